/* SPDX-License-Identifier: MIT */
/* Regions: poses that bend normals, turn triangles over or lose a dimension. */
#include "harness.h"
#include "picture.h"
#include "plain_raster.h"
#include "region.h"

#include <math.h>

static void scale(random_scene *s, double x, double y, double z) {
    const glint_q16 distance = s->objects[0].pose.m[2][3];
    s->objects[0].pose = glint_pose_scale(region_q16(x), region_q16(y), region_q16(z));
    s->objects[0].pose.m[2][3] = distance;
}

/* N.L of a normal scaled by y as positions are, against one scaled by 1/y; L along the exact normal. */
static double bent_normal(double y) {
    double worst = 0;
    for (int degrees = 0; degrees <= 90; degrees++) {
        const double angle = degrees * 3.14159265358979323846 / 180;
        const double exact[2] = {cos(angle), sin(angle) / y};
        const double bent[2] = {cos(angle), sin(angle) * y};
        double product =
            (exact[0] * bent[0] + exact[1] * bent[1]) / hypot(exact[0], exact[1]) / hypot(bent[0], bent[1]);
        region_raise(&worst, 255 * (1 - product));
    }
    return worst;
}

static void measure_scales(region_figures *figures) {
    static const double scales[5][3] = {
        {1, 0.01, 0.5}, {0.01, 1, 1}, {1, 1, 0.01}, {0.01, 0.01, 1}, {0.012, 1.2, 0.012}};
    random_scene s;
    figures->plain = bent_normal(0.01);
    for (int i = 0; i < 5; i++) {
        region_sphere(&s, 9, 8);
        scale(&s, scales[i][0], scales[i][1], scales[i][2]);
        region_light(&s, 0.4, 0.5, 0.6);
        region_judge_viewers(&s, figures);
    }
}

static void measure_mirrors(region_figures *figures) {
    random_scene s;
    for (int i = 1; i < 8; i++) {
        region_square(&s);
        scale(&s, i & 1 ? -1 : 1, i & 2 ? -1 : 1, i & 4 ? -1 : 1);
        figures->plain += (double)plain_cover(&s, PLAIN_WINDING).wrong;
        region_judge_coverage(&s, figures);
        region_sphere(&s, 9, 8);
        scale(&s, i & 1 ? -1 : 1, i & 2 ? -1 : 1, i & 4 ? -1 : 1);
        region_light(&s, 0.4, 0.5, 0.6);
        region_judge_coverage(&s, figures);
    }
}

/* The inverse transpose as cofactors over a determinant of 0; the library refuses. */
static void measure_singular(region_figures *figures) {
    for (int which = 0; which < 7; which++) {
        random_scene s;
        picture image = picture_open(16, 16, &glint_format_rgb565);
        region_sphere(&s, 9, 8);
        scale(&s, which & 1 ? 1 : 0, which & 2 ? 1 : 0, which & 4 ? 1 : 0);
        const glint_pose *p = &s.objects[0].pose;
        double determinant = (double)p->m[0][0] * p->m[1][1] * p->m[2][2];
        figures->plain += isinf(1 / determinant);
        int drawn = picture_render(&image, &s.scene, NULL, NULL) != GLINT_ERROR_POSE;
        figures->library[0] += drawn;
        figures->library[1] += drawn;
        picture_close(&image);
    }
}

const region pose_regions[] = {
    {"scales of 1:100", "normals by the pose itself", REGION_STEPS,
     "normals by the inverse transpose, sized to 30 bits", 200, measure_scales},
    {"mirrored poses", "front faces by the screen's winding alone", "pixels", "the determinant's sign turns the test",
     200, measure_mirrors},
    {"singular poses", "divides by the determinant", "poses drawn", "GLINT_ERROR_POSE before anything is sent", 7,
     measure_singular},
};
const unsigned pose_region_count = sizeof pose_regions / sizeof pose_regions[0];
