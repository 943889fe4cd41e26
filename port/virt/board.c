/* SPDX-License-Identifier: MIT */
/*
 * QEMU's RISC-V machine `virt`: any core, memory from 0x80000000 on. Here RV32IMC shows that the library computes the
 * same bits, and what it takes. It has no panel: pictures go to a framebuffer in memory. Text and exit status go
 * through semihosting.
 */
#include "board.h"

#include "riscv/riscv.h"
#include "semihosting/semihosting.h"

#include <string.h>

/* Ticks of the core's timer in a millisecond. */
enum { TIMER_TICKS = 10000 };

enum { WIDTH = 320, HEIGHT = 240 };

/** What a display would show. */
uint16_t virt_framebuffer[HEIGHT][WIDTH];

static int copy_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const uint8_t *row = pixels;

    (void)context;
    for (int line = 0; line < height; line++, row += stride) {
        memcpy(&virt_framebuffer[y + line][x], row, (size_t)width * sizeof(uint16_t));
    }
    return 0;
}

void board_init(void) {
}

void board_write(const char *text) {
    semihosting_write(text);
}

void board_exit(int status) {
    riscv_exit(status);
}

void board_delay(uint32_t milliseconds) {
    const volatile uint32_t *time = riscv_register(0x0200bff8); /* of the CLINT, low half */

    for (uint32_t i = 0; i < milliseconds; i++) {
        const uint32_t start = *time;
        while (*time - start <= TIMER_TICKS) {
        }
    }
}

const glint_bus *board_panel_bus(void) {
    return 0;
}

glint_status board_display_start(board_display *display) {
    *display = (board_display){WIDTH, HEIGHT, &glint_format_rgb565, {copy_tile, 0, 0}};
    return GLINT_OK;
}

void board_checkpoint(const char *name) {
    semihosting_checkpoint(name);
}
