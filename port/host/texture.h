/* SPDX-License-Identifier: MIT */
/**
 * @file texture.h
 * Pictures as textures of the library.
 */
#ifndef GLINT_HOST_TEXTURE_H
#define GLINT_HOST_TEXTURE_H

#include "glint.h"
#include "png.h"

#include <stdint.h>

/** Longest side that the library takes. */
#define TEXTURE_SIDE_MAX 1024u

/** A type is chosen whose mean squared error is at most this, of levels from 0 to 255: a ratio of peak signal to noise
 * of 35 dB. RGB565 itself has 42. */
#define TEXTURE_ERROR_MAX 20.56

typedef enum texture_type {
    TEXTURE_AUTO, /**< The smallest one within TEXTURE_ERROR_MAX. */
    TEXTURE_RGB565,
    TEXTURE_GREY8,
    TEXTURE_PALETTE256,
    TEXTURE_PALETTE16
} texture_type;

/** Their names on the command line, ended by a null pointer; those from the second on are the library's. */
extern const char *const texture_type_names[];

typedef struct texture_options {
    texture_type type;
    uint32_t side; /**< Longest side; 0 for TEXTURE_SIDE_MAX. */
    bool dither;   /**< Whether errors are spread over the next texels (Floyd and Steinberg, 1976). */
    bool levels;   /**< Whether it gets all smaller levels, down to one texel. */
} texture_options;

/** Levels of the largest texture beside itself. */
#define TEXTURE_LEVELS_MAX 10

typedef struct host_texture {
    glint_texture texture;                    /**< Its arrays are this module's. */
    glint_texture levels[TEXTURE_LEVELS_MAX]; /**< Its smaller ones, whose palette and key are its own. */
    size_t level_count;
    texture_type type; /**< Not auto. */
    size_t size;       /**< Bytes of flash of its arrays. */
    double error;      /**< Mean squared error of all texels that are no holes, of levels from 0 to 255. */
    char *name;        /**< Of the picture. */
    size_t picture;    /**< The picture within the model, counted from 1; 0 for a file. */
    uint64_t hash;     /**< FNV-1a, 64 bits, of its file. */
    double cutoff;     /**< Texels whose alpha is below this are holes; 0 for none. */
} host_texture;

/**
 * Makes a texture of a picture. Its sides become the nearest powers of two, and both are halved until the longer one is
 * within the options; each texel is the mean of the picture below it, and of a smaller level that of the texture below
 * it, in levels of the picture, not in linear light.
 * @param cutoff as above
 * @return the caller frees it with texture_free
 */
host_texture *texture_make(const host_picture *picture, double cutoff, const texture_options *options);

void texture_free(host_texture *texture);

/** Bytes of a texel array, for writers of source: of RGB565 the number of texels. */
size_t texture_items(const glint_texture *texture);

#endif
