/* SPDX-License-Identifier: MIT */
/* Found: a ring of what tiles of a pass have found of triangles, and where by its key each lies. */
#include "found.h"

#include "../frame/arena.h"

/* Places count bytes through all turns of the ring: by how far one lies behind the head it is known whether what lies
 * there is that still. */
typedef struct found_ring {
    uint32_t mask;             /* of the places, a power of two of them less 1 */
    uint32_t size, head, turn; /* the head's turn began there */
    uint8_t *first;
    uint32_t places[]; /* by the lower bits of keys */
} found_ring;

/* Bytes for each place, about what one is in the mean; and most places. */
#define BYTES_FOR_PLACE 256
#define PLACES_MAX 1024

/* Fewer are not worth it: what is yet to be found takes one of the largest. */
#define LEAST_ROOM (4 * sizeof(glint_found))

static found_ring *ring_of(const glint_workspace *workspace) {
    return workspace->spare.is_begun ? workspace->spare.memory : 0;
}

/* Begins a ring. @return null where there is no room */
static found_ring *begin_ring(glint_spare *spare) {
    found_ring *const ring = spare->memory;
    uint32_t count = PLACES_MAX;
    if (spare->size < LEAST_ROOM)
        return 0;
    while (count * BYTES_FOR_PLACE > spare->size)
        count >>= 1;
    const uint32_t taken = (uint32_t)GLINT_ALIGNED(sizeof *ring + count * sizeof ring->places[0]);
    spare->is_begun = 1;
    ring->mask = count - 1;
    ring->first = (uint8_t *)spare->memory + taken;
    ring->size = (spare->size - taken) & ~(uint32_t)(GLINT_ALIGNMENT - 1);
    ring->head = ring->turn = ring->size;
    for (uint32_t i = 0; i < count; i++)
        ring->places[i] = 0; /* too old */
    return ring;
}

/* What lies at a place. */
static inline glint_found *at_place(const found_ring *ring, uint32_t place) {
    const uint32_t from = place - ring->turn + (place < ring->turn ? ring->size : 0);
    return (glint_found *)(void *)(ring->first + from);
}

const glint_found *glint_found_find(const glint_workspace *workspace, uint32_t key) {
    const found_ring *const ring = ring_of(workspace);
    if (!ring)
        return 0;
    const uint32_t place = ring->places[key & ring->mask];
    /* what is yet to be found overwrites as much as one of the largest takes */
    if (ring->head + sizeof(glint_found) - place > ring->size)
        return 0;
    const glint_found *const found = at_place(ring, place);
    return found->key == key ? found : 0;
}

glint_found *glint_found_begin(glint_workspace *workspace) {
    found_ring *ring = ring_of(workspace);
    if (!ring)
        ring = begin_ring(&workspace->spare);
    if (!ring)
        return 0;
    if (ring->head - ring->turn > ring->size - sizeof(glint_found))
        ring->head = ring->turn += ring->size;
    return at_place(ring, ring->head);
}

void glint_found_keep(glint_workspace *workspace, const glint_found *found) {
    found_ring *const ring = ring_of(workspace);
    const size_t size = found->fits ? offsetof(glint_found, polynomials) + found->terms.end * sizeof(glint_quadratic)
                                    : offsetof(glint_found, terms);
    ring->places[found->key & ring->mask] = ring->head;
    ring->head += (uint32_t)GLINT_ALIGNED(size);
}
