/* SPDX-License-Identifier: MIT */
/**
 * @file inflate.c
 * Inflate (RFC 1951), a bit at a time: small and safe before fast.
 */
#include "inflate.h"

#include "deflate.h"

#include <string.h>

#define CODE_BITS 15  /* longest code */
#define LITERALS 286  /* literals, the end of a block, and lengths */
#define DISTANCES 30  /* symbols that mean a distance */
#define FIXED_ALL 288 /* symbols of the fixed code of literals, two of which mean nothing */
#define CODE_LENGTHS 19
#define END_OF_BLOCK 256
#define NO_SYMBOL 0xFFFFu

/** Bits of the stream, lowest of each byte first. Past the end all are 0, and `ended` is set. */
typedef struct bit_reader {
    const uint8_t *data;
    size_t size, at;
    uint32_t byte; /* what is left of the latest one */
    int left;      /* bits of it */
    bool ended;
} bit_reader;

typedef struct decoder {
    bit_reader bits;
    uint8_t *out;
    size_t count, done; /* bytes that there is room for, and that were written */
} decoder;

/** A canonical code (RFC 1951, 3.2.2): codes of one length are consecutive, in order of their symbols. */
typedef struct huffman_table {
    uint16_t counts[CODE_BITS + 1];
    uint16_t first_codes[CODE_BITS + 1];
    uint16_t first_places[CODE_BITS + 1]; /* in `symbols` */
    uint16_t symbols[FIXED_ALL];
} huffman_table;

/* ---- Bits ------------------------------------------------------------------------------------------------------- */

static uint32_t take_bit(bit_reader *bits) {
    if (bits->left == 0) {
        bits->ended = bits->ended || bits->at == bits->size;
        bits->byte = bits->ended ? 0 : bits->data[bits->at++];
        bits->left = 8;
    }
    const uint32_t bit = bits->byte & 1u;
    bits->byte >>= 1;
    bits->left--;
    return bit;
}

static uint32_t take_bits(bit_reader *bits, int count) {
    uint32_t value = 0;
    for (int i = 0; i < count; i++) {
        value |= take_bit(bits) << i;
    }
    return value;
}

static bool ends_early(host_problem *problem) {
    return problem_set(problem, 0, "is broken: its data end early");
}

static bool is_broken(host_problem *problem, const char *what) {
    return problem_set(problem, 0, "is broken: %s", what);
}

/* ---- Huffman codes ---------------------------------------------------------------------------------------------- */

/**
 * Makes the table of a code from its lengths.
 * @return false for more codes than there are, and for fewer but where that is a single one of one bit, or none
 */
static bool make_table(huffman_table *table, const uint8_t *lengths, int symbols) {
    uint32_t code = 0;
    uint32_t place = 0;
    memset(table, 0, sizeof *table);
    for (int i = 0; i < symbols; i++) {
        table->counts[lengths[i]]++;
    }
    table->counts[0] = 0;
    for (int length = 1; length <= CODE_BITS; length++) {
        code <<= 1;
        table->first_codes[length] = (uint16_t)code;
        table->first_places[length] = (uint16_t)place;
        code += table->counts[length];
        place += table->counts[length];
        if (code > 1u << length) {
            return false;
        }
    }
    uint16_t next[CODE_BITS + 1];
    memcpy(next, table->first_places, sizeof next);
    for (int i = 0; i < symbols; i++) {
        if (lengths[i] > 0) {
            table->symbols[next[lengths[i]]++] = (uint16_t)i;
        }
    }
    return code == 1u << CODE_BITS || place == 0 || (place == 1 && table->counts[1] == 1);
}

/** The next symbol, or NO_SYMBOL where the bits are no code. */
static uint32_t take_symbol(bit_reader *bits, const huffman_table *table) {
    uint32_t code = 0;
    for (int length = 1; length <= CODE_BITS; length++) {
        code = code << 1 | take_bit(bits);
        const uint32_t rank = code - table->first_codes[length]; /* far above all counts for a code below the first */
        if (rank < table->counts[length]) {
            return table->symbols[table->first_places[length] + rank];
        }
    }
    return NO_SYMBOL;
}

/* ---- Blocks ----------------------------------------------------------------------------------------------------- */

static bool put_byte(decoder *to, uint8_t value, host_problem *problem) {
    if (to->done == to->count) {
        return is_broken(problem, "it has more data than its size takes");
    }
    to->out[to->done++] = value;
    return true;
}

/** Symbols of lengths and distances come in groups of 2^`bits` that share a number of extra bits, which grows by one.
 */
static uint32_t join_extra(bit_reader *reader, uint32_t symbol, int bits) {
    if (symbol < 2u << bits) {
        return symbol;
    }
    const int extra = (int)(symbol >> bits) - 1;
    const uint32_t group = (1u << bits) | (symbol & ((1u << bits) - 1));
    return (group << extra) + take_bits(reader, extra);
}

static bool copy_match(decoder *to, uint32_t symbol, const huffman_table *distances, host_problem *problem) {
    const uint32_t length = symbol == LITERALS - 1 ? 258 : 3 + join_extra(&to->bits, symbol - END_OF_BLOCK - 1, 2);
    const uint32_t far = take_symbol(&to->bits, distances);
    if (far >= DISTANCES) {
        return is_broken(problem, "a code means nothing");
    }
    const uint32_t distance = 1 + join_extra(&to->bits, far, 1);
    if (distance > to->done) {
        return is_broken(problem, "it repeats what is before its beginning");
    }
    for (uint32_t i = 0; i < length; i++) {
        if (!put_byte(to, to->out[to->done - distance], problem)) {
            return false;
        }
    }
    return true;
}

/** Unpacks one symbol. @param[out] last whether it ends the block */
static bool take_one(decoder *to, const huffman_table *literals, const huffman_table *distances, bool *last,
                     host_problem *problem) {
    const uint32_t symbol = take_symbol(&to->bits, literals);
    *last = symbol == END_OF_BLOCK;
    if (symbol < END_OF_BLOCK) {
        return put_byte(to, (uint8_t)symbol, problem);
    }
    if (symbol >= LITERALS) {
        return is_broken(problem, "a code means nothing");
    }
    return *last || copy_match(to, symbol, distances, problem);
}

/** Unpacks the symbols of a block. */
static bool take_symbols(decoder *to, const huffman_table *literals, const huffman_table *distances,
                         host_problem *problem) {
    bool ok = true;
    for (bool last = false; ok && !last && !to->bits.ended;) {
        ok = take_one(to, literals, distances, &last, problem);
    }
    return to->bits.ended ? ends_early(problem) : ok;
}

static bool take_stored(decoder *to, host_problem *problem) {
    bit_reader *bits = &to->bits;
    bits->left = 0;
    const uint32_t length = take_bits(bits, 16);
    const uint32_t inverse = take_bits(bits, 16);
    if (bits->ended || length > bits->size - bits->at) {
        return ends_early(problem);
    }
    if (inverse != (length ^ 0xFFFFu)) {
        return is_broken(problem, "a block's length is no length");
    }
    for (uint32_t i = 0; i < length; i++) {
        if (!put_byte(to, bits->data[bits->at + i], problem)) {
            return false;
        }
    }
    bits->at += length;
    return true;
}

static bool take_fixed(decoder *to, host_problem *problem) {
    uint8_t lengths[FIXED_ALL];
    huffman_table literals;
    huffman_table distances;
    for (int i = 0; i < FIXED_ALL; i++) {
        lengths[i] = (uint8_t)(i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8);
    }
    make_table(&literals, lengths, FIXED_ALL);
    memset(lengths, 5, 32);
    make_table(&distances, lengths, 32);
    return take_symbols(to, &literals, &distances, problem);
}

/** Unpacks the lengths of both codes, of which runs are shortened (RFC 1951, 3.2.7). @return false when they are none
 */
static bool take_lengths(bit_reader *bits, const huffman_table *table, uint8_t *lengths, uint32_t count) {
    uint32_t at = 0;
    while (at < count) {
        const uint32_t symbol = take_symbol(bits, table);
        uint32_t run = 1;
        uint8_t length = symbol < 16 ? (uint8_t)symbol : 0;
        if (symbol == NO_SYMBOL || (symbol == 16 && at == 0)) {
            return false;
        }
        if (symbol == 16) {
            length = lengths[at - 1];
            run = 3 + take_bits(bits, 2);
        } else if (symbol > 16) {
            run = symbol == 17 ? 3 + take_bits(bits, 3) : 11 + take_bits(bits, 7);
        }
        if (run > count - at) {
            return false;
        }
        memset(lengths + at, length, run);
        at += run;
    }
    return true;
}

static bool take_own(decoder *to, host_problem *problem) {
    static const uint8_t order[CODE_LENGTHS] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    uint8_t lengths[LITERALS + DISTANCES] = {0};
    huffman_table literals;
    huffman_table distances;
    const uint32_t literal_count = 257 + take_bits(&to->bits, 5);
    const uint32_t distance_count = 1 + take_bits(&to->bits, 5);
    const uint32_t length_count = 4 + take_bits(&to->bits, 4);
    for (uint32_t i = 0; i < length_count; i++) {
        lengths[order[i]] = (uint8_t)take_bits(&to->bits, 3);
    }
    bool ok = literal_count <= LITERALS && distance_count <= DISTANCES && make_table(&literals, lengths, CODE_LENGTHS);
    memset(lengths, 0, CODE_LENGTHS);
    ok = ok && take_lengths(&to->bits, &literals, lengths, literal_count + distance_count);
    ok = ok && make_table(&literals, lengths, (int)literal_count) &&
         make_table(&distances, lengths + literal_count, (int)distance_count);
    if (!ok) {
        return to->bits.ended ? ends_early(problem) : is_broken(problem, "the lengths of its codes are none");
    }
    return take_symbols(to, &literals, &distances, problem);
}

static bool take_block(decoder *to, host_problem *problem) {
    switch (take_bits(&to->bits, 2)) {
    case 0:
        return take_stored(to, problem);
    case 1:
        return take_fixed(to, problem);
    case 2:
        return take_own(to, problem);
    default:
        return is_broken(problem, "a block is of no kind");
    }
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

bool zlib_decode(uint8_t *out, size_t count, const uint8_t *data, size_t size, host_problem *problem) {
    decoder to = {{data, size, 2, 0, 0, false}, out, count, 0};
    if (size < 2) {
        return ends_early(problem);
    }
    const uint32_t head = (uint32_t)data[0] << 8 | data[1];
    if ((data[0] & 15) != 8 || data[0] >> 4 > 7 || head % 31 != 0 || (data[1] & 32) != 0) {
        return is_broken(problem, "its data are no zlib stream");
    }
    bool last = false;
    while (!last) {
        last = take_bit(&to.bits) != 0;
        if (!take_block(&to, problem)) {
            return false;
        }
    }
    if (to.done < count) {
        return is_broken(problem, "it has fewer data than its size takes");
    }
    to.bits.left = 0;
    uint32_t check = 0;
    for (int i = 0; i < 4; i++) {
        check = check << 8 | take_bits(&to.bits, 8);
    }
    if (to.bits.ended) {
        return ends_early(problem);
    }
    return check == zlib_checksum(out, count) || is_broken(problem, "the checksum of its data is wrong");
}
