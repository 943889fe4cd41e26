/* SPDX-License-Identifier: MIT */
/* Made by `make figures`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include <stdint.h>

static const uint32_t pixel_table[] = {
    0xea0feda7u, /* regions */
    0xb4b88266u, /* regions */
    0x7614a274u, /* large regions */
    0xef93c087u, /* large regions */
    0xa353c9d3u, /* large regions */
    0xa4b7f42bu, /* varied regions */
    0xf3242052u, /* varied regions */
    0x628d91b3u, /* varied regions */
    0xa10ce3ffu, /* varied regions */
    0x64cddaafu, /* varied regions */
    0x42d1fed0u, /* varied regions */
    0xf15620b1u, /* varied regions */
    0xb3369783u, /* varied regions */
    0x0204bf4fu, /* varied benchmark */
    0xcbbc743cu, /* varied benchmark */
    0x458fd4bdu, /* varied benchmark */
    0x51ee5b26u, /* varied benchmark */
    0xb6762c02u, /* varied benchmark */
    0x7a3baf11u, /* varied benchmark */
    0x765c7ea9u, /* random surfaces */
    0x8b2d1d9du, /* random surfaces */
    0x7a27560au, /* random surfaces */
    0x5c8d425au, /* random surfaces */
    0x380cd212u, /* random surfaces */
    0x08219756u, /* random surfaces */
    0x013d797au, /* gallery */
    0x7271939eu, /* gallery */
    0x89a64ae2u, /* gallery */
    0x13d11984u, /* gallery */
    0xebf68937u, /* gallery */
    0x0f7f46feu, /* gallery */
    0xa7498897u, /* gallery */
};

#endif
