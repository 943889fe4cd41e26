/* SPDX-License-Identifier: MIT */
/**
 * @file thumb.h
 * What an instruction of a Cortex-M is to its pipeline. Encodings: ARMv7-M Architecture Reference Manual (ARM DDI
 * 0403E), A5 to A7; ARMv6-M's are among them.
 */
#ifndef GLINT_CYCLES_THUMB_H
#define GLINT_CYCLES_THUMB_H

#include <stdint.h>

/** Name of each kind, in this order, in what plugin.c writes. */
#define THUMB_KINDS(KIND)                                                                            \
    KIND(plain)           /* what takes a cycle everywhere */                                        \
    KIND(multiply)        /* 32 bits */                                                              \
    KIND(multiply_add)    /* 32 bits: MLA, MLS */                                                    \
    KIND(multiply_long)   /* 64 bits: SMULL, UMULL */                                                \
    KIND(accumulate_long) /* 64 bits: SMLAL, UMLAL */                                                \
    KIND(divide)          /* SDIV, UDIV */                                                           \
    KIND(load)            /* one register */                                                         \
    KIND(load_next)       /* the same, right after a load that its address does not wait for */      \
    KIND(store)           /* one register, at a register and a constant */                           \
    KIND(store_indexed)   /* one register, at the sum of two registers */                            \
    KIND(store_next)      /* any of the two right after a load that its address does not wait for */ \
    KIND(multiple)        /* several registers: LDM, STM, PUSH, POP, LDRD, STRD, VLDM, VSTM */       \
    KIND(system)          /* MRS, MSR, barriers */                                                   \
    KIND(branch)          /* B, CBZ, CBNZ */                                                         \
    KIND(call)            /* BL */                                                                   \
    KIND(jump)            /* BX, BLX, MOV and ADD to the program counter */                          \
    KIND(table)           /* TBB, TBH */                                                             \
    KIND(load_jump)       /* LDR to the program counter */                                           \
    KIND(multiple_jump)   /* POP, LDM with the program counter */                                    \
    KIND(float_plain)     /* VADD, VMUL, VCVT, ... */                                                \
    KIND(float_add)       /* VMLA, VFMA, ... */                                                      \
    KIND(float_divide)    /* VDIV, VSQRT */                                                          \
    KIND(float_load)      /* VLDR */                                                                 \
    KIND(float_load_next) /* the same, right after a load that its address does not wait for */      \
    KIND(float_store)     /* VSTR */                                                                 \
    KIND(float_pair)      /* VMOV between two core registers and two of the FPU's */

#define THUMB_NAME_KIND(name) THUMB_##name,
typedef enum thumb_kind { THUMB_KINDS(THUMB_NAME_KIND) THUMB_KIND_COUNT } thumb_kind;
#undef THUMB_NAME_KIND

/** No register. */
#define THUMB_NONE 16
/** Program counter, which literals are loaded at. */
#define THUMB_PC 15

typedef struct thumb_instruction {
    thumb_kind kind;
    int registers;   /**< Of several, how many words are transferred. */
    int base, index; /**< Registers that the address of a single load or store is made of, or THUMB_NONE. */
    int target;      /**< Register that a single load writes, or THUMB_NONE. */
} thumb_instruction;

/** @param halfwords the instruction's one or two @param bytes 2 or 4 */
thumb_instruction thumb_decode(const uint16_t *halfwords, unsigned bytes);

/** @return 1 where the instruction may go elsewhere than to the next */
int thumb_is_control(thumb_kind kind);

#endif
