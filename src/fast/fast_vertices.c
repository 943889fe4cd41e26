/* SPDX-License-Identifier: MIT */
/*
 * Fast lighting of fragments under one directional light: vertices; triangles follow in fast_begin.h.
 *
 * With unit normal N and half vector H, k = (N.H + nz) / (1 + hz) and e = (nx - hx k, ny - hy k) are the coordinates of
 * N in the plane across H, turned so that H points along z: |e|^2 = sin^2 of the angle between them. Over a small
 * triangle e and N.L are linear; the half vector is found at vertices only.
 */
#include "fast.h"

/* 1/w from which on no rounding takes its plane below 0, whatever it is at the other corners. */
#define NOT_DEEP (1 << 21)

/* ---- Vertices ---- */

int glint_fast_half_vector(const glint_fast_terms *fast, int32_t x, int32_t y, int16_t half_vector[3],
                           glint_view_vector *view) {
    return glint_half_vector_inline(fast, 2 * x, 2 * y, half_vector, view);
}

/* A deviation, Q14, rounded down. */
typedef struct deviation {
    int32_t x, y;
} deviation;

/* e. Where N.H < 0, |e| falls again: there it is stretched, so that the back of H stays outside the highlight. */
static inline deviation find_deviation(const int16_t n[3], const int16_t h[3]) {
    const int32_t cosine = glint_shift_right(glint_dot(n, h), 15);
    const int32_t k = glint_shift_right((cosine + n[2]) * glint_inverse_of_one_and(h[2]), 16); /* Q14 */
    deviation e = {glint_shift_right(n[0] * (1 << 14) - h[0] * k, 15),
                   glint_shift_right(n[1] * (1 << 14) - h[1] * k, 15)};
    if (cosine < 0) {
        e.x += glint_shift_right(e.x * -cosine, 14);
        e.y += glint_shift_right(e.y * -cosine, 14);
    }
    if (cosine < -GLINT_UNIT / 2)
        e.x = INT16_MAX;
    return e;
}

/* Cuts a deviation off where it is beyond the reach of planes. @return flags */
static inline uint32_t cut_off(int32_t reach, deviation *e) {
    const int32_t x = glint_most(glint_least(e->x, reach), -reach), y = glint_most(glint_least(e->y, reach), -reach);
    const uint32_t flags = x != e->x || y != e->y ? GLINT_VERTEX_FAR : 0;
    e->x = x;
    e->y = y;
    return flags;
}

/* A deviation on the scale of planes. */
static inline int32_t scale_deviation(const glint_fast_terms *fast, int32_t e) {
    return glint_shift_right(glint_add_wrap(glint_multiply_wrap(e, fast->scale), fast->scaled_half), 16);
}

/* Which of two numbers are no less than a cut, given 2^15 less that: bits 31 and 15; and their negatives: 30 and 14. */
static inline uint32_t find_beyond(uint32_t cut, int32_t high, int32_t low) {
    const uint32_t both = ((uint32_t)high << 16) + (uint32_t)low;
    return ((cut + both) & 0x80008000) | (((cut - both) & 0x80008000) >> 1);
}

/* The sides of the octagon around the highlight that a deviation lies beyond; of the diagonal ones, by a little. Bits
 * above those of flags mean nothing. */
static inline uint32_t find_sides(const glint_fast_terms *fast, int32_t x, int32_t y) {
    const uint32_t straight = find_beyond(fast->sides[0], y, x);
    const uint32_t diagonal = find_beyond(fast->sides[1], glint_shift_right(x - y, 1), glint_shift_right(x + y, 1));
    const uint32_t all = straight | diagonal >> 2;
    return all | all >> 20;
}

/* Finds a vertex's scaled deviation. @return flags */
static GLINT_INLINE uint32_t find_terms(const glint_fast_terms *fast, const int16_t normal[3],
                                        const int16_t half_vector[3], int16_t terms[3]) {
    deviation e = find_deviation(normal, half_vector);
    uint32_t flags = 0;
    if ((glint_magnitude_bits(e.x) | glint_magnitude_bits(e.y)) > fast->within)
        flags = cut_off(fast->reach, &e);
    const int32_t x = scale_deviation(fast, e.x), y = scale_deviation(fast, e.y);
    terms[1] = (int16_t)x;
    terms[2] = (int16_t)y;
    return flags | find_sides(fast, x, y);
}

/* N.L, Q30. */
static inline int32_t find_cosine(const int32_t light[3], const int16_t normal[3]) {
    return light[0] * normal[0] + light[1] * normal[1] + light[2] * normal[2];
}

/* Finds a vertex's terms: N.L, Q14, and its scaled deviation. @return flags */
static inline uint32_t light_vertex(const glint_fast_terms *fast, const glint_vertex *vertex, int16_t terms[3]) {
    const int32_t cosine = glint_shift_right(find_cosine(fast->long_light, vertex->attribute), 16);
    const uint32_t dark = cosine <= fast->unlit && vertex->inverse_w >= NOT_DEEP ? GLINT_VERTEX_DARK : 0;
    const uint32_t flags = cosine >= fast->lit ? 0 : GLINT_VERTEX_DIM | dark;
    terms[0] = (int16_t)(cosine > GLINT_UNIT / 2 ? GLINT_UNIT / 2 : cosine);
    if (fast->local_viewer) {
        int16_t half_vector[3];
        glint_view_vector view;
        return glint_half_vector_inline(fast, 2 * vertex->x, 2 * vertex->y, half_vector, &view)
                   ? flags | find_terms(fast, vertex->attribute, half_vector, terms)
                   : GLINT_VERTEX_UNFIT;
    }
    if (fast->specular_end)
        return flags | find_terms(fast, vertex->attribute, fast->half_vector, terms);
    terms[1] = 0;
    terms[2] = 0;
    return flags | GLINT_VERTEX_ANY_OUTSIDE;
}

void glint_fast_light(const glint_frame *frame, glint_draw *draw, const glint_transform *transform, uint32_t i) {
    const glint_fast_terms *fast = draw->shading->fast;
    const uint16_t *index = draw->triangles[i];
    (void)frame;
    (void)transform;
    for (const uint16_t *end = index + 3; index < end; index++) {
        glint_vertex *vertex = &draw->vertices[*index];
        if (vertex->flags & GLINT_VERTEX_LIT)
            continue;
        if (!(vertex->flags & GLINT_VERTEX_NORMAL))
            glint_transform_normal(draw, vertex);
        if (vertex->flags & GLINT_VERTEX_CLIP)
            continue;
        const uint32_t flags = light_vertex(fast, vertex, draw->terms[*index]);
        vertex->flags = (uint16_t)(GLINT_VERTEX_NORMAL | GLINT_VERTEX_LIT | flags);
    }
}

/* ---- Triangles ---- */

uint32_t glint_fast_even(const glint_shading *shading, const glint_fast_planes *planes) {
    const int32_t cosine = planes->cosine.start;
    if (!shading->lights || cosine <= 0)
        return shading->fast->ambient_word;
    return shading->fast->diffuse ? shading->fast->diffuse[cosine >> 22] : glint_fast_word(shading, cosine, UINT32_MAX);
}

uint32_t glint_fast_covered(const glint_part *part) {
    uint32_t covered = 0;
    for (uint32_t row = part->top; row < part->bottom; row++)
        covered += (uint32_t)part->spans[row].right - part->spans[row].left;
    return covered;
}
