/* SPDX-License-Identifier: MIT */
/* Buffers: what drawing a tile takes. */
#include "../light/shade.h"
#include "../pixel/format.h"
#include "frame.h"

size_t glint_row_bytes(const glint_format *format, uint32_t width) {
    return ((size_t)width * format->bits + 7) / 8;
}

size_t glint_workspace_size(const glint_config *config) {
    glint_config full = *config;
    if (glint_check_config(&full) != GLINT_OK)
        return 0;
    const size_t rows = 2 * full.tile_width * sizeof(int32_t[3]);
    return (rows < sizeof(glint_gathered) ? sizeof(glint_gathered) : rows) +
           (size_t)full.tile_width * full.tile_height * sizeof(uint16_t) +
           glint_row_bytes(full.format, full.tile_width) * full.tile_height;
}

size_t glint_tile_buffers_size(const glint_config *config) {
    size_t second = config->flush.wait ? glint_row_bytes(config->format, config->tile_width) * config->tile_height : 0;
    return GLINT_ALIGNED(glint_workspace_size(config) + second); /* to draw into while the first is sent */
}
