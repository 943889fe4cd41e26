/* SPDX-License-Identifier: MIT */
/*
 * What `make run` puts around a program (--wrap), which stays as it is: each frame that glint_render draws, and the
 * program's end, are checkpoints, where an emulator looks, and what a frame costs is counted. With no debugger nothing
 * changes.
 */
#include "../../tools/cycles/marks.h"
#include "board.h"
#include "text.h"

glint_status __real_glint_render(glint_renderer *renderer, const glint_scene *scene);
glint_status __wrap_glint_render(glint_renderer *renderer, const glint_scene *scene);
int __real_main(void);
int __wrap_main(void);

glint_status __wrap_glint_render(glint_renderer *renderer, const glint_scene *scene) {
    static uint32_t frame;
    char name[TEXT_NUMBER_SIZE + 8];

    CYCLES_START();
    const glint_status status = __real_glint_render(renderer, scene);
    CYCLES_STOP();
    CYCLES_WRITE();
    if (status == GLINT_OK) {
        board_checkpoint(text_join(name, sizeof name, "frame", frame++));
    }
    return status;
}

int __wrap_main(void) {
    const int status = __real_main();

    board_checkpoint("last 0");
    return status;
}
