/* SPDX-License-Identifier: MIT */
/**
 * @file sampling.h
 * The reference's textures, in double precision, from the definitions in glint.h.
 *
 * At a texel's border rounding decides which texel shows. The library may be off by REFERENCE_TEXEL_ROOM of a texel,
 * and by what a sixteenth of a pixel, to which corners are snapped, moves coordinates. A sample therefore lists all
 * texels within that. Where these are more than two along an axis, coordinates are not settled and nothing is told.
 */
#ifndef GLINT_REFERENCE_SAMPLING_H
#define GLINT_REFERENCE_SAMPLING_H

#include "glint.h"

/** Part of a texel that coordinates may be off by beside what snapping moves. */
#define REFERENCE_TEXEL_ROOM (1.0 / 16)

/** Two along each axis. */
#define REFERENCE_TEXELS_MAX 4

/** Colours that a pixel may show: those from `least` to `most`, channel by channel. */
typedef struct reference_texels {
    double exact[3];                                                      /**< At the exact coordinates. */
    double least[REFERENCE_TEXELS_MAX][3], most[REFERENCE_TEXELS_MAX][3]; /**< Of `count` texels, or of one mixture. */
    int count;                                                            /**< 0 where coordinates are not settled. */
    int is_hole;                                                          /**< The exact coordinates are a hole's. */
    int may_differ; /**< Some texels within reach are holes, not all. */
} reference_texels;

/** Texture coordinates of a vertex, in repeats; 0 where its mesh has none. */
void reference_mesh_texture(const glint_mesh *mesh, uint32_t index, double coordinates[2]);

/**
 * Chooses the level that a triangle shows, which is not clipped.
 * @param coordinates of its corners, in repeats
 * @param pixels twice its area on the screen
 * @param is_open set to 1 where the areas are so near to each other that the larger level may be shown, or the next
 * one; else to 0
 */
const glint_texture *reference_choose_level(const glint_texture *texture, const double coordinates[3][2], double pixels,
                                            int *is_open);

/**
 * Samples a texture, which may be a level of another.
 * @param flags of the material
 * @param at exact coordinates, in repeats
 * @param window least and most coordinates within a sixteenth of a pixel, u and v
 */
void reference_sample(const glint_texture *texture, uint32_t flags, const double at[2], const double window[2][2],
                      reference_texels *to);

#endif
