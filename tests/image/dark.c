/* SPDX-License-Identifier: MIT */
/*
 * Suite: light that does not show changes no bit. Lights whose colours are 0, or that a material does not answer to,
 * leave the picture as it is without them, wherever they stand in the list; so do flags without an effect, and
 * directional lights from straight behind, and nearly, under which no normal may be lit that faces away.
 */
#include "bench.h"
#include "glint.h"
#include "harness.h"
#include "picture.h"
#include "scenes.h"
#include "scenes/scenes.h"
#include "stability/random_scene.h"

#include <string.h>

static const glint_format *const formats[] = {&glint_format_rgb565, &glint_format_rgb565_be, &glint_format_rgb888};

static const glint_colour black = {0, 0, 0}, blue = {0, 0, GLINT_ONE};

/* Draws two scenes. @return whether they show the same bits */
static int is_alike(const glint_scene *one, const glint_scene *other, const glint_format *format) {
    picture a = picture_open(128, 96, format), b = picture_open(128, 96, format);
    CHECK_EQUAL(picture_render(&a, one, NULL, NULL), GLINT_OK);
    CHECK_EQUAL(picture_render(&b, other, NULL, NULL), GLINT_OK);
    const int is_same = picture_equal(&a, &b);
    picture_close(&a);
    picture_close(&b);
    return is_same;
}

/* ---- Lights ---- */

/* A torus of which nothing answers to blue. */
static void build_torus(bench_scene *scene, glint_viewer viewer, const glint_evaluation *evaluation) {
    bench_build_scene(scene, &bench_definitions[0], scene_bench_mesh(0), 3);
    scene->material.diffuse.b = scene->material.specular.b = 0;
    scene->object.evaluation = evaluation;
    scene->scene.viewer = viewer;
}

/* Lights of which none shows, a point and a spot among them. */
static void fill_dark(glint_light lights[GLINT_LIGHTS_MAX], const glint_light *like) {
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++) {
        lights[i] = *like;
        lights[i].direction.x -= i * GLINT_ONE;
        lights[i].position = (glint_vector){-lights[i].direction.x, -lights[i].direction.y, -lights[i].direction.z};
        lights[i].diffuse = i % 2 ? blue : black;
        lights[i].specular = i % 3 ? blue : black;
    }
    lights[GLINT_LIGHTS_MAX / 2].type = &glint_light_point;
    lights[GLINT_LIGHTS_MAX / 3].type = &glint_light_spot;
    lights[GLINT_LIGHTS_MAX / 3].direction = (glint_vector){0, 0, -GLINT_ONE};
    lights[GLINT_LIGHTS_MAX / 3].outer = 40 * GLINT_ONE;
}

static void with_each_place(const glint_format *format, glint_viewer viewer, const glint_evaluation *evaluation) {
    bench_scene scene;
    glint_light lights[GLINT_LIGHTS_MAX];
    build_torus(&scene, viewer, evaluation);
    const glint_light sun = scene.scene.lights[0];
    glint_scene more = scene.scene;
    more.lights = lights;
    for (more.light_count = 1; more.light_count <= GLINT_LIGHTS_MAX; more.light_count++) {
        for (uint32_t place = 0; place < more.light_count; place++) {
            fill_dark(lights, &sun);
            lights[place] = sun;
            CHECK(is_alike(&scene.scene, &more, format));
        }
    }
}

static void dark_lights_change_nothing(void) {
    for (unsigned i = 0; i < 2 * TEST_COUNT(formats); i++) {
        with_each_place(formats[i / 2], (glint_viewer)(i % 2), &glint_per_fragment);
        with_each_place(formats[i / 2], (glint_viewer)(i % 2), i % 2 ? &glint_per_vertex : &glint_per_facet);
    }
}

static void no_light_is_as_good_as_dark_ones(void) {
    for (unsigned i = 0; i < 2 * TEST_COUNT(formats); i++) {
        bench_scene scene;
        glint_light lights[GLINT_LIGHTS_MAX];
        build_torus(&scene, (glint_viewer)(i % 2), &glint_per_fragment);
        fill_dark(lights, &scene.scene.lights[0]);
        glint_scene dark = scene.scene;
        dark.lights = lights;
        scene.scene.light_count = 0;
        for (dark.light_count = 1; dark.light_count <= GLINT_LIGHTS_MAX; dark.light_count++)
            CHECK(is_alike(&scene.scene, &dark, formats[i / 2]));
    }
}

/* Scenes of all kinds, to which a light of colour 0 is added. */
static void random_scenes_with_dark_lights(void) {
    static random_scene s;
    unsigned compared = 0;
    for (uint32_t seed = 1; seed <= 400; seed++) {
        glint_light lights[GLINT_LIGHTS_MAX];
        random_scene_make(&s, seed);
        if (s.scene.light_count == GLINT_LIGHTS_MAX)
            continue;
        const uint32_t place = seed % (s.scene.light_count + 1);
        memcpy(lights, s.lights, place * sizeof *lights);
        lights[place] = s.lights[0];
        lights[place].diffuse = lights[place].specular = black;
        memcpy(lights + place + 1, s.lights + place, (s.scene.light_count - place) * sizeof *lights);
        glint_scene more = s.scene;
        more.lights = lights;
        more.light_count++;
        CHECK(is_alike(&s.scene, &more, s.format));
        compared++;
    }
    CHECK(compared > 300);
}

/* ---- Materials ---- */

/* Draws a scene, and adds its words to `sum`. */
static void add_words(const glint_scene *scene, uint16_t *sum) {
    picture image = picture_open(128, 96, &glint_format_rgb565);
    CHECK_EQUAL(picture_render(&image, scene, NULL, NULL), GLINT_OK);
    for (size_t i = 0; i < image.size / 2; i++)
        sum[i] = (uint16_t)(sum[i] + ((const uint16_t *)(const void *)image.bytes)[i]);
    picture_close(&image);
}

/* Two tori side by side, one for each of two lights: together they show what they show under one light after the other.
 */
static void each_material_has_a_light_of_its_own(void) {
    static uint16_t wanted[128 * 96], got[128 * 96];
    test_scene s;
    scene_build_named(&s, "mirrored");
    s.scene.object_count = s.scene.light_count = 2;
    s.objects[1] = s.objects[0];
    s.objects[1].material = &s.materials[1];
    s.objects[0].pose.m[0][3] -= 2 * GLINT_ONE;
    s.objects[1].pose.m[0][3] += 2 * GLINT_ONE;
    s.lights[1] = s.lights[0];
    s.lights[1].direction.x = -s.lights[0].direction.x;
    s.scene.background = s.scene.ambient = black;
    for (int i = 0; i < 2; i++) {
        const glint_colour only = {i ? 0 : GLINT_ONE, i ? GLINT_ONE : 0, 0};
        s.materials[i].diffuse = s.materials[i].specular = s.lights[i].diffuse = s.lights[i].specular = only;
    }
    add_words(&s.scene, got);
    for (int i = 0; i < 2; i++) {
        const glint_colour only = s.lights[i].diffuse;
        s.lights[i].diffuse = s.lights[i].specular = black;
        add_words(&s.scene, wanted);
        s.lights[i].diffuse = s.lights[i].specular = only;
    }
    CHECK(memcmp(got, wanted, sizeof got) == 0);
    uint16_t all = 0;
    for (unsigned i = 0; i < TEST_COUNT(got); i++)
        all |= got[i];
    CHECK_EQUAL(all, 0xffe0); /* both shine to the full */
}

/* With one light, or none, the largest of the lights' shares is their sum; a highlight of weight 0 is none. */
static void flags_without_an_effect(void) {
    for (unsigned i = 0; i < 6 * TEST_COUNT(formats); i++) {
        bench_scene one, other;
        bench_build_scene(&one, &bench_definitions[1], scene_bench_mesh(1), 3);
        bench_build_scene(&other, &bench_definitions[1], scene_bench_mesh(1), 3);
        one.scene.viewer = other.scene.viewer = (glint_viewer)(i % 2);
        if (i / 2 % 3 == 0) {
            one.scene.light_count = other.scene.light_count = 0;
            other.material.flags = GLINT_MATERIAL_MAX_WITH_AMBIENT | GLINT_MATERIAL_SPECULAR_UNGATED;
        } else if (i / 2 % 3 == 1) {
            one.material.specular = other.material.specular = black;
            other.material.flags = GLINT_MATERIAL_SPECULAR_UNGATED;
            other.material.shininess = 5 * GLINT_ONE;
        } else {
            one.material.specular = other.material.specular = black;
            other.material.model = &glint_model_lambert;
        }
        CHECK(is_alike(&one.scene, &other.scene, formats[i / 6]));
    }
}

/* ---- Lights straight from behind, and nearly: what rounding makes of L + V must not light normals that face away ----
 */

#define SIZE 8

/* Each z of 15 bits: glint_unit brings any other to one of these. */
#define LEAST_Z (1 << 14)
#define MOST_Z (1 << 15)

typedef struct stage {
    glint_mesh mesh;
    glint_material material;
    glint_light light;
    glint_object object;
    glint_scene scene;
    picture shown, expected;
} stage;

/* A square that fills the screen, its normals towards the light, away from the eye: there no highlight is to be seen.
 */
static void open_stage(stage *s, const glint_format *format, glint_viewer viewer) {
    static const int16_t away[4][3] = {{0, 0, -32767}, {0, 0, -32767}, {0, 0, -32767}, {0, 0, -32767}};
    const glint_colour white = {GLINT_ONE, GLINT_ONE, GLINT_ONE};
    memset(s, 0, sizeof *s);
    s->mesh = scene_square_mesh(GLINT_ONE, GLINT_ONE);
    s->mesh.normals = away;
    s->material = (glint_material){.model = &glint_model_blinn_phong,
                                   .ambient = {GLINT_ONE / 5, 0, 0},
                                   .specular = white,
                                   .shininess = 32 * GLINT_ONE};
    s->light = (glint_light){.type = &glint_light_directional, .diffuse = white, .specular = white};
    s->object = (glint_object){&s->mesh, &s->material, glint_pose_translate(0, 0, -5 * GLINT_ONE), &glint_per_fragment};
    s->scene = (glint_scene){.camera = {glint_pose_identity(), 10 * GLINT_ONE, GLINT_ONE},
                             .viewer = viewer,
                             .ambient = white,
                             .lights = &s->light,
                             .objects = &s->object,
                             .object_count = 1};
    s->shown = picture_open(SIZE, SIZE, format);
    s->expected = picture_open(SIZE, SIZE, format);
    CHECK_EQUAL(picture_render(&s->expected, &s->scene, NULL, NULL), GLINT_OK);
    s->scene.light_count = 1;
}

static void close_stage(stage *s) {
    picture_close(&s->shown);
    picture_close(&s->expected);
}

static int is_unlit(stage *s, int32_t x, int32_t y, int32_t z) {
    s->light.direction = (glint_vector){-x, -y, -z};
    return picture_render(&s->shown, &s->scene, NULL, NULL) == GLINT_OK && picture_equal(&s->shown, &s->expected);
}

/* Under one directional light, and under others. */
static void for_both_formats(glint_viewer viewer, long (*count_lit)(stage *s)) {
    static const glint_format *const both[2] = {&glint_format_rgb565, &glint_format_rgb888};
    for (int i = 0; i < 2; i++) {
        stage s;
        open_stage(&s, both[i], viewer);
        CHECK_EQUAL(count_lit(&s), 0);
        close_stage(&s);
    }
}

static long count_lit_from_behind(stage *s) {
    long lit = 0;
    for (int32_t z = LEAST_Z; z < MOST_Z; z++)
        lit += !is_unlit(s, 0, 0, -z);
    return lit;
}

static long count_lit_from_nearly_behind(stage *s) {
    long lit = 0;
    for (int32_t z = LEAST_Z; z < MOST_Z; z += 99)
        for (int32_t x = -4; x <= 4; x += 2)
            for (int32_t y = -4; y <= 4; y++)
                lit += !is_unlit(s, x * x * x, y, -z);
    return lit;
}

static void straight_from_behind(void) {
    for_both_formats(GLINT_VIEWER_INFINITE, count_lit_from_behind);
}

static void nearly_from_behind(void) {
    for_both_formats(GLINT_VIEWER_INFINITE, count_lit_from_nearly_behind);
}

static void local_viewer(void) {
    for_both_formats(GLINT_VIEWER_LOCAL, count_lit_from_nearly_behind);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(dark_lights_change_nothing),
        TEST_CASE(no_light_is_as_good_as_dark_ones),
        TEST_CASE(random_scenes_with_dark_lights),
        TEST_CASE(each_material_has_a_light_of_its_own),
        TEST_CASE(flags_without_an_effect),
        TEST_CASE(straight_from_behind),
        TEST_CASE(nearly_from_behind),
        TEST_CASE(local_viewer),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
