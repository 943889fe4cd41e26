/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* POSIX of 2008: readlink, access */

#include "model.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

/** Between the parts of what glint-import prints, and after them. */
static const char mesh_mark[] = "# mesh\n";
static const char end_mark[] = "# end\n";

bool importer_takes(const char *name) {
    const char *dot = strrchr(path_base_name(name), '.');
    return dot != NULL && dot > path_base_name(name) && strcasecmp(dot, ".obj") != 0;
}

/**
 * Finds the program. @param path set to its path, or to its name alone where the system does not tell this one's folder
 * @return false when it is not there
 */
static bool find_program(char path[PATH_MAX]) {
    static const char name[] = "glint-import";
    const char *given = getenv("GLINT_IMPORT");
    if (given != NULL && strlen(given) < PATH_MAX) {
        strcpy(path, given);
    } else {
        const ssize_t length = readlink("/proc/self/exe", path, PATH_MAX - sizeof name);
        path[length > 0 ? length : 0] = '\0';
        strcpy(path + (path_base_name(path) - path), name);
    }
    return strchr(path, '/') == NULL || access(path, X_OK) == 0;
}

/* ---- Models ----------------------------------------------------------------------------------------------------- */

/** Where a mark begins that is a line of its own, or null. */
static const char *find_line(const host_bytes *text, const char *mark) {
    const size_t length = strlen(mark);
    const char *at = (const char *)text->data;
    const char *end = at + text->count;
    while (at != NULL && (size_t)(end - at) >= length) {
        if (memcmp(at, mark, length) == 0) {
            return at;
        }
        at = memchr(at, '\n', (size_t)(end - at));
        at = at != NULL ? at + 1 : NULL;
    }
    return NULL;
}

/** Adds a warning for each line at the start of a text of whole lines that tells what was left out. */
static void read_skipped(const char *at, const char *end, host_warnings *warnings) {
    static const char mark[] = "# warning ";
    const size_t length = sizeof mark - 1;
    while ((size_t)(end - at) > length && memcmp(at, mark, length) == 0 && warnings->count < PROBLEM_WARNINGS_MAX) {
        const char *next = memchr(at, '\n', (size_t)(end - at));
        char quote[PROBLEM_QUOTE_SIZE];
        problem_set(&warnings->list[warnings->count++], 0, "warning: %s",
                    problem_quote(quote, at + length, (size_t)(next - at) - length));
        at = next + 1;
    }
}

/** Lines are those of what was printed, which nobody sees. */
static void forget_lines(host_warnings *warnings) {
    for (size_t i = 0; i < warnings->count; i++) {
        warnings->list[i].line = 0;
    }
}

static bool read_text(const host_bytes *text, host_mesh *mesh, host_materials *materials, host_warnings *warnings,
                      host_problem *problem) {
    const char *start = (const char *)text->data;
    const char *middle = find_line(text, mesh_mark);
    const size_t end_size = strlen(end_mark);
    if (middle == NULL || text->count < end_size || memcmp(start + text->count - end_size, end_mark, end_size) != 0) {
        return problem_set(problem, 0, "the program gave no whole mesh");
    }
    obj_materials named;
    if (!obj_read(middle, (size_t)(start + text->count - middle), mesh, &named, warnings, problem)) {
        return false;
    }
    memset(materials, 0, sizeof *materials);
    read_skipped(start, middle, warnings);
    mtl_read(start, (size_t)(middle - start), &materials->all, warnings);
    for (size_t i = 0; i < materials->all.count; i++) {
        materials->all.list[i].texture.line = 0;
    }
    materials_name(&named, mesh, materials, warnings);
    obj_materials_free(&named);
    forget_lines(warnings);
    mesh->farthest_line = 0;
    mesh_join(mesh, 0);
    return true;
}

bool importer_load(const char *name, const child_limits *limits, host_mesh *mesh, host_materials *materials,
                   host_warnings *warnings, host_problem *problem) {
    char program[PATH_MAX];
    char *const model = (char *)(uintptr_t)name; /* execvp takes it without const, and leaves it as it is */
    char *const arguments[] = {program, model, NULL};
    if (!find_program(program)) {
        return problem_set(problem, 0,
                           "only OBJ, STL, PLY, OFF and glTF are read: for others install libassimp-dev, and run make "
                           "host again");
    }
    host_bytes text;
    host_problem why;
    bool ok = child_run(arguments, limits, NULL, &text, &why);
    if (ok) {
        ok = read_text(&text, mesh, materials, warnings, &why);
        free(text.data);
    }
    return ok || problem_set(problem, 0, "cannot be imported: %s", why.text);
}

/* ---- Pictures --------------------------------------------------------------------------------------------------- */

/** Bytes before the pixels: the width and the height, the higher byte first. */
#define HEAD_SIZE 4u

static bool read_pixels(const host_bytes *printed, host_picture *picture, host_problem *problem) {
    const uint8_t *from = printed->data;
    const uint32_t width = printed->count >= HEAD_SIZE ? (uint32_t)(from[0] << 8 | from[1]) : 0;
    const uint32_t height = printed->count >= HEAD_SIZE ? (uint32_t)(from[2] << 8 | from[3]) : 0;
    const size_t count = (size_t)width * height;
    if (count == 0 || width > PICTURE_SIDE_MAX || height > PICTURE_SIDE_MAX ||
        printed->count - HEAD_SIZE != 3 * count) {
        return problem_set(problem, 0, "the program gave no whole picture");
    }
    picture->pixels = memory_new(count, sizeof *picture->pixels);
    picture->width = width;
    picture->height = height;
    for (size_t i = 0; i < count; i++) {
        memcpy(picture->pixels[i], from + HEAD_SIZE + 3 * i, 3);
        picture->pixels[i][3] = 255;
    }
    return true;
}

bool importer_decode(const host_bytes *file, const child_limits *limits, host_picture *picture, host_problem *problem) {
    const child_limits fitting = {limits->seconds, limits->megabytes,
                                  HEAD_SIZE + 3 * (size_t)PICTURE_SIDE_MAX * PICTURE_SIDE_MAX};
    char program[PATH_MAX];
    char option[] = "--jpeg";
    char *const arguments[] = {program, option, NULL};
    if (!find_program(program)) {
        return problem_set(problem, 0,
                           "JPEG is read by glint-import: install libassimp-dev and libjpeg-dev, and run make host "
                           "again");
    }
    host_bytes printed;
    host_problem why;
    bool ok = child_run(arguments, &fitting, file, &printed, &why);
    if (ok) {
        ok = read_pixels(&printed, picture, &why);
        free(printed.data);
    }
    return ok || problem_set(problem, 0, "cannot be imported: %s", why.text);
}
