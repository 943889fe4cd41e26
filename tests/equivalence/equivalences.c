/* SPDX-License-Identifier: MIT */
/*
 * Draws random scenes in other ways and told otherwise, and compares the pictures: nothing but the library says
 * what is right. `equivalences COUNT FIRST [STRIDE]`. The ways of ways.c, a mesh split in two and a scene that
 * is moved give the same bits. Elsewhere a pixel may differ for a cause, which is looked for where it does:
 *
 * - rounded: by up to two steps of RGB565 and four of RGB888. The contract (contract.h) leaves each of the two
 *   pictures one step or two from the rounded reference, which is the same for both.
 * - beside: by more, where the value lies between those of the nine pixels around, within as much. Corners are
 *   snapped, and attributes with them, so that a jump of the light moves by part of a pixel.
 * - edge: an edge of what shows passes the pixel's centre within EDGE. Then snapping and the fill rule decide
 *   what shows, and from which side it is seen.
 * - tie: another surface shows, and the depths of both are as near as what they are rounded by, TIE_STEPS each,
 *   and what they change by within EDGE. In another order of objects nothing is rounded otherwise: there depths
 *   must be equal.
 *
 * A pixel without a cause is a fault where another surface shows. Where the light of the same surface differs,
 * a frame may have as many pixels as the contract leaves both pictures: one of RGB565 each, and two of RGB888.
 */
#include "equivalence/variants.h"
#include "equivalence/varied_scene.h"
#include "equivalence/ways.h"
#include "glint_extras.h"
#include "reference.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Steps that light may differ by in either picture, and pixels that may differ by more. */
static int most_of(const glint_format *format) {
    return format == &glint_format_rgb888 ? 2 : 1;
}

/* A corner that is cut is rounded twice, by 1/16 and 1/32 of a pixel in x and y. */
#define EDGE (1.5 / 16 * 1.41421356)

/* A depth is off by at most so many of its steps (judge.h). */
#define TIE_STEPS 2

typedef enum cause { ROUNDED, BESIDE, TIE, ON_EDGE, LIGHT, FAULT, CAUSES } cause;

static const char *const cause_names[CAUSES] = {"rounded", "beside", "tie", "edge", "light", "fault"};

typedef struct tally {
    long scenes, pixels, faults;
    long causes[CAUSES];
} tally;

#define KINDS_MAX 16
static tally of_ways[KINDS_MAX], of_variants[KINDS_MAX], of_rooms;
static long reported;

static void report(const varied_scene *s, const char *what, const char *why) {
    if (reported++ < 20)
        printf("seed %lu (%s, %dx%d), %s: %s\n", (unsigned long)s->seed, s->kind, s->width, s->height, what, why);
}

/* Seeds of scenes that once differed. */
static const uint64_t kept_seeds[] = {
    4044, /* mirrored: 1/w of parallel rays passed 2^31 between corners, and light was black */
    8220, /* the same over all of the screen */
};

/* ---- A scene as it is told, and its picture ---- */

typedef struct telling {
    const glint_scene *scene;
    picture image;
    glint_renderer renderer; /* to pick with */
    void *arena;
} telling;

static glint_status open_telling(telling *t, const glint_scene *scene, int width, int height,
                                 const glint_format *format) {
    const picture_options how = {.layers = &glint_layers};
    *t = (telling){.scene = scene, .image = picture_open(width, height, format)};
    return picture_render(&t->image, scene, &how, NULL);
}

static void close_telling(telling *t) {
    free(t->arena);
    picture_close(&t->image);
}

/* Finds what a pixel shows. @return 0 where it shows the background */
static int pick(telling *t, int x, int y, glint_hit *hit) {
    if (!t->arena) {
        glint_config config = picture_config(&t->image, NULL);
        config.arena_size = picture_need(&t->image, t->scene, NULL).one_pass;
        config.arena = t->arena = malloc(config.arena_size);
        if (!t->arena || glint_init(&t->renderer, &config) != GLINT_OK)
            abort();
    }
    const int found = glint_pick(&t->renderer, t->scene, x, y, hit);
    if (found < 0)
        abort();
    return found;
}

/* ---- Surfaces on the screen ---- */

/* A line over the screen: its value at x, y is a x + b y + c. */
typedef struct line {
    double a, b, c;
} line;

static double value_at(const line *l, double x, double y) {
    return l->a * x + l->b * y + l->c;
}

/* A triangle as it is before it is cut and snapped: how far inside of each edge, and of the near plane's, a point lies,
 * pixels; and 1/w, or, of parallel rays, z. */
typedef struct surface {
    line inside[4];
    line depth;
    double z_least, z_most;
    int is_edge_on;
} surface;

/* Scales a line so that its value is a distance: without end where it is the same everywhere. */
static void make_distance(line *l, double sign) {
    const double length = hypot(l->a, l->b);
    if (length > 0)
        *l = (line){l->a * sign / length, l->b * sign / length, l->c * sign / length};
    else
        *l = (line){0, 0, l->c * sign >= 0 ? INFINITY : -INFINITY};
}

/* Finds a triangle's surface from homogeneous coordinates, so that no cut is needed (Olano and Greer, 1997). */
static void find_surface(const telling *t, const glint_hit *hit, surface *to) {
    const glint_camera *const camera = &t->scene->camera;
    const int width = t->image.width, height = t->image.height, is_parallel = camera->projection != NULL;
    const uint16_t *const corners = t->scene->objects[hit->object].mesh->triangles[hit->triangle];
    const double focal = is_parallel
                             ? height * 65536.0 / camera->view_height
                             : height / 2.0 / tan(camera->field_of_view / 65536.0 * 3.14159265358979323846 / 360);
    double v[3][3], z[3];
    *to = (surface){.z_least = INFINITY, .z_most = -INFINITY};
    for (int i = 0; i < 3; i++) {
        const reference_vertex vertex = reference_transform(t->scene, hit->object, corners[i], width, height);
        z[i] = vertex.place[2];
        v[i][2] = is_parallel ? 1 : -z[i];
        v[i][0] = focal * vertex.place[0] + width / 2.0 * v[i][2];
        v[i][1] = height / 2.0 * v[i][2] - focal * vertex.place[1];
        to->z_least = fmin(to->z_least, z[i]);
        to->z_most = fmax(to->z_most, z[i]);
    }
    for (int i = 0; i < 3; i++) {
        const double *const p = v[(i + 1) % 3], *const q = v[(i + 2) % 3];
        to->inside[i] = (line){p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    }
    const double determinant = v[0][0] * to->inside[0].a + v[0][1] * to->inside[0].b + v[0][2] * to->inside[0].c;
    to->is_edge_on = determinant == 0;
    for (int i = 0; i < 3 && !to->is_edge_on; i++) {
        const double weight = (is_parallel ? z[i] : 1) / determinant;
        to->depth.a += weight * to->inside[i].a;
        to->depth.b += weight * to->inside[i].b;
        to->depth.c += weight * to->inside[i].c;
        make_distance(&to->inside[i], determinant > 0 ? 1 : -1);
    }
    const double near_plane = camera->near_plane / 65536.0;
    to->inside[3] = (line){-to->depth.a, -to->depth.b, (is_parallel ? -near_plane : 1 / near_plane) - to->depth.c};
    make_distance(&to->inside[3], 1);
}

/* How far inside a surface a pixel's centre lies; below 0, outside. */
static double find_inside(const surface *of, int x, int y) {
    double least = INFINITY;
    for (int i = 0; i < 4; i++)
        least = fmin(least, value_at(&of->inside[i], x + 0.5, y + 0.5));
    return of->is_edge_on ? 0 : least;
}

/* By how many steps a surface's depth, `depth` here, changes within EDGE. @param range of z in 65533 steps, at least */
static double find_change(const surface *of, int is_parallel, int x, int y, double depth, double range) {
    const double slope = hypot(of->depth.a, of->depth.b);
    return EDGE * slope * (is_parallel ? 65533 / range : depth / value_at(&of->depth, x + 0.5, y + 0.5));
}

/* ---- Pixels that differ ---- */

/* Two pictures: of a scene, and of its variant. */
typedef struct pair {
    telling *plain, *other;
    const variant *by;
} pair;

static int other_column(const pair *p, int x) {
    return p->by->is_mirrored ? p->plain->image.width - 1 - x : x;
}

static int find_steps(const pair *p, int x, int y) {
    int most = 0;
    for (int c = 0; c < picture_channels(p->plain->image.format); c++) {
        const int apart =
            abs(picture_level(&p->plain->image, x, y, c) - picture_level(&p->other->image, other_column(p, x), y, c));
        most = apart > most ? apart : most;
    }
    return most;
}

/* Does each channel of the other picture lie between those of the plain picture around the pixel, or nearly? */
static int is_beside(const pair *p, int x, int y) {
    const picture *const image = &p->plain->image;
    const int room = 2 * most_of(image->format);
    for (int c = 0; c < picture_channels(image->format); c++) {
        const int level = picture_level(&p->other->image, other_column(p, x), y, c);
        int least = level + room + 1, most = -1;
        for (int i = 0; i < 9; i++) {
            const int column = x + i % 3 - 1, row = y + i / 3 - 1;
            if (column < 0 || row < 0 || column >= image->width || row >= image->height)
                continue;
            const int around = picture_level(image, column, row, c);
            least = around < least ? around : least;
            most = around > most ? around : most;
        }
        if (level < least - room || level > most + room)
            return 0;
    }
    return 1;
}

/* Do two pixels show the same: one triangle, or the background? */
static int is_same(const int is[2], const glint_hit hits[2]) {
    return is[0] == is[1] && (!is[0] || (hits[0].object == hits[1].object && hits[0].triangle == hits[1].triangle));
}

/* Finds the cause of other pixels from what shows there, of which `is[i]` tells whether it is a surface. */
static cause judge_surfaces(const pair *p, int x, int y, const int is[2], const glint_hit hits[2]) {
    const int is_parallel = p->plain->scene->camera.projection != NULL;
    surface surfaces[2];
    double inside[2] = {INFINITY, INFINITY};
    for (int i = 0; i < 2; i++)
        if (is[i]) {
            find_surface(p->plain, &hits[i], &surfaces[i]);
            inside[i] = find_inside(&surfaces[i], x, y);
        }
    if (inside[0] < -EDGE || inside[1] < -EDGE)
        return FAULT;
    if (inside[0] < EDGE || inside[1] < EDGE)
        return ON_EDGE;
    if (is_same(is, hits))
        return LIGHT;
    if (!is[0] || !is[1])
        return FAULT;
    const double range = fmax(surfaces[0].z_most, surfaces[1].z_most) - fmin(surfaces[0].z_least, surfaces[1].z_least);
    double room = 2 * TIE_STEPS;
    for (int i = 0; i < 2; i++)
        room += find_change(&surfaces[i], is_parallel, x, y, hits[i].depth, range);
    return abs(hits[0].depth - hits[1].depth) <= room ? TIE : FAULT;
}

static cause judge_pixel(const pair *p, variant_freedom freedom, int x, int y) {
    glint_hit hits[2];
    const int steps = find_steps(p, x, y);
    if (freedom != FREEDOM_TIES && steps <= 2 * most_of(p->plain->image.format))
        return ROUNDED;
    const int is[2] = {pick(p->plain, x, y, &hits[0]), pick(p->other, other_column(p, x), y, &hits[1])};
    if (is[1]) {
        const uint32_t object = hits[1].object;
        hits[1].object = p->by->object_of[object];
        hits[1].triangle += p->by->triangle_of[object];
    }
    if (freedom == FREEDOM_TIES)
        return is[0] && is[1] && hits[0].object != hits[1].object && hits[0].depth == hits[1].depth ? TIE : FAULT;
    if (is_same(is, hits) && is_beside(p, x, y))
        return BESIDE;
    if (freedom == FREEDOM_LIGHT)
        return is_same(is, hits) ? LIGHT : FAULT;
    return judge_surfaces(p, x, y, is, hits);
}

/* ---- Scenes ---- */

/* Judges the pixels of two pictures that differ. @return 0 where one is a fault, or the light of too many differs */
static int judge_pictures(const varied_scene *s, const variant_kind *kind, const pair *p, tally *to) {
    const long most_lights = 2 * most_of(p->plain->image.format);
    long faults = 0, lights = 0;
    for (int y = 0; y < s->height; y++)
        for (int x = 0; x < s->width; x++) {
            if (find_steps(p, x, y) == 0)
                continue;
            const cause why = judge_pixel(p, kind->freedom, x, y);
            char text[80];
            to->causes[why]++;
            lights += why == LIGHT;
            if (why != FAULT && (why != LIGHT || lights <= most_lights))
                continue;
            snprintf(text, sizeof text, "%s at %d, %d by %d steps", cause_names[why], x, y, find_steps(p, x, y));
            if (faults++ == 0)
                report(s, kind->name, text);
        }
    to->pixels += (long)s->width * s->height;
    return faults == 0;
}

/* Formats in which light is told in 5 or 8 bits: where nothing may differ, and in other orders, the scene's own. */
static const glint_format *find_format(const varied_scene *s, variant_freedom freedom) {
    if (freedom == FREEDOM_NONE || freedom == FREEDOM_TIES)
        return s->format;
    return s->seed / 16 % 2 ? &glint_format_rgb888 : &glint_format_rgb565;
}

/* Makes objects opaque and takes fog away, so that a pixel shows one surface. Of textures, that are taken off too, a
 * texel's border is where rounding decides what shows. */
static glint_scene undress(const glint_scene *scene, int keeps_textures) {
    static glint_object objects[VARIANT_OBJECTS_MAX];
    static glint_material materials[VARIANT_OBJECTS_MAX];
    glint_scene bare = *scene;
    for (uint32_t i = 0; i < scene->object_count; i++) {
        materials[i] = *scene->objects[i].material;
        materials[i].blend = GLINT_BLEND_NONE;
        if (!keeps_textures)
            materials[i].texture = NULL;
        objects[i] = scene->objects[i];
        objects[i].material = &materials[i];
    }
    bare.objects = objects;
    bare.fog = NULL;
    return bare;
}

static void check_variant(const varied_scene *s, unsigned which) {
    static variant by;
    const variant_kind *const kind = &variant_kinds[which];
    const glint_format *const format = find_format(s, kind->freedom);
    tally *const to = &of_variants[which];
    const glint_scene scene =
        kind->freedom == FREEDOM_NONE ? s->scene : undress(&s->scene, kind->freedom != FREEDOM_ROUNDING);
    telling plain, other;
    if (!variant_make(&by, kind, &scene, varied_pick(s->seed, 15, 1u << 31)))
        return;
    const glint_status status = open_telling(&plain, &scene, s->width, s->height, format),
                       changed = open_telling(&other, &by.scene, s->width, s->height, format);
    const pair p = {&plain, &other, &by};
    int right = status == changed;
    if (!right)
        report(s, kind->name, glint_strerror(changed));
    else if (kind->freedom == FREEDOM_NONE) {
        right = picture_equal(&plain.image, &other.image);
        if (!right)
            report(s, kind->name, "other pixels");
    } else
        right = judge_pictures(s, kind, &p, to);
    to->scenes++;
    to->faults += !right;
    close_telling(&plain);
    close_telling(&other);
}

static void check_ways(const varied_scene *s, const picture *wanted, const picture_options *how) {
    for (unsigned i = 0; i < way_count; i++) {
        const int right = ways[i].draws_same(wanted, &s->scene, how, varied_pick(s->seed, i, 1u << 31));
        of_ways[i].scenes++;
        of_ways[i].faults += !right;
        if (!right)
            report(s, ways[i].name, "other pixels");
    }
}

/* Does a closed room show no background, so that there are no holes in it? */
static void check_room(const varied_scene *s, const picture_options *how) {
    uint32_t empty = 0;
    picture_options options = *how;
    picture image = picture_open(s->width, s->height, s->format);
    options.overlay = (glint_painter){picture_count_empty, &empty};
    const int right = picture_render(&image, &s->scene, &options, NULL) == GLINT_OK && !empty;
    of_rooms.scenes++;
    of_rooms.faults += !right;
    if (!right)
        report(s, "closed rooms", "holes");
    picture_close(&image);
}

static void check_scene(uint64_t seed) {
    static varied_scene s;
    varied_scene_make(&s, seed);
    const picture_options how = varied_scene_options(&s);
    picture wanted = picture_open(s.width, s.height, s.format);
    const glint_status status = picture_render(&wanted, &s.scene, &how, NULL);
    if (status == GLINT_OK) {
        check_ways(&s, &wanted, &how);
        for (unsigned i = 0; i < variant_kind_count; i++)
            check_variant(&s, i);
        if (s.is_closed)
            check_room(&s, &how);
    } else if (status != GLINT_ERROR_RANGE) {
        of_rooms.faults++;
        report(&s, "any scene", glint_strerror(status));
    }
    picture_close(&wanted);
}

/* @return whether it failed */
static int print_tally(const char *name, const tally *t) {
    printf("%-26s %8ld %11ld", name, t->scenes, t->pixels);
    for (int i = 0; i < CAUSES; i++)
        printf(" %9ld", t->causes[i]);
    printf(" %9ld\n", t->faults);
    return t->faults > 0;
}

int main(int count, char **arguments) {
    const unsigned long scenes = count > 1 ? strtoul(arguments[1], NULL, 10) : 1000;
    const unsigned long first = count > 2 ? strtoul(arguments[2], NULL, 10) : 1;
    const unsigned long stride = count > 3 ? strtoul(arguments[3], NULL, 10) : 1;
    int failed = 0;
    for (size_t i = 0; i < sizeof kept_seeds / sizeof kept_seeds[0]; i++)
        check_scene(kept_seeds[i]);
    for (unsigned long i = 0; i < scenes; i++)
        check_scene(first + i * stride);
    printf("%-26s %8s %11s", "", "scenes", "pixels");
    for (int i = 0; i < CAUSES; i++)
        printf(" %9s", cause_names[i]);
    printf(" %9s\n", "failed");
    for (unsigned i = 0; i < way_count; i++)
        failed += print_tally(ways[i].name, &of_ways[i]);
    for (unsigned i = 0; i < variant_kind_count; i++)
        failed += print_tally(variant_kinds[i].name, &of_variants[i]);
    failed += print_tally("no holes in closed rooms", &of_rooms);
    printf("%d passed, %d failed\n", (int)(way_count + variant_kind_count) + 1 - failed, failed);
    return failed > 0;
}
