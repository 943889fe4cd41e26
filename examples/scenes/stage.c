/* SPDX-License-Identifier: MIT */
#include "stage.h"

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
