/* SPDX-License-Identifier: MIT */
#include "physical.h"

#include <math.h>

/** Largest exponent that comes of a roughness. */
#define SHININESS_MAX 1024.0

/** Reflectance of what is no metal, seen straight on: glTF 2.0, appendix B.3.5. */
#define DIELECTRIC 0.04

/**
 * Sets the lobe of a reflectance F0. alpha = roughness^2 is that of glTF 2.0, appendix B.3.5. The exponent
 * 2 / alpha^2 - 2 gives Blinn's lobe the width of Beckmann's (Walter et al., 2007, section 5.2). (Ns + 2) / 8 gives it
 * the same energy (Karis, Specular BRDF Reference, 2013: implicit shadowing, light of pi as the diffuse term has it).
 * The factor 1 - alpha is this program's own: what is rough has no lobe left, and a metal's reflection counts as
 * diffuse, else the rough metal that glTF takes where nothing is said would be black.
 */
static void set_lobe(const double reflectance[3], double alpha, mtl_material *made) {
    const double exponent = alpha > 0 ? 2 / (alpha * alpha) - 2 : SHININESS_MAX;
    double strongest = 1;
    made->shininess = fmin(fmax(exponent, 1), SHININESS_MAX);
    made->given |= MTL_DIFFUSE | MTL_SHININESS;
    for (int i = 0; i < 3; i++) {
        made->specular[i] = reflectance[i] * (made->shininess + 2) / 8 * (1 - alpha);
        strongest = fmax(strongest, made->specular[i]);
    }
    for (int i = 0; i < 3; i++) {
        made->specular[i] /= strongest;
    }
}

void physical_from_metallic(const double base[3], double metal, double roughness, mtl_material *made) {
    const double alpha = roughness * roughness;
    double reflectance[3];
    for (int i = 0; i < 3; i++) {
        reflectance[i] = DIELECTRIC + (base[i] - DIELECTRIC) * metal;
        made->diffuse[i] = base[i] * (1 - metal * (1 - alpha));
    }
    set_lobe(reflectance, alpha, made);
}

/**
 * Finds how much of a metal it is from the brightest channels: of a metal all light is reflected, of others diffuse but
 * for DIELECTRIC. What a metal reflects counts as diffuse where it is rough, as above.
 */
void physical_from_glossy(const double diffuse[3], const double specular[3], double glossiness, mtl_material *made) {
    const double alpha = (1 - glossiness) * (1 - glossiness);
    double reflected = 0;
    double scattered = 0;
    for (int i = 0; i < 3; i++) {
        reflected = fmax(reflected, specular[i] - DIELECTRIC);
        scattered = fmax(scattered, diffuse[i]);
    }
    const double metal = reflected > 0 ? reflected / (reflected + scattered) : 0;
    for (int i = 0; i < 3; i++) {
        made->diffuse[i] = fmin(diffuse[i] + alpha * fmax(specular[i] - DIELECTRIC * (1 - metal), 0), 1);
    }
    set_lobe(specular, alpha, made);
}
