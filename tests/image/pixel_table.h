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
    0x39d24f88u, /* random scenes */
    0x2feb57f7u, /* random scenes */
    0x7f4565c6u, /* random scenes */
    0xabd0c695u, /* random scenes */
    0x9a2dfbf4u, /* benchmark */
    0x4dee89f9u, /* benchmark */
    0x27e9fa9bu, /* benchmark */
    0x20e46e2au, /* benchmark */
    0xf0c9e555u, /* benchmark */
    0xb841ddb7u, /* benchmark */
    0x29f6db6du, /* benchmark */
    0x99f5ba96u, /* benchmark */
    0x18d255d6u, /* benchmark */
    0xe9191f39u, /* benchmark */
    0xabfa282fu, /* benchmark */
    0xf195f825u, /* benchmark */
    0x583acd39u, /* large */
    0xa2beb282u, /* large */
    0xe1317782u, /* large */
    0xfc9ce03du, /* large */
    0x27064630u, /* scenes */
    0x5f4e59adu, /* scenes */
    0x833b6538u, /* scenes */
    0xe4318ed2u, /* surfaces */
    0x42309271u, /* surfaces */
    0x7c203683u, /* surfaces */
    0x013d797au, /* gallery */
    0x7271939eu, /* gallery */
    0xb8747bb6u, /* gallery */
    0x13d11984u, /* gallery */
    0xda8968a0u, /* gallery */
    0x3800b8feu, /* gallery */
    0x2990fedcu, /* formats */
    0x18ee3d17u, /* formats */
    0x0af480f2u, /* formats */
    0x5178d624u, /* formats */
    0x50f2fc8bu, /* formats */
    0xf29dc2b8u, /* formats */
    0xfc90fd6bu, /* formats */
    0x93b54fa8u, /* formats */
    0xc84fa0c3u, /* formats */
    0x9b294ad1u, /* formats */
    0x940bcea7u, /* formats */
    0xef447726u, /* formats */
    0x7b068518u, /* formats */
    0x9631304du, /* formats */
    0x69ef9076u, /* formats */
    0xedcbe5aeu, /* formats */
};

#endif
