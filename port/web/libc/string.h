/* SPDX-License-Identifier: MIT */
/** @file string.h What the host program uses of it. */
#ifndef GLINT_WEB_STRING_H
#define GLINT_WEB_STRING_H

#include <stddef.h>

void *memcpy(void *restrict to, const void *restrict from, size_t count);
void *memmove(void *to, const void *from, size_t count);
void *memset(void *to, int value, size_t count);
int memcmp(const void *first, const void *second, size_t count);
void *memchr(const void *memory, int value, size_t count);
size_t strlen(const char *text);
int strcmp(const char *first, const char *second);
int strncmp(const char *first, const char *second, size_t count);
char *strcpy(char *restrict to, const char *restrict from);
char *strchr(const char *text, int value);
char *strrchr(const char *text, int value);
char *strstr(const char *text, const char *part);
char *strpbrk(const char *text, const char *set);
char *strtok(char *restrict text, const char *restrict set);
size_t strspn(const char *text, const char *set);
size_t strcspn(const char *text, const char *set);

#endif
