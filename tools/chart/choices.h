/* SPDX-License-Identifier: MIT */
/**
 * @file choices.h
 * Every choice of shading that the library offers, for the charts of whole frames: drawn alike on the host, which
 * measures errors, and on the boards, which count instructions.
 */
#ifndef CHART_CHOICES_H
#define CHART_CHOICES_H

#include "glint.h"

typedef struct choice {
    const char *name; /**< Evaluation, model, viewer. */
    const glint_evaluation *evaluation;
    const glint_shading_model *model;
    glint_viewer viewer;
    int shininess_divisor; /**< Of the exponent, for the highlight that looks most like Blinn-Phong's. */
} choice;

/* The highlight of Phong has the size of Blinn-Phong's at a quarter of the exponent; Lambert has none, nor a viewer. */
#define CHOICES_OF(name, evaluation)                                                                      \
    {name " Lambert", evaluation, &glint_model_lambert, GLINT_VIEWER_INFINITE, 1},                        \
        {name " Phong infinite", evaluation, &glint_model_phong, GLINT_VIEWER_INFINITE, 4},               \
        {name " Phong local", evaluation, &glint_model_phong, GLINT_VIEWER_LOCAL, 4},                     \
        {name " Blinn-Phong infinite", evaluation, &glint_model_blinn_phong, GLINT_VIEWER_INFINITE, 1}, { \
        name " Blinn-Phong local", evaluation, &glint_model_blinn_phong, GLINT_VIEWER_LOCAL, 1            \
    }

static const choice choices[] = {CHOICES_OF("facet", &glint_per_facet), CHOICES_OF("vertex", &glint_per_vertex),
                                 CHOICES_OF("fragment", &glint_per_fragment)};
#define CHOICES (sizeof choices / sizeof *choices)

/** Sizes of the screen. */
static const uint16_t choice_sizes[][2] = {{320, 240}, {128, 64}};
#define CHOICE_SIZES (sizeof choice_sizes / sizeof *choice_sizes)

/** Makes a scene of one object be drawn as chosen. */
static inline void choose(const choice *chosen, glint_scene *scene, glint_object *object, glint_material *material) {
    object->evaluation = chosen->evaluation;
    material->model = chosen->model;
    material->shininess /= chosen->shininess_divisor;
    scene->viewer = chosen->viewer;
}

#endif
