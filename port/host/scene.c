/* SPDX-License-Identifier: MIT */
/**
 * @file scene.c
 * The example scenes, drawn as a board draws them.
 */
#include "command.h"

#include "basics.h"
#include "label.h"
#include "scenes/scenes.h"
#include "view.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Frames a second that the scenes are made for. */
#define FRAME_RATE 25

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

bool scene_find(const char *name, chosen_scene *chosen, host_problem *problem) {
    char quote[PROBLEM_QUOTE_SIZE];
    const size_t length = strcspn(name, ":");
    const char *variant = name + length + 1;
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
    for (; name[length] == ':' && chosen->variant < chosen->scene->variant_count; chosen->variant++) {
        if (strcmp(variant, chosen->scene->variants[chosen->variant].name) == 0) {
            return true;
        }
    }
    return name[length] == '\0' || problem_set(problem, 0, "scene %s has no variant '%s': see glint scene --list",
                                               chosen->scene->name, problem_quote(quote, variant, strlen(variant)));
}

static bool check(const host_settings *settings, host_problem *problem) {
    if (settings->model == NULL) {
        return problem_set(problem, 0, "scene: a scene is missing: see glint scene --list");
    }
    if (settings->output == NULL) {
        return problem_set(problem, 0, "scene: the file to write is missing: -o FILE");
    }
    return command_check_frames(settings, "scene", problem);
}

/* ---- Pictures --------------------------------------------------------------------------------------------------- */

/** A scene that may move. */
typedef struct moving_scene {
    const chosen_scene *chosen;
    const host_settings *settings;
} moving_scene;

/** Draws a frame: of an animation, whose frames are spread over the scene's own, or of these. */
static uint8_t *draw(void *context, uint32_t frame, framebuffer *target, glint_stats *stats, host_problem *problem) {
    const moving_scene *moving = context;
    const host_settings *settings = moving->settings;
    const example_scene *scene = moving->chosen->scene;
    const example_variant *variant = &scene->variants[moving->chosen->variant];
    const uint64_t own = settings->animate > 0 ? (uint64_t)frame * scene->frames / settings->animate : frame;
    example_stage *stage = memory_new(1, sizeof *stage);
    scene->build(stage, moving->chosen->variant, (uint32_t)(own % scene->frames));
    host_settings own_settings = *settings;
    own_settings.samples = settings->samples_given ? settings->samples : stage->samples;
    const bool drawn = view_draw(&stage->scene, &own_settings, target, stats, problem);
    free(stage);
    if (!drawn) {
        return NULL;
    }
    const label_picture picture = {framebuffer_expand(target), target->width, target->height, target->format->channels};
    if (settings->labels) {
        label_draw(&picture, variant->labels, variant->label_count, scene->width, scene->height);
    }
    return picture.pixels;
}

int command_scene(const host_settings *settings) {
    host_problem problem;
    chosen_scene chosen;
    if (settings->list) {
        return print_list();
    }
    if (!check(settings, &problem) || !scene_find(settings->model, &chosen, &problem)) {
        return command_fail(NULL, &problem);
    }
    host_settings sized = *settings;
    if (!settings->size_given) {
        sized.width = chosen.scene->width;
        sized.height = chosen.scene->height;
    }
    moving_scene moving = {&chosen, &sized};
    const uint32_t period = chosen.scene->frames > UINT16_MAX ? UINT16_MAX : chosen.scene->frames;
    const command_picture shown = {draw, &moving, period, FRAME_RATE};
    return command_draw(&shown, &sized);
}
