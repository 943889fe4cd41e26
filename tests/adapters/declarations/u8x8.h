/* SPDX-License-Identifier: MIT */
/* Of u8g2's device layer what the adapter uses. */
#ifndef U8X8_H
#define U8X8_H

#include <stdint.h>

typedef struct u8x8_struct u8x8_t;

uint8_t u8x8_DrawTile(u8x8_t *u8x8, uint8_t x, uint8_t y, uint8_t cnt, uint8_t *tile_ptr);

#endif
