/* SPDX-License-Identifier: MIT */
/* Normals to camera space. */
#include "proof.h"

#include "../../src/geometry/geometry.h"
#include "../../src/math/product.h"

/* A row of the normals' matrix, whose magnitudes sum up to 3 2^28 as well, and half a step on top. */
/* Stands on scale_normals, by which the squares of all entries sum up to at most 3 2^56: `numbers` tries a million
 * transforms. */
/*@ requires \valid_read(row);
    requires -0x8000 <= x <= 0x7fff && -0x8000 <= y <= 0x7fff && -0x8000 <= z <= 0x7fff;
    requires t == 0x1000;
    assigns \result \from *row, x, y, z, t;
    admit ensures -0x2ffff000 <= \result <= 0x30001000; */
static int32_t turned_normal(const glint_row *row, int32_t x, int32_t y, int32_t z, int32_t t);

#undef glint_row_times
#define glint_row_times turned_normal
#include "../../src/geometry/geometry.c"
#include "contracts.h"

/*
 * Any number of a vertex, any normal, any matrix. @contract turned_normal glint_unit
 * @narrowing a sum of squares of at most 16383^2 has no component above 16383, and x is below twice that and one more
 */
PROOF(glint_transform_normal) {
    static int16_t normals[65536][3];
    static glint_draw draw;
    glint_vertex vertex;
    Frama_C_make_unknown((char *)normals, sizeof normals);
    Frama_C_make_unknown((char *)draw.transform.normal, sizeof draw.transform.normal);
    draw.normals = (const int16_t(*)[3])normals;
    vertex.flags = (uint16_t)ANY(0, UINT16_MAX);
    vertex.attribute[0] = ANY_SHORT;
    glint_transform_normal(&draw, &vertex);
}
