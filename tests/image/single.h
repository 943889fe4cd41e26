/* SPDX-License-Identifier: MIT */
/** @file single.h Cases of suite `extremes` that draw a single triangle. */
#ifndef GLINT_SINGLE_H
#define GLINT_SINGLE_H

/** Each keeps the contract, by a way of drawing that hardly another triangle has. */
void triangles_at_the_bounds(void);

/** Light that changes so fast is left to fragments. */
void a_cone_of_one_degree(void);

#endif
