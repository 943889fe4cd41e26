/* SPDX-License-Identifier: MIT */
/* Cull: finds the triangles of a draw that face the eye. Each takes this, so that it is all that the loop does. */
#include "frame.h"

int glint_cull(const glint_draw *draw, uint32_t *next, uint16_t seen[GLINT_SEEN_MAX]) {
    const glint_vertex *const vertices = draw->vertices;
    const uint32_t vertex_count = draw->vertex_count;
    const int32_t side = glint_takes_all(draw) ? 0 : draw->mirrored ? 1 : -1, limit = side ? 0 : -1;
    const uint32_t first = *next, end = draw->count - first < GLINT_SEEN_MAX ? draw->count : first + GLINT_SEEN_MAX;
    int count = 0;
    for (uint32_t i = first; i < end; i++) {
        const uint16_t *indices = draw->triangles[i];
        const uint32_t a = indices[0], b = indices[1], c = indices[2];
        if (a >= vertex_count || b >= vertex_count || c >= vertex_count)
            return GLINT_ERROR_INDEX;
        if (glint_double_area(&vertices[a], &vertices[b], &vertices[c]) * side > limit)
            seen[count++] = (uint16_t)i;
    }
    *next = end;
    return count;
}
