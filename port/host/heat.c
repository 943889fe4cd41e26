/* SPDX-License-Identifier: MIT */
#include "heat.h"

#include "library_geometry.h"
#include "memory.h"
#include "picture.h"
#include "reference.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Steps from which on a pixel counts as more than rounded: half a step, and what fixed point adds to it. */
#define ROUNDED 0.55

/** A cosine so near that of a jump of the light is told by rounding: two unit vectors, each off by 2.3 / 2^15. */
#define GATE (4.6 / 32768)

/** Surfaces nearer to each other than so many depth steps may come out in either order. */
#define CLOSE_STEPS 2

/* ---- The reference ---------------------------------------------------------------------------------------------- */

/** The scene without what is hidden, which the reference knows nothing of. The caller frees the objects. */
static glint_scene without_hidden(const glint_scene *scene, glint_object **objects) {
    glint_scene seen = *scene;
    *objects = memory_new(scene->object_count, sizeof **objects);
    seen.object_count = 0;
    for (uint32_t i = 0; i < scene->object_count; i++) {
        if (!scene->objects[i].hidden) {
            (*objects)[seen.object_count++] = scene->objects[i];
        }
    }
    seen.objects = *objects;
    return seen;
}

/**
 * Draws the reference with the library's own snapped vertices; of a scene of too many objects, with its own.
 * @return the library's depth steps per 1/w; 0 of such a scene
 */
static double draw_reference(const glint_scene *scene, const host_settings *settings, const framebuffer *shown,
                             reference_pixel *pixels) {
    const reference_image image = {(int)shown->width, (int)shown->height, pixels};
    const glint_config config = {.width = (uint16_t)shown->width,
                                 .height = (uint16_t)shown->height,
                                 .tile_width = settings->tile_width,
                                 .tile_height = settings->tile_height,
                                 .format = shown->format->format};
    library_geometry geometry;
    glint_object *objects;
    const glint_scene seen = without_hidden(scene, &objects);
    const bool known = library_geometry_open(&geometry, &config, &seen) == GLINT_OK;
    reference_render(&image, &seen, known ? (const reference_position *const *)geometry.positions : NULL);
    const double depth_scale = known ? geometry.depth_scale : 0;
    library_geometry_close(&geometry);
    free(objects);
    return depth_scale;
}

/* ---- Distances -------------------------------------------------------------------------------------------------- */

/** What the reference's pixel is in a channel's levels, not rounded. */
static double wanted_level(const reference_pixel *pixel, const picture *image, double gamma, int channel) {
    const double *colour = pixel->colour;
    const double luma = 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2];
    const double value = picture_channels(image->format) == 1 ? luma : colour[channel];
    return picture_level_max(image->format, channel) * (gamma < 1 || gamma > 1 ? pow(value, 1 / gamma) : value);
}

static double distance(const reference_pixel *pixel, const picture *image, double gamma, int x, int y) {
    double most = 0;
    for (int channel = 0; channel < picture_channels(image->format); channel++) {
        const double stored = picture_level(image, x, y, channel) + 0.5 - picture_threshold(image->format, x, y);
        most = fmax(most, fabs(stored - wanted_level(pixel, image, gamma, channel)));
    }
    return most;
}

/** Whether nothing that is rounded decides on a pixel as a whole. */
static bool is_judged(const reference_pixel *pixel, double depth_scale) {
    const bool close = (pixel->nearest - pixel->second) * depth_scale < CLOSE_STEPS && depth_scale > 0;
    return !pixel->uncertain && (!pixel->covered || (pixel->grazing >= GATE && !close));
}

static void note(heat_map *map, uint32_t x, uint32_t y, double steps) {
    map->steps[(size_t)y * map->width + x] = steps;
    map->judged += steps >= 0;
    map->over_half += steps > ROUNDED;
    map->over_one += steps > 1;
    if (steps > map->worst) {
        map->worst = steps;
        map->worst_x = x;
        map->worst_y = y;
    }
}

void heat_find(heat_map *map, const glint_scene *scene, const host_settings *settings, const framebuffer *shown) {
    const size_t count = (size_t)shown->width * shown->height;
    reference_pixel *pixels = memory_new(count, sizeof *pixels);
    const picture image = {.width = (int)shown->width,
                           .height = (int)shown->height,
                           .format = settings->dither ? shown->format->dithered : shown->format->format,
                           .stride = shown->row_bytes,
                           .bytes = shown->rows};
    memset(map, 0, sizeof *map);
    map->width = shown->width;
    map->height = shown->height;
    map->steps = memory_new(count, sizeof *map->steps);
    const double depth_scale = draw_reference(scene, settings, shown, pixels);
    for (uint32_t y = 0; y < map->height; y++) {
        for (uint32_t x = 0; x < map->width; x++) {
            const reference_pixel *pixel = &pixels[(size_t)y * map->width + x];
            note(map, x, y,
                 !is_judged(pixel, depth_scale) ? -1 : distance(pixel, &image, settings->gamma, (int)x, (int)y));
        }
    }
    free(pixels);
}

void heat_free(heat_map *map) {
    free(map->steps);
    memset(map, 0, sizeof *map);
}

/* ---- Colours ---------------------------------------------------------------------------------------------------- */

void heat_colour(double steps, uint8_t colour[3]) {
    static const struct {
        double steps;
        uint8_t colour[3];
    } stops[] = {{0, {0, 0, 0}},       {0.5, {16, 28, 70}}, {0.6, {40, 170, 90}}, {1, {240, 220, 60}},
                 {1.5, {240, 60, 30}}, {2, {170, 0, 40}},   {3, {255, 255, 255}}};
    static const uint8_t unjudged[3] = {70, 70, 70};
    const size_t last = sizeof stops / sizeof stops[0] - 1;
    size_t stop = 1;
    while (stop < last && stops[stop].steps < steps) {
        stop++;
    }
    const double part = fmin(1, (steps - stops[stop - 1].steps) / (stops[stop].steps - stops[stop - 1].steps));
    for (int c = 0; c < 3; c++) {
        const double from = stops[stop - 1].colour[c];
        colour[c] = steps < 0 ? unjudged[c] : (uint8_t)lround(from + part * (stops[stop].colour[c] - from));
    }
}

uint8_t *heat_picture(const heat_map *map) {
    const size_t count = (size_t)map->width * map->height;
    uint8_t *colours = memory_new(count, 3);
    for (size_t i = 0; i < count; i++) {
        heat_colour(map->steps[i], colours + 3 * i);
    }
    return colours;
}
