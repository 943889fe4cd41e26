/* SPDX-License-Identifier: MIT */
/**
 * @file obj.h
 * Wavefront OBJ files.
 *
 * Read: `v` (3 coordinates; a weight after them is checked and skipped; a colour, 0 to 1, is kept when all have one),
 * `vn`, `vt` (checked and skipped), and `f` with corners v, v/t, v//n or v/t/n, counting from 1 or, negative, back from
 * the last one read; a corner may refer only to what stands before it. Polygons become triangles. `g` and `o` are
 * counted. `usemtl` names the material of the faces after it and `mtllib` the files of materials: a name is the rest of
 * its line. Comments, CRLF, lone CR, a backslash at a line's end that continues it, a byte order mark, and a last line
 * without an end are all right. Smoothing groups and settings of other renderers are skipped.
 *
 * With a warning of each kind, at the first line of it: textures, elements other than faces, and words that are no
 * keywords of the format are skipped with their line; an index left empty after a slash is taken as not given; when a
 * colour is above 1, all are taken as 0 to 255; when only some positions have a colour, none is kept.
 *
 * What cannot be drawn is an error: no faces, indices of what is not there, words where numbers should be, and colours
 * below 0 or above 255. In a file without faces it is the first word that is no keyword, for it is of another kind.
 */
#ifndef GLINT_HOST_OBJ_H
#define GLINT_HOST_OBJ_H

#include "mesh.h"
#include "problem.h"

/** Largest coordinate that is read; what Q16.16 holds is far less, but a model may be scaled first. */
#define OBJ_COORDINATE_MAX 1e30

/** Most bytes of a file, and most positions, normals and triangles: far more than microcontrollers hold. */
#define OBJ_FILE_MAX 500000000u
#define OBJ_ITEMS_MAX 4000000u

/** Most corners of a face. */
#define OBJ_CORNERS_MAX 65536u

/** Most different materials that faces name. */
#define OBJ_MATERIALS_MAX 1024

/** Most different files of materials. */
#define OBJ_LIBRARIES_MAX 64

/** A name in the file, and its first line. */
typedef struct obj_name {
    char *text; /**< Ended by 0; bytes of 0 within are shown as '?'. */
    size_t line;
} obj_name;

/** Slots to find a name by: twice the most of them. */
#define OBJ_NAME_SLOTS 2048

/** Different names in the order of the file; owns them. */
typedef struct obj_names {
    uint16_t slots[OBJ_NAME_SLOTS]; /**< The place of a name plus one, by hash; 0 for free. */
    obj_name *list;
    size_t count, capacity;
} obj_names;

/** What the file says of materials; zeroed it is empty. */
typedef struct obj_materials {
    obj_names used;      /**< Names of usemtl: triangles of a mesh have 1 for the first of them. */
    obj_names libraries; /**< Of mtllib: a file's name, or several with blanks between them. */
} obj_materials;

/**
 * Reads a model from memory. Corners without a normal, or whose normal is of length 0, get MESH_NO_NORMAL.
 * @param text `length` bytes, any, not terminated
 * @param mesh set up, whatever it held before; the caller frees it with mesh_free
 * @param materials set, whatever it held before; the caller frees it with obj_materials_free
 * @param warnings set, in the order of their lines but for the colours'
 * @return false with a problem; nothing is then to be freed
 */
bool obj_read(const char *text, size_t length, host_mesh *mesh, obj_materials *materials, host_warnings *warnings,
              host_problem *problem);

/** Frees what obj_materials owns and makes it empty. */
void obj_materials_free(obj_materials *materials);

#endif
