/* SPDX-License-Identifier: MIT */
/* Made by `make figures`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include <stdint.h>

static const uint32_t pixel_table[] = {
    0x80565640u, /* regions */
    0x16871e2cu, /* regions */
    0x840fe551u, /* large regions */
    0xc4606b3du, /* large regions */
    0xe44efc3fu, /* large regions */
    0xf0588a39u, /* varied regions */
    0xc6706a41u, /* varied regions */
    0x040870d9u, /* varied regions */
    0xc6a52218u, /* varied regions */
    0x8b6cf655u, /* varied regions */
    0x2ded7db9u, /* varied regions */
    0x8e5267fau, /* varied regions */
    0xdd6d4f69u, /* varied regions */
    0x64399fbeu, /* varied benchmark */
    0x14e6723eu, /* varied benchmark */
    0x22c43a58u, /* varied benchmark */
    0xb430e455u, /* varied benchmark */
    0xda0ccec9u, /* varied benchmark */
    0x06b2f65fu, /* varied benchmark */
    0x765c7ea9u, /* random surfaces */
    0x8b2d1d9du, /* random surfaces */
    0x3219e201u, /* random surfaces */
    0x5c8d425au, /* random surfaces */
    0x380cd212u, /* random surfaces */
    0x08219756u, /* random surfaces */
    0x1350d543u, /* random scenes */
    0xd3c0a99au, /* random scenes */
    0x2a487148u, /* random scenes */
    0x5ce928c7u, /* random scenes */
    0x88582764u, /* benchmark */
    0x4dee89f9u, /* benchmark */
    0x27e9fa9bu, /* benchmark */
    0xe9fd3c9du, /* benchmark */
    0xf0c9e555u, /* benchmark */
    0xb841ddb7u, /* benchmark */
    0x29f6db6du, /* benchmark */
    0x99f5ba96u, /* benchmark */
    0x18d255d6u, /* benchmark */
    0xa18761a8u, /* benchmark */
    0xabfa282fu, /* benchmark */
    0xf195f825u, /* benchmark */
    0x7d285006u, /* large */
    0xc1acaeb0u, /* large */
    0x486f08f2u, /* large */
    0xd6f7dbfau, /* large */
    0xb033ecf7u, /* scenes */
    0x5f4e59adu, /* scenes */
    0x833b6538u, /* scenes */
    0xe4318ed2u, /* surfaces */
    0x42309271u, /* surfaces */
    0x7c203683u, /* surfaces */
    0x184d1c84u, /* gallery */
    0xfbc19b11u, /* gallery */
    0xb8747bb6u, /* gallery */
    0xcaa53b64u, /* gallery */
    0xda8968a0u, /* gallery */
    0x4ed12ff5u, /* gallery */
    0xaf44b5dfu, /* formats */
    0x44d652c7u, /* formats */
    0x96eb7e1bu, /* formats */
    0x12411e0cu, /* formats */
    0x495b462fu, /* formats */
    0xe89dba29u, /* formats */
    0x786910ecu, /* formats */
    0x9cf516acu, /* formats */
    0xd2e4c508u, /* formats */
    0x2fabd39au, /* formats */
    0x568003e3u, /* formats */
    0x90964451u, /* formats */
    0x7b068518u, /* formats */
    0x9631304du, /* formats */
    0x69ef9076u, /* formats */
    0xedcbe5aeu, /* formats */
};

#endif
