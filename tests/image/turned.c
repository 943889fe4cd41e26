/* SPDX-License-Identifier: MIT */
/*
 * Suite: what a scene needs with its objects turned in any way. No pose of hundreds ever needs more, frames keep to
 * what the bounds promise, and these are not far above.
 */
#include "bench.h"
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "scenes.h"
#include "scenes/scenes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define OBJECTS_MAX 40

static uint32_t random_state;

/* From a to b, by a linear congruential generator (Numerical Recipes). */
static double between(double a, double b) {
    random_state = random_state * 1664525u + 1013904223u;
    return a + (b - a) * (random_state >> 8) / 16777216.0;
}

/* A rotation, each as likely as another (Shoemake, 1992). */
static void random_rotation(double m[3][3]) {
    const double tau = 6.28318530717958647692;
    const double u = between(0, 1), a = between(0, tau), b = between(0, tau);
    const double x = sqrt(1 - u) * sin(a), y = sqrt(1 - u) * cos(a), z = sqrt(u) * sin(b), w = sqrt(u) * cos(b);
    const double rows[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                               {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                               {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    memcpy(m, rows, sizeof rows);
}

/* A pose turned about its object's origin. */
static void turn_at_random(const glint_pose *pose, glint_pose *turned) {
    double m[3][3];
    random_rotation(m);
    *turned = *pose;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double sum = 0;
            for (int k = 0; k < 3; k++)
                sum += m[i][k] * pose->m[k][j];
            turned->m[i][j] = (glint_q16)lrint(sum);
        }
}

static size_t larger_of(size_t a, size_t b) {
    return a > b ? a : b;
}

/* The scene with objects of its own. */
typedef struct copy {
    glint_object objects[OBJECTS_MAX];
    glint_scene scene;
} copy;

static void make_copy(copy *to, const glint_scene *scene) {
    to->scene = *scene;
    CHECK(scene->object_count <= OBJECTS_MAX);
    memcpy(to->objects, scene->objects, scene->object_count * sizeof *to->objects);
    to->scene.objects = to->objects;
}

/* Draws a pose with arenas of the bounds: one pass, and vertices transformed once a frame. */
static void check_frames(const glint_scene *scene, int width, int height, const glint_need *bound) {
    picture image = picture_open(width, height, &glint_format_rgb565);
    glint_stats once = {0}, stats = {0};
    picture_options options = {.arena_size = bound->one_pass};
    CHECK_EQUAL(picture_render(&image, scene, &options, &once), GLINT_OK);
    CHECK_EQUAL(once.passes, 1);
    options.arena_size = bound->resident;
    CHECK_EQUAL(picture_render(&image, scene, &options, &stats), GLINT_OK);
    CHECK_EQUAL(stats.vertices, once.vertices);
    picture_close(&image);
}

static void check_turns(const char *name, const glint_scene *scene, int width, int height, int turns) {
    static copy turned;
    picture image = picture_open(width, height, &glint_format_rgb565);
    const glint_config config = picture_config(&image, NULL);
    glint_need bound = {0}, most = {0};
    char line[160];
    make_copy(&turned, scene);
    random_state = 1;
    CHECK_EQUAL(glint_arena_need_turned(&config, scene, &bound), GLINT_OK);
    CHECK(bound.least <= bound.resident && bound.resident <= bound.one_pass);
    for (int i = 0; i < turns; i++) {
        glint_need need = {0}, again = {0};
        for (uint32_t j = 0; j < scene->object_count; j++)
            turn_at_random(&scene->objects[j].pose, &turned.objects[j].pose);
        CHECK_EQUAL(glint_arena_need(&config, &turned.scene, &need), GLINT_OK);
        CHECK_EQUAL(need.least, bound.least);
        CHECK_AT_MOST(need.resident, bound.resident);
        CHECK_AT_MOST(need.one_pass, bound.one_pass);
        most.resident = larger_of(most.resident, need.resident);
        most.one_pass = larger_of(most.one_pass, need.one_pass);
        if (i % 100)
            continue;
        check_frames(&turned.scene, width, height, &bound);
        CHECK_EQUAL(glint_arena_need_turned(&config, &turned.scene, &again), GLINT_OK); /* the same from any pose */
        CHECK(fabs((double)again.one_pass - (double)bound.one_pass) <= 0.02 * (double)bound.one_pass);
    }
    snprintf(line, sizeof line, "%-36s %8zu | %8zu %8zu %5.2f | %8zu %8zu %5.2f\n", name, bound.least, most.resident,
             bound.resident, (double)bound.resident / (double)most.resident, most.one_pass, bound.one_pass,
             (double)bound.one_pass / (double)most.one_pass);
    test_write(line);
    picture_close(&image);
}

static void print_heading(void) {
    test_write("                                        least | resident    bound       | one pass    bound\n");
}

static void bench_scenes(void) {
    print_heading();
    for (int which = 0; which < BENCH_SCENES; which++)
        for (int small = 0; small < 2; small++) {
            bench_scene scene;
            char name[80];
            const int width = small ? 128 : 320, height = small ? 64 : 240;
            bench_build_scene(&scene, &bench_definitions[which], scene_clustered_mesh(which), 3);
            snprintf(name, sizeof name, "%s %dx%d", bench_definitions[which].name, width, height);
            check_turns(name, &scene.scene, width, height, 300);
        }
}

/* Clipped, mirrored, stretched and many objects. */
static void test_scenes(void) {
    print_heading();
    for (unsigned i = 0; i < scene_count; i++) {
        test_scene scene;
        scene_build(&scene, &scene_definitions[i]);
        check_turns(scene_definitions[i].name, &scene.scene, 160, 120, 100);
    }
}

static void example_variants(void) {
    static example_stage stage;
    print_heading();
    for (unsigned i = 0; i < EXAMPLE_SCENES; i++) {
        const example_scene *scene = example_scenes[i];
        scene->build(&stage, 0, 0);
        check_turns(scene->name, &stage.scene, scene->width, scene->height, 40);
    }
}

/* A box before the eye, in all sizes: triangles of one tile to such as reach the guard band. */
static void boxes(void) {
    static int16_t positions[24][3], normals[24][3];
    static uint16_t triangles[12][3];
    const glint_mesh_room room = {positions, normals, triangles, 24, 12};
    static glint_mesh mesh;
    const glint_material paint = {.model = &glint_model_unlit};
    print_heading();
    for (int i = 0; i < 12; i++) {
        char name[80];
        const double size = 0.01 * pow(2, i);
        CHECK_EQUAL(glint_generate_box(&mesh, &room, bench_q16(size), bench_q16(0.7 * size), bench_q16(0.4 * size)),
                    GLINT_OK);
        const glint_object object = {.mesh = &mesh,
                                     .material = &paint,
                                     .evaluation = &glint_per_fragment,
                                     .pose = glint_pose_translate(GLINT_ONE, 0, 0)};
        const glint_scene scene = {.camera = {.pose = glint_pose_translate(0, 0, 8 * GLINT_ONE),
                                              .field_of_view = 50 * GLINT_ONE,
                                              .near_plane = GLINT_ONE / 8},
                                   .objects = &object,
                                   .object_count = 1};
        snprintf(name, sizeof name, "box of %.2f at 8", 2 * size);
        check_turns(name, &scene, 240, 240, 300);
    }
}

/* A box before the eye, of a unit that is a power of two. */
typedef void build_box(glint_q16 unit, glint_mesh *mesh, glint_object *object, glint_camera *camera);

/* Before the middle of the screen. */
static void build_near(glint_q16 unit, glint_mesh *mesh, glint_object *object, glint_camera *camera) {
    mesh->extent = (glint_vector){2 * unit, unit, unit / 2};
    object->pose = glint_pose_translate(unit, 0, 0);
    *camera = (glint_camera){glint_pose_translate(0, 0, 7 * unit), 50 * GLINT_ONE, 2 * unit};
}

/* Far beside its origin: it turns past the guard band before it reaches the near plane. */
static void build_beside(glint_q16 unit, glint_mesh *mesh, glint_object *object, glint_camera *camera) {
    mesh->extent = (glint_vector){468 * unit, 460 * unit, 746 * unit};
    mesh->offset = (glint_vector){723 * unit, 414 * unit, 727 * unit};
    object->pose = glint_pose_translate(0, 0, -1079 * unit);
    *camera = (glint_camera){glint_pose_translate(0, 0, 1079 * unit), 43 * GLINT_ONE, unit / 4};
}

static void check_sizes(build_box *build, int first, int last) {
    static int16_t positions[24][3], normals[24][3];
    static uint16_t triangles[12][3];
    const glint_mesh_room room = {positions, normals, triangles, 24, 12};
    const glint_material paint = {.model = &glint_model_unlit};
    picture image = picture_open(240, 240, &glint_format_rgb565);
    const glint_config config = picture_config(&image, NULL);
    glint_need least = {0};
    for (int i = first; i <= last; i++) {
        glint_mesh mesh;
        glint_object object = {.mesh = &mesh, .material = &paint, .evaluation = &glint_per_fragment};
        glint_scene scene = {.objects = &object, .object_count = 1};
        glint_need bound = {0};
        CHECK_EQUAL(glint_generate_box(&mesh, &room, GLINT_ONE, GLINT_ONE, GLINT_ONE), GLINT_OK);
        build(1 << i, &mesh, &object, &scene.camera);
        CHECK_EQUAL(glint_arena_need_turned(&config, &scene, &bound), GLINT_OK);
        least = i > first ? least : bound;
        CHECK(fabs((double)bound.one_pass - (double)least.one_pass) <= 0.01 * (double)least.one_pass);
        CHECK(fabs((double)bound.resident - (double)least.resident) <= 0.01 * (double)least.resident);
    }
    picture_close(&image);
}

/* All that is 2^n times as large and as far needs the same, up to what lengths are rounded to. */
static void sizes_need_the_same(void) {
    check_sizes(build_near, 15, 28);
    check_sizes(build_beside, 10, 20);
}

/* An edge is as long whichever of its mesh's axes are which. */
static void axes_need_the_same(void) {
    static const int16_t corners[3][3] = {{-32767, -20000, 1000}, {-30000, 32767, 0}, {-25000, 9000, 32767}};
    static const uint16_t triangles[1][3] = {{0, 1, 2}};
    const glint_material paint = {.model = &glint_model_unlit};
    picture image = picture_open(320, 320, &glint_format_rgb565);
    const glint_config config = picture_config(&image, &(picture_options){.tile_width = 8, .tile_height = 8});
    glint_need first = {0};
    for (int turn = 0; turn < 3; turn++) {
        int16_t turned[3][3];
        for (int i = 0; i < 3; i++)
            for (int c = 0; c < 3; c++)
                turned[i][c] = corners[i][(c + turn) % 3];
        const glint_mesh mesh = {.positions = (const int16_t(*)[3])turned,
                                 .normals = (const int16_t(*)[3])turned,
                                 .triangles = triangles,
                                 .vertex_count = 3,
                                 .triangle_count = 1,
                                 .extent = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
        const glint_object object = {.mesh = &mesh,
                                     .material = &paint,
                                     .evaluation = &glint_per_fragment,
                                     .pose = glint_pose_translate(0, 0, -8 * GLINT_ONE)};
        const glint_scene scene = {
            .camera = {.pose = glint_pose_identity(), .field_of_view = 50 * GLINT_ONE, .near_plane = GLINT_ONE / 8},
            .objects = &object,
            .object_count = 1};
        glint_need bound = {0};
        CHECK_EQUAL(glint_arena_need_turned(&config, &scene, &bound), GLINT_OK);
        first = turn ? first : bound;
        CHECK_EQUAL(bound.one_pass, first.one_pass);
    }
    picture_close(&image);
}

/* Squares that all lie in one quarter of the tiles need as much in each, and are transformed once a frame there. */
static void quarters_need_the_same(void) {
    const glint_mesh square = scene_square_mesh(28 * GLINT_ONE, GLINT_ONE);
    const glint_material paint = {.model = &glint_model_unlit};
    picture image = picture_open(64, 256, &glint_format_rgb565);
    picture_options options = {.tile_width = 8, .tile_height = 8};
    glint_config config = picture_config(&image, &options);
    glint_object objects[OBJECTS_MAX];
    const glint_scene scene = {.camera = {.pose = glint_pose_identity(),
                                          .near_plane = GLINT_ONE,
                                          .projection = &glint_orthographic,
                                          .view_height = 256 * GLINT_ONE},
                               .objects = objects,
                               .object_count = OBJECTS_MAX};
    glint_need first = {0};
    for (int quarter = 0; quarter < 4; quarter++) {
        for (int i = 0; i < OBJECTS_MAX; i++)
            objects[i] =
                (glint_object){.mesh = &square,
                               .material = &paint,
                               .evaluation = &glint_per_fragment,
                               .pose = glint_pose_translate(0, (96 - 64 * quarter) * GLINT_ONE, -(2 + i) * GLINT_ONE)};
        glint_need need = {0};
        glint_stats stats = {0};
        CHECK_EQUAL(glint_arena_need(&config, &scene, &need), GLINT_OK);
        first = quarter ? first : need;
        CHECK(need.least < need.resident);
        CHECK_EQUAL(need.resident, first.resident);
        options.arena_size = need.resident;
        CHECK_EQUAL(picture_render(&image, &scene, &options, &stats), GLINT_OK);
        CHECK_EQUAL(stats.vertices, 4 * OBJECTS_MAX);
    }
    picture_close(&image);
}

static void errors_are_those_of_need(void) {
    static test_scene scene;
    static glint_mesh mesh;
    picture image = picture_open(32, 32, &glint_format_rgb565);
    glint_config config = picture_config(&image, NULL);
    glint_need need = {1, 2, 3};
    scene_build(&scene, &scene_definitions[0]);
    CHECK_EQUAL(glint_arena_need_turned(NULL, &scene.scene, &need), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_arena_need_turned(&config, NULL, &need), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_arena_need_turned(&config, &scene.scene, NULL), GLINT_ERROR_NULL);
    mesh = *scene.objects[0].mesh;
    mesh.vertex_count--;
    mesh.clusters = NULL;
    scene.objects[0].mesh = &mesh;
    CHECK_EQUAL(glint_arena_need_turned(&config, &scene.scene, &need), GLINT_ERROR_INDEX);
    scene.objects[0].pose = (glint_pose){{{0}}};
    CHECK_EQUAL(glint_arena_need_turned(&config, &scene.scene, &need), GLINT_ERROR_POSE);
    config.tile_width = 7;
    CHECK_EQUAL(glint_arena_need_turned(&config, &scene.scene, &need), GLINT_ERROR_TILE);
    CHECK(need.least == 1 && need.resident == 2 && need.one_pass == 3);
    picture_close(&image);
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(bench_scenes),           TEST_CASE(test_scenes),
                                      TEST_CASE(example_variants),       TEST_CASE(boxes),
                                      TEST_CASE(sizes_need_the_same),    TEST_CASE(axes_need_the_same),
                                      TEST_CASE(quarters_need_the_same), TEST_CASE(errors_are_those_of_need)};
    return test_run(write, cases, TEST_COUNT(cases));
}
