/* SPDX-License-Identifier: MIT */
/*
 * Suite: panels over I2C. The messages are taken apart as the controllers do (SSD1306 Rev 1.5, section 8.1.5) and given
 * to the same models; the pictures must be those of the serial bus. Faults at every byte end in a stop condition and a
 * name.
 */
#include "panel/i2c.h"
#include "harness.h"
#include "panels.h"
#include "picture.h"
#include "scenes.h"
#include "wire.h"

#include <string.h>

enum { ADDRESS = 0x3d, RECORD_MAX = 64 };

/* What a byte of a message is. */
typedef enum expected { EXPECT_CONTROL, EXPECT_COMMAND, EXPECT_RAM, EXPECT_COMMANDS, EXPECT_RAMS } expected;

/* A slave, and what it noticed. */
typedef struct slave {
    panel_model *model; /* or null */
    expected next;
    int is_open;          /* between start and stop */
    unsigned bytes;       /* all, addresses too */
    unsigned failing;     /* the byte that is not acknowledged, from 1; 0 for none */
    glint_status failure; /* what it ends in */
    unsigned starts, stops, wrong;
    uint8_t record[RECORD_MAX];
    glint_i2c i2c;
    glint_bus bus;
} slave;

static glint_status take(slave *at, uint8_t byte) {
    if (at->bytes < RECORD_MAX) {
        at->record[at->bytes] = byte;
    }
    at->wrong += !at->is_open;
    return ++at->bytes == at->failing ? at->failure : GLINT_OK;
}

static void give(const slave *at, int is_data, uint8_t byte) {
    if (at->model) {
        (is_data ? panel_model_data : panel_model_command)(at->model, byte);
    }
}

static void take_control(slave *at, uint8_t byte) {
    static const expected next[2][2] = {{EXPECT_COMMANDS, EXPECT_RAMS}, {EXPECT_COMMAND, EXPECT_RAM}};

    at->wrong += (byte & 0x3f) != 0;
    at->next = next[byte >> 7][byte >> 6 & 1];
}

static glint_status take_message_byte(slave *at, uint8_t byte) {
    const glint_status status = take(at, byte);

    if (status) {
        return status;
    }
    if (at->next == EXPECT_CONTROL) {
        take_control(at, byte);
    } else {
        give(at, at->next == EXPECT_RAM || at->next == EXPECT_RAMS, byte);
        at->next = at->next == EXPECT_COMMAND || at->next == EXPECT_RAM ? EXPECT_CONTROL : at->next;
    }
    return GLINT_OK;
}

static glint_status i2c_start(void *context, uint8_t address, uint8_t first) {
    slave *at = context;

    at->wrong += (unsigned)at->is_open + (address != ADDRESS);
    at->is_open = 1;
    at->starts++;
    at->next = EXPECT_CONTROL;
    const glint_status status = take(at, (uint8_t)(address << 1));
    return status ? status : take_message_byte(at, first);
}

static glint_status i2c_write(void *context, const uint8_t *bytes, size_t count) {
    glint_status status = GLINT_OK;

    for (size_t i = 0; i < count && !status; i++) {
        status = take_message_byte(context, bytes[i]);
    }
    return status;
}

static glint_status i2c_stop(void *context) {
    slave *at = context;

    at->wrong += !at->is_open;
    at->is_open = 0;
    at->stops++;
    return GLINT_OK;
}

static void delay(void *context, uint32_t milliseconds) {
    const slave *at = ((const glint_i2c *)context)->context;

    panel_model_delay(at->model, (uint64_t)milliseconds * 1000000);
}

static void open_slave(slave *at, const char *module) {
    memset(at, 0, sizeof *at);
    at->model = module ? panel_model_begin(module) : NULL;
    if (at->model) {
        panel_model_delay(at->model, 1000000); /* its power-on reset has passed */
    }
    at->i2c = (glint_i2c){i2c_start, i2c_write, i2c_stop, at, ADDRESS};
    at->bus = (glint_bus){.command = glint_i2c_command,
                          .data = glint_i2c_data,
                          .begin = glint_i2c_begin,
                          .delay = delay,
                          .context = &at->i2c};
}

/* ---- Pictures --------------------------------------------------------------------------------------------------- */

static glint_status draw(const glint_panel *driver) {
    static uint32_t arena[1 << 16];
    static test_scene scene;
    glint_renderer renderer;
    glint_config config = {.width = glint_panel_width(driver), .height = glint_panel_height(driver), .tile_height = 16};

    scene_build_named(&scene, "interlocked");
    config.format = glint_panel_format(driver);
    config.flush = glint_panel_flush(driver);
    config.arena = arena;
    config.arena_size = sizeof arena;
    const glint_status status = glint_init(&renderer, &config);
    return status ? status : glint_render(&renderer, &scene.scene);
}

static void compare(const tested_panel *panel, glint_panel_rotation rotation) {
    slave at;
    wire line;
    const glint_panel serial = {panel->type, &line.bus, rotation, NULL, 0};
    const glint_panel driver = {panel->type, &at.bus, rotation, NULL, 0};
    size_t size;

    wire_open(&line, panel->module, 0, 0);
    panel_model_delay(line.model, 1000000);
    open_slave(&at, panel->module);
    CHECK_EQUAL(glint_panel_start(&serial), GLINT_OK);
    CHECK_EQUAL(glint_panel_start(&driver), GLINT_OK);
    CHECK_EQUAL(draw(&serial), GLINT_OK);
    CHECK_EQUAL(draw(&driver), GLINT_OK);
    size = (size_t)panel->type->width * panel->type->height * 3;
    CHECK(memcmp(panel_model_picture(line.model)->rgb, panel_model_picture(at.model)->rgb, size) == 0);
    CHECK_EQUAL(panel_model_bytes(at.model), panel_model_bytes(line.model));
    CHECK_EQUAL(panel_model_all_complaints(at.model), 0);
    CHECK_EQUAL(at.wrong, 0);
    CHECK_EQUAL(at.starts, at.stops);
    panel_model_end(at.model);
    wire_close(&line);
}

/* All whose commands fit a control byte: those that have no D/C of their own for parameters. */
static void pictures_are_those_of_the_serial_bus(void) {
    unsigned compared = 0;

    for (unsigned i = 0; i < tested_panel_count; i++) {
        for (unsigned rotation = 0; rotation < 4 && tested_panels[i].bits[0] == 1; rotation++, compared++) {
            compare(&tested_panels[i], (glint_panel_rotation)rotation);
        }
    }
    CHECK_EQUAL(compared, 4 * 4);
}

/* ---- Bytes ------------------------------------------------------------------------------------------------------ */

static void control_bytes_tell_commands_from_data(void) {
    static const uint8_t pixels[2][4] = {{1, 2, 3, 99}, {4, 5, 6, 99}};
    static const uint8_t wanted[] = {0x7a, 0x80, 0xa8, 0x80, 0x0f, 0x7a, 0x40, 7, 0x7a, 0x40, 1, 2, 3, 4, 5, 6};
    static const uint8_t command[] = {0xa8, 0x0f}, data[] = {7};
    slave at;

    open_slave(&at, NULL);
    CHECK_EQUAL(at.bus.command(at.bus.context, command, sizeof command), GLINT_OK);
    CHECK_EQUAL(at.bus.data(at.bus.context, data, sizeof data), GLINT_OK);
    CHECK_EQUAL(at.bus.begin(at.bus.context, pixels[0], 3, 2, 4), GLINT_OK);
    CHECK_EQUAL(at.bytes, sizeof wanted);
    for (unsigned i = 0; i < sizeof wanted; i++) {
        CHECK_EQUAL(at.record[i], wanted[i]);
    }
    CHECK_EQUAL(at.stops, 3);
    CHECK_EQUAL(at.wrong, 0);
}

/* A byte that is not acknowledged, or takes too long: nothing follows it but the stop condition. */
static void a_fault_stops_the_message(void) {
    static const uint8_t bytes[] = {1, 2, 3, 4};
    static const glint_status failures[] = {GLINT_ERROR_BUS, GLINT_ERROR_TIMEOUT};

    for (unsigned kind = 0; kind < 2 * TEST_COUNT(failures); kind++) {
        const int is_command = kind & 1;
        const unsigned all = is_command ? 1 + 2 * sizeof bytes : 2 + sizeof bytes;
        for (unsigned failing = 1; failing <= all; failing++) {
            slave at;
            open_slave(&at, NULL);
            at.failing = failing;
            at.failure = failures[kind / 2];
            CHECK_EQUAL(is_command ? at.bus.command(at.bus.context, bytes, sizeof bytes)
                                   : at.bus.begin(at.bus.context, bytes, 2, 2, 2),
                        failures[kind / 2]);
            CHECK_EQUAL(at.bytes, failing);
            CHECK_EQUAL(at.stops, 1);
            CHECK_EQUAL(at.wrong, 0);
        }
    }
}

/* The frame that a fault ended begins anew after glint_panel_start. */
static void a_panel_recovers(void) {
    const tested_panel *panel = panels_find("sh1106");

    for (unsigned failing = 3; failing < 1200; failing += 61) {
        slave at;
        const glint_panel driver = {panel->type, &at.bus};
        open_slave(&at, panel->module);
        at.failing = failing;
        at.failure = GLINT_ERROR_BUS;
        const glint_status started = glint_panel_start(&driver);
        CHECK(started == GLINT_ERROR_BUS || draw(&driver) == GLINT_ERROR_FLUSH);
        CHECK_EQUAL(glint_panel_start(&driver), GLINT_OK);
        CHECK_EQUAL(draw(&driver), GLINT_OK);
        CHECK_EQUAL(panel_model_all_complaints(at.model), 0);
        CHECK_EQUAL(at.wrong, 0);
        panel_model_end(at.model);
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(pictures_are_those_of_the_serial_bus),
        TEST_CASE(control_bytes_tell_commands_from_data),
        TEST_CASE(a_fault_stops_the_message),
        TEST_CASE(a_panel_recovers),
    };

    return test_run(write, cases, TEST_COUNT(cases));
}
