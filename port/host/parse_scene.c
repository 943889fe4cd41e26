/* SPDX-License-Identifier: MIT */
/**
 * @file parse_scene.c
 * Options of the example scenes.
 */
#include "parsers.h"

#include "number.h"
#include "values.h"

#include <string.h>

/** Far more than any scene has; a number that every type holds. */
#define FRAME_MAX 1000000

/** Most frames of an animation: they are all in memory at once. */
#define ANIMATE_MAX 1000

bool parse_list(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->list = true;
    return true;
}

bool parse_labels(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->labels = true;
    return true;
}

bool parse_frame(host_settings *settings, const char *text, host_problem *problem) {
    int64_t value;
    if (!number_integer(text, strlen(text), &value) || value < 0 || value > FRAME_MAX) {
        return value_expected(problem, "takes a frame, from 0 to 1000000");
    }
    settings->frame_given = true;
    settings->frame = (uint32_t)value;
    return true;
}

bool parse_animate(host_settings *settings, const char *text, host_problem *problem) {
    int64_t value;
    if (!number_integer(text, strlen(text), &value) || value < 1 || value > ANIMATE_MAX) {
        return value_expected(problem, "takes a number of frames, from 1 to 1000");
    }
    settings->animate = (uint32_t)value;
    return true;
}
