/* SPDX-License-Identifier: MIT */
#include "ssd0323.h"

#include "solomon.h"

/*
 * Registers and values are those that the LM3S6965 evaluation board's vendor sets for its module (OSRAM Pictiva,
 * 128x64); they were not checked against the controller's data sheet, and QEMU's model ignores all but the window.
 * What glint relies on: columns run left to right, rows top to bottom, and the high half of a byte is the left pixel.
 */
static const uint8_t start[] = {
    GLINT_PANEL_SEND(2), 0x81, 50,   /* contrast, of 127 */
    GLINT_PANEL_SEND(1), 0x85,       /* half current range */
    GLINT_PANEL_SEND(2), 0xa0, 0x52, /* COM split odd/even, COM order reversed, high half of a byte first, row by row */
    GLINT_PANEL_SEND(2), 0xa1, 0,    /* start line */
    GLINT_PANEL_SEND(2), 0xa2, 0x4c, /* the glass begins at this COM line */
    GLINT_PANEL_SEND(1), 0xa4,       /* show memory, not inverted */
    GLINT_PANEL_SEND(2), 0xa8, 63,   /* 64 lines */
    GLINT_PANEL_SEND(2), 0xb1, 0x22, /* phase lengths, clocks */
    GLINT_PANEL_SEND(2), 0xb2, 70,   /* clocks a row */
    GLINT_PANEL_SEND(2), 0xb3, 0xf1, /* oscillator and divider */
    GLINT_PANEL_SEND(2), 0xbf, 0x0d, /* low level of segments */
    GLINT_PANEL_SEND(2), 0xbe, 0x02, /* high level of COM lines */
    GLINT_PANEL_SEND(2), 0xbc, 0x10, /* precharge */
    GLINT_PANEL_SEND(9), 0xb8, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76, /* pulse widths of the greys */
    GLINT_PANEL_SEND(2), 0xad, 0x03,                                           /* converter on */
    GLINT_PANEL_END,
};

const glint_panel_type glint_panel_ssd0323 = {
    .family = &glint_panel_solomon_grey,
    .format = &glint_format_grey4,
    .start = start,
    .width = 128,
    .height = 64,
    .memory_width = 128,
    .memory_height = 80,
    .glass = GLINT_PANEL_UPRIGHT, /* how its lines are wired to the glass was not checked */
    .bits = {4},
    .reset_low_ms = 1,
    .reset_wait_ms = 1,
    .clock_max = 3500000, /* what the vendor's examples run it at */
};
