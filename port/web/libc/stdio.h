/* SPDX-License-Identifier: MIT */
/** @file stdio.h What the host program uses of it: formats %s, %c, %d, %u, %x, %e, %f and %g, widths, l, ll and z. */
#ifndef GLINT_WEB_STDIO_H
#define GLINT_WEB_STDIO_H

#include <stdarg.h>
#include <stddef.h>

/** Text that is printed, kept for the page. */
typedef struct web_stream FILE;

extern FILE web_stdout, web_stderr;
#define stdout (&web_stdout)
#define stderr (&web_stderr)

int vsnprintf(char *restrict to, size_t size, const char *restrict format, va_list arguments);
int snprintf(char *restrict to, size_t size, const char *restrict format, ...);
int fprintf(FILE *stream, const char *restrict format, ...);
int printf(const char *restrict format, ...);
int fputs(const char *text, FILE *stream);
int fputc(int character, FILE *stream);
int puts(const char *text);

#endif
