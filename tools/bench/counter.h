/* SPDX-License-Identifier: MIT */
/**
 * @file counter.h
 * Counts instructions. Under QEMU's -icount shift=0 an instruction takes a nanosecond, the same on every run. SysTick
 * of the MPS2 boards counts 25 MHz: forty instructions a tick. RISC-V counts instructions itself.
 */
#ifndef GLINT_BENCH_COUNTER_H
#define GLINT_BENCH_COUNTER_H

#if defined(__riscv)

#include "virt/virt.h"

#define COUNTER_INSTRUCTIONS_PER_TICK 1

static inline void counter_start(void) {
}

static inline uint32_t counter_now(void) {
    return virt_instructions();
}

/** Ticks since `then`, fewer than 2^32 ago. */
static inline uint32_t counter_ticks_since(uint32_t then) {
    return counter_now() - then;
}

#else

#include "cortex-m/cortex-m.h"

#define COUNTER_INSTRUCTIONS_PER_TICK 40

/** The counter wraps after so many ticks, 671 million instructions. */
#define COUNTER_TICKS 0x1000000u

/** Starts SysTick: its reload value, its value, and then core clock, no interrupt, on. */
static inline void counter_start(void) {
    *cortex_m_register(0xe000e014u) = COUNTER_TICKS - 1;
    *cortex_m_register(0xe000e018u) = 0;
    *cortex_m_register(0xe000e010u) = 5;
}

static inline uint32_t counter_now(void) {
    return *cortex_m_register(0xe000e018u);
}

/** Ticks since `then`, fewer than COUNTER_TICKS ago; the counter runs down. */
static inline uint32_t counter_ticks_since(uint32_t then) {
    return (then - counter_now()) & (COUNTER_TICKS - 1);
}

#endif

#endif
