/* SPDX-License-Identifier: MIT */
/**
 * @file convert.c
 * What the converter writes: a header, or a source and its header.
 */
#include "command.h"

#include "basics.h"
#include "values.h"
#include "view.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Part of a mesh's side by which positions may move unsaid: a quarter of a pixel of 1024, the largest display. */
#define STEP_MAX (1.0 / 4096.0)

/** Characters that are kept of a material's name. */
#define NAME_KEPT 40

/** A part of an identifier: 40 characters of a material's or an object's name, and two numbers. */
typedef struct header_suffix {
    char text[64];
} header_suffix;

typedef struct header_writer {
    host_bytes *out;
    const host_settings *settings;
    const quantised_mesh *mesh;
    const host_materials *materials;
    const char *storage;           /* of meshes, materials and objects */
    const header_suffix *suffixes; /* a piece each */
    const header_suffix *paints;   /* a material each, by its number */
    const glint_camera *camera;    /* that sees it all; null where none is asked for */
    char name[CONVERT_NAME_SIZE];
} header_writer;

/** Replaces a character that is no letter, digit or underscore by an underscore. */
static char plain_character(char c) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    return (char)(plain ? c : '_');
}

/* ---- Names ------------------------------------------------------------------------------------------------------ */

static bool is_taken(const header_suffix *suffixes, size_t count) {
    for (size_t i = 0; i < count; i++) {
        if (strcmp(suffixes[i].text, suffixes[count].text) == 0) {
            return true;
        }
    }
    return false;
}

/** Makes a suffix of a name, with a number where the name is `counted` or an earlier suffix equals it. */
static void make_suffix(const char *name, bool counted, header_suffix *suffixes, size_t place) {
    char base[NAME_KEPT + 16];
    size_t length = 0;
    for (const char *letter = name; *letter != '\0' && length < NAME_KEPT; letter++) {
        base[length++] = plain_character(*letter);
    }
    base[length] = '\0';
    char *suffix = suffixes[place].text;
    const size_t size = sizeof suffixes[place].text;
    snprintf(suffix, size, counted ? "_%s_1" : "_%s", base);
    for (unsigned number = 2; is_taken(suffixes, place); number++) {
        snprintf(suffix, size, "_%s_%u", base, number);
    }
}

static const char *material_name(const host_materials *materials, uint32_t number) {
    const mtl_material *material = materials_find(materials, number);
    return material != NULL ? material->name : "default";
}

static const char *object_name(const host_materials *materials, uint32_t number) {
    return number > 0 && materials->objects.list[number - 1].text[0] != '\0' ? materials->objects.list[number - 1].text
                                                                             : "default";
}

static bool is_same_part(const quantised_mesh *mesh, size_t a, size_t b) {
    return a < mesh->piece_count && b < mesh->piece_count && mesh->materials[a] == mesh->materials[b] &&
           (mesh->objects == NULL || mesh->objects[a] == mesh->objects[b]);
}

static bool is_same_object(const quantised_mesh *mesh, size_t a, size_t b) {
    return a < mesh->piece_count && b < mesh->piece_count && mesh->objects[a] == mesh->objects[b];
}

/** Returns whether the mesh is written as objects with materials, not as meshes alone. */
static bool has_objects(const host_materials *materials, const quantised_mesh *mesh) {
    return materials->used_count > 0 || mesh->objects != NULL;
}

/**
 * Makes a suffix for each piece: its number where there are several, empty for one; the name of its material where
 * there are materials, and of its object where objects stay apart, with the material's where that object has several.
 * @return the caller frees them
 */
static header_suffix *find_suffixes(const host_materials *materials, const quantised_mesh *mesh) {
    header_suffix *suffixes = memory_new(mesh->piece_count, sizeof *suffixes);
    for (size_t i = 0; i < mesh->piece_count; i++) {
        const char *material = material_name(materials, mesh->materials[i]);
        const bool counted = is_same_part(mesh, i, i - 1) || is_same_part(mesh, i, i + 1);
        char name[2 * NAME_KEPT];
        if (mesh->objects != NULL) {
            const bool alone = !is_same_object(mesh, i, i - 1) && !is_same_object(mesh, i, i + 1);
            snprintf(name, sizeof name, "%.*s%s%s", NAME_KEPT, object_name(materials, mesh->objects[i]),
                     alone ? "" : "_", alone ? "" : material);
            make_suffix(name, counted, suffixes, i);
        } else if (materials->used_count > 0) {
            make_suffix(material, counted, suffixes, i);
        } else if (mesh->piece_count > 1) {
            snprintf(suffixes[i].text, sizeof suffixes[i].text, "_%u", (unsigned)i);
        }
    }
    return suffixes;
}

/** Returns the first piece of a material, or the number of pieces if no piece has it. */
static size_t first_piece(const quantised_mesh *mesh, size_t material) {
    size_t piece = 0;
    while (piece < mesh->piece_count && mesh->materials[piece] != material) {
        piece++;
    }
    return piece;
}

/** Makes a suffix for each material: that of its first piece or, with --objects, its own; the caller frees them. */
static header_suffix *find_paints(const host_materials *materials, const quantised_mesh *mesh,
                                  const header_suffix *suffixes) {
    header_suffix *paints = memory_new(materials->used_count + 1, sizeof *paints);
    for (size_t i = 0; i <= materials->used_count; i++) {
        const size_t first = first_piece(mesh, i);
        if (first < mesh->piece_count && mesh->objects != NULL) {
            make_suffix(material_name(materials, (uint32_t)i), false, paints, i);
        } else if (first < mesh->piece_count) {
            paints[i] = suffixes[first];
        }
    }
    return paints;
}

/* ---- The head --------------------------------------------------------------------------------------------------- */

/** Says whether an output's name asks for a source and its header: it ends with .c. False for null. */
static bool is_pair(const char *output) {
    const size_t length = output != NULL ? strlen(path_base_name(output)) : 0;
    return length > 2 && strcmp(path_base_name(output) + length - 2, ".c") == 0;
}

/** The header's name of a source's. @return the caller frees it */
static char *header_of(const char *source) {
    const size_t length = strlen(source);
    char *header = memory_new(length + 1, 1);
    strcpy(header, source);
    header[length - 1] = 'h';
    return header;
}

/** Says whether a pair can have the names that it would; says why not. True for what is no pair. */
static bool check_pair(const host_settings *settings) {
    host_problem problem;
    if (!is_pair(settings->output)) {
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
    char *header = header_of(settings->output);
    const bool is_model = path_is_same_file(settings->model, header);
    if (is_model) {
        problem_set(&problem, 0, "cannot be written: it is the model");
        problem_print(header, &problem);
    }
    free(header);
    return !is_model;
}

static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

void convert_name(const char *path, char name[CONVERT_NAME_SIZE]) {
    const char *base = path_base_name(path);
    const char *dot = strrchr(base, '.');
    const size_t length = dot != NULL && dot > base ? (size_t)(dot - base) : strlen(base);
    size_t used = 0;
    if (!is_letter(base[0])) {
        name[used++] = 'm'; /* identifiers begin with a letter */
    }
    for (size_t i = 0; i < length && i < CONVERT_NAME_SIZE - 2; i++) {
        name[used++] = plain_character(base[i]);
    }
    name[used] = '\0';
}

/**
 * Returns --name, or else the name of the written file, so that one program can include two conversions of a model. If
 * that file is a device, the model's name is used.
 */
static void choose_name(const host_settings *settings, char name[CONVERT_NAME_SIZE]) {
    if (settings->name != NULL) {
        strcpy(name, settings->name);
    } else if (settings->output == NULL || path_is_stdout(settings->output) ||
               strncmp(settings->output, "/dev/", 5) == 0) {
        convert_name(settings->model, name);
    } else {
        convert_name(settings->output, name);
    }
}

/** Text that cannot end a comment, open one, or leave its line. */
static void print_in_comment(host_bytes *out, const char *text) {
    for (; *text != '\0'; text++) {
        bytes_add(out, (uint8_t)(*text < ' ' || *text > '~' || *text == '*' || *text == '\\' ? '_' : *text));
    }
}

/** Prints text of a comment as a word of a shell, with quotes where it needs them. */
static void print_word(host_bytes *out, const char *word) {
    const bool plain = word[0] != '\0' && word[strcspn(word, " \t()'\"$&;<>|`")] == '\0';
    bytes_print(out, plain ? " " : " \"");
    print_in_comment(out, word);
    bytes_print(out, plain ? "" : "\"");
}

/**
 * Prints the model without its folder, and the options as they were given. -o is printed only if it changes the bytes:
 * if the arrays have the file's name and the model has another one, and for a pair, whose source names its header.
 */
static void print_command_line(const header_writer *writer) {
    const host_settings *settings = writer->settings;
    char name[CONVERT_NAME_SIZE];
    bytes_print(writer->out, "glint convert");
    print_word(writer->out, path_base_name(settings->model));
    for (int i = 0; i < settings->argument_count; i++) {
        const char *word = settings->arguments[i];
        if (strcmp(word, "-o") == 0) {
            i++;
        } else if (word != settings->model && strncmp(word, "-o=", 3) != 0) {
            print_word(writer->out, word);
        }
    }
    convert_name(settings->model, name);
    if (is_pair(settings->output) || (settings->name == NULL && strcmp(name, writer->name) != 0)) {
        bytes_print(writer->out, " -o");
        print_word(writer->out, path_base_name(settings->output));
    }
}

static bool have_clusters(const quantised_mesh *mesh) {
    bool have = false;
    for (size_t i = 0; i < mesh->piece_count; i++) {
        have = have || mesh->pieces[i].clusters != NULL;
    }
    return have;
}

static void print_head(const header_writer *writer, const host_model *model, const quantised_mesh *mesh) {
    host_bytes *out = writer->out;
    if (writer->settings->licence != NULL) {
        bytes_print(out, "/* SPDX-License-Identifier: %s */\n", writer->settings->licence);
    }
    bytes_print(out, "/*\n * ");
    print_in_comment(out, path_base_name(writer->settings->model));
    bytes_print(out, ": %zu vertices, %zu triangles, %zu bytes of flash. Generated, not to be edited, by\n *     ",
                mesh->vertex_count, mesh->triangle_count, quantised_size(mesh) + textures_size(&model->materials));
    print_command_line(writer);
    bytes_print(out, "\n * from a source whose FNV-1a hash (64 bits) is %016llx.\n", (unsigned long long)model->hash);
    if (writer->settings->load.simplify > 0) {
        bytes_print(out, " * Simplified from %zu triangles: geometric error %.3g, in units of the source.\n",
                    model->read_count, model->error);
    }
    for (size_t i = 0; i < model->materials.library_count; i++) {
        bytes_print(out, " * Also read: ");
        print_in_comment(out, path_base_name(model->materials.libraries[i].path));
        bytes_print(out, ", whose hash is %016llx.\n", (unsigned long long)model->materials.libraries[i].hash);
    }
    for (size_t i = 0; i < model->materials.texture_count; i++) {
        if (model->materials.textures[i]->picture > 0) {
            continue; /* it is a part of the model */
        }
        bytes_print(out, " * Also read: ");
        print_in_comment(out, path_base_name(model->materials.textures[i]->name));
        bytes_print(out, ", whose hash is %016llx.\n", (unsigned long long)model->materials.textures[i]->hash);
    }
    bytes_print(out, " *\n");
    static const char *const positions[] = {"int16 steps:", "int8, 256 steps each:"};
    static const char *const normals[] = {"int16, Q15, unit length: 32767 is 1", "two int8, octahedral: see glint.h",
                                          "two int16, octahedral: see glint.h"};
    bytes_print(out,
                " * positions  %s object space is offset + extent * step / 32768, per axis\n"
                " * normals    %s\n"
                " * triangles  %s indices, counter-clockwise seen from outside\n"
                " * offset     Q16.16, where step 0 lies\n"
                " * extent     Q16.16, the length of 32768 steps\n%s%s%s */\n",
                positions[mesh->types.positions], normals[mesh->types.normals],
                mesh->types.indices == QUANTISE_INDICES_16 ? "uint16" : "uint8 up to 256 vertices, else uint16",
                mesh->pieces[0].colours != NULL ? " * colours    uint8 red, green, blue: 255 is 1\n" : "",
                model->materials.texture_count > 0 ? " * uv         int16 steps of u and v, v from the top\n" : "",
                have_clusters(mesh) ? " * clusters   triangles that face much the same way, and vertices; see glint.h\n"
                                      " * borrowers  uint16 numbers of clusters that look at a cluster's vertices\n"
                                    : "");
}

static void print_guard(const header_writer *writer, const char *directive) {
    bytes_print(writer->out, "%s ", directive);
    for (const char *c = writer->name; *c != '\0'; c++) {
        bytes_add(writer->out, (uint8_t)(*c >= 'a' && *c <= 'z' ? *c - 'a' + 'A' : *c));
    }
    bytes_print(writer->out, "_MESH_H\n");
}

/* ---- Arrays ----------------------------------------------------------------------------------------------------- */

/** Begins a row of 6 items, or goes on with one. */
static void print_gap(const header_writer *writer, size_t item) {
    bytes_print(writer->out, item % 6 == 0 ? "\n    " : " ");
}

/** Prints an array of triples or pairs. */
static void print_numbers(const header_writer *writer, const char *type, const char *what, const char *suffix,
                          const int16_t (*items)[3], size_t count, int divisor) {
    bytes_print(writer->out, "\nstatic const %s %s_%s%s[%zu][3] = {", type, writer->name, what, suffix, count);
    for (size_t i = 0; i < count; i++) {
        print_gap(writer, i);
        bytes_print(writer->out, "{%d, %d, %d},", items[i][0] / divisor, items[i][1] / divisor, items[i][2] / divisor);
    }
    bytes_print(writer->out, "\n};\n");
}

static void print_codes(const header_writer *writer, const char *suffix, const int16_t (*normals)[3], size_t count) {
    bytes_print(writer->out, "\nstatic const %s %s_normals%s[%zu][2] = {",
                writer->mesh->types.normals == QUANTISE_NORMALS_OCTAHEDRAL ? "int8_t" : "int16_t", writer->name, suffix,
                count);
    for (size_t i = 0; i < count; i++) {
        int code[2];
        quantised_code(writer->mesh, normals[i], code);
        print_gap(writer, i);
        bytes_print(writer->out, "{%d, %d},", code[0], code[1]);
    }
    bytes_print(writer->out, "\n};\n");
}

static bool has_layout(const header_writer *writer, const glint_mesh *mesh) {
    const quantise_types *types = &writer->mesh->types;
    return types->positions != QUANTISE_POSITIONS_INT16 || types->normals != QUANTISE_NORMALS_INT16 ||
           quantised_small_indices(writer->mesh, mesh);
}

static bool has_layouts(const header_writer *writer) {
    bool have = false;
    for (size_t i = 0; i < writer->mesh->piece_count; i++) {
        have = have || has_layout(writer, &writer->mesh->pieces[i]);
    }
    return have;
}

/** One attribute of a layout: none where the mesh has the array. */
static void print_attribute(const header_writer *writer, bool is_array, const char *type, const char *what,
                            const char *suffix) {
    if (is_array) {
        bytes_print(writer->out, "    {0, 0, 0}, /* %s */\n", what);
    } else {
        bytes_print(writer->out, "    {&glint_attribute_%s, %s_%s%s, 0},\n", type, writer->name, what, suffix);
    }
}

static void print_layout(const header_writer *writer, const glint_mesh *mesh, const char *suffix) {
    const quantise_types *types = &writer->mesh->types;
    bytes_print(writer->out, "\nstatic const glint_mesh_layout %s_layout%s = {\n", writer->name, suffix);
    print_attribute(writer, types->positions == QUANTISE_POSITIONS_INT16, "int8", "positions", suffix);
    print_attribute(writer, types->normals == QUANTISE_NORMALS_INT16,
                    types->normals == QUANTISE_NORMALS_OCTAHEDRAL ? "octahedral8" : "octahedral16", "normals", suffix);
    print_attribute(writer, !quantised_small_indices(writer->mesh, mesh), "uint8", "triangles", suffix);
    bytes_print(writer->out, "    {0, 0, 0}, /* colours */\n};\n");
}

static void print_colours(const header_writer *writer, const glint_mesh *mesh, const char *suffix) {
    bytes_print(writer->out, "\nstatic const uint8_t %s_colours%s[%lu][3] = {", writer->name, suffix,
                (unsigned long)mesh->vertex_count);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        print_gap(writer, i);
        bytes_print(writer->out, "{%u, %u, %u},", mesh->colours[i][0], mesh->colours[i][1], mesh->colours[i][2]);
    }
    bytes_print(writer->out, "\n};\n");
}

static void print_clusters(const header_writer *writer, const glint_clusters *clusters, const char *suffix) {
    const char *name = writer->name;
    const uint32_t borrowers = quantised_borrowers(clusters);
    bytes_print(writer->out, "\nstatic const glint_cluster %s_cluster_list%s[%lu] = {", name, suffix,
                (unsigned long)clusters->count);
    for (uint32_t i = 0; i < clusters->count; i++) {
        const glint_cluster *cluster = &clusters->list[i];
        bytes_print(writer->out, i % 4 == 0 ? "\n    " : " ");
        bytes_print(writer->out, "{{%d, %d, %d}, %u, %d, %u, %u, %u},", cluster->axis[0], cluster->axis[1],
                    cluster->axis[2], cluster->spread, cluster->height, cluster->triangles, cluster->vertices,
                    cluster->borrowers);
    }
    bytes_print(writer->out, "\n};\n\nstatic const uint16_t %s_borrowers%s[%lu] = {", name, suffix,
                (unsigned long)(borrowers > 0 ? borrowers : 1));
    for (uint32_t i = 0; i < borrowers; i++) {
        bytes_print(writer->out, i % 20 == 0 ? "\n    " : " ");
        bytes_print(writer->out, "%u,", clusters->borrowers[i]);
    }
    bytes_print(writer->out, borrowers > 0 ? "\n};\n" : "\n    0, /* none */\n};\n");
    bytes_print(
        writer->out,
        "\nstatic const glint_clusters %s_clusters%s = {&glint_cull_cones, %s_cluster_list%s, %s_borrowers%s, %luu};\n",
        name, suffix, name, suffix, name, suffix, (unsigned long)clusters->count);
}

static void print_coordinates(const header_writer *writer, const glint_mesh *mesh, const char *suffix) {
    bytes_print(writer->out, "\nstatic const int16_t %s_uv%s[%lu][2] = {", writer->name, suffix,
                (unsigned long)mesh->vertex_count);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        print_gap(writer, i);
        bytes_print(writer->out, "{%d, %d},", mesh->texture_coordinates[i][0], mesh->texture_coordinates[i][1]);
    }
    bytes_print(writer->out, "\n};\n");
}

static void print_arrays(const header_writer *writer, const glint_mesh *mesh, const char *suffix) {
    const quantise_types *types = &writer->mesh->types;
    const bool is_small = types->positions == QUANTISE_POSITIONS_INT8;
    print_numbers(writer, is_small ? "int8_t" : "int16_t", "positions", suffix, mesh->positions, mesh->vertex_count,
                  is_small ? 256 : 1);
    if (types->normals == QUANTISE_NORMALS_INT16) {
        print_numbers(writer, "int16_t", "normals", suffix, mesh->normals, mesh->vertex_count, 1);
    } else {
        print_codes(writer, suffix, mesh->normals, mesh->vertex_count);
    }
    if (mesh->colours != NULL) {
        print_colours(writer, mesh, suffix);
    }
    if (mesh->texture_coordinates != NULL) {
        print_coordinates(writer, mesh, suffix);
    }
    bytes_print(writer->out, "\nstatic const %s %s_triangles%s[%lu][3] = {",
                quantised_small_indices(writer->mesh, mesh) ? "uint8_t" : "uint16_t", writer->name, suffix,
                (unsigned long)mesh->triangle_count);
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        print_gap(writer, i);
        bytes_print(writer->out, "{%u, %u, %u},", mesh->triangles[i][0], mesh->triangles[i][1], mesh->triangles[i][2]);
    }
    bytes_print(writer->out, "\n};\n");
    if (mesh->clusters != NULL) {
        print_clusters(writer, mesh->clusters, suffix);
    }
    if (has_layout(writer, mesh)) {
        print_layout(writer, mesh, suffix);
    }
}

/** An array of the mesh, or null where the layout has it. */
static void print_array_of(const header_writer *writer, bool is_array, const char *what, const char *suffix) {
    if (is_array) {
        bytes_print(writer->out, "    %s_%s%s,\n", writer->name, what, suffix);
    } else {
        bytes_print(writer->out, "    0, /* %s: as the layout has them */\n", what);
    }
}

static void print_mesh(const header_writer *writer, const glint_mesh *mesh, const char *suffix) {
    const char *name = writer->name;
    print_array_of(writer, writer->mesh->types.positions == QUANTISE_POSITIONS_INT16, "positions", suffix);
    print_array_of(writer, writer->mesh->types.normals == QUANTISE_NORMALS_INT16, "normals", suffix);
    print_array_of(writer, !quantised_small_indices(writer->mesh, mesh), "triangles", suffix);
    bytes_print(writer->out, "    %luu, /* vertices */\n    %luu, /* triangles */\n", (unsigned long)mesh->vertex_count,
                (unsigned long)mesh->triangle_count);
    bytes_print(writer->out, "    {%ld, %ld, %ld}, /* offset */\n", (long)mesh->offset.x, (long)mesh->offset.y,
                (long)mesh->offset.z);
    bytes_print(writer->out, "    {%ld, %ld, %ld}, /* extent */\n", (long)mesh->extent.x, (long)mesh->extent.y,
                (long)mesh->extent.z);
    bytes_print(writer->out, "    %s,\n", mesh->flags != 0 ? "GLINT_MESH_DOUBLE_SIDED" : "0");
    if (mesh->colours != NULL) {
        bytes_print(writer->out, "    %s_colours%s,\n    0, /* no 16-bit colours */\n", name, suffix);
    } else {
        bytes_print(writer->out, "    0,\n    0, /* no colours */\n");
    }
    if (mesh->clusters != NULL) {
        bytes_print(writer->out, "    &%s_clusters%s,\n", name, suffix);
    } else {
        bytes_print(writer->out, "    0, /* no clusters */\n");
    }
    if (has_layout(writer, mesh)) {
        bytes_print(writer->out, "    &%s_layout%s,\n", name, suffix);
    } else {
        bytes_print(writer->out, "    0, /* no layout */\n");
    }
    if (mesh->texture_coordinates != NULL) {
        bytes_print(writer->out,
                    "    %s_uv%s,\n    {%ld, %ld}, /* of step 0 */\n    {%ld, %ld}, /* of 32768 steps */\n", name,
                    suffix, (long)mesh->texture_offset[0], (long)mesh->texture_offset[1], (long)mesh->texture_extent[0],
                    (long)mesh->texture_extent[1]);
    } else {
        bytes_print(writer->out, "    0,\n    {0, 0},\n    {0, 0}, /* no texture */\n");
    }
}

static void print_single(const header_writer *writer, const glint_mesh *mesh, const char *suffix) {
    bytes_print(writer->out, "\n%s glint_mesh %s_mesh%s = {\n", writer->storage, writer->name, suffix);
    print_mesh(writer, mesh, suffix);
    bytes_print(writer->out, "};\n");
}

/* ---- Materials and objects -------------------------------------------------------------------------------------- */

static const char *model_name(const glint_shading_model *model) {
    return model == &glint_model_lambert ? "lambert" : model == &glint_model_unlit ? "unlit" : "blinn_phong";
}

static void print_colour(host_bytes *out, glint_colour colour, const char *what) {
    bytes_print(out, "    {%ld, %ld, %ld}, /* %s */\n", (long)colour.r, (long)colour.g, (long)colour.b, what);
}

/** Returns the suffix of the first material that is written and has a texture; null where none does. */
static const char *find_wearer(const header_writer *writer, const glint_texture *texture) {
    for (uint32_t i = 1; i <= writer->materials->used_count; i++) {
        if (materials_find(writer->materials, i)->texture.made == texture && writer->paints[i].text[0] != '\0') {
            return writer->paints[i].text;
        }
    }
    return NULL;
}

static void print_values(host_bytes *out, const void *values, bool are_wide, size_t count) {
    for (size_t i = 0; i < count; i++) {
        bytes_print(out, i % 20 == 0 ? "\n    " : " ");
        bytes_print(out, "%u,", are_wide ? ((const uint16_t *)values)[i] : ((const uint8_t *)values)[i]);
    }
    bytes_print(out, "\n};\n");
}

/** Prints one level of a texture, of which all end their names in `level` and the suffix. */
static void print_level(const header_writer *writer, const host_texture *made, const glint_texture *texture,
                        const char *level, const char *suffix) {
    host_bytes *out = writer->out;
    const bool is_wide = made->type == TEXTURE_RGB565;
    bytes_print(out, "\nstatic const uint%d_t %s_texels%s%s[%zu] = {", is_wide ? 16 : 8, writer->name, level, suffix,
                texture_items(texture));
    print_values(out, texture->texels, is_wide, texture_items(texture));
    bytes_print(out, "\n%s glint_texture %s_texture%s%s = {\n    &glint_texture_%s,\n    %s_texels%s%s,\n",
                writer->storage, writer->name, level, suffix, texture_type_names[made->type], writer->name, level,
                suffix);
    if (texture->palette != NULL) {
        bytes_print(out, "    %s_palette%s,\n", writer->name, suffix);
    } else {
        bytes_print(out, "    0, /* no palette */\n");
    }
    bytes_print(out, "    %u, /* width */\n    %u, /* height */\n    %s,\n    %u, /* key */\n", texture->width,
                texture->height, texture->flags != 0 ? "GLINT_TEXTURE_HAS_KEY" : "0", texture->key);
}

/** Prints a texture under the name of the first material that has it, its smallest level first. */
static void print_texture(const header_writer *writer, const host_texture *made, const char *suffix) {
    host_bytes *out = writer->out;
    char smaller[24] = "";
    if (made->texture.palette != NULL) {
        const size_t count = made->type == TEXTURE_PALETTE16 ? 16 : 256;
        bytes_print(out, "\nstatic const uint16_t %s_palette%s[%zu] = {", writer->name, suffix, count);
        print_values(out, made->texture.palette, true, count);
    }
    for (size_t i = made->level_count + 1; i-- > 0;) {
        char level[24] = "";
        if (i > 0) {
            snprintf(level, sizeof level, "%zu", i);
        }
        print_level(writer, made, i > 0 ? &made->levels[i - 1] : &made->texture, level, suffix);
        if (i < made->level_count) {
            bytes_print(out, "    &%s_texture%s%s,\n};\n", writer->name, smaller, suffix);
        } else {
            bytes_print(out, "    0, /* no smaller level */\n};\n");
        }
        memcpy(smaller, level, sizeof smaller);
    }
}

static void print_textures(const header_writer *writer) {
    for (size_t i = 0; i < writer->materials->texture_count; i++) {
        const host_texture *made = writer->materials->textures[i];
        const char *suffix = find_wearer(writer, &made->texture);
        if (suffix != NULL) {
            print_texture(writer, made, suffix);
        }
    }
}

static void print_material(const header_writer *writer, const char *suffix, const glint_material *material) {
    host_bytes *out = writer->out;
    static const char *const flags[] = {"0", "GLINT_MATERIAL_CLAMP", "GLINT_MATERIAL_BILINEAR",
                                        "GLINT_MATERIAL_CLAMP | GLINT_MATERIAL_BILINEAR"};
    static const char *const blends[] = {"NONE", "ALPHA", "ADD", "DITHERED"};
    bytes_print(out, "\n%s glint_material %s_material%s = {\n    &glint_model_%s,\n", writer->storage, writer->name,
                suffix, model_name(material->model));
    print_colour(out, material->ambient, "ambient");
    print_colour(out, material->diffuse, "diffuse");
    print_colour(out, material->specular, "specular");
    bytes_print(out, "    %ld, /* shininess */\n    %s,\n", (long)material->shininess,
                flags[material->flags / GLINT_MATERIAL_CLAMP]);
    if (material->texture != NULL) {
        bytes_print(out, "    &%s_texture%s,\n", writer->name, find_wearer(writer, material->texture));
    } else {
        bytes_print(out, "    0, /* no texture */\n");
    }
    bytes_print(out, "    GLINT_BLEND_%s,\n    %ld, /* opacity */\n", blends[material->blend], (long)material->opacity);
    bytes_print(out, "};\n");
}

/** Prints an array's head: `static const TYPE NAME_WHAT[COUNT]`. */
static void print_array_head(const header_writer *writer, const char *type, const char *what) {
    bytes_print(writer->out, "%s %s%s_%s[%zu]", writer->storage, type, writer->name, what, writer->mesh->piece_count);
}

/** Returns the middle of the box of a piece's object, Q16.16. */
static glint_vector find_centre(const quantised_mesh *mesh, size_t piece) {
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    double high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < mesh->piece_count; i++) {
        for (uint32_t j = 0; is_same_object(mesh, i, piece) && j < mesh->pieces[i].vertex_count; j++) {
            double position[3];
            quantised_position(&mesh->pieces[i], j, position);
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = fmin(low[axis], position[axis]);
                high[axis] = fmax(high[axis], position[axis]);
            }
        }
    }
    return (glint_vector){number_q16(low[0] / 2 + high[0] / 2), number_q16(low[1] / 2 + high[1] / 2),
                          number_q16(low[2] / 2 + high[2] / 2)};
}

/** Prints NAME_object_names and NAME_object_centres, in the order of NAME_objects. */
static void print_names(const header_writer *writer) {
    host_bytes *out = writer->out;
    const quantised_mesh *mesh = writer->mesh;
    bytes_print(out, "\n/* Names of the objects. */\n");
    print_array_head(writer, "char *const ", "object_names");
    bytes_print(out, " = {\n");
    for (size_t i = 0; i < mesh->piece_count; i++) {
        bytes_print(out, "    \"");
        for (const char *c = object_name(writer->materials, mesh->objects[i]); *c != '\0'; c++) {
            bytes_add(out, (uint8_t)(*c < ' ' || *c > '~' || strchr("\"\\?", *c) != NULL ? '_' : *c));
        }
        bytes_print(out, "\",\n");
    }
    bytes_print(out, "};\n\n/* Middles of the objects' boxes, Q16.16. */\n");
    print_array_head(writer, "glint_vector ", "object_centres");
    bytes_print(out, " = {\n");
    for (size_t i = 0; i < mesh->piece_count; i++) {
        const glint_vector centre = find_centre(mesh, i);
        bytes_print(out, "    {%ld, %ld, %ld},\n", (long)centre.x, (long)centre.y, (long)centre.z);
    }
    bytes_print(out, "};\n");
}

/** Prints the materials NAME_material_MATERIAL, and NAME_objects: an object for each piece. */
static void print_objects(const header_writer *writer) {
    host_bytes *out = writer->out;
    const quantised_mesh *mesh = writer->mesh;
    print_textures(writer);
    bytes_print(out, "\n/* Materials: Q16.16, for ambient light of 1 in the scene. */\n");
    for (uint32_t i = 0; i <= writer->materials->used_count; i++) {
        if (writer->paints[i].text[0] != '\0') {
            const glint_material material = settings_material(writer->settings, materials_find(writer->materials, i));
            print_material(writer, writer->paints[i].text, &material);
        }
    }
    bytes_print(out, "\n/* Objects of one scene, all with the same pose: copy them where they move. */\n");
    print_array_head(writer, "glint_object ", "objects");
    bytes_print(out, " = {\n");
    for (size_t i = 0; i < mesh->piece_count; i++) {
        bytes_print(out,
                    "    {&%s_mesh%s, &%s_material%s, {{{65536, 0, 0, 0}, {0, 65536, 0, 0}, {0, 0, 65536, 0}}}, "
                    "&glint_per_fragment, 0, 0},\n",
                    writer->name, writer->suffixes[i].text, writer->name, writer->paints[mesh->materials[i]].text);
    }
    bytes_print(out, "};\n");
    if (mesh->objects != NULL) {
        print_names(writer);
    }
}

/** Prints the camera NAME_camera. */
static void print_camera(const header_writer *writer) {
    const glint_camera *camera = writer->camera;
    bytes_print(writer->out,
                "\n/* Sees all of it, at the aspect of the panel. */\n%s glint_camera %s_camera = {\n    {{",
                writer->storage, writer->name);
    for (int row = 0; row < 3; row++) {
        const glint_q16 *m = camera->pose.m[row];
        bytes_print(writer->out, "%s{%ld, %ld, %ld, %ld}", row > 0 ? ", " : "", (long)m[0], (long)m[1], (long)m[2],
                    (long)m[3]);
    }
    bytes_print(writer->out, "}},\n    %ld, /* field of view */\n    %ld, /* near plane */\n    0,\n    0,\n};\n",
                (long)camera->field_of_view, (long)camera->near_plane);
}

/* ---- Files ------------------------------------------------------------------------------------------------------ */

/** Declares each piece's mesh, each material, and the objects. */
static void declare_objects(const header_writer *writer) {
    const quantised_mesh *mesh = writer->mesh;
    for (size_t i = 0; i < mesh->piece_count; i++) {
        bytes_print(writer->out, "%s glint_mesh %s_mesh%s;\n", writer->storage, writer->name, writer->suffixes[i].text);
    }
    for (size_t i = 0; i <= writer->materials->used_count; i++) {
        if (writer->paints[i].text[0] != '\0') {
            bytes_print(writer->out, "%s glint_material %s_material%s;\n", writer->storage, writer->name,
                        writer->paints[i].text);
        }
    }
    for (size_t i = 0; i < writer->materials->texture_count; i++) {
        const char *suffix = find_wearer(writer, &writer->materials->textures[i]->texture);
        if (suffix != NULL) {
            bytes_print(writer->out, "%s glint_texture %s_texture%s;\n", writer->storage, writer->name, suffix);
        }
    }
    print_array_head(writer, "glint_object ", "objects");
    bytes_print(writer->out, "; /* all with the same pose: copy them where they move */\n");
    if (mesh->objects != NULL) {
        print_array_head(writer, "char *const ", "object_names");
        bytes_print(writer->out, ";\n");
        print_array_head(writer, "glint_vector ", "object_centres");
        bytes_print(writer->out, "; /* middles of their boxes */\n");
    }
}

/** Declares what a source defines: the meshes, and the materials, objects and camera that there are. */
static void print_declarations(const header_writer *writer) {
    const quantised_mesh *mesh = writer->mesh;
    bytes_print(writer->out, "\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
    if (has_objects(writer->materials, mesh)) {
        declare_objects(writer);
    } else if (mesh->piece_count > 1) {
        bytes_print(writer->out, "%s glint_mesh %s_meshes[%zu]; /* one object for each */\n", writer->storage,
                    writer->name, mesh->piece_count);
    } else {
        bytes_print(writer->out, "%s glint_mesh %s_mesh;\n", writer->storage, writer->name);
    }
    if (writer->camera != NULL) {
        bytes_print(writer->out, "%s glint_camera %s_camera; /* sees all of it */\n", writer->storage, writer->name);
    }
    bytes_print(writer->out, "\n#ifdef __cplusplus\n}\n#endif\n");
}

/** Several pieces of no material as the array NAME_meshes. */
static void print_array(const header_writer *writer, const quantised_mesh *mesh) {
    bytes_print(writer->out, "\n/* More vertices than 16 bits can index: one object for each of these. */\n");
    bytes_print(writer->out, "%s glint_mesh %s_meshes[%zu] = {\n", writer->storage, writer->name, mesh->piece_count);
    for (size_t i = 0; i < mesh->piece_count; i++) {
        bytes_print(writer->out, "    {\n");
        print_mesh(writer, &mesh->pieces[i], writer->suffixes[i].text);
        bytes_print(writer->out, "    },\n");
    }
    bytes_print(writer->out, "};\n");
}

/** Prints one mesh as NAME_mesh, several as NAME_meshes; with materials or objects each as NAME_mesh_SUFFIX. */
static void print_meshes(const header_writer *writer) {
    const quantised_mesh *mesh = writer->mesh;
    const bool apart = has_objects(writer->materials, mesh);
    for (size_t i = 0; i < mesh->piece_count; i++) {
        print_arrays(writer, &mesh->pieces[i], writer->suffixes[i].text);
    }
    if (!apart && mesh->piece_count > 1) {
        print_array(writer, mesh);
    }
    for (size_t i = 0; apart ? i < mesh->piece_count : i < 1 && mesh->piece_count == 1; i++) {
        print_single(writer, &mesh->pieces[i], writer->suffixes[i].text);
    }
    if (apart) {
        print_objects(writer);
    }
    if (writer->camera != NULL) {
        print_camera(writer);
    }
}

/** Says on stderr when steps of Q16.16 are too coarse for the mesh. */
static void warn_of_steps(const char *file, const host_model *model, const quantised_mesh *mesh) {
    double side = 0;
    for (int axis = 0; axis < 3; axis++) {
        side = model->high[axis] - model->low[axis] > side ? model->high[axis] - model->low[axis] : side;
    }
    host_problem warning;
    if (mesh->types.positions == QUANTISE_POSITIONS_INT16 && mesh->largest_move > side * STEP_MAX) {
        problem_set(&warning, 0, "warning: positions move by up to %.2g, of sides of %.3g: give --scale fit",
                    mesh->largest_move, side);
        problem_print(file, &warning);
    }
}

/** Says on stderr when the mesh that is written is not wound as it should be. */
static void warn_of_winding(const char *file, const host_mesh *mesh) {
    const mesh_winding winding = mesh_check_winding(mesh);
    host_problem warning;
    if (winding.mixed_parts == 0 && winding.inward_parts == 0) {
        return;
    }
    problem_set(&warning, 0, "warning: of %zu connected parts %zu are wound inconsistently and %zu inside out%s",
                winding.part_count, winding.mixed_parts, winding.inward_parts,
                winding.mixed_parts > winding.one_sided_parts || winding.inward_parts > 0 ? ": see --repair" : "");
    problem_print(file, &warning);
}

/** Finds the camera that sees the whole mesh on the settings' panel. @return false with a problem where none can */
static bool find_camera(const host_settings *settings, const host_model *model, const quantised_mesh *mesh,
                        glint_camera *camera, host_problem *problem) {
    host_settings framed = *settings;
    host_view view;
    memset(framed.rotate, 0, sizeof framed.rotate); /* the mesh itself was turned */
    framed.width = settings->panel.width;
    framed.height = settings->panel.height;
    if (!view_make(&view, &framed, &model->materials, mesh, problem)) {
        return problem_set(problem, 0, "--fit: no camera in Q16.16 sees all of it: give --scale fit");
    }
    *camera = view.scene.camera;
    view_free(&view);
    return true;
}

/** Prints the arguments of glint_camera_look_at for a camera; it looks at a point near the middle of the model. */
static void report_camera(const glint_camera *camera, const host_model *model) {
    double eye[3];
    double back[3];
    double distance = 0;
    for (int row = 0; row < 3; row++) {
        eye[row] = number_from_q16(camera->pose.m[row][3]);
        back[row] = number_from_q16(camera->pose.m[row][2]);
        distance += back[row] * (eye[row] - model->low[row] / 2 - model->high[row] / 2);
    }
    printf("camera_eye %.5f %.5f %.5f\n", eye[0], eye[1], eye[2]);
    printf("camera_at %.5f %.5f %.5f\n", eye[0] - distance * back[0], eye[1] - distance * back[1],
           eye[2] - distance * back[2]);
    printf("camera_near %.5f\n", number_from_q16(camera->near_plane));
}

/** Prints the size of the mesh and the camera that sees it, unless the mesh itself is printed there. */
static void print_report(const host_settings *settings, const host_model *model, const quantised_mesh *mesh,
                         const glint_camera *camera) {
    const report_subject subject = {settings, &model->materials, mesh};
    host_problem why;
    host_problem warning;
    if (path_is_stdout(settings->output)) {
        return;
    }
    if (settings->load.simplify > 0) {
        printf("triangles_read %zu\ngeometric_error %.3g\n", model->read_count, model->error);
    }
    if (!report_print(&subject, &why)) {
        problem_set(&warning, 0, "warning: what it takes is not known: %s", why.text);
        problem_print(settings->model, &warning);
    }
    if (camera != NULL) {
        report_camera(camera, model);
    }
}

static void print_header(const header_writer *writer, const host_model *model) {
    print_head(writer, model, writer->mesh);
    print_guard(writer, "#ifndef");
    print_guard(writer, "#define");
    bytes_print(writer->out, "\n#include \"%s\"\n", has_layouts(writer) ? "glint_extras.h" : "glint.h");
    if (is_pair(writer->settings->output)) {
        print_declarations(writer);
    } else {
        print_meshes(writer);
    }
    bytes_print(writer->out, "\n#endif\n");
}

static bool write_header(const header_writer *like, const host_model *model) {
    host_bytes file = {NULL, 0, 0};
    header_writer writer = *like;
    writer.out = &file;
    writer.storage = "static const";
    print_header(&writer, model);
    return command_write(&file, like->settings->output) == 0;
}

static bool write_pair(const header_writer *like, const host_model *model) {
    char *header = header_of(like->settings->output);
    host_file pair[2] = {{{NULL, 0, 0}, like->settings->output}, {{NULL, 0, 0}, header}};
    host_problem problem;
    const char *wrong;
    header_writer writer = *like;
    writer.storage = "const";
    writer.out = &pair[0].bytes;
    print_head(&writer, model, writer.mesh);
    bytes_print(writer.out, "#include \"%s\"\n", path_base_name(header));
    print_meshes(&writer);
    writer.out = &pair[1].bytes;
    writer.storage = "extern const";
    print_header(&writer, model);
    const bool ok = bytes_write_pair(pair, &wrong, &problem);
    if (!ok) {
        problem_print(wrong, &problem);
    }
    free(pair[0].bytes.data);
    free(pair[1].bytes.data);
    free(header);
    return ok;
}

/** Writes a loaded model and prints the report. @return exit status */
static int convert(const host_settings *settings, const host_model *model, const quantised_mesh *mesh) {
    glint_camera camera;
    host_problem problem;
    const bool framed = find_camera(settings, model, mesh, &camera, &problem);
    if (settings->fit && !framed) {
        return command_fail(settings->model, &problem);
    }
    header_suffix *suffixes = find_suffixes(&model->materials, mesh);
    header_suffix *paints = find_paints(&model->materials, mesh, suffixes);
    header_writer writer = {.settings = settings, .mesh = mesh, .materials = &model->materials, .suffixes = suffixes};
    writer.paints = paints;
    writer.camera = settings->fit ? &camera : NULL;
    choose_name(settings, writer.name);
    const bool ok = (is_pair(settings->output) ? write_pair : write_header)(&writer, model);
    if (ok) {
        print_report(settings, model, mesh, framed ? &camera : NULL);
        command_print_warnings(settings, model);
        command_warn_of_size(settings, &model->materials, mesh);
        warn_of_steps(settings->model, model, mesh);
        warn_of_winding(settings->model, &model->mesh);
    }
    free(suffixes);
    free(paints);
    return ok ? 0 : COMMAND_FAILED;
}

int command_convert(const host_settings *settings) {
    host_model model;
    quantised_mesh mesh;
    if (!check_pair(settings) || !command_load(settings, true, &model, &mesh)) {
        return COMMAND_FAILED;
    }
    const int status = convert(settings, &model, &mesh);
    quantised_free(&mesh);
    model_free(&model);
    return status;
}
