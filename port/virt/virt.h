/* SPDX-License-Identifier: MIT */
/** @file virt.h What the sources of this board share. */
#ifndef GLINT_VIRT_H
#define GLINT_VIRT_H

#include <stdint.h>

/** Exit status of a program that start-up code ends. */
enum { EXIT_FAULT = 100 };

/** Instructions executed so far, low half; under QEMU's -icount shift=0 exact, and the same on every run. */
static inline uint32_t virt_instructions(void) {
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
