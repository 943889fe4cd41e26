/* SPDX-License-Identifier: MIT */
/**
 * @file export.c
 * Files that the window writes: pictures, and scenes as const C data.
 */
#include "window.h"

#include "command.h"
#include "png.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Room for a name made of a scene's, and for that with what tells files apart. */
#define NAME_SIZE 49
#define FILE_SIZE (NAME_SIZE + 16)

/** Most files of one name. */
#define FILES_MAX 9999

/* ---- Names ------------------------------------------------------------------------------------------------------ */

/** The name of what is shown, without folder and ending, as a C identifier. */
static void find_name(const window_state *state, char name[NAME_SIZE]) {
    const char *base = path_base_name(state->name);
    const char *dot = strrchr(base, '.');
    const size_t length = dot != NULL && dot > base ? (size_t)(dot - base) : strlen(base);
    size_t used = 0;
    if (base[0] >= '0' && base[0] <= '9') {
        name[used++] = 'm';
    }
    for (size_t i = 0; i < length && used < NAME_SIZE - 1; i++) {
        name[used++] = convert_plain(base[i]);
    }
    name[used] = '\0';
}

/** A file's name that nothing has yet: NAME-1.ENDING and so on. */
static void find_file(const char *name, const char *ending, char file[FILE_SIZE]) {
    for (int number = 1; number <= FILES_MAX; number++) {
        snprintf(file, FILE_SIZE, "%s-%d.%s", name, number, ending);
        FILE *there = fopen(file, "rb");
        if (there == NULL) {
            return;
        }
        fclose(there);
    }
}

static void write_file(window_state *state, const host_bytes *bytes, const char *name, const char *ending) {
    char file[FILE_SIZE];
    host_problem problem;
    find_file(name, ending, file);
    if (bytes_write_file(bytes, file, &problem)) {
        snprintf(state->message, sizeof state->message, "wrote %s", file);
    } else {
        snprintf(state->message, sizeof state->message, "%s: %.90s", file, problem.text);
    }
}

/* ---- Data ------------------------------------------------------------------------------------------------------- */

/** Where a scene's data goes, and under which name. */
typedef struct data_writer {
    host_bytes *out;
    char name[NAME_SIZE];
} data_writer;

static bool is_same_vector(glint_vector a, glint_vector b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/** Whether two objects' meshes come to the same data. */
static bool is_same_mesh(const window_scene *built, uint32_t i, uint32_t j) {
    const glint_mesh *a = built->objects[i].mesh;
    const glint_mesh *b = built->objects[j].mesh;
    const bool coloured_here = built->paints[i].colours != NULL && built->paints[j].colours != NULL;
    return a->positions == b->positions && a->normals == b->normals && a->triangles == b->triangles &&
           a->vertex_count == b->vertex_count && a->triangle_count == b->triangle_count && a->flags == b->flags &&
           a->clusters == b->clusters && is_same_vector(a->offset, b->offset) && is_same_vector(a->extent, b->extent) &&
           (a->colours == b->colours || coloured_here);
}

/** The first object that has an object's mesh. */
static uint32_t find_mesh(const window_scene *built, uint32_t i) {
    uint32_t first = 0;
    while (!is_same_mesh(built, first, i)) {
        first++;
    }
    return first;
}

static void print_meshes(const data_writer *to, const window_scene *built) {
    for (uint32_t i = 0; i < built->scene.object_count; i++) {
        char suffix[16];
        snprintf(suffix, sizeof suffix, "_%lu", (unsigned long)i);
        if (find_mesh(built, i) == i) {
            convert_mesh(to->out, to->name, built->objects[i].mesh, suffix);
        }
    }
}

static void print_vector(const data_writer *to, glint_vector v) {
    bytes_print(to->out, "{%ld, %ld, %ld}", (long)v.x, (long)v.y, (long)v.z);
}

static void print_colour(const data_writer *to, const char *field, glint_colour colour) {
    bytes_print(to->out, "     .%s = {%ld, %ld, %ld},\n", field, (long)colour.r, (long)colour.g, (long)colour.b);
}

static void print_pose(const data_writer *to, const glint_pose *pose) {
    bytes_print(to->out, "{{");
    for (int row = 0; row < 3; row++) {
        bytes_print(to->out, "%s{%ld, %ld, %ld, %ld}", row > 0 ? ", " : "", (long)pose->m[row][0],
                    (long)pose->m[row][1], (long)pose->m[row][2], (long)pose->m[row][3]);
    }
    bytes_print(to->out, "}}");
}

static const char *name_model(const glint_shading_model *model) {
    return model == &glint_model_lambert ? "lambert"
           : model == &glint_model_phong ? "phong"
           : model == &glint_model_unlit ? "unlit"
                                         : "blinn_phong";
}

static void print_materials(const data_writer *to, const window_scene *built) {
    bytes_print(to->out, "\nstatic const glint_material %s_materials[%lu] = {\n", to->name,
                (unsigned long)(built->scene.object_count > 0 ? built->scene.object_count : 1));
    for (uint32_t i = 0; i < built->scene.object_count; i++) {
        const glint_material *material = built->objects[i].material;
        bytes_print(to->out, "    {.model = &glint_model_%s,\n", name_model(material->model));
        print_colour(to, "ambient", material->ambient);
        print_colour(to, "diffuse", material->diffuse);
        print_colour(to, "specular", material->specular);
        bytes_print(to->out, "     .shininess = %ld,\n     .flags = %luu},\n", (long)material->shininess,
                    (unsigned long)material->flags);
    }
    bytes_print(to->out, built->scene.object_count > 0 ? "};\n" : "    {0}, /* none */\n};\n");
}

static void print_lights(const data_writer *to, const glint_scene *scene) {
    bytes_print(to->out, "\nstatic const glint_light %s_lights[%lu] = {\n", to->name,
                (unsigned long)(scene->light_count > 0 ? scene->light_count : 1));
    for (uint32_t i = 0; i < scene->light_count; i++) {
        const glint_light *light = &scene->lights[i];
        bytes_print(to->out, "    {.type = &glint_light_%s,\n     .position = ",
                    light->type == &glint_light_point  ? "point"
                    : light->type == &glint_light_spot ? "spot"
                                                       : "directional");
        print_vector(to, light->position);
        bytes_print(to->out, ",\n     .direction = ");
        print_vector(to, light->direction);
        bytes_print(to->out, ",\n");
        print_colour(to, "diffuse", light->diffuse);
        print_colour(to, "specular", light->specular);
        bytes_print(to->out, "     .linear = %ld,\n     .quadratic = %ld,\n     .inner = %ld,\n     .outer = %ld},\n",
                    (long)light->linear, (long)light->quadratic, (long)light->inner, (long)light->outer);
    }
    bytes_print(to->out, scene->light_count > 0 ? "};\n" : "    {0}, /* none */\n};\n");
}

static const char *name_evaluation(const glint_evaluation *evaluation) {
    return evaluation == &glint_per_facet    ? "&glint_per_facet"
           : evaluation == &glint_per_vertex ? "&glint_per_vertex"
                                             : "&glint_per_fragment";
}

static void print_objects(const data_writer *to, const window_scene *built) {
    bytes_print(to->out, "\nstatic const glint_object %s_objects[%lu] = {\n", to->name,
                (unsigned long)(built->scene.object_count > 0 ? built->scene.object_count : 1));
    for (uint32_t i = 0; i < built->scene.object_count; i++) {
        const glint_object *object = &built->objects[i];
        bytes_print(to->out,
                    "    {.mesh = &%s_mesh_%lu,\n     .material = &%s_materials[%lu],\n     .pose = ", to->name,
                    (unsigned long)find_mesh(built, i), to->name, (unsigned long)i);
        print_pose(to, &object->pose);
        bytes_print(to->out, ",\n     .evaluation = %s,\n     .hidden = %d},\n", name_evaluation(object->evaluation),
                    object->hidden != 0);
    }
    bytes_print(to->out, built->scene.object_count > 0 ? "};\n" : "    {0}, /* none */\n};\n");
}

static void print_scene(const data_writer *to, const glint_scene *scene) {
    bytes_print(to->out, "\nstatic const glint_scene %s_scene = {\n    .camera = {.pose = ", to->name);
    print_pose(to, &scene->camera.pose);
    bytes_print(to->out, ",\n               .field_of_view = %ld,\n               .near_plane = %ld",
                (long)scene->camera.field_of_view, (long)scene->camera.near_plane);
    if (scene->camera.projection != NULL) {
        bytes_print(to->out, ",\n               .projection = &glint_orthographic,\n               .view_height = %ld",
                    (long)scene->camera.view_height);
    }
    bytes_print(to->out, "},\n");
    bytes_print(to->out, "    .viewer = GLINT_VIEWER_%s,\n",
                scene->viewer == GLINT_VIEWER_LOCAL ? "LOCAL" : "INFINITE");
    bytes_print(to->out, "    .background = {%ld, %ld, %ld},\n    .ambient = {%ld, %ld, %ld},\n",
                (long)scene->background.r, (long)scene->background.g, (long)scene->background.b, (long)scene->ambient.r,
                (long)scene->ambient.g, (long)scene->ambient.b);
    bytes_print(to->out, "    .lights = %s_lights,\n    .light_count = %lu,\n    .objects = %s_objects,\n", to->name,
                (unsigned long)scene->light_count, to->name);
    bytes_print(to->out, "    .object_count = %lu,\n};\n", (unsigned long)scene->object_count);
}

/** The table of a picture that has one, for all three channels. */
static void print_gamma(const data_writer *to, double gamma) {
    uint16_t tables[3][GLINT_GAMMA_ENTRIES];
    view_gamma(gamma, tables);
    bytes_print(to->out, "\nstatic const uint16_t %s_gamma[3][GLINT_GAMMA_ENTRIES] = {\n", to->name);
    for (int channel = 0; channel < 3; channel++) {
        bytes_print(to->out, "    {");
        for (int i = 0; i < GLINT_GAMMA_ENTRIES; i++) {
            bytes_print(to->out, i % 16 == 15 ? "\n     %u," : "%u,", tables[channel][i]);
        }
        bytes_print(to->out, "},\n");
    }
    bytes_print(to->out, "};\n");
}

static void print_config(const data_writer *to, const window_state *state, size_t arena) {
    const host_settings *settings = &state->settings;
    bytes_print(to->out,
                "\n/* What it was drawn with: all of a configuration but arena and flush. */\n"
                "static const glint_config %s_config = {\n",
                to->name);
    bytes_print(to->out, "    .width = %u,\n    .height = %u,\n    .tile_width = %u,\n    .tile_height = %u,\n",
                settings->width, settings->height, settings->tile_width, settings->tile_height);
    bytes_print(to->out, "    .format = &glint_format_%s%s,\n", settings->format->name,
                settings->dither ? "_dithered" : "");
    bytes_print(to->out, "    .arena_size = %zu, /* bytes, on this machine; less means more passes */\n", arena);
    if (settings->gamma < 1 || settings->gamma > 1) {
        bytes_print(to->out, "    .gamma = %s_gamma,\n", to->name);
    }
    bytes_print(to->out, "};\n");
}

static void print_all(data_writer *to, const window_state *state, const window_scene *built, size_t arena) {
    host_bytes *out = to->out;
    bytes_print(out,
                "/*\n * A scene, as the window showed it: %s_scene and %s_config. Generated by glint-view.\n"
                " * Numbers are Q16.16: 65536 is 1. Copy what moves.\n */\n",
                to->name, to->name);
    bytes_print(out, "#ifndef GLINT_SCENE_%s\n#define GLINT_SCENE_%s\n\n#include \"glint.h\"\n", to->name, to->name);
    print_meshes(to, built);
    print_materials(to, built);
    print_lights(to, &built->scene);
    print_objects(to, built);
    print_scene(to, &built->scene);
    if (state->settings.gamma < 1 || state->settings.gamma > 1) {
        print_gamma(to, state->settings.gamma);
    }
    print_config(to, state, arena);
    bytes_print(out, "\n#endif\n");
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

void window_screenshot(window_state *state) {
    window_frame frame;
    host_problem problem;
    host_bytes file = {NULL, 0, 0};
    char name[NAME_SIZE];
    if (!window_render(state, &frame, &problem)) {
        snprintf(state->message, sizeof state->message, "%.150s", problem.text);
        return;
    }
    png_encode(&file, frame.picture, frame.target.width, frame.target.height, 3);
    find_name(state, name);
    write_file(state, &file, name, "png");
    free(file.data);
    window_frame_free(&frame);
}

void window_export(window_state *state) {
    window_frame frame;
    window_scene built;
    host_problem problem;
    host_bytes file = {NULL, 0, 0};
    data_writer to = {.out = &file};
    if (!window_render(state, &frame, &problem) || !window_build(state, &built, &problem)) {
        snprintf(state->message, sizeof state->message, "%.150s", problem.text);
        return;
    }
    find_name(state, to.name);
    print_all(&to, state, &built, frame.arena);
    write_file(state, &file, to.name, "h");
    free(file.data);
    window_scene_free(&built);
    window_frame_free(&frame);
}
