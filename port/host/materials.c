/* SPDX-License-Identifier: MIT */
#include "model.h"

#include "basics.h"

#include <stdlib.h>
#include <string.h>

/** Kinds of notes on names that lead to nothing. */
enum { KIND_OUTSIDE = TEXT_KINDS, KIND_UNREAD, KIND_UTF16, KIND_MANY, KIND_UNKNOWN };

static const char *const note_texts[] = {
    [KIND_OUTSIDE] = "is skipped: it is not in the model's folder",
    [KIND_UNREAD] = "cannot be read: its materials are missing",
    [KIND_UTF16] = "is text in UTF-16, and is skipped: save it as UTF-8 or ASCII",
    [KIND_MANY] = "is skipped: no more than 64 files of materials are read",
    [KIND_UNKNOWN] = "is not among the materials: the default one stands",
};

typedef struct library_loader {
    host_materials *materials;
    const char *folder; /* the model's path... */
    size_t folder_size; /* ...and how much of it is its folder */
    size_t tried;       /* files */
    text_notes notes;
} library_loader;

static text_token token_of(const char *name) {
    const text_token token = {name, strlen(name)};
    return token;
}

/* ---- Files ------------------------------------------------------------------------------------------------------ */

bool path_is_inside(const char *path) {
    bool inside = *path != '/';
    for (const char *part = path; inside && part != NULL; part = strchr(part, '/')) {
        part += *part == '/';
        inside = !(part[0] == '.' && part[1] == '.' && (part[2] == '/' || part[2] == '\0'));
    }
    return inside;
}

static bool is_utf16(const host_bytes *file) {
    return file->count >= 2 && (memcmp(file->data, "\xFF\xFE", 2) == 0 || memcmp(file->data, "\xFE\xFF", 2) == 0);
}

/** Reads a file of the model's folder. @return 0, or the kind of a note */
static int read_file(library_loader *loader, text_token name) {
    char *path = memory_new(loader->folder_size + name.length + 1, 1);
    memcpy(path, loader->folder, loader->folder_size);
    memcpy(path + loader->folder_size, name.start, name.length);
    host_bytes file;
    host_problem problem;
    const bool inside = path_is_inside(path + loader->folder_size);
    if (!inside || !bytes_read_file(&file, path, MTL_FILE_MAX, &problem)) {
        free(path);
        return inside ? KIND_UNREAD : KIND_OUTSIDE;
    }
    if (is_utf16(&file)) {
        free(file.data);
        free(path);
        return KIND_UTF16;
    }
    host_materials *materials = loader->materials;
    materials->libraries = memory_grow(materials->libraries, &materials->library_capacity, materials->library_count,
                                       sizeof *materials->libraries);
    host_library *library = &materials->libraries[materials->library_count++];
    library->path = path;
    library->hash = bytes_hash(file.data, file.count);
    library->warnings.count = 0;
    const size_t before = materials->all.count;
    mtl_read((const char *)file.data, file.count, &materials->all, &library->warnings);
    for (size_t i = before; i < materials->all.count; i++) {
        materials->all.list[i].texture.library = materials->library_count;
    }
    free(file.data);
    return 0;
}

/**
 * Reads a file by its name as it stands or else as other systems write paths: with backslashes; or with folders of the
 * machine where it was written, in place of which the model's is taken.
 * @param may_be_several whether the name may be several, which the last folder would hide
 * @return 0, or the kind of a note
 */
static int read_library(library_loader *loader, text_token name, bool may_be_several) {
    int kind = read_file(loader, name);
    if (kind == KIND_UTF16 || kind == 0) {
        return kind;
    }
    char *path = text_copy(name);
    for (char *at = strchr(path, '\\'); at != NULL; at = strchr(at, '\\')) {
        *at = '/';
    }
    const char *base = path_base_name(path);
    const bool read = read_file(loader, token_of(path)) == 0 ||
                      (!may_be_several && base != path && *base != '\0' && read_file(loader, token_of(base)) == 0);
    free(path);
    return read ? 0 : kind;
}

static void load_library(library_loader *loader, text_token name, size_t line) {
    const int kind = loader->tried++ < OBJ_LIBRARIES_MAX ? read_library(loader, name, false) : KIND_MANY;
    if (kind != 0) {
        text_note_add(&loader->notes, kind, name, line);
    }
}

/** Reads what one mtllib names: a file whose name may hold blanks or, where there is none, several files. */
static void load_libraries(library_loader *loader, const obj_name *named) {
    text_reader names = text_begin(named->text, strlen(named->text));
    text_token name = token_of(named->text);
    if (strpbrk(named->text, " \t") == NULL) {
        load_library(loader, name, named->line);
    } else if (read_library(loader, name, true) != 0) {
        while (text_next_token(&names, &name)) {
            load_library(loader, name, named->line);
        }
    }
}

/* ---- Names ------------------------------------------------------------------------------------------------------ */

/** Returns the index of the material of a name, or the library's count. */
static size_t find_material(const mtl_library *library, text_token name) {
    size_t place = 0;
    while (place < library->count && !text_token_is(name, library->list[place].name)) {
        place++;
    }
    return place;
}

/** The same for a name as it stands in the OBJ file, which a comment may follow. */
static size_t find_named(const mtl_library *library, const char *name) {
    text_token token = token_of(name);
    const size_t place = find_material(library, token);
    const char *comment = strstr(name, " #");
    if (place < library->count || comment == NULL) {
        return place;
    }
    token.length = (size_t)(comment - name);
    while (token.length > 0 && name[token.length - 1] == ' ') {
        token.length--;
    }
    return find_material(library, token);
}

/** The number of a material, one more than its place among those that are used; it is added when it is new. */
static uint32_t use_material(host_materials *materials, size_t place) {
    size_t i = 0;
    while (i < materials->used_count && materials->used[i] != place) {
        i++;
    }
    if (i == materials->used_count) {
        materials->used[materials->used_count++] = place;
    }
    return (uint32_t)i + 1;
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

void materials_load(const char *model, obj_materials *named, host_mesh *mesh, host_materials *materials,
                    host_warnings *warnings) {
    library_loader loader = {.materials = materials, .folder = model};
    loader.folder_size = (size_t)(path_base_name(model) - model);
    memset(materials, 0, sizeof *materials);
    for (size_t i = 0; i < named->libraries.count; i++) {
        load_libraries(&loader, &named->libraries.list[i]);
    }
    text_notes_write(&loader.notes, note_texts, warnings);
    materials_name(named, mesh, materials, warnings);
}

void materials_name(obj_materials *named, host_mesh *mesh, host_materials *materials, host_warnings *warnings) {
    text_notes notes = {.count = 0};
    uint32_t *numbers = memory_new(named->used.count + 1, sizeof *numbers);
    materials->used = memory_new(named->used.count, sizeof *materials->used);
    materials->objects = named->objects;
    memset(&named->objects, 0, sizeof named->objects);
    for (size_t i = 0; i < named->used.count; i++) {
        const obj_name *name = &named->used.list[i];
        const size_t place = find_named(&materials->all, name->text);
        if (place < materials->all.count) {
            numbers[i + 1] = use_material(materials, place);
        } else {
            text_note_add(&notes, KIND_UNKNOWN, token_of(name->text), name->line);
        }
    }
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        mesh->materials[i] = numbers[mesh->materials[i]];
    }
    free(numbers);
    text_notes_write(&notes, note_texts, warnings);
}

const mtl_material *materials_find(const host_materials *materials, uint32_t number) {
    return number > 0 ? &materials->all.list[materials->used[number - 1]] : NULL;
}

void materials_print_warnings(const host_materials *materials) {
    for (size_t i = 0; i < materials->library_count; i++) {
        problem_print_warnings(materials->libraries[i].path, &materials->libraries[i].warnings);
    }
}

void materials_free(host_materials *materials) {
    for (size_t i = 0; i < materials->library_count; i++) {
        free(materials->libraries[i].path);
    }
    free(materials->libraries);
    textures_free(materials);
    obj_names_free(&materials->objects);
    free(materials->used);
    mtl_free(&materials->all);
    memset(materials, 0, sizeof *materials);
}
