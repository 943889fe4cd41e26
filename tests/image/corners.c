/* SPDX-License-Identifier: MIT */
/*
 * Suite: light at vertices and facets in RGB888 against the double-precision reference, for all exponents. Each picture
 * shows a triangle whose normals lie in a highlight, up to three times as far from its centre as its width is. Light
 * weights sum to 1.
 */
#include "glint.h"
#include "harness.h"
#include "judge.h"
#include "random.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define SIZE 32

static double between_logs(double a, double b) {
    return exp(between(log(a), log(b)));
}

static glint_q16 q16(double x) {
    return (glint_q16)lrint(x * 65536);
}

/* ---- Vectors ---- */

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void make_unit(double v[3]) {
    const double length = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

static void random_direction(double v[3]) {
    do {
        for (int i = 0; i < 3; i++)
            v[i] = between(-1, 1);
    } while (dot(v, v) > 1 || dot(v, v) < 0.01);
    make_unit(v);
}

/* ---- A triangle ---- */

typedef enum light_kind { DIRECTIONAL, POINT, SPOT } light_kind;

static const char *const light_names[] = {"directional", "point", "spot"};

/* What a picture shows. */
typedef struct stage {
    glint_light light;
    glint_material material;
    glint_mesh mesh;
    glint_object object;
    glint_scene scene;
    int16_t positions[3][3], normals[3][3];
    uint8_t colours[3][3];
    double towards[3], place[3]; /* directional: unit, towards the light; else the light's place */
} stage;

static const uint16_t triangle[1][3] = {{0, 1, 2}};

/* A rotation, scaled: evenly or not. */
static void make_pose(stage *s, int is_even) {
    double axis[3][3];
    const double scale = between_logs(0.2, 5);
    random_direction(axis[0]);
    random_direction(axis[2]);
    cross(axis[2], axis[0], axis[1]);
    make_unit(axis[1]);
    cross(axis[0], axis[1], axis[2]);
    for (int j = 0; j < 3; j++) {
        const double size = is_even ? scale : scale * between_logs(0.5, 2);
        for (int i = 0; i < 3; i++)
            s->object.pose.m[i][j] = q16(axis[j][i] * size);
    }
}

static void find_half_vector(const stage *s, light_kind kind, const double at[3], double half[3]) {
    double light[3], view[3];
    for (int i = 0; i < 3; i++) {
        light[i] = kind == DIRECTIONAL ? s->towards[i] : s->place[i] - at[i];
        view[i] = s->scene.viewer == GLINT_VIEWER_LOCAL ? -at[i] : i == 2;
    }
    make_unit(light);
    make_unit(view);
    for (int i = 0; i < 3; i++)
        half[i] = light[i] + view[i];
    make_unit(half);
}

/* A normal in a highlight. */
static void make_normal(const stage *s, light_kind kind, const double at[3], double normal[3]) {
    const double width = 1 / sqrt(1 + s->material.shininess / 65536.0);
    double aside[3];
    find_half_vector(s, kind, at, normal);
    random_direction(aside);
    const double by = between(0, 1.5) * width;
    for (int i = 0; i < 3; i++)
        normal[i] += by * aside[i];
    make_unit(normal);
}

/* Camera space to the mesh's steps, by the inverse of the pose, and normals by its transpose. */
static void set_mesh(stage *s, double corner[3][3], double normal[3][3]) {
    const glint_pose *pose = &s->object.pose;
    double column[3][3], cofactor[3][3], place[3][3];
    glint_q16 *const extent[3] = {&s->mesh.extent.x, &s->mesh.extent.y, &s->mesh.extent.z};
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 3; i++)
            column[j][i] = pose->m[i][j] / 65536.0;
    for (int j = 0; j < 3; j++)
        cross(column[(j + 1) % 3], column[(j + 2) % 3], cofactor[j]);
    const double determinant = dot(column[0], cofactor[0]);
    for (int j = 0; j < 3; j++) {
        double most = 0;
        for (int k = 0; k < 3; k++) {
            double from[3];
            for (int i = 0; i < 3; i++)
                from[i] = corner[k][i] - pose->m[i][3] / 65536.0;
            place[k][j] = dot(cofactor[j], from) / determinant;
            most = fmax(most, fabs(place[k][j]));
        }
        *extent[j] = q16(most * between(1.01, 2)) + 1;
        for (int k = 0; k < 3; k++)
            s->positions[k][j] = (int16_t)lrint(place[k][j] * 65536.0 * 32768 / *extent[j]);
    }
    for (int k = 0; k < 3; k++) {
        double n[3];
        for (int j = 0; j < 3; j++)
            n[j] = dot(column[j], normal[k]);
        make_unit(n);
        for (int j = 0; j < 3; j++)
            s->normals[k][j] = (int16_t)lrint(n[j] * 32767);
    }
}

static void make_light(stage *s, light_kind kind, const double centre[3]) {
    static const glint_light_type *const types[] = {&glint_light_directional, &glint_light_point, &glint_light_spot};
    double view[3], aside[3];
    for (int i = 0; i < 3; i++)
        view[i] = -centre[i];
    make_unit(view);
    do
        random_direction(s->towards);
    while (dot(s->towards, view) < -0.3);
    const double distance = between_logs(0.5, 30) * -centre[2];
    for (int i = 0; i < 3; i++)
        s->place[i] = centre[i] + s->towards[i] * distance;
    random_direction(aside);
    s->light = (glint_light){.type = types[kind], .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    s->light.specular = s->light.diffuse;
    if (kind == DIRECTIONAL) {
        s->light.direction = (glint_vector){q16(-s->towards[0]), q16(-s->towards[1]), q16(-s->towards[2])};
    } else {
        s->light.position = (glint_vector){q16(s->place[0]), q16(s->place[1]), q16(s->place[2])};
        s->light.linear = q16(between(0, 0.3) / distance);
        s->light.quadratic = q16(between(0, 0.3) / distance / distance);
    }
    if (kind == SPOT)
        s->light.direction = (glint_vector){q16(0.2 * aside[0] - s->towards[0]), q16(0.2 * aside[1] - s->towards[1]),
                                            q16(0.2 * aside[2] - s->towards[2])};
    s->light.inner = q16(between(1, 10));
    s->light.outer = s->light.inner + q16(between(3, 20));
}

static void make_stage(stage *s, uint32_t seed, light_kind kind, double exponent, const glint_shading_model *model,
                       const glint_evaluation *evaluation) {
    static const glint_q16 grey = GLINT_ONE / 16;
    random_state = seed * 2246822519u + (uint32_t)lrint(exponent * 97);
    *s = (stage){0};
    s->material = (glint_material){.model = model, .shininess = q16(exponent)};
    s->material.ambient = (glint_colour){grey, grey, grey};
    s->material.diffuse = (glint_colour){q16(0.3), q16(0.5), q16(0.9)};
    s->material.specular = (glint_colour){q16(0.7), q16(0.5), q16(0.1)};
    s->material.flags =
        (seed & 1 ? GLINT_MATERIAL_SPECULAR_UNGATED : 0u) | (seed & 2 ? GLINT_MATERIAL_MAX_WITH_AMBIENT : 0u);
    s->object = (glint_object){.mesh = &s->mesh, .material = &s->material, .evaluation = evaluation};
    s->scene = (glint_scene){.lights = &s->light, .light_count = 1, .objects = &s->object, .object_count = 1};
    s->scene.camera.pose = glint_pose_identity();
    s->scene.camera.field_of_view = GLINT_Q16(60);
    s->scene.camera.near_plane = GLINT_ONE / 16;
    s->scene.viewer = seed & 4 ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
    make_pose(s, (seed & 24) != 0);
    const double w = between_logs(0.5, 20), radius = w * between(0.15, 0.4);
    const double centre[3] = {between(-0.2, 0.2) * w, between(-0.2, 0.2) * w, -w};
    double corner[3][3], normal[4][3], right[3], up[3];
    for (int i = 0; i < 3; i++)
        s->object.pose.m[i][3] = q16(centre[i] + between(-0.1, 0.1) * w);
    make_light(s, kind, centre);
    make_normal(s, kind, centre, normal[3]); /* the plane's */
    random_direction(up);
    cross(up, normal[3], right);
    make_unit(right);
    cross(normal[3], right, up);
    for (int k = 0; k < 3; k++) {
        const double angle = 2.0943951 * (k + between(-0.3, 0.3));
        for (int i = 0; i < 3; i++)
            corner[k][i] = centre[i] + radius * (cos(angle) * right[i] + sin(angle) * up[i]);
        make_normal(s, kind, corner[k], normal[k]);
        for (int c = 0; c < 3; c++)
            s->colours[k][c] = (uint8_t)between(100, 255.9);
    }
    s->mesh = (glint_mesh){.positions = (const int16_t(*)[3])s->positions,
                           .normals = (const int16_t(*)[3])s->normals,
                           .triangles = triangle,
                           .colours = seed & 32 ? (const uint8_t(*)[3])s->colours : NULL,
                           .flags = seed & 64 ? GLINT_MESH_DOUBLE_SIDED : 0,
                           .vertex_count = 3,
                           .triangle_count = 1};
    set_mesh(s, corner, normal);
}

/* ---- Suites ---- */

static const double exponents[] = {0, 0.5, 1, 1.5, 2, 3, 8, 32, 128, 512, 1024, 4096, 16384, 32767};

/* GLINT_CORNERS sets how many pictures a row has. */
static void judge_row(const char *where, const glint_evaluation *evaluation, light_kind kind, const char *name,
                      const glint_shading_model *model, double exponent, uint32_t pictures) {
    judgement found = {0};
    char line[160];
    for (uint32_t seed = 0; seed < pictures; seed++) {
        stage s;
        make_stage(&s, seed, kind, exponent, model, evaluation);
        const judge_task task = {.scene = &s.scene,
                                 .width = SIZE,
                                 .height = SIZE,
                                 .format = &glint_format_rgb888,
                                 .leave_out_gates = 1,
                                 .fine = 0.75};
        judge(&task, &found);
    }
    const double judged = (double)(found.judged ? found.judged : 1);
    const double rms = sqrt(found.squares / (double)(found.samples ? found.samples : 1)) * 255;
    snprintf(line, sizeof line, "%-7s %-12s %-12s %8.1f %8ld %6.3f %7.3f %8.3f %8.4f %8.4f\n", where, name,
             light_names[kind], exponent, found.judged, rms, found.worst, 100 * (double)found.not_fine / judged,
             100 * (double)found.over_one / judged, 100 * (double)found.over_two / judged);
    test_write(line);
    CHECK_EQUAL(found.status, GLINT_OK);
    CHECK(found.judged > 0);
    CHECK_EQUAL(found.missed, 0);
    if (exponent <= 4096) {
        CHECK_EQUAL(found.over_one, 0);
    } else { /* there a unit vector's step of 2^-15 is a level of 8 bits */
        CHECK_AT_MOST(found.over_one, found.judged / 20);
        CHECK_AT_MOST(found.over_two, found.judged / 200);
    }
}

static void judge_all(const char *where, const glint_evaluation *evaluation) {
    const char *wanted = getenv("GLINT_CORNERS");
    const uint32_t pictures = wanted ? (uint32_t)atoi(wanted) : 96;
    test_write("at      model        light               p   judged    rms   worst  > .75 %     > 1 %     > 2 %\n");
    for (int kind = DIRECTIONAL; kind <= SPOT; kind++) {
        judge_row(where, evaluation, (light_kind)kind, "lambert", &glint_model_lambert, 1, pictures);
        for (unsigned i = 0; i < TEST_COUNT(exponents); i++) {
            judge_row(where, evaluation, (light_kind)kind, "phong", &glint_model_phong, exponents[i], pictures);
            judge_row(where, evaluation, (light_kind)kind, "blinn-phong", &glint_model_blinn_phong, exponents[i],
                      pictures);
        }
    }
}

static void vertices(void) {
    judge_all("vertex", &glint_per_vertex);
}

static void facets(void) {
    judge_all("facet", &glint_per_facet);
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(vertices), TEST_CASE(facets)};
    return test_run(write, cases, TEST_COUNT(cases));
}
