/* SPDX-License-Identifier: MIT */
/* Types of textures: how texels are stored. */
#include "../pixel/pixel.h"
#include "texture.h"

static inline uint32_t rgb565_at(const void *texels, const uint16_t *palette, uint32_t number) {
    (void)palette;
    return ((const uint16_t *)texels)[number];
}

static inline uint32_t grey8_at(const void *texels, const uint16_t *palette, uint32_t number) {
    (void)palette;
    return ((const uint8_t *)texels)[number];
}

static inline uint32_t nibble_at(const void *texels, const uint16_t *palette, uint32_t number) {
    const uint32_t pair = grey8_at(texels, palette, number >> 1);
    return number & 1 ? pair & 15 : pair >> 4;
}

static inline uint32_t palette256_at(const void *texels, const uint16_t *palette, uint32_t number) {
    return palette[grey8_at(texels, palette, number)];
}

static inline uint32_t palette16_at(const void *texels, const uint16_t *palette, uint32_t number) {
    return palette[nibble_at(texels, palette, number)];
}

/* ---- Between texels ---- */

/* The channels of colours times weights, 2^-10 in all: red and blue in the halves of a word, 5 bits each, and green, 6
 * bits, or grey, 8 bits. */
typedef struct texel_sum {
    uint32_t red_blue, green;
} texel_sum;

/* A square of four texels: the numbers of two columns, and of the first texels of two rows; and a place in it, 5 bits
 * in each direction. */
typedef struct texel_square {
    uint32_t left, right, above, below, across, down;
} texel_square;

/* Returns a mixture of two numbers or packed channels, times 32, by 32nds of the second one. */
static inline uint32_t mix(uint32_t a, uint32_t b, uint32_t part) {
    return (a << 5) + (b - a) * part;
}

/* Returns the channels of a colour so far apart that each has room for 5 bits more: blue, red, green. */
static inline uint32_t spread_texel(uint32_t colour) {
    return (colour | colour << 16) & 0x07e0f81f;
}

/* Returns red and blue of such a mixture, in the halves of a word. */
static inline uint32_t red_blue_of(uint32_t mixed) {
    return (mixed & 0x1ff800) << 5 | (mixed & 0x3ff);
}

/* Finds the sums at a place between four texels. */
static inline texel_sum mix_texels(const texel_square *q, const void *texels, const uint16_t *palette,
                                   glint_read_texel *at, int is_grey) {
    const uint32_t a = at(texels, palette, q->above + q->left), b = at(texels, palette, q->above + q->right),
                   c = at(texels, palette, q->below + q->left), d = at(texels, palette, q->below + q->right);
    if (is_grey)
        return (texel_sum){0, mix(mix(a, b, q->across), mix(c, d, q->across), q->down)};
    const uint32_t above = mix(spread_texel(a), spread_texel(b), q->across),
                   below = mix(spread_texel(c), spread_texel(d), q->across);
    return (texel_sum){mix(red_blue_of(above), red_blue_of(below), q->down), mix(above >> 21, below >> 21, q->down)};
}

/* The middle of a texel, less half of the last bit of a place, 2^-8. */
#define MIDDLE 124

/* Finds a colour by up to four texels, which are words of RGB565, or of grey. */
static GLINT_SPECIAL void sample_texels(const glint_texture_map *map, uint32_t u, uint32_t v, int16_t colour[3],
                                        glint_read_texel *at, int is_grey) {
    const void *const texels = map->texture->texels;
    const uint16_t *const palette = map->texture->palette;
    int32_t x = glint_texel_position(map, 0, u), y = glint_texel_position(map, 1, v);
    texel_sum sum;
    if (map->is_bilinear) {
        x -= MIDDLE, y -= MIDDLE;
        const int32_t column = glint_shift_right(x, 8), row = glint_shift_right(y, 8);
        const texel_square q = {glint_texel_column(map, column), glint_texel_column(map, column + 1),
                                glint_texel_row(map, row),       glint_texel_row(map, row + 1),
                                (uint32_t)x >> 3 & 31,           (uint32_t)y >> 3 & 31};
        sum = mix_texels(&q, texels, palette, at, is_grey);
    } else {
        const uint32_t texel =
            at(texels, palette,
               glint_texel_column(map, glint_shift_right(x, 8)) + glint_texel_row(map, glint_shift_right(y, 8)));
        sum = is_grey ? (texel_sum){0, texel << 10}
                      : (texel_sum){(texel & 0xf800) << 15 | (texel & 31) << 10, (texel >> 5 & 63) << 10};
    }
    if (is_grey) {
        colour[0] = colour[1] = colour[2] = (int16_t)(sum.green * 257 >> 11);
    } else {
        colour[0] = (int16_t)((sum.red_blue >> 16) * 1057 >> 10);
        colour[1] = (int16_t)(sum.green * 33288 >> 16);
        colour[2] = (int16_t)((sum.red_blue & 0xffff) * 1057 >> 10);
    }
}

/* ---- Spans of RGB565 ---- */

/* A colour's levels, 5, 6 and 5 bits, times 2^bits. */
typedef struct texel_levels {
    uint32_t red, green, blue;
} texel_levels;

static inline texel_levels levels_of_texel(uint32_t colour) {
    return (texel_levels){colour >> 11, colour >> 5 & 63, colour & 31};
}
#define MIXED_BITS 5 /* of sums of four texels */
static inline texel_levels levels_of_sum(const texel_sum *sum) {
    return (texel_levels){sum->red_blue >> (26 - MIXED_BITS), sum->green >> (10 - MIXED_BITS),
                          (sum->red_blue & 0xffff) >> (10 - MIXED_BITS)};
}

/* Multiply a channel by light, and add highlights: lanes have half of both and a margin. Neither exceeds `most`. */
static inline uint32_t shade_channel(uint32_t level, uint32_t light, unsigned bits) {
    return (uint32_t)((int32_t)level * (int32_t)(light - 2 * GLINT_WORN_MARGIN) + (1 << (14 + bits))) >> (15 + bits);
}
static inline uint32_t glow_channel(uint32_t level, uint32_t light, uint32_t gloss, int32_t most, unsigned bits) {
    const int32_t margin = 2 * GLINT_WORN_MARGIN, sum = (int32_t)level * ((int32_t)light - margin) +
                                                        (most << bits) * ((int32_t)gloss - margin) + (1 << (14 + bits));
    return (uint32_t)glint_least(glint_most(glint_shift_right(sum, 15 + bits), 0), most);
}

/* Reads a number at each pixel that would take a register from one that is used more often. */
static inline uint32_t read_in_loop(const uint32_t *from) {
    return *(const volatile uint32_t *)from;
}

/* The light and the highlights of a pixel step from column to column. */
typedef struct span_light {
    glint_lanes light, gloss;
} span_light;

/* Finds the sums at coordinates, less MIDDLE, of a texture that repeats. */
static inline texel_sum mix_repeated(const glint_texture_map *map, const void *texels, const uint16_t *palette,
                                     uint32_t last, uint32_t u, uint32_t v, glint_read_texel *at) {
    const uint32_t left = u >> map->across & last, above = v >> map->down & map->rows;
    const texel_square q = {left,
                            (left + 1) & last,
                            above,
                            (above + last + 1) & map->rows,
                            u >> (map->to_texels[0] + 3) & 31,
                            v >> (map->to_texels[1] + 3) & 31};
    return mix_texels(&q, texels, palette, at, 0);
}

/* Returns a colour in light. */
static inline uint32_t light_levels(const texel_levels *c, const span_light *l, int kind, unsigned bits) {
    if (kind == TEXELS_UNLIT) {
        const uint32_t half = 1u << bits >> 1;
        return (c->red + half) >> bits << 11 | (c->green + half) >> bits << 5 | (c->blue + half) >> bits;
    }
    if (kind == TEXELS_SHADED)
        return shade_channel(c->red, l->light.red_blue & 0xffff, bits) << 11 |
               shade_channel(c->green, l->light.green >> 16, bits) << 5 |
               shade_channel(c->blue, l->light.red_blue >> 16, bits);
    return glow_channel(c->red, l->light.red_blue & 0xffff, l->gloss.red_blue & 0xffff, 31, bits) << 11 |
           glow_channel(c->green, l->light.green >> 16, l->gloss.green >> 16, 63, bits) << 5 |
           glow_channel(c->blue, l->light.red_blue >> 16, l->gloss.red_blue >> 16, 31, bits);
}

/* Draws a run of RGB565 from texels of a type that has such colours. */
static GLINT_INLINE void draw_texel_run(const glint_row_walk *walk, uint16_t *depth, const uint16_t *end, uint32_t z,
                                        span_light *l, glint_read_texel *at, int swaps, int kind, int is_bent,
                                        int is_mixed) {
    const glint_texture_map *const map = walk->map;
    const void *const texels = map->texture->texels;
    const uint16_t *const palette = map->texture->palette;
    const uintptr_t from_depth = (uintptr_t)walk->pixels - (uintptr_t)walk->depth;
    const uint32_t dz = (uint32_t)walk->z.dx, last = map->texture->width - 1u;
    glint_stepped_quadratic u = map->at[0], v = map->at[1];
    if (is_mixed) {
        u.value -= (uint32_t)MIDDLE << map->to_texels[0];
        v.value -= (uint32_t)MIDDLE << map->to_texels[1];
    }
    do {
        uint32_t here = z >> 15;
        GLINT_OPAQUE(here); /* else compilers compute it twice */
        if (here > *depth) {
            uint32_t colour;
            if (is_mixed) {
                const texel_sum sum = mix_repeated(map, texels, palette, last, u.value, v.value, at);
                const texel_levels levels = levels_of_sum(&sum);
                colour = light_levels(&levels, l, kind, MIXED_BITS);
            } else {
                colour = at(texels, palette, glint_texel_number(map, u.value, v.value));
                if (kind != TEXELS_UNLIT) {
                    const texel_levels levels = levels_of_texel(colour);
                    colour = light_levels(&levels, l, kind, 0);
                }
            }
            *depth = (uint16_t)here;
            *(uint16_t *)((uintptr_t)depth + from_depth) = (uint16_t)(swaps ? glint_to_high_first(colour) : colour);
        }
        z += dz;
        glint_step_quadratic(&u, is_bent ? read_in_loop(&map->bend[0]) : 0);
        glint_step_quadratic(&v, is_bent ? read_in_loop(&map->bend[1]) : 0);
        if (kind != TEXELS_UNLIT) {
            l->light.red_blue += walk->lanes[1].red_blue;
            l->light.green += walk->lanes[1].green;
        }
        if (kind == TEXELS_GLOWING) {
            l->gloss.red_blue += walk->gloss[1].red_blue;
            l->gloss.green += walk->gloss[1].green;
        }
    } while (++depth != end);
}

/* Draws a span. */
static GLINT_INLINE void draw_any_span(const glint_row_walk *walk, int32_t row, int32_t left, int32_t right,
                                       glint_read_texel *at, int swaps, int kind, int is_mixed) {
    glint_texture_map *const map = walk->map;
    uint16_t *depth = walk->depth + ((uint32_t)row << walk->shift) + left;
    span_light l = {{0, 0}, {0, 0}};
    if (kind != TEXELS_UNLIT)
        l.light = glint_lanes_at(walk, row, left);
    if (kind == TEXELS_GLOWING)
        l.gloss = glint_gloss_at(walk, left);
    do {
        glint_find_coordinates(map, row, left);
        const uint32_t z = glint_z_at(walk, row, left);
        const int32_t stop = glint_least(map->right, right);
        uint16_t *const end = depth + (stop - left);
        left = stop;
        if (kind == TEXELS_UNLIT && !is_mixed && !GLINT_SMALL && !(map->bend[0] | map->bend[1]))
            draw_texel_run(walk, depth, end, z, &l, at, swaps, kind, 0, 0);
        else
            draw_texel_run(walk, depth, end, z, &l, at, swaps, kind, 1, is_mixed);
        depth = end;
    } while (left < right);
}

/* Draws a span of nearest texels. */
static GLINT_SPECIAL void draw_texel_span(const glint_row_walk *walk, int32_t row, int32_t left, int32_t right,
                                          glint_read_texel *at, int swaps, int kind) {
    draw_any_span(walk, row, left, right, at, swaps, kind, 0);
}

/* Draws a span between texels. Its pixels take so long that one function draws all kinds. */
static GLINT_SPECIAL void draw_mixed_span(const glint_row_walk *walk, int32_t row, int32_t left, int32_t right,
                                          glint_read_texel *at) {
    draw_any_span(walk, row, left, right, at, walk->map->swaps, walk->map->kind, 1);
}

/* Multiplies a word by a texel. */
static inline uint32_t multiply_word(uint32_t word, uint32_t texel) {
    const uint32_t red = (word >> 10 & 0x3ff) * (texel >> 11), green = (word >> 21) * (texel >> 5 & 63),
                   blue = (word & 0x1ff) * (texel & 31);
    return ((red * 1057 + (1u << 14)) >> 15 << 10) + ((green * 33288 + (1u << 20)) >> 21 << 21) +
           ((blue * 1057 + (1u << 14)) >> 15);
}

#if !GLINT_SMALL
/* Returns the word of a texel's fragment, given N'.L, N'.N' and N'.H, as sun_spans.c finds it: `dark` is without half a
 * level. */
static inline uint32_t light_texel(const glint_sun_triangle *t, uint32_t texel, uint32_t dark, uint32_t half_level,
                                   uint32_t light, uint32_t square, uint32_t half) {
    if ((int32_t)light <= 0)
        return multiply_word(dark, texel) + half_level;
    const uint32_t over = glint_over_normal(square),
                   word =
                       multiply_word(glint_clamp_word(dark + t->ramp[(light >> 14) * over >> 20]), texel) + half_level;
    if (!t->gloss)
        return word;
    const int32_t h = glint_shift_right((int32_t)half, 12);
    const uint32_t sine = square - (uint32_t)h * (uint32_t)h,
                   entry = sine >= GLINT_SINE_WRAPPED ? 0 : ((sine >> 16) * over >> 14) * over >> t->shift;
    return entry < GLINT_GLOSS_ENTRIES ? glint_clamp_word(word + t->gloss[entry]) : word;
}

/* Draws a span of RGB565 under one sun from texels of a type that has such colours. */
static GLINT_SPECIAL void draw_sun_span(const glint_row_walk *walk, int32_t row, int32_t left, int32_t right,
                                        glint_read_texel *at, int swaps) {
    const glint_sun_triangle *t = walk->suns;
    glint_texture_map *const map = walk->map;
    const void *const texels = map->texture->texels;
    const uint16_t *const palette = map->texture->palette;
    const uint32_t x = (uint32_t)(left - walk->slopes.column), y = (uint32_t)(row - walk->slopes.row);
    uint32_t z = glint_z_at(walk, row, left), light = t->lit->light.value + x * t->lit->light.x + y * t->lit->light.y;
    glint_stepped_quadratic square = glint_begin_quadratic(&t->normal, x, y), half = {0, 0};
    uint16_t *depth = walk->depth + ((uint32_t)row << walk->shift) + left;
    const uint32_t half_level = t->suns->half_level, dark = t->dark - half_level;
    if (t->gloss)
        half = glint_begin_quadratic(&t->lit->half, x, y);
    do {
        glint_find_coordinates(map, row, left);
        glint_stepped_quadratic u = map->at[0], v = map->at[1];
        const int32_t stop = glint_least(map->right, right);
        const uint16_t *const end = depth + (stop - left);
        left = stop;
        do {
            uint32_t here = z >> 15;
            GLINT_OPAQUE(here); /* else compilers compute it twice */
            if (here > *depth) {
                *depth = (uint16_t)here;
                const uint32_t texel = at(texels, palette, glint_texel_number(map, u.value, v.value)),
                               packed = glint_spread_pack(
                                   light_texel(t, texel, dark, half_level, light, square.value, half.value));
                *(uint16_t *)((uintptr_t)depth + t->from_depth) =
                    (uint16_t)(swaps ? glint_to_high_first(packed & 0xffff) : packed);
            }
            z += t->z_dx;
            light += t->light_dx;
            glint_step_quadratic(&square, t->square_bend);
            glint_step_quadratic(&half, t->half_bend);
            glint_step_quadratic(&u, map->bend[0]);
            glint_step_quadratic(&v, map->bend[1]);
        } while (++depth != end);
    } while (left < right);
}
#endif

/* Multiplies words by texels of a type that has colours of RGB565. */
static GLINT_SPECIAL void multiply_by(const glint_row_walk *walk, int32_t row, uint32_t begin, glint_spread *p,
                                      const glint_spread *end, glint_read_texel *at) {
    glint_texture_map *map = walk->map;
    const void *const texels = map->texture->texels;
    const uint16_t *const palette = map->texture->palette;
    const uint32_t half_level = walk->draw->extra ? 0 : walk->suns->suns->half_level;
    while (p != end) {
        const int32_t column = (int32_t)(p->offset - begin);
        glint_check_run(map, row, column);
        const glint_texture_run u = map->run[0], v = map->run[1];
        const uint32_t origin = begin + (uint32_t)map->origin, count = (uint32_t)(map->right - column),
                       first = p->offset;
        do {
            const uint32_t x = p->offset - origin,
                           number = glint_texel_number(map, glint_coordinate_at(&u, x), glint_coordinate_at(&v, x)),
                           colour = at(texels, palette, number);
            p->colour = multiply_word(p->colour, colour) + half_level;
        } while (++p != end && p->offset - first < count);
    }
}

#define DEFINE_SAMPLE(type, is_grey)                                                                     \
    static void sample_##type(const glint_texture_map *map, uint32_t u, uint32_t v, int16_t colour[3]) { \
        sample_texels(map, u, v, colour, type##_at, is_grey);                                            \
    }

DEFINE_SAMPLE(rgb565, 0)
DEFINE_SAMPLE(palette256, 0)
DEFINE_SAMPLE(palette16, 0)
DEFINE_SAMPLE(grey8, 1)

#define DEFINE_MULTIPLY(type)                                                                                       \
    static GLINT_HOT void multiply_##type(const glint_row_walk *walk, int32_t row, uint32_t begin, glint_spread *p, \
                                          const glint_spread *end) {                                                \
        multiply_by(walk, row, begin, p, end, type##_at);                                                           \
    }

DEFINE_MULTIPLY(rgb565)
DEFINE_MULTIPLY(palette256)
DEFINE_MULTIPLY(palette16)

#define DEFINE_DRAW(name, type, swaps, kind)                                                              \
    static GLINT_HOT void name##_##type(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) { \
        draw_texel_span(walk, row, left, right, type##_at, swaps, kind);                                  \
    }
#define DEFINE_DRAWS(type)                                                                             \
    DEFINE_DRAW(draw, type, 0, TEXELS_UNLIT)                                                           \
    DEFINE_DRAW(draw_be, type, 1, TEXELS_UNLIT)                                                        \
    DEFINE_DRAW(shade, type, 0, TEXELS_SHADED)                                                         \
    DEFINE_DRAW(shade_be, type, 1, TEXELS_SHADED)                                                      \
    DEFINE_DRAW(glow, type, 0, TEXELS_GLOWING)                                                         \
    DEFINE_DRAW(glow_be, type, 1, TEXELS_GLOWING)                                                      \
    static GLINT_HOT void mix_##type(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) { \
        draw_mixed_span(walk, row, left, right, type##_at);                                            \
    }

DEFINE_DRAWS(rgb565)
DEFINE_DRAWS(palette256)
DEFINE_DRAWS(palette16)

#if GLINT_SMALL
#define SUN_SPANS(type)
#else
#define SUN_SPANS(type) .sun = {sun_##type, sun_be_##type},
#define DEFINE_SUN(name, type, swaps)                                                                     \
    static GLINT_HOT void name##_##type(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) { \
        draw_sun_span(walk, row, left, right, type##_at, swaps);                                          \
    }
DEFINE_SUN(sun, rgb565, 0)
DEFINE_SUN(sun_be, rgb565, 1)
DEFINE_SUN(sun, palette256, 0)
DEFINE_SUN(sun_be, palette256, 1)
DEFINE_SUN(sun, palette16, 0)
DEFINE_SUN(sun_be, palette16, 1)
#endif

#define DEFINE_TYPE(type, stored, has, reads)                                                                     \
    const glint_texture_type glint_texture_##type = {                                                             \
        .bits = (stored),                                                                                         \
        .has_palette = (has),                                                                                     \
        .read = (reads),                                                                                          \
        .sample = sample_##type,                                                                                  \
        .spans = {{draw_##type, draw_be_##type}, {shade_##type, shade_be_##type}, {glow_##type, glow_be_##type}}, \
        .mixed = mix_##type,                                                                                      \
        SUN_SPANS(type).multiply = multiply_##type,                                                               \
        .stage = &glint_textures}

DEFINE_TYPE(rgb565, 16, 0, rgb565_at);
DEFINE_TYPE(palette256, 8, 1, grey8_at);
DEFINE_TYPE(palette16, 4, 1, nibble_at);
const glint_texture_type glint_texture_grey8 = {
    .bits = 8, .read = grey8_at, .sample = sample_grey8, .stage = &glint_textures};
