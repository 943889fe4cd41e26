/* SPDX-License-Identifier: MIT */
/**
 * @file report.h
 * Tells the flash and the arena that a mesh takes of a board that draws it framed.
 */
#ifndef GLINT_HOST_REPORT_H
#define GLINT_HOST_REPORT_H

#include "materials.h"
#include "quantise.h"
#include "settings.h"

/** A model, and how it is drawn. */
typedef struct report_subject {
    const host_settings *settings;
    const host_materials *materials;
    const quantised_mesh *mesh;
} report_subject;

/**
 * Bytes of arena that the framed model needs on a panel, two tile buffers included.
 * @return false with a problem
 */
bool report_arena(const report_subject *subject, const settings_panel *panel, glint_need *need, host_problem *problem);

/**
 * Prints what a mesh takes of flash and, on the settings' panel, of arena, a name and a value a line. However large it
 * is, and wherever, it is measured where a camera frames it.
 * @return false with a problem
 */
bool report_print(const report_subject *subject, host_problem *problem);

#endif
