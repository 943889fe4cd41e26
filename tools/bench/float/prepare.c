/* SPDX-License-Identifier: MIT */
/* Camera, lights and matrices in single precision. */
#include "draw.h"
#include "number.h"

#define STEPS 32768.0f

/* ---- Angles ---- */

/* Sine of up to an eighth of a turn: Taylor's series, wrong by less than 2^-28. */
static float small_sine(float angle) {
    const float square = angle * angle;

    return angle * (1 - square / 6 * (1 - square / 20 * (1 - square / 42 * (1 - square / 72))));
}

/* Cosine of 0 to 180 degrees. */
static float cosine(float degrees) {
    const float radian = 3.14159265f / 180;
    const float acute = degrees > 90 ? 180 - degrees : degrees;
    const float half = small_sine(acute * (radian / 2));
    const float result = 1 - 2 * half * half;

    return degrees > 90 ? -result : result;
}

/* Tangent of 0 to 90 degrees. */
static float tangent(float degrees) {
    return cosine(90 - degrees) / cosine(degrees);
}

/* ---- Vectors ---- */

static float_triple vector_of(const glint_vector *v) {
    return triple(float_of(v->x), float_of(v->y), float_of(v->z));
}

static float_triple colour_of(const glint_colour *c) {
    return triple(float_of(c->r), float_of(c->g), float_of(c->b));
}

/* A column of a pose. */
static float_triple column(const glint_pose *pose, int i) {
    return triple(float_of(pose->m[0][i]), float_of(pose->m[1][i]), float_of(pose->m[2][i]));
}

/* The inverse of a rotation is its transpose. */
static float_triple to_camera(const glint_camera *camera, float_triple world) {
    return triple(dot(column(&camera->pose, 0), world), dot(column(&camera->pose, 1), world),
                  dot(column(&camera->pose, 2), world));
}

static float_triple cross(float_triple a, float_triple b) {
    return triple(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

/* ---- Frame ---- */

/* From the eye, before it becomes a float: positions far from the origin keep their digits. */
static float_triple from_eye(const glint_camera *camera, glint_q16 x, glint_q16 y, glint_q16 z) {
    return triple((float)((int64_t)x - camera->pose.m[0][3]) / 65536,
                  (float)((int64_t)y - camera->pose.m[1][3]) / 65536,
                  (float)((int64_t)z - camera->pose.m[2][3]) / 65536);
}

static void prepare_light(float_light *light, const glint_light *from, const glint_camera *camera) {
    if (from->type == &glint_light_directional) {
        const float_triple shines = unit(to_camera(camera, vector_of(&from->direction)));

        light->vector = triple(-shines.x, -shines.y, -shines.z);
        return;
    }
    light->vector = to_camera(camera, from_eye(camera, from->position.x, from->position.y, from->position.z));
    light->square = dot(light->vector, light->vector);
    light->linear = float_of(from->linear);
    light->quadratic = float_of(from->quadratic);
    if (from->type == &glint_light_spot) {
        const float inner = cosine(float_of(from->inner));

        light->axis = unit(to_camera(camera, vector_of(&from->direction)));
        light->axis_position = dot(light->axis, light->vector);
        light->outer = cosine(float_of(from->outer));
        light->soft = inner > light->outer ? 1 / (inner - light->outer) : 1e9f;
    }
}

void float_prepare_frame(float_frame *frame) {
    const glint_scene *scene = frame->scene;

    frame->local = scene->viewer == GLINT_VIEWER_LOCAL;
    frame->focal = 0.5f * (float)frame->screen->height / tangent(0.5f * float_of(scene->camera.field_of_view));
    frame->near_plane = float_of(scene->camera.near_plane);
    frame->powers.shininess = -1;
    frame->pixel = 1 / frame->focal;
    frame->middle_x = 0.5f * (float)frame->screen->width - 0.5f;
    frame->middle_y = 0.5f - 0.5f * (float)frame->screen->height;
    for (uint32_t i = 0; i < scene->light_count; i++) {
        prepare_light(&frame->lights[i], &scene->lights[i], &scene->camera);
    }
}

/* ---- Objects ---- */

static float_triple row_of(float_triple x, float_triple y, float_triple z, int row) {
    return row == 0 ? triple(x.x, y.x, z.x) : row == 1 ? triple(x.y, y.y, z.y) : triple(x.z, y.z, z.z);
}

void float_prepare_object(float_draw *draw) {
    const float_frame *frame = draw->frame;
    const glint_camera *camera = &frame->scene->camera;
    const glint_mesh *mesh = draw->object->mesh;
    const glint_pose *pose = &draw->object->pose;
    const float_triple extent = scaled(vector_of(&mesh->extent), 1 / STEPS), offset = vector_of(&mesh->offset);
    const float_triple x = to_camera(camera, column(pose, 0)), y = to_camera(camera, column(pose, 1)),
                       z = to_camera(camera, column(pose, 2));
    const float_triple middle = to_camera(camera, from_eye(camera, pose->m[0][3], pose->m[1][3], pose->m[2][3]));
    const float_triple nx = cross(y, z), ny = cross(z, x), nz = cross(x, y);
    const float pixels = 16 * frame->focal;
    float_matrix *place = &draw->place;

    place->translation = sum_scaled(sum_scaled(sum_scaled(middle, x, offset.x), y, offset.y), z, offset.z);
    draw->front = dot(x, nx) < 0 ? 1 : -1;
    for (int i = 0; i < 3; i++) {
        place->row[i] = product(row_of(x, y, z, i), extent);
        draw->normal[i] = scaled(row_of(nx, ny, nz, i), (float)-draw->front);
    }
    draw->screen_x = scaled(place->row[0], pixels);
    draw->screen_tx = place->translation.x * pixels;
    draw->screen_y = scaled(place->row[1], -pixels);
    draw->screen_ty = place->translation.y * -pixels;
}

/* ---- Surfaces ---- */

static float_triple levels(float_triple colour) {
    return product(colour, triple(FLOAT_RED, FLOAT_GREEN, FLOAT_BLUE));
}

static int is_black(const float_triple *colour) {
    return colour->x + colour->y + colour->z <= 0;
}

/* Adds the lights of one type that show. @return how many. */
static uint32_t add_lamps(const float_frame *frame, const glint_material *material, const glint_light_type *type,
                          float_surface *surface, float_lamp *lamp) {
    const glint_scene *scene = frame->scene;
    const float_triple diffuse = colour_of(&material->diffuse);
    const float_triple specular = surface->model == FLOAT_DIFFUSE ? triple(0, 0, 0) : colour_of(&material->specular);
    const float_lamp *first = lamp;

    for (uint32_t i = 0; i < scene->light_count; i++) {
        const glint_light *light = &scene->lights[i];

        if (light->type == type) {
            lamp->diffuse = levels(product(diffuse, colour_of(&light->diffuse)));
            lamp->specular = levels(product(specular, colour_of(&light->specular)));
            if (!is_black(&lamp->diffuse) || !is_black(&lamp->specular)) {
                lamp->light = frame->lights[i];
                lamp++;
            }
        }
    }
    return (uint32_t)(lamp - first);
}

/* The brightest highlight, 1 being the highest level of green. */
static float brightest(const float_surface *surface) {
    const uint32_t count = surface->directional + surface->points + surface->spots;
    float most = 0;

    for (uint32_t i = 0; i < count; i++) {
        const float_triple *specular = &surface->lamps[i].specular;
        const float sum_of_all = (specular->x / FLOAT_RED + specular->y / FLOAT_GREEN + specular->z / FLOAT_BLUE);
        most = sum_of_all > most ? sum_of_all : most;
    }
    return most;
}

static float_model model_of(const glint_material *material) {
    return material->model == &glint_model_unlit         ? FLOAT_UNLIT
           : material->model == &glint_model_blinn_phong ? FLOAT_BLINN_PHONG
           : material->model == &glint_model_phong       ? FLOAT_PHONG
                                                         : FLOAT_DIFFUSE;
}

static void prepare_highlight(float_frame *frame, const glint_material *material, float_surface *surface) {
    const float bright = brightest(surface);

    if (bright <= 0) {
        surface->model = FLOAT_DIFFUSE;
        return;
    }
    float_prepare_powers(&frame->powers, material->shininess, 1 / (512 * bright));
    surface->powers = &frame->powers;
    surface->square = surface->model == FLOAT_BLINN_PHONG ? 2 : 1; /* the half vector's square is taken without its 2 */
    surface->scale = frame->powers.scale / surface->square;
    surface->offset = frame->powers.offset;
    surface->options |= (material->flags & GLINT_MATERIAL_SPECULAR_UNGATED ? FLOAT_UNGATED : 0) |
                        (material->shininess < 2 * GLINT_ONE ? FLOAT_LOW : 0);
}

void float_prepare_surface(float_frame *frame, float_draw *draw) {
    const glint_material *material = draw->object->material;
    const glint_mesh *mesh = draw->object->mesh;
    float_surface *surface = &draw->surface;

    surface->model = model_of(material);
    surface->half = triple(FLOAT_HALF_RED, FLOAT_HALF_GREEN, FLOAT_HALF_BLUE);
    surface->diffuse = levels(colour_of(&material->diffuse));
    surface->options = mesh->colours || mesh->colours565 ? FLOAT_COLOURS : 0;
    if (surface->model == FLOAT_UNLIT) {
        surface->dark = float_pixel(sum(surface->diffuse, surface->half));
        return;
    }
    surface->options |= material->flags & GLINT_MATERIAL_MAX_WITH_AMBIENT ? FLOAT_MAX : 0;
    surface->ambient = levels(product(colour_of(&material->ambient), colour_of(&frame->scene->ambient)));
    surface->base = sum(surface->ambient, surface->half);
    surface->dark = float_pixel(surface->base);
    float_lamp *lamps = surface->lamps;
    surface->directional = add_lamps(frame, material, &glint_light_directional, surface, lamps);
    surface->points = add_lamps(frame, material, &glint_light_point, surface, lamps + surface->directional);
    surface->spots =
        add_lamps(frame, material, &glint_light_spot, surface, lamps + surface->directional + surface->points);
    if (surface->model != FLOAT_DIFFUSE) {
        prepare_highlight(frame, material, surface);
    }
}
