/* SPDX-License-Identifier: MIT */
/**
 * @file plane.h
 * The contract of glint_plane_begin, which set-up itself does without.
 */
#ifndef GLINT_PROOF_PLANE_H
#define GLINT_PROOF_PLANE_H

#include "gradients.h"

/* Corners' values are so much apart; or below 2^30, or none is below 0. */
#define APART(a, b) (-0x7c000000 <= (a) - (b) <= 0x7c000000)

/*@ requires \valid(plane) && \valid_read(gradients);
    requires NARROW(gradients) || WIDE(gradients);
    requires (APART(a1, a0) && APART(a2, a0)) || (a0 >= 0 && a1 >= 0 && a2 >= 0) ||
    (-0x40000000 < a0 < 0x40000000 && -0x40000000 < a1 < 0x40000000 && -0x40000000 < a2 < 0x40000000);
    assigns *plane \from *gradients, a0, a1, a2;
    ensures \initialized(plane); */
void glint_plane_begin(glint_plane *plane, const glint_gradients *gradients, int32_t a0, int32_t a1, int32_t a2);

#endif
