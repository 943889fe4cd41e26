/* SPDX-License-Identifier: MIT */
/**
 * @file text.h
 * Lines and tokens of Wavefront's text files, OBJ and MTL, and what is noted of them on the way.
 *
 * A statement is a line; a backslash at its end continues it on the next. `#` begins a comment. Line ends are LF, CRLF
 * or CR.
 */
#ifndef GLINT_HOST_TEXT_H
#define GLINT_HOST_TEXT_H

#include "problem.h"

/** Bytes of a text, not terminated. */
typedef struct text_token {
    const char *start;
    size_t length;
} text_token;

typedef struct text_reader {
    const char *at, *end;
    size_t line; /**< That `at` is on. */
} text_reader;

/** A reader at the first byte of a text, behind a byte order mark. */
text_reader text_begin(const char *text, size_t length);

/** The next token of the statement. @return false at its end, where a comment counts as one */
bool text_next_token(text_reader *reader, text_token *token);

/** What is left of the line without the blanks around it, comment included: names may hold blanks and `#`. */
text_token text_rest_of_line(text_reader *reader);

/** A copy ended by 0, for the caller to free; bytes of 0 within become '?'. */
char *text_copy(text_token token);

/** Skips what is left of a statement, its comment and its line end. */
void text_skip_statement(text_reader *reader);

bool text_token_is(text_token token, const char *word);

bool text_same_token(text_token a, text_token b);

/** Kinds of notes that this module knows of; an input's own are from TEXT_KINDS on. */
enum {
    TEXT_WORD,       /**< One note for each different word... */
    TEXT_TEXTURE,    /**< ...and likewise for these... */
    TEXT_MORE_WORDS, /**< ...and one for words of both beyond words_max. */
    TEXT_KINDS
};

/** Where a kind, or a word of its own, was first seen. */
typedef struct text_note {
    int kind;
    text_token word;
    size_t line;
    size_t more; /**< Times after the first. */
} text_note;

/** The notes of a text, in the order in which they were made. There are at most PROBLEM_WARNINGS_MAX. */
typedef struct text_notes {
    text_note list[PROBLEM_WARNINGS_MAX];
    size_t count, word_count;
    size_t words_max; /**< Different words that get a note of their own. */
} text_notes;

/** The note of a kind, or null. */
text_note *text_find_note(text_notes *notes, int kind, text_token word);

/** Counts what is not followed; words beyond the first few are counted together. */
void text_note_add(text_notes *notes, int kind, text_token word, size_t line);

/** Writes a warning for each note: its word, the text of its kind, and how often it was seen. */
void text_notes_write(const text_notes *notes, const char *const texts[], host_warnings *warnings);

#endif
