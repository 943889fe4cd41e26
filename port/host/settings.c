/* SPDX-License-Identifier: MIT */
#include "settings.h"

#include "mesh.h"
#include "nearest.h"
#include "number.h"
#include "parsers.h"
#include "values.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/** Largest --arena: far more than any scene needs, and sure to be a size_t. */
#define ARENA_MAX 1073741824

/* ---- Options ---------------------------------------------------------------------------------------------------- */

static bool parse_output(host_settings *settings, const char *text, host_problem *problem) {
    settings->output = text;
    return text[0] != '\0' || value_expected(problem, "takes the name of a file");
}

static bool parse_size(host_settings *settings, const char *text, host_problem *problem) {
    int64_t width;
    int64_t height;
    if (!value_pair(text, &width, &height) || width < 1 || height < 1 || width > GLINT_SIZE_MAX ||
        height > GLINT_SIZE_MAX) {
        return value_expected(problem, "takes WxH, each from 1 to 1024");
    }
    settings->size_given = true;
    settings->width = (uint16_t)width;
    settings->height = (uint16_t)height;
    return true;
}

static bool is_tile_size(int64_t size) {
    return size == 8 || size == 16 || size == 32 || size == 64;
}

static bool parse_tile(host_settings *settings, const char *text, host_problem *problem) {
    int64_t width;
    int64_t height;
    if (!value_pair(text, &width, &height) || !is_tile_size(width) || !is_tile_size(height)) {
        return value_expected(problem, "takes WxH, each 8, 16, 32 or 64");
    }
    settings->tile_width = (uint16_t)width;
    settings->tile_height = (uint16_t)height;
    return true;
}

static bool parse_format(host_settings *settings, const char *text, host_problem *problem) {
    const framebuffer_format *format = framebuffer_find_format(text, NULL);
    if (format == NULL) {
        return value_expected(problem, "takes rgb565, rgb565_be, rgb444, rgb888, grey8, grey4 or mono");
    }
    settings->format = format;
    return true;
}

static bool parse_eye(host_settings *settings, const char *text, host_problem *problem) {
    settings->eye_given = true;
    return value_vector(text, strlen(text), &settings->eye, problem);
}

static bool parse_at(host_settings *settings, const char *text, host_problem *problem) {
    settings->at_given = true;
    return value_vector(text, strlen(text), &settings->at, problem);
}

static bool parse_up(host_settings *settings, const char *text, host_problem *problem) {
    return value_direction(text, strlen(text), &settings->up, problem);
}

static bool parse_fov(host_settings *settings, const char *text, host_problem *problem) {
    double value;
    if (!value_real(text, 1, 170, &value)) {
        return value_expected(problem, "takes degrees from 1 to 170");
    }
    settings->field_of_view = number_q16(value);
    return true;
}

static bool parse_orthographic(host_settings *settings, const char *text, host_problem *problem) {
    double value;
    if (!value_real(text, 1.0 / 256.0, NUMBER_Q16_MAX, &value)) {
        return value_expected(problem, "takes a height from 1/256 to 32767");
    }
    settings->view_height = number_q16(value);
    return true;
}

static bool parse_near(host_settings *settings, const char *text, host_problem *problem) {
    double value;
    if (!value_real(text, 1.0 / 65536.0, NUMBER_Q16_MAX, &value)) {
        return value_expected(problem, "takes a distance from 1/65536 to 32767");
    }
    settings->near_given = true;
    settings->near_plane = number_q16(value);
    return true;
}

static bool parse_ambient(host_settings *settings, const char *text, host_problem *problem) {
    settings->ambient_given = true;
    return value_colour(text, strlen(text), &settings->ambient, problem);
}

static bool parse_diffuse(host_settings *settings, const char *text, host_problem *problem) {
    settings->diffuse_given = true;
    return value_colour(text, strlen(text), &settings->diffuse, problem);
}

static bool parse_specular(host_settings *settings, const char *text, host_problem *problem) {
    settings->specular_given = true;
    return value_colour(text, strlen(text), &settings->specular, problem);
}

static bool parse_background(host_settings *settings, const char *text, host_problem *problem) {
    return value_colour(text, strlen(text), &settings->background, problem);
}

static bool parse_shininess(host_settings *settings, const char *text, host_problem *problem) {
    double value;
    if (!value_real(text, 0, NUMBER_Q16_MAX, &value)) {
        return value_expected(problem, "takes an exponent from 0 to 32767");
    }
    settings->shininess_given = true;
    settings->shininess = number_q16(value);
    return true;
}

static bool parse_viewer(host_settings *settings, const char *text, host_problem *problem) {
    const bool local = strcmp(text, "local") == 0;
    if (!local && strcmp(text, "infinite") != 0) {
        return value_expected(problem, "takes infinite or local");
    }
    settings->viewer = local ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
    return true;
}

static bool parse_arena(host_settings *settings, const char *text, host_problem *problem) {
    int64_t value;
    if (!number_integer(text, strlen(text), &value) || value < 1 || value > ARENA_MAX) {
        return value_expected(problem, "takes bytes, from 1 to 1073741824");
    }
    settings->arena = (size_t)value;
    return true;
}

static bool parse_stats(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->stats = true;
    return true;
}

static bool parse_bus(host_settings *settings, const char *text, host_problem *problem) {
    return value_real(text, 0.001, 1000, &settings->bus) || value_expected(problem, "takes MHz from 0.001 to 1000");
}

static bool parse_core(host_settings *settings, const char *text, host_problem *problem) {
    return value_real(text, 0.001, 10000, &settings->core) || value_expected(problem, "takes MHz from 0.001 to 10000");
}

static bool parse_instructions(host_settings *settings, const char *text, host_problem *problem) {
    return value_real(text, 0.001, 100000, &settings->instructions) ||
           value_expected(problem, "takes millions from 0.001 to 100000");
}

static bool parse_double_sided(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->double_sided = true;
    return true;
}

static bool parse_models(host_settings *settings, const char *text, host_problem *problem) {
    settings->models = text;
    return text[0] != '\0' || value_expected(problem, "takes a folder");
}

static bool parse_help(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->help = true;
    return true;
}

static bool parse_heat(host_settings *settings, const char *text, host_problem *problem) {
    settings->heat = text;
    return text[0] != '\0' || value_expected(problem, "takes the name of a file");
}

static bool parse_preview(host_settings *settings, const char *text, host_problem *problem) {
    int64_t value;
    if (!number_integer(text, strlen(text), &value) || value < 1 || value > GLINT_SIZE_MAX) {
        return value_expected(problem, "takes characters, from 1 to 1024");
    }
    settings->preview = (uint32_t)value;
    return true;
}

static bool parse_compare(host_settings *settings, const char *text, host_problem *problem) {
    settings->compare = text;
    return text[0] != '\0' || value_expected(problem, "takes the name of a file");
}

/** An option; one without `argument` is a switch. */
typedef struct host_option {
    const char *name;
    const char *argument;
    const char *help;
    int commands; /* that take it */
    bool (*parse)(host_settings *settings, const char *text, host_problem *problem);
} host_option;

#define COMMANDS_THAT_DRAW (COMMAND_RENDER | COMMAND_SCENE)
#define COMMANDS_WITH_MESH (COMMAND_RENDER | COMMAND_INFO | COMMAND_CONVERT)

static const host_option options[] = {
    {"-o", "FILE", "the file to write", COMMANDS_THAT_DRAW | COMMAND_DEMO, parse_output},
    {"-o", "FILE", "a header; or NAME.c: a source, with NAME.h that declares what is in it", COMMAND_CONVERT,
     parse_output},
    {"--size", "WxH", "of the picture, up to 1024x1024; 320x240, or what a scene is composed for", COMMANDS_THAT_DRAW,
     parse_size},
    {"--format", "NAME", "rgb565, rgb565_be, rgb444, rgb888, grey8, grey4 or mono; rgb888", COMMANDS_THAT_DRAW,
     parse_format},
    {"--dither", NULL, "ordered dithering of the format's levels", COMMANDS_THAT_DRAW, parse_dither},
    {"--gamma", "G", "output is linear^(1/G), G from 0.1 to 10; 1", COMMANDS_THAT_DRAW, parse_gamma},
    {"--eye", "x,y,z", "where the camera stands; else the model is framed", COMMAND_RENDER, parse_eye},
    {"--at", "x,y,z", "what it looks at; 0,0,0 when --eye is given", COMMAND_RENDER, parse_at},
    {"--up", "x,y,z", "what it sees upwards; 0,1,0", COMMAND_RENDER, parse_up},
    {"--fov", "DEG", "vertical field of view, 1 to 170; 45", COMMAND_RENDER, parse_fov},
    {"--orthographic", "H", "parallel rays: the picture is H units high, whatever the field of view", COMMAND_RENDER,
     parse_orthographic},
    {"--near", "N", "distance of the near plane; 0.1, or less to frame a small model", COMMAND_RENDER, parse_near},
    {"--up-axis", "y|z", "which axis of the model points up: z turns it to y; y", COMMANDS_WITH_MESH, parse_up_axis},
    {"--centre", NULL, "move the middle of the model's box to the origin", COMMANDS_WITH_MESH, parse_centre},
    {"--scale", "sx,sy,sz", "factors per axis, one for all, or fit: a power of ten for Q16.16; after --centre",
     COMMANDS_WITH_MESH, parse_scale},
    {"--rotate-x", "DEG", "turn about the x axis, after --scale", COMMANDS_WITH_MESH, parse_rotate_x},
    {"--rotate-y", "DEG", "then about the y axis", COMMANDS_WITH_MESH, parse_rotate_y},
    {"--rotate-z", "DEG", "then about the z axis", COMMANDS_WITH_MESH, parse_rotate_z},
    {"--light", "LIGHT", "see below; up to 8 times; one from the upper left", COMMAND_RENDER, parse_light},
    {"--camera-lights", NULL, "all --light are in camera space: x right, y up, z backwards; else in world space",
     COMMAND_RENDER, parse_camera_lights},
    {"--model", "NAME", "lambert, phong, blinn-phong or unlit; the file's, or blinn-phong", COMMAND_RENDER,
     parse_model},
    {"--shading", "NAME", "where light is evaluated: flat, vertex or fragment; fragment", COMMAND_RENDER,
     parse_shading},
    {"--combine", "sum|max", "ambient with diffuse + specular: their sum or the larger; sum", COMMAND_RENDER,
     parse_combine},
    {"--ungated", NULL, "specular light also where a surface faces away from the light", COMMAND_RENDER, parse_ungated},
    {"--ambient", "r,g,b", "final ambient colour, whatever the file says, or one grey level; the file's, or 0.1",
     COMMAND_RENDER, parse_ambient},
    {"--diffuse", "r,g,b", "times each light, whatever the file says; the file's, or 0.6", COMMAND_RENDER,
     parse_diffuse},
    {"--specular", "r,g,b", "times each light, whatever the file says; the file's, or 0.4", COMMAND_RENDER,
     parse_specular},
    {"--shininess", "P", "specular exponent, any real number from 0; the file's, or 32", COMMAND_RENDER,
     parse_shininess},
    {"--viewer", "infinite|local", "where highlights are seen from; infinite", COMMAND_RENDER, parse_viewer},
    {"--background", "r,g,b", "colour of the background; 0", COMMAND_RENDER, parse_background},
    {"--tile", "WxH", "size of the tiles, each 8, 16, 32 or 64", COMMANDS_THAT_DRAW, parse_tile},
    {"--arena", "BYTES", "working memory; what one pass takes", COMMANDS_THAT_DRAW, parse_arena},
    {"--stats", NULL, "print what the frame took, and what a model says of boards, a `name value` a line",
     COMMANDS_THAT_DRAW, parse_stats},
    {"--bus", "MHZ", "--stats: clock of a panel's bus, for the time that sending takes", COMMANDS_THAT_DRAW, parse_bus},
    {"--core", "MHZ", "--stats: clock of a core, for the time that drawing takes, an instruction a clock",
     COMMANDS_THAT_DRAW, parse_core},
    {"--instructions", "M", "--stats: millions that the frame takes on that core, see docs/bench.csv",
     COMMANDS_THAT_DRAW, parse_instructions},
    {"--heat", "FILE", "write how far each pixel is from double precision, and print the worst, in steps of the format",
     COMMANDS_THAT_DRAW, parse_heat},
    {"--preview", "N", "show the picture in the terminal, up to N characters wide; then -o is not needed",
     COMMANDS_THAT_DRAW, parse_preview},
    {"--compare", "FILE", "print how the picture differs from a PNG, status 1 where it does; then -o is not needed",
     COMMANDS_THAT_DRAW, parse_compare},
    {"--animate", "N", "one turn about --up in N frames, 1 to 1000: an APNG, or a PNG each for -o NAME%03d.png",
     COMMAND_RENDER, parse_animate},
    {"--crease", "DEG", "make all normals anew, split at edges sharper than that", COMMANDS_WITH_MESH, parse_crease},
    {"--weights", "NAME", "what triangles weigh in the normals that are made: equal, area or angle; area",
     COMMANDS_WITH_MESH, parse_weights},
    {"--weld", "D", "make one of positions within that distance, in the model's units; 0 for equal ones",
     COMMANDS_WITH_MESH, parse_weld},
    {"--simplify", "N", "at most N triangles, by meshoptimizer", COMMANDS_WITH_MESH, parse_simplify},
    {"--facets", NULL, "make all normals anew, the triangles' own", COMMANDS_WITH_MESH, parse_facets},
    {"--repair", NULL, "turn triangles so that connected parts are wound consistently and face outwards",
     COMMANDS_WITH_MESH, parse_repair},
    {"--no-clusters", NULL, "make no clusters, keep the model's order: where flash is short or light is costly",
     COMMANDS_WITH_MESH, parse_no_clusters},
    {"--positions", "TYPE", "how positions are stored: int16 or int8; int16", COMMANDS_WITH_MESH, parse_positions},
    {"--normals", "TYPE", "how normals are stored: int16, octahedral (2 bytes) or octahedral16 (4 bytes); int16",
     COMMANDS_WITH_MESH, parse_normals},
    {"--indices", "BITS", "how indices are stored: 16, 8 or auto, which is 8 up to 256 vertices; 16",
     COMMANDS_WITH_MESH, parse_indices},
    {"--import-seconds", "S", "time for reading another format than OBJ; 60", COMMANDS_WITH_MESH, parse_import_seconds},
    {"--import-memory", "MB", "memory for it; 2048", COMMANDS_WITH_MESH, parse_import_memory},
    {"--list", NULL, "print the scenes and their variants", COMMAND_SCENE, parse_list},
    {"--frame", "N", "which frame, counted from 0; 0", COMMAND_SCENE, parse_frame},
    {"--animate", "N", "N frames, 1 to 1000, until the scene repeats: an APNG, or a PNG each for -o NAME%03d.png",
     COMMAND_SCENE, parse_animate},
    {"--labels", NULL, "words beside the subject, where the variant has some", COMMAND_SCENE, parse_labels},
    {"--double-sided", NULL, "draw triangles from both sides", COMMAND_RENDER | COMMAND_CONVERT, parse_double_sided},
    {"--panel", "WxH[:FORMAT]", "what the mesh takes is told for that panel; 320x240:rgb565",
     COMMAND_INFO | COMMAND_CONVERT, parse_panel},
    {"--name", "NAME", "C identifier that the arrays' names begin with", COMMAND_CONVERT, parse_name},
    {"--licence", "SPDX", "licence that each file states", COMMAND_CONVERT, parse_licence},
    {"--models", "DIR", "folder of the models; examples/models", COMMAND_DEMO, parse_models},
    {"--help", NULL, "print this", COMMANDS_WITH_MESH | COMMAND_DEMO | COMMAND_SCENE, parse_help},
};

#define OPTION_COUNT (sizeof options / sizeof options[0])

/** The option that an argument names, up to its end or to an equals sign. */
static const host_option *find_option(const char *argument, int command) {
    const size_t length = strcspn(argument, "=");
    for (size_t i = 0; i < OPTION_COUNT; i++) {
        if ((options[i].commands & command) != 0 && strlen(options[i].name) == length &&
            memcmp(options[i].name, argument, length) == 0) {
            return &options[i];
        }
    }
    return NULL;
}

/** Parses a value and puts the option's name and the value before what is wrong with it. */
static bool parse_value(host_settings *settings, const host_option *option, const char *value, host_problem *problem) {
    if (option->parse(settings, value, problem)) {
        return true;
    }
    char quote[PROBLEM_QUOTE_SIZE];
    const host_problem wrong = *problem;
    return problem_set(problem, 0, "%s %s: %s", option->name, problem_quote(quote, value, strlen(value)), wrong.text);
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
        return option->parse(settings, "", problem) ? 1 : 0;
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
    settings->gamma = 1.0;
    settings->load.crease = MESH_NO_CREASE;
    settings->load.weld = -1;
    settings->load.import = (child_limits){60, 2048, OBJ_FILE_MAX};
    settings->models = "examples/models";
}

bool settings_parse(host_settings *settings, int command, int count, char **arguments, host_problem *problem) {
    int taken;
    for (int i = 0; i < count; i += taken) {
        if (arguments[i][0] == '-' && arguments[i][1] != '\0') {
            taken = take_option(settings, command, count - i, arguments + i, problem);
            if (taken == 0) {
                return false;
            }
            continue;
        }
        char quote[PROBLEM_QUOTE_SIZE];
        if (settings->model != NULL || (command & (COMMANDS_WITH_MESH | COMMAND_SCENE)) == 0) {
            return problem_set(problem, 0, "unexpected argument '%s'",
                               problem_quote(quote, arguments[i], strlen(arguments[i])));
        }
        settings->model = arguments[i];
        taken = 1;
    }
    if ((settings->core > 0) != (settings->instructions > 0)) {
        return problem_set(problem, 0, "--core and --instructions go together");
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
