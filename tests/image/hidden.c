/* SPDX-License-Identifier: MIT */
/*
 * Suite: objects that hide each other. Each is drawn alone, and of what they show the nearest pixel is taken, the first
 * object's where two are as near: together they show the same bits.
 */
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "scenes.h"
#include "scenes/scenes.h"
#include "stability/random_scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Objects one by one -------------------------------------------------------------------------------------- */

#define OBJECTS_MAX 32

/* How many pixels an object covers that a later one hides, and that a later one is as near as. */
static long hidden, tied;

/* An image and its depth, 0 where nothing is. */
typedef struct layer {
    picture image;
    uint16_t *depth;
} layer;

static layer layer_open(int width, int height, const glint_format *format) {
    return (layer){picture_open(width, height, format), calloc((size_t)width * (size_t)height, sizeof(uint16_t))};
}

static void layer_close(layer *l) {
    picture_close(&l->image);
    free(l->depth);
}

static void keep_tile(const glint_frame *frame, const glint_workspace *workspace, uint32_t tile, layer *to) {
    int at[4];
    glint_tile_rectangle(frame, tile, &at[0], &at[1], &at[2], &at[3]);
    CHECK_EQUAL(picture_put(&to->image, at, workspace->pixels, workspace->stride), 0);
    for (int y = 0; y < at[3]; y++)
        memcpy(to->depth + (at[1] + y) * to->image.width + at[0], workspace->depth + y * frame->config.tile_width,
               (size_t)at[2] * sizeof *to->depth);
}

/* Draws a scene in an arena of this size. */
static void draw_layer(const glint_scene *scene, size_t arena_size, layer *to) {
    glint_config config = picture_config(&to->image, NULL);
    glint_frame frame;
    glint_workspace workspace;
    config.tile_width = config.tile_height = 16;
    config.arena_size = arena_size;
    config.arena = malloc(arena_size);
    void *const memory = malloc(glint_workspace_size(&config));
    int status = CHECK(config.arena && memory) ? (int)glint_frame_begin(&frame, &config, scene) : GLINT_ERROR_NULL;
    CHECK_EQUAL(status, GLINT_OK);
    glint_workspace_init(&workspace, &config, memory);
    while (status >= 0 && (status = glint_frame_next(&frame)) > 0) {
        for (uint32_t tile = frame.tile_first; tile < frame.tile_end; tile++) {
            if (frame.starts) /* a tile of background alone has no depth */
                memset(workspace.depth, 0, 16 * 16 * sizeof *workspace.depth);
            if (glint_render_tile(&frame, &workspace, tile))
                keep_tile(&frame, &workspace, tile, to);
        }
    }
    CHECK_EQUAL(status, 0);
    free(memory);
    free(config.arena);
}

static void copy_pixel(const picture *from, picture *to, int i) {
    const size_t size = from->stride / (size_t)from->width;
    memcpy(to->bytes + (size_t)i * size, from->bytes + (size_t)i * size, size);
}

/* Puts an object's pixels where they are nearer than what was there. */
static void put_over(const layer *one, layer *to) {
    for (int i = 0; i < to->image.width * to->image.height; i++) {
        hidden += to->depth[i] && one->depth[i] > to->depth[i];
        tied += one->depth[i] && one->depth[i] == to->depth[i];
        if (one->depth[i] <= to->depth[i])
            continue;
        copy_pixel(&one->image, &to->image, i);
        to->depth[i] = one->depth[i];
    }
}

/* The scene with one of its objects; of the others there is a triangle without area. */
static glint_scene leave_one(const glint_scene *scene, uint32_t which, glint_object *objects, glint_mesh *meshes) {
    static const uint16_t nothing[1][3] = {{0, 0, 0}};
    glint_scene one = *scene;
    for (uint32_t i = 0; i < scene->object_count; i++) {
        objects[i] = scene->objects[i];
        if (i == which)
            continue;
        meshes[i] = *objects[i].mesh;
        meshes[i].clusters = NULL;
        meshes[i].triangles = nothing;
        meshes[i].triangle_count = 1;
        objects[i].mesh = &meshes[i];
    }
    one.objects = objects;
    return one;
}

/* In a format of whole bytes a pixel, and arenas of one pass and of many. */
static void check_scene(const glint_scene *scene, int width, int height, const glint_format *format, const char *name) {
    static glint_object objects[OBJECTS_MAX];
    static glint_mesh meshes[OBJECTS_MAX];
    layer whole = layer_open(width, height, format), wanted = layer_open(width, height, format),
          one = layer_open(width, height, format);
    glint_config config = picture_config(&whole.image, NULL);
    glint_need need;
    config.tile_width = config.tile_height = 16;
    if (CHECK_EQUAL(glint_arena_need(&config, scene, &need), GLINT_OK) && CHECK(scene->object_count <= OBJECTS_MAX)) {
        const size_t sizes[3] = {need.one_pass, need.least + (need.one_pass - need.least) / 3, need.least};
        for (uint32_t i = 0; i < scene->object_count; i++) {
            const glint_scene alone = leave_one(scene, i, objects, meshes);
            draw_layer(&alone, need.one_pass, i ? &one : &wanted);
            if (i)
                put_over(&one, &wanted);
        }
        for (int i = 0; i < (scene->object_count > 1 ? 3 : 0); i++) {
            draw_layer(scene, sizes[i], &whole);
            if (!CHECK(picture_equal(&whole.image, &wanted.image))) {
                char line[160];
                snprintf(line, sizeof line, "  %s, arena of %lu bytes\n", name, (unsigned long)sizes[i]);
                test_write(line);
            }
        }
    }
    layer_close(&whole);
    layer_close(&wanted);
    layer_close(&one);
}

static void gallery(void) {
    static example_stage stage;
    for (unsigned i = 0; i < EXAMPLE_SCENES; i++) {
        for (uint32_t variant = 0; variant < example_scenes[i]->variant_count; variant++) {
            example_scenes[i]->build(&stage, variant, example_scenes[i]->frames / 3);
            check_scene(&stage.scene, 160, 120, &glint_format_rgb888, example_scenes[i]->name);
        }
    }
}

/* At the same place as another, each third time, of another material. */
static void random_scenes(void) {
    static random_scene scene;
    char name[60];
    for (uint32_t seed = 1; seed <= 1200; seed++) {
        random_scene_make(&scene, seed);
        if (scene.scene.object_count > 1 && seed % 3 == 0) {
            scene.objects[1].mesh = scene.objects[0].mesh;
            scene.objects[1].pose = scene.objects[0].pose;
        }
        snprintf(name, sizeof name, "seed %u, %s", (unsigned)seed, random_regions[scene.region].name);
        check_scene(&scene.scene, scene.width, scene.height, scene.format, name);
    }
}

static void objects_were_hidden(void) {
    char line[80];
    snprintf(line, sizeof line, "  %ld pixels hidden by later objects, %ld as near\n", hidden, tied);
    test_write(line);
    CHECK(hidden > 10000);
    CHECK(tied > 10000);
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(gallery), TEST_CASE(random_scenes), TEST_CASE(objects_were_hidden)};
    return test_run(write, cases, TEST_COUNT(cases));
}
