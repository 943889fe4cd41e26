/* SPDX-License-Identifier: MIT */
#include "command.h"

#include "view.h"

#include <string.h>

/** How long a turn takes to be shown. */
#define TURN_SECONDS 4

/** A model that may turn. */
typedef struct turning_model {
    host_view *view;
    const host_settings *settings;
    bool is_even, is_black; /* whether the last picture has one colour alone, and whether that is black */
} turning_model;

/** Returns whether all groups of so many bytes are the same. */
static bool is_even(const uint8_t *picture, size_t size, size_t group) {
    return memcmp(picture, picture + group, size - group) == 0;
}

static uint8_t *draw(void *context, uint32_t frame, framebuffer *target, glint_stats *stats, host_problem *problem) {
    turning_model *model = context;
    if (model->settings->animate > 0) {
        view_turn(model->view, model->settings, frame);
    }
    const bool ok = view_draw(&model->view->scene, model->settings, target, stats, problem);
    if (!ok) {
        return NULL;
    }
    uint8_t *picture = framebuffer_expand(target);
    const size_t channels = model->settings->format->channels;
    const size_t size = channels * model->settings->width * model->settings->height;
    model->is_even = is_even(picture, size, channels);
    model->is_black = picture[0] == 0 && is_even(picture, size, 1);
    return picture;
}

static int render(const host_settings *settings, const host_model *model, const quantised_mesh *mesh) {
    host_problem problem;
    host_view view;
    if (!view_make(&view, settings, &model->materials, mesh, &problem)) {
        return command_fail(NULL, &problem);
    }
    turning_model turning = {&view, settings, false, false};
    const command_picture turn = {draw, &turning, TURN_SECONDS, 1};
    const int status = command_draw(&turn, settings);
    if (status == 0 && settings->animate == 0 && turning.is_even &&
        view_explain(&view.scene, settings, turning.is_black, &problem)) {
        problem_print(settings->model, &problem);
    }
    view_free(&view);
    return status;
}

int command_render(const host_settings *settings) {
    host_problem problem;
    host_model model;
    quantised_mesh mesh;
    if (!command_check_frames(settings, "render", &problem)) {
        return command_fail(NULL, &problem);
    }
    if (!command_load(settings, false, &model, &mesh)) {
        return COMMAND_FAILED;
    }
    const int status = render(settings, &model, &mesh);
    if (status == 0) {
        command_print_warnings(settings, &model);
    }
    quantised_free(&mesh);
    model_free(&model);
    return status;
}
