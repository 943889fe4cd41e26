/* SPDX-License-Identifier: MIT */
/**
 * @file physical.h
 * Physically based materials as Kd, Ks and Ns, by the formulas in docs/assets.md.
 */
#ifndef GLINT_HOST_PHYSICAL_H
#define GLINT_HOST_PHYSICAL_H

#include "model.h"

/** Sets `made` from base colour, metalness and roughness, all from 0 to 1. */
void physical_from_metallic(const double base[3], double metal, double roughness, mtl_material *made);

/** Sets `made` from diffuse colour, reflectance seen straight on, and glossiness, all from 0 to 1. */
void physical_from_glossy(const double diffuse[3], const double specular[3], double glossiness, mtl_material *made);

#endif
