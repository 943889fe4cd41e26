/* SPDX-License-Identifier: MIT */
/**
 * @file mesh.h
 * Triangles in double precision, as read or generated, before they are quantised (quantise.h).
 */
#ifndef GLINT_HOST_MESH_H
#define GLINT_HOST_MESH_H

#include <stddef.h>
#include <stdint.h>

/** A corner's normal that is not there (yet). */
#define MESH_NO_NORMAL UINT32_MAX

/** Crease angle for mesh_make_normals: keep the normals that are there and smooth over every edge. */
#define MESH_NO_CREASE (-1.0)

typedef struct mesh_corner {
    uint32_t position;
    uint32_t normal; /**< Or MESH_NO_NORMAL. */
} mesh_corner;

/** Owns its arrays; zeroed it is an empty mesh. */
typedef struct host_mesh {
    double (*positions)[3];
    double (*normals)[3];        /**< Outward, unit length or all 0. */
    mesh_corner (*triangles)[3]; /**< Counter-clockwise seen from outside. */
    size_t position_count, position_capacity;
    size_t normal_count, normal_capacity;
    size_t triangle_count, triangle_capacity;
    size_t face_count;    /**< Faces that the triangles came from. */
    size_t group_count;   /**< Groups and objects named in the file. */
    size_t farthest_line; /**< Line of the largest coordinate; 0 when the mesh did not come from a file. */
} host_mesh;

/** An edge as one of its triangles runs along it, from corner `corner` to the next. */
typedef struct mesh_half_edge {
    uint32_t low, high; /**< The two points' numbers, the smaller one first. */
    size_t triangle;
    int corner;
    int forward; /**< 1 when it runs from `low` to `high`, else 0. */
} mesh_half_edge;

/** How well a mesh closes; positions with equal coordinates count as one point. */
typedef struct mesh_topology {
    size_t point_count;        /**< Different positions that triangles refer to. */
    size_t boundary_edges;     /**< Edges of one triangle only. */
    size_t inconsistent_edges; /**< Edges that both triangles run along the same way. */
    size_t shared_edges;       /**< Edges of more than two triangles. */
} mesh_topology;

/** Frees what a mesh owns and makes it empty. */
void mesh_free(host_mesh *mesh);

/** Appends a position. @return its index */
uint32_t mesh_add_position(host_mesh *mesh, double x, double y, double z);

/** Appends a normal, made unit length unless its length is 0. @return its index */
uint32_t mesh_add_normal(host_mesh *mesh, double x, double y, double z);

/** Appends a triangle. */
void mesh_add_triangle(host_mesh *mesh, mesh_corner a, mesh_corner b, mesh_corner c);

/**
 * Appends a polygon as triangles: a fan when it is convex (or has more than 1024 corners), else its ears are clipped
 * one by one.
 * @param corners `count` corners, at least 3, all with positions of the mesh
 */
void mesh_add_polygon(host_mesh *mesh, const mesh_corner *corners, size_t count);

/** Smallest box round the positions that triangles refer to; the mesh must have triangles. */
void mesh_bounds(const host_mesh *mesh, double low[3], double high[3]);

/** Scales positions per axis, and normals to fit; factors must not be 0. A mirrored mesh has its triangles turned. */
void mesh_scale(host_mesh *mesh, const double factors[3]);

/**
 * Gives normals to the corners that have none: area-weighted averages over the triangles round a position.
 * @param crease with an angle from 0 to 180 degrees all normals are made anew, and split at edges whose triangles turn
 *        by more than that; MESH_NO_CREASE to make the missing ones only, without splits
 */
void mesh_make_normals(host_mesh *mesh, double crease);

/** Cross product of two edges of a triangle: outward, twice its area long. */
void mesh_triangle_normal(const host_mesh *mesh, size_t triangle, double normal[3]);

/**
 * The three half edges of every triangle, sorted so that those of one edge are neighbours.
 * @param points number of the point that each position is
 * @return 3 triangle_count half edges; the caller frees them
 */
mesh_half_edge *mesh_half_edges(const host_mesh *mesh, const uint32_t *points);

/** Counts the edges that a closed, consistently wound mesh has none of. */
mesh_topology mesh_check_topology(const host_mesh *mesh);

#endif
