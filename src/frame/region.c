/* SPDX-License-Identifier: MIT */
/* Region: the part of the screen that a frame draws, and where its tiles lie. */
#include "../pixel/format.h"
#include "frame.h"

/* Does a region's edge lie between bytes? The screen's own edge does. */
static int is_between_bytes(int32_t edge, int32_t step, int32_t size) {
    return (edge & (step - 1)) == 0 || edge == size;
}

glint_status glint_check_region(glint_config *config) {
    glint_rectangle *const region = &config->region;
    const glint_format *format = config->format;
    const int32_t step = format->page > 1 || !(format->bits & 7) ? 1 : format->bits == 1 ? 8 : 2;
    if (!(region->x | region->y | region->width | region->height)) {
        region->width = (int16_t)config->width;
        region->height = (int16_t)config->height;
    }
    const int32_t right = region->x + region->width, bottom = region->y + region->height;
    if (region->x < 0 || region->y < 0 || region->width < 1 || region->height < 1 || right > config->width ||
        bottom > config->height)
        return GLINT_ERROR_REGION;
    return is_between_bytes(region->x, step, 0) && is_between_bytes(right, step, config->width) &&
                   is_between_bytes(region->y, format->page, 0) &&
                   is_between_bytes(bottom, format->page, config->height)
               ? GLINT_OK
               : GLINT_ERROR_REGION;
}

/* Tiles from the one with the first of some pixels to the one with the last. */
static uint16_t count_tiles(int32_t first, int32_t pixels, unsigned shift) {
    return (uint16_t)(((first + pixels - 1) >> shift) - (first >> shift) + 1);
}

glint_status glint_region_begin(glint_frame *frame) {
    const glint_rectangle *const region = &frame->config.region;
    const glint_status status = glint_check_region(&frame->config);
    if (status != GLINT_OK)
        return status;
    const uint32_t rows = count_tiles(region->y, region->height, frame->tile_shift_y);
    frame->first_column = (uint16_t)(region->x >> frame->tile_shift_x);
    frame->first_row = (uint16_t)(region->y >> frame->tile_shift_y);
    frame->tile_columns = count_tiles(region->x, region->width, frame->tile_shift_x);
    frame->tile_count = (uint16_t)(frame->tile_columns * rows);
    return GLINT_OK;
}

/* Where pixels of a tile that begins at `first` lie, between `from` and `end`. */
static void cut_tile(int32_t first, int32_t size, int32_t from, int32_t end, int *place, int *count) {
    *place = glint_most(first, from);
    *count = glint_least(first + size, end) - *place;
}

void glint_tile_rectangle(const glint_frame *frame, uint32_t tile, int *x, int *y, int *width, int *height) {
    const glint_config *const config = &frame->config;
    const glint_rectangle *const region = &config->region;
    const uint32_t column = tile % frame->tile_columns + frame->first_column,
                   row = tile / frame->tile_columns + frame->first_row;
    cut_tile((int32_t)(column << frame->tile_shift_x), config->tile_width, region->x, region->x + region->width, x,
             width);
    cut_tile((int32_t)(row << frame->tile_shift_y), config->tile_height, region->y, region->y + region->height, y,
             height);
}

void glint_tile_find(const glint_frame *frame, const glint_workspace *workspace, uint32_t tile, glint_tile *to) {
    const glint_format *const format = frame->config.format;
    glint_tile_rectangle(frame, tile, &to->x, &to->y, &to->width, &to->height);
    const size_t column = (uint32_t)to->x & (frame->config.tile_width - 1u),
                 row = (uint32_t)to->y & (frame->config.tile_height - 1u);
    to->stride = workspace->stride;
    to->pixels = (uint8_t *)workspace->pixels + row * workspace->stride +
                 (format->page > 1 ? column : column * format->bits / 8);
    to->depth_stride = frame->config.tile_width;
    to->depth = workspace->depth + row * to->depth_stride + column;
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
