/* SPDX-License-Identifier: MIT */
/**
 * @file inflate.c
 * Unpacks zlib streams (RFC 1950) of all blocks of Deflate (RFC 1951).
 */
#include "png.h"

#include "basics.h"

#include <string.h>

#define CODE_BITS 15
#define LITERALS 288
#define DISTANCES 30
#define END_OF_BLOCK 256

/** A prefix code: how many codes each length has, and their symbols in the codes' order (RFC 1951, 3.2.2). */
typedef struct prefix_code {
    uint16_t counts[CODE_BITS + 1];
    uint16_t symbols[LITERALS];
} prefix_code;

typedef struct unpacker {
    const uint8_t *at, *end;
    uint32_t pending; /* bits that were read and not used, the first one lowest */
    int bits;         /* of them */
    bool is_cut;      /* whether bits were asked for beyond the end, which are 0 */
    uint8_t *out;
    size_t made, room;
} unpacker;

/* ---- Bits and codes --------------------------------------------------------------------------------------------- */

static uint32_t take_bits(unpacker *from, int count) {
    while (from->bits < count) {
        from->is_cut = from->is_cut || from->at == from->end;
        from->pending |= (from->at < from->end ? *from->at++ : 0u) << from->bits;
        from->bits += 8;
    }
    const uint32_t value = from->pending & ((1u << count) - 1);
    from->pending >>= count;
    from->bits -= count;
    return value;
}

/** Makes the code whose symbols have these lengths, 0 for none. @return false where there are more than can be */
static bool make_code(prefix_code *code, const uint8_t *lengths, size_t count) {
    uint16_t starts[CODE_BITS + 2] = {0};
    int left = 1;
    memset(code, 0, sizeof *code);
    for (size_t i = 0; i < count; i++) {
        code->counts[lengths[i]]++;
    }
    code->counts[0] = 0;
    for (int length = 1; length <= CODE_BITS; length++) {
        left = 2 * left - code->counts[length];
        if (left < 0) {
            return false;
        }
        starts[length + 1] = (uint16_t)(starts[length] + code->counts[length]);
    }
    for (size_t i = 0; i < count; i++) {
        if (lengths[i] > 0) {
            code->symbols[starts[lengths[i]]++] = (uint16_t)i;
        }
    }
    return true;
}

/** Reads a symbol. @return -1 where no code stands there */
static int take_symbol(unpacker *from, const prefix_code *code) {
    uint32_t word = 0;  /* the bits so far, as a number... */
    uint32_t first = 0; /* ...and the first code of this length */
    uint32_t before = 0;
    for (int length = 1; length <= CODE_BITS; length++) {
        word = word << 1 | take_bits(from, 1);
        first <<= 1;
        if (word - first < code->counts[length]) {
            return code->symbols[before + word - first];
        }
        before += code->counts[length];
        first += code->counts[length];
    }
    return -1;
}

/* ---- Blocks ----------------------------------------------------------------------------------------------------- */

static bool put(unpacker *to, uint8_t value) {
    if (to->made == to->room) {
        return false;
    }
    to->out[to->made++] = value;
    return true;
}

static bool copy_stored(unpacker *from) {
    from->pending = 0; /* up to the next byte: at most 7 bits are pending here */
    from->bits = 0;
    if (from->end - from->at < 4) {
        return false;
    }
    const size_t length = from->at[0] | (size_t)from->at[1] << 8;
    const size_t inverse = from->at[2] | (size_t)from->at[3] << 8;
    from->at += 4;
    if ((length ^ inverse) != 0xFFFF || (size_t)(from->end - from->at) < length || from->room - from->made < length) {
        return false;
    }
    memcpy(from->out + from->made, from->at, length);
    from->made += length;
    from->at += length;
    return true;
}

/** Returns the least value of a symbol of a length or a distance, whose extra bits double every 2^`shift` symbols. */
static uint32_t take_value(unpacker *from, uint32_t symbol, int shift) {
    const uint32_t extra = symbol >> shift > 0 ? (symbol >> shift) - 1 : 0;
    const uint32_t low = symbol >> shift > 0 ? 1u << shift : 0;
    return ((low | (symbol & ((1u << shift) - 1))) << extra) + take_bits(from, (int)extra);
}

static bool copy_match(unpacker *from, int symbol, const prefix_code *distances) {
    const uint32_t length = symbol == 285 ? 258 : 3 + take_value(from, (uint32_t)symbol - 257, 2);
    const int place = take_symbol(from, distances);
    if (symbol > 285 || place < 0 || place >= DISTANCES) {
        return false;
    }
    const uint32_t distance = 1 + take_value(from, (uint32_t)place, 1);
    if (distance > from->made || length > from->room - from->made) {
        return false;
    }
    for (uint32_t i = 0; i < length; i++) {
        from->out[from->made] = from->out[from->made - distance];
        from->made++;
    }
    return true;
}

static bool unpack_block(unpacker *from, const prefix_code *literals, const prefix_code *distances) {
    int symbol = take_symbol(from, literals);
    while (symbol != END_OF_BLOCK) {
        if (symbol < 0 || from->is_cut ||
            !(symbol < END_OF_BLOCK ? put(from, (uint8_t)symbol) : copy_match(from, symbol, distances))) {
            return false;
        }
        symbol = take_symbol(from, literals);
    }
    return true;
}

static bool unpack_fixed(unpacker *from) {
    uint8_t lengths[LITERALS];
    uint8_t fives[DISTANCES];
    prefix_code literals;
    prefix_code distances;
    for (int i = 0; i < LITERALS; i++) {
        lengths[i] = (uint8_t)(i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8);
    }
    memset(fives, 5, sizeof fives);
    return make_code(&literals, lengths, LITERALS) && make_code(&distances, fives, DISTANCES) &&
           unpack_block(from, &literals, &distances);
}

/** Reads the lengths of both codes, which are packed by a third one (RFC 1951, 3.2.7). */
static bool take_lengths(unpacker *from, const prefix_code *code, uint8_t *lengths, size_t count) {
    size_t made = 0;
    while (made < count) {
        const int symbol = take_symbol(from, code);
        size_t times = 1;
        uint8_t length = (uint8_t)symbol;
        if (symbol < 0 || from->is_cut || (symbol == 16 && made == 0)) {
            return false;
        }
        if (symbol >= 16) {
            length = symbol == 16 ? lengths[made - 1] : 0;
            times = symbol == 18 ? 11 + take_bits(from, 7) : 3 + take_bits(from, symbol == 16 ? 2 : 3);
        }
        if (times > count - made) {
            return false;
        }
        memset(lengths + made, length, times);
        made += times;
    }
    return true;
}

static bool unpack_dynamic(unpacker *from) {
    static const uint8_t order[19] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    const size_t literal_count = 257 + take_bits(from, 5);
    const size_t distance_count = 1 + take_bits(from, 5);
    const size_t length_count = 4 + take_bits(from, 4);
    uint8_t lengths[LITERALS + 32] = {0};
    prefix_code code;
    prefix_code distances;
    if (literal_count > 286) {
        return false;
    }
    for (size_t i = 0; i < length_count; i++) {
        lengths[order[i]] = (uint8_t)take_bits(from, 3);
    }
    if (!make_code(&code, lengths, 19) || !take_lengths(from, &code, lengths, literal_count + distance_count)) {
        return false;
    }
    return make_code(&code, lengths, literal_count) && make_code(&distances, lengths + literal_count, distance_count) &&
           unpack_block(from, &code, &distances);
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

bool zlib_decode(const uint8_t *data, size_t count, uint8_t *out, size_t size) {
    unpacker from = {.at = data, .end = data + count, .out = out, .room = size};
    const uint32_t method = take_bits(&from, 8);
    const uint32_t flags = take_bits(&from, 8);
    bool ok = (method & 15) == 8 && (256 * method + flags) % 31 == 0 && (flags & 32) == 0;
    for (bool is_last = false; ok && !is_last;) {
        is_last = take_bits(&from, 1) == 1;
        switch (take_bits(&from, 2)) {
        case 0:
            ok = copy_stored(&from);
            break;
        case 1:
            ok = unpack_fixed(&from);
            break;
        case 2:
            ok = unpack_dynamic(&from);
            break;
        default:
            ok = false;
        }
        ok = ok && !from.is_cut;
    }
    uint32_t sum = 0;
    take_bits(&from, from.bits % 8);
    for (int i = 0; i < 4; i++) {
        sum = sum << 8 | take_bits(&from, 8);
    }
    return ok && !from.is_cut && from.made == size && sum == zlib_sum(out, size);
}
