/* SPDX-License-Identifier: MIT */
/**
 * @file level_set.h
 * The levels that a pixel may have where surfaces are blended or lie in fog. Each step stores whole levels, and the
 * next one reads them: so each surface gives the levels that the contract leaves it, and what is mixed of two sets is
 * exact. Nothing else is left to rounding but the depth from which fog is found.
 */
#ifndef GLINT_LEVEL_SET_H
#define GLINT_LEVEL_SET_H

#include "glint.h"
#include "reference.h"

/** More alternatives are not told apart: then the set is empty. */
#define LEVEL_SET_MAX 25

/** Alternatives, as of several texels: each has the levels from `least` to `most`, channel by channel. */
typedef struct level_set {
    int count;
    uint8_t least[LEVEL_SET_MAX][3], most[LEVEL_SET_MAX][3];
} level_set;

/** A pixel of a format. */
typedef struct level_place {
    int channels, most[3]; /**< Most levels. */
    double threshold;      /**< What is added before a number is cut off. */
    double coarse;         /**< Steps to which opacity, in 256ths, is rounded once more, or 0. */
} level_place;

/** A part of something that is known from least to most. */
typedef struct level_share {
    double least, most;
} level_share;

level_place level_place_of(const glint_format *format, int x, int y);

/** Sets the levels of a surface that may be `slack` off before it is stored. */
void level_set_surface(level_set *to, const level_place *at, const reference_pixel *pixel, double slack);

/** Sets levels that are known. */
void level_set_known(level_set *to, const level_place *at, const int level[3]);

/** Mixes: share `part` of `over` and the rest of `set`; or, where it adds, `set` and share `part` of `over`. */
void level_set_mix(level_set *set, const level_place *at, const level_set *over, level_share part, int adds);

/** Returns by how many levels, at least, what is stored lies outside of a set that is not empty. */
int level_set_distance(const level_set *set, const level_place *at, const int level[3]);

#endif
