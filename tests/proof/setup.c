/* SPDX-License-Identifier: MIT */
/* Set-up of a triangle's planes. */
#include "proof.h"

#include "../../src/raster/setup.c"
#include "contracts.h"
#include "gradients.h"

/* x takes at most n bits and a sign if it is below 2^n either way, and more from there on. */
#define TAKES(n)                                                          \
    ((-1 - x >= (1 << (n)) || x >= (1 << (n)) || \result < (1 << (n))) && \
     ((-1 - x < (1 << (n)) && x < (1 << (n))) || \result >= (1 << (n))))

#define TAKES_4(n) (TAKES(n) && TAKES(n + 1) && TAKES(n + 2) && TAKES(n + 3))

/*@ assigns \result \from x;
    ensures TAKES_4(0) && TAKES_4(4) && TAKES_4(8) && TAKES_4(12);
    ensures TAKES_4(16) && TAKES_4(20) && TAKES_4(24) && TAKES(28) && TAKES(29) && TAKES(30); */
static inline uint32_t glint_magnitude_bits(int32_t x);

/*@ requires \valid(p) && \valid_read(g);
    requires NARROW(g);
    assigns *p \from *g, start, d1, d2;
    ensures \initialized(p); */
static inline void begin_narrow(glint_plane *p, const glint_gradients *g, int32_t start, int32_t d1, int32_t d2);

/*@ requires \valid(p) && \valid_read(g);
    requires WIDE(g);
    assigns *p \from *g, start, d1, d2;
    ensures \initialized(p); */
static inline void begin_wide(glint_plane *p, const glint_gradients *g, int32_t start, int32_t d1, int32_t d2);

/*@ requires \valid(p) && \valid_read(g);
    requires SLENDER(g);
    assigns *p \from *g, start, d1, d2;
    ensures \initialized(p); */
static void begin_slender(glint_plane *p, const glint_gradients *g, int32_t start, int32_t d1, int32_t d2);

/*@ requires \valid(g) && 1 <= area <= 0x40000000;
    requires -0x8000 <= g->x1 < 0x8000 && -0x8000 <= g->y1 < 0x8000;
    requires -0x8000 <= g->x2 < 0x8000 && -0x8000 <= g->y2 < 0x8000;
    assigns \result, g->x1, g->y1, g->x2, g->y2, g->reciprocal, g->shift, g->reach \from *g, area, steep;
    ensures g->reach < 0x8000;
    ensures (\result == 1 && NARROW(g)) || (\result == 0 && WIDE(g) && g->shift >= 1) || (\result == 0 && SLENDER(g));
 */
static inline int gradients_begin(glint_gradients *g, uint32_t area, int steep);

/*@ requires 1 <= size <= 16 && 0 <= reciprocal;
    requires -(1 << size) <= side <= 1 << size;
    assigns \result \from side, reciprocal, size;
    ensures -0x40000000 <= \result <= 0x40000000; */
static int32_t to_30_bits(int32_t side, int32_t reciprocal, int32_t size);

/* Stands on corners that run counter-clockwise in a guard band: bin lists no others, and tile.c turns them; the image
 * tests under UBSan. */
/*@ requires \valid_read(g);
    assigns \result \from *g;
    admit ensures 1 <= \result <= 0x40000000; */
static inline int32_t find_area(const glint_gradients *g);

static glint_gradients g;
static glint_plane plane;

/* Differences of any size, by the bits and signs of the larger one, first or last: an OR tells no places apart. */
static int32_t any_of_bits(int bits, int negative) {
    const int32_t x = (int32_t)ANY_OF_BITS(bits);
    return negative ? -1 - x : x;
}

/* Any number, by its bits and sign. */
PROOF(glint_magnitude_bits) {
    FOR_PARTS(bits, 0, 31) {
        FOR_PARTS(negative, 0, 1) {
            glint_magnitude_bits(any_of_bits(bits, negative));
        }
    }
}

/* Sides of up to 15 bits, any area, any bulge. */
PROOF(glint_keeps_digits) {
    any_narrow(&g);
    g.reach = ANY_UNSIGNED(0, INT16_MAX);
    glint_keeps_digits(&g, ANY(1, INT32_MAX), ANY_UNSIGNED(0, 1u << 30));
    any_wide(&g);
    g.reach = ANY_UNSIGNED(0, INT16_MAX);
    glint_keeps_digits(&g, ANY(1, INT32_MAX), ANY_UNSIGNED(0, 1u << 30));
}

/*
 * Any differences, by the bits and signs of the larger, first or last.
 * @contract glint_magnitude_bits
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(begin_narrow) {
    any_narrow(&g);
    FOR_PARTS(bits, 0, 31) {
        FOR_PARTS(kind, 0, 3) {
            const int32_t most = (int32_t)((1u << bits) - 1), d = any_of_bits(bits, kind & 1);
            const int32_t other = ANY(-1 - most, most);
            begin_narrow(&plane, &g, ANY_INT, kind & 2 ? d : other, kind & 2 ? other : d);
        }
    }
}

/*
 * Any differences, by the shift.
 * @contract glint_magnitude_bits
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(begin_wide) {
    any_wide(&g);
    FOR_PARTS(shift, -6, 27) {
        g.shift = shift;
        begin_wide(&plane, &g, ANY_INT, ANY_INT, ANY_INT);
    }
}

/*
 * Any differences.
 * @contract find_area
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(begin_slender) {
    any_slender(&g);
    begin_slender(&plane, &g, ANY_INT, ANY_INT, ANY_INT);
}

/* Corners' values up to 31 2^26 apart, by parts of the first; below 2^30; and none below 0. @contract begin_narrow
 * begin_wide begin_slender */
PROOF(glint_plane_begin) {
    FOR_PARTS(kind, 0, 2) {
        if (kind == 0)
            any_narrow(&g);
        else if (kind == 1)
            any_wide(&g);
        else
            any_slender(&g);
        if (kind == 1)
            g.shift = ANY(1, 27);
        FOR_PARTS(i, -32, 31) {
            const int32_t first = i * (1 << 26), last = first + ((1 << 26) - 1);
            const int32_t least = i < -1 ? INT32_MIN : first - 0x7c000000, most = i < 1 ? last + 0x7c000000 : INT32_MAX;
            glint_plane_begin(&plane, &g, ANY(first, last), ANY(least, most), ANY(least, most));
        }
        glint_plane_begin(&plane, &g, ANY(1 - (1 << 30), (1 << 30) - 1), ANY(1 - (1 << 30), (1 << 30) - 1),
                          ANY(1 - (1 << 30), (1 << 30) - 1));
        glint_plane_begin(&plane, &g, ANY(0, INT32_MAX), ANY(0, INT32_MAX), ANY(0, INT32_MAX));
    }
}

/*
 * Sides of each size, by signs.
 * @narrowing a shift to the left, of sides of no more bits than it leaves room for
 */
PROOF(to_30_bits) {
    FOR_PARTS(size, 1, 16) {
        to_30_bits(ANY(-(1 << size), -1), ANY(0, INT32_MAX), size);
        to_30_bits(ANY(0, 1 << size), ANY(0, INT32_MAX), size);
    }
}

/*
 * Sides below 2048 pixels, by the bits and signs of the longest, the first: an OR tells no places apart; by those of
 * the area, which has at most 1 more than twice as many.
 * @contract glint_reciprocal to_30_bits glint_reciprocal16_by_division glint_magnitude_bits
 * @unreached 1 leading zeros of 0
 * @options -eva-slevel 0 -eva-slevel-function gradients_begin:60
 */
PROOF(gradients_begin) {
    FOR_PARTS(bits, 0, 15) {
        FOR_PARTS(area, 1, 2 * bits + 1) {
            FOR_PARTS(negative, 0, 1) {
                const int32_t most = (int32_t)((1u << bits) - 1);
                glint_gradients g;
                g.x1 = any_of_bits(bits, negative);
                g.y1 = ANY(-1 - most, most);
                g.x2 = ANY(-1 - most, most);
                g.y2 = ANY(-1 - most, most);
                gradients_begin(&g, area < 31 ? (uint32_t)any_of_bits(area, 0) : 1u << 30, ANY(0, 1));
            }
        }
    }
}

/*
 * Any corners in a guard band, from its centre: where that lies cancels; of perspective and of parallel rays.
 * @contract find_area gradients_begin begin_narrow begin_wide begin_slender
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(glint_setup) {
    static glint_vertex corners[3];
    static glint_part part;
    glint_triangle triangle = {{&corners[0], &corners[1], &corners[2]}, {0, 0, 0}, 0, 0, 0};
    part.window.left = ANY(-8191, 8192);
    part.window.top = ANY(-8191, 8192);
    FOR_PARTS(is_parallel, 0, 1) {
        for (int i = 0; i < 3; i++) {
            corners[i].x = (int16_t)ANY(-16383, 16383);
            corners[i].y = (int16_t)ANY(-16383, 16383);
            corners[i].inverse_w =
                is_parallel ? ANY(GLINT_DEPTH_TOP + 1, GLINT_DEPTH_TOP + 0xfffe) : ANY(0, GLINT_DEPTH_TOP);
        }
        glint_setup(&part, &triangle);
    }
}
