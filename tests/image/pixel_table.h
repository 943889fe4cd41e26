/* SPDX-License-Identifier: MIT */
/* Made by `make unit-tables`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include "pixel_sums.h"

static const pixel_sums pixel_table[] = {
    {0x725bc924u, 0x04fde0edu}, /* regions */
    {0x237f6f26u, 0x553296abu}, /* regions */
    {0xee5088b9u, 0x52e0a7e8u}, /* random surfaces */
    {0xabf57a10u, 0x729d959fu}, /* random surfaces */
    {0x284447bcu, 0x747aaa0eu}, /* random surfaces */
    {0x99c4545au, 0xdbbda399u}, /* random surfaces */
    {0xa81c5c4bu, 0x737a517eu}, /* random surfaces */
    {0xe89308ecu, 0xd1f2ba44u}, /* random surfaces */
    {0xb98cef10u, 0x9519d543u}, /* random scenes */
    {0x3c6ea79bu, 0x0fcda129u}, /* random scenes */
    {0xe0ca6d30u, 0x8c2e5a75u}, /* random scenes */
    {0x01ac843du, 0x592c800au}, /* random scenes */
    {0x87c388eau, 0x76226b6eu}, /* benchmark */
    {0x0cf4d4d2u, 0x368210edu}, /* benchmark */
    {0x3daa6f6du, 0x0a5c35a1u}, /* benchmark */
    {0xdd94435au, 0x9103d0c3u}, /* benchmark */
    {0xeffe7fb3u, 0xf43a59e7u}, /* benchmark */
    {0xc6933e7du, 0x1a617448u}, /* benchmark */
    {0xab125c40u, 0xd44e240fu}, /* benchmark */
    {0x1e64d31eu, 0x93e2f9e5u}, /* benchmark */
    {0x27760217u, 0x3695144du}, /* benchmark */
    {0x5a24968du, 0x4a30c1edu}, /* benchmark */
    {0xc5c95e96u, 0xb75fbaefu}, /* benchmark */
    {0x27760217u, 0x3695144du}, /* benchmark */
    {0x546acb37u, 0x4f1d0282u}, /* benchmark */
    {0x26392efau, 0xc7fbd867u}, /* benchmark */
    {0x59fa9654u, 0xfab75cc7u}, /* benchmark */
    {0x60cc1a0fu, 0x26df0d69u}, /* benchmark */
    {0x45b52d0eu, 0xb54129fdu}, /* large */
    {0x5c5f60e4u, 0x6defdbb5u}, /* large */
    {0x4f12aabfu, 0x52d4f071u}, /* large */
    {0xb0e9ef83u, 0x7ed14a4cu}, /* large */
    {0xd133e088u, 0xf3de6e42u}, /* scenes */
    {0x825ffd9au, 0x8d28316du}, /* scenes */
    {0x2c7415e8u, 0xa621c721u}, /* scenes */
    {0xd84b342du, 0xc94b0b50u}, /* scenes */
    {0x42f5198bu, 0xac240b6du}, /* surfaces */
    {0xa2f2869eu, 0xd79a30f2u}, /* surfaces */
    {0xe0797374u, 0x0bdd11adu}, /* surfaces */
    {0x56c8d34eu, 0x459486a1u}, /* surfaces */
    {0x1e77fd84u, 0xffb0244fu}, /* gallery */
    {0x3015d508u, 0x8164326bu}, /* gallery */
    {0x6c486b0fu, 0x105f45d8u}, /* gallery */
    {0x68ec0604u, 0x2758c8deu}, /* gallery */
    {0xe8415a16u, 0xda81c0feu}, /* gallery */
    {0xf9586c85u, 0x4e60b3bau}, /* gallery */
    {0x94a965c6u, 0x4b449c07u}, /* formats */
    {0x5fa46c82u, 0x609193f2u}, /* formats */
    {0xc33a1b80u, 0x4b449c07u}, /* formats */
    {0x70a82de5u, 0x7ff45439u}, /* formats */
    {0x6b0e5fd0u, 0x609193f2u}, /* formats */
    {0x45ec03f3u, 0x7ff45439u}, /* formats */
    {0xaf260e89u, 0x7ff45439u}, /* formats */
    {0xf6c3f843u, 0x7ff45439u}, /* formats */
    {0xbb10a850u, 0x7ff45439u}, /* formats */
    {0x214a6960u, 0x08344bbcu}, /* formats */
    {0xcbb1267du, 0x7ff45439u}, /* formats */
    {0xcc09f0a3u, 0x08344bbcu}, /* formats */
    {0xf36bb08eu, 0x7ff45439u}, /* formats */
    {0x040bb08fu, 0x7ff45439u}, /* formats */
    {0x1caa0e3eu, 0x7ff45439u}, /* formats */
    {0x81c478fbu, 0x7ff45439u}, /* formats */
};

#endif
