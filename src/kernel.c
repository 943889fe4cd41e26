/* SPDX-License-Identifier: MIT */
/* Kernel: from the spans of a triangle to pixels, by runs of pixels that pass the depth test and a row of colours. */
#include "colour.h"
#include "spans.h"

/* ---- Triangles ---- */

typedef struct source source;

/* Finds the colours of a run of a row, which begins so far from the triangle's anchor, and finishes them. */
typedef void finder(const glint_frame *frame, const source *from, const glint_part *part, int32_t x, int32_t y,
                    uint32_t count, int32_t (*row)[3]);

/* Finds colours of fragments. */
typedef void shader(const glint_frame *frame, glint_fragments *fragments, const glint_draw *draw);

/* What the colours of a triangle's pixels come from. */
struct source {
    finder *find;                       /* null where the row holds the one colour of all */
    const glint_plane *channels;        /* of find_linear */
    shader *shade;                      /* of find_shaded */
    const glint_attributes *attributes; /* of fragments */
    const glint_draw *draw;
    uint32_t scale; /* of the attributes: over w 2^scale */
    int is_deep;
};

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
static GLINT_NOINLINE uint32_t find_deep_runs(uint16_t *depth, glint_span span, uint32_t z, uint32_t z_dx, run *runs) {
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

static void find_linear(const glint_frame *frame, const source *from, const glint_part *part, int32_t x, int32_t y,
                        uint32_t count, int32_t (*row)[3]) {
    const glint_plane *const channels = from->channels;
    (void)part;
    int32_t red = glint_plane_at(&channels[0], x, y), green = glint_plane_at(&channels[1], x, y),
            blue = glint_plane_at(&channels[2], x, y);
    for (uint32_t i = 0; i < count; i++) {
        row[i][0] = red;
        row[i][1] = green;
        row[i][2] = blue;
        red = glint_add_wrap(red, channels[0].dx);
        green = glint_add_wrap(green, channels[1].dx);
        blue = glint_add_wrap(blue, channels[2].dx);
    }
    if (frame->config.gamma)
        glint_finish_colours(&frame->config, row, count);
}

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

/* Fragments, a few at a time. */
static void find_shaded(const glint_frame *frame, const source *from, const glint_part *part, int32_t x, int32_t y,
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
        from->shade(frame, &fragments, from->draw);
        for (uint32_t i = 0; i < fragments.count; i++)
            glint_channels_of(fragments.colour[i], row[done + i]);
    }
    glint_finish_colours(&frame->config, row, count);
}

static void draw_run(const glint_frame *frame, glint_workspace *workspace, const source *from, const glint_part *part,
                     run at, uint32_t y) {
    const uint32_t count = (uint32_t)at.end - at.first;
    const int32_t x = part->x + at.first, down = part->y + (int32_t)y;
    if (from->find)
        from->find(frame, from, part, x, down, count, workspace->row);
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
        const uint32_t count = GLINT_SMALL || from->is_deep ? find_deep_runs(depth, span, z, z_dx, runs)
                                                            : find_runs(depth, span, z, z_dx, runs);
        covered += (uint32_t)span.right - span.left;
        for (uint32_t i = 0; i < count; i++)
            draw_run(frame, workspace, from, part, runs[i], y);
    }
    return covered;
}

/* ---- Kernels ---- */

/* Is a triangle deep? Built for size, all are drawn as if they were. */
static int is_deep(const glint_triangle *triangle) {
    return GLINT_SMALL || glint_is_deep(triangle);
}

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
    const int deep = is_deep(triangle);
    glint_finish_colours(&frame->config, colour, 1);
    if (frame->config.format->draw_even && !deep) {
        const glint_spans spans = glint_spans_of(frame, workspace, part);
        frame->config.format->draw_even(&spans, colour[0]);
    } else {
        const source from = {.is_deep = deep};
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

/* Draws fragments whose colours come from attributes that are interpolated over w. */
static void draw_fragments(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part, const int16_t *const main[3],
                           int is_negated, shader *shade) {
    glint_attributes attributes;
    uint32_t w[3];
    const source from = {.find = find_shaded,
                         .shade = shade,
                         .attributes = &attributes,
                         .draw = draw,
                         .scale = scale_inverse_w(triangle->corners, w),
                         .is_deep = is_deep(triangle)};
    triple(attributes.main, &part->gradients, main, w, is_negated);
    if (draw->extra && draw->evaluation->lit_at == GLINT_LIT_AT_FRAGMENTS)
        triple(attributes.extra, &part->gradients, triangle->extra, w, 0);
    glint_count(workspace, GLINT_KERNEL_GENERAL, draw_runs(frame, workspace, &from, part));
}

void glint_draw_any(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                    const glint_triangle *triangle, const glint_part *part) {
    const glint_vertex *const *v = triangle->corners;
    const int16_t *const normals[3] = {v[0]->attribute, v[1]->attribute, v[2]->attribute};
    draw_fragments(frame, workspace, draw, triangle, part, normals, triangle->back, glint_shade);
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
        draw_fragments(frame, workspace, draw, triangle, part, colour, 0, resolve);
        return;
    }
    const int is_shown = !frame->config.gamma; /* as it is: what goes through tables is finished later */
    for (int c = 0; c < 3; c++) {
        int32_t a[3];
        for (int i = 0; i < 3; i++)
            a[i] = glint_to_levels(glint_channel_of(colour[i][c]), is_shown ? format->channel[c] : 0);
        glint_plane_begin(&channels[c], &part->gradients, a[0], a[1], a[2]);
    }
    if (format->draw_channels && is_shown) {
        const glint_spans spans = glint_spans_of(frame, workspace, part);
        format->draw_channels(&spans, channels);
    } else {
        const source from = {.find = find_linear, .channels = channels};
        draw_runs(frame, workspace, &from, part);
    }
    if (workspace->drawn)
        glint_count(workspace, GLINT_KERNEL_CHANNELS, covered_by(part));
}
