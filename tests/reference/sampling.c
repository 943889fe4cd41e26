/* SPDX-License-Identifier: MIT */
#include "sampling.h"

#include "lighting.h"

#include <math.h>
#include <string.h>

void reference_mesh_texture(const glint_mesh *mesh, uint32_t index, double coordinates[2]) {
    for (int axis = 0; axis < 2; axis++)
        coordinates[axis] = mesh->texture_coordinates ? reference_real(mesh->texture_offset[axis]) +
                                                            reference_real(mesh->texture_extent[axis]) *
                                                                mesh->texture_coordinates[index][axis] / 32768
                                                      : 0;
}

/* ---- Texels ---- */

/* Brings a number of a column or row onto the texture. */
static int wrap(double number, int size, int is_clamped) {
    if (is_clamped)
        return (int)fmax(0, fmin(size - 1, number));
    return (int)(number - size * floor(number / size));
}

/* Returns a texel as it is stored. */
static unsigned stored_at(const glint_texture *texture, int column, int row) {
    const size_t number = (size_t)row * texture->width + (size_t)column;
    const uint8_t *const bytes = texture->texels;
    if (texture->type == &glint_texture_rgb565)
        return ((const uint16_t *)texture->texels)[number];
    if (texture->type == &glint_texture_palette16)
        return number % 2 ? bytes[number / 2] & 15u : bytes[number / 2] >> 4;
    return bytes[number];
}

static void colour_of(const glint_texture *texture, unsigned stored, double colour[3]) {
    const unsigned word =
        texture->palette && texture->type != &glint_texture_rgb565 ? texture->palette[stored] : stored;
    colour[0] = (word >> 11) / 31.0;
    colour[1] = (word >> 5 & 63) / 63.0;
    colour[2] = (word & 31) / 31.0;
    if (texture->type == &glint_texture_grey8)
        colour[0] = colour[1] = colour[2] = stored / 255.0;
}

/* A texture as a material wears it. */
typedef struct worn {
    const glint_texture *texture;
    int is_clamped;
} worn;

static unsigned texel_at(const worn *by, double column, double row) {
    return stored_at(by->texture, wrap(column, by->texture->width, by->is_clamped),
                     wrap(row, by->texture->height, by->is_clamped));
}

static int is_hole(const worn *by, double column, double row) {
    return (by->texture->flags & GLINT_TEXTURE_HAS_KEY) && texel_at(by, column, row) == by->texture->key;
}

/* Mixes the four texels around a point, in texels from the middle of the first one. */
static void mix_texels(const worn *by, double x, double y, double colour[3]) {
    const double column = floor(x), row = floor(y);
    memset(colour, 0, 3 * sizeof *colour);
    for (int i = 0; i < 4; i++) {
        const double weight = (i % 2 ? x - column : column + 1 - x) * (i / 2 ? y - row : row + 1 - y);
        double one[3];
        const int right = i & 1, below = i >> 1;
        colour_of(by->texture, texel_at(by, column + right, row + below), one);
        for (int channel = 0; channel < 3; channel++)
            colour[channel] += weight * one[channel];
    }
}

/* ---- Levels ---- */

/* Differences of coordinates that are rounded to 30 bits take a triangle's area off by up to this part of the largest
 * product, and areas are whole numbers of this unit. */
#define ROUNDED_PART (1.0 / (1 << 27))
#define AREA_UNIT (1.0 / 256)

const glint_texture *reference_choose_level(const glint_texture *texture, const double coordinates[3][2], double pixels,
                                            int *is_open) {
    double to[2][2], most[2];
    for (int axis = 0; axis < 2; axis++) {
        for (int i = 0; i < 2; i++)
            to[i][axis] = coordinates[i + 1][axis] - coordinates[0][axis];
        most[axis] = fmax(fabs(to[0][axis]), fabs(to[1][axis]));
    }
    const double repeats = fabs(to[0][0] * to[1][1] - to[0][1] * to[1][0]);
    *is_open = 0;
    for (; texture->smaller; texture = texture->smaller) {
        const double size = (double)texture->width * texture->height;
        *is_open |= fabs(repeats * size - pixels) <= ROUNDED_PART * most[0] * most[1] * size + AREA_UNIT;
        if (repeats * size <= pixels)
            break;
    }
    return texture;
}

/* ---- Samples ---- */

/* From least to most along an axis: the ends, and a whole number between, if there is one. @return how many */
static int take_knots(double least, double most, double knots[3]) {
    const double whole = ceil(least);
    knots[0] = least;
    knots[1] = most;
    knots[2] = whole;
    return whole < most ? 3 : 2;
}

/* Finds the least and the most of mixtures within a window: they are at its corners, or where four texels meet. */
static void mix_within(const worn *by, double window[2][2], reference_texels *to) {
    double x[3], y[3];
    const int columns = take_knots(window[0][0] - 0.5, window[0][1] - 0.5, x),
              rows = take_knots(window[1][0] - 0.5, window[1][1] - 0.5, y);
    to->count = 1;
    for (int i = 0; i < columns * rows; i++) {
        double colour[3];
        mix_texels(by, x[i % columns], y[i / columns], colour);
        for (int channel = 0; channel < 3; channel++) {
            to->least[0][channel] = i ? fmin(to->least[0][channel], colour[channel]) : colour[channel];
            to->most[0][channel] = i ? fmax(to->most[0][channel], colour[channel]) : colour[channel];
        }
    }
}

/* Lists the texels of a window that are no holes. */
static void list_within(const worn *by, const double first[2], const int counts[2], reference_texels *to) {
    for (int y = 0; y < counts[1]; y++)
        for (int x = 0; x < counts[0]; x++)
            if (!is_hole(by, first[0] + x, first[1] + y)) {
                colour_of(by->texture, texel_at(by, first[0] + x, first[1] + y), to->least[to->count]);
                memcpy(to->most[to->count], to->least[to->count], sizeof to->most[0]);
                to->count++;
            }
}

void reference_sample(const glint_texture *texture, uint32_t flags, const double at[2], const double window[2][2],
                      reference_texels *to) {
    const worn by = {texture, (flags & GLINT_MATERIAL_CLAMP) != 0};
    const int is_bilinear = (flags & GLINT_MATERIAL_BILINEAR) != 0;
    double exact[2], texels[2][2], first[2], last[2];
    int is_settled = 1, holes = 0, counts[2];
    memset(to, 0, sizeof *to);
    for (int axis = 0; axis < 2; axis++) {
        const int size = axis ? by.texture->height : by.texture->width;
        const double middle = is_bilinear ? 0.5 : 0;
        exact[axis] = at[axis] * size;
        texels[axis][0] = window[axis][0] * size - REFERENCE_TEXEL_ROOM;
        texels[axis][1] = window[axis][1] * size + REFERENCE_TEXEL_ROOM;
        for (int end = 0; end < 2 && by.is_clamped; end++) /* beyond its edges a texture is the same everywhere */
            texels[axis][end] = fmax(-1, fmin(size + 1, texels[axis][end]));
        first[axis] = floor(texels[axis][0]);
        last[axis] = floor(texels[axis][1]);
        is_settled &= size == 1 || floor(texels[axis][1] - middle) - floor(texels[axis][0] - middle) <= 1;
        if (size == 1)
            first[axis] = last[axis] = texels[axis][0] = texels[axis][1] = 0;
    }
    to->is_hole = is_hole(&by, floor(exact[0]), floor(exact[1]));
    if (is_bilinear)
        mix_texels(&by, exact[0] - 0.5, exact[1] - 0.5, to->exact);
    else
        colour_of(by.texture, texel_at(&by, floor(exact[0]), floor(exact[1])), to->exact);
    to->may_differ = !is_settled && by.texture->flags;
    if (!is_settled)
        return;
    for (int axis = 0; axis < 2; axis++)
        counts[axis] = (int)(last[axis] - first[axis]) + 1;
    for (int y = 0; y < counts[1]; y++)
        for (int x = 0; x < counts[0]; x++)
            holes += is_hole(&by, first[0] + x, first[1] + y);
    to->may_differ = holes && holes < counts[0] * counts[1];
    if (is_bilinear)
        mix_within(&by, texels, to);
    else
        list_within(&by, first, counts, to);
}
