/* SPDX-License-Identifier: MIT */
#include "turntable.h"

#include "meshes/teapot.h"
#include "meshes/torus576.h"

const char *turntable_name(turntable_model model) {
    return model == TURNTABLE_TORUS ? "torus576" : "teapot";
}

/* The benchmark scene: turned about y by 0.3 + 0.1 k and then about x by 0.04 k - 0.9 radians, 3.7 in front. */
static void set_torus(turntable *table, uint32_t frame) {
    const glint_light light = {.type = &glint_light_directional,
                               .direction = GLINT_VECTOR(-0.4, -0.6, -0.7),
                               .diffuse = GLINT_COLOUR(1, 1, 1),
                               .specular = GLINT_COLOUR(1, 1, 1)};
    const glint_material material = {&glint_model_blinn_phong, GLINT_COLOUR(0.135, 0.075, 0.045),
                                     GLINT_COLOUR(0.765, 0.425, 0.255), GLINT_COLOUR(0.5, 0.5, 0.5), GLINT_Q16(32)};
    const glint_q16 k = (glint_q16)(frame % 256);
    const glint_pose turn_y = glint_pose_rotate_y(GLINT_Q16(17.18873) + k * GLINT_Q16(5.72958));
    const glint_pose turn_x = glint_pose_rotate_x(GLINT_Q16(-51.56620) + k * GLINT_Q16(2.29183));
    const glint_pose turn = glint_pose_then(&turn_y, &turn_x);
    const glint_pose move = glint_pose_translate(0, 0, GLINT_Q16(-3.7));

    table->material = material;
    table->lights[0] = light;
    table->object.mesh = &torus576_mesh;
    table->object.pose = glint_pose_then(&turn, &move);
    table->scene.light_count = 1;
    table->scene.viewer = GLINT_VIEWER_LOCAL;
    table->scene.ambient = (glint_colour)GLINT_COLOUR(1, 1, 1);
    table->scene.camera.pose = glint_pose_identity();
    table->scene.camera.field_of_view = GLINT_Q16(60);
}

/* A tenth of a turn a frame; the camera stands still, a little above. */
static void set_teapot(turntable *table, uint32_t frame) {
    const glint_light key = {.type = &glint_light_directional,
                             .direction = GLINT_VECTOR(0.5, -0.8, -0.7),
                             .diffuse = GLINT_COLOUR(0.9, 0.9, 0.9),
                             .specular = GLINT_COLOUR(0.8, 0.8, 0.8)};
    const glint_light rim = {.type = &glint_light_directional,
                             .direction = GLINT_VECTOR(-1, -0.2, 0.6),
                             .diffuse = GLINT_COLOUR(0.3, 0.3, 0.3),
                             .specular = GLINT_COLOUR(0.4, 0.4, 0.4)};
    const glint_material material = {&glint_model_blinn_phong, GLINT_COLOUR(0.7, 0.7, 0.7), GLINT_COLOUR(0.7, 0.7, 0.7),
                                     GLINT_COLOUR(0.6, 0.6, 0.6), GLINT_Q16(50)};
    const glint_pose back = glint_pose_translate(0, 0, GLINT_Q16(2.75));
    const glint_pose above = glint_pose_rotate_x(GLINT_Q16(-19));

    table->material = material;
    table->lights[0] = key;
    table->lights[1] = rim;
    table->object.mesh = &teapot_mesh;
    table->object.pose = glint_pose_rotate_y((glint_q16)(frame % TURNTABLE_FRAMES) * GLINT_Q16(36));
    table->scene.light_count = 2;
    table->scene.viewer = GLINT_VIEWER_INFINITE;
    table->scene.ambient = (glint_colour)GLINT_COLOUR(0.15, 0.15, 0.15);
    table->scene.camera.field_of_view = GLINT_Q16(29);
    table->scene.camera.pose = glint_pose_then(&back, &above);
}

void turntable_frame(turntable *table, turntable_model model, uint32_t frame) {
    glint_scene *scene = &table->scene;

    *scene = (glint_scene){0};
    scene->camera.near_plane = GLINT_Q16(0.1);
    scene->lights = table->lights;
    scene->objects = &table->object;
    scene->object_count = 1;
    table->object = (glint_object){.material = &table->material, .evaluation = &glint_per_fragment};
    if (TURNTABLE_SHOWN > TURNTABLE_TEAPOT && model == TURNTABLE_TEAPOT)
        set_teapot(table, frame);
    else
        set_torus(table, frame);
}

void turntable_fit(turntable *table, uint16_t width, uint16_t height) {
    glint_q16 *field_of_view = &table->scene.camera.field_of_view;

    if (3 * width < 5 * height && *field_of_view < GLINT_Q16(30)) {
        *field_of_view = 3 * width < 4 * height ? GLINT_Q16(48) : GLINT_Q16(36);
    }
}
