/* SPDX-License-Identifier: MIT */
#include "bench.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

const bench_definition bench_definitions[BENCH_SCENES] = {
    {"torus2304", BENCH_TORUS, 48, 24, 3.7},
    {"torus576", BENCH_TORUS, 24, 12, 3.7},
    {"torus9216", BENCH_TORUS, 96, 48, 3.7},
    {"sphere960", BENCH_SPHERE, 32, 16, 2.9},
};

glint_q16 bench_q16(double value) {
    return (glint_q16)lrint(value * 65536.0);
}

/* The nearest step of int16 for `value` in units of `full`, which is 32768 steps; +full itself is the last step. */
static int16_t quantise(double value, double full) {
    long steps = lrint(value / full * 32768.0);
    return (int16_t)(steps > 32767 ? 32767 : steps);
}

static void put_vertex(bench_mesh *mesh, const double position[3], const double normal[3]) {
    uint32_t index = mesh->mesh.vertex_count++;
    const glint_vector *extent = &mesh->mesh.extent;
    const glint_q16 extents[3] = {extent->x, extent->y, extent->z};
    for (int axis = 0; axis < 3; axis++) {
        mesh->positions[index][axis] = quantise(position[axis], extents[axis] / 65536.0);
        mesh->normals[index][axis] = (int16_t)lrint(normal[axis] * 32767.0);
    }
}

static void put_triangle(bench_mesh *mesh, uint32_t a, uint32_t b, uint32_t c) {
    uint16_t *triangle = mesh->triangles[mesh->mesh.triangle_count++];
    triangle[0] = (uint16_t)a;
    triangle[1] = (uint16_t)b;
    triangle[2] = (uint16_t)c;
}

static void build_torus(bench_mesh *mesh, uint32_t around, uint32_t along) {
    const double ring = 1.0;
    const double tube = 0.4;
    mesh->mesh.extent = (glint_vector){bench_q16(1.5), bench_q16(1.5), bench_q16(0.5)};
    for (uint32_t i = 0; i < around; i++) {
        double u = 2 * pi * i / around;
        for (uint32_t j = 0; j < along; j++) {
            double v = 2 * pi * j / along;
            double normal[3] = {cos(v) * cos(u), cos(v) * sin(u), sin(v)};
            double out = ring + tube * cos(v);
            double position[3] = {out * cos(u), out * sin(u), tube * sin(v)};
            put_vertex(mesh, position, normal);
        }
    }
    for (uint32_t i = 0; i < around; i++) {
        for (uint32_t j = 0; j < along; j++) {
            uint32_t next_i = (i + 1) % around;
            uint32_t next_j = (j + 1) % along;
            put_triangle(mesh, i * along + j, next_i * along + j, next_i * along + next_j);
            put_triangle(mesh, i * along + j, next_i * along + next_j, i * along + next_j);
        }
    }
}

/* The north pole is vertex 0, the ring r of along - 1 begins at 1 + r * around, the south pole is last. */
static void build_sphere_triangles(bench_mesh *mesh, uint32_t around, uint32_t along) {
    uint32_t last_ring = 1 + (along - 2) * around;
    uint32_t south = last_ring + around;
    for (uint32_t i = 0; i < around; i++) {
        uint32_t next = (i + 1) % around;
        put_triangle(mesh, 0, 1 + i, 1 + next);
        for (uint32_t ring = 0; ring + 2 < along; ring++) {
            uint32_t upper = 1 + ring * around;
            uint32_t lower = upper + around;
            put_triangle(mesh, upper + i, lower + i, lower + next);
            put_triangle(mesh, upper + i, lower + next, upper + next);
        }
        put_triangle(mesh, last_ring + i, south, last_ring + next);
    }
}

static void build_sphere(bench_mesh *mesh, uint32_t around, uint32_t along) {
    const double north[3] = {0, 0, 1};
    const double south[3] = {0, 0, -1};
    mesh->mesh.extent = (glint_vector){bench_q16(1.0625), bench_q16(1.0625), bench_q16(1.0625)};
    put_vertex(mesh, north, north);
    for (uint32_t ring = 1; ring < along; ring++) {
        double polar = pi * ring / along;
        for (uint32_t i = 0; i < around; i++) {
            double u = 2 * pi * i / around;
            double normal[3] = {sin(polar) * cos(u), sin(polar) * sin(u), cos(polar)};
            put_vertex(mesh, normal, normal);
        }
    }
    put_vertex(mesh, south, south);
    build_sphere_triangles(mesh, around, along);
}

void bench_build_mesh(bench_mesh *mesh, bench_shape shape, uint32_t around, uint32_t along) {
    mesh->mesh = (glint_mesh){0};
    mesh->mesh.positions = (const int16_t(*)[3])mesh->positions;
    mesh->mesh.normals = (const int16_t(*)[3])mesh->normals;
    mesh->mesh.triangles = (const uint16_t(*)[3])mesh->triangles;
    if (shape == BENCH_TORUS)
        build_torus(mesh, around, along);
    else
        build_sphere(mesh, around, along);
}

glint_pose bench_turn(double about_x, double about_y) {
    double cx = cos(about_x);
    double sx = sin(about_x);
    double cy = cos(about_y);
    double sy = sin(about_y);
    const double turn[3][3] = {{cy, 0, sy}, {sx * sy, cx, -sx * cy}, {-cx * sy, sx, cx * cy}};
    glint_pose pose = {{{0}}};
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++)
            pose.m[row][column] = bench_q16(turn[row][column]);
    }
    return pose;
}

static glint_colour scaled(const double base[3], double scale) {
    return (glint_colour){bench_q16(base[0] * scale), bench_q16(base[1] * scale), bench_q16(base[2] * scale)};
}

void bench_build_scene(bench_scene *scene, const bench_definition *definition, const bench_mesh *mesh, int frame) {
    static const double base[3] = {0.9, 0.5, 0.3};
    static const double white[3] = {1, 1, 1};
    scene->material = (glint_material){.model = &glint_model_blinn_phong,
                                       .ambient = scaled(base, 0.15),
                                       .diffuse = scaled(base, 0.85),
                                       .specular = scaled(white, 0.5),
                                       .shininess = 32 * GLINT_ONE};
    scene->light = (glint_light){.type = &glint_light_directional,
                                 .direction = {bench_q16(-0.4), bench_q16(-0.6), bench_q16(-0.7)},
                                 .diffuse = scaled(white, 1),
                                 .specular = scaled(white, 1)};
    scene->object = (glint_object){.mesh = &mesh->mesh,
                                   .material = &scene->material,
                                   .evaluation = &glint_per_fragment,
                                   .pose = bench_turn(-0.9 + 0.04 * frame, 0.3 + 0.1 * frame)};
    scene->object.pose.m[2][3] = bench_q16(-definition->distance);
    scene->scene = (glint_scene){.camera = {.field_of_view = 60 * GLINT_ONE, .near_plane = GLINT_ONE / 10},
                                 .viewer = GLINT_VIEWER_LOCAL,
                                 .ambient = scaled(white, 1),
                                 .lights = &scene->light,
                                 .light_count = 1,
                                 .objects = &scene->object,
                                 .object_count = 1};
    for (int axis = 0; axis < 3; axis++)
        scene->scene.camera.pose.m[axis][axis] = GLINT_ONE;
}
