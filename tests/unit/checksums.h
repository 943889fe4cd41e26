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
    0x78500876u, /* pictures */
    0x20b10900u, /* pictures */
    0x1b9f7ab4u, /* pictures */
    0x8d4cafc2u, /* pictures */
    0xeac00b98u, /* pictures */
    0xd8d46c89u, /* pictures */
    0xe185ba40u, /* pictures */
    0x8dea18b3u, /* pictures */
    0xb9cc7114u, /* pictures */
    0xe07029a3u, /* pictures */
    0x82b74355u, /* pictures */
    0xf306ffb2u, /* pictures */
    0x3489833au, /* textures */
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
