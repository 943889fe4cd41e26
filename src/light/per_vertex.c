/* SPDX-License-Identifier: MIT */
/* Lighting at every vertex (Gouraud, 1971): colours, clamped at 1, are interpolated. */
#include "../geometry/layout.h"
#include "evaluation.h"
#include "shade.h"

/* Makes a vertex fragment i, seen from the front. Without colours, extra attributes are the back's, not yet lit. */
static void gather_vertices(const glint_frame *frame, const glint_draw *draw, uint32_t index, glint_fragments *to,
                            uint32_t i, int has_surface) {
    const glint_position *p = &draw->positions[index];
    const int64_t point[3] = {p->x, p->y, p->w};
    if (glint_needs_rays(frame->view, draw->shading))
        glint_ray(&draw->transform, frame->view, point, 1, to->ray[i], &to->inverse_w[i]);
    for (int c = 0; c < 3; c++) {
        to->normal[i][c] = draw->vertices[index].attribute[c];
        to->surface[i][c] = (int16_t)(has_surface ? draw->extra[index][c] : 0);
    }
}

/* Turns fragments round. */
static void negate_normals(glint_fragments *fragments) {
    for (uint32_t i = 0; i < fragments->count; i++)
        for (int c = 0; c < 3; c++)
            fragments->normal[i][c] = (int16_t)-fragments->normal[i][c];
}

static void light_corners(const glint_frame *frame, glint_draw *draw, const glint_transform *transform,
                          uint32_t triangle) {
    const glint_mesh *mesh = frame->scene->objects[draw->object].mesh;
    const int has_surface = glint_has_colours(mesh);
    uint32_t index[3], count = 0;
    glint_fragments vertices;
    (void)transform;
    for (int corner = 0; corner < 3; corner++) {
        const uint32_t here = draw->triangles[triangle][corner];
        if (draw->vertices[here].flags & GLINT_VERTEX_NORMAL)
            continue;
        glint_transform_normal(draw, &draw->vertices[here]);
        index[count] = here;
        gather_vertices(frame, draw, here, &vertices, count++, has_surface);
    }
    if (!count)
        return;
    vertices.count = count;
    vertices.away = draw->unreached;
    glint_light_all(frame, &vertices, draw->shading, has_surface);
    for (uint32_t i = 0; i < count; i++)
        glint_clamp_colour(vertices.colour[i], draw->vertices[index[i]].attribute);
    if (!draw->double_sided)
        return;
    negate_normals(&vertices);
    glint_light_all(frame, &vertices, draw->shading, has_surface);
    for (uint32_t i = 0; i < count; i++)
        glint_clamp_colour(vertices.colour[i], draw->extra[index[i]]);
}

const glint_evaluation glint_per_vertex = {GLINT_LIT_AT_VERTICES, 0, light_corners, glint_draw_lit, glint_draw_lit, 0};
