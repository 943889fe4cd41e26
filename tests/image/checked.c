/* SPDX-License-Identifier: MIT */
/*
 * Suite: glint_check tells of a frame what drawing it tells: the status for any arena, the pixels that objects cover,
 * and black only where all of it is black, with output tables and without, in every format, of a region too.
 */
#include "every_format.h"
#include "glint_extras.h"
#include "harness.h"
#include "sample.h"
#include "stability/large_scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int send_nothing(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context, (void)x, (void)y, (void)width, (void)height, (void)pixels, (void)stride;
    return 0;
}

static int wait_for_nothing(void *context) {
    (void)context;
    return 0;
}

static int count_shown(void *context, const glint_tile *tile) {
    uint32_t *const shown = context;
    for (int y = 0; y < tile->height; y++)
        for (int x = 0; x < tile->width; x++)
            *shown += tile->depth[(size_t)y * tile->depth_stride + (size_t)x] != 0;
    return 0;
}

/* Draws and checks with an arena of so many bytes. @return whether both say the same */
static int agree(glint_config config, const glint_scene *scene, size_t bytes) {
    glint_report report;
    glint_renderer renderer;
    uint32_t shown = 0;
    config.arena = malloc(bytes ? bytes : 1);
    config.arena_size = bytes;
    const glint_status said = glint_check(&config, scene, &report);
    config.overlay = (glint_painter){count_shown, &shown};
    glint_status status = glint_init(&renderer, &config);
    if (status == GLINT_OK)
        status = glint_render(&renderer, scene);
    free(config.arena);
    return said == status && report.status == said && (status != GLINT_OK || report.shown == shown) &&
           (status != GLINT_ERROR_ARENA) == (report.bytes == 0);
}

static const uint16_t (*const tables[2])[GLINT_GAMMA_ENTRIES] = {NULL, glint_gamma_srgb};

/* ---- A box under a light ---- */

typedef struct box {
    int16_t positions[24][3], normals[24][3];
    uint16_t triangles[12][3];
    glint_mesh mesh;
    glint_material material;
    glint_light light;
    glint_object object;
    glint_scene scene;
} box;

static void make_box(box *b) {
    const glint_mesh_room room = {b->positions, b->normals, b->triangles, 24, 12};
    const glint_colour white = {GLINT_ONE, GLINT_ONE, GLINT_ONE};
    memset(b, 0, sizeof *b);
    glint_generate_box(&b->mesh, &room, GLINT_ONE, GLINT_ONE, GLINT_ONE);
    b->material = glint_material_paint(&glint_model_blinn_phong, white, GLINT_ONE / 10, 32 * GLINT_ONE);
    b->light = (glint_light){&glint_light_directional, {-GLINT_ONE, GLINT_ONE, GLINT_ONE}, white, white};
    b->object = (glint_object){&b->mesh, &b->material, glint_pose_rotate_y(30 * GLINT_ONE), &glint_per_fragment};
    b->scene = (glint_scene){.camera = {glint_pose_translate(0, 0, 5 * GLINT_ONE), 45 * GLINT_ONE, GLINT_ONE / 10},
                             .ambient = white,
                             .lights = &b->light,
                             .light_count = 1,
                             .objects = &b->object,
                             .object_count = 1};
}

static void every_arena_of_a_box(void) {
    static box b;
    make_box(&b);
    for (unsigned i = 0; i < 2 * FORMAT_COUNT; i++) {
        const glint_config config = {.width = 32,
                                     .height = 32,
                                     .tile_width = 8,
                                     .tile_height = 8,
                                     .format = every_format[i / 2],
                                     .flush = {.begin = send_nothing},
                                     .gamma = tables[i % 2]};
        glint_need need;
        CHECK_EQUAL(glint_arena_need(&config, &b.scene, &need), GLINT_OK);
        for (size_t bytes = need.least - 20; bytes < need.one_pass + 100; bytes += 13)
            if (!CHECK(agree(config, &b.scene, bytes)))
                break;
        CHECK(agree(config, &b.scene, 0));
        CHECK(agree(config, &b.scene, need.least - 1));
    }
}

/* ---- Black ---- */

/* Output tables whose black is a dark grey, and whose white is white. */
static uint16_t raised[3][GLINT_GAMMA_ENTRIES];

static void raise_black(void) {
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < GLINT_GAMMA_ENTRIES; i++)
            raised[c][i] = (uint16_t)(20000 + 45535 * i / (GLINT_GAMMA_ENTRIES - 1));
}

/* The sentence about the box, which is lit or not, in a region or the whole. */
static void expect(const box *b, const glint_format *format, const uint16_t (*gamma)[GLINT_GAMMA_ENTRIES],
                   const glint_rectangle *region, int is_black) {
    static uint8_t arena[1 << 16];
    const glint_config config = {.width = 45,
                                 .height = 37,
                                 .tile_width = 16,
                                 .tile_height = 16,
                                 .format = format,
                                 .flush = {.begin = send_nothing},
                                 .arena = arena,
                                 .arena_size = sizeof arena,
                                 .gamma = gamma,
                                 .region = *region};
    glint_report report;
    CHECK_EQUAL(glint_check(&config, &b->scene, &report), GLINT_OK);
    CHECK(report.shown > 0);
    if (is_black)
        CHECK(strstr(report.sentence, "there is no light") != NULL);
    else
        CHECK(!*report.sentence);
}

static void only_black_is_black(void) {
    static const glint_rectangle whole = {0, 0, 0, 0}, part = {16, 8, 29, 16}, bytes = {10, 13, 22, 11};
    const uint16_t(*const all[3])[GLINT_GAMMA_ENTRIES] = {NULL, glint_gamma_srgb,
                                                          (const uint16_t(*)[GLINT_GAMMA_ENTRIES])raised};
    static box lit, dark;
    raise_black();
    make_box(&lit);
    make_box(&dark);
    dark.scene.light_count = 0;
    dark.scene.ambient = (glint_colour){0, 0, 0};
    dark.scene.background = (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE};
    for (unsigned i = 0; i < 3 * FORMAT_COUNT; i++) {
        const glint_format *const format = every_format[i / 3];
        const int is_whole = glint_row_bytes(format, 2) > 1 && !format_is_paged(format);
        const glint_rectangle *const regions[3] = {&whole, &part, is_whole ? &bytes : &part};
        for (unsigned r = 0; r < TEST_COUNT(regions); r++) {
            expect(&lit, format, all[i % 3], regions[r], 0);
            expect(&dark, format, all[i % 3], regions[r], 1);
        }
    }
}

/* ---- Random scenes ---- */

static void random_scenes(void) {
    static large_scene s;
    uint32_t reported = 0;
    for (uint32_t seed = 1; seed <= 1000 / sample_share(); seed++) {
        large_scene_make(&s, seed);
        const glint_config config = {.width = (uint16_t)s.width,
                                     .height = (uint16_t)s.height,
                                     .tile_width = 16,
                                     .tile_height = 8,
                                     .format = s.format,
                                     .flush = {.begin = send_nothing, .wait = seed & 16 ? wait_for_nothing : NULL},
                                     .gamma = tables[seed / LARGE_KINDS % 2]};
        glint_need need = {0};
        const glint_status status = glint_arena_need(&config, &s.scene, &need);
        const size_t more = (need.one_pass - need.least) * (seed % 5) / 4;
        if (!CHECK(agree(config, &s.scene, status == GLINT_OK ? need.least + more : 1 << 16)) && reported++ < 8) {
            test_write("  seed ");
            test_write_number(seed);
            test_write("\n");
        }
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(every_arena_of_a_box), TEST_CASE(only_black_is_black),
                                      TEST_CASE(random_scenes)};
    return test_run(write, cases, TEST_COUNT(cases));
}
