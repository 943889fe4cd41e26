/* SPDX-License-Identifier: MIT */
/**
 * @file sample.h
 * Of loops over many of one kind, the share that slow builds go through.
 */
#ifndef GLINT_SAMPLE_H
#define GLINT_SAMPLE_H

#include <stdint.h>
#include <stdlib.h>

/** One in so many is taken, as GLINT_SAMPLE sets it; all where it is not set. */
static inline uint32_t sample_share(void) {
    const char *share = getenv("GLINT_SAMPLE");
    const int parts = share ? atoi(share) : 1;
    return parts > 1 ? (uint32_t)parts : 1;
}

#endif
