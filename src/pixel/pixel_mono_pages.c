/* SPDX-License-Identifier: MIT */
/* Pixels of 1 bit: luma, in pages of 8 rows, a byte for each column of a page, its top row lowest. */
#include "pixel.h"

static inline uint32_t pack_mono_pages(const int32_t colour[3], uint32_t threshold) {
    return glint_luma_level(colour, 1, threshold);
}

static inline uint32_t pack_spread_mono_pages(uint32_t word, uint32_t threshold) {
    return glint_spread_luma(word, 1, threshold);
}

static inline void put_mono_pages(const glint_target *target, uint32_t offset, uint32_t packed) {
    const uint32_t x = offset & ((1u << target->shift) - 1), y = offset >> target->shift, bit = y & 7;
    uint8_t *eight = (uint8_t *)target->pixels + ((y >> 3 << target->shift) + x);
    *eight = (uint8_t)((*eight & ~(1u << bit)) | packed << bit);
}

/* 8 columns of a page, copied to all others. */
static inline void fill_pages(const glint_target *t, uint32_t height, const int32_t colour[3], uint32_t bits,
                              glint_pack_colour pack_one, glint_put put_one) {
    (void)bits;
    for (uint32_t i = 0; i < 64; i++) {
        const uint32_t offset = (i >> 3 << t->shift) + (i & 7);
        put_one(t, offset, pack_one(colour, glint_threshold(t, offset)));
    }
    glint_repeat(t->pixels, 8, height << t->shift >> 3);
}

GLINT_DEFINE_SPREAD(mono_pages, pack_spread_mono_pages, put_mono_pages, 0)
GLINT_DEFINE_SPREAD(mono_pages_dithered, pack_spread_mono_pages, put_mono_pages, 1)
GLINT_DEFINE_FORMAT(mono_pages, 1, GLINT_PAGE_EDGE, 0, 0, 0, pack_mono_pages, put_mono_pages, fill_pages,
                    GLINT_KEEPS_ANY, GLINT_SPREAD_ANY, GLINT_SPREAD_ANY);
