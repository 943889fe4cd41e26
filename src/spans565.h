/* SPDX-License-Identifier: MIT */
/**
 * @file spans565.h
 * Kernels of fast lighting for pixels of 16 bits: depth test, lighting and store in one loop over a span. A format
 * includes this and says which byte it stores first.
 */
#ifndef GLINT_SPANS565_H
#define GLINT_SPANS565_H

#include "deviation.h"
#include "setup.h"

/** Stores 16 bits at `pixel`, in the core's byte order or the high byte first. */
static inline void glint_put_565(uint8_t *pixel, uint32_t value, int high_first) {
    if (!high_first) {
        *(uint16_t *)(void *)pixel = (uint16_t)value;
        return;
    }
    pixel[0] = (uint8_t)(value >> 8);
    pixel[1] = (uint8_t)value;
}

/* A plane's value where a span begins: its value at the tile's first column, and what a column adds. */
typedef struct glint_walk {
    uint32_t row;
    uint32_t dx, dy;
} glint_walk;

static inline glint_walk glint_walk_begin(const glint_plane *plane, int32_t x, int32_t y) {
    const glint_walk walk = {(uint32_t)glint_plane_at(plane, x, y), (uint32_t)plane->dx, (uint32_t)plane->dy};
    return walk;
}

/* What a triangle's loops over pixels share. */
typedef struct glint_spans {
    const glint_part *part;
    uint16_t *depth;
    uint8_t *pixels;
    unsigned shift;
} glint_spans;

/* The light of one colour all over. */
static inline void glint_draw_constant(const glint_spans *s, uint32_t colour, int high_first) {
    const glint_part *part = s->part;
    glint_walk w = glint_walk_begin(&part->depth, part->x, part->y + (int32_t)part->top);
    w.row += 1u << 15;
    for (uint32_t row = part->top; row < part->bottom; row++, w.row += w.dy) {
        const glint_span span = part->spans[row];
        const uint32_t offset = (row << s->shift) + span.left;
        uint16_t *depth = s->depth + offset, *end = s->depth + (row << s->shift) + span.right;
        uint8_t *pixel = s->pixels + 2 * offset;
        uint32_t z = w.row + w.dx * span.left;
        for (; depth < end; depth++, pixel += 2, z += w.dx) {
            const uint32_t here = z >> 15;
            if (here <= *depth)
                continue;
            *depth = (uint16_t)here;
            glint_put_565(pixel, colour, high_first);
        }
    }
}

/* Diffuse light only; gated, ambient light alone where N.L <= 0. */
static inline void glint_draw_diffuse(const glint_spans *s, const glint_deviation *deviation, const glint_plane *cosine,
                                      int gated, int high_first) {
    const uint16_t *table = deviation->diffuse_pixel;
    const glint_part *part = s->part;
    const int32_t y = part->y + (int32_t)part->top;
    glint_walk w = glint_walk_begin(&part->depth, part->x, y), d = glint_walk_begin(cosine, part->x, y);
    w.row += 1u << 15;
    for (uint32_t row = part->top; row < part->bottom; row++, w.row += w.dy, d.row += d.dy) {
        const glint_span span = part->spans[row];
        const uint32_t offset = (row << s->shift) + span.left;
        uint16_t *depth = s->depth + offset, *end = s->depth + (row << s->shift) + span.right;
        uint8_t *pixel = s->pixels + 2 * offset;
        uint32_t z = w.row + w.dx * span.left, level = d.row + d.dx * span.left;
        for (; depth < end; depth++, pixel += 2, z += w.dx, level += d.dx) {
            const uint32_t here = z >> 15;
            if (here <= *depth)
                continue;
            *depth = (uint16_t)here;
            glint_put_565(pixel, gated && (int32_t)level <= 0 ? deviation->ambient : table[level >> 22], high_first);
        }
    }
}

/* A square of the high half of a plane. */
static inline uint32_t glint_high_square(uint32_t value) {
    const int32_t high = glint_shift_right((int32_t)value, 16);
    return (uint32_t)(high * high);
}

/* Diffuse and specular light. */
static inline void glint_draw_highlight(const glint_spans *s, const glint_deviation *deviation,
                                        const glint_deviation_planes *planes, int high_first) {
    const glint_part *part = s->part;
    const uint32_t *diffuse = deviation->diffuse, *specular = deviation->specular, end_square = deviation->specular_end;
    const int32_t first = part->y + (int32_t)part->top;
    glint_walk w = glint_walk_begin(&part->depth, part->x, first),
               d = glint_walk_begin(&planes->cosine, part->x, first);
    glint_walk ex = glint_walk_begin(&planes->x, part->x, first), ey = glint_walk_begin(&planes->y, part->x, first);
    w.row += 1u << 15;
    for (uint32_t row = part->top; row < part->bottom;
         row++, w.row += w.dy, d.row += d.dy, ex.row += ex.dy, ey.row += ey.dy) {
        const glint_span span = part->spans[row];
        const uint32_t offset = (row << s->shift) + span.left;
        uint16_t *depth = s->depth + offset, *end = s->depth + (row << s->shift) + span.right;
        uint8_t *pixel = s->pixels + 2 * offset;
        uint32_t z = w.row + w.dx * span.left, level = d.row + d.dx * span.left;
        uint32_t x = ex.row + ex.dx * span.left, y = ey.row + ey.dx * span.left;
        for (; depth < end; depth++, pixel += 2, z += w.dx, level += d.dx, x += ex.dx, y += ey.dx) {
            const uint32_t here = z >> 15;
            if (here <= *depth)
                continue;
            *depth = (uint16_t)here;
            const uint32_t square = glint_high_square(x) + glint_high_square(y);
            uint32_t word = diffuse[level >> 22];
            if (square < end_square)
                word = glint_spread_clamp(word + specular[square >> 15]);
            glint_put_565(pixel, glint_spread_pack(word), high_first);
        }
    }
}

/* All of these, with words that are computed. */
static inline void glint_draw_without_tables(const glint_spans *s, const glint_shading *shading,
                                             const glint_deviation_planes *planes, glint_deviation_kind kind,
                                             int high_first) {
    const glint_part *part = s->part;
    for (uint32_t row = part->top; row < part->bottom; row++) {
        const glint_span span = part->spans[row];
        for (uint32_t column = span.left; column < span.right; column++) {
            const int32_t x = part->x + (int32_t)column, y = part->y + (int32_t)row;
            const uint32_t offset = (row << s->shift) + column;
            const uint32_t here = ((uint32_t)glint_plane_at(&part->depth, x, y) + (1u << 15)) >> 15;
            if (here <= s->depth[offset])
                continue;
            s->depth[offset] = (uint16_t)here;
            const int32_t level = glint_plane_at(&planes->cosine, x, y);
            uint32_t square = UINT32_MAX;
            if (kind == GLINT_DEVIATION_SPECULAR)
                square = glint_high_square((uint32_t)glint_plane_at(&planes->x, x, y)) +
                         glint_high_square((uint32_t)glint_plane_at(&planes->y, x, y));
            glint_put_565(s->pixels + 2 * offset, glint_deviation_pixel(shading, level, square), high_first);
        }
    }
}

#include "quadratic565.h"

/** The kernel of a format; `high_first` is a constant where this is inlined. */
static inline void glint_draw_565(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                  const glint_triangle *triangle, const glint_part *part, int high_first) {
    const glint_deviation *deviation = draw->shading->deviation;
    const glint_spans spans = {part, workspace->depth, workspace->pixels, frame->tile_shift_x};
    glint_deviation_planes planes;
    const glint_deviation_kind kind = glint_deviation_begin(draw, triangle, part, &planes);
    if (kind == GLINT_DEVIATION_UNFIT) {
        if (!glint_draw_quadratic(frame, workspace, draw, triangle, part, high_first))
            glint_draw_any(frame, workspace, draw, triangle, part);
        return;
    }
    if (workspace->drawn)
        glint_count(workspace, (glint_kernel_name)kind, glint_deviation_covered(part));
    if (kind == GLINT_DEVIATION_AMBIENT)
        glint_draw_constant(&spans, deviation->ambient, high_first);
    else if (!deviation->diffuse)
        glint_draw_without_tables(&spans, draw->shading, &planes, kind, high_first);
    else if (kind == GLINT_DEVIATION_DIFFUSE)
        glint_draw_diffuse(&spans, deviation, &planes.cosine, 0, high_first);
    else if (kind == GLINT_DEVIATION_GATED)
        glint_draw_diffuse(&spans, deviation, &planes.cosine, 1, high_first);
    else
        glint_draw_highlight(&spans, deviation, &planes, high_first);
}

/** Fast lighting of a format of that byte order. */
#define GLINT_DEFINE_FAST(name, high_first)                                                                \
    static void draw(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,         \
                     const glint_triangle *triangle, const glint_part *part) {                             \
        glint_draw_565(frame, workspace, draw, triangle, part, high_first);                                \
    }                                                                                                      \
    static const glint_fast name = {glint_deviation_serves, glint_deviation_prepare, glint_deviation_need, \
                                    glint_deviation_light, draw}

#endif
