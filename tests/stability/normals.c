/* SPDX-License-Identifier: MIT */
/* Regions: normals that cancel, shrink or are not there. */
#include "region.h"

#include <math.h>
#include <string.h>

/* Normals 2 x `half` degrees apart, interpolated at t: length of the sum. */
static double length_between(double half, double t) {
    double cosine = cos(half * 3.14159265358979323846 / 180);
    double sine = sin(half * 3.14159265358979323846 / 180) * (1 - 2 * t);
    return sqrt(cosine * cosine + sine * sine);
}

static double squared(double x) {
    return x * x;
}

/* 1 / sqrt(c) from a table of 1024 over [1/4, 1): index wraps at the upper end, is held at the lower. */
static double table_root(double c) {
    int index = (int)floor((c - 0.25) / 0.75 * 1024);
    index = index < 0 ? 0 : index & 1023;
    return 1 / sqrt(0.25 + 0.75 * (index + 0.5) / 1024);
}

static void measure_opposed(region_figures *figures) {
    static const double opposed[4][3] = {{-1, 0, 0.02}, {1, 0, 0.02}, {0.7, 0.7, 0.02}, {-0.7, 0.7, 0.02}};
    random_scene s;
    for (int i = 0; i <= 100; i++)
        region_raise(&figures->plain, 255 * fabs(1 - length_between(88.9, i / 100.0) *
                                                         table_root(squared(length_between(88.9, i / 100.0)))));
    for (int i = 0; i < 8; i++) {
        region_square(&s);
        region_normals(&s, opposed);
        region_light(&s, cos(i), sin(i), 1);
        region_judge_viewers(&s, figures);
    }
}

/* No normals at all; the sine of the angle to anything is then 0, as at a highlight's centre. */
static void measure_zero(region_figures *figures) {
    random_scene s;
    region_square(&s);
    memset(s.meshes[0].normals, 0, sizeof s.meshes[0].normals);
    figures->plain = 255 * pow(1 - 0, 32 / 2.0);
    for (int ungated = 0; ungated < 2; ungated++) {
        s.materials[0].flags = ungated ? GLINT_MATERIAL_SPECULAR_UNGATED : 0;
        for (int viewer = 0; viewer < 2; viewer++) {
            s.scene.viewer = viewer ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
            region_judge_all(&s, figures);
        }
    }
}

static void measure_shortened(region_figures *figures) {
    static const double spread[4][3] = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
    random_scene s;
    for (int i = 0; i <= 100; i++)
        region_raise(&figures->plain, 255 * (1 - pow(length_between(45, i / 100.0), 32)));
    for (int i = 0; i < 8; i++) {
        region_square(&s);
        region_normals(&s, spread);
        region_light(&s, cos(i), sin(i), 1);
        region_judge_viewers(&s, figures);
    }
}

/* Normals of every length at which c leaves a table or nearly does. */
static void measure_table_ends(region_figures *figures) {
    static const int lengths[] = {1, 2, 255, 16383, 16384, 16385, 23170, 32766, 32767};
    random_scene s;
    region_raise(&figures->plain, 255 * fabs(0.5 - fmin(0.5 * table_root(1), 1)));
    for (unsigned i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        region_square(&s);
        for (int corner = 0; corner < 4; corner++)
            s.meshes[0].normals[corner][2] = (int16_t)lengths[i];
        region_light(&s, 0.3, 0.4, 0.8);
        region_judge_viewers(&s, figures);
    }
}

const region normal_regions[] = {
    {"opposed normals, nearly 0 in mid-triangle", "1/sqrt from a table over [1/4, 1)", REGION_STEPS,
     "scales each normal to its own size first", 200, measure_opposed},
    {"normals of 0", "sin^2 of what has no direction is 0: full highlight", REGION_STEPS,
     "0 stays 0: ambient light alone", 200, measure_zero},
    {"normals shortened by interpolation", "interpolated, not made unit", REGION_STEPS,
     "makes them unit at each fragment", 200, measure_shortened},
    {"c at the ends of the 1/sqrt table", "10-bit table over [1/4, 1), c = 1 wraps", REGION_STEPS,
     "scales c to [1/4, 3), the table has a node at each end", 100, measure_table_ends},
};
const unsigned normal_region_count = sizeof normal_regions / sizeof normal_regions[0];
