/* SPDX-License-Identifier: MIT */
/*
 * Firmware that counts the instructions of a frame, drawn in every way, of each benchmark scene, the mean of ten, of
 * each example scene, its middle one, and of a plane. Clear and copy to a framebuffer in memory are included. It
 * writes lines of
 *     torus2304,,320x240,undropped,INSTRUCTIONS
 */
#include "../../examples/scenes/scenes.h"
#include "../bench/counter.h"
#include "../bench/framebuffer.h"
#include "board.h"
#include "choices.h"
#include "plane.h"
#include "text.h"
#include "ways.h"

#include <bench_scenes.h>

enum { WIDTH = 320, HEIGHT = 240 };

static uint32_t arena[(1 << 20) / sizeof(uint32_t)];
static uint16_t framebuffer[HEIGHT][WIDTH];

/** What a line begins with. */
typedef struct heading {
    const char *scene, *variant;
    uint16_t width, height;
} heading;

static int copy_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context;
    framebuffer_copy(&framebuffer[y][x], sizeof framebuffer[0], pixels, stride, 2 * (size_t)width, height);
    return 0;
}

/* @return ticks that a frame takes from glint_init on; 0 after an error */
static uint32_t draw(const way *chosen, const glint_scene *scene, const heading *h) {
    static undropped_scene room;
    const glint_scene *made = scene_in_way(chosen, scene, &room);
    const glint_config config = {.width = h->width,
                                 .height = h->height,
                                 .format = format_in_way(chosen),
                                 .flush = {copy_tile, 0, 0},
                                 .arena = arena,
                                 .arena_size = sizeof arena};
    glint_renderer renderer;
    const uint32_t start = counter_now();
    if (!made || glint_init(&renderer, &config) != GLINT_OK || glint_render(&renderer, made) != GLINT_OK) {
        return 0;
    }
    return counter_ticks_since(start);
}

static void write_number(uint32_t number, const char *end) {
    char digits[TEXT_NUMBER_SIZE];

    board_write(text_number(digits, number));
    board_write(end);
}

static void report(const heading *h, const way *chosen, uint32_t instructions) {
    board_write(h->scene);
    board_write(",");
    board_write(h->variant);
    board_write(",");
    write_number(h->width, "x");
    write_number(h->height, ",");
    board_write(chosen->name);
    board_write(",");
    write_number(instructions, "\n");
}

static int bench_scene_in_ways(uint32_t which, const uint16_t size[2]) {
    const heading h = {bench_scenes[which].name, "", size[0], size[1]};
    glint_object object = {.mesh = bench_scenes[which].mesh, .material = &bench_material};
    glint_scene scene = {.camera = {glint_pose_identity(), BENCH_FIELD_OF_VIEW, BENCH_NEAR_PLANE},
                         .viewer = GLINT_VIEWER_LOCAL,
                         .ambient = {BENCH_AMBIENT, BENCH_AMBIENT, BENCH_AMBIENT},
                         .lights = &bench_light,
                         .light_count = 1,
                         .objects = &object,
                         .object_count = 1};
    for (uint32_t i = 0; i < WAYS; i++) {
        uint32_t sum = 0;
        for (int frame = 0; frame < BENCH_FRAMES; frame++) {
            object.pose = bench_scenes[which].poses[frame];
            const uint32_t ticks = draw(&ways[i], &scene, &h);
            if (!ticks) {
                return 1;
            }
            sum += ticks;
        }
        report(&h, &ways[i], sum * COUNTER_INSTRUCTIONS_PER_TICK / BENCH_FRAMES);
    }
    return 0;
}

static int one_frame_in_ways(const glint_scene *scene, const heading *h) {
    for (uint32_t i = 0; i < WAYS; i++) {
        const uint32_t ticks = draw(&ways[i], scene, h);
        if (!ticks) {
            return 1;
        }
        report(h, &ways[i], ticks * COUNTER_INSTRUCTIONS_PER_TICK);
    }
    return 0;
}

static int example_in_ways(const example_scene *scene, uint32_t variant) {
    static example_stage stage;
    const heading h = {scene->name, scene->variants[variant].name, scene->width, scene->height};
    scene->build(&stage, variant, frame_in_middle(scene->frames));
    light_at_fragments(stage.objects, stage.scene.object_count);
    return one_frame_in_ways(&stage.scene, &h);
}

static int plane_in_ways(const plane_light *light) {
    static plane_stage stage;
    const heading h = {"plane", light->name, PLANE_WIDTH, PLANE_HEIGHT};
    return plane_build(&stage, light) != GLINT_OK || one_frame_in_ways(&stage.scene, &h);
}

int main(void) {
    int failed = 0;

    counter_start();
    for (uint32_t scene = 0; scene < sizeof bench_scenes / sizeof bench_scenes[0]; scene++) {
        for (uint32_t size = 0; size < CHOICE_SIZES && !failed; size++) {
            failed = bench_scene_in_ways(scene, choice_sizes[size]);
        }
    }
    for (uint32_t i = 0; i < EXAMPLE_SCENES; i++) {
        for (uint32_t variant = 0; variant < example_scenes[i]->variant_count && !failed; variant++) {
            failed = example_in_ways(example_scenes[i], variant);
        }
    }
    for (uint32_t i = 0; i < PLANE_LIGHTS && !failed; i++) {
        failed = plane_in_ways(&plane_lights[i]);
    }
    return failed;
}
