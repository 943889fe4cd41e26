/* SPDX-License-Identifier: MIT */
/**
 * @file deflate.h
 * Compression (RFC 1950, RFC 1951).
 */
#ifndef GLINT_HOST_DEFLATE_H
#define GLINT_HOST_DEFLATE_H

#include "output.h"

/** Appends `data` as a zlib stream. The same data always give the same bytes. */
void zlib_encode(host_bytes *out, const uint8_t *data, size_t count);

/** The checksum that closes a zlib stream: Adler-32. */
uint32_t zlib_checksum(const uint8_t *data, size_t count);

#endif
