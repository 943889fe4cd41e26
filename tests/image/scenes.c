/* SPDX-License-Identifier: MIT */
#include "scenes.h"

#include "quantise.h"
#include "random.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bench_mesh bench_meshes[BENCH_SCENES];

/* A square in the xz plane facing +y, from -32768 to 32767 steps. */
static const int16_t floor_positions[4][3] = {
    {-32768, 0, 32767}, {32767, 0, 32767}, {32767, 0, -32768}, {-32768, 0, -32768}};
static const int16_t floor_normals[4][3] = {{0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}};
static const uint16_t floor_triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};

/* A square facing +z whose normals lean apart, cancel along its middle, and are zero nowhere else. */
static const int16_t leaning_positions[4][3] = {
    {-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}};
static const int16_t leaning_normals[4][3] = {
    {-32767, 0, 9000}, {32767, 0, 9000}, {20000, 0, 26000}, {-20000, 0, 26000}};
static const uint16_t leaning_triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};

static const glint_mesh floor_mesh = {.positions = floor_positions,
                                      .normals = floor_normals,
                                      .triangles = floor_triangles,
                                      .vertex_count = 4,
                                      .triangle_count = 2,
                                      .extent = {40 * GLINT_ONE, GLINT_ONE, 40 * GLINT_ONE},
                                      .flags = GLINT_MESH_DOUBLE_SIDED};
static const glint_mesh leaning_mesh = {.positions = leaning_positions,
                                        .normals = leaning_normals,
                                        .triangles = leaning_triangles,
                                        .vertex_count = 4,
                                        .triangle_count = 2,
                                        .extent = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
static glint_mesh open_torus; /* double-sided */

glint_mesh scene_square_mesh(glint_q16 half, glint_q16 depth) {
    static const int16_t corners[4][3] = {
        {-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}};
    static const int16_t normals[4][3] = {{0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}};
    static const uint16_t triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
    return (glint_mesh){.positions = corners,
                        .normals = normals,
                        .triangles = triangles,
                        .vertex_count = 4,
                        .triangle_count = 2,
                        .extent = {half, half, depth}};
}

const bench_mesh *scene_bench_mesh(int which) {
    const bench_definition *definition = &bench_definitions[which];
    if (bench_meshes[which].mesh.vertex_count == 0)
        bench_build_mesh(&bench_meshes[which], definition->shape, definition->around, definition->along);
    return &bench_meshes[which];
}

const bench_mesh *scene_clustered_mesh(int which) {
    static bench_mesh meshes[BENCH_SCENES];
    const bench_definition *definition = &bench_definitions[which];
    if (meshes[which].mesh.vertex_count == 0) {
        bench_build_mesh(&meshes[which], definition->shape, definition->around, definition->along);
        cluster_mesh(&meshes[which].mesh);
    }
    return &meshes[which];
}

/* A benchmark's frame 3 as the first object; others follow by copying it. */
static void begin(test_scene *scene, int which) {
    bench_scene bench;
    bench_build_scene(&bench, &bench_definitions[which], scene_clustered_mesh(which), 3);
    memset(scene, 0, sizeof *scene);
    scene->scene = bench.scene;
    scene->scene.objects = scene->objects;
    scene->scene.lights = scene->lights;
    scene->lights[0] = bench.light;
    for (int i = 0; i < SCENE_OBJECTS_MAX; i++) {
        scene->materials[i] = bench.material;
        scene->objects[i] = bench.object;
        scene->objects[i].material = &scene->materials[i];
    }
}

static void scale_columns(glint_pose *pose, double x, double y, double z) {
    const double scale[3] = {x, y, z};
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++)
            pose->m[row][column] = bench_q16(pose->m[row][column] / 65536.0 * scale[column]);
    }
}

static void place(glint_object *object, double x, double y, double z) {
    object->pose.m[0][3] = bench_q16(x);
    object->pose.m[1][3] = bench_q16(y);
    object->pose.m[2][3] = bench_q16(z);
}

static glint_colour colour(double r, double g, double b) {
    return (glint_colour){bench_q16(r), bench_q16(g), bench_q16(b)};
}

static void build_near_plane(test_scene *scene) {
    begin(scene, 0);
    place(&scene->objects[0], 0.2, 0.1, -0.7);
    scene->scene.camera.near_plane = bench_q16(0.75);
}

static void build_near_double_sided(test_scene *scene) {
    build_near_plane(scene);
    open_torus = scene_clustered_mesh(1)->mesh;
    open_torus.flags = GLINT_MESH_DOUBLE_SIDED;
    scene->objects[0].mesh = &open_torus;
    place(&scene->objects[0], 0.3, -0.1, -1.2);
}

/* A plane that reaches from far behind the eye to the horizon, far beyond the screen's sides. */
static void build_floor(test_scene *scene) {
    begin(scene, 0);
    scene->objects[0].mesh = &floor_mesh;
    scene->objects[0].pose = glint_pose_identity();
    place(&scene->objects[0], 3, -1, -5);
    scene->materials[0].diffuse = colour(0.3, 0.4, 0.5);
}

/* Close to a sphere whose silhouette lies off the screen on three sides. */
static void build_guard_band(test_scene *scene) {
    begin(scene, 3);
    scale_columns(&scene->objects[0].pose, 9, 9, 9);
    place(&scene->objects[0], 6, -4, -9.4);
}

static void build_mirrored(test_scene *scene) {
    begin(scene, 0);
    scale_columns(&scene->objects[0].pose, -1, 1, 1);
}

static void build_mirrored_double_sided(test_scene *scene) {
    begin(scene, 1);
    open_torus = scene_clustered_mesh(1)->mesh;
    open_torus.flags = GLINT_MESH_DOUBLE_SIDED;
    scene->objects[0].mesh = &open_torus;
    scale_columns(&scene->objects[0].pose, 1, -1.25, 0.75);
}

static void build_squashed(test_scene *scene) {
    begin(scene, 3);
    scale_columns(&scene->objects[0].pose, 1, 0.01, 0.5);
    scene->materials[0].shininess = 8 * GLINT_ONE;
}

static void build_stretched(test_scene *scene) {
    begin(scene, 0);
    scale_columns(&scene->objects[0].pose, 0.05, 0.05, 5);
}

static void build_eight_lights(test_scene *scene) {
    static const double towards[8][3] = {{1, 0, 0.2}, {-1, 0, 0.3}, {0, 1, 0.1},  {0, -1, 0.4},
                                         {1, 1, 1},   {-1, 1, 0.5}, {1, -1, -.2}, {-.3, -.2, 3}};
    begin(scene, 0);
    for (int i = 0; i < 8; i++) {
        const double *v = towards[i];
        scene->lights[i] = scene->lights[0];
        scene->lights[i].direction = (glint_vector){bench_q16(-v[0]), bench_q16(-v[1]), bench_q16(-v[2])};
        scene->lights[i].diffuse = colour(i & 1 ? 0.3 : 0.05, i & 2 ? 0.25 : 0, i & 4 ? 0.2 : 0.1);
        scene->lights[i].specular = colour(0.4, i & 1 ? 0.1 : 0.5, 0.3);
    }
    scene->scene.light_count = 8;
}

/* Every term above 1: nearly all is clamped, and a sum that wraps shows. */
static void build_saturated(test_scene *scene) {
    build_eight_lights(scene);
    for (int i = 0; i < 8; i++) {
        scene->lights[i].diffuse = colour(4, 3, 0.2);
        scene->lights[i].specular = colour(4, 4, 4);
    }
    scene->materials[0].diffuse = colour(4, 2, 0.3);
    scene->materials[0].specular = colour(4, 1, 0.5);
}

static void build_interlocked(test_scene *scene) {
    begin(scene, 0);
    scene->scene.object_count = 2;
    scene->objects[1].pose = bench_turn(0.8, 1.1);
    place(&scene->objects[0], -0.5, 0, -3.7);
    place(&scene->objects[1], 0.5, 0, -3.5);
    scene->materials[1].diffuse = colour(0.2, 0.6, 0.4);
    scene->materials[1].shininess = bench_q16(77.7);
}

static void build_low_exponents(test_scene *scene) {
    static const double exponents[4] = {0, 0.5, 1, 1.5};
    begin(scene, 3);
    scene->scene.object_count = 4;
    for (int i = 0; i < 4; i++) {
        place(&scene->objects[i], i % 2 ? 1.5 : -1.5, i / 2 ? 1.1 : -1.1, -5);
        scene->materials[i].shininess = bench_q16(exponents[i]);
    }
}

/* From behind, straight against the view, where the half vector vanishes; and from the eye. */
static void build_opposed_lights(test_scene *scene) {
    begin(scene, 0);
    scene->lights[1] = scene->lights[0];
    scene->lights[0].direction = (glint_vector){0, 0, GLINT_ONE};
    scene->lights[1].direction = (glint_vector){0, 0, -GLINT_ONE};
    scene->scene.light_count = 2;
}

static void build_leaning_normals(test_scene *scene) {
    begin(scene, 0);
    scene->objects[0].mesh = &leaning_mesh;
    place(&scene->objects[0], 0, 0, -2.5);
}

static void build_turned_camera(test_scene *scene) {
    begin(scene, 0);
    scene->scene.object_count = 2;
    place(&scene->objects[0], 10, 3, -7);
    place(&scene->objects[1], 12, 3, -6.5);
    const glint_vector eye = {bench_q16(7.3), bench_q16(4.1), bench_q16(-9)};
    const glint_vector at = {bench_q16(10.7), bench_q16(3), bench_q16(-6.9)};
    const glint_vector up = {bench_q16(0.1), GLINT_ONE, 0};
    glint_camera_look_at(&scene->scene.camera, eye, at, up);
    scene->scene.camera.field_of_view = bench_q16(42.5);
}

/* A small object far away: few pixels a triangle, and far from the origin of its mesh. */
static void build_far(test_scene *scene) {
    begin(scene, 2);
    place(&scene->objects[0], 2, 1, -30);
}

/* ---- Random scenes ------------------------------------------------------------------------------------------- */

static glint_vector random_vector(double reach) {
    glint_vector vector;
    vector.x = bench_q16(between(-reach, reach));
    vector.y = bench_q16(between(-reach, reach));
    vector.z = bench_q16(between(-reach, reach));
    return vector;
}

static glint_colour random_colour(double most) {
    double r = between(0, most);
    double g = between(0, most);
    return colour(r, g, between(0, most));
}

/* Turned and scaled by up to a factor of 8 between axes, mirrored half of the time, near `centre`. */
static void place_at_random(glint_object *object, const glint_vector *centre) {
    double about_x = between(-4, 4);
    double x = between(0.25, 2);
    x *= between(0, 1) < 0.5 ? -1 : 1;
    double y = between(0.25, 2);
    object->pose = bench_turn(about_x, between(-4, 4));
    scale_columns(&object->pose, x, y, between(0.25, 2));
    object->pose.m[0][3] = centre->x + bench_q16(between(-1, 1));
    object->pose.m[1][3] = centre->y + bench_q16(between(-1, 1));
    object->pose.m[2][3] = centre->z + bench_q16(between(-1, 1));
}

/* The camera looks at the centre from 4.5 to 6 units away: no object comes nearer to it than a third of a unit. */
static void look_from_random(glint_camera *camera, const glint_vector *centre) {
    double longitude = between(-3.1, 3.1);
    double distance = between(4.5, 6) * 65536;
    glint_vector eye = *centre;
    glint_vector up = {bench_q16(between(-0.3, 0.3)), GLINT_ONE, 0};
    eye.x += (int32_t)(distance * 0.8 * cos(longitude));
    eye.y += (int32_t)(distance * between(-0.6, 0.6));
    eye.z += (int32_t)(distance * 0.8 * sin(longitude));
    glint_camera_look_at(camera, eye, *centre, up);
    camera->field_of_view = bench_q16(between(10, 110));
}

void scene_build_random(test_scene *scene, uint32_t seed) {
    random_state = seed * 2654435761u;
    begin(scene, 0);
    glint_vector centre = random_vector(between(0, 1) < 0.5 ? 5 : 20000);
    look_from_random(&scene->scene.camera, &centre);
    scene->scene.viewer = between(0, 1) < 0.5 ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
    scene->scene.object_count = 1 + (uint32_t)between(0, 3);
    scene->scene.light_count = (uint32_t)between(0, 9);
    for (uint32_t i = 0; i < scene->scene.object_count; i++) {
        scene->objects[i].mesh = &scene_clustered_mesh(between(0, 1) < 0.5 ? 1 : 3)->mesh;
        place_at_random(&scene->objects[i], &centre);
        scene->materials[i].ambient = random_colour(0.3);
        scene->materials[i].diffuse = random_colour(0.8);
        scene->materials[i].specular = random_colour(0.8);
        scene->materials[i].shininess = bench_q16(exp(between(0.7, 6)));
    }
    for (uint32_t i = 0; i < scene->scene.light_count; i++) {
        scene->lights[i].type = &glint_light_directional;
        const glint_vector from = random_vector(1);
        scene->lights[i].direction = (glint_vector){-from.x, -from.y, -from.z};
        scene->lights[i].diffuse = random_colour(1);
        scene->lights[i].specular = random_colour(1);
    }
}

void scene_make_parallel(glint_scene *scene) {
    const glint_camera *const camera = &scene->camera;
    double away = 0;
    for (int i = 0; i < 3; i++)
        away += ((double)camera->pose.m[i][3] - scene->objects[0].pose.m[i][3]) * camera->pose.m[i][2] / 65536;
    const double height = 2 * away * tan(camera->field_of_view / 65536.0 * 3.14159265358979323846 / 360);
    scene->camera.projection = &glint_orthographic;
    scene->camera.view_height = height > 256 ? (glint_q16)height : 256;
}

const glint_evaluation *const scene_evaluations[3] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};

void scene_evaluate(test_scene *scene, const glint_evaluation *evaluation) {
    for (uint32_t i = 0; i < scene->scene.object_count; i++)
        scene->objects[i].evaluation = evaluation;
}

const scene_definition scene_definitions[] = {
    {"near plane", build_near_plane},
    {"near plane, double-sided", build_near_double_sided},
    {"floor to the horizon", build_floor},
    {"guard band", build_guard_band},
    {"mirrored", build_mirrored},
    {"mirrored, double-sided", build_mirrored_double_sided},
    {"scaled 1:0.01:0.5", build_squashed},
    {"scaled 0.05:0.05:5", build_stretched},
    {"eight lights", build_eight_lights},
    {"saturated", build_saturated},
    {"interlocked", build_interlocked},
    {"p of 0, 0.5, 1, 1.5", build_low_exponents},
    {"opposed lights", build_opposed_lights},
    {"leaning normals", build_leaning_normals},
    {"turned camera", build_turned_camera},
    {"far away", build_far},
};
const unsigned scene_count = sizeof scene_definitions / sizeof scene_definitions[0];

void scene_build(test_scene *scene, const scene_definition *definition) {
    definition->build(scene);
}

void scene_build_named(test_scene *scene, const char *name) {
    for (unsigned i = 0; i < scene_count; i++) {
        if (strcmp(scene_definitions[i].name, name) == 0) {
            scene_build(scene, &scene_definitions[i]);
            return;
        }
    }
    fprintf(stderr, "no scene is called %s\n", name);
    exit(1);
}
