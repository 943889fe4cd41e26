/* SPDX-License-Identifier: MIT */
/** @file measure.h Holds a drawing of the host program against the reference. */
#ifndef GLINT_WEB_MEASURE_H
#define GLINT_WEB_MEASURE_H

#include "framebuffer.h"
#include "settings.h"

/** Sums over the pixels that the reference covers, but for those that the suites' judge leaves out. */
typedef struct measured_errors {
    double squares; /**< Of the channels' errors, levels as 0 to 1. */
    double samples; /**< Channels of pixels. */
    double worst;   /**< Steps of the format. */
} measured_errors;

/** What settings say of a configuration, but for arena and flush. */
glint_config measure_configuration(const host_settings *settings);

/**
 * The distance of each pixel from the unrounded reference: of its worst channel, steps of the format. A dithered pixel
 * counts from its own threshold; one that is left out has 0.
 * @param target what was drawn of `scene`
 * @param same not 0: the reference is shaded in the same way; 0: lit at each pixel, for a local viewer
 * @return the pixels' errors, row by row, which the caller frees; null where the scene has too many objects, or is not
 * what the reference draws: with samples, fog, or objects that blend
 */
float *measure_errors(const glint_scene *scene, const host_settings *settings, const framebuffer *target, int same,
                      measured_errors *sums);

#endif
