/* SPDX-License-Identifier: MIT */
/**
 * @file open.c
 * What the window shows: models, shapes and example scenes by their names.
 */
#include "window.h"

#include "basics.h"
#include "command.h"
#include "model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Shapes that stand behind the scenes in the list. */
static const char *const shapes[] = {"torus:48x24", "sphere:32x16", "cylinder:32x4", "cone:32x8", "box"};

#define SHAPE_COUNT (sizeof shapes / sizeof shapes[0])

static char *copy_text(const char *text) {
    const size_t size = strlen(text) + 1;
    char *copy = memory_new(size, 1);
    memcpy(copy, text, size);
    return copy;
}

/** What is shown is no longer. */
static void forget(window_state *state) {
    if (state->has_model) {
        quantised_free(&state->mesh);
        model_free(&state->model);
    }
    free(state->name);
    state->name = NULL;
    state->has_model = false;
    state->scene = NULL;
    state->frame = 0;
    state->runs = false;
}

/** Replaces the shown model or scene by one of that name, which may be the old name itself. */
static void begin(window_state *state, const char *name) {
    const window_changes none = {.zoom = 1};
    char *kept = copy_text(name);
    forget(state);
    state->name = kept;
    state->settings.model = state->name;
    state->changes = none;
    state->message[0] = '\0';
}

/** The size that what is shown is made for, unless one has been chosen. */
static void choose_size(window_state *state, uint16_t width, uint16_t height) {
    if (!state->settings.size_given) {
        state->settings.width = width;
        state->settings.height = height;
    }
}

/* ---- Scenes ----------------------------------------------------------------------------------------------------- */

/** Whether a name is that of a scene and of a variant of it; then shows it. */
static bool open_scene(window_state *state, const char *name) {
    chosen_scene chosen;
    host_problem problem;
    if (!scene_find(name, &chosen, &problem)) {
        return false;
    }
    begin(state, name);
    state->scene = chosen.scene;
    state->variant = chosen.variant;
    choose_size(state, chosen.scene->width, chosen.scene->height);
    return true;
}

/* ---- Models ----------------------------------------------------------------------------------------------------- */

static bool open_model(window_state *state, const char *name, host_problem *problem) {
    host_settings settings = state->settings;
    host_model model;
    quantised_mesh mesh;
    settings.model = name;
    settings.output = NULL;
    if (!command_prepare(&settings, false, &model, &mesh, problem)) {
        return false;
    }
    begin(state, name);
    choose_size(state, 320, 240);
    state->has_model = true;
    state->model = model;
    state->mesh = mesh;
    if (model.note.text[0] != '\0') {
        snprintf(state->message, sizeof state->message, "%.150s", model.note.text);
    } else if (model.warnings.count > 0) {
        snprintf(state->message, sizeof state->message, "%.150s", model.warnings.list[0].text);
    }
    return true;
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

void window_init(window_state *state, const host_settings *settings) {
    memset(state, 0, sizeof *state);
    state->settings = *settings;
    state->changes.zoom = 1;
    state->arena = 1;
    state->bus = 7;
}

bool window_open(window_state *state, const char *name, host_problem *problem) {
    return open_scene(state, name) || open_model(state, name, problem);
}

/** The name at a place of the list. @return false when the list ends before it */
static bool find_listed(size_t place, char *name, size_t size) {
    for (int i = 0; i < EXAMPLE_SCENES; i++) {
        const example_scene *scene = example_scenes[i];
        if (place < scene->variant_count) {
            snprintf(name, size, "%s:%s", scene->name, scene->variants[place].name);
            return true;
        }
        place -= scene->variant_count;
    }
    if (place < SHAPE_COUNT) {
        snprintf(name, size, "%s", shapes[place]);
    }
    return place < SHAPE_COUNT;
}

/** Where the list has what is shown; its end where it does not. */
static size_t find_place(const window_state *state) {
    char name[80];
    size_t place = 0;
    for (; find_listed(place, name, sizeof name); place++) {
        const size_t length = strlen(state->name);
        if (strncmp(name, state->name, length) == 0 && (name[length] == '\0' || name[length] == ':')) {
            return place;
        }
    }
    return place;
}

void window_open_next(window_state *state, int step) {
    char name[80];
    host_problem problem;
    size_t count = 0;
    while (find_listed(count, name, sizeof name)) {
        count++;
    }
    const size_t place = find_place(state);
    const size_t next = step > 0 ? (place + 1 < count ? place + 1 : 0) : (place > 0 ? place : count) - 1;
    if (find_listed(next, name, sizeof name) && !window_open(state, name, &problem)) {
        snprintf(state->message, sizeof state->message, "%.150s", problem.text);
    }
}

void window_free(window_state *state) {
    forget(state);
}
