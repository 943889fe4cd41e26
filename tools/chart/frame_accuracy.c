/* SPDX-License-Identifier: MIT */
/*
 * How right whole frames of the benchmark scenes are, as CSV: ten frames of each scene, size, format, choice of shading
 * and exponent, held against the double-precision reference. `against` tells which: "scene" is what the scene asks for,
 * Blinn-Phong per fragment for a local viewer, whatever the choice; "own" is the choice's own model and viewer.
 */
#include "bench.h"
#include "choices.h"
#include "judge.h"
#include "quantise.h"
#include "truth.h"

#include <math.h>

#define PIXELS_MAX (320 * 240)
#define CHANNELS 3

static const int exponents[] = {1, 2, 8, 32, 64, 256, 1024};
#define EXPONENTS (sizeof exponents / sizeof *exponents)

/** What the contract allows, in steps of a channel whose light weights sum to at most 1, and above. */
typedef struct output {
    const char *name;
    const glint_format *format;
    double fine, slope;
} output;

static const output outputs[] = {{"rgb565", &glint_format_rgb565, 0.75, 0.25},
                                 {"rgb888", &glint_format_rgb888, 0.8, 0.3}};
#define OUTPUTS (sizeof outputs / sizeof *outputs)

/** A row of the table: pixels by how far off they are, and the sum of squared errors. */
typedef struct row {
    long judged, gated, within_fine, within_bound, within_one, within_two;
    int frames, frames_bound, frames_one, frames_two; /* all, and those that keep each part of the contract */
    double worst;                                     /* steps from the unrounded reference */
    double squares;
    long samples;
} row;

/** The reference of a frame. */
typedef struct truth {
    reference_pixel pixels[PIXELS_MAX];
    double depth_scale;
} truth;

static bench_mesh mesh;

static double bound(const output *kind, const bench_scene *scene, int channel) {
    const glint_colour *diffuse = &scene->material.diffuse, *specular = &scene->material.specular;
    const glint_q16 sums[CHANNELS] = {diffuse->r + specular->r, diffuse->g + specular->g, diffuse->b + specular->b};
    const double sum = sums[channel] / 65536.0; /* the light is white, of weight 1 */
    return sum <= 1 ? kind->fine : 0.5 + kind->slope * sum;
}

static void add_pixel(row *total, const output *kind, const bench_scene *scene, const picture *drawn,
                      const reference_pixel *wanted, int x, int y, int close) {
    double worst = 0;
    int steps = 0, bounded = 1;
    for (int channel = 0; channel < CHANNELS; channel++) {
        const int max = picture_level_max(kind->format, channel);
        const double level = wanted->colour[channel] * max;
        const int stored = drawn ? picture_level(drawn, x, y, channel) : (int)floor(level + 0.5);
        const double error = fabs(stored - level);
        const int off = abs(stored - (int)floor(level + 0.5));
        total->squares += error / max * (error / max);
        worst = fmax(worst, error);
        steps = off > steps ? off : steps;
        bounded &= error <= bound(kind, scene, channel);
    }
    total->samples += CHANNELS;
    if (close)
        return;
    if (wanted->grazing < JUDGE_GATE) {
        total->gated++;
        return;
    }
    total->judged++;
    total->within_fine += worst <= kind->fine;
    total->within_bound += bounded;
    total->within_one += steps <= 1;
    total->within_two += steps <= 2;
    total->worst = fmax(total->worst, worst);
}

/* Are at most 1 in `share` pixels beyond, or one of them? */
static int keeps(long within, long judged, long share) {
    return judged - within <= 1 || (judged - within) * share <= judged;
}

static void add_frame(row *total, const row *frame) {
    total->judged += frame->judged;
    total->gated += frame->gated;
    total->within_fine += frame->within_fine;
    total->within_bound += frame->within_bound;
    total->within_one += frame->within_one;
    total->within_two += frame->within_two;
    total->worst = fmax(total->worst, frame->worst);
    total->squares += frame->squares;
    total->samples += frame->samples;
    total->frames++;
    total->frames_bound += keeps(frame->within_bound, frame->judged, 1000);
    total->frames_one += keeps(frame->within_one, frame->judged, 10000);
    total->frames_two += frame->within_two == frame->judged;
}

/* Adds a picture, or without one the reference itself correctly rounded. */
static void add_picture(row *total, const output *kind, const bench_scene *scene, const picture *drawn,
                        const truth *right, const uint16_t size[2]) {
    row frame = {0};
    for (int y = 0; y < size[1]; y++) {
        for (int x = 0; x < size[0]; x++) {
            const reference_pixel *wanted = &right->pixels[y * size[0] + x];
            const int close = (wanted->nearest - wanted->second) * right->depth_scale < JUDGE_CLOSE_STEPS;
            if (wanted->covered)
                add_pixel(&frame, kind, scene, drawn, wanted, x, y, close);
        }
    }
    add_frame(total, &frame);
}

static void fail(const char *what) {
    fprintf(stderr, "frame accuracy: %s\n", what);
    exit(1);
}

static void build_frame(bench_scene *scene, int which, int frame, const choice *chosen, int exponent) {
    bench_build_scene(scene, &bench_definitions[which], &mesh, frame);
    scene->material.shininess = exponent * GLINT_ONE;
    if (chosen)
        choose(chosen, &scene->scene, &scene->object, &scene->material);
}

static void find_truth(truth *right, const bench_scene *scene, const uint16_t size[2]) {
    const reference_image image = {size[0], size[1], right->pixels};

    right->depth_scale = truth_draw(&image, &scene->scene);
}

static void draw(row *total, const output *kind, const bench_scene *scene, const truth *right, const uint16_t size[2]) {
    picture drawn = picture_open(size[0], size[1], kind->format);
    if (picture_render(&drawn, &scene->scene, NULL, NULL) != GLINT_OK)
        fail("the library refuses a scene");
    add_picture(total, kind, scene, &drawn, right, size);
    picture_close(&drawn);
}

static double percent(long part, long whole) {
    return 100.0 * (double)part / (double)whole;
}

static void print_row(const row *total, int which, const uint16_t size[2], const output *kind, const char *name,
                      int exponent, const char *against) {
    if (total->judged == 0)
        fail("nothing was drawn");
    printf("%s,%dx%d,%s,%s,%d,%s,%.2f,%.4f,%.4f,%.4f,%.4f,%.3f,%ld,%ld,%d,%d,%d,%d\n", bench_definitions[which].name,
           size[0], size[1], kind->name, name, exponent, against, -10 * log10(total->squares / (double)total->samples),
           percent(total->within_fine, total->judged), percent(total->within_bound, total->judged),
           percent(total->within_one, total->judged), percent(total->within_two, total->judged), total->worst,
           total->judged + total->gated, total->gated, total->frames, total->frames_bound, total->frames_one,
           total->frames_two);
}

/* Every choice against the scene as it is. */
static void judge_choices(int which, const uint16_t size[2], truth *right) {
    static const int exponent = 32;
    row rows[CHOICES + 1] = {{0}};
    for (int frame = 0; frame < BENCH_FRAMES; frame++) {
        bench_scene scene;
        build_frame(&scene, which, frame, NULL, exponent);
        find_truth(right, &scene, size);
        add_picture(&rows[CHOICES], &outputs[0], &scene, NULL, right, size);
        for (size_t i = 0; i < CHOICES; i++) {
            build_frame(&scene, which, frame, &choices[i], exponent);
            draw(&rows[i], &outputs[0], &scene, right, size);
        }
    }
    for (size_t i = 0; i <= CHOICES; i++)
        print_row(&rows[i], which, size, &outputs[0], i < CHOICES ? choices[i].name : "correctly rounded", exponent,
                  "scene");
}

/* A choice against its own model, for which the contract is given. */
static void judge_own(int which, const uint16_t size[2], const choice *chosen, int exponent, truth *right) {
    row rows[OUTPUTS] = {{0}};
    for (int frame = 0; frame < BENCH_FRAMES; frame++) {
        bench_scene scene;
        build_frame(&scene, which, frame, chosen, exponent * chosen->shininess_divisor);
        find_truth(right, &scene, size);
        for (size_t i = 0; i < OUTPUTS; i++)
            draw(&rows[i], &outputs[i], &scene, right, size);
    }
    for (size_t i = 0; i < OUTPUTS; i++)
        print_row(&rows[i], which, size, &outputs[i], chosen->name, exponent, "own");
}

static void judge_contract(int which, const uint16_t size[2], truth *right) {
    for (size_t i = 0; i < CHOICES; i++) {
        const int has_highlight = choices[i].model != &glint_model_lambert;
        const int is_held = choices[i].evaluation == &glint_per_fragment;
        for (size_t p = 0; p < EXPONENTS && is_held; p++)
            if (has_highlight || p == 0)
                judge_own(which, size, &choices[i], exponents[p], right);
    }
}

int main(void) {
    static truth right;
    puts("scene,size,format,choice,p,against,psnr_db,within_fine_percent,within_bound_percent,within_one_percent,"
         "within_two_percent,worst_steps,pixels,left_out,frames,frames_within_bound,frames_within_one,frames_within_"
         "two");
    for (int which = 0; which < BENCH_SCENES; which++) {
        bench_build_mesh(&mesh, bench_definitions[which].shape, bench_definitions[which].around,
                         bench_definitions[which].along);
        cluster_mesh(&mesh.mesh); /* as instructions are counted */
        for (size_t i = 0; i < CHOICE_SIZES; i++) {
            judge_choices(which, choice_sizes[i], &right);
            judge_contract(which, choice_sizes[i], &right);
        }
    }
    return ferror(stdout) || fflush(stdout);
}
