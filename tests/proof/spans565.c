/* SPDX-License-Identifier: MIT */
/* Kernels of fast lighting. */
#include "proof.h"

#include "../../src/spans565.h"
#include "lit.h"
#include "pixels.h"

/*
 * Not proven: glint_deviation_begin: shifts and sums bounded by how far fits() lets a triangle turn. Suite `reads`.
 */
/*
 * Not proven: glint_draw_quadratic, glint_quadratic_begin, glint_interpolate_begin: coefficients bounded by limits of
 * turn, extent and depth. Suites `compare`, `highlights`, and `budget` and `drops` with random scenes, under ASan and
 * UBSan.
 */

#define WIDTH 8

/* Depths and pixels of two rows, side by side as a workspace has them; the tables; a part. */
static uint16_t tile[2 * 2 * WIDTH];
static uint32_t words[GLINT_DIFFUSE_ENTRIES], highlight[1024];
static uint16_t packed[GLINT_DIFFUSE_ENTRIES];
static glint_deviation deviation;
static glint_part part;
static glint_deviation_planes planes;

static glint_spans any_part(void) {
    const glint_spans spans = {&part, tile, (uint8_t *)(tile + 2 * WIDTH), 3};
    Frama_C_make_unknown((char *)tile, sizeof tile);
    Frama_C_make_unknown((char *)words, sizeof words);
    Frama_C_make_unknown((char *)highlight, sizeof highlight);
    Frama_C_make_unknown((char *)packed, sizeof packed);
    any_plane(&part.depth);
    any_plane(&planes.cosine);
    any_plane(&planes.x);
    any_plane(&planes.y);
    part.x = ANY(-2047, 2047);
    part.y = ANY(-2047, 2047);
    deviation.diffuse = words;
    deviation.specular = highlight;
    deviation.diffuse_pixel = packed;
    deviation.specular_end = ANY_UNSIGNED(1, 1024) << 15;
    deviation.ambient = (uint16_t)ANY(0, 0xffff);
    part.top = 0;
    part.bottom = 2;
    return spans;
}

/*
 * Every span of a row, and every column at which the row before it may have ended: what a loop carries from one to the
 * next.
 */
#define FOR_SPANS()                                                                            \
    FOR_PARTS(end, 0, WIDTH)                                                                   \
    FOR_PARTS(left, 0, WIDTH)                                                                  \
    FOR_PARTS(right, left, WIDTH)                                                              \
    if (part.spans[0].left = (uint8_t)(end ? end - 1 : 0), part.spans[0].right = (uint8_t)end, \
        part.spans[1].left = (uint8_t)left, part.spans[1].right = (uint8_t)right, 1)

/*
 * Every span in two rows of a tile 8 pixels wide, any planes.
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 46
 */
PROOF(glint_draw_constant) {
    const glint_spans spans = any_part();
    FOR_SPANS() {
        glint_draw_constant(&spans, ANY_UNSIGNED(0, UINT_MAX), ANY(0, 1));
    }
}

/*
 * The same, gated and not.
 * @alarms 2 N.L at a pixel is within its table's 272 entries: suite `reads` looks at every pixel of half a million
 * triangles
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 46
 */
PROOF(glint_draw_diffuse) {
    const glint_spans spans = any_part();
    FOR_SPANS() {
        glint_draw_diffuse(&spans, &deviation, &planes.cosine, ANY(0, 1), ANY(0, 1));
    }
}

/*
 * The same; every squared deviation.
 * @alarms 1 N.L at a pixel is within its table's 272 entries: suite `reads` looks at every pixel of half a million
 * triangles
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 46
 */
PROOF(glint_draw_highlight) {
    const glint_spans spans = any_part();
    FOR_SPANS() {
        glint_draw_highlight(&spans, &deviation, &planes, ANY(0, 1));
    }
}

/*
 * Any spans in two rows of a tile 8 pixels wide, any planes.
 * @contract glint_deviation_pixel
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0
 */
PROOF(glint_draw_without_tables) {
    const glint_spans spans = any_part();
    glint_shading shading;
    for (int row = 0; row < 2; row++) {
        part.spans[row].left = (uint8_t)ANY(0, WIDTH);
        part.spans[row].right = (uint8_t)ANY(0, WIDTH);
    }
    glint_draw_without_tables(&spans, &shading, &planes, GLINT_DEVIATION_GATED, ANY(0, 1));
    glint_draw_without_tables(&spans, &shading, &planes, GLINT_DEVIATION_SPECULAR, ANY(0, 1));
}
