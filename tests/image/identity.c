/* SPDX-License-Identifier: MIT */
/*
 * Suite: the image is the same, byte for byte, for every tile size and arena from the smallest to the best. The best
 * arena takes one pass, and meshes of more triangles than a pass can number cost no more passes than they ask for.
 */
#include "every_format.h"
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "random.h"
#include "scenes.h"

/* A size that no tile divides. */
#define WIDTH 150
#define HEIGHT 101

static const uint16_t tile_sizes[4] = {8, 16, 32, 64};

/* Every tile size in one pass. */
static void check_tile_sizes(const picture *wanted, const glint_scene *scene) {
    for (int i = 0; i < 16; i++) {
        const picture_options options = {.tile_width = tile_sizes[i % 4], .tile_height = tile_sizes[i / 4]};
        glint_stats stats;
        CHECK(picture_draws_same(wanted, scene, &options, &stats));
        CHECK_EQUAL(stats.passes, 1);
        CHECK_AT_MOST(stats.arena_used, picture_need(wanted, scene, &options).one_pass);
    }
}

/* From the smallest arena, which takes many passes, to beyond the best, which takes one. */
static void check_arenas(const picture *wanted, const glint_scene *scene) {
    for (int i = 0; i < 3; i++) {
        picture_options options = {.tile_width = tile_sizes[i], .tile_height = tile_sizes[(i + 1) % 3]};
        const glint_need need = picture_need(wanted, scene, &options);
        picture image = *wanted;
        glint_stats stats;
        CHECK(need.least <= need.resident && need.resident <= need.one_pass);
        for (uint32_t eighth = 0; eighth <= 9; eighth++) {
            options.arena_size = picture_arena(&need, 32 * eighth) + (eighth & 3);
            CHECK(picture_draws_same(wanted, scene, &options, &stats));
            CHECK_AT_MOST(stats.arena_used, options.arena_size);
        }
        options.arena_size = need.resident;
        CHECK(picture_draws_same(wanted, scene, &options, NULL));
        options.arena_size = need.least - 1;
        CHECK_EQUAL(picture_render(&image, scene, &options, NULL), GLINT_ERROR_ARENA);
    }
}

typedef void (*scene_check)(const picture *wanted, const glint_scene *scene);

/* Runs a check over a scene, with one image drawn the default way. */
static void check_in(const glint_format *format, const glint_scene *scene, scene_check check) {
    picture wanted = picture_open(WIDTH, HEIGHT, format);
    CHECK_EQUAL(picture_render(&wanted, scene, NULL, NULL), GLINT_OK);
    CHECK(picture_is_complete(&wanted));
    check(&wanted, scene);
    picture_close(&wanted);
}

/* All scenes in 8 bits a channel, in RGB565, and each in a format of its own; also with parallel rays. */
static void for_each_scene(scene_check check) {
    random_state = 1;
    for (unsigned i = 0; i < scene_count; i++) {
        test_scene scene;
        scene_build(&scene, &scene_definitions[i]);
        scene.scene.viewer = i % 3 ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
        check_in(&glint_format_rgb888, &scene.scene, check);
        check_in(&glint_format_rgb565, &scene.scene, check);
        scene_evaluate(&scene, scene_evaluations[i % 3]);
        check_in(every_format[i % FORMAT_COUNT], &scene.scene, check);
        scene_make_parallel(&scene.scene);
        check_in(&glint_format_rgb565, &scene.scene, check);
    }
}

static void every_tile_size(void) {
    for_each_scene(check_tile_sizes);
}

static void every_arena(void) {
    for_each_scene(check_arenas);
}

/*
 * Two planes that cross at a quarter of a degree: over most of the screen their depths are a few steps apart, so that
 * whatever makes depth depend on the tile shows in the colours.
 */
static void every_tile_size_where_depths_nearly_tie(void) {
    test_scene scene;
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
    check_in(&glint_format_rgb888, &scene.scene, check_tile_sizes);
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
static void check_share(const picture *wanted, const glint_scene *scene, uint32_t sixteenths, uint32_t most) {
    const glint_need need = picture_need(wanted, scene, NULL);
    const picture_options options = {.arena_size = picture_arena(&need, 16 * sixteenths)};
    glint_stats stats;
    CHECK(picture_draws_same(wanted, scene, &options, &stats));
    CHECK_AT_MOST(stats.vertices, most * FINE_VERTICES);
    CHECK_AT_MOST(stats.passes, 4 * stats.tiles);
}

/* Where an arena does not hold all vertices, what a frame takes grows by and by as the arena shrinks. */
static void parts_of_a_mesh(void) {
    static const uint32_t most[2][4] = {{1, 6, 5, 14}, {1, 80, 85, 170}};
    static const uint32_t sixteenths[4] = {16, 8, 4, 1};
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

/* ---- More triangles than a pass can number ---- */

#define PASS_WIDTH 128
#define PASS_HEIGHT 96
#define PASS_TILES (PASS_WIDTH / 8 * PASS_HEIGHT / 8)
#define PASS_TRIANGLES 200000u

/* Vertices transformed for a pass of one or two triangles, a look at which tiles they touch included. Each strip of
 * tiles that is loaded in vain adds to them: an estimate of bytes that wraps makes it 23. */
#define VERTICES_OF_PASS 12

/* Numbers of the mesh's triangles that are visible; all others have no area. */
static const uint32_t visible[] = {0, 1, 65536 + 2, 131072 + 40, PASS_TRIANGLES - 1};

static const uint8_t half_colours[4][3] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 0}};

/* Halves of a square, in turn. */
static void set_half(uint16_t triangle[3], unsigned number) {
    triangle[0] = 0;
    triangle[1] = (uint16_t)(1 + number % 2);
    triangle[2] = (uint16_t)(2 + number % 2);
}

static glint_status draw_halves(const uint16_t (*triangles)[3], uint32_t count, const glint_evaluation *evaluation,
                                size_t arena_size, picture *image, glint_stats *stats) {
    glint_mesh mesh = scene_square_mesh(20 * GLINT_ONE, GLINT_ONE);
    const glint_material paint = {.model = &glint_model_lambert,
                                  .ambient = {GLINT_ONE, GLINT_ONE, GLINT_ONE},
                                  .diffuse = {GLINT_ONE / 2, GLINT_ONE / 2, GLINT_ONE / 2}};
    const glint_light light = {.type = &glint_light_directional,
                               .direction = {-GLINT_ONE, 0, -GLINT_ONE},
                               .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    const glint_object object = {&mesh, &paint, glint_pose_identity(), evaluation};
    const glint_scene scene = {
        .camera = {glint_pose_translate(0, 0, 4 * GLINT_ONE), 45 * GLINT_ONE, GLINT_ONE / 10},
        .ambient = {GLINT_ONE / 2, GLINT_ONE / 2, GLINT_ONE / 2},
        .lights = &light,
        .light_count = 1,
        .objects = &object,
        .object_count = 1,
    };
    const picture_options options = {.tile_width = 8, .tile_height = 8, .arena_size = arena_size};
    mesh.triangles = triangles;
    mesh.triangle_count = count;
    mesh.colours = half_colours;
    return picture_render(image, &scene, &options, stats);
}

static void large_meshes_cost_few_passes(void) {
    static const size_t arenas[] = {0, 1 << 15, 1 << 18, 1 << 22, 1 << 26};
    static uint16_t all[PASS_TRIANGLES][3];
    uint16_t few[TEST_COUNT(visible)][3];
    for (unsigned i = 0; i < TEST_COUNT(visible); i++) {
        set_half(all[visible[i]], i);
        set_half(few[i], i);
    }
    for (unsigned e = 0; e < TEST_COUNT(scene_evaluations); e++) {
        glint_stats stats;
        picture wanted = picture_open(PASS_WIDTH, PASS_HEIGHT, &glint_format_rgb565);
        CHECK_EQUAL(
            draw_halves((const uint16_t(*)[3])few, TEST_COUNT(visible), scene_evaluations[e], 0, &wanted, &stats),
            GLINT_OK);
        for (unsigned i = 0; i < TEST_COUNT(arenas); i++) {
            picture got = picture_open(PASS_WIDTH, PASS_HEIGHT, &glint_format_rgb565);
            CHECK_EQUAL(
                draw_halves((const uint16_t(*)[3])all, PASS_TRIANGLES, scene_evaluations[e], arenas[i], &got, &stats),
                GLINT_OK);
            CHECK(picture_equal(&got, &wanted));
            CHECK_AT_MOST(stats.passes, PASS_TILES * TEST_COUNT(visible));
            CHECK_AT_MOST(stats.vertices, VERTICES_OF_PASS * stats.passes);
            picture_close(&got);
        }
        picture_close(&wanted);
    }
}

/*
 * A plane of 120,000 triangles, all of which are seen: as one object, of which a pass has no room for all; as two, of
 * which the second has more than a part's numbers reach; and as three.
 */
static void many_triangles_of_few_objects(void) {
    enum { COLUMNS = 250, ROWS = 240, WIDE = 96, THIRD = 2 * COLUMNS * ROWS / 3 };
    static int16_t positions[(COLUMNS + 1) * (ROWS + 1)][3], bent[(COLUMNS + 1) * (ROWS + 1)][3];
    static uint16_t triangles[2 * COLUMNS * ROWS][3];
    const glint_mesh_room room = {positions, bent, triangles, TEST_COUNT(positions), TEST_COUNT(triangles)};
    picture wanted = picture_open(WIDE, WIDE, &glint_format_rgb888);
    test_scene scene;
    glint_mesh plane, parts[3];
    scene_build_named(&scene, "mirrored");
    CHECK_EQUAL(glint_generate_plane(&plane, &room, COLUMNS, ROWS, GLINT_ONE, GLINT_ONE), GLINT_OK);
    for (unsigned i = 0; i < TEST_COUNT(positions); i++) { /* so that colours tell places apart */
        bent[i][0] = (int16_t)(positions[i][0] / 2);
        bent[i][1] = (int16_t)(positions[i][1] / 3);
    }
    for (uint32_t count = 3; count > 0; count--) {
        picture_options options = {.tile_width = 64, .tile_height = 64, .arena_size = 1 << 24};
        glint_stats stats;
        scene.scene.object_count = count;
        for (uint32_t i = 0; i < count; i++) {
            parts[i] = plane;
            parts[i].triangles += i * THIRD;
            parts[i].triangle_count = i + 1 < count ? THIRD : (3 - i) * THIRD;
            scene.objects[i] = scene.objects[0];
            scene.objects[i].mesh = &parts[i];
            scene.objects[i].pose = glint_pose_rotate_z(10 * GLINT_ONE);
            scene.objects[i].pose.m[2][3] = -3 * GLINT_ONE;
        }
        if (count == 3)
            CHECK_EQUAL(picture_render(&wanted, &scene.scene, &options, NULL), GLINT_OK);
        CHECK(picture_draws_same(&wanted, &scene.scene, &options, &stats));
        CHECK_EQUAL(stats.outside, 0); /* no triangle is so small that it has no number */
        CHECK(count == 3 || stats.passes > 1);
        for (options.arena_size = 0; options.arena_size <= 200000; options.arena_size += 100000) {
            CHECK(picture_draws_same(&wanted, &scene.scene, &options, &stats));
            CHECK(count == 3 || stats.passes > 1);
        }
    }
    picture_close(&wanted);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(every_tile_size),
        TEST_CASE(every_tile_size_where_depths_nearly_tie),
        TEST_CASE(every_arena),
        TEST_CASE(parts_of_a_mesh),
        TEST_CASE(large_meshes_cost_few_passes),
        TEST_CASE(many_triangles_of_few_objects),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
