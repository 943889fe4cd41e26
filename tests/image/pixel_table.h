/* SPDX-License-Identifier: MIT */
/* Made by `make unit-tables`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include "pixel_sums.h"

static const pixel_sums pixel_table[] = {
    {0xc6c38835u, 0x84ae9397u}, /* regions */
    {0x91848f99u, 0xdfa9fd32u}, /* regions */
    {0x727f7d2eu, 0x52e0a7e8u}, /* random surfaces */
    {0x0aa451f8u, 0xedc3288fu}, /* random surfaces */
    {0x3c09bc93u, 0x747aaa0eu}, /* random surfaces */
    {0x779047fbu, 0xc508f1e7u}, /* random surfaces */
    {0x9b96b422u, 0x737a517eu}, /* random surfaces */
    {0x15adb133u, 0x72f22cabu}, /* random surfaces */
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
    {0x5f7c1e95u, 0xf3de6e42u}, /* scenes */
    {0x0eee8bd2u, 0x8d28316du}, /* scenes */
    {0x2c7415e8u, 0xa621c721u}, /* scenes */
    {0xe882d0b8u, 0xc94b0b50u}, /* scenes */
    {0xcb44cda6u, 0xac240b6du}, /* surfaces */
    {0xf598eaaau, 0xd79a30f2u}, /* surfaces */
    {0xe96c20dcu, 0x0bdd11adu}, /* surfaces */
    {0x230c4466u, 0x187094e5u}, /* surfaces */
    {0xc5817913u, 0xffb0244fu}, /* gallery */
    {0xec0ef5ecu, 0x8164326bu}, /* gallery */
    {0x8c3cc172u, 0xdb27b9a0u}, /* gallery */
    {0x5f4213f1u, 0x3229035eu}, /* gallery */
    {0x0c5adc59u, 0xf89b3544u}, /* gallery */
    {0x0dec0bbcu, 0x4e60b3bau}, /* gallery */
    {0xde083c4eu, 0x4b449c07u}, /* formats */
    {0x6345fb1du, 0xbdbd160au}, /* formats */
    {0x56da57bcu, 0x4b449c07u}, /* formats */
    {0xe0a1d003u, 0x4a35959du}, /* formats */
    {0xb9097975u, 0xbdbd160au}, /* formats */
    {0x7218e55cu, 0x4a35959du}, /* formats */
    {0x651ae61fu, 0x4a35959du}, /* formats */
    {0x6954a557u, 0x4a35959du}, /* formats */
    {0xc05cccf3u, 0x4a35959du}, /* formats */
    {0x043b16ebu, 0x350386ccu}, /* formats */
    {0x2bedf2e9u, 0x4a35959du}, /* formats */
    {0x9017074cu, 0x350386ccu}, /* formats */
    {0x88a5e0fau, 0x4a35959du}, /* formats */
    {0x040bb08fu, 0x4a35959du}, /* formats */
    {0x2e1d986fu, 0x4a35959du}, /* formats */
    {0x81c478fbu, 0x4a35959du}, /* formats */
};

#endif
