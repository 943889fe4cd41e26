/* SPDX-License-Identifier: MIT */
/**
 * @file reader.c
 * Has what readers of STL, PLY, OFF and glTF share, and finds which of them a file's name asks for.
 */
#define _XOPEN_SOURCE 700 /* POSIX of 2008: strcasecmp, strncasecmp */

#include "reader.h"

#include "values.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

bool reader_fail(model_reader *reader, const char *format, ...) {
    char text[sizeof reader->problem->text];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return problem_set(reader->problem, reader->line, "%s", text);
}

void reader_warn(model_reader *reader, const char *format, ...) {
    char text[sizeof reader->problem->text - sizeof "warning: "];
    host_warnings *warnings = reader->warnings;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (warnings->count < PROBLEM_WARNINGS_MAX) {
        problem_set(&warnings->list[warnings->count++], reader->line, "warning: %s", text);
    }
}

/* ---- The mesh --------------------------------------------------------------------------------------------------- */

static bool has_room(model_reader *reader, size_t count) {
    return count < OBJ_ITEMS_MAX ||
           reader_fail(reader, "more than the %u positions, normals or triangles that are read", OBJ_ITEMS_MAX);
}

static uint8_t level(double channel) {
    return (uint8_t)lround(255 * (channel > 0 ? fmin(channel, 1) : 0));
}

bool reader_add_position(model_reader *reader, const double position[3], const double *colour) {
    static const double white[3] = {1, 1, 1};
    host_mesh *mesh = reader->mesh;
    const double *own = colour != NULL ? colour : white;
    if (!has_room(reader, mesh->position_count)) {
        return false;
    }
    bool fits = true;
    for (int axis = 0; axis < 3; axis++) {
        fits = fits && fabs(position[axis]) <= OBJ_COORDINATE_MAX;
        reader->coloured = reader->coloured || level(own[axis]) < 255;
    }
    reader->unfit = memory_grow(reader->unfit, &reader->unfit_capacity, mesh->position_count, sizeof *reader->unfit);
    reader->unfit[mesh->position_count] = !fits;
    mesh_add_position(mesh, fits ? position[0] : 0, fits ? position[1] : 0, fits ? position[2] : 0);
    mesh_add_colour(mesh, level(own[0]), level(own[1]), level(own[2]));
    return true;
}

uint32_t reader_add_normal(model_reader *reader, const double normal[3]) {
    const double sum = fabs(normal[0]) + fabs(normal[1]) + fabs(normal[2]);
    if (!(sum > 0) || !isfinite(sum)) {
        return MESH_NO_NORMAL;
    }
    return mesh_add_normal(reader->mesh, normal[0], normal[1], normal[2]);
}

void reader_add_corner(model_reader *reader, mesh_corner corner) {
    reader->face = memory_grow(reader->face, &reader->face_capacity, reader->face_count, sizeof *reader->face);
    reader->face[reader->face_count++] = corner;
}

bool reader_colour_face(model_reader *reader, const double colour[3]) {
    for (size_t i = 0; i < reader->face_count; i++) {
        const uint32_t from = reader->face[i].position;
        const double *shared = reader->mesh->positions[from];
        const double position[3] = {shared[0], shared[1], shared[2]};
        const size_t to = reader->mesh->position_count;
        if (!reader_add_position(reader, position, colour)) {
            return false;
        }
        reader->unfit[to] = reader->unfit[from];
        reader->face[i].position = (uint32_t)to;
    }
    return true;
}

bool reader_end_face(model_reader *reader, bool flat) {
    host_mesh *mesh = reader->mesh;
    const size_t count = reader->face_count;
    const size_t before = mesh->triangle_count;
    reader->face_count = 0;
    if (count < 3) {
        reader->thin_count++;
        return true;
    }
    if (count > OBJ_CORNERS_MAX) {
        return reader_fail(reader, "a face of more than %u corners", OBJ_CORNERS_MAX);
    }
    if (!has_room(reader, mesh->triangle_count + count - 3)) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        if (reader->unfit[reader->face[i].position]) {
            return reader_fail(reader, "a corner's coordinates are not finite, or above %.0e", OBJ_COORDINATE_MAX);
        }
    }
    mesh->face_count++;
    if (!mesh_add_polygon(mesh, reader->face, count)) {
        return reader_fail(reader, "faces that are not convex have too many corners: make them triangles first");
    }
    for (size_t i = before; flat && i < mesh->triangle_count; i++) {
        double own[3];
        mesh_triangle_normal(mesh, i, own);
        const uint32_t normal = reader_add_normal(reader, own);
        for (int corner = 0; corner < 3; corner++) {
            mesh->triangles[i][corner].normal = normal;
        }
    }
    return true;
}

void reader_start_object(model_reader *reader, const char *name, size_t length) {
    const text_token token = {name, length};
    const size_t place = obj_names_add(&reader->materials->objects, token, reader->line, OBJ_OBJECTS_MAX);
    reader->mesh->object = (uint32_t)place + 1;
    reader->mesh->group_count++;
}

/* ---- Tokens and numbers ----------------------------------------------------------------------------------------- */

text_token reader_rest_of_line(text_reader *text) {
    text_token rest = {text->at, 0};
    while (text->at < text->end && *text->at != '\n' && *text->at != '\r') {
        text->at++;
    }
    while (rest.start < text->at && (*rest.start == ' ' || *rest.start == '\t')) {
        rest.start++;
    }
    rest.length = (size_t)(text->at - rest.start);
    while (rest.length > 0 && (rest.start[rest.length - 1] == ' ' || rest.start[rest.length - 1] == '\t')) {
        rest.length--;
    }
    return rest;
}

bool reader_token_is(text_token token, const char *word) {
    return strlen(word) == token.length && strncasecmp(token.start, word, token.length) == 0;
}

bool reader_number(model_reader *reader, text_token token, double *value) {
    char quote[PROBLEM_QUOTE_SIZE];
    text_token word = token;
    if (number_real(token.start, token.length, value)) {
        return true;
    }
    if (word.length > 0 && (*word.start == '-' || *word.start == '+')) {
        word.start++;
        word.length--;
    }
    *value = NAN;
    return (word.length >= 3 && (strncasecmp(word.start, "nan", 3) == 0 || strncasecmp(word.start, "inf", 3) == 0)) ||
           reader_fail(reader, "'%s' is not a number", problem_quote(quote, token.start, token.length));
}

bool reader_next_token(model_reader *reader, text_reader *text, text_token *token) {
    while (!text_next_token(text, token)) {
        if (text->at == text->end) {
            reader->line = text->line;
            return reader_fail(reader, "the file is cut off: it ends within an element");
        }
        text_skip_statement(text);
    }
    reader->line = text->line;
    return true;
}

uint64_t reader_unsigned(const uint8_t *bytes, size_t size) {
    uint64_t value = 0;
    for (size_t i = size; i-- > 0;) {
        value = value << 8 | bytes[i];
    }
    return value;
}

double reader_float(const uint8_t *bytes) {
    const uint32_t bits = (uint32_t)reader_unsigned(bytes, 4);
    float value;
    memcpy(&value, &bits, sizeof value);
    return (double)value;
}

/* ---- Files ------------------------------------------------------------------------------------------------------ */

static const struct format {
    const char *ending;
    bool (*read)(model_reader *reader);
} formats[] = {{".stl", stl_read}, {".ply", ply_read}, {".off", off_read}, {".gltf", gltf_read}, {".glb", gltf_read}};

static const struct format *find_format(const char *name) {
    const char *dot = strrchr(path_base_name(name), '.');
    for (size_t i = 0; dot != NULL && i < sizeof formats / sizeof formats[0]; i++) {
        if (strcasecmp(dot, formats[i].ending) == 0) {
            return &formats[i];
        }
    }
    return NULL;
}

bool reader_takes(const char *name) {
    return find_format(name) != NULL;
}

bool reader_load(const char *name, const host_bytes *file, host_mesh *mesh, host_materials *materials,
                 host_warnings *warnings, host_problem *problem) {
    model_reader reader = {.path = name, .data = file->data, .size = file->count, .mesh = mesh};
    reader.materials = materials;
    reader.warnings = warnings;
    reader.problem = problem;
    memset(mesh, 0, sizeof *mesh);
    memset(materials, 0, sizeof *materials);
    warnings->count = 0;
    const bool ok =
        find_format(name)->read(&reader) && (mesh->triangle_count > 0 || problem_set(problem, 0, "no faces"));
    reader.line = 0;
    if (ok && reader.thin_count > 0) {
        reader_warn(&reader, "faces of fewer than 3 corners are skipped (%zu)", reader.thin_count);
    }
    if (ok && reader.see_through) {
        reader_warn(&reader, "transparency of colours is not drawn");
    }
    free(reader.unfit);
    free(reader.face);
    if (!ok) {
        materials_free(materials);
        mesh_free(mesh);
        return false;
    }
    if (!reader.coloured) { /* white changes no pixel, and would cost flash and time */
        free(mesh->colours);
        mesh->colours = NULL;
        mesh->colour_count = mesh->colour_capacity = 0;
    }
    mesh_join(mesh, 0);
    return true;
}
