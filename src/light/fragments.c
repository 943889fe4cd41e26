/* SPDX-License-Identifier: MIT */
/* Fragments of a triangle that are lit one by one, gathered until there are enough. */
#include "fragments.h"

#include "../pixel/format.h"
#include "../raster/runs.h"
#include "evaluation.h"

/* An attribute of 16 bits over w: below 2^30. */
static int32_t over_w(int32_t attribute, uint32_t w) {
    return attribute * (int32_t)(w >> 16) + glint_shift_right(attribute * (int32_t)(w & 0xffff), 16);
}

/* Planes of three attributes of 16 bits over w 2^-up, times a sign. */
static void triple(glint_plane planes[3], const glint_gradients *g, const glint_triangle *triangle, unsigned up,
                   const int16_t *const attribute[3], int32_t sign) {
    for (int c = 0; c < 3; c++) {
        int32_t scaled[3];
        for (int i = 0; i < 3; i++)
            scaled[i] = over_w(sign * attribute[i][c], (uint32_t)triangle->corners[i]->inverse_w << up);
        glint_plane_begin(&planes[c], g, scaled[0], scaled[1], scaled[2]);
    }
}

/* 1/w of a far triangle, with the bits that its own plane lacks. */
static void begin_far(glint_plane *depth, const glint_gradients *g, const glint_triangle *triangle, unsigned scale) {
    const int32_t by = 1 << (scale - 1);
    const glint_vertex *const *v = triangle->corners;
    glint_plane_begin(depth, g, v[0]->inverse_w * by, v[1]->inverse_w * by, v[2]->inverse_w * by);
}

void glint_gathering_begin(const glint_gathering *gathering, const glint_triangle *triangle,
                           const int16_t *const main[3], glint_attributes *attributes) {
    const glint_gradients *g = &gathering->part->gradients;
    glint_fragments *fragments = gathering->fragments;
    const unsigned up = glint_find_room(triangle->corners);
    fragments->count = 0;
    fragments->part = gathering->part;
    fragments->attributes = attributes;
    fragments->scale = up;
    fragments->away = triangle->away;
    const int is_opposite = triangle->back && gathering->draw->evaluation->lit_at == GLINT_LIT_AT_FRAGMENTS;
    if (up > GLINT_FAR_SCALE)
        begin_far(&attributes->depth, g, triangle, up);
    triple(attributes->main, g, triangle, up, main, is_opposite ? -1 : 1);
    if (gathering->draw->extra)
        triple(attributes->extra, g, triangle, up, triangle->extra, 1);
}

/* Colours of fragments in levels: each takes the place of its colour. */
static void finish_fragments(const glint_frame *frame, glint_fragments *fragments) {
    const uint8_t *const bits = frame->config.format->channel;
    const unsigned red = bits[0], green = bits[1], blue = bits[2];
    int32_t(*row)[3] = (int32_t(*)[3])fragments->colour;
    for (uint32_t i = 0; i < fragments->count; i++)
        glint_channels_of(fragments->colour[i], row[i]);
    if (GLINT_SMALL || frame->config.gamma) {
        glint_finish_colours(&frame->config, row, fragments->count);
        return;
    }
    for (uint32_t i = 0; i < fragments->count; i++, row++) {
        (*row)[0] = glint_to_levels((*row)[0], red);
        (*row)[1] = glint_to_levels((*row)[1], green);
        (*row)[2] = glint_to_levels((*row)[2], blue);
    }
}

/* Stores fragments by runs; what that takes of stack is not there while they are shaded. */
static GLINT_NOINLINE void store_fragments(const glint_gathering *gathering) {
    const glint_frame *frame = gathering->frame;
    const glint_fragments *fragments = gathering->fragments;
    const int8_t *const x = fragments->column, *const y = fragments->row;
    glint_run runs[GLINT_FRAGMENTS_MAX], *end = runs;
    for (uint32_t i = 0; i < fragments->count; i++) {
        if (i && y[i] == y[i - 1] && x[i] == x[i - 1] + 1)
            end[-1].count++;
        else
            *end++ = (glint_run){(uint8_t)x[i], (uint8_t)y[i], 1};
    }
    frame->config.format->store(gathering->workspace->pixels, frame->tile_shift_x, runs, end,
                                (const int32_t(*)[3])fragments->colour);
}

void glint_gathering_store(const glint_gathering *gathering) {
    glint_fragments *fragments = gathering->fragments;
    if (!fragments->count)
        return;
    gathering->shade(gathering->frame, fragments, gathering->draw);
    finish_fragments(gathering->frame, fragments);
    store_fragments(gathering);
    fragments->count = 0;
}
