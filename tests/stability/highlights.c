/* SPDX-License-Identifier: MIT */
/* Regions: highlights where they are sharpest, end, or should not be. */
#include "region.h"

#include <math.h>
#include <string.h>

/* sin^2 along a row, (slope (x - centre))^2, by forward differences in Q32 that are cut off: the smallest drifts below
 * 0. */
static double black_dot(double slope, double centre, double p) {
    const double one = 4294967296.0;
    const double q = slope * slope;
    uint32_t value = (uint32_t)floor(one * q * centre * centre);
    int32_t first = (int32_t)floor(one * q * (1 - 2 * centre));
    const int32_t second = (int32_t)floor(one * 2 * q);
    double worst = 0;
    for (int x = 0; x < 64; x++) {
        double wanted = pow(1 - q * (x - centre) * (x - centre), p / 2);
        double got = pow(1 - value / one, p / 2);
        region_raise(&worst, 255 * fabs(wanted - got));
        value += (uint32_t)first;
        first += second;
    }
    return worst;
}

/* A bent square; the light is moved by fractions of a pixel. */
static void measure_centre(region_figures *figures) {
    static const double bent[4][3] = {{-0.3, -0.3, 1}, {0.3, -0.3, 1}, {0.3, 0.3, 1}, {-0.3, 0.3, 1}};
    random_scene s;
    region_square(&s);
    region_normals(&s, bent);
    region_weights(&s, 0, 0, 1);
    s.materials[0].shininess = 1024 * GLINT_ONE;
    for (int i = 0; i < 16; i++) {
        region_raise(&figures->plain, black_dot(0.01, 32 + i / 16.0, 1024));
        region_light(&s, 0.3 + i * 0.001, 0.2 + i * 0.0007, 1);
        region_judge_viewers(&s, figures);
    }
}

/* cos^p from a cosine rounded to 16 bits. */
static double rounded_cosine(double p) {
    double worst = 0;
    for (int i = 0; i < 4000; i++) {
        double cosine = cos(i * 4 / sqrt(p) / 4000);
        double rounded = floor(cosine * 65536 + 0.5) / 65536;
        region_raise(&worst, 255 * fabs(pow(cosine, p) - pow(rounded, p)));
    }
    return worst;
}

static void measure_exponents(region_figures *figures, const glint_q16 *exponents, int count) {
    random_scene s;
    for (int i = 0; i < count; i++) {
        region_sphere(&s, 9, 8);
        region_light(&s, 0.5, 0.6, 0.7);
        s.materials[0].shininess = exponents[i];
        region_raise(&figures->plain, rounded_cosine(exponents[i] / 65536.0));
        region_judge_viewers(&s, figures);
    }
}

static void measure_high_exponents(region_figures *figures) {
    static const glint_q16 exponents[3] = {257 * GLINT_ONE, 514 * GLINT_ONE, 1024 * GLINT_ONE};
    measure_exponents(figures, exponents, 3);
}

static void measure_highest_exponents(region_figures *figures) {
    static const glint_q16 exponents[4] = {2048 * GLINT_ONE, 4096 * GLINT_ONE, 16384 * GLINT_ONE, INT32_MAX};
    measure_exponents(figures, exponents, 4);
}

/* Normals on the far side of the light and of the eye, not gated. */
static void measure_behind(region_figures *figures) {
    static const double away[4][3] = {{-0.2, -0.1, -1}, {0.1, -0.2, -1}, {0.2, 0.2, -1}, {-0.1, 0.1, -1}};
    random_scene s;
    region_square(&s);
    region_normals(&s, away);
    region_weights(&s, 0.1, 0.4, 0.5);
    s.materials[0].flags = GLINT_MATERIAL_SPECULAR_UNGATED;
    for (int degrees = 90; degrees <= 180; degrees++) {
        double cosine = cos(degrees * 3.14159265358979323846 / 180);
        double of_sine = pow(1 - (1 - cosine * cosine), 32 / 2.0);
        region_raise(&figures->plain, 255 * (of_sine - pow(fmax(cosine, 0), 32)));
    }
    region_judge_viewers(&s, figures);
}

/* A wide lobe, the light from the side: half of the highlight lies in the dark. */
static void measure_terminator(region_figures *figures) {
    random_scene s;
    region_sphere(&s, 9, 8);
    region_light(&s, 1, 0.1, 0);
    s.materials[0].shininess = 4 * GLINT_ONE;
    for (int degrees = 90; degrees < 180; degrees++) /* N from L; H is at 45 degrees */
        region_raise(&figures->plain, 255 * pow(fmax(cos((degrees - 45) * 3.14159265358979323846 / 180), 0), 4));
    region_judge_viewers(&s, figures);
}

/* Unit vectors of one bit too many: 1 is 32768, which int16 does not hold. */
static void measure_above_one(region_figures *figures) {
    random_scene s;
    const int16_t wrapped = (int16_t)(uint16_t)32768u;
    figures->plain = 255 * fabs(1 - fmax(wrapped * 32767.0 / 32768 / 32768, 0));
    for (int i = 0; i < 26; i++) {
        const int direction = i < 13 ? i : i + 1; /* all but (0, 0, 0) */
        const int steps[3] = {direction / 9 - 1, direction / 3 % 3 - 1, direction % 3 - 1};
        const double n[3] = {steps[0], steps[1], steps[2]};
        const double same[4][3] = {{n[0], n[1], n[2]}, {n[0], n[1], n[2]}, {n[0], n[1], n[2]}, {n[0], n[1], n[2]}};
        region_square(&s);
        region_normals(&s, same);
        region_weights(&s, 0, 1, 0);
        region_light(&s, n[0], n[1], n[2]);
        region_judge_viewers(&s, figures);
    }
}

/* L + V of vectors rounded to 15 bits; N is what comes out, made unit. */
static double noise_for_half_vector(double off) {
    const double light[3] = {sin(off), 0, -cos(off)};
    const double exact[3] = {light[0], 0, light[2] + 1};
    double rounded[3];
    for (int axis = 0; axis < 3; axis++)
        rounded[axis] = floor(light[axis] * 32767 + 0.5) + (axis == 2 ? 32766 : 0);
    double length = sqrt(rounded[0] * rounded[0] + rounded[2] * rounded[2]);
    double exact_length = sqrt(exact[0] * exact[0] + exact[2] * exact[2]);
    double cosine = (rounded[0] * exact[0] + rounded[2] * exact[2]) / (length * exact_length + 1e-30);
    return 255 * (1 - pow(fmax(cosine, 0), 32));
}

/* Lit per vertex, not gated: what one corner has of a light straight behind it shows all over the square. */
static void measure_opposed_corner(region_figures *figures) {
    random_scene s;
    region_square(&s);
    s.scene.viewer = GLINT_VIEWER_LOCAL;
    s.materials[0].flags = GLINT_MATERIAL_SPECULAR_UNGATED;
    s.objects[0].evaluation = &glint_per_vertex;
    for (int i = 0; i < 64; i++) {
        const glint_q16 away = 5 * GLINT_ONE / 2 + i * (GLINT_ONE / 64);
        s.objects[0].pose.m[2][3] = -away;
        region_light(&s, i & 1 ? 1.00002 : -1.00002, i & 2 ? 1 : -1, -away / 65536.0);
        region_judge_all(&s, figures);
    }
}

static void measure_opposed(region_figures *figures) {
    random_scene s;
    for (int i = 0; i <= 20; i++)
        region_raise(&figures->plain, noise_for_half_vector(i * 1e-5));
    for (int ungated = 0; ungated < 2; ungated++) {
        region_sphere(&s, 9, 8);
        region_light(&s, 0, 0, -1);
        s.materials[0].flags = ungated ? GLINT_MATERIAL_SPECULAR_UNGATED : 0;
        region_judge_all(&s, figures);
    }
    measure_opposed_corner(figures);
}

/* What R = 2 (N.L) N - L turns by where N, from which L is so far, lacks this of its length. */
static double turn_of_short(double lacking, double apart) {
    const double along = (2 * (1 - lacking) * (1 - lacking) - 1) * cos(apart);
    return atan2(sin(apart), along) - apart;
}

/* Normals of vertices lack up to 12 of 32764: squares of one normal each, on the slope of the highlight. */
static void measure_short_normals(region_figures *figures) {
    const double exponent = 1024, slope = 1 / sqrt(exponent), degree = 3.14159265358979323846 / 180;
    random_scene s;
    for (int i = 1; i < 90; i++) {
        const double turn = turn_of_short(12.0 / 32764, i * degree);
        for (int j = 0; j < 200; j++)
            region_raise(&figures->plain,
                         255 * (pow(cos(j / 1000.0), exponent) - pow(cos(j / 1000.0 + turn), exponent)));
    }
    for (int i = 0; i < 64; i++) {
        const double lean = (20 + i / 4.0) * degree, light = 2 * lean - slope;
        const double normal[3] = {sin(lean) * cos(i), sin(lean) * sin(i), cos(lean)};
        double normals[4][3];
        region_square(&s);
        for (int corner = 0; corner < 4; corner++)
            memcpy(normals[corner], normal, sizeof normal);
        region_normals(&s, (const double(*)[3])normals);
        region_light(&s, sin(light) * cos(i), sin(light) * sin(i), cos(light));
        region_weights(&s, 0, 0, 1);
        s.materials[0].model = &glint_model_phong;
        s.materials[0].shininess = (glint_q16)exponent * GLINT_ONE;
        s.objects[0].evaluation = &glint_per_vertex;
        region_judge(&s, figures);
    }
}

const region highlight_regions[] = {
    {"highlight's centre over the longest run of a tile, p = 1024",
     "forward differences of sin^2 in Q32 over 64 pixels, cut off", REGION_STEPS,
     "computes sin^2 from each fragment's own cross product: a sum of squares cannot fall below 0", 200,
     measure_centre},
    {"p of 257, 514, 1024", "cosine rounded to Q16", REGION_STEPS, "raises sin^2, from a cross product, to p/2", 0.9,
     measure_high_exponents},
    {"p of 2048 to 32767.99, the largest that Q16.16 holds", "cosine rounded to Q16", REGION_STEPS,
     "the same; the table's window narrows with p", 30, measure_highest_exponents},
    {"Phong's highlight at vertices, whose normals are up to 2^-11 short, p = 1024", "R with N taken for unit",
     REGION_STEPS, "divides by N.N", 2, measure_short_normals},
    {"N.H < 0", "sin^2 alone, which is the same on the back", REGION_STEPS, "takes the sign of N.H first", 200,
     measure_behind},
    {"terminator across a highlight", "highlight without gate", REGION_STEPS,
     "gates by N.L > 0 unless the material is ungated", 60, measure_terminator},
    {"N.L above 1 by rounding", "unit vectors of length 2^15 in int16", REGION_STEPS,
     "unit vectors have length 32764; weights make good for what is missing", 200, measure_above_one},
    {"L = -V", "half vector made unit from what rounding left", REGION_STEPS,
     "a half vector that is rounding alone: cos is 0", 200, measure_opposed},
};
const unsigned highlight_region_count = sizeof highlight_regions / sizeof highlight_regions[0];
