/* SPDX-License-Identifier: MIT */
#include "maps.h"

#include "heat.h"
#include "memory.h"
#include "output.h"
#include "png.h"
#include "progress.h"
#include "watch.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Writes a map of 3 bytes a pixel, and frees it. @return false with a problem that names the file */
static bool write_map(uint8_t *colours, const framebuffer *size, const char *path, host_problem *problem) {
    host_bytes file = {NULL, 0, 0};
    host_problem wrong;
    png_encode(&file, colours, size->width, size->height, 3);
    const bool ok = bytes_write_file(&file, path, &wrong);
    free(file.data);
    free(colours);
    return ok || problem_set(problem, 0, "%s %s", path, wrong.text);
}

/* ---- How pixels were lit ---------------------------------------------------------------------------------------- */

/** Prints the ways that are there: a colour, the pixels, and the name. */
static void print_ways(const uint8_t *ways, size_t count) {
    size_t pixels[WAYS] = {0};
    for (size_t i = 0; i < count; i++) {
        pixels[ways[i]]++;
    }
    for (int i = 0; i < WAYS; i++) {
        const uint8_t *colour = watch_looks[i].colour;
        if (pixels[i] > 0) {
            printf("lit_%02x%02x%02x %zu pixels: %s\n", colour[0], colour[1], colour[2], pixels[i],
                   watch_looks[i].name);
        }
    }
}

static bool write_ways(const uint8_t *ways, const framebuffer *target, const char *path, host_problem *problem) {
    const size_t count = (size_t)target->width * target->height;
    uint8_t *colours = memory_new(count, 3);
    for (size_t i = 0; i < count; i++) {
        memcpy(colours + 3 * i, watch_looks[ways[i]].colour, 3);
    }
    if (!write_map(colours, target, path, problem)) {
        return false;
    }
    print_ways(ways, count);
    return true;
}

/* ---- Errors ----------------------------------------------------------------------------------------------------- */

static bool write_heat(const glint_scene *scene, const host_settings *settings, const framebuffer *target,
                       host_problem *problem) {
    heat_map map;
    progress_begin("drawing in double precision", NULL);
    heat_find(&map, scene, settings, target);
    progress_end();
    const bool ok = write_map(heat_picture(&map), target, settings->heat, problem);
    if (ok) {
        printf("steps_worst %.3f\nsteps_worst_at %lu,%lu\n", map.worst, (unsigned long)map.worst_x,
               (unsigned long)map.worst_y);
        printf("pixels_judged %ld\npixels_over_half_a_step %ld\npixels_over_one_step %ld\n", map.judged, map.over_half,
               map.over_one);
    }
    heat_free(&map);
    return ok;
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

bool maps_draw(const glint_scene *scene, const host_settings *settings, framebuffer *target, frame_counts *counts,
               host_problem *problem) {
    watched seen = {settings->width, settings->height, NULL, NULL, NULL, 0};
    if (settings->lit_map != NULL) {
        seen.ways = memory_new((size_t)settings->width * settings->height, 1);
        watch_into(&seen);
    }
    progress_begin("drawing", NULL);
    const bool drawn = view_draw(scene, settings, target, counts, problem);
    progress_end();
    watch_into(NULL);
    bool ok = drawn && (settings->lit_map == NULL || write_ways(seen.ways, target, settings->lit_map, problem));
    ok = ok && (settings->heat == NULL || write_heat(scene, settings, target, problem));
    if (drawn && !ok) {
        framebuffer_free(target);
    }
    free(seen.ways);
    return ok;
}
