/* SPDX-License-Identifier: MIT */
#include "lvgl.h"

#include <string.h>

static int copy(const lv_draw_buf_t *to, int x, int y, int width, int height, const void *pixels, size_t stride) {
    for (int row = 0; row < height; row++)
        memcpy(to->data + (size_t)(y + row) * to->header.stride + 2 * (size_t)x,
               (const uint8_t *)pixels + (size_t)row * stride, 2 * (size_t)width);
    return 0;
}

/* ---- A canvas ---- */

static int to_canvas(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    lv_obj_t *const canvas = context;

    copy(lv_canvas_get_draw_buf(canvas), x, y, width, height, pixels, stride);
    lv_obj_invalidate(canvas);
    return 0;
}

glint_flush adapter_lvgl_canvas(lv_obj_t *canvas) {
    return (glint_flush){.begin = to_canvas, .context = canvas};
}

/* ---- A canvas with alpha ---- */

/* ARGB8888 is blue, green, red, alpha in memory. */
static int to_alpha(void *context, const glint_tile *tile) {
    lv_obj_t *const canvas = context;
    const lv_draw_buf_t *const buffer = lv_canvas_get_draw_buf(canvas);

    for (int y = 0; y < tile->height; y++) {
        const uint8_t *from = (const uint8_t *)tile->pixels + (size_t)y * tile->stride;
        const uint16_t *const depth = tile->depth + (size_t)y * tile->depth_stride;
        uint8_t *to = buffer->data + (size_t)(tile->y + y) * buffer->header.stride + 4 * (size_t)tile->x;

        for (int x = 0; x < tile->width; x++, from += 3, to += 4) {
            const uint8_t shows = depth[x] ? 255 : 0;

            to[0] = from[2] & shows, to[1] = from[1] & shows, to[2] = from[0] & shows, to[3] = shows;
        }
    }
    lv_obj_invalidate(canvas);
    return 0;
}

glint_painter adapter_lvgl_alpha(lv_obj_t *canvas) {
    return (glint_painter){to_alpha, canvas};
}

/* ---- While LVGL draws ---- */

/* The widget's corner, seen from that of the layer's buffer. */
typedef struct target {
    const lv_draw_buf_t *buffer;
    int left, top;
} target;

static int to_layer(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const target *const t = context;

    return copy(t->buffer, x + t->left, y + t->top, width, height, pixels, stride);
}

/* What LVGL has drawn there. */
static int from_layer(void *context, const glint_tile *tile) {
    const target *const t = context;

    for (int row = 0; row < tile->height; row++)
        memcpy((uint8_t *)tile->pixels + (size_t)row * tile->stride,
               t->buffer->data + (size_t)(tile->y + t->top + row) * t->buffer->header.stride +
                   2 * (size_t)(tile->x + t->left),
               2 * (size_t)tile->width);
    return 0;
}

void adapter_lvgl_draw(lv_event_t *event) {
    adapter_lvgl_view *const view = lv_event_get_user_data(event);
    lv_layer_t *const layer = lv_event_get_layer(event);
    glint_config config = view->config;
    lv_area_t widget, shown;
    glint_renderer renderer;

    lv_obj_get_coords(lv_event_get_target_obj(event), &widget);
    if (!lv_area_intersect(&shown, &widget, &layer->_clip_area))
        return;
    while (layer->draw_task_head) { /* what lies behind is to be in the buffer */
        lv_draw_dispatch_wait_for_request();
        lv_draw_dispatch();
    }
    target to = {layer->draw_buf, (int)(widget.x1 - layer->buf_area.x1), (int)(widget.y1 - layer->buf_area.y1)};
    config.format = &glint_format_rgb565;
    config.flush = (glint_flush){.begin = to_layer, .context = &to};
    config.background = (glint_painter){from_layer, &to};
    config.region = (glint_rectangle){(int16_t)(shown.x1 - widget.x1), (int16_t)(shown.y1 - widget.y1),
                                      (int16_t)lv_area_get_width(&shown), (int16_t)lv_area_get_height(&shown)};
    view->status = glint_init(&renderer, &config);
    if (view->status == GLINT_OK)
        view->status = glint_render(&renderer, view->scene);
}
