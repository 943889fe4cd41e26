/* SPDX-License-Identifier: MIT */
/* Made by `make figures`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include <stdint.h>

static const uint32_t pixel_table[] = {
    0x260d0402u, /* regions */
    0xa10157afu, /* regions */
    0x8167f177u, /* large regions */
    0x15080df1u, /* large regions */
    0xd5f2545cu, /* large regions */
    0xa3df1e9au, /* varied regions */
    0xa2119039u, /* varied regions */
    0xa854321bu, /* varied regions */
    0x966307edu, /* varied regions */
    0x47024abau, /* varied regions */
    0x35797cccu, /* varied regions */
    0x83096668u, /* varied regions */
    0x1a7afe04u, /* varied regions */
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
    0x2a4026deu, /* gallery */
};

#endif
