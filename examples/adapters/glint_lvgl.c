/* SPDX-License-Identifier: MIT */
#include "glint_lvgl.h"

#include <string.h>

/* ---- A canvas ---- */

/* Is there a buffer of this format and at least this size? */
static int takes(const lv_draw_buf_t *buffer, lv_color_format_t format, int width, int height) {
    if (buffer && buffer->header.cf == format && (int)buffer->header.w >= width && (int)buffer->header.h >= height)
        return 1;
    LV_LOG_WARN("glint: the canvas has no buffer, another format, or is smaller than the screen");
    return 0;
}

static int to_canvas(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    lv_obj_t *const canvas = context;
    const lv_draw_buf_t *const to = lv_canvas_get_draw_buf(canvas);

    if (!takes(to, LV_COLOR_FORMAT_RGB565, x + width, y + height))
        return 1;
    for (int row = 0; row < height; row++)
        memcpy(to->data + (size_t)(y + row) * to->header.stride + 2 * (size_t)x,
               (const uint8_t *)pixels + (size_t)row * stride, 2 * (size_t)width);
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

    if (!takes(buffer, LV_COLOR_FORMAT_ARGB8888, tile->x + tile->width, tile->y + tile->height))
        return 1;
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

/* A layer's buffer, the widget's corner as seen from the buffer's, and how opaque the model is, 0 to 255. */
typedef struct target {
    const lv_draw_buf_t *buffer;
    int left, top;
    unsigned opacity;
} target;

/* Mixes two levels by their weights, of which one at least is not 0. */
static unsigned mix(unsigned over, unsigned under, unsigned over_weight, unsigned under_weight) {
    const unsigned sum = over_weight + under_weight;

    return (over * over_weight + under * under_weight + sum / 2) / sum;
}

static void mix_565(uint16_t *to, const uint16_t *from, unsigned opacity) {
    const unsigned over = *from, under = *to, rest = 255 - opacity;

    *to = (uint16_t)(mix(over >> 11, under >> 11, opacity, rest) << 11 |
                     mix(over >> 5 & 63, under >> 5 & 63, opacity, rest) << 5 |
                     mix(over & 31, under & 31, opacity, rest));
}

/* Blue, green, red and, where the layer has it, alpha; colours are not premultiplied. */
static void mix_888(uint8_t *to, const uint8_t *from, unsigned opacity, int has_alpha) {
    const unsigned rest = has_alpha ? (255 - opacity) * to[3] / 255 : 255 - opacity;

    if (opacity + rest == 0)
        return;
    for (int channel = 0; channel < 3; channel++)
        to[channel] = (uint8_t)mix(from[2 - channel], to[channel], opacity, rest);
    if (has_alpha)
        to[3] = (uint8_t)(opacity + rest);
}

static int to_layer(void *context, const glint_tile *tile) {
    const target *const t = context;
    const lv_color_format_t format = (lv_color_format_t)t->buffer->header.cf;
    const int is_565 = format == LV_COLOR_FORMAT_RGB565;
    const size_t from_bytes = is_565 ? 2 : 3, to_bytes = is_565 ? 2 : format == LV_COLOR_FORMAT_RGB888 ? 3 : 4;

    for (int y = 0; y < tile->height; y++) {
        const uint8_t *from = (const uint8_t *)tile->pixels + (size_t)y * tile->stride;
        const uint16_t *const depth = tile->depth + (size_t)y * tile->depth_stride;
        uint8_t *to = t->buffer->data + (size_t)(tile->y + t->top + y) * t->buffer->header.stride +
                      to_bytes * (size_t)(tile->x + t->left);

        for (int x = 0; x < tile->width; x++, from += from_bytes, to += to_bytes) {
            if (depth[x] && is_565)
                mix_565((uint16_t *)(void *)to, (const uint16_t *)(const void *)from, t->opacity);
            else if (depth[x])
                mix_888(to, from, t->opacity, format == LV_COLOR_FORMAT_ARGB8888);
        }
    }
    return 0;
}

static int send_nothing(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context, (void)x, (void)y, (void)width, (void)height, (void)pixels, (void)stride;
    return 0;
}

static glint_status refuse(glint_status status, const char *sentence) {
    (void)sentence; /* LV_USE_LOG may be 0 */
    LV_LOG_WARN("glint: %s", sentence);
    return status;
}

/* Prepares the layer's buffer, with what LVGL has drawn behind the widget. */
static glint_status open_layer(lv_layer_t *layer) {
    if (!lv_draw_layer_alloc_buf(layer))
        return refuse(GLINT_ERROR_NULL, "LVGL has no memory for the layer of a view");
#if LV_DRAW_TRANSFORM_USE_MATRIX
    if (!lv_matrix_is_identity(&layer->matrix))
        return refuse(GLINT_ERROR_FORMAT, "a view is not drawn through a matrix");
#endif
    switch (layer->draw_buf->header.cf) {
    case LV_COLOR_FORMAT_RGB565:
    case LV_COLOR_FORMAT_RGB888:
    case LV_COLOR_FORMAT_XRGB8888:
    case LV_COLOR_FORMAT_ARGB8888:
        break;
    default:
        return refuse(GLINT_ERROR_FORMAT, "a view is not drawn into a layer of this format");
    }
    while (layer->draw_task_head) {
        lv_draw_dispatch_wait_for_request();
        lv_draw_dispatch();
    }
    return GLINT_OK;
}

static glint_status draw(adapter_lvgl_view *view, lv_layer_t *layer, const lv_area_t *widget, const lv_area_t *shown) {
    glint_status status = open_layer(layer);
    glint_config config = view->config;
    glint_renderer renderer;

    if (status != GLINT_OK)
        return status;
    target to = {layer->draw_buf, (int)(widget->x1 - layer->buf_area.x1), (int)(widget->y1 - layer->buf_area.y1),
                 layer->opa};
    config.format = layer->draw_buf->header.cf == LV_COLOR_FORMAT_RGB565 ? &glint_format_rgb565 : &glint_format_rgb888;
    config.flush = (glint_flush){.begin = send_nothing};
    config.background = (glint_painter){0};
    config.overlay = (glint_painter){to_layer, &to};
    config.region = (glint_rectangle){(int16_t)(shown->x1 - widget->x1), (int16_t)(shown->y1 - widget->y1),
                                      (int16_t)lv_area_get_width(shown), (int16_t)lv_area_get_height(shown)};
    status = glint_init(&renderer, &config);
    if (status == GLINT_OK)
        status = glint_render(&renderer, view->scene);
    return status == GLINT_OK ? status : refuse(status, glint_strerror(status));
}

void adapter_lvgl_draw(lv_event_t *event) {
    adapter_lvgl_view *const view = lv_event_get_user_data(event);
    lv_layer_t *const layer = lv_event_get_layer(event);
    lv_area_t widget, shown;

    if (!layer) /* of another event */
        return;
    lv_obj_get_coords(lv_event_get_target_obj(event), &widget);
    shown.x1 = LV_MAX(widget.x1, layer->_clip_area.x1);
    shown.y1 = LV_MAX(widget.y1, layer->_clip_area.y1);
    shown.x2 = LV_MIN(widget.x2, layer->_clip_area.x2);
    shown.y2 = LV_MIN(widget.y2, layer->_clip_area.y2);
    if (shown.x1 > shown.x2 || shown.y1 > shown.y2)
        return;
    view->status = draw(view, layer, &widget, &shown);
}
