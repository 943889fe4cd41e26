/* SPDX-License-Identifier: MIT */
/**
 * @file command.h
 * The program's commands. Each takes the arguments after its name and returns the program's exit status: 0; 1 where
 * --compare found a difference; or 2 after one line on stderr, with no output file written.
 */
#ifndef GLINT_HOST_COMMAND_H
#define GLINT_HOST_COMMAND_H

#include "basics.h"
#include "model.h"
#include "png.h"
#include "quantise.h"
#include "settings.h"

/** Exit status for a picture that differs from the one that it is compared with. */
#define COMMAND_DIFFERS 1

/** Exit status for bad input and failed output. */
#define COMMAND_FAILED 2

/** Draws a model into a PNG. */
int command_render(const host_settings *settings);

/** Prints what there is to know about a model. */
int command_info(const host_settings *settings);

/** Writes a model as a C header, or as a C source and its header. */
int command_convert(const host_settings *settings);

/** Draws an example scene into a PNG or an APNG, or lists them. */
int command_scene(const host_settings *settings);

/** Draws the sheet that shows what the library does. */
int command_demo(const host_settings *settings);

/** Prints a problem with an input file, or with none when `file` is null. @return COMMAND_FAILED */
int command_fail(const char *file, const host_problem *problem);

/**
 * Loads the settings' model, places it, quantises it and gives it clusters. One to be `converted` is turned as options
 * say; any other is not, and scaled where it does not fit.
 * @return false with a problem; nothing is then to be freed, else the model and `mesh`
 */
bool command_prepare(const host_settings *settings, bool converted, host_model *model, quantised_mesh *mesh,
                     host_problem *problem);

/** The same, but prints what is wrong, and refuses a model that is the file to write. */
bool command_load(const host_settings *settings, bool converted, host_model *model, quantised_mesh *mesh);

/** Prints what a model says and is not followed, a line each. */
void command_print_warnings(const host_settings *settings, const host_model *model);

/** Says on stderr when a mesh is larger than what microcontrollers hold. */
void command_warn_of_size(const host_settings *settings, const quantised_mesh *mesh);

/** Prints what a frame took, a name and a value a line. */
void command_print_stats(const glint_stats *stats, const framebuffer *target);

/** Whether the settings say where the picture goes: to a file, the terminal, or into a comparison. */
bool command_has_output(const host_settings *settings);

/**
 * Reads the picture to compare with, or prints why not.
 * @param[out] other set up by this, the caller frees its pixels; they are null where nothing is to be compared
 */
bool command_open_compared(const host_settings *settings, png_picture *other);

/** A picture, or frames that follow each other. */
typedef struct command_picture {
    /**
     * Draws a frame, counted from 0.
     * @param target set up by this, the caller frees it; untouched when the result is null
     * @return the picture as png_encode takes it, for the caller to free; null with a problem
     */
    uint8_t *(*draw)(void *context, uint32_t frame, framebuffer *target, glint_stats *stats, host_problem *problem);
    void *context;
    uint32_t duration, rate; /**< It repeats after duration / rate seconds; each from 1 to 65535. */
} command_picture;

/**
 * Checks the options beside --animate, and the name of what is to be written; without --animate nothing.
 * @param command what a problem begins with
 * @return false with a problem
 */
bool command_check_frames(const host_settings *settings, const char *command, host_problem *problem);

/**
 * Draws and writes what the settings say: a picture, which is shown, measured and compared with another; or as many
 * frames as they say, to one file, or to one each where its name has a %d. Prints what is wrong.
 * @param other as of command_open_compared
 * @return exit status
 */
int command_draw(const command_picture *shown, const host_settings *settings, const png_picture *other);

/** Prints a mesh as NAME_meshSUFFIX, behind its arrays. @param name at most 65 characters */
void convert_mesh(host_bytes *out, const char *name, const glint_mesh *mesh, const char *suffix);

/** A character as an identifier may have it: what is no letter, digit or underscore becomes an underscore. */
char convert_plain(char c);

#endif
