/* SPDX-License-Identifier: MIT */
/**
 * @file lights.h
 * Makes the kernels of one choice of lights: a file defines LIGHTS and CHOOSE, and includes this.
 */
#include "kernel.h"

#define KERNEL(name, model, local, options)                                           \
    static void name(const float_draw *draw) {                                        \
        draw_list(draw, (float_loop){FLOAT_LIGHTS, LIGHTS, {model, local, options}}); \
    }

#define KERNELS(name, model, local)                     \
    KERNEL(name##_plain, model, local, 0)               \
    KERNEL(name##_colours, model, local, FLOAT_COLOURS) \
    KERNEL(name##_any, model, local, FLOAT_ANY)

KERNELS(diffuse, FLOAT_DIFFUSE, 0)
KERNELS(blinn_phong, FLOAT_BLINN_PHONG, 0)
KERNELS(blinn_phong_local, FLOAT_BLINN_PHONG, 1)
KERNELS(phong, FLOAT_PHONG, 0)
KERNELS(phong_local, FLOAT_PHONG, 1)

#define ENTRIES(name) \
    { name##_plain, name##_colours, name##_any }

/* By model, viewer and options. */
static float_kernel *const kernels[3][2][3] = {
    {ENTRIES(diffuse), ENTRIES(diffuse)},
    {ENTRIES(blinn_phong), ENTRIES(blinn_phong_local)},
    {ENTRIES(phong), ENTRIES(phong_local)},
};

float_kernel *CHOOSE(const float_draw *draw) {
    const uint32_t options = draw->surface.options;

    return kernels[draw->surface.model - FLOAT_DIFFUSE][draw->frame->local][options == 0               ? 0
                                                                            : options == FLOAT_COLOURS ? 1
                                                                                                       : 2];
}
