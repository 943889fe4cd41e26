/* SPDX-License-Identifier: MIT */
/**
 * @file png.h
 * PNG pictures (ISO/IEC 15948), 8 bits a channel.
 */
#ifndef GLINT_HOST_PNG_H
#define GLINT_HOST_PNG_H

#include "output.h"

/**
 * Appends a picture as a PNG file. The same pixels always give the same bytes.
 * @param pixels rows from top to bottom without padding, `channels` bytes a pixel
 * @param channels 1 for grey, 3 for red, green, blue
 */
void png_encode(host_bytes *out, const uint8_t *pixels, uint32_t width, uint32_t height, uint32_t channels);

#endif
