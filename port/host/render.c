/* SPDX-License-Identifier: MIT */
#include "command.h"

#include "animation.h"
#include "maps.h"
#include "view.h"

#include <stdio.h>
#include <stdlib.h>

/** How long a turn takes to be shown. */
#define TURN_SECONDS 4

/* Milliseconds of sending, of drawing, and of both: one after the other, and at the same time, as well as that can go.
 */
static void print_times(const host_settings *settings, uint64_t bytes) {
    const double bus = settings->bus > 0 ? (double)bytes * 8 / (settings->bus * 1000) : 0;
    const double core = settings->core > 0 ? settings->instructions / settings->core * 1000 : 0;

    if (bus > 0) {
        printf("bus_ms %.3f\n", bus);
    }
    if (core > 0) {
        printf("core_ms %.3f\n", core);
    }
    if (bus > 0 && core > 0) {
        printf("frame_ms %.3f\n", bus + core);
        printf("frame_ms_overlapped %.3f\n", bus > core ? bus : core);
    }
}

void command_print_stats(const glint_stats *stats, const framebuffer *target, const host_settings *settings) {
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
    print_times(settings, target->bytes_sent);
}

/* ---- A picture -------------------------------------------------------------------------------------------------- */

/** Draws a picture, writes it, and compares it. @return exit status */
static int draw_still(const host_view *view, const host_settings *settings, const png_picture *other) {
    host_problem problem;
    framebuffer target;
    glint_stats stats;
    if (!maps_draw(&view->scene, settings, &target, &stats, &problem)) {
        return command_fail(NULL, &problem);
    }
    uint8_t *picture = framebuffer_expand(&target);
    const int status = command_finish(picture, &target, &stats, settings, other);
    free(picture);
    framebuffer_free(&target);
    return status;
}

/* ---- A turn ----------------------------------------------------------------------------------------------------- */

/** A model that turns. */
typedef struct turning_model {
    host_view *view;
    const host_settings *settings;
} turning_model;

static uint8_t *draw_turned(void *context, uint32_t frame, host_problem *problem) {
    const turning_model *model = context;
    framebuffer target;
    glint_stats stats;
    view_turn(model->view, model->settings, frame);
    if (!view_draw(&model->view->scene, model->settings, &target, &stats, problem)) {
        return NULL;
    }
    uint8_t *picture = framebuffer_expand(&target);
    framebuffer_free(&target);
    return picture;
}

/* ---- The command ------------------------------------------------------------------------------------------------ */

static int render(const host_settings *settings, const host_model *model, const quantised_mesh *mesh,
                  const png_picture *other) {
    host_problem problem;
    host_view view;
    if (!view_make(&view, settings, &model->materials, mesh, &problem)) {
        return command_fail(NULL, &problem);
    }
    turning_model turning = {&view, settings};
    const animation turn = {draw_turned, &turning, TURN_SECONDS, 1};
    const int status = settings->animate > 0 ? animation_write(&turn, settings) : draw_still(&view, settings, other);
    view_free(&view);
    return status;
}

int command_render(const host_settings *settings) {
    host_problem problem;
    host_model model;
    quantised_mesh mesh;
    png_picture other;
    if (!animation_check(settings, "render", &problem)) {
        return command_fail(NULL, &problem);
    }
    if (!command_open_compared(settings, &other)) {
        return COMMAND_FAILED;
    }
    int status = COMMAND_FAILED;
    if (command_load(settings, false, &model, &mesh)) {
        status = render(settings, &model, &mesh, &other);
        quantised_free(&mesh);
        if (status != COMMAND_FAILED) {
            command_print_warnings(settings, &model);
        }
        model_free(&model);
    }
    free(other.pixels);
    return status;
}
