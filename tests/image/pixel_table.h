/* SPDX-License-Identifier: MIT */
/* Made by `make unit-tables`; not to be edited: what every picture came to when it was made. */
/* clang-format off */
#ifndef GLINT_PIXEL_TABLE_H
#define GLINT_PIXEL_TABLE_H

#include "pixel_sums.h"

static const pixel_sums pixel_table[] = {
    {0x6de0a2d3u, 0x04fde0edu}, /* regions */
    {0xaa3d13f3u, 0x04ca5563u}, /* regions */
    {0xfc9fcb8au, 0xf0220baeu}, /* large regions */
    {0xfbfaadbau, 0x48ce73efu}, /* large regions */
    {0x998d2d70u, 0xe34c04e4u}, /* large regions */
    {0x945147b6u, 0x9eb8de8cu}, /* varied regions */
    {0x32c0e5e4u, 0xd806770eu}, /* varied regions */
    {0x0194bb2fu, 0xefc62b8eu}, /* varied regions */
    {0x1d48db76u, 0xf47dbeedu}, /* varied regions */
    {0x5a0bc439u, 0x177e6bc1u}, /* varied regions */
    {0x916816e6u, 0x0afee90fu}, /* varied regions */
    {0xf205ce8bu, 0x2a1b41d9u}, /* varied regions */
    {0x4bb07e63u, 0xc82f33a7u}, /* varied regions */
    {0xde5d4f0du, 0x644ff5f7u}, /* varied benchmark */
    {0xae4ad891u, 0xde532779u}, /* varied benchmark */
    {0xe2bcbf1eu, 0xf4f26b5bu}, /* varied benchmark */
    {0xa74f06a4u, 0x728a8e96u}, /* varied benchmark */
    {0xc43fd490u, 0x3615ef8au}, /* varied benchmark */
    {0x49b02cd7u, 0x96944646u}, /* varied benchmark */
    {0x9b053754u, 0x52e0a7e8u}, /* random surfaces */
    {0x6c70b664u, 0xba825368u}, /* random surfaces */
    {0xb4eee428u, 0x747aaa0eu}, /* random surfaces */
    {0x4fb7384cu, 0xcd900bf6u}, /* random surfaces */
    {0x42a850d6u, 0x737a517eu}, /* random surfaces */
    {0xf009e113u, 0xd1f2ba44u}, /* random surfaces */
    {0xa055992du, 0x9519d543u}, /* random scenes */
    {0x94c8ea77u, 0x0fcda129u}, /* random scenes */
    {0xe0ca6d30u, 0x8c2e5a75u}, /* random scenes */
    {0xdb175aecu, 0x67a320c8u}, /* random scenes */
    {0x7065ffa7u, 0x76226b6eu}, /* benchmark */
    {0xe6dd59c5u, 0x368210edu}, /* benchmark */
    {0xb725ce41u, 0x0a5c35a1u}, /* benchmark */
    {0x1eb11c27u, 0x9103d0c3u}, /* benchmark */
    {0x0174919fu, 0xf43a59e7u}, /* benchmark */
    {0xa3a2c9f0u, 0x1a617448u}, /* benchmark */
    {0x3c60226bu, 0xd44e240fu}, /* benchmark */
    {0x2463197du, 0x93e2f9e5u}, /* benchmark */
    {0x0f41320du, 0x3695144du}, /* benchmark */
    {0xa79d2180u, 0x4a30c1edu}, /* benchmark */
    {0xaf001419u, 0xb75fbaefu}, /* benchmark */
    {0x0f41320du, 0x3695144du}, /* benchmark */
    {0x8bc95d62u, 0x4f1d0282u}, /* benchmark */
    {0x53f7759du, 0xc7fbd867u}, /* benchmark */
    {0x94d59b79u, 0xfab75cc7u}, /* benchmark */
    {0x1e663036u, 0x26df0d69u}, /* benchmark */
    {0x980c74b1u, 0xb54129fdu}, /* large */
    {0x73d4d4ffu, 0x6defdbb5u}, /* large */
    {0x4f12aabfu, 0x52d4f071u}, /* large */
    {0x3c474ffau, 0x7ed14a4cu}, /* large */
    {0xe501cdb8u, 0xf3de6e42u}, /* scenes */
    {0x825ffd9au, 0x8d28316du}, /* scenes */
    {0x2c7415e8u, 0xa621c721u}, /* scenes */
    {0x902e0294u, 0xc94b0b50u}, /* scenes */
    {0x42f5198bu, 0xac240b6du}, /* surfaces */
    {0xa2f2869eu, 0xd79a30f2u}, /* surfaces */
    {0xe0797374u, 0x0bdd11adu}, /* surfaces */
    {0x799422e6u, 0x4398873fu}, /* surfaces */
    {0x976fdb56u, 0xffb0244fu}, /* gallery */
    {0xee110d83u, 0x8164326bu}, /* gallery */
    {0x95b303b4u, 0x105f45d8u}, /* gallery */
    {0xb1c35e86u, 0x2758c8deu}, /* gallery */
    {0xb1cc2f5du, 0xda81c0feu}, /* gallery */
    {0x2b62eba9u, 0x4e60b3bau}, /* gallery */
    {0xc5c297aeu, 0x4b449c07u}, /* formats */
    {0x9b142fd0u, 0x4b449c07u}, /* formats */
    {0x729c56a0u, 0x4b449c07u}, /* formats */
    {0x2e7bd4b7u, 0x4c1682c9u}, /* formats */
    {0xd7ec7c7au, 0x4b449c07u}, /* formats */
    {0xc8d8c171u, 0x4c1682c9u}, /* formats */
    {0x0b2768ccu, 0x4c1682c9u}, /* formats */
    {0x43d3e91du, 0x4c1682c9u}, /* formats */
    {0xbb10a850u, 0x4c1682c9u}, /* formats */
    {0xbdf8e287u, 0xdc6903f1u}, /* formats */
    {0x9fc612dcu, 0x4c1682c9u}, /* formats */
    {0x91d2dbe1u, 0xdc6903f1u}, /* formats */
    {0xf36bb08eu, 0x4c1682c9u}, /* formats */
    {0x612619a8u, 0x4c1682c9u}, /* formats */
    {0x1caa0e3eu, 0x4c1682c9u}, /* formats */
    {0x02e21373u, 0x4c1682c9u}, /* formats */
};

#endif
