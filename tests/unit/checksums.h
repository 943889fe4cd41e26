/* SPDX-License-Identifier: MIT */
/*
 * Made by `make figures`; not to be edited. Says only that every core and compiler computes the same
 * bits: whether they are right is judged by the reference, tests/image/accuracy.c.
 */
/* clang-format off */
#ifndef GLINT_UNIT_CHECKSUMS_H
#define GLINT_UNIT_CHECKSUMS_H

#include <stdint.h>

static const uint32_t expected_checksums[] = {
    0x1973b73eu, /* local_viewer */
    0x1a4d0cfeu, /* infinite_viewer */
    0xd78a7ae7u, /* exponent_half */
    0xdc0f8d1eu, /* exponent_two */
    0xe9d47e44u, /* exponent_1024 */
    0x5b6d73f0u, /* exponents_beyond */
    0x17a1139cu, /* curved */
    0xbff4ac0au, /* curved_infinite */
    0x294bd448u, /* curved_exponent_8192 */
    0x8323b46au, /* curved_exponent_1024 */
    0xbd1c1d72u, /* curved_gently */
    0x9fdba25du, /* curved_gently_infinite */
    0x8448c7cdu, /* curved_gently_exponent_256 */
    0xb7db161cu, /* eight_lights */
    0xf070027bu, /* eight_lights_infinite */
    0x1bf103c9u, /* saturated */
    0x087c66a6u, /* near_plane */
    0xda8a09c5u, /* floor_to_horizon */
    0x47143e8bu, /* large_highlight */
    0x2071d918u, /* guard_band */
    0xf879c326u, /* mirrored_double_sided */
    0x17c15145u, /* squashed */
    0x0e1454d0u, /* interlocked */
    0xe819959du, /* turned_camera */
    0x77051dc5u, /* no_objects */
    0xfe056f80u, /* big_endian */
    0xf3c28469u, /* rgb888_odd_size */
    0x8aaed4cau, /* grey8_odd_size */
    0x2df03fcfu, /* grey4_odd_size */
    0x4ef7a4a6u, /* rgb444_odd_size */
    0xe5654271u, /* tall_and_thin */
    0x418a6b15u, /* one_pixel */
    0x477ee808u, /* point_light */
    0xc89cdb20u, /* spot_phong */
    0xa6ab3d53u, /* lambert_infinite */
    0x3338b425u, /* phong_ungated_max */
    0x586ebd2au, /* per_vertex */
    0x57814f13u, /* per_vertex_clipped */
    0xeb3475abu, /* per_facet */
    0x2b3439b3u, /* per_facet_clipped */
    0x1475605du, /* mesh_colours */
    0x338e8736u, /* mesh_colours565_per_vertex */
    0xc000fff1u, /* mesh_colours_unlit_facets */
    0xa069f5a8u, /* rgb565_dithered */
    0x7f400056u, /* grey4_dithered_odd_size */
    0x69c1cbfdu, /* rgb444_dithered */
    0xb68aaf6au, /* mono_dithered_odd_size */
    0x969b287eu, /* elementary_functions */
    0x79785263u, /* unit_vectors */
    0xb11aa47bu, /* poses */
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
    0xf312434fu, /* gamma_of_squares */
    0xe7241fc5u, /* dither_threshold */
};

#endif
