/* SPDX-License-Identifier: MIT */
/**
 * @file ply.c
 * PLY, as text and binary of either byte order: vertices and faces with colours and texture coordinates, normals,
 * and triangle strips. Properties by other names change no pixel and are skipped.
 */
#include "reader.h"

#include "values.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Most elements, and most properties of an element. */
#define ELEMENTS_MAX 32
#define PROPERTIES_MAX 128

/** A property is read for one of these: a channel of a vertex or a face, or its corners. */
enum {
    USE_X,
    USE_Y,
    USE_Z,
    USE_NX,
    USE_NY,
    USE_NZ,
    USE_S,
    USE_T,
    USE_RED,
    USE_GREEN,
    USE_BLUE,
    USE_ALPHA,
    USE_COUNT,
    USE_CORNERS,
    USE_TEXTURES
};

typedef struct ply_type {
    const char *names[2];
    size_t size;
    char kind;   /* i for integers, u for unsigned ones, f for floating point */
    double full; /* the level of a colour that counts as 1 */
} ply_type;

static const ply_type types[] = {
    {{"char", "int8"}, 1, 'i', 127},          {{"uchar", "uint8"}, 1, 'u', 255},
    {{"short", "int16"}, 2, 'i', 32767},      {{"ushort", "uint16"}, 2, 'u', 65535},
    {{"int", "int32"}, 4, 'i', 2147483647.0}, {{"uint", "uint32"}, 4, 'u', 4294967295.0},
    {{"long", "int64"}, 8, 'i', 1},           {{"ulong", "uint64"}, 8, 'u', 1},
    {{"float", "float32"}, 4, 'f', 1},        {{"double", "float64"}, 8, 'f', 1},
};

typedef struct ply_property {
    const ply_type *type;
    const ply_type *count_type; /* of a list's count; null for a single number */
    int use;                    /* USE_COUNT for none */
} ply_property;

typedef struct ply_element {
    text_token name;
    uint64_t count;
    ply_property properties[PROPERTIES_MAX];
    size_t property_count;
    bool has[USE_TEXTURES + 1]; /* which uses its properties have */
} ply_element;

typedef struct ply_reader {
    model_reader *base;
    text_reader text; /* the header, and the body of text */
    const uint8_t *at, *end;
    bool is_binary, is_big_endian;
    ply_element *elements;
    size_t element_count;
    mesh_corner *vertices;
    size_t vertex_count, vertex_capacity;
    int64_t *list; /* the corners that were read last */
    size_t list_count, list_capacity;
    double *places; /* and their texture coordinates */
    size_t place_count, place_capacity;
} ply_reader;

/* ---- Header ----------------------------------------------------------------------------------------------------- */

static const ply_type *find_type(ply_reader *reader, text_token name) {
    char quote[PROBLEM_QUOTE_SIZE];
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
        if (text_token_is(name, types[i].names[0]) || text_token_is(name, types[i].names[1])) {
            return &types[i];
        }
    }
    reader_fail(reader->base, "'%s' is not a type of PLY", problem_quote(quote, name.start, name.length));
    return NULL;
}

static int find_use(text_token name, bool is_list) {
    static const char *const names[][4] = {
        [USE_X] = {"x"},
        [USE_Y] = {"y"},
        [USE_Z] = {"z"},
        [USE_NX] = {"nx", "normal_x"},
        [USE_NY] = {"ny", "normal_y"},
        [USE_NZ] = {"nz", "normal_z"},
        [USE_S] = {"s", "u", "texture_u"},
        [USE_T] = {"t", "v", "texture_v"},
        [USE_RED] = {"red", "r", "diffuse_red"},
        [USE_GREEN] = {"green", "g", "diffuse_green"},
        [USE_BLUE] = {"blue", "b", "diffuse_blue"},
        [USE_ALPHA] = {"alpha", "a", "diffuse_alpha"},
    };
    if (is_list) {
        return text_token_is(name, "vertex_indices") || text_token_is(name, "vertex_index") ? USE_CORNERS
               : text_token_is(name, "texcoord")                                            ? USE_TEXTURES
                                                                                            : USE_COUNT;
    }
    for (int use = 0; use < USE_COUNT; use++) {
        for (int i = 0; i < 4 && names[use][i] != NULL; i++) {
            if (text_token_is(name, names[use][i])) {
                return use;
            }
        }
    }
    return USE_COUNT;
}

/** The next token of a header's line. @return false with a problem when the line has no more */
static bool next_word(ply_reader *reader, text_token *token) {
    return text_next_token(&reader->text, token) || reader_fail(reader->base, "the header's line is cut off");
}

static bool read_format(ply_reader *reader) {
    text_token word;
    if (!next_word(reader, &word)) {
        return false;
    }
    char quote[PROBLEM_QUOTE_SIZE];
    reader->is_big_endian = text_token_is(word, "binary_big_endian");
    reader->is_binary = reader->is_big_endian || text_token_is(word, "binary_little_endian");
    return reader->is_binary || text_token_is(word, "ascii") ||
           reader_fail(reader->base, "'%s' is not a format of PLY", problem_quote(quote, word.start, word.length));
}

static bool read_element(ply_reader *reader) {
    text_token count;
    int64_t number;
    if (reader->element_count == ELEMENTS_MAX) {
        return reader_fail(reader->base, "more than %d elements", ELEMENTS_MAX);
    }
    ply_element *element = &reader->elements[reader->element_count++];
    if (!next_word(reader, &element->name) || !next_word(reader, &count)) {
        return false;
    }
    char quote[PROBLEM_QUOTE_SIZE];
    if (!number_integer(count.start, count.length, &number) || number < 0) {
        return reader_fail(reader->base, "'%s' is not a count", problem_quote(quote, count.start, count.length));
    }
    element->count = (uint64_t)number;
    return true;
}

static bool read_property(ply_reader *reader) {
    text_token word;
    if (!next_word(reader, &word)) {
        return false;
    }
    if (reader->element_count == 0) {
        return reader_fail(reader->base, "a property before any element");
    }
    ply_element *element = &reader->elements[reader->element_count - 1];
    if (element->property_count == PROPERTIES_MAX) {
        return reader_fail(reader->base, "more than %d properties of an element", PROPERTIES_MAX);
    }
    ply_property *property = &element->properties[element->property_count++];
    const bool is_list = text_token_is(word, "list");
    property->count_type = NULL;
    if (is_list && (!next_word(reader, &word) || (property->count_type = find_type(reader, word)) == NULL ||
                    !next_word(reader, &word))) {
        return false;
    }
    property->type = find_type(reader, word);
    if (property->type == NULL || !next_word(reader, &word)) {
        return false;
    }
    property->use = find_use(word, is_list);
    element->has[property->use] = true;
    return true;
}

/** Reads the name of the picture: MeshLab writes it into a comment. */
static void read_comment(ply_reader *reader) {
    mtl_texture *texture = &reader->base->materials->bare;
    text_token word;
    if (text_next_token(&reader->text, &word) && reader_token_is(word, "TextureFile")) {
        const text_token name = reader_rest_of_line(&reader->text);
        mtl_set_texture(texture, name.start, name.length);
        texture->line = reader->text.line;
    }
}

static bool read_header(ply_reader *reader) {
    text_token word = {NULL, 0};
    if (!text_next_token(&reader->text, &word) || !text_token_is(word, "ply")) {
        return reader_fail(reader->base, "the file does not begin with 'ply'");
    }
    while (reader->text.at < reader->text.end) {
        bool ok = true;
        reader_rest_of_line(&reader->text);
        text_skip_statement(&reader->text);
        reader->base->line = reader->text.line;
        if (!text_next_token(&reader->text, &word)) {
            continue;
        }
        if (text_token_is(word, "end_header")) {
            return true;
        }
        if (text_token_is(word, "format")) {
            ok = read_format(reader);
        } else if (text_token_is(word, "element")) {
            ok = read_element(reader);
        } else if (text_token_is(word, "property")) {
            ok = read_property(reader);
        } else if (text_token_is(word, "comment")) {
            read_comment(reader);
        }
        if (!ok) {
            return false;
        }
    }
    return reader_fail(reader->base, "the file is cut off: its header has no end");
}

/* ---- Values ----------------------------------------------------------------------------------------------------- */

/** The number in a binary file's bytes, least significant byte first. */
static double decode(const ply_type *type, const uint8_t *bytes) {
    const uint64_t bits = reader_unsigned(bytes, type->size);
    if (type->kind == 'f') {
        double value;
        memcpy(&value, &bits, sizeof value);
        return type->size == 4 ? reader_float(bytes) : value;
    }
    const uint64_t sign = (uint64_t)1 << (8 * type->size - 1);
    if (type->kind == 'u' || (bits & sign) == 0) {
        return (double)bits;
    }
    return -(double)((~bits & (sign - 1)) + 1);
}

/** Reads a number. @param value set, or null where it is skipped, and may then be any word */
static bool read_value(ply_reader *reader, const ply_type *type, double *value) {
    if (!reader->is_binary) {
        text_token token;
        return reader_next_token(reader->base, &reader->text, &token) &&
               (value == NULL || reader_number(reader->base, token, value));
    }
    if ((size_t)(reader->end - reader->at) < type->size) {
        return reader_fail(reader->base, "the file is cut off: it ends within an element");
    }
    uint8_t bytes[8];
    for (size_t i = 0; i < type->size; i++) {
        bytes[i] = reader->at[reader->is_big_endian ? type->size - 1 - i : i];
    }
    reader->at += type->size;
    if (value != NULL) {
        *value = decode(type, bytes);
    }
    return true;
}

/** Keeps a number of a list: of a corner, or of its texture coordinates. */
static void keep_number(ply_reader *reader, int use, double value) {
    if (use == USE_CORNERS) {
        reader->list = memory_grow(reader->list, &reader->list_capacity, reader->list_count, sizeof *reader->list);
        reader->list[reader->list_count++] = fabs(value) <= 4294967295.0 ? (int64_t)value : INT64_MIN;
    } else {
        reader->places =
            memory_grow(reader->places, &reader->place_capacity, reader->place_count, sizeof *reader->places);
        reader->places[reader->place_count++] = value;
    }
}

static bool read_list(ply_reader *reader, const ply_property *property) {
    const bool kept = property->use > USE_COUNT;
    double count;
    double value;
    if (!read_value(reader, property->count_type, &count)) {
        return false;
    }
    if (!(count >= 0 && count <= 4294967295.0)) {
        return reader_fail(reader->base, "a list of %g numbers", count);
    }
    reader->list_count = property->use == USE_CORNERS ? 0 : reader->list_count;
    reader->place_count = property->use == USE_TEXTURES ? 0 : reader->place_count;
    for (uint64_t i = 0; i < (uint64_t)count; i++) {
        if (!read_value(reader, property->type, kept ? &value : NULL)) {
            return false;
        }
        if (kept) {
            keep_number(reader, property->use, value);
        }
    }
    return true;
}

static bool has_colours(const ply_element *element) {
    return element->has[USE_RED] && element->has[USE_GREEN] && element->has[USE_BLUE];
}

/** Reads the next one of an element: its numbers by use, and its list of corners. */
static bool read_item(ply_reader *reader, const ply_element *element, double values[USE_COUNT]) {
    reader->list_count = reader->place_count = 0;
    for (size_t i = 0; i < element->property_count; i++) {
        const ply_property *property = &element->properties[i];
        double *value = property->use < USE_COUNT ? &values[property->use] : NULL;
        if (property->count_type != NULL ? !read_list(reader, property) : !read_value(reader, property->type, value)) {
            return false;
        }
        if (property->count_type == NULL && property->use >= USE_RED && value != NULL) {
            *value /= property->type->full;
        }
    }
    reader->base->see_through =
        reader->base->see_through || (has_colours(element) && element->has[USE_ALPHA] && values[USE_ALPHA] < 1);
    return true;
}

/* ---- Elements --------------------------------------------------------------------------------------------------- */

static bool read_vertices(ply_reader *reader, const ply_element *element) {
    const bool has_normals = element->has[USE_NX] && element->has[USE_NY] && element->has[USE_NZ];
    const bool has_textures = element->has[USE_S] && element->has[USE_T];
    if (!element->has[USE_X] || !element->has[USE_Y] || !element->has[USE_Z]) {
        return reader_fail(reader->base, "vertices without x, y and z");
    }
    for (uint64_t i = 0; i < element->count; i++) {
        double values[USE_COUNT] = {0};
        if (!read_item(reader, element, values) ||
            !reader_add_position(reader->base, values, has_colours(element) ? values + USE_RED : NULL)) {
            return false;
        }
        reader->vertices =
            memory_grow(reader->vertices, &reader->vertex_capacity, reader->vertex_count, sizeof *reader->vertices);
        mesh_corner *vertex = &reader->vertices[reader->vertex_count++];
        vertex->position = (uint32_t)reader->base->mesh->position_count - 1;
        vertex->normal = has_normals ? reader_add_normal(reader->base, values + USE_NX) : MESH_NO_NORMAL;
        vertex->texture = has_textures ? mesh_add_texture(reader->base->mesh, values[USE_S], 1 - values[USE_T]) : 0;
    }
    return true;
}

static bool add_corner(ply_reader *reader, int64_t number) {
    if (number < 0 || (uint64_t)number >= reader->vertex_count) {
        return reader_fail(reader->base, "a face names vertex %lld of %zu", (long long)number, reader->vertex_count);
    }
    reader_add_corner(reader->base, reader->vertices[number]);
    return true;
}

static bool read_faces(ply_reader *reader, const ply_element *element, bool coloured) {
    for (uint64_t i = 0; i < element->count; i++) {
        double values[USE_COUNT] = {0};
        if (!read_item(reader, element, values)) {
            return false;
        }
        for (size_t j = 0; j < reader->list_count; j++) {
            if (!add_corner(reader, reader->list[j])) {
                return false;
            }
            if (reader->place_count == 2 * reader->list_count) {
                const double *at = reader->places + 2 * j;
                reader->base->face[j].texture = mesh_add_texture(reader->base->mesh, at[0], 1 - at[1]);
            }
        }
        if ((coloured && !reader_colour_face(reader->base, values + USE_RED)) ||
            !reader_end_face(reader->base, false)) {
            return false;
        }
    }
    return true;
}

/** Reads strips: each corner from the third on makes a triangle with the two before it, and -1 begins again. */
static bool read_strips(ply_reader *reader, const ply_element *element) {
    for (uint64_t i = 0; i < element->count; i++) {
        double values[USE_COUNT] = {0};
        size_t start = 0;
        if (!read_item(reader, element, values)) {
            return false;
        }
        for (size_t j = 0; j < reader->list_count; j++) {
            const int64_t *list = reader->list + j;
            if (*list == -1) {
                start = j + 1;
                continue;
            }
            if (j < start + 2 || list[-2] == list[-1] || list[-1] == list[0] || list[-2] == list[0]) {
                continue;
            }
            const size_t odd = (j - start) % 2;
            if (!add_corner(reader, list[odd ? -1 : -2]) || !add_corner(reader, list[odd ? -2 : -1]) ||
                !add_corner(reader, list[0]) || !reader_end_face(reader->base, false)) {
                return false;
            }
        }
    }
    return true;
}

static bool skip_element(ply_reader *reader, const ply_element *element) {
    char quote[PROBLEM_QUOTE_SIZE];
    for (uint64_t i = 0; i < element->count && element->property_count > 0; i++) {
        double values[USE_COUNT] = {0};
        if (!read_item(reader, element, values)) {
            return false;
        }
    }
    if (element->count > 0) {
        reader_warn(reader->base, "the elements '%s' are skipped",
                    problem_quote(quote, element->name.start, element->name.length));
    }
    return true;
}

static bool read_body(ply_reader *reader) {
    bool vertices_coloured = false;
    for (size_t i = 0; i < reader->element_count; i++) {
        const ply_element *element = &reader->elements[i];
        const bool corners = element->has[USE_CORNERS];
        bool ok;
        if (text_token_is(element->name, "vertex")) {
            vertices_coloured = vertices_coloured || has_colours(element);
            ok = read_vertices(reader, element);
        } else if (text_token_is(element->name, "face") && corners) {
            if (vertices_coloured && has_colours(element)) {
                reader_warn(reader->base, "colours of faces are skipped: vertices have some");
            }
            ok = read_faces(reader, element, has_colours(element) && !vertices_coloured);
        } else if (text_token_is(element->name, "tristrips") && corners) {
            ok = read_strips(reader, element);
        } else {
            ok = skip_element(reader, element);
        }
        if (!ok) {
            return false;
        }
    }
    return reader->base->mesh->triangle_count > 0 ||
           reader_fail(reader->base, reader->vertex_count > 0 ? "no faces: a cloud of points" : "no faces");
}

bool ply_read(model_reader *base) {
    ply_reader reader = {.base = base, .text = text_begin((const char *)base->data, base->size)};
    reader.elements = memory_new(ELEMENTS_MAX, sizeof *reader.elements);
    base->line = 1;
    bool ok = read_header(&reader);
    if (ok) {
        if (reader.is_binary) {
            base->line = 0;
        }
        /* The header's last line ends by LF, CR or CR LF; in a binary file the body begins right behind it. */
        text_skip_statement(&reader.text);
        reader.at = (const uint8_t *)reader.text.at;
        reader.end = base->data + base->size;
        ok = read_body(&reader);
    }
    free(reader.elements);
    free(reader.vertices);
    free(reader.list);
    free(reader.places);
    return ok;
}
