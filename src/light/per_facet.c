/* SPDX-License-Identifier: MIT */
/* Lighting once a triangle, at its centroid, with the normal of its plane turned towards the eye. */
#include "evaluation.h"
#include "shade.h"

/* Does the eye see the side from which corners run clockwise? Of one that is clipped, by the product of its corners. */
static int is_clockwise(const glint_view *view, const glint_vertex *const v[3], const glint_position *p,
                        const int32_t cross[3]) {
    if (!((v[0]->flags | v[1]->flags | v[2]->flags) & GLINT_VERTEX_CLIP))
        return glint_double_area(v[0], v[1], v[2]) > 0;
    if (view->is_parallel)
        return cross[2] < 0;
    return (int64_t)cross[0] * p->x - (int64_t)cross[1] * p->y - (int64_t)cross[2] * p->w > 0;
}

/*
 * Normal of a triangle in camera space, from clip coordinates, towards the eye: x and y there are focal length / guard
 * band times too large, so that z, the product of two of them, is scaled by the inverse of that. A facet seen on edge
 * shows the side that its corners on the screen do: what is drawn as a front is lit as one.
 */
static void facet_normal(const glint_view *view, const glint_vertex *const v[3], const glint_position *const p[3],
                         int16_t normal[3]) {
    const int64_t ax = (int64_t)p[1]->x - p[0]->x, ay = (int64_t)p[0]->y - p[1]->y, az = (int64_t)p[0]->w - p[1]->w;
    const int64_t bx = (int64_t)p[2]->x - p[0]->x, by = (int64_t)p[0]->y - p[2]->y, bz = (int64_t)p[0]->w - p[2]->w;
    const int64_t cross[3] = {ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx};
    int32_t reduced[3];
    glint_reduce(cross, reduced);
    const int is_away = is_clockwise(view, v, p[0], reduced);
    /* times focal length (twice, Q12) and guard band (the same) */
    const int64_t scaled[3] = {(int64_t)reduced[0] * view->focal, (int64_t)reduced[1] * view->focal,
                               (int64_t)reduced[2] * (2 * GLINT_GUARD_BAND * 4096)};
    glint_reduce(scaled, reduced);
    glint_unit(reduced[0], reduced[1], reduced[2], normal);
    for (int c = 0; c < 3 && is_away; c++)
        normal[c] = (int16_t)-normal[c];
}

static int32_t average(const glint_draw *draw, const uint16_t *indices, int c) {
    return (draw->extra[indices[0]][c] + draw->extra[indices[1]][c] + draw->extra[indices[2]][c]) / 3;
}

static void light_facet(const glint_frame *frame, glint_draw *draw, const glint_transform *transform, uint32_t i) {
    const uint16_t *indices = draw->triangles[i];
    const glint_position *const p[3] = {&draw->positions[indices[0]], &draw->positions[indices[1]],
                                        &draw->positions[indices[2]]};
    const glint_vertex *const v[3] = {&draw->vertices[indices[0]], &draw->vertices[indices[1]],
                                      &draw->vertices[indices[2]]};
    const int64_t sum[3] = {(int64_t)p[0]->x + p[1]->x + p[2]->x, (int64_t)p[0]->y + p[1]->y + p[2]->y,
                            (int64_t)p[0]->w + p[1]->w + p[2]->w};
    glint_fragments one;
    one.count = 1;
    one.away = draw->unreached;
    glint_ray(transform, frame->view, sum, 3, one.ray[0], &one.inverse_w[0]);
    facet_normal(frame->view, v, p, one.normal[0]);
    for (int c = 0; c < 3 && draw->extra; c++)
        one.surface[0][c] = (int16_t)average(draw, indices, c);
    glint_light_all(frame, &one, draw->shading, draw->extra != 0);
    glint_clamp_colour(one.colour[0], draw->facets[i]);
}

const glint_evaluation glint_per_facet = {GLINT_LIT_AT_FACETS, 0, light_facet, glint_draw_facet, glint_draw_facet, 0};
