/* SPDX-License-Identifier: MIT */
/* Of LVGL 9.5 what the adapter uses, as its documentation declares it; structures have further members there. */
#ifndef LVGL_H
#define LVGL_H

#include <stdbool.h>
#include <stdint.h>

typedef struct _lv_obj_t lv_obj_t;
typedef struct _lv_event_t lv_event_t;
typedef struct _lv_draw_task_t lv_draw_task_t;

typedef struct {
    uint32_t magic : 8, cf : 8, flags : 16;
    uint32_t w : 16, h : 16;
    uint32_t stride : 16, reserved_2 : 16;
} lv_image_header_t;

typedef struct {
    lv_image_header_t header;
    uint32_t data_size;
    uint8_t *data;
} lv_draw_buf_t;

typedef struct {
    int32_t x1, y1, x2, y2;
} lv_area_t;

typedef struct {
    lv_draw_buf_t *draw_buf;
    lv_draw_task_t *draw_task_head;
    lv_area_t buf_area;
    lv_area_t _clip_area;
} lv_layer_t;

lv_draw_buf_t *lv_canvas_get_draw_buf(lv_obj_t *canvas);
void lv_obj_invalidate(const lv_obj_t *obj);
void lv_obj_get_coords(const lv_obj_t *obj, lv_area_t *coords);
void *lv_event_get_user_data(lv_event_t *event);
lv_obj_t *lv_event_get_target_obj(lv_event_t *event);
lv_layer_t *lv_event_get_layer(lv_event_t *event);
bool lv_area_intersect(lv_area_t *result, const lv_area_t *a, const lv_area_t *b);
int32_t lv_area_get_width(const lv_area_t *area);
int32_t lv_area_get_height(const lv_area_t *area);
void lv_draw_dispatch(void);
void lv_draw_dispatch_wait_for_request(void);

#endif
