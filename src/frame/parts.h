/* SPDX-License-Identifier: MIT */
/** @file parts.h Parts of objects: the triangles that some tiles may show, where not all vertices fit. */
#ifndef GLINT_PARTS_H
#define GLINT_PARTS_H

#include "cull.h"
#include "frame.h"

/**
 * The tiles that 2^frame->extent_shift triangles of a mesh, which follow each other, may show; right and bottom are
 * exclusive, and 255 is as far as there is.
 */
typedef struct glint_extent {
    uint8_t left, top, right, bottom;
} glint_extent;

/** The triangles of an object, one after the other. */
typedef struct glint_sight {
    glint_transform transform;
    glint_frame *frame;
    const glint_mesh *mesh;
    const uint16_t *(*corners)(glint_walk *walk, const glint_mesh *mesh, uint32_t triangle); /* or null: in its array */
    glint_walk walk;
    glint_vertex *seen;  /* vertices as they were seen last, by the low bits of their numbers */
    uint32_t seen_count; /* a power of two, or 0 */
    glint_vertex own[3]; /* of a triangle, where none are kept */
    glint_transform_some *bring;
    glint_position *position, clipped; /* where positions go, which nothing looks at; null where none may be clipped */
} glint_sight;

/** Where it stands: at the arena's high end, in what is kept for binning. */
static inline glint_sight *glint_sight_of(const glint_frame *frame) {
    return (glint_sight *)(void *)(frame->memory.base + frame->memory.high) - 1;
}

/** Bytes for vertices that were seen: no more than these, nor than are worth having. */
size_t glint_sight_size(size_t room);

/** Begins before the first triangle of an object whose transform is there, with that many bytes. */
void glint_sight_begin(glint_sight *sight, glint_frame *frame, const glint_object *object, void *memory, size_t size);

/**
 * Looks at a triangle of a number above the last one's.
 * @return its corners, and sets the tiles that it may show; null where there are none, or in case of GLINT_ERROR_INDEX
 */
const uint16_t *glint_sight_next(glint_sight *sight, uint32_t number, glint_range *tiles, glint_status *status);

/** Tiles that follow each other: from a row and a column to another, themselves too. */
typedef struct glint_strip {
    int32_t first_row, first_column, last_row, last_column;
} glint_strip;

/** The tiles from frame->tile_first to before `end`. */
void glint_strip_begin(glint_strip *strip, const glint_frame *frame, uint32_t end);

/** Is one of these tiles in a strip? */
int glint_is_in_strip(const glint_strip *strip, const glint_range *tiles);

/** Finds the extents of all objects, where there is room for them. */
glint_status glint_extents_find(glint_frame *frame);

/** May triangles of this extent, counted through all objects, show in a strip? */
int glint_extent_shows(const glint_frame *frame, const glint_strip *strip, uint32_t index);

/** Extents of a mesh of so many triangles. */
static inline uint32_t glint_extents_of(const glint_frame *frame, uint32_t triangles) {
    return (triangles + (1u << frame->extent_shift) - 1) >> frame->extent_shift;
}

/**
 * Loads what of the scene, from (frame->object, frame->triangle) on, the tiles from frame->tile_first on may show: of
 * as many tiles as frame->pass_tiles says and the arena has room for; or of one, as many triangles as it has room for.
 */
glint_status glint_load_parts(glint_frame *frame);

#endif
