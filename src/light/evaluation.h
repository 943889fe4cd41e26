/* SPDX-License-Identifier: MIT */
/** @file evaluation.h Where light is found, and what draws pixels. */
#ifndef GLINT_EVALUATION_H
#define GLINT_EVALUATION_H

#include "../geometry/draw.h"
#include "../pixel/format.h"
#include "shading.h"

/** Where colours are found. */
typedef enum glint_lit_at { GLINT_LIT_AT_FRAGMENTS, GLINT_LIT_AT_VERTICES, GLINT_LIT_AT_FACETS } glint_lit_at;

struct glint_evaluation {
    uint8_t lit_at;              /* glint_lit_at */
    uint8_t is_costly;           /* what is hidden is better not begun */
    glint_light_triangle *light; /* what comes before a triangle is drawn */
    void (*draw_triangle)(glint_row_walk *walk);
    size_t (*vertex_size)(const glint_shading *shading); /* the bytes that a vertex keeps of lights, or null for none */
};

/** Light of directional lights alone, which is linked with these and glint_per_fragment: suns.h. */
typedef struct glint_suns_stage {
    const glint_evaluation *evaluation;
    /** Can an object be lit this way? Its material is prepared. */
    int (*serves)(const glint_frame *frame, const glint_shading *shading, const glint_object *object);
    /** Prepares the materials of a frame; they are what the arena holds last. */
    glint_status (*prepare)(glint_frame *frame);
    /** Adds the bytes that a material takes at least, and its tables, which want as much room left behind them. */
    void (*need)(const glint_frame *frame, const glint_shading *shading, size_t *least, size_t *tables);
} glint_suns_stage;

extern const glint_suns_stage glint_suns_of_lights GLINT_IF_LINKED;

/** Returns it where a scene has directional lights, or null. */
static inline const glint_suns_stage *glint_find_suns(const glint_scene *scene) {
    for (uint32_t i = 0; i < scene->light_count; i++)
        if (scene->lights[i].type->suns)
            return scene->lights[i].type->suns;
    return 0;
}

/** Moves the slopes of a small triangle so that colours of its corners, in the order of slopes, are linear on the
 * screen.
 * @return 0 where they are not */
int glint_bend_slopes(const glint_row_walk *walk, glint_slopes *slopes, const int16_t *a, const int16_t *b,
                      const int16_t *c);

/** Draws a triangle of its own one colour. */
void glint_draw_facet(glint_row_walk *walk);

/** Draws a triangle with colours at its corners. */
void glint_draw_lit(glint_row_walk *walk);

#endif
