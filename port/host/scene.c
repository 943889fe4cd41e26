/* SPDX-License-Identifier: MIT */
/**
 * @file scene.c
 * The example scenes, drawn as a board draws them.
 */
#include "command.h"

#include "label.h"
#include "maps.h"
#include "memory.h"
#include "output.h"
#include "png.h"
#include "scenes/scenes.h"
#include "view.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Frames a second that the scenes are made for. */
#define FRAME_RATE 25

/** A scene, and which variant of it. */
typedef struct chosen_scene {
    const example_scene *scene;
    uint32_t variant;
} chosen_scene;

static int print_list(void) {
    for (int i = 0; i < EXAMPLE_SCENES; i++) {
        const example_scene *scene = example_scenes[i];
        printf("%s (%ux%u, %lu frame%s): %s\n", scene->name, scene->width, scene->height, (unsigned long)scene->frames,
               scene->frames == 1 ? "" : "s", scene->summary);
        for (uint32_t j = 0; j < scene->variant_count; j++) {
            printf("  %s:%s  %s\n", scene->name, scene->variants[j].name, scene->variants[j].look_for);
        }
    }
    return 0;
}

/* ---- Names ------------------------------------------------------------------------------------------------------ */

static bool is_word(const char *text, size_t length, const char *word) {
    return strlen(word) == length && memcmp(text, word, length) == 0;
}

/** Finds the scene and the variant that a name says, the first variant when it says none. */
static bool choose_scene(const char *name, chosen_scene *chosen, host_problem *problem) {
    char quote[PROBLEM_QUOTE_SIZE];
    const size_t length = strcspn(name, ":");
    chosen->scene = NULL;
    chosen->variant = 0;
    for (int i = 0; i < EXAMPLE_SCENES; i++) {
        if (is_word(name, length, example_scenes[i]->name)) {
            chosen->scene = example_scenes[i];
        }
    }
    if (chosen->scene == NULL) {
        return problem_set(problem, 0, "unknown scene '%s': see glint scene --list",
                           problem_quote(quote, name, length));
    }
    if (name[length] == '\0') {
        return true;
    }
    const char *variant = name + length + 1;
    while (chosen->variant < chosen->scene->variant_count) {
        if (strcmp(variant, chosen->scene->variants[chosen->variant].name) == 0) {
            return true;
        }
        chosen->variant++;
    }
    return problem_set(problem, 0, "scene %s has no variant '%s': see glint scene --list", chosen->scene->name,
                       problem_quote(quote, variant, strlen(variant)));
}

static bool check(const host_settings *settings, host_problem *problem) {
    if (settings->model == NULL) {
        return problem_set(problem, 0, "scene: a scene is missing: see glint scene --list");
    }
    if (settings->output == NULL && settings->preview == 0) {
        return problem_set(problem, 0, "scene: the file to write is missing: -o FILE");
    }
    if (settings->frame_given && settings->animate > 0) {
        return problem_set(problem, 0, "scene: --frame and --animate exclude each other");
    }
    if ((settings->lit_map != NULL || settings->heat != NULL || settings->preview > 0) && settings->animate > 0) {
        return problem_set(problem, 0, "scene: --lit-map, --heat and --preview show one frame: not with --animate");
    }
    if (settings->stats && settings->animate > 0) {
        return problem_set(problem, 0, "scene: --stats and --animate exclude each other");
    }
    return true;
}

/* ---- Pictures --------------------------------------------------------------------------------------------------- */

static bool draw_frame(const chosen_scene *chosen, uint32_t frame, const host_settings *settings, framebuffer *target,
                       frame_counts *counts, host_problem *problem) {
    example_stage *stage = memory_new(1, sizeof *stage);
    chosen->scene->build(stage, chosen->variant, frame % chosen->scene->frames);
    stage->scene.error_budget = settings->budget;
    const bool ok = maps_draw(&stage->scene, settings, target, counts, problem);
    free(stage);
    return ok;
}

/** The picture of a frame, with its labels when they are asked for. The caller frees it. */
static uint8_t *expand(const chosen_scene *chosen, const host_settings *settings, const framebuffer *target) {
    const example_scene *scene = chosen->scene;
    const example_variant *variant = &scene->variants[chosen->variant];
    const label_picture picture = {framebuffer_expand(target), target->width, target->height, target->format->channels};
    if (settings->labels) {
        label_draw(&picture, variant->labels, variant->label_count, scene->width, scene->height);
    }
    return picture.pixels;
}

static int draw_still(const chosen_scene *chosen, const host_settings *settings) {
    framebuffer target;
    frame_counts counts;
    host_problem problem;
    if (!draw_frame(chosen, settings->frame, settings, &target, &counts, &problem)) {
        return command_fail(NULL, &problem);
    }
    uint8_t *picture = expand(chosen, settings, &target);
    const bool written = command_write_png(picture, settings, &problem);
    free(picture);
    if (written && settings->stats) {
        command_print_stats(&counts, &target, settings);
    }
    framebuffer_free(&target);
    return written ? 0 : command_fail(settings->output, &problem);
}

/** Draws all frames, spread over the scene's own. @return how many were drawn; with a problem when not all */
static uint32_t draw_frames(const chosen_scene *chosen, const host_settings *settings, uint8_t **pictures,
                            host_problem *problem) {
    for (uint32_t i = 0; i < settings->animate; i++) {
        framebuffer target;
        frame_counts counts;
        const uint64_t frame = (uint64_t)i * chosen->scene->frames / settings->animate;
        if (!draw_frame(chosen, (uint32_t)frame, settings, &target, &counts, problem)) {
            return i;
        }
        pictures[i] = expand(chosen, settings, &target);
        framebuffer_free(&target);
    }
    return settings->animate;
}

static bool write_animation(const chosen_scene *chosen, const host_settings *settings, uint8_t *const *pictures,
                            host_problem *problem) {
    host_bytes file = {NULL, 0, 0};
    const uint32_t period = chosen->scene->frames > UINT16_MAX ? UINT16_MAX : chosen->scene->frames;
    const png_movie movie = {.frames = pictures,
                             .count = settings->animate,
                             .delay_numerator = (uint16_t)period,
                             .delay_denominator = (uint16_t)(settings->animate * FRAME_RATE)};
    png_encode_movie(&file, &movie, settings->width, settings->height, settings->format->channels);
    const bool ok = bytes_write_file(&file, settings->output, problem);
    free(file.data);
    return ok;
}

static int draw_animation(const chosen_scene *chosen, const host_settings *settings) {
    uint8_t **pictures = memory_new(settings->animate, sizeof *pictures);
    host_problem problem;
    const uint32_t drawn = draw_frames(chosen, settings, pictures, &problem);
    const bool all = drawn == settings->animate;
    const bool written = all && write_animation(chosen, settings, pictures, &problem);
    for (uint32_t i = 0; i < drawn; i++) {
        free(pictures[i]);
    }
    free(pictures);
    return written ? 0 : command_fail(all ? settings->output : NULL, &problem);
}

int command_scene(const host_settings *settings) {
    host_problem problem;
    chosen_scene chosen;
    if (settings->list) {
        return print_list();
    }
    if (!check(settings, &problem) || !choose_scene(settings->model, &chosen, &problem)) {
        return command_fail(NULL, &problem);
    }
    host_settings sized = *settings;
    if (!settings->size_given) {
        sized.width = chosen.scene->width;
        sized.height = chosen.scene->height;
    }
    return settings->animate > 0 ? draw_animation(&chosen, &sized) : draw_still(&chosen, &sized);
}
