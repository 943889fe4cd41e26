/* SPDX-License-Identifier: MIT */
/** @file quadratic565.h Kernels of exact lighting for pixels of 16 bits, as those of spans565.h are. */
#ifndef GLINT_QUADRATIC565_H
#define GLINT_QUADRATIC565_H

#include "quadratic.h"

/* A quadratic at the tile's first column: in this row, its step to the next row, and to the next column. */
typedef struct glint_stride {
    uint32_t row, down, across;
    uint32_t dxx, dxy, dyy;
} glint_stride;

static inline glint_stride glint_stride_begin(const glint_quadratic *q, int32_t x, int32_t y) {
    const uint32_t i = (uint32_t)x, j = (uint32_t)y;
    const uint32_t across = q->dx + q->dxx * i + q->dxy * j, down = q->dy + q->dxy * i + q->dyy * j;
    const uint32_t row = q->start + q->dx * i + q->dy * j + q->dxy * i * j + q->dxx * (uint32_t)(x * (x - 1) / 2) +
                         q->dyy * (uint32_t)(y * (y - 1) / 2);
    return (glint_stride){row, down, across, q->dxx, q->dxy, q->dyy};
}

static inline void glint_stride_down(glint_stride *s) {
    s->row += s->down;
    s->down += s->dyy;
    s->across += s->dxy;
}

/* Value and step at a column. */
static inline uint32_t glint_stride_at(const glint_stride *s, uint32_t column, uint32_t *step) {
    *step = s->across + s->dxx * column;
    return s->row + s->across * column + s->dxx * (column * (column - 1) / 2);
}

/* Diffuse light; ambient light alone where N.L <= 0. */
static inline void glint_draw_quadratic_diffuse(const glint_spans *s, const glint_deviation *deviation,
                                                const glint_quadratic_light *light, int high_first) {
    const uint16_t *table = deviation->diffuse_pixel, *root = glint_root_table;
    const glint_part *part = s->part;
    const int32_t y = part->y + (int32_t)part->top;
    glint_walk w = glint_walk_begin(&part->depth, part->x, y), a = glint_walk_begin(&light->cosine, part->x, y);
    glint_stride c = glint_stride_begin(&light->square, part->x, y);
    w.row += 1u << 15;
    for (uint32_t row = part->top; row < part->bottom; row++, w.row += w.dy, a.row += a.dy, glint_stride_down(&c)) {
        const glint_span span = part->spans[row];
        const uint32_t offset = (row << s->shift) + span.left;
        uint16_t *depth = s->depth + offset, *end = s->depth + (row << s->shift) + span.right;
        uint8_t *pixel = s->pixels + 2 * offset;
        uint32_t z = w.row + w.dx * span.left, along = a.row + a.dx * span.left, step;
        uint32_t square = glint_stride_at(&c, span.left, &step);
        for (; depth < end; depth++, pixel += 2, z += w.dx, along += a.dx, square += step, step += c.dxx) {
            const uint32_t here = z >> 15;
            if (here <= *depth)
                continue;
            *depth = (uint16_t)here;
            glint_put_565(pixel,
                          (int32_t)along <= 0 ? deviation->ambient : table[(along >> 15) * root[square >> 22] >> 22],
                          high_first);
        }
    }
}

/* Diffuse and specular light. */
static inline void glint_draw_quadratic_specular(const glint_spans *s, const glint_deviation *deviation,
                                                 const glint_quadratic_light *light, int high_first) {
    const uint32_t *diffuse = deviation->diffuse, *specular = deviation->specular;
    const uint16_t *root = glint_root_table;
    const uint32_t limit = deviation->quadratic.limit, shift = deviation->quadratic.shift,
                   last = deviation->quadratic.end;
    const glint_part *part = s->part;
    const int32_t y = part->y + (int32_t)part->top;
    glint_walk w = glint_walk_begin(&part->depth, part->x, y), a = glint_walk_begin(&light->cosine, part->x, y);
    glint_stride c = glint_stride_begin(&light->square, part->x, y);
    glint_stride ex = glint_stride_begin(&light->x, part->x, y), ey = glint_stride_begin(&light->y, part->x, y);
    w.row += 1u << 15;
    for (uint32_t row = part->top; row < part->bottom;
         row++, w.row += w.dy, a.row += a.dy, glint_stride_down(&c), glint_stride_down(&ex), glint_stride_down(&ey)) {
        const glint_span span = part->spans[row];
        const uint32_t offset = (row << s->shift) + span.left;
        uint16_t *depth = s->depth + offset, *end = s->depth + (row << s->shift) + span.right;
        uint8_t *pixel = s->pixels + 2 * offset;
        uint32_t z = w.row + w.dx * span.left, along = a.row + a.dx * span.left, step, x_step, y_step;
        uint32_t square = glint_stride_at(&c, span.left, &step);
        uint32_t x = glint_stride_at(&ex, span.left, &x_step), yy = glint_stride_at(&ey, span.left, &y_step);
        for (; depth < end; depth++, pixel += 2, z += w.dx, along += a.dx, square += step, step += c.dxx, x += x_step,
                            x_step += ex.dxx, yy += y_step, y_step += ey.dxx) {
            const uint32_t here = z >> 15;
            if (here <= *depth)
                continue;
            *depth = (uint16_t)here;
            if ((int32_t)along <= 0) {
                glint_put_565(pixel, deviation->ambient, high_first);
                continue;
            }
            const uint32_t inverse = root[square >> 22];
            uint32_t word = diffuse[(along >> 15) * inverse >> 22];
            const uint32_t x_high = (uint32_t)glint_shift_right((int32_t)x, 15);
            const uint32_t y_high = (uint32_t)glint_shift_right((int32_t)yy, 15);
            uint32_t deviates = x_high * x_high + y_high * y_high;
            if (deviates < limit) {
                deviates = (deviates >> shift) * (inverse * inverse >> 16);
                if (deviates < last)
                    word = glint_spread_clamp(word + specular[deviates >> 20]);
            }
            glint_put_565(pixel, glint_spread_pack(word), high_first);
        }
    }
}

/* The pixel of a fragment, packed, with words that are computed. */
static inline uint32_t glint_quadratic_pixel(const glint_shading *shading, const glint_quadratic_light *light,
                                             int shows, int32_t x, int32_t y) {
    const glint_quadratic_limits *limits = &shading->deviation->quadratic;
    const uint32_t along = (uint32_t)glint_plane_at(&light->cosine, x, y);
    const uint32_t inverse = glint_root_table[glint_stride_begin(&light->square, x, y).row >> 22];
    uint32_t deviates = UINT32_MAX;
    if ((int32_t)along <= 0)
        return shading->deviation->ambient;
    if (shows) {
        const uint32_t x_high = (uint32_t)glint_shift_right((int32_t)glint_stride_begin(&light->x, x, y).row, 15);
        const uint32_t y_high = (uint32_t)glint_shift_right((int32_t)glint_stride_begin(&light->y, x, y).row, 15);
        deviates = x_high * x_high + y_high * y_high;
        deviates = deviates < limits->limit ? (deviates >> limits->shift) * (inverse * inverse >> 16) : UINT32_MAX;
    }
    /* one step is as good as none */
    return glint_deviation_pixel(shading, (int32_t)((along >> 15) * inverse) | 1,
                                 deviates < limits->end ? deviates >> 5 : UINT32_MAX);
}

/* Both, without tables. */
static inline void glint_draw_quadratic_without_tables(const glint_spans *s, const glint_shading *shading,
                                                       const glint_quadratic_light *light, int shows, int high_first) {
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
            glint_put_565(s->pixels + 2 * offset, glint_quadratic_pixel(shading, light, shows, x, y), high_first);
        }
    }
}

static inline void glint_draw_quadratic_kind(const glint_workspace *workspace, const glint_spans *s,
                                             const glint_shading *shading, const glint_quadratic_light *light,
                                             glint_quadratic_kind kind, int high_first) {
    const glint_deviation *deviation = shading->deviation;
    if (workspace->drawn)
        glint_count(workspace, (glint_kernel_name)kind, glint_deviation_covered(s->part));
    if (kind == GLINT_QUADRATIC_AMBIENT)
        glint_draw_constant(s, deviation->ambient, high_first);
    else if (!deviation->diffuse)
        glint_draw_quadratic_without_tables(s, shading, light, kind == GLINT_QUADRATIC_SPECULAR, high_first);
    else if (kind == GLINT_QUADRATIC_DIFFUSE)
        glint_draw_quadratic_diffuse(s, deviation, light, high_first);
    else
        glint_draw_quadratic_specular(s, deviation, light, high_first);
}

/* The part of a triangle that lies in a square, 2^size pixels wide and aligned to the screen. */
static inline void glint_cut_square(glint_part *out, const glint_part *part, const glint_square *square) {
    const int32_t half = 1 << (square->size - 1);
    const int32_t x = square->x - half - glint_shift_right(part->window.left, 4);
    const int32_t y = square->y - half - glint_shift_right(part->window.top, 4);
    *out = *part;
    out->top = (int32_t)part->top > y ? part->top : (uint32_t)y;
    out->bottom = (int32_t)part->bottom < y + 2 * half ? part->bottom : (uint32_t)(y + 2 * half);
    for (uint32_t row = out->top; row < out->bottom; row++) {
        int32_t left = part->spans[row].left, right = part->spans[row].right;
        left = left > x ? left : x;
        right = right < x + 2 * half ? right : x + 2 * half;
        out->spans[row].left = (uint8_t)left;
        out->spans[row].right = (uint8_t)(right > left ? right : left);
    }
}

/* Draws a triangle square by square, where the half vector bends too much all over it. */
static inline void glint_draw_squares(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                      const glint_triangle *triangle, const glint_part *part,
                                      glint_quadratic_light *light, int high_first) {
    const glint_deviation *deviation = draw->shading->deviation;
    const int32_t side = 1 << deviation->quadratic.cell, half = side / 2;
    const int32_t left = glint_shift_right(part->window.left, 4), top = glint_shift_right(part->window.top, 4);
    glint_square square = {0, 0, deviation->quadratic.cell};
    for (square.y = ((top + (int32_t)part->top) & -side) + half; square.y - half < top + (int32_t)part->bottom;
         square.y += side) {
        for (square.x = (left & -side) + half; square.x - half < left + part->window.width; square.x += side) {
            glint_part cut;
            glint_cut_square(&cut, part, &square);
            const glint_spans spans = {&cut, workspace->depth, workspace->pixels, frame->tile_shift_x};
            const glint_quadratic_kind kind = glint_quadratic_bend(deviation, triangle, part, &square, light);
            if (kind == GLINT_QUADRATIC_UNFIT)
                glint_draw_any(frame, workspace, draw, triangle, &cut);
            else
                glint_draw_quadratic_kind(workspace, &spans, draw->shading, light, kind, high_first);
        }
    }
}

/* @return 0 where nothing is drawn: the triangle does not fit */
static inline int glint_draw_quadratic(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                       const glint_triangle *triangle, const glint_part *part, int high_first) {
    const glint_deviation *deviation = draw->shading->deviation;
    const glint_spans spans = {part, workspace->depth, workspace->pixels, frame->tile_shift_x};
    glint_quadratic_light light;
    glint_square square;
    glint_quadratic_kind kind = glint_quadratic_begin(draw, triangle, part, &light);
    if (kind == GLINT_QUADRATIC_UNFIT)
        return 0;
    if (kind == GLINT_QUADRATIC_SPECULAR && deviation->local_viewer) {
        kind = GLINT_QUADRATIC_UNFIT;
        if (glint_quadratic_square(triangle, &square))
            kind = glint_quadratic_bend(deviation, triangle, part, &square, &light);
        if (kind == GLINT_QUADRATIC_UNFIT) {
            glint_draw_squares(frame, workspace, draw, triangle, part, &light, high_first);
            return 1;
        }
    }
    glint_draw_quadratic_kind(workspace, &spans, draw->shading, &light, kind, high_first);
    return 1;
}

#endif
