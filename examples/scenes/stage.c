/* SPDX-License-Identifier: MIT */
#include "stage.h"

#include "meshes/glow.h"

void stage_clear(example_stage *stage, glint_colour background) {
    const glint_scene scene = {{glint_pose_identity(), GLINT_Q16(30), GLINT_Q16(0.1)},
                               GLINT_VIEWER_LOCAL,
                               background,
                               GREY(1),
                               stage->lights,
                               0,
                               stage->objects,
                               0};

    stage->scene = scene;
    stage->layers = 0;
    stage->samples = 0;
}

void stage_look(example_stage *stage, glint_vector eye, glint_vector at, glint_q16 field_of_view) {
    const glint_vector up = XYZ(0, 1, 0);

    stage->scene.camera.field_of_view = field_of_view;
    (void)glint_camera_look_at(&stage->scene.camera, eye, at, up); /* fails for no scene: none looks straight down */
}

static glint_light *add_light(example_stage *stage, glint_light light) {
    glint_light *added = &stage->lights[stage->scene.light_count++];

    *added = light;
    return added;
}

glint_light *stage_sun(example_stage *stage, glint_vector direction, glint_colour colour) {
    return add_light(stage, glint_sun(direction, colour));
}

glint_light *stage_lamp(example_stage *stage, const glint_light_type *type, glint_vector position,
                        glint_colour colour) {
    const glint_light light = {.type = type, .position = position, .diffuse = colour, .specular = colour};

    return add_light(stage, light);
}

glint_object *stage_add(example_stage *stage, const glint_mesh *mesh, const glint_material *material,
                        const glint_pose *pose) {
    glint_material *copy = &stage->materials[stage->scene.object_count];
    const glint_object object = {mesh, copy, *pose, &glint_per_fragment};
    glint_object *added = &stage->objects[stage->scene.object_count++];

    *copy = *material;
    *added = object;
    return added;
}

glint_object *stage_again(example_stage *stage, const glint_mesh *mesh, const glint_pose *pose) {
    const glint_object *before = &stage->objects[stage->scene.object_count - 1];
    const glint_object object = {mesh, before->material, *pose, before->evaluation};
    glint_object *added = &stage->objects[stage->scene.object_count++];

    *added = object;
    return added;
}

/* From the middle of a glow to its rim, about 255 e^(-5 r) at rings of 24 vertices. Formatted by hand, a ring a line.
 */
/* clang-format off */
#define FOUR(level) {level, level, level}, {level, level, level}, {level, level, level}, {level, level, level},
#define RING(level) FOUR(level) FOUR(level) FOUR(level) FOUR(level) FOUR(level) FOUR(level)

static const uint8_t fading[STAGE_DISC_VERTICES][3] = {
    {255, 255, 255},
    RING(199)
    RING(187)
    RING(171)
    RING(151)
    RING(120)
    RING(83)
    RING(34)
    RING(0)
};
/* clang-format on */

const glint_mesh stage_disc = {
    .positions = glow_positions,
    .normals = glow_normals,
    .triangles = glow_triangles,
    .vertex_count = STAGE_DISC_VERTICES,
    .triangle_count = COUNT_OF(glow_triangles),
    .extent = {1310761, 1310761, 0}, /* as in glow.h: C takes no constant from a constant structure */
    .colours = fading,
};

glint_object *stage_glow(example_stage *stage, glint_vector position, glint_q16 radius, glint_colour colour) {
    const glint_material light = {
        .model = &glint_model_unlit, .diffuse = colour, .blend = GLINT_BLEND_ADD, .opacity = GLINT_ONE};
    const glint_pose size = glint_pose_scale(radius / 20, radius / 20, GLINT_ONE);
    glint_pose pose = stage->scene.camera.pose;
    glint_object *added;

    pose.m[0][3] = position.x;
    pose.m[1][3] = position.y;
    pose.m[2][3] = position.z;
    pose = glint_pose_then(&size, &pose);
    added = stage_add(stage, &stage_disc, &light, &pose);
    added->evaluation = &glint_per_vertex;
    stage->layers = &glint_layers;
    return added;
}

void stage_fog(example_stage *stage, const glint_fog_type *type, glint_q16 start, glint_q16 end, glint_colour colour) {
    const glint_fog fog = {.type = type, .colour = colour, .start = start, .end = end};

    stage->fog = fog;
    stage->scene.fog = &stage->fog;
}

glint_pose stage_place(glint_vector scale, glint_q16 turn, glint_vector position) {
    const glint_pose scaling = glint_pose_scale(scale.x, scale.y, scale.z);
    const glint_pose turning = glint_pose_rotate_y(turn);
    const glint_pose moving = glint_pose_translate(position.x, position.y, position.z);
    const glint_pose turned = glint_pose_then(&scaling, &turning);

    return glint_pose_then(&turned, &moving);
}

glint_q16 stage_multiply(glint_q16 a, glint_q16 b) {
    const int64_t product = (int64_t)a * b;

    return (glint_q16)((product + (product < 0 ? -GLINT_ONE / 2 : GLINT_ONE / 2)) / GLINT_ONE); /* no shift: sign */
}

glint_colour stage_times(glint_colour colour, glint_q16 factor) {
    const glint_colour product = {stage_multiply(colour.r, factor), stage_multiply(colour.g, factor),
                                  stage_multiply(colour.b, factor)};

    return product;
}
