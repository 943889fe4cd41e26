/* SPDX-License-Identifier: MIT */
/**
 * @file framebuffer.h
 * A panel in memory: takes tiles as any display does and keeps them as they were sent.
 */
#ifndef GLINT_HOST_FRAMEBUFFER_H
#define GLINT_HOST_FRAMEBUFFER_H

#include "glint.h"

/** A pixel format with the name that users know it by. */
typedef struct framebuffer_format {
    const char *name;
    const glint_format *format;
    const glint_format *dithered; /**< The same with ordered dithering. */
    uint32_t channels;            /**< Of the picture it becomes: 1 for grey, 3 for red, green, blue. */
    /** Expands the pixel at column `x` of a stored row to 8 bits a channel. */
    void (*expand)(const uint8_t *row, uint32_t x, uint8_t *levels);
} framebuffer_format;

/** All formats, ended by one without a name. */
extern const framebuffer_format framebuffer_formats[];

/** The format of a name or, with a null name, of a descriptor, dithered or not; null when there is none. */
const framebuffer_format *framebuffer_find_format(const char *name, const glint_format *format);

/** What one frame was sent as. Owns `rows`. */
typedef struct framebuffer {
    const framebuffer_format *format;
    uint32_t width, height;
    size_t row_bytes;
    uint8_t *rows;        /**< `height` rows of `row_bytes` in the stored format. */
    uint64_t pixels_sent; /**< Since framebuffer_init. */
    uint64_t bytes_sent;
    /** The rectangle on its way, between `begin` and `wait`; `pixels` is null when there is none. */
    struct framebuffer_transfer {
        const uint8_t *pixels;
        size_t stride;
        uint32_t x, y, width, height;
    } transfer;
} framebuffer;

/** Sets up a black framebuffer; free it with framebuffer_free. `format` must be one of framebuffer_formats. */
void framebuffer_init(framebuffer *target, const glint_format *format, uint32_t width, uint32_t height);

/** Frees what framebuffer_init made. */
void framebuffer_free(framebuffer *target);

/**
 * Callbacks that fill the framebuffer. `wait` does the copying, as late as a slow display might, so that pixels which
 * change before it show. Both report a failure when a rectangle leaves the screen, splits a byte, or comes out of turn.
 */
glint_flush framebuffer_flush(framebuffer *target);

/**
 * The picture with 8 bits a channel, levels expanded exactly: v of n levels to v 255 / (n - 1), rounded to nearest.
 * @return width height channels bytes, rows from top to bottom; the caller frees them
 */
uint8_t *framebuffer_expand(const framebuffer *target);

#endif
