/* SPDX-License-Identifier: MIT */
/**
 * @file png_read.c
 * PNG files (ISO/IEC 15948) of other programs. What a file takes of memory is known from its size, which has a limit,
 * before its data are unpacked.
 */
#include "png.h"

#include "basics.h"

#include <stdlib.h>
#include <string.h>

/** Colour types. */
enum { TYPE_GREY = 0, TYPE_COLOUR = 2, TYPE_PALETTE = 3, TYPE_GREY_ALPHA = 4, TYPE_COLOUR_ALPHA = 6 };

/** A chunk: its type and data. */
typedef struct png_chunk {
    const char *type; /* 4 letters, not terminated */
    const uint8_t *data;
    uint32_t size;
} png_chunk;

/** A file that is being read. */
typedef struct png_file {
    const uint8_t *data; /* of the file */
    size_t count, at;
    uint32_t width, height, depth, type;
    uint8_t palette[256][4];
    uint32_t palette_count;
    host_bytes packed; /* the data of all IDAT chunks */
    bool has_head, has_data, data_ended;
} png_file;

static uint32_t get_u32(const uint8_t *from) {
    return (uint32_t)from[0] << 24 | (uint32_t)from[1] << 16 | (uint32_t)from[2] << 8 | from[3];
}

/* ---- Chunks ----------------------------------------------------------------------------------------------------- */

static bool is_type(const png_chunk *chunk, const char *type) {
    return memcmp(chunk->type, type, 4) == 0;
}

/** Says what is wrong with a chunk, by its name. */
static bool refuse_chunk(const png_chunk *chunk, const char *what, host_problem *problem) {
    char name[PROBLEM_QUOTE_SIZE];
    return problem_set(problem, 0, "is broken: its chunk %s %s", problem_quote(name, chunk->type, 4), what);
}

static bool take_chunk(png_file *file, png_chunk *chunk, host_problem *problem) {
    const size_t left = file->count - file->at;
    const uint8_t *start = file->data + file->at;
    if (left < 12 || get_u32(start) > left - 12) {
        problem_set(problem, 0, "is broken: it ends early");
        return false;
    }
    chunk->size = get_u32(start);
    chunk->type = (const char *)(start + 4);
    chunk->data = start + 8;
    file->at += (size_t)chunk->size + 12;
    return png_checksum(start + 4, (size_t)chunk->size + 4) == get_u32(chunk->data + chunk->size) ||
           refuse_chunk(chunk, "has a wrong checksum", problem);
}

/** Channels of a colour type, as they are stored; 0 for no such type. */
static uint32_t stored_channels(uint32_t type) {
    static const uint8_t channels[TYPE_COLOUR_ALPHA + 1] = {1, 0, 3, 1, 2, 0, 4};
    return type <= TYPE_COLOUR_ALPHA ? channels[type] : 0;
}

/** Whether a channel may have so many bits. */
static bool is_depth(uint32_t depth, uint32_t type) {
    const bool few = depth == 1 || depth == 2 || depth == 4;
    return depth == 8 || (few && (type == TYPE_GREY || type == TYPE_PALETTE));
}

static bool take_head(png_file *file, const png_chunk *chunk, host_problem *problem) {
    const uint8_t *data = chunk->data;
    if (chunk->size != 13 || file->has_head) {
        return refuse_chunk(chunk, file->has_head ? "comes twice" : "has a wrong length", problem);
    }
    file->has_head = true;
    file->width = get_u32(data);
    file->height = get_u32(data + 4);
    file->depth = data[8];
    file->type = data[9];
    if (file->width == 0 || file->height == 0 || file->width > PNG_SIDE_MAX || file->height > PNG_SIDE_MAX) {
        return problem_set(problem, 0, "is %lux%lu pixels: 1x1 to %ux%u are read", (unsigned long)file->width,
                           (unsigned long)file->height, PNG_SIDE_MAX, PNG_SIDE_MAX);
    }
    if (file->depth == 16 && stored_channels(file->type) > 0 && file->type != TYPE_PALETTE) {
        return problem_set(problem, 0, "has 16 bits a channel: up to 8 are read");
    }
    if (stored_channels(file->type) == 0 || !is_depth(file->depth, file->type)) {
        return problem_set(problem, 0, "is broken: there is no colour type %lu of %lu bits", (unsigned long)file->type,
                           (unsigned long)file->depth);
    }
    if (data[12] == 1) {
        return problem_set(problem, 0, "is interlaced (Adam7), which is not read");
    }
    return (data[10] == 0 && data[11] == 0 && data[12] == 0) || refuse_chunk(chunk, "names no known method", problem);
}

static bool take_palette(png_file *file, const png_chunk *chunk, host_problem *problem) {
    const uint32_t count = chunk->size / 3;
    if (file->type != TYPE_PALETTE) {
        return true; /* a suggestion */
    }
    if (file->palette_count > 0 || file->has_data) {
        return refuse_chunk(chunk, "is out of order", problem);
    }
    if (chunk->size % 3 != 0 || count == 0 || count > 1u << file->depth) {
        return refuse_chunk(chunk, "has a wrong length", problem);
    }
    for (uint32_t i = 0; i < count; i++) {
        memcpy(file->palette[i], chunk->data + 3 * i, 3);
        file->palette[i][3] = 255;
    }
    file->palette_count = count;
    return true;
}

static bool take_transparency(png_file *file, const png_chunk *chunk, host_problem *problem) {
    if (file->type != TYPE_PALETTE) {
        return problem_set(problem, 0, "has a transparent colour (tRNS), which is read of palettes only");
    }
    if (file->has_data || chunk->size > file->palette_count) {
        return refuse_chunk(chunk, file->has_data ? "is out of order" : "has a wrong length", problem);
    }
    for (uint32_t i = 0; i < chunk->size; i++) {
        file->palette[i][3] = chunk->data[i];
    }
    return true;
}

static bool take_data(png_file *file, const png_chunk *chunk, host_problem *problem) {
    if (file->data_ended || (file->type == TYPE_PALETTE && file->palette_count == 0)) {
        return refuse_chunk(chunk, "is out of order", problem);
    }
    file->has_data = true;
    for (uint32_t i = 0; i < chunk->size; i++) {
        bytes_add(&file->packed, chunk->data[i]);
    }
    return true;
}

/** Takes what a chunk says; one that need not be known is passed over (its name begins with a small letter). */
static bool follow_chunk(png_file *file, const png_chunk *chunk, host_problem *problem) {
    if (is_type(chunk, "IHDR") || !file->has_head) {
        return is_type(chunk, "IHDR") ? take_head(file, chunk, problem)
                                      : refuse_chunk(chunk, "comes before IHDR", problem);
    }
    if (is_type(chunk, "IDAT")) {
        return take_data(file, chunk, problem);
    }
    file->data_ended = file->has_data;
    if (is_type(chunk, "PLTE")) {
        return take_palette(file, chunk, problem);
    }
    if (is_type(chunk, "tRNS")) {
        return take_transparency(file, chunk, problem);
    }
    return (chunk->type[0] & 0x20) != 0 || is_type(chunk, "IEND") || refuse_chunk(chunk, "is not known", problem);
}

/** Takes all chunks up to IEND. */
static bool take_chunks(png_file *file, host_problem *problem) {
    png_chunk chunk;
    do {
        if (!take_chunk(file, &chunk, problem) || !follow_chunk(file, &chunk, problem)) {
            return false;
        }
    } while (!is_type(&chunk, "IEND"));
    return file->has_data || problem_set(problem, 0, "is broken: it has no picture (IDAT)");
}

/* ---- Rows ------------------------------------------------------------------------------------------------------- */

/** Of three neighbours the one nearest to left + above - corner (Paeth, 1991), the first of equals. */
static int paeth(int left, int above, int corner) {
    const int to_left = abs(above - corner);
    const int to_above = abs(left - corner);
    const int to_corner = abs(left + above - 2 * corner);
    if (to_left <= to_above && to_left <= to_corner) {
        return left;
    }
    return to_above <= to_corner ? above : corner;
}

/** Undoes a row's filter. @param above the row before, or null. @return false for a filter that there is not */
static bool unfilter(int filter, uint8_t *row, const uint8_t *above, size_t size, size_t step) {
    for (size_t i = 0; i < size && filter <= 4; i++) {
        const int left = i >= step ? row[i - step] : 0;
        const int up = above != NULL ? above[i] : 0;
        const int corner = above != NULL && i >= step ? above[i - step] : 0;
        const int guesses[] = {0, left, up, (left + up) / 2, paeth(left, up, corner)};
        row[i] = (uint8_t)((row[i] + guesses[filter]) & 0xFF);
    }
    return filter <= 4;
}

/** Sample `index` of a row, as it is stored. */
static uint8_t sample_at(const png_file *file, const uint8_t *row, uint32_t index) {
    const uint32_t bit = index * file->depth;
    const uint32_t mask = (1u << file->depth) - 1;
    return (uint8_t)(row[bit / 8] >> (8 - file->depth - bit % 8) & mask);
}

/** A pixel as red, green, blue and alpha. @return false where the palette has no such colour */
static bool expand_pixel(const png_file *file, const uint8_t *row, uint32_t x, uint8_t pixel[4]) {
    const uint32_t channels = stored_channels(file->type);
    const uint8_t first = sample_at(file, row, x * channels);
    if (file->type == TYPE_PALETTE) {
        memcpy(pixel, file->palette[first], 4);
        return first < file->palette_count;
    }
    const bool has_colour = channels > 2;
    for (uint32_t c = 0; c < 3; c++) {
        const uint32_t level = has_colour ? sample_at(file, row, x * channels + c) : first;
        pixel[c] = (uint8_t)(level * 255 / ((1u << file->depth) - 1));
    }
    pixel[3] = channels % 2 == 0 ? sample_at(file, row, x * channels + channels - 1) : 255;
    return true;
}

/** Expands rows, each behind its filter, into the picture. */
static bool expand(const png_file *file, uint8_t *rows, size_t row_size, png_picture *picture, host_problem *problem) {
    const uint32_t bits = stored_channels(file->type) * file->depth;
    const uint8_t *above = NULL;
    for (uint32_t y = 0; y < file->height; y++) {
        uint8_t *row = rows + y * (row_size + 1) + 1;
        if (!unfilter(row[-1], row, above, row_size, bits < 8 ? 1 : bits / 8)) {
            return problem_set(problem, 0, "is broken: row %lu has filter %d, which there is not", (unsigned long)y,
                               row[-1]);
        }
        for (uint32_t x = 0; x < file->width; x++) {
            uint8_t *pixel = picture->pixels + 4 * ((size_t)y * file->width + x);
            if (!expand_pixel(file, row, x, pixel)) {
                return problem_set(problem, 0, "is broken: pixel %lu,%lu has no colour in the palette",
                                   (unsigned long)x, (unsigned long)y);
            }
            picture->opaque = picture->opaque && pixel[3] == 255;
        }
        above = row;
    }
    return true;
}

static bool unpack(const png_file *file, png_picture *picture, host_problem *problem) {
    const size_t bits = (size_t)file->width * stored_channels(file->type) * file->depth;
    const size_t row_size = (bits + 7) / 8;
    const size_t size = (row_size + 1) * file->height;
    uint8_t *rows = memory_new(size, 1);
    png_picture found = {file->width, file->height, memory_new((size_t)file->width * file->height, 4), true};
    const bool ok = zlib_decode(rows, size, file->packed.data, file->packed.count, problem) &&
                    expand(file, rows, row_size, &found, problem);
    free(rows);
    if (ok) {
        *picture = found;
    } else {
        free(found.pixels);
    }
    return ok;
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

bool png_decode(png_picture *picture, const uint8_t *data, size_t count, host_problem *problem) {
    static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    if (count < sizeof signature || memcmp(data, signature, sizeof signature) != 0) {
        return problem_set(problem, 0, "is no PNG file");
    }
    png_file *file = memory_new(1, sizeof *file);
    file->data = data;
    file->count = count;
    file->at = sizeof signature;
    const bool ok = take_chunks(file, problem) && unpack(file, picture, problem);
    free(file->packed.data);
    free(file);
    return ok;
}
