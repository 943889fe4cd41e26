/* SPDX-License-Identifier: MIT */
/** @file single.h Cases of suite `extremes` that draw a single triangle. */
#ifndef GLINT_SINGLE_H
#define GLINT_SINGLE_H

/** Each keeps the contract, however hard it is to light. */
void triangles_at_the_bounds(void);

#endif
