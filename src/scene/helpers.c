/* SPDX-License-Identifier: MIT */
/* These helpers fill a scene in: poses, cameras, materials and lights. One finds where a camera sees a point. */
#include "view.h"

/* ---- Poses ---- */

glint_q16 glint_sin(glint_q16 degrees) {
    return glint_shift_right(glint_sine(glint_phase(degrees)) + (1 << 13), 14);
}

glint_q16 glint_cos(glint_q16 degrees) {
    return glint_shift_right(glint_sine(glint_phase(degrees) + 0x40000000u) + (1 << 13), 14);
}

glint_pose glint_pose_scale(glint_q16 x, glint_q16 y, glint_q16 z) {
    glint_pose pose = {{{x, 0, 0, 0}, {0, y, 0, 0}, {0, 0, z, 0}}};
    return pose;
}

glint_pose glint_pose_identity(void) {
    return glint_pose_scale(GLINT_ONE, GLINT_ONE, GLINT_ONE);
}

glint_pose glint_pose_translate(glint_q16 x, glint_q16 y, glint_q16 z) {
    glint_pose pose = glint_pose_identity();
    pose.m[0][3] = x;
    pose.m[1][3] = y;
    pose.m[2][3] = z;
    return pose;
}

/* Returns a rotation in the plane of two axes, from the first towards the second. */
static glint_pose rotate_in_plane(int from, int to, glint_q16 degrees) {
    glint_pose pose = glint_pose_identity();
    pose.m[from][from] = pose.m[to][to] = glint_cos(degrees);
    pose.m[to][from] = glint_sin(degrees);
    pose.m[from][to] = -pose.m[to][from];
    return pose;
}

glint_pose glint_pose_rotate_x(glint_q16 degrees) {
    return rotate_in_plane(1, 2, degrees);
}

glint_pose glint_pose_rotate_y(glint_q16 degrees) {
    return rotate_in_plane(2, 0, degrees);
}

glint_pose glint_pose_rotate_z(glint_q16 degrees) {
    return rotate_in_plane(0, 1, degrees);
}

static glint_q16 saturate(int64_t x) {
    return x > INT32_MAX ? INT32_MAX : x < INT32_MIN ? INT32_MIN : (glint_q16)x;
}

/* This is 2^-14 in Q32. A rotation rounded to Q16.16 is within half of it. */
#define ROTATION_TOLERANCE (1 << 18)

/*
 * Copies a pose's axes, and replaces those of a rotation by the unit and perpendicular axes next to them: one step of
 * M (3 I - M^T M) / 2 (Bjorck and Bowie, 1971), which leaves an error below 2^-26.
 * @return bits of fraction beyond Q16.16: 14 of a rotation, else 0
 */
static unsigned find_axes(const glint_pose *pose, int32_t axes[3][3]) {
    int32_t error[3][3];
    const int is_rotation = glint_axes_are_unit(pose, ROTATION_TOLERANCE, error);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            int64_t sum = 0; /* Q48, below 2^37 */
            for (int k = 0; k < 3 && is_rotation; k++)
                sum += (int64_t)pose->m[i][k] * error[k][j];
            axes[i][j] =
                is_rotation ? pose->m[i][j] * (1 << 14) - (int32_t)glint_round_shift64(sum, 19) : pose->m[i][j];
        }
    }
    return is_rotation ? 14 : 0;
}

/* Without exact axes, a rotation's rounding to Q16.16 would shrink a pose that turns every frame by 2^-19 a frame. */
glint_pose glint_pose_then(const glint_pose *first, const glint_pose *second) {
    glint_pose pose;
    int32_t inner[3][3], outer[3][3];
    /* Each product loses two bits of fraction more, so that three and a translation fit 64 bits. */
    const unsigned outer_shift = 2 + find_axes(second, outer), inner_shift = outer_shift + find_axes(first, inner);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            int64_t sum = j == 3 ? (int64_t)second->m[i][3] * (1 << 14) : 0;
            for (int k = 0; k < 3; k++)
                sum += j == 3 ? glint_round_shift64((int64_t)outer[i][k] * first->m[k][3], outer_shift)
                              : glint_round_shift64((int64_t)outer[i][k] * inner[k][j], inner_shift);
            pose.m[i][j] = saturate(glint_round_shift64(sum, 14));
        }
    }
    return pose;
}

/* Scales (x, y, z), of int64 with up to 62 bits, to 30 bits. @return its length, rounded down; 0 when it is 0 */
static int64_t to_thirty_bits(const int64_t in[3], int64_t v[3]) {
    uint64_t bits = glint_magnitude64(in[0]) | glint_magnitude64(in[1]) | glint_magnitude64(in[2]);
    uint64_t square = 0;
    if (!bits)
        return 0;
    const int shift = (int)glint_bits64(bits) - 30;
    for (int i = 0; i < 3; i++) {
        v[i] = shift > 0 ? glint_shift_right64(in[i], (unsigned)shift) : in[i] * ((int64_t)1 << -shift);
        square += (uint64_t)(v[i] * v[i]);
    }
    return glint_square_root(square);
}

/* Brings (x, y, z) to length 1 in Q16.16. @return 0 when its length is 0 */
static int normalise(const int64_t in[3], glint_q16 out[3]) {
    int64_t v[3];
    const int64_t length = to_thirty_bits(in, v);
    for (int i = 0; i < 3 && length; i++)
        out[i] = (glint_q16)glint_shift_right64(v[i] * (1 << 17) / length + 1, 1);
    return length != 0;
}

/* Finds R = c I + (1 - c) u u^T + s [u]x (Rodrigues, 1840). Entries are off by at most 0.6 steps of Q16.16 (suite
 * `camera`). */
glint_pose glint_pose_rotate(glint_vector axis, glint_q16 degrees) {
    const int64_t along[3] = {axis.x, axis.y, axis.z};
    const uint32_t phase = glint_phase(degrees);
    const int64_t sine = glint_sine(phase), cosine = glint_sine(phase + 0x40000000u); /* Q30 */
    glint_pose pose = glint_pose_identity();
    int64_t u[3];
    const int64_t length = to_thirty_bits(along, u);
    if (!length)
        return pose;
    for (int i = 0; i < 3; i++)
        u[i] = u[i] * (1 << 30) / length; /* Q30 */
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            int64_t sum = glint_round_shift64(u[i] * u[j], 30) * ((1 << 30) - cosine); /* Q60 */
            if (i == j)
                sum += cosine * (1 << 30);
            else
                sum += (j == (i + 2) % 3 ? sine : -sine) * u[3 - i - j];
            pose.m[i][j] = (glint_q16)glint_round_shift64(sum, 60 - 16);
        }
    return pose;
}

/* Converts a quaternion of any length (Hamilton, 1844). Entries are off by at most 0.51 steps of Q16.16 (suite
 * `camera`). */
glint_pose glint_pose_quaternion(glint_q16 x, glint_q16 y, glint_q16 z, glint_q16 w) {
    const glint_q16 in[4] = {x, y, z, w};
    uint64_t bits = 0, square = 0;
    int64_t q[4];
    glint_pose pose = glint_pose_identity();
    for (int i = 0; i < 4; i++)
        bits |= glint_magnitude64(in[i]);
    if (!bits)
        return pose;
    for (int i = 0; i < 4; i++) { /* the largest has 30 bits */
        const int shift = 30 - (int)glint_bits64(bits);
        q[i] = shift < 0 ? glint_shift_right64(in[i], (unsigned)-shift) : in[i] * ((int64_t)1 << shift);
        square += (uint64_t)(q[i] * q[i]);
    }
    const int64_t whole = (int64_t)square, by = whole >> 16; /* above 2^41 */
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const int k = 3 - i - j; /* where i and j differ */
            const int64_t sum = i == j ? whole - 2 * (whole - q[i] * q[i] - q[3] * q[3])
                                       : 2 * (q[i] * q[j] + (j == (i + 2) % 3 ? q[k] : -q[k]) * q[3]);
            pose.m[i][j] = (glint_q16)((sum < 0 ? sum - by / 2 : sum + by / 2) / by);
        }
    return pose;
}

glint_vector glint_pose_apply(const glint_pose *pose, glint_vector point) {
    const glint_q16 in[3] = {point.x, point.y, point.z};
    glint_q16 out[3];
    for (int i = 0; i < 3; i++) {
        int64_t sum = (int64_t)pose->m[i][3] * (1 << 14);
        for (int j = 0; j < 3; j++)
            sum += glint_round_shift64((int64_t)pose->m[i][j] * in[j], 2);
        out[i] = saturate(glint_round_shift64(sum, 14));
    }
    return (glint_vector){out[0], out[1], out[2]};
}

glint_camera glint_camera_default(void) {
    glint_camera camera = {glint_pose_translate(0, 0, 4 * GLINT_ONE), 45 * GLINT_ONE, GLINT_Q16(0.1), 0, 0};
    return camera;
}

/* Computes a x b, for |a| and |b| below 2^31. */
static void cross(const glint_q16 a[3], const int64_t b[3], int64_t out[3]) {
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = (int64_t)a[j] * b[k] - (int64_t)a[k] * b[j];
    }
}

glint_status glint_camera_look_at(glint_camera *camera, glint_vector eye, glint_vector at, glint_vector up) {
    if (!camera)
        return GLINT_ERROR_NULL;
    const int64_t back[3] = {(int64_t)eye.x - at.x, (int64_t)eye.y - at.y, (int64_t)eye.z - at.z};
    const int64_t upward[3] = {up.x, up.y, up.z};
    glint_q16 x[3], y[3] = {0}, z[3], u[3]; /* y is always found: x and z are perpendicular */
    int64_t product[3];
    if (!normalise(back, z) || !normalise(upward, u))
        return GLINT_ERROR_CAMERA;
    const int64_t back_unit[3] = {z[0], z[1], z[2]};
    cross(u, back_unit, product); /* x = up x back, Q32 */
    uint64_t size = glint_magnitude64(product[0]) | glint_magnitude64(product[1]) | glint_magnitude64(product[2]);
    if (size < (1u << 20) || !normalise(product, x)) /* sine of the angle between them below 2^-12 */
        return GLINT_ERROR_CAMERA;
    const int64_t right[3] = {x[0], x[1], x[2]};
    cross(z, right, product);
    normalise(product, y);
    for (int i = 0; i < 3; i++) {
        camera->pose.m[i][0] = x[i];
        camera->pose.m[i][1] = y[i];
        camera->pose.m[i][2] = z[i];
    }
    camera->pose.m[0][3] = eye.x;
    camera->pose.m[1][3] = eye.y;
    camera->pose.m[2][3] = eye.z;
    return GLINT_OK;
}

void glint_camera_orbit(glint_camera *camera, glint_vector at, glint_q16 yaw, glint_q16 pitch, glint_q16 distance) {
    const glint_pose tilt = rotate_in_plane(2, 1, pitch), turn = glint_pose_rotate_y(yaw);
    const glint_vector tilted = glint_pose_apply(&tilt, (glint_vector){0, 0, distance}),
                       place = glint_pose_apply(&turn, tilted);
    camera->pose = glint_pose_then(&tilt, &turn);
    camera->pose.m[0][3] = saturate((int64_t)place.x + at.x);
    camera->pose.m[1][3] = saturate((int64_t)place.y + at.y);
    camera->pose.m[2][3] = saturate((int64_t)place.z + at.z);
}

/* ---- Materials ---- */

glint_material glint_material_paint(const glint_shading_model *model, glint_colour paint, glint_q16 ambient_fraction,
                                    glint_q16 shininess) {
    glint_material material = {.model = model,
                               .ambient = paint,
                               .diffuse = paint,
                               .specular = {GLINT_ONE, GLINT_ONE, GLINT_ONE},
                               .shininess = shininess};
    glint_q16 *const ambient[3] = {&material.ambient.r, &material.ambient.g, &material.ambient.b};
    for (int c = 0; c < 3; c++)
        *ambient[c] = (glint_q16)glint_round_shift64((int64_t)*ambient[c] * ambient_fraction, 16);
    return material;
}

/* ---- Lights ---- */

/* At its range a lamp is divided by 126 = 1 + 125, which leaves half a step of green's 63 of full light. */
#define WEAKENED 125

/* Below a range of 1/16 the quadratic coefficient would pass Q16.16. */
#define RANGE_LEAST (GLINT_ONE / 16)

/* Sets attenuation so that linear range + quadratic range^2 is WEAKENED. The linear coefficient takes over what the
 * quadratic one loses by its 16 bits of fraction: all of it beyond a range of 2862. */
static void set_attenuation(glint_light *light, glint_q16 range) {
    if (range < RANGE_LEAST) {
        light->quadratic = -1; /* GLINT_ERROR_ATTENUATION */
        return;
    }
    const uint64_t square = (uint64_t)range * (uint32_t)range, weakened = (uint64_t)WEAKENED << 48; /* Q32; Q48 */
    light->quadratic = (glint_q16)(weakened / square);
    light->linear = (glint_q16)((weakened % square / (uint32_t)range + (1 << 15)) >> 16);
}

static glint_light begin_light(const glint_light_type *type, glint_colour colour) {
    glint_light light = {0};
    light.type = type;
    light.diffuse = light.specular = colour;
    return light;
}

glint_light glint_sun(glint_vector direction, glint_colour colour) {
    glint_light light = begin_light(&glint_light_directional, colour);
    light.direction = direction;
    return light;
}

glint_light glint_lamp(glint_vector position, glint_colour colour, glint_q16 range) {
    glint_light light = begin_light(&glint_light_point, colour);
    light.position = position;
    set_attenuation(&light, range);
    return light;
}

glint_light glint_spot(glint_vector position, glint_vector at, glint_colour colour, glint_q16 range, glint_q16 angle) {
    glint_light light = begin_light(&glint_light_spot, colour);
    const int64_t way[3] = {(int64_t)at.x - position.x, (int64_t)at.y - position.y, (int64_t)at.z - position.z};
    int32_t direction[3];
    set_attenuation(&light, range);
    glint_reduce(way, direction);
    light.position = position;
    light.direction = (glint_vector){direction[0], direction[1], direction[2]};
    light.inner = angle / 2;
    light.outer = angle;
    return light;
}

/* ---- Points on the screen ---- */

glint_status glint_check_sight(const glint_config *config, const glint_camera *camera) {
    if (!config || !camera)
        return GLINT_ERROR_NULL;
    if (config->width < 1 || config->width > GLINT_SIZE_MAX || config->height < 1 || config->height > GLINT_SIZE_MAX)
        return GLINT_ERROR_SIZE;
    return glint_camera_is_valid(camera) ? GLINT_OK : GLINT_ERROR_CAMERA;
}

int64_t glint_find_divisor(const glint_config *config, const glint_camera *camera, const int64_t sight[3]) {
    return camera->projection ? camera->projection->find_w(config, camera) * 8 : sight[2];
}

void glint_find_sight(const glint_camera *camera, glint_vector point, int64_t sight[3]) {
    const glint_q16 world[3] = {point.x, point.y, point.z};
    for (int i = 0; i < 3; i++) {
        sight[i] = 0;
        for (int j = 0; j < 3; j++) {
            const int64_t from_eye = (int64_t)world[j] - camera->pose.m[j][3]; /* 33 bits */
            sight[i] += glint_shift_right64(from_eye * camera->pose.m[j][i], 1) * (i ? -1 : 1);
        }
    }
}

/* Computes half the size + focal length x / distance, Q16 and saturated. The distance has at most 30 bits. */
static glint_q16 place_on_screen(int64_t x, int64_t distance, int64_t focal, int32_t size) {
    const int shift =
        32 + (int)glint_bits64((uint64_t)distance) - (int)glint_bits64(glint_magnitude64(x)); /* ratio: 33 bits */
    if (shift < 4)
        return x < 0 ? INT32_MIN : INT32_MAX;
    const int64_t ratio = x * ((int64_t)1 << shift) / distance;
    const int64_t place = ((int64_t)size << 15) + glint_round_shift64(ratio * focal, (unsigned)shift - 3);
    return place > INT32_MAX ? INT32_MAX : place < INT32_MIN ? INT32_MIN : (glint_q16)place;
}

int glint_camera_project(const glint_config *config, const glint_camera *camera, glint_vector point,
                         glint_screen_point *to) {
    const glint_status status = to ? glint_check_sight(config, camera) : GLINT_ERROR_NULL;
    int64_t sight[3];
    if (status != GLINT_OK)
        return status;
    glint_find_sight(camera, point, sight);
    if (sight[2] < (int64_t)camera->near_plane * (1 << 15))
        return 0;
    const int64_t focal = glint_round_shift64(glint_focal_length(config, camera), 31 - 12),
                  away = glint_shift_right64(sight[2], 15);
    const int64_t divisor = glint_find_divisor(config, camera, sight);
    const unsigned bits = glint_bits64((uint64_t)divisor), down = bits > 30 ? bits - 30 : 0;
    const int64_t distance = (divisor >> down) + (divisor == 0); /* which no valid camera sees */
    to->x = place_on_screen(glint_shift_right64(sight[0], down), distance, focal, config->width);
    to->y = place_on_screen(glint_shift_right64(sight[1], down), distance, focal, config->height);
    to->distance = away > INT32_MAX ? INT32_MAX : (glint_q16)away;
    return 1;
}
