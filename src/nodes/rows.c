/* SPDX-License-Identifier: MIT */
/* Runs: what a region's terms make of pixels, run by run and term by term. */
#include "rows.h"

#include "../pixel/format.h"

static void find_inverses(const glint_descent *square, const glint_pixel_runs *to, uint16_t *inverse) {
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress p = glint_run_start(square, run, to);
        for (uint32_t n = run->count; n; n--, glint_progress_next(&p)) {
            const int32_t entry = glint_shift_right((int32_t)p.value, 20) - 256; /* M.M is Q30 */
            *inverse++ = glint_root_table[glint_least(glint_most(entry, 0), 767)];
        }
    }
}

/* ---- Sums ---- */

/* Sets colours to a base and a sum of one chroma; `is_over` is a constant where this is inlined. */
static inline void begin_with_chroma(const glint_terms *terms, const glint_descent *sum, const int32_t base[3],
                                     const glint_pixel_runs *to, int is_over) {
    const unsigned up = terms->light->sum_bits;
    const int32_t *const chroma = terms->light->chroma;
    const int32_t by_red = chroma[0] << up, by_green = chroma[1] << up, by_blue = chroma[2] << up;
    const int32_t red = base[0], green = base[1], blue = base[2];
    int32_t(*row)[3] = to->row;
    glint_inverses inverse = to->inverse;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress p = glint_run_start(sum, run, to);
        for (int32_t(*const end)[3] = row + run->count; row != end; row++, glint_progress_next(&p)) {
            int32_t amount = glint_shift_right((int32_t)p.value, 16);
            if (is_over)
                amount = glint_shift_right(amount * *inverse++, 15);
            (*row)[0] = red + amount * by_red;
            (*row)[1] = green + amount * by_green;
            (*row)[2] = blue + amount * by_blue;
        }
    }
}

/* Sets colours to a base and three channels; `is_over` is a constant where this is inlined. */
static GLINT_INLINE void begin_with_channels_inline(const glint_descent sum[3], const int32_t base[3],
                                                    const glint_pixel_runs *to, int is_over) {
    int32_t(*row)[3] = to->row;
    glint_inverses inverse = to->inverse;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress red = glint_run_start(&sum[0], run, to), green = glint_run_start(&sum[1], run, to),
                       blue = glint_run_start(&sum[2], run, to);
        if (!is_over) {
            red.value += (uint32_t)base[0];
            green.value += (uint32_t)base[1];
            blue.value += (uint32_t)base[2];
        }
        for (int32_t(*const end)[3] = row + run->count; row != end; row++) {
            if (is_over) {
                const int32_t over = *inverse++ >> 1;
                (*row)[0] = base[0] + glint_shift_right((int32_t)red.value, 14) * over;
                (*row)[1] = base[1] + glint_shift_right((int32_t)green.value, 14) * over;
                (*row)[2] = base[2] + glint_shift_right((int32_t)blue.value, 14) * over;
            } else {
                (*row)[0] = (int32_t)red.value;
                (*row)[1] = (int32_t)green.value;
                (*row)[2] = (int32_t)blue.value;
            }
            glint_progress_next(&red);
            glint_progress_next(&green);
            glint_progress_next(&blue);
        }
    }
}

static GLINT_NOINLINE void begin_with_channels(const glint_descent sum[3], const int32_t base[3],
                                               const glint_pixel_runs *to) {
    if (GLINT_SMALL)
        begin_with_channels_inline(sum, base, to, to->inverse != 0);
    else if (to->inverse)
        begin_with_channels_inline(sum, base, to, 1);
    else
        begin_with_channels_inline(sum, base, to, 0);
}

/* Sets colours to sums of light, and what is added to all. */
static void begin_row(const glint_terms *terms, const glint_descent *sum, const glint_pixel_runs *to) {
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
    else
        begin_with_channels(sum, base, to);
}

/* ---- Surfaces ---- */

/* One channel of what is below, and to the next pixel. */
static inline void take_channel(int32_t *colour, glint_progress *surface, int32_t ambient, int32_t half, int is_least) {
    const int32_t by = glint_shift_right(is_least ? ambient : *colour, 12);
    const int32_t value = by * glint_shift_right((int32_t)surface->value, 18) + half;
    *colour = is_least ? glint_most(*colour, value) : value;
    glint_progress_next(surface);
}

/* Multiplies what there is by the surface's colours, or makes it no less than ambient light times these, and half a
 * level; `is_least` is a constant where this is inlined. */
static GLINT_INLINE void take_surface_inline(const glint_light_terms *light, const glint_descent surface[3],
                                             const glint_pixel_runs *to, int is_least) {
    int32_t(*row)[3] = to->row;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress red = glint_run_start(&surface[0], run, to), green = glint_run_start(&surface[1], run, to),
                       blue = glint_run_start(&surface[2], run, to);
        for (int32_t(*const end)[3] = row + run->count; row != end; row++) {
            take_channel(&(*row)[0], &red, light->ambient[0], light->half[0], is_least);
            take_channel(&(*row)[1], &green, light->ambient[1], light->half[1], is_least);
            take_channel(&(*row)[2], &blue, light->ambient[2], light->half[2], is_least);
        }
    }
}

static void take_surface(const glint_light_terms *light, const glint_descent surface[3], const glint_pixel_runs *to,
                         int is_least) {
    if (GLINT_SMALL)
        take_surface_inline(light, surface, to, is_least);
    else if (is_least)
        take_surface_inline(light, surface, to, 1);
    else
        take_surface_inline(light, surface, to, 0);
}

/* Makes a colour no less than it is. */
static inline void raise_to(int32_t *colour, int32_t least) {
    *colour = glint_most(*colour, least);
}

/* Makes colours no less than ambient light. */
static void raise_row(const glint_light_terms *light, int32_t (*row)[3], uint32_t pixels) {
    const int32_t red = light->ambient[0] + light->half[0], green = light->ambient[1] + light->half[1],
                  blue = light->ambient[2] + light->half[2];
    for (int32_t(*const end)[3] = row + pixels; row != end; row++) {
        raise_to(&(*row)[0], red);
        raise_to(&(*row)[1], green);
        raise_to(&(*row)[2], blue);
    }
}

/* Sets colours of runs. @return pixels */
static uint32_t find_colours(const glint_terms *terms, const glint_descent *polynomials, glint_pixel_runs *to) {
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
        if (a->kinds >> GLINT_SIDE & 1)
            glint_row_add_side(terms, a, polynomials, to);
    if (terms->has_surface)
        take_surface(light, polynomials + terms->surface, to, 0);
    for (const glint_apart *a = terms->apart; a != end; a++)
        if (a->kinds >> GLINT_LOBE_X & 1)
            glint_row_add_lobe(terms, a, polynomials, to);
    if (terms->takes_largest && terms->has_surface)
        take_surface(light, polynomials + terms->surface, to, 1);
    else if (terms->takes_largest)
        raise_row(light, to->row, pixels);
    to->inverse = 0;
    return pixels;
}

void glint_terms_draw(const glint_frame *frame, glint_workspace *workspace, const glint_terms *terms,
                      const glint_descent *polynomials, const glint_run *runs, uint32_t count) {
    const glint_format *format = frame->config.format;
    const unsigned shift = frame->tile_shift_x;
    int32_t(*row)[3] = workspace->row;
    glint_pixel_runs to = {runs, runs + count, 0, row, terms->is_curved};
    const uint32_t pixels = find_colours(terms, polynomials, &to);
    if (frame->config.gamma)
        glint_finish_colours(&frame->config, row, pixels);
    for (const glint_run *run = runs; run != to.end; row += run->count, run++)
        format->store(workspace->pixels, shift, ((uint32_t)run->y << shift) + run->x, run->count,
                      (const int32_t(*)[3])row);
}
