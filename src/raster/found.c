/* SPDX-License-Identifier: MIT */
/* Found: a ring of what tiles of a pass have found of triangles, and where by its key each lies. */
#include "found.h"

#include "../frame/arena.h"

/* Places count bytes through all turns of the ring: by how far one lies behind what has been written it is known
 * whether what lies there is that still. */
typedef struct found_ring {
    uint32_t mask;             /* of the places, a power of two of them less 1 */
    uint32_t size, head, turn; /* the head's turn began there */
    uint32_t written;          /* the end of what may have been written to */
    uint8_t *first;
    uint32_t places[]; /* by the lower bits of keys */
} found_ring;

/* Bytes for each place, about what is kept in the mean; and most places. */
#define BYTES_FOR_PLACE 256
#define PLACES_MAX 1024

/* A ring that is smaller is not worth it. */
#define LEAST_ROOM 4096

/* A key, and what is kept behind it. */
#define KEY_SIZE GLINT_ALIGNED(sizeof(uint32_t))

static found_ring *ring_of(const glint_workspace *workspace) {
    return workspace->spare.is_begun ? workspace->spare.memory : 0;
}

/* Begins a ring. @return null where there is no room */
static found_ring *begin_ring(glint_spare *spare) {
    found_ring *const ring = spare->memory;
    uint32_t count = PLACES_MAX;
    if (!ring || spare->size < LEAST_ROOM)
        return 0;
    while (count * BYTES_FOR_PLACE > spare->size)
        count >>= 1;
    const uint32_t taken = (uint32_t)GLINT_ALIGNED(sizeof *ring + count * sizeof ring->places[0]);
    spare->is_begun = 1;
    ring->mask = count - 1;
    ring->first = (uint8_t *)spare->memory + taken;
    ring->size = (spare->size - taken) & ~(uint32_t)(GLINT_ALIGNMENT - 1);
    ring->head = ring->turn = ring->written = ring->size;
    for (uint32_t i = 0; i < count; i++)
        ring->places[i] = 0; /* too old, or beyond a ring on its first turn */
    return ring;
}

/* What lies at a place. */
static inline uint8_t *at_place(const found_ring *ring, uint32_t place) {
    return ring->first + (place - ring->turn + (place < ring->turn ? ring->size : 0));
}

const void *glint_ring_find(const glint_workspace *workspace, uint32_t key) {
    const found_ring *const ring = ring_of(workspace);
    if (!ring)
        return 0;
    const uint32_t place = ring->places[key & ring->mask];
    if (!place || ring->written - place > ring->size)
        return 0;
    const uint8_t *const at = at_place(ring, place);
    return *(const uint32_t *)(const void *)at == key ? at + KEY_SIZE : 0;
}

void *glint_ring_begin(glint_workspace *workspace, size_t most) {
    const uint32_t size = (uint32_t)(KEY_SIZE + GLINT_ALIGNED(most));
    found_ring *ring = ring_of(workspace);
    if (!ring)
        ring = begin_ring(&workspace->spare);
    if (!ring || size > ring->size)
        return 0;
    if (ring->head - ring->turn > ring->size - size)
        ring->head = ring->turn += ring->size;
    if (ring->written < ring->head + size)
        ring->written = ring->head + size;
    return at_place(ring, ring->head) + KEY_SIZE;
}

void glint_ring_keep(glint_workspace *workspace, uint32_t key, size_t size) {
    found_ring *const ring = ring_of(workspace);
    *(uint32_t *)(void *)at_place(ring, ring->head) = key;
    ring->places[key & ring->mask] = ring->head;
    ring->head += (uint32_t)(KEY_SIZE + GLINT_ALIGNED(size));
}
