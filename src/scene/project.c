/* SPDX-License-Identifier: MIT */
/* Project: where a point of the world shows on the screen, for labels and the like. */
#include "../math/numeric.h"
#include "sight.h"

glint_status glint_check_sight(const glint_config *config, const glint_camera *camera) {
    if (!config || !camera)
        return GLINT_ERROR_NULL;
    if (config->width < 1 || config->width > GLINT_SIZE_MAX || config->height < 1 || config->height > GLINT_SIZE_MAX)
        return GLINT_ERROR_SIZE;
    return glint_camera_is_valid(camera) ? GLINT_OK : GLINT_ERROR_CAMERA;
}

int64_t glint_find_focal_length(const glint_config *config, const glint_camera *camera) {
    if (camera->projection)
        return 2 * GLINT_GUARD_BAND << 12;
    const uint32_t phase = glint_phase(camera->field_of_view) >> 1;
    const int64_t sine = glint_sine(phase), cosine = glint_sine(phase + 0x40000000u);
    return glint_round_shift64((cosine << 31) / sine * config->height, 31 - 12);
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

/* Half the size + focal length x / distance, Q16 and saturated; a distance of 30 bits at most. */
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
    const int64_t focal = glint_find_focal_length(config, camera), away = glint_shift_right64(sight[2], 15);
    const int64_t divisor = glint_find_divisor(config, camera, sight);
    const unsigned bits = glint_bits64((uint64_t)divisor), down = bits > 30 ? bits - 30 : 0;
    const int64_t distance = (divisor >> down) + (divisor == 0); /* which no valid camera sees */
    to->x = place_on_screen(glint_shift_right64(sight[0], down), distance, focal, config->width);
    to->y = place_on_screen(glint_shift_right64(sight[1], down), distance, focal, config->height);
    to->distance = away > INT32_MAX ? INT32_MAX : (glint_q16)away;
    return 1;
}
