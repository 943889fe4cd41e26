/* SPDX-License-Identifier: MIT */
/**
 * @file glint_u8g2.h
 * Monochrome displays through u8g2's device layer, u8x8, which needs no buffer of its own: glint_format_mono_pages,
 * a screen whose width and height are multiples of 8.
 */
#ifndef ADAPTER_U8G2_H
#define ADAPTER_U8G2_H

#include <glint.h>
#include <u8x8.h>

/** A display that is set up: `u8g2_GetU8x8(&u8g2)` after u8g2_InitDisplay and u8g2_SetPowerSave(.., 0). */
glint_flush adapter_u8x8_flush(u8x8_t *display);

#endif
