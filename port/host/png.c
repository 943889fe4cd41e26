/* SPDX-License-Identifier: MIT */
#include "png.h"

#include "basics.h"

#include <stdlib.h>
#include <string.h>

/* ---- PNG -------------------------------------------------------------------------------------------------------- */

static void put_u32(host_bytes *out, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes_add(out, (uint8_t)(value >> shift & 0xFF));
    }
}

static void put_u16(host_bytes *out, uint32_t value) {
    bytes_add(out, (uint8_t)(value >> 8 & 0xFF));
    bytes_add(out, (uint8_t)(value & 0xFF));
}

/** The checksum of a chunk's type and data: CRC-32. */
static uint32_t checksum(const uint8_t *data, size_t count) {
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
    put_u32(out, checksum(out->data + start + 4, out->count - start - 4));
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

/** Part of a picture. */
typedef struct png_rectangle {
    const uint8_t *pixels; /* of its first row */
    size_t stride;         /* from row to row */
    uint32_t x, y, width, height;
    uint32_t channels;
} png_rectangle;

/** Each row with the filter that leaves the smallest differences, the usual heuristic (PNG specification, 12.8). */
static int choose_filter(uint8_t *out, const png_rectangle *part, const uint8_t *row, const uint8_t *above) {
    int best = 0;
    uint32_t least = UINT32_MAX;
    for (int filter = 0; filter <= 2; filter++) {
        const uint32_t sum = filter_row(out, filter, row, above, (size_t)part->width * part->channels, part->channels);
        best = sum < least ? filter : best;
        least = sum < least ? sum : least;
    }
    return best;
}

/** Appends a part's rows, filtered or as they are. */
static void put_rows(host_bytes *out, const png_rectangle *part, bool filtered) {
    const size_t row_size = (size_t)part->width * part->channels;
    uint8_t *rows = memory_new(part->height, row_size + 1);
    for (size_t y = 0; y < part->height; y++) {
        const uint8_t *row = part->pixels + y * part->stride;
        const uint8_t *above = y > 0 ? row - part->stride : NULL;
        uint8_t *to = rows + y * (row_size + 1);
        const int filter = filtered ? choose_filter(to, part, row, above) : 0;
        filter_row(to, filter, row, above, row_size, part->channels);
    }
    zlib_encode(out, rows, (row_size + 1) * part->height);
    free(rows);
}

/** Differences are short where levels are many, and whole pixels repeat where they are few: whichever is shorter. */
static void put_pixels(host_bytes *out, const png_rectangle *part) {
    host_bytes filtered = {NULL, 0, 0};
    host_bytes plain = {NULL, 0, 0};
    put_rows(&filtered, part, true);
    put_rows(&plain, part, false);
    const host_bytes *shorter = plain.count < filtered.count ? &plain : &filtered;
    for (size_t i = 0; i < shorter->count; i++) {
        bytes_add(out, shorter->data[i]);
    }
    free(filtered.data);
    free(plain.data);
}

static png_rectangle whole(const uint8_t *pixels, uint32_t width, uint32_t height, uint32_t channels) {
    const png_rectangle part = {pixels, (size_t)width * channels, 0, 0, width, height, channels};
    return part;
}

/* ---- Files ------------------------------------------------------------------------------------------------------ */

static void put_head(host_bytes *out, const png_rectangle *picture) {
    static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    for (size_t i = 0; i < sizeof signature; i++) {
        bytes_add(out, signature[i]);
    }
    const size_t chunk = chunk_begin(out, "IHDR");
    put_u32(out, picture->width);
    put_u32(out, picture->height);
    bytes_add(out, 8);                              /* bits */
    bytes_add(out, picture->channels == 3 ? 2 : 0); /* colour type */
    for (int i = 0; i < 3; i++) {
        bytes_add(out, 0); /* the only methods there are */
    }
    chunk_end(out, chunk);
}

static void put_data(host_bytes *out, const png_rectangle *picture) {
    const size_t chunk = chunk_begin(out, "IDAT");
    put_pixels(out, picture);
    chunk_end(out, chunk);
}

void png_encode(host_bytes *out, const uint8_t *pixels, uint32_t width, uint32_t height, uint32_t channels) {
    const png_rectangle picture = whole(pixels, width, height, channels);
    put_head(out, &picture);
    put_data(out, &picture);
    chunk_end(out, chunk_begin(out, "IEND"));
}

/* ---- Animations ------------------------------------------------------------------------------------------------- */

/** The rectangle outside which two pictures are equal: one pixel when they are equal everywhere. */
static png_rectangle difference(const uint8_t *before, const png_rectangle *picture) {
    uint32_t left = picture->width;
    uint32_t top = picture->height;
    uint32_t right = 0;
    uint32_t bottom = 0;
    for (uint32_t y = 0; y < picture->height; y++) {
        for (uint32_t x = 0; x < picture->width; x++) {
            const size_t at = y * picture->stride + (size_t)x * picture->channels;
            if (memcmp(before + at, picture->pixels + at, picture->channels) != 0) {
                left = x < left ? x : left;
                right = x > right ? x : right;
                top = y < top ? y : top;
                bottom = y;
            }
        }
    }
    png_rectangle part = *picture;
    part.x = left < picture->width ? left : 0;
    part.y = top < picture->height ? top : 0;
    part.width = right + 1 - part.x;
    part.height = bottom + 1 - part.y;
    part.pixels = picture->pixels + part.y * picture->stride + (size_t)part.x * picture->channels;
    return part;
}

static void put_frame_control(host_bytes *out, uint32_t sequence, const png_rectangle *part, const png_movie *movie) {
    const size_t chunk = chunk_begin(out, "fcTL");
    put_u32(out, sequence);
    put_u32(out, part->width);
    put_u32(out, part->height);
    put_u32(out, part->x);
    put_u32(out, part->y);
    put_u16(out, movie->delay_numerator);
    put_u16(out, movie->delay_denominator);
    bytes_add(out, 0); /* left as it is when the next one comes */
    bytes_add(out, 0); /* replaces what was there */
    chunk_end(out, chunk);
}

static void put_animation_control(host_bytes *out, const png_movie *movie) {
    const size_t chunk = chunk_begin(out, "acTL");
    put_u32(out, movie->count);
    put_u32(out, 0); /* for ever */
    chunk_end(out, chunk);
}

void png_encode_movie(host_bytes *out, const png_movie *movie, uint32_t width, uint32_t height, uint32_t channels) {
    const png_rectangle first = whole(movie->frames[0], width, height, channels);
    uint32_t sequence = 0;
    put_head(out, &first);
    put_animation_control(out, movie);
    put_frame_control(out, sequence++, &first, movie);
    put_data(out, &first);
    for (uint32_t i = 1; i < movie->count; i++) {
        const png_rectangle picture = whole(movie->frames[i], width, height, channels);
        const png_rectangle part = difference(movie->frames[i - 1], &picture);
        put_frame_control(out, sequence++, &part, movie);
        const size_t chunk = chunk_begin(out, "fdAT");
        put_u32(out, sequence++);
        put_pixels(out, &part);
        chunk_end(out, chunk);
    }
    chunk_end(out, chunk_begin(out, "IEND"));
}
