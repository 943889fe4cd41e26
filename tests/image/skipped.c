/* SPDX-License-Identifier: MIT */
/*
 * Suite: objects with nothing to draw. Where a configuration skips them, a scene with some is what it is without them:
 * pixels, arena, what is picked; and they are counted. Where it does not, they are errors.
 */
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "scenes.h"

#include <stdlib.h>
#include <string.h>

#define WIDTH 96
#define HEIGHT 64
#define OBJECTS_MAX (2 * SCENE_OBJECTS_MAX + 2)

static const int16_t corners[3][3] = {{0, 0, 0}, {32767, 0, 0}, {0, 32767, 0}};
static const uint16_t triangle[1][3] = {{0, 1, 2}};

/* What is the matter with an object. */
enum { FLAT_X, FLAT_Y, FLAT_Z, NO_POSE, COLUMNS_ALIKE, NO_VERTICES, NO_TRIANGLES, NO_MESH, EMPTY_AND_FLAT, KINDS };

static glint_mesh meshes[OBJECTS_MAX];

static int is_flat(int kind) {
    return kind <= COLUMNS_ALIKE;
}

/* Makes an object that has nothing to draw: where the first is, of its material. */
static glint_object degenerate(int kind, const glint_object *like, glint_mesh *mesh) {
    glint_object object = *like;
    const glint_q16 one = GLINT_ONE;
    const glint_pose scale[] = {glint_pose_scale(0, one, one), glint_pose_scale(one, 0, one),
                                glint_pose_scale(one, one, 0), glint_pose_scale(0, 0, 0)};
    *mesh = *like->mesh;
    object.mesh = mesh;
    if (kind <= NO_POSE)
        object.pose = glint_pose_then(&scale[kind], &like->pose);
    if (kind == COLUMNS_ALIKE)
        for (int row = 0; row < 3; row++)
            object.pose.m[row][1] = object.pose.m[row][2];
    if (kind == NO_VERTICES || kind == NO_TRIANGLES)
        *mesh =
            (glint_mesh){.positions = corners, .normals = corners, .triangles = triangle, .extent = {one, one, one}};
    if (kind == NO_VERTICES)
        mesh->triangle_count = 1;
    if (kind == NO_TRIANGLES)
        mesh->vertex_count = 3;
    if (kind == NO_MESH || kind == EMPTY_AND_FLAT)
        *mesh = (glint_mesh){.extent = {-1, 0, 0}, .flags = 77};
    if (kind == EMPTY_AND_FLAT)
        object.pose = scale[NO_POSE];
    return object;
}

/* The scene with one such object in front of each of its own and one behind them, of kinds from `kind` on. */
static glint_scene mix(const glint_scene *of, int kind, glint_object *objects) {
    glint_scene scene = *of;
    scene.objects = objects;
    scene.object_count = 0;
    for (uint32_t i = 0; i <= of->object_count; i++) {
        objects[scene.object_count] =
            degenerate((kind + (int)i) % KINDS, &of->objects[i < of->object_count ? i : 0], &meshes[i]);
        scene.object_count++;
        if (i < of->object_count)
            objects[scene.object_count++] = of->objects[i];
    }
    return scene;
}

static glint_status draw(const glint_config *of, const glint_scene *scene, size_t arena_size, picture *image,
                         glint_stats *stats) {
    glint_config config = *of;
    glint_renderer renderer;
    config.arena = malloc(arena_size);
    config.arena_size = arena_size;
    config.flush.context = image;
    memset(image->bytes, 0, image->size);
    memset(image->sent, 0, (size_t)(WIDTH * HEIGHT));
    glint_status status = CHECK(config.arena != NULL) ? glint_init(&renderer, &config) : GLINT_ERROR_NULL;
    if (status == GLINT_OK)
        status = glint_render(&renderer, scene);
    *stats = renderer.stats;
    free(config.arena);
    return status;
}

/* What is picked at some pixels is what is picked without them, and what glint_check finds draws. */
static void check_picks(const glint_config *of, const glint_scene *scene, const glint_scene *without, size_t size) {
    glint_config config = *of;
    glint_renderer renderer;
    glint_report report;
    config.arena = malloc(size);
    config.arena_size = size;
    CHECK_EQUAL(glint_check(&config, scene, &report), GLINT_OK);
    CHECK_EQUAL(report.object, -1);
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    for (int i = 0; i < 12; i++) {
        glint_hit hit = {0, 0, 0}, wanted = {0, 0, 0};
        const int x = (i * 37 + 5) % WIDTH, y = (i * 23 + 9) % HEIGHT;
        CHECK_EQUAL(glint_pick(&renderer, scene, x, y, &hit), glint_pick(&renderer, without, x, y, &wanted));
        CHECK(scene->objects[hit.object].mesh == without->objects[wanted.object].mesh || !hit.depth);
        CHECK_EQUAL(hit.triangle, wanted.triangle);
        CHECK_EQUAL(hit.depth, wanted.depth);
    }
    free(config.arena);
}

static void check_needs(const glint_config *config, const glint_scene *scene, const glint_scene *without,
                        glint_need *need) {
    glint_need wanted;
    CHECK_EQUAL(glint_arena_need(config, scene, need), GLINT_OK);
    CHECK_EQUAL(glint_arena_need(config, without, &wanted), GLINT_OK);
    CHECK(!memcmp(need, &wanted, sizeof wanted));
}

static void check_scene(const glint_scene *without, int kind, const glint_format *format) {
    glint_object objects[OBJECTS_MAX];
    const glint_scene scene = mix(without, kind, objects);
    picture image = picture_open(WIDTH, HEIGHT, format), wanted = picture_open(WIDTH, HEIGHT, format);
    glint_config config = picture_config(&image, NULL);
    glint_need need = {0, 0, 0};
    config.tile_width = config.tile_height = 16;
    config.skips_degenerate = 1;
    check_needs(&config, &scene, without, &need);
    const size_t sizes[3] = {need.one_pass, need.least + (need.one_pass - need.least) / 3, need.least};
    for (int i = 0; i < 3; i++) {
        glint_stats stats, plain;
        CHECK_EQUAL(draw(&config, without, sizes[i], &wanted, &plain), GLINT_OK);
        CHECK_EQUAL(draw(&config, &scene, sizes[i], &image, &stats), GLINT_OK);
        CHECK(picture_is_complete(&image) && picture_equal(&image, &wanted));
        CHECK_EQUAL(plain.skipped, 0);
        CHECK_EQUAL(stats.skipped, without->object_count + 1);
        CHECK(stats.hidden >= plain.hidden + stats.skipped);
    }
    check_picks(&config, &scene, without, need.one_pass);
    picture_close(&image);
    picture_close(&wanted);
}

static void test_scenes(void) {
    for (unsigned i = 0; i < scene_count; i++) {
        static test_scene s;
        scene_build(&s, &scene_definitions[i]);
        check_scene(&s.scene, (int)(i % KINDS), i % 2 ? &glint_format_rgb888 : &glint_format_rgb565);
    }
}

static void random_scenes(void) {
    for (uint32_t seed = 1; seed <= 60; seed++) {
        static test_scene s;
        scene_build_random(&s, seed);
        check_scene(&s.scene, (int)(seed % KINDS), seed % 2 ? &glint_format_rgb565 : &glint_format_grey8);
    }
}

/* A frame of the caller's tells them too; where nothing else is there, all of it is background, and that is said. */
static void nothing_else(void) {
    static test_scene s;
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    glint_config config = picture_config(&image, NULL);
    scene_build(&s, &scene_definitions[0]);
    config.skips_degenerate = 1;
    config.arena_size = 1 << 16;
    config.arena = malloc(config.arena_size);
    for (int kind = 0; kind < KINDS; kind++) {
        glint_scene scene = s.scene;
        glint_object object = degenerate(kind, &s.objects[0], &meshes[0]);
        glint_frame frame;
        glint_report report;
        glint_renderer renderer;
        glint_hit hit;
        scene.objects = &object;
        scene.object_count = 1;
        CHECK_EQUAL(glint_frame_begin(&frame, &config, &scene), GLINT_OK);
        CHECK_EQUAL(frame.stats.skipped, 1);
        CHECK_EQUAL(glint_frame_next(&frame), 1);
        CHECK_EQUAL(frame.stats.hidden, 1);
        CHECK_EQUAL(glint_frame_next(&frame), 0);
        CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
        CHECK_EQUAL(glint_pick(&renderer, &scene, WIDTH / 2, HEIGHT / 2, &hit), 0);
        CHECK_EQUAL(glint_check(&config, &scene, &report), GLINT_OK);
        CHECK_EQUAL(report.shown, 0);
        CHECK(strstr(report.sentence, "skipped") != NULL);
        object.hidden = 1;
        CHECK_EQUAL(glint_frame_begin(&frame, &config, &scene), GLINT_OK);
        CHECK_EQUAL(frame.stats.skipped, 0);
    }
    free(config.arena);
    picture_close(&image);
}

/* Where it is not asked for they are errors, for all who look; hidden ones are none. */
static void errors_unasked(void) {
    static test_scene s;
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    glint_config config = picture_config(&image, NULL);
    scene_build(&s, &scene_definitions[0]);
    config.arena_size = 1 << 16;
    config.arena = malloc(config.arena_size);
    for (int kind = 0; kind < KINDS; kind++) {
        glint_object objects[OBJECTS_MAX];
        glint_scene scene = s.scene;
        glint_frame frame;
        glint_report report;
        glint_renderer renderer;
        glint_hit hit;
        glint_need need;
        const int wanted = is_flat(kind)                               ? GLINT_ERROR_POSE
                           : kind == NO_MESH || kind == EMPTY_AND_FLAT ? GLINT_ERROR_NULL
                                                                       : GLINT_ERROR_MESH;
        scene.objects = objects;
        scene.object_count = 2;
        objects[0] = s.objects[0];
        objects[1] = degenerate(kind, &s.objects[0], &meshes[0]);
        CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
        CHECK_EQUAL(glint_render(&renderer, &scene), wanted);
        CHECK_EQUAL(glint_pick(&renderer, &scene, 1, 1, &hit), wanted);
        CHECK_EQUAL(glint_frame_begin(&frame, &config, &scene), wanted);
        CHECK_EQUAL(glint_arena_need(&config, &scene, &need), wanted);
        CHECK_EQUAL(glint_check(&config, &scene, &report), wanted);
        CHECK_EQUAL(report.object, 1);
        objects[1].hidden = 1;
        CHECK_EQUAL(glint_render(&renderer, &scene), is_flat(kind) ? GLINT_OK : wanted);
        CHECK_EQUAL(renderer.stats.skipped, 0);
    }
    free(config.arena);
    picture_close(&image);
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(test_scenes), TEST_CASE(random_scenes), TEST_CASE(nothing_else),
                                      TEST_CASE(errors_unasked)};
    return test_run(write, cases, TEST_COUNT(cases));
}
