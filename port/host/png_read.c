/* SPDX-License-Identifier: MIT */
/**
 * @file png_read.c
 * PNG files into pixels: all types of colour and depths, but no interlaced ones.
 */
#include "png.h"

#include "basics.h"

#include <stdlib.h>
#include <string.h>

/** Bytes of the signature, and of a chunk without its data. */
#define SIGNATURE_SIZE 8
#define CHUNK_SIZE 12

enum { GREY = 0, RGB = 2, PALETTE = 3, GREY_ALPHA = 4, RGBA = 6 };

typedef struct png_reader {
    uint32_t width, height;
    int depth, type;
    int channels;
    uint8_t palette[256][4];
    uint32_t palette_count;
    bool has_key;
    uint32_t key[3]; /* the colour that is transparent, in the file's levels */
    host_bytes data; /* of all IDAT chunks */
    host_problem *problem;
} png_reader;

static uint32_t read_u32(const uint8_t *bytes) {
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

static uint32_t read_u16(const uint8_t *bytes) {
    return (uint32_t)bytes[0] << 8 | bytes[1];
}

/* ---- Chunks ----------------------------------------------------------------------------------------------------- */

/** Reads the head. @return false with a problem */
static bool read_head(png_reader *reader, const uint8_t *data, size_t size) {
    static const uint32_t depths[7] = {0x10116, 0, 0x10100, 0x116, 0x10100, 0, 0x10100}; /* bit n for n bits */
    static const int channels[7] = {1, 0, 3, 1, 2, 0, 4};
    if (size != 13) {
        return problem_set(reader->problem, 0, "its head is damaged");
    }
    reader->width = read_u32(data);
    reader->height = read_u32(data + 4);
    reader->depth = data[8];
    reader->type = data[9];
    if (reader->type > RGBA || reader->depth > 16 || (depths[reader->type] >> reader->depth & 1) == 0 ||
        data[10] != 0 || data[11] != 0 || data[12] > 1 || reader->width == 0 || reader->height == 0) {
        return problem_set(reader->problem, 0, "its head is damaged");
    }
    if (reader->width > PICTURE_SIDE_MAX || reader->height > PICTURE_SIDE_MAX) {
        return problem_set(reader->problem, 0, "it has %lux%lu pixels: at most %ux%u are read",
                           (unsigned long)reader->width, (unsigned long)reader->height, PICTURE_SIDE_MAX,
                           PICTURE_SIDE_MAX);
    }
    reader->channels = channels[reader->type];
    return data[12] == 0 || problem_set(reader->problem, 0, "it is interlaced, which is not read: save it without");
}

static void read_palette(png_reader *reader, const uint8_t *data, size_t size) {
    for (uint32_t i = 0; i < 256 && 3 * i + 2 < size; i++) {
        memcpy(reader->palette[i], data + (size_t)3 * i, 3);
        reader->palette[i][3] = 255;
        reader->palette_count = i + 1;
    }
}

/** Reads the alpha of a palette's colours, or the colour that is transparent. */
static void read_transparency(png_reader *reader, const uint8_t *data, size_t size) {
    const size_t count = reader->type == PALETTE ? reader->palette_count : reader->type == RGB ? 3 : 1;
    for (size_t i = 0; reader->type == PALETTE && i < count && i < size; i++) {
        reader->palette[i][3] = data[i];
    }
    if ((reader->type == GREY || reader->type == RGB) && size >= 2 * count) {
        reader->has_key = true;
        for (size_t i = 0; i < 3; i++) {
            reader->key[i] = read_u16(data + 2 * (i < count ? i : 0));
        }
    }
}

static void add_data(png_reader *reader, const uint8_t *data, size_t size) {
    if (reader->data.data == NULL) {
        reader->data.data = memory_new(reader->data.capacity, 1);
    }
    memcpy(reader->data.data + reader->data.count, data, size); /* all chunks have room: the capacity is the file's */
    reader->data.count += size;
}

/** Reads the chunks up to the end of the picture. @return false with a problem */
static bool read_chunks(png_reader *reader, const uint8_t *data, size_t count) {
    size_t at = SIGNATURE_SIZE;
    reader->data.capacity = count;
    for (bool is_first = true; count - at >= CHUNK_SIZE; is_first = false) {
        const size_t size = read_u32(data + at);
        const char *kind = (const char *)data + at + 4;
        const uint8_t *body = data + at + 8;
        if (size > count - at - CHUNK_SIZE) {
            break;
        }
        if (is_first && (memcmp(kind, "IHDR", 4) != 0 || !read_head(reader, body, size))) {
            return memcmp(kind, "IHDR", 4) == 0 ? false : problem_set(reader->problem, 0, "its head is damaged");
        }
        if (memcmp(kind, "PLTE", 4) == 0) {
            read_palette(reader, body, size);
        } else if (memcmp(kind, "tRNS", 4) == 0) {
            read_transparency(reader, body, size);
        } else if (memcmp(kind, "IDAT", 4) == 0) {
            add_data(reader, body, size);
        } else if (memcmp(kind, "IEND", 4) == 0) {
            break;
        }
        at += size + CHUNK_SIZE;
    }
    if (reader->data.count == 0) {
        return problem_set(reader->problem, 0, "the file is cut off");
    }
    return reader->type != PALETTE || reader->palette_count > 0 || problem_set(reader->problem, 0, "it has no palette");
}

/* ---- Rows ------------------------------------------------------------------------------------------------------- */

static int predict(int left, int up, int corner) {
    const int guess = left + up - corner;
    const int to_left = abs(guess - left);
    const int to_up = abs(guess - up);
    const int to_corner = abs(guess - corner);
    return to_left <= to_up && to_left <= to_corner ? left : to_up <= to_corner ? up : corner;
}

/** Undoes the filter of a row (PNG, 9.2). @param above the row above, or null. @return false where it is none */
static bool unfilter(uint8_t *row, const uint8_t *above, size_t size, size_t step, int filter) {
    for (size_t i = 0; i < size && filter > 0; i++) {
        const int left = i >= step ? row[i - step] : 0;
        const int up = above != NULL ? above[i] : 0;
        const int corner = above != NULL && i >= step ? above[i - step] : 0;
        const int guess[5] = {0, left, up, (left + up) / 2, predict(left, up, corner)};
        if (filter > 4) {
            return false;
        }
        row[i] = (uint8_t)(row[i] + guess[filter]);
    }
    return true;
}

/** Returns a sample of a row, in the file's levels. */
static uint32_t sample_at(const uint8_t *row, size_t place, int depth) {
    if (depth == 16) {
        return read_u16(row + 2 * place);
    }
    const size_t bit = place * (size_t)depth;
    return row[bit / 8] >> (8 - (size_t)depth - bit % 8) & ((1u << depth) - 1);
}

static void convert_pixel(const png_reader *reader, const uint8_t *row, size_t x, uint8_t pixel[4]) {
    const uint32_t full = (1u << reader->depth) - 1;
    const bool is_grey = reader->type == GREY || reader->type == GREY_ALPHA;
    const size_t first = x * (size_t)reader->channels;
    bool is_key = reader->has_key;
    if (reader->type == PALETTE) {
        memcpy(pixel, reader->palette[sample_at(row, x, reader->depth)], 4);
        return;
    }
    for (size_t i = 0; i < 3; i++) {
        const uint32_t level = sample_at(row, first + (is_grey ? 0 : i), reader->depth);
        is_key = is_key && level == reader->key[i];
        pixel[i] = (uint8_t)((level * 255 + full / 2) / full);
    }
    pixel[3] = is_key ? 0 : 255;
    if (reader->type == GREY_ALPHA || reader->type == RGBA) {
        const uint32_t alpha = sample_at(row, first + (is_grey ? 1 : 3), reader->depth);
        pixel[3] = (uint8_t)((alpha * 255 + full / 2) / full);
    }
}

static bool read_pixels(const png_reader *reader, host_picture *picture) {
    const size_t bits = (size_t)reader->channels * (size_t)reader->depth;
    const size_t size = (reader->width * bits + 7) / 8;
    uint8_t *rows = memory_new(reader->height, size + 1);
    bool ok = zlib_decode(reader->data.data, reader->data.count, rows, (size + 1) * reader->height);
    picture->pixels = memory_new((size_t)reader->width * reader->height, sizeof *picture->pixels);
    picture->width = reader->width;
    picture->height = reader->height;
    for (size_t y = 0; ok && y < reader->height; y++) {
        uint8_t *row = rows + y * (size + 1) + 1;
        ok = unfilter(row, y > 0 ? row - size - 1 : NULL, size, (bits + 7) / 8, row[-1]);
        for (size_t x = 0; ok && x < reader->width; x++) {
            convert_pixel(reader, row, x, picture->pixels[y * reader->width + x]);
        }
    }
    free(rows);
    if (!ok) {
        free(picture->pixels);
    }
    return ok || problem_set(reader->problem, 0, "its pixels are damaged, or cut off");
}

/** Says what a file is that is no PNG file. @return false */
static bool refuse(const uint8_t *data, size_t count, host_problem *problem) {
    static const struct {
        const char *bytes;
        size_t size;
        const char *name;
    } others[] = {{"GIF8", 4, "GIF"}, {"BM", 2, "BMP"}, {"RIFF", 4, "WebP"}, {"DDS ", 4, "DDS"}, {"\xABKTX", 4, "KTX"}};
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        if (count >= others[i].size && memcmp(data, others[i].bytes, others[i].size) == 0) {
            return problem_set(problem, 0, "it is %s, which is not read: save it as PNG", others[i].name);
        }
    }
    return problem_set(problem, 0, "it is neither PNG nor JPEG");
}

bool png_decode(const uint8_t *data, size_t count, host_picture *picture, host_problem *problem) {
    static const uint8_t signature[SIGNATURE_SIZE] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    png_reader reader = {.problem = problem};
    if (count < SIGNATURE_SIZE || memcmp(data, signature, SIGNATURE_SIZE) != 0) {
        return refuse(data, count, problem);
    }
    const bool ok = read_chunks(&reader, data, count) && read_pixels(&reader, picture);
    free(reader.data.data);
    return ok;
}
