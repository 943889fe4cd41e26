/* SPDX-License-Identifier: MIT */
/**
 * @file parse_shading.c
 * Options that say how surfaces are lit and how pixels are stored.
 */
#include "parsers.h"

#include "number.h"
#include "values.h"

#include <string.h>

bool parse_model(host_settings *settings, const char *text, host_problem *problem) {
    static const struct {
        const char *name;
        const glint_shading_model *model;
    } models[] = {
        {"lambert", &glint_model_lambert},
        {"phong", &glint_model_phong},
        {"blinn-phong", &glint_model_blinn_phong},
        {"unlit", &glint_model_unlit},
    };
    for (size_t i = 0; i < sizeof models / sizeof models[0]; i++) {
        if (strcmp(text, models[i].name) == 0) {
            settings->reflection = models[i].model;
            settings->reflection_given = true;
            return true;
        }
    }
    return value_expected(problem, "takes lambert, phong, blinn-phong or unlit");
}

bool parse_shading(host_settings *settings, const char *text, host_problem *problem) {
    static const struct {
        const char *name;
        const glint_evaluation *evaluation;
    } places[] = {
        {"flat", &glint_per_facet},
        {"vertex", &glint_per_vertex},
        {"fragment", &glint_per_fragment},
    };
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        if (strcmp(text, places[i].name) == 0) {
            settings->evaluation = places[i].evaluation;
            return true;
        }
    }
    return value_expected(problem, "takes flat, vertex or fragment");
}

bool parse_combine(host_settings *settings, const char *text, host_problem *problem) {
    const bool larger = strcmp(text, "max") == 0;
    if (!larger && strcmp(text, "sum") != 0) {
        return value_expected(problem, "takes sum or max");
    }
    settings->material_flags &= ~GLINT_MATERIAL_MAX_WITH_AMBIENT;
    settings->material_flags |= larger ? GLINT_MATERIAL_MAX_WITH_AMBIENT : 0;
    return true;
}

bool parse_ungated(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->material_flags |= GLINT_MATERIAL_SPECULAR_UNGATED;
    return true;
}

bool parse_dither(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->dither = true;
    return true;
}

bool parse_gamma(host_settings *settings, const char *text, host_problem *problem) {
    return value_real(text, 0.1, 10, &settings->gamma) || value_expected(problem, "takes a number from 0.1 to 10");
}
