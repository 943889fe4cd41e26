/* SPDX-License-Identifier: MIT */
#include "obj.h"

#include "memory.h"
#include "number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Different words for each of which there is a warning. With one of each other kind PROBLEM_WARNINGS_MAX holds all. */
#define WORDS_MAX 4

typedef struct obj_token {
    const char *start;
    size_t length;
} obj_token;

/** What is not followed, or nothing. */
typedef enum obj_kind {
    KIND_NONE,
    KIND_MATERIAL,
    KIND_ELEMENT,
    KIND_WORD,
    KIND_MORE_WORDS,
    KIND_EMPTY_INDEX,
    KIND_BYTE_COLOURS,
    KIND_NO_COLOUR
} obj_kind;

/** Where a kind, or a word of KIND_WORD, was first seen. */
typedef struct obj_notice {
    obj_kind kind;
    obj_token word;
    size_t line;
    size_t more; /* times after the first */
} obj_notice;

typedef struct obj_reader {
    const char *at, *end;
    size_t line; /* that `at` is on */
    host_mesh *mesh;
    size_t texture_count;
    double farthest;      /* largest coordinate so far */
    double (*colours)[3]; /* as read */
    size_t colour_count, colour_capacity;
    size_t bare_line, bare_count; /* the first position without a colour; how many */
    mesh_corner *face;
    size_t face_count, face_capacity;
    obj_notice notices[PROBLEM_WARNINGS_MAX];
    size_t notice_count, word_count;
    host_problem *problem;
} obj_reader;

/* ---- Lines and tokens ------------------------------------------------------------------------------------------ */

/** Bytes of the line end at a place: 0 when there is none, 2 for CRLF. */
static size_t line_end(const obj_reader *reader, const char *at) {
    if (at == reader->end || (*at != '\n' && *at != '\r')) {
        return 0;
    }
    return *at == '\r' && at + 1 < reader->end && at[1] == '\n' ? 2 : 1;
}

/** Bytes of a backslash and the line end after it, or 0. */
static size_t continuation(const obj_reader *reader, const char *at) {
    if (at == reader->end || *at != '\\') {
        return 0;
    }
    const size_t size = line_end(reader, at + 1);
    return size > 0 ? size + 1 : 0;
}

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

static void skip_blanks(obj_reader *reader) {
    while (reader->at < reader->end) {
        const size_t size = continuation(reader, reader->at);
        if (size == 0 && !is_blank(*reader->at)) {
            return;
        }
        reader->at += size > 0 ? size : 1;
        reader->line += size > 0;
    }
}

/** The next token of the statement. @return false at its end, where a comment counts as one */
static bool next_token(obj_reader *reader, obj_token *token) {
    skip_blanks(reader);
    token->start = reader->at;
    if (reader->at < reader->end && *reader->at == '#') {
        return false;
    }
    while (reader->at < reader->end && !is_blank(*reader->at) && line_end(reader, reader->at) == 0 &&
           continuation(reader, reader->at) == 0) {
        reader->at++;
    }
    token->length = (size_t)(reader->at - token->start);
    return token->length > 0;
}

/** Skips what is left of a statement, its comment and its line end. */
static void skip_statement(obj_reader *reader) {
    obj_token token;
    while (next_token(reader, &token)) {
    }
    while (reader->at < reader->end && line_end(reader, reader->at) == 0) {
        reader->at++;
    }
    const size_t size = line_end(reader, reader->at);
    reader->at += size;
    reader->line += size > 0;
}

static bool token_is(obj_token token, const char *word) {
    return strlen(word) == token.length && memcmp(token.start, word, token.length) == 0;
}

/* ---- Warnings --------------------------------------------------------------------------------------------------- */

static const obj_token position_word = {"v", 1};

static obj_notice *find_notice(obj_reader *reader, obj_kind kind, obj_token word) {
    for (size_t i = 0; i < reader->notice_count; i++) {
        obj_notice *notice = &reader->notices[i];
        const bool same =
            notice->word.length == word.length && memcmp(notice->word.start, word.start, word.length) == 0;
        if (notice->kind == kind && (kind != KIND_WORD || same)) {
            return notice;
        }
    }
    return NULL;
}

/** Counts what is not followed; words beyond the first few are counted together. */
static void note(obj_reader *reader, obj_kind kind, obj_token word) {
    obj_notice *known = find_notice(reader, kind, word);
    if (known == NULL && kind == KIND_WORD && reader->word_count == WORDS_MAX) {
        kind = KIND_MORE_WORDS;
        known = find_notice(reader, kind, word);
    }
    if (known != NULL) {
        known->more++;
        return;
    }
    reader->word_count += kind == KIND_WORD;
    reader->notices[reader->notice_count++] = (obj_notice){kind, word, reader->line, 0};
}

static void write_warnings(const obj_reader *reader, host_warnings *warnings) {
    static const char *const texts[] = {
        [KIND_MATERIAL] = "is skipped: materials are not read",
        [KIND_ELEMENT] = "is skipped: only faces are drawn",
        [KIND_WORD] = "is skipped: it is not an OBJ keyword",
        [KIND_MORE_WORDS] = "is skipped, as are more words that are not OBJ keywords",
        [KIND_EMPTY_INDEX] = "has an empty index: taken as not given",
        [KIND_BYTE_COLOURS] = "has a colour above 1: all colours are taken as 0 to 255",
        [KIND_NO_COLOUR] = "has no colour, as others have: no colour is kept",
    };
    for (size_t i = 0; i < reader->notice_count; i++) {
        const obj_notice *notice = &reader->notices[i];
        char quote[PROBLEM_QUOTE_SIZE];
        char more[40] = "";
        if (notice->more > 0) {
            snprintf(more, sizeof more, " (and %zu more)", notice->more);
        }
        problem_set(&warnings->list[i], notice->line, "warning: '%s' %s%s",
                    problem_quote(quote, notice->word.start, notice->word.length), texts[notice->kind], more);
    }
    warnings->count = reader->notice_count;
}

/* ---- Vertices -------------------------------------------------------------------------------------------------- */

/** Reads the numbers that are left of a statement, up to 8. @return how many, or -1 with a problem. */
static int read_numbers(obj_reader *reader, double values[8]) {
    obj_token token;
    int count = 0;
    while (next_token(reader, &token)) {
        char quote[PROBLEM_QUOTE_SIZE];
        if (count == 8) {
            problem_set(reader->problem, reader->line, "too many numbers");
            return -1;
        }
        if (!number_real(token.start, token.length, &values[count])) {
            problem_set(reader->problem, reader->line, "'%s' is not a finite number",
                        problem_quote(quote, token.start, token.length));
            return -1;
        }
        count++;
    }
    return count;
}

static bool has_room(obj_reader *reader, size_t count) {
    return count < MESH_NO_NORMAL - 1 || problem_set(reader->problem, reader->line, "more than 2^32 - 2 of a kind");
}

/** Keeps a position's colour. @return false with a problem when it is none */
static bool read_colour(obj_reader *reader, const double *channels) {
    reader->colours =
        memory_grow(reader->colours, &reader->colour_capacity, reader->colour_count, sizeof *reader->colours);
    double *colour = reader->colours[reader->colour_count++];
    bool is_byte = false;
    for (int i = 0; i < 3; i++) {
        if (!(channels[i] >= 0 && channels[i] <= 255)) {
            return problem_set(reader->problem, reader->line, "colour %.6g is not from 0 to 1, nor to 255",
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

/** Gives the mesh its colours, when all positions have one. */
static void keep_colours(obj_reader *reader) {
    const double scale = find_notice(reader, KIND_BYTE_COLOURS, position_word) != NULL ? 1.0 : 255.0;
    if (reader->colour_count > 0 && reader->bare_count > 0) {
        reader->notices[reader->notice_count++] =
            (obj_notice){KIND_NO_COLOUR, position_word, reader->bare_line, reader->bare_count - 1};
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
        return problem_set(reader->problem, reader->line, "v takes 3 coordinates, here are %d numbers", count);
    }
    const double largest = fmax(fabs(values[0]), fmax(fabs(values[1]), fabs(values[2])));
    if (largest > OBJ_COORDINATE_MAX) {
        return problem_set(reader->problem, reader->line, "coordinate of %.3g is too large", largest);
    }
    if (largest > reader->farthest) {
        reader->farthest = largest;
        reader->mesh->farthest_line = reader->line;
    }
    if (!has_room(reader, reader->mesh->position_count) || (count >= 6 && !read_colour(reader, values + count - 3))) {
        return false;
    }
    if (count < 6 && reader->bare_count++ == 0) {
        reader->bare_line = reader->line;
    }
    mesh_add_position(reader->mesh, values[0], values[1], values[2]);
    return true;
}

static bool read_normal(obj_reader *reader) {
    double values[8];
    const int count = read_numbers(reader, values);
    if (count >= 0 && count != 3) {
        return problem_set(reader->problem, reader->line, "vn takes 3 numbers, here are %d", count);
    }
    if (count < 0 || !has_room(reader, reader->mesh->normal_count)) {
        return false;
    }
    mesh_add_normal(reader->mesh, values[0], values[1], values[2]);
    return true;
}

static bool read_texture(obj_reader *reader) {
    double values[8];
    const int count = read_numbers(reader, values);
    if (count >= 0 && (count < 1 || count > 3)) {
        return problem_set(reader->problem, reader->line, "vt takes 1 to 3 numbers, here are %d", count);
    }
    reader->texture_count++;
    return count >= 0;
}

/* ---- Faces ------------------------------------------------------------------------------------------------------ */

/** Reads one index of a corner. @return false with a problem when it does not refer to one of `count` items */
static bool read_index(obj_reader *reader, obj_token part, const char *what, size_t count, uint32_t *index) {
    int64_t number;
    char quote[PROBLEM_QUOTE_SIZE];
    problem_quote(quote, part.start, part.length);
    if (!number_integer(part.start, part.length, &number)) {
        return problem_set(reader->problem, reader->line, "'%s' is not a %s index", quote, what);
    }
    const int64_t place = number < 0 ? (int64_t)count + number : number - 1;
    if (number == 0 || place < 0 || place >= (int64_t)count) {
        return problem_set(reader->problem, reader->line, "%s index %s is out of range: %zu so far", what, quote,
                           count);
    }
    *index = (uint32_t)place;
    return true;
}

/** Splits a corner at its slashes. @return the number of parts, from 1; 4 when there are more than 3 */
static int split_corner(obj_token token, obj_token parts[3]) {
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

static bool read_corner(obj_reader *reader, obj_token token, mesh_corner *corner) {
    obj_token parts[3];
    const int count = split_corner(token, parts);
    uint32_t texture;
    corner->normal = MESH_NO_NORMAL;
    if (count > 3) {
        char quote[PROBLEM_QUOTE_SIZE];
        problem_quote(quote, token.start, token.length);
        return problem_set(reader->problem, reader->line, "corner '%s' is not v, v/t, v//n or v/t/n", quote);
    }
    const bool has_texture = count >= 2 && parts[1].length > 0;
    const bool has_normal = count == 3 && parts[2].length > 0;
    if (!read_index(reader, parts[0], "position", reader->mesh->position_count, &corner->position) ||
        (has_texture && !read_index(reader, parts[1], "texture", reader->texture_count, &texture)) ||
        (has_normal && !read_index(reader, parts[2], "normal", reader->mesh->normal_count, &corner->normal))) {
        return false;
    }
    if (parts[count - 1].length == 0) { /* v//n leaves out the texture as it should */
        note(reader, KIND_EMPTY_INDEX, token);
    }
    if (has_normal && is_zero_normal(reader->mesh->normals[corner->normal])) {
        corner->normal = MESH_NO_NORMAL;
    }
    return true;
}

static bool read_face(obj_reader *reader) {
    obj_token token;
    reader->face_count = 0;
    while (next_token(reader, &token)) {
        reader->face = memory_grow(reader->face, &reader->face_capacity, reader->face_count, sizeof *reader->face);
        if (!read_corner(reader, token, &reader->face[reader->face_count])) {
            return false;
        }
        reader->face_count++;
    }
    if (reader->face_count < 3) {
        return problem_set(reader->problem, reader->line, "a face takes 3 or more corners, here are %zu",
                           reader->face_count);
    }
    mesh_add_polygon(reader->mesh, reader->face, reader->face_count);
    reader->mesh->face_count++;
    return true;
}

static bool read_group(obj_reader *reader) {
    reader->mesh->group_count++;
    return true;
}

/* ---- Files ------------------------------------------------------------------------------------------------------ */

static const struct obj_statement {
    const char *keyword;
    bool (*read)(obj_reader *reader);
} statements[] = {
    {"v", read_position}, {"vn", read_normal}, {"vt", read_texture},
    {"f", read_face},     {"g", read_group},   {"o", read_group},
};

/** The format's other keywords (Wavefront, Advanced Visualizer manual, appendix B1), old ones included. */
static const struct obj_skipped {
    const char *keyword;
    obj_kind kind;
} skipped[] = {
    {"usemtl", KIND_MATERIAL}, {"mtllib", KIND_MATERIAL}, {"usemap", KIND_MATERIAL}, {"maplib", KIND_MATERIAL},
    {"p", KIND_ELEMENT},       {"l", KIND_ELEMENT},       {"curv", KIND_ELEMENT},    {"curv2", KIND_ELEMENT},
    {"surf", KIND_ELEMENT},    {"bsp", KIND_ELEMENT},     {"bzp", KIND_ELEMENT},     {"cdc", KIND_ELEMENT},
    {"cdp", KIND_ELEMENT},     {"call", KIND_ELEMENT},    {"csh", KIND_ELEMENT},     {"vp", KIND_NONE},
    {"deg", KIND_NONE},        {"bmat", KIND_NONE},       {"step", KIND_NONE},       {"cstype", KIND_NONE},
    {"parm", KIND_NONE},       {"trim", KIND_NONE},       {"hole", KIND_NONE},       {"scrv", KIND_NONE},
    {"sp", KIND_NONE},         {"end", KIND_NONE},        {"con", KIND_NONE},        {"s", KIND_NONE},
    {"mg", KIND_NONE},         {"bevel", KIND_NONE},      {"lod", KIND_NONE},        {"ctech", KIND_NONE},
    {"stech", KIND_NONE},      {"shadow_obj", KIND_NONE}, {"trace_obj", KIND_NONE},  {"c_interp", KIND_NONE},
    {"d_interp", KIND_NONE},   {"res", KIND_NONE},
};

/** What a keyword that is not read comes to. */
static obj_kind kind_of(obj_token keyword) {
    for (size_t i = 0; i < sizeof skipped / sizeof skipped[0]; i++) {
        if (token_is(keyword, skipped[i].keyword)) {
            return skipped[i].kind;
        }
    }
    return KIND_WORD;
}

static bool read_statement(obj_reader *reader) {
    obj_token keyword;
    if (!next_token(reader, &keyword)) {
        return true;
    }
    for (size_t i = 0; i < sizeof statements / sizeof statements[0]; i++) {
        if (token_is(keyword, statements[i].keyword)) {
            return statements[i].read(reader);
        }
    }
    const obj_kind kind = kind_of(keyword);
    if (kind != KIND_NONE) {
        note(reader, kind, keyword);
    }
    return true;
}

/** Says that there are no faces; by the first word that is no keyword, when there is one. @return false */
static bool refuse_without_faces(const obj_reader *reader) {
    for (size_t i = 0; i < reader->notice_count; i++) {
        const obj_notice *notice = &reader->notices[i];
        if (notice->kind == KIND_WORD) {
            char quote[PROBLEM_QUOTE_SIZE];
            return problem_set(reader->problem, notice->line, "'%s' is not an OBJ keyword",
                               problem_quote(quote, notice->word.start, notice->word.length));
        }
    }
    return problem_set(reader->problem, reader->line, "no faces");
}

bool obj_read(const char *text, size_t length, host_mesh *mesh, host_warnings *warnings, host_problem *problem) {
    memset(mesh, 0, sizeof *mesh);
    obj_reader reader = {.at = text, .end = text + length, .line = 1, .mesh = mesh, .problem = problem};
    reader.at += length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    bool ok = true;
    while (ok && reader.at < reader.end) {
        ok = read_statement(&reader);
        if (ok) {
            skip_statement(&reader);
        }
    }
    ok = ok && (mesh->triangle_count > 0 || refuse_without_faces(&reader));
    if (ok) {
        keep_colours(&reader);
        write_warnings(&reader, warnings);
    }
    free(reader.colours);
    free(reader.face);
    if (!ok) {
        mesh_free(mesh);
    }
    return ok;
}
