/* SPDX-License-Identifier: MIT */
/*
 * Draws random scenes, and prints a line for each: its seed, its kind, how it is drawn, the status and a sum of all
 * bytes. `draw COUNT SEED`. levels.py compares what the library prints that is built in different ways.
 */
#include "equivalence/varied_scene.h"
#include "picture.h"

#include <stdio.h>
#include <stdlib.h>

/* FNV-1a (Fowler, Noll and Vo). */
static uint32_t sum_of(const picture *image) {
    uint32_t sum = 2166136261u;
    for (size_t i = 0; i < image->size; i++)
        sum = (sum ^ image->bytes[i]) * 16777619u;
    return sum;
}

/* Draws with as much arena as is asked for, of 256 parts from the least to one pass; nothing is counted. */
static glint_status draw(const varied_scene *s, picture *image) {
    static const uint16_t tiles[5] = {0, 8, 16, 32, 64};
    static const uint32_t arenas[4] = {0, 64, 256, 256};
    const glint_scene *const scene = &s->scene;
    picture_options options = varied_scene_options(s);
    const uint32_t sizes = options.samples ? 4 : 5;
    options.tile_width = tiles[varied_pick(s->seed, 1, sizes)];
    options.tile_height = tiles[varied_pick(s->seed, 2, sizes)];
    glint_config config = picture_config(image, &options);
    glint_renderer renderer;
    glint_need need;
    glint_status status = glint_arena_need(&config, scene, &need);
    if (status != GLINT_OK)
        return status;
    config.arena_size = need.least + (need.one_pass - need.least) * arenas[varied_pick(s->seed, 4, 4)] / 256;
    config.arena = malloc(config.arena_size);
    status = config.arena ? glint_init(&renderer, &config) : GLINT_ERROR_NULL;
    if (status == GLINT_OK)
        status = glint_render(&renderer, scene);
    free(config.arena);
    return status;
}

static void draw_scene(uint64_t seed) {
    static varied_scene s;
    varied_scene_make(&s, seed);
    picture image = picture_open(s.width, s.height, s.format);
    const glint_status status = draw(&s, &image);
    printf("%lu (%s, %dx%d): %d %08lx\n", (unsigned long)seed, s.kind, image.width, image.height, status,
           (unsigned long)sum_of(&image));
    picture_close(&image);
}

int main(int count, char **arguments) {
    const unsigned long scenes = count > 1 ? strtoul(arguments[1], NULL, 10) : 1000;
    const unsigned long first = count > 2 ? strtoul(arguments[2], NULL, 10) : 1;
    for (unsigned long i = 0; i < scenes; i++)
        draw_scene(first + i);
    return 0;
}
