/* SPDX-License-Identifier: MIT */
/**
 * @file progress.h
 * A line on stderr about work that takes longer than a second, rewritten while it goes on and erased at its end. Where
 * stderr is no terminal nothing is written. Takes POSIX: a timer's signal, SIGALRM, writes it.
 */
#ifndef GLINT_HOST_PROGRESS_H
#define GLINT_HOST_PROGRESS_H

#include <stdint.h>

/**
 * Begins a piece of work, of which one goes on at a time.
 * @param doing what is done, a few words
 * @param name what it is done to, or null
 */
void progress_begin(const char *doing, const char *name);

/** Says which frame of how many the work is at, counted from 1. */
void progress_frame(uint32_t frame, uint32_t count);

/** Ends the work: call it before anything else is written. */
void progress_end(void);

#endif
