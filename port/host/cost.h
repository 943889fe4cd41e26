/* SPDX-License-Identifier: MIT */
/**
 * @file cost.h
 * What a board would take for a frame that was drawn here: a price for each item that it consists of, fitted to frames
 * counted in an emulator (`make prices`). Milliseconds follow from a model of cycles. Neither is validated on silicon.
 */
#ifndef GLINT_HOST_COST_H
#define GLINT_HOST_COST_H

#include "counts.h"

#include <stdbool.h>

/** What a core takes for a frame: negative where nothing is known of it. */
typedef struct cost_figures {
    const char *core;
    int mhz; /**< Its usual clock; 0 for none. */
    double instructions, cycles;
} cost_figures;

/** How many cores there are. */
size_t cost_cores(void);

/** What core `index` takes. @return false for a frame of several passes, of which nothing is known */
bool cost_find(const frame_counts *counts, size_t index, cost_figures *figures);

/** Prints instructions and milliseconds on each core, a name and a value a line; of frames of one pass only. */
void cost_print(const frame_counts *counts);

#endif
