/* SPDX-License-Identifier: MIT */
/**
 * @file main.c
 * The host program: see `glint help`.
 */
#include "command.h"

#include "model.h"
#include "values.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

typedef struct host_command {
    const char *name;
    const char *usage;
    const char *summary;
    int bit;
    bool takes_model, takes_output;
    int (*run)(const host_settings *settings);
} host_command;

static const host_command commands[] = {
    {"render", "MODEL [options] -o OUT.png", "draw a model", COMMAND_RENDER, true, true, command_render},
    {"info", "MODEL [options]", "counts, bounds, and the arena it needs on common panels", COMMAND_INFO, true, false,
     command_info},
    {"convert", "MODEL [options] -o MESH.h|MESH.c", "write a model as const arrays, and print what it takes of a board",
     COMMAND_CONVERT, true, true, command_convert},
#ifndef HOST_WITHOUT_SCENES
    {"scene", "NAME[:VARIANT] [options] -o OUT.png", "draw a frame of an example scene, or an animation", COMMAND_SCENE,
     false, false, command_scene},
#endif
    {"demo", "[options] -o OUT.png", "draw several models on one sheet", COMMAND_DEMO, false, true, command_demo},
};

#define COMMAND_COUNT (sizeof commands / sizeof commands[0])

static void print_command(const host_command *command) {
    printf("\nglint %s %s\n  %s\n", command->name, command->usage, command->summary);
    settings_help(command->bit);
}

static int print_help(void) {
    printf("glint draws lit 3D models and scenes as the library of the same name does, pixel for pixel.\n");
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        print_command(&commands[i]);
    }
    printf("\nglint help [COMMAND]\nglint --version\n\n"
           "MODEL is a Wavefront OBJ file; or one whose name ends by its format: .gltf, .glb, .stl, .ply, .off or, by\n"
           "way of glint-import, what assimp reads, such as .fbx, .dae or .3ds (the environment's GLINT_IMPORT names\n"
           "another program for that); or one of\n");
    for (const host_shape *shape = host_shapes; shape->name != NULL; shape++) {
        char left[40];
        snprintf(left, sizeof left, "%s%s", shape->name, shape->syntax);
        printf("  %-26s %s\n", left, shape->help);
    }
    printf(
        "\nWhat holds without an option stands last in its line. The exit status is 0 when all was done, else 2: bad\n"
        "input ends with one line on stderr and no output file. What a model says and glint does not follow, such as\n"
        "textures, is told by warnings on stderr, with status 0, as is why a picture shows nothing or is black. The "
        "file\n"
        "to write replaces an older one, or the one that a link of its name leads to, whole or not at all; it may not "
        "be\n"
        "one that is read.\n");
    return 0;
}

static int print_version(void) {
    printf("glint %d.%d.%d\n", GLINT_VERSION_MAJOR, GLINT_VERSION_MINOR, GLINT_VERSION_PATCH);
    return 0;
}

/** Refuses names of pictures in other formats than PNG: they would lie. */
static bool check_picture(const char *output, host_problem *problem) {
    static const char *const others[] = {"jpg", "jpeg", "gif",  "bmp", "ppm", "pgm", "pnm", "tga",
                                         "tif", "tiff", "webp", "svg", "pdf", "mp4", "h",   "c"};
    const char *dot = strrchr(path_base_name(output), '.');
    for (size_t i = 0; dot != NULL && i < sizeof others / sizeof others[0]; i++) {
        if (strcasecmp(dot + 1, others[i]) == 0) {
            return problem_set(problem, 0, "-o: pictures are PNG files: name it .png, not %s", dot);
        }
    }
    return true;
}

static int run_command(const host_command *command, int count, char **arguments) {
    host_settings settings;
    host_problem problem;
    settings_default(&settings);
    if (!settings_parse(&settings, command->bit, count, arguments, &problem)) {
        return command_fail(NULL, &problem);
    }
    if (settings.help) {
        print_command(command);
        return 0;
    }
    if (command->takes_model && settings.model == NULL) {
        problem_set(&problem, 0, "%s: a model is missing: an OBJ file, or a shape such as torus:24x12", command->name);
        return command_fail(NULL, &problem);
    }
    if (command->takes_output && settings.output == NULL) {
        problem_set(&problem, 0, "%s: the file to write is missing: -o FILE", command->name);
        return command_fail(NULL, &problem);
    }
    if (settings.output != NULL && command->bit != COMMAND_CONVERT && !check_picture(settings.output, &problem)) {
        return command_fail(NULL, &problem);
    }
    return command->run(&settings);
}

/** What was printed may have gone to a full disk: that is a failure too. */
static int finish(int status) {
    if (status != COMMAND_FAILED && (fflush(stdout) != 0 || ferror(stdout))) {
        fputs("glint: standard output cannot be written\n", stderr);
        return COMMAND_FAILED;
    }
    return status;
}

static const host_command *find_command(const char *name) {
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        if (strcmp(name, commands[i].name) == 0) {
            return &commands[i];
        }
    }
    return NULL;
}

/** Says that there is no such command, and which was meant. */
static int refuse_command(const char *name) {
    char quote[PROBLEM_QUOTE_SIZE];
    host_problem problem;
    problem_quote(quote, name, strlen(name));
    problem_set(&problem, 0, "unknown command '%s': see glint help", quote);
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        if (nearest_is_meant(strlen(name), nearest_distance(name, strlen(name), commands[i].name))) {
            problem_set(&problem, 0, "unknown command '%s': did you mean %s?", quote, commands[i].name);
        }
    }
    return command_fail(NULL, &problem);
}

static int run(int count, char **arguments) {
    host_problem problem;
    if (count < 2) {
        problem_set(&problem, 0, "a command is missing: see glint help");
        return command_fail(NULL, &problem);
    }
    if (strcmp(arguments[1], "help") == 0 && count > 2) {
        const host_command *command = find_command(arguments[2]);
        if (command == NULL) {
            return refuse_command(arguments[2]);
        }
        print_command(command);
        return 0;
    }
    if (strcmp(arguments[1], "help") == 0 || strcmp(arguments[1], "--help") == 0 || strcmp(arguments[1], "-h") == 0) {
        return print_help();
    }
    if (strcmp(arguments[1], "--version") == 0) {
        return print_version();
    }
    const host_command *command = find_command(arguments[1]);
    return command != NULL ? run_command(command, count - 2, arguments + 2) : refuse_command(arguments[1]);
}

int main(int count, char **arguments) {
    return finish(run(count, arguments));
}
