/* SPDX-License-Identifier: MIT */
/**
 * @file renderer.h
 * What the library is measured against: a renderer in single precision, for a core with an FPU and memory for a whole
 * frame. It draws the same scenes as RGB565, rounded to nearest.
 */
#ifndef FLOAT_RENDERER_H
#define FLOAT_RENDERER_H

#include "glint.h"

/** Most of a mesh. A triangle that crosses the near plane takes up to 4 vertices more, and may make 2; what finds no
 * room is not drawn. */
#define FLOAT_VERTICES_MAX 8192
#define FLOAT_TRIANGLES_MAX 16384

/** Red, green and blue, or x, y and z. */
typedef struct float_triple {
    float x, y, z;
} float_triple;

/** A vertex on the screen. */
typedef struct float_vertex {
    float x; /**< Pixels; its whole part is the first column whose centre is not left of it. */
    float y; /**< Pixels. */
    float inverse_w;
    float_triple attribute; /**< Normal, or lit colour, over w. */
    float step;             /**< Rows from it down to the centre of `row`. */
    int32_t row;            /**< The first whose centre is not above it. */
} float_vertex;

/** A triangle to be drawn. */
typedef struct float_triangle {
    uint16_t corner[3];
    uint16_t source; /**< The mesh's triangle that it is, or is a part of. */
} float_triangle;

/** What an object takes while it is drawn. */
typedef struct float_memory {
    float_vertex vertices[FLOAT_VERTICES_MAX];
    float_triple colours[FLOAT_VERTICES_MAX]; /**< Of the mesh, over w. */
    uint32_t packed[FLOAT_VERTICES_MAX];      /**< Sixteenths of a pixel: x in the lower half, y in the upper. */
    uint8_t used[FLOAT_VERTICES_MAX];         /**< A triangle that is drawn has this corner. */
    float_triangle triangles[FLOAT_TRIANGLES_MAX];
    uint16_t facets[FLOAT_TRIANGLES_MAX]; /**< Pixels of triangles that are lit once. */
} float_memory;

/** Where to draw. */
typedef struct float_screen {
    uint32_t width, height;
    uint16_t *colour; /**< width * height, as `depth`; both aligned to 4 bytes. */
    int32_t *depth;   /**< Bits of 1/w as a float, which order as the floats do. */
} float_screen;

/** Draws a scene that the library would draw, but for meshes above FLOAT_VERTICES_MAX or FLOAT_TRIANGLES_MAX. */
void float_render(const float_screen *screen, float_memory *memory, const glint_scene *scene);

#endif
