/* SPDX-License-Identifier: MIT */
/**
 * @file topology.c
 * Which triangles share which edges.
 */
#include "mesh.h"

#include "basics.h"

#include <stdlib.h>

/** A position and where it stands in the mesh, so that sorting keeps track. */
typedef struct placed {
    double at[3];
    uint32_t index;
} placed;

static int compare_places(const void *left, const void *right) {
    const placed *a = left;
    const placed *b = right;
    for (int axis = 0; axis < 3; axis++) {
        if (a->at[axis] < b->at[axis] || a->at[axis] > b->at[axis]) {
            return a->at[axis] < b->at[axis] ? -1 : 1;
        }
    }
    return 0;
}

static int compare_numbers(size_t a, size_t b) {
    return (a > b) - (a < b);
}

static int compare_edges(const void *left, const void *right) {
    const mesh_half_edge *a = left;
    const mesh_half_edge *b = right;
    int order = compare_numbers(a->low, b->low);
    order = order != 0 ? order : compare_numbers(a->high, b->high);
    order = order != 0 ? order : compare_numbers(a->triangle, b->triangle);
    return order != 0 ? order : a->corner - b->corner;
}

mesh_half_edge *mesh_half_edges(const host_mesh *mesh, const uint32_t *points) {
    const size_t count = 3 * mesh->triangle_count;
    mesh_half_edge *edges = memory_new(count, sizeof *edges);
    for (size_t i = 0; i < count; i++) {
        const uint32_t from = points[mesh->triangles[i / 3][i % 3].position];
        const uint32_t to = points[mesh->triangles[i / 3][(i + 1) % 3].position];
        edges[i].low = from < to ? from : to;
        edges[i].high = from < to ? to : from;
        edges[i].triangle = i / 3;
        edges[i].corner = (int)(i % 3);
        edges[i].forward = from < to;
    }
    qsort(edges, count, sizeof *edges, compare_edges);
    return edges;
}

uint32_t *mesh_weld(const host_mesh *mesh) {
    placed *places = memory_new(mesh->position_count, sizeof *places);
    for (size_t i = 0; i < mesh->position_count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            places[i].at[axis] = mesh->positions[i][axis];
        }
        places[i].index = (uint32_t)i;
    }
    qsort(places, mesh->position_count, sizeof *places, compare_places);
    uint32_t *points = memory_new(mesh->position_count, sizeof *points);
    uint32_t point = 0;
    for (size_t i = 0; i < mesh->position_count; i++) {
        point += i > 0 && compare_places(&places[i - 1], &places[i]) != 0;
        points[places[i].index] = point;
    }
    free(places);
    return points;
}

static size_t count_points(const host_mesh *mesh, const uint32_t *points) {
    uint8_t *seen = memory_new(mesh->position_count, 1);
    size_t count = 0;
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        uint8_t *flag = &seen[points[mesh->triangles[i / 3][i % 3].position]];
        count += *flag == 0;
        *flag = 1;
    }
    free(seen);
    return count;
}

static void count_edge(mesh_topology *topology, const mesh_half_edge *edges, size_t count) {
    if (edges[0].low == edges[0].high) {
        return; /* a triangle without area has edges without length */
    }
    topology->boundary_edges += count == 1;
    topology->shared_edges += count > 2;
    topology->inconsistent_edges += count == 2 && edges[0].forward == edges[1].forward;
}

mesh_topology mesh_check_topology(const host_mesh *mesh) {
    mesh_topology topology = {0, 0, 0, 0};
    uint32_t *points = mesh_weld(mesh);
    mesh_half_edge *edges = mesh_half_edges(mesh, points);
    const size_t count = 3 * mesh->triangle_count;
    size_t first = 0;
    for (size_t i = 1; i <= count; i++) {
        if (i == count || edges[i].low != edges[first].low || edges[i].high != edges[first].high) {
            count_edge(&topology, edges + first, i - first);
            first = i;
        }
    }
    topology.point_count = count_points(mesh, points);
    free(edges);
    free(points);
    return topology;
}
