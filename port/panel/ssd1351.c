/* SPDX-License-Identifier: MIT */
#include "ssd1351.h"

#include "solomon.h"

/*
 * Colour depth and order: the bits of command 0xa0 as a module's vendor explains them. The other values are those that
 * public drivers send to modules of 128x128; they, the clock and times were not checked against a data sheet. Its
 * pixels have 8, 16 or 18 bits, none 12.
 */
static const uint8_t start[] = {
    GLINT_PANEL_SEND(2), 0xfd, 0x12,             /* unlocks commands */
    GLINT_PANEL_SEND(2), 0xfd, 0xb1,             /* and those that set up the glass */
    GLINT_PANEL_SEND(1), 0xae,                   /* display off */
    GLINT_PANEL_SEND(2), 0xb3, 0xf1,             /* oscillator and divider */
    GLINT_PANEL_SEND(2), 0xca, 127,              /* 128 lines */
    GLINT_PANEL_SEND(2), 0xa1, 0,                /* start line */
    GLINT_PANEL_SEND(2), 0xa2, 0,                /* the glass begins at the first */
    GLINT_PANEL_SEND(2), 0xb5, 0x00,             /* general purpose pins off */
    GLINT_PANEL_SEND(2), 0xab, 0x01,             /* supply of the logic from inside */
    GLINT_PANEL_SEND(2), 0xb1, 0x32,             /* phase lengths */
    GLINT_PANEL_SEND(2), 0xbb, 0x17,             /* precharge */
    GLINT_PANEL_SEND(2), 0xbe, 0x05,             /* level of lines not selected */
    GLINT_PANEL_SEND(1), 0xa6,                   /* show memory, not inverted */
    GLINT_PANEL_SEND(4), 0xc1, 0xc8, 0x80, 0xc8, /* contrast of the three colours */
    GLINT_PANEL_SEND(2), 0xc7, 0x0f,             /* and of all */
    GLINT_PANEL_SEND(4), 0xb4, 0xa0, 0xb5, 0x55, /* low level of segments from outside */
    GLINT_PANEL_SEND(2), 0xb6, 0x01,             /* second precharge */
    GLINT_PANEL_END,
};

const glint_panel_type glint_panel_ssd1351 = {
    .family = &glint_panel_solomon_colour,
    .format = &glint_format_rgb565_be,
    .start = start,
    .width = 128,
    .height = 128,
    .memory_width = 128,
    .memory_height = 128,
    .glass = GLINT_PANEL_MIRRORED_Y,
    .bits = {16},
    .reset_low_ms = 1,
    .reset_wait_ms = 1,
    .clock_max = 4500000, /* a cycle of 220 ns, the slowest that revisions of its data sheet are said to give */
};
