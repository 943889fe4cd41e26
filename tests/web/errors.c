/* SPDX-License-Identifier: MIT */
/*
 * The errors of a picture as this machine computes them: errors COMMAND SAME WORD... with the words of `glint render`
 * or `glint scene`. Writes each pixel's as a float to stdout. Ends with 3 where sums are not those of the suites'
 * judge.
 */
#include "command.h"
#include "judge.h"
#include "measure.h"
#include "scenes/scenes.h"
#include "view.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int complain(const host_problem *problem) {
    problem_print(NULL, problem);
    return 1;
}

/** The judge draws the picture anew. */
static int is_judged_so(const glint_scene *scene, const host_settings *settings, const measured_errors *sums) {
    const glint_format *format = measure_configuration(settings).format;
    const judge_task task = {.scene = scene,
                             .width = settings->width,
                             .height = settings->height,
                             .format = format,
                             .leave_out_gates = 1,
                             .fine = 1};
    judgement total = {0};
    judge(&task, &total);
    return total.status == GLINT_OK && fabs(total.worst - sums->worst) < 1e-6 &&
           fabs(total.squares / (double)total.samples - sums->squares / sums->samples) < 1e-9;
}

static int write_errors(const glint_scene *scene, const host_settings *settings, int same) {
    framebuffer target;
    glint_stats stats;
    host_problem problem;
    measured_errors sums;
    if (!view_draw(scene, settings, &target, &stats, &problem)) {
        return complain(&problem);
    }
    float *errors = measure_errors(scene, settings, &target, same, &sums);
    const size_t count = (size_t)target.width * target.height;
    int failed = errors == NULL || fwrite(errors, sizeof *errors, count, stdout) != count;
    if (!failed && same && !is_judged_so(scene, settings, &sums)) {
        failed = 3;
    }
    free(errors);
    framebuffer_free(&target);
    return failed;
}

static int write_scene(const host_settings *settings, int same) {
    static example_stage stage;
    char *colon = strchr(settings->model, ':');
    for (int i = 0; i < EXAMPLE_SCENES; i++) {
        const example_scene *scene = example_scenes[i];
        for (uint32_t j = 0; j < scene->variant_count; j++) {
            if (strncmp(scene->name, settings->model, strlen(scene->name)) == 0 && colon != NULL &&
                strcmp(scene->variants[j].name, colon + 1) == 0) {
                scene->build(&stage, j, settings->frame);
                return write_errors(&stage.scene, settings, same);
            }
        }
    }
    return 1;
}

static int write_model(const host_settings *settings, int same) {
    host_model model;
    quantised_mesh mesh;
    host_view view;
    host_problem problem;
    if (!command_load(settings, false, &model, &mesh)) {
        return 1;
    }
    if (!view_make(&view, settings, &model.materials, &mesh, &problem)) {
        return complain(&problem);
    }
    const int failed = write_errors(&view.scene, settings, same);
    view_free(&view);
    quantised_free(&mesh);
    model_free(&model);
    return failed;
}

int main(int count, char **arguments) {
    host_settings settings;
    host_problem problem;
    if (count < 4) {
        fputs("errors render|scene 0|1 WORD...\n", stderr);
        return 2;
    }
    const int is_scene = strcmp(arguments[1], "scene") == 0, same = arguments[2][0] == '1';
    settings_default(&settings);
    if (!settings_parse(&settings, is_scene ? COMMAND_SCENE : COMMAND_RENDER, count - 3, arguments + 3, &problem)) {
        return complain(&problem);
    }
    return is_scene ? write_scene(&settings, same) : write_model(&settings, same);
}
