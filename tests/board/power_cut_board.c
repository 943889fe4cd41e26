/* SPDX-License-Identifier: MIT */
/*
 * Firmware whose power is cut: a timer resets the core at the instant that tests/board/power_cut.py has chosen,
 * anywhere from its first instruction on. It then starts as after any reset, and draws its first frame. What the
 * library writes to lies in memory that neither the reset nor start-up code touches: all of it is as the cut has left
 * it.
 */
#include "board.h"
#include "cortex-m/cortex-m.h"
#include "display.h"
#include "mps2-an385/lcd.h"
#include "panel/ili9341.h"
#include "text.h"
#include "turntable/turntable.h"

/* A memory beside that which the linker script names, and what is in it. The emulator writes the first word. */
enum { BESIDE = 0x21000000, INSTANT = BESIDE, NOTES = BESIDE + 0x100, VECTORS = BESIDE + 0x400 };
enum { RENDERER = BESIDE + 0x10000, ARENA = BESIDE + 0x20000 };

/* A timer of the board, counting down at 25 MHz; registers from Arm's public header for the board (SMM_MPS2.h). */
enum { TIMER = 0x40000000, TIMER_VALUE = TIMER + 0x04, TIMER_RELOAD = TIMER + 0x08, TIMER_CLEAR = TIMER + 0x0c };
enum { TIMER_RUNS_AND_INTERRUPTS = 1u << 0 | 1u << 3, INTERRUPT_TIMER = 8, INTERRUPT_LCD = 11, INTERRUPTS = 16 };

/* A register of light-emitting diodes, whose writes the trace shows: a picture is whole. */
enum { LEDS = 0x40028000 };

#define CLOCK_HZ 25000000
#define PAUSES_MAX 16
#define CORE_VECTORS 16
#define VECTOR_TABLE 0xe000ed08u
#define RESET_CONTROL 0xe000ed0cu
#define RESET_REQUEST 0x05fa0004u
#define INTERRUPTS_ENABLE 0xe000e100u
#define INTERRUPTS_PRIORITY 0xe000e400u /* 4 to a word */

/* Begin of the vectors in flash. */
extern const uint32_t linker_text_begin[];

typedef enum power_state { POWER_FRESH, POWER_ARMED, POWER_CUT } power_state;

/* What the firmware does from one mark to the next. */
typedef enum power_mark {
    MARK_STARTED,
    MARK_PANEL,
    MARK_SCENE,
    MARK_TILE,
    MARK_ROW,
    MARK_FRAME,
    MARK_NEXT_FRAME,
    MARKS
} power_mark;

typedef struct power_notes {
    power_state state;
    uint32_t place;                              /* the instruction before which the power was cut */
    uint32_t marks[MARKS];                       /* ticks since the timer was started */
    uint32_t pauses[PAUSES_MAX][2], pause_count; /* when the panel is waited for: nothing happens meanwhile */
    glint_flush flush;
} power_notes;

static power_notes *notes(void) {
    return (power_notes *)(uintptr_t)NOTES;
}

/* ---- The cut */

__attribute__((used)) static void cut_frame(const uint32_t *frame) {
    notes()->place = frame[6];
    notes()->state = POWER_CUT;
    *cortex_m_register(RESET_CONTROL) = RESET_REQUEST;
    for (;;) { /* the reset comes */
    }
}

__attribute__((naked)) static void cut(void) {
    __asm__ volatile("mrs r0, msp\n"
                     "ldr r1, =cut_frame\n"
                     "bx r1\n");
}

/* Starts the timer, which interrupts the transfer's interrupt as well, and begins as after a reset. */
static void arm(void) {
    const uint32_t instant = *cortex_m_register(INSTANT);
    volatile uint32_t *const vectors = cortex_m_register(VECTORS);

    for (int i = 0; i < CORE_VECTORS + INTERRUPTS; i++) {
        vectors[i] = linker_text_begin[i];
    }
    vectors[CORE_VECTORS + INTERRUPT_TIMER] = (uint32_t)(uintptr_t)cut;
    *cortex_m_register(VECTOR_TABLE) = VECTORS;
    *cortex_m_register(INTERRUPTS_PRIORITY + INTERRUPT_LCD / 4 * 4) = 0x80u << INTERRUPT_LCD % 4 * 8;
    *cortex_m_register(INTERRUPTS_ENABLE) = 1u << INTERRUPT_TIMER;
    notes()->state = POWER_ARMED;
    *cortex_m_register(TIMER_RELOAD) = instant;
    *cortex_m_register(TIMER_VALUE) = instant;
    *cortex_m_register(TIMER_CLEAR) = 1;
    *cortex_m_register(TIMER) = TIMER_RUNS_AND_INTERRUPTS;
    __asm__ volatile("msr msp, %0\n"
                     "bx %1\n"
                     :
                     : "r"(vectors[0]), "r"(vectors[1])
                     : "memory");
}

static uint32_t ticks(void) {
    return *cortex_m_register(TIMER_RELOAD) - *cortex_m_register(TIMER_VALUE);
}

static void mark(power_mark which) {
    notes()->marks[which] = ticks();
}

/* ---- Frames */

static int begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context;
    if (x == 0 && y == 0 && notes()->marks[MARK_TILE] == 0) {
        mark(MARK_TILE);
    }
    if (y > 0 && notes()->marks[MARK_ROW] == 0) {
        mark(MARK_ROW);
    }
    return notes()->flush.begin(notes()->flush.context, x, y, width, height, pixels, stride);
}

static int wait(void *context) {
    (void)context;
    return notes()->flush.wait(notes()->flush.context);
}

static void pause(void *context, uint32_t milliseconds) {
    power_notes *const to = notes();
    const uint32_t which = to->pause_count < PAUSES_MAX ? to->pause_count++ : PAUSES_MAX - 1;

    to->pauses[which][0] = ticks();
    mps2_lcd_bus.delay(context, milliseconds);
    to->pauses[which][1] = ticks();
}

/* The board's own display, on a bus whose pauses are noted. */
static glint_status start_display(board_display *display) {
    static glint_bus bus;
    static const glint_panel panel = {.type = &glint_panel_ili9341, .bus = &bus, .rotation = GLINT_PANEL_90};

    bus = mps2_lcd_bus;
    bus.delay = pause;
    notes()->pause_count = 0;
    mps2_lcd_start(CLOCK_HZ, glint_panel_ili9341.clock_max);
    return glint_display_start(&panel, display);
}

static glint_status start(glint_renderer *renderer) {
    board_display display;
    glint_status status;

    mark(MARK_STARTED);
    status = start_display(&display);
    if (status != GLINT_OK) {
        return status;
    }
    mark(MARK_PANEL);
    notes()->flush = display.flush;
    const glint_config config = {.width = display.width,
                                 .height = display.height,
                                 .format = display.format,
                                 .flush = {begin, wait, 0},
                                 .arena = (void *)(uintptr_t)ARENA,
                                 .arena_size = BOARD_ARENA,
                                 .keeps_arena = 1};
    return glint_init(renderer, &config);
}

static glint_status draw(glint_renderer *renderer, turntable_model model, power_mark done) {
    turntable table;

    turntable_frame(&table, model, 0);
    turntable_fit(&table, renderer->config.width, renderer->config.height);
    if (model == TURNTABLE_TORUS) {
        mark(MARK_SCENE);
    }
    const glint_status status = glint_render(renderer, &table.scene);
    mark(done);
    *cortex_m_register(LEDS) = 1u + (uint32_t)model;
    return status;
}

static void report(const char *what, uint32_t number) {
    char digits[TEXT_NUMBER_SIZE];

    board_write(what);
    board_write(text_number(digits, number));
    board_write("\n");
}

int main(void) {
    static const char *const names[MARKS] = {"started ", "panel ", "scene ", "tile ", "row ", "frame ", "next-frame "};
    glint_renderer *const renderer = (glint_renderer *)(uintptr_t)RENDERER;

    if (notes()->state == POWER_FRESH) {
        arm();
    }
    glint_status status = start(renderer);
    status = status == GLINT_OK ? draw(renderer, TURNTABLE_TORUS, MARK_FRAME) : status;
    if (notes()->state == POWER_CUT) {
        report("cut at ", notes()->place);
        return status != GLINT_OK;
    }
    status = status == GLINT_OK ? draw(renderer, TURNTABLE_TEAPOT, MARK_NEXT_FRAME) : status;
    for (int i = 0; i < MARKS; i++) {
        report(names[i], notes()->marks[i]);
    }
    for (uint32_t i = 0; i < 2 * notes()->pause_count; i++) {
        report(i % 2 ? "pause-ends " : "pause-begins ", notes()->pauses[i / 2][i % 2]);
    }
    return status != GLINT_OK;
}
