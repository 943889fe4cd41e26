/* SPDX-License-Identifier: MIT */
/*
 * Suite: pictures of the float renderer that frames are compared with, against the double-precision reference, for
 * each workload of the benchmark in RGB565. Its coverage is judged for the vertices as it snapped them, its colours by
 * PSNR over covered pixels: what is lit per vertex or per facet is held against a reference that is lit so too.
 */
#include "harness.h"
#include "snapped.h"
#include "workloads.h"

#include <math.h>
#include <stdio.h>

#define PIXELS (320 * 240)

/* Decibels. RGB565 itself allows about 42. */
#define PSNR_LEAST 41.0

/*
 * Of covered pixels, those whose centre an edge passes so near that a sum of floats decides: drawn where nothing is, or
 * the other way about, or in the colour of the triangle beyond the edge, which is off by more than WRONG_COLOUR.
 */
#define MISSED_SHARE 1000
#define WRONG_COLOUR 0.125

typedef struct found {
    long covered, missed, samples;
    double squares; /* of errors, levels as 0..1 */
} found;

static uint16_t colour[PIXELS];
static int32_t depth[PIXELS];
static float_memory memory;
static reference_pixel exact[PIXELS];

/* ---- Pixels ---- */

static double squares_of(const double errors[3]) {
    return errors[0] * errors[0] + errors[1] * errors[1] + errors[2] * errors[2];
}

static void errors_of(uint16_t pixel, const double wanted[3], double errors[3]) {
    const double levels[3] = {(pixel >> 11) / 31.0, (pixel >> 5 & 63) / 63.0, (pixel & 31) / 31.0};

    for (int channel = 0; channel < 3; channel++)
        errors[channel] = fabs(levels[channel] - wanted[channel]);
}

static void compare(const float_screen *screen, found *total) {
    for (uint32_t i = 0; i < screen->width * screen->height; i++) {
        const reference_pixel *pixel = &exact[i];
        const int drawn = depth[i] > 0;
        double errors[3];

        if (pixel->uncertain)
            continue;
        errors_of(colour[i], pixel->colour, errors);
        total->covered += pixel->covered;
        if (drawn != pixel->covered || (drawn && fmax(errors[0], fmax(errors[1], errors[2])) > WRONG_COLOUR)) {
            total->missed++;
        } else if (drawn) {
            total->squares += squares_of(errors);
            total->samples += 3;
        }
    }
}

static void report(const char *name, const char *look, const float_screen *screen, const found *total) {
    const double psnr = -10 * log10(total->squares / (double)total->samples);
    char line[200];

    snprintf(line, sizeof line, "%-16s %-40s %3ux%-3u %8ld covered %5ld missed %6.2f dB\n", name, look,
             (unsigned)screen->width, (unsigned)screen->height, total->covered, total->missed, psnr);
    test_write(line);
    CHECK(total->samples > 0);
    CHECK(psnr >= PSNR_LEAST);
    CHECK_AT_MOST(total->missed * MISSED_SHARE, total->covered);
}

/* ---- Workloads ---- */

static workload_stage stage;

static void judge_workload(const workload *drawn) {
    const float_screen screen = {drawn->width, drawn->height, colour, depth};
    const uint32_t frames = drawn->example ? 1 : drawn->frames; /* example scenes stand still */
    found total = {0};

    if (!CHECK_EQUAL(workload_build(&stage, drawn), 0))
        return;
    if (!workload_is_bare(&stage)) /* more than this renderer draws */
        return;
    for (uint32_t frame = 0; frame < frames; frame++) {
        workload_set_frame(&stage, frame);
        float_draw_reference(&screen, &memory, &stage.example.scene, exact);
        float_render(&screen, &memory, &stage.example.scene);
        compare(&screen, &total);
    }
    report(drawn->scene, drawn->look, &screen, &total);
}

/* ---- Cases ---- */

/* Workloads in RGB565 of a part of the list. */
static void judge_all(uint32_t first, uint32_t end) {
    uint32_t judged = 0;

    for (uint32_t i = first; i < end; i++) {
        const workload drawn = workload_get(i);
        if (*drawn.output->name == '\0') {
            judge_workload(&drawn);
            judged++;
        }
    }
    CHECK(judged > 0);
}

static void benchmark_scenes(void) {
    judge_all(0, WORKLOADS_PLAIN);
}

static void other_workloads(void) {
    judge_all(WORKLOADS_PLAIN, workload_count());
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(benchmark_scenes), TEST_CASE(other_workloads)};
    return test_run(write, cases, TEST_COUNT(cases));
}
