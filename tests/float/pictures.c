/* SPDX-License-Identifier: MIT */
/*
 * Suite: pictures of the float renderer that frames are compared with, against the double-precision reference, for
 * each workload of the benchmark in RGB565. Its coverage is judged for the vertices as it snapped them, its colours by
 * PSNR over covered pixels: what is lit per vertex or per facet is held against a reference that is lit so too.
 *
 * All frames are drawn here; with GLINT_FLOAT_PICTURES the first ones are read from that file, in which
 * pictures_board.c's are kept.
 */
#include "draw.h"
#include "harness.h"
#include "reference.h"
#include "renderer.h"
#include "workloads.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PIXELS (320 * 240)

/* Decibels. RGB565 itself allows about 42. */
#define PSNR_LEAST 41.0

/*
 * Of covered pixels, those whose centre an edge passes so near that a sum of floats decides: drawn where nothing is, or
 * the other way about, or in the colour of the triangle beyond the edge, which is off by more than WRONG_COLOUR.
 */
#define MISSED_SHARE 1000
#define WRONG_COLOUR 0.125

typedef struct found {
    long covered, missed, samples;
    double squares; /* of errors, levels as 0..1 */
} found;

static uint16_t colour[PIXELS];
static int32_t depth[PIXELS];
static float_memory memory;
static reference_pixel exact[PIXELS];

/* ---- Vertices as they are drawn ---- */

static reference_position position_of(const float_vertex *vertex) {
    const double column = 0.5 - 1.0 / 4096; /* what a vertex's x is shifted by */

    return (reference_position){(int32_t)lrint(16 * (vertex->x - column)), (int32_t)lrint(16 * (double)vertex->y),
                                vertex->inverse_w > 0};
}

/* @return an array of the object's positions, the caller's to free; null when none of it can be seen */
static reference_position *snap(const float_frame *frame, const glint_object *object) {
    static float_draw draw;
    const uint32_t count = object->mesh->vertex_count;
    reference_position *positions = malloc(count * sizeof *positions);

    draw = (float_draw){.frame = frame, .object = object, .side = 1};
    float_prepare_object(&draw);
    const float_whereabouts where = float_locate(&draw);
    if (where == FLOAT_OUTSIDE || !positions) {
        free(positions);
        return NULL;
    }
    float_transform(&draw, where);
    for (uint32_t i = 0; i < count; i++)
        positions[i] = position_of(&memory.vertices[i]);
    return positions;
}

static void draw_reference(const float_screen *screen, const glint_scene *scene) {
    const reference_image image = {(int)screen->width, (int)screen->height, exact};
    static reference_position *positions[BOXES_MAX];
    float_frame frame = {.screen = screen, .memory = &memory, .scene = scene};

    if (scene->object_count > BOXES_MAX)
        abort();
    float_prepare_frame(&frame);
    for (uint32_t i = 0; i < scene->object_count; i++)
        positions[i] = snap(&frame, &scene->objects[i]);
    reference_render(&image, scene, (const reference_position *const *)positions);
    for (uint32_t i = 0; i < scene->object_count; i++)
        free(positions[i]);
}

/* ---- Pictures of a board ---- */

static FILE *kept;

/* @return whether the next picture of the file is whole */
static int read_picture(const float_screen *screen) {
    for (uint32_t i = 0; i < screen->width * screen->height; i++) {
        char digits[5], *end;

        if (fscanf(kept, "%4s", digits) != 1)
            return 0;
        screen->colour[i] = (uint16_t)strtoul(digits, &end, 16);
        screen->depth[i] = end != digits;
        if (end != digits + 4 && strcmp(digits, "----") != 0)
            return 0;
    }
    return 1;
}

/* ---- Pixels ---- */

static double squares_of(const double errors[3]) {
    return errors[0] * errors[0] + errors[1] * errors[1] + errors[2] * errors[2];
}

static void errors_of(uint16_t pixel, const double wanted[3], double errors[3]) {
    const double levels[3] = {(pixel >> 11) / 31.0, (pixel >> 5 & 63) / 63.0, (pixel & 31) / 31.0};

    for (int channel = 0; channel < 3; channel++)
        errors[channel] = fabs(levels[channel] - wanted[channel]);
}

static void compare(const float_screen *screen, found *total) {
    for (uint32_t i = 0; i < screen->width * screen->height; i++) {
        const reference_pixel *pixel = &exact[i];
        const int drawn = depth[i] > 0;
        double errors[3];

        if (pixel->uncertain)
            continue;
        errors_of(colour[i], pixel->colour, errors);
        total->covered += pixel->covered;
        if (drawn != pixel->covered || (drawn && fmax(errors[0], fmax(errors[1], errors[2])) > WRONG_COLOUR)) {
            total->missed++;
        } else if (drawn) {
            total->squares += squares_of(errors);
            total->samples += 3;
        }
    }
}

static void report(const char *name, const char *look, const float_screen *screen, const found *total) {
    const double psnr = -10 * log10(total->squares / (double)total->samples);
    char line[200];

    snprintf(line, sizeof line, "%-16s %-40s %3ux%-3u %8ld covered %5ld missed %6.2f dB\n", name, look,
             (unsigned)screen->width, (unsigned)screen->height, total->covered, total->missed, psnr);
    test_write(line);
    CHECK(total->samples > 0);
    CHECK(psnr >= PSNR_LEAST);
    CHECK_AT_MOST(total->missed * MISSED_SHARE, total->covered);
}

/* ---- Workloads ---- */

static workload_stage stage;

static void judge_workload(const workload *drawn) {
    const float_screen screen = {drawn->width, drawn->height, colour, depth};
    const uint32_t frames = drawn->example || kept ? 1 : drawn->frames; /* example scenes stand still */
    found total = {0};

    if (!CHECK_EQUAL(workload_build(&stage, drawn), 0))
        return;
    for (uint32_t frame = 0; frame < frames; frame++) {
        workload_set_frame(&stage, frame);
        draw_reference(&screen, &stage.example.scene);
        if (!kept)
            float_render(&screen, &memory, &stage.example.scene);
        else if (!CHECK(read_picture(&screen)))
            return;
        compare(&screen, &total);
    }
    report(drawn->scene, drawn->look, &screen, &total);
}

/* ---- Kernels ---- */

/* A way to change the material and the mesh. */
typedef struct option {
    const char *name;
    uint32_t flags;
    int coloured;
    glint_q16 shininess;
} option;

static const option options[] = {
    {"", 0, 0, GLINT_Q16(32)},
    {"colours", 0, 1, GLINT_Q16(32)},
    {"max", GLINT_MATERIAL_MAX, 0, GLINT_Q16(32)},
    {"ungated", GLINT_MATERIAL_UNGATED, 0, GLINT_Q16(12)},
    {"p 0.5", 0, 0, GLINT_Q16(0.5)},
    {"p 0", 0, 0, 0},
    {"all", GLINT_MATERIAL_UNGATED | GLINT_MATERIAL_MAX, 1, GLINT_Q16(1.5)},
};

static const struct {
    const char *name;
    const glint_model *model;
} models[] = {
    {"lambert", &glint_model_lambert},
    {"phong", &glint_model_phong},
    {"blinn-phong", &glint_model_blinn_phong},
};

static void change(const option *to, const glint_model *model) {
    static uint8_t colours[FLOAT_VERTICES_MAX][3];
    glint_material *material = &stage.example.materials[0];

    material->model = model;
    material->flags = to->flags;
    material->shininess = to->shininess;
    for (uint32_t i = 0; i < stage.mesh.vertex_count; i++)
        for (uint32_t channel = 0; channel < 3; channel++)
            colours[i][channel] = (uint8_t)(255 - (i * (channel + 3) & 127));
    stage.mesh.colours = to->coloured ? (const uint8_t(*)[3])colours : NULL;
}

/* Draws a workload changed: by an option and a model, for either viewer; cut open, it is double-sided. */
static void judge_changed(const workload *drawn, const option *to, int model, glint_viewer viewer, int cut) {
    const float_screen screen = {drawn->width, drawn->height, colour, depth};
    char look[100];
    found total = {0};

    if (!CHECK_EQUAL(workload_build(&stage, drawn), 0))
        return;
    change(to, models[model].model);
    stage.example.scene.viewer = viewer;
    if (cut) {
        stage.example.scene.camera.near_plane = GLINT_Q16(3.2);
        stage.mesh.flags = GLINT_MESH_DOUBLE_SIDED;
    }
    draw_reference(&screen, &stage.example.scene);
    float_render(&screen, &memory, &stage.example.scene);
    compare(&screen, &total);
    snprintf(look, sizeof look, "%s %s %s %s %s", drawn->look, models[model].name, to->name,
             viewer == GLINT_VIEWER_LOCAL ? "local" : "infinite", cut ? "cut" : "");
    report(drawn->scene, look, &screen, &total);
}

/* Every model and option for either viewer. */
static void judge_kernels(const workload *drawn) {
    for (int model = 0; model < 3; model++) {
        for (unsigned i = 0; i < TEST_COUNT(options); i++) {
            judge_changed(drawn, &options[i], model, GLINT_VIEWER_LOCAL, 0);
            judge_changed(drawn, &options[i], model, GLINT_VIEWER_INFINITE, 0);
        }
    }
    judge_changed(drawn, &options[0], 2, GLINT_VIEWER_LOCAL, 1);
    judge_changed(drawn, &options[1], 1, GLINT_VIEWER_LOCAL, 1);
}

/* ---- Cases ---- */

/* Workloads in RGB565 of a part of the list. */
static void judge_all(uint32_t first, uint32_t end) {
    uint32_t judged = 0;

    for (uint32_t i = first; i < end; i++) {
        const workload drawn = workload_get(i);
        if (*drawn.output->name == '\0') {
            judge_workload(&drawn);
            judged++;
        }
    }
    CHECK(judged > 0);
}

static void benchmark_scenes(void) {
    judge_all(0, WORKLOADS_PLAIN);
}

static void other_workloads(void) {
    judge_all(WORKLOADS_PLAIN, workload_count());
}

static int is_one_of(const char *name, const char *const names[], unsigned count) {
    for (unsigned i = 0; i < count; i++)
        if (strcmp(name, names[i]) == 0)
            return 1;
    return 0;
}

/* Not only what workloads ask for: every kernel, on a small screen. */
static void every_kernel(void) {
    static const char *const looks[] = {"p 8",      "2 directional", "1 point",  "1 spot",
                                        "4 points", "per vertex",    "per facet"};
    unsigned judged = 0;

    for (uint32_t i = 0; i < workload_count(); i++) {
        const workload drawn = workload_get(i);
        if (drawn.width == 128 && strcmp(drawn.scene, "torus576") == 0 &&
            is_one_of(drawn.look, looks, TEST_COUNT(looks))) {
            judge_kernels(&drawn);
            judged++;
        }
    }
    CHECK_EQUAL(judged, TEST_COUNT(looks));
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(benchmark_scenes),
        TEST_CASE(other_workloads),
        TEST_CASE(every_kernel),
    };

    const char *path = getenv("GLINT_FLOAT_PICTURES");

    kept = path ? fopen(path, "r") : NULL;
    if (path && !kept) {
        write("the file of pictures cannot be read\n");
        return 1;
    }
    const int failed = test_run(write, cases, TEST_COUNT(cases) - (kept ? 1 : 0)); /* the board draws workloads */
    if (kept)
        fclose(kept);
    return failed;
}
