/* SPDX-License-Identifier: MIT */
/* Finds the vectors of suns: terms of vertices, and highlights of single fragments. suns.h */
#include "../geometry/draw.h"
#include "../raster/small.h"
#include "lamps.h"
#include "suns.h"

/* Makes a vector below GLINT_MOST_RAY unit, 1 = 2^bits, up to 15 bits. If its square is below `least`, it becomes 0. */
static GLINT_SPECIAL void make_vector_unit(int32_t v[3], uint32_t least, unsigned bits) {
    uint32_t square = (uint32_t)(v[0] * v[0]) + (uint32_t)v[1] * (uint32_t)v[1] + (uint32_t)v[2] * (uint32_t)v[2];
    if (square < least) {
        v[0] = v[1] = v[2] = 0;
        return;
    }
    if (bits == 15 && square >> 30) {
        v[0] = glint_shift_right(v[0], 1), v[1] = glint_shift_right(v[1], 1), v[2] = glint_shift_right(v[2], 1);
        square >>= 2;
    }
    const unsigned zeros = glint_leading_zeros(square) & ~1u, down = 16 - zeros / 2;
    const int32_t over = (int32_t)(glint_over_length(square << zeros) >> (15 - bits)), half = 1 << (down - 1);
    v[0] = glint_shift_right(v[0] * over + half, down);
    v[1] = glint_shift_right(v[1] * over + half, down);
    v[2] = glint_shift_right(v[2] * over + half, down);
}

/* Finds V, unit, at a point of the screen in sixteenths of a pixel. @return 0 if the point is too far outside */
static GLINT_SPECIAL int find_view(const glint_frame *frame, const glint_suns *suns, int32_t x, int32_t y, int32_t v[3],
                                   unsigned bits) {
    const int32_t scale = frame->view->ray_scale;
    int32_t none = 0;
    GLINT_OPAQUE(none); /* else compilers store both zeros from a register of the FPU */
    v[0] = v[1] = none;
    v[2] = 1 << bits;
    if (!suns->is_local)
        return 1;
    x = 8 * frame->config.width - x;
    y -= 8 * frame->config.height;
    if ((uint32_t)(x + suns->ray_limit) > 2 * (uint32_t)suns->ray_limit ||
        (uint32_t)(y + suns->ray_limit) > 2 * (uint32_t)suns->ray_limit)
        return 0;
    v[0] = glint_shift_right(x * scale, 15);
    v[1] = glint_shift_right(y * scale, 15);
    v[2] = suns->ray_z;
    make_vector_unit(v, 1, bits);
    return 1;
}

/* If |L + V|^2, 1 = 2^28, is below this, the direction of H is too imprecise: terms are then 0, and scalars do not
 * serve triangles that have them. */
#define LEAST_HALF (1u << 22)

/* sin^2, Q16, may be too large by this, because of rounding. */
#define OUTSIDE_MARGIN 16

/* Returns sin^2 of half the angle between V and the mirrored L, Q30, given N, L and V, 1 = 2^15: it is
 * (1 + L.V) / 2 - N.L N.V. */
static inline int32_t sine_of_mirrored(const int32_t n[3], const int32_t light[3], const int32_t v[3]) {
    const int32_t facing = glint_shift_right(n[0] * light[0] + n[1] * light[1] + n[2] * light[2], 15),
                  seen = glint_shift_right(n[0] * v[0] + n[1] * v[1] + n[2] * v[2], 15),
                  light_dot_view = glint_shift_right(light[0] * v[0] + light[1] * v[1] + light[2] * v[2], 15);
    return ((1 << 15) + light_dot_view) * (1 << 14) - facing * seen;
}

/* Finds a vertex's term of a light, given N, 1 = 2^15, and V, 1 = 2^14. */
static inline void find_term(const glint_suns *suns, const glint_drawn_sun *sun, const int32_t n[3], const int32_t v[3],
                             glint_sun_term *to) {
    int32_t h[3] = {v[0], v[1], v[2]}, sine;
    if (suns->is_mirror) {
        const int32_t twice[3] = {2 * v[0], 2 * v[1], 2 * v[2]};
        sine = sine_of_mirrored(n, sun->light, twice);
    } else {
        h[0] += glint_shift_right(sun->light[0], 1);
        h[1] += glint_shift_right(sun->light[1], 1);
        h[2] += glint_shift_right(sun->light[2], 1);
        make_vector_unit(h, LEAST_HALF, 14);
        const int32_t cosine = glint_shift_right(n[0] * h[0] + n[1] * h[1] + n[2] * h[2], 14);
        sine = h[0] | h[1] | h[2] ? (1 << 30) - cosine * cosine : 0;
    }
    to->v[0] = (int16_t)h[0], to->v[1] = (int16_t)h[1], to->v[2] = (int16_t)h[2];
    to->outside = (uint16_t)glint_least(glint_most(glint_shift_right(sine, 14) - OUTSIDE_MARGIN, 0), UINT16_MAX);
}

/* Finds the terms of a vertex. @return 0 if it has no V */
static int light_vertex(const glint_frame *frame, const glint_suns *suns, const glint_vertex *vertex,
                        glint_sun_term *to) {
    const int32_t n[3] = {vertex->attribute[0], vertex->attribute[1], vertex->attribute[2]};
    int32_t v[3];
    if (!suns->terms)
        return 1;
    if (!find_view(frame, suns, vertex->x, vertex->y, v, 14))
        return 0;
    for (const glint_drawn_sun *sun = suns->suns, *end = sun + suns->count; sun != end; sun++)
        if (sun->shines)
            find_term(suns, sun, n, v, to++);
    return 1;
}

void glint_light_sun_vertices(const glint_frame *frame, glint_draw *draw, const glint_transform *transform,
                              uint32_t i) {
    const glint_suns *suns = draw->shading->suns;
    (void)transform;
    for (int corner = 0; corner < 3; corner++) {
        const uint32_t index = draw->triangles[i][corner];
        glint_vertex *vertex = &draw->vertices[index];
        if (vertex->flags & GLINT_VERTEX_NORMAL)
            continue;
        glint_transform_normal(draw, vertex);
        if (!(vertex->flags & GLINT_VERTEX_CLIP) &&
            light_vertex(frame, suns, vertex, draw->terms + index * suns->terms))
            vertex->flags |= GLINT_VERTEX_LIT;
    }
}

/* ---- Fragments ---- */

/* The chord between N and H = L + V serves, as it is short inside of a highlight: errors of lengths count squared. */
GLINT_NOINLINE uint32_t glint_sine_by_chord(const int32_t n[3], const int32_t v[3], const int32_t l[3]) {
    const int32_t x = glint_shift_right(v[0] + l[0], 1), y = glint_shift_right(v[1] + l[1], 1),
                  z = glint_shift_right(v[2] + l[2], 1);
    uint32_t square = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z);
    if (square < 1u << 16)
        return 1u << 30;
    square = square < 1u << 30 ? square : (1u << 30) - 1;
    const unsigned zeros = glint_leading_zeros(square) & ~1u, down = 16 - zeros / 2;
    const int32_t over = (int32_t)glint_over_length(square << zeros), half = 1 << (down - 1);
    const int32_t dx = glint_shift_right(x * over + half, down) - n[0],
                  dy = glint_shift_right(y * over + half, down) - n[1],
                  dz = glint_shift_right(z * over + half, down) - n[2];
    const uint32_t chord = (uint32_t)dx * (uint32_t)dx + (uint32_t)dy * (uint32_t)dy + (uint32_t)dz * (uint32_t)dz;
    if (chord < 1u << 30)
        return chord - ((chord >> 15) * (chord >> 15) >> 2);
    return chord < 1u << 31 ? chord - (chord >> 16) * (chord >> 16) : 1u << 30;
}

uint32_t glint_find_sine(const glint_row_walk *walk, const glint_drawn_sun *sun, int32_t row, int32_t column,
                         const int32_t n[3]) {
    const glint_window *window = &walk->part->window;
    int32_t v[3];
    (void)find_view(walk->frame, walk->suns->suns, window->left + 16 * column, window->top + 16 * row, v, 15);
    if (!walk->suns->suns->is_mirror)
        return glint_sine_by_chord(n, v, sun->light);
    return (uint32_t)glint_most(sine_of_mirrored(n, sun->light, v), 0);
}
