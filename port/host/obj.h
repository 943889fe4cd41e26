/* SPDX-License-Identifier: MIT */
/**
 * @file obj.h
 * Wavefront OBJ files.
 *
 * Read: `v` (3 coordinates; a weight after them is checked and skipped; a colour, 0 to 1, is kept when all have one),
 * `vn`, `vt` (checked and skipped), and `f` with corners v, v/t, v//n or v/t/n, counting from 1 or, negative, back from
 * the last one read; a corner may refer only to what stands before it. Polygons become triangles. `g` and `o` are
 * counted. Comments, CRLF, lone CR, a backslash at a line's end that continues it, a byte order mark, and a last line
 * without an end are all right. Smoothing groups and settings of other renderers are skipped.
 *
 * With a warning of each kind, at the first line of it: materials, elements other than faces, and words that are no
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

/**
 * Reads a model from memory. Corners without a normal, or whose normal is of length 0, get MESH_NO_NORMAL.
 * @param text `length` bytes, any, not terminated
 * @param mesh set up, whatever it held before; the caller frees it with mesh_free
 * @param warnings set, in the order of their lines but for the colours'
 * @return false with a problem; nothing is then to be freed
 */
bool obj_read(const char *text, size_t length, host_mesh *mesh, host_warnings *warnings, host_problem *problem);

#endif
