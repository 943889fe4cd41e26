/* SPDX-License-Identifier: MIT */
/*
 * The example scenes by the contract, as CSV: the first frame of every variant, and one past the middle of those that
 * move, as composed, in RGB565 and RGB888.
 */
#include "scenes/scenes.h"
#include "stability/contract.h"

#include <stdio.h>

static const struct {
    const char *name;
    const glint_format *format;
} outputs[] = {{"rgb565", &glint_format_rgb565}, {"rgb888", &glint_format_rgb888}};
#define OUTPUTS (sizeof outputs / sizeof *outputs)

static double percent(long part, long whole) {
    return 100.0 * (double)part / (double)whole;
}

/* @return 1 when the library refuses the scene */
static int judge_variant(const example_scene *scene, uint32_t variant, size_t output) {
    static example_stage stage;
    judgement total = {0};
    double share = 0;
    for (uint32_t frame = 0; frame < scene->frames; frame += scene->frames / 2 + 1) {
        contract_result result;
        scene->build(&stage, variant, frame);
        contract_judge(&stage.scene, scene->width, scene->height, outputs[output].format, &result);
        judgement_add(&total, &result.found);
        share = result.worst_share > share ? result.worst_share : share;
    }
    printf("%s,%s,%s,%ld,%ld,%.2f,%.4f,%.4f,%.4f,%.3f,%.3f\n", scene->name, scene->variants[variant].name,
           outputs[output].name, total.judged, total.missed, judgement_psnr(&total),
           percent(total.judged - total.not_fine, total.judged), percent(total.judged - total.over_one, total.judged),
           percent(total.judged - total.over_two, total.judged), total.worst, share);
    return total.status != GLINT_OK;
}

int main(void) {
    int failed = 0;
    puts("scene,variant,format,pixels,missed,psnr_db,within_bound_percent,within_one_percent,within_two_percent,"
         "worst_steps,worst_over_bound");
    for (unsigned i = 0; i < EXAMPLE_SCENES; i++)
        for (uint32_t variant = 0; variant < example_scenes[i]->variant_count; variant++)
            for (size_t output = 0; output < OUTPUTS; output++)
                failed |= judge_variant(example_scenes[i], variant, output);
    return failed || ferror(stdout) || fflush(stdout);
}
