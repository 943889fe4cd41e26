/* SPDX-License-Identifier: MIT */
#include "methods.h"

static const method_list *const lists[] = {&methods_power,    &methods_normalise,   &methods_divide,
                                           &methods_lighting, &methods_half_vector, &methods_colour,
                                           &methods_rounding};

uint32_t methods_count(void) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < sizeof lists / sizeof lists[0]; i++) {
        count += lists[i]->count;
    }
    return count;
}

const method *methods_get(uint32_t index) {
    uint32_t i = 0;
    while (index >= lists[i]->count) {
        index -= lists[i++]->count;
    }
    return &lists[i]->methods[index];
}
