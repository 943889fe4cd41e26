/* SPDX-License-Identifier: MIT */
/* Regions: colours and lights beyond their usual range. */
#include "region.h"

#include <math.h>
#include <string.h>

/* Bytes added without a clamp. */
static void measure_sums(region_figures *figures) {
    random_scene s;
    for (int diffuse = 0; diffuse < 256; diffuse++) {
        for (int specular = 0; specular < 256; specular++)
            region_raise(&figures->plain, fabs((uint8_t)(diffuse + specular) - fmin(diffuse + specular, 255)));
    }
    for (int lights = 1; lights <= RANDOM_LIGHTS_MAX; lights++) {
        region_sphere(&s, 9, 8);
        region_weights(&s, 16, 16, 16);
        s.scene.light_count = (uint32_t)lights;
        for (int i = 0; i < lights; i++)
            s.lights[i].direction = (glint_vector){GLINT_ONE * (1 - i), -GLINT_ONE, -GLINT_ONE / 2 * i};
        region_judge_viewers(&s, figures);
    }
}

/* Weights of 4 on a dark ground: every level from 0 to 1 is passed. */
static void measure_bright_slopes(region_figures *figures) {
    random_scene s;
    for (int i = 0; i <= 255; i++)
        region_raise(&figures->plain, fabs((uint8_t)(4 * i) - fmin(4 * i, 255)));
    region_sphere(&s, 9, 8);
    region_weights(&s, 0, 4, 4);
    region_light(&s, 1, 0.5, -0.3);
    region_judge_viewers(&s, figures);
}

static void make_point(random_scene *s, double x, double y, double z) {
    s->lights[0].type = &glint_light_point;
    region_light(s, x, y, z);
}

/* A square whose normals lean towards its upper right corner: a light there, in its plane, is seen. */
static void make_leaning(random_scene *s) {
    static const double leaning[4][3] = {{0.5, 0.4, 1}, {0.1, 0.5, 1}, {0.4, 0.3, 1}, {0.5, 0.2, 1}};
    region_square(s);
    region_normals(s, leaning);
}

/* 1 / d^2 in Q16, where d^2 of less than 1/256 is 0, taken to mean as much as can be. */
static void measure_no_distance(region_figures *figures) {
    random_scene s;
    for (int i = 0; i < 1000; i++) {
        double d = i / 1000.0;
        double square = floor(floor(d * 256) / 256 * floor(d * 256) / 256 * 65536) / 65536;
        double strength = square > 0 ? fmin(1 / square, 32767) : 32767;
        region_raise(&figures->plain, 255 * (fmin(strength, 1) - 1 / (1 + 8 * d + 8 * d * d)));
    }
    for (int i = 0; i < 2; i++) {
        make_leaning(&s);
        make_point(&s, 1, 1, -3);
        s.lights[0].linear = s.lights[0].quadratic = i ? 8 * GLINT_ONE : 0;
        region_judge_viewers(&s, figures);
    }
}

/* A direction from a squared length in Q16: nearer than 1/256 there is none. */
static double lost_direction(void) {
    double worst = 0;
    for (int i = 1; i < 100; i++) {
        int32_t d = i * 65536 / 10000;
        int32_t square = (int32_t)((int64_t)d * d >> 16);
        region_raise(&worst, 255 * fabs(1 - (square ? d / sqrt(square * 65536.0) : 0)));
    }
    return worst;
}

static void measure_touching(region_figures *figures) {
    static const double places[5][3] = {{0.1, 0.2, -3}, {0, 0, -3}, {0.1, 0.2, -2.9995}, {0.1, 0.2, -2.98}, {0, 0, 0}};
    random_scene s;
    figures->plain = lost_direction();
    for (int i = 0; i < 5; i++) {
        make_leaning(&s);
        make_point(&s, places[i][0], places[i][1], places[i][2]);
        region_judge_viewers(&s, figures);
    }
}

/* A surface so far away, its top and its foot so much farther and nearer or the other way round, with corners so many
 * pixels across and down from the screen's middle; and a pixel 1 away, through a lens of one degree. */
#define FAR 1000.0
#define LEANING 12
#define ASIDE 24
#define FAR_PIXEL (tan(3.14159265358979323846 / 360) / 32)

/* What a lamp so high above a surface is off by where 1/w is cut off to Q25. */
static double misplaced(double height) {
    const double off = FAR * FAR / (1 << 25);
    double worst = 0;
    for (int i = 0; i <= 1000; i++) {
        const double aside = i * height / 250;
        region_raise(&worst, 255 * fabs(height / hypot(height, aside) - (height - off) / hypot(height - off, aside)));
    }
    return worst;
}

/* That surface, and a small square 1 away. */
static void make_far(random_scene *s, double leaning) {
    random_mesh *mesh = &s->meshes[1];
    double normals[4][3];
    region_square(s);
    *mesh = s->meshes[0];
    mesh->mesh.positions = (const int16_t(*)[3])mesh->positions;
    mesh->mesh.extent = (glint_vector){GLINT_ONE / 2048, GLINT_ONE / 2048, GLINT_ONE / 2048};
    s->objects[1].mesh = &mesh->mesh;
    s->objects[1].pose = glint_pose_translate(region_q16(0.007), region_q16(0.007), -GLINT_ONE);
    for (int i = 0; i < 4; i++) {
        const double w = FAR + (i < 2 ? -leaning : leaning), aside = ASIDE * FAR_PIXEL * w;
        const double place[3] = {i % 3 ? aside : -aside, i < 2 ? -aside : aside, FAR - w};
        for (int axis = 0; axis < 3; axis++)
            s->meshes[0].positions[i][axis] = (int16_t)lrint(place[axis] * 1024);
        memcpy(normals[i], (const double[3]){0, leaning, ASIDE * FAR_PIXEL * FAR}, sizeof normals[i]);
    }
    region_normals(s, (const double(*)[3])normals);
    s->meshes[0].mesh.extent = (glint_vector){32 * GLINT_ONE, 32 * GLINT_ONE, 32 * GLINT_ONE};
    s->objects[0].pose = glint_pose_translate(0, 0, -(glint_q16)FAR * GLINT_ONE);
    s->scene.object_count = 2;
    s->scene.camera.field_of_view = GLINT_ONE;
}

/* The lamp is above what the middle of the screen shows. */
static void measure_far_lamp(region_figures *figures) {
    const double height = 3 * FAR_PIXEL * FAR;
    random_scene s;
    figures->plain = misplaced(height);
    for (int i = 0; i < 2; i++) {
        const double leaning = i ? LEANING : -LEANING, up = ASIDE * FAR_PIXEL * FAR;
        const double by = height / hypot(leaning, up);
        make_far(&s, leaning);
        region_weights(&s, 0, 1, 0);
        make_point(&s, 0, by * leaning, by * up - (FAR - LEANING * LEANING / FAR));
        region_judge_viewers(&s, figures);
    }
}

/* From within, every normal leans away: nothing but ambient light is left. */
static void measure_inside(region_figures *figures) {
    random_scene s;
    region_sphere(&s, 9, 8);
    make_point(&s, 0.1, 0.2, -4);
    s.materials[0].shininess = 2 * GLINT_ONE;
    for (int degrees = 90; degrees <= 180; degrees++) {
        double cosine = cos(degrees * 3.14159265358979323846 / 180);
        region_raise(&figures->plain, 255 * fabs(cosine));
    }
    region_judge_viewers(&s, figures);
    s.meshes[0].mesh.flags = GLINT_MESH_DOUBLE_SIDED;
    region_judge_viewers(&s, figures);
}

/* The soft edge of a spot, from the angle in 8 bits. */
static void measure_spot(region_figures *figures) {
    random_scene s;
    const double inner = cos(10 * 3.14159265358979323846 / 180);
    const double outer = cos(20 * 3.14159265358979323846 / 180);
    for (int i = 0; i <= 1000; i++) {
        double cosine = outer + (inner - outer) * i / 1000;
        double t = fmax(0, fmin(1, (floor(cosine * 256 + 0.5) / 256 - outer) / (inner - outer)));
        double exact = i / 1000.0;
        region_raise(&figures->plain, 255 * fabs(t * t * (3 - 2 * t) - exact * exact * (3 - 2 * exact)));
    }
    region_square(&s);
    make_point(&s, 0.3, 0.1, 0);
    s.lights[0].type = &glint_light_spot;
    s.lights[0].direction = (glint_vector){-GLINT_ONE / 4, 0, -3 * GLINT_ONE};
    s.lights[0].inner = 10 * GLINT_ONE;
    s.lights[0].outer = 20 * GLINT_ONE;
    region_judge_viewers(&s, figures);
}

const region light_regions[] = {
    {"sums of up to 144", "bytes added without clamp", REGION_STEPS,
     "sums in 32 bits, where all that a scene may ask for fits, and clamps once", 200, measure_sums},
    {"weights of 4, every level passed", "bytes multiplied without clamp", REGION_STEPS, "the same", 200,
     measure_bright_slopes},
    {"attenuation at distance 0", "1/d^2 in Q16", REGION_STEPS,
     "1 / (1 + a d + b d^2) by one division, sizes brought together", 200, measure_no_distance},
    {"light on the surface, at the eye", "direction over a length squared in Q16", REGION_STEPS,
     "scales each direction to its own size; nearer than 1/32768 of the way to the eye a light adds nothing", 200,
     measure_touching},
    {"lamp 3 pixels from a surface 1000 times as far as the nearest", "1/w in Q25, relative to the nearest geometry",
     REGION_STEPS, "keeps 6 bits more of a far corner's 1/w, and its triangle's plane in 30 bits", 2, measure_far_lamp},
    {"light inside the object", "N.L without its sign", REGION_STEPS, "skips what faces away from the light", 200,
     measure_inside},
    {"soft edge of a spot, 10 to 20 degrees", "cosine in 8 bits", REGION_STEPS, "cosine of 15-bit unit vectors", 10,
     measure_spot},
};
const unsigned light_region_count = sizeof light_regions / sizeof light_regions[0];
