/* SPDX-License-Identifier: MIT */
/*
 * Suite: large triangles with the eye inside, which were wrong: each draws what it should, in any tiles and arena; and
 * the near plane cuts floors where glint.h says. Random scenes of this kind are a part of suite `equivalences`.
 */
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "reference.h"
#include "stability/grids.h"

#include <stdlib.h>

/* Draws a scene in one pass. */
static glint_status draw(const glint_scene *scene, picture *image, uint32_t *empty) {
    const picture_options options = {.overlay = {picture_count_empty, empty}};
    *empty = 0;
    return picture_render(image, scene, &options, NULL);
}

/* A triangle whose plane of 1/w is off by more than the 1/w of its corners: colours were divided by 0. */
static void far_colours_are_drawn(void) {
    static const int16_t points[3][3] = {{26624, -17408, -11264}, {-22528, 1024, -30720}, {-9216, 19456, -10240}};
    static const uint8_t colours[3][3] = {{255, 255, 255}, {128, 255, 128}, {255, 0, 0}};
    static const uint16_t side[1][3] = {{0, 1, 2}};
    const glint_q16 size = 1000 * GLINT_ONE;
    const glint_mesh mesh = {points, points, side, 3, 1, {0, 0, 0}, {size, size, size}, GLINT_MESH_DOUBLE_SIDED,
                             colours};
    const glint_material paint = {.model = &glint_model_unlit, .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    static const glint_evaluation *const evaluations[3] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    for (unsigned i = 0; i < TEST_COUNT(evaluations); i++) {
        const glint_object object = {&mesh, &paint, glint_pose_identity(), evaluations[i]};
        const glint_scene scene = {
            .camera = {glint_pose_identity(), 50 * GLINT_ONE, 1}, .objects = &object, .object_count = 1};
        picture image = picture_open(160, 120, &glint_format_rgb565);
        uint32_t empty;
        CHECK_EQUAL(draw(&scene, &image, &empty), GLINT_OK);
        CHECK(picture_is_complete(&image));
        CHECK(empty > 0 && empty < 160 * 120 / 2);
        picture_close(&image);
    }
}

/* The largest step from a pixel that shows no background to the next one of its row, of 24 bits each. */
static int largest_step(const picture *image) {
    int most = 0;
    for (int y = 0; y < image->height; y++)
        for (int x = 1; x < image->width; x++) {
            const uint8_t *const pixel = image->bytes + (size_t)y * image->stride + 3 * (size_t)x;
            for (int c = 0; c < 3 && (pixel[-2] | pixel[-3]) && (pixel[0] | pixel[1]); c++)
                most = abs(pixel[c] - pixel[c - 3]) > most ? abs(pixel[c] - pixel[c - 3]) : most;
        }
    return most;
}

/* Another one, behind an object without pixels: where 1/w was rounded below 0, whether it was drawn was up to the
 * arena. */
static void far_triangles_are_not_hidden(void) {
    static const int16_t dot_places[2][3] = {{0, 0, 0}, {0, 0, 0}}, normals[3][3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    static const int16_t places[3][3] = {{0, 8192, 0}, {0, 0, 0}, {0, 0, -16384}};
    static const uint16_t dot_sides[1][3] = {{0, 1, 0}}, sides[1][3] = {{0, 2, 1}};
    static const uint16_t colours[3] = {32024, 29973, 11594};
    static const struct {
        uint16_t tile_width, arena; /* of 256 from the least to one pass */
    } ways[] = {{8, 0}, {8, 256}, {64, 0}};
    const glint_vector one = {GLINT_ONE, GLINT_ONE, GLINT_ONE};
    const glint_mesh dot = {dot_places, normals, dot_sides, 2, 1, {0, 0, 0}, one};
    const glint_mesh far = {places, normals, sides, 3, 1, {0, 0, 0}, one, .colours565 = colours};
    const glint_material paint = {.model = &glint_model_unlit, .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    const glint_object objects[2] = {
        {&dot, &paint, glint_pose_identity()},
        {&far, &paint, {{{0, -86573056, 0, 0}, {3113, -885456896, 0, 0}, {0, 0, 398852096, 0}}}, &glint_per_vertex}};
    const glint_scene scene = {
        .camera = {{{{-11843, -8272, 63924, 16777216}, {2762, -64999, -7900, -122851}, {64398, 1266, 12095, 40770}}},
                   45 * GLINT_ONE,
                   1},
        .objects = objects,
        .object_count = 2,
        .background = {0, 0, GLINT_ONE}};
    picture image = picture_open(24, 8, &glint_format_rgb888);
    uint32_t empty, again;
    CHECK_EQUAL(draw(&scene, &image, &empty), GLINT_OK);
    CHECK_EQUAL(empty, 24 * 8 - 42);
    CHECK_AT_MOST(largest_step(&image), 64); /* of noise, 255 */
    for (unsigned i = 0; i < TEST_COUNT(ways); i++) {
        picture_options options = {ways[i].tile_width, 8, .overlay = {picture_count_empty, &again}};
        const glint_need need = picture_need(&image, &scene, &options);
        options.arena_size = picture_arena(&need, ways[i].arena);
        again = 0;
        CHECK(picture_draws_same(&image, &scene, &options, NULL));
        CHECK_EQUAL(again, empty);
    }
    picture_close(&image);
}

/* ---- Near cuts ----------------------------------------------------------------------------------------------- */

/* Numbers below a limit (Knuth's multiplicative hash). */
static uint32_t take(uint32_t *state, uint32_t limit) {
    *state = *state * 2654435761u + 12345;
    return (uint32_t)((uint64_t)(*state >> 8) * limit >> 24);
}

#define CUT_WIDTH 12
#define CUT_HEIGHT 72

/* A floor whose extent is 2^log2_ratio near planes, cut by the near plane below the middle of the screen. The eye
 * stands anywhere, and looks anywhere from level to 20 degrees down. */
typedef struct floor_scene {
    int16_t positions[4][3], normals[4][3];
    uint16_t triangles[2][3];
    glint_mesh mesh;
    glint_object object;
    glint_scene scene;
} floor_scene;

static void make_floor(floor_scene *f, uint32_t *state, int log2_ratio) {
    static const glint_material paint = {.model = &glint_model_unlit, .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    const glint_mesh_room room = {f->positions, f->normals, f->triangles, 4, 2};
    const glint_q16 near_plane = 64 + (glint_q16)take(state, (30000u >> (log2_ratio - 16)) - 64);
    const glint_q16 extent = near_plane << log2_ratio, tangent = 37837; /* of half the field of view */
    const glint_pose down = glint_pose_rotate_x(-(glint_q16)take(state, 20 * GLINT_ONE));
    const glint_pose around = glint_pose_rotate_y((glint_q16)take(state, 360 * GLINT_ONE));
    glint_camera *const camera = &f->scene.camera;
    grid_add_terrain(&f->mesh, &room, 1);
    f->mesh.positions = (const int16_t(*)[3])f->positions;
    f->mesh.normals = (const int16_t(*)[3])f->normals;
    f->mesh.triangles = (const uint16_t(*)[3])f->triangles;
    f->mesh.extent = (glint_vector){extent, GLINT_ONE, extent};
    f->object = (glint_object){&f->mesh, &paint, glint_pose_identity()};
    camera->pose = glint_pose_then(&down, &around);
    camera->pose.m[0][3] = extent / 1000 * ((glint_q16)take(state, 1400) - 700);
    camera->pose.m[1][3] = (glint_q16)((int64_t)near_plane * tangent / 1000 * (200 + take(state, 600)) >> 16);
    camera->pose.m[2][3] = extent / 1000 * ((glint_q16)take(state, 1400) - 700);
    camera->field_of_view = 60 * GLINT_ONE;
    camera->near_plane = near_plane;
    f->scene.objects = &f->object;
    f->scene.object_count = 1;
}

/* The pixels of a column, at most, that the library covers or the reference, and not both; and adds what is covered. */
static int rows_apart(const glint_scene *scene, long *covered) {
    static reference_pixel pixels[CUT_WIDTH * CUT_HEIGHT];
    const reference_image wanted = {CUT_WIDTH, CUT_HEIGHT, pixels};
    picture image = picture_open(CUT_WIDTH, CUT_HEIGHT, &glint_format_grey8);
    int most = 0;
    CHECK_EQUAL(picture_render(&image, scene, NULL, NULL), GLINT_OK);
    reference_render(&wanted, scene, NULL);
    for (int x = 0; x < CUT_WIDTH; x++) {
        int apart = 0;
        for (int y = 0; y < CUT_HEIGHT; y++) {
            apart += (picture_level(&image, x, y, 0) > 0) != pixels[y * CUT_WIDTH + x].covered;
            *covered += pixels[y * CUT_WIDTH + x].covered;
        }
        most = apart > most ? apart : most;
    }
    picture_close(&image);
    return most;
}

/* Who stands close to a floor sees it end where the near plane cuts it. */
static void near_cuts_are_where_they_are(void) {
    static const struct { int log2_ratio, rows; } stated[] = {{16, 1}, {18, 3}, {20, 7}};
    uint32_t state = 1;
    long covered = 0;
    for (unsigned i = 0; i < TEST_COUNT(stated); i++)
        for (int number = 0; number < 100; number++) {
            floor_scene f = {0};
            make_floor(&f, &state, stated[i].log2_ratio);
            CHECK_AT_MOST(rows_apart(&f.scene, &covered), stated[i].rows);
        }
    CHECK(covered > 300 * CUT_WIDTH * CUT_HEIGHT / 8);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(far_colours_are_drawn),
        TEST_CASE(far_triangles_are_not_hidden),
        TEST_CASE(near_cuts_are_where_they_are),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
