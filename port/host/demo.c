/* SPDX-License-Identifier: MIT */
/**
 * @file demo.c
 * A sheet of pictures as panels show them: each is what `glint render` draws with the arguments that stand here.
 */
#include "command.h"

#include "basics.h"
#include "png.h"
#include "view.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** A panel of 320x240 pixels each, in rows from the left. File names are looked up in the folder of the models. */
#define PANEL "--size 320x240 --format rgb565 --dither "
#define CELL_WIDTH 320u
#define CELL_HEIGHT 240u
#define COLUMNS 3u

/** Most arguments of a cell, and bytes of all of them. */
#define ARGUMENTS_MAX 48
#define ARGUMENTS_SIZE 512

#define CELLS (sizeof cells / sizeof cells[0])
#define SHEET_WIDTH (COLUMNS * CELL_WIDTH)
#define SHEET_HEIGHT ((uint32_t)CELLS / COLUMNS * CELL_HEIGHT)

static const char *const cells[] = {
    /* Glazed clay: a warm key light, a cool one from behind that draws the outline, a faint one from below. */
    "teapot.obj --double-sided --eye 0.55,1.65,2.3 --at 0.07,-0.04,0 --fov 32 --viewer local "
    "--light dir:-0.6,0.8,0.7:1,0.95,0.86 --light dir:0.9,0.35,-0.7:0.35,0.55,0.95 "
    "--light dir:0.2,-0.9,0.4:0.2,0.13,0.1 --ambient .05,.055,.07 --diffuse .5,.13,.1 --specular .9 "
    "--shininess 60 --background .075,.085,.115",
    /* Copper. */
    "spot.obj --rotate-y 172 --viewer local --light dir:-0.7,0.8,0.6:1,.95,.9 --light dir:1,0.2,-0.4:.5,.35,.3 "
    "--ambient .08,.035,.025 --diffuse .62,.27,.13 --specular .8,.52,.34 --shininess 22 --background .12,.085,.08",
    /* Plastic, seen by the infinite viewer. */
    "torus:96x48 --rotate-x -65 --viewer infinite --light dir:-0.5,1,0.5 --light dir:0.9,0.5,-0.4:.25,.3,.45 "
    "--ambient .01,.04,.07 --diffuse .04,.36,.68 --specular .85 --shininess 160 --background .06,.1,.13",
    /* Facets: normals split at every edge. */
    "spot-control.obj --crease 0 --rotate-y 180 --viewer infinite --light dir:-0.6,0.9,0.5:1,1,.9 "
    "--light dir:0.8,-0.1,0.6:.3,.35,.5 --ambient .06,.09,.06 --diffuse .45,.68,.33 --specular .15 --shininess 8 "
    "--background .085,.115,.085",
    /* Steel. */
    "featuretype.obj --rotate-y 68 --viewer local --light dir:-0.5,0.8,0.7:.95,.97,1 "
    "--light dir:0.3,0.62,-0.82:.75,.6,.4 --light dir:0.9,-0.45,0.7:.4,.45,.55 --ambient .07,.075,.085 "
    "--diffuse .44,.46,.5 --specular .7 --shininess 18 --background .1,.1,.108",
    /* Three coloured lights and a grey one on white. */
    "sphere:128x64 --eye 0,0.5,3.1 --fov 41 --viewer local --light dir:-1,0.5,0.6:1,.16,.12 "
    "--light dir:1,0.5,0.5:.14,.35,1 --light dir:0,-1,0.35:.12,.8,.2 --light dir:0,1,.6:.3,.3,.3 --ambient .03 "
    "--diffuse .75 --specular .6 --shininess 300 --background .095,.085,.12",
};

typedef struct demo_words {
    char text[ARGUMENTS_SIZE];
    char *words[ARGUMENTS_MAX];
    int count;
} demo_words;

static void split_words(const char *text, demo_words *out) {
    out->count = 0;
    snprintf(out->text, sizeof out->text, PANEL "%s", text);
    for (char *word = strtok(out->text, " "); word != NULL && out->count < ARGUMENTS_MAX; word = strtok(NULL, " ")) {
        out->words[out->count++] = word;
    }
}

/** The model's path: shapes have none. The caller frees it. */
static char *model_path(const char *folder, const char *model) {
    const size_t size = strlen(folder) + strlen(model) + 2;
    char *path = memory_new(size, 1);
    const bool is_shape = strchr(model, ':') != NULL;
    snprintf(path, size, "%s%s%s", is_shape ? "" : folder, is_shape ? "" : "/", model);
    return path;
}

static void place_picture(const framebuffer *source, size_t cell, uint8_t *sheet) {
    uint8_t *picture = framebuffer_expand(source);
    const size_t row = 3 * (size_t)source->width;
    const size_t left = cell % COLUMNS * CELL_WIDTH;
    const size_t top = cell / COLUMNS * CELL_HEIGHT;
    for (uint32_t y = 0; y < source->height; y++) {
        memcpy(sheet + 3 * ((top + y) * SHEET_WIDTH + left), picture + y * row, row);
    }
    free(picture);
}

/** Draws a cell's scene onto the sheet. @return false with a problem */
static bool draw_view(const host_settings *settings, const host_model *model, const quantised_mesh *mesh, size_t cell,
                      uint8_t *sheet, host_problem *problem) {
    host_view view;
    framebuffer target;
    glint_stats stats;
    if (!view_make(&view, settings, &model->materials, mesh, problem)) {
        return false;
    }
    const bool drawn = view_draw(&view.scene, settings, &target, &stats, problem);
    view_free(&view);
    if (drawn) {
        place_picture(&target, cell, sheet);
        framebuffer_free(&target);
    }
    return drawn;
}

/** Draws a cell, or prints what is wrong. */
static bool draw_cell(size_t cell, const host_settings *demo, uint8_t *sheet) {
    demo_words words;
    host_settings settings;
    host_problem problem;
    settings_default(&settings);
    split_words(cells[cell], &words);
    if (!settings_parse(&settings, COMMAND_RENDER, words.count, words.words, &problem)) {
        problem_print(NULL, &problem);
        return false;
    }
    char *path = model_path(demo->models, settings.model);
    settings.model = path;
    settings.output = demo->output;
    host_model model;
    quantised_mesh mesh;
    bool ok = command_load(&settings, false, &model, &mesh);
    if (ok) {
        ok = draw_view(&settings, &model, &mesh, cell, sheet, &problem);
        quantised_free(&mesh);
        if (ok) {
            command_print_warnings(&settings, &model);
        } else {
            problem_print(NULL, &problem);
        }
        model_free(&model);
    }
    free(path);
    return ok;
}

static int write_sheet(const uint8_t *sheet, const char *path) {
    host_bytes file = {NULL, 0, 0};
    png_encode(&file, sheet, SHEET_WIDTH, SHEET_HEIGHT, 3);
    const int status = command_write(&file, path);
    if (status == 0) {
        printf("%s\n", path);
    }
    return status;
}

int command_demo(const host_settings *settings) {
    uint8_t *sheet = memory_new((size_t)SHEET_WIDTH * SHEET_HEIGHT, 3);
    bool ok = true;
    for (size_t i = 0; ok && i < CELLS; i++) {
        ok = draw_cell(i, settings, sheet);
    }
    const int status = ok ? write_sheet(sheet, settings->output) : COMMAND_FAILED;
    free(sheet);
    return status;
}
