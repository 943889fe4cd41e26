/* SPDX-License-Identifier: MIT */
/*
 * Firmware for boards with a panel in RGB565 and room for it: the night scene in motion, dithered, once round. After
 * each frame it says "night N done", where an emulator can be told to look (board_checkpoint).
 */
#include "night.h"

#include "board.h"
#include "text.h"

static uint32_t arena[BOARD_ARENA / sizeof(uint32_t)];
static example_stage stage;

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
                                 .format = &glint_format_rgb565_be_dithered,
                                 .flush = display.flush,
                                 .arena = arena,
                                 .arena_size = sizeof arena,
                                 .keeps_arena = 1};
    glint_status status = glint_init(&renderer, &config);
    for (uint32_t frame = 0; status == GLINT_OK && frame < NIGHT_FRAMES; frame++) {
        night_build(&stage, frame, display.width, display.height);
        status = glint_render(&renderer, &stage.scene);
        if (status == GLINT_OK) {
            board_checkpoint(text_join(line, sizeof line, "night", frame));
        }
    }
    return status != GLINT_OK;
}
