/* SPDX-License-Identifier: MIT */
/*
 * QEMU's RISC-V machine `virt`: any core, memory from 0x80000000 on. Here RV32IMC shows that the library computes the
 * same bits, and what it takes. It has no panel. Text and exit status go through semihosting (RISC-V Semihosting 0.2),
 * whose operations are Arm's.
 */
#include "board.h"

#include "virt.h"

enum { SYS_WRITE0 = 0x04, SYS_EXIT_EXTENDED = 0x20 };

/* ADP_Stopped_ApplicationExit: the reason that carries an exit status. */
static const uintptr_t application_exit = 0x20026;

/* Ticks of the core's timer in a millisecond. */
enum { TIMER_TICKS = 10000 };

static void semihosting(int operation, const void *argument) {
    register int number __asm__("a0") = operation;
    register const void *parameter __asm__("a1") = argument;

    __asm__ volatile(".balign 16\n" /* the three may not lie in two pages */
                     ".option push\n"
                     ".option norvc\n"
                     "slli x0, x0, 0x1f\n"
                     "ebreak\n"
                     "srai x0, x0, 7\n"
                     ".option pop"
                     : "+r"(number)
                     : "r"(parameter)
                     : "memory", "t0", "t1");
}

void board_init(void) {
}

void board_write(const char *text) {
    semihosting(SYS_WRITE0, text);
}

void board_exit(int status) {
    const uintptr_t block[2] = {application_exit, (uintptr_t)status};

    semihosting(SYS_EXIT_EXTENDED, block);
    for (;;) { /* nobody listens: stay */
    }
}

void board_delay(uint32_t milliseconds) {
    const volatile uint32_t *time = (const volatile uint32_t *)0x0200bff8u; /* of the CLINT, low half */

    for (uint32_t i = 0; i < milliseconds; i++) {
        const uint32_t start = *time;
        while (*time - start <= TIMER_TICKS) {
        }
    }
}

const glint_bus *board_panel_bus(void) {
    return 0;
}

/* Without a panel there is nothing to stop for. */
void board_checkpoint(const char *name) {
    board_write(name);
    board_write(" done\n");
}
