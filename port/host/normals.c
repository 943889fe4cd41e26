/* SPDX-License-Identifier: MIT */
/**
 * @file normals.c
 * Vertex normals from triangles.
 */
#include "mesh.h"

#include "basics.h"

#include <math.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846;

const char *const mesh_weight_names[] = {
    [MESH_BY_AREA] = "area", [MESH_BY_ANGLE] = "angle", [MESH_EQUAL] = "equal", NULL};

/** Corners that share a normal, as a forest: a corner's parent is another of its set, or itself. */
static size_t set_root(size_t *parents, size_t corner) {
    while (parents[corner] != corner) {
        parents[corner] = parents[parents[corner]];
        corner = parents[corner];
    }
    return corner;
}

/** The smaller root wins, so that sets do not depend on the order of joining. */
static void set_join(size_t *parents, size_t a, size_t b) {
    a = set_root(parents, a);
    b = set_root(parents, b);
    parents[a > b ? a : b] = a < b ? a : b;
}

/** Whether the angle between two triangles' normals is at most the one of this cosine; no area, no angle. */
static int is_smooth(const host_mesh *mesh, size_t first, size_t second, double cosine) {
    double a[3];
    double b[3];
    mesh_triangle_normal(mesh, first, a);
    mesh_triangle_normal(mesh, second, b);
    const double lengths =
        sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]) * sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]);
    return lengths > 0 && a[0] * b[0] + a[1] * b[1] + a[2] * b[2] >= (cosine - 1e-9) * lengths;
}

/** Joins the corners of two triangles at both ends of an edge that they share. */
static void join_across(size_t *parents, const mesh_half_edge *first, const mesh_half_edge *second) {
    const size_t a = 3 * first->triangle + (size_t)first->corner;
    const size_t a_next = 3 * first->triangle + (size_t)((first->corner + 1) % 3);
    const size_t b = 3 * second->triangle + (size_t)second->corner;
    const size_t b_next = 3 * second->triangle + (size_t)((second->corner + 1) % 3);
    const int opposite = first->forward != second->forward;
    set_join(parents, a, opposite ? b_next : b);
    set_join(parents, a_next, opposite ? b : b_next);
}

/** For every corner the corner that stands for its set. */
static size_t *sets_by_crease(const host_mesh *mesh, double crease) {
    const size_t count = 3 * mesh->triangle_count;
    const double cosine = cos(crease * pi / 180.0);
    uint32_t *points = memory_new(mesh->position_count, sizeof *points);
    for (size_t i = 0; i < mesh->position_count; i++) {
        points[i] = (uint32_t)i;
    }
    mesh_half_edge *edges = mesh_half_edges(mesh, points);
    size_t *parents = memory_new(count, sizeof *parents);
    for (size_t i = 0; i < count; i++) {
        parents[i] = i;
    }
    for (size_t i = 0; i + 1 < count; i++) {
        if (edges[i].low == edges[i + 1].low && edges[i].high == edges[i + 1].high &&
            is_smooth(mesh, edges[i].triangle, edges[i + 1].triangle, cosine)) {
            join_across(parents, &edges[i], &edges[i + 1]);
        }
    }
    for (size_t i = 0; i < count; i++) {
        parents[i] = set_root(parents, i);
    }
    free(edges);
    free(points);
    return parents;
}

/** For every corner the first corner at its position. */
static size_t *sets_by_position(const host_mesh *mesh) {
    const size_t count = 3 * mesh->triangle_count;
    size_t *sets = memory_new(count, sizeof *sets);
    size_t *first = memory_new(mesh->position_count, sizeof *first); /* plus one; 0 for none yet */
    for (size_t i = 0; i < count; i++) {
        const uint32_t position = mesh->triangles[i / 3][i % 3].position;
        first[position] = first[position] > 0 ? first[position] : i + 1;
        sets[i] = first[position] - 1;
    }
    free(first);
    return sets;
}

static double length(const double v[3]) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/** Angle between two edges of a triangle at corner `i`, over the length of the triangle's normal. */
static double angle_weight(const host_mesh *mesh, size_t i, const double normal[3]) {
    const mesh_corner *triangle = mesh->triangles[i / 3];
    const double *here = mesh->positions[triangle[i % 3].position];
    const double *next = mesh->positions[triangle[(i + 1) % 3].position];
    const double *last = mesh->positions[triangle[(i + 2) % 3].position];
    double dot = 0;
    for (int axis = 0; axis < 3; axis++) {
        dot += (next[axis] - here[axis]) * (last[axis] - here[axis]);
    }
    const double twice_area = length(normal);
    return twice_area > 0 ? atan2(twice_area, dot) / twice_area : 0.0;
}

/** What a triangle's normal, twice its area long, is multiplied by at corner `i`. */
static double weight_of(const host_mesh *mesh, size_t i, const double normal[3], mesh_weights weights) {
    if (weights == MESH_BY_ANGLE) {
        return angle_weight(mesh, i, normal);
    }
    const double twice_area = length(normal);
    return weights == MESH_EQUAL && twice_area > 0 ? 1.0 / twice_area : 1.0;
}

static double (*sum_over_sets(const host_mesh *mesh, const size_t *sets, mesh_weights weights))[3] {
    double(*sums)[3] = memory_new(3 * mesh->triangle_count, sizeof *sums);
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        double normal[3];
        mesh_triangle_normal(mesh, i / 3, normal);
        const double weight = weight_of(mesh, i, normal, weights);
        for (int axis = 0; axis < 3; axis++) {
            sums[sets[i]][axis] += weight * normal[axis];
        }
    }
    return sums;
}

static int is_zero(const double v[3]) {
    return !(fabs(v[0]) > 0 || fabs(v[1]) > 0 || fabs(v[2]) > 0);
}

/** A normal for a set: its sum; where that is 0 the triangle's own; where that is 0 too, any. */
static uint32_t add_set_normal(host_mesh *mesh, const double sum[3], size_t triangle) {
    double normal[3] = {sum[0], sum[1], sum[2]};
    if (is_zero(normal)) {
        mesh_triangle_normal(mesh, triangle, normal);
    }
    return mesh_add_normal(mesh, normal[0], normal[1], is_zero(normal) ? 1.0 : normal[2]);
}

void mesh_average_normals(host_mesh *mesh, double crease, mesh_weights weights) {
    const size_t count = 3 * mesh->triangle_count;
    size_t *sets = crease < 0 ? sets_by_position(mesh) : sets_by_crease(mesh, crease);
    double(*sums)[3] = sum_over_sets(mesh, sets, weights);
    uint32_t *made = memory_new(count, sizeof *made); /* plus one; 0 for none yet */
    mesh->normal_count = crease < 0 ? mesh->normal_count : 0;
    for (size_t i = 0; i < count; i++) {
        mesh_corner *corner = &mesh->triangles[i / 3][i % 3];
        if (crease < 0 && corner->normal != MESH_NO_NORMAL) {
            continue;
        }
        if (made[sets[i]] == 0) {
            made[sets[i]] = add_set_normal(mesh, sums[sets[i]], i / 3) + 1;
        }
        corner->normal = made[sets[i]] - 1;
    }
    free(made);
    free(sums);
    free(sets);
}

void mesh_make_facet_normals(host_mesh *mesh) {
    mesh->normal_count = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const double none[3] = {0, 0, 0};
        const uint32_t normal = add_set_normal(mesh, none, i);
        for (int j = 0; j < 3; j++) {
            mesh->triangles[i][j].normal = normal;
        }
    }
}
