/* SPDX-License-Identifier: MIT */
/**
 * @file i2c.h
 * A panel on I2C: the bus's callbacks, over what a board's I2C can do. D/C goes as a control byte in front of what it
 * tells of (SSD1306 Rev 1.5, section 8.1.5; SH1106 V2.3, "I2C-bus protocol"): 0x80 before each byte of a command, 0x40
 * once before data. A message is a command with its parameters, or data; nothing is on its way when a callback returns.
 *
 *     static glint_i2c i2c = {i2c_start, i2c_write, i2c_stop, NULL, 0x3c};
 *     static const glint_bus bus = {.command = glint_i2c_command, .data = glint_i2c_data, .begin = glint_i2c_begin,
 *                                   .delay = delay, .context = &i2c};
 */
#ifndef GLINT_I2C_H
#define GLINT_I2C_H

#include "bus.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The highest clock of fast mode, which the panels take, Hz. */
#define GLINT_I2C_CLOCK_MAX 400000

/** A panel's place on a board's I2C, and the board's callbacks. Every wait in them is bounded, as those of a glint_bus.
 */
typedef struct glint_i2c {
    /** Sends a start condition, the address for writing and a first byte. GLINT_ERROR_BUS: not acknowledged. */
    glint_status (*start)(void *context, uint8_t address, uint8_t first);
    /** Sends further bytes of the message. */
    glint_status (*write)(void *context, const uint8_t *bytes, size_t count);
    /** Sends a stop condition, and leaves the bus idle; after an error too, whichever of the others returned it. */
    glint_status (*stop)(void *context);
    void *context;   /**< Handed to all of these. */
    uint8_t address; /**< 7 bits; most panels have 0x3c, or 0x3d with a pin. */
} glint_i2c;

/** A glint_bus's callback `command`. @param context a glint_i2c @param bytes,count as there @return as there */
glint_status glint_i2c_command(void *context, const uint8_t *bytes, size_t count);

/** A glint_bus's callback `data`. @param context a glint_i2c @param bytes,count as there @return as there */
glint_status glint_i2c_data(void *context, const uint8_t *bytes, size_t count);

/** A glint_bus's callback `begin`. @param context a glint_i2c @param bytes,row_bytes,rows,stride as there @return as
 * there
 */
glint_status glint_i2c_begin(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride);

#ifdef __cplusplus
}
#endif

#endif
