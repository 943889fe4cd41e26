/* SPDX-License-Identifier: MIT */
/**
 * @file bus.h
 * The bus to a panel, as callbacks that a board provides. One line, D/C, tells commands (low) from data (high); chip
 * select is the callbacks' business, and high between calls. Bytes go most significant bit first.
 */
#ifndef GLINT_BUS_H
#define GLINT_BUS_H

#include "glint.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Const data of a board. Callbacks that send return GLINT_OK, GLINT_ERROR_TIMEOUT or GLINT_ERROR_BUS. Every wait in
 * them is bounded, so that a dead bus is an error and never a hang. Once one has returned an error, nothing is on its
 * way any more: what was left of a transfer is given up.
 */
typedef struct glint_bus {
    /** Sends bytes with D/C low; returns when the last one has left. */
    glint_status (*command)(void *context, const uint8_t *bytes, size_t count);
    /** Sends bytes with D/C high; returns when the last one has left. */
    glint_status (*data)(void *context, const uint8_t *bytes, size_t count);
    /**
     * Starts to send `rows` rows of `row_bytes` each with D/C high, `stride` bytes from one row to the next. May return
     * before they are sent: they stay as they are until `wait`. Nothing else is called in between.
     */
    glint_status (*begin)(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride);
    /** Returns when what `begin` started is sent, at once when it started nothing. Null when `begin` returns only then.
     */
    glint_status (*wait)(void *context);
    /** Pulls the panel's reset line low (1) or lets it go (0). Null when it hangs on the board's own reset. */
    void (*reset)(void *context, int active);
    /** Switches the light behind the panel. Null for a panel that glows by itself. */
    void (*backlight)(void *context, int on);
    /** Returns no earlier than after this many milliseconds. */
    void (*delay)(void *context, uint32_t milliseconds);
    /** Handed to all of these. */
    void *context;
    /**
     * As `begin`, of 16-bit words in the core's byte order, which the bus sends high byte first: what an SPI or a DMA
     * of 16 bits does. `row_bytes` and `stride` are even. Null where the bus sends bytes only.
     */
    glint_status (*begin_words)(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride);
} glint_bus;

#ifdef __cplusplus
}
#endif

#endif
