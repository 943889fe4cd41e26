/* SPDX-License-Identifier: MIT */
#include "nearest.h"

#include <string.h>

/** Bytes of a word that count. */
#define WORD_MAX 32

static size_t least(size_t a, size_t b) {
    return a < b ? a : b;
}

size_t nearest_distance(const char *word, size_t length, const char *other) {
    const size_t across = least(length, WORD_MAX);
    const size_t down = least(strlen(other), WORD_MAX);
    size_t row[WORD_MAX + 1]; /* distances of the word's beginnings from a beginning of the other */
    for (size_t i = 0; i <= across; i++) {
        row[i] = i;
    }
    for (size_t j = 1; j <= down; j++) {
        size_t corner = row[0];
        row[0] = j;
        for (size_t i = 1; i <= across; i++) {
            const size_t changed = corner + (word[i - 1] != other[j - 1]);
            corner = row[i];
            row[i] = least(changed, least(row[i], row[i - 1]) + 1);
        }
    }
    return row[across];
}

int nearest_is_meant(size_t length, size_t distance) {
    return 3 * distance <= length;
}
