/* SPDX-License-Identifier: MIT */
/* Runs: what a region's terms make of pixels, run by run and term by term. */
#include "../light/model.h"
#include "../pixel/format.h"
#include "lobes.h"

/* 1 / |M|, Q15, of pixels; or null: then it is 1. */
typedef const uint16_t *inverses;

static inline void go_on(glint_progress *p) {
    p->value += p->step;
    p->step += p->turn;
}

/* Pixels on their way, run after run. */
typedef struct pixel_runs {
    const glint_run *runs, *end;
    inverses inverse;
    int32_t (*row)[3];
    int is_curved;
} pixel_runs;

static inline glint_progress start(const glint_descent *p, const glint_run *run, const pixel_runs *to) {
    if (to->is_curved)
        return glint_progress_at(p, run->x, run->y);
    return (glint_progress){p->row.value + p->row.step * run->x + p->down * run->y, p->row.step, 0};
}

/* A number at pixel i of a run. */
static inline int32_t at(const glint_descent *polynomial, const glint_run *run, uint32_t i) {
    return (int32_t)glint_progress_at(polynomial, run->x + i, run->y).value;
}

static void find_inverses(const glint_descent *square, const pixel_runs *to, uint16_t *inverse) {
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress p = start(square, run, to);
        for (uint32_t n = run->count; n; n--, go_on(&p)) {
            const int32_t entry = glint_shift_right((int32_t)p.value, 20) - 256; /* M.M is Q30 */
            *inverse++ = glint_root_table[glint_least(glint_most(entry, 0), 767)];
        }
    }
}

/* ---- Sums ---- */

/* Sets colours to a base and a sum of one chroma; `is_over` is a constant where this is inlined. */
static inline void begin_with_chroma(const glint_terms *terms, const glint_descent *sum, const int32_t base[3],
                                     const pixel_runs *to, int is_over) {
    const unsigned up = terms->light->sum_bits;
    const int32_t *const chroma = terms->light->chroma;
    const int32_t by_red = chroma[0] << up, by_green = chroma[1] << up, by_blue = chroma[2] << up;
    const int32_t red = base[0], green = base[1], blue = base[2];
    int32_t(*row)[3] = to->row;
    inverses inverse = to->inverse;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress p = start(sum, run, to);
        for (int32_t(*const end)[3] = row + run->count; row != end; row++, go_on(&p)) {
            int32_t amount = glint_shift_right((int32_t)p.value, 16);
            if (is_over)
                amount = glint_shift_right(amount * *inverse++, 15);
            (*row)[0] = red + amount * by_red;
            (*row)[1] = green + amount * by_green;
            (*row)[2] = blue + amount * by_blue;
        }
    }
}

/* Sets colours to a base and three channels. */
static void begin_with_channels(const glint_descent sum[3], const int32_t base[3], const pixel_runs *to) {
    int32_t(*row)[3] = to->row;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress red = start(&sum[0], run, to), green = start(&sum[1], run, to), blue = start(&sum[2], run, to);
        red.value += (uint32_t)base[0];
        green.value += (uint32_t)base[1];
        blue.value += (uint32_t)base[2];
        for (int32_t(*const end)[3] = row + run->count; row != end; row++) {
            (*row)[0] = (int32_t)red.value;
            (*row)[1] = (int32_t)green.value;
            (*row)[2] = (int32_t)blue.value;
            go_on(&red);
            go_on(&green);
            go_on(&blue);
        }
    }
}

/* The same over |M|. */
static void begin_with_channels_over(const glint_descent sum[3], const int32_t base[3], const pixel_runs *to) {
    for (int c = 0; c < 3; c++) {
        int32_t(*row)[3] = to->row;
        inverses inverse = to->inverse;
        for (const glint_run *run = to->runs; run != to->end; run++) {
            glint_progress channel = start(&sum[c], run, to);
            for (uint32_t n = run->count; n; n--, row++, go_on(&channel))
                (*row)[c] = base[c] + glint_shift_right((int32_t)channel.value, 14) * (*inverse++ >> 1);
        }
    }
}

/* Sets colours to sums of light, and what is added to all. */
static void begin_row(const glint_terms *terms, const glint_descent *sum, const pixel_runs *to) {
    const glint_light_terms *light = terms->light;
    int32_t base[3];
    for (int c = 0; c < 3; c++) {
        base[c] = terms->has_surface || (terms->is_channels && !to->inverse) ? 0 : light->half[c];
        base[c] += terms->is_channels || terms->takes_largest ? 0 : light->ambient[c];
    }
    if (terms->sums == 1 && to->inverse)
        begin_with_chroma(terms, sum, base, to, 1);
    else if (terms->sums == 1)
        begin_with_chroma(terms, sum, base, to, 0);
    else if (to->inverse)
        begin_with_channels_over(sum, base, to);
    else
        begin_with_channels(sum, base, to);
}

/* ---- Lights with terms of their own ---- */

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
static GLINT_INLINE void add_side_inline(const light_parts *of, const uint16_t weight[3], const pixel_runs *to,
                                         int is_over, int has_cone) {
    int32_t(*row)[3] = to->row;
    inverses inverse = to->inverse;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress cosine = start(of->side, run, to), cone = start(has_cone ? of->cone : of->side, run, to);
        for (int32_t(*const end)[3] = row + run->count; row != end; row++, go_on(&cosine)) {
            const uint32_t over = is_over ? *inverse++ : 1u << 15;
            const int32_t within = (int32_t)cone.value;
            if (has_cone)
                go_on(&cone);
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

static void add_side(const light_parts *of, const uint16_t weight[3], const pixel_runs *to) {
    if (of->cone)
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
                                         const pixel_runs *to, uint32_t times_over, int is_weak) {
    const lobe_table table = table_of(terms);
    int32_t(*row)[3] = to->row;
    inverses inverse = to->inverse;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress x = start(&of->lobe[0], run, to), y = start(&of->lobe[1], run, to);
        int32_t(*const begin)[3] = row;
        for (int32_t(*const end)[3] = row + run->count; row != end; row++, go_on(&x), go_on(&y)) {
            int32_t dx = glint_shift_right((int32_t)x.value, 16), dy = glint_shift_right((int32_t)y.value, 16);
            for (uint32_t n = times_over; n; n--) {
                dx = glint_shift_right(dx * *inverse, 15);
                dy = glint_shift_right(dy * *inverse, 15);
            }
            if (times_over)
                inverse++;
            const uint32_t square = (uint32_t)(dx * dx) + (uint32_t)(dy * dy);
            if (square >= table.end)
                continue;
            const int32_t power = power_of_square(&table, square);
            add(*row, is_weak ? weaken(power, of, terms->is_ungated, run, (uint32_t)(row - begin)) : power, weight);
        }
    }
}

static void add_lobe(const glint_terms *terms, const light_parts *of, const uint16_t weight[3], const pixel_runs *to) {
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
                          const pixel_runs *to) {
    static const glint_progress whole = {1u << 30, 0, 0};
    light_parts cut = *of; /* for what the strength does not do */
    cut.strength = 0;
    const int is_cut = of->cone || (of->side && !terms->is_ungated);
    const int32_t at_zero = (int32_t)glint_power_of_zero(terms->power), red = weight[0], green = weight[1],
                  blue = weight[2];
    const uint16_t *const powers = terms->light->cosine;
    int32_t(*row)[3] = to->row;
    inverses inverse = to->inverse;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress cosine = start(of->lobe, run, to),
                       strength = of->strength ? start(of->strength, run, to) : whole;
        for (uint32_t i = 0; i < run->count; i++, row++, go_on(&cosine), go_on(&strength)) {
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

/* ---- Surfaces ---- */

/* Multiplies what there is by the surface's colours, and adds half a level. */
static void multiply_by_surface(const glint_terms *terms, const glint_descent surface[3], const pixel_runs *to) {
    for (int c = 0; c < 3; c++) {
        const int32_t half = terms->light->half[c];
        int32_t(*row)[3] = to->row;
        for (const glint_run *run = to->runs; run != to->end; run++) {
            glint_progress colour = start(&surface[c], run, to);
            for (uint32_t n = run->count; n; n--, row++, go_on(&colour))
                (*row)[c] = glint_shift_right((*row)[c], 12) * glint_shift_right((int32_t)colour.value, 18) + half;
        }
    }
}

/* Makes colours no less than ambient light, and the surface's colour of it. */
static void raise_row_to_ambient(const glint_terms *terms, const glint_descent surface[3], const pixel_runs *to) {
    for (int c = 0; c < 3; c++) {
        const int32_t ambient = terms->light->ambient[c], half = terms->light->half[c];
        int32_t(*row)[3] = to->row;
        for (const glint_run *run = to->runs; run != to->end; run++) {
            for (uint32_t i = 0; i < run->count; i++, row++) {
                const int32_t least =
                    terms->has_surface ? glint_shift_right(ambient, 12) * glint_shift_right(at(&surface[c], run, i), 18)
                                       : ambient;
                (*row)[c] = glint_most((*row)[c], least + half);
            }
        }
    }
}

/* Sets colours of runs. @return pixels */
static uint32_t find_colours(const glint_terms *terms, const glint_descent *polynomials, pixel_runs *to) {
    const glint_light_terms *light = terms->light;
    const glint_apart *const end = terms->apart + terms->apart_count;
    uint16_t inverse[2 * GLINT_TILE_MAX];
    uint32_t pixels = 0;
    for (const glint_run *run = to->runs; run != to->end; run++)
        pixels += run->count;
    to->inverse = 0;
    if (terms->is_over_length) {
        find_inverses(&polynomials[terms->square], to, inverse);
        to->inverse = inverse;
    }
    begin_row(terms, polynomials, to);
    for (const glint_apart *a = terms->apart; a != end; a++)
        if (a->kinds >> GLINT_SIDE & 1) {
            const light_parts parts = parts_of(a, polynomials);
            add_side(&parts, light->diffuse[a->light], to);
        }
    if (terms->has_surface)
        multiply_by_surface(terms, polynomials + terms->surface, to);
    for (const glint_apart *a = terms->apart; a != end; a++)
        if (a->kinds >> GLINT_LOBE_X & 1) {
            const light_parts parts = parts_of(a, polynomials);
            if (light->lobe_is_wide)
                add_wide_lobe(terms, &parts, light->specular[a->light], to);
            else
                add_lobe(terms, &parts, light->specular[a->light], to);
        }
    if (terms->takes_largest)
        raise_row_to_ambient(terms, polynomials + terms->surface, to);
    to->inverse = 0;
    return pixels;
}

static inline int is_within(int32_t value, int32_t margin) {
    const int32_t high = glint_shift_right(value, 16);
    return high < margin && high > -margin;
}

uint32_t glint_terms_find_edge(const glint_terms *terms, const glint_descent *polynomials, const glint_run *run,
                               uint8_t columns[GLINT_TILE_MAX]) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < run->count; i++) {
        int is_edge = 0;
        for (const glint_apart *a = terms->apart; a != terms->apart + terms->apart_count; a++) {
            const light_parts parts = parts_of(a, polynomials);
            if (!parts.lobe)
                continue;
            is_edge |= parts.side && !terms->is_ungated && is_within(at(parts.side, run, i), terms->margin);
            is_edge |= terms->light->lobe_has_strip && is_within(at(parts.lobe, run, i), GLINT_HORIZON);
        }
        if (is_edge)
            columns[count++] = (uint8_t)(run->x + i);
    }
    return count;
}

void glint_terms_draw(const glint_frame *frame, glint_workspace *workspace, const glint_terms *terms,
                      const glint_descent *polynomials, const glint_run *runs, uint32_t count) {
    const glint_format *format = frame->config.format;
    const unsigned shift = frame->tile_shift_x;
    int32_t(*row)[3] = workspace->row;
    pixel_runs to = {runs, runs + count, 0, row, terms->is_curved};
    const uint32_t pixels = find_colours(terms, polynomials, &to);
    if (frame->config.gamma)
        glint_finish_colours(&frame->config, row, pixels);
    for (const glint_run *run = runs; run != to.end; row += run->count, run++)
        format->store(workspace->pixels, shift, ((uint32_t)run->y << shift) + run->x, run->count,
                      (const int32_t(*)[3])row);
}
