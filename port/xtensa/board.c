/* SPDX-License-Identifier: MIT */
/*
 * An Xtensa LX106, the core of an ESP8266, in QEMU's machine `sim`: it shows that the library computes the same bits.
 * There is no panel. Text and exit status go through the emulator's own call (simcall).
 */
#include "board.h"

#include <string.h>

/* Calls of QEMU's simulator of Xtensa. */
enum { SIM_EXIT = 1, SIM_WRITE = 4 };

extern uint32_t linker_stack_bottom[], linker_stack_top[];
extern uint8_t linker_data_load[], linker_data_begin[], linker_data_end[], linker_bss_begin[], linker_bss_end[];

int main(void);

static void call_simulator(int number, uintptr_t a, const void *b, size_t c) {
    register int operation __asm__("a2") = number;
    register uintptr_t first __asm__("a3") = a;
    register const void *second __asm__("a4") = b;
    register size_t third __asm__("a5") = c;

    __asm__ volatile("simcall" : "+r"(operation), "+r"(first) : "r"(second), "r"(third) : "memory");
}

__attribute__((used)) static void start(void) {
    memcpy(linker_data_begin, linker_data_load, (uintptr_t)linker_data_end - (uintptr_t)linker_data_begin);
    memset(linker_bss_begin, 0, (uintptr_t)linker_bss_end - (uintptr_t)linker_bss_begin);
    board_init();
    board_exit(main());
}

/* Begins at the first byte of memory; a literal lies before what loads it. */
__asm__(".section .vectors, \"ax\"\n"
        ".global xtensa_reset\n"
        "xtensa_reset: j 1f\n"
        ".align 4\n"
        ".literal_position\n"
        "1: movi a1, linker_stack_top\n"
        "call0 start\n"
        ".text\n");

void board_init(void) {
}

void board_write(const char *text) {
    size_t length = 0;

    while (text[length] != '\0') {
        length++;
    }
    call_simulator(SIM_WRITE, 1, text, length);
}

void board_exit(int status) {
    call_simulator(SIM_EXIT, (uintptr_t)status, 0, 0);
    for (;;) {
    }
}

void board_delay(uint32_t milliseconds) {
    (void)milliseconds; /* nothing is waited for */
}

const glint_bus *board_panel_bus(void) {
    return 0;
}

static int drop_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context, (void)x, (void)y, (void)width, (void)height, (void)pixels, (void)stride;
    return 0;
}

glint_status board_display_start(board_display *display) {
    *display = (board_display){320, 240, &glint_format_rgb565, {drop_tile, 0, 0}};
    return GLINT_OK;
}

void board_checkpoint(const char *name) {
    board_write(name);
    board_write(" done\n");
}

uint32_t board_stack_used(void) {
    return 0; /* not measured */
}
