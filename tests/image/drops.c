/* SPDX-License-Identifier: MIT */
/*
 * Suite: what cannot show is dropped, and dropping keeps every bit: each scene is drawn again by twins that drop
 * nothing. Each drop is seen to have happened.
 */
#include "glint.h"
#include "harness.h"
#include "picture.h"
#include "scenes.h"
#include "scenes/scenes.h"
#include "stability/random_scene.h"
#include "undropped.h"

#include <stdio.h>
#include <string.h>

/* What all scenes together took. */
static glint_stats total;
static uint32_t scenes, different;

static void add(const glint_stats *stats) {
    total.facing_away += stats->facing_away;
    total.outside += stats->outside;
    total.hidden += stats->hidden;
    for (int kernel = 0; kernel < GLINT_KERNELS; kernel++) {
        total.drawn[kernel].parts += stats->drawn[kernel].parts;
        total.drawn[kernel].covered += stats->drawn[kernel].covered;
    }
}

/* Twins have models of their own, which have no nodes: what is lit there is drawn per fragment. */
static void light_at_fragments(glint_scene *scene, glint_object objects[UNDROPPED_OBJECTS_MAX]) {
    for (uint32_t i = 0; i < scene->object_count && CHECK(i < UNDROPPED_OBJECTS_MAX); i++) {
        objects[i] = scene->objects[i];
        if (objects[i].evaluation == &glint_per_node)
            objects[i].evaluation = &glint_per_fragment;
    }
    scene->objects = objects;
}

/* Draws a scene and its twin. */
static void check_same(const glint_scene *as_said, int width, int height, const glint_format *format,
                       const char *name) {
    static undropped_scene twin;
    static glint_object objects[UNDROPPED_OBJECTS_MAX];
    glint_scene plain = *as_said;
    const glint_scene *const scene = &plain;
    light_at_fragments(&plain, objects);
    glint_stats stats = {0};
    picture dropped = picture_open(width, height, format);
    picture whole = picture_open(width, height, undropped_format(format));
    CHECK(undropped_make(&twin, scene));
    CHECK_EQUAL(picture_render(&dropped, scene, NULL, &stats), GLINT_OK);
    CHECK_EQUAL(picture_render(&whole, &twin.scene, NULL, NULL), GLINT_OK);
    add(&stats);
    scenes++;
    if (!CHECK(picture_equal(&dropped, &whole)) && different++ < 10) {
        char line[160];
        snprintf(line, sizeof line, "  %s, %dx%d, %s\n", name, width, height,
                 format == &glint_format_rgb565 ? "rgb565" : "another format");
        test_write(line);
    }
    picture_close(&dropped);
    picture_close(&whole);
}

static void in_both_formats(const glint_scene *scene, int width, int height, const char *name) {
    check_same(scene, width, height, &glint_format_rgb565, name);
    check_same(scene, width, height, &glint_format_rgb888, name);
}

static void bench_scenes(void) {
    static const glint_q16 exponents[] = {0, GLINT_ONE, 2 * GLINT_ONE, 32 * GLINT_ONE, 1024 * GLINT_ONE};
    for (int which = 0; which < BENCH_SCENES; which++) {
        for (unsigned i = 0; i < TEST_COUNT(exponents); i++) {
            bench_scene scene;
            bench_build_scene(&scene, &bench_definitions[which], scene_bench_mesh(which), (int)i * 2);
            scene.material.shininess = exponents[i];
            for (int viewer = GLINT_VIEWER_INFINITE; viewer <= GLINT_VIEWER_LOCAL; viewer++) {
                scene.scene.viewer = (glint_viewer)viewer;
                in_both_formats(&scene.scene, 320, 240, bench_definitions[which].name);
            }
            scene.material.specular = (glint_colour){0, 0, 0};
            in_both_formats(&scene.scene, 128, 64, bench_definitions[which].name);
        }
    }
}

static void gallery(void) {
    static example_stage stage;
    for (unsigned i = 0; i < EXAMPLE_SCENES; i++) {
        const example_scene *scene = example_scenes[i];
        for (uint32_t variant = 0; variant < scene->variant_count; variant++) {
            scene->build(&stage, variant, scene->frames / 2);
            in_both_formats(&stage.scene, scene->width, scene->height, scene->name);
        }
    }
}

static void chosen_scenes(void) {
    for (unsigned i = 0; i < scene_count; i++) {
        test_scene scene;
        scene_build(&scene, &scene_definitions[i]);
        in_both_formats(&scene.scene, 150, 101, scene_definitions[i].name);
    }
}

/* Of few objects under one light, as RGB565 has kernels for; and of every region where methods fail. */
static void random_scenes(void) {
    static random_scene scene;
    char name[40];
    for (uint32_t seed = 1; seed <= 150; seed++) {
        test_scene one;
        scene_build_random(&one, seed);
        one.scene.light_count = one.scene.light_count > 1 && seed % 8 ? 1 : one.scene.light_count;
        snprintf(name, sizeof name, "random scene %u", (unsigned)seed);
        in_both_formats(&one.scene, 160, 120, name);
    }
    for (uint32_t seed = 1; seed <= 1500; seed++) {
        random_scene_make(&scene, seed);
        snprintf(name, sizeof name, "scene %u, %s", (unsigned)seed, random_regions[scene.region].name);
        in_both_formats(&scene.scene, scene.width, scene.height, name);
    }
}

/* ---- Lights that do not show --------------------------------------------------------------------------------- */

static const glint_format *const formats[] = {&glint_format_rgb565, &glint_format_rgb565_be, &glint_format_rgb888};

static const glint_colour black = {0, 0, 0}, blue = {0, 0, GLINT_ONE};

/* Nothing answers to blue. */
static void build_torus(bench_scene *scene, glint_viewer viewer, int32_t error_budget) {
    bench_build_scene(scene, &bench_definitions[0], scene_bench_mesh(0), 3);
    scene->material.diffuse.b = scene->material.specular.b = 0;
    scene->scene.viewer = viewer;
    scene->scene.error_budget = error_budget;
}

/* Lights of which none shows, a lamp among them. */
static void fill_dark(glint_light lights[GLINT_LIGHTS_MAX], const glint_light *like) {
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++) {
        lights[i] = *like;
        lights[i].vector.x += i * GLINT_ONE;
        lights[i].diffuse = i % 2 ? blue : black;
        lights[i].specular = i % 3 ? blue : black;
    }
    lights[GLINT_LIGHTS_MAX / 2].type = &glint_light_point;
}

/* Draws two scenes: the same bits, by the same kernels, the general one among them or not. */
static void check_alike(const glint_scene *one, const glint_scene *other, const glint_format *format, int is_general) {
    glint_stats stats[2] = {{0}};
    picture a = picture_open(128, 96, format), b = picture_open(128, 96, format);
    CHECK_EQUAL(picture_render(&a, one, NULL, &stats[0]), GLINT_OK);
    CHECK_EQUAL(picture_render(&b, other, NULL, &stats[1]), GLINT_OK);
    CHECK(picture_equal(&a, &b));
    for (int kernel = 0; kernel < GLINT_KERNELS; kernel++) {
        CHECK_EQUAL(stats[1].drawn[kernel].parts, stats[0].drawn[kernel].parts);
        CHECK_EQUAL(stats[1].drawn[kernel].covered, stats[0].drawn[kernel].covered);
    }
    CHECK_EQUAL(stats[0].drawn[GLINT_KERNEL_GENERAL].covered != 0, is_general);
    picture_close(&a);
    picture_close(&b);
}

static void lights_that_do_not_show_cost_nothing(void) {
    for (unsigned i = 0; i < 4 * TEST_COUNT(formats); i++) {
        const glint_format *format = formats[i / 4];
        bench_scene scene;
        glint_light lights[GLINT_LIGHTS_MAX];
        build_torus(&scene, (glint_viewer)(i & 1), i & 2);
        const glint_light sun = scene.scene.lights[0];
        glint_scene more = scene.scene;
        more.lights = lights;
        for (more.light_count = 1; more.light_count <= GLINT_LIGHTS_MAX; more.light_count++) {
            for (uint32_t place = 0; place < more.light_count; place++) {
                fill_dark(lights, &sun);
                lights[place] = sun;
                check_alike(&scene.scene, &more, format, format == &glint_format_rgb888);
            }
        }
    }
}

static void no_light_is_as_good_as_dark_ones(void) {
    for (unsigned i = 0; i < 4 * TEST_COUNT(formats); i++) {
        bench_scene scene;
        glint_light lights[GLINT_LIGHTS_MAX];
        build_torus(&scene, (glint_viewer)(i & 1), i & 2);
        fill_dark(lights, &scene.scene.lights[0]);
        glint_scene dark = scene.scene;
        dark.lights = lights;
        scene.scene.light_count = 0;
        for (dark.light_count = 1; dark.light_count <= GLINT_LIGHTS_MAX; dark.light_count++)
            check_alike(&scene.scene, &dark, formats[i / 4], 0);
    }
}

/* Draws a scene, and adds its words to `sum`. */
static void add_words(const glint_scene *scene, uint16_t *sum, glint_stats *stats) {
    picture image = picture_open(128, 96, &glint_format_rgb565);
    CHECK_EQUAL(picture_render(&image, scene, NULL, stats), GLINT_OK);
    for (size_t i = 0; i < image.size / 2; i++)
        sum[i] = (uint16_t)(sum[i] + ((const uint16_t *)(const void *)image.bytes)[i]);
    picture_close(&image);
}

/* Two tori side by side, one for each of two lights: together they show what they show under one light after the other.
 */
static void each_material_has_a_light_of_its_own(void) {
    static uint16_t wanted[128 * 96], got[128 * 96];
    glint_stats stats = {0};
    test_scene s;
    scene_build_named(&s, "mirrored");
    s.scene.object_count = s.scene.light_count = 2;
    s.objects[1] = s.objects[0];
    s.objects[1].material = &s.materials[1];
    s.objects[0].pose.m[0][3] -= 2 * GLINT_ONE;
    s.objects[1].pose.m[0][3] += 2 * GLINT_ONE;
    s.lights[1] = s.lights[0];
    s.lights[1].vector.x = -s.lights[0].vector.x;
    s.scene.background = s.scene.ambient = black;
    for (int i = 0; i < 2; i++) {
        const glint_colour only = {i ? 0 : GLINT_ONE, i ? GLINT_ONE : 0, 0};
        s.materials[i].diffuse = s.materials[i].specular = s.lights[i].diffuse = s.lights[i].specular = only;
    }
    add_words(&s.scene, got, &stats);
    CHECK_AT_MOST(30 * stats.drawn[GLINT_KERNEL_GENERAL].parts, stats.drawn[GLINT_KERNEL_CURVED_SPECULAR].parts);
    for (int i = 0; i < 2; i++) {
        const glint_colour only = s.lights[i].diffuse;
        s.lights[i].diffuse = s.lights[i].specular = black;
        add_words(&s.scene, wanted, NULL);
        s.lights[i].diffuse = s.lights[i].specular = only;
    }
    CHECK(memcmp(got, wanted, sizeof got) == 0);
    uint16_t all = 0;
    for (unsigned i = 0; i < TEST_COUNT(got); i++)
        all |= got[i];
    CHECK_EQUAL(all, 0xffe0); /* both shine to the full */
}

static void every_drop_happened(void) {
    char line[160];
    snprintf(line, sizeof line, "  %u scenes; fragments: %u facing away, %u out of reach, %u without highlight;\n",
             (unsigned)scenes, (unsigned)undropped.facing_away, (unsigned)undropped.out_of_reach,
             (unsigned)undropped.no_highlight);
    test_write(line);
    snprintf(line, sizeof line, "  materials without specular light: %u; parts: %u ambient, %u without highlight\n",
             (unsigned)undropped.no_specular, (unsigned)undropped.parts_ambient, (unsigned)undropped.parts_matt);
    test_write(line);
    snprintf(line, sizeof line, "  interpolated parts without highlight: %u; squares: %u\n",
             (unsigned)undropped.parts_interpolated, (unsigned)undropped.squares_matt);
    test_write(line);
    CHECK(undropped.parts_interpolated > 0);
    CHECK(undropped.squares_matt > 0);
    CHECK(undropped.facing_away > 0);
    CHECK(undropped.out_of_reach > 0);
    CHECK(undropped.no_highlight > 0);
    CHECK(undropped.no_specular > 0);
    CHECK(undropped.parts_ambient > 0);
    CHECK(undropped.parts_matt > 0);
    CHECK(total.facing_away > 0);
    CHECK(total.outside > 0);
    CHECK(total.hidden > 0);
    for (int kernel = 0; kernel < GLINT_KERNELS; kernel++) {
        CHECK(total.drawn[kernel].parts > 0);
        CHECK(total.drawn[kernel].covered > 0);
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(bench_scenes),
                                      TEST_CASE(gallery),
                                      TEST_CASE(chosen_scenes),
                                      TEST_CASE(random_scenes),
                                      TEST_CASE(lights_that_do_not_show_cost_nothing),
                                      TEST_CASE(no_light_is_as_good_as_dark_ones),
                                      TEST_CASE(each_material_has_a_light_of_its_own),
                                      TEST_CASE(every_drop_happened)};
    return test_run(write, cases, TEST_COUNT(cases));
}
