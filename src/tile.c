/* SPDX-License-Identifier: MIT */
/* Tile: draws the triangles that a pass lists for one tile. */
#include "frame.h"

size_t glint_row_bytes(const glint_format *format, uint32_t width) {
    return ((size_t)width * format->bits + 7) / 8;
}

static uint32_t tile_pixels(const glint_config *config) {
    return (uint32_t)config->tile_width * config->tile_height;
}

size_t glint_workspace_size(const glint_config *config) {
    glint_config full = *config;
    if (glint_check_config(&full) != GLINT_OK)
        return 0;
    return sizeof(glint_fragments) + tile_pixels(&full) * sizeof(uint16_t) +
           glint_row_bytes(full.format, full.tile_width) * full.tile_height;
}

void glint_workspace_init(glint_workspace *workspace, const glint_config *config, void *memory) {
    glint_config full = *config;
    uint8_t *bytes = memory;
    glint_check_config(&full);
    workspace->fragments = memory;
    workspace->depth = (uint16_t *)(void *)(bytes + sizeof(glint_fragments));
    workspace->pixels = workspace->depth + tile_pixels(&full);
    workspace->stride = glint_row_bytes(full.format, full.tile_width);
}

static void clear(const glint_frame *frame, glint_workspace *workspace) {
    const glint_colour *background = &frame->scene->background;
    const uint32_t colour[3] = {(uint32_t)background->r << 7, (uint32_t)background->g << 7,
                                (uint32_t)background->b << 7};
    uint32_t count = tile_pixels(&frame->config);
    frame->config.format->fill(workspace->pixels, count, colour);
    for (uint32_t i = 0; i < count; i++)
        workspace->depth[i] = 0;
}

static void draw_reference(const glint_frame *frame, glint_workspace *workspace, const glint_draw **draw,
                           uint32_t number) {
    if (number > GLINT_TRIANGLES_MAX) {
        const glint_clipped *top = (const glint_clipped *)(const void *)(frame->memory.base + frame->memory.high);
        const glint_clipped *clipped = top - 1 - (GLINT_CLIPPED_TOP - number);
        const glint_vertex *const corners[3] = {&clipped->corners[0], &clipped->corners[1], &clipped->corners[2]};
        glint_raster(frame, workspace, clipped->draw, corners);
        return;
    }
    while (number >= (uint32_t)(*draw)->first + (*draw)->count)
        *draw = (*draw)->next;
    const uint16_t *indices = (*draw)->triangles[number - (*draw)->first];
    const glint_vertex *vertices = (*draw)->vertices;
    const glint_vertex *const corners[3] = {&vertices[indices[0]], &vertices[indices[1]], &vertices[indices[2]]};
    glint_raster(frame, workspace, *draw, corners);
}

int glint_render_tile(const glint_frame *frame, glint_workspace *workspace, uint32_t tile) {
    int x, y, width, height;
    glint_tile_rectangle(frame, tile, &x, &y, &width, &height);
    workspace->fragments->count = 0;
    workspace->fragments->tile_x = x;
    workspace->fragments->tile_y = y;
    workspace->fragments->tile_width = width;
    workspace->fragments->tile_height = height;
    if (frame->starts)
        clear(frame, workspace);
    const glint_draw *draw = frame->draws;
    uint32_t here = frame->lists[tile - frame->tile_first].head;
    for (; here != GLINT_LIST_END; here = frame->references[here].next)
        draw_reference(frame, workspace, &draw, frame->references[here].triangle);
    return frame->ends;
}
