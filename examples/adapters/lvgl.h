/* SPDX-License-Identifier: MIT */
/**
 * @file lvgl.h
 * glint in LVGL 9: on a canvas, on a canvas with alpha, or straight into what LVGL draws. All with LV_COLOR_DEPTH 16
 * and glint_format_rgb565.
 */
#ifndef ADAPTER_LVGL_H
#define ADAPTER_LVGL_H

#include <glint.h>
#include <lvgl.h>

/** A flush into a canvas of LV_COLOR_FORMAT_RGB565, no smaller than the screen of the configuration. */
glint_flush adapter_lvgl_canvas(lv_obj_t *canvas);

/** An overlay that writes what shows objects, opaque, into a canvas of LV_COLOR_FORMAT_ARGB8888, and leaves all else
 * clear. Takes glint_format_rgb888; of the flush nothing is needed but that it returns 0. */
glint_painter adapter_lvgl_alpha(lv_obj_t *canvas);

/** A model that is drawn while LVGL draws a widget, in each of its partial areas, over what lies behind it. */
typedef struct adapter_lvgl_view {
    glint_config config; /**< Width and height are the widget's; format, flush and background are set when it draws. */
    const glint_scene *scene;
    glint_status status; /**< Of the last area. */
} adapter_lvgl_view;

/** To be added for LV_EVENT_DRAW_MAIN, with an adapter_lvgl_view as user data. */
void adapter_lvgl_draw(lv_event_t *event);

#endif
