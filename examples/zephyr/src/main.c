/* SPDX-License-Identifier: MIT */
/* A teapot that turns on the board's display: of RGB565, RGB888 or 8-bit grey. */
#include <adapters/glint_zephyr.h>
#include <glint.h>
#include <turntable/turntable.h>
#include <zephyr/device.h>
#include <zephyr/drivers/display.h>

static uint32_t arena[12288];

/* Sets what fits the display's pixels. @return 0 when glint has none such */
static int choose_format(const struct display_capabilities *is, glint_config *config, adapter_zephyr *display) {
    if (is->current_pixel_format == PIXEL_FORMAT_RGB_565) {
        config->format = &glint_format_rgb565_be;
        display->bits = 16;
    } else if (is->current_pixel_format == PIXEL_FORMAT_RGB_888) {
        config->format = &glint_format_rgb888;
        display->bits = 24;
    } else if (is->current_pixel_format == PIXEL_FORMAT_L_8) {
        config->format = &glint_format_grey8;
        display->bits = 8;
    }
    return display->bits;
}

int main(void) {
    static glint_renderer renderer;
    static turntable table;
    adapter_zephyr display = {.device = DEVICE_DT_GET(DT_CHOSEN(zephyr_display))};
    struct display_capabilities is;
    glint_config config = {.arena = arena, .arena_size = sizeof arena, .keeps_arena = 1};

    if (!device_is_ready(display.device))
        return 1; /* no display, or not started */
    display_get_capabilities(display.device, &is);
    if (!choose_format(&is, &config, &display))
        return 2;
    config.width = is.x_resolution;
    config.height = is.y_resolution;
    config.flush = adapter_zephyr_flush(&display);
    display_blanking_off(display.device);
    int failed = glint_init(&renderer, &config);
    for (uint32_t frame = 0; !failed; frame++) {
        turntable_frame(&table, TURNTABLE_TEAPOT, frame);
        failed = glint_render(&renderer, &table.scene);
    }
    return failed;
}
