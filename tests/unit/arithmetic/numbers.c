/* SPDX-License-Identifier: MIT */
/*
 * Suite: the library's arithmetic of several arguments against libm in long double, at the largest errors its contracts
 * state; domains.c has the functions of one.
 */
#include "glint.h"
#include "harness.h"
#include "math/division.h"
#include "math/product.h"

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

/* Both forms of a rotation's row times coordinates, at the ends of their range and between. */
static void turned_coordinates(void) {
    const int32_t most = (1 << 28) - 1;
    for (int i = 0; i < 300000; i++) {
        const glint_pose x = glint_pose_rotate_x(random_signed(26)), y = glint_pose_rotate_y(random_signed(26)),
                         z = glint_pose_rotate_z(random_signed(26)), xy = glint_pose_then(&x, &y),
                         turn = glint_pose_then(&xy, &z);
        const int32_t *const r = turn.m[i % 3];
        int64_t exact = 0;
        int32_t v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = i % 3 ? random_signed(31) % (most + 1) : random_bits() % 2 ? most : -most;
            exact += (int64_t)r[k] * v[k];
        }
        exact = (int64_t)floorl((long double)exact / 65536);
        CHECK_EQUAL(glint_turn_whole(r, v[0], v[1], v[2]), exact);
        CHECK_EQUAL(glint_turn_split(r, v[0], v[1], v[2]), exact);
    }
}

/* The thousandth is for the halves that the products may lose before they are added. The first poses have the most
 * negative numbers alone, whose products are the largest of all. */
static void poses_one_after_another(void) {
    long double worst = 0;
    for (int i = 0; i < 20000; i++) {
        glint_pose first = random_pose(1 + random_bits() % 32);
        glint_pose second = random_pose(1 + random_bits() % 32);
        for (int entry = 0; entry < 12 && i == 0; entry++)
            first.m[entry / 4][entry % 4] = second.m[entry / 4][entry % 4] = INT32_MIN;
        glint_pose both = glint_pose_then(&first, &second);
        const glint_vector there =
            glint_pose_apply(&second, (glint_vector){first.m[0][3], first.m[1][3], first.m[2][3]});
        CHECK(there.x == both.m[0][3] && there.y == both.m[1][3] && there.z == both.m[2][3]);
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

static void reciprocals_of_16_bits(void) {
    int wrong = 0;
    for (uint32_t x = 1u << 15; x <= 1u << 16; x++) {
        const int64_t nearest = (int64_t)floorl(2147483648.0L / x + 0.5L);
        wrong += glint_reciprocal16_by_division(x) != nearest;
        wrong += glint_reciprocal16_by_table(x) != nearest;
    }
    CHECK_EQUAL(wrong, 0);
}

/* Largest error of the crossings of an edge, in steps times 16 dy: at its first row and its last, for all positions. */
static int64_t worst_crossing(int32_t slope, int32_t dx, int32_t dy) {
    int64_t worst = 0;
    for (int32_t first = 0; first < 16; first++) {
        const int32_t last = first + (dy - 1 - first) / 16 * 16;
        for (int32_t down = first; down<dy; down += last> first ? last - first : 16) {
            const int64_t found = (int64_t)glint_edge_start(slope, first) + (int64_t)slope * ((down - first) / 16);
            int64_t error = found * 16 * dy - (int64_t)down * dx * (1 << 20);
            error = error < 0 ? -error : error;
            worst = error > worst ? error : worst;
        }
    }
    return worst;
}

static void check_edges(const char *name, int32_t (*slope)(int32_t, int32_t), int32_t end) {
    double worst = 0;
    for (int32_t dy = 1; dy < end; dy++) {
        for (int32_t dx = 1 - GLINT_EDGE_DX; dx < GLINT_EDGE_DX; dx++)
            worst = fmax(worst, (double)worst_crossing(slope(dx, dy), dx, dy) / (16 * dy));
    }
    test_write("  ");
    test_write(name);
    test_write(": ");
    test_write_number((int64_t)(worst * 1000 / GLINT_EDGE_ERROR));
    test_write(" thousandths of the error allowed\n");
    CHECK(worst < GLINT_EDGE_ERROR);
    CHECK((1 << 20) / (16 * (end - 1)) >= 2 * GLINT_EDGE_ERROR); /* exact crossings lie so far apart */
}

static void crossings_of_all_short_edges(void) {
    check_edges("edges by division", glint_slope_by_division, 512);
    check_edges("edges by table", glint_slope_by_table, 512);
    CHECK(GLINT_EDGE_DY <= 512);
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
        TEST_CASE(reciprocals_of_16_bits),
        TEST_CASE(crossings_of_all_short_edges),
        TEST_CASE(sums_of_products),
        TEST_CASE(turned_coordinates),
        TEST_CASE(poses_one_after_another),
        TEST_CASE(rotations_turn_right_handed),
        TEST_CASE(cameras_look_at),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
