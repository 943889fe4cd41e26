/* SPDX-License-Identifier: MIT */
#include "patch.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>

/*
 * Two patches that share an edge are merged into one, again and again, those first that gain most: what a patch costs,
 * less what is drawn for nothing more than before. A patch is seen from half of all directions and sin(spread) / 2
 * more.
 *
 * What is compared are integers, some of them rounded from doubles: the patches are the same everywhere.
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

bool patch_normal(const glint_mesh *mesh, uint32_t triangle, double unit[3]) {
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

double patch_length(const int64_t sum[3]) {
    return sqrt((double)(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]));
}

static int64_t product(const int32_t direction[3], const int64_t vector[3]) {
    return direction[0] * vector[0] + direction[1] * vector[1] + direction[2] * vector[2];
}

uint32_t patch_farthest(const mesh_patches *patches, uint32_t patch, const int64_t vector[3]) {
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

/* ---- Public ----------------------------------------------------------------------------------------------------- */

void patch_mesh(const glint_mesh *mesh, mesh_patches *out) {
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

void patch_free(mesh_patches *patches) {
    free(patches->directions);
    free(patches->opposite);
    free(patches->patch_of);
    free(patches->next);
    free(patches->patches);
}
