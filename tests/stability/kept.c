/* SPDX-License-Identifier: MIT */
/*
 * Suite: the worst scenes that the search found keep to the contract, or miss it by no more than they are known to; and
 * colours of rooms and terrains are as exact as glint.h says, up to 2^20 times the nearest depth, per facet at any.
 */
#include "kept.h"

#include "contract.h"
#include "harness.h"
#include "random_scene.h"

#include <math.h>
#include <stdio.h>

static unsigned kept_next;

static void print_scene(const random_scene *s, const contract_result *result) {
    char line[160];
    snprintf(line, sizeof line, "%s, seed %llu: missed %ld, over two %ld, worst %.3f\n", random_regions[s->region].name,
             (unsigned long long)s->seed, result->found.missed + result->found.spilled, result->found.over_two,
             result->found.worst);
    test_write(line);
}

static void judge_kept(void) {
    static random_scene scene;
    const kept_scene *kept = &kept_scenes[kept_next++];
    contract_result result;
    random_scene_make_in(&scene, kept->region, kept->seed);
    contract_judge(&scene.scene, scene.width, scene.height, scene.format, &result);
    print_scene(&scene, &result);
    CHECK_EQUAL(random_scene_checksum(&scene), kept->checksum);
    CHECK_EQUAL(result.found.status, GLINT_OK);
    CHECK_AT_MOST(result.found.missed + result.found.spilled, kept->missed);
    if (random_regions[scene.region].in_contract && kept->missed + kept->over_two == 0)
        CHECK(contract_holds(&result));
    else if (random_regions[scene.region].in_contract)
        CHECK_AT_MOST(result.found.over_two, kept->over_two);
    if (kept->worst > 0)
        CHECK_AT_MOST(lrint(100 * result.found.worst), lrint(100 * kept->worst));
}

/* Rounding alone is off by 0.25 in each channel, and by 0.375 in the worst of three. */
static void check_depths(const glint_evaluation *evaluation, int depths) {
    static random_scene scene;
    contract_depth sums[CONTRACT_DEPTHS] = {{0}};
    for (unsigned i = 0; i < 120; i++) {
        contract_result result;
        random_scene_make_in(&scene, RANDOM_TEXTURED_REGION - 1 - i % RANDOM_DEEP_REGIONS, i + 1);
        for (uint32_t object = 0; object < scene.scene.object_count; object++)
            scene.objects[object].evaluation = evaluation;
        contract_judge_closely(&scene.scene, scene.width, scene.height, &glint_format_rgb888, &result);
        for (int depth = 0; depth < depths; depth++) {
            sums[depth].pixels += result.depths[depth].pixels;
            sums[depth].sum += result.depths[depth].sum;
        }
    }
    for (int depth = 0; depth < depths; depth++)
        CHECK(sums[depth].sum <= 0.45 * (double)sums[depth].pixels || sums[depth].pixels < 1000);
    CHECK(sums[depths - 1].pixels >= 1000 || depths == CONTRACT_DEPTHS);
}

static void colours_are_exact_to_the_stated_depths(void) {
    check_depths(&glint_per_fragment, 20);
    check_depths(&glint_per_vertex, 20);
    check_depths(&glint_per_facet, CONTRACT_DEPTHS);
}

int test_main(test_writer write) {
    static test_case cases[TEST_COUNT(kept_scenes) + 1];
    for (unsigned i = 0; i < TEST_COUNT(kept_scenes); i++)
        cases[i] = (test_case){"kept scene", judge_kept};
    cases[TEST_COUNT(kept_scenes)] =
        (test_case){"colours_are_exact_to_the_stated_depths", colours_are_exact_to_the_stated_depths};
    return test_run(write, cases, TEST_COUNT(cases));
}
