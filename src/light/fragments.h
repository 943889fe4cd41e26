/* SPDX-License-Identifier: MIT */
/** @file fragments.h Fragments of a triangle that are lit one by one, gathered until there are enough. */
#ifndef GLINT_FRAGMENTS_H
#define GLINT_FRAGMENTS_H

#include "../geometry/draw.h"
#include "../raster/setup.h"
#include "shade.h"

/** 1/w of a far triangle's fragments, where its own plane has too few bits for places. */
static inline void glint_find_depths(glint_fragments *fragments) {
    const unsigned down = fragments->scale - 1;
    for (uint32_t i = 0; i < fragments->count; i++) {
        const int32_t x = fragments->part->x + fragments->column[i], y = fragments->part->y + fragments->row[i];
        const int32_t w = glint_plane_at(&fragments->attributes->depth, x, y);
        fragments->inverse_w[i] = glint_most(glint_shift_right(w, down), 0);
    }
}

/** Rays of fragments against the one through their pixel's centre, in half pixels, Q12. */
static inline void glint_find_rays(const glint_frame *frame, glint_fragments *fragments) {
    const glint_window *window = &fragments->part->window;
    const int32_t x = frame->config.width * 4096 - window->left * 512; /* the window is in sixteenths */
    const int32_t y = window->top * 512 - frame->config.height * 4096;
    const int32_t focal = frame->view->focal;
    if (fragments->scale > GLINT_FAR_SCALE)
        glint_find_depths(fragments);
    for (uint32_t i = 0; i < fragments->count; i++) {
        fragments->ray[i][0] = x - fragments->column[i] * 8192;
        fragments->ray[i][1] = y + fragments->row[i] * 8192;
        fragments->ray[i][2] = focal;
    }
    if (frame->view->is_parallel)
        frame->scene->camera.projection->place(frame, fragments);
}

/** Finds a colour of a fragment from planes of colours over w. */
typedef void glint_resolver(const glint_fragments *fragments, uint32_t i, const glint_plane planes[3], int16_t out[3]);

/** Unit normals of fragments, and the surface's own colours. */
static inline void glint_find_surface(glint_fragments *fragments, const glint_draw *draw, glint_resolver *resolve) {
    const glint_attributes *a = fragments->attributes;
    for (uint32_t i = 0; i < fragments->count; i++) {
        const int32_t x = fragments->part->x + fragments->column[i], y = fragments->part->y + fragments->row[i];
        glint_unit_each(glint_plane_at(&a->main[0], x, y), glint_plane_at(&a->main[1], x, y),
                        glint_plane_at(&a->main[2], x, y), fragments->normal[i]);
        if (draw->extra)
            resolve(fragments, i, a->extra, fragments->surface[i]);
    }
}

/** Finds colours of fragments, Q23. */
typedef void glint_shader(const glint_frame *frame, glint_fragments *fragments, const glint_draw *draw);

/** Fragments of a part on their way to pixels. */
typedef struct glint_gathering {
    const glint_frame *frame;
    glint_workspace *workspace;
    const glint_part *part;
    const glint_draw *draw;
    glint_shader *shade;
    glint_fragments *fragments;
} glint_gathering;

/**
 * Begins with no fragments of a triangle whose planes are made of `main`, and of its extra attributes if it has some.
 * Where normals are lit, those of backs are turned over.
 */
void glint_gathering_begin(const glint_gathering *gathering, const glint_triangle *triangle,
                           const int16_t *const main[3], glint_attributes *attributes);

/** Lights the fragments gathered so far, and stores them by runs. */
void glint_gathering_store(const glint_gathering *gathering);

/** Adds the fragment at a pixel of the tile, for which there is room. */
static inline void glint_gather(const glint_gathering *gathering, int32_t x, int32_t y, int32_t inverse_w) {
    glint_fragments *fragments = gathering->fragments;
    const uint32_t i = fragments->count++;
    fragments->column[i] = (int8_t)x;
    fragments->row[i] = (int8_t)y;
    fragments->inverse_w[i] = glint_most(inverse_w, 0); /* rounding may take a deep triangle's plane below */
}

/** The same, lit at once where no more fit. */
static inline void glint_gather_lit(const glint_gathering *gathering, int32_t x, int32_t y) {
    const glint_part *part = gathering->part;
    glint_gather(gathering, x, y, glint_plane_at(&part->depth, part->x + x, part->y + y));
    if (gathering->fragments->count == GLINT_FRAGMENTS_MAX)
        glint_gathering_store(gathering);
}

#endif
