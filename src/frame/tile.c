/* SPDX-License-Identifier: MIT */
/* Draws the triangles that a pass lists for one tile, into buffers that this file measures and lays out. */
#include "../blend/blend.h"
#include "../light/evaluation.h"
#include "../light/room.h"
#include "../light/wear.h"
#include "../pixel/pixel.h"
#include "../raster/depth.h"
#include "frame.h"

/* ---- Buffers ---- */

size_t glint_row_bytes(const glint_format *format, uint32_t width) {
    return ((size_t)width * format->bits + 7) / 8;
}

/* Returns the bytes of a tile's pixels. */
static size_t size_pixels(const glint_config *config) {
    return glint_row_bytes(config->format, config->tile_width) * config->tile_height << glint_sample_bits(config);
}

/* Returns the bytes of a tile's depth, of rows, and of layers. */
static size_t size_depth(const glint_config *config) {
    const size_t rows = 2 * config->tile_width * sizeof(int32_t[3]) << glint_sample_bits(config) / 2;
    const size_t light = sizeof(glint_lamps) + sizeof(glint_lit_room);
    const size_t pixels = (size_t)config->tile_width * config->tile_height << glint_sample_bits(config);
    return (rows < light ? light : rows) + pixels * sizeof(uint16_t) +
           (config->layers ? config->layers->size(config) : 0);
}

size_t glint_workspace_size(const glint_config *config) {
    if (!config)
        return 0;
    glint_config full = *config;
    return glint_check_config(&full) == GLINT_OK ? size_depth(&full) + size_pixels(&full) : 0;
}

size_t glint_second_pixels(const glint_config *config) {
    const size_t size = size_pixels(config);
    return config->pixels ? (size + GLINT_CACHE_LINE - 1) / GLINT_CACHE_LINE * GLINT_CACHE_LINE : size;
}

/* Returns how many tiles have pixels: one is drawn while another is sent. */
static size_t count_tiles(const glint_config *config) {
    return config->flush.wait ? 2 : 1;
}

size_t glint_pixels_need(const glint_config *config) {
    if (!config)
        return 0;
    glint_config full = *config;
    full.pixels = &full; /* anything but null */
    return glint_check_config(&full) == GLINT_OK ? glint_second_pixels(&full) * count_tiles(&full) : 0;
}

size_t glint_tile_buffers_size(const glint_config *config) {
    const size_t pixels = config->pixels ? 0 : count_tiles(config) * size_pixels(config);
    return GLINT_ALIGNED(size_depth(config) + pixels);
}

static uint32_t or_default(uint32_t size) {
    return size ? size : GLINT_TILE_DEFAULT;
}

void glint_place_lights(glint_workspace *workspace) {
    workspace->lamps = (void *)workspace->row;
    workspace->room = (void *)(workspace->lamps + 1);
    workspace->layer = (void *)(workspace->room + 1);
}

void glint_workspace_init(glint_workspace *workspace, const glint_config *config, void *memory) {
    const uint32_t width = or_default(config->tile_width), height = or_default(config->tile_height);
    workspace->depth = memory;
    workspace->pixels = workspace->depth + (width * height << glint_sample_bits(config));
    workspace->stride = glint_row_bytes(config->format, width);
    void *const last = (uint8_t *)workspace->pixels + (workspace->stride * height << glint_sample_bits(config));
    workspace->row = last;
    glint_place_lights(workspace);
    workspace->spare = (glint_spare){0, 0, 0};
}

/* Finds the first pixel of a tile on the screen, wherever the region begins. */
static void find_first_pixel(const glint_frame *frame, uint32_t tile, int *x, int *y) {
    const uint32_t row = tile / frame->tile_columns, column = tile % frame->tile_columns;
    *x = (int)((column + frame->first_column) << frame->tile_shift_x);
    *y = (int)((row + frame->first_row) << frame->tile_shift_y);
}

/* Finds where a tile lies, and how far its part of the region begins from its first pixel, in pixels that are sent. */
static void cut_tile(const glint_frame *frame, uint32_t tile, glint_tile *to, uint32_t *across, uint32_t *down) {
    const glint_config *const config = &frame->config;
    const unsigned shift = glint_sample_shift(frame);
    int x, y;
    find_first_pixel(frame, tile, &x, &y);
    const int left = glint_most(x, config->region.x), top = glint_most(y, config->region.y);
    to->x = left >> shift;
    to->y = top >> shift;
    to->width = (glint_least(x + config->tile_width, frame->right) - left) >> shift;
    to->height = (glint_least(y + config->tile_height, frame->bottom) - top) >> shift;
    *across = (uint32_t)(left - x) >> shift;
    *down = (uint32_t)(top - y) >> shift;
}

void glint_tile_find(const glint_frame *frame, const glint_workspace *workspace, uint32_t tile, glint_tile *to) {
    const glint_format *const format = frame->config.format;
    uint32_t across, down;
    cut_tile(frame, tile, to, &across, &down);
    to->stride = workspace->stride;
    to->pixels =
        (uint8_t *)workspace->pixels + down * to->stride + (format->edge[1] ? across : across * format->bits / 8);
    to->depth_stride = (size_t)frame->config.tile_width >> glint_sample_shift(frame);
    to->depth = workspace->depth + down * to->depth_stride + across;
    to->frame = frame;
    to->workspace = workspace;
}

void glint_tile_rectangle(const glint_frame *frame, uint32_t tile, int *x, int *y, int *width, int *height) {
    glint_tile to;
    uint32_t across, down;
    cut_tile(frame, tile, &to, &across, &down);
    *x = to.x;
    *y = to.y;
    *width = to.width;
    *height = to.height;
}

/* ---- Backgrounds ---- */

void glint_repeat(void *bytes, size_t period, size_t size) {
    uint8_t *first = bytes;
    for (size_t done = period; done < size; done *= 2)
        memcpy(first + done, first, done);
}

/* The loop below fills blocks of this size. */
#define FILL_BLOCK 64

GLINT_HOT void glint_fill_words(void *bytes, uint32_t word, size_t size) {
#if defined(__GNUC__) && defined(__arm__) && !GLINT_SMALL
    if (size % FILL_BLOCK == 0) { /* no compiler makes these instructions of C */
        register uint32_t a __asm__("r2") = word, b __asm__("r3") = word, c __asm__("r4") = word,
                            d __asm__("r5") = word;
        uint8_t *to = bytes, *const end = to + size;
        do
            __asm__ volatile("stmia %0!, {%1, %2, %3, %4}\n\tstmia %0!, {%1, %2, %3, %4}\n\t"
                             "stmia %0!, {%1, %2, %3, %4}\n\tstmia %0!, {%1, %2, %3, %4}"
                             : "+l"(to)
                             : "l"(a), "l"(b), "l"(c), "l"(d)
                             : "memory");
        while (to != end);
        return;
    }
#endif
    memcpy(bytes, &word, sizeof word);
    glint_repeat(bytes, sizeof word, size);
}

static GLINT_NOINLINE int paint(const glint_painter *painter, const glint_frame *frame,
                                const glint_workspace *workspace, uint32_t tile) {
    glint_tile of;
    glint_tile_find(frame, workspace, tile, &of);
    return painter->paint(painter->context, &of);
}

/* Fills a tile with background. What this uses of the stack is not there while triangles are drawn.
 * @return not 0 where the painter failed */
static GLINT_NOINLINE int clear(const glint_frame *frame, glint_workspace *workspace, uint32_t tile) {
    const glint_config *config = &frame->config;
    if (config->background.paint) {
        const int failed = paint(&config->background, frame, workspace, tile);
        if (frame->samples)
            frame->samples->spread(frame, workspace->pixels);
        return failed;
    }
    const glint_colour *background = &frame->scene->background;
    const uint32_t shown[3] = {(uint32_t)background->r << 7, (uint32_t)background->g << 7,
                               (uint32_t)background->b << 7};
    int32_t colour[1][3];
    glint_channels_of(shown, colour[0]);
    glint_finish_colours(config, colour, 1);
    config->format->fill(workspace->pixels, frame->tile_shift_x, config->tile_height, colour[0]);
    return 0;
}

int glint_tile_is_empty(const glint_frame *frame, uint32_t tile) {
    return frame->starts && frame->ends && frame->references[tile - frame->tile_first].next == GLINT_LIST_END;
}

/* Swaps the corners of a triangle that runs clockwise on the screen. */
static GLINT_NOINLINE void turn_round(glint_triangle *triangle, const glint_draw *draw) {
    const glint_vertex *const *v = triangle->corners;
    const int clockwise = glint_double_area(v[0], v[1], v[2]) > 0;
    triangle->back = clockwise != draw->mirrored;
    if (!clockwise)
        return;
    const glint_vertex *corner = triangle->corners[1];
    triangle->corners[1] = triangle->corners[2];
    triangle->corners[2] = corner;
    if (draw->extra) {
        const int16_t *extra = triangle->extra[1];
        triangle->extra[1] = triangle->extra[2];
        triangle->extra[2] = extra;
    }
}

/* Plain triangles of walk->draw, by their numbers in the pass, need nothing but corners. Some draws have none. */
typedef struct plain_triangles {
    uint32_t first, count;
    int may_turn; /* whether corners may run clockwise on the screen */
} plain_triangles;

static inline plain_triangles no_triangles(void) {
    uint32_t none = 0;
    GLINT_OPAQUE(none); /* otherwise compilers store two zeros from a register of the FPU */
    return (plain_triangles){none, none, 0};
}

static inline const uint16_t *find_corners(const glint_draw *draw, uint32_t i, glint_triangle *t) {
    const uint16_t *indices = draw->triangles[i];
    t->corners[0] = &draw->vertices[indices[0]];
    t->corners[1] = &draw->vertices[indices[1]];
    t->corners[2] = &draw->vertices[indices[2]];
    t->index = i;
    return indices;
}

/* Returns the clipped triangle of a number. */
static const glint_clipped *clipped_of(const glint_frame *frame, uint32_t number) {
    const glint_clipped *top = (const glint_clipped *)(const void *)(frame->memory.base + frame->memory.high);
    return top - 1 - (GLINT_CLIPPED_TOP - number);
}

/* Returns the draw of a triangle: this one or one that follows. */
static const glint_draw *find_draw(const glint_frame *frame, const glint_draw *draw, uint32_t number) {
    if (number > GLINT_TRIANGLES_MAX)
        return clipped_of(frame, number)->draw;
    while (number - draw->first >= draw->count)
        draw = draw->next;
    return draw;
}

/* Begins with the triangles of a draw. */
static void begin_draw(glint_row_walk *walk, const glint_draw *draw) {
    walk->draw = draw;
    walk->triangle.away = draw->unreached;
    walk->lanes[0] = draw->flat;
    walk->packed = draw->packed;
}

/* Finds any triangle: of the walk's draw, of one that follows, or made by clipping. */
static GLINT_NOINLINE void find_any_triangle(glint_row_walk *walk, plain_triangles *plain, uint32_t number) {
    glint_triangle *const t = &walk->triangle;
    const glint_draw *const draw = find_draw(walk->frame, walk->draw, number);
    if (number > GLINT_TRIANGLES_MAX) {
        const glint_clipped *clipped = clipped_of(walk->frame, number);
        for (int i = 0; i < 3; i++) {
            t->corners[i] = &clipped->corners[i];
            t->extra[i] = clipped->extra[i];
        }
        t->index = clipped->triangle;
    } else {
        const uint16_t *indices = find_corners(draw, number - draw->first, t);
        for (int i = 0; i < 3 && draw->extra; i++)
            t->extra[i] = draw->extra[indices[i]];
    }
    if (draw != walk->draw)
        begin_draw(walk, draw);
    t->back = 0;
    plain->first = draw->first;
    plain->count = draw->extra ? 0 : draw->count;
    plain->may_turn = draw->mirrored || draw->double_sided;
    if (plain->may_turn)
        turn_round(t, draw);
}

/* Finds a triangle by its number. A list names draws in order, none before the walk's. */
static inline void find_triangle(glint_row_walk *walk, plain_triangles *plain, uint32_t number) {
    const uint32_t i = number - plain->first;
    if (i >= plain->count) {
        find_any_triangle(walk, plain, number);
        return;
    }
    find_corners(walk->draw, i, &walk->triangle);
    if (plain->may_turn)
        turn_round(&walk->triangle, walk->draw);
}

/* Colours of so many columns, from a multiple on, may be interpolated together, if enough of them are drawn. */
#define COLUMNS_TOGETHER 8

/* Places a tile. It is drawn from its first pixel on, wherever the region begins, to the region's end, and as far
 * beyond as columns are drawn together: so that how they are does not depend on the region. */
static void place_tile(const glint_frame *frame, glint_window *window, uint32_t tile) {
    const glint_config *const config = &frame->config;
    const int32_t right = glint_least(config->width, (frame->right + COLUMNS_TOGETHER - 1) & -COLUMNS_TOGETHER);
    int x, y;
    find_first_pixel(frame, tile, &x, &y);
    glint_window_begin(window, x, y, glint_least(config->tile_width, right - x),
                       glint_least(config->tile_height, frame->bottom - y));
}

/* ---- Hidden draws ---- */

/* Does a draw hide nothing behind its pixels, or not all? */
static inline int lets_through(const glint_frame *frame, const glint_draw *draw) {
    return glint_has_holes(draw) || (frame->config.layers && draw->shading->material->blend);
}

/* Hides what lies behind a span: stores its depth, less a step, so that the span itself is still nearer. */
static void hide_span(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    uint16_t *depth = walk->depth + ((uint32_t)row << walk->shift) + left, *const end = depth + (right - left);
    uint32_t z = glint_z_at(walk, row, left);
    for (; depth < end; depth++, z += (uint32_t)walk->z.dx) {
        const uint32_t here = ((uint32_t)glint_most((int32_t)z, GLINT_DEPTH_BIAS) >> 15) - 1;
        if (here >= *depth) {
            *depth = (uint16_t)here;
            walk->packed = 1; /* it may be visible */
        }
    }
}

static void begin_hiding(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    glint_begin_depth(walk);
    walk->draw_span = hide_span;
    hide_span(walk, row, left, right);
}

/*
 * Hides the parts of costly objects that lie behind objects drawn later: light that nobody sees costs more than finding
 * depth twice. Triangles drawn later that are not visible leave the list. Pixels are the same whatever is hidden here.
 */
static GLINT_NOINLINE void hide_objects(const glint_frame *frame, glint_row_walk *walk, glint_reference *list) {
    glint_reference *const references = frame->references;
    const glint_draw *const first = find_draw(frame, frame->draws, references[list->next].triangle);
    const uint32_t last = find_draw(frame, first, references[list->triangle].triangle)->object;
    plain_triangles plain = no_triangles();
    uint32_t behind = last; /* the first costly object */
    if (first->object == last)
        return;
    for (glint_reference *before = list, *here; before->next != GLINT_LIST_END; before = here) {
        here = &references[before->next];
        find_triangle(walk, &plain, here->triangle);
        if (walk->draw->object < behind && walk->draw->fragments & GLINT_ARE_COSTLY)
            behind = walk->draw->object;
        if (walk->draw->object <= behind || lets_through(frame, walk->draw))
            continue;
        walk->packed = 0;
        walk->draw_span = begin_hiding;
        glint_walk_triangle(walk);
        if (walk->packed)
            continue;
        before->next = here->next;
        here = before;
    }
}

/* ---- Tiles ---- */

/* Draws the triangles of a tile's list. This is out of line, where the loop has all registers. */
static GLINT_NOINLINE void draw_triangles(const glint_frame *frame, glint_workspace *workspace, uint32_t tile) {
    glint_reference *const references = frame->references, *const list = &references[tile - frame->tile_first];
    plain_triangles plain = no_triangles();
    glint_row_walk walk;
    glint_part part;
    place_tile(frame, &part.window, tile);
    glint_walk_begin_tile(&walk, frame, workspace, &part);
    glint_walk_begin_format(&walk, &frame->config);
    walk.list = &workspace->room->list;
    walk.suns = &workspace->room->of.suns;
    begin_draw(&walk, frame->draws);
    if (!GLINT_SMALL && frame->has_costly && (frame->starts || !frame->config.layers)) { /* no layer is begun */
        hide_objects(frame, &walk, list);
        begin_draw(&walk, frame->draws);
    }
    for (uint32_t here = list->next; here != GLINT_LIST_END;) {
        const glint_reference *const reference = &references[here];
        here = reference->next;
        find_triangle(&walk, &plain, reference->triangle);
        walk.draw->draw_triangle(&walk);
    }
}

/* Finishes layers and fog, where there are any. @return not 0 where the background's painter failed */
static int finish_blended(const glint_frame *frame, glint_workspace *workspace) {
    const glint_fog *const fog = frame->scene->fog;
    if (frame->config.layers)
        return frame->config.layers->finish(frame, workspace);
    if (fog)
        fog->type->fade(frame, workspace->depth, workspace->pixels, 0, 0,
                        (uint32_t)frame->config.tile_width << frame->tile_shift_y);
    return 0;
}

/* Finishes a tile that is drawn. @return 1, or GLINT_ERROR_PAINT */
static int end_tile(const glint_frame *frame, glint_workspace *workspace, uint32_t tile) {
    const glint_painter *const overlay = &frame->config.overlay;
    if (!glint_tile_is_empty(frame, tile) && finish_blended(frame, workspace))
        return GLINT_ERROR_PAINT;
    if (frame->samples) {
        frame->samples->average(frame, workspace->pixels);
        if (overlay->paint)
            frame->samples->keep_nearest(frame, workspace->depth);
    }
    return overlay->paint && paint(overlay, frame, workspace, tile) ? GLINT_ERROR_PAINT : 1;
}

int glint_render_tile(const glint_frame *frame, glint_workspace *workspace, uint32_t tile) {
    const glint_layer_stage *const layers = frame->config.layers;
    if (frame->starts) {
        if (layers)
            layers->begin(workspace, tile);
        if (clear(frame, workspace, tile))
            return GLINT_ERROR_PAINT;
        if (!glint_tile_is_empty(frame, tile) || frame->config.overlay.paint)
            glint_fill_words(workspace->depth, 0,
                             (size_t)frame->config.tile_width * frame->config.tile_height * sizeof *workspace->depth);
    }
    if (frame->references[tile - frame->tile_first].next != GLINT_LIST_END)
        draw_triangles(frame, workspace, tile);
    return frame->ends ? end_tile(frame, workspace, tile) : 0;
}
