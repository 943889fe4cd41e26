/* SPDX-License-Identifier: MIT */
/**
 * @file pages.h
 * Buffers between pages that must not be touched: a read or a write beyond a buffer's end is a fault at once, and one
 * before its first byte is found by canaries; or the other way round.
 */
#ifndef GLINT_ATTACK_PAGES_H
#define GLINT_ATTACK_PAGES_H

#include <stddef.h>
#include <stdint.h>

/** Some pages with a forbidden one on either side; holds one buffer at a time. */
typedef struct pages {
    uint8_t *room; /**< The first usable page. */
    size_t room_size;
    uint8_t *bytes; /**< The buffer. */
    size_t size;
} pages;

/** Reserves room for buffers up to a size; ends the program where there is none. */
void pages_open(pages *of, size_t most);

void pages_close(pages *of);

/**
 * Places a buffer, not set, with canaries at both ends.
 * @param size bytes, at most what the room was opened for
 * @param alignment a power of two
 * @param at_end whether it ends at the forbidden page behind, as nearly as the alignment allows, or begins behind the
 * one before
 * @return its first byte
 */
void *pages_place(pages *of, size_t size, size_t alignment, int at_end);

/** Forbids all writes until pages_unseal. */
void pages_seal(const pages *of);

/** Allows writes again. */
void pages_unseal(const pages *of);

/** Are the canaries as pages_place left them? */
int pages_are_whole(const pages *of);

#endif
