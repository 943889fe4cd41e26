/* SPDX-License-Identifier: MIT */
#include "solomon.h"

enum { SET_COLUMNS = 0x15, SET_ROWS = 0x75 };

/* Columns are counted in bytes, that is in pairs of pixels. Data needs no command of its own. */
static int window(const glint_bus *bus, int left, int top, int right, int bottom) {
    uint8_t bytes[6];

    bytes[0] = SET_COLUMNS;
    bytes[1] = (uint8_t)(left / 2);
    bytes[2] = (uint8_t)(right / 2);
    bytes[3] = SET_ROWS;
    bytes[4] = (uint8_t)top;
    bytes[5] = (uint8_t)bottom;
    return bus->command(bus->context, bytes, sizeof bytes);
}

const glint_panel_family glint_panel_solomon_grey = {window, 1};
