/* SPDX-License-Identifier: MIT */
/* Teapot and torus under one directional light, lit per vertex or per fragment, with and without an exponent. */
#include "stage.h"

#include "meshes/teapot.h"
#include "meshes/torus576.h"

#define FRAMES 36

static const example_variant variants[] = {
    {"fragment", "Exponent 100 per fragment: small round highlights, and no trace of the mesh."},
    {"vertex", "Exponent 100 per vertex: the torus shows its mesh in its highlight."},
    {"fragment-flood", "Exponent 1, as without the shininess term: the highlight floods all that the light reaches."},
    {"vertex-flood", "Exponent 1 per vertex: so wide a highlight hardly needs fragments."},
};

static void build(example_stage *stage, uint32_t variant, uint32_t frame) {
    const glint_vector light = XYZ(-0.45, 0.8, 0.75), eye = XYZ(0, 3.2, 8.5), at = XYZ(0, -0.05, 0);
    /* The larger of ambient and the rest: its shadows are all one colour. */
    const glint_material china = {&glint_model_blinn_phong,
                                  RGB(0.11, 0.15, 0.22),
                                  RGB(0.34, 0.46, 0.66),
                                  GREY(0.7),
                                  variant < 2 ? GLINT_Q16(100) : GLINT_ONE,
                                  GLINT_MATERIAL_MAX};
    glint_material brass = china;
    const glint_evaluation *evaluation = variant % 2 == 1 ? &glint_per_vertex : &glint_per_fragment;
    const glint_q16 turn = (glint_q16)(frame % FRAMES) * (360 / FRAMES) * GLINT_ONE;
    const glint_pose pot = stage_place((glint_vector)XYZ(1.1, 1.1, 1.1), turn, (glint_vector)XYZ(-1.05, 0, 0));
    const glint_pose tilt = glint_pose_rotate_x(GLINT_Q16(-60));
    const glint_pose ring_place = stage_place((glint_vector)XYZ(0.62, 0.62, 0.62), turn, (glint_vector)XYZ(1.12, 0, 0));
    const glint_pose ring = glint_pose_then(&tilt, &ring_place);

    brass.ambient = (glint_colour)RGB(0.2, 0.13, 0.05);
    brass.diffuse = (glint_colour)RGB(0.56, 0.37, 0.14);
    stage_clear(stage, (glint_colour)RGB(0, 0, 0));
    stage_look(stage, eye, at, GLINT_Q16(14));
    stage_light(stage, &glint_light_directional, light, (glint_colour)GREY(1));
    stage_add(stage, &teapot_mesh, &china, &pot)->evaluation = evaluation;
    stage_add(stage, &torus576_mesh, &brass, &ring)->evaluation = evaluation;
}

const example_scene example_teapot = {
    .name = "teapot",
    .summary = "Teapot and torus, lit per vertex or per fragment, with exponent 1 or 100.",
    .variants = variants,
    .variant_count = COUNT_OF(variants),
    .frames = FRAMES,
    .width = 320,
    .height = 160,
    .build = build,
};
