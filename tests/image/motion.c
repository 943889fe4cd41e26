/* SPDX-License-Identifier: MIT */
/*
 * Suite: slow motion. From one frame to the next, a hundredth of a degree or a fiftieth of a pixel on, no pixel jumps
 * by more than one step of RGB565 where double precision stands still: whatever way a triangle is drawn in, it does not
 * show when another one takes over.
 */
#include "bench.h"
#include "glint.h"
#include "harness.h"
#include "library_geometry.h"
#include "picture.h"
#include "reference.h"
#include "scenes.h"
#include "scenes/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define WIDTH 160
#define HEIGHT 120
#define FRAMES 40

/* A pixel stands still where no channel of the reference changes by more than this, steps of RGB565. */
#define STILL 0.25

/* A frame of the library, and the reference's of the same snapped vertices. */
typedef struct shot {
    picture image;
    double depth_scale; /* steps of depth per 1/w */
    reference_pixel pixels[WIDTH * HEIGHT];
} shot;

static void take(shot *to, const glint_scene *scene) {
    const glint_config config = picture_config(&to->image, NULL);
    const reference_image image = {WIDTH, HEIGHT, to->pixels};
    library_geometry geometry;
    CHECK_EQUAL(library_geometry_open(&geometry, &config, scene), GLINT_OK);
    reference_render(&image, scene, (const reference_position *const *)geometry.positions);
    to->depth_scale = geometry.depth_scale;
    library_geometry_close(&geometry);
    CHECK_EQUAL(picture_render(&to->image, scene, NULL, NULL), GLINT_OK);
}

/* What all shots together showed. */
typedef struct found {
    long still, jumps;
    int largest;
} found;

/* Does anything but light decide on a pixel: a rounded edge, a surface or a texel as near, an angle at which light
 * begins? */
static int is_decided(const shot *of, int i) {
    const reference_pixel *pixel = &of->pixels[i];
    const int is_close = (pixel->nearest - pixel->second) * of->depth_scale < 2;
    const int has_texels = pixel->unsettled || pixel->choice_count > 1;
    return !pixel->covered || pixel->uncertain || is_close || has_texels || pixel->grazing < 0.01;
}

/* Does a pixel stand still? */
static int is_still(const shot *a, const shot *b, int i) {
    double most = 0;
    if (is_decided(a, i) || is_decided(b, i))
        return 0;
    for (int c = 0; c < 3; c++)
        most =
            fmax(most, fabs(a->pixels[i].colour[c] - b->pixels[i].colour[c]) * picture_level_max(a->image.format, c));
    return most < STILL;
}

static void compare(const shot *a, const shot *b, found *to) {
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        if (!is_still(a, b, i))
            continue;
        int largest = 0;
        for (int c = 0; c < 3; c++) {
            const int steps = abs(picture_level(&a->image, i % WIDTH, i / WIDTH, c) -
                                  picture_level(&b->image, i % WIDTH, i / WIDTH, c));
            largest = steps > largest ? steps : largest;
        }
        to->still++;
        to->jumps += largest > 1;
        to->largest = largest > to->largest ? largest : to->largest;
    }
}

static shot shots[2];

/* Moves a scene a little from frame to frame, and compares each with the one before. */
static void follow(glint_scene *scene, glint_pose *pose, const char *name) {
    char line[120];
    found all = {0, 0, 0};
    const glint_pose start = *pose;
    for (int frame = 0; frame < FRAMES; frame++) {
        const glint_pose turn = glint_pose_rotate_y(frame * GLINT_Q16(0.01)), there = glint_pose_then(&turn, &start);
        *pose = there;
        pose->m[2][3] += frame * (GLINT_ONE / 512);
        take(&shots[frame % 2], scene);
        if (frame > 0)
            compare(&shots[(frame + 1) % 2], &shots[frame % 2], &all);
    }
    *pose = start;
    snprintf(line, sizeof line, "  %-44s %8ld pixels stand still, %ld jump, by %d steps at most\n", name, all.still,
             all.jumps, all.largest);
    test_write(line);
    CHECK(all.still > 20L * FRAMES);
    CHECK_EQUAL(all.jumps, 0);
}

static void open_shots(void) {
    for (int i = 0; i < 2; i++)
        shots[i].image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
}

static void close_shots(void) {
    for (int i = 0; i < 2; i++)
        picture_close(&shots[i].image);
}

/* Meshes of the benchmark, coarse and fine, by each evaluation, with exponents and viewers of all kinds. */
static void bench_scenes(void) {
    static const int exponents[] = {1, 8, 32, 200};
    static const glint_evaluation *const evaluations[] = {&glint_per_fragment, &glint_per_vertex};
    open_shots();
    for (unsigned i = 0; i < 4 * BENCH_SCENES; i++) {
        const unsigned which = i % BENCH_SCENES;
        bench_scene scene;
        char name[80];
        bench_build_scene(&scene, &bench_definitions[which], scene_bench_mesh((int)which), (int)i);
        scene.material.shininess = exponents[i / BENCH_SCENES] * GLINT_ONE;
        scene.scene.viewer = i % 2 ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
        scene.object.evaluation = evaluations[i % 3 == 2];
        snprintf(name, sizeof name, "%s, p = %d, per %s", bench_definitions[which].name, exponents[i / BENCH_SCENES],
                 i % 3 == 2 ? "vertex" : "fragment");
        follow(&scene.scene, &scene.object.pose, name);
    }
    close_shots();
}

/* Lights of all kinds, near and large ones. */
static void example_variants(void) {
    static example_stage stage;
    open_shots();
    for (unsigned i = 0; i < EXAMPLE_SCENES; i++) {
        const example_scene *scene = example_scenes[i];
        for (uint32_t variant = 0; variant < scene->variant_count; variant += 5) {
            scene->build(&stage, variant, 0);
            follow(&stage.scene, &stage.objects[0].pose, scene->variants[variant].name);
        }
    }
    close_shots();
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(bench_scenes), TEST_CASE(example_variants)};
    return test_run(write, cases, TEST_COUNT(cases));
}
