/* SPDX-License-Identifier: MIT */
/**
 * @file deflate.c
 * Deflate (RFC 1951) as one block of the fixed code: the longest of some earlier matches, taken unless the next byte
 * starts a longer one.
 */
#include "png.h"

#include "basics.h"

#include <stdlib.h>

#define MATCH_MIN 3
#define MATCH_MAX 258
#define WINDOW 32768u
#define HASH_BITS 15
#define CHAIN_MAX 256
#define END_OF_BLOCK 256u

/** What is packed, and where its three bytes were seen before: positions plus one, 0 for none. */
typedef struct packer {
    const uint8_t *data;
    size_t count;
    size_t *latest; /* by hash */
    size_t *before; /* by position within the window */
    host_bytes *out;
    uint32_t pending; /* bits not yet written, the first one lowest */
    int bits;         /* of them, below 8 between calls */
} packer;

/** A run of bytes that came `distance` bytes before; no match when `length` is 0. */
typedef struct match {
    uint32_t length, distance;
} match;

static void put_bits(packer *to, uint32_t value, int count) {
    to->pending |= value << to->bits;
    for (to->bits += count; to->bits >= 8; to->bits -= 8) {
        bytes_add(to->out, (uint8_t)(to->pending & 0xFF));
        to->pending >>= 8;
    }
}

/** Writes a code, whose highest bit goes first. */
static void put_code(packer *to, uint32_t code, int length) {
    while (length-- > 0) {
        put_bits(to, code >> length & 1u, 1);
    }
}

/** Writes a literal, the end of the block, or a length's symbol (RFC 1951, 3.2.6). */
static void put_symbol(packer *to, uint32_t symbol) {
    if (symbol < 144) {
        put_code(to, 0x30 + symbol, 8);
    } else if (symbol < 256) {
        put_code(to, 0x190 + symbol - 144, 9);
    } else if (symbol < 280) {
        put_code(to, symbol - 256, 7);
    } else {
        put_code(to, 0xC0 + symbol - 280, 8);
    }
}

/** Symbols come in groups of 2^`bits` that share a number of extra bits, which doubles. @return the symbol */
static uint32_t split_extra(uint32_t rest, int bits, int *extra) {
    *extra = 0;
    while ((rest >> *extra) >= (2u << bits)) {
        (*extra)++;
    }
    return ((uint32_t)*extra << bits) + (rest >> *extra);
}

static void put_match(packer *to, match found) {
    int extra = 0;
    const uint32_t rest = found.length - MATCH_MIN;
    put_symbol(to, found.length == MATCH_MAX ? 285 : 257 + split_extra(rest, 2, &extra));
    put_bits(to, rest & ((1u << extra) - 1), extra);
    put_code(to, split_extra(found.distance - 1, 1, &extra), 5);
    put_bits(to, (found.distance - 1) & ((1u << extra) - 1), extra);
}

static size_t *latest_of(const packer *from, size_t at) {
    const uint8_t *c = from->data + at;
    const uint32_t word = c[0] | (uint32_t)c[1] << 8 | (uint32_t)c[2] << 16;
    return &from->latest[(word * 2654435761u) >> (32 - HASH_BITS)];
}

/** Notes the bytes at a place as seen. */
static void note(packer *from, size_t at) {
    if (from->count - at >= MATCH_MIN) {
        size_t *latest = latest_of(from, at);
        from->before[at % WINDOW] = *latest;
        *latest = at + 1;
    }
}

/** The longest match of those tried, the nearest of them. */
static match find_match(const packer *from, size_t at) {
    match best = {0, 0};
    const size_t left = from->count - at;
    const size_t limit = left < MATCH_MAX ? left : MATCH_MAX;
    size_t seen = left >= MATCH_MIN ? *latest_of(from, at) : 0;
    for (int tries = 0; tries < CHAIN_MAX && seen > 0 && at + 1 - seen < WINDOW; tries++) {
        size_t length = 0;
        while (length < limit && from->data[seen - 1 + length] == from->data[at + length]) {
            length++;
        }
        if (length >= MATCH_MIN && length > best.length) {
            best = (match){(uint32_t)length, (uint32_t)(at + 1 - seen)};
        }
        seen = from->before[(seen - 1) % WINDOW];
    }
    return best;
}

uint32_t zlib_sum(const uint8_t *data, size_t count) {
    uint32_t a = 1;
    uint32_t b = 0;
    for (size_t i = 0; i < count; i++) {
        a = (a + data[i]) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

void zlib_encode(host_bytes *out, const uint8_t *data, size_t count) {
    packer to = {.data = data, .count = count, .out = out};
    to.latest = memory_new((size_t)1 << HASH_BITS, sizeof *to.latest);
    to.before = memory_new(WINDOW, sizeof *to.before);
    bytes_add(out, 0x78); /* 32 KB window */
    bytes_add(out, 0x01);
    put_bits(&to, 3, 3); /* the last block, of the fixed code */
    for (size_t at = 0; at < count;) {
        match found = find_match(&to, at);
        note(&to, at);
        if (found.length > 0 && at + 1 < count && find_match(&to, at + 1).length > found.length) {
            found.length = 0;
        }
        if (found.length > 0) {
            put_match(&to, found);
        } else {
            put_symbol(&to, data[at]);
        }
        const size_t end = at + (found.length > 0 ? found.length : 1);
        while (++at < end) {
            note(&to, at);
        }
    }
    put_symbol(&to, END_OF_BLOCK);
    put_bits(&to, 0, 7); /* fill the last byte */
    const uint32_t check = zlib_sum(data, count);
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes_add(out, (uint8_t)(check >> shift & 0xFF));
    }
    free(to.before);
    free(to.latest);
}
