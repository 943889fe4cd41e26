/* SPDX-License-Identifier: MIT */
/**
 * @file fuzz_import.c
 * What reads the output of glint-import, on any bytes (libFuzzer): the program is not run, a function in place of
 * child_run hands them out. It either reports one problem, or gives a mesh whose triangles have materials that are
 * there, and no two of whose positions are the same; and likewise a picture that has all its pixels.
 */
#define _POSIX_C_SOURCE 200112L /* setenv */

#include "checks.h"
#include "model.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerInitialize(const int *count, char ***arguments);

static const uint8_t *printed;
static size_t printed_size;

/** Stands for the one of child.c: what it prints is the input, in memory of its size; nothing at all is a failure. */
bool child_run(char *const arguments[], const child_limits *limits, const host_bytes *input, host_bytes *out,
               host_problem *problem) {
    (void)arguments;
    (void)limits;
    (void)input;
    *out = (host_bytes){NULL, 0, 0};
    if (printed_size == 0) {
        return problem_set(problem, 0, "failed without a word");
    }
    out->data = allocate(printed_size);
    out->count = out->capacity = printed_size;
    memcpy(out->data, printed, printed_size);
    return true;
}

/** A name without a folder is not looked for before it is run. */
int LLVMFuzzerInitialize(const int *count, char ***arguments) {
    (void)count;
    (void)arguments;
    return setenv("GLINT_IMPORT", "input", 1);
}

/** The first bytes as a model's name: without a dot it is for no program. */
static void check_name(const uint8_t *data, size_t size) {
    char name[32] = "";
    memcpy(name, data, size < sizeof name ? size : sizeof name - 1);
    require(!importer_takes(name) || strchr(name, '.') != NULL);
}

static void check_refusal(const host_problem *problem) {
    check_problem(problem);
    require(problem->line == 0 && strncmp(problem->text, "cannot be imported: ", 20) == 0);
}

static void check_picture(const child_limits *limits) {
    host_picture picture;
    host_problem problem = {0, ""};
    if (!importer_decode(NULL, limits, &picture, &problem)) {
        check_refusal(&problem);
        return;
    }
    require(picture.width >= 1 && picture.width <= PICTURE_SIDE_MAX);
    require(picture.height >= 1 && picture.height <= PICTURE_SIDE_MAX);
    for (size_t i = 0; i < (size_t)picture.width * picture.height; i++) {
        require(memcmp(picture.pixels[i], printed + 4 + 3 * i, 3) == 0 && picture.pixels[i][3] == 255);
    }
    free(picture.pixels);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const child_limits limits = {1, 1, 1};
    host_mesh mesh;
    host_materials materials;
    host_warnings warnings;
    host_problem problem = {0, ""};
    check_name(data, size);
    printed = data;
    printed_size = size;
    check_picture(&limits);
    if (!importer_load("model.glb", &limits, &mesh, &materials, &warnings, &problem)) {
        check_refusal(&problem);
        return 0;
    }
    check_warnings(&warnings, 0);
    check_materials(&materials.all);
    for (size_t i = 0; i < mesh.triangle_count; i++) {
        require(mesh.materials[i] <= materials.used_count);
        require((materials_find(&materials, mesh.materials[i]) == NULL) == (mesh.materials[i] == 0));
    }
    require(mesh_join(&mesh, 0) == 0);
    check_mesh(&mesh);
    materials_free(&materials);
    mesh_free(&mesh);
    return 0;
}
