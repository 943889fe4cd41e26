/* SPDX-License-Identifier: MIT */
#include "memory.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static void out_of_memory(void) {
    fputs("glint: out of memory\n", stderr);
    exit(2);
}

void *memory_new(size_t count, size_t size) {
    void *memory = calloc(count > 0 ? count : 1, size);
    if (memory == NULL) {
        out_of_memory();
    }
    return memory;
}

void *memory_grow(void *array, size_t *capacity, size_t count, size_t size) {
    if (count < *capacity) {
        return array;
    }
    size_t wanted = count + count / 2 + 16;
    if (wanted < count || wanted > SIZE_MAX / size) {
        out_of_memory();
    }
    void *grown = realloc(array, wanted * size);
    if (grown == NULL) {
        out_of_memory();
    }
    *capacity = wanted;
    return grown;
}
