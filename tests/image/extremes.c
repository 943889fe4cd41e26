/* SPDX-License-Identifier: MIT */
/*
 * Suite: the ends of what a scene may say. Lights as far off as numbers reach, the least and the largest field of view,
 * exponents from 0 to 32768, more triangles than a pass holds, and places next to the eye.
 */
#include "bench.h"
#include "glint_extras.h"
#include "harness.h"
#include "judge.h"
#include "picture.h"
#include "rows.h"
#include "scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH 160
#define HEIGHT 120

static glint_colour grey(double value) {
    return (glint_colour){bench_q16(value), bench_q16(value), bench_q16(value)};
}

/* A torus that fills most of the screen, in white light. */
static void build(test_scene *scene) {
    scene_build_named(scene, "mirrored");
    scene->objects[0].mesh = &scene_bench_mesh(1)->mesh;
    scene->objects[0].pose = bench_turn(-0.8, 0.6);
    scene->objects[0].pose.m[2][3] = bench_q16(-3.7);
    scene->materials[0].ambient = grey(0.1);
    scene->materials[0].diffuse = grey(0.5);
    scene->materials[0].specular = grey(0.4);
    scene->materials[0].shininess = 32 * GLINT_ONE;
    scene->scene.ambient = grey(1);
    scene->scene.light_count = 1;
    scene->lights[0] = (glint_light){.type = &glint_light_directional,
                                     .direction = {bench_q16(-0.4), bench_q16(-0.6), bench_q16(-0.7)},
                                     .diffuse = grey(1),
                                     .specular = grey(1)};
}

static void judge_viewers(const char *name, test_scene *scene) {
    judgement total = {0};
    for (int viewer = 0; viewer < 2; viewer++) {
        scene->scene.viewer = (glint_viewer)viewer;
        row_judge(&scene->scene, WIDTH, HEIGHT, &glint_format_rgb565, &total);
    }
    row_print(name, &total);
    row_check(&total, row_is_per_fragment(&scene->scene));
}

/* ---- Lights -------------------------------------------------------------------------------------------------- */

/* Points and spots at the ends of the range, each in every evaluation. */
static void lights_far_off(void) {
    static const glint_vector places[] = {{INT32_MAX, INT32_MAX, INT32_MAX},
                                          {INT32_MIN, INT32_MAX, INT32_MAX},
                                          {0, INT32_MIN, INT32_MAX},
                                          {INT32_MAX, 0, 0},
                                          {GLINT_ONE, 2 * GLINT_ONE, INT32_MAX}};
    const glint_evaluation *const evaluations[3] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    row_print_heading();
    for (unsigned i = 0; i < 6 * TEST_COUNT(places); i++) {
        const glint_vector *place = &places[i / 6];
        test_scene scene;
        char name[80];
        build(&scene);
        scene.objects[0].evaluation = evaluations[i % 3];
        scene.lights[0].type = i / 3 % 2 ? &glint_light_spot : &glint_light_point;
        scene.lights[0].position = *place;
        scene.lights[0].direction = (glint_vector){-(place->x / 2), -(place->y / 2), -(place->z / 2)};
        scene.lights[0].inner = 10 * GLINT_ONE;
        scene.lights[0].outer = 20 * GLINT_ONE;
        snprintf(name, sizeof name, "%s far off, place %u, evaluation %u", i / 3 % 2 ? "spot" : "point", i / 6, i % 3);
        judge_viewers(name, &scene);
    }
}

/* With attenuation so small that it shows over such a distance alone. */
static void light_far_off_fades(void) {
    test_scene scene;
    row_print_heading();
    build(&scene);
    scene.lights[0].type = &glint_light_point;
    scene.lights[0].position = (glint_vector){0, 0, INT32_MAX};
    scene.lights[0].linear = 1; /* 1 / (1 + 1/2) */
    judge_viewers("point far off, a third less", &scene);
    scene.lights[0].quadratic = 1; /* 1 / (1 + 1/2 + 2^14) */
    judge_viewers("point far off, gone", &scene);
    scene.lights[0].linear = scene.lights[0].quadratic = INT32_MAX;
    judge_viewers("point far off, attenuated as far as can be", &scene);
}

/* Spots at the far corners of boxes that a shear draws out to needles: a user would see their ends dark. */
static void cones_reach_the_ends_of_sheared_boxes(void) {
    row_print_heading();
    for (int i = 0; i < 4; i++) {
        const glint_q16 lean_y = i % 2 ? GLINT_Q16(0.9) : GLINT_Q16(-0.9),
                        lean_z = i / 2 ? GLINT_Q16(0.9) : GLINT_Q16(-0.9), thin = GLINT_Q16(0.3);
        int16_t positions[24][3], normals[24][3];
        uint16_t triangles[12][3];
        const glint_mesh_room room = {positions, normals, triangles, 24, 12};
        glint_mesh box;
        test_scene scene;
        build(&scene);
        CHECK_EQUAL(glint_generate_box(&box, &room, GLINT_ONE, GLINT_ONE, GLINT_ONE), GLINT_OK);
        scene.objects[0].mesh = &box;
        scene.objects[0].pose =
            (glint_pose){{{GLINT_ONE, lean_y, lean_z, 0}, {0, thin, 0, 0}, {0, 0, thin, -8 * GLINT_ONE}}};
        scene.lights[0].type = &glint_light_spot;
        scene.lights[0].position = (glint_vector){GLINT_Q16(2.8), 0, -3 * GLINT_ONE};
        scene.lights[0].direction = (glint_vector){0, 0, -GLINT_ONE};
        scene.lights[0].inner = 5 * GLINT_ONE;
        scene.lights[0].outer = 10 * GLINT_ONE;
        judge_viewers("a spot at the end of a sheared box", &scene);
    }
}

/* Ambient light of 14.4 on dark colours of a mesh, under a light that adds little: a user would see a dark surface in
 * bright light too bright, or too dark. */
static void bright_ambient_light_on_dark_colours(void) {
    enum { COLOURED = 2048 };
    static const glint_light_type *const types[2] = {&glint_light_directional, &glint_light_point};
    static uint8_t colours[COLOURED][3];
    for (unsigned i = 0; i < COLOURED; i++) {
        colours[i][0] = (uint8_t)(i % 16);
        colours[i][1] = (uint8_t)(i / 2 % 15);
        colours[i][2] = 12;
    }
    row_print_heading();
    for (int i = 0; i < 2; i++) {
        test_scene scene;
        judgement total = {0};
        build(&scene);
        glint_mesh mesh = *scene.objects[0].mesh;
        CHECK(mesh.vertex_count <= COLOURED);
        mesh.colours = (const uint8_t(*)[3])colours;
        scene.objects[0].mesh = &mesh;
        scene.materials[0].ambient = grey(3.6);
        scene.materials[0].specular = grey(0);
        scene.scene.ambient = grey(4);
        scene.lights[0].type = types[i];
        scene.lights[0].position = (glint_vector){GLINT_ONE, GLINT_ONE, 0};
        row_judge(&scene.scene, WIDTH, HEIGHT, &glint_format_rgb888, &total);
        row_print(i ? "point in bright ambient light" : "sun in bright ambient light", &total);
        row_check(&total, 1);
    }
}

/* ---- Camera -------------------------------------------------------------------------------------------------- */

static void fields_of_view(void) {
    static const struct {
        glint_q16 degrees;
        double distance;
    } views[] = {{GLINT_ONE, 200}, {GLINT_ONE, 170}, {170 * GLINT_ONE, 1.5}, {170 * GLINT_ONE, 3}};
    const glint_light_type *const types[2] = {&glint_light_directional, &glint_light_point};
    row_print_heading();
    for (unsigned i = 0; i < 2 * TEST_COUNT(views); i++) {
        test_scene scene;
        char name[80];
        build(&scene);
        scene.scene.camera.field_of_view = views[i / 2].degrees;
        scene.objects[0].pose.m[2][3] = bench_q16(-views[i / 2].distance);
        scene.lights[0].type = types[i % 2];
        scene.lights[0].position = (glint_vector){2 * GLINT_ONE, 3 * GLINT_ONE, bench_q16(4 - views[i / 2].distance)};
        scene.lights[0].direction = (glint_vector){-2 * GLINT_ONE, -3 * GLINT_ONE, -4 * GLINT_ONE};
        snprintf(name, sizeof name, "%d degrees, at %g, %s", views[i / 2].degrees / GLINT_ONE, views[i / 2].distance,
                 i % 2 ? "point" : "directional");
        judge_viewers(name, &scene);
    }
}

/* Rays to the sides of a row of pixels are the widest there are: the eye's way is next to nothing of a unit vector. A
 * wall before it, in columns so narrow that light counts as linear across them. */
#define COLUMNS 64

static void widest_rays(void) {
    static int16_t positions[2 * COLUMNS + 2][3], normals[2 * COLUMNS + 2][3];
    static uint16_t triangles[2 * COLUMNS][3];
    const glint_shading_model *const models[2] = {&glint_model_blinn_phong, &glint_model_phong};
    for (int i = 0; i < 2 * COLUMNS + 2; i++) {
        positions[i][0] = (int16_t)((i / 2 - COLUMNS / 2) * (32767 / (COLUMNS / 2)));
        positions[i][1] = (int16_t)(i % 2 ? 32767 : -32767);
        normals[i][2] = 32767;
    }
    for (int i = 0; i < 2 * COLUMNS; i++) {
        const uint16_t at[3] = {(uint16_t)i, (uint16_t)(i + 2 - i % 2), (uint16_t)(i + 1 + i % 2)};
        memcpy(triangles[i], at, sizeof at);
    }
    const glint_mesh wall = {.positions = (const int16_t(*)[3])positions,
                             .normals = (const int16_t(*)[3])normals,
                             .triangles = (const uint16_t(*)[3])triangles,
                             .vertex_count = 2 * COLUMNS + 2,
                             .triangle_count = 2 * COLUMNS,
                             .extent = {24000 * GLINT_ONE, 60 * GLINT_ONE, GLINT_ONE}};
    row_print_heading();
    for (int i = 0; i < 2; i++) {
        test_scene scene;
        judgement total = {0};
        build(&scene);
        scene.scene.camera.field_of_view = 170 * GLINT_ONE;
        scene.objects[0].mesh = &wall;
        scene.objects[0].pose = glint_pose_translate(0, 0, -GLINT_ONE);
        scene.lights[0].direction = (glint_vector){-GLINT_ONE, 0, -GLINT_ONE / 50};
        scene.materials[0].model = models[i];
        scene.materials[0].shininess = 4 * GLINT_ONE;
        row_judge(&scene.scene, GLINT_SIZE_MAX, 1, &glint_format_rgb565, &total);
        row_print(i ? "phong" : "blinn-phong", &total);
        row_check(&total, 1);
    }
}

/* ---- Exponents ----------------------------------------------------------------------------------------------- */

static void least_exponents(void) {
    static const glint_q16 exponents[] = {0, 1, 2, 655};
    const glint_shading_model *const models[2] = {&glint_model_blinn_phong, &glint_model_phong};
    const glint_evaluation *const evaluations[2] = {&glint_per_fragment, &glint_per_vertex};
    static const char *const names[2] = {"fragment", "vertex"};
    row_print_heading();
    for (unsigned i = 0; i < 4 * TEST_COUNT(exponents); i++) {
        test_scene scene;
        char name[80];
        build(&scene);
        const glint_q16 exponent = exponents[i / 4];
        scene.materials[0].shininess = exponent;
        scene.materials[0].model = models[i % 2];
        scene.objects[0].evaluation = evaluations[i / 2 % 2];
        snprintf(name, sizeof name, "p = %.6f, %s, per %s", exponent / 65536.0, i % 2 ? "phong" : "blinn-phong",
                 names[i / 2 % 2]);
        judge_viewers(name, &scene);
    }
}

/* A highlight that narrow fills a part of the screen where the field of view is narrow too. */
static void largest_exponents(void) {
    const glint_shading_model *const models[2] = {&glint_model_blinn_phong, &glint_model_phong};
    row_print_heading();
    for (int i = 0; i < 6; i++) {
        test_scene scene;
        char name[80];
        build(&scene);
        scene.objects[0].mesh = &scene_bench_mesh(3)->mesh;
        scene.scene.camera.field_of_view = 2 * GLINT_ONE;
        scene.lights[0].direction = (glint_vector){-GLINT_ONE / 100, 0, -GLINT_ONE};
        scene.materials[0].model = models[i % 2];
        scene.materials[0].shininess = i / 2 ? INT32_MAX : 16384 * GLINT_ONE;
        if (i / 2 == 2) /* the least that shows, on the smallest place */
            scene.materials[0].specular = grey(9.5 / 4096);
        snprintf(name, sizeof name, "p = %.2f, %s%s", scene.materials[0].shininess / 65536.0,
                 i % 2 ? "phong" : "blinn-phong", i / 2 == 2 ? ", weak" : "");
        judge_viewers(name, &scene);
    }
}

/* ---- Near the eye -------------------------------------------------------------------------------------------- */

/* Draws a scene, and compares it. */
static void check_same_picture(const test_scene *scene, const picture *expected) {
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb888);
    glint_stats stats;
    CHECK_EQUAL(picture_render(&image, &scene->scene, NULL, &stats), GLINT_OK);
    CHECK(picture_equal(&image, expected));
    picture_close(&image);
}

/* A triangle so large that coordinates are rounded to more than the near plane, its middle in the eye: seen edge on, it
 * shows nothing, whatever lights that middle. */
static void triangle_around_the_eye(void) {
    static const int16_t corners[3][3] = {{0, 0, -20000}, {10000, 0, 10000}, {-10000, 0, 10000}},
                         normals[3][3] = {{0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}};
    static const uint16_t triangles[2][1][3] = {{{0, 0, 0}}, {{0, 1, 2}}}; /* the first has no area */
    const glint_q16 extent = 8192 * GLINT_ONE;
    glint_mesh around = {.positions = corners,
                         .normals = normals,
                         .triangles = triangles[0],
                         .vertex_count = 3,
                         .triangle_count = 1,
                         .extent = {extent, extent, extent},
                         .flags = GLINT_MESH_DOUBLE_SIDED};
    test_scene scene;
    glint_stats stats;
    picture without = picture_open(WIDTH, HEIGHT, &glint_format_rgb888);
    build(&scene);
    scene.scene.viewer = GLINT_VIEWER_LOCAL;
    scene.scene.camera.near_plane = 1;
    scene.scene.camera.pose = glint_pose_identity();
    scene.objects[1] = scene.objects[0];
    scene.objects[1].mesh = &around;
    scene.objects[1].evaluation = &glint_per_facet;
    scene.objects[1].pose = glint_pose_identity();
    for (int i = 0; i < 3; i++)
        scene.objects[1].pose.m[i][i] = 4 * GLINT_ONE;
    scene.scene.object_count = 2;
    CHECK_EQUAL(picture_render(&without, &scene.scene, NULL, &stats), GLINT_OK);
    CHECK(stats.references > 0 && stats.clipped == 0);
    around.triangles = triangles[1];
    check_same_picture(&scene, &without);
    picture_close(&without);
}

/* An object whose box begins beyond the near plane by less than places are told apart by: the plane may as well be
 * a step nearer. */
static void box_just_beyond_the_near_plane(void) {
    static const int16_t corners[4][3] = {{-32767, 0, -32767},
                                          {32767, 0, -32767},
                                          {0, 32767, 32767},
                                          {0, -32767, 32767}},
                         normals[4][3] = {{0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}};
    static const uint16_t triangles[2][3] = {{0, 1, 2}, {0, 3, 1}};
    const glint_mesh mesh = {.positions = corners,
                             .normals = normals,
                             .triangles = triangles,
                             .vertex_count = 4,
                             .triangle_count = 2,
                             .extent = {2048, 2048, 1024}};
    test_scene scene;
    picture expected = picture_open(WIDTH, HEIGHT, &glint_format_rgb888);
    glint_stats stats;
    build(&scene);
    scene.objects[0].mesh = &mesh;
    scene.objects[0].pose = glint_pose_translate(2048 + 4, 0, -(8192 + 1024));
    scene.scene.camera.pose = glint_pose_identity();
    scene.scene.camera.pose.m[0][2] = -1; /* so that 1/65536 of x adds to the distance */
    scene.scene.camera.near_plane = 8192 - 1;
    CHECK_EQUAL(picture_render(&expected, &scene.scene, NULL, &stats), GLINT_OK);
    CHECK(stats.references > 0 && stats.clipped == 0);
    scene.scene.camera.near_plane = 8192;
    check_same_picture(&scene, &expected);
    picture_close(&expected);
}

/* ---- Single triangles that are hard to light: found where a way of drawing came to its bounds ---- */

/* A triangle of an extent of 16, the light that shines on it, and its material; Q16.16. */
typedef struct single_triangle {
    const char *name;
    int16_t positions[3][3], normals[3][3];
    glint_vector light; /* towards it */
    glint_q16 diffuse, specular, shininess;
    glint_q16 field_of_view;
    int is_fine, has_colours; /* drawn in 8 bits a channel; white and black corners */
} single_triangle;

#define FIELD (45 * GLINT_ONE)
#define WIDE_FIELD (60 * GLINT_ONE)
#define DIFFUSE GLINT_Q16(0.6)

/* clang-format off */
static const single_triangle single_triangles[] = {
    {"wider than two focal lengths",
     {{189, -4320, -4262}, {2258, 330, -3996}, {-2354, 4431, -4061}}, {{-148, -2506, 32671}, {-3626, 4089, 32308}, {2143, 4575, 32375}},
     {28548, 3527, 65536}, DIFFUSE, GLINT_Q16(0.4), 371394, 7756358, 0, 0},
    {"a faint and tiny highlight between its corners",
     {{4003, 2071, -8192}, {145, 2253, -8192}, {2155, -1583, -8192}}, {{-9080, 1238, 31459}, {-2471, 525, 32669}, {-5970, 7410, 31355}},
     {-7428, 18648, 62386}, DIFFUSE, 161, 2023032831, WIDE_FIELD, 0, 0},
    {"half vectors at its corners, none between them",
     {{83, 1453, -6263}, {-533, -284, -6135}, {872, 114, -5942}}, {{-26940, 5169, 17921}, {-24877, 14725, 15428}, {-29331, 6645, 13008}},
     {-54268, 22516, -29034}, DIFFUSE, 4201, 705784, WIDE_FIELD, 0, 0},
    {"the longest normals, towards the light",
     {{1525, -1382, -8192}, {1992, 253, -8192}, {-965, -977, -8192}}, {{4927, 29212, 14021}, {4926, 29207, 14019}, {4926, 29205, 14018}},
     {9852, 58411, 28037}, DIFFUSE, 0, GLINT_ONE, WIDE_FIELD, 0, 0},
    {"normals that are the same, and long",
     {{3155, -1316, -10181}, {-2294, 1621, -8447}, {-482, -2073, -7486}}, {{0, 6553, 32112}, {0, 6553, 32112}, {0, 6553, 32112}},
     {6554, 19661, 32768}, DIFFUSE, 0, GLINT_ONE, FIELD, 0, 0},
    {"normals nearly the same, but for one's y",
     {{3155, -1316, -10181}, {-2294, 1621, -8447}, {-482, -2073, -7486}}, {{0, 6553, 32112}, {0, 6563, 32112}, {0, 6553, 32112}},
     {6554, 19661, 32768}, DIFFUSE, 0, GLINT_ONE, FIELD, 0, 0},
    {"normals nearly the same, but for the last one's y",
     {{1986, -723, -6185}, {-1000, 1486, -8619}, {-3810, -701, -10498}}, {{0, 6553, 32112}, {0, 6553, 32112}, {0, 6563, 32112}},
     {6554, 19661, 32768}, DIFFUSE, 0, GLINT_ONE, FIELD, 0, 0},
    {"normals nearly the same, but for the last one's z",
     {{3359, -246, -10641}, {-1211, 1131, -6075}, {-1266, -1842, -8992}}, {{0, 32112, 6553}, {0, 32112, 6553}, {0, 32112, 6563}},
     {6554, 65536, 32768}, DIFFUSE, 0, GLINT_ONE, FIELD, 0, 0},
    {"colours from 0 to 1 in little light, going away",
     {{-2254, -3338, -11026}, {129, -3082, -8764}, {-728, -938, -5037}}, {{-3847, -16837, 27846}, {13225, -13095, 26968}, {-3948, -11120, 30569}},
     {-62892, -13622, 36287}, 2390, 2390, 1330877, FIELD, 1, 1},
    {"normals all around in little light, across an edge",
     {{2523, 547, -8163}, {2300, 2035, -8106}, {1378, 1065, -8290}}, {{22868, 15921, 17240}, {-19374, -25824, 5608}, {20969, -19618, -15783}},
     {36400, 37969, 18261}, 354, 82, 346844, FIELD, 1, 0},
    {"normals all around in little light, along an edge",
     {{-790, -228, -8251}, {872, -653, -11366}, {-128, 412, -5469}}, {{8334, 9354, 30277}, {-7957, -28498, 14078}, {20263, 25530, 3365}},
     {38798, 31109, 3205}, 263, 0, GLINT_ONE, FIELD, 1, 0},
    {"normals that are half as long at its middle as at its corners",
     {{944, 2269, -8192}, {-2437, -317, -8192}, {1493, -1952, -8192}}, {{10882, 26148, 16480}, {-28086, -3651, 16480}, {17206, -22498, 16480}},
     {0, 0, GLINT_ONE}, DIFFUSE, 0, GLINT_ONE, FIELD, 1, 0},
    {"normals that are too short there for lighting at nodes",
     {{2026, -1391, -8192}, {191, 2450, -8192}, {-2218, -1059, -8192}}, {{24795, -17019, 13009}, {2341, 29983, 13009}, {-27136, -12964, 13009}},
     {0, 0, GLINT_ONE}, DIFFUSE, 0, GLINT_ONE, FIELD, 1, 0},
    {"normals as long as the table of their lengths, and a little more by rounding",
     {{3570, -601, -8192}, {-247, -601, -8192}, {2176, -777, -8192}}, {{941, 17201, 27873}, {9883, 23798, 20240}, {11751, 24127, 18801}},
     {0, 0, GLINT_ONE}, DIFFUSE, 0, GLINT_ONE, FIELD, 1, 0},
    {"a pixel at its nearest corner",
     {{2566, -1913, -8192}, {-2094, 1884, -8192}, {868, -2504, -8570}}, {{-9269, 12255, 28941}, {1256, -2807, 32622}, {-553, -6190, 32172}},
     {0, 0, GLINT_ONE}, DIFFUSE, 0, GLINT_ONE, FIELD, 1, 0},
};
/* clang-format on */

static void build_single(test_scene *scene, glint_mesh *mesh, const single_triangle *of) {
    static const uint16_t triangle[1][3] = {{0, 1, 2}};
    static const uint8_t colours[3][3] = {{0, 255, 255}, {255, 255, 255}, {255, 0, 255}};
    scene_build_named(scene, "mirrored");
    *mesh = (glint_mesh){.positions = of->positions,
                         .normals = of->normals,
                         .triangles = triangle,
                         .vertex_count = 3,
                         .triangle_count = 1,
                         .flags = GLINT_MESH_DOUBLE_SIDED,
                         .extent = {16 * GLINT_ONE, 16 * GLINT_ONE, 16 * GLINT_ONE}};
    if (of->has_colours)
        mesh->colours = colours;
    scene->objects[0].mesh = mesh;
    scene->objects[0].pose = glint_pose_identity();
    scene->materials[0].model = of->specular ? &glint_model_blinn_phong : &glint_model_lambert;
    scene->materials[0].ambient = grey(0.014);
    scene->materials[0].diffuse = (glint_colour){of->diffuse, of->diffuse, of->diffuse};
    scene->materials[0].specular = (glint_colour){of->specular, of->specular, of->specular};
    scene->materials[0].shininess = of->shininess;
    scene->scene.ambient = grey(1);
    scene->scene.light_count = 1;
    scene->lights[0] = (glint_light){.type = &glint_light_directional,
                                     .direction = {-of->light.x, -of->light.y, -of->light.z},
                                     .diffuse = grey(1),
                                     .specular = grey(1)};
    scene->scene.viewer = GLINT_VIEWER_LOCAL;
    scene->scene.camera = (glint_camera){glint_pose_identity(), of->field_of_view, GLINT_ONE / 8};
}

static void triangles_at_the_bounds(void) {
    row_print_heading();
    for (unsigned i = 0; i < TEST_COUNT(single_triangles); i++) {
        const single_triangle *of = &single_triangles[i];
        test_scene scene;
        glint_mesh mesh;
        judgement total = {0};
        build_single(&scene, &mesh, of);
        row_judge(&scene.scene, 128, 96, of->is_fine ? &glint_format_rgb888 : &glint_format_rgb565, &total);
        row_print(of->name, &total);
        row_check(&total, 1);
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(lights_far_off),
        TEST_CASE(light_far_off_fades),
        TEST_CASE(cones_reach_the_ends_of_sheared_boxes),
        TEST_CASE(bright_ambient_light_on_dark_colours),
        TEST_CASE(fields_of_view),
        TEST_CASE(widest_rays),
        TEST_CASE(least_exponents),
        TEST_CASE(largest_exponents),
        TEST_CASE(triangle_around_the_eye),
        TEST_CASE(box_just_beyond_the_near_plane),
        TEST_CASE(triangles_at_the_bounds),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
