/* SPDX-License-Identifier: MIT */
/* Regions: data that is wrong, memory that is short, and a display that fails or is slow. */
#include "picture.h"
#include "region.h"

#include <stdlib.h>
#include <string.h>

static void set_library(region_figures *figures, double value) {
    figures->library[0] = figures->library[1] = value;
}

/* Tiles sent of a scene that is to be refused with `expected`; -1 where it is not. */
static double tiles_sent(const random_scene *s, glint_status expected, size_t arena_size) {
    picture image = picture_open(s->width, s->height, &glint_format_rgb565);
    const picture_options options = {.arena_size = arena_size};
    double sent = picture_render(&image, &s->scene, &options, NULL) == expected ? 0 : -1;
    for (int i = 0; i < s->width * s->height && sent >= 0; i++)
        sent += image.sent[i];
    picture_close(&image);
    return sent < 0 ? 1e6 : sent;
}

static void measure_indices(region_figures *figures) {
    random_scene s;
    double sent = 0;
    for (int corner = 0; corner < 3; corner++) {
        region_sphere(&s, 9, 8);
        s.meshes[0].triangles[s.meshes[0].mesh.triangle_count - 1][corner] =
            (uint16_t)(s.meshes[0].mesh.vertex_count + (corner == 1 ? 0 : 60000));
        for (uint32_t i = 0; i < 3 * s.meshes[0].mesh.triangle_count; i++)
            figures->plain += s.meshes[0].triangles[i / 3][i % 3] >= s.meshes[0].mesh.vertex_count;
        sent += tiles_sent(&s, GLINT_ERROR_INDEX, 0);
    }
    set_library(figures, sent);
}

static void measure_empty(region_figures *figures) {
    random_scene s;
    double sent = 0;
    for (int which = 0; which < 2; which++) {
        region_sphere(&s, 9, 8);
        if (which)
            s.meshes[0].mesh.vertex_count = 0;
        else
            s.meshes[0].mesh.triangle_count = 0;
        sent += tiles_sent(&s, GLINT_ERROR_MESH, 0);
        /* a bounding box begun beyond all numbers and widened by every vertex there is */
        int32_t least = INT32_MAX;
        int32_t most = INT32_MIN;
        for (uint32_t i = 0; i < s.meshes[0].mesh.vertex_count * s.meshes[0].mesh.triangle_count; i++) {
            least = s.meshes[0].positions[0][0];
            most = least;
        }
        figures->plain += least > most;
    }
    set_library(figures, sent);
}

/* ---- Memory -------------------------------------------------------------------------------------------------- */

/* Pixels that differ when triangles beyond the first 64 find no room. */
static double dropped_pixels(const random_scene *full) {
    random_scene s;
    double differing = 0;
    picture all = picture_open(full->width, full->height, &glint_format_rgb888);
    picture some = picture_open(full->width, full->height, &glint_format_rgb888);
    region_sphere(&s, 9, 8);
    picture_render(&all, &s.scene, NULL, NULL);
    s.meshes[0].mesh.triangle_count = 64;
    picture_render(&some, &s.scene, NULL, NULL);
    for (size_t i = 0; i < all.size; i += 3)
        differing += memcmp(all.bytes + i, some.bytes + i, 3) != 0;
    picture_close(&all);
    picture_close(&some);
    return differing;
}

/* Pixels that the smallest arena changes, and those sent with a byte less. */
static void measure_arena(region_figures *figures) {
    random_scene s;
    region_sphere(&s, 9, 8);
    figures->plain = dropped_pixels(&s);
    for (int format = 0; format < 2; format++) {
        const glint_format *const formats[2] = {&glint_format_rgb888, &glint_format_rgb565};
        picture best = picture_open(s.width, s.height, formats[format]);
        picture least = picture_open(s.width, s.height, formats[format]);
        glint_config config = picture_config(&best, NULL);
        glint_need need = {0};
        glint_status status = glint_arena_need(&config, &s.scene, &need);
        picture_options options = {.arena_size = need.least};
        if (status != GLINT_OK || picture_render(&best, &s.scene, NULL, NULL) != GLINT_OK ||
            picture_render(&least, &s.scene, &options, NULL) != GLINT_OK)
            figures->library[format] = 1e6;
        for (size_t i = 0; i < best.size; i++)
            figures->library[format] += best.bytes[i] != least.bytes[i];
        options.arena_size = need.least - 1;
        memset(least.sent, 0, (size_t)s.width * (size_t)s.height);
        figures->library[format] += picture_render(&least, &s.scene, &options, NULL) == GLINT_ERROR_ARENA ? 0 : 1e6;
        for (int i = 0; i < s.width * s.height; i++)
            figures->library[format] += least.sent[i];
        picture_close(&best);
        picture_close(&least);
    }
}

/* ---- Displays ------------------------------------------------------------------------------------------------ */

/* A display that fails at a call, and looks at a tile's pixels again when they are sent. */
typedef struct display {
    int begins, fails_at, after_failure;
    double changed;
    const uint8_t *pixels;
    uint8_t kept[32 * 32 * 2];
} display;

static int begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    display *d = context;
    (void)x;
    (void)y;
    d->after_failure += d->fails_at >= 0 && d->begins > d->fails_at;
    d->pixels = pixels;
    memcpy(d->kept, pixels, stride * (size_t)(height - 1) + (size_t)width * 2);
    return d->begins++ == d->fails_at;
}

static int wait(void *context) {
    display *d = context;
    for (size_t i = 0; i < sizeof d->kept; i++)
        d->changed += d->pixels[i] != d->kept[i];
    return 0;
}

static glint_status show(display *d, const random_scene *s) {
    glint_config config = {.width = (uint16_t)s->width,
                           .height = (uint16_t)s->height,
                           .format = &glint_format_rgb565,
                           .flush = {begin, wait, d}};
    glint_renderer renderer;
    glint_need need;
    glint_status status = glint_arena_need(&config, &s->scene, &need);
    if (status != GLINT_OK)
        return status;
    config.arena = malloc(need.one_pass);
    config.arena_size = need.one_pass;
    status = config.arena ? glint_init(&renderer, &config) : GLINT_ERROR_NULL;
    if (status == GLINT_OK)
        status = glint_render(&renderer, &s->scene);
    free(config.arena);
    return status;
}

static void measure_failing_display(region_figures *figures) {
    random_scene s;
    region_sphere(&s, 9, 8);
    s.width = s.height = 96;
    double sent = 0;
    for (int fails_at = 0; fails_at < 9; fails_at++) {
        display d = {.fails_at = fails_at};
        sent += show(&d, &s) == GLINT_ERROR_FLUSH ? d.after_failure : 1e6;
        figures->plain += 8 - fails_at;
    }
    set_library(figures, sent);
}

/* One buffer for all tiles: bytes that the next tile changes while a tile is being sent. */
static double overwritten(const random_scene *s) {
    double changed = 0;
    picture image = picture_open(s->width, s->height, &glint_format_rgb565);
    picture_render(&image, &s->scene, NULL, NULL);
    for (int y = 0; y < 32; y++) {
        const uint8_t *row = image.bytes + (size_t)y * image.stride;
        for (int x = 0; x < 64; x++)
            changed += row[x] != row[x + 64];
    }
    picture_close(&image);
    return changed;
}

static void measure_slow_display(region_figures *figures) {
    random_scene s;
    display d = {.fails_at = -1};
    region_sphere(&s, 9, 8);
    s.width = s.height = 96;
    figures->plain = overwritten(&s);
    set_library(figures, show(&d, &s) == GLINT_OK && d.begins == 9 ? d.changed : 1e6);
}

const region input_regions[] = {
    {"indices out of range", "no check", "reads beyond the mesh; pixels sent",
     "GLINT_ERROR_INDEX before anything is sent", 3, measure_indices},
    {"meshes without vertices or triangles", "bounding box of nothing", "boxes inside out; pixels sent",
     "GLINT_ERROR_MESH before anything is sent", 2, measure_empty},
    {"arena one byte short", "drops triangles beyond a list of 64", "pixels changed or sent",
     "GLINT_ERROR_ARENA before anything is sent; with the byte, more passes and the same pixels", 200, measure_arena},
    {"flush callback that fails", "result not looked at", "tiles sent after the failure", "GLINT_ERROR_FLUSH at once",
     30, measure_failing_display},
    {"flush callback that is slow", "one buffer, no wait", "bytes changed before they are sent",
     "two buffers, and waits for a tile before its buffer is drawn into", 100, measure_slow_display},
};
const unsigned input_region_count = sizeof input_regions / sizeof input_regions[0];
