/* SPDX-License-Identifier: MIT */
/*
 * Suite: directional lights straight from behind, and nearly. What rounding makes of L + V must be no half vector that
 * points away from the eye: that would be read beside a table, and light normals that face away.
 */
#include "glint.h"
#include "harness.h"
#include "picture.h"

#include <string.h>

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
static void open(stage *s, const glint_format *format, glint_viewer viewer) {
    static const int16_t corners[4][3] = {
        {-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}};
    static const int16_t normals[4][3] = {{0, 0, -32767}, {0, 0, -32767}, {0, 0, -32767}, {0, 0, -32767}};
    static const uint16_t triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
    const glint_colour white = {GLINT_ONE, GLINT_ONE, GLINT_ONE};
    memset(s, 0, sizeof *s);
    s->mesh = (glint_mesh){.positions = corners,
                           .normals = normals,
                           .triangles = triangles,
                           .vertex_count = 4,
                           .triangle_count = 2,
                           .extent = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
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

static void close(stage *s) {
    picture_close(&s->shown);
    picture_close(&s->expected);
}

static int is_unlit(stage *s, int32_t x, int32_t y, int32_t z) {
    s->light.vector = (glint_vector){x, y, z};
    return picture_render(&s->shown, &s->scene, NULL, NULL) == GLINT_OK && picture_equal(&s->shown, &s->expected);
}

/* Under one directional light, and under others. */
static void for_both_formats(glint_viewer viewer, long (*count_lit)(stage *s)) {
    static const glint_format *const formats[2] = {&glint_format_rgb565, &glint_format_rgb888};
    for (int i = 0; i < 2; i++) {
        stage s;
        open(&s, formats[i], viewer);
        CHECK_EQUAL(count_lit(&s), 0);
        close(&s);
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
    static const test_case cases[] = {TEST_CASE(straight_from_behind), TEST_CASE(nearly_from_behind),
                                      TEST_CASE(local_viewer)};
    return test_run(write, cases, TEST_COUNT(cases));
}
