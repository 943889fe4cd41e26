/* SPDX-License-Identifier: MIT */
/* Suite: the worst scenes that the search found keep to the contract, or miss it by no more than they are known to. */
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

int test_main(test_writer write) {
    static test_case cases[TEST_COUNT(kept_scenes)];
    for (unsigned i = 0; i < TEST_COUNT(cases); i++)
        cases[i] = (test_case){"kept scene", judge_kept};
    return test_run(write, cases, TEST_COUNT(cases));
}
