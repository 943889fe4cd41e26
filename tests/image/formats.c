/* SPDX-License-Identifier: MIT */
/*
 * Suite: the accuracy contract of every pixel format, dithered or not, which is about the value before it is rounded. A
 * stored level is floor(v + t), t being 1/2 or the pixel's threshold, and v is within weights_slack of the reference r:
 * what is stored is then within that, and half a level, of r + 1/2 - t (contract.h). What this leaves after rounding:
 * levels of 4 bits and of 1 are within one of floor(r + t) in every pixel that counts, and other than floor(r + t) in
 * few.
 */
#include "glint.h"
#include "harness.h"
#include "picture.h"
#include "sample.h"
#include "scenes.h"
#include "scenes/scenes.h"
#include "stability/contract.h"
#include "stability/random_scene.h"
#include "stability/weights.h"

#include <math.h>
#include <stdio.h>

typedef struct tested {
    const char *name;
    const glint_format *format;
    /*
     * Share of the pixels that may be other than the rounded reference. Within 0.15 dB of that, as the contract of
     * RGB565 says, are errors of 0.054 steps, root mean square; where they are uniform, 4.7 % of the pixels differ in
     * one channel.
     */
    double most_apart;
} tested;

/* Its place in the table. */
#define RGB888 4

static const tested formats[] = {
    {"RGB565", &glint_format_rgb565, 0.03},
    {"RGB565 dithered", &glint_format_rgb565_dithered, 0.03},
    {"RGB565 big-endian", &glint_format_rgb565_be, 0.03},
    {"RGB565 big-endian, dithered", &glint_format_rgb565_be_dithered, 0.03},
    {"RGB888", &glint_format_rgb888, 0.06},
    {"RGB888 dithered", &glint_format_rgb888_dithered, 0.06},
    {"RGB444", &glint_format_rgb444, 0.01},
    {"RGB444 dithered", &glint_format_rgb444_dithered, 0.01},
    {"grey8", &glint_format_grey8, 0.03},
    {"grey8 dithered", &glint_format_grey8_dithered, 0.03},
    {"grey4", &glint_format_grey4, 0.003},
    {"grey4 dithered", &glint_format_grey4_dithered, 0.003},
    {"mono", &glint_format_mono, 0.0002},
    {"mono dithered", &glint_format_mono_dithered, 0.0002},
    {"mono in pages", &glint_format_mono_pages, 0.0002},
    {"mono in pages, dithered", &glint_format_mono_pages_dithered, 0.0002},
};

/* Of each format, over all scenes. */
typedef struct tally {
    judgement found;
    double worst_share;
    long scenes;
} tally;

static tally tallies[TEST_COUNT(formats)];
static unsigned turn;

static int is_coarse(const glint_format *format) {
    return picture_level_max(format, 0) <= 15;
}

static void judge_in(unsigned kind, const glint_scene *scene, int width, int height, const char *name) {
    contract_result result;
    tally *to = &tallies[kind];
    char line[200];
    contract_judge(scene, width, height, formats[kind].format, &result);
    const long far = is_coarse(formats[kind].format) ? result.found.over_one : 0;
    if (!CHECK(contract_holds(&result) && far == 0)) {
        snprintf(
            line, sizeof line,
            "  %s, %s: status %d, missed %ld, spilled %ld, %ld of %ld over, one %ld, two %ld, worst %.4f of %.4f\n",
            name, formats[kind].name, result.found.status, result.found.missed, result.found.spilled,
            result.found.not_fine, result.found.judged, result.found.over_one, result.found.over_two,
            result.found.worst, result.bound);
        test_write(line);
    }
    to->scenes++;
    to->worst_share = fmax(to->worst_share, (result.found.worst - 0.5) / (result.bound - 0.5));
    judgement_add(&to->found, &result.found);
}

/* In so many formats, others for each scene. */
static void judge_some(unsigned count, const glint_scene *scene, int width, int height, const char *name) {
    for (unsigned i = 0; i < count; i++)
        judge_in(turn++ % TEST_COUNT(formats), scene, width, height, name);
}

static void bench_scenes(void) {
    static const int exponents[] = {1, 2, 8, 32, 64, 256, 1024};
    static const glint_evaluation *const evaluations[] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    static const glint_model *const models[] = {&glint_model_blinn_phong, &glint_model_phong};
    for (unsigned i = 0; i < 4 * BENCH_SCENES * 7 * 3; i++) {
        bench_scene scene;
        const unsigned which = i / 84, viewer = i / 42 % 2;
        bench_build_scene(&scene, &bench_definitions[which], scene_bench_mesh((int)which), (int)(i % 10));
        scene.material.model = models[i / 21 % 2];
        scene.material.shininess = exponents[i / 3 % 7] * GLINT_ONE;
        scene.object.evaluation = evaluations[i % 3];
        scene.scene.viewer = viewer ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
        judge_some(1, &scene.scene, i % 5 ? 128 : 320, i % 5 ? 64 : 240, bench_definitions[which].name);
    }
}

/* Clipped, mirrored and stretched objects, up to eight lights, colours beyond 1. */
static void scenes(void) {
    for (unsigned i = 0; i < scene_count; i++) {
        test_scene scene;
        scene_build(&scene, &scene_definitions[i]);
        const int is_too_bright = scene.materials[0].diffuse.r > GLINT_ONE; /* for a contract in steps of 8 bits */
        for (unsigned kind = 0; kind < TEST_COUNT(formats); kind++)
            if (!is_too_bright || (kind != RGB888 && kind != RGB888 + 1))
                judge_in(kind, &scene.scene, 157, 93, scene_definitions[i].name);
    }
}

/* Coarse triangles whose highlights turn far, as the viewer's direction does too: in steps of 8 bits. */
static void highlights_in_8_bits(void) {
    static const int exponents[] = {2, 8, 32, 64, 256, 1024};
    static const unsigned coarse[] = {1, 3}; /* torus576 and sphere960 */
    for (unsigned i = 0; i < 480; i++) {
        bench_scene scene;
        const unsigned which = coarse[i / 240], small = i / 120 % 2, is_phong = i / 60 % 2;
        bench_build_scene(&scene, &bench_definitions[which], scene_bench_mesh((int)which), (int)(i % 10));
        scene.material.model = is_phong ? &glint_model_phong : &glint_model_blinn_phong;
        scene.material.shininess = exponents[i / 10 % 6] * GLINT_ONE;
        scene.scene.viewer = GLINT_VIEWER_LOCAL;
        judge_in(RGB888, &scene.scene, small ? 128 : 320, small ? 64 : 240, bench_definitions[which].name);
    }
}

/* Lights of all kinds, one to five of them. */
static void example_variants(void) {
    static example_stage stage;
    for (unsigned i = 0; i < EXAMPLE_SCENES; i++) {
        const example_scene *scene = example_scenes[i];
        for (uint32_t variant = 0; variant < scene->variant_count; variant++) {
            scene->build(&stage, variant, scene->frames / 2);
            judge_some(3, &stage.scene, scene->width, scene->height, scene->name);
        }
    }
}

static void random_scenes(void) {
    static random_scene scene;
    for (uint64_t seed = 1; seed <= 2500 / sample_share(); seed++) {
        random_scene_make(&scene, seed);
        if (random_regions[scene.region].in_contract)
            judge_some(1, &scene.scene, scene.width, scene.height, random_regions[scene.region].name);
    }
}

/* Facets whose longest edges are next to parallel, of 16 bits: what these lose turns the normal. */
static void facets_of_slivers(void) {
    static const uint64_t seeds[] = {319, 4918, 6745, 18694, 20920, 29656};
    static random_scene scene;
    for (unsigned i = 0; i < TEST_COUNT(seeds); i++) {
        contract_result found;
        random_scene_make(&scene, seeds[i]);
        contract_judge(&scene.scene, scene.width, scene.height, scene.format, &found);
        CHECK_EQUAL(found.found.status, GLINT_OK);
        CHECK_EQUAL(found.found.over_one, 0);
    }
}

static void few_are_apart(void) {
    test_write("                              scenes    pixels  of the slack  not as rounded, %   > 1\n");
    for (unsigned kind = 0; kind < TEST_COUNT(formats); kind++) {
        const tally *t = &tallies[kind];
        const double apart = (double)t->found.apart / (double)t->found.judged;
        char line[160];
        snprintf(line, sizeof line, "%-28s %7ld %9ld %13.3f %18.4f %5ld\n", formats[kind].name, t->scenes,
                 t->found.judged, t->worst_share, 100 * apart, t->found.over_one);
        test_write(line);
        CHECK(t->found.judged > 100000);
        CHECK(apart <= formats[kind].most_apart);
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(bench_scenes),        TEST_CASE(example_variants),
                                      TEST_CASE(random_scenes),       TEST_CASE(facets_of_slivers),
                                      TEST_CASE(few_are_apart),       TEST_CASE(scenes),
                                      TEST_CASE(highlights_in_8_bits)};
    return test_run(write, cases, TEST_COUNT(cases));
}
