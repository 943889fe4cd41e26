/* SPDX-License-Identifier: MIT */
/** @file identity.h Checksums of frames, drawn in every way that must not change a pixel. */
#ifndef GLINT_TESTS_IDENTITY_H
#define GLINT_TESTS_IDENTITY_H

#include "glint.h"

typedef struct identity_format {
    const char *name;
    const glint_format *format;
} identity_format;

/**
 * Writes a line for each frame and way to draw it: "torus576 3 grey4 | tile 8x16 smallest | 0123abcd". Lines that agree
 * in the first part must agree in the last, whatever the second is and wherever this runs; "does not fit" stands where
 * the arena is too small.
 * @return the number of frames that could not be drawn for another reason
 */
int identity_run(void (*write)(const char *text));

/**
 * The same of the turntable's frames alone, in the formats that are chosen, the widest last: what boards without room
 * for the example scenes draw.
 */
int identity_run_turntable(void (*write)(const char *text), const identity_format *chosen, int count);

#endif
