/* SPDX-License-Identifier: MIT */
/*
 * Suite: the ends of what a scene may say. Lights as far off as numbers reach, the least and the largest field of view,
 * exponents from 0 to 32768, more triangles than a pass holds, and places next to the eye.
 */
#include "bench.h"
#include "glint_extras.h"
#include "harness.h"
#include "judge.h"
#include "picture.h"
#include "rows.h"
#include "scenes.h"
#include "single.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH 160
#define HEIGHT 120

static glint_colour grey(double value) {
    return (glint_colour){bench_q16(value), bench_q16(value), bench_q16(value)};
}

/* A torus that fills most of the screen, in white light. */
static void build(test_scene *scene) {
    scene_build_named(scene, "mirrored");
    scene->objects[0].mesh = &scene_bench_mesh(1)->mesh;
    scene->objects[0].pose = bench_turn(-0.8, 0.6);
    scene->objects[0].pose.m[2][3] = bench_q16(-3.7);
    scene->materials[0].ambient = grey(0.1);
    scene->materials[0].diffuse = grey(0.5);
    scene->materials[0].specular = grey(0.4);
    scene->materials[0].shininess = 32 * GLINT_ONE;
    scene->scene.ambient = grey(1);
    scene->scene.light_count = 1;
    scene->lights[0] = (glint_light){.type = &glint_light_directional,
                                     .vector = {bench_q16(0.4), bench_q16(0.6), bench_q16(0.7)},
                                     .diffuse = grey(1),
                                     .specular = grey(1)};
}

static void judge_viewers(const char *name, test_scene *scene) {
    judgement total = {0};
    for (int viewer = 0; viewer < 2; viewer++) {
        scene->scene.viewer = (glint_viewer)viewer;
        row_judge(&scene->scene, WIDTH, HEIGHT, &glint_format_rgb565, &total);
    }
    row_print(name, &total);
    row_check(&total, row_is_per_fragment(&scene->scene));
}

/* ---- Lights -------------------------------------------------------------------------------------------------- */

/* Points and spots at the ends of the range, each in every evaluation. */
static void lights_far_off(void) {
    static const glint_vector places[] = {{INT32_MAX, INT32_MAX, INT32_MAX},
                                          {INT32_MIN, INT32_MAX, INT32_MAX},
                                          {0, INT32_MIN, INT32_MAX},
                                          {INT32_MAX, 0, 0},
                                          {GLINT_ONE, 2 * GLINT_ONE, INT32_MAX}};
    const glint_evaluation *const evaluations[3] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    row_print_heading();
    for (unsigned i = 0; i < 6 * TEST_COUNT(places); i++) {
        const glint_vector *place = &places[i / 6];
        test_scene scene;
        char name[80];
        build(&scene);
        scene.objects[0].evaluation = evaluations[i % 3];
        scene.lights[0].type = i / 3 % 2 ? &glint_light_spot : &glint_light_point;
        scene.lights[0].vector = *place;
        scene.lights[0].axis = (glint_vector){-(place->x / 2), -(place->y / 2), -(place->z / 2)};
        scene.lights[0].inner = 10 * GLINT_ONE;
        scene.lights[0].outer = 20 * GLINT_ONE;
        snprintf(name, sizeof name, "%s far off, place %u, evaluation %u", i / 3 % 2 ? "spot" : "point", i / 6, i % 3);
        judge_viewers(name, &scene);
    }
}

/* With attenuation so small that it shows over such a distance alone. */
static void light_far_off_fades(void) {
    test_scene scene;
    row_print_heading();
    build(&scene);
    scene.lights[0].type = &glint_light_point;
    scene.lights[0].vector = (glint_vector){0, 0, INT32_MAX};
    scene.lights[0].linear = 1; /* 1 / (1 + 1/2) */
    judge_viewers("point far off, a third less", &scene);
    scene.lights[0].quadratic = 1; /* 1 / (1 + 1/2 + 2^14) */
    judge_viewers("point far off, gone", &scene);
    scene.lights[0].linear = scene.lights[0].quadratic = INT32_MAX;
    judge_viewers("point far off, attenuated as far as can be", &scene);
}

/* ---- Camera -------------------------------------------------------------------------------------------------- */

static void fields_of_view(void) {
    static const struct {
        glint_q16 degrees;
        double distance;
    } views[] = {{GLINT_ONE, 200}, {GLINT_ONE, 170}, {170 * GLINT_ONE, 1.5}, {170 * GLINT_ONE, 3}};
    const glint_light_type *const types[2] = {&glint_light_directional, &glint_light_point};
    row_print_heading();
    for (unsigned i = 0; i < 2 * TEST_COUNT(views); i++) {
        test_scene scene;
        char name[80];
        build(&scene);
        scene.scene.camera.field_of_view = views[i / 2].degrees;
        scene.objects[0].pose.m[2][3] = bench_q16(-views[i / 2].distance);
        scene.lights[0].type = types[i % 2];
        scene.lights[0].vector = (glint_vector){2 * GLINT_ONE, 3 * GLINT_ONE, bench_q16(4 - views[i / 2].distance)};
        if (i % 2 == 0)
            scene.lights[0].vector.z = 4 * GLINT_ONE;
        snprintf(name, sizeof name, "%d degrees, at %g, %s", views[i / 2].degrees / GLINT_ONE, views[i / 2].distance,
                 i % 2 ? "point" : "directional");
        judge_viewers(name, &scene);
    }
}

/* ---- Exponents ----------------------------------------------------------------------------------------------- */

static void least_exponents(void) {
    static const glint_q16 exponents[] = {0, 1, 2, 655};
    const glint_model *const models[2] = {&glint_model_blinn_phong, &glint_model_phong};
    const glint_evaluation *const evaluations[2] = {&glint_per_fragment, &glint_per_vertex};
    static const char *const names[2] = {"fragment", "vertex"};
    row_print_heading();
    for (unsigned i = 0; i < 4 * TEST_COUNT(exponents); i++) {
        test_scene scene;
        char name[80];
        build(&scene);
        const glint_q16 exponent = exponents[i / 4];
        scene.materials[0].shininess = exponent;
        scene.materials[0].model = models[i % 2];
        scene.objects[0].evaluation = evaluations[i / 2 % 2];
        snprintf(name, sizeof name, "p = %.6f, %s, per %s", exponent / 65536.0, i % 2 ? "phong" : "blinn-phong",
                 names[i / 2 % 2]);
        judge_viewers(name, &scene);
    }
}

/* A highlight that narrow fills a part of the screen where the field of view is narrow too. */
static void largest_exponents(void) {
    const glint_model *const models[2] = {&glint_model_blinn_phong, &glint_model_phong};
    row_print_heading();
    for (int i = 0; i < 6; i++) {
        test_scene scene;
        char name[80];
        build(&scene);
        scene.objects[0].mesh = &scene_bench_mesh(3)->mesh;
        scene.scene.camera.field_of_view = 2 * GLINT_ONE;
        scene.lights[0].vector = (glint_vector){GLINT_ONE / 100, 0, GLINT_ONE};
        scene.materials[0].model = models[i % 2];
        scene.materials[0].shininess = i / 2 ? INT32_MAX : 16384 * GLINT_ONE;
        if (i / 2 == 2) /* the least that shows, on the smallest place */
            scene.materials[0].specular = grey(9.5 / 4096);
        snprintf(name, sizeof name, "p = %.2f, %s%s", scene.materials[0].shininess / 65536.0,
                 i % 2 ? "phong" : "blinn-phong", i / 2 == 2 ? ", weak" : "");
        judge_viewers(name, &scene);
    }
}

/* ---- Near the eye -------------------------------------------------------------------------------------------- */

/* Draws a scene, and compares it. */
static void check_same_picture(const test_scene *scene, const picture *expected) {
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb888);
    glint_stats stats;
    CHECK_EQUAL(picture_render(&image, &scene->scene, NULL, &stats), GLINT_OK);
    CHECK(picture_equal(&image, expected));
    picture_close(&image);
}

/* A triangle so large that coordinates are rounded to more than the near plane, its middle in the eye: seen edge on, it
 * shows nothing, whatever lights that middle. */
static void triangle_around_the_eye(void) {
    static const int16_t corners[3][3] = {{0, 0, -20000}, {10000, 0, 10000}, {-10000, 0, 10000}},
                         normals[3][3] = {{0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}};
    static const uint16_t triangles[2][1][3] = {{{0, 0, 0}}, {{0, 1, 2}}}; /* the first has no area */
    const glint_q16 extent = 8192 * GLINT_ONE;
    glint_mesh around = {.positions = corners,
                         .normals = normals,
                         .triangles = triangles[0],
                         .vertex_count = 3,
                         .triangle_count = 1,
                         .extent = {extent, extent, extent},
                         .flags = GLINT_MESH_DOUBLE_SIDED};
    test_scene scene;
    glint_stats stats;
    picture without = picture_open(WIDTH, HEIGHT, &glint_format_rgb888);
    build(&scene);
    scene.scene.viewer = GLINT_VIEWER_LOCAL;
    scene.scene.camera.near_plane = 1;
    scene.scene.camera.pose = glint_pose_identity();
    scene.objects[1] = scene.objects[0];
    scene.objects[1].mesh = &around;
    scene.objects[1].evaluation = &glint_per_facet;
    scene.objects[1].pose = glint_pose_identity();
    for (int i = 0; i < 3; i++)
        scene.objects[1].pose.m[i][i] = 4 * GLINT_ONE;
    scene.scene.object_count = 2;
    CHECK_EQUAL(picture_render(&without, &scene.scene, NULL, &stats), GLINT_OK);
    CHECK(stats.references > 0 && stats.clipped == 0);
    around.triangles = triangles[1];
    check_same_picture(&scene, &without);
    picture_close(&without);
}

/* An object whose box begins beyond the near plane by less than places are told apart by: the plane may as well be
 * a step nearer. */
static void box_just_beyond_the_near_plane(void) {
    static const int16_t corners[4][3] = {{-32767, 0, -32767},
                                          {32767, 0, -32767},
                                          {0, 32767, 32767},
                                          {0, -32767, 32767}},
                         normals[4][3] = {{0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}};
    static const uint16_t triangles[2][3] = {{0, 1, 2}, {0, 3, 1}};
    const glint_mesh mesh = {.positions = corners,
                             .normals = normals,
                             .triangles = triangles,
                             .vertex_count = 4,
                             .triangle_count = 2,
                             .extent = {2048, 2048, 1024}};
    test_scene scene;
    picture expected = picture_open(WIDTH, HEIGHT, &glint_format_rgb888);
    glint_stats stats;
    build(&scene);
    scene.objects[0].mesh = &mesh;
    scene.objects[0].pose = glint_pose_translate(2048 + 4, 0, -(8192 + 1024));
    scene.scene.camera.pose = glint_pose_identity();
    scene.scene.camera.pose.m[0][2] = -1; /* so that 1/65536 of x adds to the distance */
    scene.scene.camera.near_plane = 8192 - 1;
    CHECK_EQUAL(picture_render(&expected, &scene.scene, NULL, &stats), GLINT_OK);
    CHECK(stats.references > 0 && stats.clipped == 0);
    scene.scene.camera.near_plane = 8192;
    check_same_picture(&scene, &expected);
    picture_close(&expected);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(lights_far_off),
        TEST_CASE(light_far_off_fades),
        TEST_CASE(fields_of_view),
        TEST_CASE(least_exponents),
        TEST_CASE(largest_exponents),
        TEST_CASE(triangle_around_the_eye),
        TEST_CASE(box_just_beyond_the_near_plane),
        TEST_CASE(triangles_at_the_bounds),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
