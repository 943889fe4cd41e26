/* SPDX-License-Identifier: MIT */
/* Layout: meshes whose attributes are stored in another way than in arrays of their own; linked with any type of one.
 */
#include "../geometry/layout.h"

#include "../light/evaluation.h"
#include "../pixel/format.h"
#include "cull.h"
#include "frame.h"

/* ---- Check ---- */

/* May an attribute be read for one use? */
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

/* Positions that are decoded at once. */
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

/* Puts the normals that are not known yet into an array of their own for as long as the triangle is lit: after that
 * they are. Until then no flag but that of clipping is set, and their numbers stand in attribute[0]. */
static void light_fetched(const glint_frame *frame, glint_draw *draw, const glint_transform *transform,
                          uint32_t triangle) {
    const glint_mesh_layout *layout = frame->scene->objects[draw->object].mesh->layout;
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
