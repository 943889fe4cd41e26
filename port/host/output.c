/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L /* lstat */

#include "output.h"

#include "memory.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

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

bool bytes_read_file(host_bytes *bytes, const char *path, host_problem *problem) {
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return problem_set(problem, 0, "cannot be opened: %s", strerror(errno));
    }
    memset(bytes, 0, sizeof *bytes);
    size_t got = 0;
    do {
        bytes->count += got;
        bytes->data = memory_grow(bytes->data, &bytes->capacity, bytes->count, 1);
        got = fread(bytes->data + bytes->count, 1, bytes->capacity - bytes->count, file);
    } while (got > 0);
    const int error = ferror(file) ? errno : 0;
    fclose(file);
    if (error != 0) {
        free(bytes->data);
        return problem_set(problem, 0, "cannot be read: %s", strerror(error));
    }
    return true;
}

static bool write_directly(const host_bytes *bytes, const char *path, host_problem *problem) {
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        return problem_set(problem, 0, "cannot be written: %s", strerror(errno));
    }
    const bool written = fwrite(bytes->data, 1, bytes->count, file) == bytes->count;
    const int error = errno;
    if (fclose(file) != 0 || !written) {
        return problem_set(problem, 0, "cannot be written: %s", strerror(written ? errno : error));
    }
    return true;
}

static bool write_beside(const host_bytes *bytes, const char *beside, const char *path, host_problem *problem) {
    if (!write_directly(bytes, beside, problem)) {
        remove(beside);
        return false;
    }
    if (rename(beside, path) != 0) {
        problem_set(problem, 0, "cannot be written: %s", strerror(errno));
        remove(beside);
        return false;
    }
    return true;
}

bool bytes_write_file(const host_bytes *bytes, const char *path, host_problem *problem) {
    struct stat status;
    /* A device or a link is kept: moving a file over /dev/null would replace it. */
    if (lstat(path, &status) == 0 && !S_ISREG(status.st_mode)) {
        return write_directly(bytes, path, problem);
    }
    const size_t size = strlen(path) + sizeof ".part";
    char *beside = memory_new(size, 1);
    snprintf(beside, size, "%s.part", path);
    const bool ok = write_beside(bytes, beside, path, problem);
    free(beside);
    return ok;
}

const char *path_base_name(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}
