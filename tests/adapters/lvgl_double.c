/* SPDX-License-Identifier: MIT */
#include "adapters.h"

#include <adapters/glint_lvgl.h>
#include <stdlib.h>
#include <string.h>

/* A widget, canvas or not: a buffer and where it lies. */
struct _lv_obj_t {
    lv_draw_buf_t buffer;
    lv_area_t coords;
    int is_empty; /* a canvas that has been given no buffer */
};

struct _lv_event_t {
    void *user_data;
    lv_obj_t *target;
    lv_layer_t *layer;
};

/* The background that LVGL has yet to draw: all bytes of the layer become this. */
struct _lv_draw_task_t {
    uint8_t byte;
};

static int invalidated, dispatched, logged, has_memory;
static lv_layer_t layer;
static uint8_t memory[200 * 160 * 4];

static lv_draw_buf_t buffer_of(lv_color_format_t format, int width, int height);

lv_draw_buf_t *lv_canvas_get_draw_buf(lv_obj_t *obj) {
    return obj->is_empty ? NULL : &obj->buffer;
}

lv_result_t lv_obj_invalidate(const lv_obj_t *obj) {
    (void)obj;
    invalidated++;
    return LV_RESULT_OK;
}

void lv_obj_get_coords(const lv_obj_t *obj, lv_area_t *coords) {
    *coords = obj->coords;
}

void *lv_event_get_user_data(lv_event_t *e) {
    return e->user_data;
}

lv_obj_t *lv_event_get_target_obj(lv_event_t *e) {
    return e->target;
}

lv_layer_t *lv_event_get_layer(lv_event_t *e) {
    return e->layer;
}

int32_t lv_area_get_width(const lv_area_t *area_p) {
    return area_p->x2 - area_p->x1 + 1;
}

int32_t lv_area_get_height(const lv_area_t *area_p) {
    return area_p->y2 - area_p->y1 + 1;
}

void lv_draw_dispatch_wait_for_request(void) {
    dispatched++;
}

void lv_draw_dispatch(void) {
    if (!layer.draw_task_head)
        return;
    memset(layer.draw_buf->data, layer.draw_task_head->byte, layer.draw_buf->data_size);
    layer.draw_task_head = 0;
}

void lv_log_add(lv_log_level_t level, const char *file, int line, const char *func, const char *format, ...) {
    (void)level, (void)file, (void)line, (void)func, (void)format;
    logged++;
}

/* A layer begins without a buffer. */
void *lv_draw_layer_alloc_buf(lv_layer_t *of) {
    static lv_draw_buf_t made;

    if (!of->draw_buf && has_memory) {
        made = buffer_of(of->color_format, lv_area_get_width(&of->buf_area), lv_area_get_height(&of->buf_area));
        of->draw_buf = &made;
    }
    return of->draw_buf ? of->draw_buf->data : NULL;
}

static int bytes_of(lv_color_format_t format) {
    return format == LV_COLOR_FORMAT_A8       ? 1
           : format == LV_COLOR_FORMAT_RGB565 ? 2
           : format == LV_COLOR_FORMAT_RGB888 ? 3
                                              : 4;
}

/* A buffer whose rows are longer than its pixels. */
static lv_draw_buf_t buffer_of(lv_color_format_t format, int width, int height) {
    const uint32_t stride = (uint32_t)(width * bytes_of(format) + 12);
    lv_draw_buf_t buffer = {.data = memory, .data_size = stride * (uint32_t)height};

    buffer.header.cf = (unsigned)format & 0xff;
    buffer.header.w = (unsigned)width & 0xffff;
    buffer.header.h = (unsigned)height & 0xffff;
    buffer.header.stride = stride & 0xffff;
    memset(memory, 0, sizeof memory);
    return buffer;
}

static int differing(const lv_draw_buf_t *buffer, const uint8_t *expected, int bytes) {
    const size_t row = (size_t)ADAPTED_WIDTH * (size_t)bytes;
    int count = 0;

    for (size_t y = 0; y < ADAPTED_HEIGHT; y++)
        count += memcmp(buffer->data + y * buffer->header.stride, expected + y * row, row) != 0;
    return count;
}

void lvgl_canvas_shows_the_scene(void) {
    lv_obj_t canvas = {.buffer = buffer_of(LV_COLOR_FORMAT_RGB565, ADAPTED_WIDTH, ADAPTED_HEIGHT)};
    const uint8_t *const expected = adapted_expected(&glint_format_rgb565);
    const glint_config config = adapted_config(&glint_format_rgb565, adapter_lvgl_canvas(&canvas), 0);

    invalidated = 0;
    CHECK_EQUAL(adapted_draw(&config), GLINT_OK);
    CHECK(invalidated > 0);
    CHECK_EQUAL(differing(&canvas.buffer, expected, 2), 0);
}

static int ignore(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context, (void)x, (void)y, (void)width, (void)height, (void)pixels, (void)stride;
    return 0;
}

/* Opaque where depth tells so: the reference here is the frame itself, twice, over backgrounds that differ. */
void lvgl_alpha_shows_what_objects_cover(void) {
    lv_obj_t canvas = {.buffer = buffer_of(LV_COLOR_FORMAT_ARGB8888, ADAPTED_WIDTH, ADAPTED_HEIGHT)};
    const uint8_t *const expected = adapted_expected(&glint_format_rgb888);
    glint_config config = adapted_config(&glint_format_rgb888, (glint_flush){.begin = ignore}, 0);
    int wrong = 0, opaque = 0;

    config.overlay = adapter_lvgl_alpha(&canvas);
    CHECK_EQUAL(adapted_draw(&config), GLINT_OK);
    for (size_t y = 0; y < ADAPTED_HEIGHT; y++)
        for (size_t x = 0; x < ADAPTED_WIDTH; x++) {
            const uint8_t *const pixel = canvas.buffer.data + y * canvas.buffer.header.stride + 4 * x;
            const uint8_t *const rgb = expected + 3 * (y * ADAPTED_WIDTH + x);
            const int is_background = rgb[0] == expected[0] && rgb[1] == expected[1] && rgb[2] == expected[2];

            opaque += pixel[3] == 255;
            if (is_background)
                wrong += pixel[3] != 0 || pixel[0] || pixel[1] || pixel[2];
            else
                wrong += pixel[3] != 255 || pixel[0] != rgb[2] || pixel[1] != rgb[1] || pixel[2] != rgb[0];
        }
    CHECK_EQUAL(wrong, 0);
    CHECK(opaque > 1000);
}

/* Written as if it fitted, a canvas would be overrun. */
void lvgl_canvas_that_does_not_fit_is_refused(void) {
    const struct {
        lv_color_format_t format;
        int width, height, has_buffer;
    } unfit[] = {{LV_COLOR_FORMAT_A8, ADAPTED_WIDTH, ADAPTED_HEIGHT, 1},
                 {LV_COLOR_FORMAT_RGB565, ADAPTED_WIDTH - 1, ADAPTED_HEIGHT, 1},
                 {LV_COLOR_FORMAT_ARGB8888, ADAPTED_WIDTH, ADAPTED_HEIGHT - 1, 1},
                 {LV_COLOR_FORMAT_RGB565, 0, 0, 0}};

    for (size_t i = 0; i < TEST_COUNT(unfit); i++) {
        lv_obj_t canvas = {.buffer = buffer_of(unfit[i].format, unfit[i].width, unfit[i].height),
                           .is_empty = !unfit[i].has_buffer};
        const glint_config plain = adapted_config(&glint_format_rgb565, adapter_lvgl_canvas(&canvas), 0);
        glint_config alpha = adapted_config(&glint_format_rgb888, (glint_flush){.begin = ignore}, 0);

        alpha.overlay = adapter_lvgl_alpha(&canvas);
        logged = 0;
        CHECK_EQUAL(adapted_draw(&plain), GLINT_ERROR_FLUSH);
        CHECK_EQUAL(adapted_draw(&alpha), GLINT_ERROR_PAINT);
        CHECK_EQUAL(logged, 2);
    }
}

/* Draws the areas that LVGL would, into a layer that begins at (50, 20) of the display; the widget is at (60, 30). */
static void draw_area(adapter_lvgl_view *view, int x, int y, int width, int height) {
    lv_obj_t widget = {.coords = {60, 30, 60 + ADAPTED_WIDTH - 1, 30 + ADAPTED_HEIGHT - 1}};
    lv_event_t event = {view, &widget, &layer};

    layer.buf_area = (lv_area_t){50, 20, 50 + 150 - 1, 20 + 100 - 1};
    layer._clip_area = (lv_area_t){60 + x, 30 + y, 60 + x + width - 1, 30 + y + height - 1};
    view->status = GLINT_ERROR_NULL;
    adapter_lvgl_draw(&event);
}

/* What shows at the widget's corner; where no object does, `behind` is. */
static int wrong_pixels(const uint8_t *expected, uint8_t behind) {
    int wrong = 0;

    for (size_t y = 0; y < ADAPTED_HEIGHT; y++)
        for (size_t x = 0; x < ADAPTED_WIDTH; x++) {
            const uint8_t *const pixel = memory + (y + 10) * layer.draw_buf->header.stride + 2 * (x + 10);
            const uint8_t *const should = expected + 2 * (y * ADAPTED_WIDTH + x);

            if (memcmp(should, expected, 2) == 0)
                wrong += pixel[0] != behind || pixel[1] != behind;
            else
                wrong += memcmp(pixel, should, 2) != 0;
        }
    return wrong;
}

void lvgl_areas_are_the_whole(void) {
    const uint8_t *const expected = adapted_expected(&glint_format_rgb565);
    lv_draw_buf_t buffer = buffer_of(LV_COLOR_FORMAT_RGB565, 150, 100);
    adapter_lvgl_view view = {adapted_config(&glint_format_rgb565, (glint_flush){0}, 1), adapted_scene(), GLINT_OK};

    layer = (lv_layer_t){.draw_buf = &buffer, .opa = 255};
    memset(memory, 0x5a, sizeof memory);
    for (int y = -5; y < ADAPTED_HEIGHT; y += 17) { /* also beyond the widget's edges */
        draw_area(&view, -3, y, 40, 17);
        CHECK_EQUAL(view.status, GLINT_OK);
        draw_area(&view, 37, y, ADAPTED_WIDTH, 17);
        CHECK_EQUAL(view.status, GLINT_OK);
    }
    CHECK_EQUAL(wrong_pixels(expected, 0x5a), 0);
    int outside = 0;
    for (size_t i = 0; i < 10 * (size_t)buffer.header.stride; i++)
        outside += memory[i] != 0x5a;
    CHECK_EQUAL(outside, 0);
}

void lvgl_waits_for_what_lies_behind(void) {
    const uint8_t *const expected = adapted_expected(&glint_format_rgb565);
    lv_draw_task_t background = {0x33};
    lv_draw_buf_t buffer = buffer_of(LV_COLOR_FORMAT_RGB565, 150, 100);
    adapter_lvgl_view view = {adapted_config(&glint_format_rgb565, (glint_flush){0}, 1), adapted_scene(), GLINT_OK};

    layer = (lv_layer_t){.draw_buf = &buffer, .draw_task_head = &background, .opa = 255};
    dispatched = 0;
    draw_area(&view, 0, 0, ADAPTED_WIDTH, ADAPTED_HEIGHT);
    CHECK_EQUAL(view.status, GLINT_OK);
    CHECK_EQUAL(dispatched, 1);
    CHECK_EQUAL(wrong_pixels(expected, 0x33), 0);
}

void lvgl_area_elsewhere_draws_nothing(void) {
    lv_draw_buf_t buffer = buffer_of(LV_COLOR_FORMAT_RGB565, 150, 100);
    adapter_lvgl_view view = {adapted_config(&glint_format_rgb565, (glint_flush){0}, 1), adapted_scene(), GLINT_OK};

    layer = (lv_layer_t){.draw_buf = &buffer, .opa = 255};
    draw_area(&view, ADAPTED_WIDTH, 0, 10, 10);
    CHECK_EQUAL(view.status, GLINT_ERROR_NULL); /* as it was */
    int written = 0;
    for (size_t i = 0; i < sizeof memory; i++)
        written += memory[i] != 0;
    CHECK_EQUAL(written, 0);
}

/* A pixel's level of blue, green or red. */
static int level_of(const uint8_t *pixel, int is_565, int channel) {
    const int value = pixel[0] | pixel[1] << 8;

    return !is_565 ? pixel[channel] : channel == 0 ? value & 31 : channel == 1 ? value >> 5 & 63 : value >> 11;
}

/* Do two levels mix to this one, rounded? */
static int is_mix(int level, int over, int under, int opacity) {
    return abs(255 * level - over * opacity - under * (255 - opacity)) <= 128;
}

/* What `opa`, `opa_layered` and transformations ask of a view: LVGL hands out a layer that begins without a buffer, in
 * another format than the display's, and less than opaque. Before, LVGL has filled it with `behind`. */
static void check_layer(lv_color_format_t format, int opacity, uint8_t behind) {
    const int is_565 = format == LV_COLOR_FORMAT_RGB565, has_alpha = format == LV_COLOR_FORMAT_ARGB8888;
    const uint8_t *const expected = adapted_expected(is_565 ? &glint_format_rgb565 : &glint_format_rgb888);
    const uint8_t background[] = {behind, behind};
    const size_t bytes = (size_t)bytes_of(format), expected_bytes = is_565 ? 2 : 3;
    adapter_lvgl_view view = {adapted_config(&glint_format_rgb565, (glint_flush){0}, 1), adapted_scene(), GLINT_OK};
    lv_draw_task_t fill = {behind};
    /* alpha, where nothing lies behind, tells how much of the model is there: its colours are the model's own */
    const int part = has_alpha && !behind ? 255 : opacity;
    int wrong = 0, covered = 0;

    layer = (lv_layer_t){.color_format = format, .draw_task_head = &fill, .opa = (lv_opa_t)opacity};
    has_memory = 1;
    draw_area(&view, 0, 0, ADAPTED_WIDTH, ADAPTED_HEIGHT);
    CHECK_EQUAL(view.status, GLINT_OK);
    for (size_t y = 0; y < ADAPTED_HEIGHT; y++)
        for (size_t x = 0; x < ADAPTED_WIDTH; x++) {
            const uint8_t *const pixel = memory + (y + 10) * layer.draw_buf->header.stride + bytes * (x + 10);
            const uint8_t *const over = expected + expected_bytes * (y * ADAPTED_WIDTH + x);
            const int shows = memcmp(over, expected, expected_bytes) != 0;

            covered += shows;
            for (int channel = 0; channel < 3; channel++)
                wrong +=
                    !is_mix(level_of(pixel, is_565, channel), level_of(over, is_565, is_565 ? channel : 2 - channel),
                            level_of(background, is_565, is_565 ? channel : 0), shows ? part : 0);
            wrong += has_alpha && pixel[3] != (behind || !shows ? behind : opacity);
        }
    CHECK_EQUAL(wrong, 0);
    CHECK(covered > 1000);
}

void lvgl_layers_show_the_model(void) {
    const lv_color_format_t formats[] = {LV_COLOR_FORMAT_RGB565, LV_COLOR_FORMAT_RGB888, LV_COLOR_FORMAT_XRGB8888,
                                         LV_COLOR_FORMAT_ARGB8888};

    for (size_t i = 0; i < TEST_COUNT(formats); i++) {
        check_layer(formats[i], 255, 0);
        check_layer(formats[i], 100, 255);
    }
    check_layer(LV_COLOR_FORMAT_ARGB8888, 100, 0);
}

/* A layer that cannot be drawn into is left as it was, and the log says so. */
void lvgl_layer_that_cannot_be_drawn_is_refused(void) {
    adapter_lvgl_view view = {adapted_config(&glint_format_rgb565, (glint_flush){0}, 1), adapted_scene(), GLINT_OK};

    logged = 0;
    layer = (lv_layer_t){.color_format = LV_COLOR_FORMAT_RGB565, .opa = 255};
    has_memory = 0;
    draw_area(&view, 0, 0, ADAPTED_WIDTH, ADAPTED_HEIGHT);
    CHECK(view.status == GLINT_ERROR_NULL && logged == 1);
    layer = (lv_layer_t){.color_format = LV_COLOR_FORMAT_A8, .opa = 255};
    has_memory = 1;
    draw_area(&view, 0, 0, ADAPTED_WIDTH, ADAPTED_HEIGHT);
    CHECK(view.status == GLINT_ERROR_FORMAT && logged == 2);
    int written = 0;
    for (size_t i = 0; i < sizeof memory; i++)
        written += memory[i] != 0;
    CHECK_EQUAL(written, 0);
}
