/* SPDX-License-Identifier: MIT */
/* Levels of a channel, and thresholds. */
#include "proof.h"

#include "../../src/pixel/pixel.h"
#include "contracts.h"

/* A channel before it is clamped, in levels or not; the value of a plane at a pixel may lie beyond those of corners. */
#define ANY_CHANNEL ANY(-(1 << 27), 15 << 27)

/* Any channel, in levels of each number of bits, and any threshold. */
PROOF(glint_level) {
    FOR_PARTS(bits, 4, 8) {
        const uint32_t level = glint_level(ANY_CHANNEL, (unsigned)bits, ANY_UNSIGNED(0, 128));
        /*@ assert level < 1 << bits; */
    }
}

/* Any channels, whatever their range, as one of any number of levels, any threshold. @unsigned */
PROOF(glint_luma_level) {
    FOR_PARTS(bits, 1, 8) {
        const int32_t colour[3] = {ANY_INT, ANY_INT, ANY_INT};
        glint_luma_level(colour, (1u << bits) - 1, ANY_UNSIGNED(0, 127));
    }
}

/* Any offset in a tile of any width, dithered and not. */
PROOF(glint_threshold) {
    FOR_PARTS(shift, 3, 6) {
        const glint_target target = {0, (unsigned)shift, ANY(0, 1)};
        glint_threshold(&target, ANY_UNSIGNED(0, UINT_MAX));
    }
}
