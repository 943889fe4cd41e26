/* SPDX-License-Identifier: MIT */
/*
 * Suite: the order of bytes on a bus that is done at random times; and what becomes of a bus or a panel that fails: a
 * bounded wait, a named error, and after glint_panel_start a frame that is whole.
 */
#include "harness.h"
#include "panels.h"
#include "picture.h"
#include "scenes.h"
#include "wire.h"

#include <stdio.h>
#include <string.h>

static uint32_t arena[1 << 16];

/* ---- Drawing ---------------------------------------------------------------------------------------------------- */

/* A panel's flush callbacks that keep the error which the renderer only reports as one. */
typedef struct guard {
    const glint_panel *driver;
    int status;
} guard;

static int guarded_begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    guard *guarded = context;

    guarded->status = glint_panel_begin(guarded->driver, x, y, width, height, pixels, stride);
    return guarded->status;
}

static int guarded_wait(void *context) {
    guard *guarded = context;

    guarded->status = glint_panel_wait(guarded->driver);
    return guarded->status;
}

static const glint_scene *example(void) {
    static test_scene scene;

    scene_build_named(&scene, "interlocked");
    return &scene.scene;
}

static glint_config configure(const glint_panel *driver) {
    glint_config config = {.width = glint_panel_width(driver), .height = glint_panel_height(driver)};

    config.format = glint_panel_format(driver);
    config.arena = arena;
    config.arena_size = sizeof arena;
    return config;
}

/* Draws a frame. @return what the panel said last. */
static int draw(const glint_panel *driver, int has_wait) {
    guard guarded = {driver, GLINT_OK};
    glint_config config = configure(driver);
    glint_renderer renderer;
    glint_status status;

    config.flush.begin = guarded_begin;
    config.flush.wait = has_wait ? guarded_wait : NULL;
    config.flush.context = &guarded;
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    status = glint_render(&renderer, example());
    CHECK_EQUAL(status, guarded.status ? GLINT_ERROR_FLUSH : GLINT_OK);
    return guarded.status;
}

/* What the glass of a panel shows after a frame on a bus without fault; kept until another panel is asked for. */
static const uint8_t *sound_picture(const tested_panel *panel) {
    static uint8_t kept[320 * 480 * 3];
    static const tested_panel *kept_of;
    wire line;
    const glint_panel driver = {panel->type, &line.bus};
    const panel_picture *picture;

    if (kept_of != panel) {
        wire_open(&line, panel->module, panel->type->clock_max, 1);
        CHECK_EQUAL(glint_panel_start(&driver), GLINT_OK);
        CHECK_EQUAL(draw(&driver, 1), GLINT_OK);
        picture = panel_model_picture(line.model);
        memcpy(kept, picture->rgb, (size_t)picture->width * (size_t)picture->height * 3);
        wire_close(&line);
        kept_of = panel;
    }
    return kept;
}

static int is_whole(const tested_panel *panel, wire *line) {
    const panel_picture *picture = panel_model_picture(line->model);

    return memcmp(picture->rgb, sound_picture(panel), (size_t)picture->width * (size_t)picture->height * 3) == 0;
}

/* ---- Order ------------------------------------------------------------------------------------------------------ */

static uint64_t order_of_bytes(const tested_panel *panel, uint32_t seed, int has_wait) {
    wire line;
    const glint_panel driver = {panel->type, &line.bus};
    uint64_t order;

    wire_open(&line, panel->module, panel->type->clock_max, 1);
    line.is_random = seed != 0;
    line.random = seed;
    CHECK_EQUAL(glint_panel_start(&driver), GLINT_OK);
    CHECK(draw(&driver, has_wait) == GLINT_OK || !has_wait);
    order = line.order;
    wire_close(&line);
    return order;
}

/* The same bytes in the same order however late they leave; and without `wait` they are not. */
static void order_is_the_same_at_random_times(void) {
    for (unsigned i = 0; i < tested_panel_count; i++) {
        const uint64_t wanted = order_of_bytes(&tested_panels[i], 0, 1);
        for (uint32_t seed = 1; seed <= 6; seed++) {
            CHECK(order_of_bytes(&tested_panels[i], seed, 1) == wanted);
        }
        CHECK(order_of_bytes(&tested_panels[i], 1, 0) != wanted);
    }
}

/* ---- Faults ----------------------------------------------------------------------------------------------------- */

typedef struct fault_case {
    const char *name;
    wire_fault fault;
    int status; /* what the panel's functions return */
} fault_case;

static const fault_case faults[] = {
    {"bus never ready", WIRE_NEVER_READY, GLINT_ERROR_TIMEOUT},
    {"transfer error", WIRE_BROKEN, GLINT_ERROR_BUS},
    {"100 times too slow", WIRE_SLOW, GLINT_ERROR_TIMEOUT},
    {"panel reset in mid-frame", WIRE_PANEL_RESET, GLINT_OK}, /* nobody is told: a panel does not answer */
    {"core reset in mid-frame", WIRE_CUT, GLINT_OK},
};

static void report(const tested_panel *panel, const fault_case *fault, unsigned call, int has_reset) {
    char text[120];

    snprintf(text, sizeof text, "  %s: %s at call %u, %s reset line\n", panel->module, fault->name, call,
             has_reset ? "with a" : "no");
    test_write(text);
}

/* After a start, the next frame is whole, and the model has nothing more to complain about. */
static int recovers(const tested_panel *panel, wire *line, const glint_panel *driver) {
    unsigned complaints;
    int good;

    wire_mend(line);
    good = CHECK_EQUAL(glint_panel_start(driver), GLINT_OK);
    complaints = panel_model_all_complaints(line->model);
    good &= CHECK_EQUAL(draw(driver, 1), GLINT_OK);
    good &= CHECK(is_whole(panel, line));
    good &= CHECK_EQUAL(panel_model_all_complaints(line->model), complaints);
    return good;
}

static void open_panel(const tested_panel *panel, wire *line, int has_reset) {
    wire_open(line, panel->module, panel->type->clock_max, has_reset);
    line->is_random = 1;
}

static void fail_in_frame(const tested_panel *panel, const fault_case *fault, unsigned call, int has_reset) {
    wire line;
    const glint_panel driver = {panel->type, &line.bus};
    int good;

    open_panel(panel, &line, has_reset);
    good = CHECK_EQUAL(glint_panel_start(&driver), GLINT_OK);
    wire_break(&line, fault->fault, call);
    good &= CHECK_EQUAL(draw(&driver, 1), fault->status);
    good &= CHECK(!is_whole(panel, &line));
    good &= CHECK_AT_MOST(line.polls_worst, WIRE_PATIENCE);
    if (!(good & recovers(panel, &line, &driver))) {
        report(panel, fault, call, has_reset);
    }
    wire_close(&line);
}

static void fail_in_start(const tested_panel *panel, const fault_case *fault, unsigned call, int has_reset) {
    wire line;
    const glint_panel driver = {panel->type, &line.bus};
    int good;

    open_panel(panel, &line, has_reset);
    wire_break(&line, fault->fault, call);
    good = CHECK_EQUAL(glint_panel_start(&driver), fault->status);
    good &= CHECK(line.is_lit == (fault->status == GLINT_OK));
    if (!(good & recovers(panel, &line, &driver))) {
        report(panel, fault, call, has_reset);
    }
    wire_close(&line);
}

/* Calls that a start and a frame take. */
static unsigned count_calls(const tested_panel *panel, int has_reset, unsigned *start) {
    wire line;
    const glint_panel driver = {panel->type, &line.bus};
    unsigned calls;

    open_panel(panel, &line, has_reset);
    CHECK_EQUAL(glint_panel_start(&driver), GLINT_OK);
    *start = line.calls;
    CHECK_EQUAL(draw(&driver, 1), GLINT_OK);
    calls = line.calls - *start;
    CHECK(is_whole(panel, &line));
    wire_close(&line);
    return calls;
}

/* At each call of the first tile and the first steps of the start, and at some later ones. */
static void every_fault_is_survived(void) {
    uint32_t random = 1;

    for (unsigned i = 0; i < 2 * tested_panel_count; i++) {
        const tested_panel *panel = &tested_panels[i / 2];
        const int has_reset = i % 2 == 0;
        unsigned start_calls;
        const unsigned calls = count_calls(panel, has_reset, &start_calls);
        for (unsigned kind = 0; kind < TEST_COUNT(faults); kind++) {
            for (unsigned call = 1; call <= 6; call++) {
                fail_in_frame(panel, &faults[kind], call < 6 ? call : 6 + wire_random(&random) % (calls - 6),
                              has_reset);
            }
            for (unsigned call = 1; call <= 3; call++) {
                fail_in_start(panel, &faults[kind], 1 + (call < 3 ? call - 1 : wire_random(&random)) % start_calls,
                              has_reset);
            }
        }
    }
}

/*
 * Where parameters go as commands do, a panel without a reset line may still wait for some. 0xb8 has 8, 0x21 has 2,
 * whose values are nonsense then.
 */
static void half_a_command_is_ended(void) {
    static const struct {
        const char *module;
        uint8_t command;
        unsigned complaints;
    } list[] = {
        {"ssd0323", 0xb8, 0}, {"ssd1306", 0x21, 1}, {"ssd0303", 0x91, 0}, {"sh1106", 0x81, 0}, {"st7567", 0xf8, 1}};

    for (unsigned i = 0; i < tested_panel_count; i++) {
        for (unsigned j = 0; j < TEST_COUNT(list); j++) {
            wire line;
            const glint_panel driver = {tested_panels[i].type, &line.bus};
            if (strcmp(tested_panels[i].module, list[j].module) != 0) {
                continue;
            }
            open_panel(&tested_panels[i], &line, 0);
            panel_model_delay(line.model, 1000000);
            panel_model_command(line.model, list[j].command);
            CHECK_EQUAL(glint_panel_start(&driver), GLINT_OK);
            CHECK_EQUAL(draw(&driver, 1), GLINT_OK);
            CHECK(is_whole(&tested_panels[i], &line));
            CHECK_EQUAL(panel_model_all_complaints(line.model), list[j].complaints);
            wire_close(&line);
        }
    }
}

/* What another program left behind in a panel without a reset line: awake and inverted. */
static void what_was_left_behind_is_reset(void) {
    for (unsigned i = 0; i < tested_panel_count; i++) {
        static const uint8_t left[] = {0x11, 0x21, 0x29};
        wire line;
        const glint_panel driver = {tested_panels[i].type, &line.bus};
        if (tested_panels[i].window_bytes != 11) {
            continue;
        }
        open_panel(&tested_panels[i], &line, 0);
        for (unsigned j = 0; j < TEST_COUNT(left); j++) {
            panel_model_delay(line.model, 120000000);
            panel_model_command(line.model, left[j]);
        }
        CHECK_EQUAL(glint_panel_start(&driver), GLINT_OK);
        CHECK_EQUAL(draw(&driver, 1), GLINT_OK);
        CHECK(is_whole(&tested_panels[i], &line));
        CHECK_EQUAL(panel_model_all_complaints(line.model), 0);
        wire_close(&line);
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(order_is_the_same_at_random_times),
        TEST_CASE(every_fault_is_survived),
        TEST_CASE(half_a_command_is_ended),
        TEST_CASE(what_was_left_behind_is_reset),
    };

    return test_run(write, cases, TEST_COUNT(cases));
}
