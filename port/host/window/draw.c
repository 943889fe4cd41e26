/* SPDX-License-Identifier: MIT */
/**
 * @file draw.c
 * The canvas: the magnified picture, the grid of tiles, the help, and the text beside (side.c).
 */
#include "window.h"

#include "basics.h"
#include "command.h"
#include "png.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const uint8_t paper[3] = {30, 31, 36}, ink[3] = {225, 228, 235}, dim[3] = {150, 155, 168},
                     line[3] = {255, 200, 60};

/* ---- Frames ----------------------------------------------------------------------------------------------------- */

/** 3 bytes a pixel of a picture that may have one. */
static uint8_t *expand(const framebuffer *target) {
    const size_t count = (size_t)target->width * target->height;
    const size_t channels = target->format->channels;
    uint8_t *levels = framebuffer_expand(target);
    uint8_t *colours = memory_new(count, 3);
    for (size_t i = 0; i < 3 * count; i++) {
        colours[i] = levels[i / 3 * channels + i % 3 % channels];
    }
    free(levels);
    return colours;
}

/** Draws with as much arena as the slider says. */
static bool render(const window_state *state, const window_scene *built, window_frame *frame, host_problem *problem) {
    const glint_scene *scene = &built->scene;
    host_settings settings = state->settings;
    settings.samples = built->samples;
    const glint_status status = view_need(scene, &settings, &frame->need);
    if (status != GLINT_OK) {
        return problem_set(problem, 0, "%s", glint_strerror(status));
    }
    const double more = (double)(frame->need.one_pass - frame->need.least);
    frame->arena = frame->need.least + (size_t)(state->arena * more);
    settings.arena = frame->arena;
    if (!view_draw(scene, &settings, &frame->target, &frame->stats, problem)) {
        return false;
    }
    frame->picture = expand(&frame->target);
    return true;
}

bool window_render(const window_state *state, window_frame *frame, host_problem *problem) {
    window_scene built;
    memset(frame, 0, sizeof *frame);
    if (!window_build(state, &built, problem)) {
        return false;
    }
    const bool ok = render(state, &built, frame, problem);
    window_scene_free(&built);
    return ok;
}

void window_frame_free(window_frame *frame) {
    framebuffer_free(&frame->target);
    free(frame->picture);
}

/* ---- Canvas ----------------------------------------------------------------------------------------------------- */

int window_scale(const window_state *state, uint32_t width, uint32_t height) {
    const int across = ((int)width - WINDOW_SIDE - 2 * WINDOW_MARGIN) / state->settings.width;
    const int down = ((int)height - 2 * WINDOW_MARGIN) / state->settings.height;
    const int scale = across < down ? across : down;
    return scale > 1 ? scale : 1;
}

static void draw_picture(const window_frame *frame, const label_picture *canvas, int scale) {
    const uint8_t *pixel = frame->picture;
    for (int y = 0; y < (int)frame->target.height; y++) {
        for (int x = 0; x < (int)frame->target.width; x++, pixel += 3) {
            label_fill(canvas, WINDOW_MARGIN + x * scale, WINDOW_MARGIN + y * scale, scale, scale, pixel);
        }
    }
}

/** Lines along the left and the upper edges of tiles. */
static void draw_grid(const window_state *state, const label_picture *canvas, int scale) {
    const host_settings *settings = &state->settings;
    const int width = settings->tile_width > 0 ? settings->tile_width : 32;
    const int height = settings->tile_height > 0 ? settings->tile_height : 32;
    for (int x = width; x < settings->width; x += width) {
        label_fill(canvas, WINDOW_MARGIN + x * scale, WINDOW_MARGIN, 1, settings->height * scale, line);
    }
    for (int y = height; y < settings->height; y += height) {
        label_fill(canvas, WINDOW_MARGIN, WINDOW_MARGIN + y * scale, settings->width * scale, 1, line);
    }
}

static void draw_help(const label_picture *canvas) {
    const int step = 2 * LABEL_LINE + 3;
    int y = 2 * WINDOW_MARGIN;
    int count = 0;
    while (window_helps[count].keys != NULL) {
        count++;
    }
    label_fill(canvas, WINDOW_MARGIN, WINDOW_MARGIN, 53 * 2 * LABEL_COLUMN, count * step + 2 * WINDOW_MARGIN, paper);
    for (int i = 0; i < count; i++, y += step) {
        label_text(canvas, window_helps[i].keys, 2 * WINDOW_MARGIN, y, 2, line);
        label_text(canvas, window_helps[i].what, 2 * WINDOW_MARGIN + 12 * 2 * LABEL_COLUMN, y, 2, ink);
    }
}

void window_draw(window_state *state, const label_picture *canvas) {
    window_frame frame;
    host_problem problem;
    const int scale = window_scale(state, canvas->width, canvas->height);
    label_fill(canvas, 0, 0, (int)canvas->width, (int)canvas->height, paper);
    if (window_render(state, &frame, &problem)) {
        draw_picture(&frame, canvas, scale);
        if (state->grid) {
            draw_grid(state, canvas, scale);
        }
        window_draw_side(state, &frame, canvas);
        window_frame_free(&frame);
    } else {
        label_text(canvas, problem.text, 2 * WINDOW_MARGIN, 2 * WINDOW_MARGIN, 2, ink);
    }
    if (state->help) {
        draw_help(canvas);
    }
    const int size = strlen(state->message) * 2 * LABEL_COLUMN < canvas->width - WINDOW_SIDE ? 2 : 1;
    label_text(canvas, state->message, WINDOW_MARGIN, (int)canvas->height - 2 * LABEL_LINE - WINDOW_MARGIN, size, dim);
}

/* ---- Screenshots ------------------------------------------------------------------------------------------------ */

void window_screenshot(window_state *state) {
    window_frame frame;
    host_problem problem;
    host_bytes file = {NULL, 0, 0};
    char name[CONVERT_NAME_SIZE];
    char path[CONVERT_NAME_SIZE + 16];
    FILE *there;
    int number = 0;
    if (!window_render(state, &frame, &problem)) {
        snprintf(state->message, sizeof state->message, "%.150s", problem.text);
        return;
    }
    convert_name(state->name, name);
    do { /* a name that nothing has yet */
        snprintf(path, sizeof path, "%s-%d.png", name, ++number);
        there = fopen(path, "rb");
        if (there != NULL) {
            fclose(there);
        }
    } while (there != NULL);
    png_encode(&file, frame.picture, frame.target.width, frame.target.height, 3);
    if (bytes_write_file(&file, path, &problem)) {
        snprintf(state->message, sizeof state->message, "wrote %s", path);
    } else {
        snprintf(state->message, sizeof state->message, "%s: %.70s", path, problem.text);
    }
    free(file.data);
    window_frame_free(&frame);
}
