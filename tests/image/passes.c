/* SPDX-License-Identifier: MIT */
/*
 * Suite: meshes of more triangles than a pass can number. Whatever the arena, the picture is that of the few triangles
 * that are visible, and a tile costs no more passes than its triangles ask for.
 */
#include "glint.h"
#include "harness.h"
#include "picture.h"

#define WIDTH 128
#define HEIGHT 96
#define TILES (WIDTH / 8 * HEIGHT / 8)
#define TRIANGLES 200000u

/* Vertices transformed for a pass of one or two triangles, a look at which tiles they touch included. Each strip of
 * tiles that is loaded in vain adds to them: an estimate of bytes that wraps makes it 23. */
#define VERTICES_OF_PASS 12

/* Numbers of the mesh's triangles that are visible; all others have no area. */
static const uint32_t visible[] = {0, 1, 65536 + 2, 131072 + 40, TRIANGLES - 1};

static const int16_t corners[4][3] = {{-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}};
static const int16_t normals[4][3] = {{0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}};
static const uint8_t colours[4][3] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 0}};

/* Halves of a square, in turn. */
static void set_half(uint16_t triangle[3], unsigned number) {
    triangle[0] = 0;
    triangle[1] = (uint16_t)(1 + number % 2);
    triangle[2] = (uint16_t)(2 + number % 2);
}

static glint_status draw(const uint16_t (*triangles)[3], uint32_t count, const glint_evaluation *evaluation,
                         size_t arena_size, picture *image, glint_stats *stats) {
    const glint_mesh mesh = {
        corners, normals, triangles, 4, count, {0}, {GLINT_Q16(20), GLINT_Q16(20), GLINT_ONE}, .colours = colours};
    const glint_material paint = {.model = &glint_model_lambert,
                                  .ambient = {GLINT_ONE, GLINT_ONE, GLINT_ONE},
                                  .diffuse = {GLINT_ONE / 2, GLINT_ONE / 2, GLINT_ONE / 2}};
    const glint_light light = {.type = &glint_light_directional,
                               .vector = {GLINT_ONE, 0, GLINT_ONE},
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
    return picture_render(image, &scene, &options, stats);
}

static void large_meshes_cost_few_passes(void) {
    static const size_t arenas[] = {0, 1 << 15, 1 << 18, 1 << 22, 1 << 26};
    static const glint_evaluation *const evaluations[] = {&glint_per_vertex, &glint_per_fragment, &glint_per_facet};
    static uint16_t all[TRIANGLES][3];
    uint16_t few[TEST_COUNT(visible)][3];
    for (unsigned i = 0; i < TEST_COUNT(visible); i++) {
        set_half(all[visible[i]], i);
        set_half(few[i], i);
    }
    for (unsigned e = 0; e < TEST_COUNT(evaluations); e++) {
        glint_stats stats;
        picture wanted = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
        CHECK_EQUAL(draw((const uint16_t(*)[3])few, TEST_COUNT(visible), evaluations[e], 0, &wanted, &stats), GLINT_OK);
        for (unsigned i = 0; i < TEST_COUNT(arenas); i++) {
            picture got = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
            CHECK_EQUAL(draw((const uint16_t(*)[3])all, TRIANGLES, evaluations[e], arenas[i], &got, &stats), GLINT_OK);
            CHECK(picture_equal(&got, &wanted));
            CHECK_AT_MOST(stats.passes, TILES * TEST_COUNT(visible));
            CHECK_AT_MOST(stats.vertices, VERTICES_OF_PASS * stats.passes);
            picture_close(&got);
        }
        picture_close(&wanted);
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(large_meshes_cost_few_passes)};
    return test_run(write, cases, TEST_COUNT(cases));
}
