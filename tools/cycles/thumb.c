/* SPDX-License-Identifier: MIT */
#include "thumb.h"

static thumb_instruction of_kind(thumb_kind kind) {
    return (thumb_instruction){.kind = kind, .base = THUMB_NONE, .index = THUMB_NONE, .target = THUMB_NONE};
}

static thumb_instruction of_several(thumb_kind kind, int registers) {
    thumb_instruction decoded = of_kind(kind);

    decoded.registers = registers;
    return decoded;
}

static thumb_instruction of_load(int target, int base, int index) {
    thumb_instruction decoded = of_kind(target == THUMB_PC ? THUMB_load_jump : THUMB_load);

    decoded.target = target;
    decoded.base = base;
    decoded.index = index;
    return decoded;
}

static thumb_instruction of_store(int base, int index) {
    thumb_instruction decoded = of_kind(index == THUMB_NONE ? THUMB_store : THUMB_store_indexed);

    decoded.base = base;
    decoded.index = index;
    return decoded;
}

static int bits_set(unsigned list) {
    int count = 0;

    for (; list; list &= list - 1)
        count++;
    return count;
}

/* ---- 16 bits ---- */

/* ADD, CMP, MOV of high registers; BX, BLX. */
static thumb_kind high_registers(unsigned code) {
    const unsigned operation = code >> 8 & 3;
    const unsigned target = (code >> 4 & 8) | (code & 7);

    return operation == 3 || (operation != 1 && target == THUMB_PC) ? THUMB_jump : THUMB_plain;
}

static thumb_instruction miscellaneous(unsigned code) {
    if ((code & 0xf500) == 0xb100)
        return of_kind(THUMB_branch);
    if ((code & 0xfe00) == 0xb400)
        return of_several(THUMB_multiple, bits_set(code & 0x1ff));
    if ((code & 0xfe00) == 0xbc00)
        return of_several(code & 0x100 ? THUMB_multiple_jump : THUMB_multiple, bits_set(code & 0x1ff));
    return of_kind(THUMB_plain);
}

static thumb_instruction decode_16(unsigned code) {
    const int low = (int)(code & 7), next = (int)(code >> 3 & 7), third = (int)(code >> 6 & 7);
    const int high = (int)(code >> 8 & 7);

    switch (code >> 12) {
    case 4:
        if ((code & 0xffc0) == 0x4340)
            return of_kind(THUMB_multiply);
        if ((code & 0xfc00) == 0x4400)
            return of_kind(high_registers(code));
        return code & 0x800 ? of_load(high, THUMB_PC, THUMB_NONE) : of_kind(THUMB_plain);
    case 5:
        return (code >> 9 & 7) >= 3 ? of_load(low, next, third) : of_store(next, third);
    case 6:
    case 7:
    case 8:
        return code & 0x800 ? of_load(low, next, THUMB_NONE) : of_store(next, THUMB_NONE);
    case 9:
        return code & 0x800 ? of_load(high, 13, THUMB_NONE) : of_store(13, THUMB_NONE);
    case 11:
        return miscellaneous(code);
    case 12:
        return of_several(THUMB_multiple, bits_set(code & 0xff));
    case 13:
        return of_kind((code >> 8 & 15) < 14 ? THUMB_branch : THUMB_system);
    case 14:
        return of_kind(THUMB_branch);
    default:
        return of_kind(THUMB_plain);
    }
}

/* ---- 32 bits ---- */

/* Several registers; two registers; exclusive ones; table branches. */
static thumb_instruction several_32(unsigned first, unsigned second) {
    const int loads = first >> 4 & 1;

    if (!(first & 0x40))
        return of_several(loads && second >> THUMB_PC ? THUMB_multiple_jump : THUMB_multiple, bits_set(second));
    if ((first & 0xfff0) == 0xe8d0 && (second & 0xffe0) == 0xf000)
        return of_kind(THUMB_table);
    return of_several(THUMB_multiple, 2);
}

static thumb_instruction single_32(unsigned first, unsigned second) {
    const int base = (int)(first & 15), target = (int)(second >> 12);
    /* Neither a constant of 12 bits, nor of 8, nor the program counter: a register. */
    const int is_indexed = !(first & 0x80) && base != THUMB_PC && !(second & 0x800);
    const int index = is_indexed ? (int)(second & 15) : THUMB_NONE;

    return first & 0x10 ? of_load(target, base, index) : of_store(base, index);
}

static thumb_kind multiply_32(unsigned first, unsigned second) {
    if (first & 0x80) {
        switch (first >> 4 & 7) {
        case 1:
        case 3:
            return THUMB_divide;
        case 0:
        case 2:
            return THUMB_multiply_long;
        default:
            return THUMB_accumulate_long;
        }
    }
    return second >> 12 == 15 ? THUMB_multiply : THUMB_multiply_add;
}

/* Branches, and what has to do with the system. */
static thumb_kind control_32(unsigned first, unsigned second) {
    if (second & 0x4000)
        return THUMB_call;
    if (second & 0x1000 || (first >> 6 & 15) < 14)
        return THUMB_branch;
    return THUMB_system;
}

static thumb_instruction of_float_transfer(unsigned first) {
    thumb_instruction decoded = of_kind(first & 0x10 ? THUMB_float_load : THUMB_float_store);

    decoded.base = (int)(first & 15);
    return decoded;
}

static thumb_instruction float_32(unsigned first, unsigned second) {
    if ((first & 0xff00) == 0xee00) {
        const unsigned operation = first >> 4 & 11;

        if (second & 0x10)
            return of_kind(THUMB_float_plain);
        if (operation == 8 || (operation == 11 && (first & 15) == 1 && (second & 0xc0) == 0xc0))
            return of_kind(THUMB_float_divide);
        return of_kind(operation < 2 || operation == 9 || operation == 10 ? THUMB_float_add : THUMB_float_plain);
    }
    if ((first & 0xffe0) == 0xec40)
        return of_kind(THUMB_float_pair);
    if ((first & 0x120) == 0x100)
        return of_float_transfer(first);
    return of_several(THUMB_multiple, (int)(second & 0xff));
}

static thumb_instruction decode_32(unsigned first, unsigned second) {
    if ((first & 0xfe00) == 0xe800)
        return several_32(first, second);
    if ((first & 0xfe00) == 0xec00 || (first & 0xff00) == 0xee00)
        return float_32(first, second);
    if ((first & 0xf800) == 0xf000)
        return of_kind(second & 0x8000 ? control_32(first, second) : THUMB_plain);
    if ((first & 0xfe00) == 0xf800)
        return single_32(first, second);
    if ((first & 0xff00) == 0xfb00)
        return of_kind(multiply_32(first, second));
    return of_kind(THUMB_plain);
}

thumb_instruction thumb_decode(const uint16_t *halfwords, unsigned bytes) {
    return bytes == 4 ? decode_32(halfwords[0], halfwords[1]) : decode_16(halfwords[0]);
}

int thumb_is_control(thumb_kind kind) {
    return kind >= THUMB_branch && kind <= THUMB_multiple_jump;
}
