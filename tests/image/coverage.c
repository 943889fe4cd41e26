/* SPDX-License-Identifier: MIT */
/*
 * Suite: which pixels objects cover. Triangles that share edges cover each pixel of their union exactly once: every
 * triangle is drawn on its own, unlit white on black, and the coverages are added. Clustered meshes have no holes.
 * Objects that hide each other show the bits that each shows alone where it is nearest.
 */
#include "bench.h"
#include "glint.h"
#include "glint_extras.h"
#include "harness.h"
#include "library_geometry.h"
#include "picture.h"
#include "random.h"
#include "reference.h"
#include "scenes.h"
#include "scenes/scenes.h"
#include "stability/random_scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SIZE 64
#define PATCH_VERTICES 64
#define PATCH_TRIANGLES 96

/* The screen's half height in steps of 28.4, and mesh steps per step of 28.4: the extent is 4 half heights. */
#define HALF_HEIGHT (SIZE / 2 * 16)
#define STEPS_PER_SNAP (32768 / 4 / HALF_HEIGHT)

/* A patch of triangles in the plane z = -1, seen with a field of view of 90 degrees. */
typedef struct patch {
    int16_t positions[PATCH_VERTICES][3];
    int16_t normals[PATCH_VERTICES][3];
    uint16_t triangles[PATCH_TRIANGLES][3];
    glint_mesh mesh;
    glint_object object;
    glint_scene scene;
} patch;

static const glint_material white = {.model = &glint_model_blinn_phong, .ambient = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};

static void patch_begin(patch *p) {
    memset(p, 0, sizeof *p);
    p->mesh = (glint_mesh){.positions = (const int16_t(*)[3])p->positions,
                           .normals = (const int16_t(*)[3])p->normals,
                           .triangles = (const uint16_t(*)[3])p->triangles,
                           .extent = {4 * GLINT_ONE, 4 * GLINT_ONE, 4 * GLINT_ONE}};
    p->object = (glint_object){.mesh = &p->mesh,
                               .material = &white,
                               .evaluation = &glint_per_fragment,
                               .pose = glint_pose_translate(0, 0, -GLINT_ONE)};
    p->scene = (glint_scene){
        .camera = {.pose = glint_pose_identity(), .field_of_view = 90 * GLINT_ONE, .near_plane = GLINT_ONE / 16},
        .ambient = {GLINT_ONE, GLINT_ONE, GLINT_ONE},
        .objects = &p->object,
        .object_count = 1};
}

/* A vertex at a screen position in 28.4, at z = -1. */
static uint16_t patch_vertex(patch *p, int x, int y) {
    uint32_t index = p->mesh.vertex_count++;
    p->positions[index][0] = (int16_t)((x - HALF_HEIGHT) * STEPS_PER_SNAP);
    p->positions[index][1] = (int16_t)((HALF_HEIGHT - y) * STEPS_PER_SNAP);
    p->normals[index][2] = 32767;
    return (uint16_t)index;
}

/* Screen y runs down: counter-clockwise as seen. */
static void patch_triangle(patch *p, int a, int b, int c) {
    uint16_t *triangle = p->triangles[p->mesh.triangle_count++];
    triangle[0] = (uint16_t)a;
    triangle[1] = (uint16_t)b;
    triangle[2] = (uint16_t)c;
}

/* Sums the coverage of each triangle drawn alone. */
static void add_up(const glint_scene *scene, int counts[SIZE * SIZE]) {
    const glint_mesh *whole = scene->objects[0].mesh;
    picture image = picture_open(SIZE, SIZE, &glint_format_grey8);
    memset(counts, 0, SIZE * SIZE * sizeof *counts);
    for (uint32_t i = 0; i < whole->triangle_count; i++) {
        glint_mesh single = *whole;
        glint_object object = scene->objects[0];
        glint_scene alone = *scene;
        single.triangles += i;
        single.triangle_count = 1;
        object.mesh = &single;
        alone.objects = &object;
        if (!CHECK_EQUAL(picture_render(&image, &alone, NULL, NULL), GLINT_OK))
            break;
        for (int pixel = 0; pixel < SIZE * SIZE; pixel++)
            counts[pixel] += image.bytes[pixel] != 0;
    }
    picture_close(&image);
}

/*
 * No pixel counted twice; the mesh drawn whole covers the same; and both cover what the reference says, drawn with the
 * library's own screen positions. @return pixels covered, so that a caller can tell that something was tested.
 */
static int check_patch(const glint_scene *scene) {
    static reference_pixel pixels[SIZE * SIZE];
    static int counts[SIZE * SIZE];
    const reference_image expected = {SIZE, SIZE, pixels};
    picture together = picture_open(SIZE, SIZE, &glint_format_grey8);
    glint_config config = picture_config(&together, NULL);
    library_geometry geometry;
    int covered = 0;
    CHECK_EQUAL(library_geometry_open(&geometry, &config, scene), GLINT_OK);
    reference_render(&expected, scene, (const reference_position *const *)geometry.positions);
    CHECK_EQUAL(picture_render(&together, scene, NULL, NULL), GLINT_OK);
    add_up(scene, counts);
    int twice = 0;
    int unlike_whole = 0;
    int unlike_reference = 0;
    for (int i = 0; i < SIZE * SIZE; i++) {
        twice += counts[i] > 1;
        unlike_whole += (counts[i] > 0) != (together.bytes[i] != 0);
        unlike_reference += (together.bytes[i] != 0) != pixels[i].covered;
        covered += counts[i] > 0;
    }
    CHECK_EQUAL(twice, 0);
    CHECK_EQUAL(unlike_whole, 0);
    CHECK_EQUAL(unlike_reference, 0);
    library_geometry_close(&geometry);
    picture_close(&together);
    return covered;
}

/* ---- Flat patches, nothing clipped --------------------------------------------------------------------------- */

/*
 * Around a centre, at equal angles and random radii: star-shaped, so that all triangles keep their winding. Grid 8,
 * half a pixel, puts vertices and edges through pixel centres.
 */
static void build_fan(patch *p, int spokes, int grid) {
    int x = (26 * 16 + any(0, 12 * 16 - 1)) / grid * grid;
    int y = (26 * 16 + any(0, 12 * 16 - 1)) / grid * grid;
    patch_begin(p);
    patch_vertex(p, x, y);
    for (int i = 0; i < spokes; i++) {
        double angle = -6.283185307 * i / spokes;
        double radius = 16 * (10 + any(0, 17));
        patch_vertex(p, x + (int)lrint(radius * cos(angle)) / grid * grid,
                     y + (int)lrint(radius * sin(angle)) / grid * grid);
    }
    for (int i = 0; i < spokes; i++)
        patch_triangle(p, 0, 1 + i, 1 + (i + 1) % spokes);
}

static void fans(void) {
    static const int grids[4] = {1, 4, 8, 16};
    for (int i = 0; i < 60; i++) {
        static patch p;
        build_fan(&p, 3 + any(0, 11), grids[i % 4]);
        CHECK(check_patch(&p.scene) > 100);
    }
}

/*
 * The left side of a large triangle, (x, y) to (x + dx, y + dy), passes a pixel's centre at one row by 1/(16 dy) of a
 * pixel, the least that it can: (x - 8) dy + (16 row + 8 - y) dx is 1 modulo 16 dy. The pixel is outside.
 */
static void sides_just_beside_centres(void) {
    enum { TOP = 9, DY = 961 };
    for (int row = 4; row < 60; row++) {
        static patch p;
        const int down = 16 * row + 8 - TOP;
        int dx = 1;
        while (dx < DY && down * dx % DY != 1)
            dx++;
        if (dx < 100 || dx > 800)
            continue;
        const int x = 8 + (16 - down * dx / DY % 16) % 16;
        patch_begin(&p);
        patch_vertex(&p, x, TOP);
        patch_vertex(&p, x + dx, TOP + DY);
        patch_vertex(&p, 1000, TOP);
        patch_triangle(&p, 0, 1, 2);
        CHECK(check_patch(&p.scene) > 100);
    }
}

/* A lattice of quads with jittered vertices that keeps its triangles' winding. */
static void build_lattice(patch *p, int grid, int jitter) {
    const int pitch = 8 * 16;
    patch_begin(p);
    for (int i = 0; i < 49; i++) {
        int x = (i % 7 + 1) * pitch + (any(0, 2 * jitter + 1 - 1) - jitter) / grid * grid;
        int y = (i / 7 + 1) * pitch + (any(0, 2 * jitter + 1 - 1) - jitter) / grid * grid;
        patch_vertex(p, x, y);
    }
    for (int i = 0; i < 36; i++) {
        int a = i / 6 * 7 + i % 6;
        patch_triangle(p, a, a + 7, a + 8);
        patch_triangle(p, a, a + 8, a + 1);
    }
}

static void reverse_winding(patch *p) {
    for (uint32_t i = 0; i < p->mesh.triangle_count; i++) {
        uint16_t first = p->triangles[i][0];
        p->triangles[i][0] = p->triangles[i][2];
        p->triangles[i][2] = first;
    }
}

/* Reversed: nothing when single-sided, the same pixels when double-sided; a mirror changes neither. */
static void reversed_winding(void) {
    static patch p;
    for (int i = 0; i < 8; i++) {
        build_lattice(&p, 8, 40);
        int forward = check_patch(&p.scene);
        p.object.pose.m[0][0] = -GLINT_ONE;
        int mirrored = check_patch(&p.scene);
        CHECK(mirrored > 1500);
        reverse_winding(&p);
        CHECK_EQUAL(check_patch(&p.scene), 0);
        p.mesh.flags = GLINT_MESH_DOUBLE_SIDED;
        CHECK_EQUAL(check_patch(&p.scene), mirrored);
        p.object.pose.m[0][0] = GLINT_ONE;
        CHECK_EQUAL(check_patch(&p.scene), forward);
        p.mesh.flags = 0;
        CHECK_EQUAL(check_patch(&p.scene), 0);
    }
}

/* ---- Off the screen, beyond the guard band, through the near plane ------------------------------------------- */

/* Whether pixels of the screen have their centres from a place to before another, in sixteenths. */
static int has_centres(int from, int to) {
    int centres = 0;
    for (int pixel = 0; pixel < SIZE; pixel++)
        centres += 16 * pixel + 8 >= from && 16 * pixel + 8 < to;
    return centres > 0;
}

/* Triangles at each sixteenth around the edges of the screen are counted as outside exactly where no centre of a pixel
 * is as far across or down, the smallest also elsewhere: a user who asks why a picture is empty would be told another
 * reason. */
static void triangles_outside_are_counted(void) {
    enum { MIDDLE = 296, AROUND = 80 };
    static const int corners[3][2] = {{0, 0}, {0, 1}, {1, 1}}, sides[2] = {60, 9};
    picture image = picture_open(SIZE, SIZE, &glint_format_grey8);
    long outside = 0, all = 0;
    for (int i = 0; i < 4 * 2 * 3; i++) {
        const int edge = i % 4 / 2 * 16 * SIZE, side = sides[i / 4 % 2], first = i / 8;
        for (int at = edge - AROUND; at < edge + AROUND; at++) {
            const int left = i % 2 ? MIDDLE : at, top = i % 2 ? at : MIDDLE;
            static patch p;
            glint_stats stats;
            patch_begin(&p);
            for (int k = 0; k < 3; k++) {
                const int *const corner = corners[(k + first) % 3];
                patch_vertex(&p, left + side * corner[0], top + side * corner[1]);
            }
            patch_triangle(&p, 0, 1, 2);
            CHECK_EQUAL(picture_render(&image, &p.scene, NULL, &stats), GLINT_OK);
            CHECK_EQUAL(stats.outside, !has_centres(left, left + side) || !has_centres(top, top + side));
            outside += stats.outside;
            all++;
        }
    }
    CHECK(outside > all / 4 && outside < all * 3 / 4);
    picture_close(&image);
}

/* Whether all eight neighbours of a pixel and itself are covered by the reference. */
static int deep_inside(const reference_pixel *pixels, int pixel) {
    int x = pixel % SIZE;
    int y = pixel / SIZE;
    for (int row = y - 1; row <= y + 1; row++) {
        for (int column = x - 1; column <= x + 1; column++) {
            if (row >= 0 && row < SIZE && column >= 0 && column < SIZE && !pixels[row * SIZE + column].covered)
                return 0;
        }
    }
    return 1;
}

/* Where triangles are clipped, edges may lie a sixteenth off; no pixel is covered twice, and none inside is missed. */
static int check_clipped(const glint_scene *scene) {
    static reference_pixel pixels[SIZE * SIZE];
    static int counts[SIZE * SIZE];
    const reference_image expected = {SIZE, SIZE, pixels};
    int covered = 0;
    int wrong = 0;
    int twice = 0;
    reference_render(&expected, scene, NULL);
    add_up(scene, counts);
    for (int i = 0; i < SIZE * SIZE; i++) {
        twice += counts[i] > 1;
        wrong += !pixels[i].uncertain && counts[i] != pixels[i].covered;
        wrong += deep_inside(pixels, i) && counts[i] != 1;
        covered += counts[i] > 0;
    }
    CHECK_EQUAL(twice, 0);
    CHECK_EQUAL(wrong, 0);
    return covered;
}

static void clipped_at_the_near_plane(void) {
    for (int i = 0; i < 10; i++) {
        static patch p;
        build_lattice(&p, 1, 40);
        glint_pose tilt = glint_pose_rotate_x((-80 + 3 * i) * GLINT_ONE);
        glint_pose turn = glint_pose_rotate_z(i * 17 * GLINT_ONE);
        glint_pose away = glint_pose_translate(i * 1000, -GLINT_ONE / 3, -GLINT_ONE / 4);
        p.object.pose = glint_pose_then(&turn, &tilt);
        p.object.pose = glint_pose_then(&p.object.pose, &away);
        p.scene.camera.near_plane = GLINT_ONE / 10;
        CHECK(check_clipped(&p.scene) > 200);
    }
}

static void clipped_at_the_guard_band(void) {
    for (int i = 0; i < 10; i++) {
        static patch p;
        build_lattice(&p, 1, 40);
        for (int axis = 0; axis < 2; axis++)
            p.object.pose.m[axis][axis] = (60 + 13 * i) * GLINT_ONE;
        p.object.pose.m[0][3] = any(0, 20 * GLINT_ONE - 1) - 10 * GLINT_ONE;
        p.object.pose.m[1][3] = any(0, 20 * GLINT_ONE - 1) - 10 * GLINT_ONE;
        CHECK_EQUAL(check_clipped(&p.scene), SIZE * SIZE);
    }
}

/* The edges of a triangle cut off three corners of the guard band, and the near plane the fourth: eight corners are
 * left, the most that there can be. The triangle fills the screen. A ninth would lie in memory of something else. */
static void clipped_to_eight_corners(void) {
    /* in pixels over the focal length of 32, and in near planes */
    static const double places[3][3] = {{0, 1700, 3.125}, {-1700, 0, 3.125}, {2500, -2500, 0}};
    static patch p;
    patch_begin(&p);
    p.mesh.vertex_count = 3;
    p.mesh.flags = GLINT_MESH_DOUBLE_SIDED;
    p.mesh.extent = (glint_vector){16 * GLINT_ONE, 16 * GLINT_ONE, GLINT_ONE / 4};
    p.object.pose = glint_pose_identity();
    for (int i = 0; i < 3; i++) {
        const double w = places[i][2] / 16, scale = 32767 / 16.0 / 32 * (w > 0 ? w : 1.0 / 16);
        p.positions[i][0] = (int16_t)lrint(places[i][0] * scale);
        p.positions[i][1] = (int16_t)lrint(places[i][1] * scale);
        p.positions[i][2] = (int16_t)lrint(-w * 4 * 32767);
        p.normals[i][2] = 32767;
    }
    patch_triangle(&p, 0, 1, 2);
    CHECK_EQUAL(check_clipped(&p.scene), SIZE * SIZE);
}

/* ---- Clustered meshes -------------------------------------------------------------------------------------------- */

/*
 * Clusters drop triangles that face away as they are, not as their corners were rounded: pixels may differ where the
 * reference is uncertain, as it rounds no corner; none inside is missed.
 */
static int check_clustered(int which, double about_x, double about_y, double distance, int mirrored) {
    static reference_pixel pixels[SIZE * SIZE];
    const reference_image expected = {SIZE, SIZE, pixels};
    bench_scene scene;
    picture image = picture_open(SIZE, SIZE, &glint_format_grey8);
    glint_stats stats;
    int wrong = 0;
    bench_build_scene(&scene, &bench_definitions[which], scene_clustered_mesh(which), 0);
    scene.object.pose = bench_turn(about_x, about_y);
    scene.object.pose.m[2][3] = bench_q16(-distance);
    for (int row = 0; row < 3 && mirrored; row++)
        scene.object.pose.m[row][0] = -scene.object.pose.m[row][0];
    scene.material = white;
    reference_render(&expected, &scene.scene, NULL);
    CHECK_EQUAL(picture_render(&image, &scene.scene, NULL, &stats), GLINT_OK);
    for (int i = 0; i < SIZE * SIZE; i++) {
        const int drawn = image.bytes[i] != 0;
        wrong += !pixels[i].uncertain && drawn != pixels[i].covered;
        wrong += deep_inside(pixels, i) && !drawn;
    }
    CHECK_EQUAL(wrong, 0);
    picture_close(&image);
    return stats.vertices < scene.object.mesh->vertex_count;
}

static void clustered_meshes_have_no_holes(void) {
    int fewer = 0;
    for (int i = 0; i < 40; i++) {
        double about_x = any(0, 6282) / 1000.0;
        double about_y = any(0, 6282) / 1000.0;
        double distance = 2.5 + any(0, 3999) / 1000.0;
        for (int which = 0; which < BENCH_SCENES; which++)
            fewer += check_clustered(which, about_x, about_y, distance, i % 2);
    }
    CHECK_EQUAL(fewer, 40 * BENCH_SCENES); /* vertices were left out each time */
}

/* ---- Objects that hide each other: alone, and of what they show the nearest pixel, of the first where two are as near
 * ---- */

#define OBJECTS_MAX 32

/* How many pixels an object covers that a later one hides, and that a later one is as near as. */
static long hidden, tied;

/* An image and its depth, 0 where nothing is. */
typedef struct layer {
    picture image;
    uint16_t *depth;
} layer;

static layer layer_open(int width, int height, const glint_format *format) {
    return (layer){picture_open(width, height, format), calloc((size_t)width * (size_t)height, sizeof(uint16_t))};
}

static void layer_close(layer *l) {
    picture_close(&l->image);
    free(l->depth);
}

/* Draws a scene in an arena of this size. */
static void draw_layer(const glint_scene *scene, size_t arena_size, layer *to) {
    const picture_options options = {.tile_width = 16, .tile_height = 16, .arena_size = arena_size, .depth = to->depth};
    CHECK_EQUAL(picture_render(&to->image, scene, &options, NULL), GLINT_OK);
}

static void copy_pixel(const picture *from, picture *to, int i) {
    const size_t size = from->stride / (size_t)from->width;
    memcpy(to->bytes + (size_t)i * size, from->bytes + (size_t)i * size, size);
}

/* Puts an object's pixels where they are nearer than what was there. */
static void put_over(const layer *one, layer *to) {
    for (int i = 0; i < to->image.width * to->image.height; i++) {
        hidden += to->depth[i] && one->depth[i] > to->depth[i];
        tied += one->depth[i] && one->depth[i] == to->depth[i];
        if (one->depth[i] <= to->depth[i])
            continue;
        copy_pixel(&one->image, &to->image, i);
        to->depth[i] = one->depth[i];
    }
}

/* The scene with one of its objects; of the others there is a triangle without area. */
static glint_scene leave_one(const glint_scene *scene, uint32_t which, glint_object *objects, glint_mesh *meshes) {
    static const uint16_t nothing[1][3] = {{0, 0, 0}};
    glint_scene one = *scene;
    for (uint32_t i = 0; i < scene->object_count; i++) {
        objects[i] = scene->objects[i];
        if (i == which)
            continue;
        meshes[i] = *objects[i].mesh;
        meshes[i].clusters = NULL;
        meshes[i].triangles = nothing;
        meshes[i].triangle_count = 1;
        objects[i].mesh = &meshes[i];
    }
    one.objects = objects;
    return one;
}

/* In a format of whole bytes a pixel, and arenas of one pass and of many. */
static void check_layers(const glint_scene *scene, int width, int height, const glint_format *format,
                         const char *name) {
    static glint_object objects[OBJECTS_MAX];
    static glint_mesh meshes[OBJECTS_MAX];
    layer whole = layer_open(width, height, format), wanted = layer_open(width, height, format),
          one = layer_open(width, height, format);
    const glint_need need = picture_need(&whole.image, scene, &(picture_options){.tile_width = 16, .tile_height = 16});
    if (CHECK(scene->object_count <= OBJECTS_MAX)) {
        const size_t sizes[3] = {need.one_pass, picture_arena(&need, 85), need.least};
        for (uint32_t i = 0; i < scene->object_count; i++) {
            const glint_scene alone = leave_one(scene, i, objects, meshes);
            draw_layer(&alone, need.one_pass, i ? &one : &wanted);
            if (i)
                put_over(&one, &wanted);
        }
        for (int i = 0; i < (scene->object_count > 1 ? 3 : 0); i++) {
            draw_layer(scene, sizes[i], &whole);
            if (!CHECK(picture_equal(&whole.image, &wanted.image))) {
                char line[160];
                snprintf(line, sizeof line, "  %s, arena of %lu bytes\n", name, (unsigned long)sizes[i]);
                test_write(line);
            }
        }
    }
    layer_close(&whole);
    layer_close(&wanted);
    layer_close(&one);
}

static void hidden_in_the_gallery(void) {
    static example_stage stage;
    for (unsigned i = 0; i < EXAMPLE_SCENES; i++) {
        for (uint32_t variant = 0; variant < example_scenes[i]->variant_count; variant++) {
            example_scenes[i]->build(&stage, variant, example_scenes[i]->frames / 3);
            if (!stage.layers) /* else objects show what is behind them */
                check_layers(&stage.scene, 160, 120, &glint_format_rgb888, example_scenes[i]->name);
        }
    }
}

/* At the same place as another, each third time, of another material. */
static void hidden_in_random_scenes(void) {
    static random_scene scene;
    char name[60];
    for (uint32_t seed = 1; seed <= 1200; seed++) {
        random_scene_make(&scene, seed);
        if (scene.scene.object_count > 1 && seed % 3 == 0) {
            scene.objects[1].mesh = scene.objects[0].mesh;
            scene.objects[1].pose = scene.objects[0].pose;
        }
        snprintf(name, sizeof name, "seed %u, %s", (unsigned)seed, random_regions[scene.region].name);
        check_layers(&scene.scene, scene.width, scene.height, scene.format, name);
    }
}

static void objects_were_hidden(void) {
    char line[80];
    snprintf(line, sizeof line, "  %ld pixels hidden by later objects, %ld as near\n", hidden, tied);
    test_write(line);
    CHECK(hidden > 10000);
    CHECK(tied > 10000);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(fans),
        TEST_CASE(sides_just_beside_centres),
        TEST_CASE(reversed_winding),

        TEST_CASE(triangles_outside_are_counted),
        TEST_CASE(clipped_at_the_near_plane),
        TEST_CASE(clipped_at_the_guard_band),
        TEST_CASE(clipped_to_eight_corners),
        TEST_CASE(clustered_meshes_have_no_holes),
        TEST_CASE(hidden_in_the_gallery),
        TEST_CASE(hidden_in_random_scenes),
        TEST_CASE(objects_were_hidden),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
