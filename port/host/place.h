/* SPDX-License-Identifier: MIT */
/**
 * @file place.h
 * Where a model is put before it is quantised, and how large.
 */
#ifndef GLINT_HOST_PLACE_H
#define GLINT_HOST_PLACE_H

#include "load.h"
#include "settings.h"

/**
 * Puts a model where options say: --up-axis, --centre, --scale and, when `turned`, --rotate-x, -y and -z, in this
 * order. Sets the model's box.
 */
void place_model(host_model *model, const host_settings *settings, bool turned);

/**
 * Moves the middle of a model's box to the origin and scales it by a power of ten to a half side of 0.3 to 3, where
 * Q16.16 does not hold its coordinates, or is too coarse or too narrow for a camera that frames it. Sets model->fit and
 * the model's note. The model's box stays what it was.
 */
void place_to_fit(host_model *model, const host_settings *settings);

#endif
