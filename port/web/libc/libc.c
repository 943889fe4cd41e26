/* SPDX-License-Identifier: MIT */
/**
 * @file libc.c
 * As much of a C library as the host program and the reference take in a browser. Memory is taken from the end and
 * given back as a whole, but for the block taken last; text that is printed waits for the page.
 */
#include "libc.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ---- Memory ------------------------------------------------------------------------------------------------------ */

#define PAGE 65536u
#define UNIT 16u

/** Before each block. */
typedef union block {
    size_t size;
    uint8_t unit[UNIT];
} block;

extern uint8_t __heap_base; /* the linker's */
static uint8_t *top;

void *web_heap_top(void) {
    if (top == NULL) {
        top = (uint8_t *)(((uintptr_t)&__heap_base + UNIT - 1) / UNIT * UNIT);
    }
    return top;
}

void web_heap_return(void *mark) {
    top = mark;
}

void *malloc(size_t size) {
    uint8_t *start = web_heap_top();
    const size_t room = __builtin_wasm_memory_size(0) * PAGE - (size_t)start;
    if (size > SIZE_MAX / 2) {
        return NULL;
    }
    const size_t taken = sizeof(block) + (size + UNIT - 1) / UNIT * UNIT;
    if (taken > room && __builtin_wasm_memory_grow(0, (taken - room + PAGE - 1) / PAGE) == SIZE_MAX) {
        return NULL;
    }
    ((block *)(void *)start)->size = size;
    top = start + taken;
    return start + sizeof(block);
}

void *calloc(size_t count, size_t size) {
    const bool is_empty = count == 0 || size == 0;
    void *memory = !is_empty && count > SIZE_MAX / size ? NULL : malloc(is_empty ? 1 : count * size);
    return memory != NULL ? memset(memory, 0, count * size) : NULL;
}

static bool is_last(const uint8_t *memory) {
    const size_t size = ((const block *)(const void *)(memory - sizeof(block)))->size;
    return memory + (size + UNIT - 1) / UNIT * UNIT == top;
}

void *realloc(void *memory, size_t size) {
    if (memory == NULL) {
        return malloc(size);
    }
    const size_t before = ((block *)(void *)((uint8_t *)memory - sizeof(block)))->size;
    if (is_last(memory)) {
        top = (uint8_t *)memory - sizeof(block);
        return malloc(size); /* in the same place, with the same bytes */
    }
    void *grown = malloc(size);
    return grown != NULL ? memcpy(grown, memory, before < size ? before : size) : NULL;
}

void free(void *memory) {
    if (memory != NULL && is_last(memory)) {
        top = (uint8_t *)memory - sizeof(block);
    }
}

/* ---- Sorting ----------------------------------------------------------------------------------------------------- */

/** Merges two sorted halves; the first goes first where they tie. */
static void merge(uint8_t *items, size_t left, size_t count, size_t size, uint8_t *room,
                  int (*compare)(const void *, const void *)) {
    const uint8_t *a = room, *b = items + left * size;
    const uint8_t *const a_end = room + left * size, *const b_end = items + count * size;
    memcpy(room, items, left * size);
    for (uint8_t *to = items; a < a_end; to += size) {
        const bool from_b = b < b_end && compare(b, a) < 0;
        memcpy(to, from_b ? b : a, size);
        a += from_b ? 0 : size;
        b += from_b ? size : 0;
    }
}

/** From runs of one item to one run. */
void qsort(void *items, size_t count, size_t size, int (*compare)(const void *, const void *)) {
    uint8_t *room = malloc(count * size);
    if (room == NULL) {
        exit(2);
    }
    for (size_t run = 1; run < count; run *= 2) {
        for (size_t at = 0; at + run < count; at += 2 * run) {
            const size_t rest = count - at;
            merge((uint8_t *)items + at * size, run, rest < 2 * run ? rest : 2 * run, size, room, compare);
        }
    }
    free(room);
}

void exit(int status) {
    (void)status;
    __builtin_trap();
}

/* ---- Strings ----------------------------------------------------------------------------------------------------- */

void *memchr(const void *memory, int value, size_t count) {
    const uint8_t *at = memory;
    for (; count > 0; count--, at++) {
        if (*at == (uint8_t)value) {
            return (void *)at;
        }
    }
    return NULL;
}

size_t strlen(const char *text) {
    size_t length = 0;
    while (text[length] != '\0') {
        length++;
    }
    return length;
}

int strncmp(const char *first, const char *second, size_t count) {
    for (; count > 0; count--, first++, second++) {
        if (*first != *second || *first == '\0') {
            return (uint8_t)*first - (uint8_t)*second;
        }
    }
    return 0;
}

int strcmp(const char *first, const char *second) {
    return strncmp(first, second, SIZE_MAX);
}

char *strcpy(char *restrict to, const char *restrict from) {
    return memcpy(to, from, strlen(from) + 1);
}

char *strchr(const char *text, int value) {
    return memchr(text, value, strlen(text) + 1);
}

char *strrchr(const char *text, int value) {
    for (size_t i = strlen(text) + 1; i > 0; i--) {
        if (text[i - 1] == (char)value) {
            return (char *)text + i - 1;
        }
    }
    return NULL;
}

char *strstr(const char *text, const char *part) {
    const size_t length = strlen(part);
    for (; *text != '\0'; text++) {
        if (strncmp(text, part, length) == 0) {
            return (char *)text;
        }
    }
    return length == 0 ? (char *)text : NULL;
}

static bool is_one_of(char c, const char *set) {
    return c != '\0' && strchr(set, c) != NULL;
}

size_t strspn(const char *text, const char *set) {
    size_t length = 0;
    while (is_one_of(text[length], set)) {
        length++;
    }
    return length;
}

size_t strcspn(const char *text, const char *set) {
    size_t length = 0;
    while (text[length] != '\0' && !is_one_of(text[length], set)) {
        length++;
    }
    return length;
}

char *strpbrk(const char *text, const char *set) {
    text += strcspn(text, set);
    return *text != '\0' ? (char *)text : NULL;
}

char *strtok(char *restrict text, const char *restrict set) {
    static char nothing[1];
    static char *next = nothing;
    next = text != NULL ? text : next;
    next += strspn(next, set);
    if (*next == '\0') {
        return NULL;
    }
    char *word = next;
    next += strcspn(next, set);
    if (*next != '\0') {
        *next++ = '\0';
    }
    return word;
}

/* ---- Printing ---------------------------------------------------------------------------------------------------- */

struct web_stream web_stdout, web_stderr;

/** Text that is written as far as there is room. */
typedef struct printer {
    char *to;
    size_t size, count;
} printer;

/** What stands between % and the letter. */
typedef struct conversion {
    char pad;
    int width, digits; /* digits below 0: not given */
    int longs;         /* 64-bit with 2 */
    char letter;
} conversion;

static void put(printer *out, char c) {
    if (out->count + 1 < out->size) {
        out->to[out->count] = c;
    }
    out->count++;
}

static void put_padded(printer *out, const conversion *how, const char *text, size_t length) {
    for (int i = (int)length; i < how->width; i++) {
        put(out, how->pad);
    }
    for (size_t i = 0; i < length; i++) {
        put(out, text[i]);
    }
}

static void put_integer(printer *out, const conversion *how, uint64_t value, bool negative) {
    const unsigned base = how->letter == 'x' ? 16 : 10;
    char text[24];
    size_t at = sizeof text;
    do {
        text[--at] = "0123456789abcdef"[value % base];
        value /= base;
    } while (value > 0);
    if (negative) {
        text[--at] = '-';
    }
    put_padded(out, how, text + at, sizeof text - at);
}

static void put_real(printer *out, const conversion *how, double value) {
    char text[64];
    const int length = web_print_real(value, how->letter, how->digits < 0 ? 6 : how->digits, text);
    put_padded(out, how, text, (size_t)length);
}

static const char *read_conversion(const char *at, conversion *how) {
    *how = (conversion){*at == '0' ? '0' : ' ', 0, -1, 0, 0};
    for (; *at >= '0' && *at <= '9'; at++) {
        how->width = how->width * 10 + (*at - '0');
    }
    if (*at == '.') {
        how->digits = 0;
        for (at++; *at >= '0' && *at <= '9'; at++) {
            how->digits = how->digits * 10 + (*at - '0');
        }
    }
    for (; *at == 'l' || *at == 'z'; at++) {
        how->longs += *at == 'l';
    }
    how->letter = *at;
    return at + (*at != '\0');
}

int vsnprintf(char *restrict to, size_t size, const char *restrict format, va_list arguments) {
    printer out = {to, size, 0};
    while (*format != '\0') {
        conversion how;
        if (*format != '%') {
            put(&out, *format++);
            continue;
        }
        format = read_conversion(format + 1, &how);
        if (how.letter == 's') {
            const char *text = va_arg(arguments, const char *);
            put_padded(&out, &how, text, strlen(text));
        } else if (how.letter == 'c') {
            const char c = (char)va_arg(arguments, int);
            put_padded(&out, &how, &c, 1);
        } else if (how.letter == 'd') {
            const int64_t value = how.longs > 1 ? va_arg(arguments, long long) : va_arg(arguments, int);
            put_integer(&out, &how, value < 0 ? 0 - (uint64_t)value : (uint64_t)value, value < 0);
        } else if (how.letter == 'u' || how.letter == 'x') {
            put_integer(&out, &how, how.longs > 1 ? va_arg(arguments, unsigned long long) : va_arg(arguments, unsigned),
                        false);
        } else if (how.letter == 'f' || how.letter == 'e' || how.letter == 'g') {
            put_real(&out, &how, va_arg(arguments, double));
        } else {
            put(&out, how.letter);
        }
    }
    if (size > 0) {
        to[out.count < size ? out.count : size - 1] = '\0';
    }
    return (int)out.count;
}

int snprintf(char *restrict to, size_t size, const char *restrict format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const int count = vsnprintf(to, size, format, arguments);
    va_end(arguments);
    return count;
}

static int print_to(FILE *stream, const char *format, va_list arguments) {
    const size_t room = sizeof stream->text - stream->count;
    const int count = vsnprintf(stream->text + stream->count, room, format, arguments);
    stream->count += (size_t)count < room ? (size_t)count : room - 1;
    return count;
}

int fprintf(FILE *stream, const char *restrict format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const int count = print_to(stream, format, arguments);
    va_end(arguments);
    return count;
}

int printf(const char *restrict format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const int count = print_to(stdout, format, arguments);
    va_end(arguments);
    return count;
}

int fputs(const char *text, FILE *stream) {
    return fprintf(stream, "%s", text);
}

int fputc(int character, FILE *stream) {
    return fprintf(stream, "%c", character);
}

int puts(const char *text) {
    return printf("%s\n", text);
}
