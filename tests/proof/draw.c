/* SPDX-License-Identifier: MIT */
/* From spans to pixels: runs, rows of colours, and what triangles begin with. */
#include "proof.h"

#include "../../src/light/draw.c"
#include "gathering.h"
#include "lit.h"
#include "pixels.h"
#include "plane.h"

/*
 * Not proven: glint_draw_facet: it hands on what draw_even is proven for. The image tests under ASan.
 */

/* Stands on glint_find_runs, whose runs lie in their span, and on what draws a run, which fills no more. The image
 * tests under ASan. */
/*@ requires \valid_read(from);
    requires \valid_read(from->to.frame) && \valid_read(from->to.workspace) && \valid_read(from->to.part);
    requires \initialized(&from->draw_run) && \initialized(&from->is_deep);
    assigns \result \from indirect: *from; */
static uint32_t draw_runs(const colour_source *from);

#define WIDTH 8

/* ---- Rows ---- */

static const uint16_t tables[3][GLINT_GAMMA_ENTRIES];

static void any_place(glint_part *part) {
    any_plane(&part->depth);
    part->x = ANY(-2047, 2047);
    part->y = ANY(-2047, 2047);
    part->window.left = ANY(-(GLINT_SIZE_MAX * 16), GLINT_SIZE_MAX * 16);
    part->window.top = ANY(-(GLINT_SIZE_MAX * 16), GLINT_SIZE_MAX * 16);
}

static void any_store(void *pixels, unsigned shift, const glint_run *run, const glint_run *end,
                      const int32_t (*colour)[3]) {
    (void)pixels;
    /*@ assert end == run + 1; */
    /*@ assert 0 < run->count && (run->y << shift) + run->x + run->count <= 8 << shift; */
    /*@ assert \initialized(&colour[0 .. run->count - 1][0 .. 2]); */
}

static void any_quadratic(glint_quadratic *q) {
    q->start = ANY_UNSIGNED(0, UINT32_MAX);
    q->dx = ANY_UNSIGNED(0, UINT32_MAX);
    q->dy = ANY_UNSIGNED(0, UINT32_MAX);
    q->dxx = ANY_UNSIGNED(0, UINT32_MAX);
    q->dxy = ANY_UNSIGNED(0, UINT32_MAX);
    q->dyy = ANY_UNSIGNED(0, UINT32_MAX);
}

/* Every run in each row of a tile of 8 x 8. */
#define FOR_RUNS(y, at)              \
    FOR_PARTS(y, 0, WIDTH - 1)       \
    FOR_PARTS(first, 0, WIDTH - 1)   \
    FOR_PARTS(end, first + 1, WIDTH) \
    for (const glint_run *at = any_run_of(first, end, y); at; at = 0)

static const glint_run *any_run_of(int first, int end, int y) {
    static glint_run at;
    at = (glint_run){(uint8_t)first, (uint8_t)y, (uint8_t)(end - first)};
    return &at;
}

static void any_small_tile(glint_frame *frame, glint_part *part) {
    static const glint_format format = {.store = any_store, .channel = {5, 6, 5}};
    any_place(part);
    frame->config.format = &format;
    frame->config.gamma = 0;
    frame->tile_shift_x = 3;
}

/* Any row. */
PROOF(store_run) {
    glint_frame frame;
    glint_part part;
    int32_t row[WIDTH][3] = {{0}};
    glint_workspace workspace = {.row = row};
    const colour_source from = {.to = {&frame, &workspace, &part, 0, 0, 0}, .draw_run = store_run};
    any_small_tile(&frame, &part);
    FOR_RUNS(y, at) {
        store_run(&from, at);
    }
}

/*
 * Any polynomials, with output tables and without.
 * @contract glint_finish_colours
 * @narrowing polynomials are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(draw_channel_run) {
    glint_quadratic channels[3];
    glint_frame frame;
    glint_part part;
    any_small_tile(&frame, &part);
    for (int c = 0; c < 3; c++)
        any_quadratic(&channels[c]);
    FOR_RUNS(y, at) {
        int32_t row[WIDTH][3];
        glint_workspace workspace = {.row = row};
        const colour_source from = {.to = {&frame, &workspace, &part, 0, 0, 0}, .channels = channels};
        frame.config.gamma = y & 1 ? tables : 0;
        draw_channel_run(&from, at);
    }
}

/*
 * Any runs after any number of fragments, and the first one of a triangle.
 * @contract glint_gathering_begin glint_gathering_store
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @unreached 4 what is done built for size
 */
PROOF(gather_run) {
    static glint_gathered gathered;
    static const int16_t normals[3][3];
    const int16_t *const main[3] = {normals[0], normals[1], normals[2]};
    const glint_triangle triangle = {.number = 0};
    glint_workspace workspace = {.gathered = &gathered};
    glint_fragments *const fragments = &gathered.fragments;
    glint_draw draw;
    glint_frame frame;
    glint_part part;
    const colour_source from = {
        {&frame, &workspace, &part, &draw, glint_shade, fragments}, gather_run, &triangle, main};
    any_small_tile(&frame, &part);
    FOR_PARTS(before, -1, GLINT_FRAGMENTS_MAX - 1) {
        FOR_PARTS(first, 0, WIDTH - 1) {
            FOR_PARTS(end, first + 1, WIDTH) {
                fragments->count = before < 0 ? 0 : (uint32_t)before;
                fragments->attributes = before < 0 ? 0 : &gathered.attributes;
                gather_run(&from, any_run_of(first, end, 5));
                /*@ assert fragments->count < GLINT_FRAGMENTS_MAX; */
            }
        }
    }
}

/* Fragments anywhere on any screen, planes of any slopes. @contract glint_resolve_colour @unsigned
 * @options -eva-slevel 0 -eva-min-loop-unroll 9 */
PROOF(resolve) {
    glint_frame frame;
    glint_fragments fragments;
    glint_attributes attributes;
    glint_draw draw;
    glint_part part;
    any_planes(&attributes);
    FOR_PARTS(count, 1, GLINT_FRAGMENTS_MAX) {
        any_run(&frame, &fragments, &part, (uint32_t)count);
        fragments.attributes = &attributes;
        resolve(&frame, &fragments, &draw);
    }
}

/* ---- Triangles ---- */

static glint_vertex corners[3];
static int16_t extra[3][3];
static glint_triangle triangle;
static glint_part part_of_all;
static glint_workspace workspace_of_all;

/* Any gradients: EVA keeps the two kinds apart. */
#define ANY_GRADIENTS(to)   \
    do {                    \
        if (ANY(0, 1))      \
            any_wide(to);   \
        else                \
            any_narrow(to); \
    } while (0)

/* Corners of any attributes from `least` on; parts are counted or not. */
static void any_triangle(int16_t least) {
    static glint_drawn drawn[GLINT_KERNELS];
    workspace_of_all.drawn = ANY(0, 1) ? drawn : 0;
    any_place(&part_of_all);
    part_of_all.top = 0;
    part_of_all.bottom = 1;
    part_of_all.spans[0] = (glint_span){0, WIDTH};
    for (int i = 0; i < 3; i++) {
        for (int c = 0; c < 3; c++) {
            corners[i].attribute[c] = (int16_t)ANY(least, 32767);
            extra[i][c] = (int16_t)ANY(0, GLINT_COLOUR_ONE);
        }
        triangle.corners[i] = &corners[i];
        triangle.extra[i] = extra[i];
        corners[i].inverse_w = ANY(64, INT32_MAX);
        corners[i].x = (int16_t)ANY(INT16_MIN, INT16_MAX);
        corners[i].y = (int16_t)ANY(INT16_MIN, INT16_MAX);
    }
    triangle.back = ANY(0, 1);
    triangle.number = ANY_UNSIGNED(0, UINT16_MAX);
}

/* Corners of any normals and 1/w. @contract glint_gathering_store draw_runs */
PROOF(glint_draw_any) {
    static glint_draw draw;
    static glint_frame frame;
    static glint_gathered gathered;
    any_triangle(-32767);
    ANY_GRADIENTS(&part_of_all.gradients);
    workspace_of_all.gathered = &gathered;
    glint_draw_any(&frame, &workspace_of_all, &draw, &triangle, &part_of_all);
}

/* Stands on the most of three, which is no less than the least. */
/*@ requires \valid_read(v + (0 .. 2));
    assigns \result \from indirect: v[0 .. 2];
    admit ensures \result.least <= 65535 && 1 <= \result.change <= 65536; */
static inline glint_w_range glint_find_w_range(const glint_vertex *const v[3]);

/* Stands on PROOF(glint_barycentric_begin) in polynomial.c. */
/*@ requires \valid(barycentric) && \valid_read(gradients);
    assigns *barycentric \from *gradients, gradients, unit;
    ensures \initialized(barycentric); */
void glint_barycentric_begin(glint_barycentric *barycentric, const glint_gradients *gradients, int32_t unit);

/* Stands on PROOF(glint_polynomial_begin) in polynomial.c, of such terms and bulges. */
/*@ requires \valid(q) && \valid_read(barycentric);
    requires \subset(a[0 .. 2], (0 .. 32767)) && \subset(b[0 .. 2], (-12096 .. 12096));
    assigns *q \from *barycentric, a[0 .. 2], b[0 .. 2];
    ensures \initialized(q); */
void glint_polynomial_begin(glint_quadratic *q, const glint_barycentric *barycentric, const int32_t a[3],
                            const int32_t b[3]);

/*
 * Colours at corners of any 1/w, any levels. @contract glint_find_w_range
 * @unsigned
 * @alarms 3 the most of three colours is no less than the least: 32767 times 65536 fits; 1/w that changes by at most
 * 7/16 is above 0, and their ratio below 2^11. Suite `models`
 * @unreached 1 leading zeros of 0
 */
PROOF(find_fit) {
    const int16_t *const colour[3] = {extra[0], extra[1], extra[2]};
    any_triangle(0);
    triangle.area = ANY(1, 0x40000000);
    ANY_GRADIENTS(&part_of_all.gradients);
    FOR_PARTS(bits, 0, 8) {
        const glint_format format = {.channel = {5, (uint8_t)bits, 5}};
        find_fit(&triangle, &part_of_all.gradients, &format, colour);
    }
}

/* Corners whose 1/w are less than a factor 4 apart, with the room that the largest leaves. */
PROOF(find_skew) {
    FOR_PARTS(bits, 17, 31) {
        for (int i = 0; i < 2; i++)
            corners[i].inverse_w = ANY(1 << (bits - 2), (int32_t)((1u << bits) - 1));
        find_skew(&corners[0], &corners[1], 31u - (unsigned)bits);
    }
}

/* Stands on PROOF(find_skew), and on triangles that are not deep. */
/*@ requires \valid_read(a) && \valid_read(b);
    assigns \result \from *a, *b, up;
    admit ensures -MOST_SKEW <= \result <= MOST_SKEW; */
static int32_t find_skew(const glint_vertex *a, const glint_vertex *b, unsigned up);

/*
 * Any colours.
 * @contract find_skew glint_barycentric_begin glint_polynomial_begin
 * @unreached 2 leading zeros of 0
 */
PROOF(begin_channel_quadratics) {
    glint_quadratic channel[3];
    int32_t a[3][3];
    const glint_vertex *const v[3] = {&corners[0], &corners[1], &corners[2]};
    any_triangle(0);
    ANY_GRADIENTS(&part_of_all.gradients);
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 3; i++)
            a[c][i] = ANY(0, GLINT_COLOUR_ONE);
    begin_channel_quadratics(channel, &part_of_all.gradients, v, a);
}

/* Any colours. @contract glint_plane_begin */
PROOF(begin_channel_planes) {
    glint_quadratic channel[3];
    int32_t a[3][3];
    any_triangle(0);
    ANY_GRADIENTS(&part_of_all.gradients);
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 3; i++)
            a[c][i] = ANY(0, GLINT_COLOUR_ONE);
    begin_channel_planes(channel, &part_of_all.gradients, a);
}

static void any_draw_even(const glint_spans *spans, const int32_t colour[3]) {
    (void)spans;
    /*@ assert \subset(colour[0 .. 2], (CHANNEL_LEAST .. CHANNEL_MOST)); */
}

/* Channels are there wherever colours fit: builds under MSan. */
static void any_draw_channels(const glint_spans *spans, const glint_quadratic *channel, int is_curved) {
    (void)spans, (void)channel, (void)is_curved;
}

/*@ assigns \result \from indirect: *triangle, indirect: *g, indirect: *format, indirect: colour[0 .. 2];
    ensures 0 <= \result <= 2; */
static curve_fit find_fit(const glint_triangle *triangle, const glint_gradients *g, const glint_format *format,
                          const int16_t *const colour[3]);

/*@ requires \valid(channel + (0 .. 2)) && \valid_read(g) && \initialized(&a[0 .. 2][0 .. 2]);
    assigns channel[0 .. 2] \from *g, a[0 .. 2][0 .. 2];
    ensures \initialized(channel + (0 .. 2)); */
static void begin_channel_planes(glint_quadratic channel[3], const glint_gradients *g, int32_t a[3][3]);

/*@ requires \valid(channel + (0 .. 2)) && \valid_read(g) && \valid_read(v + (0 .. 2));
    requires \initialized(&a[0 .. 2][0 .. 2]);
    assigns channel[0 .. 2] \from *g, v[0 .. 2], a[0 .. 2][0 .. 2];
    ensures \initialized(channel + (0 .. 2)); */
static void begin_channel_quadratics(glint_quadratic channel[3], const glint_gradients *g,
                                     const glint_vertex *const v[3], int32_t a[3][3]);

/* Stands on a pass that leaves no bytes of the arena. */
/*@ assigns \result \from indirect: *workspace, indirect: key;
    admit ensures \result == \null; */
const void *glint_ring_find(const glint_workspace *workspace, uint32_t key);

/* Stands on the same. */
/*@ assigns \result \from indirect: *workspace, indirect: most;
    admit ensures \result == \null; */
void *glint_ring_begin(glint_workspace *workspace, size_t most);

/*
 * Colours at any corners, seen from both sides; in formats with loops of their own and without, with output tables and
 * without; of the first draw and of others, in front of any depths.
 * @contract glint_is_visible find_fit begin_channel_planes begin_channel_quadratics draw_runs glint_gathering_store
 * glint_ring_find glint_ring_begin
 * @narrowing planes are evaluated modulo 2^32
 * @unreached 7 what is handed on between tiles
 */
PROOF(glint_draw_lit) {
    static glint_draw draw;
    static glint_gathered gathered;
    uint16_t depth[WIDTH];
    glint_frame frame;
    for (int i = 0; i < WIDTH; i++)
        depth[i] = (uint16_t)ANY(0, UINT16_MAX);
    frame.draws = ANY(0, 1) ? &draw : 0;
    workspace_of_all.depth = depth;
    workspace_of_all.gathered = &gathered;
    frame.tile_shift_x = (uint8_t)ANY(3, 6);
    any_triangle(0);
    ANY_GRADIENTS(&part_of_all.gradients);
    any_plane(&part_of_all.depth);
    FOR_PARTS(kind, 0, 7) {
        const uint8_t green = kind & 1 ? 6 : 0, red = kind & 1 ? 5 : 0;
        const glint_format format = {.channel = {red, green, red}, .draw_channels = kind & 2 ? any_draw_channels : 0};
        frame.config.format = &format;
        frame.config.gamma = kind & 4 ? tables : 0;
        triangle.back = ANY(0, 1);
        glint_draw_lit(&frame, &workspace_of_all, &draw, &triangle, &part_of_all);
    }
}

/*
 * Any finished colour, in formats with loops of their own and without: a tile's row holds it.
 * @contract draw_runs
 * @unreached 2 glint_count where nothing is counted: it is not called
 */
PROOF(glint_draw_unlit) {
    static glint_draw draw;
    glint_frame frame;
    int32_t row[GLINT_TILE_MAX][3];
    any_triangle(0);
    for (int c = 0; c < 3; c++)
        draw.even[c] = ANY(CHANNEL_LEAST, CHANNEL_MOST);
    workspace_of_all.row = row;
    FOR_PARTS(shift, 3, 6) {
        FOR_PARTS(fused, 0, 1) {
            const glint_format format = {.draw_even = fused ? any_draw_even : 0};
            frame.config.format = &format;
            frame.config.gamma = 0;
            frame.config.tile_width = (uint16_t)(1 << shift);
            frame.tile_shift_x = (uint8_t)shift;
            glint_draw_unlit(&frame, &workspace_of_all, &draw, &triangle, &part_of_all);
        }
    }
}

/* Any corners' 1/w. */
PROOF(glint_is_deep) {
    any_triangle(0);
    glint_is_deep(&triangle);
}
