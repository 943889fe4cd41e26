/* SPDX-License-Identifier: MIT */
/* Light at nodes. */
#include "proof.h"

#include "../../src/nodes.c"
#include "lit.h"

/* GLINT_UNIT^2 */
#define FULL 1073479696

/*
 * Not proven: glint_nodes_light: it walks nodes and lights, and calls what is proven. Suite `nodes` under ASan and UBSan,
 * and fuzzing.
 */

/* Stands on |a . b| <= |a| |b| (Cauchy, 1821) of unit vectors: of a vertex's normal, which is up to 2^15 long, too. */
/*@ requires \valid_read(normal + (0 .. 2)) && \valid_read(light + (0 .. 2));
    assigns \result \from indirect: normal[0 .. 2], indirect: light[0 .. 2];
    admit ensures -0x8000 <= \result <= 0x7fff; */
static inline int32_t find_node_cosine(const int16_t normal[3], const int16_t light[3]);

static glint_view view;
static glint_frame frame;
static glint_material material;
static glint_model model;
static glint_shading shading;
static glint_light_terms terms;
static glint_fragments at;
static glint_node node;

/* Any point of the guard band. @contract */
PROOF(glint_find_ray) {
    int32_t ray[3];
    frame.view = &view;
    any_view(&view);
    frame.config.width = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame.config.height = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    glint_find_ray(&frame, ANY(INT16_MIN, INT16_MAX), ANY(INT16_MIN, INT16_MAX), ray);
}

/*
 * Any normal and light, any half vector, both kinds of lobes, fixed or not; the half vector's length by parts.
 * @contract glint_dot glint_unit glint_mirror
 */
PROOF(find_axis) {
    glint_prepared_light source;
    int16_t normal[3], light[3], view_vector[3], turning[3], axis[3];
    uint32_t half = ANY_UNSIGNED(0, INT16_MAX);
    any_unit(source.half_vector);
    any_unit(normal);
    any_unit(light);
    any_unit(view_vector);
    FOR_PARTS(lobe, GLINT_LOBE_NONE, GLINT_LOBE_MIRROR) {
        model.lobe = (uint8_t)lobe;
        find_axis(&model, &source, ANY(0, 1), normal, light, view_vector, turning, axis, &half);
    }
}
