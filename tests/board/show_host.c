/* SPDX-License-Identifier: MIT */
/*
 * What firmware must show on a display: show_host PROGRAM WIDTH HEIGHT FORMAT DIRECTORY, PROGRAM `show`, `animate`,
 * `night`, `compose` or `moving` (examples/firmware), writes DIRECTORY/<name>-<frame>.ppm for each frame, levels
 * expanded to 255, and prints their names.
 */
#include "compose/compose.h"
#include "firmware/animation.h"
#include "firmware/night.h"
#include "moving/moving.h"
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

typedef struct target {
    int width, height;
    const glint_format *format;
    const char *directory;
} target;

static int draw(const target *to, const glint_scene *scene, const char *name, uint32_t frame) {
    char path[512];
    picture image = picture_open(to->width, to->height, to->format);
    const picture_options options = {.layers = &glint_layers};
    const glint_status status = picture_render(&image, scene, &options, NULL);

    snprintf(path, sizeof path, "%s/%s-%u.ppm", to->directory, name, (unsigned)frame);
    const int failed = status != GLINT_OK || write_picture(path, &image);
    picture_close(&image);
    if (failed) {
        fprintf(stderr, "%s: %s\n", path, glint_strerror(status));
    } else {
        printf("%s-%u\n", name, (unsigned)frame);
    }
    return failed;
}

static int draw_show(const target *to) {
    turntable table;

    for (uint32_t i = 0; i < TURNTABLE_MODELS * FRAMES; i++) {
        const turntable_model model = (turntable_model)(i / FRAMES);
        turntable_frame(&table, model, i % FRAMES);
        turntable_fit(&table, (uint16_t)to->width, (uint16_t)to->height);
        if (draw(to, &table.scene, turntable_name(model), i % FRAMES)) {
            return 1;
        }
    }
    return 0;
}

static int draw_animate(const target *to) {
    static example_stage stage;
    const target dithered = {to->width, to->height, animation_format(to->format), to->directory};
    const example_scene *scene;

    for (uint32_t i = 0; (scene = animation_build(&stage, i, (uint16_t)to->width, (uint16_t)to->height)) != NULL; i++) {
        if (draw(&dithered, &stage.scene, scene->name, i % ANIMATION_FRAMES)) {
            return 1;
        }
    }
    return 0;
}

/* Dithered, in RGB565. */
static int draw_night(const target *to) {
    static example_stage stage;
    target dithered = *to;

    dithered.format = &glint_format_rgb565_dithered;
    for (uint32_t frame = 0; frame < NIGHT_FRAMES; frame++) {
        night_build(&stage, frame, (uint16_t)to->width, (uint16_t)to->height);
        if (draw(&dithered, &stage.scene, "night", frame)) {
            return 1;
        }
    }
    return 0;
}

static int take(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const int rectangle[4] = {x, y, width, height};

    return picture_put(context, rectangle, pixels, stride);
}

/* Frames over each other on one display. */
static int draw_compose(const target *to) {
    static uint32_t arena[(64 << 10) / sizeof(uint32_t)];
    picture image = picture_open(to->width, to->height, &glint_format_rgb565_be);
    char path[512];
    int failed = 0;

    for (int i = 0; i < 3 && !failed; i++) {
        const glint_status status =
            compose_draw((glint_flush){.begin = take, .context = &image}, arena, sizeof arena, i * 8);
        snprintf(path, sizeof path, "%s/compose-%d.ppm", to->directory, i);
        failed = status != GLINT_OK || write_picture(path, &image);
        printf("compose-%d\n", i);
    }
    picture_close(&image);
    return failed;
}

/* Meshes that change. */
static int draw_moving(const target *to) {
    static uint32_t arena[(64 << 10) / sizeof(uint32_t)];
    picture image = picture_open(to->width, to->height, to->format);
    const glint_config config = {.width = (uint16_t)to->width,
                                 .height = (uint16_t)to->height,
                                 .format = to->format,
                                 .flush = {.begin = take, .context = &image},
                                 .arena = arena,
                                 .arena_size = sizeof arena};
    glint_renderer renderer;
    glint_status status = glint_init(&renderer, &config);
    int failed = status != GLINT_OK;

    for (int i = 0; i < 5 && !failed; i++) {
        char path[512];
        status = moving_draw(&renderer, i * 50);
        snprintf(path, sizeof path, "%s/moving-%d.ppm", to->directory, i);
        failed = status != GLINT_OK || write_picture(path, &image);
        printf("moving-%d\n", i);
    }
    picture_close(&image);
    return failed;
}

int main(int argc, char **argv) {
    const glint_format *format = argc == 6 ? find_format(argv[4]) : NULL;

    if (!format) {
        fputs("show_host show|animate|night|compose|moving WIDTH HEIGHT rgb565|rgb444|mono|grey4 DIRECTORY\n", stderr);
        return 2;
    }
    const target to = {atoi(argv[2]), atoi(argv[3]), format, argv[5]};
    return strcmp(argv[1], "animate") == 0   ? draw_animate(&to)
           : strcmp(argv[1], "night") == 0   ? draw_night(&to)
           : strcmp(argv[1], "compose") == 0 ? draw_compose(&to)
           : strcmp(argv[1], "moving") == 0  ? draw_moving(&to)
                                             : draw_show(&to);
}
