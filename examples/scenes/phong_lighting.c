/* SPDX-License-Identifier: MIT */
#include "stage.h"

static const example_variant variants[] = {{"plain", "Nothing yet."}};

static void build(example_stage *stage, uint32_t variant, uint32_t frame) {
    (void)variant;
    (void)frame;
    stage_clear(stage, (glint_colour)RGB(0, 0, 0));
}

const example_scene example_phong_lighting = {
    "phong-lighting", "Nothing yet.", variants, 1, 1, 320, 240, build,
};
