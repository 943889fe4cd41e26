/* SPDX-License-Identifier: MIT */
/**
 * @file ranges.h
 * What stages hand to each other, over the whole of the ranges that the headers state.
 */
#ifndef GLINT_RANGES_H
#define GLINT_RANGES_H

#include "contracts.h"
#include "proof.h"

/* Twice the focal length in pixels, Q12: of one pixel under 170 degrees it is 358, of 1024 under 1 degree 4.8e8. */
#define ANY_FOCAL ANY(1 << 8, 1 << 29)

/* An axis of a camera is unit to 2^-9: no component above 1 + 2^-9, far below the 2 that are taken here. */
#define ANY_TURN ANY(-2 * GLINT_ONE, 2 * GLINT_ONE)

/* A camera's, without lights. */
static void any_view(glint_view *view) {
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            view->rotation[i][j] = ANY_TURN;
        view->eye[i] = ANY_INT;
    }
    view->focal = ANY_FOCAL;
    view->focal_mantissa = ANY(1 << 23, 1 << 24);
    view->focal_shift = ANY_UNSIGNED(18, 38);
    view->near_plane = ANY_LONG(1 << 12, (int64_t)INT32_MAX << 12);
    view->nearest = ANY_LONG(1 << 12, (int64_t)1 << 57);
    view->light_count = 0;
    view->local_viewer = (uint8_t)ANY(0, 1);
    view->has_positions = (uint8_t)ANY(0, 1);
    view->is_parallel = 0;
}

/* An object's, but for its rows of normals. */
static void any_transform(glint_transform *transform) {
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            glint_row_set(&transform->matrix[i], j, ANY(-0x2fffffff, 0x2fffffff));
        transform->translation[i] = ANY(-0x2fffffff, 0x2fffffff);
    }
    transform->exponent = ANY(1, 92);
    transform->near_plane = ANY(16, 1 << 30);
    transform->least_w = ANY(-0x30000000, 0x30000000);
    transform->nearest = ANY(0, 1 << 30);
    transform->center_x = ANY(1, GLINT_SIZE_MAX) * (8 << 11) + (1 << 10);
    transform->center_y = ANY(1, GLINT_SIZE_MAX) * (8 << 11) + (1 << 10);
    transform->visible = (uint8_t)ANY(0, 1);
    transform->clips = (uint8_t)ANY(0, 1);
    transform->mirrored = (uint8_t)ANY(0, 1);
}

#endif
