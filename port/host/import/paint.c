/* SPDX-License-Identifier: MIT */
#include "import.h"

#include <assimp/material.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/** Largest exponent that comes of a roughness. */
#define SHININESS_MAX 1024.0

/** Reflectance of what is no metal, seen straight on: glTF 2.0, appendix B.3.5. */
#define DIELECTRIC 0.04

typedef struct paint {
    double diffuse[3], specular[3], shininess; /* 0 or less for an exponent that is not given */
} paint;

/** A number that a material has, or what holds without. What is not finite counts as not given. A key is three values.
 */
static double number_of(const struct aiMaterial *material, const char *key, unsigned type, unsigned index,
                        double otherwise) {
    float value = 0;
    const int got = aiGetMaterialFloatArray(material, key, type, index, &value, NULL) == aiReturn_SUCCESS;
    return got && isfinite(value) ? (double)value : otherwise;
}

/** @return whether the material has such a colour; else `colour` stays */
static int colour_of(const struct aiMaterial *material, const char *key, unsigned type, unsigned index,
                     double colour[3]) {
    struct aiColor4D value = {0, 0, 0, 1};
    if (aiGetMaterialColor(material, key, type, index, &value) != aiReturn_SUCCESS || !isfinite(value.r) ||
        !isfinite(value.g) || !isfinite(value.b)) {
        return 0;
    }
    colour[0] = value.r;
    colour[1] = value.g;
    colour[2] = value.b;
    return 1;
}

static double clamp(double value, double least, double most) {
    return value < least ? least : value > most ? most : value;
}

/**
 * From metalness and roughness. F0 and alpha = roughness^2 are those of glTF 2.0, appendix B.3.5. The exponent
 * 2 / alpha^2 - 2 gives Blinn's lobe the width of Beckmann's (Walter et al., 2007, section 5.2). (Ns + 2) / 8 gives it
 * the same energy (Karis, Specular BRDF Reference, 2013: implicit shadowing, light of pi as the diffuse term has it).
 * The factor 1 - alpha is this program's own: what is rough has no lobe left, and a metal's reflection counts as
 * diffuse, else the rough metal that glTF takes where nothing is said would be black.
 */
static void paint_physically(paint *made, const double base[3], double metal, double roughness) {
    const double alpha = roughness * roughness;
    const double exponent = alpha > 0 ? 2 / (alpha * alpha) - 2 : SHININESS_MAX;
    double strongest = 0;
    made->shininess = clamp(exponent, 1, SHININESS_MAX);
    for (int i = 0; i < 3; i++) {
        const double reflectance = DIELECTRIC + (base[i] - DIELECTRIC) * metal;
        made->specular[i] = reflectance * (made->shininess + 2) / 8 * (1 - alpha);
        made->diffuse[i] = base[i] * (1 - metal * (1 - alpha));
        strongest = fmax(strongest, made->specular[i]);
    }
    for (int i = 0; i < 3 && strongest > 1; i++) {
        made->specular[i] /= strongest;
    }
}

/** A material of Phong's kind as it stands. */
static void paint_plainly(paint *made, const struct aiMaterial *material) {
    const double strength = number_of(material, AI_MATKEY_SHININESS_STRENGTH, 1);
    colour_of(material, AI_MATKEY_COLOR_DIFFUSE, made->diffuse);
    colour_of(material, AI_MATKEY_COLOR_SPECULAR, made->specular);
    for (int i = 0; i < 3; i++) {
        made->specular[i] *= strength;
    }
    made->shininess = number_of(material, AI_MATKEY_SHININESS, 0);
}

static int is_physical(const struct aiMaterial *material) {
    return number_of(material, AI_MATKEY_METALLIC_FACTOR, -1) >= 0 ||
           number_of(material, AI_MATKEY_ROUGHNESS_FACTOR, -1) >= 0;
}

static paint paint_of(const struct aiMaterial *material) {
    paint made = {{0.6, 0.6, 0.6}, {0, 0, 0}, 0};
    const double metal = number_of(material, AI_MATKEY_METALLIC_FACTOR, -1);
    const double roughness = number_of(material, AI_MATKEY_ROUGHNESS_FACTOR, -1);
    double base[3] = {1, 1, 1};
    if (!is_physical(material)) {
        paint_plainly(&made, material);
    } else {
        if (!colour_of(material, AI_MATKEY_BASE_COLOR, base)) {
            colour_of(material, AI_MATKEY_COLOR_DIFFUSE, base);
        }
        paint_physically(&made, base, clamp(metal, 0, 1), roughness < 0 ? 1 : clamp(roughness, 0, 1));
    }
    return made;
}

static int is_unlit(const struct aiMaterial *material) {
    int mode = 0;
    return aiGetMaterialIntegerArray(material, AI_MATKEY_SHADING_MODEL, &mode, NULL) == aiReturn_SUCCESS &&
           mode == aiShadingMode_NoShading;
}

static void print_colour(const char *keyword, const double colour[3]) {
    printf("%s %.6g %.6g %.6g\n", keyword, colour[0], colour[1], colour[2]);
}

static int has_texture(const struct aiMaterial *material) {
    int type = aiTextureType_NONE;
    while (type <= AI_TEXTURE_TYPE_MAX && aiGetMaterialTextureCount(material, (enum aiTextureType)type) == 0) {
        type++;
    }
    return type <= AI_TEXTURE_TYPE_MAX;
}

void paint_plain(struct aiString *name) {
    for (char *c = name->data; *c != '\0'; c++) {
        *c = (char)(*c > ' ' && *c <= '~' && *c != '#' && *c != '\\' ? *c : '_');
    }
}

/** @return false for one that stands for none: by assimp's name for it, or by no name in formats that have none */
static int name_of(const struct aiScene *scene, unsigned number, struct aiString *name) {
    name->length = 0;
    name->data[0] = '\0';
    aiGetMaterialString(scene->mMaterials[number], AI_MATKEY_NAME, name);
    if (strcmp(name->data, AI_DEFAULT_MATERIAL_NAME) == 0 ||
        (name->data[0] == '\0' && !is_physical(scene->mMaterials[number]))) {
        return 0;
    }
    paint_plain(name);
    return 1;
}

/** The name; where others before have it, or it is empty, with the number of the material, behind what no name has. */
static void print_name(const char *keyword, const struct aiScene *scene, unsigned number, const struct aiString *name) {
    struct aiString other;
    int taken = name->data[0] == '\0';
    for (unsigned i = 0; i < number && !taken; i++) {
        taken = name_of(scene, i, &other) && strcmp(other.data, name->data) == 0;
    }
    printf("%s %s", keyword, name->data);
    if (taken) {
        printf("#%u", number);
    }
    putchar('\n');
}

static void print_material(const struct aiMaterial *material) {
    const paint made = paint_of(material);
    double emission[3] = {0, 0, 0};
    print_colour("Kd", made.diffuse);
    print_colour("Ks", made.specular);
    if (made.shininess > 0) {
        printf("Ns %.6g\n", made.shininess);
    }
    if (colour_of(material, AI_MATKEY_COLOR_EMISSIVE, emission)) {
        const double strength = number_of(material, AI_MATKEY_EMISSIVE_INTENSITY, 1);
        for (int i = 0; i < 3; i++) {
            emission[i] *= strength;
        }
        print_colour("Ke", emission);
    }
    printf("illum %d\n", is_unlit(material) ? 0 : 2);
    if (number_of(material, AI_MATKEY_OPACITY, 1) < 1) {
        printf("d %.6g\n", number_of(material, AI_MATKEY_OPACITY, 1));
    }
    if (has_texture(material)) {
        puts("map_Kd texture");
    }
}

void paint_print(const struct aiScene *scene) {
    struct aiString name;
    for (unsigned i = 0; i < scene->mNumMaterials; i++) {
        if (name_of(scene, i, &name)) {
            print_name("newmtl", scene, i, &name);
            print_material(scene->mMaterials[i]);
        }
    }
}

int paint_is_none(const struct aiScene *scene, unsigned material) {
    struct aiString name;
    return material >= scene->mNumMaterials || !name_of(scene, material, &name);
}

void paint_use(const struct aiScene *scene, unsigned material) {
    struct aiString name;
    name_of(scene, material, &name);
    print_name("usemtl", scene, material, &name);
}
