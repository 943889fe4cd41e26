/* SPDX-License-Identifier: MIT */
/**
 * @file view.h
 * From settings and a model to a scene, and from a scene to pixels.
 */
#ifndef GLINT_HOST_VIEW_H
#define GLINT_HOST_VIEW_H

#include "glint.h"
#include "model.h"
#include "quantise.h"
#include "settings.h"

/* ---- Where a model is put before it is quantised, and how large ---- */

/**
 * Puts a model where options say: --up-axis, --centre, --scale and, when `turned`, --rotate-x, -y and -z, in this
 * order. Sets the model's box.
 */
void place_model(host_model *model, const host_settings *settings, bool turned);

/**
 * Moves the middle of a model's box to the origin and scales it by a power of ten to a half side of 0.3 to 3, where
 * Q16.16 does not hold its coordinates, or is too coarse or too narrow for a camera that frames it. Sets model->fit and
 * the model's note. The model's box stays what it was.
 */
void place_to_fit(host_model *model, const host_settings *settings);

/* ---- From settings and a mesh to a scene, and from a scene to pixels ---- */

/** A scene with all that it points to but the mesh. It points into itself: not to be copied. */
typedef struct host_view {
    glint_scene scene;
    glint_material *materials; /**< The default one, then the model's. */
    glint_light lights[GLINT_LIGHTS_MAX];
    glint_object *objects;
    glint_vector middle; /**< Of the box of a model that turns: of one that --animate is given for. */
} host_view;

/**
 * Makes the scene that settings describe: one object for each piece of the mesh. Without an eye the camera is placed
 * so that the model fills the view, in all frames of a turn.
 * @param materials of the model that `mesh` comes from
 * @param mesh stays the caller's and must outlive the view
 * @return false with a problem; nothing is then to be freed, else the view with view_free
 */
bool view_make(host_view *view, const host_settings *settings, const host_materials *materials,
               const quantised_mesh *mesh, host_problem *problem);

/** Turns the model as it is in a frame of the settings' animation: about --up, through the middle of its box. */
void view_turn(host_view *view, const host_settings *settings, uint32_t frame);

/** No less than how far from the origin a framing camera stands, of a model about it of that half side. */
double view_framing_distance(const host_settings *settings, double half_side);

/** Frees what view_make made. */
void view_free(host_view *view);

/** Bytes of arena that a scene takes with the settings' size, format and tiles. */
glint_status view_need(const glint_scene *scene, const host_settings *settings, glint_need *need);

/**
 * Draws a scene with the settings' size, format, tiles and arena.
 * @param target set up by this, the caller frees it; untouched when the result is false
 */
bool view_draw(const glint_scene *scene, const host_settings *settings, framebuffer *target, glint_stats *stats,
               host_problem *problem);

/**
 * Says why a picture of one colour shows nothing of its scene, or shows it black, as glint_check finds it.
 * @param is_black whether its colour is black
 * @return false where it does show something
 */
bool view_explain(const glint_scene *scene, const host_settings *settings, bool is_black, host_problem *warning);

/* ---- Tells the flash and the arena that a mesh takes of a board that draws it framed ---- */

/** A model, and how it is drawn. */
typedef struct report_subject {
    const host_settings *settings;
    const host_materials *materials;
    const quantised_mesh *mesh;
} report_subject;

/**
 * Prints what a mesh takes of flash and, on the settings' panel, of arena, a name and a value a line. However large it
 * is, and wherever, it is measured where a camera frames it.
 * @return false with a problem
 */
bool report_print(const report_subject *subject, host_problem *problem);

#endif
