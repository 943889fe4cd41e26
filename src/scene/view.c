/* SPDX-License-Identifier: MIT */
/* Brings camera and lights into the form that a frame reads, and finds the scale of depth. */
#include "view.h"

unsigned glint_reduce(const int64_t in[3], int32_t out[3]) {
    uint64_t bits = 0;
    for (int i = 0; i < 3; i++)
        bits |= glint_magnitude64(in[i]);
    unsigned size = glint_bits64(bits), down = size > 30 ? size - 30 : 0;
    for (int i = 0; i < 3; i++)
        out[i] = (int32_t)glint_shift_right64(in[i], down);
    return down;
}

int glint_light_to_camera(const glint_view *view, const glint_light *light, int opposite, int16_t out[3]) {
    const int32_t in[3] = {light->direction.x, light->direction.y, light->direction.z};
    int64_t sum[3];
    int32_t reduced[3];
    for (int i = 0; i < 3; i++) {
        sum[i] = 0;
        for (int j = 0; j < 3; j++)
            sum[i] += glint_product(view->rotation[i][j], in[j]); /* below 2^50 */
        if (opposite)
            sum[i] = -sum[i];
    }
    glint_reduce(sum, reduced);
    glint_unit(reduced[0], reduced[1], reduced[2], out);
    return (in[0] | in[1] | in[2]) != 0;
}

/* The axes have to be unit and perpendicular to within 2^-9. Rounding to Q16.16 costs far less. */
int glint_camera_is_valid(const glint_camera *camera) {
    int32_t error[3][3];
    if (!glint_axes_are_unit(&camera->pose, 1 << 23, error))
        return 0;
    if (camera->projection)
        return camera->near_plane > 0 && camera->projection->is_valid(camera);
    return camera->field_of_view >= GLINT_ONE && camera->field_of_view <= 170 * GLINT_ONE && camera->near_plane > 0;
}

/* Sets twice the focal length in pixels, given in Q31 and below 2^48. */
static void set_focal_length(glint_view *view, int64_t focal) {
    view->focal = (int32_t)glint_round_shift64(focal, 31 - 12);
    int64_t ratio = focal * (1 << 12) / (2 * GLINT_GUARD_BAND); /* focal length / guard band, Q43: 29 bits or more */
    unsigned down = glint_bits64((uint64_t)ratio) - 24;
    view->focal_shift = 43 - down;
    view->focal_mantissa = (int32_t)glint_shift_right64(ratio, down);
}

/* Chooses the scale of rays so that the ray of a screen corner has 15 bits, or 14 of parallel rays, whose z is found
 * separately. Whole multiples of half pixels are exact. */
static void set_ray_scale(glint_view *view, const glint_config *config) {
    const uint64_t focal = (uint64_t)view->focal >> 12, width = config->width + 16u,
                   height = config->height + 16u; /* nodes may lie 8 pixels outside: light/cells.c */
    const uint64_t square = width * width + height * height + (view->is_parallel ? 0 : focal * focal);
    const uint32_t scale = (32767u << 12) / (glint_square_root(square) + 2) >> (view->is_parallel ? 1 : 0);
    view->ray_scale = (int32_t)(scale >> 15 ? scale & ~0xfffu : scale);
}

int64_t glint_focal_length(const glint_config *config, const glint_camera *camera) {
    if (camera->projection)
        return (int64_t)GLINT_GUARD_BAND << 32;
    const uint32_t phase = glint_phase(camera->field_of_view) >> 1;
    const int64_t sine = glint_sine(phase), cosine = glint_sine(phase + 0x40000000u);
    return (cosine << 31) / sine * config->height;
}

static glint_status prepare_lights(glint_view *view, const glint_scene *scene) {
    view->light_count = scene->light_count;
    view->has_positions = view->is_parallel;
    for (uint32_t i = 0; i < scene->light_count; i++) {
        const glint_light *light = &scene->lights[i];
        view->lights[i].type = light->type;
        if (light->type->has_place)
            view->has_positions = 1;
        glint_status status = light->type->prepare(light, &view->lights[i], view);
        if (status != GLINT_OK)
            return status;
    }
    return GLINT_OK;
}

/* Returns the larger of a w, Q28, and that of the farthest corner of an object's bounding box. */
static GLINT_NOINLINE int64_t farther(int64_t farthest, const glint_transform *transform) {
    const int64_t w = 2 * (int64_t)transform->translation[2] - transform->least_w + 2;
    const int64_t here = glint_shift_round64(w, transform->exponent - 28);
    return here > farthest ? here : farthest;
}

/* Scales depth to the nearest corner of any visible object's bounding box. */
static glint_status prepare_nearest(glint_view *view, const glint_config *config, const glint_scene *scene,
                                    glint_transform *last, uint32_t count) {
    int64_t nearest = INT64_MAX, farthest = view->near_plane;
    if (!view->is_parallel)
        view->nearest = view->near_plane;
    view->skipped = 0;
    for (uint32_t i = 0; i < scene->object_count; i++) {
        const uint32_t behind = scene->object_count - 1 - i;
        glint_transform *const transform = last - (!GLINT_SMALL && behind < count ? behind : 0);
        glint_status status = glint_transform_prepare(transform, view, config, &scene->objects[i]);
        if (status != GLINT_OK)
            return status;
        view->skipped += transform->skipped;
        int64_t w = transform->visible ? glint_transform_nearest(transform, view) : INT64_MAX;
        if (w < nearest)
            nearest = w;
        if (view->is_parallel && transform->visible)
            farthest = farther(farthest, transform);
    }
    if (view->is_parallel)
        scene->camera.projection->set_range(view, nearest < farthest ? nearest : farthest, farthest);
    else if (nearest < INT64_MAX) {
        nearest -= nearest >> 7; /* this leaves room for the rounding of planes of 1/w */
        const unsigned bits = glint_bits64((uint64_t)nearest), down = bits > 16 ? bits - 16 : 0;
        view->nearest = nearest >> down << down; /* geometry keeps 16 bits, and lights are placed by the same bits */
    }
    return GLINT_OK;
}

glint_status glint_prepare_view(glint_view *view, const glint_config *config, const glint_scene *scene,
                                struct glint_transform *last, uint32_t count) {
    const glint_camera *camera = &scene->camera;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            view->rotation[i][j] = camera->pose.m[j][i];
        view->eye[i] = camera->pose.m[i][3];
    }
    view->near_plane = (int64_t)camera->near_plane << 12;
    view->is_parallel = camera->projection != 0;
    view->local_viewer = scene->viewer == GLINT_VIEWER_LOCAL && !view->is_parallel;
    if (view->is_parallel)
        view->nearest = camera->projection->find_w(config, camera);
    set_focal_length(view, glint_focal_length(config, camera));
    set_ray_scale(view, config);
    glint_status status = prepare_lights(view, scene);
    if (status == GLINT_OK)
        status = prepare_nearest(view, config, scene, last, count);
    for (uint32_t i = 0; i < scene->light_count && status == GLINT_OK; i++)
        if (scene->lights[i].type->place)
            scene->lights[i].type->place(&scene->lights[i], &view->lights[i], view);
    return status;
}
