/* SPDX-License-Identifier: MIT */
/*
 * Fades pixels by their depth. What is visible at a depth stands in a table of 8 nodes to each octave of depth, from
 * the octave of the fog's end on, and is linear between them. Distances w are inverse to depth: with the second
 * derivatives of 1/x and 1/x^2, linear fog is off by at most 9/8 w / (256 r), squared fog by 9/8 w / (512 r) times (6 x
 * + 2 start / r), where r is end - start and x the part of linear fog at the farther node. Nearer than 1/128 of the end
 * it is as there.
 */
#include "../math/division.h"
#include "blend.h"

/* Bits of a depth's position between two nodes, once it has 16. */
#define FRACTION_BITS (15 - GLINT_FOG_NODE_BITS)

/* All of a surface is visible, Q13. */
#define VISIBLE_BITS 13
#define VISIBLE_ONE (1 << VISIBLE_BITS)

/* ---- Set-up ---- */

static glint_status check_fog(const glint_config *config, const glint_fog *fog) {
    const glint_colour *const c = &fog->colour;
    if (fog->start < 0 || fog->end <= fog->start)
        return GLINT_ERROR_FOG;
    if ((uint32_t)c->r > GLINT_COLOUR_MAX || (uint32_t)c->g > GLINT_COLOUR_MAX || (uint32_t)c->b > GLINT_COLOUR_MAX)
        return GLINT_ERROR_COLOUR;
    return fog->to_background && config->background.paint && !config->layers ? GLINT_ERROR_LAYERS : GLINT_OK;
}

/* Distances along the camera's axis, Q28. */
typedef struct depth_scale {
    int64_t nearest;         /* of depth 2^16; of parallel rays: */
    int64_t farthest, range; /* the distance of depth 3/2, and from there to the nearest, 65533 steps */
} depth_scale;

static depth_scale scale_of(const glint_frame *frame) {
    depth_scale scale = {frame->view->nearest, 0, 0};
    if (frame->view->is_parallel)
        frame->scene->camera.projection->get_range(frame->view, &scale.farthest, &scale.range);
    return scale;
}

/* Returns the distance, Q16 from 0 to `most`, in the middle of a step of depth. The depth is a mantissa, 2^15 to 2^16,
 * over 2^zeros. */
static int32_t find_fog_distance(const depth_scale *scale, uint32_t mantissa, uint32_t zeros, int32_t most) {
    const uint32_t twice = 2 * mantissa - (1u << zeros); /* 2^15 to 2^17: twice the depth less 1, over 2^zeros */
    int64_t w;
    if (scale->range) {
        const unsigned down = scale->range >> 45 ? 17 : 0;
        const int64_t part = (scale->range >> down) * ((int64_t)(twice >> zeros) - 2) >> (17 - down);
        w = scale->farthest - part - (part >> 15) - (part >> 16); /* 65536 / 65533 */
    } else if (scale->nearest >> 12 >= most) {
        return most;
    } else {
        const unsigned down = 16 - glint_leading_zeros(twice);
        w = scale->nearest * glint_reciprocal16(twice >> down) * 2 >> (15 + down - zeros);
    }
    w = glint_shift_right64(w, 12);
    return w < 0 ? 0 : w < most ? (int32_t)w : most;
}

/* Nodes are at most so far from 0 and from 1, Q13. */
#define NODE_MOST (3 * VISIBLE_ONE - 1)

/* Returns the part of a surface that is visible at a distance, Q13, as if fog went on in front of its start and behind
 * its end: there and back it is point-symmetric about its start. */
static int32_t find_visible(const glint_fog *fog, int32_t distance) {
    const uint32_t range = (uint32_t)(fog->end - fog->start);
    const int is_in_front = distance < fog->start;
    const uint32_t inside = (uint32_t)(is_in_front ? fog->start - distance : distance - fog->start);
    const unsigned zeros = glint_leading_zeros(range);
    int32_t taken = NODE_MOST;
    if (inside >> 2 < range) { /* a quarter of it by the range, Q15 */
        const uint32_t scaled = (zeros >= 2 ? inside << (zeros - 2) : inside >> (2 - zeros)) >> 16;
        taken = (int32_t)(scaled * (uint32_t)glint_reciprocal16(range << zeros >> 16) >> 16);
        taken = fog->type->is_squared ? (int32_t)((uint32_t)taken * (uint32_t)taken >> 13) : taken;
    }
    taken = glint_least(taken, NODE_MOST);
    return VISIBLE_ONE + (is_in_front ? taken : -taken);
}

/* Sets the pixel of the fog's colour, rounded to levels. */
static void set_colour(const glint_config *config, const glint_colour *colour, glint_fog_table *table) {
    const uint32_t shown[3] = {(uint32_t)colour->r << 7, (uint32_t)colour->g << 7, (uint32_t)colour->b << 7};
    int32_t channel[3];
    glint_channels_of(shown, channel);
    table->lanes = glint_flat_lanes(config, channel);
    table->packed = glint_pack(config->format, table->lanes);
}

static glint_status prepare_fog(glint_frame *frame) {
    const glint_fog *const fog = frame->scene->fog;
    const depth_scale scale = scale_of(frame);
    glint_fog_table *const table = glint_take(&frame->memory, sizeof *table);
    if (!table)
        return GLINT_ERROR_ARENA;
    const int32_t most = fog->end < INT32_MAX / 2 ? 2 * fog->end : INT32_MAX; /* twice the end is in the first octave */
    set_colour(&frame->config, fog->to_background ? &frame->scene->background : &fog->colour, table);
    table->zeros = GLINT_FOG_OCTAVES - 1;
    while (!scale.range && table->zeros < 15 && find_fog_distance(&scale, 1u << 15, table->zeros, most) < fog->end)
        table->zeros++;
    for (uint32_t i = 0; i <= GLINT_FOG_OCTAVES << GLINT_FOG_NODE_BITS; i++) {
        const uint32_t octave = i >> GLINT_FOG_NODE_BITS,
                       nodes = (1u << GLINT_FOG_NODE_BITS) + (i & ((1u << GLINT_FOG_NODE_BITS) - 1));
        const int is_end = octave == GLINT_FOG_OCTAVES; /* of the last octave */
        const uint32_t mantissa = is_end ? 1u << 16 : nodes << FRACTION_BITS;
        table->visible[i] = (int16_t)find_visible(
            fog, find_fog_distance(&scale, mantissa, table->zeros - octave + (uint32_t)is_end, most));
    }
    frame->fog = table;
    return GLINT_OK;
}

/* ---- Pixels ---- */

/* Returns the part of a surface that is visible at a depth, from 0 to 1 - 2^-13, Q13. */
static GLINT_INLINE int32_t visible_at(const int16_t *visible, uint32_t first_zeros, uint32_t depth) {
    const uint32_t zeros = glint_leading_zeros(depth) - 16, octave = first_zeros - zeros;
    const uint32_t mantissa = depth << zeros, nodes = 1u << GLINT_FOG_NODE_BITS;
    uint32_t node = octave * nodes + (mantissa >> FRACTION_BITS) - nodes;
    int32_t between = (int32_t)(mantissa & ((1u << FRACTION_BITS) - 1));
    if (GLINT_RARELY(octave >= GLINT_FOG_OCTAVES)) {
        node = zeros < first_zeros ? (GLINT_FOG_OCTAVES << GLINT_FOG_NODE_BITS) - 1 : 0;
        between = zeros < first_zeros ? 1 << FRACTION_BITS : 0;
    }
    const int32_t change = visible[node + 1] - visible[node];
    return (int32_t)glint_saturate(visible[node] + glint_shift_right(change * between, FRACTION_BITS), VISIBLE_BITS, 0);
}

static uint32_t visible_in_frame(const glint_frame *frame, uint32_t depth) {
    const glint_fog_table *const table = frame->fog;
    return (uint32_t)(visible_at(table->visible, table->zeros, depth) + 16) >> 5;
}

/* Returns the first depth from one that is 0 on that may not be, or `last`, which is a whole number of words away. */
static inline const uint16_t *skip_empty(const uint16_t *depth, const uint16_t *last) {
    if ((uintptr_t)depth & 2 || depth[1])
        return depth + 1;
    do
        depth += 2;
    while (depth != last && !*(const glint_word *)(const void *)depth);
    return depth;
}

/* Fades pixels of RGB565 that are not dithered, to a colour. */
static GLINT_HOT void fade_565(const glint_fog_table *table, const glint_canvas *canvas, const uint16_t *depth,
                               uint32_t first, uint32_t end) {
    const uint32_t fog = glint_take_apart(table->packed), base = fog * 32 + GLINT_NEAREST / 4 * 0x00200801u,
                   zeros = table->zeros;
    const int16_t *const visible = table->visible;
    const uint16_t *const last = depth + end;
    const int swaps = canvas->format->is_high_first;
    const uintptr_t to_pixel = (uintptr_t)canvas->pixels - (uintptr_t)depth;
    depth += first;
    while (depth != last) {
        const uint32_t here = *depth;
        if (!here) {
            depth = skip_empty(depth, last);
            continue;
        }
        uint16_t *const pixel = (uint16_t *)((uintptr_t)depth + to_pixel);
        const uint32_t surface = glint_take_apart(swaps ? glint_to_high_first(*pixel) : *pixel),
                       part = (uint32_t)(visible_at(visible, zeros, here) + 128) >> 8;
        const uint32_t mixed = (base + (surface - fog) * part) >> 5 & GLINT_APART, packed = mixed | mixed >> 16;
        *pixel = (uint16_t)(swaps ? glint_to_high_first(packed & 0xffff) : packed);
        depth++;
    }
}

/* Returns the pixel of the fog's colour at a place of a tile. */
static uint32_t fog_colour_at(const glint_fog_table *table, const glint_canvas *canvas, uint32_t offset) {
    const glint_format *const format = canvas->format;
    glint_lanes lanes = table->lanes;
    if (!format->is_dithered)
        return table->packed;
    glint_add_threshold(&lanes, glint_canvas_threshold(canvas, offset), format->channel[0], glint_green_bits(format));
    return glint_pack(format, lanes);
}

static void fade(const glint_frame *frame, const uint16_t *depth, void *pixels, const void *background, uint32_t first,
                 uint32_t end) {
    const glint_canvas canvas = glint_canvas_of(frame, pixels),
                       behind = glint_canvas_of(frame, (void *)(uintptr_t)background);
    const glint_fog_table *const table = frame->fog;
    if (canvas.format->bits == 16 && !canvas.format->is_dithered && !background) {
        fade_565(table, &canvas, depth, first, end);
        return;
    }
    for (; first < end; first++) {
        const uint32_t part = depth[first] ? GLINT_WHOLE - visible_in_frame(frame, depth[first]) : 0;
        if (part)
            glint_mix_pixel(&canvas, first,
                            background ? glint_read_pixel(&behind, first) : fog_colour_at(table, &canvas, first), part,
                            0);
    }
}

const glint_fog_type glint_fog_linear = {0, check_fog, prepare_fog, fade, visible_in_frame};
const glint_fog_type glint_fog_squared = {1, check_fog, prepare_fog, fade, visible_in_frame};
