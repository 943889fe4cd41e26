/* SPDX-License-Identifier: MIT */
/* Lighting of facets. */
#include "proof.h"

#include "../../src/light/per_facet.c"
#include "lit.h"

/*
 * Three vertices anywhere in clip space, clipped or within the guard band, with colours of their own and without.
 * @contract glint_light_all glint_ray glint_clamp_colour glint_reduce glint_unit
 */
PROOF(light_facet) {
    static const uint16_t triangles[1][3] = {{0, 1, 2}};
    glint_vertex vertices[3];
    glint_position positions[3];
    int16_t extra[3][3], facets[1][3];
    glint_frame frame;
    glint_view view;
    glint_transform transform;
    glint_shading shading;
    glint_draw draw;
    any_view(&view);
    view.is_parallel = (uint8_t)ANY(0, 1);
    any_transform(&transform);
    for (int i = 0; i < 3; i++) {
        positions[i].x = ANY(-0x30000000, 0x30000000);
        positions[i].y = ANY(-0x30000000, 0x30000000);
        positions[i].w = ANY(-0x30000000, 0x30000000);
        vertices[i].x = (int16_t)ANY(-0x4000, 0x3fff);
        vertices[i].y = (int16_t)ANY(-0x4000, 0x3fff);
        vertices[i].flags = (uint16_t)ANY(0, 0xffff);
        for (int c = 0; c < 3; c++)
            extra[i][c] = (int16_t)ANY(0, GLINT_COLOUR_ONE);
    }
    frame.view = &view;
    draw.triangles = triangles;
    draw.vertices = vertices;
    draw.positions = positions;
    draw.facets = facets;
    draw.shading = &shading;
    draw.unreached = ANY_UNSIGNED(0, 0xff);
    draw.extra = 0;
    light_facet(&frame, &draw, &transform, 0);
    draw.extra = extra;
    light_facet(&frame, &draw, &transform, 0);
}
