/* SPDX-License-Identifier: MIT */
#include "checksummed.h"

#include "domains.h"
#include "every_format.h"
#include "harness.h"
#include "math/numeric.h"

/* ---- Pictures ------------------------------------------------------------------------------------------------ */

/* A number below `count`, of what is left of a larger one. */
static uint32_t take(uint32_t *left, uint32_t count) {
    const uint32_t taken = *left % count;
    *left /= count;
    return taken;
}

static void scale(glint_object *object, glint_q16 x, glint_q16 y, glint_q16 z) {
    const glint_pose scaling = glint_pose_scale(x, y, z);
    object->pose = glint_pose_then(&scaling, &object->pose);
}

static void place(glint_object *object, glint_q16 x, glint_q16 y, glint_q16 z) {
    object->pose.m[0][3] = x;
    object->pose.m[1][3] = y;
    object->pose.m[2][3] = z;
}

/* A floor from behind the eye to the horizon, in colours of either kind or in none. */
static void set_floor(fixture *f, uint32_t colours) {
    static const uint8_t corners[4][3] = {{255, 0, 20}, {0, 255, 130}, {255, 250, 255}, {3, 0, 255}};
    static const uint16_t corners565[4] = {0xf800, 0x07ff, 0x8c51, 0xffff};
    f->objects[0].mesh = &f->floor;
    f->objects[0].pose = glint_pose_translate(3 * GLINT_ONE, -GLINT_ONE, -5 * GLINT_ONE);
    f->floor.colours = colours == 1 ? corners : 0;
    f->floor.colours565 = colours == 2 ? corners565 : 0;
}

/* What is seen, and from where: close by normals turn far from pixel to pixel, others are clipped, or mirrored. */
static void set_object(fixture *f, uint32_t kind) {
    glint_object *const object = &f->objects[0];
    switch (kind) {
    case 0:
        place(object, 0, 0, GLINT_Q16(-1.9));
        break;
    case 1:
        scale(object, GLINT_ONE, GLINT_ONE, GLINT_Q16(0.4));
        place(object, 0, 0, GLINT_Q16(-1.7));
        break;
    case 2:
        place(object, GLINT_ONE / 5, GLINT_ONE / 10, GLINT_Q16(-0.7));
        f->scene.camera.near_plane = GLINT_Q16(0.3);
        f->torus.flags = GLINT_MESH_DOUBLE_SIDED;
        break;
    case 3:
        scale(object, 30 * GLINT_ONE, 30 * GLINT_ONE, 30 * GLINT_ONE);
        place(object, -30 * GLINT_ONE, 20 * GLINT_ONE, -20 * GLINT_ONE);
        break;
    case 4:
        scale(object, -GLINT_ONE, GLINT_ONE / 3, GLINT_ONE);
        f->torus.flags = GLINT_MESH_DOUBLE_SIDED;
        break;
    case 5:
        f->scene.object_count = 2;
        f->objects[1].pose = glint_pose_rotate_x(GLINT_Q16(33.3));
        place(&f->objects[1], GLINT_ONE / 2, 0, GLINT_Q16(-3.6));
        break;
    default:
        set_floor(f, kind - 6);
        break;
    }
}

/* Suns from before, beside and behind, eight of them, or a lamp. */
static void set_lights(fixture *f, uint32_t kind) {
    static const glint_vector directions[3] = {{GLINT_Q16(-0.3), GLINT_Q16(-0.6), -GLINT_ONE},
                                               {-GLINT_ONE, GLINT_Q16(-0.3), GLINT_Q16(-0.3)},
                                               {GLINT_Q16(-0.9), GLINT_Q16(-0.3), GLINT_Q16(0.3)}};
    glint_light *const light = &f->lights[0];
    light->direction = directions[kind % 3];
    if (kind == 3) {
        f->scene.light_count = GLINT_LIGHTS_MAX;
        for (int i = 0; i < GLINT_LIGHTS_MAX; i++) {
            f->lights[i].direction =
                (glint_vector){-glint_cos(45 * i * GLINT_ONE), -glint_sin(45 * i * GLINT_ONE), (2 - i) * 9000};
            f->lights[i].diffuse = (glint_colour){GLINT_ONE / (1 + i), GLINT_ONE / (8 - i), GLINT_ONE / 4};
        }
    } else if (kind > 3) {
        light->type = kind == 4 ? &glint_light_point : &glint_light_spot;
        light->position = (glint_vector){GLINT_ONE, GLINT_Q16(1.2), GLINT_Q16(-2.4)};
        light->direction = (glint_vector){-GLINT_ONE, -GLINT_ONE, -GLINT_ONE};
        light->linear = GLINT_ONE / 8;
        light->quadratic = GLINT_ONE / 16;
        light->inner = 15 * GLINT_ONE;
        light->outer = 40 * GLINT_ONE;
    }
}

static void set_screen(fixture *f, uint32_t format, uint32_t size) {
    static const uint16_t sizes[4][2] = {{FIXTURE_WIDTH, FIXTURE_HEIGHT}, {61, 29}, {1, 1024}, {41, 31}};
    f->config.format =
        format_is_paged(every_format[format]) ? &glint_format_grey4 : every_format[format]; /* rows alone */
    size = glint_row_bytes(f->config.format, 1) == 3 ? 3 : size;
    f->config.width = sizes[size][0];
    f->config.height = sizes[size][1];
}

/* Takes each thing that a scene may have from a number that a picture's own is spread to (Knuth's multiplicative hash).
 */
void checksummed_set_up(uint32_t number, fixture *f) {
    static const glint_shading_model *const models[6] = {&glint_model_blinn_phong, &glint_model_blinn_phong,
                                                         &glint_model_blinn_phong, &glint_model_phong,
                                                         &glint_model_lambert,     &glint_model_unlit};
    static const glint_q16 exponents[8] = {0,
                                           GLINT_ONE / 2,
                                           2 * GLINT_ONE,
                                           12 * GLINT_ONE,
                                           GLINT_Q16(77.7),
                                           256 * GLINT_ONE,
                                           1024 * GLINT_ONE,
                                           8192 * GLINT_ONE};
    const glint_evaluation *const evaluations[4] = {&glint_per_fragment, &glint_per_fragment, &glint_per_vertex,
                                                    &glint_per_facet};
    uint32_t left = number * 2654435761u;
    set_screen(f, number % FORMAT_COUNT, number / FORMAT_COUNT % 3);
    set_object(f, take(&left, 9));
    set_lights(f, take(&left, 6));
    f->scene.viewer = take(&left, 2) ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
    f->materials[0].model = models[take(&left, 6)];
    f->materials[0].shininess = exponents[take(&left, 8)];
    f->materials[0].flags = take(&left, 8) % 5 % 4;
    f->objects[0].evaluation = evaluations[take(&left, 4)];
    f->materials[0].specular.g = take(&left, 4) ? GLINT_ONE / 2 : 4 * GLINT_ONE; /* which saturates */
}

static uint32_t pictures(uint32_t first, uint32_t count) {
    uint32_t checksum = FIXTURE_CHECKSUM_START;
    for (uint32_t i = 0; i < count; i++) {
        fixture *const f = fixture_begin();
        checksummed_set_up(first + i, f);
        CHECK_EQUAL(fixture_render(f), GLINT_OK);
        checksum = (checksum ^ fixture_checksum(f)) * 16777619u;
    }
    return checksum;
}

/* ---- Textures ---- */

/* Texels of one byte and of two; those of a byte are numbers of a palette, too. */
static const uint8_t small_texels[64] = {0,  9, 15, 2,  7, 7,  12, 4, 1, 8, 14, 3,  6,  5, 13, 11, 10, 0, 9,  15, 2, 7,
                                         12, 4, 4,  8,  1, 14, 3,  6, 5, 5, 13, 11, 10, 0, 2,  7,  9,  1, 15, 12, 8, 4,
                                         14, 6, 3,  13, 0, 11, 10, 5, 9, 2, 7,  12, 15, 4, 8,  1,  14, 3, 13, 6};
static const uint16_t large_texels[16] = {0x0000, 0xffff, 0xf800, 0x07e0, 0x001f, 0x8410, 0xfbe0, 0x1234,
                                          0x07e0, 0x9cd3, 0x4208, 0xc618, 0x867d, 0xa145, 0x3a69, 0x07e0};

/* Lets the first object wear a texture. Any numbers serve as coordinates: positions are. */
static void set_texture(fixture *f, uint32_t kind, glint_texture *texture) {
    static const glint_texture_type *const types[4] = {&glint_texture_rgb565, &glint_texture_palette256,
                                                       &glint_texture_palette16, &glint_texture_grey8};
    glint_mesh *const mesh = f->objects[0].mesh == &f->floor ? &f->floor : &f->torus;
    const uint32_t type = kind % 4;
    *texture = (glint_texture){types[type],
                               type ? (const void *)small_texels : (const void *)large_texels,
                               type == 1 || type == 2 ? large_texels : 0,
                               (uint16_t)(type ? 16u >> kind / 4 % 3 : 4u),
                               (uint16_t)(type ? 4u << kind / 4 % 3 : 4u),
                               0,
                               0};
    mesh->texture_coordinates = (const int16_t(*)[2])(const void *)mesh->positions;
    mesh->texture_offset[0] = INT32_MIN + (int32_t)kind * 30000;
    mesh->texture_extent[0] = (3 + (int32_t)kind) * GLINT_ONE / 2;
    mesh->texture_extent[1] = GLINT_ONE / 3 << kind % 6;
    f->materials[0].texture = texture;
    f->materials[0].flags |= kind / 2 % 4 * GLINT_MATERIAL_CLAMP;
    texture->flags = (uint16_t)(kind % 3 ? 0 : GLINT_TEXTURE_HAS_KEY);
    texture->key = type ? 7 : 0x07e0;
}

static uint32_t textures(void) {
    uint32_t checksum = FIXTURE_CHECKSUM_START;
    for (uint32_t i = 0; i < 24; i++) {
        fixture *const f = fixture_begin();
        glint_texture texture;
        checksummed_set_up(5 * i + 1, f);
        set_texture(f, i, &texture);
        CHECK_EQUAL(fixture_render(f), GLINT_OK);
        checksum = (checksum ^ fixture_checksum(f)) * 16777619u;
    }
    return checksum;
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

/* The functions of one argument come last, over their whole domains at as many arguments. */
#define DOMAIN_ARGUMENTS 4096

typedef struct entry {
    const char *name;
    uint32_t (*compute)(void);
} entry;

static const entry entries[] = {{"textures", textures},
                                {"elementary_functions", elementary_functions},
                                {"unit_vectors", unit_vectors},
                                {"poses", poses},
                                {"cameras", cameras}};

enum { GROUPS = CHECKSUMMED_PICTURES / CHECKSUMMED_GROUP, NUMBERS = GROUPS + TEST_COUNT(entries) };

const unsigned checksummed_count = NUMBERS + DOMAIN_COUNT;

const char *checksummed_name(unsigned index) {
    return index < GROUPS ? "pictures" : index < NUMBERS ? entries[index - GROUPS].name : domains[index - NUMBERS].name;
}

uint32_t checksummed_compute(unsigned index) {
    if (index >= NUMBERS)
        return domain_checksum(&domains[index - NUMBERS], DOMAIN_ARGUMENTS);
    return index < GROUPS ? pictures(index * CHECKSUMMED_GROUP, CHECKSUMMED_GROUP) : entries[index - GROUPS].compute();
}
