/* SPDX-License-Identifier: MIT */
/** @file config.h How and where a frame is drawn. */
#ifndef GLINT_CONFIG_H
#define GLINT_CONFIG_H

#include "../glint.h"

/** Tile width and height where the configuration says 0. */
#define GLINT_TILE_DEFAULT 32

/** Largest tile width and height. */
#define GLINT_TILE_MAX 64

/** Fills in defaults. @return GLINT_ERROR_NULL, _SIZE or _TILE. */
glint_status glint_check_config(glint_config *config);

#endif
