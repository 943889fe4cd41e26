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
    0xeea48d66u, /* local_viewer */
    0xcfd10428u, /* infinite_viewer */
    0x354c489cu, /* exponent_half */
    0x36036016u, /* exponent_two */
    0xfb845b79u, /* exponent_1024 */
    0x8aa8f385u, /* exponents_beyond */
    0xbbf2fb01u, /* curved */
    0x3fbe4c79u, /* curved_infinite */
    0x0fcac212u, /* curved_exponent_8192 */
    0x971aa1e9u, /* curved_exponent_1024 */
    0x908a4ba6u, /* curved_gently */
    0x7e3a10c5u, /* curved_gently_infinite */
    0xfe55c663u, /* curved_gently_exponent_256 */
    0x43a3c5dbu, /* eight_lights */
    0x04db6918u, /* eight_lights_infinite */
    0x57e9bc99u, /* saturated */
    0x8bd854a8u, /* near_plane */
    0xda8a09c5u, /* floor_to_horizon */
    0x00c9afc6u, /* large_highlight */
    0x6598cdd1u, /* guard_band */
    0xf3636e33u, /* mirrored_double_sided */
    0x7b8d6d35u, /* squashed */
    0xcbad351bu, /* interlocked */
    0x5b7f54fdu, /* turned_camera */
    0x77051dc5u, /* no_objects */
    0xfe7b377cu, /* big_endian */
    0x5e19852eu, /* rgb888_odd_size */
    0xd4c48de9u, /* grey8_odd_size */
    0x392c720cu, /* grey4_odd_size */
    0x0e37d1a6u, /* rgb444_odd_size */
    0x0d934524u, /* tall_and_thin */
    0x418a6b15u, /* one_pixel */
    0x6a9e76a7u, /* point_light */
    0xc89cdb20u, /* spot_phong */
    0x8dc475ebu, /* lambert_infinite */
    0x6282db6bu, /* phong_ungated_max */
    0xa121b85fu, /* per_vertex */
    0x40d0ee1du, /* per_vertex_clipped */
    0xeb3475abu, /* per_facet */
    0x2b3439b3u, /* per_facet_clipped */
    0x0c8b9f5du, /* mesh_colours */
    0x289e51a9u, /* mesh_colours565_per_vertex */
    0xc000fff1u, /* mesh_colours_unlit_facets */
    0x779ca5f7u, /* rgb565_dithered */
    0x7f400056u, /* grey4_dithered_odd_size */
    0x3ebf27bbu, /* rgb444_dithered */
    0xb68aaf6au, /* mono_dithered_odd_size */
    0x969b287eu, /* elementary_functions */
    0x79785263u, /* unit_vectors */
    0x7dc44604u, /* poses */
    0xca3899d5u, /* cameras */
    0x08e7d75eu, /* leading_zeros */
    0xe2eb2995u, /* magnitude_bits */
    0xa6eeab3fu, /* inverse_root */
    0xa377c888u, /* inverse */
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
    0xa3b687e5u, /* luma_1 */
    0x36118962u, /* luma_15 */
    0x1dc75f1au, /* luma_255 */
    0x602a8e25u, /* channel */
    0x3cbd01d5u, /* clamped_colour */
    0xf312434fu, /* gamma_of_squares */
    0xe7241fc5u, /* dither_threshold */
};

#endif
