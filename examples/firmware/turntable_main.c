/* SPDX-License-Identifier: MIT */
/*
 * Firmware: a torus and then a teapot turn on the board's OLED, tile by tile over SPI. After each frame it says
 * "torus576 N done", where an emulator can be told to look at the panel (board_checkpoint).
 */
#include "board.h"
#include "panel/ssd0323.h"
#include "text.h"
#include "turntable/turntable.h"

/*
 * Tile buffers and, as far as it goes, the frame's vertices and bins; what does not fit costs another pass. All of the
 * 32 KB that this firmware allows itself but for the stack (linker script) and a few variables.
 */
#define ARENA_SIZE (28 * 1024)

static uint32_t arena[ARENA_SIZE / sizeof(uint32_t)];

static void report(const char *what, uint32_t number) {
    char digits[TEXT_NUMBER_SIZE];

    board_write(what);
    board_write(text_number(digits, number));
    board_write("\n");
}

static glint_status draw(glint_renderer *renderer, turntable_model model, uint32_t frame) {
    char name[TEXT_NUMBER_SIZE + 16];
    turntable table;

    turntable_frame(&table, model, frame);
    glint_status status = glint_render(renderer, &table.scene);
    if (status != GLINT_OK) {
        report("glint_status -", (uint32_t)-status); /* glint_strerror's sentences would take 1.5 KB of flash */
        return status;
    }
    if (frame == 0) {
        report("passes ", renderer->stats.passes);
        report("arena used ", renderer->stats.arena_used);
    }
    board_checkpoint(text_join(name, sizeof name, turntable_name(model), frame));
    return GLINT_OK;
}

int main(void) {
    const glint_panel panel = {&glint_panel_ssd0323, board_panel_bus()};
    glint_renderer renderer;
    glint_config config = {.width = TURNTABLE_WIDTH, .height = TURNTABLE_HEIGHT};
    glint_status status;

    if (glint_panel_start(&panel)) {
        board_write("the panel does not answer\n");
        return 1;
    }
    config.format = panel.type->format;
    config.flush = glint_panel_flush(&panel);
    config.arena = arena;
    config.arena_size = sizeof arena;
    config.keeps_arena = 1;
    status = glint_init(&renderer, &config);
    for (uint32_t i = 0; i < TURNTABLE_MODELS * TURNTABLE_FRAMES && status == GLINT_OK; i++) {
        status = draw(&renderer, (turntable_model)(i / TURNTABLE_FRAMES), i % TURNTABLE_FRAMES);
    }
    report("stack used ", board_stack_used());
    return status != GLINT_OK;
}
