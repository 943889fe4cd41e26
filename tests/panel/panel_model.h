/* SPDX-License-Identifier: MIT */
/**
 * @file panel_model.h
 * Models of panels: they take what a bus carries, execute it as the controller's documents say, complain about what
 * those forbid, and show what would be on the glass. Written from the controllers' behaviour, not from any driver.
 *
 * A module is a controller with a glass: which part of the memory the glass shows, how it is wired to the controller,
 * and in which order its colours lie. The picture is the glass seen in its native orientation.
 */
#ifndef GLINT_PANEL_MODEL_H
#define GLINT_PANEL_MODEL_H

#include <stddef.h>
#include <stdint.h>

/** What a model complains about. */
typedef enum panel_complaint {
    PANEL_COMPLAINT_COMMAND,    /**< A command that the controller does not have. */
    PANEL_COMPLAINT_PARAMETERS, /**< Too few or too many parameters. */
    PANEL_COMPLAINT_VALUE,      /**< A parameter that the controller does not allow. */
    PANEL_COMPLAINT_DATA,       /**< Data that no command asked for. */
    PANEL_COMPLAINT_ASLEEP,     /**< Pixels before the controller was woken. */
    PANEL_COMPLAINT_DISPLAY,    /**< The display was switched on before what feeds it. */
    PANEL_COMPLAINT_WINDOW,     /**< A window that does not lie in the memory. */
    PANEL_COMPLAINT_OVERRUN,    /**< More pixels than the window holds. */
    PANEL_COMPLAINT_DELAY,      /**< A command too soon after what it has to wait for. */
    PANEL_COMPLAINT_CLOCK,      /**< Bytes at a higher clock than the controller takes. */
    PANEL_COMPLAINT_RESET,      /**< Reset held for too short, or bytes during it. */
    PANEL_COMPLAINT_LOCKED,     /**< A command that is locked. */
    PANEL_COMPLAINT_WIRING,     /**< A setting that does not fit how the glass is wired. */
    PANEL_COMPLAINT_COUNT
} panel_complaint;

/** Complaints that are kept with their place; the others are only counted. */
#define PANEL_NOTES_MAX 16

/** Where a complaint arose. */
typedef struct panel_note {
    panel_complaint complaint;
    uint64_t byte;   /**< Bytes taken before. */
    uint8_t command; /**< The command last taken. */
} panel_note;

/** What the glass shows. Grey and one-bit glasses have three equal channels. */
typedef struct panel_picture {
    int width, height;
    uint8_t *rgb; /**< width * height * 3, rows from top to bottom. */
} panel_picture;

typedef struct panel_model panel_model;

/** Names of the modules, ended by null. */
const char *panel_module_name(unsigned index);

/** A module just powered on: its power-on reset has passed. Null when no module has the name, or no memory is left. */
panel_model *panel_model_begin(const char *name);

void panel_model_end(panel_model *model);

/**
 * Gives a module a smaller glass, as others of its controller have: it shows the memory's cells from (left, top) on.
 * Not for controllers that are told the size of their glass, which are those without sleep.
 */
void panel_model_set_glass(panel_model *model, int left, int top, int width, int height);

/** A byte with D/C low. */
void panel_model_command(panel_model *model, uint8_t byte);

/** A byte with D/C high. */
void panel_model_data(panel_model *model, uint8_t byte);

/** Time that passes without a byte. */
void panel_model_delay(panel_model *model, uint64_t nanoseconds);

/** The bus clock from now on, Hz; each byte takes 8 of its periods. 0, as at first: unknown, and bytes take no time. */
void panel_model_clock(panel_model *model, uint32_t hertz);

/** The reset line is pulled low (1) or let go (0). */
void panel_model_reset(panel_model *model, int active);

/** What is on the glass now. Filled in anew by each call; the model owns it. */
const panel_picture *panel_model_picture(panel_model *model);

/** A pixel of it. */
void panel_model_pixel(const panel_model *model, int x, int y, uint8_t rgb[3]);

/** Says that no more bytes come: a command that still waits for parameters is complained about. */
void panel_model_finish(panel_model *model);

/** How often a model complained of one thing, and in all. */
unsigned panel_model_complaints(const panel_model *model, panel_complaint complaint);
unsigned panel_model_all_complaints(const panel_model *model);

/** The first complaints, in order. @return how many of them there are, PANEL_NOTES_MAX at most. */
unsigned panel_model_notes(const panel_model *model, panel_note notes[PANEL_NOTES_MAX]);

/** A complaint as words. */
const char *panel_complaint_text(panel_complaint complaint);

/** Bytes taken so far, and pixels written into the memory. */
uint64_t panel_model_bytes(const panel_model *model);
uint64_t panel_model_pixels(const panel_model *model);

#endif
