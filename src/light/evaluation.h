/* SPDX-License-Identifier: MIT */
/** @file evaluation.h Evaluations: where light is computed, and the functions that draw triangles then. */
#ifndef GLINT_EVALUATION_H
#define GLINT_EVALUATION_H

#include "../geometry/draw.h"
#include "../pixel/format.h"
#include "shading.h"

/** Points at which light is computed. */
typedef enum glint_lit_at { GLINT_LIT_AT_FRAGMENTS, GLINT_LIT_AT_VERTICES, GLINT_LIT_AT_FACETS } glint_lit_at;

struct glint_evaluation {
    uint8_t lit_at;              /* glint_lit_at */
    uint8_t is_costly;           /* hidden triangles are to be dropped before they are begun */
    glint_light_triangle *light; /* lights or prepares the corners of a triangle before it is drawn */
    void (*draw_triangle)(glint_row_walk *walk);
    size_t (*vertex_size)(const glint_shading *shading); /* the bytes of a vertex's terms; null for none */
};

/** Light at fragments by directional lights alone: suns.h. It is linked if a program uses both such lights and
 * glint_per_fragment. */
typedef struct glint_suns_stage {
    const glint_evaluation *evaluation;
    /** Returns whether an object can be lit this way; its material is prepared. */
    int (*serves)(const glint_frame *frame, const glint_shading *shading, const glint_object *object);
    /** Prepares the materials of a frame, which come last in the arena. */
    glint_status (*prepare)(glint_frame *frame);
    /** Adds the bytes that a material needs, and those of its tables, which are made only if the arena has room. */
    void (*need)(const glint_frame *frame, const glint_shading *shading, size_t *least, size_t *tables);
} glint_suns_stage;

extern const glint_suns_stage glint_suns_of_lights GLINT_IF_LINKED;

/** Returns the stage of suns if a scene has directional lights, or null. */
static inline const glint_suns_stage *glint_find_suns(const glint_scene *scene) {
    for (uint32_t i = 0; i < scene->light_count; i++)
        if (scene->lights[i].type->suns)
            return scene->lights[i].type->suns;
    return 0;
}

/** Returns the numbers of a triangle's corners in the order of slopes, which begins with corner `top`. */
static GLINT_INLINE const uint8_t *glint_corner_order(uint32_t top) {
    static const uint8_t next[5] = {0, 1, 2, 0, 1};
    return &next[top];
}

/** Changes the slopes of a small triangle so that colours a, b, c of its corners, in the order of slopes, may be linear
 * on the screen.
 * @return 0 if perspective bends them too much for that */
int glint_bend_slopes(const glint_row_walk *walk, glint_slopes *slopes, const int16_t *a, const int16_t *b,
                      const int16_t *c);

/** Begins with the colours of a triangle's corners, once the depth has been begun, and chooses what draws spans. A
 * texture asks for this; it is linked where surfaces have light. */
void glint_begin_interpolated(glint_row_walk *walk) GLINT_IF_LINKED;

/** Divides the colour at a pixel, 1 = GLINT_COLOUR_ONE. Linked likewise. */
void glint_divide_at(const glint_row_walk *walk, int32_t row, int32_t column, int16_t colour[3]) GLINT_IF_LINKED;

/** Draws a triangle in the colour of its facet. */
void glint_draw_facet(glint_row_walk *walk);

/** Draws a triangle with colours interpolated between its corners. */
void glint_draw_lit(glint_row_walk *walk);

#endif
