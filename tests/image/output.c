/* SPDX-License-Identifier: MIT */
/* Suite: what happens to a colour once it is lit: ordered dithering and the output tables. */
#include "../stability/weights.h"
#include "bench.h"
#include "glint.h"
#include "harness.h"
#include "picture.h"
#include "scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const glint_format *const dithered[] = {&glint_format_rgb565_dithered, &glint_format_rgb565_be_dithered,
                                               &glint_format_rgb888_dithered, &glint_format_grey8_dithered,
                                               &glint_format_grey4_dithered,  &glint_format_rgb444_dithered,
                                               &glint_format_mono_dithered,   &glint_format_mono_pages_dithered};

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
static void pick(int index, int count, double rgb[3]) {
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
    for (unsigned kind = 0; kind < TEST_COUNT(dithered); kind++) {
        picture image = picture_open(40, 24, dithered[kind]);
        int is_grey = picture_channels(dithered[kind]) == 1;
        double rounding = picture_level_max(dithered[kind], 0) * (is_grey ? 5e-5 : 1.0 / 65536);
        double worst = 0;
        for (int i = 0; i <= 400; i++) {
            double rgb[3];
            pick(i / 2, 200, rgb);
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

/* ---- Dithered images ----------------------------------------------------------------------------------------- */

/*
 * A stored level is the value plus the pixel's threshold, cut off; rounding replaces it by 1/2. From the image in finer
 * steps the value is known to half such a step, so that the level is one of two at most. Where light is found in
 * another way in either, values may be as far apart as the contract of RGB565 lets them.
 */
static int count_misplaced(const picture *coarse, const picture *fine, double apart) {
    int misplaced = 0;
    for (int i = 0; i < coarse->width * coarse->height; i++) {
        int x = i % coarse->width;
        int y = i / coarse->width;
        for (int channel = 0; channel < 3; channel++) {
            double value = picture_level(fine, x, y, channel) / 255.0 * picture_level_max(coarse->format, channel);
            double slack = 0.6 / 255 * picture_level_max(coarse->format, channel) + apart;
            double threshold = picture_threshold(&glint_format_rgb565_dithered, x, y);
            int level = picture_level(coarse, x, y, channel);
            misplaced += level < (int)floor(value + threshold - slack) || level > (int)floor(value + threshold + slack);
        }
    }
    return misplaced;
}

/* One light has loops of its own in some formats. */
static void add_light(test_scene *scene) {
    if (scene->scene.light_count > 1)
        return;
    const glint_colour weak = {GLINT_ONE / 16, GLINT_ONE / 16, GLINT_ONE / 16};
    scene->lights[scene->scene.light_count] =
        (glint_light){.type = &glint_light_directional, .vector = {GLINT_ONE, 0, 0}, .diffuse = weak, .specular = weak};
    scene->scene.light_count++;
}

/* How far the contract of RGB565 lets values be off: the more, the more weights add up to. */
static double slack_of(const glint_scene *scene) {
    double most = 0;
    for (uint32_t i = 0; i < scene->object_count; i++)
        most = fmax(most, weights_slack(weights_sum(scene, scene->objects[i].material), &glint_format_rgb565));
    return most;
}

static void thresholds_are_bayers(void) {
    picture fine = picture_open(160, 120, &glint_format_rgb888);
    picture plain = picture_open(160, 120, &glint_format_rgb565);
    picture coarse = picture_open(160, 120, &glint_format_rgb565_dithered);
    for (unsigned i = 0; i < 2 * scene_count; i++) {
        test_scene scene;
        scene_build(&scene, &scene_definitions[i / 2]);
        if (i % 2)
            add_light(&scene);
        scene.scene.background = (glint_colour){GLINT_ONE / 7, GLINT_ONE / 3, GLINT_Q16(0.9)};
        CHECK_EQUAL(picture_render(&fine, &scene.scene, NULL, NULL), GLINT_OK);
        CHECK_EQUAL(picture_render(&plain, &scene.scene, NULL, NULL), GLINT_OK);
        CHECK_EQUAL(picture_render(&coarse, &scene.scene, NULL, NULL), GLINT_OK);
        const double apart = slack_of(&scene.scene);
        CHECK_EQUAL(count_misplaced(&coarse, &fine, apart), 0);
        CHECK(apart > 0.25 || count_misplaced(&plain, &fine, apart) > 0);
    }
    picture_close(&fine);
    picture_close(&plain);
    picture_close(&coarse);
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

static int largest_difference(const picture *a, const picture *b) {
    int largest = 0;
    for (size_t i = 0; i < a->size; i++) {
        int difference = abs(a->bytes[i] - b->bytes[i]);
        largest = difference > largest ? difference : largest;
    }
    return largest;
}

static void identity_table_changes_nothing(void) {
    static gamma_tables tables;
    picture plain = picture_open(160, 120, &glint_format_rgb888);
    picture tabled = picture_open(160, 120, &glint_format_rgb888);
    const picture_options options = {.gamma = (const uint16_t(*)[GLINT_GAMMA_ENTRIES])tables};
    fill_tables(tables, 1, 1, 1);
    for (unsigned i = 0; i < scene_count; i++) {
        test_scene scene;
        scene_build(&scene, &scene_definitions[i]);
        CHECK_EQUAL(picture_render(&plain, &scene.scene, NULL, NULL), GLINT_OK);
        CHECK_EQUAL(picture_render(&tabled, &scene.scene, &options, NULL), GLINT_OK);
        CHECK_AT_MOST(largest_difference(&plain, &tabled), 2); /* either may be a step off */
    }
    picture_close(&plain);
    picture_close(&tabled);
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
    static const glint_evaluation *const evaluations[] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    static const gamma_tables tables;
    const picture_options options = {.gamma = tables};
    picture image = picture_open(160, 120, &glint_format_rgb888);
    for (unsigned i = 0; i < 3 * scene_count; i++) {
        test_scene scene;
        int lit = 0;
        scene_build(&scene, &scene_definitions[i / 3]);
        for (uint32_t k = 0; k < scene.scene.object_count; k++)
            scene.objects[k].evaluation = evaluations[i % 3];
        CHECK_EQUAL(picture_render(&image, &scene.scene, &options, NULL), GLINT_OK);
        for (size_t k = 0; k < image.size; k++)
            lit += image.bytes[k] != 0;
        CHECK_EQUAL(lit, 0);
    }
    picture_close(&image);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(blocks_mean_their_colour),         TEST_CASE(thresholds_are_bayers),
        TEST_CASE(identity_table_changes_nothing),   TEST_CASE(tables_apply_and_stay_monotone),
        TEST_CASE(tables_apply_to_every_evaluation),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
