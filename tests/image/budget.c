/* SPDX-License-Identifier: MIT */
/*
 * Suite: an error budget of b steps changes no channel of any pixel by more than b steps, keeps what is covered, and
 * saves something.
 */
#include "glint.h"
#include "harness.h"
#include "picture.h"
#include "scenes.h"
#include "scenes/scenes.h"
#include "stability/random_scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const int32_t budgets[] = {1, 2, 4, 8};
#define BUDGETS TEST_COUNT(budgets)

/* Of all scenes: the largest difference, pixels that differ, and what was drawn, by budget, exact first. */
static int worst[BUDGETS];
static uint64_t differ[BUDGETS];
static glint_drawn drawn[BUDGETS + 1][GLINT_KERNELS];

static void add(glint_drawn sum[GLINT_KERNELS], const glint_drawn *counted) {
    for (int kernel = 0; kernel < GLINT_KERNELS; kernel++) {
        sum[kernel].parts += counted[kernel].parts;
        sum[kernel].covered += counted[kernel].covered;
    }
}

static uint32_t covered(const glint_drawn *counted) {
    uint32_t sum = 0;
    for (int kernel = 0; kernel < GLINT_KERNELS; kernel++)
        sum += counted[kernel].covered;
    return sum;
}

/* The largest difference of a channel, in steps. */
static int largest_difference(const picture *a, const picture *b, uint64_t *pixels) {
    int largest = 0;
    for (int y = 0; y < a->height; y++) {
        if (memcmp(a->bytes + (size_t)y * a->stride, b->bytes + (size_t)y * b->stride, a->stride) == 0)
            continue;
        for (int x = 0; x < a->width; x++) {
            int here = 0;
            for (int channel = 0; channel < picture_channels(a->format); channel++) {
                const int difference = abs(picture_level(a, x, y, channel) - picture_level(b, x, y, channel));
                here = difference > here ? difference : here;
            }
            *pixels += here != 0;
            largest = here > largest ? here : largest;
        }
    }
    return largest;
}

static void check_budgets(const glint_scene *scene, int width, int height, const glint_format *format,
                          const char *name) {
    glint_scene granted = *scene;
    glint_stats exact = {0};
    picture wanted = picture_open(width, height, format);
    CHECK_EQUAL(picture_render(&wanted, scene, NULL, &exact), GLINT_OK);
    add(drawn[0], exact.drawn);
    for (unsigned i = 0; i < BUDGETS; i++) {
        glint_stats stats = {0};
        picture got = picture_open(width, height, format);
        granted.error_budget = budgets[i];
        CHECK_EQUAL(picture_render(&got, &granted, NULL, &stats), GLINT_OK);
        CHECK_EQUAL(covered(stats.drawn), covered(exact.drawn));
        add(drawn[i + 1], stats.drawn);
        const int steps = largest_difference(&wanted, &got, &differ[i]);
        worst[i] = steps > worst[i] ? steps : worst[i];
        if (!CHECK(steps <= budgets[i])) {
            char line[160];
            snprintf(line, sizeof line, "  %s, %dx%d, %s: %d steps for a budget of %d\n", name, width, height,
                     format == &glint_format_rgb565 ? "rgb565" : "rgb888", steps, (int)budgets[i]);
            test_write(line);
        }
        picture_close(&got);
    }
    picture_close(&wanted);
}

static void in_both_formats(const glint_scene *scene, int width, int height, const char *name) {
    check_budgets(scene, width, height, &glint_format_rgb565, name);
    check_budgets(scene, width, height, &glint_format_rgb888, name);
}

static void bench_scenes(void) {
    static const glint_q16 exponents[] = {GLINT_ONE,      2 * GLINT_ONE,   8 * GLINT_ONE,
                                          32 * GLINT_ONE, 256 * GLINT_ONE, 1024 * GLINT_ONE};
    for (int which = 0; which < BENCH_SCENES; which++) {
        for (unsigned i = 0; i < TEST_COUNT(exponents); i++) {
            bench_scene scene;
            bench_build_scene(&scene, &bench_definitions[which], scene_bench_mesh(which), (int)i);
            scene.material.shininess = exponents[i];
            for (int viewer = GLINT_VIEWER_INFINITE; viewer <= GLINT_VIEWER_LOCAL; viewer++) {
                scene.scene.viewer = (glint_viewer)viewer;
                in_both_formats(&scene.scene, 320, 240, bench_definitions[which].name);
            }
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

/* Lights and materials of any strength, also such as hardly show. */
static void weaken(test_scene *scene, uint32_t seed) {
    for (uint32_t i = 0; i < scene->scene.light_count; i++) {
        const unsigned down = (seed * 7 + i * 3) % 9;
        scene->lights[i].diffuse.r >>= down;
        scene->lights[i].diffuse.g >>= down;
        scene->lights[i].diffuse.b >>= down;
        scene->lights[i].specular.r >>= (seed + i) % 7;
        scene->lights[i].specular.g >>= (seed + i) % 7;
        scene->lights[i].specular.b >>= (seed + i) % 7;
    }
}

/* GLINT_BUDGET_SCENES sets how many. */
static void random_scenes(void) {
    static random_scene scene;
    const char *wanted = getenv("GLINT_BUDGET_SCENES");
    const uint32_t scenes = wanted ? (uint32_t)atoi(wanted) : 250;
    char name[80];
    for (uint32_t seed = 1; seed <= scenes; seed++) {
        test_scene one;
        scene_build_random(&one, seed);
        one.scene.light_count = one.scene.light_count > 1 && seed % 4 ? 1 : one.scene.light_count;
        if (seed % 2)
            weaken(&one, seed);
        snprintf(name, sizeof name, "random scene %u", (unsigned)seed);
        in_both_formats(&one.scene, 160, 120, name);
    }
    for (uint32_t seed = 1; seed <= 4 * scenes; seed++) {
        random_scene_make(&scene, seed);
        snprintf(name, sizeof name, "scene %u, %s", (unsigned)seed, random_regions[scene.region].name);
        in_both_formats(&scene.scene, scene.width, scene.height, name);
    }
}

/* What was drawn by cheaper kernels than without a budget, and how far it went. */
static void budgets_save(void) {
    char line[160];
    for (unsigned i = 0; i < BUDGETS; i++) {
        snprintf(line, sizeof line, "  budget %d: at most %d steps, %llu pixels differ\n", (int)budgets[i], worst[i],
                 (unsigned long long)differ[i]);
        test_write(line);
        CHECK(worst[i] > 0);
        CHECK(drawn[i + 1][GLINT_KERNEL_EVEN].covered > drawn[i][GLINT_KERNEL_EVEN].covered);
        CHECK(drawn[i + 1][GLINT_KERNEL_GENERAL].covered < drawn[i][GLINT_KERNEL_GENERAL].covered);
    }
    for (int kernel = 0; kernel < GLINT_KERNELS; kernel++) {
        snprintf(line, sizeof line, "  kernel %d: %u pixels covered; with budgets %u, %u, %u, %u\n", kernel,
                 (unsigned)drawn[0][kernel].covered, (unsigned)drawn[1][kernel].covered,
                 (unsigned)drawn[2][kernel].covered, (unsigned)drawn[3][kernel].covered,
                 (unsigned)drawn[4][kernel].covered);
        test_write(line);
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(bench_scenes), TEST_CASE(gallery), TEST_CASE(random_scenes),
                                      TEST_CASE(budgets_save)};
    return test_run(write, cases, TEST_COUNT(cases));
}
