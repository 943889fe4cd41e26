/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* POSIX of 2008: realpath, stat */

#include "import.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/** The model's path as it was given, and its folder without links, ended by a slash. */
static const char *model_path;
static char folder_path[PATH_MAX + 2];

static FILE *stream_of(struct aiFile *file) {
    return (FILE *)(void *)file->UserData;
}

static size_t read_items(struct aiFile *file, char *to, size_t size, size_t count) {
    return fread(to, size, count, stream_of(file));
}

static size_t write_nothing(struct aiFile *file, const char *from, size_t size, size_t count) {
    (void)file;
    (void)from;
    (void)size;
    (void)count;
    return 0;
}

static size_t tell(struct aiFile *file) {
    const long place = ftell(stream_of(file));
    return place < 0 ? 0 : (size_t)place;
}

static size_t size_of(struct aiFile *file) {
    struct stat status;
    return fstat(fileno(stream_of(file)), &status) == 0 ? (size_t)status.st_size : 0;
}

static enum aiReturn seek(struct aiFile *file, size_t offset, enum aiOrigin origin) {
    const int from = origin == aiOrigin_SET ? SEEK_SET : origin == aiOrigin_CUR ? SEEK_CUR : SEEK_END;
    return offset <= LONG_MAX && fseek(stream_of(file), (long)offset, from) == 0 ? aiReturn_SUCCESS : aiReturn_FAILURE;
}

static void flush_nothing(struct aiFile *file) {
    (void)file;
}

static int is_allowed(const char *path) {
    char place[PATH_MAX];
    struct stat status;
    if (stat(path, &status) != 0 || !S_ISREG(status.st_mode)) {
        return 0;
    }
    return strcmp(path, model_path) == 0 ||
           (realpath(path, place) != NULL && strncmp(place, folder_path, strlen(folder_path)) == 0);
}

static struct aiFile *open_file(struct aiFileIO *files, const char *path, const char *mode) {
    (void)files;
    FILE *stream = mode[0] == 'r' && is_allowed(path) ? fopen(path, "rb") : NULL;
    struct aiFile *file = stream != NULL ? calloc(1, sizeof *file) : NULL;
    if (file == NULL) {
        if (stream != NULL) {
            fclose(stream);
        }
        return NULL;
    }
    file->ReadProc = read_items;
    file->WriteProc = write_nothing;
    file->TellProc = tell;
    file->FileSizeProc = size_of;
    file->SeekProc = seek;
    file->FlushProc = flush_nothing;
    file->UserData = (aiUserData)(void *)stream;
    return file;
}

static void close_file(struct aiFileIO *files, struct aiFile *file) {
    (void)files;
    fclose(stream_of(file));
    free(file);
}

int folder_open(struct aiFileIO *files, const char *model) {
    const char *slash = strrchr(model, '/');
    const size_t length = slash != NULL ? (size_t)(slash - model) + 1 : 0;
    char named[PATH_MAX];
    if (length + 2 > sizeof named) {
        return 0;
    }
    memcpy(named, model, length);
    strcpy(named + length, length == 0 ? "." : "");
    if (realpath(named, folder_path) == NULL) {
        return 0;
    }
    if (strcmp(folder_path, "/") != 0) {
        strcat(folder_path, "/");
    }
    model_path = model;
    files->OpenProc = open_file;
    files->CloseProc = close_file;
    files->UserData = NULL;
    return 1;
}
