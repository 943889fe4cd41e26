/* SPDX-License-Identifier: MIT */
/*
 * PSNR of every way to light, as CSV: ten frames of each scene, in RGB565, against what it asks for in double
 * precision, Blinn-Phong per fragment for a local viewer, whatever the choice; and of the float renderer's frames.
 */
#include "float/snapped.h"
#include "truth.h"
#include "ways.h"

#include <math.h>

enum { WIDTH = 320, HEIGHT = 240, PIXELS = WIDTH * HEIGHT, CHANNELS = 3 };

/** Of errors, levels as 0..1, over channels of pixels. */
typedef struct sum {
    double squares;
    long samples;
} sum;

static workload_stage asked, stage;
static reference_pixel truth[PIXELS], float_truth[PIXELS];
static uint16_t colour[PIXELS];
static int32_t depth[PIXELS];
static const float_screen screen = {WIDTH, HEIGHT, colour, depth};
static float_memory memory;

static void fail(const char *what) {
    fprintf(stderr, "ways accuracy: %s\n", what);
    exit(1);
}

static double psnr(const sum *of) {
    if (of->samples == 0)
        fail("nothing was drawn");
    return -10 * log10(of->squares / (double)of->samples);
}

/* Draws what is asked for in double precision, for the vertices as the library and the float renderer snap them. */
static void find_truth(const workload *drawn, uint32_t frame) {
    const reference_image image = {WIDTH, HEIGHT, truth};
    const glint_scene *scene = &asked.example.scene;

    if (workload_build(&asked, drawn))
        fail("a scene cannot be built");
    workload_set_frame(&asked, frame);
    truth_draw(&image, scene);
    float_draw_reference(&screen, &memory, scene, float_truth);
}

static void add_pixel(sum *to, const double levels[CHANNELS], const reference_pixel *wanted) {
    for (int channel = 0; channel < CHANNELS; channel++) {
        const double error = levels[channel] - wanted->colour[channel];
        to->squares += error * error;
    }
    to->samples += CHANNELS;
}

static void add_library(sum *to) {
    picture drawn = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);

    if (picture_render(&drawn, &stage.example.scene, NULL, NULL) != GLINT_OK)
        fail("the library refuses a scene");
    for (int i = 0; i < PIXELS; i++) {
        double levels[CHANNELS];
        for (int channel = 0; channel < CHANNELS; channel++)
            levels[channel] = (double)picture_level(&drawn, i % WIDTH, i / WIDTH, channel) /
                              picture_level_max(&glint_format_rgb565, channel);
        if (truth[i].covered)
            add_pixel(to, levels, &truth[i]);
    }
    picture_close(&drawn);
}

static void add_float(sum *to) {
    float_render(&screen, &memory, &stage.example.scene);
    for (int i = 0; i < PIXELS; i++) {
        const double levels[CHANNELS] = {(colour[i] >> 11) / 31.0, (colour[i] >> 5 & 63) / 63.0,
                                         (colour[i] & 31) / 31.0};
        if (float_truth[i].covered && depth[i] > 0)
            add_pixel(to, levels, &float_truth[i]);
    }
}

static void judge_scene(const workload *drawn) {
    sum library[CHOICES] = {{0}}, with_float[CHOICES] = {{0}};

    for (uint32_t frame = 0; frame < drawn->frames; frame++) {
        find_truth(drawn, frame);
        for (size_t i = 0; i < CHOICES; i++) {
            if (ways_build(&stage, drawn, &choices[i]))
                fail("a scene cannot be built");
            workload_set_frame(&stage, frame);
            add_library(&library[i]);
            add_float(&with_float[i]);
        }
    }
    for (size_t i = 0; i < CHOICES; i++)
        printf("%s,%s,%s,%.2f,%.2f\n", drawn->scene, ways_lights(drawn), choices[i].name, psnr(&library[i]),
               psnr(&with_float[i]));
}

int main(void) {
    puts("scene,lights,choice,psnr_db,float_psnr_db");
    for (uint32_t i = 0; i < WAYS_SCENES; i++) {
        const workload drawn = ways_scene(i);
        judge_scene(&drawn);
    }
    return ferror(stdout) || fflush(stdout);
}
