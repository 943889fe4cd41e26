/* SPDX-License-Identifier: MIT */
#include "plain_raster.h"

#include "reference.h"

#include <math.h>
#include <stdlib.h>

typedef struct point {
    double x, y, w;
} point;

static double snap(double value, unsigned flags) {
    if (flags & PLAIN_PIXELS)
        return floor(value + 0.5);
    double steps = floor(value * 16 + 0.5);
    if (flags & PLAIN_WRAP)
        steps -= 65536 * floor((steps + 32768) / 65536);
    return steps / 16;
}

static double edge(const point *a, const point *b, double x, double y) {
    return (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
}

/* On an edge, the top-left rule decides, or any edge counts. Corners clockwise on the screen. */
static int is_inside(const point *a, const point *b, double x, double y, unsigned flags) {
    double value = edge(a, b, x, y);
    int top_left = b->y < a->y || (b->y == a->y && b->x > a->x);
    return value > 0 || (value == 0 && ((flags & PLAIN_INCLUSIVE) || top_left));
}

static void draw(const random_scene *s, const point corners[3], unsigned flags, int mirrored, unsigned *times) {
    const point *a = &corners[0];
    const point *b = &corners[1];
    const point *c = &corners[2];
    double area = edge(a, b, c->x, c->y);
    int front = (mirrored && !(flags & PLAIN_WINDING)) ? area > 0 : area < 0;
    if ((area == 0 && !(flags & PLAIN_INCLUSIVE)) ||
        (area != 0 && !front && !(s->meshes[0].mesh.flags & GLINT_MESH_DOUBLE_SIDED)))
        return;
    if (area < 0) {
        b = &corners[2];
        c = &corners[1];
    }
    for (int y = 0; y < s->height; y++) {
        for (int x = 0; x < s->width; x++)
            times[y * s->width + x] += is_inside(a, b, x + 0.5, y + 0.5, flags) &&
                                       is_inside(b, c, x + 0.5, y + 0.5, flags) &&
                                       is_inside(c, a, x + 0.5, y + 0.5, flags);
    }
}

static void draw_all(const random_scene *s, unsigned flags, unsigned *times) {
    const glint_mesh *mesh = s->objects[0].mesh;
    const glint_pose *p = &s->objects[0].pose; /* only scales mirror here: the sign is that of the diagonal */
    int mirrored = (p->m[0][0] < 0) != ((p->m[1][1] < 0) != (p->m[2][2] < 0));
    for (uint32_t triangle = 0; triangle < mesh->triangle_count; triangle++) {
        point corners[3];
        int behind = 0;
        for (int i = 0; i < 3; i++) {
            reference_vertex v = reference_transform(&s->scene, 0, mesh->triangles[triangle][i], s->width, s->height);
            corners[i] = (point){snap(v.x, flags), snap(v.y, flags), v.w};
            behind |= v.w <= 0;
        }
        if (!behind || (flags & PLAIN_UNCLIPPED))
            draw(s, corners, flags, mirrored, times);
    }
}

plain_coverage plain_cover(const random_scene *s, unsigned flags) {
    const size_t count = (size_t)s->width * (size_t)s->height;
    unsigned *times = calloc(count, sizeof *times);
    reference_image image = {s->width, s->height, malloc(count * sizeof *image.pixels)};
    plain_coverage result = {0, 0, 0};
    if (times == NULL || image.pixels == NULL)
        abort();
    draw_all(s, flags, times);
    reference_render(&image, &s->scene, NULL);
    for (size_t i = 0; i < count; i++) {
        result.drawn += times[i];
        result.wrong += (times[i] > 0) != image.pixels[i].covered;
        result.twice += times[i] > 1 ? (long)times[i] - 1 : 0;
    }
    free(times);
    free(image.pixels);
    return result;
}
