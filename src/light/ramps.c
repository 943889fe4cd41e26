/* SPDX-License-Identifier: MIT */
/* Ramps: makes tables of packed colours, of diffuse light over N.L and of highlights over sin^2; suns.h. */
#include "../math/numeric.h"
#include "../scene/arena.h"
#include "lamps.h"
#include "suns.h"

/* A highlight ends where it falls below 2^-9: at weight 1 this is 1/8 of a level of 63. */
#define CUT_BITS 9

/* Every 2^NODE_BITS-th entry of a table of highlights is computed, a node; those between are interpolated. */
#define NODE_BITS 2

/* The largest levels of red, green and blue. */
static const uint32_t most_level[3] = {31, 63, 31};

/* Half of the step that `spread_levels` cuts off. */
static const uint32_t cut_half[3] = {1 << 17, 1 << 18, 1 << 18};

/* Returns half a level, Q23, if the format stores words as they are, and 0 if it adds thresholds. */
static inline uint32_t half_level(const glint_shading *shading) {
    return shading->suns->is_rounded ? 1 << 22 : 0;
}

static inline uint32_t least(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

/* Packs a colour, Q23 times 31, 63 and 31, to a word. */
static uint32_t spread_levels(const uint32_t level[3]) {
    return (level[0] >> 18) << 10 | (level[1] >> 19) << 21 | level[2] >> 19;
}

/* A colour that changes by `step` from entry to entry; entries are clamped at `most`. */
typedef struct level_ramp {
    uint32_t level[3], step[3], most[3];
} level_ramp;

/* Returns the word of a ramp's current entry. */
static uint32_t entry_of(const level_ramp *r) {
    const uint32_t level[3] = {least(r->level[0], r->most[0]), least(r->level[1], r->most[1]),
                               least(r->level[2], r->most[2])};
    return spread_levels(level);
}

/* Stores the next `count` words of a ramp. A level that rises stops within a step above `most`, so that none wraps. */
static void fill(level_ramp *r, uint32_t *words, uint32_t count) {
    for (uint32_t i = 0; i < count; i++) {
        words[i] = entry_of(r);
        for (int c = 0; c < 3; c++)
            if (r->level[c] <= r->most[c] || r->step[c] >> 31)
                r->level[c] += r->step[c];
    }
}

/* Begins the ramp of diffuse light over N.L in 512 steps, each of which has the colour of its middle. If the material
 * has one light only, the ramp includes ambient light and half a level. */
static void begin_diffuse_ramp(const glint_shading *shading, const glint_drawn_sun *sun, level_ramp *r) {
    const uint32_t *const weight = shading->weights[sun->number].diffuse;
    const int has_base = !shading->suns->sum_mask;
    for (int c = 0; c < 3; c++) {
        const uint32_t base = has_base ? least(shading->ambient[c], 1u << 23) * most_level[c] + half_level(shading) : 0;
        r->step[c] = weight[c] * most_level[c] << 2; /* Q12 to Q23, 512 steps; below 2^25 */
        r->most[c] = (most_level[c] << 23) + (has_base ? half_level(shading) : 0) + cut_half[c];
        r->level[c] = least(base + cut_half[c] + r->step[c] / 2, r->most[c]);
    }
}

uint32_t glint_ramp_word(const glint_shading *shading, const glint_drawn_sun *sun, uint32_t index) {
    level_ramp r;
    begin_diffuse_ramp(shading, sun, &r);
    for (int c = 0; c < 3; c++) {
        const uint64_t level = r.level[c] + (uint64_t)r.step[c] * index;
        r.level[c] = level > r.most[c] ? r.most[c] : (uint32_t)level;
    }
    return spread_levels(r.level);
}

/* Finds the colour of the highlight at node i, below 4 in each channel; Q23 times 31, 63 and 31. */
static void find_highlight(const glint_shading *shading, const glint_drawn_sun *sun, uint32_t i, uint32_t level[3]) {
    const glint_suns *suns = shading->suns;
    const uint32_t *const weight = shading->weights[sun->number].specular;
    uint32_t sine_square = (i << NODE_BITS) << suns->shift; /* Q30; of Phong, of half the angle */
    const uint32_t end = i << NODE_BITS >= GLINT_GLOSS_ENTRIES ? suns->end : sine_square;
    sine_square = end < suns->end ? sine_square : suns->end;
    if (suns->is_mirror) /* sin^2 2a = 4 sin^2 a (1 - sin^2 a) */
        sine_square = (uint32_t)((uint64_t)sine_square * ((1u << 30) - sine_square) >> 28);
    const uint32_t power = end < suns->end ? glint_power_at(&shading->power, sine_square) : 0;
    for (int c = 0; c < 3; c++)
        level[c] = least(power * weight[c] >> 4, (1u << 25) - 1) * most_level[c];
}

/* Begins the ramp from a node of the highlight to the next; each entry has the colour of its middle. Steps may be below
 * 0, modulo 2^32. */
static void begin_highlight_ramp(const uint32_t here[3], const uint32_t next[3], level_ramp *r) {
    for (int c = 0; c < 3; c++) {
        const int32_t change = (int32_t)(next[c] - here[c]);
        r->step[c] = (uint32_t)glint_shift_right(change, NODE_BITS);
        r->level[c] = here[c] + (uint32_t)glint_shift_right(change, NODE_BITS + 1) + cut_half[c];
        r->most[c] = (most_level[c] << 23) + cut_half[c];
    }
}

uint32_t glint_gloss_word(const glint_shading *shading, const glint_drawn_sun *sun, uint32_t index) {
    uint32_t here[3], next[3];
    level_ramp r;
    find_highlight(shading, sun, index >> NODE_BITS, here);
    find_highlight(shading, sun, (index >> NODE_BITS) + 1, next);
    begin_highlight_ramp(here, next, &r);
    for (int c = 0; c < 3; c++)
        r.level[c] += r.step[c] * (index & ((1 << NODE_BITS) - 1));
    return entry_of(&r);
}

/* Makes the table of highlights of a light. */
static void fill_gloss(const glint_shading *shading, const glint_drawn_sun *sun, uint32_t *words) {
    uint32_t here[3], next[3];
    find_highlight(shading, sun, 0, here);
    for (uint32_t i = 0; i < GLINT_GLOSS_ENTRIES >> NODE_BITS; i++) {
        level_ramp r;
        find_highlight(shading, sun, i + 1, next);
        begin_highlight_ramp(here, next, &r);
        fill(&r, words + (i << NODE_BITS), 1 << NODE_BITS);
        for (int c = 0; c < 3; c++)
            here[c] = next[c];
    }
}

void glint_ramps_make(const glint_shading *shading, glint_drawn_sun *sun, uint32_t *tables,
                      const uint32_t *last_tables) {
    const size_t size = glint_ramps_size(sun);
    level_ramp r;
    sun->ramp = tables;
    sun->gloss = sun->shines ? tables + GLINT_RAMP_ENTRIES + 3 : 0;
    if (tables == last_tables && glint_sum(tables, size) == sun->sum)
        return;
    begin_diffuse_ramp(shading, sun, &r);
    fill(&r, tables, GLINT_RAMP_ENTRIES + 3);
    if (sun->shines)
        fill_gloss(shading, sun, tables + GLINT_RAMP_ENTRIES + 3);
    sun->sum = glint_sum(tables, size);
}

/* ---- Where highlights end ---- */

/* Returns the largest channel of the specular weights of all lights. */
static uint32_t largest_specular(const glint_shading *shading) {
    uint32_t largest = 0;
    for (uint32_t i = 0; shading->has_specular >> i; i++)
        for (int c = 0; c < 3; c++)
            if (shading->has_specular >> i & 1 && shading->weights[i].specular[c] > largest)
                largest = shading->weights[i].specular[c];
    return largest;
}

/* Returns sin^2 of the angle at which the highlight ends, Q30; of Phong, of half the angle. */
static uint32_t find_highlight_end(const glint_shading *shading, uint32_t largest) {
    const int fine_bits = shading->suns->bits > 6 ? shading->suns->bits - 6 : 0;
    const int64_t bits =
        (int64_t)glint_log2(largest << 15) + ((4 + CUT_BITS + fine_bits) << 26); /* Q26; the weight is Q12 */
    if (!largest || bits <= 0)
        return 0;
    const int64_t twice = (2 * bits << 16) / shading->shininess;
    if (!shading->suns->is_mirror)
        return (1u << 30) - glint_exp2(twice < 31 << 26 ? (int32_t)-twice : -(31 << 26));
    return (1u << 29) - glint_exp2(twice / 2 < 31 << 26 ? (int32_t) - (twice / 2) : -(31 << 26)) / 2;
}

/*
 * Sets `far` and `far_slope`, in their formats, so that far + far_slope d^2 is no less than sin^2(a + b), where a is
 * the angle at which highlights end, and b^2 is a third of d^2. sin^2(a + b) = sin^2 a + sin^2 b (1 - 2 sin^2 a) + 2 k
 * sin b cos b, where k = sin a cos a. The last part is at most k (t + sin^2 b / t) for any t, and closest where b is
 * about t: here 1/4.
 */
static void set_far(glint_suns *suns, uint32_t end) {
    const uint32_t k = glint_square_root((uint64_t)end * ((1u << 30) - end) >> 30); /* Q15 */
    suns->far = (end >> 14) + k / 2 + 4;
    suns->far_slope = ((1u << 15) + 4 * k - 2 * least(end >> 15, (1u << 14) + 2 * k)) / 96 + 1;
}

/*
 * Where a highlight is steepest, it changes by 63 weight (0.61 sqrt(p) + 2.5 / p) levels a radian. If the angle of H
 * changes by d over a triangle, an H that is linear between corners is off by up to 0.16 d^2, which may be 0.3 of a
 * level. V is off by half of that, and in triangles with planes by an eighth. In wide views V turns unevenly, and H is
 * off by more: the limit goes down with z of V in a corner of the screen, from 11/16 on.
 */
#define BEND_LIMIT (60u << 23)
#define NARROW_Z (11 << 11)

/* Scalars are precise enough for highlights up to these exponents, times weights above 1: of Phong, of channels of 8
 * bits, and of all others. */
#define MOST_MIRRORED (32 * GLINT_ONE)
#define MOST_FINE (128 * GLINT_ONE)
#define MOST_EXPONENT (256 * GLINT_ONE)

/* Larger exponents do not lower the limit of H's change any more: the highlight is then a small part of a triangle. */
#define SMALL_EXPONENT (96 * GLINT_ONE)

void glint_ramps_prepare(glint_suns *suns, const glint_shading *shading) {
    uint32_t level[3], half[3];
    for (int c = 0; c < 3; c++) {
        half[c] = half_level(shading);
        level[c] = least(shading->ambient[c], 1u << 23) * most_level[c] + (half[c] ? half[c] : cut_half[c]);
    }
    suns->dark = spread_levels(level);
    suns->half_level = spread_levels(half);
    suns->first = suns->takes_most ? suns->half_level : suns->dark;
    suns->end = 0;
    suns->shift = 0;
    suns->bend = 0;
    suns->small_bend = 0;
    if (!shading->has_specular)
        return;
    const uint32_t largest = largest_specular(shading), p = least((uint32_t)shading->shininess, SMALL_EXPONENT),
                   slope = (glint_square_root(p) * 156 >> 8) + (640u << 16) / (p | 1);
    const int32_t most = suns->is_mirror ? MOST_MIRRORED : suns->bits > 6 ? MOST_FINE : MOST_EXPONENT;
    suns->end = find_highlight_end(shading, largest);
    while (suns->end >> suns->shift >= GLINT_GLOSS_ENTRIES)
        suns->shift++;
    set_far(suns, suns->end);
    if ((uint64_t)shading->shininess * (largest > 1u << 12 ? largest : 1u << 12) >> 12 > (uint32_t)most)
        return; /* `bend` of 0 leaves all triangles with a visible highlight to lamps */
    const uint64_t steep = (uint64_t)largest * slope * (suns->bits > 6 ? 150 : 63) + 1, /* Q20 */
        limit = (uint64_t)(BEND_LIMIT / NARROW_Z) * least((uint32_t)suns->ray_z, NARROW_Z),
                   bend = (limit << (20 + suns->is_mirror)) / steep;
    suns->bend = bend < 1u << 28 ? (uint32_t)bend : 1u << 28;
    suns->small_bend = (int32_t)(suns->bend >> (suns->is_mirror ? 3 : 2)) + (1 << 15); /* rounding costs up to 2^15 */
}
