/* SPDX-License-Identifier: MIT */
/** @file libc.h What is behind the standard headers here. */
#ifndef GLINT_WEB_LIBC_H
#define GLINT_WEB_LIBC_H

#include <stdio.h>

/** What was printed, ended by 0; what does not fit is dropped. */
struct web_stream {
    char text[16384];
    size_t count;
};

/** Where the next block of memory begins. */
void *web_heap_top(void);

/** Takes back all memory from such a place on. */
void web_heap_return(void *mark);

/** The browser's: prints a number as %f, %e or %g do. @return its length, at most 64 */
int web_print_real(double value, int letter, int digits, char *text);

#endif
