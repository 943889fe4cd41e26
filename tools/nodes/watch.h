/* SPDX-License-Identifier: MIT */
/**
 * @file watch.h
 * How the library lit a scene: of every pixel in which way, and where the nodes lie. Calls from one of its files to
 * another are watched, which the linker leads through here (--wrap); what they do is the library's own.
 */
#ifndef GLINT_NODES_WATCH_H
#define GLINT_NODES_WATCH_H

#include "picture.h"

/** How a pixel was lit; what shows of it is `way_names`, in nodes.c. */
typedef enum way {
    WAY_NONE, /* background */
    WAY_FAST,
    WAY_EVEN, /* one colour: no light reaches the object */
    WAY_PLANES,
    WAY_QUADRATICS,
    WAY_OVER_LENGTH,
    WAY_PIECES,
    WAY_SQUARES_16,
    WAY_SQUARES_8,
    WAY_SQUARES_4,
    WAY_ONE_BY_ONE,
    WAYS
} way;

/** A point of the screen, sixteenths of a pixel. */
typedef struct node_place {
    int x, y;
} node_place;

/** Most nodes of an area. */
#define WATCH_NODES 9

/** Most areas of a picture. */
#define WATCH_AREAS_MAX (1 << 17)

/** A triangle's part in a tile, a piece of a triangle or a square of the lattice; and what polynomials go through. */
typedef struct lit_area {
    node_place corners[3]; /* of the piece, else of the triangle */
    node_place nodes[WATCH_NODES];
    int node_count, size; /* pixels of a square across; 0 for a triangle or a piece */
} lit_area;

/** What was seen of a picture. */
typedef struct watched {
    picture image;
    uint8_t *ways; /* a `way` a pixel */
    int *owners;   /* of each pixel: the number of the area it is lit in, -1 for none */
    lit_area *areas;
    int area_count;
} watched;

/** Draws a variant of an example scene; ends the program where there is none. Free with watch_close. */
watched watch(const char *scene, const char *variant, const glint_format *format);

void watch_close(watched *seen);

#endif
