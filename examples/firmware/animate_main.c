/* SPDX-License-Identifier: MIT */
/*
 * Firmware for boards with room for it: the example scenes, one after another, in motion on whatever the board shows
 * pictures on. After each frame it says "teapot N done", where an emulator can be told to look (board_checkpoint).
 */
#include "animation.h"
#include "board.h"
#include "text.h"

/* BOARD_ARENA, bytes, is what the board can spare, BOARD_TILE_WIDTH and BOARD_TILE_HEIGHT are its tiles'
 * (port/boards.mk). What does not fit costs more passes. */
static uint32_t arena[BOARD_ARENA / sizeof(uint32_t)];
static example_stage stage;

static void report(const char *what, uint32_t number) {
    char digits[TEXT_NUMBER_SIZE];

    board_write(what);
    board_write(text_number(digits, number));
    board_write("\n");
}

static glint_status draw(glint_renderer *renderer, const char *name, uint32_t frame) {
    char line[TEXT_NUMBER_SIZE + 24];
    const glint_status status = glint_render(renderer, &stage.scene);

    if (status != GLINT_OK) {
        report("glint_status -", (uint32_t)-status);
        return status;
    }
    if (frame == 0) {
        report("passes ", renderer->stats.passes);
    }
    board_checkpoint(text_join(line, sizeof line, name, frame));
    return GLINT_OK;
}

int main(void) {
    board_display display;
    glint_renderer renderer;
    const example_scene *scene;

    if (board_display_start(&display)) {
        board_write("the display does not answer\n");
        return 1;
    }
    glint_config config = {.width = display.width,
                           .height = display.height,
                           .tile_width = BOARD_TILE_WIDTH,
                           .tile_height = BOARD_TILE_HEIGHT,
                           .format = animation_format(display.format),
                           .flush = display.flush,
                           .arena = arena,
                           .arena_size = sizeof arena,
                           .keeps_arena = 1};
    glint_status status = GLINT_OK;
    for (uint32_t i = 0; status == GLINT_OK && (scene = animation_build(&stage, i, display.width, display.height)) != 0;
         i++) {
        if (i % ANIMATION_FRAMES == 0) {
            config.layers = stage.layers;
            status = glint_init(&renderer, &config);
        }
        status = status == GLINT_OK ? draw(&renderer, scene->name, i % ANIMATION_FRAMES) : status;
    }
    report("stack used ", board_stack_used());
    return status != GLINT_OK;
}
