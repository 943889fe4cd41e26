/* SPDX-License-Identifier: MIT */
/**
 * @file inflate.h
 * Decompression (RFC 1950, RFC 1951).
 */
#ifndef GLINT_HOST_INFLATE_H
#define GLINT_HOST_INFLATE_H

#include "problem.h"

#include <stdint.h>

/**
 * Unpacks a zlib stream that holds exactly `count` bytes. What follows the stream is not read.
 * @param out room for `count` bytes; what it holds after a failure means nothing
 * @return false with a problem of line 0 when the stream is broken, or holds fewer bytes or more
 */
bool zlib_decode(uint8_t *out, size_t count, const uint8_t *data, size_t size, host_problem *problem);

#endif
