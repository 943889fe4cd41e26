/* SPDX-License-Identifier: MIT */
/* A display of 320x240 pixels in memory. After two frames its picture is written to teapot.ppm. */
#include <stdio.h>
#include <stdlib.h>
#include <zephyr/device.h>
#include <zephyr/drivers/display.h>

enum { WIDTH = 320, HEIGHT = 240 };

struct device {
    int number;
};
const struct device zephyr_display_device = {1};

static uint8_t screen[HEIGHT][WIDTH][2];
static int is_on, drawn;

static void demand(int good, const char *what) {
    if (good)
        return;
    fprintf(stderr, "zephyr: %s\n", what);
    exit(1);
}

bool device_is_ready(const struct device *device) {
    return device == &zephyr_display_device;
}

void display_get_capabilities(const struct device *device, struct display_capabilities *capabilities) {
    demand(device == &zephyr_display_device, "another device");
    *capabilities = (struct display_capabilities){WIDTH, HEIGHT, PIXEL_FORMAT_RGB_565, 0, PIXEL_FORMAT_RGB_565, 0};
}

int display_blanking_off(const struct device *device) {
    demand(device == &zephyr_display_device, "another device");
    is_on = 1;
    return 0;
}

static void write_picture(void) {
    FILE *const file = fopen("teapot.ppm", "wb");

    demand(file != NULL && is_on, "teapot.ppm");
    fprintf(file, "P6\n%d %d\n255\n", WIDTH, HEIGHT);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const int word = screen[y][x][0] << 8 | screen[y][x][1];
            fprintf(file, "%c%c%c", ((word >> 11) * 255 + 15) / 31, ((word >> 5 & 63) * 255 + 31) / 63,
                    ((word & 31) * 255 + 15) / 31);
        }
    exit(fclose(file) != 0);
}

int display_write(const struct device *dev, const uint16_t x, const uint16_t y,
                  const struct display_buffer_descriptor *desc, const void *buf) {
    demand(dev == &zephyr_display_device && x + desc->width <= WIDTH && y + desc->height <= HEIGHT,
           "a tile beside the screen");
    demand(desc->pitch >= desc->width && desc->buf_size >= desc->pitch * desc->height * 2u, "a tile's description");
    for (int row = 0; row < desc->height; row++)
        for (int i = 0; i < desc->width; i++, drawn++) {
            const uint8_t *const from = (const uint8_t *)buf + (row * desc->pitch + i) * 2;
            screen[y + row][x + i][0] = from[0];
            screen[y + row][x + i][1] = from[1];
        }
    if (drawn >= 2 * WIDTH * HEIGHT)
        write_picture();
    return 0;
}
