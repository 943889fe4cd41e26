/* SPDX-License-Identifier: MIT */
/** @file truth.h Draws what pictures are held against. */
#ifndef CHART_TRUTH_H
#define CHART_TRUTH_H

#include "library_geometry.h"
#include "picture.h"

#include <stdio.h>
#include <stdlib.h>

/**
 * Draws a scene in double precision, on the positions to which the library snaps its vertices; ends the program where
 * the library refuses the scene. @return depth steps per 1/w
 */
static inline double truth_draw(const reference_image *image, const glint_scene *scene) {
    picture blank = picture_open(image->width, image->height, &glint_format_rgb565);
    const glint_config config = picture_config(&blank, NULL);
    library_geometry geometry;

    if (library_geometry_open(&geometry, &config, scene) != GLINT_OK) {
        fputs("the library refuses a scene\n", stderr);
        exit(1);
    }
    reference_render(image, scene, (const reference_position *const *)geometry.positions);
    const double depth_scale = geometry.depth_scale;
    library_geometry_close(&geometry);
    picture_close(&blank);
    return depth_scale;
}

#endif
