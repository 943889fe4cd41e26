/* SPDX-License-Identifier: MIT */
#include "moving.h"
#include "glint_extras.h"

static glint_q16 times(glint_q16 a, glint_q16 b) {
    return (glint_q16)((int64_t)a * b / GLINT_ONE);
}

static glint_q16 between(glint_q16 from, glint_q16 to, glint_q16 weight) {
    return from + times(to - from, weight);
}

static glint_q16 sine_of(glint_q16 degrees) {
    return glint_pose_rotate_z(degrees).m[1][0];
}

/* ---- A wave: one struct a vertex, normals in two bytes, indices in one ---- */

#define SIDE 16 /* vertices, 256 in all */
#define SQUARES (SIDE - 1)

typedef struct wave_vertex {
    int16_t position[3];
    int8_t normal[2]; /* octahedral */
} wave_vertex;

static wave_vertex wave[SIDE][SIDE];
static uint8_t wave_triangles[2 * SQUARES * SQUARES][3];
static const glint_mesh_layout wave_layout = {{&glint_attribute_int16, wave[0][0].position, sizeof(wave_vertex)},
                                              {&glint_attribute_octahedral8, wave[0][0].normal, sizeof(wave_vertex)},
                                              {&glint_attribute_uint8, wave_triangles, 0},
                                              {0, 0, 0}};
static const glint_mesh wave_mesh = {.vertex_count = SIDE * SIDE,
                                     .triangle_count = 2 * SQUARES * SQUARES,
                                     .extent = GLINT_VECTOR(1.2, 0.16, 1.2),
                                     .layout = &wave_layout};

static int32_t magnitude(int32_t x) {
    return x < 0 ? -x : x;
}

/* Two bytes for a normal of components below 2^22: a point of the octahedron, folded where z < 0. */
static void encode(const int32_t n[3], int8_t code[2]) {
    const int32_t sum = magnitude(n[0]) + magnitude(n[1]) + magnitude(n[2]);
    const int32_t x = n[0] * 127 / sum, y = n[1] * 127 / sum;
    const int32_t fold_x = n[0] < 0 ? magnitude(y) - 127 : 127 - magnitude(y),
                  fold_y = n[1] < 0 ? magnitude(x) - 127 : 127 - magnitude(x);
    code[0] = (int8_t)(n[2] < 0 ? fold_x : x);
    code[1] = (int8_t)(n[2] < 0 ? fold_y : y);
}

/* Height at a place of the grid, -1 to 1: between waves that run along it and rings that run out of its middle. */
static glint_q16 height_at(int column, int row, int degrees, glint_q16 weight) {
    const int x = 2 * column - SQUARES, z = 2 * row - SQUARES;
    const glint_q16 along = sine_of((24 * x + 10 * z - degrees) * GLINT_ONE);
    const glint_q16 around = sine_of((2 * (x * x + z * z) - 2 * degrees) * GLINT_ONE);
    return times(between(along, around, weight), GLINT_Q16(0.9));
}

/* Across the surface: what it rises over two squares, at its edge twice over one. */
static void set_normal(glint_q16 height[SIDE][SIDE], int column, int row) {
    const int left = column > 0 ? column - 1 : 0, right = column < SQUARES ? column + 1 : SQUARES;
    const int back = row > 0 ? row - 1 : 0, front = row < SQUARES ? row + 1 : SQUARES;
    const glint_q16 across = (height[row][left] - height[row][right]) * 2 / (right - left),
                    along = (height[back][column] - height[front][column]) * 2 / (front - back);
    /* height times 0.16 over two squares of 2 * 1.2 / SQUARES each */
    const int32_t normal[3] = {times(across, GLINT_Q16(0.16)), GLINT_Q16(2 * 2.4 / SQUARES),
                               times(along, GLINT_Q16(0.16))};
    encode(normal, wave[row][column].normal);
}

static void set_wave(int degrees) {
    static glint_q16 height[SIDE][SIDE];
    const glint_q16 weight = (GLINT_ONE - sine_of((degrees + 90) * GLINT_ONE)) / 2;
    for (int row = 0; row < SIDE; row++) {
        for (int column = 0; column < SIDE; column++) {
            int16_t *const at = wave[row][column].position;
            height[row][column] = height_at(column, row, degrees, weight);
            at[0] = (int16_t)((2 * column - SQUARES) * 32767 / SQUARES);
            at[1] = (int16_t)(height[row][column] / 2);
            at[2] = (int16_t)((2 * row - SQUARES) * 32767 / SQUARES);
        }
    }
    for (int i = 0; i < SIDE * SIDE; i++)
        set_normal(height, i % SIDE, i / SIDE);
}

static void join_wave(void) {
    for (int i = 0; i < SQUARES * SQUARES; i++) {
        const int here = i / SQUARES * SIDE + i % SQUARES;
        uint8_t *const first = wave_triangles[2 * i], *const second = wave_triangles[2 * i + 1];
        first[0] = second[0] = (uint8_t)here;
        first[1] = (uint8_t)(here + SIDE);
        first[2] = second[1] = (uint8_t)(here + SIDE + 1);
        second[2] = (uint8_t)(here + 1);
    }
}

/* ---- An arm: a generated mesh at rest, of whose vertices two bones make others ---- */

#define AROUND 16
#define ALONG 20
#define ARM_VERTICES (AROUND * (ALONG + 1) + 2 * (AROUND + 1))
#define ARM_TRIANGLES (2 * AROUND * ALONG + 2 * AROUND)

typedef struct arm_vertex {
    int16_t position[3], normal[3];
} arm_vertex;

static int16_t rest_positions[ARM_VERTICES][3], rest_normals[ARM_VERTICES][3];
static uint16_t arm_triangles[ARM_TRIANGLES][3];
static glint_mesh rest;
static arm_vertex arm[ARM_VERTICES];
static const glint_mesh_layout arm_layout = {{&glint_attribute_int16, arm[0].position, sizeof(arm_vertex)},
                                             {&glint_attribute_int16, arm[0].normal, sizeof(arm_vertex)},
                                             {0, 0, 0},
                                             {0, 0, 0}};
/* As far as the arm reaches, however it bends. */
static const glint_mesh arm_mesh = {.triangles = (const uint16_t (*)[3])arm_triangles,
                                    .vertex_count = ARM_VERTICES,
                                    .triangle_count = ARM_TRIANGLES,
                                    .extent = GLINT_VECTOR(1.5, 1.5, 1.5),
                                    .layout = &arm_layout};

/* A direction turned by a bone, and a place. */
static glint_q16 turned(const glint_pose *bone, int row, const glint_q16 v[3]) {
    return times(bone->m[row][0], v[0]) + times(bone->m[row][1], v[1]) + times(bone->m[row][2], v[2]);
}

/* How much of a place along the arm is the forearm's: 0 up to half its radius before the elbow, 1 behind; smooth. */
static glint_q16 weight_at(glint_q16 z) {
    const glint_q16 t = z <= GLINT_Q16(-0.3) ? 0 : z >= GLINT_Q16(0.3) ? GLINT_ONE : (z + GLINT_Q16(0.3)) * 5 / 3;
    return times(times(t, t), 3 * GLINT_ONE - 2 * t);
}

/* Linear blending: the weighted mean of where both bones bring a vertex (Magnenat-Thalmann et al., 1988). */
static void bend_arm(int degrees) {
    const glint_pose forearm =
        glint_pose_rotate_x(times(GLINT_Q16(-55), GLINT_ONE - sine_of((degrees + 90) * GLINT_ONE)));
    const glint_q16 extent[3] = {rest.extent.x, rest.extent.y, rest.extent.z};
    for (uint32_t i = 0; i < ARM_VERTICES; i++) {
        glint_q16 place[3], normal[3];
        for (int c = 0; c < 3; c++) {
            place[c] = times(rest_positions[i][c] * 2, extent[c]);
            normal[c] = rest_normals[i][c];
        }
        const glint_q16 weight = weight_at(place[2]);
        for (int c = 0; c < 3; c++) {
            const glint_q16 at = between(place[c], turned(&forearm, c, place), weight);
            arm[i].position[c] = (int16_t)((int64_t)at * 32768 / GLINT_Q16(1.5));
            arm[i].normal[c] = (int16_t)between(normal[c], turned(&forearm, c, normal), weight);
        }
    }
}

glint_status moving_set(int degrees) {
    const glint_mesh_room room = {rest_positions, rest_normals, arm_triangles, ARM_VERTICES, ARM_TRIANGLES};
    if (!rest.vertex_count) {
        const glint_status status =
            glint_generate_cylinder(&rest, &room, AROUND, ALONG, GLINT_Q16(0.25), GLINT_Q16(1.2), 1);
        if (status != GLINT_OK)
            return status;
        join_wave();
    }
    set_wave(degrees);
    bend_arm(degrees);
    return GLINT_OK;
}

glint_status moving_draw(glint_renderer *renderer, int degrees) {
    static const glint_material water = {&glint_model_blinn_phong, GLINT_COLOUR(0.02, 0.05, 0.08),
                                         GLINT_COLOUR(0.1, 0.35, 0.5), GLINT_COLOUR(0.5, 0.5, 0.5), GLINT_Q16(30)};
    static const glint_material skin = {&glint_model_blinn_phong, GLINT_COLOUR(0.06, 0.04, 0.03),
                                        GLINT_COLOUR(0.55, 0.35, 0.25), GLINT_COLOUR(0.15, 0.15, 0.15), GLINT_Q16(12)};
    static const glint_light lamp = {.type = &glint_light_directional,
                                     .direction = GLINT_VECTOR(0.4, -1, -0.5),
                                     .diffuse = GLINT_COLOUR(1, 1, 1),
                                     .specular = GLINT_COLOUR(1, 1, 1)};
    const glint_pose side = glint_pose_rotate_y(GLINT_Q16(80)), left = glint_pose_translate(GLINT_Q16(-1.35), 0, 0),
                     right = glint_pose_translate(GLINT_Q16(1.45), GLINT_Q16(-0.35), 0);
    const glint_object objects[2] = {
        {.mesh = &wave_mesh, .material = &water, .evaluation = &glint_per_fragment, .pose = left},
        {.mesh = &arm_mesh,
         .material = &skin,
         .evaluation = &glint_per_fragment,
         .pose = glint_pose_then(&side, &right)}};
    glint_scene scene = {.background = GLINT_COLOUR(0.01, 0.015, 0.03),
                         .ambient = GLINT_COLOUR(1, 1, 1),
                         .lights = &lamp,
                         .light_count = 1,
                         .objects = objects,
                         .object_count = 2};
    const glint_vector eye = GLINT_VECTOR(0, 3.4, 4.4), at = GLINT_VECTOR(0, 0, 0), up = GLINT_VECTOR(0, 1, 0);
    glint_status status = moving_set(degrees);
    if (status == GLINT_OK)
        status = glint_camera_look_at(&scene.camera, eye, at, up);
    scene.camera.field_of_view = GLINT_Q16(32);
    scene.camera.near_plane = GLINT_Q16(0.1);
    return status == GLINT_OK ? glint_render(renderer, &scene) : status;
}
