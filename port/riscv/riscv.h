/* SPDX-License-Identifier: MIT */
/** @file riscv.h What the boards with a RISC-V core share, for their board.c to use. */
#ifndef GLINT_RISCV_H
#define GLINT_RISCV_H

#include <stdint.h>

/** Exit status of a program that start-up code ends. */
enum { EXIT_FAULT = 100 };

/** A register of a peripheral. */
static inline volatile uint32_t *riscv_register(uintptr_t address) {
    return (volatile uint32_t *)address;
}

/** board_exit by semihosting. */
void riscv_exit(int status);

/** Instructions executed so far, low half; under QEMU's -icount shift=0 exact, and the same on every run. */
static inline uint32_t riscv_instructions(void) {
    uint32_t count;

    __asm__ volatile(".option push\n"
                     ".option arch, +zicsr\n"
                     "csrr %0, minstret\n"
                     ".option pop"
                     : "=r"(count)
                     :
                     : "memory");
    return count;
}

#endif
