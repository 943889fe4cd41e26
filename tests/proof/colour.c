/* SPDX-License-Identifier: MIT */
/* Colours: gamma, clamping, and the perspective divide. */
#include "proof.h"

#include "../../src/light/colour.c"
#include "../../src/pixel/gamma.c"
#include "contracts.h"
#include "pixels.h"

/* Stands on a value between two entries of the table: `make domains` takes every channel. */
/*@ requires \valid_read(table + (0 .. 256));
    requires \initialized(table + (0 .. 256));
    assigns \result \from table[0 .. 256], channel;
    admit ensures 0 <= \result <= 0x8000000; */
static inline int32_t look_up(const uint16_t *table, int32_t channel);

/*@ requires -0x8000000 <= channel <= 0x78000000;
    requires bits <= 8;
    assigns \result \from channel, bits;
    ensures -0x8000000 <= \result <= 0x78000000; */
static inline int32_t glint_to_levels(int32_t channel, unsigned bits);

/* Any channel through any table. */
PROOF(look_up) {
    uint16_t table[GLINT_GAMMA_ENTRIES];
    for (int i = 0; i < GLINT_GAMMA_ENTRIES; i++)
        table[i] = (uint16_t)ANY(0, UINT16_MAX);
    FOR_PARTS(entry, -1, GLINT_GAMMA_ENTRIES - 1) {
        const int32_t first = entry < 0 ? INT32_MIN : entry << 19;
        look_up(table, ANY(first, entry < 0 ? -1 : entry < 256 ? first + (1 << 19) - 1 : INT32_MAX));
    }
}

/* Every colour of 15 bits. */
PROOF(glint_channel_of) {
    const int32_t channel = glint_channel_of((int16_t)ANY(0, GLINT_COLOUR_ONE));
    /*@ assert 0 <= channel <= 0x8000000; */
}

/* Any channel, of each number of bits that a format's may have, and as it is. */
PROOF(glint_to_levels) {
    FOR_PARTS(bits, 0, 8) {
        FOR_PARTS(part, CHANNEL_LEAST >> 23, CHANNEL_MOST >> 23) {
            const int32_t levels =
                glint_to_levels(ANY(part * (1 << 23), part < 15 << 4 ? part * (1 << 23) + (1 << 23) - 1 : CHANNEL_MOST),
                                (unsigned)bits);
            /*@ assert CHANNEL_LEAST <= levels <= CHANNEL_MOST; */
        }
    }
}

/*
 * Some of any channels, in levels of any bits, and through any tables whatever there is.
 * @contract look_up glint_to_levels
 */
PROOF(glint_finish_colours) {
    uint16_t gamma[3][GLINT_GAMMA_ENTRIES];
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < GLINT_GAMMA_ENTRIES; i++)
            gamma[c][i] = (uint16_t)ANY(0, UINT16_MAX);
    FOR_PARTS(kind, 0, 7) {
        const uint8_t bits[4] = {0, 4, 5, 8};
        const glint_format format = {.channel = {bits[kind & 3], kind & 3 ? 6 : 0, bits[kind & 3]}};
        const glint_config config = {.format = &format, .gamma = kind & 4 ? (const void *)gamma : 0};
        FOR_PARTS(count, 1, 3) {
            int32_t colour[3][3];
            for (int i = 0; i < 3; i++)
                for (int c = 0; c < 3; c++)
                    colour[i][c] = kind & 4 ? ANY_INT : ANY_CHANNEL;
            glint_finish_colours(&config, colour, (uint32_t)count);
        }
    }
}

/*
 * Any fragment of any row, planes of any values, and 1/w that its scale leaves in 32 bits, by its bits.
 * @unreached 1 leading zeros of 0
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(glint_resolve_colour) {
    glint_frame frame;
    glint_fragments fragments;
    glint_attributes attributes;
    glint_part part;
    int16_t out[3];
    any_planes(&attributes);
    any_run(&frame, &fragments, &part, 1);
    fragments.attributes = &attributes;
    FOR_PARTS(bits, 0, 32) { /* of 1/w 2^scale, which is all that is used of the two */
        fragments.scale = bits == 32;
        fragments.inverse_w[0] = (int32_t)ANY_OF_BITS(bits == 32 ? 31 : bits);
        glint_resolve_colour(&fragments, 0, attributes.main, out);
        /*@ assert \subset(out[0 .. 2], (0 .. 32767)); */
    }
    FOR_PARTS(scale, 0, 30) {
        fragments.scale = (uint32_t)scale;
        fragments.inverse_w[0] = 1;
        glint_resolve_colour(&fragments, 0, attributes.main, out);
    }
}
