/* SPDX-License-Identifier: MIT */
/**
 * @file mtl.h
 * Wavefront MTL files: the materials of an OBJ file.
 *
 * Read: `newmtl`, whose name is the rest of its line; `Ka`, `Kd`, `Ks` and `Ke`, with three numbers or one for all
 * channels; `Ns`; `illum` 0 to 2. With a warning of each kind, at its first line: `illum` 3 to 10 counts as 2, `d`
 * below 1, `Tr` above 0 and `Tf` other than 1 are skipped, as are textures, numbers out of range, what stands before
 * the first `newmtl`, and other words. `Ni`, which says nothing of an opaque surface, and `d 1` are skipped without.
 */
#ifndef GLINT_HOST_MTL_H
#define GLINT_HOST_MTL_H

#include "problem.h"

/** Largest channel of a colour: the library's. */
#define MTL_COLOUR_MAX 16.0

/** Largest exponent: what Q16.16 holds. */
#define MTL_SHININESS_MAX 32767.0

/** Most bytes of a file, and most materials. */
#define MTL_FILE_MAX 4000000u
#define MTL_MATERIALS_MAX 65536u

/** What of a material the file gives. */
enum {
    MTL_AMBIENT = 1,
    MTL_DIFFUSE = 2,
    MTL_SHININESS = 4,
};

/** A material as it stands in the file. */
typedef struct mtl_material {
    char *name;         /**< Ended by 0; bytes of 0 within are shown as '?'. */
    double ambient[3];  /**< Ka. */
    double diffuse[3];  /**< Kd. */
    double specular[3]; /**< Ks; 0 when not given. */
    double emission[3]; /**< Ke; 0 when not given. */
    double shininess;   /**< Ns. */
    int illumination;   /**< illum: 0, 1 or 2, which holds when not given. */
    unsigned given;     /**< Bits of the enumeration above. */
} mtl_material;

/** Owns its materials; zeroed it has none. */
typedef struct mtl_library {
    mtl_material *list;
    size_t count, capacity;
} mtl_library;

/**
 * Adds the materials of a file in memory to a library: any bytes will do, nothing in them is an error.
 * @param warnings set, in the order of their lines
 */
void mtl_read(const char *text, size_t length, mtl_library *library, host_warnings *warnings);

/** Frees what a library owns and makes it empty. */
void mtl_free(mtl_library *library);

#endif
