/* SPDX-License-Identifier: MIT */
#include "identity.h"

#include "frames.h"
#include "scenes/scenes.h"
#include "text.h"

static const identity_format formats[] = {
    {"grey4", &glint_format_grey4},         {"grey8", &glint_format_grey8},   {"rgb565", &glint_format_rgb565},
    {"rgb565_be", &glint_format_rgb565_be}, {"rgb888", &glint_format_rgb888},
};

enum { FORMATS = sizeof formats / sizeof formats[0], WIDEST = FORMATS - 1 };

static const identity_format dithered[FORMATS] = {
    {"grey4 dithered", &glint_format_grey4_dithered},   {"grey8 dithered", &glint_format_grey8_dithered},
    {"rgb565 dithered", &glint_format_rgb565_dithered}, {"rgb565_be dithered", &glint_format_rgb565_be_dithered},
    {"rgb888 dithered", &glint_format_rgb888_dithered},
};

/* Where a scene is lit, when not where it says itself. */
static const struct {
    const char *name;
    const glint_evaluation *evaluation;
} evaluations[] = {
    {"fragment", &glint_per_fragment},
    {"vertex", &glint_per_vertex},
    {"facet", &glint_per_facet},
};

static const struct {
    const char *name;
    const glint_light_type *type;
} lights[] = {
    {"directional", &glint_light_directional},
    {"point", &glint_light_point},
    {"spot", &glint_light_spot},
};

enum { EVALUATIONS = sizeof evaluations / sizeof evaluations[0], LIGHTS = sizeof lights / sizeof lights[0] };

static const uint16_t tile_sizes[] = {8, 16, 32, 64};

static example_stage stage;

static void write_number(void (*write)(const char *text), uint32_t number) {
    char digits[TEXT_NUMBER_SIZE];

    write(text_number(digits, number));
}

static void write_hex(void (*write)(const char *text), uint32_t number) {
    char digits[9];

    for (int i = 0; i < 8; i++) {
        digits[i] = "0123456789abcdef"[number >> (28 - 4 * i) & 15u];
    }
    digits[8] = '\0';
    write(digits);
}

/* The second and the last part of a line. @return 1 when drawing failed; 0 too when the arena here is too small */
static int write_drawn(void (*write)(const char *text), const frame_options *options, glint_status status,
                       uint32_t sum) {
    write(" | tile ");
    write_number(write, options->tile_width);
    write("x");
    write_number(write, options->tile_height);
    write(options->smallest ? " smallest | " : " best | ");
    if (status == GLINT_OK) {
        write_hex(write, sum);
    } else {
        write(status == GLINT_ERROR_ARENA ? "does not fit" : glint_strerror(status));
    }
    write("\n");
    return status != GLINT_OK && status != GLINT_ERROR_ARENA;
}

static int draw(void (*write)(const char *text), turntable_model model, uint32_t frame, const identity_format *format,
                frame_options options) {
    uint32_t sum;

    options.format = format->format;
    write(turntable_name(model));
    write(" ");
    write_number(write, frame);
    write(" ");
    write(format->name);
    const glint_status status = frame_sum(&sum, model, frame, &options);
    return write_drawn(write, &options, status, sum);
}

/* One frame in every tile size, or in square ones only, with the largest and the smallest arena. */
static int draw_tiles(void (*write)(const char *text), turntable_model model, uint32_t frame,
                      const identity_format *format, int square) {
    int failed = 0;

    for (int i = 0; i < 32; i++) {
        const frame_options options = {NULL, tile_sizes[i & 3], tile_sizes[i >> 2 & 3], i >> 4, NULL, NULL};
        if (!square || options.tile_width == options.tile_height) {
            failed += draw(write, model, frame, format, options);
        }
    }
    return failed;
}

/* ---- Example scenes ---------------------------------------------------------------------------------------------- */

static int draw_stage(void (*write)(const char *text), const identity_format *format, frame_options options) {
    uint32_t sum;

    options.format = format->format;
    write(" ");
    write(format->name);
    const glint_status status = frame_sum_scene(&sum, &stage.scene, &options);
    return write_drawn(write, &options, status, sum);
}

/* One frame of each variant of each scene. */
static int draw_variants(void (*write)(const char *text)) {
    frame_options options = {NULL, 0, 0, 0, NULL, NULL};
    int failed = 0;

    for (int i = 0; i < EXAMPLE_SCENES; i++) {
        const example_scene *scene = example_scenes[i];
        for (uint32_t variant = 0; variant < scene->variant_count; variant++) {
            scene->build(&stage, variant, scene->frames / 3);
            write(scene->name);
            write(" ");
            write(scene->variants[variant].name);
            options.layers = stage.layers;
            options.samples = stage.samples;
            failed += draw_stage(write, &formats[WIDEST], options);
        }
    }
    return failed;
}

/* The torus of the teapot's scene under one light of a type, above it, lit where `evaluation` says. */
static void build_lit(int light, int evaluation) {
    glint_light *lamp = &stage.lights[0];

    example_teapot.build(&stage, 0, 5);
    lamp->type = lights[light].type;
    if (lamp->type != &glint_light_directional) { /* nearer, nodes are no fewer than fragments */
        lamp->direction = (glint_vector){GLINT_Q16(0.2), -GLINT_ONE, GLINT_Q16(-0.8)};
        lamp->position = (glint_vector){GLINT_Q16(-0.9), GLINT_Q16(2.4), GLINT_Q16(2.2)};
    }
    lamp->linear = GLINT_Q16(0.1);
    lamp->quadratic = GLINT_Q16(0.05);
    lamp->inner = GLINT_Q16(20);
    lamp->outer = GLINT_Q16(60);
    stage.scene.objects = &stage.objects[1];
    stage.scene.object_count = 1;
    stage.objects[1].evaluation = evaluations[evaluation].evaluation;
}

static int draw_lit(void (*write)(const char *text), int light, int evaluation, const identity_format *format,
                    frame_options options) {
    build_lit(light, evaluation);
    write(lights[light].name);
    write(" ");
    write(evaluations[evaluation].name);
    return draw_stage(write, format, options);
}

/* Each type of light lit in each place, and tile sizes and dithered formats lit in each. */
static int draw_lights(void (*write)(const char *text)) {
    const frame_options usual = {NULL, 0, 0, 0};
    int failed = 0;

    for (int i = 0; i < LIGHTS * EVALUATIONS; i++) {
        failed += draw_lit(write, i / EVALUATIONS, i % EVALUATIONS, &formats[WIDEST], usual);
    }
    for (int i = 0; i < 2 * EVALUATIONS * 4; i++) {
        const frame_options options = {NULL, tile_sizes[i & 3], tile_sizes[(i + i / 4) & 3], i >= EVALUATIONS * 4};
        failed += draw_lit(write, i % LIGHTS, i / 4 % EVALUATIONS, &dithered[WIDEST], options);
    }
    for (int format = 0; format < FORMATS; format++) {
        failed += draw_lit(write, format % LIGHTS, format % EVALUATIONS, &dithered[format], usual);
    }
    return failed;
}

int identity_run_turntable(void (*write)(const char *text), const identity_format *chosen, int count) {
    const identity_format *widest = &chosen[count - 1];
    int failed = 0;

    for (int model = 0; model < TURNTABLE_SHOWN; model++) {
        const frame_options options = {NULL, 0, 0, 0};
        for (uint32_t frame = 0; frame < TURNTABLE_FRAMES; frame++) {
            failed += draw(write, (turntable_model)model, frame, widest, options);
        }
        for (int format = 0; format < count - 1; format++) {
            failed += draw(write, (turntable_model)model, 5, &chosen[format], options);
        }
        /* the smallest arena means hundreds of passes over the larger mesh: there, square tiles are enough */
        failed += draw_tiles(write, (turntable_model)model, 5, widest, model == TURNTABLE_TEAPOT);
    }
    return failed;
}

int identity_run(void (*write)(const char *text)) {
    return identity_run_turntable(write, formats, FORMATS) + draw_variants(write) + draw_lights(write);
}
