/* SPDX-License-Identifier: MIT */
/*
 * libFuzzer target: a panel's driver, whose steps come in any order: starts, rectangles to send, waits, faults of the
 * bus or of the panel, time that passes. A step that befell no fault returns what it should, the panel's model
 * complains of nothing, and its glass shows what was sent. One that a fault befell names an error or nothing at all;
 * after a start, and at last in every run, the next frame is exact.
 */
#include "panel/i2c.h"
#include "panel/patterns.h"
#include "source.h"

#include <stddef.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { STEPS_MAX = 40, SIDE_MAX = 128, TILE_MAX = 64, MESSAGE_MAX = 16384, ADDRESS = 0x3c };

/* Panels that take any glass of their memory are given small ones. Of others the last frame is drawn in part, but for
 * one in so many runs. */
enum { GLASS_MIN = 2, GLASS_MAX = 32, PART = 8 };

/* ---- A bus of messages ------------------------------------------------------------------------------------------- */

/* I2C as a board has it, on top of the wire: a message is what stands between start and stop. Any panel may have it. */
typedef struct messages {
    wire *line;
    glint_i2c i2c;
    uint8_t bytes[MESSAGE_MAX];
    size_t count;
    int is_open;
} messages;

static glint_status add_bytes(void *context, const uint8_t *bytes, size_t count) {
    messages *to = context;

    require(to->is_open && count <= MESSAGE_MAX - to->count);
    memcpy(to->bytes + to->count, bytes, count);
    to->count += count;
    return GLINT_OK;
}

static glint_status open_message(void *context, uint8_t address, uint8_t first) {
    messages *to = context;

    require(!to->is_open && address == ADDRESS);
    to->is_open = 1;
    to->count = 0;
    return add_bytes(context, &first, 1);
}

/* A control byte in front of each byte of a command, or once before data. */
static glint_status close_message(void *context) {
    messages *to = context;
    const glint_bus *bus = &to->line->bus;
    size_t count = 0;

    require(to->is_open && to->count > 0);
    to->is_open = 0;
    if (to->bytes[0] == 0x40) {
        return bus->data(bus->context, to->bytes + 1, to->count - 1);
    }
    for (size_t i = 0; i + 1 < to->count; i += 2) {
        require(to->bytes[i] == 0x80);
        to->bytes[count++] = to->bytes[i + 1];
    }
    return bus->command(bus->context, to->bytes, count);
}

static void delay_messages(void *context, uint32_t milliseconds) {
    const messages *to = ((const glint_i2c *)context)->context;

    panel_model_delay(to->line->model, (uint64_t)milliseconds * 1000000);
}

/* ---- A panel ----------------------------------------------------------------------------------------------------- */

typedef struct run {
    source *from;
    wire line;
    glint_bus bus;
    glint_panel_type type;
    tested_panel panel;
    way to;
    int is_started, is_lost; /* what was sent since is on the glass; something befell it */
    unsigned complaints;     /* when it was started */
    uint32_t chosen;         /* a number that tells which of the last frame is drawn */
    uint8_t *tiles[STEPS_MAX + 1];
    unsigned tile_count; /* that may still be read */
    int is_checked;      /* all that was sent was seen on the glass */
    uint8_t is_known[SIDE_MAX * SIDE_MAX];
    uint8_t shown[SIDE_MAX * SIDE_MAX][3]; /* from here on nothing is cleared before a run */
    messages messages;
} run;

static int across(const run *r) {
    return glint_panel_width(&r->to.driver);
}

static int down(const run *r) {
    return glint_panel_height(&r->to.driver);
}

static int has_pages(const run *r) {
    return r->to.bits == 1 && r->to.driver.rotation % 2 == 0;
}

/* A glass of any size at any place of the memory. */
static void choose_glass(run *r) {
    glint_panel_type *type = &r->type;
    const uint32_t width = GLASS_MIN + below(r->from, GLASS_MAX - GLASS_MIN + 1);
    const uint32_t height = GLASS_MIN + below(r->from, GLASS_MAX - GLASS_MIN + 1);

    type->width = (uint16_t)width;
    type->height = (uint16_t)(type->glass & GLINT_PANEL_ROUND ? width : height);
    type->left = (uint16_t)below(r->from, type->memory_width - type->width + 1u);
    type->top = (uint16_t)below(r->from, type->memory_height - type->height + 1u);
    panel_model_set_glass(r->line.model, type->left, type->top, type->width, type->height);
}

static void choose_bus(run *r, int is_message) {
    r->bus = r->line.bus;
    if (is_message) {
        r->messages.line = &r->line;
        r->messages.is_open = 0;
        r->messages.i2c = (glint_i2c){open_message, add_bytes, close_message, &r->messages, ADDRESS};
        r->bus = (glint_bus){glint_i2c_command,
                             glint_i2c_data,
                             glint_i2c_begin,
                             NULL,
                             NULL,
                             NULL,
                             delay_messages,
                             &r->messages.i2c,
                             NULL};
    } else if (below(r->from, 4) == 1) { /* one that returns when all is sent */
        r->bus.wait = NULL;
        r->line.is_random = 0;
    }
}

static void choose_panel(run *r) {
    const tested_panel *panel = &tested_panels[below(r->from, tested_panel_count)];
    const uint32_t rotation = panel->can_turn ? below(r->from, 4) : 0;
    const uint32_t kind = below(r->from, 3), flags = take(r->from, 1);
    const unsigned bits = panel->bits[panel->bits[kind] ? kind : 0];

    wire_open(&r->line, panel->module, panel->type->clock_max >> (flags & 3), (int)(flags >> 2 & 1));
    r->line.is_random = 1;
    r->line.random = r->chosen = take(r->from, 2);
    r->type = *panel->type;
    if (panel->bits[0] > 4 && panel->type->family->recover[0] != GLINT_PANEL_END) {
        choose_glass(r);
    }
    r->panel = *panel;
    r->panel.type = &r->type;
    choose_bus(r, (flags & 8) != 0);
    r->to = way_choose(&r->panel, &r->line, rotation, bits, bits == 16 && (flags & 24) == 16);
    r->to.driver.bus = &r->bus;
}

/* ---- What is known ----------------------------------------------------------------------------------------------- */

static int is_busy(const run *r) {
    return r->line.transfer.is_busy;
}

/* A fault set off, at the latest by the call at hand. */
static int has_fault(const run *r) {
    return r->line.fault != WIRE_SOUND && r->line.calls >= r->line.fault_call;
}

/* Judges what a step returned that should have returned `wanted`; it began when there had been so many calls. */
static void judge(run *r, glint_status status, glint_status wanted, unsigned calls) {
    r->is_lost |= has_fault(r);
    require(status == wanted || (has_fault(r) && (status == GLINT_ERROR_TIMEOUT || status == GLINT_ERROR_BUS)));
    if (has_fault(r) && r->line.fault == WIRE_BROKEN && calls < r->line.fault_call) {
        require(status == GLINT_ERROR_BUS);
    }
    require(r->line.polls_worst <= WIRE_PATIENCE);
    require(r->is_lost || !r->is_started || panel_model_all_complaints(r->line.model) == r->complaints);
}

static void remember(run *r, const int rectangle[4], int shift) {
    const int width = across(r);

    r->is_checked = 0;
    for (int i = 0; i < rectangle[2] * rectangle[3]; i++) {
        const int x = rectangle[0] + i % rectangle[2], y = rectangle[1] + i / rectangle[2];
        const int at = y * width + x;
        r->is_known[at] = 1;
        pattern_expect(&r->to, x + shift, y, r->shown[at]);
    }
}

/* The glass shows all that is known of it. */
static void check_glass(run *r) {
    static const uint8_t dark[3];
    const int width = across(r), count = width * down(r);

    for (int i = 0; i < count; i++) {
        uint8_t glass[3];
        int at[2];
        if (!r->is_known[i]) {
            continue;
        }
        panels_find_on_glass(&r->type, r->to.driver.rotation, i % width, i / width, at);
        panel_model_pixel(r->line.model, at[0], at[1], glass);
        require(memcmp(glass, panels_is_seen(&r->panel, at[0], at[1]) ? r->shown[i] : dark, 3) == 0);
    }
    r->is_checked = 1;
}

/* ---- Steps ------------------------------------------------------------------------------------------------------- */

static void start(run *r) {
    const unsigned calls = r->line.calls;
    const int was_busy = is_busy(r);
    glint_status status;

    if (was_busy && !r->bus.reset) { /* a start is promised to mend faults, not a transfer that became commands */
        return;
    }
    r->is_started = r->line.is_lit = 0;
    status = glint_panel_start(&r->to.driver);
    judge(r, status, GLINT_OK, calls);
    require(!r->bus.backlight || r->line.is_lit == (status == GLINT_OK));
    r->is_started = status == GLINT_OK;
    r->is_lost = was_busy || has_fault(r);
    r->complaints = panel_model_all_complaints(r->line.model);
    memset(r->is_known, 0, sizeof r->is_known);
}

static void wait_for(run *r) {
    const unsigned calls = r->line.calls;

    judge(r, glint_panel_wait(&r->to.driver), GLINT_OK, calls);
    while (!is_busy(r) && r->tile_count > 0) {
        free(r->tiles[--r->tile_count]);
    }
}

/* Within the picture, and on whole bytes, a last column but for: that one a memory may have or not. */
static int is_sound(const run *r, const int rectangle[4]) {
    const int step = has_pages(r) || r->to.bits % 8 == 0 ? 1 : r->to.bits == 1 ? 8 : 2;
    const int line = has_pages(r) ? 8 : 1;
    const int x = rectangle[0], y = rectangle[1], width = rectangle[2], height = rectangle[3];

    return x >= 0 && y >= 0 && width > 0 && height > 0 && x < across(r) && y < down(r) && width <= across(r) - x &&
           height <= down(r) - y && x % step == 0 && y % line == 0 && height % line == 0 &&
           (width % step == 0 || x + width == across(r));
}

static int may_be_refused(const run *r, const int rectangle[4]) {
    return r->to.bits % 8 != 0 && !has_pages(r) && rectangle[2] % 2 != 0;
}

/* A tile whose memory ends where its last row does. */
static uint8_t *make_tile(run *r, const int rectangle[4], int shift, size_t *stride) {
    const int moved[4] = {rectangle[0] + shift, rectangle[1], rectangle[2], rectangle[3]};
    uint8_t *tile;

    *stride = glint_row_bytes(glint_panel_format(&r->to.driver), (uint32_t)(rectangle[2] + 7) / 8 * 8);
    tile = allocate(*stride * (size_t)rectangle[3]);
    memset(tile, 0, *stride * (size_t)rectangle[3]);
    pattern_fill(&r->to, tile, *stride, moved);
    r->tiles[r->tile_count++] = tile;
    return tile;
}

static void send(run *r, const int rectangle[4], int shift) {
    static const uint8_t none[1];
    const glint_flush flush = glint_panel_flush(&r->to.driver);
    const int sound = is_sound(r, rectangle);
    const unsigned calls = r->line.calls;
    size_t stride = 0;
    const uint8_t *tile = sound ? make_tile(r, rectangle, shift, &stride) : none;
    glint_status status;

    if (is_busy(r)) { /* no wait came before: nothing is promised, but that it ends */
        r->is_lost = 1;
    }
    status =
        (glint_status)flush.begin(flush.context, rectangle[0], rectangle[1], rectangle[2], rectangle[3], tile, stride);
    if (status == GLINT_ERROR_REGION && may_be_refused(r, rectangle)) {
        return;
    }
    if (r->is_lost && status == GLINT_ERROR_BUS) {
        return;
    }
    judge(r, status, sound ? GLINT_OK : GLINT_ERROR_REGION, calls);
    if (status == GLINT_OK) {
        remember(r, rectangle, shift);
    }
}

/* Of a side from some place to the end, as much as a tile may have: the wire gives up on what takes far longer. Mostly
 * a quarter of that, which is as good and sooner done. */
static int take_side(run *r, int left) {
    const int side = (int)below(r->from, left < TILE_MAX ? (uint32_t)left : TILE_MAX);

    return 1 + (side % 4 ? side / 4 : side);
}

/* Mostly a rectangle of the picture, on whole bytes. */
static void send_any(run *r) {
    const int step = r->to.bits % 8 == 0 ? 1 : 8, line = has_pages(r) ? 8 : 1;
    int rectangle[4];

    if (one_in(r->from, 16)) {
        for (int i = 0; i < 4; i++) {
            rectangle[i] = any(r->from);
        }
    } else {
        rectangle[0] = (int)below(r->from, (uint32_t)across(r)) / step * step;
        rectangle[1] = (int)below(r->from, (uint32_t)down(r)) / line * line;
        rectangle[2] = take_side(r, across(r) - rectangle[0]);
        rectangle[3] = take_side(r, down(r) - rectangle[1]);
        rectangle[2] = one_in(r->from, 8) ? rectangle[2] : (rectangle[2] + step - 1) / step * step;
        rectangle[3] = one_in(r->from, 8) ? rectangle[3] : (rectangle[3] + line - 1) / line * line;
    }
    send(r, rectangle, (int)below(r->from, 8));
}

/* A frame; of a large glass one rectangle in so many, or all of them. */
static void send_frame(run *r) {
    const int side = has_pages(r) || r->to.bits % 8 != 0 ? 32 : 19;
    const uint32_t step = across(r) * down(r) > GLASS_MAX * GLASS_MAX && r->chosen % PART ? PART : 1;
    uint32_t number = r->chosen;

    for (int y = 0; y < down(r); y += side) {
        for (int x = 0; x < across(r); x += side) {
            const int rectangle[4] = {x, y, across(r) - x < side ? across(r) - x : side,
                                      down(r) - y < side ? down(r) - y : side};
            if (number++ % step == 0) {
                send(r, rectangle, 0);
                wait_for(r);
            }
        }
    }
}

static void step(run *r) {
    switch (below(r->from, 8)) {
    case 0:
        start(r);
        break;
    case 1:
        wire_break(&r->line, (wire_fault)(1 + below(r->from, WIRE_CUT)), 1 + below(r->from, 64));
        break;
    case 2:
        r->line.fault = WIRE_SOUND; /* what was on its way still is */
        break;
    case 3:
        panel_model_delay(r->line.model, (uint64_t)take(r->from, 2) << below(r->from, 16));
        break;
    case 4:
    case 5:
        send_any(r);
        break;
    case 6:
        wait_for(r);
        break;
    default:
        if (r->is_started && !r->is_lost && !is_busy(r) && !r->is_checked) {
            check_glass(r);
        }
        break;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    source from = {data, size};
    static run r;

    memset(&r, 0, offsetof(run, shown));
    r.from = &from;
    choose_panel(&r);
    for (unsigned i = 0; i < STEPS_MAX && from.left > 0; i++) {
        step(&r);
    }
    wire_mend(&r.line);
    start(&r);
    send_frame(&r);
    check_glass(&r);
    require(r.is_started && !r.is_lost);
    wait_for(&r);
    wire_close(&r.line);
    return 0;
}
