/* SPDX-License-Identifier: MIT */
/**
 * @file command.h
 * The program's commands. Each takes the arguments after its name and returns the program's exit status: 0, or 2 after
 * one line on stderr, with no output file written.
 */
#ifndef GLINT_HOST_COMMAND_H
#define GLINT_HOST_COMMAND_H

#include "basics.h"
#include "model.h"
#include "png.h"
#include "quantise.h"
#include "settings.h"

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

/** A scene and the number of one of its variants. */
typedef struct chosen_scene {
    const struct example_scene *scene;
    uint32_t variant;
} chosen_scene;

/** Finds a scene and its variant by name; the default is the first variant. @return false with a problem */
bool scene_find(const char *name, chosen_scene *chosen, host_problem *problem);

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

/** Says on stderr when a mesh with its textures is larger than what microcontrollers hold. */
void command_warn_of_size(const host_settings *settings, const host_materials *materials, const quantised_mesh *mesh);

/** Prints what a frame took, a name and a value a line. */
void command_print_stats(const glint_stats *stats, const framebuffer *target);

/** Writes a file and frees its bytes, or prints why not. @return exit status */
int command_write(host_bytes *file, const char *path);

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

/** Checks the options beside --animate. @param command what a problem begins with. @return false with a problem */
bool command_check_frames(const host_settings *settings, const char *command, host_problem *problem);

/**
 * Draws and writes a picture, or the frames of --animate in one file, or prints the problem.
 * @return exit status
 */
int command_draw(const command_picture *shown, const host_settings *settings);

/** Room for an identifier: a --name of 64 characters, or as many of a file name's. */
#define CONVERT_NAME_SIZE 66

/** Makes a C identifier of a file's name without folder and ending. */
void convert_name(const char *path, char name[CONVERT_NAME_SIZE]);

#endif
