/* SPDX-License-Identifier: MIT */
/* Finds ways to lights: near ones with all bits, and those of other octaves of 1/w in their own unit; arrive.h. */
#include "arrive.h"

#include "../math/product.h"
#include "../raster/depth.h"

/* ---- Ways ---- */

/* Returns 1/w of a fragment, with more bits than depth has, from 2^31 on: scaled to the octave of the unit. */
static uint32_t find_inverse_w(const glint_lamps *lamps, const glint_lit_view *view) {
    glint_row_walk *walk = lamps->walk;
    if (!walk->list->has_w)
        glint_set_fine_w(walk);
    const int32_t fine =
        glint_lamp_plane(&walk->w, glint_fragment_row(view->fragment), glint_fragment_column(view->fragment));
    const uint32_t up = (uint32_t)glint_least(glint_most(17 - lamps->unit - (int32_t)walk->list->up, 1), 31);
    if (fine <= glint_shift_right(INT32_MAX, up))
        return 1u << 31;
    return fine >> (32 - up) ? UINT32_MAX : (uint32_t)fine << up;
}

/* Finds the vector from a fragment's place to the eye, as in `e` of the view, with w of all bits. */
static void find_fine_place(const glint_lamps *lamps, const glint_lit_view *view, int32_t e[3]) {
    if (lamps->walk->frame->view->is_parallel) {
        for (int c = 0; c < 3; c++)
            e[c] = view->e[c];
        return;
    }
    const uint32_t w = glint_reciprocal(find_inverse_w(lamps, view));
    glint_find_fine_ray(lamps, view->fragment, e);
    for (int c = 0; c < 3; c++)
        e[c] = (int32_t)glint_shift_right64(glint_product(e[c], (int32_t)(w >> 1)), 27);
}

/* Finds the vector from a fragment to a light, 31 bits, by adding the light's place to the vector to the eye. */
static inline void add_place(const glint_drawn_lamp *lamp, const int32_t e[3], int32_t way[3]) {
    const int32_t *const place = lamp->source->lamp.place;
    for (int c = 0; c < 3; c++)
        way[c] = glint_shift_right(e[c], lamp->down - 15u) + glint_shift_right(place[c], lamp->fine_down);
}

static GLINT_NOINLINE void find_fine_way(const glint_lamps *lamps, const glint_drawn_lamp *lamp,
                                         const glint_lit_view *view, int32_t way[3]) {
    int32_t e[3];
    find_fine_place(lamps, view, e);
    add_place(lamp, e, way);
}

/* ---- Units of places ---- */

/* Returns 1 / tan^2 of a spot's outer angle, Q8, below 2^16; an angle of 90 degrees or more gives 0. */
static uint16_t sharpness_of(const glint_prepared_light *source) {
    const int32_t cosine = glint_shift_right(source->spot.cosine_outer, 15);
    if (cosine <= 0)
        return 0;
    const uint32_t square = (uint32_t)(cosine * cosine), rest = square < 1u << 30 ? ((1u << 30) - square) >> 8 : 0;
    return (uint16_t)glint_least((int32_t)(square / (rest > 1u << 14 ? rest : 1u << 14)), UINT16_MAX);
}

/*
 * Brings lights to the unit of places in which 1/w 2^-unit has 16 bits. A fragment's place lies within 2^15 of the eye,
 * and so does a light: if a light is farther, its place and the fragment's are both scaled by 2^-k. The sum of both has
 * up to two bits more, so that products with other vectors of 15 bits have 31.
 */
static void bring_to_unit(glint_lamps *lamps) {
    const int32_t unit = lamps->unit;
    for (glint_drawn_lamp *lamp = lamps->lamps, *end = lamp + lamps->count; lamp != end; lamp++) {
        const glint_prepared_light *source = lamp->source;
        if (!lamp->has_place)
            continue;
        const int32_t near_shift = source->lamp.shift - 15 - unit, k = glint_most(16 - near_shift, 0);
        const unsigned shift = (unsigned)glint_least(near_shift + k, 30);
        const int32_t half = (int32_t)(1u << shift); /* half a step to round, and half that the cut of `e` loses */
        for (int c = 0; c < 3; c++)
            lamp->place[c] = glint_shift_right(source->lamp.place[c] + half, shift);
        lamp->down = (uint8_t)glint_least(16 + k, 31);
        /* 12 pixels, at the largest distance that places of this unit can have */
        const uint32_t cell =
            (uint32_t)glint_shift_right(glint_least(lamps->step >> 8, 1 << 14), (unsigned)glint_least(k, 15));
        lamp->rough = cell * cell / 4 * 9;
        const uint32_t sharpness = lamp->has_cone ? sharpness_of(source) : 0, most = 0x80000000u / (sharpness + 1),
                       narrow = lamp->rough >> 8;
        lamp->cone_rough = (narrow < most ? narrow : most) * sharpness;
        lamp->cone_rough = lamp->cone_rough > lamp->rough ? lamp->cone_rough : lamp->rough;
        lamp->near = k <= 3 ? lamps->near >> k : 0; /* lights of larger k are never so near */
        lamp->fine_down = (uint8_t)glint_least(near_shift + k - 15, 31);
        const int32_t linear_shift = source->lamp.linear_shift - (k - unit),
                      quadratic_shift = source->lamp.quadratic_shift - 2 * (k - unit);
        lamp->weakens = (lamp->linear | lamp->quadratic) != 0;
        if ((lamp->linear && linear_shift < 0) || (lamp->quadratic && quadratic_shift < 0))
            lamp->weakens = 2;
        lamp->usual = lamp->near > lamp->rough ? lamp->near : lamp->rough;
        if (lamp->has_cone || lamp->weakens != 1)
            lamp->usual = UINT32_MAX;
        lamp->linear_shift = (int8_t)glint_most(glint_least(linear_shift, 31), INT8_MIN);
        lamp->quadratic_shift = (int8_t)glint_most(glint_least(quadratic_shift, 31), INT8_MIN);
    }
}

/*
 * Finds the vectors from a triangle's corners to the eye, all in one unit of places.
 * @return the leading zeros of 1/w at the corners, or a number below 0 if a corner has another octave of 1/w or lies
 * too far outside of the screen
 */
static int32_t find_corner_ways(const glint_row_walk *walk, int32_t e[3][3]) {
    const glint_vertex *const *v = walk->triangle.corners;
    const glint_config *config = &walk->frame->config;
    const glint_lamps *lamps = walk->workspace->lamps;
    const uint32_t zeros = glint_leading_zeros((uint32_t)v[0]->inverse_w | 1);
    if (walk->frame->view->is_parallel)
        return -1;
    for (int j = 0; j < 3; j++) {
        const uint32_t inverse_w = (uint32_t)v[j]->inverse_w;
        const int64_t x = glint_product(8 * config->width - v[j]->x, lamps->step),
                      y = glint_product(v[j]->y - 8 * config->height, lamps->step), limit = (int64_t)1 << 31;
        if (inverse_w >> (31 - zeros) != 1 || x >= limit || x < -limit || y >= limit || y < -limit)
            return -1;
        const int32_t w = glint_reciprocal16(inverse_w << zeros >> 16);
        e[j][0] = glint_shift_right((int32_t)x, 16) * w;
        e[j][1] = glint_shift_right((int32_t)y, 16) * w;
        e[j][2] = glint_shift_right(lamps->z, 12) * w;
    }
    return (int32_t)zeros;
}

/* Sets V and w of a fragment where rays are parallel: V has 14 bits, and w is a power of two. */
static void find_parallel(const glint_row_walk *walk, glint_lit_view *view) {
    const glint_view *camera = walk->frame->view;
    const int32_t distance = walk->frame->scene->camera.projection->distance_of(camera, view->fragment->inverse_w);
    const int64_t far = glint_shift_right64(glint_product(distance, camera->ray_scale), 24);
    const unsigned bits = glint_bits64(glint_magnitude64(far)), down = bits > 14 ? bits - 14 : 0,
                   rest = down > 16 ? down - 16 : 0;
    view->v[0] = glint_shift_right(view->v[0], rest);
    view->v[1] = glint_shift_right(view->v[1], rest);
    view->v[2] = (int32_t)glint_shift_right64(far, rest);
    view->w = 1 << (16 - (down - rest));
    glint_set_lamps_unit(walk, 16 - (int32_t)down);
}

GLINT_NOINLINE void glint_find_other_w(const glint_row_walk *walk, glint_lit_view *view) {
    const uint32_t inverse_w = (uint32_t)view->fragment->inverse_w, zeros = glint_leading_zeros(inverse_w);
    if (walk->frame->view->is_parallel) {
        find_parallel(walk, view);
        return;
    }
    glint_set_lamps_unit(walk, 16 - (int32_t)zeros - (int32_t)walk->list->room);
    view->w = glint_reciprocal16(inverse_w << zeros >> 16);
}

/* ---- Near lights ---- */

/* Returns x 2^-shift, at most 2^30. */
static uint32_t weaken_by(uint32_t x, int32_t shift) {
    if (shift > 31)
        return 0;
    return shift < 0 ? (x ? 1u << 30 : 0) : x >> shift;
}

GLINT_NOINLINE uint32_t glint_sum_attenuation(const glint_drawn_lamp *lamp, uint32_t distance, uint32_t square,
                                              uint32_t square_up) {
    return (1u << 16) + weaken_by(distance * lamp->linear, lamp->linear_shift + (int32_t)(square_up >> 1)) +
           weaken_by((square >> 16) * lamp->quadratic, lamp->quadratic_shift + (int32_t)square_up);
}

/* A way shorter than a quarter of a step is nothing but rounding: a light in the surface itself does not light it. */
GLINT_NOINLINE int glint_find_near_way(const glint_lamps *lamps, const glint_drawn_lamp *lamp,
                                       const glint_lit_view *view, uint32_t coarse_square, int32_t coarse_cosine,
                                       glint_lamp_way *way) {
    int32_t d[3];
    if (coarse_square < lamp->rough || lamp->has_cone)
        view->fragment->is_rough = 1;
    if (coarse_square < lamps->nearest >> (lamp->down - 16) || coarse_cosine <= lamps->far_gate)
        find_fine_way(lamps, lamp, view, d);
    else
        add_place(lamp, view->e, d);
    const unsigned zeros =
        glint_leading_zeros(glint_magnitude_bits(d[0]) | glint_magnitude_bits(d[1]) | glint_magnitude_bits(d[2]));
    if (zeros > 18)
        return 0;
    const unsigned down = zeros < 17 ? 17 - zeros : 0;
    const int32_t half = (int32_t)(1u << down >> 1);
    way->square = 0;
    way->cosine = 0;
    for (int c = 0; c < 3; c++) {
        const int32_t x = way->vector[c] = glint_shift_right(d[c] + half, down);
        way->square += (uint32_t)(x * x);
        way->cosine += view->n[c] * x;
    }
    way->square_up = 2 * (15 - down);
    return way->cosine > lamps->gate;
}

GLINT_NOINLINE void glint_mark_rough(const glint_drawn_lamp *lamp, glint_lit_fragment *f, int32_t x, int32_t y,
                                     int32_t z, uint32_t square) {
    if (square >= lamp->rough) { /* only lights with a cone get here: the distance from its axis decides */
        const int16_t *axis = lamp->source->direction;
        const int32_t axial = glint_shift_right(axis[0] * x + axis[1] * y + axis[2] * z, 15);
        if (axial <= 0 || (int32_t)(square - (uint32_t)axial * (uint32_t)axial) >=
                              4 * (int32_t)glint_least((int32_t)lamp->rough, INT32_MAX / 4))
            return;
    }
    f->is_rough = 1;
}

/* ---- Interface of lamps ---- */

const glint_places glint_lamp_places = {bring_to_unit, find_corner_ways, find_fine_way};

#if GLINT_SMALL
int glint_arrive_from_place(const glint_lamps *lamps, const glint_drawn_lamp *lamp, glint_lit_view *view,
                            glint_arrival *to) {
    return arrive_from_place(lamps, lamp, view, to, lamps->has_gloss);
}

int glint_arrive_from_direction(const glint_lamps *lamps, const glint_drawn_lamp *lamp, glint_lit_view *view,
                                glint_arrival *to) {
    return arrive_from_direction(lamps, lamp, view, to, lamps->has_gloss);
}
#endif
