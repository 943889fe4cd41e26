/* SPDX-License-Identifier: MIT */
/* Kernel: from the spans of a triangle to pixels, by runs of pixels that pass the depth test and a row of colours. */
#include "colour.h"
#include "division.h"
#include "polynomial.h"
#include "spans.h"
#include "terms.h"

/* ---- Triangles ---- */

typedef struct source source;

/* Draws runs of a part. */
typedef void drawer(const glint_frame *frame, glint_workspace *workspace, const source *from, const glint_part *part,
                    const glint_run *runs, uint32_t count);

/* What the colours of a triangle's pixels come from. */
struct source {
    drawer *draw;
    const glint_quadratic *channels; /* of draw_channels */
    const glint_terms *terms;        /* of draw_terms, and its polynomials */
    const glint_descent *polynomials;
    const glint_draw *draws;
    const glint_triangle *triangle;
    int is_deep;
};

/* ---- Rows ---- */

/* Finds the runs of a span, and stores their depth; 1/w is given with GLINT_DEPTH_BIAS. @return where the next goes */
static inline glint_run *find_runs(uint16_t *depth, glint_span span, uint32_t z, uint32_t z_dx, uint32_t y,
                                   glint_run *run) {
    uint32_t column = span.left;
    while (column < span.right) {
        while (z >> 15 <= depth[column]) {
            z += z_dx;
            if (++column == span.right)
                return run;
        }
        const uint32_t first = column;
        do {
            depth[column] = (uint16_t)(z >> 15);
            z += z_dx;
            column++;
        } while (column < span.right && z >> 15 > depth[column]);
        *run++ = (glint_run){(uint8_t)first, (uint8_t)y, (uint8_t)(column - first)};
    }
    return run;
}

/* The same where 1/w may be below 0, as of a deep triangle's planes; and shorter. */
static glint_run *find_deep_runs(uint16_t *depth, glint_span span, uint32_t z, uint32_t z_dx, uint32_t y,
                                 glint_run *run) {
    uint32_t end = GLINT_TILE_MAX;
    for (uint32_t column = span.left; column < span.right; column++, z += z_dx) {
        const uint32_t here = (uint32_t)glint_most((int32_t)z, GLINT_DEPTH_BIAS) >> 15;
        if (here <= depth[column])
            continue;
        depth[column] = (uint16_t)here;
        if (column != end)
            *run++ = (glint_run){(uint8_t)column, (uint8_t)y, 0};
        end = column + 1;
        run[-1].count++;
    }
    return run;
}

/* Stores colours of one after the other. */
static void store_runs(const glint_frame *frame, glint_workspace *workspace, const source *from, const glint_part *part,
                       const glint_run *runs, uint32_t count) {
    (void)from;
    (void)part;
    for (const glint_run *const end = runs + count; runs != end; runs++)
        frame->config.format->store(workspace->pixels, frame->tile_shift_x,
                                    ((uint32_t)runs->y << frame->tile_shift_x) + runs->x, runs->count,
                                    (const int32_t(*)[3])workspace->row);
}

static void draw_channels(const glint_frame *frame, glint_workspace *workspace, const source *from,
                          const glint_part *part, const glint_run *runs, uint32_t count) {
    for (const glint_run *const end = runs + count; runs != end; runs++) {
        for (int c = 0; c < 3; c++) {
            const glint_quadratic *q = &from->channels[c];
            glint_stride s = glint_stride_begin(q, part->x + runs->x, part->y + runs->y);
            for (uint32_t i = 0; i < runs->count; i++) {
                workspace->row[i][c] = (int32_t)s.value;
                glint_stride_next(&s, q);
            }
        }
        if (frame->config.gamma)
            glint_finish_colours(&frame->config, workspace->row, runs->count);
        store_runs(frame, workspace, from, part, runs, 1);
    }
}

static void draw_terms(const glint_frame *frame, glint_workspace *workspace, const source *from, const glint_part *part,
                       const glint_run *runs, uint32_t count) {
    glint_terms_draw(frame, workspace, from->terms, from->polynomials, runs, count, 0);
    if (from->terms->margin)
        glint_draw_edges(frame, workspace, from->draws, from->triangle, part, from->terms, from->polynomials, runs,
                         count);
}

/* Most runs of a row, and of two. */
#define ROW_RUNS ((GLINT_TILE_MAX + 1) / 2)

/* Draws a part by runs, of as many rows at once as two rows of a tile have pixels. @return pixels of its spans */
static uint32_t draw_runs(const glint_frame *frame, glint_workspace *workspace, const source *from,
                          const glint_part *part) {
    glint_run runs[2 * ROW_RUNS], *next = runs;
    uint32_t covered = 0, pixels = 0;
    for (uint32_t y = part->top; y < part->bottom; y++) {
        const glint_span span = part->spans[y];
        const uint32_t z_dx = (uint32_t)part->depth.dx, width = (uint32_t)span.right - span.left;
        const uint32_t z =
            (uint32_t)glint_plane_at(&part->depth, part->x + span.left, part->y + (int32_t)y) + GLINT_DEPTH_BIAS;
        uint16_t *const depth = workspace->depth + (y << frame->tile_shift_x);
        covered += width;
        pixels += width;
        if (pixels > 2 * frame->config.tile_width || next > runs + ROW_RUNS) {
            from->draw(frame, workspace, from, part, runs, (uint32_t)(next - runs));
            next = runs;
            pixels = width;
        }
        next = GLINT_SMALL || from->is_deep ? find_deep_runs(depth, span, z, z_dx, y, next)
                                            : find_runs(depth, span, z, z_dx, y, next);
    }
    if (next != runs)
        from->draw(frame, workspace, from, part, runs, (uint32_t)(next - runs));
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
        const source from = {.draw = store_runs, .is_deep = is_deep};
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

void glint_draw_terms(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, const glint_part *part) {
    glint_terms terms;
    glint_quadratic polynomials[GLINT_POLYNOMIALS_MAX];
    if (!glint_terms_begin(frame, draw, triangle, part, &terms, polynomials)) {
        glint_draw_any(frame, workspace, draw, triangle, part);
        return;
    }
    if (terms.is_plain && !frame->config.gamma && frame->config.format->draw_channels) {
        const glint_spans spans = glint_spans_of(frame, workspace, part);
        frame->config.format->draw_channels(&spans, polynomials, terms.is_curved);
        if (workspace->drawn)
            glint_count(workspace, GLINT_KERNEL_CHANNELS, covered_by(part));
        return;
    }
    glint_descent descents[GLINT_POLYNOMIALS_MAX];
    const source from = {
        .draw = draw_terms, .terms = &terms, .polynomials = descents, .draws = draw, .triangle = triangle};
    for (uint32_t i = 0; i < terms.end; i++)
        glint_descent_begin(&descents[i], &polynomials[i], part->x, part->y);
    glint_count(workspace, GLINT_KERNEL_CHANNELS, draw_runs(frame, workspace, &from, part));
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

/* How a triangle's colours are drawn. */
typedef enum fit { FITS_PLANES, FITS_QUADRATICS, FITS_NOTHING } fit;

/*
 * Where 1/w changes by a factor 1 + r, what is linear over w is at most r / 4 of its corners' difference from a plane,
 * and 0.0485 r^2 from a quadratic through the middles of the edges too; slivers have none.
 */
static fit find_fit(const glint_triangle *triangle, const glint_gradients *g, const glint_format *format,
                    const int16_t *const colour[3]) {
    const glint_w_range w = glint_find_w_range(triangle->corners);
    const uint32_t close = CLOSE >> (format->channel[1] ? format->channel[1] : 8), apart = find_difference(colour);
    if (apart * w.change <= 4 * close * w.least)
        return FITS_PLANES;
    if (16 * w.change > 7 * w.least || glint_slenderness(g, triangle->area) > GLINT_POLYNOMIAL_SLENDER ||
        triangle->area < GLINT_POLYNOMIAL_LEAST_AREA)
        return FITS_NOTHING;
    const uint32_t ratio = (w.change << 12) / w.least; /* w.change is at most 2^15 */
    return apart * (ratio * ratio >> 12) <= (close * 20 << 12) ? FITS_QUADRATICS : FITS_NOTHING;
}

/* Of find_skew, where 1/w changes by at most 7/16. */
#define MOST_SKEW 5898

/* The shift that brings the largest 1/w of the corners, none 0, to 2^30 .. 2^31. */
static inline unsigned find_room(const glint_vertex *const v[3]) {
    return glint_leading_zeros((uint32_t)(v[0]->inverse_w | v[1]->inverse_w | v[2]->inverse_w)) - 1;
}

/*
 * Four times what a colour at the middle of an edge is more than the mean of its ends, over their difference: Q14. With
 * 1/w times 2^up, below 2^31.
 */
static int32_t find_skew(const glint_vertex *a, const glint_vertex *b, unsigned up) {
    const int32_t wa = a->inverse_w << up >> 16, wb = b->inverse_w << up >> 16;
    const int32_t skew = wa == wb ? 0 : (wa - wb) * (1 << 15) / (wa + wb);
    return glint_least(glint_most(skew, -MOST_SKEW), MOST_SKEW);
}

static void begin_planes(glint_quadratic channel[3], const glint_gradients *g, int32_t a[3][3]) {
    for (int c = 0; c < 3; c++) {
        glint_plane plane;
        const int32_t up = 1 << (GLINT_CHANNEL_BITS - 15);
        glint_plane_begin(&plane, g, a[c][0] * up, a[c][1] * up, a[c][2] * up);
        channel[c] = (glint_quadratic){(uint32_t)plane.start, (uint32_t)plane.dx, (uint32_t)plane.dy, 0, 0, 0};
    }
}

static void begin_quadratics(glint_quadratic channel[3], const glint_gradients *g, const glint_vertex *const v[3],
                             int32_t a[3][3]) {
    const unsigned up = find_room(v);
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

void glint_draw_lit(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                    const glint_triangle *triangle, const glint_part *part) {
    const glint_vertex *const *v = triangle->corners;
    const int16_t *const front[3] = {v[0]->attribute, v[1]->attribute, v[2]->attribute};
    const int16_t *const *const colour = triangle->back && draw->double_sided ? triangle->extra : front;
    const glint_format *const format = frame->config.format;
    const int finishes = frame->config.gamma != 0;
    const fit how = glint_is_deep(triangle) ? FITS_NOTHING : find_fit(triangle, &part->gradients, format, colour);
    glint_quadratic channels[3];
    int32_t a[3][3];
    if (how == FITS_NOTHING) {
        glint_draw_fragments(frame, workspace, draw, triangle, part, colour, 0, resolve);
        return;
    }
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 3; i++)
            a[c][i] =
                finishes || !format->channel[c] ? colour[i][c] : colour[i][c] - (colour[i][c] >> format->channel[c]);
    if (how == FITS_PLANES)
        begin_planes(channels, &part->gradients, a);
    else
        begin_quadratics(channels, &part->gradients, v, a);
    for (int c = 0; c < 3 && !finishes; c++)
        channels[c].start += (uint32_t)glint_to_levels(0, format->channel[c]);
    if (format->draw_channels && !finishes) {
        const glint_spans spans = glint_spans_of(frame, workspace, part);
        format->draw_channels(&spans, channels, how == FITS_QUADRATICS);
    } else {
        const source from = {.draw = draw_channels, .channels = channels};
        draw_runs(frame, workspace, &from, part);
    }
    if (workspace->drawn)
        glint_count(workspace, GLINT_KERNEL_CHANNELS, covered_by(part));
}
