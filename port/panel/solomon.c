/* SPDX-License-Identifier: MIT */
#include "solomon.h"

enum { DISPLAY_ON = 0xaf };

static const uint8_t recover[] = {GLINT_PANEL_SOLOMON_RECOVER};

static glint_status switch_on(const glint_panel *panel) {
    static const uint8_t on = DISPLAY_ON;

    return glint_panel_send(panel, &on, 1);
}

static glint_status send_range(const glint_panel *panel, uint8_t command, int first, int last) {
    uint8_t bytes[3];

    bytes[0] = command;
    bytes[1] = (uint8_t)first;
    bytes[2] = (uint8_t)last;
    return glint_panel_send(panel, bytes, sizeof bytes);
}

/* ---- Grey and colour: columns and rows -------------------------------------------------------------------------- */

enum { SET_COLUMNS = 0x15, WRITE = 0x5c, SET_ROWS = 0x75, REMAP = 0xa0 };

/* Columns are counted in bytes, that is in pairs of pixels. Data needs no command of its own. */
static glint_status window_grey(const glint_panel *panel, int left, int top, int right, int bottom) {
    const glint_status status = send_range(panel, SET_COLUMNS, left / 2, right / 2);

    return status ? status : send_range(panel, SET_ROWS, top, bottom);
}

const glint_panel_family glint_panel_solomon_grey = {switch_on, window_grey, recover, 1};

enum {
    REMAP_ROW_BY_ROW = 0,
    REMAP_DOWNWARDS = 1 << 0, /* addresses advance down a column first */
    REMAP_COLUMNS = 1 << 1,
    REMAP_COLOURS = 1 << 2, /* red first */
    REMAP_ROWS = 1 << 4,
    REMAP_SPLIT = 1 << 5, /* odd and even lines come from two sides */
    REMAP_65K = 1 << 6,
};

static glint_status set_up_colour(const glint_panel *panel) {
    const glint_panel_axes axes = glint_panel_find_axes(panel);
    uint8_t bytes[2];
    glint_status status;

    bytes[0] = REMAP;
    bytes[1] =
        (uint8_t)(REMAP_65K | REMAP_SPLIT | (panel->type->glass & GLINT_PANEL_BGR ? 0u : (unsigned)REMAP_COLOURS) |
                  (axes.mirror_x ? REMAP_COLUMNS : 0u) | (axes.mirror_y ? REMAP_ROWS : 0u) |
                  (axes.exchanged ? REMAP_DOWNWARDS : REMAP_ROW_BY_ROW));
    status = glint_panel_send(panel, bytes, sizeof bytes);
    return status ? status : switch_on(panel);
}

static glint_status window_colour(const glint_panel *panel, int left, int top, int right, int bottom) {
    const glint_panel_axes axes = glint_panel_find_axes(panel);
    static const uint8_t write = WRITE;
    glint_status status = send_range(panel, axes.exchanged ? SET_ROWS : SET_COLUMNS, left, right);

    if (!status) {
        status = send_range(panel, axes.exchanged ? SET_COLUMNS : SET_ROWS, top, bottom);
    }
    return status ? status : glint_panel_send(panel, &write, 1);
}

/* Parameters come with D/C high: a command ends the one before. */
static const uint8_t no_recovery = GLINT_PANEL_END;

const glint_panel_family glint_panel_solomon_colour = {set_up_colour, window_colour, &no_recovery, 0};
