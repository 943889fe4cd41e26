/* SPDX-License-Identifier: MIT */
/** @file patterns.h Ways to draw to a panel, and a pattern that tells every pixel from its neighbours. */
#ifndef GLINT_PANEL_PATTERNS_H
#define GLINT_PANEL_PATTERNS_H

#include "panels.h"
#include "wire.h"

/** A way to draw to a panel. */
typedef struct way {
    const tested_panel *panel;
    glint_panel driver;
    unsigned bits;
} way;

/** A way with pixels of so many bits, as words or not. `line` carries it. */
way way_choose(const tested_panel *panel, const wire *line, unsigned rotation, unsigned bits, int has_words);

/** Fills a tile of `stride` bytes a row, cleared before where pixels have one bit, with the pattern at a rectangle. */
void pattern_fill(const way *to, uint8_t *tile, size_t stride, const int rectangle[4]);

/** What the glass ought to show of the pattern at (x, y). */
void pattern_expect(const way *to, int x, int y, uint8_t rgb[3]);

/** A level of so many bits, of 8. */
uint8_t pattern_expand(unsigned level, unsigned bits);

#endif
