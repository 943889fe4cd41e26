/* SPDX-License-Identifier: MIT */
/*
 * From reset to main on any Cortex-M, and what the boards share. No interrupt is used: the table ends with the core's
 * own 16 entries. The linker script names the ends of everything (linker/sections.ld).
 */
#include "cortex-m.h"

#include "board.h"
#include "semihosting/semihosting.h"

#include <string.h>

extern uint32_t linker_stack_bottom[], linker_stack_top[], linker_text_begin[], linker_text_end[];
extern uint8_t linker_data_load[], linker_data_begin[], linker_data_end[], linker_bss_begin[], linker_bss_end[];

int main(void);

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

static void reset(void) {
    memcpy(linker_data_begin, linker_data_load, between(linker_data_begin, linker_data_end));
    memset(linker_bss_begin, 0, between(linker_bss_begin, linker_bss_end));
    paint_stack();
    board_init();
    board_exit(main());
}

/* A semihosting call that nobody answers faults: skip it, with -1 as its result. Anything else ends the program. */
__attribute__((used)) static void fault_frame(uint32_t *frame) {
    const uint16_t breakpoint_ab = 0xbeab;
    const uintptr_t pc = frame[6];

    if (pc >= (uintptr_t)linker_text_begin && pc < (uintptr_t)linker_text_end &&
        *(const uint16_t *)pc == breakpoint_ab) {
        frame[0] = UINT32_MAX;
        frame[6] += 2;
        return;
    }
    board_write("fault\n");
    board_exit(EXIT_FAULT);
}

__attribute__((naked)) static void fault(void) {
    __asm__ volatile("mrs r0, msp\n"
                     "ldr r1, =fault_frame\n"
                     "bx r1\n");
}

static void unexpected(void) {
    board_write("unexpected interrupt\n");
    board_exit(EXIT_INTERRUPT);
}

typedef union vector {
    uint32_t *stack;
    void (*handler)(void);
} vector;

extern const vector cortex_m_vectors[16];

__attribute__((section(".vectors"), used)) const vector cortex_m_vectors[16] = {
    {.stack = linker_stack_top}, {.handler = reset},      {.handler = unexpected}, /* NMI */
    {.handler = fault},          {.handler = fault},      {.handler = fault},      {.handler = fault},
    {.handler = unexpected},     {.handler = unexpected}, {.handler = unexpected}, {.handler = unexpected},
    {.handler = unexpected},     {.handler = unexpected}, {.handler = unexpected}, {.handler = unexpected},
    {.handler = unexpected},
};

void cortex_m_delay(uint32_t milliseconds, uint32_t clock_hz) {
    const uint32_t cycles_per_turn = 3; /* subtract and taken branch, without wait states: never too short */

    for (uint32_t i = 0; i < milliseconds; i++) {
        uint32_t turns = clock_hz / 1000 / cycles_per_turn + 1;
        __asm__ volatile(".syntax unified\n1: subs %0, %0, #1\n bne 1b" : "+l"(turns) : : "cc");
    }
}

int semihosting_call(int operation, const void *argument) {
    register int result __asm__("r0") = operation;
    register const void *parameter __asm__("r1") = argument;

    __asm__ volatile("bkpt 0xab" : "+r"(result) : "r"(parameter) : "memory");
    return result;
}

void cortex_m_exit(int status) {
    semihosting_exit(status);
    for (;;) { /* nobody listens: stay */
    }
}
