/* SPDX-License-Identifier: MIT */
/**
 * @file cost.h
 * What a board would take for a frame that was drawn here: a price for each item that it consists of, fitted to frames
 * counted in an emulator (`make prices`). Milliseconds follow from a model of cycles. Neither is validated on silicon.
 */
#ifndef GLINT_HOST_COST_H
#define GLINT_HOST_COST_H

#include "counts.h"

/** Prints instructions and milliseconds on each core, a name and a value a line; of frames of one pass only. */
void cost_print(const frame_counts *counts);

#endif
