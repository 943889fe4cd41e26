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

/* A frame; with the shininess of all materials changed where that is not 0. */
static picture draw_changed(const char *scene, const char *variant, int keep, uint32_t frame, glint_q16 shininess) {
    static example_stage stage;
    const shown of = find(scene, variant);
    picture image = picture_open(of.scene->width, of.scene->height, &glint_format_rgb888);
    of.scene->build(&stage, of.variant, frame);
    for (uint32_t i = 0; i < EXAMPLE_OBJECTS_MAX; i++) {
        if (shininess)
            stage.materials[i].shininess = shininess;
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

static picture draw(const char *scene, const char *variant, int keep) {
    return draw_changed(scene, variant, keep, 0, 0);
}

/* A part of a picture, from `left` and `top` to before `right` and `bottom`. */
typedef struct region {
    int left, top, right, bottom;
} region;

/* One of `count` parts side by side. */
static region part(const picture *image, int i, int count) {
    return (region){image->width * i / count, 0, image->width * (i + 1) / count, image->height};
}

static region whole(const picture *image) {
    return part(image, 0, 1);
}

static int sum_at(const picture *image, int x, int y) {
    return picture_level(image, x, y, 0) + picture_level(image, x, y, 1) + picture_level(image, x, y, 2);
}

/* ---- What is measured -------------------------------------------------------------------------------------------- */

/* A highlight: its brightest pixel, in levels; pixels that it lights by at least half as much, their middle, and how
 * much longer they are along than across, by the roots of their variances. */
typedef struct highlight {
    int level;
    long pixels;
    double x, y, aspect;
} highlight;

static highlight measure_highlight(const picture *with, const picture *without, region in) {
    double sums[6] = {0};
    int most = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (int y = in.top; y < in.bottom; y++) {
            for (int x = in.left; x < in.right; x++) {
                const int light = sum_at(with, x, y) - sum_at(without, x, y);
                const double terms[6] = {1, x, y, x * x, x * y, y * y};
                most = pass == 0 && light > most ? light : most;
                for (int i = 0; i < 6 && pass == 1 && light > 0 && 2 * light >= most; i++)
                    sums[i] += terms[i];
            }
        }
    }
    const double x = sums[1] / sums[0], y = sums[2] / sums[0];
    const double xx = sums[3] / sums[0] - x * x, xy = sums[4] / sums[0] - x * y, yy = sums[5] / sums[0] - y * y;
    const double middle = (xx + yy) / 2, apart = hypot((xx - yy) / 2, xy);
    return (highlight){most / 3, (long)sums[0], x, y, sqrt((middle + apart) / (middle - apart))};
}

/* Highlights' light by which one part of a picture differs from the first, of the first one's. */
static double share_off(const picture *with, const picture *without, int i, int count) {
    const region first = part(with, 0, count), other = part(with, i, count);
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

/* Root mean square difference of two pictures over a region, where both show something: not of their outlines. */
static double difference(const picture *a, const picture *b, region in) {
    double sum = 0;
    long count = 0;
    for (int y = in.top; y < in.bottom; y++) {
        for (int x = in.left; x < in.right; x++) {
            if (sum_at(a, x, y) == 0 || sum_at(b, x, y) == 0)
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

/* The largest change from a pixel to its right or lower neighbour. */
static int largest_jump(const picture *image, region in) {
    int most = 0;
    for (int y = in.top; y < in.bottom; y++) {
        for (int x = in.left; x < in.right; x++) {
            const int right = abs(picture_level(image, x + 1, y, 1) - picture_level(image, x, y, 1));
            const int down = abs(picture_level(image, x, y + 1, 1) - picture_level(image, x, y, 1));
            most = right > most ? right : most;
            most = down > most ? down : most;
        }
    }
    return most;
}

static int brightest_at(const picture *image, region in, int *at_x, int *at_y) {
    int most = -1;
    for (int y = in.top; y < in.bottom; y++) {
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

static void print_brightest(const char *name, const picture *image, region in) {
    int x = 0, y = 0;
    brightest_at(image, in, &x, &y);
    print_levels(name, image, x, y);
}

/* Sizes of the highlights of objects side by side, from `first` to before `count`. */
static void print_sizes(const char *name, const char *scene, const char *variant, int first, int count) {
    picture with = draw(scene, variant, ALL), without = draw(scene, variant, WITHOUT_SPECULAR);
    for (int i = first; i < count; i++)
        printf("%s_%d,%ld\n", name, i, measure_highlight(&with, &without, part(&with, i, count)).pixels);
    picture_close(&with);
    picture_close(&without);
}

/* How much wider Blinn-Phong's highlights are than Phong's at the same exponents. */
static void print_widths(void) {
    picture with[2], without[2];
    for (int i = 0; i < 2; i++) {
        with[i] = draw("three-spheres", i ? "blinn-phong" : "phong", ALL);
        without[i] = draw("three-spheres", i ? "blinn-phong" : "phong", WITHOUT_SPECULAR);
    }
    for (int i = 1; i < 3; i++) {
        const region in = part(&with[0], i, 3);
        printf("wider_%d,%.1f\n", i,
               sqrt((double)measure_highlight(&with[1], &without[1], in).pixels /
                    (double)measure_highlight(&with[0], &without[0], in).pixels));
    }
    for (int i = 0; i < 2; i++) {
        picture_close(&with[i]);
        picture_close(&without[i]);
    }
}

static void print_twice(const char *name, const char *variant) {
    picture with = draw("surfaces", variant, ALL), without = draw("surfaces", variant, WITHOUT_SPECULAR);
    for (int i = 1; i < 4; i++)
        printf("%s_%d,%.2f\n", name, 1 << (i - 1), share_off(&with, &without, i, 4));
    for (int i = 0; i < 4; i++)
        printf("%s_aspect_%d,%.1f\n", name, i, measure_highlight(&with, &without, part(&with, i, 4)).aspect);
    const highlight phong = measure_highlight(&with, &without, part(&with, 0, 4)),
                    blinn = measure_highlight(&with, &without, part(&with, 3, 4));
    printf("%s_apart,%.1f\n", name, hypot(blinn.x - 240 - phong.x, blinn.y - phong.y));
    picture_close(&with);
    picture_close(&without);
}

/* Of 255 in a channel, and of all three. */
static void print_clamped(void) {
    picture image = draw("surfaces", "terms", ALL);
    const region in = part(&image, 3, 4);
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
    print_sizes("metal_size", "surfaces", "metal", 0, 3);
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
        print_brightest(name, &image, (region){200, 0, 320, 240});
        picture_close(&image);
    }
}

static void print_jumps(void) {
    static const region strip = {120, 60, 190, 150}, ground = {0, 100, 60, 230}, half = {90, 60, 160, 120};
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
        const region in = part(&with, i, 2);
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
        printf("teapot_%s,%.1f\n", pots[i], difference(&pot, &vertex, (region){170, 0, 320, 160}));
        picture_close(&vertex);
    }
    picture dense = draw("teapot", "vertex-dense", ALL);
    long covered = 0;
    for (int i = 0; i < dense.width * dense.height; i++)
        covered += i % dense.width >= 170 && sum_at(&dense, i % dense.width, i / dense.width) > 0;
    printf("pixels_a_triangle,%.0f\n", (double)covered / (2304.0 / 2)); /* half of them face away */
    picture_close(&dense);
    for (int i = 0; i < 2; i++) {
        picture vertex = draw("three-spheres", i ? "vertex-dense" : "vertex", ALL);
        printf("%s,%.1f\n", i ? "spheres_vertex-dense" : "spheres_vertex",
               difference(&spheres, &vertex, (region){213, 0, 320, 160}));
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
    printf("halloween_vertex,%.1f\n", difference(&night, &vertex, whole(&night)));
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
               100.0 * (double)measure_highlight(&with, &without, whole(&with)).pixels / (double)body);
        picture_close(&with);
        picture_close(&without);
    }
}

/* The squashed cylinders: brightest pixels, and where they lie on them. */
static void print_normals(void) {
    picture image = draw("phong-lighting", "scaled-normals", ALL);
    static const region sides[2] = {{20, 24, 148, 100}, {152, 24, 260, 100}};
    for (int i = 0; i < 2; i++) {
        long lit = 0, all = 0;
        for (int y = sides[i].top; y < sides[i].bottom; y++) {
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

/* The highlights of coarse cylinders, per vertex by Phong and by Blinn-Phong. */
static void print_cylinders(void) {
    static const char *const variants[] = {"cylinder-50", "cylinder-100"};
    for (int i = 0; i < 2; i++) {
        picture with = draw("shaders", variants[i], ALL), without = draw("shaders", variants[i], WITHOUT_SPECULAR);
        for (int column = 0; column < 2; column++) {
            const region in = {80 * column, 0, 80 * column + 80, 90};
            printf("%s_%d,%d\n", variants[i], column, measure_highlight(&with, &without, in).level);
        }
        picture_close(&with);
        picture_close(&without);
    }
}

/* The streaks of the torus, and the brightest pixel where vertices have colours. */
static void print_shapes(void) {
    picture with = draw("teapot", "fragment", ALL), without = draw("teapot", "fragment", WITHOUT_SPECULAR);
    picture colours = draw("phong-lighting", "vertex-colours", ALL);
    const region upper = {240, 25, 285, 65}, lower = {205, 85, 250, 120}, cylinder = {85, 15, 195, 140};
    printf("streak_upper,%.1f\nstreak_lower,%.1f\n", measure_highlight(&with, &without, upper).aspect,
           measure_highlight(&with, &without, lower).aspect);
    print_brightest("spot_vertex-colours", &colours, cylinder);
    picture_close(&with);
    picture_close(&without);
    picture_close(&colours);
}

/* What a highlight adds at its brightest, channel by channel, and what ambient light leaves in the shade. */
static void print_six_colours(void) {
    static const char *const names[3] = {"white", "yellow", "red"};
    picture with = draw("surfaces", "six-colours", ALL), without = draw("surfaces", "six-colours", WITHOUT_SPECULAR);
    for (int i = 0; i < 3; i++) {
        const region in = part(&with, i, 3);
        int at[2] = {in.left, 0}, most = -1;
        for (int y = 0; y < in.bottom; y++) {
            for (int x = in.left; x < in.right; x++) {
                const int light = sum_at(&with, x, y) - sum_at(&without, x, y);
                if (light > most) {
                    most = light;
                    at[0] = x;
                    at[1] = y;
                }
            }
        }
        printf("shine_%s,(%d %d %d)\n", names[i],
               picture_level(&with, at[0], at[1], 0) - picture_level(&without, at[0], at[1], 0),
               picture_level(&with, at[0], at[1], 1) - picture_level(&without, at[0], at[1], 1),
               picture_level(&with, at[0], at[1], 2) - picture_level(&without, at[0], at[1], 2));
    }
    print_levels("shade_white", &with, 53 + 36, 74 + 27);
    print_levels("shade_green", &with, 160 + 36, 74 + 27);
    picture_close(&with);
    picture_close(&without);
}

/* Both lights against the sum of one and the other, which hold ambient light twice. */
static void print_two_lights(void) {
    picture image = draw("surfaces", "two-lights", ALL);
    double sum = 0;
    long count = 0;
    for (int y = 74 - 30; y < 74 + 30; y++) {
        for (int x = 60 - 17; x < 60 + 17; x++) {
            for (int c = 0; c < 3; c++) {
                const int ambient = 36, one = picture_level(&image, x, y, c),
                          two = picture_level(&image, x + 100, y, c);
                const double off = picture_level(&image, x + 200, y, c) - (one + two - ambient);
                sum += off * off;
                count++;
            }
        }
    }
    print_levels("ambient_light_1", &image, 60 + 33, 74 + 6);
    print_levels("ambient_light_2", &image, 160 - 33, 74);
    printf("lights_off,%.1f\n", sqrt(sum / (double)count));
    picture_close(&image);
}

/* Pixels of a sphere that have nothing but ambient light, where that is added and where the larger counts. */
static void print_ambient_max(void) {
    picture image = draw("surfaces", "ambient-max", ALL);
    for (int i = 0; i < 2; i++) {
        const region in = part(&image, i, 2);
        const char *name = i ? "larger" : "added";
        char spot[40];
        long shade = 0;
        for (int y = 0; y < in.bottom; y++)
            for (int x = in.left; x < in.right; x++)
                shade += picture_level(&image, x, y, 0) == 63 && picture_level(&image, x, y, 1) == 43;
        printf("shade_%s,%ld\n", name, shade);
        snprintf(spot, sizeof spot, "spot_%s", name);
        print_brightest(spot, &image, in);
    }
    picture_close(&image);
}

/* Tori by normals of facets and by their means, against those by the formula. */
static void print_made_normals(void) {
    picture image = draw("surfaces", "normals", ALL);
    for (int i = 0; i < 2; i++) {
        double sum = 0;
        long count = 0;
        for (int y = 0; y < image.height; y++) {
            for (int x = 10; x < 110; x++) {
                const int here = x + 100 * i, there = x + 200;
                const int is_background = sum_at(&image, there, y) == sum_at(&image, 0, 0);
                for (int c = 0; c < 3 && !is_background; c++, count++) {
                    const double d = picture_level(&image, here, y, c) - picture_level(&image, there, y, c);
                    sum += d * d;
                }
            }
        }
        printf("%s,%.1f\n", i ? "normals_means" : "normals_facets", sqrt(sum / (double)count));
    }
    picture_close(&image);
}

/* The steps where a lamp sets and where Phong's lobe ends, over the exponent. */
static void print_steps(void) {
    static const region edge = {146, 60, 157, 150}, ground = {0, 100, 60, 230};
    for (int p = 1; p <= 16; p *= 2) { /* the ring's in sixteenths */
        picture near_lamp = draw_changed("phong-lighting", "near", ALL, 0, p * GLINT_ONE),
                ring = draw_changed("phong-lighting", "ring", ALL, 0, p * GLINT_ONE / 16);
        printf("near_step_%d,%d\nring_step_%d,%d\n", p, largest_jump(&near_lamp, edge), p, largest_jump(&ring, ground));
        picture_close(&near_lamp);
        picture_close(&ring);
    }
}

static highlight highlight_of(const char *variant, uint32_t frame, region in) {
    picture with = draw_changed("phong-lighting", variant, ALL, frame, 0),
            without = draw_changed("phong-lighting", variant, WITHOUT_SPECULAR, frame, 0);
    const highlight found = measure_highlight(&with, &without, in);
    picture_close(&with);
    picture_close(&without);
    return found;
}

/* How far the ground's highlight moves with the viewer, and over what it changes as the eye goes round. */
static void print_viewers(void) {
    static const region ground = {200, 100, 320, 240}, cylinder = {85, 15, 195, 140}, all = {0, 0, 320, 240};
    static const char *const moving[] = {"orbit", "camera-light", "dark-orbit"};
    const highlight local = highlight_of("plain", 0, ground), far = highlight_of("far-viewer", 0, ground);
    printf("quarter_adds,%d\n", highlight_of("specular-quarter", 0, cylinder).level);
    printf("viewer_moves,%.0f\n", hypot(far.x - local.x, far.y - local.y));
    for (int i = 0; i < 3; i++) {
        int least = 255, most = 0;
        double left = 320, right = 0;
        for (uint32_t frame = 0; frame < 36; frame += 3) {
            const highlight found = highlight_of(moving[i], frame, all);
            least = found.level < least ? found.level : least;
            most = found.level > most ? found.level : most;
            left = found.x < left ? found.x : left;
            right = found.x > right ? found.x : right;
        }
        printf("%s_least,%d\n%s_most,%d\n%s_moves,%.0f\n", moving[i], least, moving[i], most, moving[i], right - left);
    }
}

/* Pixels by which Phong and Blinn-Phong differ, with and without their specular light. */
static void print_models(void) {
    for (int keep = ALL; keep <= WITHOUT_SPECULAR; keep++) {
        picture phong = draw("three-spheres", "phong", keep), blinn = draw("three-spheres", "blinn-phong", keep);
        int most = 0;
        for (int i = 0; i < 3 * phong.width * phong.height; i++) {
            const int x = i / 3 % phong.width, y = i / 3 / phong.width;
            const int off = abs(picture_level(&phong, x, y, i % 3) - picture_level(&blinn, x, y, i % 3));
            most = off > most ? off : most;
        }
        printf("%s,%d\n", keep == ALL ? "models_apart" : "models_apart_unshiny", most);
        picture_close(&phong);
        picture_close(&blinn);
    }
}

int main(void) {
    puts("name,value");
    print_sizes("exponents", "surfaces", "exponents", 0, 5);
    print_sizes("spheres", "three-spheres", "phong", 1, 3);
    print_sizes("blinn_spheres", "three-spheres", "blinn-phong", 1, 3);
    print_widths();
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
    print_cylinders();
    print_shapes();
    print_six_colours();
    print_two_lights();
    print_ambient_max();
    print_made_normals();
    print_steps();
    print_viewers();
    print_models();
    return ferror(stdout) || fflush(stdout);
}
