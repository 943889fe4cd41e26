/* SPDX-License-Identifier: MIT */
#include "ssd0303.h"

#include "pages.h"

/*
 * Memory of 132x64: SSD0303 Rev 1.3 (Jul 2005). The values are those that the vendor of the LM3S811 evaluation board
 * sends to its module (OSRAM Pictiva, 96x16), with segments and scan reversed and the picture from column 36 on; they,
 * the clock (a serial cycle of 250 ns) and times were not checked against the data sheet. Of 64 lines it drives 16.
 */
static const uint8_t start[] = {
    GLINT_PANEL_SEND(1), 0xae,       /* display off */
    GLINT_PANEL_SEND(2), 0x81, 0x2b, /* contrast */
    GLINT_PANEL_SEND(1), 0x40,       /* start line 0 */
    GLINT_PANEL_SEND(2), 0xd3, 0,    /* the glass begins at the first */
    GLINT_PANEL_SEND(2), 0xa8, 15,   /* 16 lines */
    GLINT_PANEL_SEND(1), 0xa4,       /* show memory */
    GLINT_PANEL_SEND(2), 0xd5, 0x72, /* oscillator and divider */
    GLINT_PANEL_SEND(2), 0xd8, 0,    /* one colour */
    GLINT_PANEL_SEND(2), 0xd9, 0x22, /* precharge */
    GLINT_PANEL_SEND(2), 0xda, 0x12, /* odd and even lines alternate */
    GLINT_PANEL_SEND(2), 0xdb, 0x0f, /* level of lines not selected */
    GLINT_PANEL_SEND(2), 0xad, 0x8b, /* converter on */
    GLINT_PANEL_END,
};

const glint_panel_type glint_panel_ssd0303 = {
    .family = &glint_panel_pages,
    .format = &glint_format_mono_pages_dithered,
    .format_turned = &glint_format_mono_dithered,
    .start = start,
    .width = 96,
    .height = 16,
    .memory_width = 132,
    .memory_height = 16,
    .glass = GLINT_PANEL_MIRRORED_X | GLINT_PANEL_MIRRORED_Y | GLINT_PANEL_PAGES,
    .bits = {1},
    .reset_low_ms = 1,
    .reset_wait_ms = 1,
    .clock_max = 4000000,
};
