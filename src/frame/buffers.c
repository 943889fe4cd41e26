/* SPDX-License-Identifier: MIT */
/* Buffers: what drawing a tile takes. */
#include "../light/lamps.h"
#include "../pixel/format.h"
#include "frame.h"

size_t glint_row_bytes(const glint_format *format, uint32_t width) {
    return ((size_t)width * format->bits + 7) / 8;
}

/* Bytes of a tile's pixels. */
static size_t size_pixels(const glint_config *config) {
    return glint_row_bytes(config->format, config->tile_width) * config->tile_height;
}

/* Bytes of its depth, and of rows. */
static size_t size_depth(const glint_config *config) {
    const size_t rows = 2 * config->tile_width * sizeof(int32_t[3]);
    return (rows < sizeof(glint_lamps) ? sizeof(glint_lamps) : rows) +
           (size_t)config->tile_width * config->tile_height * sizeof(uint16_t);
}

size_t glint_workspace_size(const glint_config *config) {
    if (!config)
        return 0;
    glint_config full = *config;
    return glint_check_config(&full) == GLINT_OK ? size_depth(&full) + size_pixels(&full) : 0;
}

size_t glint_second_pixels(const glint_config *config) {
    const size_t size = size_pixels(config);
    return config->pixels ? (size + GLINT_CACHE_LINE - 1) / GLINT_CACHE_LINE * GLINT_CACHE_LINE : size;
}

/* One tile is drawn while another is sent. */
static size_t count_tiles(const glint_config *config) {
    return config->flush.wait ? 2 : 1;
}

size_t glint_pixels_need(const glint_config *config) {
    if (!config)
        return 0;
    glint_config full = *config;
    full.pixels = &full; /* anything but null */
    return glint_check_config(&full) == GLINT_OK ? glint_second_pixels(&full) * count_tiles(&full) : 0;
}

size_t glint_tile_buffers_size(const glint_config *config) {
    const size_t pixels = config->pixels ? 0 : count_tiles(config) * size_pixels(config);
    return GLINT_ALIGNED(size_depth(config) + pixels);
}
