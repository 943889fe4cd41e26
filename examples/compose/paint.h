/* SPDX-License-Identifier: MIT */
/** @file paint.h Shapes and text of 16-bit pixels, high byte first, on a tile, in screen coordinates: what lies outside
 * it is left out.
 */
#ifndef COMPOSE_PAINT_H
#define COMPOSE_PAINT_H

#include "glint.h"

/** Columns and rows of a letter, and from one to the next. */
#define PAINT_LETTER_WIDTH 3
#define PAINT_LETTER_HEIGHT 5
#define PAINT_LETTER_STEP 4

/** Fills a rectangle with 5, 6, 5 bits. */
void paint_rectangle(const glint_tile *tile, int x, int y, int width, int height, uint32_t colour);

/** Writes digits, capitals and spaces, each pixel of a letter as large as `scale`. */
void paint_text(const glint_tile *tile, int x, int y, int scale, uint32_t colour, const char *text);

#endif
