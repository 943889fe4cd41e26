/* SPDX-License-Identifier: MIT */
/* Finds the triangle that a pixel shows. It draws that pixel with a kernel that keeps the triangle that passes the
 * depth test last. */
#include "../blend/blend.h"
#include "../frame/frame.h"
#include "../light/wear.h"
#include "../pixel/format.h"
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
    const glint_layer_stage *const layers = walk->frame->config.layers;
    const glint_draw *draw = walk->draw;
    if (row != (int32_t)p->row || left > (int32_t)p->column || right <= (int32_t)p->column)
        return;
    glint_begin_depth(walk);
    uint16_t *const depth = walk->depth + (p->row << walk->shift) + p->column;
    const int32_t z = glint_most((int32_t)glint_z_at(walk, row, (int32_t)p->column), GLINT_DEPTH_BIAS);
    if (glint_has_holes(draw) && draw->texture->type->stage->is_hole(walk, row, (int32_t)p->column))
        return;
    if (layers && !layers->covers(glint_object_at(walk->frame, draw->object)->material, p->column, p->row))
        return;
    if (!glint_is_nearest((uint8_t *)depth, (uint32_t)z))
        return;
    const uint32_t number = walk->triangle.index;
    p->found = 1;
    p->hit.object = (uint32_t)(glint_object_at(walk->frame, draw->object) - walk->frame->scene->objects);
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

/* Begins the frame of a pixel. This is out of line, so that its configuration is not on the stack while it is drawn. */
static GLINT_NOINLINE int begin_pick(glint_frame *frame, picker *p, const glint_config *config,
                                     const glint_scene *scene, int x, int y) {
    glint_config as = *config;
    as.region = square_around(config, x, y);
    p->column = (uint32_t)x & (config->tile_width - 1u);
    p->row = (uint32_t)y & (config->tile_height - 1u);
    glint_take_buffers(&as, &p->workspace);
    return glint_frame_begin(frame, &as, scene);
}

/* Finds what a pixel shows by a configuration of one sample a pixel. @return as glint_pick */
static int pick_at(const glint_config *config, const glint_scene *scene, int has_long_slopes, int x, int y,
                   glint_hit *hit) {
    picker p = {0};
    glint_frame frame;
    int status = begin_pick(&frame, &p, config, scene, x, y);
    frame.has_long_slopes = (uint8_t)has_long_slopes;
    while (status == GLINT_OK && (status = glint_frame_next_pass(&frame)) > 0) {
        pick_pass(&frame, &p);
        status = GLINT_OK;
    }
    if (status < 0)
        return status;
    *hit = p.hit;
    return p.found;
}

int glint_pick(glint_renderer *renderer, const glint_scene *scene, int x, int y, glint_hit *hit) {
    if (!renderer || !scene || !hit || !renderer->config.flush.begin)
        return GLINT_ERROR_NULL;
    glint_config config = renderer->config;
    if (x < 0 || y < 0 || x >= config.width || y >= config.height)
        return GLINT_ERROR_REGION;
    config.background.paint = config.overlay.paint = 0;
    config.keeps_arena = 0;
    renderer->kept = (glint_kept){0};
    const int shift = config.samples != 0, has_long_slopes = glint_has_long_slopes(&config);
    if (shift)
        config.samples->enlarge(&config);
    glint_hit nearest = {0, 0, 0}, here;
    int found = 0;
    for (int i = 0; i < 1 << 2 * shift; i++) {
        const int status =
            pick_at(&config, scene, has_long_slopes, (x << shift) + (i & 1), (y << shift) + (i >> 1), &here);
        if (status < 0)
            return status;
        if (status && here.depth > nearest.depth)
            nearest = here;
        found |= status;
    }
    if (found)
        *hit = nearest;
    return found;
}
