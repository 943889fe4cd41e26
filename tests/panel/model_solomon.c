/* SPDX-License-Identifier: MIT */
/*
 * Solomon controllers whose memory is addressed by columns and rows: SSD0323 (4 bits a pixel, two in a byte; parameters
 * with D/C low) and SSD1351 (colour; parameters with D/C high). Read for it: what a module's vendor says of the
 * SSD1351's command 0xa0, and the like commands of the SSD1329, page 34. The rest was not checked against a data sheet.
 */
#include "model.h"

enum {
    SET_COLUMNS = 0x15,
    WRITE = 0x5c,
    SET_ROWS = 0x75,
    REMAP = 0xa0,
    START_LINE = 0xa1,
    OFFSET = 0xa2,
    SHOW = 0xa4, /* to 0xa7: in which order differs */
    DISPLAY_OFF = 0xae,
    DISPLAY_ON = 0xaf,
};

enum { REMAP_DOWNWARDS = 1 << 0, REMAP_COLUMNS = 1 << 1, REMAP_ROWS = 1 << 4 };

/* ---- Both ------------------------------------------------------------------------------------------------------- */

static void set_range(panel_model *model, int *first, int *last, int *at, int limit) {
    const int begin = model->parameters[0];
    const int end = model->parameters[1];

    if (begin > end || end >= limit) {
        model_complain(model, PANEL_COMPLAINT_WINDOW);
        return;
    }
    *first = *at = begin;
    *last = end;
    model->is_full = 0;
}

static void advance(panel_model *model) {
    model->is_full = model->memory_access & REMAP_DOWNWARDS ? model_step(&model->y, model->first_y, model->last_y) &&
                                                                  model_step(&model->x, model->first_x, model->last_x)
                                                            : model_step(&model->x, model->first_x, model->last_x) &&
                                                                  model_step(&model->y, model->first_y, model->last_y);
}

static void mind_overrun(panel_model *model) {
    if (model->is_full) {
        model_complain(model, PANEL_COMPLAINT_OVERRUN);
    }
}

static void reset_window(panel_model *model, int last_x, int last_y) {
    model->is_awake = 1; /* they have no sleep but display off */
    model->is_on = model->is_inverse = model->forces_on = model->forces_off = 0;
    model->is_full = 0;
    model->first_x = model->first_y = model->x = model->y = 0;
    model->last_x = last_x;
    model->last_y = last_y;
    model->start_line = model->offset = model->pump = model->unlocked = 0;
    model->lines = (uint8_t)last_y;
}

static void set_range_of(panel_model *model, int columns, int rows) {
    if (model->current == SET_COLUMNS) {
        set_range(model, &model->first_x, &model->last_x, &model->x, columns);
    } else {
        set_range(model, &model->first_y, &model->last_y, &model->y, rows);
    }
}

/* What the glass shows in place of a cell, where it is all off, all on or inverse. */
static uint8_t find_level(const panel_model *model, uint8_t level) {
    if (model->forces_off) {
        return 0;
    }
    if (model->forces_on) {
        return 255;
    }
    return model->is_inverse ? (uint8_t)(255 - level) : level;
}

static void copy_shown(const panel_model *model, const uint8_t *cell, uint8_t rgb[3]) {
    for (int i = 0; i < 3; i++) {
        rgb[i] = find_level(model, cell[i]);
    }
}

/* ---- SSD0323 ---------------------------------------------------------------------------------------------------- */

enum { GREY_WIDTH = 128, GREY_HEIGHT = 80, GREY_LINES = 0xa8, GREY_CONVERTER = 0xad, CONVERTER_ON = 3 };

static const model_rule grey_rules[] = {
    {SET_COLUMNS, 2, 2}, {SET_ROWS, 2, 2},   {0x81, 1, 1},       {0x84, 0, 0},       {0x85, 0, 0},
    {0x86, 0, 0},        {REMAP, 1, 1},      {START_LINE, 1, 1}, {OFFSET, 1, 1},     {SHOW, 0, 0},
    {SHOW + 1, 0, 0},    {SHOW + 2, 0, 0},   {SHOW + 3, 0, 0},   {GREY_LINES, 1, 1}, {GREY_CONVERTER, 1, 1},
    {DISPLAY_OFF, 0, 0}, {DISPLAY_ON, 0, 0}, {0xb0, 1, 1},       {0xb1, 1, 1},       {0xb2, 1, 1},
    {0xb3, 1, 1},        {0xb4, 1, 1},       {0xb8, 8, 8},       {0xbc, 1, 1},       {0xbe, 1, 1},
    {0xbf, 1, 1},        {0xe3, 0, 0},       {0, 1, 0},
};

static void grey_reset(panel_model *model) {
    reset_window(model, GREY_WIDTH / 2 - 1, GREY_HEIGHT - 1);
    model->memory_access = 0;
}

static void grey_data(panel_model *model, uint8_t byte) {
    panel_model_finish(model);
    mind_overrun(model);
    for (int half = 0; half < 2; half++) {
        uint8_t *cell = model_cell(model, 2 * model->x + half, model->y);
        cell[0] = cell[1] = cell[2] = model_level(half ? byte & 15u : byte >> 4, 15);
    }
    model->pixels += 2;
    advance(model);
}

static void grey_switch_on(panel_model *model) {
    if (model->pump != CONVERTER_ON) {
        model_complain(model, PANEL_COMPLAINT_DISPLAY);
    }
    /* The module's lines are wired for these settings alone, as its vendor uses them. */
    if (model->memory_access != 0x52 || model->offset != 0x4c || model->start_line != 0 || model->lines != 63) {
        model_complain(model, PANEL_COMPLAINT_WIRING);
    }
    model->is_on = 1;
}

static void grey_execute(panel_model *model, uint8_t byte) {
    if (byte >= SHOW && byte < SHOW + 4) {
        model->forces_on = byte == SHOW + 1;
        model->forces_off = byte == SHOW + 2;
        model->is_inverse = byte == SHOW + 3;
    } else if (byte == DISPLAY_ON) {
        grey_switch_on(model);
    } else if (byte == DISPLAY_OFF) {
        model->is_on = 0;
    }
}

static void grey_set(panel_model *model) {
    switch (model->current) {
    case SET_COLUMNS:
    case SET_ROWS:
        set_range_of(model, GREY_WIDTH / 2, GREY_HEIGHT);
        break;
    case REMAP:
        model->memory_access = model->parameters[0];
        break;
    case START_LINE:
        model->start_line = model->parameters[0];
        break;
    case OFFSET:
        model->offset = model->parameters[0];
        break;
    case GREY_LINES:
        model->lines = model->parameters[0];
        break;
    case GREY_CONVERTER:
        model->pump = model->parameters[0];
        break;
    default:
        break;
    }
}

static void grey_command(panel_model *model, uint8_t byte) {
    if (model->rule != NULL && model->parameter_count < model->rule->least) {
        if (model_take_parameter(model, byte)) {
            grey_set(model);
        }
    } else if (model_begin_command(model, byte) != NULL) {
        grey_execute(model, byte);
    }
}

static void grey_show(const panel_model *model, int column, int row, uint8_t rgb[3]) {
    copy_shown(model, model_cell(model, column, row), rgb);
}

/* A serial clock cycle of 250 ns. */
const model_controller model_ssd0323 = {GREY_WIDTH,
                                        GREY_HEIGHT,
                                        4000000,
                                        MODEL_MICROSECONDS(3),
                                        MODEL_MICROSECONDS(3),
                                        grey_rules,
                                        grey_reset,
                                        grey_command,
                                        grey_data,
                                        grey_show,
                                        NULL};

/* ---- SSD1351 ---------------------------------------------------------------------------------------------------- */

enum { COLOUR_SIZE = 128, COLOUR_LINES = 0xca, LOCK = 0xfd };

enum {
    REMAP_COLOURS = 1 << 2,
    REMAP_SPLIT = 1 << 5,
    REMAP_DEPTH = 3 << 6,
    DEPTH_16 = 1 << 6,
    LOCK_OPEN = 0x12,
    LOCK_CLOSED = 0x16,
    LOCK_GLASS_CLOSED = 0xb0,
    LOCK_GLASS_OPEN = 0xb1,
    UNLOCKED = 1,
    UNLOCKED_GLASS = 2,
};

static const model_rule colour_rules[] = {
    {SET_COLUMNS, 2, 2}, {WRITE, 0, MODEL_ANY}, {0x5d, 0, 0},     {SET_ROWS, 2, 2},   {0x96, 5, 5},
    {0x9e, 0, 0},        {0x9f, 0, 0},          {REMAP, 1, 1},    {START_LINE, 1, 1}, {OFFSET, 1, 1},
    {SHOW, 0, 0},        {SHOW + 1, 0, 0},      {SHOW + 2, 0, 0}, {SHOW + 3, 0, 0},   {0xab, 1, 1},
    {DISPLAY_OFF, 0, 0}, {DISPLAY_ON, 0, 0},    {0xb1, 1, 1},     {0xb2, 3, 3},       {0xb3, 1, 1},
    {0xb4, 3, 3},        {0xb5, 1, 1},          {0xb6, 1, 1},     {0xb8, 63, 63},     {0xb9, 0, 0},
    {0xbb, 1, 1},        {0xbe, 1, 1},          {0xc1, 3, 3},     {0xc7, 1, 1},       {COLOUR_LINES, 1, 1},
    {0xd1, 0, 0},        {0xe3, 0, 0},          {LOCK, 1, 1},     {0, 1, 0},
};

static void colour_reset(panel_model *model) {
    reset_window(model, COLOUR_SIZE - 1, COLOUR_SIZE - 1);
    model->memory_access = DEPTH_16;
    model->unlocked = UNLOCKED;
}

static void store(panel_model *model, const uint8_t bytes[2]) {
    const unsigned word = (unsigned)bytes[0] << 8 | bytes[1];
    const uint8_t high = model_level(word >> 11, 31);
    const uint8_t low = model_level(word & 31, 31);
    const int is_reversed = model->memory_access & REMAP_COLUMNS;
    uint8_t *cell = model_cell(model, is_reversed ? COLOUR_SIZE - 1 - model->x : model->x, model->y);

    mind_overrun(model);
    cell[0] = model->memory_access & REMAP_COLOURS ? high : low;
    cell[1] = model_level(word >> 5 & 63, 63);
    cell[2] = model->memory_access & REMAP_COLOURS ? low : high;
    model->pixels++;
    model->pending_count = 0;
    advance(model);
}

static void colour_set(panel_model *model) {
    const uint8_t value = model->parameters[0];

    switch (model->current) {
    case SET_COLUMNS:
    case SET_ROWS:
        set_range_of(model, COLOUR_SIZE, COLOUR_SIZE);
        break;
    case REMAP:
        model->memory_access = value;
        if ((value & REMAP_DEPTH) != DEPTH_16) { /* other depths are not modelled */
            model_complain(model, PANEL_COMPLAINT_VALUE);
        }
        if (!(value & REMAP_SPLIT)) {
            model_complain(model, PANEL_COMPLAINT_WIRING);
        }
        break;
    case START_LINE:
        model->start_line = value;
        break;
    case OFFSET:
        model->offset = value;
        break;
    case COLOUR_LINES:
        model->lines = value;
        if (value < 15 || value > 127) {
            model_complain(model, PANEL_COMPLAINT_VALUE);
        }
        break;
    case LOCK:
        if (value == LOCK_OPEN || value == LOCK_CLOSED) {
            model->unlocked = (uint8_t)(value == LOCK_OPEN ? model->unlocked | UNLOCKED : 0);
        } else if (value == LOCK_GLASS_CLOSED || value == LOCK_GLASS_OPEN) {
            model->unlocked = (uint8_t)((model->unlocked & UNLOCKED) | (value == LOCK_GLASS_OPEN ? UNLOCKED_GLASS : 0));
        } else {
            model_complain(model, PANEL_COMPLAINT_VALUE);
        }
        break;
    default:
        break;
    }
}

static int is_of_glass(uint8_t byte) {
    return byte == OFFSET || byte == 0xb1 || byte == 0xb3 || byte == 0xbb || byte == 0xbe || byte == 0xc1;
}

static void colour_command(panel_model *model, uint8_t byte) {
    if (model_begin_command(model, byte) == NULL) {
        return;
    }
    if (byte != LOCK && (!(model->unlocked & UNLOCKED) || (is_of_glass(byte) && !(model->unlocked & UNLOCKED_GLASS)))) {
        model_complain(model, PANEL_COMPLAINT_LOCKED);
    }
    if (byte == WRITE) {
        model->pending_count = 0;
    } else if (byte >= SHOW && byte < SHOW + 4) {
        model->forces_off = byte == SHOW;
        model->forces_on = byte == SHOW + 1;
        model->is_inverse = byte == SHOW + 3;
    } else if (byte == DISPLAY_ON || byte == DISPLAY_OFF) {
        model->is_on = byte == DISPLAY_ON;
    }
}

static void colour_data(panel_model *model, uint8_t byte) {
    if (model->current == WRITE) {
        model->pending[model->pending_count++] = byte;
        if (model->pending_count == 2) {
            store(model, model->pending);
        }
    } else if (model_take_parameter(model, byte)) {
        colour_set(model);
    }
}

/* `row` is the number of a common line; the scan may run from the last. */
static void colour_show(const panel_model *model, int column, int row, uint8_t rgb[3]) {
    const int line = model->memory_access & REMAP_ROWS ? model->lines - row : row;

    if (line < 0 || line > model->lines) {
        rgb[0] = rgb[1] = rgb[2] = 0;
        return;
    }
    copy_shown(model, model_cell(model, column, (line + model->start_line + model->offset) % COLOUR_SIZE), rgb);
}

/* A serial clock cycle of 220 ns. */
const model_controller model_ssd1351 = {COLOUR_SIZE,           COLOUR_SIZE,  4545454,      MODEL_MICROSECONDS(2),
                                        MODEL_MICROSECONDS(2), colour_rules, colour_reset, colour_command,
                                        colour_data,           colour_show,  NULL};
