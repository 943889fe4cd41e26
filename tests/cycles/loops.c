/* SPDX-License-Identifier: MIT */
/*
 * Firmware of loops whose cycles are counted by hand in loops.py, each a hundred rounds; it writes the name of each as
 * it ends.
 */
#include "../../tools/cycles/marks.h"
#include "board.h"

#ifdef __ARM_FP
#include "../../tools/bench/float/fpu.h"
#endif

#include <stdint.h>

static uint32_t from[256], to[256];

/* The body, then the end of each round: a subtraction and a branch back, which is not taken in the last one. */
#define LOOP(name, body)                                                          \
    do {                                                                          \
        uint32_t rounds = 100;                                                    \
        register uint32_t *source __asm("r0") = from;                             \
        register uint32_t *target __asm("r1") = to;                               \
        from[0] = (uint32_t)(uintptr_t)from;                                      \
        __asm volatile(".syntax unified\n"                                        \
                       ".align 2\n"                                               \
                       "sev\n"                                                    \
                       "1:\n" body "subs %0, #1\n"                                \
                       "bne 1b\n"                                                 \
                       "sev\n"                                                    \
                       : "+l"(rounds), "+l"(source), "+l"(target)                 \
                       :                                                          \
                       : "r4", "r5", "r6", "r7", "lr", "cc", "memory" CLOBBERED); \
        board_write(name "\n");                                                   \
        CYCLES_WRITE();                                                           \
    } while (0)

#ifdef __ARM_FP
#define CLOBBERED , "s0", "s1", "s2"
#else
#define CLOBBERED
#endif

__asm(".text\n"
      ".align 2\n"
      ".thumb_func\n"
      "cycles_called:\n"
      "push {r4, lr}\n"
      "pop {r4, pc}\n");

/* Words that are read where code lies. */
__asm(".section .rodata.cycles_table, \"a\"\n"
      ".global cycles_table, cycles_table_end\n"
      "cycles_table: .word 1, 2\n"
      "cycles_table_end:\n"
      ".text\n");

int main(void) {
#ifdef __ARM_FP
    fpu_start();
#endif
    LOOP("several", "ldmia r0!, {r4, r5}\n"
                    "stmia r1!, {r4, r5}\n");
    LOOP("product", "ldr r4, [r0]\n"
                    "ldr r5, [r1]\n"
                    "muls r4, r5\n"
                    "adds r6, r4\n");
    LOOP("chase", "ldr r0, [r0]\n"
                  "ldr r0, [r0]\n"
                  "str r4, [r1]\n"
                  "movs r5, #4\n"
                  "str r4, [r1, r5]\n");
    LOOP("call", "bl cycles_called\n");
    LOOP("skip", "b 2f\n"
                 "nop\n"
                 "2: cmp r0, r0\n"
                 "bne 2b\n");
    LOOP("table", "ldr r4, =cycles_table\n"
                  "ldmia r4!, {r5, r6}\n");
#if __ARM_ARCH >= 7
    LOOP("long", "umull r4, r5, r4, r5\n"
                 "umlal r4, r5, r6, r7\n"
                 "mla r4, r5, r6, r7\n"
                 "udiv r4, r5, r6\n");
    LOOP("wide", "movs r5, #4\n"
                 "ldr.w r4, [r0, #8]\n"
                 "str.w r4, [r1, r5, lsl #1]\n"
                 "ldrd r4, r5, [r0]\n"
                 "cbz r0, 2f\n"
                 "movs r4, #0\n"
                 "tbb [pc, r4]\n"
                 ".byte 1, 1\n"
                 "2:\n");
#endif
#ifdef __ARM_FP
    LOOP("float", "vldr s0, [r0]\n"
                  "vldr s1, [r0]\n"
                  "vstr s1, [r1]\n"
                  "vmul.f32 s1, s0, s0\n"
                  "vfma.f32 s2, s0, s0\n"
                  "vdiv.f32 s1, s0, s0\n"
                  "vsqrt.f32 s1, s0\n"
                  "vldmia r0, {s0, s1}\n");
#endif
    return 0;
}
