/* SPDX-License-Identifier: MIT */
/**
 * @file convert.h
 * Parts of what the converter writes: a header, or a source and its header.
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

/** Where and as what a file's meshes, materials and objects are printed. */
typedef struct convert_names {
    host_bytes *out;
    const char *storage; /* such as "static const" */
    const char *name;
    const header_suffix *suffixes; /* a piece each */
} convert_names;

/** Prints the materials NAME_material_MATERIAL, and NAME_objects: an object for each piece. */
void convert_objects(const convert_names *names, const host_settings *settings, const host_materials *materials,
                     const quantised_mesh *mesh);

/** Declares what a source defines: the meshes, and the materials and objects that there are. */
void convert_declarations(const convert_names *names, const host_materials *materials, const quantised_mesh *mesh);

/** Whether an output's name asks for a source and its header: it ends with .c. False for null. */
bool convert_is_pair(const char *output);

/** The header's name of a source's. @return the caller frees it */
char *convert_header_of(const char *source);

/** Whether a pair can have the names that it would; says why not. True for what is no pair. */
bool convert_check_pair(const host_settings *settings);

#endif
