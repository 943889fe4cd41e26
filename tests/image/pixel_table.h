/* SPDX-License-Identifier: MIT */
/* Made by `make unit-tables`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include "pixel_sums.h"

static const pixel_sums pixel_table[] = {
    {0x5fc989aeu, 0x04fde0edu}, /* regions */
    {0x0d53e889u, 0x04ca5563u}, /* regions */
    {0x9b053754u, 0x52e0a7e8u}, /* random surfaces */
    {0x9a1cfca4u, 0xba825368u}, /* random surfaces */
    {0xb4eee428u, 0x747aaa0eu}, /* random surfaces */
    {0x8a728891u, 0xcd900bf6u}, /* random surfaces */
    {0x42a850d6u, 0x737a517eu}, /* random surfaces */
    {0xe659f80du, 0xd1f2ba44u}, /* random surfaces */
    {0xa055992du, 0x9519d543u}, /* random scenes */
    {0x3c6ea79bu, 0x0fcda129u}, /* random scenes */
    {0xe0ca6d30u, 0x8c2e5a75u}, /* random scenes */
    {0xe2a95ebbu, 0xaff45824u}, /* random scenes */
    {0x85672ca2u, 0x76226b6eu}, /* benchmark */
    {0xe6dd59c5u, 0x368210edu}, /* benchmark */
    {0xb725ce41u, 0x0a5c35a1u}, /* benchmark */
    {0x5db4bc00u, 0x9103d0c3u}, /* benchmark */
    {0x6dda351bu, 0xf43a59e7u}, /* benchmark */
    {0xa3a2c9f0u, 0x1a617448u}, /* benchmark */
    {0x3c60226bu, 0xd44e240fu}, /* benchmark */
    {0x62dc6af9u, 0x93e2f9e5u}, /* benchmark */
    {0x0f41320du, 0x3695144du}, /* benchmark */
    {0xa79d2180u, 0x4a30c1edu}, /* benchmark */
    {0xaf001419u, 0xb75fbaefu}, /* benchmark */
    {0x0f41320du, 0x3695144du}, /* benchmark */
    {0x068f283eu, 0x4f1d0282u}, /* benchmark */
    {0x53f7759du, 0xc7fbd867u}, /* benchmark */
    {0x94d59b79u, 0xfab75cc7u}, /* benchmark */
    {0xb21a4298u, 0x26df0d69u}, /* benchmark */
    {0x45b52d0eu, 0xb54129fdu}, /* large */
    {0xe8c7a4eeu, 0x6defdbb5u}, /* large */
    {0x4f12aabfu, 0x52d4f071u}, /* large */
    {0xb0e9ef83u, 0x7ed14a4cu}, /* large */
    {0xa0f0ac88u, 0xf3de6e42u}, /* scenes */
    {0x825ffd9au, 0x8d28316du}, /* scenes */
    {0x2c7415e8u, 0xa621c721u}, /* scenes */
    {0xc621543du, 0xc94b0b50u}, /* scenes */
    {0x42f5198bu, 0xac240b6du}, /* surfaces */
    {0xa2f2869eu, 0xd79a30f2u}, /* surfaces */
    {0xe0797374u, 0x0bdd11adu}, /* surfaces */
    {0x56c8d34eu, 0x459486a1u}, /* surfaces */
    {0xb2954cf6u, 0xffb0244fu}, /* gallery */
    {0xab4bbe81u, 0x8164326bu}, /* gallery */
    {0x6cba1825u, 0x105f45d8u}, /* gallery */
    {0xecd01857u, 0x2758c8deu}, /* gallery */
    {0xd6d1f3f0u, 0xda81c0feu}, /* gallery */
    {0x2b62eba9u, 0x4e60b3bau}, /* gallery */
    {0x94a965c6u, 0x4b449c07u}, /* formats */
    {0xddf8e98cu, 0x4b449c07u}, /* formats */
    {0xc33a1b80u, 0x4b449c07u}, /* formats */
    {0x70a82de5u, 0x7ff45439u}, /* formats */
    {0x19d3d31eu, 0x4b449c07u}, /* formats */
    {0x45ec03f3u, 0x7ff45439u}, /* formats */
    {0xaf260e89u, 0x7ff45439u}, /* formats */
    {0xf6c3f843u, 0x7ff45439u}, /* formats */
    {0xbb10a850u, 0x7ff45439u}, /* formats */
    {0x1c3dfda7u, 0xdc6903f1u}, /* formats */
    {0xcbb1267du, 0x7ff45439u}, /* formats */
    {0xfd1e9121u, 0xdc6903f1u}, /* formats */
    {0xf36bb08eu, 0x7ff45439u}, /* formats */
    {0x040bb08fu, 0x7ff45439u}, /* formats */
    {0x1caa0e3eu, 0x7ff45439u}, /* formats */
    {0x81c478fbu, 0x7ff45439u}, /* formats */
};

#endif
