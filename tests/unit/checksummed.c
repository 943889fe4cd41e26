/* SPDX-License-Identifier: MIT */
#include "checksummed.h"

#include "domains.h"
#include "harness.h"
#include "math/numeric.h"

typedef struct entry {
    const char *name;
    void (*set_up)(fixture *f); /* of an image */
    uint32_t (*compute)(void);  /* of numbers */
} entry;

/* ---- Images -------------------------------------------------------------------------------------------------- */

static glint_colour colour(glint_q16 r, glint_q16 g, glint_q16 b) {
    const glint_colour result = {r, g, b};
    return result;
}

static void place(glint_object *object, glint_q16 x, glint_q16 y, glint_q16 z) {
    object->pose.m[0][3] = x;
    object->pose.m[1][3] = y;
    object->pose.m[2][3] = z;
}

static void scale(glint_object *object, glint_q16 x, glint_q16 y, glint_q16 z) {
    glint_pose scaling = glint_pose_scale(x, y, z);
    object->pose = glint_pose_then(&scaling, &object->pose);
}

static void local_viewer(fixture *f) {
    f->scene.viewer = GLINT_VIEWER_LOCAL;
}

static void infinite_viewer(fixture *f) {
    f->scene.viewer = GLINT_VIEWER_INFINITE;
}

static void exponent_half(fixture *f) {
    f->materials[0].shininess = GLINT_ONE / 2;
}

static void exponent_two(fixture *f) {
    f->materials[0].shininess = 2 * GLINT_ONE;
}

static void exponent_1024(fixture *f) {
    f->materials[0].shininess = 1024 * GLINT_ONE;
    infinite_viewer(f);
}

static void exponents_beyond(fixture *f) {
    f->scene.object_count = 3;
    place(&f->objects[1], -2 * GLINT_ONE, 0, -4 * GLINT_ONE);
    place(&f->objects[2], 2 * GLINT_ONE, 0, -4 * GLINT_ONE);
    f->materials[0].shininess = 0;
    f->materials[1].shininess = GLINT_Q16(77.7);
    f->materials[2].shininess = INT32_MAX;
}

/* Triangles of many pixels whose normals turn far, lit from beside and behind: the terminator crosses the highlight. */
static void curved(fixture *f) {
    f->objects[0].pose.m[2][3] = GLINT_Q16(-1.9);
    f->lights[0].direction = (glint_vector){GLINT_Q16(-0.9), GLINT_Q16(-0.3), GLINT_Q16(0.3)};
    f->materials[0].shininess = 12 * GLINT_ONE;
    local_viewer(f);
}

static void curved_infinite(fixture *f) {
    curved(f);
    infinite_viewer(f);
}

static void curved_exponent_8192(fixture *f) {
    curved(f);
    f->lights[0].direction = (glint_vector){GLINT_Q16(-0.3), GLINT_Q16(-0.6), -GLINT_ONE};
    f->materials[0].shininess = 8192 * GLINT_ONE;
    infinite_viewer(f);
}

static void curved_exponent_1024(fixture *f) {
    curved_exponent_8192(f);
    f->materials[0].shininess = 1024 * GLINT_ONE;
    local_viewer(f);
}

/* Flattened: between top and bottom normals turn less far, so that lighting is interpolated. */
static void curved_gently(fixture *f) {
    curved(f);
    scale(&f->objects[0], GLINT_ONE, GLINT_ONE, GLINT_Q16(0.4));
    f->objects[0].pose.m[2][3] = GLINT_Q16(-1.9);
    f->lights[0].direction = (glint_vector){-GLINT_ONE, GLINT_Q16(-0.3), GLINT_Q16(-0.3)};
}

static void curved_gently_infinite(fixture *f) {
    curved_gently(f);
    f->objects[0].pose.m[2][3] = GLINT_Q16(-1.7);
    infinite_viewer(f);
}

static void curved_gently_exponent_256(fixture *f) {
    curved_gently(f);
    f->lights[0].direction = (glint_vector){GLINT_Q16(-0.3), GLINT_Q16(-0.6), -GLINT_ONE};
    f->materials[0].shininess = 256 * GLINT_ONE;
    infinite_viewer(f);
}

static void eight_lights(fixture *f) {
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++) {
        const glint_vector direction = {-glint_cos(45 * i * GLINT_ONE), -glint_sin(45 * i * GLINT_ONE), (2 - i) * 9000};
        f->lights[i].direction = direction;
        f->lights[i].diffuse = colour(GLINT_ONE / (1 + i), GLINT_ONE / (8 - i), GLINT_ONE / 4);
    }
    f->scene.light_count = GLINT_LIGHTS_MAX;
}

static void eight_lights_infinite(fixture *f) {
    eight_lights(f);
    infinite_viewer(f);
}

static void saturated(fixture *f) {
    eight_lights(f);
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++)
        f->lights[i].specular = colour(4 * GLINT_ONE, 4 * GLINT_ONE, 4 * GLINT_ONE);
    f->materials[0].specular = colour(4 * GLINT_ONE, 4 * GLINT_ONE, GLINT_ONE);
    f->materials[0].ambient = colour(GLINT_COLOUR_MAX, 0, 0);
}

static void near_plane(fixture *f) {
    place(&f->objects[0], GLINT_ONE / 5, GLINT_ONE / 10, GLINT_Q16(-0.7));
    f->scene.camera.near_plane = GLINT_Q16(0.3);
}

static void floor_to_horizon(fixture *f) {
    f->objects[0].mesh = &f->floor;
    f->objects[0].pose = glint_pose_translate(3 * GLINT_ONE, -GLINT_ONE, -5 * GLINT_ONE);
}

/* Two triangles of hundreds of pixels, each in many tiles, with a highlight of their own. */
static void large_highlight(fixture *f) {
    const glint_pose up = glint_pose_rotate_x(75 * GLINT_ONE), turn = glint_pose_rotate_y(10 * GLINT_ONE);
    const glint_pose small = glint_pose_scale(GLINT_ONE / 60, GLINT_ONE / 60, GLINT_ONE / 60);
    const glint_pose stand = glint_pose_then(&small, &up);
    f->objects[0].mesh = &f->floor;
    f->objects[0].pose = glint_pose_then(&stand, &turn);
    f->objects[0].pose.m[2][3] = -12 * GLINT_ONE;
    f->scene.camera.field_of_view = 12 * GLINT_ONE;
    f->lights[0].direction = (glint_vector){GLINT_Q16(-0.3), GLINT_Q16(-0.5), -GLINT_ONE};
    f->materials[0].shininess = 32 * GLINT_ONE;
    f->materials[0].specular = colour(GLINT_ONE / 4, GLINT_ONE / 4, GLINT_ONE / 4);
    f->config.tile_width = f->config.tile_height = 8;
    local_viewer(f);
}

static void guard_band(fixture *f) {
    scale(&f->objects[0], 30 * GLINT_ONE, 30 * GLINT_ONE, 30 * GLINT_ONE);
    place(&f->objects[0], -30 * GLINT_ONE, 20 * GLINT_ONE, -20 * GLINT_ONE);
}

static void mirrored_double_sided(fixture *f) {
    f->torus.flags = GLINT_MESH_DOUBLE_SIDED;
    scale(&f->objects[0], -GLINT_ONE, GLINT_ONE, GLINT_ONE);
}

static void squashed(fixture *f) {
    scale(&f->objects[0], GLINT_ONE, GLINT_ONE / 100, GLINT_ONE);
}

static void interlocked(fixture *f) {
    f->scene.object_count = 2;
    f->objects[1].pose = glint_pose_rotate_x(GLINT_Q16(33.3));
    place(&f->objects[1], GLINT_ONE / 2, 0, GLINT_Q16(-3.6));
    f->materials[1].diffuse = colour(GLINT_ONE / 5, GLINT_ONE / 2, GLINT_ONE);
}

static void turned_camera(fixture *f) {
    const glint_vector eye = {GLINT_Q16(3.3), GLINT_Q16(1.9), GLINT_Q16(-1.5)};
    const glint_vector at = {GLINT_Q16(0.1), 0, GLINT_Q16(-3.7)};
    const glint_vector up = {0, GLINT_ONE, 0};
    glint_camera_look_at(&f->scene.camera, eye, at, up);
}

static void no_objects(fixture *f) {
    f->scene.object_count = 0;
    f->scene.objects = 0;
}

static void big_endian(fixture *f) {
    f->config.format = &glint_format_rgb565_be;
}

static void rgb888_odd_size(fixture *f) {
    f->config.format = &glint_format_rgb888;
    f->config.width = 41;
    f->config.height = 31;
}

static void grey8_odd_size(fixture *f) {
    f->config.format = &glint_format_grey8;
    f->config.width = 61;
}

static void grey4_odd_size(fixture *f) {
    f->config.format = &glint_format_grey4;
    f->config.width = 61;
    f->config.height = 29;
}

static void rgb444_odd_size(fixture *f) {
    f->config.format = &glint_format_rgb444;
    f->config.width = 61;
    f->config.height = 29;
}

static void tall_and_thin(fixture *f) {
    f->config.width = 1;
    f->config.height = 1024;
}

static void one_pixel(fixture *f) {
    f->config.width = f->config.height = 1;
}

/* ---- Models, lights and evaluations -------------------------------------------------------------------------- */

static void point_light(fixture *f) {
    const glint_vector position = {GLINT_ONE, GLINT_Q16(1.2), GLINT_Q16(-2.4)};
    f->lights[0].type = &glint_light_point;
    f->lights[0].position = position;
    f->lights[0].linear = GLINT_ONE / 8;
    f->lights[0].quadratic = GLINT_ONE / 16;
}

static void spot_phong(fixture *f) {
    const glint_vector direction = {-GLINT_ONE, -GLINT_ONE, -GLINT_ONE};
    point_light(f);
    f->lights[0].type = &glint_light_spot;
    f->lights[0].direction = direction;
    f->lights[0].inner = 15 * GLINT_ONE;
    f->lights[0].outer = 40 * GLINT_ONE;
    f->materials[0].model = &glint_model_phong;
}

static void lambert_infinite(fixture *f) {
    f->materials[0].model = &glint_model_lambert;
    infinite_viewer(f);
}

static void phong_ungated_max(fixture *f) {
    f->materials[0].model = &glint_model_phong;
    f->materials[0].flags = GLINT_MATERIAL_SPECULAR_UNGATED | GLINT_MATERIAL_MAX_WITH_AMBIENT;
    f->materials[0].shininess = GLINT_Q16(3.5);
}

static void per_vertex(fixture *f) {
    point_light(f);
    f->objects[0].evaluation = &glint_per_vertex;
}

static void per_vertex_clipped(fixture *f) {
    near_plane(f);
    f->torus.flags = GLINT_MESH_DOUBLE_SIDED;
    f->objects[0].evaluation = &glint_per_vertex;
}

static void per_facet(fixture *f) {
    spot_phong(f);
    f->objects[0].evaluation = &glint_per_facet;
}

static void per_facet_clipped(fixture *f) {
    near_plane(f);
    f->objects[0].evaluation = &glint_per_facet;
}

static void mesh_colours(fixture *f) {
    static const uint8_t corners[4][3] = {{255, 0, 20}, {0, 255, 130}, {255, 250, 255}, {3, 0, 255}};
    floor_to_horizon(f);
    f->floor.colours = corners;
}

static void mesh_colours565_per_vertex(fixture *f) {
    static const uint16_t corners[4] = {0xf800, 0x07ff, 0x8c51, 0xffff};
    floor_to_horizon(f);
    f->floor.colours565 = corners;
    f->objects[0].evaluation = &glint_per_vertex;
}

static void mesh_colours_unlit_facets(fixture *f) {
    mesh_colours(f);
    f->materials[0].model = &glint_model_unlit;
    f->objects[0].evaluation = &glint_per_facet;
}

static void rgb565_dithered(fixture *f) {
    f->config.format = &glint_format_rgb565_dithered;
}

static void grey4_dithered_odd_size(fixture *f) {
    grey4_odd_size(f);
    f->config.format = &glint_format_grey4_dithered;
}

static void rgb444_dithered(fixture *f) {
    f->config.format = &glint_format_rgb444_dithered;
}

static void mono_dithered_odd_size(fixture *f) {
    grey4_odd_size(f);
    f->config.format = &glint_format_mono_dithered;
}

/* ---- Numbers ------------------------------------------------------------------------------------------------- */

static uint32_t add_number(uint32_t checksum, uint32_t number) {
    const uint8_t bytes[4] = {(uint8_t)number, (uint8_t)(number >> 8), (uint8_t)(number >> 16),
                              (uint8_t)(number >> 24)};
    return fixture_checksum_add(checksum, bytes, 4);
}

/* Values spread over all magnitudes, by a linear congruential generator (Numerical Recipes). */
static uint32_t next_value(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return *state >> (*state >> 4 & 31);
}

static uint32_t elementary_functions(void) {
    uint32_t checksum = FIXTURE_CHECKSUM_START;
    uint32_t state = 1;
    for (int i = 0; i < 500; i++) {
        uint32_t x = next_value(&state);
        checksum = add_number(checksum, (uint32_t)glint_sin((int32_t)x));
        checksum = add_number(checksum, (uint32_t)glint_cos(-(int32_t)(x >> 1)));
        checksum = add_number(checksum, glint_power(x >> 1, (int32_t)(next_value(&state) >> 1)));
        checksum = add_number(checksum, glint_reciprocal(x | 0x80000000u));
        checksum = add_number(checksum, (uint32_t)glint_log2(x >> 1));
    }
    return checksum;
}

static uint32_t unit_vectors(void) {
    uint32_t checksum = FIXTURE_CHECKSUM_START;
    uint32_t state = 1;
    for (int i = 0; i < 500; i++) {
        int32_t x = (int32_t)next_value(&state);
        int32_t y = -(int32_t)(next_value(&state) >> 1);
        int16_t unit[3];
        glint_unit(x, y, (int32_t)next_value(&state), unit);
        for (int axis = 0; axis < 3; axis++)
            checksum = add_number(checksum, (uint32_t)unit[axis]);
    }
    return checksum;
}

static uint32_t add_pose(uint32_t checksum, const glint_pose *pose) {
    for (int i = 0; i < 12; i++)
        checksum = add_number(checksum, (uint32_t)pose->m[i / 4][i % 4]);
    return checksum;
}

static uint32_t poses(void) {
    uint32_t checksum = FIXTURE_CHECKSUM_START;
    glint_pose pose = glint_pose_translate(1000, -70000, 3 * GLINT_ONE);
    for (int i = 0; i < 100; i++) {
        glint_pose x = glint_pose_rotate_x(i * 100000);
        glint_pose y = glint_pose_rotate_y(-i * 70000);
        glint_pose z = glint_pose_rotate_z(i * 12345);
        pose = glint_pose_then(&pose, &x);
        pose = glint_pose_then(&y, &pose);
        pose = glint_pose_then(&pose, &z);
        checksum = add_pose(checksum, &pose);
    }
    return checksum;
}

static uint32_t cameras(void) {
    uint32_t checksum = FIXTURE_CHECKSUM_START;
    uint32_t state = 1;
    for (int i = 0; i < 100; i++) {
        glint_vector v[3];
        for (int k = 0; k < 3; k++) {
            v[k].x = (int32_t)next_value(&state);
            v[k].y = (int32_t)next_value(&state);
            v[k].z = (int32_t)next_value(&state);
        }
        glint_camera camera = {{{{0}}}, 0, 0};
        checksum = add_number(checksum, (uint32_t)glint_camera_look_at(&camera, v[0], v[1], v[2]));
        checksum = add_pose(checksum, &camera.pose);
    }
    return checksum;
}

/* ---- Table --------------------------------------------------------------------------------------------------- */

#define IMAGE(function) \
    { #function, function, 0 }
#define NUMBERS(function) \
    { #function, 0, function }

static const entry entries[] = {
    IMAGE(local_viewer),
    IMAGE(infinite_viewer),
    IMAGE(exponent_half),
    IMAGE(exponent_two),
    IMAGE(exponent_1024),
    IMAGE(exponents_beyond),
    IMAGE(curved),
    IMAGE(curved_infinite),
    IMAGE(curved_exponent_8192),
    IMAGE(curved_exponent_1024),
    IMAGE(curved_gently),
    IMAGE(curved_gently_infinite),
    IMAGE(curved_gently_exponent_256),
    IMAGE(eight_lights),
    IMAGE(eight_lights_infinite),
    IMAGE(saturated),
    IMAGE(near_plane),
    IMAGE(floor_to_horizon),
    IMAGE(large_highlight),
    IMAGE(guard_band),
    IMAGE(mirrored_double_sided),
    IMAGE(squashed),
    IMAGE(interlocked),
    IMAGE(turned_camera),
    IMAGE(no_objects),
    IMAGE(big_endian),
    IMAGE(rgb888_odd_size),
    IMAGE(grey8_odd_size),
    IMAGE(grey4_odd_size),
    IMAGE(rgb444_odd_size),
    IMAGE(tall_and_thin),
    IMAGE(one_pixel),
    IMAGE(point_light),
    IMAGE(spot_phong),
    IMAGE(lambert_infinite),
    IMAGE(phong_ungated_max),
    IMAGE(per_vertex),
    IMAGE(per_vertex_clipped),
    IMAGE(per_facet),
    IMAGE(per_facet_clipped),
    IMAGE(mesh_colours),
    IMAGE(mesh_colours565_per_vertex),
    IMAGE(mesh_colours_unlit_facets),
    IMAGE(rgb565_dithered),
    IMAGE(grey4_dithered_odd_size),
    IMAGE(rgb444_dithered),
    IMAGE(mono_dithered_odd_size),
    NUMBERS(elementary_functions),
    NUMBERS(unit_vectors),
    NUMBERS(poses),
    NUMBERS(cameras),
};

/* The functions of one argument follow the entries, over their whole domains at as many arguments. */
#define DOMAIN_ARGUMENTS 4096

const unsigned checksummed_count = TEST_COUNT(entries) + DOMAIN_COUNT;

const char *checksummed_name(unsigned index) {
    return index < TEST_COUNT(entries) ? entries[index].name : domains[index - TEST_COUNT(entries)].name;
}

int checksummed_set_up(unsigned index, fixture *f) {
    if (index >= TEST_COUNT(entries) || !entries[index].set_up)
        return 0;
    entries[index].set_up(f);
    return 1;
}

uint32_t checksummed_compute(unsigned index) {
    fixture *f = fixture_begin();
    if (index >= TEST_COUNT(entries))
        return domain_checksum(&domains[index - TEST_COUNT(entries)], DOMAIN_ARGUMENTS);
    if (!checksummed_set_up(index, f))
        return entries[index].compute();
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    return fixture_checksum(f);
}
