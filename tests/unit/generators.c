/* SPDX-License-Identifier: MIT */
/* Generated meshes: counts, room, orientation, closed surfaces, and normals as their formulas say. */
#include "fixture.h"
#include "glint_extras.h"
#include "harness.h"
#include "unit.h"

#define GUARD 0xa7
#define GUARD_BYTES 4

/* Sizes of all shapes. */
#define RADIUS (2 * GLINT_ONE)
#define TUBE GLINT_Q16(0.75)
#define HALF_HEIGHT GLINT_Q16(1.5)

enum { TORUS, SPHERE, CYLINDER, CAPPED_CYLINDER, CONE, CAPPED_CONE, PLANE, BOX };

typedef struct shape {
    int kind;
    uint32_t around, along, vertices, triangles;
    int closed;
} shape;

static const shape shapes[] = {
    {TORUS, 3, 3, 9, 18, 1},
    {TORUS, 7, 5, 35, 70, 1},
    {SPHERE, 3, 2, 5, 6, 1},
    {SPHERE, 6, 5, 26, 48, 1},
    {CYLINDER, 3, 1, 6, 6, 0},
    {CYLINDER, 7, 3, 28, 42, 0},
    {CAPPED_CYLINDER, 5, 2, 27, 30, 1},
    {CONE, 3, 1, 6, 3, 0},
    {CONE, 6, 3, 24, 30, 0},
    {CAPPED_CONE, 5, 2, 21, 20, 1},
    {PLANE, 1, 1, 4, 2, 0},
    {PLANE, 4, 3, 20, 24, 0},
    {BOX, 0, 0, 24, 12, 1},
};

static glint_status generate(const shape *s, glint_mesh *mesh, const glint_mesh_room *room) {
    switch (s->kind) {
    case TORUS:
        return glint_generate_torus(mesh, room, s->around, s->along, RADIUS, TUBE);
    case SPHERE:
        return glint_generate_sphere(mesh, room, s->around, s->along, RADIUS);
    case CYLINDER:
    case CAPPED_CYLINDER:
        return glint_generate_cylinder(mesh, room, s->around, s->along, RADIUS, HALF_HEIGHT,
                                       s->kind == CAPPED_CYLINDER);
    case CONE:
    case CAPPED_CONE:
        return glint_generate_cone(mesh, room, s->around, s->along, RADIUS, HALF_HEIGHT, s->kind == CAPPED_CONE);
    case PLANE:
        return glint_generate_plane(mesh, room, s->around, s->along, RADIUS, HALF_HEIGHT);
    default:
        return glint_generate_box(mesh, room, RADIUS, HALF_HEIGHT, TUBE);
    }
}

/* ---- Room ---------------------------------------------------------------------------------------------------- */

/* Cuts the next array from the fixture's arena, which no frame uses here, and guards its end. */
static void *cut(uint8_t **free_bytes, uint32_t count, uint32_t size) {
    uint8_t *array = *free_bytes;
    *free_bytes += (count * size + GUARD_BYTES + 3) / 4 * 4;
    for (uint8_t *at = array; at < *free_bytes; at++)
        *at = GUARD;
    return array;
}

static glint_mesh_room make_room(uint32_t vertices, uint32_t triangles) {
    uint8_t *bytes = fixture_arena();
    glint_mesh_room room;
    bytes += (0u - (unsigned)((uintptr_t)bytes & 3u)) % 4u;
    room.positions = cut(&bytes, vertices, sizeof *room.positions);
    room.normals = cut(&bytes, vertices, sizeof *room.normals);
    room.triangles = cut(&bytes, triangles, sizeof *room.triangles);
    room.vertex_room = vertices;
    room.triangle_room = triangles;
    return room;
}

static int is_guarded(const void *end) {
    const uint8_t *at = end;
    return at[0] == GUARD && at[1] == GUARD && at[2] == GUARD && at[3] == GUARD;
}

static void check_room(const shape *s, uint32_t vertices, uint32_t triangles, glint_status expected) {
    glint_mesh mesh;
    glint_mesh_room room = make_room(vertices, triangles);
    CHECK_EQUAL(generate(s, &mesh, &room), expected);
    CHECK_EQUAL(mesh.vertex_count, s->vertices);
    CHECK_EQUAL(mesh.triangle_count, s->triangles);
    CHECK(is_guarded(room.positions + vertices));
    CHECK(is_guarded(room.normals + vertices));
    CHECK(is_guarded(room.triangles + triangles));
}

void generators_fill_their_room(void) {
    for (unsigned i = 0; i < TEST_COUNT(shapes); i++) {
        const shape *s = &shapes[i];
        const glint_mesh_room none = {0, 0, 0, 0, 0};
        glint_mesh mesh;
        check_room(s, s->vertices, s->triangles, GLINT_OK);
        check_room(s, s->vertices - 1, s->triangles, GLINT_ERROR_GENERATOR);
        check_room(s, s->vertices, s->triangles - 1, GLINT_ERROR_GENERATOR);
        mesh.positions = 0; /* with pointers of null it cannot be drawn */
        mesh.extent.x = -1;
        CHECK_EQUAL(generate(s, &mesh, &none), GLINT_ERROR_GENERATOR);
        CHECK_EQUAL(mesh.vertex_count, s->vertices);
        CHECK_EQUAL(mesh.triangle_count, s->triangles);
        CHECK_EQUAL(mesh.extent.x, -1);
        const glint_mesh_room small = make_room(s->vertices - 1, s->triangles);
        CHECK_EQUAL(generate(s, &mesh, &small), GLINT_ERROR_GENERATOR);
        CHECK(mesh.positions == 0 && mesh.extent.x == -1);
    }
}

/* ---- Surface ------------------------------------------------------------------------------------------------- */

/* A vertex in object space, Q16. */
static void locate(const glint_mesh *mesh, uint32_t vertex, int64_t place[3]) {
    const int16_t *steps = mesh->positions[vertex];
    const glint_q16 offset[3] = {mesh->offset.x, mesh->offset.y, mesh->offset.z};
    const glint_q16 extent[3] = {mesh->extent.x, mesh->extent.y, mesh->extent.z};
    for (int axis = 0; axis < 3; axis++)
        place[axis] = offset[axis] + (int64_t)steps[axis] * extent[axis] / 32768;
}

static int64_t dot(const int64_t a[3], const int64_t b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const int64_t a[3], const int64_t b[3], int64_t result[3]) {
    for (int axis = 0; axis < 3; axis++)
        result[axis] = a[(axis + 1) % 3] * b[(axis + 2) % 3] - a[(axis + 2) % 3] * b[(axis + 1) % 3];
}

/* A triangle's plane faces where the normals of its corners do. */
static int faces_outwards(const glint_mesh *mesh, uint32_t triangle) {
    int64_t p[3][3];
    int64_t plane[3];
    int64_t along = 0;
    for (int i = 0; i < 3; i++)
        locate(mesh, mesh->triangles[triangle][i], p[i]);
    for (int axis = 0; axis < 3; axis++) {
        p[1][axis] -= p[0][axis];
        p[2][axis] -= p[0][axis];
    }
    cross(p[1], p[2], plane);
    for (int i = 0; i < 3; i++) {
        const int16_t *normal = mesh->normals[mesh->triangles[triangle][i]];
        const int64_t wide[3] = {normal[0], normal[1], normal[2]};
        along += dot(plane, wide);
    }
    return along > 0;
}

static int same_place(const glint_mesh *mesh, uint32_t a, uint32_t b) {
    const int16_t *p = mesh->positions[a];
    const int16_t *q = mesh->positions[b];
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/* How often the edge from a to b occurs, its ends taken by where they are. */
static int count_edges(const glint_mesh *mesh, uint32_t a, uint32_t b) {
    int count = 0;
    for (uint32_t i = 0; i < 3 * mesh->triangle_count; i++) {
        const uint16_t *triangle = mesh->triangles[i / 3];
        count += same_place(mesh, triangle[i % 3], a) && same_place(mesh, triangle[(i + 1) % 3], b);
    }
    return count;
}

void generators_face_outwards(void) {
    for (unsigned i = 0; i < TEST_COUNT(shapes); i++) {
        glint_mesh mesh;
        glint_mesh_room room = make_room(shapes[i].vertices, shapes[i].triangles);
        CHECK_EQUAL(generate(&shapes[i], &mesh, &room), GLINT_OK);
        for (uint32_t triangle = 0; triangle < mesh.triangle_count; triangle++)
            CHECK(faces_outwards(&mesh, triangle));
        for (uint32_t edge = 0; edge < 3 * mesh.triangle_count && shapes[i].closed; edge++) {
            const uint16_t *triangle = mesh.triangles[edge / 3];
            CHECK_EQUAL(count_edges(&mesh, triangle[(edge + 1) % 3], triangle[edge % 3]), 1);
        }
    }
}

/* ---- Formulas ------------------------------------------------------------------------------------------------ */

static int64_t magnitude(int64_t x) {
    return x < 0 ? -x : x;
}

/* Off by at most 1/8192 of what is compared with. */
static int is_near(int64_t a, int64_t b, int64_t scale) {
    return magnitude(a - b) <= scale / 8192;
}

/* Square of the distance from the z axis, Q32. */
static int64_t around_axis(const int64_t place[3]) {
    return place[0] * place[0] + place[1] * place[1];
}

static int64_t square(int64_t x) {
    return x * x;
}

/* A step of `length` inwards along the normal: to the centre of a sphere, to the circle in a torus. */
static void step_inwards(const int64_t place[3], const int16_t normal[3], int64_t length, int64_t result[3]) {
    for (int axis = 0; axis < 3; axis++)
        result[axis] = place[axis] - normal[axis] * length / 32767;
}

static int is_on_torus(const int64_t place[3], const int16_t normal[3]) {
    int64_t inside[3];
    step_inwards(place, normal, TUBE, inside);
    return is_near(inside[2], 0, TUBE) && is_near(around_axis(inside), square(RADIUS), square(RADIUS));
}

static int is_on_sphere(const int64_t place[3], const int16_t normal[3]) {
    int64_t inside[3];
    step_inwards(place, normal, RADIUS, inside);
    return is_near(inside[0], 0, RADIUS) && is_near(inside[1], 0, RADIUS) && is_near(inside[2], 0, RADIUS);
}

/* On a cap, at its end, or on the side: the slope of the radius over z is `slope_radius` to 2 HALF_HEIGHT. */
static int is_on_side(const int64_t place[3], const int16_t normal[3], int64_t slope_radius) {
    const int64_t level = place[2] - HALF_HEIGHT; /* from the upper end */
    const int64_t radius = RADIUS - slope_radius - slope_radius * level / (2 * HALF_HEIGHT);
    const int64_t wide[3] = {normal[0], normal[1], normal[2]};
    if (normal[0] == 0 && normal[1] == 0 && magnitude(normal[2]) >= 32766)
        return is_near(place[2], normal[2] > 0 ? HALF_HEIGHT : -HALF_HEIGHT, HALF_HEIGHT) &&
               around_axis(place) <= square(RADIUS) + square(RADIUS) / 4096;
    /* along the axis plane: N turned is P turned; and at right angles to the side */
    return is_near(place[0] * wide[1], place[1] * wide[0], square(32768) * 8) &&
           is_near(around_axis(place), square(radius), square(RADIUS) * 2) &&
           is_near(square(wide[2] * (2 * HALF_HEIGHT >> 8)),
                   (wide[0] * wide[0] + wide[1] * wide[1]) * square(slope_radius >> 8),
                   square(32768) * square(RADIUS >> 8));
}

/* At a face of half sizes x, y, z: the normal is its axis. */
static int is_on_face(const int64_t place[3], const int16_t normal[3], const int64_t half[3]) {
    int axes = 0;
    int inside = 1;
    for (int axis = 0; axis < 3; axis++) {
        inside &= magnitude(place[axis]) <= half[axis] + half[axis] / 8192;
        axes += normal[axis] != 0;
        if (normal[axis] != 0)
            inside &= is_near(place[axis], normal[axis] > 0 ? half[axis] : -half[axis], half[axis] + 8192);
    }
    return inside && axes == 1;
}

static int is_on_shape(int kind, const int64_t place[3], const int16_t normal[3]) {
    static const int64_t box[3] = {RADIUS, HALF_HEIGHT, TUBE};
    static const int64_t plane[3] = {RADIUS, HALF_HEIGHT, 0};
    if (kind == TORUS || kind == SPHERE)
        return kind == TORUS ? is_on_torus(place, normal) : is_on_sphere(place, normal);
    if (kind == PLANE || kind == BOX)
        return is_on_face(place, normal, kind == BOX ? box : plane);
    return is_on_side(place, normal, kind == CONE || kind == CAPPED_CONE ? RADIUS : 0);
}

void generators_follow_their_formulas(void) {
    for (unsigned i = 0; i < TEST_COUNT(shapes); i++) {
        glint_mesh mesh;
        glint_mesh_room room = make_room(shapes[i].vertices, shapes[i].triangles);
        CHECK_EQUAL(generate(&shapes[i], &mesh, &room), GLINT_OK);
        for (uint32_t vertex = 0; vertex < mesh.vertex_count; vertex++) {
            const int16_t *normal = mesh.normals[vertex];
            int64_t place[3];
            locate(&mesh, vertex, place);
            CHECK(is_near(square(normal[0]) + square(normal[1]) + square(normal[2]), square(32767), square(32767)));
            if (!CHECK(is_on_shape(shapes[i].kind, place, normal))) {
                test_write("  shape ");
                test_write_number(i);
                test_write(", vertex ");
                test_write_number(vertex);
                test_write("\n");
            }
        }
    }
}

/* ---- Bad input ----------------------------------------------------------------------------------------------- */

static void refuse(glint_status status, glint_status expected) {
    CHECK_EQUAL(status, expected);
}

static void refuse_divisions(uint32_t around, uint32_t along) {
    const glint_mesh_room room = make_room(40, 40);
    const glint_status bad = GLINT_ERROR_GENERATOR;
    glint_mesh mesh;
    refuse(glint_generate_torus(&mesh, &room, around, along, GLINT_ONE, GLINT_ONE), bad);
    refuse(glint_generate_sphere(&mesh, &room, around, along, GLINT_ONE), bad);
    refuse(glint_generate_cylinder(&mesh, &room, around, along, GLINT_ONE, GLINT_ONE, 1), bad);
    refuse(glint_generate_cone(&mesh, &room, around, along, GLINT_ONE, GLINT_ONE, 0), bad);
    refuse(glint_generate_plane(&mesh, &room, around, along, GLINT_ONE, GLINT_ONE), bad);
}

static void refuse_sizes(glint_q16 a, glint_q16 b) {
    const glint_mesh_room room = make_room(40, 40);
    const glint_status bad = GLINT_ERROR_GENERATOR;
    glint_mesh mesh;
    refuse(glint_generate_torus(&mesh, &room, 4, 4, a, b), bad);
    refuse(glint_generate_cylinder(&mesh, &room, 4, 1, a, b, 1), bad);
    refuse(glint_generate_cone(&mesh, &room, 4, 1, a, b, 0), bad);
    refuse(glint_generate_plane(&mesh, &room, 1, 1, a, b), bad);
    refuse(glint_generate_box(&mesh, &room, a, b, GLINT_ONE), bad);
    refuse(glint_generate_box(&mesh, &room, b, GLINT_ONE, a), bad);
    refuse(glint_generate_box(&mesh, &room, GLINT_ONE, a, b), bad);
    if (a == b)
        refuse(glint_generate_sphere(&mesh, &room, 4, 4, a), bad);
}

void generators_refuse_bad_input(void) {
    static const glint_q16 sizes[] = {0, -1, INT32_MIN, 8192 * GLINT_ONE + 1, INT32_MAX};
    static const uint32_t counts[] = {0, 65537, 0x80000000u, 0xffffffffu};
    const glint_mesh_room room = make_room(40, 40);
    glint_mesh mesh;
    for (unsigned i = 0; i < TEST_COUNT(sizes); i++) {
        refuse_sizes(sizes[i], GLINT_ONE);
        refuse_sizes(GLINT_ONE, sizes[i]);
        refuse_sizes(sizes[i], sizes[i]);
    }
    for (unsigned i = 0; i < TEST_COUNT(counts); i++) {
        refuse_divisions(counts[i], 3);
        refuse_divisions(3, counts[i]);
    }
    refuse_divisions(300, 300); /* more vertices than uint16 can index */
    refuse(glint_generate_torus(&mesh, &room, 2, 3, GLINT_ONE, GLINT_ONE), GLINT_ERROR_GENERATOR);
    refuse(glint_generate_torus(&mesh, &room, 3, 2, GLINT_ONE, GLINT_ONE), GLINT_ERROR_GENERATOR);
    refuse(glint_generate_sphere(&mesh, &room, 2, 2, GLINT_ONE), GLINT_ERROR_GENERATOR);
    refuse(glint_generate_sphere(&mesh, &room, 3, 1, GLINT_ONE), GLINT_ERROR_GENERATOR);
    refuse(glint_generate_cylinder(&mesh, &room, 2, 1, GLINT_ONE, GLINT_ONE, 0), GLINT_ERROR_GENERATOR);
    refuse(glint_generate_cone(&mesh, &room, 2, 1, GLINT_ONE, GLINT_ONE, 0), GLINT_ERROR_GENERATOR);
    for (unsigned i = 0; i < TEST_COUNT(shapes); i++) {
        refuse(generate(&shapes[i], 0, &room), GLINT_ERROR_NULL);
        refuse(generate(&shapes[i], &mesh, 0), GLINT_ERROR_NULL);
    }
}
