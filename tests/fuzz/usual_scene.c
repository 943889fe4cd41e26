/* SPDX-License-Identifier: MIT */
/* Scenes as users have them: what the fast ways of lighting take, beside what they must leave to others. */
#include "drawing.h"

#include "glint_extras.h"
#include "quantise.h"

#include <string.h>

/* ---- Numbers ------------------------------------------------------------------------------------------------- */

/* From 2^least to 2^(most + 1), each power of two as likely as the others. */
static glint_q16 across(source *s, int least, int most) {
    const int power = least + (int)below(s, (uint32_t)(most - least + 1));
    const glint_q16 one = GLINT_ONE + (glint_q16)(take(s, 1) << 8);
    return power < 0 ? one >> -power : one << power;
}

/* From least to most. */
static glint_q16 between(source *s, glint_q16 least, glint_q16 most) {
    return least + (glint_q16)((int64_t)take(s, 2) * (most - least) / 65535);
}

static glint_q16 times(glint_q16 a, glint_q16 b) {
    const int64_t product = ((int64_t)a * b) / GLINT_ONE, most = 8000 * GLINT_ONE;
    return (glint_q16)(product > most ? most : product < -most ? -most : product);
}

static glint_vector scaled(glint_vector v, glint_q16 by) {
    return (glint_vector){times(v.x, by), times(v.y, by), times(v.z, by)};
}

static glint_vector sum(glint_vector a, glint_vector b) {
    return (glint_vector){a.x + b.x, a.y + b.y, a.z + b.z};
}

/* Of length 1: now and then along an axis of the world. */
static glint_vector take_direction(source *s) {
    const uint32_t grid = take(s, 2), quarter = 90 * GLINT_ONE;
    const glint_q16 turn = (glint_q16)(grid % 4 ? (grid >> 8) * 92160 : (grid >> 8) % 4 * quarter);
    const glint_q16 rise =
        grid % 4 ? between(s, -90 * GLINT_ONE, 90 * GLINT_ONE) : (glint_q16)(grid >> 4 & 1) * 90 * GLINT_ONE;
    const glint_q16 radius = glint_cos(rise);
    return (glint_vector){times(radius, glint_sin(turn)), glint_sin(rise), times(radius, glint_cos(turn))};
}

/* From 2^least to 2^(most + 1) times as long as `size`, in any direction. */
static glint_vector take_offset(source *s, glint_q16 size, int least, int most) {
    const glint_vector direction = take_direction(s);
    return scaled(direction, times(size, across(s, least, most)));
}

/* Grey, or of three channels; now and then black, or up to 4. */
static glint_colour take_colour(source *s) {
    const uint32_t kind = below(s, 16);
    const glint_q16 most = kind == 2 || kind == 3 ? 4 * GLINT_ONE : GLINT_ONE;
    glint_colour colour = {0, 0, 0};
    if (kind == 1)
        return colour;
    colour.r = colour.g = colour.b = between(s, 0, most);
    if (kind & 1) {
        colour.g = between(s, 0, most);
        colour.b = between(s, 0, most);
    }
    return colour;
}

/* ---- Meshes -------------------------------------------------------------------------------------------------- */

typedef struct shape {
    uint32_t kind, around, along;
    glint_q16 radius, size; /* the other size */
} shape;

/* Into room, or without room only how much it takes. */
static glint_status generate(const shape *of, glint_mesh *mesh, const glint_mesh_room *room) {
    switch (of->kind) {
    case 0:
    case 1:
        return glint_generate_torus(mesh, room, of->around, of->along, of->radius, of->size);
    case 2:
    case 3:
        return glint_generate_sphere(mesh, room, of->around, of->along, of->radius);
    case 4:
        return glint_generate_cylinder(mesh, room, of->around, of->along, of->radius, of->size, (int)of->around & 1);
    case 5:
        return glint_generate_cone(mesh, room, of->around, of->along, of->radius, of->size, (int)of->around & 1);
    case 6:
        return glint_generate_plane(mesh, room, of->around - 2, of->along - 2, of->radius, of->size);
    default:
        return glint_generate_box(mesh, room, of->radius, of->size, of->radius);
    }
}

/* About 1 large. */
static void take_mesh(source *s, glint_mesh *mesh, int may_have_clusters) {
    shape of;
    glint_mesh_room room = {0};
    of.kind = below(s, 8);
    of.around = 3 + below(s, 22);
    of.along = 3 + below(s, 10);
    of.radius = across(s, -1, 0);
    of.size = across(s, -3, 0);
    require(generate(&of, mesh, &room) == GLINT_ERROR_GENERATOR);
    room.vertex_room = mesh->vertex_count;
    room.triangle_room = mesh->triangle_count;
    room.positions = allocate(room.vertex_room * sizeof *room.positions);
    room.normals = allocate(room.vertex_room * sizeof *room.normals);
    room.triangles = allocate(room.triangle_room * sizeof *room.triangles);
    require(generate(&of, mesh, &room) == GLINT_OK);
    if (one_in(s, 8))
        mesh->flags = GLINT_MESH_DOUBLE_SIDED;
    if (below(s, 2) && may_have_clusters)
        cluster_mesh(mesh);
    if (one_in(s, 8))
        take_mesh_colours(s, mesh);
    if (mesh->colours && mesh->colours565) { /* which of them is drawn is not said where they differ */
        free((void *)(uintptr_t)mesh->colours565);
        mesh->colours565 = NULL;
    }
}

/* ---- Objects ------------------------------------------------------------------------------------------------- */

static glint_pose take_turn(source *s) {
    const glint_pose x = glint_pose_rotate_x(between(s, 0, 360 * GLINT_ONE));
    const glint_pose y = glint_pose_rotate_y(between(s, 0, 360 * GLINT_ONE));
    return glint_pose_then(&x, &y);
}

/* Of a size: stretched now and then, or mirrored. */
static glint_pose take_pose(source *s, glint_q16 size, glint_vector at) {
    const uint32_t kind = below(s, 8);
    const glint_q16 x = kind == 2 || kind == 3 ? times(size, across(s, -2, 1)) : size;
    const glint_pose scaling = glint_pose_scale(kind & 1 ? -x : x, size, size);
    const glint_pose turn = take_turn(s);
    glint_pose pose = glint_pose_then(&scaling, &turn);
    pose.m[0][3] = at.x;
    pose.m[1][3] = at.y;
    pose.m[2][3] = at.z;
    return pose;
}

static glint_q16 take_shininess(source *s) {
    switch (below(s, 8)) {
    case 0:
        return across(s, 5, 6);
    case 1:
        return 0;
    case 2:
        return across(s, -16, 1);
    case 3:
        return across(s, 10, 13);
    case 4:
        return GLINT_ONE << below(s, 11);
    default:
        return across(s, 1, 9);
    }
}

static void take_material(source *s, glint_material *material) {
    static const glint_shading_model *const models[8] = {
        &glint_model_blinn_phong, &glint_model_blinn_phong, &glint_model_blinn_phong, &glint_model_lambert,
        &glint_model_blinn_phong, &glint_model_phong,       &glint_model_blinn_phong, &glint_model_unlit};
    const glint_shading_model *model = models[below(s, 8)];
    const glint_q16 shininess = take_shininess(s);
    const glint_colour paint = take_colour(s);
    *material = glint_material_paint(model, paint, GLINT_ONE / 8, shininess);
    if (below(s, 2)) {
        material->diffuse = take_colour(s);
        material->specular = take_colour(s);
    }
    if (one_in(s, 8))
        material->flags = below(s, 4);
}

static void take_objects(source *s, drawing *d, glint_q16 size, glint_vector centre) {
    const glint_evaluation *const evaluations[8] = {&glint_per_fragment, &glint_per_fragment, &glint_per_fragment,
                                                    &glint_per_vertex,   &glint_per_vertex,   &glint_per_fragment,
                                                    &glint_per_fragment, &glint_per_facet};
    d->scene.object_count = 1 + below(s, DRAWING_OBJECTS);
    for (uint32_t i = 0; i < d->scene.object_count; i++) {
        glint_object *object = &d->objects[i];
        take_material(s, &d->materials[i]);
        *object = (glint_object){0};
        object->mesh = &d->meshes[below(s, DRAWING_MESHES)];
        object->material = &d->materials[below(s, i + 1)];
        object->evaluation = evaluations[below(s, 8)];
        const glint_vector at = i ? sum(centre, take_offset(s, size, -2, 1)) : centre;
        object->pose = take_pose(s, size, at);
    }
    d->scene.objects = d->objects;
}

/* ---- Camera -------------------------------------------------------------------------------------------------- */

/* So far that `size` takes about the screen's height, or any distance. */
static glint_q16 take_distance(source *s, glint_q16 field_of_view, glint_q16 size) {
    const glint_q16 ratio = across(s, -1, 0);
    if (one_in(s, 4))
        return times(size, across(s, -2, 12));
    const glint_q16 tangent =
        (glint_q16)((int64_t)glint_sin(field_of_view / 2) * GLINT_ONE / glint_cos(field_of_view / 2));
    return times(size, GLINT_ONE / 2 + (glint_q16)((int64_t)ratio * 2 * GLINT_ONE / (tangent + 1)));
}

/* Looks at the centre from around it, or a little beside. @return towards the eye */
static glint_vector take_camera(source *s, glint_camera *camera, glint_q16 size, glint_vector centre) {
    const glint_vector up = {0, GLINT_ONE, 0}, forward = {0, 0, GLINT_ONE};
    const glint_vector back = take_direction(s);
    camera->field_of_view =
        one_in(s, 4) ? between(s, GLINT_ONE, 170 * GLINT_ONE) : between(s, 20 * GLINT_ONE, 70 * GLINT_ONE);
    const glint_q16 distance = take_distance(s, camera->field_of_view, size);
    const glint_vector eye = sum(centre, scaled(back, distance));
    if (one_in(s, 4))
        centre = sum(centre, scaled(take_direction(s), size));
    camera->pose = glint_pose_translate(eye.x, eye.y, eye.z);
    if (glint_camera_look_at(camera, eye, centre, up) != GLINT_OK)
        (void)glint_camera_look_at(camera, eye, centre, forward);
    camera->near_plane = (below(s, 2) ? distance >> below(s, 30) : size >> 4) | 1;
    return back;
}

/* ---- Lights -------------------------------------------------------------------------------------------------- */

/* A vertex of the first object, in the world. */
static glint_vector take_vertex(source *s, const glint_object *object) {
    const glint_mesh *mesh = object->mesh;
    const int16_t *steps = mesh->positions[below(s, mesh->vertex_count)];
    const glint_q16 place[3] = {mesh->offset.x + (glint_q16)((int64_t)mesh->extent.x * steps[0] / 32768),
                                mesh->offset.y + (glint_q16)((int64_t)mesh->extent.y * steps[1] / 32768),
                                mesh->offset.z + (glint_q16)((int64_t)mesh->extent.z * steps[2] / 32768)};
    const glint_pose point = glint_pose_translate(place[0], place[1], place[2]);
    const glint_pose there = glint_pose_then(&point, &object->pose);
    return (glint_vector){there.m[0][3], there.m[1][3], there.m[2][3]};
}

/* Where the eye is, straight behind, inside, on the surface, or anywhere around. */
static glint_vector take_place(source *s, const drawing *d, glint_q16 size, glint_vector back) {
    const glint_pose *camera = &d->scene.camera.pose, *first = &d->objects[0].pose;
    const glint_vector centre = {first->m[0][3], first->m[1][3], first->m[2][3]};
    switch (below(s, 8)) {
    case 1:
        return (glint_vector){camera->m[0][3], camera->m[1][3], camera->m[2][3]};
    case 2:
        return sum(centre, scaled(back, -times(size, across(s, 0, 3))));
    case 3:
        return sum(centre, scaled(take_direction(s), size >> 4));
    case 4:
        return take_vertex(s, &d->objects[0]);
    default:
        return sum(centre, take_offset(s, size, 0, 5));
    }
}

/* The same of directions: from the eye, from straight behind, along the camera's axes, or any. */
static glint_vector take_towards(source *s, const glint_camera *camera, glint_vector back) {
    const uint32_t axis = below(s, 3);
    switch (below(s, 8)) {
    case 1:
        return back;
    case 2:
        return scaled(back, -across(s, -8, 6));
    case 3:
    case 4:
        return (glint_vector){camera->pose.m[0][axis], camera->pose.m[1][axis], camera->pose.m[2][axis]};
    case 5: /* a little beside the eye */
        return sum(back, take_offset(s, GLINT_ONE, -12, -1));
    default:
        return take_direction(s);
    }
}

static void take_lamp(source *s, const drawing *d, glint_q16 size, glint_vector back, glint_light *light) {
    const glint_pose *first = &d->objects[0].pose;
    light->position = take_place(s, d, size, back);
    if (below(s, 2)) {
        light->linear = across(s, -6, 1);
        light->quadratic = across(s, -8, 1);
    }
    light->direction = (glint_vector){first->m[0][3] - light->position.x, first->m[1][3] - light->position.y,
                                      first->m[2][3] - light->position.z};
    if (!(light->direction.x | light->direction.y | light->direction.z))
        light->direction = scaled(back, -GLINT_ONE);
    light->outer = one_in(s, 4) ? between(s, 0, 180 * GLINT_ONE) : between(s, 5 * GLINT_ONE, 60 * GLINT_ONE);
    light->inner = one_in(s, 4) ? light->outer : between(s, 0, light->outer);
}

static void take_lights(source *s, drawing *d, glint_q16 size, glint_vector back) {
    static const glint_light_type *const types[8] = {
        &glint_light_directional, &glint_light_directional, &glint_light_directional, &glint_light_point,
        &glint_light_directional, &glint_light_spot,        &glint_light_directional, &glint_light_point};
    d->scene.light_count = below(s, 2) ? 1 + below(s, GLINT_LIGHTS_MAX) : 1;
    for (uint32_t i = 0; i < d->scene.light_count; i++) {
        glint_light *light = &d->lights[i];
        light->type = types[below(s, 8)];
        if (light->type == &glint_light_directional)
            light->direction = scaled(take_towards(s, &d->scene.camera, back), -GLINT_ONE);
        else
            take_lamp(s, d, size, back, light);
        light->diffuse = take_colour(s);
        light->specular = one_in(s, 4) ? take_colour(s) : light->diffuse;
    }
    d->scene.lights = d->lights;
}

/* ---- Scene --------------------------------------------------------------------------------------------------- */

void take_usual_scene(source *s, drawing *d, int may_have_clusters) {
    glint_vector centre = {0, 0, 0};
    memset(d, 0, sizeof *d);
    for (int i = 0; i < DRAWING_MESHES; i++)
        take_mesh(s, &d->meshes[i], may_have_clusters);
    const glint_q16 size = one_in(s, 4) ? across(s, -6, 6) : GLINT_ONE;
    if (one_in(s, 8))
        centre = take_offset(s, GLINT_ONE, 0, 11);
    const glint_vector back = take_camera(s, &d->scene.camera, size, centre);
    take_objects(s, d, size, centre);
    take_lights(s, d, size, back);
    d->scene.viewer = below(s, 2) ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
    d->scene.background = take_colour(s);
    d->scene.ambient = take_colour(s);
}
