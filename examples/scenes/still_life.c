/* SPDX-License-Identifier: MIT */
/* A crate, a globe, a fence and a leaf on a table of tiles, all of which wear textures; and what is not opaque. */
#include "stage.h"
#include "still_life_data.h"

#include "meshes/cylinder24x1.h"
#include "meshes/flame.h"

enum { FRAMES = 72 };

enum { TURNING, DUSK, FOG, GLASS, GLOW, SMOOTH };

static const example_variant variants[] = {
    {"turning", "Textures multiply the light of each fragment; holes of the fence and of the leaf show what is behind.",
     0, 0},
    {"dusk", "Fog takes the fences one by one, a pane and a lamp are of glass, the flame glows, and edges are smooth.",
     0, 0},
    {"fog", "The far side of the table fades into fog, which has the background's colour.", 0, 0},
    {"glass", "What is behind the pane shows through it, dimmed and tinted; its highlight is as bright as any.", 0, 0},
    {"glow", "The flame lights what is around it, and a disc of light that is added to all makes the air glow.", 0, 0},
    {"smooth", "Edges are smooth: each pixel is the mean of 2 x 2 samples.", 0, 0},
};

/* The length of 32768 steps, of which 32767 are 1. */
#define UNIT GLINT_Q16(32768.0 / 32767)

/* A mesh of a shape, whose texture repeats so many times from left to right, and from top to bottom. */
#define MESH(name, shape, normals_of, mesh_flags, across, down)                    \
    static const glint_mesh name = {.positions = shape##_positions,                \
                                    .normals = (normals_of),                       \
                                    .triangles = shape##_triangles,                \
                                    .vertex_count = COUNT_OF(shape##_positions),   \
                                    .triangle_count = COUNT_OF(shape##_triangles), \
                                    .extent = {UNIT, UNIT, UNIT},                  \
                                    .flags = (mesh_flags),                         \
                                    .texture_coordinates = shape##_coordinates,    \
                                    .texture_extent = {(across)*UNIT, (down)*UNIT}}

MESH(globe_mesh, globe, globe_positions, 0, 1, 1);
MESH(crate_mesh, crate, crate_normals, 0, 1, 1);
MESH(square_mesh, square, square_normals, 0, 1, 1);
MESH(fence_mesh, square, square_normals, GLINT_MESH_DOUBLE_SIDED, 4, 1);
MESH(long_fence_mesh, square, square_normals, GLINT_MESH_DOUBLE_SIDED, 14, 1);
MESH(pane_mesh, square, square_normals, GLINT_MESH_DOUBLE_SIDED, 1, 1);
MESH(floor_mesh, square, square_normals, 0, 5, 5);

/* Paints of white, which the texture multiplies. */
static const glint_material tiles = {&glint_model_blinn_phong, GREY(0.3),     GREY(0.72), GREY(0.12), GLINT_Q16(40),
                                     GLINT_MATERIAL_CLAMP,     &tiles_texture};
static const glint_material flags = {
    &glint_model_blinn_phong, GREY(0.3), GREY(0.72), GREY(0.12), GLINT_Q16(40), 0, &tiles_texture};
static const glint_material wood = {
    &glint_model_blinn_phong, GREY(0.3), GREY(0.8), GREY(0.06), GLINT_Q16(12), 0, &crate_texture};
static const glint_material map = {&glint_model_blinn_phong, GREY(0.3),     GREY(0.78), GREY(0.4), GLINT_Q16(60),
                                   GLINT_MATERIAL_BILINEAR,  &globe_texture};
static const glint_material paint = {
    &glint_model_blinn_phong, GREY(0.3), GREY(0.7), GREY(0.1), GLINT_Q16(20), 0, &fence_texture};
static const glint_material autumn = {&glint_model_blinn_phong, GREY(0.35),   GREY(0.8), GREY(0.1), GLINT_Q16(10),
                                      GLINT_MATERIAL_CLAMP,     &leaf_texture};
static const glint_material glass = {.model = &glint_model_blinn_phong,
                                     .ambient = RGB(0.1, 0.3, 0.3),
                                     .diffuse = RGB(0.1, 0.35, 0.35),
                                     .specular = GREY(1),
                                     .shininess = GLINT_Q16(90),
                                     .blend = GLINT_BLEND_ALPHA,
                                     .opacity = GLINT_Q16(0.45)};
static const glint_material clear = {.model = &glint_model_blinn_phong,
                                     .ambient = GREY(1.3),
                                     .diffuse = GREY(0.25),
                                     .specular = GREY(2),
                                     .shininess = GLINT_Q16(40),
                                     .blend = GLINT_BLEND_ALPHA,
                                     .opacity = GLINT_Q16(0.2)};
static const glint_material frame_wood = {
    &glint_model_blinn_phong, RGB(0.16, 0.1, 0.05), RGB(0.5, 0.31, 0.15), GREY(0.1), GLINT_Q16(20), 0};
static const glint_material wax = {&glint_model_lambert, RGB(0.75, 0.6, 0.35), RGB(0.8, 0.75, 0.6), GREY(0), 0, 0};
static const glint_material fire = {&glint_model_unlit, GREY(0), RGB(1, 0.92, 0.55), GREY(0), 0, 0};
static const glint_material brass = {&glint_model_blinn_phong, RGB(0.1, 0.08, 0.03), RGB(0.45, 0.36, 0.14),
                                     RGB(0.8, 0.7, 0.4),       GLINT_Q16(30),        0};

/* Adds what stands on the table, in a pose of its own there. */
static void put(example_stage *stage, const glint_mesh *mesh, const glint_material *material, const glint_pose *own,
                const glint_pose *table) {
    const glint_pose pose = glint_pose_then(own, table);

    stage_add(stage, mesh, material, &pose);
}

static glint_pose lie(glint_q16 size, glint_q16 turn, glint_vector position) {
    const glint_pose down = glint_pose_rotate_x(GLINT_Q16(-90));
    const glint_pose place = stage_place((glint_vector){size, size, size}, turn, position);

    return glint_pose_then(&down, &place);
}

/* A globe's axis leans by 23.4 degrees. */
static glint_pose spin(glint_q16 turn) {
    const glint_q16 radius = GLINT_Q16(0.62);
    const glint_pose spun = stage_place((glint_vector){radius, radius, radius}, turn, (glint_vector)XYZ(0, 0, 0));
    const glint_pose lean = glint_pose_rotate_z(GLINT_Q16(-23.4));
    const glint_pose move = glint_pose_translate(GLINT_Q16(0.62), radius, GLINT_Q16(0.32));
    const glint_pose leant = glint_pose_then(&spun, &lean);

    return glint_pose_then(&leant, &move);
}

/* A pane in a frame of wood. */
static void put_window(example_stage *stage, const glint_pose *place, const glint_pose *table) {
    static const glint_vector bars[][2] = {
        {XYZ(0.05, 0.72, 0.05), XYZ(-0.55, 0.72, 0)}, {XYZ(0.05, 0.72, 0.05), XYZ(0.55, 0.72, 0)},
        {XYZ(0.5, 0.05, 0.05), XYZ(0, 1.39, 0)},      {XYZ(0.5, 0.05, 0.05), XYZ(0, 0.05, 0)},
        {XYZ(0.5, 0.025, 0.03), XYZ(0, 0.72, 0)},     {XYZ(0.025, 0.62, 0.03), XYZ(0, 0.72, 0)}};
    const glint_pose wide = stage_place((glint_vector)XYZ(0.5, 0.62, 1), 0, (glint_vector)XYZ(0, 0.72, 0));
    const glint_pose pane = glint_pose_then(&wide, place);

    for (uint32_t i = 0; i < COUNT_OF(bars); i++) {
        const glint_pose own = stage_place(bars[i][0], 0, bars[i][1]);
        const glint_pose bar = glint_pose_then(&own, place);

        put(stage, &crate_mesh, &frame_wood, &bar, table);
    }
    put(stage, &pane_mesh, &glass, &pane, table);
}

/* A candle that burns at a place, whose light is added to the air; `glazed` under a chimney of glass. */
static void put_candle(example_stage *stage, glint_vector foot, const glint_pose *table, int glazed) {
    const glint_pose stand = glint_pose_rotate_x(GLINT_Q16(-90));
    const glint_vector flame = {foot.x, foot.y + GLINT_Q16(0.42), foot.z};
    const glint_vector lamp = glint_pose_apply(table, flame);
    const glint_pose thin = glint_pose_scale(GLINT_Q16(0.085), GLINT_Q16(0.085), GLINT_Q16(0.15));
    const glint_pose flat = glint_pose_scale(GLINT_Q16(0.24), GLINT_Q16(0.24), GLINT_Q16(0.025));
    const glint_pose wide = glint_pose_scale(GLINT_Q16(0.2), GLINT_Q16(0.2), GLINT_Q16(0.36));
    const glint_pose lift = glint_pose_translate(foot.x, foot.y + GLINT_Q16(0.17), foot.z);
    const glint_pose low = glint_pose_translate(foot.x, foot.y + GLINT_Q16(0.025), foot.z);
    const glint_pose high = glint_pose_translate(foot.x, foot.y + GLINT_Q16(0.4), foot.z);
    const glint_pose burning =
        stage_place((glint_vector)XYZ(0.35, 0.35, 0.35), 0, (glint_vector){foot.x, foot.y + GLINT_Q16(0.32), foot.z});
    glint_pose stick = glint_pose_then(&thin, &stand), plate = glint_pose_then(&flat, &stand),
               chimney = glint_pose_then(&wide, &stand);
    glint_light *light = stage_lamp(stage, &glint_light_point, lamp, (glint_colour)RGB(2.4, 1.5, 0.6));

    light->quadratic = GLINT_Q16(0.7);
    stick = glint_pose_then(&stick, &lift);
    plate = glint_pose_then(&plate, &low);
    chimney = glint_pose_then(&chimney, &high);
    put(stage, &flame_mesh, &fire, &burning, table);
    put(stage, &cylinder24x1_mesh, &wax, &stick, table);
    put(stage, &cylinder24x1_mesh, &brass, &plate, table);
    if (glazed) {
        put(stage, &cylinder24x1_mesh, &clear, &chimney, table);
    }
    stage_glow(stage, lamp, GLINT_Q16(1.5), (glint_colour)RGB(0.9, 0.55, 0.2))->order = 1;
}

static void put_things(example_stage *stage, glint_q16 step, const glint_pose *table) {
    const glint_pose crate =
        stage_place((glint_vector)XYZ(0.62, 0.62, 0.62), GLINT_Q16(24), (glint_vector)XYZ(-0.62, 0.62, -0.3));
    const glint_pose upright = stage_place((glint_vector)XYZ(1.7, 0.4, 1), 0, (glint_vector)XYZ(0.2, 0.4, -1.6));
    const glint_pose fallen = lie(GLINT_Q16(0.36), GLINT_Q16(35), (glint_vector)XYZ(-0.55, 0.015, 1.15));
    const glint_pose globe = spin(GLINT_Q16(200) + 2 * step);

    put(stage, &fence_mesh, &paint, &upright, table);
    put(stage, &crate_mesh, &wood, &crate, table);
    put(stage, &globe_mesh, &map, &globe, table);
    put(stage, &square_mesh, &autumn, &fallen, table);
}

/* A table that turns. */
static void build_table(example_stage *stage, uint32_t variant, glint_q16 step) {
    const glint_vector from_upper_left = XYZ(0.6, -0.8, -0.8), from_right = XYZ(-0.9, -0.35, -0.3);
    const glint_colour night = RGB(0.07, 0.09, 0.13), haze = RGB(0.3, 0.34, 0.4);
    const glint_q16 day = variant == GLOW ? GLINT_Q16(0.3) : GLINT_ONE;
    const glint_pose table = glint_pose_rotate_y(step);
    const glint_pose flat = lie(GLINT_Q16(2), 0, (glint_vector)XYZ(0, 0, 0));
    const glint_pose window = stage_place((glint_vector)XYZ(1, 1, 1), GLINT_Q16(-20), (glint_vector)XYZ(0.85, 0, 1.15));

    stage_clear(stage, variant == FOG ? haze : night);
    stage_look(stage, (glint_vector)XYZ(0, 3, 5.7), (glint_vector)XYZ(0, 0.32, 0), GLINT_Q16(36.5));
    stage_sun(stage, from_upper_left, stage_times((glint_colour)RGB(1, 0.96, 0.88), day));
    stage_sun(stage, from_right, stage_times((glint_colour)RGB(0.16, 0.2, 0.28), day));
    put(stage, &square_mesh, &tiles, &flat, &table);
    put_things(stage, step, &table);
    if (variant == FOG) {
        stage_fog(stage, &glint_fog_linear, GLINT_Q16(4.8), GLINT_Q16(8.2), haze);
    } else if (variant == GLASS) {
        put_window(stage, &window, &table);
    } else if (variant == GLOW) {
        stage->scene.ambient = (glint_colour)RGB(0.35, 0.4, 0.55);
        put_candle(stage, (glint_vector)XYZ(-0.62, 1.24, -0.3), &table, 0);
    } else if (variant == SMOOTH) {
        stage->samples = &glint_samples_2x2;
    }
    stage->layers = variant == GLASS || variant == GLOW ? &glint_layers : 0;
}

/* The same things at dusk, on a terrace that leads into fog; the camera sways. */
static void build_dusk(example_stage *stage, glint_q16 step) {
    const glint_colour haze = RGB(0.2, 0.24, 0.33);
    const glint_q16 angle = stage_multiply(GLINT_Q16(16), glint_sin(step));
    const glint_pose table = glint_pose_rotate_y(angle);
    const glint_pose terrace = lie(GLINT_Q16(10), 0, (glint_vector)XYZ(0, 0, -4));
    const glint_pose window = stage_place((glint_vector)XYZ(1, 1, 1), GLINT_Q16(-24), (glint_vector)XYZ(1.35, 0, 1));

    stage_clear(stage, haze);
    stage_look(stage, (glint_vector)XYZ(0, 1.9, 6), (glint_vector)XYZ(0, 0.8, 0), GLINT_Q16(36.5));
    stage->scene.ambient = (glint_colour)RGB(0.45, 0.5, 0.65);
    stage_sun(stage, (glint_vector)XYZ(0.6, -0.8, -0.8), (glint_colour)RGB(0.45, 0.5, 0.65));
    put(stage, &floor_mesh, &flags, &terrace, &table);
    for (int i = 0; i < 4; i++) {
        const glint_pose row = stage_place((glint_vector)XYZ(5, 0.4, 1), 0,
                                           (glint_vector){0, GLINT_Q16(0.4), -GLINT_Q16(3.4) - i * GLINT_Q16(2)});

        put(stage, &long_fence_mesh, &paint, &row, &table);
    }
    put_things(stage, step, &table);
    put_window(stage, &window, &table);
    put_candle(stage, (glint_vector)XYZ(-0.62, 1.24, -0.3), &table, 1);
    stage_fog(stage, &glint_fog_linear, GLINT_Q16(5), GLINT_Q16(15), haze);
    stage->layers = &glint_layers;
    stage->samples = &glint_samples_2x2;
}

static void build(example_stage *stage, uint32_t variant, uint32_t frame) {
    const glint_q16 step = (glint_q16)frame * (GLINT_Q16(360) / FRAMES);

    if (variant == DUSK) {
        build_dusk(stage, step);
    } else {
        build_table(stage, variant, step);
    }
}

const example_scene example_still_life = {
    .name = "still-life",
    .summary = "A crate, a globe, a fence and a leaf that wear textures.",
    .variants = variants,
    .variant_count = COUNT_OF(variants),
    .frames = FRAMES,
    .width = 320,
    .height = 240,
    .build = build,
};
