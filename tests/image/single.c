/* SPDX-License-Identifier: MIT */
/* Single triangles that are hard to light: found where a way of drawing came to its bounds. */
#include "single.h"

#include "bench.h"
#include "glint.h"
#include "harness.h"
#include "picture.h"
#include "rows.h"
#include "scenes.h"

#define WIDTH 128
#define HEIGHT 96

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

static const single_triangle single_triangles[] = {
    {"wider than two focal lengths",
     {{189, -4320, -4262}, {2258, 330, -3996}, {-2354, 4431, -4061}},
     {{-148, -2506, 32671}, {-3626, 4089, 32308}, {2143, 4575, 32375}},
     {28548, 3527, 65536},
     DIFFUSE,
     GLINT_Q16(0.4),
     371394,
     7756358,
     0,
     0},
    {"a faint and tiny highlight between its corners",
     {{4003, 2071, -8192}, {145, 2253, -8192}, {2155, -1583, -8192}},
     {{-9080, 1238, 31459}, {-2471, 525, 32669}, {-5970, 7410, 31355}},
     {-7428, 18648, 62386},
     DIFFUSE,
     161,
     2023032831,
     WIDE_FIELD,
     0,
     0},
    {"half vectors at its corners, none between them",
     {{83, 1453, -6263}, {-533, -284, -6135}, {872, 114, -5942}},
     {{-26940, 5169, 17921}, {-24877, 14725, 15428}, {-29331, 6645, 13008}},
     {-54268, 22516, -29034},
     DIFFUSE,
     4201,
     705784,
     WIDE_FIELD,
     0,
     0},
    {"the longest normals, towards the light",
     {{1525, -1382, -8192}, {1992, 253, -8192}, {-965, -977, -8192}},
     {{4927, 29212, 14021}, {4926, 29207, 14019}, {4926, 29205, 14018}},
     {9852, 58411, 28037},
     DIFFUSE,
     0,
     GLINT_ONE,
     WIDE_FIELD,
     0,
     0},
    {"normals that are the same, and long",
     {{3155, -1316, -10181}, {-2294, 1621, -8447}, {-482, -2073, -7486}},
     {{0, 6553, 32112}, {0, 6553, 32112}, {0, 6553, 32112}},
     {6554, 19661, 32768},
     DIFFUSE,
     0,
     GLINT_ONE,
     FIELD,
     0,
     0},
    {"normals nearly the same, but for one's y",
     {{3155, -1316, -10181}, {-2294, 1621, -8447}, {-482, -2073, -7486}},
     {{0, 6553, 32112}, {0, 6563, 32112}, {0, 6553, 32112}},
     {6554, 19661, 32768},
     DIFFUSE,
     0,
     GLINT_ONE,
     FIELD,
     0,
     0},
    {"normals nearly the same, but for the last one's y",
     {{1986, -723, -6185}, {-1000, 1486, -8619}, {-3810, -701, -10498}},
     {{0, 6553, 32112}, {0, 6553, 32112}, {0, 6563, 32112}},
     {6554, 19661, 32768},
     DIFFUSE,
     0,
     GLINT_ONE,
     FIELD,
     0,
     0},
    {"normals nearly the same, but for the last one's z",
     {{3359, -246, -10641}, {-1211, 1131, -6075}, {-1266, -1842, -8992}},
     {{0, 32112, 6553}, {0, 32112, 6553}, {0, 32112, 6563}},
     {6554, 65536, 32768},
     DIFFUSE,
     0,
     GLINT_ONE,
     FIELD,
     0,
     0},
    {"colours from 0 to 1 in little light, going away",
     {{-2254, -3338, -11026}, {129, -3082, -8764}, {-728, -938, -5037}},
     {{-3847, -16837, 27846}, {13225, -13095, 26968}, {-3948, -11120, 30569}},
     {-62892, -13622, 36287},
     2390,
     2390,
     1330877,
     FIELD,
     1,
     1},
    {"normals all around in little light, across an edge",
     {{2523, 547, -8163}, {2300, 2035, -8106}, {1378, 1065, -8290}},
     {{22868, 15921, 17240}, {-19374, -25824, 5608}, {20969, -19618, -15783}},
     {36400, 37969, 18261},
     354,
     82,
     346844,
     FIELD,
     1,
     0},
    {"normals all around in little light, along an edge",
     {{-790, -228, -8251}, {872, -653, -11366}, {-128, 412, -5469}},
     {{8334, 9354, 30277}, {-7957, -28498, 14078}, {20263, 25530, 3365}},
     {38798, 31109, 3205},
     263,
     0,
     GLINT_ONE,
     FIELD,
     1,
     0},
    {"normals that are half as long at its middle as at its corners",
     {{944, 2269, -8192}, {-2437, -317, -8192}, {1493, -1952, -8192}},
     {{10882, 26148, 16480}, {-28086, -3651, 16480}, {17206, -22498, 16480}},
     {0, 0, GLINT_ONE},
     DIFFUSE,
     0,
     GLINT_ONE,
     FIELD,
     1,
     0},
    {"normals that are too short there for lighting at nodes",
     {{2026, -1391, -8192}, {191, 2450, -8192}, {-2218, -1059, -8192}},
     {{24795, -17019, 13009}, {2341, 29983, 13009}, {-27136, -12964, 13009}},
     {0, 0, GLINT_ONE},
     DIFFUSE,
     0,
     GLINT_ONE,
     FIELD,
     1,
     0},
    {"normals as long as the table of their lengths, and a little more by rounding",
     {{3570, -601, -8192}, {-247, -601, -8192}, {2176, -777, -8192}},
     {{941, 17201, 27873}, {9883, 23798, 20240}, {11751, 24127, 18801}},
     {0, 0, GLINT_ONE},
     DIFFUSE,
     0,
     GLINT_ONE,
     FIELD,
     1,
     0},
    {"a pixel at its nearest corner",
     {{2566, -1913, -8192}, {-2094, 1884, -8192}, {868, -2504, -8570}},
     {{-9269, 12255, 28941}, {1256, -2807, 32622}, {-553, -6190, 32172}},
     {0, 0, GLINT_ONE},
     DIFFUSE,
     0,
     GLINT_ONE,
     FIELD,
     1,
     0},
};

static glint_colour grey(double value) {
    return (glint_colour){bench_q16(value), bench_q16(value), bench_q16(value)};
}

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
    scene->lights[0] =
        (glint_light){.type = &glint_light_directional, .vector = of->light, .diffuse = grey(1), .specular = grey(1)};
    scene->scene.viewer = GLINT_VIEWER_LOCAL;
    scene->scene.camera = (glint_camera){glint_pose_identity(), of->field_of_view, GLINT_ONE / 8};
}

void triangles_at_the_bounds(void) {
    row_print_heading();
    for (unsigned i = 0; i < TEST_COUNT(single_triangles); i++) {
        const single_triangle *of = &single_triangles[i];
        test_scene scene;
        glint_mesh mesh;
        judgement total = {0};
        build_single(&scene, &mesh, of);
        row_judge(&scene.scene, WIDTH, HEIGHT, of->is_fine ? &glint_format_rgb888 : &glint_format_rgb565, &total);
        row_print(of->name, &total);
        row_check(&total, 1);
    }
}
