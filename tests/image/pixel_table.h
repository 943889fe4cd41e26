/* SPDX-License-Identifier: MIT */
/* Made by `make unit-tables`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include "pixel_sums.h"

static const pixel_sums pixel_table[] = {
    {0x188a8828u, 0x37b0fe31u}, /* regions */
    {0x5648969bu, 0x553296abu}, /* regions */
    {0xafdf450fu, 0x52e0a7e8u}, /* random surfaces */
    {0xb95e5046u, 0xd9635b3du}, /* random surfaces */
    {0x1a94c48fu, 0x747aaa0eu}, /* random surfaces */
    {0x9637a6dfu, 0x33bc59bdu}, /* random surfaces */
    {0xbb7e1489u, 0x737a517eu}, /* random surfaces */
    {0xec550a03u, 0xe4b06893u}, /* random surfaces */
    {0x3835fad8u, 0x9519d543u}, /* random scenes */
    {0xe7aa1f20u, 0x64b39844u}, /* random scenes */
    {0xd69d0bffu, 0x8c2e5a75u}, /* random scenes */
    {0x80772a37u, 0xea5e36d0u}, /* random scenes */
    {0x0fe1e726u, 0x76226b6eu}, /* benchmark */
    {0x0cf4d4d2u, 0x368210edu}, /* benchmark */
    {0x3daa6f6du, 0x0a5c35a1u}, /* benchmark */
    {0x9ca9ecc2u, 0x9103d0c3u}, /* benchmark */
    {0xa3da9368u, 0xf43a59e7u}, /* benchmark */
    {0x8d7ee942u, 0x1a617448u}, /* benchmark */
    {0xab125c40u, 0xd44e240fu}, /* benchmark */
    {0x0d6ca44au, 0x93e2f9e5u}, /* benchmark */
    {0x9ec29cc1u, 0x3695144du}, /* benchmark */
    {0x5a24968du, 0x4a30c1edu}, /* benchmark */
    {0xc5c95e96u, 0xb75fbaefu}, /* benchmark */
    {0x9ec29cc1u, 0x3695144du}, /* benchmark */
    {0xbd062d63u, 0x4f1d0282u}, /* benchmark */
    {0x26392efau, 0xc7fbd867u}, /* benchmark */
    {0x59fa9654u, 0xfab75cc7u}, /* benchmark */
    {0x1af6dc58u, 0x26df0d69u}, /* benchmark */
    {0x1c2e55e6u, 0xb54129fdu}, /* large */
    {0x879762b3u, 0x6defdbb5u}, /* large */
    {0x4f12aabfu, 0x52d4f071u}, /* large */
    {0xfbf8b4a9u, 0x7ed14a4cu}, /* large */
    {0xda80a1dfu, 0xf3de6e42u}, /* scenes */
    {0x8c23adeeu, 0x8d28316du}, /* scenes */
    {0x2c7415e8u, 0xa621c721u}, /* scenes */
    {0x655b8157u, 0xc94b0b50u}, /* scenes */
    {0x8e485e3du, 0xac240b6du}, /* surfaces */
    {0x52a8ece3u, 0xd79a30f2u}, /* surfaces */
    {0xe0797374u, 0x0bdd11adu}, /* surfaces */
    {0xa682f8bbu, 0x187094e5u}, /* surfaces */
    {0xc5817913u, 0xffb0244fu}, /* gallery */
    {0x3015d508u, 0x8164326bu}, /* gallery */
    {0x821bb055u, 0x105f45d8u}, /* gallery */
    {0x689c319du, 0x2758c8deu}, /* gallery */
    {0xb5267cacu, 0xda81c0feu}, /* gallery */
    {0x6acaf068u, 0x4e60b3bau}, /* gallery */
    {0x7d4c4641u, 0x4b449c07u}, /* formats */
    {0x7ad33f20u, 0x609193f2u}, /* formats */
    {0x895a1109u, 0x4b449c07u}, /* formats */
    {0x507d34edu, 0x7ff45439u}, /* formats */
    {0x5ed94f3eu, 0x609193f2u}, /* formats */
    {0xdf7c2f76u, 0x7ff45439u}, /* formats */
    {0x079577d6u, 0x7ff45439u}, /* formats */
    {0xc8595bdcu, 0x7ff45439u}, /* formats */
    {0xbb10a850u, 0x7ff45439u}, /* formats */
    {0xada695d1u, 0x08344bbcu}, /* formats */
    {0xcbb1267du, 0x7ff45439u}, /* formats */
    {0x6672097cu, 0x08344bbcu}, /* formats */
    {0xf36bb08eu, 0x7ff45439u}, /* formats */
    {0x040bb08fu, 0x7ff45439u}, /* formats */
    {0x1caa0e3eu, 0x7ff45439u}, /* formats */
    {0x81c478fbu, 0x7ff45439u}, /* formats */
};

#endif
