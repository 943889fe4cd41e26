/* SPDX-License-Identifier: MIT */
#include "model.h"

#include "basics.h"

#include <stdio.h>
#include <string.h>

/* ---- Lines and tokens ------------------------------------------------------------------------------------------ */

text_reader text_begin(const char *text, size_t length) {
    text_reader reader = {text, text + length, 1};
    reader.at += length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    return reader;
}

/** Bytes of the line end at a place: 0 when there is none, 2 for CRLF. */
static size_t line_end(const text_reader *reader, const char *at) {
    if (at == reader->end || (*at != '\n' && *at != '\r')) {
        return 0;
    }
    return *at == '\r' && at + 1 < reader->end && at[1] == '\n' ? 2 : 1;
}

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/** Bytes of a backslash, blanks that are not seen there, and the line end after them, or 0. */
static size_t continuation(const text_reader *reader, const char *at) {
    if (at == reader->end || *at != '\\') {
        return 0;
    }
    const char *next = at + 1;
    while (next < reader->end && is_blank(*next)) {
        next++;
    }
    const size_t size = line_end(reader, next);
    return size > 0 ? (size_t)(next - at) + size : 0;
}

static void skip_blanks(text_reader *reader) {
    while (reader->at < reader->end) {
        const size_t size = continuation(reader, reader->at);
        if (size == 0 && !is_blank(*reader->at)) {
            return;
        }
        reader->at += size > 0 ? size : 1;
        reader->line += size > 0;
    }
}

bool text_next_token(text_reader *reader, text_token *token) {
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

text_token text_rest_of_line(text_reader *reader) {
    skip_blanks(reader);
    text_token rest = {reader->at, 0};
    while (reader->at < reader->end && line_end(reader, reader->at) == 0 && continuation(reader, reader->at) == 0) {
        reader->at++;
    }
    rest.length = (size_t)(reader->at - rest.start);
    while (rest.length > 0 && is_blank(rest.start[rest.length - 1])) {
        rest.length--;
    }
    return rest;
}

text_token text_name(text_reader *reader) {
    text_token name = text_rest_of_line(reader);
    if (name.length >= 2 && name.start[0] == '"' && name.start[name.length - 1] == '"') {
        name.start++;
        name.length -= 2;
    }
    return name;
}

char *text_copy(text_token token) {
    char *copy = memory_new(token.length + 1, 1);
    for (size_t i = 0; i < token.length; i++) {
        copy[i] = (char)(token.start[i] != '\0' ? token.start[i] : '?');
    }
    return copy;
}

void text_skip_statement(text_reader *reader) {
    text_token token;
    while (text_next_token(reader, &token)) {
    }
    while (reader->at < reader->end && line_end(reader, reader->at) == 0) {
        reader->at++;
    }
    const size_t size = line_end(reader, reader->at);
    reader->at += size;
    reader->line += size > 0;
}

bool text_token_is(text_token token, const char *word) {
    return strlen(word) == token.length && memcmp(token.start, word, token.length) == 0;
}

bool text_same_token(text_token a, text_token b) {
    return a.length == b.length && memcmp(a.start, b.start, a.length) == 0;
}

/* ---- Notes ------------------------------------------------------------------------------------------------------ */

static bool is_by_word(int kind) {
    return kind == TEXT_WORD || kind == TEXT_TEXTURE;
}

text_note *text_find_note(text_notes *notes, int kind, text_token word) {
    for (size_t i = 0; i < notes->count; i++) {
        text_note *note = &notes->list[i];
        if (note->kind == kind && (!is_by_word(kind) || text_same_token(note->word, word))) {
            return note;
        }
    }
    return NULL;
}

void text_note_add(text_notes *notes, int kind, text_token word, size_t line) {
    text_note *known = text_find_note(notes, kind, word);
    if (known == NULL && is_by_word(kind) && notes->word_count == notes->words_max) {
        kind = TEXT_MORE_WORDS;
        known = text_find_note(notes, kind, word);
    }
    if (known != NULL) {
        known->more++;
        return;
    }
    notes->word_count += is_by_word(kind);
    notes->list[notes->count++] = (text_note){kind, word, line, 0};
}

void text_notes_write(const text_notes *notes, const char *const texts[], host_warnings *warnings) {
    for (size_t i = 0; i < notes->count && warnings->count < PROBLEM_WARNINGS_MAX; i++) {
        const text_note *note = &notes->list[i];
        char quote[PROBLEM_QUOTE_SIZE];
        char more[40] = "";
        if (note->more > 0) {
            snprintf(more, sizeof more, " (and %zu more)", note->more);
        }
        problem_set(&warnings->list[warnings->count++], note->line, "warning: '%s' %s%s",
                    problem_quote(quote, note->word.start, note->word.length), texts[note->kind], more);
    }
}
