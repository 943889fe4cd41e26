/* SPDX-License-Identifier: MIT */
/** @file identity.h Checksums of frames, drawn in every way that must not change a pixel. */
#ifndef GLINT_TESTS_IDENTITY_H
#define GLINT_TESTS_IDENTITY_H

/**
 * Writes a line for each frame and way to draw it: "torus576 3 grey4 | tile 8x16 smallest | 0123abcd". Lines that agree
 * in the first part must agree in the last, whatever the second is and wherever this runs.
 * @return the number of frames that could not be drawn.
 */
int identity_run(void (*write)(const char *text));

#endif
