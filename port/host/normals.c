/* SPDX-License-Identifier: MIT */
/**
 * @file normals.c
 * Vertex normals from triangles.
 */
#include "mesh.h"

#include "basics.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

const char *const mesh_weight_names[] = {
    [MESH_BY_AREA] = "area", [MESH_BY_ANGLE] = "angle", [MESH_EQUAL] = "equal", NULL};

/** A triangle is a sliver, whose own normal says nothing, below this height over its longest edge. */
#define SLIVER 1e-6

/** Slivers to pass on the way to a triangle that is none. */
#define SLIVERS_MAX 64

/** Triangles at one edge that each triangle there is compared with; a surface has 1. */
#define EDGE_NEIGHBOURS_MAX 8

/** How a triangle takes part in normals. */
typedef struct triangle_facing {
    double normal[3]; /* Unit length: its own or, of a sliver, of the surface that it lies in; 0 for none. */
    double twice_area;
    double longest; /* Square of its longest edge. */
    bool is_sliver;
} triangle_facing;

/* ---- Facings ---------------------------------------------------------------------------------------------------- */

static double length(const double v[3]) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/** Square of the distance between a corner and the next one of its triangle. */
static double edge_square(const host_mesh *mesh, size_t triangle, int corner) {
    const double *a = mesh->positions[mesh->triangles[triangle][corner].position];
    const double *b = mesh->positions[mesh->triangles[triangle][(corner + 1) % 3].position];
    const double edge[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    return edge[0] * edge[0] + edge[1] * edge[1] + edge[2] * edge[2];
}

static triangle_facing own_facing(const host_mesh *mesh, size_t triangle) {
    triangle_facing facing = {{0, 0, 0}, 0, 0, true};
    double normal[3];
    mesh_triangle_normal(mesh, triangle, normal);
    facing.twice_area = length(normal);
    for (int i = 0; i < 3; i++) {
        facing.longest = fmax(facing.longest, edge_square(mesh, triangle, i));
    }
    facing.is_sliver = !(facing.twice_area > SLIVER * facing.longest);
    for (int axis = 0; !facing.is_sliver && axis < 3; axis++) {
        facing.normal[axis] = normal[axis] / facing.twice_area;
    }
    return facing;
}

/** Returns the end of the half edges that share the edge of the one at `first`. */
static size_t edge_end(const mesh_half_edge *edges, size_t first, size_t count) {
    size_t end = first + 1;
    while (end < count && edges[end].low == edges[first].low && edges[end].high == edges[first].high) {
        end++;
    }
    return end;
}

/** Notes, for slivers whose longest edge this is, a neighbour there: one that is no sliver where there is one. */
static void note_neighbours(const host_mesh *mesh, const triangle_facing *facings, const mesh_half_edge *edges,
                            size_t count, size_t *neighbours) {
    size_t best = 0;
    while (best < count && facings[edges[best].triangle].is_sliver) {
        best++;
    }
    best = best < count ? best : 0;
    for (size_t i = 0; i < count; i++) {
        const size_t triangle = edges[i].triangle;
        if (facings[triangle].is_sliver && edge_square(mesh, triangle, edges[i].corner) >= facings[triangle].longest) {
            neighbours[triangle] = edges[best].triangle;
        }
    }
}

/** Finds how triangles face; a sliver faces as what lies across its longest edge, in whose plane it was cut. */
static triangle_facing *find_facings(const host_mesh *mesh, const mesh_half_edge *edges) {
    const size_t count = 3 * mesh->triangle_count;
    triangle_facing *facings = memory_new(mesh->triangle_count, sizeof *facings);
    size_t *neighbours = memory_new(mesh->triangle_count, sizeof *neighbours);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        facings[i] = own_facing(mesh, i);
        neighbours[i] = i;
    }
    for (size_t first = 0, end; first < count; first = end) {
        end = edge_end(edges, first, count);
        note_neighbours(mesh, facings, edges + first, end - first, neighbours);
    }
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        size_t other = i;
        for (int passed = 0; facings[other].is_sliver && passed < SLIVERS_MAX; passed++) {
            other = neighbours[other];
        }
        memcpy(facings[i].normal, facings[other].normal, sizeof facings[i].normal);
    }
    free(neighbours);
    return facings;
}

/* ---- Sets of corners that share a normal ------------------------------------------------------------------------ */

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

/** Returns whether two triangles are smooth where they meet: by their smoothing groups or else by their angle. */
static bool is_smooth(const host_mesh *mesh, const triangle_facing *facings, const mesh_normal_rule *rule, size_t first,
                      size_t second) {
    const uint32_t group = mesh->smoothing[first];
    if (!rule->anew && (group != MESH_BY_CREASE || mesh->smoothing[second] != MESH_BY_CREASE)) {
        return group == mesh->smoothing[second] && group != MESH_FACETED;
    }
    const double *a = facings[first].normal;
    const double *b = facings[second].normal;
    return length(a) > 0 && length(b) > 0 &&
           a[0] * b[0] + a[1] * b[1] + a[2] * b[2] >= cos(rule->crease * pi / 180.0) - 1e-9;
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

/** Finds for every corner the corner that stands for its set. */
static size_t *find_sets(const host_mesh *mesh, const triangle_facing *facings, const mesh_half_edge *edges,
                         const mesh_normal_rule *rule) {
    const size_t count = 3 * mesh->triangle_count;
    size_t *parents = memory_new(count, sizeof *parents);
    for (size_t i = 0; i < count; i++) {
        parents[i] = i;
    }
    for (size_t first = 0, end; first < count; first = end) {
        end = edge_end(edges, first, count);
        for (size_t i = first; i < end; i++) {
            for (size_t j = i + 1; j < end && j <= i + EDGE_NEIGHBOURS_MAX; j++) {
                if (is_smooth(mesh, facings, rule, edges[i].triangle, edges[j].triangle)) {
                    join_across(parents, &edges[i], &edges[j]);
                }
            }
        }
    }
    for (size_t i = 0; i < count; i++) {
        parents[i] = set_root(parents, i);
    }
    return parents;
}

/* ---- Normals of sets -------------------------------------------------------------------------------------------- */

/** Angle between two edges of a triangle at corner `i`. */
static double corner_angle(const host_mesh *mesh, size_t i, double twice_area) {
    const mesh_corner *triangle = mesh->triangles[i / 3];
    const double *here = mesh->positions[triangle[i % 3].position];
    const double *next = mesh->positions[triangle[(i + 1) % 3].position];
    const double *last = mesh->positions[triangle[(i + 2) % 3].position];
    double dot = 0;
    for (int axis = 0; axis < 3; axis++) {
        dot += (next[axis] - here[axis]) * (last[axis] - here[axis]);
    }
    return atan2(twice_area, dot);
}

static double weight_of(const host_mesh *mesh, size_t i, const triangle_facing *facing, mesh_weights weights) {
    switch (weights) {
    case MESH_BY_ANGLE:
        return corner_angle(mesh, i, facing->twice_area);
    case MESH_BY_AREA:
        return facing->twice_area;
    default:
        return facing->is_sliver ? 0.0 : 1.0;
    }
}

static double (*sum_over_sets(const host_mesh *mesh, const triangle_facing *facings, const size_t *sets,
                              mesh_weights weights))[3] {
    double(*sums)[3] = memory_new(3 * mesh->triangle_count, sizeof *sums);
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        const triangle_facing *facing = &facings[i / 3];
        const double weight = weight_of(mesh, i, facing, weights);
        for (int axis = 0; axis < 3; axis++) {
            sums[sets[i]][axis] += weight * facing->normal[axis];
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

/** Numbers the points of positions: in a mesh with colours, several at one place are told apart by their colours only.
 */
static uint32_t *find_points(const host_mesh *mesh) {
    if (mesh->colours != NULL) {
        return mesh_weld(mesh);
    }
    uint32_t *points = memory_new(mesh->position_count, sizeof *points);
    for (size_t i = 0; i < mesh->position_count; i++) {
        points[i] = (uint32_t)i;
    }
    return points;
}

void mesh_make_normals(host_mesh *mesh, const mesh_normal_rule *rule) {
    const size_t count = 3 * mesh->triangle_count;
    uint32_t *points = find_points(mesh);
    mesh_half_edge *edges = mesh_half_edges(mesh, points);
    triangle_facing *facings = find_facings(mesh, edges);
    size_t *sets = find_sets(mesh, facings, edges, rule);
    double(*sums)[3] = sum_over_sets(mesh, facings, sets, rule->weights);
    uint32_t *made = memory_new(count, sizeof *made); /* plus one; 0 for none yet */
    mesh->normal_count = rule->anew ? 0 : mesh->normal_count;
    for (size_t i = 0; i < count; i++) {
        mesh_corner *corner = &mesh->triangles[i / 3][i % 3];
        if (!rule->anew && corner->normal != MESH_NO_NORMAL) {
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
    free(facings);
    free(edges);
    free(points);
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
