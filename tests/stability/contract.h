/* SPDX-License-Identifier: MIT */
/**
 * @file contract.h
 * The accuracy contract, pixel by pixel. Given the snapped vertices, coverage is that of the reference. A stored value
 * is within weights_bound of the unrounded reference for 99.9 % of a frame's pixels, within one step of the rounded one
 * for 99.99 %, or for all but one where that is more, and within two for all.
 *
 * Left out are pixels where the last bit of an input decides, by rules that do not look at the outcome:
 * - close: two surfaces less than 2 depth steps apart (judge.h), or than depth changes by over 1/64 of a pixel, a
 * quarter of what vertices are snapped to;
 * - uncertain: beside an edge that library and reference each clip and round, or where a texture may have a hole
 * (judge.h);
 * - unsettled: more than two texels along an axis within a sixteenth of a texel and of a pixel. Where there are two,
 * the pixel may have the colour of either, or, where texels are mixed, any mixture within that (sampling.h);
 * - gated: a cosine within 4.6 / 2^15 of a light's horizon, where a highlight's gate jumps, of a cone without soft
 * edge, or of 0 where it is raised to less than 1, from where it rises without bound: each of the two unit vectors is
 * off by up to 2.3 / 2^15;
 * - touched: a light within a pixel of what it lights, as wide as pixels are there. The way to it is told in steps of
 * 2^-13 of a pixel or more: its direction is known to fewer than 13 bits (the reference's lighting.c; counted as
 * gated);
 * - next to it: a light so near that a sixteenth of a pixel, to which vertices are snapped, changes N.L by four times
 * what the bound leaves beside rounding: by two levels of 255 in 8 bits a channel, within 8 pixels, and by one of 63 in
 * RGB565, within 4; or so near that 2^-16 of the depth, to which 1/w of vertices is exact, changes N.L by what the
 * bound leaves: within 1/128 of the depth in 8 bits a channel, and within 1/260 in RGB565 (glint.h says so);
 * - short: a sum of unit vectors nearly cancels. An interpolated normal, or L + V of a light with Blinn's highlight, is
 *   shorter than a quarter, so that its direction is known to fewer than 13 bits. An object that is lit per vertex or
 *   facet is left out whole where L + V of one of its vertices is.
 * - narrow: within the soft edge of a spot whose inner and outer cosines are less than 1/64 apart. The cosine of two
 * unit vectors of 15 bits is known to about 2^-14, which there is more than 1.5 steps of 256. Surfaces lit per vertex
 * or facet count as within wherever they are seen.
 * - far: more than 2^20 times as far as the frame's nearest geometry, where glint.h promises coverage and the colours
 * of facets only. Where textures have holes and are that far, pixels are uncertain.
 * - rounded: in a scene with a clipped object, where 1.5/16 of a pixel changes the light by over a quarter of a step,
 * or 1/w by more than two surfaces are apart. Library and reference cut on their own and round the cut corners, so that
 * their snapped vertices are not the same.
 *
 * Where surfaces are blended or lie in fog, what is stored is one of the levels that the definitions in glint_extras.h
 * make of those that the bound above leaves each surface (level_set.h), in as many pixels as above, and at most one
 * level beside, or two, in as many. A pixel is left out where a rule leaves out any of the surfaces that it may show.
 */
#ifndef GLINT_STABILITY_CONTRACT_H
#define GLINT_STABILITY_CONTRACT_H

#include "glint.h"
#include "judge.h"
#include "picture.h"

/** Lengths below which a sum of unit vectors counts as short: normals, L + V at a vertex, and L + V at a fragment. */
#define CONTRACT_SHORT 0.25
#define CONTRACT_SHORT_HALF (1.0 / 16)

/** Difference of cosines below which a spot's edge counts as narrow. */
#define CONTRACT_NARROW (1.0 / 64)

/** Depth over that of the frame's nearest geometry from which on a surface counts as far. */
#define CONTRACT_FAR JUDGE_FAR

/** Why a covered pixel is left out, or that it is judged; where several hold, the first one in the order that pixels
 * are asked for them. */
typedef enum contract_rule {
    CONTRACT_JUDGED,
    CONTRACT_UNCERTAIN,
    CONTRACT_UNSETTLED,
    CONTRACT_GATED,
    CONTRACT_CLOSE,
    CONTRACT_DISTANT,
    CONTRACT_SHORT_SUM,
    CONTRACT_NARROW_EDGE,
    CONTRACT_NEXT_TO,
    CONTRACT_ROUNDED,
    CONTRACT_RULES
} contract_rule;

/** Depths, as multiples of that of the frame's nearest geometry, by powers of two: as many as coordinates have. */
#define CONTRACT_DEPTHS 34

/** What was found at depths from a power of two to the next, in pixels that are judged but for how far they are. */
typedef struct contract_depth {
    long pixels;
    double sum, worst; /**< Distances from the unrounded reference, in steps. */
    double apart;      /**< Sum of what depth is off by, as a share of it. */
} contract_depth;

typedef struct contract_result {
    judgement found;             /**< Its worst and its counts over bounds are those of the pixels that count. */
    long excused;                /**< Pixels over a bound that were left out as short, narrow, far or rounded. */
    long pixels[CONTRACT_RULES]; /**< Covered pixels by rule. */
    double worst_share;          /**< Largest distance from the unrounded reference over the pixel's bound. */
    double bound;                /**< That pixel's. */
    int worst_x, worst_y;
    contract_depth depths[CONTRACT_DEPTHS]; /**< In perspective. */
    int is_fine;                            /**< The format has 8 bits a channel. */
} contract_result;

/** Judges one scene; pixels are counted by rule only if some are beyond the strictest bound. */
void contract_judge(const glint_scene *scene, int width, int height, const glint_format *format,
                    contract_result *result);

/** The same, with pixels counted in any case. */
void contract_judge_closely(const glint_scene *scene, int width, int height, const glint_format *format,
                            contract_result *result);

/** The same of what is drawn over a painted background, say, always closely; without output tables. */
void contract_judge_blended(const glint_scene *scene, int width, int height, const glint_format *format,
                            const picture_options *how, contract_result *result);

/** Whether the frame keeps the contract, by the pixels that count. */
int contract_holds(const contract_result *result);

#endif
