/* SPDX-License-Identifier: MIT */
/* Prepare: checks a scene and brings camera, lights and materials into the form that a frame reads. */
#include "frame.h"

/* Below 0 is far above the largest when unsigned. */
static int colour_is_valid(const glint_colour *colour) {
    const uint32_t most = GLINT_COLOUR_MAX;
    return (uint32_t)colour->r <= most && (uint32_t)colour->g <= most && (uint32_t)colour->b <= most;
}

/* Out of line, which is less code than branches across the loop over objects. */
static GLINT_NOINLINE glint_status check_mesh(const glint_mesh *mesh) {
    if (!mesh || !mesh->positions || !mesh->normals || !mesh->triangles)
        return GLINT_ERROR_NULL;
    if (mesh->vertex_count - 1 >= 65536 || mesh->triangle_count < 1 ||
        (mesh->extent.x | mesh->extent.y | mesh->extent.z) < 0)
        return GLINT_ERROR_MESH;
    if (mesh->flags > GLINT_MESH_DOUBLE_SIDED)
        return GLINT_ERROR_FLAGS;
    const glint_cull *cull = glint_cull_of(mesh);
    return cull ? cull->check(mesh) : GLINT_OK;
}

static glint_status check_material(const glint_material *material) {
    if (!material || !material->model)
        return GLINT_ERROR_NULL;
    if (!colour_is_valid(&material->ambient) || !colour_is_valid(&material->diffuse) ||
        !colour_is_valid(&material->specular))
        return GLINT_ERROR_COLOUR;
    if (material->flags > (GLINT_MATERIAL_UNGATED | GLINT_MATERIAL_MAX))
        return GLINT_ERROR_FLAGS;
    return material->shininess < 0 ? GLINT_ERROR_SHININESS : GLINT_OK;
}

static glint_status check_lights(const glint_scene *scene) {
    if (scene->light_count > GLINT_LIGHTS_MAX)
        return GLINT_ERROR_LIGHTS;
    if (scene->light_count && !scene->lights)
        return GLINT_ERROR_NULL;
    for (uint32_t i = 0; i < scene->light_count; i++) {
        if (!scene->lights[i].type)
            return GLINT_ERROR_NULL;
        if (!colour_is_valid(&scene->lights[i].diffuse) || !colour_is_valid(&scene->lights[i].specular))
            return GLINT_ERROR_COLOUR;
    }
    return GLINT_OK;
}

/* Unit and perpendicular to within 2^-9, far more than rounding to Q16.16 takes away. */
static int camera_is_valid(const glint_camera *camera) {
    for (int i = 0; i < 3; i++) {
        for (int j = i; j < 3; j++) {
            int64_t dot = 0;
            for (int k = 0; k < 3; k++) {
                if ((uint32_t)camera->pose.m[k][i] + 2 * GLINT_ONE > 4 * GLINT_ONE)
                    return 0;
                dot += glint_product(camera->pose.m[k][i], camera->pose.m[k][j]);
            }
            if (glint_magnitude64(dot - (i == j ? (int64_t)1 << 32 : 0)) > (1u << 23))
                return 0;
        }
    }
    return camera->field_of_view >= GLINT_ONE && camera->field_of_view <= 170 * GLINT_ONE && camera->near_plane > 0;
}

static glint_status check_objects(const glint_scene *scene) {
    for (uint32_t i = 0; i < scene->object_count; i++) {
        glint_status status = check_mesh(scene->objects[i].mesh);
        if (status == GLINT_OK)
            status = check_material(scene->objects[i].material);
        if (status != GLINT_OK)
            return status;
    }
    return GLINT_OK;
}

glint_status glint_check_scene(const glint_scene *scene) {
    if (!scene || (scene->object_count && !scene->objects))
        return GLINT_ERROR_NULL;
    if (!camera_is_valid(&scene->camera))
        return GLINT_ERROR_CAMERA;
    if (scene->viewer != GLINT_VIEWER_INFINITE && scene->viewer != GLINT_VIEWER_LOCAL)
        return GLINT_ERROR_VIEWER;
    if ((uint32_t)scene->error_budget > GLINT_BUDGET_MAX)
        return GLINT_ERROR_BUDGET;
    if (!colour_is_valid(&scene->background) || !colour_is_valid(&scene->ambient))
        return GLINT_ERROR_COLOUR;
    const glint_status status = check_lights(scene);
    return status == GLINT_OK ? check_objects(scene) : status;
}

unsigned glint_reduce(const int64_t in[3], int32_t out[3]) {
    uint64_t bits = 0;
    for (int i = 0; i < 3; i++)
        bits |= glint_magnitude64(in[i]);
    unsigned size = glint_bits64(bits), down = size > 30 ? size - 30 : 0;
    for (int i = 0; i < 3; i++)
        out[i] = (int32_t)glint_shift_right64(in[i], down);
    return down;
}

int glint_direction_to_camera(const glint_view *view, glint_vector world, int16_t out[3]) {
    const int32_t in[3] = {world.x, world.y, world.z};
    int64_t sum[3];
    int32_t reduced[3];
    for (int i = 0; i < 3; i++) {
        sum[i] = 0;
        for (int j = 0; j < 3; j++)
            sum[i] += glint_product(view->rotation[i][j], in[j]); /* below 2^50 */
    }
    glint_reduce(sum, reduced);
    glint_unit(reduced[0], reduced[1], reduced[2], out);
    return (in[0] | in[1] | in[2]) != 0;
}

/* Twice the focal length in pixels, Q31: below 2^48. */
static void set_focal_length(glint_view *view, int64_t focal) {
    view->focal = (int32_t)glint_round_shift64(focal, 31 - 12);
    int64_t ratio = focal * (1 << 12) / (2 * GLINT_GUARD_BAND); /* focal length / guard band, Q43: 29 bits or more */
    unsigned down = glint_bits64((uint64_t)ratio) - 24;
    view->focal_shift = 43 - down;
    view->focal_mantissa = (int32_t)glint_shift_right64(ratio, down);
}

/* Focal length from the vertical field of view: half the height over the tangent of half the angle. */
static void prepare_focal_length(glint_view *view, const glint_config *config, glint_q16 field_of_view) {
    uint32_t phase = glint_phase(field_of_view) >> 1;
    int64_t sine = glint_sine(phase), cosine = glint_sine(phase + 0x40000000u);
    set_focal_length(view, (cosine << 31) / sine * config->height);
}

static glint_status prepare_lights(glint_view *view, const glint_scene *scene) {
    view->light_count = scene->light_count;
    view->has_positions = 0;
    for (uint32_t i = 0; i < scene->light_count; i++) {
        const glint_light *light = &scene->lights[i];
        view->lights[i].type = light->type;
        if (light->type->illuminate)
            view->has_positions = 1;
        glint_status status = light->type->prepare(light, &view->lights[i], view);
        if (status != GLINT_OK)
            return status;
    }
    return GLINT_OK;
}

/* Lights with positions are kept in the units of the depth's scale. */
static void place_lights(glint_view *view, const glint_scene *scene) {
    for (uint32_t i = 0; i < scene->light_count; i++)
        if (scene->lights[i].type->place)
            scene->lights[i].type->place(&scene->lights[i], &view->lights[i], view);
}

/* Depth is scaled to the nearest corner of any visible object's bounding box. */
static glint_status prepare_nearest(glint_view *view, const glint_config *config, const glint_scene *scene,
                                    glint_transform *transform) {
    int64_t nearest = INT64_MAX;
    view->nearest = view->near_plane;
    for (uint32_t i = 0; i < scene->object_count; i++) {
        glint_status status = glint_transform_prepare(transform, view, config, &scene->objects[i]);
        if (status != GLINT_OK)
            return status;
        int64_t w = transform->visible ? glint_transform_nearest(transform, view) : INT64_MAX;
        if (w < nearest)
            nearest = w;
    }
    if (nearest < INT64_MAX)
        view->nearest = nearest;
    return GLINT_OK;
}

glint_status glint_prepare_view(glint_view *view, const glint_config *config, const glint_scene *scene,
                                glint_transform *last) {
    const glint_camera *camera = &scene->camera;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            view->rotation[i][j] = camera->pose.m[j][i];
        view->eye[i] = camera->pose.m[i][3];
    }
    view->near_plane = (int64_t)camera->near_plane << 12;
    view->local_viewer = scene->viewer == GLINT_VIEWER_LOCAL;
    prepare_focal_length(view, config, camera->field_of_view);
    glint_status status = prepare_lights(view, scene);
    if (status == GLINT_OK)
        status = prepare_nearest(view, config, scene, last);
    if (status == GLINT_OK)
        place_lights(view, scene);
    return status;
}

/* Products of two colours with `bits` fractional bits. @return the largest, below 0 when one passes GLINT_COLOUR_MAX.
 */
static int32_t weigh_colour(const glint_colour *a, const glint_colour *b, int bits, uint32_t weight[3]) {
    const glint_q16 left[3] = {a->r, a->g, a->b}, right[3] = {b->r, b->g, b->b};
    int32_t largest = 0;
    for (int c = 0; c < 3; c++) {
        int64_t product = glint_product(left[c], right[c]);
        if (product > (int64_t)GLINT_COLOUR_MAX << 16)
            return -1;
        const int32_t here = (int32_t)glint_shift_round64(product, 32 - bits);
        weight[c] = (uint32_t)here;
        largest = here > largest ? here : largest;
    }
    return largest;
}

/* What the error budget allows, as a weight, Q12: its steps less a quarter for what is rounded otherwise. */
static int32_t find_spare(const glint_frame *frame) {
    const int32_t budget = frame->scene->error_budget, bits = (int32_t)frame->config.format->bits;
    const int32_t levels = bits & 4 ? 15 : bits == 16 ? 63 : 255;
    return budget && !frame->config.gamma ? (4096 * budget - 1024) / levels : 0;
}

/* Sets a number that tables are made from. */
static inline void renew(glint_shading *shading, uint32_t *number, uint32_t value) {
    shading->changed |= GLINT_SMALL ? 0 : *number ^ value;
    *number = value;
}

static void renew_colour(glint_shading *shading, uint32_t number[3], const uint32_t value[3]) {
    for (int c = 0; c < 3; c++)
        renew(shading, &number[c], value[c]);
}

/*
 * Weights of the lights that show, and what of the error budget they leave. @return the largest of specular light,
 * below 0 when one passes GLINT_COLOUR_MAX.
 */
static int32_t weigh_lights(const glint_scene *scene, glint_shading *shading, int32_t spare) {
    const glint_material *material = shading->material;
    uint32_t lights = 0, has_specular = 0, shown = 0, weight[2][3] = {{0}};
    int32_t largest = 0;
    for (uint32_t i = 0; i < scene->light_count; i++) {
        const glint_light *light = &scene->lights[i];
        const int32_t diffuse = weigh_colour(&material->diffuse, &light->diffuse, 12, weight[0]);
        const int32_t specular = weigh_colour(&material->specular, &light->specular, 12, weight[1]);
        if ((diffuse | specular) < 0)
            return -1;
        renew_colour(shading, shading->weights[i].diffuse, weight[0]);
        renew_colour(shading, shading->weights[i].specular, weight[1]);
        if (specular > spare) {
            has_specular |= 1u << i;
            largest = glint_most(specular, largest);
        } else {
            spare -= specular;
            if (diffuse <= spare) {
                spare -= diffuse;
                continue;
            }
        }
        lights |= 1u << i;
        shown++;
    }
    renew(shading, &shading->lights, material->model->light ? lights : 0);
    renew(shading, &shading->has_specular, material->model->prepare ? has_specular : 0);
    renew(shading, &shading->spare, shown ? (uint32_t)spare / shown : 0);
    return largest;
}

glint_status glint_prepare_shading(const glint_frame *frame, glint_shading *shading, const glint_material *material) {
    uint32_t ambient[3] = {0};
    shading->changed = GLINT_SMALL || shading->material != material || shading->shininess != material->shininess;
    shading->material = material;
    shading->shininess = material->shininess;
    if (weigh_colour(&material->ambient, &frame->scene->ambient, 23, ambient) < 0)
        return GLINT_ERROR_COLOUR;
    renew_colour(shading, shading->ambient, ambient);
    const int32_t largest = weigh_lights(frame->scene, shading, find_spare(frame));
    if (largest < 0)
        return GLINT_ERROR_COLOUR;
    if (material->model->prepare)
        material->model->prepare(shading, (uint32_t)largest);
    return GLINT_OK;
}
