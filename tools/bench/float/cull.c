/* SPDX-License-Identifier: MIT */
/* Which triangles face the right way and hold the centre of a pixel. */
#include "draw.h"
#include "number.h"

/* ---- Two numbers of 16 bits in a word ---- */

#if defined __ARM_FEATURE_SIMD32

#include <arm_acle.h>

static inline uint32_t pair_difference(uint32_t a, uint32_t b) {
    return (uint32_t)__ssub16((int16x2_t)a, (int16x2_t)b);
}

static inline int32_t pair_area(uint32_t a, uint32_t b) {
    return __smusdx((int16x2_t)a, (int16x2_t)b);
}

/* The smaller and the larger halves. */
static inline void pair_order(uint32_t a, uint32_t b, uint32_t *small, uint32_t *large) {
    (void)__ssub16((int16x2_t)a, (int16x2_t)b);
    *small = (uint32_t)__sel((uint8x4_t)b, (uint8x4_t)a);
    *large = (uint32_t)__sel((uint8x4_t)a, (uint8x4_t)b);
}

#else

static inline int32_t low_of(uint32_t pair) {
    return (int16_t)(uint16_t)pair;
}

static inline int32_t high_of(uint32_t pair) {
    return (int16_t)(uint16_t)(pair >> 16);
}

static inline uint32_t pair_of(int32_t low, int32_t high) {
    return (uint32_t)high << 16 | (uint16_t)low;
}

static inline uint32_t pair_difference(uint32_t a, uint32_t b) {
    return pair_of(low_of(a) - low_of(b), high_of(a) - high_of(b));
}

static inline int32_t pair_area(uint32_t a, uint32_t b) {
    return low_of(a) * high_of(b) - high_of(a) * low_of(b);
}

static inline void pair_order(uint32_t a, uint32_t b, uint32_t *small, uint32_t *large) {
    const int low = low_of(a) < low_of(b), high = high_of(a) < high_of(b);

    *small = pair_of(low_of(low ? a : b), high_of(high ? a : b));
    *large = pair_of(low_of(low ? b : a), high_of(high ? b : a));
}

#endif

/* Between the centres of two columns or two rows. Sums stay in their halves: the guard band leaves room. */
static inline int holds_no_centre(uint32_t a, uint32_t b, uint32_t c) {
    uint32_t least, most, middle, unused;

    pair_order(a, b, &least, &most);
    pair_order(least, c, &least, &middle);
    pair_order(most, middle, &unused, &most);
    const uint32_t first = least + 0x00070007u, end = most + 0x00070007u;
    const uint32_t differ = (first ^ end) & 0xfff0fff0u;
    return differ < 0x10000u || (differ & 0xffffu) == 0;
}

/* Adds a triangle. Its corners are read before: what is written here may be anything to the compiler. */
static inline void list(float_triangle *triangle, uint8_t *used, uint32_t a, uint32_t b, uint32_t c, uint32_t source) {
    triangle->corner[0] = (uint16_t)a;
    triangle->corner[1] = (uint16_t)b;
    triangle->corner[2] = (uint16_t)c;
    triangle->source = (uint16_t)source;
    used[a] = used[b] = used[c] = 1;
}

static void forget_uses(float_draw *draw) {
    uint32_t *const words = (uint32_t *)(void *)draw->frame->memory->used;
    const uint32_t count = (draw->object->mesh->vertex_count + 3) / 4;

    for (uint32_t i = 0; i < count; i++) {
        words[i] = 0;
    }
    draw->vertex_end = draw->object->mesh->vertex_count;
}

static void cull_packed(float_draw *draw) {
    float_memory *memory = draw->frame->memory;
    const uint16_t(*corner)[3] = draw->object->mesh->triangles;
    const uint32_t count = draw->object->mesh->triangle_count;
    const uint32_t *packed = memory->packed;
    uint8_t *used = memory->used;
    float_triangle *triangle = memory->triangles;
    const int32_t front = draw->front;

    forget_uses(draw);
    for (uint32_t i = 0; i < count; i++, corner++) {
        const uint32_t first = (*corner)[0], second = (*corner)[1], third = (*corner)[2];
        const uint32_t a = packed[first], b = packed[second], c = packed[third];

        if (pair_area(pair_difference(b, a), pair_difference(c, a)) * front > 0 && !holds_no_centre(a, b, c)) {
            list(triangle++, used, first, second, third, i);
        }
    }
    draw->count = (uint32_t)(triangle - memory->triangles);
}

/* ---- Anywhere ---- */

static float area_of(const float_vertex *a, const float_vertex *b, const float_vertex *c) {
    return (b->x - a->x) * (c->y - a->y) - (c->x - a->x) * (b->y - a->y);
}

static void cull_anywhere(float_draw *draw) {
    const glint_mesh *mesh = draw->object->mesh;
    const float_vertex *vertices = draw->frame->memory->vertices;

    forget_uses(draw);
    draw->count = 0;
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        const uint16_t *corner = mesh->triangles[i];
        const float_vertex *a = &vertices[corner[0]], *b = &vertices[corner[1]], *c = &vertices[corner[2]];

        if (a->inverse_w == 0 || b->inverse_w == 0 || c->inverse_w == 0) {
            float_clip(draw, i);
        } else if (area_of(a, b, c) * (float)draw->front > 0 && draw->count < FLOAT_TRIANGLES_MAX) {
            list(&draw->frame->memory->triangles[draw->count++], draw->frame->memory->used, corner[0], corner[1],
                 corner[2], i);
        }
    }
}

void float_cull(float_draw *draw, float_whereabouts where) {
    if (where == FLOAT_ANYWHERE) {
        cull_anywhere(draw);
    } else {
        cull_packed(draw);
    }
}

/* ---- The near plane ---- */

/* A corner before it is divided by w. */
typedef struct corner {
    float_triple place;
    float_attributes at;
} corner;

static corner corner_of(const float_draw *draw, uint32_t index) {
    corner result = {.place = float_place_of(draw, index)};

    result.at = float_attributes_of(draw, index, &result.place);
    return result;
}

/* From the inner to the outer end, so that triangles that share an edge cut it alike. */
static corner cut(const corner *in, const corner *out, float near_plane) {
    const float t = (-in->place.z - near_plane) / (out->place.z - in->place.z);
    corner result = {
        sum_scaled(in->place, difference(out->place, in->place), t),
        {sum_scaled(in->at.attribute, difference(out->at.attribute, in->at.attribute), t),
         sum_scaled(in->at.colour, difference(out->at.colour, in->at.colour), t)},
    };

    result.place.z = -near_plane;
    return result;
}

/* Sutherland and Hodgman, 1974. @return how many corners are left. */
static uint32_t keep_beyond(const corner corners[3], float near_plane, corner kept[4]) {
    uint32_t count = 0;

    for (int i = 0; i < 3; i++) {
        const corner *from = &corners[i], *to = &corners[(i + 1) % 3];
        const int from_in = -from->place.z >= near_plane, to_in = -to->place.z >= near_plane;

        if (from_in) {
            kept[count++] = *from;
        }
        if (from_in != to_in) {
            kept[count++] = from_in ? cut(from, to, near_plane) : cut(to, from, near_plane);
        }
    }
    return count;
}

/* Puts a corner behind the mesh's vertices. */
static void add_vertex(float_draw *draw, const corner *from) {
    float_memory *memory = draw->frame->memory;
    float_vertex *vertex = &memory->vertices[draw->vertex_end];

    float_project(draw->frame, &from->place, vertex);
    vertex->attribute = scaled(from->at.attribute, vertex->inverse_w);
    memory->colours[draw->vertex_end++] = scaled(from->at.colour, vertex->inverse_w);
}

void float_clip(float_draw *draw, uint32_t triangle) {
    const uint16_t *indices = draw->object->mesh->triangles[triangle];
    const uint32_t first = draw->vertex_end;
    float_memory *memory = draw->frame->memory;
    const float_vertex *vertices = &memory->vertices[first];
    corner corners[3], kept[4];

    if (first + 4 > FLOAT_VERTICES_MAX || draw->count + 2 > FLOAT_TRIANGLES_MAX) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        corners[i] = corner_of(draw, indices[i]);
    }
    const uint32_t count = keep_beyond(corners, draw->frame->near_plane, kept);
    for (uint32_t i = 0; i < count; i++) {
        add_vertex(draw, &kept[i]);
    }
    for (uint32_t i = 2; i < count; i++) {
        if (area_of(&vertices[0], &vertices[i - 1], &vertices[i]) * (float)draw->front > 0) {
            list(&memory->triangles[draw->count++], memory->used, first, first + i - 1, first + i, triangle);
        }
    }
}
