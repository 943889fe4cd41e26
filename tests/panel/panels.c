/* SPDX-License-Identifier: MIT */
#include "panels.h"

#include "panel/gc9a01.h"
#include "panel/ili9341.h"
#include "panel/ili9488.h"
#include "panel/sh1106.h"
#include "panel/ssd0303.h"
#include "panel/ssd0323.h"
#include "panel/ssd1306.h"
#include "panel/ssd1351.h"
#include "panel/st7567.h"
#include "panel/st7735.h"
#include "panel/st7789.h"

#include <string.h>

const tested_panel tested_panels[] = {
    {&glint_panel_ili9341, "ili9341", {16, 24}, 1, 11},
    {&glint_panel_st7789_240x240, "st7789-240x240", {16, 12, 24}, 1, 11},
    {&glint_panel_st7789_240x320, "st7789-240x320", {16, 12, 24}, 1, 11},
    {&glint_panel_st7789_135x240, "st7789-135x240", {16, 12, 24}, 1, 11},
    {&glint_panel_st7735_green, "st7735-green", {16, 12, 24}, 1, 11},
    {&glint_panel_st7735_red, "st7735-red", {16, 12, 24}, 1, 11},
    {&glint_panel_st7735_black, "st7735-black", {16, 12, 24}, 1, 11},
    {&glint_panel_gc9a01, "gc9a01", {16, 12, 24}, 1, 11},
    {&glint_panel_ssd0323, "ssd0323", {4}, 0, 6},
    {&glint_panel_ssd1306, "ssd1306", {1}, 1, 6},
    {&glint_panel_ssd1351, "ssd1351", {16}, 1, 7},
    {&glint_panel_ili9488, "ili9488", {24}, 1, 11},
    {&glint_panel_sh1106, "sh1106", {1}, 1, 3, 1},
    {&glint_panel_ssd0303, "ssd0303", {1}, 1, 3, 1},
    {&glint_panel_st7567, "st7567", {1}, 1, 3, 1},
};

const unsigned tested_panel_count = sizeof tested_panels / sizeof tested_panels[0];

int panels_take(const tested_panel *panel, unsigned bits) {
    return memchr(panel->bits, (int)bits, sizeof panel->bits) != NULL;
}

const tested_panel *panels_find(const char *module) {
    const tested_panel *panel = tested_panels;

    while (strcmp(panel->module, module) != 0) {
        panel++;
    }
    return panel;
}

void panels_find_on_glass(const glint_panel_type *type, unsigned quarters, int x, int y, int glass[2]) {
    const int right = type->width - 1;
    const int bottom = type->height - 1;
    const int across[4] = {x, right - y, right - x, y};
    const int down[4] = {y, x, bottom - y, bottom - x};

    glass[0] = across[quarters];
    glass[1] = down[quarters];
}

int panels_is_seen(const tested_panel *panel, int x, int y) {
    const int across = 2 * x + 1 - panel->type->width;
    const int down = 2 * y + 1 - panel->type->height;

    return !(panel->type->glass & GLINT_PANEL_ROUND) ||
           across * across + down * down <= panel->type->width * panel->type->width;
}
