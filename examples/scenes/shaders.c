/* SPDX-License-Identifier: MIT */
/* One shape under four shaders, few polygons above and many below. */
#include "stage.h"

#include "meshes/cylinder10x2.h"
#include "meshes/cylinder48x16.h"
#include "meshes/sphere10x6.h"
#include "meshes/sphere48x32.h"
#include "meshes/torus12x8.h"
#include "meshes/torus48x24.h"

#define LOOK "From the left Phong and Blinn-Phong per vertex, Blinn-Phong and Lambert per fragment: "

/* What the columns are, between the rows; what the rows are, above and below. */
/* clang-format off */
#define COLUMNS \
    {"Phong\nper vertex", 38, 90, 0, 0}, \
    {"Blinn-Phong\nper vertex", 119, 90, 0, 0}, \
    {"Blinn-Phong\nper fragment", 201, 90, 0, 0}, \
    {"Lambert\nper fragment", 282, 90, 0, 0}
/* clang-format on */

static const example_label torus_labels[] = {
    COLUMNS, {"192 triangles each", 160, 5, 0, 0}, {"2304 triangles each", 160, 175, 0, 0}};
static const example_label cylinder_labels[] = {
    COLUMNS, {"60 triangles each", 160, 5, 0, 0}, {"1632 triangles each", 160, 175, 0, 0}};
static const example_label sphere_labels[] = {
    COLUMNS, {"100 triangles each", 160, 5, 0, 0}, {"2976 triangles each", 160, 175, 0, 0}};

static const example_variant variants[] = {
    {"torus-50",
     LOOK "above, of 192 triangles, only the third has its highlight; below, of 2304, all have it but Lambert, whose "
          "model has none.",
     torus_labels, COUNT_OF(torus_labels)},
    {"torus-100", LOOK "the smaller the highlight, the more of it is lost between vertices.", torus_labels,
     COUNT_OF(torus_labels)},
    {"cylinder-50", LOOK "above, the vertices smear the highlight into a broad band; the third is as narrow as below.",
     cylinder_labels, COUNT_OF(cylinder_labels)},
    {"cylinder-100",
     LOOK "above, the bands per vertex stay as broad as at 50; Phong's pales from 125 levels to 103, Blinn-Phong's "
          "hardly, from 138 to 137.",
     cylinder_labels, COUNT_OF(cylinder_labels)},
    {"sphere-50", LOOK "above, of 100 triangles, the third is as round as below, but for its outline.", sphere_labels,
     COUNT_OF(sphere_labels)},
    {"sphere-100", LOOK "the third highlight is as good above, of 100 triangles, as below, of 2976.", sphere_labels,
     COUNT_OF(sphere_labels)},
};

/* Three shapes, coarse and fine. */
static const glint_mesh *const meshes[3][2] = {{&torus12x8_mesh, &torus48x24_mesh},
                                               {&cylinder10x2_mesh, &cylinder48x16_mesh},
                                               {&sphere10x6_mesh, &sphere48x32_mesh}};

static const struct {
    const glint_shading_model *model;
    const glint_evaluation *evaluation;
} shaders[] = {
    {&glint_model_phong, &glint_per_vertex},
    {&glint_model_blinn_phong, &glint_per_vertex},
    {&glint_model_blinn_phong, &glint_per_fragment},
    {&glint_model_lambert, &glint_per_fragment},
};

/* Scale, turns about x and z, and a direction of light that put a highlight where the shape can show it. */
static const struct {
    glint_q16 scale, tilt, lean;
    glint_vector light;
} views[3] = {
    {GLINT_Q16(0.74), GLINT_Q16(-35), GLINT_Q16(20), XYZ(0.5, -0.6, -0.8)},
    {GLINT_Q16(0.77), GLINT_Q16(-73), GLINT_Q16(-48), XYZ(0.75, -0.08, -0.65)},
    {GLINT_Q16(1.05), GLINT_Q16(-70), 0, XYZ(0.5, -0.6, -0.8)},
};

static glint_pose place(uint32_t shape, glint_q16 x, glint_q16 y) {
    const glint_q16 scale = views[shape].scale;
    const glint_pose size = glint_pose_scale(scale, scale, scale);
    const glint_pose tilt = glint_pose_rotate_x(views[shape].tilt);
    const glint_pose lean = glint_pose_rotate_z(views[shape].lean);
    const glint_pose move = glint_pose_translate(x, y, 0);
    glint_pose pose = glint_pose_then(&size, &tilt);

    pose = glint_pose_then(&pose, &lean);
    return glint_pose_then(&pose, &move);
}

static void build(example_stage *stage, uint32_t variant, uint32_t frame) {
    const glint_vector eye = XYZ(0, 0, 40), at = XYZ(0, 0, 0);
    const glint_colour paint = RGB(0.2, 0.45, 0.85), light = GREY(0.8);
    const glint_q16 shininess = variant % 2 == 0 ? GLINT_Q16(50) : GLINT_Q16(100);
    const uint32_t shape = variant / 2;

    (void)frame;
    stage_clear(stage, (glint_colour)GREY(0));
    stage_look(stage, eye, at, GLINT_Q16(7.9));
    stage->scene.ambient = light;
    stage_sun(stage, views[shape].light, light);
    for (uint32_t row = 0; row < 2; row++) {
        for (uint32_t i = 0; i < COUNT_OF(shaders); i++) {
            const glint_material material = glint_material_paint(shaders[i].model, paint, GLINT_Q16(0.2), shininess);
            const glint_pose pose =
                place(shape, ((glint_q16)i * 2 - 3) * GLINT_Q16(1.25), row == 0 ? GLINT_Q16(1.38) : GLINT_Q16(-1.38));

            stage_add(stage, meshes[shape][row], &material, &pose)->evaluation = shaders[i].evaluation;
        }
    }
}

const example_scene example_shaders = {
    .name = "shaders",
    .summary = "Torus, cylinder and sphere, coarse and fine, under four shaders, with exponents 50 and 100.",
    .variants = variants,
    .variant_count = COUNT_OF(variants),
    .frames = 1,
    .width = 320,
    .height = 180,
    .build = build,
};
