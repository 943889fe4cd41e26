/* SPDX-License-Identifier: MIT */
/*
 * Suite: lines through any view: screens of 1/256 to 32767 units, fields of view of 1 to 170 degrees, near planes from
 * the least to the largest number. A line across the screen has a pixel in each column, and any lines are the same
 * pixels whatever the tiles are.
 */
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "sample.h"

#include <stdlib.h>
#include <string.h>

#define LINES 12

static uint32_t state;

/* From least to most (Numerical Recipes' generator). */
static int32_t any(int32_t least, int32_t most) {
    state = state * 1664525u + 1013904223u;
    const uint32_t high = state >> 16;
    state = state * 1664525u + 1013904223u;
    const uint64_t count = (uint64_t)((int64_t)most - least) + 1, number = (uint64_t)high << 16 | state >> 16;
    return (int32_t)(least + (int64_t)(number * count >> 32));
}

/* From 1 to most, each number of bits as likely. */
static int32_t any_size(int32_t most) {
    const int32_t bits = any(0, 30);
    return any(1, most >> bits ? most >> bits : 1);
}

/* ---- Drawing ---- */

typedef struct overlay {
    const glint_segment *segments;
    uint32_t count, marked; /* pixels of lines */
} overlay;

static int draw_lines(void *context, const glint_tile *tile) {
    overlay *const o = context;
    if (glint_lines_draw(tile, o->segments, o->count) != GLINT_OK)
        return 1;
    for (int y = 0; y < tile->height; y++)
        for (int x = 0; x < tile->width; x++)
            o->marked += tile->depth[(size_t)y * tile->depth_stride + (size_t)x] != 0;
    return 0;
}

/* Draws lines and nothing else. @return pixels that they have */
static uint32_t draw(const glint_camera *camera, const glint_line *lines, uint32_t count, uint16_t tile,
                     picture *image) {
    static uint8_t arena[1 << 16];
    const picture_options options = {.tile_width = tile, .tile_height = tile};
    glint_segment segments[LINES];
    overlay over = {segments, count, 0};
    glint_config config = picture_config(image, &options);
    const glint_pose pose = glint_pose_identity();
    const glint_scene scene = {.camera = *camera};
    glint_renderer renderer;
    config.arena = arena;
    config.arena_size = sizeof arena;
    config.overlay = (glint_painter){draw_lines, &over};
    CHECK_EQUAL(glint_lines_place(segments, &config, camera, &pose, lines, count), GLINT_OK);
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    CHECK_EQUAL(glint_render(&renderer, &scene), GLINT_OK);
    return over.marked;
}

/* ---- Views ---- */

static glint_camera any_camera(void) {
    glint_camera camera = {.field_of_view = 45 * GLINT_ONE};
    const glint_vector axis = {any(-9, 9), any(-9, 9), any(1, 9)};
    camera.pose = glint_pose_rotate(axis, any(0, 360 * GLINT_ONE));
    camera.near_plane = any_size(INT32_MAX);
    camera.field_of_view = any(GLINT_ONE, 170 * GLINT_ONE);
    if (any(0, 2)) {
        camera.projection = &glint_orthographic;
        camera.view_height = GLINT_ONE / 256 - 1 + any_size(INT32_MAX - GLINT_ONE);
    }
    return camera;
}

static const glint_colour white = {GLINT_ONE, GLINT_ONE, GLINT_ONE};

/* Half of what a square screen shows, with a quarter more, at the near plane. */
static int64_t half_of_view(const glint_camera *camera) {
    if (camera->projection)
        return (int64_t)camera->view_height * 5 / 8 + 2;
    const glint_q16 half = camera->field_of_view / 2;
    return (int64_t)camera->near_plane * glint_sin(half) / glint_cos(half) * 5 / 4 + 2;
}

static void lines_across_views_have_every_column(void) {
    uint32_t drawn = 0, reported = 0;
    for (uint32_t i = 0; i < 4000 / sample_share(); i++) {
        state = i + 1;
        const glint_camera camera = any_camera();
        const int size = any(1, 70);
        const int64_t half = half_of_view(&camera);
        const glint_q16 near_plane = camera.near_plane;
        if (half > 18000 * (int64_t)GLINT_ONE || near_plane > 18000 * GLINT_ONE || half < 1000 * size ||
            half < near_plane >> 10)
            continue; /* ends leave the range, or they or the turn are rounded to whole pixels */
        /* behind the near plane by more than the turn's rounding brings an end towards it */
        const glint_q16 away = -(near_plane + near_plane / 64 + (glint_q16)(half >> 12) + 2);
        const glint_vector left = {(glint_q16)-half, 0, away}, right = {(glint_q16)half, 0, away};
        const glint_line line = {glint_pose_apply(&camera.pose, left), glint_pose_apply(&camera.pose, right), white};
        picture image = picture_open(size, size, &glint_format_rgb565);
        if (!CHECK_EQUAL(draw(&camera, &line, 1, 16, &image), size) && reported++ < 8) {
            test_write("  view ");
            test_write_number(i);
            test_write("\n");
        }
        picture_close(&image);
        drawn++;
    }
    CHECK(drawn > 400 / sample_share());
}

static void any_lines_are_the_same_in_all_tiles(void) {
    for (uint32_t i = 0; i < 3000 / sample_share(); i++) {
        state = i + 1;
        const glint_camera camera = any_camera();
        const int width = any(1, 70), height = any(1, 70);
        const int32_t most = any_size(INT32_MAX);
        glint_line lines[LINES];
        for (uint32_t l = 0; l < LINES; l++)
            lines[l] = (glint_line){{any(-most, most), any(-most, most), any(-most, most)},
                                    {any(-most, most), any(-most, most), any(-most, most)},
                                    {any(0, GLINT_ONE), any(0, GLINT_ONE), any(0, GLINT_ONE)}};
        picture whole = picture_open(width, height, &glint_format_rgb565);
        const uint32_t marked = draw(&camera, lines, LINES, 64, &whole);
        for (uint16_t tile = 8; tile < 64; tile *= 2) {
            picture again = picture_open(width, height, &glint_format_rgb565);
            CHECK_EQUAL(draw(&camera, lines, LINES, tile, &again), marked);
            CHECK(picture_equal(&again, &whole));
            picture_close(&again);
        }
        picture_close(&whole);
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(lines_across_views_have_every_column),
                                      TEST_CASE(any_lines_are_the_same_in_all_tiles)};
    return test_run(write, cases, TEST_COUNT(cases));
}
