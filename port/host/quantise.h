/* SPDX-License-Identifier: MIT */
/**
 * @file quantise.h
 * Meshes in double precision into meshes as the library takes them.
 */
#ifndef GLINT_HOST_QUANTISE_H
#define GLINT_HOST_QUANTISE_H

#include "basics.h"
#include "glint.h"
#include "mesh.h"

/** Largest coordinate of a mesh: offset and extent then fit Q16.16 with room for a rounding. */
#define QUANTISE_COORDINATE_MAX 32766.0

/** Largest texture coordinate: beyond it all are as there. */
#define QUANTISE_TEXTURE_MAX 16000.0

/** Most triangles of a piece for each of its vertices; a closed surface has two. */
#define QUANTISE_SHARING_MAX 1024

typedef enum quantise_positions { QUANTISE_POSITIONS_INT16, QUANTISE_POSITIONS_INT8 } quantise_positions;

typedef enum quantise_normals {
    QUANTISE_NORMALS_INT16,
    QUANTISE_NORMALS_OCTAHEDRAL,  /**< Two int8. */
    QUANTISE_NORMALS_OCTAHEDRAL16 /**< Two int16. */
} quantise_normals;

typedef enum quantise_indices { QUANTISE_INDICES_16, QUANTISE_INDICES_8, QUANTISE_INDICES_AUTO } quantise_indices;

/** How a mesh is stored; all 0 for arrays of 16 bits. Pieces have arrays all the same, of the decoded numbers. */
typedef struct quantise_types {
    quantise_positions positions;
    quantise_normals normals;
    quantise_indices indices; /**< Auto: 8 bits for each piece of up to 256 vertices. */
} quantise_types;

/** Their names on the command line, each list ended by a null pointer. */
extern const char *const quantise_position_names[], *const quantise_normal_names[], *const quantise_index_names[];

/**
 * A mesh in as many pieces as its materials and 16-bit indices need, by rising material. All pieces have the same
 * offset and extent, so that nothing gapes between them. Owns its meshes and their arrays.
 */
typedef struct quantised_mesh {
    glint_mesh *pieces;
    uint32_t *materials; /**< Of the pieces: the numbers that their triangles have in the mesh. */
    uint32_t *objects;   /**< Likewise, where objects stay apart (command_prepare), else null. */
    size_t piece_count;
    size_t vertex_count;   /**< Of all pieces: different positions, normals, colours and texture coordinates. */
    size_t triangle_count; /**< Of all pieces. */
    size_t dropped_count;  /**< Triangles left out: two corners fell on one position. */
    double largest_move;   /**< Largest distance along an axis between a position and its quantised one. */
    double largest_turn;   /**< Largest angle between a normal and its quantised one, degrees. */
    quantise_types types;
} quantised_mesh;

/**
 * Quantises a mesh whose corners all have normals. Steps are within +-32767 and rounded to nearest, halves away from
 * zero, with the offset and extent as Q16.16 holds them; normals are unit length, 32767 for 1. Vertices stand in the
 * order of the positions, then normals, of `mesh`.
 * @param flags of every piece
 * @param types null for 16 bits. Positions of 8 bits are multiples of 256 within +-127 * 256; octahedral normals are
 * the nearest that can be stored
 * @return false with a problem when a coordinate is beyond QUANTISE_COORDINATE_MAX, no triangle is left, or 8 bits do
 *         not hold the indices that are to have them; nothing is then to be freed
 */
bool quantise(const host_mesh *mesh, uint32_t flags, const quantise_types *types, quantised_mesh *out,
              host_problem *problem);

/** Whether a piece's indices are stored in 8 bits. */
bool quantised_small_indices(const quantised_mesh *mesh, const glint_mesh *piece);

/** The code of an octahedral normal whose decoded numbers a piece has. */
void quantised_code(const quantised_mesh *mesh, const int16_t normal[3], int code[2]);

/** Gives each piece clusters, where they pay: its vertices and triangles are then in their order (cluster_mesh). */
void quantised_cluster(quantised_mesh *mesh);

/** Bytes of flash that its arrays take. */
size_t quantised_size(const quantised_mesh *mesh);

/** How many numbers a list of borrowers holds. */
uint32_t quantised_borrowers(const glint_clusters *clusters);

/** Frees what quantise and quantised_cluster made. */
void quantised_free(quantised_mesh *mesh);

/** Object-space position of a vertex, as the library sees it. */
void quantised_position(const glint_mesh *mesh, uint32_t vertex, double position[3]);

/*
 * Groups the triangles of a mesh into clusters (glint_cluster), so that those that face away are dropped together.
 */

/**
 * Gives a mesh clusters: puts its triangles and vertices into their order, which draws the same, and sets `clusters`.
 * Leaves a mesh as it is where clusters would not pay: one of few triangles, of triangles that all face much the same
 * way, or drawn from both sides.
 * @param mesh without clusters; what it points to must be the caller's to write
 */
void cluster_mesh(glint_mesh *mesh);

/** Frees what cluster_mesh made. */
void cluster_free(glint_mesh *mesh);

#endif
