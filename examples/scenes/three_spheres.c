/* SPDX-License-Identifier: MIT */
/* Three spheres of one paint under a dim and a bright light: no highlight, then Phong's with exponents 4 and 16. */
#include "stage.h"

#include "meshes/sphere12x8.h"
#include "meshes/sphere32x16.h"
#include "meshes/sphere48x32.h"

enum { PHONG, BLINN_PHONG, VERTEX, VERTEX_DENSE, GREENISH };

static const example_label labels[] = {
    {"no highlight", 56, 148, 0, 0}, {"exponent 4", 160, 148, 0, 0}, {"exponent 16", 264, 148, 0, 0}};

#define LABELS labels, COUNT_OF(labels)

static const example_variant variants[] = {
    {"phong",
     "The lobe of exponent 4, in the middle, is wide and soft, that of 16, on the right, is small and sharp. The edge "
     "at the middle sphere's left is where the rear light sets, N.L = 0.",
     LABELS},
    {"blinn-phong", "At the same exponents the half vector's lobes are 1.7 and 1.8 times as wide as those of phong.",
     LABELS},
    {"vertex", "Lit at the vertices of 168 triangles, the highlights show the mesh, and the right one is nearly lost.",
     LABELS},
    {"vertex-dense", "Lit at the vertices of 2976 triangles, they are as good as per fragment with 960.", LABELS},
    {"greenish", "A tinted ambient colour, (0.1, 0.3, 0.1): where no light falls the spheres are green.", LABELS},
};

static const glint_mesh *mesh_of(uint32_t variant) {
    return variant == VERTEX ? &sphere12x8_mesh : variant == VERTEX_DENSE ? &sphere48x32_mesh : &sphere32x16_mesh;
}

static void build(example_stage *stage, uint32_t variant, uint32_t frame) {
    const glint_vector from_rear_left = XYZ(1, 0, 0.5), from_front_upper_right = XYZ(-1, -1, -0.5);
    const glint_vector eye = XYZ(0, 0, 16), at = XYZ(0, 0, 0);
    const glint_shading_model *shiny = variant == BLINN_PHONG ? &glint_model_blinn_phong : &glint_model_phong;
    /* Ambient light of 0.2, tinted with the paint. */
    glint_material material = {&glint_model_lambert, RGB(0.17, 0.07, 0.05), RGB(0.6, 0.23, 0.15), GREY(0.4), 0, 0};

    (void)frame;
    if (variant == GREENISH) {
        material.ambient = (glint_colour)RGB(0.1, 0.3, 0.1);
        material.diffuse = (glint_colour)RGB(0.3, 0.5, 0.3);
    }
    stage_clear(stage, (glint_colour)RGB(0, 0, 0));
    stage_look(stage, eye, at, GLINT_Q16(12));
    stage_sun(stage, from_rear_left, (glint_colour)RGB(0.3, 0.4, 0.6));
    stage_sun(stage, from_front_upper_right, (glint_colour)GREY(1));
    for (int i = 0; i < 3; i++) {
        /* turned, so that no vertex lies right where a light begins */
        const glint_pose turn = glint_pose_rotate_z(variant == VERTEX ? GLINT_Q16(7) : 0);
        const glint_pose move = glint_pose_translate((i - 1) * GLINT_Q16(2.2), 0, 0);
        const glint_pose pose = glint_pose_then(&turn, &move);

        stage_add(stage, mesh_of(variant), &material, &pose)->evaluation =
            variant == VERTEX || variant == VERTEX_DENSE ? &glint_per_vertex : &glint_per_fragment;
        material.model = shiny;
        material.shininess = i == 0 ? GLINT_Q16(4) : GLINT_Q16(16);
    }
}

const example_scene example_three_spheres = {
    .name = "three-spheres",
    .summary = "Phong's highlight: none, exponent 4, exponent 16, under a dim and a bright light.",
    .variants = variants,
    .variant_count = COUNT_OF(variants),
    .frames = 1,
    .width = 320,
    .height = 160,
    .build = build,
};
