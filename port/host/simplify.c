/* SPDX-License-Identifier: MIT */
#include "mesh.h"

#include "basics.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#ifdef HOST_WITH_MESHOPTIMIZER

#include <meshoptimizer.h>

/**
 * A vertex is a position with a material and texture coordinates: where two of either meet, there are two, and they are
 * collapsed together.
 */
typedef struct simplifier {
    host_mesh *mesh;
    unsigned *indices;  /* 3 for each triangle */
    uint32_t *position; /* of each vertex */
    uint32_t *material, *texture;
    float (*places)[3]; /* about the middle, the largest coordinate 1: floats are finest so */
    size_t index_count, vertex_count;
    double scale; /* from those to the mesh's units */
} simplifier;

/* ---- Vertices --------------------------------------------------------------------------------------------------- */

/** The corners' order by position, then material and texture coordinates. */
typedef struct placed_corner {
    uint32_t position, material, texture;
    size_t corner;
} placed_corner;

static int compare_corners(const void *left, const void *right) {
    const placed_corner *a = left;
    const placed_corner *b = right;
    if (a->position != b->position) {
        return a->position < b->position ? -1 : 1;
    }
    if (a->material != b->material) {
        return a->material < b->material ? -1 : 1;
    }
    if (a->texture != b->texture) {
        return a->texture < b->texture ? -1 : 1;
    }
    return (a->corner > b->corner) - (a->corner < b->corner);
}

static bool has_area(const mesh_corner triangle[3]) {
    return triangle[0].position != triangle[1].position && triangle[1].position != triangle[2].position &&
           triangle[2].position != triangle[0].position;
}

/** Corners of triangles that have three positions, in their order; the caller frees them. */
static placed_corner *list_corners(simplifier *made) {
    const host_mesh *mesh = made->mesh;
    placed_corner *list = memory_new(3 * mesh->triangle_count, sizeof *list);
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        const mesh_corner corner = mesh->triangles[i / 3][i % 3];
        if (has_area(mesh->triangles[i / 3])) {
            list[made->index_count] =
                (placed_corner){corner.position, mesh->materials[i / 3], corner.texture, made->index_count};
            made->index_count++;
        }
    }
    return list;
}

static void number_vertices(simplifier *made) {
    placed_corner *list = list_corners(made);
    made->indices = memory_new(made->index_count, sizeof *made->indices);
    made->position = memory_new(made->index_count, sizeof *made->position);
    made->material = memory_new(made->index_count, sizeof *made->material);
    made->texture = memory_new(made->index_count, sizeof *made->texture);
    qsort(list, made->index_count, sizeof *list, compare_corners);
    for (size_t i = 0; i < made->index_count; i++) {
        if (i == 0 || list[i].position != list[i - 1].position || list[i].material != list[i - 1].material ||
            list[i].texture != list[i - 1].texture) {
            made->position[made->vertex_count] = list[i].position;
            made->texture[made->vertex_count] = list[i].texture;
            made->material[made->vertex_count++] = list[i].material;
        }
        made->indices[list[i].corner] = (unsigned)made->vertex_count - 1;
    }
    free(list);
}

static void place_vertices(simplifier *made) {
    double low[3];
    double high[3];
    mesh_bounds(made->mesh, low, high);
    for (int axis = 0; axis < 3; axis++) {
        made->scale = fmax(made->scale, high[axis] / 2 - low[axis] / 2);
    }
    made->places = memory_new(made->vertex_count, sizeof *made->places);
    for (size_t i = 0; i < 3 * made->vertex_count; i++) {
        const size_t axis = i % 3;
        const double middle = low[axis] / 2 + high[axis] / 2;
        const double at = made->mesh->positions[made->position[i / 3]][axis] - middle;
        made->places[i / 3][axis] = (float)(made->scale > 0 ? at / made->scale : 0);
    }
}

/* ---- Normals ---------------------------------------------------------------------------------------------------- */

/** Normals that the positions had, those of a position one after the other. */
typedef struct old_normals {
    size_t *starts; /* of each position, and the end of all */
    uint32_t *list;
} old_normals;

static old_normals list_normals(const host_mesh *mesh) {
    old_normals old = {memory_new(mesh->position_count + 2, sizeof *old.starts),
                       memory_new(3 * mesh->triangle_count, sizeof *old.list)};
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        old.starts[mesh->triangles[i / 3][i % 3].position + 2]++;
    }
    for (size_t i = 2; i < mesh->position_count + 2; i++) {
        old.starts[i] += old.starts[i - 1];
    }
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        const mesh_corner corner = mesh->triangles[i / 3][i % 3];
        old.list[old.starts[corner.position + 1]++] = corner.normal;
    }
    return old;
}

/** Of the normals that a position had the one that is nearest to a direction, or none. */
static uint32_t find_normal(const host_mesh *mesh, const old_normals *old, uint32_t position, const double facing[3]) {
    uint32_t best = MESH_NO_NORMAL;
    double most = -HUGE_VAL;
    for (size_t i = old->starts[position]; i < old->starts[position + 1]; i++) {
        const uint32_t normal = old->list[i];
        const double *n = normal != MESH_NO_NORMAL ? mesh->normals[normal] : NULL;
        const double dot = n != NULL ? n[0] * facing[0] + n[1] * facing[1] + n[2] * facing[2] : most;
        if (dot > most) {
            most = dot;
            best = normal;
        }
    }
    return best;
}

static void choose_normals(host_mesh *mesh, const old_normals *old) {
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        double facing[3];
        mesh_triangle_normal(mesh, i, facing);
        for (int j = 0; j < 3; j++) {
            mesh_corner *corner = &mesh->triangles[i][j];
            corner->normal = find_normal(mesh, old, corner->position, facing);
        }
    }
}

/* ---- Folds ------------------------------------------------------------------------------------------------------ */

/** Times that all triangles are looked at for folds: each swap may lay bare another one. */
#define FOLD_ROUNDS_MAX 32

#define NO_POSITION UINT32_MAX

/** Cosine to the surface below which a triangle is a fold: those on edge, and what quantising turns over, too. */
#define FOLD_COSINE 0.02

/**
 * Collapses turn a triangle a little each, and some over in the end: folds. Of such a triangle an edge is swapped
 * for the other diagonal of the two triangles there; or a position that it and two others surround is dropped; or it is
 * dropped with another one that lies on it.
 */
typedef struct unfolder {
    host_mesh *mesh;
    double (*facings)[3];  /* of each position in the surface as it was */
    mesh_half_edge *edges; /* of this round */
    uint8_t *touched;      /* positions of this round's swaps, round which edges are no longer those */
} unfolder;

/**
 * Finds how the surface faces at each position: along an axis where all triangles do, as those of a terrain, or else
 * along the sum of the normals, by area, of the triangles there. The caller frees them.
 */
static double (*list_facings(const host_mesh *mesh))[3] {
    double(*facings)[3] = memory_new(mesh->position_count, sizeof *facings);
    bool along[3][2] = {{true, true}, {true, true}, {true, true}};
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        double normal[3];
        mesh_triangle_normal(mesh, i / 3, normal);
        for (int axis = 0; axis < 3; axis++) {
            facings[mesh->triangles[i / 3][i % 3].position][axis] += normal[axis];
            along[axis][0] = along[axis][0] && normal[axis] > 0;
            along[axis][1] = along[axis][1] && normal[axis] < 0;
        }
    }
    for (int axis = 0; axis < 3; axis++) {
        for (size_t i = 0; (along[axis][0] || along[axis][1]) && i < mesh->position_count; i++) {
            const double sign = along[axis][0] ? 1 : -1;
            memcpy(facings[i], (double[3]){0, 0, 0}, sizeof facings[i]);
            facings[i][axis] = sign;
        }
    }
    return facings;
}

/** Cosine of the angle between a triangle and the surface that was at its corners; 1 where either has no direction. */
static double cosine_to_surface(const unfolder *work, size_t triangle) {
    double normal[3];
    double facing[3] = {0, 0, 0};
    mesh_triangle_normal(work->mesh, triangle, normal);
    for (int i = 0; i < 9; i++) {
        facing[i % 3] += work->facings[work->mesh->triangles[triangle][i / 3].position][i % 3];
    }
    const double dot = normal[0] * facing[0] + normal[1] * facing[1] + normal[2] * facing[2];
    const double square = (normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]) *
                          (facing[0] * facing[0] + facing[1] * facing[1] + facing[2] * facing[2]);
    return square > 0 ? dot / sqrt(square) : 1.0;
}

/** Finds the first half edge between two positions; `count` is how many there are. */
static size_t find_edge(const unfolder *work, uint32_t a, uint32_t b, size_t *count) {
    const uint32_t low = a < b ? a : b;
    const uint32_t high = a < b ? b : a;
    const mesh_half_edge *edges = work->edges;
    const size_t all = 3 * work->mesh->triangle_count;
    size_t first = 0;
    for (size_t end = all; first < end;) {
        const size_t middle = first + (end - first) / 2;
        if (edges[middle].low < low || (edges[middle].low == low && edges[middle].high < high)) {
            first = middle + 1;
        } else {
            end = middle;
        }
    }
    *count = 0;
    while (first + *count < all && edges[first + *count].low == low && edges[first + *count].high == high) {
        (*count)++;
    }
    return first;
}

/** Returns whether two triangles have the same texture coordinates where they meet. */
static bool is_joined(const host_mesh *mesh, size_t first, size_t second) {
    for (int i = 0; i < 9; i++) {
        const mesh_corner a = mesh->triangles[first][i / 3];
        const mesh_corner b = mesh->triangles[second][i % 3];
        if (a.position == b.position && a.texture != b.texture) {
            return false;
        }
    }
    return true;
}

/** Swaps the edge behind a corner of a triangle where that leaves less of a fold. @return whether it did */
static bool swap_edge(unfolder *work, size_t triangle, int corner) {
    host_mesh *mesh = work->mesh;
    mesh_corner *here = mesh->triangles[triangle];
    size_t count;
    const size_t first = find_edge(work, here[corner].position, here[(corner + 1) % 3].position, &count);
    const mesh_half_edge *edge = work->edges + first;
    if (count != 2 || edge[0].forward == edge[1].forward ||
        mesh->materials[edge[0].triangle] != mesh->materials[edge[1].triangle] ||
        !is_joined(mesh, edge[0].triangle, edge[1].triangle)) {
        return false;
    }
    const mesh_half_edge *across = edge[0].triangle == triangle ? &edge[1] : &edge[0];
    mesh_corner *there = mesh->triangles[across->triangle];
    const mesh_corner ends[2] = {here[corner], here[(corner + 1) % 3]};
    const mesh_corner tips[2] = {here[(corner + 2) % 3], there[(across->corner + 2) % 3]};
    uint8_t *touched = work->touched;
    find_edge(work, tips[0].position, tips[1].position, &count);
    if (count > 0 || tips[0].position == tips[1].position || touched[ends[0].position] || touched[ends[1].position] ||
        touched[tips[0].position] || touched[tips[1].position]) {
        return false;
    }
    const double before = fmin(cosine_to_surface(work, triangle), cosine_to_surface(work, across->triangle));
    const mesh_corner old[2][3] = {{here[0], here[1], here[2]}, {there[0], there[1], there[2]}};
    const mesh_corner made[2][3] = {{ends[0], tips[1], tips[0]}, {tips[1], ends[1], tips[0]}};
    memcpy(here, made[0], sizeof made[0]);
    memcpy(there, made[1], sizeof made[1]);
    if (fmin(cosine_to_surface(work, triangle), cosine_to_surface(work, across->triangle)) <= before) {
        memcpy(here, old[0], sizeof old[0]);
        memcpy(there, old[1], sizeof old[1]);
        return false;
    }
    touched[ends[0].position] = touched[ends[1].position] = 1;
    touched[tips[0].position] = touched[tips[1].position] = 1;
    return true;
}

static void touch(unfolder *work, const mesh_corner triangle[3]) {
    for (int i = 0; i < 3; i++) {
        work->touched[triangle[i].position] = 1;
    }
}

/** Drops a triangle: what has one position alone is left out in the end. */
static void drop_triangle(unfolder *work, size_t triangle) {
    mesh_corner *corners = work->mesh->triangles[triangle];
    touch(work, corners);
    corners[1] = corners[2] = corners[0];
}

/**
 * Finds another triangle across the edge behind a corner: one whose tip is that one or, for NO_POSITION, the only one.
 * @return its tip, or NO_POSITION
 */
static uint32_t find_across(const unfolder *work, size_t triangle, int corner, uint32_t tip, size_t *other) {
    const mesh_corner *here = work->mesh->triangles[triangle];
    const bool forward = here[corner].position < here[(corner + 1) % 3].position;
    size_t count;
    const size_t first = find_edge(work, here[corner].position, here[(corner + 1) % 3].position, &count);
    for (size_t i = first; i < first + count && (count == 2 || tip != NO_POSITION); i++) {
        const mesh_half_edge *edge = &work->edges[i];
        const uint32_t at = work->mesh->triangles[edge->triangle][(edge->corner + 2) % 3].position;
        if ((edge->forward == 1) != forward && (tip == NO_POSITION || at == tip)) {
            *other = edge->triangle;
            return at;
        }
    }
    return NO_POSITION;
}

/** Drops a triangle and the one that lies on it, where there is one. @return whether it did */
static bool drop_flap(unfolder *work, size_t triangle) {
    size_t other;
    if (find_across(work, triangle, 0, work->mesh->triangles[triangle][2].position, &other) == NO_POSITION) {
        return false;
    }
    drop_triangle(work, triangle);
    drop_triangle(work, other);
    return true;
}

/** Drops the position behind a corner, where three triangles surround it. @return whether it did */
static bool drop_position(unfolder *work, size_t triangle, int corner) {
    host_mesh *mesh = work->mesh;
    mesh_corner *middle = &mesh->triangles[triangle][(corner + 1) % 3];
    size_t others[2];
    size_t count;
    const uint32_t tip = find_across(work, triangle, corner, NO_POSITION, &others[0]);
    if (tip == NO_POSITION || find_across(work, triangle, (corner + 1) % 3, NO_POSITION, &others[1]) != tip) {
        return false;
    }
    find_edge(work, middle->position, tip, &count);
    if (count != 2 || work->touched[tip] || mesh->materials[others[0]] != mesh->materials[triangle] ||
        mesh->materials[others[1]] != mesh->materials[triangle] || !is_joined(mesh, triangle, others[0]) ||
        !is_joined(mesh, triangle, others[1]) || !is_joined(mesh, others[0], others[1])) {
        return false;
    }
    touch(work, mesh->triangles[triangle]);
    for (int i = 0; i < 3; i++) {
        const mesh_corner at = mesh->triangles[others[0]][i];
        middle->texture = at.position == tip ? at.texture : middle->texture;
    }
    middle->position = tip;
    drop_triangle(work, others[0]);
    drop_triangle(work, others[1]);
    return true;
}

/** Mends a fold in one of the ways above. @return whether it did */
static bool mend_fold(unfolder *work, size_t triangle) {
    const mesh_corner *corners = work->mesh->triangles[triangle];
    for (int i = 0; i < 3; i++) {
        if (work->touched[corners[i].position]) {
            return false;
        }
    }
    bool mended = drop_flap(work, triangle);
    for (int i = 0; i < 3 && !mended; i++) {
        mended = swap_edge(work, triangle, i) || drop_position(work, triangle, i);
    }
    return mended;
}

/** Leaves out triangles that were dropped. */
static void close_gaps(host_mesh *mesh) {
    size_t kept = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        if (has_area(mesh->triangles[i])) {
            memmove(mesh->triangles[kept], mesh->triangles[i], sizeof *mesh->triangles);
            mesh->materials[kept++] = mesh->materials[i];
        }
    }
    mesh->triangle_count = kept;
}

/** Unfolds what it can of the triangles that face against the surface that was there. */
static void unfold(host_mesh *mesh, double (*facings)[3]) {
    unfolder work = {.mesh = mesh, .facings = facings};
    uint32_t *points = memory_new(mesh->position_count, sizeof *points);
    for (size_t i = 0; i < mesh->position_count; i++) {
        points[i] = (uint32_t)i;
    }
    bool mended = true;
    for (int round = 0; mended && round < FOLD_ROUNDS_MAX; round++) {
        work.edges = mesh_half_edges(mesh, points);
        work.touched = memory_new(mesh->position_count, 1);
        mended = false;
        for (size_t i = 0; i < mesh->triangle_count; i++) {
            if (cosine_to_surface(&work, i) < FOLD_COSINE) {
                mended = mend_fold(&work, i) || mended;
            }
        }
        close_gaps(mesh);
        free(work.touched);
        free(work.edges);
    }
    free(points);
}

/* ---- Back into the mesh ----------------------------------------------------------------------------------------- */

static void put_triangles(const simplifier *made) {
    host_mesh *mesh = made->mesh;
    const old_normals old = list_normals(mesh);
    double(*facings)[3] = list_facings(mesh);
    mesh->triangle_count = made->index_count / 3;
    for (size_t i = 0; i < made->index_count; i++) {
        const unsigned vertex = made->indices[i];
        mesh->triangles[i / 3][i % 3] = (mesh_corner){made->position[vertex], MESH_NO_NORMAL, made->texture[vertex]};
        mesh->materials[i / 3] = made->material[vertex];
    }
    unfold(mesh, facings);
    choose_normals(mesh, &old);
    free(facings);
    free(old.starts);
    free(old.list);
}

/** Puts positions, and their colours, into the order in which triangles first come to them; those unused go. */
static void sort_positions(host_mesh *mesh) {
    uint32_t *places = memory_new(mesh->position_count, sizeof *places); /* plus one; 0 for none yet */
    double(*positions)[3] = memory_new(mesh->position_count, sizeof *positions);
    uint8_t(*colours)[3] = mesh->colours != NULL ? memory_new(mesh->position_count, sizeof *colours) : NULL;
    const size_t capacity = mesh->position_count;
    size_t count = 0;
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        uint32_t *position = &mesh->triangles[i / 3][i % 3].position;
        if (places[*position] == 0) {
            memcpy(positions[count], mesh->positions[*position], sizeof *positions);
            if (colours != NULL) {
                memcpy(colours[count], mesh->colours[*position], sizeof *colours);
            }
            places[*position] = (uint32_t)++count;
        }
        *position = places[*position] - 1;
    }
    free(places);
    free(mesh->positions);
    free(mesh->colours);
    mesh->positions = positions;
    mesh->colours = colours;
    mesh->position_count = count;
    mesh->position_capacity = capacity;
    mesh->colour_count = mesh->colour_capacity = colours != NULL ? count : 0;
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

/** Collapses as far as it goes and orders what is left. @return the error in the mesh's units */
static double collapse(simplifier *made, size_t most) {
    float error = 0;
    unsigned *left = memory_new(made->index_count, sizeof *left);
    const size_t count = meshopt_simplify(left, made->indices, made->index_count, made->places[0], made->vertex_count,
                                          sizeof made->places[0], 3 * most, FLT_MAX, 0, &error);
    meshopt_optimizeVertexCache(made->indices, left, count, made->vertex_count);
    free(left);
    made->index_count = count;
    return made->scale * (double)error *
           (double)meshopt_simplifyScale(made->places[0], made->vertex_count, sizeof made->places[0]);
}

bool mesh_simplify(host_mesh *mesh, size_t most, double *error, host_problem *problem) {
    simplifier made = {.mesh = mesh};
    *error = 0;
    if (mesh->triangle_count <= most) {
        return true;
    }
    number_vertices(&made);
    place_vertices(&made);
    *error = made.index_count > 0 ? collapse(&made, most) : 0;
    const size_t left = made.index_count / 3;
    const bool ok = left <= most && left > 0;
    if (ok) {
        put_triangles(&made);
        sort_positions(mesh);
    } else {
        problem_set(problem, 0,
                    left > 0 ? "--simplify %zu: it cannot be brought to fewer than %zu triangles"
                             : "--simplify %zu: nothing would be left of it",
                    most, left);
    }
    free(made.indices);
    free(made.position);
    free(made.material);
    free(made.texture);
    free(made.places);
    return ok;
}

#else

bool mesh_simplify(host_mesh *mesh, size_t most, double *error, host_problem *problem) {
    *error = 0;
    return mesh->triangle_count <= most ||
           problem_set(problem, 0, "--simplify: install libmeshoptimizer-dev, and run make host again");
}

#endif
