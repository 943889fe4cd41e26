/* SPDX-License-Identifier: MIT */
#include "animation.h"

#include "command.h"
#include "memory.h"
#include "numbered.h"
#include "output.h"
#include "png.h"
#include "progress.h"

#include <stdio.h>
#include <stdlib.h>

bool animation_check(const host_settings *settings, const char *command, host_problem *problem) {
    numbered_name name;
    host_problem wrong;
    if (settings->animate == 0) {
        return true;
    }
    if (settings->frame_given) {
        return problem_set(problem, 0, "%s: --frame and --animate exclude each other", command);
    }
    if (settings->heat != NULL || settings->preview > 0 || settings->compare != NULL) {
        return problem_set(problem, 0, "%s: --heat, --preview and --compare take one frame: not with --animate",
                           command);
    }
    if (settings->stats) {
        return problem_set(problem, 0, "%s: --stats and --animate exclude each other", command);
    }
    if (!numbered_parse(&name, settings->output, &wrong)) {
        return problem_set(problem, 0, "%s: -o with --animate %s", command, wrong.text);
    }
    return true;
}

/** Draws a frame, and says so. */
static uint8_t *draw(const animation *movie, uint32_t frame, uint32_t count, host_problem *problem) {
    progress_frame(frame + 1, count);
    return movie->draw(movie->context, frame, problem);
}

/* ---- A file for each frame -------------------------------------------------------------------------------------- */

static bool write_frame(const uint8_t *picture, const host_settings *settings, const char *path,
                        host_problem *problem) {
    host_bytes file = {NULL, 0, 0};
    png_encode(&file, picture, settings->width, settings->height, settings->format->channels);
    const bool ok = bytes_write_file(&file, path, problem);
    free(file.data);
    return ok;
}

/** Prints what went wrong with a frame, and how many are there. */
static int fail_after(uint32_t written, const char *path, const host_settings *settings, const host_problem *wrong) {
    host_problem problem;
    problem_set(&problem, 0, "%s; %lu of %lu frames were written", wrong->text, (unsigned long)written,
                (unsigned long)settings->animate);
    return command_fail(path, &problem);
}

static int write_files(const animation *movie, const host_settings *settings, const numbered_name *name) {
    int status = 0;
    for (uint32_t i = 0; status == 0 && i < settings->animate; i++) {
        host_problem problem;
        char *path = numbered_make(name, i);
        uint8_t *picture = draw(movie, i, settings->animate, &problem);
        if (picture == NULL || !write_frame(picture, settings, path, &problem)) {
            progress_end();
            status = fail_after(i, picture != NULL ? path : NULL, settings, &problem);
        }
        free(picture);
        free(path);
    }
    return status;
}

/* ---- One file --------------------------------------------------------------------------------------------------- */

static bool write_movie(const animation *movie, const host_settings *settings, uint8_t *const *pictures,
                        const char *path, host_problem *problem) {
    host_bytes file = {NULL, 0, 0};
    const png_movie frames = {.frames = pictures,
                              .count = settings->animate,
                              .delay_numerator = (uint16_t)movie->duration,
                              .delay_denominator = (uint16_t)(settings->animate * movie->rate)};
    png_encode_movie(&file, &frames, settings->width, settings->height, settings->format->channels);
    const bool ok = bytes_write_file(&file, path, problem);
    free(file.data);
    return ok;
}

static int write_one(const animation *movie, const host_settings *settings, const numbered_name *name) {
    uint8_t **pictures = memory_new(settings->animate, sizeof *pictures);
    host_problem problem;
    char *path = numbered_make(name, 0);
    uint32_t drawn = 0;
    while (drawn < settings->animate && (pictures[drawn] = draw(movie, drawn, settings->animate, &problem)) != NULL) {
        drawn++;
    }
    const bool all = drawn == settings->animate;
    const bool written = all && write_movie(movie, settings, pictures, path, &problem);
    progress_end();
    const int status = written ? 0 : command_fail(all ? path : NULL, &problem);
    for (uint32_t i = 0; i < drawn; i++) {
        free(pictures[i]);
    }
    free(pictures);
    free(path);
    return status;
}

int animation_write(const animation *movie, const host_settings *settings) {
    numbered_name name;
    host_problem problem;
    if (!numbered_parse(&name, settings->output, &problem)) {
        return command_fail(NULL, &problem);
    }
    progress_begin("drawing", NULL);
    const int status = name.has_number ? write_files(movie, settings, &name) : write_one(movie, settings, &name);
    progress_end();
    return status;
}
