/* SPDX-License-Identifier: MIT */
#include "methods.h"

static const method_list *const lists[] = {&methods_power, &methods_normalise};

uint32_t methods_count(void) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < sizeof lists / sizeof lists[0]; i++) {
        count += lists[i]->count;
    }
    return count;
}

const method *methods_get(uint32_t index) {
    const method_list *const first = lists[0], *const second = lists[1];
    return index < first->count ? &first->methods[index] : &second->methods[index - first->count];
}
