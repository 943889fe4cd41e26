/* SPDX-License-Identifier: MIT */
/*
 * Firmware that counts the instructions of the float renderer's frames of all workloads in RGB565 that it
 * draws, clear included. It writes a line for each, torus576,320x240 local float 8 points,INSTRUCTIONS
 */
#include "../../cycles/marks.h"
#include "../counter.h"
#include "../workloads.h"
#include "fpu.h"
#include "renderer.h"

/** The largest screen. */
enum { PIXELS = 320 * 240 };

/* Aligned to words, which clearing writes. */
static uint32_t colour[PIXELS / 2];
static int32_t depth[PIXELS];
static float_memory memory;
static workload_stage stage;

/* @return 0, or 1 when it cannot be drawn */
static int count(const workload *drawn) {
    const float_screen screen = {drawn->width, drawn->height, (uint16_t *)(void *)colour, depth};
    uint64_t ticks = 0;

    if (workload_build(&stage, drawn)) {
        board_write("no such variant\n");
        return 1;
    }
    if (!workload_is_bare(&stage)) {
        return 0; /* more than this renderer draws */
    }
    for (uint32_t frame = 0; frame < drawn->frames; frame++) {
        workload_set_frame(&stage, frame);
        CYCLES_START();
        const uint32_t start = counter_now();
        float_render(&screen, &memory, &stage.example.scene);
        ticks += counter_ticks_since(start);
        CYCLES_STOP();
    }
    board_write(drawn->scene);
    board_write(",");
    write_number(drawn->width, "x");
    write_number(drawn->height, " local float");
    board_write(*drawn->look ? " " : "");
    board_write(drawn->look);
    board_write(",");
    write_number(drawn->frames ? (uint32_t)(ticks * COUNTER_INSTRUCTIONS_PER_TICK / drawn->frames) : 0, "\n");
    CYCLES_WRITE();
    return 0;
}

int main(void) {
    int failed = 0;

    fpu_start();
    counter_start();
    for (uint32_t i = 0; i < workload_count() && !failed; i++) {
        const workload drawn = workload_get(i);
        if (*drawn.output->name == '\0') {
            failed = count(&drawn);
        }
    }
    return failed;
}
