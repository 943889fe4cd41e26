/* SPDX-License-Identifier: MIT */
/* Made by `make figures`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include <stdint.h>

static const uint32_t pixel_table[] = {
    0x98d035d8u, /* regions */
    0x8db7b7a9u, /* regions */
    0xa34a20b8u, /* large regions */
    0x9ee27324u, /* large regions */
    0xeb0f0090u, /* large regions */
    0x314d414au, /* varied regions */
    0xe481090du, /* varied regions */
    0x95d4be71u, /* varied regions */
    0x0f90d331u, /* varied regions */
    0x2e7deb67u, /* varied regions */
    0x2aa40affu, /* varied regions */
    0x7a4dd66eu, /* varied regions */
    0x0837162au, /* varied regions */
    0x9d4a33e0u, /* varied benchmark */
    0xbc436839u, /* varied benchmark */
    0x11a0d0b9u, /* varied benchmark */
    0xc9de8576u, /* varied benchmark */
    0x5e6a2287u, /* varied benchmark */
    0x5c8faecau, /* varied benchmark */
    0xc1ac99c1u, /* random surfaces */
    0xe5c6d40eu, /* random surfaces */
    0x34bbe712u, /* random surfaces */
    0x82748abdu, /* random surfaces */
    0x4a8d30a6u, /* random surfaces */
    0x919e9647u, /* random surfaces */
    0x019f5407u, /* random scenes */
    0xa02e1a7cu, /* random scenes */
    0x07b7f21fu, /* random scenes */
    0xbf1d8aeeu, /* random scenes */
    0xf91337a0u, /* benchmark */
    0xf607d0edu, /* benchmark */
    0x27e9fa9bu, /* benchmark */
    0xfb17c2deu, /* benchmark */
    0x267ac755u, /* benchmark */
    0xb841ddb7u, /* benchmark */
    0x6a8e66bbu, /* benchmark */
    0x8fe1958eu, /* benchmark */
    0x18d255d6u, /* benchmark */
    0xb7efa4aau, /* benchmark */
    0x441eb64au, /* benchmark */
    0xf195f825u, /* benchmark */
    0xa352b875u, /* large */
    0x09a50031u, /* large */
    0xb79ab7e8u, /* large */
    0x6e0729b6u, /* large */
    0x77aa3eb8u, /* scenes */
    0x9aa98bccu, /* scenes */
    0x833b6538u, /* scenes */
    0x4fbddf8cu, /* surfaces */
    0x8a9f2ff4u, /* surfaces */
    0x7c203683u, /* surfaces */
    0x0e006bfau, /* gallery */
    0xcf826517u, /* gallery */
    0x66c94c6du, /* gallery */
    0xfd83d5c2u, /* gallery */
    0x8ed31963u, /* gallery */
    0x7fb78c7du, /* gallery */
    0xc90124efu, /* formats */
    0xdacdd0d5u, /* formats */
    0xd7d1bbefu, /* formats */
    0x1d21d2ccu, /* formats */
    0x8038d785u, /* formats */
    0xb6189a34u, /* formats */
    0x7b61e4e7u, /* formats */
    0xce1bd813u, /* formats */
    0x2b629cf0u, /* formats */
    0xd9d338d2u, /* formats */
    0xaff7d145u, /* formats */
    0x611b98c5u, /* formats */
    0x0ad5f33au, /* formats */
    0x585d55b5u, /* formats */
    0x05b3a0f6u, /* formats */
    0x7062d471u, /* formats */
};

#endif
