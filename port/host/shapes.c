/* SPDX-License-Identifier: MIT */
#include "model.h"

#include "basics.h"
#include "quantise.h"
#include "values.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Largest size that the library generates. */
#define SIZE_LARGEST 8192.0

/** Largest count: the library checks the vertices. */
#define COUNT_LARGEST 65536

/* ---- The library's generators ----------------------------------------------------------------------------------- */

static glint_status torus(glint_mesh *mesh, const glint_mesh_room *room, const uint32_t counts[2],
                          const glint_q16 sizes[SHAPE_SIZES_MAX]) {
    return glint_generate_torus(mesh, room, counts[0], counts[1], sizes[0], sizes[1]);
}

static glint_status sphere(glint_mesh *mesh, const glint_mesh_room *room, const uint32_t counts[2],
                           const glint_q16 sizes[SHAPE_SIZES_MAX]) {
    return glint_generate_sphere(mesh, room, counts[0], counts[1], sizes[0]);
}

static glint_status cylinder(glint_mesh *mesh, const glint_mesh_room *room, const uint32_t counts[2],
                             const glint_q16 sizes[SHAPE_SIZES_MAX]) {
    return glint_generate_cylinder(mesh, room, counts[0], counts[1], sizes[0], sizes[1], 0);
}

static glint_status cylinder_capped(glint_mesh *mesh, const glint_mesh_room *room, const uint32_t counts[2],
                                    const glint_q16 sizes[SHAPE_SIZES_MAX]) {
    return glint_generate_cylinder(mesh, room, counts[0], counts[1], sizes[0], sizes[1], 1);
}

static glint_status cone(glint_mesh *mesh, const glint_mesh_room *room, const uint32_t counts[2],
                         const glint_q16 sizes[SHAPE_SIZES_MAX]) {
    return glint_generate_cone(mesh, room, counts[0], counts[1], sizes[0], sizes[1], 0);
}

static glint_status cone_capped(glint_mesh *mesh, const glint_mesh_room *room, const uint32_t counts[2],
                                const glint_q16 sizes[SHAPE_SIZES_MAX]) {
    return glint_generate_cone(mesh, room, counts[0], counts[1], sizes[0], sizes[1], 1);
}

static glint_status plane(glint_mesh *mesh, const glint_mesh_room *room, const uint32_t counts[2],
                          const glint_q16 sizes[SHAPE_SIZES_MAX]) {
    return glint_generate_plane(mesh, room, counts[0], counts[1], sizes[0], sizes[1]);
}

static glint_status box(glint_mesh *mesh, const glint_mesh_room *room, const uint32_t counts[2],
                        const glint_q16 sizes[SHAPE_SIZES_MAX]) {
    (void)counts;
    return glint_generate_box(mesh, room, sizes[0], sizes[1], sizes[2]);
}

const host_shape host_shapes[] = {
    {"torus",
     ":NxM[:R,r]",
     "round z, N steps round it, M round the tube; radii 1,0.4",
     {3, 3},
     2,
     SHAPE_TORUS,
     {1, 0.4, 0},
     torus},
    {"sphere",
     ":NxM[:R]",
     "N steps round z, M from pole to pole; radius 1",
     {3, 2},
     1,
     SHAPE_SPHERE,
     {1, 0, 0},
     sphere},
    {"cylinder",
     ":NxM[:R,H]",
     "open, N steps round z, M along it; radius 1, half height 1",
     {3, 1},
     2,
     SHAPE_ROUND,
     {1, 1, 0},
     cylinder},
    {"cylinder-capped", ":NxM[:R,H]", "the same with both caps", {3, 1}, 2, SHAPE_ROUND, {1, 1, 0}, cylinder_capped},
    {"cone",
     ":NxM[:R,H]",
     "open, its tip at z = H, its base at -H; radius 1, half height 1",
     {3, 1},
     2,
     SHAPE_ROUND,
     {1, 1, 0},
     cone},
    {"cone-capped", ":NxM[:R,H]", "the same with a cap", {3, 1}, 2, SHAPE_ROUND, {1, 1, 0}, cone_capped},
    {"plane",
     ":NxM[:X,Y]",
     "z = 0, N columns, M rows, seen from +z; half sizes 1,1",
     {1, 1},
     2,
     SHAPE_FLAT,
     {1, 1, 0},
     plane},
    {"box", "[:X,Y,Z]", "six faces; half sizes 1,1,1", {0, 0}, 3, SHAPE_FLAT, {1, 1, 1}, box},
    {NULL, NULL, NULL, {0, 0}, 0, SHAPE_FLAT, {0, 0, 0}, NULL},
};

/* ---- Names ------------------------------------------------------------------------------------------------------ */

const host_shape *shape_find(const char *name) {
    const size_t length = strcspn(name, ":");
    for (const host_shape *shape = host_shapes; shape->name != NULL; shape++) {
        /* A shape without counts may do without a colon; no other may, so that a file can be called torus. */
        if (strlen(shape->name) == length && memcmp(name, shape->name, length) == 0 &&
            (name[length] == ':' || shape->least[0] == 0)) {
            return shape;
        }
    }
    return NULL;
}

bool shape_offer(host_problem *problem) {
    size_t length = strlen(problem->text);
    for (const host_shape *shape = host_shapes; shape->name != NULL && length < sizeof problem->text; shape++) {
        length += (size_t)snprintf(problem->text + length, sizeof problem->text - length, "%s %s%s",
                                   shape == host_shapes ? "; shapes are" : ",", shape->name,
                                   shape->least[0] > 0 ? ":NxM" : "");
    }
    return false;
}

static bool bad_counts(const host_shape *shape, host_problem *problem) {
    return problem_set(problem, 0, "%s takes counts from %lux%lu, and at most 65536 vertices", shape->name,
                       (unsigned long)shape->least[0], (unsigned long)shape->least[1]);
}

/** Reads the counts at `*at`, and moves on to the colon before the sizes, or the end. */
static bool read_counts(const host_shape *shape, const char **at, uint32_t counts[2], host_problem *problem) {
    const size_t length = strcspn(*at, ":");
    const char *cross = memchr(*at, 'x', length);
    int64_t values[2];
    if (cross == NULL || !number_integer(*at, (size_t)(cross - *at), &values[0]) ||
        !number_integer(cross + 1, (size_t)(*at + length - cross - 1), &values[1])) {
        return problem_set(problem, 0, "%s takes two counts, as in %s:24x12", shape->name, shape->name);
    }
    for (int i = 0; i < 2; i++) {
        if (values[i] < shape->least[i] || values[i] > COUNT_LARGEST) {
            return bad_counts(shape, problem);
        }
        counts[i] = (uint32_t)values[i];
    }
    *at += length;
    return true;
}

/** Reads a colon and the sizes at `at`, which may be the end. */
static bool read_sizes(const host_shape *shape, const char *at, glint_q16 sizes[SHAPE_SIZES_MAX],
                       host_problem *problem) {
    double values[SHAPE_SIZES_MAX];
    memcpy(values, shape->sizes, sizeof values);
    bool ok = *at == '\0' || number_list(at + 1, strlen(at + 1), ',', shape->size_count, values);
    for (uint32_t i = 0; ok && i < shape->size_count; i++) {
        ok = values[i] >= 1.0 / 65536.0 && values[i] <= SIZE_LARGEST;
    }
    if (!ok) {
        return problem_set(problem, 0, "%s takes %lu size%s above 0, up to 8192", shape->name,
                           (unsigned long)shape->size_count, shape->size_count > 1 ? "s" : "");
    }
    for (int i = 0; i < SHAPE_SIZES_MAX; i++) {
        sizes[i] = number_q16(values[i]);
    }
    return true;
}

/* ---- Texture coordinates ---------------------------------------------------------------------------------------- */

static const double pi = 3.14159265358979323846;

/** Takes a part of a turn to less than half a turn from another one. */
static double unwrap(double part, double other) {
    return part - floor(part - other + 0.5);
}

/** Lays a picture on a triangle of a flat side, across the axis that it faces most. */
static void lay_flat(const double size[3], const double normal[3], const double position[3], double at[2]) {
    int axis = fabs(normal[1]) > fabs(normal[0]) ? 1 : 0;
    axis = fabs(normal[2]) > fabs(normal[axis]) ? 2 : axis;
    const int across = axis == 0 ? 2 : 0;
    const int down = axis == 1 ? 2 : 1;
    const double sign = (normal[axis] < 0) == (axis == 0) ? 1 : -1;
    const double u = position[across] / size[across] * (axis == 1 ? 1 : sign);
    const double v = position[down] / size[down] * (axis == 1 ? sign : -1);
    at[0] = 0.5 + u / 2;
    at[1] = 0.5 + v / 2;
}

/** Wraps a picture around z. @return whether the position is off the axis, so that it has a u */
static bool lay_round(shape_wrap wrap, const double size[3], const double tube, const double position[3],
                      double at[2]) {
    const double radius = hypot(position[0], position[1]);
    at[0] = atan2(position[1], position[0]) / (2 * pi);
    if (wrap == SHAPE_TORUS) {
        at[1] = 0.5 - atan2(position[2], radius - (size[0] - tube)) / (2 * pi);
    } else if (wrap == SHAPE_SPHERE) {
        at[1] = acos(fmax(-1, fmin(1, position[2] / size[2]))) / pi;
    } else {
        at[1] = 0.5 - position[2] / size[2] / 2;
    }
    return radius > 1e-4 * size[0];
}

static void lay_triangle(host_mesh *mesh, size_t triangle, const host_shape *shape, const double size[3]) {
    mesh_corner *corners = mesh->triangles[triangle];
    double normal[3];
    double at[3][2];
    double sum = 0;
    int rounds = 0;
    bool has_u[3] = {true, true, true};
    mesh_triangle_normal(mesh, triangle, normal);
    const bool is_cap =
        shape->wrap == SHAPE_ROUND && fabs(normal[2]) > 0 && hypot(normal[0], normal[1]) < 1e-4 * fabs(normal[2]);
    const bool is_flat = shape->wrap == SHAPE_FLAT || is_cap;
    for (int i = 0; i < 3; i++) {
        const double *position = mesh->positions[corners[i].position];
        if (is_flat) {
            lay_flat(size, normal, position, at[i]);
            continue;
        }
        has_u[i] = lay_round(shape->wrap, size, size[2], position, at[i]);
        if (has_u[i]) {
            at[i][0] = rounds > 0 ? unwrap(at[i][0], sum / rounds) : at[i][0];
            sum += at[i][0];
            rounds++;
        }
        at[i][1] = i > 0 && shape->wrap == SHAPE_TORUS ? unwrap(at[i][1], at[0][1]) : at[i][1];
    }
    for (int i = 0; i < 3; i++) {
        corners[i].texture = mesh_add_texture(mesh, has_u[i] ? at[i][0] : sum / rounds, at[i][1]);
    }
}

/** Wraps a picture around a shape. */
static void lay_picture(host_mesh *mesh, const host_shape *shape) {
    double size[3];
    double low[3];
    mesh_bounds(mesh, low, size);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        lay_triangle(mesh, i, shape, size);
    }
}

/* ---- Meshes ----------------------------------------------------------------------------------------------------- */

static void read_back(const glint_mesh *made, host_mesh *mesh) {
    memset(mesh, 0, sizeof *mesh);
    for (uint32_t i = 0; i < made->vertex_count; i++) {
        double position[3];
        const int16_t *normal = made->normals[i];
        quantised_position(made, i, position);
        mesh_add_position(mesh, position[0], position[1], position[2]);
        mesh_add_normal(mesh, normal[0], normal[1], normal[2]);
    }
    for (uint32_t i = 0; i < made->triangle_count; i++) {
        mesh_corner corners[3];
        for (int j = 0; j < 3; j++) {
            corners[j].position = corners[j].normal = made->triangles[i][j];
            corners[j].texture = 0;
        }
        mesh_add_triangle(mesh, corners[0], corners[1], corners[2]);
    }
    mesh->face_count = mesh->triangle_count;
}

static bool generate(const host_shape *shape, const uint32_t counts[2], const glint_q16 sizes[SHAPE_SIZES_MAX],
                     host_mesh *mesh, host_problem *problem) {
    glint_mesh_room room = {0};
    glint_mesh made = {0};
    /* Without room the generator only counts, and says that there is too little. */
    (void)shape->generate(&made, &room, counts, sizes);
    if (made.vertex_count > 65536 || (uint64_t)counts[0] * counts[1] > 65536) {
        return bad_counts(shape, problem);
    }
    if (made.vertex_count == 0) {
        return problem_set(problem, 0, "%s: its sizes come to more than 8192", shape->name);
    }
    room.vertex_room = made.vertex_count;
    room.triangle_room = made.triangle_count;
    room.positions = memory_new(room.vertex_room, sizeof *room.positions);
    room.normals = memory_new(room.vertex_room, sizeof *room.normals);
    room.triangles = memory_new(room.triangle_room, sizeof *room.triangles);
    const glint_status status = shape->generate(&made, &room, counts, sizes);
    if (status == GLINT_OK) {
        read_back(&made, mesh);
        lay_picture(mesh, shape);
    }
    free(room.positions);
    free(room.normals);
    free(room.triangles);
    return status == GLINT_OK || problem_set(problem, 0, "%s", glint_strerror(status));
}

bool shape_make(const host_shape *shape, const char *name, host_mesh *mesh, host_problem *problem) {
    const char *at = name + strlen(shape->name);
    uint32_t counts[2] = {0, 0};
    glint_q16 sizes[SHAPE_SIZES_MAX];
    if (shape->least[0] > 0) {
        at++; /* the colon that shape_find saw */
        if (!read_counts(shape, &at, counts, problem)) {
            return false;
        }
    }
    return read_sizes(shape, at, sizes, problem) && generate(shape, counts, sizes, mesh, problem);
}
