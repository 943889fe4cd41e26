/* SPDX-License-Identifier: MIT */
/*
 * What is modelled of each benchmark scene, ten frames, each example scene, its middle frame, and a plane, as CSV, in
 * RGB565: means a frame of the pixels that each kernel covers and of the parts of triangles that it draws, and the
 * largest difference from the exact image. What the general kernel and vertices drop, light by light, the twin tells
 * that drops nothing: its rows have that in place of kernels.
 */
#include "bench.h"
#include "choices.h"
#include "picture.h"
#include "plane.h"
#include "scenes/scenes.h"
#include "ways.h"

#include <stdio.h>
#include <stdlib.h>

static const char *const kernels[GLINT_KERNELS] = {
    "general", "ambient", "diffuse", "gated", "specular", "curved_diffuse", "curved_specular", "even", "channels"};

/** Of the frames of a scene, drawn in one way. */
typedef struct total {
    uint64_t covered[GLINT_KERNELS], parts[GLINT_KERNELS];
    undropped_drops dropped;
    int largest; /* steps */
} total;

/** What a row begins with. */
typedef struct heading {
    const char *scene, *variant;
    int width, height;
    uint64_t frames;
} heading;

static void fail(const char *what) {
    fprintf(stderr, "modelled: %s\n", what);
    exit(1);
}

/* The largest difference of a channel, in steps. */
static int largest_difference(const picture *a, const picture *b) {
    int largest = 0;
    for (int y = 0; y < a->height; y++) {
        for (int x = 0; x < a->width; x++) {
            for (int channel = 0; channel < picture_channels(a->format); channel++) {
                const int steps = abs(picture_level(a, x, y, channel) - picture_level(b, x, y, channel));
                largest = steps > largest ? steps : largest;
            }
        }
    }
    return largest;
}

static void add(total *sum, const glint_stats *stats, int steps) {
    for (int kernel = 0; kernel < GLINT_KERNELS; kernel++) {
        sum->covered[kernel] += stats->drawn[kernel].covered;
        sum->parts[kernel] += stats->drawn[kernel].parts;
    }
    sum->dropped.lightings += undropped.lightings;
    sum->dropped.facing_away += undropped.facing_away;
    sum->dropped.out_of_reach += undropped.out_of_reach;
    sum->dropped.no_highlight += undropped.no_highlight;
    sum->dropped.parts_ambient += undropped.parts_ambient;
    sum->dropped.parts_matt += undropped.parts_matt;
    sum->largest = steps > sum->largest ? steps : sum->largest;
}

static picture draw(const way *chosen, const glint_scene *scene, int width, int height, glint_stats *stats) {
    static undropped_scene room;
    const glint_scene *made = scene_in_way(chosen, scene, &room);
    picture drawn = picture_open(width, height, format_in_way(chosen));
    if (!made || picture_render(&drawn, made, NULL, stats) != GLINT_OK)
        fail("the library refuses a scene");
    drawn.format = &glint_format_rgb565; /* as which the twin stores, too */
    return drawn;
}

/* Adds a frame, drawn in every way. */
static void add_frame(total sums[WAYS], const glint_scene *scene, int width, int height) {
    static const way exact = {"exact", 1, 0};
    glint_stats stats = {0};
    picture wanted = draw(&exact, scene, width, height, &stats);
    for (size_t i = 0; i < WAYS; i++) {
        undropped = (undropped_drops){0};
        stats = (glint_stats){0};
        picture drawn = draw(&ways[i], scene, width, height, &stats);
        const int steps = largest_difference(&drawn, &wanted);
        if (steps > ways[i].error_budget)
            fail("a difference above the error budget");
        add(&sums[i], &stats, steps);
        picture_close(&drawn);
    }
    picture_close(&wanted);
}

static void print_mean(uint64_t sum, uint64_t frames, const char *end) {
    printf("%llu%s", (unsigned long long)((sum + frames / 2) / frames), end);
}

static void print_rows(const heading *h, const total sums[WAYS]) {
    for (size_t i = 0; i < WAYS; i++) {
        const undropped_drops *dropped = &sums[i].dropped;
        printf("%s,%s,%dx%d,%s,", h->scene, h->variant, h->width, h->height, ways[i].name);
        for (int kernel = 0; kernel < GLINT_KERNELS; kernel++) {
            if (ways[i].drops) {
                print_mean(sums[i].covered[kernel], h->frames, ",");
                print_mean(sums[i].parts[kernel], h->frames, ",");
            } else {
                printf(",,");
            }
        }
        if (ways[i].drops) {
            printf(",,,,");
        } else {
            print_mean(dropped->lightings, h->frames, ",");
            print_mean(dropped->facing_away, h->frames, ",");
            print_mean(dropped->out_of_reach, h->frames, ",");
            print_mean(dropped->no_highlight, h->frames, ",");
        }
        printf("%d\n", sums[i].largest);
    }
}

static void bench_scenes(void) {
    static bench_mesh mesh;
    for (int which = 0; which < BENCH_SCENES; which++) {
        bench_build_mesh(&mesh, bench_definitions[which].shape, bench_definitions[which].around,
                         bench_definitions[which].along);
        for (size_t size = 0; size < CHOICE_SIZES; size++) {
            const heading h = {bench_definitions[which].name, "", choice_sizes[size][0], choice_sizes[size][1],
                               BENCH_FRAMES};
            total sums[WAYS] = {0};
            for (int frame = 0; frame < BENCH_FRAMES; frame++) {
                bench_scene scene;
                bench_build_scene(&scene, &bench_definitions[which], &mesh, frame);
                scene.scene.viewer = GLINT_VIEWER_LOCAL;
                add_frame(sums, &scene.scene, h.width, h.height);
            }
            print_rows(&h, sums);
        }
    }
}

static void gallery(void) {
    static example_stage stage;
    for (unsigned i = 0; i < EXAMPLE_SCENES; i++) {
        const example_scene *scene = example_scenes[i];
        for (uint32_t variant = 0; variant < scene->variant_count; variant++) {
            const heading h = {scene->name, scene->variants[variant].name, scene->width, scene->height, 1};
            total sums[WAYS] = {0};
            scene->build(&stage, variant, frame_in_middle(scene->frames));
            light_at_fragments(stage.objects, stage.scene.object_count);
            add_frame(sums, &stage.scene, h.width, h.height);
            print_rows(&h, sums);
        }
    }
}

/* Nothing of which can be dropped, or they are not what they are for. */
static void planes(void) {
    static plane_stage stage;
    for (size_t i = 0; i < PLANE_LIGHTS; i++) {
        const heading h = {"plane", plane_lights[i].name, PLANE_WIDTH, PLANE_HEIGHT, 1};
        total sums[WAYS] = {0};
        if (plane_build(&stage, &plane_lights[i]) != GLINT_OK)
            fail("no plane");
        add_frame(sums, &stage.scene, h.width, h.height);
        const undropped_drops *dropped = &sums[0].dropped;
        if (dropped->facing_away + dropped->out_of_reach + dropped->no_highlight + dropped->parts_ambient +
            dropped->parts_matt)
            fail("something of a plane can be dropped");
        print_rows(&h, sums);
    }
}

int main(void) {
    printf("scene,variant,size,way,");
    for (int kernel = 0; kernel < GLINT_KERNELS; kernel++)
        printf("%s_covered,%s_parts,", kernels[kernel], kernels[kernel]);
    puts("lightings,facing_away,out_of_reach,no_highlight,largest_steps");
    bench_scenes();
    gallery();
    planes();
    return ferror(stdout) || fflush(stdout);
}
