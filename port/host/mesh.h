/* SPDX-License-Identifier: MIT */
/**
 * @file mesh.h
 * Triangles in double precision, as read or generated, before they are quantised (quantise.h).
 */
#ifndef GLINT_HOST_MESH_H
#define GLINT_HOST_MESH_H

#include "basics.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** A corner's normal that is not there (yet). */
#define MESH_NO_NORMAL UINT32_MAX

/** Smoothing of triangles. From 2 on it is a smoothing group: triangles of one group are smooth where they meet. */
enum {
    MESH_BY_CREASE, /**< The angle between triangles decides. */
    MESH_FACETED    /**< Sharp at all edges. */
};

typedef struct mesh_corner {
    uint32_t position;
    uint32_t normal;  /**< Or MESH_NO_NORMAL. */
    uint32_t texture; /**< Its texture coordinates, counted from 1; 0 for none. */
} mesh_corner;

/** Owns its arrays; zeroed it is an empty mesh. */
typedef struct host_mesh {
    double (*positions)[3];
    double (*normals)[3];        /**< Outward, unit length or all 0. */
    double (*textures)[2];       /**< Texture coordinates: u from the left edge, v from the top one. */
    mesh_corner (*triangles)[3]; /**< Counter-clockwise seen from outside. */
    uint8_t (*colours)[3];       /**< Of the positions, 255 for 1; null when there are none. */
    uint32_t *materials;         /**< Of the triangles: 0 for none, else as whoever added them numbers materials. */
    uint32_t *objects;           /**< Of the triangles, likewise: objects that the file names. */
    uint32_t *smoothing;         /**< Of the triangles, as above. */
    uint32_t material, object, smooth; /**< Of triangles that are added. */
    size_t position_count, position_capacity;
    size_t normal_count, normal_capacity;
    size_t texture_count, texture_capacity;
    size_t triangle_count, triangle_capacity, material_capacity, object_capacity, smoothing_capacity;
    size_t colour_count, colour_capacity; /**< position_count, or 0 when there are none. */
    uint64_t clip_steps;                  /**< Corners looked at to clip ears, of all polygons. */
    size_t face_count;                    /**< Faces that the triangles came from. */
    size_t group_count;                   /**< Groups and objects named in the file. */
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

/** How a mesh is wound, part by part; a part hangs together by edges that exactly two triangles share. */
typedef struct mesh_winding {
    size_t part_count;
    size_t mixed_parts;     /**< With triangles that are wound against each other. */
    size_t inward_parts;    /**< Closed, consistently wound, and inside out. */
    size_t one_sided_parts; /**< That no winding makes consistent. */
} mesh_winding;

/** What triangles weigh in the normal of a corner that they share. */
typedef enum mesh_weights {
    MESH_BY_AREA,  /**< Their areas. */
    MESH_BY_ANGLE, /**< Their angles there (Thuermer and Wuethrich, 1998): cutting a face up changes nothing. */
    MESH_EQUAL     /**< All the same (Gouraud, 1971); those without area nothing. */
} mesh_weights;

/** Their names on the command line, ended by a null pointer. */
extern const char *const mesh_weight_names[];

/** Frees what a mesh owns and makes it empty. */
void mesh_free(host_mesh *mesh);

/** Appends a position. @return its index */
uint32_t mesh_add_position(host_mesh *mesh, double x, double y, double z);

/** Appends a normal, made unit length unless its length is 0. @return its index */
uint32_t mesh_add_normal(host_mesh *mesh, double x, double y, double z);

/** Appends texture coordinates; those that are not finite become 0. @return their number, from 1 */
uint32_t mesh_add_texture(host_mesh *mesh, double u, double v);

/** Appends the colour of the next position that has none, each channel 0 to 255. */
void mesh_add_colour(host_mesh *mesh, uint8_t r, uint8_t g, uint8_t b);

/** Appends a triangle. */
void mesh_add_triangle(host_mesh *mesh, mesh_corner a, mesh_corner b, mesh_corner c);

/**
 * Appends a polygon as triangles: a fan when it is convex (or has more than 1024 corners), else its ears are clipped
 * one by one.
 * @param corners `count` corners, at least 3, all with positions of the mesh
 * @return false when this and those before take too long; not all of it is then added
 */
bool mesh_add_polygon(host_mesh *mesh, const mesh_corner *corners, size_t count);

/** Smallest box round the positions that triangles refer to; the mesh must have triangles. */
void mesh_bounds(const host_mesh *mesh, double low[3], double high[3]);

/** Scales positions per axis, and normals to fit; factors must not be 0. A mirrored mesh has its triangles turned. */
void mesh_scale(host_mesh *mesh, const double factors[3]);

/** Moves positions so that `origin` comes to lie at the origin. */
void mesh_move_to_origin(host_mesh *mesh, const double origin[3]);

/** Turns positions and normals about an axis, right-handed, by an angle of that cosine and sine. */
void mesh_turn(host_mesh *mesh, int axis, double cosine, double sine);

/** How normals are made. */
typedef struct mesh_normal_rule {
    double crease; /**< Degrees, 0 to 180: by crease, edges whose triangles turn by more are sharp. */
    bool anew;     /**< Make all normals, and do not follow the triangles' smoothing. */
    mesh_weights weights;
} mesh_normal_rule;

/**
 * Gives normals to the corners that have none: weighted averages over the triangles round a position, up to sharp
 * edges. Triangles meet where they have positions of the same number or, in a mesh with colours, at the same place;
 * those too thin to have a normal take part with that of the surface they lie in.
 */
void mesh_make_normals(host_mesh *mesh, const mesh_normal_rule *rule);

/** Makes all normals anew: the triangles' own. */
void mesh_make_facet_normals(host_mesh *mesh);

/**
 * Makes one of positions that lie no farther than `distance` from each other and have the same colour: in their order,
 * each joins the first one that stays within the distance, or stays. Triangles keep their normals; some may then have
 * two corners at one position.
 * @param distance 0 for equal coordinates
 * @return how many are gone
 */
size_t mesh_join(host_mesh *mesh, double distance);

/** Gives equal numbers to positions with equal coordinates; the caller frees the numbers. */
uint32_t *mesh_weld(const host_mesh *mesh);

/** Looks at how the mesh is wound. */
mesh_winding mesh_check_winding(const host_mesh *mesh);

/**
 * Marks materials of which backs may be seen: a triangle of theirs is of a part that is open, or not wound outwards.
 * @param marks by the triangles' materials, false at first
 */
void mesh_mark_open(const host_mesh *mesh, bool *marks);

/**
 * Turns triangles so that each part is wound consistently and faces outwards: away from the volume that it encloses or,
 * when it is open, from its middle. A flat part keeps the way in which most of its area faces; a one-sided one stays.
 * Normals of turned triangles that then face backwards are turned too.
 * @return the number of triangles turned
 */
size_t mesh_repair_winding(host_mesh *mesh);

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

/*
 * Meshes of fewer triangles, by meshoptimizer (Debian's libmeshoptimizer-dev), where the program was built with it.
 */

/**
 * Brings a mesh to at most `most` triangles: edges are collapsed into one of their ends, those first that move the
 * surface least (quadrics, Garland and Heckbert, 1997), and never so that the surface tears, or parts of different
 * materials, colours or texture coordinates part. Positions that are the same must be one (mesh_join). Triangles and
 * positions come into an order in which neighbours follow each other. A corner takes, of the normals that its position
 * had, the one nearest to its triangle's own.
 * @param error set to the geometric error that meshoptimizer tells, in the mesh's units; 0 where it has no more
 *        triangles as it is
 * @return false with a problem when that many are too few for it, or meshoptimizer is missing; the mesh is then as it
 *         was
 */
bool mesh_simplify(host_mesh *mesh, size_t most, double *error, host_problem *problem);

#endif
