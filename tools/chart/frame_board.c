/* SPDX-License-Identifier: MIT */
/*
 * Firmware that counts the instructions of whole frames of the benchmark scenes for every choice of shading, clear and
 * copy to a framebuffer in memory included. It writes lines of
 *     torus2304,320x240,rgb565,fragment Blinn-Phong local,INSTRUCTIONS
 * which are means of ten frames.
 */
#include "../bench/counter.h"
#include "../bench/framebuffer.h"
#include "choices.h"

#include <bench_scenes.h>

enum { WIDTH = 320, HEIGHT = 240 };

static uint32_t arena[(1 << 20) / sizeof(uint32_t)];
static uint16_t framebuffer[HEIGHT][WIDTH];

static int copy_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context;
    framebuffer_copy(&framebuffer[y][x], sizeof framebuffer[0], pixels, stride, 2 * (size_t)width, height);
    return 0;
}

/* @return ticks that the ten frames take, as an animation, from glint_init on; 0 after an error */
static uint32_t draw_frames(const glint_config *config, const glint_scene *scene, glint_object *object,
                            const glint_pose *poses) {
    glint_renderer renderer;
    uint32_t ticks = 0;

    for (int frame = 0; frame < BENCH_FRAMES; frame++) {
        object->pose = poses[frame];
        const uint32_t start = counter_now();
        if ((frame == 0 && glint_init(&renderer, config) != GLINT_OK) || glint_render(&renderer, scene) != GLINT_OK) {
            return 0;
        }
        ticks += counter_ticks_since(start);
    }
    return ticks;
}

static uint32_t measure(uint32_t which, const uint16_t size[2], const choice *chosen) {
    glint_material material = bench_material;
    glint_object object = {.mesh = bench_scenes[which].mesh, .material = &material, .evaluation = &glint_per_fragment};
    glint_scene scene = {.ambient = {BENCH_AMBIENT, BENCH_AMBIENT, BENCH_AMBIENT},
                         .lights = &bench_light,
                         .light_count = 1,
                         .objects = &object,
                         .object_count = 1};
    const glint_config config = {.width = size[0],
                                 .height = size[1],
                                 .format = &glint_format_rgb565,
                                 .flush = {copy_tile, 0, 0},
                                 .arena = arena,
                                 .arena_size = sizeof arena,
                                 .keeps_arena = 1};

    choose(chosen, &scene, &object, &material);
    scene.camera.pose = glint_pose_identity();
    scene.camera.field_of_view = BENCH_FIELD_OF_VIEW;
    scene.camera.near_plane = BENCH_NEAR_PLANE;
    return draw_frames(&config, &scene, &object, bench_scenes[which].poses);
}

static int report(uint32_t which, const uint16_t size[2], const choice *chosen) {
    const uint32_t ticks = measure(which, size, chosen);

    board_write(bench_scenes[which].name);
    board_write(",");
    write_number(size[0], "x");
    write_number(size[1], ",rgb565,");
    board_write(chosen->name);
    board_write(",");
    write_number(ticks * COUNTER_INSTRUCTIONS_PER_TICK / BENCH_FRAMES, "\n");
    return ticks == 0;
}

int main(void) {
    int failed = 0;

    counter_start();
    for (uint32_t scene = 0; scene < sizeof bench_scenes / sizeof bench_scenes[0] && !failed; scene++) {
        for (uint32_t size = 0; size < CHOICE_SIZES && !failed; size++) {
            for (uint32_t i = 0; i < CHOICES && !failed; i++) {
                failed = report(scene, choice_sizes[size], &choices[i]);
            }
        }
    }
    return failed;
}
