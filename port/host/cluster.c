/* SPDX-License-Identifier: MIT */
/**
 * @file cluster.c
 * Cuts a mesh into patches, triangles that hang together by edges and face much the same way, and gives each its
 * bounds.
 */
#include "quantise.h"

#include "basics.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** No triangle, no patch. */
#define PATCH_NONE UINT32_MAX

/** Length of a triangle's direction. */
#define PATCH_DIRECTION_ONE 1048576.0

/** The cost of a patch equals that of so many triangles, which are drawn for nothing half of the time. */
#define PATCH_COST 1.5

/** Most triangles of a patch. */
#define PATCH_TRIANGLES_MAX 64

/** Triangles, as a list: the patch is named by its first one, which is its lowest. */
typedef struct triangle_patch {
    uint32_t last;    /**< Triangle of the list. */
    uint32_t count;   /**< Of triangles; 0 where this triangle is not the lowest of its patch. */
    uint32_t version; /**< How often it grew. */
    int64_t sum[3];   /**< Of the triangles' directions. */
    int64_t loss;     /**< Triangles times the sine of their spread. */
} triangle_patch;

/** A mesh's patches. Owns its arrays. */
typedef struct mesh_patches {
    const glint_mesh *mesh;
    int32_t (*directions)[3]; /**< Normals of the triangles, PATCH_DIRECTION_ONE long; 0 for those without area. */
    uint32_t *opposite;       /**< Of half edge 3 * triangle + corner: the next on the same edge, or itself. */
    uint32_t *patch_of;       /**< Of each triangle. */
    uint32_t *next;           /**< Triangle of the same patch, or PATCH_NONE. */
    triangle_patch *patches;  /**< Of each triangle. */
} mesh_patches;

/*
 * Two patches that share an edge are merged into one, again and again, those first that gain most: what a patch costs,
 * less what is drawn for nothing more than before. A patch is seen from half of all directions and sin(spread) / 2
 * more.
 *
 * Integers are compared, some of them rounded from doubles: the patches are the same everywhere.
 */

/** A sine of 1. */
#define SINE_ONE 65536.0

/** Something to be sorted by. */
typedef struct sort_item {
    uint64_t key;
    uint32_t number; /* breaks ties */
} sort_item;

/** Two patches that might merge. */
typedef struct patch_pair {
    int64_t gain;
    uint32_t a, b; /* a < b */
    uint32_t version_a, version_b;
} patch_pair;

/** Pairs that gain: a heap, the best on top. */
typedef struct pair_heap {
    patch_pair *pairs;
    size_t count, capacity;
} pair_heap;

/* ---- Neighbours ------------------------------------------------------------------------------------------------- */

static int compare_items(const void *left, const void *right) {
    const sort_item *a = left;
    const sort_item *b = right;
    if (a->key != b->key) {
        return a->key < b->key ? -1 : 1;
    }
    return (a->number > b->number) - (a->number < b->number);
}

/** Numbers vertices so that those at equal positions have the same number; the caller frees them. */
static uint32_t *number_points(const glint_mesh *mesh) {
    sort_item *items = memory_new(mesh->vertex_count, sizeof *items);
    uint32_t *points = memory_new(mesh->vertex_count, sizeof *points);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const int16_t *step = mesh->positions[i];
        items[i].key = (uint64_t)(uint16_t)step[0] << 32 | (uint64_t)(uint16_t)step[1] << 16 | (uint16_t)step[2];
        items[i].number = i;
    }
    qsort(items, mesh->vertex_count, sizeof *items, compare_items);
    uint32_t point = 0;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        point += i > 0 && items[i].key != items[i - 1].key;
        points[items[i].number] = point;
    }
    free(items);
    return points;
}

/** Links the half edges of each edge into a ring. */
static void find_neighbours(mesh_patches *patches) {
    const glint_mesh *mesh = patches->mesh;
    const size_t count = 3 * (size_t)mesh->triangle_count;
    uint32_t *points = number_points(mesh);
    sort_item *items = memory_new(count, sizeof *items);
    for (size_t i = 0; i < count; i++) {
        const uint64_t from = points[mesh->triangles[i / 3][i % 3]];
        const uint64_t to = points[mesh->triangles[i / 3][(i + 1) % 3]];
        items[i].key = from < to ? from << 32 | to : to << 32 | from;
        items[i].number = (uint32_t)i;
    }
    qsort(items, count, sizeof *items, compare_items);
    size_t first = 0;
    for (size_t i = 0; i < count; i++) {
        const bool last = i + 1 == count || items[i + 1].key != items[first].key;
        patches->opposite[items[i].number] = items[last ? first : i + 1].number;
        first = last ? i + 1 : first;
    }
    free(items);
    free(points);
}

/* ---- Directions ------------------------------------------------------------------------------------------------- */

/** Normal of a triangle's plane in steps, unit length. @return false for a triangle without area */
static bool patch_normal(const glint_mesh *mesh, uint32_t triangle, double unit[3]) {
    const int16_t *a = mesh->positions[mesh->triangles[triangle][0]];
    const int16_t *b = mesh->positions[mesh->triangles[triangle][1]];
    const int16_t *c = mesh->positions[mesh->triangles[triangle][2]];
    double square = 0;
    for (int axis = 0; axis < 3; axis++) {
        const int j = (axis + 1) % 3;
        const int k = (axis + 2) % 3;
        const int64_t exact = (int64_t)(b[j] - a[j]) * (c[k] - a[k]) - (int64_t)(b[k] - a[k]) * (c[j] - a[j]);
        unit[axis] = (double)exact;
        square += unit[axis] * unit[axis];
    }
    for (int axis = 0; axis < 3 && square > 0; axis++) {
        unit[axis] /= sqrt(square);
    }
    return square > 0;
}

/** Length of a sum of directions. */
static double patch_length(const int64_t sum[3]) {
    return sqrt((double)(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]));
}

static int64_t product(const int32_t direction[3], const int64_t vector[3]) {
    return direction[0] * vector[0] + direction[1] * vector[1] + direction[2] * vector[2];
}

/** Returns the triangle of a patch, of those with area, that faces farthest from `vector`; or PATCH_NONE. */
static uint32_t patch_farthest(const mesh_patches *patches, uint32_t patch, const int64_t vector[3]) {
    int64_t smallest = INT64_MAX;
    uint32_t farthest = PATCH_NONE;
    for (uint32_t i = patch; i != PATCH_NONE; i = patches->next[i]) {
        const int32_t *direction = patches->directions[i];
        const int64_t turned = product(direction, vector);
        if (turned < smallest && (direction[0] != 0 || direction[1] != 0 || direction[2] != 0)) {
            smallest = turned;
            farthest = i;
        }
    }
    return farthest;
}

/** Sine of the angle from `sum` to the farthest of a patch's triangles, 1 from a right angle on. */
static double patch_sine(const mesh_patches *patches, uint32_t patch, const int64_t sum[3]) {
    const uint32_t farthest = patch_farthest(patches, patch, sum);
    if (farthest == PATCH_NONE) {
        return 0;
    }
    const int64_t along = product(patches->directions[farthest], sum);
    const double cosine = (double)along / (patch_length(sum) * PATCH_DIRECTION_ONE);
    const double square = cosine * cosine;
    return along <= 0 ? 1 : square < 1 ? sqrt(1 - square) : 0;
}

/* ---- Pairs ------------------------------------------------------------------------------------------------------ */

/** Does a pair gain more than another? Lower numbers break ties. */
static bool comes_before(const patch_pair *left, const patch_pair *right) {
    if (left->gain != right->gain) {
        return left->gain > right->gain;
    }
    return left->a != right->a ? left->a < right->a : left->b < right->b;
}

static void push_pair(pair_heap *heap, const patch_pair *pair) {
    heap->pairs = memory_grow(heap->pairs, &heap->capacity, heap->count, sizeof *heap->pairs);
    size_t place = heap->count++;
    while (place > 0 && comes_before(pair, &heap->pairs[(place - 1) / 2])) {
        heap->pairs[place] = heap->pairs[(place - 1) / 2];
        place = (place - 1) / 2;
    }
    heap->pairs[place] = *pair;
}

static patch_pair pop_pair(pair_heap *heap) {
    const patch_pair best = heap->pairs[0];
    const patch_pair moved = heap->pairs[--heap->count];
    size_t place = 0;
    for (size_t child = 1; child < heap->count; child = 2 * place + 1) {
        child += child + 1 < heap->count && comes_before(&heap->pairs[child + 1], &heap->pairs[child]);
        if (!comes_before(&heap->pairs[child], &moved)) {
            break;
        }
        heap->pairs[place] = heap->pairs[child];
        place = child;
    }
    heap->pairs[place] = moved;
    return best;
}

/** What two patches would be as one. */
static triangle_patch united(const mesh_patches *patches, uint32_t a, uint32_t b) {
    const triangle_patch *left = &patches->patches[a];
    const triangle_patch *right = &patches->patches[b];
    triangle_patch patch = {right->last, left->count + right->count, left->version + 1, {0, 0, 0}, 0};
    for (int axis = 0; axis < 3; axis++) {
        patch.sum[axis] = left->sum[axis] + right->sum[axis];
    }
    const double sine = fmax(patch_sine(patches, a, patch.sum), patch_sine(patches, b, patch.sum));
    patch.loss = patch.count * (int64_t)(sine * SINE_ONE);
    return patch;
}

/** Keeps two patches in mind when to merge them gains. */
static void consider(const mesh_patches *patches, pair_heap *heap, uint32_t one, uint32_t other) {
    const uint32_t a = one < other ? one : other;
    const uint32_t b = one < other ? other : one;
    const triangle_patch *left = &patches->patches[a];
    const triangle_patch *right = &patches->patches[b];
    if (a == b || left->count + right->count > PATCH_TRIANGLES_MAX) {
        return;
    }
    const triangle_patch both = united(patches, a, b);
    const int64_t gain = (int64_t)(PATCH_COST * SINE_ONE) + left->loss + right->loss - both.loss;
    if (gain > 0) {
        const patch_pair pair = {gain, a, b, left->version, right->version};
        push_pair(heap, &pair);
    }
}

static bool is_of_today(const mesh_patches *patches, const patch_pair *pair) {
    const triangle_patch *left = &patches->patches[pair->a];
    const triangle_patch *right = &patches->patches[pair->b];
    return left->count > 0 && right->count > 0 && left->version == pair->version_a && right->version == pair->version_b;
}

static void merge_patches(mesh_patches *patches, pair_heap *heap, uint32_t a, uint32_t b) {
    const triangle_patch both = united(patches, a, b);
    patches->next[patches->patches[a].last] = b;
    patches->patches[a] = both;
    patches->patches[b].count = 0;
    for (uint32_t i = b; i != PATCH_NONE; i = patches->next[i]) {
        patches->patch_of[i] = a;
    }
    uint32_t before = a;
    for (uint32_t i = a; i != PATCH_NONE; i = patches->next[i]) {
        for (uint32_t edge = 3 * i; edge < 3 * i + 3; edge++) {
            const uint32_t other = patches->patch_of[patches->opposite[edge] / 3];
            if (other != before) { /* some come twice, which does no harm */
                consider(patches, heap, a, other);
            }
            before = other;
        }
    }
}

/* ---- Patches ---------------------------------------------------------------------------------------------------- */

/** Cuts a mesh into patches. */
static void patch_mesh(const glint_mesh *mesh, mesh_patches *out) {
    const uint32_t count = mesh->triangle_count;
    pair_heap heap = {NULL, 0, 0};
    out->mesh = mesh;
    out->directions = memory_new(count, sizeof *out->directions);
    out->opposite = memory_new(3 * (size_t)count, sizeof *out->opposite);
    out->patch_of = memory_new(count, sizeof *out->patch_of);
    out->next = memory_new(count, sizeof *out->next);
    out->patches = memory_new(count, sizeof *out->patches);
    find_neighbours(out);
    for (uint32_t i = 0; i < count; i++) {
        double unit[3];
        patch_normal(mesh, i, unit);
        out->patches[i] = (triangle_patch){i, 1, 0, {0, 0, 0}, 0};
        for (int axis = 0; axis < 3; axis++) {
            out->directions[i][axis] = (int32_t)lround(unit[axis] * PATCH_DIRECTION_ONE);
            out->patches[i].sum[axis] = out->directions[i][axis];
        }
        out->patch_of[i] = i;
        out->next[i] = PATCH_NONE;
    }
    for (uint32_t edge = 0; edge < 3 * count; edge++) {
        consider(out, &heap, edge / 3, out->opposite[edge] / 3);
    }
    while (heap.count > 0) {
        const patch_pair best = pop_pair(&heap);
        if (is_of_today(out, &best)) {
            merge_patches(out, &heap, best.a, best.b);
        }
    }
    free(heap.pairs);
}

static void patch_free(mesh_patches *patches) {
    free(patches->directions);
    free(patches->opposite);
    free(patches->patch_of);
    free(patches->next);
    free(patches->patches);
}

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
    reorder(mesh->texture_coordinates, order, placed, sizeof *mesh->texture_coordinates);
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
