/* SPDX-License-Identifier: MIT */
/* Nodes: light at a point, summed over lights; and what of it no sum can hold. */
#include "../fast/fast.h"
#include "../light/model.h"
#include "../light/point.h"
#include "nearness.h"
#include "terms.h"

/* N.L, Q15, from which on a point clearly faces a light, or does not: of lights without and with a position, whose
 * direction has fewer bits. What faces away by less than that still counts as light. */
#define CLEARLY_LIT 16
#define CLEARLY_LIT_NEAR 128
#define NEARLY_LIT 4096

/* The same of a cone's cosine, as products of unit vectors: UNIT^2 / 64. */
#define CLEARLY_IN_CONE (1 << 24)

/* |L + V|^2 / 2 = 1 + L.V, Q15, below which a half vector turns too fast. */
#define LEAST_HALF_SQUARE (1 << 11)

void glint_find_ray(const glint_frame *frame, int32_t x, int32_t y, int32_t ray[3]) {
    ray[0] = frame->config.width * 4096 - x * 256;
    ray[1] = y * 256 - frame->config.height * 4096;
    ray[2] = frame->view->focal;
}

/* The half vector, and half its square before it is made unit. @return 0 where it turns too fast, or points away */
static int find_half(const int16_t light[3], const int16_t view[3], uint32_t *half, int16_t axis[3]) {
    const int32_t square = glint_shift_right(GLINT_UNIT * GLINT_UNIT + glint_dot(light, view), 15);
    if (square < LEAST_HALF_SQUARE)
        return 0;
    *half = (uint32_t)glint_least(square, INT16_MAX);
    glint_unit(light[0] + view[0], light[1] + view[1], light[2] + view[2], axis);
    return axis[2] >= 0;
}

/* Largest x and y of a deviation: differences have 15 bits and a sign. */
#define REACH ((1 << 14) - 1)

/* Cuts a deviation off. @return was it beyond? */
static inline int cut_off_number(int32_t *e) {
    const int32_t inside = glint_most(glint_least(*e, REACH), -REACH);
    const int is_far = inside != *e;
    *e = inside;
    return is_far;
}

/*
 * With unit N and H, k = (N.H + nz) / (1 + hz), e = (nx - hx k, ny - hy k) are the coordinates of N in the plane across
 * H, turned so that H points along z: |e|^2 = sin^2 of the angle between them. Where N.H < 0, |e| falls again: there it
 * is stretched, so that the back of H stays outside the highlight. @return is it stretched or cut off, so that no
 * polynomial fits?
 */
static int find_lobe_deviation(const int16_t n[3], const int16_t h[3], unsigned shift, int16_t number[GLINT_NUMBERS]) {
    const int32_t cosine = glint_shift_right(glint_dot(n, h), 15);
    const int32_t k = glint_shift_right((cosine + n[2]) * glint_inverse_of_one_and(h[2]), 16); /* Q14 */
    int32_t x = n[0] * (1 << 14) - h[0] * k, y = n[1] * (1 << 14) - h[1] * k;                  /* Q29 */
    if (cosine < 0) {
        x += glint_shift_right(x, 14) * -cosine;
        y += glint_shift_right(y, 14) * -cosine;
    }
    x = glint_shift_right(x + (1 << (14 - shift)), 15 - shift);
    y = glint_shift_right(y + (1 << (14 - shift)), 15 - shift);
    if (cosine < -GLINT_UNIT / 2)
        x = INT32_MAX;
    const int is_far = (cosine < 0) | cut_off_number(&x) | cut_off_number(&y);
    number[GLINT_LOBE_X] = (int16_t)x;
    number[GLINT_LOBE_Y] = (int16_t)y;
    return is_far;
}

/* A cosine, Q15, of two unit vectors' product. */
static inline int32_t signed_cosine(int32_t dot) { /* UNIT^2 is 2^30 less a part in 2^12 */
    return glint_least(glint_shift_right(dot + glint_shift_right(dot, 12), 15), INT16_MAX);
}

/* Of mirrored light |L + V|^2 / 2 stands for what R and V turn by; where no axis turns it is as large as can be. */
static inline uint32_t usual_half(const glint_shading *shading) {
    return shading->material->model->lobe == GLINT_LOBE_MIRROR ? 1 << 14 : INT16_MAX;
}

/* A lobe lies around H, and N turns about it; or around V, and R does. @return |L + V|^2 / 2, Q15 */
static uint32_t light_lobe(const glint_shading *shading, uint32_t i, const glint_prepared_light *source, int is_fixed,
                           const glint_fragments *at, uint32_t n, const int16_t *light, int32_t dot, glint_node *node) {
    int16_t own[3];
    const int16_t *turning = at->normal[n], *axis = own;
    uint32_t half = usual_half(shading);
    int is_there = 1;
    node->number[i][GLINT_LOBE_X] = node->number[i][GLINT_LOBE_Y] = 0;
    if (shading->material->model->lobe == GLINT_LOBE_MIRROR) {
        glint_mirror(dot, at->normal[n], light, own);
        turning = own;
        axis = at->view[n];
    } else if (is_fixed) {
        axis = source->half_vector;
        is_there = axis[2] > 0;
    } else {
        is_there = find_half(light, at->view[n], &half, own);
    }
    if (!is_there)
        node->unfit |= (uint8_t)(1u << i);
    else if (shading->terms->lobe_is_wide)
        node->number[i][GLINT_LOBE_X] = (int16_t)(signed_cosine(glint_dot(turning, axis)) >> 1);
    else if (find_lobe_deviation(turning, axis, shading->terms->lobe_shift, node->number[i]))
        node->far |= (uint8_t)(1u << i);
    return half;
}

/* Most that a cone's number tells, Q12. */
#define STEEP (7 << 12)

/* How far within a cone L is: 1 at its inner edge, 0 at its outer. */
static void find_cone(const glint_prepared_light *source, uint32_t i, const int16_t *light, glint_node *node,
                      int *is_lit) {
    const int32_t cosine = glint_cone_cosine(source, light);
    const int32_t past = glint_shift_right(cosine - source->spot.cosine_outer, source->spot.shift);
    const int64_t ramp = glint_shift_right64((int64_t)past * source->spot.slope, 18);
    const int32_t inside = (int32_t)(ramp > STEEP ? STEEP : ramp < -STEEP ? -STEEP : ramp);
    *is_lit = *is_lit && cosine > source->spot.cosine_inner + CLEARLY_IN_CONE;
    if (cosine < source->spot.cosine_outer - CLEARLY_IN_CONE)
        node->outside |= (uint16_t)(1u << i);
    if (cosine < source->spot.cosine_outer - 8 * CLEARLY_IN_CONE)
        node->outside |= (uint16_t)(0x100u << i);
    node->number[i][GLINT_CONE] = (int16_t)inside;
    if (inside != ramp || !source->spot.slope)
        node->steep |= (uint8_t)(1u << i);
}

/* One light at all points. */
static void light_nodes(const glint_frame *frame, const glint_shading *shading, uint32_t i, glint_fragments *at,
                        uint32_t lobes, int tells, glint_node *const nodes[]) {
    const glint_light_terms *terms = shading->terms;
    const glint_prepared_light *source = &frame->view->lights[i];
    const int has_position = source->type->illuminate != 0;
    const int32_t clearly = has_position ? CLEARLY_LIT_NEAR : CLEARLY_LIT,
                  nearly = has_position ? NEARLY_LIT : CLEARLY_LIT;
    const uint8_t bit = (uint8_t)(1u << i);
    at->is_gated = 0;
    if (has_position)
        glint_point_illuminate(source, at);
    for (uint32_t n = 0; n < at->count; n++) {
        glint_node *node = nodes[n];
        const int16_t *light = has_position ? at->light[n] : source->direction;
        const int32_t strength = has_position ? at->strength[n] : 1 << 15;
        const int32_t dot = glint_dot(at->normal[n], light), cosine = signed_cosine(dot);
        int is_lit = cosine > clearly;
        /* right at a light its direction tells nothing */
        const int is_dark = cosine < -clearly && (!has_position || at->length[n]);
        if (source->type->has_cone)
            find_cone(source, i, light, node, &is_lit);
        node->number[i][GLINT_SIDE] = (int16_t)glint_shift_right(cosine * strength, 16);
        node->number[i][GLINT_STRENGTH] = (int16_t)glint_shift_right(strength, 1);
        uint32_t half = usual_half(shading);
        if (lobes & bit)
            half = light_lobe(shading, i, source, !has_position && !frame->view->local_viewer, at, n, light, dot, node);
        if (!tells)
            continue;
        node->lit |= is_lit ? bit : 0;
        node->dark |= is_dark ? bit : 0;
        node->number[i][GLINT_NEARNESS] =
            (int16_t)(uint16_t)glint_nearness_of(has_position ? glint_point_closeness(at, n) : 0, half);
        if ((!is_dark || cosine >= -nearly) && !(node->outside & bit))
            node->levels += (terms->diffuse_levels[i] >> 3) * (uint32_t)strength >> 16;
    }
}

void glint_nodes_light(const glint_frame *frame, const glint_shading *shading, glint_fragments *at, uint32_t lights,
                       uint32_t lobes, int tells, glint_node *const nodes[]) {
    if (lobes)
        glint_find_view_vectors(frame->view, at);
    for (uint32_t n = 0; n < at->count; n++) {
        glint_node *node = nodes[n];
        node->levels = 0;
        node->outside = 0;
        node->lit = node->dark = node->far = node->unfit = node->steep = node->left = 0;
    }
    for (uint32_t i = 0; lights >> i; i++)
        if (lights >> i & 1)
            light_nodes(frame, shading, i, at, lobes, tells, nodes);
}

/* Light of one node: channels, or Q15 of one chroma. */
void glint_node_sum(const glint_light_terms *light, uint32_t held, glint_node *node) {
    const unsigned down = light->channels == 1 ? light->sum_bits : 11 + light->sum_bits;
    const int32_t half = (int32_t)(1u << down >> 1);
    int32_t red = half, green = half, blue = half;
    for (uint32_t i = 0; held >> i; i++) {
        const int32_t amount = node->number[i][GLINT_SIDE];
        if (!(held >> i & 1))
            continue;
        if (light->channels == 1) {
            red += glint_shift_right(amount * light->share[i], 14);
            continue;
        }
        red += amount * light->diffuse[i][0];
        green += amount * light->diffuse[i][1];
        blue += amount * light->diffuse[i][2];
    }
    node->sum[0] = glint_shift_right(red, down);
    node->sum[1] = glint_shift_right(green, down);
    node->sum[2] = glint_shift_right(blue, down);
}
