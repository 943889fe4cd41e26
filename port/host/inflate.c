/* SPDX-License-Identifier: MIT */
/**
 * @file inflate.c
 * Inflate (RFC 1951), a bit at a time: small and safe before fast.
 */
#include "png.h"

#include <string.h>

#define CODE_BITS 15  /* longest code */
#define LITERALS 286  /* literals, the end of a block, and lengths */
#define DISTANCES 30  /* symbols that mean a distance */
#define FIXED_ALL 288 /* symbols of the fixed code of literals, two of which mean nothing */
#define CODE_LENGTHS 19
#define END_OF_BLOCK 256
#define NO_SYMBOL 0xFFFFu

typedef struct decoder {
    const uint8_t *data;
    size_t size, at;
    uint32_t byte; /* what is left of the latest one: its lowest bit comes first */
    int left;      /* bits of it */
    uint8_t *out;
    size_t count, done; /* bytes that there is room for, and that were written */
    const char *wrong;  /* what was wrong first, or null */
} decoder;

/** A canonical code (RFC 1951, 3.2.2): codes of one length are consecutive, in order of their symbols. */
typedef struct huffman_table {
    uint16_t counts[CODE_BITS + 1];
    uint16_t first_codes[CODE_BITS + 1];
    uint16_t first_places[CODE_BITS + 1]; /* in `symbols` */
    uint16_t symbols[FIXED_ALL];
} huffman_table;

static void fail(decoder *from, const char *what) {
    from->wrong = from->wrong != NULL ? from->wrong : what;
}

/** Takes bits, the lowest first; past the end all are 0. */
static uint32_t take_bits(decoder *from, int count) {
    uint32_t value = 0;
    for (int i = 0; i < count; i++) {
        if (from->left == 0) {
            if (from->at == from->size) {
                fail(from, "its data end early");
            }
            from->byte = from->at < from->size ? from->data[from->at++] : 0;
            from->left = 8;
        }
        value |= (from->byte & 1u) << i;
        from->byte >>= 1;
        from->left--;
    }
    return value;
}

/* ---- Huffman codes ---------------------------------------------------------------------------------------------- */

/**
 * Makes the table of a code from its lengths.
 * @return false for more codes than there are, and for fewer but where that is a single one of one bit, or none
 */
static bool make_table(huffman_table *table, const uint8_t *lengths, uint32_t symbols) {
    uint32_t code = 0;
    uint32_t place = 0;
    memset(table, 0, sizeof *table);
    for (uint32_t i = 0; i < symbols; i++) {
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
    for (uint32_t i = 0; i < symbols; i++) {
        if (lengths[i] > 0) {
            table->symbols[next[lengths[i]]++] = (uint16_t)i;
        }
    }
    return code == 1u << CODE_BITS || place == 0 || (place == 1 && table->counts[1] == 1);
}

/** The next symbol, or NO_SYMBOL where the bits are no code. */
static uint32_t take_symbol(decoder *from, const huffman_table *table) {
    uint32_t code = 0;
    for (int length = 1; length <= CODE_BITS; length++) {
        code = code << 1 | take_bits(from, 1);
        const uint32_t rank = code - table->first_codes[length]; /* far above all counts for a code below the first */
        if (rank < table->counts[length]) {
            return table->symbols[table->first_places[length] + rank];
        }
    }
    return NO_SYMBOL;
}

/* ---- Blocks ----------------------------------------------------------------------------------------------------- */

static void put_byte(decoder *to, uint8_t value) {
    if (to->done == to->count) {
        fail(to, "it has more data than its size takes");
    } else {
        to->out[to->done++] = value;
    }
}

/** Symbols come in groups of 2^`bits` that share a number of extra bits, which grows by one. */
static uint32_t join_extra(decoder *from, uint32_t symbol, int bits) {
    if (symbol < 2u << bits) {
        return symbol;
    }
    const int extra = (int)(symbol >> bits) - 1;
    const uint32_t group = (1u << bits) | (symbol & ((1u << bits) - 1));
    return (group << extra) + take_bits(from, extra);
}

/** Unpacks a match, whose length's symbol was taken. */
static void take_match(decoder *to, uint32_t symbol, const huffman_table *distances) {
    const uint32_t length = symbol == LITERALS - 1 ? 258 : 3 + join_extra(to, symbol - END_OF_BLOCK - 1, 2);
    const uint32_t far = take_symbol(to, distances);
    const uint32_t distance = far < DISTANCES ? 1 + join_extra(to, far, 1) : 0;
    if (distance == 0) {
        fail(to, "a code means nothing");
    } else if (distance > to->done) {
        fail(to, "it repeats what is before its beginning");
    }
    for (uint32_t i = 0; i < length && to->wrong == NULL; i++) {
        put_byte(to, to->out[to->done - distance]);
    }
}

/** Unpacks the symbols of a block. */
static void take_symbols(decoder *to, const huffman_table *literals, const huffman_table *distances) {
    while (to->wrong == NULL) {
        const uint32_t symbol = take_symbol(to, literals);
        if (symbol == END_OF_BLOCK) {
            return;
        }
        if (symbol < END_OF_BLOCK) {
            put_byte(to, (uint8_t)symbol);
        } else if (symbol < LITERALS) {
            take_match(to, symbol, distances);
        } else {
            fail(to, "a code means nothing");
        }
    }
}

static void take_stored(decoder *to) {
    to->left = 0;
    const uint32_t length = take_bits(to, 16);
    const uint32_t inverse = take_bits(to, 16);
    if (length > to->size - to->at) {
        fail(to, "its data end early");
    } else if (inverse != (length ^ 0xFFFFu)) {
        fail(to, "a block's length is no length");
    }
    for (uint32_t i = 0; i < length && to->wrong == NULL; i++) {
        put_byte(to, to->data[to->at++]);
    }
}

static void take_fixed(decoder *to) {
    uint8_t lengths[FIXED_ALL];
    huffman_table literals;
    huffman_table distances;
    for (int i = 0; i < FIXED_ALL; i++) {
        lengths[i] = (uint8_t)(i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8);
    }
    make_table(&literals, lengths, FIXED_ALL);
    memset(lengths, 5, 32);
    make_table(&distances, lengths, 32);
    take_symbols(to, &literals, &distances);
}

/** Unpacks the lengths of both codes, of which runs are shortened (RFC 1951, 3.2.7). @return false when they are none
 */
static bool take_lengths(decoder *from, const huffman_table *table, uint8_t *lengths, uint32_t count) {
    uint32_t at = 0;
    while (at < count) {
        const uint32_t symbol = take_symbol(from, table);
        uint32_t run = 1;
        uint8_t length = symbol < 16 ? (uint8_t)symbol : 0;
        if (symbol == NO_SYMBOL || (symbol == 16 && at == 0)) {
            return false;
        }
        if (symbol == 16) {
            length = lengths[at - 1];
            run = 3 + take_bits(from, 2);
        } else if (symbol > 16) {
            run = symbol == 17 ? 3 + take_bits(from, 3) : 11 + take_bits(from, 7);
        }
        if (run > count - at) {
            return false;
        }
        memset(lengths + at, length, run);
        at += run;
    }
    return true;
}

static void take_own(decoder *to) {
    static const uint8_t order[CODE_LENGTHS] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    uint8_t lengths[LITERALS + DISTANCES] = {0};
    huffman_table literals;
    huffman_table distances;
    const uint32_t literal_count = 257 + take_bits(to, 5);
    const uint32_t distance_count = 1 + take_bits(to, 5);
    const uint32_t length_count = 4 + take_bits(to, 4);
    for (uint32_t i = 0; i < length_count; i++) {
        lengths[order[i]] = (uint8_t)take_bits(to, 3);
    }
    bool ok = literal_count <= LITERALS && distance_count <= DISTANCES && make_table(&literals, lengths, CODE_LENGTHS);
    memset(lengths, 0, CODE_LENGTHS);
    ok = ok && take_lengths(to, &literals, lengths, literal_count + distance_count) &&
         make_table(&literals, lengths, literal_count) &&
         make_table(&distances, lengths + literal_count, distance_count);
    if (ok) {
        take_symbols(to, &literals, &distances);
    } else {
        fail(to, "the lengths of its codes are none");
    }
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

bool zlib_decode(uint8_t *out, size_t count, const uint8_t *data, size_t size, host_problem *problem) {
    decoder to = {.data = data, .size = size, .out = out, .count = count};
    uint32_t head = take_bits(&to, 8) << 8;
    head |= take_bits(&to, 8);
    if ((head >> 8 & 15) != 8 || head >> 12 > 7 || head % 31 != 0 || (head & 32) != 0) {
        fail(&to, "its data are no zlib stream");
    }
    for (bool last = false; !last && to.wrong == NULL;) {
        last = take_bits(&to, 1) != 0;
        const uint32_t kind = take_bits(&to, 2);
        if (kind == 3) {
            fail(&to, "a block is of no kind");
        } else {
            (kind == 0 ? take_stored : kind == 1 ? take_fixed : take_own)(&to);
        }
    }
    if (to.done < count) {
        fail(&to, "it has fewer data than its size takes");
    }
    to.left = 0;
    uint32_t check = 0;
    for (int i = 0; i < 4; i++) {
        check = check << 8 | take_bits(&to, 8);
    }
    if (to.wrong == NULL && check != zlib_checksum(out, count)) {
        fail(&to, "the checksum of its data is wrong");
    }
    return to.wrong == NULL || problem_set(problem, 0, "is broken: %s", to.wrong);
}
