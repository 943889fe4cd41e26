/* SPDX-License-Identifier: MIT */
#include "png.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

/* ---- Deflate (RFC 1951): one block with the fixed Huffman codes ------------------------------------------------ */

#define MATCH_MIN 3
#define MATCH_MAX 258
#define WINDOW 32768
#define HASH_BITS 15

typedef struct bit_writer {
    host_bytes *out;
    uint32_t pending; /* bits not yet written, the first one lowest */
    int count;        /* of them, below 8 between calls */
} bit_writer;

static void put_bits(bit_writer *writer, uint32_t value, int count) {
    writer->pending |= value << writer->count;
    for (writer->count += count; writer->count >= 8; writer->count -= 8) {
        bytes_add(writer->out, (uint8_t)(writer->pending & 0xFF));
        writer->pending >>= 8;
    }
}

/** Huffman codes go with their highest bit first, all else with the lowest. */
static void put_code(bit_writer *writer, uint32_t code, int count) {
    uint32_t reversed = 0;
    for (int i = 0; i < count; i++) {
        reversed |= ((code >> i) & 1u) << (count - 1 - i);
    }
    put_bits(writer, reversed, count);
}

/** A literal, the end of the block (256), or a length symbol (257 to 285). */
static void put_symbol(bit_writer *writer, uint32_t symbol) {
    if (symbol < 144) {
        put_code(writer, 0x30 + symbol, 8);
    } else if (symbol < 256) {
        put_code(writer, 0x190 + symbol - 144, 9);
    } else if (symbol < 280) {
        put_code(writer, symbol - 256, 7);
    } else {
        put_code(writer, 0xC0 + symbol - 280, 8);
    }
}

static void put_length(bit_writer *writer, uint32_t length) {
    if (length == MATCH_MAX) {
        put_symbol(writer, 285);
        return;
    }
    /* Symbols come in fours that share a number of extra bits; the first eight have none. */
    uint32_t rest = length - MATCH_MIN;
    int extra = 0;
    while ((rest >> extra) >= 8) {
        extra++;
    }
    put_symbol(writer, 257 + 4 * (uint32_t)extra + (rest >> extra));
    put_bits(writer, rest & ((1u << extra) - 1), extra);
}

static void put_distance(bit_writer *writer, uint32_t distance) {
    uint32_t rest = distance - 1;
    int extra = 0;
    while ((rest >> extra) >= 4) {
        extra++;
    }
    put_code(writer, 2 * (uint32_t)extra + (rest >> extra), 5);
    put_bits(writer, rest & ((1u << extra) - 1), extra);
}

static size_t match_length(const uint8_t *earlier, const uint8_t *at, size_t left) {
    const size_t limit = left < MATCH_MAX ? left : MATCH_MAX;
    size_t length = 0;
    while (length < limit && earlier[length] == at[length]) {
        length++;
    }
    return length;
}

static uint32_t hash3(const uint8_t *at) {
    const uint32_t word = at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16;
    return (word * 2654435761u) >> (32 - HASH_BITS);
}

/** Appends `data` as one deflate block; `latest` remembers where three bytes were last seen, plus one. */
static void deflate_block(bit_writer *writer, const uint8_t *data, size_t count, size_t *latest) {
    put_bits(writer, 1, 1); /* the last block */
    put_bits(writer, 1, 2); /* fixed codes */
    size_t at = 0;
    while (at < count) {
        size_t length = 0;
        size_t distance = 0;
        if (count - at >= MATCH_MIN) {
            size_t *seen = &latest[hash3(data + at)];
            if (*seen > 0 && at + 1 - *seen <= WINDOW) {
                distance = at + 1 - *seen;
                length = match_length(data + at - distance, data + at, count - at);
            }
            *seen = at + 1;
        }
        if (length >= MATCH_MIN) {
            put_length(writer, (uint32_t)length);
            put_distance(writer, (uint32_t)distance);
            at += length;
        } else {
            put_symbol(writer, data[at++]);
        }
    }
    put_symbol(writer, 256);
    put_bits(writer, 0, 7); /* fill the last byte */
}

static uint32_t adler32(const uint8_t *data, size_t count) {
    uint32_t a = 1;
    uint32_t b = 0;
    for (size_t i = 0; i < count; i++) {
        a = (a + data[i]) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

/* ---- PNG -------------------------------------------------------------------------------------------------------- */

static void put_u32(host_bytes *out, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes_add(out, (uint8_t)(value >> shift & 0xFF));
    }
}

static void zlib_stream(host_bytes *out, const uint8_t *data, size_t count) {
    size_t *latest = memory_new((size_t)1 << HASH_BITS, sizeof *latest);
    bit_writer writer = {out, 0, 0};
    bytes_add(out, 0x78); /* 32 KB window */
    bytes_add(out, 0x01);
    deflate_block(&writer, data, count, latest);
    put_u32(out, adler32(data, count));
    free(latest);
}

static uint32_t crc32(const uint8_t *data, size_t count) {
    uint32_t crc = 0xFFFFFFFFu;
    for (size_t i = 0; i < count; i++) {
        crc ^= data[i];
        for (int bit = 0; bit < 8; bit++) {
            crc = crc >> 1 ^ (0xEDB88320u & (0u - (crc & 1u)));
        }
    }
    return ~crc;
}

/** Starts a chunk whose length chunk_end fills in. @return where it starts. */
static size_t chunk_begin(host_bytes *out, const char *type) {
    const size_t start = out->count;
    put_u32(out, 0);
    for (int i = 0; i < 4; i++) {
        bytes_add(out, (uint8_t)type[i]);
    }
    return start;
}

static void chunk_end(host_bytes *out, size_t start) {
    const uint32_t length = (uint32_t)(out->count - start - 8);
    for (int i = 0; i < 4; i++) {
        out->data[start + (size_t)i] = (uint8_t)(length >> (24 - 8 * i) & 0xFF);
    }
    put_u32(out, crc32(out->data + start + 4, out->count - start - 4));
}

/** Filter 0 keeps a row, 1 subtracts the pixel to the left, 2 the one above. @return the sum of what is left. */
static uint32_t filter_row(uint8_t *out, int filter, const uint8_t *row, const uint8_t *above, size_t size,
                           size_t step) {
    uint32_t sum = 0;
    out[0] = (uint8_t)filter;
    for (size_t i = 0; i < size; i++) {
        const int left = filter == 1 && i >= step ? row[i - step] : 0;
        const int up = filter == 2 && above != NULL ? above[i] : 0;
        const uint8_t rest = (uint8_t)((row[i] - left - up) & 0xFF);
        out[i + 1] = rest;
        sum += rest < 128 ? rest : 256u - rest;
    }
    return sum;
}

/** Each row with the filter that leaves the smallest differences, the usual heuristic (PNG specification, 12.8). */
static uint8_t *filter_rows(const uint8_t *pixels, size_t row_size, size_t rows, size_t step) {
    uint8_t *filtered = memory_new(rows, row_size + 1);
    for (size_t y = 0; y < rows; y++) {
        const uint8_t *row = pixels + y * row_size;
        const uint8_t *above = y > 0 ? row - row_size : NULL;
        uint8_t *out = filtered + y * (row_size + 1);
        int best = 0;
        uint32_t least = UINT32_MAX;
        for (int filter = 0; filter <= 2; filter++) {
            const uint32_t sum = filter_row(out, filter, row, above, row_size, step);
            best = sum < least ? filter : best;
            least = sum < least ? sum : least;
        }
        filter_row(out, best, row, above, row_size, step);
    }
    return filtered;
}

void png_encode(host_bytes *out, const uint8_t *pixels, uint32_t width, uint32_t height, uint32_t channels) {
    static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    for (size_t i = 0; i < sizeof signature; i++) {
        bytes_add(out, signature[i]);
    }
    size_t chunk = chunk_begin(out, "IHDR");
    put_u32(out, width);
    put_u32(out, height);
    const uint8_t rest[5] = {8, channels == 3 ? 2 : 0, 0, 0,
                             0}; /* bits, colour type, then the only methods there are */
    for (size_t i = 0; i < sizeof rest; i++) {
        bytes_add(out, rest[i]);
    }
    chunk_end(out, chunk);
    const size_t row_size = (size_t)width * channels;
    uint8_t *filtered = filter_rows(pixels, row_size, height, channels);
    chunk = chunk_begin(out, "IDAT");
    zlib_stream(out, filtered, (row_size + 1) * height);
    chunk_end(out, chunk);
    free(filtered);
    chunk_end(out, chunk_begin(out, "IEND"));
}
