/* SPDX-License-Identifier: MIT */
/*
 * Suite: every lighting model under every kind of light, evaluated per fragment, per vertex and per facet, against
 * the double-precision reference. Light weights sum to 1. A row stands for both viewers and all exponents.
 */
#include "bench.h"
#include "glint.h"
#include "harness.h"
#include "rows.h"
#include "scenes.h"
#include "scenes/scenes.h"
#include "stability/contract.h"
#include "surfaces.h"

#include <stdio.h>

#define WIDTH 160
#define HEIGHT 120

/* ---- What is combined ---------------------------------------------------------------------------------------- */

typedef struct model_kind {
    const char *name;
    const glint_shading_model *model;
    uint32_t flags;
    int exponents; /* how many of them, 0 when the model has none */
    int is_bright; /* ambient light alone is more than pixels hold */
} model_kind;

static const double exponents[] = {0.5, 1, 4, 50, 100, 1024};

static const model_kind models[] = {
    {"lambert", &glint_model_lambert, 0, 0, 0},
    {"phong", &glint_model_phong, 0, 6, 0},
    {"blinn-phong", &glint_model_blinn_phong, 0, 6, 0},
    {"unlit", &glint_model_unlit, 0, 0, 0},
    {"phong ungated", &glint_model_phong, GLINT_MATERIAL_SPECULAR_UNGATED, 6, 0},
    {"blinn ungated", &glint_model_blinn_phong, GLINT_MATERIAL_SPECULAR_UNGATED, 6, 0},
    {"lambert max", &glint_model_lambert, GLINT_MATERIAL_MAX_WITH_AMBIENT, 0, 0},
    {"phong max", &glint_model_phong, GLINT_MATERIAL_MAX_WITH_AMBIENT, 3, 0},
    {"blinn max ungated", &glint_model_blinn_phong, GLINT_MATERIAL_MAX_WITH_AMBIENT | GLINT_MATERIAL_SPECULAR_UNGATED,
     3, 0},
    {"lambert bright", &glint_model_lambert, 0, 0, 1},
    {"lambert max bright", &glint_model_lambert, GLINT_MATERIAL_MAX_WITH_AMBIENT, 0, 1},
    {"blinn max bright", &glint_model_blinn_phong, GLINT_MATERIAL_MAX_WITH_AMBIENT, 1, 1},
};

typedef struct evaluation_kind {
    const char *name;
    const glint_evaluation *const *evaluation;
} evaluation_kind;

static const glint_evaluation *const fragment = &glint_per_fragment;
static const glint_evaluation *const vertex = &glint_per_vertex;
static const glint_evaluation *const facet = &glint_per_facet;
static const evaluation_kind evaluations[] = {{"fragment", &fragment}, {"vertex", &vertex}, {"facet", &facet}};

/* Places are relative to the middle between the two objects; a directional light comes from there. */
typedef struct light_kind {
    const char *name;
    const glint_light_type *type;
    double place[3];
    double linear, quadratic;
    double inner, outer;
} light_kind;

static const light_kind lights[] = {
    {"directional", &glint_light_directional, {0.4, 0.6, 0.7}, 0, 0, 0, 0},
    {"point far", &glint_light_point, {4, 6, 5}, 0, 0, 0, 0},
    {"point near", &glint_light_point, {0.9, 0.9, 1.1}, 0.2, 0.1, 0, 0},
    {"point between", &glint_light_point, {0.1, 0.5, 0.2}, 0.5, 0, 0, 0},
    {"point faint", &glint_light_point, {0.9, 0.9, 1.1}, 8000, 30000, 0, 0},
    {"spot soft", &glint_light_spot, {0.5, 1, 2}, 0.1, 0, 10, 25},
    {"spot hard", &glint_light_spot, {0.5, 1, 2}, 0, 0.1, 15, 15},
    {"spot all round", &glint_light_spot, {0.9, 0.9, 1.1}, 0, 0, 0, 180},
};

/* ---- Scene --------------------------------------------------------------------------------------------------- */

static glint_colour colour(double r, double g, double b) {
    return (glint_colour){bench_q16(r), bench_q16(g), bench_q16(b)};
}

static glint_vector vector(double x, double y, double z) {
    return (glint_vector){bench_q16(x), bench_q16(y), bench_q16(z)};
}

/* A torus with a small sphere before it. */
static void build_objects(test_scene *scene) {
    scene_build_named(scene, "interlocked");
    scene->objects[1].mesh = &scene_bench_mesh(3)->mesh;
    scene->objects[1].pose = glint_pose_scale(GLINT_ONE / 2, GLINT_ONE / 2, GLINT_ONE / 2);
    for (int row = 0; row < 2; row++)
        scene->objects[row].pose.m[0][3] = scene->objects[row].pose.m[1][3] = 0;
    scene->objects[0].mesh = &scene_bench_mesh(1)->mesh;
    scene->objects[0].pose.m[2][3] = bench_q16(-3.7);
    scene->objects[1].pose.m[0][3] = bench_q16(0.6);
    scene->objects[1].pose.m[1][3] = bench_q16(-0.5);
    scene->objects[1].pose.m[2][3] = bench_q16(-3);
    scene->scene.ambient = colour(1, 1, 1);
    scene->scene.light_count = 1;
}

static void set_model(test_scene *scene, const model_kind *model, double exponent) {
    for (uint32_t i = 0; i < scene->scene.object_count; i++) {
        glint_material *material = &scene->materials[i];
        material->model = model->model;
        material->flags = model->flags;
        material->shininess = bench_q16(exponent);
        material->ambient = model->is_bright ? colour(2.5, 1.1, 0.7) : colour(0.1, 0.08, 0.05);
        material->diffuse = i ? colour(0.2, 0.4, 0.5) : colour(0.5, 0.35, 0.2);
        material->specular = colour(0.4, 0.4, 0.3);
    }
}

static void set_light(test_scene *scene, const light_kind *kind) {
    const double *v = kind->place;
    scene->lights[0] = (glint_light){.type = kind->type,
                                     .position = vector(v[0], v[1], v[2] - 3.5),
                                     .direction = vector(-v[0], -v[1], -v[2]),
                                     .diffuse = colour(1, 1, 1),
                                     .specular = colour(1, 1, 1),
                                     .linear = bench_q16(kind->linear),
                                     .quadratic = bench_q16(kind->quadratic),
                                     .inner = bench_q16(kind->inner),
                                     .outer = bench_q16(kind->outer)};
}

static void set_evaluation(test_scene *scene, const evaluation_kind *evaluation) {
    for (uint32_t i = 0; i < scene->scene.object_count; i++)
        scene->objects[i].evaluation = *evaluation->evaluation;
}

/* ---- Rows ---------------------------------------------------------------------------------------------------- */

/* Both viewers and all exponents that make a difference. */
static void judge_row(const char *name, test_scene *scene, const model_kind *model, const evaluation_kind *evaluation) {
    judgement total = {0};
    set_evaluation(scene, evaluation);
    for (int i = 0; i < model->exponents || i == 0; i++) {
        set_model(scene, model, exponents[i]);
        for (int viewer = 0; viewer < (model->exponents ? 2 : 1); viewer++) {
            scene->scene.viewer = (glint_viewer)viewer;
            row_judge(&scene->scene, WIDTH, HEIGHT, &glint_format_rgb565, &total);
        }
    }
    row_print(name, &total);
    row_check(&total, row_is_per_fragment(&scene->scene));
    CHECK(total.gated * 50 < total.covered);
}

static void judge_models(const evaluation_kind *evaluation) {
    row_print_heading();
    for (unsigned light = 0; light < TEST_COUNT(lights); light++) {
        for (unsigned model = 0; model < TEST_COUNT(models); model++) {
            test_scene scene;
            char name[80];
            build_objects(&scene);
            set_light(&scene, &lights[light]);
            snprintf(name, sizeof name, "%s, %s, per %s", lights[light].name, models[model].name, evaluation->name);
            judge_row(name, &scene, &models[model], evaluation);
        }
    }
}

static void models_per_fragment(void) {
    judge_models(&evaluations[0]);
}

static void models_per_vertex(void) {
    judge_models(&evaluations[1]);
}

static void models_per_facet(void) {
    judge_models(&evaluations[2]);
}

/* ---- Surfaces and lights that are hard ----------------------------------------------------------------------- */

static void judge_surface(const scene_definition *definition, const evaluation_kind *evaluation) {
    const glint_shading_model *const kinds[] = {&glint_model_blinn_phong, &glint_model_phong};
    judgement total = {0};
    char name[80];
    for (int i = 0; i < 4; i++) {
        test_scene scene;
        definition->build(&scene);
        set_evaluation(&scene, evaluation);
        if (scene.materials[0].model != &glint_model_unlit)
            scene.materials[0].model = kinds[i / 2];
        scene.scene.viewer = (glint_viewer)(i % 2);
        row_judge(&scene.scene, 2 * WIDTH, 2 * HEIGHT, &glint_format_rgb565, &total);
    }
    snprintf(name, sizeof name, "%s, per %s", definition->name, evaluation->name);
    row_print(name, &total);
    row_check(&total, evaluation == &evaluations[0]);
    CHECK(total.gated * 50 < total.covered);
}

static void surfaces(void) {
    row_print_heading();
    for (unsigned i = 0; i < surface_count; i++) {
        for (unsigned k = 0; k < TEST_COUNT(evaluations); k++)
            judge_surface(&surface_definitions[i], &evaluations[k]);
    }
}

/* All kinds together; the bounds hold over all of them. */
static void random_scenes(void) {
    judgement total = {0};
    for (uint32_t seed = 1; seed <= 600; seed++) {
        test_scene scene;
        surface_build_random(&scene, seed);
        row_judge(&scene.scene, WIDTH, HEIGHT, &glint_format_rgb565, &total);
    }
    row_print_heading();
    row_print("600 random scenes", &total);
    row_check(&total, 1);
}

/* ---- Every variant of every example scene, as composed: each frame keeps the contract, by the pixels that count ----
 */

/* The first frame, and one past the middle of a scene that moves. */
static void judge_variant(const example_scene *scene, uint32_t variant, const glint_format *format) {
    static example_stage stage;
    judgement total = {0};
    char name[80];
    for (uint32_t frame = 0; frame < scene->frames; frame += scene->frames / 2 + 1) {
        contract_result result;
        scene->build(&stage, variant, frame);
        contract_judge(&stage.scene, scene->width, scene->height, format, &result);
        CHECK(contract_holds(&result));
        judgement_add(&total, &result.found);
    }
    snprintf(name, sizeof name, "%s %s, %s", scene->name, scene->variants[variant].name,
             format == &glint_format_rgb565 ? "RGB565" : "RGB888");
    row_print(name, &total);
    row_check(&total, row_is_per_fragment(&stage.scene));
    CHECK(total.gated * 50 < total.covered);
}

static void gallery(void) {
    row_print_heading();
    for (unsigned i = 0; i < EXAMPLE_SCENES; i++) {
        CHECK(example_scenes[i]->variant_count > 0);
        for (uint32_t variant = 0; variant < example_scenes[i]->variant_count; variant++) {
            judge_variant(example_scenes[i], variant, &glint_format_rgb565);
            judge_variant(example_scenes[i], variant, &glint_format_rgb888);
        }
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(models_per_fragment), TEST_CASE(models_per_vertex), TEST_CASE(models_per_facet), TEST_CASE(surfaces),
        TEST_CASE(random_scenes),       TEST_CASE(gallery),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
