/* SPDX-License-Identifier: MIT */
/**
 * @file keys.c
 * What keys and mouse change.
 */
#include "window.h"

#include "values.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/** Degrees that a light moves at a key, or finely; and that it turns at a tick. */
#define LIGHT_STEP 5.0
#define LIGHT_FINE 1.0
#define LIGHT_TICK 2.0

/** Eighths of a doubling of the exponent, likewise. */
#define EXPONENT_STEP 4
#define EXPONENT_FINE 1
#define EXPONENT_MOST (8 * 16)

/** Degrees of orbit for a pixel of the mouse; the distance's factor for a step of the wheel, and its ends. */
#define DRAG_STEP 0.5
#define WHEEL_STEP 0.9
#define ZOOM_MIN 0.05
#define ZOOM_MAX 50.0

const window_help window_helps[] = {
    {"drag, wheel", "orbit, zoom"},
    {"right-drag", "turn the object"},
    {"I J K L", "move the light (Shift: finely)"},
    {"U O", "exponent up, down (Shift: finely)"},
    {"G", "dark diffuse colour, or as it is"},
    {"H", "diffuse + specular, specular, diffuse"},
    {"Shift H", "diffuse, or diffuse + specular"},
    {"T", "squashed to half its height, or not"},
    {"Space", "plain, or colours at vertices"},
    {"1 2 3", "flat, per vertex, per fragment"},
    {"M", "Lambert, Phong, Blinn-Phong"},
    {"V", "viewer: infinite, local"},
    {"E P W", "fog, opacity (Shift: kind), smooth edges"},
    {"N", "one more light (Shift: one less)"},
    {"C", "choose the next light"},
    {"X", "its kind: directional, point, spot"},
    {"Y", "lights drawn, or not"},
    {"B", "light turns, or stands"},
    {"S", "size of the panel (Shift: back)"},
    {"F D", "format of pixels (Shift: back), dithered"},
    {"Q", "size of tiles"},
    {"Z", "grid of tiles"},
    {"A", "less arena (Shift: more), or the slider"},
    {"- =", "clock of the panel's bus down, up"},
    {"PgUp PgDn", "other scenes and shapes"},
    {"Left Right", "frame of a scene"},
    {"R", "run a scene's frames, or stop"},
    {"Home", "all as it was loaded"},
    {"F2", "screenshot"},
    {NULL, NULL},
};

const glint_blend window_blends[WINDOW_BLENDS] = {GLINT_BLEND_ALPHA, GLINT_BLEND_ADD, GLINT_BLEND_DITHERED};

const double window_buses[WINDOW_BUSES] = {4, 8, 10, 16, 20, 24, 32, 40, 50, 62.5, 80};

/* ---- Lights ----------------------------------------------------------------------------------------------------- */

/** The lights of the scene as it is drawn become the state's own. */
static void own_lights(const window_scene *built, window_changes *changes) {
    if (changes->has_lights) {
        return;
    }
    changes->has_lights = true;
    changes->light_count = built->scene.light_count;
    for (uint32_t i = 0; i < changes->light_count; i++) {
        window_light *own = &changes->lights[i];
        const glint_light *light = &built->scene.lights[i];
        own->light = *light;
        number_from_vector(light->position, own->position);
        number_from_vector(light->direction, own->direction);
    }
}

/** Turns the chosen light about what the camera looks at. */
static void turn_light(const window_scene *built, window_changes *changes, const double axis[3], double degrees) {
    own_lights(built, changes);
    if (changes->chosen >= changes->light_count) {
        return;
    }
    window_light *light = &changes->lights[changes->chosen];
    for (int i = 0; i < 3; i++) {
        light->position[i] -= built->target[i];
    }
    window_turn(light->position, axis, degrees);
    window_turn(light->direction, axis, degrees);
    for (int i = 0; i < 3; i++) {
        light->position[i] += built->target[i];
    }
}

/** One more light from a side of its own, or one less. */
static void change_count(const window_scene *built, window_changes *changes, bool less) {
    static const struct {
        double from[3]; /* right, up, back */
        double colour[3];
    } added[GLINT_LIGHTS_MAX] = {{{-0.5, 0.7, 0.7}, {1, 1, 1}},        {{0.9, 0.2, 0.4}, {0.8, 0.4, 0.2}},
                                 {{-0.8, -0.3, 0.5}, {0.2, 0.4, 0.8}}, {{0.1, -0.9, 0.4}, {0.2, 0.6, 0.3}},
                                 {{0.7, 0.6, -0.5}, {0.6, 0.6, 0.3}},  {{-0.7, 0.5, -0.5}, {0.5, 0.3, 0.6}},
                                 {{0.4, 0.1, 0.9}, {0.3, 0.3, 0.3}},   {{0, 0.9, -0.4}, {0.3, 0.5, 0.5}}};
    own_lights(built, changes);
    if (less && changes->light_count > 0) {
        changes->light_count--;
        changes->chosen = changes->chosen < changes->light_count ? changes->chosen : 0;
    } else if (!less && changes->light_count < GLINT_LIGHTS_MAX) {
        const uint32_t i = changes->light_count++;
        window_light *light = &changes->lights[i];
        const glint_light white = {.type = &glint_light_directional};
        light->light = white;
        light->light.diffuse.r = light->light.specular.r = number_q16(added[i].colour[0]);
        light->light.diffuse.g = light->light.specular.g = number_q16(added[i].colour[1]);
        light->light.diffuse.b = light->light.specular.b = number_q16(added[i].colour[2]);
        for (int axis = 0; axis < 3; axis++) {
            light->position[axis] = 0;
            light->direction[axis] = -(added[i].from[0] * built->right[axis] + added[i].from[1] * built->up[axis] +
                                       added[i].from[2] * built->back[axis]);
        }
        changes->chosen = i;
    }
}

/** The chosen light's next kind. One that gets a place stands as far off as the view is high, in the same direction. */
static void change_kind(const window_scene *built, window_changes *changes) {
    own_lights(built, changes);
    if (changes->chosen >= changes->light_count) {
        return;
    }
    window_light *own = &changes->lights[changes->chosen];
    glint_light *light = &own->light;
    const bool gets_place = light->type == &glint_light_directional;
    const bool is_spot = light->type == &glint_light_spot;
    double towards[3];
    double length = 0;
    for (int i = 0; i < 3; i++) {
        towards[i] = gets_place ? -own->direction[i] : own->position[i] - built->target[i];
        length += towards[i] * towards[i];
    }
    const double factor = gets_place ? 1.5 * built->reach / sqrt(length) : 1;
    for (int i = 0; i < 3; i++) {
        own->direction[i] = -towards[i];
        own->position[i] = towards[i] * factor + built->target[i];
    }
    light->type = gets_place ? &glint_light_point : is_spot ? &glint_light_directional : &glint_light_spot;
    light->inner = GLINT_Q16(14);
    light->outer = GLINT_Q16(22);
}

/** Keys that move and change lights; these need the camera's axes. */
static void light_key(window_state *state, int key, bool fine) {
    window_changes *changes = &state->changes;
    const double step = fine ? LIGHT_FINE : LIGHT_STEP;
    window_scene built;
    host_problem problem;
    if (!window_build(state, &built, &problem)) {
        return;
    }
    if (key == 'N') {
        change_count(&built, changes, fine);
    } else if (key == 'X') {
        change_kind(&built, changes);
    } else if (key == 'C') {
        own_lights(&built, changes);
        changes->chosen = changes->chosen + 1 < changes->light_count ? changes->chosen + 1 : 0;
    } else if (key == 'J' || key == 'L') {
        turn_light(&built, changes, built.up, key == 'L' ? step : -step);
    } else {
        turn_light(&built, changes, built.right, key == 'K' ? step : -step);
    }
    window_scene_free(&built);
}

/* ---- Panel ------------------------------------------------------------------------------------------------------ */

static size_t step_round(size_t at, size_t count, bool back) {
    return back ? (at > 0 ? at : count) - 1 : (at + 1) % count;
}

static void change_size(window_state *state, bool back) {
    static const uint16_t sizes[][2] = {{320, 240}, {240, 240}, {240, 135}, {160, 128},
                                        {128, 128}, {128, 64},  {96, 64}};
    const size_t count = sizeof sizes / sizeof sizes[0];
    size_t at = 0;
    while (at < count && (sizes[at][0] != state->settings.width || sizes[at][1] != state->settings.height)) {
        at++;
    }
    at = at < count ? step_round(at, count, back) : 0;
    state->settings.size_given = true;
    state->settings.width = sizes[at][0];
    state->settings.height = sizes[at][1];
}

static void change_format(window_state *state, bool back) {
    static const char *const names[] = {"rgb565", "rgb444", "grey4", "mono", "rgb888", "grey8"};
    const size_t count = sizeof names / sizeof names[0];
    size_t at = 0;
    while (at + 1 < count && strcmp(names[at], state->settings.format->name) != 0) {
        at++;
    }
    state->settings.format = framebuffer_find_format(names[step_round(at, count, back)], NULL);
}

static void change_tile(window_state *state, bool back) {
    static const uint16_t sizes[] = {8, 16, 32, 64};
    const uint16_t now = state->settings.tile_width > 0 ? state->settings.tile_width : 32;
    size_t at = 0;
    while (at < 3 && sizes[at] < now) {
        at++;
    }
    state->settings.tile_width = state->settings.tile_height = sizes[step_round(at, 4, back)];
}

static size_t step_within(size_t at, size_t count, bool up) {
    return up ? at + (at + 1 < count) : at - (at > 0);
}

static void change_arena(window_state *state, double by) {
    state->arena = fmax(0, fmin(1, state->arena + by));
}

/* ---- Keys ------------------------------------------------------------------------------------------------------- */

static void change_reflection(window_state *state) {
    static const glint_shading_model *const models[] = {&glint_model_lambert, &glint_model_phong,
                                                        &glint_model_blinn_phong};
    window_scene built;
    host_problem problem;
    const glint_shading_model *now = NULL;
    if (!window_build(state, &built, &problem)) {
        return;
    }
    for (uint32_t i = 0; now == NULL && i < built.scene.object_count; i++) { /* the first that is lit */
        const glint_shading_model *model = built.objects[i].material->model;
        now = model != &glint_model_unlit ? model : NULL;
    }
    window_scene_free(&built);
    size_t at = 0;
    while (at < 2 && models[at] != now) {
        at++;
    }
    state->changes.reflection = models[step_round(at, 3, false)];
}

static void change_viewer(window_state *state) {
    window_scene built;
    host_problem problem;
    if (window_build(state, &built, &problem)) {
        state->changes.has_viewer = true;
        state->changes.viewer = built.scene.viewer == GLINT_VIEWER_LOCAL ? GLINT_VIEWER_INFINITE : GLINT_VIEWER_LOCAL;
        window_scene_free(&built);
    }
}

/** No fog, or the scene's own; then one type after the other. */
static void change_fog(window_changes *changes) {
    changes->fog = changes->fog == NULL                ? &glint_fog_linear
                   : changes->fog == &glint_fog_linear ? &glint_fog_squared
                                                       : NULL;
}

/** A quarter less opacity, or the next way to blend, which then shows. */
static void change_opacity(window_changes *changes, bool blends) {
    changes->passed = blends ? changes->passed : (changes->passed + 1) % 4;
    changes->blend = blends ? (changes->blend + 1) % WINDOW_BLENDS : changes->blend;
}

/** Samples that are not those which the scene is drawn with. */
static void change_samples(window_state *state) {
    window_scene built;
    host_problem problem;
    if (window_build(state, &built, &problem)) {
        state->settings.samples_given = true;
        state->settings.samples = built.samples == NULL ? &glint_samples_2x2 : NULL;
        window_scene_free(&built);
    }
}

static void change_exponent(window_changes *changes, int by) {
    const int changed = changes->exponent + by;
    changes->exponent = changed < -EXPONENT_MOST ? -EXPONENT_MOST : changed > EXPONENT_MOST ? EXPONENT_MOST : changed;
}

/** The next term, or with Shift diffuse light with specular or alone. */
static void change_terms(window_changes *changes, bool keeps_diffuse) {
    const int other = changes->terms == WINDOW_BOTH ? WINDOW_DIFFUSE : WINDOW_BOTH;
    changes->terms = keeps_diffuse ? other : (changes->terms + 1) % WINDOW_TERMS;
}

static void evaluate(window_changes *changes, int digit) {
    static const glint_evaluation *const places[] = {&glint_per_facet, &glint_per_vertex, &glint_per_fragment};
    changes->has_evaluation = true;
    changes->evaluation = places[digit - '1'];
}

static void reset(window_state *state) {
    const window_changes none = {.zoom = 1};
    state->changes = none;
    state->frame = 0;
    state->runs = false;
}

static void change_frame(window_state *state, int by) {
    if (!state->has_model) {
        const int64_t count = state->scene->frames;
        state->frame = (uint32_t)(((int64_t)state->frame + by + count) % count);
    }
}

/** Keys that turn something on and off. @return whether it is one */
static bool toggle_key(window_state *state, int key) {
    window_changes *changes = &state->changes;
    const struct {
        int key;
        bool *is_on;
    } toggles[] = {{'G', &changes->dark},        {'T', &changes->squashed},    {'Y', &changes->shows_lights},
                   {'B', &changes->lights_turn}, {' ', &changes->colours},     {'D', &state->settings.dither},
                   {'Z', &state->grid},          {WINDOW_KEY_F1, &state->help}};
    for (size_t i = 0; i < sizeof toggles / sizeof toggles[0]; i++) {
        if (toggles[i].key == key) {
            *toggles[i].is_on = !*toggles[i].is_on;
            return true;
        }
    }
    return false;
}

/** Keys of what is drawn. @return whether it is one */
static bool scene_key(window_state *state, int key, bool fine) {
    window_changes *changes = &state->changes;
    switch (key) {
    case 'U':
        change_exponent(changes, fine ? EXPONENT_FINE : EXPONENT_STEP);
        return true;
    case 'O':
        change_exponent(changes, fine ? -EXPONENT_FINE : -EXPONENT_STEP);
        return true;
    case 'H':
        change_terms(changes, fine);
        return true;
    case 'M':
        change_reflection(state);
        return true;
    case 'V':
        change_viewer(state);
        return true;
    case 'E':
        change_fog(changes);
        return true;
    case 'P':
        change_opacity(changes, fine);
        return true;
    case 'R':
        state->runs = !state->has_model && !state->runs;
        return true;
    case WINDOW_KEY_LEFT:
        change_frame(state, -1);
        return true;
    case WINDOW_KEY_RIGHT:
        change_frame(state, 1);
        return true;
    case WINDOW_KEY_PAGE_UP:
        window_open_next(state, -1);
        return true;
    case WINDOW_KEY_PAGE_DOWN:
        window_open_next(state, 1);
        return true;
    case WINDOW_KEY_HOME:
        reset(state);
        return true;
    default:
        return false;
    }
}

/** Keys of how it is shown. */
static void show_key(window_state *state, int key, bool back) {
    switch (key) {
    case 'S':
        change_size(state, back);
        break;
    case 'F':
        change_format(state, back);
        break;
    case 'W':
        change_samples(state);
        break;
    case 'Q':
        change_tile(state, back);
        break;
    case 'A':
        change_arena(state, back ? 0.1 : -0.1);
        break;
    case '-':
    case '=':
        state->bus = step_within(state->bus, WINDOW_BUSES, key == '=');
        break;
    case WINDOW_KEY_F2:
        window_screenshot(state);
        break;
    default:
        break;
    }
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

void window_key(window_state *state, int key, bool fine) {
    state->message[0] = '\0';
    if (key >= '1' && key <= '3') {
        evaluate(&state->changes, key);
    } else if (key != 0 && key < 128 && strchr("IJKLNXC", key) != NULL) {
        light_key(state, key, fine);
    } else if (!toggle_key(state, key) && !scene_key(state, key, fine)) {
        show_key(state, key, fine);
    }
}

void window_drag(window_state *state, int across, int down) {
    window_scene built;
    host_problem problem;
    state->changes.yaw -= DRAG_STEP * across;
    state->changes.pitch += DRAG_STEP * down;
    if (window_build(state, &built, &problem)) {
        state->changes.pitch = built.pitch;
        window_scene_free(&built);
    }
}

void window_drag_subject(window_state *state, int across, int down) {
    static const double unturned[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    window_changes *changes = &state->changes;
    window_scene built;
    host_problem problem;
    if (!window_build(state, &built, &problem)) {
        return;
    }
    if (!changes->has_turn) {
        memcpy(changes->turn, unturned, sizeof unturned);
        changes->has_turn = true;
    }
    for (int column = 0; column < 3; column++) {
        window_turn(changes->turn[column], built.up, DRAG_STEP * across);
        window_turn(changes->turn[column], built.right, DRAG_STEP * down);
    }
    window_scene_free(&built);
}

void window_wheel(window_state *state, int steps) {
    state->changes.zoom = fmax(ZOOM_MIN, fmin(ZOOM_MAX, state->changes.zoom * pow(WHEEL_STEP, steps)));
}

bool window_press(window_state *state, int x, int y) {
    const window_box *slider = &state->slider;
    if (y < slider->y || y >= slider->y + slider->height || x < slider->x || x >= slider->x + slider->width) {
        return false;
    }
    state->arena = (double)(x - slider->x) / (slider->width - 1);
    return true;
}

bool window_tick(window_state *state) {
    static const double upwards[3] = {0, 1, 0};
    window_scene built;
    host_problem problem;
    if (state->runs) {
        change_frame(state, 1);
    }
    if (state->changes.lights_turn && window_build(state, &built, &problem)) {
        turn_light(&built, &state->changes, upwards, LIGHT_TICK);
        window_scene_free(&built);
    }
    return state->runs || state->changes.lights_turn;
}
