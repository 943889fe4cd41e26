/* SPDX-License-Identifier: MIT */
/*
 * Firmware that counts the instructions of a frame of four scenes with arenas from the least to that of one pass,
 * and with the one that keeps all vertices. Clear and copy to a framebuffer in memory are included. It writes lines of
 *     torus2304,320x240,BYTES,PASSES,INSTRUCTIONS
 */
#include "../../examples/scenes/scenes.h"
#include "../bench/counter.h"
#include "../bench/framebuffer.h"

#include <bench_scenes.h>
#include <spot.h>

enum { WIDTH = 320, HEIGHT = 240, STEPS = 12 };

static uint32_t arena[(1 << 20) / sizeof(uint32_t)];
static uint16_t framebuffer[HEIGHT][WIDTH];

/** Ticks of the frame up to `counted`: read at each tile, as a frame of thousands of passes may outlast the counter. */
static uint64_t ticks;
static uint32_t counted;

static void count(void) {
    ticks += counter_ticks_since(counted);
    counted = counter_now();
}

/** What a line begins with. */
typedef struct heading {
    const char *scene;
    uint16_t width, height;
} heading;

static int copy_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context;
    count();
    framebuffer_copy(&framebuffer[y][x], sizeof framebuffer[0], pixels, stride, 2 * (size_t)width, height);
    return 0;
}

/* @return 0, or 1 after an error */
static int draw(const glint_config *config, const glint_scene *scene, const heading *h) {
    glint_renderer renderer;

    ticks = 0;
    counted = counter_now();
    if (glint_init(&renderer, config) != GLINT_OK || glint_render(&renderer, scene) != GLINT_OK) {
        return 1;
    }
    count();
    board_write(h->scene);
    board_write(",");
    write_number(h->width, "x");
    write_number(h->height, ",");
    write_number((uint32_t)config->arena_size, ",");
    write_number(renderer.stats.passes, ",");
    write_number((uint32_t)(ticks * COUNTER_INSTRUCTIONS_PER_TICK), "\n");
    return 0;
}

/* The steps are closer where arenas are small. */
static int draw_in_arenas(const glint_scene *scene, const heading *h) {
    glint_config config = {.width = h->width,
                           .height = h->height,
                           .format = &glint_format_rgb565,
                           .flush = {copy_tile, 0, 0},
                           .arena = arena};
    glint_need need;
    int failed = glint_arena_need(&config, scene, &need) != GLINT_OK || need.one_pass > sizeof arena;

    for (uint32_t step = 0; step <= STEPS && !failed; step++) {
        config.arena_size = need.least + (need.one_pass - need.least) * step * step / (STEPS * STEPS);
        failed = draw(&config, scene, h);
    }
    config.arena_size = need.resident;
    return failed || draw(&config, scene, h);
}

/* A mesh in the benchmark's material and light, at a pose. */
static int draw_mesh(const glint_mesh *mesh, const glint_pose *pose, const heading *h) {
    const glint_object object = {
        .mesh = mesh, .material = &bench_material, .evaluation = &glint_per_fragment, .pose = *pose};
    const glint_scene scene = {.camera = {glint_pose_identity(), BENCH_FIELD_OF_VIEW, BENCH_NEAR_PLANE},
                               .viewer = GLINT_VIEWER_LOCAL,
                               .ambient = {BENCH_AMBIENT, BENCH_AMBIENT, BENCH_AMBIENT},
                               .lights = &bench_light,
                               .light_count = 1,
                               .objects = &object,
                               .object_count = 1};

    return draw_in_arenas(&scene, h);
}

/* In front of the camera, as near as its largest side allows. */
static int draw_spot(void) {
    const heading h = {"spot", 240, 240};
    const glint_vector extent = spot_mesh.extent, offset = spot_mesh.offset;
    const glint_q16 wide = extent.x > extent.z ? extent.x : extent.z, side = wide > extent.y ? wide : extent.y;
    const glint_pose pose = glint_pose_translate(-offset.x, -offset.y, -offset.z - 4 * side);

    return draw_mesh(&spot_mesh, &pose, &h);
}

static int draw_example(const example_scene *example, uint32_t variant) {
    static example_stage stage;
    const heading h = {example->name, example->width, example->height};

    example->build(&stage, variant, example->frames / 2);
    return draw_in_arenas(&stage.scene, &h);
}

int main(void) {
    const heading torus = {bench_scenes[0].name, WIDTH, HEIGHT};

    counter_start();
    return draw_mesh(bench_scenes[0].mesh, &bench_scenes[0].poses[0], &torus) || draw_spot() ||
           draw_example(&example_teapot, 0) || draw_example(&example_halloween, 0);
}
