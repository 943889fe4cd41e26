/* SPDX-License-Identifier: MIT */
#include "maps.h"

#include "heat.h"
#include "memory.h"
#include "output.h"
#include "png.h"
#include "progress.h"

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

bool maps_draw(const glint_scene *scene, const host_settings *settings, framebuffer *target, glint_stats *stats,
               host_problem *problem) {
    progress_begin("drawing", NULL);
    const bool drawn = view_draw(scene, settings, target, stats, problem);
    progress_end();
    const bool ok = drawn && (settings->heat == NULL || write_heat(scene, settings, target, problem));
    if (drawn && !ok) {
        framebuffer_free(target);
    }
    return ok;
}
