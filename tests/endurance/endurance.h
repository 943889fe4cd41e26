/* SPDX-License-Identifier: MIT */
/** @file endurance.h The example scenes in turn, turning for a long time: the same code on the host and on a board. */
#ifndef GLINT_TESTS_ENDURANCE_H
#define GLINT_TESTS_ENDURANCE_H

#include "glint.h"

/** Size of the screen; small, so that many frames take little time. */
#define ENDURANCE_WIDTH 64
#define ENDURANCE_HEIGHT 48

/**
 * Draws revolutions of the example scenes, each variant in turn, by one renderer that keeps its arena, until at least
 * `frames` frames are drawn. Writes a line for each first revolution, with its checksum, and one for each later
 * revolution whose checksum differs from the first one's; last, how many frames were drawn and revolutions differed.
 * @return how many revolutions differed or failed
 */
uint32_t endurance_run(uint32_t frames, void (*write)(const char *text));

#endif
