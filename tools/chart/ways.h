/* SPDX-License-Identifier: MIT */
/**
 * @file ways.h
 * Every way to light, for the charts of errors over instructions: each choice of shading under each number and kind of
 * lights, of the torus of 576 triangles at 320x240, and in the benchmark's own light of that of 2304. Frames are the
 * same on the host, which measures errors, and on boards, which count instructions.
 */
#ifndef CHART_WAYS_H
#define CHART_WAYS_H

#include "../bench/workloads.h"
#include "choices.h"

/** Scenes: first that of 2304 triangles, then one for each number and kind of lights. */
#define WAYS_SCENES (1 + WORKLOADS_LIGHTS)

static inline workload ways_scene(uint32_t number) {
    return number == 0 ? workload_get(0) : workload_get_lights(number - 1);
}

/** What lights are called. */
static inline const char *ways_lights(const workload *drawn) {
    return *drawn->look ? drawn->look : "1 directional";
}

/** Builds a scene's first frame, to be drawn as chosen. @return 0, or 1 after an error */
static inline int ways_build(workload_stage *stage, const workload *built, const choice *chosen) {
    if (workload_build(stage, built)) {
        return 1;
    }
    choose(chosen, &stage->example.scene, &stage->example.objects[0], &stage->example.materials[0]);
    return 0;
}

#endif
