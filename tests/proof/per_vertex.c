/* SPDX-License-Identifier: MIT */
/* Lighting of vertices. */
#include "proof.h"

#include "../../src/light/per_vertex.c"
#include "lit.h"

/*@ requires \valid_read(draw) && \valid(vertex);
    assigns vertex->attribute[0 .. 2], vertex->flags \from indirect: *draw, *vertex;
    ensures \initialized(&vertex->attribute[0 .. 2]) && \initialized(&vertex->flags);
    ensures \subset(vertex->attribute[0 .. 2], (-32767 .. 32767)); */
void glint_transform_normal(const glint_draw *draw, glint_vertex *vertex);

/*
 * A triangle with any of its vertices lit, anywhere in clip space, with colours of their own and without, from one
 * side and from both.
 * @contract glint_light_all glint_needs_rays glint_ray glint_clamp_colour glint_transform_normal
 * @unreached 3 meshes with a layout: suite `layouts` under ASan and UBSan
 */
PROOF(light_corners) {
    static const uint8_t colours[1][3];
    static const uint16_t colours565[1];
    static const uint16_t triangles[1][3] = {{0, 1, 2}};
    glint_vertex vertices[3];
    glint_position positions[3];
    glint_mesh mesh = {0};
    const glint_object object = {.mesh = &mesh};
    const glint_scene scene = {.objects = &object};
    glint_view view;
    glint_material material;
    glint_shading shading;
    glint_frame frame;
    glint_draw draw;
    any_view(&view);
    any_transform(&draw.transform);
    any_shading(&shading, &material);
    frame.scene = &scene;
    frame.view = &view;
    draw.object = 0;
    draw.unreached = ANY_UNSIGNED(0, 0xff);
    draw.triangles = triangles;
    draw.vertices = vertices;
    draw.positions = positions;
    draw.shading = &shading;
    FOR_PARTS(lit, 0, 7) {
        FOR_PARTS(kind, 0, 5) {
            int16_t extra[3][3]; /* without colours, what nothing has written */
            for (int i = 0; i < 3; i++) {
                vertices[i].flags = lit >> i & 1 ? GLINT_VERTEX_NORMAL : 0;
                positions[i].x = ANY(-0x30000000, 0x30000000);
                positions[i].y = ANY(-0x30000000, 0x30000000);
                positions[i].w = ANY(-0x30000000, 0x30000000);
                for (int c = 0; c < 3 && kind >> 1; c++)
                    extra[i][c] = (int16_t)ANY(0, GLINT_COLOUR_ONE);
            }
            mesh.colours = kind >> 1 == 1 ? colours : 0;
            mesh.colours565 = kind >> 1 == 2 ? colours565 : 0;
            draw.extra = kind ? extra : 0;
            draw.double_sided = (uint8_t)(kind & 1);
            light_corners(&frame, &draw, &draw.transform, 0);
        }
    }
}
