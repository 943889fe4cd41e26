/* SPDX-License-Identifier: MIT */
/* Depths up to 2^33 times that of the near plane: drawn as well as 1/w allows, whatever it rounds to. */
#include "fixture.h"
#include "harness.h"
#include "unit.h"

static const glint_format *const formats[2] = {&glint_format_rgb565, &glint_format_rgb888};

static uint32_t count_covered(const fixture *f) {
    const size_t bytes = glint_row_bytes(f->config.format, 1);
    uint32_t covered = 0;
    for (int y = 0; y < f->config.height; y++)
        for (int x = 0; x < f->config.width; x++) {
            const uint8_t *pixel = fixture_row(f, y) + (size_t)x * bytes;
            uint32_t any = 0;
            for (size_t i = 0; i < bytes; i++)
                any |= pixel[i];
            covered += any != 0;
        }
    return covered;
}

/* Black behind, and some ambient light. */
static fixture *begin_on_black(const glint_format *format) {
    fixture *f = fixture_begin();
    f->config.format = format;
    f->config.width = 40;
    f->scene.background.b = 0;
    return f;
}

/* With the near plane ever nearer, 1/w of all its corners rounds to less and less. */
void torus_far_around_the_eye_is_drawn(void) {
    for (int which = 0; which < 2; which++) {
        uint32_t expected = 0;
        for (int32_t near_plane = 1 << 16; near_plane; near_plane >>= 3) {
            fixture *f = begin_on_black(formats[which]);
            f->torus.extent.x <<= 13;
            f->torus.extent.y <<= 13;
            f->torus.extent.z <<= 13;
            f->objects[0].pose = glint_pose_rotate_x(GLINT_Q16(90));
            f->scene.camera.near_plane = near_plane;
            CHECK_EQUAL(fixture_render(f), GLINT_OK);
            expected = expected ? expected : count_covered(f);
            CHECK(expected > 0);
            CHECK_EQUAL(count_covered(f), expected);
        }
    }
}

/* A square that fills the screen, 2^15 away; 1/w counts from a torus before the eye. */
static fixture *begin_far_square(const glint_format *format) {
    fixture *f = begin_on_black(format);
    f->scene.object_count = 2;
    f->objects[0].mesh = &f->floor;
    f->objects[0].pose = glint_pose_rotate_x(GLINT_Q16(90));
    f->floor.extent.x = f->floor.extent.z = 32767 * GLINT_ONE;
    f->floor.offset.y = -32767 * GLINT_ONE;
    f->objects[1].pose = glint_pose_identity();
    f->torus.extent.x = f->torus.extent.y = f->torus.extent.z = 2;
    f->torus.offset.x = 3;
    f->torus.offset.z = -8;
    f->scene.camera.near_plane = 1;
    return f;
}

/* The light of a square does not depend on how far it is, nor on where it is evaluated. */
void farthest_surfaces_are_lit(void) {
    static const glint_evaluation *const evaluations[] = {
        &glint_per_fragment,
        &glint_per_vertex,
        &glint_per_facet,
    };
    for (size_t which = 0; which < sizeof evaluations / sizeof evaluations[0]; which++) {
        int red[2];
        for (int is_far = 0; is_far < 2; is_far++) {
            fixture *f = begin_far_square(&glint_format_rgb888);
            f->scene.viewer = GLINT_VIEWER_INFINITE;
            f->objects[0].evaluation = evaluations[which];
            f->scene.object_count = is_far ? 2 : 1;
            CHECK_EQUAL(fixture_render(f), GLINT_OK);
            red[is_far] = fixture_row(f, 20)[3 * 5];
        }
        CHECK(red[0] > 100);
        CHECK_EQUAL(red[1], red[0]);
    }
}

/*
 * A triangle from just beyond the near plane to far away, its far edge through the centres of a row: its 1/w is so near
 * to 0 there that a plane's rounding may take it below. By lamps, and by suns, where it is dark.
 */
static uint32_t pixels_of_far_row(const glint_format *format, int bits, int row) {
    static int16_t positions[3][3];
    static const int16_t normals[3][3] = {{0, 0, -32767}, {0, 0, -32767}, {0, 0, -32767}};
    static const uint16_t triangle[1][3] = {{0, 1, 2}};
    fixture *f = begin_on_black(format);
    const int near_plane = 1 << 6; /* of 2^16 */
    const int up = 16384 * (2 * 16 - 2 * row - 1) / 32;
    positions[1][0] = 31000;
    positions[2][0] = -31000;
    positions[1][1] = positions[2][1] = (int16_t)up;
    positions[1][2] = positions[2][2] = -16384;
    f->floor.positions = (const int16_t(*)[3])positions;
    f->floor.normals = normals;
    f->floor.triangles = triangle;
    f->floor.vertex_count = 3;
    f->floor.triangle_count = 1;
    f->floor.flags = 0;
    f->floor.extent.x = f->floor.extent.y = f->floor.extent.z = GLINT_ONE << bits;
    f->floor.offset.z = -near_plane;
    f->objects[0].mesh = &f->floor;
    f->objects[0].pose = glint_pose_identity();
    f->scene.camera.field_of_view = 90 * GLINT_ONE;
    f->scene.camera.near_plane = near_plane / 2;
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    uint32_t covered = 0;
    for (int x = 0; x < f->config.width; x++)
        covered += fixture_row(f, row)[(size_t)x * glint_row_bytes(format, 1)] != 0;
    return covered;
}

void farthest_row_is_drawn(void) {
    for (int which = 0; which < 2; which++)
        for (int row = 0; row < 12; row++) {
            const uint32_t expected = pixels_of_far_row(formats[which], 0, row);
            CHECK(expected > 10);
            for (int bits = 6; bits < 14; bits++)
                CHECK_AT_MOST(expected, pixels_of_far_row(formats[which], bits, row));
        }
}

/* A square whose corners' distance is just below a power of two, where rounding passes it, is as large as one nearer.
 */
static uint32_t pixels_of_square(int32_t distance) {
    static const int16_t positions[4][3] = {
        {-32768, -32768, -32768}, {32767, -32768, -32768}, {32767, 32767, -32768}, {-32768, 32767, -32768}};
    static const int16_t normals[4][3] = {{0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}};
    static const uint16_t triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
    fixture *f = begin_on_black(formats[0]);
    f->floor.positions = positions;
    f->floor.normals = normals;
    f->floor.triangles = triangles;
    f->floor.vertex_count = 4;
    f->floor.triangle_count = 2;
    f->floor.extent.x = f->floor.extent.y = 8 * GLINT_ONE;
    f->floor.extent.z = 1001;
    f->objects[0].mesh = &f->floor;
    f->objects[0].pose = glint_pose_translate(0, 0, f->floor.extent.z - distance);
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    return count_covered(f);
}

void corners_below_a_power_of_two_stay(void) {
    const uint32_t expected = pixels_of_square(16 * GLINT_ONE - 64);
    CHECK(expected > 27 * 27 - 2 * 27);
    CHECK_EQUAL(pixels_of_square(16 * GLINT_ONE - 1), expected);
}
