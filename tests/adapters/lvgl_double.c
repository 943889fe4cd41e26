/* SPDX-License-Identifier: MIT */
#include "adapters.h"

#include <adapters/lvgl.h>
#include <string.h>

/* A widget, canvas or not: a buffer and where it lies. */
struct _lv_obj_t {
    lv_draw_buf_t buffer;
    lv_area_t coords;
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

static int invalidated, dispatched;
static lv_layer_t layer;
static uint8_t memory[200 * 160 * 4];

lv_draw_buf_t *lv_canvas_get_draw_buf(lv_obj_t *canvas) {
    return &canvas->buffer;
}

void lv_obj_invalidate(const lv_obj_t *obj) {
    (void)obj;
    invalidated++;
}

void lv_obj_get_coords(const lv_obj_t *obj, lv_area_t *coords) {
    *coords = obj->coords;
}

void *lv_event_get_user_data(lv_event_t *event) {
    return event->user_data;
}

lv_obj_t *lv_event_get_target_obj(lv_event_t *event) {
    return event->target;
}

lv_layer_t *lv_event_get_layer(lv_event_t *event) {
    return event->layer;
}

bool lv_area_intersect(lv_area_t *result, const lv_area_t *a, const lv_area_t *b) {
    result->x1 = a->x1 > b->x1 ? a->x1 : b->x1;
    result->y1 = a->y1 > b->y1 ? a->y1 : b->y1;
    result->x2 = a->x2 < b->x2 ? a->x2 : b->x2;
    result->y2 = a->y2 < b->y2 ? a->y2 : b->y2;
    return result->x1 <= result->x2 && result->y1 <= result->y2;
}

int32_t lv_area_get_width(const lv_area_t *area) {
    return area->x2 - area->x1 + 1;
}

int32_t lv_area_get_height(const lv_area_t *area) {
    return area->y2 - area->y1 + 1;
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

/* A buffer whose rows are longer than its pixels. */
static lv_draw_buf_t buffer_of(int width, int height, int bytes) {
    const uint32_t stride = (uint32_t)(width * bytes + 12);
    lv_draw_buf_t buffer = {.data = memory, .data_size = stride * (uint32_t)height};

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
    lv_obj_t canvas = {.buffer = buffer_of(ADAPTED_WIDTH, ADAPTED_HEIGHT, 2)};
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
    lv_obj_t canvas = {.buffer = buffer_of(ADAPTED_WIDTH, ADAPTED_HEIGHT, 4)};
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
    lv_draw_buf_t buffer = buffer_of(150, 100, 2);
    adapter_lvgl_view view = {adapted_config(&glint_format_rgb565, (glint_flush){0}, 1), adapted_scene(), GLINT_OK};

    layer = (lv_layer_t){.draw_buf = &buffer};
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
    lv_draw_buf_t buffer = buffer_of(150, 100, 2);
    adapter_lvgl_view view = {adapted_config(&glint_format_rgb565, (glint_flush){0}, 1), adapted_scene(), GLINT_OK};

    layer = (lv_layer_t){.draw_buf = &buffer, .draw_task_head = &background};
    dispatched = 0;
    draw_area(&view, 0, 0, ADAPTED_WIDTH, ADAPTED_HEIGHT);
    CHECK_EQUAL(view.status, GLINT_OK);
    CHECK_EQUAL(dispatched, 1);
    CHECK_EQUAL(wrong_pixels(expected, 0x33), 0);
}

void lvgl_area_elsewhere_draws_nothing(void) {
    lv_draw_buf_t buffer = buffer_of(150, 100, 2);
    adapter_lvgl_view view = {adapted_config(&glint_format_rgb565, (glint_flush){0}, 1), adapted_scene(), GLINT_OK};

    layer = (lv_layer_t){.draw_buf = &buffer};
    draw_area(&view, ADAPTED_WIDTH, 0, 10, 10);
    CHECK_EQUAL(view.status, GLINT_ERROR_NULL); /* as it was */
    int written = 0;
    for (size_t i = 0; i < sizeof memory; i++)
        written += memory[i] != 0;
    CHECK_EQUAL(written, 0);
}
