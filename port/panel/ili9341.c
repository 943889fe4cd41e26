/* SPDX-License-Identifier: MIT */
#include "ili9341.h"

#include "dcs.h"

/*
 * Supply and gamma registers keep what reset gives them. It takes pixels of 16 and 18 bits (ILI9341, page 92 of 233),
 * none of 12. How the glass lies is as on the common modules; clock and times were not checked against a data sheet.
 */
static const uint8_t start[] = {GLINT_PANEL_DCS_WAKE, GLINT_PANEL_END};

const glint_panel_type glint_panel_ili9341 = {
    .family = &glint_panel_dcs,
    .format = &glint_format_rgb565_be,
    .start = start,
    .width = 240,
    .height = 320,
    .memory_width = 240,
    .memory_height = 320,
    .glass = GLINT_PANEL_MIRRORED_X | GLINT_PANEL_BGR,
    .bits = {16, 24},
    .reset_low_ms = 1,
    .reset_wait_ms = GLINT_PANEL_DCS_WAKE_MS,
    .clock_max = 10000000, /* a write cycle of 100 ns */
};
