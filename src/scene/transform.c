/* SPDX-License-Identifier: MIT */
/* Brings an object's pose under the camera, and checks ranges once so that no vertex can overflow. */
#include "view.h"

/* Coordinates are rounded to a step or two. This keeps w above 0. */
#define SMALLEST_W 16

int64_t glint_shift_round64(int64_t x, int shift) {
    return shift > 0 ? glint_round_shift64(x, (unsigned)shift) : x * ((int64_t)1 << -shift);
}

/* ---- Poses ---- */

/* Brings three rows of three to 30 bits, by their largest number. */
static void rows_to_30_bits(int64_t x[3][3], int32_t out[3][3]) {
    uint64_t bits = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            bits |= glint_magnitude64(x[i][j]);
    const int shift = (int)glint_bits64(bits) - 30;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            out[i][j] = (int32_t)glint_shift_round64(x[i][j], shift);
}

/* Finds the cofactors of three columns, brought to 30 bits by way of `wide`. @return the determinant on their scale */
static int64_t find_cofactors(int32_t p[3][3], int64_t wide[3][3], int32_t cofactor[3][3]) {
    static const uint8_t next[3] = {1, 2, 0};
    int64_t determinant = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t *a = p[next[i]], *b = p[next[next[i]]];
        for (int j = 0; j < 3; j++) {
            int k = next[j], l = next[k];
            wide[i][j] = glint_product(a[k], b[l]) - glint_product(a[l], b[k]);
        }
    }
    rows_to_30_bits(wide, cofactor);
    for (int j = 0; j < 3; j++)
        determinant += glint_product(p[0][j], cofactor[0][j]);
    return determinant;
}

/* Finds a pose's cofactors, of 30 bits. @return its determinant, 2^60 of orthogonal axes, or 0 where it is singular */
static int64_t find_pose_cofactors(const glint_pose *pose, int64_t wide[3][3], int32_t cofactor[3][3]) {
    int32_t p[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            wide[i][j] = pose->m[i][j];
    rows_to_30_bits(wide, p);
    const int64_t determinant = find_cofactors(p, wide, cofactor);
    return glint_magnitude64(determinant) < (uint64_t)1 << 36 ? 0 : determinant;
}

/* The sign of a determinant above this is certain. The determinant of orthogonal axes of 14 bits is about 2^28. */
#define CERTAIN (1 << 19)

/* Finds the sign of a pose's determinant, or 0 where it is singular. `p` is the pose in 28 bits, of which 14 suffice
 * mostly. */
static int find_sign(const glint_pose *pose, int32_t p[3][3]) {
    int64_t wide[3][3];
    int32_t q[3][3], cofactor[3][3], sum = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            q[i][j] = glint_shift_right(p[i][j], 14);
    for (int j = 0; j < 3; j++) {
        const int k = j < 2 ? j + 1 : 0, l = 3 - j - k;
        sum += q[0][j] * glint_shift_right(q[1][k] * q[2][l] - q[1][l] * q[2][k], 14);
    }
    if (sum > CERTAIN || sum < -CERTAIN)
        return sum > 0 ? 1 : -1;
    const int64_t determinant = find_pose_cofactors(pose, wide, cofactor);
    return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
}

/* Scales the matrix of normals so that a rotation keeps lengths: three rows of one length are about 2^13 UNIT long.
 * The squares of all entries then sum up to at most 3 2^56, so that a transformed normal is below 3 2^28. */
static void scale_normals(glint_transform *transform, int32_t matrix[3][3]) {
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

/* The inverse transpose is, up to its scale, the cofactors with the sign of the determinant. */
void glint_transform_begin_normals(glint_transform *transform, const glint_view *view, const glint_pose *pose) {
    int64_t wide[3][3];
    int32_t cofactor[3][3];
    find_pose_cofactors(pose, wide, cofactor);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            int64_t sum = 0;
            for (int k = 0; k < 3; k++)
                sum += glint_product(view->rotation[i][k], cofactor[k][j]);
            wide[i][j] = glint_shift_round64(sum, 12);
        }
    }
    rows_to_30_bits(wide, cofactor);
    scale_normals(transform, cofactor);
}

/* ---- Places ---- */

/* The camera's rotation is applied to numbers of so many bits (glint_turn). */
#define TURNED_BITS 28

/* Multiplies numbers by 2^n, rounded down. */
static void scale_all(int32_t *x, int count, int32_t n) {
    int32_t *const end = x + count;
    if (n >= 0)
        for (; x < end; x++)
            *x = glint_shift_left(*x, (unsigned)n);
    else
        for (const unsigned down = (unsigned)glint_least(-n, 31); x < end; x++)
            *x = glint_shift_right(*x, down);
}

/* Returns x 2^-n rounded to nearest, halves up. */
static inline int32_t round_by(int32_t x, int32_t n) {
    if (n <= 0)
        return glint_shift_left(x, (unsigned)-n);
    return n > 31 ? 0 : glint_shift_right(glint_shift_right(x, (unsigned)n - 1) + 1, 1);
}

static inline int32_t bits_of(uint32_t x) {
    return 32 - (int32_t)glint_leading_zeros(x);
}

static inline uint32_t magnitude(int32_t x) {
    return x < 0 ? 0u - (uint32_t)x : (uint32_t)x;
}

/* Finds the vector from the eye to the mesh's origin, brought to TURNED_BITS: it was 2^*exponent units. @return 0
 * where the vector has 2^17 units or more in a direction */
static int find_way(const glint_view *view, const glint_object *object, int32_t way[3], int32_t *exponent) {
    const int32_t offset[3] = {object->mesh->offset.x, object->mesh->offset.y, object->mesh->offset.z};
    const int is_offset = (offset[0] | offset[1] | offset[2]) != 0;
    int64_t wide[3]; /* Q16, where the mesh has an offset Q28 */
    uint64_t all = 0;
    for (int i = 0; i < 3; i++) {
        wide[i] = (int64_t)object->pose.m[i][3] - view->eye[i];
        if (is_offset) {
            wide[i] *= 1 << 12;
            for (int j = 0; j < 3; j++)
                wide[i] += glint_shift_round64(glint_product(object->pose.m[i][j], offset[j]), 4);
        }
        all |= glint_magnitude64(wide[i]);
    }
    const int bits = (int)glint_bits64(all), down = bits - TURNED_BITS, fraction = is_offset ? 28 : 16;
    *exponent = down - fraction;
    for (int i = 0; i < 3; i++)
        way[i] = down > 0 ? (int32_t)glint_shift_right64(wide[i], (unsigned)down)
                          : glint_shift_left((int32_t)wide[i], (unsigned)-down);
    return bits <= fraction + 17;
}

/* Is a mesh smaller than 2^17 units from its middle, along the axes of the world? */
static GLINT_NOINLINE int is_in_range(const glint_object *object) {
    const int32_t extent[3] = {object->mesh->extent.x, object->mesh->extent.y, object->mesh->extent.z};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            if (glint_magnitude64(glint_shift_round64(glint_product(object->pose.m[i][j], extent[j]), 4)) >> 45)
                return 0;
    return 1;
}

/* An object in camera space: columns of 2^15 steps and the vector to its origin are below 2^30, and 2^ their exponents
 * units. */
typedef struct placed {
    int32_t columns[3][3], way[3];
    int32_t exponent, way_exponent;
} placed;

/* Brings a pose under the camera. `turned` is the pose's rotation in TURNED_BITS, 2^-down of it. */
static glint_status place(const glint_view *view, const glint_object *object, int32_t turned[3][3], int32_t down,
                          placed *to) {
    const int32_t extent[3] = {object->mesh->extent.x, object->mesh->extent.y, object->mesh->extent.z};
    const uint32_t all = (uint32_t)extent[0] | (uint32_t)extent[1] | (uint32_t)extent[2];
    const int32_t up = glint_most((int32_t)glint_leading_zeros(all) - 1, 0);
    int32_t way[3];
    if (!find_way(view, object, way, &to->way_exponent) ||
        (TURNED_BITS + down + bits_of(all) > 48 && !is_in_range(object)))
        return GLINT_ERROR_RANGE;
    to->exponent = down - up;
    for (int i = 0; i < 3; i++)
        to->way[i] = glint_turn(view->rotation[i], way[0], way[1], way[2]);
    for (int j = 0; j < 3; j++) {
        const int32_t x = turned[0][j], y = turned[1][j], z = turned[2][j];
        const int32_t scale = glint_shift_left(extent[j], (unsigned)up);
        for (int i = 0; i < 3; i++)
            to->columns[j][i] = glint_product_high(glint_turn(view->rotation[i], x, y, z), scale);
    }
    return GLINT_OK;
}

/* Returns the bits of one and a half times the largest magnitude that a row has in the bounding box. */
static inline int32_t find_bits(uint32_t columns, uint32_t way) {
    return bits_of(columns + columns / 2 + way + way / 2);
}

/*
 * Sets clip rows x, y and w, so that magnitudes in the bounding box, and w of parallel rays, are at most 2.67 2^28, a
 * third of 2^31. Screen y runs down, and z towards the eye.
 */
static void bring_to_clip_space(glint_transform *transform, const glint_view *view, placed *p) {
    const int32_t more = 25 - (int32_t)view->focal_shift;              /* rows x and y are over 2^more */
    const int32_t exponent = glint_most(p->exponent, p->way_exponent); /* the exponent of both in sums */
    const unsigned down = (unsigned)glint_least(exponent - p->exponent, 31),
                   way_down = (unsigned)glint_least(exponent - p->way_exponent, 31);
    const int32_t focal = view->focal_mantissa << 7;
    int32_t bits = INT32_MIN;
    for (int i = 0; i < 3; i++) {
        int32_t x = p->columns[0][i], y = p->columns[1][i], z = p->columns[2][i], t = p->way[i];
        if (i < 2) {
            x = glint_product_high(x, focal), y = glint_product_high(y, focal);
            z = glint_product_high(z, focal), t = glint_product_high(t, focal);
        }
        if (i > 0)
            x = -x, y = -y, z = -z, t = -t;
        p->columns[0][i] = x, p->columns[1][i] = y, p->columns[2][i] = z, p->way[i] = t;
        const int32_t here =
            find_bits((magnitude(x) + magnitude(y) + magnitude(z) + 3) >> down, (magnitude(t) + 1) >> way_down);
        bits = glint_most(bits, here + (i < 2 ? more : 0));
    }
    if (view->is_parallel)
        bits = glint_most(bits, (int32_t)glint_bits64((uint64_t)(view->nearest + view->nearest / 2)) - 28 - exponent);
    for (int i = 0; i < 3; i++) {
        const int32_t cut = bits - 30 - (i < 2 ? more : 0);
        const int32_t of_columns = cut + exponent - p->exponent;
        for (int j = 0; j < 3; j++)
            glint_row_set(&transform->matrix[i], j, round_by(p->columns[j][i], of_columns));
        transform->translation[i] = round_by(p->way[i], cut + exponent - p->way_exponent);
    }
    transform->exponent = 30 - bits - exponent;
}

/* Finds the smallest value of a x + b w over the box, given row x and row w of the matrix with the translation last.
 * Sums are modulo 2^32, and the result fits. */
static int32_t smallest(const int32_t x[4], const int32_t w[4], int32_t a, int32_t b) {
    int32_t value = glint_add_wrap(glint_multiply_wrap(a, x[3]), glint_multiply_wrap(b, w[3]));
    for (int j = 0; j < 3; j++) {
        const int32_t change = glint_add_wrap(glint_multiply_wrap(a, x[j]), glint_multiply_wrap(b, w[j]));
        value = glint_add_wrap(value, change < 0 ? change : -change);
    }
    return value;
}

/* Matrices lose so many bits here: row sums are then below 2.67 2^17 times 2046 + 1025. */
#define BOX_CUT 11

static void cut_row(const glint_transform *transform, int i, int32_t cut[4]) {
    for (int j = 0; j < 3; j++)
        cut[j] = glint_shift_right(glint_row_get(&transform->matrix[i], j), BOX_CUT);
    cut[3] = glint_shift_right(transform->translation[i], BOX_CUT);
}

/* Tests in one direction whether any of the box is on the screen, and whether any passes the guard band. Both are
 * tested to within the error of cutting, at most a step of each of four columns of both rows. */
static GLINT_NOINLINE void classify_row(glint_transform *transform, int i, int32_t side) {
    const int32_t band = 2 * GLINT_GUARD_BAND;
    int32_t x[4], w[4] = {0, 0, 0, 0};
    cut_row(transform, i, x);
    if (transform->clips & GLINT_PARALLEL)
        w[3] = glint_shift_right(transform->nearest, BOX_CUT);
    else
        cut_row(transform, 2, w);
    for (int32_t sign = -1; sign <= 1; sign += 2) {
        if (smallest(x, w, sign, 1) < 8)
            transform->clips |= 1;
        if (smallest(x, w, -sign * band, -side) > 4 * (band + side))
            transform->visible = 0;
    }
}

/* Returns half the extent of the box in a row. */
static inline int32_t extent_of(const glint_row *row) {
    const int32_t x = glint_row_get(row, 0), y = glint_row_get(row, 1), z = glint_row_get(row, 2);
    return (x < 0 ? -x : x) + (y < 0 ? -y : y) + (z < 0 ? -z : z);
}

/* Tests whether any of the box is on the screen, and whether any passes the near plane or the guard band. A box whose
 * middle is on the screen and that lies far from the band needs no further test. */
static void classify(glint_transform *transform, const glint_config *config, int is_parallel) {
    const int32_t extent = extent_of(&transform->matrix[2]);
    int32_t w = transform->translation[2], least = w - extent;
    transform->least_w = least;
    transform->visible = w + extent >= transform->near_plane;
    transform->clips = least < transform->near_plane;
    if (is_parallel) {
        transform->clips |= GLINT_PARALLEL;
        transform->nearest = glint_most(transform->nearest, 1);
        w = least = transform->nearest;
    }
    for (int i = 0; i < 2; i++) {
        const int32_t t = transform->translation[i], middle = t < 0 ? -t : t;
        const int32_t side = (i ? config->height : config->width) + 1; /* in half pixels */
        if (least - middle - extent_of(&transform->matrix[i]) < 17 << BOX_CUT ||
            glint_shift_right(middle, BOX_CUT) * (2 * GLINT_GUARD_BAND) > glint_shift_right(w, BOX_CUT) * side)
            classify_row(transform, i, side);
    }
}

/* Converts a w, Q28, to units of 2^shift. Above 2^30, which is farther than any coordinate, it returns 2^30. */
static int32_t to_units(int64_t w, int shift) {
    return (int)glint_bits64((uint64_t)w) - shift > 30 ? 1 << 30 : (int32_t)glint_shift_round64(w, shift);
}

/* Sums up the magnitudes of three entries and a translation. */
static uint32_t row_sum(const glint_row *row, int32_t t) {
    return (uint32_t)extent_of(row) + magnitude(t);
}

/* Sets entries of 16 bits and a translation of 31, 2^up times as large as those of clip space. */
static void set_short_row(const glint_row *row, int32_t t, unsigned up, int32_t out[4]) {
    for (int j = 0; j < 3; j++)
        out[j] = glint_shift_right(glint_shift_left(glint_row_get(row, j), up) + (1 << 14), 15);
    out[3] = glint_shift_left(t, up);
}

/* Takes 2^-10 off a row, since the guard band is 1023 pixels wide and not 1024. */
static void to_pixels(int32_t row[4]) {
    for (int j = 0; j < 3; j++)
        row[j] -= glint_shift_right(row[j] + (1 << 9), 10);
    row[3] += (1 << 15) - glint_shift_right(row[3], 10); /* this includes half of what is cut off */
}

/* Sets the short matrix, where it serves the object. */
static void set_short_matrix(glint_transform *transform) {
    glint_short_matrix *m = &transform->brief;
    const uint32_t x = row_sum(&transform->matrix[0], transform->translation[0]);
    const uint32_t y = row_sum(&transform->matrix[1], transform->translation[1]);
    const uint32_t w = row_sum(&transform->matrix[2], transform->translation[2]);
    const unsigned up = glint_leading_zeros((x | y) + 4) - 2, up_w = glint_leading_zeros(w + 4) - 1;
    m->serves = 0;
    if (transform->clips || transform->least_w < glint_shift_right((int32_t)w, 2) ||
        glint_shift_right(transform->least_w, 2) < (int32_t)(x > y ? x : y))
        return;
    const int32_t nearest = glint_most(transform->nearest, 1);
    const int32_t bits = 32 - (int32_t)glint_leading_zeros((uint32_t)nearest);
    const int32_t shift = 6 + (int32_t)up - (int32_t)up_w, depth_shift = 32 - bits - (int32_t)up_w;
    if (shift < 3 || shift > 31 || depth_shift > 31)
        return;
    set_short_row(&transform->matrix[0], transform->translation[0], up, m->x);
    set_short_row(&transform->matrix[1], transform->translation[1], up, m->y);
    set_short_row(&transform->matrix[2], transform->translation[2], up_w, m->w);
    const uint32_t middle = (uint32_t)m->w[3];
    const uint32_t extent = (magnitude(m->w[0]) + magnitude(m->w[1]) + magnitude(m->w[2])) << 15;
    if (middle + extent > INT32_MAX || middle - extent < 1u << 28) /* rounding of entries moves w by up to 3 2^14 */
        return;
    to_pixels(m->x);
    to_pixels(m->y);
    m->nearest =
        bits > 16 ? (uint32_t)glint_shift_right(nearest, (unsigned)bits - 16) : (uint32_t)nearest << (16 - bits);
    m->shift = (uint8_t)shift;
    m->depth_shift = (uint8_t)depth_shift;
    m->serves = 1;
}

int64_t glint_transform_nearest(const glint_transform *transform, const glint_view *view) {
    const int32_t w = glint_most(transform->least_w, transform->near_plane);
    if (w == transform->near_plane && w > SMALLEST_W)
        return view->near_plane;
    const int64_t nearest = glint_shift_round64(w, transform->exponent - 28);
    return nearest > view->near_plane ? nearest : view->near_plane;
}

/* The frame's nearest w, rounded to the object's units, must not pass any w that is visible. */
void glint_transform_place(glint_transform *transform, const glint_view *view) {
    if (transform->clips & GLINT_PARALLEL) /* the nearest w does not depend on other objects then */
        return;
    transform->nearest = glint_least(to_units(view->nearest, 28 - transform->exponent),
                                     glint_most(transform->least_w, transform->near_plane));
    set_short_matrix(transform);
}

/* A hidden object is all 0. This is out of line since gcc 12 keeps a 0 in a register of the FPU otherwise. */
static GLINT_NOINLINE glint_status prepare_object(glint_transform *transform, const glint_view *view,
                                                  const glint_config *config, const glint_object *object) {
    int32_t turned[3][3];
    uint32_t all = 0;
    placed at;
    if (object->hidden) {
        *transform = (glint_transform){0};
        return GLINT_OK;
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            turned[i][j] = object->pose.m[i][j];
            all |= glint_magnitude_bits(turned[i][j]);
        }
    }
    const int32_t down = bits_of(all) - TURNED_BITS;
    scale_all(turned[0], 9, -down);
    const int sign = find_sign(&object->pose, turned);
    if (!sign)
        return GLINT_ERROR_POSE;
    if (place(view, object, turned, down, &at) != GLINT_OK)
        return GLINT_ERROR_RANGE;
    transform->mirrored = sign < 0;
    bring_to_clip_space(transform, view, &at);
    transform->center_x = config->width * (8 << 11) + (1 << 10);
    transform->center_y = config->height * (8 << 11) + (1 << 10);
    transform->near_plane = glint_most(to_units(view->near_plane, 28 - transform->exponent), SMALLEST_W);
    transform->nearest = view->is_parallel ? to_units(view->nearest, 28 - transform->exponent) : 0;
    classify(transform, config, view->is_parallel);
    transform->brief.serves = 0;
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

/* Once the largest is brought to 20 bits, numbers that had this many are off by at most 1 by the rounding of
 * cofactors. */
#define LEAST_BITS 51

/* Returns |(x, y, z)| of 20 bits, too large by at most 2^-9 of it and 128. It is the product with the unit vector. */
static int32_t find_length(int32_t x, int32_t y, int32_t z) {
    int16_t unit[3];
    glint_unit(x, y, z, unit);
    const int32_t length =
        glint_shift_right(x, 6) * unit[0] + glint_shift_right(y, 6) * unit[1] + glint_shift_right(z, 6) * unit[2];
    return glint_shift_right(length, 9) + glint_shift_right(length, 19) + 128;
}

/* Brings a place and its weight to the bits of an eye. Where rounding leaves too few digits, sets an eye that no
 * triangle faces away from. */
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
    to->weight = weight > 0 ? (int32_t)(weight >> (size - 13)) : 0; /* only rounding takes the weight below 0 */
}

/*
 * With the matrix of steps A and the translation t, the eye is where A e + 2^15 t = 0. That is e = 2^15 E / W, where E
 * = -C^T t, W = det A, and C are the cofactors of A. W of a mirrored object is below 0. Parallel rays come from
 * infinitely far along -w: there t is (0, 0, 1), and W is 0.
 */
void glint_transform_eye(const glint_transform *transform, glint_eye *eye) {
    int32_t rows[3][3], cofactor[3][3];
    int64_t wide[3][3], place[3];
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
