/* SPDX-License-Identifier: MIT */
/**
 * @file shade.h
 * Light at a point, for one model, viewer and set of options at a time. With v = (vx, vy, 1), the way to the eye
 * over w, a point lies at -v w, and a light at Q in the direction Q / w + v: nothing is divided by 1/w.
 */
#ifndef FLOAT_SHADE_H
#define FLOAT_SHADE_H

#include "draw.h"
#include "number.h"

/** What a kernel is made for. */
typedef struct float_kind {
    float_model model;
    int local;
    uint32_t options;
} float_kind;

/** A point, its vectors of unit length. */
typedef struct float_point {
    float_triple normal;
    float_triple way;  /**< To the eye. */
    float nearness;    /**< 1 over the distance of the eye. */
    float_triple view; /**< The viewer's direction: the way, or the camera's axis. */
    float facing;      /**< Normal times view. */
    float facing_way;  /**< Normal times way. */
} float_point;

/** What lights add: both parts are one where the mesh has no colours. */
typedef struct float_light_sum {
    float_triple diffuse, specular;
} float_light_sum;

FLOAT_INLINE int float_has(const float_surface *surface, float_kind kind, uint32_t option) {
    return ((kind.options & FLOAT_ANY ? surface->options : kind.options) & option) != 0;
}

/* ---- Highlights ---- */

FLOAT_INLINE float float_low_power(const float_surface *surface, float square) {
    const float_powers *powers = surface->powers;

    if (square <= 0) {
        return powers->at_zero;
    }
    const uint32_t bits = (uint32_t)float_bits(square / surface->square);
    const uint32_t number = bits < FLOAT_LOW_FIRST ? 0 : 1 + ((bits - FLOAT_LOW_FIRST) >> FLOAT_LOW_SHIFT);
    const float_power *entry = &powers->table[number % FLOAT_POWERS_ROOM];
    return entry->value + entry->slope * (square / surface->square);
}

/** Adds a highlight whose cosine's square, with its sign, is so much over so much. */
FLOAT_INLINE void float_add_highlight(const float_surface *surface, float_kind kind, float over, float under,
                                      const float_lamp *lamp, float strength, float_light_sum *result) {
    float_triple *const to = float_has(surface, kind, FLOAT_COLOURS) ? &result->specular : &result->diffuse;

    if (float_has(surface, kind, FLOAT_LOW)) {
        *to = sum_scaled(*to, lamp->specular, strength * float_low_power(surface, over / under));
        return;
    }
    const float at = over / under * surface->scale + surface->offset;
    if (at > 0) {
        const float_power *entry = &surface->powers->table[float_whole(at) % FLOAT_POWERS_ROOM];
        *to = sum_scaled(*to, lamp->specular, strength * (entry->value + entry->slope * at));
    }
}

/* ---- Lights ---- */

/* How a light with a position lies to a point: its distance over that of the eye, and what of it arrives. */
typedef struct float_arrival {
    float square, length;
    float strength; /* 0 where nothing arrives */
} float_arrival;

/* A spot's part: a smooth step between its cones. Most points lie outside: they are told before anything is divided. */
FLOAT_INLINE float float_cone(const float_light *light, const float_point *point, float length) {
    const float inside =
        -(light->axis_position * point->nearness + dot(light->axis, point->way)) - light->outer * length;

    if (inside <= 0) {
        return 0;
    }
    const float t = inside / length * light->soft;
    return t >= 1 ? 1 : t * t * (3 - 2 * t);
}

FLOAT_INLINE float_arrival float_arrive(const float_light *light, const float_point *point, int spot, float near_way) {
    const float inverse_square = point->nearness * point->nearness;
    float_arrival result = {.square = inverse_square * light->square + 2 * near_way + 1};

    if (result.square <= 0) {
        return result;
    }
    result.length = float_root(result.square);
    result.strength = spot ? float_cone(light, point, result.length) : 1;
    if (spot && result.strength <= 0) {
        return result;
    }
    result.strength *= inverse_square / (inverse_square + light->linear * (point->nearness * result.length) +
                                         light->quadratic * result.square);
    return result;
}

/** Adds a light; `positional` and `spot` are constants. */
FLOAT_INLINE void float_add_lamp(const float_surface *surface, float_kind kind, const float_lamp *lamp,
                                 const float_point *point, int positional, int spot, float_light_sum *result) {
    const float_light *light = &lamp->light;
    const int gated = kind.model == FLOAT_DIFFUSE || !float_has(surface, kind, FLOAT_UNGATED);
    float_arrival arrival = {1, 1, 1};
    float toward = dot(light->vector, point->normal);

    if (positional) {
        toward = toward * point->nearness + point->facing_way;
    }
    if (gated && toward <= 0) {
        return;
    }
    float along = dot(light->vector, point->view); /* the light's direction times the view */
    if (positional) {
        const float near_way = point->nearness * (kind.local ? along : dot(light->vector, point->way));
        arrival = float_arrive(light, point, spot, near_way);
        if (spot ? arrival.strength <= 0 : arrival.square <= 0) {
            return;
        }
        along = kind.local ? near_way + 1 : point->nearness * along + point->way.z;
    }
    if (gated || toward > 0) {
        result->diffuse = sum_scaled(result->diffuse, lamp->diffuse,
                                     positional ? toward / arrival.length * arrival.strength : toward);
    }
    if (kind.model == FLOAT_BLINN_PHONG) {
        const float half = toward + arrival.length * point->facing;
        float_add_highlight(surface, kind, half * __builtin_fabsf(half), arrival.square + arrival.length * along, lamp,
                            arrival.strength, result);
    } else if (kind.model == FLOAT_PHONG) {
        const float mirrored = 2 * toward * point->facing - along;
        float_add_highlight(surface, kind, mirrored * __builtin_fabsf(mirrored), arrival.square, lamp, arrival.strength,
                            result);
    }
}

/* ---- Sums ---- */

FLOAT_INLINE float_light_sum float_begin_sum(const float_surface *surface, float_kind kind) {
    const int colours = float_has(surface, kind, FLOAT_COLOURS), most = float_has(surface, kind, FLOAT_MAX);
    const float_triple none = {0, 0, 0};

    return (float_light_sum){colours ? most ? none : surface->ambient : most ? surface->half : surface->base, none};
}

/** Levels of a sum; `colour` is the mesh's. */
FLOAT_INLINE float_triple float_end_sum(const float_surface *surface, float_kind kind, const float_light_sum *light,
                                        float_triple colour) {
    const int most = float_has(surface, kind, FLOAT_MAX);

    if (!float_has(surface, kind, FLOAT_COLOURS)) {
        return most ? larger(light->diffuse, surface->base) : light->diffuse;
    }
    const float_triple lit = sum(product(light->diffuse, colour), light->specular);
    return sum(most ? larger(lit, product(surface->ambient, colour)) : lit, surface->half);
}

/** Adds all lights. */
FLOAT_INLINE void float_add_lamps(const float_surface *surface, float_kind kind, const float_point *point,
                                  float_light_sum *result) {
    const float_lamp *lamp = surface->lamps;
    const float_lamp *const points = lamp + surface->directional, *const spots = points + surface->points,
                            *const end = spots + surface->spots;

    for (; lamp < points; lamp++) {
        float_add_lamp(surface, kind, lamp, point, 0, 0, result);
    }
    for (; lamp < spots; lamp++) {
        float_add_lamp(surface, kind, lamp, point, 1, 0, result);
    }
    for (; lamp < end; lamp++) {
        float_add_lamp(surface, kind, lamp, point, 1, 1, result);
    }
}

#endif
