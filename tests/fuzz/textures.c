/* SPDX-License-Identifier: MIT */
/* Textures of a scene's materials: of every type, with holes, and now and then wrong. */
#include "drawing.h"

#include <string.h>

/* All of 16 bits, or a few values of them, which are met again. Texels take just as many bytes as they need. */
static void *take_texels(source *s, const glint_texture *texture, uint32_t *first) {
    const uint32_t count = (uint32_t)texture->width * texture->height;
    const size_t size = texture->type == &glint_texture_rgb565      ? 2 * (size_t)count
                        : texture->type == &glint_texture_palette16 ? (count + 1) / 2
                                                                    : count;
    const uint32_t mask = below(s, 2) ? 0xff : 7;
    uint32_t state = take(s, 2);
    uint8_t *const texels = allocate(size);
    for (size_t i = 0; i < size; i++)
        texels[i] = (uint8_t)(next_random(&state) & mask);
    const int is_word = texture->type == &glint_texture_rgb565, is_nibble = texture->type == &glint_texture_palette16;
    uint8_t byte = 0;
    uint16_t word = 0;
    memcpy(is_word ? (void *)&word : &byte, texels, is_word ? sizeof word : sizeof byte);
    *first = is_word ? word : is_nibble ? byte >> 4 : byte;
    return texels;
}

static uint16_t *take_palette(source *s, uint32_t count) {
    uint16_t *const palette = allocate(count * sizeof *palette);
    uint32_t state = take(s, 2);
    for (uint32_t i = 0; i < count; i++)
        palette[i] = (uint16_t)next_random(&state);
    return palette;
}

static void spoil(source *s, glint_texture *texture) {
    switch (below(s, 6)) {
    case 0:
        texture->type = NULL;
        break;
    case 1:
        texture->width = (uint16_t)below(s, texture->width + 1u);
        break;
    case 2:
        texture->height = (uint16_t)below(s, texture->height + 1u);
        break;
    case 3:
        texture->flags = (uint16_t)take(s, 2);
        break;
    case 4:
        texture->key = (uint16_t)take(s, 2);
        break;
    default:
        texture->palette = NULL;
        break;
    }
}

static void take_texture(source *s, glint_texture *texture) {
    static const glint_texture_type *const types[4] = {&glint_texture_rgb565, &glint_texture_grey8,
                                                       &glint_texture_palette256, &glint_texture_palette16};
    const uint32_t type = below(s, 4), most = one_in(s, 16) ? 11 : 7;
    uint32_t first;
    texture->type = types[type];
    texture->width = (uint16_t)(1u << below(s, most));
    texture->height = (uint16_t)(1u << below(s, most));
    texture->texels = take_texels(s, texture, &first);
    if (type >= 2)
        texture->palette = take_palette(s, type == 2 ? 256 : 16);
    if (below(s, 2)) {
        texture->flags = GLINT_TEXTURE_HAS_KEY;
        texture->key = (uint16_t)first;
    }
}

/* Levels of a sound texture, of texels of their own, as many as there are or fewer. */
static void take_levels(source *s, glint_texture *texture, glint_texture levels[DRAWING_LEVELS], int is_sound) {
    glint_texture *larger = texture;
    uint32_t first;
    for (uint32_t i = 0, count = 1 + below(s, DRAWING_LEVELS); larger->width * larger->height > 1 && i < count; i++) {
        levels[i] = *larger;
        levels[i].width = (uint16_t)((larger->width + 1) / 2);
        levels[i].height = (uint16_t)((larger->height + 1) / 2);
        levels[i].texels = take_texels(s, &levels[i], &first);
        larger->smaller = &levels[i];
        larger = &levels[i];
    }
    if (!is_sound && one_in(s, 8))
        larger->smaller = below(s, 2) ? texture : larger; /* a ring */
    if (!is_sound && one_in(s, 8))
        spoil(s, larger);
}

/* Places of vertices on the texture: any, or all within a repeat or a few. */
static void take_coordinates(source *s, glint_mesh *mesh, int is_sound) {
    int16_t(*coordinates)[2] = allocate(mesh->vertex_count * sizeof *coordinates);
    uint32_t state = take(s, 2);
    for (uint32_t i = 0; i < 2 * mesh->vertex_count; i++)
        coordinates[i / 2][i % 2] = (int16_t)next_random(&state);
    mesh->texture_coordinates = (const int16_t(*)[2])coordinates;
    for (int axis = 0; axis < 2; axis++) {
        mesh->texture_offset[axis] = any(s);
        mesh->texture_extent[axis] = one_in(s, 8) ? any(s) : GLINT_ONE >> 4 << below(s, 8);
        if (is_sound && mesh->texture_extent[axis] < 0)
            mesh->texture_extent[axis] = INT32_MAX;
    }
}

void take_textures(source *s, drawing *d, int is_sound) {
    if (!below(s, 4))
        return;
    for (int i = 0; i < DRAWING_MESHES; i++)
        if (is_sound || below(s, 16))
            take_coordinates(s, &d->meshes[i], is_sound);
    for (int i = 0; i < DRAWING_OBJECTS; i++) {
        if (!below(s, 4))
            continue;
        take_texture(s, &d->textures[i]);
        d->texels[i] = d->textures[i].texels;
        d->palettes[i] = d->textures[i].palette;
        d->materials[i].texture = &d->textures[i];
        d->materials[i].flags |= below(s, 4) * GLINT_MATERIAL_CLAMP;
        if (one_in(s, 4))
            take_levels(s, &d->textures[i], d->levels[i], is_sound);
        if (!is_sound && one_in(s, 16))
            spoil(s, &d->textures[i]);
    }
}
