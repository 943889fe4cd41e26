/* SPDX-License-Identifier: MIT */
#include "command.h"

#include "output.h"
#include "png.h"
#include "shapes.h"

#include <stdlib.h>

int command_fail(const char *file, const host_problem *problem) {
    problem_print(file, problem);
    return COMMAND_FAILED;
}

/** Whether the file to write is the model's own, by whatever name. */
static bool is_overwritten(const host_settings *settings) {
    return settings->output != NULL && shape_find(settings->model) == NULL &&
           path_is_same_file(settings->model, settings->output);
}

bool command_load(const host_settings *settings, bool scaled, host_model *model, quantised_mesh *mesh) {
    host_problem problem;
    if (is_overwritten(settings)) {
        problem_set(&problem, 0, "cannot be written: it is the model");
        problem_print(settings->output, &problem);
        return false;
    }
    if (!load_model(settings->model, &settings->load, model, &problem)) {
        problem_print(settings->model, &problem);
        return false;
    }
    if (scaled) {
        mesh_scale(&model->mesh, settings->scale);
    }
    if (!quantise(&model->mesh, settings->double_sided ? GLINT_MESH_DOUBLE_SIDED : 0, mesh, &problem)) {
        problem_print(settings->model, &problem);
        model_free(model);
        return false;
    }
    if (!settings->load.plain) {
        quantised_cluster(mesh);
    }
    return true;
}

bool command_write_png(const uint8_t *picture, const host_settings *settings, host_problem *problem) {
    host_bytes file = {NULL, 0, 0};
    png_encode(&file, picture, settings->width, settings->height, settings->format->channels);
    const bool ok = bytes_write_file(&file, settings->output, problem);
    free(file.data);
    return ok;
}

void command_print_warnings(const host_settings *settings, const host_model *model) {
    problem_print_warnings(settings->model, &model->warnings);
    materials_print_warnings(&model->materials);
}
