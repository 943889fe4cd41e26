/* SPDX-License-Identifier: MIT */
/* Coverage. */
#include "proof.h"

#include "../../src/raster.c"
#include "contracts.h"

/* Corners in a tile, in sixteenths, of vertices within 1023 pixels of the screen's centre: screen and tile add 512. */
#define MOST_PLACE (16 * (1023 + 512))
#define MOST_SIDE (16 * 2 * 1023)

/* Stands on the quotient of C99 (6.5.5), which leaves less than b; suite `fill_rule`. */
/*@ requires b > 0 && \valid(remainder);
    assigns \result, *remainder \from a, b;
    ensures \initialized(remainder);
    admit ensures a / b - 1 <= \result <= a / b && 0 <= *remainder < b; */
static int32_t divide_floor(int32_t a, int32_t b, int32_t *remainder);

/*
 * Sides of any length, by parts of a quarter of its rows' bits, in tiles of up to 64 rows and columns.
 * @contract divide_floor
 * @options -eva-slevel 0 -eva-min-loop-unroll 65
 */
PROOF(walk_exactly) {
    glint_span spans[GLINT_TILE_MAX];
    FOR_PARTS(bits, 0, 13) {
        FOR_PARTS(quarter, bits < 2 ? 1 << bits : 4, bits < 2 ? (2 << bits) - 1 : 7) {
            const int32_t dy = (int32_t)(bits < 2 ? quarter : quarter << (bits - 2));
            const int32_t last = bits < 2 ? dy : dy + (1 << (bits - 2)) - 1;
            edge e;
            begin_exactly(&e, ANY(-MOST_PLACE, MOST_PLACE), ANY(-MOST_SIDE, MOST_SIDE), ANY(dy, last),
                          ANY(0, MOST_PLACE));
            walk(&e, &spans[0].left, ANY(1, GLINT_TILE_MAX), ANY(1, GLINT_TILE_MAX));
        }
    }
}

/*
 * Short sides in a tile, from its first row on, of every phase and by the bits of their heights, down and up.
 * @options -eva-slevel 10 -eva-min-loop-unroll 65
 */
PROOF(find_inside) {
    glint_part part;
    FOR_PARTS(phase, 0, 15) {
        FOR_PARTS(bits, 0, 8) {
            const int32_t least = 1 << bits, most = 2 * least - 1, y = (int32_t)phase - 15;
            glint_place upper = {ANY(-8, 16 * GLINT_TILE_MAX - 9), y, 0};
            glint_place lower = {ANY(-8, 16 * GLINT_TILE_MAX - 9), ANY(y + least, y + most), 0};
            lower.row = ANY((y + least + 15) >> 4, (y + most + 15) >> 4);
            find_inside(&part, &upper, &lower);
            find_inside(&part, &lower, &upper);
        }
    }
}

/* Stands on begin_exactly and walk, all that it does: walk_exactly. */
/*@ requires \valid_read(part) && \valid_read(s);
    requires 1 <= s->rows <= 64;
    assigns s->column[0 .. 2 * (s->rows - 1)] \from indirect: *part, indirect: *s; */
static void find_exactly(const glint_part *part, const side *s);

/* Sides from so many rows above a tile, the top from y to y + slack there, `least` to `most` below y + slack. */
static void find_from(int above, int y, int slack, int least, int most) {
    glint_part part;
    glint_place upper = {ANY(-MOST_PLACE, MOST_PLACE), ANY(y, y + slack), -above};
    glint_place lower = {ANY(-MOST_PLACE, MOST_PLACE), ANY(y + slack + least, y + slack + most), 0};
    lower.row = ANY((y + slack + least + 15) >> 4, (y + slack + most + 15) >> 4);
    part.window.width = ANY(1, GLINT_TILE_MAX);
    part.window.height = ANY(1, GLINT_TILE_MAX);
    find_side(&part, &upper, &lower);
    find_side(&part, &lower, &upper);
}

/*
 * Sides of up to 511 sixteenths from the first row of any tile or from above it, by how far and by parts of their
 * heights.
 * @contract find_exactly
 * @narrowing crossings beyond the tile are found modulo 2^32
 * @alarms 2 a crossing was just compared, as unsigned, with 65 2^20, and a slope is below 2^30: `fill_rule` under UBSan
 * @options -eva-slevel 10 -eva-min-loop-unroll 65
 */
PROOF(find_side) {
    FOR_PARTS(phase, 0, 15) {
        FOR_PARTS(bits, 0, 4) {
            find_from(0, (int)phase - 15, 0, 1 << bits, (2 << bits) - 1);
        }
    }
    FOR_PARTS(above, 0, 31) {
        for (int least = above ? 16 * (int)above + 2 : 17; least < 512; least += least / 2)
            find_from((int)above, -16 * (int)above - 15, 15, least, least + least / 2 - 1);
    }
}

/* Any spans of any rows. @options -eva-slevel 0 */
PROOF(has_pixels) {
    glint_part part;
    for (int i = 0; i < GLINT_TILE_MAX; i++) {
        part.spans[i].left = (uint8_t)ANY(0, GLINT_TILE_MAX);
        part.spans[i].right = (uint8_t)ANY(0, GLINT_TILE_MAX);
    }
    FOR_PARTS(bottom, 1, GLINT_TILE_MAX) {
        part.bottom = (uint32_t)bottom;
        part.top = ANY_UNSIGNED(0, part.bottom - 1);
        has_pixels(&part);
    }
}
