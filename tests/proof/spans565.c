/* SPDX-License-Identifier: MIT */
/* Kernels of fast lighting. */
#include "proof.h"

#include "../../src/spans565.h"
#include "lit.h"
#include "spans.h"

/*
 * Every span in two rows of a tile 8 pixels wide, any planes.
 * @unreached 5 what ARMv6-M does
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
 * @unreached 5 what ARMv6-M does
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
 * @unreached 5 what ARMv6-M does
 * @alarms 3 N.L at a pixel is within its tables' 272 entries, and a squared deviation not below 0: suite `reads` looks
 * at every pixel of half a million triangles
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
