/* SPDX-License-Identifier: MIT */
/* Kernel: from the spans of a triangle to pixels, by runs of pixels that pass the depth test and a row of colours. */
#include "colour.h"
#include "spans.h"
#include "terms.h"

/* ---- Triangles ---- */

/* What the colours of a triangle's pixels come from: one of these. */
typedef struct source {
    const int32_t *even;                /* the one colour of all, which the row holds */
    const glint_plane *channels;        /* three planes */
    const glint_terms *terms;           /* light */
    const glint_attributes *attributes; /* what fragments are lit by */
    const glint_draw *draw;
    uint32_t scale;        /* of the attributes: over w 2^scale */
    int is_deep, finishes; /* are colours found that are to be finished? */
} source;

/* 1/w of the corners, none 0, the largest in 2^30 .. 2^31; @return the shift that took. */
static unsigned scale_inverse_w(const glint_vertex *const v[3], uint32_t w[3]) {
    unsigned up =
        glint_leading_zeros((uint32_t)v[0]->inverse_w | (uint32_t)v[1]->inverse_w | (uint32_t)v[2]->inverse_w) - 1;
    for (int i = 0; i < 3; i++)
        w[i] = (uint32_t)v[i]->inverse_w << up;
    return up;
}

/* An attribute of 16 bits over w: below 2^30. */
static int32_t over_w(int32_t attribute, uint32_t w) {
    return attribute * (int32_t)(w >> 16) + glint_shift_right(attribute * (int32_t)(w & 0xffff), 16);
}

/* Planes of three attributes of 16 bits over w; negated, normals are those of the back. */
static void triple(glint_plane planes[3], const glint_gradients *g, const int16_t *const attribute[3],
                   const uint32_t w[3], int negated) {
    for (int c = 0; c < 3; c++) {
        int32_t scaled[3];
        for (int i = 0; i < 3; i++)
            scaled[i] = over_w(negated ? -attribute[i][c] : attribute[i][c], w[i]);
        glint_plane_begin(&planes[c], g, scaled[0], scaled[1], scaled[2]);
    }
}

/* ---- Rows ---- */

/* Pixels of a row that are nearer than what was there, from one to before another. */
typedef struct run {
    uint8_t first, end;
} run;

/* Depth of 1/w, given with GLINT_DEPTH_BIAS; that of a deep triangle's planes may be below 0. */
static inline uint32_t depth_of(uint32_t z, int is_deep) {
    return (is_deep ? (uint32_t)glint_most((int32_t)z, GLINT_DEPTH_BIAS) : z) >> 15;
}

/* Finds the runs of a span, and stores their depth. @return how many */
static inline uint32_t find_runs(uint16_t *depth, glint_span span, uint32_t z, uint32_t z_dx, int is_deep, run *runs) {
    uint32_t count = 0, column = span.left;
    while (column < span.right) {
        while (depth_of(z, is_deep) <= depth[column]) {
            z += z_dx;
            if (++column == span.right)
                return count;
        }
        runs[count].first = (uint8_t)column;
        do {
            depth[column] = (uint16_t)depth_of(z, is_deep);
            z += z_dx;
            column++;
        } while (column < span.right && depth_of(z, is_deep) > depth[column]);
        runs[count++].end = (uint8_t)column;
    }
    return count;
}

static GLINT_NOINLINE uint32_t find_deep_runs(uint16_t *depth, glint_span span, uint32_t z, uint32_t z_dx, run *runs) {
    return find_runs(depth, span, z, z_dx, 1, runs);
}

static void find_linear(const glint_plane channels[3], int32_t x, int32_t y, uint32_t count, int32_t (*row)[3]) {
    int32_t red = glint_plane_at(&channels[0], x, y), green = glint_plane_at(&channels[1], x, y),
            blue = glint_plane_at(&channels[2], x, y);
    for (; count; count--, row++) {
        (*row)[0] = red;
        (*row)[1] = green;
        (*row)[2] = blue;
        red = glint_add_wrap(red, channels[0].dx);
        green = glint_add_wrap(green, channels[1].dx);
        blue = glint_add_wrap(blue, channels[2].dx);
    }
}

/* Lights fragments one by one. */
static void find_lit(const glint_frame *frame, const source *from, const glint_part *part, int32_t x, int32_t y,
                     uint32_t count, int32_t (*row)[3]) {
    glint_fragments fragments;
    fragments.scale = from->scale;
    fragments.attributes = from->attributes;
    for (uint32_t done = 0; done < count; done += fragments.count) {
        const int32_t column = x + (int32_t)done;
        int32_t inverse_w = glint_plane_at(&part->depth, column, y);
        fragments.count = count - done < GLINT_FRAGMENTS_MAX ? count - done : GLINT_FRAGMENTS_MAX;
        fragments.at_x = column;
        fragments.at_y = y;
        fragments.x = column - part->x + glint_shift_right(part->window.left, 4);
        fragments.y = y - part->y + glint_shift_right(part->window.top, 4);
        for (uint32_t i = 0; i < fragments.count; i++) {
            fragments.inverse_w[i] = glint_most(inverse_w, 0); /* rounding may take a deep triangle's plane below */
            inverse_w = glint_add_wrap(inverse_w, part->depth.dx);
        }
        glint_shade(frame, &fragments, from->draw);
        for (uint32_t i = 0; i < fragments.count; i++)
            glint_channels_of(fragments.colour[i], row[done + i]);
    }
}

static void draw_run(const glint_frame *frame, glint_workspace *workspace, const source *from, const glint_part *part,
                     run at, uint32_t y) {
    const uint32_t count = (uint32_t)at.end - at.first;
    const int32_t x = part->x + at.first, down = part->y + (int32_t)y;
    if (from->channels)
        find_linear(from->channels, x, down, count, workspace->row);
    else if (from->terms)
        glint_terms_row(from->terms, x, down, count, workspace->row);
    else if (from->attributes)
        find_lit(frame, from, part, x, down, count, workspace->row);
    if (from->finishes)
        glint_finish_colours(&frame->config, workspace->row, count);
    frame->config.format->store(workspace->pixels, frame->tile_shift_x, (y << frame->tile_shift_x) + at.first, count,
                                (const int32_t(*)[3])workspace->row);
}

/* Draws a part by runs. @return pixels of its spans */
static uint32_t draw_runs(const glint_frame *frame, glint_workspace *workspace, const source *from,
                          const glint_part *part) {
    run runs[(GLINT_TILE_MAX + 1) / 2];
    uint32_t covered = 0;
    for (uint32_t y = part->top; y < part->bottom; y++) {
        const glint_span span = part->spans[y];
        const uint32_t z_dx = (uint32_t)part->depth.dx;
        const uint32_t z =
            (uint32_t)glint_plane_at(&part->depth, part->x + span.left, part->y + (int32_t)y) + GLINT_DEPTH_BIAS;
        uint16_t *const depth = workspace->depth + (y << frame->tile_shift_x);
        const uint32_t count = from->is_deep || GLINT_SMALL ? find_deep_runs(depth, span, z, z_dx, runs)
                                                            : find_runs(depth, span, z, z_dx, 0, runs);
        covered += (uint32_t)span.right - span.left;
        for (uint32_t i = 0; i < count; i++)
            draw_run(frame, workspace, from, part, runs[i], y);
    }
    return covered;
}

/* ---- Kernels ---- */

/* Pixels of a part's spans. */
static uint32_t covered_by(const glint_part *part) {
    uint32_t covered = 0;
    for (uint32_t y = part->top; y < part->bottom; y++)
        covered += (uint32_t)part->spans[y].right - part->spans[y].left;
    return covered;
}

/* Draws a part in one colour, which is not finished. */
static void draw_even(const glint_frame *frame, glint_workspace *workspace, const glint_triangle *triangle,
                      const glint_part *part, int32_t colour[1][3]) {
    const int is_deep = glint_is_deep(triangle);
    glint_finish_colours(&frame->config, colour, 1);
    if (frame->config.format->draw_even && !is_deep) {
        const glint_spans spans = glint_spans_of(frame, workspace, part);
        frame->config.format->draw_even(&spans, colour[0]);
    } else {
        const source from = {.even = colour[0], .is_deep = is_deep};
        for (uint32_t i = 0; i < frame->config.tile_width; i++)
            for (int c = 0; c < 3; c++)
                workspace->row[i][c] = colour[0][c];
        draw_runs(frame, workspace, &from, part);
    }
    if (workspace->drawn)
        glint_count(workspace, GLINT_KERNEL_EVEN, covered_by(part));
}

void glint_draw_unlit(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, const glint_part *part) {
    int32_t colour[1][3];
    glint_channels_of(draw->shading->ambient, colour[0]);
    draw_even(frame, workspace, triangle, part, colour);
}

void glint_draw_facet(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, const glint_part *part) {
    int32_t colour[1][3];
    (void)draw;
    for (int c = 0; c < 3; c++)
        colour[0][c] = glint_channel_of(triangle->facet[c]);
    draw_even(frame, workspace, triangle, part, colour);
}

/* Draws fragments that are lit one by one, by attributes that are interpolated over w. */
static void draw_fragments(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part, const int16_t *const main[3],
                           int is_negated) {
    glint_attributes attributes;
    uint32_t w[3];
    const source from = {.attributes = &attributes,
                         .draw = draw,
                         .scale = scale_inverse_w(triangle->corners, w),
                         .is_deep = glint_is_deep(triangle),
                         .finishes = 1};
    triple(attributes.main, &part->gradients, main, w, is_negated);
    if (draw->extra && draw->evaluation->lit_at == GLINT_LIT_AT_FRAGMENTS)
        triple(attributes.extra, &part->gradients, triangle->extra, w, 0);
    glint_count(workspace, GLINT_KERNEL_GENERAL, draw_runs(frame, workspace, &from, part));
}

void glint_draw_any(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                    const glint_triangle *triangle, const glint_part *part) {
    const glint_vertex *const *v = triangle->corners;
    const int16_t *const normals[3] = {v[0]->attribute, v[1]->attribute, v[2]->attribute};
    draw_fragments(frame, workspace, draw, triangle, part, normals, triangle->back);
}

void glint_draw_terms(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, const glint_part *part) {
    glint_terms terms;
    if (!glint_terms_begin(frame, draw, triangle, part, &terms)) {
        glint_draw_any(frame, workspace, draw, triangle, part);
        return;
    }
    const source from = {.terms = &terms, .finishes = frame->config.gamma != 0};
    glint_count(workspace, GLINT_KERNEL_CHANNELS, draw_runs(frame, workspace, &from, part));
}

/* How far a plane may be from a colour that is linear over w: 1/10 of a level; Q15, times 4. */
#define PLANE_LIMIT ((1u << 15) * 4 / 10)

/*
 * Is the plane of a colour near enough? Where 1/w changes by a factor 1 + r, it lies at most r / 4 of its corners'
 * difference from what is linear over w.
 */
static int fits_plane(const glint_triangle *triangle, const glint_format *format, const int16_t *const colour[3]) {
    const glint_w_range w = glint_find_w_range(triangle->corners);
    const unsigned bits = format->channel[1] ? format->channel[1] : 8;
    const uint32_t limit = PLANE_LIMIT >> bits;
    uint32_t apart = 0;
    for (int c = 0; c < 3; c++) {
        const int32_t least = glint_least_of(colour[0][c], colour[1][c], colour[2][c]),
                      most = glint_most_of(colour[0][c], colour[1][c], colour[2][c]);
        apart = apart > (uint32_t)(most - least) ? apart : (uint32_t)(most - least);
    }
    return apart * w.change <= limit * w.least;
}

void glint_draw_lit(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                    const glint_triangle *triangle, const glint_part *part) {
    const glint_vertex *const *v = triangle->corners;
    const int16_t *const front[3] = {v[0]->attribute, v[1]->attribute, v[2]->attribute};
    const int16_t *const *const colour = triangle->back && draw->double_sided ? triangle->extra : front;
    const glint_format *const format = frame->config.format;
    glint_plane channels[3];
    if (glint_is_deep(triangle) || !fits_plane(triangle, format, colour)) {
        draw_fragments(frame, workspace, draw, triangle, part, colour, 0);
        return;
    }
    const int finishes = frame->config.gamma != 0;
    for (int c = 0; c < 3; c++) {
        int32_t a[3];
        for (int i = 0; i < 3; i++)
            a[i] = finishes ? glint_channel_of(colour[i][c])
                            : glint_to_levels(glint_channel_of(colour[i][c]), format->channel[c]);
        glint_plane_begin(&channels[c], &part->gradients, a[0], a[1], a[2]);
    }
    if (format->draw_channels && !finishes) {
        const glint_spans spans = glint_spans_of(frame, workspace, part);
        format->draw_channels(&spans, channels);
    } else {
        const source from = {.channels = channels, .finishes = finishes};
        draw_runs(frame, workspace, &from, part);
    }
    if (workspace->drawn)
        glint_count(workspace, GLINT_KERNEL_CHANNELS, covered_by(part));
}
