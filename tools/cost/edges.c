/* SPDX-License-Identifier: MIT */
/*
 * How near to a picture of 64 samples a pixel the ways to draw edges of docs/cost.md come, as CSV: the peak signal to
 * noise ratio of pixels of which any sample shows the object, and of those of which some samples do and some do not.
 * The truth is the mean of 8x8 samples in double precision: of 4x4 pictures of twice the size, for each of which the
 * vertices are moved by quarters of its pixels.
 */
#include "../chart/truth.h"
#include "shown.h"

#include <math.h>

enum { WIDTH = 320, HEIGHT = 240, TWICE = 2, SHIFTS = 4, VERTICES_MAX = 1024 };
enum { SAMPLES = TWICE * TWICE * SHIFTS * SHIFTS };

static workload_stage stage;
static reference_pixel drawn_once[TWICE * HEIGHT][TWICE * WIDTH];

/* A pixel's colour, and of how many of its samples it is the object's. */
static struct {
    double colour[3];
    int covered;
} truth[HEIGHT][WIDTH];

static void fail(const char *what) {
    fprintf(stderr, "edges: %s\n", what);
    exit(1);
}

/* Draws a picture of twice the size whose samples lie 2 x + `right` and 2 y + `down` sixteenths from pixels' middles.
 */
static void add_samples(const glint_scene *scene, int right, int down) {
    static reference_position moved[VERTICES_MAX];
    const reference_position *const positions[1] = {moved};
    const reference_image image = {TWICE * WIDTH, TWICE * HEIGHT, drawn_once[0]};
    const uint32_t count = scene->objects[0].mesh->vertex_count;

    if (scene->object_count != 1 || count > VERTICES_MAX)
        fail("one object of up to 1024 vertices is drawn");
    for (uint32_t i = 0; i < count; i++) {
        const reference_vertex vertex = reference_transform(scene, 0, i, image.width, image.height);
        moved[i] = (reference_position){(int32_t)lrint(16 * vertex.x) - right, (int32_t)lrint(16 * vertex.y) - down,
                                        vertex.w > 0};
    }
    reference_render(&image, scene, positions);
    for (int y = 0; y < image.height; y++)
        for (int x = 0; x < image.width; x++) {
            truth[y / TWICE][x / TWICE].covered += drawn_once[y][x].covered;
            for (int channel = 0; channel < 3; channel++)
                truth[y / TWICE][x / TWICE].colour[channel] += drawn_once[y][x].colour[channel] / SAMPLES;
        }
}

static double psnr(const picture *drawn, int are_edges) {
    double squares = 0;
    long count = 0;

    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            for (int channel = 0; channel < 3; channel++) {
                const double shown = (double)picture_level(drawn, x, y, channel) /
                                     picture_level_max(drawn->format, channel),
                             error = shown - truth[y][x].colour[channel];
                if (truth[y][x].covered == 0 || (are_edges && truth[y][x].covered == SAMPLES))
                    continue;
                squares += error * error;
                count++;
            }
    return -10 * log10(squares / (double)count);
}

static int is_listed(const workload *drawn) {
    return cost_is_shown(drawn) && (!*drawn->look || cost_same_text(drawn->look, "2x2 samples")) &&
           (!*drawn->output->name || cost_same_text(drawn->output->name, "rgb565 dithered"));
}

int main(void) {
    int is_known = 0;

    puts("look,format,psnr_db,edges_psnr_db");
    for (uint32_t i = 0; i < workload_count(); i++) {
        workload drawn = workload_get(i);
        if (!is_listed(&drawn))
            continue;
        drawn.by_default = 1;
        if (workload_build(&stage, &drawn))
            fail("a scene cannot be built");
        for (int shift = 0; shift < SHIFTS * SHIFTS && !is_known; shift++)
            add_samples(&stage.example.scene, 4 * (shift % SHIFTS) - 6, 4 * (shift / SHIFTS) - 6);
        is_known = 1;
        const picture_options how = {.samples = stage.example.samples};
        picture shown = picture_open(WIDTH, HEIGHT, drawn.output->format);
        if (picture_render(&shown, &stage.example.scene, &how, NULL) != GLINT_OK)
            fail("the library refuses a scene");
        printf("%s,%s,%.2f,%.2f\n", drawn.look, drawn.output->name, psnr(&shown, 0), psnr(&shown, 1));
        picture_close(&shown);
    }
    return ferror(stdout) || fflush(stdout);
}
