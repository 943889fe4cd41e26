/* SPDX-License-Identifier: MIT */
/**
 * @file surfaces.h
 * Scenes for what evaluation, mesh colours and lights with positions get wrong: each is drawn per fragment, per vertex
 * and per facet, by both viewers.
 */
#ifndef GLINT_SURFACES_H
#define GLINT_SURFACES_H

#include "scenes.h"

extern const scene_definition surface_definitions[];
extern const unsigned surface_count;

/** A random scene with lights of all types, models, flags, evaluations and mesh colours. */
void surface_build_random(test_scene *scene, uint32_t seed);

#endif
