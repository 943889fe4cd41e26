/* SPDX-License-Identifier: MIT */
/*
 * Firmware that counts what docs/cost.md shows as it is by default: an infinite viewer, and no arena that is kept from
 * frame to frame. It writes lines as workload_frames.c does,
 *     torus576,320x240 infinite 32x32 anew 8 points,INSTRUCTIONS,SMALLEST,BEST
 */
#define IS_BY_DEFAULT 1
#include "workload_frames.c" /* NOLINT(bugprone-suspicious-include): the same program, by default */
