/* SPDX-License-Identifier: MIT */
/**
 * @file checksummed.h
 * Images and runs of numbers whose bits are to be the same on every core, for every compiler and its options.
 */
#ifndef GLINT_UNIT_CHECKSUMMED_H
#define GLINT_UNIT_CHECKSUMMED_H

#include <stdint.h>

#include "fixture.h"

/** Pictures, and how many of them a checksum stands for. */
#define CHECKSUMMED_PICTURES 48u
#define CHECKSUMMED_GROUP 4u

extern const unsigned checksummed_count;

const char *checksummed_name(unsigned index);

/** Draws or computes an entry. @return its checksum. */
uint32_t checksummed_compute(unsigned index);

/** Sets the fixture up to draw a picture. */
void checksummed_set_up(uint32_t number, fixture *f);

#endif
