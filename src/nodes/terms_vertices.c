/* SPDX-License-Identifier: MIT */
/* Terms at vertices: light at a triangle's corners, and what they keep of it. */
#include "terms.h"

static void keep(const glint_light_terms *light, uint32_t lights, const glint_node *node, int16_t *to) {
    int16_t *const rest = to + light->channels;
    for (uint32_t c = 0; c < light->channels; c++)
        to[c] = (int16_t)node->sum[c];
    rest[GLINT_KEPT_FACING] = (int16_t)(uint16_t)(node->lit | node->dark << 8);
    rest[GLINT_KEPT_FLAGS] = (int16_t)(uint16_t)(node->far | node->unfit << 8);
    rest[GLINT_KEPT_STEEP] = (int16_t)node->steep;
    rest[GLINT_KEPT_OUTSIDE] = (int16_t)node->outside;
    rest[GLINT_KEPT_LEVELS] = (int16_t)glint_least((int32_t)((node->levels + 3) >> 2), INT16_MAX); /* Q2 */
    for (int c = 0; c < 3; c++)
        rest[GLINT_KEPT_SHINE + c] = (int16_t)node->shine[c];
    for (uint32_t i = 0; lights >> i; i++)
        for (uint32_t kind = 0; kind < GLINT_NUMBERS && lights >> i & 1; kind++)
            if (light->at[i][kind])
                to[light->at[i][kind]] = node->number[i][kind];
}

static void gather_corner(const glint_frame *frame, const glint_vertex *v, glint_fragments *to) {
    const uint32_t i = to->count++;
    glint_find_ray(frame, 2 * v->x, 2 * v->y, to->ray[i]);
    to->inverse_w[i] = v->inverse_w;
    for (int c = 0; c < 3; c++)
        to->normal[i][c] = v->attribute[c];
}

/* A flag of vertices: their normal is known, but they are not lit. */
#define NORMAL_ALONE 8u

/* Is a triangle large enough for polynomials, and whole? */
static int is_large(const glint_draw *draw, const uint16_t corners[3]) {
    const glint_vertex *const a = &draw->vertices[corners[0]], *const b = &draw->vertices[corners[1]],
                              *const c = &draw->vertices[corners[2]];
    if ((a->flags | b->flags | c->flags) & GLINT_VERTEX_CLIP)
        return 0;
    const int32_t area = glint_double_area(a, b, c);
    return area >= GLINT_NODES_LEAST_AREA || area <= -GLINT_NODES_LEAST_AREA;
}

/* Finds normals. Vertices are not done with that: a larger triangle of theirs has them lit. */
static void find_normals(glint_draw *draw, const uint16_t corners[3]) {
    for (int i = 0; i < 3; i++) {
        glint_vertex *vertex = &draw->vertices[corners[i]];
        if (vertex->flags & (GLINT_VERTEX_NORMAL | NORMAL_ALONE))
            continue;
        glint_transform_normal(draw, vertex);
        vertex->flags ^= GLINT_VERTEX_NORMAL | NORMAL_ALONE;
    }
}

void glint_terms_light(const glint_frame *frame, glint_draw *draw, const glint_transform *transform,
                       uint32_t triangle) {
    const glint_light_terms *light = draw->shading->terms;
    const uint32_t lights = draw->shading->lights & ~draw->unreached;
    const uint16_t *const corners = draw->triangles[triangle];
    uint16_t index[3];
    glint_fragments vertices;
    glint_node nodes[3], *const to[3] = {&nodes[0], &nodes[1], &nodes[2]};
    if (!light) {
        glint_transform_normals(frame, draw, transform, triangle);
        return;
    }
    find_normals(draw, corners);
    if (!is_large(draw, corners))
        return;
    vertices.count = 0;
    for (int i = 0; i < 3; i++) {
        glint_vertex *vertex = &draw->vertices[corners[i]];
        if (vertex->flags & GLINT_VERTEX_LIT)
            continue;
        vertex->flags |= GLINT_VERTEX_LIT | GLINT_VERTEX_NORMAL;
        index[vertices.count] = corners[i];
        gather_corner(frame, vertex, &vertices);
    }
    glint_nodes_light(frame, draw->shading, &vertices, lights, light->lobes & lights, 1, to);
    for (uint32_t i = 0; i < vertices.count; i++) {
        glint_node_sum(light, nodes[i].lit, &nodes[i]);
        glint_node_shine(draw->shading, nodes[i].lit & light->lobes, &nodes[i]);
        keep(light, lights, &nodes[i], draw->nodes + index[i] * light->stride);
    }
}
