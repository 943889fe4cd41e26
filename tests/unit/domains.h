/* SPDX-License-Identifier: MIT */
/**
 * @file domains.h
 * The library's functions of one argument, each with its whole domain, as integers in and out: tests/unit/arithmetic
 * compares them with double precision, and the unit tests compare their bits on every core.
 */
#ifndef GLINT_UNIT_DOMAINS_H
#define GLINT_UNIT_DOMAINS_H

#include <stdint.h>

typedef struct domain {
    const char *name;
    int64_t first, last; /* arguments */
    int64_t (*value)(int64_t x);
} domain;

#define DOMAIN_COUNT 29u

extern const domain domains[DOMAIN_COUNT];

/** Checksum of the function's values at `count` arguments, evenly spread, the first and the last among them. */
uint32_t domain_checksum(const domain *function, uint32_t count);

#endif
