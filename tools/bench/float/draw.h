/* SPDX-License-Identifier: MIT */
/**
 * @file draw.h
 * What the renderer's stages hand on: a frame, a surface (a material under its lights) and an object.
 */
#ifndef FLOAT_DRAW_H
#define FLOAT_DRAW_H

#include "renderer.h"

/** Intervals of a table of powers, and room for its entries: a power of two, so that no number reads beyond. */
#define FLOAT_POWERS 128
#define FLOAT_POWERS_ROOM 256

/** A table for exponents below 2: bits of the first node, and how many bits a step of the table has. */
#define FLOAT_LOW_FIRST 0x37800000u
#define FLOAT_LOW_SHIFT 20

/** Value and slope over the position in the table, so that no fraction of it has to be found. */
typedef struct float_power {
    float value, slope;
} float_power;

/** Powers of a cosine, over its square. */
typedef struct float_powers {
    glint_q16 shininess;
    float cut;           /**< Powers below it are left out. */
    float scale, offset; /**< From the square to the position; not above 0 where the power is left out. */
    float at_zero;       /**< Power of 0. */
    float_power table[FLOAT_POWERS_ROOM];
} float_powers;

/** A light in camera space. */
typedef struct float_light {
    float_triple vector; /**< Directional: unit, towards the light; else its position. */
    float square;        /**< Of the position. */
    float linear, quadratic;
    float_triple axis;
    float axis_position; /**< Their product. */
    float outer, soft;   /**< Cosine, and 1 over what the inner one's is more. */
} float_light;

/** A light as a material answers it, in levels (see FLOAT_RED). */
typedef struct float_lamp {
    float_light light;
    float_triple diffuse, specular;
} float_lamp;

typedef enum float_model { FLOAT_UNLIT, FLOAT_DIFFUSE, FLOAT_BLINN_PHONG, FLOAT_PHONG } float_model;

/** What kernels are made for; those for any options look at the surface's. */
enum { FLOAT_COLOURS = 1, FLOAT_MAX = 2, FLOAT_UNGATED = 4, FLOAT_LOW = 8, FLOAT_ANY = 16 };

/** A material under the lights that show on it: first directional ones, then points, then spots. */
typedef struct float_surface {
    float_model model;
    uint32_t options;
    uint32_t directional, points, spots; /**< How many. */
    float_triple ambient, half;          /**< Levels; half a level, which rounds, is to be added. */
    float_triple base;                   /**< Their sum. */
    float_triple diffuse;                /**< Of the material itself: what is unlit shows it. */
    uint16_t dark;                       /**< Pixel in ambient light alone. */
    const float_powers *powers;
    float scale, offset; /**< Position in the table of what is a cosine's square times `square`. */
    float square;
    float_lamp lamps[GLINT_LIGHTS_MAX];
} float_surface;

typedef struct float_frame {
    const float_screen *screen;
    float_memory *memory;
    const glint_scene *scene;
    int local;                /**< The viewer. */
    float focal;              /**< Pixels of x/w = 1. */
    float near_plane;         /**< Its distance. */
    float pixel;              /**< Distance of two pixels where w = 1. */
    float middle_x, middle_y; /**< The screen's middle from the first column's centres, and minus that of rows. */
    float_light lights[GLINT_LIGHTS_MAX];
    float_powers powers; /**< The last that were asked for. */
} float_frame;

/** An affine map. */
typedef struct float_matrix {
    float_triple row[3];
    float_triple translation;
} float_matrix;

typedef struct float_draw {
    const float_frame *frame;
    const glint_object *object;
    float_surface surface;
    float_matrix place;    /**< Steps of the mesh to camera space. */
    float_triple screen_x; /**< The same to sixteenths of a pixel times w, from the screen's centre. */
    float_triple screen_y;
    float screen_tx, screen_ty;
    float_triple normal[3]; /**< Rows of the normals' matrix. */
    int front;              /**< Sign of the area of what is drawn now. */
    float side;             /**< -1 where backs are drawn. */
    uint32_t count;         /**< Triangles to be drawn. */
    uint32_t vertex_end;    /**< Vertices of the mesh, and those that clipping made. */
    const uint16_t *facets; /**< Pixel of each triangle, or null. */
} float_draw;

/** Draws the list. */
typedef void float_kernel(const float_draw *draw);

/* ---- Stages */

/** Camera and lights. */
void float_prepare_frame(float_frame *frame);

/** An object's matrices. */
void float_prepare_object(float_draw *draw);

/** Its material under the frame's lights. */
void float_prepare_surface(float_frame *frame, float_draw *draw);

/** Where an object is, by its bounding box. */
typedef enum float_whereabouts {
    FLOAT_OUTSIDE,
    FLOAT_ON_SCREEN,
    FLOAT_IN_GUARD_BAND,
    FLOAT_ANYWHERE
} float_whereabouts;
float_whereabouts float_locate(const float_draw *draw);

/** Puts the vertices on the screen; of an object that is anywhere, those nearer than the near plane get 1/w = 0. */
void float_transform(const float_draw *draw, float_whereabouts where);

/** Lists what faces the right way. */
void float_cull(float_draw *draw, float_whereabouts where);

/** Finds attributes of the vertices that are used, or of the triangles that are lit once. */
void float_light_all(float_draw *draw);

/** Attributes of a vertex, not yet over w. */
typedef struct float_attributes {
    float_triple attribute, colour;
} float_attributes;
float_attributes float_attributes_of(const float_draw *draw, uint32_t index, const float_triple *place);

/** A vertex in camera space. */
float_triple float_place_of(const float_draw *draw, uint32_t index);

/** Cuts a triangle at the near plane and lists what is left. */
void float_clip(float_draw *draw, uint32_t triangle);

/** Puts a point of camera space on the screen. */
void float_project(const float_frame *frame, const float_triple *place, float_vertex *vertex);

void float_prepare_powers(float_powers *powers, glint_q16 shininess, float cut);

/** Levels of a point that is lit by itself: of a vertex or a facet. */
float_triple float_light_point(const float_draw *draw, const float_triple *place, const float_triple *normal,
                               const float_triple *colour);

/** The kernel for a surface that is lit per fragment. */
float_kernel *float_choose_directional(const float_draw *draw);
float_kernel *float_choose_point(const float_draw *draw);
float_kernel *float_choose_spot(const float_draw *draw);
float_kernel *float_choose_many(const float_draw *draw);

/** Kernels of one colour, and of interpolated ones. */
void float_draw_flat(const float_draw *draw);
void float_draw_interpolated(const float_draw *draw);

#endif
