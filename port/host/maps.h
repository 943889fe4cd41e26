/* SPDX-License-Identifier: MIT */
/**
 * @file maps.h
 * A frame, and the maps of it that options ask for: how each pixel was lit, and how far it is from double precision.
 */
#ifndef GLINT_HOST_MAPS_H
#define GLINT_HOST_MAPS_H

#include "view.h"

/**
 * Draws a scene as view_draw does, writes the maps, and prints what their colours stand for, a `name value` a line.
 * @param target set up by this, the caller frees it; untouched when the result is false
 */
bool maps_draw(const glint_scene *scene, const host_settings *settings, framebuffer *target, glint_stats *stats,
               host_problem *problem);

#endif
