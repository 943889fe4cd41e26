/* SPDX-License-Identifier: MIT */
/*
 * Suite: the accuracy contract of RGB565 under one directional light.
 *
 * For p from 1 to 1024 and either viewer, in every frame: of its covered pixels 99.9%, or all but one where that is
 * more, are within 0.75 step of the unrounded reference in every channel where the light weights (diffuse + specular,
 * times the light's colour) sum to at most 1, and within 0.5 + 0.25 times that sum above it; 99.99%, or all but one,
 * are within one step of the rounded reference, and all within two. Pixels where N.L is 0 within rounding are left out.
 * Scenes under more lights, brighter and clipped ones too, are within one step.
 */
#include "bench.h"
#include "glint.h"
#include "harness.h"
#include "judge.h"
#include "random.h"
#include "rows.h"
#include "scenes.h"

#include <math.h>
#include <stdio.h>

static const int exponents[] = {1, 2, 3, 5, 8, 13, 32, 64, 100, 256, 600, 1024};

static double product(glint_q16 a, glint_q16 b) {
    return a / 65536.0 * (b / 65536.0);
}

/* What is fine by the contract, for a material under a light. */
static void set_contract(judge_task *task, const glint_material *material, const glint_light *light) {
    const glint_colour *d = &material->diffuse, *s = &material->specular;
    const int shines = material->model != &glint_model_lambert;
    const double sums[3] = {product(d->r, light->diffuse.r) + shines * product(s->r, light->specular.r),
                            product(d->g, light->diffuse.g) + shines * product(s->g, light->specular.g),
                            product(d->b, light->diffuse.b) + shines * product(s->b, light->specular.b)};
    for (int c = 0; c < 3; c++)
        task->fine_of[c] = 0.5 + 0.25 * fmax(1, sums[c]);
}

static void print_heading(void) {
    test_write("                                              covered   fine%  <= 1 step%  > 2    worst   psnr\n");
}

static void print_row(const char *name, const judgement *found) {
    char line[160];
    const double judged = (double)(found->judged ? found->judged : 1) / 100;
    snprintf(line, sizeof line, "%-44s %8ld %7.3f %11.4f %4ld %8.3f %6.2f\n", name, found->covered,
             100 - (double)found->not_fine / judged, 100 - (double)found->over_one / judged, found->over_two,
             found->worst, judgement_psnr(found));
    test_write(line);
}

/* Judges a frame by itself, prints it where it misses the contract, and adds it to others. */
static void judge_frame(const judge_task *task, const char *name, judgement *total) {
    judgement frame = {0};
    judge(task, &frame);
    if (!CHECK(judgement_keeps_contract(&frame)))
        print_row(name, &frame);
    judgement_add(total, &frame);
}

static void bench_scene_keeps(int which, int exponent, glint_viewer viewer, int width, int height) {
    judgement found = {0};
    char name[80], frame_name[100];
    snprintf(name, sizeof name, "%s %dx%d p = %d %s", bench_definitions[which].name, width, height, exponent,
             viewer == GLINT_VIEWER_LOCAL ? "local" : "infinite");
    for (int frame = 0; frame < 10; frame++) {
        bench_scene scene;
        judge_task task = {.width = width, .height = height, .format = &glint_format_rgb565, .leave_out_gates = 1};
        bench_build_scene(&scene, &bench_definitions[which], scene_bench_mesh(which), frame);
        scene.material.shininess = exponent * GLINT_ONE;
        scene.scene.viewer = viewer;
        set_contract(&task, &scene.material, &scene.light);
        task.scene = &scene.scene;
        snprintf(frame_name, sizeof frame_name, "  frame %d of %s", frame, name);
        judge_frame(&task, frame_name, &found);
    }
    print_row(name, &found);
    CHECK(found.judged > 0);
    CHECK_AT_MOST(found.over_one * 10000, found.judged); /* as README.md says */
    CHECK(found.gated * 4096 < found.covered);
    CHECK_EQUAL(found.uncertain, 0);
    CHECK(found.close * 500 < found.covered);
    CHECK(found.vertex_error <= 1.0 / 16);
    if (which == 0 && width == 320 && exponent == 32 && viewer == GLINT_VIEWER_LOCAL)
        CHECK(judgement_psnr(&found) >= 41.5);
}

static void bench_scenes(void) {
    print_heading();
    for (int which = 0; which < BENCH_SCENES; which++) {
        for (unsigned i = 0; i < TEST_COUNT(exponents); i++) {
            for (int viewer = 0; viewer < 2; viewer++) {
                bench_scene_keeps(which, exponents[i], viewer ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE, 320, 240);
                bench_scene_keeps(which, exponents[i], viewer ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE, 128, 64);
            }
        }
    }
}

/* ---- Scenes of all that a renderer gets wrong: no light is left out, of any number and brightness ---- */

static void scene_keeps(const scene_definition *definition, glint_viewer viewer, int width, int height) {
    judge_task task = {.width = width, .height = height, .format = &glint_format_rgb565, .fine = 0.75};
    judgement found = {0};
    test_scene scene;
    scene_build(&scene, definition);
    scene.scene.viewer = viewer;
    task.scene = &scene.scene;
    task.leave_out_gates = width == GLINT_SIZE_MAX && scene.materials[0].shininess == 0; /* the jump is full height */
    judge(&task, &found);
    row_print(definition->name, &found);
    row_check(&found, 1);
    if (task.leave_out_gates)
        CHECK(found.gated * 2048 < found.covered);
}

static void scenes(void) {
    row_print_heading();
    for (unsigned i = 0; i < scene_count; i++) {
        scene_keeps(&scene_definitions[i], GLINT_VIEWER_INFINITE, 320, 240);
        scene_keeps(&scene_definitions[i], GLINT_VIEWER_LOCAL, 320, 240);
    }
}

static void scenes_on_the_largest_screen(void) {
    row_print_heading();
    for (unsigned i = 0; i < scene_count; i++)
        scene_keeps(&scene_definitions[i], GLINT_VIEWER_LOCAL, GLINT_SIZE_MAX, GLINT_SIZE_MAX);
}

/* ---- Flat faces ---- */

/* A cube's sides, four corners and two triangles each; its corners lie on the unit sphere. */
static void build_cube(bench_mesh *cube) {
    static const int signs[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int side = 0; side < 6; side++) {
        const int axis = side / 2, out = side % 2 ? 1 : -1;
        for (int corner = 0; corner < 4; corner++) {
            int16_t *position = cube->positions[4 * side + corner], *normal = cube->normals[4 * side + corner];
            position[axis] = (int16_t)(18918 * out);
            position[(axis + 1) % 3] = (int16_t)(18918 * signs[corner][0]);
            position[(axis + 2) % 3] = (int16_t)(18918 * signs[corner][1] * out);
            normal[axis] = (int16_t)(32767 * out);
            normal[(axis + 1) % 3] = normal[(axis + 2) % 3] = 0;
        }
        for (int half = 0; half < 2; half++) {
            uint16_t *triangle = cube->triangles[2 * side + half];
            triangle[0] = (uint16_t)(4 * side);
            triangle[1] = (uint16_t)(4 * side + 1 + half);
            triangle[2] = (uint16_t)(4 * side + 2 + half);
        }
    }
    cube->mesh = (glint_mesh){.positions = (const int16_t(*)[3])cube->positions,
                              .normals = (const int16_t(*)[3])cube->normals,
                              .triangles = (const uint16_t(*)[3])cube->triangles,
                              .vertex_count = 24,
                              .triangle_count = 12,
                              .extent = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
}

static void cube_keeps(const bench_mesh *cube, int exponent, glint_viewer viewer) {
    judgement found = {0};
    char name[80];
    snprintf(name, sizeof name, "cube 128x64 p = %d %s", exponent, viewer == GLINT_VIEWER_LOCAL ? "local" : "infinite");
    for (int frame = 0; frame < 10; frame++) {
        bench_scene scene;
        judge_task task = {.width = 128, .height = 64, .format = &glint_format_rgb565, .leave_out_gates = 1};
        bench_build_scene(&scene, &bench_definitions[1], cube, frame);
        scene.material.shininess = exponent * GLINT_ONE;
        scene.scene.viewer = viewer;
        scene.object.pose.m[2][3] += frame % 2 * GLINT_ONE; /* every other one is near */
        set_contract(&task, &scene.material, &scene.light);
        task.scene = &scene.scene;
        judge_frame(&task, name, &found);
    }
    print_row(name, &found);
    CHECK_EQUAL(found.over_one, 0);
}

/* Faces that are large on a small screen: the local viewer's half vector bends over them. */
static void flat_faces(void) {
    static bench_mesh cube;
    build_cube(&cube);
    print_heading();
    for (unsigned i = 0; i < TEST_COUNT(exponents); i++) {
        cube_keeps(&cube, exponents[i], GLINT_VIEWER_INFINITE);
        cube_keeps(&cube, exponents[i], GLINT_VIEWER_LOCAL);
    }
}

/* ---- Random scenes ---- */

/* As between, every factor as likely as another. */
static double between_logs(double a, double b) {
    return exp(between(log(a), log(b)));
}

/* A colour, half of the time a grey. */
static glint_colour random_colour(double most) {
    const double r = between(0, most), g = between(0, most), b = between(0, most);
    if (between(0, 1) < 0.5)
        return (glint_colour){bench_q16(r), bench_q16(r), bench_q16(r)};
    return (glint_colour){bench_q16(r), bench_q16(g), bench_q16(b)};
}

/* From 1 to 1024, the widest that a table serves half of the time; some are whole numbers. */
static double random_exponent(void) {
    const double exponent = between(0, 1) < 0.5 ? between_logs(1, 1024) : between_logs(2, 8);
    return between(0, 1) < 0.25 ? floor(exponent) : exponent;
}

/* Objects of one material at random places, under one light that is white or coloured. */
static void build_random(test_scene *scene, uint32_t seed) {
    glint_material *const material = &scene->materials[0];
    glint_light *const light = &scene->lights[0];
    const glint_colour white = {GLINT_ONE, GLINT_ONE, GLINT_ONE};
    scene_build_random(scene, seed);
    random_state = seed * 2246822519u;
    scene->scene.light_count = 1;
    light->type = &glint_light_directional;
    light->direction.x = -bench_q16(between(-1, 1));
    light->direction.y = -bench_q16(between(-1, 1));
    light->direction.z = -bench_q16(between(-1, 1));
    light->diffuse = seed % 4 < 2 ? random_colour(1) : white;
    light->specular = seed % 4 < 2 ? random_colour(1) : white;
    material->model = seed % 8 == 3 ? &glint_model_lambert : &glint_model_blinn_phong;
    material->ambient = random_colour(0.3);
    material->diffuse = random_colour(between_logs(0.1, seed % 4 == 0 ? 2 : 1));
    material->specular = random_colour(between_logs(0.1, seed % 4 == 1 ? 3 : 1));
    material->shininess = bench_q16(random_exponent());
    for (uint32_t i = 0; i < scene->scene.object_count; i++) {
        scene->objects[i].material = material;
        scene->objects[i].mesh = &scene_bench_mesh((int)between(0, BENCH_SCENES))->mesh;
    }
}

static const int screens[][2] = {{160, 120}, {128, 64}, {240, 135}};

static void judge_random(uint32_t seed, judgement *found) {
    test_scene scene;
    judge_task task = {.width = screens[seed % 3][0],
                       .height = screens[seed % 3][1],
                       .format = &glint_format_rgb565,
                       .leave_out_gates = 1};
    char name[80];
    build_random(&scene, seed);
    set_contract(&task, &scene.materials[0], &scene.lights[0]);
    task.scene = &scene.scene;
    snprintf(name, sizeof name, "  scene %u, p = %.1f", seed, scene.materials[0].shininess / 65536.0);
    judge_frame(&task, name, found);
}

/*
 * Of tens of thousands, those that missed the contract by most with wider limits: for planes and for quadratics, by
 * the turn of normals, by 1/w and by the half vector, at low and at high p; and slivers whose normals turn so far that
 * slopes wrapped.
 */
static const uint32_t hard_seeds[] = {24,    197,   364,    569,    1409,   1495,  2349,  3098,
                                      3465,  3839,  3961,   5149,   10377,  11737, 22733, 29271,
                                      30505, 32498, 103736, 110885, 112902, 22662, 26119};

static void hard_scenes(void) {
    judgement found = {0};
    for (unsigned i = 0; i < TEST_COUNT(hard_seeds); i++)
        judge_random(hard_seeds[i], &found);
    print_row("the hardest scenes", &found);
    CHECK(found.judged > 0);
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(bench_scenes), TEST_CASE(scenes),
                                      TEST_CASE(scenes_on_the_largest_screen), TEST_CASE(flat_faces),
                                      TEST_CASE(hard_scenes)};
    return test_run(write, cases, TEST_COUNT(cases));
}
