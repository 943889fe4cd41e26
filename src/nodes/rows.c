/* SPDX-License-Identifier: MIT */
/* Rows: the depth test and sums of a region's terms in one loop, then term by term what else they make of its runs. */
#include "rows.h"

#include "../pixel/pixel.h"

/* ---- Sums ---- */

/*
 * What rows of a part begin with: depth, and sums of light over |M|, or not. Sums of one chroma are kept as two numbers
 * of a pixel, of light and of gloss, until rows are mixed, and 1 / |M| as a third; of three channels they are colours,
 * to which `base` is added.
 */
typedef struct row_sums {
    const glint_part *part;
    const glint_quadratic *sum, *square;
    int32_t base[3];
    uint16_t *depth; /* of the tile */
    unsigned shift;  /* binary logarithm of its width */
} row_sums;

/* M.M, Q30, that 1 / |M| is known from: GLINT_LEAST_SQUARE keeps it, as rounded, above. */
#define LEAST_LENGTH_SQUARE (1u << 28)

/* 1 / |M|, Q15, of M.M less its least; the longest is 1, but for rounding. */
static inline uint32_t inverse_of(uint32_t square) {
    const uint32_t entry = square >> 20;
    return glint_root_table[entry < 768 ? entry : 767];
}

/* A base and a sum times 1 / |M|. */
static inline int32_t over_length(uint32_t sum, int32_t base, uint32_t over) {
    return base + glint_shift_right((int32_t)sum, 14) * (int32_t)(over >> 1);
}

/* A visible pixel on its way: its depth, and where its numbers go. */
typedef struct row_pixel {
    uint16_t *depth;
    uint32_t z; /* 1/w, with GLINT_DEPTH_BIAS */
    int32_t (*row)[3];
    uint16_t *inverse;
} row_pixel;

/* Channel by channel: over lengths, all three at once take more registers than there are. */
static GLINT_INLINE void part_channels(int is_over) {
    if (is_over)
        GLINT_BARRIER();
}

/* Begins a run at a pixel that is visible, i, j from the anchor, up to `right` or a pixel that is not. */
static GLINT_INLINE void begin_run_inline(const row_sums *of, int32_t i, int32_t j, const uint16_t *right,
                                          row_pixel *at, int is_chroma, int is_over) {
    const uint32_t z_dx = (uint32_t)of->part->depth.dx;
    glint_progress one = glint_progress_begin(&of->sum[0], i, j), square = {0, 0, 0}, two = square, three = square;
    if (is_over) {
        square = glint_progress_begin(of->square, i, j);
        square.value -= LEAST_LENGTH_SQUARE;
    }
    if (!is_chroma) {
        part_channels(is_over);
        two = glint_progress_begin(&of->sum[1], i, j);
        part_channels(is_over);
        three = glint_progress_begin(&of->sum[2], i, j);
    }
    if (!is_chroma && !is_over) {
        /* NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): sums are 1 or 3, and of 3 the base is found */
        one.value += (uint32_t)of->base[0];
        two.value += (uint32_t)of->base[1];
        three.value += (uint32_t)of->base[2];
    }
    uint16_t *depth = at->depth, *inverse = at->inverse;
    uint32_t z = at->z;
    int32_t(*row)[3] = at->row;
    do {
        const uint32_t over = is_over ? inverse_of(square.value) : 0;
        if (is_over)
            glint_progress_next(&square);
        *depth++ = (uint16_t)(z >> 15);
        z += z_dx;
        if (is_chroma) {
            const int32_t amount = glint_shift_right((int32_t)one.value, 16);
            (*row)[0] = is_over ? glint_shift_right(amount * (int32_t)over, 15) : amount;
            (*row)[1] = 0;
            if (is_over)
                (*row)[2] = (int32_t)over;
        } else {
            if (is_over)
                *inverse++ = (uint16_t)over;
            part_channels(is_over);
            /* NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): as above */
            (*row)[0] = is_over ? over_length(one.value, of->base[0], over) : (int32_t)one.value;
            part_channels(is_over);
            (*row)[1] = is_over ? over_length(two.value, of->base[1], over) : (int32_t)two.value;
            glint_progress_next(&two);
            part_channels(is_over);
            (*row)[2] = is_over ? over_length(three.value, of->base[2], over) : (int32_t)three.value;
            glint_progress_next(&three);
        }
        glint_progress_next(&one);
        row++;
        GLINT_OPAQUE(row); /* else a second pointer runs beside it */
    } while (depth < right && z >> 15 > *depth);
    *at = (row_pixel){depth, z, row, inverse};
}

/*
 * Begins rows of a part from row *y on, as many as two rows of the tile have room for: tests and stores depth, sets
 * sums and 1 / |M| of pixels that are visible; `is_chroma` and `is_over` are constants where this is inlined.
 * @return the runs' end
 */
static GLINT_INLINE glint_run *begin_rows_inline(const row_sums *of, uint32_t *y, glint_run *run, int32_t (*row)[3],
                                                 uint16_t *inverse, int is_chroma, int is_over) {
    const glint_part *part = of->part;
    const uint32_t z_dx = (uint32_t)part->depth.dx, z_dy = (uint32_t)part->depth.dy, bottom = part->bottom;
    uint32_t j = *y, room = 2u << of->shift; /* pixels */
    uint32_t z_row = (uint32_t)glint_plane_at(&part->depth, part->x, part->y + (int32_t)j) + GLINT_DEPTH_BIAS;
    uint16_t *line = of->depth + (j << of->shift);
    row_pixel at = {.row = row};
    at.inverse = inverse;
    do {
        const glint_span span = part->spans[j];
        const uint16_t *const right = line + span.right;
        at.depth = line + span.left;
        at.z = z_row + z_dx * span.left;
        if ((uint32_t)span.right - span.left > room)
            break;
        while (at.depth < right) {
            if (at.z >> 15 <= *at.depth) {
                at.z += z_dx;
                at.depth++;
                continue;
            }
            const uint32_t first = (uint32_t)(at.depth - line);
            begin_run_inline(of, part->x + (int32_t)first, part->y + (int32_t)j, right, &at, is_chroma, is_over);
            const uint32_t count = (uint32_t)(at.depth - line) - first;
            *run++ = (glint_run){(uint8_t)first, (uint8_t)j, (uint8_t)count};
            room -= count;
        }
        line += 1u << of->shift;
        z_row += z_dy;
    } while (++j < bottom);
    *y = j;
    return run;
}

static GLINT_NOINLINE glint_run *begin_chroma(const row_sums *of, uint32_t *y, glint_run *run, int32_t (*row)[3]) {
    return begin_rows_inline(of, y, run, row, 0, 1, 0);
}

static GLINT_NOINLINE glint_run *begin_chroma_over(const row_sums *of, uint32_t *y, glint_run *run, int32_t (*row)[3]) {
    return begin_rows_inline(of, y, run, row, 0, 1, 1);
}

static GLINT_NOINLINE glint_run *begin_channels(const row_sums *of, uint32_t *y, glint_run *run, int32_t (*row)[3]) {
    return begin_rows_inline(of, y, run, row, 0, 0, 0);
}

static GLINT_NOINLINE glint_run *begin_channels_over(const row_sums *of, uint32_t *y, glint_run *run, int32_t (*row)[3],
                                                     uint16_t *inverse) {
    return begin_rows_inline(of, y, run, row, inverse, 0, 1);
}

/* Begins rows. @return the runs' end */
static glint_run *begin_rows(const glint_terms *terms, const row_sums *of, uint32_t *y, glint_run *run,
                             int32_t (*row)[3], uint16_t *inverse) {
    const int is_chroma = terms->sums == 1, is_over = terms->is_over_length;
    if (GLINT_SMALL)
        return begin_rows_inline(of, y, run, row, inverse, is_chroma, is_over);
    if (is_over)
        return is_chroma ? begin_chroma_over(of, y, run, row) : begin_channels_over(of, y, run, row, inverse);
    return is_chroma ? begin_chroma(of, y, run, row) : begin_channels(of, y, run, row);
}

/* What is added to sums of channels: half a level and ambient light, unless sums or what follows has them. */
static void find_base(const glint_terms *terms, int32_t base[3]) {
    const glint_light_terms *light = terms->light;
    for (int c = 0; c < 3; c++) {
        base[c] = terms->has_surface || (terms->is_channels && !terms->is_over_length) ? 0 : light->half[c];
        base[c] += terms->is_channels || terms->takes_largest ? 0 : light->ambient[c];
    }
}

/* ---- Surfaces ---- */

/* A channel times that of the surface, which goes to the next pixel. */
static inline int32_t times_surface(int32_t channel, glint_progress *surface) {
    const int32_t by = glint_shift_right((int32_t)surface->value, 18);
    glint_progress_next(surface);
    return glint_shift_right(channel, 12) * by;
}

/* One channel of what is below. */
static inline void take_channel(int32_t *colour, glint_progress *surface, int32_t ambient, int32_t half, int is_least) {
    const int32_t value = times_surface(is_least ? ambient : *colour, surface) + half;
    *colour = is_least ? glint_most(*colour, value) : value;
}

/* Multiplies what there is by the surface's colours, or makes it no less than ambient light times these, and half a
 * level; `is_least` is a constant where this is inlined. */
static GLINT_INLINE void take_surface_inline(const glint_light_terms *light, const glint_quadratic surface[3],
                                             const glint_pixel_runs *to, int is_least) {
    int32_t(*row)[3] = to->row;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress red = glint_run_start(&surface[0], run, to), green = glint_run_start(&surface[1], run, to),
                       blue = glint_run_start(&surface[2], run, to);
        for (uint32_t n = run->count; n; n--, row++) {
            take_channel(&(*row)[0], &red, light->ambient[0], light->half[0], is_least);
            take_channel(&(*row)[1], &green, light->ambient[1], light->half[1], is_least);
            take_channel(&(*row)[2], &blue, light->ambient[2], light->half[2], is_least);
        }
    }
}

static void take_surface(const glint_light_terms *light, const glint_quadratic surface[3], const glint_pixel_runs *to,
                         int is_least) {
    if (GLINT_SMALL)
        take_surface_inline(light, surface, to, is_least);
    else if (is_least)
        take_surface_inline(light, surface, to, 1);
    else
        take_surface_inline(light, surface, to, 0);
}

/* Makes a colour no less than it is. */
static inline void raise_to(int32_t *colour, int32_t least) {
    *colour = glint_most(*colour, least);
}

/* Makes colours no less than ambient light. */
static void raise_row(const glint_light_terms *light, const glint_pixel_runs *to) {
    const int32_t red = light->ambient[0] + light->half[0], green = light->ambient[1] + light->half[1],
                  blue = light->ambient[2] + light->half[2];
    int32_t(*row)[3] = to->row;
    for (const glint_run *run = to->runs; run != to->end; run++)
        for (uint32_t n = run->count; n; n--, row++) {
            raise_to(&(*row)[0], red);
            raise_to(&(*row)[1], green);
            raise_to(&(*row)[2], blue);
        }
}

/* ---- Mixtures ---- */

/* Mixes colours of rows. */
static void mix_rows(const glint_mix *mix, const glint_pixel_runs *to) {
    int32_t(*row)[3] = to->row;
    for (const glint_run *run = to->runs; run != to->end; run++)
        for (uint32_t n = run->count; n; n--, row++) {
            const int32_t number[3] = {(*row)[0], (*row)[1], 0};
            for (int c = 0; c < 3; c++)
                (*row)[c] = glint_mix_channel(mix, c, number, 1, mix->has_least);
        }
}

/* Mixes colours of rows, light multiplied by the surface's colours. */
static void mix_with_surface(const glint_mix *mix, const int32_t half[3], const glint_quadratic surface[3],
                             const glint_pixel_runs *to) {
    const int32_t base[3] = {mix->base[0] - half[0], mix->base[1] - half[1], mix->base[2] - half[2]};
    int32_t(*row)[3] = to->row;
    for (const glint_run *run = to->runs; run != to->end; run++) {
        glint_progress red = glint_run_start(&surface[0], run, to), green = glint_run_start(&surface[1], run, to),
                       blue = glint_run_start(&surface[2], run, to);
        for (uint32_t n = run->count; n; n--, row++) {
            const int32_t light = (*row)[0], gloss = (*row)[1];
            (*row)[0] = times_surface(base[0] + light * mix->light[0], &red) + half[0] + gloss * mix->gloss[0];
            (*row)[1] = times_surface(base[1] + light * mix->light[1], &green) + half[1] + gloss * mix->gloss[1];
            (*row)[2] = times_surface(base[2] + light * mix->light[2], &blue) + half[2] + gloss * mix->gloss[2];
        }
    }
}

/* ---- Rows ---- */

/* Rows on their way to pixels. */
typedef struct rows_of {
    const glint_frame *frame;
    glint_workspace *workspace;
    const glint_terms *terms;
    const glint_quadratic *polynomials;
} rows_of;

static void add_sides(const rows_of *of, const glint_pixel_runs *to) {
    const glint_terms *terms = of->terms;
    for (const glint_apart *a = terms->apart; a != terms->apart + terms->apart_count; a++)
        if (a->kinds >> GLINT_SIDE & 1)
            glint_row_add_side(terms, a, of->polynomials, to);
}

/* Adds highlights. @return are there any? */
static int add_lobes(const rows_of *of, const glint_pixel_runs *to) {
    const glint_terms *terms = of->terms;
    int has_gloss = 0;
    for (const glint_apart *a = terms->apart; a != terms->apart + terms->apart_count; a++)
        if (a->kinds >> GLINT_LOBE_X & 1) {
            glint_row_add_lobe(terms, a, of->polynomials, to);
            has_gloss = 1;
        }
    return has_gloss;
}

/* Stores colours of runs. */
static void store_rows(const rows_of *of, const glint_pixel_runs *to) {
    const glint_config *config = &of->frame->config;
    uint32_t count = 0;
    for (const glint_run *run = to->runs; config->gamma && run != to->end; run++)
        count += run->count;
    if (config->gamma)
        glint_finish_colours(config, to->row, count);
    config->format->store(of->workspace->pixels, of->frame->tile_shift_x, to->runs, to->end,
                          (const int32_t(*)[3])to->row);
}

/* Draws runs whose sums are of one chroma. */
static void draw_chroma(const rows_of *of, const glint_pixel_runs *to) {
    const glint_terms *terms = of->terms;
    const glint_light_terms *light = terms->light;
    const glint_config *config = &of->frame->config;
    add_sides(of, to);
    const int has_gloss = add_lobes(of, to);
    if (!GLINT_SMALL && config->format->store_mixed && !terms->has_surface && !config->gamma) {
        config->format->store_mixed(of->workspace->pixels, of->frame->tile_shift_x, to->runs, to->end, &light->mix,
                                    has_gloss, (const int32_t(*)[3])to->row);
        return;
    }
    if (terms->has_surface)
        mix_with_surface(&light->mix, light->half, of->polynomials + terms->surface, to);
    else
        mix_rows(&light->mix, to);
    if (terms->takes_largest && terms->has_surface)
        take_surface(light, of->polynomials + terms->surface, to, 1);
    store_rows(of, to);
}

/* Draws runs whose sums are three channels. */
static void draw_channels(const rows_of *of, const glint_pixel_runs *to) {
    const glint_terms *terms = of->terms;
    const glint_light_terms *light = terms->light;
    add_sides(of, to);
    if (terms->has_surface)
        take_surface(light, of->polynomials + terms->surface, to, 0);
    add_lobes(of, to);
    if (terms->takes_largest && terms->has_surface)
        take_surface(light, of->polynomials + terms->surface, to, 1);
    else if (terms->takes_largest)
        raise_row(light, to);
    store_rows(of, to);
}

/* Draws rows of a part from row *y on, as many as workspace->row has room for, and moves *y behind them.
 * @param runs what of them is visible @return their end */
static GLINT_NOINLINE const glint_run *draw_rows(const glint_frame *frame, glint_workspace *workspace,
                                                 const glint_terms *terms, const glint_quadratic *polynomials,
                                                 const glint_part *part, uint32_t *y,
                                                 glint_run runs[GLINT_BATCH_RUNS]) {
    uint16_t inverse[2 * GLINT_TILE_MAX];
    const rows_of of = {frame, workspace, terms, polynomials};
    row_sums sums;
    sums.part = part;
    sums.sum = polynomials;
    sums.square = &polynomials[terms->square];
    sums.depth = workspace->depth;
    sums.shift = frame->tile_shift_x;
    if (terms->sums > 1)
        find_base(terms, sums.base);
    const glint_run *const end = begin_rows(terms, &sums, y, runs, workspace->row, inverse);
    const glint_pixel_runs to = {runs, end, part->x, part->y, terms->is_over_length ? inverse : 0, workspace->row};
    if (terms->sums == 1)
        draw_chroma(&of, &to);
    else
        draw_channels(&of, &to);
    return end;
}

/* ---- Parts ---- */

/* Draws a part by the format's own loop. */
static void draw_fused(const glint_frame *frame, const glint_workspace *workspace, const glint_part *part,
                       const glint_terms *terms, const glint_polynomials *polynomials) {
    const glint_spans spans = glint_spans_of(frame, workspace, part);
    const glint_format *format = frame->config.format;
    if (terms->sums == 1)
        format->draw_mixed(&spans, polynomials->of, &terms->light->mix);
    else
        format->draw_channels(&spans, polynomials->of, terms->is_curved);
}

void glint_terms_draw_part(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part, const glint_terms *terms,
                           const glint_polynomials *polynomials) {
    glint_run runs[GLINT_BATCH_RUNS];
    if (!GLINT_SMALL && terms->is_fused) {
        draw_fused(frame, workspace, part, terms, polynomials);
        return;
    }
    for (uint32_t y = part->top; y < part->bottom;) {
        const glint_run *const end = draw_rows(frame, workspace, terms, polynomials->of, part, &y, runs);
        if (terms->margin)
            glint_draw_edges(frame, workspace, draw, triangle, part, terms, polynomials->of, runs, end);
    }
}
