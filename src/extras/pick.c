/* SPDX-License-Identifier: MIT */
/* Finds the triangle that a pixel shows. It draws that pixel with a kernel that keeps the triangle that passes the
 * depth test last. */
#include "../frame/frame.h"
#include "../raster/depth.h"
#include "../raster/triangle.h"

/* A picker has a workspace, and the result so far. */
typedef struct picker {
    glint_workspace workspace;
    uint32_t column, row; /* of the pixel in its tile */
    int found;
    glint_hit hit;
} picker;

/* Keeps a triangle that is the nearest so far at the pixel. */
static void pick_pixel(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    picker *const p = (picker *)(void *)walk->workspace; /* its first member */
    const glint_draw *draw = walk->draw;
    if (row != (int32_t)p->row || left > (int32_t)p->column || right <= (int32_t)p->column)
        return;
    glint_begin_depth(walk);
    uint16_t *const depth = walk->depth + (p->row << walk->shift) + p->column;
    const int32_t z = glint_most((int32_t)glint_z_at(walk, row, (int32_t)p->column), GLINT_DEPTH_BIAS);
    if (!glint_is_nearest((uint8_t *)depth, (uint32_t)z))
        return;
    const uint32_t number = walk->triangle.index;
    p->found = 1;
    p->hit.object = draw->object;
    p->hit.triangle = draw->first_triangle + (draw->origin ? draw->origin[number] : number);
    p->hit.depth = *depth;
}

static void pick_triangle(glint_row_walk *walk) {
    walk->draw_span = pick_pixel;
    glint_walk_triangle(walk);
}

/* Draws a pass by this function. */
static void pick_pass(glint_frame *frame, picker *p) {
    for (glint_draw *draw = frame->draws; draw; draw = draw->next)
        draw->draw_triangle = pick_triangle;
    frame->has_costly = 0;
    glint_render_tile(frame, &p->workspace, frame->tile_first);
}

/* Returns the square of 8 pixels around the pixel, which no tile divides, nor a byte of any format. */
static glint_rectangle square_around(const glint_config *config, int x, int y) {
    const int left = x & ~7, top = y & ~7;
    return (glint_rectangle){(int16_t)left, (int16_t)top, (int16_t)glint_least(8, config->width - left),
                             (int16_t)glint_least(8, config->height - top)};
}

int glint_pick(glint_renderer *renderer, const glint_scene *scene, int x, int y, glint_hit *hit) {
    if (!renderer || !scene || !hit || !renderer->config.flush.begin)
        return GLINT_ERROR_NULL;
    glint_config config = renderer->config;
    if (x < 0 || y < 0 || x >= config.width || y >= config.height)
        return GLINT_ERROR_REGION;
    config.region = square_around(&config, x, y);
    config.background.paint = config.overlay.paint = 0;
    config.keeps_arena = 0;
    renderer->kept = (glint_kept){0};
    picker p = {.column = (uint32_t)x & (config.tile_width - 1u), .row = (uint32_t)y & (config.tile_height - 1u)};
    glint_frame frame;
    glint_take_buffers(&config, &p.workspace);
    int status = glint_frame_begin(&frame, &config, scene);
    while (status == GLINT_OK && (status = glint_frame_next_pass(&frame)) > 0) {
        pick_pass(&frame, &p);
        status = GLINT_OK;
    }
    if (status < 0)
        return status;
    if (p.found)
        *hit = p.hit;
    return p.found;
}
