/* SPDX-License-Identifier: MIT */
/* Made by `make figures`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include <stdint.h>

static const uint32_t pixel_table[] = {
    0x8e2d454fu, /* regions */
    0x16871e2cu, /* regions */
    0x59e10b36u, /* large regions */
    0x75179d60u, /* large regions */
    0x5909b7cfu, /* large regions */
    0xb445bc6cu, /* varied regions */
    0xf417677cu, /* varied regions */
    0x15ea8867u, /* varied regions */
    0x0400e1f0u, /* varied regions */
    0xe5e4de63u, /* varied regions */
    0x1c7a263cu, /* varied regions */
    0x8cb917a9u, /* varied regions */
    0x01d3d72bu, /* varied regions */
    0x64399fbeu, /* varied benchmark */
    0x651e031eu, /* varied benchmark */
    0x22c43a58u, /* varied benchmark */
    0x5187d498u, /* varied benchmark */
    0xda0ccec9u, /* varied benchmark */
    0x06b2f65fu, /* varied benchmark */
    0xe436d8d0u, /* random surfaces */
    0xf0223d0bu, /* random surfaces */
    0xa915aaafu, /* random surfaces */
    0x5c8d425au, /* random surfaces */
    0x10b2b335u, /* random surfaces */
    0x08219756u, /* random surfaces */
    0x75df0c6du, /* random scenes */
    0x683f2926u, /* random scenes */
    0xc83c20bau, /* random scenes */
    0x3a8dc5a5u, /* random scenes */
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
    0x75003dfbu, /* scenes */
    0x5f4e59adu, /* scenes */
    0x833b6538u, /* scenes */
    0xe4318ed2u, /* surfaces */
    0x42309271u, /* surfaces */
    0x7c203683u, /* surfaces */
    0x184d1c84u, /* gallery */
    0xfbc19b11u, /* gallery */
    0xb8747bb6u, /* gallery */
    0xcaa53b64u, /* gallery */
    0x8ed31963u, /* gallery */
    0x4ed12ff5u, /* gallery */
    0xaf44b5dfu, /* formats */
    0x44d652c7u, /* formats */
    0x96eb7e1bu, /* formats */
    0x522e65abu, /* formats */
    0x495b462fu, /* formats */
    0x45bc7166u, /* formats */
    0xa8243e52u, /* formats */
    0x4694e360u, /* formats */
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
