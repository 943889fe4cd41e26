/* SPDX-License-Identifier: MIT */
/*
 * Suite: the accuracy contract of every pixel format, dithered or not, which is about the value before it is rounded. A
 * stored level is floor(v + t), t being 1/2 or the pixel's threshold, and v is within weights_slack of the reference r:
 * what is stored is then within that, and half a level, of r + 1/2 - t (contract.h). What this leaves after rounding:
 * levels of 4 bits and of 1 are within one of floor(r + t) in every pixel that counts, and other than floor(r + t) in
 * few. And what happens to a colour once it is lit: ordered dithering and the output tables.
 */
#include "bench.h"
#include "every_format.h"
#include "glint.h"
#include "harness.h"
#include "picture.h"
#include "sample.h"
#include "scenes.h"
#include "scenes/scenes.h"
#include "stability/contract.h"
#include "stability/random_scene.h"
#include "stability/weights.h"

#include <math.h>
#include <stdio.h>

/* ---- What is stored, against the reference ---- */

typedef struct tested {
    const char *name;
    const glint_format *format;
    /*
     * Share of the pixels that may be other than the rounded reference. Within 0.15 dB of that, as the contract of
     * RGB565 says, are errors of 0.054 steps, root mean square; where they are uniform, 4.7 % of the pixels differ in
     * one channel.
     */
    double most_apart;
} tested;

/* Its place in the table. */
#define RGB888 4

static const tested formats[] = {
    {"RGB565", &glint_format_rgb565, 0.03},
    {"RGB565 dithered", &glint_format_rgb565_dithered, 0.03},
    {"RGB565 big-endian", &glint_format_rgb565_be, 0.03},
    {"RGB565 big-endian, dithered", &glint_format_rgb565_be_dithered, 0.03},
    {"RGB888", &glint_format_rgb888, 0.06},
    {"RGB888 dithered", &glint_format_rgb888_dithered, 0.06},
    {"RGB444", &glint_format_rgb444, 0.01},
    {"RGB444 dithered", &glint_format_rgb444_dithered, 0.01},
    {"grey8", &glint_format_grey8, 0.03},
    {"grey8 dithered", &glint_format_grey8_dithered, 0.03},
    {"grey4", &glint_format_grey4, 0.003},
    {"grey4 dithered", &glint_format_grey4_dithered, 0.003},
    {"mono", &glint_format_mono, 0.0002},
    {"mono dithered", &glint_format_mono_dithered, 0.0002},
    {"mono in pages", &glint_format_mono_pages, 0.0002},
    {"mono in pages, dithered", &glint_format_mono_pages_dithered, 0.0002},
};

/* Of each format, over all scenes. */
typedef struct tally {
    judgement found;
    double worst_share;
    long scenes;
} tally;

static tally tallies[TEST_COUNT(formats)];
static unsigned turn;

static int is_coarse(const glint_format *format) {
    return picture_level_max(format, 0) <= 15;
}

static void judge_in(unsigned kind, const glint_scene *scene, int width, int height, const char *name) {
    contract_result result;
    tally *to = &tallies[kind];
    char line[200];
    contract_judge(scene, width, height, formats[kind].format, &result);
    const long far = is_coarse(formats[kind].format) ? result.found.over_one : 0;
    if (!CHECK(contract_holds(&result) && far == 0)) {
        snprintf(
            line, sizeof line,
            "  %s, %s: status %d, missed %ld, spilled %ld, %ld of %ld over, one %ld, two %ld, worst %.4f of %.4f\n",
            name, formats[kind].name, result.found.status, result.found.missed, result.found.spilled,
            result.found.not_fine, result.found.judged, result.found.over_one, result.found.over_two,
            result.found.worst, result.bound);
        test_write(line);
    }
    to->scenes++;
    to->worst_share = fmax(to->worst_share, (result.found.worst - 0.5) / (result.bound - 0.5));
    judgement_add(&to->found, &result.found);
}

/* In so many formats, others for each scene. */
static void judge_some(unsigned count, const glint_scene *scene, int width, int height, const char *name) {
    for (unsigned i = 0; i < count; i++)
        judge_in(turn++ % TEST_COUNT(formats), scene, width, height, name);
}

static void bench_scenes(void) {
    static const int exponents[] = {1, 2, 8, 32, 64, 256, 1024};
    static const glint_shading_model *const models[] = {&glint_model_blinn_phong, &glint_model_phong};
    for (unsigned i = 0; i < 4 * BENCH_SCENES * 7 * 3; i++) {
        bench_scene scene;
        const unsigned which = i / 84, viewer = i / 42 % 2;
        bench_build_scene(&scene, &bench_definitions[which], scene_bench_mesh((int)which), (int)(i % 10));
        scene.material.model = models[i / 21 % 2];
        scene.material.shininess = exponents[i / 3 % 7] * GLINT_ONE;
        scene.object.evaluation = scene_evaluations[i % 3];
        scene.scene.viewer = viewer ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
        judge_some(1, &scene.scene, i % 5 ? 128 : 320, i % 5 ? 64 : 240, bench_definitions[which].name);
    }
}

/* Clipped, mirrored and stretched objects, up to eight lights, colours beyond 1. */
static void scenes(void) {
    for (unsigned i = 0; i < scene_count; i++) {
        test_scene scene;
        scene_build(&scene, &scene_definitions[i]);
        const int is_too_bright = scene.materials[0].diffuse.r > GLINT_ONE; /* for a contract in steps of 8 bits */
        for (unsigned kind = 0; kind < TEST_COUNT(formats); kind++)
            if (!is_too_bright || (kind != RGB888 && kind != RGB888 + 1))
                judge_in(kind, &scene.scene, 157, 93, scene_definitions[i].name);
    }
}

/* Coarse triangles whose highlights turn far, as the viewer's direction does too: in steps of 8 bits. */
static void highlights_in_8_bits(void) {
    static const int exponents[] = {2, 8, 32, 64, 256, 1024};
    static const unsigned coarse[] = {1, 3}; /* torus576 and sphere960 */
    for (unsigned i = 0; i < 480; i++) {
        bench_scene scene;
        const unsigned which = coarse[i / 240], small = i / 120 % 2, is_phong = i / 60 % 2;
        bench_build_scene(&scene, &bench_definitions[which], scene_bench_mesh((int)which), (int)(i % 10));
        scene.material.model = is_phong ? &glint_model_phong : &glint_model_blinn_phong;
        scene.material.shininess = exponents[i / 10 % 6] * GLINT_ONE;
        scene.scene.viewer = GLINT_VIEWER_LOCAL;
        judge_in(RGB888, &scene.scene, small ? 128 : 320, small ? 64 : 240, bench_definitions[which].name);
    }
}

/* Lights of all kinds, one to five of them. */
static void example_variants(void) {
    static example_stage stage;
    for (unsigned i = 0; i < EXAMPLE_SCENES; i++) {
        const example_scene *scene = example_scenes[i];
        for (uint32_t variant = 0; variant < scene->variant_count; variant++) {
            scene->build(&stage, variant, scene->frames / 2);
            judge_some(3, &stage.scene, scene->width, scene->height, scene->name);
        }
    }
}

/* The first of random_regions. Rooms and terrains are left out: many of their pixels are alike, and some are so far
 * away that their colours are not promised. */
#define USUAL_REGIONS 21

static void random_scenes(void) {
    static random_scene scene;
    for (uint64_t seed = 1; seed <= 2500 / sample_share(); seed++) {
        random_scene_make_in(&scene, (unsigned)(seed % USUAL_REGIONS), seed);
        if (random_regions[scene.region].in_contract)
            judge_some(1, &scene.scene, scene.width, scene.height, random_regions[scene.region].name);
    }
}

#define SLIVERS 4 /* of random_regions */

/* Facets whose longest edges are next to parallel, of 16 bits: what these lose turns the normal. */
static void facets_of_slivers(void) {
    static const uint64_t seeds[] = {319, 4918, 6745, 18694, 20920, 29656};
    static random_scene scene;
    for (unsigned i = 0; i < TEST_COUNT(seeds); i++) {
        contract_result found;
        random_scene_make_in(&scene, SLIVERS, seeds[i]);
        contract_judge(&scene.scene, scene.width, scene.height, scene.format, &found);
        CHECK_EQUAL(found.found.status, GLINT_OK);
        CHECK_EQUAL(found.found.over_one, 0);
    }
}

static void few_are_apart(void) {
    test_write("                              scenes    pixels  of the slack  not as rounded, %   > 1\n");
    for (unsigned kind = 0; kind < TEST_COUNT(formats); kind++) {
        const tally *t = &tallies[kind];
        const double apart = (double)t->found.apart / (double)t->found.judged;
        /* a sample has up to three standard deviations of a count more than all */
        const double of_sample = sample_share() > 1 ? 3 * sqrt(formats[kind].most_apart / (double)t->found.judged) : 0;
        char line[160];
        snprintf(line, sizeof line, "%-28s %7ld %9ld %13.3f %18.4f %5ld\n", formats[kind].name, t->scenes,
                 t->found.judged, t->worst_share, 100 * apart, t->found.over_one);
        test_write(line);
        CHECK(t->found.judged > 100000);
        CHECK(apart <= formats[kind].most_apart + of_sample);
    }
}

/* ---- Flat colours -------------------------------------------------------------------------------------------- */

/* Draws a screen of one colour: the background, or a square before it. */
static void draw_flat(picture *image, const double rgb[3], int as_object, const picture_options *options) {
    const glint_mesh square = scene_square_mesh(100 * GLINT_ONE, GLINT_ONE);
    const glint_colour colour = {bench_q16(rgb[0]), bench_q16(rgb[1]), bench_q16(rgb[2])};
    const glint_material paint = {.model = &glint_model_unlit, .diffuse = colour};
    const glint_object object = {.mesh = &square,
                                 .material = &paint,
                                 .evaluation = &glint_per_fragment,
                                 .pose = glint_pose_translate(0, 0, -2 * GLINT_ONE)};
    const glint_scene scene = {
        .camera = {.pose = glint_pose_identity(), .field_of_view = 60 * GLINT_ONE, .near_plane = GLINT_ONE},
        .background = as_object ? (glint_colour){0, 0, 0} : colour,
        .objects = &object,
        .object_count = (uint32_t)as_object};
    CHECK_EQUAL(picture_render(image, &scene, options, NULL), GLINT_OK);
}

static double level_of(const double rgb[3], const glint_format *format, int channel) {
    double value = picture_channels(format) == 1 ? 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2] : rgb[channel];
    return value * picture_level_max(format, channel);
}

/* Colours of all brightnesses, the three channels apart. */
static void take_colour(int index, int count, double rgb[3]) {
    rgb[0] = (double)index / count;
    rgb[1] = 1 - rgb[0];
    rgb[2] = fmod(0.618034 * index, 1);
}

/* Largest distance of a block's mean from the colour, in steps. */
static double worst_mean(const picture *image, const double rgb[3]) {
    double worst = 0;
    for (int block = 0; block < image->width / 8 * (image->height / 8); block++) {
        int left = block % (image->width / 8) * 8;
        int top = block / (image->width / 8) * 8;
        for (int channel = 0; channel < picture_channels(image->format); channel++) {
            int sum = 0;
            for (int i = 0; i < 64; i++)
                sum += picture_level(image, left + i % 8, top + i / 8, channel);
            worst = fmax(worst, fabs(sum / 64.0 - level_of(rgb, image->format, channel)));
        }
    }
    return worst;
}

/* The thresholds are 64 evenly spread ones: half of their distance, and what the colour itself is off by. */
static void blocks_mean_their_colour(void) {
    for (unsigned kind = 0; kind < FORMAT_COUNT / 2; kind++) {
        picture image = picture_open(40, 24, every_format[FORMAT_COUNT / 2 + kind]);
        int is_grey = picture_channels(every_format[FORMAT_COUNT / 2 + kind]) == 1;
        double rounding = picture_level_max(every_format[FORMAT_COUNT / 2 + kind], 0) * (is_grey ? 5e-5 : 1.0 / 65536);
        double worst = 0;
        for (int i = 0; i <= 400; i++) {
            double rgb[3];
            take_colour(i / 2, 200, rgb);
            draw_flat(&image, rgb, i % 2, NULL);
            worst = fmax(worst, worst_mean(&image, rgb));
        }
        char line[100];
        snprintf(line, sizeof line, "dithered format %u: means of blocks are off by at most %.5f steps\n", kind, worst);
        test_write(line);
        CHECK(worst <= 1.0 / 128 + rounding);
        picture_close(&image);
    }
}

/* ---- Output tables ------------------------------------------------------------------------------------------- */

typedef uint16_t gamma_tables[3][GLINT_GAMMA_ENTRIES];

static void fill_tables(gamma_tables tables, double red, double green, double blue) {
    const double exponents[3] = {red, green, blue};
    for (int channel = 0; channel < 3; channel++) {
        for (int i = 0; i < GLINT_GAMMA_ENTRIES; i++)
            tables[channel][i] = (uint16_t)floor(65535 * pow(i / 256.0, exponents[channel]) + 0.5);
    }
}

/* A table's value, linear between its entries. */
static double look_up(const uint16_t table[GLINT_GAMMA_ENTRIES], double value) {
    int entry = (int)(value * 256);
    double fraction = value * 256 - entry;
    return (table[entry] + (entry < 256 ? fraction * (table[entry + 1] - table[entry]) : 0)) / 65535;
}

/* Each channel by its own table, the background and what is drawn alike, never darker for a brighter colour. */
static void tables_apply_and_stay_monotone(void) {
    static gamma_tables tables;
    const picture_options options = {.gamma = (const uint16_t(*)[GLINT_GAMMA_ENTRIES])tables};
    picture image = picture_open(8, 8, &glint_format_rgb888);
    double worst = 0;
    fill_tables(tables, 1 / 2.2, 2.2, 1);
    for (int as_object = 0; as_object < 2; as_object++) {
        int before[3] = {0, 0, 0};
        for (int i = 0; i <= 1000; i++) {
            const double rgb[3] = {i / 1000.0, i / 1000.0, i / 1000.0};
            draw_flat(&image, rgb, as_object, &options);
            for (int channel = 0; channel < 3; channel++) {
                int level = picture_level(&image, 3, 5, channel);
                CHECK(level >= before[channel]);
                worst = fmax(worst, fabs(level - 255 * look_up(tables[channel], rgb[channel])));
                before[channel] = level;
            }
        }
        CHECK_EQUAL(before[0], 255);
        CHECK_EQUAL(before[1], 255);
    }
    char line[100];
    snprintf(line, sizeof line, "output tables: off by at most %.4f 8-bit steps, 0.5 of it rounding\n", worst);
    test_write(line);
    CHECK(worst <= 0.52);
    picture_close(&image);
}

/* However a scene is lit, all that is drawn goes through the tables: where these are 0, it is black. */
static void tables_apply_to_every_evaluation(void) {
    static const gamma_tables tables;
    const picture_options options = {.gamma = tables};
    picture image = picture_open(160, 120, &glint_format_rgb888);
    for (unsigned i = 0; i < 3 * scene_count; i++) {
        test_scene scene;
        int lit = 0;
        scene_build(&scene, &scene_definitions[i / 3]);
        scene_evaluate(&scene, scene_evaluations[i % 3]);
        CHECK_EQUAL(picture_render(&image, &scene.scene, &options, NULL), GLINT_OK);
        for (size_t k = 0; k < image.size; k++)
            lit += image.bytes[k] != 0;
        CHECK_EQUAL(lit, 0);
    }
    picture_close(&image);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(bench_scenes),
        TEST_CASE(example_variants),
        TEST_CASE(random_scenes),
        TEST_CASE(facets_of_slivers),
        TEST_CASE(few_are_apart),
        TEST_CASE(scenes),
        TEST_CASE(highlights_in_8_bits),
        TEST_CASE(blocks_mean_their_colour),
        TEST_CASE(tables_apply_and_stay_monotone),
        TEST_CASE(tables_apply_to_every_evaluation),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
