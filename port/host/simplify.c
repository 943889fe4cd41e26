/* SPDX-License-Identifier: MIT */
#include "mesh.h"

#include "basics.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#ifdef HOST_WITH_MESHOPTIMIZER

#include <meshoptimizer.h>

/** A vertex is a position with a material: where two materials meet, there are two, and they are collapsed together. */
typedef struct simplifier {
    host_mesh *mesh;
    unsigned *indices;  /* 3 for each triangle */
    uint32_t *position; /* of each vertex */
    uint32_t *material;
    float (*places)[3]; /* about the middle, the largest coordinate 1: floats are finest so */
    size_t index_count, vertex_count;
    double scale; /* from those to the mesh's units */
} simplifier;

/* ---- Vertices --------------------------------------------------------------------------------------------------- */

/** The corners' order by position, then material. */
typedef struct placed_corner {
    uint32_t position, material;
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
        if (has_area(mesh->triangles[i / 3])) {
            list[made->index_count] =
                (placed_corner){mesh->triangles[i / 3][i % 3].position, mesh->materials[i / 3], made->index_count};
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
    qsort(list, made->index_count, sizeof *list, compare_corners);
    for (size_t i = 0; i < made->index_count; i++) {
        if (i == 0 || list[i].position != list[i - 1].position || list[i].material != list[i - 1].material) {
            made->position[made->vertex_count] = list[i].position;
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

/* ---- Back into the mesh ----------------------------------------------------------------------------------------- */

static void put_triangles(const simplifier *made) {
    host_mesh *mesh = made->mesh;
    const old_normals old = list_normals(mesh);
    mesh->triangle_count = made->index_count / 3;
    for (size_t i = 0; i < made->index_count; i++) {
        const unsigned vertex = made->indices[i];
        mesh->triangles[i / 3][i % 3] = (mesh_corner){made->position[vertex], MESH_NO_NORMAL};
        mesh->materials[i / 3] = made->material[vertex];
    }
    choose_normals(mesh, &old);
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
