/* SPDX-License-Identifier: MIT */
/*
 * Suite: glint_check tells of a frame what drawing it tells: the status for any arena, the pixels that objects cover,
 * and black only where all of it is black, with output tables and without, in every format, of a region too. It names
 * what keeps a scene from being drawn. Objects with nothing to draw are skipped where a configuration says so.
 */
#include "every_format.h"
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "sample.h"
#include "scenes.h"
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
    b->light = (glint_light){&glint_light_directional, {0, 0, 0}, {GLINT_ONE, -GLINT_ONE, -GLINT_ONE}, white, white};
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

static void random_scenes_agree(void) {
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

/* ---- What keeps a scene from being drawn, or makes it black, is named; sound scenes have nothing ---- */

#define WIDTH 96
#define HEIGHT 64

static uint8_t arena[1 << 20];

static int take(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context, (void)x, (void)y, (void)width, (void)height, (void)pixels, (void)stride;
    test_check(0, "nothing is sent", __FILE__, __LINE__);
    return 1;
}

/* A scene that is sound until a case spoils it. */
typedef struct patient {
    glint_config config;
    test_scene scene;
    glint_mesh mesh;
} patient;

static void begin_patient(patient *p) {
    memset(p, 0, sizeof *p);
    p->config = (glint_config){.width = WIDTH,
                               .height = HEIGHT,
                               .format = &glint_format_rgb565,
                               .flush = {.begin = take},
                               .arena = arena,
                               .arena_size = sizeof arena};
    p->mesh = scene_bench_mesh(1)->mesh;
    p->scene.materials[0] = glint_material_paint(&glint_model_blinn_phong, (glint_colour){GLINT_ONE, 0, GLINT_ONE / 2},
                                                 GLINT_ONE / 8, GLINT_Q16(20));
    p->scene.lights[0] = (glint_light){.type = &glint_light_directional,
                                       .direction = {-GLINT_ONE, -GLINT_ONE, -GLINT_ONE},
                                       .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    for (int i = 0; i < 2; i++)
        p->scene.objects[i] = (glint_object){.mesh = &p->mesh,
                                             .material = &p->scene.materials[0],
                                             .evaluation = &glint_per_fragment,
                                             .pose = glint_pose_translate(i * GLINT_ONE, 0, 0)};
    p->scene.scene = (glint_scene){.camera = {.field_of_view = GLINT_Q16(45), .near_plane = GLINT_Q16(0.1)},
                                   .lights = p->scene.lights,
                                   .light_count = 1,
                                   .objects = p->scene.objects,
                                   .object_count = 2};
    p->scene.scene.camera.pose = glint_pose_translate(0, 0, GLINT_Q16(5));
}

/* Holds what is found against the status, a word of the sentence, and what that is about. */
static glint_report expect_found(patient *p, glint_status status, const char *word, int object, int light) {
    glint_report report;
    memset(&report, 0x55, sizeof report);
    CHECK_EQUAL(glint_check(&p->config, &p->scene.scene, &report), status);
    CHECK_EQUAL(report.status, status);
    CHECK_EQUAL(report.object, object);
    CHECK_EQUAL(report.light, light);
    if (!CHECK(*word ? strstr(report.sentence, word) != NULL : !*report.sentence)) {
        test_write("  found: ");
        test_write(report.sentence);
        test_write("\n");
    }
    return report;
}

static void make_parallel(patient *p, glint_q16 view_height) {
    p->scene.scene.camera.projection = &glint_orthographic;
    p->scene.scene.camera.view_height = view_height;
}

#define CASE(spoil, status, word, object, light)       \
    {                                                  \
        static patient p;                              \
        begin_patient(&p);                             \
        spoil;                                         \
        expect_found(&p, status, word, object, light); \
    }

static void sound_scenes_have_nothing(void) {
    for (unsigned i = 0; i < scene_count; i++) {
        static patient p;
        begin_patient(&p);
        scene_build(&p.scene, &scene_definitions[i]);
        const glint_report report = expect_found(&p, GLINT_OK, "", -1, -1);
        CHECK(report.shown > 0);
    }
    CASE((void)0, GLINT_OK, "", -1, -1)
    CASE(p.config.format = &glint_format_mono_pages; p.scene.materials[0].diffuse.g = GLINT_ONE, GLINT_OK, "", -1, -1)
}

static void errors_have_a_place(void) {
    glint_report report;
    CHECK_EQUAL(glint_check(NULL, NULL, NULL), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_check(NULL, NULL, &report), GLINT_ERROR_NULL);
    CHECK(strstr(report.sentence, "configuration") != NULL);
    CASE(p.config.format = NULL, GLINT_ERROR_NULL, "format", -1, -1)
    CASE(p.config.flush.begin = NULL, GLINT_ERROR_NULL, "flush", -1, -1)
    CASE(p.config.arena = NULL, GLINT_ERROR_NULL, "arena", -1, -1)
    CASE(p.config.width = 0, GLINT_ERROR_SIZE, "1024", -1, -1)
    CASE(p.config.tile_width = 12, GLINT_ERROR_TILE, "64", -1, -1)
    CASE(p.config.region.x = 5, GLINT_ERROR_REGION, "region", -1, -1)
    CASE(p.scene.scene.camera.field_of_view = 45, GLINT_ERROR_CAMERA, "GLINT_Q16(60)", -1, -1)
    CASE(p.scene.scene.camera.field_of_view = GLINT_Q16(175), GLINT_ERROR_CAMERA, "170", -1, -1)
    CASE(p.scene.scene.camera.near_plane = 0, GLINT_ERROR_CAMERA, "near", -1, -1)
    CASE(p.scene.scene.camera.pose.m[0][0] = 0, GLINT_ERROR_CAMERA, "axes", -1, -1)
    CASE(make_parallel(&p, 256); p.scene.scene.camera.field_of_view = -5, GLINT_OK, "", -1, -1)
    CASE(make_parallel(&p, INT32_MAX); p.config.arena_size = 0, GLINT_ERROR_ARENA, "arena", -1, -1)
    CASE(make_parallel(&p, 255), GLINT_ERROR_CAMERA, "view height", -1, -1)
    CASE(make_parallel(&p, 0), GLINT_ERROR_CAMERA, "view height", -1, -1)
    CASE(make_parallel(&p, INT32_MIN), GLINT_ERROR_CAMERA, "view height", -1, -1)
    CASE(make_parallel(&p, GLINT_ONE); p.scene.scene.camera.near_plane = 0, GLINT_ERROR_CAMERA, "near plane", -1, -1)
    CASE(p.scene.scene.light_count = 9, GLINT_ERROR_LIGHTS, "8", -1, -1)
    CASE(p.scene.scene.lights = NULL, GLINT_ERROR_NULL, "scene->lights", -1, -1)
    CASE(p.scene.scene.objects = NULL, GLINT_ERROR_NULL, "scene->objects", -1, -1)
    CASE(p.scene.lights[1] = p.scene.lights[0]; p.scene.lights[1].type = NULL;
         p.scene.scene.light_count = 2, GLINT_ERROR_NULL, "type", -1, 1)
    CASE(p.scene.lights[0].direction = ((glint_vector){0, 0, 0}), GLINT_ERROR_DIRECTION, "direction", -1, 0)
    CASE(p.scene.objects[1].mesh = NULL, GLINT_ERROR_NULL, "mesh", 1, -1)
    CASE(p.mesh.normals = NULL, GLINT_ERROR_NULL, "normals", 0, -1)
    static const glint_mesh_layout none = {{0}, {0}, {0}, {0}};
    static const glint_mesh_layout wrong = {{&glint_attribute_uint8, arena, 0}, {0}, {0}, {0}},
                                   odd = {{0}, {&glint_attribute_octahedral8, arena, 1}, {0}, {0}};
    CASE(p.mesh.triangles = NULL; p.mesh.layout = &none, GLINT_ERROR_NULL, "triangles", 0, -1)
    CASE(p.mesh.positions = NULL; p.mesh.layout = &wrong, GLINT_ERROR_TYPE, "type", 0, -1)
    CASE(p.mesh.normals = NULL; p.mesh.layout = &odd, GLINT_ERROR_STRIDE, "stride", 0, -1)
    CASE(p.scene.objects[1].material = NULL, GLINT_ERROR_NULL, "material", 1, -1)
    CASE(p.scene.objects[1].evaluation = NULL, GLINT_ERROR_NULL, "evaluation", 1, -1)
    CASE(p.scene.objects[1].pose.m[1][1] = 0, GLINT_ERROR_POSE, "singular", 1, -1)
    CASE(p.scene.objects[1].pose.m[1][1] = 0; p.scene.objects[1].hidden = 1, GLINT_OK, "", -1, -1)
    CASE(p.mesh.vertex_count = 9, GLINT_ERROR_INDEX, "vertex", 0, -1)
}

/* Of several errors the one that drawing returns. */
static void errors_beside_others_are_passed_over(void) {
    CASE(p.scene.lights[0].direction = ((glint_vector){0, 0, 0});
         p.scene.objects[1].material = NULL, GLINT_ERROR_NULL, "material", 1, -1)
    CASE(p.scene.scene.camera.near_plane = 0; p.scene.scene.objects = NULL, GLINT_ERROR_NULL, "scene->objects", -1, -1)
    CASE(p.scene.objects[0].pose.m[1][1] = 0; p.scene.objects[1].mesh = NULL, GLINT_ERROR_NULL, "mesh", 1, -1)
}

static void missing_bytes_are_told(void) {
    static patient p;
    glint_need need;
    begin_patient(&p);
    CHECK_EQUAL(glint_arena_need(&p.config, &p.scene.scene, &need), GLINT_OK);
    p.config.arena_size = need.least - 100;
    CHECK_EQUAL(expect_found(&p, GLINT_ERROR_ARENA, "arena", -1, -1).bytes, 100);
    p.config.arena_size = 50;
    CHECK_EQUAL(expect_found(&p, GLINT_ERROR_ARENA, "arena", -1, -1).bytes, need.least - 50);
    p.config.arena_size = need.least;
    CHECK_EQUAL(expect_found(&p, GLINT_OK, "", -1, -1).bytes, 0);
    begin_patient(&p);
    p.config.pixels = arena;
    p.config.arena = arena + 8192;
    p.config.arena_size -= 8192;
    p.config.pixels_size = glint_pixels_need(&p.config) - 7;
    CHECK_EQUAL(expect_found(&p, GLINT_ERROR_PIXELS, "pixels", -1, -1).bytes, 7);
}

/* One triangle that faces the eye, or away. */
static void flatten(patient *p, int away) {
    static const int16_t corners[3][3] = {{-32767, -32767, 0}, {32767, -32767, 0}, {0, 32767, 0}},
                         normals[3][3] = {{0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}};
    static const uint16_t order[2][1][3] = {{{0, 1, 2}}, {{0, 2, 1}}};
    p->mesh = (glint_mesh){.positions = corners,
                           .normals = normals,
                           .triangles = order[away],
                           .vertex_count = 3,
                           .triangle_count = 1,
                           .extent = {GLINT_ONE, GLINT_ONE, 0}};
}

static void empty_pictures_have_a_reason(void) {
    CASE(p.scene.scene.object_count = 0, GLINT_OK, "no objects", -1, -1)
    CASE(p.scene.objects[0].hidden = p.scene.objects[1].hidden = 1, GLINT_OK, "hidden", -1, -1)
    CASE(p.scene.scene.camera.pose = glint_pose_translate(0, 0, 5), GLINT_OK, "Q16(4)", -1, -1)
    CASE(p.scene.scene.camera.pose = glint_pose_translate(0, 0, GLINT_Q16(-5)), GLINT_OK, "sees no object", -1, -1)
    CASE(p.mesh.extent = ((glint_vector){1, 1, 1}), GLINT_OK, "extent", 0, -1)
    CASE(flatten(&p, 1), GLINT_OK, "counter-clockwise", -1, -1)
}

static int paint_white(void *context, const glint_tile *tile) {
    (void)context;
    for (int y = 0; y < tile->height; y++)
        memset((uint8_t *)tile->pixels + (size_t)y * tile->stride, 0xff, 2 * (size_t)tile->width);
    return 0;
}

/* The last is as black before a painted background, which a user's program may well have. */
static void black_pictures_have_a_reason(void) {
    CASE(p.scene.scene.light_count = 0, GLINT_OK, "no light", -1, -1)
    CASE(p.scene.lights[0].diffuse = ((glint_colour){0, 0, 0}), GLINT_OK, "lights are black", -1, -1)
    CASE(p.scene.lights[0].diffuse = ((glint_colour){1, 1, 1}), GLINT_OK, "light's colour", -1, 0)
    CASE(memset(&p.scene.materials[0].diffuse, 0, sizeof(glint_colour));
         memset(&p.scene.materials[0].ambient, 0, sizeof(glint_colour));
         memset(&p.scene.materials[0].specular, 0, sizeof(glint_colour)), GLINT_OK, "materials are black", -1, -1)
    CASE(flatten(&p, 0);
         p.scene.lights[0].direction = ((glint_vector){0, 0, GLINT_ONE}), GLINT_OK, "no light reaches", -1, -1)
    CASE(p.scene.scene.light_count = 0; p.config.background.paint = paint_white, GLINT_OK, "no light", -1, -1)
}

static void numbers_that_look_like_integers_are_told(void) {
    CASE(p.scene.materials[0].shininess = 32, GLINT_OK, "shininess", 0, -1)
    CASE(p.scene.objects[1].pose = glint_pose_translate(1, 0, 0), GLINT_OK, "pose", 1, -1)
    CASE(p.scene.objects[1].pose = glint_pose_translate(0, 1, 0), GLINT_OK, "pose", 1, -1)
    CASE(p.scene.objects[1].pose = glint_pose_translate(0, 0, -1), GLINT_OK, "pose", 1, -1)
    CASE(p.scene.objects[1].pose = glint_pose_translate(1, 0, GLINT_Q16(-0.5)), GLINT_OK, "", -1, -1)
    CASE(p.scene.lights[0].type = &glint_light_point;
         p.scene.lights[0].position = ((glint_vector){2, 3, 4}), GLINT_OK, "a light stands", -1, 0)
}

/* ---- Objects with nothing to draw: where they are skipped, a scene is what it is without them; else they are errors
 * ---- */

#define OBJECTS_MAX (2 * SCENE_OBJECTS_MAX + 2)

static const int16_t three[3][3] = {{0, 0, 0}, {32767, 0, 0}, {0, 32767, 0}};
static const uint16_t one_triangle[1][3] = {{0, 1, 2}};

/* What is the matter with an object. */
enum { FLAT_X, FLAT_Y, FLAT_Z, NO_POSE, COLUMNS_ALIKE, NO_VERTICES, NO_TRIANGLES, NO_MESH, EMPTY_AND_FLAT, KINDS };

static glint_mesh meshes[OBJECTS_MAX];

static int is_flat(int kind) {
    return kind <= COLUMNS_ALIKE;
}

/* Makes an object that has nothing to draw: where the first is, of its material. */
static glint_object degenerate(int kind, const glint_object *like, glint_mesh *mesh) {
    glint_object object = *like;
    const glint_q16 one = GLINT_ONE;
    const glint_pose scale[] = {glint_pose_scale(0, one, one), glint_pose_scale(one, 0, one),
                                glint_pose_scale(one, one, 0), glint_pose_scale(0, 0, 0)};
    *mesh = *like->mesh;
    object.mesh = mesh;
    if (kind <= NO_POSE)
        object.pose = glint_pose_then(&scale[kind], &like->pose);
    if (kind == COLUMNS_ALIKE)
        for (int row = 0; row < 3; row++)
            object.pose.m[row][1] = object.pose.m[row][2];
    if (kind == NO_VERTICES || kind == NO_TRIANGLES)
        *mesh =
            (glint_mesh){.positions = three, .normals = three, .triangles = one_triangle, .extent = {one, one, one}};
    if (kind == NO_VERTICES)
        mesh->triangle_count = 1;
    if (kind == NO_TRIANGLES)
        mesh->vertex_count = 3;
    if (kind == NO_MESH || kind == EMPTY_AND_FLAT)
        *mesh = (glint_mesh){.extent = {-1, 0, 0}, .flags = 77};
    if (kind == EMPTY_AND_FLAT)
        object.pose = scale[NO_POSE];
    return object;
}

/* The scene with one such object in front of each of its own and one behind them, of kinds from `kind` on. */
static glint_scene mix(const glint_scene *of, int kind, glint_object *objects) {
    glint_scene scene = *of;
    scene.objects = objects;
    scene.object_count = 0;
    for (uint32_t i = 0; i <= of->object_count; i++) {
        objects[scene.object_count] =
            degenerate((kind + (int)i) % KINDS, &of->objects[i < of->object_count ? i : 0], &meshes[i]);
        scene.object_count++;
        if (i < of->object_count)
            objects[scene.object_count++] = of->objects[i];
    }
    return scene;
}

/* What is picked at some pixels is what is picked without them, and what glint_check finds draws. */
static void check_picks(const glint_config *of, const glint_scene *scene, const glint_scene *without, size_t size) {
    glint_config config = *of;
    glint_renderer renderer;
    glint_report report;
    config.arena = malloc(size);
    config.arena_size = size;
    CHECK_EQUAL(glint_check(&config, scene, &report), GLINT_OK);
    CHECK_EQUAL(report.object, -1);
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    for (int i = 0; i < 12; i++) {
        glint_hit hit = {0, 0, 0}, wanted = {0, 0, 0};
        const int x = (i * 37 + 5) % WIDTH, y = (i * 23 + 9) % HEIGHT;
        CHECK_EQUAL(glint_pick(&renderer, scene, x, y, &hit), glint_pick(&renderer, without, x, y, &wanted));
        CHECK(scene->objects[hit.object].mesh == without->objects[wanted.object].mesh || !hit.depth);
        CHECK_EQUAL(hit.triangle, wanted.triangle);
        CHECK_EQUAL(hit.depth, wanted.depth);
    }
    free(config.arena);
}

static void check_needs(const glint_config *config, const glint_scene *scene, const glint_scene *without,
                        glint_need *need) {
    glint_need wanted;
    CHECK_EQUAL(glint_arena_need(config, scene, need), GLINT_OK);
    CHECK_EQUAL(glint_arena_need(config, without, &wanted), GLINT_OK);
    CHECK(!memcmp(need, &wanted, sizeof wanted));
}

static void check_skipped(const glint_scene *without, int kind, const glint_format *format) {
    glint_object objects[OBJECTS_MAX];
    const glint_scene scene = mix(without, kind, objects);
    picture wanted = picture_open(WIDTH, HEIGHT, format);
    picture_options options = {.tile_width = 16, .tile_height = 16, .skips_degenerate = 1};
    const glint_config config = picture_config(&wanted, &options);
    glint_need need = {0, 0, 0};
    check_needs(&config, &scene, without, &need);
    for (uint32_t third = 0; third <= 3; third++) {
        glint_stats stats, plain;
        options.arena_size = picture_arena(&need, 256 * third / 3);
        CHECK_EQUAL(picture_render(&wanted, without, &options, &plain), GLINT_OK);
        CHECK(picture_draws_same(&wanted, &scene, &options, &stats));
        CHECK_EQUAL(plain.skipped, 0);
        CHECK_EQUAL(stats.skipped, without->object_count + 1);
        CHECK(stats.hidden >= plain.hidden + stats.skipped);
    }
    check_picks(&config, &scene, without, need.one_pass);
    picture_close(&wanted);
}

static void skipped_in_scenes(void) {
    for (unsigned i = 0; i < scene_count; i++) {
        static test_scene s;
        scene_build(&s, &scene_definitions[i]);
        check_skipped(&s.scene, (int)(i % KINDS), i % 2 ? &glint_format_rgb888 : &glint_format_rgb565);
    }
}

static void skipped_in_random_scenes(void) {
    for (uint32_t seed = 1; seed <= 60; seed++) {
        static test_scene s;
        scene_build_random(&s, seed);
        check_skipped(&s.scene, (int)(seed % KINDS), seed % 2 ? &glint_format_rgb565 : &glint_format_grey8);
    }
}

/* A frame of the caller's tells them too; where nothing else is there, all of it is background, and that is said. */
static void nothing_else(void) {
    static test_scene s;
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    glint_config config = picture_config(&image, NULL);
    scene_build(&s, &scene_definitions[0]);
    config.skips_degenerate = 1;
    config.arena_size = 1 << 16;
    config.arena = malloc(config.arena_size);
    for (int kind = 0; kind < KINDS; kind++) {
        glint_scene scene = s.scene;
        glint_object object = degenerate(kind, &s.objects[0], &meshes[0]);
        glint_frame frame;
        glint_report report;
        glint_renderer renderer;
        glint_hit hit;
        scene.objects = &object;
        scene.object_count = 1;
        CHECK_EQUAL(glint_frame_begin(&frame, &config, &scene), GLINT_OK);
        CHECK_EQUAL(frame.stats.skipped, 1);
        CHECK_EQUAL(glint_frame_next_pass(&frame), 1);
        CHECK_EQUAL(frame.stats.hidden, 1);
        CHECK_EQUAL(glint_frame_next_pass(&frame), 0);
        CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
        CHECK_EQUAL(glint_pick(&renderer, &scene, WIDTH / 2, HEIGHT / 2, &hit), 0);
        CHECK_EQUAL(glint_check(&config, &scene, &report), GLINT_OK);
        CHECK_EQUAL(report.shown, 0);
        CHECK(strstr(report.sentence, "skipped") != NULL);
        object.hidden = 1;
        CHECK_EQUAL(glint_frame_begin(&frame, &config, &scene), GLINT_OK);
        CHECK_EQUAL(frame.stats.skipped, 0);
    }
    free(config.arena);
    picture_close(&image);
}

/* Where it is not asked for they are errors, for all who look; hidden ones are none. */
static void errors_unasked(void) {
    static test_scene s;
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    glint_config config = picture_config(&image, NULL);
    scene_build(&s, &scene_definitions[0]);
    config.arena_size = 1 << 16;
    config.arena = malloc(config.arena_size);
    for (int kind = 0; kind < KINDS; kind++) {
        glint_object objects[OBJECTS_MAX];
        glint_scene scene = s.scene;
        glint_frame frame;
        glint_report report;
        glint_renderer renderer;
        glint_hit hit;
        glint_need need;
        const int wanted = is_flat(kind)                               ? GLINT_ERROR_POSE
                           : kind == NO_MESH || kind == EMPTY_AND_FLAT ? GLINT_ERROR_NULL
                                                                       : GLINT_ERROR_MESH;
        scene.objects = objects;
        scene.object_count = 2;
        objects[0] = s.objects[0];
        objects[1] = degenerate(kind, &s.objects[0], &meshes[0]);
        CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
        CHECK_EQUAL(glint_render(&renderer, &scene), wanted);
        CHECK_EQUAL(glint_pick(&renderer, &scene, 1, 1, &hit), wanted);
        CHECK_EQUAL(glint_frame_begin(&frame, &config, &scene), wanted);
        CHECK_EQUAL(glint_arena_need(&config, &scene, &need), wanted);
        CHECK_EQUAL(glint_check(&config, &scene, &report), wanted);
        CHECK_EQUAL(report.object, 1);
        objects[1].hidden = 1;
        CHECK_EQUAL(glint_render(&renderer, &scene), is_flat(kind) ? GLINT_OK : wanted);
        CHECK_EQUAL(renderer.stats.skipped, 0);
    }
    free(config.arena);
    picture_close(&image);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(every_arena_of_a_box),
        TEST_CASE(only_black_is_black),
        TEST_CASE(random_scenes_agree),
        TEST_CASE(sound_scenes_have_nothing),
        TEST_CASE(errors_have_a_place),
        TEST_CASE(errors_beside_others_are_passed_over),
        TEST_CASE(missing_bytes_are_told),
        TEST_CASE(empty_pictures_have_a_reason),
        TEST_CASE(black_pictures_have_a_reason),
        TEST_CASE(numbers_that_look_like_integers_are_told),
        TEST_CASE(skipped_in_scenes),
        TEST_CASE(skipped_in_random_scenes),
        TEST_CASE(nothing_else),
        TEST_CASE(errors_unasked),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
