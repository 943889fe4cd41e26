/* SPDX-License-Identifier: MIT */
/* Suite: parallel rays. Images and depth against the reference, needs, and what is refused. */
#include "glint_extras.h"
#include "harness.h"
#include "judge.h"
#include "library_geometry.h"
#include "picture.h"
#include "random.h"
#include "scenes.h"
#include "stability/contract.h"

#include <math.h>

#define WIDTH 150
#define HEIGHT 101

/* ---- Images ---- */

static void report(const judgement *all) {
    test_write("  of ");
    test_write_number(all->judged);
    test_write(" pixels ");
    test_write_number(all->not_fine);
    test_write(" are not fine, ");
    test_write_number(all->over_one);
    test_write(" over one step\n");
}

static void judge_scene(const test_scene *s, const glint_format *format, judgement *all) {
    contract_result found;
    contract_judge(&s->scene, WIDTH, HEIGHT, format, &found);
    CHECK_EQUAL(found.found.status, GLINT_OK);
    CHECK(contract_holds(&found));
    CHECK_EQUAL(found.found.missed, 0);
    CHECK(found.found.vertex_error < 0.04); /* half of 1/16, and a part of it */
    judgement_add(all, &found.found);
}

static const glint_format *const formats[] = {&glint_format_rgb565, &glint_format_rgb888, &glint_format_grey8_dithered};

static void scenes_keep_the_contract(void) {
    judgement all = {0};
    for (unsigned i = 0; i < scene_count; i++)
        for (int evaluation = 0; evaluation < 3; evaluation++) {
            test_scene s;
            scene_build(&s, &scene_definitions[i]);
            scene_make_parallel(&s.scene);
            scene_evaluate(&s, scene_evaluations[evaluation]);
            judge_scene(&s, formats[i % 3], &all);
        }
    report(&all);
    CHECK(all.judged > 100000);
}

static void random_scenes_keep_the_contract(void) {
    judgement all = {0};
    for (uint32_t number = 1; number <= 150; number++) {
        test_scene s;
        scene_build_random(&s, number);
        scene_make_parallel(&s.scene);
        scene_evaluate(&s, scene_evaluations[number % 3]);
        judge_scene(&s, formats[number / 4 % 3], &all);
        test_write("");
    }
    report(&all);
    CHECK(all.judged > 100000);
}

/* A torus under lamps and spots at any distance, some next to its surface. */
static void lights_keep_the_contract(void) {
    judgement all = {0};
    for (uint32_t number = 1; number <= 120; number++) {
        bench_scene b;
        test_scene s;
        bench_build_scene(&b, &bench_definitions[1], scene_bench_mesh(1), (int)(number % 10));
        s.scene = b.scene;
        s.objects[0] = b.object;
        s.materials[0] = b.material;
        s.objects[0].material = &s.materials[0];
        s.scene.objects = s.objects;
        s.scene.lights = s.lights;
        s.scene.light_count = 2;
        random_state = number;
        for (int i = 0; i < 2; i++) {
            const int reach = number % 3 ? 2 * GLINT_ONE : 40 * GLINT_ONE;
            const glint_pose *const at = &s.objects[0].pose;
            s.lights[i] = (glint_light){
                .type = i ? &glint_light_spot : &glint_light_point,
                .position = {any(-reach, reach), any(-reach, reach), at->m[2][3] + any(GLINT_ONE / 2, reach)},
                .diffuse = {GLINT_ONE, GLINT_ONE / 2, GLINT_ONE / 2},
                .specular = {GLINT_ONE / 2, GLINT_ONE / 2, GLINT_ONE},
                .quadratic = GLINT_ONE / 16 * any(0, 2),
                .inner = 20 * GLINT_ONE,
                .outer = 50 * GLINT_ONE};
            s.lights[i].direction =
                (glint_vector){-s.lights[i].position.x, -s.lights[i].position.y, at->m[2][3] - s.lights[i].position.z};
        }
        scene_make_parallel(&s.scene);
        scene_evaluate(&s, scene_evaluations[number / 2 % 3]);
        judge_scene(&s, &glint_format_rgb565, &all);
    }
    report(&all);
    CHECK(all.judged > 100000);
}

/*
 * Of a scene as deep as a landscape, a leaning square is in the first few of the 65533 steps: its 1/w is next to the
 * largest, and colours between its corners, which are divided by that, were black.
 */
static void nearest_surfaces_keep_their_colours(void) {
    static const uint8_t colours[4][3] = {{200, 20, 90}, {40, 180, 10}, {20, 90, 250}, {250, 250, 60}};
    const glint_colour white = {GLINT_ONE, GLINT_ONE, GLINT_ONE};
    const glint_material paint = {.model = &glint_model_unlit, .diffuse = white};
    glint_mesh near = scene_square_mesh(3 * GLINT_ONE, 0);
    const glint_mesh far = near;
    near.colours = colours;
    judgement all = {0};
    random_state = 1;
    for (int i = 0; i < 30; i++) {
        const glint_pose x = glint_pose_rotate_x(any(-20 * GLINT_ONE, 20 * GLINT_ONE)),
                         y = glint_pose_rotate_y(any(-20 * GLINT_ONE, 20 * GLINT_ONE));
        test_scene s = {.objects = {{&near, &paint, glint_pose_then(&x, &y), &glint_per_vertex},
                                    {&far, &paint, glint_pose_identity(), &glint_per_vertex}}};
        s.objects[0].pose.m[2][3] = -4 * GLINT_ONE;
        s.objects[1].pose.m[2][3] = -20000 * GLINT_ONE;
        s.scene = (glint_scene){.camera = {.pose = glint_pose_identity(),
                                           .near_plane = GLINT_ONE / 4,
                                           .projection = &glint_orthographic,
                                           .view_height = 5 * GLINT_ONE},
                                .objects = s.objects,
                                .object_count = 2};
        judge_scene(&s, formats[i % 2], &all);
    }
    report(&all);
    CHECK(all.judged > 100000);
}

/* A lamp before a square that is 126 guard bands away, where rays nearly end, lights it as it does one close by. */
static void lamps_near_the_end_of_rays_light_as_close_by(void) {
    const glint_mesh square = scene_square_mesh(GLINT_ONE, 0);
    const glint_colour white = {GLINT_ONE, GLINT_ONE, GLINT_ONE};
    const double band = 2.0 * GLINT_ONE * 1024 / HEIGHT; /* of a screen that is two high */
    picture close = picture_open(WIDTH, HEIGHT, &glint_format_rgb888), image = close;
    for (int i = 0; i < 8; i++) {
        const glint_q16 away = i ? (glint_q16)((125.7 + 0.1 * i) * band) : 10 * GLINT_ONE;
        const glint_material paint = {.model = &glint_model_lambert, .diffuse = white};
        const glint_light lamp = {.type = &glint_light_point,
                                  .position = {0, 0, GLINT_ONE - away},
                                  .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
        const glint_object object = {.mesh = &square,
                                     .material = &paint,
                                     .evaluation = &glint_per_fragment,
                                     .pose = glint_pose_translate(0, 0, -away)};
        const glint_scene scene = {.camera = {.pose = glint_pose_identity(),
                                              .near_plane = GLINT_ONE / 4,
                                              .projection = &glint_orthographic,
                                              .view_height = 2 * GLINT_ONE},
                                   .lights = &lamp,
                                   .light_count = 1,
                                   .objects = &object,
                                   .object_count = 1};
        int worst = 0;
        image = i ? picture_open(WIDTH, HEIGHT, &glint_format_rgb888) : close;
        CHECK_EQUAL(picture_render(&image, &scene, NULL, NULL), GLINT_OK);
        for (size_t k = 0; k < image.size; k++)
            worst = image.bytes[k] - close.bytes[k] > worst   ? image.bytes[k] - close.bytes[k]
                    : close.bytes[k] - image.bytes[k] > worst ? close.bytes[k] - image.bytes[k]
                                                              : worst;
        CHECK_AT_MOST(worst, 8);
        if (i)
            picture_close(&image);
    }
    picture_close(&close);
}

/* ---- Depth ---- */

static uint16_t depths[HEIGHT][WIDTH];
static const picture_options with_depth = {.depth = depths[0]};

/* How far the corners of a mesh's box are along the camera's axis. */
static void extend(const glint_scene *scene, const glint_object *object, double *nearest, double *farthest) {
    const glint_mesh *const mesh = object->mesh;
    const double extent[3] = {mesh->extent.x / 65536.0, mesh->extent.y / 65536.0, mesh->extent.z / 65536.0},
                 offset[3] = {mesh->offset.x / 65536.0, mesh->offset.y / 65536.0, mesh->offset.z / 65536.0};
    for (int corner = 0; corner < 8; corner++) {
        double w = 0;
        for (int i = 0; i < 3; i++) {
            double at = (object->pose.m[i][3] - (double)scene->camera.pose.m[i][3]) / 65536;
            for (int j = 0; j < 3; j++)
                at += object->pose.m[i][j] / 65536.0 * (offset[j] + (corner >> j & 1 ? extent[j] : -extent[j]));
            w -= at * scene->camera.pose.m[i][2] / 65536;
        }
        *nearest = fmin(*nearest, w);
        *farthest = fmax(*farthest, w);
    }
}

static void depth_is_linear(void) {
    static reference_pixel pixels[HEIGHT][WIDTH];
    const reference_image image = {WIDTH, HEIGHT, pixels[0]};
    long seen = 0, wrong = 0;
    for (uint32_t number = 1; number <= 30; number++) {
        test_scene s;
        picture drawn = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
        const glint_config config = picture_config(&drawn, NULL);
        double nearest = HUGE_VAL, farthest = 0;
        scene_build_random(&s, number);
        s.scene.object_count = 1; /* then it is visible */
        scene_make_parallel(&s.scene);
        CHECK_EQUAL(picture_render(&drawn, &s.scene, &with_depth, NULL), GLINT_OK);
        library_geometry geometry; /* where its corners are rounded to: a sixteenth of a pixel may be many steps */
        CHECK_EQUAL(library_geometry_open(&geometry, &config, &s.scene), GLINT_OK);
        reference_render(&image, &s.scene, (const reference_position *const *)geometry.positions);
        library_geometry_close(&geometry);
        extend(&s.scene, &s.objects[0], &nearest, &farthest);
        nearest = fmax(nearest, s.scene.camera.near_plane / 65536.0);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                const double w = REFERENCE_FAR - pixels[y][x].nearest;
                const double exact = 1 + 65533 * (farthest - w) / (farthest - nearest);
                if (!pixels[y][x].covered || !depths[y][x] || pixels[y][x].uncertain)
                    continue;
                seen++;
                wrong += fabs(exact - depths[y][x]) > 2;
            }
        picture_close(&drawn);
    }
    CHECK(seen > 40000);
    CHECK_EQUAL(wrong, 0);
}

/* Depths of a square across the axis between two others are rounded to the nearest; those of pixels are one more. */
static void depth_is_rounded(void) {
    const glint_mesh square = scene_square_mesh(20 * GLINT_ONE, 0);
    const glint_material paint = {.model = &glint_model_unlit};
    double worst = 0;
    for (int i = 0; i < 200; i++) {
        const glint_q16 z[3] = {100 * GLINT_ONE, 100 * GLINT_ONE + 131072 * i + 977 * (i + 1), 700 * GLINT_ONE};
        picture drawn = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
        glint_object objects[3];
        for (int k = 0; k < 3; k++)
            objects[k] = (glint_object){.mesh = &square,
                                        .material = &paint,
                                        .evaluation = &glint_per_fragment,
                                        .pose = glint_pose_translate((k - 1) * 40 * GLINT_ONE, 0, -z[k])};
        const glint_scene scene = {.camera = {.pose = glint_pose_identity(),
                                              .near_plane = GLINT_ONE,
                                              .projection = &glint_orthographic,
                                              .view_height = 100 * GLINT_ONE},
                                   .objects = objects,
                                   .object_count = 3};
        CHECK_EQUAL(picture_render(&drawn, &scene, &with_depth, NULL), GLINT_OK);
        const double exact = 2 + 65533.0 * (z[2] - z[1]) / (z[2] - z[0]);
        const int found = depths[HEIGHT / 2][WIDTH / 2];
        worst = fmax(worst, fabs(exact - found));
        picture_close(&drawn);
    }
    CHECK_AT_MOST((int)(1000 * worst), 500 + 100);
}

static picture draw(const glint_scene *scene) {
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    CHECK_EQUAL(picture_render(&image, scene, NULL, NULL), GLINT_OK);
    return image;
}

static void viewers_are_the_same(void) {
    for (uint32_t number = 1; number <= 20; number++) {
        test_scene s;
        scene_build_random(&s, number);
        scene_make_parallel(&s.scene);
        scene_evaluate(&s, scene_evaluations[number % 3]);
        s.scene.viewer = GLINT_VIEWER_LOCAL;
        picture local = draw(&s.scene);
        s.scene.viewer = GLINT_VIEWER_INFINITE;
        picture infinite = draw(&s.scene);
        CHECK(picture_equal(&local, &infinite));
        picture_close(&local);
        picture_close(&infinite);
    }
}

/* ---- Places, pixels and errors ---- */

static void points_are_placed(void) {
    double worst = 0;
    random_state = 1;
    for (int i = 0; i < 20000; i++) {
        glint_camera camera = {glint_pose_rotate((glint_vector){any(-9, 9), any(-9, 9), 1}, any(0, 359) * GLINT_ONE), 0,
                               GLINT_ONE / 10, &glint_orthographic, any(GLINT_ONE, 200 * GLINT_ONE)};
        const glint_config config = {.width = (uint16_t)any(1, 1024), .height = (uint16_t)any(1, 1024)};
        const glint_q16 reach = 200 * GLINT_ONE;
        const glint_vector point = {any(-reach, reach), any(-reach, reach), any(-reach, reach)};
        glint_screen_point place;
        double sight[3] = {0, 0, 0};
        for (int k = 0; k < 3; k++)
            camera.pose.m[k][3] = any(-reach, reach);
        for (int k = 0; k < 3; k++) {
            const glint_q16 at[3] = {point.x, point.y, point.z};
            for (int j = 0; j < 3; j++)
                sight[k] += camera.pose.m[j][k] / 65536.0 * ((double)at[j] - camera.pose.m[j][3]) / 65536;
        }
        const double pixels = config.height / (camera.view_height / 65536.0),
                     x = 0.5 * config.width + pixels * sight[0], y = 0.5 * config.height - pixels * sight[1];
        const int found = glint_camera_project(&config, &camera, point, &place);
        if (fabs(-sight[2] - 0.1) > 1e-3)
            CHECK_EQUAL(found, -sight[2] > 0.1);
        if (found != 1 || fabs(x - 512) > 1024 || fabs(y - 512) > 1024)
            continue;
        worst = fmax(worst, fmax(fabs(place.x / 65536.0 - x), fabs(place.y / 65536.0 - y)));
        CHECK(fabs(place.distance / 65536.0 + sight[2]) < 1e-3);
    }
    CHECK_AT_MOST((int)(1000000 * worst), 1000000 / 128);
}

/* ---- Coarse coordinates ---- */

/* Two squares across the axis, 100 away and 1 behind, that show as they are lit from nowhere. */
static void build_squares(test_scene *s) {
    static glint_mesh square;
    square = scene_square_mesh(8000 * GLINT_ONE, GLINT_ONE);
    scene_build_random(s, 1);
    s->scene.camera = (glint_camera){.pose = glint_pose_identity(),
                                     .near_plane = 1,
                                     .projection = &glint_orthographic,
                                     .view_height = 30000 * GLINT_ONE};
    s->scene.object_count = 2;
    s->scene.ambient = (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE};
    for (int i = 0; i < 2; i++) {
        s->materials[i] = (glint_material){.model = &glint_model_unlit, .diffuse = {.g = GLINT_ONE / (i + 1)}};
        s->objects[i] =
            (glint_object){.mesh = &square, .material = &s->materials[i], .evaluation = &glint_per_fragment};
        s->objects[i].pose = glint_pose_translate(2000 * i * GLINT_ONE, 0, -(100 + i) * GLINT_ONE);
    }
}

/* Is the picture that of both squares? */
static int has_near_square(const test_scene *s, const picture *both) {
    picture image = draw(&s->scene);
    const int is_same = picture_equal(&image, both);
    picture_close(&image);
    return is_same;
}

/* In a view that wide, coordinates are rounded to more than a near plane's steps: what lies before it by less than half
 * of one is drawn as at it, still before all else. */
static void near_plane_between_coordinates(void) {
    test_scene s;
    build_squares(&s);
    picture both = draw(&s.scene);
    s.scene.object_count = 1;
    CHECK(!has_near_square(&s, &both));
    s.scene.object_count = 2;
    for (int beyond = -2; beyond <= 4; beyond++) {
        s.scene.camera.near_plane = 100 * GLINT_ONE + beyond;
        CHECK(has_near_square(&s, &both));
    }
    s.scene.camera.near_plane = 100 * GLINT_ONE + GLINT_ONE / 2;
    CHECK(!has_near_square(&s, &both));
    picture_close(&both);
}

/* An object that is up to 2^30 times smaller than what is seen: it is nowhere, and all else as without it. The guard
 * band's width, Q28 and rounded, is hardly more than a multiple of 2^43, but for the widest view. */
static void specks_in_wide_views(void) {
    test_scene s;
    glint_mesh speck;
    build_squares(&s);
    s.scene.object_count = 2;
    speck = *s.objects[0].mesh;
    speck.extent = (glint_vector){1, 1, 1};
    s.objects[2] = s.objects[0];
    s.objects[2].mesh = &speck;
    for (int64_t i = 1; i <= 10; i++) {
        s.scene.camera.view_height = i < 10 ? (glint_q16)((i << 43) * HEIGHT / (1023 << 12) + 1) : INT32_MAX;
        s.scene.object_count = 2;
        picture without = draw(&s.scene);
        s.scene.object_count = 3;
        for (int away = 1; away <= 1 << 20; away *= 4) {
            s.objects[2].pose = glint_pose_translate(0, 0, -away);
            picture image = draw(&s.scene);
            CHECK(picture_equal(&image, &without));
            picture_close(&image);
        }
        picture_close(&without);
    }
}

/* A square of nearly 2^17 units to a side, the largest that is drawn, fills the narrowest view as a small one does. */
static void largest_objects_in_the_narrowest_view(void) {
    const glint_mesh large = scene_square_mesh(INT32_MAX, GLINT_ONE);
    test_scene s;
    build_squares(&s);
    s.scene.camera.view_height = GLINT_ONE / 256;
    s.scene.object_count = 1;
    picture wanted = draw(&s.scene);
    s.objects[0].mesh = &large;
    for (int scale = 2; scale < 8; scale++) {
        for (int i = 0; i < 3; i++)
            s.objects[0].pose.m[i][i] = scale * GLINT_ONE / 2;
        CHECK(has_near_square(&s, &wanted));
    }
    picture_close(&wanted);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(scenes_keep_the_contract),
        TEST_CASE(random_scenes_keep_the_contract),
        TEST_CASE(lights_keep_the_contract),
        TEST_CASE(lamps_near_the_end_of_rays_light_as_close_by),
        TEST_CASE(nearest_surfaces_keep_their_colours),
        TEST_CASE(depth_is_linear),
        TEST_CASE(depth_is_rounded),
        TEST_CASE(viewers_are_the_same),
        TEST_CASE(points_are_placed),
        TEST_CASE(near_plane_between_coordinates),
        TEST_CASE(specks_in_wide_views),
        TEST_CASE(largest_objects_in_the_narrowest_view),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
