/* SPDX-License-Identifier: MIT */
/*
 * Controllers that speak the MIPI display command set: ILI9341, ILI9488, ST7789, ST7735, GC9A01.
 *
 * Read for it: ST7735 V1.7 (2009-12-04), pages 38 (16-bit pixels), 78 (command list), 99 (column window), 103 (memory
 * write) and 109 (memory access); ST7735R V0.2 (2009-08-05), page 54 (12-bit pixels) and 62 (addresses under MV, MX,
 * MY); ILI9341, page 92 of 233 (bits of memory access, pixel formats); ILI9488 V100 (2012-11-28), page 121 (pixels on a
 * serial bus). Other values, above all times and clocks, were
 * not checked against a data sheet.
 *
 * Memory holds 8 bits a channel, levels expanded exactly, so that pictures compare with what was drawn; the controllers
 * keep 6.
 */
#include "model.h"

enum {
    SOFTWARE_RESET = 0x01,
    SLEEP_IN = 0x10,
    SLEEP_OUT = 0x11,
    INVERSION_OFF = 0x20,
    INVERSION_ON = 0x21,
    DISPLAY_OFF = 0x28,
    DISPLAY_ON = 0x29,
    COLUMNS = 0x2a,
    ROWS = 0x2b,
    WRITE = 0x2c,
    MEMORY_ACCESS = 0x36,
    PIXEL_FORMAT = 0x3a,
    WRITE_ON = 0x3c,
};

enum { ACCESS_BGR = 1 << 3, ACCESS_EXCHANGE = 1 << 5, ACCESS_MIRROR_X = 1 << 6, ACCESS_MIRROR_Y = 1 << 7 };

enum { FORMAT_12 = 3, FORMAT_16 = 5, FORMAT_18 = 6 };

#define LAST_RULE \
    { 0, 1, 0 }

static const model_rule rules[] = {
    {0x00, 0, 0}, {SOFTWARE_RESET, 0, 0}, {SLEEP_IN, 0, 0},      {SLEEP_OUT, 0, 0},
    {0x12, 0, 0}, {0x13, 0, 0},           {INVERSION_OFF, 0, 0}, {INVERSION_ON, 0, 0},
    {0x26, 1, 1}, {DISPLAY_OFF, 0, 0},    {DISPLAY_ON, 0, 0},    {COLUMNS, 4, 4},
    {ROWS, 4, 4}, {WRITE, 0, MODEL_ANY},  {0x30, 4, 4},          {0x33, 6, 6},
    {0x34, 0, 0}, {0x35, 1, 1},           {MEMORY_ACCESS, 1, 1}, {0x37, 2, 2},
    {0x38, 0, 0}, {0x39, 0, 0},           {PIXEL_FORMAT, 1, 1},  LAST_RULE,
};

/* ---- Addresses -------------------------------------------------------------------------------------------------- */

/* Columns and rows as the host counts them: exchanged by MV. */
static int host_width(const panel_model *model) {
    const model_controller *controller = model->module->controller;

    return model->memory_access & ACCESS_EXCHANGE ? controller->memory_height : controller->memory_width;
}

static int host_height(const panel_model *model) {
    const model_controller *controller = model->module->controller;

    return model->memory_access & ACCESS_EXCHANGE ? controller->memory_width : controller->memory_height;
}

/* The memory cell of an address: the mirrors act on memory columns and rows, after the exchange. */
static uint8_t *find_cell(const panel_model *model) {
    const model_controller *controller = model->module->controller;
    const int exchanged = model->memory_access & ACCESS_EXCHANGE;
    const int column = exchanged ? model->y : model->x;
    const int row = exchanged ? model->x : model->y;

    return model_cell(model, model->memory_access & ACCESS_MIRROR_X ? controller->memory_width - 1 - column : column,
                      model->memory_access & ACCESS_MIRROR_Y ? controller->memory_height - 1 - row : row);
}

static int window_fits(const panel_model *model) {
    return model->first_x <= model->last_x && model->first_y <= model->last_y && model->last_x < host_width(model) &&
           model->last_y < host_height(model);
}

static void begin_writing(panel_model *model) {
    model->is_writing = 1;
    model->is_full = 0;
    model->pending_count = 0;
    model->x = model->first_x;
    model->y = model->first_y;
    if (!model->is_awake) {
        model_complain(model, PANEL_COMPLAINT_ASLEEP);
    }
    if (!window_fits(model)) {
        model_complain(model, PANEL_COMPLAINT_WINDOW);
        model->is_writing = 0;
    }
}

/* ---- Pixels ----------------------------------------------------------------------------------------------------- */

static void store(panel_model *model, uint8_t first, uint8_t second, uint8_t third) {
    uint8_t *cell = find_cell(model);
    const int is_bgr = model->memory_access & ACCESS_BGR;

    if (model->is_full) {
        model_complain(model, PANEL_COMPLAINT_OVERRUN);
        model->is_full = 0;
    }
    cell[0] = is_bgr ? third : first;
    cell[1] = second;
    cell[2] = is_bgr ? first : third;
    model->pixels++;
    if (model->x++ == model->last_x) {
        model->x = model->first_x;
        if (model->y++ == model->last_y) {
            model->y = model->first_y;
            model->is_full = 1;
        }
    }
}

/* Two pixels in three bytes; a last pixel may stand alone in one byte and a half. */
static void take_12(panel_model *model, const uint8_t bytes[3]) {
    if (model->pending_count == 2) {
        store(model, model_level(bytes[0] >> 4, 15), model_level(bytes[0] & 15, 15), model_level(bytes[1] >> 4, 15));
    }
    if (model->pending_count == 3) {
        store(model, model_level(bytes[1] & 15, 15), model_level(bytes[2] >> 4, 15), model_level(bytes[2] & 15, 15));
        model->pending_count = 0;
    }
}

static void take_16(panel_model *model, const uint8_t bytes[2]) {
    const unsigned word = (unsigned)bytes[0] << 8 | bytes[1];

    if (model->pending_count == 2) {
        store(model, model_level(word >> 11, 31), model_level(word >> 5 & 63, 63), model_level(word & 31, 31));
        model->pending_count = 0;
    }
}

static void take_18(panel_model *model, const uint8_t bytes[3]) {
    if (model->pending_count == 3) {
        store(model, model_level(bytes[0] >> 2, 63), model_level(bytes[1] >> 2, 63), model_level(bytes[2] >> 2, 63));
        model->pending_count = 0;
    }
}

static void take_pixels(panel_model *model, uint8_t byte) {
    model->pending[model->pending_count++] = byte;
    switch (model->pixel_format & 7) {
    case FORMAT_12:
        take_12(model, model->pending);
        break;
    case FORMAT_16:
        take_16(model, model->pending);
        break;
    default:
        take_18(model, model->pending);
        break;
    }
}

/* ---- Commands --------------------------------------------------------------------------------------------------- */

static void reset(panel_model *model) {
    const model_controller *controller = model->module->controller;

    model->is_awake = model->is_on = model->is_inverse = model->unlocked = 0;
    model->memory_access = 0;
    model->pixel_format = FORMAT_18;
    model->first_x = model->first_y = 0;
    model->last_x = controller->memory_width - 1;
    model->last_y = controller->memory_height - 1;
    model->wake = model->now + MODEL_MILLISECONDS(120);
    model->sleep = model->now;
}

static void wake(panel_model *model) {
    if (model->now < model->wake) {
        model_complain(model, PANEL_COMPLAINT_DELAY);
    }
    model->is_awake = 1;
    model->ready = model->now + MODEL_MILLISECONDS(5);
    model->sleep = model->now + MODEL_MILLISECONDS(120);
}

static void fall_asleep(panel_model *model) {
    if (model->now < model->sleep) {
        model_complain(model, PANEL_COMPLAINT_DELAY);
    }
    model->is_awake = 0;
    model->ready = model->now + MODEL_MILLISECONDS(5);
    model->wake = model->now + MODEL_MILLISECONDS(120);
}

static void switch_on(panel_model *model) {
    if (!model->is_awake) {
        model_complain(model, PANEL_COMPLAINT_DISPLAY);
    }
    model->is_on = 1;
}

static void execute(panel_model *model, uint8_t byte) {
    switch (byte) {
    case SOFTWARE_RESET:
        model->ready = model->now + MODEL_MILLISECONDS(5);
        reset(model);
        break;
    case SLEEP_IN:
        fall_asleep(model);
        break;
    case SLEEP_OUT:
        wake(model);
        break;
    case INVERSION_OFF:
    case INVERSION_ON:
        model->is_inverse = byte == INVERSION_ON;
        break;
    case DISPLAY_OFF:
        model->is_on = 0;
        break;
    case DISPLAY_ON:
        switch_on(model);
        break;
    case WRITE:
        begin_writing(model);
        break;
    default:
        break;
    }
}

/* The GC9A01's own registers open when these two follow each other. */
enum { OPEN_FIRST = 0xfe, OPEN_SECOND = 0xef };

static void mind_lock(panel_model *model, uint8_t before, uint8_t byte) {
    const int is_own = model->module->controller == &model_gc9a01 && byte >= 0x60;

    if (is_own && byte == OPEN_SECOND && before == OPEN_FIRST) {
        model->unlocked = 1;
    } else if (is_own && byte != OPEN_FIRST && !model->unlocked) {
        model_complain(model, PANEL_COMPLAINT_LOCKED);
    }
}

static void command(panel_model *model, uint8_t byte) {
    const uint8_t before = model->current;

    if (model_begin_command(model, byte) != NULL) {
        mind_lock(model, before, byte);
        execute(model, byte);
    }
}

/* The ILI9488's pixels of 3 bits, which it takes too, are not modelled. */
static int has_format(const panel_model *model, unsigned format) {
    const model_controller *controller = model->module->controller;

    return format == FORMAT_18 || (format == FORMAT_16 && controller != &model_ili9488) ||
           (format == FORMAT_12 && controller != &model_ili9341 && controller != &model_ili9488);
}

static void set_registers(panel_model *model) {
    const uint8_t *bytes = model->parameters;

    switch (model->current) {
    case COLUMNS:
        model->first_x = bytes[0] << 8 | bytes[1];
        model->last_x = bytes[2] << 8 | bytes[3];
        break;
    case ROWS:
        model->first_y = bytes[0] << 8 | bytes[1];
        model->last_y = bytes[2] << 8 | bytes[3];
        break;
    case MEMORY_ACCESS:
        model->memory_access = bytes[0];
        break;
    case PIXEL_FORMAT:
        if (!has_format(model, bytes[0] & 7)) {
            model_complain(model, PANEL_COMPLAINT_VALUE);
        }
        model->pixel_format = bytes[0];
        break;
    default:
        break;
    }
}

static void data(panel_model *model, uint8_t byte) {
    if (model->current == WRITE) { /* where the window is outside the memory, pixels are lost */
        if (model->is_writing) {
            take_pixels(model, byte);
        }
    } else if (model_take_parameter(model, byte)) {
        set_registers(model);
    }
}

static void show(const panel_model *model, int column, int row, uint8_t rgb[3]) {
    const uint8_t *cell = model_cell(model, column, row);

    for (int i = 0; i < 3; i++) {
        rgb[i] = model->is_inverse ? (uint8_t)(255 - cell[i]) : cell[i];
    }
}

/* ---- Controllers ------------------------------------------------------------------------------------------------ */

static const model_rule ili9341_rules[] = {
    {0xb0, 1, 1}, {0xb1, 2, 2}, {0xb4, 1, 1}, {0xb5, 4, 4},   {0xb6, 3, 4},   {0xb7, 1, 1}, {0xc0, 1, 1},
    {0xc1, 1, 1}, {0xc5, 2, 2}, {0xc7, 1, 1}, {0xcb, 5, 5},   {0xcf, 3, 3},   {0xe8, 3, 3}, {0xea, 2, 2},
    {0xed, 4, 4}, {0xf2, 1, 1}, {0xf6, 3, 3}, {0xe0, 15, 15}, {0xe1, 15, 15}, {0xf7, 1, 1}, LAST_RULE,
};

static const model_rule ili9488_rules[] = {
    {0xb0, 1, 1}, {0xb1, 2, 2}, {0xb4, 1, 1}, {0xb6, 3, 3}, {0xb7, 1, 1},   {0xc0, 2, 2},   {0xc1, 1, 1},
    {0xc2, 1, 1}, {0xc5, 4, 4}, {0xe9, 1, 1}, {0xf7, 4, 4}, {0xe0, 15, 15}, {0xe1, 15, 15}, LAST_RULE,
};

static const model_rule st7789_rules[] = {
    {0xb0, 2, 2}, {0xb1, 3, 3}, {0xb2, 5, 5}, {0xb7, 1, 1}, {0xbb, 1, 1},   {0xc0, 1, 1},   {0xc2, 2, 2},
    {0xc3, 1, 1}, {0xc4, 1, 1}, {0xc6, 1, 1}, {0xd0, 2, 2}, {0xe0, 14, 14}, {0xe1, 14, 14}, LAST_RULE,
};

static const model_rule st7735_rules[] = {
    {0xb1, 3, 3}, {0xb2, 3, 3}, {0xb3, 6, 6}, {0xb4, 1, 1},   {0xb6, 2, 2},   {0xc0, 2, 3}, {0xc1, 1, 1}, {0xc2, 2, 2},
    {0xc3, 2, 2}, {0xc4, 2, 2}, {0xc5, 1, 2}, {0xe0, 16, 16}, {0xe1, 16, 16}, {0xfc, 1, 2}, LAST_RULE,
};

/* Registers that no document explains take any number of parameters. */
#define UNDOCUMENTED(command) \
    { command, 0, MODEL_ANY }

static const model_rule gc9a01_rules[] = {
    {OPEN_FIRST, 0, 0}, {OPEN_SECOND, 0, 0}, {0xb6, 2, 2},       {0xc3, 1, 1},       {0xc4, 1, 1},
    {0xc9, 1, 1},       {0xe8, 1, 1},        {0xf0, 6, 6},       {0xf1, 6, 6},       {0xf2, 6, 6},
    {0xf3, 6, 6},       UNDOCUMENTED(0x62),  UNDOCUMENTED(0x63), UNDOCUMENTED(0x64), UNDOCUMENTED(0x66),
    UNDOCUMENTED(0x67), UNDOCUMENTED(0x70),  UNDOCUMENTED(0x74), UNDOCUMENTED(0x84), UNDOCUMENTED(0x85),
    UNDOCUMENTED(0x86), UNDOCUMENTED(0x87),  UNDOCUMENTED(0x88), UNDOCUMENTED(0x89), UNDOCUMENTED(0x8a),
    UNDOCUMENTED(0x8b), UNDOCUMENTED(0x8c),  UNDOCUMENTED(0x8d), UNDOCUMENTED(0x8e), UNDOCUMENTED(0x8f),
    UNDOCUMENTED(0x90), UNDOCUMENTED(0x98),  UNDOCUMENTED(0xae), UNDOCUMENTED(0xbc), UNDOCUMENTED(0xbd),
    UNDOCUMENTED(0xbe), UNDOCUMENTED(0xcd),  UNDOCUMENTED(0xdf), UNDOCUMENTED(0xe1), UNDOCUMENTED(0xeb),
    UNDOCUMENTED(0xed), UNDOCUMENTED(0xff),  LAST_RULE,
};

#define DCS_RESET_LOW MODEL_MICROSECONDS(10)
#define DCS_RESET_WAIT MODEL_MILLISECONDS(5)

#define DCS_CONTROLLER(width, height, clock, rules_of_its_own) \
    { width, height, clock, DCS_RESET_LOW, DCS_RESET_WAIT, rules, reset, command, data, show, rules_of_its_own }

/* Serial write cycles of 100 ns, 66 ns, and 10 ns. */
const model_controller model_ili9341 = DCS_CONTROLLER(240, 320, 10000000, ili9341_rules);
const model_controller model_ili9488 = DCS_CONTROLLER(320, 480, 15151515, ili9488_rules);
const model_controller model_st7789 = DCS_CONTROLLER(240, 320, 15151515, st7789_rules);
const model_controller model_st7735 = DCS_CONTROLLER(128, 160, 15151515, st7735_rules);
const model_controller model_st7735_large = DCS_CONTROLLER(132, 162, 15151515, st7735_rules);
const model_controller model_gc9a01 = DCS_CONTROLLER(240, 240, 100000000, gc9a01_rules);
