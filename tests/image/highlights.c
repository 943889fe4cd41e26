/* SPDX-License-Identifier: MIT */
/*
 * Suite: how far Blinn-Phong with a multiple of the exponent looks like Phong. In the plane of L and V the angle from N
 * to H is half of that from R to V, so that small highlights agree at four times the exponent; across that plane the
 * multiple is 4 cos^2 of half the angle between L and V. Found, on a torus and a sphere, for p of 10, 30 and 100:
 * - Four times the exponent is off by at most 0.03 of white while the light is within 30 degrees of the view, 0.11 at
 *   60, 0.25 at 90 and 0.48 at 120.
 * - Twice the exponent is off by 0.25 of white at any angle, as cos^p and cos^2p of one angle are: its highlights are
 *   wider by a half. In sum it is off by nearly all of Phong's light seen from the light, by 0.3 to 0.45 from 90
 * degrees on, where it comes out about as near as four times.
 * - The multiple that fits best falls from 4.2 to 2.3 as the light goes from 0 to 120 degrees.
 */
#include "bench.h"
#include "glint.h"
#include "harness.h"
#include "picture.h"
#include "scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define WIDTH 160
#define HEIGHT 120

/* Two images of highlights alone: largest distance, and the sum of distances over the sum of Phong's light. */
typedef struct likeness {
    double largest; /* of full white */
    double relative;
} likeness;

/* A sphere or a torus with a white highlight; the light `degrees` from the view. */
static void build(test_scene *scene, int shape, double degrees, glint_viewer viewer) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    scene_build_named(scene, "mirrored");
    scene->objects[0].mesh = &scene_bench_mesh(shape)->mesh;
    scene->objects[0].pose = bench_turn(-0.8, 0.6);
    scene->objects[0].pose.m[2][3] = bench_q16(-3.7);
    scene->lights[0].vector =
        (glint_vector){bench_q16(0.8 * sin(angle)), bench_q16(0.6 * sin(angle)), bench_q16(cos(angle))};
    scene->lights[0].specular = (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE};
    scene->materials[0].ambient = scene->materials[0].diffuse = (glint_colour){0, 0, 0};
    scene->materials[0].specular = (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE};
    scene->scene.viewer = viewer;
    scene->scene.background = (glint_colour){0, 0, 0};
}

static void draw(picture *image, test_scene *scene, const glint_model *model, double exponent) {
    scene->materials[0].model = model;
    scene->materials[0].shininess = bench_q16(exponent);
    CHECK_EQUAL(picture_render(image, &scene->scene, NULL, NULL), GLINT_OK);
}

static likeness compare(const picture *phong, const picture *blinn) {
    likeness result = {0, 0};
    double light = 0;
    for (size_t i = 0; i < phong->size; i++) {
        double difference = abs(phong->bytes[i] - blinn->bytes[i]);
        result.largest = fmax(result.largest, difference / 255);
        result.relative += difference;
        light += phong->bytes[i];
    }
    result.relative = light > 0 ? result.relative / light : 0;
    return result;
}

/* The multiple of the exponent that is nearest to Phong, in steps of a tenth. */
static double find_best(picture *blinn, const picture *phong, test_scene *scene, double exponent) {
    double best = 0;
    double least = INFINITY;
    for (int tenths = 10; tenths <= 50; tenths++) {
        draw(blinn, scene, &glint_model_blinn_phong, exponent * tenths / 10);
        double relative = compare(phong, blinn).relative;
        if (relative < least)
            best = tenths / 10.0;
        least = fmin(least, relative);
    }
    return best;
}

/* [0] for twice the exponent, [1] for four times. */
typedef struct row {
    likeness of[2];
    double best;
} row;

static row measure(int shape, double degrees, glint_viewer viewer, double exponent) {
    picture phong = picture_open(WIDTH, HEIGHT, &glint_format_grey8);
    picture blinn = picture_open(WIDTH, HEIGHT, &glint_format_grey8);
    test_scene scene;
    row result;
    build(&scene, shape, degrees, viewer);
    draw(&phong, &scene, &glint_model_phong, exponent);
    for (int i = 0; i < 2; i++) {
        draw(&blinn, &scene, &glint_model_blinn_phong, exponent * (i ? 4 : 2));
        result.of[i] = compare(&phong, &blinn);
    }
    result.best = find_best(&blinn, &phong, &scene, exponent);
    picture_close(&phong);
    picture_close(&blinn);
    return result;
}

static void check_row(const row *found, int degrees) {
    const likeness *twice = &found->of[0];
    const likeness *four = &found->of[1];
    CHECK(twice->largest >= 0.24 && twice->largest <= 0.27);
    CHECK(twice->relative <= (degrees <= 60 ? 1 : 0.5));
    CHECK(four->largest <= (degrees <= 30 ? 0.03 : degrees <= 60 ? 0.11 : degrees <= 90 ? 0.26 : 0.49));
    if (degrees <= 60)
        CHECK(four->relative * 5 < twice->relative);
    if (degrees <= 30)
        CHECK(found->best >= 3.8 && found->best <= 4.3);
    if (degrees >= 90)
        CHECK(found->best >= 2 && found->best <= 3.3);
}

static void highlights_by_angle(void) {
    static const double exponents[] = {10, 30, 100};
    test_write("shape   light      p   twice: largest relative   four times: largest relative   best multiple\n");
    for (int shape = 1; shape <= 3; shape += 2) {
        for (int degrees = 0; degrees <= 120; degrees += 30) {
            for (unsigned i = 0; i < TEST_COUNT(exponents); i++) {
                char line[200];
                row found = measure(shape, degrees, GLINT_VIEWER_INFINITE, exponents[i]);
                snprintf(line, sizeof line, "%s %3d deg. %5.0f %14.3f %8.3f %20.3f %8.3f %15.1f\n",
                         shape == 1 ? "torus " : "sphere", degrees, exponents[i], found.of[0].largest,
                         found.of[0].relative, found.of[1].largest, found.of[1].relative, found.best);
                test_write(line);
                check_row(&found, degrees);
            }
        }
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(highlights_by_angle)};
    return test_run(write, cases, TEST_COUNT(cases));
}
