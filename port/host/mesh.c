/* SPDX-License-Identifier: MIT */
#include "mesh.h"

#include "basics.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void mesh_free(host_mesh *mesh) {
    free(mesh->positions);
    free(mesh->normals);
    free(mesh->textures);
    free(mesh->triangles);
    free(mesh->colours);
    free(mesh->materials);
    free(mesh->objects);
    free(mesh->smoothing);
    memset(mesh, 0, sizeof *mesh);
}

uint32_t mesh_add_position(host_mesh *mesh, double x, double y, double z) {
    mesh->positions =
        memory_grow(mesh->positions, &mesh->position_capacity, mesh->position_count, sizeof *mesh->positions);
    double *position = mesh->positions[mesh->position_count];
    position[0] = x;
    position[1] = y;
    position[2] = z;
    return (uint32_t)mesh->position_count++;
}

uint32_t mesh_add_normal(host_mesh *mesh, double x, double y, double z) {
    /* Divided by the largest component first: its square could be beyond or below what a double holds. */
    const double largest = fmax(fabs(x), fmax(fabs(y), fabs(z)));
    const double divisor = largest > 0 ? largest : 1.0;
    x /= divisor;
    y /= divisor;
    z /= divisor;
    const double length = largest > 0 ? sqrt(x * x + y * y + z * z) : 1.0;
    mesh->normals = memory_grow(mesh->normals, &mesh->normal_capacity, mesh->normal_count, sizeof *mesh->normals);
    double *normal = mesh->normals[mesh->normal_count];
    normal[0] = x / length;
    normal[1] = y / length;
    normal[2] = z / length;
    return (uint32_t)mesh->normal_count++;
}

uint32_t mesh_add_texture(host_mesh *mesh, double u, double v) {
    mesh->textures = memory_grow(mesh->textures, &mesh->texture_capacity, mesh->texture_count, sizeof *mesh->textures);
    mesh->textures[mesh->texture_count][0] = isfinite(u) ? u : 0;
    mesh->textures[mesh->texture_count][1] = isfinite(v) ? v : 0;
    return (uint32_t)++mesh->texture_count;
}

void mesh_add_colour(host_mesh *mesh, uint8_t r, uint8_t g, uint8_t b) {
    mesh->colours = memory_grow(mesh->colours, &mesh->colour_capacity, mesh->colour_count, sizeof *mesh->colours);
    uint8_t *colour = mesh->colours[mesh->colour_count++];
    colour[0] = r;
    colour[1] = g;
    colour[2] = b;
}

void mesh_add_triangle(host_mesh *mesh, mesh_corner a, mesh_corner b, mesh_corner c) {
    mesh->triangles =
        memory_grow(mesh->triangles, &mesh->triangle_capacity, mesh->triangle_count, sizeof *mesh->triangles);
    mesh->materials =
        memory_grow(mesh->materials, &mesh->material_capacity, mesh->triangle_count, sizeof *mesh->materials);
    mesh->objects = memory_grow(mesh->objects, &mesh->object_capacity, mesh->triangle_count, sizeof *mesh->objects);
    mesh->smoothing =
        memory_grow(mesh->smoothing, &mesh->smoothing_capacity, mesh->triangle_count, sizeof *mesh->smoothing);
    mesh->materials[mesh->triangle_count] = mesh->material;
    mesh->objects[mesh->triangle_count] = mesh->object;
    mesh->smoothing[mesh->triangle_count] = mesh->smooth;
    mesh_corner *triangle = mesh->triangles[mesh->triangle_count++];
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
}

void mesh_bounds(const host_mesh *mesh, double low[3], double high[3]) {
    for (int axis = 0; axis < 3; axis++) {
        low[axis] = HUGE_VAL;
        high[axis] = -HUGE_VAL;
    }
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        const double *position = mesh->positions[mesh->triangles[i / 3][i % 3].position];
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = fmin(low[axis], position[axis]);
            high[axis] = fmax(high[axis], position[axis]);
        }
    }
}

static void turn_triangles(host_mesh *mesh) {
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const mesh_corner second = mesh->triangles[i][1];
        mesh->triangles[i][1] = mesh->triangles[i][2];
        mesh->triangles[i][2] = second;
    }
}

void mesh_scale(host_mesh *mesh, const double factors[3]) {
    for (size_t i = 0; i < mesh->position_count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            mesh->positions[i][axis] *= factors[axis];
        }
    }
    /* Normals go by the inverse transpose; written over in place, each stays at its index. */
    const size_t count = mesh->normal_count;
    mesh->normal_count = 0;
    for (size_t i = 0; i < count; i++) {
        const double *normal = mesh->normals[i];
        mesh_add_normal(mesh, normal[0] / factors[0], normal[1] / factors[1], normal[2] / factors[2]);
    }
    if (factors[0] * factors[1] * factors[2] < 0) {
        turn_triangles(mesh);
    }
}

void mesh_move_to_origin(host_mesh *mesh, const double origin[3]) {
    for (size_t i = 0; i < 3 * mesh->position_count; i++) {
        mesh->positions[i / 3][i % 3] -= origin[i % 3];
    }
}

static void turn_vectors(double (*vectors)[3], size_t count, int axis, double cosine, double sine) {
    const int j = (axis + 1) % 3;
    const int k = (axis + 2) % 3;
    for (size_t i = 0; i < count; i++) {
        const double first = vectors[i][j];
        const double second = vectors[i][k];
        vectors[i][j] = cosine * first - sine * second;
        vectors[i][k] = sine * first + cosine * second;
    }
}

void mesh_turn(host_mesh *mesh, int axis, double cosine, double sine) {
    turn_vectors(mesh->positions, mesh->position_count, axis, cosine, sine);
    turn_vectors(mesh->normals, mesh->normal_count, axis, cosine, sine);
}

void mesh_triangle_normal(const host_mesh *mesh, size_t triangle, double normal[3]) {
    const double *a = mesh->positions[mesh->triangles[triangle][0].position];
    const double *b = mesh->positions[mesh->triangles[triangle][1].position];
    const double *c = mesh->positions[mesh->triangles[triangle][2].position];
    for (int axis = 0; axis < 3; axis++) {
        const int j = (axis + 1) % 3;
        const int k = (axis + 2) % 3;
        normal[axis] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
    }
}
