/* SPDX-License-Identifier: MIT */
/* Firmware for any board: meshes in RAM that change from frame to frame (examples/moving), some frames of them. */
#include "board.h"
#include "moving/moving.h"
#include "text.h"

/** Frames, and degrees from one to the next: the arm is nowhere twice. */
#define FRAMES 5
#define STEP 50

static uint32_t arena[BOARD_ARENA / sizeof(uint32_t)];

int main(void) {
    board_display display;
    glint_renderer renderer;
    char line[TEXT_NUMBER_SIZE + 24];

    if (board_display_start(&display)) {
        board_write("the display does not answer\n");
        return 1;
    }
    const glint_config config = {.width = display.width,
                                 .height = display.height,
                                 .tile_width = BOARD_TILE_WIDTH,
                                 .tile_height = BOARD_TILE_HEIGHT,
                                 .format = display.format,
                                 .flush = display.flush,
                                 .arena = arena,
                                 .arena_size = sizeof arena,
                                 .keeps_arena = 1};
    glint_status status = glint_init(&renderer, &config);
    for (uint32_t i = 0; i < FRAMES && status == GLINT_OK; i++) {
        status = moving_draw(&renderer, (int)i * STEP);
        if (status == GLINT_OK) {
            board_checkpoint(text_join(line, sizeof line, "moving", i));
        }
    }
    text_join(line, sizeof line, "stack used", board_stack_used());
    board_write(line);
    board_write("\n");
    return status != GLINT_OK;
}
