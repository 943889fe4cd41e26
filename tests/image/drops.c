/* SPDX-License-Identifier: MIT */
/*
 * Suite: what cannot show is dropped, and dropping keeps every bit: each scene is drawn again by twins that drop
 * nothing. Each drop is seen to have happened.
 */
#include "glint.h"
#include "harness.h"
#include "picture.h"
#include "scenes.h"
#include "scenes/scenes.h"
#include "stability/random_scene.h"
#include "undropped.h"

#include <stdio.h>

/* What all scenes together took. */
static glint_stats total;
static uint32_t scenes, different;

static void add(const glint_stats *stats) {
    total.facing_away += stats->facing_away;
    total.outside += stats->outside;
    total.hidden += stats->hidden;
    for (int kernel = 0; kernel < GLINT_KERNELS; kernel++) {
        total.drawn[kernel].parts += stats->drawn[kernel].parts;
        total.drawn[kernel].covered += stats->drawn[kernel].covered;
    }
}

/* Draws a scene and its twin. */
static void check_same(const glint_scene *scene, int width, int height, const glint_format *format, const char *name) {
    static undropped_scene twin;
    glint_stats stats = {0};
    picture dropped = picture_open(width, height, format);
    picture whole = picture_open(width, height, undropped_format(format));
    CHECK(undropped_make(&twin, scene));
    CHECK_EQUAL(picture_render(&dropped, scene, NULL, &stats), GLINT_OK);
    CHECK_EQUAL(picture_render(&whole, &twin.scene, NULL, NULL), GLINT_OK);
    add(&stats);
    scenes++;
    if (!CHECK(picture_equal(&dropped, &whole)) && different++ < 10) {
        char line[160];
        snprintf(line, sizeof line, "  %s, %dx%d, %s\n", name, width, height,
                 format == &glint_format_rgb565 ? "rgb565" : "another format");
        test_write(line);
    }
    picture_close(&dropped);
    picture_close(&whole);
}

static void in_both_formats(const glint_scene *scene, int width, int height, const char *name) {
    check_same(scene, width, height, &glint_format_rgb565, name);
    check_same(scene, width, height, &glint_format_rgb888, name);
}

static void bench_scenes(void) {
    static const glint_q16 exponents[] = {0, GLINT_ONE, 2 * GLINT_ONE, 32 * GLINT_ONE, 1024 * GLINT_ONE};
    for (int which = 0; which < BENCH_SCENES; which++) {
        for (unsigned i = 0; i < TEST_COUNT(exponents); i++) {
            bench_scene scene;
            bench_build_scene(&scene, &bench_definitions[which], scene_bench_mesh(which), (int)i * 2);
            scene.material.shininess = exponents[i];
            for (int viewer = GLINT_VIEWER_INFINITE; viewer <= GLINT_VIEWER_LOCAL; viewer++) {
                scene.scene.viewer = (glint_viewer)viewer;
                in_both_formats(&scene.scene, 320, 240, bench_definitions[which].name);
            }
            scene.material.specular = (glint_colour){0, 0, 0};
            in_both_formats(&scene.scene, 128, 64, bench_definitions[which].name);
        }
    }
}

static void gallery(void) {
    static example_stage stage;
    for (unsigned i = 0; i < EXAMPLE_SCENES; i++) {
        const example_scene *scene = example_scenes[i];
        for (uint32_t variant = 0; variant < scene->variant_count; variant++) {
            scene->build(&stage, variant, scene->frames / 2);
            in_both_formats(&stage.scene, scene->width, scene->height, scene->name);
        }
    }
}

static void chosen_scenes(void) {
    for (unsigned i = 0; i < scene_count; i++) {
        test_scene scene;
        scene_build(&scene, &scene_definitions[i]);
        in_both_formats(&scene.scene, 150, 101, scene_definitions[i].name);
    }
}

/* Of few objects under one light, as RGB565 has kernels for; and of every region where methods fail. */
static void random_scenes(void) {
    static random_scene scene;
    char name[40];
    for (uint32_t seed = 1; seed <= 150; seed++) {
        test_scene one;
        scene_build_random(&one, seed);
        one.scene.light_count = one.scene.light_count > 1 && seed % 8 ? 1 : one.scene.light_count;
        snprintf(name, sizeof name, "random scene %u", (unsigned)seed);
        in_both_formats(&one.scene, 160, 120, name);
    }
    for (uint32_t seed = 1; seed <= 1000; seed++) {
        random_scene_make(&scene, seed);
        snprintf(name, sizeof name, "scene %u, %s", (unsigned)seed, random_regions[scene.region].name);
        in_both_formats(&scene.scene, scene.width, scene.height, name);
    }
}

static void every_drop_happened(void) {
    char line[160];
    snprintf(line, sizeof line, "  %u scenes; fragments: %u facing away, %u out of reach, %u without highlight;\n",
             (unsigned)scenes, (unsigned)undropped.facing_away, (unsigned)undropped.out_of_reach,
             (unsigned)undropped.no_highlight);
    test_write(line);
    snprintf(line, sizeof line, "  materials without specular light: %u; parts: %u ambient, %u without highlight\n",
             (unsigned)undropped.no_specular, (unsigned)undropped.parts_ambient, (unsigned)undropped.parts_matt);
    test_write(line);
    snprintf(line, sizeof line, "  interpolated parts without highlight: %u; squares: %u\n",
             (unsigned)undropped.parts_interpolated, (unsigned)undropped.squares_matt);
    test_write(line);
    CHECK(undropped.parts_interpolated > 0);
    CHECK(undropped.squares_matt > 0);
    CHECK(undropped.facing_away > 0);
    CHECK(undropped.out_of_reach > 0);
    CHECK(undropped.no_highlight > 0);
    CHECK(undropped.no_specular > 0);
    CHECK(undropped.parts_ambient > 0);
    CHECK(undropped.parts_matt > 0);
    CHECK(total.facing_away > 0);
    CHECK(total.outside > 0);
    CHECK(total.hidden > 0);
    for (int kernel = 0; kernel < GLINT_KERNELS; kernel++) {
        const int needs_budget = kernel == GLINT_KERNEL_EVEN;
        CHECK_EQUAL(total.drawn[kernel].parts > 0, !needs_budget);
        CHECK_EQUAL(total.drawn[kernel].covered > 0, !needs_budget);
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(bench_scenes), TEST_CASE(gallery), TEST_CASE(chosen_scenes),
                                      TEST_CASE(random_scenes), TEST_CASE(every_drop_happened)};
    return test_run(write, cases, TEST_COUNT(cases));
}
