/* SPDX-License-Identifier: MIT */
/**
 * @file reader.h
 * Readers of formats beside OBJ: STL, PLY, OFF and glTF. What a file says is judged by what it draws: a number that no
 * triangle depends on may be anything, and what is not followed gets one warning.
 */
#ifndef GLINT_HOST_READER_H
#define GLINT_HOST_READER_H

#include "basics.h"
#include "mesh.h"
#include "model.h"

/** A model while it is read. Its mesh and materials are empty at first. */
typedef struct model_reader {
    const char *path; /**< Of the file: others that it names are looked for in its folder. */
    const uint8_t *data;
    size_t size;
    size_t line; /**< That problems and warnings are of; 0 in binary files. */
    host_mesh *mesh;
    host_materials *materials;
    host_warnings *warnings;
    host_problem *problem;
    bool *unfit; /**< Of the positions: whether one is not finite or too large, and stands as 0. */
    size_t unfit_capacity;
    bool coloured;     /**< Whether a colour other than white was read. */
    bool see_through;  /**< Whether a colour lets light through. */
    size_t thin_count; /**< Faces that were skipped: they have fewer than three corners. */
    mesh_corner *face; /**< Corners of the face that is read. */
    size_t face_count, face_capacity;
} model_reader;

/** Notes a problem of the current line. @return false */
bool reader_fail(model_reader *reader, const char *format, ...) PROBLEM_PRINTF(2, 3);

/** Adds a warning of the current line, as far as there is room. */
void reader_warn(model_reader *reader, const char *format, ...) PROBLEM_PRINTF(2, 3);

/**
 * Adds a position.
 * @param position any numbers
 * @param colour from 0 to 1, or null for white
 * @return false with a problem when there are too many
 */
bool reader_add_position(model_reader *reader, const double position[3], const double *colour);

/** Adds a normal. @return its number, MESH_NO_NORMAL when it is not finite or of length 0 */
uint32_t reader_add_normal(model_reader *reader, const double normal[3]);

/** Adds a corner to the face. */
void reader_add_corner(model_reader *reader, mesh_corner corner);

/** Gives the face a colour: its corners get positions of their own. @return false with a problem for too many */
bool reader_colour_face(model_reader *reader, const double colour[3]);

/**
 * Adds the face and begins another one.
 * @param flat its triangles get their own normals
 * @return false with a problem when it has a position that is not finite, or is too much
 */
bool reader_end_face(model_reader *reader, bool flat);

/** Starts an object; `length` bytes name it. */
void reader_start_object(model_reader *reader, const char *name, size_t length);

/**
 * Finds the number that a text's token stands for.
 * @param value set; words for what is not finite, such as `nan`, are NAN
 * @return false with a problem when it is no number
 */
bool reader_number(model_reader *reader, text_token token, double *value);

/** The next token of a text, on whatever line. @return false with a problem at the text's end */
bool reader_next_token(model_reader *reader, text_reader *text, text_token *token);

/** The rest of a line without the blanks around it, whatever it holds. */
text_token reader_rest_of_line(text_reader *text);

/** Returns whether a token is a word, in letters of either case. */
bool reader_token_is(text_token token, const char *word);

/** Reads a float of 32 bits, least significant byte first. */
double reader_float(const uint8_t *bytes);

/** Reads an unsigned number of 1 to 8 bytes, least significant byte first. */
uint64_t reader_unsigned(const uint8_t *bytes, size_t size);

/* Each reads a whole file. @return false with a problem; whatever was made so far is the caller's to free. */
bool stl_read(model_reader *reader);
bool ply_read(model_reader *reader);
bool off_read(model_reader *reader);
bool gltf_read(model_reader *reader);

#endif
