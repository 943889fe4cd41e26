/* SPDX-License-Identifier: MIT */
/* The panel driver against a bus that records: what is sent, no byte more, and what becomes of a bus that fails. */
#include "harness.h"
#include "panel/solomon.h"
#include "panel/ssd0323.h"

enum { RECORD_MAX = 16384, COMMAND = 0x100, FRAME_BYTES = 128 / 2 * 64 };

static struct {
    uint16_t bytes[RECORD_MAX]; /* with COMMAND set when D/C was low */
    unsigned count;
    unsigned calls, failing_call; /* the call that fails, from 1; 0 for none */
    unsigned delayed, resets, waiting;
} record;

static glint_status keep(const uint8_t *bytes, size_t count, unsigned flag) {
    CHECK(!record.waiting);
    for (size_t i = 0; i < count && record.count < RECORD_MAX; i++) {
        record.bytes[record.count++] = (uint16_t)(bytes[i] | flag);
    }
    return ++record.calls == record.failing_call ? GLINT_ERROR_TIMEOUT : GLINT_OK;
}

static glint_status command(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    return keep(bytes, count, COMMAND);
}

static glint_status data(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    return keep(bytes, count, 0);
}

static glint_status begin(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    glint_status status = GLINT_OK;

    (void)context;
    for (size_t row = 0; row < rows && status == GLINT_OK; row++) {
        status = keep(bytes + row * stride, row_bytes, 0);
    }
    record.waiting = status == GLINT_OK;
    return status;
}

static glint_status wait(void *context) {
    (void)context;
    CHECK(record.waiting);
    record.waiting = 0;
    return ++record.calls == record.failing_call ? GLINT_ERROR_BUS : GLINT_OK;
}

static void reset(void *context, int active) {
    (void)context;
    record.resets += active != 0;
}

static void delay(void *context, uint32_t milliseconds) {
    (void)context;
    record.delayed += milliseconds;
}

static const glint_bus bus = {command, data, begin, wait, reset, NULL, delay, NULL};
static const glint_panel panel = {&glint_panel_ssd0323, &bus};

static void start_recording(unsigned failing_call) {
    record.count = record.calls = record.delayed = record.resets = record.waiting = 0;
    record.failing_call = failing_call;
}

static void starts_with_reset_and_commands(void) {
    start_recording(0);
    CHECK_EQUAL(glint_panel_start(&panel), 0);
    CHECK_EQUAL(record.resets, 1);
    CHECK_EQUAL(record.delayed, glint_panel_ssd0323.reset_low_ms + glint_panel_ssd0323.reset_wait_ms);
    CHECK(record.count > 0);
    for (unsigned i = 0; i < record.count; i++) {
        CHECK(record.bytes[i] & COMMAND);
    }
    CHECK_EQUAL(record.bytes[record.count - 1], COMMAND | 0xaf);
}

static void start_reports_a_dead_bus(void) {
    start_recording(3);
    CHECK_EQUAL(glint_panel_start(&panel), GLINT_ERROR_TIMEOUT);
    CHECK_EQUAL(record.calls, 3);
}

static void sends_window_and_pixels_only(void) {
    static const uint8_t pixels[3][8] = {{1, 2, 3, 99}, {4, 5, 6, 99}, {7, 8, 9, 99}};
    static const uint16_t wanted[] = {COMMAND | 0x15,
                                      COMMAND | 5,
                                      COMMAND | 7,
                                      COMMAND | 0x75,
                                      COMMAND | 20,
                                      COMMAND | 22,
                                      1,
                                      2,
                                      3,
                                      4,
                                      5,
                                      6,
                                      7,
                                      8,
                                      9};

    start_recording(0);
    CHECK_EQUAL(glint_panel_begin(&panel, 10, 20, 6, 3, pixels, sizeof pixels[0]), 0);
    CHECK_EQUAL(glint_panel_wait(&panel), 0);
    CHECK_EQUAL(record.count, TEST_COUNT(wanted));
    for (unsigned i = 0; i < TEST_COUNT(wanted); i++) {
        CHECK_EQUAL(record.bytes[i], wanted[i]);
    }
}

static void refuses_what_it_cannot_show(void) {
    static const int rectangles[][4] = {{-2, 0, 4, 4},  {0, -1, 4, 4}, {126, 0, 4, 4},        {0, 61, 4, 4},
                                        {1, 0, 4, 4},   {0, 0, 3, 4},  {0, 0, 0, 4},          {0, 0, 4, 0},
                                        {0, 0, 130, 4}, {0, 0, 4, 65}, {2147483646, 0, 4, 4}, {0, 2147483647, 4, 4}};
    static const uint8_t pixels[4];

    start_recording(0);
    for (unsigned i = 0; i < TEST_COUNT(rectangles); i++) {
        const int *r = rectangles[i];
        CHECK_EQUAL(glint_panel_begin(&panel, r[0], r[1], r[2], r[3], pixels, 1), GLINT_ERROR_REGION);
    }
    CHECK_EQUAL(record.count, 0);
}

/* An empty scene: 8 tiles of 32x32. */
static int draw(glint_status *status) {
    static uint32_t arena[3072];
    const glint_scene scene = {.camera = {glint_pose_identity(), GLINT_Q16(45), GLINT_Q16(0.1)}};
    glint_renderer renderer;
    glint_config config = {.width = 128, .height = 64, .tile_width = 32, .tile_height = 32};

    config.format = panel.type->format;
    config.flush = glint_panel_flush(&panel);
    config.arena = arena;
    config.arena_size = sizeof arena;
    if (!CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK)) {
        return 0;
    }
    *status = glint_render(&renderer, &scene);
    return 1;
}

static void a_frame_is_its_windows_and_its_pixels(void) {
    const unsigned tiles = 8, window_bytes = 6;
    glint_status status;

    start_recording(0);
    if (draw(&status)) {
        CHECK_EQUAL(status, GLINT_OK);
        CHECK_EQUAL(record.count, tiles * window_bytes + FRAME_BYTES);
    }
}

static void a_failing_bus_ends_the_frame(void) {
    const unsigned tile_calls = 1 + 32 + 1; /* window, rows, wait */
    glint_status status;

    for (unsigned call = 1; call <= 8 * tile_calls; call++) {
        start_recording(call);
        if (!draw(&status)) {
            return;
        }
        CHECK_EQUAL(status, GLINT_ERROR_FLUSH);
        CHECK(record.calls >= call && record.calls <= call + 1);
    }
    a_frame_is_its_windows_and_its_pixels();
}

/* ---- Types of one's own -------------------------------------------------------------------------------------- */

/* The same panel, with a glass of odd width, and a memory that ends with it or not. */
static void odd_glasses_take_what_memory_has(void) {
    static const uint8_t pixels[4] = {1, 2, 3, 4};
    glint_panel_type type = glint_panel_ssd0323;
    const glint_panel odd = {&type, &bus};

    type.width = 127;
    start_recording(0);
    CHECK_EQUAL(glint_panel_begin(&odd, 120, 0, 7, 1, pixels, sizeof pixels), GLINT_OK);
    CHECK_EQUAL(glint_panel_wait(&odd), GLINT_OK);
    CHECK_EQUAL(record.count, 6 + 4);
    type.memory_width = 127;
    start_recording(0);
    CHECK_EQUAL(glint_panel_begin(&odd, 120, 0, 7, 1, pixels, sizeof pixels), GLINT_ERROR_REGION);
    CHECK_EQUAL(record.count, 0);
    CHECK_EQUAL(glint_panel_begin(&odd, 120, 0, 6, 1, pixels, sizeof pixels), GLINT_OK);
    CHECK_EQUAL(glint_panel_wait(&odd), GLINT_OK);
}

/* A glass whose colours lie the other way differs in one bit of what starts it. */
static void colours_lie_as_the_glass_has_them(void) {
    enum { RED_FIRST = 1 << 2 };
    static uint16_t red_first[RECORD_MAX];
    glint_panel_type type = glint_panel_ssd0323;
    const glint_panel coloured = {&type, &bus};
    unsigned count, different = 0;

    type.family = &glint_panel_solomon_colour;
    type.format = &glint_format_rgb565_be;
    type.bits[0] = 16;
    type.glass = 0;
    start_recording(0);
    CHECK_EQUAL(glint_panel_start(&coloured), GLINT_OK);
    count = record.count;
    for (unsigned i = 0; i < count; i++) {
        red_first[i] = record.bytes[i];
    }
    type.glass = GLINT_PANEL_BGR;
    start_recording(0);
    CHECK_EQUAL(glint_panel_start(&coloured), GLINT_OK);
    CHECK_EQUAL(record.count, count);
    for (unsigned i = 0; i < count; i++) {
        different += record.bytes[i] != red_first[i];
        CHECK(record.bytes[i] == red_first[i] || (record.bytes[i] | RED_FIRST) == red_first[i]);
    }
    CHECK_EQUAL(different, 1);
}

/* Words are pixels of 16 bits; others are refused, whatever the bus can do. */
static void words_have_16_bits(void) {
    glint_bus with_words = bus;
    glint_panel_type type = glint_panel_ssd0323;
    const glint_panel wide = {&type, &with_words, GLINT_PANEL_0, &glint_format_rgb888, 1};
    const glint_panel whole = {&type, &with_words, GLINT_PANEL_0, &glint_format_rgb565, 1};

    with_words.begin_words = begin;
    type.bits[0] = 24;
    start_recording(0);
    CHECK_EQUAL(glint_panel_start(&wide), GLINT_ERROR_FORMAT);
    CHECK_EQUAL(record.count, 0);
    type.bits[0] = 16;
    CHECK_EQUAL(glint_panel_start(&whole), GLINT_OK);
    CHECK(record.count > 0);
}

int test_main(void (*write)(const char *text)) {
    static const test_case cases[] = {
        TEST_CASE(starts_with_reset_and_commands),
        TEST_CASE(start_reports_a_dead_bus),
        TEST_CASE(sends_window_and_pixels_only),
        TEST_CASE(refuses_what_it_cannot_show),
        TEST_CASE(a_frame_is_its_windows_and_its_pixels),
        TEST_CASE(a_failing_bus_ends_the_frame),
        TEST_CASE(odd_glasses_take_what_memory_has),
        TEST_CASE(colours_lie_as_the_glass_has_them),
        TEST_CASE(words_have_16_bits),
    };

    return test_run(write, cases, TEST_COUNT(cases));
}
