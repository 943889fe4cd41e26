/* SPDX-License-Identifier: MIT */
/* Made by `make figures`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include <stdint.h>

static const uint32_t pixel_table[] = {
    0x73765d57u, /* regions */
    0xd24f8860u, /* regions */
    0x5aba87d6u, /* large regions */
    0x053f6e5cu, /* large regions */
    0x7cc8fee9u, /* large regions */
    0xb5bf5820u, /* varied regions */
    0xc99eea17u, /* varied regions */
    0xf4d86f79u, /* varied regions */
    0xcfe63fc6u, /* varied regions */
    0x438a66a2u, /* varied regions */
    0x74eb675eu, /* varied regions */
    0x98dafd2fu, /* varied regions */
    0x48f065e1u, /* varied regions */
    0x2874cf57u, /* varied benchmark */
    0x83b00cc6u, /* varied benchmark */
    0xd58f700du, /* varied benchmark */
    0x3f42beddu, /* varied benchmark */
    0xf5135f8au, /* varied benchmark */
    0x817846f5u, /* varied benchmark */
    0x880c7cbeu, /* random surfaces */
    0x44a117c9u, /* random surfaces */
    0xdd265c1eu, /* random surfaces */
    0x135be48eu, /* random surfaces */
    0x1fde0842u, /* random surfaces */
    0xcbd0ee75u, /* random surfaces */
    0x37293094u, /* random scenes */
    0xf57fd393u, /* random scenes */
    0xef25b1a4u, /* random scenes */
    0xe2edcf26u, /* random scenes */
    0xf8a4ac66u, /* benchmark */
    0x21408097u, /* benchmark */
    0x27e9fa9bu, /* benchmark */
    0xc4d929e4u, /* benchmark */
    0x10929c94u, /* benchmark */
    0xb841ddb7u, /* benchmark */
    0x78917246u, /* benchmark */
    0x99f5ba96u, /* benchmark */
    0x18d255d6u, /* benchmark */
    0x8d4ac401u, /* benchmark */
    0xdee06880u, /* benchmark */
    0xf195f825u, /* benchmark */
    0xb37dabc3u, /* large */
    0x4fc9e88fu, /* large */
    0xb0ea14eeu, /* large */
    0x973566b7u, /* large */
    0xeb98e6fcu, /* scenes */
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
