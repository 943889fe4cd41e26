/* SPDX-License-Identifier: MIT */
/**
 * @file web.c
 * What the page calls: the host program's `render`, `scene` and `convert`, by the same options, with files and pictures
 * in memory, and the reference beside them. Options come as words that each end with a 0; the page writes them, and
 * files, into room that web_room gives.
 *
 * The page adds the models that it brings along and calls web_start. web_begin forgets what came after that: files are
 * added, and then a model is loaded once and drawn any number of times. Memory of a drawing is taken back by the next.
 */
#include "basics.h"
#include "command.h"
#include "files.h"
#include "framebuffer.h"
#include "glint_extras.h"
#include "libc.h"
#include "measure.h"
#include "meshes.h"
#include "scenes/scenes.h"
#include "view.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define EXPORT(name) __attribute__((export_name(#name))) name

#define WORDS_MAX 128

/** What the page looks at after a drawing. */
typedef struct web_picture {
    uint32_t width, height;
    const uint8_t *pixels; /**< Red, green, blue and 255 each. */
    const float *errors;   /**< Of each pixel, steps of the format; null until web_measure. */
    const char *told;      /**< What was printed: a name and a value a line. */
    const char *problem;   /**< What is wrong, and warnings. */
} web_picture;

/* What is loaded, and what was drawn last. */
static host_model model;
static quantised_mesh mesh;
static host_settings settings;
static host_view view;
static example_stage stage;
static const glint_scene *drawn;
static framebuffer target;
static web_picture shown;
static void *started_end, *loaded_end;

static void forget_text(void) {
    web_stdout.count = web_stderr.count = 0;
    web_stdout.text[0] = web_stderr.text[0] = '\0';
}

void *EXPORT(web_room)(size_t size) {
    return memory_new(size, 1);
}

/** Adds a file. Name and data stay where they are, in room that web_room gave. @return 0 when there are too many */
int EXPORT(web_hand)(const char *name, const uint8_t *data, size_t size) {
    return web_add_file(name, data, size);
}

/** Takes `size` bytes of words apart. @return false with a problem told */
static bool take_words(int command, char *words, size_t size) {
    static char *list[WORDS_MAX]; /* the settings keep them */
    int count = 0;
    host_problem problem;
    for (size_t i = 0; i < size && count < WORDS_MAX; i += strlen(words + i) + 1) {
        list[count++] = words + i;
    }
    settings_default(&settings);
    if (!settings_parse(&settings, command, count, list, &problem)) {
        problem_print(NULL, &problem);
        return false;
    }
    return true;
}

/** Makes the meshes of the example scenes from the files that were added; these stay. To be called once, first. */
int EXPORT(web_start)(void) {
    for (const web_mesh *made = web_meshes; made->mesh != NULL; made++) {
        char *words = memory_new(made->size, 1);
        memcpy(words, made->words, made->size);
        if (!take_words(COMMAND_CONVERT, words, made->size) || !command_load(&settings, true, &model, &mesh)) {
            return 0;
        }
        *made->mesh = mesh.pieces[0];
    }
    web_files_keep();
    started_end = loaded_end = web_heap_top();
    return 1;
}

/** Forgets all that was added and loaded since the start. */
void EXPORT(web_begin)(void) {
    web_heap_return(started_end);
    web_files_forget();
    forget_text();
    loaded_end = started_end;
}

/** Loads the model that words name, by their options. The words must stay. @return 1, or 0 with a problem told */
int EXPORT(web_load)(char *words, size_t size) {
    forget_text();
    if (!take_words(COMMAND_RENDER, words, size)) {
        return 0;
    }
    const bool ok = command_load(&settings, false, &model, &mesh);
    if (ok) {
        command_print_warnings(&settings, &model);
        command_warn_of_size(&settings, &model.materials, &mesh);
    }
    loaded_end = web_heap_top();
    return ok;
}

/** Of what was loaded: half the longest side of its box before --scale, in steps of 2^-16; 0 where it is not known. */
double EXPORT(web_half_side)(void) {
    double half = 0;
    for (int axis = 0; axis < 3; axis++) {
        half = fmax(half, (model.high[axis] - model.low[axis]) / 2 / settings.scale[axis]);
    }
    return half;
}

/* ---- Drawing ----------------------------------------------------------------------------------------------------- */

/** Prints how much arena the scene takes. As on a board, a tile is sent while the next one is drawn. */
static void print_needs(void) {
    glint_need need = {0};
    if (view_need(drawn, &settings, &need) != GLINT_OK) {
        return;
    }
    printf("need_least %zu\nneed_resident %zu\nneed_one_pass %zu\n", need.least, need.resident, need.one_pass);
}

static void print_meshes(void) {
    size_t vertices = 0;
    size_t triangles = 0;
    for (uint32_t i = 0; i < drawn->object_count; i++) {
        vertices += drawn->objects[i].mesh->vertex_count;
        triangles += drawn->objects[i].mesh->triangle_count;
    }
    printf("scene_vertices %zu\nscene_triangles %zu\nscene_objects %lu\nscene_lights %lu\n", vertices, triangles,
           (unsigned long)drawn->object_count, (unsigned long)drawn->light_count);
}

/** Grey or coloured levels of 8 bits as a canvas takes them. */
static const uint8_t *expand(void) {
    const uint32_t channels = target.format->channels;
    const size_t count = (size_t)target.width * target.height;
    const uint8_t *levels = framebuffer_expand(&target);
    uint8_t *pixels = memory_new(count, 4);
    for (size_t i = 0; i < count; i++) {
        for (size_t channel = 0; channel < 3; channel++) {
            pixels[4 * i + channel] = levels[channels * i + (channels == 3 ? channel : 0)];
        }
        pixels[4 * i + 3] = 255;
    }
    return pixels;
}

static int draw(const glint_scene *scene) {
    glint_stats stats;
    host_problem problem;
    drawn = scene;
    if (!view_draw(scene, &settings, &target, &stats, &problem)) {
        problem_print(NULL, &problem);
        print_needs();
        return 0;
    }
    command_print_stats(&stats, &target);
    print_needs();
    print_meshes();
    shown.width = target.width;
    shown.height = target.height;
    shown.pixels = expand();
    return 1;
}

static void begin_drawing(void) {
    web_heap_return(loaded_end);
    forget_text();
    shown = (web_picture){.told = web_stdout.text, .problem = web_stderr.text};
    drawn = NULL;
}

/** Draws what was loaded. @param words `size` bytes, not in room that web_room gave after loading */
int EXPORT(web_draw)(char *words, size_t size) {
    host_problem problem;
    begin_drawing();
    if (!take_words(COMMAND_RENDER, words, size)) {
        return 0;
    }
    if (!view_make(&view, &settings, &model.materials, &mesh, &problem)) {
        problem_print(NULL, &problem);
        return 0;
    }
    return draw(&view.scene);
}

/** Draws an example scene. */
int EXPORT(web_draw_scene)(uint32_t scene, uint32_t variant, char *words, size_t size) {
    begin_drawing();
    if (!take_words(COMMAND_SCENE, words, size)) {
        return 0;
    }
    example_scenes[scene]->build(&stage, variant, settings.frame % example_scenes[scene]->frames);
    settings.samples = settings.samples_given ? settings.samples : stage.samples;
    return draw(&stage.scene);
}

/** Tells of the drawing. */
const web_picture *EXPORT(web_shown)(void) {
    return &shown;
}

/** Prints the example scenes, a line each with tabs between what it says, and after each its variants. */
void EXPORT(web_list)(void) {
    begin_drawing();
    for (uint32_t i = 0; i < EXAMPLE_SCENES; i++) {
        const example_scene *scene = example_scenes[i];
        printf("scene\t%s\t%u\t%u\t%lu\t%s\n", scene->name, scene->width, scene->height, (unsigned long)scene->frames,
               scene->summary);
        for (uint32_t j = 0; j < scene->variant_count; j++) {
            printf("variant\t%s\t%s\n", scene->variants[j].name, scene->variants[j].look_for);
        }
    }
}

/** Converts a model to a header, which web_written then holds. */
const char *EXPORT(web_convert)(char *words, size_t size) {
    forget_text();
    if (!take_words(COMMAND_CONVERT, words, size) || command_convert(&settings) != 0) {
        return NULL;
    }
    bytes_add(&web_written, '\0');
    return (const char *)web_written.data;
}

/* ---- Errors ------------------------------------------------------------------------------------------------------ */

/**
 * Holds the drawing against the reference.
 * @param same 0: lit at each pixel, for a local viewer; else shaded in the same way, in double precision
 * @return 1, or 0 where nothing was drawn, the scene has too many objects, or is not what the reference draws
 */
int EXPORT(web_measure)(int same) {
    measured_errors sums;
    if (shown.pixels == NULL) {
        return 0;
    }
    const float *errors = measure_errors(drawn, &settings, &target, same, &sums);
    if (errors == NULL) {
        return 0;
    }
    shown.errors = errors;
    if (sums.samples > 0) {
        const double mean = sums.squares / sums.samples;
        printf("psnr %.4f\nworst_steps %.4f\n", mean > 0 ? -10 * log10(mean) : 99.0, sums.worst);
    }
    return 1;
}
