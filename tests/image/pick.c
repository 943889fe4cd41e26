/* SPDX-License-Identifier: MIT */
/*
 * Suite: what is picked at a pixel is what the frame shows there. The triangle that is named, alone in the scene, is as
 * near there as the whole frame; and nothing is picked just where the frame shows background.
 */
#include "glint_extras.h"
#include "harness.h"
#include "random.h"
#include "scenes.h"

#include <string.h>

#define WIDTH 150
#define HEIGHT 101

static uint8_t arena[1 << 20];
static uint16_t depth[HEIGHT][WIDTH];

static int nothing(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context, (void)x, (void)y, (void)width, (void)height, (void)pixels, (void)stride;
    return 0;
}

/* Keeps the depth of a finished tile. */
static int keep_depth(void *context, const glint_tile *tile) {
    (void)context;
    for (int y = 0; y < tile->height; y++)
        memcpy(&depth[tile->y + y][tile->x], tile->depth + (size_t)y * tile->depth_stride,
               (size_t)tile->width * sizeof(uint16_t));
    return 0;
}

/* Depth of a pixel of the scene where all but one triangle of it have no area. */
static uint16_t depth_of(const glint_config *config, const test_scene *of, const glint_hit *hit, int x, int y) {
    static const uint16_t no_area[1][3] = {{0, 0, 0}};
    test_scene scene = *of;
    glint_mesh meshes[SCENE_OBJECTS_MAX];
    glint_renderer renderer;
    scene.scene.objects = scene.objects;
    for (uint32_t i = 0; i < scene.scene.object_count; i++) {
        meshes[i] = *of->objects[i].mesh;
        meshes[i].triangles = i == hit->object ? meshes[i].triangles + hit->triangle : no_area;
        meshes[i].triangle_count = 1;
        meshes[i].clusters = NULL;
        scene.objects[i].mesh = &meshes[i];
    }
    CHECK_EQUAL(glint_init(&renderer, config), GLINT_OK);
    CHECK_EQUAL(glint_render(&renderer, &scene.scene), GLINT_OK);
    return depth[y][x];
}

static uint32_t picks;

/* Picks at some pixels, the frame drawn anew where that was overwritten. */
static void check_picks(const glint_config *config, const test_scene *scene, int count) {
    glint_config plain = *config;
    glint_renderer renderer;
    plain.overlay.paint = NULL;
    CHECK_EQUAL(glint_init(&renderer, config), GLINT_OK);
    CHECK_EQUAL(glint_render(&renderer, &scene->scene), GLINT_OK);
    static uint16_t shown[HEIGHT][WIDTH];
    memcpy(shown, depth, sizeof depth);
    CHECK_EQUAL(glint_init(&renderer, &plain), GLINT_OK);
    for (int i = 0; i < count; i++) {
        const int x = any(0, WIDTH - 1), y = any(0, HEIGHT - 1);
        glint_hit hit = {77, 77, 77};
        const int found = glint_pick(&renderer, &scene->scene, x, y, &hit);
        CHECK_EQUAL(found, shown[y][x] != 0);
        if (!found) {
            CHECK_EQUAL(hit.object, 77);
            continue;
        }
        picks++;
        CHECK_EQUAL(hit.depth, shown[y][x]);
        CHECK(hit.object < scene->scene.object_count);
        CHECK(hit.triangle < scene->objects[hit.object].mesh->triangle_count);
        CHECK_EQUAL(depth_of(config, scene, &hit, x, y), hit.depth);
    }
}

static void what_is_picked_is_what_shows(void) {
    static const uint16_t tiles[] = {8, 16, 32, 64};
    picks = 0;
    for (unsigned i = 0; i < scene_count; i++)
        for (int small = 0; small < 2; small++) {
            test_scene scene;
            glint_need need;
            scene_build(&scene, &scene_definitions[i]);
            random_state = 2 * i + (unsigned)small;
            glint_config config = {.width = WIDTH,
                                   .height = HEIGHT,
                                   .tile_width = tiles[any(0, 3)],
                                   .tile_height = tiles[any(0, 3)],
                                   .format = any(0, 1) ? &glint_format_mono_pages : &glint_format_rgb565,
                                   .flush = {.begin = nothing},
                                   .arena = arena,
                                   .arena_size = sizeof arena,
                                   .overlay = {.paint = keep_depth}};
            CHECK_EQUAL(glint_arena_need(&config, &scene.scene, &need), GLINT_OK);
            config.arena_size = small ? need.least : need.one_pass;
            check_picks(&config, &scene, 60);
        }
    test_write("  picked: ");
    test_write_number(picks);
    test_write("\n");
    CHECK(picks > 300);
}

/* A renderer whose arena is kept draws the same frame after a pick as before. */
static void frames_are_the_same_after_a_pick(void) {
    test_scene scene;
    glint_renderer renderer;
    glint_hit hit;
    static uint16_t before[HEIGHT][WIDTH];
    scene_build_random(&scene, 4);
    const glint_config config = {.width = WIDTH,
                                 .height = HEIGHT,
                                 .format = &glint_format_rgb565,
                                 .flush = {.begin = nothing},
                                 .arena = arena,
                                 .arena_size = sizeof arena,
                                 .keeps_arena = 1,
                                 .overlay = {.paint = keep_depth}};
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    for (int i = 0; i < 3; i++) {
        CHECK_EQUAL(glint_render(&renderer, &scene.scene), GLINT_OK);
        if (i)
            CHECK(memcmp(before, depth, sizeof depth) == 0);
        memcpy(before, depth, sizeof depth);
        CHECK(glint_pick(&renderer, &scene.scene, 70 + i, 50, &hit) >= 0);
    }
}

static void bad_picks_are_refused(void) {
    test_scene scene;
    glint_renderer renderer;
    glint_hit hit;
    scene_build_random(&scene, 4);
    const glint_config config = {.width = WIDTH,
                                 .height = HEIGHT,
                                 .format = &glint_format_rgb565,
                                 .flush = {.begin = nothing},
                                 .arena = arena,
                                 .arena_size = sizeof arena};
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    CHECK_EQUAL(glint_pick(NULL, &scene.scene, 0, 0, &hit), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_pick(&renderer, NULL, 0, 0, &hit), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_pick(&renderer, &scene.scene, 0, 0, NULL), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_pick(&renderer, &scene.scene, -1, 0, &hit), GLINT_ERROR_REGION);
    CHECK_EQUAL(glint_pick(&renderer, &scene.scene, 0, HEIGHT, &hit), GLINT_ERROR_REGION);
    scene.scene.camera.near_plane = 0;
    CHECK_EQUAL(glint_pick(&renderer, &scene.scene, 0, 0, &hit), GLINT_ERROR_CAMERA);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(what_is_picked_is_what_shows),
        TEST_CASE(frames_are_the_same_after_a_pick),
        TEST_CASE(bad_picks_are_refused),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
