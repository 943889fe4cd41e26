/* SPDX-License-Identifier: MIT */
#include "sh1106.h"

#include "pages.h"

/*
 * Memory of 132x64, of which modules of 128x64 show the middle: SH1106 V2.3 (block diagram, display data RAM). The
 * other values are those that public drivers send to modules of 128x64; they, the clock (a serial cycle of 250 ns) and
 * times were not checked against the data sheet.
 */
static const uint8_t start[] = {
    GLINT_PANEL_SEND(1), 0xae,       /* display off */
    GLINT_PANEL_SEND(2), 0xd5, 0x80, /* oscillator and divider */
    GLINT_PANEL_SEND(2), 0xa8, 63,   /* 64 lines */
    GLINT_PANEL_SEND(2), 0xd3, 0,    /* the glass begins at the first */
    GLINT_PANEL_SEND(1), 0x40,       /* start line 0 */
    GLINT_PANEL_SEND(2), 0xad, 0x8b, /* converter on */
    GLINT_PANEL_SEND(1), 0x32,       /* its voltage */
    GLINT_PANEL_SEND(2), 0xda, 0x12, /* odd and even lines alternate */
    GLINT_PANEL_SEND(2), 0x81, 0x80, /* contrast */
    GLINT_PANEL_SEND(2), 0xd9, 0x22, /* precharge */
    GLINT_PANEL_SEND(2), 0xdb, 0x35, /* level of lines not selected */
    GLINT_PANEL_SEND(1), 0xa4,       /* show memory */
    GLINT_PANEL_END,
};

const glint_panel_type glint_panel_sh1106 = {
    .family = &glint_panel_pages,
    .format = &glint_format_mono_pages_dithered,
    .format_turned = &glint_format_mono_dithered,
    .start = start,
    .width = 128,
    .height = 64,
    .memory_width = 132,
    .memory_height = 64,
    .left = 2,
    .glass = GLINT_PANEL_MIRRORED_X | GLINT_PANEL_MIRRORED_Y | GLINT_PANEL_PAGES,
    .bits = {1},
    .reset_low_ms = 1,
    .reset_wait_ms = 1,
    .clock_max = 4000000,
};
