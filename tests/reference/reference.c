/* SPDX-License-Identifier: MIT */
#include "reference.h"

#include <math.h>
#include <string.h>

#define CORNERS_MAX 4 /* a triangle cut by one plane */

typedef struct light_vectors {
    double towards[GLINT_LIGHTS_MAX][3]; /* camera space, unit length */
} light_vectors;

/* A triangle's corner as it is drawn. */
typedef struct corner {
    double place[3];
    double normal[3];
    double w;
    int64_t x, y; /* 28.4 */
} corner;

typedef struct drawing {
    const reference_image *image;
    const glint_scene *scene;
    const glint_material *material;
    light_vectors lights;
    int rounded_here; /* the present triangle's screen positions are not given */
} drawing;

static double real(glint_q16 value) {
    return value / 65536.0;
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Zero stays zero. */
static void normalise(double v[3]) {
    double length = sqrt(dot(v, v));
    for (int axis = 0; axis < 3 && length > 0; axis++)
        v[axis] /= length;
}

/* World to camera: the inverse of a rotation is its transpose. */
static void rotate_to_camera(const glint_camera *camera, const double world[3], double result[3]) {
    for (int axis = 0; axis < 3; axis++) {
        result[axis] = 0;
        for (int row = 0; row < 3; row++)
            result[axis] += real(camera->pose.m[row][axis]) * world[row];
    }
}

/* The cofactors of a pose's linear part: its transposed inverse times the determinant. @return the determinant. */
static double cofactors(const glint_pose *pose, double cofactor[3][3]) {
    double m[3][3];
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++)
            m[row][column] = real(pose->m[row][column]);
    }
    for (int row = 0; row < 3; row++) {
        int r1 = (row + 1) % 3;
        int r2 = (row + 2) % 3;
        for (int column = 0; column < 3; column++) {
            int c1 = (column + 1) % 3;
            int c2 = (column + 2) % 3;
            cofactor[row][column] = m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
        }
    }
    return dot(m[0], cofactor[0]);
}

/* By the transposed inverse, up to a positive factor. */
static void transform_normal(const glint_pose *pose, const double object[3], double world[3]) {
    double cofactor[3][3];
    double sign = cofactors(pose, cofactor) < 0 ? -1 : 1;
    for (int row = 0; row < 3; row++)
        world[row] = sign * dot(cofactor[row], object);
}

static void transform_place(const glint_scene *scene, const glint_object *object, uint32_t index, double place[3]) {
    const glint_mesh *mesh = object->mesh;
    const glint_camera *camera = &scene->camera;
    const glint_q16 offset[3] = {mesh->offset.x, mesh->offset.y, mesh->offset.z};
    const glint_q16 extent[3] = {mesh->extent.x, mesh->extent.y, mesh->extent.z};
    double local[3];
    double world[3];
    for (int axis = 0; axis < 3; axis++)
        local[axis] = real(offset[axis]) + real(extent[axis]) * mesh->positions[index][axis] / 32768.0;
    for (int row = 0; row < 3; row++) {
        const glint_q16 *m = object->pose.m[row];
        world[row] = real(m[0]) * local[0] + real(m[1]) * local[1] + real(m[2]) * local[2] + real(m[3]);
        world[row] -= real(camera->pose.m[row][3]);
    }
    rotate_to_camera(camera, world, place);
}

/* Pixels per unit of x/w and y/w: pixels are square, the field of view is vertical. */
static double focal_length(const glint_scene *scene, int height) {
    const double degree = 3.14159265358979323846 / 180;
    return 0.5 * height / tan(0.5 * real(scene->camera.field_of_view) * degree);
}

reference_vertex reference_transform(const glint_scene *scene, uint32_t object, uint32_t index, int width, int height) {
    const glint_object *source = &scene->objects[object];
    const int16_t *steps = source->mesh->normals[index];
    const double normal[3] = {steps[0], steps[1], steps[2]};
    double world[3];
    double focal = focal_length(scene, height);
    reference_vertex vertex = {{0}, {0}, 0, 0, 0};
    transform_place(scene, source, index, vertex.place);
    transform_normal(&source->pose, normal, world);
    rotate_to_camera(&scene->camera, world, vertex.normal);
    normalise(vertex.normal);
    vertex.w = -vertex.place[2];
    vertex.x = 0.5 * width + focal * vertex.place[0] / vertex.w;
    vertex.y = 0.5 * height - focal * vertex.place[1] / vertex.w;
    return vertex;
}

/* ---- Lighting ------------------------------------------------------------------------------------------------ */

static void add_light(const drawing *draw, uint32_t index, const double normal[3], const double view[3],
                      reference_pixel *pixel) {
    const glint_light *light = &draw->scene->lights[index];
    const glint_material *material = draw->material;
    const double *towards = draw->lights.towards[index];
    const double diffuse[3] = {real(light->diffuse.r) * real(material->diffuse.r),
                               real(light->diffuse.g) * real(material->diffuse.g),
                               real(light->diffuse.b) * real(material->diffuse.b)};
    const double specular[3] = {real(light->specular.r) * real(material->specular.r),
                                real(light->specular.g) * real(material->specular.g),
                                real(light->specular.b) * real(material->specular.b)};
    double half[3] = {towards[0] + view[0], towards[1] + view[1], towards[2] + view[2]};
    double n_dot_l = dot(normal, towards);
    pixel->grazing = fmin(pixel->grazing, fabs(n_dot_l));
    if (n_dot_l <= 0)
        return;
    normalise(half);
    double shine = pow(fmax(dot(normal, half), 0), real(material->shininess));
    for (int channel = 0; channel < 3; channel++)
        pixel->colour[channel] += diffuse[channel] * n_dot_l + specular[channel] * shine;
}

/* Blinn, 1977: ambient + sum over lights of gate(N.L > 0) (diffuse N.L + specular (N.H)^p), clamped at 1. */
static void shade(const drawing *draw, const double place[3], const double normal[3], reference_pixel *pixel) {
    const glint_material *material = draw->material;
    const glint_colour *ambient = &draw->scene->ambient;
    double unit[3] = {normal[0], normal[1], normal[2]};
    double view[3] = {0, 0, 1};
    normalise(unit);
    if (draw->scene->viewer == GLINT_VIEWER_LOCAL) {
        for (int axis = 0; axis < 3; axis++)
            view[axis] = -place[axis];
        normalise(view);
    }
    pixel->grazing = 1;
    pixel->colour[0] = real(material->ambient.r) * real(ambient->r);
    pixel->colour[1] = real(material->ambient.g) * real(ambient->g);
    pixel->colour[2] = real(material->ambient.b) * real(ambient->b);
    for (uint32_t index = 0; index < draw->scene->light_count; index++)
        add_light(draw, index, unit, view, pixel);
    for (int channel = 0; channel < 3; channel++)
        pixel->colour[channel] = fmin(pixel->colour[channel], 1);
}

/* ---- Raster -------------------------------------------------------------------------------------------------- */

/* Twice the area of (a, b, p), positive when clockwise as seen on the screen, whose y runs down. */
static int64_t edge(const corner *a, const corner *b, int64_t x, int64_t y) {
    return (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
}

/* Clockwise on the screen, a top edge runs right and a left edge runs up. */
static int is_top_left(const corner *a, const corner *b) {
    return b->y < a->y || (b->y == a->y && b->x > a->x);
}

static void draw_fragment(const drawing *draw, const corner *const c[3], const double weight[3],
                          reference_pixel *pixel) {
    double place[3] = {0, 0, 0};
    double normal[3] = {0, 0, 0};
    double depth = 0;
    for (int i = 0; i < 3; i++)
        depth += weight[i] / c[i]->w;
    if (depth <= pixel->nearest) {
        pixel->second = fmax(pixel->second, depth);
        return;
    }
    for (int i = 0; i < 3; i++) {
        double share = weight[i] / c[i]->w / depth;
        for (int axis = 0; axis < 3; axis++) {
            place[axis] += share * c[i]->place[axis];
            normal[axis] += share * c[i]->normal[axis];
        }
    }
    pixel->second = pixel->nearest;
    pixel->nearest = depth;
    pixel->covered = 1;
    shade(draw, place, normal, pixel);
}

/* The pixels of 28.4 values and two sixteenths beyond, cut to the screen. */
static void pixel_range(const int64_t value[3], int size, int *first, int *last) {
    int64_t least = value[0] < value[1] ? value[0] : value[1];
    int64_t most = value[0] > value[1] ? value[0] : value[1];
    least = least < value[2] ? least : value[2];
    most = most > value[2] ? most : value[2];
    least -= 2;
    most += 2;
    *first = least < 0 ? 0 : (int)(least / 16 < size ? least / 16 : size);
    *last = most < 0 ? -1 : (int)(most / 16 < size ? most / 16 : size - 1);
}

/* How far inside a triangle a pixel's centre lies: weights of the corners, and sixteenths from the nearest edge. */
typedef struct position {
    double weight[3];
    double distance;
    int inside;
} position;

static position locate(const corner *const c[3], int64_t area, int x, int y) {
    position at = {.distance = INFINITY, .inside = 1};
    for (int i = 0; i < 3; i++) {
        const corner *a = c[(i + 1) % 3];
        const corner *b = c[(i + 2) % 3];
        int64_t value = edge(a, b, 16 * (int64_t)x + 8, 16 * (int64_t)y + 8);
        at.inside &= value > 0 || (value == 0 && is_top_left(a, b));
        at.weight[i] = (double)value / (double)area;
        at.distance = fmin(at.distance, (double)value / hypot((double)(b->x - a->x), (double)(b->y - a->y)));
    }
    return at;
}

/* Corners clockwise on the screen, area above 0. */
static void draw_clockwise(const drawing *draw, const corner *const c[3], int64_t area) {
    const int64_t xs[3] = {c[0]->x, c[1]->x, c[2]->x};
    const int64_t ys[3] = {c[0]->y, c[1]->y, c[2]->y};
    int first_x, last_x, first_y, last_y;
    pixel_range(xs, draw->image->width, &first_x, &last_x);
    pixel_range(ys, draw->image->height, &first_y, &last_y);
    for (int y = first_y; y <= last_y; y++) {
        for (int x = first_x; x <= last_x; x++) {
            reference_pixel *pixel = &draw->image->pixels[(size_t)y * (size_t)draw->image->width + (size_t)x];
            position at = locate(c, area, x, y);
            pixel->uncertain |= draw->rounded_here && fabs(at.distance) <= 1.5;
            if (at.inside)
                draw_fragment(draw, c, at.weight, pixel);
        }
    }
}

/* Culls, turns and draws; corners are counter-clockwise in a right-handed view when seen from outside. */
static void draw_triangle(const drawing *draw, const corner *a, const corner *b, const corner *c, int mirrored,
                          int double_sided) {
    int64_t area = edge(a, b, c->x, c->y);
    int front = mirrored ? area > 0 : area < 0;
    if (area == 0 || (!front && !double_sided))
        return;
    corner turned[3] = {*a, *b, *c};
    for (int i = 0; i < 3 && !front; i++) {
        for (int axis = 0; axis < 3; axis++)
            turned[i].normal[axis] = -turned[i].normal[axis];
    }
    const corner *const clockwise[3] = {&turned[0], &turned[area > 0 ? 1 : 2], &turned[area > 0 ? 2 : 1]};
    draw_clockwise(draw, clockwise, area > 0 ? area : -area);
}

/* ---- Clipping ------------------------------------------------------------------------------------------------ */

/* Rounds a screen position to 28.4, half up. Good to 2^28 pixels, beyond which edge functions leave 64 bits. */
static void snap(const drawing *draw, corner *c) {
    double focal = focal_length(draw->scene, draw->image->height);
    c->w = -c->place[2];
    c->x = (int64_t)floor(16 * (0.5 * draw->image->width + focal * c->place[0] / c->w) + 0.5);
    c->y = (int64_t)floor(16 * (0.5 * draw->image->height - focal * c->place[1] / c->w) + 0.5);
}

static corner between(const drawing *draw, const corner *in, const corner *out, double near) {
    double t = (in->w - near) / (in->w - out->w);
    corner cut;
    for (int axis = 0; axis < 3; axis++) {
        cut.place[axis] = in->place[axis] + t * (out->place[axis] - in->place[axis]);
        cut.normal[axis] = in->normal[axis] + t * (out->normal[axis] - in->normal[axis]);
    }
    cut.place[2] = -near;
    snap(draw, &cut);
    return cut;
}

/* Keeps the part with w >= near (Sutherland and Hodgman, 1974). @return its number of corners. */
static int clip(const drawing *draw, const corner c[3], corner kept[CORNERS_MAX]) {
    double near = real(draw->scene->camera.near_plane);
    int count = 0;
    for (int i = 0; i < 3; i++) {
        const corner *from = &c[i];
        const corner *to = &c[(i + 1) % 3];
        if (from->w >= near)
            kept[count++] = *from;
        if (from->w >= near && to->w < near)
            kept[count++] = between(draw, from, to, near);
        if (from->w < near && to->w >= near)
            kept[count++] = between(draw, to, from, near);
    }
    return count;
}

static void draw_object_triangle(const drawing *draw, uint32_t object, uint32_t triangle,
                                 const reference_position *positions) {
    const glint_object *source = &draw->scene->objects[object];
    const uint16_t *indices = source->mesh->triangles[triangle];
    corner corners[3];
    corner kept[CORNERS_MAX];
    double cofactor[3][3];
    int mirrored = cofactors(&source->pose, cofactor) < 0;
    int known = positions != NULL;
    for (int i = 0; i < 3; i++) {
        reference_vertex vertex =
            reference_transform(draw->scene, object, indices[i], draw->image->width, draw->image->height);
        memcpy(corners[i].place, vertex.place, sizeof vertex.place);
        memcpy(corners[i].normal, vertex.normal, sizeof vertex.normal);
        corners[i].w = vertex.w;
        known = known && positions[indices[i]].known && vertex.w >= real(draw->scene->camera.near_plane);
    }
    drawing local = *draw;
    local.rounded_here = !known;
    int count = clip(draw, corners, kept);
    for (int i = 0; i < count; i++) {
        snap(draw, &kept[i]);
        if (known) {
            kept[i].x = positions[indices[i]].x;
            kept[i].y = positions[indices[i]].y;
        }
    }
    for (int i = 2; i < count; i++)
        draw_triangle(&local, &kept[0], &kept[i - 1], &kept[i], mirrored,
                      source->mesh->flags & GLINT_MESH_DOUBLE_SIDED);
}

/* ---- Scene --------------------------------------------------------------------------------------------------- */

static void clear(const reference_image *image, const glint_colour *background) {
    const reference_pixel empty = {
        .colour = {fmin(real(background->r), 1), fmin(real(background->g), 1), fmin(real(background->b), 1)}};
    for (int i = 0; i < image->width * image->height; i++)
        image->pixels[i] = empty;
}

static void prepare_lights(const glint_scene *scene, light_vectors *lights) {
    for (uint32_t index = 0; index < scene->light_count; index++) {
        const glint_vector *vector = &scene->lights[index].vector;
        const double world[3] = {real(vector->x), real(vector->y), real(vector->z)};
        rotate_to_camera(&scene->camera, world, lights->towards[index]);
        normalise(lights->towards[index]);
    }
}

void reference_render(const reference_image *image, const glint_scene *scene,
                      const reference_position *const *positions) {
    drawing draw = {.image = image, .scene = scene};
    clear(image, &scene->background);
    prepare_lights(scene, &draw.lights);
    for (uint32_t object = 0; object < scene->object_count; object++) {
        draw.material = scene->objects[object].material;
        for (uint32_t triangle = 0; triangle < scene->objects[object].mesh->triangle_count; triangle++)
            draw_object_triangle(&draw, object, triangle, positions ? positions[object] : NULL);
    }
}
