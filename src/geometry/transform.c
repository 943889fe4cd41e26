/* SPDX-License-Identifier: MIT */
/* Transform: an object's pose under the camera, with ranges checked once so that no vertex can overflow. */
#include "geometry.h"

#define RANGE ((int64_t)1 << 45) /* Q28: 2^17 units */

/* Coordinates are rounded to a step or two: this keeps w above 0. */
#define SMALLEST_W 16

int64_t glint_shift_round64(int64_t x, int shift) {
    return shift > 0 ? glint_round_shift64(x, (unsigned)shift) : x * ((int64_t)1 << -shift);
}

/* The same where the result has 30 bits: half of it is added in 32, but in a library built for size. */
static inline int32_t shift_round_to_30(int64_t x, int shift) {
    if (GLINT_SMALL)
        return (int32_t)glint_shift_round64(x, shift);
    if (shift <= 0)
        return (int32_t)x * (1 << -shift);
    const int32_t twice = (int32_t)glint_shift_right64(x, (unsigned)shift - 1);
    return glint_shift_right(twice, 1) + (twice & 1);
}

/* Exact in 64 bits: pose times mesh extent, and the mesh's origin relative to the eye as a fourth column; Q28. */
static int place_in_world(const glint_view *view, const glint_object *object, int64_t world[3][4]) {
    const glint_mesh *mesh = object->mesh;
    const int32_t extent[3] = {mesh->extent.x, mesh->extent.y, mesh->extent.z};
    const int32_t offset[3] = {mesh->offset.x, mesh->offset.y, mesh->offset.z};
    uint64_t bits = 0;
    for (int i = 0; i < 3; i++) {
        world[i][3] = ((int64_t)object->pose.m[i][3] - view->eye[i]) * (1 << 12);
        for (int j = 0; j < 3; j++) {
            world[i][j] = glint_shift_round64(glint_product(object->pose.m[i][j], extent[j]), 4);
            if (GLINT_SMALL || offset[j])
                world[i][3] += glint_shift_round64(glint_product(object->pose.m[i][j], offset[j]), 4);
            bits |= glint_magnitude64(world[i][j]);
        }
        bits |= glint_magnitude64(world[i][3]);
    }
    return bits < (uint64_t)RANGE;
}

/* Three rows of so many, the largest number brought to 30 bits. @return n: they were 2^n times as large. */
static int rows_to_30_bits(int64_t x[3][4], int columns, int32_t out[3][4]) {
    uint64_t bits = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < columns; j++)
            bits |= glint_magnitude64(x[i][j]);
    int shift = (int)glint_bits64(bits) - 30;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < columns; j++)
            out[i][j] = shift_round_to_30(x[i][j], shift);
    return shift;
}

/* The camera's rotation of so many columns below 2^30, times 2^4. */
static void rotate(const glint_view *view, int32_t in[3][4], int columns, int64_t out[3][4]) {
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < columns; j++) {
            int64_t sum = 0;
            for (int k = 0; k < 3; k++)
                sum += glint_product(view->rotation[i][k], in[k][j]);
            out[i][j] = glint_shift_round64(sum, 12);
        }
    }
}

/*
 * Sets rows below 2^43, none of whose magnitudes sum up to more than `largest`, so that these sums are at most 2.67
 * 2^28, a third of 2^31. @return n: they were 2^n times that.
 */
static int set_rows(glint_transform *transform, int64_t rows[3][4], uint64_t largest) {
    int shift = (int)glint_bits64(largest + largest / 2) - 30;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            glint_row_set(&transform->matrix[i], j, shift_round_to_30(rows[i][j], shift));
        transform->translation[i] = shift_round_to_30(rows[i][3], shift);
    }
    return shift;
}

/* Clip rows x, y, w from rows below 2^38; `largest` is to fit as well. @return n: they were 2^n times that. */
static int bring_to_clip_space(glint_transform *transform, const glint_view *view, uint64_t largest,
                               int64_t rows[3][4]) {
    for (int i = 0; i < 3; i++) {
        uint64_t sum = 0; /* the largest magnitude that the bounding box takes */
        for (int j = 0; j < 4; j++) {
            if (i < 2)
                rows[i][j] = glint_shift_round64(rows[i][j] * view->focal_mantissa, (int)view->focal_shift);
            if (i > 0) /* screen y runs down, and z towards the eye */
                rows[i][j] = -rows[i][j];
            sum += glint_magnitude64(rows[i][j]);
        }
        largest = sum > largest ? sum : largest;
    }
    return set_rows(transform, rows, largest);
}

/*
 * Smallest value of a x + b w over the box, of which this is row x and row w of the matrix, the translation last;
 * modulo 2^32, and it fits.
 */
static int32_t smallest(const int32_t x[4], const int32_t w[4], int32_t a, int32_t b) {
    int32_t value = glint_add_wrap(glint_multiply_wrap(a, x[3]), glint_multiply_wrap(b, w[3]));
    for (int j = 0; j < 3; j++) {
        const int32_t change = glint_add_wrap(glint_multiply_wrap(a, x[j]), glint_multiply_wrap(b, w[j]));
        value = glint_add_wrap(value, change < 0 ? change : -change);
    }
    return value;
}

/* Bits that the matrix is cut by: row sums are below 2.67 2^17 times 2046 + 1025. */
#define BOX_CUT 11

/* Is any of the box on the screen, and does any of it pass the near plane or the guard band? To within what cutting
 * takes at most, a step of each of four columns of both rows. */
static void classify(glint_transform *transform, const glint_config *config, int is_parallel) {
    const int32_t half[2] = {config->width, config->height}; /* in half pixels */
    int32_t cut[3][4], extent = 0;
    for (int i = 0; i < 3; i++) {
        extent = 0;
        for (int j = 0; j < 3; j++) {
            const int32_t entry = glint_row_get(&transform->matrix[i], j);
            extent = glint_add_wrap(extent, entry < 0 ? -entry : entry);
            cut[i][j] = glint_shift_right(entry, BOX_CUT);
        }
        cut[i][3] = glint_shift_right(transform->translation[i], BOX_CUT);
    }
    transform->least_w = transform->translation[2] - extent;
    transform->visible = transform->translation[2] + extent >= transform->near_plane;
    transform->clips = transform->least_w < transform->near_plane;
    if (is_parallel) {
        transform->clips |= GLINT_PARALLEL;
        transform->nearest = glint_most(transform->nearest, 1);
        cut[2][0] = cut[2][1] = cut[2][2] = 0;
        cut[2][3] = glint_shift_right(transform->nearest, BOX_CUT);
    }
    for (int row = 0; row < 2; row++) {
        const int32_t band = 2 * GLINT_GUARD_BAND, side = half[row] + 1;
        for (int32_t sign = -1; sign <= 1; sign += 2) {
            if (smallest(cut[row], cut[2], sign, 1) < 8)
                transform->clips |= 1;
            if (smallest(cut[row], cut[2], -sign * band, -side) > 4 * (band + side))
                transform->visible = 0;
        }
    }
}

/*
 * The matrix of normals so scaled that a turn keeps lengths: with rows of about 2^13 UNIT if all three are as long.
 * The squares of all entries then sum up to at most 3 2^56, so that a transformed normal is below 3 2^28.
 */
static void scale_normals(glint_transform *transform, int32_t matrix[3][4]) {
    uint64_t sum = 0; /* below 9 2^60 */
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const int64_t entry = matrix[i][j];
            sum += (uint64_t)(entry * entry);
        }
    }
    uint32_t square = (uint32_t)(sum >> 32) / 3 * 4; /* less than 2^28 only when rows differ */
    int32_t factor = glint_inverse_root(square < 1u << 28 ? 1u << 28 : square);
    factor -= factor >> 13; /* lengths end up just below UNIT: no component passes int16 */
    factor = transform->mirrored ? -factor : factor;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            glint_row_set(&transform->normal[i], j,
                          (int32_t)glint_shift_round64(glint_product(matrix[i][j], factor), 17));
}

/* Cofactors of the first three columns, brought to 30 bits by way of `wide`. @return the determinant on their scale */
static GLINT_INLINE int64_t find_cofactors(int32_t p[3][4], int64_t wide[3][4], int32_t cofactor[3][4]) {
    static const uint8_t next[3] = {1, 2, 0};
    int64_t determinant = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t *a = p[next[i]], *b = p[next[next[i]]];
        for (int j = 0; j < 3; j++) {
            int k = next[j], l = next[k];
            wide[i][j] = glint_product(a[k], b[l]) - glint_product(a[l], b[k]);
        }
    }
    rows_to_30_bits(wide, 3, cofactor);
    for (int j = 0; j < 3; j++)
        determinant += glint_product(p[0][j], cofactor[0][j]);
    return determinant;
}

/* The inverse transpose up to its scale: cofactors, with the determinant's sign. @return 0 when it is singular. */
static int prepare_normals(glint_transform *transform, const glint_view *view, const glint_pose *pose) {
    int64_t wide[3][4];
    int32_t p[3][4], cofactor[3][4];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            wide[i][j] = pose->m[i][j];
    rows_to_30_bits(wide, 3, p);
    const int64_t determinant = find_cofactors(p, wide, cofactor);
    if (glint_magnitude64(determinant) < (uint64_t)1 << 36) /* 2^-24 of what orthogonal axes give */
        return 0;
    transform->mirrored = determinant < 0;
    rotate(view, cofactor, 3, wide);
    rows_to_30_bits(wide, 3, cofactor);
    scale_normals(transform, cofactor);
    return 1;
}

/* A w, Q28, in units of 2^shift; 2^30, which is farther than any coordinate, where it is more. */
static int32_t to_units(int64_t w, int shift) {
    return (int)glint_bits64((uint64_t)w) - shift > 30 ? 1 << 30 : (int32_t)glint_shift_round64(w, shift);
}

/* The near plane and the frame's nearest w in the object's units. */
static void prepare_depth(glint_transform *transform, const glint_view *view, int exponent) {
    int32_t near_plane = to_units(view->near_plane, 28 - exponent);
    transform->near_plane = near_plane < SMALLEST_W ? SMALLEST_W : near_plane;
    transform->nearest = to_units(view->nearest, 28 - exponent);
}

/* Rounded to the object's units, the frame's nearest w must not pass any that is seen. */
static void lower_nearest(glint_transform *transform) {
    const int32_t least = transform->least_w > transform->near_plane ? transform->least_w : transform->near_plane;
    if (transform->nearest > least && !(transform->clips & GLINT_PARALLEL))
        transform->nearest = least;
}

int64_t glint_transform_nearest(const glint_transform *transform, const glint_view *view) {
    int32_t w = transform->least_w;
    if (w <= transform->near_plane)
        return view->near_plane;
    int64_t nearest = glint_shift_round64(w, transform->exponent - 28);
    return nearest > view->near_plane ? nearest : view->near_plane;
}

void glint_transform_place(glint_transform *transform, const glint_view *view) {
    if (transform->clips & GLINT_PARALLEL) /* then it does not depend on what else is seen */
        return;
    prepare_depth(transform, view, transform->exponent);
    lower_nearest(transform);
}

/* x 2^shift, at most 2^61, of an x above 0. */
static uint64_t in_rows(int64_t x, int shift) {
    if ((int)glint_bits64((uint64_t)x) + shift > 61)
        return (uint64_t)1 << 61;
    return shift < 0 ? (uint64_t)glint_shift_right64(x, (unsigned)-shift) : (uint64_t)x << shift;
}

/* What is hidden is all 0. Out of line: in line, gcc 12 keeps a 0 in a register of the FPU. */
static GLINT_NOINLINE glint_status prepare_object(glint_transform *transform, const glint_view *view,
                                                  const glint_config *config, const glint_object *object) {
    int64_t wide[3][4];
    int32_t world[3][4];
    if (object->hidden) {
        *transform = (glint_transform){0};
        return GLINT_OK;
    }
    if (!prepare_normals(transform, view, &object->pose))
        return GLINT_ERROR_POSE;
    if (!place_in_world(view, object, wide))
        return GLINT_ERROR_RANGE;
    int up = rows_to_30_bits(wide, 4, world);
    rotate(view, world, 4, wide);
    const uint64_t parallel = view->is_parallel ? in_rows(view->nearest, 4 - up) : 0;
    transform->exponent = 28 + 4 - up - bring_to_clip_space(transform, view, parallel, wide);
    transform->center_x = config->width * (8 << 11) + (1 << 10);
    transform->center_y = config->height * (8 << 11) + (1 << 10);
    prepare_depth(transform, view, transform->exponent);
    classify(transform, config, view->is_parallel);
    lower_nearest(transform);
    return GLINT_OK;
}

glint_status glint_transform_prepare(glint_transform *transform, const glint_view *view, const glint_config *config,
                                     const glint_object *object) {
    const int is_empty = config->skips_degenerate && !object->hidden && glint_mesh_is_empty(object->mesh);
    const glint_status status = is_empty ? GLINT_ERROR_POSE : prepare_object(transform, view, config, object);
    transform->skipped = 0;
    if (status != GLINT_ERROR_POSE || !config->skips_degenerate)
        return status;
    *transform = (glint_transform){.skipped = 1};
    return GLINT_OK;
}

/* ---- The eye ---- */

/* Numbers of so many bits, once the largest is brought to 20, are off by at most 1 from how cofactors are rounded. */
#define LEAST_BITS 51

/* |(x, y, z)| of 20 bits, or up to 2^-9 of it and 128 more: from the product with its unit vector. */
static int32_t find_length(int32_t x, int32_t y, int32_t z) {
    int16_t unit[3];
    glint_unit(x, y, z, unit);
    const int32_t length =
        glint_shift_right(x, 6) * unit[0] + glint_shift_right(y, 6) * unit[1] + glint_shift_right(z, 6) * unit[2];
    return glint_shift_right(length, 9) + glint_shift_right(length, 19) + 128;
}

/* Brings a place and its weight to as many bits as there are in an eye; where rounding leaves too few of it, to one
 * that no triangle faces away from. */
static void set_eye(const int64_t place[3], int64_t weight, glint_eye *to) {
    uint64_t bits = glint_magnitude64(weight);
    for (int i = 0; i < 3; i++)
        bits |= glint_magnitude64(place[i]);
    const unsigned size = glint_bits64(bits);
    *to = (glint_eye){0};
    if (size < LEAST_BITS)
        return;
    to->x = (int32_t)glint_shift_right64(place[0], size - 20);
    to->y = (int32_t)glint_shift_right64(place[1], size - 20);
    to->z = (int32_t)glint_shift_right64(place[2], size - 20);
    to->distance = find_length(to->x, to->y, to->z);
    to->weight = weight > 0 ? (int32_t)(weight >> (size - 13)) : 0; /* rounding alone takes it below */
}

/*
 * With the matrix of steps A and the translation t, the eye is where A e + 2^15 t = 0: at e = 2^15 E / W, where
 * E = -C^T t and W = det A, C its cofactors. A mirrored object's W is below 0. Parallel rays come from infinitely far
 * along -w: t is (0, 0, 1), and W is 0.
 */
void glint_transform_eye(const glint_transform *transform, glint_eye *eye) {
    int32_t rows[3][4], cofactor[3][4];
    int64_t wide[3][4], place[3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            rows[i][j] = glint_row_get(&transform->matrix[i], j);
    const int64_t weight = find_cofactors(rows, wide, cofactor);
    const int32_t sign = transform->mirrored ? 1 : -1;
    const int is_parallel = transform->clips & GLINT_PARALLEL;
    const int32_t x = is_parallel ? 0 : sign * transform->translation[0],
                  y = is_parallel ? 0 : sign * transform->translation[1],
                  w = sign * (is_parallel ? 1 << 29 : transform->translation[2]);
    for (int j = 0; j < 3; j++)
        place[j] =
            glint_product(cofactor[0][j], x) + glint_product(cofactor[1][j], y) + glint_product(cofactor[2][j], w);
    set_eye(place, is_parallel ? 0 : -sign * weight, eye);
}
