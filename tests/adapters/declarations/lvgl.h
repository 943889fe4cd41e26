/* SPDX-License-Identifier: MIT */
/* What the adapter uses of LVGL 9.5's public headers, as they declare it; structures have further members there. */
#ifndef LVGL_H
#define LVGL_H

#include <stdbool.h>
#include <stdint.h>

#define LV_MIN(a, b) ((a) < (b) ? (a) : (b))
#define LV_MAX(a, b) ((a) > (b) ? (a) : (b))

typedef struct _lv_obj_t lv_obj_t;
typedef struct _lv_event_t lv_event_t;
typedef struct _lv_draw_task_t lv_draw_task_t;
typedef struct _lv_draw_buf_t lv_draw_buf_t;
typedef struct _lv_layer_t lv_layer_t;
typedef uint8_t lv_opa_t;
typedef int8_t lv_log_level_t;
typedef enum { LV_RESULT_INVALID = 0, LV_RESULT_OK } lv_result_t;

typedef enum {
    LV_COLOR_FORMAT_A8 = 0x0E,
    LV_COLOR_FORMAT_RGB888 = 0x0F,
    LV_COLOR_FORMAT_ARGB8888 = 0x10,
    LV_COLOR_FORMAT_XRGB8888 = 0x11,
    LV_COLOR_FORMAT_RGB565 = 0x12
} lv_color_format_t;

typedef struct {
    uint32_t magic : 8, cf : 8, flags : 16;
    uint32_t w : 16, h : 16;
    uint32_t stride : 16, reserved_2 : 16;
} lv_image_header_t;

struct _lv_draw_buf_t {
    lv_image_header_t header;
    uint32_t data_size;
    uint8_t *data;
};

typedef struct {
    int32_t x1, y1, x2, y2;
} lv_area_t;

struct _lv_layer_t {
    lv_draw_buf_t *draw_buf;
    lv_draw_task_t *draw_task_head;
    lv_area_t buf_area;
    lv_area_t _clip_area;
    lv_color_format_t color_format;
    lv_opa_t opa;
};

lv_draw_buf_t *lv_canvas_get_draw_buf(lv_obj_t *obj);
lv_result_t lv_obj_invalidate(const lv_obj_t *obj);
void lv_obj_get_coords(const lv_obj_t *obj, lv_area_t *coords);
void *lv_event_get_user_data(lv_event_t *e);
lv_obj_t *lv_event_get_target_obj(lv_event_t *e);
lv_layer_t *lv_event_get_layer(lv_event_t *e);
int32_t lv_area_get_width(const lv_area_t *area_p);
int32_t lv_area_get_height(const lv_area_t *area_p);
void *lv_draw_layer_alloc_buf(lv_layer_t *);
void lv_draw_dispatch(void);
void lv_draw_dispatch_wait_for_request(void);

#define LV_LOG_LEVEL_WARN 2
void lv_log_add(lv_log_level_t level, const char *file, int line, const char *func, const char *format, ...);
#define LV_LOG_WARN(...) lv_log_add(LV_LOG_LEVEL_WARN, __FILE__, __LINE__, __func__, __VA_ARGS__)

#endif
