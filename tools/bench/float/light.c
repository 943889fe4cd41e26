/* SPDX-License-Identifier: MIT */
/* Attributes of vertices: normals, or colours where they are lit; and colours of facets. */
#include "draw.h"
#include "number.h"
#include "shade.h"

/* ---- Points that are lit by themselves ---- */

/* All models and options, which are looked at here. */
static float_triple shade_any(const float_surface *surface, int local, const float_point *point,
                              const float_triple *colour) {
    const float_kind kinds[3] = {
        {FLOAT_DIFFUSE, local, FLOAT_ANY}, {FLOAT_BLINN_PHONG, local, FLOAT_ANY}, {FLOAT_PHONG, local, FLOAT_ANY}};
    float_light_sum light = float_begin_sum(surface, kinds[0]);

    if (surface->model == FLOAT_DIFFUSE) {
        float_add_lamps(surface, kinds[0], point, &light);
    } else if (surface->model == FLOAT_BLINN_PHONG) {
        float_add_lamps(surface, kinds[1], point, &light);
    } else {
        float_add_lamps(surface, kinds[2], point, &light);
    }
    return float_end_sum(surface, kinds[0], &light, *colour);
}

float_triple float_light_point(const float_draw *draw, const float_triple *place, const float_triple *normal,
                               const float_triple *colour) {
    const float_triple top = {FLOAT_RED + FLOAT_HALF_RED, FLOAT_GREEN + FLOAT_HALF_GREEN, FLOAT_BLUE + FLOAT_HALF_BLUE};
    const float_surface *surface = &draw->surface;
    float_point point = {.normal = unit(*normal), .nearness = 1 / float_root(dot(*place, *place))};

    if (surface->model == FLOAT_UNLIT) {
        return sum(product(surface->diffuse, *colour), surface->half);
    }
    point.way = scaled(*place, -point.nearness);
    point.view = draw->frame->local ? point.way : triple(0, 0, 1);
    point.facing = dot(point.normal, point.view);
    point.facing_way = dot(point.normal, point.way);
    const float_triple level = shade_any(surface, draw->frame->local, &point, colour);
    return triple(level.x < top.x ? level.x : top.x, level.y < top.y ? level.y : top.y,
                  level.z < top.z ? level.z : top.z);
}

/* ---- Vertices ---- */

static float_triple colour_of(const glint_mesh *mesh, uint32_t index) {
    if (mesh->colours565) {
        const uint32_t word = mesh->colours565[index];
        return triple((float)(word >> 11) / 31, (float)(word >> 5 & 63) / 63, (float)(word & 31) / 31);
    }
    if (mesh->colours) {
        const uint8_t *colour = mesh->colours[index];
        return scaled(triple((float)colour[0], (float)colour[1], (float)colour[2]), 1.0f / 255);
    }
    return triple(1, 1, 1);
}

static inline float_triple normal_of(const float_draw *draw, uint32_t index) {
    const float_triple normal = triple_of(draw->object->mesh->normals[index]);

    return triple(dot(draw->normal[0], normal), dot(draw->normal[1], normal), dot(draw->normal[2], normal));
}

static int is_lit_at_vertices(const float_draw *draw) {
    return draw->surface.model == FLOAT_UNLIT || draw->object->evaluation == &glint_per_vertex;
}

float_attributes float_attributes_of(const float_draw *draw, uint32_t index, const float_triple *place) {
    const float_triple normal = scaled(unit(normal_of(draw, index)), draw->side);
    float_attributes result = {normal, colour_of(draw->object->mesh, index)};

    if (is_lit_at_vertices(draw)) {
        result.attribute = float_light_point(draw, place, &normal, &result.colour);
    }
    return result;
}

/* Unit normals over w, of vertices that are used. */
static void put_normals(const float_draw *draw) {
    float_memory *memory = draw->frame->memory;
    const uint32_t count = draw->object->mesh->vertex_count;

    for (uint32_t i = 0; i < count; i++) {
        if (memory->used[i]) {
            float_vertex *vertex = &memory->vertices[i];
            const float_triple normal = normal_of(draw, i);
            vertex->attribute = scaled(normal, draw->side * vertex->inverse_w / float_root(dot(normal, normal)));
        }
    }
}

static void put_colours(const float_draw *draw) {
    float_memory *memory = draw->frame->memory;
    const glint_mesh *mesh = draw->object->mesh;

    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        if (memory->used[i]) {
            memory->colours[i] = scaled(colour_of(mesh, i), memory->vertices[i].inverse_w);
        }
    }
}

static void put_lit_vertices(const float_draw *draw) {
    float_memory *memory = draw->frame->memory;

    for (uint32_t i = 0; i < draw->object->mesh->vertex_count; i++) {
        if (memory->used[i]) {
            const float_triple place = float_place_of(draw, i);
            const float_attributes at = float_attributes_of(draw, i, &place);
            memory->vertices[i].attribute = scaled(at.attribute, memory->vertices[i].inverse_w);
        }
    }
}

/* ---- Facets ---- */

static uint16_t facet_pixel(const float_draw *draw, const uint16_t corner[3]) {
    const glint_mesh *mesh = draw->object->mesh;
    const float_triple a = float_place_of(draw, corner[0]), b = float_place_of(draw, corner[1]),
                       c = float_place_of(draw, corner[2]);
    const float_triple ab = difference(b, a), ac = difference(c, a);
    const float_triple place = scaled(sum(sum(a, b), c), 1.0f / 3);
    const float_triple colour =
        scaled(sum(sum(colour_of(mesh, corner[0]), colour_of(mesh, corner[1])), colour_of(mesh, corner[2])), 1.0f / 3);
    const float_triple across = {ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z, ab.x * ac.y - ab.y * ac.x};
    const float_triple normal = dot(across, place) > 0 ? scaled(across, -1) : across;

    return float_pixel(float_light_point(draw, &place, &normal, &colour));
}

static void put_facets(float_draw *draw) {
    float_memory *memory = draw->frame->memory;

    for (uint32_t i = 0; i < draw->count; i++) {
        memory->facets[i] = facet_pixel(draw, draw->object->mesh->triangles[memory->triangles[i].source]);
    }
    draw->facets = memory->facets;
}

void float_light_all(float_draw *draw) {
    const int coloured = (draw->surface.options & FLOAT_COLOURS) != 0;

    draw->facets = 0;
    if (draw->surface.model == FLOAT_UNLIT && !coloured) {
        return;
    }
    if (draw->object->evaluation == &glint_per_facet) {
        put_facets(draw);
    } else if (is_lit_at_vertices(draw)) {
        put_lit_vertices(draw);
    } else {
        put_normals(draw);
        if (coloured) {
            put_colours(draw);
        }
    }
}
