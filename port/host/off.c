/* SPDX-License-Identifier: MIT */
/**
 * @file off.c
 * OFF as Geomview has it, text only: ST, C, N and 4 before the word name what a vertex has beside its place; a face may
 * have a colour behind its corners.
 */
#include "reader.h"

#include "values.h"

#include <stdlib.h>
#include <string.h>

typedef struct off_reader {
    model_reader *base;
    text_reader text;
    bool has_colours, has_normals, has_fourth;
    bool warned; /* of colours by number */
    uint32_t (*vertices)[2];
    size_t vertex_count, vertex_capacity;
} off_reader;

/** Moves to the next line that holds something, and reads its first token. */
static bool next_line(off_reader *reader, text_token *token) {
    return reader_next_token(reader->base, &reader->text, token);
}

static bool read_count(off_reader *reader, text_token token, size_t *count) {
    char quote[PROBLEM_QUOTE_SIZE];
    int64_t number;
    if (!number_integer(token.start, token.length, &number) || number < 0) {
        return reader_fail(reader->base, "'%s' is not a count", problem_quote(quote, token.start, token.length));
    }
    *count = (size_t)number;
    return true;
}

/** Reads the word that begins the file, if there is one, and the counts of vertices, faces and edges. */
static bool read_header(off_reader *reader, size_t *vertices, size_t *faces) {
    text_token token;
    size_t edges;
    if (!next_line(reader, &token)) {
        return false;
    }
    if (token.length >= 3 && memcmp(token.start + token.length - 3, "OFF", 3) == 0) {
        for (size_t i = 0; i + 3 < token.length; i++) {
            const char letter = token.start[i];
            reader->has_colours = reader->has_colours || letter == 'C';
            reader->has_normals = reader->has_normals || letter == 'N';
            reader->has_fourth = reader->has_fourth || letter == '4';
            if (letter == 'n') {
                return reader_fail(reader->base, "OFF of more than 3 dimensions is not read");
            }
        }
        if (!next_line(reader, &token)) {
            return false;
        }
    }
    if (reader_token_is(token, "BINARY")) {
        return reader_fail(reader->base, "binary OFF is not read: take text");
    }
    return read_count(reader, token, vertices) && next_line(reader, &token) && read_count(reader, token, faces) &&
           (!text_next_token(&reader->text, &token) || read_count(reader, token, &edges));
}

/**
 * Reads the numbers that are left of the line, at most `most`.
 * @param whole set when all are integers: colours are then of 255
 * @return how many, or -1 with a problem
 */
static int read_numbers(off_reader *reader, double *values, int most, bool *whole) {
    text_token token;
    int count = 0;
    *whole = true;
    while (count < most && text_next_token(&reader->text, &token)) {
        int64_t integer;
        if (!reader_number(reader->base, token, &values[count])) {
            return -1;
        }
        *whole = *whole && number_integer(token.start, token.length, &integer);
        count++;
    }
    return count;
}

/** Makes channels from 0 to 1 of 3 or 4 numbers, the fourth of which is alpha. */
static void scale_colour(off_reader *reader, double *colour, int count, bool whole) {
    for (int i = 0; i < count; i++) {
        colour[i] /= whole ? 255 : 1;
    }
    reader->base->see_through = reader->base->see_through || (count == 4 && colour[3] < 1);
}

static bool read_vertex(off_reader *reader) {
    double values[3 + 1 + 3 + 4] = {0};
    double *colour = NULL;
    text_token token;
    bool whole;
    if (!next_line(reader, &token) || !reader_number(reader->base, token, &values[0])) {
        return false;
    }
    int count = 3 + (reader->has_fourth ? 1 : 0) + (reader->has_normals ? 3 : 0);
    int got = read_numbers(reader, values + 1, count - 1, &whole);
    if (got >= 0 && got < count - 1) {
        return reader_fail(reader->base, "a vertex takes %d numbers, here are %d", count, got + 1);
    }
    if (got >= 0 && reader->has_colours) {
        got = read_numbers(reader, values + count, 4, &whole);
        if (got >= 3) {
            colour = values + count;
            scale_colour(reader, colour, got, whole);
        }
    }
    text_skip_statement(&reader->text);
    if (reader->has_fourth) {
        for (int axis = 0; axis < 3; axis++) {
            values[axis] /= values[3];
        }
    }
    if (got < 0 || !reader_add_position(reader->base, values, colour)) {
        return false;
    }
    reader->vertices =
        memory_grow(reader->vertices, &reader->vertex_capacity, reader->vertex_count, sizeof *reader->vertices);
    uint32_t *vertex = reader->vertices[reader->vertex_count++];
    vertex[0] = (uint32_t)reader->base->mesh->position_count - 1;
    vertex[1] = reader->has_normals ? reader_add_normal(reader->base, values + count - 3) : MESH_NO_NORMAL;
    return true;
}

/** Reads the colour behind a face's corners. @return 1 when there is one, 0 for none, -1 with a problem */
static int read_colour(off_reader *reader, double colour[4]) {
    bool whole;
    const int count = read_numbers(reader, colour, 4, &whole);
    if (count > 0 && count < 3 && !reader->warned) {
        reader_warn(reader->base, "colours by their number in a map are skipped");
        reader->warned = true;
    }
    if (count >= 3) {
        scale_colour(reader, colour, count, whole);
    }
    return count < 0 ? -1 : count >= 3;
}

static bool read_face(off_reader *reader) {
    model_reader *base = reader->base;
    double colour[4];
    text_token token;
    size_t count;
    if (!next_line(reader, &token) || !read_count(reader, token, &count)) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        char quote[PROBLEM_QUOTE_SIZE];
        int64_t number;
        if (!next_line(reader, &token)) {
            return false;
        }
        if (!number_integer(token.start, token.length, &number) || number < 0 ||
            (uint64_t)number >= reader->vertex_count) {
            return reader_fail(base, "'%s' is not one of %zu vertices", problem_quote(quote, token.start, token.length),
                               reader->vertex_count);
        }
        const uint32_t *vertex = reader->vertices[number];
        reader_add_corner(base, (mesh_corner){vertex[0], vertex[1], 0});
    }
    const int own = read_colour(reader, colour);
    text_skip_statement(&reader->text);
    if (own > 0 && !reader->has_colours && !reader_colour_face(base, colour)) {
        return false;
    }
    return own >= 0 && reader_end_face(base, false);
}

bool off_read(model_reader *base) {
    off_reader reader = {.base = base, .text = text_begin((const char *)base->data, base->size)};
    size_t vertices = 0;
    size_t faces = 0;
    base->line = 1;
    bool ok = read_header(&reader, &vertices, &faces);
    text_skip_statement(&reader.text);
    for (size_t i = 0; ok && i < vertices; i++) {
        ok = read_vertex(&reader);
    }
    for (size_t i = 0; ok && i < faces; i++) {
        ok = read_face(&reader);
    }
    free(reader.vertices);
    return ok;
}
