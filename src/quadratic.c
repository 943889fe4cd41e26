/* SPDX-License-Identifier: MIT */
/*
 * Exact lighting of fragments under one directional light, by quadratics.
 *
 * With M = N/w, which is linear on the screen, N.L = M.L / |M|, and the deviation of N from the half vector
 * (deviation.c) is that of M, which is linear in M, over |M|. So three quadratics give a fragment's light: M.M exactly;
 * and the deviation, exactly for the infinite viewer, for the local one through nine points of a square of pixels, in
 * which the half vector bends little.
 */
#include "quadratic.h"

#include "division.h"
#include "setup.h"

/* N.L, Q15, that is above 0 at every pixel (LIT in deviation.c). */
#define LIT 300

/* N.L at which rounding cannot light what faces away (deviation.c). */
#define UNLIT (-16)

/* Sum of the squares of the normals' differences, with the ratio of 1/w: M.M stays above 0.3 of its largest. */
#define LEAST_SQUARE ((6u << 27) / 10 * 3)

/* Error of a highlight that its third order may make, in 1/64 of a level. */
#define BEND_LIMIT 10

/* ---- Frame ---- */

static uint32_t largest_level(const uint32_t weight[3]) {
    uint32_t largest = weight[0] > weight[2] ? weight[0] : weight[2];
    largest *= 31;
    return largest > weight[1] * 63 ? largest : weight[1] * 63;
}

/* Two rows that take N to its deviation from H: x - hx (H + z) / (1 + hz), and y alike. */
static void find_across(glint_quadratic_limits *limits, const int16_t h[3]) {
    const int32_t inverse = glint_inverse_of_one_and(h[2]);
    for (int row = 0; row < 2; row++) {
        const int32_t along = glint_shift_right(h[row] * inverse, 15);
        for (int c = 0; c < 3; c++) {
            const int32_t part = c == 2 ? h[row] : glint_shift_right(h[c] * along + 0x4000, 15);
            const int32_t value = (c == row ? GLINT_UNIT : 0) - part;
            limits->across[row][c] = (int16_t)glint_shift_right(value * limits->scale + 0x4000, 15);
        }
    }
}

/*
 * The slope of a highlight is at most 0.61 sqrt(p) weight; what is left of the third order in a square of side s, in
 * units of the focal length, is about 0.3 s^3 where L and V are less than 120 degrees apart.
 */
static void find_bend(glint_quadratic_limits *limits, const glint_deviation *deviation, const glint_shading *shading) {
    const uint32_t root = glint_square_root((uint64_t)(uint32_t)shading->material->shininess);         /* Q8 */
    const uint32_t weight = largest_level(shading->weights[0].specular) + 1;                           /* Q12 */
    const uint64_t bend = ((uint64_t)BEND_LIMIT << (30 + 20 - 6)) * 5 / 3 / ((uint64_t)weight * root); /* Q30 */
    limits->bend = bend < 1 << 28 ? (int32_t)bend : 1 << 28;
    limits->cell = 5;
    for (; limits->cell > 3; limits->cell--) {
        const uint64_t side = (uint64_t)(uint32_t)deviation->ray_scale << limits->cell >> 10; /* Q16 */
        if (side < 1 << 16 && side * side * side < bend * 3 << 18)
            break;
    }
    limits->change = glint_shift_right(deviation->ray_scale, 6) + 1;
}

void glint_quadratic_prepare(glint_deviation *deviation, const glint_shading *shading) {
    glint_quadratic_limits *limits = &deviation->quadratic;
    const uint32_t entries = deviation->specular_end >> 15, cut = deviation->sine_square_end;
    if (!cut)
        return;
    const uint64_t density = ((uint64_t)entries << 46) / cut; /* entries over sin^2 from 0 to 1, Q16 */
    const unsigned bits = glint_bits64(density - 1) - 16;
    limits->scale = (int32_t)glint_square_root(density << (30 - 16) >> bits);
    limits->scale = limits->scale < INT16_MAX ? limits->scale : INT16_MAX;
    if (bits > 24)
        return;
    limits->shift = 24 - bits;
    limits->limit = entries << (6 + limits->shift);
    limits->end = entries << 20;
    limits->cut = glint_shift_right((deviation->cut + 1) * limits->scale, 15) + 1;
    limits->cut_diagonal = glint_shift_right((deviation->cut_diagonal + 1) * limits->scale, 15) + 1;
    limits->behind = -(int32_t)(glint_square_root((uint64_t)((1u << 30) - cut)) / 2);
    if (deviation->local_viewer) {
        limits->behind = glint_shift_right(limits->behind * limits->scale, 15);
        find_bend(limits, deviation, shading);
    } else
        find_across(limits, deviation->half_vector);
}

/* ---- Triangle ---- */

static int32_t least(int32_t a, int32_t b, int32_t c) {
    const int32_t m = a < b ? a : b;
    return m < c ? m : c;
}

static int32_t most(int32_t a, int32_t b, int32_t c) {
    const int32_t m = a > b ? a : b;
    return m > c ? m : c;
}

static int32_t dot(const int32_t a[3], const int32_t b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* x 2^n modulo 2^32, n below 32. */
static uint32_t scale(int32_t x, int32_t n) {
    if (n >= 0)
        return (uint32_t)x << n;
    return n < -30 ? 0 : (uint32_t)glint_shift_right(x + glint_shift_left(1, (unsigned)(-n - 1)), (unsigned)-n);
}

/* Normals of the corners, those of the back when that is seen. */
static void find_normals(const glint_triangle *triangle, int32_t normal[3][3]) {
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 3; c++)
            normal[i][c] = triangle->back ? -triangle->corners[i]->attribute[c] : triangle->corners[i]->attribute[c];
}

/*
 * 1/w of the corners, the largest 32256: |M| then stays below 1 with all errors of its planes. Where the normals are
 * the same they need no weights.
 * @return 0 where M.M gets too small: by the turn of the normals, an edge's middle has it 1 - turn / 6
 */
static int find_weights(const glint_triangle *triangle, int32_t normal[3][3], int32_t weight[3]) {
    const glint_vertex *const *v = triangle->corners;
    int32_t squares = 0, differs = 0;
    for (int c = 0; c < 3; c++) {
        const int32_t sum = glint_shift_right(normal[0][c] + normal[1][c] + normal[2][c], 2);
        squares += sum * sum;
        differs |= (normal[0][c] ^ normal[1][c]) | (normal[0][c] ^ normal[2][c]);
    }
    const int32_t turn = 9 * (GLINT_UNIT / 4 * (GLINT_UNIT / 4)) - squares; /* Q26 */
    const unsigned up =
        glint_leading_zeros((uint32_t)v[0]->inverse_w | (uint32_t)v[1]->inverse_w | (uint32_t)v[2]->inverse_w | 1) - 1;
    const uint32_t w[3] = {(uint32_t)v[0]->inverse_w << up >> 15, (uint32_t)v[1]->inverse_w << up >> 15,
                           (uint32_t)v[2]->inverse_w << up >> 15};
    int32_t reciprocal = glint_reciprocal16((uint32_t)most((int32_t)w[0], (int32_t)w[1], (int32_t)w[2]));
    reciprocal -= reciprocal >> 6;
    for (int i = 0; i < 3; i++)
        weight[i] = differs ? (int32_t)(w[i] * (uint32_t)reciprocal >> 16) : 32256;
    const int32_t smallest = least(weight[0], weight[1], weight[2]), left = (6 << 12) - glint_shift_right(turn, 14);
    return left > 0 && (uint32_t)(smallest * smallest >> 15) * (uint32_t)left > LEAST_SQUARE;
}

/* Planes of M. @return 0 for slivers, and where it changes too much from pixel to pixel */
static int find_planes(const glint_triangle *triangle, const glint_gradients *g, int32_t normal[3][3],
                       const int32_t cosine[3], glint_quadratic_light *light, int32_t *size) {
    glint_plane *planes = light->normal;
    int32_t weight[3];
    uint32_t bits = 0;
    if (!find_weights(triangle, normal, weight) ||
        2 * g->size - 31 + (int32_t)glint_leading_zeros((uint32_t)triangle->area) > 6)
        return 0;
    for (int c = 0; c < 3; c++) {
        glint_plane_begin(&planes[c], g, normal[0][c] * weight[0], normal[1][c] * weight[1], normal[2][c] * weight[2]);
        bits |= glint_magnitude_bits(planes[c].dx) | glint_magnitude_bits(planes[c].dy);
    }
    glint_plane_begin(&light->cosine, g, cosine[0] * weight[0], cosine[1] * weight[1], cosine[2] * weight[2]);
    *size = 18 - (int32_t)glint_leading_zeros(bits);
    return *size <= 14;
}

/* What is quadratic or linear in M; the changes of M from pixel to pixel are `size` bits longer than 14 and a sign. */
static void find_products(const glint_deviation *deviation, glint_quadratic_light *light, int32_t size) {
    int32_t m[3], mx[3], my[3];
    for (int c = 0; c < 3; c++) {
        m[c] = glint_shift_right(light->normal[c].start + 0x4000, 15);
        mx[c] = (int32_t)scale(light->normal[c].dx, -size);
        my[c] = (int32_t)scale(light->normal[c].dy, -size);
    }
    const int32_t l[3] = {deviation->light[0], deviation->light[1], deviation->light[2]};
    light->cosine =
        (glint_plane){dot(l, m), (int32_t)scale(dot(l, mx), size - 15), (int32_t)scale(dot(l, my), size - 15)};
    glint_quadratic *s = &light->square;
    s->start = ((uint32_t)(m[0] * m[0]) + (uint32_t)(m[1] * m[1]) + (uint32_t)(m[2] * m[2]) - (1 << 28)) << 2;
    s->dxx = scale(dot(mx, mx), 2 * size - 27);
    s->dxy = scale(dot(mx, my), 2 * size - 27);
    s->dyy = scale(dot(my, my), 2 * size - 27);
    s->dx = scale(dot(m, mx), size - 12) + s->dxx / 2;
    s->dy = scale(dot(m, my), size - 12) + s->dyy / 2;
    if (deviation->local_viewer || !deviation->quadratic.limit)
        return;
    for (int row = 0; row < 2; row++) {
        const int16_t *across = deviation->quadratic.across[row];
        const int32_t t[3] = {across[0], across[1], across[2]};
        glint_quadratic *e = row ? &light->y : &light->x;
        *e =
            (glint_quadratic){(uint32_t)dot(t, m), scale(dot(t, mx), size - 15), scale(dot(t, my), size - 15), 0, 0, 0};
    }
}

/* Can none of three deviations and what lies between them be in the highlight? Q14, scaled. */
static int is_outside(const glint_quadratic_limits *limits, int32_t e[3][2], int32_t margin) {
    const int32_t cut = limits->cut + margin, diagonal = limits->cut_diagonal + margin;
    const int32_t x0 = e[0][0], x1 = e[1][0], x2 = e[2][0], y0 = e[0][1], y1 = e[1][1], y2 = e[2][1];
    return least(x0, x1, x2) >= cut || most(x0, x1, x2) <= -cut || least(y0, y1, y2) >= cut ||
           most(y0, y1, y2) <= -cut || least(x0 + y0, x1 + y1, x2 + y2) >= diagonal ||
           most(x0 + y0, x1 + y1, x2 + y2) <= -diagonal || least(x0 - y0, x1 - y1, x2 - y2) >= diagonal ||
           most(x0 - y0, x1 - y1, x2 - y2) <= -diagonal;
}

/* Does the highlight of the infinite viewer show? */
static glint_quadratic_kind find_infinite(const glint_deviation *deviation, int32_t normal[3][3]) {
    const glint_quadratic_limits *limits = &deviation->quadratic;
    const int32_t h[3] = {deviation->half_vector[0], deviation->half_vector[1], deviation->half_vector[2]};
    int32_t e[3][2], behind = 0;
    for (int i = 0; i < 3; i++) {
        for (int row = 0; row < 2; row++) {
            const int32_t t[3] = {limits->across[row][0], limits->across[row][1], limits->across[row][2]};
            e[i][row] = glint_shift_right(dot(t, normal[i]), 16);
        }
        behind |= dot(h, normal[i]) < limits->behind * (1 << 15);
    }
    if (is_outside(limits, e, 8))
        return GLINT_QUADRATIC_DIFFUSE;
    return behind ? GLINT_QUADRATIC_UNFIT : GLINT_QUADRATIC_SPECULAR;
}

glint_quadratic_kind glint_quadratic_begin(const glint_draw *draw, const glint_triangle *triangle,
                                           const glint_part *part, glint_quadratic_light *light) {
    const glint_deviation *deviation = draw->shading->deviation;
    const int32_t l[3] = {deviation->light[0], deviation->light[1], deviation->light[2]};
    glint_quadratic_kind kind = GLINT_QUADRATIC_DIFFUSE;
    int32_t normal[3][3], size;
    find_normals(triangle, normal);
    const int32_t cosine[3] = {glint_shift_right(dot(l, normal[0]) + 0x4000, 15),
                               glint_shift_right(dot(l, normal[1]) + 0x4000, 15),
                               glint_shift_right(dot(l, normal[2]) + 0x4000, 15)};
    if (most(cosine[0], cosine[1], cosine[2]) <= UNLIT)
        return GLINT_QUADRATIC_AMBIENT;
    light->gated = least(cosine[0], cosine[1], cosine[2]) < LIT;
    if (deviation->specular_end) {
        kind = deviation->local_viewer ? GLINT_QUADRATIC_SPECULAR : find_infinite(deviation, normal);
        if (!deviation->quadratic.limit)
            return GLINT_QUADRATIC_UNFIT;
    }
    if (kind == GLINT_QUADRATIC_UNFIT || !find_planes(triangle, &part->gradients, normal, cosine, light, &size))
        return GLINT_QUADRATIC_UNFIT;
    find_products(deviation, light, size);
    return kind;
}

/* ---- Square ---- */

/* A half vector, and 1 / (1 + hz). */
typedef struct half_vector {
    int32_t h[3], inverse;
} half_vector;

/* At a point of the screen, 28.4. @return 0 where there is none */
static int find_half_vector(const glint_deviation *deviation, int32_t x, int32_t y, half_vector *at) {
    int16_t h[3];
    if (!glint_deviation_half_vector(deviation, x, y, h))
        return 0;
    *at = (half_vector){{h[0], h[1], h[2]}, glint_inverse_of_one_and(h[2])};
    return 1;
}

/* Deviation of m, Q14, below 1.8 long; Q29. */
static void deviate(const half_vector *at, const int32_t m[3], int32_t e[2]) {
    int32_t along = dot(at->h, m); /* UNIT is short of 2^15 by a part in 2^13: so are products of h */
    along = glint_shift_right(along + glint_shift_right(along, 13) + 0x4000, 15) + m[2];
    along = glint_shift_right(along * at->inverse, 15);
    along += glint_shift_right(along + 0x1000, 13);
    e[0] = m[0] * (1 << 15) - at->h[0] * along;
    e[1] = m[1] * (1 << 15) - at->h[1] * along;
}

int glint_quadratic_square(const glint_triangle *triangle, glint_square *square) {
    const glint_vertex *const *v = triangle->corners;
    const int32_t left = least(v[0]->x, v[1]->x, v[2]->x), right = most(v[0]->x, v[1]->x, v[2]->x);
    const int32_t top = least(v[0]->y, v[1]->y, v[2]->y), bottom = most(v[0]->y, v[1]->y, v[2]->y);
    const int32_t extent = right - left > bottom - top ? right - left : bottom - top;
    square->x = glint_shift_right(left + right, 5);
    square->y = glint_shift_right(top + bottom, 5);
    square->size = 2;
    while (extent >> (square->size + 4))
        square->size++;
    return square->size <= 5;
}

/* The highlight of the local viewer near a triangle in a square: does it show, by its corners and H in the middle? */
static glint_quadratic_kind find_local(const glint_quadratic_limits *limits, const glint_triangle *triangle,
                                       const half_vector *middle, uint32_t size) {
    const int32_t margin = (3 * limits->change << size >> 8) + 32; /* 3/4 of the side, and the third order */
    int32_t e[3][2], behind = 0;
    for (int i = 0; i < 3; i++) {
        int32_t m[3], found[2];
        for (int c = 0; c < 3; c++) {
            m[c] = glint_shift_right(triangle->corners[i]->attribute[c] * limits->scale, 16);
            m[c] = triangle->back ? -m[c] : m[c];
        }
        deviate(middle, m, found);
        e[i][0] = glint_shift_right(found[0], 15);
        e[i][1] = glint_shift_right(found[1], 15);
        behind |= glint_shift_right(dot(middle->h, m), 14) - margin * 2 < limits->behind;
    }
    if (is_outside(limits, e, margin))
        return GLINT_QUADRATIC_DIFFUSE;
    return behind ? GLINT_QUADRATIC_UNFIT : GLINT_QUADRATIC_SPECULAR;
}

/* M at the middle of a square, and its change over half a side; Q30, scaled. @return 0 where it gets too long */
static int find_middle(const glint_quadratic_light *light, int32_t x, int32_t y, uint32_t size, int32_t factor,
                       int32_t middle[3][3]) {
    uint32_t bits = 0, change = 0;
    for (int c = 0; c < 3; c++) {
        const glint_plane *plane = &light->normal[c];
        const int32_t at = glint_plane_at(plane, x, y);
        bits |= glint_magnitude_bits(at);
        change |= glint_magnitude_bits(plane->dx) | glint_magnitude_bits(plane->dy);
        middle[0][c] = glint_shift_right(at, 15) * factor;
        middle[1][c] = glint_shift_right((int32_t)((uint32_t)plane->dx << (size - 1)), 15) * factor;
        middle[2][c] = glint_shift_right((int32_t)((uint32_t)plane->dy << (size - 1)), 15) * factor;
    }
    return !(bits >> 30) && !(change >> (29 - (size - 1)));
}

/* The polynomial of a square, from its coefficients over half sides, Q30, seen from the triangle's anchor. */
static void find_quadratic(glint_quadratic *q, const int32_t k[6], int32_t x, int32_t y, uint32_t size) {
    const unsigned half = size - 1;
    q->dxx = scale(k[3], 1 - 2 * (int32_t)half);
    q->dxy = scale(k[4], -2 * (int32_t)half);
    q->dyy = scale(k[5], 1 - 2 * (int32_t)half);
    q->dx = scale(k[1], -(int32_t)half) + (uint32_t)glint_shift_right((int32_t)q->dxx, 1);
    q->dy = scale(k[2], -(int32_t)half) + (uint32_t)glint_shift_right((int32_t)q->dyy, 1);
    const uint32_t left = 0u - (uint32_t)x, up = 0u - (uint32_t)y;
    q->start = (uint32_t)k[0] + q->dx * left + q->dy * up + q->dxy * left * up + q->dxx * (uint32_t)(x * (x + 1) / 2) +
               q->dyy * (uint32_t)(y * (y + 1) / 2);
    q->dx += q->dxx * left + q->dxy * up;
    q->dy += q->dyy * up + q->dxy * left;
}

static int32_t magnitude(int32_t x) {
    return x < 0 ? -x : x;
}

/* Deviations at the middle of a square, right, left, below, above, at its lower right and its upper left corner. */
typedef int32_t points[7][2];

static int find_points(const glint_deviation *deviation, const glint_square *square, int32_t middle[3][3],
                       const half_vector *at_middle, points e) {
    static const int8_t way[7][2] = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}};
    for (int i = 0; i < 7; i++) {
        half_vector at = *at_middle;
        int32_t m[3];
        if (i && !find_half_vector(deviation, 16 * (square->x + way[i][0] * (1 << (square->size - 1))) + 8,
                                   16 * (square->y + way[i][1] * (1 << (square->size - 1))) + 8, &at))
            return 0;
        for (int c = 0; c < 3; c++)
            m[c] = glint_shift_right(middle[0][c] + way[i][0] * middle[1][c] + way[i][1] * middle[2][c] + 0x8000, 16);
        deviate(&at, m, e[i]);
    }
    return 1;
}

glint_quadratic_kind glint_quadratic_bend(const glint_deviation *deviation, const glint_triangle *triangle,
                                          const glint_part *part, const glint_square *square,
                                          glint_quadratic_light *light) {
    const glint_quadratic_limits *limits = &deviation->quadratic;
    const int32_t x = square->x - glint_shift_right(part->window.left, 4) + part->x;
    const int32_t y = square->y - glint_shift_right(part->window.top, 4) + part->y;
    half_vector at;
    points e;
    int32_t middle[3][3], third = 0, far = 0;
    if (!find_half_vector(deviation, 16 * square->x + 8, 16 * square->y + 8, &at))
        return GLINT_QUADRATIC_UNFIT;
    const glint_quadratic_kind kind = find_local(limits, triangle, &at, square->size);
    if (kind != GLINT_QUADRATIC_SPECULAR)
        return kind;
    if (!find_middle(light, x, y, square->size, limits->scale, middle) ||
        !find_points(deviation, square, middle, &at, e))
        return GLINT_QUADRATIC_UNFIT;
    for (int row = 0; row < 2; row++) {
        int32_t k[6];
        k[0] = 2 * e[0][row];
        k[1] = e[1][row] - e[2][row];
        k[2] = e[3][row] - e[4][row];
        k[3] = e[1][row] + e[2][row] - k[0];
        k[5] = e[3][row] + e[4][row] - k[0];
        k[4] = e[5][row] + e[6][row] - k[0] - k[3] - k[5];
        third += magnitude(e[5][row] - e[6][row] - k[1] - k[2]);
        far |=
            magnitude(k[0]) - magnitude(k[1]) - magnitude(k[2]) - magnitude(k[3]) - magnitude(k[4]) - magnitude(k[5]) >
            limits->cut * (1 << 16);
        find_quadratic(row ? &light->y : &light->x, k, x, y, square->size);
    }
    if (third > limits->bend)
        return GLINT_QUADRATIC_UNFIT;
    return far ? GLINT_QUADRATIC_DIFFUSE : GLINT_QUADRATIC_SPECULAR;
}
