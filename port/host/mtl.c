/* SPDX-License-Identifier: MIT */
#include "model.h"

#include "basics.h"
#include "values.h"

#include <stdlib.h>
#include <string.h>

/** Different words that are skipped for each of which there is a warning. */
#define WORDS_MAX 12

/** What is not followed, beside words. */
enum {
    KIND_COLOUR = TEXT_KINDS,
    KIND_NUMBER,
    KIND_ILLUMINATION,
    KIND_TRANSPARENT,
    KIND_ORPHAN,
    KIND_MANY,
    KIND_OPTION
};

static const char *const note_texts[] = {
    [TEXT_WORD] = "is skipped: it is not followed",
    [TEXT_TEXTURE] = "is skipped: of textures only map_Kd is drawn",
    [TEXT_MORE_WORDS] = "is skipped, as are more words that are not followed",
    [KIND_COLOUR] = "is skipped: it takes 1 or 3 numbers from 0 to 16",
    [KIND_NUMBER] = "is skipped: it takes one number in its range",
    [KIND_ILLUMINATION] = "above 2 is taken as 2: reflections and refraction are not drawn",
    [KIND_TRANSPARENT] = "is skipped: of transparency only d and Tr are drawn, above 0 and up to 1 of d",
    [KIND_MANY] = "is skipped: there are 65536 materials before it",
    [KIND_OPTION] = "of a texture is skipped: -clamp, -s and -o are followed",
    [KIND_ORPHAN] = "is skipped: it stands before any newmtl",
};

typedef struct mtl_reader {
    text_reader text;
    mtl_library *library;
    mtl_material *material; /* the one that is read, or null */
    text_notes notes;
} mtl_reader;

static void note(mtl_reader *reader, int kind, text_token word) {
    text_note_add(&reader->notes, kind, word, reader->text.line);
}

/* ---- Statements ------------------------------------------------------------------------------------------------- */

static void read_name(mtl_reader *reader, text_token keyword) {
    const text_token name = text_name(&reader->text);
    mtl_library *library = reader->library;
    reader->material = NULL;
    if (library->count == MTL_MATERIALS_MAX) {
        note(reader, KIND_MANY, keyword);
        return;
    }
    library->list = memory_grow(library->list, &library->capacity, library->count, sizeof *library->list);
    reader->material = &library->list[library->count++];
    memset(reader->material, 0, sizeof *reader->material);
    reader->material->illumination = 2;
    reader->material->name = text_copy(name);
}

/** Reads numbers from 0 to `most`, at most 3. @return how many, or 0 when that is not all that stands there */
static int read_numbers(mtl_reader *reader, double most, double values[3]) {
    text_token token;
    int count = 0;
    while (text_next_token(&reader->text, &token)) {
        if (count == 3 || !number_real(token.start, token.length, &values[count]) || values[count] < 0 ||
            values[count] > most) {
            return 0;
        }
        count++;
    }
    return count;
}

typedef struct mtl_statement mtl_statement;

struct mtl_statement {
    const char *keyword;
    void (*read)(mtl_reader *reader, const mtl_statement *statement, text_token keyword); /* null: it is skipped */
    size_t at;      /* of the value in the material */
    unsigned given; /* what it gives */
    double most;
};

static void read_colour(mtl_reader *reader, const mtl_statement *statement, text_token keyword) {
    double *colour = (double *)(void *)((char *)reader->material + statement->at);
    double values[3];
    const int count = read_numbers(reader, MTL_COLOUR_MAX, values);
    if (count != 1 && count != 3) {
        note(reader, KIND_COLOUR, keyword);
        return;
    }
    for (int i = 0; i < 3; i++) {
        colour[i] = values[count == 3 ? i : 0];
    }
    reader->material->given |= statement->given;
}

static void read_number(mtl_reader *reader, const mtl_statement *statement, text_token keyword) {
    double values[3];
    if (read_numbers(reader, statement->most, values) != 1) {
        note(reader, KIND_NUMBER, keyword);
    } else if (statement->given != 0) {
        *(double *)(void *)((char *)reader->material + statement->at) = values[0];
        reader->material->given |= statement->given;
    } else {
        if (values[0] > 2) {
            note(reader, KIND_ILLUMINATION, keyword);
        }
        reader->material->illumination = values[0] > 2 ? 2 : (int)values[0];
    }
}

/** Reads d, or Tr, which is 1 - d, unless there is a d. A surface that nobody could see is an exporter's mistake. */
static void read_opacity(mtl_reader *reader, const mtl_statement *statement, text_token keyword) {
    mtl_material *material = reader->material;
    double values[3] = {1, 0, 0};
    const int count = read_numbers(reader, statement->most, values);
    const double passed = text_token_is(keyword, "Tr") ? values[0] : 1 - values[0];
    if ((material->given & MTL_OPACITY) != 0 && statement->given == 0) {
        return;
    }
    if (count != 1 || passed >= 1) {
        note(reader, KIND_TRANSPARENT, keyword);
        return;
    }
    material->passed = passed;
    material->given |= statement->given;
}

/** Reads Tf, which has up to three numbers: what is coloured by passing through is not followed. */
static void read_filter(mtl_reader *reader, const mtl_statement *statement, text_token keyword) {
    double values[3];
    const int count = read_numbers(reader, statement->most, values);
    bool opaque = count == 1 || count == 3;
    for (int i = 0; opaque && i < count; i++) {
        opaque = values[i] >= 1;
    }
    if (!opaque) {
        note(reader, KIND_TRANSPARENT, keyword);
    }
}

void mtl_set_texture(mtl_texture *texture, const char *name, size_t length) {
    const text_token token = {name, length};
    free(texture->name);
    memset(texture, 0, sizeof *texture);
    texture->name = text_copy(token);
    texture->cutoff = 0.5;
    texture->transform[0][0] = texture->transform[1][1] = 1;
}

/** Reads up to 3 numbers of an option; those that are missing stay. */
static void read_option_numbers(mtl_reader *reader, double values[3]) {
    text_reader ahead = reader->text;
    text_token token;
    for (int i = 0; i < 3 && text_next_token(&ahead, &token); i++) {
        double value;
        if (!number_real(token.start, token.length, &value)) {
            return;
        }
        values[i] = value;
        reader->text = ahead;
    }
}

/** Skips an option's values: words for these, else numbers. */
static void skip_option(mtl_reader *reader, text_token option) {
    static const char *const with_words[] = {"-blendu", "-blendv", "-cc", "-imfchan", "-type"};
    double values[3];
    text_token word;
    note(reader, KIND_OPTION, option);
    for (size_t i = 0; i < sizeof with_words / sizeof with_words[0]; i++) {
        if (text_token_is(option, with_words[i])) {
            text_next_token(&reader->text, &word);
            return;
        }
    }
    read_option_numbers(reader, values);
}

/** Reads options and the name of the picture, which is the rest of the line. */
static void read_texture(mtl_reader *reader, const mtl_statement *statement, text_token keyword) {
    double scale[3] = {1, 1, 1};
    double move[3] = {0, 0, 0};
    bool clamps = false;
    const size_t line = reader->text.line;
    text_reader ahead = reader->text;
    text_token token;
    (void)statement;
    while (text_next_token(&ahead, &token) && token.start[0] == '-') {
        reader->text = ahead;
        if (text_token_is(token, "-clamp")) {
            clamps = text_next_token(&reader->text, &token) && text_token_is(token, "on");
        } else if (text_token_is(token, "-s")) {
            read_option_numbers(reader, scale);
        } else if (text_token_is(token, "-o")) {
            read_option_numbers(reader, move);
        } else {
            skip_option(reader, token);
        }
        ahead = reader->text;
    }
    const text_token name = text_name(&reader->text);
    mtl_texture *texture = &reader->material->texture;
    if (name.length == 0) {
        note(reader, TEXT_WORD, keyword);
        return;
    }
    mtl_set_texture(texture, name.start, name.length);
    texture->line = line;
    texture->clamps = clamps;
    texture->transform[0][0] = scale[0];
    texture->transform[0][2] = move[0];
    texture->transform[1][1] = scale[1];
    texture->transform[1][2] = 1 - scale[1] - move[1]; /* v counts from the bottom there, from the top here */
}

static const mtl_statement statements[] = {
    {"Ka", read_colour, offsetof(mtl_material, ambient), MTL_AMBIENT, 0},
    {"Kd", read_colour, offsetof(mtl_material, diffuse), MTL_DIFFUSE, 0},
    {"Ks", read_colour, offsetof(mtl_material, specular), 0, 0},
    {"Ke", read_colour, offsetof(mtl_material, emission), 0, 0},
    {"Ns", read_number, offsetof(mtl_material, shininess), MTL_SHININESS, MTL_SHININESS_MAX},
    {"illum", read_number, 0, 0, 10},
    {"d", read_opacity, 0, MTL_OPACITY, 1},
    {"Tr", read_opacity, 0, 0, 1},
    {"Tf", read_filter, 0, 0, 1},
    {"Ni", NULL, 0, 0, 0},
    {"map_Kd", read_texture, 0, 0, 0},
};

static bool is_texture(text_token keyword) {
    static const char *const words[] = {"bump", "disp", "decal", "refl", "norm"};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        if (text_token_is(keyword, words[i])) {
            return true;
        }
    }
    return keyword.length > 4 && memcmp(keyword.start, "map_", 4) == 0;
}

static void read_statement(mtl_reader *reader) {
    text_token keyword;
    if (!text_next_token(&reader->text, &keyword)) {
        return;
    }
    if (text_token_is(keyword, "newmtl")) {
        read_name(reader, keyword);
        return;
    }
    for (size_t i = 0; i < sizeof statements / sizeof statements[0]; i++) {
        if (text_token_is(keyword, statements[i].keyword)) {
            if (reader->material == NULL) {
                note(reader, KIND_ORPHAN, keyword);
            } else if (statements[i].read != NULL) {
                statements[i].read(reader, &statements[i], keyword);
            }
            return;
        }
    }
    note(reader, is_texture(keyword) ? TEXT_TEXTURE : TEXT_WORD, keyword);
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

void mtl_read(const char *text, size_t length, mtl_library *library, host_warnings *warnings) {
    mtl_reader reader = {.text = text_begin(text, length), .library = library, .notes = {.words_max = WORDS_MAX}};
    while (reader.text.at < reader.text.end) {
        read_statement(&reader);
        text_skip_statement(&reader.text);
    }
    text_notes_write(&reader.notes, note_texts, warnings);
}

void mtl_free(mtl_library *library) {
    for (size_t i = 0; i < library->count; i++) {
        free(library->list[i].name);
        free(library->list[i].texture.name);
    }
    free(library->list);
    memset(library, 0, sizeof *library);
}
