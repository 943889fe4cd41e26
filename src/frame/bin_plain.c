/* SPDX-License-Identifier: MIT */
/* Plain draws, nowhere clipped: one loop culls and lists their triangles. */
#include "lists.h"

/* Keeps what a variable holds out of the registers. */
#if defined(__GNUC__)
#define IN_MEMORY(x) __asm__("" : "+m"(x))
#else
#define IN_MEMORY(x) ((void)0)
#endif

/*
 * What a triangle that faces the eye needs: kept in memory, so that the loop over all has the registers. Places are
 * words of two halves, for x and y, as place_of_word gives.
 */
typedef struct grid {
    glint_frame *frame;
    glint_draw *draw;
    uint32_t shift_x, shift_y; /* from a half to a tile's column and row */
    uint32_t above;            /* the bits of these */
    uint32_t last;             /* the last place of the region, which begins in the screen's first tile */
    uint32_t columns, first, count;
    uint32_t most;           /* references there may be */
    uint32_t end, reference; /* behind the last triangle: its number and what would refer to it */
} grid;

static grid grid_of(glint_frame *frame, glint_draw *draw, uint32_t end) {
    const uint32_t shift_x = frame->tile_shift_x + 4u, shift_y = frame->tile_shift_y + 4u;
    return (grid){frame,
                  draw,
                  shift_x,
                  shift_y + 16,
                  (0xffffu << shift_x & 0xffffu) | 0xffff0000u << shift_y,
                  (16u * frame->right - 1) | (16u * frame->bottom - 1) << 16,
                  frame->tile_columns,
                  frame->tile_first,
                  glint_pass_tiles(frame),
                  glint_most_references(frame),
                  end,
                  glint_reference_to((uint32_t)draw->first + end)};
}

/* x and y of a vertex as two halves of a word. */
static inline uint32_t word_of(const glint_vertex *v) {
    return (uint32_t)(uint16_t)v->x | (uint32_t)(uint16_t)v->y << 16;
}

static inline int32_t difference_of_x(uint32_t a, uint32_t b) {
    uint32_t difference = a - b;
    GLINT_OPAQUE(difference); /* else both halves are taken out first */
    return (int16_t)difference;
}

static inline int32_t y_of(uint32_t word) {
    return glint_shift_right((int32_t)word, 16);
}

/* Which triangles of a draw are seen: those whose corners run counter-clockwise on the screen, clockwise, or both. */
#define COUNTER_CLOCKWISE 1u
#define CLOCKWISE 2u

static uint32_t turns_of(const glint_draw *draw) {
    return draw->double_sided ? COUNTER_CLOCKWISE | CLOCKWISE : draw->mirrored ? CLOCKWISE : COUNTER_CLOCKWISE;
}

/* Is a triangle seen, by its corners' words? The guard band keeps differences in 16 bits. */
static inline int is_seen(const uint32_t w[3], uint32_t turns) {
    const int32_t x1 = difference_of_x(w[1], w[0]), y1 = y_of(w[1]) - y_of(w[0]);
    const int32_t x2 = difference_of_x(w[2], w[0]), y2 = y_of(w[2]) - y_of(w[0]);
    return x1 * y2 < x2 * y1 ? (turns & COUNTER_CLOCKWISE) != 0 : x1 * y2 > x2 * y1 && (turns & CLOCKWISE);
}

/* From the last pixel centre before a corner. A carry from x to y comes from x < 0, which is on no tile. */
static inline uint32_t place_of_word(uint32_t word) {
    return word + 0x00070007;
}

/*
 * Most triangles lie in one tile: then their corners' places agree in all bits above it. Where the pass is of all
 * tiles, each on the screen is one of its.
 */
typedef enum where { NOWHERE, ONE_TILE, SOMEWHERE } where;

static GLINT_INLINE where find_tile(const grid *g, const uint32_t w[3], int all_tiles, uint32_t *tile) {
    const uint32_t a = place_of_word(w[0]), differ = (a ^ place_of_word(w[1])) | (a ^ place_of_word(w[2]));
    if (!(differ & 0xfff0) || !(differ >> 20))
        return NOWHERE;
    /* Off the screen, a half or its difference from the last one is below 0. */
    if ((differ & g->above) | ((a | (g->last - a)) & 0x80008000))
        return SOMEWHERE;
    *tile = (a >> g->shift_y) * g->columns + ((a & 0xffff) >> g->shift_x) - (all_tiles ? 0 : g->first);
    GLINT_OPAQUE(*tile); /* found now, before a call that all it comes from would have to outlast */
    return ONE_TILE;
}

/* Pixels between three coordinates, which are the high halves of words: *high is exclusive. */
static inline void find_pixels(int32_t a, int32_t b, int32_t c, int32_t size, int32_t *low, int32_t *high) {
    const int32_t least = glint_least_of(a, b, c), most = glint_most_of(a, b, c);
    *low = glint_most(glint_shift_right(least + 0x70000, 20), 0);
    *high = glint_least(glint_shift_right(most + 0x70000, 20), size);
}

/* Appends a reference to the lists of a rectangle of tiles, all in the pass, from `tile` to `last`; there is room. */
static inline void append_all(const grid *g, uint32_t tile, uint32_t row_end, uint32_t last, uint32_t reference) {
    const uint32_t to_next_row = g->columns - (row_end - tile);
    glint_reference *references = g->frame->references;
    uint32_t here = g->frame->reference_count;
    for (;;) {
        glint_list_put(references, here++, tile, reference);
        if (tile == last)
            break;
        if (tile++ == row_end) {
            tile = row_end + to_next_row;
            row_end += g->columns;
        }
        GLINT_OPAQUE(tile); /* else gcc counts in more ways than one */
        GLINT_OPAQUE(here);
        GLINT_OPAQUE(references);
    }
    g->frame->reference_count = here;
}

/*
 * Which of the four quadrants around a point lies beyond one of a triangle's sides, as a bit; 0 when none does. The
 * quadrant's first pixel centre, half a pixel from the point both ways, is the one that lies least beyond.
 * @param dx, dy the side @param x, y of the point, from where the side begins
 */
static inline uint32_t quadrant_beyond(int32_t dx, int32_t dy, int32_t x, int32_t y) {
    const int32_t to_center = 8 * ((dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy));
    return dy * x - dx * y < to_center ? 1u << ((dx > 0 ? 2 : 0) + (dy < 0 ? 1 : 0)) : 0;
}

static inline uint32_t quadrant_beyond_side(uint32_t a, uint32_t b, uint32_t point) {
    return quadrant_beyond(difference_of_x(b, a), y_of(b) - y_of(a), difference_of_x(point, a), y_of(point) - y_of(a));
}

/* Lists a triangle that runs counter-clockwise with those of four tiles that it may reach; the first ends at a point.
 * There is room. */
static GLINT_NOINLINE void list_four(const grid *g, uint32_t left, uint32_t tile, uint32_t point) {
    const uint16_t *indices = g->draw->triangles[g->end - left];
    const glint_vertex *vertices = g->draw->vertices;
    const uint32_t a = word_of(&vertices[indices[0]]), b = word_of(&vertices[indices[1]]),
                   c = word_of(&vertices[indices[2]]);
    const uint32_t beyond =
        quadrant_beyond_side(a, b, point) | quadrant_beyond_side(b, c, point) | quadrant_beyond_side(c, a, point);
    for (uint32_t i = 0; i < 4; i++)
        if (!(beyond >> i & 1))
            glint_list_append(g->frame, tile + (i & 1) + (i >> 1) * g->columns, g->reference - (left << 16));
}

/* Bins a triangle, with so many left in the draw, itself too: most times in a few tiles, all in the pass. */
static GLINT_NOINLINE int bin_several(const grid *g, uint32_t left) {
    glint_frame *frame = g->frame;
    glint_draw *draw = g->draw;
    const uint32_t triangle = g->end - left;
    const uint16_t *indices = draw->triangles[triangle];
    const glint_vertex *const v[3] = {&draw->vertices[indices[0]], &draw->vertices[indices[1]],
                                      &draw->vertices[indices[2]]};
    const uint32_t a = word_of(v[0]), b = word_of(v[1]), c = word_of(v[2]);
    int32_t x, y, right, bottom;
    find_pixels((int32_t)(a << 16), (int32_t)(b << 16), (int32_t)(c << 16), frame->right, &x, &right);
    find_pixels((int32_t)a, (int32_t)b, (int32_t)c, frame->bottom, &y, &bottom);
    if (x >= right || y >= bottom) {
        frame->stats.outside++;
        return 1;
    }
    const uint32_t column = (uint32_t)x >> frame->tile_shift_x, row = (uint32_t)y >> frame->tile_shift_y;
    const uint32_t more_columns = ((uint32_t)(right - 1) >> frame->tile_shift_x) - column;
    const uint32_t more_rows = ((uint32_t)(bottom - 1) >> frame->tile_shift_y) - row;
    const uint32_t tile = row * g->columns + column - g->first, row_end = tile + more_columns;
    const uint32_t last = row_end + more_rows * g->columns;
    if (tile >= g->count || last >= g->count || frame->reference_count + (more_rows + 1) * (more_columns + 1) > g->most)
        return glint_bin_whole(frame, draw, triangle);
    glint_list_light(frame, draw, v, triangle);
    if (more_columns == 1 && more_rows == 1 && turns_of(draw) == COUNTER_CLOCKWISE)
        list_four(g, left, tile, (column + 1) << g->shift_x | (row + 1) << g->shift_y);
    else
        append_all(g, tile, row_end, last, g->reference - (left << 16));
    return 1;
}

/* Bins a triangle that is seen, with so many left in the draw, itself too. @return 0 when the arena is full. */
static GLINT_INLINE int bin_seen(const grid *g, const glint_vertex *const v[3], const uint32_t w[3], uint32_t left,
                                 int all_tiles) {
    uint32_t tile;
    const where place = find_tile(g, w, all_tiles, &tile);
    if (place == SOMEWHERE)
        return bin_several(g, left);
    if (place == NOWHERE) {
        g->frame->stats.outside++;
    } else if (all_tiles || tile < g->count) {
        if (g->frame->reference_count >= g->most)
            return 0;
        glint_list_light(g->frame, g->draw, v, g->end - left);
        glint_list_append(g->frame, tile, g->reference - (left << 16));
    }
    return 1;
}

/* bin_each of a plain draw, up to a triangle, in a pass of all tiles or of some. */
static GLINT_INLINE int bin_loop(glint_frame *frame, glint_draw *draw, uint32_t next, uint32_t end, uint32_t turns,
                                 int all_tiles) {
    grid g = grid_of(frame, draw, end);
    const glint_vertex *const vertices = draw->vertices;
    const uint32_t vertex_count = draw->vertex_count;
    const uint16_t *indices = draw->triangles[next];
    uint32_t left = end - next, away = 0;
    for (; left; left--) {
        const uint32_t a = indices[0], b = indices[1], c = indices[2];
        indices += 3;
        if ((a | b | c) >= vertex_count && (a >= vertex_count || b >= vertex_count || c >= vertex_count))
            return GLINT_ERROR_INDEX;
        const glint_vertex *const v[3] = {&vertices[a], &vertices[b], &vertices[c]};
        const uint32_t w[3] = {word_of(v[0]), word_of(v[1]), word_of(v[2])};
        if (!is_seen(w, turns)) {
            away++;
            continue;
        }
        IN_MEMORY(g);
        if (!bin_seen(&g, v, w, left, all_tiles))
            break;
    }
    frame->stats.facing_away += away;
    return (int)(end - left);
}

/* Most draws: of triangles seen from one side, not mirrored, in a pass of all tiles. */
static GLINT_NOINLINE int bin_fronts(glint_frame *frame, glint_draw *draw, uint32_t next, uint32_t end) {
    return bin_loop(frame, draw, next, end, COUNTER_CLOCKWISE, 1);
}

static GLINT_NOINLINE int bin_others(glint_frame *frame, glint_draw *draw, uint32_t next, uint32_t end) {
    return bin_loop(frame, draw, next, end, turns_of(draw), 0);
}

int glint_bin_plain(glint_frame *frame, glint_draw *draw, uint32_t next, uint32_t end) {
    return glint_pass_tiles(frame) == frame->tile_count && turns_of(draw) == COUNTER_CLOCKWISE
               ? bin_fronts(frame, draw, next, end)
               : bin_others(frame, draw, next, end);
}
