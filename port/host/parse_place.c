/* SPDX-License-Identifier: MIT */
/**
 * @file parse_place.c
 * Options that say where a model is put, and how large.
 */
#include "parsers.h"

#include "number.h"
#include "values.h"

#include <math.h>
#include <string.h>

/** Smallest factor: takes the largest coordinate that is read to 1. */
#define SCALE_MIN 1e-30

bool parse_up_axis(host_settings *settings, const char *text, host_problem *problem) {
    settings->z_up = strcmp(text, "z") == 0;
    return settings->z_up || strcmp(text, "y") == 0 || value_expected(problem, "takes y or z");
}

bool parse_centre(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->centre = true;
    return true;
}

bool parse_scale(host_settings *settings, const char *text, host_problem *problem) {
    double *scale = settings->scale;
    settings->scale_fit = strcmp(text, "fit") == 0;
    if (settings->scale_fit) {
        return true;
    }
    bool ok = number_list(text, strlen(text), ',', 3, scale);
    if (!ok && number_list(text, strlen(text), ',', 1, scale)) {
        scale[1] = scale[2] = scale[0];
        ok = true;
    }
    for (int i = 0; ok && i < 3; i++) {
        ok = fabs(scale[i]) >= SCALE_MIN && fabs(scale[i]) <= NUMBER_Q16_MAX;
    }
    return ok || value_expected(problem, "takes fit, sx,sy,sz or one factor, each not 0 and from -32767 to 32767");
}

static bool parse_rotate(host_settings *settings, int axis, const char *text, host_problem *problem) {
    double value;
    if (!value_real(text, -NUMBER_Q16_MAX, NUMBER_Q16_MAX, &value)) {
        return value_expected(problem, "takes degrees from -32767 to 32767");
    }
    settings->rotate[axis] = number_q16(value);
    return true;
}

bool parse_rotate_x(host_settings *settings, const char *text, host_problem *problem) {
    return parse_rotate(settings, 0, text, problem);
}

bool parse_rotate_y(host_settings *settings, const char *text, host_problem *problem) {
    return parse_rotate(settings, 1, text, problem);
}

bool parse_rotate_z(host_settings *settings, const char *text, host_problem *problem) {
    return parse_rotate(settings, 2, text, problem);
}
