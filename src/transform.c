/* SPDX-License-Identifier: MIT */
/* Transform: an object's pose under the camera, with ranges checked once so that no vertex can overflow. */
#include "frame.h"

#define RANGE ((int64_t)1 << 45) /* Q28: 2^17 units */

/* Coordinates are rounded to a step or two: this keeps w above 0. */
#define SMALLEST_W 16

/* Exact in 64 bits: pose times mesh extent, and the mesh's origin relative to the eye as a fourth column; Q28. */
static int place_in_world(const glint_view *view, const glint_object *object, int64_t world[3][4]) {
    const glint_mesh *mesh = object->mesh;
    const int32_t extent[3] = {mesh->extent.x, mesh->extent.y, mesh->extent.z};
    const int32_t offset[3] = {mesh->offset.x, mesh->offset.y, mesh->offset.z};
    uint64_t bits = 0;
    for (int i = 0; i < 3; i++) {
        world[i][3] = ((int64_t)object->pose.m[i][3] - view->eye[i]) * (1 << 12);
        for (int j = 0; j < 3; j++) {
            world[i][j] = glint_round_shift64((int64_t)object->pose.m[i][j] * extent[j], 4);
            world[i][3] += glint_round_shift64((int64_t)object->pose.m[i][j] * offset[j], 4);
            bits |= glint_magnitude64(world[i][j]);
        }
        bits |= glint_magnitude64(world[i][3]);
    }
    return bits < (uint64_t)RANGE;
}

/* The camera's rotation of columns below 2^46. */
static void rotate(const glint_view *view, int64_t in[3][4], int64_t out[3][4]) {
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            int64_t sum = 0;
            for (int k = 0; k < 3; k++)
                sum += view->rotation[i][k] * in[k][j];
            out[i][j] = glint_round_shift64(sum, 16);
        }
    }
}

/* Largest magnitude that any coordinate of the bounding box takes. */
static uint64_t largest_coordinate(int64_t rows[3][4]) {
    uint64_t largest = 0;
    for (int i = 0; i < 3; i++) {
        uint64_t sum = 0;
        for (int j = 0; j < 4; j++)
            sum += glint_magnitude64(rows[i][j]);
        largest = sum > largest ? sum : largest;
    }
    return largest;
}

static int64_t scale(int64_t x, int shift) {
    return shift > 0 ? glint_round_shift64(x, (unsigned)shift) : x * ((int64_t)1 << -shift);
}

/* Scales three rows of four alike, the largest number to 30 bits. */
static void to_30_bits(int64_t x[3][4]) {
    uint64_t bits = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            bits |= glint_magnitude64(x[i][j]);
    int shift = (int)glint_bits64(bits) - 30;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            x[i][j] = scale(x[i][j], shift);
}

/* Clip rows x, y, w in 30 bits; @return the exponent: a unit is 2^-exponent. */
static int to_clip_space(glint_transform *transform, const glint_view *view, int64_t rows[3][4]) {
    int spare = (int)glint_bits64(largest_coordinate(rows)) - 38;
    int before = spare > 0 ? spare : 0;
    for (int j = 0; j < 4; j++) {
        for (int i = 0; i < 2; i++)
            rows[i][j] = glint_round_shift64(scale(rows[i][j], before) * view->focal_mantissa, view->focal_shift);
        rows[1][j] = -rows[1][j]; /* screen y runs down */
        rows[2][j] = -scale(rows[2][j], before);
    }
    int after = (int)glint_bits64(largest_coordinate(rows)) + 1 - 30;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            transform->matrix[i][j] = (int32_t)scale(rows[i][j], after);
        transform->translation[i] = (int32_t)scale(rows[i][3], after);
    }
    return 28 - before - after;
}

/* Smallest value of a x + b w over the box, where x is clip row 0 or 1; |a|, |b| below 2^12. */
static int64_t smallest(const glint_transform *transform, int row, int32_t a, int32_t b) {
    int64_t value = (int64_t)transform->translation[row] * a + (int64_t)transform->translation[2] * b;
    for (int j = 0; j < 3; j++)
        value -=
            (int64_t)glint_magnitude64((int64_t)transform->matrix[row][j] * a + (int64_t)transform->matrix[2][j] * b);
    return value;
}

static int64_t largest(const glint_transform *transform, int row, int32_t a, int32_t b) {
    return -smallest(transform, row, -a, -b);
}

/* Is any of the box on the screen, and does any of it pass the near plane or the guard band? */
static void classify(glint_transform *transform, const glint_config *config) {
    const int32_t half[2] = {config->width, config->height}; /* in half pixels */
    transform->visible = largest(transform, 2, 0, 1) >= transform->near_plane;
    transform->clips = smallest(transform, 2, 0, 1) < transform->near_plane;
    for (int row = 0; row < 2; row++) {
        for (int32_t sign = -1; sign <= 1; sign += 2) {
            if (smallest(transform, row, sign, 1) <= 0)
                transform->clips = 1;
            if (largest(transform, row, 2 * GLINT_GUARD_BAND * sign, half[row] + 1) < 0)
                transform->visible = 0;
        }
    }
}

/* The inverse transpose up to its scale: cofactors, with the determinant's sign. @return 0 when it is singular. */
static int prepare_normals(glint_transform *transform, const glint_view *view, const glint_pose *pose) {
    static const uint8_t next[3] = {1, 2, 0};
    int64_t p[3][4], cofactor[3][4], rotated[3][4];
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            p[i][j] = pose->m[i][j];
        p[i][3] = cofactor[i][3] = 0;
    }
    to_30_bits(p);
    for (int i = 0; i < 3; i++) {
        const int64_t *a = p[next[i]], *b = p[next[next[i]]];
        for (int j = 0; j < 3; j++) {
            int k = next[j], l = next[k];
            cofactor[i][j] = a[k] * b[l] - a[l] * b[k];
        }
    }
    to_30_bits(cofactor);
    int64_t determinant = 0;
    for (int j = 0; j < 3; j++)
        determinant += p[0][j] * cofactor[0][j];
    if (glint_magnitude64(determinant) < (uint64_t)1 << 36) /* 2^-24 of what orthogonal axes give */
        return 0;
    transform->mirrored = determinant < 0;
    rotate(view, cofactor, rotated);
    to_30_bits(rotated);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            transform->normal[i][j] = (int32_t)(transform->mirrored ? -rotated[i][j] : rotated[i][j]);
    return 1;
}

/* The near plane and the frame's nearest w in the object's units. */
static void prepare_depth(glint_transform *transform, const glint_view *view, int exponent) {
    int shift = 28 - exponent;
    int beyond = (int)glint_bits64((uint64_t)view->near_plane) - shift > 30; /* farther than any coordinate */
    int64_t w = beyond ? (int64_t)1 << 30 : scale(view->near_plane, shift);
    transform->near_plane = (int32_t)(w < SMALLEST_W ? SMALLEST_W : w);
    int bits = (int)glint_bits64((uint64_t)view->nearest);
    transform->depth_mantissa = (int32_t)scale(view->nearest, bits - 31);
    if (transform->depth_mantissa < 0) /* rounded up to 2^31 */
        transform->depth_mantissa = INT32_MAX;
    transform->depth_shift = (uint32_t)(shift - (bits - 31));
}

int64_t glint_transform_nearest(const glint_transform *transform, const glint_view *view) {
    int64_t w = smallest(transform, 2, 0, 1);
    if (w <= transform->near_plane)
        return view->near_plane;
    int shift = 28 - transform->exponent;
    int64_t nearest = shift > 0 ? w << shift : glint_shift_right64(w, (unsigned)-shift);
    return nearest > view->near_plane ? nearest : view->near_plane;
}

glint_status glint_transform_prepare(glint_transform *transform, const glint_view *view, const glint_config *config,
                                     const glint_object *object) {
    int64_t world[3][4], rows[3][4];
    if (!prepare_normals(transform, view, &object->pose))
        return GLINT_ERROR_POSE;
    if (!place_in_world(view, object, world))
        return GLINT_ERROR_RANGE;
    rotate(view, world, rows);
    transform->exponent = to_clip_space(transform, view, rows);
    transform->center_x = config->width * 8;
    transform->center_y = config->height * 8;
    prepare_depth(transform, view, transform->exponent);
    classify(transform, config);
    return GLINT_OK;
}
