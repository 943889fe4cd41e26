/* SPDX-License-Identifier: MIT */
/* Kernel: from the spans of a triangle to pixels, by runs of pixels that pass the depth test and a row of colours. */
#include "../pixel/format.h"
#include "../raster/found.h"
#include "../raster/polynomial.h"
#include "../raster/runs.h"
#include "colour.h"
#include "evaluation.h"
#include "fragments.h"

/* ---- Triangles ---- */

typedef struct colour_source colour_source;

/* Draws a run. */
typedef void drawer(const colour_source *from, const glint_run *run);

/* What the colours of a triangle's pixels come from. */
struct colour_source {
    glint_gathering to; /* of runs that are gathered; of others it has no shader */
    drawer *draw_run;
    const glint_triangle *triangle;  /* of gather_run: */
    const int16_t *const *main;      /* its corners' attributes */
    const glint_quadratic *channels; /* of draw_channel_run */
    int is_deep;
};

/* ---- Rows ---- */

static void store_run(const colour_source *from, const glint_run *run) {
    const glint_frame *frame = from->to.frame;
    const glint_workspace *workspace = from->to.workspace;
    frame->config.format->store(workspace->pixels, frame->tile_shift_x, run, run + 1,
                                (const int32_t(*)[3])workspace->row);
}

static void draw_channel_run(const colour_source *from, const glint_run *run) {
    const glint_config *config = &from->to.frame->config;
    const glint_part *part = from->to.part;
    int32_t(*const row)[3] = from->to.workspace->row;
    for (int c = 0; c < 3; c++) {
        const glint_quadratic *q = &from->channels[c];
        glint_stride s = glint_stride_begin(q, part->x + run->x, part->y + run->y);
        for (uint32_t i = 0; i < run->count; i++) {
            row[i][c] = (int32_t)s.value;
            glint_stride_next(&s, q);
        }
    }
    if (config->gamma)
        glint_finish_colours(config, row, run->count);
    store_run(from, run);
}

/* Gathers the fragments of a run, and lights them whenever there are enough. Of a hidden triangle there is none. */
static void gather_run(const colour_source *from, const glint_run *run) {
    const glint_part *part = from->to.part;
    if (!from->to.fragments->attributes)
        glint_gathering_begin(&from->to, from->triangle, from->main, &from->to.workspace->gathered->attributes);
    const uint32_t end = (uint32_t)run->x + run->count;
    int32_t inverse_w = glint_plane_at(&part->depth, part->x + run->x, part->y + run->y);
    for (uint32_t column = run->x; column < end && GLINT_SMALL; column++)
        glint_gather_lit(&from->to, (int32_t)column, run->y);
    for (uint32_t column = run->x; column < end && !GLINT_SMALL; column++) {
        glint_gather(&from->to, (int32_t)column, run->y, inverse_w);
        inverse_w = glint_add_wrap(inverse_w, part->depth.dx);
        if (from->to.fragments->count == GLINT_FRAGMENTS_MAX)
            glint_gathering_store(&from->to);
    }
}

/* Draws a part by runs. @return pixels of its spans */
static uint32_t draw_runs(const colour_source *from) {
    const glint_part *part = from->to.part;
    glint_run runs[GLINT_ROW_RUNS];
    uint32_t covered = 0;
    for (uint32_t y = part->top; y < part->bottom; y++) {
        const glint_run *const end = glint_find_runs(from->to.frame, from->to.workspace, part, from->is_deep, y, runs);
        covered += (uint32_t)part->spans[y].right - part->spans[y].left;
        for (const glint_run *run = runs; run != end; run++)
            from->draw_run(from, run);
    }
    return covered;
}

/* ---- Kernels ---- */

/* Draws a part in one colour, which is finished. */
static void draw_even(const glint_frame *frame, glint_workspace *workspace, const glint_triangle *triangle,
                      const glint_part *part, const int32_t colour[3]) {
    const int is_deep = glint_is_deep(triangle);
    if (!GLINT_SMALL && frame->config.format->draw_even && !is_deep) {
        const glint_spans spans = glint_spans_of(frame, workspace, part);
        frame->config.format->draw_even(&spans, colour);
    } else {
        const colour_source from = {.to = {frame, workspace, part, 0, 0, 0}, .draw_run = store_run, .is_deep = is_deep};
        for (uint32_t i = 0; i < frame->config.tile_width; i++)
            for (int c = 0; c < 3; c++)
                workspace->row[i][c] = colour[c];
        draw_runs(&from);
    }
    if (workspace->drawn)
        glint_count(workspace, GLINT_KERNEL_EVEN, glint_covered_by(part));
}

void glint_draw_unlit(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, const glint_part *part) {
    draw_even(frame, workspace, triangle, part, draw->even);
}

void glint_draw_facet(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, const glint_part *part) {
    int32_t colour[1][3];
    (void)draw;
    for (int c = 0; c < 3; c++)
        colour[0][c] = glint_channel_of(triangle->facet[c]);
    glint_finish_colours(&frame->config, colour, 1);
    draw_even(frame, workspace, triangle, part, colour[0]);
}

/* Draws fragments that are coloured one by one. */
static void draw_fragments(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part, const int16_t *const main[3],
                           glint_shader *shade) {
    const int is_deep = GLINT_SMALL || glint_is_deep(triangle);
    glint_fragments *const fragments = &workspace->gathered->fragments;
    const colour_source from = {
        {frame, workspace, part, draw, shade, fragments}, gather_run, triangle, main, 0, is_deep};
    fragments->count = 0;
    fragments->attributes = 0;
    const uint32_t covered = draw_runs(&from);
    glint_gathering_store(&from.to);
    glint_count(workspace, GLINT_KERNEL_GENERAL, covered);
}

void glint_draw_any(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                    const glint_triangle *triangle, const glint_part *part) {
    const glint_vertex *const *v = triangle->corners;
    const int16_t *const normals[3] = {v[0]->attribute, v[1]->attribute, v[2]->attribute};
    draw_fragments(frame, workspace, draw, triangle, part, normals, glint_shade);
}

/* ---- Colours at corners ---- */

/* Finds colours of fragments from those of vertices. */
static void resolve(const glint_frame *frame, glint_fragments *fragments, const glint_draw *draw) {
    (void)frame;
    (void)draw;
    for (uint32_t i = 0; i < fragments->count; i++) {
        int16_t colour[3];
        glint_resolve_colour(fragments, i, fragments->attributes->main, colour);
        for (int c = 0; c < 3; c++) /* 32767 stands for 1 */
            fragments->colour[i][c] = ((uint32_t)colour[c] << 8) + ((uint32_t)colour[c] >> 7);
    }
}

/* How far a polynomial may be from a colour that is linear over w: 1/10 of a level, Q15. */
#define CLOSE ((1u << 15) / 10)

/* Of all channels, what the corners' colours are apart at most. */
static uint32_t find_difference(const int16_t *const colour[3]) {
    uint32_t most = 0;
    for (int c = 0; c < 3; c++) {
        const uint32_t apart = (uint32_t)(glint_most_of(colour[0][c], colour[1][c], colour[2][c]) -
                                          glint_least_of(colour[0][c], colour[1][c], colour[2][c]));
        most = apart > most ? apart : most;
    }
    return most;
}

/* How far pixels of a triangle lie from its first corner, in x and y together. */
static uint32_t find_farthest(const glint_vertex *const v[3]) {
    int32_t most = 0;
    for (int i = 1; i < 3; i++) {
        const int32_t x = v[i]->x - v[0]->x, y = v[i]->y - v[0]->y;
        most = glint_most(most, glint_most(x, -x) + glint_most(y, -y));
    }
    return (uint32_t)most >> 4;
}

/* How a triangle's colours are drawn. */
typedef enum curve_fit { FITS_PLANES, FITS_QUADRATICS, FITS_NOTHING } curve_fit;

/*
 * Where 1/w changes by a factor 1 + r, what is linear over w is at most r / 4 of its corners' difference from a plane,
 * and 0.0485 r^2 from a quadratic through the middles of the edges too; slivers have none. Coefficients of the second
 * degree, rounded down by up to 1, 2 and 1 of 2^-GLINT_CHANNEL_BITS, add that times the span's square.
 */
static curve_fit find_fit(const glint_triangle *triangle, const glint_gradients *g, const glint_format *format,
                          const int16_t *const colour[3]) {
    const glint_w_range w = glint_find_w_range(triangle->corners);
    const uint32_t close = CLOSE >> (format->channel[1] ? format->channel[1] : 8), apart = find_difference(colour);
    if (apart * w.change <= 4 * close * w.least)
        return FITS_PLANES;
    if (16 * w.change > 7 * w.least || glint_slenderness(g, triangle->area) > GLINT_SLENDER ||
        triangle->area < GLINT_POLYNOMIAL_LEAST_AREA)
        return FITS_NOTHING;
    const uint32_t span = g->reciprocal ? 0 : find_farthest(triangle->corners); /* narrow ones reach no 128 pixels */
    if (span * span > close << (GLINT_CHANNEL_BITS - 15))
        return FITS_NOTHING;
    const uint32_t ratio = (w.change << 12) / w.least; /* w.change is at most 2^15 */
    return apart * (ratio * ratio >> 12) <= (close * 20 << 12) ? FITS_QUADRATICS : FITS_NOTHING;
}

/* Of find_skew, where 1/w changes by at most 7/16. */
#define MOST_SKEW 5898

/*
 * Four times what a colour at the middle of an edge is more than the mean of its ends, over their difference: Q14. With
 * 1/w times 2^up, below 2^31.
 */
static int32_t find_skew(const glint_vertex *a, const glint_vertex *b, unsigned up) {
    const int32_t wa = a->inverse_w << up >> 16, wb = b->inverse_w << up >> 16;
    const int32_t skew = wa == wb ? 0 : (wa - wb) * (1 << 15) / (wa + wb);
    return glint_least(glint_most(skew, -MOST_SKEW), MOST_SKEW);
}

static void begin_channel_planes(glint_quadratic channel[3], const glint_gradients *g, int32_t a[3][3]) {
    for (int c = 0; c < 3; c++) {
        glint_plane plane;
        const int32_t up = 1 << (GLINT_CHANNEL_BITS - 15);
        glint_plane_begin(&plane, g, a[c][0] * up, a[c][1] * up, a[c][2] * up);
        glint_quadratic_of(&channel[c], &plane);
    }
}

static void begin_channel_quadratics(glint_quadratic channel[3], const glint_gradients *g,
                                     const glint_vertex *const v[3], int32_t a[3][3]) {
    const unsigned up = glint_find_room(v);
    const int32_t skew[3] = {find_skew(v[0], v[1], up), find_skew(v[1], v[2], up), find_skew(v[0], v[2], up)};
    glint_barycentric s;
    glint_barycentric_begin(&s, g, GLINT_CHANNEL_BITS - 15);
    for (int c = 0; c < 3; c++) {
        const int32_t bulge[3] = {glint_shift_right((a[c][0] - a[c][1]) * skew[0], 14),
                                  glint_shift_right((a[c][1] - a[c][2]) * skew[1], 14),
                                  glint_shift_right((a[c][0] - a[c][2]) * skew[2], 14)};
        glint_polynomial_begin(&channel[c], &s, a[c], bulge);
    }
}

/* Colours of a triangle that is lit at its corners. */
typedef struct lit_colours {
    curve_fit how;
    glint_quadratic channels[3];
} lit_colours;

static void find_lit_colours(const glint_config *config, const glint_triangle *triangle, const glint_gradients *g,
                             const int16_t *const colour[3], lit_colours *to) {
    const glint_format *const format = config->format;
    int32_t a[3][3];
    to->how = glint_is_deep(triangle) ? FITS_NOTHING : find_fit(triangle, g, format, colour);
    if (to->how == FITS_NOTHING)
        return;
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 3; i++)
            a[c][i] = config->gamma || !format->channel[c] ? colour[i][c]
                                                           : colour[i][c] - (colour[i][c] >> format->channel[c]);
    if (to->how == FITS_PLANES)
        begin_channel_planes(to->channels, g, a);
    else
        begin_channel_quadratics(to->channels, g, triangle->corners, a);
    for (int c = 0; c < 3 && !config->gamma; c++)
        to->channels[c].start += (uint32_t)glint_to_levels(0, format->channel[c]);
}

/* These, found here unless another tile did. @param own room for them */
static const lit_colours *find_lit(const glint_frame *frame, glint_workspace *workspace, const glint_triangle *triangle,
                                   const glint_part *part, const int16_t *const colour[3], lit_colours *own) {
    const lit_colours *const before = glint_found_find(workspace, triangle, part, 0);
    if (before)
        return before;
    lit_colours *const kept = glint_found_begin(workspace, triangle, part, sizeof *kept);
    lit_colours *const found = kept ? kept : own;
    find_lit_colours(&frame->config, triangle, &part->gradients, colour, found);
    if (kept)
        glint_found_keep(workspace, triangle, 0, sizeof *kept);
    return found;
}

/* Is a part hidden by what other objects have drawn? Most that are not show at their first pixel. Of deep triangles
 * what rounding takes below 0 counts as near: they may be drawn in vain. */
static GLINT_NOINLINE int is_hidden(const glint_frame *frame, const glint_workspace *workspace,
                                    const glint_part *part) {
    const uint32_t left = part->spans[part->top].left;
    const uint32_t z = glint_first_row(part, &part->depth) + (uint32_t)part->depth.dx * left + GLINT_DEPTH_BIAS;
    return z >> 15 <= workspace->depth[(part->top << frame->tile_shift_x) + left] && !workspace->drawn &&
           !glint_is_visible(frame, workspace, part);
}

void glint_draw_lit(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                    const glint_triangle *triangle, const glint_part *part) {
    const glint_vertex *const *v = triangle->corners;
    const int16_t *const front[3] = {v[0]->attribute, v[1]->attribute, v[2]->attribute};
    const int16_t *const *const colour = triangle->back ? triangle->extra : front;
    const glint_format *const format = frame->config.format;
    lit_colours own;
    if (!GLINT_SMALL && draw != frame->draws && is_hidden(frame, workspace, part))
        return;
    const lit_colours *const lit = find_lit(frame, workspace, triangle, part, colour, &own);
    if (lit->how == FITS_NOTHING) {
        draw_fragments(frame, workspace, draw, triangle, part, colour, resolve);
        return;
    }
    if (!GLINT_SMALL && format->draw_channels && !frame->config.gamma) {
        const glint_spans spans = glint_spans_of(frame, workspace, part);
        format->draw_channels(&spans, lit->channels, lit->how == FITS_QUADRATICS);
    } else {
        const colour_source from = {
            .to = {frame, workspace, part, 0, 0, 0}, .draw_run = draw_channel_run, .channels = lit->channels};
        draw_runs(&from);
    }
    if (workspace->drawn)
        glint_count(workspace, GLINT_KERNEL_CHANNELS, glint_covered_by(part));
}
