/* SPDX-License-Identifier: MIT */
#include "random_scene.h"

#include "byte_order.h"
#include "glint_extras.h"
#include "grids.h"
#include "random_texture.h"
#include "source.h"
#include "weights.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* ---- Numbers ------------------------------------------------------------------------------------------------- */

static double between(source *random, double least, double most) {
    return least + (most - least) * (double)(next(random) >> 11) / 9007199254740992.0;
}

/* From least to most, each factor of two as likely as the others. */
static double across(source *random, double least, double most) {
    return least * pow(most / least, between(random, 0, 1));
}

static glint_q16 q16(double value) {
    return (glint_q16)lrint(value * 65536);
}

static glint_vector vector(double x, double y, double z) {
    return (glint_vector){q16(x), q16(y), q16(z)};
}

/* Evenly over the unit sphere: z and the longitude are even (Archimedes). */
static void direction(source *random, double out[3]) {
    double z = between(random, -1, 1);
    double longitude = between(random, 0, 6.283185307179586);
    double radius = sqrt(1 - z * z);
    out[0] = radius * cos(longitude);
    out[1] = radius * sin(longitude);
    out[2] = z;
}

static glint_colour colour(source *random, double most) {
    double r = between(random, 0, most);
    double g = between(random, 0, most);
    return (glint_colour){q16(r), q16(g), q16(between(random, 0, most))};
}

/* ---- Meshes -------------------------------------------------------------------------------------------------- */

static glint_mesh_room room_of(random_mesh *mesh) {
    return (glint_mesh_room){.positions = mesh->positions,
                             .normals = mesh->normals,
                             .triangles = mesh->triangles,
                             .vertex_room = RANDOM_VERTICES_MAX,
                             .triangle_room = RANDOM_TRIANGLES_MAX};
}

static void make_solid(random_mesh *mesh, source *random) {
    const glint_mesh_room room = room_of(mesh);
    glint_q16 size = q16(between(random, 0.5, 1));
    uint32_t along;
    switch (below(random, 5)) {
    case 0:
        along = 2 + below(random, 5);
        glint_generate_sphere(&mesh->mesh, &room, 3 + below(random, 7), along, size);
        break;
    case 1:
        along = 3 + below(random, 5);
        glint_generate_torus(&mesh->mesh, &room, 3 + below(random, 7), along, size, size / 3);
        break;
    case 2:
        along = 1 + below(random, 2);
        glint_generate_cylinder(&mesh->mesh, &room, 3 + below(random, 8), along, size / 2, size, 1);
        break;
    case 3:
        along = 1 + below(random, 2);
        glint_generate_cone(&mesh->mesh, &room, 3 + below(random, 10), along, size / 2, size, 1);
        break;
    default:
        glint_generate_box(&mesh->mesh, &room, size, size / 2, q16(between(random, 0.2, 1)));
    }
}

static void own_arrays(random_mesh *mesh, uint32_t vertices, uint32_t triangles) {
    mesh->mesh = (glint_mesh){.positions = (const int16_t(*)[3])mesh->positions,
                              .normals = (const int16_t(*)[3])mesh->normals,
                              .triangles = (const uint16_t(*)[3])mesh->triangles,
                              .vertex_count = vertices,
                              .triangle_count = triangles,
                              .extent = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
}

static void set_normal(random_mesh *mesh, uint32_t vertex, const double n[3], double length) {
    double size = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int axis = 0; axis < 3; axis++)
        mesh->normals[vertex][axis] = (int16_t)lrint(n[axis] / size * length);
}

/* Triangles of their own corners, anywhere within the unit cube, seen from both sides. */
static void make_triangles(random_mesh *mesh, source *random, uint32_t count) {
    own_arrays(mesh, 3 * count, count);
    mesh->mesh.flags = GLINT_MESH_DOUBLE_SIDED;
    for (uint32_t i = 0; i < 3 * count; i++) {
        mesh->triangles[i / 3][i % 3] = (uint16_t)i;
        for (int axis = 0; axis < 3; axis++)
            mesh->positions[i][axis] = (int16_t)lrint(between(random, -32767, 32767));
    }
}

static void plane_normal(const random_mesh *mesh, uint32_t triangle, double out[3]) {
    const uint16_t *corner = mesh->triangles[triangle];
    double a[3];
    double b[3];
    for (int axis = 0; axis < 3; axis++) {
        a[axis] = mesh->positions[corner[1]][axis] - mesh->positions[corner[0]][axis];
        b[axis] = mesh->positions[corner[2]][axis] - mesh->positions[corner[0]][axis];
    }
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Normals of the triangle's plane, leaning by up to `lean` of their length in any direction. */
static void lean_normals(random_mesh *mesh, source *random, double lean) {
    for (uint32_t triangle = 0; triangle < mesh->mesh.triangle_count; triangle++) {
        double plane[3];
        plane_normal(mesh, triangle, plane);
        double size = sqrt(plane[0] * plane[0] + plane[1] * plane[1] + plane[2] * plane[2]) + 1;
        for (int corner = 0; corner < 3; corner++) {
            double n[3];
            direction(random, n);
            for (int axis = 0; axis < 3; axis++)
                n[axis] = plane[axis] / size + lean * n[axis];
            set_normal(mesh, mesh->triangles[triangle][corner], n, 32767);
        }
    }
}

/* A square of two triangles facing +z, from -1 to 1. */
static void make_square(random_mesh *mesh, source *random, double lean) {
    static const int16_t corners[4][2] = {{-32767, -32767}, {32767, -32767}, {32767, 32767}, {-32767, 32767}};
    static const uint16_t triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
    own_arrays(mesh, 4, 2);
    mesh->mesh.flags = GLINT_MESH_DOUBLE_SIDED;
    memcpy(mesh->triangles, triangles, sizeof triangles);
    for (uint32_t i = 0; i < 4; i++) {
        mesh->positions[i][0] = corners[i][0];
        mesh->positions[i][1] = corners[i][1];
        mesh->positions[i][2] = 0;
    }
    lean_normals(mesh, random, lean);
}

/* Each triangle's third corner a few steps beside its first edge. */
static void make_slivers(random_mesh *mesh, source *random) {
    make_triangles(mesh, random, 4 + below(random, 12));
    double most = across(random, 3, 3000);
    for (uint32_t triangle = 0; triangle < mesh->mesh.triangle_count; triangle++) {
        const uint16_t *corner = mesh->triangles[triangle];
        double along = between(random, 0, 1);
        for (int axis = 0; axis < 3; axis++) {
            double a = mesh->positions[corner[0]][axis];
            double b = mesh->positions[corner[1]][axis];
            double middle = a + along * (b - a) + between(random, -most, most);
            mesh->positions[corner[2]][axis] = (int16_t)lrint(fmax(-32767, fmin(32767, middle)));
        }
    }
    lean_normals(mesh, random, 0.3);
}

static void random_normals(random_mesh *mesh, source *random, double shortest) {
    for (uint32_t i = 0; i < mesh->mesh.vertex_count; i++) {
        double n[3];
        direction(random, n);
        double length = across(random, shortest, 32767);
        set_normal(mesh, i, n, length);
    }
}

static void random_colours(random_mesh *mesh, source *random) {
    for (uint32_t i = 0; i < mesh->mesh.vertex_count; i++) {
        for (int channel = 0; channel < 3; channel++)
            mesh->colours[i][channel] = (uint8_t)below(random, 256);
    }
    mesh->mesh.colours = (const uint8_t(*)[3])mesh->colours;
}

/* ---- Poses --------------------------------------------------------------------------------------------------- */

static void scale_columns(glint_pose *pose, double x, double y, double z) {
    const double scale[3] = {x, y, z};
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++)
            pose->m[row][column] = (glint_q16)lrint(pose->m[row][column] * scale[column]);
    }
}

static glint_pose random_turn(source *random) {
    const glint_pose x = glint_pose_rotate_x(q16(between(random, 0, 360)));
    const glint_pose y = glint_pose_rotate_y(q16(between(random, 0, 360)));
    const glint_pose z = glint_pose_rotate_z(q16(between(random, 0, 360)));
    const glint_pose xy = glint_pose_then(&x, &y);
    return glint_pose_then(&xy, &z);
}

static void move_to(glint_pose *pose, double x, double y, double z) {
    pose->m[0][3] = q16(x);
    pose->m[1][3] = q16(y);
    pose->m[2][3] = q16(z);
}

/* Half the height that the camera sees at a distance of 1. */
static double half_view(const random_scene *s) {
    return tan(s->scene.camera.field_of_view / 65536.0 * 3.14159265358979323846 / 360);
}

/* Turned, scaled by 0.5 to 1.5, on the screen: as large as some of it. Camera space, as all poses until the end. */
static void place_at_random(random_scene *s, uint32_t object, source *random) {
    glint_pose *pose = &s->objects[object].pose;
    double size = between(random, 0.5, 1.5);
    double distance = size * (1.5 + between(random, 0.4, 1.5) / half_view(s));
    double reach = 0.6 * distance * half_view(s);
    *pose = random_turn(random);
    scale_columns(pose, size, size, size);
    double x = between(random, -reach, reach);
    move_to(pose, x, between(random, -reach, reach), -distance);
}

/* ---- Lights and materials ------------------------------------------------------------------------------------ */

static void make_directional(glint_light *light, source *random) {
    double v[3];
    direction(random, v);
    if (one_in(random, 2))
        v[2] = fabs(v[2]); /* more often from the viewer's side */
    light->type = &glint_light_directional;
    light->direction = vector(-v[0], -v[1], -v[2]);
}

/* Near the first object's centre, outside of it more often than not. */
static void make_point(random_scene *s, glint_light *light, source *random, double least, double most) {
    const glint_pose *near = &s->objects[0].pose;
    double reach = across(random, least, most);
    double v[3];
    direction(random, v);
    light->type = &glint_light_point;
    light->position = vector(near->m[0][3] / 65536.0 + reach * v[0], near->m[1][3] / 65536.0 + reach * v[1],
                             near->m[2][3] / 65536.0 + reach * fabs(v[2]));
    light->linear = one_in(random, 2) ? q16(across(random, 0.01, 4)) : 0;
    light->quadratic = one_in(random, 2) ? q16(across(random, 0.01, 4)) : 0;
}

/* Pointing at the first object; the step is a quarter of a degree or more, or none at all. */
static void make_spot(random_scene *s, glint_light *light, source *random) {
    const glint_pose *near = &s->objects[0].pose;
    make_point(s, light, random, 1, 6);
    light->type = &glint_light_spot;
    light->direction.x = near->m[0][3] - light->position.x + q16(between(random, -0.3, 0.3));
    light->direction.y = near->m[1][3] - light->position.y + q16(between(random, -0.3, 0.3));
    light->direction.z = near->m[2][3] - light->position.z + q16(between(random, -0.3, 0.3));
    light->inner = q16(between(random, 0, 40));
    light->outer = light->inner + (one_in(random, 4) ? 0 : q16(across(random, 0.25, 40)));
}

static void make_light(random_scene *s, glint_light *light, source *random) {
    light->diffuse = colour(random, 1);
    light->specular = colour(random, 1);
    switch (below(random, 4)) {
    case 0:
        make_point(s, light, random, 0.8, 20);
        break;
    case 1:
        make_spot(s, light, random);
        break;
    default:
        make_directional(light, random);
    }
}

static void make_material(glint_material *material, source *random) {
    static const glint_shading_model *const models[8] = {
        &glint_model_blinn_phong, &glint_model_blinn_phong, &glint_model_blinn_phong, &glint_model_blinn_phong,
        &glint_model_blinn_phong, &glint_model_phong,       &glint_model_phong,       &glint_model_lambert};
    material->model = one_in(random, 40) ? &glint_model_unlit : models[below(random, 8)];
    material->ambient = colour(random, 0.3);
    material->diffuse = colour(random, 1);
    material->specular = colour(random, 1);
    material->shininess = q16(across(random, 1, 1024));
    material->flags = one_in(random, 4) ? below(random, 4) : 0;
}

static void scale_colour(glint_colour *c, double factor) {
    c->r = (glint_q16)floor(c->r * factor);
    c->g = (glint_q16)floor(c->g * factor);
    c->b = (glint_q16)floor(c->b * factor);
}

/* Weights of diffuse and specular light summing to at most `most` in each channel. */
static void limit_weights(random_scene *s, double most) {
    for (uint32_t i = 0; i < s->scene.object_count; i++) {
        double sum = weights_sum(&s->scene, &s->materials[i]);
        if (sum > most) {
            scale_colour(&s->materials[i].diffuse, most / sum);
            scale_colour(&s->materials[i].specular, most / sum);
        }
    }
}

/* ---- Regions ------------------------------------------------------------------------------------------------- */

static void make_plain(random_scene *s, source *random) {
    (void)s;
    (void)random;
}

static void make_loose_triangles(random_scene *s, source *random) {
    make_triangles(&s->meshes[0], random, 1 + below(random, 20));
    lean_normals(&s->meshes[0], random, between(random, 0, 0.6));
}

static void make_odd_normals(random_scene *s, source *random) {
    if (one_in(random, 2))
        make_square(&s->meshes[0], random, 0);
    random_normals(&s->meshes[0], random, 64);
    lean_normals(&s->meshes[0], random, between(random, 0.6, 1.1));
}

static void make_opposed_normals(random_scene *s, source *random) {
    if (one_in(random, 2))
        make_square(&s->meshes[0], random, 0);
    else
        make_triangles(&s->meshes[0], random, 1 + below(random, 8));
    random_normals(&s->meshes[0], random, 300);
}

static void make_sliver_scene(random_scene *s, source *random) {
    make_slivers(&s->meshes[0], random);
}

static void make_tiny(random_scene *s, source *random) {
    for (uint32_t i = 0; i < s->scene.object_count; i++) {
        glint_pose *pose = &s->objects[i].pose;
        double size = across(random, 0.01, 0.2);
        scale_columns(pose, size, size, size);
    }
}

/*
 * The eye beside or inside the object, or a square through the near plane and far beyond the screen. Alone: a cut
 * corner is rounded apart by library and reference, and with it the depth by what it changes in a sixteenth of a pixel.
 */
static void make_crossing(random_scene *s, source *random) {
    glint_pose *pose = &s->objects[0].pose;
    if (one_in(random, 2))
        make_square(&s->meshes[0], random, between(random, 0, 0.5));
    double size = across(random, 0.5, 40);
    *pose = random_turn(random);
    scale_columns(pose, size, size, size);
    double reach = 0.7 * size;
    double x = between(random, -reach, reach);
    double y = between(random, -reach, reach);
    move_to(pose, x, y, between(random, -1.5 * size, 0));
    s->meshes[0].mesh.flags = below(random, 2);
    s->scene.object_count = 1;
    s->scene.camera.near_plane = q16(across(random, 0.01, 0.5) * size);
}

static void make_extreme_poses(random_scene *s, source *random) {
    for (uint32_t i = 0; i < s->scene.object_count; i++) {
        double scale[3];
        for (int axis = 0; axis < 3; axis++) {
            scale[axis] = across(random, 0.01, 1);
            scale[axis] *= one_in(random, 2) ? -1 : 1;
        }
        scale[below(random, 3)] = 1;
        scale_columns(&s->objects[i].pose, scale[0], scale[1], scale[2]);
    }
}

static void make_near_lights(random_scene *s, source *random) {
    for (uint32_t i = 0; i < s->scene.light_count; i++)
        make_point(s, &s->lights[i], random, 0.01, 1.2);
    if (one_in(random, 3))
        s->lights[0].position = vector(0, 0, 0); /* at the eye */
}

static void make_spots(random_scene *s, source *random) {
    for (uint32_t i = 0; i < s->scene.light_count; i++)
        make_spot(s, &s->lights[i], random);
}

/* The sums from 1 to 16; products stay within what the library takes. */
static void make_bright(random_scene *s, source *random) {
    double most = across(random, 1, 16);
    for (uint32_t i = 0; i < s->scene.object_count; i++) {
        scale_colour(&s->materials[i].diffuse, 16);
        scale_colour(&s->materials[i].specular, 16);
    }
    limit_weights(s, most);
}

/* A strip that runs from one unit before the eye to up to 1000 away. */
static void make_deep(random_scene *s, source *random) {
    double length = across(random, 20, 500);
    double height = between(random, 0.15, 0.4) * half_view(s);
    glint_pose *pose = &s->objects[0].pose;
    make_square(&s->meshes[0], random, between(random, 0, 0.4));
    const glint_pose down = glint_pose_rotate_x(-90 * GLINT_ONE);
    const glint_pose turn = glint_pose_rotate_z(q16(between(random, -180, 180)));
    glint_pose flat = down;
    flat.m[1][3] = -q16(height);
    *pose = glint_pose_then(&flat, &turn);
    scale_columns(pose, across(random, 0.3, 30), length, 1);
    pose->m[2][3] = q16(-length - across(random, 0.5, 1));
    s->scene.object_count = 1;
}

static void set_low_exponent(glint_material *material, double p, source *random) {
    material->shininess = q16(p);
    material->model = one_in(random, 2) ? &glint_model_phong : &glint_model_blinn_phong;
    material->flags = below(random, 2) ? GLINT_MATERIAL_SPECULAR_UNGATED : 0;
}

static void make_lowest_exponents(random_scene *s, source *random) {
    static const double exact[3] = {0, 0.5, 1.0 / 65536};
    for (uint32_t i = 0; i < s->scene.object_count; i++) {
        double p = one_in(random, 3) ? exact[below(random, 3)] : between(random, 0, 1);
        set_low_exponent(&s->materials[i], p, random);
    }
}

static void make_low_exponents(random_scene *s, source *random) {
    for (uint32_t i = 0; i < s->scene.object_count; i++) {
        double p = one_in(random, 3) ? 1 + below(random, 2) : between(random, 1, 2.5);
        set_low_exponent(&s->materials[i], p, random);
    }
}

static void make_high_exponents(random_scene *s, source *random) {
    for (uint32_t i = 0; i < s->scene.object_count; i++) {
        s->materials[i].shininess = one_in(random, 8) ? INT32_MAX : q16(across(random, 1024, 32767));
        s->materials[i].model = &glint_model_blinn_phong;
    }
}

/* From behind, within a few degrees of straight against the view, and from straight before. */
static void make_opposed_lights(random_scene *s, source *random) {
    for (uint32_t i = 0; i < s->scene.light_count; i++) {
        double off = one_in(random, 4) ? 0 : across(random, 0.001, 0.3);
        double around = between(random, 0, 6.283185307179586);
        s->lights[i].type = &glint_light_directional;
        s->lights[i].direction = vector(-off * cos(around), -off * sin(around), one_in(random, 4) ? -1 : 1);
    }
    for (uint32_t i = 0; i < s->scene.object_count; i++)
        s->materials[i].flags = below(random, 2) ? GLINT_MATERIAL_SPECULAR_UNGATED : 0;
}

/* Objects through one another. */
static void make_crowd(random_scene *s, source *random) {
    s->scene.object_count = 3;
    for (uint32_t i = 1; i < 3; i++) {
        s->objects[i].pose.m[0][3] = s->objects[0].pose.m[0][3] + q16(between(random, -0.3, 0.3));
        s->objects[i].pose.m[1][3] = s->objects[0].pose.m[1][3] + q16(between(random, -0.3, 0.3));
        s->objects[i].pose.m[2][3] = s->objects[0].pose.m[2][3] + q16(between(random, -0.3, 0.3));
    }
}

static void make_odd_screen(random_scene *s, source *random) {
    if (one_in(random, 2))
        s->width = 1 + (int)below(random, 9);
    else
        s->height = 1 + (int)below(random, 9);
}

/* Depths that 16 fractional bits and a range of 2^17 leave: from 2^-16 to near 2^17. */
#define LEAST_DEPTH (1.0 / 65536)
#define MOST_DEPTH 125000.0

/* Makes a mesh `size` times as large and moves it aside and straight ahead, in object space: poses move by 2^15 only.
 */
static void resize(glint_mesh *mesh, double size, double aside, double ahead) {
    mesh->extent.x = q16(mesh->extent.x / 65536.0 * size) + 1;
    mesh->extent.y = q16(mesh->extent.y / 65536.0 * size) + 1;
    mesh->extent.z = q16(mesh->extent.z / 65536.0 * size) + 1;
    mesh->offset = vector(aside, 0, -ahead);
}

/* Puts an object before the eye, as large on the screen at any distance. */
static void place_far(random_scene *s, uint32_t object, double distance, source *random) {
    const double size = distance / (1.5 + between(random, 0.6, 2) / half_view(s));
    const double aside = between(random, 0.2, 0.8) * distance * half_view(s);
    const double up = distance > 20000 ? 8 : 1; /* an offset goes to 2^15, a place to 2^17 */
    glint_pose *pose = &s->objects[object].pose;
    *pose = glint_pose_rotate_z(q16(between(random, 0, 360)));
    scale_columns(pose, up, up, up);
    resize(&s->meshes[object].mesh, size / up, aside / up, distance / up);
}

/*
 * The first object near the near plane, and the others up to 2^33 times as far as that plane. Or a single one around
 * the eye, up to 2^20 times as far: beyond, what is cut at the near plane leaves the reference's range.
 */
static void make_far(random_scene *s, source *random) {
    const double ratio = across(random, 256, MOST_DEPTH / LEAST_DEPTH);
    const double near_plane = across(random, LEAST_DEPTH, MOST_DEPTH / ratio);
    const double far = ratio * near_plane;
    s->scene.camera.near_plane = q16(near_plane);
    if (one_in(random, 2) && ratio < 1 << 20 && far < 20000) {
        s->scene.object_count = 1;
        s->meshes[0].mesh.flags = GLINT_MESH_DOUBLE_SIDED;
        s->objects[0].pose = random_turn(random);
        resize(&s->meshes[0].mesh, far, 0, 0);
        return;
    }
    s->scene.object_count = 2 + below(random, 2);
    place_far(s, 0, (10 + 2 / half_view(s)) * near_plane, random);
    for (uint32_t i = 1; i < s->scene.object_count; i++)
        place_far(s, i, far * across(random, 0.1, 1), random);
}

/* ---- Large triangles --------------------------------------------------------------------------------------------- */

/* A lamp a little above an object, or inside it, or with the edge of its cone across it. */
static void make_lamp_by_object(random_scene *s, glint_light *light, source *random) {
    const double half = across(random, 1, 40);
    if (one_in(random, 2)) {
        make_point(s, light, random, 0.02, 4);
        return;
    }
    make_spot(s, light, random);
    light->inner = one_in(random, 3) ? q16(half) : q16(half * between(random, 0, 1));
    light->outer = q16(half) + (one_in(random, 4) ? 0 : q16(1));
}

/* As large as the screen, with up to all lights that a scene may have. */
static void make_large(random_scene *s, source *random) {
    static const int most[3] = {2, 4, GLINT_LIGHTS_MAX};
    const uint32_t kind = below(random, 4);
    glint_pose *pose = &s->objects[0].pose;
    s->scene.object_count = 1 + below(random, 2);
    if (kind == 0)
        make_square(&s->meshes[0], random, between(random, 0, 0.5));
    else if (kind == 1)
        make_loose_triangles(s, random);
    else if (kind == 2 && one_in(random, 2))
        make_slivers(&s->meshes[0], random);
    *pose = random_turn(random);
    move_to(pose, 0, 0, -between(random, 1.2, 3) / half_view(s) - 0.5);
    if (one_in(random, 3))
        s->meshes[0].mesh.flags = GLINT_MESH_DOUBLE_SIDED;
    if (one_in(random, 3))
        random_colours(&s->meshes[0], random);
    s->scene.light_count = 1 + below(random, (uint32_t)most[below(random, 3)]);
    for (uint32_t i = 0; i < s->scene.light_count; i++) {
        make_light(s, &s->lights[i], random);
        if (one_in(random, 2))
            make_lamp_by_object(s, &s->lights[i], random);
    }
    for (uint32_t i = 0; i < s->scene.object_count; i++)
        s->materials[i].flags = below(random, 2) ? below(random, 4) : 0;
    s->width += 64;
    s->height += 64;
}

/* The same with every exponent that there is. */
static void make_large_of_any_exponent(random_scene *s, source *random) {
    make_large(s, random);
    for (uint32_t i = 0; i < s->scene.object_count; i++)
        s->materials[i].shininess = one_in(random, 2) ? q16(between(random, 0, 1)) : q16(across(random, 1, 32767));
}

/* ---- Rooms and terrains ------------------------------------------------------------------------------------------ */

/* What is much larger than the near plane, from 1/65536 to as far from the eye as coordinates reach. */
typedef struct deep_place {
    double size;      /* half of the largest side */
    double near;      /* plane */
    double centre[3]; /* from the eye, in the mesh's own axes */
} deep_place;

/* The largest half side, so that a corner is at most 2^17 away along each axis. */
#define MOST_SIZE 60000.0

/* Numbers of offsets and extents go to 2^15: the pose is to scale what is larger. */
static double scale_of(const deep_place *place) {
    return place->size > 8000 ? 8 : 1;
}

/* The eye is no nearer to a surface: places are known to some 2^-27 of an object's size (glint.h). */
static double least_way(const deep_place *place) {
    return fmax(64 * place->near, place->size / 65536);
}

static deep_place take_place(random_scene *s, source *random) {
    deep_place place = {.size = across(random, 1, MOST_SIZE)};
    place.near = one_in(random, 3) ? LEAST_DEPTH : across(random, LEAST_DEPTH, place.size / 256);
    s->scene.camera.near_plane = q16(place.near);
    return place;
}

/* Lets a mesh of all steps reach `half` of the place's size along each axis, with the eye where the place says. */
static void put_around_eye(random_scene *s, const deep_place *place, const double half[3], const glint_pose *turn) {
    const double up = scale_of(place);
    glint_mesh *mesh = &s->meshes[0].mesh;
    mesh->extent = vector(half[0] * place->size / up, half[1] * place->size / up, half[2] * place->size / up);
    mesh->offset = vector(place->centre[0] / up, place->centre[1] / up, place->centre[2] / up);
    s->objects[0].pose = *turn;
    scale_columns(&s->objects[0].pose, up, up, up);
}

/* An upright eye that looks around, up or down a little, or one that lies anyhow. */
static glint_pose look_around(source *random) {
    if (one_in(random, 4))
        return random_turn(random);
    const glint_pose around = glint_pose_rotate_y(q16(between(random, 0, 360)));
    const glint_pose tilt = glint_pose_rotate_x(q16(between(random, -30, 30)));
    return glint_pose_then(&around, &tilt);
}

/* What all such scenes share: objects in the room, or one by the eye and the near plane, each evaluation, colours, and
 * lamps as far as the room is large. */
static void furnish(random_scene *s, const deep_place *place, source *random) {
    static const glint_evaluation *const evaluations[3] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    s->scene.object_count = 1 + below(random, RANDOM_OBJECTS_MAX);
    for (uint32_t i = 1; i < s->scene.object_count; i++)
        if (one_in(random, 3)) /* depth is relative to the nearest */
            place_far(s, i, fmin(100000, (10 + 2 / half_view(s)) * place->near * across(random, 1, 256)), random);
        else
            place_far(s, i, place->size * across(random, 0.01, 0.5), random);
    for (uint32_t i = 0; i < s->scene.object_count; i++) {
        s->objects[i].evaluation = evaluations[below(random, 3)];
        if (one_in(random, 2))
            random_colours(&s->meshes[i], random);
    }
    for (uint32_t i = 0; i < s->scene.light_count; i++) {
        glint_light *light = &s->lights[i];
        if (light->type == &glint_light_directional)
            continue;
        const double reach = fmin(place->size, 12000); /* positions go to 2^15, and the eye is up to 5000 away */
        const double x = between(random, -reach, reach);
        const double y = between(random, -reach, reach);
        light->position = vector(x, y, between(random, -reach, reach));
        light->linear = q16(light->linear / 65536.0 / reach);
        light->quadratic = q16(light->quadratic / 65536.0 / reach / reach);
    }
}

/* A closed room with the eye in it, one time in four by a wall. */
static void make_room(random_scene *s, source *random) {
    deep_place place = take_place(s, random);
    const glint_mesh_room room = room_of(&s->meshes[0]);
    double half[3];
    for (int axis = 0; axis < 3; axis++) {
        half[axis] = axis ? across(random, 0.1, 1) : 1;
        place.centre[axis] = between(random, -0.8, 0.8) * half[axis] * place.size;
    }
    if (one_in(random, 4))
        place.centre[below(random, 2)] =
            place.size * half[1] - across(random, least_way(&place), 0.5 * half[1] * place.size);
    own_arrays(&s->meshes[0], 0, 0);
    grid_add_room(&s->meshes[0].mesh, &room, 1 + below(random, 2));
    const glint_pose turn = look_around(random);
    put_around_eye(s, &place, half, &turn);
    furnish(s, &place, random);
}

/* A terrain, or one time in two a flat floor, to the horizon below the eye. */
static void make_terrain(random_scene *s, source *random) {
    deep_place place = take_place(s, random);
    const glint_mesh_room room = room_of(&s->meshes[0]);
    random_mesh *mesh = &s->meshes[0];
    const double height = across(random, 0.001, 0.2), above = across(random, least_way(&place), 0.3 * place.size);
    const double half[3] = {1, height, 1};
    own_arrays(mesh, 0, 0);
    grid_add_terrain(&mesh->mesh, &room, 1 + below(random, 6));
    if (one_in(random, 2)) {
        for (uint32_t i = 0; i < mesh->mesh.vertex_count; i++)
            mesh->positions[i][1] = (int16_t)lrint(between(random, -32767, 32767));
        lean_normals(mesh, random, between(random, 0, 0.4));
    }
    place.centre[0] = between(random, -0.8, 0.8) * place.size;
    place.centre[1] = -above;
    place.centre[2] = between(random, -0.8, 0.8) * place.size;
    mesh->mesh.flags = below(random, 2);
    const glint_pose turn = look_around(random);
    put_around_eye(s, &place, half, &turn);
    furnish(s, &place, random);
}

/* ---- All regions --------------------------------------------------------------------------------------------- */

typedef struct region_maker {
    void (*make)(random_scene *s, source *random);
    int weights_left; /* not limited afterwards */
} region_maker;

const random_region random_regions[] = {
    {"plain scenes", 1},
    {"loose triangles", 1},
    {"leaning normals", 1},
    {"opposed normals", 1},
    {"slivers", 1},
    {"tiny triangles", 1},
    {"near plane and guard band", 1},
    {"scales of 1:100 and mirrors", 1},
    {"lights at the surface", 1},
    {"spots", 1},
    {"sums above 1", 1},
    {"w ratios to 1:1000", 1},
    {"p from 0 to 1", 0},
    {"p from 1 to 2.5", 1},
    {"p from 1024 up", 0},
    {"lights from behind", 1},
    {"crossing objects", 1},
    {"odd screens", 1},
    {"depth ratios to 2^33", 1},
    {"large triangles", 1},
    {"large triangles of any p", 0},
    {"rooms", 1},
    {"terrains", 1},
    {"textures", 1},
};
const unsigned random_region_count = sizeof random_regions / sizeof random_regions[0];

static const region_maker makers[] = {
    {make_plain, 0},
    {make_loose_triangles, 0},
    {make_odd_normals, 0},
    {make_opposed_normals, 0},
    {make_sliver_scene, 0},
    {make_tiny, 0},
    {make_crossing, 0},
    {make_extreme_poses, 0},
    {make_near_lights, 0},
    {make_spots, 0},
    {make_bright, 1},
    {make_deep, 0},
    {make_lowest_exponents, 0},
    {make_low_exponents, 0},
    {make_high_exponents, 0},
    {make_opposed_lights, 0},
    {make_crowd, 0},
    {make_odd_screen, 0},
    {make_far, 0},
    {make_large, 0},
    {make_large_of_any_exponent, 0},
    {make_room, 0},
    {make_terrain, 0},
};

/* ---- Scene --------------------------------------------------------------------------------------------------- */

static void make_camera(random_scene *s, source *random) {
    glint_camera *camera = &s->scene.camera;
    camera->pose = glint_pose_identity();
    camera->field_of_view = q16(between(random, 15, 90));
    camera->near_plane = q16(0.1);
    if (one_in(random, 3))
        return;
    double reach = across(random, 1, 5000);
    double v[3];
    direction(random, v);
    const glint_vector eye = vector(reach * v[0], reach * v[1], reach * v[2]);
    direction(random, v);
    const glint_vector at = {eye.x + q16(10 * v[0]), eye.y + q16(10 * v[1]), eye.z + q16(10 * v[2])};
    const glint_vector up = fabs(v[1]) < 0.9 ? vector(0, 1, 0) : vector(1, 0, 0);
    glint_camera_look_at(camera, eye, at, up);
}

static void make_screen(random_scene *s, source *random) {
    static const uint16_t tiles[4] = {8, 16, 32, 64};
    const glint_format *const formats[4] = {&glint_format_rgb565, &glint_format_rgb565, &glint_format_rgb888,
                                            &glint_format_grey8};
    s->width = 16 + (int)below(random, 49);
    s->height = 16 + (int)below(random, 33);
    s->tile_width = tiles[below(random, 4)];
    s->tile_height = tiles[below(random, 4)];
    s->format = formats[below(random, 4)];
}

static void make_object(random_scene *s, uint32_t i, source *random) {
    const glint_evaluation *const evaluations[8] = {&glint_per_fragment, &glint_per_fragment, &glint_per_fragment,
                                                    &glint_per_fragment, &glint_per_fragment, &glint_per_fragment,
                                                    &glint_per_vertex,   &glint_per_facet};
    make_solid(&s->meshes[i], random);
    make_material(&s->materials[i], random);
    s->objects[i].mesh = &s->meshes[i].mesh;
    s->objects[i].material = &s->materials[i];
    s->objects[i].evaluation = evaluations[below(random, 8)];
    place_at_random(s, i, random);
}

/* From camera space to the world. */
static void to_world(random_scene *s) {
    const glint_pose *camera = &s->scene.camera.pose;
    for (uint32_t i = 0; i < s->scene.object_count; i++)
        s->objects[i].pose = glint_pose_then(&s->objects[i].pose, camera);
    for (uint32_t i = 0; i < s->scene.light_count; i++) {
        glint_light *light = &s->lights[i];
        const glint_vector p = light->position;
        const glint_vector d = light->direction;
        int32_t position[3];
        int32_t direction[3];
        for (int row = 0; row < 3; row++) {
            const double m[3] = {camera->m[row][0] / 65536.0, camera->m[row][1] / 65536.0, camera->m[row][2] / 65536.0};
            position[row] = (int32_t)lrint(m[0] * p.x + m[1] * p.y + m[2] * p.z) + camera->m[row][3];
            direction[row] = (int32_t)lrint(m[0] * d.x + m[1] * d.y + m[2] * d.z);
        }
        light->position = (glint_vector){position[0], position[1], position[2]};
        light->direction = (glint_vector){direction[0], direction[1], direction[2]};
    }
}

void random_scene_wear(random_scene *s, uint64_t seed) {
    source random = {~seed};
    for (uint32_t i = 0; i < s->scene.object_count; i++) {
        random_mesh *const mesh = &s->meshes[i];
        if (one_in(&random, 4))
            continue;
        random_texture_dress(&mesh->mesh, mesh->texture_coordinates, &s->materials[i], &s->textures[i], &random);
    }
}

/* The region whose scenes a seed gives textures: any whose exponents keep to the contract. */
static unsigned find_bare_region(uint64_t seed) {
    unsigned region = (unsigned)(seed / 4 % RANDOM_TEXTURED_REGION);
    while (!random_regions[region].in_contract)
        region--;
    return region;
}

void random_scene_make_in(random_scene *s, unsigned region, uint64_t seed) {
    const region_maker *const maker = &makers[region == RANDOM_TEXTURED_REGION ? find_bare_region(seed) : region];
    source random = {seed};
    memset(s, 0, sizeof *s);
    s->seed = seed;
    s->region = region;
    make_camera(s, &random);
    make_screen(s, &random);
    s->scene.objects = s->objects;
    s->scene.lights = s->lights;
    s->scene.object_count = 1 + below(&random, 2);
    s->scene.light_count = 1 + below(&random, RANDOM_LIGHTS_MAX - 1);
    s->scene.viewer = one_in(&random, 2) ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
    s->scene.background = (glint_colour){q16(0.2), q16(0.4), q16(0.2)}; /* far from halfway between steps */
    s->scene.ambient = colour(&random, 1);
    for (uint32_t i = 0; i < RANDOM_OBJECTS_MAX; i++)
        make_object(s, i, &random);
    for (uint32_t i = 0; i < s->scene.light_count; i++)
        make_light(s, &s->lights[i], &random);
    maker->make(s, &random);
    if (!maker->weights_left)
        limit_weights(s, one_in(&random, 4) ? across(&random, 1, 2.5) : 1);
    for (uint32_t i = 0; i < s->scene.object_count; i++) {
        if (one_in(&random, 6))
            random_colours(&s->meshes[i], &random);
    }
    to_world(s);
    if (region == RANDOM_TEXTURED_REGION)
        random_scene_wear(s, seed);
}

void random_scene_make(random_scene *s, uint64_t seed) {
    random_scene_make_in(
        s, (unsigned)(seed % 4 == 3 ? RANDOM_DEEP_REGION + seed / 4 % RANDOM_DEEP_REGIONS : seed % RANDOM_DEEP_REGION),
        seed);
}

/* Adds numbers of `each` bytes. */
static uint64_t add(uint64_t sum, const void *bytes, size_t size, size_t each) {
    const size_t flip = byte_order_flip(each);
    for (size_t i = 0; i < size; i++)
        sum = (sum ^ ((const uint8_t *)bytes)[i ^ flip]) * 1099511628211u;
    return sum;
}

uint64_t random_scene_checksum(const random_scene *s) {
    uint64_t sum = 14695981039346656037u;
    sum = add(sum, &s->scene.camera, offsetof(glint_camera, projection), 4); /* always in perspective */
    for (uint32_t i = 0; i < s->scene.object_count; i++) {
        const random_mesh *mesh = &s->meshes[i];
        sum = add(sum, mesh->positions, sizeof mesh->positions, 2);
        sum = add(sum, mesh->normals, sizeof mesh->normals, 2);
        sum = add(sum, mesh->triangles, sizeof mesh->triangles, 2);
        sum = add(sum, mesh->colours, sizeof mesh->colours, 1);
        sum = add(sum, &s->objects[i].pose, sizeof s->objects[i].pose, 4);
        sum = add(sum, &s->materials[i].ambient, 3 * sizeof(glint_colour), 4);
        sum = add(sum, &s->materials[i].shininess, sizeof s->materials[i].shininess, 4);
    }
    for (uint32_t i = 0; i < s->scene.light_count; i++) {
        const glint_light *light = &s->lights[i];
        const glint_vector d = light->direction, towards = {-d.x, -d.y, -d.z};
        sum = add(sum, light->type == &glint_light_directional ? &towards : &light->position, sizeof towards, 4);
    }
    return sum;
}
