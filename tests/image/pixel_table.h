/* SPDX-License-Identifier: MIT */
/* Made by `make figures`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include <stdint.h>

static const uint32_t pixel_table[] = {
    0x41053764u, /* regions */
    0x46d8a5d4u, /* regions */
    0xe86aa2c4u, /* large regions */
    0xef93c087u, /* large regions */
    0x16060117u, /* large regions */
    0xa98a697fu, /* varied regions */
    0x21de6b96u, /* varied regions */
    0x33aff565u, /* varied regions */
    0x5fdf0797u, /* varied regions */
    0x0a003cc2u, /* varied regions */
    0x667a358cu, /* varied regions */
    0x40e2b119u, /* varied regions */
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
