/* SPDX-License-Identifier: MIT */
/*
 * Firmware for any board: two models on whatever it shows pictures on. After each frame it says "torus576 N done",
 * where an emulator can be told to look (board_checkpoint).
 */
#include "board.h"
#include "text.h"
#include "turntable/turntable.h"

/** Frames of each model. */
#define FRAMES 2

/* BOARD_ARENA, bytes, is what the board can spare, BOARD_TILE_WIDTH and BOARD_TILE_HEIGHT are its tiles'
 * (port/boards.mk). What does not fit costs more passes. */
static uint32_t arena[BOARD_ARENA / sizeof(uint32_t)];

static void report(const char *what, uint32_t number) {
    char digits[TEXT_NUMBER_SIZE];

    board_write(what);
    board_write(text_number(digits, number));
    board_write("\n");
}

static glint_status draw(glint_renderer *renderer, const board_display *display, turntable_model model,
                         uint32_t frame) {
    char name[TEXT_NUMBER_SIZE + 16];
    turntable table;

    turntable_frame(&table, model, frame);
    turntable_fit(&table, display->width, display->height);
    const glint_status status = glint_render(renderer, &table.scene);
    if (status != GLINT_OK) {
        report("glint_status -", (uint32_t)-status);
        return status;
    }
    report("passes ", renderer->stats.passes);
    board_checkpoint(text_join(name, sizeof name, turntable_name(model), frame));
    return GLINT_OK;
}

int main(void) {
    board_display display;
    glint_renderer renderer;

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
    for (uint32_t i = 0; i < TURNTABLE_SHOWN * FRAMES && status == GLINT_OK; i++) {
        status = draw(&renderer, &display, (turntable_model)(i / FRAMES), i % FRAMES);
    }
    report("stack used ", board_stack_used());
    return status != GLINT_OK;
}
