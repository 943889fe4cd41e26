/* SPDX-License-Identifier: MIT */
/*
 * Marks around each frame of a firmware (tools/cycles/marks.h), which stays as it is: the linker puts this in place of
 * glint_render (--wrap).
 */
#include "../cycles/marks.h"
#include "glint.h"

glint_status __real_glint_render(glint_renderer *renderer, const glint_scene *scene);
glint_status __wrap_glint_render(glint_renderer *renderer, const glint_scene *scene);

glint_status __wrap_glint_render(glint_renderer *renderer, const glint_scene *scene) {
    CYCLES_START();
    const glint_status status = __real_glint_render(renderer, scene);
    CYCLES_STOP();
    CYCLES_WRITE();
    return status;
}
