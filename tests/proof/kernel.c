/* SPDX-License-Identifier: MIT */
/* From spans to pixels: runs, rows of colours, and what triangles begin with. */
#include "proof.h"

#include "../../src/kernel.c"
#include "lit.h"
#include "pixels.h"
#include "plane.h"

/*
 * Not proven: glint_draw_any, glint_draw_facet: they hand on what draw_fragments and draw_even are proven for. The
 * image tests under ASan.
 */

/* Stands on find_runs, whose runs lie in their span, and draw_run, which fills no more than a run. The image tests
 * under ASan. */
/*@ requires \valid_read(frame) && \valid_read(workspace) && \valid_read(from) && \valid_read(part);
    requires \initialized(&from->find) && \initialized(&from->is_deep);
    assigns \result \from indirect: *frame, indirect: *workspace, indirect: *from, indirect: *part; */
static uint32_t draw_runs(const glint_frame *frame, glint_workspace *workspace, const source *from,
                          const glint_part *part);

/*@ requires \valid_read(frame) && \valid_read(workspace) && \valid_read(draw) && \valid_read(triangle);
    requires \valid_read(part) && \valid_read(main + (0 .. 2));
    assigns \nothing; */
static void draw_fragments(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part, const int16_t *const main[3],
                           int is_negated, shader *shade);

#define WIDTH 8

/* ---- Runs ---- */

static uint16_t depths[WIDTH];
static run runs[(WIDTH + 1) / 2];

/* Runs follow each other in a span, with a pixel at least between two. */
static void check_runs(const run *found, uint32_t count, glint_span span) {
    uint32_t from = span.left;
    for (uint32_t i = 0; i < count; i++) {
        /*@ assert from <= found[i].first < found[i].end <= span.right; */
        from = found[i].end + 1u;
    }
}

/* Every span of a row of 8 pixels, of which any are hidden; 1/w of a triangle that lies in between. */
#define FOR_ROWS(span)                              \
    FOR_PARTS(left, 0, WIDTH)                       \
    FOR_PARTS(right, left, WIDTH)                   \
    FOR_PARTS(hidden, 0, (1 << (right - left)) - 1) \
    for (const glint_span *span = any_row(left, right, hidden); span; span = 0)

static const glint_span *any_row(int left, int right, int hidden) {
    static glint_span span;
    span = (glint_span){(uint8_t)left, (uint8_t)right};
    for (int i = left; i < right; i++)
        depths[i] = (uint16_t)(hidden >> (i - left) & 1 ? UINT16_MAX : 0);
    return &span;
}

/* Every span of a row of 8 pixels, any of them hidden: no more runs than half of its pixels. */
PROOF(find_runs) {
    FOR_ROWS(span) {
        check_runs(runs, find_runs(depths, *span, ANY_UNSIGNED(1u << 15, 0x7fff7fff), 0, runs), *span);
    }
}

/* The same, and 1/w below 0. @narrowing 1/w is a number with a sign */
PROOF(find_deep_runs) {
    FOR_ROWS(span) {
        check_runs(runs, find_deep_runs(depths, *span, (uint32_t)ANY(INT32_MIN, 0x7fff7fff), 0, runs), *span);
    }
}

/* ---- Rows ---- */

static const uint16_t tables[3][GLINT_GAMMA_ENTRIES];

static void any_place(glint_part *part) {
    any_plane(&part->depth);
    part->x = ANY(-2047, 2047);
    part->y = ANY(-2047, 2047);
    part->window.left = ANY(-(GLINT_SIZE_MAX * 16), GLINT_SIZE_MAX * 16);
    part->window.top = ANY(-(GLINT_SIZE_MAX * 16), GLINT_SIZE_MAX * 16);
}

/*
 * Any planes, 1 to 64 pixels, with output tables and without.
 * @contract glint_finish_colours
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(find_linear) {
    glint_plane channels[3];
    const source from = {.channels = channels};
    glint_frame frame;
    glint_part part;
    for (int c = 0; c < 3; c++)
        any_plane(&channels[c]);
    FOR_PARTS(count, 1, GLINT_TILE_MAX) {
        int32_t row[GLINT_TILE_MAX][3];
        frame.config.gamma = count & 1 ? tables : 0;
        find_linear(&frame, &from, &part, ANY(-2047, 2047 + 64), ANY(-2047, 2047 + 64), (uint32_t)count, row);
        /*@ assert \initialized(&row[0 .. count - 1][0 .. 2]); */
    }
}

/*
 * 1 to 64 pixels of any triangle in any tile, 8 at once.
 * @contract glint_shade glint_channels_of glint_finish_colours
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(find_shaded) {
    static glint_attributes attributes;
    static glint_draw draw;
    glint_frame frame;
    glint_part part;
    any_place(&part);
    frame.config.gamma = 0;
    FOR_PARTS(count, 1, GLINT_TILE_MAX) {
        int32_t row[GLINT_TILE_MAX][3];
        const source from = {
            .shade = glint_shade, .attributes = &attributes, .draw = &draw, .scale = ANY_UNSIGNED(0, 30)};
        find_shaded(&frame, &from, &part, part.x + ANY(0, 63), part.y + ANY(0, 63), (uint32_t)count, row);
        /*@ assert \initialized(&row[0 .. count - 1][0 .. 2]); */
    }
}

/* Fragments anywhere on any screen, planes of any slopes. @contract glint_resolve_colour @unsigned
 * @options -eva-slevel 0 -eva-min-loop-unroll 9 */
PROOF(resolve) {
    glint_frame frame;
    glint_fragments fragments;
    glint_attributes attributes;
    glint_draw draw;
    any_planes(&attributes);
    FOR_PARTS(count, 1, GLINT_FRAGMENTS_MAX) {
        any_run(&frame, &fragments, (uint32_t)count);
        fragments.attributes = &attributes;
        resolve(&frame, &fragments, &draw);
    }
}

/* A row is filled from its first pixel on, and as much of it is stored as the run has. */
static void fill_row(const glint_frame *frame, const source *from, const glint_part *part, int32_t x, int32_t y,
                     uint32_t count, int32_t (*row)[3]) {
    (void)frame, (void)from, (void)part;
    /*@ assert -2047 <= x <= 2047 + 63 && -2047 <= y <= 2047 + 63; */
    for (uint32_t i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            row[i][c] = 0;
}

static void any_store(void *pixels, unsigned shift, uint32_t offset, uint32_t count, const int32_t (*colour)[3]) {
    (void)pixels;
    /*@ assert 0 < count && offset + count <= 8 << shift; */
    /*@ assert \initialized(&colour[0 .. count - 1][0 .. 2]); */
}

/* Every run in each row of a tile of 8 x 8. */
PROOF(draw_run) {
    static const glint_format format = {.store = any_store};
    const source from = {.find = fill_row};
    glint_frame frame;
    glint_part part;
    any_place(&part);
    frame.config.format = &format;
    frame.tile_shift_x = 3;
    FOR_PARTS(y, 0, WIDTH - 1) {
        FOR_PARTS(first, 0, WIDTH - 1) {
            FOR_PARTS(end, first + 1, WIDTH) {
                int32_t row[WIDTH][3];
                glint_workspace workspace = {.row = row};
                const run at = {(uint8_t)first, (uint8_t)end};
                draw_run(&frame, &workspace, &from, &part, at, (uint32_t)y);
            }
        }
    }
}

/* Any rows of any spans. */
PROOF(covered_by) {
    glint_part part;
    FOR_PARTS(bottom, 0, GLINT_TILE_MAX) {
        part.top = ANY_UNSIGNED(0, (uint32_t)bottom);
        part.bottom = (uint32_t)bottom;
        for (int row = 0; row < GLINT_TILE_MAX; row++) {
            part.spans[row].left = (uint8_t)ANY(0, GLINT_TILE_MAX);
            part.spans[row].right = (uint8_t)ANY(part.spans[row].left, GLINT_TILE_MAX);
        }
        covered_by(&part);
    }
}

/* ---- Triangles ---- */

static glint_vertex corners[3];
static int16_t extra[3][3];
static glint_triangle triangle;
static glint_part part_of_all;
static glint_workspace workspace_of_all;

/* Any gradients: EVA keeps the two kinds apart. */
#define ANY_GRADIENTS(to)   \
    do {                    \
        if (ANY(0, 1))      \
            any_wide(to);   \
        else                \
            any_narrow(to); \
    } while (0)

/* Corners of any attributes from `least` on; parts are counted or not. */
static void any_triangle(int16_t least) {
    static glint_drawn drawn[GLINT_KERNELS];
    workspace_of_all.drawn = ANY(0, 1) ? drawn : 0;
    any_place(&part_of_all);
    part_of_all.top = 0;
    part_of_all.bottom = 1;
    part_of_all.spans[0] = (glint_span){0, WIDTH};
    for (int i = 0; i < 3; i++) {
        for (int c = 0; c < 3; c++) {
            corners[i].attribute[c] = (int16_t)ANY(least, 32767);
            extra[i][c] = (int16_t)ANY(0, GLINT_COLOUR_ONE);
        }
        triangle.corners[i] = &corners[i];
        triangle.extra[i] = extra[i];
        corners[i].inverse_w = ANY(64, INT32_MAX);
    }
    triangle.back = ANY(0, 1);
}

/* 1/w of the corners, by the bits of the largest, first or last. */
#define FOR_CORNERS(bits)                                                                                    \
    FOR_PARTS(bits, 7, 31)                                                                                   \
    FOR_PARTS(is_last, 0, 1)                                                                                 \
    if (corners[0].inverse_w = ANY(is_last ? 64 : (int32_t)((1u << bits) / 2), (int32_t)((1u << bits) - 1)), \
        corners[1].inverse_w = ANY(64, (int32_t)((1u << bits) - 1)),                                         \
        corners[2].inverse_w = ANY(is_last ? (int32_t)((1u << bits) / 2) : 64, (int32_t)((1u << bits) - 1)), 1)

/*
 * Corners of any attributes, 1/w by the bits of the largest, first or last; of normals, turned round or not, with
 * colours of their own and without, and of colours.
 * @contract glint_plane_begin draw_runs
 * @unreached 2 leading zeros of 0 and 1
 */
PROOF(draw_fragments) {
    static const glint_evaluation places[2] = {{.lit_at = GLINT_LIT_AT_FRAGMENTS}, {.lit_at = GLINT_LIT_AT_VERTICES}};
    const int16_t *const main[3] = {corners[0].attribute, corners[1].attribute, corners[2].attribute};
    static glint_draw draw;
    static glint_frame frame;
    any_triangle(-32767);
    ANY_GRADIENTS(&part_of_all.gradients);
    FOR_CORNERS(bits) {
        FOR_PARTS(kind, 0, 3) {
            draw.evaluation = &places[kind & 1];
            draw.extra = kind & 2 ? extra : 0;
            draw_fragments(&frame, &workspace_of_all, &draw, &triangle, &part_of_all, main, ANY(0, 1), glint_shade);
        }
    }
}

/* Stands on the most of three, which is no less than the least. */
/*@ requires \valid_read(v + (0 .. 2));
    assigns \result \from indirect: v[0 .. 2];
    admit ensures \result.least <= 65535 && 1 <= \result.change <= 65536; */
static inline glint_w_range glint_find_w_range(const glint_vertex *const v[3]);

/*
 * Colours at corners of any 1/w, any levels. @contract glint_find_w_range
 * @unsigned
 * @alarms 1 the most of three colours is no less than the least: 32767 times 65536 fits. Suite `models`
 */
PROOF(fits_plane) {
    const int16_t *const colour[3] = {extra[0], extra[1], extra[2]};
    any_triangle(0);
    FOR_PARTS(bits, 0, 8) {
        const glint_format format = {.channel = {5, (uint8_t)bits, 5}};
        fits_plane(&triangle, &format, colour);
    }
}

static void any_draw_even(const glint_spans *spans, const int32_t colour[3]) {
    (void)spans;
    /*@ assert \subset(colour[0 .. 2], (CHANNEL_LEAST .. CHANNEL_MOST)); */
}

static void any_draw_channels(const glint_spans *spans, const glint_plane channel[3]) {
    (void)spans;
    /*@ assert \initialized(&channel[0 .. 2]); */
}

/*
 * Colours at any corners, seen from both sides; in formats with loops of their own and without, with output tables and
 * without.
 * @contract glint_plane_begin draw_runs draw_fragments
 * @unreached 2 glint_count where nothing is counted: it is not called
 */
PROOF(glint_draw_lit) {
    static glint_draw draw;
    glint_frame frame;
    frame.tile_shift_x = (uint8_t)ANY(3, 6);
    any_triangle(0);
    ANY_GRADIENTS(&part_of_all.gradients);
    FOR_PARTS(kind, 0, 7) {
        const uint8_t green = kind & 1 ? 6 : 0, red = kind & 1 ? 5 : 0;
        const glint_format format = {.channel = {red, green, red}, .draw_channels = kind & 2 ? any_draw_channels : 0};
        frame.config.format = &format;
        frame.config.gamma = kind & 4 ? tables : 0;
        draw.double_sided = (uint8_t)ANY(0, 1);
        glint_draw_lit(&frame, &workspace_of_all, &draw, &triangle, &part_of_all);
    }
}

/*
 * Any ambient light, in formats with loops of their own and without: a tile's row holds it.
 * @contract glint_channels_of glint_finish_colours draw_runs
 * @unreached 2 glint_count where nothing is counted: it is not called
 */
PROOF(glint_draw_unlit) {
    static glint_draw draw;
    glint_shading shading;
    glint_frame frame;
    int32_t row[GLINT_TILE_MAX][3];
    any_triangle(0);
    for (int c = 0; c < 3; c++)
        shading.ambient[c] = ANY_UNSIGNED(0, 16u << 23);
    draw.shading = &shading;
    workspace_of_all.row = row;
    FOR_PARTS(shift, 3, 6) {
        FOR_PARTS(fused, 0, 1) {
            const glint_format format = {.draw_even = fused ? any_draw_even : 0};
            frame.config.format = &format;
            frame.config.gamma = 0;
            frame.config.tile_width = (uint16_t)(1 << shift);
            frame.tile_shift_x = (uint8_t)shift;
            glint_draw_unlit(&frame, &workspace_of_all, &draw, &triangle, &part_of_all);
        }
    }
}

/* Any corners' 1/w. */
PROOF(glint_is_deep) {
    any_triangle(0);
    glint_is_deep(&triangle);
}
