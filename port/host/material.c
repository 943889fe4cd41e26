/* SPDX-License-Identifier: MIT */
/**
 * @file material.c
 * From what an MTL file says to a material of the library.
 */
#include "settings.h"

#include "values.h"

#include <math.h>

/** Level of the ambient light that Ka answers; a scene's own is 1. */
#define AMBIENT_LEVEL 0.1

/** Kd that is not given: the default material's. */
#define DIFFUSE_DEFAULT 0.6

static glint_colour to_colour(const double channels[3]) {
    const glint_colour colour = {number_q16(fmin(channels[0], MTL_COLOUR_MAX)),
                                 number_q16(fmin(channels[1], MTL_COLOUR_MAX)),
                                 number_q16(fmin(channels[2], MTL_COLOUR_MAX))};
    return colour;
}

static bool is_white(const double channels[3]) {
    return channels[0] >= 1 && channels[1] >= 1 && channels[2] >= 1;
}

/** Returns whether a texture would be black: some exporters write Kd 0 beside it. */
static bool hides_texture(const mtl_material *file) {
    return file->texture.made != NULL && !(file->diffuse[0] + file->diffuse[1] + file->diffuse[2] > 0);
}

/** Colours as MTL has them, with Ke in ambient light or, where there is no light, in the colour itself. */
static glint_material from_file(const host_settings *settings, const mtl_material *file) {
    const bool lit = file->illumination > 0;
    double ambient[3];
    double diffuse[3];
    double specular[3];
    /* Below 1 a highlight is no lobe any more but a veil over all that is lit: exporters write Ns 0 for matt. */
    const bool veils = (file->given & MTL_SHININESS) != 0 && !settings->shininess_given;
    const double lobe = veils ? fmin(file->shininess, 1) : 1;
    for (int i = 0; i < 3; i++) {
        const double unsaid = file->texture.made != NULL ? 1 : DIFFUSE_DEFAULT;
        const double own = (file->given & MTL_DIFFUSE) != 0 && !hides_texture(file) ? file->diffuse[i] : unsaid;
        const bool answers = (file->given & MTL_AMBIENT) != 0 && !is_white(file->ambient);
        ambient[i] = AMBIENT_LEVEL * (answers ? file->ambient[i] : own) + file->emission[i];
        diffuse[i] = own + (lit ? 0 : file->emission[i]);
        specular[i] = lobe * file->specular[i];
    }
    glint_material material = {.model = lit ? &glint_model_blinn_phong : &glint_model_unlit};
    material.ambient = to_colour(ambient);
    material.diffuse = to_colour(diffuse);
    if (file->illumination == 1) {
        material.model = &glint_model_lambert;
    } else {
        material.specular = to_colour(specular);
    }
    material.shininess = (file->given & MTL_SHININESS) != 0 ? number_q16(file->shininess) : settings->shininess;
    return material;
}

/** Sets what options say of opacity; else what the file says, or null. */
static void set_opacity(const host_settings *settings, const mtl_material *file, glint_material *material) {
    const double passed = file != NULL ? file->passed : 0;
    const glint_q16 opacity = settings->opacity_given ? settings->opacity : number_q16(1 - passed);
    if (settings->blend_given) {
        material->blend = settings->blend;
    } else if (opacity < GLINT_ONE) {
        material->blend = GLINT_BLEND_ALPHA;
    }
    material->opacity = material->blend != GLINT_BLEND_NONE ? opacity : 0;
}

glint_material settings_material(const host_settings *settings, const mtl_material *file) {
    const uint32_t flags = (settings->takes_larger ? (uint32_t)GLINT_MATERIAL_MAX_WITH_AMBIENT : 0) |
                           (settings->ungated ? (uint32_t)GLINT_MATERIAL_SPECULAR_UNGATED : 0);
    glint_material material = {settings->reflection,
                               settings->ambient,
                               settings->diffuse,
                               settings->specular,
                               settings->shininess,
                               flags,
                               NULL,
                               GLINT_BLEND_NONE,
                               0};
    set_opacity(settings, file, &material);
    if (file == NULL) {
        return material;
    }
    const glint_material own = from_file(settings, file);
    material.model = settings->reflection_given ? material.model : own.model;
    material.ambient = settings->ambient_given ? material.ambient : own.ambient;
    material.diffuse = settings->diffuse_given ? material.diffuse : own.diffuse;
    material.specular = settings->specular_given ? material.specular : own.specular;
    material.shininess = settings->shininess_given ? material.shininess : own.shininess;
    if (file->texture.made != NULL) {
        material.texture = file->texture.made;
        material.flags |= (file->texture.clamps ? (uint32_t)GLINT_MATERIAL_CLAMP : 0) |
                          (settings->bilinear ? (uint32_t)GLINT_MATERIAL_BILINEAR : 0);
    }
    return material;
}
