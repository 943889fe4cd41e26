/* SPDX-License-Identifier: MIT */
/* The panel of examples/firmware/own_flush.c over a board's bus. It ends the program after some frames. */
#include "firmware/lcd.h"

#include "board.h"
#include "text.h"

/** Bytes of a frame, and frames. */
#define FRAME_BYTES (2 * 320 * 240)
#define FRAMES 4

typedef struct lcd_state {
    const glint_bus *bus;
    size_t sent; /* bytes of pixels */
    int is_dead; /* the panel does not answer */
} lcd_state;

void *lcd_start(void) {
    static lcd_state state;
    board_display display;

    state.is_dead = board_display_start(&display) != GLINT_OK;
    state.bus = board_panel_bus();
    return &state;
}

int lcd_send(void *lcd, uint8_t command, const uint8_t *parameters, size_t count) {
    const lcd_state *state = lcd;

    return state->is_dead || state->bus->command(state->bus->context, &command, 1) != GLINT_OK ||
           (count > 0 && state->bus->data(state->bus->context, parameters, count) != GLINT_OK);
}

int lcd_pixels(void *lcd, const uint8_t *bytes, size_t count) {
    lcd_state *state = lcd;
    char line[TEXT_NUMBER_SIZE + 24];
    const int failed = state->bus->data(state->bus->context, bytes, count) != GLINT_OK;

    state->sent += count;
    if (state->sent % FRAME_BYTES == 0) {
        board_checkpoint(text_join(line, sizeof line, "own", (uint32_t)(state->sent / FRAME_BYTES - 1)));
    }
    if (state->sent == FRAMES * FRAME_BYTES) {
        board_exit(0);
    }
    return failed;
}
