/* SPDX-License-Identifier: MIT */
/**
 * @file pl022.h
 * Arm PL022 (PrimeCell Synchronous Serial Port, DDI 0194), as several parts have it: bytes out, by polling or from its
 * interrupt. D/C and chip select are the board's business.
 */
#ifndef GLINT_PL022_H
#define GLINT_PL022_H

#include "panel/bus.h"

/** A port and what its interrupt has still to send. `base` is the board's to fill in, the rest is not to be touched. */
typedef struct pl022 {
    uintptr_t base;
    const uint8_t *volatile next; /**< The next byte for the FIFO. */
    volatile size_t row_left;     /**< Bytes of this row that are not in the FIFO yet. */
    volatile size_t rows_left;    /**< Rows, this one included. */
    size_t row_bytes, gap;        /**< Bytes of a row, and from its end to the next. */
} pl022;

/** Frames of 8 bits, most significant first; how the clock idles and when data is sampled. */
typedef enum pl022_mode { PL022_MODE_0 = 0, PL022_MODE_2 = 1 << 6 } pl022_mode;

/** Sets the port up; the bus is never faster than bus_hz. */
void pl022_start(const pl022 *port, uint32_t clock_hz, uint32_t bus_hz, pl022_mode mode);

/** Sends bytes and returns when the last is on its way. */
glint_status pl022_send(const pl022 *port, const uint8_t *bytes, size_t count);

/** Returns when the last byte has left. */
glint_status pl022_finish(const pl022 *port);

/** Starts to send rows from the interrupt, which the board has let through to pl022_interrupt. */
void pl022_begin(pl022 *port, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride);

/** Returns when all that pl022_begin started has left. */
glint_status pl022_wait(pl022 *port);

/** The port's interrupt: fills the FIFO. */
void pl022_interrupt(pl022 *port);

#endif
