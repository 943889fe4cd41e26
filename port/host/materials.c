/* SPDX-License-Identifier: MIT */
#include "model.h"

#include "basics.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** A kind of what is missing: where it first is, and how often. */
typedef struct missing_names {
    obj_name first;
    size_t count;
    const char *why;
} missing_names;

typedef struct library_loader {
    host_materials *materials;
    const char *folder; /* the model's path... */
    size_t folder_size; /* ...and how much of it is its folder */
    size_t tried;       /* files */
    missing_names outside, unread, many;
} library_loader;

static void miss(missing_names *missing, const char *name, size_t line) {
    if (missing->count++ == 0) {
        missing->first.text = text_copy((text_token){name, strlen(name)});
        missing->first.line = line;
    }
}

/** Turns what is missing into a warning. */
static void warn(missing_names *missing, host_warnings *warnings) {
    if (missing->count == 0 || warnings->count == PROBLEM_WARNINGS_MAX) {
        free(missing->first.text);
        return;
    }
    char quote[PROBLEM_QUOTE_SIZE];
    char more[40] = "";
    if (missing->count > 1) {
        snprintf(more, sizeof more, " (and %zu more)", missing->count - 1);
    }
    problem_set(&warnings->list[warnings->count++], missing->first.line, "warning: '%s' %s%s",
                problem_quote(quote, missing->first.text, strlen(missing->first.text)), missing->why, more);
    free(missing->first.text);
}

/* ---- Files ------------------------------------------------------------------------------------------------------ */

/** Whether a path stays in the folder that it begins in: it is relative, and no part of it is `..`. */
static bool is_inside(const char *path) {
    bool inside = *path != '/';
    for (const char *part = path; inside && part != NULL; part = strchr(part, '/')) {
        part += *part == '/';
        inside = !(part[0] == '.' && part[1] == '.' && (part[2] == '/' || part[2] == '\0'));
    }
    return inside;
}

/** Reads a file of the model's folder. @return false when it cannot be read */
static bool read_library(library_loader *loader, const char *name) {
    const size_t size = loader->folder_size + strlen(name) + 1;
    char *path = memory_new(size, 1);
    memcpy(path, loader->folder, loader->folder_size);
    memcpy(path + loader->folder_size, name, strlen(name) + 1);
    host_bytes file;
    host_problem problem;
    if (!bytes_read_file(&file, path, MTL_FILE_MAX, &problem)) {
        free(path);
        return false;
    }
    host_materials *materials = loader->materials;
    materials->libraries = memory_grow(materials->libraries, &materials->library_capacity, materials->library_count,
                                       sizeof *materials->libraries);
    host_library *library = &materials->libraries[materials->library_count++];
    library->path = path;
    library->hash = bytes_hash(file.data, file.count);
    mtl_read((const char *)file.data, file.count, &materials->all, &library->warnings);
    free(file.data);
    return true;
}

static void load_library(library_loader *loader, const char *name, size_t line) {
    if (loader->tried++ >= OBJ_LIBRARIES_MAX) {
        miss(&loader->many, name, line);
    } else if (!is_inside(name)) {
        miss(&loader->outside, name, line);
    } else if (!read_library(loader, name)) {
        miss(&loader->unread, name, line);
    }
}

/** Reads what one mtllib names: a file whose name may hold blanks or, where there is none, several files. */
static void load_libraries(library_loader *loader, const obj_name *named) {
    if (strpbrk(named->text, " \t") == NULL) {
        load_library(loader, named->text, named->line);
        return;
    }
    if (is_inside(named->text) && read_library(loader, named->text)) {
        return;
    }
    char *names = text_copy((text_token){named->text, strlen(named->text)});
    for (char *name = strtok(names, " \t"); name != NULL && name[0] != '#'; name = strtok(NULL, " \t")) {
        load_library(loader, name, named->line);
    }
    free(names);
}

/* ---- Names ------------------------------------------------------------------------------------------------------ */

/** The place of the material of a name of `length` bytes, or the library's count. */
static size_t find_material(const mtl_library *library, const char *name, size_t length) {
    size_t place = 0;
    while (place < library->count &&
           (strncmp(library->list[place].name, name, length) != 0 || library->list[place].name[length] != '\0')) {
        place++;
    }
    return place;
}

/** The same for a name as it stands in the OBJ file, which a comment may follow. */
static size_t find_named(const mtl_library *library, const char *name) {
    const size_t place = find_material(library, name, strlen(name));
    const char *comment = strstr(name, " #");
    if (place < library->count || comment == NULL) {
        return place;
    }
    size_t length = (size_t)(comment - name);
    while (length > 0 && name[length - 1] == ' ') {
        length--;
    }
    return find_material(library, name, length);
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

void materials_load(const char *model, const obj_materials *named, host_mesh *mesh, host_materials *materials,
                    host_warnings *warnings) {
    library_loader loader = {.materials = materials, .folder = model};
    loader.folder_size = (size_t)(path_base_name(model) - model);
    loader.outside.why = "is skipped: it is not in the model's folder";
    loader.many.why = "is skipped: no more than 64 files of materials are read";
    loader.unread.why = "cannot be read: its materials are missing";
    memset(materials, 0, sizeof *materials);
    for (size_t i = 0; i < named->libraries.count; i++) {
        load_libraries(&loader, &named->libraries.list[i]);
    }
    warn(&loader.outside, warnings);
    warn(&loader.unread, warnings);
    warn(&loader.many, warnings);
    materials_name(named, mesh, materials, warnings);
}

void materials_name(const obj_materials *named, host_mesh *mesh, host_materials *materials, host_warnings *warnings) {
    missing_names unknown = {.why = "is not among the materials: the default one stands"};
    uint32_t *numbers = memory_new(named->used.count + 1, sizeof *numbers);
    materials->used = memory_new(named->used.count, sizeof *materials->used);
    for (size_t i = 0; i < named->used.count; i++) {
        const size_t place = find_named(&materials->all, named->used.list[i].text);
        if (place < materials->all.count) {
            numbers[i + 1] = use_material(materials, place);
        } else {
            miss(&unknown, named->used.list[i].text, named->used.list[i].line);
        }
    }
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        mesh->materials[i] = numbers[mesh->materials[i]];
    }
    free(numbers);
    warn(&unknown, warnings);
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
    free(materials->used);
    mtl_free(&materials->all);
    memset(materials, 0, sizeof *materials);
}
