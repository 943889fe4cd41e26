/* SPDX-License-Identifier: MIT */
/*
 * What examples/firmware/show_main.c must show on a display: show_host WIDTH HEIGHT FORMAT DIRECTORY writes
 * DIRECTORY/<name>-<frame>.ppm for each of its frames, levels expanded to 255, and prints their names.
 */
#include "picture.h"
#include "turntable/turntable.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FRAMES 2

static const struct {
    const char *name;
    const glint_format *format;
} formats[] = {{"rgb565", &glint_format_rgb565},
               {"rgb444", &glint_format_rgb444},
               {"mono", &glint_format_mono_dithered},
               {"grey4", &glint_format_grey4}};

static const glint_format *find_format(const char *name) {
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        if (strcmp(formats[i].name, name) == 0) {
            return formats[i].format;
        }
    }
    return NULL;
}

static int write_picture(const char *path, const picture *image) {
    FILE *file = fopen(path, "wb");
    const int channels = picture_channels(image->format);

    if (!file) {
        return 1;
    }
    fprintf(file, "P6\n%d %d\n255\n", image->width, image->height);
    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++) {
            for (int c = 0; c < 3; c++) {
                const int channel = channels == 3 ? c : 0;
                const int most = picture_level_max(image->format, channel);
                fputc((picture_level(image, x, y, channel) * 255 + most / 2) / most, file);
            }
        }
    }
    const int failed = ferror(file);
    return fclose(file) != 0 || failed;
}

static int draw(picture *image, turntable_model model, uint32_t frame, const char *directory) {
    char path[512];
    turntable table;

    turntable_frame(&table, model, frame);
    const glint_status status = picture_render(image, &table.scene, NULL, NULL);
    snprintf(path, sizeof path, "%s/%s-%u.ppm", directory, turntable_name(model), (unsigned)frame);
    if (status != GLINT_OK || write_picture(path, image)) {
        fprintf(stderr, "%s: %s\n", path, glint_strerror(status));
        return 1;
    }
    printf("%s-%u\n", turntable_name(model), (unsigned)frame);
    return 0;
}

int main(int argc, char **argv) {
    const glint_format *format = argc == 5 ? find_format(argv[3]) : NULL;

    if (!format) {
        fputs("show_host WIDTH HEIGHT rgb565|rgb444|mono|grey4 DIRECTORY\n", stderr);
        return 2;
    }
    for (uint32_t i = 0; i < TURNTABLE_MODELS * FRAMES; i++) {
        picture image = picture_open(atoi(argv[1]), atoi(argv[2]), format);
        const int failed = draw(&image, (turntable_model)(i / FRAMES), i % FRAMES, argv[4]);
        picture_close(&image);
        if (failed) {
            return 1;
        }
    }
    return 0;
}
