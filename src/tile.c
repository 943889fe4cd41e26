/* SPDX-License-Identifier: MIT */
/* Tile: draws the triangles that a pass lists for one tile. */
#include "frame.h"

/* Compilers call memset even in freestanding code; here the library does. */
void *memset(void *bytes, int value, size_t size);

static uint32_t tile_pixels(const glint_config *config) {
    return (uint32_t)config->tile_width * config->tile_height;
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
    const glint_config *config = &frame->config;
    const glint_colour *background = &frame->scene->background;
    uint32_t colour[1][3] = {
        {(uint32_t)background->r << 7, (uint32_t)background->g << 7, (uint32_t)background->b << 7}};
    if (config->gamma)
        glint_apply_gamma(config->gamma, colour, 1);
    config->format->fill(workspace->pixels, config->tile_width, config->tile_height, colour[0]);
    memset(workspace->depth, 0, tile_pixels(config) * sizeof *workspace->depth);
}

static void draw_clipped(const glint_frame *frame, glint_workspace *workspace, const glint_clipped *clipped) {
    glint_triangle triangle;
    for (int i = 0; i < 3; i++) {
        triangle.corners[i] = &clipped->corners[i];
        triangle.extra[i] = clipped->extra[i];
    }
    triangle.facet = clipped->draw->facets ? clipped->draw->facets[clipped->triangle] : 0;
    glint_raster(frame, workspace, clipped->draw, &triangle);
}

static void draw_triangle(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw, uint32_t i) {
    const uint16_t *indices = draw->triangles[i];
    glint_triangle triangle;
    for (int j = 0; j < 3; j++) {
        triangle.corners[j] = &draw->vertices[indices[j]];
        triangle.extra[j] = draw->extra ? draw->extra[indices[j]] : 0;
    }
    triangle.facet = draw->facets ? draw->facets[i] : 0;
    glint_raster(frame, workspace, draw, &triangle);
}

static void draw_reference(const glint_frame *frame, glint_workspace *workspace, const glint_draw **draw,
                           uint32_t number) {
    if (number > GLINT_TRIANGLES_MAX) {
        const glint_clipped *top = (const glint_clipped *)(const void *)(frame->memory.base + frame->memory.high);
        draw_clipped(frame, workspace, top - 1 - (GLINT_CLIPPED_TOP - number));
        return;
    }
    while (number >= (uint32_t)(*draw)->first + (*draw)->count)
        *draw = (*draw)->next;
    draw_triangle(frame, workspace, *draw, number - (*draw)->first);
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
