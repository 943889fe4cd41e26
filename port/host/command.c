/* SPDX-License-Identifier: MIT */
/**
 * @file command.c
 * What commands share: how models are loaded, and what becomes of pictures.
 */
#include "command.h"

#include "values.h"
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

bool command_has_output(const host_settings *settings) {
    return settings->output != NULL || settings->preview > 0 || settings->compare != NULL;
}

/** Refuses, with a line, to write over a file that is read, by whatever name; of an animation by that of any frame. */
static bool keeps(const host_settings *settings, const char *file, const char *what) {
    host_problem problem;
    numbered_name name;
    bool ok = true;
    if (settings->output == NULL || (settings->animate > 0 && !numbered_parse(&name, settings->output, &problem))) {
        return true; /* the command says what is wrong with the name */
    }
    const uint32_t count = settings->animate > 0 && name.has_number ? settings->animate : 1;
    for (uint32_t i = 0; ok && i < count; i++) {
        char *made = settings->animate > 0 ? numbered_make(&name, i) : NULL;
        const char *output = made != NULL ? made : settings->output;
        if (path_is_same_file(file, output)) {
            problem_set(&problem, 0, "cannot be written: it is %s", what);
            problem_print(output, &problem);
            ok = false;
        }
        free(made);
    }
    return ok;
}

/* ---- Models ----------------------------------------------------------------------------------------------------- */

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
    if (shape_find(settings->model) == NULL && !keeps(settings, settings->model, "the model")) {
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

/* ---- Pictures in a terminal ------------------------------------------------------------------------------------- */

/** A picture that is made smaller: `factor` times `factor` pixels become one. */
typedef struct preview {
    const uint8_t *pixels;
    uint32_t width, height, channels, factor;
} preview;

/** The mean of a square, as far as it lies in the picture; black below it. */
static void find_mean(const preview *from, uint32_t column, uint32_t row, uint32_t mean[3]) {
    uint32_t count = 0;
    mean[0] = mean[1] = mean[2] = 0;
    for (uint32_t y = row * from->factor; y < (row + 1) * from->factor && y < from->height; y++) {
        for (uint32_t x = column * from->factor; x < (column + 1) * from->factor && x < from->width; x++, count++) {
            const uint8_t *pixel = from->pixels + ((size_t)y * from->width + x) * from->channels;
            for (uint32_t c = 0; c < 3; c++) {
                mean[c] += pixel[c % from->channels];
            }
        }
    }
    for (uint32_t c = 0; c < 3; c++) {
        mean[c] = count > 0 ? (mean[c] + count / 2) / count : 0;
    }
}

/**
 * Prints a picture on standard output: two pixels a character, as an upper half block in 24-bit colours. One that is
 * wider than so many characters is made smaller by a whole number: each pixel is the mean of a square.
 */
static void print_preview(const uint8_t *pixels, uint32_t width, uint32_t height, uint32_t channels, uint32_t columns) {
    const uint32_t factor = (width + columns - 1) / columns;
    const preview from = {pixels, width, height, channels, factor};
    for (uint32_t row = 0; row * factor < height; row += 2) {
        for (uint32_t column = 0; column * factor < width; column++) {
            uint32_t upper[3];
            uint32_t lower[3];
            find_mean(&from, column, row, upper);
            find_mean(&from, column, row + 1, lower);
            printf("\033[38;2;%u;%u;%u;48;2;%u;%u;%um\342\226\200", (unsigned)upper[0], (unsigned)upper[1],
                   (unsigned)upper[2], (unsigned)lower[0], (unsigned)lower[1], (unsigned)lower[2]);
        }
        puts("\033[0m");
    }
}

/* ---- Stills ----------------------------------------------------------------------------------------------------- */

bool command_open_compared(const host_settings *settings, png_picture *other) {
    host_problem problem;
    host_bytes file;
    memset(other, 0, sizeof *other);
    if (settings->compare == NULL) {
        return true;
    }
    if (!keeps(settings, settings->compare, "the picture to compare with")) {
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

static bool write_png(const uint8_t *picture, const host_settings *settings, const char *path, host_problem *problem) {
    host_bytes file = {NULL, 0, 0};
    png_encode(&file, picture, settings->width, settings->height, settings->format->channels);
    const bool ok = bytes_write_file(&file, path, problem);
    free(file.data);
    return ok;
}

/** Shows, writes, measures and compares a picture, each where the settings say so. @return exit status */
static int finish_still(const uint8_t *picture, const framebuffer *target, const glint_stats *stats,
                        const host_settings *settings, const png_picture *other) {
    host_problem problem;
    if (settings->preview > 0) {
        print_preview(picture, settings->width, settings->height, settings->format->channels, settings->preview);
    }
    if (settings->output != NULL && !write_png(picture, settings, settings->output, &problem)) {
        return command_fail(settings->output, &problem);
    }
    if (settings->stats) {
        command_print_stats(stats, target);
    }
    if (other->pixels == NULL) {
        return 0;
    }
    const comparison found = compare_pictures(picture, settings->format->channels, other);
    compare_print(&found);
    return found.different > 0 ? COMMAND_DIFFERS : 0;
}

static int draw_still(const command_picture *shown, const host_settings *settings, const png_picture *other) {
    host_problem problem;
    framebuffer target;
    glint_stats stats;
    uint8_t *picture = shown->draw(shown->context, settings->frame, &target, &stats, &problem);
    if (picture == NULL) {
        return command_fail(NULL, &problem);
    }
    const int status = finish_still(picture, &target, &stats, settings, other);
    free(picture);
    framebuffer_free(&target);
    return status;
}

/* ---- Animations ------------------------------------------------------------------------------------------------- */

bool command_check_frames(const host_settings *settings, const char *command, host_problem *problem) {
    numbered_name name;
    host_problem wrong;
    if (settings->animate == 0) {
        return true;
    }
    if (settings->frame_given) {
        return problem_set(problem, 0, "%s: --frame and --animate exclude each other", command);
    }
    if (settings->preview > 0 || settings->compare != NULL) {
        return problem_set(problem, 0, "%s: --preview and --compare take one frame: not with --animate", command);
    }
    if (settings->stats) {
        return problem_set(problem, 0, "%s: --stats and --animate exclude each other", command);
    }
    if (!numbered_parse(&name, settings->output, &wrong)) {
        return problem_set(problem, 0, "%s: -o with --animate %s", command, wrong.text);
    }
    return true;
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

/** Prints what went wrong with a frame, and how many are there. */
static int fail_after(uint32_t written, const char *path, const host_settings *settings, const host_problem *wrong) {
    host_problem problem;
    problem_set(&problem, 0, "%s; %lu of %lu frames were written", wrong->text, (unsigned long)written,
                (unsigned long)settings->animate);
    return command_fail(path, &problem);
}

/** Writes a file for each frame. Those before a failure stay. */
static int write_files(const command_picture *shown, const host_settings *settings, const numbered_name *name) {
    int status = 0;
    for (uint32_t i = 0; status == 0 && i < settings->animate; i++) {
        host_problem problem;
        char *path = numbered_make(name, i);
        uint8_t *picture = draw_frame(shown, i, &problem);
        if (picture == NULL || !write_png(picture, settings, path, &problem)) {
            status = fail_after(i, picture != NULL ? path : NULL, settings, &problem);
        }
        free(picture);
        free(path);
    }
    return status;
}

/** Writes all frames into one file. */
static int write_movie(const command_picture *shown, const host_settings *settings, const char *path) {
    uint8_t **pictures = memory_new(settings->animate, sizeof *pictures);
    const png_movie frames = {.frames = pictures,
                              .count = settings->animate,
                              .delay_numerator = (uint16_t)shown->duration,
                              .delay_denominator = (uint16_t)(settings->animate * shown->rate)};
    host_problem problem;
    host_bytes file = {NULL, 0, 0};
    uint32_t drawn = 0;
    int status = 0;
    while (drawn < settings->animate && (pictures[drawn] = draw_frame(shown, drawn, &problem)) != NULL) {
        drawn++;
    }
    if (drawn < settings->animate) {
        status = command_fail(NULL, &problem);
    } else {
        png_encode_movie(&file, &frames, settings->width, settings->height, settings->format->channels);
        status = bytes_write_file(&file, path, &problem) ? 0 : command_fail(path, &problem);
    }
    free(file.data);
    for (uint32_t i = 0; i < drawn; i++) {
        free(pictures[i]);
    }
    free(pictures);
    return status;
}

int command_draw(const command_picture *shown, const host_settings *settings, const png_picture *other) {
    numbered_name name;
    host_problem problem;
    if (settings->animate == 0) {
        return draw_still(shown, settings, other);
    }
    if (!numbered_parse(&name, settings->output, &problem)) {
        return command_fail(NULL, &problem);
    }
    if (name.has_number) {
        return write_files(shown, settings, &name);
    }
    char *path = numbered_make(&name, 0);
    const int status = write_movie(shown, settings, path);
    free(path);
    return status;
}
