/* SPDX-License-Identifier: MIT */
#include "command.h"

#include "output.h"
#include "place.h"
#include "png.h"
#include "preview.h"
#include "shapes.h"

#include <stdlib.h>

/** More of either than the flash of nearly all microcontrollers has room for. */
#define VERTICES_HELD 100000u
#define FLASH_HELD 1000000u

int command_fail(const char *file, const host_problem *problem) {
    problem_print(file, problem);
    return COMMAND_FAILED;
}

/** Whether the file to write is the model's own, by whatever name. */
static bool is_overwritten(const host_settings *settings) {
    return settings->output != NULL && shape_find(settings->model) == NULL &&
           path_is_same_file(settings->model, settings->output);
}

bool command_prepare(const host_settings *settings, bool converted, host_model *model, quantised_mesh *mesh,
                     host_problem *problem) {
    if (!load_model(settings->model, &settings->load, model, problem)) {
        return false;
    }
    place_model(model, settings, converted);
    if (!converted) {
        place_to_fit(model, settings);
    }
    if (!quantise(&model->mesh, settings->double_sided ? GLINT_MESH_DOUBLE_SIDED : 0, &settings->load.types, mesh,
                  problem)) {
        model_free(model);
        return false;
    }
    if (!settings->load.plain && mesh->vertex_count <= VERTICES_HELD) {
        quantised_cluster(mesh);
    }
    return true;
}

bool command_load(const host_settings *settings, bool converted, host_model *model, quantised_mesh *mesh) {
    host_problem problem;
    if (is_overwritten(settings)) {
        problem_set(&problem, 0, "cannot be written: it is the model");
        problem_print(settings->output, &problem);
        return false;
    }
    if (!command_prepare(settings, converted, model, mesh, &problem)) {
        problem_print(settings->model, &problem);
        return false;
    }
    return true;
}

bool command_write_png(const uint8_t *picture, const host_settings *settings, host_problem *problem) {
    if (settings->preview > 0) {
        preview_print(picture, settings->width, settings->height, settings->format->channels, settings->preview);
    }
    if (settings->output == NULL) {
        return true;
    }
    host_bytes file = {NULL, 0, 0};
    png_encode(&file, picture, settings->width, settings->height, settings->format->channels);
    const bool ok = bytes_write_file(&file, settings->output, problem);
    free(file.data);
    return ok;
}

void command_print_warnings(const host_settings *settings, const host_model *model) {
    if (model->note.text[0] != '\0') {
        problem_print(settings->model, &model->note);
    }
    problem_print_warnings(settings->model, &model->warnings);
    materials_print_warnings(&model->materials);
}

void command_warn_of_size(const host_settings *settings, const quantised_mesh *mesh) {
    const size_t flash = quantised_size(mesh);
    host_problem warning;
    if (mesh->vertex_count > VERTICES_HELD || flash > FLASH_HELD) {
        problem_set(
            &warning, 0,
            "warning: %zu vertices and %zu triangles take %.1f MB of flash, more than microcontrollers have: take "
            "fewer triangles (--simplify N), or a part of the model",
            mesh->vertex_count, mesh->triangle_count, (double)flash / 1e6);
        problem_print(settings->model, &warning);
    }
}
