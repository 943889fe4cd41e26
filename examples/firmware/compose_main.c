/* SPDX-License-Identifier: MIT */
/*
 * Firmware for a board with a panel of 320x240: a model over a picture, a label, a cursor and a clock
 * (examples/compose), some frames of it.
 */
#include "board.h"
#include "compose/compose.h"
#include "text.h"

/** Frames, and how far from one to the next. */
#define FRAMES 3
#define STEP 8

static uint32_t arena[BOARD_ARENA / sizeof(uint32_t)];

int main(void) {
    board_display display;
    char line[TEXT_NUMBER_SIZE + 24];
    glint_status status = GLINT_OK;

    if (board_display_start(&display) || display.width != COMPOSE_WIDTH || display.height != COMPOSE_HEIGHT ||
        display.format != &glint_format_rgb565_be) {
        board_write("the display is no panel of 320x240 with 16 bits a pixel\n");
        return 1;
    }
    for (uint32_t i = 0; i < FRAMES && status == GLINT_OK; i++) {
        status = compose_draw(display.flush, arena, sizeof arena, (int)i * STEP);
        if (status == GLINT_OK) {
            board_checkpoint(text_join(line, sizeof line, "compose", i));
        }
    }
    text_join(line, sizeof line, "stack used", board_stack_used());
    board_write(line);
    board_write("\n");
    return status != GLINT_OK;
}
