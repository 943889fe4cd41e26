/* SPDX-License-Identifier: MIT */
/*
 * What the eye sees of the formats of docs/cost.md from a distance, as CSV: the root mean square error of means over
 * 5x5 pixels, in steps of 255, against those of the unrounded picture in double precision. Squares that the object
 * does not fill are left out. The luma stands for the colour where a format has one channel.
 */
#include "../chart/truth.h"
#include "shown.h"

#include <math.h>

enum { WIDTH = 320, HEIGHT = 240, SIDE = 5 };

static workload_stage stage;
static reference_pixel truth[HEIGHT][WIDTH];

static void fail(const char *what) {
    fprintf(stderr, "means: %s\n", what);
    exit(1);
}

static double wanted(const reference_pixel *pixel, int channels, int channel) {
    const double *colour = pixel->colour;

    return channels == 1 ? 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2] : colour[channel];
}

/* @return the error of the mean over a square, of 1; NAN where the object does not fill it */
static double mean_error(const picture *drawn, int left, int top, int channel) {
    const int channels = picture_channels(drawn->format), most = picture_level_max(drawn->format, channel);
    double sum = 0;

    for (int y = top; y < top + SIDE; y++)
        for (int x = left; x < left + SIDE; x++) {
            if (!truth[y][x].covered)
                return NAN;
            sum += (double)picture_level(drawn, x, y, channel) / most - wanted(&truth[y][x], channels, channel);
        }
    return sum / (SIDE * SIDE);
}

static double root_mean_square(const picture *drawn) {
    double squares = 0;
    long samples = 0;

    for (int y = 0; y <= HEIGHT - SIDE; y++)
        for (int x = 0; x <= WIDTH - SIDE; x++)
            for (int channel = 0; channel < picture_channels(drawn->format); channel++) {
                const double error = mean_error(drawn, x, y, channel);
                if (!isnan(error)) {
                    squares += error * error;
                    samples++;
                }
            }
    return samples ? sqrt(squares / (double)samples) : NAN;
}

int main(void) {
    const reference_image image = {WIDTH, HEIGHT, truth[0]};

    puts("format,mean_rms_lsb8");
    for (uint32_t i = 0; i < workload_count(); i++) {
        workload drawn = workload_get(i);
        if (*drawn.look || !cost_is_shown(&drawn))
            continue;
        drawn.by_default = 1;
        if (workload_build(&stage, &drawn))
            fail("a scene cannot be built");
        truth_draw(&image, &stage.example.scene);
        picture shown = picture_open(WIDTH, HEIGHT, drawn.output->format);
        if (picture_render(&shown, &stage.example.scene, NULL, NULL) != GLINT_OK)
            fail("the library refuses a scene");
        printf("%s,%.3f\n", *drawn.output->name ? drawn.output->name : "rgb565", 255 * root_mean_square(&shown));
        picture_close(&shown);
    }
    return ferror(stdout) || fflush(stdout);
}
