/* SPDX-License-Identifier: MIT */
/**
 * @file rows.h
 * Tables of judgements, and the contract that every row is held to.
 */
#ifndef GLINT_ROWS_H
#define GLINT_ROWS_H

#include "judge.h"

void row_print_heading(void);
void row_print(const char *name, const judgement *found);

/** Whether some object of a scene is lit per fragment, where a few pixels may be off by two steps. */
int row_is_per_fragment(const glint_scene *scene);

/** Judges an image and adds to `total`; where it misses the contract, prints viewer, exponent and worst pixel. */
void row_judge(const glint_scene *scene, int width, int height, const glint_format *format, judgement *total);

/**
 * The contract, as checks: coverage is identical; every channel is within one step, and per fragment within two for one
 * pixel in 10000.
 */
void row_check(const judgement *found, int per_fragment);

#endif
