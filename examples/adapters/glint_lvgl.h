/* SPDX-License-Identifier: MIT */
/**
 * @file glint_lvgl.h
 * glint in LVGL 9.3 and later: on a canvas, on a canvas with alpha, or straight into what LVGL draws. What cannot be
 * drawn is refused with a warning in LVGL's log.
 */
#ifndef GLINT_LVGL_H
#define GLINT_LVGL_H

#include <glint.h>
#include <lvgl.h>

/** Returns a flush of glint_format_rgb565 into a canvas of LV_COLOR_FORMAT_RGB565. A canvas of another format, or
 * smaller than the screen of the configuration, ends the frame with GLINT_ERROR_FLUSH. */
glint_flush adapter_lvgl_canvas(lv_obj_t *canvas);

/** Returns an overlay that writes pixels that show objects, opaque, into a canvas of LV_COLOR_FORMAT_ARGB8888, and
 * leaves all others clear. It takes glint_format_rgb888, and a flush that returns 0. A canvas that does not fit ends
 * the frame with GLINT_ERROR_PAINT. */
glint_painter adapter_lvgl_alpha(lv_obj_t *canvas);

/** A view shows a model while LVGL draws a widget, in each of its partial areas, over what lies behind it. */
typedef struct adapter_lvgl_view {
    glint_config config; /**< Width and height are the widget's. Format, flush, background, overlay and region are set
                              when it draws: neither the scene's background nor a painter's is visible. */
    const glint_scene *scene;
    glint_status status; /**< Of the last area: glint_render's; GLINT_ERROR_NULL where LVGL has no memory for a layer,
                              GLINT_ERROR_FORMAT where a layer has another format than RGB565, RGB888, XRGB8888 or
                              ARGB8888, or is rotated by a matrix (LV_DRAW_TRANSFORM_USE_MATRIX). */
} adapter_lvgl_view;

/** Draws a view. It is to be added for LV_EVENT_DRAW_MAIN, with an adapter_lvgl_view as user data. Of the widget's
 * styles `opa`, `opa_layered` and transformations count. */
void adapter_lvgl_draw(lv_event_t *event);

#endif
