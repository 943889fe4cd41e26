/* SPDX-License-Identifier: MIT */
/* Lighting of vertices. */
#include "proof.h"

#include "../../src/per_vertex.c"
#include "lit.h"
#include "pixels.h"

/*
 * Up to 9 vertices anywhere in clip space, more than are lit at once, with colours of their own and without, from one
 * side and from both.
 * @contract glint_light_all glint_needs_rays glint_ray glint_clamp_colour
 * @options -eva-slevel 0 -eva-min-loop-unroll 10
 */
PROOF(light_vertices) {
    enum { COUNT = GLINT_FRAGMENTS_MAX + 1 };
    static const uint8_t colours[1][3];
    static const uint16_t colours565[1];
    glint_vertex vertices[COUNT];
    glint_position positions[COUNT];
    int16_t extra[COUNT][3];
    glint_frame frame;
    glint_view view;
    glint_material material;
    glint_shading shading;
    glint_transform transform;
    glint_mesh mesh;
    glint_draw draw;
    any_view(&view);
    any_transform(&transform);
    any_shading(&shading, &material);
    frame.view = &view;
    draw.vertices = vertices;
    draw.positions = positions;
    draw.shading = &shading;
    FOR_PARTS(count, 1, COUNT) {
        FOR_PARTS(kind, 0, 7) {
            draw.vertex_count = (uint32_t)count;
            for (int i = 0; i < COUNT; i++) {
                any_unit(vertices[i].attribute);
                positions[i].x = ANY(-0x30000000, 0x30000000);
                positions[i].y = ANY(-0x30000000, 0x30000000);
                positions[i].w = ANY(-0x30000000, 0x30000000);
                for (int c = 0; c < 3; c++)
                    extra[i][c] = (int16_t)ANY(0, GLINT_COLOUR_ONE);
            }
            mesh.colours = (kind & 3) == 1 ? colours : 0;
            mesh.colours565 = (kind & 3) == 2 ? colours565 : 0;
            draw.extra = kind & 3 ? extra : 0;
            draw.double_sided = (uint8_t)(kind >> 2);
            light_vertices(&frame, &draw, &transform, &mesh);
        }
    }
}

/* Fragments anywhere in any tile, planes of any slopes. @contract glint_resolve_colour
 * @options -eva-slevel 0 -eva-min-loop-unroll 9 */
PROOF(per_vertex_shade) {
    glint_frame frame;
    glint_fragments fragments;
    glint_attributes attributes;
    glint_draw draw;
    any_planes(&attributes);
    FOR_PARTS(count, 1, GLINT_FRAGMENTS_MAX) {
        any_tile(&frame, &fragments, (uint32_t)count);
        fragments.attributes = &attributes;
        shade(&frame, &fragments, &draw);
    }
}
