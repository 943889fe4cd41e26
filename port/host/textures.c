/* SPDX-License-Identifier: MIT */
/**
 * @file textures.c
 * From the pictures that materials name to textures, and from a mesh's coordinates to theirs.
 */
#include "model.h"

#include "basics.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Most bytes of a picture's file. */
#define PICTURE_FILE_MAX 100000000u

typedef struct texture_loader {
    const char *model;
    const load_options *options;
    host_mesh *mesh;
    host_materials *materials;
    host_warnings *warnings; /* of the model */
} texture_loader;

/* ---- Files ------------------------------------------------------------------------------------------------------ */

/** Reads a file of the model's folder. @param path set to its path, for the caller to free, where it is read */
static bool read_inside(const char *model, const char *name, host_bytes *file, char **path, host_problem *problem) {
    const size_t folder = (size_t)(path_base_name(model) - model);
    if (!path_is_inside(name)) {
        problem_set(problem, 0, "is not in the model's folder");
        return false;
    }
    *path = memory_new(folder + strlen(name) + 1, 1);
    memcpy(*path, model, folder);
    strcpy(*path + folder, name);
    if (bytes_read_file(file, *path, PICTURE_FILE_MAX, problem)) {
        return true;
    }
    free(*path);
    problem_set(problem, 0, "cannot be read");
    return false;
}

/** Does the same for a name as other systems write it: with backslashes, or folders of another machine. */
static bool read_beside(const char *model, const char *name, host_bytes *file, char **path, host_problem *problem) {
    host_problem other;
    if (read_inside(model, name, file, path, problem)) {
        return true;
    }
    const text_token token = {name, strlen(name)};
    char *plain = text_copy(token);
    for (char *at = strchr(plain, '\\'); at != NULL; at = strchr(at, '\\')) {
        *at = '/';
    }
    const char *base = path_base_name(plain);
    const bool ok = *base != '\0' &&
                    (read_inside(model, plain, file, path, &other) || read_inside(model, base, file, path, &other));
    free(plain);
    return ok;
}

/* ---- Textures --------------------------------------------------------------------------------------------------- */

/** Warns of a material's picture, at the line that names it. */
static void warn(const texture_loader *loader, const mtl_texture *texture, const char *why) {
    host_warnings *warnings =
        texture->library > 0 ? &loader->materials->libraries[texture->library - 1].warnings : loader->warnings;
    char quote[PROBLEM_QUOTE_SIZE];
    if (warnings->count < PROBLEM_WARNINGS_MAX) {
        problem_set(&warnings->list[warnings->count++], texture->line, "warning: the texture '%s' is not drawn: %s",
                    problem_quote(quote, texture->name, strlen(texture->name)), why);
    }
}

/** Returns a texture that was made of the same picture before, or null. */
static const glint_texture *find_texture(const host_materials *materials, const mtl_texture *texture,
                                         const char *name) {
    for (size_t i = 0; i < materials->texture_count; i++) {
        const host_texture *made = materials->textures[i];
        if (strcmp(made->name, name) == 0 && made->picture == texture->picture && !(made->cutoff < texture->cutoff) &&
            !(made->cutoff > texture->cutoff)) {
            return &made->texture;
        }
    }
    return NULL;
}

/** Decodes a picture by what its first bytes are, whatever its name. */
static bool decode(const texture_loader *loader, const host_bytes *file, host_picture *picture, host_problem *problem) {
    static const uint8_t jpeg[] = {0xFF, 0xD8, 0xFF};
    return file->count >= sizeof jpeg && memcmp(file->data, jpeg, sizeof jpeg) == 0
               ? importer_decode(file, &loader->options->import, picture, problem)
               : png_decode(file->data, file->count, picture, problem);
}

/** Makes a texture of a file's bytes, unless there is one. @return null with a problem */
static const glint_texture *make_texture(const texture_loader *loader, const host_bytes *file,
                                         const mtl_texture *texture, const char *name, host_problem *problem) {
    host_materials *materials = loader->materials;
    host_picture picture;
    const glint_texture *known = find_texture(materials, texture, name);
    if (known != NULL) {
        return known;
    }
    if (!decode(loader, file, &picture, problem)) {
        return NULL;
    }
    host_texture *made = texture_make(&picture, texture->cutoff, &loader->options->texture);
    const text_token token = {name, strlen(name)};
    free(picture.pixels);
    made->name = text_copy(token);
    made->picture = texture->picture;
    made->hash = bytes_hash(file->data, file->count);
    materials->textures = memory_grow(materials->textures, &materials->texture_capacity, materials->texture_count,
                                      sizeof(host_texture *));
    materials->textures[materials->texture_count++] = made;
    return &made->texture;
}

/** Loads the picture that a material names, or warns why not. */
static void load_texture(const texture_loader *loader, mtl_texture *texture, bool has_coordinates) {
    host_materials *materials = loader->materials;
    host_problem problem;
    host_bytes file;
    char *path;
    if (!has_coordinates) {
        problem_set(&problem, 0, "the triangles have no texture coordinates");
    } else if (texture->picture > 0) {
        const host_bytes *picture = &materials->pictures[texture->picture - 1];
        texture->made = make_texture(loader, picture, texture, texture->name, &problem);
    } else if (read_beside(loader->model, texture->name, &file, &path, &problem)) {
        texture->made = make_texture(loader, &file, texture, path, &problem);
        free(file.data);
        free(path);
    }
    if (texture->made == NULL) {
        warn(loader, texture, problem.text);
    }
}

/** Reads the picture that all materials are to have. @return null with a problem */
static const glint_texture *load_chosen(const texture_loader *loader, const char *path, host_problem *problem) {
    const glint_texture *made = NULL;
    host_problem why;
    host_bytes file;
    char quote[PROBLEM_QUOTE_SIZE];
    if (loader->mesh->texture_count == 0) {
        problem_set(problem, 0, "--texture: the model has no texture coordinates");
        return NULL;
    }
    if (bytes_read_file(&file, path, PICTURE_FILE_MAX, &why)) {
        const mtl_texture texture = {.name = (char *)(uintptr_t)path, .cutoff = 0.5};
        made = make_texture(loader, &file, &texture, path, &why);
        free(file.data);
    }
    if (made == NULL) {
        problem_set(problem, 0, "--texture %s: %s", problem_quote(quote, path, strlen(path)), why.text);
    }
    return made;
}

/** Gives triangles without a material one that has a texture and nothing else. */
static void paint_bare(const texture_loader *loader, const glint_texture *made) {
    host_materials *materials = loader->materials;
    mtl_library *all = &materials->all;
    size_t capacity = materials->used_count;
    const text_token name = {"textured", 8};
    for (size_t i = 0; i < loader->mesh->triangle_count; i++) {
        uint32_t *material = &loader->mesh->materials[i];
        *material = *material > 0 ? *material : (uint32_t)materials->used_count + 1;
    }
    all->list = memory_grow(all->list, &all->capacity, all->count, sizeof *all->list);
    mtl_material *material = &all->list[all->count];
    memset(material, 0, sizeof *material);
    material->name = text_copy(name);
    material->illumination = 2;
    mtl_set_texture(&material->texture, "", 0);
    material->texture.made = made;
    materials->used = memory_grow(materials->used, &capacity, materials->used_count, sizeof *materials->used);
    materials->used[materials->used_count++] = all->count++;
}

/* ---- Coordinates ------------------------------------------------------------------------------------------------ */

static bool is_identity(const mtl_texture *texture) {
    double most = 0;
    for (int i = 0; i < 6; i++) {
        most = fmax(most, fabs(texture->transform[i / 3][i % 3] - (i == 0 || i == 4 ? 1 : 0)));
    }
    return !(most > 0);
}

/** Takes the coordinates of a material's triangles to its picture. */
static void transform(host_mesh *mesh, uint32_t material, const mtl_texture *texture) {
    const size_t count = mesh->texture_count;
    uint32_t *moved = memory_new(count + 1, sizeof *moved);
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        uint32_t *number = &mesh->triangles[i / 3][i % 3].texture;
        if (mesh->materials[i / 3] != material || *number == 0) {
            continue;
        }
        if (moved[*number] == 0) {
            const double *from = mesh->textures[*number - 1];
            double to[2];
            for (int k = 0; k < 2; k++) {
                const double *row = texture->transform[k];
                to[k] = row[0] * from[0] + row[1] * from[1] + row[2];
            }
            moved[*number] = mesh_add_texture(mesh, to[0], to[1]);
        }
        *number = moved[*number];
    }
    free(moved);
}

/** Returns whether each material has coordinates, by its number; the caller frees them. */
static bool *find_coordinates(const host_mesh *mesh, const host_materials *materials) {
    bool *has = memory_new(materials->used_count + 1, sizeof *has);
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        has[mesh->materials[i / 3]] = has[mesh->materials[i / 3]] || mesh->triangles[i / 3][i % 3].texture > 0;
    }
    return has;
}

/** Leaves out coordinates that no texture uses; a corner of a textured triangle that has none gets 0 0. */
static void fit_coordinates(host_mesh *mesh, const host_materials *materials) {
    uint32_t origin = 0;
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        const mtl_material *material = materials_find(materials, mesh->materials[i / 3]);
        uint32_t *texture = &mesh->triangles[i / 3][i % 3].texture;
        if (material == NULL || material->texture.made == NULL) {
            *texture = 0;
        } else if (*texture == 0) {
            origin = origin > 0 ? origin : mesh_add_texture(mesh, 0, 0);
            *texture = origin;
        }
    }
}

/** Coordinates and their number, to be sorted. */
typedef struct numbered_point {
    double at[2];
    uint32_t number;
} numbered_point;

static int compare_points(const void *left, const void *right) {
    const numbered_point *a = left;
    const numbered_point *b = right;
    for (int i = 0; i < 2; i++) {
        if (a->at[i] < b->at[i] || a->at[i] > b->at[i]) {
            return a->at[i] < b->at[i] ? -1 : 1;
        }
    }
    return (a->number > b->number) - (a->number < b->number);
}

/** Gives corners of equal coordinates one number, so that no seam is between them. */
static void join_coordinates(host_mesh *mesh) {
    const size_t count = mesh->texture_count;
    numbered_point *points = memory_new(count, sizeof *points);
    uint32_t *first = memory_new(count + 1, sizeof *first);
    for (size_t i = 0; i < count; i++) {
        points[i] = (numbered_point){{mesh->textures[i][0], mesh->textures[i][1]}, (uint32_t)i + 1};
    }
    qsort(points, count, sizeof *points, compare_points);
    for (size_t i = 0; i < count; i++) {
        const bool is_new = i == 0 || points[i].at[0] > points[i - 1].at[0] || points[i].at[1] > points[i - 1].at[1] ||
                            points[i].at[1] < points[i - 1].at[1];
        first[points[i].number] = is_new ? points[i].number : first[points[i - 1].number];
    }
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        uint32_t *texture = &mesh->triangles[i / 3][i % 3].texture;
        *texture = first[*texture];
    }
    free(points);
    free(first);
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

bool textures_load(const char *model, const load_options *options, host_mesh *mesh, host_materials *materials,
                   host_warnings *warnings, host_problem *problem) {
    const char *chosen = options->picture;
    const texture_loader loader = {model, options, mesh, materials, warnings};
    const glint_texture *made = chosen != NULL ? load_chosen(&loader, chosen, problem) : NULL;
    bool *has = find_coordinates(mesh, materials);
    for (uint32_t i = 0; (made != NULL || chosen == NULL) && i < materials->used_count; i++) {
        mtl_texture *texture = &materials->all.list[materials->used[i]].texture;
        if (made != NULL && has[i + 1]) {
            texture->made = made;
        } else if (made == NULL && texture->name != NULL) {
            load_texture(&loader, texture, has[i + 1]);
        }
        if (texture->made != NULL && texture->name != NULL && !is_identity(texture)) {
            transform(mesh, i + 1, texture);
        }
    }
    if (chosen == NULL && materials->bare.name != NULL) {
        load_texture(&loader, &materials->bare, has[0]);
        made = materials->bare.made;
    }
    if (made != NULL && has[0]) {
        paint_bare(&loader, made);
    }
    free(has);
    fit_coordinates(mesh, materials);
    if (materials->texture_count > 0) {
        join_coordinates(mesh);
    }
    return chosen == NULL || made != NULL;
}

size_t textures_size(const host_materials *materials) {
    size_t size = 0;
    for (size_t i = 0; i < materials->texture_count; i++) {
        size += materials->textures[i]->size;
    }
    return size;
}

void textures_print(const host_materials *materials) {
    for (size_t i = 0; i < materials->texture_count; i++) {
        const host_texture *texture = materials->textures[i];
        printf("texture %ux%u %s %zu", texture->texture.width, texture->texture.height,
               texture_type_names[texture->type], texture->size);
        if (texture->error > 0) {
            printf(" %.1f\n", 10 * log10(255.0 * 255.0 / texture->error));
        } else {
            printf(" exact\n");
        }
    }
}

void textures_free(host_materials *materials) {
    for (size_t i = 0; i < materials->texture_count; i++) {
        texture_free(materials->textures[i]);
    }
    for (size_t i = 0; i < materials->picture_count; i++) {
        free(materials->pictures[i].data);
    }
    free(materials->textures);
    free(materials->pictures);
    free(materials->bare.name);
}
