/* SPDX-License-Identifier: MIT */
/* Arrive: ways to lights that are near, and what arrives of any where that is not put into loops; arrive.h. */
#include "arrive.h"

#include "../math/product.h"
#include "../raster/depth.h"

/* ---- Ways ---- */

/* Finds 1/w of a fragment from 2^31 on, in the octave of the unit of places. */
static uint32_t find_inverse_w(const glint_lamps *lamps, const glint_lit_view *s) {
    glint_row_walk *walk = lamps->walk;
    if (!walk->list->has_w)
        glint_set_fine_w(walk);
    const int32_t fine = glint_lamp_plane(&walk->w, glint_fragment_row(s->at), glint_fragment_column(s->at));
    const uint32_t up = (uint32_t)glint_least(glint_most(17 - lamps->unit - (int32_t)walk->list->up, 1), 31);
    if (fine <= glint_shift_right(INT32_MAX, up))
        return 1u << 31;
    return fine >> (32 - up) ? UINT32_MAX : (uint32_t)fine << up;
}

/* Finds the way from a fragment's place to the eye, as in `e`, with the bits that this lacks of w. */
static void find_fine_place(const glint_lamps *lamps, const glint_lit_view *s, int32_t e[3]) {
    if (lamps->walk->frame->view->is_parallel) {
        for (int c = 0; c < 3; c++)
            e[c] = s->e[c];
        return;
    }
    const uint32_t w = glint_reciprocal(find_inverse_w(lamps, s));
    glint_find_fine_ray(lamps, s->at, e);
    for (int c = 0; c < 3; c++)
        e[c] = (int32_t)glint_shift_right64(glint_product(e[c], (int32_t)(w >> 1)), 27);
}

/* Adds a light's place to the way to the eye. */
static inline void add_place(const glint_drawn_lamp *lamp, const int32_t e[3], int32_t way[3]) {
    const int32_t *const place = lamp->source->lamp.place;
    for (int c = 0; c < 3; c++)
        way[c] = glint_shift_right(e[c], lamp->down - 15u) + glint_shift_right(place[c], lamp->fine_down);
}

GLINT_NOINLINE void glint_find_fine_way(const glint_lamps *lamps, const glint_drawn_lamp *lamp, const glint_lit_view *s,
                                        int32_t way[3]) {
    int32_t e[3];
    find_fine_place(lamps, s, e);
    add_place(lamp, e, way);
}

/* ---- Near lights ---- */

/* x 2^-shift, at most 2^30. */
static uint32_t weaken_by(uint32_t x, int32_t shift) {
    if (shift > 31)
        return 0;
    return shift < 0 ? (x ? 1u << 30 : 0) : x >> shift;
}

GLINT_NOINLINE uint32_t glint_sum_attenuation(const glint_drawn_lamp *lamp, uint32_t distance, uint32_t square,
                                              uint32_t up) {
    return (1u << 16) + weaken_by(distance * lamp->linear, lamp->linear_shift + (int32_t)(up >> 1)) +
           weaken_by((square >> 16) * lamp->quadratic, lamp->quadratic_shift + (int32_t)up);
}

/* A way of a quarter of a step is no more than rounding leaves: of a lamp at the surface nothing arrives. */
GLINT_NOINLINE int glint_find_near_way(const glint_lamps *lamps, const glint_drawn_lamp *lamp, const glint_lit_view *s,
                                       uint32_t coarse_square, int32_t coarse_cosine, glint_lamp_way *way) {
    int32_t d[3];
    if (coarse_square < lamp->rough || lamp->has_cone)
        s->at->is_rough = 1;
    if (coarse_square < lamps->nearest >> (lamp->down - 16) || coarse_cosine <= lamps->far_gate)
        glint_find_fine_way(lamps, lamp, s, d);
    else
        add_place(lamp, s->e, d);
    const unsigned zeros =
        glint_leading_zeros(glint_magnitude_bits(d[0]) | glint_magnitude_bits(d[1]) | glint_magnitude_bits(d[2]));
    if (zeros > 18)
        return 0;
    const unsigned down = zeros < 17 ? 17 - zeros : 0;
    const int32_t half = (int32_t)(1u << down >> 1);
    way->square = 0;
    way->cosine = 0;
    for (int c = 0; c < 3; c++) {
        const int32_t x = way->at[c] = glint_shift_right(d[c] + half, down);
        way->square += (uint32_t)(x * x);
        way->cosine += s->n[c] * x;
    }
    way->more = 2 * (15 - down);
    return way->cosine > lamps->gate;
}

GLINT_NOINLINE void glint_mark_rough(const glint_drawn_lamp *lamp, glint_lit_fragment *f, int32_t x, int32_t y,
                                     int32_t z, uint32_t square) {
    if (square >= lamp->rough) { /* then it has a cone */
        const int16_t *axis = lamp->source->direction;
        const int32_t along = glint_shift_right(axis[0] * x + axis[1] * y + axis[2] * z, 15);
        if (along <= 0 || (int32_t)(square - (uint32_t)along * (uint32_t)along) >=
                              4 * (int32_t)glint_least((int32_t)lamp->rough, INT32_MAX / 4))
            return;
    }
    f->is_rough = 1;
}

#if GLINT_SMALL
int glint_arrive_from_place(const glint_lamps *lamps, const glint_drawn_lamp *lamp, glint_lit_view *s,
                            glint_arrival *to) {
    return arrive_from_place(lamps, lamp, s, to, lamps->has_gloss);
}

int glint_arrive_along(const glint_lamps *lamps, const glint_drawn_lamp *lamp, glint_lit_view *s, glint_arrival *to) {
    return arrive_along(lamps, lamp, s, to, lamps->has_gloss);
}
#endif
