/* SPDX-License-Identifier: MIT */
/* Lighting at every vertex (Gouraud, 1971): colours, clamped at 1, are interpolated. */
#include "colour.h"

/* Fragments of vertices from `first` on, seen from the front or the back. */
static void gather(const glint_frame *frame, const glint_draw *draw, const glint_transform *transform, uint32_t first,
                   int back, glint_fragments *vertices) {
    const int has_rays = glint_needs_rays(frame->view, draw->shading);
    uint32_t rest = draw->vertex_count - first;
    vertices->count = rest < GLINT_FRAGMENTS_MAX ? rest : GLINT_FRAGMENTS_MAX;
    for (uint32_t i = 0; i < vertices->count; i++) {
        const glint_position *p = &draw->positions[first + i];
        const int64_t point[3] = {p->x, p->y, p->w};
        if (has_rays)
            glint_ray(transform, frame->view, point, 1, vertices->ray[i], &vertices->inverse_w[i]);
        for (int c = 0; c < 3; c++) {
            int16_t n = draw->vertices[first + i].attribute[c];
            vertices->normal[i][c] = (int16_t)(back ? -n : n);
            if (draw->extra)
                vertices->surface[i][c] = draw->extra[first + i][c];
        }
    }
}

/* Colours of some vertices, seen from the front or the back. @return how many. */
static uint32_t light_some(const glint_frame *frame, const glint_draw *draw, const glint_transform *transform,
                           uint32_t first, int back, int has_surface, int16_t colour[GLINT_FRAGMENTS_MAX][3]) {
    glint_fragments vertices;
    gather(frame, draw, transform, first, back, &vertices);
    glint_light_all(frame, &vertices, draw->shading, has_surface);
    for (uint32_t i = 0; i < vertices.count; i++)
        glint_clamp_colour(vertices.colour[i], colour[i]);
    return vertices.count;
}

static void copy_colour(const int16_t from[3], int16_t to[3]) {
    to[0] = from[0];
    to[1] = from[1];
    to[2] = from[2];
}

static void light_vertices(const glint_frame *frame, glint_draw *draw, const glint_transform *transform,
                           const glint_mesh *mesh) {
    const int has_surface = mesh->colours || mesh->colours565;
    uint32_t fronts, backs;
    for (uint32_t first = 0; first < draw->vertex_count; first += fronts) {
        int16_t front[GLINT_FRAGMENTS_MAX][3], back[GLINT_FRAGMENTS_MAX][3];
        fronts = light_some(frame, draw, transform, first, 0, has_surface, front);
        backs = draw->double_sided && draw->extra ? light_some(frame, draw, transform, first, 1, has_surface, back) : 0;
        for (uint32_t i = 0; i < fronts; i++)
            copy_colour(front[i], draw->vertices[first + i].attribute);
        for (uint32_t i = 0; i < backs; i++)
            copy_colour(back[i], draw->extra[first + i]);
    }
}

static void shade(const glint_frame *frame, glint_fragments *fragments, const glint_draw *draw) {
    (void)draw;
    for (uint32_t i = 0; i < fragments->count; i++) {
        int16_t colour[3];
        glint_resolve_colour(frame, fragments, i, fragments->attributes->main, colour);
        for (int c = 0; c < 3; c++) /* 32767 stands for 1 */
            fragments->colour[i][c] = ((uint32_t)colour[c] << 8) + ((uint32_t)colour[c] >> 7);
    }
}

const glint_evaluation glint_per_vertex = {3, 1, light_vertices, 0, shade};
