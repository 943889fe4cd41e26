/* SPDX-License-Identifier: MIT */
/*
 * What a sketch's last frame looks like when its scene is drawn to memory and not to its panel: sketch PICTURE.ppm. The
 * sketch is SKETCH; its renderer, scene and config are its statics.
 */
#include <Arduino.h>

#include SKETCH

#include <stdio.h>

static uint8_t screen[320 * 240 * 2];

static int keep_tile(void *, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const uint8_t *from = (const uint8_t *)pixels;

    if (config.format == &glint_format_rgb565_be)
        for (int row = 0; row < height; row++)
            for (int i = 0; i < 2 * width; i++)
                screen[(y + row) * 2 * config.width + 2 * x + i] = from[row * stride + i];
    else
        for (int row = 0; row < height; row++)
            for (int i = 0; i < width; i++)
                screen[(y + row) * config.width + x + i] = from[i + row / 8 * 8 * stride] >> row % 8 & 1;
    return 0;
}

static int level(int value, int most) {
    return (value * 255 + most / 2) / most;
}

int main(int, char **arguments) {
    FILE *const file = fopen(arguments[1], "wb");

    setup();
    for (int frame = 0; frame < 3; frame++)
        loop();
    config.flush.begin = keep_tile;
    if (!file || glint_init(&renderer, &config) || glint_render(&renderer, &scene))
        return 1;
    fprintf(file, "P6\n%d %d\n255\n", config.width, config.height);
    for (int i = 0; i < config.width * config.height; i++) {
        const int word = screen[2 * i] << 8 | screen[2 * i + 1];

        if (config.format == &glint_format_rgb565_be)
            fprintf(file, "%c%c%c", level(word >> 11, 31), level(word >> 5 & 63, 63), level(word & 31, 31));
        else
            fprintf(file, "%c%c%c", screen[i] * 255, screen[i] * 255, screen[i] * 255);
    }
    return fclose(file) != 0;
}
