/* SPDX-License-Identifier: MIT */
/* Rows: what a region's terms make of pixels that follow each other. */
#include "light.h"
#include "terms.h"

/* 1 / |M|, Q15, of pixels; or null: then it is 1. */
typedef const uint16_t *inverses;

static inline int32_t over(int32_t number, inverses inverse, uint32_t i) {
    return inverse ? glint_shift_right(number * inverse[i], 15) : number;
}

static inline void go_on(glint_progress *p) {
    p->value += p->step;
    p->step += p->turn;
}

static void find_inverses(glint_progress square, uint32_t count, uint16_t *inverse) {
    for (uint32_t i = 0; i < count; i++, go_on(&square)) {
        const int32_t entry = glint_shift_right((int32_t)square.value, 20) - 256; /* M.M is Q30 */
        inverse[i] = glint_root_table[glint_least(glint_most(entry, 0), 767)];
    }
}

/* Sets colours to a base and a sum of one chroma. */
static void begin_with_chroma(glint_progress sum, const int32_t base[3], const int32_t chroma[3], unsigned up,
                              inverses inverse, uint32_t count, int32_t (*row)[3]) {
    const int32_t red = base[0], green = base[1], blue = base[2];
    const int32_t by_red = chroma[0] << up, by_green = chroma[1] << up, by_blue = chroma[2] << up;
    for (uint32_t i = 0; i < count; i++, row++, go_on(&sum)) {
        const int32_t amount = over(glint_shift_right((int32_t)sum.value, 16), inverse, i);
        (*row)[0] = red + amount * by_red;
        (*row)[1] = green + amount * by_green;
        (*row)[2] = blue + amount * by_blue;
    }
}

/* Sets colours to a base and three channels. */
static void begin_with_channels(const glint_progress sum[3], const int32_t base[3], uint32_t count, int32_t (*row)[3]) {
    glint_progress red = sum[0], green = sum[1], blue = sum[2];
    red.value += (uint32_t)base[0];
    green.value += (uint32_t)base[1];
    blue.value += (uint32_t)base[2];
    for (int32_t(*const end)[3] = row + count; row != end; row++) {
        (*row)[0] = (int32_t)red.value;
        (*row)[1] = (int32_t)green.value;
        (*row)[2] = (int32_t)blue.value;
        go_on(&red);
        go_on(&green);
        go_on(&blue);
    }
}

/* The same over |M|. */
static void begin_with_channels_over(const glint_progress sum[3], const int32_t base[3], inverses inverse,
                                     uint32_t count, int32_t (*row)[3]) {
    for (int c = 0; c < 3; c++) {
        glint_progress channel = sum[c];
        for (uint32_t i = 0; i < count; i++, go_on(&channel))
            row[i][c] = base[c] + glint_shift_right((int32_t)channel.value, 13) * (inverse[i] >> 1) / 2;
    }
}

static inline void add(int32_t colour[3], int32_t amount, const int32_t weight[3]) {
    colour[0] += amount * weight[0];
    colour[1] += amount * weight[1];
    colour[2] += amount * weight[2];
}

/* t^2 (3 - 2 t), Q15, for t Q12 in the high half, cut off at 0 and 1. */
static inline int32_t smooth_step(uint32_t value) {
    const int32_t t = glint_least(glint_most(glint_shift_right((int32_t)value, 13), 0), 1 << 15);
    return (int32_t)(((uint32_t)(t * t) >> 15) * (uint32_t)((3 << 15) - 2 * t) >> 15);
}

/* A number at pixel i of a row. */
static inline int32_t at(const glint_progress *p, uint32_t i) {
    return (int32_t)(p->value + p->step * i + p->turn * (i * (i - 1) / 2));
}

/* Adds a light where it shines. */
static void add_side(glint_progress cosine, const glint_progress *cone, const int32_t weight[3], inverses inverse,
                     uint32_t count, int32_t (*row)[3]) {
    for (uint32_t i = 0; i < count; i++, go_on(&cosine)) {
        if ((int32_t)cosine.value <= 0)
            continue;
        int32_t amount = over((int32_t)(cosine.value >> 15), inverse, i);
        if (cone)
            amount = glint_shift_right(amount * smooth_step((uint32_t)at(cone, i)), 15);
        add(row[i], amount, weight);
    }
}

/* What a light's polynomials are; null where it has none. */
typedef struct light_parts {
    const glint_progress *side, *cone, *strength, *lobe;
} light_parts;

static light_parts parts_of(const glint_apart *apart, const glint_progress *polynomials) {
    const glint_progress *next = polynomials + apart->first;
    light_parts parts;
    parts.side = apart->kinds >> GLINT_SIDE & 1 ? next++ : 0;
    parts.cone = apart->kinds >> GLINT_CONE & 1 ? next++ : 0;
    parts.strength = apart->kinds >> GLINT_STRENGTH & 1 ? next++ : 0;
    parts.lobe = apart->kinds >> GLINT_LOBE_X & 1 ? next : 0;
    return parts;
}

/* What a terminator and a cone leave of a highlight at a pixel. */
static int32_t cut(int32_t power, const light_parts *of, int is_ungated, uint32_t i) {
    if (of->side && !is_ungated && at(of->side, i) <= 0)
        return 0;
    return of->cone ? glint_shift_right(power * smooth_step((uint32_t)at(of->cone, i)), 15) : power;
}

/* Adds a highlight. */
static void add_lobe(const glint_terms *terms, const light_parts *of, const int32_t weight[3], inverses inverse,
                     uint32_t count, int32_t (*row)[3]) {
    glint_progress x = of->lobe[0], y = of->lobe[1];
    const uint32_t end = terms->light->lobe_end;
    const unsigned shift = 2 * terms->light->lobe_shift;
    const int is_cut = of->cone || (of->side && !terms->is_ungated);
    for (uint32_t i = 0; i < count; i++, go_on(&x), go_on(&y)) {
        int32_t dx = over(glint_shift_right((int32_t)x.value, 16), inverse, i);
        int32_t dy = over(glint_shift_right((int32_t)y.value, 16), inverse, i);
        if (terms->is_over_length > 1) {
            dx = over(dx, inverse, i);
            dy = over(dy, inverse, i);
        }
        const uint32_t square = (uint32_t)(dx * dx) + (uint32_t)(dy * dy);
        if (square >= end)
            continue;
        int32_t power = (int32_t)glint_power_at(terms->power, square << 2 >> shift);
        if (of->strength)
            power = glint_shift_right(power * glint_most(glint_shift_right(at(of->strength, i), 15), 0), 15);
        add(row[i], is_cut ? cut(power, of, terms->is_ungated, i) : power, weight);
    }
}

/* Adds a highlight of the cosine. */
static void add_wide_lobe(const glint_terms *terms, const light_parts *of, const int32_t weight[3], inverses inverse,
                          uint32_t count, int32_t (*row)[3]) {
    static const glint_progress whole = {1u << 30, 0, 0};
    glint_progress cosine = of->lobe[0], strength = of->strength ? *of->strength : whole;
    const int32_t at_zero = (int32_t)glint_power_of_zero(terms->power), red = weight[0], green = weight[1],
                  blue = weight[2];
    const int is_cut = of->cone || (of->side && !terms->is_ungated);
    for (uint32_t i = 0; i < count; i++, row++, go_on(&cosine), go_on(&strength)) {
        int32_t x = over(glint_shift_right((int32_t)cosine.value, 15), inverse, i);
        if (terms->is_over_length > 1)
            x = over(x, inverse, i);
        if (x <= 0 && !at_zero)
            continue;
        int32_t power =
            x > 0 ? (int32_t)glint_power_of_cosine(terms->power, (uint32_t)glint_least(x, INT16_MAX) << 16) : at_zero;
        power = glint_shift_right(power * glint_most(glint_shift_right((int32_t)strength.value, 15), 0), 15);
        if (is_cut)
            power = cut(power, of, terms->is_ungated, i);
        (*row)[0] += power * red;
        (*row)[1] += power * green;
        (*row)[2] += power * blue;
    }
}

/* Multiplies what there is by the surface's colours, and adds half a level. */
static void multiply_by_surface(const glint_progress surface[3], const int32_t half[3], uint32_t count,
                                int32_t (*row)[3]) {
    for (int c = 0; c < 3; c++) {
        glint_progress colour = surface[c];
        for (uint32_t i = 0; i < count; i++, go_on(&colour))
            row[i][c] = glint_shift_right(row[i][c], 12) * glint_shift_right((int32_t)colour.value, 18) + half[c];
    }
}

/* Makes colours no less than ambient light, and the surface's colour of it. */
static void raise_to_ambient(const glint_terms *terms, const glint_progress *surface, uint32_t count,
                             int32_t (*row)[3]) {
    for (int c = 0; c < 3; c++) {
        int32_t ambient = terms->light->ambient[c];
        for (uint32_t i = 0; i < count; i++) {
            const int32_t least = terms->has_surface
                                      ? glint_shift_right(ambient, 12) * glint_shift_right(at(&surface[c], i), 18)
                                      : ambient;
            row[i][c] = glint_most(row[i][c], least + terms->light->half[c]);
        }
    }
}

/* Sets colours to sums of light, and what is added to all. */
static void begin(const glint_terms *terms, const glint_progress *sum, inverses inverse, uint32_t count,
                  int32_t (*row)[3]) {
    const glint_light_terms *light = terms->light;
    int32_t base[3];
    for (int c = 0; c < 3; c++) {
        base[c] = terms->has_surface || (terms->is_channels && !inverse) ? 0 : light->half[c];
        base[c] += terms->is_channels || terms->takes_largest ? 0 : light->ambient[c];
    }
    if (!terms->is_channels && light->channels == 1)
        begin_with_chroma(sum[0], base, light->chroma, light->sum_bits, inverse, count, row);
    else if (inverse)
        begin_with_channels_over(sum, base, inverse, count, row);
    else
        begin_with_channels(sum, base, count, row);
}

void glint_terms_row(const glint_terms *terms, const glint_progress *polynomials, uint32_t count, int32_t (*row)[3]) {
    const glint_light_terms *light = terms->light;
    uint16_t inverse_of[GLINT_TILE_MAX];
    inverses inverse = terms->is_over_length ? inverse_of : 0;
    if (inverse)
        find_inverses(polynomials[GLINT_SQUARE], count, inverse_of);
    begin(terms, polynomials, inverse, count, row);
    for (uint32_t i = 0; i < terms->apart_count; i++) {
        const light_parts parts = parts_of(&terms->apart[i], polynomials);
        if (parts.side)
            add_side(*parts.side, parts.cone, light->diffuse[terms->apart[i].light], inverse, count, row);
    }
    if (terms->has_surface)
        multiply_by_surface(polynomials + GLINT_SURFACE, light->half, count, row);
    for (uint32_t i = 0; i < terms->apart_count; i++) {
        const light_parts parts = parts_of(&terms->apart[i], polynomials);
        if (parts.lobe && terms->light->lobe_is_wide)
            add_wide_lobe(terms, &parts, light->specular[terms->apart[i].light], inverse, count, row);
        else if (parts.lobe)
            add_lobe(terms, &parts, light->specular[terms->apart[i].light], inverse, count, row);
    }
    if (terms->takes_largest)
        raise_to_ambient(terms, polynomials + GLINT_SURFACE, count, row);
}
