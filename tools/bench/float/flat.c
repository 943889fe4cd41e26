/* SPDX-License-Identifier: MIT */
/* Kernels without light: it was found before, a triangle or a vertex at a time. */
#include "kernel.h"

void float_draw_flat(const float_draw *draw) {
    draw_list(draw, (float_loop){FLOAT_FLAT, FLOAT_MANY, {FLOAT_UNLIT, 0, 0}});
}

void float_draw_interpolated(const float_draw *draw) {
    draw_list(draw, (float_loop){FLOAT_INTERPOLATED, FLOAT_MANY, {FLOAT_UNLIT, 0, 0}});
}
