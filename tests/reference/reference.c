/* SPDX-License-Identifier: MIT */
#include "reference.h"

#include "bayer.h"
#include "glint_extras.h"
#include "lighting.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define CORNERS_MAX 8 /* a triangle cut by five planes */

/* What is interpolated between corners, all of it linear in camera space. */
typedef struct attributes {
    double place[3];
    double normal[3];
    double colour[3];  /* of the mesh */
    double texture[2]; /* in repeats */
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
    reference_surface facet;    /* what of the present triangle is lit, where it is lit once */
    int rounded_here;           /* the present triangle's screen positions are not given */
    int back;                   /* it is seen from the back */
    const glint_texture *level; /* of its texture, or null */
    int is_level_open;          /* another level may be seen: texels are not settled */
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
        for (int axis = 0; axis < 2; axis++)
            sum.texture[axis] += share[i] * at->texture[axis];
        sum.grazing[back] = fmin(sum.grazing[back], at->grazing[back]);
    }
    return sum;
}

/* Lights a fragment whose texel has a colour. */
static reference_light light_fragment(const drawing *draw, const attributes *at, const double texel[3]) {
    const glint_material *const material = draw->object->material;
    const glint_evaluation *const evaluation = draw->object->evaluation;
    reference_surface surface = draw->facet;
    reference_light result = {.grazing = at->grazing[draw->back]};
    if (evaluation == &glint_per_vertex) {
        for (int channel = 0; channel < 3; channel++)
            result.colour[channel] = at->lit[draw->back][channel] * texel[channel];
        return result;
    }
    if (evaluation != &glint_per_facet) {
        memcpy(surface.place, at->place, sizeof surface.place);
        memcpy(surface.normal, at->normal, sizeof surface.normal);
        memcpy(surface.colour, at->colour, sizeof surface.colour);
    }
    if (evaluation == &glint_per_facet) {
        result = reference_shade(draw->scene, &draw->lights, material, &surface);
        for (int channel = 0; channel < 3; channel++)
            result.colour[channel] *= texel[channel];
        return result;
    }
    for (int channel = 0; channel < 3; channel++)
        surface.colour[channel] *= texel[channel];
    return reference_shade(draw->scene, &draw->lights, material, &surface);
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

/* Finds each corner's share, in space, of a point whose weights on the screen are given. @return its depth */
static double find_shares(const drawing *draw, const corner *const c[3], const double weight[3], double share[3]) {
    const int is_parallel = draw->scene->camera.projection != NULL;
    double depth = 0;
    for (int i = 0; i < 3; i++)
        depth += is_parallel ? weight[i] * (REFERENCE_FAR - c[i]->w) : weight[i] / c[i]->w;
    for (int i = 0; i < 3; i++)
        share[i] = is_parallel ? weight[i] : weight[i] / c[i]->w / depth;
    return depth;
}

/* ---- Textures ---- */

/* Sixteenths of a pixel by which corners may be off: those given are the library's own, and it cuts others itself. */
#define SNAPPED 1
#define SNAPPED_APART 2

/* Finds the coordinates within what corners may be off by; all there are where some of that lies behind the eye. */
static void find_window(const drawing *draw, const corner *const c[3], double area, int x, int y, const double at[2],
                        double window[2][2]) {
    const int reach = draw->rounded_here ? SNAPPED_APART : SNAPPED;
    for (int axis = 0; axis < 2; axis++)
        window[axis][0] = window[axis][1] = at[axis];
    for (int i = 0; i < 4; i++) {
        double weight[3], share[3];
        for (int j = 0; j < 3; j++)
            weight[j] = (double)edge(c[(j + 1) % 3], c[(j + 2) % 3], 16 * (int64_t)x + 8 + (i % 2 ? reach : -reach),
                                     16 * (int64_t)y + 8 + (i / 2 ? reach : -reach)) /
                        area;
        const double depth = find_shares(draw, c, weight, share);
        for (int axis = 0; axis < 2; axis++) {
            const double there = share[0] * c[0]->at.texture[axis] + share[1] * c[1]->at.texture[axis] +
                                 share[2] * c[2]->at.texture[axis];
            window[axis][0] = depth > 0 ? fmin(window[axis][0], there) : -INFINITY;
            window[axis][1] = depth > 0 ? fmax(window[axis][1], there) : INFINITY;
        }
    }
}

/* Sets what a pixel of a texture may show. @return the light of its own texel */
static reference_light light_texels(const drawing *draw, const attributes *at, const reference_texels *texels,
                                    reference_pixel *pixel) {
    pixel->choice_count = texels->count;
    pixel->unsettled = !texels->count && !texels->may_differ;
    for (int i = 0; i < texels->count; i++) {
        const reference_light least = light_fragment(draw, at, texels->least[i]),
                              most = light_fragment(draw, at, texels->most[i]);
        memcpy(pixel->choices[i].least, least.colour, sizeof least.colour);
        memcpy(pixel->choices[i].most, most.colour, sizeof most.colour);
    }
    return light_fragment(draw, at, texels->exact);
}

/* Of 1; a single channel is the luma. */
static double value_of(const double colour[3], int channels, int channel) {
    return channels == 1 ? 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2] : colour[channel];
}

int reference_find_wanted(const reference_pixel *pixel, int channels, const int most[3], const double stored[3],
                          double wanted[3]) {
    double apart = INFINITY;
    int is_other = 0;
    for (int i = -1; i < pixel->choice_count; i++) {
        const double *const first = i < 0 ? pixel->colour : pixel->choices[i].least, *const last =
                                                                                         i < 0 ? pixel->colour
                                                                                               : pixel->choices[i].most;
        double nearest[3], there = 0;
        for (int channel = 0; channel < channels; channel++) {
            nearest[channel] = fmax(most[channel] * value_of(first, channels, channel),
                                    fmin(most[channel] * value_of(last, channels, channel), stored[channel]));
            there = fmax(there, fabs(nearest[channel] - stored[channel]));
        }
        if (there >= apart)
            continue;
        apart = there;
        is_other = i >= 0;
        memcpy(wanted, nearest, sizeof nearest);
    }
    return is_other;
}

/* ---- Pixels ---- */

/* Weights of the corners are `value` of `area`. */
static void draw_fragment(const drawing *draw, const corner *const c[3], const int64_t value[3], double area, int x,
                          int y) {
    static const double white[3] = {1, 1, 1};
    const glint_material *const material = draw->object->material;
    const double weight[3] = {(double)value[0] / area, (double)value[1] / area, (double)value[2] / area};
    reference_pixel *pixel = &draw->image->pixels[(size_t)y * (size_t)draw->image->width + (size_t)x];
    reference_texels texels;
    double share[3], window[2][2];
    const double depth = find_shares(draw, c, weight, share);
    attributes at = mix(c, share, draw->back);
    if (material->texture) {
        find_window(draw, c, area, x, y, at.texture, window);
        reference_sample(draw->level, material->flags, at.texture, (const double(*)[2])window, &texels);
        if (draw->is_level_open) {
            texels.count = 0;
            texels.may_differ = draw->level->flags != 0;
        }
        if (texels.may_differ)
            pixel->torn = fmax(pixel->torn, depth);
        if (material->texture->flags)
            pixel->keyed = fmax(pixel->keyed, depth);
        if (texels.is_hole)
            return;
    }
    if (depth <= pixel->nearest) {
        if (depth > pixel->second)
            pixel->rounded[1] = draw->rounded_here;
        pixel->second = fmax(pixel->second, depth);
        return;
    }
    place_on_ray(draw, x, y, depth, at.place);
    pixel->choice_count = pixel->unsettled = 0;
    pixel->is_level_open = draw->is_level_open;
    const reference_light plain = light_fragment(draw, &at, white),
                          light = material->texture ? light_texels(draw, &at, &texels, pixel) : plain;
    pixel->second = pixel->nearest;
    pixel->rounded[1] = pixel->rounded[0];
    pixel->nearest = depth;
    pixel->rounded[0] = draw->rounded_here;
    pixel->covered = 1;
    pixel->object = (uint32_t)(draw->object - draw->scene->objects);
    pixel->grazing = light.grazing;
    memcpy(pixel->colour, light.colour, sizeof pixel->colour);
    memcpy(pixel->plain, plain.colour, sizeof pixel->plain);
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

/* Does the present object cover a pixel, where it covers some in a pattern? */
static int is_kept(const drawing *draw, int x, int y) {
    const glint_material *const material = draw->object->material;
    return material->blend != GLINT_BLEND_DITHERED || bayer_threshold(x, y) < reference_real(material->opacity);
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
            if (!is_kept(draw, x, y))
                continue;
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

/* Positions are at most so many pixels from the screen's centre, that edge functions stay within 64 bits. */
#define FARTHEST_PIXEL 67108864.0

/* Rounds a screen position to 28.4, half up. */
static void snap(const drawing *draw, corner *c) {
    double screen[2];
    c->w = -c->at.place[2];
    find_screen(draw->scene, draw->focal, draw->image->width, draw->image->height, c->at.place, screen);
    c->x = (int64_t)floor(16 * screen[0] + 0.5);
    c->y = (int64_t)floor(16 * screen[1] + 0.5);
}

/* The corner at t of the way from one to another. */
static corner between(const corner *in, const corner *out, double t) {
    const double share[3] = {1 - t, t, 0};
    const corner *const ends[3] = {in, out, out};
    const attributes back = mix(ends, share, 1);
    corner cut = {.at = mix(ends, share, 0)};
    memcpy(cut.at.lit[1], back.lit[1], sizeof back.lit[1]);
    cut.at.grazing[1] = back.grazing[1];
    return cut;
}

/* How far inside a plane a corner lies: the near plane, or one of four sides FARTHEST_PIXEL from the centre. */
static double inside_of(const drawing *draw, const corner *c, int plane) {
    const double side = FARTHEST_PIXEL / draw->focal * c->w;
    if (plane == 0)
        return c->w - reference_real(draw->scene->camera.near_plane);
    return plane % 2 ? side - c->at.place[plane / 3] : side + c->at.place[plane / 3];
}

/* Keeps the part inside a plane (Sutherland and Hodgman, 1974). @return its number of corners. */
static int clip_at(const drawing *draw, int plane, const corner *c, int corners, corner kept[CORNERS_MAX]) {
    int count = 0;
    for (int i = 0; i < corners; i++) {
        const corner *from = &c[i];
        const corner *to = &c[(i + 1) % corners];
        const double here = inside_of(draw, from, plane);
        const double there = inside_of(draw, to, plane);
        if (here >= 0 && count < CORNERS_MAX)
            kept[count++] = *from;
        if ((here >= 0) == (there >= 0) || count == CORNERS_MAX)
            continue;
        const corner *const in = here >= 0 ? from : to;
        const corner *const out = here >= 0 ? to : from;
        corner *const cut = &kept[count++];
        if (plane == 0) {
            const double near = reference_real(draw->scene->camera.near_plane);
            *cut = between(in, out, (in->w - near) / (in->w - out->w));
            cut->at.place[2] = -near;
        } else {
            *cut = between(in, out, fmax(here, there) / fabs(here - there));
        }
        cut->w = -cut->at.place[2];
    }
    return count;
}

/* Is a corner beyond FARTHEST_PIXEL? */
static int is_beyond(const drawing *draw, const corner *c, int count) {
    int found = 0;
    for (int i = 0; i < count; i++)
        for (int plane = 1; plane < 5; plane++)
            found |= inside_of(draw, &c[i], plane) < 0;
    return found && draw->scene->camera.projection == NULL;
}

/* Keeps the part of a triangle beyond the near plane, and of that what edge functions can hold. */
static int clip(const drawing *draw, const corner c[3], corner kept[CORNERS_MAX]) {
    corner other[CORNERS_MAX];
    int count = clip_at(draw, 0, c, 3, kept);
    for (int plane = 1; plane < 5 && is_beyond(draw, kept, count); plane++) {
        memcpy(other, kept, sizeof other);
        count = clip_at(draw, plane, other, count, kept);
    }
    return count;
}

/*
 * Finds what is lit once a triangle: the mean of its corners, with the normal of its plane turned towards the eye: on
 * the side that corners on the screen show, where they are known.
 */
static reference_surface find_facet(const drawing *draw, const corner c[3], int is_known) {
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
    return surface;
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
    reference_mesh_texture(draw->object->mesh, index, result.at.texture);
    if (draw->object->evaluation == &glint_per_vertex)
        light_vertex(draw, &result.at);
    return result;
}

/* Chooses the level of a triangle whose corners are known. Others are clipped, and show the texture itself. */
static void choose_level(drawing *draw, const corner corners[3], int known) {
    double coordinates[3][2];
    draw->level = draw->object->material->texture;
    draw->is_level_open = 0;
    if (!draw->level || !known)
        return;
    for (int i = 0; i < 3; i++)
        memcpy(coordinates[i], corners[i].at.texture, sizeof coordinates[i]);
    const double pixels = fabs((double)edge(&corners[0], &corners[1], corners[2].x, corners[2].y)) / 256;
    draw->level = reference_choose_level(draw->level, (const double(*)[2])coordinates, pixels, &draw->is_level_open);
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
    choose_level(draw, corners, known);
    if (source->evaluation == &glint_per_facet)
        draw->facet = find_facet(draw, corners, known);
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

/* ---- Layers and fog -------------------------------------------------------------------------------------------- */

static int is_layer(const glint_object *object) {
    return object->material->blend == GLINT_BLEND_ALPHA || object->material->blend == GLINT_BLEND_ADD;
}

/* How far the middle of an object's box lies from the eye along the camera's axis. */
static double find_middle(const glint_scene *scene, const glint_object *object) {
    const glint_pose *const camera = &scene->camera.pose;
    const glint_vector at = object->mesh->offset;
    const double local[3] = {reference_real(at.x), reference_real(at.y), reference_real(at.z)};
    double depth = 0;
    for (int row = 0; row < 3; row++) {
        const glint_q16 *const m = object->pose.m[row];
        double world = reference_real(m[3]) - reference_real(camera->m[row][3]);
        for (int axis = 0; axis < 3; axis++)
            world += reference_real(m[axis]) * local[axis];
        depth -= reference_real(camera->m[row][2]) * world;
    }
    return depth;
}

static int is_before(const glint_scene *scene, uint32_t a, uint32_t b) {
    const glint_object *const first = &scene->objects[a], *const second = &scene->objects[b];
    if (first->order != second->order)
        return first->order < second->order;
    return find_middle(scene, first) > find_middle(scene, second);
}

uint32_t reference_find_layers(const glint_scene *scene, uint32_t *layers) {
    uint32_t count = 0;
    for (uint32_t object = 0; object < scene->object_count; object++) {
        uint32_t place = count;
        if (scene->objects[object].hidden || !is_layer(&scene->objects[object]))
            continue;
        for (; place > 0 && is_before(scene, object, layers[place - 1]); place--)
            layers[place] = layers[place - 1];
        layers[place] = object;
        count++;
    }
    return count;
}

double reference_fog(const glint_fog *fog, double depth) {
    const double start = reference_real(fog->start), end = reference_real(fog->end);
    const double part = fmax(0, fmin(1, (depth - start) / (end - start)));
    return fog->type == &glint_fog_squared ? part * part : part;
}

/* ---- Scene --------------------------------------------------------------------------------------------------- */

static void clear(const reference_image *image, const glint_colour *background) {
    const reference_pixel empty = {.colour = {fmin(reference_real(background->r), 1),
                                              fmin(reference_real(background->g), 1),
                                              fmin(reference_real(background->b), 1)}};
    for (int i = 0; i < image->width * image->height; i++)
        image->pixels[i] = empty;
}

/* Draws all that are not blended, or one object. */
static void render(const reference_image *image, const glint_scene *scene, const reference_position *const *positions,
                   const uint32_t *only) {
    drawing draw = {.image = image, .scene = scene, .focal = focal_length(scene, image->height)};
    clear(image, &scene->background);
    reference_prepare_lights(&draw.lights, scene, image->height);
    for (uint32_t object = 0; object < scene->object_count; object++)
        if (only ? object == *only : !is_layer(&scene->objects[object]))
            draw_object(&draw, object, positions ? positions[object] : NULL);
    for (int i = 0; i < image->width * image->height; i++)
        image->pixels[i].uncertain |= image->pixels[i].torn > 0 && image->pixels[i].torn >= image->pixels[i].nearest;
}

void reference_render(const reference_image *image, const glint_scene *scene,
                      const reference_position *const *positions) {
    render(image, scene, positions, NULL);
}

void reference_render_object(const reference_image *image, const glint_scene *scene, uint32_t object,
                             const reference_position *const *positions) {
    render(image, scene, positions, &object);
}
