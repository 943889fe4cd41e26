/* SPDX-License-Identifier: MIT */
/**
 * @file fuzz_mtl.c
 * The reader of MTL on any bytes (libFuzzer), as two files of one model, cut at its first byte of 0: nothing in them is
 * an error, what is kept is in range, what the first file gave stays as it was, and the library takes each material.
 */
#include "checks.h"
#include "settings.h"

#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check_channels(glint_colour colour) {
    require(colour.r >= 0 && colour.g >= 0 && colour.b >= 0);
    require(colour.r <= GLINT_COLOUR_MAX && colour.g <= GLINT_COLOUR_MAX && colour.b <= GLINT_COLOUR_MAX);
}

static void check_lit(const mtl_material *file) {
    const host_settings settings = {.shininess = GLINT_Q16(32)};
    const glint_material material = settings_material(&settings, file);
    check_channels(material.ambient);
    check_channels(material.diffuse);
    check_channels(material.specular);
    require(material.shininess >= 0 && material.model != NULL);
}

/** Reads a file from memory that ends where it does, so that reading on is seen; gone when it is read. */
static void read_file(const uint8_t *data, size_t size, mtl_library *library) {
    host_warnings warnings = {.count = 0};
    char *memory = allocate(size + 1);
    memcpy(memory + 1, data, size);
    mtl_read(memory + 1, size, library, &warnings);
    free(memory);
    check_warnings(&warnings, 1);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const uint8_t *cut = size > 0 ? memchr(data, '\0', size) : NULL;
    const size_t first = cut != NULL ? (size_t)(cut - data) : size;
    mtl_library library = {NULL, 0, 0};
    read_file(data, first, &library);
    const size_t kept = library.count;
    const char *last = kept > 0 ? library.list[kept - 1].name : NULL;
    if (cut != NULL) {
        read_file(cut + 1, size - first - 1, &library);
    }
    require(library.count >= kept && (kept == 0 || library.list[kept - 1].name == last));
    check_materials(&library);
    for (size_t i = 0; i < library.count; i++) {
        check_lit(&library.list[i]);
    }
    mtl_free(&library);
    return 0;
}
