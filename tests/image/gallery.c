/* SPDX-License-Identifier: MIT */
/*
 * Suite: every variant of every example scene, as composed, against the double-precision reference: each frame keeps
 * the contract, by the pixels that count (contract.h).
 */
#include "glint.h"
#include "harness.h"
#include "rows.h"
#include "scenes/scenes.h"
#include "stability/contract.h"

#include <stdio.h>

/* The first frame, and one past the middle of a scene that moves. */
static void judge_variant(const example_scene *scene, uint32_t variant, const glint_format *format) {
    static example_stage stage;
    judgement total = {0};
    char name[80];
    for (uint32_t frame = 0; frame < scene->frames; frame += scene->frames / 2 + 1) {
        contract_result result;
        scene->build(&stage, variant, frame);
        contract_judge(&stage.scene, scene->width, scene->height, format, &result);
        CHECK(contract_holds(&result));
        judgement_add(&total, &result.found);
    }
    snprintf(name, sizeof name, "%s %s, %s", scene->name, scene->variants[variant].name,
             format == &glint_format_rgb565 ? "RGB565" : "RGB888");
    row_print(name, &total);
    row_check(&total, row_is_per_fragment(&stage.scene));
    CHECK(total.gated * 50 < total.covered);
}

static void gallery(void) {
    row_print_heading();
    for (unsigned i = 0; i < EXAMPLE_SCENES; i++) {
        CHECK(example_scenes[i]->variant_count > 0);
        for (uint32_t variant = 0; variant < example_scenes[i]->variant_count; variant++) {
            judge_variant(example_scenes[i], variant, &glint_format_rgb565);
            judge_variant(example_scenes[i], variant, &glint_format_rgb888);
        }
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(gallery)};
    return test_run(write, cases, TEST_COUNT(cases));
}
