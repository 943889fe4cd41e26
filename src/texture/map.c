/* SPDX-License-Identifier: MIT */
/* Maps: from pixels to coordinates of a texture. texture.h */
#include "../light/evaluation.h"
#include "../math/division.h"
#include "../raster/small.h"
#include "texture.h"

/* ---- Corners ---- */

/* Coordinates of a triangle: those of the first corner, and the differences of the others, 2^32 being a width. */
typedef struct corner_coordinates {
    int64_t first[2];
    int64_t to[2][2];
    uint64_t most[2]; /* the larger magnitude of the differences */
} corner_coordinates;

/* Returns the numbers of the corners of a triangle in its mesh, in the order of its draw. */
static const uint16_t *find_numbers(const glint_row_walk *walk, const glint_mesh *mesh, uint16_t fetched[3]) {
    const glint_draw *draw = walk->draw;
    const uint32_t index = walk->triangle.index;
    return glint_triangle_of(mesh, draw->first_triangle + (draw->origin ? draw->origin[index] : index), fetched);
}

/* Finds the coordinates of corners of given numbers in the mesh. */
static void find_coordinates_of(const glint_mesh *mesh, const uint16_t number[3], corner_coordinates *to) {
    const int16_t *const a = mesh->texture_coordinates[number[0]], *const b = mesh->texture_coordinates[number[1]],
                         *const c = mesh->texture_coordinates[number[2]];
    for (int k = 0; k < 2; k++) {
        const int32_t extent = mesh->texture_extent[k];
        to->first[k] = (int64_t)mesh->texture_offset[k] * (1 << 16) + 2 * glint_product(extent, a[k]);
        to->to[0][k] = 2 * glint_product(extent, b[k] - a[k]);
        to->to[1][k] = 2 * glint_product(extent, c[k] - a[k]);
        const uint64_t most_b = glint_magnitude64(to->to[0][k]), most_c = glint_magnitude64(to->to[1][k]);
        to->most[k] = most_b > most_c ? most_b : most_c;
    }
}

/* ---- Edges ---- */

/* Leaves a coordinate out: in textures of one column or row it has no bits. */
static GLINT_NOINLINE void leave_out(corner_coordinates *c, int k) {
    int32_t none = 0;
    GLINT_OPAQUE(none); /* else compilers store zeros from a register of the FPU */
    c->first[k] = none;
    c->to[0][k] = c->to[1][k] = none;
    c->most[k] = (uint64_t)none;
}

/* Divides coordinates of a texture that does not repeat by a power of two, so that they fit with their signs, and have
 * room beyond the corners'. */
static GLINT_NOINLINE void clamp_coordinates(glint_texture_map *map, corner_coordinates *c, int k) {
    const uint64_t all = (uint64_t)1 << 32 | glint_magnitude64(c->first[k]) |
                         glint_magnitude64(c->first[k] + c->to[0][k]) | glint_magnitude64(c->first[k] + c->to[1][k]);
    const unsigned by = glint_bits64(all) - 30;
    map->beyond[k] = (uint8_t)by;
    c->first[k] = glint_shift_right64(c->first[k], by);
    c->to[0][k] = glint_shift_right64(c->to[0][k], by);
    c->to[1][k] = glint_shift_right64(c->to[1][k], by);
}

/* Begins the edges of a texture. */
static void begin_edges(glint_texture_map *map, const glint_material *material, corner_coordinates *c) {
    map->is_bilinear = (material->flags & GLINT_MATERIAL_BILINEAR) != 0;
    map->is_plain = !(material->flags & (GLINT_MATERIAL_CLAMP | GLINT_MATERIAL_BILINEAR));
    for (int k = 0; k < 2; k++) {
        const uint32_t size = k ? map->texture->height : map->texture->width;
        map->beyond[k] = 0;
        if (material->flags & GLINT_MATERIAL_CLAMP)
            clamp_coordinates(map, c, k);
        map->to_texels[k] = (int8_t)((int32_t)glint_leading_zeros(size) - 7 - map->beyond[k]);
        if (size == 1)
            leave_out(c, k);
    }
}

/* ---- Quadratics ---- */

/*
 * Let L be the change of a coordinate from the first corner as if it were linear on the screen, G that of 1/w in parts
 * of its mean, and d and g their differences at the other corners, whose weights on the screen are w1 and w2. To second
 * order, the coordinate changes by L + (d1 g1 w1 + d2 g2 w2) - L G: exact at corners, and elsewhere off by up to d g^2
 * / 8.
 */

/* Quadratics serve where d g^2 is at most a quarter of a texel, 2^-22. */
#define MOST_ERROR (1u << 20)

/* Finds g1 and g2, Q16. @return whether they are small enough */
static int find_depth_changes(const glint_row_walk *walk, const glint_texture *texture, const corner_coordinates *c,
                              int32_t g[2]) {
    const glint_vertex *const *v = walk->from_top;
    const int32_t a = v[0]->inverse_w, b = v[1]->inverse_w - a, d = v[2]->inverse_w - a;
    const uint32_t mean = (uint32_t)a + (uint32_t)glint_shift_right(b, 2) + (uint32_t)glint_shift_right(d, 2);
    if ((c->most[0] | c->most[1]) >> 34 || glint_magnitude_bits(b) >= mean / 2 || glint_magnitude_bits(d) >= mean / 2)
        return 0;
    const uint32_t zeros = glint_leading_zeros(mean);
    const int32_t over = walk->frame->view->is_parallel ? 0 : glint_reciprocal16(mean << zeros >> 16);
    g[0] = glint_shift_right(glint_shift_right(glint_shift_left(b, zeros), 16) * over, 15);
    g[1] = glint_shift_right(glint_shift_right(glint_shift_left(d, zeros), 16) * over, 15);
    const uint32_t most = glint_magnitude_bits(g[0]) | glint_magnitude_bits(g[1]);
    const uint32_t texels =
        (uint32_t)(c->most[0] >> 12) * texture->width | (uint32_t)(c->most[1] >> 12) * texture->height; /* 2^-20 */
    return (most * most >> 16) * (texels >> 14) <= MOST_ERROR;
}

/* Slopes times differences of this many bits in all do not overflow. */
#define MOST_BITS 28

/* Returns the product of two changes, 2^-32 and Q30, 2^-32. */
static inline uint32_t multiply_changes(int32_t a, int32_t b) {
    return (uint32_t)glint_shift_right(glint_shift_right(a, 14) * glint_shift_right(b, 14), 2);
}

/* Sets the quadratic of a coordinate. @return 0 where it is too steep */
static int set_texture_quadratic(const glint_slopes *s, const corner_coordinates *c, int k, const int32_t g[2],
                                 glint_quadratic *to) {
    const int32_t d1 = (int32_t)glint_shift_right64(c->to[0][k] + (1 << 13), 14),
                  d2 = (int32_t)glint_shift_right64(c->to[1][k] + (1 << 13), 14);
    const uint32_t steep = glint_magnitude_bits(s->x1) | glint_magnitude_bits(s->x2) | glint_magnitude_bits(s->y1) |
                           glint_magnitude_bits(s->y2);
    if (glint_leading_zeros((glint_magnitude_bits(d1) | glint_magnitude_bits(d2)) | 1) +
            glint_leading_zeros(steep | 1) <
        64 - MOST_BITS)
        return 0;
    const int32_t l = (int32_t)glint_weigh(d1, s->start1, d2, s->start2),
                  lx = (int32_t)glint_weigh(d1, s->x1, d2, s->x2), ly = (int32_t)glint_weigh(d1, s->y1, d2, s->y2);
    const int32_t h = (int32_t)glint_weigh(g[0], s->start1, g[1], s->start2),
                  hx = (int32_t)glint_weigh(g[0], s->x1, g[1], s->x2),
                  hy = (int32_t)glint_weigh(g[0], s->y1, g[1], s->y2);
    const int32_t e1 = d1 + glint_shift_right(glint_shift_right(d1, 3) * glint_shift_right(g[0], 1), 12),
                  e2 = d2 + glint_shift_right(glint_shift_right(d2, 3) * glint_shift_right(g[1], 1), 12);
    to->value = (uint32_t)c->first[k] + glint_weigh(e1, s->start1, e2, s->start2) - multiply_changes(l, h);
    to->x = glint_weigh(e1, s->x1, e2, s->x2) - multiply_changes(l, hx) - multiply_changes(lx, h);
    to->y = glint_weigh(e1, s->y1, e2, s->y2) - multiply_changes(l, hy) - multiply_changes(ly, h);
    to->xx = 0u - multiply_changes(lx, hx);
    to->xy = 0u - multiply_changes(lx, hy) - multiply_changes(ly, hx);
    to->yy = 0u - multiply_changes(ly, hy);
    return 1;
}

/* Sets the quadratics of a small triangle. @return 0 where they do not serve it */
static GLINT_NOINLINE int set_texture_quadratics(const glint_row_walk *walk, const corner_coordinates *c,
                                                 glint_texture_map *map) {
    glint_slopes s;
    int32_t g[2];
    if (!walk->has_slopes || glint_is_deep(&walk->triangle) || !find_depth_changes(walk, map->texture, c, g))
        return 0;
    glint_find_slopes(&walk->corners, &s);
    map->origin = s.column;
    map->by.quadratic.row = s.row;
    if (!set_texture_quadratic(&s, c, 0, g, &map->by.quadratic.of[0]) ||
        !set_texture_quadratic(&s, c, 1, g, &map->by.quadratic.of[1]))
        return 0;
    map->left = INT32_MIN;
    map->right = INT32_MAX;
    return 1;
}

/* ---- Coordinates that are divided ---- */

/* A number that is linear on the screen: its value at a point, and its change over a sixteenth of a pixel. */
typedef struct exact_plane {
    int64_t value, x, y;
} exact_plane;

/* The numerators of both coordinates, and 1/w, from a point on, in sixteenths. All have the same unit. */
typedef struct exact_planes {
    exact_plane over[2], under;
    int32_t x, y;
    uint64_t most; /* the largest 1/w of the corners */
} exact_planes;

/* Brings differences to 30 bits. @return how many bits they have lost */
static uint32_t reduce_differences(const glint_texture_map *map, const corner_coordinates *c, int k, int32_t to[2]) {
    const unsigned bits = glint_bits64(c->most[k] >> map->beyond[k]), down = bits > 30 ? bits - 30 : 0;
    to[0] = (int32_t)glint_shift_right64(c->to[0][k], down);
    to[1] = (int32_t)glint_shift_right64(c->to[1][k], down);
    return down;
}

/*
 * Finds the planes of a triangle that is not clipped. The weights of corners are areas on the screen; times 1/w of the
 * corners, 30 bits, they are those in space.
 */
static GLINT_NOINLINE void find_by_areas(const glint_row_walk *walk, const corner_coordinates *c,
                                         glint_texture_map *map, const glint_vertex *const v[3], exact_planes *to) {
    const unsigned up = glint_find_room(v);
    const int32_t x1 = v[1]->x - v[0]->x, y1 = v[1]->y - v[0]->y, x2 = v[2]->x - v[0]->x, y2 = v[2]->y - v[0]->y;
    const int32_t twice = x1 * y2 - x2 * y1, sign = twice < 0 ? -1 : 1;
    int32_t z[3];
    for (int i = 0; i < 3; i++)
        z[i] = walk->frame->view->is_parallel ? 1 << 29 : glint_shift_left(v[i]->inverse_w, up) >> 1;
    const int32_t b = sign * (z[1] - z[0]), d = sign * (z[2] - z[0]);
    int32_t none = 0;
    GLINT_OPAQUE(none); /* else compilers store a zero from a register of the FPU */
    to->x = v[0]->x, to->y = v[0]->y;
    to->under.value = glint_product(z[0], sign * twice);
    to->under.x = glint_product(b, y2) - glint_product(d, y1);
    to->under.y = glint_product(d, x1) - glint_product(b, x2);
    to->most = (uint64_t)glint_product(glint_most_of(z[0], z[1], z[2]), sign * twice);
    for (int k = 0; k < 2; k++) {
        int32_t change[2];
        map->by.quotient.up[k] = (uint8_t)reduce_differences(map, c, k, change);
        const int32_t p = sign * (int32_t)glint_shift_right64(glint_product(z[1], change[0]), 30),
                      q = sign * (int32_t)glint_shift_right64(glint_product(z[2], change[1]), 30);
        to->over[k].value = none;
        to->over[k].x = glint_product(p, y2) - glint_product(q, y1);
        to->over[k].y = glint_product(q, x1) - glint_product(p, x2);
    }
}

/* Sets the cross product of the positions of two corners: its product with a ray is the weight of the third, over w. */
static GLINT_NOINLINE void cross_positions(int32_t p[3][3], int third, int64_t to[3]) {
    const uint8_t *const order = glint_corner_order((uint32_t)third);
    const int32_t *const a = p[order[1]], *const b = p[order[2]];
    for (int j = 0; j < 3; j++) {
        const uint8_t *const axis = glint_corner_order((uint32_t)j);
        to[j] = glint_product(a[axis[1]], b[axis[2]]) - glint_product(a[axis[2]], b[axis[1]]);
    }
}

/* Rays have x and y in sixteenths from the screen's centre, and as z the guard band. */
static exact_plane plane_of_ray(const int64_t ray[3]) {
    return (exact_plane){ray[2] * (GLINT_GUARD_BAND * 16), ray[0], ray[1]};
}

/*
 * Finds the planes of a triangle that is clipped, from the positions of its corners, some of which are on no screen.
 * The weights of corners are determinants of a ray and two positions (Olano and Greer, 1997).
 */
static GLINT_NOINLINE void find_by_rays(const glint_row_walk *walk, const corner_coordinates *c, glint_texture_map *map,
                                        const uint16_t *corners, exact_planes *to) {
    const glint_draw *draw = walk->draw;
    int32_t p[3][3], weight[3][3];
    int64_t n[3], sign = 0;
    uint64_t all = 0;
    for (int i = 0; i < 3; i++) {
        const glint_position *from = &draw->positions[corners[i]];
        p[i][0] = from->x, p[i][1] = from->y;
        p[i][2] = draw->transform.clips & GLINT_PARALLEL ? draw->transform.nearest : from->w;
    }
    for (int i = 0; i < 3; i++) {
        cross_positions(p, i, n);
        for (int j = 0; j < 3; j++)
            all |= glint_magnitude64(n[j]);
    }
    const unsigned bits = glint_bits64(all), down = bits > 29 ? bits - 29 : 0;
    for (int i = 0; i < 3; i++) {
        cross_positions(p, i, n); /* again: all nine would be much of the stack */
        for (int j = 0; j < 3; j++)
            weight[i][j] = (int32_t)glint_shift_right64(n[j], down);
    }
    for (int j = 0; j < 3; j++)
        sign += glint_product(p[0][j], weight[0][j]);
    sign = sign < 0 ? -1 : 1;
    for (int j = 0; j < 3; j++)
        n[j] = sign * (1 << 15) * ((int64_t)weight[0][j] + weight[1][j] + weight[2][j]);
    to->under = plane_of_ray(n);
    for (int k = 0; k < 2; k++) {
        int32_t d[2];
        map->by.quotient.up[k] = (uint8_t)reduce_differences(map, c, k, d);
        for (int j = 0; j < 3; j++)
            n[j] =
                sign * glint_shift_right64(glint_product(weight[1][j], d[0]) + glint_product(weight[2][j], d[1]), 15);
        to->over[k] = plane_of_ray(n);
    }
    to->x = 8 * walk->frame->config.width, to->y = 8 * walk->frame->config.height;
    to->most = 1;
    for (int i = 0; i < 3; i++) {
        const glint_vertex *v = walk->triangle.corners[i];
        const int64_t there = to->under.value + (v->x - to->x) * to->under.x + (v->y - to->y) * to->under.y;
        to->most |= (uint64_t)(there > 0 ? there : 0);
    }
}

/* Sets a plane of 2^-down of an exact one, by way of the pixel of its point: rounding is the same in every tile. */
static void set_map_plane(const glint_row_walk *walk, const exact_planes *planes, const exact_plane *from, int down,
                          glint_plane *to) {
    const int64_t start = from->value + from->x * (8 - (planes->x & 15)) + from->y * (8 - (planes->y & 15));
    const glint_window *window = &walk->part->window;
    to->dx = (int32_t)glint_shift_round64(16 * from->x, down);
    to->dy = (int32_t)glint_shift_round64(16 * from->y, down);
    to->start = (int32_t)glint_shift_round64(start, down);
    to->start = glint_plane_at(to, glint_shift_right(window->left, 4) - glint_shift_right(planes->x, 4),
                               glint_shift_right(window->top, 4) - glint_shift_right(planes->y, 4));
}

static void set_map_planes(const glint_row_walk *walk, const exact_planes *planes, glint_texture_map *map) {
    const int down = (int)glint_bits64(planes->most) - 30;
    set_map_plane(walk, planes, &planes->under, down, &map->by.quotient.under);
    set_map_plane(walk, planes, &planes->over[0], down, &map->by.quotient.over[0]);
    set_map_plane(walk, planes, &planes->over[1], down, &map->by.quotient.over[1]);
}

/* ---- Quotients ---- */

/* Returns 2^62 / x for x from 2^31, off by 2^-29 of itself: one Newton step from 16 bits. */
static inline int32_t find_over(uint32_t x) {
    const uint32_t rough = (uint32_t)glint_reciprocal16(x >> 16) << 15;
    const int32_t error = (int32_t)((1u << 30) - glint_product_high_unsigned(rough, x));
    const uint32_t over = rough + (uint32_t)glint_shift_right((int32_t)(rough >> 16) * error, 14);
    return (int32_t)(over >> 31 ? INT32_MAX : over);
}

/* A number by which others are divided. */
typedef struct divisor {
    int32_t z, over;
    uint32_t up;
} divisor;

/* Sets a divisor. */
static inline divisor begin_divisor(int32_t z) {
    const uint32_t up = glint_leading_zeros((uint32_t)z) - 1;
    return (divisor){z, find_over((uint32_t)z << up << 1), up};
}

/* Returns x / z, Q28. */
static inline int32_t divide_by(const divisor *d, int32_t x) {
    return 2 *
           glint_product_high(d->up > 2 ? glint_shift_left(x, d->up - 2) : glint_shift_right(x, 2 - d->up), d->over);
}

/* Is |x| below 4 z, so that it can be divided? */
static inline int is_divisible(int32_t x, int32_t z) {
    return (uint32_t)glint_shift_right(x, 2) + (uint32_t)z - 1 < 2 * (uint32_t)z - 1;
}

/* ---- Runs ---- */

/*
 * Runs are parts of a row of the screen that are aligned to their size. Around the middle, let G be the change of 1/w
 * from pixel to pixel in parts of itself, and L that of a coordinate. x pixels further the coordinate has changed by
 * L x - L G x^2 to second order, and is off by L G^2 x^3 / (1 - |G x|), up to (1 + 2 |G x|) L G^2 x^3.
 */

/* Coordinates are to be off by at most a sixteenth of a texel, 2^-12, of which rounding may take a sixteenth, and the 5
 * bits of weights between texels a quarter. */
#define MOST_RUN_ERROR(map) ((map)->is_bilinear ? 11u << 4 : 15u << 4)

/* Binary logarithms of the largest and the smallest size of runs, but for single pixels. */
#define LONG_SHIFT 5
#define SHORT_SHIFT 2

/* Returns a change, 2^(up - 32), in texels, 2^-12, or more than 11 bits. */
static inline uint32_t to_texels(uint32_t change, uint32_t size, uint32_t up) {
    const uint32_t texels = (change >> 10) * size; /* 2^-22, times 2^up */
    return up <= 10 ? texels >> (10 - up) : texels >> (42 - up) ? UINT32_MAX : texels << (up - 10);
}

/* Returns by how much coordinates are off half a run's size away, 2^-12 of a texel, or more than fits, and sets how
 * much more if they are linear. */
static inline uint32_t find_run_error(const glint_texture_map *map, int32_t u, int32_t v, int32_t g, unsigned shift,
                                      uint32_t *bend) {
    const uint32_t texels = to_texels(glint_magnitude_bits(u), map->texture->width,
                                      map->by.quotient.up[0] + map->beyond[0]) |
                            to_texels(glint_magnitude_bits(v), map->texture->height,
                                      map->by.quotient.up[1] + map->beyond[1]),
                   change = glint_magnitude_bits(g) >> (15 - shift), /* Q16, up to 1/2 */
        square = change * change >> 16;
    *bend = change * (texels >> (5 - shift)) >> 12;
    return texels >> 16 ? UINT32_MAX : (square + (square * change >> 15)) * (texels >> (5 - shift)) >> 12;
}

/* Sets a coordinate of the run around a middle. */
static inline void set_run(glint_texture_map *map, int k, int32_t middle, int32_t slope, int32_t g) {
    const uint32_t up = map->by.quotient.up[k];
    map->run[k] = (glint_texture_run){map->by.quotient.first[k] + ((uint32_t)middle << up), (uint32_t)slope << up,
                                      0u - ((uint32_t)(4 * glint_product_high(slope, g)) << up)};
}

/* Finds a run of a size, from a column on. @return the size that serves, or 0 */
static GLINT_NOINLINE unsigned find_run(glint_texture_map *map, int32_t row, int32_t column, unsigned shift) {
    const int32_t size = 1 << shift, left = ((column + map->x) & -size) - map->x, x = left + size / 2;
    const int32_t z = glint_plane_at(&map->by.quotient.under, x, row),
                  u = glint_plane_at(&map->by.quotient.over[0], x, row),
                  v = glint_plane_at(&map->by.quotient.over[1], x, row),
                  limit = glint_shift_right(z, shift); /* of changes */
    if (limit < 16 || !is_divisible(u, z) || !is_divisible(v, z) ||
        glint_magnitude_bits(map->by.quotient.under.dx) >= (uint32_t)limit ||
        !is_divisible(map->by.quotient.over[0].dx, limit) || !is_divisible(map->by.quotient.over[1].dx, limit))
        return 0;
    const divisor d = begin_divisor(z);
    const int32_t g = 4 * divide_by(&d, map->by.quotient.under.dx), at_u = divide_by(&d, u), at_v = divide_by(&d, v),
                  slope_u = divide_by(&d, map->by.quotient.over[0].dx) - 4 * glint_product_high(at_u, g),
                  slope_v = divide_by(&d, map->by.quotient.over[1].dx) - 4 * glint_product_high(at_v, g);
    const uint32_t most = MOST_RUN_ERROR(map);
    uint32_t bend, error = find_run_error(map, slope_u, slope_v, g, shift, &bend);
    if (error > most) {
        do {
            error /= 8;
            shift--;
        } while (error > most && shift >= SHORT_SHIFT);
        return shift >= SHORT_SHIFT ? shift : 0;
    }
    const int32_t bent = error + bend > most ? g : 0;
    set_run(map, 0, at_u, slope_u, bent);
    set_run(map, 1, at_v, slope_v, bent);
    map->left = left;
    map->origin = x;
    map->right = left + size;
    return shift;
}

/* Finds the coordinates of one pixel. Those of pixels in the triangle can be divided, but for rounding. */
static GLINT_NOINLINE void find_pixel(glint_texture_map *map, int32_t row, int32_t column) {
    const int32_t z = glint_most(glint_plane_at(&map->by.quotient.under, column, row), 1);
    const divisor d = begin_divisor(z);
    for (int k = 0; k < 2; k++) {
        const int32_t over = glint_plane_at(&map->by.quotient.over[k], column, row),
                      at = is_divisible(over, z) ? divide_by(&d, over) : 0;
        map->run[k] = (glint_texture_run){map->by.quotient.first[k] + ((uint32_t)at << map->by.quotient.up[k]), 0, 0};
    }
    map->left = map->origin = column;
    map->right = column + 1;
}

/* Returns the next smaller size of runs to try, or 0, given what find_run has returned. */
static uint32_t next_shift(uint32_t shift, unsigned serves) {
    return serves ? serves : shift > SHORT_SHIFT ? SHORT_SHIFT : 0;
}

/* Finds the run of a pixel. What follows a part that does not serve is known for all of it, so that it does not depend
 * on which of its pixels are drawn. */
static inline void find_divided(glint_texture_map *map, int32_t row, int32_t column) {
    const int32_t part = glint_shift_right(column + map->x, map->by.quotient.longest);
    if (map->row != row || map->by.quotient.part != part) {
        const uint32_t longest = map->by.quotient.longest;
        map->by.quotient.part = part;
        map->by.quotient.shift = 0;
        if (longest) {
            const unsigned serves = find_run(map, row, column, longest);
            if (serves == longest)
                return;
            map->by.quotient.shift = (uint8_t)next_shift(longest, serves);
        }
    }
    for (uint32_t shift = map->by.quotient.shift; shift;) {
        const unsigned serves = find_run(map, row, column, shift);
        if (serves == shift)
            return;
        shift = next_shift(shift, serves);
    }
    find_pixel(map, row, column);
}

/* Sets the run of a row from quadratics. */
static inline void set_row(glint_texture_map *map, int32_t row) {
    const uint32_t y = (uint32_t)(row - map->by.quadratic.row);
    for (int k = 0; k < 2; k++) {
        const glint_quadratic *q = &map->by.quadratic.of[k];
        map->run[k] = (glint_texture_run){q->value + y * (q->y + y * q->yy), q->x + y * q->xy, q->xx};
    }
}

void glint_find_run(glint_texture_map *map, int32_t row, int32_t column) {
    if (map->is_quadratic)
        set_row(map, row);
    else
        find_divided(map, row, column);
    map->row = row;
}

void glint_find_coordinates(glint_texture_map *map, int32_t row, int32_t column) {
    if (map->is_quadratic) {
        const uint32_t x = (uint32_t)(column - map->origin), y = (uint32_t)(row - map->by.quadratic.row);
        map->at[0] = glint_begin_quadratic(&map->by.quadratic.of[0], x, y);
        map->at[1] = glint_begin_quadratic(&map->by.quadratic.of[1], x, y);
        map->bend[0] = 2 * map->by.quadratic.of[0].xx;
        map->bend[1] = 2 * map->by.quadratic.of[1].xx;
        return;
    }
    glint_check_run(map, row, column);
    const uint32_t x = (uint32_t)(column - map->origin);
    for (int k = 0; k < 2; k++) {
        const glint_texture_run *run = &map->run[k];
        map->at[k].value = run->value + x * (run->slope + x * run->curve);
        map->at[k].step = run->slope + (2 * x + 1) * run->curve;
        map->bend[k] = 2 * run->curve;
    }
}

/* ---- Triangles ---- */

/* Sets what numbers of texels are made of. */
static void set_texture_size(glint_texture_map *map, const glint_texture *texture) {
    const uint32_t across = 31 - glint_leading_zeros(texture->width), down = 31 - glint_leading_zeros(texture->height);
    map->texture = texture;
    map->across = across ? 32 - across : 31; /* of one column, coordinates are 0 */
    map->down = (32 - across - down) & 31;
    map->rows = (texture->height - 1u) << across;
}

/* Returns the size of runs around whose middle planes of 1/w and of coordinates fit 32 bits outside of the triangle. */
static inline int32_t find_longest(int32_t z, int32_t u, int32_t v) {
    const uint32_t most = glint_magnitude_bits(z) | glint_magnitude_bits(u) | glint_magnitude_bits(v);
    return glint_least((int32_t)glint_leading_zeros(most | 1) - 2, LONG_SHIFT);
}

/* Triangles of fewer columns have pixels, not runs, and such of fewer rows look for no better size of runs; sixteenths.
 */
#define LEAST_COLUMNS 64
#define LEAST_ROWS 128

/* Begins with quotients; `indices` are those of a triangle that is clipped, else null. */
static GLINT_NOINLINE void begin_quotients(const glint_row_walk *walk, const corner_coordinates *c,
                                           glint_texture_map *map, const uint16_t *indices, const uint8_t order[3]) {
    const glint_vertex *const *v = walk->triangle.corners;
    exact_planes planes;
    if (indices) {
        find_by_rays(walk, c, map, indices, &planes);
    } else {
        const glint_vertex *const corners[3] = {v[order[0]], v[order[1]], v[order[2]]};
        find_by_areas(walk, c, map, corners, &planes);
    }
    set_map_planes(walk, &planes, map);
    map->by.quotient.first[0] = (uint32_t)c->first[0];
    map->by.quotient.first[1] = (uint32_t)c->first[1];
    map->by.quotient.up[0] = (uint8_t)(map->by.quotient.up[0] + 2); /* quotients are Q28 */
    map->by.quotient.up[1] = (uint8_t)(map->by.quotient.up[1] + 2);
    map->right = 0;
    const int32_t longest =
        find_longest(map->by.quotient.under.dx, map->by.quotient.over[0].dx, map->by.quotient.over[1].dx);
    /* a run costs as much as two pixels and more */
    const uint32_t width = glint_magnitude_bits(v[1]->x - v[0]->x) | glint_magnitude_bits(v[2]->x - v[0]->x),
                   height = glint_magnitude_bits(v[1]->y - v[0]->y) | glint_magnitude_bits(v[2]->y - v[0]->y);
    map->by.quotient.longest = longest < SHORT_SHIFT || width < LEAST_COLUMNS ? 0 : (uint8_t)longest;
    if (map->by.quotient.longest && height >= LEAST_ROWS) {
        /* in the middle of the triangle: where other sizes serve, they are found */
        const int32_t column = glint_shift_right((v[0]->x + v[1]->x + v[2]->x) / 3, 4) - map->x,
                      row = glint_shift_right((v[0]->y + v[1]->y + v[2]->y) / 3 - walk->part->window.top, 4);
        map->by.quotient.longest =
            (uint8_t)next_shift((uint32_t)longest, find_run(map, row, column, (uint32_t)longest));
        map->right = 0;
    }
}

/* Chooses the level of a triangle that is not clipped. Areas are in 2^-8, of parallelograms: twice those of triangles.
 */
static GLINT_NOINLINE void choose_level(const glint_row_walk *walk, const corner_coordinates *c,
                                        glint_texture_map *map) {
    const glint_vertex *const *v = walk->triangle.corners;
    const int32_t x1 = v[1]->x - v[0]->x, y1 = v[1]->y - v[0]->y, x2 = v[2]->x - v[0]->x, y2 = v[2]->y - v[0]->y;
    const uint32_t pixels = glint_magnitude_bits(x1 * y2 - x2 * y1);
    const glint_texture *level = map->texture;
    int32_t to_u[2], to_v[2];
    map->beyond[0] = map->beyond[1] = 0;
    const uint32_t down = reduce_differences(map, c, 0, to_u) + reduce_differences(map, c, 1, to_v); /* up to 36 */
    const uint64_t repeats = glint_magnitude64(glint_product(to_u[0], to_v[1]) - glint_product(to_u[1], to_v[0]));
    while (level->smaller &&
           repeats >> (25 + glint_leading_zeros((uint32_t)level->width * level->height) - down) > pixels)
        level = level->smaller;
    set_texture_size(map, level);
}

/* Finds the coordinates of a triangle's corners. This is out of line: what it uses of the stack is free again then. */
static GLINT_NOINLINE void begin_coordinates(const glint_row_walk *walk, glint_texture_map *map, const uint8_t order[3],
                                             int is_clipped, corner_coordinates *c) {
    const glint_object *object = glint_object_at(walk->frame, walk->draw->object);
    const uint16_t *const indices = walk->draw->triangles[walk->triangle.index];
    const int is_turned = !is_clipped && walk->triangle.corners[1] != &walk->draw->vertices[indices[1]];
    uint16_t fetched[3], number[3];
    const uint16_t *const numbers = find_numbers(walk, object->mesh, fetched);
    for (int i = 0; i < 3; i++)
        number[i] = numbers[is_turned ? (3 - order[i]) % 3 : order[i]];
    find_coordinates_of(object->mesh, number, c);
    if (map->texture->smaller && !is_clipped)
        choose_level(walk, c, map);
    begin_edges(map, object->material, c);
}

void glint_begin_map(const glint_row_walk *walk, glint_texture_map *map) {
    const uint16_t *indices = walk->draw->triangles[walk->triangle.index];
    const int is_clipped = walk->triangle.corners[0] != &walk->draw->vertices[indices[0]];
    const uint8_t *order = glint_corner_order(!is_clipped && walk->has_slopes ? walk->corners.top : 0);
    corner_coordinates c;
    set_texture_size(map, walk->draw->texture);
    map->row = -1;
    map->x = glint_shift_right(walk->part->window.left, 4);
    begin_coordinates(walk, map, order, is_clipped, &c);
    map->is_quadratic = (uint8_t)(!is_clipped && set_texture_quadratics(walk, &c, map));
    if (!map->is_quadratic)
        begin_quotients(walk, &c, map, is_clipped ? indices : 0, order);
}
