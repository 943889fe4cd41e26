/* SPDX-License-Identifier: MIT */
#include "model.h"

#include "basics.h"
#include "values.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Different words for each of which there is a warning. With one of each other kind PROBLEM_WARNINGS_MAX holds all. */
#define WORDS_MAX 4

/** What is not followed, beside words that are no keywords; or nothing. */
enum {
    KIND_NONE = TEXT_KINDS,
    KIND_TEXTURE,
    KIND_LIBRARIES,
    KIND_ELEMENT,
    KIND_EMPTY_INDEX,
    KIND_BYTE_COLOURS,
    KIND_NO_COLOUR,
    KIND_SMOOTHING,
    KIND_NO_TEXTURE,
    KIND_TEXTURE_INDEX,
    KIND_NO_NORMAL,
    KIND_NORMAL_INDEX,
    KIND_FEW_CORNERS,
    KIND_ZBRUSH
};

typedef struct obj_reader {
    text_reader text;
    host_mesh *mesh;
    obj_materials *materials;
    double farthest;      /* largest coordinate so far */
    double (*colours)[3]; /* as read */
    size_t colour_count, colour_capacity;
    size_t bare_line, bare_count; /* the first position without a colour; how many */
    mesh_corner *face;
    size_t face_count, face_capacity;
    text_token object, group; /* current names of `o` and `g` */
    text_notes notes;
    host_problem *problem;
} obj_reader;

/* ---- Warnings --------------------------------------------------------------------------------------------------- */

static const text_token position_word = {"v", 1};

static const char *const note_texts[] = {
    [TEXT_WORD] = "is skipped: it is not an OBJ keyword",
    [TEXT_MORE_WORDS] = "is skipped, as are more words that are not OBJ keywords",
    [KIND_TEXTURE] = "is skipped: of textures only map_Kd is drawn",
    [KIND_LIBRARIES] = "is skipped: no more than 64 files of materials are read",
    [KIND_ELEMENT] = "is skipped: only faces are drawn",
    [KIND_EMPTY_INDEX] = "has an empty index: taken as not given",
    [KIND_BYTE_COLOURS] = "has a colour above 1: all colours are taken as 0 to 255",
    [KIND_NO_COLOUR] = "has no colour, as others have: no colour is kept",
    [KIND_NO_TEXTURE] = "does not have 1 to 3 finite numbers: taken as 0 0",
    [KIND_TEXTURE_INDEX] = "has a texture index that is none before it: taken as not given",
    [KIND_NO_NORMAL] = "does not have 3 finite numbers: taken as not given",
    [KIND_NORMAL_INDEX] = "has a normal index that is none before it: taken as not given",
    [KIND_FEW_CORNERS] = "is skipped: it has fewer than 3 corners",
    [KIND_ZBRUSH] = "is skipped: colours in ZBrush's comments are not read",
    [KIND_SMOOTHING] = "is skipped: a smoothing group is a number or off",
};

static void note(obj_reader *reader, int kind, text_token word) {
    text_note_add(&reader->notes, kind, word, reader->text.line);
}

/* ---- Vertices -------------------------------------------------------------------------------------------------- */

/** Reads the numbers that are left of a statement, up to 8. @return how many, or -1 with a problem. */
static int read_numbers(obj_reader *reader, double values[8]) {
    text_token token;
    int count = 0;
    while (text_next_token(&reader->text, &token)) {
        char quote[PROBLEM_QUOTE_SIZE];
        if (count == 8) {
            problem_set(reader->problem, reader->text.line, "too many numbers");
            return -1;
        }
        if (!number_real(token.start, token.length, &values[count])) {
            problem_set(reader->problem, reader->text.line, "'%s' is not a finite number%s",
                        problem_quote(quote, token.start, token.length),
                        memchr(token.start, ',', token.length) != NULL ? ": it takes a point in place of the comma"
                                                                       : "");
            return -1;
        }
        count++;
    }
    return count;
}

static bool has_room(obj_reader *reader, size_t count) {
    return count < OBJ_ITEMS_MAX || problem_set(reader->problem, reader->text.line,
                                                "more than the %u positions, normals or triangles that are "
                                                "read",
                                                OBJ_ITEMS_MAX);
}

/** Keeps a position's colour. @return false with a problem when it is none */
static bool read_colour(obj_reader *reader, const double *channels) {
    reader->colours =
        memory_grow(reader->colours, &reader->colour_capacity, reader->colour_count, sizeof *reader->colours);
    double *colour = reader->colours[reader->colour_count++];
    bool is_byte = false;
    for (int i = 0; i < 3; i++) {
        if (!(channels[i] >= 0 && channels[i] <= 255)) {
            return problem_set(reader->problem, reader->text.line, "colour %.6g is not from 0 to 1, nor to 255",
                               channels[i]);
        }
        colour[i] = channels[i];
        is_byte = is_byte || channels[i] > 1;
    }
    if (is_byte) {
        note(reader, KIND_BYTE_COLOURS, position_word);
    }
    return true;
}

/** Are all colours white? Then they change no pixel, and would cost flash and time. */
static bool are_white(const obj_reader *reader, double white) {
    for (size_t i = 0; i < reader->colour_count; i++) {
        for (int c = 0; c < 3; c++) {
            if (reader->colours[i][c] != white) {
                return false;
            }
        }
    }
    return true;
}

/** Gives the mesh its colours, when all positions have one and not all are white. */
static void keep_colours(obj_reader *reader) {
    const double scale = text_find_note(&reader->notes, KIND_BYTE_COLOURS, position_word) != NULL ? 1.0 : 255.0;
    if (reader->colour_count > 0 && reader->bare_count > 0) {
        reader->notes.list[reader->notes.count++] =
            (text_note){KIND_NO_COLOUR, position_word, reader->bare_line, reader->bare_count - 1};
        return;
    }
    if (are_white(reader, 255.0 / scale)) {
        return;
    }
    for (size_t i = 0; i < reader->colour_count; i++) {
        const double *colour = reader->colours[i];
        mesh_add_colour(reader->mesh, (uint8_t)lround(colour[0] * scale), (uint8_t)lround(colour[1] * scale),
                        (uint8_t)lround(colour[2] * scale));
    }
}

static bool read_position(obj_reader *reader) {
    double values[8];
    const int count = read_numbers(reader, values);
    if (count < 0) {
        return false;
    }
    if (count < 3 || count == 5 || count > 7) {
        return problem_set(reader->problem, reader->text.line, "v takes 3 coordinates, here are %d numbers", count);
    }
    const double largest = fmax(fabs(values[0]), fmax(fabs(values[1]), fabs(values[2])));
    if (largest > OBJ_COORDINATE_MAX) {
        return problem_set(reader->problem, reader->text.line, "coordinate of %.3g is too large", largest);
    }
    if (largest > reader->farthest) {
        reader->farthest = largest;
        reader->mesh->farthest_line = reader->text.line;
    }
    if (!has_room(reader, reader->mesh->position_count) || (count >= 6 && !read_colour(reader, values + count - 3))) {
        return false;
    }
    if (count < 6 && reader->bare_count++ == 0) {
        reader->bare_line = reader->text.line;
    }
    mesh_add_position(reader->mesh, values[0], values[1], values[2]);
    return true;
}

/** Reads what is left of a statement that can be done without. @return how many numbers, or -1 when one is none */
static int read_optional(obj_reader *reader, double values[3]) {
    text_token token;
    int count = 0;
    while (text_next_token(&reader->text, &token)) {
        if (count == 3 || !number_real(token.start, token.length, &values[count])) {
            return -1;
        }
        count++;
    }
    return count;
}

/** Reads a normal. One that is none has length 0, as a normal that is not given. */
static bool read_normal(obj_reader *reader) {
    static const text_token word = {"vn", 2};
    double values[3];
    const bool ok = read_optional(reader, values) == 3;
    if (!has_room(reader, reader->mesh->normal_count)) {
        return false;
    }
    if (ok) {
        mesh_add_normal(reader->mesh, values[0], values[1], values[2]);
    } else {
        note(reader, KIND_NO_NORMAL, word);
        mesh_add_normal(reader->mesh, 0, 0, 0);
    }
    return true;
}

static bool read_texture(obj_reader *reader) {
    static const text_token word = {"vt", 2};
    double values[3] = {0, 0, 0};
    const int count = read_optional(reader, values);
    if (!has_room(reader, reader->mesh->texture_count)) {
        return false;
    }
    if (count < 1) {
        note(reader, KIND_NO_TEXTURE, word);
    }
    /* v counts from the bottom here. */
    mesh_add_texture(reader->mesh, count < 1 ? 0 : values[0], 1 - (count < 2 ? 0 : values[1]));
    return true;
}

/* ---- Faces ------------------------------------------------------------------------------------------------------ */

/** Reads one index of a corner. @return false with a problem when it is no number */
static bool read_index(obj_reader *reader, text_token part, const char *what, int64_t *number) {
    char quote[PROBLEM_QUOTE_SIZE];
    return number_integer(part.start, part.length, number) ||
           problem_set(reader->problem, reader->text.line, "'%s' is not a %s index",
                       problem_quote(quote, part.start, part.length), what);
}

/** Finds the place of an index, from 1 or back from the last, among `count` items. @return false when it has none */
static bool find_place(int64_t number, size_t count, uint32_t *place) {
    const int64_t found = number < 0 ? (int64_t)count + number : number - 1;
    if (number == 0 || found < 0 || found >= (int64_t)count) {
        return false;
    }
    *place = (uint32_t)found;
    return true;
}

/** Splits a corner at its slashes. @return the number of parts, from 1; 4 when there are more than 3 */
static int split_corner(text_token token, text_token parts[3]) {
    int count = 0;
    const char *end = token.start + token.length;
    const char *start = token.start;
    for (const char *at = start;; at++) {
        if (at < end && *at != '/') {
            continue;
        }
        if (count == 3) {
            return 4;
        }
        parts[count].start = start;
        parts[count++].length = (size_t)(at - start);
        if (at == end) {
            return count;
        }
        start = at + 1;
    }
}

static bool is_zero_normal(const double normal[3]) {
    return !(fabs(normal[0]) > 0 || fabs(normal[1]) > 0 || fabs(normal[2]) > 0);
}

static bool read_position_index(obj_reader *reader, text_token part, uint32_t *position) {
    const size_t count = reader->mesh->position_count;
    int64_t number;
    if (!read_index(reader, part, "position", &number)) {
        return false;
    }
    if (!find_place(number, count, position)) {
        char quote[PROBLEM_QUOTE_SIZE];
        return problem_set(reader->problem, reader->text.line, "position index %s is out of range: %zu so far",
                           problem_quote(quote, part.start, part.length), count);
    }
    return true;
}

static bool read_texture_index(obj_reader *reader, text_token token, text_token part, uint32_t *texture) {
    int64_t number;
    uint32_t place;
    if (!read_index(reader, part, "texture", &number)) {
        return false;
    }
    if (find_place(number, reader->mesh->texture_count, &place)) {
        *texture = place + 1;
    } else {
        note(reader, KIND_TEXTURE_INDEX, token);
    }
    return true;
}

static bool read_normal_index(obj_reader *reader, text_token token, text_token part, uint32_t *normal) {
    int64_t number;
    if (!read_index(reader, part, "normal", &number)) {
        return false;
    }
    if (!find_place(number, reader->mesh->normal_count, normal)) {
        note(reader, KIND_NORMAL_INDEX, token);
    } else if (is_zero_normal(reader->mesh->normals[*normal])) {
        *normal = MESH_NO_NORMAL;
    }
    return true;
}

static bool read_corner(obj_reader *reader, text_token token, mesh_corner *corner) {
    text_token parts[3];
    const int count = split_corner(token, parts);
    corner->normal = MESH_NO_NORMAL;
    corner->texture = 0;
    if (count > 3) {
        char quote[PROBLEM_QUOTE_SIZE];
        problem_quote(quote, token.start, token.length);
        return problem_set(reader->problem, reader->text.line, "corner '%s' is not v, v/t, v//n or v/t/n", quote);
    }
    const bool has_texture = count >= 2 && parts[1].length > 0;
    const bool has_normal = count == 3 && parts[2].length > 0;
    if (!read_position_index(reader, parts[0], &corner->position) ||
        (has_texture && !read_texture_index(reader, token, parts[1], &corner->texture)) ||
        (has_normal && !read_normal_index(reader, token, parts[2], &corner->normal))) {
        return false;
    }
    if (parts[count - 1].length == 0) { /* v//n leaves out the texture as it should */
        note(reader, KIND_EMPTY_INDEX, token);
    }
    return true;
}

static bool read_face(obj_reader *reader) {
    static const text_token word = {"f", 1};
    text_token token;
    reader->face_count = 0;
    while (text_next_token(&reader->text, &token)) {
        if (reader->face_count == OBJ_CORNERS_MAX) {
            return problem_set(reader->problem, reader->text.line, "a face of more than %u corners", OBJ_CORNERS_MAX);
        }
        reader->face = memory_grow(reader->face, &reader->face_capacity, reader->face_count, sizeof *reader->face);
        if (!read_corner(reader, token, &reader->face[reader->face_count])) {
            return false;
        }
        reader->face_count++;
    }
    if (reader->face_count < 3) {
        note(reader, KIND_FEW_CORNERS, word);
        return true;
    }
    if (!has_room(reader, reader->mesh->triangle_count + reader->face_count - 3)) {
        return false;
    }
    reader->mesh->face_count++;
    return mesh_add_polygon(reader->mesh, reader->face, reader->face_count) ||
           problem_set(reader->problem, reader->text.line,
                       "faces that are not convex have too many corners: make them triangles first");
}

/** Reads the smoothing group of the faces after it: a number, of which 0 is off. */
static bool read_smoothing(obj_reader *reader) {
    static const text_token word = {"s", 1};
    text_token token = {word.start, 0};
    int64_t group = 0;
    const bool given = text_next_token(&reader->text, &token);
    if (given && text_token_is(token, "off")) {
        reader->mesh->smooth = MESH_FACETED;
    } else if (given && number_integer(token.start, token.length, &group) && group >= 0 && group < UINT32_MAX) {
        reader->mesh->smooth = (uint32_t)(group + MESH_FACETED);
    } else {
        note(reader, KIND_SMOOTHING, word);
    }
    return true;
}

/* ---- Names ------------------------------------------------------------------------------------------------------ */

size_t obj_names_add(obj_names *names, text_token name, size_t line, size_t most) {
    char *text = text_copy(name);
    size_t slot = bytes_hash(text, name.length) % OBJ_NAME_SLOTS;
    while (names->slots[slot] != 0 && strcmp(names->list[names->slots[slot] - 1].text, text) != 0) {
        slot = (slot + 1) % OBJ_NAME_SLOTS;
    }
    if (names->slots[slot] != 0 || names->count == most) {
        free(text);
        return names->slots[slot] != 0 ? names->slots[slot] - 1u : names->count;
    }
    names->list = memory_grow(names->list, &names->capacity, names->count, sizeof *names->list);
    names->list[names->count++] = (obj_name){text, line};
    names->slots[slot] = (uint16_t)names->count;
    return names->count - 1;
}

static bool read_material(obj_reader *reader) {
    obj_names *used = &reader->materials->used;
    const text_token name = text_name(&reader->text);
    const size_t place = obj_names_add(used, name, reader->text.line, OBJ_MATERIALS_MAX);
    reader->mesh->material = (uint32_t)place + 1;
    return place < used->count ||
           problem_set(reader->problem, reader->text.line, "more than %d materials", OBJ_MATERIALS_MAX);
}

static bool read_library(obj_reader *reader) {
    static const text_token word = {"mtllib", 6};
    obj_names *libraries = &reader->materials->libraries;
    const text_token name = text_name(&reader->text);
    if (obj_names_add(libraries, name, reader->text.line, OBJ_LIBRARIES_MAX) == libraries->count) {
        note(reader, KIND_LIBRARIES, word);
    }
    return true;
}

/** Starts the object that the names of the current `o` and `g` make together. */
static bool choose_object(obj_reader *reader) {
    const text_token o = reader->object;
    const text_token g = reader->group;
    const size_t gap = o.length > 0 && g.length > 0;
    char *both = memory_new(o.length + g.length + gap + 1, 1);
    memcpy(both, o.start, o.length);
    memcpy(both + o.length, " ", gap);
    memcpy(both + o.length + gap, g.start, g.length);
    const text_token name = {both, o.length + gap + g.length};
    const size_t place = obj_names_add(&reader->materials->objects, name, reader->text.line, OBJ_OBJECTS_MAX);
    free(both);
    reader->mesh->object = (uint32_t)place + 1;
    reader->mesh->group_count++;
    return true;
}

static bool read_object(obj_reader *reader) {
    reader->object = text_rest_of_line(&reader->text);
    reader->group.length = 0;
    return choose_object(reader);
}

static bool read_group(obj_reader *reader) {
    reader->group = text_rest_of_line(&reader->text);
    return choose_object(reader);
}

void obj_names_free(obj_names *names) {
    for (size_t i = 0; i < names->count; i++) {
        free(names->list[i].text);
    }
    free(names->list);
    memset(names, 0, sizeof *names);
}

void obj_materials_free(obj_materials *materials) {
    obj_names_free(&materials->used);
    obj_names_free(&materials->libraries);
    obj_names_free(&materials->objects);
}

/* ---- Files ------------------------------------------------------------------------------------------------------ */

static const struct obj_statement {
    const char *keyword;
    bool (*read)(obj_reader *reader);
} statements[] = {
    {"v", read_position}, {"vn", read_normal},       {"vt", read_texture},     {"f", read_face},      {"g", read_group},
    {"o", read_object},   {"usemtl", read_material}, {"mtllib", read_library}, {"s", read_smoothing}, {"fo", read_face},
};

/** The format's other keywords (Wavefront, Advanced Visualizer manual, appendix B1), old ones included. */
static const struct obj_skipped {
    const char *keyword;
    int kind;
} skipped[] = {
    {"usemap", KIND_TEXTURE}, {"maplib", KIND_TEXTURE}, {"p", KIND_ELEMENT},       {"l", KIND_ELEMENT},
    {"curv", KIND_ELEMENT},   {"curv2", KIND_ELEMENT},  {"surf", KIND_ELEMENT},    {"bsp", KIND_ELEMENT},
    {"bzp", KIND_ELEMENT},    {"cdc", KIND_ELEMENT},    {"cdp", KIND_ELEMENT},     {"call", KIND_ELEMENT},
    {"csh", KIND_ELEMENT},    {"vp", KIND_NONE},        {"deg", KIND_NONE},        {"bmat", KIND_NONE},
    {"step", KIND_NONE},      {"cstype", KIND_NONE},    {"parm", KIND_NONE},       {"trim", KIND_NONE},
    {"hole", KIND_NONE},      {"scrv", KIND_NONE},      {"sp", KIND_NONE},         {"end", KIND_NONE},
    {"con", KIND_NONE},       {"mg", KIND_NONE},        {"bevel", KIND_NONE},      {"lod", KIND_NONE},
    {"ctech", KIND_NONE},     {"stech", KIND_NONE},     {"shadow_obj", KIND_NONE}, {"trace_obj", KIND_NONE},
    {"c_interp", KIND_NONE},  {"d_interp", KIND_NONE},  {"res", KIND_NONE},
};

/** What a keyword that is not read comes to. */
static int kind_of(text_token keyword) {
    for (size_t i = 0; i < sizeof skipped / sizeof skipped[0]; i++) {
        if (text_token_is(keyword, skipped[i].keyword)) {
            return skipped[i].kind;
        }
    }
    return TEXT_WORD;
}

static bool read_statement(obj_reader *reader) {
    static const text_token zbrush = {"#MRGB", 5};
    text_token keyword;
    if (!text_next_token(&reader->text, &keyword)) {
        if ((size_t)(reader->text.end - keyword.start) > zbrush.length &&
            memcmp(keyword.start, zbrush.start, zbrush.length) == 0) {
            note(reader, KIND_ZBRUSH, zbrush);
        }
        return true;
    }
    for (size_t i = 0; i < sizeof statements / sizeof statements[0]; i++) {
        if (text_token_is(keyword, statements[i].keyword)) {
            return statements[i].read(reader);
        }
    }
    const int kind = kind_of(keyword);
    if (kind != KIND_NONE) {
        note(reader, kind, keyword);
    }
    return true;
}

/** Returns what a file is that begins like this and is no OBJ file, or null. */
static const char *name_other_format(const char *start, size_t length) {
    static const struct {
        const char *bytes;
        size_t size;
        const char *name;
    } formats[] = {
        {"\xFF\xFE", 2, "text in UTF-16: save it as UTF-8 or ASCII"},
        {"\xFE\xFF", 2, "text in UTF-16: save it as UTF-8 or ASCII"},
        {"PK\x03\x04", 4, "a ZIP archive: unpack it first"},
        {"\x1F\x8B", 2, "compressed by gzip: unpack it first"},
        {"glTF", 4, "binary glTF: name it .glb"},
        {"{", 1, "JSON: name it .gltf if it is glTF"},
        {"ply", 3, "PLY: name it .ply"},
        {"solid", 5, "STL: name it .stl"},
        {"OFF", 3, "OFF: name it .off"},
        {"Kaydara FBX", 11, "FBX: name it .fbx"},
        {"<?xml", 5, "XML: name it .dae if it is Collada"},
        {"<!DOCTYPE", 9, "a web page: download the file itself"},
        {"<html", 5, "a web page: download the file itself"},
        {"version https://git-lfs", 23, "a pointer of Git LFS: run git lfs pull"},
        {"\x64\x86", 2, "a compiler's object file"},
        {"\x7F"
         "ELF",
         4, "a compiler's object file"},
        {"\x89PNG", 4, "a picture"},
    };
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        if (length >= formats[i].size && memcmp(start, formats[i].bytes, formats[i].size) == 0) {
            return formats[i].name;
        }
    }
    return NULL;
}

/** Says that there are no faces: by what the file is instead, by the first word that is no keyword, when there is one.
 * @return false */
static bool refuse_without_faces(obj_reader *reader, const char *start) {
    const char *other = name_other_format(start, (size_t)(reader->text.end - start));
    if (other != NULL) {
        return problem_set(reader->problem, 1, "is not an OBJ file: it is %s", other);
    }
    const text_note *few = text_find_note(&reader->notes, KIND_FEW_CORNERS, position_word);
    if (few != NULL) {
        return problem_set(reader->problem, few->line, "no face has 3 or more corners");
    }
    for (size_t i = 0; i < reader->notes.count; i++) {
        const text_note *notice = &reader->notes.list[i];
        if (notice->kind == TEXT_WORD) {
            char quote[PROBLEM_QUOTE_SIZE];
            return problem_set(reader->problem, notice->line, "'%s' is not an OBJ keyword",
                               problem_quote(quote, notice->word.start, notice->word.length));
        }
    }
    return problem_set(reader->problem, reader->text.line, "no faces");
}

bool obj_read(const char *text, size_t length, host_mesh *mesh, obj_materials *materials, host_warnings *warnings,
              host_problem *problem) {
    memset(mesh, 0, sizeof *mesh);
    memset(materials, 0, sizeof *materials);
    warnings->count = 0;
    obj_reader reader = {.text = text_begin(text, length), .mesh = mesh, .materials = materials, .problem = problem};
    reader.object = reader.group = (text_token){text, 0};
    reader.notes.words_max = WORDS_MAX;
    bool ok = true;
    while (ok && reader.text.at < reader.text.end) {
        ok = read_statement(&reader);
        if (ok) {
            text_skip_statement(&reader.text);
        }
    }
    ok = ok && (mesh->triangle_count > 0 || refuse_without_faces(&reader, text));
    if (ok) {
        keep_colours(&reader);
        text_notes_write(&reader.notes, note_texts, warnings);
    }
    free(reader.colours);
    free(reader.face);
    if (!ok) {
        mesh_free(mesh);
        obj_materials_free(materials);
    }
    return ok;
}
