/* SPDX-License-Identifier: MIT */
/**
 * @file fuzz_command.c
 * The command line on any bytes (libFuzzer), a line of the input for each argument: the program's main function, with
 * functions in place of the commands, so that no file is read or written. Either one line says what is wrong, and the
 * exit status is 2; or it is 0, and a command has settings in their ranges. A generated shape that is small is loaded
 * and put in view as they say, whose frame the library can tell the size of or names an error.
 */
#include "checks.h"
#include "command.h"
#include "model.h"
#include "values.h"
#include "view.h"

#include <stdio.h>
#include <string.h>

/** main.c's main, which is compiled by this name. */
int glint_main(int count, char **arguments);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerInitialize(const int *count, char ***arguments);

#define ARGUMENTS_MAX 64

/** Positions of a shape that is loaded: larger ones take long. */
#define POSITIONS_MAX 600

static unsigned failures;

/* ---- What settings promise --------------------------------------------------------------------------------------- */

static bool is_within(double value, double least, double most) {
    return value >= least && value <= most;
}

static void check_channels(glint_colour colour) {
    require(is_within(colour.r, 0, GLINT_Q16(16)) && is_within(colour.g, 0, GLINT_Q16(16)) &&
            is_within(colour.b, 0, GLINT_Q16(16)));
}

static bool is_direction(glint_vector vector) {
    return vector.x != 0 || vector.y != 0 || vector.z != 0;
}

static void check_light(const glint_light *light) {
    check_channels(light->diffuse);
    require(light->type != NULL && light->linear >= 0 && light->quadratic >= 0);
    require(light->type != &glint_light_directional || is_direction(light->direction));
    require(light->type != &glint_light_spot || is_direction(light->direction));
    require(light->inner >= 0 && light->inner <= light->outer && light->outer <= 180 * GLINT_ONE);
}

static bool is_tile_side(uint16_t side) {
    return side == 0 || side == 8 || side == 16 || side == 32 || side == 64;
}

static void check_picture(const host_settings *settings) {
    require(is_within(settings->width, 1, GLINT_SIZE_MAX) && is_within(settings->height, 1, GLINT_SIZE_MAX));
    require(is_within(settings->panel.width, 1, GLINT_SIZE_MAX) &&
            is_within(settings->panel.height, 1, GLINT_SIZE_MAX));
    require(is_tile_side(settings->tile_width) && is_tile_side(settings->tile_height));
    require(settings->format != NULL && settings->panel.format != NULL && is_within(settings->gamma, 0.1, 10));
    require(settings->animate <= 1000 && settings->frame <= 1000000);
}

static void check_scene(const host_settings *settings) {
    require(is_within(settings->field_of_view, GLINT_ONE, 170 * GLINT_ONE) && settings->near_plane > 0);
    require(settings->view_height >= 0 && is_direction(settings->up));
    check_channels(settings->ambient);
    check_channels(settings->diffuse);
    check_channels(settings->specular);
    check_channels(settings->background);
    require(settings->shininess >= 0 && settings->reflection != NULL && settings->light_count <= GLINT_LIGHTS_MAX);
    for (uint32_t i = 0; i < settings->light_count; i++) {
        check_light(&settings->lights[i]);
    }
}

static void check_loading(const host_settings *settings) {
    const load_options *load = &settings->load;
    for (int i = 0; i < 3; i++) {
        require(is_within(settings->scale[i], -NUMBER_Q16_MAX, NUMBER_Q16_MAX));
        require(settings->scale[i] < 0 || settings->scale[i] > 0);
    }
    require(load->weld <= OBJ_COORDINATE_MAX && load->simplify <= OBJ_ITEMS_MAX);
    require(load->texture.side <= TEXTURE_SIDE_MAX && load->texture.type <= TEXTURE_PALETTE16);
    require(is_within(load->import.seconds, 1, 86400) && is_within(load->import.megabytes, 1, 1048576));
}

static void check_settings(const host_settings *settings) {
    check_picture(settings);
    check_scene(settings);
    check_loading(settings);
}

/* ---- What a shape becomes ---------------------------------------------------------------------------------------- */

static bool is_small_shape(const host_settings *settings) {
    host_mesh mesh;
    host_problem problem = {0, ""};
    const host_shape *shape = shape_find(settings->model);
    if (shape == NULL) {
        require(!shape_offer(&problem));
        check_problem(&problem);
        return false;
    }
    if (!shape_make(shape, settings->model, &mesh, &problem)) {
        check_problem(&problem);
        return false;
    }
    const bool small = mesh.position_count <= POSITIONS_MAX;
    mesh_free(&mesh);
    return small;
}

static void check_view(const host_settings *settings, const host_model *model, const quantised_mesh *mesh) {
    host_view view;
    host_problem problem = {0, ""};
    if (!view_make(&view, settings, &model->materials, mesh, &problem)) {
        check_problem(&problem);
        return;
    }
    glint_need need = {0};
    view_turn(&view, settings, settings->animate / 2);
    const glint_status status = view_need(&view.scene, settings, &need);
    require(status == GLINT_OK ? need.least > 0 && need.least <= need.one_pass : glint_strerror(status)[0] != '\0');
    view_free(&view);
}

/** As command_prepare does. */
static void load_shape(const host_settings *settings, bool converted) {
    host_model model;
    quantised_mesh mesh;
    host_problem problem = {0, ""};
    load_options options = settings->load;
    options.picture = NULL; /* a file */
    if (!is_small_shape(settings)) {
        return;
    }
    if (!load_model(settings->model, &options, &model, &problem)) {
        check_problem(&problem);
        return;
    }
    place_model(&model, settings, converted);
    if (!converted) {
        place_to_fit(&model, settings);
    }
    if (quantise(&model.mesh, 0, &settings->load.types, &mesh, &problem)) {
        check_view(settings, &model, &mesh);
        quantised_free(&mesh);
    } else {
        check_problem(&problem);
    }
    model_free(&model);
}

/* ---- In place of the commands ------------------------------------------------------------------------------------ */

int command_fail(const char *file, const host_problem *problem) {
    require(file == NULL && problem->line == 0);
    check_problem(problem);
    failures++;
    return COMMAND_FAILED;
}

int command_render(const host_settings *settings) {
    check_settings(settings);
    load_shape(settings, false);
    return 0;
}

int command_info(const host_settings *settings) {
    check_settings(settings);
    load_shape(settings, false);
    return 0;
}

int command_convert(const host_settings *settings) {
    check_settings(settings);
    require(settings->name == NULL || strlen(settings->name) <= 64);
    require(settings->licence == NULL || strlen(settings->licence) <= 100);
    load_shape(settings, true);
    return 0;
}

int command_scene(const host_settings *settings) {
    check_settings(settings);
    return 0;
}

int command_demo(const host_settings *settings) {
    check_settings(settings);
    require(settings->model == NULL && settings->models != NULL);
    return 0;
}

/* ---- Arguments --------------------------------------------------------------------------------------------------- */

/** What the help prints is of no use here. */
int LLVMFuzzerInitialize(const int *count, char ***arguments) {
    (void)count;
    (void)arguments;
    return freopen("/dev/null", "w", stdout) == NULL;
}

/** A line, up to a byte of 0 or of a line end, as a string in memory of its size. */
static char *take_argument(source *from) {
    size_t length = 0;
    while (length < from->left && from->bytes[length] != '\n' && from->bytes[length] != '\0') {
        length++;
    }
    char *argument = allocate(length + 1);
    memcpy(argument, from->bytes, length);
    argument[length] = '\0';
    const size_t taken = length < from->left ? length + 1 : length;
    from->bytes += taken;
    from->left -= taken;
    return argument;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static char program[] = "glint";
    source from = {data, size};
    char *arguments[ARGUMENTS_MAX + 1] = {program};
    int count = 1;
    while (from.left > 0 && count < ARGUMENTS_MAX) {
        arguments[count++] = take_argument(&from);
    }
    failures = 0;
    const int status = glint_main(count, arguments);
    require(status == (failures > 0 ? COMMAND_FAILED : 0) && failures <= 1);
    while (count > 1) {
        free(arguments[--count]);
    }
    return 0;
}
