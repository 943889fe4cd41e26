/* SPDX-License-Identifier: MIT */
/* Kernel: from the spans of a triangle to pixels, by runs of pixels that pass the depth test and a row of colours. */
#include "colour.h"
#include "division.h"
#include "polynomial.h"
#include "spans.h"

/* ---- Triangles ---- */

/* Pixels of a row that are nearer than what was there, from one to before another. */
typedef struct run {
    uint8_t first, end;
} run;

typedef struct source source;

/* Draws a run of row y. */
typedef void drawer(const source *from, run at, uint32_t y);

/* Finds colours of fragments, Q23. */
typedef void shader(const glint_frame *frame, glint_fragments *fragments, const glint_draw *draw);

/* What the colours of a triangle's pixels come from. */
struct source {
    const glint_frame *frame;
    glint_workspace *workspace;
    const glint_part *part;
    drawer *draw_run;
    const glint_quadratic *channels; /* of draw_channel_run */
    shader *shade;                   /* of gather_run */
    const glint_draw *draw;
    int is_deep;
};

/* An attribute of 16 bits over w: below 2^30. */
static int32_t over_w(int32_t attribute, uint32_t w) {
    return attribute * (int32_t)(w >> 16) + glint_shift_right(attribute * (int32_t)(w & 0xffff), 16);
}

/* The shift that brings the largest 1/w of the corners, none 0, to 2^30 .. 2^31. */
static GLINT_INLINE unsigned find_room(const glint_vertex *const v[3]) {
    return glint_leading_zeros((uint32_t)(v[0]->inverse_w | v[1]->inverse_w | v[2]->inverse_w)) - 1;
}

/* Planes of three attributes of 16 bits over w; negated, normals are those of the back. */
static void triple(glint_plane planes[3], const glint_part *part, const int16_t *const attribute[3],
                   const uint32_t w[3], int negated) {
    for (int c = 0; c < 3; c++) {
        int32_t scaled[3];
        for (int i = 0; i < 3; i++)
            scaled[i] = over_w(negated ? -attribute[i][c] : attribute[i][c], w[i]);
        glint_plane_begin(&planes[c], &part->gradients, scaled[0], scaled[1], scaled[2]);
    }
}

/* ---- Rows ---- */

/* Finds the runs of a span, and stores their depth; 1/w is given with GLINT_DEPTH_BIAS. @return how many */
static inline uint32_t find_runs(uint16_t *depth, glint_span span, uint32_t z, uint32_t z_dx, run *runs) {
    uint32_t count = 0, column = span.left;
    while (column < span.right) {
        while (z >> 15 <= depth[column]) {
            z += z_dx;
            if (++column == span.right)
                return count;
        }
        runs[count].first = (uint8_t)column;
        do {
            depth[column] = (uint16_t)(z >> 15);
            z += z_dx;
            column++;
        } while (column < span.right && z >> 15 > depth[column]);
        runs[count++].end = (uint8_t)column;
    }
    return count;
}

/* The same where 1/w may be below 0, as of a deep triangle's planes; and shorter. */
static uint32_t find_deep_runs(uint16_t *depth, glint_span span, uint32_t z, uint32_t z_dx, run *runs) {
    run *next = runs;
    uint32_t end = GLINT_TILE_MAX;
    for (uint32_t column = span.left; column < span.right; column++, z += z_dx) {
        const uint32_t here = (uint32_t)glint_most((int32_t)z, GLINT_DEPTH_BIAS) >> 15;
        if (here <= depth[column])
            continue;
        depth[column] = (uint16_t)here;
        if (column != end)
            (next++)->first = (uint8_t)column;
        end = column + 1;
        next[-1].end = (uint8_t)end;
    }
    return (uint32_t)(next - runs);
}

static void store_run(const source *from, run at, uint32_t y) {
    const glint_frame *frame = from->frame;
    const glint_workspace *workspace = from->workspace;
    frame->config.format->store(workspace->pixels, frame->tile_shift_x, (y << frame->tile_shift_x) + at.first,
                                (uint32_t)at.end - at.first, (const int32_t(*)[3])workspace->row);
}

static void draw_channel_run(const source *from, run at, uint32_t y) {
    const glint_config *config = &from->frame->config;
    const glint_part *part = from->part;
    int32_t(*const row)[3] = from->workspace->row;
    const uint32_t count = (uint32_t)at.end - at.first;
    for (int c = 0; c < 3; c++) {
        const glint_quadratic *q = &from->channels[c];
        glint_stride s = glint_stride_begin(q, part->x + at.first, part->y + (int32_t)y);
        for (uint32_t i = 0; i < count; i++) {
            row[i][c] = (int32_t)s.value;
            glint_stride_next(&s, q);
        }
    }
    if (config->gamma)
        glint_finish_colours(config, row, count);
    store_run(from, at, y);
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

/* Lights the fragments gathered so far, and stores them by runs. */
static void store_fragments(const source *from) {
    const glint_frame *frame = from->frame;
    glint_workspace *workspace = from->workspace;
    const glint_format *format = frame->config.format;
    glint_fragments *fragments = &workspace->gathered->fragments;
    from->shade(frame, fragments, from->draw);
    finish_fragments(frame, fragments);
    for (uint32_t i = 0, end; i < fragments->count; i = end) {
        const uint32_t offset = ((uint32_t)fragments->row[i] << frame->tile_shift_x) + fragments->column[i];
        end = i + 1;
        while (!GLINT_SMALL && end < fragments->count && fragments->row[end] == fragments->row[i] &&
               fragments->column[end] == fragments->column[end - 1] + 1)
            end++;
        format->store(workspace->pixels, frame->tile_shift_x, offset, end - i,
                      (const int32_t(*)[3])(fragments->colour + i));
    }
    fragments->count = 0;
}

/* Gathers the fragments of a run, and lights them whenever there are enough. */
static void gather_run(const source *from, run at, uint32_t y) {
    const glint_part *part = from->part;
    glint_fragments *fragments = &from->workspace->gathered->fragments;
    const uint32_t end = at.end;
    int32_t inverse_w = glint_plane_at(&part->depth, part->x + at.first, part->y + (int32_t)y);
    for (uint32_t column = at.first; column < end; column++) {
        const uint32_t i = fragments->count++;
        fragments->column[i] = (uint8_t)column;
        fragments->row[i] = (uint8_t)y;
        fragments->inverse_w[i] = glint_most(inverse_w, 0); /* rounding may take a deep triangle's plane below */
        inverse_w = glint_add_wrap(inverse_w, part->depth.dx);
        if (i == GLINT_FRAGMENTS_MAX - 1)
            store_fragments(from);
    }
}

/* Draws a part by runs. @return pixels of its spans */
static uint32_t draw_runs(const source *from) {
    const glint_part *part = from->part;
    run runs[(GLINT_TILE_MAX + 1) / 2];
    uint32_t covered = 0;
    for (uint32_t y = part->top; y < part->bottom; y++) {
        const glint_span span = part->spans[y];
        const uint32_t z_dx = (uint32_t)part->depth.dx;
        const uint32_t z =
            (uint32_t)glint_plane_at(&part->depth, part->x + span.left, part->y + (int32_t)y) + GLINT_DEPTH_BIAS;
        uint16_t *const depth = from->workspace->depth + (y << from->frame->tile_shift_x);
        const uint32_t count = GLINT_SMALL || from->is_deep ? find_deep_runs(depth, span, z, z_dx, runs)
                                                            : find_runs(depth, span, z, z_dx, runs);
        covered += (uint32_t)span.right - span.left;
        for (uint32_t i = 0; i < count; i++)
            from->draw_run(from, runs[i], y);
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
        const source from = {frame, workspace, part, .draw_run = store_run, .is_deep = is_deep};
        for (uint32_t i = 0; i < frame->config.tile_width; i++)
            for (int c = 0; c < 3; c++)
                workspace->row[i][c] = colour[0][c];
        draw_runs(&from);
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

/*
 * What a triangle's fragments have in common, and 1/w of its corners with all the bits there are.
 * @return its attributes, to be filled in
 */
static glint_attributes *begin_fragments(glint_workspace *workspace, const glint_triangle *triangle,
                                         const glint_part *part, uint32_t w[3]) {
    glint_gathered *to = workspace->gathered;
    const glint_vertex *const *v = triangle->corners;
    const unsigned up = find_room(v);
    for (int i = 0; i < 3; i++)
        w[i] = (uint32_t)v[i]->inverse_w << up;
    to->fragments.count = 0;
    to->fragments.part = part;
    to->fragments.attributes = &to->attributes;
    to->fragments.scale = up;
    return &to->attributes;
}

/* Draws fragments that are coloured one by one. */
static void draw_fragments(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part, shader *shade) {
    const int is_deep = GLINT_SMALL || glint_is_deep(triangle);
    const source from = {frame, workspace, part, gather_run, .shade = shade, .draw = draw, .is_deep = is_deep};
    const uint32_t covered = draw_runs(&from);
    if (workspace->gathered->fragments.count)
        store_fragments(&from);
    glint_count(workspace, GLINT_KERNEL_GENERAL, covered);
}

void glint_draw_any(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                    const glint_triangle *triangle, const glint_part *part) {
    const glint_vertex *const *v = triangle->corners;
    const int16_t *const normals[3] = {v[0]->attribute, v[1]->attribute, v[2]->attribute};
    uint32_t w[3];
    glint_attributes *attributes = begin_fragments(workspace, triangle, part, w);
    triple(attributes->main, part, normals, w, triangle->back);
    if (draw->extra)
        triple(attributes->extra, part, triangle->extra, w, 0);
    draw_fragments(frame, workspace, draw, triangle, part, glint_shade);
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

/* Draws fragments of which each has the colour of its own place, from those of the corners. */
static void draw_resolved(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                          const glint_triangle *triangle, const glint_part *part, const int16_t *const colour[3]) {
    uint32_t w[3];
    glint_attributes *attributes = begin_fragments(workspace, triangle, part, w);
    triple(attributes->main, part, colour, w, 0);
    draw_fragments(frame, workspace, draw, triangle, part, resolve);
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
        draw_resolved(frame, workspace, draw, triangle, part, colour);
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
        const source from = {frame, workspace, part, .draw_run = draw_channel_run, .channels = channels};
        draw_runs(&from);
    }
    if (workspace->drawn)
        glint_count(workspace, GLINT_KERNEL_CHANNELS, covered_by(part));
}
