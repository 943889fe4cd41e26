/* SPDX-License-Identifier: MIT */
/**
 * @file panel.h
 * What all panels share: start-up from a const description, and glint's flush callbacks. A panel sends its window, then
 * the pixels in it, and no byte more.
 *
 *     glint_panel panel = {&glint_panel_ssd0323, bus};
 *     glint_panel_start(&panel);
 *     config.format = panel.type->format;
 *     config.flush = glint_panel_flush(&panel);
 */
#ifndef GLINT_PANEL_H
#define GLINT_PANEL_H

#include "bus.h"
#include "glint.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What panel functions return: a glint_bus_status below 0, or one of these. */
typedef enum glint_panel_status {
    GLINT_PANEL_OK = 0,
    GLINT_PANEL_ERROR_WINDOW = -16 /**< A rectangle lies outside the panel, or its edges cut a byte in two. */
} glint_panel_status;

/**
 * An element of a start-up sequence, which is a string of bytes: GLINT_PANEL_SEND(n) and n bytes, the command first;
 * GLINT_PANEL_DELAY(ms); and GLINT_PANEL_END.
 */
#define GLINT_PANEL_END 0
#define GLINT_PANEL_SEND(count) (count)                     /**< 1 to 127 bytes. */
#define GLINT_PANEL_DELAY(milliseconds) 128, (milliseconds) /**< 0 to 255 ms. */

/** What panels of one family have in common. */
typedef struct glint_panel_family {
    /** Sets the rectangle that pixels go to, inclusive; on return the panel expects pixels. */
    int (*window)(const glint_bus *bus, int left, int top, int right, int bottom);
    /** Parameters of a command go with D/C low, as the command itself; otherwise high. */
    int parameters_are_commands;
} glint_panel_family;

/** A kind of panel, const data. */
typedef struct glint_panel_type {
    const glint_panel_family *family;
    const glint_format *format; /**< What its memory takes. */
    const uint8_t *start;       /**< Start-up sequence, from reset to a panel that shows its memory. */
    uint16_t width, height;     /**< Pixels. */
    uint8_t pixels_per_byte;    /**< Windows begin and end on whole bytes. */
    uint8_t reset_low_ms;       /**< How long reset is held. */
    uint8_t reset_wait_ms;      /**< From the end of reset to the first command. */
    uint32_t clock_max;         /**< Highest bus clock, Hz. */
} glint_panel_type;

/** A panel on a bus. Owned by the caller; not written. */
typedef struct glint_panel {
    const glint_panel_type *type;
    const glint_bus *bus;
} glint_panel;

/** Resets the panel and sends its start-up sequence. @return 0 or a glint_bus_status. */
int glint_panel_start(const glint_panel *panel);

/**
 * Starts to send pixels of the panel's format to a rectangle; glint_panel_wait must follow.
 * @return 0, GLINT_PANEL_ERROR_WINDOW or a glint_bus_status.
 */
int glint_panel_begin(const glint_panel *panel, int x, int y, int width, int height, const void *pixels, size_t stride);

/** Returns when the pixels are sent. @return 0 or a glint_bus_status. */
int glint_panel_wait(const glint_panel *panel);

/** The callbacks with which glint draws to this panel, which must outlive them. */
glint_flush glint_panel_flush(const glint_panel *panel);

#ifdef __cplusplus
}
#endif

#endif
