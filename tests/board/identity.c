/* SPDX-License-Identifier: MIT */
#include "identity.h"

#include "frames.h"
#include "text.h"

typedef struct named_format {
    const char *name;
    const glint_format *format;
} named_format;

static const named_format formats[] = {
    {"grey4", &glint_format_grey4},         {"grey8", &glint_format_grey8},   {"rgb565", &glint_format_rgb565},
    {"rgb565_be", &glint_format_rgb565_be}, {"rgb888", &glint_format_rgb888},
};

enum { FORMATS = sizeof formats / sizeof formats[0], WIDEST = FORMATS - 1 };

static const uint16_t tile_sizes[] = {8, 16, 32, 64};

static frame_image image;

static void write_number(void (*write)(const char *text), uint32_t number) {
    char digits[TEXT_NUMBER_SIZE];

    write(text_number(digits, number));
}

static void write_hex(void (*write)(const char *text), uint32_t number) {
    char digits[9];

    for (int i = 0; i < 8; i++) {
        digits[i] = "0123456789abcdef"[number >> (28 - 4 * i) & 15u];
    }
    digits[8] = '\0';
    write(digits);
}

static int draw(void (*write)(const char *text), turntable_model model, uint32_t frame, const named_format *format,
                frame_options options) {
    glint_status status;

    options.format = format->format;
    write(turntable_name(model));
    write(" ");
    write_number(write, frame);
    write(" ");
    write(format->name);
    write(" | tile ");
    write_number(write, options.tile_width);
    write("x");
    write_number(write, options.tile_height);
    write(options.smallest ? " smallest | " : " best | ");
    status = frame_draw(&image, model, frame, &options);
    if (status != GLINT_OK) {
        write(glint_strerror(status));
    } else {
        write_hex(write, frame_checksum(&image));
    }
    write("\n");
    return status != GLINT_OK;
}

/* One frame in every tile size, or in square ones only, with the largest and the smallest arena. */
static int draw_tiles(void (*write)(const char *text), turntable_model model, uint32_t frame, int square) {
    int failed = 0;

    for (int i = 0; i < 32; i++) {
        const frame_options options = {NULL, tile_sizes[i & 3], tile_sizes[i >> 2 & 3], i >> 4};
        if (!square || options.tile_width == options.tile_height) {
            failed += draw(write, model, frame, &formats[WIDEST], options);
        }
    }
    return failed;
}

int identity_run(void (*write)(const char *text)) {
    int failed = 0;

    for (int model = 0; model < TURNTABLE_MODELS; model++) {
        const frame_options options = {NULL, 0, 0, 0};
        for (uint32_t frame = 0; frame < TURNTABLE_FRAMES; frame++) {
            failed += draw(write, (turntable_model)model, frame, &formats[WIDEST], options);
        }
        for (int format = 0; format < WIDEST; format++) {
            failed += draw(write, (turntable_model)model, 5, &formats[format], options);
        }
        /* the smallest arena means hundreds of passes over the larger mesh: there, square tiles are enough */
        failed += draw_tiles(write, (turntable_model)model, 5, model == TURNTABLE_TEAPOT);
    }
    return failed;
}
