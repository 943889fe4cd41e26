/* SPDX-License-Identifier: MIT */
#include "json.h"

#include "values.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Most arrays and objects in one another: glTF needs a dozen. */
#define DEPTH_MAX 128

typedef struct json_parser {
    const char *start, *at, *end;
    json_document *document;
    host_problem *problem;
    size_t open[DEPTH_MAX]; /* arrays and objects that have not ended */
    size_t depth;
} json_parser;

static bool fail(const json_parser *parser, const char *why) {
    size_t line = 1;
    for (const char *c = parser->start; c < parser->at; c++) {
        line += *c == '\n';
    }
    return problem_set(parser->problem, line, "%s", parser->at == parser->end ? "the JSON text is cut off" : why);
}

static bool is_one_of(char c, const char *characters) {
    return c != '\0' && strchr(characters, c) != NULL;
}

static void skip_blanks(json_parser *parser) {
    while (parser->at < parser->end && is_one_of(*parser->at, " \t\r\n")) {
        parser->at++;
    }
}

static json_value *add_value(json_parser *parser, json_type type) {
    json_document *document = parser->document;
    document->values = memory_grow(document->values, &document->capacity, document->count, sizeof *document->values);
    json_value *value = &document->values[document->count++];
    *value = (json_value){type, parser->at, 0, 0, 1};
    return value;
}

static bool read_string(json_parser *parser) {
    parser->at++;
    json_value *value = add_value(parser, JSON_STRING);
    while (parser->at < parser->end && *parser->at != '"') {
        parser->at += *parser->at == '\\' && parser->at + 1 < parser->end ? 2 : 1;
    }
    value->length = (size_t)(parser->at - value->start);
    if (parser->at == parser->end) {
        return fail(parser, "");
    }
    parser->at++;
    return true;
}

/** Reads a number, or one of the three words. */
static bool read_word(json_parser *parser) {
    static const char *const words[] = {"null", "true", "false"};
    json_value *value = add_value(parser, JSON_NUMBER);
    double number;
    while (parser->at < parser->end && !is_one_of(*parser->at, " \t\r\n,:]}\"[{")) {
        parser->at++;
    }
    value->length = (size_t)(parser->at - value->start);
    for (size_t i = 0; i < 3; i++) {
        if (strlen(words[i]) == value->length && memcmp(words[i], value->start, value->length) == 0) {
            value->type = i == 0 ? JSON_NULL : JSON_BOOLEAN;
            return true;
        }
    }
    if (number_real(value->start, value->length, &number)) {
        return true;
    }
    char quote[PROBLEM_QUOTE_SIZE];
    char why[PROBLEM_QUOTE_SIZE + 32];
    problem_quote(quote, value->start, value->length);
    snprintf(why, sizeof why, "'%s' is no value of JSON", quote);
    return fail(parser, why);
}

/** Ends the arrays and objects whose brackets stand here. */
static bool close_brackets(json_parser *parser) {
    skip_blanks(parser);
    while (parser->depth > 0 && parser->at < parser->end && (*parser->at == ']' || *parser->at == '}')) {
        json_value *value = &parser->document->values[parser->open[parser->depth - 1]];
        if ((*parser->at == '}') != (value->type == JSON_OBJECT)) {
            return fail(parser, "a bracket that closes none");
        }
        parser->at++;
        parser->depth--;
        value->size = (size_t)(parser->document->values + parser->document->count - value);
        skip_blanks(parser);
    }
    return true;
}

/** Reads what stands before a value in an object: its name and a colon. */
static bool read_name(json_parser *parser) {
    if (parser->at == parser->end || *parser->at != '"') {
        return fail(parser, "a name is missing");
    }
    if (!read_string(parser)) {
        return false;
    }
    skip_blanks(parser);
    if (parser->at == parser->end || *parser->at != ':') {
        return fail(parser, "a colon is missing");
    }
    parser->at++;
    skip_blanks(parser);
    return true;
}

/** Reads a value, and of an array or object its opening bracket. @param opened set to whether it is one of these */
static bool read_value(json_parser *parser, bool *opened) {
    if (parser->depth > 0) {
        json_value *outer = &parser->document->values[parser->open[parser->depth - 1]];
        outer->count++;
        if (outer->type == JSON_OBJECT && !read_name(parser)) {
            return false;
        }
    }
    *opened = parser->at < parser->end && (*parser->at == '[' || *parser->at == '{');
    if (parser->at == parser->end) {
        return fail(parser, "");
    }
    if (!*opened) {
        return *parser->at == '"' ? read_string(parser) : read_word(parser);
    }
    if (parser->depth == DEPTH_MAX) {
        return fail(parser, "more than 128 arrays and objects in one another");
    }
    parser->open[parser->depth++] = parser->document->count;
    add_value(parser, *parser->at == '[' ? JSON_ARRAY : JSON_OBJECT);
    parser->at++;
    skip_blanks(parser);
    return true;
}

bool json_parse(const char *text, size_t length, json_document *document, host_problem *problem) {
    json_parser parser = {.start = text, .at = text, .end = text + length, .document = document, .problem = problem};
    memset(document, 0, sizeof *document);
    bool opened = false;
    parser.at += length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    skip_blanks(&parser);
    do {
        const bool is_empty = opened && parser.at < parser.end && (*parser.at == ']' || *parser.at == '}');
        if (!is_empty && !read_value(&parser, &opened)) {
            return false;
        }
        if (opened && !is_empty) {
            continue;
        }
        opened = false;
        if (!close_brackets(&parser)) {
            return false;
        }
        if (parser.depth > 0) {
            if (parser.at == parser.end || *parser.at != ',') {
                return fail(&parser, "a comma or a bracket is missing");
            }
            parser.at++;
            skip_blanks(&parser);
        }
    } while (parser.depth > 0);
    return parser.at == parser.end || fail(&parser, "something behind the end of the JSON text");
}

void json_free(json_document *document) {
    free(document->values);
    memset(document, 0, sizeof *document);
}

/* ---- Values ----------------------------------------------------------------------------------------------------- */

bool json_is(const json_value *value, const char *text) {
    return value != NULL && value->type == JSON_STRING && strlen(text) == value->length &&
           memcmp(text, value->start, value->length) == 0;
}

const json_value *json_next(const json_value *item) {
    return item + item->size;
}

const json_value *json_member(const json_value *object, const char *name) {
    if (object == NULL || object->type != JSON_OBJECT) {
        return NULL;
    }
    const json_value *member = object + 1;
    for (size_t i = 0; i < object->count; i++) {
        if (json_is(member, name)) {
            return member + 1;
        }
        member = json_next(member + 1);
    }
    return NULL;
}

size_t json_count(const json_value *array) {
    return array != NULL && array->type == JSON_ARRAY ? array->count : 0;
}

const json_value *json_first(const json_value *array) {
    return json_count(array) > 0 ? array + 1 : NULL;
}

double json_number(const json_value *value, double otherwise) {
    double number = otherwise;
    return value != NULL && value->type == JSON_NUMBER && number_real(value->start, value->length, &number) ? number
                                                                                                            : otherwise;
}

bool json_whole(const json_value *value, size_t *whole) {
    const double number = json_number(value, -1);
    if (!(number >= 0 && number <= 9007199254740992.0) || number < floor(number) || number > floor(number)) {
        return false;
    }
    *whole = (size_t)number;
    return true;
}

bool json_true(const json_value *value) {
    return value != NULL && value->type == JSON_BOOLEAN && value->length == 4;
}

/** Reads the four digits of an escape. @return the number, or '?' */
static unsigned escaped_unit(const char *at, const char *end) {
    unsigned unit = 0;
    for (int i = 0; i < 4; i++) {
        if (at + i >= end || !is_one_of(at[i], "0123456789abcdefABCDEF")) {
            return '?';
        }
        const char lower = (char)(at[i] >= 'A' ? (at[i] | 32) : at[i]);
        unit = unit * 16 + (unsigned)(lower >= 'a' ? lower - 'a' + 10 : lower - '0');
    }
    return unit;
}

static void add_code(host_bytes *text, unsigned code) {
    if (code < 0x80) {
        bytes_add(text, (uint8_t)code);
        return;
    }
    static const unsigned first_bits[] = {0, 0xC0, 0xE0, 0xF0}; /* by the number of bytes after the first */
    const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    bytes_add(text, (uint8_t)(first_bits[more] | code >> 6 * more));
    for (int i = more - 1; i >= 0; i--) {
        bytes_add(text, (uint8_t)(0x80 | (code >> 6 * i & 0x3F)));
    }
}

char *json_text(const json_value *value) {
    static const char letters[] = "\"\\/bfnrt";
    static const char meant[] = "\"\\/\b\f\n\r\t";
    host_bytes text = {NULL, 0, 0};
    const bool is_text = value != NULL && value->type == JSON_STRING;
    const char *end = is_text ? value->start + value->length : NULL;
    for (const char *at = is_text ? value->start : NULL; at != end; at++) {
        if (*at != '\\' || at + 1 == end) {
            bytes_add(&text, (uint8_t)*at);
            continue;
        }
        const char *letter = memchr(letters, *++at, sizeof letters - 1);
        if (letter != NULL) {
            bytes_add(&text, (uint8_t)meant[letter - letters]);
        } else if (*at == 'u') {
            unsigned code = escaped_unit(at + 1, end);
            at += end - at > 4 ? 4 : end - at - 1;
            if (code >= 0xD800 && code < 0xDC00 && end - at > 6 && at[1] == '\\' && at[2] == 'u') {
                const unsigned low = escaped_unit(at + 3, end);
                code = 0x10000 + ((code & 0x3FF) << 10) + (low & 0x3FF);
                at += 6;
            }
            add_code(&text, code != 0 ? code : '?');
        }
    }
    bytes_add(&text, 0);
    return (char *)text.data;
}
