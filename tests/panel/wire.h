/* SPDX-License-Identifier: MIT */
/**
 * @file wire.h
 * A bus between a driver and a panel's model, as a peripheral with DMA gives: what `begin` starts leaves at random
 * times, the last of it only while `wait` waits, read from the caller's memory no sooner. Commands leave at once,
 * whatever else is on its way. Time is the model's. Faults can be had at any call and any byte.
 */
#ifndef GLINT_PANEL_WIRE_H
#define GLINT_PANEL_WIRE_H

#include "panel/bus.h"
#include "panel_model.h"

typedef enum wire_fault {
    WIRE_SOUND,
    WIRE_NEVER_READY, /**< From the call on, the bus takes nothing. */
    WIRE_BROKEN,      /**< The call's transfer fails after a part of it. */
    WIRE_SLOW,        /**< From the call on, bytes take 100 times as long. */
    WIRE_PANEL_RESET, /**< At the call, the panel is reset by something else; the bus sees nothing of it. */
    WIRE_CUT          /**< From the call on, everything is lost, unseen: the core is reset, say. */
} wire_fault;

typedef struct wire {
    panel_model *model;
    glint_bus bus; /**< What the driver is given. */
    uint32_t random;
    int is_random; /**< Transfers leave at random times; else within `begin`. */
    wire_fault fault;
    unsigned fault_call;  /**< From 1. */
    unsigned calls;       /**< Of the callbacks that send and wait. */
    unsigned polls_worst; /**< Most polls that one wait took. */
    uint64_t streamed;    /**< Bytes of transfers. */
    uint64_t order;       /**< A sum over all bytes with their D/C, in the order in which they left. */
    int is_lit;

    struct wire_transfer {
        const uint8_t *bytes;
        size_t row_bytes, rows, stride, done;
        int has_words, is_busy;
    } transfer;
} wire;

/** Polls after which a wait gives up. */
#define WIRE_PATIENCE 8192u

/** A sound bus at `hertz` to a new panel, with or without a reset line. Ends the program when there is no such module.
 */
void wire_open(wire *line, const char *module, uint32_t hertz, int has_reset);

void wire_close(wire *line);

/** Sets off a fault at a call from now, 1 the next. */
void wire_break(wire *line, wire_fault fault, unsigned call);

/** All is well again. */
void wire_mend(wire *line);

/** The next of a row of pseudo-random numbers (Numerical Recipes' linear one; the high bits count). */
uint32_t wire_random(uint32_t *state);

#endif
