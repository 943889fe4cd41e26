/* SPDX-License-Identifier: MIT */
/** @file colour.h Colours that were interpolated over w. */
#ifndef GLINT_COLOUR_H
#define GLINT_COLOUR_H

#include "shade.h"

/** Fragment i's colour, 1 = GLINT_COLOUR_ONE, from its planes; off by at most 4 steps. */
void glint_resolve_colour(const glint_fragments *fragments, uint32_t i, const glint_plane planes[3], int16_t out[3]);

/** The same beyond a triangle, where it may be below 0 or above 1: Q14, cut off at 2. */
void glint_extend_colour(const glint_fragments *fragments, uint32_t i, const glint_plane planes[3], int16_t out[3]);

#endif
