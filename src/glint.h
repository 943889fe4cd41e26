/* SPDX-License-Identifier: MIT */
/**
 * @file glint.h
 * glint draws lit 3D objects on small displays from cores without FPU: a freestanding C99 library, all fixed point,
 * drawn tile by tile, lit per fragment, per vertex or per facet. This header stands in the order in which a first
 * program needs it; glint_extras.h has what such a program does without. This is one, but for its panel (README.md):
 *
 * @code
 * #include "glint.h"
 * #include "lcd.h"
 * #include "meshes/torus576.h"
 *
 * static int take_tile(void *lcd, int x, int y, int width, int height, const void *pixels, size_t stride) {
 *     const int right = x + width - 1, bottom = y + height - 1;
 *     const uint8_t columns[] = {(uint8_t)(x >> 8), (uint8_t)x, (uint8_t)(right >> 8), (uint8_t)right};
 *     const uint8_t rows[] = {(uint8_t)(y >> 8), (uint8_t)y, (uint8_t)(bottom >> 8), (uint8_t)bottom};
 *     int failed = lcd_send(lcd, 0x2a, columns, 4) || lcd_send(lcd, 0x2b, rows, 4) || lcd_send(lcd, 0x2c, rows, 0);
 *     for (int row = 0; row < height && !failed; row++)
 *         failed = lcd_pixels(lcd, (const uint8_t *)pixels + (size_t)row * stride, 2 * (size_t)width);
 *     return failed;
 * }
 *
 * int main(void) {
 *     static uint32_t arena[8192];
 *     const glint_colour white = GLINT_COLOUR(1, 1, 1), amber = GLINT_COLOUR(1, 0.5, 0), black = GLINT_COLOUR(0, 0, 0);
 *     const glint_material wax = glint_material_paint(&glint_model_blinn_phong, amber, GLINT_ONE / 10, 32 * GLINT_ONE);
 *     const glint_vector down_right = GLINT_VECTOR(1, -1, -1);
 *     const glint_light sun = glint_sun(down_right, white);
 *     glint_object torus = {&torus576_mesh, &wax, glint_pose_identity(), &glint_per_fragment};
 *     const glint_scene scene = {glint_camera_default(), GLINT_VIEWER_INFINITE, black, white, &sun, 1, &torus, 1};
 *     const glint_flush flush = {take_tile, 0, lcd_start()};
 *     const glint_config config = {320, 240, 0, 0, &glint_format_rgb565_be, flush, arena, sizeof arena};
 *     glint_renderer renderer;
 *     glint_init(&renderer, &config);
 *     for (int turn = 5; glint_render(&renderer, &scene) == GLINT_OK; turn += 5)
 *         torus.pose = glint_pose_rotate_x(turn % 360 * GLINT_ONE);
 *     return 1;
 * }
 * @endcode
 *
 * Conventions
 * - Scalars are Q16.16 (`glint_q16`) unless said otherwise; angles are degrees in Q16.16.
 * - World space is right-handed. A camera looks along its own -z axis, with +y up and +x to the right.
 * - Front faces are counter-clockwise seen from outside.
 * - Screen x runs right and y runs down; pixel (x, y) has its centre at (x + 1/2, y + 1/2). A pixel belongs to a
 *   triangle when its centre lies inside, or on a top or left edge.
 * - Colours are linear, 0 is black and 1 is full; sums above 1 are clamped when a pixel is stored.
 * - Functions that can fail return GLINT_OK or a negative `glint_status`; those that also answer yes or no return an
 *   `int`: 1, 0 or a negative `glint_status`. On failure a renderer, a frame or a filter that they set up is all 0, and
 *   drawing with it gives GLINT_ERROR_NULL; other out-parameters are unchanged.
 * - Structures may grow at their end from version to version, and 0 stands for what was so before: initialise them, or
 *   set them to {0} before fields are assigned one by one.
 * - Structures with the library's own state are declared in full, so that they can be static. Fields below a line
 *   `@privatesection` are neither to be read nor to be written, and change with any version.
 * - Descriptors (shading models, types of lights and of attributes, evaluations, projections, formats, culls) are
 *   incomplete types: programs name those of the library by their address, and can neither copy nor make any.
 * - Nothing is allocated and no global is written: everything lives in the caller's structures and arena, so that any
 *   number of renderers work side by side.
 */
#ifndef GLINT_H
#define GLINT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Incompatible API changes. */
#define GLINT_VERSION_MAJOR 0
/** New features; pixels may have changed. */
#define GLINT_VERSION_MINOR 3
/** Fixed errors. */
#define GLINT_VERSION_PATCH 0

/* ---- Numbers ----------------------------------------------------------------------------------------------------- */

/** Numbers are signed fixed point with 16 fractional bits: 65536 is 1. */
typedef int32_t glint_q16;

#ifdef __cplusplus
#define GLINT_ONE static_cast<glint_q16>(65536)
#define GLINT_Q16(x) static_cast<glint_q16>((x)*65536.0 + ((x) < 0 ? -0.5 : 0.5))
#else
/** This is one in Q16.16. */
#define GLINT_ONE ((glint_q16)65536)

/**
 * Converts a constant to Q16.16, rounded to nearest. It is for literals: the compiler folds it, and no floating point
 * is left.
 * @param x a number, from -32768 to below 32768
 */
#define GLINT_Q16(x) ((glint_q16)((x)*65536.0 + ((x) < 0 ? -0.5 : 0.5)))
#endif

/** A vector is a point, a direction or a length per axis. */
typedef struct glint_vector {
    glint_q16 x, y, z; /**< Along each axis. */
} glint_vector;

/** A colour is linear. Each channel is from 0 to GLINT_COLOUR_MAX. */
typedef struct glint_colour {
    glint_q16 r, g, b; /**< Red, green, blue. */
} glint_colour;

/**
 * Initialises a vector from literals: `const glint_vector up = GLINT_VECTOR(0, 1, 0);`. An argument in C needs its
 * type, `(glint_vector)GLINT_VECTOR(0, 1, 0)`, in C++11 it does not.
 * @param x,y,z as for GLINT_Q16
 */
#define GLINT_VECTOR(x, y, z) \
    { GLINT_Q16(x), GLINT_Q16(y), GLINT_Q16(z) }

/**
 * Initialises a colour from literals: `const glint_colour orange = GLINT_COLOUR(1, 0.5, 0);`.
 * @param r,g,b 0 to 16; 0 is black and 1 is full
 */
#define GLINT_COLOUR(r, g, b) \
    { GLINT_Q16(r), GLINT_Q16(g), GLINT_Q16(b) }

/** Colour channels, and products of a light's and a material's channel, are at most 16. */
#define GLINT_COLOUR_MAX (16 * GLINT_ONE)

/** A pose is an affine map of column vectors: (x, y, z) goes to m[.][0] x + m[.][1] y + m[.][2] z + m[.][3]. */
typedef struct glint_pose {
    glint_q16 m[3][4]; /**< Rows of four. */
} glint_pose;

/* ---- Meshes ------------------------------------------------------------------------------------------------------ */

/** A layout stores attributes of a mesh otherwise than its arrays do: see glint_extras.h. */
typedef struct glint_mesh_layout glint_mesh_layout;

/** Clusters of a mesh let many triangles be dropped at once. They stand at the end of this header. */
typedef struct glint_clusters glint_clusters;

/** Triangles are drawn from both sides. Seen from the back they are lit with the normal flipped. */
#define GLINT_MESH_DOUBLE_SIDED 1u

/**
 * A mesh has triangles in flash or RAM. Positions are stored as int16 steps: object space is offset + extent * step /
 * 32768, per axis. The caller owns a mesh. It is read while a frame is drawn and never written. Between frames
 * everything may change: no frame relies on what a mesh was before.
 */
typedef struct glint_mesh {
    const int16_t (*positions)[3];   /**< vertex_count positions, steps. */
    const int16_t (*normals)[3];     /**< vertex_count outward normals in object space, Q15; any length but 0. */
    const uint16_t (*triangles)[3];  /**< triangle_count index triples, counter-clockwise from outside. */
    uint32_t vertex_count;           /**< 1 to 65536. */
    uint32_t triangle_count;         /**< 1 or more. */
    glint_vector offset;             /**< Object-space position of step 0. */
    glint_vector extent;             /**< Object-space length of 32768 steps, 0 or more. */
    uint32_t flags;                  /**< 0 or GLINT_MESH_DOUBLE_SIDED. */
    const uint8_t (*colours)[3];     /**< vertex_count red, green, blue times 255, or null: the material's ambient and
                                          diffuse colours are multiplied by them. */
    const uint16_t *colours565;      /**< The same in 16 bits, or null. */
    const glint_clusters *clusters;  /**< As `glint convert` writes them, or null; not used on
                                          double-sided meshes. Null where positions change. */
    const glint_mesh_layout *layout; /**< What stands in place of arrays that are null, or null. */
    const int16_t (*texture_coordinates)[2]; /**< vertex_count u, v, steps, or null. From left to right, u of a
                                                  texture goes from 0 to 1; from top to bottom, v does. */
    glint_q16 texture_offset[2];             /**< u, v of step 0. */
    glint_q16 texture_extent[2];             /**< Change of u, v over 32768 steps, 0 or more. */
} glint_mesh;

/* ---- Textures ---------------------------------------------------------------------------------------------------- */

/** A texture type says how texels are stored. It is one of the descriptors below. */
typedef struct glint_texture_type glint_texture_type;

extern const glint_texture_type glint_texture_rgb565;     /**< uint16 a texel, RRRRRGGGGGGBBBBB. */
extern const glint_texture_type glint_texture_grey8;      /**< uint8 a texel, 255 for white. */
extern const glint_texture_type glint_texture_palette256; /**< uint8 a texel: a number of the palette. */
extern const glint_texture_type glint_texture_palette16;  /**< 4 bits a texel, the left one in the high half. */

/** A texel that is stored as `key` is a hole: nothing is drawn there. */
#define GLINT_TEXTURE_HAS_KEY 1u

/** A texture is a picture that surfaces wear, in flash or RAM. The caller owns it. It is read while a frame is drawn
 * and never written. Of its levels (mipmaps) each triangle shows one: the largest that has no more texels than pixels
 * (or samples, where glint_config.samples is set) in the triangle's area, or else the last. Triangles that cross the
 * near plane, or reach far beyond the screen, show the texture itself. */
typedef struct glint_texture {
    const glint_texture_type *type;      /**< How texels are stored. */
    const void *texels;                  /**< Row after row, from the top one; of RGB565 aligned to 2. */
    const uint16_t *palette;             /**< 256 or 16 colours, RGB565; null for types without a palette. */
    uint16_t width, height;              /**< Powers of two, 1 to 1024. */
    uint16_t flags;                      /**< 0 or GLINT_TEXTURE_HAS_KEY. */
    uint16_t key;                        /**< The texel that is a hole, as it is stored. */
    const struct glint_texture *smaller; /**< The next level, or null: of the same type and flags, and of half the width
                                              and height, at least 1. A texture of one texel has none. */
} glint_texture;

/* ---- Materials --------------------------------------------------------------------------------------------------- */

/** A shading model says how a surface reflects. It is one of the descriptors below. */
typedef struct glint_shading_model glint_shading_model;

/** Adds ambient and diffuse max(N.L, 0) (Lambert, 1760). */
extern const glint_shading_model glint_model_lambert;

/** Adds to Lambert specular max(R.V, 0)^shininess where N.L > 0, R = 2 (N.L) N - L (Phong, 1975). */
extern const glint_shading_model glint_model_phong;

/** Adds to Lambert specular max(N.H, 0)^shininess where N.L > 0, H = (L + V) / |L + V| (Blinn, 1977). */
extern const glint_shading_model glint_model_blinn_phong;

/** Shows the diffuse colour as it is, whatever the lights. */
extern const glint_shading_model glint_model_unlit;

/** Specular light is added also where N.L <= 0: the highlight shines through. */
#define GLINT_MATERIAL_SPECULAR_UNGATED 1u

/** The larger of diffuse + specular and ambient counts, channel by channel, in place of their sum. */
#define GLINT_MATERIAL_MAX_WITH_AMBIENT 2u

/** Beyond its edges a texture shows the texels at them; else it repeats. */
#define GLINT_MATERIAL_CLAMP 4u

/** Between the middles of texels their colours are interpolated; else the nearest texel shows. */
#define GLINT_MATERIAL_BILINEAR 8u

/** A blend says how a surface mixes with what is behind it. All but GLINT_BLEND_NONE need glint_config.layers. */
typedef enum glint_blend {
    GLINT_BLEND_NONE = 0,    /**< It is opaque. */
    GLINT_BLEND_ALPHA = 1,   /**< It lets 1 - opacity of it through: glass. */
    GLINT_BLEND_ADD = 2,     /**< It adds opacity times its own colour: glows. */
    GLINT_BLEND_DITHERED = 3 /**< It covers a part of the pixels, as many as `opacity` says, in a pattern of 8 x 8. */
} glint_blend;

/** A material says how an object reflects. Each channel is from 0 to GLINT_COLOUR_MAX. */
typedef struct glint_material {
    const glint_shading_model *model; /**< How it reflects. */
    glint_colour ambient;             /**< Times the scene's ambient light. */
    glint_colour diffuse;             /**< Times each light's diffuse colour. */
    glint_colour specular;            /**< Times each light's specular colour: white for plastic, the diffuse one for
                                           metal. */
    glint_q16 shininess;              /**< Specular exponent p, 0 or more, any real number; 0^0 is 1. */
    uint32_t flags;                   /**< 0, or the sum of GLINT_MATERIAL_ flags above. */
    const glint_texture *texture;     /**< Multiplies the ambient and diffuse colours, and of what is lit per vertex or
                                           per facet all light; or null. */
    glint_blend blend;                /**< Whether it is opaque. */
    glint_q16 opacity;                /**< Where it blends: 0 to 1. */
} glint_material;

/**
 * Makes a surface of one paint: ambient paint * ambient_fraction, each channel rounded to nearest, diffuse paint, and a
 * white highlight. Where all three terms meet, channels may pass 1 and are clamped.
 * @param model how it reflects
 * @param paint each channel from 0 to 1
 * @param ambient_fraction 0 to 1
 * @param shininess specular exponent, 0 or more
 * @return the material
 */
glint_material glint_material_paint(const glint_shading_model *model, glint_colour paint, glint_q16 ambient_fraction,
                                    glint_q16 shininess);

/* ---- Lights ------------------------------------------------------------------------------------------------------ */

/** A light type says how light travels. It is one of the descriptors below. */
typedef struct glint_light_type glint_light_type;

/** Light comes from infinitely far, the same everywhere. It has a direction and no position. */
extern const glint_light_type glint_light_directional;

/** Light goes from a position to all sides, and weakens with its distance d: 1 / (1 + linear d + quadratic d^2). It
 * adds nothing at d = 0, that is, nearer than about 1/32768 of the distance to the eye; nearer than 1/128 of that, N.L
 * may be off by more than half a step of 255. */
extern const glint_light_type glint_light_point;

/**
 * A spot is a point light with a direction: full up to `inner` degrees from it, none from `outer` on, with a smooth
 * step between. Unit vectors of 15 bits give cosines to about 2^-14: rounding is visible in a step where the cosines of
 * `inner` and `outer` are less than 1/64 apart.
 */
extern const glint_light_type glint_light_spot;

/** A light is in world space. Ambient light belongs to the scene. */
typedef struct glint_light {
    const glint_light_type *type; /**< What kind. */
    glint_vector position;        /**< Of point lights and spots: where they stand. */
    glint_vector direction;       /**< Of directional lights and spots: the way that the light travels, from the light
                                       to what it lights; of any length but 0. */
    glint_colour diffuse;         /**< For diffuse terms. */
    glint_colour specular;        /**< For highlights. */
    glint_q16 linear, quadratic;  /**< Attenuation, per unit and per unit squared, 0 or more. */
    glint_q16 inner, outer;       /**< Of a spot: degrees from its direction, 0 <= inner <= outer <= 180. */
} glint_light;

/**
 * Returns a directional light, such as the sun's.
 * @param direction in which the light travels, in world space, of any length but 0: GLINT_VECTOR(0, -1, 0) shines down
 * @param colour of its diffuse and specular light, each channel from 0 to GLINT_COLOUR_MAX
 * @return the light; a direction of length 0 gives GLINT_ERROR_DIRECTION when it is drawn with
 */
glint_light glint_sun(glint_vector direction, glint_colour colour);

/**
 * Returns a point light that weakens with the square of its distance, up to a range. There it has faded to 1/126, which
 * is half a step of RGB565's green, and light of a colour up to 1 is not visible beyond. Half of it is left at 1/11 of
 * the range, a sixth at 1/5. Set `linear` and `quadratic` of the result for another attenuation, both 0 for none.
 * @param position in world space
 * @param colour of its diffuse and specular light, each channel from 0 to GLINT_COLOUR_MAX; beyond 1 it reaches
 * farther, by the square root
 * @param range in units of the world, Q16.16, 1/16 or more; light there is exact to 1/400. The quadratic coefficient
 * has 16 bits of fraction: beyond a range of 250 some of the attenuation is linear, beyond 2862 all of it
 * @return the light; a range below 1/16 gives GLINT_ERROR_ATTENUATION when it is drawn with
 */
glint_light glint_lamp(glint_vector position, glint_colour colour, glint_q16 range);

/**
 * Returns a spot that points at a place: full up to half its angle from its direction, none from the angle on. Set
 * `inner` of the result for another edge.
 * @param position,colour,range as for glint_lamp
 * @param at a point that it shines at, in world space: any other than `position`
 * @param angle between its direction and the cone's edge, degrees, Q16.16, 0 to 180
 * @return the light; when it is drawn with, GLINT_ERROR_ATTENUATION as for glint_lamp, GLINT_ERROR_DIRECTION where `at`
 * is its position, GLINT_ERROR_CONE where the angle is not from 0 to 180 degrees
 */
glint_light glint_spot(glint_vector position, glint_vector at, glint_colour colour, glint_q16 range, glint_q16 angle);

/** A scene has at most so many lights. */
#define GLINT_LIGHTS_MAX 8

/* ---- Poses ------------------------------------------------------------------------------------------------------- */

/** Returns the sine of an angle. @param degrees any angle, Q16.16 @return Q16.16 */
glint_q16 glint_sin(glint_q16 degrees);

/** Returns the cosine of an angle. @param degrees any angle, Q16.16 @return Q16.16 */
glint_q16 glint_cos(glint_q16 degrees);

/** Returns the pose that changes nothing. @return the pose */
glint_pose glint_pose_identity(void);

/** Returns a translation. @param x,y,z how far along each axis @return the pose */
glint_pose glint_pose_translate(glint_q16 x, glint_q16 y, glint_q16 z);

/** Returns a scale per axis. @param x,y,z factors @return the pose */
glint_pose glint_pose_scale(glint_q16 x, glint_q16 y, glint_q16 z);

/** Returns a right-handed rotation about the x axis. @param degrees any angle @return the pose */
glint_pose glint_pose_rotate_x(glint_q16 degrees);

/** Returns a right-handed rotation about the y axis. @param degrees any angle @return the pose */
glint_pose glint_pose_rotate_y(glint_q16 degrees);

/** Returns a right-handed rotation about the z axis. @param degrees any angle @return the pose */
glint_pose glint_pose_rotate_z(glint_q16 degrees);

/** Returns a right-handed rotation. @param axis of any length @param degrees any angle @return the identity where the
 * axis is 0 */
glint_pose glint_pose_rotate(glint_vector axis, glint_q16 degrees);

/** Returns the rotation of a quaternion. @param x,y,z,w of any length @return the identity where that is 0 */
glint_pose glint_pose_quaternion(glint_q16 x, glint_q16 y, glint_q16 z, glint_q16 w);

/** Applies a pose to a point. @param pose any @param point any @return rounded to nearest and saturated */
glint_vector glint_pose_apply(const glint_pose *pose, glint_vector point);

/**
 * Joins two poses, so that a pose may be turned a little every frame for as long as you like:
 * `pose = glint_pose_then(&pose, &turn)` turns it in the world, `glint_pose_then(&turn, &pose)` about its own axes.
 *
 * A pose whose axes, its first three columns, are unit and perpendicular to within 2^-14 (lengths squared and scalar
 * products) counts as the rotation next to it. So rotations, and their mirror images, stay as exact as Q16.16 can hold
 * them: lengths and scalar products of the result are within 2^-15. Scale and shear are kept as they are: where either
 * pose has any, entries are exact but for rounding, which adds up to a part in a thousand of a length in 36,000 turns.
 * Keep such an object's rotation as a pose of its own, and its scale beside it, where that is too much.
 * @param first what comes first
 * @param second what comes then
 * @return each entry rounded to nearest and saturated
 */
glint_pose glint_pose_then(const glint_pose *first, const glint_pose *second);

/* ---- Objects ----------------------------------------------------------------------------------------------------- */

/** An evaluation says where light is found; it is one of the descriptors below. */
typedef struct glint_evaluation glint_evaluation;

/** Light is found at every fragment, with the normal interpolated and made unit (Phong shading, 1975). It goes with any
 * model: the Phong model is another thing, one kind of highlight. */
extern const glint_evaluation glint_per_fragment;

/** Light is found at every vertex. Colours, clamped at 1, are interpolated (Gouraud, 1971). */
extern const glint_evaluation glint_per_vertex;

/** Light is found once a triangle, at its centroid, with the normal of its plane. */
extern const glint_evaluation glint_per_facet;

/** An object is a mesh of a material at a place. The caller owns it. It is read while a frame is drawn and never
 * written. */
typedef struct glint_object {
    const glint_mesh *mesh;         /**< What it looks like. */
    const glint_material *material; /**< What it is made of. */
    glint_pose pose;                /**< Object to world; scales may differ per axis and mirror. */
    const glint_evaluation
        *evaluation; /**< Where it is lit; may be null where it is unlit and its mesh has no colours. */
    uint8_t hidden;  /**< Not 0: it is not drawn, and its pose may be anything. */
    int16_t order;   /**< Of objects that blend: those of lower ones are drawn first, those of the same one from back to
                          front. */
} glint_object;

/* ---- Cameras ----------------------------------------------------------------------------------------------------- */

/** A projection says how a camera projects. It is null for perspective, or the descriptor below. */
typedef struct glint_projection glint_projection;

/**
 * Rays are parallel (orthographic projection): an object twice as far away looks as large. A local viewer sees what an
 * infinite viewer sees.
 *
 * Depth is linear: 65533 steps from the nearest corner of any visible object's bounding box, or the near plane, to the
 * farthest. A surface's depth is off by at most two steps. Lights with a position know a surface's place along the
 * camera's axis to such a step, up to 2^17 pixels' widths from the eye.
 */
extern const glint_projection glint_orthographic;

/** A camera says where a scene is seen from. */
typedef struct glint_camera {
    glint_pose pose;         /**< Camera to world: a rotation and the eye's position. */
    glint_q16 field_of_view; /**< Vertical, degrees, 1 to 170; not looked at where the projection is orthographic. */
    glint_q16 near_plane;    /**< Distance to the near plane, above 0. */
    const glint_projection *projection; /**< Null, or &glint_orthographic. */
    glint_q16 view_height;              /**< Where it is orthographic: the screen's height in units, 1/256 or more. */
} glint_camera;

/** Returns a camera to begin with: 4 units from the origin on +z, looking there, with a field of view of 45 degrees and
 * the near plane at 0.1. glint_camera_look_at and glint_camera_orbit move it. @return the camera */
glint_camera glint_camera_default(void);

/*
 * In perspective depths reach from the near plane to 2^33 times as far, the range of all coordinates, and all are
 * drawn, with the same pixels on every core. How exact they are is told by the depth as a multiple of that of the
 * nearest corner of any visible object's bounding box (docs/stability.md has a chart):
 * - Colours are as exact as anywhere up to 2^20 times that depth, per facet at any. Beyond, light per fragment or per
 *   vertex and colours of vertices are 0.5 of 255 off on average at 2^24 and 2 at 2^25, single pixels up to 98.
 *   Texture coordinates, and so texels and holes, lose their bits there, too.
 * - Depths are told apart to 0.6 % at 2^10 times that depth and to 9 % at 2^14. From 2^16 on all tie.
 *
 * The near plane cuts an object to within a row of 72 where the extent of its mesh is 2^16 near planes, within three at
 * 2^18 and seven at 2^20. Where the near plane is nearer than some 2^-24 extents, it cuts there.
 */

/* ---- Scenes ------------------------------------------------------------------------------------------------------ */

/** A viewer says where highlights are seen from. */
typedef enum glint_viewer {
    GLINT_VIEWER_INFINITE = 0, /**< V is the camera's backward axis everywhere: cheaper. */
    GLINT_VIEWER_LOCAL = 1     /**< V points from each fragment to the eye. */
} glint_viewer;

/** Fog hides what is far away: see glint_extras.h. */
typedef struct glint_fog glint_fog;

/** A scene holds all that a frame shows. The caller owns it. It is read while a frame is drawn and never written. */
typedef struct glint_scene {
    glint_camera camera;         /**< Where it is seen from. */
    glint_viewer viewer;         /**< Where highlights are seen from. */
    glint_colour background;     /**< What shows where no object does. */
    glint_colour ambient;        /**< Ambient light. */
    const glint_light *lights;   /**< Lights. */
    uint32_t light_count;        /**< 0 to GLINT_LIGHTS_MAX. */
    const glint_object *objects; /**< Nearest first is fastest: what is hidden is not lit. */
    uint32_t object_count;       /**< 0 or more. Where depths tie, the first drawn wins. */
    const glint_fog *fog;        /**< Null for none. */
} glint_scene;

/* ---- Output ------------------------------------------------------------------------------------------------------ */

/** A format is a descriptor that says how pixels are stored. */
typedef struct glint_format glint_format;

extern const glint_format glint_format_rgb565;    /**< 16 bits, RRRRRGGGGGGBBBBB, in the core's byte order. */
extern const glint_format glint_format_rgb565_be; /**< 16 bits, high byte first: as most SPI panels want it. */
extern const glint_format glint_format_rgb888;    /**< 3 bytes: red, green, blue. */
extern const glint_format glint_format_grey8;     /**< 1 byte: 0.299 R + 0.587 G + 0.114 B. */
extern const glint_format glint_format_grey4;     /**< 4 bits, the left pixel of a byte in its high half. */
extern const glint_format glint_format_rgb444;    /**< 12 bits, RRRRGGGGBBBB, high bits first: 2 pixels in 3 bytes. */
extern const glint_format glint_format_mono;      /**< 1 bit of luma, the left pixel of a byte lowest. */

/** A pixel is 1 bit of luma, as OLED controllers keep it: pixel (x, y) of a tile is bit y % 8 of byte x + y / 8 * 8
 * stride. */
extern const glint_format glint_format_mono_pages;

/**
 * @name Dithered
 * These use ordered dithering (Bayer, 1973) over 8 x 8 pixels: no banding, at the price of a fine pattern. Every format
 * stores floor(v + t): v is the value in its levels, t is 1/2 or, dithered, the pixel's threshold, an odd number of
 * 128ths. v is exact to a part of a level that docs/accuracy.md states for each format.
 * @{
 */
extern const glint_format glint_format_rgb565_dithered;     /**< As glint_format_rgb565. */
extern const glint_format glint_format_rgb565_be_dithered;  /**< As glint_format_rgb565_be. */
extern const glint_format glint_format_rgb888_dithered;     /**< As glint_format_rgb888. */
extern const glint_format glint_format_grey8_dithered;      /**< As glint_format_grey8. */
extern const glint_format glint_format_grey4_dithered;      /**< As glint_format_grey4. */
extern const glint_format glint_format_rgb444_dithered;     /**< As glint_format_rgb444. */
extern const glint_format glint_format_mono_dithered;       /**< As glint_format_mono. */
extern const glint_format glint_format_mono_pages_dithered; /**< As glint_format_mono_pages. */
/** @} */

/** An output table has so many entries. */
#define GLINT_GAMMA_ENTRIES 257

/** This is the output table of a panel that expects sRGB (IEC 61966-2-1), which shows linear colours too dark. It uses
 * 1.5 KB of flash where it is named, and a frame costs more instructions with a table than without. */
extern const uint16_t glint_gamma_srgb[3][GLINT_GAMMA_ENTRIES];

/** Returns the bytes of a row of pixels. @param format how they are stored @param width pixels @return bytes */
size_t glint_row_bytes(const glint_format *format, uint32_t width);

/**
 * A flush takes finished tiles. `begin` starts to send a rectangle and may return before it is sent; `wait` returns
 * when it is. They are called in pairs, in order, and the buffer is not modified between them. Tiles that show only the
 * background may pass the same pixels again. Either returns 0, or anything else to report a failure, which ends the
 * frame with GLINT_ERROR_FLUSH: no further tile is sent, and the next frame is whole.
 *
 * Flushes and painters may call all of the library with another renderer and another arena, to any depth that the stack
 * allows. They must not touch the renderer that calls them, its arena, or the scene. They must return: the library has
 * no clock, so that a wait without an end is a frame without an end. Bound each wait, and report a failure when it is
 * over. A transfer that was given up must not go on reading the pixels. The drivers in port/ return GLINT_ERROR_TIMEOUT
 * then.
 */
typedef struct glint_flush {
    /** Starts to send; `stride` is bytes from a row of `pixels` to the next. */
    int (*begin)(void *context, int x, int y, int width, int height, const void *pixels, size_t stride);
    /** May be null when `begin` returns only once all is sent. */
    int (*wait)(void *context);
    void *context; /**< Handed to both. */
} glint_flush;

/** A rectangle holds pixels of a screen. */
typedef struct glint_rectangle {
    int16_t x, y, width, height; /**< From its left upper corner on. */
} glint_rectangle;

/** A tile of the screen is cut at the screen's edges and at the region's. */
typedef struct glint_tile {
    int x, y, width, height; /**< On the screen. */
    void *pixels;            /**< The one at x, y. */
    size_t stride;           /**< Bytes from row to row. */
    /** Depth at x, y, larger where nearer. It is 0 where nothing has been drawn, so that it shows which pixels show
     * objects. It does not cover a background. */
    const uint16_t *depth;
    size_t depth_stride; /**< Numbers from row to row. */
    /** @privatesection */
    /* glint_lines_draw reads these. */
    const struct glint_frame *frame;
    const struct glint_workspace *workspace;
} glint_tile;

/**
 * A painter paints pixels of a tile, in the format of the configuration. It returns 0, or anything else to report a
 * failure, which ends the frame with GLINT_ERROR_PAINT. The caller that draws the tile calls it: two callers at once
 * where two draw tiles.
 */
typedef struct glint_painter {
    int (*paint)(void *context, const glint_tile *tile); /**< Null: nothing is painted. */
    void *context;                                       /**< Handed to it. */
} glint_painter;

/** Width and height are at most this. */
#define GLINT_SIZE_MAX 1024

/** Layers are what objects that blend are drawn with: see glint_extras.h. */
typedef struct glint_layer_stage glint_layer_stage;

/** Samples smooth edges: see glint_extras.h. */
typedef struct glint_sampling glint_sampling;

/** A configuration says how and where to draw. `glint_init` copies it; what it points to stays the caller's. */
typedef struct glint_config {
    uint16_t width;             /**< Pixels, 1 to GLINT_SIZE_MAX. */
    uint16_t height;            /**< Pixels, 1 to GLINT_SIZE_MAX. */
    uint16_t tile_width;        /**< 8, 16, 32 or 64; 0 for the default, 32. */
    uint16_t tile_height;       /**< 8, 16, 32 or 64; 0 for the default, 32. */
    const glint_format *format; /**< How pixels are stored. */
    glint_flush flush;          /**< Where they are sent. */
    void *arena;                /**< Working memory, any alignment. More means fewer passes, never other pixels. */
    size_t arena_size;          /**< Bytes; see `glint_arena_need`. */
    /**
     * glint_render puts the pixels that it sends here, for memory of its own that DMA reads. It is aligned as a pointer
     * is, or as a cache or a DMA wants it: the second of two tiles begins a multiple of 64 bytes behind the first.
     * Where it is null, pixels are in the arena, where depth is in any case.
     */
    void *pixels;
    size_t pixels_size; /**< Bytes: no less than `glint_pixels_need` tells. */
    /** Output tables for red, green and blue, or null. They have the output for 0, 1/256 .. 1; Q16, 65535 is 1. */
    const uint16_t (*gamma)[GLINT_GAMMA_ENTRIES];
    /**
     * Not 0: nobody else writes to the arena between frames. Tables of a material that the last frame prepared are then
     * kept as long as their inputs do not change, and made again where something has written there. A library built for
     * size does not keep them.
     */
    uint8_t keeps_arena;
    int16_t left, top; /**< Where the screen's first pixel lies on the display: added to where tiles are sent. */
    /**
     * The part of the screen that is drawn and sent, all 0 for the whole. Its pixels are those of the whole frame.
     * Where pixels share a byte, it ends where bytes do, or at the screen's edge: x and width are multiples of 2 in
     * formats of 4 and 12 bits and of 8 in glint_format_mono; y and height of 8 in glint_format_mono_pages.
     */
    glint_rectangle region;
    glint_painter background; /**< Paints all of a tile before objects are drawn, in place of scene->background. */
    glint_painter overlay;    /**< Paints over a finished tile, also where no object shows. */
    /**
     * Not 0: objects that have nothing to draw are left out and counted in glint_stats.skipped. These are objects whose
     * pose is singular, which would end the frame with GLINT_ERROR_POSE, and objects whose mesh has no vertices or no
     * triangles, with GLINT_ERROR_MESH. Nothing else of such a mesh is read.
     */
    uint8_t skips_degenerate;
    const glint_layer_stage *layers; /**< &glint_layers where materials blend; or null. */
    const glint_sampling *samples;   /**< &glint_samples_2x2 for smooth edges; or null. */
} glint_config;

/* ---- Errors ------------------------------------------------------------------------------------------------------ */

/** Every function that can fail returns a status, those of panels and boards too. `glint_strerror` gives the
 * sentence. */
typedef enum glint_status {
    GLINT_OK = 0,
    GLINT_ERROR_NULL = -1,         /**< A required pointer is null. */
    GLINT_ERROR_SIZE = -2,         /**< Width or height is not from 1 to GLINT_SIZE_MAX. */
    GLINT_ERROR_TILE = -3,         /**< Tile width or height is not 8, 16, 32 or 64. */
    GLINT_ERROR_ARENA = -4,        /**< The arena is smaller than the smallest this scene can be drawn with. */
    GLINT_ERROR_CAMERA = -5,       /**< The camera's axes are not unit and perpendicular, its field of view is not from
                                        1 to 170 degrees, its near plane or view height is not above 0, or eye, target and
                                        up lie on one line. */
    GLINT_ERROR_LIGHTS = -6,       /**< More than GLINT_LIGHTS_MAX lights. */
    GLINT_ERROR_DIRECTION = -7,    /**< A light's direction has length 0. */
    GLINT_ERROR_COLOUR = -8,       /**< A colour channel, or a light's times a material's, is not from 0 to 16. */
    GLINT_ERROR_SHININESS = -9,    /**< A shininess exponent is below 0. */
    GLINT_ERROR_MESH = -10,        /**< A mesh has no vertices, no triangles, more vertices than uint16 can index, an
                                        extent below 0, or clusters that do not add up to it or are too many. */
    GLINT_ERROR_INDEX = -11,       /**< A triangle refers to a vertex that its mesh does not have. */
    GLINT_ERROR_POSE = -12,        /**< A pose is singular: it squashes the object flat. */
    GLINT_ERROR_RANGE = -13,       /**< An object is too far from the camera or too large for 32-bit coordinates. */
    GLINT_ERROR_FLUSH = -14,       /**< The flush callback reported a failure; the frame was not finished. */
    GLINT_ERROR_VIEWER = -15,      /**< The viewer is neither infinite nor local. */
    GLINT_ERROR_ATTENUATION = -16, /**< An attenuation coefficient is below 0. */
    GLINT_ERROR_CONE = -17,        /**< A spot's cone is wider inside than outside, below 0 or above 180 degrees. */
    GLINT_ERROR_GENERATOR = -18,   /**< A generator has too few divisions, a size not above 0, or too little room. */
    GLINT_ERROR_FLAGS = -20,       /**< A mesh's or a material's flags have a bit that is not defined. */
    GLINT_ERROR_PIXELS = -21,      /**< A configuration's own memory of pixels is too small, or not aligned. */
    GLINT_ERROR_REGION = -22,   /**< A region is not on the screen, or a rectangle not on the panel, or its edges divide
                                     a byte of the format. */
    GLINT_ERROR_PAINT = -23,    /**< The background or overlay callback reported a failure; the frame was not
                                     finished. */
    GLINT_ERROR_TIMEOUT = -24,  /**< A panel's bus took no byte, or did not fall idle, for longer than it can need. */
    GLINT_ERROR_BUS = -25,      /**< A panel's bus reported a failed transfer. */
    GLINT_ERROR_FORMAT = -26,   /**< A panel does not take pixels of this size, or its bus no words. */
    GLINT_ERROR_ROTATION = -27, /**< A panel's controller cannot turn the picture so. */
    GLINT_ERROR_TYPE = -28,     /**< A layout's type does not serve the attribute that it stands for. */
    GLINT_ERROR_STRIDE = -29,   /**< A layout's stride is less than one of its type takes, or its stride or its data are
                                     not aligned as that type is. */
    GLINT_ERROR_TEXTURE = -30, /**< A texture's width or height is not a power of two from 1 to 1024, its key is none of
                                    its type, a smaller level is not half as large or of another type or flags, or its
                                  object's mesh has no texture coordinates, or an extent below 0. */
    GLINT_ERROR_BLEND = -31,   /**< A material's blend is none of those above, or its opacity is not from 0 to 1. */
    GLINT_ERROR_LAYERS = -32,  /**< A material blends, or fog fades to a painted background, and the configuration has
                                    no layers. */
    GLINT_ERROR_FOG = -33,     /**< Fog does not end behind its start, or starts in front of the eye. */
    GLINT_ERROR_SAMPLES = -34, /**< With samples, width or height is above 512, or a tile's above 32. */
    GLINT_ERROR_WIDTH = -35    /**< A line's width is not from 0 to 64. */
} glint_status;

/** Returns the meaning of a status. @param status a glint_status @return a sentence in English; "unknown status" for
 * any other number; never null */
const char *glint_strerror(int status);

/* ---- Drawing ----------------------------------------------------------------------------------------------------- */

/** Statistics count since the frame began. */
typedef struct glint_stats {
    uint32_t passes;      /**< Times the scene was gone through. */
    uint32_t tiles;       /**< Tiles drawn and sent. */
    uint32_t vertices;    /**< Vertices transformed. */
    uint32_t triangles;   /**< Triangles looked at. */
    uint32_t facing_away; /**< Of these, dropped: facing away, or without area. */
    uint32_t outside;     /**< Of these, dropped: outside the screen, or between pixel centres. */
    uint32_t clipped;     /**< Of these, cut at the near plane or the guard band. */
    uint32_t hidden;      /**< Objects dropped whole: outside the screen, hidden, or skipped. */
    uint32_t references;  /**< Triangle references put into tiles. */
    uint32_t arena_used;  /**< Most bytes of the arena in use. */
    int flush_error;      /**< What the flush callback returned when it failed, else 0. */
    uint32_t skipped;     /**< Objects left out as glint_config.skips_degenerate asks, else 0. */
} glint_stats;

/** The last frame leaves prepared materials in the arena. */
typedef struct glint_kept {
    /** @privatesection */
    const struct glint_shading *shadings;
    uint32_t count;
    size_t end; /* of the arena's use */
} glint_kept;

/** A renderer draws; glint_init sets it up. The caller owns it. */
typedef struct glint_renderer {
    glint_stats stats; /**< Of the last frame; 0 where it could not begin. */
    /** @privatesection */
    glint_config config;
    glint_kept kept; /* of use only where the arena is kept */
} glint_renderer;

/**
 * Sets a renderer up and draws nothing. On failure the renderer, if there is one, is all 0.
 * @param renderer the caller's
 * @param config how and where to draw; copied
 * @return GLINT_ERROR_NULL, _SIZE, _TILE, _PIXELS, or _ARENA when the arena cannot hold even the tile buffers.
 */
glint_status glint_init(glint_renderer *renderer, const glint_config *config);

/**
 * Draws a scene: every pixel of the screen, or of the region, goes through the flush callback once, tile by tile, left
 * to right and top to bottom. Errors in the scene are found before the first tile is sent.
 * Callbacks must not call the library with the same renderer, nor with its arena: what is being drawn lies there, and
 * nothing checks for it.
 * @param renderer what glint_init has set up
 * @param scene what to draw
 * @return GLINT_OK, or why the frame was not drawn or not finished
 */
glint_status glint_render(glint_renderer *renderer, const glint_scene *scene);

/**
 * Draws a scene likewise, for one frame, in another region than the configuration's.
 * @param renderer,scene as for glint_render
 * @param region see glint_config.region
 * @return as for glint_render; GLINT_ERROR_REGION
 */
glint_status glint_render_region(glint_renderer *renderer, const glint_scene *scene, const glint_rectangle *region);

/** These are bytes of arena for a scene. Each is no less than the one before it. */
typedef struct glint_need {
    size_t least;    /**< Below this, GLINT_ERROR_ARENA. Between this and `resident`, vertices are loaded in parts. */
    size_t resident; /**< From this on every vertex is transformed once a frame, for up to 57344 triangles in view. */
    size_t one_pass; /**< From this on, one pass; more has no effect. */
} glint_need;

/**
 * Finds how much arena a scene needs when glint_render draws it with this configuration. The configuration's arena and
 * the size of its pixels do not count. Where objects move, `resident` and `one_pass` are those of this frame: for all
 * frames, use the largest over their poses.
 * @param config,scene what is to be drawn
 * @param need set
 * @return the error that drawing the scene would give: then `need` is as it was
 */
glint_status glint_arena_need(const glint_config *config, const glint_scene *scene, glint_need *need);

/** Returns the bytes of `pixels` that glint_render needs where they are apart from the arena. @param config what is to
 * be drawn with @return 0 when the configuration is null or not valid */
size_t glint_pixels_need(const glint_config *config);

/* ---- Where a camera looks ---------------------------------------------------------------------------------------- */

/**
 * Sets camera->pose.
 * @param camera its other fields stay
 * @param eye where it stands
 * @param at what it looks at
 * @param up a direction that it sees upwards, of any length
 * @return GLINT_ERROR_CAMERA when the three lie on one line: then the camera is as it was.
 */
glint_status glint_camera_look_at(glint_camera *camera, glint_vector eye, glint_vector at, glint_vector up);

/**
 * Sets camera->pose so that the camera looks at `at` from a distance: without angles from +z, with a yaw of 90 degrees
 * from +x, with a pitch of 90 degrees from +y.
 * @param camera its other fields stay
 * @param at what it looks at
 * @param yaw,pitch degrees, any
 * @param distance from `at`
 */
void glint_camera_orbit(glint_camera *camera, glint_vector at, glint_q16 yaw, glint_q16 pitch, glint_q16 distance);

/* ---- Clusters of meshes ------------------------------------------------------------------------------------------ */

/** A cull drops triangles that face away, many at once. It is the descriptor below. */
typedef struct glint_cull glint_cull;

/** Drops clusters whose triangles all face away, by their normals' cones. */
extern const glint_cull glint_cull_cones;

/**
 * A cluster has triangles that lie together and face much the same way, and vertices. Triangles and vertices of a mesh
 * follow each other as its clusters do. `glint convert` makes clusters, and leaves them out with `--no-clusters`: where
 * flash is short, or most of a frame is light of fragments, which they do not save.
 *
 * With the eye at e, in steps, a triangle in the plane n.p = h faces away where n.e <= h. The normal n of each triangle
 * of a cluster can be scaled so that |n - axis| <= spread and h >= 256 height: where axis.e + spread |e| <= 256 height
 * all of them face away. Degenerate triangles constrain neither value.
 */
typedef struct glint_cluster {
    int8_t axis[3];     /**< As above. */
    uint8_t spread;     /**< As above. */
    int16_t height;     /**< As above. */
    uint16_t triangles; /**< Number of triangles. */
    uint16_t vertices;  /**< Number of vertices first used by this cluster. */
    uint16_t borrowers; /**< Number of other clusters with triangles at these vertices. */
} glint_cluster;

/** Clusters hold all triangles and vertices of a mesh. A triangle that faces away so little that rounding its corners
 * to 1/16 of a pixel reverses it is dropped with its cluster too. */
struct glint_clusters {
    const glint_cull *cull;    /**< glint_cull_cones; null for no clusters. */
    const glint_cluster *list; /**< The clusters. */
    const uint16_t *borrowers; /**< Indices of the borrowers, cluster after cluster; an index >= count means "always
                                    visible". Null: every borrower is. */
    uint32_t count;            /**< 1 to 65536 clusters. */
};

#ifdef __cplusplus
}
#endif

#endif
