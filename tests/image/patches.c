/* SPDX-License-Identifier: MIT */
/*
 * Bent patches, seen from both sides, of materials that take the larger light and whose highlights show behind the
 * horizon: against the reference. Some have colours of their own, some are of flat facets.
 */
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "random.h"
#include "stability/contract.h"

#include <math.h>
#include <string.h>

#define WIDTH 128
#define HEIGHT 96

/** Vertices along a side, at most. */
#define SIDE_MAX 14

/* Flat facets have corners of their own. */
#define FACETS_MAX (2 * SIDE_MAX * SIDE_MAX)

/* Steps of a mesh from its middle to a side; 2048 are 1. */
#define HALF_SIDE 9000

typedef struct patch {
    int16_t positions[3 * FACETS_MAX][3], normals[3 * FACETS_MAX][3];
    uint16_t triangles[FACETS_MAX][3];
    uint8_t colours[3 * FACETS_MAX][3];
    glint_mesh mesh;
    glint_material material;
    glint_light lights[2];
    glint_object object;
    glint_scene scene;
} patch;

static glint_q16 fixed(double number) {
    return (glint_q16)lrint(number * GLINT_ONE);
}

/* Turned about y, then about x. */
static void turn(const double angle[2], const double v[3], double to[3]) {
    const double z = v[2] * cos(angle[0]) - v[0] * sin(angle[0]);
    to[0] = v[0] * cos(angle[0]) + v[2] * sin(angle[0]);
    to[1] = v[1] * cos(angle[1]) - z * sin(angle[1]);
    to[2] = v[1] * sin(angle[1]) + z * cos(angle[1]);
}

/* Vertex i, at u, v from -1/2 to 1/2, of a patch so bent. */
static void set_vertex(patch *p, int i, double u, double v, const double bend[2], const double angle[2]) {
    const double a = bend[0] * u, b = bend[1] * v;
    const double place[3] = {2 * u, 2 * v, (cos(a) + cos(b) - 2) * 0.7};
    const double normal[3] = {sin(a), sin(b), 1.2 * cos(a) * cos(b) + 0.1};
    double here[3], unit[3];
    turn(angle, place, here);
    turn(angle, normal, unit);
    const double length = sqrt(unit[0] * unit[0] + unit[1] * unit[1] + unit[2] * unit[2]);
    for (int c = 0; c < 3; c++) {
        p->positions[i][c] = (int16_t)lrint(HALF_SIDE * here[c] - (c == 2 ? 8192 : 0));
        p->normals[i][c] = (int16_t)lrint(32767 * unit[c] / length);
    }
}

/* How finely patches are divided, and how far they bend, radians. */
typedef struct shape {
    int least_side, most_side;
    double least_bend, most_bend;
} shape;

static const shape fine = {4, SIDE_MAX, 0, 2.6}, coarse = {2, 4, 0.5, 3.1};

static void build_mesh(patch *p, const shape *of) {
    const int side = of->least_side + any(0, of->most_side - of->least_side);
    const double bend[2] = {between(of->least_bend, of->most_bend), between(of->least_bend, of->most_bend)},
                 angle[2] = {between(0, 6.28), between(-1.2, 1.2)};
    uint32_t count = 0;
    for (int i = 0; i < side * side; i++) {
        const int row = i / side, column = i % side;
        set_vertex(p, i, (double)row / (side - 1) - 0.5, (double)column / (side - 1) - 0.5, bend, angle);
    }
    for (int i = 0; i < side * (side - 1); i++) {
        if (i % side == side - 1)
            continue;
        const uint16_t a = (uint16_t)i, b = (uint16_t)(i + side);
        const uint16_t two[2][3] = {{a, b, (uint16_t)(a + 1)}, {(uint16_t)(a + 1), b, (uint16_t)(b + 1)}};
        for (int t = 0; t < 2; t++, count++)
            for (int c = 0; c < 3; c++)
                p->triangles[count][c] = two[t][c];
    }
    p->mesh = (glint_mesh){.positions = (const int16_t(*)[3])p->positions,
                           .normals = (const int16_t(*)[3])p->normals,
                           .triangles = (const uint16_t(*)[3])p->triangles,
                           .vertex_count = (uint32_t)(side * side),
                           .triangle_count = count,
                           .flags = GLINT_MESH_DOUBLE_SIDED,
                           .extent = {16 * GLINT_ONE, 16 * GLINT_ONE, 16 * GLINT_ONE}};
}

/* Ambient light is up to 3/5 of what diffuse light is at most, channel by channel another part. */
static void build(patch *p, const shape *of, uint32_t number, uint32_t flags) {
    static const double exponents[] = {2, 5, 10, 20, 50, 100, 300};
    random_state = number * 7919u + 12345u;
    build_mesh(p, of);
    const double diffuse = between(0.1, 1), ambient = between(0, 0.6) * diffuse,
                 specular = below(3) ? between(0.05, 1) : 0;
    const double side = between(0, 6.28), front = between(-0.6, 1), beside = sqrt(1 - front * front);
    p->material =
        (glint_material){.model = &glint_model_blinn_phong,
                         .ambient = {fixed(ambient), fixed(ambient * between(0.3, 1.2)), fixed(ambient * 0.5)},
                         .diffuse = {fixed(diffuse), fixed(diffuse * 0.8), fixed(diffuse * 0.6)},
                         .specular = {fixed(specular), fixed(specular), fixed(specular * 0.8)},
                         .shininess = fixed(exponents[below(TEST_COUNT(exponents))]),
                         .flags = flags};
    p->lights[0] = (glint_light){.type = &glint_light_directional,
                                 .direction = {-fixed(beside * cos(side)), -fixed(beside * sin(side)), -fixed(front)},
                                 .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE},
                                 .specular = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    p->object = (glint_object){
        .mesh = &p->mesh, .material = &p->material, .evaluation = &glint_per_fragment, .pose = glint_pose_identity()};
    p->scene = (glint_scene){.viewer = below(3) ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE,
                             .ambient = {GLINT_ONE, GLINT_ONE, GLINT_ONE},
                             .camera = {glint_pose_identity(), 45 * GLINT_ONE, GLINT_ONE / 8, 0, 0},
                             .lights = p->lights,
                             .light_count = 1,
                             .objects = &p->object,
                             .object_count = 1};
}

/* Gives vertices colours of their own, and half of the patches less light: all of their sums are then below 1. */
static void add_colours(patch *p) {
    for (uint32_t i = 0; i < p->mesh.vertex_count; i++)
        for (int c = 0; c < 3; c++)
            p->colours[i][c] = (uint8_t)below(256);
    p->mesh.colours = (const uint8_t(*)[3])p->colours;
    if (below(2))
        p->material.ambient = (glint_colour){GLINT_ONE - p->material.diffuse.r, GLINT_ONE / 32, 0};
}

/* Gives each triangle three vertices of its own, with its normal. */
static void cut_facets(patch *p) {
    static int16_t places[SIDE_MAX * SIDE_MAX][3];
    memcpy(places, p->positions, sizeof places);
    for (uint32_t t = 0; t < p->mesh.triangle_count; t++) {
        double side[2][3], normal[3];
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 2; k++)
                side[k][c] = places[p->triangles[t][k + 1]][c] - places[p->triangles[t][0]][c];
        for (int c = 0; c < 3; c++)
            normal[c] = side[0][(c + 1) % 3] * side[1][(c + 2) % 3] - side[0][(c + 2) % 3] * side[1][(c + 1) % 3];
        const double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        for (uint32_t k = 0; k < 3; k++) {
            const uint32_t to = 3 * t + k;
            memcpy(p->positions[to], places[p->triangles[t][k]], sizeof p->positions[to]);
            for (int c = 0; c < 3; c++)
                p->normals[to][c] = (int16_t)lrint(32767 * normal[c] / length);
            p->triangles[t][k] = (uint16_t)to;
        }
    }
    p->mesh.vertex_count = 3 * p->mesh.triangle_count;
}

/* A second light, from elsewhere, of half of them. */
static void add_light(patch *p) {
    const glint_vector from = p->lights[0].direction;
    p->lights[1] = p->lights[0];
    p->lights[1].direction = (glint_vector){from.y, from.z, from.x};
    p->scene.light_count = 1 + below(2);
}

static void smooth(patch *p) {
    (void)p;
}

static void coloured(patch *p) {
    add_light(p);
    add_colours(p);
}

static void faceted(patch *p) {
    add_light(p);
    cut_facets(p);
}

/* Of lamps, three away from the patch's middle. */
static void lamplit(patch *p) {
    add_light(p);
    for (uint32_t i = 0; i < p->scene.light_count; i++) {
        glint_light *light = &p->lights[i];
        light->type = &glint_light_point;
        light->position =
            (glint_vector){-3 * light->direction.x, -3 * light->direction.y, -3 * light->direction.z - 4 * GLINT_ONE};
    }
}

/* Of two lamps, or a lamp and a directional light, from anywhere: some set within a large triangle. */
static void setting(patch *p) {
    const int has_sun = (int)below(2);
    if (below(2))
        p->material.specular = (glint_colour){0, 0, 0};
    p->scene.light_count = 2;
    p->lights[1] = p->lights[0];
    for (int i = 0; i < 2; i++) {
        glint_light *light = &p->lights[i];
        const double side = between(0, 6.28), front = between(-1, 0.9), beside = sqrt(1 - front * front),
                     distance = between(1.2, 6);
        const double x = beside * cos(side), y = beside * sin(side);
        const glint_q16 bright = fixed(between(0.3, 1));
        light->type = has_sun && i == 0 ? &glint_light_directional : &glint_light_point;
        light->direction = (glint_vector){-fixed(x), -fixed(y), -fixed(front)};
        light->position =
            (glint_vector){fixed(distance * x), fixed(distance * y), fixed(distance * front) - 4 * GLINT_ONE};
        light->diffuse = light->specular = (glint_colour){bright, bright, bright};
    }
}

/* Of a wide view from nearby. */
static void wide(patch *p) {
    p->material.specular = (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE};
    p->scene.viewer = GLINT_VIEWER_LOCAL;
    p->scene.camera.field_of_view = fixed(between(100, 160));
    p->object.pose = glint_pose_translate(0, 0, fixed(between(1, 3.5)));
}

/* Of a lamp close to a large triangle, in front of it or behind. */
static void close_by(patch *p) {
    static const double exponents[] = {1, 4, 8, 16, 32};
    p->material.specular = (glint_colour){GLINT_ONE / 2, GLINT_ONE / 2, GLINT_ONE / 2};
    p->material.shininess = fixed(exponents[below(TEST_COUNT(exponents))]);
    p->lights[0].type = &glint_light_point;
    p->lights[0].position = (glint_vector){fixed(between(-2, 2)), fixed(between(-2, 2)), fixed(between(-6, -2))};
}

static patch drawn;

static void judge_patches(const glint_format *format, uint32_t count, void (*change)(patch *)) {
    long judged = 0, not_fine = 0;
    for (uint32_t i = 0; i < count; i++) {
        contract_result found;
        build(&drawn, &fine, i, i % 4);
        change(&drawn);
        contract_judge(&drawn.scene, WIDTH, HEIGHT, format, &found);
        CHECK_EQUAL(found.found.status, GLINT_OK);
        if (!CHECK(contract_holds(&found))) {
            test_write("  patch ");
            test_write_number((long)i);
            test_write("\n");
        }
        judged += found.found.judged;
        not_fine += found.found.not_fine;
    }
    test_write("  of ");
    test_write_number(judged);
    test_write(" pixels ");
    test_write_number(not_fine);
    test_write(" are not fine\n");
}

static void patches_keep_the_contract(void) {
    judge_patches(&glint_format_rgb565, 400, smooth);
}

static void coloured_patches_keep_the_contract(void) {
    judge_patches(&glint_format_rgb565, 300, coloured);
}

static void lamplit_patches_keep_the_contract(void) {
    judge_patches(&glint_format_rgb565, 300, lamplit);
}

/* A light that sets within a cell is no reason to smooth over its horizon: of 3,000 patches, these showed it most when
 * cells did not look where lights set. */
static void lights_that_set_keep_the_contract(void) {
    static const uint32_t numbers[] = {1009, 1032, 21038, 22129};
    for (uint32_t i = 0; i < TEST_COUNT(numbers); i++) {
        contract_result found;
        build(&drawn, &coarse, numbers[i], 0);
        setting(&drawn);
        contract_judge(&drawn.scene, WIDTH, HEIGHT, &glint_format_rgb565, &found);
        CHECK_EQUAL(found.found.status, GLINT_OK);
        CHECK(found.found.judged > 1000);
        CHECK(contract_holds(&found));
    }
}

/* Judges single patches. */
static void judge_some(const shape *of, const uint32_t *numbers, uint32_t count, void (*change)(patch *)) {
    for (uint32_t i = 0; i < count; i++) {
        contract_result found;
        build(&drawn, of, numbers[i], numbers[i] % 4);
        change(&drawn);
        contract_judge(&drawn.scene, WIDTH, HEIGHT, &glint_format_rgb565, &found);
        CHECK_EQUAL(found.found.status, GLINT_OK);
        CHECK(found.found.judged > 1000);
        CHECK(contract_holds(&found));
    }
}

/* Highlights between nodes of cells are not lost: of 10,000 patches, these had lost the most while large triangles were
 * drawn in cells where normals or half vectors turn fast. */
static void highlights_between_nodes_keep_the_contract(void) {
    static const uint32_t numbers[] = {352, 575, 4861, 7112, 7783};
    judge_some(&coarse, numbers, TEST_COUNT(numbers), close_by);
}

/* In wide views V turns unevenly from pixel to pixel: of 2,000 patches, these missed the most while half vectors of all
 * views were interpolated as far. */
static void wide_views_keep_the_contract(void) {
    static const uint32_t numbers[] = {490, 565, 631, 821, 1063};
    judge_some(&fine, numbers, TEST_COUNT(numbers), wide);
}

static void faceted_patches_keep_the_contract(void) {
    judge_patches(&glint_format_rgb565, 300, faceted);
}

static void patches_in_8_bits_keep_the_contract(void) {
    judge_patches(&glint_format_rgb888, 200, smooth);
}

/*
 * A cylinder that runs away from the eye, its facets twice as far at one end as at the other: what lies far beside the
 * highlight, where M is half as long, must not pass for part of it.
 */
static void a_long_cylinder_keeps_the_contract(void) {
    static int16_t positions[24][3], normals[24][3];
    static uint16_t triangles[32][3];
    const glint_mesh_room room = {positions, normals, triangles, 24, 32};
    const glint_colour white = {GLINT_ONE, GLINT_ONE, GLINT_ONE};
    const glint_light light = {
        .type = &glint_light_directional, .direction = {-47362, -40564, -60655}, .diffuse = white, .specular = white};
    const glint_material material = {.model = &glint_model_blinn_phong,
                                     .ambient = {5000, 5000, 5000},
                                     .diffuse = {30000, 20000, 10000},
                                     .specular = {65536, 60000, 50000},
                                     .shininess = 95 * GLINT_ONE + GLINT_ONE / 2};
    glint_mesh mesh;
    contract_result found;
    CHECK_EQUAL(glint_generate_cylinder(&mesh, &room, 8, 2, GLINT_ONE, 5 * GLINT_ONE, 0), GLINT_OK);
    const glint_object object = {
        .mesh = &mesh,
        .material = &material,
        .evaluation = &glint_per_fragment,
        .pose = {{{141217, 48616, 849, -37121}, {0, 2607, -149330, -173444}, {-48624, 141195, 2465, -5 * GLINT_ONE}}}};
    const glint_scene scene = {
        .camera = {.pose = glint_pose_identity(), .field_of_view = 44 * GLINT_ONE, .near_plane = 20000},
        .viewer = GLINT_VIEWER_INFINITE,
        .ambient = white,
        .lights = &light,
        .light_count = 1,
        .objects = &object,
        .object_count = 1};
    contract_judge(&scene, 160, 120, &glint_format_rgb565, &found);
    CHECK_EQUAL(found.found.status, GLINT_OK);
    CHECK(found.found.covered > 1000);
    CHECK(contract_holds(&found));
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(patches_keep_the_contract),          TEST_CASE(coloured_patches_keep_the_contract),
        TEST_CASE(lamplit_patches_keep_the_contract),  TEST_CASE(faceted_patches_keep_the_contract),
        TEST_CASE(lights_that_set_keep_the_contract),  TEST_CASE(patches_in_8_bits_keep_the_contract),
        TEST_CASE(a_long_cylinder_keeps_the_contract), TEST_CASE(highlights_between_nodes_keep_the_contract),
        TEST_CASE(wide_views_keep_the_contract),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
