/* SPDX-License-Identifier: MIT */
/* Reflect: adds what fragments reflect of a light; lamps.h. */
#include "../math/division.h"
#include "../math/product.h"
#include "arrive.h"

/* ---- Powers of cosines ---- */

/* floor(n / d), n below d 2^15, d from 1 to 2^16. */
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

/* cos^p, Q15, of 1 - cos^2, Q15, for exponents that are not narrow. */
static inline uint32_t power_of(const glint_lamps *lamps, uint32_t sine) {
    const uint32_t at = sine << lamps->power_up;
    const uint16_t *node = &lamps->power[at >> 16];
    return (uint32_t)(node[0] - glint_shift_right((node[0] - node[1]) * (int32_t)(at & 0xffff), 16));
}

/* Returns cos^p, Q15, of 1 - cos^2, Q30, for exponents from 2 on. */
static uint32_t power_of_narrow(const glint_power_table *table, uint32_t sine) {
    if (sine >= table->window)
        return 0;
    const uint16_t *node = &table->value[sine >> table->index_shift];
    const uint32_t fraction =
        sine >> (table->index_shift - GLINT_POWER_FRACTION_BITS) & ((1u << GLINT_POWER_FRACTION_BITS) - 1);
    return (uint32_t)(node[0] - glint_shift_right((node[0] - node[1]) * (int32_t)fraction, GLINT_POWER_FRACTION_BITS));
}

/* cos^p, Q15, of exponents below 2: over / sqrt(under), Q15 and Q16 of a half, is the cosine. */
static GLINT_NOINLINE uint32_t power_by_logarithm(const glint_power_table *table, int32_t over, int32_t under) {
    if (over <= 0 || under <= 0)
        return table->exponent ? 0 : 1u << 15;
    const int32_t logarithm =
        glint_log2((uint32_t)glint_least(over, 1 << 16) << 15) - glint_log2((uint32_t)under << 15) / 2;
    const int64_t y = glint_shift_right64(glint_product(glint_least(logarithm, 0), table->exponent), 16);
    return y < -31 * (int64_t)(1 << 26) ? 0 : (glint_exp2((int32_t)y) + (1u << 14)) >> 15;
}

/* ---- Fine vectors ---- */

/* Makes a vector of up to 31 bits unit, 1 = 2^17; components are off by a step, and 0 stays 0. */
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
    const int32_t more = (int32_t)glint_shift_right64(excess, 12); /* Q25 of a half; one step of Newton's */
    for (int c = 0; c < 3; c++)
        v[c] = glint_shift_right(v[c] + 1 - (int32_t)glint_shift_right64(glint_product(v[c], more), 25), 1);
}

/* Two vectors, 1 = 2^17, whose cosine a highlight is a power of: the first is unit. */
typedef struct lobe {
    int32_t a[3], b[3];
} lobe;

/* Finds N and L + V of a fragment and a light, or V and the mirrored L. */
static GLINT_NOINLINE void find_lobe(const glint_lamps *lamps, const glint_drawn_lamp *lamp, const glint_lit_view *s,
                                     int is_mirror, lobe *to) {
    const glint_lit_fragment *f = s->at;
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
        lamps->placed->find_fine_way(lamps, lamp, s, l);
    make_unit(n);
    make_unit(l);
    const int64_t dot = glint_product(n[0], l[0]) + glint_product(n[1], l[1]) + glint_product(n[2], l[2]);
    const int32_t cosine = (int32_t)glint_shift_right64(dot, 16); /* twice that, Q17 */
    for (int c = 0; c < 3; c++) {
        to->a[c] = is_mirror ? v[c] : n[c];
        to->b[c] = is_mirror ? (int32_t)glint_shift_right64(glint_product(n[c], cosine), 17) - l[c] : l[c] + v[c];
    }
}

/* Returns a component of the product of a lobe's vectors, Q29. */
static inline int32_t lobe_product(const lobe *of, int i, int j) {
    return (int32_t)glint_shift_right64(glint_product(of->a[i], of->b[j]) - glint_product(of->a[j], of->b[i]), 5);
}

/* Returns 1 - cos^2, Q30, by the product of both vectors, which is exact to a part of itself. */
static uint32_t sine_by_product(const lobe *of) {
    int32_t x = lobe_product(of, 1, 2), y = lobe_product(of, 2, 0), z = lobe_product(of, 0, 1);
    uint32_t under = 0; /* Q28 */
    for (int c = 0; c < 3; c++) {
        const int32_t b = glint_shift_right(of->b[c] + 4, 3);
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

/* Returns the cosine of N and L + V, Q15, where the light is nearly opposed to the viewer. */
static int32_t lobe_cosine(const lobe *of) {
    int32_t cosine = 0;
    int16_t half[3];
    if ((glint_magnitude_bits(of->b[0]) | glint_magnitude_bits(of->b[1]) | glint_magnitude_bits(of->b[2])) < 32)
        return 0; /* straight from behind: rounding alone gives a direction */
    glint_unit(of->b[0], of->b[1], of->b[2], half);
    for (int c = 0; c < 3; c++)
        cosine += glint_shift_right(of->a[c], 2) * half[c];
    cosine = glint_shift_right(cosine, 15);
    return glint_least(cosine + glint_shift_right(cosine, 13), (1 << 15) - 1);
}

/* The square of a way to a light, 15 bits, of which a step is 2^-12 of it. */
#define MOST_NEAR (1u << 24)

/* Finds the unit vector to a light, 1 = 2^15. @return 0 where it is so near that the way to it has too few bits */
static int find_unit_way(const glint_drawn_lamp *lamp, const glint_lit_view *s, int32_t l[3]) {
    uint32_t square = 0;
    for (int c = 0; c < 3; c++) {
        l[c] = lamp->at[c] + (lamp->has_place ? glint_shift_right(s->e[c], lamp->down) : 0);
        square += (uint32_t)l[c] * (uint32_t)l[c];
    }
    if (!lamp->has_place)
        return 1;
    if (square < MOST_NEAR)
        return 0;
    const uint32_t zeros = glint_leading_zeros(square) & 30;
    const int32_t over = (int32_t)glint_over_length(square << zeros);
    for (int c = 0; c < 3; c++)
        l[c] = glint_shift_right(glint_shift_left(l[c], zeros / 2) * (over >> 1), 15);
    return 1;
}

/* Returns 1 - cos^2 between N and L + V, Q30, given L. */
static uint32_t find_sine(const glint_lit_view *s, const int32_t l[3]) {
    int32_t n[3], v[3];
    for (int c = 0; c < 3; c++) {
        n[c] = glint_shift_right(s->n[c] * s->over_n, 15);
        v[c] = glint_shift_right(s->v[c] * s->over_v, 15);
    }
    return glint_sine_by_chord(n, v, l);
}

/* Returns the highlight of narrow lobes and of exponents below 2, Q15. */
static GLINT_NOINLINE uint32_t find_rare_power(const glint_lamps *lamps, const glint_drawn_lamp *lamp,
                                               const glint_lit_view *s, glint_arrival a, int is_mirror) {
    const glint_power_table *table = &lamps->shading->power;
    const uint32_t cut = (uint32_t)glint_most(table->cosine_square_floor, 0);
    const int32_t whole = glint_most((1 << 15) - 2 + a.along, 0);
    const int32_t over = is_mirror ? glint_shift_right(a.cosine * s->facing, 14) - a.along + 2
                                   : glint_least(a.cosine + s->facing, 0xffff);
    lobe of;
    if (!table->direct) {
        if (over <= 0 || (uint32_t)over * (uint32_t)over < cut * (is_mirror ? 1u << 15 : 2 * (uint32_t)whole))
            return 0;
        if (!is_mirror && table->exponent <= GLINT_CHORD_EXPONENT && find_unit_way(lamp, s, of.b))
            return power_of_narrow(table, find_sine(s, of.b));
        find_lobe(lamps, lamp, s, is_mirror, &of);
        return power_of_narrow(table, sine_by_product(&of));
    }
    if (is_mirror)
        return power_by_logarithm(table, 2 * (over - 2), 1 << 16);
    if ((1 << 15) + a.along >= lamps->least_whole)
        return power_by_logarithm(table, a.cosine + s->facing, (1 << 15) + a.along);
    find_lobe(lamps, lamp, s, 0, &of);
    return power_by_logarithm(table, 2 * lobe_cosine(&of), 1 << 16);
}

/* ---- Highlights ---- */

/* The least 1 + L.V, Q15, of which L + V of 15 bits tells its direction to 2^-12: as the contract asks for it. */
#define LEAST_CHORD (1 << 10)

/* What sums of two cosines of 15 bits may be off by. */
#define COSINE_MARGIN 8

/* Is a fragment surely outside a highlight, given N.L + N.V and 1 + L.V, Q15? */
static inline int is_beyond(const glint_lamps *lamps, int32_t half, int32_t whole) {
    const int32_t most = half + COSINE_MARGIN, least = glint_most(whole - COSINE_MARGIN, 0);
    return most <= 0 || (most < 1 << 16 && (uint32_t)most * (uint32_t)most < lamps->cut * (uint32_t)least);
}

/* Finds a rare highlight, or one of a half vector that is short, Q15. */
static GLINT_NOINLINE uint32_t find_odd_power(const glint_lamps *lamps, const glint_drawn_lamp *lamp,
                                              const glint_lit_view *s, glint_arrival a) {
    const glint_power_table *table = &lamps->shading->power;
    lobe of;
    if (lamps->is_rare)
        return find_rare_power(lamps, lamp, s, a, 0);
    if (is_beyond(lamps, a.cosine + s->facing, (1 << 15) + a.along))
        return 0;
    if ((1 << 15) + a.along >= LEAST_CHORD && find_unit_way(lamp, s, of.b))
        return power_of_narrow(table, find_sine(s, of.b));
    find_lobe(lamps, lamp, s, 0, &of);
    const int32_t cosine = lobe_cosine(&of);
    const uint32_t square = (uint32_t)(cosine * cosine), cut = (uint32_t)glint_most(table->cosine_square_floor, 0)
                                                               << 15;
    return cosine > 0 && square >= cut ? power_of(lamps, ((1u << 30) - square) >> 15) : 0;
}

/*
 * Blinn-Phong without a half vector: N.H = (N.L + N.V) / sqrt(2 + 2 L.V). The sum below counts as two steps less, which
 * is what cutting off takes away from that above. Q15.
 */
static GLINT_INLINE uint32_t find_half_power(const glint_lamps *lamps, const glint_drawn_lamp *lamp,
                                             const glint_lit_view *s, glint_arrival a) {
    const uint32_t whole = (uint32_t)((1 << 15) - 2 + a.along) | 1; /* where it is below 0, nothing is inside */
    uint32_t half = (uint32_t)(a.cosine + s->facing);
    if (GLINT_RARELY((int32_t)whole < lamps->usual_whole)) {
        return find_odd_power(lamps, lamp, s, a);
    }
    if (GLINT_RARELY(half > 0xffff)) {
        if ((int32_t)half < 0)
            return 0;
        half = 0xffff;
    }
    const uint32_t square = half * half;
    if (square < lamps->cut * whole)
        return 0;
    const int32_t rest = (int32_t)((whole << 15) - (square >> 1));
    return power_of(lamps, rest < 0 ? 0 : divide_small((uint32_t)rest, whole));
}

/* Phong: R.V = 2 N.L N.V - L.V, counted as two steps more. Q15. */
static GLINT_INLINE uint32_t find_mirror_power(const glint_lamps *lamps, const glint_drawn_lamp *lamp,
                                               const glint_lit_view *s, glint_arrival a) {
    if (GLINT_RARELY(lamps->is_rare)) {
        return find_rare_power(lamps, lamp, s, a, 1);
    }
    const int32_t mirrored = glint_shift_right(a.cosine * s->facing, 14) - a.along + 2;
    const uint32_t square = (uint32_t)(mirrored * mirrored);
    if (mirrored <= 0 || square < lamps->cut << 14)
        return 0;
    return power_of(lamps, square < 1u << 30 ? ((1u << 30) - square) >> 15 : 0);
}

/* ---- What is reflected ---- */

enum { MATT, HALF, MIRROR };

/* Adds what a fragment reflects of a light. */
static GLINT_INLINE void reflect(const glint_lamps *lamps, const glint_drawn_lamp *lamp, const glint_lit_view *s,
                                 const glint_arrival *a, int32_t colour[3], int32_t gloss[3], int model) {
    int32_t power = 0;
    if (model != MATT && lamp->shines)
        power = (int32_t)(model == HALF ? find_half_power(lamps, lamp, s, *a) : find_mirror_power(lamps, lamp, s, *a));
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

/* Brings N that is short or long, of 30 bits and half of what 15 bits cut off, to 15 bits. @return the square of its
 * length */
static GLINT_INLINE uint32_t lengthen_normal(glint_lit_view *s, int32_t nx, int32_t ny, int32_t nz, uint32_t square) {
    const unsigned up = (glint_leading_zeros(square | 1) - 2) >> 1, down = square >> 30 ? 16 : up < 15 ? 15 - up : 0;
    const int32_t half = (1 << down >> 1) - (1 << 14); /* in place of what was added for 15 bits: 0 stays 0 */
    const int32_t x = glint_shift_right(nx + half, down), y = glint_shift_right(ny + half, down),
                  z = glint_shift_right(nz + half, down);
    square = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z);
    s->n[0] = x, s->n[1] = y, s->n[2] = z;
    return square < 1u << 28 ? 1u << 28 : square < 1u << 30 ? square : (1u << 30) - 1;
}

/* Begins with a fragment: N of 15 bits, and the way to the eye. */
static GLINT_INLINE void begin_view(const glint_row_walk *walk, const glint_lamps *lamps, glint_lit_fragment *f,
                                    glint_lit_view *s) {
    const int32_t row = glint_fragment_row(f), column = glint_fragment_column(f);
    const int32_t nx = glint_lamp_plane(&walk->channel[0], row, column),
                  ny = glint_lamp_plane(&walk->channel[1], row, column),
                  nz = glint_lamp_plane(&walk->channel[2], row, column);
    const int32_t x = glint_shift_right(nx, 15), y = glint_shift_right(ny, 15), z = glint_shift_right(nz, 15);
    uint32_t square = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z);
    s->at = f;
    s->n[0] = x, s->n[1] = y, s->n[2] = z;
    if (GLINT_RARELY(square - (1u << 28) >= 3u << 28))
        square = lengthen_normal(s, nx, ny, nz, square);
    s->over_n = (int32_t)glint_over_length(square << 2);
    s->v[0] = glint_shift_right(lamps->x - lamps->step * column, 12);
    s->v[1] = glint_shift_right(lamps->y + lamps->step * row, 12);
    s->v[2] = glint_shift_right(lamps->z, 12);
}

/* Finds the place of a fragment; lights are brought to its unit. */
static GLINT_INLINE void find_place(const glint_row_walk *walk, const glint_lamps *lamps, glint_lit_view *s) {
    const int32_t inverse_w = s->at->inverse_w;
    const uint32_t least = lamps->least_w;
    if (GLINT_RARELY((uint32_t)inverse_w - least >= least)) {
        glint_find_other_w(walk, s);
    } else {
        s->w = glint_reciprocal16((uint32_t)inverse_w << lamps->up >> 16);
    }
    for (int c = 0; c < 3; c++)
        s->e[c] = s->v[c] * s->w;
}

/* Finds V and N.V, once the place is found. */
static GLINT_INLINE void find_facing(const glint_lamps *lamps, glint_lit_view *s) {
    const uint32_t x = (uint32_t)s->v[0], y = (uint32_t)s->v[1],
                   z = (uint32_t)s->v[2]; /* of parallel rays beyond 16 bits */
    uint32_t square = x * x + y * y + z * z;
    if (GLINT_RARELY(square < lamps->least_view)) {
        if (!lamps->is_local) {
            s->v[0] = s->v[1] = 0;
            s->v[2] = (1 << 15) - 1;
            s->over_v = 1 << 15;
            s->facing = glint_shift_right(s->n[2] * s->over_n, 15);
            return;
        }
        square = glint_lengthen_view(s, square);
    }
    const uint32_t over = glint_over_length(square << 2);
    const int32_t dot = glint_shift_right(s->n[0] * s->v[0] + s->n[1] * s->v[1] + s->n[2] * s->v[2], 15);
    s->over_v = (int32_t)over;
    s->facing = glint_shift_right(dot * (int32_t)((uint32_t)s->over_n * over >> 16), 14);
}

GLINT_NOINLINE void glint_mix_own_colour(const glint_row_walk *walk, glint_lit_fragment *f, int32_t w, uint32_t zeros,
                                         const int32_t gloss[3]) {
    const glint_lamps *lamps = walk->workspace->lamps;
    int32_t *const to = f->out.colour, base[3] = {lamps->base[0], lamps->base[1], lamps->base[2]};
    if (lamps->has_colours) {
        const int is_parallel = walk->frame->view->is_parallel;
        w = is_parallel ? 1 << 16 : w;
        zeros = is_parallel ? 0 : zeros;
        glint_multiply_by_own(walk->list, f, w, zeros, to);
        if (lamps->takes_most)
            glint_multiply_by_own(walk->list, f, w, zeros, base);
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

/* Finds what arrives of a light: a library built for size asks its type, so that no other is linked. */
#if GLINT_SMALL
#define ARRIVE(from, lamps, lamp, s, a, has_gloss) (lamp)->source->type->arrive(lamps, lamp, s, a)
#else
#define ARRIVE(from, lamps, lamp, s, a, has_gloss) arrive_##from(lamps, lamp, s, a, has_gloss)
#endif

static GLINT_INLINE void light_fragments(const glint_row_walk *walk, glint_lit_fragment *f,
                                         const glint_lit_fragment *end, int model) {
    const glint_lamps *lamps = walk->workspace->lamps;
    int32_t gloss[3] = {0, 0, 0};
    for (; f != end; f++) {
        glint_lit_view s;
        glint_arrival a;
        begin_view(walk, lamps, f, &s);
        if (!GLINT_RARELY(!lamps->needs_w))
            find_place(walk, lamps, &s);
        else
            s.e[0] = s.e[1] = s.e[2] = s.w = 0;
        if (model != MATT)
            find_facing(lamps, &s);
        for (int c = 0; c < 3; c++)
            f->out.colour[c] = lamps->first[c];
        for (const glint_drawn_lamp *lamp = lamps->along; !GLINT_SMALL && GLINT_RARELY(lamp != 0); lamp = lamp->next)
            if (ARRIVE(along, lamps, lamp, &s, &a, model != MATT))
                reflect(lamps, lamp, &s, &a, f->out.colour, gloss, model);
        for (const glint_drawn_lamp *lamp = lamps->places; lamp; lamp = lamp->next)
            if (ARRIVE(from_place, lamps, lamp, &s, &a, model != MATT))
                reflect(lamps, lamp, &s, &a, f->out.colour, gloss, model);
        if (GLINT_RARELY(lamps->is_mixed)) {
            glint_mix_own_colour(walk, f, s.w, lamps->up, gloss);
            gloss[0] = gloss[1] = gloss[2] = 0;
        }
    }
}

void glint_reflect_matt(const glint_row_walk *walk, glint_lit_fragment *f, const glint_lit_fragment *end) {
    light_fragments(walk, f, end, MATT);
}

void glint_reflect_half(const glint_row_walk *walk, glint_lit_fragment *f, const glint_lit_fragment *end) {
    light_fragments(walk, f, end, HALF);
}

void glint_reflect_mirror(const glint_row_walk *walk, glint_lit_fragment *f, const glint_lit_fragment *end) {
    light_fragments(walk, f, end, MIRROR);
}

/* ---- Fragments ---- */

/* Finds the colours of fragments that no light reaches. */
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

/* Finds 1/w of the fragments of a far triangle. */
static GLINT_NOINLINE void find_far_depths(const glint_row_walk *walk, glint_lit_fragment *f,
                                           const glint_lit_fragment *end) {
    for (; f != end; f++)
        f->inverse_w = glint_most(glint_lamp_plane(&walk->w, glint_fragment_row(f), glint_fragment_column(f)), 1);
}

void glint_lamps_light(const glint_row_walk *walk, glint_lit_fragment *f, const glint_lit_fragment *end) {
    const glint_lamps *lamps = walk->workspace->lamps;
    if (walk->list->room)
        find_far_depths(walk, f, end);
    if (lamps->along || lamps->places)
        lamps->shading->material->model->reflect(walk, f, end);
    else
        show_ambient(walk, f, end);
}
