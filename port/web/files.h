/* SPDX-License-Identifier: MIT */
/** @file files.h Files that the page was given, and what is written. */
#ifndef GLINT_WEB_FILES_H
#define GLINT_WEB_FILES_H

#include "basics.h"

/** Most files at a time: the models that the page brings along, one more, and its materials. */
#define WEB_FILES_MAX 48

typedef struct web_file {
    const char *name; /**< Without a folder. */
    const uint8_t *data;
    size_t size;
} web_file;

/** What bytes_write_file wrote last. */
extern host_bytes web_written;

/** Keeps what was added. */
void web_files_keep(void);

/** Forgets all files that were added since. */
void web_files_forget(void);

/** Adds a file; name and data stay the caller's. @return 0 when there are too many */
int web_add_file(const char *name, const uint8_t *data, size_t size);

/** The file of a path's last part, the one that was added last, or null. */
const web_file *web_find_file(const char *name);

#endif
