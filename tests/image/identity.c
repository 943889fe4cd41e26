/* SPDX-License-Identifier: MIT */
/*
 * Suite: the image is the same, byte for byte, for every tile size, every arena from the smallest to the best, tiles
 * drawn in another order by two workspaces, and objects in another order.
 */
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "random.h"
#include "scenes.h"

#include <stdlib.h>

/* A size that no tile divides. */
#define WIDTH 150
#define HEIGHT 101

static const uint16_t tile_sizes[4] = {8, 16, 32, 64};

/* Draws with options and holds the bytes against `wanted`; both arguments' pictures have the same size. */
static void check_same(const picture *wanted, const glint_scene *scene, const picture_options *options) {
    picture got = picture_open(wanted->width, wanted->height, wanted->format);
    CHECK_EQUAL(picture_render(&got, scene, options, NULL), GLINT_OK);
    CHECK(picture_is_complete(&got));
    CHECK(picture_equal(wanted, &got));
    picture_close(&got);
}

typedef void (*scene_check)(const picture *wanted, const glint_scene *scene);

/* Runs a check over every scene, with one image drawn the default way. */
static void for_each_scene_in(const glint_format *format, scene_check check) {
    for (unsigned i = 0; i < scene_count; i++) {
        test_scene scene;
        picture wanted = picture_open(WIDTH, HEIGHT, format);
        scene_build(&scene, &scene_definitions[i]);
        scene.scene.viewer = i % 3 ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
        CHECK_EQUAL(picture_render(&wanted, &scene.scene, NULL, NULL), GLINT_OK);
        CHECK(picture_is_complete(&wanted));
        check(&wanted, &scene.scene);
        picture_close(&wanted);
    }
}

/* In 8 bits a channel, and in RGB565. */
static void for_each_scene(scene_check check) {
    for_each_scene_in(&glint_format_rgb888, check);
    for_each_scene_in(&glint_format_rgb565, check);
}

static void check_tile_sizes(const picture *wanted, const glint_scene *scene) {
    for (int i = 0; i < 16; i++) {
        const picture_options options = {.tile_width = tile_sizes[i % 4], .tile_height = tile_sizes[i / 4]};
        check_same(wanted, scene, &options);
    }
}

static void every_tile_size(void) {
    for_each_scene(check_tile_sizes);
}

/*
 * Two planes that cross at a quarter of a degree: over most of the screen their depths are a few steps apart, so that
 * whatever makes depth depend on the tile shows in the colours.
 */
static void every_tile_size_where_depths_nearly_tie(void) {
    test_scene scene;
    picture wanted = picture_open(WIDTH, HEIGHT, &glint_format_rgb888);
    scene_build_named(&scene, "floor to the horizon");
    for (int i = 0; i < 2; i++) {
        glint_pose tilt = glint_pose_rotate_x(80 * GLINT_ONE + i * GLINT_ONE / 4);
        glint_pose turn = glint_pose_rotate_z((20 + i) * GLINT_ONE);
        scene.objects[i] = scene.objects[0];
        scene.objects[i].pose = glint_pose_then(&tilt, &turn);
        scene.objects[i].pose.m[2][3] = -9 * GLINT_ONE;
        scene.objects[i].material = &scene.materials[i];
    }
    scene.materials[1].ambient = (glint_colour){0, 0, GLINT_ONE};
    scene.scene.object_count = 2;
    CHECK_EQUAL(picture_render(&wanted, &scene.scene, NULL, NULL), GLINT_OK);
    check_tile_sizes(&wanted, &scene.scene);
    picture_close(&wanted);
}

static glint_need arena_need(const picture *like, const glint_scene *scene, const picture_options *options) {
    picture image = *like;
    glint_config config = picture_config(&image, options);
    glint_need need = {0};
    CHECK_EQUAL(glint_arena_need(&config, scene, &need), GLINT_OK);
    CHECK(need.least <= need.one_pass);
    return need;
}

/* From the smallest arena, which takes many passes, to beyond the best, which takes one. */
static void check_arenas(const picture *wanted, const glint_scene *scene) {
    for (int i = 0; i < 3; i++) {
        picture_options options = {.tile_width = tile_sizes[i], .tile_height = tile_sizes[(i + 1) % 3]};
        glint_need need = arena_need(wanted, scene, &options);
        for (int eighth = 0; eighth <= 9; eighth++) {
            options.arena_size = need.least + (need.one_pass - need.least) / 8 * (size_t)eighth + (eighth & 3);
            check_same(wanted, scene, &options);
        }
        options.arena_size = need.least;
        check_same(wanted, scene, &options);
        options.arena_size = need.one_pass;
        check_same(wanted, scene, &options);
    }
}

/* Two triangles of a thousand pixels, lit by stepped squares: in tiles of every size, with tables and without. */
static void every_tile_size_and_arena_of_large_highlights(void) {
    test_scene scene;
    picture wanted = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    const glint_pose small = glint_pose_scale(GLINT_ONE / 60, GLINT_ONE / 60, GLINT_ONE / 60);
    const glint_pose up = glint_pose_rotate_x(75 * GLINT_ONE), stand = glint_pose_then(&small, &up);
    scene_build_named(&scene, "floor to the horizon");
    scene.objects[0].pose = stand;
    scene.objects[0].pose.m[2][3] = -12 * GLINT_ONE;
    scene.scene.camera.field_of_view = 12 * GLINT_ONE;
    scene.scene.viewer = GLINT_VIEWER_LOCAL;
    scene.lights[0].vector = (glint_vector){GLINT_Q16(0.1), GLINT_Q16(0.5), GLINT_ONE};
    CHECK_EQUAL(picture_render(&wanted, &scene.scene, NULL, NULL), GLINT_OK);
    check_tile_sizes(&wanted, &scene.scene);
    check_arenas(&wanted, &scene.scene);
    picture_close(&wanted);
}

static void every_arena(void) {
    for_each_scene(check_arenas);
}

static void best_arena_takes_one_pass(void) {
    for (unsigned i = 0; i < scene_count; i++) {
        test_scene scene;
        glint_stats stats = {0};
        picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
        scene_build(&scene, &scene_definitions[i]);
        picture_options options = {0};
        glint_need need = arena_need(&image, &scene.scene, &options);
        CHECK_EQUAL(picture_render(&image, &scene.scene, &options, &stats), GLINT_OK);
        CHECK_EQUAL(stats.passes, 1);
        CHECK_AT_MOST(stats.arena_used, need.one_pass);
        options.arena_size = need.least;
        CHECK_EQUAL(picture_render(&image, &scene.scene, &options, &stats), GLINT_OK);
        CHECK_AT_MOST(stats.arena_used, need.least);
        options.arena_size = need.least - 1;
        CHECK_EQUAL(picture_render(&image, &scene.scene, &options, &stats), GLINT_ERROR_ARENA);
        picture_close(&image);
    }
}

/* ---- Less than all vertices ---- */

#define FINE_AROUND 96
#define FINE_ALONG 48
#define FINE_VERTICES ((FINE_AROUND + 1) * (FINE_ALONG + 1))
#define FINE_TRIANGLES (2 * FINE_AROUND * FINE_ALONG)

static int16_t fine_positions[FINE_VERTICES][3], fine_normals[FINE_VERTICES][3];
static uint16_t fine_triangles[FINE_TRIANGLES][3];

/* Swaps each triangle with one anywhere. */
static void shuffle_triangles(void) {
    random_state = 1;
    for (uint32_t i = 0; i < FINE_TRIANGLES; i++) {
        const uint32_t other = below(FINE_TRIANGLES);
        for (int c = 0; c < 3; c++) {
            const uint16_t corner = fine_triangles[i][c];
            fine_triangles[i][c] = fine_triangles[other][c];
            fine_triangles[other][c] = corner;
        }
    }
}

/* With so many sixteenths of what one pass takes above the smallest: how often is a vertex transformed, at most? */
static void check_share(const picture *wanted, const glint_scene *scene, int sixteenths, uint32_t most) {
    picture got = picture_open(wanted->width, wanted->height, wanted->format);
    picture_options options = {0};
    glint_stats stats = {0};
    const glint_need need = arena_need(wanted, scene, &options);
    options.arena_size = need.least + (need.one_pass - need.least) / 16 * (size_t)sixteenths;
    CHECK_EQUAL(picture_render(&got, scene, &options, &stats), GLINT_OK);
    CHECK(picture_equal(wanted, &got));
    CHECK_AT_MOST(stats.vertices, most * FINE_VERTICES);
    CHECK_AT_MOST(stats.passes, 4 * stats.tiles);
    picture_close(&got);
}

/* Where an arena does not hold all vertices, what a frame takes grows by and by as the arena shrinks. */
static void parts_of_a_mesh(void) {
    static const uint32_t most[2][4] = {{1, 6, 5, 14}, {1, 80, 85, 170}};
    static const int sixteenths[4] = {16, 8, 4, 1};
    const glint_mesh_room room = {fine_positions, fine_normals, fine_triangles, FINE_VERTICES, FINE_TRIANGLES};
    test_scene scene;
    glint_mesh mesh;
    picture wanted = picture_open(320, 240, &glint_format_rgb565);
    scene_build_named(&scene, "p of 0, 0.5, 1, 1.5");
    scene.scene.object_count = 1;
    scene.objects[0].pose = glint_pose_rotate_x(50 * GLINT_ONE);
    scene.objects[0].pose.m[2][3] = -4 * GLINT_ONE;
    CHECK_EQUAL(glint_generate_torus(&mesh, &room, FINE_AROUND, FINE_ALONG, GLINT_ONE, GLINT_ONE / 3), GLINT_OK);
    scene.objects[0].mesh = &mesh;
    for (int is_shuffled = 0; is_shuffled < 2; is_shuffled++) {
        if (is_shuffled)
            shuffle_triangles();
        CHECK_EQUAL(picture_render(&wanted, &scene.scene, NULL, NULL), GLINT_OK);
        for (int i = 0; i < 4; i++)
            check_share(&wanted, &scene.scene, sixteenths[i], most[is_shuffled][i]);
    }
    picture_close(&wanted);
}

/* ---- Tile by tile -------------------------------------------------------------------------------------------- */

typedef struct two_workspaces {
    glint_workspace of[2];
    void *memory[2];
} two_workspaces;

static two_workspaces workspaces_open(const glint_config *config) {
    two_workspaces workspaces;
    for (int i = 0; i < 2; i++) {
        workspaces.memory[i] = malloc(glint_workspace_size(config));
        CHECK(workspaces.memory[i] != NULL);
        glint_workspace_init(&workspaces.of[i], config, workspaces.memory[i]);
    }
    return workspaces;
}

static void draw_tile(const glint_frame *frame, glint_workspace *workspace, uint32_t tile, picture *image) {
    int rectangle[4];
    if (!glint_render_tile(frame, workspace, tile))
        return;
    glint_tile_rectangle(frame, tile, &rectangle[0], &rectangle[1], &rectangle[2], &rectangle[3]);
    CHECK_EQUAL(picture_put(image, rectangle, workspace->pixels, workspace->stride), 0);
}

/*
 * The last tile of a pass first, workspaces in turn. Only the last tile of a pass may need a later one, which must find
 * it in the same workspace: a workspace is chosen by the tile's number, and no other tile may come between.
 */
static void draw_backwards(const picture *wanted, const glint_scene *scene, size_t arena_size) {
    const picture_options options = {.tile_width = 16, .tile_height = 8};
    picture got = picture_open(wanted->width, wanted->height, wanted->format);
    glint_config config = picture_config(&got, &options);
    config.arena_size = arena_size;
    config.arena = malloc(arena_size);
    two_workspaces workspaces = workspaces_open(&config);
    glint_frame frame;
    int status = CHECK(config.arena != NULL) ? (int)glint_frame_begin(&frame, &config, scene) : GLINT_ERROR_NULL;
    CHECK_EQUAL(status, GLINT_OK);
    while (status >= 0 && (status = glint_frame_next(&frame)) > 0) {
        for (uint32_t tile = frame.tile_end; tile-- > frame.tile_first;)
            draw_tile(&frame, &workspaces.of[tile % 2], tile, &got);
    }
    CHECK_EQUAL(status, 0);
    CHECK(picture_is_complete(&got));
    CHECK(picture_equal(wanted, &got));
    free(workspaces.memory[0]);
    free(workspaces.memory[1]);
    free(config.arena);
    picture_close(&got);
}

static void check_tile_order(const picture *wanted, const glint_scene *scene) {
    const picture_options options = {.tile_width = 16, .tile_height = 8};
    glint_need need = arena_need(wanted, scene, &options);
    draw_backwards(wanted, scene, need.one_pass);
    draw_backwards(wanted, scene, need.least + (need.one_pass - need.least) / 3);
    draw_backwards(wanted, scene, need.least);
}

static void two_workspaces_in_another_tile_order(void) {
    for_each_scene(check_tile_order);
}

/* ---- Object order -------------------------------------------------------------------------------------------- */

/* Four spheres one behind the other, overlapping on the screen and nowhere touching. */
static void build_row_of_spheres(test_scene *scene) {
    scene_build_named(scene, "p of 0, 0.5, 1, 1.5");
    for (int i = 0; i < 4; i++) {
        scene->objects[i].pose.m[0][3] = (i - 1) * GLINT_ONE / 2;
        scene->objects[i].pose.m[1][3] = (i % 3 - 1) * GLINT_ONE / 4;
        scene->objects[i].pose.m[2][3] = -(4 + 3 * i) * GLINT_ONE;
    }
}

static void every_order_of_objects(void) {
    test_scene scene;
    build_row_of_spheres(&scene);
    picture wanted = picture_open(WIDTH, HEIGHT, &glint_format_rgb888);
    CHECK_EQUAL(picture_render(&wanted, &scene.scene, NULL, NULL), GLINT_OK);
    for (int order = 0; order < 4 * 4 * 4; order++) {
        int picks[4] = {order % 4, order / 4 % 4, order / 16, 0};
        picks[3] = 6 - picks[0] - picks[1] - picks[2];
        glint_object objects[4];
        int seen = 0;
        for (int i = 0; i < 4; i++)
            seen |= picks[i] >= 0 && picks[i] < 4 ? 1 << picks[i] : 0;
        if (seen != 15)
            continue;
        for (int i = 0; i < 4; i++)
            objects[i] = scene.objects[picks[i]];
        glint_scene shuffled = scene.scene;
        shuffled.objects = objects;
        check_same(&wanted, &shuffled, NULL);
    }
    picture_close(&wanted);
}

/* The same object twice in two colours: where depths tie, the first drawn wins. */
static void first_of_ties_wins(void) {
    test_scene scene;
    scene_build(&scene, &scene_definitions[0]);
    picture wanted = picture_open(WIDTH, HEIGHT, &glint_format_rgb888);
    CHECK_EQUAL(picture_render(&wanted, &scene.scene, NULL, NULL), GLINT_OK);
    scene.objects[1] = scene.objects[0];
    scene.objects[1].material = &scene.materials[1];
    scene.materials[1].diffuse = (glint_colour){0, GLINT_ONE, 0};
    scene.scene.object_count = 2;
    check_same(&wanted, &scene.scene, NULL);
    picture_close(&wanted);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(every_tile_size),
        TEST_CASE(every_tile_size_where_depths_nearly_tie),
        TEST_CASE(every_tile_size_and_arena_of_large_highlights),
        TEST_CASE(every_arena),
        TEST_CASE(best_arena_takes_one_pass),
        TEST_CASE(parts_of_a_mesh),
        TEST_CASE(two_workspaces_in_another_tile_order),
        TEST_CASE(every_order_of_objects),
        TEST_CASE(first_of_ties_wins),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
