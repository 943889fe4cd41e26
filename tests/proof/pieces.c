/* SPDX-License-Identifier: MIT */
/* Pieces of a triangle. */
#include "proof.h"

#include "../../src/math/tables.c"
#include "../../src/nodes/pieces.c"
#include "plane.h"
#include "ranges.h"

/*
 * Not proven: glint_ring_find, glint_ring_begin, glint_ring_keep, begin_ring, at_place, find_whole, find_piece:
 * addresses in the bytes that a pass leaves free, by counts of bytes, unsigned. Suite `nodes`, many sizes of them,
 * and fuzzing, under ASan and UBSan.
 */
/*
 * Not proven: glint_draw_pieces, draw_piece, light_piece, cut_spans: they walk a triangle's pieces, rows and nodes,
 * whose numbers number_of is proven to keep, and call what is proven. Suite `nodes` under ASan and UBSan, and fuzzing.
 */

static glint_vertex vertices[3];
static int16_t colours[3][3];
static glint_triangle triangle;
static glint_frame frame;
static glint_view view;
static glint_draw draw;

/* A triangle that is not deep. */
static void any_triangle(void) {
    for (int i = 0; i < 3; i++) {
        for (int c = 0; c < 3; c++) {
            vertices[i].attribute[c] = ANY_COMPONENT;
            colours[i][c] = (int16_t)ANY(0, INT16_MAX);
        }
        triangle.extra[i] = colours[i];
        vertices[i].x = (int16_t)ANY(INT16_MIN, INT16_MAX);
        vertices[i].y = (int16_t)ANY(INT16_MIN, INT16_MAX);
        vertices[i].inverse_w = ANY(64, INT32_MAX);
        triangle.corners[i] = &vertices[i];
    }
}

/* Every node. */
PROOF(number_of) {
    FOR_PARTS(k, 0, PLACES - 1) {
        FOR_PARTS(j, 0, PLACES - 1 - k) {
            const uint32_t number = number_of((int)j, (int)k);
            /*@ assert number < 15; */
        }
    }
}

/*
 * Every node of any triangle that is not deep: 1/w of its corners is 2^-10 of the largest or more.
 * @contract glint_unit_inline
 * @alarms 1 a weighted mean is no more than the largest; suite `nodes` under UBSan
 */
PROOF(gather_piece) {
    glint_fragments fragments;
    pieces p;
    any_triangle();
    any_view(&view);
    frame.view = &view;
    frame.config.width = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame.config.height = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    draw.extra = (const int16_t(*)[3])colours;
    p.frame = &frame;
    p.draw = &draw;
    p.triangle = &triangle;
    for (int i = 0; i < 3; i++)
        p.w[i] = ANY(32, INT16_MAX);
    FOR_PARTS(k, 0, PLACES - 1) {
        FOR_PARTS(j, 0, PLACES - 1 - k) {
            draw.extra = ANY(0, 1) ? (const int16_t(*)[3])colours : 0;
            fragments.count = 0;
            gather_piece(&p, (int)j, (int)k, &fragments);
        }
    }
}

/* Any triangle, by the bits of its largest 1/w. @unreached 3 leading zeros of 0, and a number of no bits */
PROOF(begin_pieces) {
    glint_shape shape;
    pieces p;
    any_triangle();
    p.triangle = &triangle;
    FOR_PARTS(bits, 7, 31) {
        for (int i = 0; i < 3; i++)
            vertices[i].inverse_w = (int32_t)(i ? ANY_UNSIGNED(64, 0xffffffffu >> (32 - bits)) : ANY_OF_BITS(bits));
        begin_pieces(&p, &shape);
    }
}

/*@ requires \valid_read(barycentric) && \valid_read(form) && \valid(q);
    requires -0x18000 < form->d1 + form->d2 < 0x18000 && -0x18000 < form->d1 - form->d2 < 0x18000;
    requires -0x4000 < form->b1 < 0x4000 && -0x4000 < form->b2 < 0x4000 && -0x8000 < form->both < 0x8000;
    assigns *q \from *barycentric, *form;
    ensures \initialized(q); */
void glint_form_begin(glint_quadratic *q, const glint_barycentric *barycentric, const glint_form *form);

/*@ requires \valid(barycentric) && \valid_read(gradients) && 2 <= unit <= 16;
    assigns *barycentric \from *gradients, unit;
    ensures \initialized(barycentric); */
void glint_barycentric_begin(glint_barycentric *barycentric, const glint_gradients *gradients, int32_t unit);

/*
 * Nodes of 15 bits and a sign, every piece.
 * @contract glint_form_begin glint_barycentric_begin
 * @alarms 2 is_beyond_piece has just been asked of these numbers
 */
PROOF(fit_piece) {
    static const int32_t kinds[4][3] = {{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {-1, 1, 1}};
    glint_part part;
    glint_barycentric barycentric;
    glint_shape shape;
    glint_quadratic to;
    int32_t n[6];
    shape.part = &part;
    shape.barycentric = &barycentric;
    barycentric.unit = ANY_UNSIGNED(0, 16);
    for (int i = 0; i < 6; i++)
        n[i] = ANY(INT16_MIN, INT16_MAX);
    FOR_PARTS(kind, 0, 3) {
        shape.turned = kinds[kind][0];
        shape.first[0] = kinds[kind][1];
        shape.first[1] = kinds[kind][2];
        fit_piece(&shape, n, ANY(12, 16), &to);
    }
}
