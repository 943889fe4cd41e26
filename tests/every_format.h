/* SPDX-License-Identifier: MIT */
/* Every format of pixels, for suites that go through all. */
#ifndef GLINT_TESTS_EVERY_FORMAT_H
#define GLINT_TESTS_EVERY_FORMAT_H

#include "glint.h"

enum { FORMAT_COUNT = 16 };

static const glint_format *const every_format[FORMAT_COUNT] = {&glint_format_rgb565,
                                                               &glint_format_rgb565_be,
                                                               &glint_format_rgb888,
                                                               &glint_format_grey8,
                                                               &glint_format_grey4,
                                                               &glint_format_rgb444,
                                                               &glint_format_mono,
                                                               &glint_format_mono_pages,
                                                               &glint_format_rgb565_dithered,
                                                               &glint_format_rgb565_be_dithered,
                                                               &glint_format_rgb888_dithered,
                                                               &glint_format_grey8_dithered,
                                                               &glint_format_grey4_dithered,
                                                               &glint_format_rgb444_dithered,
                                                               &glint_format_mono_dithered,
                                                               &glint_format_mono_pages_dithered};

/** Is a byte 8 rows of a column? */
static inline int format_is_paged(const glint_format *format) {
    return format == &glint_format_mono_pages || format == &glint_format_mono_pages_dithered;
}

#endif
