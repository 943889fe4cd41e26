/* SPDX-License-Identifier: MIT */
/**
 * @file deflate.c
 * Deflate (RFC 1951): the longest of some earlier matches, taken unless the next byte starts a longer one; blocks with
 * Huffman codes of their own.
 */
#include "deflate.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

#define MATCH_MIN 3
#define MATCH_MAX 258
#define WINDOW 32768u
#define HASH_BITS 15
#define CHAIN_MAX 256

#define LITERALS 286 /* literals, the end of a block, and lengths */
#define DISTANCES 30
#define CODE_LENGTHS 19
#define END_OF_BLOCK 256
#define BLOCK_TOKENS 16384u

typedef struct bit_writer {
    host_bytes *out;
    uint32_t pending; /* bits not yet written, the first one lowest */
    int count;        /* of them, below 8 between calls */
} bit_writer;

/** A literal when `distance` is 0, else a match. */
typedef struct token {
    uint16_t value; /* the byte, or the match's length */
    uint16_t distance;
} token;

typedef struct huffman_code {
    uint16_t codes[LITERALS]; /* first bit lowest */
    uint8_t lengths[LITERALS];
} huffman_code;

/** Where three bytes were seen before: positions plus one, 0 for none. */
typedef struct match_finder {
    const uint8_t *data;
    size_t count;
    size_t *latest; /* by hash */
    size_t *before; /* by position within the window */
} match_finder;

/* ---- Bits ------------------------------------------------------------------------------------------------------- */

static void put_bits(bit_writer *writer, uint32_t value, int count) {
    writer->pending |= value << writer->count;
    for (writer->count += count; writer->count >= 8; writer->count -= 8) {
        bytes_add(writer->out, (uint8_t)(writer->pending & 0xFF));
        writer->pending >>= 8;
    }
}

static void put_symbol(bit_writer *writer, const huffman_code *code, uint32_t symbol) {
    put_bits(writer, code->codes[symbol], code->lengths[symbol]);
}

/** Symbols of lengths and distances come in groups of 2^`bits` that share a number of extra bits, which doubles. */
static uint32_t split_extra(uint32_t rest, int bits, int *extra) {
    *extra = 0;
    while ((rest >> *extra) >= (2u << bits)) {
        (*extra)++;
    }
    return ((uint32_t)*extra << bits) + (rest >> *extra);
}

static uint32_t length_symbol(uint32_t length, int *extra) {
    if (length == MATCH_MAX) {
        *extra = 0;
        return 285;
    }
    return 257 + split_extra(length - MATCH_MIN, 2, extra);
}

static uint32_t distance_symbol(uint32_t distance, int *extra) {
    return split_extra(distance - 1, 1, extra);
}

/* ---- Huffman codes ---------------------------------------------------------------------------------------------- */

/** A node of the tree that is being built: leaves first, in order of their symbols. */
typedef struct huffman_node {
    uint32_t weight;
    uint16_t parent; /* 0 for none yet: no leaf is a parent */
} huffman_node;

/** The lightest node without a parent, the first of them; or -1. */
static int lightest(const huffman_node *nodes, int count) {
    int best = -1;
    for (int i = 0; i < count; i++) {
        if (nodes[i].parent == 0 && nodes[i].weight > 0 && (best < 0 || nodes[i].weight < nodes[best].weight)) {
            best = i;
        }
    }
    return best;
}

/** Code lengths by Huffman's algorithm (1952). @return the longest */
static int tree_lengths(const uint32_t *weights, int symbols, uint8_t *lengths) {
    huffman_node nodes[2 * LITERALS] = {{0, 0}};
    int count = symbols;
    int longest = 0;
    for (int i = 0; i < symbols; i++) {
        nodes[i].weight = weights[i];
    }
    for (;;) {
        const int first = lightest(nodes, count);
        nodes[first].parent = (uint16_t)count; /* taken out of the search for the second */
        const int second = lightest(nodes, count);
        if (second < 0) {
            nodes[first].parent = 0;
            break;
        }
        nodes[second].parent = (uint16_t)count;
        nodes[count++].weight = nodes[first].weight + nodes[second].weight;
    }
    for (int i = 0; i < symbols; i++) {
        int length = 0;
        for (int at = i; nodes[at].parent != 0; at = nodes[at].parent) {
            length++;
        }
        lengths[i] = (uint8_t)length;
        longest = length > longest ? length : longest;
    }
    return longest;
}

/** Numbers the codes of given lengths (RFC 1951, 3.2.2), first bit lowest. */
static void number_codes(huffman_code *code, int symbols) {
    uint32_t next = 0;
    for (int length = 1; length <= 15; length++) {
        next <<= 1;
        for (int i = 0; i < symbols; i++) {
            if (code->lengths[i] != length) {
                continue;
            }
            uint32_t reversed = 0;
            for (int bit = 0; bit < length; bit++) {
                reversed |= (next >> bit & 1u) << (length - 1 - bit);
            }
            code->codes[i] = (uint16_t)reversed;
            next++;
        }
    }
}

/** A code of at most `most` bits for the symbols that have a weight; two of them at least get one. */
static void make_code(huffman_code *code, uint32_t *weights, int symbols, int most) {
    int used = 0;
    memset(code, 0, sizeof *code);
    for (int i = 0; i < symbols; i++) {
        used += weights[i] > 0;
    }
    for (int i = 0; used < 2; i++) {
        used += weights[i] == 0;
        weights[i] += weights[i] == 0;
    }
    while (tree_lengths(weights, symbols, code->lengths) > most) {
        for (int i = 0; i < symbols; i++) { /* flatter weights make a flatter tree */
            weights[i] = weights[i] > 0 ? weights[i] / 2 + 1 : 0;
        }
    }
    number_codes(code, symbols);
}

/* ---- Blocks ----------------------------------------------------------------------------------------------------- */

static void weigh_tokens(const token *tokens, size_t count, uint32_t *literals, uint32_t *distances) {
    int extra;
    for (size_t i = 0; i < count; i++) {
        if (tokens[i].distance == 0) {
            literals[tokens[i].value]++;
        } else {
            literals[length_symbol(tokens[i].value, &extra)]++;
            distances[distance_symbol(tokens[i].distance, &extra)]++;
        }
    }
    literals[END_OF_BLOCK]++;
}

/** The code lengths of both codes, one by one: no runs, which would save some dozen bytes a block. */
static void put_code_lengths(bit_writer *writer, const huffman_code *literals, const huffman_code *distances) {
    static const uint8_t order[CODE_LENGTHS] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    uint32_t weights[CODE_LENGTHS] = {0};
    huffman_code code;
    for (int i = 0; i < LITERALS; i++) {
        weights[literals->lengths[i]]++;
    }
    for (int i = 0; i < DISTANCES; i++) {
        weights[distances->lengths[i]]++;
    }
    make_code(&code, weights, CODE_LENGTHS, 7);
    put_bits(writer, LITERALS - 257, 5);
    put_bits(writer, DISTANCES - 1, 5);
    put_bits(writer, CODE_LENGTHS - 4, 4);
    for (int i = 0; i < CODE_LENGTHS; i++) {
        put_bits(writer, code.lengths[order[i]], 3);
    }
    for (int i = 0; i < LITERALS; i++) {
        put_symbol(writer, &code, literals->lengths[i]);
    }
    for (int i = 0; i < DISTANCES; i++) {
        put_symbol(writer, &code, distances->lengths[i]);
    }
}

static void put_match(bit_writer *writer, const huffman_code *literals, const huffman_code *distances, token match) {
    int extra;
    put_symbol(writer, literals, length_symbol(match.value, &extra));
    put_bits(writer, (match.value - (uint32_t)MATCH_MIN) & ((1u << extra) - 1), extra);
    put_symbol(writer, distances, distance_symbol(match.distance, &extra));
    put_bits(writer, (match.distance - 1u) & ((1u << extra) - 1), extra);
}

static void put_block(bit_writer *writer, const token *tokens, size_t count, bool last) {
    uint32_t literal_weights[LITERALS] = {0};
    uint32_t distance_weights[DISTANCES] = {0};
    huffman_code literals;
    huffman_code distances;
    weigh_tokens(tokens, count, literal_weights, distance_weights);
    make_code(&literals, literal_weights, LITERALS, 15);
    make_code(&distances, distance_weights, DISTANCES, 15);
    put_bits(writer, last, 1);
    put_bits(writer, 2, 2); /* codes of its own */
    put_code_lengths(writer, &literals, &distances);
    for (size_t i = 0; i < count; i++) {
        if (tokens[i].distance == 0) {
            put_symbol(writer, &literals, tokens[i].value);
        } else {
            put_match(writer, &literals, &distances, tokens[i]);
        }
    }
    put_symbol(writer, &literals, END_OF_BLOCK);
}

/* ---- Matches ---------------------------------------------------------------------------------------------------- */

static uint32_t hash3(const uint8_t *at) {
    const uint32_t word = at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16;
    return (word * 2654435761u) >> (32 - HASH_BITS);
}

static size_t match_length(const uint8_t *earlier, const uint8_t *at, size_t left) {
    const size_t limit = left < MATCH_MAX ? left : MATCH_MAX;
    size_t length = 0;
    while (length < limit && earlier[length] == at[length]) {
        length++;
    }
    return length;
}

/** Notes the bytes at a place as seen. */
static void note(match_finder *finder, size_t at) {
    if (finder->count - at >= MATCH_MIN) {
        size_t *latest = &finder->latest[hash3(finder->data + at)];
        finder->before[at % WINDOW] = *latest;
        *latest = at + 1;
    }
}

/** The longest match of those tried, the nearest of them; a literal when there is none. */
static token find_match(const match_finder *finder, size_t at) {
    token best = {finder->data[at], 0};
    size_t longest = MATCH_MIN - 1;
    if (finder->count - at < MATCH_MIN) {
        return best;
    }
    size_t seen = finder->latest[hash3(finder->data + at)];
    for (int tries = 0; tries < CHAIN_MAX && seen > 0 && at + 1 - seen < WINDOW; tries++) {
        const size_t length = match_length(finder->data + seen - 1, finder->data + at, finder->count - at);
        if (length > longest) {
            longest = length;
            best.value = (uint16_t)length;
            best.distance = (uint16_t)(at + 1 - seen);
        }
        seen = finder->before[(seen - 1) % WINDOW];
    }
    return best;
}

/** The token at `*at`, and moves on; a match only when the next byte does not start a longer one. */
static token next_token(match_finder *finder, size_t *at) {
    token found = find_match(finder, *at);
    note(finder, *at);
    if (found.distance > 0 && found.value < MATCH_MAX && *at + 1 < finder->count) {
        const token next = find_match(finder, *at + 1);
        if (next.distance > 0 && next.value > found.value) {
            found.value = finder->data[*at];
            found.distance = 0;
        }
    }
    const size_t length = found.distance > 0 ? found.value : 1;
    for (size_t i = 1; i < length; i++) {
        note(finder, *at + i);
    }
    *at += length;
    return found;
}

/* ---- Streams ---------------------------------------------------------------------------------------------------- */

uint32_t zlib_checksum(const uint8_t *data, size_t count) {
    uint32_t a = 1;
    uint32_t b = 0;
    for (size_t i = 0; i < count; i++) {
        a = (a + data[i]) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

void zlib_encode(host_bytes *out, const uint8_t *data, size_t count) {
    match_finder finder = {data, count, memory_new((size_t)1 << HASH_BITS, sizeof *finder.latest),
                           memory_new(WINDOW, sizeof *finder.before)};
    token *tokens = memory_new(BLOCK_TOKENS, sizeof *tokens);
    bit_writer writer = {out, 0, 0};
    bytes_add(out, 0x78); /* 32 KB window */
    bytes_add(out, 0x01);
    size_t at = 0;
    do {
        size_t used = 0;
        while (used < BLOCK_TOKENS && at < count) {
            tokens[used++] = next_token(&finder, &at);
        }
        put_block(&writer, tokens, used, at == count);
    } while (at < count);
    put_bits(&writer, 0, 7); /* fill the last byte */
    const uint32_t check = zlib_checksum(data, count);
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes_add(out, (uint8_t)(check >> shift & 0xFF));
    }
    free(tokens);
    free(finder.before);
    free(finder.latest);
}
