/* SPDX-License-Identifier: MIT */
/**
 * @file convert.h
 * Parts of a converted header.
 */
#ifndef GLINT_HOST_CONVERT_H
#define GLINT_HOST_CONVERT_H

#include "command.h"
#include "output.h"

/** Room for what tells a piece's names from those of others: 40 characters of a material's name, and two numbers. */
typedef struct header_suffix {
    char text[64];
} header_suffix;

/** Prints a mesh as NAME_meshSUFFIX, behind its arrays. @param name at most 65 characters */
void convert_mesh(host_bytes *out, const char *name, const glint_mesh *mesh, const char *suffix);

/** A character as an identifier may have it: what is no letter, digit or underscore becomes an underscore. */
char convert_plain(char c);

/**
 * A suffix for each piece: empty for one piece without materials; its number where there are several; with materials
 * the name of its own, followed by numbers where that alone is not unique. @return the caller frees them
 */
header_suffix *convert_suffixes(const host_materials *materials, const quantised_mesh *mesh);

/** Prints the materials NAME_material_MATERIAL, and NAME_objects: an object for each piece. */
void convert_objects(host_bytes *out, const char *name, const host_settings *settings, const host_materials *materials,
                     const quantised_mesh *mesh, const header_suffix *suffixes);

#endif
