/* SPDX-License-Identifier: MIT */
/*
 * The LCD's port: a PL022, with D/C, chip select, reset and backlight in the FPGA's MISC register. Bits of that
 * register as Arm's public header for the board (SMM_MPS2.h) has them. Pixels are sent from the interrupt while the
 * core draws on.
 */
#include "lcd.h"

#include "board.h"
#include "cortex-m/cortex-m.h"
#include "pl022/pl022.h"

/* The images for Armv8-M have it elsewhere: all runs in the secure state, whose addresses these are. */
#if defined __ARM_ARCH_8M_MAIN__
enum { LCD = 0x50206000, MISC = 0x5030204c, INTERRUPT_LCD = 52 };
#else
enum { LCD = 0x40021000, MISC = 0x4002804c };
enum { INTERRUPT_LCD = 11 }; /* shared with the port at 0x40020000, which is not used */
#endif

enum { MISC_NOT_SELECTED = 1u << 0, MISC_NOT_RESET = 1u << 3, MISC_DATA = 1u << 4, MISC_BACKLIGHT = 1u << 6 };

#define INTERRUPTS_ENABLE 0xe000e100u /* 32 to a word */

static pl022 port = {.base = LCD};

static void interrupt(void) {
    pl022_interrupt(&port);
}

__attribute__((section(".vectors.interrupts"), used)) static void (*const interrupts[INTERRUPT_LCD + 1])(void) = {
    [INTERRUPT_LCD] = interrupt};

static void set(uint32_t bits, int high) {
    volatile uint32_t *misc = cortex_m_register(MISC);

    *misc = high ? *misc | bits : *misc & ~bits;
}

void mps2_lcd_start(uint32_t clock_hz, uint32_t bus_hz) {
    *cortex_m_register(MISC) = MISC_NOT_SELECTED | MISC_NOT_RESET;
    pl022_start(&port, clock_hz, bus_hz, PL022_MODE_0);
    *cortex_m_register(INTERRUPTS_ENABLE + INTERRUPT_LCD / 32 * 4) = 1u << INTERRUPT_LCD % 32;
}

/* Lets the panel go. */
static glint_status finish(glint_status status) {
    set(MISC_NOT_SELECTED, 1);
    return status;
}

/* What a transfer that was given up left behind leaves before the panel listens. */
static glint_status select(int is_data) {
    const glint_status status = pl022_finish(&port);

    if (!status) {
        set(MISC_DATA, is_data);
        set(MISC_NOT_SELECTED, 0);
    }
    return status;
}

static glint_status send(const uint8_t *bytes, size_t count, int is_data) {
    glint_status status = select(is_data);

    if (status) {
        return status;
    }
    status = pl022_send(&port, bytes, count);
    return finish(status ? status : pl022_finish(&port));
}

static glint_status command(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    return send(bytes, count, 0);
}

static glint_status data(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    return send(bytes, count, 1);
}

static glint_status begin(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    const glint_status status = select(1);

    (void)context;
    if (!status) {
        pl022_begin(&port, bytes, row_bytes, rows, stride);
    }
    return status;
}

static glint_status wait(void *context) {
    (void)context;
    return finish(pl022_wait(&port));
}

static void reset(void *context, int active) {
    (void)context;
    set(MISC_NOT_RESET, !active);
}

static void backlight(void *context, int on) {
    (void)context;
    set(MISC_BACKLIGHT, on);
}

static void delay(void *context, uint32_t milliseconds) {
    (void)context;
    board_delay(milliseconds);
}

const glint_bus mps2_lcd_bus = {.command = command,
                                .data = data,
                                .begin = begin,
                                .wait = wait,
                                .reset = reset,
                                .backlight = backlight,
                                .delay = delay};
