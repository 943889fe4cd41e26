/* SPDX-License-Identifier: MIT */
#include "board.h"
#include "panel/ssd0323.h"

#define GREY(level) GLINT_COLOUR(level, level, level)

static const int16_t points[4][3] = {{0, 32767, 0}, {-32767, -16384, 0}, {32767, -16384, 0}, {0, 0, 32767}};
static const uint16_t sides[4][3] = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}}; /* counter-clockwise from outside */
static const glint_mesh pyramid = {points, points /* as normals */, sides, 4, 4, {0, 0, 0}, GREY(1), 0};
static const glint_material clay = {&glint_model_blinn_phong, GREY(0.1), GREY(0.6), GREY(0.4), GLINT_Q16(32)};
static const glint_light sun = {&glint_light_directional, {0}, GLINT_VECTOR(1, -1, -1), GREY(1), GREY(1)};
static uint32_t arena[3072];

int main(void) {
    const glint_panel panel = {&glint_panel_ssd0323, board_panel_bus()};
    const glint_flush flush = glint_panel_flush(&panel);
    const glint_config config = {128, 64, 0, 0, panel.type->format, flush, arena, sizeof arena};
    const glint_camera camera = {glint_pose_translate(0, 0, GLINT_Q16(4)), GLINT_Q16(40), GLINT_Q16(0.1)};
    glint_object object = {&pyramid, &clay, glint_pose_identity(), &glint_per_fragment};
    const glint_scene scene = {
        .camera = camera, .ambient = GREY(1), .lights = &sun, .light_count = 1, .objects = &object, .object_count = 1};
    glint_renderer renderer;
    int failed = glint_panel_start(&panel) || glint_init(&renderer, &config);
    for (int turn = 0; turn < 360 && !failed; turn += 5) { /* one turn, 5 degrees a frame */
        object.pose = glint_pose_rotate_y(turn * GLINT_ONE);
        failed = glint_render(&renderer, &scene);
    }
    return failed;
}
