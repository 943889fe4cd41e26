/* SPDX-License-Identifier: MIT */
/* An object's transform. */
#include "proof.h"

#include "../../src/geometry/transform.c"
#include "ranges.h"

#define MOST (1 << 30)

/* Stands on the bits of an OR, which are no fewer than those of each: below 2^45 if it is. */
/*@ requires \valid_read(view) && \valid_read(object);
    assigns \result, world[0][0 .. 3], world[1][0 .. 3], world[2][0 .. 3] \from *view, *object;
    ensures \result == 0 || \result == 1;
    ensures \initialized(&world[0][0 .. 3]) && \initialized(&world[1][0 .. 3]) && \initialized(&world[2][0 .. 3]);
    admit ensures \result == 0 || \subset(world[0][0 .. 3], (-0x200000000000 .. 0x200000000000));
    admit ensures \result == 0 || \subset(world[1][0 .. 3], (-0x200000000000 .. 0x200000000000));
    admit ensures \result == 0 || \subset(world[2][0 .. 3], (-0x200000000000 .. 0x200000000000)); */
static int place_in_world(const glint_view *view, const glint_object *object, int64_t world[3][4]);

/*@ requires columns == 3 || columns == 4;
    requires \subset(x[0][0 .. columns - 1], (-0x3fffffffffffffff .. 0x3fffffffffffffff));
    requires \subset(x[1][0 .. columns - 1], (-0x3fffffffffffffff .. 0x3fffffffffffffff));
    requires \subset(x[2][0 .. columns - 1], (-0x3fffffffffffffff .. 0x3fffffffffffffff));
    assigns \result, out[0][0 .. columns - 1], out[1][0 .. columns - 1], out[2][0 .. columns - 1]
        \from x[0][0 .. columns - 1], x[1][0 .. columns - 1], x[2][0 .. columns - 1], columns;
    ensures -30 <= \result <= 32;
    ensures \initialized(&out[0][0 .. columns - 1]) && \initialized(&out[1][0 .. columns - 1]);
    ensures \initialized(&out[2][0 .. columns - 1]);
    ensures \subset(out[0][0 .. columns - 1], (-0x40000000 .. 0x40000000));
    ensures \subset(out[1][0 .. columns - 1], (-0x40000000 .. 0x40000000));
    ensures \subset(out[2][0 .. columns - 1], (-0x40000000 .. 0x40000000)); */
static int rows_to_30_bits(int64_t x[3][4], int columns, int32_t out[3][4]);

/*@ requires \valid_read(view) && (columns == 3 || columns == 4);
    requires \subset(in[0][0 .. columns - 1], (-0x40000000 .. 0x40000000));
    requires \subset(in[1][0 .. columns - 1], (-0x40000000 .. 0x40000000));
    requires \subset(in[2][0 .. columns - 1], (-0x40000000 .. 0x40000000));
    assigns out[0][0 .. columns - 1], out[1][0 .. columns - 1], out[2][0 .. columns - 1]
        \from *view, in[0][0 .. columns - 1], in[1][0 .. columns - 1], in[2][0 .. columns - 1], columns;
    ensures \initialized(&out[0][0 .. columns - 1]) && \initialized(&out[1][0 .. columns - 1]);
    ensures \initialized(&out[2][0 .. columns - 1]);
    ensures \subset(out[0][0 .. columns - 1], (-0x1800000000 .. 0x1800000000));
    ensures \subset(out[1][0 .. columns - 1], (-0x1800000000 .. 0x1800000000));
    ensures \subset(out[2][0 .. columns - 1], (-0x1800000000 .. 0x1800000000)); */
static void rotate(const glint_view *view, int32_t in[3][4], int columns, int64_t out[3][4]);

/* Stands on no row having a magnitude above the largest sum of a row's: what bring_to_clip_space adds up. */
/*@ requires largest <= 0x2000000000000000;
    assigns \result, transform->matrix[0 .. 2], transform->translation[0 .. 2]
        \from rows[0][0 .. 3], rows[1][0 .. 3], rows[2][0 .. 3], largest;
    ensures -30 <= \result <= 32; */
static int set_rows(glint_transform *transform, int64_t rows[3][4], uint64_t largest);

/*@ requires \valid_read(view) && largest <= 0x2000000000000000;
    requires \subset(rows[0][0 .. 3], (-0x1800000000 .. 0x1800000000));
    requires \subset(rows[1][0 .. 3], (-0x1800000000 .. 0x1800000000));
    requires \subset(rows[2][0 .. 3], (-0x1800000000 .. 0x1800000000));
    assigns \result, transform->matrix[0 .. 2], transform->translation[0 .. 2], rows[0][0 .. 3], rows[1][0 .. 3],
        rows[2][0 .. 3] \from *view, largest, rows[0][0 .. 3], rows[1][0 .. 3], rows[2][0 .. 3];
    ensures -30 <= \result <= 32; */
static int bring_to_clip_space(glint_transform *transform, const glint_view *view, uint64_t largest,
                               int64_t rows[3][4]);

/*@ requires 0x1000 <= x <= 0x200000000000000 && -28 <= shift <= 34;
    assigns \result \from x, shift;
    ensures 0 <= \result <= 0x2000000000000000; */
static uint64_t in_rows(int64_t x, int shift);

/*@ requires \valid(transform);
    requires \subset(matrix[0][0 .. 2], (-0x40000000 .. 0x40000000));
    requires \subset(matrix[1][0 .. 2], (-0x40000000 .. 0x40000000));
    requires \subset(matrix[2][0 .. 2], (-0x40000000 .. 0x40000000));
    assigns transform->normal[0 .. 2] \from transform->mirrored, matrix[0][0 .. 2], matrix[1][0 .. 2],
        matrix[2][0 .. 2]; */
static void scale_normals(glint_transform *transform, int32_t matrix[3][4]);

/*@ requires \subset(p[0][0 .. 2], (-0x40000000 .. 0x40000000));
    requires \subset(p[1][0 .. 2], (-0x40000000 .. 0x40000000));
    requires \subset(p[2][0 .. 2], (-0x40000000 .. 0x40000000));
    assigns \result, wide[0][0 .. 2], wide[1][0 .. 2], wide[2][0 .. 2], cofactor[0][0 .. 2], cofactor[1][0 .. 2],
        cofactor[2][0 .. 2] \from p[0][0 .. 2], p[1][0 .. 2], p[2][0 .. 2];
    ensures -0x3000000000000000 <= \result <= 0x3000000000000000;
    ensures \initialized(&cofactor[0][0 .. 2]) && \initialized(&cofactor[1][0 .. 2]);
    ensures \initialized(&cofactor[2][0 .. 2]);
    ensures \subset(cofactor[0][0 .. 2], (-0x40000000 .. 0x40000000));
    ensures \subset(cofactor[1][0 .. 2], (-0x40000000 .. 0x40000000));
    ensures \subset(cofactor[2][0 .. 2], (-0x40000000 .. 0x40000000)); */
static int64_t find_cofactors(int32_t p[3][4], int64_t wide[3][4], int32_t cofactor[3][4]);

/*@ requires \valid(transform) && \valid_read(view) && \valid_read(pose);
    assigns \result, transform->mirrored, transform->normal[0 .. 2] \from *view, *pose;
    ensures \result == 0 || \result == 1; */
static int prepare_normals(glint_transform *transform, const glint_view *view, const glint_pose *pose);

/*@ requires 0x1000 <= w <= 0x200000000000000;
    requires -64 <= shift <= 60;
    assigns \result \from w, shift;
    ensures 0 <= \result <= 0x40000000; */
static int32_t to_units(int64_t w, int shift);

/*@ requires \valid(transform) && \valid_read(view);
    requires -32 <= exponent <= 92;
    assigns transform->near_plane, transform->nearest \from *view, exponent;
    ensures \initialized(&transform->near_plane) && \initialized(&transform->nearest);
    ensures 16 <= transform->near_plane <= 0x40000000;
    ensures 0 <= transform->nearest <= 0x40000000; */
static void prepare_depth(glint_transform *transform, const glint_view *view, int exponent);

/*@ requires \valid(transform) && \valid_read(config);
    requires 16 <= transform->near_plane <= 0x40000000;
    requires 0 <= transform->nearest <= 0x40000000;
    assigns transform->least_w, transform->visible, transform->clips, transform->nearest
        \from *transform, *config, is_parallel;
    ensures \initialized(&transform->least_w) && \initialized(&transform->visible);
    ensures \initialized(&transform->clips) && 0 <= transform->nearest <= 0x40000000; */
static void classify(glint_transform *transform, const glint_config *config, int is_parallel);

/*@ requires -0x100000 <= x <= 0x100000 && -0x100000 <= y <= 0x100000 && -0x100000 <= z <= 0x100000;
    assigns \result \from x, y, z;
    ensures -0x400000 <= \result <= 0x400000; */
static int32_t find_length(int32_t x, int32_t y, int32_t z);

/*@ requires \subset(place[0 .. 2], (-0x3fffffffffffffff .. 0x3fffffffffffffff));
    requires -0x3fffffffffffffff <= weight <= 0x3fffffffffffffff;
    requires \valid(to);
    assigns *to \from place[0 .. 2], weight;
    ensures \initialized(to) && -0x100000 <= to->x <= 0x100000 && -0x100000 <= to->y <= 0x100000 &&
        -0x100000 <= to->z <= 0x100000 && -0x400000 <= to->distance <= 0x400000 && 0 <= to->weight <= 0x2000; */
static void set_eye(const int64_t place[3], int64_t weight, glint_eye *to);

static void any_rows(int64_t rows[3][4], int64_t most) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            rows[i][j] = ANY_LONG(-most, most);
}

static void any_short_rows(int32_t rows[3][4]) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            rows[i][j] = ANY(-MOST, MOST);
}

static void any_object(glint_object *object, glint_mesh *mesh) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            object->pose.m[i][j] = ANY_INT;
    mesh->extent = (glint_vector){ANY(0, INT32_MAX), ANY(0, INT32_MAX), ANY(0, INT32_MAX)};
    mesh->offset = (glint_vector){ANY_INT, ANY_INT, ANY_INT};
    mesh->vertex_count = ANY_UNSIGNED(0, 65536);
    mesh->triangle_count = ANY_UNSIGNED(0, UINT_MAX);
    object->mesh = mesh;
    object->hidden = (uint8_t)ANY(0, 1);
}

/* Any pose, eye, extent and offset. @unreached 1 shift to the left */
PROOF(place_in_world_itself) {
    glint_view view;
    glint_object object;
    glint_mesh mesh;
    int64_t world[3][4];
    any_view(&view);
    any_object(&object, &mesh);
    place_in_world(&view, &object, world);
}

/*
 * Any numbers of up to 62 bits, by bits and sign of the first, the largest: an OR tells no places apart.
 * @options -eva-slevel-function glint_magnitude64:0
 */
PROOF(rows_to_30_bits) {
    int64_t rows[3][4];
    int32_t out[3][4];
    any_rows(rows, 0);
    rows_to_30_bits(rows, 4, out);
    FOR_PARTS(bits, 1, 62) {
        const int64_t least = (int64_t)1 << (bits - 1), most = 2 * (least - 1) + 1;
        any_rows(rows, most);
        rows[0][0] = ANY_LONG(least, most);
        rows_to_30_bits(rows, 4, out);
        rows[0][0] = ANY_LONG(-most, -least);
        rows_to_30_bits(rows, 4, out);
    }
}

/* Columns of up to 2^30, turned by axes up to 2 long. @unreached 1 shift to the left */
PROOF(rotate) {
    glint_view view;
    int32_t in[3][4];
    int64_t out[3][4];
    any_view(&view);
    any_short_rows(in);
    rotate(&view, in, 4, out);
}

/* Any sum up to 2^44, by the bits of 3/2 of it, and rows up to it; any up to 2^61, where rays are parallel. */
PROOF(set_rows) {
    glint_transform transform;
    int64_t rows[3][4];
    any_rows(rows, 0);
    set_rows(&transform, rows, 0);
    FOR_PARTS(bits, 1, 44) {
        const int64_t least = (((int64_t)1 << bits) + 2) / 3, most = (((int64_t)2 << bits) + 2) / 3 - 1;
        any_rows(rows, most);
        set_rows(&transform, rows, (uint64_t)ANY_LONG(least, most));
    }
    any_rows(rows, (int64_t)3 << 42);
    FOR_PARTS(bits, 45, 61) {
        const int64_t least = (((int64_t)1 << bits) + 2) / 3, most = bits < 61 ? 2 * least - 1 : (int64_t)1 << 61;
        set_rows(&transform, rows, (uint64_t)ANY_LONG(least, most));
    }
}

/* Rows of up to 3 2^35, any focal length, any w of parallel rays. @contract set_rows @unreached 1 shift to the left */
PROOF(bring_to_clip_space) {
    glint_transform transform;
    glint_view view;
    int64_t rows[3][4];
    any_view(&view);
    FOR_PARTS(shift, 18, 38) {
        view.focal_shift = (uint32_t)shift;
        any_rows(rows, (int64_t)3 << 35);
        bring_to_clip_space(&transform, &view, (uint64_t)ANY_LONG(0, (int64_t)1 << 61), rows);
    }
}

/*
 * Any matrix of up to 2^30. @contract glint_inverse_root
 * @unreached 1 shift to the left
 * @options -eva-subdivide-non-linear 20
 */
PROOF(scale_normals) {
    glint_transform transform;
    int32_t matrix[3][4];
    any_short_rows(matrix);
    transform.mirrored = (uint8_t)ANY(0, 1);
    scale_normals(&transform, matrix);
}

/* Any three columns of up to 2^30. @contract rows_to_30_bits */
PROOF(find_cofactors) {
    int32_t rows[3][4], cofactor[3][4];
    int64_t wide[3][4];
    any_short_rows(rows);
    find_cofactors(rows, wide, cofactor);
}

/* Any pose. @contract find_cofactors rows_to_30_bits rotate scale_normals */
PROOF(prepare_normals) {
    glint_transform transform;
    glint_view view;
    glint_pose pose;
    any_view(&view);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            pose.m[i][j] = ANY_INT;
    prepare_normals(&transform, &view, &pose);
}

/* w from 2^12 to 2^57, by its bits; any shift from -64 to 60. @unreached 1 leading zeros of 0 */
PROOF(to_units) {
    FOR_PARTS(bits, 13, 58) {
        const int64_t least = (int64_t)1 << (bits - 1), w = ANY_LONG(least, bits < 58 ? 2 * least - 1 : least);
        to_units(w, ANY(-64, bits - 31));
        FOR_PARTS(shift, bits - 30, 60) {
            to_units(w, shift);
        }
    }
}

/* Any near plane and nearest w, any exponent from -32 to 92. @contract to_units */
PROOF(prepare_depth) {
    glint_transform transform;
    glint_view view;
    any_view(&view);
    prepare_depth(&transform, &view, ANY(-32, 92));
}

/* w from 2^12 to 2^57, by its bits; any shift from -28 to 34. @unreached 1 leading zeros of 0 */
PROOF(in_rows) {
    FOR_PARTS(bits, 13, 58) {
        const int64_t least = (int64_t)1 << (bits - 1), x = ANY_LONG(least, bits < 58 ? 2 * least - 1 : least);
        FOR_PARTS(shift, -28, 34) {
            in_rows(x, (int)shift);
        }
    }
}

/*
 * Rows below 2^30, the last one's magnitudes summing up to 3 2^28, by parts; any screen.
 * @narrowing sums over the box are found modulo 2^32: right wherever the true value fits
 * @options -eva-slevel-function classify:0
 */
PROOF(classify) {
    glint_transform transform;
    glint_config config;
    any_transform(&transform);
    config.width = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    config.height = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    FOR_PARTS(a, 1, 3) {
        FOR_PARTS(b, 1, 4 - a) {
            FOR_PARTS(c, 1, 5 - a - b) {
                const int32_t units[4] = {a, b, c, 6 - a - b - c};
                for (int i = 0; i < 3; i++)
                    glint_row_set(&transform.matrix[2], i, ANY(-units[i] * (1 << 28), units[i] * (1 << 28)));
                transform.translation[2] = ANY(-units[3] * (1 << 28), units[3] * (1 << 28));
                transform.nearest = ANY(0, 1 << 30);
                classify(&transform, &config, 0);
                classify(&transform, &config, 1);
            }
        }
    }
}

/* Exponents up to 45, or a near plane beyond all that is seen. */
PROOF(glint_transform_nearest) {
    glint_transform transform;
    glint_view view;
    any_view(&view);
    any_transform(&transform);
    transform.exponent = ANY(1, 45);
    glint_transform_nearest(&transform, &view);
    transform.exponent = ANY(46, 92);
    transform.near_plane = 1 << 30;
    glint_transform_nearest(&transform, &view);
}

/*
 * Any object under any camera.
 * @contract prepare_normals place_in_world rows_to_30_bits rotate bring_to_clip_space prepare_depth classify in_rows
 * @options -eva-split-return-function prepare_object:full
 */
PROOF(glint_transform_prepare) {
    glint_transform transform;
    glint_view view;
    glint_config config;
    glint_object object;
    glint_mesh mesh;
    any_view(&view);
    view.is_parallel = (uint8_t)ANY(0, 1);
    any_object(&object, &mesh);
    config.width = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    config.height = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    config.skips_degenerate = (uint8_t)ANY(0, 1);
    glint_transform_prepare(&transform, &view, &config, &object);
}

/* Any place of 20 bits. @contract glint_unit */
PROOF(find_length) {
    find_length(ANY(-(1 << 20), 1 << 20), ANY(-(1 << 20), 1 << 20), ANY(-(1 << 20), 1 << 20));
}

static void any_place(int64_t place[3], int64_t most) {
    for (int i = 0; i < 3; i++)
        place[i] = ANY_LONG(-most, most);
}

/*
 * Any numbers of up to 62 bits, by bits and sign of the largest, the first or the weight: an OR tells no places apart.
 * @contract find_length
 * @options -eva-slevel-function glint_magnitude64:0
 */
PROOF(set_eye) {
    int64_t place[3];
    glint_eye to;
    any_place(place, 0);
    set_eye(place, 0, &to);
    FOR_PARTS(bits, 1, 62) {
        const int64_t least = (int64_t)1 << (bits - 1), most = 2 * (least - 1) + 1;
        any_place(place, most);
        set_eye(place, ANY_LONG(least, most), &to);
        set_eye(place, ANY_LONG(-most, -least), &to);
        place[0] = ANY_LONG(least, most);
        set_eye(place, ANY_LONG(-most, most), &to);
        place[0] = ANY_LONG(-most, -least);
        set_eye(place, ANY_LONG(-most, most), &to);
    }
}

/* Any transform. @contract find_cofactors set_eye */
PROOF(glint_transform_eye) {
    glint_transform transform;
    glint_eye to;
    any_transform(&transform);
    transform.clips = (uint8_t)ANY(0, 3);
    glint_transform_eye(&transform, &to);
}
