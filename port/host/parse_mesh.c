/* SPDX-License-Identifier: MIT */
/**
 * @file parse_mesh.c
 * Options that say what becomes of a model when it is loaded.
 */
#include "parsers.h"

#include "values.h"

#include <string.h>

bool parse_crease(host_settings *settings, const char *text, host_problem *problem) {
    return value_real(text, 0, 180, &settings->load.crease) || value_expected(problem, "takes degrees from 0 to 180");
}

bool parse_weights(host_settings *settings, const char *text, host_problem *problem) {
    const bool by_angle = strcmp(text, "angle") == 0;
    if (!by_angle && strcmp(text, "area") != 0) {
        return value_expected(problem, "takes area or angle");
    }
    settings->load.weights = by_angle ? MESH_BY_ANGLE : MESH_BY_AREA;
    return true;
}

bool parse_facets(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->load.facets = true;
    return true;
}

bool parse_repair(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->load.repair = true;
    return true;
}

bool parse_no_clusters(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->load.plain = true;
    return true;
}
