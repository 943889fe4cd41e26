/* SPDX-License-Identifier: MIT */
#include "measure.h"

#include "basics.h"
#include "judge.h"
#include "library_geometry.h"
#include "picture.h"
#include "reference.h"

#include <math.h>
#include <stdlib.h>

static double wanted_level(const reference_pixel *pixel, const glint_format *format, int channel) {
    const double *colour = pixel->colour;
    const double value =
        picture_channels(format) == 1 ? 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2] : colour[channel];
    return value * picture_level_max(format, channel);
}

/**
 * Leaves out the pixels that rounding decides as a whole, as the suites' judge does: beside edges that are clipped,
 * where two surfaces tie in depth, and where a light just reaches the surface.
 */
static float measure_pixel(const picture *image, const reference_pixel *pixel, double depth_scale, int x, int y,
                           measured_errors *sums) {
    const bool is_close = pixel->covered && (pixel->nearest - pixel->second) * depth_scale < JUDGE_CLOSE_STEPS;
    const bool is_gated = pixel->covered && pixel->grazing < JUDGE_GATE;
    const int is_counted = pixel->covered && !pixel->uncertain;
    const double threshold = picture_threshold(image->format, x, y);
    double largest = 0;
    for (int channel = 0; channel < picture_channels(image->format); channel++) {
        const double wanted = wanted_level(pixel, image->format, channel);
        const int stored = picture_level(image, x, y, channel);
        const double relative = (stored - wanted) / picture_level_max(image->format, channel);
        largest = fmax(largest, fabs(stored + 0.5 - threshold - wanted));
        sums->squares += is_counted ? relative * relative : 0;
        sums->samples += is_counted;
    }
    if (pixel->uncertain || is_close || is_gated) {
        return 0;
    }
    sums->worst = is_counted ? fmax(sums->worst, largest) : sums->worst;
    return (float)largest;
}

static float *measure_picture(const picture *image, const reference_image *reference, double depth_scale,
                              measured_errors *sums) {
    float *errors = memory_new((size_t)image->width * (size_t)image->height, sizeof *errors);
    *sums = (measured_errors){0, 0, 0};
    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++) {
            const int i = y * image->width + x;
            errors[i] = measure_pixel(image, &reference->pixels[i], depth_scale, x, y, sums);
        }
    }
    return errors;
}

/** Returns whether the reference draws a scene as it is: opaque, without fog, with one sample a pixel. */
static bool is_plain(const glint_scene *scene, const host_settings *settings) {
    bool is_opaque = true;
    for (uint32_t i = 0; i < scene->object_count; i++) {
        is_opaque = is_opaque && scene->objects[i].material->blend == GLINT_BLEND_NONE;
    }
    return is_opaque && scene->fog == NULL && settings->samples == NULL;
}

/** The objects, lit at each pixel. */
static glint_object *objects_exactly(const glint_scene *scene) {
    glint_object *objects = memory_new(scene->object_count, sizeof *objects);
    for (uint32_t i = 0; i < scene->object_count; i++) {
        objects[i] = scene->objects[i];
        objects[i].evaluation = NULL;
    }
    return objects;
}

glint_config measure_configuration(const host_settings *settings) {
    const glint_config config = {.width = settings->width,
                                 .height = settings->height,
                                 .tile_width = settings->tile_width,
                                 .tile_height = settings->tile_height,
                                 .format = settings->dither ? settings->format->dithered : settings->format->format};
    return config;
}

float *measure_errors(const glint_scene *scene, const host_settings *settings, const framebuffer *target, int same,
                      measured_errors *sums) {
    const glint_config config = measure_configuration(settings);
    const picture image = {.width = config.width,
                           .height = config.height,
                           .format = config.format,
                           .stride = target->row_bytes,
                           .size = target->row_bytes * target->height,
                           .bytes = target->rows};
    if (!is_plain(scene, settings)) {
        return NULL;
    }
    library_geometry geometry;
    if (library_geometry_open(&geometry, &config, scene) != GLINT_OK) {
        library_geometry_close(&geometry);
        return NULL;
    }
    glint_object *objects = objects_exactly(scene);
    glint_scene exact = *scene;
    exact.objects = objects;
    exact.viewer = GLINT_VIEWER_LOCAL;
    const reference_image reference = {
        image.width, image.height, memory_new((size_t)image.width * (size_t)image.height, sizeof *reference.pixels)};
    reference_render(&reference, same ? scene : &exact, (const reference_position *const *)geometry.positions);
    float *errors = measure_picture(&image, &reference, geometry.depth_scale, sums);
    free(reference.pixels);
    free(objects);
    library_geometry_close(&geometry);
    return errors;
}
