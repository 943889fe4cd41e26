/* SPDX-License-Identifier: MIT */
#include "grids.h"

static void add_triangle(glint_mesh *mesh, const glint_mesh_room *room, uint32_t a, uint32_t b, uint32_t c) {
    uint16_t *const corners = room->triangles[mesh->triangle_count++];
    corners[0] = (uint16_t)a;
    corners[1] = (uint16_t)b;
    corners[2] = (uint16_t)c;
}

/* Adds a grid: the first corner, and where its rows and columns go. */
static void add_grid(glint_mesh *mesh, const glint_mesh_room *room, const int32_t first[3], const int32_t across_it[3],
                     const int32_t along_it[3], const int16_t normal[3], uint32_t cells) {
    const uint32_t start = mesh->vertex_count;
    for (uint32_t j = 0; j <= cells; j++)
        for (uint32_t i = 0; i <= cells; i++) {
            const uint32_t v = mesh->vertex_count++;
            for (int axis = 0; axis < 3; axis++) {
                const int64_t part = (int64_t)across_it[axis] * i + (int64_t)along_it[axis] * j;
                room->positions[v][axis] = (int16_t)(first[axis] + part / (int64_t)cells);
                room->normals[v][axis] = normal[axis];
            }
        }
    for (uint32_t j = 0; j < cells; j++)
        for (uint32_t i = 0; i < cells; i++) {
            const uint32_t v = start + j * (cells + 1) + i;
            add_triangle(mesh, room, v, v + 1, v + cells + 2);
            add_triangle(mesh, room, v, v + cells + 2, v + cells + 1);
        }
}

void grid_add_terrain(glint_mesh *mesh, const glint_mesh_room *room, uint32_t cells) {
    static const int32_t first[3] = {-32767, 0, 32767}, right[3] = {65534, 0, 0}, ahead[3] = {0, 0, -65534};
    static const int16_t up[3] = {0, 32767, 0};
    add_grid(mesh, room, first, right, ahead, up, cells);
}

void grid_add_room(glint_mesh *mesh, const glint_mesh_room *room, uint32_t cells) {
    for (int wall = 0; wall < 6; wall++) {
        const int axis = wall / 2, u = (axis + 1) % 3, v = (axis + 2) % 3, low = wall % 2;
        int32_t first[3] = {-32767, -32767, -32767}, across_it[3] = {0}, along_it[3] = {0};
        int16_t inward[3] = {0};
        first[axis] = low ? -32767 : 32767;
        inward[axis] = low ? 32767 : -32767;
        across_it[low ? u : v] = along_it[low ? v : u] = 65534; /* across x along is inward */
        add_grid(mesh, room, first, across_it, along_it, inward, cells);
    }
}
