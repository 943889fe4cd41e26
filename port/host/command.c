/* SPDX-License-Identifier: MIT */
#include "command.h"

#include "compare.h"
#include "numbered.h"
#include "output.h"
#include "place.h"
#include "png.h"
#include "preview.h"
#include "progress.h"
#include "shapes.h"

#include <stdlib.h>
#include <string.h>

/** More of either than the flash of nearly all microcontrollers has room for. */
#define VERTICES_HELD 100000u
#define FLASH_HELD 1000000u

int command_fail(const char *file, const host_problem *problem) {
    problem_print(file, problem);
    return COMMAND_FAILED;
}

bool command_has_output(const host_settings *settings) {
    return settings->output != NULL || settings->preview > 0 || settings->compare != NULL;
}

/** Refuses to write a file to a place where one is read, by whatever name. */
static bool keeps(const char *output, const char *input, const char *what) {
    host_problem problem;
    if (output == NULL || !path_is_same_file(input, output)) {
        return true;
    }
    problem_set(&problem, 0, "cannot be written: it is %s", what);
    problem_print(output, &problem);
    return false;
}

/** The same for each frame of an animation. */
static bool frames_keep(const host_settings *settings, const char *input, const char *what) {
    host_problem problem;
    numbered_name name;
    bool ok = true;
    if (!numbered_parse(&name, settings->output, &problem)) {
        return true; /* the command says what is wrong */
    }
    for (uint32_t i = 0; ok && i < (name.has_number ? settings->animate : 1); i++) {
        char *output = numbered_make(&name, i);
        ok = keeps(output, input, what);
        free(output);
    }
    return ok;
}

bool command_keeps(const host_settings *settings, const char *file, const char *what) {
    return keeps(settings->heat, file, what) &&
           (settings->animate > 0 && settings->output != NULL ? frames_keep(settings, file, what)
                                                              : keeps(settings->output, file, what));
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
    if (shape_find(settings->model) == NULL && !command_keeps(settings, settings->model, "the model")) {
        return false;
    }
    progress_begin("reading", path_base_name(settings->model));
    const bool ok = command_prepare(settings, converted, model, mesh, &problem);
    progress_end();
    if (!ok) {
        problem_print(settings->model, &problem);
    }
    return ok;
}

bool command_open_compared(const host_settings *settings, png_picture *other) {
    host_problem problem;
    host_bytes file;
    memset(other, 0, sizeof *other);
    if (settings->compare == NULL) {
        return true;
    }
    if (!command_keeps(settings, settings->compare, "the picture to compare with")) {
        return false;
    }
    bool ok = bytes_read_file(&file, settings->compare, PNG_FILE_MAX, &problem);
    if (ok) {
        ok = png_decode(other, file.data, file.count, &problem);
        free(file.data);
    }
    if (ok && (other->width != settings->width || other->height != settings->height)) {
        free(other->pixels);
        ok = problem_set(&problem, 0, "is %lux%lu pixels, the picture %ux%u", (unsigned long)other->width,
                         (unsigned long)other->height, settings->width, settings->height);
    }
    if (!ok) {
        problem_print(settings->compare, &problem);
    }
    return ok;
}

/** Writes a picture to the settings' output, and shows it where they say so. */
static bool write_picture(const uint8_t *picture, const host_settings *settings, host_problem *problem) {
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

int command_finish(const uint8_t *picture, const framebuffer *target, const glint_stats *stats,
                   const host_settings *settings, const png_picture *other) {
    host_problem problem;
    if (!write_picture(picture, settings, &problem)) {
        return command_fail(settings->output, &problem);
    }
    if (settings->stats) {
        command_print_stats(stats, target, settings);
    }
    if (other->pixels == NULL) {
        return 0;
    }
    const comparison found = compare_pictures(picture, settings->format->channels, other);
    compare_print(&found);
    return found.different > 0 ? COMMAND_DIFFERS : 0;
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
