/* SPDX-License-Identifier: MIT */
/* Suite: what makes a scene readable: literals, lights, a camera, all through glint.h. */
#include "glint.h"
#include "harness.h"

#include <math.h>
#include <string.h>

#define SIZE 33
#define MIDDLE (SIZE / 2)

/* A white wall at z = 0, wider than what the camera sees. */
static const int16_t corners[3][3] = {{-32767, -32767, 0}, {32767, -32767, 0}, {0, 32767, 0}},
                     normals[3][3] = {{0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}};
static const uint16_t triangle[1][3] = {{0, 1, 2}};
static const glint_mesh wall = {.positions = corners,
                                .normals = normals,
                                .triangles = triangle,
                                .vertex_count = 3,
                                .triangle_count = 1,
                                .extent = {16 * GLINT_ONE, 16 * GLINT_ONE, 16 * GLINT_ONE}};
static const glint_colour white = GLINT_COLOUR(1, 1, 1);
static const glint_material white_paint = {.model = &glint_model_lambert, .diffuse = GLINT_COLOUR(1, 1, 1)};

static uint16_t shown[SIZE][SIZE];

static int take(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context;
    for (int row = 0; row < height; row++)
        memcpy(&shown[y + row][x], (const uint8_t *)pixels + (size_t)row * stride, 2 * (size_t)width);
    return 0;
}

/* Draws the wall as the default camera sees it by one light. */
static glint_status draw(const glint_light *light) {
    static uint32_t arena[8192];
    const glint_config config = {.width = SIZE,
                                 .height = SIZE,
                                 .format = &glint_format_rgb565,
                                 .flush = {.begin = take},
                                 .arena = arena,
                                 .arena_size = sizeof arena};
    const glint_object object = {
        .mesh = &wall, .material = &white_paint, .evaluation = &glint_per_fragment, .pose = glint_pose_identity()};
    const glint_scene scene = {
        .camera = glint_camera_default(), .lights = light, .light_count = 1, .objects = &object, .object_count = 1};
    glint_renderer renderer;
    memset(shown, 0xff, sizeof shown);
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    return glint_render(&renderer, &scene);
}

static int green(int x, int y) {
    return shown[y][x] >> 5 & 63;
}

/* ---- Literals ---- */

static void literals_are_rounded(void) {
    static const glint_vector v = GLINT_VECTOR(-1, 0.5, 3.00001);
    CHECK(v.x == -GLINT_ONE && v.y == GLINT_ONE / 2 && v.z == 3 * GLINT_ONE + 1);
    static const glint_light light = {.type = &glint_light_directional, .diffuse = GLINT_COLOUR(1, 0.25, 16)};
    CHECK(light.diffuse.r == GLINT_ONE && light.diffuse.g == GLINT_ONE / 4 && light.diffuse.b == GLINT_COLOUR_MAX);
    const glint_vector sums = GLINT_VECTOR(3 + 4, -(1 + 2), 1 - 2);
    CHECK(sums.x == 7 * GLINT_ONE && sums.y == -3 * GLINT_ONE && sums.z == -GLINT_ONE);
}

/* ---- Lights ---- */

static void suns_shine_in_their_direction(void) {
    glint_light sun = glint_sun((glint_vector)GLINT_VECTOR(0, 0, -7), (glint_colour)GLINT_COLOUR(1, 0.5, 0));
    CHECK(sun.type == &glint_light_directional && sun.linear == 0 && sun.quadratic == 0);
    CHECK_EQUAL(draw(&sun), GLINT_OK);
    CHECK_EQUAL(shown[MIDDLE][MIDDLE], 31 << 11 | 32 << 5);
    CHECK_EQUAL(sun.specular.g, GLINT_ONE / 2);
    sun = glint_sun((glint_vector){0, 0, INT32_MIN}, white);
    CHECK_EQUAL(draw(&sun), GLINT_OK);
    CHECK_EQUAL(shown[MIDDLE][MIDDLE], 0xffff);
    sun = glint_sun((glint_vector)GLINT_VECTOR(0, 0, 1), white);
    CHECK_EQUAL(draw(&sun), GLINT_OK);
    CHECK_EQUAL(shown[MIDDLE][MIDDLE], 0);
    sun = glint_sun((glint_vector)GLINT_VECTOR(0, 0, 0), white);
    CHECK_EQUAL(draw(&sun), GLINT_ERROR_DIRECTION);
}

/* What is left of a lamp's light at a distance. */
static double left_at(const glint_light *lamp, double distance) {
    return 1 / (1 + lamp->linear / 65536.0 * distance + lamp->quadratic / 65536.0 * distance * distance);
}

/* Every range from the least to the largest number, each 0.1 % above the one before it. */
static void lamps_fade_to_half_a_step_at_their_range(void) {
    double worst = 0, worst_form = 0;
    for (int64_t range = 4096; range <= INT32_MAX; range += range / 1000 + 1) {
        const double units = (double)range / 65536;
        const glint_light lamp = glint_lamp((glint_vector)GLINT_VECTOR(0, 0, 0), white, (glint_q16)range);
        worst = fmax(worst, fabs(left_at(&lamp, units) * 126 - 1));
        if (units <= 250)
            worst_form = fmax(worst_form, fabs(left_at(&lamp, units / 5) * 6 - 1));
        CHECK(lamp.linear >= 0 && lamp.quadratic >= 0);
    }
    CHECK(worst < 1.0 / 400);
    CHECK(worst_form < 0.04);
}

/* Half a step is not stored where light is a little less, and is where it is a little more. */
static void nothing_shows_beyond_a_range(void) {
    static const int ranges[] = {1, 3, 20, 300, 2900, 20000};
    for (unsigned i = 0; i < TEST_COUNT(ranges); i++) {
        const glint_q16 range = ranges[i] * GLINT_ONE, hundredth = range / 100;
        glint_light lamp = glint_lamp((glint_vector){0, 0, range - hundredth}, white, range);
        CHECK_EQUAL(draw(&lamp), GLINT_OK);
        CHECK_EQUAL(green(MIDDLE, MIDDLE), 1);
        lamp.position.z = range + hundredth;
        CHECK_EQUAL(draw(&lamp), GLINT_OK);
        CHECK_EQUAL(shown[MIDDLE][MIDDLE], 0);
        lamp.position.z = range / 5;
        CHECK_EQUAL(draw(&lamp), GLINT_OK);
        CHECK_AT_MOST(green(MIDDLE, MIDDLE), 11); /* 63 / 6, of far ranges 63 / 26 */
        CHECK_AT_MOST(ranges[i] <= 300 ? 10 : 2, green(MIDDLE, MIDDLE));
    }
}

static void ranges_too_short_are_refused(void) {
    static const glint_q16 ranges[] = {INT32_MIN, -GLINT_ONE, 0, 1, 4095};
    for (unsigned i = 0; i < TEST_COUNT(ranges); i++) {
        glint_light light = glint_lamp((glint_vector)GLINT_VECTOR(0, 0, 1), white, ranges[i]);
        CHECK_EQUAL(draw(&light), GLINT_ERROR_ATTENUATION);
        light = glint_spot((glint_vector)GLINT_VECTOR(0, 0, 1), (glint_vector)GLINT_VECTOR(0, 0, 0), white, ranges[i],
                           GLINT_ONE);
        CHECK_EQUAL(draw(&light), GLINT_ERROR_ATTENUATION);
    }
}

/* The wall's middle is lit, what lies beyond the angle is not, what lies between is in part. */
static void spots_point_at_their_place(void) {
    const glint_vector eye = GLINT_VECTOR(0, 0, 2), middle = GLINT_VECTOR(0, 0, 0);
    const glint_colour bright = GLINT_COLOUR(4, 4, 4);
    glint_light spot = glint_spot(eye, middle, bright, 20 * GLINT_ONE, 30 * GLINT_ONE);
    CHECK(spot.type == &glint_light_spot && spot.inner == 15 * GLINT_ONE && spot.outer == 30 * GLINT_ONE);
    CHECK_EQUAL(draw(&spot), GLINT_OK);
    CHECK_EQUAL(green(MIDDLE, MIDDLE), 63);
    CHECK_EQUAL(green(MIDDLE + 14, MIDDLE), 0);    /* 1.40 from the middle, 35 degrees */
    CHECK_AT_MOST(green(MIDDLE + 10, MIDDLE), 62); /* 1.00, 27 degrees */
    CHECK_AT_MOST(1, green(MIDDLE + 10, MIDDLE));
    spot = glint_spot(eye, (glint_vector)GLINT_VECTOR(1.4, 0, 0), bright, 20 * GLINT_ONE, 30 * GLINT_ONE);
    CHECK_EQUAL(draw(&spot), GLINT_OK);
    CHECK_EQUAL(green(MIDDLE, MIDDLE), 0);
    CHECK_EQUAL(green(MIDDLE + 14, MIDDLE), 63);
    spot = glint_spot(eye, eye, bright, GLINT_ONE, GLINT_ONE);
    CHECK_EQUAL(draw(&spot), GLINT_ERROR_DIRECTION);
    spot = glint_spot(eye, middle, bright, GLINT_ONE, 180 * GLINT_ONE + 1);
    CHECK_EQUAL(draw(&spot), GLINT_ERROR_CONE);
    spot = glint_spot(eye, middle, bright, GLINT_ONE, -1);
    CHECK_EQUAL(draw(&spot), GLINT_ERROR_CONE);
}

/* A place as far from the light as numbers go keeps its direction. */
static void spots_point_far_away(void) {
    const glint_vector least = {INT32_MIN, INT32_MIN, INT32_MIN}, most = {INT32_MAX, INT32_MAX, INT32_MAX};
    const glint_light spot = glint_spot(least, most, white, GLINT_ONE, GLINT_ONE);
    CHECK(spot.direction.x > 1 << 28 && spot.direction.x == spot.direction.y && spot.direction.x == spot.direction.z);
    const glint_light near = glint_spot((glint_vector){5, 5, 5}, (glint_vector){5, 4, 5}, white, GLINT_ONE, GLINT_ONE);
    CHECK(near.direction.x == 0 && near.direction.y == -1 && near.direction.z == 0);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(literals_are_rounded),
        TEST_CASE(suns_shine_in_their_direction),
        TEST_CASE(lamps_fade_to_half_a_step_at_their_range),
        TEST_CASE(nothing_shows_beyond_a_range),
        TEST_CASE(ranges_too_short_are_refused),
        TEST_CASE(spots_point_at_their_place),
        TEST_CASE(spots_point_far_away),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
