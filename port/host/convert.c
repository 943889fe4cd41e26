/* SPDX-License-Identifier: MIT */
/**
 * @file convert.c
 * What the converter writes: a header, or a source and its header.
 */
#include "command.h"

#include "basics.h"
#include "values.h"
#include "view.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Part of a mesh's side by which positions may move unsaid: a quarter of a pixel of 1024, the largest display. */
#define STEP_MAX (1.0 / 4096.0)

/** Characters that are kept of a material's name. */
#define NAME_KEPT 40

/** Room for what tells a piece's names from those of others: 40 characters of a material's name, and two numbers. */
typedef struct header_suffix {
    char text[64];
} header_suffix;

typedef struct header_writer {
    host_bytes *out;
    const host_settings *settings;
    const quantised_mesh *mesh;
    const char *storage;           /* of meshes, materials and objects */
    const header_suffix *suffixes; /* a piece each */
    char name[CONVERT_NAME_SIZE];
} header_writer;

/** A character as an identifier may have it: what is no letter, digit or underscore becomes an underscore. */
static char plain_character(char c) {
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
        base[length++] = plain_character(*letter);
    }
    base[length] = '\0';
    char *suffix = suffixes[piece].text;
    const size_t size = sizeof suffixes[piece].text;
    snprintf(suffix, size, counted ? "_%s_1" : "_%s", base);
    for (unsigned number = 2; is_taken(suffixes, piece); number++) {
        snprintf(suffix, size, "_%s_%u", base, number);
    }
}

/**
 * A suffix for each piece: empty for one piece without materials; its number where there are several; with materials
 * the name of its own, followed by numbers where that alone is not unique. @return the caller frees them
 */
static header_suffix *find_suffixes(const host_materials *materials, const quantised_mesh *mesh) {
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

/* ---- The head --------------------------------------------------------------------------------------------------- */

/** Whether an output's name asks for a source and its header: it ends with .c. False for null. */
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

/** Whether a pair can have the names that it would; says why not. True for what is no pair. */
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

/** Text that cannot end a comment, open one, or leave its line. */
static void print_in_comment(host_bytes *out, const char *text) {
    for (; *text != '\0'; text++) {
        bytes_add(out, (uint8_t)(*text < ' ' || *text > '~' || *text == '*' || *text == '\\' ? '_' : *text));
    }
}

static void print_load_options(host_bytes *out, const load_options *load) {
    if (load->weld >= 0) {
        bytes_print(out, " --weld %.9g", load->weld);
    }
    if (load->simplify > 0) {
        bytes_print(out, " --simplify %zu", load->simplify);
    }
    if (load->crease >= 0) {
        bytes_print(out, " --crease %.9g", load->crease);
    }
    if (load->weights != MESH_BY_AREA) {
        bytes_print(out, " --weights %s", mesh_weight_names[load->weights]);
    }
    if (load->types.positions != QUANTISE_POSITIONS_INT16) {
        bytes_print(out, " --positions %s", quantise_position_names[load->types.positions]);
    }
    if (load->types.normals != QUANTISE_NORMALS_INT16) {
        bytes_print(out, " --normals %s", quantise_normal_names[load->types.normals]);
    }
    if (load->types.indices != QUANTISE_INDICES_16) {
        bytes_print(out, " --indices %s", quantise_index_names[load->types.indices]);
    }
    bytes_print(out, "%s%s%s", load->facets ? " --facets" : "", load->repair ? " --repair" : "",
                load->plain ? " --no-clusters" : "");
}

/**
 * The options that shape the mesh, in one order. A header's name is not among them: it must not change the bytes. That
 * of a pair is, as the source names its header.
 */
static void print_command_line(const header_writer *writer) {
    const host_settings *settings = writer->settings;
    const double *scale = settings->scale;
    bytes_print(writer->out, "glint convert ");
    print_in_comment(writer->out, path_base_name(settings->model));
    if (settings->name != NULL) {
        bytes_print(writer->out, " --name %s", settings->name);
    }
    if (settings->licence != NULL) {
        bytes_print(writer->out, " --licence \"%s\"", settings->licence);
    }
    print_load_options(writer->out, &settings->load);
    bytes_print(writer->out, "%s%s%s", settings->z_up ? " --up-axis z" : "", settings->centre ? " --centre" : "",
                settings->scale_fit ? " --scale fit" : "");
    if (scale[0] < 1 || scale[0] > 1 || scale[1] < 1 || scale[1] > 1 || scale[2] < 1 || scale[2] > 1) {
        bytes_print(writer->out, " --scale %.9g,%.9g,%.9g", scale[0], scale[1], scale[2]);
    }
    for (int axis = 0; axis < 3; axis++) {
        if (settings->rotate[axis] != 0) {
            bytes_print(writer->out, " --rotate-%c %.9g", "xyz"[axis], number_from_q16(settings->rotate[axis]));
        }
    }
    if (settings->double_sided) {
        bytes_print(writer->out, " --double-sided");
    }
    if (is_pair(settings->output)) {
        bytes_print(writer->out, " -o ");
        print_in_comment(writer->out, path_base_name(settings->output));
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
                mesh->vertex_count, mesh->triangle_count, quantised_size(mesh));
    print_command_line(writer);
    bytes_print(out, "\n * from a source whose FNV-1a hash (64 bits) is %016llx.\n", (unsigned long long)model->hash);
    if (writer->settings->load.simplify > 0) {
        bytes_print(out, " * Simplified from %zu triangles: geometric error %.3g, in units of the source.\n",
                    model->read_count, model->error);
    }
    for (size_t i = 0; i < model->materials.library_count; i++) {
        bytes_print(out, " * Materials from ");
        print_in_comment(out, path_base_name(model->materials.libraries[i].path));
        bytes_print(out, ", whose hash is %016llx.\n", (unsigned long long)model->materials.libraries[i].hash);
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
                " * extent     Q16.16, the length of 32768 steps\n%s%s */\n",
                positions[mesh->types.positions], normals[mesh->types.normals],
                mesh->types.indices == QUANTISE_INDICES_16 ? "uint16" : "uint8 up to 256 vertices, else uint16",
                mesh->pieces[0].colours != NULL ? " * colours    uint8 red, green, blue: 255 is 1\n" : "",
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

static void print_material(const header_writer *writer, const char *suffix, const glint_material *material) {
    host_bytes *out = writer->out;
    bytes_print(out, "\n%s glint_material %s_material%s = {\n    &glint_model_%s,\n", writer->storage, writer->name,
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

/** Prints the materials NAME_material_MATERIAL, and NAME_objects: an object for each piece. */
static void print_objects(const header_writer *writer, const host_materials *materials, const quantised_mesh *mesh) {
    host_bytes *out = writer->out;
    const header_suffix *suffixes = writer->suffixes;
    size_t *first = first_pieces(materials, mesh);
    bytes_print(out, "\n/* Materials: Q16.16, for ambient light of 1 in the scene. */\n");
    for (size_t i = 0; i < mesh->piece_count; i++) {
        if (first[mesh->materials[i]] == i) {
            const glint_material material =
                settings_material(writer->settings, materials_find(materials, mesh->materials[i]));
            print_material(writer, suffixes[i].text, &material);
        }
    }
    bytes_print(out,
                "\n/* Objects of one scene, all with the same pose: copy them where they move. */\n"
                "%s glint_object %s_objects[%zu] = {\n",
                writer->storage, writer->name, mesh->piece_count);
    for (size_t i = 0; i < mesh->piece_count; i++) {
        const char *material = suffixes[first[mesh->materials[i]]].text;
        bytes_print(out,
                    "    {&%s_mesh%s, &%s_material%s, {{{65536, 0, 0, 0}, {0, 65536, 0, 0}, {0, 0, 65536, 0}}}, "
                    "&glint_per_fragment, 0},\n",
                    writer->name, suffixes[i].text, writer->name, material);
    }
    bytes_print(out, "};\n");
    free(first);
}

/* ---- Files ------------------------------------------------------------------------------------------------------ */

/** Declares each piece's mesh, each material, and the objects. */
static void declare_painted(const header_writer *writer, const host_materials *materials, const quantised_mesh *mesh) {
    size_t *first = first_pieces(materials, mesh);
    for (size_t i = 0; i < mesh->piece_count; i++) {
        bytes_print(writer->out, "%s glint_mesh %s_mesh%s;\n", writer->storage, writer->name, writer->suffixes[i].text);
    }
    for (size_t i = 0; i < mesh->piece_count; i++) {
        if (first[mesh->materials[i]] == i) {
            bytes_print(writer->out, "%s glint_material %s_material%s;\n", writer->storage, writer->name,
                        writer->suffixes[i].text);
        }
    }
    bytes_print(writer->out,
                "%s glint_object %s_objects[%zu]; /* all with the same pose: copy them where they move */\n",
                writer->storage, writer->name, mesh->piece_count);
    free(first);
}

/** Declares what a source defines: the meshes, and the materials and objects that there are. */
static void print_declarations(const header_writer *writer, const host_materials *materials,
                               const quantised_mesh *mesh) {
    bytes_print(writer->out, "\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
    if (materials->used_count > 0) {
        declare_painted(writer, materials, mesh);
    } else if (mesh->piece_count > 1) {
        bytes_print(writer->out, "%s glint_mesh %s_meshes[%zu]; /* one object for each */\n", writer->storage,
                    writer->name, mesh->piece_count);
    } else {
        bytes_print(writer->out, "%s glint_mesh %s_mesh;\n", writer->storage, writer->name);
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

/** One mesh as NAME_mesh, several as NAME_meshes; with materials each as NAME_mesh_MATERIAL. */
static void print_meshes(const header_writer *writer, const host_model *model, const quantised_mesh *mesh) {
    const header_suffix *suffixes = writer->suffixes;
    const bool painted = model->materials.used_count > 0;
    for (size_t i = 0; i < mesh->piece_count; i++) {
        print_arrays(writer, &mesh->pieces[i], suffixes[i].text);
    }
    if (!painted && mesh->piece_count > 1) {
        print_array(writer, mesh);
    }
    for (size_t i = 0; painted ? i < mesh->piece_count : i < 1 && mesh->piece_count == 1; i++) {
        print_single(writer, &mesh->pieces[i], suffixes[i].text);
    }
    if (painted) {
        print_objects(writer, &model->materials, mesh);
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

/** Prints what the mesh takes, unless the mesh itself is printed there. */
static void print_report(const host_settings *settings, const host_model *model, const quantised_mesh *mesh) {
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
}

static void print_header(const header_writer *writer, const host_model *model, const quantised_mesh *mesh) {
    print_head(writer, model, mesh);
    print_guard(writer, "#ifndef");
    print_guard(writer, "#define");
    bytes_print(writer->out, "\n#include \"glint.h\"\n");
    if (is_pair(writer->settings->output)) {
        print_declarations(writer, &model->materials, mesh);
    } else {
        print_meshes(writer, model, mesh);
    }
    bytes_print(writer->out, "\n#endif\n");
}

static void print_source(const header_writer *writer, const char *header, const host_model *model,
                         const quantised_mesh *mesh) {
    print_head(writer, model, mesh);
    bytes_print(writer->out, "#include \"%s\"\n", path_base_name(header));
    print_meshes(writer, model, mesh);
}

static bool write_header(const header_writer *like, const host_model *model, const quantised_mesh *mesh) {
    host_bytes file = {NULL, 0, 0};
    host_problem problem;
    header_writer writer = *like;
    writer.out = &file;
    writer.storage = "static const";
    print_header(&writer, model, mesh);
    const bool ok = bytes_write_file(&file, like->settings->output, &problem);
    if (!ok) {
        problem_print(like->settings->output, &problem);
    }
    free(file.data);
    return ok;
}

static bool write_pair(const header_writer *like, const host_model *model, const quantised_mesh *mesh) {
    char *header = header_of(like->settings->output);
    host_file pair[2] = {{{NULL, 0, 0}, like->settings->output}, {{NULL, 0, 0}, header}};
    host_problem problem;
    const char *wrong;
    header_writer writer = *like;
    writer.storage = "const";
    writer.out = &pair[0].bytes;
    print_source(&writer, header, model, mesh);
    writer.out = &pair[1].bytes;
    writer.storage = "extern const";
    print_header(&writer, model, mesh);
    const bool ok = bytes_write_pair(pair, &wrong, &problem);
    if (!ok) {
        problem_print(wrong, &problem);
    }
    free(pair[0].bytes.data);
    free(pair[1].bytes.data);
    free(header);
    return ok;
}

int command_convert(const host_settings *settings) {
    host_model model;
    quantised_mesh mesh;
    if (!check_pair(settings) || !command_load(settings, true, &model, &mesh)) {
        return COMMAND_FAILED;
    }
    header_suffix *suffixes = find_suffixes(&model.materials, &mesh);
    header_writer writer = {.settings = settings, .mesh = &mesh, .suffixes = suffixes};
    if (settings->name != NULL) {
        strcpy(writer.name, settings->name);
    } else {
        convert_name(settings->model, writer.name);
    }
    const bool ok = (is_pair(settings->output) ? write_pair : write_header)(&writer, &model, &mesh);
    if (ok) {
        print_report(settings, &model, &mesh);
        command_print_warnings(settings, &model);
        command_warn_of_size(settings, &mesh);
        warn_of_steps(settings->model, &model, &mesh);
        warn_of_winding(settings->model, &model.mesh);
    }
    free(suffixes);
    quantised_free(&mesh);
    model_free(&model);
    return ok ? 0 : COMMAND_FAILED;
}
