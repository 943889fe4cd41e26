/* SPDX-License-Identifier: MIT */
/* Fast lighting's tables of colour: what a material makes of N.L, and of the deviation. */
#include "../frame/frame.h"
#include "../light/model.h"
#include "../pixel/format.h"
#include "fast.h"

/* Binary logarithm of the specular table's entries for each node that is computed; it is linear between them. */
#define NODE_BITS 3

/* Bytes of a diffuse table. */
#define WORD_BYTES (GLINT_DIFFUSE_ENTRIES * sizeof(uint32_t))
#define PIXEL_BYTES (GLINT_DIFFUSE_ENTRIES * sizeof(uint16_t))

size_t glint_fast_tables_size(const glint_format *format, uint32_t specular) {
    return GLINT_ALIGNED(WORD_BYTES + (format->fast->stores_spread ? 0 : PIXEL_BYTES) + specular * sizeof(uint32_t));
}

/* A colour, Q23 times 31, 63 and 31, as a word. */
static uint32_t spread_levels(const uint32_t level[3]) {
    return (level[0] >> 18) << 10 | (level[1] >> 19) << 21 | level[2] >> 19;
}

/* Half of what `spread` cuts off. */
static const uint32_t spread_half[3] = {1 << 17, 1 << 18, 1 << 18};

/* Half a level, Q23, where words are stored as they are; what the format packs has its thresholds added. */
static inline uint32_t half_of(const glint_shading *shading) {
    return shading->fast->is_rounded ? 1 << 22 : 0;
}

/* What is added to diffuse light before it is cut off. */
static inline uint32_t rounding_of(const glint_shading *shading, int c) {
    return half_of(shading) + (shading->lights || !shading->fast->is_rounded ? spread_half[c] : 0);
}

static inline uint32_t least(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

/* A colour that changes by `step` from entry to entry, up to `most`. */
typedef struct level_ramp {
    uint32_t level[3], step[3], most[3];
} level_ramp;

/* Its first `count` words. */
static void fill(const level_ramp *r, uint32_t *words, uint32_t count) {
    uint32_t red = r->level[0], green = r->level[1], blue = r->level[2];
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t level[3] = {red, green, blue};
        words[i] = spread_levels(level);
        red = least(red + r->step[0], r->most[0]);
        green = least(green + r->step[1], r->most[1]);
        blue = least(blue + r->step[2], r->most[2]);
    }
}

/* Ambient and diffuse light over N.L in 256 steps, the first at its middle; where no light shows, `ambient`. */
static void diffuse_ramp(const glint_shading *shading, level_ramp *r) {
    const uint32_t *const weight = glint_weights_shown(shading)->diffuse;
    for (int c = 0; c < 3; c++) {
        const uint32_t ambient = least(shading->ambient[c], 1u << 23);
        r->step[c] = weight[c] * glint_fast_levels[c] << 3; /* Q12 to Q23, 256 steps; below 2^26 */
        r->most[c] = (glint_fast_levels[c] << 23) + half_of(shading) + spread_half[c];
        r->level[c] = least(ambient * glint_fast_levels[c] + rounding_of(shading, c) + r->step[c] / 2, r->most[c]);
    }
}

/* The larger of ambient and diffuse light, not their sum. */
static GLINT_NOINLINE uint32_t larger_word(const glint_shading *shading, uint32_t index) {
    level_ramp r;
    diffuse_ramp(shading, &r);
    for (int c = 0; c < 3; c++) {
        const uint32_t ambient = least(shading->ambient[c], 1u << 23) * glint_fast_levels[c],
                       half = rounding_of(shading, c);
        const uint64_t diffuse = half + r.step[c] / 2 + (uint64_t)r.step[c] * index;
        r.level[c] = diffuse < ambient + half ? ambient + half : diffuse > r.most[c] ? r.most[c] : (uint32_t)diffuse;
    }
    return spread_levels(r.level);
}

static uint32_t diffuse_word(const glint_shading *shading, uint32_t index) {
    level_ramp r;
    if (glint_takes_largest(shading))
        return larger_word(shading, index);
    diffuse_ramp(shading, &r);
    for (int c = 0; c < 3; c++) {
        uint64_t level = r.level[c] + (uint64_t)r.step[c] * index;
        r.level[c] = level > r.most[c] ? r.most[c] : (uint32_t)level;
    }
    return spread_levels(r.level);
}

/* Highlight at node i, clamped at 1 in each channel; Q23 times 31, 63 and 31. */
static void highlight(const glint_shading *shading, uint32_t i, uint32_t level[3]) {
    const glint_fast_terms *fast = shading->fast;
    const uint32_t *const weight = glint_weights_shown(shading)->specular;
    const unsigned bits = 31 - glint_leading_zeros(fast->specular_end >> (15 + NODE_BITS)); /* of their number */
    uint32_t power = glint_power_at(&shading->power, (uint32_t)((uint64_t)fast->sine_square_end * i >> bits));
    for (int c = 0; c < 3; c++) {
        uint32_t amount = power * weight[c] >> 4;
        level[c] = least(amount, 1u << 23) * glint_fast_levels[c];
    }
}

/* From a node of the highlight to the next, the first entry at its middle; downwards modulo 2^32. */
static void highlight_ramp(const uint32_t here[3], const uint32_t next[3], level_ramp *r) {
    for (int c = 0; c < 3; c++) {
        const int32_t change = (int32_t)(next[c] - here[c]);
        r->step[c] = (uint32_t)glint_shift_right(change, NODE_BITS);
        r->level[c] = here[c] + (uint32_t)glint_shift_right(change, NODE_BITS + 1) + spread_half[c];
        r->most[c] = UINT32_MAX;
    }
}

static uint32_t highlight_word(const glint_shading *shading, uint32_t index) {
    uint32_t here[3], next[3];
    level_ramp r;
    highlight(shading, index >> NODE_BITS, here);
    highlight(shading, (index >> NODE_BITS) + 1, next);
    highlight_ramp(here, next, &r);
    for (int c = 0; c < 3; c++)
        r.level[c] += r.step[c] * (index & ((1 << NODE_BITS) - 1));
    return spread_levels(r.level);
}

uint32_t glint_fast_word(const glint_shading *shading, int32_t cosine, uint32_t square) {
    if (cosine <= 0)
        return shading->fast->ambient_word;
    const uint32_t word = diffuse_word(shading, (uint32_t)cosine >> 22);
    return square < shading->fast->specular_end ? word + highlight_word(shading, square >> 15) : word;
}

static void fill_specular(const glint_shading *shading, uint32_t *words, uint32_t entries) {
    uint32_t here[3], next[3];
    highlight(shading, 0, here);
    for (uint32_t i = 0; i < entries >> NODE_BITS; i++) {
        level_ramp r;
        highlight(shading, i + 1, next);
        highlight_ramp(here, next, &r);
        fill(&r, words + (i << NODE_BITS), 1 << NODE_BITS);
        for (int c = 0; c < 3; c++)
            here[c] = next[c];
    }
}

/* The tables, if they leave room to draw any scene; nothing is to be done where the last frame left them, unspoilt. */
void glint_fast_make_tables(glint_frame *frame, glint_fast_terms *fast, const glint_shading *shading) {
    glint_memory *const memory = &frame->memory;
    const uint32_t entries = fast->specular_end >> 15, *const kept = fast->diffuse;
    const size_t size = glint_fast_tables_size(frame->config.format, entries);
    level_ramp r;
    fast->diffuse = 0;
    if (memory->high - GLINT_ALIGNED(memory->low) < size + glint_room_behind_tables(size))
        return;
    uint32_t *const specular = glint_take(memory, size), *const diffuse = specular + entries;
    uint16_t *pixels = (uint16_t *)(void *)(diffuse + GLINT_DIFFUSE_ENTRIES);
    fast->specular = specular;
    fast->diffuse = diffuse;
    fast->diffuse_stored = fast->is_rounded ? (const void *)pixels : diffuse;
    if (diffuse == kept && glint_sum(specular, size) == fast->tables_sum)
        return;
    if (entries)
        fill_specular(shading, specular, entries);
    diffuse_ramp(shading, &r);
    fill(&r, diffuse, GLINT_DIFFUSE_ENTRIES);
    for (uint32_t i = 0; i < GLINT_DIFFUSE_ENTRIES && glint_takes_largest(shading); i++)
        diffuse[i] = larger_word(shading, i);
    for (uint32_t i = 0; i < GLINT_DIFFUSE_ENTRIES && fast->is_rounded; i++)
        pixels[i] = (uint16_t)glint_spread_pack(fast->diffuse[i]);
    fast->tables_sum = glint_sum(specular, size);
}

void glint_fast_prepare_words(glint_fast_terms *fast, const glint_format *format, const glint_shading *shading) {
    uint32_t level[3];
    fast->is_rounded = !format->fast->stores_spread;
    for (int c = 0; c < 3; c++)
        level[c] = least(shading->ambient[c], 1u << 23) * glint_fast_levels[c] +
                   (fast->is_rounded ? 1u << 22 : spread_half[c]);
    fast->ambient_word = spread_levels(level);
    fast->ambient = (uint16_t)glint_spread_pack(fast->ambient_word);
}
