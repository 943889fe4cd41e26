/* SPDX-License-Identifier: MIT */
/*
 * Corners: light at vertices (Gouraud, 1971) and at facets. The colour of each vertex or facet that is visible is
 * computed once, and clamped at 1. The file has three parts: the lights of an object, the light of a point, and the two
 * evaluations.
 */
#include "corners.h"
#include "wear.h"

#include "../geometry/geometry.h"
#include "../pixel/format.h"
#include "evaluation.h"

/* ---- An object's lights ---- */

/* Rotates a vector of the world. @return n: the rotated vector is 2^n times the result */
static int32_t rotate_vector(const glint_corner_space *space, const int64_t world[3], int32_t to[3]) {
    int32_t reduced[3];
    int64_t sum[3];
    const unsigned down = glint_reduce(world, reduced);
    for (int i = 0; i < 3; i++)
        sum[i] = glint_product(space->rotation[i][0], reduced[0]) + glint_product(space->rotation[i][1], reduced[1]) +
                 glint_product(space->rotation[i][2], reduced[2]);
    return (int32_t)(down + glint_reduce(sum, to));
}

/* Scales a matrix by a power of two, to 30 bits. @return n: the matrix is 2^n times the result */
static int32_t reduce_matrix(int64_t in[3][3], int32_t out[3][3]) {
    uint64_t all = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            all |= glint_magnitude64(in[i][j]);
    const int32_t down = (int32_t)glint_bits64(all) - 30;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            out[i][j] =
                (int32_t)(down > 0 ? glint_shift_right64(in[i][j], (unsigned)down) : in[i][j] * ((int64_t)1 << -down));
    return down;
}

/*
 * Returns whether the columns of a matrix are perpendicular and equally long, to within 2^-13 of their squares: then it
 * preserves cosines to within 2^-14. Entries are rounded to 15 bits, for which 2^15 is added to the tolerance. Sums are
 * modulo 2^32, as all squares and differences are below it.
 */
static int has_even_columns(int32_t m[3][3]) {
    int32_t column[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            column[j][i] = glint_shift_right(m[i][j] + (1 << 14), 15);
    uint32_t square[3];
    for (int j = 0; j < 3; j++) {
        const int32_t *a = column[j];
        square[j] = (uint32_t)(a[0] * a[0]) + (uint32_t)(a[1] * a[1]) + (uint32_t)(a[2] * a[2]);
    }
    const int32_t slack = (int32_t)((square[0] >> 13) + (1u << 15));
    for (int j = 0; j < 3; j++) {
        const int next = j < 2 ? j + 1 : 0;
        const int32_t dot = glint_dot32(column[j], column[next]), difference = (int32_t)(square[next] - square[j]);
        if (dot > slack || dot < -slack || difference > slack || difference < -slack)
            return 0;
    }
    return 1;
}

/*
 * Sets the mesh's own space: places of points are extents times steps, and vectors of the world are rotated by the
 * transpose of the pose's matrix M. As M scales too, places have to be multiplied by |column of M|^2.
 */
static void set_even_space(glint_corner_space *space, glint_corner_lights *to, int32_t m[3][3], int32_t m_exponent,
                           const glint_vector *extent) {
    const int32_t extents[3] = {extent->x, extent->y, extent->z};
    int64_t scaled[3];
    uint64_t square = 0, all = 0;
    for (int i = 0; i < 3; i++) {
        square += (uint64_t)glint_product(m[i][0], m[i][0]);
        for (int j = 0; j < 3; j++)
            space->rotation[j][i] = m[i][j];
    }
    const unsigned down =
        (glint_bits64(square) - 29) & ~1u; /* the square has 57 bits or more, of which 29 or 30 are left */
    const int32_t scale = (int32_t)(square >> down);
    space->inverse = (uint32_t)glint_inverse_root((uint32_t)scale); /* times UNIT / 2^15 */
    space->inverse += space->inverse >> 13;
    space->inverse_exponent = -30 - (int32_t)down / 2;
    for (int j = 0; j < 3; j++) {
        scaled[j] = glint_product(scale, extents[j]);
        all |= (uint64_t)scaled[j];
    }
    const unsigned bits = glint_bits64(all), cut = bits > 15 ? bits - 15 : 0;
    for (int j = 0; j < 3; j++) {
        const int32_t entry = (int32_t)((scaled[j] + ((int64_t)1 << cut >> 1)) >> cut);
        to->matrix[j][j] = glint_least(entry, 32766);
        space->range[j] = to->matrix[j][j] << 15;
    }
    /* M in Q16 is m 2^m_exponent, extents are Q16, steps are Q15, and vectors rotated by m are Q28 */
    space->exponent = (int32_t)(cut + down) + m_exponent - 19;
}

/* Sets the camera's space, where the pose scales unevenly: a matrix brings steps to places. */
static void set_camera_space(glint_corner_space *space, glint_corner_lights *to, const glint_view *view,
                             const glint_pose *pose, const glint_vector *extent) {
    const int32_t extents[3] = {extent->x, extent->y, extent->z};
    int64_t wide[3][3];
    int32_t scaled[3][3];
    uint64_t most = 0;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            wide[i][j] = glint_product(pose->m[i][j], extents[j]);
            space->rotation[i][j] = view->rotation[i][j];
        }
    }
    const int32_t down = reduce_matrix(wide, scaled);
    for (int i = 0; i < 3; i++) {
        uint64_t row = 0;
        for (int j = 0; j < 3; j++) {
            wide[i][j] = 0;
            for (int k = 0; k < 3; k++)
                wide[i][j] += glint_product(view->rotation[i][k], scaled[k][j]);
            row += glint_magnitude64(wide[i][j]);
        }
        most = row > most ? row : most;
    }
    const unsigned bits = glint_bits64(most + most / 8192), cut = bits > 15 ? bits - 15 : 0;
    for (int i = 0; i < 3; i++) {
        uint32_t row = 0;
        for (int j = 0; j < 3; j++) {
            to->matrix[i][j] = (int32_t)glint_shift_right64(wide[i][j], cut);
            row += (uint32_t)glint_magnitude64(to->matrix[i][j]);
        }
        space->range[i] = (int32_t)(row << 15);
    }
    space->inverse = 1u << 15;
    space->inverse_exponent = -31;
    space->exponent = (int32_t)cut + down - 19;
}

/* Chooses and sets the space in which an object is lit. */
static void set_space(glint_corner_space *space, glint_corner_lights *to, const glint_view *view,
                      const glint_object *object) {
    const glint_mesh *mesh = object->mesh;
    const int32_t offset[3] = {mesh->offset.x, mesh->offset.y, mesh->offset.z};
    int64_t wide[3][3];
    int32_t m[3][3];
    for (int i = 0; i < 3; i++) {
        space->middle[i] = (int64_t)object->pose.m[i][3] * (1 << 12);
        for (int j = 0; j < 3; j++) {
            wide[i][j] = object->pose.m[i][j];
            space->middle[i] += glint_shift_right64(glint_product(object->pose.m[i][j], offset[j]), 4);
        }
    }
    const int32_t exponent = reduce_matrix(wide, m);
    to->is_even = (uint8_t)has_even_columns(m);
    if (to->is_even)
        set_even_space(space, to, m, exponent, &mesh->extent);
    else
        set_camera_space(space, to, view, &object->pose, &mesh->extent);
}

/* Transforms a place of the world, Q16, to an object's space. @return its shift, which may be more than 31 */
static int32_t bring_place(const glint_corner_space *space, const int32_t world[3], glint_corner_place *to) {
    int64_t way[3];
    uint32_t most = 0;
    for (int i = 0; i < 3; i++)
        way[i] = (int64_t)world[i] * (1 << 12) - space->middle[i];
    const int32_t exact = rotate_vector(space, way, to->vector) - space->exponent, shift = glint_most(exact, 0);
    to->shift = (uint8_t)glint_least(shift, 31);
    for (int i = 0; i < 3; i++) {
        if (exact < 0)
            to->vector[i] = glint_shift_right(to->vector[i], (unsigned)glint_least(-exact, 31));
        most |= glint_magnitude_bits(to->vector[i]) + ((uint32_t)space->range[i] >> to->shift) + 2;
    }
    to->down = (uint8_t)glint_most(17 - (int32_t)glint_leading_zeros(most), 0);
    for (int i = 0; i < 3; i++)
        to->vector[i] += 1 << to->down >> 1;
    return shift;
}

/* Transforms a vector of the world, and makes it unit, 1 = GLINT_UNIT. */
static void bring_direction(const glint_corner_space *space, const int64_t world[3], int32_t to[3]) {
    int32_t exponent;
    rotate_vector(space, world, to);
    glint_corner_unit(to, &exponent);
}

void glint_corner_towards(const glint_corner_space *space, const glint_light *light, int32_t to[3]) {
    const int64_t towards[3] = {-(int64_t)light->direction.x, -(int64_t)light->direction.y,
                                -(int64_t)light->direction.z};
    bring_direction(space, towards, to);
}

/* Transforms the place or the direction of a light. */
static void bring_light(const glint_corner_space *space, const glint_light *light, glint_corner_light *to) {
    const int32_t position[3] = {light->position.x, light->position.y, light->position.z};
    if (light->type->bring)
        light->type->bring(light, space, bring_place(space, position, &to->place) + space->exponent, to);
    else
        glint_corner_towards(space, light, to->place.vector);
}

/* Sets the products of two extents, scaled so that the largest has 30 bits. */
static void set_areas(const glint_vector *extent, int32_t area[3]) {
    const uint32_t e[3] = {(uint32_t)extent->x, (uint32_t)extent->y, (uint32_t)extent->z};
    const uint64_t areas[3] = {glint_product_unsigned(e[1], e[2]), glint_product_unsigned(e[2], e[0]),
                               glint_product_unsigned(e[0], e[1])};
    const unsigned up = 64 - glint_bits64(areas[0] | areas[1] | areas[2] | 1);
    for (int i = 0; i < 3; i++)
        area[i] = (int32_t)(areas[i] << up >> 34);
}

/* Sets the lights that reach an object, in its space. Without lights no space is set. */
static void bring_lights(const glint_frame *frame, const glint_draw *draw, glint_corner_lights *to) {
    const glint_shading *shading = draw->shading;
    const uint32_t lights = shading->lights & ~draw->unreached, flags = shading->material->flags;
    const glint_object *object = glint_object_at(frame, draw->object);
    const glint_vector *extent = &object->mesh->extent;
    glint_corner_space space;
    to->object = draw->object + 1;
    to->count = 0;
    to->shading = shading;
    to->highlight = shading->material->model->highlight;
    to->mesh = object->mesh;
    to->has_colours = (uint8_t)glint_has_colours(object->mesh);
    to->is_cubic = extent->x == extent->y && extent->y == extent->z;
    if (draw->facets && !to->is_cubic)
        set_areas(extent, to->area);
    to->takes_largest = flags & GLINT_MATERIAL_MAX_WITH_AMBIENT && shading->material->model->is_lit;
    if (!lights)
        return;
    set_space(&space, to, frame->view, object);
    const int32_t *const back = frame->view->rotation[2];
    const int64_t towards_eye[3] = {back[0], back[1], back[2]};
    to->is_local = frame->view->local_viewer;
    if (to->is_local)
        bring_place(&space, frame->view->eye, &to->eye);
    else
        bring_direction(&space, towards_eye, to->eye.vector);
    for (uint32_t i = 0; lights >> i; i++) {
        glint_corner_light *light = &to->lights[to->count];
        if (!(lights >> i & 1))
            continue;
        light->source = &frame->view->lights[i];
        light->reach = light->source->type->reach;
        light->weights = &shading->weights[i];
        light->shines = shading->has_specular >> i & 1;
        light->is_gated = !(flags & GLINT_MATERIAL_SPECULAR_UNGATED);
        bring_light(&space, &frame->scene->lights[i], light);
        to->count++;
    }
}

/* Returns the lights of a draw's object, which are set now unless the last corner belongs to the same object. */
static inline const glint_corner_lights *lights_of(const glint_frame *frame, const glint_draw *draw) {
    glint_corner_lights *lights = frame->corners;
    if (lights->object != draw->object + 1)
        bring_lights(frame, draw, lights);
    return lights;
}

/* ---- A point's light ---- */

/* Adds an amount of light, Q15, to a colour, Q23. */
static inline void add_weighted(uint32_t colour[3], uint32_t amount, const uint32_t weight[3]) {
    colour[0] += amount * weight[0] >> 4;
    colour[1] += amount * weight[1] >> 4;
    colour[2] += amount * weight[2] >> 4;
}

/* Adds the diffuse and the specular light that all lights give to a point, Q23; both sums may be the same array. */
static GLINT_NOINLINE void add_point_lights(const glint_corner_lights *lights, const glint_lit_point *point,
                                            uint32_t diffuse[3], uint32_t specular[3]) {
    const glint_corner_light *light = lights->lights, *const end = light + lights->count;
    const glint_power_table *const table = &lights->shading->power;
    glint_corner_sight towards, view;
    const int32_t *towards_eye = lights->is_local ? 0 : lights->eye.vector;
    for (; light != end; light++) {
        const int32_t *direction = light->place.vector;
        uint32_t strength = 1u << 15;
        int32_t cosine;
        if (light->reach) {
            strength = light->reach(light, point, &towards);
            if (!strength)
                continue;
            direction = towards.direction;
            cosine = towards.cosine;
        } else {
            cosine = glint_shift_right(glint_dot32(point->normal, direction), 15);
        }
        if (cosine > 0) { /* the cosine is one part in 2^13 to 2^12 too small */
            const uint32_t amount = (uint32_t)(cosine + glint_shift_right(cosine, 13));
            add_weighted(diffuse, amount * strength >> 15, light->weights->diffuse);
        } else if (light->is_gated) {
            continue;
        }
        if (!light->shines)
            continue;
        if (!towards_eye) {
            glint_corner_see(&lights->eye, point, 0, &view);
            towards_eye = view.direction;
        }
        const uint32_t power = lights->highlight(table, point->normal, direction, towards_eye);
        if (power)
            add_weighted(specular, power * strength >> 15, light->weights->specular);
    }
}

/* Returns x times a channel of the surface's own colour, 1 = GLINT_COLOUR_ONE. */
static uint32_t times_own(uint32_t x, int16_t surface) {
    return (uint32_t)(glint_product_unsigned(x, (uint32_t)surface + 1) >> 15);
}

/* Finds the colour of a point, Q23, whose ambient, diffuse and specular light have to be kept apart: it has a colour of
 * its own, or takes the larger of ambient and all other light. */
static GLINT_NOINLINE void light_apart(const glint_corner_lights *lights, const glint_lit_point *point,
                                       const int16_t *surface, uint32_t colour[3]) {
    uint32_t diffuse[3] = {0, 0, 0}, specular[3] = {0, 0, 0};
    if (lights->count)
        add_point_lights(lights, point, diffuse, specular);
    for (int c = 0; c < 3; c++) {
        uint32_t ambient = lights->shading->ambient[c], sum = diffuse[c];
        if (surface) {
            ambient = times_own(ambient, surface[c]);
            sum = times_own(sum, surface[c]);
        }
        sum += specular[c];
        colour[c] = !lights->takes_largest ? sum + ambient : sum > ambient ? sum : ambient;
    }
}

/* Finds the colour of a point, Q23; `surface` is its own colour, or null. */
static inline void light_point(const glint_corner_lights *lights, const glint_lit_point *point, const int16_t *surface,
                               uint32_t colour[3]) {
    const uint32_t *const ambient = lights->shading->ambient;
    if (surface || lights->takes_largest) {
        light_apart(lights, point, surface, colour);
        return;
    }
    colour[0] = ambient[0];
    colour[1] = ambient[1];
    colour[2] = ambient[2];
    if (lights->count)
        add_point_lights(lights, point, colour, colour);
}

/* ---- Points of meshes ---- */

/* Normals of a mesh count as unit if their length lies between these. */
#define LEAST_UNIT 32761
#define MOST_UNIT 32769
#define LEAST_UNIT_SQUARE ((uint32_t)LEAST_UNIT * LEAST_UNIT)
#define UNIT_SQUARES ((uint32_t)MOST_UNIT * MOST_UNIT - LEAST_UNIT_SQUARE)

/* Sets a point's normal, unit, from a normal of the mesh that has any length, below 2^15 if the space is uneven. */
static inline void set_point_normal(const glint_draw *draw, const glint_corner_lights *lights, int32_t x, int32_t y,
                                    int32_t z, glint_lit_point *point) {
    int32_t *const n = point->normal, exponent;
    n[0] = x;
    n[1] = y;
    n[2] = z;
    if (lights->is_even) {
        if ((uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z) - LEAST_UNIT_SQUARE <= UNIT_SQUARES)
            return;
    } else {
        for (int i = 0; i < 3; i++)
            n[i] = glint_row_times(&draw->transform.normal[i], x, y, z, 0);
    }
    glint_corner_unit(n, &exponent);
}

/* Sets a point's place from its position in steps of the mesh. */
static inline void set_point_place(const glint_corner_lights *lights, int32_t x, int32_t y, int32_t z,
                                   glint_lit_point *point) {
    const int32_t(*m)[3] = lights->matrix;
    if (lights->is_even) {
        point->place[0] = m[0][0] * x;
        point->place[1] = m[1][1] * y;
        point->place[2] = m[2][2] * z;
        return;
    }
    for (int i = 0; i < 3; i++)
        point->place[i] = m[i][0] * x + m[i][1] * y + m[i][2] * z;
}

/* ---- Vertices ---- */

/* Sets a point to the place and the normal of a vertex. */
static inline void set_point_to_vertex(const glint_draw *draw, const glint_corner_lights *lights, uint32_t index,
                                       glint_lit_point *point) {
    const glint_mesh *mesh = lights->mesh;
    int16_t fetched[3];
    const int16_t *steps = glint_steps_of(mesh, index, fetched), *normal = fetched;
    set_point_place(lights, steps[0], steps[1], steps[2], point);
    if (mesh->normals)
        normal = mesh->normals[index];
    else
        glint_fetch(&mesh->layout->normals, index, 1, (int16_t(*)[3])(void *)fetched);
    set_point_normal(draw, lights, normal[0], normal[1], normal[2], point);
}

/* Stores light that a texture is still to multiply. */
static GLINT_NOINLINE void store_worn(const uint32_t colour[3], int16_t to[3]) {
    for (int c = 0; c < 3; c++)
        to[c] = (int16_t)((colour[c] < 1u << 23 ? colour[c] : 1u << 23) / 512 + GLINT_WORN_MARGIN);
}

/* Stores a corner's colour. */
static inline void store_corner(const glint_frame *frame, const glint_draw *draw, const uint32_t colour[3],
                                int16_t to[3]) {
    if (draw->texture)
        store_worn(colour, to);
    else
        glint_finish_corner(&frame->config, colour, to);
}

/* Finds the colour of vertex `slot` of a draw, and of double-sided meshes also its colour from behind. */
static void light_one_vertex(const glint_frame *frame, const glint_draw *draw, const glint_corner_lights *lights,
                             uint32_t slot) {
    glint_vertex *vertex = &draw->vertices[slot];
    int16_t own[3];
    uint32_t colour[3];
    glint_lit_point point;
    const int16_t *surface = 0;
    if (lights->count)
        set_point_to_vertex(draw, lights, (uint16_t)vertex->attribute[0], &point);
    if (lights->has_colours) { /* they are copied, as the colour from behind is stored in their place */
        for (int c = 0; c < 3; c++)
            own[c] = draw->extra[slot][c];
        surface = own;
    }
    vertex->flags |= GLINT_VERTEX_NORMAL;
    light_point(lights, &point, surface, colour);
    store_corner(frame, draw, colour, vertex->attribute);
    if (!draw->double_sided || !draw->extra)
        return;
    for (int i = 0; i < 3 && lights->count; i++)
        point.normal[i] = -point.normal[i];
    light_point(lights, &point, surface, colour);
    store_corner(frame, draw, colour, draw->extra[slot]);
}

/* Lights the vertices of a triangle that are not lit yet. */
static void light_corners(const glint_frame *frame, glint_draw *draw, const glint_transform *transform,
                          uint32_t triangle) {
    const uint16_t *corners = draw->triangles[triangle];
    const glint_corner_lights *lights = lights_of(frame, draw);
    (void)transform;
    for (int i = 0; i < 3; i++)
        if (!(draw->vertices[corners[i]].flags & GLINT_VERTEX_NORMAL))
            light_one_vertex(frame, draw, lights, corners[i]);
}

const glint_evaluation glint_per_vertex = {
    .lit_at = GLINT_LIT_AT_VERTICES, .light = light_corners, .draw_triangle = glint_draw_lit};

/* ---- Facets ---- */

/*
 * Turns a cross product of edges in steps into the normal in the mesh's space, by multiplying each component by the
 * product of the other two extents. It is not inlined, as most meshes have equal extents.
 */
static GLINT_NOINLINE void stretch_normal(const int32_t area[3], int32_t normal[3]) {
    const unsigned zeros = glint_leading_zeros(glint_magnitude_bits(normal[0]) | glint_magnitude_bits(normal[1]) |
                                               glint_magnitude_bits(normal[2]));
    for (int i = 0; i < 3; i++) /* the shift uses all bits */
        normal[i] = glint_product_high(area[i], glint_shift_left(normal[i], zeros - 1));
}

/*
 * Finds the cross product b x c of edges in steps, 16 bits and a sign, scaled to 31 bits. Products are exact, as those
 * of a sliver's edges nearly cancel.
 */
static inline void multiply_edges(int32_t bx, int32_t by, int32_t bz, int32_t cx, int32_t cy, int32_t cz,
                                  int32_t normal[3]) {
    const uint32_t all = glint_magnitude_bits(bx) | glint_magnitude_bits(by) | glint_magnitude_bits(bz) |
                         glint_magnitude_bits(cx) | glint_magnitude_bits(cy) | glint_magnitude_bits(cz);
    if (all >> 15) {
        const int64_t whole[3] = {glint_product(by, cz) - glint_product(bz, cy),
                                  glint_product(bz, cx) - glint_product(bx, cz),
                                  glint_product(bx, cy) - glint_product(by, cx)};
        glint_reduce(whole, normal);
        return;
    }
    normal[0] = by * cz - bz * cy; /* products are at most 2^30, and one of the two is below it */
    normal[1] = bz * cx - bx * cz;
    normal[2] = bx * cy - by * cx;
}

/* Returns whether the corners of a clipped triangle run clockwise on the screen, by the determinant of its clip
 * coordinates. */
static int is_clockwise(const glint_view *view, const glint_position *const p[3]) {
    const int64_t ax = (int64_t)p[1]->x - p[0]->x, ay = (int64_t)p[1]->y - p[0]->y, aw = (int64_t)p[1]->w - p[0]->w;
    const int64_t bx = (int64_t)p[2]->x - p[0]->x, by = (int64_t)p[2]->y - p[0]->y, bw = (int64_t)p[2]->w - p[0]->w;
    const int64_t cross[3] = {ay * bw - aw * by, aw * bx - ax * bw, ax * by - ay * bx};
    int32_t c[3];
    glint_reduce(cross, c);
    if (view->is_parallel) /* w is the same everywhere, and positions have a distance in its place */
        return c[2] > 0;
    return (int64_t)c[0] * p[0]->x + (int64_t)c[1] * p[0]->y + (int64_t)c[2] * p[0]->w > 0;
}

/* Returns whether a triangle of a double-sided mesh is seen from behind: by the same area that drawing uses, so that a
 * triangle drawn as a front is lit as one. */
static int shows_back(const glint_frame *frame, const glint_draw *draw, const uint16_t corners[3]) {
    const glint_vertex *const v[3] = {&draw->vertices[corners[0]], &draw->vertices[corners[1]],
                                      &draw->vertices[corners[2]]};
    if (!((v[0]->flags | v[1]->flags | v[2]->flags) & GLINT_VERTEX_CLIP))
        return (glint_double_area(v[0], v[1], v[2]) > 0) != draw->mirrored;
    const glint_position *const p[3] = {&draw->positions[corners[0]], &draw->positions[corners[1]],
                                        &draw->positions[corners[2]]};
    return is_clockwise(frame->view, p) != draw->mirrored;
}

/* Sets a point to a facet's centroid, and its normal to that of the facet's plane, on the side towards the eye. */
static inline void set_point_to_facet(const glint_frame *frame, const glint_draw *draw,
                                      const glint_corner_lights *lights, const uint16_t corners[3],
                                      glint_lit_point *point) {
    const int16_t *p[3];
    int16_t fetched[3][3];
    int32_t normal[3], exponent;
    for (int i = 0; i < 3; i++)
        p[i] = glint_steps_of(lights->mesh, (uint16_t)draw->vertices[corners[i]].attribute[0], fetched[i]);
    const int32_t x = p[0][0], y = p[0][1], z = p[0][2], bx = p[1][0] - x, by = p[1][1] - y, bz = p[1][2] - z,
                  cx = p[2][0] - x, cy = p[2][1] - y, cz = p[2][2] - z;
    /* 1/3 is 21845 2^-16, and the product is below 2^31 */
    set_point_place(lights, glint_shift_right((3 * x + bx + cx) * 21845, 16),
                    glint_shift_right((3 * y + by + cy) * 21845, 16), glint_shift_right((3 * z + bz + cz) * 21845, 16),
                    point);
    multiply_edges(bx, by, bz, cx, cy, cz, normal);
    if (!lights->is_cubic)
        stretch_normal(lights->area, normal);
    glint_corner_unit(normal, &exponent);
    set_point_normal(draw, lights, normal[0], normal[1], normal[2], point);
    if (draw->double_sided && shows_back(frame, draw, corners))
        for (int i = 0; i < 3; i++)
            point->normal[i] = -point->normal[i];
}

/* Finds the colour of a facet, with the mean of its corners' own colours. */
static void light_facet(const glint_frame *frame, glint_draw *draw, const glint_transform *transform,
                        uint32_t triangle) {
    const uint16_t *corners = draw->triangles[triangle];
    const glint_corner_lights *lights = lights_of(frame, draw);
    int16_t mean[3];
    uint32_t colour[3];
    const int16_t *surface = 0;
    glint_lit_point point;
    (void)transform;
    if (!draw->facets)
        return;
    if (lights->count)
        set_point_to_facet(frame, draw, lights, corners, &point);
    if (lights->has_colours) {
        const int16_t(*const own)[3] = (const int16_t(*)[3])draw->extra;
        for (int c = 0; c < 3; c++)
            mean[c] = (int16_t)((own[corners[0]][c] + own[corners[1]][c] + own[corners[2]][c]) / 3);
        surface = mean;
    }
    light_point(lights, &point, surface, colour);
    if (draw->texture)
        store_worn(colour, draw->facets[triangle]);
    else
        glint_finish_facet(&frame->config, colour, draw->facets[triangle]);
}

const glint_evaluation glint_per_facet = {
    .lit_at = GLINT_LIT_AT_FACETS, .light = light_facet, .draw_triangle = glint_draw_facet};
