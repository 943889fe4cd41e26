/* SPDX-License-Identifier: MIT */
#include "solomon.h"

enum { DISPLAY_ON = 0xaf, NO_OPERATION = 0xe3 };

/*
 * Where parameters go as commands do, a command that a fault cut short would take what follows for its parameters. None
 * has more than 8.
 */
static const uint8_t recover[] = {
    GLINT_PANEL_SEND(8), NO_OPERATION, NO_OPERATION, NO_OPERATION, NO_OPERATION,
    NO_OPERATION,        NO_OPERATION, NO_OPERATION, NO_OPERATION, GLINT_PANEL_END,
};

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

/* ---- One bit: columns and pages --------------------------------------------------------------------------------- */

enum { SET_MODE = 0x20, MODE_ACROSS = 0, MODE_DOWN = 1, SET_PAGE_COLUMNS = 0x21, SET_PAGES = 0x22 };

enum { SEGMENTS = 0xa0, SEGMENTS_REVERSED = 0xa1, SCAN = 0xc0, SCAN_REVERSED = 0xc8 };

static glint_status set_up_mono(const glint_panel *panel) {
    const glint_panel_axes axes = glint_panel_find_axes(panel);
    uint8_t bytes[4];
    glint_status status;

    bytes[0] = axes.mirror_x ? SEGMENTS_REVERSED : SEGMENTS;
    bytes[1] = axes.mirror_y ? SCAN_REVERSED : SCAN;
    bytes[2] = SET_MODE;
    bytes[3] = axes.exchanged ? MODE_DOWN : MODE_ACROSS;
    status = glint_panel_send(panel, bytes, sizeof bytes);
    return status ? status : switch_on(panel);
}

/* Turned by a quarter, the 8 pixels of a byte lie along a row of the picture, and columns count its rows. */
static glint_status window_mono(const glint_panel *panel, int left, int top, int right, int bottom) {
    const int is_turned = glint_panel_find_axes(panel).exchanged;
    const glint_status status = send_range(panel, SET_PAGE_COLUMNS, is_turned ? top : left, is_turned ? bottom : right);

    return status ? status
                  : send_range(panel, SET_PAGES, (is_turned ? left : top) / 8, (is_turned ? right : bottom) / 8);
}

const glint_panel_family glint_panel_solomon_mono = {set_up_mono, window_mono, recover, 1};
