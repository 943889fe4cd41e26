/* SPDX-License-Identifier: MIT */
/*
 * Suite: 2 x 2 samples a pixel. A picture is, bit for bit, the means of a picture of twice the size, in every format,
 * and within a level more of the reference's means than without; the same for any tiles, arena and region, by either
 * way to draw a frame. Painters, picking and points of the screen count pixels. A user would see jagged or shifted
 * edges, seams between tiles, or would pick beside what shows.
 */
#include "every_format.h"
#include "glint_extras.h"
#include "harness.h"
#include "library_geometry.h"
#include "picture.h"
#include "random.h"
#include "reference.h"
#include "sample.h"
#include "scenes.h"
#include "stability/weights.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH 150
#define HEIGHT 101

static const picture_options sampled = {.samples = &glint_samples_2x2};

/* ---- A picture of twice the size ----------------------------------------------------------------------------- */

/*
 * What is added to the mean of four stored levels before it is cut off: half a level, or a quarter of 0 to 3. This is
 * the number of the pixel's highest and lowest two bits of the 64 thresholds, bit by bit where one of them is set.
 */
static double added(const glint_format *format, int x, int y) {
    if (picture_undithered(format) == format)
        return 0.5;
    const int number = (int)(picture_threshold(format, x, y) * 64);
    return ((number / 16) ^ (number % 4)) / 4.0;
}

/* The level that four samples make. */
static int mean_level(const picture *large, const glint_format *format, int x, int y, int channel) {
    int sum = 0;
    for (int i = 0; i < 4; i++)
        sum += picture_level(large, 2 * x + i % 2, 2 * y + i / 2, channel);
    return (int)floor(sum / 4.0 + added(format, x, y));
}

static long count_unlike(const picture *image, const picture *large, int most) {
    long unlike = 0;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            for (int channel = 0; channel < picture_channels(image->format); channel++)
                unlike +=
                    abs(picture_level(image, x, y, channel) - mean_level(large, image->format, x, y, channel)) > most;
    return unlike;
}

/* Formats of up to 6 bits without output tables are lit per fragment by other arithmetic: within a level, nearly
 * everywhere. */
static int may_differ(const glint_scene *scene, const glint_format *format, const void *gamma) {
    int is_per_fragment = 0;
    for (uint32_t i = 0; i < scene->object_count; i++)
        is_per_fragment |= !scene->objects[i].evaluation || scene->objects[i].evaluation == &glint_per_fragment;
    return is_per_fragment && !gamma && picture_level_max(format, picture_channels(format) / 2) < 255;
}

/* Draws a scene with samples, and holds it against one of twice the size. */
static void check_means(const glint_scene *scene, int width, int height, const glint_format *format,
                        const uint16_t (*gamma)[GLINT_GAMMA_ENTRIES]) {
    picture image = picture_open(width, height, format), large = picture_open(2 * width, 2 * height, format);
    picture_options with = sampled, without = {0};
    with.gamma = without.gamma = gamma;
    CHECK_EQUAL(picture_render(&image, scene, &with, NULL), GLINT_OK);
    CHECK(picture_is_complete(&image));
    CHECK_EQUAL(picture_render(&large, scene, &without, NULL), GLINT_OK);
    if (may_differ(scene, format, gamma)) {
        CHECK_AT_MOST(count_unlike(&image, &large, 0), width * height / 8);
        CHECK_AT_MOST(count_unlike(&image, &large, 1), width * height / 1000);
    } else {
        CHECK_EQUAL(count_unlike(&image, &large, 0), 0);
    }
    picture_close(&image);
    picture_close(&large);
}

static void every_format_has_means(void) {
    for (unsigned i = 0; i < FORMAT_COUNT; i++)
        for (uint32_t seed = 1; seed <= 6; seed++) {
            test_scene scene;
            scene_build_random(&scene, seed + 10 * i);
            if (seed % 3 == 0)
                scene_make_parallel(&scene.scene);
            scene_evaluate(&scene, scene_evaluations[(seed + i) % 3]);
            check_means(&scene.scene, WIDTH, HEIGHT, every_format[i], seed % 2 ? NULL : glint_gamma_srgb);
        }
}

static void largest_and_smallest_screens(void) {
    test_scene scene;
    scene_build_random(&scene, 3);
    check_means(&scene.scene, 512, 512, &glint_format_rgb565, NULL);
    check_means(&scene.scene, 512, 1, &glint_format_grey4, NULL);
    check_means(&scene.scene, 1, 1, &glint_format_mono, NULL);
}

/* Four samples of a dithered format have 64 thresholds over 8 x 8 pixels, as one has. */
static void blocks_mean_their_colour(void) {
    test_scene none = {0};
    none.scene.camera = glint_camera_default();
    for (unsigned i = 0; i < FORMAT_COUNT; i++) {
        const glint_format *const format = every_format[i];
        if (picture_undithered(format) == format)
            continue;
        picture image = picture_open(32, 16, format);
        const int most = picture_level_max(format, 0);
        double worst = 0;
        for (int step = 0; step <= 256; step++) {
            const glint_q16 grey = GLINT_ONE / 256 * step;
            double sum = 0;
            none.scene.background = (glint_colour){grey, grey, grey};
            CHECK_EQUAL(picture_render(&image, &none.scene, &sampled, NULL), GLINT_OK);
            for (int at = 0; at < 64; at++)
                sum += picture_level(&image, 8 + at % 8, 8 + at / 8, 0) / 64.0;
            worst = fmax(worst, fabs(sum - most * step / 256.0));
        }
        CHECK(worst <= 1.0 / 64);
        picture_close(&image);
    }
}

/* ---- The reference's means ----------------------------------------------------------------------------------- */

typedef struct means {
    reference_image reference; /* of twice the size */
    uint8_t *is_left_out;      /* its pixels */
    library_geometry geometry;
} means;

static void open_means(means *m, const glint_scene *scene, const picture *large) {
    picture unused = *large;
    const glint_config config = picture_config(&unused, NULL);
    const size_t pixels = (size_t)large->width * (size_t)large->height;
    m->reference = (reference_image){large->width, large->height, malloc(pixels * sizeof(reference_pixel))};
    m->is_left_out = calloc(pixels, 1);
    if (!m->reference.pixels || !m->is_left_out)
        exit(1);
    CHECK_EQUAL(library_geometry_open(&m->geometry, &config, scene), GLINT_OK);
    reference_render(&m->reference, scene, (const reference_position *const *)m->geometry.positions);
    for (size_t i = 0; i < pixels; i++) {
        const reference_pixel *const p = &m->reference.pixels[i];
        m->is_left_out[i] = p->uncertain || p->unsettled || (p->covered && p->grazing < 4.6 / 32768) ||
                            (p->second > 0 && (p->nearest - p->second) * m->geometry.depth_scale < 2);
    }
}

static void close_means(means *m) {
    library_geometry_close(&m->geometry);
    free(m->reference.pixels);
    free(m->is_left_out);
}

/* The unrounded mean of four samples, in levels. @return 0 where a last bit decides one of them */
static int find_mean(const means *m, const glint_format *format, int x, int y, int channel, double *mean) {
    *mean = 0;
    for (int i = 0; i < 4; i++) {
        const size_t at = (size_t)(2 * y + i / 2) * (size_t)m->reference.width + (size_t)(2 * x + i % 2);
        const double *const colour = m->reference.pixels[at].colour;
        const double value =
            picture_channels(format) == 1 ? 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2] : colour[channel];
        if (m->is_left_out[at])
            return 0;
        *mean += value * picture_level_max(format, channel) / 4;
    }
    return 1;
}

/* Counts pixels, and those that are more than so many levels from the mean. */
static void judge_means(const glint_scene *scene, const glint_format *format, double most, long *judged, long *over) {
    picture image = picture_open(WIDTH, HEIGHT, format), large = picture_open(2 * WIDTH, 2 * HEIGHT, format);
    means m;
    open_means(&m, scene, &large);
    CHECK_EQUAL(picture_render(&image, scene, &sampled, NULL), GLINT_OK);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        for (int channel = 0; channel < picture_channels(format); channel++) {
            const int x = i % WIDTH, y = i / WIDTH;
            double mean;
            if (!find_mean(&m, format, x, y, channel, &mean))
                continue;
            ++*judged;
            *over += fabs(picture_level(&image, x, y, channel) - mean) > most;
        }
    close_means(&m);
    picture_close(&image);
    picture_close(&large);
}

/* A stored level is within half a level of what is rounded, dithered within one; and each sample likewise. */
static void pixels_are_means_of_the_reference(void) {
    for (unsigned i = 0; i < FORMAT_COUNT; i++) {
        const glint_format *const format = every_format[i];
        const double one = picture_undithered(format) == format ? 0.5 : 1;
        long judged = 0, over = 0;
        for (uint32_t seed = 1; seed <= 12; seed++) {
            test_scene scene;
            double sum = 0;
            scene_build_random(&scene, seed + 100 * i);
            for (uint32_t object = 0; object < scene.scene.object_count; object++)
                sum = fmax(sum, weights_sum(&scene.scene, scene.objects[object].material));
            judge_means(&scene.scene, format, 2 * one + weights_slack(sum, format), &judged, &over);
        }
        if (!CHECK(over * 1000 <= judged) || !CHECK(judged > 12 * WIDTH * HEIGHT * 3 / 4)) {
            char line[80];
            snprintf(line, sizeof line, "  format %u: %ld of %ld are over\n", i, over, judged);
            test_write(line);
        }
    }
}

/* ---- Ways to draw -------------------------------------------------------------------------------------------- */

static void tiles_arenas_and_regions_agree(void) {
    static const uint16_t sizes[] = {8, 16, 32};
    for (unsigned i = 0; i < FORMAT_COUNT; i++) {
        test_scene scene;
        picture whole = picture_open(WIDTH, HEIGHT, every_format[i]);
        scene_build_random(&scene, 50 + i);
        CHECK_EQUAL(picture_render(&whole, &scene.scene, &sampled, NULL), GLINT_OK);
        for (unsigned way = 0; way < 18; way++) {
            picture_options options = sampled;
            options.tile_width = sizes[way % 3];
            options.tile_height = sizes[way / 3 % 3];
            options.waits = way % 2;
            options.skew = way % 4;
            if (way % 5 == 1)
                options.region = (glint_rectangle){(int16_t)(8 * (way % 7)), (int16_t)(8 * (way % 3)), 48, 40};
            const glint_need need = picture_need(&whole, &scene.scene, &options);
            options.arena_size = picture_arena(&need, way / 9 ? 0 : 16 * way);
            CHECK(picture_draws_same(&whole, &scene.scene, &options, NULL));
        }
        picture_close(&whole);
    }
}

/* Tile by tile in workspaces of the caller's own, from the last to the first; pixels apart from the arena. */
static void frames_by_tile_agree(void) {
    for (unsigned i = 0; i < FORMAT_COUNT; i++) {
        test_scene scene;
        picture whole = picture_open(WIDTH, HEIGHT, every_format[i]), image = picture_open(WIDTH, HEIGHT, whole.format);
        picture_options options = sampled;
        scene_build_random(&scene, 80 + i);
        options.waits = i % 2;
        CHECK_EQUAL(picture_render(&whole, &scene.scene, &options, NULL), GLINT_OK);
        glint_config config = picture_config(&image, &options);
        const glint_need need = picture_need(&image, &scene.scene, &options);
        const size_t size = glint_workspace_size(&config), pixels_size = glint_pixels_need(&config);
        void *const arena = malloc(need.one_pass), *const memory = malloc(size), *const pixels = malloc(pixels_size);
        glint_frame frame;
        glint_workspace workspace;
        glint_tile tile;
        config.arena = arena;
        config.arena_size = need.one_pass;
        CHECK_EQUAL(glint_frame_begin(&frame, &config, &scene.scene), GLINT_OK);
        glint_workspace_init(&workspace, &config, memory);
        CHECK_EQUAL(glint_frame_next_pass(&frame), 1);
        for (uint32_t number = frame.tile_end; number-- > frame.tile_first;) {
            CHECK_EQUAL(glint_render_tile(&frame, &workspace, number), 1);
            glint_tile_find(&frame, &workspace, number, &tile);
            int to[4];
            glint_tile_rectangle(&frame, number, &to[0], &to[1], &to[2], &to[3]);
            CHECK(to[0] == tile.x && to[1] == tile.y && to[2] == tile.width && to[3] == tile.height);
            CHECK_EQUAL(picture_put(&image, to, tile.pixels, tile.stride), 0);
        }
        CHECK(picture_is_complete(&image));
        CHECK(picture_equal(&image, &whole));
        glint_renderer renderer;
        memset(image.bytes, 0, image.size);
        config.pixels = pixels;
        config.pixels_size = pixels_size;
        CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
        CHECK_EQUAL(glint_render(&renderer, &scene.scene), GLINT_OK);
        CHECK(picture_equal(&image, &whole));
        config.pixels_size--;
        CHECK_EQUAL(glint_init(&renderer, &config), GLINT_ERROR_PIXELS);
        free(arena);
        free(memory);
        free(pixels);
        picture_close(&whole);
        picture_close(&image);
    }
}

static void filters_know_what_changed(void) {
    static glint_tile_signature signatures[64];
    test_scene scene;
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565_dithered);
    glint_config config = picture_config(&image, &sampled);
    glint_change_filter filter;
    glint_renderer renderer;
    scene_build_random(&scene, 5);
    const glint_need need = picture_need(&image, &scene.scene, &sampled);
    const uint32_t count = glint_tile_signature_count(&config);
    CHECK_EQUAL(count, 5 * 4);
    CHECK_EQUAL(glint_change_filter_init(&filter, signatures, &config), GLINT_OK);
    config.flush = glint_change_filter_flush(&filter);
    config.arena = malloc(need.one_pass);
    config.arena_size = need.one_pass;
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    CHECK_EQUAL(glint_render(&renderer, &scene.scene), GLINT_OK);
    CHECK_EQUAL(glint_render(&renderer, &scene.scene), GLINT_OK);
    CHECK_EQUAL(filter.sent, count);
    CHECK_EQUAL(filter.unchanged, count);
    free(config.arena);
    picture_close(&image);
}

/* ---- Painters, picking, points ------------------------------------------------------------------------------- */

static uint16_t depth[HEIGHT][WIDTH], line_depth[HEIGHT][WIDTH], large_depth[2 * HEIGHT][2 * WIDTH];

static void depth_is_that_of_the_nearest_sample(void) {
    for (uint32_t seed = 1; seed <= 12; seed++) {
        test_scene scene;
        picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565),
                large = picture_open(2 * WIDTH, 2 * HEIGHT, image.format);
        picture_options with = sampled;
        long unlike = 0;
        scene_build_random(&scene, seed);
        scene_evaluate(&scene, scene_evaluations[seed % 3]);
        with.depth = depth[0];
        CHECK_EQUAL(picture_render(&image, &scene.scene, &with, NULL), GLINT_OK);
        CHECK_EQUAL(picture_render(&large, &scene.scene, &(picture_options){.depth = large_depth[0]}, NULL), GLINT_OK);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            const int x = i % WIDTH, y = i / WIDTH;
            int nearest = 0;
            for (int j = 0; j < 4; j++)
                nearest = large_depth[2 * y + j / 2][2 * x + j % 2] > nearest
                              ? large_depth[2 * y + j / 2][2 * x + j % 2]
                              : nearest;
            unlike += abs(depth[y][x] - nearest) > (seed % 3 == 0); /* per fragment: a step */
        }
        CHECK_EQUAL(unlike, 0);
        picture_close(&image);
        picture_close(&large);
    }
}

/* Paints numbers that no drawing leaves by chance: each byte is told by its place on the screen. */
static int paint_bytes(void *context, const glint_tile *tile) {
    const picture *const image = context;
    const int paged = picture_undithered(image->format) == &glint_format_mono_pages, step = paged ? 8 : 1;
    const size_t left = paged ? (size_t)tile->x : glint_row_bytes(image->format, (uint32_t)tile->x),
                 count = paged ? (size_t)tile->width : glint_row_bytes(image->format, (uint32_t)tile->width);
    for (int y = 0; y < tile->height; y += step)
        for (size_t i = 0; i < count; i++)
            ((uint8_t *)tile->pixels)[(size_t)y * tile->stride + i] =
                (uint8_t)(((left + i) * 2654435761u ^ (uint32_t)(tile->y + y) * 40503u) >> 7);
    return 0;
}

/* Draws as a configuration says, in an arena of one pass. */
static void draw_as(const glint_scene *scene, glint_config config) {
    glint_renderer renderer;
    glint_need need;
    CHECK_EQUAL(glint_arena_need(&config, scene, &need), GLINT_OK);
    config.arena = malloc(need.one_pass);
    config.arena_size = need.one_pass;
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    CHECK_EQUAL(glint_render(&renderer, scene), GLINT_OK);
    free(config.arena);
}

/* Draws over a painted background. */
static void draw_painted(const glint_scene *scene, picture *image, const picture_options *options, uint16_t tile) {
    glint_config config = picture_config(image, options);
    config.background = (glint_painter){paint_bytes, image};
    config.tile_width = config.tile_height = tile;
    config.layers = &glint_layers;
    draw_as(scene, config);
}

/* A background's pixels stay where no sample shows an object. Elsewhere they are as mixed as edges are. */
static void painted_backgrounds_show(void) {
    long shown = 0;
    for (unsigned i = 0; i < FORMAT_COUNT; i++) {
        test_scene scene;
        picture image = picture_open(WIDTH, HEIGHT, every_format[i]), alone = picture_open(WIDTH, HEIGHT, image.format),
                again = picture_open(WIDTH, HEIGHT, image.format);
        picture_options with = sampled;
        long unlike = 0;
        scene_build_random(&scene, 30 + i);
        with.depth = depth[0];
        CHECK_EQUAL(picture_render(&image, &scene.scene, &with, NULL), GLINT_OK);
        draw_painted(&scene.scene, &image, &sampled, 32);
        draw_painted(&scene.scene, &again, &sampled, 8);
        CHECK(picture_equal(&image, &again));
        scene.scene.object_count = 0;
        draw_painted(&scene.scene, &alone, &(picture_options){0}, 32);
        for (int at = 0; at < WIDTH * HEIGHT; at++)
            for (int channel = 0; channel < picture_channels(image.format); channel++) {
                const int x = at % WIDTH, y = at / WIDTH;
                shown += depth[y][x] == 0;
                unlike +=
                    depth[y][x] == 0 && picture_level(&image, x, y, channel) != picture_level(&alone, x, y, channel);
            }
        CHECK_EQUAL(unlike, 0);
        picture_close(&image);
        picture_close(&alone);
        picture_close(&again);
    }
    CHECK(shown > FORMAT_COUNT * WIDTH * HEIGHT / 4);
}

/* Makes some objects of a scene blend, and adds fog. */
static void blend(test_scene *scene, uint32_t number, glint_fog *fog) {
    for (uint32_t i = 0; i < scene->scene.object_count; i++) {
        scene->materials[i] = *scene->objects[i].material;
        scene->materials[i].blend = (glint_blend)((number + i) % 4);
        scene->materials[i].opacity = GLINT_ONE / 5 * (int32_t)(1 + (number + i) % 5);
        scene->objects[i].material = &scene->materials[i];
    }
    *fog = (glint_fog){number % 2 ? &glint_fog_linear : &glint_fog_squared,
                       {GLINT_ONE / 3, GLINT_ONE / 2, GLINT_ONE},
                       0,
                       8 * GLINT_ONE,
                       0};
    scene->scene.fog = number % 3 ? fog : NULL;
}

/* Layers and fog see samples as pixels. Where fog fades to a painter's pixels, tiles still agree. */
static void what_blends_has_means(void) {
    for (uint32_t seed = 1; seed <= 24; seed++) {
        test_scene scene;
        glint_fog fog;
        picture image = picture_open(WIDTH, HEIGHT, every_format[seed % FORMAT_COUNT]),
                again = picture_open(WIDTH, HEIGHT, image.format),
                large = picture_open(2 * WIDTH, 2 * HEIGHT, image.format);
        scene_build_random(&scene, seed);
        scene_evaluate(&scene, scene_evaluations[1 + seed % 2]);
        blend(&scene, seed, &fog);
        glint_config config = picture_config(&image, &sampled), twice = picture_config(&large, NULL);
        config.layers = twice.layers = &glint_layers;
        draw_as(&scene.scene, config);
        draw_as(&scene.scene, twice);
        CHECK_EQUAL(count_unlike(&image, &large, 0), 0);
        fog.to_background = 1;
        draw_painted(&scene.scene, &image, &sampled, 32);
        draw_painted(&scene.scene, &again, &sampled, 16);
        CHECK(picture_equal(&image, &again));
        picture_close(&image);
        picture_close(&again);
        picture_close(&large);
    }
}

static int fail_to_paint(void *context, const glint_tile *tile) {
    (void)context;
    (void)tile;
    return 1;
}

static void failed_painters_end_frames(void) {
    static uint32_t arena[32768];
    test_scene scene;
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    scene_build_random(&scene, 9);
    for (int over = 0; over < 2; over++) {
        glint_config config = picture_config(&image, &sampled);
        glint_renderer renderer;
        *(over ? &config.overlay : &config.background) = (glint_painter){fail_to_paint, NULL};
        config.arena = arena;
        config.arena_size = sizeof arena;
        CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
        CHECK_EQUAL(glint_render(&renderer, &scene.scene), GLINT_ERROR_PAINT);
    }
    picture_close(&image);
}

/* What is picked is as near as what shows, and shows at one of the four samples. */
static void picks_are_at_pixels(void) {
    static uint32_t arena[65536];
    long found = 0;
    for (uint32_t seed = 1; seed <= 10; seed++) {
        test_scene scene;
        picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565),
                large = picture_open(2 * WIDTH, 2 * HEIGHT, image.format);
        picture_options with = sampled;
        glint_renderer renderer, beside;
        scene_build_random(&scene, seed);
        glint_config config = picture_config(&image, &sampled), twice = picture_config(&large, NULL);
        config.arena = twice.arena = arena;
        config.arena_size = twice.arena_size = sizeof arena;
        CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
        CHECK_EQUAL(glint_init(&beside, &twice), GLINT_OK);
        with.depth = depth[0];
        CHECK_EQUAL(picture_render(&image, &scene.scene, &with, NULL), GLINT_OK);
        random_state = seed;
        for (int i = 0; i < 60; i++) {
            const int x = any(0, WIDTH - 1), y = any(0, HEIGHT - 1);
            glint_hit hit = {7, 7, 7}, sample;
            const int is_found = glint_pick(&renderer, &scene.scene, x, y, &hit);
            int is_there = !is_found;
            CHECK_EQUAL(is_found, depth[y][x] != 0);
            CHECK_EQUAL(hit.depth, is_found ? depth[y][x] : 7);
            for (int j = 0; j < 4; j++)
                is_there |= glint_pick(&beside, &scene.scene, 2 * x + j % 2, 2 * y + j / 2, &sample) > 0 &&
                            sample.object == hit.object && sample.triangle == hit.triangle;
            CHECK(is_there);
            found += is_found;
        }
        glint_hit unused;
        CHECK_EQUAL(glint_pick(&renderer, &scene.scene, WIDTH, 0, &unused), GLINT_ERROR_REGION);
        picture_close(&image);
        picture_close(&large);
    }
    CHECK(found > 100);
}

/* A corner of a square is where glint_camera_project says, with samples and without. */
static void points_count_pixels(void) {
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    const glint_config with = picture_config(&image, &sampled), without = picture_config(&image, NULL);
    const glint_camera camera = glint_camera_default();
    glint_screen_point a, b;
    CHECK_EQUAL(glint_camera_project(&with, &camera, (glint_vector)GLINT_VECTOR(0.3, -0.2, 0.5), &a), 1);
    CHECK_EQUAL(glint_camera_project(&without, &camera, (glint_vector)GLINT_VECTOR(0.3, -0.2, 0.5), &b), 1);
    CHECK(a.x == b.x && a.y == b.y && a.distance == b.distance);
    picture_close(&image);
}

/* ---- Lines --------------------------------------------------------------------------------------------------- */

static glint_segment segments[12];

static int draw_lines(void *context, const glint_tile *tile) {
    (void)context;
    return glint_lines_draw(tile, segments, TEST_COUNT(segments));
}

/* Where no object is, lines have the pixels that they have without samples; and are hidden behind objects. */
static void lines_are_drawn_over_means(void) {
    long marked = 0;
    for (unsigned i = 0; i < FORMAT_COUNT; i++) {
        test_scene scene;
        picture with = picture_open(WIDTH, HEIGHT, every_format[i]), without = picture_open(WIDTH, HEIGHT, with.format),
                plain = picture_open(WIDTH, HEIGHT, with.format);
        glint_line lines[12];
        picture_options options = {.overlay = {draw_lines, NULL}};
        long unlike = 0;
        scene_build_random(&scene, 60 + i);
        const glint_vector extent = scene.objects[0].mesh->extent;
        const glint_config config = picture_config(&with, &sampled);
        glint_lines_box(lines, (glint_vector){-extent.x, -extent.y, -extent.z}, extent,
                        (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE});
        CHECK_EQUAL(glint_lines_project(segments, &config, &scene.scene.camera, &scene.objects[0].pose, lines, 12),
                    GLINT_OK);
        const picture_options covered = {.samples = &glint_samples_2x2, .depth = depth[0]};
        CHECK_EQUAL(picture_render(&plain, &scene.scene, &covered, NULL), GLINT_OK);
        CHECK_EQUAL(picture_render(&without, &scene.scene, &options, NULL), GLINT_OK);
        options.samples = &glint_samples_2x2;
        options.depth = line_depth[0];
        CHECK_EQUAL(picture_render(&with, &scene.scene, &options, NULL), GLINT_OK);
        for (int at = 0; at < WIDTH * HEIGHT; at++)
            for (int channel = 0; channel < picture_channels(with.format); channel++) {
                const int x = at % WIDTH, y = at / WIDTH, level = picture_level(&with, x, y, channel);
                const int is_line = line_depth[y][x] != depth[y][x];
                marked += is_line;
                unlike += depth[y][x] == 0 && is_line && level != picture_level(&without, x, y, channel);
                unlike += !is_line && level != picture_level(&plain, x, y, channel);
            }
        CHECK_EQUAL(unlike, 0);
        picture_close(&with);
        picture_close(&without);
        picture_close(&plain);
    }
    CHECK(marked > 1000);
}

/* ---- Errors -------------------------------------------------------------------------------------------------- */

static void check_refused(uint16_t width, uint16_t height, uint16_t tile_width, uint16_t tile_height,
                          glint_status expected) {
    static uint32_t arena[65536];
    test_scene scene;
    picture image = picture_open(8, 8, &glint_format_rgb565);
    glint_config config = picture_config(&image, &sampled);
    glint_renderer renderer;
    glint_need need;
    scene_build_random(&scene, 2);
    config.width = width;
    config.height = height;
    config.tile_width = tile_width;
    config.tile_height = tile_height;
    config.arena = arena;
    config.arena_size = sizeof arena;
    CHECK_EQUAL(glint_init(&renderer, &config), expected);
    CHECK_EQUAL(glint_arena_need(&config, &scene.scene, &need), expected);
    CHECK_EQUAL(glint_workspace_size(&config) == 0, expected != GLINT_OK);
    CHECK_EQUAL(glint_pixels_need(&config) == 0, expected != GLINT_OK);
    if (expected != GLINT_OK) {
        glint_report report;
        CHECK_EQUAL(glint_check(&config, &scene.scene, &report), expected);
        CHECK(strcmp(report.sentence, glint_strerror(expected)) == 0);
    }
    picture_close(&image);
}

static void what_is_too_large_is_refused(void) {
    check_refused(512, 512, 32, 32, GLINT_OK);
    check_refused(513, 512, 32, 32, GLINT_ERROR_SAMPLES);
    check_refused(512, 513, 0, 0, GLINT_ERROR_SAMPLES);
    check_refused(512, 512, 64, 32, GLINT_ERROR_SAMPLES);
    check_refused(512, 512, 32, 64, GLINT_ERROR_SAMPLES);
    check_refused(512, 512, 32, 65, GLINT_ERROR_TILE);
    check_refused(1025, 512, 32, 32, GLINT_ERROR_SIZE);
}

/* A scene draws in the least arena, and not in a byte less; check sees what shows. */
static void least_arenas_suffice(void) {
    for (uint32_t seed = 1; seed <= 8; seed++) {
        test_scene scene;
        picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
        picture_options options = sampled;
        scene_build_random(&scene, seed);
        options.waits = seed % 2;
        options.arena_size = picture_need(&image, &scene.scene, &options).least;
        CHECK_EQUAL(picture_render(&image, &scene.scene, &options, NULL), GLINT_OK);
        options.arena_size -= sizeof(void *);
        CHECK_EQUAL(picture_render(&image, &scene.scene, &options, NULL), GLINT_ERROR_ARENA);
        picture_close(&image);
    }
}

static void check_counts_pixels(void) {
    static uint32_t arena[65536];
    test_scene scene;
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    picture_options with = sampled;
    glint_config config = picture_config(&image, &sampled);
    glint_report report;
    uint32_t shown = 0;
    scene_build_random(&scene, 4);
    config.arena = arena;
    config.arena_size = sizeof arena;
    with.depth = depth[0];
    CHECK_EQUAL(picture_render(&image, &scene.scene, &with, NULL), GLINT_OK);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        shown += depth[i / WIDTH][i % WIDTH] != 0;
    CHECK_EQUAL(glint_check(&config, &scene.scene, &report), GLINT_OK);
    CHECK_EQUAL(report.shown, shown);
    picture_close(&image);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(every_format_has_means),
        TEST_CASE(largest_and_smallest_screens),
        TEST_CASE(blocks_mean_their_colour),
        TEST_CASE(pixels_are_means_of_the_reference),
        TEST_CASE(tiles_arenas_and_regions_agree),
        TEST_CASE(frames_by_tile_agree),
        TEST_CASE(filters_know_what_changed),
        TEST_CASE(depth_is_that_of_the_nearest_sample),
        TEST_CASE(painted_backgrounds_show),
        TEST_CASE(what_blends_has_means),
        TEST_CASE(failed_painters_end_frames),
        TEST_CASE(picks_are_at_pixels),
        TEST_CASE(points_count_pixels),
        TEST_CASE(lines_are_drawn_over_means),
        TEST_CASE(what_is_too_large_is_refused),
        TEST_CASE(least_arenas_suffice),
        TEST_CASE(check_counts_pixels),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
