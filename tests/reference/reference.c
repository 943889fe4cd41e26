/* SPDX-License-Identifier: MIT */
#include "reference.h"

#include "lighting.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define CORNERS_MAX 4 /* a triangle cut by one plane */

/* What is interpolated between corners, all of it linear in camera space. */
typedef struct attributes {
    double place[3];
    double normal[3];
    double colour[3];  /* of the mesh */
    double lit[2][3];  /* per vertex: clamped colours of the front and the back */
    double grazing[2]; /* not interpolated: the smallest counts */
} attributes;

/* A triangle's corner as it is drawn. */
typedef struct corner {
    attributes at;
    double w;
    int64_t x, y; /* 28.4 */
    int is_given; /* they are those of the renderer under judgement */
} corner;

typedef struct drawing {
    const reference_image *image;
    const glint_scene *scene;
    const glint_object *object;
    double focal; /* pixels per unit of x/w and y/w */
    reference_lights lights;
    reference_light facet; /* the present triangle's colour, where it is lit once */
    int rounded_here;      /* the present triangle's screen positions are not given */
    int back;              /* it is seen from the back */
} drawing;

/* The cofactors of a pose's linear part: its transposed inverse times the determinant. @return the determinant. */
static double cofactors(const glint_pose *pose, double cofactor[3][3]) {
    double m[3][3];
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++)
            m[row][column] = reference_real(pose->m[row][column]);
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
    return reference_dot(m[0], cofactor[0]);
}

/* By the transposed inverse, up to a positive factor. */
static void transform_normal(const glint_pose *pose, const double object[3], double world[3]) {
    double cofactor[3][3];
    double sign = cofactors(pose, cofactor) < 0 ? -1 : 1;
    for (int row = 0; row < 3; row++)
        world[row] = sign * reference_dot(cofactor[row], object);
}

static void transform_place(const glint_scene *scene, const glint_object *object, uint32_t index, double place[3]) {
    const glint_mesh *mesh = object->mesh;
    const glint_camera *camera = &scene->camera;
    const glint_q16 offset[3] = {mesh->offset.x, mesh->offset.y, mesh->offset.z};
    const glint_q16 extent[3] = {mesh->extent.x, mesh->extent.y, mesh->extent.z};
    double local[3];
    double world[3];
    reference_mesh_position(mesh, index, local);
    for (int axis = 0; axis < 3; axis++)
        local[axis] = reference_real(offset[axis]) + reference_real(extent[axis]) * local[axis];
    for (int row = 0; row < 3; row++) {
        const glint_q16 *m = object->pose.m[row];
        world[row] = reference_real(m[0]) * local[0] + reference_real(m[1]) * local[1] +
                     reference_real(m[2]) * local[2] + reference_real(m[3]);
        world[row] -= reference_real(camera->pose.m[row][3]);
    }
    reference_to_camera(camera, world, place);
}

/* Pixels per unit of x/w and y/w: pixels are square, the field of view is vertical. */
static double focal_length(const glint_scene *scene, int height) {
    const double degree = 3.14159265358979323846 / 180;
    return 0.5 * height / tan(0.5 * reference_real(scene->camera.field_of_view) * degree);
}

/* Where a place in camera space shows: parallel rays take no notice of how far it is. */
static void find_screen(const glint_scene *scene, double focal, int width, int height, const double place[3],
                        double screen[2]) {
    const double scale =
        scene->camera.projection ? height / reference_real(scene->camera.view_height) : focal / -place[2];
    screen[0] = 0.5 * width + scale * place[0];
    screen[1] = 0.5 * height - scale * place[1];
}

static reference_vertex transform(const glint_scene *scene, double focal, uint32_t object, uint32_t index, int width,
                                  int height) {
    const glint_object *source = &scene->objects[object];
    double normal[3];
    double world[3];
    double screen[2];
    reference_vertex vertex = {{0}, {0}, 0, 0, 0};
    transform_place(scene, source, index, vertex.place);
    reference_mesh_normal(source->mesh, index, normal);
    transform_normal(&source->pose, normal, world);
    reference_to_camera(&scene->camera, world, vertex.normal);
    reference_normalise(vertex.normal);
    vertex.w = -vertex.place[2];
    find_screen(scene, focal, width, height, vertex.place, screen);
    vertex.x = screen[0];
    vertex.y = screen[1];
    return vertex;
}

reference_vertex reference_transform(const glint_scene *scene, uint32_t object, uint32_t index, int width, int height) {
    return transform(scene, focal_length(scene, height), object, index, width, height);
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

/* sum of weight times attribute; the normal points to the viewer's side */
static attributes mix(const corner *const c[3], const double share[3], int back) {
    attributes sum = {.grazing = {1, 1}};
    for (int i = 0; i < 3; i++) {
        const attributes *at = &c[i]->at;
        for (int axis = 0; axis < 3; axis++) {
            sum.place[axis] += share[i] * at->place[axis];
            sum.normal[axis] += share[i] * (back ? -at->normal[axis] : at->normal[axis]);
            sum.colour[axis] += share[i] * at->colour[axis];
            sum.lit[back][axis] += share[i] * at->lit[back][axis];
        }
        sum.grazing[back] = fmin(sum.grazing[back], at->grazing[back]);
    }
    return sum;
}

static reference_light light_fragment(const drawing *draw, const attributes *at) {
    reference_surface surface;
    reference_light result = {.grazing = at->grazing[draw->back]};
    if (draw->object->evaluation == &glint_per_facet)
        return draw->facet;
    if (draw->object->evaluation == &glint_per_vertex) {
        memcpy(result.colour, at->lit[draw->back], sizeof result.colour);
        return result;
    }
    memcpy(surface.place, at->place, sizeof surface.place);
    memcpy(surface.normal, at->normal, sizeof surface.normal);
    memcpy(surface.colour, at->colour, sizeof surface.colour);
    return reference_shade(draw->scene, &draw->lights, draw->object->material, &surface);
}

/* The point of depth 1/w seen through a pixel's centre: exact, where the corners' weights would add their rounding. */
static void place_on_ray(const drawing *draw, int x, int y, double depth, double place[3]) {
    const double focal = draw->focal;
    if (draw->scene->camera.projection) {
        const double pixel = reference_real(draw->scene->camera.view_height) / draw->image->height;
        place[0] = (x + 0.5 - 0.5 * draw->image->width) * pixel;
        place[1] = (0.5 * draw->image->height - y - 0.5) * pixel;
        place[2] = depth - REFERENCE_FAR;
        return;
    }
    place[0] = (x + 0.5 - 0.5 * draw->image->width) / focal / depth;
    place[1] = (0.5 * draw->image->height - y - 0.5) / focal / depth;
    place[2] = -1 / depth;
}

/* Weights of the corners are `value` of `area`. */
static void draw_fragment(const drawing *draw, const corner *const c[3], const int64_t value[3], double area, int x,
                          int y) {
    const double weight[3] = {(double)value[0] / area, (double)value[1] / area, (double)value[2] / area};
    reference_pixel *pixel = &draw->image->pixels[(size_t)y * (size_t)draw->image->width + (size_t)x];
    double share[3];
    double depth = 0;
    const int is_parallel = draw->scene->camera.projection != NULL;
    for (int i = 0; i < 3; i++)
        depth += is_parallel ? weight[i] * (REFERENCE_FAR - c[i]->w) : weight[i] / c[i]->w;
    if (depth <= pixel->nearest) {
        if (depth > pixel->second)
            pixel->rounded[1] = draw->rounded_here;
        pixel->second = fmax(pixel->second, depth);
        return;
    }
    for (int i = 0; i < 3; i++)
        share[i] = is_parallel ? weight[i] : weight[i] / c[i]->w / depth;
    attributes at = mix(c, share, draw->back);
    place_on_ray(draw, x, y, depth, at.place);
    const reference_light light = light_fragment(draw, &at);
    pixel->second = pixel->nearest;
    pixel->rounded[1] = pixel->rounded[0];
    pixel->nearest = depth;
    pixel->rounded[0] = draw->rounded_here;
    pixel->covered = 1;
    pixel->grazing = light.grazing;
    memcpy(pixel->colour, light.colour, sizeof pixel->colour);
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

/* A pixel's centre by the edges opposite to each corner: @return whether it lies inside. */
static int locate(const corner *const c[3], int x, int y, int64_t value[3]) {
    int inside = 1;
    for (int i = 0; i < 3; i++) {
        const corner *a = c[(i + 1) % 3];
        const corner *b = c[(i + 2) % 3];
        value[i] = edge(a, b, 16 * (int64_t)x + 8, 16 * (int64_t)y + 8);
        inside &= value[i] > 0 || (value[i] == 0 && is_top_left(a, b));
    }
    return inside;
}

/* Sixteenths from the nearest edge, below 0 outside. */
static double find_distance(const corner *const c[3], const int64_t value[3]) {
    double distance = INFINITY;
    for (int i = 0; i < 3; i++) {
        const corner *a = c[(i + 1) % 3];
        const corner *b = c[(i + 2) % 3];
        distance = fmin(distance, (double)value[i] / hypot((double)(b->x - a->x), (double)(b->y - a->y)));
    }
    return distance;
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
            int64_t value[3];
            const int inside = locate(c, x, y, value);
            pixel->uncertain |= draw->rounded_here && fabs(find_distance(c, value)) <= 1.5;
            if (inside)
                draw_fragment(draw, c, value, (double)area, x, y);
        }
    }
}

/* Culls, turns and draws; corners are counter-clockwise in a right-handed view when seen from outside. */
static void draw_triangle(drawing *draw, const corner *a, const corner *b, const corner *c, int mirrored) {
    int64_t area = edge(a, b, c->x, c->y);
    int front = mirrored ? area > 0 : area < 0;
    if (area == 0 || (!front && !(draw->object->mesh->flags & GLINT_MESH_DOUBLE_SIDED)))
        return;
    const corner *const clockwise[3] = {a, area > 0 ? b : c, area > 0 ? c : b};
    draw->back = !front;
    draw_clockwise(draw, clockwise, area > 0 ? area : -area);
}

/* ---- Clipping ------------------------------------------------------------------------------------------------ */

/* Rounds a screen position to 28.4, half up. Good to 2^28 pixels, beyond which edge functions leave 64 bits. */
static void snap(const drawing *draw, corner *c) {
    double screen[2];
    c->w = -c->at.place[2];
    find_screen(draw->scene, draw->focal, draw->image->width, draw->image->height, c->at.place, screen);
    c->x = (int64_t)floor(16 * screen[0] + 0.5);
    c->y = (int64_t)floor(16 * screen[1] + 0.5);
}

static corner between(const drawing *draw, const corner *in, const corner *out, double near) {
    const double t = (in->w - near) / (in->w - out->w);
    const double share[3] = {1 - t, t, 0};
    const corner *const ends[3] = {in, out, out};
    const attributes back = mix(ends, share, 1);
    corner cut = {.at = mix(ends, share, 0)};
    memcpy(cut.at.lit[1], back.lit[1], sizeof back.lit[1]);
    cut.at.grazing[1] = back.grazing[1];
    cut.at.place[2] = -near;
    snap(draw, &cut);
    return cut;
}

/* Keeps the part with w >= near (Sutherland and Hodgman, 1974). @return its number of corners. */
static int clip(const drawing *draw, const corner c[3], corner kept[CORNERS_MAX]) {
    double near = reference_real(draw->scene->camera.near_plane);
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

/*
 * Once a triangle: at the mean of its corners, with the normal of its plane turned towards the eye: on the side that
 * corners on the screen show, where they are known.
 */
static reference_light light_facet(const drawing *draw, const corner c[3], int is_known) {
    reference_surface surface;
    double a[3];
    double b[3];
    for (int axis = 0; axis < 3; axis++) {
        surface.place[axis] = (c[0].at.place[axis] + c[1].at.place[axis] + c[2].at.place[axis]) / 3;
        surface.colour[axis] = (c[0].at.colour[axis] + c[1].at.colour[axis] + c[2].at.colour[axis]) / 3;
        a[axis] = c[1].at.place[axis] - c[0].at.place[axis];
        b[axis] = c[2].at.place[axis] - c[0].at.place[axis];
    }
    for (int axis = 0; axis < 3; axis++) {
        int next = (axis + 1) % 3;
        int last = (axis + 2) % 3;
        surface.normal[axis] = a[next] * b[last] - a[last] * b[next];
    }
    double away = is_known                         ? (double)edge(&c[0], &c[1], c[2].x, c[2].y)
                  : draw->scene->camera.projection ? -surface.normal[2]
                                                   : reference_dot(surface.normal, surface.place);
    for (int axis = 0; axis < 3 && away > 0; axis++)
        surface.normal[axis] = -surface.normal[axis];
    return reference_shade(draw->scene, &draw->lights, draw->object->material, &surface);
}

/* Both sides of a vertex. */
static void light_vertex(const drawing *draw, attributes *at) {
    for (int back = 0; back < 2; back++) {
        reference_surface surface;
        memcpy(surface.place, at->place, sizeof surface.place);
        memcpy(surface.colour, at->colour, sizeof surface.colour);
        for (int axis = 0; axis < 3; axis++)
            surface.normal[axis] = back ? -at->normal[axis] : at->normal[axis];
        const reference_light light = reference_shade(draw->scene, &draw->lights, draw->object->material, &surface);
        memcpy(at->lit[back], light.colour, sizeof light.colour);
        at->grazing[back] = light.grazing;
    }
}

static corner make_corner(const drawing *draw, uint32_t object, uint32_t index) {
    const reference_vertex vertex =
        transform(draw->scene, draw->focal, object, index, draw->image->width, draw->image->height);
    corner result = {.at = {.grazing = {1, 1}}, .w = vertex.w};
    memcpy(result.at.place, vertex.place, sizeof vertex.place);
    memcpy(result.at.normal, vertex.normal, sizeof vertex.normal);
    reference_mesh_colour(draw->object->mesh, index, result.at.colour);
    if (draw->object->evaluation == &glint_per_vertex)
        light_vertex(draw, &result.at);
    return result;
}

/* Of vertices, or where there is none: without memory for them each is found whenever a triangle has it. */
static void draw_object_triangle(drawing *draw, uint32_t object, const corner *vertices, uint32_t triangle,
                                 const reference_position *positions) {
    const glint_object *source = draw->object;
    uint32_t indices[3];
    corner corners[3];
    corner kept[CORNERS_MAX];
    double cofactor[3][3];
    int mirrored = cofactors(&source->pose, cofactor) < 0;
    int known = positions != NULL;
    reference_mesh_corners(source->mesh, triangle, indices);
    for (int i = 0; i < 3; i++) {
        corners[i] = vertices ? vertices[indices[i]] : make_corner(draw, object, indices[i]);
        corner *const c = &corners[i];
        c->is_given =
            positions && positions[indices[i]].known && c->w >= reference_real(draw->scene->camera.near_plane);
        known &= c->is_given;
        if (c->is_given) {
            c->x = positions[indices[i]].x;
            c->y = positions[indices[i]].y;
        }
    }
    draw->rounded_here = !known;
    if (source->evaluation == &glint_per_facet)
        draw->facet = light_facet(draw, corners, known);
    int count = clip(draw, corners, kept);
    for (int i = 0; i < count; i++) {
        if (!kept[i].is_given)
            snap(draw, &kept[i]);
    }
    for (int i = 2; i < count; i++)
        draw_triangle(draw, &kept[0], &kept[i - 1], &kept[i], mirrored);
}

static void draw_object(drawing *draw, uint32_t object, const reference_position *positions) {
    const glint_mesh *mesh = draw->scene->objects[object].mesh;
    corner *vertices = malloc((mesh->vertex_count + 1) * sizeof *vertices);
    draw->object = &draw->scene->objects[object];
    for (uint32_t index = 0; index < mesh->vertex_count && vertices; index++)
        vertices[index] = make_corner(draw, object, index);
    for (uint32_t triangle = 0; triangle < mesh->triangle_count; triangle++)
        draw_object_triangle(draw, object, vertices, triangle, positions);
    free(vertices);
}

/* ---- Scene --------------------------------------------------------------------------------------------------- */

static void clear(const reference_image *image, const glint_colour *background) {
    const reference_pixel empty = {.colour = {fmin(reference_real(background->r), 1),
                                              fmin(reference_real(background->g), 1),
                                              fmin(reference_real(background->b), 1)}};
    for (int i = 0; i < image->width * image->height; i++)
        image->pixels[i] = empty;
}

void reference_render(const reference_image *image, const glint_scene *scene,
                      const reference_position *const *positions) {
    drawing draw = {.image = image, .scene = scene, .focal = focal_length(scene, image->height)};
    clear(image, &scene->background);
    reference_prepare_lights(&draw.lights, scene, image->height);
    for (uint32_t object = 0; object < scene->object_count; object++)
        draw_object(&draw, object, positions ? positions[object] : NULL);
}
