/* SPDX-License-Identifier: MIT */
/** @file view.h Prepares camera, lights and poses of a scene, once a frame. */
#ifndef GLINT_VIEW_H
#define GLINT_VIEW_H

#include "../glint_extras.h"
#include "../math/product.h"

struct glint_drawn_lamp;
struct glint_arrival;
struct glint_lit_fragment;
struct glint_lit_view;
struct glint_row_walk;
struct glint_lamps;
struct glint_transform;
struct glint_corner_light;
struct glint_corner_sight;
struct glint_corner_space;
struct glint_lit_point;

/** Clip space x = w lies so many pixels from the screen's centre: this is half the width of the guard band. */
#define GLINT_GUARD_BAND 1023

/** A light is prepared in camera space. */
typedef struct glint_prepared_light {
    const glint_light_type *type;
    int16_t direction[3];   /* directional: towards the light, unit; spot: against its axis, unit */
    int16_t half_vector[3]; /* directional, for the infinite viewer; 0 when the light is straight behind */
    struct {
        int32_t mantissa[3]; /* position times 2 focal lengths over the frame's nearest w: mantissa 2^-shift, Q12, over
                                Q31 */
        int32_t shift;
    } point;
    struct {
        int32_t place[3]; /* place of a light with a position, in the units of lamps.c times 2^-shift and 1/w, Q31:
                             below 2^30 */
        int32_t shift;
        uint16_t linear, quadratic; /* 14 bits; this 2^-shift times a distance in units of 1/w = 2^31 is added to 1 */
        int16_t linear_shift, quadratic_shift;
    } lamp;
    struct {
        int32_t cosine_outer, cosine_inner; /* times GLINT_UNIT^2, and the axis's length over GLINT_UNIT */
        int32_t slope;                      /* 2^30 / (difference >> shift); 0 of a hard edge */
        uint32_t shift;                     /* leaves 16 bits of the difference */
    } spot;
} glint_prepared_light;

/** A view holds camera and lights. */
typedef struct glint_view {
    int32_t rotation[3][3]; /* world to camera, Q16.16 */
    int32_t eye[3];         /* world, Q16.16 */
    int32_t focal;          /* twice the focal length in pixels, Q12 */
    int32_t focal_mantissa; /* focal length / guard band = mantissa 2^-shift, 2^23 to 2^24 */
    uint32_t focal_shift;
    int32_t ray_scale;  /* Q12: a ray to the eye, of 15 bits, is half pixels times this */
    uint32_t skipped;   /* objects */
    int64_t near_plane; /* Q28 */
    int64_t nearest;    /* Q28: no visible w is smaller */
    uint32_t light_count;
    uint8_t local_viewer;
    uint8_t has_positions; /* whether a light has a position, or rays are parallel: then fragments have rays */
    uint8_t is_parallel;
    glint_prepared_light lights[1]; /* as many as the scene has */
} glint_view;

/** Returns the bytes of a view with so many lights. */
#define GLINT_VIEW_SIZE(count) (offsetof(glint_view, lights) + (count) * sizeof(glint_prepared_light))

/** A range says where depth begins and ends. It lies behind the lights of a view whose rays are parallel. */
typedef struct glint_depth_range {
    uint32_t far_low, far_high; /* the farthest w, Q28 */
    uint32_t scale;             /* nearest from farthest, Q28, is 2^(61 + shift) over this */
    int32_t shift;
    int32_t far_ray, range_ray; /* the farthest w, and that of depth 2^31, in the units of rays */
} glint_depth_range;

/** A view of the most lights, with its range of depths, which not all have. */
typedef struct glint_whole_view {
    glint_view view;
    glint_prepared_light more[GLINT_LIGHTS_MAX - 1];
    glint_depth_range range;
} glint_whole_view;

struct glint_vertex;

/**
 * A camera with parallel rays does these things differently. To it w is the same everywhere, B: the w of a perspective
 * camera whose focal length is the width of the guard band, at a distance that equals the width of the guard band in
 * units. So x and y are projected by the same code. Clip positions have the distance in place of w, transform->nearest
 * is B, and vertices have a depth of 16 bits above GLINT_DEPTH_TOP in place of 1/w.
 */
struct glint_projection {
    int (*is_valid)(const glint_camera *camera);
    /** Returns the w of everything visible, Q28. */
    int64_t (*find_w)(const glint_config *config, const glint_camera *camera);
    /** Sets the view's range of depths, in Q28. */
    void (*set_range)(glint_view *view, int64_t nearest, int64_t farthest);
    /** Converts the distances of vertices to depth. */
    void (*finish)(const glint_view *view, const struct glint_transform *transform, struct glint_vertex *vertices,
                   uint32_t count);
    /** Returns how far a depth, Q31, lies from the eye along the axis, in half pixels, Q12. */
    int32_t (*distance_of)(const glint_view *view, int32_t depth);
    /** Returns the depth, Q31, of a distance, Q28. It may be below 0 or beyond 2^31. */
    int64_t (*depth_at)(const glint_view *view, int64_t w);
    /** Finds the distance of depth 2^15, and the range from there to the nearest, Q28. */
    void (*get_range)(const glint_view *view, int64_t *farthest, int64_t *range);
};

/** No depth of a vertex is larger in perspective. Depths of parallel rays lie above it. */
#define GLINT_DEPTH_TOP 0x7fff0000

/** Returns the bytes of the view of a scene. */
static inline size_t glint_view_size(const glint_scene *scene) {
    return GLINT_VIEW_SIZE(scene->light_count) + (scene->camera.projection ? sizeof(glint_depth_range) : 0);
}

/** Finds the light at a point. @return its strength there, Q15; 0 where it is gated and the point faces away */
typedef uint32_t glint_reach_light(const struct glint_corner_light *light, const struct glint_lit_point *point,
                                   struct glint_corner_sight *to);

/** Sets what `reach` needs beyond a light's place in an object's space. The unit of this space is 2^exponent times that
 * of rotated vectors in Q28. */
typedef void glint_bring_light(const glint_light *light, const struct glint_corner_space *space, int32_t exponent,
                               struct glint_corner_light *to);

struct glint_light_type {
    /** Brings a light to camera space. @return GLINT_ERROR_DIRECTION, _ATTENUATION or _CONE when it is not valid. */
    glint_status (*prepare)(const glint_light *light, glint_prepared_light *prepared, const glint_view *view);
    /** Does the part of `prepare` that needs the frame's nearest w; may be null. */
    void (*place)(const glint_light *light, glint_prepared_light *prepared, const glint_view *view);
    /** Does no part of this light meet any part of an object? Null stands for light that goes everywhere. */
    int (*misses)(const glint_light *light, const glint_prepared_light *prepared, const glint_view *view,
                  const glint_object *object);
    const struct glint_suns_stage *suns; /* of directional lights: light/evaluation.h; else null */
    const struct glint_places *places;   /* functions of lamps for such lights: light/lamps.h */
    uint8_t has_place;                   /* whether light comes from a place, not from one direction everywhere */
    uint8_t has_cone;                    /* whether prepared->spot holds a cone */
    /** Finds the light that arrives at a fragment: light/lamps.h. */
    int (*arrive)(const struct glint_lamps *lamps, const struct glint_drawn_lamp *lamp, struct glint_lit_view *s,
                  struct glint_arrival *to);
    glint_bring_light *bring; /* null where light has no place, */
    glint_reach_light *reach; /* and so is this */
};

/** Prepares camera, lights and depth scale; and transforms, except what needs view->nearest. The last object's
 * transform goes to `last`, those before it lie below, `count` in all, at least 1. */
glint_status glint_prepare_view(glint_view *view, const glint_config *config, const glint_scene *scene,
                                struct glint_transform *last, uint32_t count);

/**
 * Measures a pose's axes, its first three columns: error[i][j] is the scalar product of axes i and j, less 1 where they
 * are the same; Q32.
 * @param tolerance Q32, below 2^24
 * @return 0 where an error is beyond the tolerance: then errors are of no use
 */
static inline int glint_axes_are_unit(const glint_pose *pose, int32_t tolerance, int32_t error[3][3]) {
    const int32_t most = GLINT_ONE + GLINT_ONE / 2; /* any entry beyond 1 and the tolerance is an error */
    for (int i = 0; i < 3; i++) {
        for (int j = i; j < 3; j++) {
            int64_t dot = i == j ? -((int64_t)1 << 32) : 0;
            for (int k = 0; k < 3; k++) {
                if (pose->m[k][i] < -most || pose->m[k][i] > most)
                    return 0;
                dot += (int64_t)pose->m[k][i] * pose->m[k][j];
            }
            if (dot < -tolerance || dot > tolerance)
                return 0;
            error[i][j] = error[j][i] = (int32_t)dot;
        }
    }
    return 1;
}

/** Are a camera's axes unit and perpendicular, and are its field of view and near plane valid? */
int glint_camera_is_valid(const glint_camera *camera);

/**
 * Brings a light's direction to camera space, unit.
 * @param opposite not 0: the direction towards the light in its place
 * @return 0 when the direction has length 0
 */
int glint_light_to_camera(const glint_view *view, const glint_light *light, int opposite, int16_t out[3]);

/** Returns x / 2^shift, rounded to nearest, halves up. The shift is from -62 to 62, |x| and the result are below
 * 2^62. */
int64_t glint_shift_round64(int64_t x, int shift);

/** Scales a vector of 64 bits to 30 bits and keeps its direction. @return n: the vector is 2^n times the result */
unsigned glint_reduce(const int64_t in[3], int32_t out[3]);

/* ---- Objects under the camera ---- */

/** Has a mesh nothing to draw? */
static inline int glint_mesh_is_empty(const glint_mesh *mesh) {
    return !mesh->vertex_count || !mesh->triangle_count;
}

/**
 * A short matrix brings mesh steps to the screen in products of 16 bits. It serves objects that are not clipped, whose
 * w differs by a factor of at most 4, and that lie within 256 pixels of the screen's centre, a quarter of the guard
 * band. Positions are off by less than half a sixteenth of a pixel beyond rounding, 1/w by 2^-15.
 */
typedef struct glint_short_matrix {
    /* Clip coordinates of a step have 15 bits and a sign, those of step 0 have 31 bits, and those of x and y include a
     * half for rounding. Rows x and y are scaled by one power of two, row w by another. */
    int32_t x[4], y[4], w[4];
    uint32_t nearest; /* of the frame, 16 bits */
    uint8_t serves;
    uint8_t shift;       /* shift from X / W to sixteenths, Q11, for a W of 31 bits */
    uint8_t depth_shift; /* shift from a reciprocal to 1/w */
} glint_short_matrix;

/** A transform brings mesh steps to clip space, and object normals to camera space. */
typedef struct glint_transform {
    glint_row matrix[3]; /* rows x, y, w: clip coordinate of 2^15 steps */
    int32_t translation[3];
    glint_row normal[3];         /* of draws that are lit */
    int32_t exponent;            /* a clip unit is 2^-exponent */
    int32_t near_plane, least_w; /* w of the near plane, and of the nearest corner of the box */
    int32_t nearest;             /* w of the frame, at most any visible w of the object; of parallel rays their w */
    int32_t center_x, center_y;  /* of the screen, 28.4 and 11 bits for rounding */
    uint8_t visible, clips, mirrored;
    uint8_t skipped; /* whether it has nothing to draw, and is left out */
    glint_short_matrix brief;
} glint_transform;

/** This bit of glint_transform.clips says that rays are parallel: then positions have their distance in place of w. */
#define GLINT_PARALLEL 2u

/** The eye is given in mesh steps, in homogeneous coordinates. */
typedef struct glint_eye {
    int32_t x, y, z;  /* times weight 2^-8: 20 bits and a sign */
    int32_t distance; /* from step 0, or a little more; times the same */
    int32_t weight;   /* 13 bits */
} glint_eye;

/** Finds the eye from an object's transform. */
void glint_transform_eye(const glint_transform *transform, glint_eye *eye);

/** Sets an object's transform. Uses view->nearest as it is. */
glint_status glint_transform_prepare(glint_transform *transform, const glint_view *view, const glint_config *config,
                                     const glint_object *object);

/** Sets an object's matrix of normals. */
void glint_transform_begin_normals(glint_transform *transform, const glint_view *view, const glint_pose *pose);

/** Does the part of it that needs view->nearest, again. */
void glint_transform_place(glint_transform *transform, const glint_view *view);

/** Returns the smallest w of the object's bounding box, Q28, no less than the near plane as the object is cut there. */
int64_t glint_transform_nearest(const glint_transform *transform, const glint_view *view);

/**
 * May w of an object's corners differ by a factor above 8, or 1/w be so small that its differences need all their bits,
 * or are rays parallel?
 */
static inline uint8_t glint_transform_is_wide(const glint_transform *transform) {
    const int32_t least = transform->least_w, half = transform->translation[2] - least;
    return transform->clips || half / 4 > least || /* the farthest is twice the half more */
           glint_shift_right(least / 2 + half, 12) > transform->nearest;
}

/* ---- Points as a camera sees them, for helpers that know no frame ---- */

/** Checks the inputs of a projection to the screen. @return GLINT_ERROR_NULL, _SIZE or _CAMERA */
glint_status glint_check_sight(const glint_config *config, const glint_camera *camera);

/** Finds a point relative to the eye: right, down and away, Q31, below 2^52. */
void glint_find_sight(const glint_camera *camera, glint_vector point, int64_t sight[3]);

/** Returns twice the focal length in pixels, Q31, below 2^48; of parallel rays, the width of the guard band. */
int64_t glint_focal_length(const glint_config *config, const glint_camera *camera);

/** Returns the divisor of x and y, Q31, below 2^58: the distance of a point, or the w of parallel rays. */
int64_t glint_find_divisor(const glint_config *config, const glint_camera *camera, const int64_t sight[3]);

#endif
