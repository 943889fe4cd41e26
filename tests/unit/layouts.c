/* SPDX-License-Identifier: MIT */
/* Layouts: errors are named, and what is drawn of a mesh in RAM, one struct a vertex, is what its arrays give. */
#include "fixture.h"
#include "glint_extras.h"
#include "harness.h"
#include "unit.h"

/* The floor, one struct a vertex. */
typedef struct place {
    int16_t position[3];
    int16_t normal[3];
    uint8_t colour[3], rest;
} place;

/* A mesh in RAM; not to be moved. */
typedef struct laid_out {
    place places[4];
    uint8_t faces[2][3];
    glint_mesh_layout layout;
} laid_out;

static fixture *show_floor(void) {
    fixture *f = fixture_begin();
    f->objects[0].mesh = &f->floor;
    f->objects[0].pose = glint_pose_translate(3 * GLINT_ONE, -GLINT_ONE, -5 * GLINT_ONE);
    return f;
}

/* A fixture that shows the floor, which has no arrays but a layout. */
static fixture *lay_out(laid_out *to) {
    fixture *f = show_floor();
    for (uint32_t i = 0; i < 4; i++)
        for (int c = 0; c < 3; c++) {
            to->places[i].position[c] = f->floor.positions[i][c];
            to->places[i].normal[c] = f->floor.normals[i][c];
            to->places[i].colour[c] = 255;
        }
    for (uint32_t i = 0; i < 3 * 2; i++)
        to->faces[i / 3][i % 3] = (uint8_t)f->floor.triangles[i / 3][i % 3];
    to->layout = (glint_mesh_layout){{&glint_attribute_int16, to->places[0].position, sizeof(place)},
                                     {&glint_attribute_int16, to->places[0].normal, sizeof(place)},
                                     {&glint_attribute_uint8, to->faces, 0},
                                     {&glint_attribute_rgb888, to->places[0].colour, sizeof(place)}};
    f->floor.positions = 0;
    f->floor.normals = 0;
    f->floor.triangles = 0;
    f->floor.layout = &to->layout;
    return f;
}

/* Never read. */
static const uint32_t numbers[4];

/* Draws with one attribute spoiled. */
static void expect_attribute(int which, const glint_attribute_type *type, const void *data, uint32_t stride,
                             glint_status error) {
    laid_out to;
    fixture *f = lay_out(&to);
    glint_mesh_attribute *const all[4] = {&to.layout.positions, &to.layout.normals, &to.layout.triangles,
                                          &to.layout.colours};
    *all[which] = (glint_mesh_attribute){type, data, stride};
    fixture_expect_error(f, error);
}

static void expect_null(int which) {
    expect_attribute(which, &glint_attribute_int16, 0, 0, GLINT_ERROR_NULL);
    if (which < 3)
        expect_attribute(which, 0, numbers, 0, GLINT_ERROR_NULL);
}

static void expect_type(int which, const glint_attribute_type *type) {
    expect_attribute(which, type, numbers, 0, GLINT_ERROR_TYPE);
}

static void expect_stride(int which, const glint_attribute_type *type, uint32_t offset, uint32_t stride) {
    expect_attribute(which, type, (const uint8_t *)numbers + offset, stride, GLINT_ERROR_STRIDE);
}

static void expect_index(uint8_t index, int small) {
    laid_out to;
    fixture *f = lay_out(&to);
    f->config.arena_size = small ? fixture_need(f).least : f->config.arena_size;
    to.faces[1][1] = index;
    fixture_expect_error(f, GLINT_ERROR_INDEX);
}

void bad_layouts_are_refused(void) {
    for (int which = 0; which < 4; which++)
        expect_null(which);
    expect_type(0, &glint_attribute_octahedral8);
    expect_type(0, &glint_attribute_octahedral16);
    expect_type(0, &glint_attribute_uint16);
    expect_type(0, &glint_attribute_uint8);
    expect_type(1, &glint_attribute_rgb888);
    expect_type(1, &glint_attribute_uint8);
    expect_type(2, &glint_attribute_int16);
    expect_type(2, &glint_attribute_int8);
    expect_type(3, &glint_attribute_int8);
    expect_type(3, &glint_attribute_octahedral8);
    expect_stride(0, &glint_attribute_int16, 0, 4);
    expect_stride(0, &glint_attribute_int16, 0, 7);
    expect_stride(0, &glint_attribute_int16, 1, 0);
    expect_stride(0, &glint_attribute_int8, 1, 2);
    expect_stride(1, &glint_attribute_octahedral16, 0, 2);
    expect_stride(1, &glint_attribute_octahedral16, 3, 8);
    expect_stride(1, &glint_attribute_octahedral8, 0, 1);
    expect_stride(2, &glint_attribute_uint16, 0, 9);
    expect_stride(2, &glint_attribute_uint8, 0, 1);
    expect_stride(3, &glint_attribute_rgb565, 1, 2);
    for (int small = 0; small < 2; small++) {
        expect_index(4, small);
        expect_index(255, small);
    }
}

static void draw_both(const glint_evaluation *evaluation, int small) {
    laid_out to;
    fixture *f = show_floor();
    f->objects[0].evaluation = evaluation;
    f->config.arena_size = small ? fixture_need(f).least : f->config.arena_size;
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    const uint32_t wanted = fixture_checksum(f);
    f = lay_out(&to);
    to.layout.colours.type = 0;
    f->objects[0].evaluation = evaluation;
    f->config.arena_size = small ? fixture_need(f).least : f->config.arena_size;
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK_EQUAL(fixture_checksum(f), wanted);
    to.places[2].position[1] = 8000; /* what is drawn is what is there now */
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK(fixture_checksum(f) != wanted);
}

void layouts_draw_what_arrays_do(void) {
    draw_both(&glint_per_fragment, 0);
    draw_both(&glint_per_fragment, 1);
    draw_both(&glint_per_vertex, 1);
    draw_both(&glint_per_facet, 1);
}
