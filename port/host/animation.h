/* SPDX-License-Identifier: MIT */
/**
 * @file animation.h
 * Pictures drawn one after the other: an animated PNG, or a PNG for each.
 */
#ifndef GLINT_HOST_ANIMATION_H
#define GLINT_HOST_ANIMATION_H

#include "settings.h"

/** What moves. */
typedef struct animation {
    /** Draws a frame, counted from 0. @return it as png_encode takes it, for the caller to free; null with a problem */
    uint8_t *(*draw)(void *context, uint32_t frame, host_problem *problem);
    void *context;
    uint32_t duration, rate; /**< It repeats after duration / rate seconds; each from 1 to 65535. */
} animation;

/**
 * Checks the options beside --animate, and the name of what is to be written; without --animate nothing.
 * @param command what a problem begins with
 * @return false with a problem
 */
bool animation_check(const host_settings *settings, const char *command, host_problem *problem);

/**
 * Draws as many frames as the settings say, and writes them: to one file, or to one each where its name has a %d. Of
 * those, the ones before a failure stay. Prints what is wrong.
 * @return exit status
 */
int animation_write(const animation *movie, const host_settings *settings);

#endif
