/* SPDX-License-Identifier: MIT */
/**
 * @file side.c
 * The text beside the picture: what is set, and what the frame took.
 */
#include "window.h"

#include "values.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const uint8_t ink[3] = {225, 228, 235}, dim[3] = {150, 155, 168}, mark[3] = {255, 200, 60},
                     rail[3] = {70, 72, 82};

/** Characters that a line has room for. */
#define LINE_SIZE 31

/** Where the next line goes. */
typedef struct writer {
    const label_picture *canvas;
    int x, y;
} writer;

static void print(writer *to, const uint8_t *colour, const char *format, ...) PROBLEM_PRINTF(3, 4);

static void print(writer *to, const uint8_t *colour, const char *format, ...) {
    char text[LINE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    label_text(to->canvas, text, to->x, to->y, 2, colour);
    to->y += 2 * LABEL_LINE;
}

static void print_title(writer *to, const char *title) {
    to->y += LABEL_LINE;
    print(to, mark, "%s", title);
}

/* ---- What is set ------------------------------------------------------------------------------------------------ */

static void print_panel(writer *to, const window_state *state) {
    const host_settings *settings = &state->settings;
    const unsigned width = settings->tile_width > 0 ? settings->tile_width : 32;
    const unsigned height = settings->tile_height > 0 ? settings->tile_height : 32;
    const char *slash = strrchr(state->name, '/');
    print(to, mark, "%s", slash != NULL ? slash + 1 : state->name);
    print(to, ink, "%ux%u %s%s", settings->width, settings->height, settings->format->name,
          settings->dither ? " dithered" : "");
    print(to, ink, "tiles of %ux%u", width, height);
    if (!state->has_model && state->scene->frames > 1) {
        print(to, ink, "frame %lu of %lu", (unsigned long)state->frame, (unsigned long)state->scene->frames);
    }
}

/** The first object that light falls on, or the first of all; null for none. */
static const glint_object *find_lit(const glint_scene *scene) {
    for (uint32_t i = 0; i < scene->object_count; i++) {
        if (scene->objects[i].material->model != &glint_model_unlit && !scene->objects[i].hidden) {
            return &scene->objects[i];
        }
    }
    return scene->object_count > 0 ? &scene->objects[0] : NULL;
}

static const char *name_model(const glint_shading_model *model) {
    return model == &glint_model_lambert ? "Lambert"
           : model == &glint_model_phong ? "Phong"
           : model == &glint_model_unlit ? "unlit"
                                         : "Blinn-Phong";
}

static const char *name_place(const glint_evaluation *evaluation) {
    return evaluation == &glint_per_facet ? "flat" : evaluation == &glint_per_vertex ? "per vertex" : "per fragment";
}

static const char *name_kind(const glint_light *light) {
    return light->type == &glint_light_point ? "point" : light->type == &glint_light_spot ? "spot" : "directional";
}

/** Writes the settings of fog, opacity and samples that are not off. */
static void print_layers(writer *to, const window_state *state, const window_scene *built) {
    static const char *const blends[WINDOW_BLENDS] = {"alpha", "added", "dithered"};
    const window_changes *changes = &state->changes;
    if (built->scene.fog != NULL) {
        print(to, ink, "fog %s", built->scene.fog->type == &glint_fog_squared ? "squared" : "linear");
    }
    if (changes->passed > 0) {
        print(to, ink, "opacity %g, %s", 1 - changes->passed / 4.0, blends[changes->blend]);
    }
    if (built->samples != NULL) {
        print(to, ink, "2x2 samples");
    }
}

static void print_light(writer *to, const window_state *state, const glint_scene *scene) {
    static const char *const terms[WINDOW_TERMS] = {"diffuse + specular", "specular alone", "diffuse alone"};
    const glint_object *object = find_lit(scene);
    const uint32_t chosen = state->changes.chosen;
    print_title(to, "Light");
    if (object != NULL) {
        print(to, ink, "%s, %s", name_model(object->material->model), name_place(object->evaluation));
        print(to, ink, "exponent %.4g", number_from_q16(object->material->shininess));
    }
    print(to, ink, "%s%s", terms[state->changes.terms], state->changes.dark ? ", dark" : "");
    print(to, ink, "viewer %s", scene->viewer == GLINT_VIEWER_LOCAL ? "local" : "infinite");
    if (chosen < scene->light_count) {
        print(to, ink, "light %lu of %lu: %s", (unsigned long)chosen + 1, (unsigned long)scene->light_count,
              name_kind(&scene->lights[chosen]));
    } else {
        print(to, ink, "no light");
    }
}

/* ---- What it takes ---------------------------------------------------------------------------------------------- */

static void draw_slider(writer *to, window_state *state) {
    const window_box box = {to->x, to->y, WINDOW_SIDE - 2 * WINDOW_MARGIN, 14};
    const int at = (int)lround(state->arena * (box.width - 1));
    label_fill(to->canvas, box.x, box.y + 5, box.width, 4, rail);
    label_fill(to->canvas, box.x + at - 3, box.y, 7, box.height, mark);
    state->slider = box;
    to->y += 2 * LABEL_LINE;
}

static void print_frame(writer *to, window_state *state, const window_frame *frame) {
    const glint_stats *stats = &frame->stats;
    print_title(to, "Frame");
    print(to, ink, "%lu triangles, %lu vertices", (unsigned long)stats->triangles, (unsigned long)stats->vertices);
    print(to, ink, "%lu pass%s, %lu tiles", (unsigned long)stats->passes, stats->passes == 1 ? "" : "es",
          (unsigned long)stats->tiles);
    print(to, ink, "arena %zu bytes", frame->arena);
    draw_slider(to, state);
    print(to, dim, "%zu .. %zu", frame->need.least, frame->need.one_pass);
}

static void print_rate(writer *to, const window_state *state, const window_frame *frame) {
    const double bus = window_buses[state->bus];
    print(to, ink, "SPI %g MHz: send %.1f ms", bus, (double)frame->target.bytes_sent * 8 / (bus * 1e3));
}

void window_draw_side(window_state *state, const window_frame *frame, const label_picture *canvas) {
    writer to = {canvas, (int)canvas->width - WINDOW_SIDE + WINDOW_MARGIN, WINDOW_MARGIN};
    window_scene built;
    host_problem problem;
    print_panel(&to, state);
    if (window_build(state, &built, &problem)) {
        print_layers(&to, state, &built);
        print_light(&to, state, &built.scene);
        window_scene_free(&built);
    }
    print_frame(&to, state, frame);
    print_rate(&to, state, frame);
    label_text(canvas, "F1: help", to.x, (int)canvas->height - 2 * LABEL_LINE - WINDOW_MARGIN, 2, dim);
}
