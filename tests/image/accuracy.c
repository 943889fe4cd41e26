/* SPDX-License-Identifier: MIT */
/*
 * Suite: the accuracy contract of RGB565 under one directional light, which fast lighting has to keep as well.
 *
 * For p from 1 to 1024 and either viewer, of the covered pixels 99.9% are within 0.75 step of the unrounded reference
 * in every channel where the light weights (diffuse + specular, times the light's colour) sum to at most 1, and within
 * 0.5 + 0.25 times that sum above it; 99.99% are within one step of the rounded reference, and all within two.
 */
#include "bench.h"
#include "glint.h"
#include "harness.h"
#include "judge.h"
#include "picture.h"
#include "scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const int exponents[] = {1, 2, 3, 5, 8, 13, 32, 64, 100, 256, 600, 1024};

static double product(glint_q16 a, glint_q16 b) {
    return a / 65536.0 * (b / 65536.0);
}

/* What is fine by the contract, for a material under a light. */
static void set_contract(judge_task *task, const glint_material *material, const glint_light *light) {
    const glint_colour *d = &material->diffuse, *s = &material->specular;
    const double sums[3] = {product(d->r, light->diffuse.r) + product(s->r, light->specular.r),
                            product(d->g, light->diffuse.g) + product(s->g, light->specular.g),
                            product(d->b, light->diffuse.b) + product(s->b, light->specular.b)};
    for (int c = 0; c < 3; c++)
        task->fine_of[c] = 0.5 + 0.25 * fmax(1, sums[c]);
}

static void print_heading(void) {
    test_write("                                              covered   fine%  <= 1 step%  > 2    worst   psnr\n");
}

static void print_row(const char *name, const judgement *found) {
    char line[160];
    const double judged = (double)(found->judged ? found->judged : 1) / 100;
    snprintf(line, sizeof line, "%-44s %8ld %7.3f %11.4f %4ld %8.3f %6.2f\n", name, found->covered,
             100 - (double)found->not_fine / judged, 100 - (double)found->over_one / judged, found->over_two,
             found->worst, judgement_psnr(found));
    test_write(line);
}

static void check(const judgement *found) {
    CHECK_EQUAL(found->status, GLINT_OK);
    CHECK(found->judged > 0);
    CHECK_EQUAL(found->missed, 0);
    CHECK_EQUAL(found->spilled, 0);
    CHECK_EQUAL(found->over_two, 0);
    CHECK_AT_MOST(found->over_one * 10000, found->judged);
    CHECK_AT_MOST(found->not_fine * 1000, found->judged);
}

/* Frames 0, 3 and 7 of a benchmark. */
static void bench_scene_keeps(int which, int exponent, glint_viewer viewer, int width, int height) {
    judgement found = {0};
    char name[80];
    for (int frame = 0; frame < 10; frame += 3 + (frame > 0)) {
        bench_scene scene;
        judge_task task = {.width = width, .height = height, .format = &glint_format_rgb565};
        bench_build_scene(&scene, &bench_definitions[which], scene_bench_mesh(which), frame);
        scene.material.shininess = exponent * GLINT_ONE;
        scene.scene.viewer = viewer;
        set_contract(&task, &scene.material, &scene.light);
        task.scene = &scene.scene;
        judge(&task, &found);
    }
    snprintf(name, sizeof name, "%s %dx%d p = %d %s", bench_definitions[which].name, width, height, exponent,
             viewer == GLINT_VIEWER_LOCAL ? "local" : "infinite");
    print_row(name, &found);
    check(&found);
    if (which == 0 && width == 320 && exponent == 32 && viewer == GLINT_VIEWER_LOCAL)
        CHECK(judgement_psnr(&found) >= 41.5);
}

static void bench_scenes(void) {
    print_heading();
    for (int which = 0; which < BENCH_SCENES; which++) {
        for (unsigned i = 0; i < TEST_COUNT(exponents); i++) {
            bench_scene_keeps(which, exponents[i], GLINT_VIEWER_INFINITE, 320, 240);
            bench_scene_keeps(which, exponents[i], GLINT_VIEWER_LOCAL, 320, 240);
        }
        bench_scene_keeps(which, 32, GLINT_VIEWER_LOCAL, 128, 64);
    }
}

/* The coarse torus, whose normals turn far, is drawn by the kernels made for that, for both viewers. */
static void curved_triangles_have_kernels(void) {
    static const int tested[] = {2, 8, 32, 256, 1024};
    for (unsigned i = 0; i < 2 * TEST_COUNT(tested); i++) {
        bench_scene scene;
        glint_stats stats = {0};
        picture image = picture_open(320, 240, &glint_format_rgb565);
        bench_build_scene(&scene, &bench_definitions[1], scene_bench_mesh(1), (int)i);
        scene.material.shininess = tested[i / 2] * GLINT_ONE;
        scene.scene.viewer = i % 2 ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
        CHECK_EQUAL(picture_render(&image, &scene.scene, NULL, &stats), GLINT_OK);
        CHECK(stats.drawn[GLINT_KERNEL_CURVED_SPECULAR].covered > 1000);
        CHECK(stats.drawn[GLINT_KERNEL_CURVED_DIFFUSE].covered + stats.drawn[GLINT_KERNEL_CURVED_SPECULAR].covered >
              11000);
        /* the widest highlights reach to the horizon, behind which their backs are */
        CHECK_AT_MOST(stats.drawn[GLINT_KERNEL_GENERAL].covered, tested[i / 2] < 32 ? 1500 : 140);
        picture_close(&image);
    }
}

/* ---- Random scenes ---- */

static uint32_t random_state;

/* From a to b, by a linear congruential generator (Numerical Recipes). */
static double between(double a, double b) {
    random_state = random_state * 1664525u + 1013904223u;
    return a + (b - a) * (random_state >> 8) / 16777216.0;
}

static glint_colour random_colour(double most) {
    double r = between(0, most);
    double g = between(0, most);
    return (glint_colour){bench_q16(r), bench_q16(g), bench_q16(between(0, most))};
}

/* Objects of one material at random places, under one light that is white or coloured. */
static void build_random(test_scene *scene, uint32_t seed) {
    scene_build_random(scene, seed);
    random_state = seed * 2246822519u;
    scene->scene.light_count = 1;
    scene->lights[0].type = &glint_light_directional;
    scene->lights[0].vector.x = bench_q16(between(-1, 1));
    scene->lights[0].vector.y = bench_q16(between(-1, 1));
    scene->lights[0].vector.z = bench_q16(between(-1, 1));
    scene->lights[0].diffuse = random_colour(1);
    scene->lights[0].specular = random_colour(1);
    scene->materials[0].ambient = random_colour(0.3);
    scene->materials[0].diffuse = random_colour(seed % 4 == 0 ? 2 : 1);
    scene->materials[0].specular = random_colour(seed % 4 == 1 ? 3 : 1);
    if (seed % 4 >= 2) {
        scene->lights[0].diffuse = (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE};
        scene->lights[0].specular = scene->lights[0].diffuse;
    }
    scene->materials[0].shininess = bench_q16(exp(between(0, log(1024))));
    for (uint32_t i = 0; i < scene->scene.object_count; i++) {
        scene->objects[i].material = &scene->materials[0];
        scene->objects[i].mesh = &scene_bench_mesh((int)between(0, BENCH_SCENES))->mesh;
    }
}

/* The bounds hold over all of them together; GLINT_ACCURACY_SCENES sets how many. */
static void random_scenes(void) {
    const char *wanted = getenv("GLINT_ACCURACY_SCENES");
    const uint32_t scenes = wanted ? (uint32_t)atoi(wanted) : 300;
    judgement found = {0};
    char name[80];
    for (uint32_t seed = 1; seed <= scenes; seed++) {
        test_scene scene;
        judge_task task = {.width = 160, .height = 120, .format = &glint_format_rgb565, .leave_out_gates = 1};
        judgement one = {0};
        build_random(&scene, seed);
        set_contract(&task, &scene.materials[0], &scene.lights[0]);
        task.scene = &scene.scene;
        judge(&task, &one);
        if (one.over_two || one.over_one * 1000 > one.judged || one.not_fine * 50 > one.judged) {
            snprintf(name, sizeof name, "  scene %u, p = %.1f, worst at (%d, %d)", seed,
                     scene.materials[0].shininess / 65536.0, one.worst_x, one.worst_y);
            print_row(name, &one);
        }
        judgement_add(&found, &one);
    }
    print_heading();
    snprintf(name, sizeof name, "%u random scenes", scenes);
    print_row(name, &found);
    check(&found);
    CHECK(found.gated * 2048 < found.covered);
}

static void every_compiler_draws_the_same_scenes(void) {
    CHECK_EQUAL(scene_checksum_of_seeds(build_random), 0xce9dd129u);
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(bench_scenes), TEST_CASE(curved_triangles_have_kernels),
                                      TEST_CASE(random_scenes), TEST_CASE(every_compiler_draws_the_same_scenes)};
    return test_run(write, cases, TEST_COUNT(cases));
}
