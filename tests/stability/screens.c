/* SPDX-License-Identifier: MIT */
/* Regions: screens that tiles do not divide, and the borders between tiles. */
#include "picture.h"
#include "region.h"

#include "library_geometry.h"
#include "reference.h"

#include <math.h>
#include <stdlib.h>

static const glint_format *const formats[2] = {&glint_format_rgb888, &glint_format_rgb565};

/* Pixels that were not sent exactly once; those outside end the frame. */
static void count_sent(const random_scene *s, region_figures *figures) {
    for (int format = 0; format < 2; format++) {
        picture image = picture_open(s->width, s->height, formats[format]);
        glint_status status = picture_render(&image, &s->scene, NULL, NULL);
        for (int i = 0; i < s->width * s->height; i++)
            figures->library[format] += status != GLINT_OK || image.sent[i] != 1;
        picture_close(&image);
    }
}

static void measure_size(int width, int height, region_figures *figures) {
    random_scene s;
    region_figures colours = {0};
    region_sphere(&s, 9, 8);
    s.width = width;
    s.height = height;
    const int tiles = (width + 31) / 32 * ((height + 31) / 32);
    figures->plain += tiles * 32 * 32 - width * height;
    region_judge_viewers(&s, &colours);
    for (int format = 0; format < 2; format++)
        judgement_add(&figures->found[format], &colours.found[format]);
    count_sent(&s, figures);
}

static void measure_odd_sizes(region_figures *figures) {
    measure_size(150, 101, figures);
    measure_size(33, 31, figures);
    measure_size(31, 33, figures);
}

static void measure_narrow(region_figures *figures) {
    measure_size(1, 100, figures);
    measure_size(100, 1, figures);
    measure_size(1, 1, figures);
}

/* ---- Seams --------------------------------------------------------------------------------------------------- */

/* A smooth surface under a wide highlight, all over the screen. */
static void make_smooth(random_scene *s) {
    static const double bent[4][3] = {{-0.5, -0.5, 1}, {0.5, -0.5, 1}, {0.5, 0.5, 1}, {-0.5, 0.5, 1}};
    region_square(s);
    region_normals(s, bent);
    region_light(s, 0.3, 0.4, 0.6);
    s->width = s->height = 128;
    s->objects[0].pose.m[2][3] = region_q16(-2.8);
    s->scene.viewer = GLINT_VIEWER_LOCAL;
}

/* What tiles' borders add: the largest change from a pixel to the next across them, over that elsewhere. */
typedef struct seam {
    double across, inside;
} seam;

static void add_change(seam *found, int at, double change) {
    region_raise(at % 32 == 0 ? &found->across : &found->inside, fabs(change));
}

/* Of the image's error: the surface's own changes would hide a seam. */
static seam find_seams(const random_scene *s, const glint_format *format) {
    seam found = {0, 0};
    picture image = picture_open(s->width, s->height, format);
    glint_config config = picture_config(&image, NULL);
    library_geometry geometry;
    reference_image wanted = {s->width, s->height, malloc((size_t)(s->width * s->height) * sizeof *wanted.pixels)};
    if (wanted.pixels == NULL || library_geometry_open(&geometry, &config, &s->scene) != GLINT_OK ||
        picture_render(&image, &s->scene, NULL, NULL) != GLINT_OK)
        abort();
    reference_render(&wanted, &s->scene, (const reference_position *const *)geometry.positions);
    const int top = picture_level_max(format, 1);
    for (int i = 0; i < s->width * s->height; i++)
        wanted.pixels[i].colour[1] =
            picture_level(&image, i % s->width, i / s->width, 1) - wanted.pixels[i].colour[1] * top;
    for (int y = 1; y < s->height; y++) {
        for (int x = 1; x < s->width; x++) {
            const reference_pixel *here = &wanted.pixels[y * s->width + x];
            add_change(&found, x, here->colour[1] - here[-1].colour[1]);
            add_change(&found, y, here->colour[1] - here[-s->width].colour[1]);
        }
    }
    free(wanted.pixels);
    library_geometry_close(&geometry);
    picture_close(&image);
    return found;
}

/* cos^p along a row where V is that of each tile's middle. */
static double constant_view(double p) {
    double across = 0;
    double inside = 0;
    double last = 0;
    for (int x = 0; x < 320; x++) {
        double tile = (floor(x / 32.0) * 32 + 15.5 - 160) / 300;
        double value = 255 * pow(fmax(cos(0.5 * atan(tile) + 0.003 * (x - 160)), 0), p);
        if (x > 0)
            region_raise(x % 32 == 0 ? &across : &inside, fabs(value - last));
        last = value;
    }
    return across - inside;
}

static void measure_seams(region_figures *figures) {
    random_scene s;
    figures->plain = constant_view(64);
    make_smooth(&s);
    for (int i = 0; i < 3; i++) {
        s.materials[0].shininess = (i + 1) * (i + 1) * 8 * GLINT_ONE;
        for (int format = 0; format < 2; format++) {
            seam found = find_seams(&s, formats[format]);
            region_raise(&figures->library[format], found.across - found.inside);
            figures->bound[format] = 0.25;
        }
    }
}

const region screen_regions[] = {
    {"screens of 150 x 101, 33 x 31, 31 x 33", "whole tiles of 32 x 32", "pixels outside, or not sent once",
     "cuts tiles at the screen's edge", 1000, measure_odd_sizes},
    {"screens of 1 x 100, 100 x 1, 1 x 1", "whole tiles of 32 x 32", "pixels outside, or not sent once", "the same",
     1000, measure_narrow},
    {"tile borders", "view vector of the tile's middle",
     "steps by which a change across a border passes the largest elsewhere",
     "every pixel's value comes from its triangle alone, whatever the tile", 5, measure_seams},
};
const unsigned screen_region_count = sizeof screen_regions / sizeof screen_regions[0];
