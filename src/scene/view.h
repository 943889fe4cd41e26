/* SPDX-License-Identifier: MIT */
/** @file view.h What camera, lights and poses of a scene become, once a frame. */
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
    } point;
    struct {
        int32_t
            place[3]; /* of a light with a position, in the units of lamps.c times 2^-shift and 1/w, Q31: below 2^30 */
        int32_t shift;
        uint16_t linear,
            quadratic; /* 14 bits; 1 weakened by this 2^-shift times a distance in units of 1/w = 2^31 is */
        int16_t linear_shift, quadratic_shift;
    } lamp;
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
    int32_t ray_scale;  /* Q12: half pixels times this are the way to the eye, of 15 bits */
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
    /** Returns how far a depth, Q31, lies from the eye along the axis: half pixels, Q12. */
    int32_t (*distance_of)(const glint_view *view, int32_t depth);
    /** Depth, Q31, of a distance Q28; it may be below 0 or beyond 2^31. */
    int64_t (*depth_at)(const glint_view *view, int64_t w);
};

/** The largest depth of a vertex, and what parallel rays have above it. */
#define GLINT_DEPTH_TOP 0x7fff0000

/** Bytes of the view that a scene takes. */
static inline size_t glint_view_size(const glint_scene *scene) {
    return GLINT_VIEW_SIZE(scene->light_count) + (scene->camera.projection ? sizeof(glint_depth_range) : 0);
}

/** Finds what a point sees of a light. @return its strength there, Q15; 0 where it is gated and the point faces away */
typedef uint32_t glint_reach_light(const struct glint_corner_light *light, const struct glint_lit_point *point,
                                   struct glint_corner_sight *to);

/** Sets what `reach` needs beyond a light's place in an object's space, of which the unit is 2^exponent times that of
 * turned vectors in Q28. */
typedef void glint_bring_light(const glint_light *light, const struct glint_corner_space *space, int32_t exponent,
                               struct glint_corner_light *to);

struct glint_light_type {
    /** Brings a light to camera space. @return GLINT_ERROR_DIRECTION, _ATTENUATION or _CONE when it is not valid. */
    glint_status (*prepare)(const glint_light *light, glint_prepared_light *prepared, const glint_view *view);
    /** The part of `prepare` that needs the frame's nearest w; may be null. */
    void (*place)(const glint_light *light, glint_prepared_light *prepared, const glint_view *view);
    /** Does an object lie where none of this light goes, all of it? Null: light goes everywhere. */
    int (*misses)(const glint_light *light, const glint_prepared_light *prepared, const glint_view *view,
                  const glint_object *object);
    const struct glint_suns_stage *suns; /* of directional lights: light/evaluation.h; else null */
    const struct glint_places *places;   /* what lamps do with such lights: light/lamps.h */
    uint8_t has_place;                   /* light comes from one, not from the same direction everywhere */
    uint8_t has_cone;                    /* prepared->spot holds one */
    /** Finds what arrives of a light at a fragment: light/lamps.h. */
    int (*arrive)(const struct glint_lamps *lamps, const struct glint_drawn_lamp *lamp, struct glint_lit_view *s,
                  struct glint_arrival *to);
    glint_bring_light *bring; /* null where light has no place, */
    glint_reach_light *reach; /* as well */
};

/**
 * Camera, lights and depth scale; and transforms, but for what needs view->nearest: the last object's at `last`, those
 * before it below, `count` in all, at least 1.
 */
glint_status glint_prepare_view(glint_view *view, const glint_config *config, const glint_scene *scene,
                                struct glint_transform *last, uint32_t count);

/**
 * Measures a pose's axes, its first three columns: error[i][j] is the scalar product of axes i and j, less 1 where they
 * are the same; Q32.
 * @param tolerance Q32, below 2^24
 * @return 0 where an error is beyond the tolerance; then errors are of no use
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

/** Has a camera unit axes that are perpendicular, a field of view and a near plane? */
int glint_camera_is_valid(const glint_camera *camera);

/**
 * Brings a light's direction to camera space, unit.
 * @param opposite not 0: the way towards the light in its place
 * @return 0 when the direction has length 0
 */
int glint_light_to_camera(const glint_view *view, const glint_light *light, int opposite, int16_t out[3]);

/** x / 2^shift, rounded to nearest, halves up; shift from -62 to 62, |x| and the result below 2^62. */
int64_t glint_shift_round64(int64_t x, int shift);

/** Scales a vector of 64 bits to one of 30, its direction kept. @return n: it is 2^n times the result. */
unsigned glint_reduce(const int64_t in[3], int32_t out[3]);

/* ---- Objects under the camera ---- */

/** Has a mesh nothing to draw? */
static inline int glint_mesh_is_empty(const glint_mesh *mesh) {
    return !mesh->vertex_count || !mesh->triangle_count;
}

/**
 * Mesh steps to the screen in products of 16 bits, for objects that are nowhere clipped, whose w differs by a factor of
 * 4 at most, and that lie within a quarter of the guard band, 256 pixels, of the screen's centre. Off by less than half
 * a sixteenth of a pixel beyond rounding, and by 2^-15 of 1/w.
 */
typedef struct glint_short_matrix {
    /* Clip coordinates of a step, 15 bits and a sign, and of step 0, 31 bits, of x and y with a half for rounding; rows
     * of x and y are times one power of two, that of w times another. */
    int32_t x[4], y[4], w[4];
    uint32_t nearest; /* of the frame, 16 bits */
    uint8_t serves;
    uint8_t shift;       /* from X / W to sixteenths, Q11, and from a reciprocal to 1/w, for a W of 31 bits */
    uint8_t depth_shift; /* the same of 1/w */
} glint_short_matrix;

/** Mesh steps to clip space, and object normals to camera space. */
typedef struct glint_transform {
    glint_row matrix[3]; /* rows x, y, w: clip coordinate of 2^15 steps */
    int32_t translation[3];
    glint_row normal[3];         /* of draws that are lit */
    int32_t exponent;            /* a clip unit is 2^-exponent */
    int32_t near_plane, least_w; /* w of the near plane, and of the nearest corner of the box */
    int32_t nearest;             /* w of the frame, no more than any of the object's that is seen; of parallel rays w */
    int32_t center_x, center_y;  /* of the screen, 28.4 and 11 bits for rounding */
    uint8_t visible, clips, mirrored;
    uint8_t skipped; /* it has nothing to draw, and is left out */
    glint_short_matrix brief;
} glint_transform;

/** A bit of glint_transform.clips: rays are parallel, and positions have their distance in place of w. */
#define GLINT_PARALLEL 2u

/** The eye among a mesh's steps, homogeneous. */
typedef struct glint_eye {
    int32_t x, y, z;  /* times weight 2^-8: 20 bits and a sign */
    int32_t distance; /* from step 0, or a little more; times the same */
    int32_t weight;   /* 13 bits */
} glint_eye;

/** Finds the eye from an object's transform. */
void glint_transform_eye(const glint_transform *transform, glint_eye *eye);

/** An object's transform. Takes view->nearest as it stands. */
glint_status glint_transform_prepare(glint_transform *transform, const glint_view *view, const glint_config *config,
                                     const glint_object *object);

/** Sets an object's matrix of normals. */
void glint_transform_begin_normals(glint_transform *transform, const glint_view *view, const glint_pose *pose);

/** The part of it that needs view->nearest, anew. */
void glint_transform_place(glint_transform *transform, const glint_view *view);

/** Smallest w of the object's bounding box, Q28, no less than the near plane. */
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

/** Checks what places on a screen are found from. @return GLINT_ERROR_NULL, _SIZE or _CAMERA */
glint_status glint_check_sight(const glint_config *config, const glint_camera *camera);

/** A point from the eye: right, down and away, Q31, below 2^52. */
void glint_find_sight(const glint_camera *camera, glint_vector point, int64_t sight[3]);

/** Returns twice the focal length in pixels, Q31, below 2^48; of parallel rays, the width of the guard band. */
int64_t glint_focal_length(const glint_config *config, const glint_camera *camera);

/** What x and y are divided by, Q31: how far away a point is, or the w of parallel rays, below 2^58. */
int64_t glint_find_divisor(const glint_config *config, const glint_camera *camera, const int64_t sight[3]);

#endif
