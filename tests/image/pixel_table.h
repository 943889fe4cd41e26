/* SPDX-License-Identifier: MIT */
/* Made by `make unit-tables`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include "pixel_sums.h"

static const pixel_sums pixel_table[] = {
    {0x5fc989aeu, 0xc4637ee1u}, /* regions */
    {0xff18e945u, 0xe4d3c49bu}, /* regions */
    {0x9b053754u, 0x3ffdeda8u}, /* random surfaces */
    {0xae7ac287u, 0x8fa19743u}, /* random surfaces */
    {0xb4eee428u, 0x3c421cbdu}, /* random surfaces */
    {0x6604fdcdu, 0xef7abd0fu}, /* random surfaces */
    {0x42a850d6u, 0xdd64e40au}, /* random surfaces */
    {0xe659f80du, 0xb482934eu}, /* random surfaces */
    {0xb98cef10u, 0x1b253fd6u}, /* random scenes */
    {0x3c6ea79bu, 0x51365592u}, /* random scenes */
    {0xe0ca6d30u, 0x047d85b2u}, /* random scenes */
    {0x01ac843du, 0x5c0165f5u}, /* random scenes */
    {0xd03712adu, 0x76226b6eu}, /* benchmark */
    {0xe6dd59c5u, 0x368210edu}, /* benchmark */
    {0xb725ce41u, 0x0a5c35a1u}, /* benchmark */
    {0xf46a2a37u, 0x9103d0c3u}, /* benchmark */
    {0x36e3a335u, 0xf43a59e7u}, /* benchmark */
    {0xa3a2c9f0u, 0x1a617448u}, /* benchmark */
    {0x3c60226bu, 0xd44e240fu}, /* benchmark */
    {0x9c856464u, 0x93e2f9e5u}, /* benchmark */
    {0x0f41320du, 0x3695144du}, /* benchmark */
    {0xa79d2180u, 0x4a30c1edu}, /* benchmark */
    {0xaf001419u, 0xb75fbaefu}, /* benchmark */
    {0x0f41320du, 0x3695144du}, /* benchmark */
    {0xb4e0a39du, 0x4f1d0282u}, /* benchmark */
    {0x53f7759du, 0xc7fbd867u}, /* benchmark */
    {0x94d59b79u, 0xfab75cc7u}, /* benchmark */
    {0x096d587cu, 0x26df0d69u}, /* benchmark */
    {0x45b52d0eu, 0xb54129fdu}, /* large */
    {0x5c5f60e4u, 0x6defdbb5u}, /* large */
    {0x4f12aabfu, 0x52d4f071u}, /* large */
    {0xb0e9ef83u, 0x7ed14a4cu}, /* large */
    {0xd133e088u, 0x8bb743cau}, /* scenes */
    {0x825ffd9au, 0x334b61fdu}, /* scenes */
    {0x2c7415e8u, 0xd0f54051u}, /* scenes */
    {0xd84b342du, 0xf845b954u}, /* scenes */
    {0x42f5198bu, 0xe02592a9u}, /* surfaces */
    {0xa2f2869eu, 0x3a0f77eeu}, /* surfaces */
    {0xe0797374u, 0x0ff90a69u}, /* surfaces */
    {0x56c8d34eu, 0xd8d745a5u}, /* surfaces */
    {0xb2954cf6u, 0xffb0244fu}, /* gallery */
    {0xab4bbe81u, 0x8164326bu}, /* gallery */
    {0x6cba1825u, 0x62fa80feu}, /* gallery */
    {0x68ec0604u, 0x2758c8deu}, /* gallery */
    {0xd6d1f3f0u, 0xda81c0feu}, /* gallery */
    {0x2b62eba9u, 0x4e60b3bau}, /* gallery */
    {0x94a965c6u, 0x782732ebu}, /* formats */
    {0x5fa46c82u, 0xe67ad4b2u}, /* formats */
    {0xc33a1b80u, 0x782732ebu}, /* formats */
    {0x70a82de5u, 0xe15b0bf9u}, /* formats */
    {0x6b0e5fd0u, 0xe67ad4b2u}, /* formats */
    {0x45ec03f3u, 0xe15b0bf9u}, /* formats */
    {0xaf260e89u, 0xe15b0bf9u}, /* formats */
    {0xf6c3f843u, 0xe15b0bf9u}, /* formats */
    {0xbb10a850u, 0xe15b0bf9u}, /* formats */
    {0x214a6960u, 0x5986bd4cu}, /* formats */
    {0xcbb1267du, 0xe15b0bf9u}, /* formats */
    {0xcc09f0a3u, 0x5986bd4cu}, /* formats */
    {0xf36bb08eu, 0xe15b0bf9u}, /* formats */
    {0x040bb08fu, 0xe15b0bf9u}, /* formats */
    {0x1caa0e3eu, 0xe15b0bf9u}, /* formats */
    {0x81c478fbu, 0xe15b0bf9u}, /* formats */
};

#endif
