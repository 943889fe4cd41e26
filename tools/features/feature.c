/* SPDX-License-Identifier: MIT */
/*
 * Firmware that draws the torus of 576 triangles with one feature, chosen by the macros below when it is compiled, and
 * says how many instructions a frame of 320x240 and one of 128x64 take. What they are without a definition is the base
 * that features are held against.
 */
#include "../bench/counter.h"
#include "../bench/framebuffer.h"
#include "board.h"
#include "glint_extras.h"
#include "text.h"

#include <bench_scenes.h>

#ifndef FEATURE_MODEL
#define FEATURE_MODEL glint_model_blinn_phong
#endif
#ifdef FEATURE_LIGHT
#define FEATURE_DIRECTION_Z (-GLINT_Q16(3))
#else
#define FEATURE_LIGHT glint_light_directional
#define FEATURE_DIRECTION_Z bench_light.direction.z
#endif
#ifndef FEATURE_EVALUATION
#define FEATURE_EVALUATION glint_per_fragment
#endif
#ifndef FEATURE_EVALUATION_POINTER
#define FEATURE_EVALUATION_POINTER &FEATURE_EVALUATION
#endif
#ifndef FEATURE_FORMAT
#define FEATURE_FORMAT glint_format_rgb565
#endif
#ifndef FEATURE_VIEWER
#define FEATURE_VIEWER GLINT_VIEWER_INFINITE
#endif
#ifndef FEATURE_MATERIAL_FLAGS
#define FEATURE_MATERIAL_FLAGS 0
#endif
#ifndef FEATURE_MESH
#define FEATURE_MESH torus576_mesh
#endif
#ifndef FEATURE_MESH_FLAGS
#define FEATURE_MESH_FLAGS 0
#endif
#ifndef FEATURE_COLOURS
#define FEATURE_COLOURS 0
#endif
#ifndef FEATURE_COLOURS565
#define FEATURE_COLOURS565 0
#endif
#ifndef FEATURE_GAMMA
#define FEATURE_GAMMA 0
#endif
#ifndef FEATURE_LIGHTS
#define FEATURE_LIGHTS 1
#endif
#ifndef FEATURE_BLEND
#define FEATURE_BLEND GLINT_BLEND_NONE
#endif
#ifndef FEATURE_LAYERS
#define FEATURE_LAYERS 0
#endif
#ifndef FEATURE_SAMPLES
#define FEATURE_SAMPLES 0
#endif
/* A function that is named and not called while instructions are counted. */
#ifndef FEATURE_FUNCTION
#define FEATURE_FUNCTION 0
#endif

enum { WIDTH_MAX = 320, HEIGHT_MAX = 240, PIXEL_MAX = 3 };

static const uint16_t sizes[][2] = {{WIDTH_MAX, HEIGHT_MAX}, {128, 64}};
enum { SIZES = sizeof sizes / sizeof sizes[0] };

static uint32_t arena[(1 << 18) / sizeof(uint32_t)];
static uint8_t framebuffer[WIDTH_MAX * HEIGHT_MAX * PIXEL_MAX];

/* As many as the mesh has vertices. */
enum { VERTICES = 288 };
extern uint8_t feature_colours[VERTICES][3];
extern uint16_t feature_colours565[VERTICES];
uint8_t feature_colours[VERTICES][3];
uint16_t feature_colours565[VERTICES];

/* The base's mesh, and nothing that its clusters need. */
extern const glint_mesh feature_plain_mesh;
const glint_mesh feature_plain_mesh = {.positions = torus576_positions,
                                       .normals = torus576_normals,
                                       .triangles = torus576_triangles,
                                       .vertex_count = sizeof torus576_positions / sizeof torus576_positions[0],
                                       .triangle_count = sizeof torus576_triangles / sizeof torus576_triangles[0],
                                       .extent = {GLINT_Q16(1.5), GLINT_Q16(1.5), GLINT_Q16(0.5)}};

/* The same in smaller types, filled as the program starts: none but what a mesh that is drawn names is linked. Indices
 * of 8 bits do not reach all vertices: that mesh is linked and not drawn. */
enum { TRIANGLES = sizeof torus576_triangles / sizeof torus576_triangles[0] };
static int8_t small_positions[VERTICES][3], small_normals[VERTICES][2];
static uint8_t small_triangles[TRIANGLES][3];
static const glint_mesh_layout positions_layout = {.positions = {&glint_attribute_int8, small_positions, 0}};
static const glint_mesh_layout octahedral8_layout = {.normals = {&glint_attribute_octahedral8, small_normals, 0}};
static const glint_mesh_layout indices_layout = {.triangles = {&glint_attribute_uint8, small_triangles, 0}};

#define SMALLER_MESH(name, positions_or_null, normals_or_null, triangles_or_null, of)    \
    extern const glint_mesh name;                                                        \
    const glint_mesh name = {.positions = (positions_or_null),                           \
                             .normals = (normals_or_null),                               \
                             .triangles = (triangles_or_null),                           \
                             .vertex_count = VERTICES,                                   \
                             .triangle_count = TRIANGLES,                                \
                             .extent = {GLINT_Q16(1.5), GLINT_Q16(1.5), GLINT_Q16(0.5)}, \
                             .layout = &(of)}
SMALLER_MESH(feature_positions8_mesh, 0, torus576_normals, torus576_triangles, positions_layout);
SMALLER_MESH(feature_octahedral8_mesh, torus576_positions, 0, torus576_triangles, octahedral8_layout);
SMALLER_MESH(feature_indices8_mesh, torus576_positions, torus576_normals, 0, indices_layout);

/* Every vertex shows the place of a texture of 64x64 that lies before it; both are filled as the program starts. */
static int16_t coordinates[VERTICES][2];
static uint16_t texels[64 * 64], palette[256];
#ifdef FEATURE_TEXTURE
static const glint_texture feature_texture = {
    .type = &FEATURE_TEXTURE, .texels = texels, .palette = palette, .width = 64, .height = 64};
#define FEATURE_TEXTURE_POINTER &feature_texture
#else
#define FEATURE_TEXTURE_POINTER 0
#endif

/* From before the torus to behind it. */
#ifdef FEATURE_FOG
static const glint_fog feature_fog = {
    .type = &FEATURE_FOG, .colour = GLINT_COLOUR(0.25, 0.25, 0.25), .start = GLINT_Q16(2.5), .end = GLINT_Q16(5.5)};
#define FEATURE_FOG_POINTER &feature_fog
#else
#define FEATURE_FOG_POINTER 0
#endif

/* Every output goes through a table; what it holds is no matter. */
extern const uint16_t feature_gamma[3][GLINT_GAMMA_ENTRIES];
const uint16_t feature_gamma[3][GLINT_GAMMA_ENTRIES] = {{0, 65535}, {0, 65535}, {0, 65535}};

/* What the base names, so that firmware can have both. */
static const void *volatile feature_base[] = {
#ifdef FEATURE_WITH_BASE
    &glint_model_blinn_phong, &glint_light_directional, &glint_per_fragment, &glint_format_rgb565,
#endif
    0};

typedef void feature_function(void);
static feature_function *volatile feature_named;

static int copy_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const glint_config *config = context;
    const size_t pitch = glint_row_bytes(&FEATURE_FORMAT, config->width),
                 left = glint_row_bytes(&FEATURE_FORMAT, (uint32_t)x);

    framebuffer_copy(framebuffer + (size_t)y * pitch + left, pitch, pixels, stride,
                     glint_row_bytes(&FEATURE_FORMAT, (uint32_t)width), height);
    return 0;
}

/* Every vertex has a colour of its own, none of them black: black would take fewer instructions. */
static void set_colours(void) {
    for (unsigned i = 0; i < VERTICES; i++) {
        uint8_t *colour = feature_colours[i];
        for (unsigned channel = 0; channel < 3; channel++) {
            colour[channel] = (uint8_t)(128 + (37 * i + 41 * channel) % 128);
        }
        feature_colours565[i] = (uint16_t)(colour[0] >> 3 << 11 | colour[1] >> 2 << 5 | colour[2] >> 3);
    }
}

static void set_texture(void) {
    for (unsigned i = 0; i < VERTICES; i++) {
        coordinates[i][0] = torus576_positions[i][0];
        coordinates[i][1] = torus576_positions[i][1];
    }
    for (unsigned i = 0; i < sizeof texels / sizeof texels[0]; i++) {
        texels[i] = (uint16_t)(40503 * i);
    }
    for (unsigned i = 0; i < sizeof palette / sizeof palette[0]; i++) {
        palette[i] = (uint16_t)(40503 * i);
    }
}

static int32_t magnitude(int32_t x) {
    return x < 0 ? -x : x;
}

/* The point of the octahedron in a normal's direction, `one` for 1, folded where z < 0. */
static void encode(const int16_t normal[3], int32_t one, int16_t code[2]) {
    const int32_t sum = magnitude(normal[0]) + magnitude(normal[1]) + magnitude(normal[2]);
    const int32_t x = normal[0] * one / sum;
    const int32_t y = normal[1] * one / sum;
    const int32_t fold_x = normal[0] < 0 ? magnitude(y) - one : one - magnitude(y);
    const int32_t fold_y = normal[1] < 0 ? magnitude(x) - one : one - magnitude(x);

    code[0] = (int16_t)(normal[2] < 0 ? fold_x : x);
    code[1] = (int16_t)(normal[2] < 0 ? fold_y : y);
}

static void set_smaller(void) {
    for (unsigned i = 0; i < VERTICES; i++) {
        int16_t code[2];
        for (unsigned axis = 0; axis < 3; axis++) {
            small_positions[i][axis] = (int8_t)(torus576_positions[i][axis] / 256);
        }
        encode(torus576_normals[i], 127, code);
        small_normals[i][0] = (int8_t)code[0];
        small_normals[i][1] = (int8_t)code[1];
    }
}

/* The second shines from the other side, so that triangles are lit by both, by either and by none. */
static void set_lights(glint_light lights[FEATURE_LIGHTS]) {
    for (int i = 0; i < FEATURE_LIGHTS; i++) {
        lights[i] = bench_light;
        lights[i].type = &FEATURE_LIGHT;
        lights[i].direction.x = i == 0 ? bench_light.direction.x : -bench_light.direction.x;
        lights[i].position = (glint_vector){-lights[i].direction.x, -lights[i].direction.y, -lights[i].direction.z};
        lights[i].direction.z = FEATURE_DIRECTION_Z;
        lights[i].linear = GLINT_Q16(0.25);
        lights[i].inner = GLINT_Q16(20);
        lights[i].outer = GLINT_Q16(40);
    }
}

static void set_config(glint_config *config, const uint16_t size[2]) {
    config->width = size[0];
    config->height = size[1];
    config->format = &FEATURE_FORMAT;
    config->arena = arena;
    config->arena_size = sizeof arena;
    config->keeps_arena = 1;
    config->flush.begin = copy_tile;
    config->flush.context = config;
    config->gamma = FEATURE_GAMMA;
    config->layers = FEATURE_LAYERS;
    config->samples = FEATURE_SAMPLES;
}

static void set_camera(glint_camera *camera) {
    camera->pose.m[0][0] = camera->pose.m[1][1] = camera->pose.m[2][2] = GLINT_ONE;
    camera->field_of_view = BENCH_FIELD_OF_VIEW;
    camera->near_plane = BENCH_NEAR_PLANE;
}

/* @return ticks that the ten frames take, 0 after an error */
static uint32_t draw_frames(const glint_config *config, const glint_scene *scene, glint_object *object) {
    glint_renderer renderer;
    uint32_t ticks = 0;

    for (int frame = 0; frame < BENCH_FRAMES; frame++) {
        object->pose = torus576_poses[frame];
        const uint32_t start = counter_now();
        if ((frame == 0 && glint_init(&renderer, config) != GLINT_OK) || glint_render(&renderer, scene) != GLINT_OK) {
            return 0;
        }
        ticks += counter_ticks_since(start);
    }
    return ticks;
}

/* Writes what a frame takes. @return not 0 after an error */
static int report(const glint_scene *scene, glint_object *object, const uint16_t size[2]) {
    char digits[TEXT_NUMBER_SIZE];
    glint_config config = {0};

    set_config(&config, size);
    const uint32_t ticks = draw_frames(&config, scene, object);
    board_write(text_number(digits, ticks * (COUNTER_INSTRUCTIONS_PER_TICK / BENCH_FRAMES)));
    board_write("\n");
    return ticks == 0;
}

int main(void) {
    glint_mesh mesh = FEATURE_MESH;
    glint_material material = bench_material;
    glint_light lights[FEATURE_LIGHTS];
    glint_object object = {.mesh = &mesh, .material = &material, .evaluation = FEATURE_EVALUATION_POINTER};
    glint_scene scene = {.viewer = FEATURE_VIEWER,
                         .ambient = {BENCH_AMBIENT, BENCH_AMBIENT, BENCH_AMBIENT},
                         .lights = lights,
                         .light_count = FEATURE_LIGHTS,
                         .objects = &object,
                         .object_count = 1,
                         .fog = FEATURE_FOG_POINTER};
    int failed = 0;

    mesh.flags = FEATURE_MESH_FLAGS;
    mesh.colours = (const uint8_t(*)[3])FEATURE_COLOURS;
    mesh.colours565 = FEATURE_COLOURS565;
    material.texture = FEATURE_TEXTURE_POINTER;
    if (material.texture) {
        mesh.texture_coordinates = (const int16_t(*)[2])coordinates;
        mesh.texture_extent[0] = mesh.texture_extent[1] = GLINT_ONE;
        material.diffuse = (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE};
    }
    material.model = &FEATURE_MODEL;
    material.flags = FEATURE_MATERIAL_FLAGS;
    material.blend = FEATURE_BLEND;
    material.opacity = GLINT_ONE / 2;
    feature_named = (feature_function *)FEATURE_FUNCTION;
    (void)feature_base[0];
    set_colours();
    set_smaller();
    set_texture();
    set_lights(lights);
    set_camera(&scene.camera);
    counter_start();
    for (int i = 0; i < SIZES && !failed; i++) {
        failed = report(&scene, &object, sizes[i]);
    }
    return failed;
}
