/* SPDX-License-Identifier: MIT */
/**
 * @file board.h
 * What a board gives to firmware. Each directory of a board in port/ implements all of it; start-up code calls
 * board_init before main and board_exit with what main returned.
 */
#ifndef GLINT_BOARD_H
#define GLINT_BOARD_H

#include "glint.h"
#include "panel/bus.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Sets clocks and pins. Bounded: where a clock does not come up, the board runs on, slower, from another. */
void board_init(void);

/** Writes text where a developer sees it: a debugger, an emulator's console, a serial line. @param text ended by 0 */
void board_write(const char *text);

/** Ends the program, and tells the debugger or emulator how. Does not return. @param status 0 for success */
void board_exit(int status);

/** Returns no earlier than after some time. @param milliseconds how long */
void board_delay(uint32_t milliseconds);

/** The bus to the board's panel. @return null when it has none */
const glint_bus *board_panel_bus(void);

/** What a board shows pictures on. */
typedef struct board_display {
    uint16_t width, height;     /**< Pixels. */
    const glint_format *format; /**< What it takes. */
    glint_flush flush;          /**< Where it takes it. */
} board_display;

/** Starts the board's display. @param display set @return GLINT_OK, or what the panel or its bus returns */
glint_status board_display_start(board_display *display);

/**
 * Says that what `name` names is done, and goes on. A debugger or emulator that started the program with arguments
 * whose last word is "stop" gets time to look: then a character from it is waited for.
 * @param name ended by 0
 */
void board_checkpoint(const char *name);

/** Most bytes of stack used so far. @return 0 when the board cannot tell */
uint32_t board_stack_used(void);

#ifdef __cplusplus
}
#endif

#endif
