/* SPDX-License-Identifier: MIT */
/*
 * Solomon SSD1306: 128x64 pixels of one bit, in pages of 8 rows; commands and their parameters with D/C low, memory
 * with D/C high. Read for it: Rev 1.5 (Aug 2010), section 8.7 (memory, which end of a byte is up) and page 18 (serial
 * interface). The rest was not checked against a data sheet.
 */
#include "model.h"

enum { WIDTH = 128, HEIGHT = 64, PAGES = HEIGHT / 8 };

enum { MODE_HORIZONTAL, MODE_VERTICAL, MODE_PAGE };

enum {
    SET_MODE = 0x20,
    SET_COLUMNS = 0x21,
    SET_PAGES = 0x22,
    START_LINE = 0x40,
    CONTRAST = 0x81,
    CHARGE_PUMP = 0x8d,
    SEGMENTS = 0xa0,
    FROM_MEMORY = 0xa4,
    NORMAL = 0xa6,
    LINES = 0xa8,
    DISPLAY_OFF = 0xae,
    DISPLAY_ON = 0xaf,
    PAGE = 0xb0,
    SCAN = 0xc0,
    SCAN_REVERSED = 0xc8,
    OFFSET = 0xd3,
    COM_PINS = 0xda,
};

enum { PUMP_ON = 1 << 2, PINS_ALTERNATE = 0x12 };

static const model_rule rules[] = {
    {SET_MODE, 1, 1},     {SET_COLUMNS, 2, 2}, {SET_PAGES, 2, 2},     {0x26, 6, 6},
    {0x27, 6, 6},         {0x29, 5, 5},        {0x2a, 5, 5},          {0x2e, 0, 0},
    {0x2f, 0, 0},         {CONTRAST, 1, 1},    {CHARGE_PUMP, 1, 1},   {SEGMENTS, 0, 0},
    {SEGMENTS + 1, 0, 0}, {0xa3, 2, 2},        {FROM_MEMORY, 0, 0},   {FROM_MEMORY + 1, 0, 0},
    {NORMAL, 0, 0},       {NORMAL + 1, 0, 0},  {LINES, 1, 1},         {DISPLAY_OFF, 0, 0},
    {DISPLAY_ON, 0, 0},   {SCAN, 0, 0},        {SCAN_REVERSED, 0, 0}, {OFFSET, 1, 1},
    {0xd5, 1, 1},         {0xd9, 1, 1},        {COM_PINS, 1, 1},      {0xdb, 1, 1},
    {0xe3, 0, 0},         {0, 1, 0},
};

/* Commands whose parameter is part of the byte. */
static const model_rule in_byte = {0, 0, 0};

static void reset(panel_model *model) {
    model->is_awake = 1; /* it has no sleep but display off */
    model->is_on = model->is_inverse = model->forces_on = 0;
    model->mode = MODE_PAGE;
    model->first_x = model->first_y = model->x = model->y = 0;
    model->last_x = WIDTH - 1;
    model->last_y = PAGES - 1;
    model->is_full = 0;
    model->start_line = model->offset = model->pump = model->scan_reversed = model->segments_reversed = 0;
    model->lines = HEIGHT - 1;
    model->com_pins = PINS_ALTERNATE;
}

/* ---- Memory: rows of bytes, each byte as 8 cells ---------------------------------------------------------------- */

static void store(panel_model *model, uint8_t byte) {
    const int column = model->segments_reversed ? WIDTH - 1 - model->x : model->x;

    for (int bit = 0; bit < 8; bit++) {
        uint8_t *cell = model_cell(model, column, model->y * 8 + bit);
        cell[0] = cell[1] = cell[2] = byte >> bit & 1 ? 255 : 0;
    }
    model->pixels += 8;
}

static void advance(panel_model *model) {
    if (model->mode == MODE_PAGE) {
        model->is_full = model_step(&model->x, 0, WIDTH - 1);
    } else if (model->mode == MODE_HORIZONTAL) {
        model->is_full = model_step(&model->x, model->first_x, model->last_x) &&
                         model_step(&model->y, model->first_y, model->last_y);
    } else {
        model->is_full = model_step(&model->y, model->first_y, model->last_y) &&
                         model_step(&model->x, model->first_x, model->last_x);
    }
}

static void data(panel_model *model, uint8_t byte) {
    panel_model_finish(model);
    if (model->is_full) {
        model_complain(model, PANEL_COMPLAINT_OVERRUN);
    }
    store(model, byte);
    advance(model);
}

/* ---- Commands --------------------------------------------------------------------------------------------------- */

static void set_range(panel_model *model, int *first, int *last, int *at, int limit) {
    const int begin = model->parameters[0];
    const int end = model->parameters[1];

    if (begin > end || end >= limit || model->mode == MODE_PAGE) {
        model_complain(model, PANEL_COMPLAINT_WINDOW);
        return;
    }
    *first = *at = begin;
    *last = end;
    model->is_full = 0;
}

static void set_registers(panel_model *model) {
    switch (model->current) {
    case SET_MODE:
        model_take_value(model, &model->mode, MODE_HORIZONTAL, MODE_PAGE);
        break;
    case SET_COLUMNS:
        set_range(model, &model->first_x, &model->last_x, &model->x, WIDTH);
        break;
    case SET_PAGES:
        set_range(model, &model->first_y, &model->last_y, &model->y, PAGES);
        break;
    case CHARGE_PUMP:
        model_take_value(model, &model->pump, 0x10, 0x14);
        break;
    case LINES:
        model_take_value(model, &model->lines, 15, 63);
        break;
    case OFFSET:
        model_take_value(model, &model->offset, 0, 63);
        break;
    case COM_PINS:
        model_take_value(model, &model->com_pins, 0x02, 0x32);
        if (model->com_pins != PINS_ALTERNATE) {
            model_complain(model, PANEL_COMPLAINT_WIRING);
        }
        break;
    default:
        break;
    }
}

static void switch_on(panel_model *model) {
    if (!(model->pump & PUMP_ON)) {
        model_complain(model, PANEL_COMPLAINT_DISPLAY);
    }
    model->is_on = 1;
}

static void execute(panel_model *model, uint8_t byte) {
    if (byte == SEGMENTS || byte == SEGMENTS + 1) {
        model->segments_reversed = byte & 1;
    } else if (byte == FROM_MEMORY || byte == FROM_MEMORY + 1) {
        model->forces_on = byte & 1;
    } else if (byte == NORMAL || byte == NORMAL + 1) {
        model->is_inverse = byte & 1;
    } else if (byte == SCAN || byte == SCAN_REVERSED) {
        model->scan_reversed = byte == SCAN_REVERSED;
    } else if (byte == DISPLAY_ON) {
        switch_on(model);
    } else if (byte == DISPLAY_OFF) {
        model->is_on = 0;
    }
}

/* @return whether it was a command with its parameter in the byte. */
static int execute_in_byte(panel_model *model, uint8_t byte) {
    if (byte < 0x20) { /* column of page mode, low and high half */
        model->x = byte < 0x10 ? (model->x & 0x70) | byte : (model->x & 0x0f) | (byte & 7) << 4;
    } else if (byte >= START_LINE && byte < START_LINE + HEIGHT) {
        model->start_line = byte - START_LINE;
        return 1;
    } else if (byte >= PAGE && byte < PAGE + PAGES) {
        model->y = byte - PAGE;
    } else {
        return 0;
    }
    model->is_full = 0;
    if (model->mode != MODE_PAGE) {
        model_complain(model, PANEL_COMPLAINT_VALUE);
    }
    return 1;
}

static void command(panel_model *model, uint8_t byte) {
    if (model->rule != NULL && model->parameter_count < model->rule->least) {
        if (model_take_parameter(model, byte)) {
            set_registers(model);
        }
        return;
    }
    if (execute_in_byte(model, byte)) {
        model->rule = &in_byte;
        model->current = byte;
    } else if (model_begin_command(model, byte) != NULL) {
        execute(model, byte);
    }
}

/* ---- Glass ------------------------------------------------------------------------------------------------------ */

static void show(const panel_model *model, int column, int row, uint8_t rgb[3]) {
    model_show_bit(model, column, row, HEIGHT, rgb);
}

/* A serial clock cycle of 100 ns; reset held for 3 us and waited for as long. */
const model_controller model_ssd1306 = {
    WIDTH, HEIGHT, 10000000, MODEL_MICROSECONDS(3), MODEL_MICROSECONDS(3), rules, reset, command, data, show, NULL};
