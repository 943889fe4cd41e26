/* SPDX-License-Identifier: MIT */
/* Lights with terms of their own: what these make of pixels, run by run. */
#include "../light/model.h"
#include "lobes.h"
#include "rows.h"

/* A number at pixel i of a run. */
static inline int32_t at(const glint_descent *polynomial, const glint_run *run, uint32_t i) {
    return (int32_t)glint_progress_at(polynomial, run->x + i, run->y).value;
}

/* What a light's polynomials are; null where it has none. */
typedef struct light_parts {
    const glint_descent *side, *cone, *strength, *lobe;
} light_parts;

static inline light_parts parts_of(const glint_apart *apart, const glint_descent *polynomials) {
    const glint_descent *next = polynomials + apart->first;
    light_parts parts;
    parts.side = apart->kinds >> GLINT_SIDE & 1 ? next++ : 0;
    parts.cone = apart->kinds >> GLINT_CONE & 1 ? next++ : 0;
    parts.strength = apart->kinds >> GLINT_STRENGTH & 1 ? next++ : 0;
    parts.lobe = apart->kinds >> GLINT_LOBE_X & 1 ? next : 0;
    return parts;
}

static inline void add(int32_t colour[3], int32_t amount, const uint16_t weight[3]) {
    colour[0] += amount * weight[0];
    colour[1] += amount * weight[1];
    colour[2] += amount * weight[2];
}

/* t^2 (3 - 2 t), Q15, for t Q12 in the high half, cut off at 0 and 1. */
static inline int32_t smooth_step_at(int32_t value) {
    const int32_t t = glint_least(glint_most(glint_shift_right(value, 13), 0), 1 << 15);
    return (int32_t)(((uint32_t)(t * t) >> 15) * (uint32_t)((3 << 15) - 2 * t) >> 15);
}

/* Adds a light where it shines; `is_over` and `has_cone` are constants where this is inlined. */
static GLINT_INLINE void add_side_inline(const light_parts *of, const uint16_t weight[3], const glint_pixel_runs *to,
                                         int is_over, int has_cone) {
    int32_t(*row)[3] = to->row;
    glint_inverses inverse = to->inverse;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress cosine = glint_run_start(of->side, run, to),
                       cone = glint_run_start(has_cone ? of->cone : of->side, run, to);
        for (int32_t(*const end)[3] = row + run->count; row != end; row++, glint_progress_next(&cosine)) {
            const uint32_t over = is_over ? *inverse++ : 1u << 15;
            const int32_t within = (int32_t)cone.value;
            if (has_cone)
                glint_progress_next(&cone);
            if ((int32_t)cosine.value <= 0)
                continue;
            int32_t amount = (int32_t)(cosine.value >> 15);
            if (is_over)
                amount = glint_shift_right((int32_t)((uint32_t)amount * over), 15);
            if (has_cone)
                amount = glint_shift_right(amount * smooth_step_at(within), 15);
            add(*row, amount, weight);
        }
    }
}

static void add_side(const light_parts *of, const uint16_t weight[3], const glint_pixel_runs *to) {
    if (GLINT_SMALL)
        add_side_inline(of, weight, to, to->inverse != 0, of->cone != 0);
    else if (of->cone)
        add_side_inline(of, weight, to, to->inverse != 0, 1);
    else if (to->inverse)
        add_side_inline(of, weight, to, 1, 0);
    else
        add_side_inline(of, weight, to, 0, 0);
}

/* What distance, terminator and cone leave of a highlight at a pixel. */
static int32_t weaken(int32_t power, const light_parts *of, int is_ungated, const glint_run *run, uint32_t i) {
    if (of->side && !is_ungated && at(of->side, run, i) <= 0)
        return 0;
    if (of->strength)
        power = glint_shift_right(power * glint_most(glint_shift_right(at(of->strength, run, i), 15), 0), 15);
    return of->cone ? glint_shift_right(power * smooth_step_at(at(of->cone, run, i)), 15) : power;
}

/*
 * A power table over squared deviations as these are kept: glint_power_at of them. Its window is no less than 1/15 of
 * where lobes end, to which deviations are kept with 24 bits: no shift is below 0.
 */
typedef struct lobe_table {
    const uint16_t *value;
    uint32_t end;             /* beyond, the power is 0 or need not show */
    unsigned index, fraction; /* shifts */
} lobe_table;

static lobe_table table_of(const glint_terms *terms) {
    const glint_power_table *power = terms->power;
    const unsigned kept = 2 * terms->light->lobe_shift; /* u, Q30, is 4 times a square, over 2^kept */
    const uint32_t window = power->window >> 2 << kept, end = terms->light->lobe_end;
    const unsigned index = power->index_shift + kept - 2;
    return (lobe_table){power->value, end < window ? end : window, index, index - GLINT_POWER_FRACTION_BITS};
}

static inline int32_t power_of_square(const lobe_table *table, uint32_t square) {
    const uint16_t *const node = &table->value[square >> table->index];
    const int32_t fraction = (int32_t)(square >> table->fraction & ((1u << GLINT_POWER_FRACTION_BITS) - 1));
    return node[0] + glint_shift_right((node[1] - node[0]) * fraction, GLINT_POWER_FRACTION_BITS);
}

/* Adds a highlight; how numbers are over length, and whether it is weakened, are constants where this is inlined. */
static GLINT_INLINE void add_lobe_inline(const glint_terms *terms, const light_parts *of, const uint16_t weight[3],
                                         const glint_pixel_runs *to, uint32_t times_over, int is_weak) {
    const lobe_table table = table_of(terms);
    int32_t(*row)[3] = to->row;
    glint_inverses inverse = to->inverse;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress x = glint_run_start(&of->lobe[0], run, to), y = glint_run_start(&of->lobe[1], run, to);
        int32_t(*const begin)[3] = row;
        for (int32_t(*const end)[3] = row + run->count; row != end;
             row++, glint_progress_next(&x), glint_progress_next(&y)) {
            int32_t dx = glint_shift_right((int32_t)x.value, 16), dy = glint_shift_right((int32_t)y.value, 16);
            const int32_t over = times_over ? *inverse++ : 0;
            uint32_t square = (uint32_t)(dx * dx) + (uint32_t)(dy * dy);
            if (square >= table.end) /* it grows over length: glint_root_table has nothing below 1 */
                continue;
            if (times_over) {
                for (uint32_t n = times_over; n; n--) {
                    dx = glint_shift_right(dx * over, 15);
                    dy = glint_shift_right(dy * over, 15);
                }
                square = (uint32_t)(dx * dx) + (uint32_t)(dy * dy);
                if (square >= table.end)
                    continue;
            }
            const int32_t power = power_of_square(&table, square);
            add(*row, is_weak ? weaken(power, of, terms->is_ungated, run, (uint32_t)(row - begin)) : power, weight);
        }
    }
}

static void add_lobe(const glint_terms *terms, const light_parts *of, const uint16_t weight[3],
                     const glint_pixel_runs *to) {
    if (GLINT_SMALL || terms->is_over_length > 1)
        add_lobe_inline(terms, of, weight, to, terms->is_over_length, 1);
    else if (terms->is_over_length)
        add_lobe_inline(terms, of, weight, to, 1, 1);
    else if (of->side || of->strength || of->cone)
        add_lobe_inline(terms, of, weight, to, 0, 1);
    else
        add_lobe_inline(terms, of, weight, to, 0, 0);
}

/* Adds a highlight of the cosine. */
static void add_wide_lobe(const glint_terms *terms, const light_parts *of, const uint16_t weight[3],
                          const glint_pixel_runs *to) {
    static const glint_progress whole = {1u << 30, 0, 0};
    light_parts cut = *of; /* for what the strength does not do */
    cut.strength = 0;
    const int is_cut = of->cone || (of->side && !terms->is_ungated);
    const int32_t at_zero = (int32_t)glint_power_of_zero(terms->power), red = weight[0], green = weight[1],
                  blue = weight[2];
    const uint16_t *const powers = terms->light->cosine;
    int32_t(*row)[3] = to->row;
    glint_inverses inverse = to->inverse;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress cosine = glint_run_start(of->lobe, run, to),
                       strength = of->strength ? glint_run_start(of->strength, run, to) : whole;
        for (uint32_t i = 0; i < run->count; i++, row++, glint_progress_next(&cosine), glint_progress_next(&strength)) {
            int32_t x = glint_shift_right((int32_t)cosine.value, 15);
            if (inverse) {
                for (uint32_t n = terms->is_over_length; n; n--)
                    x = glint_shift_right(x * *inverse, 15);
                inverse++;
            }
            if (x <= 0 && !at_zero)
                continue;
            int32_t power =
                x > 0 ? (int32_t)glint_power_of_cosine(powers, (uint32_t)glint_least(x, INT16_MAX) << 16) : at_zero;
            power = glint_shift_right(power * glint_most(glint_shift_right((int32_t)strength.value, 15), 0), 15);
            if (is_cut)
                power = weaken(power, &cut, terms->is_ungated, run, i);
            (*row)[0] += power * red;
            (*row)[1] += power * green;
            (*row)[2] += power * blue;
        }
    }
}

void glint_row_add_side(const glint_terms *terms, const glint_apart *apart, const glint_descent *polynomials,
                        const glint_pixel_runs *to) {
    const light_parts parts = parts_of(apart, polynomials);
    add_side(&parts, terms->light->diffuse[apart->light], to);
}

void glint_row_add_lobe(const glint_terms *terms, const glint_apart *apart, const glint_descent *polynomials,
                        const glint_pixel_runs *to) {
    const light_parts parts = parts_of(apart, polynomials);
    const uint16_t *const weight = terms->light->specular[apart->light];
    if (terms->light->lobe_is_wide)
        add_wide_lobe(terms, &parts, weight, to);
    else
        add_lobe(terms, &parts, weight, to);
}

/* ---- Edges ---- */

static inline int is_within(int32_t value, int32_t margin) {
    const int32_t high = glint_shift_right(value, 16);
    return high < margin && high > -margin;
}

/* Marks pixels of a run where a number is near 0. */
static void mark_within(const glint_descent *number, int32_t margin, const glint_run *run, uint8_t *is_edge) {
    glint_progress p = glint_progress_at(number, run->x, run->y);
    for (uint32_t n = run->count; n; n--, is_edge++, glint_progress_next(&p))
        if (is_within((int32_t)p.value, margin))
            *is_edge = 1;
}

uint32_t glint_terms_find_edge(const glint_terms *terms, const glint_descent *polynomials, const glint_run *run,
                               uint8_t columns[GLINT_TILE_MAX]) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < run->count; i++)
        columns[i] = 0;
    for (const glint_apart *a = terms->apart; a != terms->apart + terms->apart_count; a++) {
        const light_parts parts = parts_of(a, polynomials);
        if (!parts.lobe)
            continue;
        if (parts.side && !terms->is_ungated)
            mark_within(parts.side, terms->margin, run, columns);
        if (terms->light->lobe_has_strip)
            mark_within(parts.lobe, GLINT_HORIZON, run, columns);
    }
    for (uint32_t i = 0; i < run->count; i++)
        if (columns[i])
            columns[count++] = (uint8_t)(run->x + i);
    return count;
}
