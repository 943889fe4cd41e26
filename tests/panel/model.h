/* SPDX-License-Identifier: MIT */
/** @file model.h What the models of the controllers share; private to them. */
#ifndef GLINT_PANEL_MODEL_PRIVATE_H
#define GLINT_PANEL_MODEL_PRIVATE_H

#include "panel_model.h"

#define MODEL_MICROSECONDS(count) ((uint64_t)(count)*1000)
#define MODEL_MILLISECONDS(count) ((uint64_t)(count)*1000000)

enum { MODEL_PARAMETERS_MAX = 64, MODEL_ANY = 255 };

/** How many parameters a command has: MODEL_ANY at most when their number is not fixed. */
typedef struct model_rule {
    uint8_t command, least, most;
} model_rule;

typedef struct model_controller {
    int memory_width, memory_height; /* pixels */
    uint32_t clock_max;              /* Hz */
    uint64_t reset_low;              /* ns that reset is held at least */
    uint64_t reset_wait;             /* ns from its end to the first command */
    const model_rule *rules;         /* ended by least > most */
    void (*reset)(panel_model *model);
    void (*command)(panel_model *model, uint8_t byte);
    void (*data)(panel_model *model, uint8_t byte);
    /* The colour that line and segment of the glass shows; both count memory cells before any re-mapping. */
    void (*show)(const panel_model *model, int column, int row, uint8_t rgb[3]);
    const model_rule *own_rules; /* further ones, or null */
} model_controller;

/** A controller with its glass. */
typedef struct model_module {
    const char *name;
    const model_controller *controller;
    int width, height;      /* of the glass */
    int left, top;          /* the memory cell of its first column and row */
    int mirror_x, mirror_y; /* columns of the memory run to the left, rows upwards */
    int is_bgr;             /* colours of a pixel lie blue, green, red */
    int is_inverted;        /* the glass is dark where the controller means light */
    int is_round;
} model_module;

struct panel_model {
    const model_module *module;
    model_module own; /* where its glass is another */
    panel_picture picture;
    unsigned complaints[PANEL_COMPLAINT_COUNT];
    panel_note notes[PANEL_NOTES_MAX];
    unsigned note_count;
    uint64_t bytes, pixels;
    uint32_t clock;
    uint64_t now, reset_since; /* ns */
    uint64_t ready;            /* earliest time of the next command */
    uint64_t wake, sleep;      /* earliest time of leaving and of entering sleep */
    int in_reset;

    const model_rule *rule; /* of the command that takes parameters, or null */
    uint8_t current;        /* the command last taken */
    uint8_t parameters[MODEL_PARAMETERS_MAX];
    unsigned parameter_count;

    int is_writing;                       /* data are pixels */
    int is_full;                          /* the window has been filled */
    int first_x, last_x, first_y, last_y; /* the window, in the controller's addresses */
    int x, y;
    uint8_t pending[4]; /* bytes of pixels that are not complete */
    unsigned pending_count;

    int is_awake, is_on, is_inverse, forces_on, forces_off;
    uint8_t memory_access, pixel_format; /* MADCTL and COLMOD; Solomon's re-map */
    uint8_t mode;                        /* SSD1306: how addresses advance */
    uint8_t start_line, offset, lines, com_pins, pump, scan_reversed, segments_reversed;
    uint8_t unlocked;
    uint8_t *memory; /* 3 bytes a pixel, memory_width * memory_height */
};

/** Notes a complaint. */
void model_complain(panel_model *model, panel_complaint complaint);

/** The rule of a command, or null. */
const model_rule *model_find_rule(const model_controller *controller, uint8_t command);

/** Begins a command: ends the one before, looks its rule up, minds the time. @return its rule; null if unknown. */
const model_rule *model_begin_command(panel_model *model, uint8_t command);

/** Takes a parameter of the current command. @return 1 when it is complete now. */
int model_take_parameter(panel_model *model, uint8_t byte);

/** A cell of the memory, 3 bytes. */
uint8_t *model_cell(const panel_model *model, int column, int row);

/** A level of 0 to `top`, as one of 0 to 255, rounded to nearest. */
uint8_t model_level(unsigned level, unsigned top);

/** Steps `at` through its range, or back to it from beyond. @return 1 when it has begun again. */
int model_step(int *at, int first, int last);

/** Takes the current command's parameter as a register's value, and complains of one out of its range. */
void model_take_value(panel_model *model, uint8_t *value, uint8_t least, uint8_t most);

/**
 * What a glass of one bit a pixel shows of a memory of so many rows at a column and at common line `row`. Lines beyond
 * the multiplex ratio are not driven.
 */
void model_show_bit(const panel_model *model, int column, int row, int rows, uint8_t rgb[3]);

extern const model_controller model_ili9341, model_ili9488, model_st7789, model_st7735, model_st7735_large,
    model_gc9a01;
extern const model_controller model_ssd0323, model_ssd1306, model_ssd1351;
extern const model_controller model_sh1106, model_ssd0303, model_st7567;

#endif
