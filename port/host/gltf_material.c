/* SPDX-License-Identifier: MIT */
/**
 * @file gltf_material.c
 * Materials of glTF: 3.9, KHR_materials_unlit, KHR_materials_emissive_strength, KHR_materials_pbrSpecularGlossiness.
 */
#include "gltf.h"

#include "physical.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Reads up to 4 numbers from 0 to 1; what is missing stays. */
static void read_factors(const json_value *object, const char *name, double *factors, size_t count) {
    const json_value *array = json_member(object, name);
    const json_value *item = json_first(array);
    for (size_t i = 0; i < count && i < json_count(array); i++) {
        factors[i] = fmin(fmax(json_number(item, factors[i]), 0), 1);
        item = json_next(item);
    }
}

static double read_factor(const json_value *object, const char *name, double otherwise) {
    return fmin(fmax(json_number(json_member(object, name), otherwise), 0), 1);
}

/** Reads finite numbers; what is missing stays. */
static void read_numbers(const json_value *object, const char *name, double *numbers, size_t count) {
    const json_value *array = json_member(object, name);
    const json_value *item = json_first(array);
    for (size_t i = 0; i < count && i < json_count(array); i++) {
        numbers[i] = json_number(item, numbers[i]);
        item = json_next(item);
    }
}

static const json_value *find_extension(const json_value *material, const char *name) {
    return json_member(json_member(material, "extensions"), name);
}

/** Reads the base colour with its alpha, whichever way the material is given. */
static void read_base(const json_value *material, double base[4]) {
    const json_value *glossy = find_extension(material, "KHR_materials_pbrSpecularGlossiness");
    for (int i = 0; i < 4; i++) {
        base[i] = 1;
    }
    if (glossy != NULL) {
        read_factors(glossy, "diffuseFactor", base, 4);
    } else {
        read_factors(json_member(material, "pbrMetallicRoughness"), "baseColorFactor", base, 4);
    }
}

/* ---- Textures --------------------------------------------------------------------------------------------------- */

/** Finds the texture of the base colour, whichever way the material is given; or null. */
static const json_value *find_texture(const json_value *material) {
    const json_value *glossy = find_extension(material, "KHR_materials_pbrSpecularGlossiness");
    return glossy != NULL ? json_member(glossy, "diffuseTexture")
                          : json_member(json_member(material, "pbrMetallicRoughness"), "baseColorTexture");
}

size_t gltf_texture_set(gltf_file *file, const json_value *primitive) {
    size_t number = 0;
    size_t set = 0;
    if (!json_whole(json_member(primitive, "material"), &number) || number >= file->materials.count) {
        return 0;
    }
    const json_value *texture = find_texture(file->materials.items[number]);
    const json_value *moved = find_extension(texture, "KHR_texture_transform");
    json_whole(json_member(texture, "texCoord"), &set);
    json_whole(json_member(moved, "texCoord"), &set);
    return set;
}

/** Takes coordinates as KHR_texture_transform says: scaled, turned, and then moved. */
static void read_transform(const json_value *moved, mtl_texture *texture) {
    double scale[2] = {1, 1};
    double move[2] = {0, 0};
    const double turn = json_number(json_member(moved, "rotation"), 0);
    read_numbers(moved, "scale", scale, 2);
    read_numbers(moved, "offset", move, 2);
    texture->transform[0][0] = cos(turn) * scale[0];
    texture->transform[0][1] = sin(turn) * scale[1];
    texture->transform[1][0] = -sin(turn) * scale[0];
    texture->transform[1][1] = cos(turn) * scale[1];
    texture->transform[0][2] = move[0];
    texture->transform[1][2] = move[1];
}

/** Reads whether a texture repeats (3.8.4.2): along both axes, or along none. */
static void read_sampler(gltf_file *file, const json_value *texture, mtl_texture *made) {
    size_t modes[2] = {10497, 10497};
    size_t number;
    if (json_whole(json_member(texture, "sampler"), &number) && number < file->samplers.count) {
        json_whole(json_member(file->samplers.items[number], "wrapS"), &modes[0]);
        json_whole(json_member(file->samplers.items[number], "wrapT"), &modes[1]);
    }
    made->clamps = modes[0] == 33071 && modes[1] == 33071;
    if (modes[0] != modes[1] || modes[0] == 33648) {
        reader_warn(file->base, "a texture repeats along both axes: mirrored, or along one alone, is not drawn");
    }
}

/** Names the image: a file, or a picture within this one, which is read. */
static void name_image(gltf_file *file, size_t number, mtl_texture *made) {
    host_materials *materials = file->base->materials;
    const json_value *image = file->images.items[number];
    char *uri = json_text(json_member(image, "uri"));
    char name[32];
    snprintf(name, sizeof name, "image %zu", number);
    if (uri[0] != '\0' && strncmp(uri, "data:", 5) != 0) {
        gltf_unescape(uri);
        mtl_set_texture(made, uri, strlen(uri));
    } else {
        if (file->pictures[number] == 0) {
            host_bytes bytes;
            if (!gltf_read_image(file, image, &bytes)) {
                reader_warn(file->base, "%.200s", file->base->problem->text);
            }
            materials->pictures = memory_grow(materials->pictures, &materials->picture_capacity,
                                              materials->picture_count, sizeof *materials->pictures);
            materials->pictures[materials->picture_count++] = bytes;
            file->pictures[number] = materials->picture_count;
        }
        mtl_set_texture(made, name, strlen(name));
        made->picture = file->pictures[number];
    }
    free(uri);
}

static void read_texture(gltf_file *file, const json_value *material, mtl_texture *made) {
    const json_value *info = find_texture(material);
    const json_value *moved = find_extension(info, "KHR_texture_transform");
    const json_value *mode = json_member(material, "alphaMode");
    size_t number;
    size_t source;
    if (info == NULL) {
        return;
    }
    if (!json_whole(json_member(info, "index"), &number) || number >= file->textures.count ||
        !json_whole(json_member(file->textures.items[number], "source"), &source) || source >= file->images.count) {
        reader_warn(file->base, "a texture is not drawn: it has no image of PNG or JPEG");
        return;
    }
    name_image(file, source, made);
    read_sampler(file, file->textures.items[number], made);
    if (moved != NULL) {
        read_transform(moved, made);
    }
    made->cutoff = json_is(mode, "BLEND") ? 0.5 : 0;
    made->cutoff = json_is(mode, "MASK") ? read_factor(material, "alphaCutoff", 0.5) : made->cutoff;
}

/* ---- Materials -------------------------------------------------------------------------------------------------- */

/** The name; of a material without one its number, and a word for the one of what has none. */
static char *read_name(const json_value *material, size_t number) {
    char text[24] = "default";
    char *name = json_text(json_member(material, "name"));
    if (name[0] == '\0') {
        free(name);
        if (material != NULL) {
            snprintf(text, sizeof text, "%zu", number);
        }
        name = memory_new(strlen(text) + 1, 1);
        strcpy(name, text);
    }
    return name;
}

static void read_material(const json_value *material, mtl_material *made) {
    const json_value *metallic = json_member(material, "pbrMetallicRoughness");
    const json_value *glossy = find_extension(material, "KHR_materials_pbrSpecularGlossiness");
    const json_value *strength = find_extension(material, "KHR_materials_emissive_strength");
    double base[4];
    memset(made, 0, sizeof *made);
    made->illumination = find_extension(material, "KHR_materials_unlit") != NULL ? 0 : 2;
    made->double_sided = json_true(json_member(material, "doubleSided"));
    read_base(material, base);
    made->passed = json_is(json_member(material, "alphaMode"), "BLEND") && base[3] > 0 ? 1 - base[3] : 0;
    if (glossy != NULL) {
        double specular[3] = {1, 1, 1};
        read_factors(glossy, "specularFactor", specular, 3);
        physical_from_glossy(base, specular, read_factor(glossy, "glossinessFactor", 1), made);
    } else {
        physical_from_metallic(base, read_factor(metallic, "metallicFactor", 1),
                               read_factor(metallic, "roughnessFactor", 1), made);
    }
    read_factors(material, "emissiveFactor", made->emission, 3);
    for (int i = 0; i < 3; i++) {
        const double emission = made->emission[i] * json_number(json_member(strength, "emissiveStrength"), 1);
        made->emission[i] = fmin(fmax(emission, 0), MTL_COLOUR_MAX);
    }
}

bool gltf_use_material(gltf_file *file, const json_value *primitive, uint32_t *number) {
    host_materials *materials = file->base->materials;
    mtl_library *all = &materials->all;
    const json_value *material = NULL;
    size_t place = file->materials.count; /* of the material of what has none: all at its defaults (3.7.2.1) */
    if (json_member(primitive, "material") != NULL &&
        (material = gltf_item(file, &file->materials, primitive, "material", &place)) == NULL) {
        return false;
    }
    if (file->used[place] == 0) {
        if (materials->used_count == OBJ_MATERIALS_MAX) {
            return reader_fail(file->base, "more than %d materials", OBJ_MATERIALS_MAX);
        }
        all->list = memory_grow(all->list, &all->capacity, all->count, sizeof *all->list);
        read_material(material, &all->list[all->count]);
        read_texture(file, material, &all->list[all->count].texture);
        all->list[all->count].name = read_name(material, place);
        if (materials->used == NULL) {
            materials->used = memory_new(OBJ_MATERIALS_MAX, sizeof *materials->used);
        }
        materials->used[materials->used_count++] = all->count++;
        file->used[place] = (uint32_t)materials->used_count;
    }
    *number = file->used[place];
    return true;
}

static bool has_other_textures(const json_value *material) {
    const json_value *metallic = json_member(material, "pbrMetallicRoughness");
    const json_value *glossy = find_extension(material, "KHR_materials_pbrSpecularGlossiness");
    return json_member(material, "normalTexture") != NULL || json_member(material, "occlusionTexture") != NULL ||
           json_member(material, "emissiveTexture") != NULL ||
           json_member(metallic, "metallicRoughnessTexture") != NULL ||
           json_member(glossy, "specularGlossinessTexture") != NULL;
}

void gltf_warn_of_materials(gltf_file *file) {
    size_t textured = 0;
    for (size_t i = 0; i < file->materials.count; i++) {
        textured += file->used[i] > 0 && has_other_textures(file->materials.items[i]);
    }
    if (textured > 0) {
        reader_warn(file->base, "of textures only base colours are drawn: %zu materials have others", textured);
    }
}
