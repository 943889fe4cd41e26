/* SPDX-License-Identifier: MIT */
/**
 * @file build.c
 * From the state to a scene: what was loaded, with what keys and mouse changed of it.
 */
#include "glint_extras.h"
#include "window.h"

#include "basics.h"
#include "values.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** How steeply a camera may look down or up, degrees. */
#define STEEPEST 89.0

/** Part of what the view reaches at which the drawn lights of no place stand, and radius of those that are drawn. */
#define LIGHT_DISTANCE 1.0
#define LIGHT_RADIUS 0.05

static const double pi = 3.14159265358979323846;

/* ---- Vectors ---------------------------------------------------------------------------------------------------- */

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void window_turn(double vector[3], const double axis[3], double degrees) {
    const double c = cos(degrees * pi / 180);
    const double s = sin(degrees * pi / 180);
    const double along = dot(axis, vector) * (1 - c);
    double turned[3];
    for (int i = 0; i < 3; i++) { /* Rodrigues */
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        turned[i] = vector[i] * c + (axis[j] * vector[k] - axis[k] * vector[j]) * s + axis[i] * along;
    }
    memcpy(vector, turned, sizeof turned);
}

/** A number as Q16.16, at most as large as that holds. */
static glint_q16 held(double value) {
    return number_q16(fmax(-NUMBER_Q16_MAX, fmin(NUMBER_Q16_MAX, value)));
}

static glint_vector vector_of(const double v[3]) {
    const glint_vector vector = {held(v[0]), held(v[1]), held(v[2])};
    return vector;
}

/* ---- Camera ----------------------------------------------------------------------------------------------------- */

/** The middle of an object's box in the world, and its radius. */
static double measure(const glint_object *object, double middle[3]) {
    const glint_mesh *mesh = object->mesh;
    double offset[3];
    double extent[3];
    double square = 0;
    number_from_vector(mesh->offset, offset);
    number_from_vector(mesh->extent, extent);
    for (int row = 0; row < 3; row++) {
        double half = 0;
        middle[row] = number_from_q16(object->pose.m[row][3]);
        for (int column = 0; column < 3; column++) {
            middle[row] += number_from_q16(object->pose.m[row][column]) * offset[column];
            half += fabs(number_from_q16(object->pose.m[row][column])) * extent[column];
        }
        square += half * half;
    }
    return sqrt(square);
}

/**
 * How far before the camera lies what the scene is about: the mean of its objects, of which small ones weigh most, so
 * that ground and sky hardly count.
 */
static double find_distance(const glint_scene *scene, const double eye[3], const double back[3]) {
    const double least = 4 * number_from_q16(scene->camera.near_plane);
    double sum = 0;
    double weights = 0;
    for (uint32_t i = 0; i < scene->object_count; i++) {
        double middle[3];
        const double radius = measure(&scene->objects[i], middle);
        const double weight = scene->objects[i].hidden ? 0 : 1 / fmax(radius * radius, 1e-9);
        for (int axis = 0; axis < 3; axis++) {
            sum += weight * (eye[axis] - middle[axis]) * back[axis];
        }
        weights += weight;
    }
    return fmax(weights > 0 ? sum / weights : 0, least);
}

static void find_axes(window_scene *built) {
    const glint_pose *pose = &built->scene.camera.pose;
    double eye[3];
    for (int row = 0; row < 3; row++) {
        built->right[row] = number_from_q16(pose->m[row][0]);
        built->up[row] = number_from_q16(pose->m[row][1]);
        built->back[row] = number_from_q16(pose->m[row][2]);
        eye[row] = number_from_q16(pose->m[row][3]);
    }
    const double distance = find_distance(&built->scene, eye, built->back);
    built->reach = distance * tan(number_from_q16(built->scene.camera.field_of_view) * pi / 360);
    for (int row = 0; row < 3; row++) {
        built->target[row] = eye[row] - distance * built->back[row];
    }
}

/** Turns the camera about what it looks at, and takes it nearer or farther. */
static void orbit(const window_changes *changes, const double sky[3], window_scene *built) {
    glint_pose *pose = &built->scene.camera.pose;
    const double angle = number_from_q16(built->scene.camera.field_of_view) * pi / 360;
    const double distance = changes->zoom * built->reach / tan(angle);
    const double height = asin(fmax(-1, fmin(1, dot(built->back, sky)))) * 180 / pi;
    built->pitch = fmax(-STEEPEST - height, fmin(STEEPEST - height, changes->pitch));
    window_turn(built->back, built->right, -built->pitch);
    window_turn(built->up, built->right, -built->pitch);
    window_turn(built->right, sky, changes->yaw);
    window_turn(built->up, sky, changes->yaw);
    window_turn(built->back, sky, changes->yaw);
    for (int row = 0; row < 3; row++) {
        pose->m[row][0] = number_q16(built->right[row]);
        pose->m[row][1] = number_q16(built->up[row]);
        pose->m[row][2] = number_q16(built->back[row]);
        pose->m[row][3] = held(built->target[row] + distance * built->back[row]);
    }
}

/* ---- Objects ---------------------------------------------------------------------------------------------------- */

static glint_q16 quarter(glint_q16 value) {
    return value / 4;
}

static glint_q16 raised(glint_q16 shininess, int eighths) {
    return held(number_from_q16(shininess) * pow(2, eighths / 8.0));
}

static void change_material(const window_changes *changes, glint_material *material) {
    static const glint_colour black = {0, 0, 0};
    if (material->model == &glint_model_unlit) {
        return;
    }
    material->model = changes->reflection != NULL ? changes->reflection : material->model;
    if (changes->exponent != 0) {
        material->shininess = raised(material->shininess, changes->exponent);
    }
    if (changes->dark) {
        material->diffuse.r = quarter(material->diffuse.r);
        material->diffuse.g = quarter(material->diffuse.g);
        material->diffuse.b = quarter(material->diffuse.b);
    }
    material->diffuse = changes->terms == WINDOW_SPECULAR ? black : material->diffuse;
    material->specular = changes->terms == WINDOW_DIFFUSE ? black : material->specular;
}

/** Colours of a mesh's vertices by their normals. */
static uint8_t (*colour_mesh(const glint_mesh *mesh))[3] {
    uint8_t(*colours)[3] = memory_new(mesh->vertex_count, sizeof *colours);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const int16_t *normal = mesh->normals[i];
        const double length =
            sqrt((double)normal[0] * normal[0] + (double)normal[1] * normal[1] + (double)normal[2] * normal[2]);
        for (int axis = 0; axis < 3; axis++) {
            colours[i][axis] = (uint8_t)lround(127.5 + 127.5 * normal[axis] / fmax(length, 1));
        }
    }
    return colours;
}

/** Plain meshes get colours, others lose theirs. */
static void change_colours(window_scene *built, uint32_t i) {
    glint_mesh *mesh = &built->meshes[i];
    *mesh = *built->objects[i].mesh;
    if (mesh->colours != NULL || mesh->colours565 != NULL) {
        mesh->colours = NULL;
    } else {
        built->paints[i].colours = colour_mesh(mesh);
        mesh->colours = (const uint8_t(*)[3])built->paints[i].colours;
    }
    mesh->colours565 = NULL;
    built->objects[i].mesh = mesh;
}

/** Half as high as it was, about what the camera looks at. */
static void squash(const double target[3], glint_pose *pose) {
    for (int column = 0; column < 4; column++) {
        const double value = number_from_q16(pose->m[1][column]);
        pose->m[1][column] = held(value / 2 + (column == 3 ? target[1] / 2 : 0));
    }
}

static void change_objects(const window_changes *changes, window_scene *built) {
    for (uint32_t i = 0; i < built->scene.object_count; i++) {
        glint_object *object = &built->objects[i];
        built->materials[i] = *object->material;
        change_material(changes, &built->materials[i]);
        object->material = &built->materials[i];
        object->evaluation = changes->has_evaluation ? changes->evaluation : object->evaluation;
        if (changes->colours) {
            change_colours(built, i);
        }
        if (changes->squashed) {
            squash(built->target, &object->pose);
        }
    }
}

/* ---- Lights ----------------------------------------------------------------------------------------------------- */

static void change_lights(const window_changes *changes, window_scene *built) {
    for (uint32_t i = 0; i < changes->light_count; i++) {
        const window_light *light = &changes->lights[i];
        built->lights[i] = light->light;
        built->lights[i].position = vector_of(light->position);
        built->lights[i].direction = vector_of(light->direction);
    }
    built->scene.lights = built->lights;
    built->scene.light_count = changes->light_count;
}

/** A small ball of no light but its own; ends the program where it cannot be made, as it always can. */
static const glint_mesh *ball(void) {
    enum { AROUND = 12, ALONG = 8, VERTICES = (AROUND + 1) * (ALONG + 1), TRIANGLES = 2 * AROUND * ALONG };
    static int16_t positions[VERTICES][3];
    static int16_t normals[VERTICES][3];
    static uint16_t triangles[TRIANGLES][3];
    static glint_mesh mesh;
    const glint_mesh_room room = {positions, normals, triangles, VERTICES, TRIANGLES};
    if (mesh.vertex_count == 0 && glint_generate_sphere(&mesh, &room, AROUND, ALONG, GLINT_ONE) != GLINT_OK) {
        abort();
    }
    return &mesh;
}

static glint_q16 shown_channel(glint_q16 channel, glint_q16 most) {
    return (glint_q16)((int64_t)channel * GLINT_ONE / (most > 0 ? most : GLINT_ONE));
}

/** Adds an object where a light is, or from where it comes. */
static void show_light(const glint_light *light, window_scene *built) {
    const uint32_t i = built->scene.object_count++;
    double position[3];
    double direction[3];
    const glint_colour colour = light->diffuse;
    const glint_q16 most =
        colour.r > colour.g ? (colour.r > colour.b ? colour.r : colour.b) : (colour.g > colour.b ? colour.g : colour.b);
    const double radius = LIGHT_RADIUS * built->reach;
    const glint_pose scale = glint_pose_scale(held(radius), held(radius), held(radius));
    glint_pose pose = scale;
    number_from_vector(light->position, position);
    number_from_vector(light->direction, direction);
    for (int row = 0; row < 3; row++) {
        const double far =
            built->target[row] - LIGHT_DISTANCE * built->reach * direction[row] / sqrt(dot(direction, direction));
        pose.m[row][3] = held(light->type == &glint_light_directional ? far : position[row]);
    }
    const glint_material material = {
        .model = &glint_model_unlit,
        .diffuse = {shown_channel(colour.r, most), shown_channel(colour.g, most), shown_channel(colour.b, most)}};
    const glint_object object = {
        .mesh = ball(), .material = &built->materials[i], .evaluation = &glint_per_fragment, .pose = pose};
    built->materials[i] = material;
    built->objects[i] = object;
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

/** Copies a scene's objects, with room for those that lights become. */
static void adopt(const glint_scene *scene, window_scene *built) {
    const size_t room = (size_t)scene->object_count + GLINT_LIGHTS_MAX;
    built->scene = *scene;
    built->objects = memory_new(room, sizeof *built->objects);
    built->materials = memory_new(room, sizeof *built->materials);
    built->meshes = memory_new(room, sizeof *built->meshes);
    built->paints = memory_new(room, sizeof *built->paints);
    memcpy(built->objects, scene->objects, scene->object_count * sizeof *built->objects);
    memcpy(built->lights, scene->lights, scene->light_count * sizeof *built->lights);
    built->scene.objects = built->objects;
    built->scene.lights = built->lights;
}

static void change(const window_state *state, window_scene *built) {
    static const double upwards[3] = {0, 1, 0};
    const window_changes *changes = &state->changes;
    double sky[3];
    number_from_vector(state->settings.up, sky);
    const double length = sqrt(dot(sky, sky));
    for (int axis = 0; axis < 3; axis++) {
        sky[axis] = state->has_model ? sky[axis] / length : upwards[axis];
    }
    find_axes(built);
    change_objects(changes, built);
    if (changes->yaw < 0 || changes->yaw > 0 || changes->pitch < 0 || changes->pitch > 0 || changes->zoom < 1 ||
        changes->zoom > 1) {
        orbit(changes, sky, built);
    }
    if (changes->has_lights) {
        change_lights(changes, built);
    }
    if (changes->has_viewer) {
        built->scene.viewer = changes->viewer;
    }
    for (uint32_t i = 0; changes->shows_lights && i < built->scene.light_count; i++) {
        show_light(&built->scene.lights[i], built);
    }
}

bool window_build(const window_state *state, window_scene *built, host_problem *problem) {
    memset(built, 0, sizeof *built);
    if (state->has_model) {
        host_view view;
        if (!view_make(&view, &state->settings, &state->model.materials, &state->mesh, problem)) {
            return false;
        }
        adopt(&view.scene, built);
        change(state, built); /* copies the materials */
        view_free(&view);
    } else {
        example_stage *stage = memory_new(1, sizeof *stage);
        state->scene->build(stage, state->variant, state->frame);
        example_fit(stage, state->scene, state->settings.width, state->settings.height);
        adopt(&stage->scene, built);
        change(state, built);
        free(stage);
    }
    return true;
}

void window_scene_free(window_scene *built) {
    for (uint32_t i = 0; i < built->scene.object_count; i++) {
        free(built->paints[i].colours);
    }
    free(built->paints);
    free(built->meshes);
    free(built->materials);
    free(built->objects);
}
