/* SPDX-License-Identifier: MIT */
#include "shapes.h"

#include "number.h"

#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

typedef struct unit {
    double c, s;
} unit;

/** cos and sin of 2 pi i / n for 0 <= i <= n/8: 1/2 exactly at 30 degrees, so that no rounding rests on libm's last
 * bit. */
static unit circle_octant(int i, int n) {
    const double angle = 2.0 * pi * i / n;
    const unit point = {cos(angle), 12 * i == n ? 0.5 : sin(angle)};
    return point;
}

/** cos and sin of 2 pi i / n for 0 <= i < n, as symmetric as the circle is. */
static unit circle(int i, int n) {
    const int below = 2 * i > n; /* mirrored at the x axis */
    i = below ? n - i : i;
    const int left = 4 * i > n; /* at the y axis, in half steps so that an odd n works */
    const int i2 = left ? n - 2 * i : 2 * i;
    const int above = 4 * i2 > n; /* n / 2 half steps make a quarter; at the diagonal, in quarter steps */
    const unit low = circle_octant(above ? n - 2 * i2 : 2 * i2, 4 * n);
    const unit first = {above ? low.s : low.c, above ? low.c : low.s};
    const unit point = {left ? -first.c : first.c, below ? -first.s : first.s};
    return point;
}

static mesh_corner both(uint32_t index) {
    const mesh_corner corner = {index, index};
    return corner;
}

/** R = 1, r = 0.4, axis z; vertex i nv + j. */
static void make_torus(host_mesh *mesh, int nu, int nv) {
    for (int i = 0; i < nu; i++) {
        const unit u = circle(i, nu);
        for (int j = 0; j < nv; j++) {
            const unit v = circle(j, nv);
            const double ring = 1.0 + 0.4 * v.c;
            mesh_add_position(mesh, ring * u.c, ring * u.s, 0.4 * v.s);
            mesh_add_normal(mesh, v.c * u.c, v.c * u.s, v.s);
        }
    }
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const int i1 = (i + 1) % nu;
            const int j1 = (j + 1) % nv;
            const mesh_corner a = both((uint32_t)(i * nv + j));
            const mesh_corner b = both((uint32_t)(i1 * nv + j));
            const mesh_corner c = both((uint32_t)(i1 * nv + j1));
            const mesh_corner d = both((uint32_t)(i * nv + j1));
            mesh_add_triangle(mesh, a, b, c);
            mesh_add_triangle(mesh, a, c, d);
        }
    }
}

static void add_sphere_point(host_mesh *mesh, double x, double y, double z) {
    mesh_add_position(mesh, x, y, z);
    mesh_add_normal(mesh, x, y, z);
}

/** Radius 1: the pole at z = 1, nv - 1 rings of nu points, the pole at z = -1. */
static void make_sphere(host_mesh *mesh, int nu, int nv) {
    add_sphere_point(mesh, 0, 0, 1);
    for (int j = 1; j < nv; j++) {
        const unit polar = circle(j, 2 * nv);
        for (int i = 0; i < nu; i++) {
            const unit u = circle(i, nu);
            add_sphere_point(mesh, polar.s * u.c, polar.s * u.s, polar.c);
        }
    }
    add_sphere_point(mesh, 0, 0, -1);
    const mesh_corner north = both(0);
    const mesh_corner south = both((uint32_t)(nu * (nv - 1) + 1));
    for (int j = 0; j < nv; j++) {
        for (int i = 0; i < nu; i++) {
            const int i1 = (i + 1) % nu;
            const mesh_corner a = j > 0 ? both((uint32_t)(1 + (j - 1) * nu + i)) : north;
            const mesh_corner b = j + 1 < nv ? both((uint32_t)(1 + j * nu + i)) : south;
            const mesh_corner c = j + 1 < nv ? both((uint32_t)(1 + j * nu + i1)) : south;
            const mesh_corner d = j > 0 ? both((uint32_t)(1 + (j - 1) * nu + i1)) : north;
            if (j + 1 < nv) {
                mesh_add_triangle(mesh, a, b, c);
            }
            if (j > 0) {
                mesh_add_triangle(mesh, a, c, d);
            }
        }
    }
}

const host_shape host_shapes[] = {
    {"torus", "NUxNV: radii 1 and 0.4 round z, NU steps round it, NV round the tube", {3, 3}, 1024, make_torus},
    {"sphere", "NUxNV: radius 1, poles on z, NU steps round it, NV from pole to pole", {3, 2}, 1024, make_sphere},
    {NULL, NULL, {0, 0}, 0, NULL},
};

const host_shape *shape_find(const char *name) {
    for (const host_shape *shape = host_shapes; shape->name != NULL; shape++) {
        const size_t length = strlen(shape->name);
        if (strncmp(name, shape->name, length) == 0 && name[length] == ':') {
            return shape;
        }
    }
    return NULL;
}

bool shape_make(const host_shape *shape, const char *name, host_mesh *mesh, host_problem *problem) {
    const char *sizes = strchr(name, ':') + 1;
    const char *cross = strchr(sizes, 'x');
    int64_t nu;
    int64_t nv;
    if (cross == NULL || !number_integer(sizes, (size_t)(cross - sizes), &nu) ||
        !number_integer(cross + 1, strlen(cross + 1), &nv)) {
        return problem_set(problem, 0, "%s takes two sizes, as in %s:24x12", shape->name, shape->name);
    }
    if (nu < shape->least[0] || nv < shape->least[1] || nu > shape->most || nv > shape->most) {
        return problem_set(problem, 0, "%s takes sizes from %dx%d to %dx%d", shape->name, shape->least[0],
                           shape->least[1], shape->most, shape->most);
    }
    memset(mesh, 0, sizeof *mesh);
    shape->make(mesh, (int)nu, (int)nv);
    mesh->face_count = mesh->triangle_count;
    return true;
}
