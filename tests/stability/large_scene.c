/* SPDX-License-Identifier: MIT */
#include "large_scene.h"

#include "every_format.h"
#include "grids.h"
#include "random_texture.h"
#include "source.h"

#include <string.h>

/* ---- Numbers ------------------------------------------------------------------------------------------------- */

/* From least to most, both included. */
static int32_t between(source *random, int32_t least, int32_t most) {
    const uint64_t count = (uint64_t)((int64_t)most - least) + 1;
    return (int32_t)(least + (int64_t)((next(random) >> 32) * count >> 32));
}

/* Up to most, each number of bits as likely as the others. */
static int32_t across(source *random, int32_t least, int32_t most) {
    int32_t top = least;
    for (uint32_t up = below(random, 32); up && top < most; up--)
        top = top > most / 2 ? most : 2 * top;
    return between(random, top / 2 > least ? top / 2 : least, top);
}

static glint_vector direction(source *random) {
    const glint_q16 x = between(random, -GLINT_ONE, GLINT_ONE);
    const glint_q16 y = between(random, -GLINT_ONE, GLINT_ONE);
    return (glint_vector){x, y, between(random, 0, 1) ? GLINT_ONE / 2 : -GLINT_ONE / 2};
}

static glint_colour colour(source *random, glint_q16 most) {
    const glint_q16 r = between(random, 0, most);
    const glint_q16 g = between(random, 0, most);
    return (glint_colour){r, g, between(random, 0, most)};
}

/* ---- Meshes -------------------------------------------------------------------------------------------------- */

/* Begins a mesh that reaches `size` units from its origin, Q16. */
static void begin_mesh(large_mesh *mesh, glint_q16 size) {
    mesh->mesh = (glint_mesh){.positions = (const int16_t(*)[3])mesh->positions,
                              .normals = (const int16_t(*)[3])mesh->normals,
                              .triangles = (const uint16_t(*)[3])mesh->triangles,
                              .extent = {size, size, size},
                              .flags = GLINT_MESH_DOUBLE_SIDED};
}

static void set_triangle(large_mesh *mesh, uint32_t a, uint32_t b, uint32_t c) {
    uint16_t *const corners = mesh->triangles[mesh->mesh.triangle_count++];
    corners[0] = (uint16_t)a;
    corners[1] = (uint16_t)b;
    corners[2] = (uint16_t)c;
}

/* The mesh's arrays, as large as they are. */
static glint_mesh_room room_of(large_mesh *mesh) {
    return (glint_mesh_room){.positions = mesh->positions, .normals = mesh->normals, .triangles = mesh->triangles};
}

/* A terrain as wide as all steps, its heights random. */
static void make_terrain(large_mesh *mesh, source *random, glint_q16 size) {
    const glint_mesh_room room = room_of(mesh);
    begin_mesh(mesh, size);
    mesh->mesh.extent.y = size / 5 + 1;
    grid_add_terrain(&mesh->mesh, &room, 1 + below(random, 6));
    for (uint32_t i = 0; i < mesh->mesh.vertex_count; i++)
        mesh->positions[i][1] = (int16_t)between(random, -32768, 32767);
}

/* A room: six walls, their front faces inside. */
static void make_room(large_mesh *mesh, source *random, glint_q16 size) {
    const glint_mesh_room room = room_of(mesh);
    begin_mesh(mesh, size);
    grid_add_room(&mesh->mesh, &room, 1 + below(random, 2));
    if (one_in(random, 2))
        mesh->mesh.flags = 0;
}

/* Triangles anywhere within all steps. */
static void make_loose(large_mesh *mesh, source *random, glint_q16 size) {
    const uint32_t count = 1 + below(random, 8);
    begin_mesh(mesh, size);
    mesh->mesh.vertex_count = 3 * count;
    for (uint32_t i = 0; i < 3 * count; i++)
        for (int axis = 0; axis < 3; axis++) {
            mesh->positions[i][axis] = (int16_t)between(random, -32768, 32767);
            mesh->normals[i][axis] = (int16_t)(between(random, -16384, 16383) * 2 + 1);
        }
    for (uint32_t i = 0; i < count; i++)
        set_triangle(mesh, 3 * i, 3 * i + 1, 3 * i + 2);
}

/* Colours of vertices, more often than not. */
static void paint_mesh(large_mesh *mesh, source *random) {
    if (one_in(random, 3))
        return;
    for (uint32_t i = 0; i < mesh->mesh.vertex_count; i++)
        for (int c = 0; c < 3; c++)
            mesh->colours[i][c] = (uint8_t)(one_in(random, 4) ? 255 * below(random, 2) : below(random, 256));
    mesh->mesh.colours = (const uint8_t(*)[3])mesh->colours;
}

/* ---- Objects, lights and cameras ----------------------------------------------------------------------------- */

/* Adds an object where its mesh is, lit in any way. */
static void add_object(large_scene *s, source *random) {
    static const glint_shading_model *const models[4] = {&glint_model_unlit, &glint_model_lambert, &glint_model_phong,
                                                         &glint_model_blinn_phong};
    const glint_evaluation *const evaluations[4] = {&glint_per_fragment, &glint_per_fragment, &glint_per_vertex,
                                                    &glint_per_facet};
    const uint32_t i = s->scene.object_count++;
    glint_material *const material = &s->materials[i];
    paint_mesh(&s->meshes[i], random);
    material->model = models[below(random, 4)];
    material->ambient = colour(random, GLINT_ONE / 4);
    material->diffuse = colour(random, GLINT_ONE);
    material->specular = colour(random, GLINT_ONE / 2);
    material->shininess = across(random, GLINT_ONE / 2, 400 * GLINT_ONE);
    material->flags = one_in(random, 4) ? below(random, 4) : 0;
    s->objects[i] = (glint_object){&s->meshes[i].mesh, material, glint_pose_identity(), evaluations[below(random, 4)]};
}

static void make_lights(large_scene *s, source *random, glint_q16 size) {
    static const glint_light_type *const types[4] = {&glint_light_directional, &glint_light_directional,
                                                     &glint_light_point, &glint_light_spot};
    s->scene.lights = s->lights;
    s->scene.light_count = below(random, one_in(random, 8) ? GLINT_LIGHTS_MAX + 1 : 4);
    for (uint32_t i = 0; i < s->scene.light_count; i++) {
        glint_light *const light = &s->lights[i];
        light->type = types[below(random, 4)];
        const glint_vector from = direction(random);
        if (light->type != &glint_light_directional) {
            light->position.x = between(random, -size, size);
            light->position.y = between(random, -size, size);
            light->position.z = between(random, -size, size);
        }
        light->diffuse = colour(random, GLINT_ONE);
        light->specular = colour(random, GLINT_ONE);
        light->linear = one_in(random, 2) ? 0 : across(random, 1, GLINT_ONE);
        light->quadratic = one_in(random, 2) ? 0 : across(random, 1, GLINT_ONE);
        light->direction = direction(random);
        if (light->type == &glint_light_directional)
            light->direction = (glint_vector){-from.x, -from.y, -from.z};
        light->inner = between(random, 0, 90 * GLINT_ONE);
        light->outer = light->inner + between(random, 0, 90 * GLINT_ONE);
    }
}

/* An eye up to `reach` units from the origin, that looks anywhere. */
static void make_camera(large_scene *s, source *random, glint_q16 reach) {
    static const glint_q16 near_planes[8] = {1, 1, 1, 1, 2, 8, 64, 6554};
    glint_camera *const camera = &s->scene.camera;
    const glint_q16 x = between(random, -reach, reach), y = between(random, -reach, reach);
    const glint_vector axis = direction(random);
    camera->pose = glint_pose_rotate(axis, between(random, 0, 360 * GLINT_ONE));
    camera->pose.m[0][3] = x;
    camera->pose.m[1][3] = y;
    camera->pose.m[2][3] = between(random, -reach, reach);
    camera->field_of_view = one_in(random, 2) ? 50 * GLINT_ONE : across(random, GLINT_ONE, 120 * GLINT_ONE);
    camera->near_plane = near_planes[below(random, 8)];
    if (!s->is_closed && one_in(random, 8)) {
        camera->projection = &glint_orthographic;
        camera->view_height = across(random, GLINT_ONE / 256, reach);
    }
}

/* A triangle before the eye, a few units large: the first object is drawn without a look at what hides it. */
static void add_flag(large_scene *s, source *random) {
    static const int16_t corners[3][3] = {{0, 0, 0}, {2000, 0, 0}, {0, 2000, 0}};
    large_mesh *const mesh = &s->meshes[s->scene.object_count];
    const glint_pose ahead = glint_pose_translate(0, 0, -3 * GLINT_ONE);
    begin_mesh(mesh, GLINT_ONE);
    memcpy(mesh->positions, corners, sizeof corners);
    for (uint32_t i = 0; i < 3; i++)
        mesh->normals[i][2] = 32767;
    mesh->mesh.vertex_count = 3;
    set_triangle(mesh, 0, 1, 2);
    add_object(s, random);
    s->objects[s->scene.object_count - 1].pose = glint_pose_then(&ahead, &s->scene.camera.pose);
}

/* Meshes up to 2^17 units large around the origin, of which 2^15 are their extent and the rest their pose's scale. */
static void add_depths(large_scene *s, source *random) {
    while (s->scene.object_count < 3) {
        const uint32_t i = s->scene.object_count;
        make_loose(&s->meshes[i], random, across(random, GLINT_ONE / 16, 30000 * GLINT_ONE));
        add_object(s, random);
        if (one_in(random, 2))
            s->objects[i].pose = glint_pose_scale(4 * GLINT_ONE, 4 * GLINT_ONE, 4 * GLINT_ONE);
    }
}

/* Lets half of the objects of some scenes wear textures. */
static void dress(large_scene *s, source *random) {
    if (!one_in(random, 3))
        return;
    for (uint32_t i = 0; i < s->scene.object_count; i++) {
        large_mesh *const mesh = &s->meshes[i];
        if (one_in(random, 2))
            random_texture_dress(&mesh->mesh, mesh->texture_coordinates, &s->materials[i], &s->textures[i], random);
        s->is_closed &= !s->textures[i].texture.flags;
    }
}

/* ---- Scenes -------------------------------------------------------------------------------------------------- */

const char *const large_kind_names[LARGE_KINDS] = {"terrain", "room", "loose triangles", "depths"};

void large_scene_make(large_scene *s, uint64_t seed) {
    source random = {seed};
    memset(s, 0, sizeof *s);
    s->seed = seed;
    s->kind = (large_kind)(seed % LARGE_KINDS);
    s->is_closed = s->kind == LARGE_ROOM;
    s->width = 8 + (int)below(&random, 121);
    s->height = 8 + (int)below(&random, 73);
    s->format = every_format[one_in(&random, 2) ? below(&random, FORMAT_COUNT) : below(&random, 3)];
    s->scene.objects = s->objects;
    s->scene.viewer = one_in(&random, 2) ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
    s->scene.background = (glint_colour){0, 0, GLINT_ONE};
    s->scene.ambient = colour(&random, GLINT_ONE);
    const glint_q16 size = one_in(&random, 2) ? between(&random, 500 * GLINT_ONE, 4000 * GLINT_ONE)
                                              : across(&random, 32 * GLINT_ONE, 30000 * GLINT_ONE);
    make_camera(s, &random, s->kind == LARGE_DEPTHS ? 4 * GLINT_ONE : size / 8 * 7);
    if (one_in(&random, 2))
        add_flag(s, &random);
    const uint32_t i = s->scene.object_count;
    if (s->kind == LARGE_TERRAIN)
        make_terrain(&s->meshes[i], &random, size);
    else if (s->kind == LARGE_ROOM)
        make_room(&s->meshes[i], &random, size);
    else if (s->kind == LARGE_LOOSE)
        make_loose(&s->meshes[i], &random, size);
    if (s->kind == LARGE_DEPTHS)
        add_depths(s, &random);
    else
        add_object(s, &random);
    if (one_in(&random, 3))
        add_flag(s, &random);
    make_lights(s, &random, size);
    dress(s, &random);
}
