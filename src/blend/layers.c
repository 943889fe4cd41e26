/* SPDX-License-Identifier: MIT */
/*
 * Draws objects that blend, each as a layer: onto pixels of its own, and a copy of the tile's depth. Pixels whose depth
 * differs then are mixed into the tile.
 */
#include "../pixel/pixel.h"
#include "blend.h"

typedef struct glint_layer glint_layer;

/* The layer of a tile. Behind it lie its depth and its pixels. */
struct glint_layer {
    uint32_t object;   /* that is drawn now, plus 1; 0 where none that blends is */
    uint32_t is_faded; /* whether fog has faded the opaque objects */
    uint32_t failed;   /* whether the background's painter has failed */
    uint32_t tile;
};

/* Returns the pixels of a tile. */
static uint32_t count_pixels(const glint_frame *frame) {
    return (uint32_t)frame->config.tile_width << frame->tile_shift_y;
}

static uint16_t *layer_depth(glint_layer *layer) {
    return (uint16_t *)(void *)(layer + 1);
}

static void *layer_pixels(const glint_frame *frame, glint_layer *layer) {
    return layer_depth(layer) + count_pixels(frame);
}

/* ---- Set-up ---- */

static glint_status check_blend(const glint_material *material) {
    return (uint32_t)material->blend > GLINT_BLEND_DITHERED || (uint32_t)material->opacity > GLINT_ONE
               ? GLINT_ERROR_BLEND
               : GLINT_OK;
}

static size_t size_layer(const glint_config *config) {
    const size_t pixels = (size_t)config->tile_width * config->tile_height << glint_sample_bits(config);
    return GLINT_ALIGNED(sizeof(glint_layer) + pixels * sizeof(uint16_t) + pixels * config->format->bits / 8);
}

/* Is an object drawn after those that are opaque? */
static int comes_last(const glint_object *object) {
    return object->material->blend == GLINT_BLEND_ALPHA || object->material->blend == GLINT_BLEND_ADD;
}

/* Returns how far the middle of an object's bounding box lies from the eye along the camera's axis. */
static int64_t find_depth_of(const glint_scene *scene, const glint_object *object) {
    int64_t sight[3];
    glint_find_sight(&scene->camera, glint_pose_apply(&object->pose, object->mesh->offset), sight);
    return sight[2];
}

/* Is one of two objects that come last drawn before the other, which stands behind it in the scene? */
static int is_before(const glint_scene *scene, const glint_object *one, const glint_object *other) {
    if (one->order != other->order)
        return one->order < other->order;
    return find_depth_of(scene, one) >= find_depth_of(scene, other);
}

static glint_status set_order(glint_frame *frame) {
    const glint_scene *const scene = frame->scene;
    const uint32_t count = scene->object_count;
    uint32_t *const order = glint_take(&frame->memory, count * sizeof *order), last = 0;
    if (!order)
        return GLINT_ERROR_ARENA;
    for (uint32_t i = 0; i < count; i++)
        if (!comes_last(&scene->objects[i]))
            order[last++] = i;
    for (uint32_t i = 0, first = last; i < count; i++) {
        if (!comes_last(&scene->objects[i]))
            continue;
        uint32_t place = last++;
        for (; place > first && !is_before(scene, &scene->objects[order[place - 1]], &scene->objects[i]); place--)
            order[place] = order[place - 1];
        order[place] = i;
    }
    frame->order = order;
    return GLINT_OK;
}

/* ---- Layers ---- */

static void begin_tile(glint_workspace *workspace, uint32_t tile) {
    *workspace->layer = (glint_layer){.tile = tile};
}

/* Does fog fade to the pixels of a painter? */
static int fades_to_painted(const glint_frame *frame) {
    return frame->scene->fog->to_background && frame->config.background.paint;
}

/* Paints the background again, where the pixels of layers are. */
static void paint_background(const glint_frame *frame, const glint_workspace *workspace) {
    const glint_painter *const painter = &frame->config.background;
    glint_layer *const layer = workspace->layer;
    glint_workspace there = *workspace;
    glint_tile of;
    there.pixels = layer_pixels(frame, layer);
    glint_tile_find(frame, &there, layer->tile, &of);
    layer->failed = painter->paint(painter->context, &of) != 0;
    if (frame->samples)
        frame->samples->spread(frame, there.pixels);
}

/* Fades what is opaque, before the first object that comes last. */
static void fade_opaque(const glint_frame *frame, const glint_workspace *workspace) {
    const glint_fog *const fog = frame->scene->fog;
    const void *background = 0;
    workspace->layer->is_faded = 1;
    if (!fog)
        return;
    if (fades_to_painted(frame)) {
        paint_background(frame, workspace);
        background = layer_pixels(frame, workspace->layer);
    }
    fog->type->fade(frame, workspace->depth, workspace->pixels, background, 0, count_pixels(frame));
}

/* A layer on its way into the tile. */
typedef struct layer_mix {
    const glint_frame *frame;
    uint16_t *depth;       /* of the tile */
    const uint16_t *drawn; /* of the layer, */
    void *pixels;          /* and its pixels */
    glint_canvas canvas;
    const glint_fog *fog;
    uint32_t part;
    glint_q16 opacity;
    uint8_t blend;
    uint8_t fades; /* whether fog takes part in place of colour */
} layer_mix;

static void begin_mix(layer_mix *mix, const glint_frame *frame, const glint_workspace *workspace, uint32_t object) {
    const glint_material *const material = glint_object_at(frame, object)->material;
    mix->frame = frame;
    mix->depth = workspace->depth;
    mix->drawn = layer_depth(workspace->layer);
    mix->pixels = layer_pixels(frame, workspace->layer);
    mix->canvas = glint_canvas_of(frame, workspace->pixels);
    mix->fog = frame->scene->fog;
    mix->opacity = material->opacity;
    mix->part = (uint32_t)(material->opacity + 128) >> 8;
    mix->blend = (uint8_t)material->blend;
    mix->fades = mix->fog && (mix->blend == GLINT_BLEND_ADD || fades_to_painted(frame));
}

/* Does an opacity cover a pixel? */
static int is_covered(glint_q16 opacity, uint32_t column, uint32_t row) {
    return glint_dither_matrix[(row & 7) * 8 + (column & 7)] * 512 < opacity;
}

static int covers(const glint_material *material, uint32_t column, uint32_t row) {
    return material->blend != GLINT_BLEND_DITHERED || is_covered(material->opacity, column, row);
}

/* Takes a pixel of a layer that covers some into the tile, if it covers this one. */
static void sift_pixel(const layer_mix *mix, uint32_t offset) {
    const glint_canvas from = {mix->canvas.format, mix->pixels, mix->canvas.shift};
    if (!is_covered(mix->opacity, offset, offset >> mix->canvas.shift))
        return;
    mix->depth[offset] = mix->drawn[offset];
    if (mix->canvas.format->bits == 16)
        ((uint16_t *)mix->canvas.pixels)[offset] = ((const uint16_t *)mix->pixels)[offset];
    else
        glint_write_pixel(&mix->canvas, offset, glint_read_pixel(&from, offset));
}

/* Takes a run of pixels of a layer into the tile. */
static void mix_run(const layer_mix *mix, uint32_t first, uint32_t end) {
    const int adds = mix->blend == GLINT_BLEND_ADD;
    if (mix->blend == GLINT_BLEND_DITHERED) {
        for (; first < end; first++)
            sift_pixel(mix, first);
    } else if (mix->fades) {
        for (; first < end; first++) {
            const uint32_t visible = mix->fog->type->visible_at(mix->frame, mix->drawn[first]);
            const uint32_t part = (mix->part * visible + GLINT_WHOLE / 2) / GLINT_WHOLE;
            glint_mix_pixels(&mix->canvas, mix->pixels, first, first + 1, part, adds);
        }
    } else {
        if (mix->fog)
            mix->fog->type->fade(mix->frame, mix->drawn, mix->pixels, 0, first, end);
        glint_mix_pixels(&mix->canvas, mix->pixels, first, end, mix->part, adds);
    }
}

/* Moves two places on to where the depth there differs, words of two first. @return 0 where it does not up to `last` */
static inline int find_difference(const uint16_t **here, const uint16_t **at, const uint16_t *last) {
    const uint16_t *a = *here, *b = *at;
    if (a != last && (uintptr_t)a & 2 && *a == *b)
        a++, b++;
    if (!((uintptr_t)a & 2))
        for (; a != last && *(const glint_word *)(const void *)a == *(const glint_word *)(const void *)b; a += 2)
            b += 2;
    if (a != last && *a == *b)
        a++, b++;
    *here = a;
    *at = b;
    return a != last;
}

/* Finishes the object that is drawn now, if any: goes through the runs of pixels whose depth it has changed. */
static GLINT_HOT void finish_layer(const glint_frame *frame, const glint_workspace *workspace) {
    glint_layer *const layer = workspace->layer;
    if (!layer->object)
        return;
    layer_mix mix;
    begin_mix(&mix, frame, workspace, layer->object - 1);
    layer->object = 0;
    const uint16_t *const depth = mix.depth, *const last = depth + count_pixels(frame);
    const uint16_t *here = depth, *at = mix.drawn;
    while (find_difference(&here, &at, last)) {
        const uint16_t *const first = here;
        do
            here++, at++;
        while (here != last && *here != *at);
        mix_run(&mix, (uint32_t)(first - depth), (uint32_t)(here - depth));
    }
}

/* Begins the layer of an object. */
static void begin_layer(const glint_frame *frame, const glint_workspace *workspace, uint32_t object) {
    glint_layer *const layer = workspace->layer;
    if (!layer->is_faded && comes_last(glint_object_at(frame, object)))
        fade_opaque(frame, workspace);
    memcpy(layer_depth(layer), workspace->depth, count_pixels(frame) * sizeof(uint16_t));
    layer->object = object + 1;
}

static void draw_in_layer(glint_row_walk *walk) {
    const glint_draw *const draw = walk->draw;
    const glint_frame *const frame = walk->frame;
    const glint_workspace *const workspace = walk->workspace;
    const uint32_t object = draw->shading->material->blend ? draw->object + 1 : 0;
    if (object != workspace->layer->object) {
        finish_layer(frame, workspace);
        if (object)
            begin_layer(frame, workspace, draw->object);
    }
    if (object)
        glint_walk_on(walk, layer_depth(workspace->layer), layer_pixels(frame, workspace->layer));
    else
        glint_walk_on(walk, workspace->depth, workspace->pixels);
    glint_drawer_of(frame, draw)(walk);
}

static int finish_layers(const glint_frame *frame, const glint_workspace *workspace) {
    finish_layer(frame, workspace);
    if (!workspace->layer->is_faded)
        fade_opaque(frame, workspace);
    return workspace->layer->failed != 0;
}

const glint_layer_stage glint_layers = {check_blend,   size_layer, set_order,    begin_tile,
                                        draw_in_layer, covers,     finish_layers};
