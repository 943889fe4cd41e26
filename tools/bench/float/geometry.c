/* SPDX-License-Identifier: MIT */
/* Vertices to the screen, snapped to sixteenths of a pixel. */
#include "draw.h"
#include "number.h"

/* A vertex of an object in the guard band lies no further from the screen's centre than so many sixteenths: sides fit
 * 15 bits then, and their products 31. */
#define GUARD 16000

/* Moves what is rounded above 0, where the whole part is the floor: more than the guard band, and a half. */
#define ABOVE 16384

/* The first row at or below a vertex; kept on the screen where `height` is not 0: then edges begin there. */
static inline void put_row(float_vertex *vertex, int32_t y, int32_t height) {
    const int32_t row = (y + 7) >> 4;

    vertex->row = !height ? row : row < 0 ? 0 : row > height ? height : row;
    vertex->step = (float)vertex->row - (vertex->y - 0.5f);
}

static inline float_triple transform(const float_matrix *matrix, float_triple p) {
    return triple(dot(matrix->row[0], p) + matrix->translation.x, dot(matrix->row[1], p) + matrix->translation.y,
                  dot(matrix->row[2], p) + matrix->translation.z);
}

float_triple float_place_of(const float_draw *draw, uint32_t index) {
    return transform(&draw->place, triple_of(draw->object->mesh->positions[index]));
}

static inline __attribute__((always_inline)) void transform_all(const float_draw *draw, int32_t height) {
    const float_screen *screen = draw->frame->screen;
    const int16_t(*position)[3] = draw->object->mesh->positions;
    const float_triple sx = draw->screen_x, sy = draw->screen_y, sz = draw->place.row[2];
    const float tx = draw->screen_tx, ty = draw->screen_ty, tz = draw->place.translation.z;
    const float middle_x = 8 * (float)screen->width + ABOVE + 0.5f, middle_y = 8 * (float)screen->height + ABOVE + 0.5f;
    const float column = FLOAT_COLUMN - ABOVE * (1.0f / 16);
    float_vertex *vertex = draw->frame->memory->vertices;
    const float_vertex *const end = vertex + draw->object->mesh->vertex_count;
    uint32_t *packed = draw->frame->memory->packed;

    for (; vertex < end; vertex++, position++) {
        const float_triple p = triple_of(*position);
        const float inverse_w = -1 / (dot(sz, p) + tz);
        const int32_t x = (int32_t)((dot(sx, p) + tx) * inverse_w + middle_x);
        const int32_t y = (int32_t)((dot(sy, p) + ty) * inverse_w + middle_y) - ABOVE;

        vertex->x = (float)x * (1.0f / 16) + column;
        vertex->y = (float)y * (1.0f / 16);
        vertex->inverse_w = inverse_w;
        put_row(vertex, y, height);
        *packed++ = (uint32_t)y << 16 | (uint16_t)(x - ABOVE);
    }
}

/* ---- Anywhere ---- */

void float_project(const float_frame *frame, const float_triple *place, float_vertex *vertex) {
    const float inverse_w = -1 / place->z, pixels = 16 * frame->focal * inverse_w;
    const float most = 1 << 27;
    const float x = place->x * pixels + 8 * (float)frame->screen->width + 0.5f,
                y = place->y * -pixels + 8 * (float)frame->screen->height + 0.5f;
    /* The floor, by way of numbers above 0. */
    const int32_t left = x > -most && x < most ? (int32_t)(x + 4096) - 4096 - (x < -4096)
                         : x < 0               ? -(1 << 27)
                                               : 1 << 27;
    const int32_t top = y > -most && y < most ? (int32_t)(y + 4096) - 4096 - (y < -4096) : y < 0 ? -(1 << 27) : 1 << 27;

    vertex->x = (float)left * (1.0f / 16) + FLOAT_COLUMN;
    vertex->y = (float)top * (1.0f / 16);
    vertex->inverse_w = inverse_w;
    put_row(vertex, top, (int32_t)frame->screen->height);
}

static void transform_anywhere(const float_draw *draw) {
    const float_frame *frame = draw->frame;
    float_vertex *vertices = frame->memory->vertices;
    const uint32_t count = draw->object->mesh->vertex_count;

    for (uint32_t i = 0; i < count; i++) {
        const float_triple place = float_place_of(draw, i);

        if (-place.z >= frame->near_plane) {
            float_project(frame, &place, &vertices[i]);
        } else {
            vertices[i].inverse_w = 0;
        }
    }
}

void float_transform(const float_draw *draw, float_whereabouts where) {
    if (where == FLOAT_ON_SCREEN) {
        transform_all(draw, 0);
    } else if (where == FLOAT_IN_GUARD_BAND) {
        transform_all(draw, (int32_t)draw->frame->screen->height);
    } else {
        transform_anywhere(draw);
    }
}

/* ---- Where an object is ---- */

/* Sides of the view that a point lies beyond, a bit each: near, left, right, top, bottom; and whether it leaves the
 * guard band. */
static uint32_t sides(const float_draw *draw, float_triple corner) {
    const float_screen *screen = draw->frame->screen;
    const float w = -(dot(draw->place.row[2], corner) + draw->place.translation.z);
    const float x = dot(draw->screen_x, corner) + draw->screen_tx, y = dot(draw->screen_y, corner) + draw->screen_ty;
    const float half_width = 8 * (float)screen->width * w, half_height = 8 * (float)screen->height * w;
    const float guard = (GUARD - 1) * w;
    const uint32_t leaves = x > guard || x < -guard || y > guard || y < -guard;

    return (w < draw->frame->near_plane ? 1u : 0) | (x < -half_width ? 2u : 0) | (x > half_width ? 4u : 0) |
           (y < -half_height ? 8u : 0) | (y > half_height ? 16u : 0) | leaves << 5;
}

float_whereabouts float_locate(const float_draw *draw) {
    uint32_t any = 0, all = 31;

    for (int i = 0; i < 8; i++) {
        const float steps = 32768;
        const uint32_t beyond =
            sides(draw, triple(i & 1 ? steps : -steps, i & 2 ? steps : -steps, i & 4 ? steps : -steps));
        any |= beyond;
        all &= beyond;
    }
    return all ? FLOAT_OUTSIDE : any & 33 ? FLOAT_ANYWHERE : any ? FLOAT_IN_GUARD_BAND : FLOAT_ON_SCREEN;
}
