/* SPDX-License-Identifier: MIT */
/* Suite: turns, and where points show, against double precision. */
#include "glint_extras.h"
#include "harness.h"
#include "reference.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static uint32_t seed = 1;

static double any(double least, double most) {
    seed = seed * 1664525u + 1013904223u;
    return least + (most - least) * (seed >> 8) / 16777216.0;
}

static glint_q16 any_q16(double least, double most) {
    return (glint_q16)floor(any(least, most) * 65536 + 0.5);
}

#define PI 3.14159265358979323846

/* ---- Turns ---- */

/* The largest difference from a matrix, in steps of Q16.16. */
static double apart(const glint_pose *pose, double m[3][3]) {
    double most = 0;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            most = fmax(most, fabs(pose->m[i][j] - m[i][j] * 65536));
        most = fmax(most, abs(pose->m[i][3]));
    }
    return most;
}

/* The turn of a unit quaternion. */
static void turn_of(const double q[4], double m[3][3]) {
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double r[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                            {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                            {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    for (int i = 0; i < 9; i++)
        m[i / 3][i % 3] = r[i / 3][i % 3];
}

static const double spans[] = {1.0 / 65536, 1.0 / 256, 1, 100, 32767};

static void turns_about_an_axis(void) {
    double worst = 0, m[3][3];
    for (int i = 0; i < 100000; i++) {
        const double span = spans[i % 5], degrees = any(-720, 720);
        const glint_vector axis = {any_q16(-span, span), any_q16(-span, span), any_q16(-span, span)};
        const glint_q16 turn = (glint_q16)floor(degrees * 65536);
        const double x = axis.x, y = axis.y, z = axis.z, length = sqrt(x * x + y * y + z * z);
        const double half = turn / 65536.0 * PI / 360, s = length > 0 ? sin(half) / length : 0;
        const double q[4] = {x * s, y * s, z * s, length > 0 ? cos(half) : 1};
        turn_of(q, m);
        const glint_pose pose = glint_pose_rotate(axis, turn);
        worst = fmax(worst, apart(&pose, m));
    }
    char line[80];
    snprintf(line, sizeof line, "  about an axis: %.2f steps of Q16.16 at most\n", worst);
    test_write(line);
    CHECK(worst <= 0.6);
    const glint_pose about_y = glint_pose_rotate((glint_vector){0, 5 * GLINT_ONE, 0}, 33 * GLINT_ONE),
                     same = glint_pose_rotate_y(33 * GLINT_ONE);
    for (int i = 0; i < 12; i++)
        CHECK(abs(about_y.m[i / 4][i % 4] - same.m[i / 4][i % 4]) <= 1);
}

static void turns_of_quaternions(void) {
    double worst = 0, m[3][3];
    for (int i = 0; i < 100000; i++) {
        const double span = spans[i % 5];
        glint_q16 in[4];
        double q[4], length = 0;
        for (int c = 0; c < 4; c++) {
            in[c] = i % 7 == c ? INT32_MIN : any_q16(-span, span);
            length += (double)in[c] * in[c];
        }
        for (int c = 0; c < 4; c++)
            q[c] = length > 0 ? in[c] / sqrt(length) : c == 3;
        turn_of(q, m);
        const glint_pose pose = glint_pose_quaternion(in[0], in[1], in[2], in[3]);
        worst = fmax(worst, apart(&pose, m));
    }
    char line[80];
    snprintf(line, sizeof line, "  of quaternions: %.2f steps of Q16.16 at most\n", worst);
    test_write(line);
    CHECK(worst <= 0.51);
}

/* ---- Poses that add up ---- */

/* How far a pose's axes, and its rows, are from unit and perpendicular. */
static double bent(const glint_pose *pose) {
    double worst = 0;
    for (int i = 0; i < 3; i++)
        for (int j = i; j < 3; j++) {
            double columns = 0, rows = 0;
            for (int k = 0; k < 3; k++) {
                columns += pose->m[k][i] / 65536.0 * (pose->m[k][j] / 65536.0);
                rows += pose->m[i][k] / 65536.0 * (pose->m[j][k] / 65536.0);
            }
            if (i == j) /* lengths */
                columns = sqrt(columns), rows = sqrt(rows);
            worst = fmax(worst, fmax(fabs(columns - (i == j)), fabs(rows - (i == j))));
        }
    return worst;
}

static int is_camera(const glint_pose *pose) {
    const glint_config config = {.width = 160, .height = 120};
    const glint_camera camera = {*pose, 45 * GLINT_ONE, GLINT_ONE / 10};
    glint_screen_point place;
    return glint_camera_project(&config, &camera, (glint_vector){0, 0, 0}, &place) >= 0;
}

/* The i-th of many axes, none of which is a coordinate axis. */
static glint_vector axis_of(int i) {
    return (glint_vector){(i * 7919 % 2001 - 1000) * 64 + 1, (i * 1543 % 2003 - 1001) * 64, i % 17 * 4096 - 32767};
}

/* 36,000 turns, in the world or about the pose's own axes, from a rotation or its mirror image. */
static double turn_on(const glint_pose *start, const glint_pose *step, int in_world) {
    glint_pose pose = *start;
    double worst = 0;
    for (int i = 1; i <= 36000; i++) {
        pose = in_world ? glint_pose_then(&pose, step) : glint_pose_then(step, &pose);
        worst = fmax(worst, bent(&pose));
    }
    CHECK(is_camera(&pose));
    return worst;
}

static void rotations_stay_rotations(void) {
    static const double degrees[] = {0.001, 0.25, 0.5, 1, 3, 7, 45, 90, 120, 359.9};
    const glint_pose identity = glint_pose_identity(), mirror = glint_pose_scale(-GLINT_ONE, GLINT_ONE, GLINT_ONE);
    double worst = 0;
    for (int i = 0; i < 20; i++) {
        const glint_q16 angle = (glint_q16)(degrees[i % 10] * 65536);
        const glint_pose about_any = glint_pose_rotate(axis_of(i), angle), about_y = glint_pose_rotate_y(angle),
                         *step = i < 10 ? &about_y : &about_any;
        worst = fmax(worst, turn_on(&identity, step, 1));
        worst = fmax(worst, turn_on(&mirror, step, 0));
    }
    char line[80];
    snprintf(line, sizeof line, "  36,000 turns: %.2f steps of Q16.16 at most\n", worst * 65536);
    test_write(line);
    CHECK(worst <= 1.0 / 16384);
}

/* Each of 36,000 times another axis and angle. */
static void any_turns_stay_rotations(void) {
    glint_pose pose = glint_pose_identity();
    double worst = 0;
    for (int i = 0; i < 36000; i++) {
        const glint_pose turn = glint_pose_rotate(axis_of(i), i % 720 * GLINT_ONE + i);
        pose = i % 2 ? glint_pose_then(&pose, &turn) : glint_pose_then(&turn, &pose);
        worst = fmax(worst, bent(&pose));
    }
    CHECK(worst <= 1.0 / 16384);
    CHECK(is_camera(&pose));
}

/* Scales are the user's, however close to 1; turned, they are off by rounding alone. */
static void scales_are_kept(void) {
    const glint_pose step = glint_pose_scale(GLINT_ONE + 4, GLINT_ONE, GLINT_ONE - 4);
    glint_pose pose = glint_pose_identity();
    for (int i = 0; i < 10000; i++)
        pose = glint_pose_then(&pose, &step);
    CHECK(fabs(pose.m[0][0] / 65536.0 - pow(65540 / 65536.0, 10000)) < 0.1);
    CHECK(pose.m[1][1] == GLINT_ONE);
    CHECK(pose.m[2][2] < GLINT_Q16(0.6));

    const glint_pose turn = glint_pose_rotate((glint_vector){GLINT_ONE, GLINT_ONE, GLINT_ONE}, 3 * GLINT_ONE);
    pose = glint_pose_scale(GLINT_ONE / 2, GLINT_ONE, 2 * GLINT_ONE);
    for (int i = 0; i < 36000; i++)
        pose = glint_pose_then(&pose, &turn);
    for (int j = 0; j < 3; j++) {
        double square = 0;
        for (int i = 0; i < 3; i++)
            square += pow(pose.m[i][j] / 65536.0, 2);
        CHECK(fabs(sqrt(square) * 2 / (1 << j) - 1) < 0.002);
    }
}

/* ---- Places ---- */

static void look_from_somewhere(glint_camera *camera) {
    const glint_vector at = {any_q16(-9, 9), any_q16(-9, 9), any_q16(-9, 9)};
    glint_camera_orbit(camera, at, any_q16(-400, 400), any_q16(-200, 200), any_q16(0.5, 20));
    camera->field_of_view = any_q16(1, 170);
    camera->near_plane = any_q16(0.001, 2);
}

/* A mesh of one vertex, for the reference to bring to the screen. */
static reference_vertex show(const glint_camera *camera, glint_vector point, int width, int height) {
    static const int16_t origin[1][3] = {{0, 0, 0}}, up[1][3] = {{0, 0, 32767}};
    static const uint16_t corners[1][3] = {{0, 0, 0}};
    const glint_mesh mesh = {.positions = origin,
                             .normals = up,
                             .triangles = corners,
                             .vertex_count = 1,
                             .triangle_count = 1,
                             .extent = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    const glint_object object = {.mesh = &mesh, .pose = glint_pose_translate(point.x, point.y, point.z)};
    const glint_scene scene = {.camera = *camera, .objects = &object, .object_count = 1};
    return reference_transform(&scene, 0, 0, width, height);
}

static void places_of_points(void) {
    double worst = 0, worst_distance = 0;
    uint32_t shown = 0, wrong = 0;
    for (int i = 0; i < 200000; i++) {
        glint_camera camera = {0};
        look_from_somewhere(&camera);
        const glint_config config = {.width = (uint16_t)any(1, 1024.9), .height = (uint16_t)any(1, 1024.9)};
        const double reach = i % 3 ? 10 : 3000;
        const glint_vector point = {any_q16(-reach, reach), any_q16(-reach, reach), any_q16(-reach, reach)};
        const reference_vertex wanted = show(&camera, point, config.width, config.height);
        glint_screen_point place = {1, 2, 3};
        const int found = glint_camera_project(&config, &camera, point, &place);
        const double distance = -wanted.place[2], from_near = distance - camera.near_plane / 65536.0;
        wrong += fabs(from_near) > 0.001 && found != (from_near > 0);
        if (!found) {
            wrong += place.x != 1 || place.y != 2 || place.distance != 3;
            continue;
        }
        worst_distance = fmax(worst_distance, fabs(place.distance / 65536.0 - distance));
        if (wanted.x < -64 || wanted.y < -64 || wanted.x > config.width + 64 || wanted.y > config.height + 64)
            continue;
        shown++;
        worst = fmax(worst, fmax(fabs(place.x / 65536.0 - wanted.x), fabs(place.y / 65536.0 - wanted.y)));
    }
    char line[120];
    snprintf(line, sizeof line, "  %u points: %.5f of a pixel, and a distance of %.6f, at most\n", (unsigned)shown,
             worst, worst_distance);
    test_write(line);
    CHECK_EQUAL(wrong, 0);
    CHECK(shown > 10000);
    CHECK(worst <= 1.0 / 128);
    CHECK(worst_distance <= 0.0001);
}

static void far_aside_is_saturated(void) {
    const glint_config config = {.width = 320, .height = 240};
    const glint_camera camera = {glint_pose_identity(), 60 * GLINT_ONE, 1};
    glint_screen_point place;
    CHECK_EQUAL(glint_camera_project(&config, &camera, (glint_vector){INT32_MAX, INT32_MIN, -1}, &place), 1);
    CHECK_EQUAL(place.x, INT32_MAX);
    CHECK_EQUAL(place.y, INT32_MAX);
    CHECK_EQUAL(place.distance, 1);
    CHECK_EQUAL(glint_camera_project(&config, &camera, (glint_vector){INT32_MIN, INT32_MAX, INT32_MIN}, &place), 1);
    CHECK_EQUAL(place.distance, INT32_MAX);
    CHECK_EQUAL(glint_camera_project(&config, &camera, (glint_vector){0, 0, 0}, &place), 0);
    CHECK_EQUAL(glint_camera_project(NULL, &camera, (glint_vector){0, 0, 0}, &place), GLINT_ERROR_NULL);
    glint_camera bad = camera;
    bad.pose.m[0][0] = INT32_MIN;
    CHECK_EQUAL(glint_camera_project(&config, &bad, (glint_vector){0, 0, 0}, &place), GLINT_ERROR_CAMERA);
    const glint_config none = {0};
    CHECK_EQUAL(glint_camera_project(&none, &camera, (glint_vector){0, 0, 0}, &place), GLINT_ERROR_SIZE);
}

static void orbits(void) {
    static const struct {
        glint_q16 yaw, pitch;
        double from[3];
    } cases[] = {{0, 0, {0, 0, 2}},
                 {90 * GLINT_ONE, 0, {2, 0, 0}},
                 {0, 90 * GLINT_ONE, {0, 2, 0}},
                 {-90 * GLINT_ONE, -90 * GLINT_ONE, {0, -2, 0}}};
    for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++) {
        glint_camera camera = {0};
        const glint_vector at = {3 * GLINT_ONE, -GLINT_ONE, GLINT_ONE / 2};
        const double centre[3] = {3, -1, 0.5};
        glint_camera_orbit(&camera, at, cases[i].yaw, cases[i].pitch, 2 * GLINT_ONE);
        for (int c = 0; c < 3; c++) {
            CHECK(fabs(camera.pose.m[c][3] / 65536.0 - centre[c] - cases[i].from[c]) < 0.0001);
            CHECK(fabs(camera.pose.m[c][2] / 65536.0 - cases[i].from[c] / 2) < 0.0001);
        }
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(turns_about_an_axis),      TEST_CASE(turns_of_quaternions),
        TEST_CASE(rotations_stay_rotations), TEST_CASE(any_turns_stay_rotations),
        TEST_CASE(scales_are_kept),          TEST_CASE(places_of_points),
        TEST_CASE(far_aside_is_saturated),   TEST_CASE(orbits),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
