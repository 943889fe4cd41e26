/* SPDX-License-Identifier: MIT */
/**
 * @file fuzz_png.c
 * The reader of PNG on any bytes (libFuzzer): as a file; as one whose chunks have the checksums that they should; and
 * as rows, which are packed here and must be read as they are. It either reports one problem or gives a picture.
 */
#include "png.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/** Ends the run with a report when a promise is broken. */
static void require(bool kept) {
    if (!kept) {
        abort();
    }
}

static void put_u32(uint8_t *to, uint32_t value) {
    for (int i = 0; i < 4; i++) {
        to[i] = (uint8_t)(value >> (24 - 8 * i) & 0xFF);
    }
}

static uint32_t get_u32(const uint8_t *from) {
    return (uint32_t)from[0] << 24 | (uint32_t)from[1] << 16 | (uint32_t)from[2] << 8 | from[3];
}

/** @return whether it is a file */
static bool read_file(const uint8_t *data, size_t size) {
    png_picture picture;
    host_problem problem = {0, ""};
    if (!png_decode(&picture, data, size, &problem)) {
        require(problem.text[0] != '\0' && problem.line == 0);
        for (const char *c = problem.text; *c != '\0'; c++) {
            require(*c >= ' ' && *c <= '~');
        }
        return false;
    }
    const size_t count = (size_t)picture.width * picture.height;
    bool opaque = true;
    require(picture.width >= 1 && picture.width <= PNG_SIDE_MAX && picture.height >= 1 &&
            picture.height <= PNG_SIDE_MAX);
    for (size_t i = 0; i < count; i++) {
        opaque = opaque && picture.pixels[4 * i + 3] == 255;
    }
    require(opaque == picture.opaque);
    free(picture.pixels);
    return true;
}

/** Gives all chunks their checksums, as far as chunks can be told. */
static void mend(uint8_t *file, size_t size) {
    for (size_t at = 8; at < size && size - at >= 12;) {
        const uint32_t length = get_u32(file + at);
        if (length > size - at - 12) {
            break;
        }
        put_u32(file + at + 8 + length, png_checksum(file + at + 4, (size_t)length + 4));
        at += (size_t)length + 12;
    }
}

static void add_chunk(host_bytes *file, const char *type, const uint8_t *data, size_t size) {
    const size_t start = file->count;
    uint8_t word[4];
    put_u32(word, (uint32_t)size);
    for (size_t i = 0; i < 8 + size; i++) {
        bytes_add(file, i < 4 ? word[i] : i < 8 ? (uint8_t)type[i - 4] : data[i - 8]);
    }
    put_u32(word, png_checksum(file->data + start + 4, size + 4));
    for (size_t i = 0; i < 4; i++) {
        bytes_add(file, word[i]);
    }
}

/** Packs bytes, and reads them as a picture of their first one's kind, whose rows are so many bytes as the second says.
 */
static void read_rows(const uint8_t *data, size_t size) {
    static const uint8_t kinds[8][2] = {{8, 0}, {8, 2}, {8, 4}, {8, 6}, {1, 0}, {2, 0}, {4, 0}, {8, 2}};
    static const uint8_t channels[7] = {1, 0, 3, 0, 2, 0, 4};
    static const char signature[] = "\x89PNG\r\n\x1a\n";
    const uint8_t *kind = kinds[data[0] % 8];
    const uint32_t width = data[1] % 16 + 1;
    const size_t row = (width * channels[kind[1]] * kind[0] + 7) / 8 + 1;
    const size_t height = (size - 2) / row;
    uint8_t head[13] = {0};
    host_bytes file = {NULL, 0, 0};
    host_bytes packed = {NULL, 0, 0};
    bool known = height > 0 && height <= PNG_SIDE_MAX;
    for (size_t y = 0; y < height; y++) {
        known = known && data[2 + y * row] <= 4;
    }
    put_u32(head, width);
    put_u32(head + 4, (uint32_t)height);
    head[8] = kind[0];
    head[9] = kind[1];
    for (size_t i = 0; i < 8; i++) {
        bytes_add(&file, (uint8_t)signature[i]);
    }
    zlib_encode(&packed, data + 2, row * height);
    add_chunk(&file, "IHDR", head, sizeof head);
    add_chunk(&file, "IDAT", packed.data, packed.count);
    add_chunk(&file, "IEND", head, 0);
    require(read_file(file.data, file.count) == known);
    free(packed.data);
    free(file.data);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    uint8_t *mended = malloc(size + 1);
    memcpy(mended, data, size);
    mend(mended, size);
    read_file(data, size);
    read_file(mended, size);
    free(mended);
    if (size >= 2 && data[0] != 0x89) {
        read_rows(data, size);
    }
    return 0;
}
