/* SPDX-License-Identifier: MIT */
/*
 * The port of the panel stands still when it is switched off, and a transfer never ends when its interrupt is. A PL022
 * knows no failed transfer: there the bus itself says so, half a transfer done.
 */
#include "faults.h"

#include "board.h"
#include "cortex-m/cortex-m.h"
#include "panel/ssd0323.h"

enum { SSI_CONTROL_1 = 0x40008004, SSI_ENABLE = 1u << 1, SSI_INTERRUPT = 1u << 7 };

#define INTERRUPTS_ENABLE 0xe000e100u
#define INTERRUPTS_DISABLE 0xe000e180u

static int is_broken;

static glint_status command(void *context, const uint8_t *bytes, size_t count) {
    return board_panel_bus()->command(context, bytes, count);
}

static glint_status data(void *context, const uint8_t *bytes, size_t count) {
    return board_panel_bus()->data(context, bytes, count);
}

static glint_status begin(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    if (is_broken) {
        board_panel_bus()->begin(context, bytes, row_bytes, rows / 2, stride);
        board_panel_bus()->wait(context);
        return GLINT_ERROR_BUS;
    }
    return board_panel_bus()->begin(context, bytes, row_bytes, rows, stride);
}

static glint_status wait(void *context) {
    return board_panel_bus()->wait(context);
}

static void delay(void *context, uint32_t milliseconds) {
    board_panel_bus()->delay(context, milliseconds);
}

static const glint_bus bus = {.command = command, .data = data, .begin = begin, .wait = wait, .delay = delay};

const glint_panel faults_panel = {.type = &glint_panel_ssd0323, .bus = &bus};

void faults_set(fault_kind kind) {
    *cortex_m_register(SSI_CONTROL_1) = kind == FAULT_STOPPED ? 0 : SSI_ENABLE;
    *cortex_m_register(kind == FAULT_SLOW ? INTERRUPTS_DISABLE : INTERRUPTS_ENABLE) = SSI_INTERRUPT;
    is_broken = kind == FAULT_BROKEN;
    if (kind == FAULT_RESET) {
        board_checkpoint("reset 0"); /* the emulator resets the machine here */
    }
}
