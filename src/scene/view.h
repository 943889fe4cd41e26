/* SPDX-License-Identifier: MIT */
/** @file view.h What a scene's camera and lights become, once a frame. */
#ifndef GLINT_VIEW_H
#define GLINT_VIEW_H

#include "../glint.h"

struct glint_fragments;
struct glint_transform;

/** Half width of the guard band in pixels: clip space x = w lies this far from the screen's centre. */
#define GLINT_GUARD_BAND 1023

/** A light in camera space. */
typedef struct glint_prepared_light {
    const glint_light_type *type;
    int16_t direction[3];   /* directional: towards the light, unit; spot: against its axis, unit */
    int16_t half_vector[3]; /* directional, for the infinite viewer; 0 when the light is straight behind */
    struct {
        int32_t mantissa[3]; /* position times 2 focal lengths over the frame's nearest w: mantissa 2^-shift, Q12, over
                                Q31 */
        int32_t shift;
        int32_t distance_mantissa;  /* |light vector| UNIT / 2^15 over 1/w to world units, times a power of two */
        uint32_t linear, quadratic; /* 2^31 or more, or 0. Of a distance d times that mantissa is lost: */
        int32_t linear_shift, quadratic_shift; /* linear d 2^(this - 33), quadratic d^2 2^(this - 50) */
    } point;
    struct {
        int32_t cosine_outer, cosine_inner; /* times GLINT_UNIT^2 */
        int32_t slope;                      /* Q15: 2^30 / (difference >> 15) */
    } spot;
} glint_prepared_light;

/** Camera and lights. */
typedef struct glint_view {
    int32_t rotation[3][3]; /* world to camera, Q16.16 */
    int32_t eye[3];         /* world, Q16.16 */
    int32_t focal;          /* twice the focal length in pixels, Q12 */
    int32_t focal_mantissa; /* focal length / guard band = mantissa 2^-shift, 2^23 to 2^24 */
    uint32_t focal_shift;
    uint32_t skipped;   /* objects */
    int64_t near_plane; /* Q28 */
    int64_t nearest;    /* Q28: no visible w is smaller */
    uint32_t light_count;
    uint8_t local_viewer;
    uint8_t has_positions; /* some light has one */
    glint_prepared_light lights[GLINT_LIGHTS_MAX];
} glint_view;

/** Bytes of a view with so many lights. */
#define GLINT_VIEW_SIZE(count) (offsetof(glint_view, lights) + (count) * sizeof(glint_prepared_light))

struct glint_light_type {
    /** Brings a light to camera space. @return GLINT_ERROR_DIRECTION, _ATTENUATION or _CONE when it is not valid. */
    glint_status (*prepare)(const glint_light *light, glint_prepared_light *prepared, const glint_view *view);
    /** Direction and strength at the fragments; null where both are the same everywhere. */
    void (*illuminate)(const glint_prepared_light *light, struct glint_fragments *fragments);
    /** The part of `prepare` that needs the frame's nearest w; may be null. */
    void (*place)(const glint_light *light, glint_prepared_light *prepared, const glint_view *view);
    uint8_t has_cone; /* prepared->spot holds one */
};

/**
 * Camera, lights and depth scale; and transforms, but for what needs view->nearest: the last object's at `last`, those
 * before it below, `count` in all, at least 1.
 */
glint_status glint_prepare_view(glint_view *view, const glint_config *config, const glint_scene *scene,
                                struct glint_transform *last, uint32_t count);

/** Has a camera unit axes that are perpendicular, a field of view and a near plane? */
int glint_camera_is_valid(const glint_camera *camera);

/** Brings a world direction to camera space, unit. @return 0 when it has length 0. */
int glint_direction_to_camera(const glint_view *view, glint_vector world, int16_t out[3]);

/** x / 2^shift, rounded to nearest, halves up; shift from -62 to 62, |x| and the result below 2^62. */
int64_t glint_shift_round64(int64_t x, int shift);

/** Scales a vector of 64 bits to one of 30, its direction kept. @return n: it is 2^n times the result. */
unsigned glint_reduce(const int64_t in[3], int32_t out[3]);

#endif
