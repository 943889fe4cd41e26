/* SPDX-License-Identifier: MIT */
/*
 * Suite: what is picked at a pixel is what the frame shows there. The triangle that is named, alone in the scene, is as
 * near there as the whole frame; and nothing is picked just where the frame shows background.
 */
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "random.h"
#include "scenes.h"

#include <string.h>

#define WIDTH 150
#define HEIGHT 101

static uint8_t arena[1 << 20];
static uint16_t depth[HEIGHT][WIDTH];

/* Draws a scene for its depth. */
static void draw(const glint_scene *scene, picture *image, const picture_options *how) {
    picture_options options = *how;
    options.depth = depth[0];
    CHECK_EQUAL(picture_render(image, scene, &options, NULL), GLINT_OK);
}

/* Depth of a pixel of the scene where all but one triangle of it have no area. */
static uint16_t depth_of(const test_scene *of, const glint_hit *hit, int x, int y, picture *image) {
    static const uint16_t no_area[1][3] = {{0, 0, 0}};
    test_scene scene = *of;
    glint_mesh meshes[SCENE_OBJECTS_MAX];
    scene.scene.objects = scene.objects;
    for (uint32_t i = 0; i < scene.scene.object_count; i++) {
        meshes[i] = *of->objects[i].mesh;
        meshes[i].triangles = i == hit->object ? meshes[i].triangles + hit->triangle : no_area;
        meshes[i].triangle_count = 1;
        meshes[i].clusters = NULL;
        scene.objects[i].mesh = &meshes[i];
    }
    draw(&scene.scene, image, &(picture_options){0});
    return depth[y][x];
}

static uint32_t picks;

/* A renderer for an image, in an arena of this size. */
static glint_renderer open_renderer(picture *image, const picture_options *how, size_t size) {
    glint_config config = picture_config(image, how);
    glint_renderer renderer;
    config.arena = arena;
    config.arena_size = size;
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    return renderer;
}

/* Picks at some pixels of a frame. */
static void check_picks(const test_scene *scene, picture *image, const picture_options *how, int count) {
    static uint16_t shown[HEIGHT][WIDTH];
    glint_renderer renderer = open_renderer(image, how, how->arena_size);
    draw(&scene->scene, image, how);
    memcpy(shown, depth, sizeof depth);
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
        CHECK_EQUAL(depth_of(scene, &hit, x, y, image), hit.depth);
    }
}

/* In arenas of one pass and the least, by rays that meet in the eye and parallel ones. */
static void what_is_picked_is_what_shows(void) {
    static const uint16_t tiles[] = {8, 16, 32, 64};
    picks = 0;
    for (unsigned i = 0; i < 4 * scene_count; i++) {
        test_scene scene;
        scene_build(&scene, &scene_definitions[i / 4]);
        if (i & 2)
            scene_make_parallel(&scene.scene);
        random_state = i;
        picture image = picture_open(WIDTH, HEIGHT, below(2) ? &glint_format_mono_pages : &glint_format_rgb565);
        picture_options how = {.tile_width = tiles[below(4)], .tile_height = tiles[below(4)]};
        const glint_need need = picture_need(&image, &scene.scene, &how);
        how.arena_size = i & 1 ? need.least : need.one_pass;
        check_picks(&scene, &image, &how, 60);
        picture_close(&image);
    }
    test_write("  picked: ");
    test_write_number(picks);
    test_write("\n");
    CHECK(picks > 600);
}

/* A renderer whose arena is kept draws the same frame after a pick as before. */
static void frames_are_the_same_after_a_pick(void) {
    test_scene scene;
    glint_hit hit;
    scene_build_random(&scene, 4);
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565),
            wanted = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    glint_renderer renderer = open_renderer(&image, NULL, sizeof arena);
    renderer.config.keeps_arena = 1;
    CHECK_EQUAL(picture_render(&wanted, &scene.scene, NULL, NULL), GLINT_OK);
    for (int i = 0; i < 3; i++) {
        CHECK_EQUAL(glint_render(&renderer, &scene.scene), GLINT_OK);
        CHECK(picture_equal(&image, &wanted));
        memset(image.bytes, 0, image.size);
        CHECK(glint_pick(&renderer, &scene.scene, 70 + i, 50, &hit) >= 0);
    }
    picture_close(&image);
    picture_close(&wanted);
}

static void bad_picks_are_refused(void) {
    test_scene scene;
    glint_hit hit;
    scene_build_random(&scene, 4);
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    glint_renderer renderer = open_renderer(&image, NULL, sizeof arena);
    CHECK_EQUAL(glint_pick(NULL, &scene.scene, 0, 0, &hit), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_pick(&renderer, NULL, 0, 0, &hit), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_pick(&renderer, &scene.scene, 0, 0, NULL), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_pick(&renderer, &scene.scene, -1, 0, &hit), GLINT_ERROR_REGION);
    CHECK_EQUAL(glint_pick(&renderer, &scene.scene, 0, HEIGHT, &hit), GLINT_ERROR_REGION);
    scene.scene.camera.near_plane = 0;
    CHECK_EQUAL(glint_pick(&renderer, &scene.scene, 0, 0, &hit), GLINT_ERROR_CAMERA);
    picture_close(&image);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(what_is_picked_is_what_shows),
        TEST_CASE(frames_are_the_same_after_a_pick),
        TEST_CASE(bad_picks_are_refused),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
