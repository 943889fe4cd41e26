/* SPDX-License-Identifier: MIT */
/** @file plain_raster.h Edge functions as a first attempt has them: what such a renderer covers. */
#ifndef GLINT_STABILITY_PLAIN_RASTER_H
#define GLINT_STABILITY_PLAIN_RASTER_H

#include "random_scene.h"

enum {
    PLAIN_INCLUSIVE = 1, /**< Edges belong to both sides. */
    PLAIN_PIXELS = 2,    /**< Vertices are rounded to whole pixels, not to sixteenths. */
    PLAIN_WRAP = 4,      /**< Screen positions wrap in int16. */
    PLAIN_UNCLIPPED = 8, /**< What is behind the eye is projected too; else such triangles are left out. */
    PLAIN_WINDING = 16   /**< Mirrors do not turn the test for front faces. */
};

/** Compared with the reference's coverage. */
typedef struct plain_coverage {
    long drawn; /**< Pixels, each time they are. */
    long wrong; /**< Covered by one of the two. */
    long twice; /**< Beyond the first time, where the reference covers. */
} plain_coverage;

plain_coverage plain_cover(const random_scene *s, unsigned flags);

#endif
