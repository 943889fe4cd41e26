/* SPDX-License-Identifier: MIT */
#include "lighting.h"

#include "glint_extras.h"

#include <math.h>

double reference_normalise(double v[3]) {
    double length = sqrt(reference_dot(v, v));
    for (int axis = 0; axis < 3 && length > 0; axis++)
        v[axis] /= length;
    return length;
}

void reference_to_camera(const glint_camera *camera, const double world[3], double result[3]) {
    for (int axis = 0; axis < 3; axis++) {
        result[axis] = 0;
        for (int row = 0; row < 3; row++)
            result[axis] += reference_real(camera->pose.m[row][axis]) * world[row];
    }
}

/* What an attribute of a layout holds, of element `index`. */
static const void *element_of(const glint_mesh_attribute *attribute, uint32_t index, size_t size) {
    return (const char *)attribute->data + (attribute->stride ? attribute->stride : size) * index;
}

/* Two numbers of an octahedron, from -1 to 1 (Cigolle et al., 2014). */
static void unfold_octahedron(double x, double y, double normal[3]) {
    x = x < -1 ? -1 : x;
    y = y < -1 ? -1 : y;
    normal[2] = 1 - fabs(x) - fabs(y);
    normal[0] = normal[2] < 0 ? (1 - fabs(y)) * (x < 0 ? -1 : 1) : x;
    normal[1] = normal[2] < 0 ? (1 - fabs(x)) * (y < 0 ? -1 : 1) : y;
}

static void three_of(const glint_mesh_attribute *attribute, uint32_t index, double to[3]) {
    const int is_small = attribute->type == &glint_attribute_int8;
    const int16_t *const words = element_of(attribute, index, 6);
    const int8_t *const bytes = element_of(attribute, index, 3);
    for (int axis = 0; axis < 3; axis++)
        to[axis] = is_small ? bytes[axis] / 128.0 : words[axis] / 32768.0;
}

void reference_mesh_position(const glint_mesh *mesh, uint32_t index, double extents[3]) {
    if (!mesh->positions) {
        three_of(&mesh->layout->positions, index, extents);
        return;
    }
    for (int axis = 0; axis < 3; axis++)
        extents[axis] = mesh->positions[index][axis] / 32768.0;
}

void reference_mesh_normal(const glint_mesh *mesh, uint32_t index, double normal[3]) {
    if (mesh->normals) {
        for (int axis = 0; axis < 3; axis++)
            normal[axis] = mesh->normals[index][axis];
        return;
    }
    const glint_mesh_attribute *const from = &mesh->layout->normals;
    if (from->type == &glint_attribute_octahedral8) {
        const int8_t *code = element_of(from, index, 2);
        unfold_octahedron(code[0] / 127.0, code[1] / 127.0, normal);
    } else if (from->type == &glint_attribute_octahedral16) {
        const int16_t *code = element_of(from, index, 4);
        unfold_octahedron(code[0] / 32767.0, code[1] / 32767.0, normal);
    } else {
        three_of(from, index, normal);
    }
}

void reference_mesh_corners(const glint_mesh *mesh, uint32_t triangle, uint32_t corners[3]) {
    for (int i = 0; i < 3; i++) {
        if (mesh->triangles)
            corners[i] = mesh->triangles[triangle][i];
        else if (mesh->layout->triangles.type == &glint_attribute_uint8)
            corners[i] = ((const uint8_t *)element_of(&mesh->layout->triangles, triangle, 3))[i];
        else
            corners[i] = ((const uint16_t *)element_of(&mesh->layout->triangles, triangle, 6))[i];
    }
}

void reference_mesh_colour(const glint_mesh *mesh, uint32_t index, double colour[3]) {
    const uint8_t *levels = mesh->colours ? mesh->colours[index] : NULL;
    const uint16_t *packed = mesh->colours565 ? mesh->colours565 + index : NULL;
    if (!levels && !packed && mesh->layout && mesh->layout->colours.type) {
        const glint_mesh_attribute *const from = &mesh->layout->colours;
        if (from->type == &glint_attribute_rgb888)
            levels = element_of(from, index, 3);
        else
            packed = element_of(from, index, 2);
    }
    for (int channel = 0; channel < 3; channel++)
        colour[channel] = levels ? levels[channel] / 255.0 : 1;
    if (packed) {
        uint16_t word = *packed;
        colour[0] = (word >> 11) / 31.0;
        colour[1] = (word >> 5 & 63) / 63.0;
        colour[2] = (word & 31) / 31.0;
    }
}

/* ---- Lights -------------------------------------------------------------------------------------------------- */

static int has_position(const glint_light *light) {
    return light->type == &glint_light_point || light->type == &glint_light_spot;
}

void reference_prepare_lights(reference_lights *lights, const glint_scene *scene, int height) {
    const glint_camera *camera = &scene->camera;
    const double half_angle = reference_real(camera->field_of_view) * 3.14159265358979323846 / 360;
    lights->is_parallel = camera->projection != NULL;
    lights->pixel = (lights->is_parallel ? reference_real(camera->view_height) : 2 * tan(half_angle)) / height;
    for (uint32_t index = 0; index < scene->light_count; index++) {
        const glint_light *light = &scene->lights[index];
        double position[3] = {reference_real(light->position.x), reference_real(light->position.y),
                              reference_real(light->position.z)};
        const double direction[3] = {reference_real(light->direction.x), reference_real(light->direction.y),
                                     reference_real(light->direction.z)};
        for (int row = 0; row < 3; row++)
            position[row] -= reference_real(camera->pose.m[row][3]);
        reference_to_camera(camera, position, lights->position[index]);
        reference_to_camera(camera, direction, lights->direction[index]);
        reference_normalise(lights->direction[index]);
    }
}

/* How much of a spot's light falls in the direction of a point: t^2 (3 - 2 t). */
static double cone(const glint_light *light, const double direction[3], const double towards[3], double *grazing) {
    const double degree = 3.14159265358979323846 / 180;
    double cosine = -reference_dot(direction, towards);
    double inner = cos(reference_real(light->inner) * degree);
    double outer = cos(reference_real(light->outer) * degree);
    if (light->inner == light->outer)
        *grazing = fmin(*grazing, fabs(cosine - outer));
    if (cosine >= inner)
        return 1;
    if (cosine <= outer)
        return 0;
    double t = (cosine - outer) / (inner - outer);
    return t * t * (3 - 2 * t);
}

/*
 * Parts of the way to the eye: a light about as near as the 1/32768 below which it is to add nothing. And pixels: the
 * way to a light is told in steps of 2^-13 of one, at vertices and facets of up to 2^-11. From one pixel on a
 * fragment's has a direction of 13 bits: half a step of these, halved by H, changes a highlight of p = 1024, whose
 * slope is 0.61 sqrt(p), by 0.15 of 255 levels.
 */
#define TOUCHING (1.0 / 8192)
#define TOUCHING_PIXELS 1

static int touches(const reference_lights *lights, const double place[3], double distance) {
    const double pixel = lights->pixel * (lights->is_parallel ? 1 : -place[2]);
    return distance < TOUCHING * sqrt(reference_dot(place, place)) || distance < TOUCHING_PIXELS * pixel;
}

void reference_find_way(const glint_light *light, const reference_lights *lights, uint32_t index, const double place[3],
                        double way[3]) {
    for (int axis = 0; axis < 3; axis++)
        way[axis] = has_position(light) ? lights->position[index][axis] - place[axis] : -lights->direction[index][axis];
}

/* Direction to a light, unit. @return how much of it arrives. */
static double illuminate(const glint_light *light, const reference_lights *lights, uint32_t index,
                         const double place[3], double towards[3], double *grazing) {
    reference_find_way(light, lights, index, place, towards);
    double distance = reference_normalise(towards);
    if (!has_position(light))
        return 1;
    if (touches(lights, place, distance))
        *grazing = 0;
    if (distance == 0)
        return 0;
    double strength =
        1 / (1 + reference_real(light->linear) * distance + reference_real(light->quadratic) * distance * distance);
    if (light->type == &glint_light_spot)
        strength *= cone(light, lights->direction[index], towards, grazing);
    return strength;
}

/* ---- Materials ----------------------------------------------------------------------------------------------- */

/* Cosine whose power a highlight is: of Phong's mirrored light R = 2 (N.L) N - L, or of Blinn's half vector. */
static double specular_cosine(const glint_material *material, const double normal[3], const double towards[3],
                              const double view[3]) {
    double other[3];
    if (material->model == &glint_model_phong) {
        double twice = 2 * reference_dot(normal, towards);
        for (int axis = 0; axis < 3; axis++)
            other[axis] = twice * normal[axis] - towards[axis];
        return reference_dot(other, view);
    }
    for (int axis = 0; axis < 3; axis++)
        other[axis] = towards[axis] + view[axis];
    reference_normalise(other);
    return reference_dot(normal, other);
}

static void product(const glint_colour *a, const glint_colour *b, double result[3]) {
    result[0] = reference_real(a->r) * reference_real(b->r);
    result[1] = reference_real(a->g) * reference_real(b->g);
    result[2] = reference_real(a->b) * reference_real(b->b);
}

/* Adds one light's diffuse and specular part. */
static void add_light(const glint_light *light, const glint_material *material, const reference_surface *surface,
                      const double towards[3], const double view[3], double strength, reference_light *result) {
    const int has_highlight = material->model == &glint_model_phong || material->model == &glint_model_blinn_phong;
    const int gated = has_highlight && !(material->flags & GLINT_MATERIAL_SPECULAR_UNGATED);
    double n_dot_l = reference_dot(surface->normal, towards);
    double shine = 0;
    double diffuse[3];
    double specular[3];
    product(&light->diffuse, &material->diffuse, diffuse);
    product(&light->specular, &material->specular, specular);
    if (gated)
        result->grazing = fmin(result->grazing, fabs(n_dot_l));
    if (has_highlight && (n_dot_l > 0 || !gated)) {
        const double cosine = specular_cosine(material, surface->normal, towards, view);
        shine = pow(fmax(cosine, 0), reference_real(material->shininess));
        if (material->shininess > 0 && material->shininess < GLINT_ONE) /* R turns twice as fast as N */
            result->grazing = fmin(result->grazing, fabs(cosine) / 2);
    }
    for (int channel = 0; channel < 3; channel++)
        result->colour[channel] +=
            strength * (diffuse[channel] * surface->colour[channel] * fmax(n_dot_l, 0) + specular[channel] * shine);
}

static void find_view(const glint_scene *scene, const double place[3], double view[3]) {
    for (int axis = 0; axis < 3; axis++)
        view[axis] = scene->viewer == GLINT_VIEWER_LOCAL && !scene->camera.projection ? -place[axis] : axis == 2;
    reference_normalise(view);
}

static reference_light light_all(const glint_scene *scene, const reference_lights *lights,
                                 const glint_material *material, const reference_surface *surface) {
    reference_light result = {{0, 0, 0}, 1};
    double view[3];
    double ambient[3];
    find_view(scene, surface->place, view);
    for (uint32_t index = 0; index < scene->light_count; index++) {
        const glint_light *light = &scene->lights[index];
        double towards[3];
        double strength = illuminate(light, lights, index, surface->place, towards, &result.grazing);
        add_light(light, material, surface, towards, view, strength, &result);
    }
    product(&material->ambient, &scene->ambient, ambient);
    for (int channel = 0; channel < 3; channel++) {
        double base = ambient[channel] * surface->colour[channel];
        if (material->flags & GLINT_MATERIAL_MAX_WITH_AMBIENT)
            result.colour[channel] = fmax(result.colour[channel], base);
        else
            result.colour[channel] += base;
    }
    return result;
}

reference_light reference_shade(const glint_scene *scene, const reference_lights *lights,
                                const glint_material *material, const reference_surface *surface) {
    const double paint[3] = {reference_real(material->diffuse.r), reference_real(material->diffuse.g),
                             reference_real(material->diffuse.b)};
    reference_surface local = *surface;
    reference_light result = {{0, 0, 0}, 1};
    reference_normalise(local.normal);
    if (material->model != &glint_model_unlit)
        result = light_all(scene, lights, material, &local);
    for (int channel = 0; channel < 3; channel++) {
        if (material->model == &glint_model_unlit)
            result.colour[channel] = paint[channel] * surface->colour[channel];
        result.colour[channel] = fmin(result.colour[channel], 1);
    }
    return result;
}
