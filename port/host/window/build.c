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

/** A dark colour keeps this part of each channel. */
#define DARK 0.2

static void darken(glint_colour *colour) {
    colour->r = number_q16(DARK * number_from_q16(colour->r));
    colour->g = number_q16(DARK * number_from_q16(colour->g));
    colour->b = number_q16(DARK * number_from_q16(colour->b));
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
    if (changes->dark) { /* ambient light meets the diffuse colour too */
        darken(&material->diffuse);
        darken(&material->ambient);
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

static bool has_colours(const glint_mesh *mesh) {
    return mesh->colours != NULL || mesh->colours565 != NULL;
}

/** Plain meshes get colours, others lose theirs. */
static void change_colours(window_scene *built, uint32_t i) {
    glint_mesh *mesh = &built->meshes[i];
    *mesh = *built->objects[i].mesh;
    if (has_colours(mesh)) {
        mesh->colours = NULL;
    } else {
        built->paints[i].colours = colour_mesh(mesh);
        mesh->colours = (const uint8_t(*)[3])built->paints[i].colours;
    }
    mesh->colours565 = NULL;
    built->objects[i].mesh = mesh;
}

/** Finds a mesh in the scene's variants: coloured where it is plain here, or plain. Returns null where none has it. */
static const glint_object *find_twin(const window_state *state, const glint_mesh *mesh, example_stage *stage) {
    for (uint32_t variant = 0; variant < state->scene->variant_count; variant++) {
        state->scene->build(stage, variant, state->frame);
        for (uint32_t i = 0; i < stage->scene.object_count; i++) {
            const glint_object *other = &stage->objects[i];
            if (other->mesh->positions == mesh->positions && other->mesh->triangle_count == mesh->triangle_count &&
                has_colours(other->mesh) != has_colours(mesh)) {
                return other;
            }
        }
    }
    return NULL;
}

/** Gives objects the colours that other variants of the scene have for them. @return whether there are any */
static bool take_colours(const window_state *state, window_scene *built) {
    example_stage *stage = memory_new(1, sizeof *stage);
    bool any = false;
    for (uint32_t i = 0; !state->has_model && i < built->scene.object_count; i++) {
        const glint_object *twin = find_twin(state, built->objects[i].mesh, stage);
        if (twin != NULL) {
            built->objects[i].mesh = twin->mesh;
            built->materials[i].diffuse = twin->material->diffuse;
            built->materials[i].ambient = twin->material->ambient;
            any = true;
        }
    }
    free(stage);
    return any;
}

/* ---- The subject ------------------------------------------------------------------------------------------------ */

/** Returns whether an object is a model's, or in a scene is lit and has height, which a ground has not. */
static bool is_subject(const window_state *state, const glint_object *object) {
    const glint_vector extent = object->mesh->extent;
    const bool is_solid = extent.x > 0 && extent.y > 0 && extent.z > 0;
    return state->has_model || (object->material->model != &glint_model_unlit && is_solid);
}

static void turn_pose(const double turn[3][3], const double middle[3], glint_pose *pose) {
    const glint_pose before = *pose;
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 4; column++) {
            double sum = column == 3 ? middle[row] : 0;
            for (int i = 0; i < 3; i++) {
                sum += turn[i][row] * (number_from_q16(before.m[i][column]) - (column == 3 ? middle[i] : 0));
            }
            pose->m[row][column] = held(sum);
        }
    }
}

/** Turns the subject about its middle. */
static void turn_subject(const window_state *state, window_scene *built) {
    double middle[3] = {0, 0, 0};
    uint32_t count = 0;
    for (uint32_t i = 0; i < built->scene.object_count; i++) {
        if (is_subject(state, &built->objects[i])) {
            double own[3];
            measure(&built->objects[i], own);
            count++;
            for (int axis = 0; axis < 3; axis++) {
                middle[axis] += (own[axis] - middle[axis]) / count;
            }
        }
    }
    for (uint32_t i = 0; i < built->scene.object_count; i++) {
        if (is_subject(state, &built->objects[i])) {
            turn_pose(state->changes.turn, middle, &built->objects[i].pose);
        }
    }
}

/** Half as high as it was, about what the camera looks at. */
static void squash(const double target[3], glint_pose *pose) {
    for (int column = 0; column < 4; column++) {
        const double value = number_from_q16(pose->m[1][column]);
        pose->m[1][column] = held(value / 2 + (column == 3 ? target[1] / 2 : 0));
    }
}

static void change_objects(const window_state *state, window_scene *built) {
    const window_changes *changes = &state->changes;
    for (uint32_t i = 0; i < built->scene.object_count; i++) {
        built->materials[i] = *built->objects[i].material;
        built->objects[i].material = &built->materials[i];
    }
    const bool coloured = changes->colours && take_colours(state, built);
    for (uint32_t i = 0; i < built->scene.object_count; i++) {
        glint_object *object = &built->objects[i];
        change_material(changes, &built->materials[i]);
        object->evaluation = changes->has_evaluation ? changes->evaluation : object->evaluation;
        if (changes->colours && !coloured && is_subject(state, object)) {
            change_colours(built, i);
        }
        if (changes->passed > 0 && is_subject(state, object)) {
            built->materials[i].blend = window_blends[changes->blend];
            built->materials[i].opacity = GLINT_ONE - changes->passed * (GLINT_ONE / 4);
        }
        if (changes->squashed) {
            squash(built->target, &object->pose);
        }
    }
    if (changes->has_turn) {
        turn_subject(state, built);
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
    if (scene->fog != NULL) {
        built->fog = *scene->fog;
        built->scene.fog = &built->fog;
    }
    built->scene.objects = built->objects;
    built->scene.lights = built->lights;
}

/** Adds fog of the background's colour, which begins in front of what the camera looks at, and ends behind it. */
static void add_fog(const window_changes *changes, window_scene *built) {
    const double angle = number_from_q16(built->scene.camera.field_of_view) * pi / 360;
    const double distance = changes->zoom * built->reach / tan(angle);
    const double half = fmin(built->reach, 0.75 * distance);
    built->fog = (glint_fog){.type = changes->fog, .to_background = 1};
    built->fog.start = held(distance - half);
    built->fog.end = held(distance + half);
    built->scene.fog = &built->fog;
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
    change_objects(state, built);
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
    if (changes->fog != NULL) {
        add_fog(changes, built);
    }
    for (uint32_t i = 0; changes->shows_lights && i < built->scene.light_count; i++) {
        show_light(&built->scene.lights[i], built);
    }
}

bool window_build(const window_state *state, window_scene *built, host_problem *problem) {
    memset(built, 0, sizeof *built);
    built->samples = state->settings.samples;
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
        built->samples = state->settings.samples_given ? built->samples : stage->samples;
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
