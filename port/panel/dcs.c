/* SPDX-License-Identifier: MIT */
/*
 * Commands and bits as in ST7735 V1.7 (2009-12-04), pages 78, 99, 103 and 109, ST7735R V0.2 (2009-08-05), pages 54 and
 * 62, and ILI9341, page 92 of 233.
 */
#include "dcs.h"

enum {
    SOFTWARE_RESET = 0x01,
    INVERT = 0x21,
    DISPLAY_ON = 0x29,
    COLUMNS = 0x2a,
    ROWS = 0x2b,
    WRITE = 0x2c,
    MEMORY_ACCESS = 0x36,
    PIXEL_FORMAT = 0x3a,
};

enum { ACCESS_BGR = 1 << 3, ACCESS_EXCHANGE = 1 << 5, ACCESS_MIRROR_X = 1 << 6, ACCESS_MIRROR_Y = 1 << 7 };

/* A pixel of 18 bits is three bytes, of which the lower two bits are not read. */
enum { FORMAT_12_BITS = 0x33, FORMAT_16_BITS = 0x55, FORMAT_18_BITS = 0x66 };

static const uint8_t recover[] = {
    GLINT_PANEL_SEND(1),
    SOFTWARE_RESET,
    GLINT_PANEL_DELAY(GLINT_PANEL_DCS_WAKE_MS),
    GLINT_PANEL_END,
};

static glint_status send_value(const glint_panel *panel, uint8_t command, uint8_t value) {
    uint8_t bytes[2];

    bytes[0] = command;
    bytes[1] = value;
    return glint_panel_send(panel, bytes, 2);
}

static glint_status send_one(const glint_panel *panel, uint8_t command) {
    return glint_panel_send(panel, &command, 1);
}

/* The format register's value for pixels as long as the panel's; 0 where the command set has none. */
static uint8_t find_format(const glint_panel *panel) {
    switch (glint_panel_pixel_bits(panel)) {
    case 12:
        return FORMAT_12_BITS;
    case 16:
        return FORMAT_16_BITS;
    case 24:
        return FORMAT_18_BITS;
    default:
        return 0;
    }
}

static glint_status set_up(const glint_panel *panel) {
    const uint8_t format = find_format(panel);
    const glint_panel_axes axes = glint_panel_find_axes(panel);
    const unsigned access = (axes.exchanged ? ACCESS_EXCHANGE : 0u) | (axes.mirror_x ? ACCESS_MIRROR_X : 0u) |
                            (axes.mirror_y ? ACCESS_MIRROR_Y : 0u) |
                            (panel->type->glass & GLINT_PANEL_BGR ? ACCESS_BGR : 0u);
    glint_status status = format ? send_value(panel, MEMORY_ACCESS, (uint8_t)access) : GLINT_ERROR_FORMAT;

    if (!status) {
        status = send_value(panel, PIXEL_FORMAT, format);
    }
    if (!status && (panel->type->glass & GLINT_PANEL_INVERTED)) {
        status = send_one(panel, INVERT);
    }
    return status ? status : send_one(panel, DISPLAY_ON);
}

static glint_status send_range(const glint_panel *panel, uint8_t command, unsigned first, unsigned last) {
    uint8_t bytes[5];

    bytes[0] = command;
    bytes[1] = (uint8_t)(first >> 8);
    bytes[2] = (uint8_t)first;
    bytes[3] = (uint8_t)(last >> 8);
    bytes[4] = (uint8_t)last;
    return glint_panel_send(panel, bytes, sizeof bytes);
}

static glint_status window(const glint_panel *panel, int left, int top, int right, int bottom) {
    const glint_panel_axes axes = glint_panel_find_axes(panel);
    glint_status status = send_range(panel, COLUMNS, axes.first_x + (unsigned)left, axes.first_x + (unsigned)right);

    if (!status) {
        status = send_range(panel, ROWS, axes.first_y + (unsigned)top, axes.first_y + (unsigned)bottom);
    }
    return status ? status : send_one(panel, WRITE);
}

const glint_panel_family glint_panel_dcs = {set_up, window, recover, 0};
