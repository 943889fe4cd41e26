/* SPDX-License-Identifier: MIT */
#include "region.h"

#include "contract.h"
#include "glint_extras.h"
#include "harness.h"
#include "weights.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const glint_format *const formats[2] = {&glint_format_rgb888, &glint_format_rgb565};

const region *region_at(unsigned i, const char **topic) {
    const struct {
        const char *topic;
        const region *rows;
        unsigned count;
    } groups[] = {
        {"highlights", highlight_regions, highlight_region_count},
        {"normals", normal_regions, normal_region_count},
        {"powers", power_regions, power_region_count},
        {"lights", light_regions, light_region_count},
        {"triangles", triangle_regions, triangle_region_count},
        {"poses", pose_regions, pose_region_count},
        {"screens", screen_regions, screen_region_count},
        {"inputs", input_regions, input_region_count},
    };
    for (unsigned group = 0; group < sizeof groups / sizeof groups[0]; group++) {
        if (i < groups[group].count) {
            *topic = groups[group].topic;
            return &groups[group].rows[i];
        }
        i -= groups[group].count;
    }
    return NULL;
}

/* Colours are held to the contract's percentages, all else to the figure itself. */
static void check_format(const region *which, const region_figures *figures, int format) {
    const judgement *found = &figures->found[format];
    char line[200];
    CHECK_EQUAL(found->status, GLINT_OK);
    CHECK_EQUAL(found->missed, 0);
    CHECK_EQUAL(found->spilled, 0);
    CHECK(format == 0 ? judgement_keeps_fine_contract(found) : judgement_keeps_contract(found));
    if (strcmp(which->unit, REGION_STEPS) == 0) {
        CHECK(found->judged > 0);
        return;
    }
    if (figures->library[format] <= figures->bound[format])
        return;
    snprintf(line, sizeof line, "%s: %.3f where %.3f is allowed\n", which->name, figures->library[format],
             figures->bound[format]);
    test_write(line);
    CHECK(figures->library[format] <= figures->bound[format]);
}

void region_check(const region *which, const region_figures *figures) {
    char line[200];
    if (!CHECK(figures->plain >= which->fails)) {
        snprintf(line, sizeof line, "%s: the plain method is off by %.3f only\n", which->name, figures->plain);
        test_write(line);
    }
    check_format(which, figures, 0);
    check_format(which, figures, 1);
}

/* ---- Scenes -------------------------------------------------------------------------------------------------- */

glint_q16 region_q16(double value) {
    return (glint_q16)lrint(value * 65536);
}

static glint_colour grey(double value) {
    return (glint_colour){region_q16(value), region_q16(value), region_q16(value)};
}

void region_light(random_scene *s, double x, double y, double z) {
    if (s->lights[0].type == &glint_light_directional)
        s->lights[0].direction = (glint_vector){region_q16(-x), region_q16(-y), region_q16(-z)};
    else
        s->lights[0].position = (glint_vector){region_q16(x), region_q16(y), region_q16(z)};
}

void region_weights(random_scene *s, double ambient, double diffuse, double specular) {
    s->materials[0].ambient = grey(ambient);
    s->materials[0].diffuse = grey(diffuse);
    s->materials[0].specular = grey(specular);
}

void region_normals(random_scene *s, const double normals[4][3]) {
    for (int i = 0; i < 4; i++) {
        double length =
            sqrt(normals[i][0] * normals[i][0] + normals[i][1] * normals[i][1] + normals[i][2] * normals[i][2]);
        for (int axis = 0; axis < 3; axis++)
            s->meshes[0].normals[i][axis] = (int16_t)lrint(32767 * normals[i][axis] / length);
    }
}

static void begin(random_scene *s) {
    memset(s, 0, sizeof *s);
    s->width = s->height = 64;
    for (int i = 0; i < RANDOM_LIGHTS_MAX; i++) {
        s->lights[i] = (glint_light){.type = &glint_light_directional, .diffuse = grey(1), .specular = grey(1)};
        s->lights[i].direction.z = -GLINT_ONE;
    }
    for (int i = 0; i < RANDOM_OBJECTS_MAX; i++) {
        s->materials[i] = (glint_material){.model = &glint_model_blinn_phong, .shininess = 32 * GLINT_ONE};
        s->objects[i] = (glint_object){.mesh = &s->meshes[0].mesh,
                                       .material = &s->materials[0],
                                       .evaluation = &glint_per_fragment,
                                       .pose = glint_pose_translate(0, 0, -3 * GLINT_ONE)};
    }
    region_weights(s, 0.1, 0.4, 0.5);
    s->scene = (glint_scene){.camera = {glint_pose_identity(), region_q16(36.86989764584402), GLINT_ONE / 10},
                             .ambient = grey(1),
                             .lights = s->lights,
                             .light_count = 1,
                             .objects = s->objects,
                             .object_count = 1};
}

void region_square(random_scene *s) {
    static const int16_t positions[4][3] = {
        {-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}};
    static const int16_t normals[4][3] = {{0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}};
    static const uint16_t triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
    random_mesh *mesh = &s->meshes[0];
    begin(s);
    memcpy(mesh->positions, positions, sizeof positions);
    memcpy(mesh->normals, normals, sizeof normals);
    memcpy(mesh->triangles, triangles, sizeof triangles);
    mesh->mesh = (glint_mesh){.positions = (const int16_t(*)[3])mesh->positions,
                              .normals = (const int16_t(*)[3])mesh->normals,
                              .triangles = (const uint16_t(*)[3])mesh->triangles,
                              .vertex_count = 4,
                              .triangle_count = 2,
                              .extent = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
}

void region_sphere(random_scene *s, uint32_t around, uint32_t along) {
    random_mesh *mesh = &s->meshes[0];
    begin(s);
    const glint_mesh_room room = {mesh->positions, mesh->normals, mesh->triangles, RANDOM_VERTICES_MAX,
                                  RANDOM_TRIANGLES_MAX};
    CHECK_EQUAL(glint_generate_sphere(&mesh->mesh, &room, around, along, GLINT_ONE), GLINT_OK);
    s->objects[0].pose.m[2][3] = -4 * GLINT_ONE;
}

/* ---- Judging ------------------------------------------------------------------------------------------------- */

void region_raise(double *figure, double value) {
    *figure = fmax(*figure, value);
}

static double largest_bound(const random_scene *s, const glint_format *format) {
    double bound = 0;
    for (uint32_t i = 0; i < s->scene.object_count; i++)
        region_raise(&bound, weights_bound(weights_sum(&s->scene, s->objects[i].material), format));
    return bound;
}

void region_judge(const random_scene *s, region_figures *figures) {
    for (int format = 0; format < 2; format++) {
        contract_result result;
        contract_judge(&s->scene, s->width, s->height, formats[format], &result);
        judgement_add(&figures->found[format], &result.found);
        region_raise(&figures->library[format], result.found.worst);
        region_raise(&figures->bound[format], largest_bound(s, formats[format]));
    }
}

void region_judge_viewers(random_scene *s, region_figures *figures) {
    for (int viewer = 0; viewer < 2; viewer++) {
        s->scene.viewer = viewer ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
        region_judge(s, figures);
    }
}

void region_judge_all(const random_scene *s, region_figures *figures) {
    for (int format = 0; format < 2; format++) {
        const judge_task task = {.scene = &s->scene,
                                 .width = s->width,
                                 .height = s->height,
                                 .format = formats[format],
                                 .fine = largest_bound(s, formats[format])};
        judgement found = {0};
        judge(&task, &found);
        judgement_add(&figures->found[format], &found);
        region_raise(&figures->library[format], found.worst);
        region_raise(&figures->bound[format], task.fine);
    }
}

void region_judge_coverage(const random_scene *s, region_figures *figures) {
    region_figures colours = {0};
    region_judge(s, &colours);
    for (int format = 0; format < 2; format++) {
        judgement_add(&figures->found[format], &colours.found[format]);
        region_raise(&figures->library[format], (double)colours.found[format].missed);
    }
}
