/* SPDX-License-Identifier: MIT */
/* Decodes meshes whose attributes are stored otherwise than in arrays of their own. It is linked with any type of such
 * an attribute. */
#include "../light/evaluation.h"
#include "../pixel/format.h"
#include "frame.h"

/* ---- Check ---- */

/* May an attribute be read for a use? */
static glint_status check_attribute(const glint_mesh_attribute *a, uint32_t use) {
    if (!a->type || !a->data)
        return GLINT_ERROR_NULL;
    if (!(a->type->uses & use))
        return GLINT_ERROR_TYPE;
    if (a->stride && a->stride < a->type->size)
        return GLINT_ERROR_STRIDE;
    const uintptr_t odd = ((uintptr_t)a->data | a->stride) & (a->type->alignment - 1u);
    return odd ? GLINT_ERROR_STRIDE : GLINT_OK;
}

static glint_status check_layout_of(const glint_mesh *mesh) {
    const glint_mesh_layout *layout = mesh->layout;
    glint_status status = mesh->positions ? GLINT_OK : check_attribute(&layout->positions, GLINT_OF_POSITIONS);
    if (status == GLINT_OK && !mesh->normals)
        status = check_attribute(&layout->normals, GLINT_OF_NORMALS);
    if (status == GLINT_OK && !mesh->triangles)
        status = check_attribute(&layout->triangles, GLINT_OF_TRIANGLES);
    if (status == GLINT_OK && layout->colours.type && !mesh->colours && !mesh->colours565)
        status = check_attribute(&layout->colours, GLINT_OF_COLOURS);
    return status;
}

/* ---- Positions ---- */

/* So many positions are decoded at once. */
#define FETCHED_AT_ONCE 8

static void transform_fetched(const glint_transform *transform, const glint_mesh *mesh, uint32_t first, uint32_t count,
                              glint_vertex *vertex, glint_position *position) {
    int16_t fetched[FETCHED_AT_ONCE][3];
    for (uint32_t done = 0, some; done < count; done += some) {
        some = count - done < FETCHED_AT_ONCE ? count - done : FETCHED_AT_ONCE;
        glint_fetch(&mesh->layout->positions, first + done, some, fetched);
        glint_transform_steps(transform, (const int16_t(*)[3])fetched, first + done, some, vertex + done,
                              position ? position + done : 0);
    }
}

/* ---- Normals ---- */

/* Puts the normals that are still in mesh space into an array of their own while the triangle is lit. Until then only
 * the flag of clipping may be set, and the numbers of vertices are in attribute[0]. */
static void light_fetched(const glint_frame *frame, glint_draw *draw, const glint_transform *transform,
                          uint32_t triangle) {
    const glint_mesh_layout *layout = glint_object_at(frame, draw->object)->mesh->layout;
    const uint16_t *const corners = draw->triangles[triangle];
    int16_t fetched[3][3];
    for (int corner = 0; corner < 3; corner++) {
        glint_vertex *vertex = &draw->vertices[corners[corner]];
        const int is_fetched =
            (corner > 0 && corners[corner] == corners[0]) || (corner > 1 && corners[2] == corners[1]);
        if (vertex->flags & ~GLINT_VERTEX_CLIP || is_fetched)
            continue;
        const uint32_t index = (uint16_t)vertex->attribute[0];
        glint_fetch(&layout->normals, index, 1, &fetched[corner]);
        vertex->attribute[0] = (int16_t)corner;
    }
    draw->normals = (const int16_t(*)[3])fetched;
    draw->evaluation->light(frame, draw, transform, triangle);
    draw->normals = 0;
}

/* ---- Triangles ---- */

static const uint16_t *corners_fetched(glint_walk *walk, const glint_mesh *mesh, uint32_t triangle) {
    glint_fetch(&mesh->layout->triangles, triangle, 1, (int16_t(*)[3])(void *)walk->fetched);
    return walk->fetched;
}

static const uint16_t (*list_fetched(glint_frame *frame, const glint_mesh *mesh))[3] {
    int16_t(*list)[3] = glint_take(&frame->memory, mesh->triangle_count * sizeof *list);
    glint_fetch(&mesh->layout->triangles, 0, mesh->triangle_count, list);
    return (const uint16_t(*)[3])(void *)list;
}

const glint_layout_stage glint_layouts = {check_layout_of, transform_fetched, light_fetched, corners_fetched,
                                          list_fetched};

/* ---- Types ---- */

/* Types of 16 bits are stored as the arrays of a mesh have them. */
static void fetch_words(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]) {
    for (uint32_t i = 0; i < count; i++, from += stride) {
        const int16_t *word = (const int16_t *)(const void *)from;
        for (int c = 0; c < 3; c++)
            to[i][c] = word[c];
    }
}

const glint_attribute_type glint_attribute_int16 = {GLINT_OF_POSITIONS | GLINT_OF_NORMALS, 6, 2, fetch_words,
                                                    &glint_layouts};
const glint_attribute_type glint_attribute_uint16 = {GLINT_OF_TRIANGLES, 6, 2, fetch_words, &glint_layouts};

/* Positions and normals of 8 bits are the high halves of 16. */
static void fetch_int8(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]) {
    for (uint32_t i = 0; i < count; i++, from += stride)
        for (int c = 0; c < 3; c++)
            to[i][c] = (int16_t)((int8_t)from[c] * 256);
}

const glint_attribute_type glint_attribute_int8 = {GLINT_OF_POSITIONS | GLINT_OF_NORMALS, 3, 1, fetch_int8,
                                                   &glint_layouts};

/* Triangles of meshes of up to 256 vertices have indices of 8 bits. */
static void fetch_uint8(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]) {
    for (uint32_t i = 0; i < count; i++, from += stride)
        for (int c = 0; c < 3; c++)
            to[i][c] = from[c];
}

const glint_attribute_type glint_attribute_uint8 = {GLINT_OF_TRIANGLES, 3, 1, fetch_uint8, &glint_layouts};

/* Colours of vertices have 8 bits a channel, or are RGB565. */
static void fetch888(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]) {
    for (uint32_t i = 0; i < count; i++, from += stride)
        for (int c = 0; c < 3; c++)
            to[i][c] = glint_channel_from8(from[c]);
}

static void fetch565(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]) {
    for (uint32_t i = 0; i < count; i++, from += stride)
        for (int c = 0; c < 3; c++)
            to[i][c] = glint_channel_from565(*(const uint16_t *)(const void *)from, c);
}

const glint_attribute_type glint_attribute_rgb888 = {GLINT_OF_COLOURS, 3, 1, fetch888, &glint_layouts};
const glint_attribute_type glint_attribute_rgb565 = {GLINT_OF_COLOURS, 2, 2, fetch565, &glint_layouts};

/* Normals are points of an octahedron that is folded onto a square (Meyer et al., 2010; Cigolle et al., 2014). */
/*
 * Decodes the normal of x and y, |x| + |y| + |z| = one, exactly. One is at most 32767, and values below -one count as
 * -one. Where z < 0 a coordinate is one less the other's magnitude, with its own sign: that is itself and z more or
 * less.
 */
static inline void unfold(int32_t x, int32_t y, int32_t one, int32_t scale, int16_t to[3]) {
    x = x < -one ? -one : x;
    y = y < -one ? -one : y;
    const int32_t z = one - (x < 0 ? -x : x) - (y < 0 ? -y : y);
    const int32_t folded = z < 0 ? z : 0;
    to[0] = (int16_t)((x < 0 ? x - folded : x + folded) * scale);
    to[1] = (int16_t)((y < 0 ? y - folded : y + folded) * scale);
    to[2] = (int16_t)(z * scale);
}

static void fetch8(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]) {
    for (uint32_t i = 0; i < count; i++, from += stride)
        unfold((int8_t)from[0], (int8_t)from[1], 127, 258, to[i]);
}

static void fetch16(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]) {
    for (uint32_t i = 0; i < count; i++, from += stride) {
        const int16_t *word = (const int16_t *)(const void *)from;
        unfold(word[0], word[1], 32767, 1, to[i]);
    }
}

const glint_attribute_type glint_attribute_octahedral8 = {GLINT_OF_NORMALS, 2, 1, fetch8, &glint_layouts};
const glint_attribute_type glint_attribute_octahedral16 = {GLINT_OF_NORMALS, 4, 2, fetch16, &glint_layouts};
