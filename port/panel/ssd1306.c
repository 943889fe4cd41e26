/* SPDX-License-Identifier: MIT */
#include "ssd1306.h"

#include "pages.h"

/*
 * Pages and the order of bits: SSD1306 Rev 1.5 (Aug 2010), section 8.7. Clock: 10 MHz by the data of a module (EA
 * OLEDS102-6, page 5). The other values are those that public drivers send to modules of 128x64 with a charge pump;
 * they were not checked against the data sheet.
 */
static const uint8_t start[] = {
    GLINT_PANEL_SEND(1), 0xae,       /* display off */
    GLINT_PANEL_SEND(2), 0xd5, 0x80, /* oscillator and divider */
    GLINT_PANEL_SEND(2), 0xa8, 63,   /* 64 lines */
    GLINT_PANEL_SEND(2), 0xd3, 0,    /* the glass begins at the first */
    GLINT_PANEL_SEND(1), 0x40,       /* start line 0 */
    GLINT_PANEL_SEND(2), 0x8d, 0x14, /* charge pump on */
    GLINT_PANEL_SEND(2), 0xda, 0x12, /* odd and even lines alternate */
    GLINT_PANEL_SEND(2), 0x81, 0xcf, /* contrast */
    GLINT_PANEL_SEND(2), 0xd9, 0xf1, /* precharge */
    GLINT_PANEL_SEND(2), 0xdb, 0x40, /* level of lines not selected */
    GLINT_PANEL_SEND(1), 0xa4,       /* show memory */
    GLINT_PANEL_SEND(1), 0xa6,       /* not inverted */
    GLINT_PANEL_END,
};

const glint_panel_type glint_panel_ssd1306 = {
    .family = &glint_panel_pages_window,
    .format = &glint_format_mono_pages_dithered,
    .format_turned = &glint_format_mono_dithered,
    .start = start,
    .width = 128,
    .height = 64,
    .memory_width = 128,
    .memory_height = 64,
    .glass = GLINT_PANEL_MIRRORED_X | GLINT_PANEL_MIRRORED_Y | GLINT_PANEL_PAGES,
    .bits = {1},
    .reset_low_ms = 1,
    .reset_wait_ms = 1,
    .clock_max = 10000000,
};
