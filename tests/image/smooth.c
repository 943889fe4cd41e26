/* SPDX-License-Identifier: MIT */
/*
 * Suite: smooth lines. Each pixel is covered as double precision says, and nearly as the exact area of the line's
 * rectangle does; the same from both ends, in any tiles, arena and region; objects hide lines, which leave depth as it
 * was. A user would see lines that are too thin or too thick, seams, or ends that are off.
 */
#include "every_format.h"
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "random.h"
#include "scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH 150
#define HEIGHT 101
#define LINES 24

static glint_segment segments[LINES];
static uint32_t segment_count;
static uint16_t depth[HEIGHT][WIDTH], depth_before[HEIGHT][WIDTH];

static int draw_lines(void *context, const glint_tile *tile) {
    (void)context;
    for (int y = 0; y < tile->height; y++)
        memcpy(&depth_before[tile->y + y][tile->x], tile->depth + (size_t)y * tile->depth_stride,
               (size_t)tile->width * sizeof(uint16_t));
    return glint_lines_draw_smooth(tile, segments, segment_count);
}

static const picture_options with_lines = {.overlay = {draw_lines, NULL}};

static void project(const glint_scene *scene, const glint_line *lines, uint32_t count) {
    const glint_config config = {.width = WIDTH, .height = HEIGHT};
    const glint_pose none = glint_pose_identity();
    segment_count = count;
    CHECK_EQUAL(glint_lines_project(segments, &config, &scene->camera, &none, lines, count), GLINT_OK);
}

/* ---- Coverage ------------------------------------------------------------------------------------------------ */

/* How much of a square of one pixel, so far from the middle, lies in a range of so many pixels around it. */
static double part_of(double size, double distance) {
    return fmax(0, fmin(fmin(1, size), size / 2 + 0.5 - fabs(distance)));
}

/* The place of a pixel's point along and across a segment, from its middle, and the segment's length. */
static double place(const glint_segment *of, double x, double y, double *along, double *across) {
    const double dx = (of->x[1] - of->x[0]) / 16.0, dy = (of->y[1] - of->y[0]) / 16.0, length = sqrt(dx * dx + dy * dy);
    const double to_x = x - (of->x[0] + of->x[1]) / 32.0, to_y = y - (of->y[0] + of->y[1]) / 32.0;
    *along = length > 0 ? (to_x * dx + to_y * dy) / length : 0;
    *across = length > 0 ? (to_x * dy - to_y * dx) / length : 0;
    return length;
}

static double coverage(const glint_segment *of, double width, int x, int y) {
    double along, across;
    const double length = place(of, x + 0.5, y + 0.5, &along, &across);
    return part_of(length, along) * part_of(width, across);
}

/* The area of a pixel that the line's rectangle covers, by 16 x 16 points. */
static double exact_area(const glint_segment *of, double width, int x, int y) {
    int inside = 0;
    for (int i = 0; i < 256; i++) {
        const int column = i % 16, row = i / 16;
        double along, across;
        const double length = place(of, x + (column + 0.5) / 16, y + (row + 0.5) / 16, &along, &across);
        inside += fabs(along) < length / 2 && fabs(across) < width / 2;
    }
    return inside / 256.0;
}

static glint_line any_line(int32_t reach, uint32_t number) {
    static const double widths[] = {0, 0.25, 0.5, 1, 1.5, 2, 3.3, 8, 20, 64};
    return (glint_line){{any(-reach, reach), any(-reach, reach), any(-reach, reach)},
                        {any(-reach, reach), any(-reach, reach), any(-reach, reach)},
                        {GLINT_ONE, GLINT_ONE, GLINT_ONE},
                        (glint_q16)(65536 * widths[number % TEST_COUNT(widths)])};
}

static void pixels_are_covered_as_double_precision_says(void) {
    test_scene scene = {0};
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_grey8);
    double worst = 0, worst_area = 0;
    long covered = 0;
    scene.scene.camera = glint_camera_default();
    random_state = 1;
    for (uint32_t i = 0; i < 400; i++) {
        glint_line line = any_line(i % 4 ? 2 * GLINT_ONE : GLINT_ONE / 8, i / 4);
        if (i % 16 == 3)
            line.to.y = line.from.y, line.to.z = line.from.z; /* along a row */
        project(&scene.scene, &line, 1);
        CHECK_EQUAL(picture_render(&image, &scene.scene, &with_lines, NULL), GLINT_OK);
        const double width = line.width ? line.width / 65536.0 : 1;
        for (int at = 0; at < WIDTH * HEIGHT && segments[0].colour; at++) {
            const int x = at % WIDTH, y = at / WIDTH;
            const double shown = picture_level(&image, x, y, 0) / 255.0, wanted = coverage(segments, width, x, y);
            worst = fmax(worst, fabs(shown - wanted));
            covered += wanted > 0;
            if (i % 8 == 0 && (wanted > 0 || shown > 0))
                worst_area = fmax(worst_area, fabs(shown - exact_area(segments, width, x, y)));
        }
    }
    char text[120];
    snprintf(text, sizeof text, "  coverage is off by at most %.4f, from the exact area %.3f\n", worst, worst_area);
    test_write(text);
    CHECK(worst <= 1.0 / 64);
    CHECK(worst_area <= 0.08);
    CHECK(covered > 100000);
    picture_close(&image);
}

/* ---- Ways to draw -------------------------------------------------------------------------------------------- */

/* Lines about the objects of a random scene, whose colours the lines keep. */
static void build(test_scene *scene, glint_line lines[LINES], uint32_t number) {
    scene_build_random(scene, number);
    const glint_pose *const at = &scene->objects[0].pose;
    random_state = number;
    for (uint32_t i = 0; i < LINES; i++) {
        lines[i] = any_line(GLINT_ONE, i + number);
        lines[i].colour = (glint_colour){any(0, GLINT_ONE), any(0, GLINT_ONE), any(0, GLINT_ONE)};
        lines[i].from = glint_pose_apply(at, lines[i].from);
        lines[i].to = glint_pose_apply(at, lines[i].to);
    }
    if (number % 3 == 0)
        scene_make_parallel(&scene->scene);
    project(&scene->scene, lines, LINES);
}

static void all_ways_agree(void) {
    static const uint16_t sizes[] = {8, 16, 32};
    for (uint32_t i = 0; i < 3 * FORMAT_COUNT; i++) {
        test_scene scene;
        glint_line lines[LINES];
        picture whole = picture_open(WIDTH, HEIGHT, every_format[i % FORMAT_COUNT]);
        picture_options options = with_lines;
        options.samples = i % 2 ? &glint_samples_2x2 : NULL;
        build(&scene, lines, i + 1);
        CHECK_EQUAL(picture_render(&whole, &scene.scene, &options, NULL), GLINT_OK);
        for (uint32_t way = 0; way < 6; way++) {
            options.tile_width = sizes[way % 3];
            options.tile_height = sizes[(way + i) % 3];
            options.arena_size = 0;
            if (way > 3)
                options.region = (glint_rectangle){40, 16, 56, 48};
            const glint_need need = picture_need(&whole, &scene.scene, &options);
            options.arena_size = picture_arena(&need, 64 * (way % 3));
            for (uint32_t line = 0; line < LINES; line++) {
                const glint_vector from = lines[line].from;
                lines[line].from = lines[line].to;
                lines[line].to = from;
            }
            project(&scene.scene, lines, LINES);
            CHECK(picture_draws_same(&whole, &scene.scene, &options, NULL));
        }
        picture_close(&whole);
    }
}

/* Depth stays; a pixel changes only where a line covers it and is nearer than the object there. */
static void objects_hide_lines(void) {
    long hidden = 0, shown = 0;
    for (uint32_t seed = 1; seed <= 12; seed++) {
        test_scene scene;
        picture plain = picture_open(WIDTH, HEIGHT, &glint_format_rgb888),
                image = picture_open(WIDTH, HEIGHT, plain.format);
        picture_options options = with_lines;
        options.samples = seed % 2 ? &glint_samples_2x2 : NULL;
        scene_build_random(&scene, seed);
        scene.scene.background = (glint_colour){0, 0, 0};
        const glint_vector middle = {scene.objects[0].pose.m[0][3], scene.objects[0].pose.m[1][3],
                                     scene.objects[0].pose.m[2][3]};
        const glint_vector extent = scene.objects[0].mesh->extent;
        const glint_pose *const camera = &scene.scene.camera.pose;
        for (int behind = 0; behind < 2; behind++) {
            /* A bar right across what is seen of the first object: at 1/8 or 8 times its distance from the eye. */
            glint_line bar = {middle, middle, {GLINT_ONE, GLINT_ONE, GLINT_ONE}, 9 * GLINT_ONE};
            const int64_t part = behind ? 8 * GLINT_ONE : GLINT_ONE / 8;
            glint_q16 *const to[2][3] = {{&bar.from.x, &bar.from.y, &bar.from.z}, {&bar.to.x, &bar.to.y, &bar.to.z}};
            for (int end = 0; end < 2; end++)
                for (int axis = 0; axis < 3; axis++) {
                    const int64_t side = (int64_t)camera->m[axis][0] * extent.x >> 16;
                    const int64_t away = *to[end][axis] + (end ? side : -side) - camera->m[axis][3];
                    *to[end][axis] = (glint_q16)(camera->m[axis][3] + away * part / GLINT_ONE);
                }
            project(&scene.scene, &bar, 1);
            options.depth = depth[0];
            CHECK_EQUAL(picture_render(&image, &scene.scene, &options, NULL), GLINT_OK);
            CHECK(memcmp(depth, depth_before, sizeof depth) == 0);
            options.overlay.paint = NULL;
            CHECK_EQUAL(picture_render(&plain, &scene.scene, &options, NULL), GLINT_OK);
            options.overlay = with_lines.overlay;
            for (int at = 0; at < WIDTH * HEIGHT && segments[0].colour; at++) {
                const int x = at % WIDTH, y = at / WIDTH, is_covered = coverage(segments, 9, x, y) > 0.99;
                const int is_white = picture_level(&image, x, y, 1) == 255,
                          is_same = picture_level(&image, x, y, 1) == picture_level(&plain, x, y, 1);
                if (!is_covered || !depth[y][x])
                    continue;
                CHECK(behind ? is_same : is_white);
                hidden += behind;
                shown += !behind;
            }
        }
        picture_close(&plain);
        picture_close(&image);
    }
    CHECK(hidden > 500);
    CHECK(shown > 500);
}

/* ---- Errors -------------------------------------------------------------------------------------------------- */

static void widths_are_checked(void) {
    const glint_config config = {.width = WIDTH, .height = HEIGHT};
    const glint_camera camera = glint_camera_default();
    const glint_pose none = glint_pose_identity();
    glint_line line = {{0, 0, 0}, {GLINT_ONE, 0, 0}, {0, 0, 0}, 0};
    for (int i = 0; i < 4; i++) {
        static const glint_q16 widths[] = {0, 64 * GLINT_ONE, 64 * GLINT_ONE + 1, -1};
        line.width = widths[i];
        CHECK_EQUAL(glint_lines_project(segments, &config, &camera, &none, &line, 1),
                    i < 2 ? GLINT_OK : GLINT_ERROR_WIDTH);
    }
    glint_tile tile = {0};
    CHECK_EQUAL(glint_lines_draw_smooth(NULL, segments, 1), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_lines_draw_smooth(&tile, segments, 1), GLINT_ERROR_NULL);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(pixels_are_covered_as_double_precision_says),
        TEST_CASE(all_ways_agree),
        TEST_CASE(objects_hide_lines),
        TEST_CASE(widths_are_checked),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
