/* SPDX-License-Identifier: MIT */
/* Cull: finds the triangles of a draw that face the eye. Each takes this, so that it is all that the loop does. */
#include "frame.h"

/* Those from `first` to before `end` whose area is above a limit; one that faces the eye has one above 0. */
static inline int find(const glint_draw *draw, uint32_t first, uint32_t end, int32_t limit, uint16_t *seen) {
    const glint_vertex *const vertices = draw->vertices;
    const uint32_t vertex_count = draw->vertex_count, left = draw->mirrored ? 1 : 2, right = 3 - left;
    uint16_t *out = seen;
    for (uint32_t i = first; i < end; i++) {
        const uint16_t *indices = draw->triangles[i];
        const uint32_t a = indices[0], b = indices[left], c = indices[right];
        if (a >= vertex_count || b >= vertex_count || c >= vertex_count)
            return GLINT_ERROR_INDEX;
        if (glint_double_area(&vertices[a], &vertices[b], &vertices[c]) > limit) {
            *out++ = (uint16_t)i;
            GLINT_OPAQUE(out); /* else gcc moves it twice for Cortex-M4 */
        }
    }
    return (int)(out - seen);
}

int glint_cull(const glint_draw *draw, uint32_t *next, uint16_t seen[GLINT_SEEN_MAX]) {
    const uint32_t first = *next, end = draw->count - first < GLINT_SEEN_MAX ? draw->count : first + GLINT_SEEN_MAX;
    *next = end;
    const int32_t limit = glint_takes_all(draw) ? INT32_MIN : 0;
    return limit || GLINT_SMALL ? find(draw, first, end, limit, seen) : find(draw, first, end, 0, seen);
}
