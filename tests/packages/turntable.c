/* SPDX-License-Identifier: MIT */
/* What the samples show at last, two frames after their start: turntable WIDTH HEIGHT PICTURE.ppm. */
#include "turntable/turntable.h"

#include "framebuffer.h"

#include <stdio.h>
#include <stdlib.h>

int main(int count, char **arguments) {
    static uint32_t arena[32768];
    const uint32_t width = count == 4 ? (uint32_t)atoi(arguments[1]) : 0;
    const uint32_t height = count == 4 ? (uint32_t)atoi(arguments[2]) : 0;
    FILE *const file = count == 4 ? fopen(arguments[3], "wb") : NULL;
    framebuffer screen;
    glint_renderer renderer;
    turntable table = {0};

    if (file == NULL)
        return 2;
    framebuffer_init(&screen, &glint_format_rgb565_be, width, height);
    const glint_config config = {.width = (uint16_t)width,
                                 .height = (uint16_t)height,
                                 .format = &glint_format_rgb565_be,
                                 .flush = framebuffer_flush(&screen),
                                 .arena = arena,
                                 .arena_size = sizeof arena};
    turntable_frame(&table, TURNTABLE_TEAPOT, 1);
    if (glint_init(&renderer, &config) || glint_render(&renderer, &table.scene))
        return 1;
    fprintf(file, "P6\n%u %u\n255\n", width, height);
    fwrite(framebuffer_expand(&screen), 3, (size_t)width * height, file);
    return fclose(file) != 0;
}
