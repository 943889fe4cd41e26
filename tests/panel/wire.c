/* SPDX-License-Identifier: MIT */
#include "wire.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

uint32_t wire_random(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return *state >> 16;
}

/* ---- Faults ----------------------------------------------------------------------------------------------------- */

static int has_fault(const wire *line, wire_fault fault) {
    return line->fault == fault && line->calls >= line->fault_call;
}

/* Counts a call. What befalls the panel from outside befalls it here. */
static void count_call(wire *line) {
    line->calls++;
    if (line->fault == WIRE_PANEL_RESET && line->calls == line->fault_call) {
        panel_model_reset(line->model, 1);
        panel_model_delay(line->model, 1000000);
        panel_model_reset(line->model, 0);
        panel_model_delay(line->model, 1000000000);
    }
}

/* The call at hand is the one that fails half-way. @return bytes of `count` that leave. */
static size_t cut_short(wire *line, size_t count) {
    return line->fault == WIRE_BROKEN && line->calls == line->fault_call ? wire_random(&line->random) % (count + 1)
                                                                         : count;
}

/* ---- Bytes --------------------------------------------------------------------------------------------------- */

/* Fowler, Noll and Vo's sum, of 64 bits. */
static void leave(wire *line, int is_data, uint8_t byte) {
    line->order = (line->order ^ (unsigned)(is_data << 8 | byte)) * 1099511628211u;
    if (is_data) {
        panel_model_data(line->model, byte);
    } else {
        panel_model_command(line->model, byte);
    }
}

/* ---- Commands and data ------------------------------------------------------------------------------------------ */

/* Where D/C changes under a transfer, its rest goes out as what it is not. */
static void spill(wire *line, int is_data) {
    struct wire_transfer *transfer = &line->transfer;

    for (; transfer->is_busy && transfer->done < transfer->row_bytes * transfer->rows; transfer->done++) {
        leave(line, is_data,
              transfer->bytes[transfer->done / transfer->row_bytes * transfer->stride +
                              transfer->done % transfer->row_bytes]);
    }
    transfer->is_busy = 0;
}

static glint_status send(wire *line, const uint8_t *bytes, size_t count, int is_data) {
    size_t leaving;

    count_call(line);
    spill(line, is_data);
    if (has_fault(line, WIRE_NEVER_READY)) {
        return GLINT_ERROR_TIMEOUT;
    }
    leaving = has_fault(line, WIRE_CUT) ? 0 : has_fault(line, WIRE_SLOW) ? count / 2 : cut_short(line, count);
    for (size_t i = 0; i < leaving; i++) {
        leave(line, is_data, bytes[i]);
    }
    if (has_fault(line, WIRE_SLOW)) {
        return GLINT_ERROR_TIMEOUT;
    }
    return line->fault == WIRE_BROKEN && line->calls == line->fault_call ? GLINT_ERROR_BUS : GLINT_OK;
}

static glint_status command(void *context, const uint8_t *bytes, size_t count) {
    return send(context, bytes, count, 0);
}

static glint_status data(void *context, const uint8_t *bytes, size_t count) {
    return send(context, bytes, count, 1);
}

/* ---- Transfers -------------------------------------------------------------------------------------------------- */

static uint8_t find_byte(const struct wire_transfer *transfer) {
    const size_t at = transfer->done % transfer->row_bytes;
    const uint8_t *row = transfer->bytes + transfer->done / transfer->row_bytes * transfer->stride;
    uint16_t word;

    if (!transfer->has_words) {
        return row[at];
    }
    memcpy(&word, row + (at & ~(size_t)1), sizeof word);
    return (uint8_t)(at % 2 ? word : word >> 8);
}

/* Lets up to `count` bytes leave. */
static void pump(wire *line, size_t count) {
    struct wire_transfer *transfer = &line->transfer;
    const size_t all = transfer->row_bytes * transfer->rows;

    for (; count > 0 && transfer->done < all; count--, transfer->done++) {
        if (!has_fault(line, WIRE_CUT)) {
            leave(line, 1, find_byte(transfer));
        }
    }
    transfer->is_busy = transfer->done < all;
}

static glint_status start(wire *line, struct wire_transfer transfer) {
    const size_t all = transfer.row_bytes * transfer.rows;

    count_call(line);
    if (line->transfer.is_busy) { /* one DMA channel: the transfer before is lost */
        return GLINT_ERROR_BUS;
    }
    if (has_fault(line, WIRE_NEVER_READY)) {
        return GLINT_ERROR_TIMEOUT;
    }
    line->transfer = transfer;
    line->transfer.is_busy = 1;
    line->streamed += all;
    if (line->fault == WIRE_BROKEN && line->calls == line->fault_call) {
        pump(line, cut_short(line, all));
        line->transfer.is_busy = 0;
        return GLINT_ERROR_BUS;
    }
    pump(line, !line->is_random ? all : wire_random(&line->random) % (all + 1));
    return GLINT_OK;
}

static glint_status begin(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    const struct wire_transfer transfer = {bytes, row_bytes, rows, stride, 0, 0, 0};

    return start(context, transfer);
}

static glint_status begin_words(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    const struct wire_transfer transfer = {bytes, row_bytes, rows, stride, 0, 1, 0};

    if (row_bytes % 2 || stride % 2) {
        return GLINT_ERROR_BUS;
    }
    return start(context, transfer);
}

/* As a board's: polls until the peripheral is done, and not for ever. On an error the transfer is stopped. */
static glint_status wait(void *context) {
    wire *line = context;
    unsigned polls = 0;
    glint_status status = GLINT_OK;

    count_call(line);
    if (line->fault == WIRE_BROKEN && line->calls == line->fault_call) {
        status = GLINT_ERROR_BUS;
    }
    while (line->transfer.is_busy && status == GLINT_OK) {
        const unsigned most = has_fault(line, WIRE_SLOW) ? 1 : 100; /* bytes in 20 polls */
        pump(line, polls % 20 == 0 && !has_fault(line, WIRE_NEVER_READY) ? wire_random(&line->random) % (most + 1) : 0);
        if (++polls == WIRE_PATIENCE) {
            status = GLINT_ERROR_TIMEOUT;
        }
    }
    line->transfer.is_busy = 0;
    line->polls_worst = polls > line->polls_worst ? polls : line->polls_worst;
    return status;
}

/* ---- Other lines ------------------------------------------------------------------------------------------------ */

static void reset(void *context, int active) {
    wire *line = context;

    panel_model_reset(line->model, active);
}

static void backlight(void *context, int on) {
    wire *line = context;

    line->is_lit = on;
}

static void delay(void *context, uint32_t milliseconds) {
    wire *line = context;

    panel_model_delay(line->model, (uint64_t)milliseconds * 1000000);
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

void wire_open(wire *line, const char *module, uint32_t hertz, int has_reset) {
    memset(line, 0, sizeof *line);
    line->model = panel_model_begin(module);
    if (line->model == NULL) {
        fprintf(stderr, "%s: no such module\n", module);
        exit(1);
    }
    panel_model_clock(line->model, hertz);
    line->random = 1;
    line->bus.command = command;
    line->bus.data = data;
    line->bus.begin = begin;
    line->bus.begin_words = begin_words;
    line->bus.wait = wait;
    line->bus.reset = has_reset ? reset : NULL;
    line->bus.backlight = backlight;
    line->bus.delay = delay;
    line->bus.context = line;
}

void wire_close(wire *line) {
    panel_model_end(line->model);
}

void wire_break(wire *line, wire_fault fault, unsigned call) {
    line->fault = fault;
    line->fault_call = line->calls + call;
}

void wire_mend(wire *line) {
    line->fault = WIRE_SOUND;
    line->transfer.is_busy = 0;
}
