/* SPDX-License-Identifier: MIT */
/* Config: checks how and where to draw, and tells what a tile takes. */
#include "frame.h"

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

size_t glint_row_bytes(const glint_format *format, uint32_t width) {
    return ((size_t)width * format->bits + 7) / 8;
}

size_t glint_workspace_size(const glint_config *config) {
    glint_config full = *config;
    if (glint_check_config(&full) != GLINT_OK)
        return 0;
    const size_t row = full.tile_width * sizeof(int32_t[3]);
    return (row < sizeof(glint_gathered) ? sizeof(glint_gathered) : row) +
           (size_t)full.tile_width * full.tile_height * sizeof(uint16_t) +
           glint_row_bytes(full.format, full.tile_width) * full.tile_height;
}

size_t glint_tile_buffers_size(const glint_config *config) {
    size_t second = config->flush.wait ? glint_row_bytes(config->format, config->tile_width) * config->tile_height : 0;
    return GLINT_ALIGNED(glint_workspace_size(config) + second); /* to draw into while the first is sent */
}
