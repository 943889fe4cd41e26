/* SPDX-License-Identifier: MIT */
/**
 * @file shading_scene.h
 * A torus of more or fewer triangles, for the chart of what evaluation per vertex and per fragment give: built alike on
 * the host, which measures errors, and on the board, which counts instructions.
 */
#ifndef SHADING_SCENE_H
#define SHADING_SCENE_H

#include "glint.h"

#define SHADING_WIDTH 320
#define SHADING_HEIGHT 240

/** Quads around and along the tube, coarse to fine. */
static const uint16_t shading_sizes[][2] = {{12, 6}, {16, 8}, {24, 12}, {32, 16}, {48, 24}, {64, 32}, {96, 48}};
#define SHADING_SIZES (sizeof shading_sizes / sizeof *shading_sizes)

/** What stands in for the true surface. */
#define SHADING_TRUE_AROUND 320
#define SHADING_TRUE_ALONG 160

static const struct {
    const char *name;
    const glint_evaluation *evaluation;
} shading_evaluations[] = {
    {"facet", &glint_per_facet}, {"vertex", &glint_per_vertex}, {"fragment", &glint_per_fragment}};
#define SHADING_EVALUATIONS (sizeof shading_evaluations / sizeof *shading_evaluations)

/** With and without fast lighting. */
static const struct {
    const char *name;
    const glint_format *format;
} shading_formats[] = {{"rgb565", &glint_format_rgb565}, {"rgb888", &glint_format_rgb888}};
#define SHADING_FORMATS (sizeof shading_formats / sizeof *shading_formats)

typedef struct shading_scene {
    glint_material material;
    glint_light light;
    glint_object object;
    glint_scene scene;
} shading_scene;

/** Fills `s`, which is not to be moved while it is drawn. */
static void shading_build(shading_scene *s, const glint_mesh *mesh, const glint_evaluation *evaluation) {
    const glint_colour paint = {GLINT_Q16(0.2), GLINT_Q16(0.5), GLINT_Q16(0.8)};
    const glint_colour white = {GLINT_ONE, GLINT_ONE, GLINT_ONE};
    const glint_pose turn = glint_pose_rotate_x(GLINT_Q16(-50)), back = glint_pose_translate(0, 0, GLINT_Q16(-3.2));
    s->material = glint_material_paint(&glint_model_blinn_phong, paint, GLINT_Q16(0.2), GLINT_Q16(50));
    s->material.specular = (glint_colour){GLINT_Q16(0.5), GLINT_Q16(0.5), GLINT_Q16(0.5)};
    s->light = (glint_light){.type = &glint_light_directional,
                             .direction = {GLINT_Q16(-0.4), GLINT_Q16(-0.6), GLINT_Q16(-0.7)},
                             .diffuse = white,
                             .specular = white};
    s->object = (glint_object){.mesh = mesh, .material = &s->material, .evaluation = evaluation};
    s->object.pose = glint_pose_then(&turn, &back);
    s->scene = (glint_scene){.viewer = GLINT_VIEWER_LOCAL,
                             .ambient = white,
                             .lights = &s->light,
                             .light_count = 1,
                             .objects = &s->object,
                             .object_count = 1};
    s->scene.camera = (glint_camera){glint_pose_identity(), GLINT_Q16(50), GLINT_Q16(0.1)};
}

#endif
