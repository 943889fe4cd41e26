/* SPDX-License-Identifier: MIT */
/*
 * Firmware that breaks its bus in mid-frame, says by which error the frame ended, starts the panel again and draws the
 * next frame, which must be whole: tests/board/faults.py compares it with the host's. Last, a reset in mid-frame.
 */
#include "faults.h"

#include "board.h"
#include "turntable/turntable.h"

/** Tiles of a frame that are sent before something breaks. */
#define TILES_BEFORE 3

static uint32_t arena[BOARD_ARENA / sizeof(uint32_t)];

static glint_renderer renderer;

/* What happens between renderer and panel. */
static struct {
    fault_kind next;   /* breaks at its tile */
    int tiles, status; /* of this frame; what the panel said last */
    glint_flush flush;
} between;

static int guarded_begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context;
    if (between.tiles++ == TILES_BEFORE && between.next != FAULT_NONE) {
        faults_set(between.next);
    }
    between.status = between.flush.begin(between.flush.context, x, y, width, height, pixels, stride);
    return between.status;
}

static int guarded_wait(void *context) {
    (void)context;
    between.status = between.flush.wait(between.flush.context);
    return between.status;
}

/* Pictures 0 to 3. @return what the panel said last, or a glint_status that is not of its making. */
static int draw(uint32_t picture, fault_kind fault) {
    turntable table;

    between.next = fault;
    between.tiles = between.status = 0;
    turntable_frame(&table, (turntable_model)(picture / 2), picture % 2);
    turntable_fit(&table, glint_panel_width(&faults_panel), glint_panel_height(&faults_panel));
    const glint_status status = glint_render(&renderer, &table.scene);
    return status == GLINT_ERROR_FLUSH || status == GLINT_OK ? between.status : (int)status;
}

static int start(void) {
    const glint_config config = {.width = glint_panel_width(&faults_panel),
                                 .height = glint_panel_height(&faults_panel),
                                 .format = glint_panel_format(&faults_panel),
                                 .flush = {guarded_begin, guarded_wait, 0},
                                 .arena = arena,
                                 .arena_size = sizeof arena};

    between.flush = glint_panel_flush(&faults_panel);
    return glint_panel_start(&faults_panel) || glint_init(&renderer, &config);
}

static int show(uint32_t picture) {
    static const char *const names[] = {"torus576 0", "torus576 1", "teapot 0", "teapot 1"};
    const int status = draw(picture, FAULT_NONE);

    if (!status) {
        board_checkpoint(names[picture]);
    }
    return status;
}

/* Draws what the panel shows already until the bus breaks; then all of the next picture. */
static int survive(fault_kind fault, int expected, uint32_t picture) {
    const int status = draw(picture - 1, fault);

    faults_set(FAULT_NONE);
    board_write(status == GLINT_ERROR_TIMEOUT ? "timeout\n"
                : status == GLINT_ERROR_BUS   ? "fault\n"
                                              : "something else\n");
    return status != expected || start() || show(picture);
}

int main(void) {
    if (start() || show(0) || survive(FAULT_STOPPED, GLINT_ERROR_TIMEOUT, 1) ||
        survive(FAULT_SLOW, GLINT_ERROR_TIMEOUT, 2) || survive(FAULT_BROKEN, GLINT_ERROR_BUS, 3)) {
        return 1;
    }
    draw(2, FAULT_RESET);
    return 2; /* the reset has not come */
}
