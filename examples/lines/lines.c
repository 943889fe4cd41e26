/* SPDX-License-Identifier: MIT */
#include "lines.h"

#include "glint_extras.h"
#include "meshes/teapot.h"
#include "meshes/torus12x8.h"

/* Red, green and blue for x, y and z. */
static const glint_line axes[3] = {{GLINT_VECTOR(0, 0, 0), GLINT_VECTOR(1.4, 0, 0), GLINT_COLOUR(1, 0.15, 0.1)},
                                   {GLINT_VECTOR(0, 0, 0), GLINT_VECTOR(0, 1.0, 0), GLINT_COLOUR(0.2, 1, 0.2)},
                                   {GLINT_VECTOR(0, 0, 0), GLINT_VECTOR(0, 0, 1.2), GLINT_COLOUR(0.2, 0.4, 1)}};

#define BOX 12
#define EDGES 288 /* of a torus of 12 x 8 squares */

static glint_line box[BOX], edges[EDGES];

/* All that is drawn over the picture. */
typedef struct overlay {
    glint_segment axes[3], box[BOX], edges[EDGES];
} overlay;

static int draw_overlay(void *context, const glint_tile *tile) {
    const overlay *const o = context;

    return glint_lines_draw(tile, o->edges, EDGES) || glint_lines_draw(tile, o->box, BOX) ||
           glint_lines_draw(tile, o->axes, 3);
}

/* Corners of the box that a mesh's steps span. */
static glint_vector corner_of(const glint_mesh *mesh, int sign) {
    return (glint_vector){mesh->offset.x + sign * mesh->extent.x, mesh->offset.y + sign * mesh->extent.y,
                          mesh->offset.z + sign * mesh->extent.z};
}

glint_status lines_draw(const glint_config *config) {
    static const glint_material red = {&glint_model_blinn_phong, GLINT_COLOUR(0.05, 0.02, 0.02),
                                       GLINT_COLOUR(0.45, 0.16, 0.12), GLINT_COLOUR(0.5, 0.5, 0.5), GLINT_Q16(50)};
    static const glint_material grey = {&glint_model_blinn_phong, GLINT_COLOUR(0.04, 0.04, 0.05),
                                        GLINT_COLOUR(0.3, 0.32, 0.4), GLINT_COLOUR(0.2, 0.2, 0.2), GLINT_Q16(20)};
    static const glint_light lamp = {.type = &glint_light_directional,
                                     .direction = GLINT_VECTOR(0.5, -0.9, -0.7),
                                     .diffuse = GLINT_COLOUR(1, 1, 1),
                                     .specular = GLINT_COLOUR(1, 1, 1)};
    const glint_pose left = glint_pose_translate(GLINT_Q16(-0.75), 0, 0), tilt = glint_pose_rotate_x(GLINT_Q16(-60)),
                     half = glint_pose_scale(GLINT_Q16(0.5), GLINT_Q16(0.5), GLINT_Q16(0.5)),
                     right = glint_pose_translate(GLINT_Q16(1.25), 0, GLINT_Q16(0.3)),
                     small = glint_pose_then(&half, &tilt);
    const glint_object objects[2] = {
        {.mesh = &teapot_mesh, .material = &red, .evaluation = &glint_per_fragment, .pose = left},
        {.mesh = &torus12x8_mesh,
         .material = &grey,
         .evaluation = &glint_per_fragment,
         .pose = glint_pose_then(&small, &right)}};
    glint_scene scene = {.background = GLINT_COLOUR(0.01, 0.015, 0.03),
                         .ambient = GLINT_COLOUR(1, 1, 1),
                         .lights = &lamp,
                         .light_count = 1,
                         .objects = objects,
                         .object_count = 2};
    static overlay over;
    glint_config local = *config;
    glint_renderer renderer;

    scene.camera = (glint_camera){.field_of_view = GLINT_Q16(36), .near_plane = GLINT_Q16(0.1)};
    glint_camera_orbit(&scene.camera, (glint_vector)GLINT_VECTOR(0.1, 0.05, 0), GLINT_Q16(28), GLINT_Q16(24),
                       GLINT_Q16(4.8));
    glint_lines_box(box, corner_of(&teapot_mesh, -1), corner_of(&teapot_mesh, 1),
                    (glint_colour)GLINT_COLOUR(0.8, 0.8, 0.8));
    if (glint_lines_edges(edges, EDGES, &torus12x8_mesh, (glint_colour)GLINT_COLOUR(0.1, 0.9, 0.8)) != EDGES)
        return GLINT_ERROR_MESH;
    glint_status status = glint_lines_project(over.axes, &local, &scene.camera, &left, axes, 3);
    if (status == GLINT_OK)
        status = glint_lines_project(over.box, &local, &scene.camera, &left, box, BOX);
    if (status == GLINT_OK)
        status = glint_lines_project(over.edges, &local, &scene.camera, &objects[1].pose, edges, EDGES);
    local.overlay = (glint_painter){draw_overlay, &over};
    if (status == GLINT_OK)
        status = glint_init(&renderer, &local);
    return status == GLINT_OK ? glint_render(&renderer, &scene) : status;
}
