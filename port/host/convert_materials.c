/* SPDX-License-Identifier: MIT */
/**
 * @file convert_materials.c
 * A header's materials and objects, and the names that these give to its arrays.
 */
#include "convert.h"

#include "memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Characters that are kept of a material's name. */
#define NAME_KEPT 40

char convert_plain(char c) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    return (char)(plain ? c : '_');
}

/* ---- Names ------------------------------------------------------------------------------------------------------ */

/** Whether another piece has a piece's material. */
static bool shares_material(const quantised_mesh *mesh, size_t piece) {
    const uint32_t material = mesh->materials[piece];
    return (piece > 0 && mesh->materials[piece - 1] == material) ||
           (piece + 1 < mesh->piece_count && mesh->materials[piece + 1] == material);
}

static bool is_taken(const header_suffix *suffixes, size_t count) {
    for (size_t i = 0; i < count; i++) {
        if (strcmp(suffixes[i].text, suffixes[count].text) == 0) {
            return true;
        }
    }
    return false;
}

/** Names a piece by its material; with a number from 2 on where an earlier piece has that name. */
static void name_piece(const char *material, bool counted, header_suffix *suffixes, size_t piece) {
    char base[NAME_KEPT + 16];
    size_t length = 0;
    for (const char *letter = material; *letter != '\0' && length < NAME_KEPT; letter++) {
        base[length++] = convert_plain(*letter);
    }
    base[length] = '\0';
    char *suffix = suffixes[piece].text;
    const size_t size = sizeof suffixes[piece].text;
    snprintf(suffix, size, counted ? "_%s_1" : "_%s", base);
    for (unsigned number = 2; is_taken(suffixes, piece); number++) {
        snprintf(suffix, size, "_%s_%u", base, number);
    }
}

header_suffix *convert_suffixes(const host_materials *materials, const quantised_mesh *mesh) {
    header_suffix *suffixes = memory_new(mesh->piece_count, sizeof *suffixes);
    for (size_t i = 0; i < mesh->piece_count; i++) {
        const mtl_material *material = materials_find(materials, mesh->materials[i]);
        if (materials->used_count > 0) {
            name_piece(material != NULL ? material->name : "default", shares_material(mesh, i), suffixes, i);
        } else if (mesh->piece_count > 1) {
            snprintf(suffixes[i].text, sizeof suffixes[i].text, "_%u", (unsigned)i);
        }
    }
    return suffixes;
}

/* ---- Materials and objects -------------------------------------------------------------------------------------- */

static const char *model_name(const glint_shading_model *model) {
    return model == &glint_model_lambert ? "lambert" : model == &glint_model_unlit ? "unlit" : "blinn_phong";
}

static void print_colour(host_bytes *out, glint_colour colour, const char *what) {
    bytes_print(out, "    {%ld, %ld, %ld}, /* %s */\n", (long)colour.r, (long)colour.g, (long)colour.b, what);
}

static void print_material(const convert_names *names, const char *suffix, const glint_material *material) {
    host_bytes *out = names->out;
    bytes_print(out, "\n%s glint_material %s_material%s = {\n    &glint_model_%s,\n", names->storage, names->name,
                suffix, model_name(material->model));
    print_colour(out, material->ambient, "ambient");
    print_colour(out, material->diffuse, "diffuse");
    print_colour(out, material->specular, "specular");
    bytes_print(out, "    %ld, /* shininess */\n    0,\n};\n", (long)material->shininess);
}

/** The first piece of each material, by its number. @return the caller frees them */
static size_t *first_pieces(const host_materials *materials, const quantised_mesh *mesh) {
    size_t *first = memory_new(materials->used_count + 1, sizeof *first);
    for (size_t i = mesh->piece_count; i-- > 0;) {
        first[mesh->materials[i]] = i;
    }
    return first;
}

void convert_objects(const convert_names *names, const host_settings *settings, const host_materials *materials,
                     const quantised_mesh *mesh) {
    host_bytes *out = names->out;
    const header_suffix *suffixes = names->suffixes;
    size_t *first = first_pieces(materials, mesh);
    bytes_print(out, "\n/* Materials: Q16.16, for ambient light of 1 in the scene. */\n");
    for (size_t i = 0; i < mesh->piece_count; i++) {
        if (first[mesh->materials[i]] == i) {
            const glint_material material = settings_material(settings, materials_find(materials, mesh->materials[i]));
            print_material(names, suffixes[i].text, &material);
        }
    }
    bytes_print(out,
                "\n/* Objects of one scene, all with the same pose: copy them where they move. */\n"
                "%s glint_object %s_objects[%zu] = {\n",
                names->storage, names->name, mesh->piece_count);
    for (size_t i = 0; i < mesh->piece_count; i++) {
        const char *material = suffixes[first[mesh->materials[i]]].text;
        bytes_print(out,
                    "    {&%s_mesh%s, &%s_material%s, {{{65536, 0, 0, 0}, {0, 65536, 0, 0}, {0, 0, 65536, 0}}}, "
                    "&glint_per_fragment, 0},\n",
                    names->name, suffixes[i].text, names->name, material);
    }
    bytes_print(out, "};\n");
    free(first);
}

/* ---- A source and its header ------------------------------------------------------------------------------------ */

/** Declares each piece's mesh, each material, and the objects. */
static void declare_painted(const convert_names *names, const host_materials *materials, const quantised_mesh *mesh) {
    size_t *first = first_pieces(materials, mesh);
    for (size_t i = 0; i < mesh->piece_count; i++) {
        bytes_print(names->out, "%s glint_mesh %s_mesh%s;\n", names->storage, names->name, names->suffixes[i].text);
    }
    for (size_t i = 0; i < mesh->piece_count; i++) {
        if (first[mesh->materials[i]] == i) {
            bytes_print(names->out, "%s glint_material %s_material%s;\n", names->storage, names->name,
                        names->suffixes[i].text);
        }
    }
    bytes_print(names->out,
                "%s glint_object %s_objects[%zu]; /* all with the same pose: copy them where they move */\n",
                names->storage, names->name, mesh->piece_count);
    free(first);
}

void convert_declarations(const convert_names *names, const host_materials *materials, const quantised_mesh *mesh) {
    bytes_print(names->out, "\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
    if (materials->used_count > 0) {
        declare_painted(names, materials, mesh);
    } else if (mesh->piece_count > 1) {
        bytes_print(names->out, "%s glint_mesh %s_meshes[%zu]; /* one object for each */\n", names->storage,
                    names->name, mesh->piece_count);
    } else {
        bytes_print(names->out, "%s glint_mesh %s_mesh;\n", names->storage, names->name);
    }
    bytes_print(names->out, "\n#ifdef __cplusplus\n}\n#endif\n");
}

bool convert_is_pair(const char *output) {
    const size_t length = output != NULL ? strlen(path_base_name(output)) : 0;
    return length > 2 && strcmp(path_base_name(output) + length - 2, ".c") == 0;
}

char *convert_header_of(const char *source) {
    const size_t length = strlen(source);
    char *header = memory_new(length + 1, 1);
    strcpy(header, source);
    header[length - 1] = 'h';
    return header;
}

bool convert_check_pair(const host_settings *settings) {
    host_problem problem;
    if (!convert_is_pair(settings->output)) {
        return true;
    }
    for (const char *letter = path_base_name(settings->output); *letter != '\0'; letter++) {
        if ((unsigned char)*letter < ' ' || *letter == '"' || *letter == '\\') {
            problem_set(&problem, 0,
                        "cannot be written: #include of its header takes no quotes, backslashes or control characters");
            problem_print(settings->output, &problem);
            return false;
        }
    }
    char *header = convert_header_of(settings->output);
    const bool is_model = path_is_same_file(settings->model, header);
    if (is_model) {
        problem_set(&problem, 0, "cannot be written: it is the model");
        problem_print(header, &problem);
    }
    free(header);
    return !is_model;
}
