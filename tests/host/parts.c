/* SPDX-License-Identifier: MIT */
/**
 * @file parts.c
 * Parts of the host program that read what others wrote, one by one: so that sanitisers see them.
 */
#include "harness.h"
#include "png.h"
#include "values.h"

#include <stdlib.h>
#include <string.h>

#define WIDTH 7u
#define HEIGHT 5u

static uint32_t next_random(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}

/* ---- Data that are packed --------------------------------------------------------------------------------------- */

/** Bytes of few values, some of them repeated from before. */
static void fill(uint8_t *data, size_t count, uint32_t values, uint32_t *state) {
    for (size_t i = 0; i < count; i++) {
        const size_t back = next_random(state) % 300 + 1;
        data[i] = (uint8_t)(i >= back && back > 40 ? data[i - back] : next_random(state) % values);
    }
}

static void what_is_packed_is_unpacked(void) {
    static const size_t counts[] = {0, 1, 2, 300, 40000, 100000};
    uint32_t state = 1;
    for (unsigned i = 0; i < TEST_COUNT(counts); i++) {
        for (uint32_t values = 1; values <= 256; values *= 16) {
            const size_t count = counts[i];
            uint8_t *data = malloc(count + 1);
            uint8_t *unpacked = malloc(count + 1);
            host_bytes packed = {NULL, 0, 0};
            host_problem problem;
            fill(data, count, values, &state);
            zlib_encode(&packed, data, count);
            CHECK(zlib_decode(unpacked, count, packed.data, packed.count, &problem));
            CHECK(memcmp(data, unpacked, count) == 0);
            CHECK(!zlib_decode(unpacked, count + 1, packed.data, packed.count, &problem));
            CHECK(count == 0 || !zlib_decode(unpacked, count - 1, packed.data, packed.count, &problem));
            free(packed.data);
            free(unpacked);
            free(data);
        }
    }
}

/* ---- Pictures --------------------------------------------------------------------------------------------------- */

/** A file of the colours in `pixels`, which are set up here. */
static host_bytes make_file(uint8_t pixels[3 * WIDTH * HEIGHT]) {
    host_bytes file = {NULL, 0, 0};
    uint32_t state = 5;
    fill(pixels, (size_t)3 * WIDTH * HEIGHT, 256, &state);
    png_encode(&file, pixels, WIDTH, HEIGHT, 3);
    return file;
}

/** Decodes exactly these bytes: one that is read beyond them is seen. @return whether they are a file */
static int is_file(const uint8_t *data, size_t count) {
    png_picture picture;
    host_problem problem = {0, ""};
    uint8_t *exact = malloc(count + (count == 0));
    memcpy(exact, data, count);
    const bool ok = png_decode(&picture, exact, count, &problem);
    CHECK(ok || problem.text[0] != '\0');
    if (ok) {
        free(picture.pixels);
    }
    free(exact);
    return ok;
}

static void what_is_written_is_read(void) {
    uint8_t pixels[3 * WIDTH * HEIGHT];
    host_bytes file = make_file(pixels);
    png_picture picture;
    host_problem problem;
    if (CHECK(png_decode(&picture, file.data, file.count, &problem))) {
        const comparison found = compare_pictures(pixels, 3, &picture);
        CHECK(picture.opaque && picture.width == WIDTH && picture.height == HEIGHT);
        CHECK_EQUAL(found.different, 0);
        free(picture.pixels);
    }
    free(file.data);
}

static void no_part_of_a_file_is_one(void) {
    uint8_t pixels[3 * WIDTH * HEIGHT];
    host_bytes file = make_file(pixels);
    int read = 0;
    for (size_t count = 0; count < file.count; count++) {
        read += is_file(file.data, count);
    }
    CHECK_EQUAL(read, 0);
    free(file.data);
}

/** Every bit of the packed data, their chunk's checksum mended. */
static void no_changed_bit_goes_unseen(void) {
    enum { DATA = 8 + 25 + 8, AFTER = 4 + 12 }; /* signature, IHDR, head of IDAT; checksum, IEND */
    uint8_t pixels[3 * WIDTH * HEIGHT];
    host_bytes file = make_file(pixels);
    int read = 0;
    for (size_t bit = (size_t)8 * DATA; bit < 8 * (file.count - AFTER); bit++) {
        file.data[bit / 8] ^= (uint8_t)(1u << bit % 8);
        const uint32_t sum = png_checksum(file.data + DATA - 4, file.count - AFTER - DATA + 4);
        for (size_t i = 0; i < 4; i++) {
            file.data[file.count - AFTER + i] = (uint8_t)(sum >> (24 - 8 * i) & 0xFF);
        }
        read += is_file(file.data, file.count);
        file.data[bit / 8] ^= (uint8_t)(1u << bit % 8);
    }
    CHECK_AT_MOST(read, 7); /* the bits that fill the last byte before the sum of the data */
    free(file.data);
}

/* ---- Comparisons ------------------------------------------------------------------------------------------------ */

static void differences_are_counted(void) {
    static const uint8_t grey[4] = {10, 20, 30, 40};
    uint8_t other[16] = {10, 10, 10, 255, 20, 20, 20, 255, 30, 31, 30, 255, 255, 40, 37, 255};
    png_picture picture = {2, 2, other, true};
    comparison found = compare_pictures(grey, 1, &picture);
    CHECK_EQUAL(found.pixels, 4);
    CHECK_EQUAL(found.different, 2);
    CHECK_EQUAL(found.channels, 3);
    CHECK(found.largest[0] == 215 && found.largest[1] == 1 && found.largest[2] == 3);
    CHECK(found.first_x == 0 && found.first_y == 1);
    CHECK_EQUAL(found.squares * 12, 1 + 215 * 215 + 9);
    other[3] = 0;
    picture.opaque = false;
    found = compare_pictures(grey, 1, &picture);
    CHECK(found.channels == 4 && found.largest[3] == 255 && found.first_x == 0 && found.first_y == 0);
    CHECK_EQUAL(found.squares * 16, 1 + 215 * 215 + 9 + 255 * 255);
}

/* ---- Names ------------------------------------------------------------------------------------------------------ */

static void names_get_their_number(void) {
    static const struct {
        const char *text;
        uint32_t number;
        const char *made;
    } names[] = {{"a%d", 0, "a0"},
                 {"%03d.png", 7, "007.png"},
                 {"%02d", 4294967295u, "4294967295"},
                 {"%%%09d%%", 12, "%000000012%"},
                 {"no number%%", 5, "no number%"},
                 {"", 5, ""}};
    static const char *const refused[] = {"%", "%%%", "%d%d", "%0d", "%010d", "%3d", "%s", "%0", "%01", "%1$d", "%hhn"};
    numbered_name name;
    host_problem problem;
    for (unsigned i = 0; i < TEST_COUNT(names); i++) {
        if (CHECK(numbered_parse(&name, names[i].text, &problem))) {
            char *made = numbered_make(&name, names[i].number);
            CHECK(strcmp(made, names[i].made) == 0);
            free(made);
        }
    }
    for (unsigned i = 0; i < TEST_COUNT(refused); i++) {
        char *exact = malloc(strlen(refused[i]) + 1);
        strcpy(exact, refused[i]);
        CHECK(!numbered_parse(&name, exact, &problem));
        free(exact);
    }
}

int test_main(void (*write)(const char *text)) {
    static const test_case cases[] = {
        TEST_CASE(what_is_packed_is_unpacked), TEST_CASE(what_is_written_is_read), TEST_CASE(no_part_of_a_file_is_one),
        TEST_CASE(no_changed_bit_goes_unseen), TEST_CASE(differences_are_counted), TEST_CASE(names_get_their_number),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
