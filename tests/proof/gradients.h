/* SPDX-License-Identifier: MIT */
/**
 * @file gradients.h
 * What set-up leaves of a triangle, narrow, wide and slender: gradients_begin is proven to.
 */
#ifndef GLINT_PROOF_GRADIENTS_H
#define GLINT_PROOF_GRADIENTS_H

#include "../../src/math/division.h"
#include "../../src/raster/raster.h"
#include "proof.h"

/*@ requires 0x8000 <= x <= 0x10000;
    assigns \result \from x;
    ensures 0x8000 <= \result <= 0x10000; */
static inline int32_t glint_reciprocal16_by_division(uint32_t x);

#define NARROW(g)                                                                                \
    (0x8000 <= (g)->reciprocal <= 0x10000 && 0 <= (g)->shift <= 30 && -1024 <= (g)->x1 < 1024 && \
     -1024 <= (g)->y1 < 1024 && -1024 <= (g)->x2 < 1024 && -1024 <= (g)->y2 < 1024)

#define WIDE(g)                                                                                \
    ((g)->reciprocal == 0 && -6 <= (g)->shift <= 27 && -0x40000000 <= (g)->x1 <= 0x40000000 && \
     -0x40000000 <= (g)->y1 <= 0x40000000 && -0x40000000 <= (g)->x2 <= 0x40000000 &&           \
     -0x40000000 <= (g)->y2 <= 0x40000000)

/* Those too are wide, of sides with 16 bits. */
#define SLENDER(g)                                                                                            \
    ((g)->reciprocal == 0 && (g)->shift == 0 && -0x8000 <= (g)->x1 < 0x8000 && -0x8000 <= (g)->y1 < 0x8000 && \
     -0x8000 <= (g)->x2 < 0x8000 && -0x8000 <= (g)->y2 < 0x8000)

static void any_anchor(glint_gradients *g) {
    g->to_center_x = ANY(-7, 8);
    g->to_center_y = ANY(-7, 8);
}

static void any_narrow(glint_gradients *g) {
    g->x1 = ANY(-1024, 1023);
    g->y1 = ANY(-1024, 1023);
    g->x2 = ANY(-1024, 1023);
    g->y2 = ANY(-1024, 1023);
    g->reciprocal = ANY(1 << 15, 1 << 16);
    g->shift = ANY(0, 30);
    g->reach = ANY_UNSIGNED(0, 1023);
    any_anchor(g);
}

static void any_wide(glint_gradients *g) {
    const int32_t most = 1 << 30;
    g->x1 = ANY(-most, most);
    g->y1 = ANY(-most, most);
    g->x2 = ANY(-most, most);
    g->y2 = ANY(-most, most);
    g->reciprocal = 0;
    g->shift = ANY(-6, 27);
    g->reach = ANY_UNSIGNED(0, 0x7fff);
    any_anchor(g);
}

static void any_slender(glint_gradients *g) {
    g->x1 = ANY(-0x8000, 0x7fff);
    g->y1 = ANY(-0x8000, 0x7fff);
    g->x2 = ANY(-0x8000, 0x7fff);
    g->y2 = ANY(-0x8000, 0x7fff);
    g->reciprocal = 0;
    g->shift = 0;
    g->reach = ANY_UNSIGNED(0, 0x7fff);
    any_anchor(g);
}

#endif
