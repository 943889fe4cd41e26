/* SPDX-License-Identifier: MIT */
/* Computes the light that fragments reflect towards the eye, for each model; lamps.h. */
#include "../math/division.h"
#include "../math/product.h"
#include "arrive.h"
#include "wear.h"

/* ---- Powers of cosines ---- */

/* Returns floor(n / d), n below d 2^15, d from 1 to 2^16. */
static inline uint32_t divide_small(uint32_t n, uint32_t d) {
    if (GLINT_DIVIDES)
        return n / d;
    const uint32_t zeros = d >> 15 ? 0 : glint_leading_zeros(d) - 16;
    uint32_t quotient = (n >> (15 - zeros)) * (uint32_t)glint_reciprocal16(d << zeros) >> 16;
    int32_t rest = (int32_t)(n - quotient * d);
    for (; rest < 0; rest += (int32_t)d)
        quotient--;
    for (; rest >= (int32_t)d; rest -= (int32_t)d)
        quotient++;
    return quotient;
}

/* Returns cos^p, Q15, given sin^2 = 1 - cos^2, Q15, for exponents that are not narrow. */
static inline uint32_t power_of(const glint_lamps *lamps, uint32_t sine_square) {
    const uint32_t index = sine_square << lamps->power_up; /* Q16 */
    const uint16_t *node = &lamps->power[index >> 16];
    return (uint32_t)(node[0] - glint_shift_right((node[0] - node[1]) * (int32_t)(index & 0xffff), 16));
}

/* Returns cos^p, Q15, given sin^2 = 1 - cos^2, Q30, for exponents from 2 on. */
static uint32_t power_of_narrow(const glint_power_table *table, uint32_t sine_square) {
    if (sine_square >= table->window)
        return 0;
    const uint16_t *node = &table->value[sine_square >> table->index_shift];
    const uint32_t fraction =
        sine_square >> (table->index_shift - GLINT_POWER_FRACTION_BITS) & ((1u << GLINT_POWER_FRACTION_BITS) - 1);
    return (uint32_t)(node[0] - glint_shift_right((node[0] - node[1]) * (int32_t)fraction, GLINT_POWER_FRACTION_BITS));
}

/* Returns cos^p, Q15, for exponents below 2. The cosine is over / sqrt(2 under), `over` Q15 and `under` Q15; cosines of
 * 0 and less give 0^p. */
static GLINT_NOINLINE uint32_t power_by_logarithm(const glint_power_table *table, int32_t over, int32_t under) {
    if (over <= 0 || under <= 0)
        return table->exponent ? 0 : 1u << 15;
    const int32_t logarithm = glint_log2((uint32_t)glint_least(over, 1 << 16) << 15) -
                              glint_log2((uint32_t)glint_least(under, 1 << 16) << 15) / 2;
    const int64_t y = glint_shift_right64(glint_product(glint_least(logarithm, 0), table->exponent), 16);
    return y < -31 * (int64_t)(1 << 26) ? 0 : (glint_exp2((int32_t)y) + (1u << 14)) >> 15;
}

/* ---- Fine vectors ---- */

/* Makes a vector of up to 31 bits unit, 1 = 2^17; each component is off by at most one step, and 0 stays 0. */
static GLINT_NOINLINE void make_unit(int32_t v[3]) {
    const unsigned zeros =
        glint_leading_zeros(glint_magnitude_bits(v[0]) | glint_magnitude_bits(v[1]) | glint_magnitude_bits(v[2]) | 1);
    uint32_t square = 0;
    int64_t excess = -((int64_t)1 << 36);
    for (int c = 0; c < 3; c++) {
        v[c] = zeros > 1 ? glint_shift_left(v[c], zeros - 2) : glint_shift_right(v[c], 1); /* 2^29 to 2^30 */
        const int32_t high = glint_shift_right(v[c] + (1 << 14), 15);
        square += (uint32_t)(high * high);
    }
    square = square ? square : 1u << 28;
    const unsigned up = glint_leading_zeros(square) & 2;
    const int32_t over = (int32_t)glint_over_length(square << up);
    for (int c = 0; c < 3; c++) {
        v[c] = (int32_t)glint_shift_right64(glint_product(v[c], over), 28 - up / 2); /* Q18 */
        excess += glint_product(v[c], v[c]);
    }
    const int32_t half_excess = (int32_t)glint_shift_right64(excess, 12); /* Q25; this is a step of Newton's method */
    for (int c = 0; c < 3; c++)
        v[c] = glint_shift_right(v[c] + 1 - (int32_t)glint_shift_right64(glint_product(v[c], half_excess), 25), 1);
}

/* A highlight is a power of the cosine between these two vectors, 1 = 2^17; the first is unit. */
typedef struct lobe {
    int32_t a[3], b[3];
} lobe;

/* Finds the vectors of a fragment's highlight with 17 bits: N and L + V, or V and the mirrored L. */
static GLINT_NOINLINE void find_lobe(const glint_lamps *lamps, const glint_drawn_lamp *lamp, const glint_lit_view *view,
                                     int is_mirror, lobe *to) {
    const glint_lit_fragment *f = view->fragment;
    const glint_row_walk *walk = lamps->walk;
    int32_t n[3], v[3] = {0, 0, 1 << 17}, l[3];
    for (int c = 0; c < 3; c++) {
        n[c] = glint_lamp_plane(&walk->channel[c], glint_fragment_row(f), glint_fragment_column(f)) - (1 << 14);
        l[c] = lamp->source->direction[c];
    }
    if (lamps->is_local) {
        glint_find_fine_ray(lamps, f, v);
        make_unit(v);
    }
    if (lamp->has_place)
        lamps->placed->find_fine_way(lamps, lamp, view, l);
    make_unit(n);
    make_unit(l);
    const int64_t dot = glint_product(n[0], l[0]) + glint_product(n[1], l[1]) + glint_product(n[2], l[2]);
    const int32_t twice = (int32_t)glint_shift_right64(dot, 16); /* 2 N.L, Q17 */
    for (int c = 0; c < 3; c++) {
        to->a[c] = is_mirror ? v[c] : n[c];
        to->b[c] = is_mirror ? (int32_t)glint_shift_right64(glint_product(n[c], twice), 17) - l[c] : l[c] + v[c];
    }
}

/* Returns a component of the cross product of a lobe's vectors, Q29. */
static inline int32_t lobe_cross_product(const lobe *vectors, int i, int j) {
    return (int32_t)glint_shift_right64(
        glint_product(vectors->a[i], vectors->b[j]) - glint_product(vectors->a[j], vectors->b[i]), 5);
}

/* Returns sin^2 between a lobe's vectors, Q30, by their cross product: its relative error is small, so that small
 * angles keep their bits. */
static uint32_t sine_square_of(const lobe *vectors) {
    int32_t x = lobe_cross_product(vectors, 1, 2), y = lobe_cross_product(vectors, 2, 0),
            z = lobe_cross_product(vectors, 0, 1);
    uint32_t under = 0; /* the square of the second vector, Q28 */
    for (int c = 0; c < 3; c++) {
        const int32_t b = glint_shift_right(vectors->b[c] + 4, 3);
        under += (uint32_t)(b * b);
    }
    if (under < 1u << 12)
        return 1u << 30;
    const uint32_t bits = glint_magnitude_bits(x) | glint_magnitude_bits(y) | glint_magnitude_bits(z);
    const unsigned zeros = glint_leading_zeros(bits | 1), down = zeros < 17 ? 17 - zeros : 0; /* below 2^15 */
    x = glint_shift_right(x, down), y = glint_shift_right(y, down), z = glint_shift_right(z, down);
    const uint32_t square = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z);
    /* square 4^down 2^-58 over under 2^-28, Q30 */
    const unsigned up = glint_leading_zeros(square | 1), under_up = glint_leading_zeros(under);
    const uint32_t ratio = (square << up >> 16) * (uint32_t)glint_reciprocal16(under << under_up >> 16); /* 2^31 of 1 */
    const int shift = 31 + (int)up - (int)(under_up + 2 * down);
    if (shift >= 32)
        return 0;
    return shift > 0 ? ratio >> shift : 1u << 30;
}

/* Returns the cosine between N and L + V, Q15, also where the light is nearly opposite to the viewer. */
static int32_t lobe_cosine(const lobe *vectors) {
    int32_t cosine = 0;
    int16_t half[3];
    if ((glint_magnitude_bits(vectors->b[0]) | glint_magnitude_bits(vectors->b[1]) |
         glint_magnitude_bits(vectors->b[2])) < 32)
        return 0; /* the light is straight behind: the direction of L + V is nothing but rounding */
    glint_unit(vectors->b[0], vectors->b[1], vectors->b[2], half);
    for (int c = 0; c < 3; c++)
        cosine += glint_shift_right(vectors->a[c], 2) * half[c];
    cosine = glint_shift_right(cosine, 15);
    return glint_least(cosine + glint_shift_right(cosine, 13), (1 << 15) - 1);
}

/* Ways of 15 bits are precise to 2^-12 of their length if their square is at least this. */
#define LEAST_WAY_SQUARE (1u << 24)

/* Finds the unit vector to a light, 1 = 2^15. @return 0 if the light is so near that the way to it has too few bits */
static int find_unit_way(const glint_drawn_lamp *lamp, const glint_lit_view *view, int32_t l[3]) {
    uint32_t square = 0;
    for (int c = 0; c < 3; c++) {
        l[c] = lamp->place[c] + (lamp->has_place ? glint_shift_right(view->e[c], lamp->down) : 0);
        square += (uint32_t)l[c] * (uint32_t)l[c];
    }
    if (!lamp->has_place)
        return 1;
    if (square < LEAST_WAY_SQUARE)
        return 0;
    const uint32_t zeros = glint_leading_zeros(square) & 30;
    const int32_t over = (int32_t)glint_over_length(square << zeros);
    for (int c = 0; c < 3; c++)
        l[c] = glint_shift_right(glint_shift_left(l[c], zeros / 2) * (over >> 1), 15);
    return 1;
}

/* Returns sin^2 between N and L + V, Q30, given L, 1 = 2^15. */
static uint32_t find_sine_square(const glint_lit_view *view, const int32_t l[3]) {
    int32_t n[3], v[3];
    for (int c = 0; c < 3; c++) {
        n[c] = glint_shift_right(view->n[c] * view->over_n, 15);
        v[c] = glint_shift_right(view->v[c] * view->over_v, 15);
    }
    return glint_sine_by_chord(n, v, l);
}

/* Returns a highlight of a narrow lobe or of an exponent below 2, Q15. */
static GLINT_NOINLINE uint32_t find_rare_power(const glint_lamps *lamps, const glint_drawn_lamp *lamp,
                                               const glint_lit_view *view, glint_arrival a, int is_mirror) {
    const glint_power_table *table = &lamps->shading->power;
    const uint32_t cut = (uint32_t)glint_most(table->cosine_square_floor, 0);
    const int32_t half_square = glint_most((1 << 15) - 2 + a.light_dot_view, 0);
    const int32_t over = is_mirror ? glint_shift_right(a.cosine * view->facing, 14) - a.light_dot_view + 2
                                   : glint_least(a.cosine + view->facing, 0xffff);
    lobe vectors;
    if (!table->direct) {
        if (over <= 0 || (uint32_t)over * (uint32_t)over < cut * (is_mirror ? 1u << 15 : 2 * (uint32_t)half_square))
            return 0;
        if (!is_mirror && table->exponent <= GLINT_CHORD_EXPONENT && find_unit_way(lamp, view, vectors.b))
            return power_of_narrow(table, find_sine_square(view, vectors.b));
        find_lobe(lamps, lamp, view, is_mirror, &vectors);
        return power_of_narrow(table, sine_square_of(&vectors));
    }
    if (is_mirror)
        return power_by_logarithm(table, 2 * (over - 2), 1 << 16);
    if ((1 << 15) + a.light_dot_view >= lamps->least_half_square)
        return power_by_logarithm(table, a.cosine + view->facing, (1 << 15) + a.light_dot_view);
    find_lobe(lamps, lamp, view, 0, &vectors);
    return power_by_logarithm(table, 2 * lobe_cosine(&vectors), 1 << 16);
}

/* ---- Highlights ---- */

/* If 1 + L.V = |L + V|^2 / 2, Q15, is at least this, L + V of 15 bits has a direction that is precise to 2^-12, as
 * glint_sine_by_chord requires it. */
#define LEAST_HALF_SQUARE (1 << 10)

/* Sums of two cosines of 15 bits may be off by this. */
#define COSINE_MARGIN 8

/* Returns whether a fragment is surely outside a highlight, given N.L + N.V and 1 + L.V, Q15. */
static inline int is_beyond(const glint_lamps *lamps, int32_t cosine_sum, int32_t half_square) {
    const int32_t most = cosine_sum + COSINE_MARGIN, least = glint_most(half_square - COSINE_MARGIN, 0);
    return most <= 0 || (most < 1 << 16 && (uint32_t)most * (uint32_t)most < lamps->cut * (uint32_t)least);
}

/* Returns a highlight around the half vector that is rare, or whose L + V is short, Q15. */
static GLINT_NOINLINE uint32_t find_odd_power(const glint_lamps *lamps, const glint_drawn_lamp *lamp,
                                              const glint_lit_view *view, glint_arrival a) {
    const glint_power_table *table = &lamps->shading->power;
    lobe vectors;
    if (lamps->is_rare)
        return find_rare_power(lamps, lamp, view, a, 0);
    if (is_beyond(lamps, a.cosine + view->facing, (1 << 15) + a.light_dot_view))
        return 0;
    if ((1 << 15) + a.light_dot_view >= LEAST_HALF_SQUARE && find_unit_way(lamp, view, vectors.b))
        return power_of_narrow(table, find_sine_square(view, vectors.b));
    find_lobe(lamps, lamp, view, 0, &vectors);
    const int32_t cosine = lobe_cosine(&vectors);
    const uint32_t square = (uint32_t)(cosine * cosine), cut = (uint32_t)glint_most(table->cosine_square_floor, 0)
                                                               << 15;
    return cosine > 0 && square >= cut ? power_of(lamps, ((1u << 30) - square) >> 15) : 0;
}

/*
 * Returns the highlight of Blinn-Phong, Q15, without making a half vector: N.H = (N.L + N.V) / sqrt(2 + 2 L.V). Two
 * steps are taken from 1 + L.V, as cutting off has taken them from N.L + N.V.
 */
static GLINT_INLINE uint32_t find_half_power(const glint_lamps *lamps, const glint_drawn_lamp *lamp,
                                             const glint_lit_view *view, glint_arrival a) {
    const uint32_t half_square = (uint32_t)((1 << 15) - 2 + a.light_dot_view) | 1; /* |L + V|^2 / 2 */
    uint32_t cosine_sum = (uint32_t)(a.cosine + view->facing);
    if (GLINT_RARELY((int32_t)half_square < lamps->usual_half_square)) {
        return find_odd_power(lamps, lamp, view, a);
    }
    if (GLINT_RARELY(cosine_sum > 0xffff)) {
        if ((int32_t)cosine_sum < 0)
            return 0;
        cosine_sum = 0xffff;
    }
    const uint32_t square = cosine_sum * cosine_sum;
    if (square < lamps->cut * half_square)
        return 0;
    const int32_t rest = (int32_t)((half_square << 15) - (square >> 1));
    return power_of(lamps, rest < 0 ? 0 : divide_small((uint32_t)rest, half_square));
}

/* Returns the highlight of Phong, Q15: R.V = 2 N.L N.V - L.V, and two steps for what cutting off has taken away. */
static GLINT_INLINE uint32_t find_mirror_power(const glint_lamps *lamps, const glint_drawn_lamp *lamp,
                                               const glint_lit_view *view, glint_arrival a) {
    if (GLINT_RARELY(lamps->is_rare)) {
        return find_rare_power(lamps, lamp, view, a, 1);
    }
    const int32_t mirrored = glint_shift_right(a.cosine * view->facing, 14) - a.light_dot_view + 2;
    const uint32_t square = (uint32_t)(mirrored * mirrored);
    if (mirrored <= 0 || square < lamps->cut << 14)
        return 0;
    return power_of(lamps, square < 1u << 30 ? ((1u << 30) - square) >> 15 : 0);
}

/* ---- Reflected light ---- */

enum { MATT, HALF, MIRROR };

/* Adds what a fragment reflects of a light to its colour. Highlights go to `gloss` if the surface has colours of its
 * own, as these do not multiply highlights. */
static GLINT_INLINE void reflect(const glint_lamps *lamps, const glint_drawn_lamp *lamp, const glint_lit_view *view,
                                 const glint_arrival *a, int32_t colour[3], int32_t gloss[3], int model) {
    int32_t power = 0;
    if (model != MATT && lamp->shines)
        power = (int32_t)(model == HALF ? find_half_power(lamps, lamp, view, *a)
                                        : find_mirror_power(lamps, lamp, view, *a));
    const int32_t amount = (int32_t)((uint32_t)glint_most(a->cosine, 0) * a->strength >> 15);
    int32_t red = colour[0] + amount * lamp->diffuse[0], green = colour[1] + amount * lamp->diffuse[1],
            blue = colour[2] + amount * lamp->diffuse[2];
    if (power) {
        power = (int32_t)((uint32_t)power * a->strength >> 15);
        if (GLINT_RARELY(lamps->has_colours)) {
            for (int c = 0; c < 3; c++)
                gloss[c] += power * lamp->specular[c];
        } else {
            red += power * lamp->specular[0];
            green += power * lamp->specular[1];
            blue += power * lamp->specular[2];
        }
    }
    colour[0] = red, colour[1] = green, colour[2] = blue;
}

/* Brings N, which is short or long, to 15 bits. Its components come with 30 bits, and half a step of 15 bits is added
 * already. @return the square of its length */
static GLINT_INLINE uint32_t lengthen_normal(glint_lit_view *view, int32_t nx, int32_t ny, int32_t nz,
                                             uint32_t square) {
    const unsigned up = (glint_leading_zeros(square | 1) - 2) >> 1, down = square >> 30 ? 16 : up < 15 ? 15 - up : 0;
    const int32_t half = (1 << down >> 1) - (1 << 14); /* replaces the half step of 15 bits, so that 0 stays 0 */
    const int32_t x = glint_shift_right(nx + half, down), y = glint_shift_right(ny + half, down),
                  z = glint_shift_right(nz + half, down);
    square = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z);
    view->n[0] = x, view->n[1] = y, view->n[2] = z;
    return square < 1u << 28 ? 1u << 28 : square < 1u << 30 ? square : (1u << 30) - 1;
}

/* Sets N, of 15 bits, and V of a fragment. */
static GLINT_INLINE void find_normal_and_ray(const glint_row_walk *walk, const glint_lamps *lamps,
                                             glint_lit_fragment *f, glint_lit_view *view) {
    const int32_t row = glint_fragment_row(f), column = glint_fragment_column(f);
    const int32_t nx = glint_lamp_plane(&walk->channel[0], row, column),
                  ny = glint_lamp_plane(&walk->channel[1], row, column),
                  nz = glint_lamp_plane(&walk->channel[2], row, column);
    const int32_t x = glint_shift_right(nx, 15), y = glint_shift_right(ny, 15), z = glint_shift_right(nz, 15);
    uint32_t square = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z);
    view->fragment = f;
    view->n[0] = x, view->n[1] = y, view->n[2] = z;
    if (GLINT_RARELY(square - (1u << 28) >= 3u << 28))
        square = lengthen_normal(view, nx, ny, nz, square);
    view->over_n = (int32_t)glint_over_length(square << 2);
    view->v[0] = glint_shift_right(lamps->x - lamps->step * column, 12);
    view->v[1] = glint_shift_right(lamps->y + lamps->step * row, 12);
    view->v[2] = glint_shift_right(lamps->z, 12);
}

/* Finds the place of a fragment, and brings lights to its unit. */
static GLINT_INLINE void find_place(const glint_row_walk *walk, const glint_lamps *lamps, glint_lit_view *view) {
    const int32_t inverse_w = view->fragment->inverse_w;
    const uint32_t least = lamps->least_w;
    if (GLINT_RARELY((uint32_t)inverse_w - least >= least)) {
        glint_find_other_w(walk, view);
    } else {
        view->w = glint_reciprocal16((uint32_t)inverse_w << lamps->up >> 16);
    }
    for (int c = 0; c < 3; c++)
        view->e[c] = view->v[c] * view->w;
}

/* Brings V to 15 bits, once the place is found, and finds N.V. */
static GLINT_INLINE void find_facing(const glint_lamps *lamps, glint_lit_view *view) {
    const uint32_t x = (uint32_t)view->v[0], y = (uint32_t)view->v[1],
                   z = (uint32_t)view->v[2]; /* parallel rays have more than 16 bits */
    uint32_t square = x * x + y * y + z * z;
    if (GLINT_RARELY(square < lamps->least_view)) {
        if (!lamps->is_local) {
            view->v[0] = view->v[1] = 0;
            view->v[2] = (1 << 15) - 1;
            view->over_v = 1 << 15;
            view->facing = glint_shift_right(view->n[2] * view->over_n, 15);
            return;
        }
        square = glint_lengthen_view(view, square);
    }
    const uint32_t over = glint_over_length(square << 2);
    const int32_t dot =
        glint_shift_right(view->n[0] * view->v[0] + view->n[1] * view->v[1] + view->n[2] * view->v[2], 15);
    view->over_v = (int32_t)over;
    view->facing = glint_shift_right(dot * (int32_t)((uint32_t)view->over_n * over >> 16), 14);
}

/* Multiplies channels of light by the texture's, and those of ambient light if they are given. */
static GLINT_NOINLINE void multiply_by_texture(const glint_row_walk *walk, const glint_lit_fragment *f, int32_t to[3],
                                               int32_t base[3]) {
    int16_t colour[3];
    walk->draw->texture->type->stage->find(walk, glint_fragment_row(f), glint_fragment_column(f), colour);
    for (int c = 0; c < 3; c++)
        to[c] = (int32_t)(((uint32_t)to[c] >> 13) * (uint32_t)(colour[c] + 1) >> 2);
    for (int c = 0; c < 3 && base; c++)
        base[c] = (int32_t)(((uint32_t)base[c] >> 13) * (uint32_t)(colour[c] + 1) >> 2);
}

GLINT_NOINLINE void glint_mix_own_colour(const glint_row_walk *walk, glint_lit_fragment *f, int32_t w, uint32_t zeros,
                                         const int32_t gloss[3]) {
    const glint_lamps *lamps = walk->workspace->lamps;
    int32_t *const to = f->out.colour, base[3] = {lamps->base[0], lamps->base[1], lamps->base[2]};
    if (lamps->has_colours) {
        const int is_parallel = walk->frame->view->is_parallel;
        w = is_parallel ? 1 << 16 : w;
        zeros = is_parallel ? 0 : zeros;
        if (walk->draw->extra) {
            glint_multiply_by_own(walk->list, f, w, zeros, to);
            if (lamps->takes_most)
                glint_multiply_by_own(walk->list, f, w, zeros, base);
        }
        if (walk->list->lights_nodes) { /* in place of numbers that no longer count */
            f->out.pixel = (uint32_t)gloss[0], f->inverse_w = gloss[1], f->square = (uint32_t)gloss[2];
            return;
        }
        if (walk->draw->texture)
            multiply_by_texture(walk, f, to, lamps->takes_most ? base : 0);
    }
    to[0] += gloss[0], to[1] += gloss[1], to[2] += gloss[2];
    if (lamps->takes_most) {
        to[0] = glint_most(to[0], base[0]);
        to[1] = glint_most(to[1], base[1]);
        to[2] = glint_most(to[2], base[2]);
    }
    for (int c = 0; c < 3 && lamps->headroom; c++)
        to[c] = glint_shift_left(glint_least(to[c], (15 << GLINT_CHANNEL_BITS) >> lamps->headroom), lamps->headroom);
    to[0] += lamps->half[0], to[1] += lamps->half[1], to[2] += lamps->half[2];
}

/* Finds direction and strength of a light. A library built for size calls its type's function, so that no other one is
 * linked. */
#if GLINT_SMALL
#define ARRIVE(from, lamps, lamp, view, a, has_gloss) (lamp)->source->type->arrive(lamps, lamp, view, a)
#else
#define ARRIVE(from, lamps, lamp, view, a, has_gloss) arrive_from_##from(lamps, lamp, view, a, has_gloss)
#endif

/* Finds the colours of fragments by one kind of model. */
static GLINT_INLINE void light_fragments(const glint_row_walk *walk, glint_lit_fragment *f,
                                         const glint_lit_fragment *end, int model) {
    const glint_lamps *lamps = walk->workspace->lamps;
    int32_t gloss[3] = {0, 0, 0};
    for (; f != end; f++) {
        glint_lit_view view;
        glint_arrival a;
        find_normal_and_ray(walk, lamps, f, &view);
        if (!GLINT_RARELY(!lamps->needs_w))
            find_place(walk, lamps, &view);
        else
            view.e[0] = view.e[1] = view.e[2] = view.w = 0;
        if (model != MATT)
            find_facing(lamps, &view);
        for (int c = 0; c < 3; c++)
            f->out.colour[c] = lamps->first[c];
        for (const glint_drawn_lamp *lamp = lamps->directional; !GLINT_SMALL && GLINT_RARELY(lamp != 0);
             lamp = lamp->next)
            if (ARRIVE(direction, lamps, lamp, &view, &a, model != MATT))
                reflect(lamps, lamp, &view, &a, f->out.colour, gloss, model);
        for (const glint_drawn_lamp *lamp = lamps->positional; lamp; lamp = lamp->next)
            if (ARRIVE(place, lamps, lamp, &view, &a, model != MATT))
                reflect(lamps, lamp, &view, &a, f->out.colour, gloss, model);
        if (GLINT_RARELY(lamps->is_mixed)) {
            glint_mix_own_colour(walk, f, view.w, lamps->up, gloss);
            gloss[0] = gloss[1] = gloss[2] = 0;
        }
    }
}

GLINT_HOT void glint_reflect_matt(const glint_row_walk *walk, glint_lit_fragment *f, const glint_lit_fragment *end) {
    light_fragments(walk, f, end, MATT);
}

GLINT_HOT void glint_reflect_half(const glint_row_walk *walk, glint_lit_fragment *f, const glint_lit_fragment *end) {
    light_fragments(walk, f, end, HALF);
}

GLINT_HOT void glint_reflect_mirror(const glint_row_walk *walk, glint_lit_fragment *f, const glint_lit_fragment *end) {
    light_fragments(walk, f, end, MIRROR);
}

/* ---- Fragments ---- */

/* Finds the colours of fragments that no light reaches: ambient light alone. */
static GLINT_NOINLINE void show_ambient(const glint_row_walk *walk, glint_lit_fragment *f,
                                        const glint_lit_fragment *end) {
    static const int32_t gloss[3] = {0, 0, 0};
    const glint_lamps *lamps = walk->workspace->lamps;
    for (; f != end; f++) {
        for (int c = 0; c < 3; c++)
            f->out.colour[c] = lamps->first[c];
        if (lamps->is_mixed) {
            const uint32_t zeros = glint_leading_zeros((uint32_t)f->inverse_w | 1);
            glint_mix_own_colour(walk, f, glint_reciprocal16((uint32_t)f->inverse_w << zeros >> 16), zeros, gloss);
        }
    }
}

/* Finds 1/w of the fragments of a far triangle, with more bits than depth has. */
static GLINT_NOINLINE void find_far_depths(const glint_row_walk *walk, glint_lit_fragment *f,
                                           const glint_lit_fragment *end) {
    for (; f != end; f++)
        f->inverse_w = glint_most(glint_lamp_plane(&walk->w, glint_fragment_row(f), glint_fragment_column(f)), 1);
}

void glint_lamps_light(const glint_row_walk *walk, glint_lit_fragment *f, const glint_lit_fragment *end) {
    const glint_lamps *lamps = walk->workspace->lamps;
    if (walk->list->room)
        find_far_depths(walk, f, end);
    if (lamps->directional || lamps->positional)
        lamps->shading->material->model->reflect(walk, f, end);
    else
        show_ambient(walk, f, end);
}
