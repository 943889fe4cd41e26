/* SPDX-License-Identifier: MIT */
/**
 * @file window.h
 * The window's state and what it draws, without a window: keys and mouse change the state, the state gives a scene, and
 * the scene a canvas. main.c puts that on a screen.
 */
#ifndef GLINT_WINDOW_H
#define GLINT_WINDOW_H

#include "basics.h"
#include "label.h"
#include "view.h"

/** A tick of what turns by itself, milliseconds: the example scenes are made for 25 frames a second. */
#define WINDOW_TICK 40

/** From the canvas's edge to the picture, pixels; and the width of the text beside it. */
#define WINDOW_MARGIN 8
#define WINDOW_SIDE 372

/** Keys: letters, digits and signs are their own ASCII codes, letters as capitals. */
enum {
    WINDOW_KEY_F1 = 256,
    WINDOW_KEY_F2,
    WINDOW_KEY_LEFT,
    WINDOW_KEY_RIGHT,
    WINDOW_KEY_PAGE_UP,
    WINDOW_KEY_PAGE_DOWN,
    WINDOW_KEY_HOME,
};

/** Which terms of the lights are drawn. */
enum { WINDOW_BOTH, WINDOW_SPECULAR, WINDOW_DIFFUSE, WINDOW_TERMS };

/** A light whose position and direction are moved in double precision: it does not drift as it turns. */
typedef struct window_light {
    glint_light light;
    double position[3], direction[3];
} window_light;

/** What keys and mouse have changed of the scene as it was loaded; zeroed, but for `zoom`, it changes nothing. */
typedef struct window_changes {
    double yaw, pitch, zoom; /**< Degrees about what is looked at, and the distance's factor. */
    bool has_turn;
    double turn[3][3]; /**< Turns the subject, by columns: where x, y and z go. */
    bool has_lights;   /**< Whether these are in place of the scene's own. */
    window_light lights[GLINT_LIGHTS_MAX];
    uint32_t light_count, chosen; /**< The one that keys move. */
    bool has_evaluation, has_viewer;
    const glint_evaluation *evaluation;
    const glint_shading_model *reflection; /**< Or null for the materials' own. */
    glint_viewer viewer;
    int exponent;              /**< Eighths of a doubling. */
    int terms;                 /**< WINDOW_BOTH and so on. */
    const glint_fog_type *fog; /**< Null for the scene's own. */
    int passed;                /**< Quarters of light that go through the subject, 0 to 3. */
    int blend;                 /**< How the subject blends then: one of window_blends. */
    bool dark, squashed, colours, shows_lights, lights_turn;
} window_changes;

/** A rectangle of the canvas. */
typedef struct window_box {
    int x, y, width, height;
} window_box;

/** All that there is. */
typedef struct window_state {
    host_settings settings; /**< Size, format, tiles, and what else the command line says of a model. */
    char *name;             /**< Of the model or the scene. */
    bool has_model;         /**< A model, in the next two; else an example scene. */
    host_model model;
    quantised_mesh mesh;
    const example_scene *scene;
    uint32_t variant, frame;
    bool runs; /**< Whether the scene's frames follow each other. */

    window_changes changes;
    bool grid, help;
    double arena;      /**< From 0, the least that the scene takes, to 1, a single pass. */
    size_t bus;        /**< Of the list of clocks of a panel's bus. */
    window_box slider; /**< Where the arena was drawn last. */
    char message[160]; /**< What was done last, or went wrong. */
} window_state;

/* ---- Loading (open.c) ---- */

/** Sets a state up that shows nothing yet. */
void window_init(window_state *state, const host_settings *settings);

/**
 * Shows a model file, a shape or NAME[:VARIANT] of an example scene.
 * @return false with a problem; what was shown then stays
 */
bool window_open(window_state *state, const char *name, host_problem *problem);

/** Shows the scene variant, or the shape, that follows in a list of them all; -1 for the one before. */
void window_open_next(window_state *state, int step);

void window_free(window_state *state);

/* ---- Scene (build.c) ---- */

/** Colours of a mesh's vertices, or null. */
typedef struct window_paint {
    uint8_t (*colours)[3];
} window_paint;

/** The scene as it is drawn; points into itself and into the state. */
typedef struct window_scene {
    glint_scene scene;
    glint_light lights[GLINT_LIGHTS_MAX];
    glint_object *objects;
    glint_material *materials;
    glint_mesh *meshes;
    glint_fog fog;                              /**< Where the scene has some. */
    const glint_sampling *samples;              /**< That are drawn with. */
    window_paint *paints;                       /**< Of the meshes that get colours here. */
    double right[3], up[3], back[3], target[3]; /**< Axes of the camera, and what it looks at. */
    double reach;                               /**< Half the height of the view there. */
    double pitch;                               /**< The changes' own, kept from going over the top. */
} window_scene;

/** Makes the scene. @return false with a problem; nothing is then to be freed, else with window_scene_free */
bool window_build(const window_state *state, window_scene *built, host_problem *problem);

void window_scene_free(window_scene *built);

/** Turns a vector about an axis of length 1, right-handed, by degrees. */
void window_turn(double vector[3], const double axis[3], double degrees);

/* ---- Keys and mouse (keys.c) ---- */

/** A key, and what it does: one line of the help. */
typedef struct window_help {
    const char *keys, *what;
} window_help;

/** All of them, ended by one without keys. */
extern const window_help window_helps[];

/** How a subject that lets light through blends. */
#define WINDOW_BLENDS 3
extern const glint_blend window_blends[WINDOW_BLENDS];

/** Clocks to choose from, MHz, from slow to fast. */
#define WINDOW_BUSES 11
extern const double window_buses[WINDOW_BUSES];

/** Takes a key. @param fine whether Shift is down */
void window_key(window_state *state, int key, bool fine);

/** The mouse was moved with its left button down: turns the camera. */
void window_drag(window_state *state, int across, int down);

/** With its right button down: turns the subject. */
void window_drag_subject(window_state *state, int across, int down);

/** The wheel was turned; upwards is above 0 and goes nearer. */
void window_wheel(window_state *state, int steps);

/** The button is down at a point of the canvas. @return whether something there takes it */
bool window_press(window_state *state, int x, int y);

/** A tick has passed. @return whether it changed anything */
bool window_tick(window_state *state);

/* ---- Drawing (draw.c, side.c) ---- */

/** A frame as it was drawn. */
typedef struct window_frame {
    framebuffer target;
    glint_stats stats;
    glint_need need;
    size_t arena;
    uint8_t *picture; /**< 3 bytes a pixel. */
} window_frame;

/** Draws the scene. @return false with a problem; nothing is then to be freed, else with window_frame_free */
bool window_render(const window_state *state, window_frame *frame, host_problem *problem);

void window_frame_free(window_frame *frame);

/** Draws everything. @param canvas of 3 channels; all of it is overwritten */
void window_draw(window_state *state, const label_picture *canvas);

/** The text beside the picture. */
void window_draw_side(window_state *state, const window_frame *frame, const label_picture *canvas);

/** By how much a picture of the settings' size is magnified on a canvas, at least 1. */
int window_scale(const window_state *state, uint32_t width, uint32_t height);

/** Writes the picture as it shows, unscaled, to a new PNG; the message tells its name, or what is wrong. */
void window_screenshot(window_state *state);

#endif
