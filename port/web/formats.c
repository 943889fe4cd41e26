/* SPDX-License-Identifier: MIT */
/**
 * @file formats.c
 * Formats that differ from others only in where their bits lie: the page, which shows pixels, has them by name alone.
 */
#include "pixel/format.h"

const glint_format glint_format_rgb565_be = {0};
const glint_format glint_format_rgb565_be_dithered = {0};
const glint_format glint_format_mono_pages = {0};
const glint_format glint_format_mono_pages_dithered = {0};
