/* SPDX-License-Identifier: MIT */
/* A board of this machine: what goes over the bus to the panel, as text on stdout that `make panel-stream` reads. */
#include "board.h"

#include <stdio.h>

static void write_bytes(char kind, const uint8_t *bytes, size_t count) {
    if (count == 0)
        return;
    putchar(kind);
    for (size_t i = 0; i < count; i++)
        printf(" %02x", bytes[i]);
    putchar('\n');
}

static glint_status write_command(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    write_bytes('C', bytes, count);
    return GLINT_OK;
}

static glint_status write_data(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    write_bytes('D', bytes, count);
    return GLINT_OK;
}

static glint_status write_rows(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    (void)context;
    for (size_t row = 0; row < rows; row++)
        write_bytes('D', bytes + row * stride, row_bytes);
    return GLINT_OK;
}

static void write_reset(void *context, int active) {
    (void)context;
    printf("R %d\n", active);
}

static void write_delay(void *context, uint32_t milliseconds) {
    (void)context;
    printf("T %lu\n", milliseconds * 1000ul);
}

const glint_bus *board_panel_bus(void) {
    static const glint_bus bus = {
        .command = write_command, .data = write_data, .begin = write_rows, .reset = write_reset, .delay = write_delay};
    return &bus;
}
