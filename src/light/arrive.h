/* SPDX-License-Identifier: MIT */
/** @file arrive.h What arrives of a light at a fragment: put into the models' loops, except where it is built for size.
 */
#ifndef GLINT_ARRIVE_H
#define GLINT_ARRIVE_H

#include "../math/division.h"
#include "lamps.h"

/** Returns the sum of attenuate_lamp of any light. */
uint32_t glint_sum_attenuation(const glint_drawn_lamp *lamp, uint32_t distance, uint32_t square, uint32_t up);

/** A way to a light, as a vector below 2^15, its square, 4^more of what that is in the unit of places, and N.D. */
typedef struct glint_lamp_way {
    int32_t at[3], cosine;
    uint32_t square, more;
} glint_lamp_way;

/** Finds the way to a light where it, or what of it is along N, is too short for its bits. @return 0 where the light is
 * not seen */
int glint_find_near_way(const glint_lamps *lamps, const glint_drawn_lamp *lamp, const glint_lit_view *s,
                        uint32_t square, int32_t cosine, glint_lamp_way *way);

/** Marks a fragment as rough that is within a few pixels of a light, or, twice over, of a narrow cone's axis. */
void glint_mark_rough(const glint_drawn_lamp *lamp, glint_lit_fragment *f, int32_t x, int32_t y, int32_t z,
                      uint32_t square);

/* floor(2^31 / x), x from 2^16 to 2^31 + 2^16. */
static inline uint32_t invert_sum(uint32_t x) {
    if (GLINT_DIVIDES)
        return 0x80000000u / x;
    const unsigned zeros = glint_leading_zeros(x);
    uint32_t quotient = (uint32_t)glint_reciprocal16(x << zeros >> 16) >> (16 - zeros);
    while (quotient * x > 0x80000000u) /* off by 2 at most */
        quotient--;
    while (0x80000000u - quotient * x >= x)
        quotient++;
    return quotient;
}

/* Returns 1 / (1 + linear d + quadratic d^2), Q15; `square` of 32 bits is d^2 2^up, and 2^31 over its root is given. */
static inline uint32_t attenuate_lamp(const glint_drawn_lamp *lamp, uint32_t square, uint32_t over, uint32_t up) {
    const uint32_t distance = (square >> 16) * over >> 15;
    return invert_sum((1u << 16) + (distance * lamp->linear >> (up >> 1) >> lamp->linear_shift) +
                      ((square >> 16) * lamp->quadratic >> up >> lamp->quadratic_shift));
}

/* The same of any light and any `up`. */
static inline uint32_t attenuate_any(const glint_drawn_lamp *lamp, uint32_t square, uint32_t over, uint32_t up) {
    if (!lamp->weakens)
        return 1u << 15;
    if (lamp->weakens > 1 || up > 31)
        return invert_sum(glint_sum_attenuation(lamp, (square >> 16) * over >> 15, square, up));
    return attenuate_lamp(lamp, square, over, up);
}

/*
 * A spot's step between its angles, Q15; of a way's part along the axis, times 2^15, and 2^31 over the way's length,
 * which has 16 bits.
 */
static inline uint32_t cone_at(const glint_drawn_lamp *lamp, int32_t along, uint32_t over) {
    const uint32_t size = (uint32_t)(along < 0 ? -along : along) >> 15;
    const int32_t whole = (int32_t)(size * over >> 15), magnitude = whole - (whole >> 13), /* times GLINT_UNIT / 2^15 */
        past = (along < 0 ? -magnitude : magnitude) - lamp->cone_outer;                    /* Q16 */
    if (past <= 0)
        return 0;
    if (past >= lamp->cone_width)
        return 1u << 15;
    const uint32_t t = (uint32_t)past * lamp->over_width >> 15;
    return (t * t >> 15) * ((3u << 15) - 2 * t) >> 15;
}

/*
 * Finds what arrives of a light at a fragment, by the way to it; its square is 4^more of what it is in the unit of
 * places. @return 0 for nothing
 */
static GLINT_INLINE int arrive_by(const glint_drawn_lamp *lamp, const glint_lit_view *s, glint_arrival *to,
                                  int32_t cosine, int32_t x, int32_t y, int32_t z, uint32_t square, uint32_t more,
                                  int has_gloss, int is_odd) {
    const uint32_t zeros = glint_leading_zeros(square | 1) & 30, up = zeros >> 1;
    square <<= zeros;
    const uint32_t over = glint_over_length(square);
    uint32_t strength = 1u << 15;
    if (is_odd && lamp->has_cone) {
        const int16_t *axis = lamp->source->direction;
        strength = cone_at(lamp, glint_shift_left(axis[0] * x + axis[1] * y + axis[2] * z, up), over);
        if (!strength)
            return 0;
    }
    if (has_gloss) {
        const int32_t along = glint_shift_right(glint_shift_left(s->v[0] * x + s->v[1] * y + s->v[2] * z, up), 15);
        to->along = glint_shift_right(along * (int32_t)(over * (uint32_t)s->over_v >> 16), 15);
    }
    cosine = glint_shift_right(glint_shift_left(cosine, up), 15);
    to->cosine = glint_shift_right(cosine * (int32_t)(over * (uint32_t)s->over_n >> 16), 15);
    to->strength = is_odd ? strength * attenuate_any(lamp, square, over, zeros + more) >> 15
                          : attenuate_lamp(lamp, square, over, zeros);
    return 1;
}

static GLINT_INLINE int arrive_from_place(const glint_lamps *lamps, const glint_drawn_lamp *lamp, glint_lit_view *s,
                                          glint_arrival *to, int has_gloss) {
    const unsigned down = lamp->down;
    int32_t x = lamp->at[0] + glint_shift_right(s->e[0], down), y = lamp->at[1] + glint_shift_right(s->e[1], down),
            z = lamp->at[2] + glint_shift_right(s->e[2], down);
    int32_t cosine = s->n[0] * x + s->n[1] * y + s->n[2] * z;
    const int is_dim = cosine <= lamps->far_gate;
    if (is_dim && cosine <= lamps->near_gate) {
        s->at->unseen++;
        return 0;
    }
    uint32_t square = (uint32_t)x * (uint32_t)x + (uint32_t)y * (uint32_t)y + (uint32_t)z * (uint32_t)z, more = 0;
    if (GLINT_RARELY(is_dim || square < lamp->usual)) {
        if (is_dim || square < lamp->near) {
            glint_lamp_way way;
            if (!glint_find_near_way(lamps, lamp, s, square, cosine, &way)) {
                s->at->unseen++;
                return 0;
            }
            x = way.at[0], y = way.at[1], z = way.at[2];
            cosine = way.cosine;
            square = way.square;
            more = way.more;
        } else if (square < lamp->cone_rough) {
            glint_mark_rough(lamp, s->at, x, y, z, square);
        }
        return arrive_by(lamp, s, to, cosine, x, y, z, square, more, has_gloss, 1);
    }
    return arrive_by(lamp, s, to, cosine, x, y, z, square, 0, has_gloss, 0);
}

static GLINT_INLINE int arrive_along(const glint_lamps *lamps, const glint_drawn_lamp *lamp, const glint_lit_view *s,
                                     glint_arrival *to, int has_gloss) {
    const int32_t x = lamp->at[0], y = lamp->at[1], z = lamp->at[2];
    const int32_t cosine = s->n[0] * x + s->n[1] * y + s->n[2] * z;
    if (cosine <= lamps->gate) {
        s->at->unseen++;
        return 0;
    }
    to->cosine = glint_shift_right(glint_shift_right(cosine, 15) * s->over_n, 15);
    to->strength = 1u << 15;
    if (has_gloss)
        to->along = glint_shift_right(glint_shift_right(s->v[0] * x + s->v[1] * y + s->v[2] * z, 15) * s->over_v, 15);
    return 1;
}

#endif
