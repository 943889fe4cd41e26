/* SPDX-License-Identifier: MIT */
#include "random_texture.h"

#include "source.h"

#include <stddef.h>

/* ---- Texels ---- */

#define MOST_SIZE 1024
#define POOL_TEXELS (MOST_SIZE * MOST_SIZE + 4096)

/* Few colours, so that each texel's is met again, as a hole's should be. */
#define POOL_COLOURS 48

static uint16_t pool[POOL_TEXELS];

static void fill_pool(void) {
    source random = {1};
    uint16_t colours[POOL_COLOURS];
    for (int i = 0; i < POOL_COLOURS; i++)
        colours[i] = (uint16_t)next(&random);
    for (int i = 0; i < POOL_TEXELS; i++)
        pool[i] = colours[below(&random, POOL_COLOURS)];
}

static uint16_t take_size(source *random) {
    const uint32_t most = one_in(random, 16) ? 11 : 8;
    return (uint16_t)(1u << below(random, most));
}

/* Gives some textures levels, down to one texel or not as far; no other number depends on it. */
static void make_levels(random_texture *made, uint32_t number) {
    glint_texture *larger = &made->texture;
    if (number % 3)
        return;
    for (uint32_t i = 0; larger->width * larger->height > 1 && i < 1 + number / 3 % 16; i++) {
        glint_texture *const level = &made->levels[i];
        *level = *larger;
        level->width = (uint16_t)((larger->width + 1) / 2);
        level->height = (uint16_t)((larger->height + 1) / 2);
        level->texels = (const uint16_t *)larger->texels + 64;
        larger->smaller = level;
        larger = level;
    }
}

static void make_texture(random_texture *made, source *random) {
    glint_texture *const texture = &made->texture;
    static const glint_texture_type *const types[4] = {&glint_texture_rgb565, &glint_texture_grey8,
                                                       &glint_texture_palette256, &glint_texture_palette16};
    const uint32_t type = below(random, 4), first = below(random, 2048);
    if (!pool[0] && !pool[1])
        fill_pool();
    *texture = (glint_texture){.type = types[type], .texels = pool + first, .palette = type >= 2 ? pool + 1000 : NULL};
    texture->width = take_size(random);
    texture->height = take_size(random);
    if (one_in(random, 3)) {
        texture->flags = GLINT_TEXTURE_HAS_KEY;
        texture->key = (uint16_t)(pool[first + below(random, 16)] & (type == 0 ? 0xffff : type == 3 ? 15 : 255));
    }
    make_levels(made, first);
}

/* ---- Places ---- */

static int32_t from_to(source *random, int32_t least, int32_t most) {
    return (int32_t)(least + (int64_t)((next(random) >> 32) * ((uint64_t)((int64_t)most - least) + 1) >> 32));
}

static int16_t clamp(int64_t step) {
    return (int16_t)(step < -32768 ? -32768 : step > 32767 ? 32767 : step);
}

/* Throws a picture: each coordinate is a sum of a position's steps. */
static void throw_picture(const glint_mesh *mesh, int16_t (*coordinates)[2], source *random) {
    int32_t weights[2][3];
    for (int i = 0; i < 6; i++)
        weights[i / 3][i % 3] = from_to(random, -GLINT_ONE, GLINT_ONE);
    for (uint32_t vertex = 0; vertex < mesh->vertex_count; vertex++)
        for (int axis = 0; axis < 2; axis++) {
            int64_t sum = 0;
            for (int i = 0; i < 3; i++)
                sum += (int64_t)weights[axis][i] * mesh->positions[vertex][i];
            coordinates[vertex][axis] = clamp(sum >> 16);
        }
}

static void map_vertices(glint_mesh *mesh, int16_t (*coordinates)[2], source *random) {
    static const glint_q16 offsets[4] = {INT32_MIN, INT32_MAX, -GLINT_ONE, 1 << 30},
                           extents[4] = {0, 1, INT32_MAX, 1 << 24};
    if (one_in(random, 4))
        for (uint32_t i = 0; i < 2 * mesh->vertex_count; i++)
            coordinates[i / 2][i % 2] = (int16_t)from_to(random, -32768, 32767);
    else
        throw_picture(mesh, coordinates, random);
    for (int axis = 0; axis < 2; axis++) {
        const uint32_t power = below(random, one_in(random, 8) ? 8 : 4);
        mesh->texture_offset[axis] =
            one_in(random, 16) ? offsets[below(random, 4)] : from_to(random, -8 * GLINT_ONE, 8 * GLINT_ONE);
        mesh->texture_extent[axis] =
            one_in(random, 32) ? extents[below(random, 4)] : from_to(random, GLINT_ONE / 8, GLINT_ONE / 4) << power;
    }
    mesh->texture_coordinates = (const int16_t(*)[2])coordinates;
}

void random_texture_dress(glint_mesh *mesh, int16_t (*coordinates)[2], glint_material *material,
                          random_texture *texture, source *random) {
    make_texture(texture, random);
    map_vertices(mesh, coordinates, random);
    material->texture = &texture->texture;
    if (one_in(random, 3))
        material->diffuse = (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE};
    if (one_in(random, 4))
        material->model = &glint_model_unlit;
    const glint_colour of = material->diffuse;
    if (material->model == &glint_model_unlit && (of.r > GLINT_ONE || of.g > GLINT_ONE || of.b > GLINT_ONE))
        material->diffuse = (glint_colour){of.r / 16, of.g / 16, of.b / 16}; /* above 1 it is clamped */
    material->flags |= below(random, 4) * GLINT_MATERIAL_CLAMP;
}
