/* SPDX-License-Identifier: MIT */
/* Brings vertices to clip space and to the screen, and their normals to camera space. */
#include "geometry.h"

#include "../math/division.h"
#include "draw.h"

/*
 * Returns the nearest w over w, Q31, from the inverse of w; with 6 bits more where w is at least 64 to 128 times the
 * nearest. The inverse itself has 18 bits. The lowest byte of a coordinate need not count. That of the nearest w does,
 * which may be far below w. The nearest surface ends up just below the top, so that a plane's rounding cannot pass it.
 * The farthest ends up above 0, so that 1/w can be divided by.
 */
static inline int32_t to_inverse_w(int32_t nearest, uint32_t inverse) {
    const unsigned more = nearest < (1 << 22) - (1 << 8) ? 6 : 0; /* 64 times this stays below the top */
    nearest = glint_shift_left(nearest, more);
    const int32_t depth = glint_scale(nearest, inverse) + (int32_t)(((uint32_t)nearest & 0xff) * inverse >> 23);
    return glint_most(glint_shift_left(glint_least(depth, 0x7fff0000 >> 6), 6 - more), 64);
}

/* Projects clip coordinates inside the guard band and beyond the near plane. w is from 1 up and no less than the
 * nearest. */
static GLINT_SPECIAL void project(const glint_transform *transform, int32_t x, int32_t y, int32_t w,
                                  glint_vertex *vertex) {
    int32_t nearest = transform->nearest;
    if (w < 1 << 28) {
        unsigned up = 1;
        for (w *= 2; w < 1 << 28;
             w *= 2) /* mostly one step, unless w is near or the depth ratio large: faster than counting zeros */
            up++;
        x = glint_shift_left(x, up);
        y = glint_shift_left(y, up);
        nearest = glint_shift_left(nearest, up);
    }
    uint32_t inverse = glint_inverse((uint32_t)w);
    vertex->inverse_w = to_inverse_w(nearest, inverse);
    inverse -= inverse >> 10; /* GUARD_BAND is 1023 pixels, the divisor 1024: sixteenths are Q14 */
    x = glint_scale(x, inverse) + transform->center_x;
    y = glint_scale(y, inverse) + transform->center_y;
    vertex->x = (int16_t)glint_shift_right(x, 11);
    vertex->y = (int16_t)glint_shift_right(y, 11);
}

void glint_project(const glint_transform *transform, const glint_position *position, glint_vertex *vertex) {
    const int is_parallel = transform->clips & GLINT_PARALLEL;
    project(transform, position->x, position->y, is_parallel ? transform->nearest : position->w, vertex);
    if (is_parallel)
        vertex->inverse_w = position->w;
}

static int is_outside(int32_t x, int32_t y, int32_t w, int32_t near_plane) {
    return w < near_plane || x >= w || x <= -w || y >= w || y <= -w;
}

/* Returns the clip coordinates of a position of the mesh. */
static inline glint_position to_clip_space(const glint_transform *transform, const int16_t p[3]) {
    const int32_t *t = transform->translation;
    return (glint_position){glint_row_times(&transform->matrix[0], p[0], p[1], p[2], t[0]),
                            glint_row_times(&transform->matrix[1], p[0], p[1], p[2], t[1]),
                            glint_row_times(&transform->matrix[2], p[0], p[1], p[2], t[2])};
}

/* Transforms vertices of parallel rays, which all have the same w. */
static GLINT_NOINLINE void transform_parallel(const glint_transform *transform, const int16_t (*p)[3], uint32_t first,
                                              uint32_t count, glint_vertex *vertex, glint_position *position) {
    for (const glint_vertex *end = vertex + count; vertex < end; vertex++, p++, position++, first++) {
        *position = to_clip_space(transform, *p);
        *vertex = (glint_vertex){.attribute = {(int16_t)(uint16_t)first}, .flags = GLINT_VERTEX_CLIP};
        if (position->w < transform->near_plane || is_outside(position->x, position->y, transform->nearest, 0))
            continue;
        vertex->flags = 0;
        glint_project(transform, position, vertex);
    }
}

/* Counts the leading zeros of a w of 29 to 31 bits. */
static inline uint32_t zeros_of_w(uint32_t w) {
    if (GLINT_COUNTS_ZEROS)
        return glint_leading_zeros(w);
    return w >> 30 ? 1 : w >> 29 ? 2 : 3;
}

/* Transforms vertices of objects that the short matrix serves. With w = W 2^zeros in 32 bits and its 16 high bits
 * rounded, 2^47 / w is exact to 2^-16 of itself. */
static GLINT_NOINLINE void transform_brief(const glint_transform *transform, const int16_t (*p)[3], uint32_t first,
                                           uint32_t count, glint_vertex *vertex) {
    const glint_short_matrix *m = &transform->brief;
    const int32_t center_x = transform->center_x, center_y = transform->center_y;
    for (const glint_vertex *end = vertex + count; vertex < end; vertex++, p++, first++) {
        GLINT_OPAQUE(m);      /* otherwise all of it is copied to the stack, which saves no load */
        GLINT_OPAQUE(vertex); /* otherwise gcc counts differently */
        GLINT_OPAQUE(p);
        GLINT_OPAQUE(first);
        const int32_t x = (*p)[0], y = (*p)[1], z = (*p)[2];
        const uint32_t w = (uint32_t)(m->w[3] + m->w[0] * x + m->w[1] * y + m->w[2] * z), zeros = zeros_of_w(w);
        const int32_t r = glint_reciprocal16(((w << zeros >> 15) + 1) >> 1);
        const int32_t sx = glint_shift_right(m->x[3] + m->x[0] * x + m->x[1] * y + m->x[2] * z, 16) * r;
        const int32_t sy = glint_shift_right(m->y[3] + m->y[0] * x + m->y[1] * y + m->y[2] * z, 16) * r;
        const uint32_t down = m->shift - zeros;
        vertex->inverse_w = (int32_t)(m->nearest * (uint32_t)r >> (m->depth_shift - zeros));
        vertex->x = (int16_t)glint_shift_right(glint_shift_right(sx, down) + center_x, 11);
        vertex->y = (int16_t)glint_shift_right(glint_shift_right(sy, down) + center_y, 11);
        vertex->attribute[0] = (int16_t)(uint16_t)first;
        vertex->flags = 0;
    }
}

/* Transforms vertices that the short matrix does not serve, and keeps their positions where there is room for them. */
static GLINT_NOINLINE void transform_long(const glint_transform *transform, const int16_t (*p)[3], uint32_t first,
                                          uint32_t count, glint_vertex *vertex, glint_position *position) {
    for (const glint_vertex *end = vertex + count; vertex < end; vertex++, p++, first++) {
        GLINT_OPAQUE(vertex); /* otherwise gcc counts differently */
        GLINT_OPAQUE(p);
        const glint_position here = to_clip_space(transform, *p);
        vertex->attribute[0] = (int16_t)(uint16_t)first;
        vertex->flags = 0;
        if (position)
            *position++ = here;
        if (transform->clips && is_outside(here.x, here.y, here.w, transform->near_plane)) {
            vertex->flags = GLINT_VERTEX_CLIP;
            vertex->x = vertex->y = 0;
            vertex->inverse_w = 0;
        } else {
            project(transform, here.x, here.y, here.w, vertex);
        }
    }
}

/* Transforms any vertices. */
static GLINT_INLINE void transform_all(const glint_transform *transform, const int16_t (*p)[3], uint32_t first,
                                       uint32_t count, glint_vertex *vertex, glint_position *position) {
    if (transform->brief.serves) {
        transform_brief(transform, p, first, count, vertex);
        for (uint32_t i = 0; i < count && position; i++)
            position[i] = to_clip_space(transform, p[i]);
    } else if (transform->clips & GLINT_PARALLEL) {
        transform_parallel(transform, p, first, count, vertex, position);
    } else {
        transform_long(transform, p, first, count, vertex, position);
    }
}

void glint_transform_array(const glint_transform *transform, const glint_mesh *mesh, uint32_t first, uint32_t count,
                           glint_vertex *vertex, glint_position *position) {
    transform_all(transform, mesh->positions + first, first, count, vertex, position);
}

void glint_transform_steps(const glint_transform *transform, const int16_t (*p)[3], uint32_t first, uint32_t count,
                           glint_vertex *vertex, glint_position *position) {
    transform_all(transform, p, first, count, vertex, position);
}

/* A rotated normal of 32767 has this half length, may be off by this tolerance, and its square lies in this range. */
#define HALF_LENGTH 16380
#define HALF_TOLERANCE 3
#define LEAST_SQUARE ((uint32_t)(HALF_LENGTH - HALF_TOLERANCE) * (HALF_LENGTH - HALF_TOLERANCE))
#define SQUARES ((uint32_t)HALF_LENGTH * 4 * HALF_TOLERANCE)

/* A unit normal keeps its length when the object is rotated and scaled evenly. Then it need not be normalised. */
void glint_transform_normal(const glint_draw *draw, glint_vertex *vertex) {
    const int16_t *n = draw->normals[(uint16_t)vertex->attribute[0]];
    const glint_row *matrix = draw->transform.normal;
    GLINT_OPAQUE(matrix); /* its entries lie too far from `draw` for short loads */
    vertex->flags |= GLINT_VERTEX_NORMAL;
    const int32_t half = 1 << 12;
    int32_t x = glint_row_times(&matrix[0], n[0], n[1], n[2], half);
    int32_t y = glint_row_times(&matrix[1], n[0], n[1], n[2], half);
    int32_t z = glint_row_times(&matrix[2], n[0], n[1], n[2], half);
    const uint32_t a = (uint32_t)glint_shift_right(x, 14), b = (uint32_t)glint_shift_right(y, 14),
                   c = (uint32_t)glint_shift_right(z, 14);
    uint32_t square = a * a + b * b + c * c; /* at most 9 2^28, which a single component may have */
    if (square - LEAST_SQUARE > SQUARES) {
        glint_unit(x - half, y - half, z - half, vertex->attribute);
        return;
    }
    vertex->attribute[0] = (int16_t)glint_shift_right(x, 13);
    vertex->attribute[1] = (int16_t)glint_shift_right(y, 13);
    vertex->attribute[2] = (int16_t)glint_shift_right(z, 13);
}

void glint_transform_normals(const glint_frame *frame, glint_draw *draw, const glint_transform *transform, uint32_t i) {
    (void)frame;
    (void)transform;
    for (int corner = 0; corner < 3; corner++) {
        glint_vertex *vertex = &draw->vertices[draw->triangles[i][corner]];
        if (!(vertex->flags & GLINT_VERTEX_NORMAL))
            glint_transform_normal(draw, vertex);
    }
}
