/* SPDX-License-Identifier: MIT */
/* Regions: triangles of shapes and in places that rasterisers get wrong. */
#include "plain_raster.h"
#include "region.h"

#include <math.h>

#define PIXELS "pixels"

/* The square's corners, in object space from -1 to 1. */
static void set_corner(random_scene *s, int corner, double x, double y, double z) {
    s->meshes[0].positions[corner][0] = (int16_t)lrint(32767 * x);
    s->meshes[0].positions[corner][1] = (int16_t)lrint(32767 * y);
    s->meshes[0].positions[corner][2] = (int16_t)lrint(32767 * z);
}

/* Value at the far end of a sliver from a gradient (d1 y2 - d2 y1) / area in 32 bits that wrap; Q15 over Q4 pixels. */
static double wrapped_gradient(int32_t thickness) {
    const int32_t y1 = 900;
    const int32_t y2 = 900 - thickness;
    const int32_t d1 = 32767;
    const int32_t d2 = 16384;
    const int32_t area = 16 * thickness;
    int32_t slope = (int32_t)((uint32_t)(d1 * y2 - d2 * y1) << 16) / area;
    double exact = ((double)d1 * y2 - (double)d2 * y1) / area;
    return fmin(255, 255.0 / 32768 * fabs(slope / 65536.0 - exact));
}

static void measure_slivers(region_figures *figures) {
    random_scene s;
    for (int thickness = 1; thickness < 40; thickness++) {
        region_raise(&figures->plain, wrapped_gradient(thickness));
        region_square(&s);
        set_corner(&s, 0, -1, -0.9, 0);
        set_corner(&s, 1, 1, 0.8 - thickness / 300.0, 0);
        set_corner(&s, 2, 1, 0.8, 0);
        set_corner(&s, 3, -1, 0.95, 0);
        static const double leaning[4][3] = {{-0.4, 0, 1}, {0.5, 0.2, 1}, {0.3, -0.4, 1}, {0, 0.5, 1}};
        region_normals(&s, leaning);
        region_judge_viewers(&s, figures);
    }
}

/* All corners on one line, or two of them the same. */
static void measure_no_area(region_figures *figures) {
    random_scene s;
    region_square(&s);
    set_corner(&s, 0, -0.8, -0.8, 0);
    set_corner(&s, 1, 0, 0, 0);
    set_corner(&s, 2, 0.8, 0.8, 0);
    set_corner(&s, 3, 0.8, 0.8, 0);
    figures->plain = (double)plain_cover(&s, PLAIN_INCLUSIVE).drawn;
    region_judge_coverage(&s, figures);
}

static void measure_one_pixel(region_figures *figures) {
    random_scene s;
    for (int distance = 20; distance <= 40; distance++) {
        region_sphere(&s, 10, 8);
        s.objects[0].pose.m[2][3] = -distance * GLINT_ONE;
        figures->plain += (double)plain_cover(&s, PLAIN_PIXELS).wrong;
        region_judge_coverage(&s, figures);
    }
}

/* A diagonal through pixels' centres. */
static void measure_shared_edge(region_figures *figures) {
    random_scene s;
    region_square(&s);
    figures->plain = (double)plain_cover(&s, PLAIN_INCLUSIVE).twice;
    region_judge_coverage(&s, figures);
}

/* One corner of the square, turned, in the screen's middle, the rest beyond one or two sides of the guard band. */
static void measure_guard_band(region_figures *figures) {
    random_scene s;
    for (int i = 0; i < 20; i++) {
        const int size = 20 << i / 4;
        const glint_pose scale = glint_pose_scale(size * GLINT_ONE, size * GLINT_ONE, size * GLINT_ONE);
        const glint_pose turn = glint_pose_rotate_z((i * 90 + 65) * GLINT_ONE);
        region_square(&s);
        s.objects[0].pose = glint_pose_then(&scale, &turn);
        s.objects[0].pose.m[0][3] = -s.objects[0].pose.m[0][0] - s.objects[0].pose.m[0][1];
        s.objects[0].pose.m[1][3] = -s.objects[0].pose.m[1][0] - s.objects[0].pose.m[1][1];
        s.objects[0].pose.m[2][3] = -3 * GLINT_ONE;
        region_raise(&figures->plain, (double)plain_cover(&s, PLAIN_WRAP).wrong);
        region_judge_coverage(&s, figures);
    }
}

/* The square as a floor below the eye, from behind it to far before it. */
static void make_floor(random_scene *s, double size, double below, double ahead) {
    region_square(s);
    const glint_pose scale = glint_pose_scale(region_q16(size), region_q16(size), region_q16(size));
    const glint_pose turn = glint_pose_rotate_x(-90 * GLINT_ONE);
    s->objects[0].pose = glint_pose_then(&scale, &turn);
    s->objects[0].pose.m[1][3] = region_q16(-below);
    s->objects[0].pose.m[2][3] = region_q16(-ahead);
    region_light(s, 0.2, 1, 0.1);
}

static void measure_near_plane(region_figures *figures) {
    random_scene s;
    for (int i = 0; i < 4; i++) {
        make_floor(&s, 20, 0.7 + 0.3 * i, 5);
        region_raise(&figures->plain, (double)plain_cover(&s, PLAIN_UNCLIPPED).wrong);
        region_judge_coverage(&s, figures);
    }
    for (int degrees = 10; degrees <= 70; degrees += 20) { /* cut within the screen */
        region_square(&s);
        s.objects[0].pose = glint_pose_rotate_y(degrees * GLINT_ONE);
        s.objects[0].pose.m[2][3] = -3 * GLINT_ONE;
        s.scene.camera.near_plane = 3 * GLINT_ONE;
        region_raise(&figures->plain, (double)plain_cover(&s, PLAIN_UNCLIPPED).wrong);
        region_judge_coverage(&s, figures);
    }
}

/* The nearest near plane there is, and a surface through the eye but for a thousandth. */
static void measure_at_the_eye(region_figures *figures) {
    random_scene s;
    for (int i = 0; i < 4; i++) {
        make_floor(&s, 20, 0.001 * (i + 1), 5);
        s.scene.camera.near_plane = 1;
        region_raise(&figures->plain, (double)plain_cover(&s, PLAIN_UNCLIPPED | PLAIN_WRAP).wrong);
        region_judge_coverage(&s, figures);
    }
}

static void measure_behind(region_figures *figures) {
    random_scene s;
    region_sphere(&s, 9, 8);
    s.objects[0].pose.m[2][3] = 4 * GLINT_ONE;
    s.meshes[0].mesh.flags = GLINT_MESH_DOUBLE_SIDED;
    figures->plain = (double)plain_cover(&s, PLAIN_UNCLIPPED).drawn;
    region_judge_coverage(&s, figures);
}

/* Affine against perspective, between corners of w 1 and `ratio`. */
static double affine(double ratio) {
    double worst = 0;
    for (int i = 0; i <= 1000; i++) {
        double t = i / 1000.0;
        region_raise(&worst, 255 * fabs(t - t / ratio / (1 - t + t / ratio)));
    }
    return worst;
}

/* A floor from w = 0.5 to 500, within the screen. */
static void measure_depths(region_figures *figures) {
    random_scene s;
    static const double leaning[4][3] = {{-0.4, 0.1, 1}, {0.5, 0.2, 1}, {0.3, -0.4, 1}, {0, 0.5, 1}};
    figures->plain = affine(1000);
    for (int i = 1; i <= 4; i++) {
        make_floor(&s, 1, 0.1, 0);
        const glint_pose shape = glint_pose_scale(region_q16(0.1 * i), region_q16(249.75), GLINT_ONE);
        const glint_pose turn = glint_pose_rotate_x(-90 * GLINT_ONE);
        s.objects[0].pose = glint_pose_then(&shape, &turn);
        s.objects[0].pose.m[1][3] = region_q16(-0.1);
        s.objects[0].pose.m[2][3] = region_q16(-250.25);
        region_normals(&s, leaning);
        region_judge_viewers(&s, figures);
    }
}

/* Of a quadratic whose coefficients are rounded down to 2^-27: a pixel away across and down makes this of a step. */
static double round_down(double away) {
    return 255 * 4 * away * away / (1 << 27);
}

/* A square that reaches far beyond the screen and is nearly in a plane with it, lit at its corners. */
static void measure_large_and_lit(region_figures *figures) {
    static const double leaning[4][3] = {{-0.4, 0.1, 1}, {0.5, 0.2, 1}, {0.3, -0.4, 1}, {0, 0.5, 1}};
    random_scene s;
    figures->plain = round_down(700);
    for (int i = 0; i < 16; i++) {
        region_square(&s);
        region_normals(&s, leaning);
        s.objects[0].evaluation = &glint_per_vertex;
        s.objects[0].pose = glint_pose_rotate_y((i & 1 ? 2 : -2) * GLINT_ONE);
        s.objects[0].pose.m[0][3] = region_q16(i & 2 ? 0.92 : -0.92);
        s.objects[0].pose.m[1][3] = region_q16(i & 4 ? 0.92 : -0.92);
        s.objects[0].pose.m[2][3] = region_q16(-3);
        s.scene.camera.field_of_view = (i & 8 ? 3 : 5) * GLINT_ONE;
        region_judge_all(&s, figures);
    }
}

/* Depth in 16 bits relative to the near plane: which of two squares is nearer, along their common middle. */
static void measure_depth_steps(region_figures *figures) {
    const double near = 0.001;
    random_scene s;
    for (int i = -100; i <= 100; i++) {
        double first = floor(65535 * near / (3.7 + 0.2 * i / 100));
        double second = floor(65535 * near / (3.7 - 0.2 * i / 100));
        figures->plain += (second > first) != (i > 0);
    }
    region_square(&s);
    s.scene.object_count = 2;
    s.scene.camera.near_plane = region_q16(near);
    for (int i = 0; i < 2; i++) {
        s.objects[i].pose = glint_pose_rotate_y((i ? 5 : -5) * GLINT_ONE);
        s.objects[i].pose.m[2][3] = region_q16(-3.7);
    }
    s.materials[1] = s.materials[0];
    s.materials[1].diffuse = (glint_colour){0, GLINT_ONE / 2, 0};
    s.objects[1].material = &s.materials[1];
    region_judge(&s, figures);
    for (int format = 0; format < 2; format++) {
        /* Pixels that show the wrong one, and those where the library's steps leave it open. */
        figures->library[format] = (double)(figures->found[format].over_one + figures->found[format].close);
        figures->bound[format] = 0;
    }
}

const region triangle_regions[] = {
    {"slivers down to 1/16 of a pixel", "gradients in 32 bits", REGION_STEPS,
     "gradients from products of 64 bits; planes modulo 2^32", 200, measure_slivers},
    {"triangles without area", "edges that belong to both sides", PIXELS, "drops them", 20, measure_no_area},
    {"triangles of about a pixel", "vertices on whole pixels", PIXELS, "vertices on sixteenths, exact edges", 20,
     measure_one_pixel},
    {"shared edges through pixel centres", "edges that belong to both sides", PIXELS, "top-left rule", 20,
     measure_shared_edge},
    {"triangles larger than the guard band", "screen positions in int16", PIXELS,
     "clips at 1023 pixels from the centre", 200, measure_guard_band},
    {"through the near plane", "no clipping", PIXELS, "clips in clip space", 200, measure_near_plane},
    {"w near 0", "no clipping, positions in int16", PIXELS, "the same, with the near plane at 1/65536", 200,
     measure_at_the_eye},
    {"everything behind the eye", "no clipping", PIXELS, "drops the object by its bounding box", 200, measure_behind},
    {"w from 0.5 to 500 in one triangle", "affine interpolation", REGION_STEPS, "interpolates N/w", 200,
     measure_depths},
    {"triangles of 490 to 815 pixels, lit at their corners", "quadratics with whole coefficients, of 2^-27",
     REGION_STEPS, "quadratics only as far as their rounding keeps within a tenth of a step", 2, measure_large_and_lit},
    {"surfaces that cross, 3700 near planes away", "16-bit depth relative to the near plane", PIXELS,
     "depth relative to the frame's nearest geometry", 10, measure_depth_steps},
};
const unsigned triangle_region_count = sizeof triangle_regions / sizeof triangle_regions[0];
