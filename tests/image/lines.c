/* SPDX-License-Identifier: MIT */
/*
 * Suite: lines. Which pixels they have, how deep they lie, and that neither tile nor arena, region or format changes
 * that, through any view: a line across the screen has a pixel in each column.
 */
#include "every_format.h"
#include "glint_extras.h"
#include "harness.h"
#include "library_geometry.h"
#include "picture.h"
#include "random.h"
#include "sample.h"
#include "scenes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH 150
#define HEIGHT 101
#define LINES 40

static double real(glint_q16 x) {
    return x / 65536.0;
}

/* ---- Drawing ---- */

/* What an overlay draws, and what depth it finds and leaves. */
typedef struct overlay {
    const glint_segment *segments;
    uint32_t count;
    uint16_t before[HEIGHT][WIDTH], after[HEIGHT][WIDTH];
} overlay;

static overlay over;

static void keep_depth(const glint_tile *tile, uint16_t to[HEIGHT][WIDTH]) {
    for (int y = 0; y < tile->height; y++)
        memcpy(&to[tile->y + y][tile->x], tile->depth + (size_t)y * tile->depth_stride,
               (size_t)tile->width * sizeof(uint16_t));
}

static int draw_overlay(void *context, const glint_tile *tile) {
    overlay *const o = context;
    keep_depth(tile, o->before);
    const int result = glint_lines_draw(tile, o->segments, o->count);
    keep_depth(tile, o->after);
    return result;
}

/* Draws a scene, and lines over it. */
static void draw_with(const glint_scene *scene, const picture_options *how, const glint_segment *segments,
                      uint32_t count, picture *image) {
    picture_options options = *how;
    if (segments) {
        over = (overlay){.segments = segments, .count = count};
        options.overlay = (glint_painter){draw_overlay, &over};
    }
    CHECK_EQUAL(picture_render(image, scene, &options, NULL), GLINT_OK);
}

static void draw(const glint_scene *scene, const glint_segment *segments, uint32_t count, picture *image) {
    draw_with(scene, &(picture_options){0}, segments, count, image);
}

static picture open_picture(const glint_format *format) {
    return picture_open(WIDTH, HEIGHT, format);
}

/* ---- The rule, by itself ---- */

/* A point of a line in double precision: pixels, and 1/w; of parallel rays, how far before REFERENCE_FAR it is. */
typedef struct point {
    double x, y, inverse_w;
} point;

typedef struct sight {
    double place[3]; /* right, down, away */
} sight;

static double pixels_of_unit(const glint_scene *scene) {
    return HEIGHT / real(scene->camera.view_height);
}

static double focal_length(const glint_scene *scene) {
    return 0.5 * HEIGHT / tan(real(scene->camera.field_of_view) * 3.14159265358979323846 / 360);
}

static sight see(const glint_scene *scene, const glint_pose *pose, glint_vector of) {
    const double local[3] = {real(of.x), real(of.y), real(of.z)};
    double from_eye[3];
    sight s;
    for (int i = 0; i < 3; i++)
        from_eye[i] = real(pose->m[i][0]) * local[0] + real(pose->m[i][1]) * local[1] + real(pose->m[i][2]) * local[2] +
                      real(pose->m[i][3]) - real(scene->camera.pose.m[i][3]);
    for (int i = 0; i < 3; i++) {
        s.place[i] = 0;
        for (int j = 0; j < 3; j++)
            s.place[i] += real(scene->camera.pose.m[j][i]) * from_eye[j] * (i ? -1 : 1);
    }
    return s;
}

static sight point_between(const sight *a, const sight *b, double t) {
    sight s;
    for (int i = 0; i < 3; i++)
        s.place[i] = a->place[i] + (b->place[i] - a->place[i]) * t;
    return s;
}

/* How far inside a bound: the near plane, and 1023 pixels to each side. */
static double inside(const glint_scene *scene, const sight *s, int bound) {
    const double w = s->place[2],
                 band = scene->camera.projection ? 1023 / pixels_of_unit(scene) : 1023 / focal_length(scene) * w;
    return bound == 0 ? w - real(scene->camera.near_plane)
                      : band + (bound & 1 ? s->place[bound > 2] : -s->place[bound > 2]);
}

/* Ends of a line as the rule cuts them. @return 0 where nothing is left */
static int cut(const glint_scene *scene, const glint_pose *pose, const glint_line *line, point ends[2]) {
    sight s[2] = {see(scene, pose, line->from), see(scene, pose, line->to)};
    const double focal = focal_length(scene);
    for (int bound = 0; bound < 5; bound++) {
        const double a = inside(scene, &s[0], bound), b = inside(scene, &s[1], bound);
        if (a < 0 && b < 0)
            return 0;
        if (a < 0)
            s[0] = point_between(&s[0], &s[1], a / (a - b));
        if (b < 0)
            s[1] = point_between(&s[0], &s[1], a / (a - b));
    }
    for (int i = 0; i < 2; i++) {
        const int is_parallel = scene->camera.projection != NULL;
        const double scale = is_parallel ? pixels_of_unit(scene) : focal / s[i].place[2];
        ends[i] = (point){0.5 * WIDTH + scale * s[i].place[0], 0.5 * HEIGHT + scale * s[i].place[1],
                          is_parallel ? REFERENCE_FAR - s[i].place[2] : 1 / s[i].place[2]};
    }
    return 1;
}

/* Pixels of a line between rounded ends, and 1/w there: 0 where it has none. All places are fractions of integers. */
static void cover(const glint_segment *segment, const point ends[2], double to[HEIGHT][WIDTH]) {
    const int dx = abs(segment->x[1] - segment->x[0]), dy = abs(segment->y[1] - segment->y[0]), steep = dy > dx;
    const int16_t *const u = steep ? segment->y : segment->x, *const v = steep ? segment->x : segment->y;
    const int length = steep ? dy : dx, low = u[1] < u[0], high = !low;
    memset(to, 0, sizeof(double[HEIGHT][WIDTH]));
    for (int pixel = 0; pixel < (steep ? HEIGHT : WIDTH); pixel++) {
        if (16 * pixel + 15 < u[low] || 16 * pixel > u[high])
            continue;
        const int middle = 16 * pixel + 8, at = middle < u[low] ? u[low] : middle > u[high] ? u[high] : middle;
        const long long across = (long long)v[low] * length + (long long)(v[high] - v[low]) * (at - u[low]);
        const double exact =
            length ? (double)across / (16.0 * length) : v[low] / 16.0; /* quotients of small integers */
        const int other = (int)floor(exact), x = steep ? other : pixel, y = steep ? pixel : other;
        const double t = length ? (double)(at - u[low]) / length : 0;
        if (x >= 0 && x < WIDTH && y >= 0 && y < HEIGHT)
            to[y][x] = ends[low].inverse_w + (ends[high].inverse_w - ends[low].inverse_w) * t;
    }
}

/* ---- Scenes ---- */

typedef struct line_scene {
    test_scene at;
    glint_pose pose;
    glint_line lines[LINES];
    glint_segment segments[LINES];
} line_scene;

static glint_vector any_vector(int reach) {
    return (glint_vector){any(-reach, reach), any(-reach, reach), any(-reach, reach)};
}

/* So many times as far from the origin as a mesh reaches. */
static glint_vector any_place(glint_vector extent, int times) {
    return (glint_vector){any(-times * extent.x, times * extent.x), any(-times * extent.y, times * extent.y),
                          any(-times * extent.z, times * extent.z)};
}

/* Lines about the objects of a random scene, some of which pass the eye or are points. */
static void build(line_scene *s, uint32_t number) {
    scene_build_random(&s->at, number);
    const glint_object *const object = &s->at.objects[0];
    const glint_vector extent = object->mesh->extent;
    random_state = number;
    s->pose = object->pose;
    if (number % 3 == 0) {
        s->at.scene.camera.projection = &glint_orthographic;
        s->at.scene.camera.view_height = 4 * (extent.x > extent.y ? extent.x : extent.y) + 256;
    }
    for (int i = 0; i < LINES; i++) {
        const int reach = i % 5 == 4 ? 12 : 2;
        s->lines[i] = (glint_line){
            any_place(extent, reach), any_place(extent, reach), {GLINT_ONE, GLINT_ONE / 2, GLINT_ONE / 4}, 0};
        if (i % 7 == 3)
            s->lines[i].to = s->lines[i].from;
    }
}

static glint_config screen_of(int width, int height) {
    return (glint_config){.width = (uint16_t)width, .height = (uint16_t)height};
}

static void place(line_scene *s) {
    const glint_config config = screen_of(WIDTH, HEIGHT);
    CHECK_EQUAL(glint_lines_project(s->segments, &config, &s->at.scene.camera, &s->pose, s->lines, LINES), GLINT_OK);
}

/* ---- Cases ---- */

static line_scene scene;
/* Ends lie where they do in double precision, before these are rounded to sixteenths: up to 1/64 more. */
static void ends_are_where_they_are(void) {
    int seen = 0, gone = 0;
    double worst = 0;
    for (uint32_t number = 1; number <= 200; number++) {
        build(&scene, number);
        place(&scene);
        for (int i = 0; i < LINES; i++) {
            const glint_segment *const s = &scene.segments[i];
            point ends[2];
            const int shows = cut(&scene.at.scene, &scene.pose, &scene.lines[i], ends);
            if (!CHECK_EQUAL(s->colour != NULL, shows))
                continue;
            seen += shows;
            gone += !shows;
            for (int end = 0; end < 2 && shows; end++) {
                if (fabs(ends[end].x - 0.5 * WIDTH) > 500 || fabs(ends[end].y - 0.5 * HEIGHT) > 500)
                    continue;
                worst = fmax(worst, fabs(16 * ends[end].x - s->x[end]));
                worst = fmax(worst, fabs(16 * ends[end].y - s->y[end]));
                const double kept = ldexp(s->inverse_w[end], 28 - s->exponent[end]); /* 1/w */
                if (!scene.at.scene.camera.projection)
                    CHECK(fabs(kept / ends[end].inverse_w - 1) < 1e-4);
            }
        }
    }
    CHECK_AT_MOST((int)(1000 * worst), 500 + 250);
    CHECK(seen > 4000 && gone > 100);
}

/* The farthest corner of the objects' boxes. */
static double find_farthest(const glint_scene *of) {
    double farthest = 0;
    for (uint32_t i = 0; i < of->object_count; i++)
        for (int corner = 0; corner < 8; corner++) {
            const glint_object *const object = &of->objects[i];
            const glint_vector e = object->mesh->extent, o = object->mesh->offset;
            const sight s = see(of, &object->pose,
                                (glint_vector){o.x + (corner & 1 ? e.x : -e.x), o.y + (corner & 2 ? e.y : -e.y),
                                               o.z + (corner & 4 ? e.z : -e.z)});
            farthest = fmax(farthest, s.place[2]);
        }
    return farthest;
}

static void pixels_are_those_of_the_rule(void) {
    static double covered[HEIGHT][WIDTH];
    int drawn = 0, hidden = 0, close = 0;
    for (uint32_t number = 1; number <= 18; number++) {
        library_geometry geometry;
        picture plain = open_picture(&glint_format_rgb888), image = open_picture(&glint_format_rgb888);
        const glint_config config = picture_config(&plain, &(picture_options){0});
        build(&scene, number);
        place(&scene);
        if (!CHECK_EQUAL(library_geometry_open(&geometry, &config, &scene.at.scene), GLINT_OK))
            return;
        const int is_parallel = scene.at.scene.camera.projection != NULL;
        const double farthest = is_parallel ? find_farthest(&scene.at.scene) : 0; /* begins with depth 1 */
        const double scale = geometry.depth_scale * (is_parallel ? 1 : 1 + 2 / focal_length(&scene.at.scene));
        const double before = is_parallel ? REFERENCE_FAR - farthest - 2 / pixels_of_unit(&scene.at.scene) : 0;
        draw(&scene.at.scene, NULL, 0, &plain);
        for (uint32_t i = 0; i < LINES; i++) {
            point ends[2];
            int wrong = 0;
            draw(&scene.at.scene, &scene.segments[i], 1, &image);
            if (cut(&scene.at.scene, &scene.pose, &scene.lines[i], ends))
                cover(&scene.segments[i], ends, covered);
            else
                memset(covered, 0, sizeof covered);
            for (int y = 0; y < HEIGHT; y++)
                for (int x = 0; x < WIDTH; x++) {
                    const double exact = fmax(fmin((covered[y][x] - before) * scale, 65534), 0.5) + 0.5;
                    const int there = over.before[y][x], is_line = over.after[y][x] != there;
                    const uint8_t *const pixel = image.bytes + (size_t)y * image.stride + 3 * (size_t)x,
                                         *const old = plain.bytes + (size_t)y * plain.stride + 3 * (size_t)x;
                    const int is_coloured = pixel[0] == 255 && pixel[1] == 128 && pixel[2] == 64;
                    if (covered[y][x] == 0) {
                        wrong += is_line || memcmp(pixel, old, 3) != 0;
                        continue;
                    }
                    if (there != 0 && fabs(exact - there) <= 2 + exact / 8192) { /* rounding decides */
                        close++;
                        continue;
                    }
                    drawn += exact > there;
                    hidden += exact < there;
                    wrong += is_line != (exact > there) || (is_line ? !is_coloured : memcmp(pixel, old, 3) != 0);
                    wrong += is_line && fabs(over.after[y][x] - exact) > 2 + exact / 8192;
                }
            CHECK_EQUAL(wrong, 0);
        }
        library_geometry_close(&geometry);
        picture_close(&plain);
        picture_close(&image);
    }
    CHECK(drawn > 8000 && hidden > 4000);
    CHECK_AT_MOST(close, 100);
}

/*
 * Of parallel rays, all that a scene has may lie within 2^-16 of a unit: a line thousands of times that far behind it
 * or before it still is, and is drawn there at the largest depth.
 */
static void lines_far_from_all_else_keep_their_side(void) {
    const glint_mesh square = scene_square_mesh(100 * GLINT_ONE, 1);
    const glint_material paint = {.model = &glint_model_unlit};
    const glint_pose at = glint_pose_identity();
    const glint_config config = screen_of(WIDTH, HEIGHT);
    picture image = open_picture(&glint_format_rgb888);
    for (int away = 40; away <= 12000; away += away / 7) {
        const glint_object object = {.mesh = &square,
                                     .material = &paint,
                                     .evaluation = &glint_per_fragment,
                                     .pose = glint_pose_translate(0, 0, -away * GLINT_ONE)};
        const glint_scene flat = {
            .camera = {.pose = at, .near_plane = 1, .projection = &glint_orthographic, .view_height = 100 * GLINT_ONE},
            .objects = &object,
            .object_count = 1};
        for (int line = 1; line < 12; line++) {
            const glint_q16 before = away * GLINT_ONE / 12 * line, behind = -(away + away * line / 8) * GLINT_ONE;
            const glint_q16 z[2] = {-before, behind};
            for (int is_behind = 0; is_behind < 2; is_behind++) {
                const glint_line one = {{-9 * GLINT_ONE, 0, z[is_behind]}, {9 * GLINT_ONE, 0, z[is_behind]}, {0, 0, 0}};
                glint_segment segment;
                int wrong = 0;
                CHECK_EQUAL(glint_lines_project(&segment, &config, &flat.camera, &at, &one, 1), GLINT_OK);
                draw(&flat, &segment, 1, &image);
                for (int x = WIDTH / 2 - 5; x < WIDTH / 2 + 5; x++)
                    wrong += is_behind ? over.after[HEIGHT / 2][x] != over.before[HEIGHT / 2][x]
                                       : over.after[HEIGHT / 2][x] != 0xffff;
                CHECK_EQUAL(wrong, 0);
            }
        }
    }
    picture_close(&image);
}

static void directions_and_copies_change_nothing(void) {
    for (uint32_t number = 1; number <= 20; number++) {
        picture a = open_picture(&glint_format_grey8), b = open_picture(&glint_format_grey8);
        build(&scene, number);
        place(&scene);
        draw(&scene.at.scene, scene.segments, LINES, &a);
        for (int i = 0; i < LINES; i++) {
            const glint_vector from = scene.lines[i].from;
            scene.lines[i].from = scene.lines[i].to;
            scene.lines[i].to = from;
        }
        place(&scene);
        draw(&scene.at.scene, scene.segments, LINES, &b);
        CHECK(picture_equal(&a, &b));
        for (int i = LINES / 2; i < LINES; i++) { /* what ties with what is there is not drawn */
            scene.lines[i] = scene.lines[i - LINES / 2];
            scene.lines[i].colour = (glint_colour){0, 0, GLINT_ONE};
        }
        place(&scene);
        draw(&scene.at.scene, scene.segments, LINES, &b);
        draw(&scene.at.scene, scene.segments, LINES / 2, &a);
        CHECK(picture_equal(&a, &b));
        picture_close(&a);
        picture_close(&b);
    }
}

/* Lines in a region, which begins inside of a tile, are hidden by what hides them in the whole frame. */
static void depth_in_regions_is_that_of_the_frame(void) {
    static overlay whole;
    const glint_rectangle region = {5, 6, WIDTH - 9, HEIGHT - 9};
    picture image = open_picture(&glint_format_grey8);
    int unlike = 0;
    build(&scene, 1);
    place(&scene);
    draw(&scene.at.scene, scene.segments, LINES, &image);
    whole = over;
    draw_with(&scene.at.scene, &(picture_options){.region = region}, scene.segments, LINES, &image);
    for (int y = region.y; y < region.y + region.height; y++)
        for (int x = region.x; x < region.x + region.width; x++)
            unlike += over.before[y][x] != whole.before[y][x] || over.after[y][x] != whole.after[y][x];
    CHECK_EQUAL(unlike, 0);
    picture_close(&image);
}

/* Does a picture show, where lines are, what a screen of their colour shows, and elsewhere what there is without? */
static void check_format(const glint_format *format, uint32_t number) {
    picture plain = open_picture(format), lines = open_picture(format), even = open_picture(format);
    int wrong = 0, counted = 0;
    build(&scene, number);
    place(&scene);
    draw(&scene.at.scene, NULL, 0, &plain);
    draw(&scene.at.scene, scene.segments, LINES, &lines);
    scene.at.scene.object_count = 0;
    scene.at.scene.background = scene.lines[0].colour;
    draw(&scene.at.scene, NULL, 0, &even);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            for (int c = 0; c < picture_channels(format); c++) {
                const int is_line = over.after[y][x] != over.before[y][x];
                counted += is_line;
                wrong += picture_level(&lines, x, y, c) != picture_level(is_line ? &even : &plain, x, y, c);
            }
    CHECK_EQUAL(wrong, 0);
    CHECK(counted > 150);
    picture_close(&plain);
    picture_close(&lines);
    picture_close(&even);
}

static void every_format_shows_their_colour(void) {
    for (uint32_t i = 0; i < TEST_COUNT(every_format); i++)
        check_format(every_format[i], i + 1);
}

/*
 * Edges of a mesh show on it: in the middle of each, where the reference sees no other surface far in front, or where
 * it does, they are hidden.
 */
static void edges_show_on_their_mesh(void) {
    static glint_line lines[864];
    static glint_segment segments[864];
    static double covered[HEIGHT][WIDTH];
    static reference_pixel pixels[HEIGHT][WIDTH];
    const glint_config config = screen_of(WIDTH, HEIGHT);
    const reference_image image = {WIDTH, HEIGHT, pixels[0]};
    picture drawn = open_picture(&glint_format_rgb888);
    bench_scene torus;
    int shown = 0, lost = 0, hidden = 0, seen_through = 0;
    bench_build_scene(&torus, &bench_definitions[1], scene_bench_mesh(1), 3);
    const glint_mesh *const mesh = torus.object.mesh;
    if (!CHECK_EQUAL(glint_lines_edges(lines, 864, mesh, (glint_colour){GLINT_ONE, 0, 0}), 864))
        return;
    CHECK_EQUAL(glint_lines_project(segments, &config, &torus.scene.camera, &torus.object.pose, lines, 864), GLINT_OK);
    draw(&torus.scene, segments, 864, &drawn);
    memset(pixels, 0, sizeof pixels);
    reference_render(&image, &torus.scene, NULL);
    for (uint32_t i = 0; i < 864; i++) {
        const glint_segment *const s = &segments[i];
        const int wide = abs(s->x[1] - s->x[0]) >= abs(s->y[1] - s->y[0]);
        int x = (s->x[0] + s->x[1]) >> 5, y = (s->y[0] + s->y[1]) >> 5;
        point ends[2];
        cut(&torus.scene, &torus.object.pose, &lines[i], ends);
        cover(s, ends, covered);
        for (int beside = -1; beside <= 1; beside += 2) /* its pixel in the middle column or row */
            if (covered[y][x] == 0 && covered[y + (wide ? beside : 0)][x + (wide ? 0 : beside)] != 0) {
                y += wide ? beside : 0;
                x += wide ? 0 : beside;
            }
        const double inverse_w = covered[y][x], surface = pixels[y][x].nearest;
        const int is_line = over.after[y][x] != over.before[y][x];
        if (surface > 1.04 * inverse_w) { /* that far in front, none of its neighbours shows through */
            hidden++;
            seen_through += is_line && fabs((double)over.after[y][x] / over.before[y][x] - 1) > 1;
        } else {
            shown++;
            lost += !is_line;
        }
    }
    CHECK(shown > 300 && hidden > 300);
    CHECK_AT_MOST(lost, shown / 50); /* those that lean too far */
    CHECK_EQUAL(seen_through, 0);
    picture_close(&drawn);
}

static int same_point(glint_vector a, glint_vector b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static void boxes_have_twelve_edges(void) {
    const glint_vector from = {-3, 5, 70000}, to = {9, -2, -70000};
    const glint_colour red = {GLINT_ONE, 0, 0};
    glint_line lines[12];
    glint_lines_box(lines, from, to, red);
    for (int i = 0; i < 12; i++) {
        const glint_vector a = lines[i].from, b = lines[i].to;
        CHECK((a.x == from.x || a.x == to.x) && (a.y == from.y || a.y == to.y) && (a.z == from.z || a.z == to.z));
        CHECK((b.x == from.x || b.x == to.x) && (b.y == from.y || b.y == to.y) && (b.z == from.z || b.z == to.z));
        CHECK_EQUAL((a.x != b.x) + (a.y != b.y) + (a.z != b.z), 1);
        CHECK_EQUAL(lines[i].colour.r, GLINT_ONE);
        for (int j = 0; j < i; j++)
            CHECK(!(same_point(a, lines[j].from) && same_point(b, lines[j].to)) &&
                  !(same_point(b, lines[j].from) && same_point(a, lines[j].to)));
    }
}

static void edges_of_a_mesh_come_once(void) {
    static const int16_t positions[4][3] = {{-32768, 0, 0}, {16384, 0, 0}, {0, 16384, 0}, {0, 0, 1}};
    static const uint16_t triangles[2][3] = {{0, 1, 2}, {1, 0, 3}};
    const glint_mesh mesh = {
        positions, positions, triangles, 4, 2, {GLINT_ONE, 0, INT32_MAX}, {INT32_MAX, GLINT_ONE, 1 << 15}};
    glint_line lines[5] = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
    CHECK_EQUAL(glint_lines_edges(NULL, 0, &mesh, (glint_colour){0, 0, 0}), 5);
    CHECK_EQUAL(glint_lines_edges(lines, 4, &mesh, (glint_colour){1, 2, 3}), 5);
    CHECK_EQUAL(lines[0].from.x, GLINT_ONE - INT32_MAX); /* 0 to 1 */
    CHECK_EQUAL(lines[0].to.x, (1 << 30) + GLINT_ONE);
    CHECK_EQUAL(lines[1].to.y, GLINT_ONE / 2);
    CHECK_EQUAL(lines[3].to.z, INT32_MAX); /* 0 to 3: the sum does not fit */
    CHECK_EQUAL(lines[3].colour.b, 3);
    CHECK_EQUAL(lines[4].colour.b, 0);
    glint_mesh less = mesh;
    less.vertex_count = 3; /* the second triangle has one edge with vertices of its own, which the first has named */
    CHECK_EQUAL(glint_lines_edges(lines, 4, &less, (glint_colour){1, 2, 3}), 3);
}

static void bad_input_is_refused(void) {
    glint_config config = screen_of(WIDTH, HEIGHT);
    build(&scene, 1);
    const glint_camera camera = scene.at.scene.camera;
    glint_camera bad = camera;
    memset(scene.segments, 0x5a, sizeof scene.segments);
    bad.near_plane = 0;
    CHECK_EQUAL(glint_lines_project(NULL, &config, &camera, &scene.pose, scene.lines, LINES), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_lines_project(scene.segments, NULL, &camera, &scene.pose, scene.lines, LINES), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_lines_project(scene.segments, &config, NULL, &scene.pose, scene.lines, LINES), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_lines_project(scene.segments, &config, &camera, NULL, scene.lines, LINES), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_lines_project(scene.segments, &config, &camera, &scene.pose, NULL, LINES), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_lines_project(scene.segments, &config, &bad, &scene.pose, scene.lines, LINES),
                GLINT_ERROR_CAMERA);
    config.height = GLINT_SIZE_MAX + 1;
    CHECK_EQUAL(glint_lines_project(scene.segments, &config, &camera, &scene.pose, scene.lines, LINES),
                GLINT_ERROR_SIZE);
    config.height = HEIGHT;
    scene.lines[LINES - 1].colour.g = GLINT_COLOUR_MAX + 1;
    CHECK_EQUAL(glint_lines_project(scene.segments, &config, &camera, &scene.pose, scene.lines, LINES),
                GLINT_ERROR_COLOUR);
    scene.lines[LINES - 1].colour.g = -1;
    CHECK_EQUAL(glint_lines_project(scene.segments, &config, &camera, &scene.pose, scene.lines, LINES),
                GLINT_ERROR_COLOUR);
    for (int i = 0; i < LINES; i++)
        CHECK(scene.segments[i].x[0] == 0x5a5a && scene.segments[i].exponent[1] == 0x5a);
    CHECK_EQUAL(glint_lines_project(NULL, &config, &camera, &scene.pose, NULL, 0), GLINT_OK);
    CHECK_EQUAL(glint_lines_draw(NULL, scene.segments, 1), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_lines_draw(&(glint_tile){0}, scene.segments, 1), GLINT_ERROR_NULL);
    picture image = open_picture(&glint_format_rgb888);
    draw(&scene.at.scene, scene.segments, 0, &image); /* no lines at all */
    picture_close(&image);
}

static glint_q16 any_number(void) {
    static const glint_q16 ends[] = {INT32_MIN, INT32_MIN + 1, -1, 0, 1, INT32_MAX - 1, INT32_MAX};
    const int kind = any(0, 3);
    if (kind == 0)
        return ends[any(0, (int)TEST_COUNT(ends) - 1)];
    return (glint_q16)((uint32_t)any(0, 0xffff) << 16 | (uint32_t)any(0, 0xffff)) >> (kind == 1 ? 0 : any(0, 30));
}

/* Any numbers whatever, of any camera: ends stay within the guard band, and what is drawn on the screen. */
static void extremes_stay_in_their_place(void) {
    picture image = open_picture(&glint_format_grey4);
    test_scene torus;
    int seen = 0, wrong = 0;
    scene_build_named(&torus, "mirrored");
    random_state = 5;
    for (int i = 0; i < 30000; i++) {
        const glint_config config = i % 256 == 0 ? screen_of(WIDTH, HEIGHT) : screen_of(any(1, 1024), any(1, 1024));
        const glint_vector axis = any_vector(GLINT_ONE);
        glint_camera camera = {glint_pose_rotate(axis, any(0, 360) * GLINT_ONE), any(GLINT_ONE, 170 * GLINT_ONE),
                               any_number() & INT32_MAX};
        glint_pose pose;
        glint_line line = {{any_number(), any_number(), any_number()},
                           {any_number(), any_number(), any_number()},
                           {GLINT_COLOUR_MAX, 0, GLINT_ONE}};
        glint_segment segment;
        camera.near_plane += camera.near_plane == 0;
        for (int row = 0; row < 3; row++) {
            camera.pose.m[row][3] = any_number();
            for (int column = 0; column < 4; column++)
                pose.m[row][column] = any_number();
        }
        if (!CHECK_EQUAL(glint_lines_project(&segment, &config, &camera, &pose, &line, 1), GLINT_OK))
            return;
        if (!segment.colour)
            continue;
        seen++;
        for (int end = 0; end < 2; end++)
            wrong += abs(segment.x[end] - 8 * config.width) > 16 * 1023 ||
                     abs(segment.y[end] - 8 * config.height) > 16 * 1023;
        if (i % 256 != 0)
            continue;
        draw(&torus.scene, &segment, 1, &image);
    }
    CHECK_EQUAL(wrong, 0);
    CHECK(seen > 1000);
    picture_close(&image);
}

/* A line that lies in the near plane is where one twice as far and twice as long is; one that only ends there, from
 * behind, is a point, whichever end it is. */
static void lines_in_the_near_plane_show(void) {
    const glint_config config = screen_of(WIDTH, HEIGHT);
    const glint_camera camera = {
        .pose = glint_pose_identity(), .field_of_view = 50 * GLINT_ONE, .near_plane = GLINT_ONE};
    const glint_pose pose = glint_pose_identity();
    const glint_colour white = {GLINT_ONE, GLINT_ONE, GLINT_ONE};
    const glint_vector from = {-GLINT_ONE / 4, GLINT_ONE / 8, -GLINT_ONE}, behind = {GLINT_ONE, 0, GLINT_ONE};
    const glint_line lines[4] = {
        {{-GLINT_ONE / 2, GLINT_ONE / 4, -2 * GLINT_ONE}, {GLINT_ONE / 4, 0, -2 * GLINT_ONE}, white},
        {from, {GLINT_ONE / 8, 0, -GLINT_ONE}, white},
        {from, behind, white},
        {behind, from, white}};
    glint_segment segments[4];
    CHECK_EQUAL(glint_lines_project(segments, &config, &camera, &pose, lines, 4), GLINT_OK);
    for (int i = 1; i < 4; i++)
        for (int end = 0; end < 2; end++) {
            CHECK(segments[i].colour);
            CHECK_EQUAL(segments[i].x[end], segments[0].x[i == 1 ? end : 0]);
            CHECK_EQUAL(segments[i].y[end], segments[0].y[i == 1 ? end : 0]);
        }
}

/* ---- Any views: screens of 1/256 to 32767 units, fields of view of 1 to 170 degrees, near planes of any number ----
 */

#define VIEW_LINES 12

/* From least to most, of any numbers. */
static int32_t any_wide(int32_t least, int32_t most) {
    const uint32_t high = random_bits() >> 8;
    const uint64_t count = (uint64_t)((int64_t)most - least) + 1, number = (uint64_t)high << 16 | random_bits() >> 8;
    return (int32_t)(least + (int64_t)(number * count >> 32));
}

/* From 1 to most, each number of bits as likely. */
static int32_t any_size(int32_t most) {
    const int32_t bits = any_wide(0, 30);
    return any_wide(1, most >> bits ? most >> bits : 1);
}

/* Draws lines and nothing else. @return pixels that they have */
static uint32_t draw_view(const glint_camera *camera, const glint_line *lines, uint32_t count, uint16_t tile,
                          picture *image) {
    const glint_config config = picture_config(image, NULL);
    const glint_pose pose = glint_pose_identity();
    const glint_scene view = {.camera = *camera};
    glint_segment segments[VIEW_LINES];
    uint32_t marked = 0;
    CHECK_EQUAL(glint_lines_project(segments, &config, camera, &pose, lines, count), GLINT_OK);
    draw_with(&view, &(picture_options){.tile_width = tile, .tile_height = tile}, segments, count, image);
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            marked += over.after[y][x] != 0;
    return marked;
}

static glint_camera any_camera(void) {
    glint_camera camera = {.field_of_view = 45 * GLINT_ONE};
    const glint_vector axis = {any_wide(-9, 9), any_wide(-9, 9), any_wide(1, 9)};
    camera.pose = glint_pose_rotate(axis, any_wide(0, 360 * GLINT_ONE));
    camera.near_plane = any_size(INT32_MAX);
    camera.field_of_view = any_wide(GLINT_ONE, 170 * GLINT_ONE);
    if (any_wide(0, 2)) {
        camera.projection = &glint_orthographic;
        camera.view_height = GLINT_ONE / 256 - 1 + any_size(INT32_MAX - GLINT_ONE);
    }
    return camera;
}

static const glint_colour white = {GLINT_ONE, GLINT_ONE, GLINT_ONE};

/* Half of what a square screen shows, with a quarter more, at the near plane. */
static int64_t half_of_view(const glint_camera *camera) {
    if (camera->projection)
        return (int64_t)camera->view_height * 5 / 8 + 2;
    const glint_q16 half = camera->field_of_view / 2;
    return (int64_t)camera->near_plane * glint_sin(half) / glint_cos(half) * 5 / 4 + 2;
}

static void lines_across_views_have_every_column(void) {
    uint32_t drawn = 0, reported = 0;
    for (uint32_t i = 0; i < 4000 / sample_share(); i++) {
        random_state = i + 1;
        const glint_camera camera = any_camera();
        const int size = any_wide(1, 70);
        const int64_t half = half_of_view(&camera);
        const glint_q16 near_plane = camera.near_plane;
        if (half > 18000 * (int64_t)GLINT_ONE || near_plane > 18000 * GLINT_ONE || half < 1000 * size ||
            half < near_plane >> 10)
            continue; /* ends leave the range, or they or the turn are rounded to whole pixels */
        /* behind the near plane by more than the turn's rounding brings an end towards it */
        const glint_q16 away = -(near_plane + near_plane / 64 + (glint_q16)(half >> 12) + 2);
        const glint_vector left = {(glint_q16)-half, 0, away}, right = {(glint_q16)half, 0, away};
        const glint_line line = {glint_pose_apply(&camera.pose, left), glint_pose_apply(&camera.pose, right), white};
        picture image = picture_open(size, size, &glint_format_rgb565);
        if (!CHECK_EQUAL(draw_view(&camera, &line, 1, 16, &image), size) && reported++ < 8) {
            test_write("  view ");
            test_write_number(i);
            test_write("\n");
        }
        picture_close(&image);
        drawn++;
    }
    CHECK(drawn > 400 / sample_share());
}

static void any_lines_are_the_same_in_all_tiles(void) {
    for (uint32_t i = 0; i < 3000 / sample_share(); i++) {
        random_state = i + 1;
        const glint_camera camera = any_camera();
        const int width = any_wide(1, 70), height = any_wide(1, 70);
        const int32_t most = any_size(INT32_MAX);
        glint_line lines[VIEW_LINES];
        for (uint32_t l = 0; l < VIEW_LINES; l++)
            lines[l] = (glint_line){{any_wide(-most, most), any_wide(-most, most), any_wide(-most, most)},
                                    {any_wide(-most, most), any_wide(-most, most), any_wide(-most, most)},
                                    {any_wide(0, GLINT_ONE), any_wide(0, GLINT_ONE), any_wide(0, GLINT_ONE)},
                                    0};
        picture whole = picture_open(width, height, &glint_format_rgb565);
        const uint32_t marked = draw_view(&camera, lines, VIEW_LINES, 64, &whole);
        for (uint16_t tile = 8; tile < 64; tile *= 2) {
            picture again = picture_open(width, height, &glint_format_rgb565);
            CHECK_EQUAL(draw_view(&camera, lines, VIEW_LINES, tile, &again), marked);
            CHECK(picture_equal(&again, &whole));
            picture_close(&again);
        }
        picture_close(&whole);
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(ends_are_where_they_are),
        TEST_CASE(pixels_are_those_of_the_rule),
        TEST_CASE(lines_far_from_all_else_keep_their_side),
        TEST_CASE(directions_and_copies_change_nothing),
        TEST_CASE(depth_in_regions_is_that_of_the_frame),
        TEST_CASE(every_format_shows_their_colour),
        TEST_CASE(edges_show_on_their_mesh),
        TEST_CASE(boxes_have_twelve_edges),
        TEST_CASE(edges_of_a_mesh_come_once),
        TEST_CASE(bad_input_is_refused),
        TEST_CASE(extremes_stay_in_their_place),
        TEST_CASE(lines_in_the_near_plane_show),
        TEST_CASE(lines_across_views_have_every_column),
        TEST_CASE(any_lines_are_the_same_in_all_tiles),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
