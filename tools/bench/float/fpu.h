/* SPDX-License-Identifier: MIT */
/**
 * @file fpu.h
 * Switches the FPU of a Cortex-M4F on; to be called before anything that has a float.
 */
#ifndef FLOAT_FPU_H
#define FLOAT_FPU_H

#include "cortex-m/cortex-m.h"

/** Access to coprocessors 10 and 11, which are the FPU. */
static inline void fpu_start(void) {
    *cortex_m_register(0xe000ed88u) |= 0xfu << 20;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
}

#endif
