/* SPDX-License-Identifier: MIT */
/**
 * @file glint_layout.h
 * Layouts of a mesh: attributes in fewer bits than its arrays have, or in structs of the caller's. Firmware that names
 * no type of these has no code for them. glint.h includes this.
 */
#ifndef GLINT_LAYOUT_H
#define GLINT_LAYOUT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How an attribute is stored: a descriptor, one of those below. Numbers are the machine's own. */
typedef struct glint_attribute_type glint_attribute_type;

/** Positions: three int16, steps. Normals: three int16, any length but 0. 6 bytes, aligned to 2. */
extern const glint_attribute_type glint_attribute_int16;

/** Positions: three int8, each 256 steps. Normals: three int8, any length but 0. 3 bytes. */
extern const glint_attribute_type glint_attribute_int8;

/**
 * Normals: x and y of the octahedron |x| + |y| + |z| = 1, whose half with z < 0 is folded outwards onto a square (Meyer
 * et al., 2010; Cigolle et al., 2014). Two int16, 32767 for 1, -32768 as -32767: 4 bytes, aligned to 2. They are
 * decoded exactly, but for the length; no direction is more than 0.0025 degrees from the nearest one stored.
 */
extern const glint_attribute_type glint_attribute_octahedral16;

/** The same: two int8, 127 for 1, -128 as -127. 2 bytes; no direction is more than 0.64 degrees from the nearest. */
extern const glint_attribute_type glint_attribute_octahedral8;

/** Triangles: three uint16, 6 bytes, aligned to 2; and three uint8, 3 bytes: for up to 256 vertices. */
extern const glint_attribute_type glint_attribute_uint16, glint_attribute_uint8;

/** Colours: red, green, blue times 255, 3 bytes; and RGB565, 2 bytes, aligned to 2. */
extern const glint_attribute_type glint_attribute_rgb888, glint_attribute_rgb565;

/** Where an attribute of a mesh is stored. */
typedef struct glint_mesh_attribute {
    const glint_attribute_type *type; /**< Null for none. */
    const void *data;                 /**< The first vertex's, or triangle's. */
    uint32_t stride;                  /**< Bytes from one to the next; 0: one follows the other. */
} glint_mesh_attribute;

/**
 * Attributes in place of those arrays of a mesh that are null. Positions, normals and colours are decoded as they are
 * needed; triangles take 6 bytes of arena each while their mesh is drawn whole. Owned by the caller, as arrays are.
 */
typedef struct glint_mesh_layout {
    glint_mesh_attribute positions; /**< glint_attribute_int16 or _int8. */
    glint_mesh_attribute normals;   /**< glint_attribute_int16, _int8, _octahedral8 or _octahedral16. */
    glint_mesh_attribute triangles; /**< glint_attribute_uint16 or _uint8. */
    glint_mesh_attribute colours;   /**< glint_attribute_rgb888 or _rgb565; used where both arrays of colours are
                                         null. */
} glint_mesh_layout;

#ifdef __cplusplus
}
#endif

#endif
