/* SPDX-License-Identifier: MIT */
/* Regions: exponents at which a table or a trick breaks, and what Phong's model itself does. */
#include "picture.h"
#include "region.h"

#include <math.h>
#include <stdlib.h>

static void judge_exponent(double p, region_figures *figures) {
    static const glint_shading_model *const models[2] = {&glint_model_blinn_phong, &glint_model_phong};
    for (int i = 0; i < 4; i++) {
        random_scene s;
        region_sphere(&s, 9, 8);
        region_light(&s, 0.6, 0.5, 0.2);
        s.materials[0].shininess = region_q16(p);
        s.materials[0].model = models[i % 2];
        s.materials[0].flags = i / 2 ? GLINT_MATERIAL_SPECULAR_UNGATED : 0;
        region_judge_viewers(&s, figures);
    }
}

/* 0^0 as 2^(0 log2 0), with 0 for what is not a number. */
static void measure_zero(region_figures *figures) {
    const double logarithm = -INFINITY;
    const double power = exp2(0 * logarithm);
    figures->plain = 255 * fabs(1 - (isnan(power) ? 0 : power));
    judge_exponent(0, figures);
}

/* (1 - u)^(p/2) from a linear table of 128 over sin^2 from 0 to 1. */
static double sine_table(double p) {
    double worst = 0;
    for (int i = 0; i <= 12800; i++) {
        double at = i / 100.0;
        double cell = fmin(floor(at), 127);
        double low = pow(1 - cell / 128, p / 2);
        double high = pow(1 - (cell + 1) / 128, p / 2);
        region_raise(&worst, 255 * fabs(pow(1 - at / 128, p / 2) - low - (high - low) * (at - cell)));
    }
    return worst;
}

static void measure_half(region_figures *figures) {
    figures->plain = sine_table(0.5);
    judge_exponent(0.5, figures);
}

static void measure_one(region_figures *figures) {
    figures->plain = sine_table(1);
    judge_exponent(1, figures);
    judge_exponent(1.5, figures);
}

/* x / (p - p x + x) (Schlick, 1994). */
static double schlick(double p) {
    double worst = 0;
    for (int i = 0; i <= 1000; i++) {
        double x = i / 1000.0;
        region_raise(&worst, 255 * fabs(pow(x, p) - x / (p - p * x + x)));
    }
    return worst;
}

/* On both sides of where the library goes over to its table. */
static void measure_two(region_figures *figures) {
    figures->plain = schlick(2);
    judge_exponent(2 - 1.0 / 65536, figures);
    judge_exponent(2, figures);
    judge_exponent(2 + 1.0 / 65536, figures);
}

static void measure_odd(region_figures *figures) {
    static const double exponents[3] = {3, 77.7, 100};
    for (int i = 0; i < 3; i++) {
        double squarings = exp2(floor(log2(exponents[i]) + 0.5));
        for (int x = 0; x <= 1000; x++)
            region_raise(&figures->plain, 255 * fabs(pow(x / 1000.0, exponents[i]) - pow(x / 1000.0, squarings)));
        judge_exponent(exponents[i], figures);
    }
}

/* x^p from a linear table of 256 over x from 0 to 1. */
static double cosine_table(double p) {
    double worst = 0;
    for (int i = 0; i <= 25600; i++) {
        double at = i / 100.0;
        double cell = fmin(floor(at), 255);
        double low = pow(cell / 256, p);
        double high = pow((cell + 1) / 256, p);
        region_raise(&worst, 255 * fabs(pow(at / 256, p) - low - (high - low) * (at - cell)));
    }
    return worst;
}

static void measure_whole_range(region_figures *figures) {
    static const double exponents[3] = {64, 256, 1024};
    for (int i = 0; i < 3; i++) {
        region_raise(&figures->plain, cosine_table(exponents[i]));
        judge_exponent(exponents[i], figures);
    }
}

/* ---- Where Phong's highlight ends in a jump -------------------------------------------------------------------- */

/* Largest difference of a pixel from its right neighbour, both on the square. */
static double largest_jump(const random_scene *s, const glint_format *format) {
    picture image = picture_open(s->width, s->height, format);
    double jump = INFINITY;
    if (picture_render(&image, &s->scene, NULL, NULL) == GLINT_OK)
        jump = 0;
    for (int y = 4; y < s->height - 4; y++) {
        for (int x = 4; x < s->width - 5; x++)
            region_raise(&jump, abs(picture_level(&image, x + 1, y, 1) - picture_level(&image, x, y, 1)) * 255.0 /
                                    picture_level_max(format, 1));
    }
    picture_close(&image);
    return jump;
}

/* Lit from behind its side, p = 1: in Phong's model the highlight ends in a jump where N.L does. */
static void measure_terminator(region_figures *figures) {
    static const double bent[4][3] = {{-1, 0, 1}, {1, 0, 1}, {1, 0, 1}, {-1, 0, 1}};
    random_scene s;
    region_square(&s);
    region_normals(&s, bent);
    region_light(&s, 1, 0, -0.6);
    s.materials[0].model = &glint_model_phong;
    s.materials[0].shininess = GLINT_ONE;
    figures->plain = largest_jump(&s, &glint_format_rgb888);
    s.materials[0].model = &glint_model_blinn_phong;
    region_judge_viewers(&s, figures);
    s.materials[0].model = &glint_model_phong;
    s.materials[0].flags = GLINT_MATERIAL_SPECULAR_UNGATED;
    region_judge_viewers(&s, figures);
    s.scene.viewer = GLINT_VIEWER_INFINITE;
    figures->library[0] = largest_jump(&s, &glint_format_rgb888);
    figures->library[1] = largest_jump(&s, &glint_format_rgb565);
    figures->bound[0] = figures->bound[1] = 12;
}

/* Lit from the side: R turns from the eye well before N turns from the light, and below p = 1 the lobe is steepest
 * there. */
static void measure_ring(region_figures *figures) {
    static const double bent[4][3] = {{-0.42, 0, 0.9}, {0.42, 0, 0.9}, {0.42, 0, 0.9}, {-0.42, 0, 0.9}};
    static const double exponents[3] = {0.25, 0.5, 0.75};
    for (int i = 0; i < 3; i++) {
        random_scene s;
        region_square(&s);
        region_normals(&s, bent);
        region_light(&s, 0.87, 0, 0.5);
        s.materials[0].model = &glint_model_phong;
        s.materials[0].shininess = region_q16(exponents[i]);
        region_raise(&figures->plain, cosine_table(exponents[i]));
        region_judge_viewers(&s, figures);
    }
}

const region power_regions[] = {
    {"p = 0, and 0^0", "2^(p log2 x)", REGION_STEPS, "says that x^0 is 1, also for 0", 200, measure_zero},
    {"p = 0.5", "128 linear entries over sin^2", REGION_STEPS,
     "computes cos^p from a logarithm and an exponential below p = 2", 20, measure_half},
    {"p of 1 and 1.5", "128 linear entries over sin^2", REGION_STEPS, "the same", 5, measure_one},
    {"p = 2, and to both sides of it", "x / (p - p x + x)", REGION_STEPS, "goes over to its table here", 20,
     measure_two},
    {"p not a power of two: 3, 77.7, 100", "repeated squaring, to the nearest power of two", REGION_STEPS,
     "the table is made for the p given", 20, measure_odd},
    {"p of 64, 256, 1024 in a table", "256 linear entries over cos from 0 to 1", REGION_STEPS,
     "128 entries over the part of sin^2 that matters", 15, measure_whole_range},
    {"Phong's highlight cut off where the surface turns from the light, N.L = 0", "Phong's own gate",
     "largest step between neighbours, of 255", "draws it on request only: ungated, there is no jump", 40,
     measure_terminator},
    {"Phong's ring, R.V = 0, p of 0.25, 0.5, 0.75", "256 linear entries over cos from 0 to 1", REGION_STEPS,
     "computes cos^p from a logarithm and an exponential: the ring is the model's own, and drawn as it is", 10,
     measure_ring},
};
const unsigned power_region_count = sizeof power_regions / sizeof power_regions[0];
