/* SPDX-License-Identifier: MIT */
#include "import.h"

#include "../physical.h"

#include <assimp/material.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

/** A material of Phong's kind as it stands. */
static void paint_plainly(mtl_material *made, const struct aiMaterial *material) {
    const double strength = number_of(material, AI_MATKEY_SHININESS_STRENGTH, 1);
    colour_of(material, AI_MATKEY_COLOR_DIFFUSE, made->diffuse);
    colour_of(material, AI_MATKEY_COLOR_SPECULAR, made->specular);
    for (int i = 0; i < 3; i++) {
        made->specular[i] *= strength;
    }
    made->shininess = number_of(material, AI_MATKEY_SHININESS, -1);
}

static int is_physical(const struct aiMaterial *material) {
    return number_of(material, AI_MATKEY_METALLIC_FACTOR, -1) >= 0 ||
           number_of(material, AI_MATKEY_ROUGHNESS_FACTOR, -1) >= 0;
}

static mtl_material paint_of(const struct aiMaterial *material) {
    mtl_material made = {.diffuse = {0.6, 0.6, 0.6}};
    const double metal = number_of(material, AI_MATKEY_METALLIC_FACTOR, -1);
    const double roughness = number_of(material, AI_MATKEY_ROUGHNESS_FACTOR, -1);
    double base[3] = {1, 1, 1};
    if (!is_physical(material)) {
        paint_plainly(&made, material);
    } else {
        if (!colour_of(material, AI_MATKEY_BASE_COLOR, base)) {
            colour_of(material, AI_MATKEY_COLOR_DIFFUSE, base);
        }
        physical_from_metallic(base, clamp(metal, 0, 1), roughness < 0 ? 1 : clamp(roughness, 0, 1), &made);
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

/** Prints the picture of the base colour, which may lie within the file: then only one beside it is read. */
static int print_texture(const struct aiScene *scene, const struct aiMaterial *material, enum aiTextureType type) {
    struct aiString path;
    enum aiTextureMapMode modes[2] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
    if (aiGetMaterialTexture(material, type, 0, &path, NULL, NULL, NULL, NULL, modes, NULL) != aiReturn_SUCCESS) {
        return 0;
    }
    const unsigned long number = path.data[0] == '*' ? strtoul(path.data + 1, NULL, 10) : ULONG_MAX;
    if (number < scene->mNumTextures && scene->mTextures[number]->mFilename.length > 0) {
        path = scene->mTextures[number]->mFilename;
    }
    for (char *c = path.data; *c != '\0'; c++) {
        *c = (char)((unsigned char)*c >= ' ' ? *c : '_');
    }
    printf("map_Kd %s\"%s\"\n", modes[0] == aiTextureMapMode_Clamp && modes[1] == modes[0] ? "-clamp on " : "",
           path.data);
    return 1;
}

/** Prints a line for textures other than that. */
static void print_textures(const struct aiScene *scene, const struct aiMaterial *material) {
    int count = 0;
    for (int type = aiTextureType_NONE; type <= AI_TEXTURE_TYPE_MAX; type++) {
        count += aiGetMaterialTextureCount(material, (enum aiTextureType)type) > 0;
    }
    const int drawn = print_texture(scene, material, aiTextureType_BASE_COLOR) ||
                      print_texture(scene, material, aiTextureType_DIFFUSE);
    if (count > 1 || (count == 1 && !drawn)) {
        puts("map_Ks texture");
    }
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

static void print_material(const struct aiScene *scene, const struct aiMaterial *material) {
    const mtl_material made = paint_of(material);
    double emission[3] = {0, 0, 0};
    print_colour("Kd", made.diffuse);
    print_colour("Ks", made.specular);
    if (made.shininess >= 0) {
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
    print_textures(scene, material);
}

void paint_print(const struct aiScene *scene) {
    struct aiString name;
    for (unsigned i = 0; i < scene->mNumMaterials; i++) {
        if (name_of(scene, i, &name)) {
            print_name("newmtl", scene, i, &name);
            print_material(scene, scene->mMaterials[i]);
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
