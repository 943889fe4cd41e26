/* SPDX-License-Identifier: MIT */
/* Orthographic projection. @link geometry/transform.c */
#include "proof.h"

#include "../../src/scene/orthographic.c"
#include "ranges.h"

/* Distances, Q28: from the least near plane to the farthest corner of any object's bounding box. */
#define NEAR_LEAST (1 << 12)
#define FAR_MOST ((int64_t)1 << 57)

/* The guard band's width, Q28, as find_same_w has it. */
#define W_LEAST ((int64_t)1 << 19)
#define W_MOST ((int64_t)1 << 54)

/*@ requires \valid_read(view);
    requires 0x80000 <= view->nearest <= 0x40000000000000;
    requires 0 <= distance <= 0x400000000000000;
    assigns \result \from *view, distance;
    ensures 0 <= \result <= 0x48000000; */
static int32_t to_ray(const glint_view *view, int64_t distance);

/*@ requires \valid_read(view);
    requires -0x1000000000000000 <= w <= 0x1000000000000000;
    assigns \result \from *view, w;
    ensures -0x8000010000 <= \result <= 0x8000010000; */
static int64_t depth_of_w(const glint_view *view, int64_t w);

static glint_whole_view whole;

/* What set_range leaves behind the lights. */
static void any_depths(uint32_t lights) {
    any_view(&whole.view);
    whole.view.light_count = lights;
    whole.view.nearest = ANY_LONG(W_LEAST, W_MOST);
    glint_depth_range *const range = range_of(&whole.view);
    const int64_t farthest = ANY_LONG(NEAR_LEAST, FAR_MOST);
    range->far_low = (uint32_t)farthest;
    range->far_high = (uint32_t)(farthest >> 32);
    range->scale = ANY_UNSIGNED(1u << 30, 1u << 31);
    range->shift = ANY(-30, 27);
    range->far_ray = ANY(0, 0x48005000);
    range->range_ray = ANY(0, 0x48000000);
}

/* Any height. */
PROOF(is_valid_view) {
    const glint_camera camera = {.view_height = ANY_INT};
    is_valid_view(&camera);
}

/* Any valid height, screens of each height: from 2^19 to 2^54. */
PROOF(find_same_w) {
    FOR_PARTS(height, 1, GLINT_SIZE_MAX) {
        const glint_config config = {.height = (uint16_t)height};
        const glint_camera camera = {.view_height = ANY(LEAST_HEIGHT, INT32_MAX)};
        const int64_t w = find_same_w(&config, &camera);
        //@ assert 0x80000 <= w <= 0x40000000000000;
    }
}

/* Any distance beside any w, above 2^26 by 8 parts of each number of bits. */
PROOF(to_ray) {
    glint_view view;
    view.nearest = ANY_LONG(W_LEAST, W_MOST);
    to_ray(&view, ANY_LONG(0, 1 << 26));
    FOR_PARTS(bits, 27, 58) {
        FOR_PARTS(part, 8, 15) {
            const int64_t least = (int64_t)part << (bits - 4);
            to_ray(&view, ANY_LONG(least, least + ((int64_t)1 << (bits - 4)) - 1));
        }
    }
}

/*
 * Any range by its bits, from the least near plane on; behind any number of lights. @contract to_ray
 * @unreached 1 leading zeros of 0
 */
PROOF(set_range) {
    FOR_PARTS(lights, 0, GLINT_LIGHTS_MAX) {
        any_view(&whole.view);
        whole.view.light_count = (uint32_t)lights;
        whole.view.nearest = ANY_LONG(W_LEAST, W_MOST);
        FOR_PARTS(bits, 0, 57) {
            const int64_t range = bits ? ANY_LONG((int64_t)1 << (bits - 1), ((int64_t)1 << bits) - 1) : 0;
            set_range(&whole.view, NEAR_LEAST, NEAR_LEAST + range);
            const glint_depth_range *const to = range_of(&whole.view);
            //@ assert 0x40000000 <= to->scale <= 0x80000000;
            //@ assert -30 <= to->shift <= 27;
            //@ assert 0 <= to->far_ray <= 0x48005000;
            //@ assert 0 <= to->range_ray <= 0x48000000;
        }
    }
}

/* Any range of depths, any distance of 60 bits and a sign. @unreached 1 a shift to the left by 31 */
PROOF(depth_of_w) {
    FOR_PARTS(lights, 0, GLINT_LIGHTS_MAX) {
        any_depths((uint32_t)lights);
        depth_of_w(&whole.view, ANY_LONG(-((int64_t)1 << 60), (int64_t)1 << 60));
    }
}

/* Any vertices, some of which are clipped, of exponents up to 45, beyond which nothing is seen. @contract depth_of_w */
PROOF(finish_depths) {
    glint_vertex vertices[2];
    glint_transform transform;
    any_depths(0);
    any_transform(&transform);
    for (int i = 0; i < 2; i++) {
        vertices[i].inverse_w = ANY(-0x30000000, 0x30000000);
        vertices[i].flags = (uint16_t)ANY(0, UINT16_MAX);
    }
    FOR_PARTS(exponent, 1, 45) {
        glint_vertex now[2] = {vertices[0], vertices[1]};
        transform.exponent = exponent;
        finish_depths(&whole.view, &transform, now, 2);
    }
}

/* Fragments of any depth, any range of depths. */
PROOF(place_fragments) {
    glint_fragments fragments;
    glint_frame frame;
    any_depths(0);
    frame.view = &whole.view;
    FOR_PARTS(count, 1, GLINT_FRAGMENTS_MAX) {
        fragments.count = (uint32_t)count;
        for (int i = 0; i < count; i++)
            fragments.inverse_w[i] = ANY(0, INT32_MAX);
        place_fragments(&frame, &fragments);
    }
}
