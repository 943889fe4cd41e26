/* SPDX-License-Identifier: MIT */
/*
 * Commands: SSD0303 Rev 1.3 (Jul 2005), SSD1306 Rev 1.5 (Aug 2010), section 8.7, and SH1106 V2.3 have them alike;
 * ST7567 V1.4 has those that are used here.
 */
#include "pages.h"

#include "solomon.h"

enum { SEGMENTS = 0xa0, NORMAL = 0xa6, DISPLAY_ON = 0xaf, SCAN = 0xc0 };

enum { IS_REVERSED = 1, IS_INVERSE = 1, SCAN_REVERSED = 8 };

static const uint8_t recover[] = {GLINT_PANEL_SOLOMON_RECOVER};

static glint_status switch_on(const glint_panel *panel) {
    static const uint8_t on = DISPLAY_ON;

    return glint_panel_send(panel, &on, 1);
}

/* How columns and rows run: two commands. */
static void put_directions(const glint_panel_axes *axes, uint8_t bytes[2]) {
    bytes[0] = axes->mirror_x ? SEGMENTS | IS_REVERSED : SEGMENTS;
    bytes[1] = axes->mirror_y ? SCAN | SCAN_REVERSED : SCAN;
}

/* ---- Page by page ----------------------------------------------------------------------------------------------- */

enum { SET_COLUMN_LOW = 0x00, SET_COLUMN_HIGH = 0x10, SET_PAGE = 0xb0 };

static glint_status set_up_pages(const glint_panel *panel) {
    const glint_panel_axes axes = glint_panel_find_axes(panel);
    uint8_t bytes[3];
    glint_status status;

    put_directions(&axes, bytes);
    bytes[2] = panel->type->glass & GLINT_PANEL_INVERTED ? NORMAL | IS_INVERSE : NORMAL;
    status = glint_panel_send(panel, bytes, sizeof bytes);
    return status ? status : switch_on(panel);
}

static glint_status set_place(const glint_panel *panel, int page, int column) {
    uint8_t bytes[3];

    bytes[0] = (uint8_t)(SET_PAGE + page);
    bytes[1] = (uint8_t)(SET_COLUMN_LOW | (column & 15));
    bytes[2] = (uint8_t)(SET_COLUMN_HIGH | column >> 4);
    return glint_panel_send(panel, bytes, sizeof bytes);
}

/* Turned by a quarter, the 8 pixels of a byte lie along a row of the picture: a page is a column of bytes. */
static glint_status send_pages(const glint_panel *panel, int x, int y, int width, int height, const uint8_t *pixels,
                               size_t stride) {
    const glint_bus *bus = panel->bus;
    const glint_panel_axes axes = glint_panel_find_axes(panel);
    const int first = (axes.exchanged ? axes.first_x + x : axes.first_y + y) / 8;
    const int last = first + (axes.exchanged ? width : height) / 8 - 1;
    const int column = axes.exchanged ? axes.first_y + y : axes.first_x + x;
    glint_status status = GLINT_OK;

    for (int page = first; page <= last && !status; page++) {
        status = set_place(panel, page, column);
        if (!status && axes.exchanged) {
            status = bus->begin(bus->context, pixels, 1, (size_t)height, stride);
            pixels++;
        } else if (!status) {
            status = bus->begin(bus->context, pixels, (size_t)width, 1, (size_t)width);
            pixels += 8 * stride;
        }
        if (!status && page < last) {
            status = glint_panel_wait(panel);
        }
    }
    return status;
}

const glint_panel_family glint_panel_pages = {set_up_pages, NULL, recover, 1, send_pages};

/* ---- Windows ---------------------------------------------------------------------------------------------------- */

enum { SET_MODE = 0x20, MODE_ACROSS = 0, MODE_DOWN = 1, SET_COLUMNS = 0x21, SET_PAGES = 0x22 };

static glint_status set_up_window(const glint_panel *panel) {
    const glint_panel_axes axes = glint_panel_find_axes(panel);
    uint8_t bytes[4];
    glint_status status;

    put_directions(&axes, bytes);
    bytes[2] = SET_MODE;
    bytes[3] = axes.exchanged ? MODE_DOWN : MODE_ACROSS;
    status = glint_panel_send(panel, bytes, sizeof bytes);
    return status ? status : switch_on(panel);
}

static glint_status send_range(const glint_panel *panel, uint8_t command, int first, int last) {
    uint8_t bytes[3];

    bytes[0] = command;
    bytes[1] = (uint8_t)first;
    bytes[2] = (uint8_t)last;
    return glint_panel_send(panel, bytes, sizeof bytes);
}

/* Turned by a quarter, columns count the picture's rows. */
static glint_status window(const glint_panel *panel, int left, int top, int right, int bottom) {
    const int is_turned = glint_panel_find_axes(panel).exchanged;
    const glint_status status = send_range(panel, SET_COLUMNS, is_turned ? top : left, is_turned ? bottom : right);

    return status ? status
                  : send_range(panel, SET_PAGES, (is_turned ? left : top) / 8, (is_turned ? right : bottom) / 8);
}

const glint_panel_family glint_panel_pages_window = {set_up_window, window, recover, 1};
