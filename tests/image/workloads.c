/* SPDX-License-Identifier: MIT */
/*
 * Suite: each workload of the benchmark, example scenes among them, keeps the accuracy contract, and its rules leave
 * few pixels out. A user would see wrong pixels in scenes like his own, or the contract would say nothing about them.
 */
#include "workloads.h"

#include "harness.h"
#include "stability/contract.h"

#include <stdio.h>

/* At most one covered pixel in so many is left out by a rule, over all workloads; of the floor, whose far pixels hold
 * many texels, more are unsettled. */
#define LEFT_OUT_SHARE 500
#define UNSETTLED_SHARE 100

static const char *const rules[CONTRACT_RULES] = {"judged", "uncertain",  "unsettled", "gated",         "close",
                                                  "far",    "short sums", "narrow",    "next to light", "rounded"};

static workload_stage stage;

static int is_judged(const glint_format *format) {
    return format == &glint_format_rgb565 || format == &glint_format_rgb888 || format == &glint_format_grey8;
}

static void judge_workload(const workload *drawn, long pixels[CONTRACT_RULES]) {
    char line[160];
    contract_result result;
    if (!CHECK_EQUAL(workload_build(&stage, drawn), 0))
        return;
    workload_set_frame(&stage, 0);
    contract_judge_closely(&stage.example.scene, drawn->width, drawn->height, drawn->output->format, &result);
    CHECK_EQUAL(result.found.status, GLINT_OK);
    if (!CHECK(contract_holds(&result))) {
        snprintf(line, sizeof line, "  %s, %s: worst %.3f of %.3f at %d, %d\n", drawn->scene,
                 drawn->look ? drawn->look : "", result.found.worst, result.bound, result.worst_x, result.worst_y);
        test_write(line);
    }
    for (int rule = 0; rule < CONTRACT_RULES; rule++)
        pixels[rule] += result.pixels[rule];
}

static void workloads_keep_the_contract(void) {
    long pixels[CONTRACT_RULES] = {0}, all = 0;
    for (uint32_t i = 0; i < workload_count(); i++) {
        const workload drawn = workload_get(i);
        if (is_judged(drawn.output->format) && !drawn.output->gamma)
            judge_workload(&drawn, pixels);
    }
    for (int rule = 0; rule < CONTRACT_RULES; rule++)
        all += pixels[rule];
    for (int rule = 0; rule < CONTRACT_RULES; rule++) {
        char line[80];
        snprintf(line, sizeof line, "  %-14s %9ld pixels, %8.4f %%\n", rules[rule], pixels[rule],
                 100 * (double)pixels[rule] / (double)all);
        test_write(line);
        if (rule != CONTRACT_JUDGED)
            CHECK_AT_MOST(pixels[rule] * (rule == CONTRACT_UNSETTLED ? UNSETTLED_SHARE : LEFT_OUT_SHARE), all);
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(workloads_keep_the_contract)};
    return test_run(write, cases, TEST_COUNT(cases));
}
