/* SPDX-License-Identifier: MIT */
/**
 * @file measure.h
 * Counts frames that follow each other, and tells the bytes of arena that they need on a panel that is sent one tile
 * while the next is drawn.
 */
#ifndef GLINT_BENCH_MEASURE_H
#define GLINT_BENCH_MEASURE_H

#include "../cycles/marks.h"
#include "counter.h"
#include "glint.h"

typedef struct measured {
    uint64_t ticks;         /**< Of all frames. */
    size_t least, one_pass; /**< Of the arena, bytes: the largest of the frames. */
} measured;

static inline int measure_wait(void *context) {
    (void)context;
    return 0;
}

static inline glint_status measure_need(const glint_config *config, const glint_scene *scene, measured *result) {
    glint_config panel = *config;
    glint_need bytes;

    panel.flush.wait = measure_wait;
    const glint_status status = glint_arena_need(&panel, scene, &bytes);
    if (status == GLINT_OK) {
        result->least = bytes.least > result->least ? bytes.least : result->least;
        result->one_pass = bytes.one_pass > result->one_pass ? bytes.one_pass : result->one_pass;
    }
    return status;
}

/** Draws a frame and adds to `result`; the first one of an animation from glint_init on. */
static inline glint_status measure_frame(const glint_config *config, const glint_scene *scene, int first,
                                         glint_renderer *renderer, measured *result) {
    glint_status status = measure_need(config, scene, result);
    CYCLES_START();
    const uint32_t start = counter_now();
    if (status == GLINT_OK && first) {
        status = glint_init(renderer, config);
    }
    if (status == GLINT_OK) {
        status = glint_render(renderer, scene);
    }
    result->ticks += counter_ticks_since(start);
    CYCLES_STOP();
    return status;
}

/** The end of a line: instructions, the mean of so many frames, the least arena and that of one pass. */
static inline void measure_write(const measured *result, uint32_t frames) {
    const uint64_t instructions = result->ticks * COUNTER_INSTRUCTIONS_PER_TICK;

    write_number(frames ? (uint32_t)(instructions / frames) : 0, ",");
    write_number((uint32_t)result->least, ",");
    write_number((uint32_t)result->one_pass, "\n");
    CYCLES_WRITE();
}

#endif
