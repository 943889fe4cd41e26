/* SPDX-License-Identifier: MIT */
/**
 * @file fixture.h
 * What the unit tests draw with: a small screen, an arena, a scene to change, and guards around all that is written.
 * There is one of it, in static memory, sized for a core with 16 KB of RAM.
 */
#ifndef GLINT_UNIT_FIXTURE_H
#define GLINT_UNIT_FIXTURE_H

#include "glint.h"

#define FIXTURE_WIDTH 64
#define FIXTURE_HEIGHT 32

/** Bytes of the screen and of the arena. */
#define FIXTURE_SCREEN_BYTES (FIXTURE_WIDTH * FIXTURE_HEIGHT * 2)
#ifdef __OPTIMIZE_SIZE__
#define FIXTURE_ARENA_BYTES (sizeof(void *) > 4 ? 8024 : 7252) /* pointers take more on a host */
#else
#define FIXTURE_ARENA_BYTES (sizeof(void *) > 4 ? 8280 : 7540)
#endif

#define FIXTURE_OBJECTS_MAX 3

typedef struct fixture {
    glint_config config; /**< 64x32, RGB565, tiles of 16x16, the whole arena. */
    glint_renderer renderer;
    glint_mesh torus; /**< 72 vertices, 144 triangles. */
    glint_mesh floor; /**< A double-sided square of 80x80 in the xz plane. */
    glint_material materials[FIXTURE_OBJECTS_MAX];
    glint_light lights[GLINT_LIGHTS_MAX + 1];
    glint_object objects[FIXTURE_OBJECTS_MAX]; /**< Tori; the first is shown. */
    glint_scene scene;

    uint32_t begins, waits; /**< Calls since fixture_render. */
    uint32_t pixels_sent;
    uint32_t flaws;         /**< Calls out of order, rectangles out of place, pixels changed before wait. */
    const uint8_t *sending; /**< The tile between begin and wait. */
    size_t sending_stride, sending_bytes;
    uint32_t sending_rows, sending_checksum;
    int next_x, next_y; /**< Where the next tile is to begin. */
} fixture;

/** The fixture, set up anew. */
fixture *fixture_begin(void);

/** Draws the scene with glint_init and glint_render, and fails the case when anything beyond the buffers changed. */
glint_status fixture_render(fixture *f);

/** Draws the scene expecting an error: the status is it, nothing is sent; then a sound frame comes out right. */
void fixture_expect_error(fixture *f, glint_status expected);

/** Spoils the fixture `f` by statements, and checks that it is refused. */
#define REFUSED(error, ...)             \
    do {                                \
        fixture *f = fixture_begin();   \
        __VA_ARGS__;                    \
        fixture_expect_error(f, error); \
    } while (0)

/** The same where it is drawn. */
#define ACCEPTED(...)                             \
    do {                                          \
        fixture *f = fixture_begin();             \
        __VA_ARGS__;                              \
        CHECK_EQUAL(fixture_render(f), GLINT_OK); \
    } while (0)

/** Bytes that the scene needs, for the configuration as it stands. */
glint_need fixture_need(const fixture *f);

/** Checksum of the screen (FNV-1a; Fowler, Noll and Vo), the same whichever byte of a number the core stores first. */
uint32_t fixture_checksum(const fixture *f);

/** The same of a screen of 16-bit pixels whose high bytes come first, whichever the core stores first. */
uint32_t fixture_checksum_of_pairs(const fixture *f);

/** Continues a checksum; begin with FIXTURE_CHECKSUM_START. */
#define FIXTURE_CHECKSUM_START 2166136261u
uint32_t fixture_checksum_add(uint32_t checksum, const uint8_t *bytes, size_t count);

/** A row of the screen. */
const uint8_t *fixture_row(const fixture *f, int y);

/** The arena, for tests that divide it. */
uint8_t *fixture_arena(void);

#endif
