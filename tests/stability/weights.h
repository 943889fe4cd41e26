/* SPDX-License-Identifier: MIT */
/** @file weights.h Sums of light weights, by which the contract's bounds grow. */
#ifndef GLINT_STABILITY_WEIGHTS_H
#define GLINT_STABILITY_WEIGHTS_H

#include "glint.h"

/** Diffuse and specular weights times the lights' colours, summed over the lights: that of the largest channel. */
double weights_sum(const glint_scene *scene, const glint_material *material);

/** Steps of a format that a value may be off before it is rounded, whatever the threshold: a part of the sum. */
double weights_slack(double sum, const glint_format *format);

/** Steps from the unrounded reference that 99.9 % of the pixels keep to: half a step, and a part of the sum. */
double weights_bound(double sum, const glint_format *format);

#endif
