/* SPDX-License-Identifier: MIT */
/** @file arrive.h Computes how much of a light arrives at a fragment, and from where. The loops of the models inline
 * these functions, except in a library built for size. */
#ifndef GLINT_ARRIVE_H
#define GLINT_ARRIVE_H

#include "../math/division.h"
#include "lamps.h"

/** Returns 1 + linear d + quadratic d^2, Q16, of any light, where attenuate_lamp does not serve. The square of the
 * distance d is square 2^-square_up. */
uint32_t glint_sum_attenuation(const glint_drawn_lamp *lamp, uint32_t distance, uint32_t square, uint32_t square_up);

/** The vector D from a fragment to a light. The unit of places is that of glint_lamps. */
typedef struct glint_lamp_way {
    int32_t vector[3];  /* D, each component below 2^15 */
    int32_t cosine;     /* N.D */
    uint32_t square;    /* D.D, */
    uint32_t square_up; /* which is 2^square_up times the square in the unit of places; at least -2, modulo 2^32 */
} glint_lamp_way;

/** Finds the way to a light with square_up bits: where the way, or its component along N, is too short for 15 bits.
 * @return 0 where the surface faces away from the light */
int glint_find_near_way(const glint_lamps *lamps, const glint_drawn_lamp *lamp, const glint_lit_view *view,
                        uint32_t square, int32_t cosine, glint_lamp_way *way);

/** Marks a fragment as rough if it lies within a few pixels of a light, or within twice as many of the axis of a narrow
 * cone. */
void glint_mark_rough(const glint_drawn_lamp *lamp, glint_lit_fragment *f, int32_t x, int32_t y, int32_t z,
                      uint32_t square);

/* Returns floor(2^31 / x), x from 2^16 to 2^31 + 2^16. */
static inline uint32_t invert_sum(uint32_t x) {
    if (GLINT_DIVIDES)
        return 0x80000000u / x;
    const unsigned zeros = glint_leading_zeros(x);
    uint32_t quotient = (uint32_t)glint_reciprocal16(x << zeros >> 16) >> (16 - zeros);
    while (quotient * x > 0x80000000u) /* the quotient is off by 2 at most */
        quotient--;
    while (0x80000000u - quotient * x >= x)
        quotient++;
    return quotient;
}

/* Returns 1 / (1 + linear d + quadratic d^2), Q15, at a distance d: `square` has 32 bits and is d^2 2^square_up, `over`
 * is 2^31 over its root. */
static inline uint32_t attenuate_lamp(const glint_drawn_lamp *lamp, uint32_t square, uint32_t over,
                                      uint32_t square_up) {
    const uint32_t distance = (square >> 16) * over >> 15;
    return invert_sum((1u << 16) + (distance * lamp->linear >> (square_up >> 1) >> lamp->linear_shift) +
                      ((square >> 16) * lamp->quadratic >> square_up >> lamp->quadratic_shift));
}

/* Returns what attenuate_lamp does, of any light at any distance. */
static inline uint32_t attenuate_any(const glint_drawn_lamp *lamp, uint32_t square, uint32_t over, uint32_t square_up) {
    if (!lamp->weakens)
        return 1u << 15;
    if (lamp->weakens > 1 || square_up > 31)
        return invert_sum(glint_sum_attenuation(lamp, (square >> 16) * over >> 15, square, square_up));
    return attenuate_lamp(lamp, square, over, square_up);
}

/* Returns the part of a spot's light that its cone lets through, Q15: a smooth step from the outer to the inner angle.
 * `axial` is the component of the way along the axis, times 2^15; `over` is 2^31 over the way's length, 16 bits. */
static inline uint32_t attenuate_by_cone(const glint_drawn_lamp *lamp, int32_t axial, uint32_t over) {
    const uint32_t size = (uint32_t)(axial < 0 ? -axial : axial) >> 15;
    const int32_t cosine = (int32_t)(size * over >> 15);
    const int32_t magnitude = cosine - (cosine >> 13); /* cone_outer has GLINT_UNIT^2 for 2^30, too */
    const int32_t past = (axial < 0 ? -magnitude : magnitude) - lamp->cone_outer; /* Q16 */
    if (past <= 0)
        return 0;
    if (past >= lamp->cone_width)
        return 1u << 15;
    return glint_smooth_step((uint32_t)past * lamp->over_width >> 15);
}

/*
 * Finds direction and strength of a light at a fragment, given the way (x, y, z) to the light, N.D as `cosine`, and
 * D.D, which is 2^square_up times the square in the unit of places. `is_odd` is set if the light has a cone, if
 * attenuate_lamp does not serve it, if it is near, or if N.D is nearly 0.
 * @return 0 if nothing arrives
 */
static GLINT_INLINE int arrive_by(const glint_drawn_lamp *lamp, const glint_lit_view *view, glint_arrival *to,
                                  int32_t cosine, int32_t x, int32_t y, int32_t z, uint32_t square, uint32_t square_up,
                                  int has_gloss, int is_odd) {
    const uint32_t zeros = glint_leading_zeros(square | 1) & 30, up = zeros >> 1;
    square <<= zeros;
    const uint32_t over = glint_over_length(square);
    uint32_t strength = 1u << 15;
    if (is_odd && lamp->has_cone) {
        const int16_t *axis = lamp->source->direction;
        strength = attenuate_by_cone(lamp, glint_shift_left(axis[0] * x + axis[1] * y + axis[2] * z, up), over);
        if (!strength)
            return 0;
    }
    if (has_gloss) {
        const int32_t dot =
            glint_shift_right(glint_shift_left(view->v[0] * x + view->v[1] * y + view->v[2] * z, up), 15);
        to->light_dot_view = glint_shift_right(dot * (int32_t)(over * (uint32_t)view->over_v >> 16), 15);
    }
    cosine = glint_shift_right(glint_shift_left(cosine, up), 15);
    to->cosine = glint_shift_right(cosine * (int32_t)(over * (uint32_t)view->over_n >> 16), 15);
    to->strength = is_odd ? strength * attenuate_any(lamp, square, over, zeros + square_up) >> 15
                          : attenuate_lamp(lamp, square, over, zeros);
    return 1;
}

/* Finds direction and strength of a light that has a place. @return 0 if nothing arrives */
static GLINT_INLINE int arrive_from_place(const glint_lamps *lamps, const glint_drawn_lamp *lamp, glint_lit_view *view,
                                          glint_arrival *to, int has_gloss) {
    const unsigned down = lamp->down;
    int32_t x = lamp->place[0] + glint_shift_right(view->e[0], down),
            y = lamp->place[1] + glint_shift_right(view->e[1], down),
            z = lamp->place[2] + glint_shift_right(view->e[2], down);
    int32_t cosine = view->n[0] * x + view->n[1] * y + view->n[2] * z;
    const int is_dim = cosine <= lamps->far_gate;
    if (is_dim && cosine <= lamps->near_gate) {
        view->fragment->unseen++;
        return 0;
    }
    uint32_t square = (uint32_t)x * (uint32_t)x + (uint32_t)y * (uint32_t)y + (uint32_t)z * (uint32_t)z, square_up = 0;
    if (GLINT_RARELY(is_dim || square < lamp->usual)) {
        if (is_dim || square < lamp->near) {
            glint_lamp_way way;
            if (!glint_find_near_way(lamps, lamp, view, square, cosine, &way)) {
                view->fragment->unseen++;
                return 0;
            }
            x = way.vector[0], y = way.vector[1], z = way.vector[2];
            cosine = way.cosine;
            square = way.square;
            square_up = way.square_up;
        } else if (square < lamp->cone_rough) {
            glint_mark_rough(lamp, view->fragment, x, y, z, square);
        }
        return arrive_by(lamp, view, to, cosine, x, y, z, square, square_up, has_gloss, 1);
    }
    return arrive_by(lamp, view, to, cosine, x, y, z, square, 0, has_gloss, 0);
}

/* Finds the direction of a directional light. @return 0 if the surface faces away from the light */
static GLINT_INLINE int arrive_from_direction(const glint_lamps *lamps, const glint_drawn_lamp *lamp,
                                              const glint_lit_view *view, glint_arrival *to, int has_gloss) {
    const int32_t x = lamp->place[0], y = lamp->place[1], z = lamp->place[2];
    const int32_t cosine = view->n[0] * x + view->n[1] * y + view->n[2] * z;
    if (cosine <= lamps->gate) {
        view->fragment->unseen++;
        return 0;
    }
    to->cosine = glint_shift_right(glint_shift_right(cosine, 15) * view->over_n, 15);
    to->strength = 1u << 15;
    if (has_gloss)
        to->light_dot_view = glint_shift_right(
            glint_shift_right(view->v[0] * x + view->v[1] * y + view->v[2] * z, 15) * view->over_v, 15);
    return 1;
}

#endif
