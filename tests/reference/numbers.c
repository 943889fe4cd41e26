/* SPDX-License-Identifier: MIT */
/*
 * Suite: the library's arithmetic of several arguments against libm in long double, at the largest errors its contracts
 * state; tests/domain has the functions of one.
 */
#include "fast/fast_begin.h"
#include "frame/cull.h"
#include "glint.h"
#include "harness.h"

#include <math.h>

/* A linear congruential generator (Knuth, MMIX); its high half. */
static uint32_t random_bits(void) {
    static uint64_t state = 1;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(state >> 32);
}

static int32_t random_signed(unsigned bits) {
    return (int32_t)random_bits() >> (32 - bits);
}

static glint_vector random_vector(unsigned bits) {
    glint_vector vector;
    vector.x = random_signed(bits);
    vector.y = random_signed(bits);
    vector.z = random_signed(bits);
    return vector;
}

/* Says how much of what a contract allows was found; fails above 1. */
static void report(const char *name, long double worst, long double allowed) {
    test_write("  ");
    test_write(name);
    test_write(": ");
    test_write_number((int64_t)(worst / allowed * 1000));
    test_write(" thousandths of the error allowed\n");
    CHECK(worst <= allowed);
}

static void sine_of_quarter_turns_is_exact(void) {
    for (int quarter = -8; quarter <= 8; quarter++) {
        static const int sines[4] = {0, 1, 0, -1};
        CHECK_EQUAL(glint_sin(quarter * 90 * GLINT_ONE), sines[(unsigned)quarter & 3] * GLINT_ONE);
        CHECK_EQUAL(glint_cos(quarter * 90 * GLINT_ONE), sines[(unsigned)(quarter + 1) & 3] * GLINT_ONE);
    }
}

/* Within 2^20 of the quarter turns; elsewhere the sine is further from 1 than it is off. */
static void sine_stays_within_one(void) {
    for (uint32_t phase = 0x40000000u - (1u << 20); phase <= 0x40000000u + (1u << 20); phase++) {
        CHECK_AT_MOST(glint_sine(phase), 1 << 30);
        CHECK_AT_MOST(-glint_sine(phase + 0x80000000u), 1 << 30);
    }
}

static void powers_of_0_and_1(void) {
    static const int32_t exponents[] = {1, 32768, 65536, 65537, 2 << 16, 100 << 16, 1024 << 16, INT32_MAX};
    for (unsigned i = 0; i < TEST_COUNT(exponents); i++) {
        CHECK_EQUAL(glint_power(0, exponents[i]), 0);
        CHECK_EQUAL(glint_power(1u << 31, exponents[i]), 1 << 30);
    }
    CHECK_EQUAL(glint_power(0, 0), 1 << 30);
    CHECK_EQUAL(glint_power(12345, 0), 1 << 30);
    CHECK_EQUAL(glint_log2(0), -32 * (int64_t)(1 << 26));
}

static void unit_vectors(void) {
    long double worst = 0;
    long double worst_length = 0;
    for (int i = 0; i < 3000000; i++) {
        unsigned bits = 1 + random_bits() % 32;
        int32_t v[3];
        v[0] = random_signed(bits);
        v[1] = random_signed(1 + random_bits() % bits);
        v[2] = random_signed(bits);
        int16_t unit[3];
        long double length = sqrtl((long double)v[0] * v[0] + (long double)v[1] * v[1] + (long double)v[2] * v[2]);
        glint_unit(v[0], v[1], v[2], unit);
        for (int axis = 0; axis < 3 && length > 0; axis++)
            worst = fmaxl(worst, fabsl(unit[axis] - v[axis] / length * GLINT_UNIT));
        long double got = sqrtl((long double)(unit[0] * unit[0]) + unit[1] * unit[1] + unit[2] * unit[2]);
        worst_length = fmaxl(worst_length, length > 0 ? fabsl(got - GLINT_UNIT) : got);
    }
    report("unit vector", worst, 2.3L);
    report("unit vector's length", worst_length, 2.3L);
}

static void unit_vectors_of_extremes(void) {
    static const int32_t values[] = {INT32_MIN, INT32_MIN + 1, -65536, -1, 0, 1, 32767, 32768, INT32_MAX};
    long double worst = 0;
    for (unsigned i = 0; i < 9 * 9 * 9; i++) {
        const int32_t v[3] = {values[i % 9], values[i / 9 % 9], values[i / 81]};
        int16_t unit[3];
        long double length = sqrtl((long double)v[0] * v[0] + (long double)v[1] * v[1] + (long double)v[2] * v[2]);
        glint_unit(v[0], v[1], v[2], unit);
        for (int axis = 0; axis < 3 && length > 0; axis++)
            worst = fmaxl(worst, fabsl(unit[axis] - v[axis] / length * GLINT_UNIT));
        CHECK(length > 0 || (unit[0] == 0 && unit[1] == 0 && unit[2] == 0));
    }
    report("unit vector of extremes", worst, 2.3L);
}

static void leading_zeros_by_table(void) {
    CHECK_EQUAL(glint_leading_zeros_by_table(0), 32);
    for (unsigned zeros = 0; zeros < 32; zeros++) {
        const uint32_t least = 0x80000000u >> zeros;
        CHECK_EQUAL(glint_leading_zeros_by_table(least), zeros);
        CHECK_EQUAL(glint_leading_zeros_by_table(2 * (least - 1) + 1), zeros);
        for (int i = 0; i < 1000; i++)
            CHECK_EQUAL(glint_leading_zeros_by_table(least + random_bits() % least), zeros);
    }
}

/* Both forms of a product, of any numbers and of those at the ends of halves. */
static void products(void) {
    static const uint32_t ends[] = {0,       1,          0x7fff,     0x8000,     0xffff,
                                    0x10000, 0x7fffffff, 0x80000000, 0xffff0000, 0xffffffff};
    for (int i = 0; i < 3000000; i++) {
        const uint32_t a = i % 3 ? random_bits() : ends[i / 3 % 10], b = i % 2 ? random_bits() : ends[i / 30 % 10];
        const int64_t exact = (int64_t)(int32_t)a * (int32_t)b;
        CHECK_EQUAL(glint_product_whole((int32_t)a, (int32_t)b), exact);
        CHECK_EQUAL(glint_product_split((int32_t)a, (int32_t)b), exact);
        CHECK_EQUAL(glint_product_high_split((int32_t)a, (int32_t)b), glint_shift_right64(exact, 32));
        CHECK_EQUAL(glint_product_high_unsigned_split(a, b), (uint32_t)((uint64_t)a * b >> 32));
        CHECK(glint_product_unsigned_whole(a, b) == (uint64_t)a * b);
        CHECK(glint_product_unsigned_split(a, b) == (uint64_t)a * b);
    }
}

/* Both forms of a product, where the magnitudes of a row sum up to 3 2^28 and at the ends of what they may be. */
static void products_of_rows(void) {
    for (int i = 0; i < 3000000; i++) {
        int32_t limit = 3 << 28;
        int32_t v[3];
        int64_t sum = 1 << 14;
        glint_row_whole whole;
        glint_row_split split;
        for (int j = 0; j < 3; j++) {
            int32_t entry = i % 7 ? random_signed(1 + random_bits() % 30) : j == i % 3 ? limit : 0;
            entry = entry > limit ? limit : entry < -limit ? -limit : entry;
            limit -= entry < 0 ? -entry : entry;
            v[j] = i % 5 ? random_signed(16) : random_bits() & 1 ? INT16_MIN : INT16_MAX;
            glint_row_set_whole(&whole, j, entry);
            glint_row_set_split(&split, j, entry);
            CHECK_EQUAL(glint_row_get_whole(&whole, j), entry);
            CHECK_EQUAL(glint_row_get_split(&split, j), entry);
            sum += (int64_t)entry * v[j];
        }
        const int32_t t = limit > 0 ? random_signed(32) % limit : 0;
        const int64_t exact = t + (int64_t)floorl((long double)sum / 32768);
        CHECK_EQUAL(glint_row_times_whole(&whole, v[0], v[1], v[2], t), exact);
        CHECK_EQUAL(glint_row_times_split(&split, v[0], v[1], v[2], t), exact);
    }
}

/* Both forms of coordinates over w: those of the guard band's edges, and any between. */
static void coordinates_over_w(void) {
    for (int i = 0; i < 3000000; i++) {
        const int32_t w = (1 << 28) + (int32_t)(random_bits() % (2u << 28));
        const int32_t x = i % 5 ? random_signed(31) % w : i % 2 ? w : -w;
        const uint32_t r = glint_inverse((uint32_t)w);
        const int64_t exact = (int64_t)floorl((long double)(x & ~0xff) / 256 * r / 32768);
        CHECK_EQUAL(glint_scale_whole(x, r), exact);
        CHECK_EQUAL(glint_scale_split(x, r), exact);
    }
}

/* Both forms of slopes over an area, at the ends of their ranges and between. */
static void slopes(void) {
    const int32_t last = 1 << 16;
    for (int i = 0; i < 4000000; i++) {
        const unsigned n = 12 + (unsigned)i % 4;
        const int32_t most = 3 << (n + 13);
        const int32_t x = i % 5 ? random_signed(31) % (most + 1) : i % 2 ? most : -most;
        const int32_t r = i % 3 ? (int32_t)(random_bits() % ((uint32_t)last + 1)) : last;
        const int64_t exact = (int64_t)floorl((long double)x * r / (1 << n));
        CHECK_EQUAL(glint_slope_of_whole(x, r, n), exact);
        CHECK_EQUAL(glint_slope_of_split(x, r, n), exact);
    }
}

/* Both forms of slopes of terms, at the ends of their ranges and between. */
static void slopes_of_terms(void) {
    const int32_t d = 30000, s = 1 << 10, last = (1 << 16) + (1 << 11);
    for (int i = 0; i < 3000000; i++) {
        const int32_t sign = i % 2 ? 1 : -1;
        const int32_t d1 = i % 5 ? random_signed(31) % (d + 1) : sign * d,
                      d2 = i % 5 ? random_signed(31) % (d + 1) : d1;
        const int32_t s1 = i % 5 ? random_signed(11) : s, s2 = i % 5 ? random_signed(11) : s;
        const int32_t r = i % 3 ? (int32_t)(random_bits() % ((uint32_t)last + 1)) : last;
        const int64_t exact = (int64_t)floorl(((long double)d1 * s1 + (long double)d2 * s2) * r / 8192);
        CHECK_EQUAL(glint_term_slope_whole(d1, s1, d2, s2, r), exact);
        CHECK_EQUAL(glint_term_slope_split(d1, s1, d2, s2, r), exact);
    }
}

/* Both forms of sums of two products, at the ends of their ranges and between. */
static void sums_of_products(void) {
    const int32_t most = 32767 << 15, last = 1 << 15;
    for (int i = 0; i < 3000000; i++) {
        const int32_t a = i % 5 ? random_signed(31) % most : i % 2 ? most : -most;
        const int32_t c = i % 7 ? random_signed(31) % most : i % 2 ? most : -most;
        const int32_t b = i % 3 ? random_signed(31) % (last + 1) : i % 2 ? last : -last;
        const int32_t d = i % 11 ? random_signed(31) % (last + 1) : i % 2 ? last : -last;
        const int64_t exact = (int64_t)floorl((long double)((int64_t)a * b + (int64_t)c * d) / 32768);
        CHECK_EQUAL(glint_sum_of_products_whole(a, b, c, d), exact);
        CHECK_EQUAL(glint_sum_of_products_split(a, b, c, d), exact);
    }
}

static glint_pose random_pose(unsigned bits) {
    glint_pose pose;
    for (int i = 0; i < 12; i++)
        pose.m[i / 4][i % 4] = random_signed(bits);
    return pose;
}

/* The thousandth is for the halves that the products may lose before they are added. */
static void poses_one_after_another(void) {
    long double worst = 0;
    for (int i = 0; i < 20000; i++) {
        glint_pose first = random_pose(1 + random_bits() % 32);
        glint_pose second = random_pose(1 + random_bits() % 32);
        glint_pose both = glint_pose_then(&first, &second);
        for (int entry = 0; entry < 12; entry++) {
            int row = entry / 4;
            int column = entry % 4;
            long double exact = column == 3 ? second.m[row][3] : 0;
            for (int k = 0; k < 3; k++)
                exact += (long double)second.m[row][k] * first.m[k][column] / 65536;
            exact = fminl(fmaxl(exact, INT32_MIN), INT32_MAX);
            worst = fmaxl(worst, fabsl((long double)both.m[row][column] - exact));
        }
    }
    report("pose then pose", worst, 0.501L);
}

static void rotations_turn_right_handed(void) {
    const glint_pose x = glint_pose_rotate_x(90 * GLINT_ONE);
    const glint_pose y = glint_pose_rotate_y(90 * GLINT_ONE);
    const glint_pose z = glint_pose_rotate_z(90 * GLINT_ONE);
    CHECK_EQUAL(x.m[2][1], GLINT_ONE); /* y goes to z */
    CHECK_EQUAL(x.m[1][2], -GLINT_ONE);
    CHECK_EQUAL(y.m[0][2], GLINT_ONE); /* z goes to x */
    CHECK_EQUAL(y.m[2][0], -GLINT_ONE);
    CHECK_EQUAL(z.m[1][0], GLINT_ONE); /* x goes to y */
    CHECK_EQUAL(z.m[0][1], -GLINT_ONE);
    CHECK_EQUAL(x.m[0][0] + y.m[1][1] + z.m[2][2], 3 * GLINT_ONE);
}

/* Back = eye - at, right = up x back, up = back x right, all of length 1. */
static void look_at_exact(const glint_vector v[3], long double axes[3][3]) {
    const long double back[3] = {(long double)v[0].x - v[1].x, (long double)v[0].y - v[1].y,
                                 (long double)v[0].z - v[1].z};
    const long double up[3] = {v[2].x, v[2].y, v[2].z};
    for (int i = 0; i < 3; i++) {
        axes[2][i] = back[i];
        axes[0][i] = up[(i + 1) % 3] * back[(i + 2) % 3] - up[(i + 2) % 3] * back[(i + 1) % 3];
    }
    for (int axis = 2; axis >= 0; axis -= 2) {
        long double length =
            sqrtl(axes[axis][0] * axes[axis][0] + axes[axis][1] * axes[axis][1] + axes[axis][2] * axes[axis][2]);
        for (int i = 0; i < 3; i++)
            axes[axis][i] /= length;
    }
    for (int i = 0; i < 3; i++)
        axes[1][i] = axes[2][(i + 1) % 3] * axes[0][(i + 2) % 3] - axes[2][(i + 2) % 3] * axes[0][(i + 1) % 3];
}

/*
 * Up stands at least 30 degrees off the view: back and up, rounded, are off by 0.87 steps each, right by
 * (0.87 + 0.87) / sin(30 degrees) and 0.87 for its own rounding, and what is made of right and back by theirs: 5.22.
 */
static void cameras_look_at(void) {
    long double worst = 0;
    for (int i = 0; i < 200000; i++) {
        glint_vector v[3];
        long double axes[3][3];
        for (int k = 0; k < 3; k++)
            v[k] = random_vector(24);
        look_at_exact(v, axes);
        long double up_length =
            sqrtl((long double)v[2].x * v[2].x + (long double)v[2].y * v[2].y + (long double)v[2].z * v[2].z);
        long double along = (axes[2][0] * v[2].x + axes[2][1] * v[2].y + axes[2][2] * v[2].z) / up_length;
        glint_camera camera = {.field_of_view = GLINT_ONE};
        if (!(fabsl(along) < 0.866L) || !CHECK_EQUAL(glint_camera_look_at(&camera, v[0], v[1], v[2]), GLINT_OK))
            continue;
        for (int entry = 0; entry < 9; entry++) {
            int row = entry / 3;
            int column = entry % 3;
            worst = fmaxl(worst, fabsl((long double)camera.pose.m[row][column] - axes[column][row] * 65536));
        }
        CHECK(camera.pose.m[0][3] == v[0].x && camera.pose.m[1][3] == v[0].y && camera.pose.m[2][3] == v[0].z);
    }
    report("look at", worst, 5.22L);
}

/* ---- Transforms: what later stages take for granted of them */

static int64_t magnitude(int64_t x) {
    return x < 0 ? -x : x;
}

static void check_rows(const glint_transform *t) {
    int64_t squares = 0;
    for (int i = 0; i < 3; i++) {
        int64_t sum = magnitude(t->translation[i]);
        for (int j = 0; j < 3; j++) {
            const int64_t normal = glint_row_get(&t->normal[i], j);
            sum += magnitude(glint_row_get(&t->matrix[i], j));
            squares += normal * normal;
        }
        CHECK_AT_MOST(sum, 0x7fffffff / 3 + 2); /* and so below 3 2^28 */
    }
    CHECK_AT_MOST(squares, (int64_t)3 << 56);
}

/* A box that is not clipped: all of it lies in front of the eye and within the guard band. */
static void check_corners(const glint_transform *t) {
    for (int corner = 0; corner < 8; corner++) {
        int32_t step[3], clip[3];
        for (int j = 0; j < 3; j++)
            step[j] = corner >> j & 1 ? INT16_MAX : INT16_MIN;
        for (int i = 0; i < 3; i++)
            clip[i] = glint_row_times(&t->matrix[i], step[0], step[1], step[2], t->translation[i]);
        CHECK(clip[2] >= 1);
        CHECK_AT_MOST(magnitude(clip[0]), clip[2]);
        CHECK_AT_MOST(magnitude(clip[1]), clip[2]);
    }
}

/* The eye, times a weight and 2^-15, and the weight, from the same matrix. */
static void exact_eye(const glint_transform *t, long double eye[3], long double *weight) {
    long double determinant = 0;
    for (int j = 0; j < 3; j++) {
        eye[j] = 0;
        for (int i = 0; i < 3; i++) {
            const glint_row *a = &t->matrix[(i + 1) % 3], *b = &t->matrix[(i + 2) % 3];
            const int k = (j + 1) % 3, l = (j + 2) % 3;
            const long double cofactor = (long double)glint_row_get(a, k) * glint_row_get(b, l) -
                                         (long double)glint_row_get(a, l) * glint_row_get(b, k);
            eye[j] -= cofactor * t->translation[i];
            determinant += i == 0 ? cofactor * glint_row_get(&t->matrix[0], j) : 0;
        }
    }
    *weight = t->mirrored ? -determinant : determinant;
    for (int j = 0; j < 3; j++)
        eye[j] = t->mirrored ? -eye[j] : eye[j];
}

/*
 * A cluster whose height lies near where it begins to face away is not told so before.
 * @return whether it is told to face away, -1 where nothing can tell
 */
static int check_cluster(const glint_transform *t) {
    static const uint16_t triangle[1][3] = {{1, 2, 3}};
    const unsigned down = 24 + random_bits() % 8;
    glint_cluster cluster = {{0, 0, 0}, (uint8_t)(random_bits() >> down), 0, 1, 4, 0};
    const glint_clusters clusters = {&glint_cull_cones, &cluster, 0, 1};
    const glint_mesh mesh = {.triangles = triangle, .vertex_count = 4, .triangle_count = 1, .clusters = &clusters};
    glint_walk walk;
    long double eye[3], weight;
    exact_eye(t, eye, &weight);
    if (weight < 0) /* so flat that rounding turned it inside out */
        return -1;
    long double reach = cluster.spread * sqrtl(eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2]);
    for (int j = 0; j < 3; j++) {
        cluster.axis[j] = (int8_t)(random_bits() >> 24);
        reach += cluster.axis[j] * eye[j];
    }
    const long double limit = weight > 0 ? 128 * reach / weight : 0;
    const int near_limit = (int)(random_bits() % 8) - 4;
    const long double height = floorl(limit) + near_limit + (random_bits() % 2 ? 0 : limit / 16);
    cluster.height = (int16_t)fmaxl(fminl(height, INT16_MAX), INT16_MIN);
    clusters.cull->begin(&walk, &mesh, t);
    const int away = clusters.cull->corners(&walk, &mesh, 0) != triangle[0];
    CHECK(!away || cluster.height * weight >= 128 * reach);
    return away;
}

/* Anything, of which most is out of range, or something in view, near and far, flat and stretched. */
static void random_object(glint_object *object, glint_mesh *mesh, int anything) {
    const unsigned bits = anything ? 1 + random_bits() % 32 : 8 + random_bits() % 16;
    object->pose = random_pose(bits);
    mesh->extent = random_vector(anything ? 1 + random_bits() % 32 : 3 + random_bits() % 10);
    mesh->offset = random_vector(anything ? 1 + random_bits() % 32 : 3 + random_bits() % 10);
    mesh->extent.x &= INT32_MAX, mesh->extent.y &= INT32_MAX, mesh->extent.z &= random_bits() % 8 ? INT32_MAX : 0;
    if (anything)
        return;
    for (int i = 0; i < 3; i++)
        object->pose.m[i][3] = random_signed(bits) / 8 - (i == 2) * (1 << (bits - 1));
}

static void transforms_keep_their_ranges(void) {
    glint_mesh mesh = {0};
    glint_object object = {.mesh = &mesh};
    glint_scene scene = {.objects = &object, .object_count = 1};
    int done = 0, whole = 0, away = 0, seen = 0;
    for (int i = 0; i < 1000000; i++) {
        glint_view view;
        glint_transform t;
        glint_config config = {.width = (uint16_t)(1 + random_bits() % GLINT_SIZE_MAX)};
        config.height = (uint16_t)(1 + random_bits() % GLINT_SIZE_MAX);
        const glint_vector eye = random_vector(16), at = {0, 0, -16 * GLINT_ONE}, up = {0, 1, 0};
        random_object(&object, &mesh, i % 4 == 0);
        if (glint_camera_look_at(&scene.camera, eye, at, up) != GLINT_OK)
            continue;
        scene.camera.field_of_view = GLINT_ONE + (int32_t)(random_bits() % (169 * GLINT_ONE + 1));
        const uint32_t nearest = random_bits();
        scene.camera.near_plane = 1 + (int32_t)(nearest >> (1 + random_bits() % 31));
        if (glint_prepare_view(&view, &config, &scene, &t, 1) != GLINT_OK)
            continue;
        CHECK_EQUAL(glint_transform_prepare(&t, &view, &config, &object), GLINT_OK);
        CHECK(view.focal >= 1 << 8 && view.focal <= 1 << 29 && view.nearest <= (int64_t)1 << 57);
        CHECK(t.exponent >= 1 && t.exponent <= 92 && t.nearest >= 0 && t.near_plane >= 16);
        check_rows(&t);
        const int faces_away = check_cluster(&t);
        away += faces_away == 1;
        seen += faces_away == 0;
        done++;
        if (!t.visible || t.clips)
            continue;
        check_corners(&t);
        whole++;
    }
    CHECK(done > 500000);
    CHECK(away > 50000 && seen > 500000);
    CHECK(whole > 30000);
}

/* IEC 61966-2-1, rounded to nearest. */
static void srgb_table(void) {
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < GLINT_GAMMA_ENTRIES; i++) {
            const long double x = i / 256.0L;
            const long double wanted = x <= 0.0031308L ? 12.92L * x : 1.055L * powl(x, 1 / 2.4L) - 0.055L;
            CHECK(fabsl(glint_gamma_srgb[c][i] - 65535 * wanted) <= 0.5L);
        }
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(sine_of_quarter_turns_is_exact),
        TEST_CASE(sine_stays_within_one),
        TEST_CASE(powers_of_0_and_1),
        TEST_CASE(srgb_table),
        TEST_CASE(unit_vectors),
        TEST_CASE(unit_vectors_of_extremes),
        TEST_CASE(leading_zeros_by_table),
        TEST_CASE(products),
        TEST_CASE(products_of_rows),
        TEST_CASE(coordinates_over_w),
        TEST_CASE(slopes),
        TEST_CASE(slopes_of_terms),
        TEST_CASE(sums_of_products),
        TEST_CASE(poses_one_after_another),
        TEST_CASE(rotations_turn_right_handed),
        TEST_CASE(cameras_look_at),
        TEST_CASE(transforms_keep_their_ranges),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
