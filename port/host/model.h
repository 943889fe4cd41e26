/* SPDX-License-Identifier: MIT */
/**
 * @file model.h
 * Models: files, the materials that they name, and generated shapes.
 */
#ifndef GLINT_HOST_MODEL_H
#define GLINT_HOST_MODEL_H

#include "basics.h"
#include "glint.h"
#include "glint_extras.h"
#include "mesh.h"
#include "quantise.h"
#include "texture.h"

#include <stdint.h>

/*
 * Lines and tokens of Wavefront's text files, OBJ and MTL, and what is noted of them on the way.
 *
 * A statement is a line; a backslash at its end, blanks or not behind it, continues it on the next. `#` begins a
 * comment. Line ends are LF, CRLF or CR.
 */

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

/** Does the same with a name, and leaves out the quotes around it. */
text_token text_name(text_reader *reader);

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

/** Adds a warning for each note, as far as there is room: its word, the text of its kind, and its count. */
void text_notes_write(const text_notes *notes, const char *const texts[], host_warnings *warnings);

/*
 * Wavefront OBJ files.
 *
 * Read: `v` (3 coordinates; a weight after them is checked and skipped; a colour, 0 to 1, is kept when all have one),
 * `vn`, `vt` (2 coordinates, or 1; a third is skipped), and `f` with corners v, v/t, v//n or v/t/n, counting from 1 or,
 * negative, back from the last one read; a corner may refer only to what stands before it. Polygons become triangles.
 * `o` and `g` name the object of the faces after them: both names where both hold, and `o` ends a group. `usemtl` names
 * the material of the faces after it and `mtllib` the files of materials: a name is the rest of its line. Comments,
 * CRLF, lone CR, a backslash at a line's end that continues it, a byte order mark, and a last line without an end are
 * all right. `s` is the smoothing of the faces after it. Settings of other renderers are skipped.
 *
 * With a warning of each kind, at the first line of it: `usemap`, elements other than faces, and words that are no
 * keywords of the format are skipped with their line, as are faces of fewer than 3 corners; an index left empty after a
 * slash, or of a texture or a normal that is not there, and a normal that is not three finite numbers, are taken as not
 * given; a texture coordinate that is no numbers is 0 0; when a colour is above 1, all are taken as 0 to 255; when only
 * some positions have a colour, none is kept.
 *
 * What cannot be drawn is an error: no faces, positions that are not there, words where numbers should be, and colours
 * below 0 or above 255. A file without faces is called what it is by its first bytes, or by its first word that is no
 * keyword.
 */

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

/** Limit on objects that are kept apart. */
#define OBJ_OBJECTS_MAX 1024

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

/** The names in a file; zeroed there are none. */
typedef struct obj_materials {
    obj_names used;      /**< Names of usemtl: triangles of a mesh have 1 for the first of them. */
    obj_names libraries; /**< Of mtllib: a file's name, or several with blanks between them. */
    obj_names objects;   /**< Of o and g, likewise; triangles of those beyond the most have one more than there are. */
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

/**
 * Finds the place of a name, which is added when it is new and there are fewer than `most`.
 * @return their count when there is no room for it
 */
size_t obj_names_add(obj_names *names, text_token name, size_t line, size_t most);

/** Frees a list of names and makes it empty. */
void obj_names_free(obj_names *names);

/** Frees what obj_materials owns and makes it empty. */
void obj_materials_free(obj_materials *materials);

/*
 * Wavefront MTL files: the materials of an OBJ file.
 *
 * Read: `newmtl`, whose name is the rest of its line; `Ka`, `Kd`, `Ks` and `Ke`, with three numbers or one for all
 * channels; `Ns`; `illum` 0 to 2; `map_Kd` with `-clamp`, `-s` and `-o`. With a warning of each kind, at its first
 * line: `illum` 3 to 10 counts as 2, `d` below 1, `Tr` above 0 and `Tf` other than 1 are skipped, as are other textures
 * and other options of `map_Kd`, numbers out of range, what stands before the first `newmtl`, and other words. `Ni`,
 * which says nothing of an opaque surface, and `d 1` are skipped without.
 */

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
    MTL_OPACITY = 8,
};

/** A picture that a material names. */
typedef struct mtl_texture {
    char *name;                /**< Of a file of the model's folder, or of a picture within the model; null for none. */
    size_t line;               /**< That names it. */
    size_t library;            /**< The file of materials that names it, counted from 1; 0 for the model itself. */
    size_t picture;            /**< The picture within the model, counted from 1; 0 for a file. */
    bool clamps;               /**< Whether it does not repeat. */
    double cutoff;             /**< Texels whose alpha is below this are holes; 0 for none. */
    double transform[2][3];    /**< From the mesh's u, v, 1 to the picture's. */
    const glint_texture *made; /**< The picture (textures_load), or null. */
} mtl_texture;

/** A material as it stands in the file. */
typedef struct mtl_material {
    char *name;         /**< Ended by 0; bytes of 0 within are shown as '?'. */
    double ambient[3];  /**< Ka. */
    double diffuse[3];  /**< Kd. */
    double specular[3]; /**< Ks; 0 when not given. */
    double emission[3]; /**< Ke; 0 when not given. */
    double shininess;   /**< Ns. */
    double passed;      /**< Part of the light from behind that it lets through: 1 - d, Tr; below 1. */
    int illumination;   /**< illum: 0, 1 or 2, which holds when not given. */
    bool double_sided;  /**< Drawn from both sides where the surface is open; of glTF. */
    unsigned given;     /**< Bits of the enumeration above. */
    mtl_texture texture;
} mtl_material;

/** Owns its materials; zeroed it has none. */
typedef struct mtl_library {
    mtl_material *list;
    size_t count, capacity;
} mtl_library;

/**
 * Adds the materials of a file in memory to a library: any bytes will do, nothing in them is an error.
 * @param warnings added to, in the order of their lines
 */
void mtl_read(const char *text, size_t length, mtl_library *library, host_warnings *warnings);

/** Frees what a library owns and makes it empty. */
void mtl_free(mtl_library *library);

/*
 * The materials of a model: from the names in an OBJ file to what its MTL files say, and to the library's own.
 */

/** A file beside the model that was read: of materials or, of glTF, a buffer. */
typedef struct host_library {
    char *path;
    uint64_t hash; /**< FNV-1a, 64 bits, of its bytes. */
    host_warnings warnings;
} host_library;

/** Owns its arrays; zeroed it has no materials. */
typedef struct host_materials {
    mtl_library all;
    size_t *used; /**< Triangles of material i are of all.list[used[i - 1]]; those of material 0 are of none. */
    size_t used_count;
    obj_names objects; /**< Names of objects, as obj_materials has them. */
    host_library *libraries;
    size_t library_count, library_capacity;
    mtl_texture bare;     /**< Of triangles without a material; zeroed there is none. */
    host_bytes *pictures; /**< Files of pictures within the model. */
    size_t picture_count, picture_capacity;
    host_texture **textures; /**< That materials in use have, each once. */
    size_t texture_count, texture_capacity;
} host_materials;

/**
 * Names a material's picture, which repeats, has holes where alpha is below one half, and lies on the mesh as it is.
 * @param name `length` bytes
 */
void mtl_set_texture(mtl_texture *texture, const char *name, size_t length);

/** Says whether a path stays in the folder that it begins in: it is relative, and no part of it is `..`. */
bool path_is_inside(const char *path);

/**
 * Reads the MTL files that a model names, from its folder, and gives its triangles the materials that these define:
 * numbers that count from 1. Of several materials of one name the first holds. A name that none has leaves its
 * triangles without a material.
 * @param model the model's path
 * @param mesh its triangles are numbered as `named` has it, and then as `materials` has it
 * @param materials set, whatever it held before; the caller frees it with materials_free
 * @param warnings what is missing is added to these
 */
void materials_load(const char *model, obj_materials *named, host_mesh *mesh, host_materials *materials,
                    host_warnings *warnings);

/**
 * Gives the triangles of a mesh the materials of `materials->all`, by the names that they have; the rest as above.
 * @param named whose objects move to `materials`
 * @param materials with no material in use
 */
void materials_name(obj_materials *named, host_mesh *mesh, host_materials *materials, host_warnings *warnings);

/** The material of a number; null for 0. */
const mtl_material *materials_find(const host_materials *materials, uint32_t number);

/** Prints the warnings of the MTL files, a line each. */
void materials_print_warnings(const host_materials *materials);

/** Frees what materials_load made. */
void materials_free(host_materials *materials);

/*
 * The library's generators under names such as `torus:24x12` or `cone:32x4:1,2`, taken wherever a model file is: a
 * name, its counts unless it has none, and its sizes unless they are the usual ones.
 */

/** Most sizes of a shape. */
#define SHAPE_SIZES_MAX 3

/** How a picture lies on a shape. */
typedef enum shape_wrap {
    SHAPE_FLAT,  /**< On each side, seen from outside with y up; seen from the y axis, with z down or up. */
    SHAPE_ROUND, /**< Once round z from +x on, and from top to bottom; on caps flat. */
    SHAPE_SPHERE,
    SHAPE_TORUS /**< Likewise once round the tube, its middle outside. */
} shape_wrap;

/** What can be generated. */
typedef struct host_shape {
    const char *name;    /**< What stands before the first colon. */
    const char *syntax;  /**< What stands after the name. */
    const char *help;    /**< What counts and sizes mean, in a few words. */
    uint32_t least[2];   /**< Smallest value of each count; 0 when the shape has none. */
    uint32_t size_count; /**< How many sizes it has. */
    shape_wrap wrap;
    double sizes[SHAPE_SIZES_MAX];
    /** Calls the generator; what it returns is the library's. */
    glint_status (*generate)(glint_mesh *mesh, const glint_mesh_room *room, const uint32_t counts[2],
                             const glint_q16 sizes[SHAPE_SIZES_MAX]);
} host_shape;

/** All shapes, ended by one without a name. */
extern const host_shape host_shapes[];

/** The shape that a model's name begins with, or null when it is a file's name. */
const host_shape *shape_find(const char *name);

/** Adds to what is wrong with a file, whose name may have been meant as a shape's, which shapes there are. @return
 * false */
bool shape_offer(host_problem *problem);

/**
 * Generates the mesh of a name that shape_find knows, and reads it back.
 * @return false with a problem when counts or sizes are bad; nothing is then to be freed
 */
bool shape_make(const host_shape *shape, const char *name, host_mesh *mesh, host_problem *problem);

/* ---- A program run under limits, for what may crash, hang, or eat memory. Takes POSIX ---- */

/** What a program may take. */
typedef struct child_limits {
    unsigned seconds;   /**< Of time that passes, and of a core's. */
    unsigned megabytes; /**< Of memory, in units of 2^20 bytes. */
    size_t output;      /**< Bytes that it may print. */
} child_limits;

/**
 * Runs a program and keeps what it prints on stdout. It can write nothing into files. It is over when this returns,
 * whatever it did.
 * @param arguments the program, with or without its folder as for execvp, what it takes, and a null pointer
 * @param input bytes that it reads on stdin; null for none
 * @param out set; the caller frees its data
 * @return false with a problem of line 0 when it could not be run, did not end in time, printed too much, was ended by
 *         a signal, or has an exit status other than 0: then it says what its first line on stderr does; nothing is
 *         then to be freed
 */
bool child_run(char *const arguments[], const child_limits *limits, const host_bytes *input, host_bytes *out,
               host_problem *problem);

/*
 * Models and pictures in formats that nothing here reads, by the program glint-import (port/host/import), which is
 * there where libassimp-dev was when `make` ran. It runs under limits, and nothing that it prints is trusted: a model
 * is read as any OBJ file is. The environment variable GLINT_IMPORT names the program to run; else it is glint-import
 * in the folder of this one. Takes POSIX.
 */

/** Says whether a file's name has an ending, and that is not .obj, in letters of either case. */
bool importer_takes(const char *name);

/**
 * Loads a model. Positions that are the same, and have the same colour, become one.
 * @param mesh set up, whatever it held before; the caller frees it with mesh_free
 * @param materials set, whatever it held before; the caller frees it with materials_free
 * @param warnings set
 * @return false with a problem of line 0; nothing is then to be freed
 */
bool importer_load(const char *name, const child_limits *limits, host_mesh *mesh, host_materials *materials,
                   host_warnings *warnings, host_problem *problem);

/**
 * Decodes a JPEG file (ITU-T T.81), baseline or progressive, of grey or of colours; needs libjpeg-dev too.
 * @param limits of which `output` is not used: pictures of at most PICTURE_SIDE_MAX a side are taken
 * @return false with a problem of line 0; nothing is then to be freed
 */
bool importer_decode(const host_bytes *file, const child_limits *limits, host_picture *picture, host_problem *problem);

/* ---- Models in other formats that this program reads itself: STL, PLY, OFF, glTF and GLB (reader.h) ---- */

/** Says whether a file's name ends as those of these formats do, in letters of either case. */
bool reader_takes(const char *name);

/**
 * Reads a model. Positions that are the same, and have the same colour, become one.
 * @param name that reader_takes; files that glTF names are looked for in its folder
 * @param mesh set up, whatever it held before; the caller frees it with mesh_free
 * @param materials set, whatever it held before; the caller frees it with materials_free
 * @param warnings set
 * @return false with a problem; nothing is then to be freed
 */
bool reader_load(const char *name, const host_bytes *file, host_mesh *mesh, host_materials *materials,
                 host_warnings *warnings, host_problem *problem);

/* ---- A model by its name on the command line: a file or a generated shape ---- */

/** What becomes of a model when it is loaded. */
typedef struct load_options {
    mesh_normal_rule normals;
    bool facets;          /**< Facet normals in place of averages. */
    bool repair;          /**< Turn triangles that are wound the wrong way. */
    quantise_types types; /**< How the mesh is stored. */
    bool plain;           /**< Without clusters, in the order of the model. */
    bool objects;         /**< Objects stay apart. */
    double weld;          /**< Distance within which positions become one; below 0 for not at all. */
    size_t simplify;      /**< Most triangles; 0 for as many as there are. */
    child_limits import;  /**< For what reads other formats than OBJ, and pictures of JPEG. */
    texture_options texture;
    const char *picture; /**< In place of the textures that the model names, by its path as it stands; or null. */
} load_options;

/**
 * Makes the textures of the materials in use, and takes the mesh's coordinates to them. What cannot be read is warned
 * of. Corners of triangles without a texture lose their coordinates.
 * @param model its path
 * @param options of which `picture`, unless it is null, is the one that all materials have in place of their own: then
 * what has no material gets one
 * @param warnings of the model; those of a file of materials get its own
 * @return false with a problem when the chosen picture cannot be drawn
 */
bool textures_load(const char *model, const load_options *options, host_mesh *mesh, host_materials *materials,
                   host_warnings *warnings, host_problem *problem);

/** Bytes of flash that all textures take. */
size_t textures_size(const host_materials *materials);

/** Prints a line for each texture: its size, type, bytes, and ratio of peak signal to noise in decibels. */
void textures_print(const host_materials *materials);

/** Frees what textures_load made. */
void textures_free(host_materials *materials);

/** The triangles of one object that have one material. */
typedef struct model_part {
    uint32_t object, material;
} model_part;

/** A model with normals at every corner. */
typedef struct host_model {
    host_mesh mesh;
    host_materials materials; /**< As the triangles number them... */
    model_part *parts;        /**< ...or, where objects stay apart, as these do, which triangles number then. */
    uint64_t hash;            /**< FNV-1a, 64 bits, of the file's bytes, or of a shape's name. */
    size_t corner_count;      /**< Corners of all triangles... */
    size_t given_normals;     /**< ...and those of them whose normal came with the model. */
    size_t welded_count;      /**< Positions that became one with others. */
    size_t read_count;        /**< Triangles before the model was simplified... */
    double error;             /**< ...and by how much it moved, in the file's units. */
    size_t turned_count;      /**< Triangles turned by the repair. */
    host_warnings warnings;
    double low[3], high[3]; /**< Its box, as options have it (view.h). */
    double fit;             /**< By what it was then scaled to fit; 1 for not at all. */
    host_problem note;      /**< That says so; empty for not at all. */
} host_model;

/**
 * Loads a model and makes the normals that are missing.
 * @return false with a problem; nothing is then to be freed, else the model with model_free
 */
bool load_model(const char *name, const load_options *options, host_model *model, host_problem *problem);

/** Frees what load_model made. */
void model_free(host_model *model);

#endif
