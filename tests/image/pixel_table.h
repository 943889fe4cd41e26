/* SPDX-License-Identifier: MIT */
/* Made by `make figures`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include <stdint.h>

static const uint32_t pixel_table[] = {
    0x84955e76u, /* regions */
    0x16871e2cu, /* regions */
    0x5aba87d6u, /* large regions */
    0x053f6e5cu, /* large regions */
    0xe544aa42u, /* large regions */
    0x2719f229u, /* varied regions */
    0x57db7628u, /* varied regions */
    0xd622b190u, /* varied regions */
    0x900a836du, /* varied regions */
    0x569070d0u, /* varied regions */
    0x5620129bu, /* varied regions */
    0xa202fd32u, /* varied regions */
    0xf74ba22bu, /* varied regions */
    0x74ee3d4cu, /* varied benchmark */
    0x83b00cc6u, /* varied benchmark */
    0x99724f34u, /* varied benchmark */
    0xa2e231f3u, /* varied benchmark */
    0x38ee46fau, /* varied benchmark */
    0x817846f5u, /* varied benchmark */
    0x0c1e43c5u, /* random surfaces */
    0x44a117c9u, /* random surfaces */
    0xcd823259u, /* random surfaces */
    0x135be48eu, /* random surfaces */
    0x71b8c927u, /* random surfaces */
    0xcbd0ee75u, /* random surfaces */
    0x74770310u, /* random scenes */
    0x5e07e185u, /* random scenes */
    0xd44315bau, /* random scenes */
    0x508eaa95u, /* random scenes */
    0xf4d7e09cu, /* benchmark */
    0x21408097u, /* benchmark */
    0x27e9fa9bu, /* benchmark */
    0x6742439cu, /* benchmark */
    0x10929c94u, /* benchmark */
    0xb841ddb7u, /* benchmark */
    0x186a0b38u, /* benchmark */
    0x99f5ba96u, /* benchmark */
    0x18d255d6u, /* benchmark */
    0x7e78c147u, /* benchmark */
    0xdee06880u, /* benchmark */
    0xf195f825u, /* benchmark */
    0xb37dabc3u, /* large */
    0x4fc9e88fu, /* large */
    0xb0ea14eeu, /* large */
    0x973566b7u, /* large */
    0x48851d14u, /* scenes */
    0x14445194u, /* scenes */
    0x833b6538u, /* scenes */
    0xe4318ed2u, /* surfaces */
    0x624930c8u, /* surfaces */
    0x7c203683u, /* surfaces */
    0xefe6ffffu, /* gallery */
    0x05f48cb6u, /* gallery */
    0xb8747bb6u, /* gallery */
    0xad6ee463u, /* gallery */
    0x8ed31963u, /* gallery */
    0x3a0a50b8u, /* gallery */
    0x269d2e6au, /* formats */
    0x5636eed2u, /* formats */
    0x9384c374u, /* formats */
    0xf69a339bu, /* formats */
    0x5491c668u, /* formats */
    0x21c27329u, /* formats */
    0xdd365380u, /* formats */
    0xecb02cbcu, /* formats */
    0xab024f0fu, /* formats */
    0x61ff53e9u, /* formats */
    0x36cbf9ecu, /* formats */
    0x04cf825au, /* formats */
    0x7b068518u, /* formats */
    0x585d55b5u, /* formats */
    0x69ef9076u, /* formats */
    0x7062d471u, /* formats */
};

#endif
