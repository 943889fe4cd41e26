/* SPDX-License-Identifier: MIT */
#include "rows.h"

#include "harness.h"

#include <stdio.h>

static double percent(long part, long whole) {
    return whole > 0 ? 100.0 * (double)part / (double)whole : 0;
}

void row_print_heading(void) {
    test_write(
        "                                                    covered missed unsure% close%  gated%  >1 step%     >2"
        "  worst   psnr\n");
}

void row_print(const char *name, const judgement *found) {
    char line[200];
    snprintf(line, sizeof line, "%-50s %8ld %6ld %7.3f %6.3f %7.3f %9.4f %6ld %6.3f %6.2f\n", name, found->covered,
             found->missed, percent(found->uncertain, found->covered), percent(found->close, found->covered),
             percent(found->gated, found->covered), percent(found->over_one, found->judged), found->over_two,
             found->worst, judgement_psnr(found));
    test_write(line);
}

int row_is_per_fragment(const glint_scene *scene) {
    for (uint32_t i = 0; i < scene->object_count; i++) {
        const glint_evaluation *evaluation = scene->objects[i].evaluation;
        if (evaluation == NULL || evaluation == &glint_per_fragment)
            return 1;
    }
    return 0;
}

static int is_within(const judgement *found, int per_fragment) {
    long allowed = per_fragment ? found->judged / 10000 : 0;
    return found->status == GLINT_OK && found->missed == 0 && found->spilled == 0 && found->over_one <= allowed;
}

void row_judge(const glint_scene *scene, int width, int height, const glint_format *format, judgement *total) {
    const judge_task task = {
        .scene = scene, .width = width, .height = height, .format = format, .leave_out_gates = 1, .fine = 1};
    judgement found = {0};
    char line[200];
    judge(&task, &found);
    if (!is_within(&found, row_is_per_fragment(scene))) {
        snprintf(line, sizeof line,
                 "    status %d, %s viewer, p = %g: %ld over 1 step, %ld over 2, %ld missed, %ld spilled, "
                 "worst %.3f at (%d, %d)\n",
                 found.status, scene->viewer == GLINT_VIEWER_LOCAL ? "local" : "infinite",
                 scene->object_count ? scene->objects[0].material->shininess / 65536.0 : 0, found.over_one,
                 found.over_two, found.missed, found.spilled, found.worst, found.worst_x, found.worst_y);
        test_write(line);
    }
    judgement_add(total, &found);
}

void row_check(const judgement *found, int per_fragment) {
    CHECK_EQUAL(found->status, GLINT_OK);
    CHECK_EQUAL(found->missed, 0);
    CHECK_EQUAL(found->spilled, 0);
    CHECK_AT_MOST(found->over_two * 10000, per_fragment ? found->judged : 0);
    CHECK(found->judged > 0);
    CHECK_AT_MOST(found->over_one * 10000, per_fragment ? found->judged : 0);
    CHECK(found->close * 500 < found->covered);
    CHECK(found->uncertain * 100 < found->covered);
    CHECK(found->vertex_error <= 1.0 / 16);
}
