/* SPDX-License-Identifier: MIT */
#include "surfaces.h"
#include "random.h"

#include <math.h>

static const glint_material clay = {.model = &glint_model_blinn_phong,
                                    .ambient = {GLINT_Q16(0.1), GLINT_Q16(0.08), GLINT_Q16(0.05)},
                                    .diffuse = {GLINT_Q16(0.5), GLINT_Q16(0.45), GLINT_Q16(0.4)},
                                    .specular = {GLINT_Q16(0.4), GLINT_Q16(0.4), GLINT_Q16(0.3)},
                                    .shininess = GLINT_Q16(20)};

static const glint_light lamp = {.type = &glint_light_point,
                                 .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE},
                                 .specular = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};

static uint8_t colours[BENCH_VERTICES_MAX][3];
static uint16_t colours565[BENCH_VERTICES_MAX];
static glint_mesh mesh; /* of the scene at hand, where it differs from the benchmark's */

static void place(glint_object *object, double x, double y, double z) {
    object->pose.m[0][3] = bench_q16(x);
    object->pose.m[1][3] = bench_q16(y);
    object->pose.m[2][3] = bench_q16(z);
}

static glint_vector vector(double x, double y, double z) {
    return (glint_vector){bench_q16(x), bench_q16(y), bench_q16(z)};
}

/* A torus, a material whose weights sum to 1, a point light before it. */
static void begin(test_scene *scene) {
    scene_build_named(scene, "mirrored");
    mesh = scene_bench_mesh(1)->mesh;
    scene->objects[0].mesh = &mesh;
    scene->objects[0].pose = bench_turn(-0.8, 0.6);
    place(&scene->objects[0], 0, 0, -3.7);
    for (int i = 0; i < SCENE_OBJECTS_MAX; i++)
        scene->materials[i] = clay;
    scene->scene.ambient = (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE};
    scene->lights[0] = lamp;
    scene->lights[0].position = vector(1, 1.5, -1.5);
}

/* The camera-space point at (x, y, z) of the torus's own space. */
static glint_vector on_object(const test_scene *scene, double x, double y, double z) {
    const int32_t(*m)[4] = scene->objects[0].pose.m;
    const double local[3] = {x, y, z};
    double world[3];
    for (int row = 0; row < 3; row++) {
        world[row] = m[row][3] / 65536.0;
        for (int column = 0; column < 3; column++)
            world[row] += m[row][column] / 65536.0 * local[column];
    }
    return vector(world[0], world[1], world[2]);
}

static void build_light_on_surface(test_scene *scene) {
    begin(scene);
    scene->lights[0].position = on_object(scene, 1.2828, 0, 0.2828);
}

static void build_light_on_vertex(test_scene *scene) {
    begin(scene);
    const int16_t *steps = mesh.positions[2];
    scene->lights[0].position =
        on_object(scene, mesh.extent.x / 65536.0 * steps[0] / 32768, mesh.extent.y / 65536.0 * steps[1] / 32768,
                  mesh.extent.z / 65536.0 * steps[2] / 32768);
}

/* A twentieth above the surface: its light ends at a sharp edge. */
static void build_light_above_surface(test_scene *scene) {
    begin(scene);
    scene->lights[0].position = on_object(scene, 1.0, 0, 0.45);
    scene->lights[0].linear = GLINT_ONE;
}

/* Within the tube, which is open to it: the other side of the torus is lit. */
static void build_light_inside(test_scene *scene) {
    begin(scene);
    scene->lights[0].position = on_object(scene, 1, 0, 0);
    scene->lights[0].linear = GLINT_ONE / 2;
}

static void build_light_at_the_eye(test_scene *scene) {
    begin(scene);
    scene->lights[0].position = vector(0, 0, 0);
}

static void build_light_far_away(test_scene *scene) {
    begin(scene);
    scene->lights[0].position = vector(20000, 16000, 12000);
}

static void build_strong_attenuation(test_scene *scene) {
    begin(scene);
    scene->lights[0].linear = INT32_MAX;
    scene->lights[0].quadratic = INT32_MAX;
    scene->lights[0].position = on_object(scene, 1.0, 0, 0.41);
}

static void build_square_of_distance(test_scene *scene) {
    begin(scene);
    scene->lights[0].quadratic = bench_q16(0.25);
}

static void make_spot(glint_light *light, double inner, double outer) {
    light->type = &glint_light_spot;
    light->position = vector(0.5, 1, -1.5);
    light->direction = vector(-0.5, -0.8, -2);
    light->inner = bench_q16(inner);
    light->outer = bench_q16(outer);
}

static void build_point_cone(test_scene *scene) {
    begin(scene);
    make_spot(&scene->lights[0], 0, 0);
}

static void build_narrow_step(test_scene *scene) {
    begin(scene);
    make_spot(&scene->lights[0], 19.5, 20);
}

static void build_wide_step(test_scene *scene) {
    begin(scene);
    make_spot(&scene->lights[0], 0, 40);
}

static void build_half_space(test_scene *scene) {
    begin(scene);
    make_spot(&scene->lights[0], 90, 90);
    scene->lights[0].position = vector(0.5, 1, -3.5);
}

static void build_all_but_a_cone(test_scene *scene) {
    begin(scene);
    make_spot(&scene->lights[0], 160, 175);
    scene->lights[0].direction = vector(0.5, 0.8, 2);
}

/* ---- Meshes -------------------------------------------------------------------------------------------------- */

/* All that 8 and 16 bits can hold, neighbours far apart. */
static void fill_colours(void) {
    for (uint32_t i = 0; i < BENCH_VERTICES_MAX; i++) {
        for (uint32_t channel = 0; channel < 3; channel++)
            colours[i][channel] = (uint8_t)(i % 7 == channel ? 0 : i % 5 == channel ? 255 : i * (37 + 60 * channel));
        colours565[i] = (uint16_t)(i * 40503u);
    }
}

static void build_colours(test_scene *scene) {
    begin(scene);
    fill_colours();
    mesh.colours = (const uint8_t(*)[3])colours;
}

static void build_colours565(test_scene *scene) {
    begin(scene);
    fill_colours();
    mesh.colours565 = colours565;
}

static void build_unlit_colours(test_scene *scene) {
    build_colours(scene);
    scene->materials[0].model = &glint_model_unlit;
    scene->materials[0].diffuse = (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE / 2};
}

static void build_largest_of_colours(test_scene *scene) {
    build_colours565(scene);
    scene->materials[0].flags = GLINT_MATERIAL_MAX_WITH_AMBIENT;
    scene->materials[0].ambient = (glint_colour){GLINT_Q16(0.4), GLINT_Q16(0.3), GLINT_Q16(0.2)};
}

/* From within a torus that is open towards the eye: its back is seen. */
static void build_double_sided(test_scene *scene) {
    begin(scene);
    mesh.flags = GLINT_MESH_DOUBLE_SIDED;
    mesh.triangle_count = mesh.triangle_count / 2;
    scene->lights[0].position = vector(0, 0.4, -3.5);
}

static void build_double_sided_mirrored(test_scene *scene) {
    build_double_sided(scene);
    for (int row = 0; row < 3; row++)
        scene->objects[0].pose.m[row][0] = -scene->objects[0].pose.m[row][0];
    fill_colours();
    mesh.colours = (const uint8_t(*)[3])colours;
}

static void build_clipped(test_scene *scene) {
    begin(scene);
    place(&scene->objects[0], 0.2, 0.1, -0.7);
    scene->scene.camera.near_plane = bench_q16(0.5);
    scene->lights[0].position = vector(0.3, 1, 0.5);
}

static void build_clipped_double_sided(test_scene *scene) {
    build_clipped(scene);
    mesh.flags = GLINT_MESH_DOUBLE_SIDED;
    fill_colours();
    mesh.colours = (const uint8_t(*)[3])colours;
}

/* A floor whose two triangles reach from w = 0.5 to 50, seen low. */
static void build_long_floor(test_scene *scene) {
    scene_build_named(scene, "floor to the horizon");
    mesh = *scene->objects[0].mesh;
    mesh.extent = (glint_vector){4 * GLINT_ONE, GLINT_ONE, bench_q16(24.75)};
    scene->objects[0].mesh = &mesh;
    place(&scene->objects[0], 0, -0.2, -25.25);
    scene->materials[0] = clay;
    scene->scene.ambient = (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE};
    scene->lights[0] = lamp;
    scene->lights[0].position = vector(0.2, 1, -1.5);
    scene->lights[0].linear = GLINT_ONE / 4;
}

static void build_long_floor_of_colours(test_scene *scene) {
    static const uint8_t corners[4][3] = {{255, 0, 0}, {0, 255, 255}, {255, 255, 255}, {0, 0, 255}};
    build_long_floor(scene);
    mesh.colours = corners;
}

/* Turned, so that w changes along every edge. */
static void build_leaning_floor(test_scene *scene) {
    build_long_floor_of_colours(scene);
    const glint_pose lean = glint_pose_rotate_x(bench_q16(4));
    const glint_pose turn = glint_pose_rotate_z(bench_q16(-50));
    const glint_pose both = glint_pose_then(&turn, &lean);
    scene->objects[0].pose = glint_pose_then(&both, &scene->objects[0].pose);
}

static void build_floor_through_the_eye(test_scene *scene) {
    build_long_floor_of_colours(scene);
    place(&scene->objects[0], 0.3, -0.2, -10);
}

/* ---- Random scenes ------------------------------------------------------------------------------------------- */

static void vary_light(glint_light *light, const glint_object *near) {
    static const glint_light_type *const types[] = {&glint_light_directional, &glint_light_point, &glint_light_spot};
    light->type = types[below(3)];
    const glint_vector from = {-light->direction.x, -light->direction.y, -light->direction.z};
    light->inner = bench_q16(below(90));
    light->outer = light->inner + bench_q16(below(90));
    light->linear = bench_q16(below(4) / 4.0);
    light->quadratic = bench_q16(below(4) / 4.0);
    if (light->type == &glint_light_directional)
        return;
    light->direction = from;
    light->position.x = near->pose.m[0][3] + 3 * from.x;
    light->position.y = near->pose.m[1][3] + 3 * from.y;
    light->position.z = near->pose.m[2][3] + 3 * from.z;
}

static void vary_object(glint_object *object, glint_material *material, glint_mesh *own) {
    static const glint_shading_model *const kinds[] = {&glint_model_blinn_phong, &glint_model_phong,
                                                       &glint_model_lambert, &glint_model_unlit};
    const glint_evaluation *const places[] = {&glint_per_fragment, &glint_per_fragment, &glint_per_vertex,
                                              &glint_per_facet};
    material->model = kinds[below(8) % 4 % 3 == 2 ? 2 + below(2) : below(2)];
    material->flags = below(4);
    object->evaluation = places[below(4)];
    *own = *object->mesh;
    own->flags = below(2);
    own->colours = below(3) == 0 ? (const uint8_t(*)[3])colours : NULL;
    own->colours565 = own->colours == NULL && below(3) == 0 ? colours565 : NULL;
    object->mesh = own;
}

void surface_build_random(test_scene *scene, uint32_t seed) {
    static glint_mesh meshes[SCENE_OBJECTS_MAX];
    scene_build_random(scene, seed);
    fill_colours();
    random_state = seed * 2246822519u;
    for (uint32_t i = 0; i < scene->scene.object_count; i++)
        vary_object(&scene->objects[i], &scene->materials[i], &meshes[i]);
    for (uint32_t i = 0; i < scene->scene.light_count; i++)
        vary_light(&scene->lights[i], &scene->objects[0]);
}

const scene_definition surface_definitions[] = {
    {"light on the surface", build_light_on_surface},
    {"light on a vertex", build_light_on_vertex},
    {"light just above the surface", build_light_above_surface},
    {"light inside", build_light_inside},
    {"light at the eye", build_light_at_the_eye},
    {"light far away", build_light_far_away},
    {"strongest attenuation", build_strong_attenuation},
    {"square of the distance", build_square_of_distance},
    {"cone of 0", build_point_cone},
    {"cone of 19.5 to 20", build_narrow_step},
    {"cone of 0 to 40", build_wide_step},
    {"cone of 90", build_half_space},
    {"cone of 160 to 175", build_all_but_a_cone},
    {"mesh colours", build_colours},
    {"mesh colours in 16 bits", build_colours565},
    {"mesh colours, unlit", build_unlit_colours},
    {"mesh colours, max", build_largest_of_colours},
    {"double-sided", build_double_sided},
    {"double-sided, mirrored, colours", build_double_sided_mirrored},
    {"clipped", build_clipped},
    {"clipped, double-sided, colours", build_clipped_double_sided},
    {"w from 0.5 to 50", build_long_floor},
    {"w from 0.5 to 50, colours", build_long_floor_of_colours},
    {"w from 0.5 to 50, leaning", build_leaning_floor},
    {"w from below 0, colours", build_floor_through_the_eye},
};
const unsigned surface_count = sizeof surface_definitions / sizeof surface_definitions[0];
