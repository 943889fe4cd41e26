/* SPDX-License-Identifier: MIT */
/* Firmware that counts the instructions per frame of the same scenes, clear and stored pixels included. */
#include "../bench/counter.h"
#include "glint_extras.h"
#include "shading_scene.h"

#define VERTICES 4608

static int16_t positions[VERTICES][3], normals[VERTICES][3];
static uint16_t triangles[2 * VERTICES][3];
static const glint_mesh_room room = {positions, normals, triangles, VERTICES, 2 * VERTICES};
static uint32_t arena[1 << 17];

static int discard_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context, (void)x, (void)y, (void)width, (void)height, (void)pixels, (void)stride;
    return 0;
}

static int measure(size_t format, const glint_mesh *mesh, size_t which) {
    const glint_config config = {.width = SHADING_WIDTH,
                                 .height = SHADING_HEIGHT,
                                 .format = shading_formats[format].format,
                                 .flush = {discard_tile, 0, 0},
                                 .arena = arena,
                                 .arena_size = sizeof arena};
    glint_renderer renderer;
    shading_scene s;
    shading_build(&s, mesh, shading_evaluations[which].evaluation);
    const uint32_t start = counter_now();
    if (glint_init(&renderer, &config) != GLINT_OK || glint_render(&renderer, &s.scene) != GLINT_OK)
        return 1;
    const uint32_t ticks = counter_ticks_since(start);
    board_write(shading_formats[format].name);
    board_write(",");
    board_write(shading_evaluations[which].name);
    board_write(",");
    write_number(mesh->triangle_count, ",");
    write_number(ticks * COUNTER_INSTRUCTIONS_PER_TICK, "\n");
    return 0;
}

static int measure_sizes(size_t format) {
    for (size_t i = 0; i < SHADING_SIZES; i++) {
        glint_mesh mesh;
        if (glint_generate_torus(&mesh, &room, shading_sizes[i][0], shading_sizes[i][1], GLINT_ONE, GLINT_Q16(0.4)) !=
            GLINT_OK)
            return 1;
        for (size_t j = 0; j < SHADING_EVALUATIONS; j++)
            if (measure(format, &mesh, j))
                return 1;
    }
    return 0;
}

int main(void) {
    int failed = 0;
    counter_start();
    for (size_t format = 0; format < SHADING_FORMATS && !failed; format++)
        failed = measure_sizes(format);
    return failed;
}
