/* SPDX-License-Identifier: MIT */
/* Vertices to clip space and to the screen. */
#include "proof.h"

#include "../../src/geometry/geometry.c"
#include "ranges.h"

#define MOST_W 0x30000000

/* Stands on classify: the box of an object that is not clipped lies within the planes. `numbers` tries a million
 * transforms. */
/*@ requires \valid_read(transform) && \valid_read(p + (0 .. 2));
    assigns \result \from *transform, p[0 .. 2];
    admit ensures 1 <= \result.w <= 0x30000000;
    admit ensures -0x30000000 <= \result.x <= 0x30000000 && -0x30000000 <= \result.y <= 0x30000000; */
static inline glint_position to_clip_space(const glint_transform *transform, const int16_t p[3]);

/*@ requires \valid_read(transform) && \valid(vertex);
    requires 1 <= w <= 0x30000000;
    assigns vertex->x, vertex->y, vertex->inverse_w \from *transform, x, y, w;
    ensures \initialized(&vertex->x) && \initialized(&vertex->y) && \initialized(&vertex->inverse_w);
    ensures -29000 <= vertex->x <= 29000 && -29000 <= vertex->y <= 29000;
    ensures 64 <= vertex->inverse_w <= 0x7fff0000; */
static void project_inline(const glint_transform *transform, int32_t x, int32_t y, int32_t w, glint_vertex *vertex);

/*@ requires \valid_read(transform) && count <= 2 && \valid(vertex + (0 .. 1));
    requires \valid_read(&p[0 .. 1][0 .. 2]);
    assigns vertex[0 .. 1] \from *transform, p[0 .. 1][0 .. 2], first, count; */
static void transform_inside(const glint_transform *transform, const int16_t (*p)[3], uint32_t first, uint32_t count,
                             glint_vertex *vertex);

/* Any w from least to most, none below the nearest; x and y, which do not meet, below 0 or not and up to it. */
static void project_part(glint_transform *transform, int32_t least, int32_t most) {
    transform->nearest = ANY(0, least);
    glint_vertex vertex;
    const glint_position right = {ANY(0, most), ANY(0, most), ANY(least, most)};
    const glint_position left = {ANY(-most, -1), ANY(-most, -1), ANY(least, most)};
    transform->clips = 0;
    glint_project(transform, &right, &vertex);
    glint_project(transform, &left, &vertex);
    transform->clips = GLINT_PARALLEL; /* this w is that of all, and positions have any */
    transform->nearest = ANY(least, most);
    const glint_position right_of_all = {ANY(0, most), ANY(0, most), ANY_INT};
    const glint_position left_of_all = {ANY(-most, -1), ANY(-most, -1), ANY_INT};
    glint_project(transform, &right_of_all, &vertex);
    glint_project(transform, &left_of_all, &vertex);
}

/* w by parts of a quarter of its bits, from 1 up. */
static void project_parts(void) {
    glint_transform transform;
    any_transform(&transform);
    FOR_PARTS(w, 1, 3) {
        project_part(&transform, (int32_t)w, (int32_t)w);
    }
    FOR_PARTS(bits, 0, 27) {
        FOR_PARTS(quarter, 4, bits < 27 ? 7 : 5) {
            project_part(&transform, (int32_t)quarter << bits, ((int32_t)(quarter + 1) << bits) - (bits < 27));
        }
    }
}

/*
 * w from 1 to 3 2^28, x and y from -w to w, by parts of w and by signs. @contract glint_inverse
 * @narrowing a shift to the left, of coordinates up to w as w is; what is stored is within 29000
 */
PROOF(project_inline) {
    project_parts();
}

/*
 * The same by products of 32 bits. @contract glint_inverse
 * @narrowing a shift to the left, of coordinates up to w as w is; what is stored is within 29000
 * @options -cpp-extra-args=-DGLINT_SPLIT_PRODUCTS=1
 */
PROOF(project_split) {
    project_parts();
}

/*
 * Any positions from any number on, of an object that may be clipped.
 * @contract glint_row_times_whole project_inline transform_inside
 * @narrowing a vertex's number in its mesh is read back as uint16_t
 * @unreached 2 glint_project in perspective
 */
PROOF(glint_transform_array) {
    static int16_t positions[65536][3];
    glint_mesh mesh;
    glint_transform transform;
    glint_vertex vertices[2];
    glint_position kept[2];
    Frama_C_make_unknown((char *)positions, sizeof positions);
    mesh.positions = (const int16_t(*)[3])positions;
    any_transform(&transform);
    const uint32_t first = ANY_UNSIGNED(0, 65534);
    transform.clips = 0;
    glint_transform_array(&transform, &mesh, first, ANY_UNSIGNED(0, 2), vertices, 0);
    transform.clips = 1;
    glint_transform_array(&transform, &mesh, first, ANY_UNSIGNED(0, 2), vertices, kept);
    transform.clips = GLINT_PARALLEL;
    transform.nearest = ANY(1, MOST_W);
    glint_transform_array(&transform, &mesh, first, ANY_UNSIGNED(0, 2), vertices, kept);
}

/*
 * Any positions from any number on. @contract to_clip_space project_inline
 * @narrowing a vertex's number in its mesh is read back as uint16_t
 */
PROOF(transform_inside) {
    static int16_t positions[65536][3];
    glint_transform transform;
    glint_vertex vertices[2];
    Frama_C_make_unknown((char *)positions, sizeof positions);
    any_transform(&transform);
    const uint32_t first = ANY_UNSIGNED(0, 65534);
    transform_inside(&transform, (const int16_t(*)[3])positions + first, first, ANY_UNSIGNED(0, 2), vertices);
}

/*
 * Sums of up to three positions of 3 2^28, any camera.
 * @narrowing all are shifted by as many bits as the largest has above 30
 */
PROOF(glint_ray) {
    glint_transform transform;
    glint_view view;
    int32_t ray[3], inverse_w;
    any_transform(&transform);
    any_view(&view);
    FOR_PARTS(count, 1, 3) {
        const int64_t most = (int64_t)count * MOST_W;
        const int64_t sum[3] = {ANY_LONG(-most, most), ANY_LONG(-most, most), ANY_LONG(-most, most)};
        glint_ray(&transform, &view, sum, (int32_t)count, ray, &inverse_w);
    }
}
