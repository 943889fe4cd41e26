/* SPDX-License-Identifier: MIT */
/*
 * From reset to main on a RISC-V core that starts at the first byte of its flash, and what the boards share. No
 * interrupt is used. The linker script names the ends of everything (linker/sections.ld) and the entry, riscv_reset.
 */
#include "riscv.h"

#include "board.h"
#include "semihosting/semihosting.h"

#include <string.h>

extern uint32_t linker_stack_bottom[], linker_stack_top[];
extern uint8_t linker_data_load[], linker_data_begin[], linker_data_end[], linker_bss_begin[], linker_bss_end[];

int main(void);

void riscv_reset(void);

static const uint32_t stack_paint = 0x5AFE57ACu;

/* What the stack never reached keeps the paint. The margin spares the frames that are live while painting. */
static void paint_stack(void) {
    volatile uint32_t here;
    const uint32_t *end = (const uint32_t *)((uintptr_t)&here - 64);

    for (uint32_t *word = linker_stack_bottom; word < end; word++) {
        *word = stack_paint;
    }
}

/* Bytes between two of the linker script's symbols, which to C are objects of their own. */
static size_t between(const void *begin, const void *end) {
    return (uintptr_t)end - (uintptr_t)begin;
}

uint32_t board_stack_used(void) {
    const size_t words = between(linker_stack_bottom, linker_stack_top) / sizeof(uint32_t);
    size_t unused = 0;

    while (unused < words && linker_stack_bottom[unused] == stack_paint) {
        unused++;
    }
    return (uint32_t)((words - unused) * sizeof(uint32_t));
}

__attribute__((used)) static void start(void) {
    memcpy(linker_data_begin, linker_data_load, between(linker_data_begin, linker_data_end));
    memset(linker_bss_begin, 0, between(linker_bss_begin, linker_bss_end));
    paint_stack();
    board_init();
    board_exit(main());
}

__attribute__((used)) static void end_at_fault(void) {
    board_write("fault\n");
    board_exit(EXIT_FAULT);
}

/* A semihosting call that nobody answers traps at its breakpoint: skip it, with -1 as its result. Any other trap ends
 * the program, on a stack begun anew, for the old one may be what faulted. */
__attribute__((naked, used, aligned(4))) static void trap(void) {
    __asm__ volatile(".option push\n"
                     ".option arch, +zicsr\n"
                     "csrr t0, mcause\n"
                     "li t1, 3\n"
                     "bne t0, t1, 1f\n"
                     "csrr t0, mepc\n"
                     "addi t0, t0, 4\n"
                     "csrw mepc, t0\n"
                     "li a0, -1\n"
                     "mret\n"
                     "1: la sp, linker_stack_top\n"
                     "j end_at_fault\n"
                     ".option pop");
}

__attribute__((naked, section(".vectors"), used)) void riscv_reset(void) {
    __asm__ volatile(".option push\n"
                     ".option arch, +zicsr\n"
                     "la sp, linker_stack_top\n"
                     "la t0, trap\n"
                     "csrw mtvec, t0\n"
                     "j start\n"
                     ".option pop");
}

int semihosting_call(int operation, const void *argument) {
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
    return number;
}

void riscv_exit(int status) {
    semihosting_exit(status);
    for (;;) { /* nobody listens: stay */
    }
}
