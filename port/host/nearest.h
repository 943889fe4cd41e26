/* SPDX-License-Identifier: MIT */
/** @file nearest.h The word that was meant. */
#ifndef GLINT_HOST_NEAREST_H
#define GLINT_HOST_NEAREST_H

#include <stddef.h>

/**
 * By how many letters more, fewer or other a word is another (Levenshtein, 1966). Only the first 32 bytes count.
 * @param length of `word`, which need not be terminated
 */
size_t nearest_distance(const char *word, size_t length, const char *other);

/** Whether a word so far from another may have been meant: one letter in three is wrong at most. */
int nearest_is_meant(size_t length, size_t distance);

#endif
