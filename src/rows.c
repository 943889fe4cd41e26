/* SPDX-License-Identifier: MIT */
/* Rows: what a triangle's terms make of pixels that follow each other. */
#include "light.h"
#include "setup.h"
#include "terms.h"

/* 1 / |M|, Q15, of pixels; or null: then it is 1. */
typedef const uint16_t *inverses;

static inline int32_t over(int32_t number, inverses inverse, uint32_t i) {
    return inverse ? glint_shift_right(number * inverse[i], 15) : number;
}

static void find_inverses(const glint_quadratic *q, int32_t x, int32_t y, uint32_t count, uint16_t *inverse) {
    glint_stride s = glint_stride_begin(q, x, y);
    const uint32_t turn = 2 * q->dxx;
    for (uint32_t i = 0; i < count; i++) {
        const int32_t entry = glint_shift_right((int32_t)s.value, 20) - 256; /* M.M is Q30 */
        inverse[i] = glint_root_table[glint_least(glint_most(entry, 0), 767)];
        s.value += s.across;
        s.across += turn;
    }
}

/* Sets colours to a base and a sum of one chroma. */
static void begin_with_chroma(const glint_quadratic *q, const int32_t base[3], const int32_t chroma[3], unsigned up,
                              inverses inverse, int32_t x, int32_t y, uint32_t count, int32_t (*row)[3]) {
    glint_stride s = glint_stride_begin(q, x, y);
    const int32_t red = base[0], green = base[1], blue = base[2];
    const int32_t by_red = chroma[0] << up, by_green = chroma[1] << up, by_blue = chroma[2] << up;
    const uint32_t turn = 2 * q->dxx;
    for (uint32_t i = 0; i < count; i++, row++) {
        const int32_t sum = over(glint_shift_right((int32_t)s.value, 16), inverse, i);
        (*row)[0] = red + sum * by_red;
        (*row)[1] = green + sum * by_green;
        (*row)[2] = blue + sum * by_blue;
        s.value += s.across;
        s.across += turn;
    }
}

/* Sets colours to a base and three channels. */
static void begin_with_channels(const glint_quadratic q[3], const int32_t base[3], int32_t x, int32_t y, uint32_t count,
                                int32_t (*row)[3]) {
    glint_stride red = glint_stride_begin(&q[0], x, y), green = glint_stride_begin(&q[1], x, y),
                 blue = glint_stride_begin(&q[2], x, y);
    const uint32_t red_turn = 2 * q[0].dxx, green_turn = 2 * q[1].dxx, blue_turn = 2 * q[2].dxx;
    red.value += (uint32_t)base[0];
    green.value += (uint32_t)base[1];
    blue.value += (uint32_t)base[2];
    for (int32_t(*const end)[3] = row + count; row != end; row++) {
        (*row)[0] = (int32_t)red.value;
        (*row)[1] = (int32_t)green.value;
        (*row)[2] = (int32_t)blue.value;
        red.value += red.across, green.value += green.across, blue.value += blue.across;
        red.across += red_turn, green.across += green_turn, blue.across += blue_turn;
    }
}

/* The same over |M|. */
static void begin_with_channels_over(const glint_quadratic q[3], const int32_t base[3], inverses inverse, int32_t x,
                                     int32_t y, uint32_t count, int32_t (*row)[3]) {
    for (int c = 0; c < 3; c++) {
        glint_stride s = glint_stride_begin(&q[c], x, y);
        const uint32_t turn = 2 * q[c].dxx;
        for (uint32_t i = 0; i < count; i++) {
            row[i][c] = base[c] + glint_shift_right((int32_t)s.value, 13) * (inverse[i] >> 1) / 2;
            s.value += s.across;
            s.across += turn;
        }
    }
}

static inline void add(int32_t colour[3], int32_t amount, const int32_t weight[3]) {
    colour[0] += amount * weight[0];
    colour[1] += amount * weight[1];
    colour[2] += amount * weight[2];
}

/* Adds a light where it shines. */
static void add_side(const glint_side *side, inverses inverse, int32_t x, int32_t y, uint32_t count,
                     int32_t (*row)[3]) {
    glint_stride s = glint_stride_begin(&side->cosine, x, y);
    const uint32_t turn = 2 * side->cosine.dxx;
    for (uint32_t i = 0; i < count; i++) {
        if ((int32_t)s.value > 0)
            add(row[i], over((int32_t)(s.value >> 15), inverse, i), side->weight);
        s.value += s.across;
        s.across += turn;
    }
}

/* Adds a highlight. */
static void add_lobe(const glint_terms *terms, const glint_lobe *lobe, inverses inverse, int32_t x, int32_t y,
                     uint32_t count, int32_t (*row)[3]) {
    glint_stride ex = glint_stride_begin(&lobe->x, x, y), ey = glint_stride_begin(&lobe->y, x, y);
    const uint32_t x_turn = 2 * lobe->x.dxx, y_turn = 2 * lobe->y.dxx, end_of_table = terms->light->lobe_end;
    const unsigned shift = 2 * terms->light->lobe_shift;
    const int is_twice = terms->is_over_length > 1;
    for (uint32_t i = 0; i < count; i++) {
        int32_t dx = over(glint_shift_right((int32_t)ex.value, 16), inverse, i);
        int32_t dy = over(glint_shift_right((int32_t)ey.value, 16), inverse, i);
        if (is_twice) {
            dx = over(dx, inverse, i);
            dy = over(dy, inverse, i);
        }
        const uint32_t square = (uint32_t)(dx * dx) + (uint32_t)(dy * dy);
        if (square < end_of_table) {
            int32_t power = (int32_t)glint_power_at(terms->power, square << 2 >> shift);
            if (lobe->is_attenuated) {
                const int32_t strength =
                    glint_shift_right((int32_t)glint_stride_begin(&lobe->strength, x + (int32_t)i, y).value, 15);
                power = glint_shift_right(power * glint_most(strength, 0), 15);
            }
            add(row[i], power, lobe->weight);
        }
        ex.value += ex.across, ey.value += ey.across;
        ex.across += x_turn, ey.across += y_turn;
    }
}

static void multiply_by_surface(const glint_plane surface[3], const int32_t half[3], int32_t x, int32_t y,
                                uint32_t count, int32_t (*row)[3]) {
    for (int c = 0; c < 3; c++) {
        int32_t colour = glint_plane_at(&surface[c], x, y);
        for (uint32_t i = 0; i < count; i++) {
            row[i][c] = glint_shift_right(row[i][c], 12) * glint_shift_right(colour, 18) + half[c];
            colour = glint_add_wrap(colour, surface[c].dx);
        }
    }
}

static void raise_to_ambient(const int32_t ambient[3], uint32_t count, int32_t (*row)[3]) {
    for (; count; count--, row++)
        for (int c = 0; c < 3; c++)
            (*row)[c] = glint_most((*row)[c], ambient[c]);
}

void glint_terms_row(const glint_terms *terms, int32_t x, int32_t y, uint32_t count, int32_t (*row)[3]) {
    const glint_light_terms *light = terms->light;
    uint16_t inverse_of[GLINT_TILE_MAX];
    inverses inverse = terms->is_over_length ? inverse_of : 0;
    int32_t base[3];
    if (inverse)
        find_inverses(&terms->square, x, y, count, inverse_of);
    if (terms->is_channels) {
        static const int32_t none[3] = {0, 0, 0};
        begin_with_channels(terms->sum, none, x, y, count, row);
        return;
    }
    for (int c = 0; c < 3; c++)
        base[c] = (terms->takes_largest ? 0 : light->ambient[c]) + (terms->has_surface ? 0 : light->half[c]);
    if (light->channels == 1)
        begin_with_chroma(&terms->sum[0], base, light->chroma, light->sum_bits, inverse, x, y, count, row);
    else if (inverse)
        begin_with_channels_over(terms->sum, base, inverse, x, y, count, row);
    else
        begin_with_channels(terms->sum, base, x, y, count, row);
    for (uint32_t i = 0; i < terms->side_count; i++)
        add_side(&terms->sides[i], inverse, x, y, count, row);
    if (terms->has_surface)
        multiply_by_surface(terms->surface, light->half, x, y, count, row);
    for (uint32_t i = 0; i < terms->lobe_count; i++)
        add_lobe(terms, &terms->lobes[i], inverse, x, y, count, row);
    if (terms->takes_largest) {
        for (int c = 0; c < 3; c++)
            base[c] = light->ambient[c] + light->half[c];
        raise_to_ambient(base, count, row);
    }
}
