/* SPDX-License-Identifier: MIT */
/**
 * @file blend.h
 * Blending: layers of objects that are not opaque, and fog. Each is linked where a program names it, and works on
 * pixels that are drawn and stored: no other stage knows of it.
 */
#ifndef GLINT_BLEND_H
#define GLINT_BLEND_H

#include "../geometry/draw.h"
#include "../light/evaluation.h"
#include "../light/wear.h"
#include "../pixel/pixel.h"

/** A part of a colour is in steps of 1/GLINT_WHOLE. */
#define GLINT_WHOLE 256

/** The pixels of a tile as the functions below see them. */
typedef struct glint_canvas {
    const glint_format *format;
    void *pixels;
    unsigned shift; /* binary logarithm of the tile's width */
} glint_canvas;

static inline glint_canvas glint_canvas_of(const glint_frame *frame, void *pixels) {
    return (glint_canvas){frame->config.format, pixels, frame->tile_shift_x};
}

/** Returns a pixel as a number: red, green, blue from the highest bit down, or luma. */
uint32_t glint_read_pixel(const glint_canvas *canvas, uint32_t offset);

/** Stores a pixel from such a number. */
void glint_write_pixel(const glint_canvas *canvas, uint32_t offset, uint32_t pixel);

/** Mixes pixel `offset` with another: (1 - part) of its own and `part` of that, or its own and `part` of that and at
 * most white. `part` is from 0 to GLINT_WHOLE; formats of 16 bits round it to 1/32. */
void glint_mix_pixel(const glint_canvas *canvas, uint32_t offset, uint32_t with, uint32_t part, int adds);

/** Mixes pixels from `first` to before `end` with those of another tile, in the same way. */
void glint_mix_pixels(const glint_canvas *canvas, void *with, uint32_t first, uint32_t end, uint32_t part, int adds);

/** Returns the threshold of a pixel, 1/128 level. */
static inline uint32_t glint_canvas_threshold(const glint_canvas *canvas, uint32_t offset) {
    const glint_target target = {canvas->pixels, canvas->shift, canvas->format->is_dithered};
    return glint_threshold(&target, offset);
}

/** Returns a part in steps of 1/32. */
static inline uint32_t glint_in_steps(uint32_t part) {
    return (part + GLINT_WHOLE / 64) / (GLINT_WHOLE / 32);
}

/** Returns RGB565 with room for 5 bits of fraction: blue in bits 0 to 4, red in 11 to 15, green in 21 to 26. */
#define GLINT_APART 0x07e0f81fu
static inline uint32_t glint_take_apart(uint32_t pixel) {
    return (pixel | pixel << 16) & GLINT_APART;
}

/** Mixes two pixels of RGB565. `part` is from 0 to 32, the threshold in 1/32 level. */
static inline uint32_t glint_mix_565(uint32_t pixel, uint32_t with, uint32_t part, uint32_t threshold) {
    const uint32_t a = glint_take_apart(pixel), b = glint_take_apart(with);
    const uint32_t mixed = (a * 32 + (b - a) * part + threshold * 0x00200801u) >> 5 & GLINT_APART;
    return (mixed | mixed >> 16) & 0xffff;
}

/** Returns a pixel of 16 bits in the core's order of bytes, from the format's, or the other way round. */
static inline uint32_t glint_order_bytes(const glint_format *format, uint32_t pixel) {
    return format->is_high_first ? glint_to_high_first(pixel) : pixel;
}

/** This stage is linked where config.layers names it. */
struct glint_layer_stage {
    /** Checks a material that blends. @return GLINT_ERROR_BLEND or GLINT_OK */
    glint_status (*check)(const glint_material *material);
    /** Returns the bytes of a workspace that the layers of a tile use. */
    size_t (*size)(const glint_config *config);
    /** Sets the order in which objects are drawn. @return GLINT_ERROR_ARENA where it does not fit */
    glint_status (*prepare)(glint_frame *frame);
    /** Begins a tile. */
    void (*begin)(glint_workspace *workspace, uint32_t tile);
    /** Draws the part of a triangle that lies in a tile. */
    void (*draw)(struct glint_row_walk *walk);
    /** Tells whether objects of a material cover a pixel of a tile, where they cover some in a pattern. */
    int (*covers)(const glint_material *material, uint32_t column, uint32_t row);
    /** Finishes a tile. @return not 0 where the background's painter failed */
    int (*finish)(const glint_frame *frame, const glint_workspace *workspace);
};

struct glint_fog_type {
    uint8_t is_squared;
    /** Checks fog. @return GLINT_ERROR_FOG, _COLOUR, _LAYERS or GLINT_OK */
    glint_status (*check)(const glint_config *config, const glint_fog *fog);
    /** Makes the frame's table of fog. @return GLINT_ERROR_ARENA where it does not fit */
    glint_status (*prepare)(glint_frame *frame);
    /** Fades pixels from `first` to before `end` by their depth, to the fog's colour, or to a background's pixels where
     * these are not null. */
    void (*fade)(const glint_frame *frame, const uint16_t *depth, void *pixels, const void *background, uint32_t first,
                 uint32_t end);
    /** Returns the part of a surface that is visible at a depth, 0 to GLINT_WHOLE. */
    uint32_t (*visible_at)(const glint_frame *frame, uint32_t depth);
};

#define GLINT_FOG_OCTAVES 8
#define GLINT_FOG_NODE_BITS 3

/** A frame's table of fog has 8 nodes to each octave of depth, from that of the fog's end on. */
typedef struct glint_fog_table {
    uint32_t packed;   /* the pixel of the fog's colour */
    glint_lanes lanes; /* its lanes, to which dithered formats add a pixel's threshold */
    uint32_t zeros;    /* leading zeros, of 16 bits, of depths in the first octave */
    /* The part of a surface that is visible, Q13, from far to near. It goes on below 0 and above 1, where it is cut off
     * only when it has been interpolated. */
    int16_t visible[(GLINT_FOG_OCTAVES << GLINT_FOG_NODE_BITS) + 1];
} glint_fog_table;

/** Returns the bytes of the arena that the table of fog uses. */
static inline size_t glint_fog_size(const glint_scene *scene) {
    return scene->fog ? GLINT_ALIGNED(sizeof(glint_fog_table)) : 0;
}

/** Returns the function that draws a triangle of a draw, layers apart. */
static inline void (*glint_drawer_of(const glint_frame *frame, const glint_draw *draw))(struct glint_row_walk *walk) {
    return draw->texture ? draw->texture->type->stage->draw
           : draw->light ? draw->evaluation->draw_triangle
                         : frame->config.format->flat;
}

/** Returns the bytes of the arena that the order of objects uses. */
static inline size_t glint_order_size(const glint_config *config, const glint_scene *scene) {
    return config->layers ? GLINT_ALIGNED(scene->object_count * sizeof(uint32_t)) : 0;
}

#endif
