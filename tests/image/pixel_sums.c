/* SPDX-License-Identifier: MIT */
#include "pixel_sums.h"

#include "bench.h"
#include "glint.h"
#include "picture.h"
#include "scenes.h"
#include "scenes/scenes.h"
#include "stability/random_scene.h"
#include "surfaces.h"

/* FNV-1a (Fowler, Noll and Vo). */
static void add(uint32_t *sum, const void *bytes, size_t size) {
    for (size_t i = 0; i < size; i++)
        *sum = (*sum ^ ((const uint8_t *)bytes)[i]) * 16777619u;
}

/* What is drawn, and how. */
typedef struct drawing {
    int width, height;
    const glint_format *format;
    uint32_t *sum;
    int failed;
} drawing;

static void draw_with(drawing *d, const glint_scene *scene, const picture_options *options) {
    picture image = picture_open(d->width, d->height, d->format);
    d->failed |= picture_render(&image, scene, options, NULL) != GLINT_OK;
    add(d->sum, image.bytes, image.size);
    picture_close(&image);
}

static void draw(drawing *d, const glint_scene *scene) {
    draw_with(d, scene, NULL);
}

/* ---- Kinds --------------------------------------------------------------------------------------------------- */

static void evaluate(glint_object *objects, uint32_t count, unsigned evaluation) {
    for (uint32_t i = 0; i < count; i++)
        objects[i].evaluation = scene_evaluations[evaluation];
}

/* Meshes, lights and materials of all kinds, near and beside each other. */
static void draw_random_surfaces(drawing *d, unsigned part) {
    for (uint32_t seed = 60 * part + 1; seed <= 60 * (part + 1); seed++) {
        test_scene scene;
        surface_build_random(&scene, seed);
        const uint32_t number = seed - 60 * part;
        d->width = number % 2 ? 157 : 128;
        d->height = number % 2 ? 93 : 64;
        d->format = number % 3 == 2 ? &glint_format_rgb888 : &glint_format_rgb565;
        draw(d, &scene.scene);
    }
}

/* As many of each region as of any other. */
static void draw_regions(drawing *d, unsigned part) {
    static random_scene scene;
    for (uint32_t i = 0; i < 20 * random_region_count; i++) {
        random_scene_make_in(&scene, i % random_region_count, 10000u * part + i);
        d->width = scene.width;
        d->height = scene.height;
        d->format = scene.format;
        draw(d, &scene.scene);
    }
}

/* The same on a screen on which triangles are large. */
static void draw_large_regions(drawing *d, unsigned part) {
    static random_scene scene;
    for (uint32_t i = 0; i < 20 * random_region_count; i++) {
        random_scene_make_in(&scene, i % random_region_count, 10000u * (10 + part) + i);
        d->width = 320;
        d->height = 240;
        d->format = &glint_format_rgb565;
        draw(d, &scene.scene);
    }
}

static const glint_format *const formats[16] = {&glint_format_rgb565,
                                                &glint_format_rgb565_dithered,
                                                &glint_format_rgb565_be,
                                                &glint_format_rgb888,
                                                &glint_format_rgb565_be_dithered,
                                                &glint_format_rgb888_dithered,
                                                &glint_format_grey8,
                                                &glint_format_grey8_dithered,
                                                &glint_format_grey4,
                                                &glint_format_rgb444,
                                                &glint_format_grey4_dithered,
                                                &glint_format_rgb444_dithered,
                                                &glint_format_mono,
                                                &glint_format_mono_dithered,
                                                &glint_format_mono_pages,
                                                &glint_format_mono_pages_dithered};

/* A number below `count`, of what is left of a larger one. */
static uint32_t take(uint32_t *left, uint32_t count) {
    const uint32_t taken = *left % count;
    *left /= count;
    return taken;
}

/* Knuth's multiplicative hash, to take numbers from. */
static uint32_t hash_of(uint32_t number) {
    return number * 2654435761u >> 4;
}

static void set_screen(drawing *d, uint32_t screen, uint32_t format) {
    static const int screens[4][2] = {{320, 240}, {128, 64}, {200, 152}, {72, 200}};
    d->width = screens[screen][0];
    d->height = screens[screen][1];
    d->format = formats[format < 16 ? format : 0];
}

/* Changes what a random scene leaves as it is most often, and with which memory it is drawn. */
static void vary(drawing *d, random_scene *scene, picture_options *options, uint32_t number) {
    uint32_t left = hash_of(number);
    const uint32_t screen = take(&left, 4), format = take(&left, 32), other = take(&left, 4), lit = take(&left, 4);
    const uint32_t value = take(&left, 36), arena = take(&left, 3), has_tile = take(&left, 2);
    set_screen(d, screen, format);
    if (other == 1)
        options->gamma = glint_gamma_srgb;
    if (lit == 0)
        for (unsigned i = 0; i < RANDOM_OBJECTS_MAX; i++)
            scene->materials[i].flags =
                GLINT_MATERIAL_MAX_WITH_AMBIENT | (value % 2 ? GLINT_MATERIAL_SPECULAR_UNGATED : 0);
    else if (lit == 1)
        evaluate(scene->objects, scene->scene.object_count, value % 3);
    else if (lit == 2)
        scene->scene.light_count = 1;
    if (has_tile) {
        options->tile_width = scene->tile_width;
        options->tile_height = scene->tile_height;
    }
    picture image = {.width = d->width, .height = d->height, .format = d->format};
    const glint_config config = picture_config(&image, options);
    glint_need need = {0};
    d->failed |= glint_arena_need(&config, &scene->scene, &need) != GLINT_OK;
    options->arena_size = arena == 0 ? need.least : arena == 1 ? (need.least + need.resident) / 2 : 0;
}

/* Regions with formats, screens, tiles, tables and the small arenas of a host of 64 bits. */
static void draw_varied_regions(drawing *d, unsigned part) {
    static random_scene scene;
    for (uint32_t i = 0; i < 20 * random_region_count; i++) {
        const uint32_t number = 10000u * (20 + part) + i;
        picture_options options = {0};
        random_scene_make_in(&scene, i % random_region_count, number);
        vary(d, &scene, &options, number);
        draw_with(d, &scene.scene, &options);
    }
}

/* Eighths, of 0 to 15. */
static glint_colour take_colour(uint32_t *left) {
    const uint32_t r = take(left, 16), g = take(left, 16), b = take(left, 16);
    return (glint_colour){(int32_t)r << 13, (int32_t)g << 13, (int32_t)b << 13};
}

/* A mesh of the benchmark with any light, weights, exponent. */
static void draw_varied_bench(drawing *d, unsigned part) {
    static const uint8_t exponents[] = {0, 1, 2, 3, 5, 8, 16, 32, 64, 100, 200, 255};
    for (uint32_t i = 0; i < 60; i++) {
        const uint32_t number = 1000 * part + i, which = number % 3 == 2 ? 3 : number % 3;
        bench_scene scene;
        bench_build_scene(&scene, &bench_definitions[which], scene_clustered_mesh((int)which), (int)i % 10);
        uint32_t left = hash_of(number + 100000);
        const uint32_t screen = take(&left, 4), format = take(&left, 3), exponent = take(&left, sizeof exponents),
                       is_high = take(&left, 4) == 0;
        set_screen(d, screen, format ? 0 : 2);
        scene.scene.viewer = take(&left, 2) ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
        scene.material.shininess = exponents[exponent] * (is_high ? 20 : 1) * GLINT_ONE;
        scene.material.flags = take(&left, 4) ? 0 : take(&left, 4);
        scene.object.evaluation = scene_evaluations[take(&left, 8) ? 0 : take(&left, 3)];
        scene.object.pose.m[2][3] += (int32_t)take(&left, 3) * GLINT_ONE / 2;
        left = hash_of(number + 200000);
        scene.material.ambient = take_colour(&left);
        scene.material.diffuse = take_colour(&left);
        left = hash_of(number + 300000);
        scene.material.specular = take_colour(&left);
        scene.light.direction.x = (8 - (int32_t)take(&left, 17)) * 8192;
        scene.light.direction.y = (8 - (int32_t)take(&left, 17)) * 8192;
        draw(d, &scene.scene);
    }
}

static void draw_gallery(drawing *d, unsigned which) {
    static example_stage stage;
    const example_scene *scene = example_scenes[which];
    for (uint32_t variant = 0; variant < scene->variant_count; variant++) {
        scene->build(&stage, variant, scene->frames / 3);
        d->width = scene->width;
        d->height = scene->height;
        d->format = &glint_format_rgb565;
        draw_with(d, &stage.scene, &(picture_options){.layers = stage.layers, .samples = stage.samples});
    }
}

typedef struct kind {
    const char *name;
    void (*draw)(drawing *d, unsigned part);
    unsigned parts;
} kind;

/* What is most varied comes first. */
static const kind kinds[] = {{"regions", draw_regions, 2},
                             {"large regions", draw_large_regions, 3},
                             {"varied regions", draw_varied_regions, 8},
                             {"varied benchmark", draw_varied_bench, 6},
                             {"random surfaces", draw_random_surfaces, 6},
                             {"gallery", draw_gallery, EXAMPLE_SCENES}};

const unsigned pixel_sums_count = 2 + 3 + 8 + 6 + 6 + EXAMPLE_SCENES;

static const kind *kind_of(unsigned *index) {
    const kind *at = kinds;
    while (*index >= at->parts)
        *index -= at++->parts;
    return at;
}

const char *pixel_sums_name(unsigned index) {
    return kind_of(&index)->name;
}

int pixel_sums_draw(unsigned index, uint32_t *sum) {
    drawing d = {.sum = sum};
    *sum = 2166136261u;
    kind_of(&index)->draw(&d, index);
    return !d.failed;
}
