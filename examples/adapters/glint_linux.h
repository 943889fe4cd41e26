/* SPDX-License-Identifier: MIT */
/**
 * @file glint_linux.h
 * A screen of Linux without a window system: a framebuffer (/dev/fb0) or a dumb buffer of DRM (/dev/dri/card0, with
 * libdrm), 16 bits a pixel: glint_format_rgb565.
 */
#ifndef ADAPTER_LINUX_H
#define ADAPTER_LINUX_H

#include <glint.h>

/** A screen in memory. */
typedef struct adapter_linux_screen {
    int file; /**< -1 where nothing is open. */
    uint16_t width, height;
    uint8_t *pixels;
    size_t pitch, size; /**< Bytes of a row; of all. */
} adapter_linux_screen;

/** Opens and maps a framebuffer. @return 0, or an errno: then nothing is open */
int adapter_linux_open_fb(adapter_linux_screen *screen, const char *path);

/** Shows a dumb buffer on the first connected screen, in its preferred mode (glint_linux_drm.c). @return the same */
int adapter_linux_open_drm(adapter_linux_screen *screen, const char *path);

/** Closes either; the kernel takes a dumb buffer back with its file. */
void adapter_linux_close(adapter_linux_screen *screen);

/** `screen` must outlive the flush. */
glint_flush adapter_linux_flush(adapter_linux_screen *screen);

#endif
