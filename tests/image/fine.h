/* SPDX-License-Identifier: MIT */
/** @file fine.h A format of one channel, red, in 2^-16 of the levels that RGB888 has. */
#ifndef GLINT_FINE_H
#define GLINT_FINE_H

#include "picture.h"

extern const glint_format glint_format_fine;

/** The level of a pixel, counted row by row. */
double fine_level(const picture *image, int pixel);

#endif
