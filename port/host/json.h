/* SPDX-License-Identifier: MIT */
/**
 * @file json.h
 * JSON as glTF needs it (RFC 8259): values of a text, in one array, each before what is in it.
 */
#ifndef GLINT_HOST_JSON_H
#define GLINT_HOST_JSON_H

#include "basics.h"

typedef enum json_type { JSON_NULL, JSON_BOOLEAN, JSON_NUMBER, JSON_STRING, JSON_ARRAY, JSON_OBJECT } json_type;

/** A value. The members of an object are names and values in turn. */
typedef struct json_value {
    json_type type;
    const char *start; /**< Of its text; of a string, behind the quotation mark. */
    size_t length;     /**< Of a string, number or word. */
    size_t count;      /**< Items of an array, members of an object. */
    size_t size;       /**< Values that it consists of, itself included: so many are between it and the next one. */
} json_value;

/** Zeroed it has no values. */
typedef struct json_document {
    json_value *values; /**< The first is the whole. */
    size_t count, capacity;
} json_document;

/** Parses a text of any bytes. @return false with a problem of its line; json_free is then to be called too */
bool json_parse(const char *text, size_t length, json_document *document, host_problem *problem);

/** Frees what json_parse made. */
void json_free(json_document *document);

/** Finds a member; null when there is none, or `object` is null or no object. */
const json_value *json_member(const json_value *object, const char *name);

/** The first item of an array; null when it has none, or is null or no array. */
const json_value *json_first(const json_value *array);

/** The item after one of an array, which must not be the last. */
const json_value *json_next(const json_value *item);

/** How many items an array has; 0 when it is null or no array. */
size_t json_count(const json_value *array);

/** A number's value; `otherwise` when it is null or no finite number. */
double json_number(const json_value *value, double otherwise);

/** Finds a whole number from 0 to 2^53. @return whether it is one */
bool json_whole(const json_value *value, size_t *whole);

/** Returns whether a value is the string. */
bool json_is(const json_value *value, const char *text);

/** Returns whether a value is `true`. */
bool json_true(const json_value *value);

/** A string's text in UTF-8, ended by 0, for the caller to free; empty when it is null or no string. */
char *json_text(const json_value *value);

#endif
