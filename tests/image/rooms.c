/* SPDX-License-Identifier: MIT */
/*
 * Suite: large triangles with the eye inside. Every way to draw a scene gives the same bits: arenas from the least to
 * one pass, tiles from 8 to 64 pixels, regions; and a closed room shows no background. GLINT_ROOMS sets how many random
 * scenes there are, GLINT_ROOMS_SEED the first one's seed.
 */
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "sample.h"
#include "stability/large_scene.h"

#include <stdio.h>
#include <stdlib.h>

/* ---- One way to draw a scene --------------------------------------------------------------------------------- */

typedef struct way {
    uint16_t tile_width, tile_height;
    uint32_t arena; /* 0 the least, 256 one pass, between them what lies between */
    glint_rectangle region;
} way;

/*
 * Draws a scene in a way: over a copy of its picture, which does not change, or into `whole`. Nothing is counted: where
 * what kernels draw is counted, no hidden triangle is left out. @return whether the picture is, or has become, the
 * scene's
 */
static int draws_same(const glint_scene *scene, picture *whole, const way *by, uint32_t *empty) {
    picture_options options = {.tile_width = by->tile_width,
                               .tile_height = by->tile_height,
                               .region = by->region,
                               .overlay = {picture_count_empty, empty}};
    const glint_need need = picture_need(whole, scene, &options);
    options.arena_size = picture_arena(&need, by->arena);
    *empty = 0;
    return picture_draws_same(whole, scene, &options, NULL);
}

/* Draws a scene in one pass. */
static glint_status draw(const glint_scene *scene, picture *image, uint32_t *empty) {
    const picture_options options = {.overlay = {picture_count_empty, empty}};
    *empty = 0;
    return picture_render(image, scene, &options, NULL);
}

/* ---- Scenes that were wrong ---------------------------------------------------------------------------------- */

static const way in_one_pass = {0, 0, 256, {0, 0, 0, 0}};

/* A triangle whose plane of 1/w is off by more than the 1/w of its corners: colours were divided by 0. */
static void far_colours_are_drawn(void) {
    static const int16_t points[3][3] = {{26624, -17408, -11264}, {-22528, 1024, -30720}, {-9216, 19456, -10240}};
    static const uint8_t colours[3][3] = {{255, 255, 255}, {128, 255, 128}, {255, 0, 0}};
    static const uint16_t side[1][3] = {{0, 1, 2}};
    const glint_q16 size = 1000 * GLINT_ONE;
    const glint_mesh mesh = {points, points, side, 3, 1, {0, 0, 0}, {size, size, size}, GLINT_MESH_DOUBLE_SIDED,
                             colours};
    const glint_material paint = {.model = &glint_model_unlit, .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    static const glint_evaluation *const evaluations[3] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    for (unsigned i = 0; i < TEST_COUNT(evaluations); i++) {
        const glint_object object = {&mesh, &paint, glint_pose_identity(), evaluations[i]};
        const glint_scene scene = {
            .camera = {glint_pose_identity(), 50 * GLINT_ONE, 1}, .objects = &object, .object_count = 1};
        picture image = picture_open(160, 120, &glint_format_rgb565);
        uint32_t empty;
        CHECK_EQUAL(draw(&scene, &image, &empty), GLINT_OK);
        CHECK(picture_is_complete(&image));
        CHECK(empty > 0 && empty < 160 * 120 / 2);
        picture_close(&image);
    }
}

/* The largest step from a pixel that shows no background to the next one of its row, of 24 bits each. */
static int largest_step(const picture *image) {
    int most = 0;
    for (int y = 0; y < image->height; y++)
        for (int x = 1; x < image->width; x++) {
            const uint8_t *const pixel = image->bytes + (size_t)y * image->stride + 3 * (size_t)x;
            for (int c = 0; c < 3 && (pixel[-2] | pixel[-3]) && (pixel[0] | pixel[1]); c++)
                most = abs(pixel[c] - pixel[c - 3]) > most ? abs(pixel[c] - pixel[c - 3]) : most;
        }
    return most;
}

/* Another one, behind an object without pixels: where 1/w was rounded below 0, whether it was drawn was up to the
 * arena. */
static void far_triangles_are_not_hidden(void) {
    static const int16_t dot_places[2][3] = {{0, 0, 0}, {0, 0, 0}}, normals[3][3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    static const int16_t places[3][3] = {{0, 8192, 0}, {0, 0, 0}, {0, 0, -16384}};
    static const uint16_t dot_sides[1][3] = {{0, 1, 0}}, sides[1][3] = {{0, 2, 1}};
    static const uint16_t colours[3] = {32024, 29973, 11594};
    static const way ways[] = {{8, 8, 0, {0, 0, 0, 0}}, {8, 8, 256, {0, 0, 0, 0}}, {64, 8, 0, {0, 0, 0, 0}}};
    const glint_vector one = {GLINT_ONE, GLINT_ONE, GLINT_ONE};
    const glint_mesh dot = {dot_places, normals, dot_sides, 2, 1, {0, 0, 0}, one};
    const glint_mesh far = {places, normals, sides, 3, 1, {0, 0, 0}, one, .colours565 = colours};
    const glint_material paint = {.model = &glint_model_unlit, .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    const glint_object objects[2] = {
        {&dot, &paint, glint_pose_identity()},
        {&far, &paint, {{{0, -86573056, 0, 0}, {3113, -885456896, 0, 0}, {0, 0, 398852096, 0}}}, &glint_per_vertex}};
    const glint_scene scene = {
        .camera = {{{{-11843, -8272, 63924, 16777216}, {2762, -64999, -7900, -122851}, {64398, 1266, 12095, 40770}}},
                   45 * GLINT_ONE,
                   1},
        .objects = objects,
        .object_count = 2,
        .background = {0, 0, GLINT_ONE}};
    picture image = picture_open(24, 8, &glint_format_rgb888);
    uint32_t empty, again;
    CHECK_EQUAL(draw(&scene, &image, &empty), GLINT_OK);
    CHECK_EQUAL(empty, 24 * 8 - 42);
    CHECK_AT_MOST(largest_step(&image), 64); /* of noise, 255 */
    for (unsigned i = 0; i < TEST_COUNT(ways); i++) {
        CHECK(draws_same(&scene, &image, &ways[i], &again));
        CHECK_EQUAL(again, empty);
    }
    picture_close(&image);
}

/* ---- Random scenes ------------------------------------------------------------------------------------------- */

static uint32_t number_from(const char *name, uint32_t otherwise) {
    const char *const text = getenv(name);
    return text ? (uint32_t)strtoul(text, NULL, 10) : otherwise;
}

/* Numbers for the ways of a scene (Knuth's multiplicative hash). */
static uint32_t take(uint32_t *state, uint32_t limit) {
    *state = *state * 2654435761u + 12345;
    return (uint32_t)((uint64_t)(*state >> 8) * limit >> 24);
}

/* Part of a side, from a multiple of 8 to another one or to the side's end. */
static void take_part(uint32_t *state, int side, int16_t *from, int16_t *size) {
    const uint32_t steps = ((uint32_t)side + 7) / 8, first = take(state, steps);
    const int end = 8 * (int)(first + 1 + take(state, steps - first));
    *from = (int16_t)(8 * first);
    *size = (int16_t)((end < side ? end : side) - *from);
}

static way take_way(uint32_t *state, const large_scene *s, uint32_t number) {
    static const uint32_t arenas[4] = {0, 0, 256, 64};
    way by = {(uint16_t)(8u << take(state, 4)), (uint16_t)(8u << take(state, 4)), arenas[number % 4], {0, 0, 0, 0}};
    if (number == 3)
        by.arena = take(state, 256);
    if (number == 1) {
        take_part(state, s->width, &by.region.x, &by.region.width);
        take_part(state, s->height, &by.region.y, &by.region.height);
    }
    return by;
}

static uint32_t drawn, refused, reported;

static void report(const large_scene *s, const way *by, const char *what) {
    char line[200];
    if (reported++ >= 8)
        return;
    snprintf(line, sizeof line, "  seed %u, %s, %dx%d: %s; tiles of %ux%u, arena %u/256, region %d %d %d %d\n",
             (unsigned)s->seed, large_kind_names[s->kind], s->width, s->height, what, by->tile_width, by->tile_height,
             (unsigned)by->arena, by->region.x, by->region.y, by->region.width, by->region.height);
    test_write(line);
}

static void check_scene(const large_scene *s) {
    uint32_t state = (uint32_t)s->seed, empty, again;
    picture whole = picture_open(s->width, s->height, s->format);
    const glint_status status = draw(&s->scene, &whole, &empty);
    drawn += status == GLINT_OK;
    refused += status != GLINT_OK;
    if (status != GLINT_OK && !CHECK_EQUAL(status, GLINT_ERROR_RANGE))
        report(s, &in_one_pass, glint_strerror(status));
    if (status == GLINT_OK && s->is_closed && !CHECK_EQUAL(empty, 0))
        report(s, &in_one_pass, "holes");
    for (uint32_t i = 0; i < 4 && status == GLINT_OK; i++) {
        const way by = take_way(&state, s, i);
        if (!CHECK(draws_same(&s->scene, &whole, &by, &again)))
            report(s, &by, "other pixels");
    }
    picture_close(&whole);
}

static void random_scenes_in_every_way(void) {
    static large_scene scene;
    const uint32_t count = number_from("GLINT_ROOMS", 4000) / sample_share(),
                   first = number_from("GLINT_ROOMS_SEED", 1);
    char line[80];
    for (uint32_t i = 0; i < count; i++) {
        large_scene_make(&scene, first + i);
        check_scene(&scene);
    }
    snprintf(line, sizeof line, "  %u scenes from seed %u, %u out of range\n", (unsigned)drawn, (unsigned)first,
             (unsigned)refused);
    test_write(line);
    CHECK_AT_MOST(20 * refused, drawn);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(far_colours_are_drawn),
        TEST_CASE(far_triangles_are_not_hidden),
        TEST_CASE(random_scenes_in_every_way),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
