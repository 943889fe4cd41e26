/* SPDX-License-Identifier: MIT */
/* Generates surfaces of revolution, the plane and the box, with normals from their formulas. */
#include "../glint_extras.h"
#include "../math/numeric.h"

/* This is 1 in Q30. */
#define ONE (1 << 30)
#define SIZE_MAX_Q16 (8192 * GLINT_ONE)

/* A builder writes a mesh. It goes on counting where the room ends. */
typedef struct builder {
    const glint_mesh_room *room;
    uint32_t vertices, triangles;
} builder;

/* A point of a profile has a distance from the axis, a height, both in units of the mesh's extent, and a normal;
 * Q30. */
typedef struct profile_point {
    int32_t radius, z, normal_radius, normal_z;
} profile_point;

static int32_t multiply(int32_t a, int32_t b) {
    return (int32_t)glint_round_shift64((int64_t)a * b, 30);
}

static int16_t step_of(int32_t value) {
    return (int16_t)glint_round_shift64((int64_t)value * 32767, 30);
}

static void add_vertex(builder *b, const int32_t position[3], const int32_t normal[3]) {
    if (b->vertices < b->room->vertex_room) {
        for (int i = 0; i < 3; i++) {
            b->room->positions[b->vertices][i] = step_of(position[i]);
            b->room->normals[b->vertices][i] = step_of(normal[i]);
        }
    }
    b->vertices++;
}

static void add_triangle(builder *b, uint32_t i, uint32_t j, uint32_t k) {
    if (b->triangles < b->room->triangle_room) {
        uint16_t *triangle = b->room->triangles[b->triangles];
        triangle[0] = (uint16_t)i;
        triangle[1] = (uint16_t)j;
        triangle[2] = (uint16_t)k;
    }
    b->triangles++;
}

/* Returns the phase of step i of n around the axis. */
static uint32_t phase_of(uint32_t i, uint32_t n) {
    return (uint32_t)((((uint64_t)i << 32) + n / 2) / n);
}

static void add_turned(builder *b, const profile_point *p, uint32_t phase) {
    int32_t sine = glint_sine(phase), cosine = glint_sine(phase + 0x40000000u);
    const int32_t position[3] = {multiply(p->radius, cosine), multiply(p->radius, sine), p->z};
    const int32_t normal[3] = {multiply(p->normal_radius, cosine), multiply(p->normal_radius, sine), p->normal_z};
    add_vertex(b, position, normal);
}

static void add_on_axis(builder *b, int32_t z, int32_t normal_z) {
    const int32_t position[3] = {0, 0, z}, normal[3] = {0, 0, normal_z};
    add_vertex(b, position, normal);
}

/* Sets the mesh up, or only its counts where the room is too small. Extents are those of 32768 steps, where sizes are
 * those of 32767. */
static glint_status finish(const builder *b, glint_mesh *mesh, glint_q16 x, glint_q16 y, glint_q16 z) {
    const glint_mesh_room *room = b->room;
    const int64_t size[3] = {x, y, z};
    glint_q16 extent[3];
    for (int i = 0; i < 3; i++)
        extent[i] = (glint_q16)((size[i] * 65536 + 32767) / 65534);
    mesh->vertex_count = b->vertices;
    mesh->triangle_count = b->triangles;
    if (b->vertices > room->vertex_room || b->triangles > room->triangle_room || b->vertices > 65536)
        return GLINT_ERROR_GENERATOR;
    mesh->positions = (const int16_t(*)[3])room->positions;
    mesh->normals = (const int16_t(*)[3])room->normals;
    mesh->triangles = (const uint16_t(*)[3])room->triangles;
    mesh->offset.x = 0, mesh->offset.y = 0, mesh->offset.z = 0;
    mesh->extent.x = extent[0], mesh->extent.y = extent[1], mesh->extent.z = extent[2];
    mesh->flags = 0;
    mesh->colours = 0;
    mesh->colours565 = 0;
    mesh->clusters = 0;
    mesh->layout = 0;
    mesh->texture_coordinates = 0;
    mesh->texture_offset[0] = mesh->texture_offset[1] = mesh->texture_extent[0] = mesh->texture_extent[1] = 0;
    return GLINT_OK;
}

static int is_size(glint_q16 size) {
    return size > 0 && size <= SIZE_MAX_Q16;
}

static int are_divisions(uint32_t a, uint32_t least_a, uint32_t b, uint32_t least_b) {
    return a >= least_a && b >= least_b && a <= 65536 && b <= 65536 && (uint64_t)a * b <= 65536;
}

glint_status glint_generate_torus(glint_mesh *mesh, const glint_mesh_room *room, uint32_t around, uint32_t along,
                                  glint_q16 radius, glint_q16 tube) {
    if (!mesh || !room)
        return GLINT_ERROR_NULL;
    if (!are_divisions(around, 3, along, 3) || !is_size(radius) || !is_size(tube) || tube > SIZE_MAX_Q16 - radius)
        return GLINT_ERROR_GENERATOR;
    builder b = {room, 0, 0};
    int64_t whole = (int64_t)radius + tube;
    for (uint32_t i = 0; i < around; i++) {
        for (uint32_t j = 0; j < along; j++) {
            int32_t sine = glint_sine(phase_of(j, along)), cosine = glint_sine(phase_of(j, along) + 0x40000000u);
            const profile_point p = {(int32_t)(((int64_t)radius * ONE + (int64_t)tube * cosine) / whole), sine, cosine,
                                     sine};
            add_turned(&b, &p, phase_of(i, around));
            uint32_t next = (i + 1) % around, up = (j + 1) % along;
            add_triangle(&b, i * along + j, next * along + j, next * along + up);
            add_triangle(&b, i * along + j, next * along + up, i * along + up);
        }
    }
    return finish(&b, mesh, (glint_q16)whole, (glint_q16)whole, tube);
}

glint_status glint_generate_sphere(glint_mesh *mesh, const glint_mesh_room *room, uint32_t around, uint32_t along,
                                   glint_q16 radius) {
    if (!mesh || !room)
        return GLINT_ERROR_NULL;
    if (!are_divisions(around, 3, along, 2) || !is_size(radius))
        return GLINT_ERROR_GENERATOR;
    builder b = {room, 0, 0};
    const uint32_t rings = along - 1, south = around * rings, north = south + 1;
    for (uint32_t i = 0; i < around; i++) {
        const uint32_t here = i * rings, next = (i + 1) % around * rings;
        for (uint32_t j = 0; j < rings; j++) {
            uint32_t phase = phase_of(j + 1, 2 * along) - 0x40000000u; /* from the south pole up */
            int32_t sine = glint_sine(phase), cosine = glint_sine(phase + 0x40000000u);
            const profile_point p = {cosine, sine, cosine, sine};
            add_turned(&b, &p, phase_of(i, around));
            if (j + 1 == rings)
                continue;
            add_triangle(&b, here + j, next + j, next + j + 1);
            add_triangle(&b, here + j, next + j + 1, here + j + 1);
        }
        add_triangle(&b, south, next, here);
        add_triangle(&b, here + rings - 1, next + rings - 1, north);
    }
    add_on_axis(&b, -ONE, -ONE);
    add_on_axis(&b, ONE, ONE);
    return finish(&b, mesh, radius, radius, radius);
}

/* Adds a disc at height z (1 or -1), facing away from the middle. */
static void add_cap(builder *b, uint32_t around, int32_t z) {
    const uint32_t first = b->vertices, centre = first + around;
    for (uint32_t i = 0; i < around; i++) {
        const profile_point p = {ONE, z, 0, z};
        add_turned(b, &p, phase_of(i, around));
        uint32_t next = first + (i + 1) % around;
        if (z > 0)
            add_triangle(b, first + i, next, centre);
        else
            add_triangle(b, next, first + i, centre);
    }
    add_on_axis(b, z, z);
}

/* Adds a side from radius 1 at z = -1 to radius `top` at z = 1, with normals (normal_radius, normal_z). */
static void add_quad(builder *b, uint32_t around, uint32_t along, int32_t top, int32_t normal_radius,
                     int32_t normal_z) {
    for (uint32_t i = 0; i < around; i++) {
        const uint32_t here = i * (along + 1), next = (i + 1) % around * (along + 1);
        for (uint32_t j = 0; j <= along; j++) {
            int64_t part = ((int64_t)j << 30) / along;
            const profile_point p = {ONE - multiply(ONE - top, (int32_t)part), (int32_t)(2 * part - ONE), normal_radius,
                                     normal_z};
            add_turned(b, &p, phase_of(i, around));
            if (j == along)
                continue;
            add_triangle(b, here + j, next + j, next + j + 1);
            if (top || j + 1 < along) /* at a tip the other triangle has no area */
                add_triangle(b, here + j, next + j + 1, here + j + 1);
        }
    }
}

glint_status glint_generate_cylinder(glint_mesh *mesh, const glint_mesh_room *room, uint32_t around, uint32_t along,
                                     glint_q16 radius, glint_q16 half_height, int capped) {
    if (!mesh || !room)
        return GLINT_ERROR_NULL;
    if (!are_divisions(around, 3, along, 1) || !is_size(radius) || !is_size(half_height))
        return GLINT_ERROR_GENERATOR;
    builder b = {room, 0, 0};
    add_quad(&b, around, along, ONE, ONE, 0);
    if (capped) {
        add_cap(&b, around, -ONE);
        add_cap(&b, around, ONE);
    }
    return finish(&b, mesh, radius, radius, half_height);
}

glint_status glint_generate_cone(glint_mesh *mesh, const glint_mesh_room *room, uint32_t around, uint32_t along,
                                 glint_q16 radius, glint_q16 half_height, int capped) {
    if (!mesh || !room)
        return GLINT_ERROR_NULL;
    if (!are_divisions(around, 3, along, 1) || !is_size(radius) || !is_size(half_height))
        return GLINT_ERROR_GENERATOR;
    builder b = {room, 0, 0};
    int16_t normal[3]; /* at right angles to the side (radius, -2 half_height) */
    glint_unit(2 * half_height, radius, 0, normal);
    const int64_t full = ONE / GLINT_UNIT;
    add_quad(&b, around, along, 0, (int32_t)(normal[0] * full), (int32_t)(normal[1] * full));
    if (capped)
        add_cap(&b, around, -ONE);
    return finish(&b, mesh, radius, radius, half_height);
}

glint_status glint_generate_plane(glint_mesh *mesh, const glint_mesh_room *room, uint32_t columns, uint32_t rows,
                                  glint_q16 half_width, glint_q16 half_height) {
    if (!mesh || !room)
        return GLINT_ERROR_NULL;
    if (!are_divisions(columns, 1, rows, 1) || !is_size(half_width) || !is_size(half_height))
        return GLINT_ERROR_GENERATOR;
    builder b = {room, 0, 0};
    const int32_t normal[3] = {0, 0, ONE};
    for (uint32_t j = 0; j <= rows; j++) {
        for (uint32_t i = 0; i <= columns; i++) {
            const int32_t position[3] = {(int32_t)(((int64_t)i << 31) / columns - ONE),
                                         (int32_t)(((int64_t)j << 31) / rows - ONE), 0};
            add_vertex(&b, position, normal);
            if (i == columns || j == rows)
                continue;
            uint32_t here = j * (columns + 1) + i, above = here + columns + 1;
            add_triangle(&b, here, here + 1, above + 1);
            add_triangle(&b, here, above + 1, above);
        }
    }
    return finish(&b, mesh, half_width, half_height, GLINT_ONE);
}

glint_status glint_generate_box(glint_mesh *mesh, const glint_mesh_room *room, glint_q16 half_width,
                                glint_q16 half_height, glint_q16 half_depth) {
    if (!mesh || !room)
        return GLINT_ERROR_NULL;
    if (!is_size(half_width) || !is_size(half_height) || !is_size(half_depth))
        return GLINT_ERROR_GENERATOR;
    builder b = {room, 0, 0};
    for (int face = 0; face < 6; face++) {
        const int axis = face / 2, sign = face & 1 ? -ONE : ONE;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const uint32_t first = b.vertices;
        for (int corner = 0; corner < 4; corner++) { /* counter-clockwise from outside */
            int32_t position[3], normal[3];
            for (int i = 0; i < 3; i++)
                position[i] = normal[i] = i == axis ? sign : 0;
            position[u] = corner == 1 || corner == 2 ? sign : -sign;
            position[v] = corner >= 2 ? ONE : -ONE;
            add_vertex(&b, position, normal);
        }
        add_triangle(&b, first, first + 1, first + 2);
        add_triangle(&b, first, first + 2, first + 3);
    }
    return finish(&b, mesh, half_width, half_height, half_depth);
}
