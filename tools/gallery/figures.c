/* SPDX-License-Identifier: MIT */
/*
 * What the gallery's page says in numbers, measured in the pictures that it shows: a `name,value` a line. Levels are
 * of 255, in RGB888.
 */
#include "picture.h"
#include "scenes/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Pictures ---------------------------------------------------------------------------------------------------- */

/* A scene's variant, found by name. */
typedef struct shown {
    const example_scene *scene;
    uint32_t variant;
} shown;

static shown find(const char *scene, const char *variant) {
    for (int i = 0; i < EXAMPLE_SCENES; i++)
        for (uint32_t j = 0; j < example_scenes[i]->variant_count; j++)
            if (strcmp(example_scenes[i]->name, scene) == 0 &&
                strcmp(example_scenes[i]->variants[j].name, variant) == 0)
                return (shown){example_scenes[i], j};
    fprintf(stderr, "no %s:%s\n", scene, variant);
    exit(1);
}

/* What a material keeps of its light. */
enum { ALL, WITHOUT_SPECULAR, DIFFUSE_ALONE };

static picture draw(const char *scene, const char *variant, int keep) {
    static example_stage stage;
    const shown of = find(scene, variant);
    picture image = picture_open(of.scene->width, of.scene->height, &glint_format_rgb888);
    of.scene->build(&stage, of.variant, 0);
    for (uint32_t i = 0; i < EXAMPLE_OBJECTS_MAX; i++) {
        if (keep != ALL)
            stage.materials[i].specular = (glint_colour){0, 0, 0};
        if (keep == DIFFUSE_ALONE)
            stage.materials[i].ambient = (glint_colour){0, 0, 0};
    }
    if (picture_render(&image, &stage.scene, NULL, NULL) != GLINT_OK) {
        fprintf(stderr, "%s:%s is refused\n", scene, variant);
        exit(1);
    }
    return image;
}

/* Columns of a picture, from `left` to before `right`. */
typedef struct columns {
    int left, right;
} columns;

static columns part(const picture *image, int i, int count) {
    return (columns){image->width * i / count, image->width * (i + 1) / count};
}

static int sum_at(const picture *image, int x, int y) {
    return picture_level(image, x, y, 0) + picture_level(image, x, y, 1) + picture_level(image, x, y, 2);
}

/* ---- What is measured -------------------------------------------------------------------------------------------- */

/* Pixels that a highlight lights by at least half as much as its brightest one. */
static long half_bright(const picture *with, const picture *without, columns in) {
    int most = 0;
    long count = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (int y = 0; y < with->height; y++) {
            for (int x = in.left; x < in.right; x++) {
                const int light = sum_at(with, x, y) - sum_at(without, x, y);
                most = pass == 0 && light > most ? light : most;
                count += pass == 1 && light > 0 && 2 * light >= most;
            }
        }
    }
    return count;
}

/* Highlights' light by which one part of a picture differs from the first, of the first one's. */
static double share_off(const picture *with, const picture *without, int i, int count) {
    const columns first = part(with, 0, count), other = part(with, i, count);
    double off = 0, whole = 0;
    for (int y = 0; y < with->height; y++) {
        for (int x = 0; x < first.right; x++) {
            const int there = other.left + x;
            const int a = sum_at(with, x, y) - sum_at(without, x, y);
            whole += a;
            off += abs(sum_at(with, there, y) - sum_at(without, there, y) - a);
        }
    }
    return off / whole;
}

/* Root mean square difference of two pictures over a region, where either shows something. */
static double difference(const picture *a, const picture *b, columns in) {
    double sum = 0;
    long count = 0;
    for (int y = 0; y < a->height; y++) {
        for (int x = in.left; x < in.right; x++) {
            if (sum_at(a, x, y) + sum_at(b, x, y) == 0)
                continue;
            for (int c = 0; c < 3; c++) {
                const double d = picture_level(a, x, y, c) - picture_level(b, x, y, c);
                sum += d * d;
                count++;
            }
        }
    }
    return sqrt(sum / (double)count);
}

/* The largest change from a pixel to its right or lower neighbour, within a box. */
static int largest_jump(const picture *image, const int box[4]) {
    int most = 0;
    for (int y = box[1]; y < box[3]; y++) {
        for (int x = box[0]; x < box[2]; x++) {
            const int right = abs(picture_level(image, x + 1, y, 1) - picture_level(image, x, y, 1));
            const int down = abs(picture_level(image, x, y + 1, 1) - picture_level(image, x, y, 1));
            most = right > most ? right : most;
            most = down > most ? down : most;
        }
    }
    return most;
}

static int brightest_at(const picture *image, columns in, int *at_x, int *at_y) {
    int most = -1;
    for (int y = 0; y < image->height; y++) {
        for (int x = in.left; x < in.right; x++) {
            if (sum_at(image, x, y) > most) {
                most = sum_at(image, x, y);
                *at_x = x;
                *at_y = y;
            }
        }
    }
    return most;
}

/* ---- Output ------------------------------------------------------------------------------------------------------ */

static void print_levels(const char *name, const picture *image, int x, int y) {
    printf("%s,(%d %d %d)\n", name, picture_level(image, x, y, 0), picture_level(image, x, y, 1),
           picture_level(image, x, y, 2));
}

static void print_brightest(const char *name, const picture *image, columns in) {
    int x = 0, y = 0;
    brightest_at(image, in, &x, &y);
    print_levels(name, image, x, y);
}

/* Sizes of the highlights of `count` objects side by side. */
static void print_sizes(const char *name, const char *scene, const char *variant, int first, int count) {
    picture with = draw(scene, variant, ALL), without = draw(scene, variant, WITHOUT_SPECULAR);
    for (int i = first; i < count; i++)
        printf("%s_%d,%ld\n", name, i, half_bright(&with, &without, part(&with, i, count)));
    picture_close(&with);
    picture_close(&without);
}

static void print_twice(const char *name, const char *variant) {
    picture with = draw("surfaces", variant, ALL), without = draw("surfaces", variant, WITHOUT_SPECULAR);
    for (int i = 1; i < 4; i++)
        printf("%s_%d,%.2f\n", name, 1 << (i - 1), share_off(&with, &without, i, 4));
    picture_close(&with);
    picture_close(&without);
}

/* Of 255 in a channel, and of all three. */
static void print_clamped(void) {
    picture image = draw("surfaces", "terms", ALL);
    const columns in = part(&image, 3, 4);
    long some = 0, all = 0;
    for (int y = 0; y < image.height; y++) {
        for (int x = in.left; x < in.right; x++) {
            const int r = picture_level(&image, x, y, 0), g = picture_level(&image, x, y, 1),
                      b = picture_level(&image, x, y, 2);
            some += r == 255 || g == 255 || b == 255;
            all += r == 255 && g == 255 && b == 255;
        }
    }
    printf("clamped_some,%ld\nclamped_all,%ld\n", some, all);
    picture_close(&image);
}

static void print_metal(void) {
    picture image = draw("surfaces", "metal", ALL);
    static const char *const names[3] = {"metal_plastic", "metal_gold", "metal_paint"};
    for (int i = 0; i < 3; i++)
        print_brightest(names[i], &image, part(&image, i, 3));
    picture_close(&image);
}

/* A place on the ground right of the cylinder, in the shade of nothing, and the cylinder's brightest pixel. */
static void print_dark(void) {
    static const char *const variants[] = {"plain", "dark", "dark-specular-quarter", "dark-diffuse-only",
                                           "inverse-square"};
    for (int i = 0; i < 5; i++) {
        char name[60];
        picture image = draw("phong-lighting", variants[i], ALL);
        snprintf(name, sizeof name, "ground_%s", variants[i]);
        print_levels(name, &image, 40, 120);
        snprintf(name, sizeof name, "spot_%s", variants[i]);
        print_brightest(name, &image, (columns){200, 320});
        picture_close(&image);
    }
}

static void print_jumps(void) {
    static const int strip[4] = {120, 60, 190, 150}, ground[4] = {0, 100, 60, 230}, half[4] = {90, 60, 160, 120};
    picture near_lamp = draw("phong-lighting", "near", ALL), ring = draw("phong-lighting", "ring", ALL),
            blinn = draw("phong-lighting", "ring-blinn-phong", ALL);
    printf("jump_near,%d\njump_ring,%d\njump_ring_blinn_phong,%d\njump_half_blinn_phong,%d\n",
           largest_jump(&near_lamp, strip), largest_jump(&ring, ground), largest_jump(&blinn, ground),
           largest_jump(&blinn, half));
    picture_close(&near_lamp);
    picture_close(&ring);
    picture_close(&blinn);
}

/* Pixels of the right body that its highlight lights and its diffuse light does not. */
static void print_ungated(void) {
    picture with = draw("surfaces", "ungated", ALL), diffuse = draw("surfaces", "ungated", DIFFUSE_ALONE),
            without = draw("surfaces", "ungated", WITHOUT_SPECULAR);
    for (int i = 0; i < 2; i++) {
        const columns in = part(&with, i, 2);
        long count = 0;
        for (int y = 0; y < with.height; y++)
            for (int x = in.left; x < in.right; x++)
                count += sum_at(&diffuse, x, y) == 0 && sum_at(&with, x, y) > sum_at(&without, x, y) + 6;
        printf("%s,%ld\n", i ? "shines_ungated" : "shines_gated", count);
    }
    picture_close(&with);
    picture_close(&diffuse);
    picture_close(&without);
}

/* How far evaluation per vertex is from that per fragment of the same picture. */
static void print_differences(void) {
    static const char *const pots[] = {"vertex-coarse", "vertex", "vertex-dense"};
    picture pot = draw("teapot", "fragment", ALL), spheres = draw("three-spheres", "phong", ALL);
    for (int i = 0; i < 3; i++) {
        picture vertex = draw("teapot", pots[i], ALL);
        printf("teapot_%s,%.1f\n", pots[i], difference(&pot, &vertex, (columns){170, 320}));
        picture_close(&vertex);
    }
    for (int i = 0; i < 2; i++) {
        picture vertex = draw("three-spheres", i ? "vertex-dense" : "vertex", ALL);
        printf("%s,%.1f\n", i ? "spheres_vertex-dense" : "spheres_vertex",
               difference(&spheres, &vertex, (columns){213, 320}));
        picture_close(&vertex);
    }
    picture_close(&pot);
    picture_close(&spheres);
}

/* Ambient light alone, and a whole scene per vertex. */
static void print_class(void) {
    picture green = draw("three-spheres", "greenish", ALL), night = draw("halloween", "night", ALL),
            vertex = draw("halloween", "vertex", ALL);
    print_levels("ambient_green", &green, 64, 118);
    printf("halloween_vertex,%.1f\n", difference(&night, &vertex, (columns){0, night.width}));
    picture_close(&green);
    picture_close(&night);
    picture_close(&vertex);
}

/* Share of the bodies' pixels whose highlight is at least half as bright as its brightest. */
static void print_floods(void) {
    static const char *const variants[] = {"fragment", "flood", "flood-wide"};
    for (int i = 0; i < 3; i++) {
        picture with = draw("teapot", variants[i], ALL), without = draw("teapot", variants[i], WITHOUT_SPECULAR);
        long body = 0;
        for (int j = 0; j < with.width * with.height; j++)
            body += sum_at(&with, j % with.width, j / with.width) > 0;
        printf("flooded_%s,%.0f\n", variants[i],
               100.0 * (double)half_bright(&with, &without, (columns){0, with.width}) / (double)body);
        picture_close(&with);
        picture_close(&without);
    }
}

/* The squashed cylinders: brightest pixels, and where they lie on them. */
static void print_normals(void) {
    picture image = draw("phong-lighting", "scaled-normals", ALL);
    static const columns sides[2] = {{20, 148}, {152, 260}};
    for (int i = 0; i < 2; i++) {
        long lit = 0, all = 0;
        for (int y = 24; y < 100; y++) {
            for (int x = sides[i].left; x < sides[i].right; x++) {
                const int r = picture_level(&image, x, y, 0), b = picture_level(&image, x, y, 2);
                all += r > b;
                lit += r > b && r > 60;
            }
        }
        printf("%s,%.0f\n", i ? "lit_wrong" : "lit_right", 100.0 * (double)lit / (double)all);
    }
    picture_close(&image);
}

int main(void) {
    puts("name,value");
    print_sizes("exponents", "surfaces", "exponents", 0, 5);
    print_sizes("spheres", "three-spheres", "phong", 1, 3);
    print_sizes("blinn_spheres", "three-spheres", "blinn-phong", 1, 3);
    print_twice("near", "twice-near");
    print_twice("far", "twice-far");
    print_clamped();
    print_metal();
    print_dark();
    print_jumps();
    print_ungated();
    print_differences();
    print_class();
    print_floods();
    print_normals();
    return ferror(stdout) || fflush(stdout);
}
