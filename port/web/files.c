/* SPDX-License-Identifier: MIT */
/**
 * @file files.c
 * Files in memory, in place of the host's output.c: those that the page was given, and one that is written. No other
 * program is run and no other format than OBJ is read, in place of importer.c and reader.c.
 */
#include "files.h"

#include "basics.h"
#include "model.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static web_file files[WEB_FILES_MAX];
static size_t file_count, kept_count;
host_bytes web_written;

void web_files_keep(void) {
    kept_count = file_count;
}

void web_files_forget(void) {
    file_count = kept_count;
    web_written = (host_bytes){NULL, 0, 0};
}

int web_add_file(const char *name, const uint8_t *data, size_t size) {
    if (file_count == WEB_FILES_MAX) {
        return 0;
    }
    files[file_count++] = (web_file){name, data, size};
    return 1;
}

const web_file *web_find_file(const char *name) {
    for (size_t i = file_count; i > 0; i--) {
        if (strcmp(files[i - 1].name, path_base_name(name)) == 0) {
            return &files[i - 1];
        }
    }
    return NULL;
}

uint64_t bytes_hash(const void *data, size_t count) {
    const uint8_t *byte = data;
    uint64_t hash = 0xCBF29CE484222325u;
    for (size_t i = 0; i < count; i++) {
        hash = (hash ^ byte[i]) * 0x100000001B3u;
    }
    return hash;
}

void bytes_add(host_bytes *bytes, uint8_t value) {
    bytes->data = memory_grow(bytes->data, &bytes->capacity, bytes->count, 1);
    bytes->data[bytes->count++] = value;
}

void bytes_print(host_bytes *bytes, const char *format, ...) {
    char text[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    for (const char *c = text; *c != '\0'; c++) {
        bytes_add(bytes, (uint8_t)*c);
    }
}

bool bytes_read_file(host_bytes *bytes, const char *path, size_t most, host_problem *problem) {
    const web_file *file = web_find_file(path);
    (void)most; /* the browser had it in memory */
    if (file == NULL) {
        return problem_set(problem, 0, "is not among the files that were dropped");
    }
    bytes->data = memory_new(file->size, 1); /* the caller's to free */
    memcpy(bytes->data, file->data, file->size);
    bytes->count = bytes->capacity = file->size;
    return true;
}

bool bytes_write_file(const host_bytes *bytes, const char *path, host_problem *problem) {
    (void)path;
    (void)problem;
    web_written.data = memory_new(bytes->count, 1);
    memcpy(web_written.data, bytes->data, bytes->count);
    web_written.count = bytes->count;
    return true;
}

bool bytes_write_pair(const host_file pair[2], const char **wrong, host_problem *problem) {
    *wrong = pair[1].path;
    return problem_set(problem, 0, "cannot be written: the page takes one file");
}

bool path_is_same_file(const char *a, const char *b) {
    (void)a;
    (void)b;
    return false;
}

bool path_is_stdout(const char *path) {
    (void)path;
    return false;
}

bool importer_takes(const char *name) {
    (void)name;
    return false;
}

bool importer_load(const char *name, const child_limits *limits, host_mesh *mesh, host_materials *materials,
                   host_warnings *warnings, host_problem *problem) {
    (void)name, (void)limits, (void)mesh, (void)materials, (void)warnings;
    return problem_set(problem, 0, "only OBJ files are read here");
}

bool importer_decode(const host_bytes *file, const child_limits *limits, host_picture *picture, host_problem *problem) {
    (void)file, (void)limits, (void)picture;
    return problem_set(problem, 0, "it is JPEG, which is not read here: save it as PNG");
}

bool reader_takes(const char *name) {
    (void)name;
    return false;
}

bool reader_load(const char *name, const host_bytes *file, host_mesh *mesh, host_materials *materials,
                 host_warnings *warnings, host_problem *problem) {
    (void)name, (void)file, (void)mesh, (void)materials, (void)warnings;
    return problem_set(problem, 0, "only OBJ files are read here");
}

const char *path_base_name(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}
