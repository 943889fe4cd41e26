/* SPDX-License-Identifier: MIT */
/**
 * @file parsers.h
 * Parsers of single options, beside those in settings.c. Each takes the option's value, empty for a switch, and returns
 * false with a problem that says what the value should have been.
 */
#ifndef GLINT_HOST_PARSERS_H
#define GLINT_HOST_PARSERS_H

#include "settings.h"

bool parse_light(host_settings *settings, const char *text, host_problem *problem);
bool parse_camera_lights(host_settings *settings, const char *text, host_problem *problem);

bool parse_model(host_settings *settings, const char *text, host_problem *problem);
bool parse_shading(host_settings *settings, const char *text, host_problem *problem);
bool parse_combine(host_settings *settings, const char *text, host_problem *problem);
bool parse_ungated(host_settings *settings, const char *text, host_problem *problem);
bool parse_dither(host_settings *settings, const char *text, host_problem *problem);
bool parse_gamma(host_settings *settings, const char *text, host_problem *problem);

bool parse_up_axis(host_settings *settings, const char *text, host_problem *problem);
bool parse_centre(host_settings *settings, const char *text, host_problem *problem);
bool parse_scale(host_settings *settings, const char *text, host_problem *problem);
bool parse_rotate_x(host_settings *settings, const char *text, host_problem *problem);
bool parse_rotate_y(host_settings *settings, const char *text, host_problem *problem);
bool parse_rotate_z(host_settings *settings, const char *text, host_problem *problem);

bool parse_crease(host_settings *settings, const char *text, host_problem *problem);
bool parse_weights(host_settings *settings, const char *text, host_problem *problem);
bool parse_facets(host_settings *settings, const char *text, host_problem *problem);
bool parse_repair(host_settings *settings, const char *text, host_problem *problem);
bool parse_positions(host_settings *settings, const char *text, host_problem *problem);
bool parse_normals(host_settings *settings, const char *text, host_problem *problem);
bool parse_indices(host_settings *settings, const char *text, host_problem *problem);
bool parse_no_clusters(host_settings *settings, const char *text, host_problem *problem);
bool parse_weld(host_settings *settings, const char *text, host_problem *problem);
bool parse_simplify(host_settings *settings, const char *text, host_problem *problem);
bool parse_panel(host_settings *settings, const char *text, host_problem *problem);
bool parse_name(host_settings *settings, const char *text, host_problem *problem);
bool parse_licence(host_settings *settings, const char *text, host_problem *problem);
bool parse_import_seconds(host_settings *settings, const char *text, host_problem *problem);
bool parse_import_memory(host_settings *settings, const char *text, host_problem *problem);

bool parse_list(host_settings *settings, const char *text, host_problem *problem);
bool parse_frame(host_settings *settings, const char *text, host_problem *problem);
bool parse_labels(host_settings *settings, const char *text, host_problem *problem);
bool parse_animate(host_settings *settings, const char *text, host_problem *problem);

#endif
