/* SPDX-License-Identifier: MIT */
/* Made by `make figures`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include <stdint.h>

static const uint32_t pixel_table[] = {
    0x8a090863u, /* regions */
    0xcdb25d13u, /* regions */
    0x919f890au, /* large regions */
    0x38992e48u, /* large regions */
    0xb0ee08a3u, /* large regions */
    0xde33df25u, /* varied regions */
    0x73726bfbu, /* varied regions */
    0x7e73bb58u, /* varied regions */
    0x02dd222bu, /* varied regions */
    0xb9bda7eau, /* varied regions */
    0x5ef454cbu, /* varied regions */
    0x0b44dc16u, /* varied regions */
    0xb817055eu, /* varied regions */
    0xa802b12fu, /* varied benchmark */
    0xae10fbd0u, /* varied benchmark */
    0xf0a3a58fu, /* varied benchmark */
    0xafad73e6u, /* varied benchmark */
    0x9750e675u, /* varied benchmark */
    0xbb7c39d5u, /* varied benchmark */
    0x0375fbbcu, /* random surfaces */
    0x8b2d1d9du, /* random surfaces */
    0x7a27560au, /* random surfaces */
    0x5c8d425au, /* random surfaces */
    0x7503bcfcu, /* random surfaces */
    0x6d61d10eu, /* random surfaces */
    0x013d797au, /* gallery */
    0x7271939eu, /* gallery */
    0x89a64ae2u, /* gallery */
    0x13d11984u, /* gallery */
    0xebf68937u, /* gallery */
    0x0f7f46feu, /* gallery */
    0x2a4026deu, /* gallery */
};

#endif
