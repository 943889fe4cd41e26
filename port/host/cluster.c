/* SPDX-License-Identifier: MIT */
#include "cluster.h"

#include "memory.h"
#include "patch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** What a mesh with clusters costs but for these, in triangles that are drawn for nothing half of the time. */
#define MESH_COST 40

/* ---- Bounds ----------------------------------------------------------------------------------------------------- */

/** Length of an axis. */
#define AXIS_LENGTH 127.0

/** More than rounding takes from what is computed here. */
#define MARGIN 1e-6

/** Steps towards the middle of the smallest cone. */
#define CONE_STEPS 64

/**
 * The middle of the smallest cone round a patch's directions: the average of those that were farthest from the average
 * before (Badoiu and Clarkson, 2003). @return false when nothing of the patch has area
 */
static bool choose_axis(const mesh_patches *patches, uint32_t patch, int8_t axis[3]) {
    int64_t middle[3];
    int64_t sum[3] = {0, 0, 0};
    memcpy(middle, patches->patches[patch].sum, sizeof middle);
    for (int i = 0; i < CONE_STEPS; i++) {
        const uint32_t farthest = patch_farthest(patches, patch, middle);
        if (farthest == PATCH_NONE) {
            return false;
        }
        for (int k = 0; k < 3; k++) {
            sum[k] += patches->directions[farthest][k];
        }
        memcpy(middle, sum, sizeof middle);
    }
    const double length = patch_length(sum);
    for (int k = 0; k < 3; k++) {
        axis[k] = (int8_t)(length > 0 ? lround((double)sum[k] / length * AXIS_LENGTH) : 0);
    }
    return true;
}

/** A triangle's plane, and an axis as its normal sees it. */
typedef struct plane_view {
    bool has_area;
    double distance; /* of the plane from step 0 */
    double along;    /* length of the axis along the normal */
    double beside;   /* distance of the axis from the normal's line */
} plane_view;

static plane_view view_plane(const glint_mesh *mesh, uint32_t triangle, const int8_t axis[3]) {
    const int16_t *point = mesh->positions[mesh->triangles[triangle][0]];
    double unit[3];
    double square = 0;
    plane_view plane = {patch_normal(mesh, triangle, unit), 0, 0, 0};
    for (int k = 0; k < 3; k++) {
        plane.distance += unit[k] * point[k];
        plane.along += unit[k] * axis[k];
        square += axis[k] * axis[k];
    }
    plane.beside = sqrt(fmax(square - plane.along * plane.along, 0));
    return plane;
}

/** Lowest height of a patch's planes: each normal is as long as lifts its own most, and has its end within `spread`. */
static double lowest_height(const mesh_patches *patches, uint32_t patch, const int8_t axis[3], double spread) {
    double lowest = INT16_MAX;
    for (uint32_t i = patch; i != PATCH_NONE; i = patches->next[i]) {
        const plane_view plane = view_plane(patches->mesh, i, axis);
        const double room = sqrt(fmax(spread * spread - plane.beside * plane.beside, 0)) - MARGIN;
        const double length = plane.distance > 0 ? plane.along + room : fmax(plane.along - room, MARGIN);
        if (plane.has_area) {
            lowest = fmin(lowest, length * plane.distance / 256);
        }
    }
    return floor(lowest - MARGIN);
}

/** Axis, spread and height of a patch. */
static glint_cluster bound_patch(const mesh_patches *patches, uint32_t patch) {
    static const glint_cluster never_dropped = {{0, 0, 0}, UINT8_MAX, -1, 0, 0, 0};
    glint_cluster cluster = {{0, 0, 0}, 0, 0, 0, 0, 0};
    double spread = 0;
    if (!choose_axis(patches, patch, cluster.axis)) {
        return cluster; /* there is nothing to drop */
    }
    for (uint32_t i = patch; i != PATCH_NONE; i = patches->next[i]) {
        const plane_view plane = view_plane(patches->mesh, i, cluster.axis);
        if (plane.has_area && plane.along < MARGIN) {
            return never_dropped;
        }
        spread = fmax(spread, plane.has_area ? ceil(plane.beside + MARGIN) : 0);
    }
    cluster.spread = (uint8_t)spread;
    cluster.height = (int16_t)lowest_height(patches, patch, cluster.axis, spread);
    return cluster;
}

/* ---- Order ------------------------------------------------------------------------------------------------------ */

/** Of a patch's edges, how many it shares with others that have not been placed? */
static uint32_t count_open_edges(const mesh_patches *patches, const bool *placed, uint32_t patch) {
    uint32_t count = 0;
    for (uint32_t i = patch; i != PATCH_NONE; i = patches->next[i]) {
        for (uint32_t edge = 3 * i; edge < 3 * i + 3; edge++) {
            const uint32_t other = patches->patch_of[patches->opposite[edge] / 3];
            count += other != patch && !placed[other];
        }
    }
    return count;
}

/** Of a patch's neighbours that have not been placed, the one with fewest such edges itself; or PATCH_NONE. */
static uint32_t choose_neighbour(const mesh_patches *patches, const bool *placed, uint32_t patch) {
    uint32_t best = PATCH_NONE;
    uint32_t fewest = UINT32_MAX;
    for (uint32_t i = patch; i != PATCH_NONE; i = patches->next[i]) {
        for (uint32_t edge = 3 * i; edge < 3 * i + 3; edge++) {
            const uint32_t other = patches->patch_of[patches->opposite[edge] / 3];
            const uint32_t open = placed[other] ? UINT32_MAX : count_open_edges(patches, placed, other);
            if (open < fewest || (open == fewest && other < best && !placed[other])) {
                best = other;
                fewest = open;
            }
        }
    }
    return best;
}

/**
 * Puts patches into an order: from neighbour to neighbour, so that those that are seen follow each other, and vertices
 * that patches share go with those that are nearly surrounded.
 * @return how many there are
 */
static uint32_t order_patches(const mesh_patches *patches, uint32_t *order) {
    bool *placed = memory_new(patches->mesh->triangle_count, sizeof *placed);
    uint32_t count = 0;
    for (uint32_t i = 0; i < patches->mesh->triangle_count; i++) {
        uint32_t patch = patches->patches[i].count > 0 && !placed[i] ? i : PATCH_NONE;
        while (patch != PATCH_NONE) {
            placed[patch] = true;
            order[count++] = patch;
            patch = choose_neighbour(patches, placed, patch);
        }
    }
    free(placed);
    return count;
}

/** Puts `count` items of `size` bytes into an order; the array, null for none, is the caller's to write. */
static void reorder(const void *array, const uint32_t *order, size_t count, size_t size) {
    uint8_t *items = (uint8_t *)(uintptr_t)array;
    if (items == NULL) {
        return;
    }
    uint8_t *before = memory_new(count, size);
    memcpy(before, items, count * size);
    for (size_t i = 0; i < count; i++) {
        memcpy(items + i * size, before + order[i] * size, size);
    }
    free(before);
}

/** Puts triangles into the order of the patches. */
static void order_triangles(const mesh_patches *patches, const uint32_t *patch_order, uint32_t patch_count) {
    const uint32_t count = patches->mesh->triangle_count;
    uint32_t *order = memory_new(count, sizeof *order);
    uint32_t placed = 0;
    for (uint32_t i = 0; i < patch_count; i++) {
        for (uint32_t triangle = patch_order[i]; triangle != PATCH_NONE; triangle = patches->next[triangle]) {
            order[placed++] = triangle;
        }
    }
    reorder(patches->mesh->triangles, order, count, sizeof *patches->mesh->triangles);
    free(order);
}

/** Puts vertices into the order in which triangles name them, and counts those that each cluster names first. */
static void order_vertices(glint_mesh *mesh, glint_cluster *clusters) {
    uint16_t(*triangles)[3] = (uint16_t(*)[3])(uintptr_t)mesh->triangles;
    uint32_t *order = memory_new(mesh->vertex_count, sizeof *order);
    uint32_t *places = memory_new(mesh->vertex_count, sizeof *places); /* plus one; 0 for none yet */
    glint_cluster *cluster = clusters;
    uint32_t placed = 0;
    for (uint32_t i = 0, end = clusters[0].triangles; i < mesh->triangle_count; i++) {
        if (i == end) {
            end += (++cluster)->triangles;
        }
        for (int corner = 0; corner < 3; corner++) {
            const uint32_t vertex = triangles[i][corner];
            if (places[vertex] == 0) {
                order[placed++] = vertex;
                places[vertex] = placed;
                cluster->vertices++;
            }
            triangles[i][corner] = (uint16_t)(places[vertex] - 1);
        }
    }
    for (uint32_t i = 0; placed < mesh->vertex_count; i++) {
        if (places[i] == 0) {
            order[placed++] = i; /* no triangle names it: the last cluster's */
            cluster->vertices++;
        }
    }
    reorder(mesh->positions, order, placed, sizeof *mesh->positions);
    reorder(mesh->normals, order, placed, sizeof *mesh->normals);
    reorder(mesh->colours, order, placed, sizeof *mesh->colours);
    reorder(mesh->colours565, order, placed, sizeof *mesh->colours565);
    free(order);
    free(places);
}

/** Finds which cluster each vertex goes with; the caller frees them. */
static uint16_t *find_owners(const glint_mesh *mesh, const glint_cluster *clusters, uint32_t count) {
    uint16_t *owners = memory_new(mesh->vertex_count, sizeof *owners);
    uint32_t vertex = 0;
    for (uint32_t cluster = 0; cluster < count; cluster++) {
        for (uint32_t i = 0; i < clusters[cluster].vertices; i++) {
            owners[vertex++] = (uint16_t)cluster;
        }
    }
    return owners;
}

/** A cluster and one with triangles at its vertices. */
typedef struct cluster_loan {
    uint16_t owner, borrower;
} cluster_loan;

/** Counts the clusters' borrowers and lists them; the caller frees the list. */
static uint16_t *list_borrowers(const glint_mesh *mesh, glint_cluster *clusters, uint32_t count) {
    uint16_t *owners = find_owners(mesh, clusters, count);
    uint32_t *last = memory_new(count, sizeof *last); /* of each owner's borrowers, plus one */
    cluster_loan *loans = NULL;
    size_t loan_count = 0;
    size_t capacity = 0;
    uint32_t end = 0;
    for (uint32_t cluster = 0, triangle = 0; cluster < count; cluster++) {
        end += clusters[cluster].triangles;
        for (; triangle < end; triangle++) {
            for (int corner = 0; corner < 3; corner++) {
                const uint16_t owner = owners[mesh->triangles[triangle][corner]];
                if (owner != cluster && last[owner] != cluster + 1) {
                    loans = memory_grow(loans, &capacity, loan_count, sizeof *loans);
                    loans[loan_count++] = (cluster_loan){owner, (uint16_t)cluster};
                    clusters[owner].borrowers++;
                    last[owner] = cluster + 1;
                }
            }
        }
    }
    uint32_t *places = last;
    uint32_t place = 0;
    for (uint32_t i = 0; i < count; i++) {
        places[i] = place;
        place += clusters[i].borrowers;
    }
    uint16_t *borrowers = memory_new(loan_count, sizeof *borrowers);
    for (size_t i = 0; i < loan_count; i++) {
        borrowers[places[loans[i].owner]++] = loans[i].borrower;
    }
    free(owners);
    free(last);
    free(loans);
    return borrowers;
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

/** Do clusters save more than they cost? Not where all face much the same way, and are seen or not as one. */
static bool are_worthwhile(const glint_cluster *clusters, uint32_t count) {
    int64_t sum[3] = {0, 0, 0};
    double gain = -MESH_COST - PATCH_COST * count;
    for (uint32_t i = 0; i < count; i++) {
        gain += clusters[i].triangles * fmax(1 - clusters[i].spread / AXIS_LENGTH, 0);
        for (int k = 0; k < 3; k++) {
            sum[k] += clusters[i].axis[k];
        }
    }
    bool differ = false;
    for (uint32_t i = 0; i < count; i++) {
        const int8_t *axis = clusters[i].axis;
        const int64_t along = axis[0] * sum[0] + axis[1] * sum[1] + axis[2] * sum[2];
        differ = differ || (double)along <= 0.8 * AXIS_LENGTH * patch_length(sum);
    }
    return gain > 0 && differ;
}

void cluster_mesh(glint_mesh *mesh) {
    if ((mesh->flags & GLINT_MESH_DOUBLE_SIDED) != 0) {
        return;
    }
    mesh_patches patches;
    patch_mesh(mesh, &patches);
    uint32_t *order = memory_new(mesh->triangle_count, sizeof *order);
    const uint32_t count = order_patches(&patches, order);
    glint_cluster *clusters = memory_new(count, sizeof *clusters);
    for (uint32_t i = 0; i < count; i++) {
        clusters[i] = bound_patch(&patches, order[i]);
        clusters[i].triangles = (uint16_t)patches.patches[order[i]].count;
    }
    if (count <= UINT16_MAX && are_worthwhile(clusters, count)) {
        order_triangles(&patches, order, count);
        order_vertices(mesh, clusters);
        glint_clusters *made = memory_new(1, sizeof *made);
        *made = (glint_clusters){&glint_cull_cones, clusters, list_borrowers(mesh, clusters, count), count};
        mesh->clusters = made;
    } else {
        free(clusters);
    }
    free(order);
    patch_free(&patches);
}

void cluster_free(glint_mesh *mesh) {
    if (mesh->clusters != NULL) {
        free((void *)(uintptr_t)mesh->clusters->list);
        free((void *)(uintptr_t)mesh->clusters->borrowers);
        free((void *)(uintptr_t)mesh->clusters);
    }
    mesh->clusters = NULL;
}
