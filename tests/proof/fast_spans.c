/* SPDX-License-Identifier: MIT */
/* Kernels of fast lighting. */
#include "proof.h"

#include "../../src/fast/fast_draw.h"
#include "lit.h"
#include "spans.h"

/*@ requires \valid_read(g) && \valid_read(planes);
    assigns \result \from *g, *planes; */
static inline int glint_square_fits(const glint_gradients *g, const glint_fast_planes *planes);

/* Stands on glint_square_fits, which no steeper slopes pass: none has more bits than their OR. Suite `reads`, under
 * UBSan. */
/*@ requires \valid_read(x) && \valid_read(y);
    assigns \result \from *x, *y; */
static inline glint_quadratic glint_square_begin(const glint_plane *x, const glint_plane *y);

/*
 * Every span in two rows of a tile 8 pixels wide, any planes.
 * @unreached 6 words that are made pixels of before a part ends: two rows are not enough for that
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 46
 */
PROOF(glint_draw_constant) {
    const glint_fast_spans spans = any_fast_part();
    FOR_SPANS() {
        glint_draw_constant(&spans, ANY_UNSIGNED(0, UINT_MAX), ANY_565);
        glint_draw_constant(&spans, ANY_UNSIGNED(0, UINT_MAX), GLINT_STORES_SPREAD);
    }
}

/*
 * The same, gated and not.
 * @alarms 2 N.L at a pixel is within its table's 272 entries: suite `reads` looks at every pixel of half a million
 * triangles
 * @unreached 6 words that are made pixels of before a part ends: two rows are not enough for that
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 46
 */
PROOF(glint_draw_diffuse) {
    const glint_fast_spans spans = any_fast_part();
    FOR_SPANS() {
        glint_draw_diffuse(&spans, &fast, &planes.cosine, ANY(0, 1), ANY_565);
        glint_draw_diffuse(&spans, &fast, &planes.cosine, ANY(0, 1), GLINT_STORES_SPREAD);
    }
}

/*
 * The same; every squared deviation.
 * @alarms 4 N.L at a pixel is within its tables' 272 entries, and a squared deviation not below 0: suite `reads` looks
 * at every pixel of half a million triangles
 * @unreached 7 words that are made pixels of before a part ends: two rows are not enough for that; and a sum of
 * words that are not clamped
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 46
 */
PROOF(glint_draw_highlight) {
    const glint_fast_spans spans = any_fast_part();
    FOR_SPANS() {
        glint_draw_highlight(&spans, &fast, &planes, ANY_565);
        glint_draw_highlight(&spans, &fast, &planes, GLINT_STORES_SPREAD);
    }
}

/* Any slopes, narrow or wide. */
PROOF(glint_square_fits) {
    glint_gradients g;
    g.reciprocal = ANY(0, 1 << 16);
    any_plane(&planes.x);
    any_plane(&planes.y);
    glint_square_fits(&g, &planes);
}

/*
 * The same, stepped.
 * @contract glint_square_begin
 * @alarms 4 N.L at a pixel is within its tables' 272 entries, and a squared deviation not below 0: suite `reads` looks
 * at every pixel of half a million triangles
 * @unreached 7 words that are made pixels of before a part ends: two rows are not enough for that; and a sum of
 * words that are not clamped
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 46
 */
PROOF(glint_draw_stepped) {
    const glint_fast_spans spans = any_fast_part();
    FOR_SPANS() {
        glint_draw_stepped(&spans, &fast, &planes, ANY_565);
        glint_draw_stepped(&spans, &fast, &planes, GLINT_STORES_SPREAD);
    }
}

/*
 * Any spans in two rows of a tile 8 pixels wide, any planes, any area.
 * @contract glint_fast_word glint_square_fits glint_square_begin
 * @unreached 2 colours of words that are stored, and of those that are not clamped
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0
 */
PROOF(glint_draw_without_tables) {
    const glint_fast_spans spans = any_fast_part();
    static glint_shading shading;
    static glint_draw draw;
    static glint_triangle triangle;
    glint_frame frame = *spans.frame;
    glint_workspace workspace = *spans.workspace;
    frame.tile_shift_x = (uint8_t)spans.of.shift;
    draw.shading = &shading;
    triangle.area = ANY(1, INT32_MAX);
    workspace.depth = spans.of.depth;
    workspace.pixels = spans.of.pixels;
    for (int row = 0; row < 2; row++) {
        part.spans[row].left = (uint8_t)ANY(0, WIDTH);
        part.spans[row].right = (uint8_t)ANY(0, WIDTH);
    }
    glint_draw_without_tables(&frame, &workspace, &draw, &triangle, &part, &planes, GLINT_FAST_GATED, ANY_565);
    glint_draw_without_tables(&frame, &workspace, &draw, &triangle, &part, &planes, GLINT_FAST_GATED,
                              GLINT_STORES_SPREAD);
    glint_draw_without_tables(&frame, &workspace, &draw, &triangle, &part, &planes, GLINT_FAST_SPECULAR, ANY_565);
    glint_draw_without_tables(&frame, &workspace, &draw, &triangle, &part, &planes, GLINT_FAST_SPECULAR,
                              GLINT_STORES_SPREAD);
}
