/* SPDX-License-Identifier: MIT */
/* Does what differs for parallel rays (orthographic projection); view.h describes how. */
#include "geometry.h"

/* There are so many steps of depth from the nearest to the farthest. Pixels have one more, and planes room for
 * rounding. */
#define STEPS 65533

/* From this height on a pixel is at least 2^-18 of a unit wide. */
#define LEAST_HEIGHT (GLINT_ONE / 256)

/* The guard band has so many half pixels, Q12. This is a ray's z at the w of all. */
#define RAY_OF_W (2 * GLINT_GUARD_BAND * 4096)

/* A ray is no farther than this, so that with a share of 2^-16 of another it is at most 2^30. */
#define FARTHEST_RAY ((1 << 30) - (1 << 14))

static int is_valid_view(const glint_camera *camera) {
    return camera->view_height >= LEAST_HEIGHT;
}

/* Returns the guard band's width in units, from 2^19.99 to 2^54. */
static int64_t find_same_w(const glint_config *config, const glint_camera *camera) {
    const int64_t height = config->height;
    return ((int64_t)camera->view_height * (GLINT_GUARD_BAND << 12) + height / 2) / height;
}

/* Returns the range, which lies behind a view's lights. */
static glint_depth_range *range_of(const glint_view *view) {
    return (glint_depth_range *)(void *)((uint8_t *)(uintptr_t)view + GLINT_VIEW_SIZE(view->light_count));
}

static int64_t far_of(const glint_depth_range *range) {
    return (int64_t)((uint64_t)range->far_high << 32 | range->far_low);
}

/* Converts a distance to the units of rays. */
static int32_t to_ray(const glint_view *view, int64_t distance) {
    const int64_t w = view->nearest;
    if (distance / 127 >= w)
        return FARTHEST_RAY;
    const unsigned bits = glint_bits64((uint64_t)distance), down = bits > 39 ? bits - 39 : 0;
    return (int32_t)((distance >> down) * RAY_OF_W / ((w >> down) + (w >> down == 0)));
}

static void set_range(glint_view *view, int64_t nearest, int64_t farthest) {
    glint_depth_range *const to = range_of(view);
    const int64_t range = farthest > nearest ? farthest - nearest : 1;
    const int down = (int)glint_bits64((uint64_t)range) - 31;
    const int64_t mantissa = (down > 0 ? range >> down : range << -down) | 1;
    to->far_low = (uint32_t)farthest;
    to->far_high = (uint32_t)(farthest >> 32);
    to->scale = (uint32_t)(((int64_t)1 << 61) / mantissa);
    to->shift = down;
    to->range_ray = to_ray(view, range + range / (STEPS / 3));
    to->far_ray = to_ray(view, farthest) + (to->range_ray >> 16);
}

/* Returns a depth: 2^15 at the farthest, 2^15 STEPS more at the nearest, off by 2^-22 of that. A distance of more than
 * 2^7 ranges counts as that. */
static int64_t depth_of_w(const glint_view *view, int64_t w) {
    const glint_depth_range *const range = range_of(view);
    const int64_t nearer = far_of(range) - w, most = (int64_t)1 << 30;
    const int down = range->shift + 8; /* a range has 23 bits then */
    int64_t part = down > 0 ? glint_shift_right64(nearer, (unsigned)down) : 0;
    if (down <= 0)
        part = nearer > most || nearer < -most ? nearer : nearer * ((int64_t)1 << glint_least(-down, 31));
    part = part > most ? most : part < -most ? -most : part;
    const int64_t depth = glint_shift_right64(part * range->scale, 22);
    return (1 << 15) + glint_shift_right64(depth * STEPS, 16);
}

static void finish_depths(const glint_view *view, const glint_transform *transform, glint_vertex *vertices,
                          uint32_t count) {
    for (uint32_t i = 0; i < count; i++) {
        if (vertices[i].flags & GLINT_VERTEX_CLIP)
            continue;
        const int64_t w = glint_shift_round64(vertices[i].inverse_w, transform->exponent - 28);
        const int64_t step = glint_shift_right64(depth_of_w(view, w) + (1 << 14), 15);
        vertices[i].inverse_w = GLINT_DEPTH_TOP + (int32_t)(step < 1 ? 1 : step > STEPS + 1 ? STEPS + 1 : step);
    }
}

static int32_t distance_of(const glint_view *view, int32_t depth) {
    const glint_depth_range *const range = range_of(view);
    return range->far_ray - (int32_t)glint_shift_right64(glint_product(depth, range->range_ray), 31);
}

static void get_range(const glint_view *view, int64_t *farthest, int64_t *range) {
    const glint_depth_range *const from = range_of(view);
    const int64_t mantissa = ((int64_t)1 << 61) / from->scale;
    *farthest = far_of(from);
    *range = from->shift > 0 ? mantissa << from->shift : mantissa >> -from->shift;
}

const glint_projection glint_orthographic = {is_valid_view, find_same_w, set_range, finish_depths,
                                             distance_of,   depth_of_w,  get_range};
