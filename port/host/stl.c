/* SPDX-License-Identifier: MIT */
/**
 * @file stl.c
 * STL, as text and binary, with the colours of VisCAM and Magics in the two bytes behind a facet. A facet's normal is
 * found from its vertices: the stored one is often zero, and says nothing else when it is right.
 */
#include "reader.h"

#include <string.h>

/** Bytes before the count of facets, before the facets, and of a facet. */
#define HEADER_SIZE 80
#define FACETS_AT 84
#define FACET_SIZE 50

/* ---- Text ------------------------------------------------------------------------------------------------------- */

/** Reads three coordinates and adds them as a corner of the face. */
static bool read_vertex(model_reader *reader, text_reader *text) {
    double position[3];
    for (int axis = 0; axis < 3; axis++) {
        text_token token;
        if (!reader_next_token(reader, text, &token) || !reader_number(reader, token, &position[axis])) {
            return false;
        }
    }
    if (!reader_add_position(reader, position, NULL)) {
        return false;
    }
    reader_add_corner(reader, (mesh_corner){(uint32_t)reader->mesh->position_count - 1, MESH_NO_NORMAL, 0});
    return true;
}

/** Reads what follows the word `facet`, up to `endfacet`. */
static bool read_facet(model_reader *reader, text_reader *text) {
    text_token token;
    while (reader_next_token(reader, text, &token)) {
        if (reader_token_is(token, "vertex")) {
            if (!read_vertex(reader, text)) {
                return false;
            }
        } else if (reader_token_is(token, "endfacet")) {
            return reader_end_face(reader, true);
        } else if (reader_token_is(token, "facet") || reader_token_is(token, "endsolid")) {
            return reader_fail(reader, "a facet without endfacet before it");
        }
    }
    return false;
}

static bool read_text(model_reader *reader) {
    text_reader text = text_begin((const char *)reader->data, reader->size);
    bool inside = false;
    size_t empty_count = 0;
    size_t before = 0;
    text_token token;
    while (text.at < text.end) {
        if (!text_next_token(&text, &token)) {
            text_skip_statement(&text);
            continue;
        }
        reader->line = text.line;
        if (reader_token_is(token, "solid")) {
            const text_token rest = reader_rest_of_line(&text);
            reader_start_object(reader, rest.start, rest.length);
            inside = true;
            before = reader->mesh->triangle_count;
        } else if (reader_token_is(token, "endsolid") || reader_token_is(token, "end")) {
            reader_rest_of_line(&text);
            empty_count += reader->mesh->triangle_count == before;
            inside = false;
        } else if (!reader_token_is(token, "facet")) {
            char quote[PROBLEM_QUOTE_SIZE];
            return reader_fail(reader, "'%s' is not a keyword of STL", problem_quote(quote, token.start, token.length));
        } else if (!read_facet(reader, &text)) {
            return false;
        }
    }
    if (inside && reader->mesh->triangle_count > 0) {
        reader_warn(reader, "the file ends without endsolid: it may be cut off");
    }
    reader->line = 0;
    if (empty_count > 0 && reader->mesh->triangle_count > 0) {
        reader_warn(reader, "solids without facets are skipped (%zu)", empty_count);
    }
    return true;
}

/* ---- Binary ----------------------------------------------------------------------------------------------------- */

/** Colours of facets: 5 bits a channel. */
typedef struct facet_colours {
    bool has_default; /* Magics: the header names the colour of facets that have none of their own */
    double colour[3];
} facet_colours;

static facet_colours find_colours(const uint8_t *header) {
    static const char word[] = "COLOR=";
    facet_colours colours = {false, {1, 1, 1}};
    for (size_t i = 0; i + sizeof word - 1 + 4 <= HEADER_SIZE; i++) {
        if (memcmp(header + i, word, sizeof word - 1) == 0) {
            colours.has_default = true;
            for (size_t c = 0; c < 3; c++) {
                colours.colour[c] = header[i + sizeof word - 1 + c] / 255.0;
            }
            return colours;
        }
    }
    return colours;
}

/**
 * Finds the colour of a facet. VisCAM has red in the upper bits, and the top bit is set where the colour holds; Magics
 * has red in the lower bits, and the top bit is set where the header's colour holds.
 */
static void choose_colour(const facet_colours *colours, unsigned bits, double colour[3]) {
    const bool own = (bits >> 15 != 0) != colours->has_default;
    for (unsigned c = 0; c < 3; c++) {
        const unsigned channel = bits >> (colours->has_default ? 5 * c : 10 - 5 * c) & 31u;
        colour[c] = own ? channel / 31.0 : colours->colour[c];
    }
}

static bool read_binary(model_reader *reader) {
    if (reader->size < FACETS_AT) {
        return reader_fail(reader, "the file is neither text of STL nor long enough for a binary one");
    }
    const uint64_t count = reader_unsigned(reader->data + HEADER_SIZE, 4);
    const uint64_t there = (reader->size - FACETS_AT) / FACET_SIZE;
    if (there < count) {
        return reader_fail(reader, "the file is cut off, or no STL: it names %llu facets and has %llu",
                           (unsigned long long)count, (unsigned long long)there);
    }
    const facet_colours colours = find_colours(reader->data);
    for (size_t i = 0; i < count; i++) {
        const uint8_t *facet = reader->data + FACETS_AT + i * FACET_SIZE;
        double colour[3];
        choose_colour(&colours, (unsigned)reader_unsigned(facet + 48, 2), colour);
        for (size_t corner = 0; corner < 3; corner++) {
            double position[3];
            for (size_t axis = 0; axis < 3; axis++) {
                position[axis] = reader_float(facet + 12 * (corner + 1) + 4 * axis);
            }
            if (!reader_add_position(reader, position, colour)) {
                return false;
            }
            reader_add_corner(reader, (mesh_corner){(uint32_t)reader->mesh->position_count - 1, MESH_NO_NORMAL, 0});
        }
        if (!reader_end_face(reader, true)) {
            return false;
        }
    }
    if (FACETS_AT + count * FACET_SIZE < reader->size) {
        reader_warn(reader, "bytes behind the %llu facets that the file names are skipped", (unsigned long long)count);
    }
    return true;
}

/** Returns whether the file is text: headers of binary files begin with `solid` too, but bytes of 0 follow. */
static bool is_text(const model_reader *reader) {
    const size_t seen = reader->size < 1024 ? reader->size : 1024;
    text_reader text = text_begin((const char *)reader->data, reader->size);
    text_token token = {NULL, 0};
    if (memchr(reader->data, '\0', seen) != NULL) {
        return false;
    }
    while (text.at < text.end && !text_next_token(&text, &token)) {
        text_skip_statement(&text);
    }
    return reader_token_is(token, "solid");
}

bool stl_read(model_reader *reader) {
    const bool fits = reader->size >= FACETS_AT && (reader->size - FACETS_AT) % FACET_SIZE == 0 &&
                      reader_unsigned(reader->data + HEADER_SIZE, 4) == (reader->size - FACETS_AT) / FACET_SIZE;
    return !fits && is_text(reader) ? read_text(reader) : read_binary(reader);
}
