/* SPDX-License-Identifier: MIT */
/* Teapot and torus under one directional light, lit per vertex or per fragment, with different exponents. */
#include "stage.h"

#include "meshes/teapot.h"
#include "meshes/torus12x8.h"
#include "meshes/torus48x24.h"
#include "meshes/torus576.h"

#define FRAMES 36

static const example_variant variants[] = {
    {"fragment",
     "Exponent 100 per fragment: small highlights without a trace of the mesh, on the torus streaks 3.8 and 5.5 times "
     "as long as wide.",
     0, 0},
    {"vertex", "Exponent 100 per vertex: the torus, of 576 triangles, shows its mesh in its highlights.", 0, 0},
    {"vertex-coarse", "A torus of 192 triangles loses its highlights between its vertices.", 0, 0},
    {"vertex-dense",
     "One of 2304 triangles has them, 4.7 levels (root mean square) from 576 triangles per fragment; 576 per vertex "
     "are 9.1 away.",
     0, 0},
    {"flood", "No shininess term, that is exponent 1: the highlight floods all that the light reaches.", 0, 0},
    {"flood-wide", "Exponent 0.25: below 1 the lobe is wider still, and ends at a sharp edge where N.L is 0.", 0, 0},
};

static const struct {
    const glint_mesh *torus;
    const glint_evaluation *evaluation;
    glint_q16 shininess;
} options[COUNT_OF(variants)] = {
    {&torus576_mesh, &glint_per_fragment, GLINT_Q16(100)}, {&torus576_mesh, &glint_per_vertex, GLINT_Q16(100)},
    {&torus12x8_mesh, &glint_per_vertex, GLINT_Q16(100)},  {&torus48x24_mesh, &glint_per_vertex, GLINT_Q16(100)},
    {&torus576_mesh, &glint_per_fragment, GLINT_ONE},      {&torus576_mesh, &glint_per_fragment, GLINT_Q16(0.25)},
};

static void build(example_stage *stage, uint32_t variant, uint32_t frame) {
    const glint_vector light = XYZ(0.45, -0.8, -0.75), eye = XYZ(0, 3.2, 8.5), at = XYZ(0, -0.05, 0);
    /* The larger of ambient and the rest: its shadows are all one colour. */
    const glint_material plastic = {&glint_model_blinn_phong,   RGB(0.11, 0.15, 0.22),
                                    RGB(0.34, 0.46, 0.66),      GREY(0.7),
                                    options[variant].shininess, GLINT_MATERIAL_MAX_WITH_AMBIENT};
    glint_material gold = plastic;
    const glint_evaluation *evaluation = options[variant].evaluation;
    const glint_q16 turn = (glint_q16)(frame % FRAMES) * (360 / FRAMES) * GLINT_ONE;
    const glint_pose pot = stage_place((glint_vector)XYZ(1.1, 1.1, 1.1), turn, (glint_vector)XYZ(-1.05, 0, 0));
    const glint_pose tilt = glint_pose_rotate_x(GLINT_Q16(-60));
    const glint_pose ring_place = stage_place((glint_vector)XYZ(0.62, 0.62, 0.62), turn, (glint_vector)XYZ(1.12, 0, 0));
    const glint_pose ring = glint_pose_then(&tilt, &ring_place);

    gold.ambient = (glint_colour)RGB(0.2, 0.13, 0.05);
    gold.diffuse = (glint_colour)RGB(0.56, 0.37, 0.14);
    gold.specular = (glint_colour)RGB(0.9, 0.6, 0.22); /* a metal's highlight has the metal's own hue */
    stage_clear(stage, (glint_colour)RGB(0, 0, 0));
    stage_look(stage, eye, at, GLINT_Q16(14));
    stage_sun(stage, light, (glint_colour)GREY(1));
    stage_add(stage, &teapot_mesh, &plastic, &pot)->evaluation = evaluation;
    stage_add(stage, options[variant].torus, &gold, &ring)->evaluation = evaluation;
}

const example_scene example_teapot = {
    .name = "teapot",
    .summary = "A plastic teapot and a golden torus, lit per vertex or per fragment, with exponents of 0.25 to 100.",
    .variants = variants,
    .variant_count = COUNT_OF(variants),
    .frames = FRAMES,
    .width = 320,
    .height = 160,
    .build = build,
};
