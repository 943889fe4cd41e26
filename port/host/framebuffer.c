/* SPDX-License-Identifier: MIT */
#include "framebuffer.h"

#include "basics.h"

#include <stdlib.h>
#include <string.h>

/* ---- Formats ---------------------------------------------------------------------------------------------------- */

static void expand_565(uint32_t pixel, uint8_t *levels) {
    levels[0] = (uint8_t)(((pixel >> 11 & 31) * 255 + 15) / 31);
    levels[1] = (uint8_t)(((pixel >> 5 & 63) * 255 + 31) / 63);
    levels[2] = (uint8_t)(((pixel & 31) * 255 + 15) / 31);
}

static void expand_rgb565(const uint8_t *row, uint32_t x, uint8_t *levels) {
    uint16_t pixel;
    memcpy(&pixel, row + 2 * x, sizeof pixel);
    expand_565(pixel, levels);
}

static void expand_rgb565_be(const uint8_t *row, uint32_t x, uint8_t *levels) {
    expand_565((uint32_t)row[2 * x] << 8 | row[2 * x + 1], levels);
}

static void expand_rgb888(const uint8_t *row, uint32_t x, uint8_t *levels) {
    memcpy(levels, row + 3 * x, 3);
}

static void expand_grey8(const uint8_t *row, uint32_t x, uint8_t *levels) {
    levels[0] = row[x];
}

static void expand_grey4(const uint8_t *row, uint32_t x, uint8_t *levels) {
    levels[0] = (uint8_t)((x % 2 == 0 ? row[x / 2] >> 4 : row[x / 2] & 15) * 17);
}

static void expand_rgb444(const uint8_t *row, uint32_t x, uint8_t *levels) {
    const uint8_t *pair = row + x / 2 * 3;
    levels[0] = (uint8_t)((x % 2 == 0 ? pair[0] >> 4 : pair[1] & 15) * 17);
    levels[1] = (uint8_t)((x % 2 == 0 ? pair[0] & 15 : pair[2] >> 4) * 17);
    levels[2] = (uint8_t)((x % 2 == 0 ? pair[1] >> 4 : pair[2] & 15) * 17);
}

static void expand_mono(const uint8_t *row, uint32_t x, uint8_t *levels) {
    levels[0] = (uint8_t)((row[x / 8] >> x % 8 & 1) * 255);
}

const framebuffer_format framebuffer_formats[] = {
    {"rgb565", &glint_format_rgb565, &glint_format_rgb565_dithered, 3, expand_rgb565},
    {"rgb565_be", &glint_format_rgb565_be, &glint_format_rgb565_be_dithered, 3, expand_rgb565_be},
    {"rgb888", &glint_format_rgb888, &glint_format_rgb888_dithered, 3, expand_rgb888},
    {"grey8", &glint_format_grey8, &glint_format_grey8_dithered, 1, expand_grey8},
    {"grey4", &glint_format_grey4, &glint_format_grey4_dithered, 1, expand_grey4},
    {"rgb444", &glint_format_rgb444, &glint_format_rgb444_dithered, 3, expand_rgb444},
    {"mono", &glint_format_mono, &glint_format_mono_dithered, 1, expand_mono},
    {NULL, NULL, NULL, 0, NULL},
};

const framebuffer_format *framebuffer_find_format(const char *name, const glint_format *format) {
    for (const framebuffer_format *found = framebuffer_formats; found->name != NULL; found++) {
        if (name != NULL ? strcmp(found->name, name) == 0 : found->format == format || found->dithered == format) {
            return found;
        }
    }
    return NULL;
}

/* ---- Transfers -------------------------------------------------------------------------------------------------- */

static int begin_transfer(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    framebuffer *target = context;
    const int screen_width = (int)target->width;
    const int screen_height = (int)target->height;
    if (target->transfer.pixels != NULL || x < 0 || y < 0 || width < 1 || height < 1 || width > screen_width - x ||
        height > screen_height - y) {
        return -1;
    }
    /* Pixels may share a byte: a rectangle may end between them only at the right of the screen. */
    const int bits = (int)glint_row_bytes(target->format->format, 8); /* bytes of 8 pixels */
    const int splits = x * bits % 8 != 0 || (width * bits % 8 != 0 && x + width != screen_width);
    if (splits || stride < glint_row_bytes(target->format->format, (uint32_t)width)) {
        return -1;
    }
    const struct framebuffer_transfer transfer = {pixels,      stride,          (uint32_t)x,
                                                  (uint32_t)y, (uint32_t)width, (uint32_t)height};
    target->transfer = transfer;
    return 0;
}

static int wait_transfer(void *context) {
    framebuffer *target = context;
    const struct framebuffer_transfer *transfer = &target->transfer;
    if (transfer->pixels == NULL) {
        return -1;
    }
    const size_t skipped = glint_row_bytes(target->format->format, transfer->x);
    const size_t size = glint_row_bytes(target->format->format, transfer->width);
    for (uint32_t y = 0; y < transfer->height; y++) {
        memcpy(target->rows + (transfer->y + y) * target->row_bytes + skipped, transfer->pixels + y * transfer->stride,
               size);
    }
    target->pixels_sent += (uint64_t)transfer->width * transfer->height;
    target->bytes_sent += (uint64_t)size * transfer->height;
    target->transfer.pixels = NULL;
    return 0;
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

void framebuffer_init(framebuffer *target, const glint_format *format, uint32_t width, uint32_t height) {
    memset(target, 0, sizeof *target);
    target->format = framebuffer_find_format(NULL, format);
    target->width = width;
    target->height = height;
    target->row_bytes = glint_row_bytes(format, width);
    target->rows = memory_new(height, target->row_bytes);
}

void framebuffer_free(framebuffer *target) {
    free(target->rows);
    memset(target, 0, sizeof *target);
}

glint_flush framebuffer_flush(framebuffer *target) {
    const glint_flush flush = {begin_transfer, wait_transfer, target};
    return flush;
}

uint8_t *framebuffer_expand(const framebuffer *target) {
    const uint32_t channels = target->format->channels;
    uint8_t *picture = memory_new((size_t)target->width * target->height, channels);
    uint8_t *levels = picture;
    for (uint32_t y = 0; y < target->height; y++) {
        for (uint32_t x = 0; x < target->width; x++, levels += channels) {
            target->format->expand(target->rows + y * target->row_bytes, x, levels);
        }
    }
    return picture;
}
