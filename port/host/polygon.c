/* SPDX-License-Identifier: MIT */
/**
 * @file polygon.c
 * Polygons into triangles: a fan, or ear clipping (Meisters, 1975) in the plane that shows the polygon largest.
 */
#include "mesh.h"

#include "basics.h"

#include <math.h>
#include <stdlib.h>

/** Ear clipping takes the square of the number of corners, the cube at worst. */
#define EAR_CORNERS_MAX 1024

/** Most corners to look at for all polygons of a mesh, which takes some seconds. */
#define CLIP_STEPS_MAX 1000000000u

typedef struct flat_point {
    double x, y;
} flat_point;

typedef struct polygon_ring {
    const mesh_corner *corners;
    flat_point *points; /* by corner, counter-clockwise as a whole */
    size_t *left;       /* corners not yet clipped */
    size_t count;
} polygon_ring;

/** Area vector of a polygon (Newell): twice its area long. */
static void area_vector(const host_mesh *mesh, const mesh_corner *corners, size_t count, double area[3]) {
    area[0] = area[1] = area[2] = 0;
    for (size_t i = 0; i < count; i++) {
        const double *p = mesh->positions[corners[i].position];
        const double *q = mesh->positions[corners[(i + 1) % count].position];
        for (int axis = 0; axis < 3; axis++) {
            const int j = (axis + 1) % 3;
            const int k = (axis + 2) % 3;
            area[axis] += (p[j] - q[j]) * (p[k] + q[k]);
        }
    }
}

/** Drops the axis along which the polygon is seen largest. */
static void flatten(const host_mesh *mesh, const mesh_corner *corners, size_t count, flat_point *points) {
    double area[3];
    area_vector(mesh, corners, count, area);
    int axis = fabs(area[1]) > fabs(area[0]) ? 1 : 0;
    axis = fabs(area[2]) > fabs(area[axis]) ? 2 : axis;
    const int first = (axis + (area[axis] < 0 ? 2 : 1)) % 3;
    const int second = (axis + (area[axis] < 0 ? 1 : 2)) % 3;
    for (size_t i = 0; i < count; i++) {
        points[i].x = mesh->positions[corners[i].position][first];
        points[i].y = mesh->positions[corners[i].position][second];
    }
}

/** Above 0 when a, b, c turn counter-clockwise. */
static double turn(flat_point a, flat_point b, flat_point c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static int is_convex(const flat_point *points, size_t count) {
    for (size_t i = 0; i < count; i++) {
        if (turn(points[i], points[(i + 1) % count], points[(i + 2) % count]) < 0) {
            return 0;
        }
    }
    return 1;
}

/** Says whether a polygon goes on nearly straight at a corner: within a millionth of the longer of its edges there. */
static int is_straight(const flat_point *points, size_t count, size_t at) {
    const flat_point a = points[(at + count - 1) % count];
    const flat_point b = points[at % count];
    const flat_point c = points[(at + 1) % count];
    const double first = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
    const double second = (c.x - b.x) * (c.x - b.x) + (c.y - b.y) * (c.y - b.y);
    return !(turn(a, b, c) > 1e-6 * fmax(first, second));
}

/** Finds the first corner from which a fan has no triangle without area, beside which pixels would gape; or `count`. */
static size_t find_hub(const flat_point *points, size_t count) {
    size_t hub = 0;
    while (hub < count && (is_straight(points, count, hub + 1) || is_straight(points, count, hub + count - 1))) {
        hub++;
    }
    return hub;
}

static int same_point(flat_point a, flat_point b) {
    return !(a.x < b.x || a.x > b.x || a.y < b.y || a.y > b.y);
}

/** Says whether the corner at place `at` can be cut off: it turns left, and no other corner lies in its triangle. */
static int is_ear(const polygon_ring *ring, size_t at) {
    const flat_point a = ring->points[ring->left[(at + ring->count - 1) % ring->count]];
    const flat_point b = ring->points[ring->left[at]];
    const flat_point c = ring->points[ring->left[(at + 1) % ring->count]];
    if (turn(a, b, c) <= 0) {
        return 0;
    }
    for (size_t i = 0; i < ring->count; i++) {
        const flat_point p = ring->points[ring->left[i]];
        if (!same_point(p, a) && !same_point(p, b) && !same_point(p, c) && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
            turn(c, a, p) >= 0) {
            return 0;
        }
    }
    return 1;
}

static void clip_corner(host_mesh *mesh, polygon_ring *ring, size_t at) {
    mesh_add_triangle(mesh, ring->corners[ring->left[(at + ring->count - 1) % ring->count]],
                      ring->corners[ring->left[at]], ring->corners[ring->left[(at + 1) % ring->count]]);
    ring->count--;
    for (size_t i = at; i < ring->count; i++) {
        ring->left[i] = ring->left[i + 1];
    }
}

static void clip_ears(host_mesh *mesh, polygon_ring *ring) {
    for (size_t i = 0; i < ring->count; i++) {
        ring->left[i] = i;
    }
    size_t at = 0;
    while (ring->count >= 3 && mesh->clip_steps < CLIP_STEPS_MAX) {
        size_t tried = 0;
        while (tried < ring->count && !is_ear(ring, at)) {
            at = (at + 1) % ring->count;
            tried++;
        }
        mesh->clip_steps += tried * ring->count;
        /* A ring that crosses itself may have no ear: cutting any corner still ends, with all corners used. */
        clip_corner(mesh, ring, at);
        at %= ring->count;
    }
}

bool mesh_add_polygon(host_mesh *mesh, const mesh_corner *corners, size_t count) {
    flat_point *points = NULL;
    size_t hub = 0;
    if (count > 3 && count <= EAR_CORNERS_MAX) {
        points = memory_new(count, sizeof *points);
        flatten(mesh, corners, count, points);
        hub = is_convex(points, count) ? find_hub(points, count) : count;
    }
    if (hub < count) {
        for (size_t i = 1; i + 1 < count; i++) {
            mesh_add_triangle(mesh, corners[hub], corners[(hub + i) % count], corners[(hub + i + 1) % count]);
        }
    } else {
        polygon_ring ring = {corners, points, memory_new(count, sizeof *ring.left), count};
        clip_ears(mesh, &ring);
        free(ring.left);
    }
    free(points);
    return mesh->clip_steps < CLIP_STEPS_MAX;
}
