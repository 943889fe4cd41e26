/* SPDX-License-Identifier: MIT */
/**
 * @file judge.h
 * Holds the library's image of a scene against the reference's, in steps of the output format. A dithered format rounds
 * at each pixel's threshold: the reference is rounded there too, and a stored level counts as the middle of what is
 * rounded to it.
 */
#ifndef GLINT_JUDGE_H
#define GLINT_JUDGE_H

#include "glint.h"

/** Surfaces nearer to each other than this many depth steps may come out in either order. */
#define JUDGE_CLOSE_STEPS 2

/** Depth over that of the frame's nearest geometry from which on 1/w has too few bits for the coordinates of a texture:
 * glint.h promises coverage and the colours of facets there, and holes are neither. */
#define JUDGE_FAR 1048576

/** Cosines of 0 to within this are told by rounding: two steps of a unit vector in Q15, N and L being rounded to one.
 */
#define JUDGE_GATE (2.0 / 32768)

/** What to draw, and how much the stored value may differ from the unrounded one to count as fine. */
typedef struct judge_task {
    const glint_scene *scene;
    int width, height;
    const glint_format *format;
    int leave_out_gates; /**< Leave `gated` pixels out of the bounds. */
    double fine;         /**< Steps. */
    double fine_of[3];   /**< Steps of each channel, in place of `fine` where the first is not 0. */
} judge_task;

/** Counts of pixels, summed over the tasks judged. */
typedef struct judgement {
    glint_status status; /**< Of the library; the rest holds only with GLINT_OK. */
    long covered;        /**< Pixels the reference covers. */
    long missed;         /**< Covered by the reference or the library only. */
    long uncertain;      /**< Beside an edge of a triangle that library and reference each clip, or where a texture may
                              have a hole, or has some and is far: not looked at. */
    long spilled;        /**< Not covered by the reference and not the background's colour. */
    long close;          /**< The two nearest surfaces are less than 2 depth steps apart: left out of the bounds. */
    long gated;     /**< The colour jumps where a light's |N.L| is 0, or at the edge of a cone, and a cosine is within
                         JUDGE_GATE of that, or a light touches the surface: rounding decides. */
    long unsettled; /**< A sixteenth of a pixel and of a texel span more than two texels (sampling.h): left out. */
    long beside;    /**< Judged, and nearer to a texel beside the pixel's own, which is within as much. */
    long judged;    /**< Covered by both and not left out. */
    long apart;     /**< Judged and not as the rounded reference. */
    long over_one;  /**< Judged and more than 1 step from the rounded reference. */
    long over_two;  /**< Judged and more than 2. */
    long not_fine;  /**< Judged and more than `fine` steps from the unrounded reference. */
    double worst;   /**< Largest distance from the unrounded reference, steps. */
    int worst_x, worst_y;
    double vertex_error; /**< Largest distance of a snapped coordinate from the exact one, pixels. */
    double squares;      /**< Sum of squared errors, levels as 0..1, over `samples`. */
    long samples;        /**< Channels of pixels covered by both. */
} judgement;

/** Judges a scene and adds to `total`, which begins as zeros. */
void judge(const judge_task *task, judgement *total);

/** Adds what was found of one task to what was found of others. */
void judgement_add(judgement *total, const judgement *part);

/**
 * Does a single frame keep the contract of formats up to 6 bits a channel? Coverage is right; at most 0.1 % of its
 * judged pixels are not fine, or three, and 0.01 % over one step, or two.
 */
int judgement_keeps_contract(const judgement *frame);

/** The same of formats of 8 bits: at most 0.5 % are beyond one step, or three, and 0.05 % over two, or two. */
int judgement_keeps_fine_contract(const judgement *frame);

/** Peak signal to noise ratio of what was judged, decibels. */
double judgement_psnr(const judgement *total);

#endif
