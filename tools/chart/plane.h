/* SPDX-License-Identifier: MIT */
/**
 * @file plane.h
 * A scene of which nothing can be dropped: a plane across the screen, all of it lit and in its highlight. Against twins
 * that drop nothing it shows what looking for drops costs.
 */
#ifndef CHART_PLANE_H
#define CHART_PLANE_H

#include "glint.h"

enum { PLANE_QUADS = 9, PLANE_VERTICES = (PLANE_QUADS + 1) * (PLANE_QUADS + 1), PLANE_WIDTH = 320, PLANE_HEIGHT = 240 };

/** The scene and all that it points to; not to be moved. */
typedef struct plane_stage {
    int16_t positions[PLANE_VERTICES][3], normals[PLANE_VERTICES][3];
    uint16_t triangles[2 * PLANE_QUADS * PLANE_QUADS][3];
    glint_mesh mesh;
    glint_material material;
    glint_light light;
    glint_object object;
    glint_scene scene;
} plane_stage;

/** A light that the fast kernels serve, and one for the general kernel. */
typedef struct plane_light {
    const char *name;
    const glint_light_type *type;
} plane_light;

static const plane_light plane_lights[] = {{"directional", &glint_light_directional}, {"point", &glint_light_point}};
#define PLANE_LIGHTS (sizeof plane_lights / sizeof *plane_lights)

#define PLANE_GREY(level) \
    { GLINT_Q16(level), GLINT_Q16(level), GLINT_Q16(level) }

/** Builds it. @return GLINT_OK, or what the generator says. */
static inline glint_status plane_build(plane_stage *stage, const plane_light *light) {
    const glint_mesh_room room = {stage->positions, stage->normals, stage->triangles, PLANE_VERTICES,
                                  2 * PLANE_QUADS * PLANE_QUADS};
    stage->material =
        (glint_material){&glint_model_blinn_phong, PLANE_GREY(0.1), PLANE_GREY(0.4), PLANE_GREY(0.4), GLINT_Q16(2), 0};
    stage->light =
        (glint_light){light->type, {GLINT_Q16(0.1), GLINT_Q16(0.1), GLINT_Q16(3)}, PLANE_GREY(1), PLANE_GREY(1)};
    stage->object = (glint_object){&stage->mesh, &stage->material, glint_pose_identity()};
    stage->scene = (glint_scene){
        .camera = {glint_pose_translate(0, 0, GLINT_Q16(3)), GLINT_Q16(35), GLINT_Q16(0.1)},
        .viewer = GLINT_VIEWER_LOCAL,
        .ambient = PLANE_GREY(1),
        .lights = &stage->light,
        .light_count = 1,
        .objects = &stage->object,
        .object_count = 1,
    };
    return glint_generate_plane(&stage->mesh, &room, PLANE_QUADS, PLANE_QUADS, GLINT_Q16(1.3), GLINT_ONE);
}

#endif
