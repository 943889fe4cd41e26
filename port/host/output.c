/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* POSIX of 2008: open, signals, realpath */

#include "basics.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- Bytes ------------------------------------------------------------------------------------------------------ */

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

/** Whether a file tells beforehand that it has more bytes; streams do not. */
static bool is_larger(FILE *file, size_t most) {
    struct stat about;
    return fstat(fileno(file), &about) == 0 && S_ISREG(about.st_mode) && about.st_size > (off_t)most;
}

bool bytes_read_file(host_bytes *bytes, const char *path, size_t most, host_problem *problem) {
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return problem_set(problem, 0, "cannot be opened: %s", strerror(errno));
    }
    memset(bytes, 0, sizeof *bytes);
    size_t got = 0;
    do {
        bytes->count += got;
        if (bytes->count > most || is_larger(file, most)) {
            free(bytes->data);
            fclose(file);
            return problem_set(problem, 0, "is larger than the %zu MB that are read", most / 1000000);
        }
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

/* ---- Files that are written ------------------------------------------------------------------------------------- */

static bool cannot_be_written(host_problem *problem) {
    return problem_set(problem, 0, "cannot be written: %s", strerror(errno));
}

/** Writes to an open file and closes it. @return false, with errno, when not all was taken */
static bool write_and_close(int file, const host_bytes *bytes) {
    size_t written = 0;
    while (written < bytes->count) {
        const ssize_t taken = write(file, bytes->data + written, bytes->count - written);
        if (taken < 0 && errno != EINTR) {
            const int error = errno;
            close(file);
            errno = error;
            return false;
        }
        written += taken > 0 ? (size_t)taken : 0;
    }
    return close(file) == 0;
}

static bool write_directly(const host_bytes *bytes, const char *path, host_problem *problem) {
    const int file = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    return (file >= 0 && write_and_close(file, bytes)) || cannot_be_written(problem);
}

/* ---- Files that are replaced ------------------------------------------------------------------------------------ */

/** A file that is replaced, or made. */
typedef struct replacement {
    const host_bytes *bytes;
    char *place;       /* where it goes: no link, unless it is_direct; the caller frees it */
    struct stat older; /* the older file, when that exists */
    bool exists;
    bool is_direct; /* what is no regular file is written to as it is */
    char *beside;   /* the new file's name until it is at its place, null for none */
} replacement;

/** Whether a link is the system's name for a file that is open: such as /dev/stdout, /dev/fd/1 and /proc/self/fd/1. */
static bool is_open_file(const char *link) {
    return strncmp(link, "/dev/", 5) == 0 || strncmp(link, "/proc/", 6) == 0;
}

/** Finds where a path leads to. @return false with a problem when it cannot be written there */
static bool find_place(const char *path, replacement *file, host_problem *problem) {
    struct stat own;
    file->exists = stat(path, &file->older) == 0;
    if (file->exists && access(path, W_OK) != 0) { /* a folder that may be written would let it be replaced */
        return cannot_be_written(problem);
    }
    const bool is_link = lstat(path, &own) == 0 && S_ISLNK(own.st_mode);
    file->is_direct = file->exists && (!S_ISREG(file->older.st_mode) || (is_link && is_open_file(path)));
    file->place = is_link && !file->is_direct ? realpath(path, NULL) : strdup(path);
    return file->place != NULL || problem_set(problem, 0, "cannot be written: it is a link to nothing");
}

/** Writes the new file beside its place. @return false, with errno, when that fails; `beside` is then to be removed */
static bool write_beside(replacement *file) {
    const size_t folder = (size_t)(path_base_name(file->place) - file->place);
    const size_t size = folder + 64;
    char *name = memory_new(size, 1);
    int made = -1;
    memcpy(name, file->place, folder);
    errno = EEXIST;
    for (unsigned i = 0; made < 0 && errno == EEXIST && i < 1000; i++) {
        snprintf(name + folder, size - folder, "glint-%ld-%u.part", (long)getpid(), i);
        made = open(name, O_WRONLY | O_CREAT | O_EXCL, 0666);
    }
    if (made < 0) {
        const int error = errno;
        free(name);
        errno = error;
        return false;
    }
    file->beside = name;
    const bool ok = !file->exists || fchmod(made, file->older.st_mode & 0777) == 0;
    return write_and_close(made, file->bytes) && ok;
}

/** Replaces files, none of them before all are written. Signals wait. @param[out] wrong which of them it failed at */
static bool replace(replacement *files, size_t count, size_t *wrong, host_problem *problem) {
    sigset_t all;
    sigset_t before;
    size_t written = 0;
    size_t moved = 0;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before);
    while (written < count && write_beside(&files[written])) {
        written++;
    }
    while (written == count && moved < count && rename(files[moved].beside, files[moved].place) == 0) {
        moved++;
    }
    const bool ok = moved == count || cannot_be_written(problem);
    *wrong = written < count ? written : moved;
    for (size_t i = 0; i < count; i++) {
        if (i >= moved && files[i].beside != NULL) {
            unlink(files[i].beside);
        }
        free(files[i].beside);
    }
    sigprocmask(SIG_SETMASK, &before, NULL);
    return ok;
}

bool bytes_write_file(const host_bytes *bytes, const char *path, host_problem *problem) {
    replacement file = {.bytes = bytes};
    size_t wrong;
    if (!find_place(path, &file, problem)) {
        return false;
    }
    const bool ok = file.is_direct ? write_directly(bytes, path, problem) : replace(&file, 1, &wrong, problem);
    free(file.place);
    return ok;
}

/** Finds where a file of a pair goes, which is no device or pipe. */
static bool find_regular(const char *path, replacement *file, host_problem *problem) {
    return find_place(path, file, problem) &&
           (!file->is_direct || problem_set(problem, 0, "cannot be written: it is no regular file"));
}

bool bytes_write_pair(const host_file pair[2], const char **wrong, host_problem *problem) {
    replacement files[2] = {{.bytes = &pair[0].bytes}, {.bytes = &pair[1].bytes}};
    size_t at = 0;
    bool ok = find_regular(pair[0].path, &files[0], problem);
    if (ok) {
        at = 1;
        ok = find_regular(pair[1].path, &files[1], problem);
    }
    if (ok && path_is_same_file(pair[0].path, pair[1].path)) {
        ok = problem_set(problem, 0, "cannot be written: it is the other file of the pair");
    }
    ok = ok && replace(files, 2, &at, problem);
    *wrong = ok ? NULL : pair[at].path;
    free(files[0].place);
    free(files[1].place);
    return ok;
}

/* ---- Paths ------------------------------------------------------------------------------------------------------ */

bool path_is_same_file(const char *a, const char *b) {
    struct stat of_a;
    struct stat of_b;
    return stat(a, &of_a) == 0 && stat(b, &of_b) == 0 && S_ISREG(of_a.st_mode) && of_a.st_dev == of_b.st_dev &&
           of_a.st_ino == of_b.st_ino;
}

bool path_is_stdout(const char *path) {
    struct stat of_path;
    struct stat of_stdout;
    return stat(path, &of_path) == 0 && fstat(STDOUT_FILENO, &of_stdout) == 0 && of_path.st_dev == of_stdout.st_dev &&
           of_path.st_ino == of_stdout.st_ino;
}

const char *path_base_name(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}
