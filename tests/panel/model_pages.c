/* SPDX-License-Identifier: MIT */
/*
 * Controllers of one bit a pixel that are addressed page by page: SH1106, SSD0303, ST7567. Commands and their
 * parameters come with D/C low, memory with D/C high; the column counts up to the last of the page, and the page stays.
 *
 * Read for it: SH1106 V2.3 (memory, column counter), SSD0303 Rev 1.3 (Jul 2005) and SSD1303 Rev 1.7 (May 2005), page 27
 * (segment re-map), ST7565S (2009-09-07), table 16, whose commands ST7567 V1.4 has. Times and clocks were not checked
 * against a data sheet.
 */
#include "model.h"

enum { WIDTH = 132, HEIGHT = 64, ICON_HEIGHT = 72 };

enum {
    COLUMN_LOW = 0x00,
    COLUMN_HIGH = 0x10,
    RESISTORS = 0x20, /* ST7567, three bits in the byte */
    POWER = 0x28,     /* ST7567, three bits in the byte */
    PUMP = 0x30,      /* SH1106, two bits in the byte */
    START_LINE = 0x40,
    CONTRAST = 0x81,
    SEGMENTS = 0xa0,
    BIAS = 0xa2,
    FROM_MEMORY = 0xa4,
    NORMAL = 0xa6,
    LINES = 0xa8,
    CONVERTER = 0xad,
    DISPLAY_OFF = 0xae,
    DISPLAY_ON = 0xaf,
    PAGE = 0xb0,
    SCAN = 0xc0,
    SCAN_REVERSED = 0xc8,
    OFFSET = 0xd3,
    COM_PINS = 0xda,
    SOFTWARE_RESET = 0xe2,
    BOOSTER = 0xf8,
};

enum { CONVERTER_OFF = 0x8a, CONVERTER_ON = 0x8b, POWER_ALL = 7, PINS_ALTERNATE = 0x12 };

#define LAST_RULE \
    { 0, 1, 0 }

/* Commands whose parameter is part of the byte stand here by the lowest of them. */
static const model_rule rules[] = {
    {COLUMN_LOW, 0, 0},    {COLUMN_HIGH, 0, 0}, {START_LINE, 0, 0},
    {CONTRAST, 1, 1},      {SEGMENTS, 0, 0},    {SEGMENTS + 1, 0, 0},
    {0xe3, 0, 0},          {FROM_MEMORY, 0, 0}, {FROM_MEMORY + 1, 0, 0},
    {NORMAL, 0, 0},        {NORMAL + 1, 0, 0},  {DISPLAY_OFF, 0, 0},
    {DISPLAY_ON, 0, 0},    {PAGE, 0, 0},        {SCAN, 0, 0},
    {SCAN_REVERSED, 0, 0}, LAST_RULE,
};

static const model_rule sh1106_rules[] = {
    {PUMP, 0, 0},     {LINES, 1, 1}, {CONVERTER, 1, 1}, {OFFSET, 1, 1}, {0xd5, 1, 1}, {0xd9, 1, 1},
    {COM_PINS, 1, 1}, {0xdb, 1, 1},  {0xe0, 0, 0},      {0xee, 0, 0},   LAST_RULE,
};

static const model_rule ssd0303_rules[] = {
    {LINES, 1, 1},    {CONVERTER, 1, 1}, {OFFSET, 1, 1}, {0xd5, 1, 1}, {0xd8, 1, 1}, {0xd9, 1, 1},
    {COM_PINS, 1, 1}, {0xdb, 1, 1},      {0x91, 4, 4},   {0x92, 4, 4}, {0x93, 4, 4}, LAST_RULE,
};

static const model_rule st7567_rules[] = {
    {RESISTORS, 0, 0}, {POWER, 0, 0},          {BIAS, 0, 0},    {BIAS + 1, 0, 0}, {0xe0, 0, 0},
    {0xee, 0, 0},      {SOFTWARE_RESET, 0, 0}, {BOOSTER, 1, 1}, LAST_RULE,
};

static int is_lcd(const panel_model *model) {
    return model->module->controller == &model_st7567;
}

static void reset(panel_model *model) {
    model->is_awake = 1; /* they have no sleep but display off */
    model->is_on = model->is_inverse = model->forces_on = model->is_full = 0;
    model->x = model->y = 0;
    model->start_line = model->offset = model->scan_reversed = model->segments_reversed = 0;
    model->lines = HEIGHT - 1;
    model->com_pins = PINS_ALTERNATE;
    model->pump = is_lcd(model) ? 0 : CONVERTER_ON;
}

/* ---- Memory ----------------------------------------------------------------------------------------------------- */

static void data(panel_model *model, uint8_t byte) {
    panel_model_finish(model);
    if (model->x >= WIDTH) {
        model_complain(model, model->is_full ? PANEL_COMPLAINT_OVERRUN : PANEL_COMPLAINT_WINDOW);
        return;
    }
    for (int bit = 0; bit < 8; bit++) {
        uint8_t *cell = model_cell(model, model->x, model->y * 8 + bit);
        cell[0] = cell[1] = cell[2] = byte >> bit & 1 ? 255 : 0;
    }
    model->pixels += 8;
    model->is_full = ++model->x == WIDTH;
}

/* ---- Commands --------------------------------------------------------------------------------------------------- */

/* The lowest byte of a command that has its parameter in it. */
static uint8_t find_lowest(const panel_model *model, uint8_t byte) {
    static const uint8_t ranges[][2] = {{COLUMN_LOW, 15}, {COLUMN_HIGH, 15}, {RESISTORS, 7}, {POWER, 7},
                                        {PUMP, 3},        {START_LINE, 63},  {SCAN, 7},      {SCAN_REVERSED, 7}};

    if (byte >= PAGE && byte < PAGE + model->module->controller->memory_height / 8) {
        return PAGE;
    }
    for (unsigned i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        if (byte >= ranges[i][0] && byte <= ranges[i][0] + ranges[i][1]) {
            return ranges[i][0];
        }
    }
    return byte;
}

static void set_registers(panel_model *model) {
    uint8_t value;

    switch (model->current) {
    case LINES:
        model_take_value(model, &model->lines, 15, 63);
        break;
    case OFFSET:
        model_take_value(model, &model->offset, 0, 63);
        break;
    case COM_PINS:
        model_take_value(model, &model->com_pins, 0x02, 0x12);
        break;
    case CONVERTER:
        model_take_value(model, &model->pump, CONVERTER_OFF, CONVERTER_ON);
        break;
    case BOOSTER:
        model_take_value(model, &value, 0, 1);
        break;
    case CONTRAST:
        model_take_value(model, &value, 0, is_lcd(model) ? 63 : 255);
        break;
    default:
        break;
    }
}

static void switch_on(panel_model *model) {
    if (model->pump != (is_lcd(model) ? POWER_ALL : CONVERTER_ON)) {
        model_complain(model, PANEL_COMPLAINT_DISPLAY);
    }
    if (!is_lcd(model) && (model->lines != model->module->height - 1 || model->com_pins != PINS_ALTERNATE)) {
        model_complain(model, PANEL_COMPLAINT_WIRING);
    }
    model->is_on = 1;
}

static void set_column(panel_model *model, int column) {
    model->x = column;
    model->is_full = 0;
}

static void execute(panel_model *model, uint8_t lowest, uint8_t byte) {
    switch (lowest) {
    case COLUMN_LOW:
        set_column(model, (model->x & 0xf0) | (byte & 15));
        break;
    case COLUMN_HIGH:
        set_column(model, (model->x & 0x0f) | (byte & 15) << 4);
        break;
    case PAGE:
        model->y = byte - PAGE;
        break;
    case POWER:
        model->pump = byte & 7;
        break;
    case START_LINE:
        model->start_line = byte - START_LINE;
        break;
    case SEGMENTS:
    case SEGMENTS + 1:
        model->segments_reversed = byte & 1;
        break;
    case FROM_MEMORY:
    case FROM_MEMORY + 1:
        model->forces_on = byte & 1;
        break;
    case NORMAL:
    case NORMAL + 1:
        model->is_inverse = byte & 1;
        break;
    case SCAN:
    case SCAN_REVERSED:
        model->scan_reversed = lowest == SCAN_REVERSED;
        break;
    case DISPLAY_OFF:
        model->is_on = 0;
        break;
    case DISPLAY_ON:
        switch_on(model);
        break;
    case SOFTWARE_RESET:
        reset(model);
        break;
    default:
        break;
    }
}

static void command(panel_model *model, uint8_t byte) {
    const uint8_t lowest = find_lowest(model, byte);

    if (model->rule != NULL && model->parameter_count < model->rule->least) {
        if (model_take_parameter(model, byte)) {
            set_registers(model);
        }
    } else if (model_begin_command(model, lowest) != NULL) {
        model->current = byte;
        execute(model, lowest, byte);
    }
}

/* ---- Glass ------------------------------------------------------------------------------------------------------ */

/* `column` is the number of a segment. */
static void show(const panel_model *model, int column, int row, uint8_t rgb[3]) {
    model_show_bit(model, model->segments_reversed ? WIDTH - 1 - column : column, row, HEIGHT, rgb);
}

#define PAGES_CONTROLLER(height, own) \
    { WIDTH, height, 4000000, MODEL_MICROSECONDS(10), MODEL_MICROSECONDS(10), rules, reset, command, data, show, own }

/* A serial clock cycle of 250 ns; reset held for 10 us and waited for as long. */
const model_controller model_sh1106 = PAGES_CONTROLLER(HEIGHT, sh1106_rules);
const model_controller model_ssd0303 = PAGES_CONTROLLER(HEIGHT, ssd0303_rules);
const model_controller model_st7567 =
    PAGES_CONTROLLER(ICON_HEIGHT, st7567_rules); /* its ninth page: one row of icons */
