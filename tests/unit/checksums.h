/* SPDX-License-Identifier: MIT */
/*
 * Made by `make unit-tables`; not to be edited. Says only that every core and compiler computes the same
 * bits: whether they are right is judged by the reference, tests/image/compare.c.
 */
/* clang-format off */
#ifndef GLINT_UNIT_CHECKSUMS_H
#define GLINT_UNIT_CHECKSUMS_H

#include <stdint.h>

static const uint32_t expected_checksums[] = {
    0x3b9498f4u, /* local_viewer */
    0x039232dau, /* infinite_viewer */
    0x0e393813u, /* exponent_half */
    0x2d9be738u, /* exponent_two */
    0xd12ae760u, /* exponent_1024 */
    0xa051e411u, /* exponents_beyond */
    0xc4ca1b5au, /* eight_lights */
    0x2bae9fbbu, /* eight_lights_infinite */
    0xc312f2d6u, /* saturated */
    0x1c33eefdu, /* near_plane */
    0xda8a09c5u, /* floor_to_horizon */
    0x71712085u, /* guard_band */
    0x92888349u, /* mirrored_double_sided */
    0x48db1401u, /* squashed */
    0x45965872u, /* interlocked */
    0x56451c6au, /* turned_camera */
    0x77051dc5u, /* no_objects */
    0x460e9816u, /* big_endian */
    0xe5843de8u, /* rgb888_odd_size */
    0xa2eae28fu, /* grey8_odd_size */
    0xb17b101cu, /* grey4_odd_size */
    0x4821fb52u, /* rgb444_odd_size */
    0xd33277eau, /* tall_and_thin */
    0x418a6b15u, /* one_pixel */
    0xab116681u, /* point_light */
    0x9804da18u, /* spot_phong */
    0x37ae56c2u, /* lambert_infinite */
    0x171ada5bu, /* phong_ungated_max */
    0x59bb3e07u, /* per_vertex */
    0x11f13aa3u, /* per_vertex_clipped */
    0xa331ea83u, /* per_facet */
    0xd913fef0u, /* per_facet_clipped */
    0x0c8b9f5du, /* mesh_colours */
    0xac712d7eu, /* mesh_colours565_per_vertex */
    0xc000fff1u, /* mesh_colours_unlit_facets */
    0x7535c4f7u, /* rgb565_dithered */
    0x0df2e9b3u, /* grey4_dithered_odd_size */
    0x74d9d3bdu, /* rgb444_dithered */
    0xb68aaf6au, /* mono_dithered_odd_size */
    0x969b287eu, /* elementary_functions */
    0x79785263u, /* unit_vectors */
    0x7dc44604u, /* poses */
    0xca3899d5u, /* cameras */
    0x08e7d75eu, /* leading_zeros */
    0xe2eb2995u, /* magnitude_bits */
    0xa6eeab3fu, /* inverse_root */
    0xeca747b2u, /* reciprocal */
    0x78495554u, /* log2 */
    0x91f01fe9u, /* exp2 */
    0x7a3afcf8u, /* power_least */
    0x2193b891u, /* power_half */
    0xf37a2ab9u, /* power_1 */
    0xe2852292u, /* power_2 */
    0xdc338fd3u, /* power_32 */
    0x77184510u, /* power_100_3 */
    0xc4fb240fu, /* power_1024 */
    0x49f54259u, /* power_largest */
    0x36bc3c2cu, /* sine_of_phase */
    0xd5e2b0d3u, /* phase */
    0x85d801aeu, /* sin */
    0x14aedc65u, /* cos */
    0x36118962u, /* level_15 */
    0xb35368aau, /* level_31 */
    0x72e7369au, /* level_63 */
    0x1dc75f1au, /* level_255 */
    0x49e59785u, /* luma_of_grey */
    0x3cbd01d5u, /* clamped_colour */
    0x16346f31u, /* gamma_of_squares */
    0x76dc5fc5u, /* dither_threshold */
};

#endif
