/* SPDX-License-Identifier: MIT */
/**
 * @file simplify.h
 * Meshes of fewer triangles, by meshoptimizer (Debian's libmeshoptimizer-dev), where the program was built with it.
 */
#ifndef GLINT_HOST_SIMPLIFY_H
#define GLINT_HOST_SIMPLIFY_H

#include "mesh.h"
#include "problem.h"

/**
 * Brings a mesh to at most `most` triangles: edges are collapsed into one of their ends, those first that move the
 * surface least (quadrics, Garland and Heckbert, 1997), and never so that the surface tears, or parts of different
 * materials or colours part. Positions that are the same must be one (mesh_join). Triangles and positions come into an
 * order in which neighbours follow each other. A corner takes, of the normals that its position had, the one nearest to
 * its triangle's own.
 * @param error set to the geometric error that meshoptimizer tells, in the mesh's units; 0 where it has no more
 *        triangles as it is
 * @return false with a problem when that many are too few for it, or meshoptimizer is missing; the mesh is then as it
 *         was
 */
bool mesh_simplify(host_mesh *mesh, size_t most, double *error, host_problem *problem);

#endif
