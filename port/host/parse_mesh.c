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
    for (int i = 0; mesh_weight_names[i] != NULL; i++) {
        if (strcmp(text, mesh_weight_names[i]) == 0) {
            settings->load.weights = (mesh_weights)i;
            return true;
        }
    }
    return value_expected(problem, "takes equal, area or angle");
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
