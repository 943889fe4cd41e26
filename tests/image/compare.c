/* SPDX-License-Identifier: MIT */
/*
 * Suite: the library's images against the double-precision reference, in steps of the output format. Every row of the
 * tables is a bound held; the two columns "fine" are measured only.
 */
#include "bench.h"
#include "glint.h"
#include "harness.h"
#include "judge.h"
#include "picture.h"
#include "scenes.h"

#include <math.h>
#include <stdio.h>

/* Steps within which a stored value counts as fine: 0.5 is ideal rounding. */
#define FINE_565 0.75
#define FINE_COARSE 0.52 /* 16 levels or fewer: hardly anything but rounding; */
#define FINE_444 0.56    /* but for those of directional light alone: a quarter of a level of 6 bits */
#define FINE_888 0.8

#define WIDTH 320
#define HEIGHT 240

static double percent(long part, long whole) {
    return whole > 0 ? 100.0 * (double)part / (double)whole : 0;
}

static void print_heading(void) {
    test_write(
        "                                         covered vertex missed unsure% close%  >1 step%   worst  >0.75%   "
        "psnr  888 worst "
        "  >0.8%\n");
}

static void print_row(const char *name, const judgement *of_565, const judgement *of_888) {
    char line[200];
    snprintf(line, sizeof line, "%-40s %7ld %6.4f %6ld %7.3f %6.3f %9.4f %7.3f %7.3f %6.2f %10.3f %7.3f\n", name,
             of_565->covered, of_565->vertex_error, of_565->missed, percent(of_565->uncertain, of_565->covered),
             percent(of_565->close, of_565->covered), percent(of_565->over_one, of_565->judged), of_565->worst,
             percent(of_565->not_fine, of_565->judged), judgement_psnr(of_565), of_888->worst,
             percent(of_888->not_fine, of_888->judged));
    test_write(line);
}

/* The colour contract of RGB565, and that no pixel is left out of it without a reason. */
static void check_colours(const judgement *found) {
    CHECK_EQUAL(found->status, GLINT_OK);
    CHECK(found->judged > 0);
    CHECK_AT_MOST(found->over_one * 10000, found->judged);
    CHECK(found->close * 500 < found->covered);
    CHECK_EQUAL(found->spilled, 0);
}

static void check_geometry(const judgement *found) {
    CHECK_EQUAL(found->missed, 0);
    CHECK(found->uncertain * 100 < found->covered);
    CHECK(found->vertex_error <= 1.0 / 16);
}

/* ---- Benchmark scenes ---------------------------------------------------------------------------------------- */

static const int exponents[] = {1, 2, 8, 32, 100, 256, 1024};

/* Frames 0 and 5 of a benchmark. */
static void judge_bench(int which, int exponent, glint_viewer viewer, const judge_task *like, judgement *total) {
    for (int frame = 0; frame <= 5; frame += 5) {
        bench_scene scene;
        judge_task task = *like;
        bench_build_scene(&scene, &bench_definitions[which], scene_bench_mesh(which), frame);
        scene.material.shininess = exponent * GLINT_ONE;
        scene.scene.viewer = viewer;
        task.scene = &scene.scene;
        task.leave_out_gates = exponent <= 2; /* beyond, next to nothing is left of the highlight where it ends */
        judge(&task, total);
    }
}

static void compare_bench(int which, int exponent, glint_viewer viewer, int width, int height) {
    judge_task task = {.width = width, .height = height, .format = &glint_format_rgb565, .fine = FINE_565};
    judgement of_565 = {0};
    judgement of_888 = {0};
    char name[80];
    judge_bench(which, exponent, viewer, &task, &of_565);
    task.format = &glint_format_rgb888;
    task.fine = FINE_888;
    judge_bench(which, exponent, viewer, &task, &of_888);
    snprintf(name, sizeof name, "%s %dx%d p = %d %s", bench_definitions[which].name, width, height, exponent,
             viewer == GLINT_VIEWER_LOCAL ? "local" : "infinite");
    print_row(name, &of_565, &of_888);
    check_colours(&of_565);
    check_geometry(&of_565);
    CHECK_EQUAL(of_565.uncertain, 0);
    if (exponent <= 2)
        CHECK_AT_MOST(of_565.gated, 2 + of_565.covered / 2048);
    if (which == 0 && width == WIDTH && exponent == 32 && viewer == GLINT_VIEWER_LOCAL)
        CHECK(judgement_psnr(&of_565) >= 41);
}

/*
 * The images are judged on the quantised mesh. What quantising may move on the screen, apart: half a step of the
 * largest extent, seen from the mesh's nearest point, with a field of view of 60 degrees.
 */
static void print_quantisation(int which, int height) {
    const bench_definition *definition = &bench_definitions[which];
    double half_step = scene_bench_mesh(which)->mesh.extent.x / 65536.0 / 65536;
    double radius = definition->shape == BENCH_TORUS ? 1.4 : 1.0;
    double focal = 0.5 * height * sqrt(3);
    char line[120];
    snprintf(line, sizeof line, "%s: quantised positions are off by at most %.4f px along an axis\n", definition->name,
             half_step * focal / (definition->distance - radius));
    test_write(line);
}

static void compare_bench_size(int width, int height) {
    print_heading();
    for (int which = 0; which < BENCH_SCENES; which++) {
        for (unsigned i = 0; i < TEST_COUNT(exponents); i++) {
            compare_bench(which, exponents[i], GLINT_VIEWER_INFINITE, width, height);
            compare_bench(which, exponents[i], GLINT_VIEWER_LOCAL, width, height);
        }
        print_quantisation(which, height);
    }
}

static void bench_scenes_at_320x240(void) {
    compare_bench_size(WIDTH, HEIGHT);
}

static void bench_scenes_at_128x64(void) {
    compare_bench_size(128, 64);
}

/*
 * Among very many pixels some lie where N.L is 0 to the last bit and the highlight, gated by N.L > 0, ends in a jump.
 * Where that is to be expected they are left out. N.L is evenly spread, so that with 8 lights they are 8 in 2^14.
 */
static void check_gates(const judgement *found) {
    CHECK(found->gated * 2048 < found->covered);
}

/* ---- Other scenes -------------------------------------------------------------------------------------------- */

static void compare_scene(const scene_definition *definition, glint_viewer viewer, int width, int height) {
    judge_task task = {.width = width, .height = height, .format = &glint_format_rgb565, .fine = FINE_565};
    judgement of_565 = {0};
    judgement of_888 = {0};
    test_scene scene;
    char name[80];
    scene_build(&scene, definition);
    scene.scene.viewer = viewer;
    task.scene = &scene.scene;
    task.leave_out_gates = width == GLINT_SIZE_MAX && scene.materials[0].shininess == 0; /* the jump is full height */
    judge(&task, &of_565);
    task.format = &glint_format_rgb888;
    task.fine = FINE_888;
    judge(&task, &of_888);
    snprintf(name, sizeof name, "%s, %s", definition->name, viewer == GLINT_VIEWER_LOCAL ? "local" : "infinite");
    print_row(name, &of_565, &of_888);
    check_colours(&of_565);
    check_geometry(&of_565);
    if (task.leave_out_gates)
        check_gates(&of_565);
}

static void other_scenes(void) {
    print_heading();
    for (unsigned i = 0; i < scene_count; i++) {
        compare_scene(&scene_definitions[i], GLINT_VIEWER_INFINITE, WIDTH, HEIGHT);
        compare_scene(&scene_definitions[i], GLINT_VIEWER_LOCAL, WIDTH, HEIGHT);
    }
}

static void other_scenes_on_the_largest_screen(void) {
    print_heading();
    for (unsigned i = 0; i < scene_count; i++)
        compare_scene(&scene_definitions[i], GLINT_VIEWER_LOCAL, GLINT_SIZE_MAX, GLINT_SIZE_MAX);
}

/* Cameras, poses, materials and lights of all kinds; the bounds hold over all of them together. */
static void random_scenes(void) {
    judge_task task = {.width = 160, .height = 120, .leave_out_gates = 1};
    judgement of_565 = {0};
    judgement of_888 = {0};
    for (uint32_t seed = 1; seed <= 200; seed++) {
        test_scene scene;
        scene_build_random(&scene, seed);
        task.scene = &scene.scene;
        task.format = &glint_format_rgb565;
        task.fine = FINE_565;
        judge(&task, &of_565);
        task.format = &glint_format_rgb888;
        task.fine = FINE_888;
        judge(&task, &of_888);
    }
    print_heading();
    print_row("200 random scenes", &of_565, &of_888);
    check_colours(&of_565);
    check_geometry(&of_565);
    check_gates(&of_565);
}

static void every_compiler_draws_the_same_scenes(void) {
    CHECK_EQUAL(scene_checksum_of_seeds(scene_build_random), 0x5fbdb2bfu);
}

/* ---- Formats ------------------------------------------------------------------------------------------------- */

/* A torus and one too bright, in every format, on a screen that no tile divides; one step of each format is allowed. */
static void compare_format(const char *name, const glint_format *format, double psnr) {
    const int is_coarse = picture_level_max(format, 0) <= 15;
    const double coarse = format == &glint_format_rgb444 ? FINE_444 : FINE_COARSE;
    judge_task task = {.width = 157, .height = 93, .format = format, .fine = is_coarse ? coarse : FINE_888};
    test_scene scene;
    judgement found = {0};
    for (unsigned i = 0; i < scene_count; i++) {
        scene_build(&scene, &scene_definitions[i]);
        task.scene = &scene.scene;
        judge(&task, &found);
    }
    print_row(name, &found, &found);
    CHECK_EQUAL(found.status, GLINT_OK);
    CHECK_EQUAL(found.missed, 0);
    CHECK_EQUAL(found.spilled, 0);
    if (format != &glint_format_rgb888 && format != &glint_format_grey8) { /* finer than the contract, which is 565's */
        CHECK_AT_MOST(found.over_one * 10000, found.judged);
    }
    if (is_coarse)
        CHECK_AT_MOST(found.not_fine * 1000, found.judged);
    CHECK(judgement_psnr(&found) >= psnr);
}

static void formats(void) {
    print_heading();
    compare_format("rgb565, all scenes", &glint_format_rgb565, 40);
    compare_format("rgb565_be, all scenes", &glint_format_rgb565_be, 40);
    compare_format("rgb888, all scenes", &glint_format_rgb888, 40);
    compare_format("grey8, all scenes", &glint_format_grey8, 40);
    compare_format("grey4, all scenes", &glint_format_grey4, 34);
    compare_format("rgb444, all scenes", &glint_format_rgb444, 34);
    compare_format("mono, all scenes", &glint_format_mono, 0);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(bench_scenes_at_320x240),
        TEST_CASE(bench_scenes_at_128x64),
        TEST_CASE(other_scenes),
        TEST_CASE(other_scenes_on_the_largest_screen),
        TEST_CASE(random_scenes),
        TEST_CASE(every_compiler_draws_the_same_scenes),
        TEST_CASE(formats),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
