/* SPDX-License-Identifier: MIT */
/*
 * How exact colours and depths are over the depth ratio, as CSV: random scenes of rooms, terrains and far objects in
 * RGB888 with each evaluation against the double-precision reference, by powers of two of the depth as a multiple of
 * that of the frame's nearest geometry.
 */
#include "stability/contract.h"
#include "stability/random_scene.h"

#include <stdio.h>
#include <string.h>

#define SCENES 1200

static const struct {
    const char *name;
    const glint_evaluation *evaluation;
} evaluations[] = {{"fragment", &glint_per_fragment}, {"vertex", &glint_per_vertex}, {"facet", &glint_per_facet}};

/* Fewer pixels say little about the largest error. */
#define LEAST_PIXELS 300

static void add(contract_depth *sum, const contract_depth *part) {
    sum->pixels += part->pixels;
    sum->sum += part->sum;
    sum->apart += part->apart;
    sum->worst = part->worst > sum->worst ? part->worst : sum->worst;
}

/* Is a region one of those with depths? */
static int is_deep(const random_region *region) {
    return strcmp(region->name, "rooms") == 0 || strcmp(region->name, "terrains") == 0 ||
           strcmp(region->name, "depth ratios to 2^33") == 0;
}

/* @return 1 when the library refuses a scene */
static int judge_evaluation(const glint_evaluation *evaluation, contract_depth sums[CONTRACT_DEPTHS]) {
    static random_scene scene;
    int failed = 0;
    for (uint64_t seed = 1; seed <= SCENES; seed++)
        for (unsigned region = 0; region < random_region_count; region++) {
            contract_result result;
            if (!is_deep(&random_regions[region]))
                continue;
            random_scene_make_in(&scene, region, seed);
            for (uint32_t i = 0; i < scene.scene.object_count; i++)
                scene.objects[i].evaluation = evaluation;
            contract_judge_closely(&scene.scene, scene.width, scene.height, &glint_format_rgb888, &result);
            failed |= result.found.status != GLINT_OK;
            for (int i = 0; i < CONTRACT_DEPTHS; i++)
                add(&sums[i], &result.depths[i]);
        }
    return failed;
}

int main(void) {
    int failed = 0;
    puts("evaluation,log2_ratio,pixels,mean_lsb8,max_lsb8,depth_percent");
    for (size_t kind = 0; kind < sizeof evaluations / sizeof *evaluations; kind++) {
        contract_depth sums[CONTRACT_DEPTHS] = {{0}};
        failed |= judge_evaluation(evaluations[kind].evaluation, sums);
        for (int i = 0; i < CONTRACT_DEPTHS; i++) {
            const contract_depth *const at = &sums[i];
            if (at->pixels >= LEAST_PIXELS)
                printf("%s,%d,%ld,%.3f,%.2f,%.4f\n", evaluations[kind].name, i, at->pixels,
                       at->sum / (double)at->pixels, at->worst, 100 * at->apart / (double)at->pixels);
        }
    }
    return failed || ferror(stdout) || fflush(stdout);
}
