/* SPDX-License-Identifier: MIT */
/**
 * @file settings.c
 * The command line: one table has each option's name, help, kind of value, range and place in the settings.
 */
#include "settings.h"

#include "values.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/** Smallest factor: takes the largest coordinate that is read to 1. */
#define SCALE_MIN 1e-30

/** Degrees at which edges are sharp when nothing says which are: a cylinder of 9 sides is round, one of 8 is not. */
#define CREASE_DEFAULT 40.0

/* ---- Values of a form of their own ------------------------------------------------------------------------------ */

static bool parse_size(host_settings *settings, const char *text, host_problem *problem) {
    return value_pair(text, GLINT_SIZE_MAX, &settings->width, &settings->height) ||
           problem_set(problem, 0, "takes WxH, each from 1 to 1024");
}

static bool is_tile_side(uint16_t side) {
    return side == 8 || side == 16 || side == 32 || side == 64;
}

static bool parse_tile(host_settings *settings, const char *text, host_problem *problem) {
    return (value_pair(text, 64, &settings->tile_width, &settings->tile_height) && is_tile_side(settings->tile_width) &&
            is_tile_side(settings->tile_height)) ||
           problem_set(problem, 0, "takes WxH, each 8, 16, 32 or 64");
}

static bool parse_format(host_settings *settings, const char *text, host_problem *problem) {
    settings->format = framebuffer_find_format(text, NULL);
    return settings->format != NULL ||
           problem_set(problem, 0, "takes rgb565, rgb565_be, rgb444, rgb888, grey8, grey4 or mono");
}

static bool parse_panel(host_settings *settings, const char *text, host_problem *problem) {
    settings_panel *panel = &settings->panel;
    const size_t length = strcspn(text, ":");
    char size[16] = "";
    memcpy(size, text, length < sizeof size ? length : 0);
    if (text[length] == ':') {
        panel->format = framebuffer_find_format(text + length + 1, NULL);
    }
    return (value_pair(size, GLINT_SIZE_MAX, &panel->width, &panel->height) && panel->format != NULL) ||
           problem_set(problem, 0, "takes WxH[:FORMAT], as in 128x64:grey4; each side from 1 to 1024");
}

static bool parse_scale(host_settings *settings, const char *text, host_problem *problem) {
    double *scale = settings->scale;
    settings->scale_fit = strcmp(text, "fit") == 0;
    if (settings->scale_fit) {
        return true;
    }
    bool ok = number_list(text, strlen(text), ',', 3, scale);
    if (!ok && number_list(text, strlen(text), ',', 1, scale)) {
        scale[1] = scale[2] = scale[0];
        ok = true;
    }
    for (int i = 0; ok && i < 3; i++) {
        ok = fabs(scale[i]) >= SCALE_MIN && fabs(scale[i]) <= NUMBER_Q16_MAX;
    }
    return ok || problem_set(problem, 0, "takes fit, sx,sy,sz or one factor, each not 0 and from -32767 to 32767");
}

/** Takes --smooth: no edge is sharp. */
static bool set_smooth(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->load.normals.crease = 180;
    return true;
}

static bool parse_light(host_settings *settings, const char *text, host_problem *problem) {
    if (settings->light_count == GLINT_LIGHTS_MAX) {
        return problem_set(problem, 0, "can be given 8 times at most");
    }
    settings->light_count++;
    return value_light(text, &settings->lights[settings->light_count - 1], problem);
}

/** Takes --fog START:END[:COLOUR]; without a colour it is the background's. */
static bool parse_fog(host_settings *settings, const char *text, host_problem *problem) {
    glint_fog *fog = &settings->fog;
    double ends[2];
    const size_t first = strcspn(text, ":");
    const size_t second = text[first] == ':' ? strcspn(text + first + 1, ":") : 0;
    const char *colour = text + first + 1 + second;
    const bool ok = text[first] == ':' && number_list(text, first + 1 + second, ':', 2, ends) && ends[0] >= 0 &&
                    ends[1] <= NUMBER_Q16_MAX && ends[0] < ends[1] && number_q16(ends[0]) < number_q16(ends[1]);
    if (!ok) {
        return problem_set(problem, 0, "takes START:END[:r,g,b], depths from 0 to 32767, the second above the first");
    }
    fog->start = number_q16(ends[0]);
    fog->end = number_q16(ends[1]);
    fog->to_background = *colour == '\0';
    return *colour == '\0' || value_colour(colour + 1, strlen(colour + 1), &fog->colour, problem);
}

static bool parse_name(host_settings *settings, const char *text, host_problem *problem) {
    settings->name = text;
    const size_t plain = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");
    const bool ok = plain > 0 && text[plain] == '\0' && !(text[0] >= '0' && text[0] <= '9') && plain <= 64;
    return ok || problem_set(problem, 0, "takes a C identifier of at most 64 characters");
}

static bool parse_licence(host_settings *settings, const char *text, host_problem *problem) {
    settings->licence = text;
    const size_t plain = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 -.+()");
    return (plain > 0 && plain <= 100 && text[plain] == '\0') ||
           problem_set(problem, 0, "takes an SPDX licence expression");
}

/* ---- Options ---------------------------------------------------------------------------------------------------- */

typedef enum option_kind {
    KIND_SWITCH, /* takes no value */
    KIND_TEXT,   /* anything but nothing */
    KIND_REAL,   /* a double */
    KIND_Q16,    /* a number as Q16.16 */
    KIND_COUNT,  /* an integer from 0, of 32 bits or a size_t */
    KIND_WORD,   /* one of some names: its place among them in an enumeration or a bool... */
    KIND_CHOICE, /* ...or what stands for it, a pointer */
    KIND_VECTOR,
    KIND_DIRECTION,
    KIND_COLOUR,
    KIND_OWN /* has a parser of its own */
} option_kind;

typedef struct host_option {
    const char *name;
    const char *argument; /* null for a switch */
    const char *help;
    int commands; /* that take it */
    option_kind kind;
    size_t at, size; /* of the value in the settings */
    size_t given;    /* of a bool that says that there is one; 0 for none */
    double least, most;
    const char *takes;         /* what a number should be */
    const char *const *words;  /* the names, ended by a null pointer */
    const void *const *chosen; /* and what they stand for */
    bool (*parse)(host_settings *settings, const char *text, host_problem *problem);
} host_option;

#define AT(field) .at = offsetof(host_settings, field), .size = sizeof((host_settings *)0)->field
#define GIVEN(field) .given = offsetof(host_settings, field)
#define SWITCH(field) .kind = KIND_SWITCH, AT(field)
#define TEXT(field, what) .kind = KIND_TEXT, AT(field), .takes = what
#define REAL(field, low, high, what) .kind = KIND_REAL, AT(field), .least = (low), .most = (high), .takes = what
#define Q16(field, low, high, what) .kind = KIND_Q16, AT(field), .least = (low), .most = (high), .takes = what
#define COUNT(field, low, high, what) .kind = KIND_COUNT, AT(field), .least = (low), .most = (high), .takes = what
#define WORD(field, names) .kind = KIND_WORD, AT(field), .words = names
#define CHOICE(field, names, list) \
    .kind = KIND_CHOICE, .at = offsetof(host_settings, field), .words = (names), .chosen = (list)
#define OWN(function) .kind = KIND_OWN, .parse = function

static const char *const model_names[] = {"lambert", "phong", "blinn-phong", "unlit", NULL};
static const void *const models[] = {&glint_model_lambert, &glint_model_phong, &glint_model_blinn_phong,
                                     &glint_model_unlit};
static const char *const shading_names[] = {"flat", "vertex", "fragment", NULL};
static const void *const shadings[] = {&glint_per_facet, &glint_per_vertex, &glint_per_fragment};
static const char *const combinations[] = {"sum", "max", NULL};
static const char *const viewers[] = {"infinite", "local", NULL}; /* as glint_viewer has them */
static const char *const fog_names[] = {"linear", "squared", NULL};
static const void *const fogs[] = {&glint_fog_linear, &glint_fog_squared};
static const char *const blend_names[] = {"none", "alpha", "add", "dithered", NULL}; /* as glint_blend has them */
static const char *const sample_names[] = {"1", "2x2", NULL};
static const void *const samplings[] = {NULL, &glint_samples_2x2};
static const char *const up_axes[] = {"y", "z", NULL};

#define DRAW (COMMAND_RENDER | COMMAND_SCENE)
#define MESH (COMMAND_RENDER | COMMAND_INFO | COMMAND_CONVERT)
#define ALL (MESH | COMMAND_DEMO | COMMAND_SCENE)

static const host_option options[] = {
    {"-o", "FILE", "the file to write", DRAW | COMMAND_DEMO, TEXT(output, "the name of a file")},
    {"-o", "FILE", "a header; or NAME.c: a source, with NAME.h that declares what is in it", COMMAND_CONVERT,
     TEXT(output, "the name of a file")},
    {"--size", "WxH", "of the picture, up to 1024x1024; 320x240, or what a scene is composed for", DRAW,
     OWN(parse_size), GIVEN(size_given)},
    {"--format", "NAME", "rgb565, rgb565_be, rgb444, rgb888, grey8, grey4 or mono; rgb888, with --stats rgb565", DRAW,
     OWN(parse_format), GIVEN(format_given)},
    {"--dither", NULL, "ordered dithering of the format's levels", DRAW, SWITCH(dither)},
    {"--gamma", "G", "output is linear^(1/G), G from 0.1 to 10; 1", DRAW,
     REAL(gamma, 0.1, 10, "a number from 0.1 to 10")},
    {"--eye", "x,y,z", "where the camera stands; else the model is framed", COMMAND_RENDER, .kind = KIND_VECTOR,
     AT(eye), GIVEN(eye_given)},
    {"--at", "x,y,z", "what it looks at; 0,0,0 when --eye is given", COMMAND_RENDER, .kind = KIND_VECTOR, AT(at),
     GIVEN(at_given)},
    {"--up", "x,y,z", "what it sees upwards; 0,1,0", COMMAND_RENDER, .kind = KIND_DIRECTION, AT(up)},
    {"--fov", "DEG", "vertical field of view, 1 to 170; 45", COMMAND_RENDER,
     Q16(field_of_view, 1, 170, "degrees from 1 to 170")},
    {"--orthographic", "H", "parallel rays: the picture is H units high, whatever the field of view", COMMAND_RENDER,
     Q16(view_height, 1.0 / 256, NUMBER_Q16_MAX, "a height from 1/256 to 32767")},
    {"--near", "N", "distance of the near plane; 0.1, or less to frame a small model", COMMAND_RENDER,
     Q16(near_plane, 1.0 / 65536, NUMBER_Q16_MAX, "a distance from 1/65536 to 32767"), GIVEN(near_given)},
    {"--up-axis", "y|z", "which axis of the model points up: z turns it to y; y", MESH, WORD(z_up, up_axes)},
    {"--centre", NULL, "move the middle of the model's box to the origin", MESH, SWITCH(centre)},
    {"--scale", "sx,sy,sz", "factors per axis, one for all, or fit: a power of ten for Q16.16; after --centre", MESH,
     OWN(parse_scale)},
    {"--rotate-x", "DEG", "turn about the x axis, after --scale", MESH,
     Q16(rotate[0], -NUMBER_Q16_MAX, NUMBER_Q16_MAX, "degrees from -32767 to 32767")},
    {"--rotate-y", "DEG", "then about the y axis", MESH,
     Q16(rotate[1], -NUMBER_Q16_MAX, NUMBER_Q16_MAX, "degrees from -32767 to 32767")},
    {"--rotate-z", "DEG", "then about the z axis", MESH,
     Q16(rotate[2], -NUMBER_Q16_MAX, NUMBER_Q16_MAX, "degrees from -32767 to 32767")},
    {"--light", "LIGHT", "see below; up to 8 times; one from the upper left, a weak one from the right", COMMAND_RENDER,
     OWN(parse_light)},
    {"--camera-lights", NULL, "all --light are in camera space: x right, y up, z backwards; else in world space",
     COMMAND_RENDER, SWITCH(camera_lights)},
    {"--model", "NAME", "lambert, phong, blinn-phong or unlit; the file's, or blinn-phong", COMMAND_RENDER,
     CHOICE(reflection, model_names, models), GIVEN(reflection_given)},
    {"--shading", "NAME", "where light is evaluated: flat, vertex or fragment; fragment", COMMAND_RENDER,
     CHOICE(evaluation, shading_names, shadings)},
    {"--combine", "sum|max", "ambient with diffuse + specular: their sum or the larger; sum", COMMAND_RENDER,
     WORD(takes_larger, combinations)},
    {"--ungated", NULL, "specular light also where a surface faces away from the light", COMMAND_RENDER,
     SWITCH(ungated)},
    {"--ambient", "r,g,b", "final ambient colour, whatever the file says, or one grey level; the file's, or 0.1",
     COMMAND_RENDER, .kind = KIND_COLOUR, AT(ambient), GIVEN(ambient_given)},
    {"--diffuse", "r,g,b", "times each light, whatever the file says; the file's, or 0.6", COMMAND_RENDER,
     .kind = KIND_COLOUR, AT(diffuse), GIVEN(diffuse_given)},
    {"--specular", "r,g,b", "times each light, whatever the file says; the file's, or 0.4", COMMAND_RENDER,
     .kind = KIND_COLOUR, AT(specular), GIVEN(specular_given)},
    {"--shininess", "P", "specular exponent, any real number from 0; the file's, or 32", COMMAND_RENDER,
     Q16(shininess, 0, NUMBER_Q16_MAX, "an exponent from 0 to 32767"), GIVEN(shininess_given)},
    {"--opacity", "A", "0 to 1, whatever the file says; the file's, or 1", COMMAND_RENDER,
     Q16(opacity, 0, 1, "a number from 0 to 1"), GIVEN(opacity_given)},
    {"--blend", "NAME", "what opacity does: none, alpha, add or dithered; alpha where it is below 1", COMMAND_RENDER,
     WORD(blend, blend_names), GIVEN(blend_given)},
    {"--fog", "START:END[:r,g,b]", "depths from the eye where fog begins and where it is all there is; no fog",
     COMMAND_RENDER, OWN(parse_fog), GIVEN(fog_given)},
    {"--fog-type", "NAME", "how fog grows with depth: linear or squared; linear", COMMAND_RENDER,
     CHOICE(fog.type, fog_names, fogs)},
    {"--viewer", "infinite|local", "where highlights are seen from; infinite", COMMAND_RENDER, WORD(viewer, viewers)},
    {"--background", "r,g,b", "colour of the background; 0", COMMAND_RENDER, .kind = KIND_COLOUR, AT(background)},
    {"--samples", "1|2x2", "smooth edges: each pixel is the mean of so many; 1, or a scene's own", DRAW,
     CHOICE(samples, sample_names, samplings), GIVEN(samples_given)},
    {"--tile", "WxH", "size of the tiles, each 8, 16, 32 or 64", DRAW, OWN(parse_tile)},
    {"--arena", "BYTES", "working memory; what one pass takes", DRAW,
     COUNT(arena, 1, 1073741824, "bytes, from 1 to 1073741824")},
    {"--stats", NULL, "print what the frame took, a `name value` a line", DRAW, SWITCH(stats)},
    {"--animate", "N", "one turn about --up in N frames, 1 to 1000: an animated PNG", COMMAND_RENDER,
     COUNT(animate, 1, 1000, "a number of frames, from 1 to 1000")},
    {"--crease", "DEG",
     "make all normals anew, split at edges sharper than that; else those missing, by the file's s, or 40", MESH,
     REAL(load.normals.crease, 0, 180, "degrees from 0 to 180"), GIVEN(load.normals.anew)},
    {"--smooth", NULL, "make all normals anew, smooth over all edges", MESH, OWN(set_smooth), GIVEN(load.normals.anew)},
    {"--flat", NULL, "make all normals anew, the triangles' own", MESH, SWITCH(load.facets)},
    {"--weights", "NAME", "what triangles weigh in the normals that are made: angle, area or equal; angle", MESH,
     WORD(load.normals.weights, mesh_weight_names)},
    {"--weld", "D", "make one of positions within that distance, in the model's units; 0 for equal ones", MESH,
     REAL(load.weld, 0, OBJ_COORDINATE_MAX, "a distance from 0")},
    {"--simplify", "N", "at most N triangles, by meshoptimizer", MESH,
     COUNT(load.simplify, 1, OBJ_ITEMS_MAX, "triangles from 1 to 4000000")},
    {"--repair", NULL, "turn triangles so that connected parts are wound consistently and face outwards", MESH,
     SWITCH(load.repair)},
    {"--no-clusters", NULL, "make no clusters, keep the model's order: where flash is short or light is costly", MESH,
     SWITCH(load.plain)},
    {"--positions", "TYPE", "how positions are stored: int16 or int8; int16", MESH,
     WORD(load.types.positions, quantise_position_names)},
    {"--normals", "TYPE", "how normals are stored: int16, octahedral (2 bytes) or octahedral16 (4 bytes); int16", MESH,
     WORD(load.types.normals, quantise_normal_names)},
    {"--indices", "BITS", "how indices are stored: 16, 8 or auto, which is 8 up to 256 vertices; 16", MESH,
     WORD(load.types.indices, quantise_index_names)},
    {"--texture", "FILE", "a PNG or JPEG picture on all of the model, in place of those that the file names", MESH,
     TEXT(load.picture, "the name of a file")},
    {"--texture-size", "N", "longest side of textures, 1 to 1024; 1024", MESH,
     COUNT(load.texture.side, 1, TEXTURE_SIDE_MAX, "texels from 1 to 1024")},
    {"--texture-type", "TYPE", "auto, rgb565, grey8, palette256 or palette16; auto: the smallest within 35 dB", MESH,
     WORD(load.texture.type, texture_type_names)},
    {"--texture-dither", NULL, "spread errors of textures over the next texels", MESH, SWITCH(load.texture.dither)},
    {"--texture-levels", NULL, "smaller levels for triangles that are far away: a third more flash", MESH,
     SWITCH(load.texture.levels)},
    {"--bilinear", NULL, "interpolate between texels, in place of showing the nearest", MESH, SWITCH(bilinear)},
    {"--import-seconds", "S", "time for reading by glint-import: other formats, and JPEG; 60", MESH,
     COUNT(load.import.seconds, 1, 86400, "seconds from 1 to 86400")},
    {"--import-memory", "MB", "memory for it; 2048", MESH,
     COUNT(load.import.megabytes, 1, 1048576, "MB from 1 to 1048576")},
    {"--list", NULL, "print the scenes and their variants", COMMAND_SCENE, SWITCH(list)},
    {"--frame", "N", "which frame, counted from 0; 0", COMMAND_SCENE,
     COUNT(frame, 0, 1000000, "a frame, from 0 to 1000000"), GIVEN(frame_given)},
    {"--animate", "N", "N frames, 1 to 1000, until the scene repeats: an animated PNG", COMMAND_SCENE,
     COUNT(animate, 1, 1000, "a number of frames, from 1 to 1000")},
    {"--labels", NULL, "words beside the subject, where the variant has some", COMMAND_SCENE, SWITCH(labels)},
    {"--double-sided", NULL, "draw triangles from both sides", COMMAND_RENDER | COMMAND_CONVERT, SWITCH(double_sided)},
    {"--panel", "WxH[:FORMAT]", "what the mesh takes is told for that panel; 320x240:rgb565",
     COMMAND_INFO | COMMAND_CONVERT, OWN(parse_panel), GIVEN(panel_given)},
    {"--objects", NULL, "a mesh for each object and group of an OBJ file, with their names and middles",
     COMMAND_CONVERT, SWITCH(load.objects)},
    {"--fit", NULL, "move the middle to the origin, and write the camera that sees all on the panel", COMMAND_CONVERT,
     SWITCH(fit)},
    {"--name", "NAME", "C identifier that the arrays' names begin with; the written file's", COMMAND_CONVERT,
     OWN(parse_name)},
    {"--licence", "SPDX", "licence that each file states", COMMAND_CONVERT, OWN(parse_licence)},
    {"--models", "DIR", "folder of the models; examples/models", COMMAND_DEMO, TEXT(models, "a folder")},
    {"--help", NULL, "print this", ALL, SWITCH(help)},
};

#define OPTION_COUNT (sizeof options / sizeof options[0])

/* ---- Values ----------------------------------------------------------------------------------------------------- */

/** Says which words there are. @return false */
static bool expect_word(const char *const *words, host_problem *problem) {
    char list[80];
    size_t used = 0;
    for (size_t i = 0; words[i] != NULL; i++) {
        const char *gap = i == 0 ? "" : words[i + 1] != NULL ? ", " : " or ";
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", gap, words[i]);
    }
    return problem_set(problem, 0, "takes %s", list);
}

static bool parse_word(const host_option *option, const char *text, void *at, host_problem *problem) {
    unsigned i = 0;
    while (option->words[i] != NULL && strcmp(option->words[i], text) != 0) {
        i++;
    }
    if (option->words[i] == NULL) {
        return expect_word(option->words, problem);
    }
    if (option->kind == KIND_CHOICE) {
        memcpy(at, &option->chosen[i], sizeof option->chosen[i]);
    } else if (option->size == sizeof(bool)) {
        *(bool *)at = i == 1;
    } else {
        memcpy(at, &i, option->size); /* an enumeration, of the size of its unsigned integers */
    }
    return true;
}

static bool parse_number(const host_option *option, const char *text, void *at, host_problem *problem) {
    double value = 0;
    int64_t integer = 0;
    const bool is_count = option->kind == KIND_COUNT;
    bool ok = is_count ? number_integer(text, strlen(text), &integer) : number_real(text, strlen(text), &value);
    value = is_count ? (double)integer : value;
    ok = ok && value >= option->least && value <= option->most;
    if (!ok) {
        return problem_set(problem, 0, "takes %s", option->takes);
    }
    if (option->kind == KIND_REAL) {
        *(double *)at = value;
    } else if (option->kind == KIND_Q16) {
        *(glint_q16 *)at = number_q16(value);
    } else if (option->size == sizeof(uint32_t)) {
        *(uint32_t *)at = (uint32_t)integer;
    } else {
        *(size_t *)at = (size_t)integer;
    }
    return true;
}

/** Parses a value, empty for a switch, into its place. */
static bool store_value(host_settings *settings, const host_option *option, const char *text, host_problem *problem) {
    void *at = (uint8_t *)settings + option->at;
    switch (option->kind) {
    case KIND_SWITCH:
        *(bool *)at = true;
        return true;
    case KIND_TEXT:
        *(const char **)at = text;
        return text[0] != '\0' || problem_set(problem, 0, "takes %s", option->takes);
    case KIND_WORD:
    case KIND_CHOICE:
        return parse_word(option, text, at, problem);
    case KIND_VECTOR:
        return value_vector(text, strlen(text), at, problem);
    case KIND_DIRECTION:
        return value_direction(text, strlen(text), at, problem);
    case KIND_COLOUR:
        return value_colour(text, strlen(text), at, problem);
    case KIND_OWN:
        return option->parse(settings, text, problem);
    default:
        return parse_number(option, text, at, problem);
    }
}

/** Parses a value and puts the option's name and the value before what is wrong with it. */
static bool parse_value(host_settings *settings, const host_option *option, const char *value, host_problem *problem) {
    if (option->given > 0) {
        *(bool *)((uint8_t *)settings + option->given) = true;
    }
    if (store_value(settings, option, value, problem)) {
        return true;
    }
    char quote[PROBLEM_QUOTE_SIZE];
    const host_problem wrong = *problem;
    return problem_set(problem, 0, "%s %s: %s", option->name, problem_quote(quote, value, strlen(value)), wrong.text);
}

/* ---- Arguments -------------------------------------------------------------------------------------------------- */

/** The option that an argument names, up to its end or to an equals sign. */
static const host_option *find_option(const char *argument, int command) {
    argument = strcmp(argument, "-h") == 0 ? "--help" : argument;
    const size_t length = strcspn(argument, "=");
    for (size_t i = 0; i < OPTION_COUNT; i++) {
        if ((options[i].commands & command) != 0 && strlen(options[i].name) == length &&
            memcmp(options[i].name, argument, length) == 0) {
            return &options[i];
        }
    }
    return NULL;
}

/** Says that there is no such option, and which was meant. @return 0 */
static int refuse_option(const char *argument, int command, host_problem *problem) {
    char quote[PROBLEM_QUOTE_SIZE];
    const size_t length = strcspn(argument, "=");
    const host_option *nearest = NULL;
    size_t least = length;
    for (size_t i = 0; i < OPTION_COUNT; i++) {
        const size_t distance = nearest_distance(argument, length, options[i].name);
        if ((options[i].commands & command) != 0 && distance < least) {
            nearest = &options[i];
            least = distance;
        }
    }
    problem_quote(quote, argument, strlen(argument));
    if (nearest != NULL && nearest_is_meant(length - strspn(argument, "-"), least)) {
        return problem_set(problem, 0, "unknown option %s: did you mean %s?", quote, nearest->name);
    }
    return problem_set(problem, 0, "unknown option %s", quote);
}

/** Takes the option at arguments[0] and its value. @return how many arguments it took, or 0 with a problem. */
static int take_option(host_settings *settings, int command, int count, char **arguments, host_problem *problem) {
    const host_option *option = find_option(arguments[0], command);
    const char *equals = strchr(arguments[0], '=');
    if (option == NULL) {
        return refuse_option(arguments[0], command, problem);
    }
    if (option->argument == NULL && equals != NULL) {
        return problem_set(problem, 0, "%s takes no value", option->name);
    }
    if (option->argument == NULL) {
        return parse_value(settings, option, "", problem) ? 1 : 0;
    }
    if (equals == NULL && count < 2) {
        return problem_set(problem, 0, "%s takes a value: %s", option->name, option->argument);
    }
    const char *value = equals != NULL ? equals + 1 : arguments[1];
    return parse_value(settings, option, value, problem) ? 2 - (equals != NULL) : 0;
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

glint_colour settings_grey(double level) {
    const glint_q16 value = number_q16(level);
    const glint_colour colour = {value, value, value};
    return colour;
}

void settings_default(host_settings *settings) {
    memset(settings, 0, sizeof *settings);
    settings->format = framebuffer_find_format("rgb888", NULL);
    settings->width = 320;
    settings->height = 240;
    settings->panel = (settings_panel){320, 240, framebuffer_find_format("rgb565", NULL)};
    settings->up.y = GLINT_ONE;
    settings->field_of_view = GLINT_Q16(45);
    settings->near_plane = GLINT_Q16(0.1);
    settings->viewer = GLINT_VIEWER_INFINITE;
    settings->scale[0] = settings->scale[1] = settings->scale[2] = 1.0;
    settings->ambient = settings_grey(0.1);
    settings->diffuse = settings_grey(0.6);
    settings->specular = settings_grey(0.4);
    settings->shininess = GLINT_Q16(32);
    settings->reflection = &glint_model_blinn_phong;
    settings->evaluation = &glint_per_fragment;
    settings->opacity = GLINT_ONE;
    settings->fog.type = &glint_fog_linear;
    settings->gamma = 1.0;
    settings->load.normals = (mesh_normal_rule){CREASE_DEFAULT, false, MESH_BY_ANGLE};
    settings->load.weld = -1;
    settings->load.import = (child_limits){60, 2048, OBJ_FILE_MAX};
    settings->models = "examples/models";
}

bool settings_parse(host_settings *settings, int command, int count, char **arguments, host_problem *problem) {
    int taken;
    settings->arguments = arguments;
    settings->argument_count = count;
    for (int i = 0; i < count; i += taken) {
        if (arguments[i][0] == '-' && arguments[i][1] != '\0') {
            taken = take_option(settings, command, count - i, arguments + i, problem);
            if (taken == 0) {
                return false;
            }
            continue;
        }
        char quote[PROBLEM_QUOTE_SIZE];
        if (settings->model != NULL || (command & (MESH | COMMAND_SCENE)) == 0) {
            return problem_set(problem, 0, "unexpected argument '%s'",
                               problem_quote(quote, arguments[i], strlen(arguments[i])));
        }
        settings->model = arguments[i];
        taken = 1;
    }
    if (settings->stats && !settings->format_given) {
        settings->format = settings->panel.format; /* what info and convert speak of */
    }
    return true;
}

static void print_lights(void) {
    printf(
        "  LIGHT is one of these; colours r,g,b from 0 to 16, attenuation 1 / (1 + k1 d + k2 d^2), degrees:\n"
        "    dir:x,y,z[:r,g,b]                                   from that direction, infinitely far\n"
        "    point:x,y,z[:r,g,b[:k1[:k2]]]                       from that point\n"
        "    spot:x,y,z:ax,ay,az:inner,outer[:r,g,b[:k1[:k2]]]   along an axis, full up to inner, none from outer\n");
}

void settings_help(int command) {
    for (size_t i = 0; i < OPTION_COUNT; i++) {
        if ((options[i].commands & command) != 0) {
            char left[64];
            snprintf(left, sizeof left, "%s %s", options[i].name,
                     options[i].argument != NULL ? options[i].argument : "");
            printf("  %-26s %s\n", left, options[i].help);
        }
    }
    if ((command & COMMAND_RENDER) != 0) {
        print_lights();
    }
}
