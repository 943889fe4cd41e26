/* SPDX-License-Identifier: MIT */
/* Divides a scene into passes, each of which holds some tiles' triangles, or some triangles of one tile. */
#include "frame.h"

#include "../blend/blend.h"
#include "../light/corners.h"
#include "../light/evaluation.h"
#include "../pixel/format.h"

static unsigned tile_shift(uint16_t size) {
    return 31u - glint_leading_zeros(size);
}

/* Prepares one shading for each distinct material, that of the last frame where it is still there. */
static glint_status prepare_materials(glint_frame *frame, const glint_kept *kept) {
    for (uint32_t i = 0; i < frame->scene->object_count; i++) {
        if (!glint_is_first_of_material(frame->scene, i))
            continue;
        glint_shading *shading = glint_take(&frame->memory, sizeof *shading);
        if (!shading)
            return GLINT_ERROR_ARENA;
        if (!frame->shading)
            frame->shading = shading;
        if (frame->shading != kept->shadings || frame->shading_count >= kept->count)
            *shading = (glint_shading){0};
        frame->shading_count++;
        glint_status status = glint_prepare_shading(frame, shading, frame->scene->objects[i].material);
        if (status != GLINT_OK)
            return status;
    }
    return GLINT_OK;
}

static int has_least_room(const glint_frame *frame) {
    return frame->memory.high - frame->memory.low >= frame->least_room;
}

/* Returns how many transforms may wait in the arena, all of them beyond its first `end` bytes. One always may. */
static uint32_t count_waiting(const glint_frame *frame, size_t end) {
    const size_t room = end < frame->memory.high ? frame->memory.high - end : 0;
    const size_t most = room / sizeof(glint_transform);
    return GLINT_SMALL || most < 1             ? 1
           : most < frame->scene->object_count ? (uint32_t)most
                                               : frame->scene->object_count;
}

size_t glint_corners_size(const glint_scene *scene) {
    for (uint32_t i = 0; i < scene->object_count; i++)
        if (scene->objects[i].evaluation && scene->objects[i].evaluation->lit_at != GLINT_LIT_AT_FRAGMENTS)
            return offsetof(glint_corner_lights, lights) + scene->light_count * sizeof(glint_corner_light);
    return 0;
}

/* Takes memory for the lights at corners, if any are lit. @return 0 when the arena is too small */
static int take_corner_lights(glint_frame *frame) {
    const size_t size = glint_corners_size(frame->scene);
    if (!size)
        return 1;
    frame->corners = glint_take(&frame->memory, size);
    if (frame->corners)
        frame->corners->object = 0;
    return frame->corners != 0;
}

static glint_status prepare_scene(glint_frame *frame, const glint_kept *kept) {
    glint_status status = glint_check_scene(&frame->config, frame->scene);
    if (status != GLINT_OK)
        return status;
    glint_view *view = glint_take(&frame->memory, glint_view_size(frame->scene));
    if (!view)
        return GLINT_ERROR_ARENA;
    frame->view = view;
    frame->least_room = GLINT_LEAST_ROOM;
    if (!has_least_room(frame)) /* the last transform waits there */
        return GLINT_ERROR_ARENA;
    const size_t taken = kept->end > frame->memory.low ? kept->end : frame->memory.low;
    frame->waiting = count_waiting(frame, taken);
    status = glint_prepare_view(view, &frame->config, frame->scene, glint_last_transform(frame), frame->waiting);
    if (status == GLINT_OK)
        status = prepare_materials(frame, kept);
    if (status == GLINT_OK && !take_corner_lights(frame))
        status = GLINT_ERROR_ARENA;
    if (status == GLINT_OK && frame->config.layers)
        status = frame->config.layers->prepare(frame);
    if (status == GLINT_OK && frame->scene->fog)
        status = frame->scene->fog->type->prepare(frame);
    if (status == GLINT_OK && glint_find_suns(frame->scene))
        status = glint_find_suns(frame->scene)->prepare(frame);
    if (status != GLINT_OK)
        return status;
    frame->prepared_end = frame->memory.low;
    frame->stats.skipped = view->skipped;
    return has_least_room(frame) ? GLINT_OK : GLINT_ERROR_ARENA;
}

/* Counts the tiles from the one with the first of some pixels to the one with the last. */
static uint16_t count_tiles_along(int32_t first, int32_t pixels, unsigned shift) {
    return (uint16_t)(((first + pixels - 1) >> shift) - (first >> shift) + 1);
}

static void begin_region(glint_frame *frame) {
    const glint_rectangle *const region = &frame->config.region;
    const uint32_t rows = count_tiles_along(region->y, region->height, frame->tile_shift_y);
    frame->first_column = (uint16_t)(region->x >> frame->tile_shift_x);
    frame->first_row = (uint16_t)(region->y >> frame->tile_shift_y);
    frame->tile_columns = count_tiles_along(region->x, region->width, frame->tile_shift_x);
    frame->tile_count = (uint16_t)(frame->tile_columns * rows);
    frame->right = (uint16_t)(region->x + region->width);
    frame->bottom = (uint16_t)(region->y + region->height);
}

glint_status glint_frame_grid(glint_frame *frame, const glint_config *config, const glint_scene *scene) {
    *frame = (glint_frame){0};
    frame->config = *config;
    frame->scene = scene;
    glint_status status = glint_check_config(&frame->config);
    if (status == GLINT_OK)
        status = glint_check_region(&frame->config);
    if (status != GLINT_OK)
        return status;
    frame->samples = config->samples;
    frame->has_long_slopes = (uint8_t)glint_has_long_slopes(config);
    if (frame->samples)
        frame->samples->enlarge(&frame->config);
    frame->tile_shift_x = (uint8_t)tile_shift(frame->config.tile_width);
    frame->tile_shift_y = (uint8_t)tile_shift(frame->config.tile_height);
    begin_region(frame);
    frame->pass_tiles = frame->tile_count;
    return GLINT_OK;
}

static glint_status begin_frame(glint_frame *frame, const glint_config *config, const glint_scene *scene) {
    glint_kept kept = {0};
    if (!config || !scene || !config->arena)
        return GLINT_ERROR_NULL;
    if (!GLINT_SMALL && config->keeps_arena)
        kept = (glint_kept){frame->shading, frame->shading_count, frame->prepared_end};
    const glint_status status = glint_frame_grid(frame, config, scene);
    if (status != GLINT_OK)
        return status;
    if (config->arena_size < GLINT_ALIGNMENT)
        return GLINT_ERROR_ARENA;
    frame->memory.base = glint_align(config->arena);
    frame->memory.high = (config->arena_size - (GLINT_ALIGNMENT - 1)) & ~(GLINT_ALIGNMENT - 1);
    return prepare_scene(frame, &kept);
}

glint_status glint_frame_begin(glint_frame *frame, const glint_config *config, const glint_scene *scene) {
    if (!frame)
        return GLINT_ERROR_NULL;
    const glint_status status = begin_frame(frame, config, scene);
    if (status != GLINT_OK)
        *frame = (glint_frame){0}; /* a failed frame must not be drawn, nor kept */
    return status;
}

/* Goes on where the last pass stopped. @return 0 when the frame is done */
static int advance(glint_frame *frame) {
    if (frame->stats.passes == 0)
        return 1;
    if (frame->ends) {
        frame->tile_first = frame->tile_end;
        frame->object = 0;
        frame->triangle = 0;
    }
    return frame->tile_first < frame->tile_count;
}

/* Returns how many tiles a pass may have when there was no room for so many. Where all is loaded, these are half of
 * the frame's tiles, then a quarter, at fixed places. */
static uint32_t find_fewer(const glint_frame *frame, uint32_t tiles) {
    const uint32_t quarter = glint_quarter_of_tiles(frame);
    if (!frame->resident || tiles <= quarter)
        return (tiles + 1) / 2;
    return tiles > 2 * quarter ? 2 * quarter : quarter;
}

/* Bins for as many tiles as the arena allows, and loads parts where these would be few. A single tile may get a part
 * of the triangles. */
static glint_status bin_tiles(glint_frame *frame) {
    const uint32_t object = frame->object, triangle = frame->triangle;
    int complete = 0;
    for (;;) {
        const uint32_t end = (uint32_t)frame->tile_first + frame->pass_tiles;
        const glint_stats before = frame->stats;
        frame->tile_end = (uint16_t)(end < frame->loaded_end ? end : frame->loaded_end);
        glint_status status = glint_bin(frame, &complete);
        if (status != GLINT_OK)
            return status;
        if (complete || glint_pass_tiles(frame) == 1)
            break;
        frame->pass_tiles = (uint16_t)find_fewer(frame, glint_pass_tiles(frame));
        frame->object = object;
        frame->triangle = triangle;
        frame->stats = before;
        if (frame->resident && frame->pass_tiles < glint_quarter_of_tiles(frame)) {
            frame->resident = 0;
            status = glint_load(frame);
            if (status != GLINT_OK)
                return status;
        }
    }
    frame->ends = complete && frame->covers_end;
    if (!complete && frame->object == object && frame->triangle == triangle)
        return GLINT_ERROR_ARENA;
    return GLINT_OK;
}

/* Loads what a pass draws, unless it is loaded, and bins it. */
static glint_status begin_pass(glint_frame *frame) {
    const int is_there = frame->resident || (frame->tile_first < frame->loaded_end && frame->ends);
    const glint_status status = is_there ? GLINT_OK : glint_load(frame);
    return status == GLINT_OK ? bin_tiles(frame) : status;
}

int glint_frame_next_pass(glint_frame *frame) {
    if (!frame || !frame->scene)
        return GLINT_ERROR_NULL;
    if (!advance(frame))
        return 0;
    frame->starts = frame->object == 0 && frame->triangle == 0;
    const glint_status status = begin_pass(frame);
    if (status != GLINT_OK)
        return status;
    const size_t used = frame->memory.high - glint_free_bytes(frame);
    if (used > frame->stats.arena_used)
        frame->stats.arena_used = (uint32_t)used;
    frame->stats.references += frame->reference_count - glint_pass_tiles(frame);
    frame->stats.passes++;
    frame->stats.tiles += frame->ends ? glint_pass_tiles(frame) : 0;
    return 1;
}
