/* SPDX-License-Identifier: MIT */
/**
 * @file quantise.h
 * Meshes in double precision into meshes as the library takes them.
 */
#ifndef GLINT_HOST_QUANTISE_H
#define GLINT_HOST_QUANTISE_H

#include "glint.h"
#include "mesh.h"
#include "problem.h"

/** Largest coordinate of a mesh: offset and extent then fit Q16.16 with room for a rounding. */
#define QUANTISE_COORDINATE_MAX 32766.0

/**
 * A mesh in as many pieces as its materials and 16-bit indices need, by rising material. All pieces have the same
 * offset and extent, so that nothing gapes between them. Owns its meshes and their arrays.
 */
typedef struct quantised_mesh {
    glint_mesh *pieces;
    uint32_t *materials; /**< Of the pieces: the numbers that their triangles have in the mesh. */
    size_t piece_count;
    size_t vertex_count;   /**< Of all pieces: different (position, normal, colour) triples. */
    size_t triangle_count; /**< Of all pieces. */
    size_t dropped_count;  /**< Triangles left out: two corners fell on one position. */
    double largest_move;   /**< Largest distance along an axis between a position and its quantised one. */
} quantised_mesh;

/**
 * Quantises a mesh whose corners all have normals. Steps are within +-32767 and rounded to nearest, halves away from
 * zero, with the offset and extent as Q16.16 holds them; normals are unit length, 32767 for 1. Vertices stand in the
 * order of the positions, then normals, of `mesh`.
 * @param flags of every piece
 * @return false with a problem when a coordinate is beyond QUANTISE_COORDINATE_MAX or no triangle is left; nothing is
 *         then to be freed
 */
bool quantise(const host_mesh *mesh, uint32_t flags, quantised_mesh *out, host_problem *problem);

/** Gives each piece clusters, where they pay: its vertices and triangles are then in their order (cluster.h). */
void quantised_cluster(quantised_mesh *mesh);

/** Bytes of flash that its arrays take. */
size_t quantised_size(const quantised_mesh *mesh);

/** How many numbers a list of borrowers holds. */
uint32_t quantised_borrowers(const glint_clusters *clusters);

/** Frees what quantise and quantised_cluster made. */
void quantised_free(quantised_mesh *mesh);

/** Object-space position of a vertex, as the library sees it. */
void quantised_position(const glint_mesh *mesh, uint32_t vertex, double position[3]);

#endif
