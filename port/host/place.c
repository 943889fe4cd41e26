/* SPDX-License-Identifier: MIT */
#include "place.h"

#include "number.h"
#include "quantise.h"
#include "view.h"

#include <math.h>

/** A model whose half side is less is too small for a camera in steps of 2^-16: 1/4096 of it is one. */
#define HALF_SIDE_MIN 0.0625

/** Least length that a power of ten scales to. */
#define LENGTH_MIN 0.3

static const double pi = 3.14159265358979323846;

/** The power of ten that takes a length to at least LENGTH_MIN and less than ten times that. */
static double power_of_ten(double length) {
    const double power = floor(log10(length / LENGTH_MIN));
    return power > 0 ? 1.0 / pow(10.0, power) : pow(10.0, -power);
}

/** The middle of a box. @return half its longest side */
static double measure_box(const double low[3], const double high[3], double middle[3]) {
    double half_side = 0;
    for (int axis = 0; axis < 3; axis++) {
        middle[axis] = low[axis] / 2 + high[axis] / 2;
        half_side = fmax(half_side, high[axis] / 2 - low[axis] / 2);
    }
    return half_side;
}

/** The largest coordinate of a box. */
static double farthest(const double low[3], const double high[3]) {
    double largest = 0;
    for (int axis = 0; axis < 3; axis++) {
        largest = fmax(largest, fmax(fabs(low[axis]), fabs(high[axis])));
    }
    return largest;
}

static void scale_model(host_model *model, const host_settings *settings) {
    double factors[3] = {settings->scale[0], settings->scale[1], settings->scale[2]};
    mesh_bounds(&model->mesh, model->low, model->high);
    const double largest = farthest(model->low, model->high);
    if (settings->scale_fit && largest > 0) {
        factors[0] = factors[1] = factors[2] = power_of_ten(largest);
    }
    mesh_scale(&model->mesh, factors);
}

void place_model(host_model *model, const host_settings *settings, bool turned) {
    if (settings->z_up) {
        mesh_turn(&model->mesh, 0, 0, -1);
    }
    if (settings->centre) {
        double middle[3];
        mesh_bounds(&model->mesh, model->low, model->high);
        measure_box(model->low, model->high, middle);
        mesh_move_to_origin(&model->mesh, middle);
    }
    scale_model(model, settings);
    for (int axis = 0; turned && axis < 3; axis++) {
        const double angle = number_from_q16(settings->rotate[axis]) * pi / 180.0;
        if (settings->rotate[axis] != 0) {
            mesh_turn(&model->mesh, axis, cos(angle), sin(angle));
        }
    }
    mesh_bounds(&model->mesh, model->low, model->high);
    model->fit = 1;
    model->note.text[0] = '\0';
}

/** Whether a camera is to frame the model, and nothing on the command line is measured in the model's units. */
static bool is_framed(const host_settings *settings) {
    bool framed = !settings->eye_given && !settings->at_given && !settings->near_given;
    for (uint32_t i = 0; i < settings->light_count; i++) {
        framed = framed && settings->lights[i].type == &glint_light_directional;
    }
    return framed;
}

void place_to_fit(host_model *model, const host_settings *settings) {
    double middle[3];
    const double half_side = measure_box(model->low, model->high, middle);
    const double largest = farthest(model->low, model->high);
    const bool framed = is_framed(settings);
    const bool fits = largest <= QUANTISE_COORDINATE_MAX &&
                      (!framed || (half_side >= HALF_SIDE_MIN &&
                                   largest + view_framing_distance(settings, half_side) <= NUMBER_Q16_MAX));
    if (fits || !(half_side > 0)) {
        return;
    }
    model->fit = power_of_ten(half_side);
    const double factors[3] = {model->fit, model->fit, model->fit};
    mesh_move_to_origin(&model->mesh, middle);
    mesh_scale(&model->mesh, factors);
    problem_set(&model->note, model->mesh.farthest_line,
                "note: coordinates reach %.6g, sides %.6g: drawn at %.6g of its size, %.6g,%.6g,%.6g at the origin",
                largest, 2 * half_side, model->fit, middle[0], middle[1], middle[2]);
}
