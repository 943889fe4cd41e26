/* SPDX-License-Identifier: MIT */
/**
 * @file methods.h
 * Candidate methods for cos^p and for unit vectors, every one a small integer implementation behind the same
 * descriptor, so that one test body, one accuracy body and one benchmark body serve them all. The library uses one or
 * two of each kind; those rows call its own functions. The others show why.
 *
 * The methods and their inputs are freestanding and run on the boards; judge.h has the double-precision side.
 */
#ifndef GLINT_METHODS_H
#define GLINT_METHODS_H

#include <stddef.h>
#include <stdint.h>

/** Most exponents at which a kind is judged. */
#define METHOD_POINTS_MAX 15

/** What a method finds, and how it is judged. */
typedef enum method_quantity {
    METHOD_POWER_OF_COSINE,
    METHOD_POWER_OF_SINE,
    METHOD_ROOT,
    METHOD_UNIT_VECTOR,
    METHOD_QUANTITIES
} method_quantity;

/** What methods of a kind are given, and what of it is enumerated. */
typedef struct method_problem {
    method_quantity quantity;
    const char *kind;
    const char *domain; /**< The inputs judged, for the table. No commas. */
    const char *unit;   /**< What instructions are counted for. */
    uint32_t units;     /**< Such units in one item. */
    uint32_t in_words, out_words;
    uint64_t size;         /**< Items enumerated. */
    uint32_t stride;       /**< One such item in so many is tried by the test suite. */
    const int32_t *points; /**< Exponents, Q16.16; null where there is none. */
    uint32_t point_count;  /**< At least 1. */
    int32_t bench_point;   /**< The exponent for which instructions are counted. */
    /** Item `index`; null where it is the index. */
    void (*input)(uint64_t index, int32_t *in);
    /** Item `i` of those that the benchmark runs: such as a picture has many of. */
    void (*bench_input)(uint32_t i, int32_t *in);
    /** The loop over items alone, with the loads and stores of a method; of one word where an item is many pixels. */
    void (*empty)(const int32_t *in, int32_t *out, uint32_t count);
} method_problem;

typedef struct method {
    const method_problem *problem;
    const char *name, *variant;
    const char *source; /**< Author and year; empty for what is folklore or glint's own. */
    int shipped;        /**< The library's own functions. */
    int32_t smallest;   /**< No smaller exponent is possible. */
    int32_t one;        /**< What stands for 1 in the output. */
    uint32_t table_bytes;
    void (*prepare)(int32_t p); /**< Builds tables; may be null. */
    void (*run)(const int32_t *in, int32_t *out, uint32_t count);
    /** Largest error at each of the problem's points, thousandths of an 8-bit step; 0 below `smallest`. */
    uint32_t error[METHOD_POINTS_MAX];
} method;

/** A row of a table of methods: the fields in their order, the errors last. */
#define METHOD(problem, name, variant, source, shipped, smallest, one, bytes, prepare, run, ...) \
    {                                                                                            \
        problem, name, variant, source, shipped, smallest, one, bytes, prepare, run, {           \
            __VA_ARGS__                                                                          \
        }                                                                                        \
    }

/** All methods of one kind. */
typedef struct method_list {
    const method *methods;
    uint32_t count;
} method_list;

#define METHOD_LIST(array) \
    { array, sizeof(array) / sizeof((array)[0]) }

extern const method_list methods_power, methods_normalise;

/** Number of methods. */
uint32_t methods_count(void);

/** Method `index`, kind by kind. */
const method *methods_get(uint32_t index);

/** The loop over items: `name` from `name_one`, which is inlined. */
#define METHOD_LOOP(name, in_words, out_words)                              \
    static void name(const int32_t *in, int32_t *out, uint32_t count) {     \
        for (; count != 0; count--, in += (in_words), out += (out_words)) { \
            name##_one(in, out);                                            \
        }                                                                   \
    }

/** 32 bits that look random, from any (after Wellons, "Prospecting for hash functions", 2018). */
static inline uint32_t method_hash(uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

/** The floor of the square root, bit by bit (Woo, 1985). */
static inline uint32_t method_square_root(uint32_t x) {
    uint32_t root = 0;
    for (uint32_t bit = 1u << 30; bit != 0; bit >>= 2) {
        if (x >= root + bit) {
            x -= root + bit;
            root = (root >> 1) + bit;
        } else {
            root >>= 1;
        }
    }
    return root;
}

#endif
