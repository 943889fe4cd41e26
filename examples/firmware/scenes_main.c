/* SPDX-License-Identifier: MIT */
/*
 * Firmware: three of the example scenes on the board's OLED in dithered greys, every variant of each. After each frame
 * it says "teapot-vertex 12 done", where an emulator can be told to look at the panel (board_checkpoint).
 */
#include "board.h"
#include "panel/ssd0323.h"
#include "shown.h"
#include "text.h"

/*
 * Most of the board's 64 KB; the stack (linker script) and the stage take their part. What does not fit costs another
 * pass.
 */
#define ARENA_SIZE (48 * 1024)

static uint32_t arena[ARENA_SIZE / sizeof(uint32_t)];
static example_stage stage;

static void report(const char *what, uint32_t number) {
    char digits[TEXT_NUMBER_SIZE];

    board_write(what);
    board_write(text_number(digits, number));
    board_write("\n");
}

static glint_status draw(glint_renderer *renderer, const shown_frame *shown) {
    char name[SHOWN_NAME_SIZE + TEXT_NUMBER_SIZE];

    shown->scene->build(&stage, shown->variant, shown->frame);
    const glint_status status = glint_render(renderer, &stage.scene);
    if (status != GLINT_OK) {
        report("glint_status -", (uint32_t)-status);
        return status;
    }
    if (shown->variant == 0 && shown->frame == 0) {
        report("passes ", renderer->stats.passes);
        report("arena used ", renderer->stats.arena_used);
    }
    board_checkpoint(text_join(name, sizeof name, shown->name, shown->frame));
    return GLINT_OK;
}

int main(void) {
    const glint_panel panel = {&glint_panel_ssd0323, board_panel_bus()};
    const glint_config config = {.width = 128,
                                 .height = 64,
                                 .format = &glint_format_grey4_dithered,
                                 .flush = glint_panel_flush(&panel),
                                 .arena = arena,
                                 .arena_size = sizeof arena,
                                 .keeps_arena = 1};
    glint_renderer renderer;
    shown_frame shown;

    if (glint_panel_start(&panel)) {
        board_write("the panel does not answer\n");
        return 1;
    }
    glint_status status = glint_init(&renderer, &config);
    for (uint32_t i = 0; status == GLINT_OK && shown_find(&shown, i); i++) {
        status = draw(&renderer, &shown);
    }
    report("stack used ", board_stack_used());
    return status != GLINT_OK;
}
