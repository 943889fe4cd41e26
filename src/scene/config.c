/* SPDX-License-Identifier: MIT */
/* Config: checks how and where to draw. */
#include "config.h"

#include "../math/numeric.h"

/* Puts the default in place of 0. @return is it a tile's width or height? */
static GLINT_NOINLINE int complete_tile_size(uint16_t *size) {
    if (!*size)
        *size = GLINT_TILE_DEFAULT;
    return *size >= 8 && *size <= GLINT_TILE_MAX && (*size & (*size - 1)) == 0;
}

glint_status glint_check_config(glint_config *config) {
    if (!config->format)
        return GLINT_ERROR_NULL;
    if (config->width < 1 || config->width > GLINT_SIZE_MAX || config->height < 1 || config->height > GLINT_SIZE_MAX)
        return GLINT_ERROR_SIZE;
    return complete_tile_size(&config->tile_width) && complete_tile_size(&config->tile_height) ? GLINT_OK
                                                                                               : GLINT_ERROR_TILE;
}
