/* SPDX-License-Identifier: MIT */
#include "command.h"

#include "cost.h"
#include "maps.h"
#include "view.h"

#include <stdio.h>
#include <stdlib.h>

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

static void print_drawn(const glint_drawn *drawn) {
    static const char *const names[GLINT_KERNELS] = {
        "general", "ambient", "diffuse", "gated", "specular", "curved-diffuse", "curved-specular", "even", "channels"};
    for (int kernel = 0; kernel < GLINT_KERNELS; kernel++) {
        printf("parts_%s %lu\n", names[kernel], (unsigned long)drawn[kernel].parts);
        printf("covered_%s %lu\n", names[kernel], (unsigned long)drawn[kernel].covered);
    }
}

void command_print_stats(const frame_counts *counts, const framebuffer *target, const host_settings *settings) {
    const glint_stats *stats = &counts->stats;
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
    print_drawn(stats->drawn);
    printf("bytes_sent %llu\n", (unsigned long long)target->bytes_sent);
    cost_print(counts);
    print_times(settings, target->bytes_sent);
}

static int render(const host_settings *settings, const host_model *model, const quantised_mesh *mesh) {
    host_problem problem;
    host_view view;
    if (!view_make(&view, settings, &model->materials, mesh, &problem)) {
        return command_fail(NULL, &problem);
    }
    framebuffer target;
    frame_counts counts;
    const bool drawn = maps_draw(&view.scene, settings, &target, &counts, &problem);
    view_free(&view);
    if (!drawn) {
        return command_fail(NULL, &problem);
    }
    uint8_t *picture = framebuffer_expand(&target);
    const bool written = command_write_png(picture, settings, &problem);
    free(picture);
    if (written && settings->stats) {
        command_print_stats(&counts, &target, settings);
    }
    framebuffer_free(&target);
    return written ? 0 : command_fail(settings->output, &problem);
}

int command_render(const host_settings *settings) {
    host_model model;
    quantised_mesh mesh;
    if (!command_load(settings, false, &model, &mesh)) {
        return COMMAND_FAILED;
    }
    const int status = render(settings, &model, &mesh);
    quantised_free(&mesh);
    if (status == 0) {
        command_print_warnings(settings, &model);
    }
    model_free(&model);
    return status;
}
