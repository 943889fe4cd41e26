/* SPDX-License-Identifier: MIT */
/**
 * @file fuzz_formats.c
 * The readers of STL, PLY, OFF and glTF on any bytes (libFuzzer), chosen by how these begin: each either reports one
 * problem, or gives a mesh whose triangles have materials that are there, and no two of whose positions are the same.
 * Likewise the reader of PNG, whose picture becomes a texture as its last byte chooses: one that the library takes.
 */
#include "checks.h"
#include "model.h"

#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/** A name in a folder that is not there: no buffer beside the model is found. */
static const char *choose_name(const uint8_t *data, size_t size) {
    char start[8] = "";
    memcpy(start, data, size < sizeof start ? size : sizeof start - 1);
    return strncmp(start, "ply", 3) == 0                       ? "none/model.ply"
           : strstr(start, "OFF") != NULL                      ? "none/model.off"
           : start[0] == '{' || strncmp(start, "glTF", 4) == 0 ? "none/model.glb"
                                                               : "none/model.stl";
}

/* ---- Pictures ---------------------------------------------------------------------------------------------------- */

/** Texels of a picture that becomes a texture: larger ones take long. */
#define TEXELS_MAX 65536

static bool is_side(uint32_t side) {
    return side >= 1 && side <= TEXTURE_SIDE_MAX && (side & (side - 1)) == 0;
}

static void check_texture(const host_texture *made) {
    const glint_texture *texture = &made->texture;
    const bool has_palette = made->type == TEXTURE_PALETTE256 || made->type == TEXTURE_PALETTE16;
    require(made->type > TEXTURE_AUTO && made->type <= TEXTURE_PALETTE16 && texture->type != NULL);
    require(is_side(texture->width) && is_side(texture->height) && texture->flags <= GLINT_TEXTURE_HAS_KEY);
    require(made->error >= 0 && made->error <= 255.0 * 255 && (texture->palette != NULL) == has_palette);
    unsigned sum = 0; /* all of it can be read */
    for (const glint_texture *level = texture; level != NULL; level = level->smaller) {
        for (size_t i = 0; i < texture_items(level); i++) {
            sum += made->type == TEXTURE_RGB565 ? ((const uint16_t *)level->texels)[i]
                                                : ((const uint8_t *)level->texels)[i];
        }
    }
    for (size_t i = 0; has_palette && i < (made->type == TEXTURE_PALETTE16 ? 16 : 256); i++) {
        sum += texture->palette[i];
    }
    require(sum < UINT32_MAX);
}

static void read_picture(const uint8_t *data, size_t size) {
    host_picture picture;
    host_problem problem = {0, ""};
    const uint8_t choice = data[size - 1];
    const texture_options options = {(texture_type)(choice % 5), choice & 64 ? 16 : 0, (choice & 32) != 0,
                                     (choice & 128) != 0};
    uint8_t *memory = allocate(size);
    memcpy(memory, data, size);
    const bool ok = png_decode(memory, size, &picture, &problem);
    free(memory);
    if (!ok) {
        check_problem(&problem);
        return;
    }
    require(picture.width >= 1 && picture.width <= PICTURE_SIDE_MAX && picture.height >= 1);
    if ((size_t)picture.width * picture.height <= TEXELS_MAX) {
        host_texture *made = texture_make(&picture, choice & 128 ? 0.5 : 0, &options);
        check_texture(made);
        texture_free(made);
    }
    free(picture.pixels);
}

/* ---- Models ------------------------------------------------------------------------------------------------------ */

static void check_textures(host_mesh *mesh, host_materials *materials) {
    static const load_options options = {.texture = {TEXTURE_AUTO, 32, false}};
    host_warnings warnings = {.count = 0};
    host_problem problem = {0, ""};
    require(textures_load("none/model", &options, mesh, materials, &warnings, &problem));
    check_warnings(&warnings, 0);
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        const mtl_material *material = materials_find(materials, mesh->materials[i / 3]);
        const uint32_t texture = mesh->triangles[i / 3][i % 3].texture;
        require(texture <= mesh->texture_count);
        require((texture > 0) == (material != NULL && material->texture.made != NULL));
    }
    for (size_t i = 0; i < materials->texture_count; i++) {
        check_texture(materials->textures[i]);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    host_mesh mesh;
    host_materials materials;
    host_warnings warnings;
    host_problem problem = {0, ""};
    host_bytes file = {NULL, size, size};
    if (size > 0 && (data[0] == 0x89 || data[0] == 0xFF)) {
        read_picture(data, size);
        return 0;
    }
    file.data = allocate(size);
    if (size > 0) {
        memcpy(file.data, data, size);
    }
    const bool ok = reader_load(choose_name(data, size), &file, &mesh, &materials, &warnings, &problem);
    free(file.data);
    if (!ok) {
        check_problem(&problem);
        return 0;
    }
    check_warnings(&warnings, 0);
    check_materials(&materials.all);
    require(mesh.face_count > 0 && materials.objects.count <= OBJ_OBJECTS_MAX);
    for (size_t i = 0; i < mesh.triangle_count; i++) {
        require(mesh.materials[i] <= materials.used_count && mesh.objects[i] <= materials.objects.count + 1);
    }
    check_textures(&mesh, &materials);
    require(mesh_join(&mesh, 0) == 0);
    check_mesh(&mesh);
    materials_free(&materials);
    mesh_free(&mesh);
    return 0;
}
