/* SPDX-License-Identifier: MIT */
/**
 * @file settings.h
 * The command line, taken apart and checked.
 */
#ifndef GLINT_HOST_SETTINGS_H
#define GLINT_HOST_SETTINGS_H

#include "basics.h"
#include "framebuffer.h"
#include "glint_extras.h"
#include "model.h"

/** Commands, as bits: which of them take an option. */
enum {
    COMMAND_RENDER = 1,
    COMMAND_INFO = 2,
    COMMAND_CONVERT = 4,
    COMMAND_DEMO = 8,
    COMMAND_SCENE = 16,
};

/** A panel: its size, and the format that it takes. */
typedef struct settings_panel {
    uint16_t width, height;
    const framebuffer_format *format;
} settings_panel;

/** All that options can say; settings_default gives what holds without them. Strings are the command line's own. */
typedef struct host_settings {
    char *const *arguments; /**< As they were given, and... */
    int argument_count;     /**< ...how many of them. */

    const char *model;  /**< File, shape or scene, or null. */
    const char *output; /**< File to write, or null. */

    const framebuffer_format *format;
    double gamma; /**< Output is linear^(1 / gamma). */
    uint16_t width, height;
    uint16_t tile_width, tile_height; /**< 0 for the library's default. */
    size_t arena;                     /**< Bytes; 0 for what the scene is best drawn with. */

    settings_panel panel; /**< That a mesh is meant for. */
    bool panel_given;

    bool help, list, stats;    /**< What to print. */
    bool dither, double_sided; /**< How to draw. */
    bool size_given, format_given, eye_given, at_given, near_given, frame_given;
    bool ambient_given, diffuse_given, specular_given, shininess_given, reflection_given;
    bool fog_given, samples_given, blend_given, opacity_given;

    glint_vector eye, at, up;
    glint_q16 field_of_view, near_plane;
    glint_q16 view_height; /**< Units of an orthographic picture's height; 0 for perspective. */
    glint_viewer viewer;
    glint_q16 rotate[3]; /**< Degrees about x, y and z, in this order. */
    double scale[3];     /**< None 0. */
    bool scale_fit;      /**< In place of it the power of ten that suits Q16.16. */
    bool centre, z_up;
    bool fit; /**< Centre, and write the camera that sees all. */

    const glint_shading_model *reflection;
    const glint_evaluation *evaluation;
    glint_colour ambient, diffuse, specular, background;
    glint_q16 shininess, opacity;
    glint_blend blend;
    glint_fog fog;                        /**< Where it is given. */
    const glint_sampling *samples;        /**< Null for one a pixel. */
    bool takes_larger, ungated, bilinear; /**< Flags of the material. */
    glint_light lights[GLINT_LIGHTS_MAX];
    uint32_t light_count; /**< 0 for the default light. */
    bool camera_lights;   /**< Whether the lights are in camera space, else in world space. */

    uint32_t frame;   /**< Of a scene. */
    uint32_t animate; /**< Frames of an animation; 0 for a still picture. */
    bool labels;      /**< Whether to draw a scene's labels over it. */

    load_options load;
    const char *name;    /**< Of converted arrays, or null. */
    const char *licence; /**< SPDX expression for a converted mesh, or null. */
    const char *models;  /**< Folder of the demo's models. */
} host_settings;

/** Grey colour. */
glint_colour settings_grey(double level);

/**
 * The material that a file's comes to, with what options say in place of what the file says; docs/assets.md has the
 * formulas.
 * @param file the file's, or null for the default one
 */
glint_material settings_material(const host_settings *settings, const mtl_material *file);

/** What holds without options. */
void settings_default(host_settings *settings);

/**
 * Takes the arguments after the command: options as `--name value` or `--name=value`, and at most one model.
 * @param command one of the bits above
 * @return false with a problem (its line is 0)
 */
bool settings_parse(host_settings *settings, int command, int count, char **arguments, host_problem *problem);

/** Prints the options that a command takes, one a line. */
void settings_help(int command);

#endif
