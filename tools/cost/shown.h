/* SPDX-License-Identifier: MIT */
/** @file shown.h Names the workloads that docs/cost.md shows: torus576 at 320x240, by default. */
#ifndef GLINT_COST_SHOWN_H
#define GLINT_COST_SHOWN_H

#include "../bench/workloads.h"

/** The look, then the format. */
static const char *const cost_shown[][2] = {
    {"", ""},
    {"unlit", ""},
    {"per facet", ""},
    {"per vertex", ""},
    {"phong", ""},
    {"max", ""},
    {"mesh colours", ""},
    {"textured", ""},
    {"textured unlit", ""},
    {"textured unlit bilinear", ""},
    {"opacity", ""},
    {"added", ""},
    {"opacity dithered", ""},
    {"fog", ""},
    {"fog squared", ""},
    {"2x2 samples", ""},
    {"2x2 samples", "rgb565 dithered"},
    {"p 8", ""},
    {"p 256", ""},
    {"2 directional", ""},
    {"1 point", ""},
    {"4 points", ""},
    {"8 points", ""},
    {"1 spot", ""},
    {"4 spots", ""},
    {"8 spots", ""},
    {"", "rgb444"},
    {"", "rgb888"},
    {"", "rgb444 dithered"},
    {"", "grey8"},
    {"", "grey4"},
    {"", "grey4 dithered"},
    {"", "mono"},
    {"", "mono dithered"},
    {"", "rgb565 dithered"},
};

enum { COST_SHOWN = sizeof cost_shown / sizeof cost_shown[0] };

static inline int cost_same_text(const char *a, const char *b) {
    while (*a && *a == *b) {
        a++, b++;
    }
    return *a == *b;
}

static inline int cost_is_shown(const workload *drawn) {
    for (size_t i = 0; i < COST_SHOWN; i++) {
        if (cost_same_text(drawn->look, cost_shown[i][0]) && cost_same_text(drawn->output->name, cost_shown[i][1])) {
            return drawn->width == 320 && cost_same_text(drawn->scene, "torus576");
        }
    }
    return 0;
}

#endif
