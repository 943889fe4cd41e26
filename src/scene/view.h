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
        int32_t cosine_outer, cosine_inner; /* times GLINT_UNIT^2, and the axis's length over GLINT_UNIT */
        int32_t slope;                      /* 2^30 / (difference >> shift); 0 of a hard edge */
        uint32_t shift;                     /* leaves 16 bits of the difference */
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
    uint8_t has_positions; /* some light has one, or rays are parallel: then fragments have rays */
    uint8_t is_parallel;
    glint_prepared_light lights[GLINT_LIGHTS_MAX];
} glint_view;

/** Bytes of a view with so many lights. */
#define GLINT_VIEW_SIZE(count) (offsetof(glint_view, lights) + (count) * sizeof(glint_prepared_light))

/** Where depth begins and ends; behind the lights of a view whose rays are parallel. */
typedef struct glint_depth_range {
    uint32_t far_low, far_high; /* the farthest w, Q28 */
    uint32_t scale;             /* nearest from farthest, Q28, is 2^(61 + shift) over this */
    int32_t shift;
    int32_t far_ray, range_ray; /* the farthest w, and that of depth 2^31, in the units of rays */
} glint_depth_range;

/** A view with all that may stand behind it. */
typedef struct glint_whole_view {
    glint_view view;
    glint_depth_range range;
} glint_whole_view;

struct glint_fragments;
struct glint_vertex;

/**
 * What a camera with parallel rays does in another way. To it w is the same everywhere, B: that of a camera in
 * perspective whose focal length is the guard band's width, seen from where that is as wide as it is. So x and y are
 * projected by the same code; clip positions have the distance in place of w, transform->nearest is B, and vertices
 * have a depth of 16 bits above GLINT_DEPTH_TOP in place of 1/w.
 */
struct glint_projection {
    int (*is_valid)(const glint_camera *camera);
    /** The w of all that is seen, Q28. */
    int64_t (*find_w)(const glint_config *config, const glint_camera *camera);
    /** Sets the view's range of depths, in Q28. */
    void (*set_range)(glint_view *view, int64_t nearest, int64_t farthest);
    /** Brings vertices from their distance to depth. */
    void (*finish)(const glint_view *view, const struct glint_transform *transform, struct glint_vertex *vertices,
                   uint32_t count);
    /** Brings fragments from their depth to rays and 1/w. */
    void (*place)(const glint_frame *frame, struct glint_fragments *fragments);
    /** Depth, Q31, of a distance Q28; it may be below 0 or beyond 2^31. */
    int64_t (*depth_at)(const glint_view *view, int64_t w);
};

/** The largest depth of a vertex, and what parallel rays have above it. */
#define GLINT_DEPTH_TOP 0x7fff0000

/** Bytes of the view that a scene takes. */
static inline size_t glint_view_size(const glint_scene *scene) {
    return GLINT_VIEW_SIZE(scene->light_count) + (scene->camera.projection ? sizeof(glint_depth_range) : 0);
}

struct glint_light_type {
    /** Brings a light to camera space. @return GLINT_ERROR_DIRECTION, _ATTENUATION or _CONE when it is not valid. */
    glint_status (*prepare)(const glint_light *light, glint_prepared_light *prepared, const glint_view *view);
    /** Direction and strength at the fragments; null where both are the same everywhere. */
    void (*illuminate)(const glint_prepared_light *light, struct glint_fragments *fragments);
    /** The part of `prepare` that needs the frame's nearest w; may be null. */
    void (*place)(const glint_light *light, glint_prepared_light *prepared, const glint_view *view);
    /** Does an object lie where none of this light goes, all of it? Null: light goes everywhere. */
    int (*misses)(const glint_light *light, const glint_prepared_light *prepared, const glint_view *view,
                  const glint_object *object);
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
