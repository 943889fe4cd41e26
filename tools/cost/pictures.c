/* SPDX-License-Identifier: MIT */
/*
 * Draws what the page of costs shows: pictures DIRECTORY
 * A PNG of the first frame of each workload of shown.h, as a panel of its format shows it.
 */
#include "framebuffer.h"
#include "png.h"
#include "shown.h"

#include <stdio.h>
#include <stdlib.h>

static workload_stage stage;
static uint32_t arena[(1 << 20) / sizeof(uint32_t)];

/* DIRECTORY/look-format.png, with dashes for spaces; "plain" where it has no look */
static void name_file(char *path, size_t size, const char *directory, const workload *drawn) {
    const char *const look = *drawn->look ? drawn->look : "plain", *const format = drawn->output->name;
    const int length = snprintf(path, size, "%s/", directory);

    snprintf(path + length, size - (size_t)length, "%s%s%s.png", look, *format ? "-" : "", format);
    for (char *letter = path + length; *letter; letter++) {
        *letter = *letter == ' ' ? '-' : *letter;
    }
}

/* @return 0, or 1 with a message */
static int draw(const workload *drawn, framebuffer *target) {
    glint_renderer renderer;
    glint_config config = {.width = drawn->width,
                           .height = drawn->height,
                           .format = drawn->output->format,
                           .arena = arena,
                           .arena_size = sizeof arena};

    framebuffer_init(target, drawn->output->format, drawn->width, drawn->height);
    config.flush = framebuffer_flush(target);
    if (workload_build(&stage, drawn)) {
        fprintf(stderr, "%s, %s: cannot be built\n", drawn->scene, drawn->look);
        return 1;
    }
    config.layers = stage.example.layers;
    config.samples = stage.example.samples;
    workload_set_frame(&stage, 0);
    int status = glint_init(&renderer, &config);
    if (status == GLINT_OK) {
        status = glint_render(&renderer, &stage.example.scene);
    }
    if (status != GLINT_OK) {
        fprintf(stderr, "%s, %s: %s\n", drawn->scene, drawn->look, glint_strerror(status));
    }
    return status != GLINT_OK;
}

static int write_picture(const framebuffer *target, const char *path) {
    uint8_t *const pixels = framebuffer_expand(target);
    host_bytes file = {0};
    host_problem problem;

    png_encode(&file, pixels, target->width, target->height, target->format->channels);
    const int failed = !bytes_write_file(&file, path, &problem);
    if (failed) {
        problem_print(path, &problem);
    }
    free(pixels);
    free(file.data);
    return failed;
}

int main(int argc, char **argv) {
    size_t count = 0;
    int failed = argc != 2;

    for (uint32_t i = 0; i < workload_count() && !failed; i++) {
        workload drawn = workload_get(i);
        framebuffer target;
        char path[1000];
        if (!cost_is_shown(&drawn)) {
            continue;
        }
        drawn.by_default = 1;
        name_file(path, sizeof path, argv[1], &drawn);
        failed = draw(&drawn, &target) || write_picture(&target, path);
        framebuffer_free(&target);
        count++;
    }
    if (!failed && count != COST_SHOWN) {
        fprintf(stderr, "%zu of the pictures are not among the workloads\n", COST_SHOWN - count);
        failed = 1;
    }
    return failed;
}
