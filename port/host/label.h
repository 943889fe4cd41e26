/* SPDX-License-Identifier: MIT */
/**
 * @file label.h
 * Words beside a picture's subject, drawn over the finished picture.
 */
#ifndef GLINT_HOST_LABEL_H
#define GLINT_HOST_LABEL_H

#include "scenes/scenes.h"

/** A picture as png_encode takes it: rows from top to bottom without padding, `channels` bytes a pixel. */
typedef struct label_picture {
    uint8_t *pixels;
    uint32_t width, height;
    uint32_t channels; /**< 1 for grey, 3 for red, green, blue. */
} label_picture;

/**
 * Draws labels: white text of 5x8 pixels a character on a black plate with a margin of a pixel, and white leader lines
 * with a black edge that end in a dot, all lines below all plates. Black and white are levels of every pixel format.
 * Where the picture has another size than the labels are composed for, their places move as the camera moves its
 * subject: scaled by the height about the middle. Text keeps its size, and is moved inside where it would leave the
 * picture. A '\n' begins a new line; what is not printable ASCII is drawn as a box.
 * @param width, height what the labels are composed for, above 0
 */
void label_draw(const label_picture *picture, const example_label *labels, uint32_t count, uint16_t width,
                uint16_t height);

/** Pixels from a character to the next one, and from a line to the next one, at scale 1. */
#define LABEL_COLUMN 6
#define LABEL_LINE 9

/**
 * Writes a line of text whose upper left corner is (x, y), each pixel of it `scale` pixels wide, without a plate. What
 * lies beyond the picture is cut off.
 * @param colour `channels` levels
 */
void label_text(const label_picture *picture, const char *text, int x, int y, int scale, const uint8_t *colour);

/** Fills a rectangle, as far as it lies in the picture. */
void label_fill(const label_picture *picture, int x, int y, int width, int height, const uint8_t *colour);

#endif
