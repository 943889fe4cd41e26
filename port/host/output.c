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
#include <sys/file.h>
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

/** What ends the program while it writes. */
static const int ends[] = {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU, SIGXFSZ};

#define END_COUNT (sizeof ends / sizeof ends[0])

/** Most files that are replaced at once. */
#define FILES_MAX 2

/** The files that are written beside their places, null for none; they exist while remove_unfinished may be called. */
static char *unfinished[FILES_MAX];

/** Handles a signal once: raised again, it ends the program as it would have without this. */
static void remove_unfinished(int number) {
    for (size_t i = 0; i < FILES_MAX; i++) {
        if (unfinished[i] != NULL) {
            unlink(unfinished[i]);
        }
    }
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

/** Has signals remove the unfinished files, but for those that the program was started to ignore. */
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

/** A file that is replaced, or made. */
typedef struct replacement {
    const host_bytes *bytes;
    char *place;       /* where it goes: no link, unless it is_direct; the caller frees it */
    struct stat older; /* the older file, when that exists */
    bool exists;
    bool is_direct; /* what is no regular file is written to as it is */
    bool is_moved;  /* the new file is at its place */
    char *beside;   /* the new file's name until then, null for none */
    char *kept;     /* the older file's name while it may have to come back, null for none */
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

/** Room for the name of a file in the folder of `path`; the caller frees it. */
static char *new_name(const char *path, size_t *folder, size_t *size) {
    *folder = (size_t)(path_base_name(path) - path);
    *size = *folder + 64;
    char *name = memory_new(*size, 1);
    memcpy(name, path, *folder);
    return name;
}

/** Makes a new file, empty or as another name of `older`. @return its descriptor, 0 for a name, or -1 */
static int create(const char *name, const char *older) {
    return older != NULL ? link(older, name) : open(name, O_WRONLY | O_CREAT | O_EXCL, 0666);
}

/**
 * Makes a new file in the folder of `path`: empty, or as another name of `older`.
 * @return as create does; the caller frees the name, null for -1
 */
static int create_beside(const char *path, const char *older, char **name) {
    size_t folder;
    size_t size;
    int file = -1;
    *name = new_name(path, &folder, &size);
    errno = EEXIST;
    for (unsigned i = 0; file < 0 && errno == EEXIST && i < 1000; i++) {
        snprintf(*name + folder, size - folder, "glint-%ld-%u.part", (long)getpid(), i);
        file = create(*name, older);
    }
    if (file < 0) {
        const int error = errno;
        free(*name);
        *name = NULL;
        errno = error;
    }
    return file;
}

/** Writes the new file beside its place, as unfinished file `number`; signals come meanwhile as `mask` lets them. */
static bool write_beside(replacement *file, size_t number, const sigset_t *mask) {
    const int descriptor = create_beside(file->place, NULL, &file->beside);
    if (descriptor < 0) {
        return false;
    }
    unfinished[number] = file->beside;
    sigprocmask(SIG_SETMASK, mask, NULL);
    const bool ok = !file->exists || fchmod(descriptor, file->older.st_mode & 0777) == 0;
    const bool is_written = write_and_close(descriptor, file->bytes);
    hold_signals();
    return is_written && ok;
}

/** Moves the older file aside, if there is one. @return false, with errno and the file as it was, when that fails */
static bool move_older(replacement *file) {
    const int name_only = create_beside(file->place, NULL, &file->kept);
    if (name_only < 0) {
        return false;
    }
    close(name_only);
    if (rename(file->place, file->kept) == 0) {
        return true;
    }
    const int error = errno;
    unlink(file->kept);
    free(file->kept);
    file->kept = NULL;
    errno = error;
    return error == ENOENT;
}

/**
 * Gives the older file, if there is one, a second name, so that its place is never empty; where files have one name
 * only, moves it aside.
 */
static bool keep_older(replacement *file) {
    return create_beside(file->place, file->place, &file->kept) == 0 || errno == ENOENT || move_older(file);
}

/** Moves the new file to its place. */
static bool move_into_place(replacement *file) {
    file->is_moved = rename(file->beside, file->place) == 0;
    return file->is_moved;
}

/** Leaves the new file at its place and nothing else, or what was there before. */
static void finish(replacement *file, bool ok) {
    if (file->beside != NULL && !file->is_moved) {
        unlink(file->beside);
    }
    if (file->kept != NULL) {
        if (ok || rename(file->kept, file->place) == 0) {
            unlink(file->kept); /* after rename as well, which leaves two names of one file */
        }
    } else if (!ok && file->is_moved) {
        unlink(file->place);
    }
    free(file->beside);
    free(file->kept);
}

/** Waits until no other writer of a pair moves files in the folder of `path`. @return what to close, or -1 for none */
static int lock_folder(const char *path, const sigset_t *mask) {
    size_t folder;
    size_t size;
    char *name = new_name(path, &folder, &size);
    snprintf(name + folder, size - folder, ".");
    const int lock = open(name, O_RDONLY);
    free(name);
    sigprocmask(SIG_SETMASK, mask, NULL);
    while (lock >= 0 && flock(lock, LOCK_EX) != 0 && errno == EINTR) {
    }
    hold_signals();
    return lock;
}

/** Moves new files to their places; older ones are kept before, as long as a later move may fail. @return how many */
static size_t move_files(replacement *files, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const bool may_come_back = i + 1 < count;
        if ((may_come_back && !keep_older(&files[i])) || !move_into_place(&files[i])) {
            return i;
        }
    }
    return count;
}

/** Replaces all files or none. @param[out] wrong which of them it failed at */
static bool replace(replacement *files, size_t count, size_t *wrong, host_problem *problem) {
    struct sigaction actions[END_COUNT];
    const sigset_t mask = hold_signals(); /* none comes while a file is there and not known, or known and not there */
    handle_signals(actions);
    size_t done = 0;
    while (done < count && write_beside(&files[done], done, &mask)) {
        done++;
    }
    const int lock = count > 1 && done == count ? lock_folder(files[0].place, &mask) : -1;
    done = done == count ? move_files(files, count) : done;
    const bool ok = done == count || cannot_be_written(problem);
    *wrong = done;
    for (size_t i = 0; i < count; i++) {
        finish(&files[i], ok);
        unfinished[i] = NULL;
    }
    if (lock >= 0) {
        close(lock);
    }
    restore_signals(actions);
    sigprocmask(SIG_SETMASK, &mask, NULL);
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
