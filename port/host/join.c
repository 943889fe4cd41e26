/* SPDX-License-Identifier: MIT */
/**
 * @file join.c
 * Positions that are made one: those within a distance, found by the cells of a grid.
 */
#include "mesh.h"

#include "basics.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** What is asked for in the table: a cell, and a colour, for others are not joined. */
typedef struct join_key {
    double cell[3];
    uint64_t colour;
} join_key;

typedef struct join_table {
    const host_mesh *mesh;
    const uint8_t (*colours)[3]; /* that must be the same too, or null */
    double distance;
    uint32_t *kept;  /* positions that stay... */
    uint32_t *next;  /* ...and of each the next of its slot, plus one */
    uint32_t *slots; /* the first of each, plus one; 0 for none */
    size_t kept_count, slot_count;
} join_table;

static join_key key_of(const join_table *table, uint32_t position) {
    join_key key = {{0, 0, 0}, 0};
    for (int axis = 0; axis < 3; axis++) {
        const double at = table->mesh->positions[position][axis];
        key.cell[axis] = table->distance > 0 ? floor(at / table->distance) : at;
    }
    for (int i = 0; table->colours != NULL && i < 3; i++) {
        key.colour = key.colour << 8 | table->colours[position][i];
    }
    return key;
}

static uint32_t *slot_of(const join_table *table, join_key key) {
    for (int axis = 0; axis < 3; axis++) {
        key.cell[axis] += 0.0; /* -0 becomes 0 */
    }
    const uint64_t hash = bytes_hash(&key, sizeof key);
    return &table->slots[(hash ^ hash >> 32) % table->slot_count];
}

static bool is_near(const join_table *table, uint32_t a, uint32_t b) {
    const double *p = table->mesh->positions[a];
    const double *q = table->mesh->positions[b];
    double length = 0;
    for (int axis = 0; axis < 3; axis++) {
        length = hypot(length, p[axis] - q[axis]);
    }
    return length <= table->distance && key_of(table, a).colour == key_of(table, b).colour;
}

/** The first kept position near one, or their count. */
static size_t find_near(const join_table *table, uint32_t position) {
    const int reach = table->distance > 0;
    size_t best = table->kept_count;
    for (int i = 0; i < (reach ? 27 : 1); i++) {
        join_key key = key_of(table, position);
        key.cell[0] += reach ? i % 3 - 1 : 0;
        key.cell[1] += reach ? i / 3 % 3 - 1 : 0;
        key.cell[2] += reach ? i / 9 - 1 : 0;
        for (uint32_t at = *slot_of(table, key); at != 0; at = table->next[at - 1]) {
            if (at - 1 < best && is_near(table, table->kept[at - 1], position)) {
                best = at - 1;
            }
        }
    }
    return best;
}

static void keep(join_table *table, uint32_t position) {
    uint32_t *slot = slot_of(table, key_of(table, position));
    table->kept[table->kept_count] = position;
    table->next[table->kept_count++] = *slot;
    *slot = (uint32_t)table->kept_count;
}

/** Finds the kept position that each position joins; the caller frees their numbers. */
static uint32_t *find_places(join_table *table) {
    const size_t count = table->mesh->position_count;
    uint32_t *places = memory_new(count, sizeof *places);
    table->slot_count = 2 * count + 1;
    table->kept = memory_new(count, sizeof *table->kept);
    table->next = memory_new(count, sizeof *table->next);
    table->slots = memory_new(table->slot_count, sizeof *table->slots);
    for (size_t i = 0; i < count; i++) {
        places[i] = (uint32_t)find_near(table, (uint32_t)i);
        if (places[i] == table->kept_count) {
            keep(table, (uint32_t)i);
        }
    }
    return places;
}

static void free_table(join_table *table) {
    free(table->slots);
    free(table->next);
    free(table->kept);
}

/** Moves the kept positions and their colours together, in their order. */
static void close_gaps(host_mesh *mesh, const join_table *table) {
    for (size_t i = 0; i < table->kept_count; i++) {
        memmove(mesh->positions[i], mesh->positions[table->kept[i]], sizeof *mesh->positions);
        if (mesh->colours != NULL) {
            memmove(mesh->colours[i], mesh->colours[table->kept[i]], sizeof *mesh->colours);
        }
    }
    mesh->position_count = table->kept_count;
    mesh->colour_count = mesh->colours != NULL ? table->kept_count : 0;
}

size_t mesh_join(host_mesh *mesh, double distance) {
    const size_t count = mesh->position_count;
    join_table table = {.mesh = mesh, .colours = (const uint8_t(*)[3])mesh->colours, .distance = distance};
    uint32_t *places = find_places(&table);
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        uint32_t *position = &mesh->triangles[i / 3][i % 3].position;
        *position = places[*position];
    }
    close_gaps(mesh, &table);
    free(places);
    free_table(&table);
    return count - mesh->position_count;
}

uint32_t *mesh_weld(const host_mesh *mesh) {
    join_table table = {.mesh = mesh};
    uint32_t *places = find_places(&table);
    free_table(&table);
    return places;
}
