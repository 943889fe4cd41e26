/* SPDX-License-Identifier: MIT */
/* Coverage. */
#include "proof.h"

#include "../../src/raster/raster.c"
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

/*@ requires \valid(part) && part->top < part->bottom <= GLINT_TILE_MAX;
    assigns \result, part->top \from *part;
    ensures part->top <= part->bottom; */
static inline int has_pixels(glint_part *part);

/*
 * Sides of any length, by parts of a quarter of its rows' bits, in tiles of up to 64 rows and columns.
 * @contract divide_floor
 * @unreached 1 what a library built for size does
 * @options -eva-slevel 0 -eva-min-loop-unroll 65
 */
PROOF(find_columns) {
    glint_span spans[GLINT_TILE_MAX];
    FOR_PARTS(bits, 0, 13) {
        FOR_PARTS(quarter, bits < 2 ? 1 << bits : 4, bits < 2 ? (2 << bits) - 1 : 7) {
            const int32_t dy = (int32_t)(bits < 2 ? quarter : quarter << (bits - 2));
            const int32_t last = bits < 2 ? dy : dy + (1 << (bits - 2)) - 1;
            find_columns(&spans[0].left, ANY(1, GLINT_TILE_MAX), ANY(1, GLINT_TILE_MAX), ANY(-MOST_PLACE, MOST_PLACE),
                         ANY(-MOST_SIDE, MOST_SIDE), ANY(dy, last), ANY(0, MOST_PLACE));
        }
    }
}

static int32_t any_place(int32_t y, int32_t most_y) {
    const int32_t x = X_BIAS - 16 * AROUND;
    const int32_t first = y * (1 << 16) + x, last = most_y * (1 << 16) + x + 0x7ff;
    return ANY(first, last);
}

/*
 * Short sides of every phase, from anywhere in a tile's columns or 32 beyond, by the bits of their heights.
 * @narrowing places and slopes take a shift to the left
 * @options -eva-slevel 10
 */
PROOF(begin_side) {
    FOR_PARTS(phase, 0, 15) {
        FOR_PARTS(bits, 0, 8) {
            const int32_t y = phase, least = 1 << bits, most = 2 * least - 1;
            begin_side(any_place(y, y), any_place(y + least, y + most));
        }
    }
}

/*
 * Any sides, down any number of rows.
 * @narrowing a crossing may lie anywhere beyond the tile below its last row
 * @options -eva-slevel 100
 */
PROOF(walk_sides) {
    glint_span spans[GLINT_SHORT_ROWS];
    FOR_PARTS(rows, 0, GLINT_SHORT_ROWS) {
        falling_side left = {ANY_INT, ANY_INT}, right = {ANY_INT, ANY_INT};
        walk_sides(&spans[0].left, rows, &left, &right);
    }
}

/* Any place less than 2047 pixels from its tile's, of any size. */
PROOF(find_cut) {
    glint_window window;
    FOR_PARTS(part, 0, 15) {
        const int32_t least = -(1 << 29) + part * (1 << 26), most = least + (1 << 26) - 1;
        corners p = {ANY(least, most), ANY(-(1 << 29), 1 << 29), ANY(-(1 << 29), 1 << 29)};
        window.width = ANY(1, GLINT_TILE_MAX);
        find_cut(&p, &window);
    }
}

/*
 * Any spans of any rows, cut on any side.
 * @contract has_pixels
 * @narrowing columns are kept modulo 256
 * @options -eva-slevel 70
 */
PROOF(cut_columns) {
    glint_part part;
    part.top = 0;
    part.window.width = ANY(1, GLINT_TILE_MAX);
    FOR_PARTS(bottom, 1, GLINT_TILE_MAX) {
        part.bottom = (uint32_t)bottom;
        for (int i = 0; i < GLINT_TILE_MAX; i++) {
            part.spans[i].left = (uint8_t)ANY(0, 255);
            part.spans[i].right = (uint8_t)ANY(0, 255);
        }
        cut_columns(&part, ANY_UNSIGNED(0, 7));
    }
}

/* Any spans of any rows. @options -eva-slevel 0 -eva-min-loop-unroll 65 */
PROOF(has_pixels) {
    glint_part part;
    for (int i = 0; i < GLINT_TILE_MAX; i++) {
        part.spans[i].left = (uint8_t)ANY(0, GLINT_TILE_MAX);
        part.spans[i].right = (uint8_t)ANY(0, GLINT_TILE_MAX);
    }
    FOR_PARTS(bottom, 1, GLINT_TILE_MAX) {
        FOR_PARTS(rows, 1, bottom) {
            part.bottom = (uint32_t)bottom;
            part.top = (uint32_t)(bottom - rows);
            has_pixels(&part);
        }
    }
}
