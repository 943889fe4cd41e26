/* SPDX-License-Identifier: MIT */
/* Made by `make unit-tables`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include "pixel_sums.h"

static const pixel_sums pixel_table[] = {
    {0xc6c38835u, 0x52e244d6u}, /* regions */
    {0x91848f99u, 0x07dc7224u}, /* regions */
    {0x727f7d2eu, 0x52e0a7e8u}, /* random surfaces */
    {0x0aa451f8u, 0xb08af62fu}, /* random surfaces */
    {0x3c09bc93u, 0xf508d151u}, /* random surfaces */
    {0x779047fbu, 0x45079034u}, /* random surfaces */
    {0x9b96b422u, 0x737a517eu}, /* random surfaces */
    {0x15adb133u, 0xd1b280a7u}, /* random surfaces */
    {0x88b25687u, 0x9519d543u}, /* random scenes */
    {0x98fa65b6u, 0x4c99c62cu}, /* random scenes */
    {0x19e56de8u, 0x8c2e5a75u}, /* random scenes */
    {0x997053eau, 0xe0f07b46u}, /* random scenes */
    {0x035bb0bfu, 0xc328e372u}, /* benchmark */
    {0xa33424adu, 0x368210edu}, /* benchmark */
    {0x6658b5afu, 0x0a5c35a1u}, /* benchmark */
    {0xa0707570u, 0x2763f527u}, /* benchmark */
    {0xfd55d9b1u, 0xf43a59e7u}, /* benchmark */
    {0x0fbae097u, 0x1a617448u}, /* benchmark */
    {0xab125c40u, 0xd44e240fu}, /* benchmark */
    {0x98dc6aa7u, 0xf7f75ff9u}, /* benchmark */
    {0x2f025b8du, 0x3695144du}, /* benchmark */
    {0x92dbe11bu, 0x4a30c1edu}, /* benchmark */
    {0xdaeeec08u, 0xb75fbaefu}, /* benchmark */
    {0x2f025b8du, 0x3695144du}, /* benchmark */
    {0xd938d48bu, 0x4f1d0282u}, /* benchmark */
    {0x63c830cdu, 0xc7fbd867u}, /* benchmark */
    {0x59fa9654u, 0xfab75cc7u}, /* benchmark */
    {0x27c00c4au, 0x26df0d69u}, /* benchmark */
    {0xb4347b65u, 0xe996f9d1u}, /* large */
    {0xdf499056u, 0x6defdbb5u}, /* large */
    {0x4f12aabfu, 0x52d4f071u}, /* large */
    {0x0914046bu, 0x7ed14a4cu}, /* large */
    {0x5f7c1e95u, 0x81f0694bu}, /* scenes */
    {0x0eee8bd2u, 0x8d28316du}, /* scenes */
    {0x2c7415e8u, 0xa621c721u}, /* scenes */
    {0xe882d0b8u, 0x24997232u}, /* scenes */
    {0xcb44cda6u, 0xac240b6du}, /* surfaces */
    {0xf598eaaau, 0xd79a30f2u}, /* surfaces */
    {0xe96c20dcu, 0x0bdd11adu}, /* surfaces */
    {0x230c4466u, 0x7b8bce14u}, /* surfaces */
    {0xc5817913u, 0xffb0244fu}, /* gallery */
    {0xec0ef5ecu, 0x8164326bu}, /* gallery */
    {0x8c3cc172u, 0xc3f619c0u}, /* gallery */
    {0x5f4213f1u, 0x3229035eu}, /* gallery */
    {0x0c5adc59u, 0xf89b3544u}, /* gallery */
    {0x0dec0bbcu, 0x4e60b3bau}, /* gallery */
    {0xde083c4eu, 0xfd90d8b3u}, /* formats */
    {0x6345fb1du, 0xf3bcbff9u}, /* formats */
    {0x56da57bcu, 0xfd90d8b3u}, /* formats */
    {0xe0a1d003u, 0xeac71014u}, /* formats */
    {0xb9097975u, 0xf3bcbff9u}, /* formats */
    {0x7218e55cu, 0xeac71014u}, /* formats */
    {0x651ae61fu, 0xeac71014u}, /* formats */
    {0x6954a557u, 0xeac71014u}, /* formats */
    {0xc05cccf3u, 0xeac71014u}, /* formats */
    {0x043b16ebu, 0x9b9e968bu}, /* formats */
    {0x2bedf2e9u, 0xeac71014u}, /* formats */
    {0x9017074cu, 0x9b9e968bu}, /* formats */
    {0x88a5e0fau, 0xeac71014u}, /* formats */
    {0x040bb08fu, 0xeac71014u}, /* formats */
    {0x2e1d986fu, 0xeac71014u}, /* formats */
    {0x81c478fbu, 0xeac71014u}, /* formats */
};

#endif
