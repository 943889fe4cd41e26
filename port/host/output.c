/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* POSIX of 2008: open, rename, signals, realpath */

#include "output.h"

#include "memory.h"

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

bool bytes_read_file(host_bytes *bytes, const char *path, size_t most, host_problem *problem) {
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return problem_set(problem, 0, "cannot be opened: %s", strerror(errno));
    }
    memset(bytes, 0, sizeof *bytes);
    size_t got = 0;
    do {
        bytes->count += got;
        if (bytes->count > most) {
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

/** What ends the program while it writes. */
static const int ends[] = {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU, SIGXFSZ};

#define END_COUNT (sizeof ends / sizeof ends[0])

/** The file that is written beside its place; it exists while remove_unfinished may be called. */
static char *unfinished;

/** Handles a signal once: raised again, it ends the program as it would have without this. */
static void remove_unfinished(int number) {
    unlink(unfinished);
    raise(number);
}

static sigset_t hold_signals(void) {
    sigset_t held;
    sigset_t before;
    sigemptyset(&held);
    for (size_t i = 0; i < END_COUNT; i++) {
        sigaddset(&held, ends[i]);
    }
    sigprocmask(SIG_BLOCK, &held, &before);
    return before;
}

/** Has signals remove the unfinished file, but for those that the program was started to ignore. */
static void handle_signals(struct sigaction before[END_COUNT]) {
    struct sigaction action = {.sa_handler = remove_unfinished};
    sigfillset(&action.sa_mask);
    action.sa_flags = (int)SA_RESETHAND;
    for (size_t i = 0; i < END_COUNT; i++) {
        sigaction(ends[i], NULL, &before[i]);
        if (before[i].sa_handler != SIG_IGN) {
            sigaction(ends[i], &action, NULL);
        }
    }
}

static void restore_signals(const struct sigaction before[END_COUNT]) {
    for (size_t i = 0; i < END_COUNT; i++) {
        sigaction(ends[i], &before[i], NULL);
    }
}

/** Makes a new file in the folder of `path`. @return its descriptor, or -1; the caller frees the name */
static int create_beside(const char *path, char **name) {
    const size_t folder = (size_t)(path_base_name(path) - path);
    const size_t size = folder + 64;
    int file = -1;
    *name = memory_new(size, 1);
    memcpy(*name, path, folder);
    errno = EEXIST;
    for (unsigned i = 0; file < 0 && errno == EEXIST && i < 1000; i++) {
        snprintf(*name + folder, size - folder, "glint-%ld-%u.part", (long)getpid(), i);
        file = open(*name, O_WRONLY | O_CREAT | O_EXCL, 0666);
    }
    return file;
}

/** Replaces the file at `path`, or makes it. `older` tells its permissions, null when there is none. */
static bool replace(const host_bytes *bytes, const char *path, const struct stat *older, host_problem *problem) {
    struct sigaction actions[END_COUNT];
    char *beside;
    sigset_t mask = hold_signals(); /* none comes while the file is there and not known, or known and not there */
    const int file = create_beside(path, &beside);
    bool ok = file >= 0 || cannot_be_written(problem);
    if (ok) {
        unfinished = beside;
        handle_signals(actions);
        sigprocmask(SIG_SETMASK, &mask, NULL);
        ok = older == NULL || fchmod(file, older->st_mode & 0777) == 0;
        ok = (write_and_close(file, bytes) && ok) || cannot_be_written(problem);
        mask = hold_signals();
        ok = ok && (rename(beside, path) == 0 || cannot_be_written(problem));
        if (!ok) {
            unlink(beside);
        }
        restore_signals(actions);
    }
    sigprocmask(SIG_SETMASK, &mask, NULL);
    free(beside);
    return ok;
}

/** Whether a link is the system's name for a file that is open: such as /dev/stdout, /dev/fd/1 and /proc/self/fd/1. */
static bool is_open_file(const char *link) {
    return strncmp(link, "/dev/", 5) == 0 || strncmp(link, "/proc/", 6) == 0;
}

bool bytes_write_file(const host_bytes *bytes, const char *path, host_problem *problem) {
    struct stat status;
    struct stat own;
    const bool exists = stat(path, &status) == 0;
    const bool is_link = lstat(path, &own) == 0 && S_ISLNK(own.st_mode);
    if (exists && access(path, W_OK) != 0) { /* a folder that may be written would let it be replaced all the same */
        return cannot_be_written(problem);
    }
    if (exists && (!S_ISREG(status.st_mode) || (is_link && is_open_file(path)))) {
        return write_directly(bytes, path, problem);
    }
    if (!is_link) {
        return replace(bytes, path, exists ? &status : NULL, problem);
    }
    char *place = realpath(path, NULL);
    if (place == NULL) {
        return problem_set(problem, 0, "cannot be written: it is a link to nothing");
    }
    const bool ok = replace(bytes, place, &status, problem);
    free(place);
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
