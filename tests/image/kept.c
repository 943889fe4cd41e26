/* SPDX-License-Identifier: MIT */
/*
 * Suite: a renderer that keeps its arena draws what a new one draws, whatever changed since its last frame.
 */
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "random.h"
#include "sample.h"
#include "scenes.h"

#include <stdlib.h>

#define WIDTH 96
#define HEIGHT 64

/* A renderer with an arena of its own, and what it draws into. */
typedef struct keeper {
    picture image;
    glint_renderer renderer;
    void *arena;
} keeper;

static void keeper_open(keeper *k, const glint_format *format, size_t arena_size) {
    k->image = picture_open(WIDTH, HEIGHT, format);
    glint_config config = picture_config(&k->image, NULL);
    k->arena = malloc(arena_size);
    CHECK(k->arena != NULL);
    config.arena = k->arena;
    config.arena_size = arena_size;
    config.keeps_arena = 1;
    CHECK_EQUAL(glint_init(&k->renderer, &config), GLINT_OK);
}

static void keeper_close(keeper *k) {
    free(k->arena);
    picture_close(&k->image);
}

/* Two tori, each of a material of its own. */
static void build(test_scene *scene) {
    scene_build_named(scene, "mirrored");
    scene->objects[1] = scene->objects[0];
    scene->objects[1].material = &scene->materials[1];
    scene->objects[1].pose.m[0][3] += GLINT_ONE / 2;
    scene->objects[1].pose.m[2][3] -= GLINT_ONE;
    scene->scene.object_count = 2;
    scene->lights[1] = scene->lights[0];
    scene->lights[1].direction.x = -scene->lights[0].direction.x;
}

/* ---- What may change from frame to frame ---- */

static const glint_colour black = {0, 0, 0}, white = {GLINT_ONE, GLINT_ONE, GLINT_ONE};

#define CHANGE(name, what)            \
    static void name(test_scene *s) { \
        what;                         \
    }

CHANGE(nothing, (void)s)
CHANGE(pose, s->objects[0].pose.m[0][3] += GLINT_ONE / 4)
CHANGE(camera, s->scene.camera.field_of_view += 5 * GLINT_ONE)
CHANGE(shininess, s->materials[0].shininess *= 3)
CHANGE(low_shininess, s->materials[1].shininess = GLINT_ONE)
CHANGE(specular, s->materials[0].specular.g /= 2)
CHANGE(brighter_specular, s->materials[0].specular.r = 4 * GLINT_ONE)
CHANGE(no_specular, s->materials[1].specular = black)
CHANGE(diffuse, s->materials[1].diffuse.b = GLINT_ONE)
CHANGE(ambient, s->materials[0].ambient.r += GLINT_ONE / 4)
CHANGE(ambient_light, s->scene.ambient.b /= 2)
CHANGE(light_colour, s->lights[0].diffuse.r /= 2)
CHANGE(light_specular, s->lights[0].specular.b /= 4)
CHANGE(light_direction, s->lights[0].direction.y = -s->lights[0].direction.y)
CHANGE(two_lights, s->scene.light_count = 2)
CHANGE(one_light, s->scene.light_count = 1)
/* Of two lights of the same colours one shows. */
CHANGE(only_second_light, s->scene.light_count = 2; s->lights[1].diffuse = s->lights[1].specular = white;
       s->lights[0].diffuse = s->lights[0].specular = black)
CHANGE(only_first_light, s->scene.light_count = 2; s->lights[0].diffuse = s->lights[0].specular = white;
       s->lights[1].diffuse = s->lights[1].specular = black)
CHANGE(no_light, s->scene.light_count = 0)
CHANGE(model, s->materials[0].model = &glint_model_phong)
CHANGE(lambert, s->materials[0].model = &glint_model_lambert)
CHANGE(blinn_phong, s->materials[0].model = &glint_model_blinn_phong)
/* Its colour happens to be what the ambient light of the next change gives. */
CHANGE(unlit, s->materials[0].model = &glint_model_unlit; s->materials[0].diffuse = s->scene.ambient)
CHANGE(unlit_ambient, s->materials[0].ambient = white)
CHANGE(unlit_colour, s->materials[0].diffuse.g = GLINT_ONE / 8)
CHANGE(flags, s->materials[1].flags = GLINT_MATERIAL_SPECULAR_UNGATED)
CHANGE(no_flags, s->materials[1].flags = 0)
CHANGE(other_order, const glint_object first = s->objects[0]; s->objects[0] = s->objects[1]; s->objects[1] = first)
CHANGE(same_material, s->objects[1].material = s->objects[0].material)
CHANGE(third_material, s->materials[2] = s->materials[1]; s->materials[2].specular.r += GLINT_ONE / 8;
       s->objects[1].material = &s->materials[2])
CHANGE(fewer_objects, s->scene.object_count = 1)
CHANGE(no_objects, s->scene.object_count = 0)
CHANGE(more_objects, s->scene.object_count = 2)
CHANGE(evaluation, s->objects[0].evaluation = &glint_per_vertex)
CHANGE(per_fragment, s->objects[0].evaluation = &glint_per_fragment)
CHANGE(both_per_vertex, s->objects[0].evaluation = s->objects[1].evaluation = &glint_per_vertex)
CHANGE(second_per_fragment, s->objects[1].evaluation = &glint_per_fragment)
CHANGE(infinite_viewer, s->scene.viewer = GLINT_VIEWER_INFINITE)

/* A mesh in RAM, whose vertices move: the arrays are the same, and their numbers are not. */
static void moving_mesh(test_scene *s) {
    static int16_t positions[BENCH_VERTICES_MAX][3];
    static glint_mesh mesh;
    static int round;
    mesh = scene_bench_mesh(1)->mesh;
    round++;
    for (uint32_t i = 0; i < mesh.vertex_count; i++)
        for (int axis = 0; axis < 3; axis++)
            positions[i][axis] = (int16_t)(mesh.positions[i][axis] / (1 + (round + axis) % 3));
    mesh.positions = (const int16_t(*)[3])positions;
    s->objects[0].mesh = &mesh;
}

typedef void (*change)(test_scene *scene);

/* clang-format off */
static const change changes[] = {
    nothing, pose, camera, shininess, low_shininess, specular, brighter_specular, no_specular, diffuse, ambient,
    ambient_light, light_colour, light_specular, light_direction, two_lights, one_light, no_light, one_light, model,
    lambert, blinn_phong, unlit, unlit_ambient, unlit_colour, blinn_phong, flags, no_flags, other_order,
    same_material, third_material, fewer_objects, more_objects, no_objects, more_objects, evaluation, per_fragment,
    two_lights, specular, blinn_phong, both_per_vertex, third_material, per_fragment, fewer_objects, more_objects,
    second_per_fragment, per_fragment, only_second_light, only_first_light, infinite_viewer, only_second_light,
    moving_mesh, moving_mesh, moving_mesh
};
/* clang-format on */

#define CHANGES (sizeof changes / sizeof changes[0])

/* Draws a frame with the keeper and with a new renderer. @return are they the same? */
static int draws_the_same(keeper *k, const glint_scene *scene) {
    picture wanted = picture_open(WIDTH, HEIGHT, k->image.format);
    CHECK_EQUAL(picture_render(&wanted, scene, NULL, NULL), GLINT_OK);
    CHECK_EQUAL(glint_render(&k->renderer, scene), GLINT_OK);
    const int same = picture_equal(&wanted, &k->image);
    picture_close(&wanted);
    return same;
}

static const glint_format *const formats[] = {&glint_format_rgb565, &glint_format_rgb565_be, &glint_format_rgb888};

/* One change after the other, in their order and in others, with arenas with room for tables and without. */
static void every_change_shows(void) {
    random_state = 1;
    for (uint32_t run = 0; run < 36; run++) {
        test_scene scene;
        keeper k;
        build(&scene);
        keeper_open(&k, formats[run % 3], run % 4 == 3 ? 20000 : 200000);
        for (uint32_t i = 0; i < CHANGES; i++) {
            const uint32_t which = run < 3 ? i : below(CHANGES);
            changes[which](&scene);
            if (scene.materials[0].shininess > 1000 * GLINT_ONE)
                scene.materials[0].shininess = 2 * GLINT_ONE;
            if (scene.scene.camera.field_of_view > 120 * GLINT_ONE)
                scene.scene.camera.field_of_view = 40 * GLINT_ONE;
            if (!CHECK(draws_the_same(&k, &scene.scene)))
                break;
        }
        keeper_close(&k);
    }
}

/* A frame that is begun again and again, and drawn tile by tile. */
typedef struct beginner {
    keeper keeper;
    glint_frame frame;
    glint_workspace workspace;
    void *memory;
} beginner;

static void beginner_open(beginner *b, const glint_format *format) {
    keeper_open(&b->keeper, format, 200000);
    b->frame = (glint_frame){0};
    b->memory = malloc(glint_workspace_size(&b->keeper.renderer.config));
    CHECK(b->memory != NULL);
    glint_workspace_init(&b->workspace, &b->keeper.renderer.config, b->memory);
}

static void beginner_close(beginner *b) {
    free(b->memory);
    keeper_close(&b->keeper);
}

static int begin(beginner *b, const glint_scene *scene) {
    return glint_frame_begin(&b->frame, &b->keeper.renderer.config, scene);
}

static int draws_the_same_tiles(beginner *b, const glint_scene *scene) {
    picture wanted = picture_open(WIDTH, HEIGHT, b->keeper.image.format);
    CHECK_EQUAL(picture_render(&wanted, scene, NULL, NULL), GLINT_OK);
    int status = begin(b, scene);
    CHECK_EQUAL(status, GLINT_OK);
    while (status >= 0 && (status = glint_frame_next_pass(&b->frame)) > 0) {
        for (uint32_t tile = b->frame.tile_first; tile < b->frame.tile_end; tile++) {
            int to[4];
            if (!glint_render_tile(&b->frame, &b->workspace, tile))
                continue;
            glint_tile_rectangle(&b->frame, tile, &to[0], &to[1], &to[2], &to[3]);
            CHECK_EQUAL(picture_put(&b->keeper.image, to, b->workspace.pixels, b->workspace.stride), 0);
        }
    }
    CHECK_EQUAL(status, 0);
    const int same = picture_equal(&wanted, &b->keeper.image);
    picture_close(&wanted);
    return same;
}

static void frames_begun_again(void) {
    for (unsigned i = 0; i < 3; i++) {
        test_scene scene;
        beginner b;
        build(&scene);
        beginner_open(&b, formats[i]);
        for (uint32_t which = 0; which < CHANGES; which++) {
            changes[which](&scene);
            CHECK(draws_the_same_tiles(&b, &scene.scene));
        }
        beginner_close(&b);
    }
}

/* Bytes that the scene needs to be drawn in one pass, and as many for frames that follow. */
static size_t need_of(const glint_scene *scene, const glint_format *format) {
    glint_need need = {0};
    picture image = picture_open(WIDTH, HEIGHT, format);
    glint_config config = picture_config(&image, NULL);
    config.keeps_arena = 1;
    CHECK_EQUAL(glint_arena_need(&config, scene, &need), GLINT_OK);
    picture_close(&image);
    return need.one_pass;
}

/* What another part of a program writes into the arena between two frames spoils none: bytes all over the arena. */
static void spoilt_arenas(void) {
    for (unsigned i = 0; i < 3; i++) {
        test_scene scene;
        keeper k;
        build(&scene);
        const size_t size = need_of(&scene.scene, formats[i]);
        keeper_open(&k, formats[i], size);
        CHECK(draws_the_same(&k, &scene.scene));
        for (size_t at = 0; at < size; at += (i ? 31 : 7) * sample_share()) {
            ((uint8_t *)k.arena)[at] ^= (uint8_t)(1 + at % 255);
            if (!CHECK(draws_the_same(&k, &scene.scene)))
                break;
        }
        keeper_close(&k);
    }
}

/* Sets up two lights, of which the first's highlight is faint; with this shininess a bright one's table is made twice
 * as wide. */
static void build_faint(test_scene *scene) {
    build(scene);
    scene->scene.light_count = 2;
    scene->materials[0].shininess = 26 * GLINT_ONE;
    scene->materials[0].specular = (glint_colour){0, 2 * GLINT_ONE, 0};
    scene->lights[0].specular.g = scene->lights[1].specular.g = GLINT_ONE / 128;
}

/* The first light becomes bright, and the second one so bright that the frame fails: when the first was set already. */
static void make_too_bright(test_scene *scene) {
    scene->lights[0].specular.g = 8 * GLINT_ONE;
    scene->lights[1].specular.g = 9 * GLINT_ONE;
}

static void failed_frames_are_not_kept(void) {
    test_scene scene;
    keeper k;
    beginner b;
    keeper_open(&k, &glint_format_rgb888, 200000);
    beginner_open(&b, &glint_format_rgb888);
    build_faint(&scene);
    CHECK(draws_the_same(&k, &scene.scene));
    CHECK(draws_the_same_tiles(&b, &scene.scene));
    make_too_bright(&scene);
    CHECK_EQUAL(glint_render(&k.renderer, &scene.scene), GLINT_ERROR_COLOUR);
    CHECK_EQUAL(begin(&b, &scene.scene), GLINT_ERROR_COLOUR);
    scene.lights[1].specular.g = GLINT_ONE / 128;
    CHECK(draws_the_same(&k, &scene.scene));
    CHECK(draws_the_same_tiles(&b, &scene.scene));
    beginner_close(&b);
    keeper_close(&k);
}

/* A frame in exactly the arena that it needs takes one pass, whatever the frames before it were. */
static void room_is_given_back(void) {
    for (unsigned which = 0; which < CHANGES; which++) {
        test_scene scene, before;
        keeper k;
        build(&scene);
        build(&before);
        before.scene.object_count = 1;
        changes[which](&before);
        keeper_open(&k, &glint_format_rgb888, need_of(&scene.scene, &glint_format_rgb888));
        if (glint_render(&k.renderer, &before.scene) == GLINT_ERROR_ARENA)
            CHECK_EQUAL(k.renderer.stats.passes, 0);
        CHECK(draws_the_same(&k, &scene.scene));
        CHECK_EQUAL(k.renderer.stats.passes, 1);
        keeper_close(&k);
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(every_change_shows),         TEST_CASE(frames_begun_again), TEST_CASE(spoilt_arenas),
        TEST_CASE(failed_frames_are_not_kept), TEST_CASE(room_is_given_back),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
