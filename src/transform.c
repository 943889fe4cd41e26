/* SPDX-License-Identifier: MIT */
/* Transform: an object's pose under the camera, with ranges checked once so that no vertex can overflow. */
#include "frame.h"

#define RANGE ((int64_t)1 << 45) /* Q28: 2^17 units */

/* Coordinates are rounded to a step or two: this keeps w above 0. */
#define SMALLEST_W 16

/* Exact in 64 bits: pose times mesh extent, and the mesh's origin relative to the eye; Q28. */
static int place_in_world(const glint_view *view, const glint_object *object, int64_t axes[3][3], int64_t origin[3]) {
    const glint_mesh *mesh = object->mesh;
    const int32_t extent[3] = {mesh->extent.x, mesh->extent.y, mesh->extent.z};
    const int32_t offset[3] = {mesh->offset.x, mesh->offset.y, mesh->offset.z};
    for (int i = 0; i < 3; i++) {
        origin[i] = ((int64_t)object->pose.m[i][3] - view->eye[i]) * (1 << 12);
        for (int j = 0; j < 3; j++) {
            axes[i][j] = glint_round_shift64((int64_t)object->pose.m[i][j] * extent[j], 4);
            origin[i] += glint_round_shift64((int64_t)object->pose.m[i][j] * offset[j], 4);
            if (glint_magnitude64(axes[i][j]) >= (uint64_t)RANGE)
                return 0;
        }
        if (glint_magnitude64(origin[i]) >= (uint64_t)RANGE)
            return 0;
    }
    return 1;
}

/* Row i of the camera's rotation times a world column, Q28; below 2^47. */
static int64_t rotate(const glint_view *view, int i, int64_t x, int64_t y, int64_t z) {
    return glint_round_shift64(view->rotation[i][0] * x + view->rotation[i][1] * y + view->rotation[i][2] * z, 16);
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
    int64_t p[3][3], cofactor[3][3], rotated[3][3];
    uint64_t bits = 0;
    for (int i = 0; i < 9; i++)
        bits |= glint_magnitude64(pose->m[i / 3][i % 3]);
    int shift = (int)glint_bits64(bits) - 30;
    for (int i = 0; i < 9; i++)
        p[i / 3][i % 3] = scale(pose->m[i / 3][i % 3], shift);
    bits = 0;
    for (int i = 0; i < 9; i++) {
        int r = i / 3, c = i % 3, r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
        cofactor[r][c] = p[r1][c1] * p[r2][c2] - p[r1][c2] * p[r2][c1];
        bits |= glint_magnitude64(cofactor[r][c]);
    }
    shift = (int)glint_bits64(bits) - 30;
    for (int i = 0; i < 9; i++)
        cofactor[i / 3][i % 3] = scale(cofactor[i / 3][i % 3], shift);
    int64_t determinant = p[0][0] * cofactor[0][0] + p[0][1] * cofactor[0][1] + p[0][2] * cofactor[0][2];
    if (glint_magnitude64(determinant) < (uint64_t)1 << 36) /* 2^-24 of what orthogonal axes give */
        return 0;
    transform->mirrored = determinant < 0;
    bits = 0;
    for (int i = 0; i < 9; i++) {
        int c = i % 3;
        int64_t entry = rotate(view, i / 3, cofactor[0][c], cofactor[1][c], cofactor[2][c]);
        rotated[i / 3][c] = transform->mirrored ? -entry : entry;
        bits |= glint_magnitude64(entry);
    }
    shift = (int)glint_bits64(bits) - 30;
    for (int i = 0; i < 9; i++)
        transform->normal[i / 3][i % 3] = (int32_t)scale(rotated[i / 3][i % 3], shift);
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
    int64_t axes[3][3], origin[3], rows[3][4];
    if (!prepare_normals(transform, view, &object->pose))
        return GLINT_ERROR_POSE;
    if (!place_in_world(view, object, axes, origin))
        return GLINT_ERROR_RANGE;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            rows[i][j] = rotate(view, i, axes[0][j], axes[1][j], axes[2][j]);
        rows[i][3] = rotate(view, i, origin[0], origin[1], origin[2]);
    }
    transform->exponent = to_clip_space(transform, view, rows);
    transform->center_x = config->width * 8;
    transform->center_y = config->height * 8;
    prepare_depth(transform, view, transform->exponent);
    classify(transform, config);
    return GLINT_OK;
}
