/* SPDX-License-Identifier: MIT */
/* Clipping. */
#include "proof.h"

#include "../../src/geometry/clip.c"
#include "contracts.h"

#define MOST (1 << 30)

/* Stands on inside <= inside - outside, both known to be at most 2^31: a quotient of at most 1. */
/*@ requires 0 <= inside <= 0x80000000;
    requires -0x80000000 <= outside < 0;
    assigns \result \from inside, outside;
    admit ensures 0 <= \result <= 0x80000000; */
static int64_t crossing(int64_t inside, int64_t outside);

static glint_corner any_corner(void) {
    glint_corner corner;
    corner.position.x = ANY(-MOST, MOST);
    corner.position.y = ANY(-MOST, MOST);
    corner.position.w = ANY(-MOST, MOST);
    for (int i = 0; i < 6; i++)
        corner.attribute[i] = ANY(-32767, 32767);
    return corner;
}

/* Distances of up to 2^31 on both sides. */
PROOF(crossing_itself) {
    crossing(ANY_LONG(0, 1LL << 31), ANY_LONG(-(1LL << 31), -1));
}

/* A near plane, and the w of parallel rays. */
static glint_transform any_planes(void) {
    glint_transform transform;
    transform.near_plane = ANY(16, MOST);
    transform.nearest = ANY(1, MOST);
    transform.clips = (uint8_t)ANY(0, 3);
    return transform;
}

/* A position of up to 2^30, every plane, a near plane of 16 to 2^30; any w of parallel rays. */
PROOF(distance) {
    const glint_corner corner = any_corner();
    const glint_transform transform = any_planes();
    FOR_PARTS(plane, 0, PLANES - 1) {
        distance(&transform, &corner.position, plane);
    }
}

/*
 * Corners of up to 2^30, attributes of 16 bits, at any crossing. @contract crossing
 * @narrowing a mean of two numbers lies between them
 */
PROOF(cut) {
    const glint_corner from = any_corner(), to = any_corner();
    glint_corner out;
    cut(&from, &to, ANY_LONG(0, 1LL << 31), ANY_LONG(-(1LL << 31), -1), &out);
}

/* Any position of 31 bits, a near plane of 16 to 2^30; any w of parallel rays. */
PROOF(keep_inside) {
    glint_position position = {ANY_INT, ANY_INT, ANY_INT};
    const glint_transform transform = any_planes();
    keep_inside(&transform, &position);
}
