/* SPDX-License-Identifier: MIT */
/*
 * Firmware that draws one frame of each benchmark scene, for tools/profile/profile.py, which follows the emulator's
 * trace. A frame lies between two calls of profile_mark; a line names it and what it held:
 *     torus2304,320x240 local,VERTICES,TRIANGLES,CULLED,REFERENCES,PIXELS
 */
#include "../bench/framebuffer.h"
#include "board.h"
#include "text.h"

#include <bench_scenes.h>

#define WIDTH 320
#define HEIGHT 240

/** Which of the ten frames. */
#define FRAME 5

typedef struct variant {
    const char *name;
    uint16_t width, height;
    glint_viewer viewer;
    uint32_t light_count;
    const glint_evaluation *evaluation;
} variant;

static const variant variants[] = {
    {"320x240 local", 320, 240, GLINT_VIEWER_LOCAL, 1, &glint_per_fragment},
    {"320x240 infinite", 320, 240, GLINT_VIEWER_INFINITE, 1, &glint_per_fragment},
    {"128x64 local", 128, 64, GLINT_VIEWER_LOCAL, 1, &glint_per_fragment},
    {"320x240 local 2 lights", 320, 240, GLINT_VIEWER_LOCAL, 2, &glint_per_fragment},
    {"128x64 local 2 lights", 128, 64, GLINT_VIEWER_LOCAL, 2, &glint_per_fragment},
};

static uint32_t arena[(1 << 20) / sizeof(uint32_t)];
static uint16_t framebuffer[HEIGHT][WIDTH];

/* Seen in the trace. */
__attribute__((noinline)) void profile_mark(void);
void profile_mark(void) {
    __asm__ volatile("");
}

static int copy_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context;
    framebuffer_copy(&framebuffer[y][x], sizeof framebuffer[0], pixels, stride, 2 * (size_t)width, height);
    return 0;
}

static uint32_t count_pixels(const variant *v) {
    uint32_t count = 0;
    for (int y = 0; y < v->height; y++) {
        for (int x = 0; x < v->width; x++) {
            count += framebuffer[y][x] != 0;
        }
    }
    return count;
}

static void write_number(uint32_t number, const char *end) {
    char digits[TEXT_NUMBER_SIZE];

    board_write(text_number(digits, number));
    board_write(end);
}

static void report(const char *scene, const variant *v, const glint_stats *stats) {
    board_write(scene);
    board_write(",");
    board_write(v->name);
    board_write(",");
    write_number(stats->vertices, ",");
    write_number(stats->triangles, ",");
    write_number(stats->facing_away + stats->outside, ",");
    write_number(stats->references, ",");
    write_number(count_pixels(v), "\n");
}

static glint_status draw(uint32_t which, const variant *v) {
    glint_light lights[2] = {bench_light, bench_light};
    glint_object object = {.mesh = bench_scenes[which].mesh,
                           .material = &bench_material,
                           .pose = bench_scenes[which].poses[FRAME - 1],
                           .evaluation = v->evaluation};
    glint_scene scene = {.viewer = v->viewer,
                         .ambient = {BENCH_AMBIENT, BENCH_AMBIENT, BENCH_AMBIENT},
                         .lights = lights,
                         .light_count = v->light_count,
                         .objects = &object,
                         .object_count = 1};
    glint_config config = {.width = v->width,
                           .height = v->height,
                           .format = &glint_format_rgb565,
                           .arena = arena,
                           .arena_size = sizeof arena,
                           .keeps_arena = 1};
    glint_renderer renderer;

    lights[1].direction.x = -bench_light.direction.x;
    scene.camera.pose = glint_pose_identity();
    scene.camera.field_of_view = BENCH_FIELD_OF_VIEW;
    scene.camera.near_plane = BENCH_NEAR_PLANE;
    config.flush.begin = copy_tile;
    glint_status status = glint_init(&renderer, &config);
    if (status == GLINT_OK) {
        status = glint_render(&renderer, &scene);
    }
    object.pose = bench_scenes[which].poses[FRAME];
    profile_mark();
    if (status == GLINT_OK) {
        status = glint_render(&renderer, &scene);
    }
    profile_mark();
    if (status == GLINT_OK) {
        report(bench_scenes[which].name, v, &renderer.stats);
    }
    return status;
}

int main(void) {
    for (uint32_t scene = 0; scene < sizeof bench_scenes / sizeof bench_scenes[0]; scene++) {
        for (uint32_t i = 0; i < sizeof variants / sizeof variants[0]; i++) {
            const glint_status status = draw(scene, &variants[i]);
            if (status != GLINT_OK) {
                board_write(glint_strerror(status));
                board_write("\n");
                return 1;
            }
        }
    }
    return 0;
}
