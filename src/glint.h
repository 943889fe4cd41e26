/* SPDX-License-Identifier: MIT */
/**
 * @file glint.h
 * glint draws lit 3D objects on small displays from cores without FPU: a freestanding C99 library, all fixed point,
 * drawn tile by tile with per-fragment Blinn-Phong lighting.
 *
 * Conventions
 * - Scalars are Q16.16 (`glint_q16`) unless said otherwise; angles are degrees in Q16.16.
 * - World space is right-handed. A camera looks along its own -z axis, with +y up and +x to the right.
 * - Front faces are counter-clockwise seen from outside.
 * - Screen x runs right and y runs down; pixel (x, y) has its centre at (x + 1/2, y + 1/2). A pixel belongs to a
 *   triangle when its centre lies inside, or on a top or left edge.
 * - Colours are linear, 0 is black and 1 is full; sums above 1 are clamped when a pixel is stored.
 * - Functions that can fail return GLINT_OK or a negative `glint_status`; those that also answer yes or no return an
 *   `int`: 1, 0 or a negative `glint_status`. On failure a renderer, a frame or a
 *   filter that they set up is all 0, and drawing with it gives GLINT_ERROR_NULL; other out-parameters are unchanged.
 *
 * Structures may grow at their end from version to version, and 0 stands for what was so before: initialise them, or
 * set them to {0} before fields are assigned one by one. Those that hold the library's own state are declared in full,
 * so that they can be static: what stands below a line `@privatesection`, to the end or to `@publicsection`, is neither
 * to be read nor to be written, and changes with any version.
 *
 * Nothing is allocated and no global is written: everything lives in the caller's structures and arena, so that any
 * number of renderers work side by side.
 */
#ifndef GLINT_H
#define GLINT_H

#include "glint_clusters.h"
#include "glint_layout.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What was written for a lower one may have to change. */
#define GLINT_VERSION_MAJOR 0
/** New features; pixels may have changed. */
#define GLINT_VERSION_MINOR 2
/** Mended errors. */
#define GLINT_VERSION_PATCH 0

/* ---- Numbers ------------------------------------------------------------------------------------------------- */

/** Signed fixed point, 16 fractional bits: 65536 is 1. */
typedef int32_t glint_q16;

#ifdef __cplusplus
#define GLINT_ONE static_cast<glint_q16>(65536)
#define GLINT_Q16(x) static_cast<glint_q16>((x)*65536.0 + ((x) < 0 ? -0.5 : 0.5))
#else
/** One in Q16.16. */
#define GLINT_ONE ((glint_q16)65536)

/**
 * A constant as Q16.16, rounded to nearest. For literals: the compiler folds it, no floating point is left.
 * @param x a number, from -32768 to below 32768
 */
#define GLINT_Q16(x) ((glint_q16)((x)*65536.0 + ((x) < 0 ? -0.5 : 0.5)))
#endif

/** A point, a direction or a length per axis. */
typedef struct glint_vector {
    glint_q16 x, y, z; /**< Along each axis. */
} glint_vector;

/** Linear colour, each channel from 0 to GLINT_COLOUR_MAX. */
typedef struct glint_colour {
    glint_q16 r, g, b; /**< Red, green, blue. */
} glint_colour;

/** Largest colour channel, and largest product of a light's and a material's channel: 16. */
#define GLINT_COLOUR_MAX (16 * GLINT_ONE)

/** An affine map, column vectors: (x, y, z) goes to m[.][0] x + m[.][1] y + m[.][2] z + m[.][3]. */
typedef struct glint_pose {
    glint_q16 m[3][4]; /**< Rows of four. */
} glint_pose;

/* ---- Errors -------------------------------------------------------------------------------------------------- */

/** Result of every function that can fail, those of panels and boards too. `glint_strerror` gives the sentence. */
typedef enum glint_status {
    GLINT_OK = 0,
    GLINT_ERROR_NULL = -1,         /**< A required pointer is null. */
    GLINT_ERROR_SIZE = -2,         /**< Width or height is not from 1 to GLINT_SIZE_MAX. */
    GLINT_ERROR_TILE = -3,         /**< Tile width or height is not 8, 16, 32 or 64. */
    GLINT_ERROR_ARENA = -4,        /**< The arena is smaller than the smallest this scene can be drawn with. */
    GLINT_ERROR_CAMERA = -5,       /**< The camera's axes are not unit and perpendicular, its field of view is not from
                                        1 to 170 degrees, its near plane or view height is not above 0, or eye, target and up
                                      lie on       one line. */
    GLINT_ERROR_LIGHTS = -6,       /**< More than GLINT_LIGHTS_MAX lights. */
    GLINT_ERROR_DIRECTION = -7,    /**< A light's direction has length 0. */
    GLINT_ERROR_COLOUR = -8,       /**< A colour channel, or a light's times a material's, is not from 0 to 16. */
    GLINT_ERROR_SHININESS = -9,    /**< A shininess exponent is below 0. */
    GLINT_ERROR_MESH = -10,        /**< A mesh has no vertices, no triangles, more vertices than uint16 can index, an
                                        extent below 0, or clusters that do not add up to it or are too many. */
    GLINT_ERROR_INDEX = -11,       /**< A triangle refers to a vertex that its mesh does not have. */
    GLINT_ERROR_POSE = -12,        /**< A pose is singular: it squashes the object flat. */
    GLINT_ERROR_RANGE = -13,       /**< An object is too far from the camera or too large for 32-bit coordinates. */
    GLINT_ERROR_FLUSH = -14,       /**< The flush callback reported a failure; the frame was not finished. */
    GLINT_ERROR_VIEWER = -15,      /**< The viewer is neither infinite nor local. */
    GLINT_ERROR_ATTENUATION = -16, /**< An attenuation coefficient is below 0. */
    GLINT_ERROR_CONE = -17,        /**< A spot's cone is wider inside than outside, below 0 or above 180 degrees. */
    GLINT_ERROR_GENERATOR = -18,   /**< A generator has too few divisions, a size not above 0, or too little room. */
    GLINT_ERROR_BUDGET = -19,      /**< An error budget is not from 0 to GLINT_BUDGET_MAX. */
    GLINT_ERROR_FLAGS = -20,       /**< A mesh's or a material's flags have a bit that is not defined. */
    GLINT_ERROR_PIXELS = -21,      /**< A configuration's own memory of pixels is too small, or not aligned. */
    GLINT_ERROR_REGION = -22,   /**< A region is not on the screen, or a rectangle not on the panel, or its edges divide
                                     a byte of the format. */
    GLINT_ERROR_PAINT = -23,    /**< The background or overlay callback reported a failure; the frame was not
                                     finished. */
    GLINT_ERROR_TIMEOUT = -24,  /**< A panel's bus took no byte, or did not fall idle, for longer than it can need. */
    GLINT_ERROR_BUS = -25,      /**< A panel's bus reported a failed transfer. */
    GLINT_ERROR_FORMAT = -26,   /**< A panel does not take pixels of this size, or its bus no words. */
    GLINT_ERROR_ROTATION = -27, /**< A panel's controller cannot turn the picture so. */
    GLINT_ERROR_TYPE = -28,     /**< A layout's type does not serve the attribute that it stands for. */
    GLINT_ERROR_STRIDE = -29    /**< A layout's stride is less than one of its type takes, or its stride or its data are
                                     not aligned as that type is. */
} glint_status;

/**
 * Tells what a status means.
 * @param status a glint_status
 * @return a sentence in English; for a number that is no status, "unknown status". Never null.
 */
const char *glint_strerror(int status);

/* ---- Scene --------------------------------------------------------------------------------------------------- */

/** Most lights in a scene. */
#define GLINT_LIGHTS_MAX 8

/** Triangles are drawn from both sides; seen from the back they are lit with the normal flipped. */
#define GLINT_MESH_DOUBLE_SIDED 1u

/**
 * Triangles in flash or RAM. Positions are stored as int16 steps: object space is offset + extent * step / 32768, per
 * axis. Owned by the caller; read while a frame is drawn, never written. In between everything may change: no frame
 * relies on what a mesh was before.
 */
typedef struct glint_mesh {
    const int16_t (*positions)[3];  /**< vertex_count positions, steps. */
    const int16_t (*normals)[3];    /**< vertex_count outward normals in object space, Q15; any length but 0. */
    const uint16_t (*triangles)[3]; /**< triangle_count index triples, counter-clockwise from outside. */
    uint32_t vertex_count;          /**< 1 to 65536. */
    uint32_t triangle_count;        /**< 1 or more. */
    glint_vector offset;            /**< Object-space position of step 0. */
    glint_vector extent;            /**< Object-space length of 32768 steps, 0 or more. */
    uint32_t flags;                 /**< 0 or GLINT_MESH_DOUBLE_SIDED. */
    const uint8_t (*colours)[3];    /**< vertex_count red, green, blue times 255, or null: the material's ambient and
                                         diffuse colours are multiplied by them. */
    const uint16_t *colours565;     /**< The same in 16 bits, or null. */
    const glint_clusters *clusters; /**< As `glint convert` writes them (glint_clusters.h), or null; not used on
                                         double-sided meshes. Null where positions change. */
    const glint_layout *layout;     /**< What stands in place of arrays that are null (glint_layout.h), or null. */
} glint_mesh;

/** How a surface reflects; a descriptor, one of those below. */
typedef struct glint_model glint_model;

/** Ambient + diffuse max(N.L, 0) (Lambert, 1760). */
extern const glint_model glint_model_lambert;

/** The same + specular max(R.V, 0)^shininess where N.L > 0, R = 2 (N.L) N - L (Phong, 1975). */
extern const glint_model glint_model_phong;

/** The same + specular max(N.H, 0)^shininess where N.L > 0, H = (L + V) / |L + V| (Blinn, 1977). */
extern const glint_model glint_model_blinn_phong;

/** The diffuse colour as it is, whatever the lights. */
extern const glint_model glint_model_unlit;

/** Specular light also where N.L <= 0: the highlight shines through. */
#define GLINT_MATERIAL_UNGATED 1u

/** The larger of diffuse + specular and ambient, channel by channel, in place of their sum. */
#define GLINT_MATERIAL_MAX 2u

/** What an object is made of. Each channel from 0 to GLINT_COLOUR_MAX. */
typedef struct glint_material {
    const glint_model *model; /**< How it reflects. */
    glint_colour ambient;     /**< Times the scene's ambient light. */
    glint_colour diffuse;     /**< Times each light's diffuse colour. */
    glint_colour specular;    /**< Times each light's specular colour: white for plastic, the diffuse one for metal. */
    glint_q16 shininess;      /**< Specular exponent p, 0 or more, any real number; 0^0 is 1. */
    uint32_t flags;           /**< 0, or GLINT_MATERIAL_UNGATED and GLINT_MATERIAL_MAX. */
} glint_material;

/**
 * A surface of one paint: ambient paint * ambient_fraction, each channel rounded to nearest, diffuse paint, a white
 * highlight. Under ambient light of the lights' colour this takes a paint, a fraction and an exponent where the full
 * model takes six colours; where all three terms meet, channels may pass 1 and are clamped.
 * @param model how it reflects
 * @param paint each channel from 0 to 1
 * @param ambient_fraction 0 to 1
 * @param shininess specular exponent, 0 or more
 * @return the material
 */
glint_material glint_material_paint(const glint_model *model, glint_colour paint, glint_q16 ambient_fraction,
                                    glint_q16 shininess);

/** What kind of light; a descriptor, one of those below. */
typedef struct glint_light_type glint_light_type;

/** Light from infinitely far: `vector` points towards it, of any length but 0. */
extern const glint_light_type glint_light_directional;

/**
 * Light from the point `vector`, weaker with its distance d: 1 / (1 + linear d + quadratic d^2). Adds nothing at d = 0,
 * that is, nearer than about 1/32768 of the way to the eye.
 */
extern const glint_light_type glint_light_point;

/** A point light along `axis`: full up to `inner` degrees from it, none from `outer` on, a smooth step between.
 * Unit vectors of 15 bits tell cosines to about 2^-14: a step shows their rounding where the cosines of `inner` and
 * `outer` are less than 1/64 apart. */
extern const glint_light_type glint_light_spot;

/** A light, in world space. Ambient light is the scene's. */
typedef struct glint_light {
    const glint_light_type *type; /**< What kind. */
    glint_vector vector;          /**< Direction towards the light, or its position. */
    glint_colour diffuse;         /**< For diffuse terms. */
    glint_colour specular;        /**< For highlights. */
    glint_q16 linear, quadratic;  /**< Attenuation, per unit and per unit squared, 0 or more. */
    glint_vector axis;            /**< Of a spot: where it points, of any length but 0. */
    glint_q16 inner, outer;       /**< Of a spot: degrees from the axis, 0 <= inner <= outer <= 180. */
} glint_light;

/** Where lighting is evaluated; a descriptor, one of those below. */
typedef struct glint_evaluation glint_evaluation;

/**
 * At every fragment, with the normal interpolated and made unit (Phong, 1975). What a null pointer means. This was long
 * called Phong shading; it goes with any model, and is not the Phong model, which is one kind of highlight.
 */
extern const glint_evaluation glint_per_fragment;

/**
 * At nodes, which are some points of a triangle or of squares of the screen: as many as it takes to be within 2/5 of a
 * level of what each fragment would be, for each 1 that weights add up to, and all fragments where no fewer do. The
 * fastest where triangles cover ten pixels or more. Takes 7.5 KB of stack, and of arena up to 118 bytes a vertex.
 */
extern const glint_evaluation glint_per_node;

/** At every vertex; colours, clamped at 1, are interpolated (Gouraud, 1971). */
extern const glint_evaluation glint_per_vertex;

/** Once a triangle, at its centroid, with the normal of its plane. */
extern const glint_evaluation glint_per_facet;

/** A mesh of a material at a place. Owned by the caller; read while a frame is drawn, never written. */
typedef struct glint_object {
    const glint_mesh *mesh;             /**< What it looks like. */
    const glint_material *material;     /**< What it is made of. */
    glint_pose pose;                    /**< Object to world; scales may differ per axis and mirror. */
    const glint_evaluation *evaluation; /**< Where it is lit; null for every fragment. */
    uint8_t hidden;                     /**< Not 0: it is not drawn, and its pose may be anything. */
} glint_object;

/** How a camera projects; a descriptor, null for perspective or the one below. */
typedef struct glint_projection glint_projection;

/**
 * Parallel rays (orthographic projection): what is twice as far away is as large. A local viewer sees what an infinite
 * one does.
 *
 * Depth is linear: 65533 steps from the nearest corner of any visible object's bounding box, or the near plane, to the
 * farthest. A surface's depth is off by at most two steps. Lights with a position know a surface's place along the
 * camera's axis to such a step, up to 2^17 pixels' widths from the eye; with these lights `glint_per_node` lights every
 * fragment.
 */
extern const glint_projection glint_orthographic;

/** Where a scene is seen from. */
typedef struct glint_camera {
    glint_pose pose;         /**< Camera to world: a rotation and the eye's position. */
    glint_q16 field_of_view; /**< Vertical, degrees, 1 to 170; not looked at where the projection is orthographic. */
    glint_q16 near_plane;    /**< Distance to the near plane, above 0. */
    const glint_projection *projection; /**< Null, or &glint_orthographic. */
    glint_q16 view_height;              /**< Where it is orthographic: the screen's height in units, 1/256 or more. */
} glint_camera;

/*
 * In perspective depths reach from the near plane to 2^33 times as far, the range of all coordinates, and all are
 * drawn. Up to 2^12 times as far as the nearest corner of any visible object's bounding box, colours are as exact as
 * anywhere. Beyond, 1/w is known to fewer than 16 bits: coverage is exact still and pixels are the same on every core,
 * but what is interpolated across a triangle, and lights with a position, are known to those bits only; from 2^16 times
 * on all depths tie.
 */

/** Where highlights are seen from. */
typedef enum glint_viewer {
    GLINT_VIEWER_INFINITE = 0, /**< V is the camera's backward axis everywhere: cheaper. */
    GLINT_VIEWER_LOCAL = 1     /**< V points from each fragment to the eye. */
} glint_viewer;

/** Largest error budget. */
#define GLINT_BUDGET_MAX 8

/** All that a frame shows. Owned by the caller; read while a frame is drawn, never written. */
typedef struct glint_scene {
    glint_camera camera;         /**< Where it is seen from. */
    glint_viewer viewer;         /**< Where highlights are seen from. */
    glint_colour background;     /**< What shows where no object does. */
    glint_colour ambient;        /**< Ambient light. */
    const glint_light *lights;   /**< Lights. */
    uint32_t light_count;        /**< 0 to GLINT_LIGHTS_MAX. */
    const glint_object *objects; /**< Nearest first is fastest: what is hidden is not lit. */
    uint32_t object_count;       /**< 0 or more. Where depths tie, the first drawn wins. */
    /** Steps of an output channel by which any may differ from the exact image, for fewer instructions: 0, exact, to
     * GLINT_BUDGET_MAX. From 4 on slow motion shows it: where a triangle is lit in another way than in the frame
     * before, all its pixels jump at once by some of these steps. Formats of 1 bit count steps of 8 bits; with output
     * tables, which may steepen errors, it is 0. */
    int32_t error_budget;
} glint_scene;

/* ---- Poses and cameras --------------------------------------------------------------------------------------- */

/**
 * Sine.
 * @param degrees any angle, Q16.16
 * @return Q16.16
 */
glint_q16 glint_sin(glint_q16 degrees);

/**
 * Cosine.
 * @param degrees any angle, Q16.16
 * @return Q16.16
 */
glint_q16 glint_cos(glint_q16 degrees);

/** The pose that changes nothing. @return the pose */
glint_pose glint_pose_identity(void);

/** A move. @param x,y,z how far along each axis @return the pose */
glint_pose glint_pose_translate(glint_q16 x, glint_q16 y, glint_q16 z);

/** A scale per axis. @param x,y,z factors @return the pose */
glint_pose glint_pose_scale(glint_q16 x, glint_q16 y, glint_q16 z);

/** A right-handed turn about the x axis. @param degrees any angle @return the pose */
glint_pose glint_pose_rotate_x(glint_q16 degrees);

/** A right-handed turn about the y axis. @param degrees any angle @return the pose */
glint_pose glint_pose_rotate_y(glint_q16 degrees);

/** A right-handed turn about the z axis. @param degrees any angle @return the pose */
glint_pose glint_pose_rotate_z(glint_q16 degrees);

/** A right-handed turn. @param axis of any length @param degrees any angle @return the identity where the axis is 0 */
glint_pose glint_pose_rotate(glint_vector axis, glint_q16 degrees);

/** The turn of a quaternion. @param x,y,z,w of any length @return the identity where that is 0 */
glint_pose glint_pose_quaternion(glint_q16 x, glint_q16 y, glint_q16 z, glint_q16 w);

/** Where a pose takes a point. @param pose any @param point any @return rounded to nearest and saturated */
glint_vector glint_pose_apply(const glint_pose *pose, glint_vector point);

/** Two poses as one. @param first what comes first @param second what comes then @return each entry rounded to nearest
 * and saturated */
glint_pose glint_pose_then(const glint_pose *first, const glint_pose *second);

/**
 * Sets camera->pose.
 * @param camera its other fields stay
 * @param eye where it stands
 * @param at what it looks at
 * @param up a direction that it sees upwards, of any length
 * @return GLINT_ERROR_CAMERA when the three lie on one line: then the camera is as it was.
 */
glint_status glint_camera_look_at(glint_camera *camera, glint_vector eye, glint_vector at, glint_vector up);

/**
 * Sets camera->pose so that the camera looks at `at` from a distance: with no angles from +z, with a yaw of 90 degrees
 * from +x, with a pitch of 90 degrees from +y.
 * @param camera its other fields stay
 * @param at what it looks at
 * @param yaw,pitch degrees, any
 * @param distance from `at`
 */
void glint_camera_orbit(glint_camera *camera, glint_vector at, glint_q16 yaw, glint_q16 pitch, glint_q16 distance);

/* ---- Generated meshes ---- */

/** Where a generator writes. Owned by the caller, who keeps it as long as the mesh. */
typedef struct glint_mesh_room {
    int16_t (*positions)[3];             /**< Room for vertex_room. */
    int16_t (*normals)[3];               /**< Room for vertex_room. */
    uint16_t (*triangles)[3];            /**< Room for triangle_room. */
    uint32_t vertex_room, triangle_room; /**< How many fit. */
} glint_mesh_room;

/**
 * @name Generators
 * Each fills `room` with a surface and its normals, both from the formula, and sets `mesh` up to point there. They
 * return GLINT_ERROR_GENERATOR when a size is not above 0, when there are fewer divisions than a solid needs or more
 * vertices than uint16 can index, or when the room is too small: then mesh->vertex_count and mesh->triangle_count tell
 * how much it takes, and the rest of the mesh is as it was. Sizes are Q16.16, up to 8192.
 * @{
 */

/**
 * A torus around the z axis.
 * @param mesh,room as above
 * @param around,along quads, 3 or more
 * @param radius to the tube's centre
 * @param tube the tube's own
 * @return as above
 */
glint_status glint_generate_torus(glint_mesh *mesh, const glint_mesh_room *room, uint32_t around, uint32_t along,
                                  glint_q16 radius, glint_q16 tube);

/**
 * A sphere, its poles on z.
 * @param mesh,room as above
 * @param around quads, 3 or more
 * @param along steps from pole to pole, 2 or more
 * @param radius its own
 * @return as above
 */
glint_status glint_generate_sphere(glint_mesh *mesh, const glint_mesh_room *room, uint32_t around, uint32_t along,
                                   glint_q16 radius);

/**
 * A cylinder around the z axis, from -half_height to half_height.
 * @param mesh,room as above
 * @param around quads, 3 or more
 * @param along steps, 1 or more
 * @param radius,half_height its size
 * @param capped 0 where it is open
 * @return as above
 */
glint_status glint_generate_cylinder(glint_mesh *mesh, const glint_mesh_room *room, uint32_t around, uint32_t along,
                                     glint_q16 radius, glint_q16 half_height, int capped);

/**
 * A cone around the z axis, its base at -half_height, its tip at half_height.
 * @param mesh,room as above
 * @param around quads, 3 or more
 * @param along steps, 1 or more
 * @param radius,half_height its size
 * @param capped 0 where its base is open
 * @return as above
 */
glint_status glint_generate_cone(glint_mesh *mesh, const glint_mesh_room *room, uint32_t around, uint32_t along,
                                 glint_q16 radius, glint_q16 half_height, int capped);

/**
 * A rectangle in the plane z = 0, seen from +z.
 * @param mesh,room as above
 * @param columns,rows quads, 1 or more
 * @param half_width,half_height x and y are from minus to plus these
 * @return as above
 */
glint_status glint_generate_plane(glint_mesh *mesh, const glint_mesh_room *room, uint32_t columns, uint32_t rows,
                                  glint_q16 half_width, glint_q16 half_height);

/**
 * A box: six faces, each of its own vertices; 24 vertices, 12 triangles.
 * @param mesh,room as above
 * @param half_width,half_height,half_depth its size
 * @return as above
 */
glint_status glint_generate_box(glint_mesh *mesh, const glint_mesh_room *room, glint_q16 half_width,
                                glint_q16 half_height, glint_q16 half_depth);
/** @} */

/* ---- Output -------------------------------------------------------------------------------------------------- */

/** How pixels are stored; a descriptor. */
typedef struct glint_format glint_format;

extern const glint_format glint_format_rgb565;    /**< 16 bits, RRRRRGGGGGGBBBBB, in the core's byte order. */
extern const glint_format glint_format_rgb565_be; /**< 16 bits, high byte first: as most SPI panels want it. */
extern const glint_format glint_format_rgb888;    /**< 3 bytes: red, green, blue. */
extern const glint_format glint_format_grey8;     /**< 1 byte: 0.299 R + 0.587 G + 0.114 B. */
extern const glint_format glint_format_grey4;     /**< 4 bits, the left pixel of a byte in its high half. */
extern const glint_format glint_format_rgb444;    /**< 12 bits, RRRRGGGGBBBB, high bits first: 2 pixels in 3 bytes. */
extern const glint_format glint_format_mono;      /**< 1 bit of luma, the left pixel of a byte lowest. */

/** 1 bit of luma, as OLED controllers keep it: pixel (x, y) of a tile is bit y % 8 of byte x + y / 8 * 8 stride. */
extern const glint_format glint_format_mono_pages;

/**
 * @name Dithered
 * The same with ordered dithering (Bayer, 1973) over 8 x 8 pixels: no banding, at the price of a fine pattern. Every
 * format stores floor(v + t): v is the value in its levels, t is 1/2 or, dithered, the pixel's threshold, an odd number
 * of 128ths. What is exact is v, to a part of a level that docs/accuracy.md states for each format.
 * @{
 */
extern const glint_format glint_format_rgb565_dithered;     /**< As glint_format_rgb565. */
extern const glint_format glint_format_rgb565_be_dithered;  /**< As glint_format_rgb565_be. */
extern const glint_format glint_format_rgb888_dithered;     /**< As glint_format_rgb888. */
extern const glint_format glint_format_grey8_dithered;      /**< As glint_format_grey8. */
extern const glint_format glint_format_grey4_dithered;      /**< As glint_format_grey4. */
extern const glint_format glint_format_rgb444_dithered;     /**< As glint_format_rgb444. */
extern const glint_format glint_format_mono_dithered;       /**< As glint_format_mono. */
extern const glint_format glint_format_mono_pages_dithered; /**< As glint_format_mono_pages. */
/** @} */

/** Entries of an output table. */
#define GLINT_GAMMA_ENTRIES 257

/**
 * The output table of a panel that expects sRGB (IEC 61966-2-1), which shows linear colours too dark. It is no default:
 * panels have curves of their own, a frame takes more instructions with a table than without, and colours that a user
 * interface mixes with are 565 already. 1.5 KB of flash where it is named.
 */
extern const uint16_t glint_gamma_srgb[3][GLINT_GAMMA_ENTRIES];

/** Bytes of a row of pixels. @param format how they are stored @param width pixels @return bytes */
size_t glint_row_bytes(const glint_format *format, uint32_t width);

/**
 * Takes finished tiles. `begin` starts to send a rectangle and may return before it is sent; `wait` returns when it
 * is. They are called in pairs, in order, and the buffer is not modified between them. Tiles that show only the
 * background may pass the same pixels again. Either returns 0, or anything else to report a failure, which ends the
 * frame with GLINT_ERROR_FLUSH: no further tile is sent, and the next frame is whole.
 *
 * These and painters may call all of the library with another renderer and another arena, to any depth that the stack
 * allows. They must not touch the renderer that calls them, its arena, or the scene, and they must return: the library
 * has no clock, so that a wait without an end is a frame without one. Bound each wait, and report a failure when it is
 * over; what is given up must not go on reading the pixels. The drivers in port/ end so with GLINT_ERROR_TIMEOUT.
 */
typedef struct glint_flush {
    /** Starts to send; `stride` is bytes from a row of `pixels` to the next. */
    int (*begin)(void *context, int x, int y, int width, int height, const void *pixels, size_t stride);
    /** May be null when `begin` returns only once all is sent. */
    int (*wait)(void *context);
    void *context; /**< Handed to both. */
} glint_flush;

/** Pixels of a screen. */
typedef struct glint_rectangle {
    int16_t x, y, width, height; /**< From its left upper corner on. */
} glint_rectangle;

/** A tile of the screen, cut at the screen's edges and at the region's. */
typedef struct glint_tile {
    int x, y, width, height; /**< On the screen. */
    void *pixels;            /**< The one at x, y. */
    size_t stride;           /**< Bytes from row to row. */
    /** Depth at x, y, larger where nearer: 0 where nothing has been drawn, so that it tells which pixels show objects.
     * Of a background it tells nothing. */
    const uint16_t *depth;
    size_t depth_stride; /**< Numbers from row to row. */
    /** @privatesection */
    /* what glint_lines_draw reads */
    const struct glint_frame *frame;
    const struct glint_workspace *workspace;
} glint_tile;

/**
 * Paints pixels of a tile, in the format of the configuration. It returns 0, or anything else to report a failure,
 * which ends the frame with GLINT_ERROR_PAINT. It is called by whoever draws the tile: by two at once where two draw
 * tiles.
 */
typedef struct glint_painter {
    int (*paint)(void *context, const glint_tile *tile); /**< Null: nothing is painted. */
    void *context;                                       /**< Handed to it. */
} glint_painter;

/** Largest width and height. */
#define GLINT_SIZE_MAX 1024

/** How and where to draw. Copied by `glint_init`; what it points to stays the caller's. */
typedef struct glint_config {
    uint16_t width;             /**< Pixels, 1 to GLINT_SIZE_MAX. */
    uint16_t height;            /**< Pixels, 1 to GLINT_SIZE_MAX. */
    uint16_t tile_width;        /**< 8, 16, 32 or 64; 0 for the default, 32. */
    uint16_t tile_height;       /**< 8, 16, 32 or 64; 0 for the default, 32. */
    const glint_format *format; /**< How pixels are stored. */
    glint_flush flush;          /**< Where they are sent. */
    void *arena;                /**< Working memory, any alignment. More means fewer passes, never other pixels. */
    size_t arena_size;          /**< Bytes; see `glint_arena_need`. */
    /**
     * Where glint_render puts the pixels that it sends, for memory of its own that DMA reads: aligned as a pointer is,
     * or as a cache or a DMA wants it, as the second of two tiles begins a multiple of 64 bytes behind the first. Null:
     * in the arena, where depth is in any case.
     */
    void *pixels;
    size_t pixels_size; /**< Bytes: no less than `glint_pixels_need` tells. */
    /** Output tables for red, green and blue, or null: what a panel needs to show 0, 1/256 .. 1; Q16, 65535 is 1. */
    const uint16_t (*gamma)[GLINT_GAMMA_ENTRIES];
    /** Not 0: nobody else writes to the arena between frames. Tables of a material that the last frame prepared are
     * then kept for as long as nothing that they come from changes, and made anew where something has written there;
     * not by a library built for size. */
    uint8_t keeps_arena;
    /** Not 0: glint_stats.drawn is counted too, for up to 1 % more instructions, 6 % where objects hide others. */
    uint8_t counts_drawn;
    int16_t left, top; /**< Where the screen's first pixel lies on the display: added to where tiles are sent. */
    /**
     * The part of the screen that is drawn and sent, all 0 for the whole: its pixels are those of the whole frame.
     * Where pixels share a byte, it ends where bytes do, or at the screen's edge: x and width are multiples of 2 in
     * formats of 4 and 12 bits and of 8 in glint_format_mono; y and height of 8 in glint_format_mono_pages.
     */
    glint_rectangle region;
    glint_painter background; /**< Paints all of a tile before objects are drawn, in place of scene->background. */
    glint_painter overlay;    /**< Paints over a finished tile, also where no object shows. */
    /** Not 0: objects that have nothing to draw are left out and counted in glint_stats.skipped: those whose pose is
     * singular, which would end the frame with GLINT_ERROR_POSE, and those whose mesh has no vertices or no triangles,
     * with GLINT_ERROR_MESH; nothing else of such a mesh is looked at. */
    uint8_t skips_degenerate;
} glint_config;

/** Kernels: loops that draw the spans of a triangle. */
typedef enum glint_kernel_name {
    GLINT_KERNEL_GENERAL,         /**< For everything. */
    GLINT_KERNEL_AMBIENT,         /**< One colour: the triangle faces away from the light. */
    GLINT_KERNEL_DIFFUSE,         /**< Lit all over, without specular light. */
    GLINT_KERNEL_GATED,           /**< Lit in part, without specular light. */
    GLINT_KERNEL_SPECULAR,        /**< Lit all over, with specular light. */
    GLINT_KERNEL_CURVED_DIFFUSE,  /**< Its normals turn far; without specular light. */
    GLINT_KERNEL_CURVED_SPECULAR, /**< Its normals turn far; with specular light. */
    GLINT_KERNEL_EVEN,            /**< One colour: without specular light, its light changes too little to show. */
    GLINT_KERNEL_CHANNELS,        /**< Lit at its corners. */
    GLINT_KERNELS
} glint_kernel_name;

/** What a kernel drew. */
typedef struct glint_drawn {
    uint32_t parts;   /**< Parts of triangles: at most one for each tile that a triangle may touch. */
    uint32_t covered; /**< Pixels of their spans, before the depth test. */
} glint_drawn;

/** What a frame took; counts since the frame began. */
typedef struct glint_stats {
    uint32_t passes;                  /**< Times the scene was gone through. */
    uint32_t tiles;                   /**< Tiles drawn and sent. */
    uint32_t vertices;                /**< Vertices transformed. */
    uint32_t triangles;               /**< Triangles looked at. */
    uint32_t facing_away;             /**< Of these, dropped: facing away, or without area. */
    uint32_t outside;                 /**< Of these, dropped: outside the screen, or between pixel centres. */
    uint32_t clipped;                 /**< Of these, cut at the near plane or the guard band. */
    uint32_t hidden;                  /**< Objects dropped whole: outside the screen, hidden, or skipped. */
    uint32_t references;              /**< Triangle references put into tiles. */
    uint32_t arena_used;              /**< Most bytes of the arena in use. */
    int flush_error;                  /**< What the flush callback returned when it failed, else 0. */
    glint_drawn drawn[GLINT_KERNELS]; /**< Where the configuration asks for it, else 0. */
    uint32_t skipped;                 /**< Objects left out as glint_config.skips_degenerate asks, else 0. */
} glint_stats;

/** Bytes of arena for a scene; each is no less than the one before it. */
typedef struct glint_need {
    size_t least;    /**< Below this, GLINT_ERROR_ARENA. Between this and `resident`, vertices are loaded in parts. */
    size_t resident; /**< From this on every vertex is transformed once a frame, for up to 57344 triangles in view. */
    size_t one_pass; /**< From this on, one pass; more has no effect. */
} glint_need;

/** Memory handed out from both ends; the bytes from `low` to `high` are free. */
typedef struct glint_memory {
    /** @privatesection */
    uint8_t *base;
    size_t low, high;
} glint_memory;

/** Everything that drawing the tiles of a pass reads; written by glint_frame_begin and glint_frame_next only. */
typedef struct glint_frame {
    /** @privatesection */
    glint_config config;
    const glint_scene *scene;
    const struct glint_view *view;       /* camera and lights, prepared */
    const struct glint_shading *shading; /* materials, prepared */
    uint32_t shading_count;
    glint_memory memory;
    /** @publicsection */
    uint16_t tile_first, tile_end; /**< Tiles of this pass: from the first to before the end. */
    /** @privatesection */
    uint16_t tile_columns, tile_count;    /* of the region */
    uint16_t first_column, first_row;     /* of the screen's tiles, in the region */
    uint16_t right, bottom;               /* behind the region's last pixels */
    uint16_t pass_tiles;                  /* tiles that a pass may hold */
    uint16_t loaded_end;                  /* what is loaded is for tiles before this */
    uint8_t tile_shift_x, tile_shift_y;   /* binary logarithms of the tile's size */
    uint8_t starts, ends;                 /* the pass holds the scene's first triangle, its last */
    uint8_t covers_end;                   /* what is loaded reaches the scene's end */
    uint8_t resident;                     /* what is loaded is all of the scene */
    uint8_t has_extents;                  /* they have been looked for */
    uint16_t part_bytes;                  /* what a triangle that may show takes about, where parts are loaded */
    uint8_t extent_shift;                 /* binary logarithm of the triangles of an extent */
    const struct glint_extent *extents;   /* null where all is loaded, or there is no room for them */
    uint32_t object, triangle;            /* where the next pass goes on */
    size_t prepared_end, vertices_end;    /* of the arena's use */
    uint32_t waiting;                     /* transforms of the last objects that wait to be loaded */
    size_t least_room;                    /* of the arena, behind what is prepared */
    const struct glint_node_stage *nodes; /* null where none are lit */
    struct glint_draw *draws;             /* what this pass draws */
    struct glint_reference *references;   /* first one for each of its tiles, with which the tile's list begins */
    uint32_t reference_count;
    uint8_t has_costly;            /* does this pass draw what is lit by fragments or nodes? */
    struct glint_clipped *clipped; /* above the last; they grow downwards */
    /** @publicsection */
    glint_stats stats; /**< So far. */
} glint_frame;

/** Bytes of the arena that a pass leaves free, for what one of its tiles finds and others take up. */
typedef struct glint_spare {
    /** @privatesection */
    void *memory; /* aligned as the arena; null where there are none */
    uint32_t size;
    uint32_t is_begun; /* not 0: something of this pass is there */
} glint_spare;

/** What drawing one tile needs. */
typedef struct glint_workspace {
    void *pixels;  /**< The finished tile. */
    size_t stride; /**< Bytes from row to row. */
    /** @privatesection */
    uint16_t *depth;
    int32_t (*row)[3];               /* colours of two rows of a tile; of use as long as nothing is gathered */
    struct glint_gathered *gathered; /* in the same place: a triangle's fragments */
    glint_spare spare;
    /** @publicsection */
    glint_drawn *drawn; /**< Null, or GLINT_KERNELS counters of the caller's, added to. */
} glint_workspace;

/** What the last frame left in the arena: prepared materials. */
typedef struct glint_kept {
    /** @privatesection */
    const struct glint_shading *shadings;
    uint32_t count;
    size_t end; /* of the arena's use */
} glint_kept;

/** What draws; set up by glint_init. Owned by the caller. */
typedef struct glint_renderer {
    glint_stats stats; /**< Of the last frame; 0 where it could not begin. */
    /** @privatesection */
    glint_config config;
    glint_kept kept; /* of use only where the arena is kept */
} glint_renderer;

/**
 * Sets up a renderer; draws nothing. On failure the renderer, if there is one, is all 0.
 * @param renderer the caller's
 * @param config how and where to draw; copied
 * @return GLINT_ERROR_NULL, _SIZE, _TILE, _PIXELS, or _ARENA when the arena cannot hold even the tile buffers.
 */
glint_status glint_init(glint_renderer *renderer, const glint_config *config);

/**
 * Draws a scene: every pixel of the screen, or of the region, goes through the flush callback once, tile by tile, left
 * to right and top to bottom. Errors in the scene are found before the first tile is sent.
 * Callbacks must not call the library with the same renderer, nor with its arena: what is being drawn lies there, and
 * nothing checks for it.
 * @param renderer what glint_init has set up
 * @param scene what to draw
 * @return GLINT_OK, or why the frame was not drawn or not finished
 */
glint_status glint_render(glint_renderer *renderer, const glint_scene *scene);

/**
 * The same for one frame of another region than the configuration's.
 * @param renderer,scene as for glint_render
 * @param region see glint_config.region
 * @return as for glint_render; GLINT_ERROR_REGION
 */
glint_status glint_render_region(glint_renderer *renderer, const glint_scene *scene, const glint_rectangle *region);

/**
 * How much arena a scene needs when drawn by glint_render with this configuration (its arena is not looked at, nor the
 * size of its pixels).
 * @param config,scene what is to be drawn
 * @param need set
 * @return the error that drawing the scene would give: then `need` is as it was
 */
glint_status glint_arena_need(const glint_config *config, const glint_scene *scene, glint_need *need);

/**
 * The same for every frame in which each object is turned in any way about its origin, (0, 0, 0) of the mesh, all else
 * being as it is: each pose may be any rotation of this one, with the same fourth column, rounded to Q16.16. `least` is
 * exact; the others are bounds from the triangles' longest edges, all of which count as facing the eye and as lying
 * where tiles meet. Objects that move as well need the most of the places where they come nearest.
 * @param config,scene,need as for glint_arena_need
 * @return as glint_arena_need: then `need` is as it was
 */
glint_status glint_arena_need_turned(const glint_config *config, const glint_scene *scene, glint_need *need);

/**
 * Bytes of `pixels` that glint_render needs where they are apart from the arena.
 * @param config what is to be drawn with
 * @return 0 when the configuration is not valid
 */
size_t glint_pixels_need(const glint_config *config);

/* ---- Why a picture is black ---- */

/** What glint_check found. */
typedef struct glint_report {
    glint_status status;  /**< What drawing the scene returns. */
    const char *sentence; /**< In English, what is wrong or looks wrong; "" where nothing does. Never null. */
    int32_t object;       /**< The object that it is about, or -1. */
    int32_t light;        /**< The light that it is about, or -1. */
    size_t bytes;         /**< How many bytes of arena, or of pixels, are missing; else 0. */
    uint32_t shown;       /**< Pixels of the region that show an object, where the scene can be drawn. */
} glint_report;

/**
 * Looks for what keeps a scene from being drawn, or makes it black: draws it with the configuration's arena, and sends
 * nothing. For development: neither its time nor its flash is meant for a product. Not while a frame is on its way.
 * @param config,scene what is to be drawn
 * @param report what was found
 * @return report->status, or GLINT_ERROR_NULL where `report` is null
 */
glint_status glint_check(const glint_config *config, const glint_scene *scene, glint_report *report);

/* ---- From the screen to the scene, and back ---- */

/** Where a point shows. */
typedef struct glint_place {
    glint_q16 x, y;     /**< Pixels from the screen's left and top edge; saturated. */
    glint_q16 distance; /**< From the eye along the camera's axis; saturated. */
} glint_place;

/**
 * Finds where a point of the world shows on a screen of config->width and height: off by at most 1/128 of a pixel, on
 * and around the screen. Nothing else of the configuration is looked at.
 * @param config,camera what it is seen with
 * @param point in the world
 * @param to where it shows
 * @return 1, 0 when it lies in front of the near plane: then `to` is as it was; GLINT_ERROR_NULL, _SIZE or _CAMERA
 */
int glint_camera_project(const glint_config *config, const glint_camera *camera, glint_vector point, glint_place *to);

/** What a pixel shows. */
typedef struct glint_hit {
    uint32_t object;   /**< Of the scene. */
    uint32_t triangle; /**< Of the object's mesh. */
    uint16_t depth;    /**< As glint_tile has it: larger is nearer. */
} glint_hit;

/**
 * Finds which triangle glint_render shows at a pixel of the screen, by drawing that pixel; uses the renderer's arena,
 * so not while a frame is on its way.
 * @param renderer,scene what shows
 * @param x,y the pixel
 * @param hit what it shows
 * @return 1, 0 when it shows background: then `hit` is as it was; GLINT_ERROR_REGION when the pixel is not on the
 * screen, or an error of the scene
 */
int glint_pick(glint_renderer *renderer, const glint_scene *scene, int x, int y, glint_hit *hit);

/* ---- Lines ---- */
/*
 * Straight lines in space: edges, axes, boxes. Each is one pixel wide and of one colour, which no light changes, and is
 * hidden by what lies in front of it. They are placed on the screen before a frame, and drawn by its overlay:
 *
 *     glint_lines_place(segments, &config, &scene.camera, &pose, lines, count);      // and then glint_render
 *     int paint(void *context, const glint_tile *tile) { return glint_lines_draw(tile, segments, count); }
 *
 * A line ends where it passes the near plane or lies 1023 pixels from the screen's centre in x or y. Its ends are then
 * rounded to 1/16 of a pixel. Is it at least as wide as it is high, then it has one pixel in each column, from that of
 * its left end to that of its right end, both included: the pixel that holds the point where the line passes the middle
 * of the column or, where it ends before, its end. A steeper line has one pixel in each row, likewise. A point between
 * two pixels belongs to the right or the lower one. The same pixels come from both directions, and for every tile,
 * arena and region.
 *
 * A pixel's depth is that of this point, linear between the ends as that of a triangle is, and is tested and kept as a
 * triangle's: what is drawn later lies in front where it is nearer. A line counts as nearer to the eye than it is, by
 * the width of two pixels there: so it shows on a surface that it lies on, unless that leans by more than 75 degrees.
 * Lines do not count where the depth's scale is found: beside those in front of all objects none is nearer than
 * another, and where there are no objects, only the order counts.
 */

/** A line. Owned by the caller. */
typedef struct glint_line {
    glint_vector from, to; /**< Before the pose. */
    glint_colour colour;   /**< Each channel from 0 to GLINT_COLOUR_MAX. */
} glint_line;

/** What a line is on the screen. Owned by the caller; written by glint_lines_place only. */
typedef struct glint_segment {
    /** @privatesection */
    int16_t x[2], y[2];    /* its ends, 28.4 */
    uint32_t inverse_w[2]; /* there: 1/w, w in Q28, is this over 2^exponent */
    uint8_t exponent[2];
    const glint_colour *colour; /* null where nothing of it shows */
} glint_segment;

/**
 * Places lines on the screen of a configuration, of which width and height are looked at. Ends are first taken to the
 * world, each coordinate rounded to nearest and saturated as glint_pose_apply does, and are then off by at most 1/64 of
 * a pixel, on and around the screen, before they are rounded.
 * @param segments `count` of them; like the lines, whose colours they point to, they stay until the frame is drawn
 * @param config,camera what they are seen with
 * @param pose of the lines, to the world
 * @param lines `count` of them
 * @param count how many
 * @return GLINT_ERROR_NULL, _SIZE, _CAMERA or _COLOUR: then segments are as they were
 */
glint_status glint_lines_place(glint_segment *segments, const glint_config *config, const glint_camera *camera,
                               const glint_pose *pose, const glint_line *lines, uint32_t count);

/**
 * Draws lines on a finished tile, for an overlay. Calls follow each other: what was drawn before hides what is drawn
 * behind it. Tiles of one frame may be drawn by several callers at once.
 * @param tile what the overlay is given
 * @param segments `count` of them, placed
 * @param count how many
 * @return GLINT_OK, or GLINT_ERROR_NULL where there is no tile, or not one that a frame has handed out
 */
glint_status glint_lines_draw(const glint_tile *tile, const glint_segment *segments, uint32_t count);

/** Sets the twelve edges of a box. @param lines set @param from,to opposite corners @param colour of all */
void glint_lines_box(glint_line lines[12], glint_vector from, glint_vector to, glint_colour colour);

/**
 * Sets lines to the edges of a mesh, in object space, rounded to nearest and saturated; an edge of two triangles that
 * name the same two vertices once, and one with a vertex that the mesh does not have left out. For meshes of a few
 * hundred triangles: its time grows with their square.
 * @param lines set
 * @param room how many fit in `lines`, which may be null where it is 0
 * @param mesh whose edges; with all that glint_render asks of it but for indices
 * @param colour of all
 * @return how many edges there are; those beyond `room` are left out
 */
uint32_t glint_lines_edges(glint_line *lines, uint32_t room, const glint_mesh *mesh, glint_colour colour);

/* ---- Only what changed ---- */
/*
 * A panel keeps its picture: tiles that are what they were need not be sent. A filter between the renderer and the
 * panel's flush knows each by a signature of 64 bits, 8 bytes a tile of the caller's memory. Tiles that differ have
 * the same one with a chance of 2^-64, those that differ in four bytes only never.
 *
 *     static glint_signature signatures[80];                    // glint_changes_count(&config)
 *     glint_changes_init(&changes, signatures, &config);
 *     config.flush = glint_changes_flush(&changes);             // and then glint_init
 *
 * Tile size, format and arena are the configuration's own; a tile's pixels are aligned to 4 bytes, as the renderer has
 * them.
 */

/** What a tile was sent as; 0 for one that has yet to be sent. */
typedef struct glint_signature {
    /** @privatesection */
    uint32_t a, b;
} glint_signature;

/** The filter. Owned by the caller. */
typedef struct glint_changes {
    uint32_t sent, unchanged; /**< Tiles, since glint_changes_init. */
    /** @privatesection */
    glint_flush flush;
    glint_signature *signatures, *sending, pending;
    uint32_t count;
    uint16_t columns, tile_width, tile_height, width, height;
    int16_t left, top;
    uint8_t is_part; /* is a part of a tile on its way? */
} glint_changes;

/** How many signatures a configuration takes. @param config with which is drawn @return 0 when it is not valid */
uint32_t glint_changes_count(const glint_config *config);

/**
 * Sets a filter up before config->flush; everything is yet to be sent. On failure the filter, if there is one, is all
 * 0, and so is its flush, which glint_init refuses.
 * @param changes the filter
 * @param signatures glint_changes_count of them, the caller's as long as the filter
 * @param config with which is to be drawn, its flush that of the panel
 * @return GLINT_ERROR_NULL, _SIZE or _TILE.
 */
glint_status glint_changes_init(glint_changes *changes, glint_signature *signatures, const glint_config *config);

/** Sends everything once more: for a panel that was started anew. A tile whose flush failed is sent again anyhow.
 * @param changes the filter */
void glint_changes_forget(glint_changes *changes);

/** The flush to draw with. @param changes the filter, which must outlive it @return the flush */
glint_flush glint_changes_flush(glint_changes *changes);

/* ---- Tile by tile -------------------------------------------------------------------------------------------- */
/*
 * glint_render is a loop over these; use them to draw the tiles of a frame in another order, or on two cores:
 *
 *     glint_frame_begin(&frame, &config, &scene);
 *     while ((status = glint_frame_next(&frame)) > 0)           // a pass
 *         for (tile = frame.tile_first; tile < frame.tile_end; tile++)
 *             if (glint_render_tile(&frame, &workspace, tile))  // any number of callers at once
 *                 send it, glint_tile_find says where;
 */

/** Bytes of a workspace. @param config with which is drawn @return 0 when it is not valid */
size_t glint_workspace_size(const glint_config *config);

/**
 * Lays a workspace out.
 * @param workspace set
 * @param config with which is drawn
 * @param memory of glint_workspace_size bytes, which are not 0, aligned as a pointer is
 */
void glint_workspace_init(glint_workspace *workspace, const glint_config *config, void *memory);

/**
 * Begins a frame: checks the scene and prepares camera, lights and materials in the arena, all of which it may use. On
 * failure the frame, if there is one, is all 0.
 * @param frame where config->keeps_arena is set, the last one drawn with this configuration, or all 0; else anything
 * @param config how to draw; copied
 * @param scene what to draw; it stays until the frame is done
 * @return GLINT_OK, or why the frame cannot be drawn
 */
glint_status glint_frame_begin(glint_frame *frame, const glint_config *config, const glint_scene *scene);

/** Prepares the next pass. @param frame begun @return 1 when there is one, 0 when the frame is done, or an error. */
int glint_frame_next(glint_frame *frame);

/**
 * Draws what this pass holds of a tile from frame->tile_first to frame->tile_end - 1. Reads the frame, writes the
 * workspace and the tile's own list: callers with workspaces of their own may draw tiles of one pass at the same time,
 * each another. A tile that takes several passes must be drawn into the same workspace in each.
 * @param frame a pass is prepared of
 * @param workspace where it is drawn
 * @param tile its number
 * @return 1 when the tile is finished, 0 when a later pass adds to it, or GLINT_ERROR_PAINT.
 */
int glint_render_tile(const glint_frame *frame, glint_workspace *workspace, uint32_t tile);

/**
 * Where a tile lies on the screen, in pixels, cut at the screen's edges and at the region's.
 * @param frame of which it is
 * @param tile its number
 * @param x,y,width,height set
 */
void glint_tile_rectangle(const glint_frame *frame, uint32_t tile, int *x, int *y, int *width, int *height);

/**
 * The same, with its pixels and its depth.
 * @param frame of which it is
 * @param workspace that holds it
 * @param tile its number
 * @param to set
 */
void glint_tile_find(const glint_frame *frame, const glint_workspace *workspace, uint32_t tile, glint_tile *to);

#ifdef __cplusplus
}
#endif

#endif
