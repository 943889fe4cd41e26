/* SPDX-License-Identifier: MIT */
/* Displays of Zephyr and of u8g2's device layer, in memory. */
#include "adapters.h"

#include <adapters/glint_u8g2.h>
#include <adapters/glint_zephyr.h>
#include <string.h>

static uint8_t screen[ADAPTED_BYTES];

/* ---- Zephyr ---- */

struct device {
    uint32_t bits;
    int vertical; /* a byte holds 8 pixels of a column */
    int fails;    /* with that, from the third tile on */
    int written;
};

static struct device *written_to;

int display_write(const struct device *dev, const uint16_t x, const uint16_t y,
                  const struct display_buffer_descriptor *desc, const void *buf) {
    const uint8_t *const from = buf;

    written_to->written++;
    if (dev->fails && dev->written > 2)
        return dev->fails;
    CHECK(x + desc->width <= ADAPTED_WIDTH && y + desc->height <= ADAPTED_HEIGHT && desc->pitch >= desc->width);
    CHECK((uint32_t)desc->pitch * desc->height * dev->bits / 8 <= desc->buf_size);
    if (dev->vertical) {
        for (uint32_t page = 0; page < desc->height / 8u; page++)
            memcpy(screen + (y / 8u + page) * ADAPTED_WIDTH + x, from + (size_t)page * desc->pitch, desc->width);
        return 0;
    }
    for (uint32_t row = 0; row < desc->height; row++)
        memcpy(screen + ((y + row) * ADAPTED_WIDTH + x) * dev->bits / 8,
               from + (size_t)row * desc->pitch * dev->bits / 8, (size_t)desc->width * dev->bits / 8);
    return 0;
}

static void check_zephyr(const glint_format *format, uint8_t bits) {
    const uint8_t *const expected = adapted_expected(format);
    struct device device = {.bits = bits, .vertical = bits == 1};
    const adapter_zephyr display = {&device, bits};
    const glint_config config = adapted_config(format, adapter_zephyr_flush(&display), 0);

    written_to = &device;
    memset(screen, 0, sizeof screen);
    CHECK_EQUAL(adapted_draw(&config), GLINT_OK);
    CHECK(memcmp(screen, expected, (size_t)ADAPTED_WIDTH * ADAPTED_HEIGHT * bits / 8) == 0);
}

void zephyr_is_sent_the_scene(void) {
    check_zephyr(&glint_format_rgb565_be, 16);
    check_zephyr(&glint_format_rgb888, 24);
    check_zephyr(&glint_format_grey8, 8);
    check_zephyr(&glint_format_mono_pages, 1);
}

void zephyr_error_is_kept(void) {
    struct device device = {.bits = 16, .fails = -5};
    const adapter_zephyr display = {&device, 16};
    const glint_config config = adapted_config(&glint_format_rgb565_be, adapter_zephyr_flush(&display), 0);
    glint_renderer renderer;

    written_to = &device;
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    CHECK_EQUAL(glint_render(&renderer, adapted_scene()), GLINT_ERROR_FLUSH);
    CHECK_EQUAL(renderer.stats.flush_error, -5);
    CHECK_EQUAL(device.written, 3);
}

/* ---- u8x8 ---- */

struct u8x8_struct {
    int left; /* calls that succeed */
};

uint8_t u8x8_DrawTile(u8x8_t *u8x8, uint8_t x, uint8_t y, uint8_t cnt, uint8_t *tile_ptr) {
    CHECK(x + cnt <= ADAPTED_WIDTH / 8 && y < ADAPTED_HEIGHT / 8);
    if (u8x8->left-- <= 0)
        return 0;
    memcpy(screen + (size_t)y * ADAPTED_WIDTH + 8u * x, tile_ptr, 8u * cnt);
    return 1;
}

void u8x8_is_sent_the_scene(void) {
    const uint8_t *const expected = adapted_expected(&glint_format_mono_pages);
    u8x8_t display = {1000};
    const glint_config config = adapted_config(&glint_format_mono_pages, adapter_u8x8_flush(&display), 0);

    memset(screen, 0, sizeof screen);
    CHECK_EQUAL(adapted_draw(&config), GLINT_OK);
    CHECK(memcmp(screen, expected, ADAPTED_WIDTH * ADAPTED_HEIGHT / 8) == 0);
}

void u8x8_error_ends_the_frame(void) {
    u8x8_t display = {6};
    const glint_config config = adapted_config(&glint_format_mono_pages, adapter_u8x8_flush(&display), 0);

    CHECK_EQUAL(adapted_draw(&config), GLINT_ERROR_FLUSH);
    CHECK_EQUAL(display.left, -1); /* nothing is drawn after a failure */
}
