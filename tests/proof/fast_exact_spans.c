/* SPDX-License-Identifier: MIT */
/* Kernels of exact lighting. */
#include "proof.h"

#include "../../src/fast/fast_draw.h"
#include "../../src/math/tables.c"
#include "lit.h"
#include "spans.h"

static glint_exact_light light;
static glint_interpolation interpolated;

static void any_quadratic(glint_quadratic *q) {
    Frama_C_make_unknown((char *)q, sizeof *q);
}

static void any_lights_of_triangle(void) {
    any_plane(&light.cosine);
    any_quadratic(&light.square);
    any_quadratic(&light.x);
    any_quadratic(&light.y);
    any_quadratic(&interpolated.cosine);
    any_quadratic(&interpolated.x);
    any_quadratic(&interpolated.y);
    fast.exact.limit = ANY_UNSIGNED(0, UINT_MAX);
    fast.exact.shift = ANY_UNSIGNED(0, 24);
    fast.exact.end = ANY_UNSIGNED(0, 1024) << 20;
}

/*
 * Not proven: glint_draw_curved, glint_draw_square, glint_draw_squares, glint_draw_curved_without_tables,
 * glint_exact_prepare, glint_exact_begin, glint_exact_bend, glint_interpolate_prepare, glint_interpolate_begin,
 * glint_interpolate_highlight: coefficients bounded by limits of turn, extent and depth. Suite `reads` with the
 * infinite viewer; `compare`, `highlights`, and `budget` and `drops` with random scenes, under ASan and UBSan.
 */

/*
 * Every span in two rows of a tile 8 pixels wide; any quadratics, gated and not.
 * @alarms 2 N.L at a pixel is within its table's 272 entries: suite `reads` looks at every pixel of half a million
 * triangles
 * @unreached 6 words that are made pixels of before a part ends: two rows are not enough for that
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 46
 */
PROOF(glint_draw_interpolated_diffuse) {
    const glint_fast_spans spans = any_fast_part();
    any_lights_of_triangle();
    FOR_SPANS() {
        glint_draw_interpolated_diffuse(&spans, &fast, &interpolated, ANY(0, 1), ANY_565);
        glint_draw_interpolated_diffuse(&spans, &fast, &interpolated, ANY(0, 1), GLINT_STORES_SPREAD);
    }
}

/*
 * The same, clamped and not.
 * @alarms 4 N.L at a pixel is within its tables' 272 entries, and a squared deviation not below 0: suite `reads` looks
 * at every pixel of half a million triangles
 * @unreached 6 words that are made pixels of before a part ends: two rows are not enough for that
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 46
 */
PROOF(glint_draw_interpolated_specular) {
    const glint_fast_spans spans = any_fast_part();
    any_lights_of_triangle();
    FOR_SPANS() {
        glint_draw_interpolated_specular(&spans, &fast, &interpolated, ANY(0, 1), ANY_565);
        glint_draw_interpolated_specular(&spans, &fast, &interpolated, ANY(0, 1), GLINT_STORES_SPREAD);
    }
}

/*
 * The same of exact lighting.
 * @alarms 3 M.M at a pixel is within its table's 768 entries, and N.L within 272: suite `reads` looks at every
 * pixel of half a million triangles
 * @unreached 6 words that are made pixels of before a part ends: two rows are not enough for that
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 46
 */
PROOF(glint_draw_curved_diffuse) {
    const glint_fast_spans spans = any_fast_part();
    any_lights_of_triangle();
    FOR_SPANS() {
        glint_draw_curved_diffuse(&spans, &fast, &light, ANY_565);
        glint_draw_curved_diffuse(&spans, &fast, &light, GLINT_STORES_SPREAD);
    }
}

/*
 * The same with highlights.
 * @alarms 4 M.M at a pixel is within its table's 768 entries, and N.L within 272 of both of its: suite `reads` looks
 * at every pixel of half a million triangles
 * @unreached 7 words that are made pixels of before a part ends: two rows are not enough for that; and a sum of
 * words that are not clamped
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 46
 */
PROOF(glint_draw_curved_specular) {
    const glint_fast_spans spans = any_fast_part();
    any_lights_of_triangle();
    FOR_SPANS() {
        glint_draw_curved_specular(&spans, &fast, &light, ANY_565);
        glint_draw_curved_specular(&spans, &fast, &light, GLINT_STORES_SPREAD);
    }
}
