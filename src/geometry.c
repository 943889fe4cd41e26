/* SPDX-License-Identifier: MIT */
/* Geometry: vertices to clip space, to the screen, and their normals to camera space. */
#include "frame.h"

void glint_project(const glint_transform *transform, const glint_position *position, glint_vertex *vertex) {
    unsigned zeros = glint_leading_zeros((uint32_t)position->w); /* w from 1 to 2^30: 1 to 31 */
    int64_t reciprocal = glint_reciprocal((uint32_t)position->w << zeros);
    /* x / w is x reciprocal 2^(zeros - 63); in Q17 it times the guard band's 16 x 1023 fits 31 bits */
    int32_t x = (int32_t)glint_shift_right64(position->x * reciprocal, 46 - zeros);
    int32_t y = (int32_t)glint_shift_right64(position->y * reciprocal, 46 - zeros);
    x = glint_shift_right(x * (16 * GLINT_GUARD_BAND) + (1 << 16), 17);
    y = glint_shift_right(y * (16 * GLINT_GUARD_BAND) + (1 << 16), 17);
    vertex->x = (int16_t)(x + transform->center_x);
    vertex->y = (int16_t)(y + transform->center_y);
    unsigned shift = 32 + transform->depth_shift - zeros;
    uint64_t inverse = shift < 64 ? (uint64_t)(transform->depth_mantissa * reciprocal) >> shift : 0;
    /* The nearest surface ends up just below the top, so that a plane's rounding cannot pass it. */
    vertex->inverse_w = inverse > 0x7fff0000u ? 0x7fff0000 : (int32_t)inverse;
}

static int32_t row(const int32_t matrix[3], int32_t translation, const int16_t p[3]) {
    int64_t sum = (int64_t)matrix[0] * p[0] + (int64_t)matrix[1] * p[1] + (int64_t)matrix[2] * p[2];
    return translation + (int32_t)glint_round_shift64(sum, 15);
}

/* Below 2^47 from 30-bit entries and Q15; 31 bits keep direction even where scales differ by 10^4. */
static int32_t normal_row(const int32_t matrix[3], const int16_t n[3]) {
    int64_t sum = (int64_t)matrix[0] * n[0] + (int64_t)matrix[1] * n[1] + (int64_t)matrix[2] * n[2];
    return (int32_t)glint_shift_right64(sum, 17);
}

static int is_outside(const glint_position *p, int32_t near_plane) {
    return p->w < near_plane || p->x >= p->w || p->x <= -p->w || p->y >= p->w || p->y <= -p->w;
}

void glint_transform_vertex(const glint_transform *transform, const glint_mesh *mesh, uint32_t index,
                            glint_vertex *vertex, glint_position *position) {
    const int16_t *p = mesh->positions[index], *n = mesh->normals[index];
    glint_position clip;
    clip.x = row(transform->matrix[0], transform->translation[0], p);
    clip.y = row(transform->matrix[1], transform->translation[1], p);
    clip.w = row(transform->matrix[2], transform->translation[2], p);
    if (position) {
        *position = clip;
        vertex->flags = is_outside(&clip, transform->near_plane) ? GLINT_VERTEX_CLIP : 0;
    } else {
        vertex->flags = 0;
    }
    if (vertex->flags)
        vertex->x = 0, vertex->y = 0, vertex->inverse_w = 0;
    else
        glint_project(transform, &clip, vertex);
    glint_unit(normal_row(transform->normal[0], n), normal_row(transform->normal[1], n),
               normal_row(transform->normal[2], n), vertex->attribute);
}

void glint_ray(const glint_transform *transform, const glint_view *view, const int64_t sum[3], int32_t count,
               int32_t ray[3], int32_t *inverse_w) {
    /* Half pixels, Q12, as rays of fragments are: x and y in guard bands, w in focal lengths; below 2^60. */
    const int64_t long_ray[3] = {-sum[0] * (2 * GLINT_GUARD_BAND * 4096), sum[1] * (2 * GLINT_GUARD_BAND * 4096),
                                 sum[2] * view->focal};
    int down = (int)transform->depth_shift - 31; /* the nearest w, Q31, which 1/w is relative to */
    int64_t nearest = down > 0 ? glint_shift_right64(transform->depth_mantissa, down < 63 ? (unsigned)down : 63u)
                               : transform->depth_mantissa * ((int64_t)1 << -down);
    nearest *= count; /* only its ratio to the ray matters */
    uint64_t bits = (uint64_t)nearest;
    for (int i = 0; i < 3; i++)
        bits |= glint_magnitude64(long_ray[i]);
    unsigned size = glint_bits64(bits), shift = size > 30 ? size - 30 : 0;
    for (int i = 0; i < 3; i++)
        ray[i] = (int32_t)glint_shift_right64(long_ray[i], shift);
    *inverse_w = (int32_t)glint_shift_right64(nearest, shift);
}
