/* SPDX-License-Identifier: MIT */
/*
 * What a program copied from the page runs on here: a bus that writes a stream for panel_stream to stdout or, in place
 * of a panel, a display that writes the picture, of 8 bits a channel as a PPM file. The program's main is compiled as
 * scene_main; WIDTH, HEIGHT and FORMAT are those of the display.
 */
#include "board.h"
#include "picture.h"

#include <stdio.h>
#include <stdlib.h>

int scene_main(void);

/* ---- A bus ------------------------------------------------------------------------------------------------------- */

static void write_bytes(char kind, const uint8_t *bytes, size_t count) {
    printf("%c", kind);
    for (size_t i = 0; i < count; i++) {
        printf(" %02x", bytes[i]);
    }
    printf("\n");
}

static glint_status command(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    write_bytes('C', bytes, count);
    return GLINT_OK;
}

static glint_status data(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    write_bytes('D', bytes, count);
    return GLINT_OK;
}

static glint_status begin(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    for (size_t row = 0; row < rows; row++) {
        data(context, bytes + row * stride, row_bytes);
    }
    return GLINT_OK;
}

static void reset(void *context, int active) {
    (void)context;
    printf("R %d\n", active);
}

static void delay(void *context, uint32_t milliseconds) {
    (void)context;
    printf("T %lu\n", (unsigned long)milliseconds * 1000);
}

const glint_bus *board_panel_bus(void) {
    static const glint_bus bus = {.command = command, .data = data, .begin = begin, .reset = reset, .delay = delay};
    printf("H 4000000\n");
    return &bus;
}

/* ---- A display --------------------------------------------------------------------------------------------------- */

#ifdef WIDTH
static picture shown;

static int display_begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const int rectangle[4] = {x, y, width, height};
    (void)context;
    if (shown.bytes == NULL) {
        shown = picture_open(WIDTH, HEIGHT, &FORMAT);
    }
    return picture_put(&shown, rectangle, pixels, stride);
}

extern const glint_flush display_flush;
const glint_flush display_flush = {display_begin, NULL, NULL};

static void write_picture(void) {
    printf("P6\n%d %d\n255\n", WIDTH, HEIGHT);
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            for (int channel = 0; channel < 3; channel++) {
                const int of = picture_channels(&FORMAT) == 3 ? channel : 0, most = picture_level_max(&FORMAT, of);
                putchar((picture_level(&shown, x, y, of) * 255 + most / 2) / most);
            }
        }
    }
}
#endif

int main(void) {
    const int failed = scene_main();
#ifdef WIDTH
    if (failed == 0 && shown.bytes != NULL) {
        write_picture();
    }
#endif
    return failed;
}
