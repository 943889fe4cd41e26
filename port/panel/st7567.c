/* SPDX-License-Identifier: MIT */
#include "st7567.h"

#include "pages.h"

enum { SETTLE_MS = 50 };

/*
 * Memory of 132x65, the last row for icons: ST7567 V1.4, page 1. The order in which the supply is switched on, and how
 * the glass lies, are as public drivers have them for modules of 128x64; they, contrast, the clock and times were not
 * checked against the data sheet. A pixel that is set is dark: the controller is told to invert, so that light is
 * light.
 */
static const uint8_t start[] = {
    GLINT_PANEL_SEND(1),
    0xae, /* display off */
    GLINT_PANEL_SEND(1),
    0x40, /* start line 0 */
    GLINT_PANEL_SEND(1),
    0xa2, /* bias 1/9 */
    GLINT_PANEL_SEND(1),
    0x2c, /* supply: booster, then regulator, then follower */
    GLINT_PANEL_DELAY(SETTLE_MS),
    GLINT_PANEL_SEND(1),
    0x2e,
    GLINT_PANEL_DELAY(SETTLE_MS),
    GLINT_PANEL_SEND(1),
    0x2f,
    GLINT_PANEL_DELAY(SETTLE_MS),
    GLINT_PANEL_SEND(2),
    0xf8,
    0x00, /* booster by 4 */
    GLINT_PANEL_SEND(1),
    0x23, /* resistor ratio */
    GLINT_PANEL_SEND(2),
    0x81,
    0x24, /* contrast, of 63 */
    GLINT_PANEL_SEND(1),
    0xa4, /* show memory */
    GLINT_PANEL_END,
};

const glint_panel_type glint_panel_st7567 = {
    .family = &glint_panel_pages,
    .format = &glint_format_mono_pages_dithered,
    .format_turned = &glint_format_mono_dithered,
    .start = start,
    .width = 128,
    .height = 64,
    .memory_width = 132,
    .memory_height = 64,
    .glass = GLINT_PANEL_MIRRORED_Y | GLINT_PANEL_INVERTED | GLINT_PANEL_PAGES,
    .bits = {1},
    .reset_low_ms = 1,
    .reset_wait_ms = 1,
    .clock_max = 4000000,
};
