/* SPDX-License-Identifier: MIT */
/* Draws triangles that wear a texture, and finds the texture's colours for those that are lit at fragments. */
#include "../light/evaluation.h"
#include "../pixel/pixel.h"
#include "../raster/small.h"
#include "texture.h"

/* ---- Checks ---- */

static int is_texture_size(uint32_t size) {
    return size >= 1 && size <= 1024 && (size & (size - 1)) == 0;
}

/* Checks the levels of a texture. As each is half as large, there are at most eleven. */
static glint_status check_levels(const glint_texture *level) {
    const glint_texture_type *type = level->type;
    for (const glint_texture *larger = 0; level; larger = level, level = level->smaller) {
        if (!level->texels || (type->has_palette && !level->palette))
            return GLINT_ERROR_NULL;
        if (level->flags > GLINT_TEXTURE_HAS_KEY)
            return GLINT_ERROR_FLAGS;
        if (!is_texture_size(level->width) || !is_texture_size(level->height) || level->key >> type->bits)
            return GLINT_ERROR_TEXTURE;
        if (larger && (level->type != type || level->flags != larger->flags || larger->width * larger->height == 1 ||
                       level->width != (larger->width + 1) / 2 || level->height != (larger->height + 1) / 2))
            return GLINT_ERROR_TEXTURE;
    }
    return GLINT_OK;
}

static glint_status check_worn(const glint_material *material, const glint_mesh *mesh) {
    const glint_status status = check_levels(material->texture);
    if (status == GLINT_OK && (!mesh->texture_coordinates || (mesh->texture_extent[0] | mesh->texture_extent[1]) < 0))
        return GLINT_ERROR_TEXTURE;
    return status;
}

/* ---- Samples ---- */

/* Returns the texel at coordinates as it is stored. */
static GLINT_INLINE uint32_t read_texel(const glint_texture_map *map, uint32_t u, uint32_t v) {
    const glint_texture *texture = map->texture;
    return texture->type->read(texture->texels, texture->palette,
                               map->is_plain
                                   ? glint_texel_number(map, u, v)
                                   : glint_texel_column(map, glint_shift_right(glint_texel_position(map, 0, u), 8)) +
                                         glint_texel_row(map, glint_shift_right(glint_texel_position(map, 1, v), 8)));
}

/* Finds the colour at coordinates outside of holes, 1 = GLINT_COLOUR_ONE. */
static inline void sample(const glint_texture_map *map, uint32_t u, uint32_t v, int16_t colour[3]) {
    map->texture->type->sample(map, u, v, colour);
}

/* ---- Maps ---- */

/* Returns the map of the walk's triangle. */
static inline glint_texture_map *begun_map(const glint_row_walk *walk) {
    glint_texture_map *const map = walk->map;
    if (!map->is_begun) {
        const glint_config *config = &walk->frame->config;
        const uint32_t spans = config->format->sun_spans;
        glint_begin_map(walk, map);
        map->is_packed = spans && !config->gamma;
        const glint_texture_type *type = map->texture->type;
        map->is_quick =
            map->is_packed && !map->beyond[0] && !walk->is_deep && (map->is_bilinear ? type->mixed : type->spans[0][0]);
        map->swaps = spans == GLINT_SPANS_OF_RGB565_BE;
        map->is_begun = 1;
    }
    return map;
}

static inline void step_map(glint_texture_map *map) {
    glint_step_quadratic(&map->at[0], map->bend[0]);
    glint_step_quadratic(&map->at[1], map->bend[1]);
}

/* ---- Holes ---- */

/* Draws the parts of a span between holes. */
static void draw_between_holes(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    glint_texture_map *map = walk->map;
    int32_t from = left;
    while (left < right) {
        glint_find_coordinates(map, row, left);
        const int32_t stop = glint_least(map->right, right);
        int is_hole = 0;
        for (; left < stop && !is_hole; left++) {
            is_hole = read_texel(map, map->at[0].value, map->at[1].value) == map->texture->key;
            step_map(map);
        }
        if (!is_hole && left < right)
            continue;
        if (from < left - is_hole)
            map->visible(walk, row, from, left - is_hole);
        from = left;
    }
}

static void leave_holes(glint_row_walk *walk) {
    glint_texture_map *map = begun_map(walk);
    if (glint_has_holes(walk->draw)) {
        map->visible = walk->draw_span;
        walk->draw_span = draw_between_holes;
    }
}

static int is_hole(glint_row_walk *walk, int32_t row, int32_t column) {
    glint_texture_map map;
    glint_begin_map(walk, &map);
    glint_find_coordinates(&map, row, column);
    return read_texel(&map, map.at[0].value, map.at[1].value) == map.texture->key;
}

/* ---- Light at fragments ---- */

static void find_worn(const glint_row_walk *walk, int32_t row, int32_t column, int16_t colour[3]) {
    glint_texture_map *map = walk->map;
    GLINT_REQUIRE(map->is_begun);
    glint_check_run(map, row, column);
    const uint32_t x = (uint32_t)(column - map->origin);
    sample(map, glint_coordinate_at(&map->run[0], x), glint_coordinate_at(&map->run[1], x), colour);
}

static void multiply_words(const glint_row_walk *walk, int32_t row, uint32_t begin, glint_spread *p,
                           const glint_spread *end) {
    const glint_texture_map *map = walk->map;
    GLINT_REQUIRE(map->is_begun);
    const uint32_t half_level = walk->draw->extra ? 0 : walk->suns->suns->half_level;
    if (map->is_plain && map->texture->type->multiply) {
        map->texture->type->multiply(walk, row, begin, p, end);
        return;
    }
    for (; p != end; p++) {
        int16_t colour[3];
        find_worn(walk, row, (int32_t)(p->offset - begin), colour);
        p->colour = glint_times_colour(p->colour, colour[0], colour[1], colour[2]) + half_level;
    }
}

static glint_draw_span *choose_sun(const glint_row_walk *walk) {
    const glint_texture_map *map = begun_map(walk);
    return map->is_quick && map->is_plain ? map->texture->type->sun[map->swaps] : 0;
}

/* ---- Light at corners, and surfaces of one colour ---- */

/* Returns a channel in levels, given the texel's and light, Q15 and below 2, and highlights, Q27. */
static inline uint32_t packed_level(int32_t texel, int32_t light, int32_t gloss, int32_t most) {
    const int32_t sum =
        glint_shift_right((texel + 1) * glint_shift_right(light, 12), 15) + glint_shift_right(gloss, 12);
    return (uint32_t)(glint_least(sum, 1 << 15) * most + (1 << 14)) >> 15;
}

/* Multiplies the light at a pixel by the texture's colour, adds highlights, and puts it. */
static void put_worn(glint_row_walk *walk, uint32_t pixel, const int32_t light[3], const int32_t gloss[3]) {
    const glint_texture_map *map = walk->map;
    const glint_config *config = &walk->frame->config;
    int16_t colour[3];
    int32_t product[3];
    sample(map, map->at[0].value, map->at[1].value, colour);
    if (map->is_packed && !((light[0] | light[1] | light[2]) >> (GLINT_CHANNEL_BITS + 1))) {
        const uint32_t packed = packed_level(colour[0], light[0], gloss[0], 31) << 11 |
                                packed_level(colour[1], light[1], gloss[1], 63) << 5 |
                                packed_level(colour[2], light[2], gloss[2], 31);
        ((uint16_t *)walk->pixels)[pixel] = (uint16_t)(map->swaps ? glint_to_high_first(packed) : packed);
        return;
    }
    for (int c = 0; c < 3; c++)
        product[c] = 4 * glint_product_high(light[c], (colour[c] + 1) * (1 << 15)) + gloss[c];
    config->format->put(walk, pixel, glint_flat_lanes(config, product));
}

/* Returns a channel of light, Q27, given what corners have of it. */
static inline int32_t light_of(int32_t worn) {
    return glint_most(worn - GLINT_WORN_MARGIN, 0) * (1 << 13);
}

/* Sets channels of light from lanes. */
static inline void set_light(glint_lanes lanes, int32_t light[3]) {
    light[0] = light_of((int32_t)(lanes.red_blue & 0xffff) >> 1);
    light[1] = light_of((int32_t)(lanes.green >> 17));
    light[2] = light_of((int32_t)(lanes.red_blue >> 17));
}

/* Light is the same at all pixels, linear on the screen with or without highlights, or divided at each pixel. */
enum { IS_EVEN, IS_SMOOTH, IS_GLOWING, IS_DIVIDED };

/* Draws a span in any format. */
static GLINT_SPECIAL void draw_worn_span(glint_row_walk *walk, int32_t row, int32_t left, int32_t right, int kind) {
    glint_texture_map *map = walk->map;
    uint32_t z = glint_z_at(walk, row, left), pixel = ((uint32_t)row << walk->shift) + (uint32_t)left;
    int32_t none = 0;
    GLINT_OPAQUE(none); /* otherwise compilers store two zeros from a register of the FPU */
    int32_t gloss[3] = {none, none, none};
    glint_find_coordinates(map, row, left);
    for (; left < right; left++) {
        if (left == map->right)
            glint_find_coordinates(map, row, left);
        if (glint_is_nearest((uint8_t *)&walk->depth[pixel], (uint32_t)glint_most((int32_t)z, GLINT_DEPTH_BIAS))) {
            int32_t *const light = map->light;
            if (kind == IS_DIVIDED) {
                int16_t worn[3];
                glint_divide_at(walk, row, left, worn);
                for (int c = 0; c < 3; c++)
                    light[c] = light_of(worn[c]);
            } else if (kind != IS_EVEN) {
                set_light(glint_lanes_at(walk, row, left), light);
                if (kind == IS_GLOWING)
                    set_light(glint_gloss_at(walk, left), gloss);
            }
            put_worn(walk, pixel, light, gloss);
        }
        pixel++;
        z += (uint32_t)walk->z.dx;
        step_map(map);
    }
}

static void draw_even_worn(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    draw_worn_span(walk, row, left, right, IS_EVEN);
}

static void draw_smooth_worn(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    draw_worn_span(walk, row, left, right, IS_SMOOTH);
}

static void draw_glowing_worn(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    draw_worn_span(walk, row, left, right, IS_GLOWING);
}

static void draw_divided_worn(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    draw_worn_span(walk, row, left, right, IS_DIVIDED);
}

/* Returns what draws spans of a kind where map->is_quick. */
static glint_draw_span *quick_span(glint_texture_map *map, int kind) {
    const glint_texture_type *type = map->texture->type;
    map->kind = (uint8_t)kind;
    return map->is_bilinear ? type->mixed : type->spans[kind][map->swaps];
}

/* Draws a span whose light is linear on the screen. */
static void draw_shaded(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    glint_texture_map *map = walk->map;
    (map->is_quick ? quick_span(map, TEXELS_SHADED) : draw_smooth_worn)(walk, row, left, right);
}

/* Draws such a span with highlights. */
static void draw_glowing(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    glint_texture_map *map = walk->map;
    (map->is_quick ? quick_span(map, TEXELS_GLOWING) : draw_glowing_worn)(walk, row, left, right);
}

/* Chooses what draws a triangle of even light. */
static glint_draw_span *choose_even(glint_row_walk *walk) {
    glint_texture_map *map = walk->map;
    const int32_t *light = map->light;
    int16_t worn[3];
    if (!map->is_quick || glint_most_of(light[0], light[1], light[2]) > GLINT_CHANNEL_ONE)
        return draw_even_worn;
    if (glint_least_of(light[0], light[1], light[2]) == GLINT_CHANNEL_ONE)
        return quick_span(map, TEXELS_UNLIT);
    for (int c = 0; c < 3; c++)
        worn[c] = (int16_t)(glint_shift_right(light[c], 13) + GLINT_WORN_MARGIN);
    walk->lanes[0] = glint_lanes_of(worn);
    walk->lanes[1] = walk->lanes[2] = (glint_lanes){0, 0};
    return quick_span(map, TEXELS_SHADED);
}

/* Draws the first span of a triangle. */
static void begin_worn(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    const glint_draw *draw = walk->draw;
    glint_begin_depth(walk);
    glint_texture_map *const map = begun_map(walk);
    if (draw->light && !draw->facets && !map->is_even) {
        glint_begin_interpolated(walk);
    } else {
        const int is_clamped = draw->evaluation && draw->evaluation->lit_at != GLINT_LIT_AT_FRAGMENTS;
        if (!map->is_even)
            glint_channels_of(draw->shading->ambient, map->light);
        for (int c = 0; c < 3 && !map->is_even; c++)
            map->light[c] = draw->light  ? light_of(draw->facets[walk->triangle.index][c])
                            : is_clamped ? glint_least(map->light[c], GLINT_CHANNEL_ONE)
                                         : map->light[c];
        walk->draw_span = choose_even(walk);
    }
    leave_holes(walk);
    walk->draw_span(walk, row, left, right);
}

static void draw_even(glint_row_walk *walk, glint_begun begun, uint32_t light) {
    const uint32_t channel[3] = {(light >> 10 & 0x3ff) * 2, light >> 21, light & 0x1ff};
    /* Q27 over levels of 5, 6 and 5 bits with 6, 4 and 4 bits of fractions */
    static const uint32_t one[3] = {(1u << GLINT_CHANNEL_BITS) / (31 << 6), (1u << GLINT_CHANNEL_BITS) / (63 << 4),
                                    (1u << GLINT_CHANNEL_BITS) / (31 << 4)};
    for (int c = 0; c < 3; c++)
        walk->map->light[c] = glint_least((int32_t)(channel[c] * (one[c] + 1)), GLINT_CHANNEL_ONE);
    walk->map->is_even = 1;
    walk->draw_span = begin_worn;
    glint_walk_begun(walk, begun);
}

static void draw_worn(glint_row_walk *walk) {
    glint_texture_map map;
    map.is_begun = map.is_even = 0;
    /* cppcheck-suppress autoVariables; the walk ends before this function does */
    walk->map = &map;
    if (walk->draw->light && walk->draw->evaluation->lit_at == GLINT_LIT_AT_FRAGMENTS) {
        walk->draw->evaluation->draw_triangle(walk);
        return;
    }
    const glint_begun begun = glint_begin_triangle(walk);
    if (begun == GLINT_NO_ROWS || (begun == GLINT_IS_SMALL && walk->has_slopes && !glint_find_visible_row(walk)))
        return;
    walk->draw_span = begin_worn;
    glint_walk_begun(walk, begun);
}

const glint_texture_stage glint_textures = {.check = check_worn,
                                            .draw = draw_worn,
                                            .draw_even = draw_even,
                                            .smooth = draw_shaded,
                                            .glowing = draw_glowing,
                                            .divided = draw_divided_worn,
                                            .leave_holes = leave_holes,
                                            .is_hole = is_hole,
                                            .find = find_worn,
                                            .multiply = multiply_words,
                                            .choose_sun = choose_sun,
                                            .set_node = glint_set_worn_node,
                                            .draw_patch = glint_draw_worn_patch};
