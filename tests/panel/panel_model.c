/* SPDX-License-Identifier: MIT */
#include "model.h"

#include <stdlib.h>
#include <string.h>

/* ---- Modules, as they are commonly sold ------------------------------------------------------------------------- */

static const model_module modules[] = {
    {"ili9341", &model_ili9341, 240, 320, 0, 0, .mirror_x = 1, .is_bgr = 1},
    {"st7789-240x240", &model_st7789, 240, 240, 0, 0, .is_inverted = 1},
    {"st7789-240x320", &model_st7789, 240, 320, 0, 0, .is_inverted = 1},
    {"st7789-135x240", &model_st7789, 135, 240, 52, 40, .is_inverted = 1},
    {"st7735-green", &model_st7735_large, 128, 160, 2, 1, .mirror_x = 1, .mirror_y = 1, .is_bgr = 1},
    {"st7735-red", &model_st7735, 128, 160, 0, 0, .mirror_x = 1, .mirror_y = 1, .is_bgr = 1},
    {"st7735-black", &model_st7735, 128, 160, 0, 0, .mirror_x = 1, .mirror_y = 1},
    {"gc9a01", &model_gc9a01, 240, 240, 0, 0, .mirror_x = 1, .is_bgr = 1, .is_inverted = 1, .is_round = 1},
    {"ssd0323", &model_ssd0323, 128, 64, 0, 0},
    {"ssd1306", &model_ssd1306, 128, 64, 0, 0, .mirror_x = 1, .mirror_y = 1},
    {"ssd1351", &model_ssd1351, 128, 128, 0, 0, .mirror_y = 1},
    {"ili9488", &model_ili9488, 320, 480, 0, 0, .mirror_x = 1, .is_bgr = 1},
    {"sh1106", &model_sh1106, 128, 64, 2, 0, .mirror_x = 1, .mirror_y = 1},
    {"ssd0303", &model_ssd0303, 96, 16, 0, 0, .mirror_x = 1, .mirror_y = 1},
    {"st7567", &model_st7567, 128, 64, 0, 0, .mirror_y = 1, .is_inverted = 1},
};

enum { MODULE_COUNT = sizeof modules / sizeof modules[0] };

/* Less than any memory has, and no number of its rows. */
enum { SCRAMBLED = 4093 };

const char *panel_module_name(unsigned index) {
    return index < MODULE_COUNT ? modules[index].name : NULL;
}

/* ---- Life ------------------------------------------------------------------------------------------------------- */

static size_t memory_size(const panel_model *model) {
    const model_controller *controller = model->module->controller;

    return (size_t)controller->memory_width * (size_t)controller->memory_height * 3;
}

/* What memory holds after power-on is not known: no picture may depend on it. It begins again after SCRAMBLED bytes. */
static void scramble(panel_model *model) {
    const size_t size = memory_size(model);
    uint32_t state = 1;

    for (size_t i = 0; i < SCRAMBLED; i++) {
        state = state * 1664525u + 1013904223u;
        model->memory[i] = (uint8_t)(state >> 24);
    }
    for (size_t i = SCRAMBLED; i < size; i += SCRAMBLED) {
        memcpy(model->memory + i, model->memory, size - i < SCRAMBLED ? size - i : SCRAMBLED);
    }
}

static void reset_registers(panel_model *model) {
    model->rule = NULL;
    model->current = 0;
    model->is_writing = 0;
    model->ready = model->now + model->module->controller->reset_wait;
    model->module->controller->reset(model);
}

panel_model *panel_model_begin(const char *name) {
    const model_module *module = modules;
    panel_model *model;

    while (module < modules + MODULE_COUNT && strcmp(module->name, name) != 0) {
        module++;
    }
    model = module < modules + MODULE_COUNT ? calloc(1, sizeof *model) : NULL;
    if (model == NULL) {
        return NULL;
    }
    model->module = module;
    model->picture.width = module->width;
    model->picture.height = module->height;
    model->picture.rgb = malloc((size_t)module->width * (size_t)module->height * 3);
    model->memory = malloc(memory_size(model));
    if (model->picture.rgb == NULL || model->memory == NULL) {
        panel_model_end(model);
        return NULL;
    }
    scramble(model);
    reset_registers(model);
    return model;
}

void panel_model_end(panel_model *model) {
    if (model != NULL) {
        free(model->picture.rgb);
        free(model->memory);
        free(model);
    }
}

void panel_model_set_glass(panel_model *model, int left, int top, int width, int height) {
    model->own = *model->module;
    model->own.left = left;
    model->own.top = top;
    model->own.width = model->picture.width = width;
    model->own.height = model->picture.height = height;
    model->module = &model->own;
}

/* ---- Bus -------------------------------------------------------------------------------------------------------- */

/* @return whether the byte reaches the controller. */
static int take_byte(panel_model *model) {
    const uint32_t clock_max = model->module->controller->clock_max;

    if (model->in_reset) {
        model_complain(model, PANEL_COMPLAINT_RESET);
        return 0;
    }
    if (model->clock > clock_max) {
        model_complain(model, PANEL_COMPLAINT_CLOCK);
    }
    if (model->clock != 0) {
        model->now += 8000000000u / model->clock;
    }
    model->bytes++;
    return 1;
}

void panel_model_command(panel_model *model, uint8_t byte) {
    if (take_byte(model)) {
        model->module->controller->command(model, byte);
    }
}

void panel_model_data(panel_model *model, uint8_t byte) {
    if (take_byte(model)) {
        model->module->controller->data(model, byte);
    }
}

void panel_model_delay(panel_model *model, uint64_t nanoseconds) {
    model->now += nanoseconds;
}

void panel_model_clock(panel_model *model, uint32_t hertz) {
    model->clock = hertz;
}

void panel_model_reset(panel_model *model, int active) {
    if (active && !model->in_reset) {
        model->reset_since = model->now;
    }
    if (!active && model->in_reset) {
        if (model->now - model->reset_since < model->module->controller->reset_low) {
            model_complain(model, PANEL_COMPLAINT_RESET);
        }
        reset_registers(model);
    }
    model->in_reset = active;
}

void panel_model_finish(panel_model *model) {
    if (model->rule != NULL && model->parameter_count < model->rule->least) {
        model_complain(model, PANEL_COMPLAINT_PARAMETERS);
    }
    model->rule = NULL;
}

/* ---- Commands --------------------------------------------------------------------------------------------------- */

static const model_rule *find_in(const model_rule *rules, uint8_t command) {
    while (rules != NULL && rules->least <= rules->most) {
        if (rules->command == command) {
            return rules;
        }
        rules++;
    }
    return NULL;
}

const model_rule *model_find_rule(const model_controller *controller, uint8_t command) {
    const model_rule *rule = find_in(controller->rules, command);

    return rule != NULL ? rule : find_in(controller->own_rules, command);
}

const model_rule *model_begin_command(panel_model *model, uint8_t command) {
    panel_model_finish(model);
    model->current = command;
    model->parameter_count = 0;
    model->is_writing = 0;
    model->rule = model_find_rule(model->module->controller, command);
    if (model->rule == NULL) {
        model_complain(model, PANEL_COMPLAINT_COMMAND);
    }
    if (model->now < model->ready) {
        model_complain(model, PANEL_COMPLAINT_DELAY);
    }
    return model->rule;
}

int model_take_parameter(panel_model *model, uint8_t byte) {
    const model_rule *rule = model->rule;

    if (rule == NULL) {
        model_complain(model, PANEL_COMPLAINT_DATA);
        return 0;
    }
    if (model->parameter_count == rule->most) {
        model_complain(model, PANEL_COMPLAINT_PARAMETERS);
        return 0;
    }
    if (model->parameter_count < MODEL_PARAMETERS_MAX) {
        model->parameters[model->parameter_count] = byte;
    }
    return ++model->parameter_count == rule->least;
}

/* ---- Memory and picture ----------------------------------------------------------------------------------------- */

uint8_t *model_cell(const panel_model *model, int column, int row) {
    return model->memory + ((size_t)row * (size_t)model->module->controller->memory_width + (size_t)column) * 3;
}

uint8_t model_level(unsigned level, unsigned top) {
    return (uint8_t)((level * 255 + top / 2) / top);
}

int model_step(int *at, int first, int last) {
    if (*at >= last) {
        *at = first;
        return 1;
    }
    ++*at;
    return 0;
}

void model_take_value(panel_model *model, uint8_t *value, uint8_t least, uint8_t most) {
    *value = model->parameters[0];
    if (*value < least || *value > most) {
        model_complain(model, PANEL_COMPLAINT_VALUE);
    }
}

void model_show_bit(const panel_model *model, int column, int row, int rows, uint8_t rgb[3]) {
    const int line = model->scan_reversed ? model->lines - row : row;
    const uint8_t *cell = model_cell(model, column, (line + model->start_line + model->offset + rows) % rows);
    const int is_driven = line >= 0 && line <= model->lines;
    const int is_lit = model->forces_on || (cell[0] != 0) != model->is_inverse;

    rgb[0] = rgb[1] = rgb[2] = is_driven && is_lit ? 255 : 0;
}

/* On a round glass, pixels are seen whose centres lie in its circle. */
static int is_seen(const model_module *module, int x, int y) {
    const int across = 2 * x + 1 - module->width;
    const int down = 2 * y + 1 - module->height;

    return !module->is_round || across * across + down * down <= module->width * module->width;
}

static void find_colour(const panel_model *model, int x, int y, uint8_t rgb[3]) {
    const model_module *module = model->module;
    const int column = module->left + (module->mirror_x ? module->width - 1 - x : x);
    const int row = module->top + (module->mirror_y ? module->height - 1 - y : y);
    const uint8_t light = module->is_inverted ? 255 : 0;

    module->controller->show(model, column, row, rgb);
    if (module->is_bgr) {
        const uint8_t red = rgb[2];
        rgb[2] = rgb[0];
        rgb[0] = red;
    }
    for (int i = 0; i < 3; i++) {
        rgb[i] ^= light;
    }
}

void panel_model_pixel(const panel_model *model, int x, int y, uint8_t rgb[3]) {
    memset(rgb, 0, 3);
    if (model->is_on && model->is_awake && !model->in_reset && is_seen(model->module, x, y)) {
        find_colour(model, x, y, rgb);
    }
}

const panel_picture *panel_model_picture(panel_model *model) {
    uint8_t *rgb = model->picture.rgb;

    for (int y = 0; y < model->picture.height; y++) {
        for (int x = 0; x < model->picture.width; x++, rgb += 3) {
            panel_model_pixel(model, x, y, rgb);
        }
    }
    return &model->picture;
}

/* ---- Complaints ------------------------------------------------------------------------------------------------- */

void model_complain(panel_model *model, panel_complaint complaint) {
    model->complaints[complaint]++;
    if (model->note_count < PANEL_NOTES_MAX) {
        panel_note *note = &model->notes[model->note_count++];
        note->complaint = complaint;
        note->byte = model->bytes;
        note->command = model->current;
    }
}

unsigned panel_model_complaints(const panel_model *model, panel_complaint complaint) {
    return model->complaints[complaint];
}

unsigned panel_model_all_complaints(const panel_model *model) {
    unsigned sum = 0;

    for (int i = 0; i < PANEL_COMPLAINT_COUNT; i++) {
        sum += model->complaints[i];
    }
    return sum;
}

unsigned panel_model_notes(const panel_model *model, panel_note notes[PANEL_NOTES_MAX]) {
    memcpy(notes, model->notes, sizeof model->notes);
    return model->note_count;
}

const char *panel_complaint_text(panel_complaint complaint) {
    static const char *const texts[PANEL_COMPLAINT_COUNT] = {
        "no such command",
        "wrong number of parameters",
        "a parameter that is not allowed",
        "data that no command asked for",
        "pixels before the controller was woken",
        "display on before what feeds it",
        "window outside the memory",
        "more pixels than the window holds",
        "too soon after the command or reset before",
        "bus clock too high",
        "reset too short, or bytes during reset",
        "a locked command",
        "a setting that does not fit the glass",
    };

    return complaint < PANEL_COMPLAINT_COUNT ? texts[complaint] : "unknown complaint";
}

uint64_t panel_model_bytes(const panel_model *model) {
    return model->bytes;
}

uint64_t panel_model_pixels(const panel_model *model) {
    return model->pixels;
}
