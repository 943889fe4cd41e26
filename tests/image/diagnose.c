/* SPDX-License-Identifier: MIT */
/* Suite: glint_check names what keeps a scene from being drawn, or makes it black, and finds nothing in sound scenes.
 */
#include "glint_extras.h"
#include "harness.h"
#include "scenes.h"

#include <stdio.h>
#include <string.h>

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

static void begin(patient *p) {
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
                                       .vector = {GLINT_ONE, GLINT_ONE, GLINT_ONE},
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
static glint_report expect(patient *p, glint_status status, const char *word, int object, int light) {
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

#define CASE(spoil, status, word, object, light) \
    {                                            \
        static patient p;                        \
        begin(&p);                               \
        spoil;                                   \
        expect(&p, status, word, object, light); \
    }

static void sound_scenes_have_nothing(void) {
    for (unsigned i = 0; i < scene_count; i++) {
        static patient p;
        begin(&p);
        scene_build(&p.scene, &scene_definitions[i]);
        const glint_report report = expect(&p, GLINT_OK, "", -1, -1);
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
    CASE(p.scene.scene.light_count = 9, GLINT_ERROR_LIGHTS, "8", -1, -1)
    CASE(p.scene.scene.lights = NULL, GLINT_ERROR_NULL, "scene->lights", -1, -1)
    CASE(p.scene.scene.objects = NULL, GLINT_ERROR_NULL, "scene->objects", -1, -1)
    CASE(p.scene.lights[1] = p.scene.lights[0]; p.scene.lights[1].type = NULL;
         p.scene.scene.light_count = 2, GLINT_ERROR_NULL, "type", -1, 1)
    CASE(p.scene.lights[0].vector = ((glint_vector){0, 0, 0}), GLINT_ERROR_DIRECTION, "direction", -1, 0)
    CASE(p.scene.objects[1].mesh = NULL, GLINT_ERROR_NULL, "mesh", 1, -1)
    CASE(p.mesh.normals = NULL, GLINT_ERROR_NULL, "normals", 0, -1)
    static const glint_layout none = {{0}, {0}, {0}, {0}};
    static const glint_layout wrong = {{&glint_type_uint8, arena, 0}, {0}, {0}, {0}},
                              odd = {{0}, {&glint_type_octahedral8, arena, 1}, {0}, {0}};
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
    CASE(p.scene.lights[0].vector = ((glint_vector){0, 0, 0});
         p.scene.objects[1].material = NULL, GLINT_ERROR_NULL, "material", 1, -1)
    CASE(p.scene.scene.camera.near_plane = 0; p.scene.scene.objects = NULL, GLINT_ERROR_NULL, "scene->objects", -1, -1)
    CASE(p.scene.objects[0].pose.m[1][1] = 0; p.scene.objects[1].mesh = NULL, GLINT_ERROR_NULL, "mesh", 1, -1)
}

static void missing_bytes_are_told(void) {
    static patient p;
    glint_need need;
    begin(&p);
    CHECK_EQUAL(glint_arena_need(&p.config, &p.scene.scene, &need), GLINT_OK);
    p.config.arena_size = need.least - 100;
    CHECK_EQUAL(expect(&p, GLINT_ERROR_ARENA, "arena", -1, -1).bytes, 100);
    p.config.arena_size = 50;
    CHECK_EQUAL(expect(&p, GLINT_ERROR_ARENA, "arena", -1, -1).bytes, need.least - 50);
    p.config.arena_size = need.least;
    CHECK_EQUAL(expect(&p, GLINT_OK, "", -1, -1).bytes, 0);
    begin(&p);
    p.config.pixels = arena;
    p.config.arena = arena + 8192;
    p.config.arena_size -= 8192;
    p.config.pixels_size = glint_pixels_need(&p.config) - 7;
    CHECK_EQUAL(expect(&p, GLINT_ERROR_PIXELS, "pixels", -1, -1).bytes, 7);
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

static void black_pictures_have_a_reason(void) {
    CASE(p.scene.scene.light_count = 0, GLINT_OK, "no light", -1, -1)
    CASE(p.scene.lights[0].diffuse = ((glint_colour){0, 0, 0}), GLINT_OK, "lights are black", -1, -1)
    CASE(p.scene.lights[0].diffuse = ((glint_colour){1, 1, 1}), GLINT_OK, "light's colour", -1, 0)
    CASE(memset(&p.scene.materials[0].diffuse, 0, sizeof(glint_colour));
         memset(&p.scene.materials[0].ambient, 0, sizeof(glint_colour));
         memset(&p.scene.materials[0].specular, 0, sizeof(glint_colour)), GLINT_OK, "materials are black", -1, -1)
    CASE(flatten(&p, 0);
         p.scene.lights[0].vector = ((glint_vector){0, 0, -GLINT_ONE}), GLINT_OK, "no light reaches", -1, -1)
}

static void numbers_that_look_like_integers_are_told(void) {
    CASE(p.scene.materials[0].shininess = 32, GLINT_OK, "shininess", 0, -1)
    CASE(p.scene.objects[1].pose = glint_pose_translate(1, 0, 0), GLINT_OK, "pose", 1, -1)
    CASE(p.scene.objects[1].pose = glint_pose_translate(0, 1, 0), GLINT_OK, "pose", 1, -1)
    CASE(p.scene.objects[1].pose = glint_pose_translate(0, 0, -1), GLINT_OK, "pose", 1, -1)
    CASE(p.scene.objects[1].pose = glint_pose_translate(1, 0, GLINT_Q16(-0.5)), GLINT_OK, "", -1, -1)
    CASE(p.scene.lights[0].type = &glint_light_point;
         p.scene.lights[0].vector = ((glint_vector){2, 3, 4}), GLINT_OK, "a light stands", -1, 0)
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(sound_scenes_have_nothing),
        TEST_CASE(errors_have_a_place),
        TEST_CASE(errors_beside_others_are_passed_over),
        TEST_CASE(missing_bytes_are_told),
        TEST_CASE(empty_pictures_have_a_reason),
        TEST_CASE(black_pictures_have_a_reason),
        TEST_CASE(numbers_that_look_like_integers_are_told),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
