/* SPDX-License-Identifier: MIT */
/*
 * What the frames of the benchmark consist of, as CSV: the rows of docs/bench.csv that are frames of this library,
 * drawn in one pass, and of each what port/host/counts.h counts, the mean of its frames; then the same of the pictures
 * of docs/gallery-instructions.csv.
 */
#include "counts.h"
#include "framebuffer.h"
#include "memory.h"
#include "workloads.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** How else a benchmark scene is drawn; frames.c has the same. */
typedef struct way {
    const char *name; /* what its row says behind the size */
    glint_viewer viewer;
    uint16_t tile_width, tile_height;
    int anew, plain;
} way;

static const way as_ever = {"local 32x32", GLINT_VIEWER_LOCAL, 32, 32, 0, 0};
static const way ways[] = {
    {"infinite 32x32", GLINT_VIEWER_INFINITE, 32, 32, 0, 0}, {"local 16x16", GLINT_VIEWER_LOCAL, 16, 16, 0, 0},
    {"local 32x16", GLINT_VIEWER_LOCAL, 32, 16, 0, 0},       {"local 64x32", GLINT_VIEWER_LOCAL, 64, 32, 0, 0},
    {"local 64x64", GLINT_VIEWER_LOCAL, 64, 64, 0, 0},       {"local 32x32 anew", GLINT_VIEWER_LOCAL, 32, 32, 1, 0},
    {"local 32x32 plain", GLINT_VIEWER_LOCAL, 32, 32, 0, 1},
};

static uint32_t arena[(4 << 20) / sizeof(uint32_t)];
static workload_stage stage;

/* Counts look at what is drawn, not at pixels. */
static int drop(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context, (void)x, (void)y, (void)width, (void)height, (void)pixels, (void)stride;
    return 0;
}

static int fail(const workload *drawn, const char *what) {
    fprintf(stderr, "%s, %s: %s\n", drawn->scene, drawn->look, what);
    return 1;
}

/* Adds the counts of a frame to `sum`. @return 0, or 1 with a message */
static int add_frame(const workload *drawn, glint_renderer *renderer, frame_counts *sum) {
    frame_counts one;
    const glint_status status = counts_render(renderer, &stage.example.scene, &one);
    if (status != GLINT_OK) {
        return fail(drawn, glint_strerror(status));
    }
    for (int item = 0; item < COUNTS; item++) {
        sum->of[item] += one.of[item] / drawn->frames;
    }
    return 0;
}

/* Sets up a renderer for a workload's first frame. */
static glint_status begin(const workload *drawn, const way *how, glint_renderer *renderer) {
    static uint16_t tables[3][GLINT_GAMMA_ENTRIES];
    glint_config config = {.width = drawn->width,
                           .height = drawn->height,
                           .tile_width = how->tile_width,
                           .tile_height = how->tile_height,
                           .format = drawn->output->format,
                           .flush.begin = drop,
                           .arena = arena,
                           .arena_size = sizeof arena,
                           .keeps_arena = !how->anew,
                           .counts_drawn = 1};
    if (drawn->output->gamma) {
        workload_gamma(tables);
        config.gamma = (const uint16_t(*)[GLINT_GAMMA_ENTRIES])tables;
    }
    return glint_init(renderer, &config);
}

static void write_counts(const frame_counts *sum) {
    for (int item = 0; item < COUNTS; item++) {
        printf(",%.10g", sum->of[item]);
    }
    putchar('\n');
}

/* Writes a workload's row. @return 0, or 1 with a message */
static int count_row(const workload *drawn, const way *how) {
    frame_counts sum = {.stats = {0}};
    glint_renderer renderer;
    char text[WORKLOAD_TEXT];
    if (workload_build(&stage, drawn)) {
        return fail(drawn, "no such variant");
    }
    stage.mesh.clusters = how->plain ? NULL : stage.mesh.clusters;
    stage.example.scene.viewer = how == &as_ever ? stage.example.scene.viewer : how->viewer;
    for (uint32_t frame = 0; frame < drawn->frames; frame++) {
        workload_set_frame(&stage, frame);
        const glint_status status = frame == 0 ? begin(drawn, how, &renderer) : GLINT_OK;
        if (status != GLINT_OK) {
            return fail(drawn, glint_strerror(status));
        }
        if (add_frame(drawn, &renderer, &sum)) {
            return 1;
        }
    }
    if (how == &as_ever) {
        printf("%s,%s", drawn->scene, workload_variant(drawn, text));
    } else {
        printf("%s,%ux%u %s", drawn->scene, drawn->width, drawn->height, how->name);
    }
    write_counts(&sum);
    return 0;
}

/* Writes the row of a picture of the gallery: a first frame. @return 0, or 1 with a message */
static int count_picture(const example_scene *scene, uint32_t variant) {
    static const workload_output rgb565 = {"", &glint_format_rgb565, 0, 0};
    const char *const name = scene->variants[variant].name;
    const workload drawn = {.scene = scene->name,
                            .look = name,
                            .width = scene->width,
                            .height = scene->height,
                            .frames = 1,
                            .output = &rgb565};
    frame_counts sum = {.stats = {0}};
    glint_renderer renderer;
    scene->build(&stage.example, variant, 0);
    const glint_status status = begin(&drawn, &as_ever, &renderer);
    if (status != GLINT_OK) {
        return fail(&drawn, glint_strerror(status));
    }
    if (add_frame(&drawn, &renderer, &sum)) {
        return 1;
    }
    printf("%s,%s", scene->name, name);
    write_counts(&sum);
    return 0;
}

static int count_gallery(void) {
    int failed = 0;
    for (size_t i = 0; i < EXAMPLE_SCENES && !failed; i++) {
        for (uint32_t variant = 0; variant < example_scenes[i]->variant_count && !failed; variant++) {
            failed = count_picture(example_scenes[i], variant);
        }
    }
    return failed;
}

int main(void) {
#define NAME(name, what) "," #name
    puts("name,variant" COUNTS_ITEMS(NAME));
#undef NAME
    int failed = 0;
    for (uint32_t i = 0; i < workload_count() && !failed; i++) {
        const workload drawn = workload_get(i);
        if (!framebuffer_find_format(NULL, drawn.output->format)) {
            continue; /* no picture that the host shows */
        }
        failed = count_row(&drawn, &as_ever);
        for (size_t j = 0; i < WORKLOADS_PLAIN && drawn.width == 320 && j < sizeof ways / sizeof ways[0] && !failed;
             j++) {
            failed = count_row(&drawn, &ways[j]);
        }
    }
    failed = failed || count_gallery();
    return failed || ferror(stdout) || fflush(stdout);
}
