/* SPDX-License-Identifier: MIT */
/* Lights with terms of their own: what these make of pixels, run by run. */
#include "../light/model.h"
#include "lobes.h"
#include "rows.h"

/* A number at pixel i of a run. */
static inline int32_t at(const glint_quadratic *q, const glint_pixel_runs *to, const glint_run *run, uint32_t i) {
    return (int32_t)glint_stride_begin(q, to->x + (int32_t)(run->x + i), to->y + run->y).value;
}

/* What a light's polynomials are; null where it has none. */
typedef struct light_parts {
    const glint_quadratic *side, *cone, *strength, *lobe;
} light_parts;

static inline light_parts parts_of(const glint_apart *apart, const glint_quadratic *polynomials) {
    const glint_quadratic *next = polynomials + apart->first;
    light_parts parts;
    parts.side = apart->kinds >> GLINT_SIDE & 1 ? next++ : 0;
    parts.cone = apart->kinds >> GLINT_CONE & 1 ? next++ : 0;
    parts.strength = apart->kinds >> GLINT_STRENGTH & 1 ? next++ : 0;
    parts.lobe = apart->kinds >> GLINT_LOBE_X & 1 ? next : 0;
    return parts;
}

/* Where a light goes: its weights, or where light is of one chroma its share, of these numbers of a pixel. */
typedef struct light_share {
    const uint16_t *weight;
    int32_t share;
    unsigned at, down; /* which number, and its shift */
} light_share;

static inline void add(int32_t colour[3], int32_t amount, const uint16_t weight[3]) {
    colour[0] += amount * weight[0];
    colour[1] += amount * weight[1];
    colour[2] += amount * weight[2];
}

/* Adds an amount, Q15, to a pixel; `is_chroma` is a constant where this is inlined. */
static GLINT_INLINE void add_amount(int32_t pixel[3], int32_t amount, const light_share *of, int is_chroma) {
    if (is_chroma)
        pixel[of->at] += glint_shift_right(amount * of->share, of->down);
    else
        add(pixel, amount, of->weight);
}

/* t^2 (3 - 2 t), Q15, for t Q12 in the high half, cut off at 0 and 1. */
static inline int32_t smooth_step_at(int32_t value) {
    const int32_t t = glint_least(glint_most(glint_shift_right(value, 13), 0), 1 << 15);
    return (int32_t)(((uint32_t)(t * t) >> 15) * (uint32_t)((3 << 15) - 2 * t) >> 15);
}

/* Adds a light where it shines; `is_over`, `has_cone` and `is_chroma` are constants where this is inlined. */
static GLINT_INLINE void add_side_inline(const light_parts *of, const light_share *share, const glint_pixel_runs *to,
                                         int is_over, int has_cone, int is_chroma) {
    const light_share into = *share;
    int32_t(*row)[3] = to->row;
    glint_inverses inverse = to->inverse;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress cosine = glint_run_start(of->side, run, to), cone = cosine;
        if (has_cone)
            cone = glint_run_start(of->cone, run, to);
        for (uint32_t n = run->count; n; n--, row++, glint_progress_next(&cosine)) {
            const uint32_t over = !is_over ? 1u << 15 : is_chroma ? (uint32_t)(*row)[2] : *inverse++;
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
            add_amount(*row, amount, &into, is_chroma);
        }
    }
}

static GLINT_NOINLINE void add_side(const light_parts *of, const light_share *share, const glint_pixel_runs *to,
                                    int is_chroma) {
    const int is_over = to->inverse != 0;
    if (GLINT_SMALL || of->cone)
        add_side_inline(of, share, to, is_over, of->cone != 0, is_chroma);
    else if (!is_chroma)
        add_side_inline(of, share, to, is_over, 0, 0);
    else if (is_over)
        add_side_inline(of, share, to, 1, 0, 1);
    else
        add_side_inline(of, share, to, 0, 0, 1);
}

/* A strength of 1. */
static const glint_progress full_strength = {1u << 30, 0, 0};

/* What terminator and cone leave of a highlight at a pixel. */
static int32_t weaken(int32_t power, const light_parts *of, int is_ungated, const glint_pixel_runs *to,
                      const glint_run *run, uint32_t i) {
    if (of->side && !is_ungated && at(of->side, to, run, i) <= 0)
        return 0;
    return of->cone ? glint_shift_right(power * smooth_step_at(at(of->cone, to, run, i)), 15) : power;
}

/*
 * A power table over squared deviations as these are kept: glint_power_at of them. Its window is no less than 1/15 of
 * where lobes end, to which deviations are kept with 24 bits: no shift is below 0. Over |M|^(2 n) what is looked up are
 * products of 32 bits: of the squares' upper 16, and of 1 / |M|^(2 n), Q14 or Q12.
 */
typedef struct lobe_table {
    const uint16_t *value;
    uint32_t end;      /* beyond, the power is 0 or need not show */
    uint32_t end_over; /* the same of products */
    unsigned upper;    /* shift to a square's upper bits */
    unsigned fraction; /* shift of what is looked up, to 12 bits between two values */
} lobe_table;

static lobe_table table_of(const glint_terms *terms) {
    const glint_power_table *power = terms->power;
    const unsigned kept = 2 * terms->light->lobe_shift; /* u, Q30, is 4 times a square, over 2^kept */
    const uint32_t window = power->window >> 2 << kept, limit = terms->light->lobe_end;
    const uint32_t end = limit < window ? limit : window;
    const unsigned bits = 32 - glint_leading_zeros(end), upper = bits > 16 ? bits - 16 : 0;
    const unsigned unit = terms->is_over_length > 1 ? 12 : 14;
    const unsigned index = power->index_shift + kept - 2 + (terms->is_over_length ? unit : upper) - upper;
    return (lobe_table){power->value, end, end >> upper << unit, upper, index - GLINT_POWER_FRACTION_BITS};
}

static inline int32_t power_of_square(const lobe_table *table, uint32_t square) {
    const uint32_t place = square >> table->fraction;
    const uint16_t *const node = &table->value[place >> GLINT_POWER_FRACTION_BITS];
    const int32_t fraction = (int32_t)(place & ((1u << GLINT_POWER_FRACTION_BITS) - 1));
    return node[0] + glint_shift_right((node[1] - node[0]) * fraction, GLINT_POWER_FRACTION_BITS);
}

/* A square over |M|^(2 n), as a table looks it up; 1 / |M| is Q15. */
static GLINT_INLINE uint32_t square_over(uint32_t square, uint32_t over, uint32_t n, const lobe_table *table) {
    uint32_t by = over * over >> 16;
    if (n > 1)
        by = by * by >> 16;
    return (square >> table->upper) * by;
}

/* Adds a highlight; all that is a number below is a constant where this is inlined. */
static GLINT_INLINE void add_lobe_inline(const glint_terms *terms, const light_parts *of, const light_share *share,
                                         const glint_pixel_runs *to, uint32_t times_over, int is_weak, int is_chroma) {
    const lobe_table table = table_of(terms);
    const light_share into = *share;
    const int is_cut = of->cone || (of->side && !terms->is_ungated);
    int32_t(*row)[3] = to->row;
    glint_inverses inverse = to->inverse;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress x = glint_run_start(&of->lobe[0], run, to);
        GLINT_BARRIER();
        glint_progress y = glint_run_start(&of->lobe[1], run, to);
        GLINT_BARRIER();
        glint_progress strength = is_weak && of->strength ? glint_run_start(of->strength, run, to) : full_strength;
        for (uint32_t n = run->count; n; n--, row++) {
            const int32_t dx = glint_shift_right((int32_t)x.value, 16), dy = glint_shift_right((int32_t)y.value, 16);
            const int32_t reach = (int32_t)strength.value;
            uint32_t square = (uint32_t)(dx * dx) + (uint32_t)(dy * dy);
            glint_progress_next(&x);
            glint_progress_next(&y);
            if (is_weak)
                glint_progress_next(&strength);
            const uint32_t over = !times_over ? 0 : is_chroma ? (uint32_t)(*row)[2] : *inverse++;
            if (square >= table.end) /* it grows over length: glint_root_table has nothing below 1 */
                continue;
            if (times_over) {
                square = square_over(square, over, times_over, &table);
                if (square >= table.end_over)
                    continue;
            }
            int32_t power = power_of_square(&table, square);
            if (is_weak)
                power = glint_shift_right(power * glint_most(glint_shift_right(reach, 15), 0), 15);
            if (is_weak && is_cut)
                power = weaken(power, of, terms->is_ungated, to, run, run->count - n);
            add_amount(*row, power, &into, is_chroma);
        }
    }
}

static GLINT_NOINLINE void add_lobe(const glint_terms *terms, const light_parts *of, const light_share *share,
                                    const glint_pixel_runs *to, int is_chroma) {
    const int is_weak = of->side || of->strength || of->cone;
    const uint32_t over = terms->is_over_length;
    if (GLINT_SMALL || (!is_chroma && (over > 1 || (is_weak && !over))))
        add_lobe_inline(terms, of, share, to, over, 1, is_chroma);
    else if (!is_chroma && over)
        add_lobe_inline(terms, of, share, to, 1, 1, 0);
    else if (!is_chroma)
        add_lobe_inline(terms, of, share, to, 0, 0, 0);
    else if (is_weak && over)
        add_lobe_inline(terms, of, share, to, over, 1, 1);
    else if (is_weak)
        add_lobe_inline(terms, of, share, to, 0, 1, 1);
    else if (over > 1)
        add_lobe_inline(terms, of, share, to, 2, 0, 1);
    else if (over)
        add_lobe_inline(terms, of, share, to, 1, 0, 1);
    else
        add_lobe_inline(terms, of, share, to, 0, 0, 1);
}

/* Adds a highlight of the cosine; whether it is weakened and `is_chroma` are constants where this is inlined. */
static GLINT_INLINE void add_wide_lobe_inline(const glint_terms *terms, const light_parts *of, const light_share *share,
                                              const glint_pixel_runs *to, int is_weak, int is_chroma) {
    const light_share into = *share;
    const int is_cut = of->cone || (of->side && !terms->is_ungated);
    const int32_t at_zero = (int32_t)glint_power_of_zero(terms->power);
    const uint16_t *const powers = terms->light->cosine;
    int32_t(*row)[3] = to->row;
    glint_inverses inverse = to->inverse;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress cosine = glint_run_start(of->lobe, run, to);
        glint_progress strength = is_weak && of->strength ? glint_run_start(of->strength, run, to) : full_strength;
        for (uint32_t n = run->count; n; n--, row++, glint_progress_next(&cosine)) {
            const int32_t reach = (int32_t)strength.value;
            int32_t x = glint_shift_right((int32_t)cosine.value, 15);
            if (is_weak)
                glint_progress_next(&strength);
            if (inverse) {
                const int32_t over = is_chroma ? (*row)[2] : *inverse++;
                for (uint32_t times = terms->is_over_length; times; times--)
                    x = glint_shift_right(x * over, 15);
            }
            if (x <= 0 && !at_zero)
                continue;
            int32_t power =
                x > 0 ? (int32_t)glint_power_of_cosine(powers, (uint32_t)glint_least(x, INT16_MAX) << 16) : at_zero;
            if (is_weak)
                power = glint_shift_right(power * glint_most(glint_shift_right(reach, 15), 0), 15);
            if (is_weak && is_cut)
                power = weaken(power, of, terms->is_ungated, to, run, run->count - n);
            add_amount(*row, power, &into, is_chroma);
        }
    }
}

static GLINT_NOINLINE void add_wide_lobe(const glint_terms *terms, const light_parts *of, const light_share *share,
                                         const glint_pixel_runs *to, int is_chroma) {
    const int is_weak = of->side || of->strength || of->cone;
    if (GLINT_SMALL || (is_weak && !is_chroma))
        add_wide_lobe_inline(terms, of, share, to, 1, is_chroma);
    else if (is_weak)
        add_wide_lobe_inline(terms, of, share, to, 1, 1);
    else
        add_wide_lobe_inline(terms, of, share, to, 0, is_chroma);
}

void glint_row_add_side(const glint_terms *terms, const glint_apart *apart, const glint_quadratic *polynomials,
                        const glint_pixel_runs *to) {
    const glint_light_terms *light = terms->light;
    const light_parts parts = parts_of(apart, polynomials);
    const light_share share = {light->diffuse[apart->light], light->share[apart->light], 0, 15 + light->sum_bits};
    add_side(&parts, &share, to, terms->sums == 1);
}

void glint_row_add_lobe(const glint_terms *terms, const glint_apart *apart, const glint_quadratic *polynomials,
                        const glint_pixel_runs *to) {
    const glint_light_terms *light = terms->light;
    const light_parts parts = parts_of(apart, polynomials);
    const light_share share = {light->specular[apart->light], light->gloss_share[apart->light], 1, 15};
    if (light->lobe_is_wide)
        add_wide_lobe(terms, &parts, &share, to, terms->sums == 1);
    else
        add_lobe(terms, &parts, &share, to, terms->sums == 1);
}

/* ---- Edges ---- */

static inline int is_within(int32_t value, int32_t margin) {
    const int32_t high = glint_shift_right(value, 16);
    return high < margin && high > -margin;
}

/* Marks pixels of a run where a number is near 0. */
static void mark_within(const glint_quadratic *number, const glint_part *part, int32_t margin, const glint_run *run,
                        uint8_t *is_edge) {
    glint_progress p = glint_progress_begin(number, part->x + run->x, part->y + run->y);
    for (uint32_t n = run->count; n; n--, is_edge++, glint_progress_next(&p))
        if (is_within((int32_t)p.value, margin))
            *is_edge = 1;
}

uint32_t glint_terms_find_edge(const glint_terms *terms, const glint_quadratic *polynomials, const glint_part *part,
                               const glint_run *run, uint8_t columns[GLINT_TILE_MAX]) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < run->count; i++)
        columns[i] = 0;
    for (const glint_apart *a = terms->apart; a != terms->apart + terms->apart_count; a++) {
        const light_parts parts = parts_of(a, polynomials);
        if (!parts.lobe)
            continue;
        if (parts.side && !terms->is_ungated)
            mark_within(parts.side, part, terms->margin, run, columns);
        if (terms->light->lobe_has_strip)
            mark_within(parts.lobe, part, GLINT_HORIZON, run, columns);
    }
    for (uint32_t i = 0; i < run->count; i++)
        if (columns[i])
            columns[count++] = (uint8_t)(run->x + i);
    return count;
}
