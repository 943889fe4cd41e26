/* SPDX-License-Identifier: MIT */
/**
 * @file command.c
 * What commands share: how models are loaded, and what becomes of pictures.
 */
#include "command.h"

#include "view.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** More of either than the flash of nearly all microcontrollers has room for. */
#define VERTICES_HELD 100000u
#define FLASH_HELD 1000000u

int command_fail(const char *file, const host_problem *problem) {
    problem_print(file, problem);
    return COMMAND_FAILED;
}

/** Refuses, with a line, to write over the model, by whatever name. */
static bool keeps_model(const host_settings *settings) {
    host_problem problem;
    if (settings->output == NULL || shape_find(settings->model) != NULL ||
        !path_is_same_file(settings->model, settings->output)) {
        return true;
    }
    problem_set(&problem, 0, "cannot be written: it is the model");
    problem_print(settings->output, &problem);
    return false;
}

/* ---- Models ----------------------------------------------------------------------------------------------------- */

/** Has pieces drawn from both sides whose material is so, where their surface is open: elsewhere no back is seen. */
static void open_sides(const host_model *model, quantised_mesh *mesh) {
    const host_materials *materials = &model->materials;
    bool any = false;
    for (uint32_t i = 1; i <= materials->used_count; i++) {
        any = any || materials_find(materials, i)->double_sided;
    }
    if (!any) {
        return;
    }
    const size_t parts = (materials->objects.count + 1) * (materials->used_count + 1);
    bool *marks = memory_new(parts, sizeof *marks);
    mesh_mark_open(&model->mesh, marks);
    for (size_t i = 0; i < mesh->piece_count; i++) {
        const uint32_t number = mesh->materials[i];
        const mtl_material *material =
            materials_find(materials, model->parts != NULL ? model->parts[number].material : number);
        if (material != NULL && material->double_sided && marks[number]) {
            mesh->pieces[i].flags |= GLINT_MESH_DOUBLE_SIDED;
        }
    }
    free(marks);
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
    open_sides(model, mesh);
    if (model->parts != NULL) {
        mesh->objects = memory_new(mesh->piece_count, sizeof *mesh->objects);
    }
    for (size_t i = 0; model->parts != NULL && i < mesh->piece_count; i++) {
        mesh->objects[i] = model->parts[mesh->materials[i]].object;
        mesh->materials[i] = model->parts[mesh->materials[i]].material;
    }
    if (!settings->load.plain && mesh->vertex_count <= VERTICES_HELD) {
        quantised_cluster(mesh);
    }
    return true;
}

bool command_load(const host_settings *settings, bool converted, host_model *model, quantised_mesh *mesh) {
    host_problem problem;
    if (!keeps_model(settings)) {
        return false;
    }
    const bool ok = command_prepare(settings, converted, model, mesh, &problem);
    if (!ok) {
        problem_print(settings->model, &problem);
    }
    return ok;
}

void command_print_warnings(const host_settings *settings, const host_model *model) {
    if (model->note.text[0] != '\0') {
        problem_print(settings->model, &model->note);
    }
    problem_print_warnings(settings->model, &model->warnings);
    materials_print_warnings(&model->materials);
}

void command_warn_of_size(const host_settings *settings, const host_materials *materials, const quantised_mesh *mesh) {
    const size_t flash = quantised_size(mesh) + textures_size(materials);
    host_problem warning;
    const char *advice = textures_size(materials) > flash / 2
                             ? "smaller textures (--texture-size N)"
                             : "fewer triangles (--simplify N), or a part of the model";
    if (mesh->vertex_count > VERTICES_HELD || flash > FLASH_HELD) {
        problem_set(
            &warning, 0,
            "warning: %zu vertices and %zu triangles take %.1f MB of flash, more than microcontrollers have: take "
            "%s",
            mesh->vertex_count, mesh->triangle_count, (double)flash / 1e6, advice);
        problem_print(settings->model, &warning);
    }
}

/* ---- Pictures --------------------------------------------------------------------------------------------------- */

void command_print_stats(const glint_stats *stats, const framebuffer *target) {
    printf("passes %lu\n", (unsigned long)stats->passes);
    printf("tiles %lu\n", (unsigned long)stats->tiles);
    printf("vertices %lu\n", (unsigned long)stats->vertices);
    printf("triangles %lu\n", (unsigned long)stats->triangles);
    printf("facing_away %lu\n", (unsigned long)stats->facing_away);
    printf("outside %lu\n", (unsigned long)stats->outside);
    printf("clipped %lu\n", (unsigned long)stats->clipped);
    printf("hidden %lu\n", (unsigned long)stats->hidden);
    printf("references %lu\n", (unsigned long)stats->references);
    printf("arena_used %lu\n", (unsigned long)stats->arena_used);
    printf("bytes_sent %llu\n", (unsigned long long)target->bytes_sent);
}

bool command_check_frames(const host_settings *settings, const char *command, host_problem *problem) {
    if (settings->animate > 0 && (settings->frame_given || settings->stats)) {
        return problem_set(problem, 0, "%s: %s and --animate exclude each other", command,
                           settings->frame_given ? "--frame" : "--stats");
    }
    return true;
}

int command_write(host_bytes *file, const char *path) {
    host_problem problem;
    const bool ok = bytes_write_file(file, path, &problem);
    free(file->data);
    return ok ? 0 : command_fail(path, &problem);
}

/** Draws the settings' frame into a file, and prints its statistics for --stats. @return exit status */
static int draw_still(const command_picture *shown, const host_settings *settings) {
    host_bytes file = {NULL, 0, 0};
    host_problem problem;
    framebuffer target;
    glint_stats stats;
    uint8_t *picture = shown->draw(shown->context, settings->frame, &target, &stats, &problem);
    if (picture == NULL) {
        return command_fail(NULL, &problem);
    }
    png_encode(&file, picture, settings->width, settings->height, settings->format->channels);
    const int status = command_write(&file, settings->output);
    if (status == 0 && settings->stats) {
        printf("panel %ux%u %s\n", settings->width, settings->height, settings->format->name);
        command_print_stats(&stats, &target);
    }
    free(picture);
    framebuffer_free(&target);
    return status;
}

static uint8_t *draw_frame(const command_picture *shown, uint32_t frame, host_problem *problem) {
    framebuffer target;
    glint_stats stats;
    uint8_t *picture = shown->draw(shown->context, frame, &target, &stats, problem);
    if (picture != NULL) {
        framebuffer_free(&target);
    }
    return picture; /* cppcheck-suppress returnDanglingLifetime; it is memory of its own */
}

/** Draws all frames into one file. @return exit status */
static int draw_movie(const command_picture *shown, const host_settings *settings) {
    uint8_t **pictures = memory_new(settings->animate, sizeof *pictures);
    const png_movie movie = {.frames = pictures,
                             .count = settings->animate,
                             .delay_numerator = (uint16_t)shown->duration,
                             .delay_denominator = (uint16_t)(settings->animate * shown->rate)};
    host_bytes file = {NULL, 0, 0};
    host_problem problem;
    uint32_t drawn = 0;
    int status;
    while (drawn < settings->animate && (pictures[drawn] = draw_frame(shown, drawn, &problem)) != NULL) {
        drawn++;
    }
    if (drawn < settings->animate) {
        status = command_fail(NULL, &problem);
    } else {
        png_encode_movie(&file, &movie, settings->width, settings->height, settings->format->channels);
        status = command_write(&file, settings->output);
    }
    for (uint32_t i = 0; i < drawn; i++) {
        free(pictures[i]);
    }
    free(pictures);
    return status;
}

int command_draw(const command_picture *shown, const host_settings *settings) {
    return (settings->animate > 0 ? draw_movie : draw_still)(shown, settings);
}
