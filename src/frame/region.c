/* SPDX-License-Identifier: MIT */
/* Region: the part of the screen that a frame draws, and where its tiles lie. */
#include "../pixel/format.h"
#include "frame.h"

glint_status glint_check_region(glint_config *config) {
    glint_rectangle *const region = &config->region;
    const uint8_t *const edge = config->format->edge;
    if (!(region->x | region->y | region->width | region->height)) {
        region->width = (int16_t)config->width;
        region->height = (int16_t)config->height;
    }
    const int32_t right = region->x + region->width, bottom = region->y + region->height;
    if ((region->x | region->y | (region->width - 1) | (region->height - 1) | (config->width - right) |
         (config->height - bottom)) < 0)
        return GLINT_ERROR_REGION;
    const int32_t across = region->x | (right < config->width ? right : 0),
                  down = region->y | (bottom < config->height ? bottom : 0);
    return (across & edge[0]) | (down & edge[1]) ? GLINT_ERROR_REGION : GLINT_OK;
}

/* Tiles from the one with the first of some pixels to the one with the last. */
static uint16_t count_tiles_along(int32_t first, int32_t pixels, unsigned shift) {
    return (uint16_t)(((first + pixels - 1) >> shift) - (first >> shift) + 1);
}

glint_status glint_region_begin(glint_frame *frame) {
    const glint_rectangle *const region = &frame->config.region;
    const glint_status status = glint_check_region(&frame->config);
    if (status != GLINT_OK)
        return status;
    const uint32_t rows = count_tiles_along(region->y, region->height, frame->tile_shift_y);
    frame->first_column = (uint16_t)(region->x >> frame->tile_shift_x);
    frame->first_row = (uint16_t)(region->y >> frame->tile_shift_y);
    frame->tile_columns = count_tiles_along(region->x, region->width, frame->tile_shift_x);
    frame->tile_count = (uint16_t)(frame->tile_columns * rows);
    frame->right = (uint16_t)(region->x + region->width);
    frame->bottom = (uint16_t)(region->y + region->height);
    return GLINT_OK;
}

/* Sets where a tile lies, and how far its part of the region begins from its first pixel. */
static void cut_tile(const glint_frame *frame, uint32_t tile, glint_tile *to, uint32_t *across, uint32_t *down) {
    const glint_config *const config = &frame->config;
    const uint32_t row = tile / frame->tile_columns, column = tile % frame->tile_columns;
    const int x = (int)((column + frame->first_column) << frame->tile_shift_x),
              y = (int)((row + frame->first_row) << frame->tile_shift_y);
    to->x = glint_most(x, config->region.x);
    to->y = glint_most(y, config->region.y);
    to->width = glint_least(x + config->tile_width, frame->right) - to->x;
    to->height = glint_least(y + config->tile_height, frame->bottom) - to->y;
    *across = (uint32_t)(to->x - x);
    *down = (uint32_t)(to->y - y);
}

void glint_tile_find(const glint_frame *frame, const glint_workspace *workspace, uint32_t tile, glint_tile *to) {
    const glint_format *const format = frame->config.format;
    uint32_t across, down;
    cut_tile(frame, tile, to, &across, &down);
    to->stride = workspace->stride;
    to->pixels =
        (uint8_t *)workspace->pixels + down * to->stride + (format->edge[1] ? across : across * format->bits / 8);
    to->depth_stride = frame->config.tile_width;
    to->depth = workspace->depth + down * to->depth_stride + across;
    to->frame = frame;
    to->workspace = workspace;
}

void glint_tile_rectangle(const glint_frame *frame, uint32_t tile, int *x, int *y, int *width, int *height) {
    glint_tile to;
    uint32_t across, down;
    cut_tile(frame, tile, &to, &across, &down);
    *x = to.x;
    *y = to.y;
    *width = to.width;
    *height = to.height;
}

glint_status glint_render_region(glint_renderer *renderer, const glint_scene *scene, const glint_rectangle *region) {
    if (!renderer || !region)
        return GLINT_ERROR_NULL;
    const glint_rectangle whole = renderer->config.region;
    renderer->config.region = *region;
    const glint_status status = glint_render(renderer, scene);
    renderer->config.region = whole;
    return status;
}
