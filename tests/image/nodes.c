/* SPDX-License-Identifier: MIT */
/*
 * Suite: light at nodes is as near to that of fragments as its bound allows, for triangles and light of many kinds, and
 * steps no more than that where an object moves slowly.
 */
#include "bench.h"
#include "fine.h"
#include "glint.h"
#include "harness.h"
#include "nodes/angles.h"
#include "nodes/nearness.h"
#include "nodes/shapes.h"
#include "picture.h"
#include "sample.h"
#include "scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH 128
#define HEIGHT 96

/* What polynomials may be off, in levels for each 1 that weights add up to: LIMIT of terms_prepare.c, doubled once; and
 * at most: MOST_OF_QUADRATICS; of light without highlights, MOST_OF_SUMS. */
#define ALLOWED (2 * 51 / 256.0)
#define MOST_ALLOWED (320 / 256.0)
#define MOST_ALLOWED_SUMS (112 / 256.0)

/* What fragments may be off themselves by the contract, half a level of rounding aside. */
#define OF_FRAGMENTS 0.3

/* ---- Random triangles ---------------------------------------------------------------------------------------- */

static uint32_t random_state;

/* From a to b, by a linear congruential generator (Numerical Recipes). */
static double between(double a, double b) {
    random_state = random_state * 1664525u + 1013904223u;
    return a + (b - a) * (random_state >> 8) / 16777216.0;
}

/* The same, each factor of two as likely as the others. */
static double across(double a, double b) {
    return a * pow(b / a, between(0, 1));
}

/* What lights and materials are made of. */
typedef struct kind {
    const char *name;
    const glint_light_type *type;
    const glint_model *model;
    double least, most; /* exponents */
    uint32_t flags;
    int lights, has_colours, at_corner, is_wall;
    int sum; /* of weights; if more than 1, all from one side */
} kind;

static const kind kinds[] = {
    {"directional, Lambert", &glint_light_directional, &glint_model_lambert, 1, 1, 0, 1, 0, 0, 0, 1},
    {"directional, Lambert, mesh colours", &glint_light_directional, &glint_model_lambert, 1, 1, 0, 1, 1, 0, 0, 1},
    {"directional, Blinn-Phong to 7", &glint_light_directional, &glint_model_blinn_phong, 1, 7, 0, 1, 0, 0, 0, 1},
    {"directional, Blinn-Phong from 7", &glint_light_directional, &glint_model_blinn_phong, 7, 1024, 0, 1, 0, 0, 0, 1},
    {"directional, Phong to 7", &glint_light_directional, &glint_model_phong, 1, 7, 0, 1, 0, 0, 0, 1},
    {"directional, Phong from 7", &glint_light_directional, &glint_model_phong, 7, 1024, 0, 1, 0, 0, 0, 1},
    {"directional, ungated", &glint_light_directional, &glint_model_blinn_phong, 1, 1024, GLINT_MATERIAL_UNGATED, 1, 0,
     0, 0, 1},
    {"lamp, Lambert", &glint_light_point, &glint_model_lambert, 1, 1, 0, 1, 0, 0, 0, 1},
    {"lamp, Blinn-Phong to 7", &glint_light_point, &glint_model_blinn_phong, 1, 7, 0, 1, 0, 0, 0, 1},
    {"lamp, Blinn-Phong from 7", &glint_light_point, &glint_model_blinn_phong, 7, 1024, 0, 1, 0, 0, 0, 1},
    {"lamp, Phong", &glint_light_point, &glint_model_phong, 1, 1024, 0, 1, 0, 0, 0, 1},
    {"lamp, max, mesh colours", &glint_light_point, &glint_model_blinn_phong, 1, 256, GLINT_MATERIAL_MAX, 1, 1, 0, 0,
     1},
    {"spot, Lambert", &glint_light_spot, &glint_model_lambert, 1, 1, 0, 1, 0, 0, 0, 1},
    {"spot, Blinn-Phong", &glint_light_spot, &glint_model_blinn_phong, 1, 1024, 0, 1, 0, 0, 0, 1},
    {"spot, Phong, mesh colours", &glint_light_spot, &glint_model_phong, 1, 1024, 0, 1, 1, 0, 0, 1},
    {"8 directional, Blinn-Phong", &glint_light_directional, &glint_model_blinn_phong, 1, 256, 0, 8, 0, 0, 0, 1},
    {"8 lamps, Phong, mesh colours", &glint_light_point, &glint_model_phong, 1, 256, 0, 8, 1, 0, 0, 1},
    {"8 spots, Blinn-Phong", &glint_light_spot, &glint_model_blinn_phong, 1, 256, 0, 8, 0, 0, 0, 1},
    {"lamp at a corner, Blinn-Phong", &glint_light_point, &glint_model_blinn_phong, 1, 256, 0, 1, 0, 1, 0, 1},
    {"lamp before a wall, Lambert", &glint_light_point, &glint_model_lambert, 1, 1, 0, 1, 0, 0, 1, 1},
    {"lamp before a wall, Blinn-Phong", &glint_light_point, &glint_model_blinn_phong, 1, 256, 0, 1, 0, 0, 1, 1},
    {"spot before a wall, Phong", &glint_light_spot, &glint_model_phong, 1, 256, 0, 1, 0, 0, 1, 1},
    {"8 directional from one side, bright", &glint_light_directional, &glint_model_blinn_phong, 1, 256, 0, 8, 0, 0, 0,
     4},
    {"8 lamps from one side, bright", &glint_light_point, &glint_model_lambert, 1, 1, 0, 8, 0, 0, 0, 4},
};

/* A triangle of its own mesh. */
typedef struct single {
    test_scene scene;
    glint_mesh mesh;
    int16_t positions[3][3], normals[3][3];
    uint8_t colours[3][3];
} single;

static int16_t whole(double value) {
    return (int16_t)lrint(fmax(-32767, fmin(32767, value)));
}

/* A corner anywhere on the screen, from 2 to 8 away; positions are of an extent of 16. */
static void place_corner(single *s, int i, double size, double depth) {
    const double z = -4 + between(-depth, depth);
    s->positions[i][0] = whole(between(-size, size) * -z * 0.55 * 2048);
    s->positions[i][1] = whole(between(-size, size) * -z * 0.41 * 2048);
    s->positions[i][2] = whole(z * 2048);
}

/* The plane's normal, towards the eye, and leaning. */
static void lean(single *s, double by) {
    double a[3], b[3], n[3];
    for (int c = 0; c < 3; c++) {
        a[c] = s->positions[1][c] - s->positions[0][c];
        b[c] = s->positions[2][c] - s->positions[0][c];
    }
    for (int c = 0; c < 3; c++)
        n[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) + 1e-9;
    for (int i = 0; i < 3; i++) {
        double leaning[3], square = 0;
        for (int c = 0; c < 3; c++) {
            leaning[c] = n[c] / length + between(-by, by);
            square += leaning[c] * leaning[c];
        }
        for (int c = 0; c < 3; c++)
            s->normals[i][c] = whole(leaning[c] / sqrt(square) * 32767);
    }
}

static void place_corners(single *s) {
    const double size = across(0.1, 1), depth = across(0.01, 2);
    for (int i = 0; i < 3; i++)
        place_corner(s, i, size, depth);
}

/* Around the axis of view, across it, within the guard band. @return how far */
static double place_wall(single *s) {
    const double far = across(0.1, 1.5), turn = between(0, 6.28);
    for (int i = 0; i < 3; i++) {
        const double size = far * between(4, 8.5), at = turn + i * 2.09 + between(-0.5, 0.5);
        s->positions[i][0] = whole(size * cos(at) * 2048);
        s->positions[i][1] = whole(size * sin(at) * 2048);
        s->positions[i][2] = whole(-far * 2048);
    }
    return far;
}

static void build_mesh(single *s, int has_colours) {
    static const uint16_t triangle[1][3] = {{0, 1, 2}};
    lean(s, between(0, 1) < 0.5 ? across(0.01, 0.2) : between(0, 0.6));
    for (int i = 0; i < 9; i++)
        s->colours[i / 3][i % 3] = (uint8_t)between(0, 256);
    s->mesh = (glint_mesh){.positions = (const int16_t(*)[3])s->positions,
                           .normals = (const int16_t(*)[3])s->normals,
                           .triangles = triangle,
                           .vertex_count = 3,
                           .triangle_count = 1,
                           .flags = GLINT_MESH_DOUBLE_SIDED,
                           .extent = {16 * GLINT_ONE, 16 * GLINT_ONE, 16 * GLINT_ONE}};
    if (has_colours)
        s->mesh.colours = (const uint8_t(*)[3])s->colours;
}

static glint_colour grey(double level) {
    return (glint_colour){bench_q16(level), bench_q16(level), bench_q16(level)};
}

/* Beside the triangle: more often before it than behind. */
static void build_light(glint_light *light, const kind *of) {
    const double x = between(-2, 2), y = between(-2, 2), z = across(0.1, 3) * (between(0, 1) < 0.8 ? 1 : -1);
    const double inner = across(2, 60);
    const int is_directional = of->type == &glint_light_directional;
    *light = (glint_light){.type = of->type,
                           .vector = {bench_q16(x), bench_q16(y), bench_q16(is_directional ? z : z - 4)},
                           .diffuse = grey((double)of->sum / of->lights),
                           .specular = grey((double)of->sum / of->lights),
                           .linear = bench_q16(between(0, 0.3)),
                           .quadratic = bench_q16(between(0, 0.3)),
                           .inner = bench_q16(inner),
                           .outer = bench_q16(inner + across(6, 40))};
    light->axis = (glint_vector){bench_q16(between(-1, 1) - x), bench_q16(between(-1, 1) - y), bench_q16(-z)};
}

/* At a corner, where directions tell nothing, or some steps beside it. */
static void put_at_corner(glint_light *light, const int16_t corner[3]) {
    glint_q16 *const to[3] = {&light->vector.x, &light->vector.y, &light->vector.z};
    const double off = between(0, 1) < 0.5 ? 0 : across(1, 64);
    for (int c = 0; c < 3; c++)
        *to[c] = bench_q16(corner[c] * 16 / 32767.0) + (glint_q16)lrint(between(-off, off));
}

/* About as near to a wall as the eye, and turned towards it; cones have soft edges. */
static void put_before_wall(glint_light *light, double far) {
    const double inner = between(10, 50);
    light->vector = (glint_vector){bench_q16(between(-far, far)), bench_q16(between(-far, far)),
                                   bench_q16(far * (across(0.1, 2) - 1))};
    light->axis = (glint_vector){bench_q16(between(-1, 1)), bench_q16(between(-1, 1)), -GLINT_ONE};
    light->inner = bench_q16(inner);
    light->outer = bench_q16(inner + between(15, 35));
}

/* Nearly where the first one is. */
static void put_beside(glint_light *light, const glint_light *first) {
    light->vector = first->vector;
    light->vector.x += bench_q16(between(-0.1, 0.1));
    light->vector.y += bench_q16(between(-0.1, 0.1));
}

static void build(single *s, const kind *of, uint32_t seed) {
    random_state = seed * 2654435761u;
    scene_build_named(&s->scene, "mirrored");
    const double far = of->is_wall ? place_wall(s) : 0;
    if (!of->is_wall)
        place_corners(s);
    build_mesh(s, of->has_colours);
    glint_material *material = &s->scene.materials[0];
    s->scene.objects[0] = (glint_object){.mesh = &s->mesh, .material = material, .pose = glint_pose_identity()};
    *material = (glint_material){.model = of->model,
                                 .ambient = grey(0.1),
                                 .diffuse = grey(of->model == &glint_model_lambert ? 1 : 0.6),
                                 .specular = grey(0.4),
                                 .shininess = bench_q16(across(of->least, of->most)),
                                 .flags = of->flags};
    s->scene.scene.camera = (glint_camera){glint_pose_identity(), 45 * GLINT_ONE, GLINT_ONE / 32};
    s->scene.scene.viewer = between(0, 1) < 0.5 ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
    s->scene.scene.ambient = grey(1);
    s->scene.scene.light_count = (uint32_t)of->lights;
    s->scene.scene.object_count = 1;
    for (int i = 0; i < of->lights; i++)
        build_light(&s->scene.lights[i], of);
    for (int i = 1; i < of->lights && of->sum > 1; i++)
        put_beside(&s->scene.lights[i], &s->scene.lights[0]);
    if (of->at_corner)
        put_at_corner(&s->scene.lights[0], s->positions[(int)between(0, 3)]);
    if (of->is_wall)
        put_before_wall(&s->scene.lights[0], far);
}

/* ---- The bound ----------------------------------------------------------------------------------------------- */

/* By triangles that were drawn whole, and all others. */
typedef struct found {
    double largest[2];
    long triangles[2], pixels[2];
    uint32_t seed[2];
} found;

static void compare(const kind *of, uint32_t seed, found *to) {
    static single s;
    picture nodes = picture_open(WIDTH, HEIGHT, &glint_format_fine),
            fragments = picture_open(WIDTH, HEIGHT, &glint_format_fine);
    glint_stats stats = {0};
    build(&s, of, seed);
    CHECK_EQUAL(picture_render(&fragments, &s.scene.scene, NULL, NULL), GLINT_OK);
    scene_light_at_nodes(&s.scene);
    CHECK_EQUAL(picture_render(&nodes, &s.scene.scene, NULL, &stats), GLINT_OK);
    const int others = !stats.drawn[GLINT_KERNEL_CHANNELS].covered;
    double largest = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        const double apart = fabs(fine_level(&nodes, i) - fine_level(&fragments, i));
        to->pixels[others] += apart != 0;
        largest = fmax(largest, apart);
    }
    to->triangles[others]++;
    if (largest > to->largest[others]) {
        to->largest[others] = largest;
        to->seed[others] = seed;
    }
    picture_close(&nodes);
    picture_close(&fragments);
}

static void within_the_bound(void) {
    char line[160];
    test_write(
        "                                     whole: triangles  largest  seed | squares and fragments, the same\n");
    for (unsigned k = 0; k < TEST_COUNT(kinds); k++) {
        found all = {{0}, {0}, {0}, {0}};
        for (uint32_t seed = 1; seed <= 400 / sample_share(); seed++)
            compare(&kinds[k], seed, &all);
        snprintf(line, sizeof line, "%-40s %9ld %10.3f %5u | %9ld %8.3f %5u\n", kinds[k].name, all.triangles[0],
                 all.largest[0], (unsigned)all.seed[0], all.triangles[1], all.largest[1], (unsigned)all.seed[1]);
        test_write(line);
        CHECK(all.pixels[0] + all.pixels[1] > 0);
        const double most = kinds[k].model == &glint_model_lambert ? MOST_ALLOWED_SUMS : MOST_ALLOWED,
                     allowed = fmin(ALLOWED * kinds[k].sum, most) + OF_FRAGMENTS;
        CHECK(all.largest[0] <= allowed);
        CHECK(all.largest[1] <= allowed);
    }
}

/* ---- Slow motion --------------------------------------------------------------------------------------------- */

#define FRAMES 40

/* Most steps by which a pixel changes that stands still in the other pictures. */
static int largest_jump(const picture nodes[2], const picture fragments[2], long *still) {
    int largest = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        const int x = i % WIDTH, y = i / WIDTH;
        const size_t size = glint_row_bytes(nodes[0].format, 1), at = (size_t)y * nodes[0].stride + (size_t)x * size;
        if (!memcmp(fragments[0].bytes + at, fragments[1].bytes + at, size) &&
            !memcmp(nodes[0].bytes + at, nodes[1].bytes + at, size)) {
            *still += 3;
            continue;
        }
        for (int c = 0; c < 3; c++) {
            const int moved = picture_level(&fragments[0], x, y, c) != picture_level(&fragments[1], x, y, c);
            const int jump = abs(picture_level(&nodes[0], x, y, c) - picture_level(&nodes[1], x, y, c));
            *still += !moved;
            if (!moved && jump > largest)
                largest = jump;
        }
    }
    return largest;
}

/* Frames in which as many triangles are drawn as in the one before, but not as many of them whole. */
static long changed;

static void count_change(const glint_stats stats[2]) {
    uint32_t parts[2] = {0, 0};
    for (int kernel = 0; kernel < GLINT_KERNELS; kernel++)
        for (int i = 0; i < 2; i++)
            parts[i] += stats[i].drawn[kernel].parts;
    changed += parts[0] == parts[1] &&
               stats[0].drawn[GLINT_KERNEL_CHANNELS].parts != stats[1].drawn[GLINT_KERNEL_CHANNELS].parts;
}

/* Moves as `step` says from frame to frame. @return the largest jump of any */
static int find_jumps(test_scene *scene, const glint_pose *step, const glint_format *format, long *still) {
    picture nodes[2], fragments[2];
    glint_stats stats[2] = {{0}, {0}};
    glint_pose *const pose = &scene->objects[0].pose;
    int largest = 0;
    for (int i = 0; i < 2; i++) {
        nodes[i] = picture_open(WIDTH, HEIGHT, format);
        fragments[i] = picture_open(WIDTH, HEIGHT, format);
    }
    for (int frame = 0; frame < FRAMES; frame++) {
        scene->objects[0].evaluation = NULL;
        CHECK_EQUAL(picture_render(&fragments[frame % 2], &scene->scene, NULL, NULL), GLINT_OK);
        scene_light_at_nodes(scene);
        CHECK_EQUAL(picture_render(&nodes[frame % 2], &scene->scene, NULL, &stats[frame % 2]), GLINT_OK);
        if (frame) {
            count_change(stats);
            const int jump = largest_jump(nodes, fragments, still);
            largest = jump > largest ? jump : largest;
        }
        const glint_pose place = glint_pose_translate(pose->m[0][3], pose->m[1][3], pose->m[2][3]);
        pose->m[0][3] = pose->m[1][3] = pose->m[2][3] = 0;
        *pose = glint_pose_then(pose, step);
        *pose = glint_pose_then(pose, &place);
    }
    for (int i = 0; i < 2; i++) {
        picture_close(&nodes[i]);
        picture_close(&fragments[i]);
    }
    return largest;
}

/* A coarse torus under one light or eight, near or far. */
static void build_moving(test_scene *scene, const kind *of, uint32_t seed) {
    single whole_of;
    build(&whole_of, of, seed);
    *scene = whole_of.scene;
    scene->scene.objects = scene->objects;
    scene->scene.lights = scene->lights;
    scene->objects[0] = (glint_object){.mesh = &scene_bench_mesh(seed % 2 ? 1 : 3)->mesh,
                                       .material = &scene->materials[0],
                                       .pose = bench_turn(-0.8, 0.6)};
    scene->objects[0].pose.m[2][3] = -4 * GLINT_ONE;
}

static void slow_motion(void) {
    static const glint_format *const formats[2] = {&glint_format_rgb888, &glint_format_rgb565};
    static const int allowed[2] = {2, 1};
    const glint_pose turn = glint_pose_rotate_y(GLINT_Q16(0.01));            /* degrees */
    const glint_pose shift = glint_pose_translate(GLINT_Q16(0.00069), 0, 0); /* 0.02 of 96 pixels at a distance of 4 */
    char line[120];
    int largest[2] = {0, 0};
    changed = 0;
    for (unsigned k = 0; k < TEST_COUNT(kinds); k++)
        for (int way = 0; way < 4; way++) {
            test_scene scene;
            long still = 0;
            build_moving(&scene, &kinds[k], k + 1);
            const int jump = find_jumps(&scene, way / 2 ? &shift : &turn, formats[way % 2], &still);
            CHECK(still > 0);
            largest[way % 2] = jump > largest[way % 2] ? jump : largest[way % 2];
            if (!CHECK(jump <= allowed[way % 2])) {
                snprintf(line, sizeof line, "  %s, %s, %s: %d steps\n", kinds[k].name, way / 2 ? "moved" : "turned",
                         way % 2 ? "RGB565" : "RGB888", jump);
                test_write(line);
            }
        }
    snprintf(line, sizeof line, "slow motion: %ld changes to or from whole triangles; jumps of RGB888 %d, RGB565 %d\n",
             changed, largest[0], largest[1]);
    test_write(line);
    CHECK(changed > 100);
}

/* ---- What tiles hand on --------------------------------------------------------------------------------------- */

/* With little and with much of the arena left free, so that what one tile has found is there for the next, or gone. */
static void handed_on_or_found_anew(void) {
    enum { STEPS = 24, STEP = 3001 };
    for (unsigned k = 0; k < TEST_COUNT(kinds); k++) {
        test_scene scene;
        glint_stats stats;
        picture wanted = picture_open(WIDTH, HEIGHT, &glint_format_rgb888), got;
        picture_options options = {16, 16, 0, NULL};
        got = picture_open(WIDTH, HEIGHT, &glint_format_rgb888);
        build_moving(&scene, &kinds[k], k + 1);
        scene_light_at_nodes(&scene);
        CHECK_EQUAL(picture_render(&wanted, &scene.scene, &options, &stats), GLINT_OK);
        options.arena_size = stats.arena_used;
        for (int i = 0; i < STEPS; i++, options.arena_size += STEP) {
            CHECK_EQUAL(picture_render(&got, &scene.scene, &options, &stats), GLINT_OK);
            if (!CHECK(picture_equal(&wanted, &got)))
                break;
        }
        picture_close(&wanted);
        picture_close(&got);
    }
}

/* ---- Bounds --------------------------------------------------------------------------------------------------- */

/* By how much sums over length may be off, of a region without lights. */
static uint32_t over_length(uint32_t ambient, int folds) {
    static const glint_material material = {.model = &glint_model_lambert};
    static glint_frame frame;
    glint_light_terms terms = {.ambient_levels = ambient, .most_of_sums = UINT32_MAX};
    const glint_shading shading = {.material = &material, .terms = &terms};
    glint_region region = {.turn = 1 << 11, .place = 1 << 10, .slant = 0, .levels = 63 << 4, .folds = folds};
    CHECK_EQUAL(glint_region_bound(&frame, &shading, &region), 1);
    return glint_error_over_length(&frame, &shading, &region);
}

/* Colours times the normal's length turn as the normal and the light do, and ambient light with them. */
static void folded_colours_add_to_the_bound(void) {
    CHECK(over_length(0, 1) > over_length(0, 0));
    CHECK(over_length(63 << 8, 1) > over_length(0, 1));
    CHECK_EQUAL(over_length(63 << 8, 0), over_length(0, 0));
}

/* A triangle across the axis of view, its longest side 1, with normals of its own, and a light: what light is there. */
typedef struct lit_triangle {
    double corner[3][2], normal[3][3], light[3], linear, quadratic;
} lit_triangle;

static double length_of(const double v[3]) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* At barycentric coordinates l. @return N.L times strength; sets this and the distance */
static double light_at(const lit_triangle *t, const double l[3], double *strength, double *distance) {
    double normal[3] = {0}, way[3] = {t->light[0], t->light[1], t->light[2]}, cosine = 0;
    for (int i = 0; i < 3; i++) {
        way[0] -= l[i] * t->corner[i][0];
        way[1] -= l[i] * t->corner[i][1];
        for (int c = 0; c < 3; c++)
            normal[c] += l[i] * t->normal[i][c];
    }
    *distance = length_of(way);
    *strength = 1 / (1 + t->linear * *distance + t->quadratic * *distance * *distance);
    for (int c = 0; c < 3; c++)
        cosine += normal[c] * way[c] / (length_of(normal) * *distance);
    return cosine * *strength;
}

static void build_lit(lit_triangle *t, double turn) {
    double longest = 0, far = across(0.3, 6), base[3] = {between(-1, 1), between(-1, 1), between(-1, 1)};
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 2; c++)
            t->corner[i][c] = between(-1, 1);
    for (int i = 0; i < 3; i++)
        longest = fmax(longest,
                       hypot(t->corner[i][0] - t->corner[(i + 1) % 3][0], t->corner[i][1] - t->corner[(i + 1) % 3][1]));
    const double size = length_of(base) + 1e-3;
    for (int i = 0; i < 3; i++) {
        for (int c = 0; c < 3; c++)
            t->normal[i][c] = base[c] / size + between(-turn, turn);
        const double length = length_of(t->normal[i]) + 1e-9;
        for (int c = 0; c < 3; c++)
            t->normal[i][c] /= length;
        t->corner[i][0] /= longest;
        t->corner[i][1] /= longest;
    }
    for (int c = 0; c < 3; c++)
        t->light[c] = between(c == 2 ? 0.02 : -far, far);
    t->linear = between(0, 1) < 0.5 ? 0 : across(0.02, 50);
    t->quadratic = between(0, 1) < 0.5 ? 0 : across(0.002, 100);
}

/* How far quadratics, and planes whose chords are made longer, are off, of 1. */
static void find_errors(const lit_triangle *t, double longer, double error[2]) {
    static const double at[6][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}};
    double v[6], strength, distance;
    for (int i = 0; i < 6; i++)
        v[i] = light_at(t, at[i], &strength, &distance);
    error[0] = error[1] = 0;
    for (int i = 0; i <= 64; i++) {
        const int column = i % 8, row = i / 8;
        const double a = column / 8.0, b = row / 8.0, l[3] = {a, b, 1 - a - b};
        if (l[2] < 0)
            continue;
        const double here = light_at(t, l, &strength, &distance), plane = a * v[0] + b * v[1] + l[2] * v[2],
                     quadratic = a * (2 * a - 1) * v[0] + b * (2 * b - 1) * v[1] + l[2] * (2 * l[2] - 1) * v[2] +
                                 4 * (a * b * v[3] + b * l[2] * v[4] + a * l[2] * v[5]);
        error[0] = fmax(error[0], fabs(quadratic - here));
        error[1] = fmax(error[1], fabs(plane * longer - here));
    }
}

/* No polynomial of a light with a place, of any falling strength, is off by more than the laws make of its region. */
static void places_turn_light_as_the_laws_say(void) {
    static const glint_material material = {.model = &glint_model_lambert};
    static glint_frame frame;
    const glint_light_terms terms = {.most_of_sums = UINT32_MAX, .limit = 204, .most = 320, .placed = 1};
    const glint_shading shading = {.material = &material, .terms = &terms, .lights = 1};
    double largest[2] = {0, 0};
    int judged[2] = {0, 0};
    char line[120];
    random_state = 4;
    for (int n = 0; n < 200000; n++) {
        static const double at[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        lit_triangle t;
        double least = INFINITY, most = 0, turn = 0, error[2];
        int is_held = 1;
        build_lit(&t, n % 4 ? across(0.005, 0.5) : 0);
        for (int i = 0; i < 3; i++) {
            double apart[3], strength, distance;
            is_held &= light_at(&t, at[i], &strength, &distance) > 0;
            least = fmin(least, distance);
            most = fmax(most, strength);
            for (int c = 0; c < 3; c++)
                apart[c] = t.normal[i][c] - t.normal[(i + 1) % 3][c];
            turn = fmax(turn, length_of(apart));
        }
        if (!is_held || least < 4 / 3.0)
            continue;
        glint_region region = {.turn = (uint32_t)ceil(turn * 4096),
                               .near = (uint32_t)ceil(4096 / least),
                               .near_of = {(uint16_t)ceil(4096 / least)},
                               .strength = {(uint16_t)floor(most * 16384)},
                               .levels = (uint32_t)ceil(most * 4 * 63 * 16),
                               .held = 1};
        if (!glint_region_fits(&shading, 0, &region) || !glint_region_bound(&frame, &shading, &region))
            continue;
        find_errors(&t, 1 + turn * turn / 12, error);
        const double allowed[2] = {region.error / 256.0, glint_plane_error(&shading, 0, &region) / 256.0};
        for (int way = 0; way < 2; way++) {
            if (allowed[way] < 0.05) /* steps of the bound */
                continue;
            judged[way]++;
            largest[way] = fmax(largest[way], error[way] * 4 * 63 / allowed[way]);
        }
    }
    snprintf(line, sizeof line, "lights with a place: quadratics off by %.2f of the law at most, planes %.2f\n",
             largest[0], largest[1]);
    test_write(line);
    CHECK(judged[0] > 10000 && judged[1] > 10000);
    CHECK(largest[0] <= 1 && largest[0] > 0.5);
    CHECK(largest[1] <= 1 && largest[1] > 0.5);
}

/* Light in sums that is off by too much on its own fits no limit, whatever all together may be off by. */
static void sums_have_a_bound_of_their_own(void) {
    static const glint_material material = {.model = &glint_model_lambert};
    static glint_frame frame;
    glint_light_terms terms = {.most_of_sums = UINT32_MAX};
    const glint_shading shading = {.material = &material, .terms = &terms};
    int within = 0, beyond = 0;
    for (uint32_t turn = 0; turn < 4096; turn += 16) {
        glint_region free = {.turn = turn, .place = turn / 2, .slant = 100, .levels = 4 * 63 << 4}, bound = free;
        terms.most_of_sums = UINT32_MAX;
        CHECK_EQUAL(glint_region_bound(&frame, &shading, &free), 1);
        const uint32_t over = glint_error_over_length(&frame, &shading, &free);
        terms.most_of_sums = 112;
        CHECK_EQUAL(glint_region_bound(&frame, &shading, &bound), 1);
        const uint32_t bound_over = glint_error_over_length(&frame, &shading, &bound);
        CHECK(free.error <= 112 ? bound.error == free.error : bound.error > 1 << 20);
        CHECK(over <= 112 ? bound_over == over : bound_over > 1 << 20);
        within += free.error <= 112 && over <= 112;
        beyond += free.error > 112 && over > 112;
    }
    CHECK(within > 10);
    CHECK(beyond > 10);
}

/* What quadratics are off by, those over length, and what is more where nodes are found between corners. */
static void find_errors_of(const glint_frame *frame, const glint_shading *shading, glint_region *region,
                           uint32_t error[3]) {
    CHECK_EQUAL(glint_region_bound(frame, shading, region), 1);
    error[0] = region->error;
    error[1] = glint_error_over_length(frame, shading, region);
    error[2] = glint_error_between(shading, region);
}

/* So does each highlight, whatever it is off by: as quadratics, over length, or found between corners. */
static void highlights_have_a_bound_each(void) {
    static const glint_view view;
    static const glint_frame frame = {.view = &view};
    static const glint_material material = {.model = &glint_model_blinn_phong};
    glint_light_terms terms = {.most_of_sums = UINT32_MAX, .specular_levels = {4 * 63 << 8, 4 * 63 << 8}};
    const glint_shading shading = {.material = &material, .terms = &terms};
    int within = 0, beyond = 0;
    for (uint32_t turn = 0; turn < 4096; turn += 16) {
        glint_region one = {.turn = turn, .slant = 100, .slope = 400, .lobes = 1}, two, bound;
        one.axis_of[0] = one.axis_of[1] = (uint16_t)(turn / 2);
        two = bound = one;
        two.lobes = bound.lobes = 3;
        uint32_t each[3], all[3], held[3];
        terms.most_of_one = UINT32_MAX;
        find_errors_of(&frame, &shading, &one, each);
        find_errors_of(&frame, &shading, &two, all);
        terms.most_of_one = 224;
        find_errors_of(&frame, &shading, &bound, held);
        for (int way = 0; way < 3; way++) {
            CHECK_EQUAL(all[way], 2 * each[way]);
            CHECK(each[way] <= 224 ? held[way] == all[way] : held[way] > 1 << 20);
            within += all[way] > 224 && each[way] <= 224;
            beyond += each[way] > 224;
        }
    }
    CHECK(within > 10);
    CHECK(beyond > 10);
}

/* ---- Deviations ----------------------------------------------------------------------------------------------- */

/* What a light's deviation is off by at nodes, in steps of 2^-14. */
typedef struct deviation_error {
    double largest;
    int count;
} deviation_error;

/* Adds that of R at a normal, with V along z: its x and y. */
static void judge_deviation(const glint_frame *frame, const glint_shading *shading, const int16_t normal[3],
                            deviation_error *to) {
    const int16_t *const light = frame->view->lights[0].direction;
    glint_fragments at = {.count = 1};
    glint_node node, *const nodes[1] = {&node};
    double square = 0, cosine = 0;
    for (int c = 0; c < 3; c++) {
        at.normal[0][c] = normal[c];
        square += (double)normal[c] * normal[c];
        cosine += (double)normal[c] * light[c];
    }
    glint_nodes_light(frame, shading, &at, 1, 1, 1, nodes);
    for (int c = 0; c < 2; c++) {
        const double off =
            node.number[0][GLINT_LOBE_X + c] - (2 * cosine / square * normal[c] - light[c]) / 2; /* of 2^15 */
        to->largest = fmax(to->largest, fabs(off));
    }
    to->count++;
}

/* Mirrored deviations do not depend on how long a vertex's normal is. */
static void mirrored_by_any_length(void) {
    static const glint_material material = {.model = &glint_model_phong};
    static const glint_light_terms terms;
    const glint_shading shading = {.material = &material, .terms = &terms};
    glint_view view = {.light_count = 1};
    const glint_frame frame = {.view = &view};
    deviation_error error = {0, 0};
    char line[120];
    random_state = 5;
    view.lights[0].type = &glint_light_directional;
    while (error.count < 20000) {
        const double towards = between(0, 1.2), turn = towards / 2 + between(-0.2, 0.2), rise = between(-0.2, 0.2);
        const double length = between(32752, 32768); /* of a vertex's normal: numeric.h */
        const int16_t normal[3] = {whole(length * sin(turn) * cos(rise)), whole(length * sin(rise)),
                                   whole(length * cos(turn) * cos(rise))};
        view.lights[0].direction[0] = whole(GLINT_UNIT * sin(towards));
        view.lights[0].direction[2] = whole(GLINT_UNIT * cos(towards));
        judge_deviation(&frame, &shading, normal, &error);
    }
    snprintf(line, sizeof line, "mirrored deviations: off by %.2f steps at most\n", error.largest);
    test_write(line);
    CHECK(error.largest <= 1.5); /* R is cut off, by a step at most, and a deviation rounded to nearest */
}

/* ---- Rounding over length -------------------------------------------------------------------------------------- */

/* By how much highlights may be off over length that do not turn but with N, of so many levels. */
static uint32_t highlight_over_length(const glint_model *model, uint32_t levels, uint32_t slope, uint8_t is_wide) {
    static const glint_view view;
    static const glint_frame frame = {.view = &view};
    const glint_material material = {.model = model};
    const glint_light_terms terms = {.most_of_sums = UINT32_MAX,
                                     .most_of_one = UINT32_MAX,
                                     .specular_levels = {levels << 8},
                                     .lobe_is_wide = is_wide};
    const glint_shading shading = {.material = &material, .terms = &terms};
    glint_region region = {.turn = 1968, .slant = 807, .slope = slope, .lobes = 1}; /* as fuzzing has found it */
    CHECK_EQUAL(glint_region_bound(&frame, &shading, &region), 1);
    return glint_error_over_length(&frame, &shading, &region);
}

/* Steps of numbers count where highlights are bright and narrow, p = 1024, and not where they are as usual, p = 32. */
static void steps_over_length_count(void) {
    const uint32_t steep = 19 << 8, flat = 3 << 8;
    CHECK(highlight_over_length(&glint_model_phong, 763, steep, 0) > 3 * 256 * 7 / 10);
    CHECK(highlight_over_length(&glint_model_blinn_phong, 763, steep, 0) > 2 * 256 * 7 / 10);
    CHECK(highlight_over_length(&glint_model_phong, 63, flat, 0) < 26);
}

/*
 * 1 / |M| of the table is off by 2^-12 where |M| is 1, 1.08 times that where normals turn as here, 1.22 times where 1/w
 * changes so, and a wide highlight's power p times.
 */
static void wide_highlights_count_the_table(void) {
    const double p = 6.97, levels = 121, table = p * levels / 4096 * 1.08 * 1.22;
    const uint32_t two_thirds = (uint32_t)(p * 2 / 3 * 256);
    CHECK(highlight_over_length(&glint_model_blinn_phong, (uint32_t)levels, two_thirds, 1) > 256 * table);
}

/*
 * Where normals do not turn, H alone leaves what a quadratic does of V, 3 v^3 / (72 sqrt 3), over |L + V|: most
 * straight before a light, where that is 2.
 */
static void axes_turn_as_views_do(void) {
    for (uint32_t v = 256; v <= 2048; v *= 2) {
        const double left = 3 * pow(v / 4096.0, 3) / (72 * sqrt(3)) / 2;
        CHECK(0.041 * glint_lobe_third(0, v / 2, v, 0) / 65536 >= left);
        CHECK(0.041 * glint_lobe_third_over_length(0, v / 2, v, 0, 0) / 65536 >= left);
    }
}

/* ---- Lamps ------------------------------------------------------------------------------------------------------ */

/* How far a region of this reach over its depth lies apart over the distance to a light, both Q12. */
static uint32_t place_beside(uint32_t reach, uint32_t closeness) {
    glint_region region = {.reach = reach, .nearness = {(uint16_t)glint_nearness_of(closeness, 0)}};
    glint_region_place(1, 1, &region);
    return region.near_of[0];
}

/* A lamp nearer than nearness tells is right there, however little of its depth a region reaches. */
static void lamps_nearer_than_told_are_there(void) {
    const uint32_t there = place_beside(1 << 12, UINT16_MAX);
    for (uint32_t reach = 1; reach <= 1 << 12; reach *= 2)
        CHECK_EQUAL(place_beside(reach, UINT16_MAX), there);
    CHECK_EQUAL(place_beside(4, 1 << 15), 4 << 7);
}

/* ---- Colours ------------------------------------------------------------------------------------------------------
 */

/* Is there a polynomial through nodes of a surface of one colour, but for one that holds another? */
static int has_polynomial(int16_t colour, int16_t other) {
    static const glint_material material = {.model = &glint_model_lambert};
    static const glint_view view;
    const glint_frame frame = {.view = &view, .config = {.format = &glint_format_rgb888}};
    static const glint_part part;
    static int16_t colours[1][3];
    static glint_polynomials polynomials;
    const glint_light_terms light = {.channels = 1, .most = UINT32_MAX, .most_of_sums = UINT32_MAX};
    const glint_shading shading = {.material = &material, .terms = &light};
    const glint_draw draw = {.shading = &shading, .extra = colours};
    glint_node node[GLINT_CELL_NODES], *nodes[GLINT_CELL_NODES];
    glint_shape shape;
    glint_terms terms;
    for (int i = 0; i < GLINT_CELL_NODES; i++) {
        node[i] = (glint_node){.inverse_w = 1 << 30, .normal = {0, 0, GLINT_UNIT}, .surface = {colour, colour, colour}};
        nodes[i] = &node[i];
    }
    node[0].surface[1] = other;
    glint_shape_cell(&part, 0, 0, 0, 1, &shape);
    return glint_shape_begin(&frame, &draw, &shape, nodes, &terms, &polynomials);
}

/* A colour beyond what a node holds is cut off: nothing goes through it. */
static void colours_that_are_cut_off_have_none(void) {
    CHECK_EQUAL(has_polynomial(1 << 14, 1 << 14), 1);
    CHECK_EQUAL(has_polynomial(INT16_MAX - 1, INT16_MAX - 2), 1);
    CHECK_EQUAL(has_polynomial(INT16_MAX - 1, INT16_MAX), 0);
    CHECK_EQUAL(has_polynomial(1 - INT16_MAX, -INT16_MAX), 0);
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(within_the_bound),
                                      TEST_CASE(slow_motion),
                                      TEST_CASE(handed_on_or_found_anew),
                                      TEST_CASE(folded_colours_add_to_the_bound),
                                      TEST_CASE(places_turn_light_as_the_laws_say),
                                      TEST_CASE(sums_have_a_bound_of_their_own),
                                      TEST_CASE(highlights_have_a_bound_each),
                                      TEST_CASE(mirrored_by_any_length),
                                      TEST_CASE(steps_over_length_count),
                                      TEST_CASE(wide_highlights_count_the_table),
                                      TEST_CASE(axes_turn_as_views_do),
                                      TEST_CASE(lamps_nearer_than_told_are_there),
                                      TEST_CASE(colours_that_are_cut_off_have_none)};
    return test_run(write, cases, TEST_COUNT(cases));
}
