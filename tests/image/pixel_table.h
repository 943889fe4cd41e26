/* SPDX-License-Identifier: MIT */
/* Made by `make figures`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include <stdint.h>

static const uint32_t pixel_table[] = {
    0xa8b1eb4bu, /* regions */
    0xa5b7e71cu, /* regions */
    0x6d30c33du, /* large regions */
    0x2e487975u, /* large regions */
    0xe44efc3fu, /* large regions */
    0x81833885u, /* varied regions */
    0xc6706a41u, /* varied regions */
    0x2bc5d0b9u, /* varied regions */
    0xde7d6420u, /* varied regions */
    0x33f252fbu, /* varied regions */
    0x498ed9a9u, /* varied regions */
    0x30224695u, /* varied regions */
    0xa679fc78u, /* varied regions */
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
    0xb8747bb6u, /* gallery */
    0x13d11984u, /* gallery */
    0xda8968a0u, /* gallery */
    0x3800b8feu, /* gallery */
};

#endif
