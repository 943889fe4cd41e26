/* SPDX-License-Identifier: MIT */
/*
 * Draws random scenes, and prints a line for each: its seed, its kind, how it is drawn, the status and a sum of all
 * bytes. `draw COUNT SEED`. levels.py compares what the library prints that is built in different ways.
 */
#include "every_format.h"
#include "glint.h"
#include "picture.h"
#include "stability/large_scene.h"
#include "stability/random_scene.h"

#include <stdio.h>
#include <stdlib.h>

/* FNV-1a (Fowler, Noll and Vo). */
static uint32_t sum_of(const picture *image) {
    uint32_t sum = 2166136261u;
    for (size_t i = 0; i < image->size; i++)
        sum = (sum ^ image->bytes[i]) * 16777619u;
    return sum;
}

/* A number below `count` for a scene's seed (Knuth's multiplicative hash), and what for. */
static uint32_t pick(uint64_t seed, uint32_t use, uint32_t count) {
    const uint32_t hash = ((uint32_t)seed * 16 + use) * 2654435761u;
    return (uint32_t)((uint64_t)hash * count >> 32);
}

/* Draws with as much arena as is asked for, of 256 parts from the least to one pass; nothing is counted. */
static glint_status draw(const glint_scene *scene, picture *image, uint64_t seed) {
    static const uint16_t tiles[5] = {0, 8, 16, 32, 64};
    static const uint32_t arenas[4] = {0, 64, 256, 256};
    const picture_options options = {.tile_width = tiles[pick(seed, 1, 5)],
                                     .tile_height = tiles[pick(seed, 2, 5)],
                                     .gamma = pick(seed, 3, 4) ? NULL : glint_gamma_srgb};
    glint_config config = picture_config(image, &options);
    glint_renderer renderer;
    glint_need need;
    glint_status status = glint_arena_need(&config, scene, &need);
    if (status != GLINT_OK)
        return status;
    config.arena_size = need.least + (need.one_pass - need.least) * arenas[pick(seed, 4, 4)] / 256;
    config.arena = malloc(config.arena_size);
    status = config.arena ? glint_init(&renderer, &config) : GLINT_ERROR_NULL;
    if (status == GLINT_OK)
        status = glint_render(&renderer, scene);
    free(config.arena);
    return status;
}

static void print(uint64_t seed, const char *kind, const glint_scene *scene, picture image) {
    const glint_status status = draw(scene, &image, seed);
    printf("%lu (%s, %dx%d): %d %08lx\n", (unsigned long)seed, kind, image.width, image.height, status,
           (unsigned long)sum_of(&image));
    picture_close(&image);
}

/* What a random scene leaves as it is most often: the format, the evaluation, flags, the camera and its lights. */
static void vary(random_scene *s, uint64_t seed) {
    const glint_evaluation *const evaluations[3] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    if (pick(seed, 5, 2))
        s->format = every_format[pick(seed, 6, FORMAT_COUNT)];
    for (uint32_t i = 0; i < s->scene.object_count; i++) {
        if (pick(seed, 7, 2))
            s->objects[i].evaluation = evaluations[pick(seed + i, 8, 3)];
        if (pick(seed, 9, 6) == 0)
            s->materials[i].model = &glint_model_unlit;
        if (pick(seed, 10, 4) == 0)
            s->materials[i].flags = pick(seed + i, 11, 4);
    }
    if (pick(seed, 12, 8) == 0) {
        s->scene.camera.projection = &glint_orthographic;
        s->scene.camera.view_height = GLINT_ONE + (glint_q16)pick(seed, 13, 8 * GLINT_ONE);
    }
    if (pick(seed, 14, 4) == 0)
        s->scene.light_count = s->scene.light_count > 1 ? 1 : 0;
}

/* One in four is large. */
static void draw_scene(uint64_t seed) {
    static random_scene any;
    static large_scene large;
    if (seed % 4 == 0) {
        large_scene_make(&large, seed / 4);
        print(seed, large_kind_names[large.kind], &large.scene, picture_open(large.width, large.height, large.format));
        return;
    }
    random_scene_make_in(&any, (unsigned)(seed % random_region_count), seed);
    vary(&any, seed);
    print(seed, random_regions[any.region].name, &any.scene, picture_open(any.width, any.height, any.format));
}

int main(int count, char **arguments) {
    const unsigned long scenes = count > 1 ? strtoul(arguments[1], NULL, 10) : 1000;
    const unsigned long first = count > 2 ? strtoul(arguments[2], NULL, 10) : 1;
    for (unsigned long i = 0; i < scenes; i++)
        draw_scene(first + i);
    return 0;
}
