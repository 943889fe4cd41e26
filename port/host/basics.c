/* SPDX-License-Identifier: MIT */
#include "basics.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Memory -------------------------------------------------------------------------------------------------------
 */

static void out_of_memory(void) {
    fputs("glint: out of memory\n", stderr);
    exit(2);
}

void *memory_new(size_t count, size_t size) {
    void *memory = calloc(count > 0 ? count : 1, size);
    if (memory == NULL) {
        out_of_memory();
    }
    return memory;
}

void *memory_grow(void *array, size_t *capacity, size_t count, size_t size) {
    if (count < *capacity) {
        return array;
    }
    size_t wanted = count + count / 2 + 16;
    if (wanted < count || wanted > SIZE_MAX / size) {
        out_of_memory();
    }
    void *grown = realloc(array, wanted * size);
    if (grown == NULL) {
        out_of_memory();
    }
    *capacity = wanted;
    return grown;
}

/* ---- Problems -----------------------------------------------------------------------------------------------------
 */

static char printable(char c) {
    return (char)(c >= ' ' && c <= '~' ? c : '?');
}

bool problem_set(host_problem *problem, size_t line, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    problem->line = line;
    vsnprintf(problem->text, sizeof problem->text, format, arguments);
    va_end(arguments);
    return false;
}

const char *problem_quote(char out[PROBLEM_QUOTE_SIZE], const char *start, size_t length) {
    const bool whole = length < PROBLEM_QUOTE_SIZE;
    const size_t kept = whole ? length : PROBLEM_QUOTE_SIZE - 4;
    for (size_t i = 0; i < kept; i++) {
        out[i] = printable(start[i]);
    }
    strcpy(out + kept, whole ? "" : "...");
    return out;
}

void problem_print(const char *file, const host_problem *problem) {
    if (file == NULL) {
        fprintf(stderr, "glint: %s\n", problem->text);
        return;
    }
    for (; *file != '\0'; file++) {
        /* File names may hold any byte; only control characters would break the one line. */
        fputc((unsigned char)*file < ' ' ? '?' : *file, stderr);
    }
    fprintf(stderr, ":%zu: %s\n", problem->line, problem->text);
}

void problem_print_warnings(const char *file, const host_warnings *warnings) {
    for (size_t i = 0; i < warnings->count; i++) {
        problem_print(file, &warnings->list[i]);
    }
}
