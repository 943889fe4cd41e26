/* SPDX-License-Identifier: MIT */
/* Firmware that shows a scene as the window exported it: the header EXPORTED with EXPORTED_scene and EXPORTED_config.
 */
#include "board.h"

#include EXPORTED_HEADER

static uint32_t arena[BOARD_ARENA / sizeof(uint32_t)];

int main(void) {
    board_display display;
    glint_renderer renderer;
    glint_config config = EXPORTED_CONFIG;

    if (board_display_start(&display) || display.format != config.format) {
        board_write("no such display\n");
        return 1;
    }
    config.flush = display.flush;
    config.arena = arena;
    config.arena_size = sizeof arena;
    const glint_status status = glint_init(&renderer, &config) || glint_render(&renderer, &EXPORTED_SCENE);
    if (status == GLINT_OK) {
        board_checkpoint("exported 0");
    }
    return status != GLINT_OK;
}
