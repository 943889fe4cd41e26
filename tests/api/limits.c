/* SPDX-License-Identifier: MIT */
/* Suite: arguments at and beyond the limits that the headers state, function by function. */
#include "glint_extras.h"
#include "harness.h"

#include <string.h>

#define WIDTH 32
#define HEIGHT 16

static uint8_t arena[1 << 16], pixels[1 << 14];

static int take(void *context, int x, int y, int width, int height, const void *sent, size_t stride) {
    (void)context, (void)x, (void)y, (void)width, (void)height, (void)sent, (void)stride;
    return 0;
}

/* One triangle before the camera, as wide as the screen is high. */
typedef struct stage {
    glint_config config;
    glint_renderer renderer;
    glint_scene scene;
    glint_mesh mesh;
    glint_mesh_layout layout;
    glint_material material;
    glint_object object;
    glint_light light;
} stage;

static const int16_t corners[3][3] = {{-32767, -32767, 0}, {32767, -32767, 0}, {0, 32767, 0}},
                     normals[3][3] = {{0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}};
static const uint16_t triangle[1][3] = {{0, 1, 2}};
static const uint8_t colours[3][3] = {{255, 0, 0}, {255, 0, 0}, {255, 0, 0}};

static stage *begin(void) {
    static stage s;
    memset(&s, 0, sizeof s);
    s.config = (glint_config){.width = WIDTH,
                              .height = HEIGHT,
                              .format = &glint_format_rgb888,
                              .flush = {.begin = take},
                              .arena = arena,
                              .arena_size = sizeof arena};
    s.mesh = (glint_mesh){.positions = corners,
                          .normals = normals,
                          .triangles = triangle,
                          .vertex_count = 3,
                          .triangle_count = 1,
                          .extent = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    s.material = (glint_material){.model = &glint_model_lambert, .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    s.light = (glint_light){.type = &glint_light_directional,
                            .direction = {0, 0, -GLINT_ONE},
                            .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    s.object = (glint_object){.mesh = &s.mesh,
                              .material = &s.material,
                              .evaluation = &glint_per_fragment,
                              .pose = glint_pose_translate(0, 0, 0)};
    s.scene = (glint_scene){.camera = {.field_of_view = 53 * GLINT_ONE, .near_plane = GLINT_ONE / 8},
                            .lights = &s.light,
                            .light_count = 1,
                            .objects = &s.object,
                            .object_count = 1};
    s.scene.camera.pose = glint_pose_translate(0, 0, 2 * GLINT_ONE);
    return &s;
}

/* ---- Layouts ---- */

/* What glint_check says of a scene, and glint_render of the same. */
static void expect(stage *s, glint_status status, const char *words) {
    glint_report report;
    CHECK_EQUAL(glint_check(&s->config, &s->scene, &report), status);
    if (!CHECK(*words ? strstr(report.sentence, words) != NULL : !*report.sentence)) {
        test_write(report.sentence);
        test_write("\n");
    }
    CHECK_EQUAL(glint_init(&s->renderer, &s->config), GLINT_OK);
    CHECK_EQUAL(glint_render(&s->renderer, &s->scene), status);
}

/* A stage whose mesh has all its attributes in a layout, and no array. */
static stage *begin_layout(void) {
    stage *s = begin();
    s->layout = (glint_mesh_layout){.positions = {&glint_attribute_int16, corners, 0},
                                    .normals = {&glint_attribute_int16, normals, 0},
                                    .triangles = {&glint_attribute_uint16, triangle, 0},
                                    .colours = {&glint_attribute_rgb888, colours, 0}};
    s->mesh.positions = s->mesh.normals = NULL;
    s->mesh.triangles = NULL;
    s->mesh.layout = &s->layout;
    return s;
}

static void missing_attributes_are_named(void) {
    stage *s = begin_layout();
    expect(s, GLINT_OK, "");
    s->layout.positions.data = NULL;
    expect(s, GLINT_ERROR_NULL, "positions are null");
    s = begin_layout();
    s->layout.normals.data = NULL;
    expect(s, GLINT_ERROR_NULL, "normals are null");
    s = begin_layout();
    s->layout.triangles.type = NULL;
    expect(s, GLINT_ERROR_NULL, "triangles are null");
    s = begin_layout();
    s->layout.colours.data = NULL;
    expect(s, GLINT_ERROR_NULL, "colours are null");
    s = begin_layout();
    s->material.model = NULL;
    expect(s, GLINT_ERROR_NULL, "model is null");
}

/* A layout that names no type stands for no array. */
static void empty_layouts_are_none(void) {
    stage *s = begin();
    s->mesh.layout = &s->layout;
    expect(s, GLINT_OK, "");
    s->mesh.positions = NULL;
    expect(s, GLINT_ERROR_NULL, "positions are null");
    s = begin();
    s->mesh.layout = &s->layout;
    s->mesh.normals = NULL;
    expect(s, GLINT_ERROR_NULL, "normals are null");
}

/* An array of colours comes before the layout's, of which nothing is read. */
static void arrays_come_first(void) {
    stage *s = begin_layout();
    s->layout.colours.data = NULL;
    s->mesh.colours = colours;
    expect(s, GLINT_OK, "");
    static const uint16_t colours565[3] = {0xf800, 0xf800, 0xf800};
    s->mesh.colours = NULL;
    s->mesh.colours565 = colours565;
    expect(s, GLINT_OK, "");
}

/* ---- Check ---- */

static void what_is_missing_is_named(void) {
    glint_report report;
    stage *s = begin();
    CHECK_EQUAL(glint_check(&s->config, NULL, &report), GLINT_ERROR_NULL);
    CHECK(strstr(report.sentence, "scene is null") != NULL);
    s->config.pixels = pixels;
    s->config.pixels_size = sizeof pixels;
    expect(s, GLINT_OK, "");
    s->config.pixels = NULL;
    /* a pose of integers, which makes the object nearly a point */
    s->object.pose = (glint_pose){{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    CHECK_EQUAL(glint_check(&s->config, &s->scene, &report), GLINT_OK);
    CHECK(strstr(report.sentence, "pose") != NULL);
    CHECK_EQUAL(report.object, 0);
}

/* ---- Pick and regions ---- */

static void picking_looks_at_the_screen_alone(void) {
    static const int places[][2] = {{-1, 0}, {0, -1}, {WIDTH, 0}, {0, HEIGHT}};
    stage *s = begin();
    glint_hit hit = {7, 7, 7}, same;
    CHECK_EQUAL(glint_pick(&s->renderer, &s->scene, 0, 0, &hit), GLINT_ERROR_NULL); /* not set up */
    CHECK_EQUAL(glint_init(&s->renderer, &s->config), GLINT_OK);
    for (unsigned i = 0; i < TEST_COUNT(places); i++)
        CHECK_EQUAL(glint_pick(&s->renderer, &s->scene, places[i][0], places[i][1], &hit), GLINT_ERROR_REGION);
    CHECK_EQUAL(glint_pick(&s->renderer, &s->scene, WIDTH - 1, HEIGHT - 1, &hit), 0);
    CHECK(hit.object == 7 && hit.triangle == 7 && hit.depth == 7);
    CHECK_EQUAL(glint_pick(&s->renderer, &s->scene, WIDTH / 2, HEIGHT / 2, &hit), 1);
    CHECK(hit.object == 0 && hit.triangle == 0 && hit.depth > 0);
    /* where tiles lie outside of the arena too */
    s->config.pixels = pixels;
    s->config.pixels_size = sizeof pixels;
    CHECK_EQUAL(glint_init(&s->renderer, &s->config), GLINT_OK);
    CHECK_EQUAL(glint_pick(&s->renderer, &s->scene, WIDTH / 2, HEIGHT / 2, &same), 1);
    CHECK(same.object == hit.object && same.triangle == hit.triangle && same.depth == hit.depth);
}

/* ---- Arenas ---- */

#define TORUS_VERTICES (48 * 24)
#define TORUS_TRIANGLES (2 * 48 * 24)

/* A torus of many more triangles than most arenas here can hold at once. */
static void begin_torus(stage *s, uint16_t numbers[TORUS_TRIANGLES][3]) {
    static int16_t positions[TORUS_VERTICES][3], directions[TORUS_VERTICES][3];
    const glint_mesh_room room = {positions, directions, numbers, TORUS_VERTICES, TORUS_TRIANGLES};
    CHECK_EQUAL(glint_generate_torus(&s->mesh, &room, 48, 24, GLINT_ONE / 2, GLINT_ONE / 4), GLINT_OK);
}

/* What is hidden takes nothing of the arena. */
static void hidden_objects_need_nothing(void) {
    static uint16_t numbers[TORUS_TRIANGLES][3];
    stage *s = begin();
    glint_need alone, beside;
    static glint_object objects[2];
    begin_torus(s, numbers);
    objects[0] = objects[1] = s->object;
    s->scene.objects = objects;
    CHECK_EQUAL(glint_arena_need(&s->config, &s->scene, &alone), GLINT_OK);
    objects[1].hidden = 1;
    s->scene.object_count = 2;
    CHECK_EQUAL(glint_arena_need(&s->config, &s->scene, &beside), GLINT_OK);
    CHECK(beside.least == alone.least && beside.one_pass == alone.one_pass);
    objects[1].hidden = 0;
    CHECK_EQUAL(glint_arena_need(&s->config, &s->scene, &beside), GLINT_OK);
    CHECK(beside.one_pass > alone.one_pass);
}

/* ---- Lines and points ---- */

static int draw_lines(void *context, const glint_tile *tile) {
    int *const count = context;
    static const glint_segment none;
    glint_tile lost = *tile;
    CHECK_EQUAL(glint_lines_draw(NULL, &none, 1), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_lines_draw(tile, NULL, 1), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_lines_draw(tile, NULL, 0), GLINT_OK);
    CHECK_EQUAL(glint_lines_draw(tile, &none, 1), GLINT_OK);
    lost.workspace = NULL;
    CHECK_EQUAL(glint_lines_draw(&lost, &none, 1), GLINT_ERROR_NULL);
    lost = *tile;
    lost.frame = NULL;
    CHECK_EQUAL(glint_lines_draw(&lost, &none, 1), GLINT_ERROR_NULL);
    ++*count;
    return 0;
}

static void lines_are_drawn_on_tiles_of_a_frame(void) {
    static int count;
    stage *s = begin();
    count = 0;
    s->config.overlay = (glint_painter){draw_lines, &count};
    CHECK_EQUAL(glint_init(&s->renderer, &s->config), GLINT_OK);
    CHECK_EQUAL(glint_render(&s->renderer, &s->scene), GLINT_OK);
    CHECK(count > 0);
}

static void colours_of_lines_are_checked(void) {
    static const glint_colour bad[] = {{-1, 0, 0},
                                       {0, -1, 0},
                                       {0, 0, -1},
                                       {GLINT_COLOUR_MAX + 1, 0, 0},
                                       {0, GLINT_COLOUR_MAX + 1, 0},
                                       {0, 0, GLINT_COLOUR_MAX + 1}};
    stage *s = begin();
    const glint_pose pose = glint_pose_translate(0, 0, 0);
    glint_line lines[2] = {{{0, 0, 0}, {GLINT_ONE, 0, 0}, {0, GLINT_COLOUR_MAX, 0}}};
    glint_segment segments[2];
    CHECK_EQUAL(glint_lines_project(segments, &s->config, &s->scene.camera, &pose, lines, 1), GLINT_OK);
    for (unsigned i = 0; i < TEST_COUNT(bad); i++) {
        lines[1].colour = bad[i];
        CHECK_EQUAL(glint_lines_project(segments, &s->config, &s->scene.camera, &pose, lines, 2), GLINT_ERROR_COLOUR);
    }
}

/* Vertices beyond the range of places stop at its ends. */
static void edges_saturate(void) {
    stage *s = begin();
    glint_line lines[3];
    s->mesh.offset = (glint_vector){INT32_MIN, INT32_MAX, 0};
    CHECK_EQUAL(glint_lines_edges(lines, 3, &s->mesh, (glint_colour){0, 0, 0}), 3);
    CHECK_EQUAL(lines[0].from.x, INT32_MIN);
    CHECK_EQUAL(lines[0].to.x, INT32_MIN + GLINT_ONE - 2);
    CHECK_EQUAL(lines[0].from.y, INT32_MAX - GLINT_ONE + 2);
    CHECK_EQUAL(lines[1].to.y, INT32_MAX);
}

/* An orthographic view of all there is, on a screen of a few rows: a line's ends are where the height says. */
static void widest_views_have_lines(void) {
    stage *s = begin();
    const glint_pose pose = glint_pose_translate(0, 0, 0);
    const glint_line line = {{INT32_MAX / 4, 0, 0}, {-(INT32_MAX / 4), INT32_MAX / 2, 0}, {GLINT_ONE, 0, 0}};
    glint_segment segment;
    s->config.height = 8;
    s->scene.camera.projection = &glint_orthographic;
    s->scene.camera.view_height = INT32_MAX;
    CHECK_EQUAL(glint_lines_project(&segment, &s->config, &s->scene.camera, &pose, &line, 1), GLINT_OK);
    CHECK(segment.colour == &line.colour);
    CHECK_EQUAL(segment.x[0], 16 * (WIDTH / 2 + 2)); /* a quarter of the height right of the centre */
    CHECK_EQUAL(segment.y[0], 16 * 4);
    CHECK_EQUAL(segment.x[1], 16 * (WIDTH / 2 - 2));
    CHECK_EQUAL(segment.y[1], 0);
}

static void points_far_aside_saturate(void) {
    stage *s = begin();
    glint_screen_point place = {1, 2, 3};
    s->scene.camera.near_plane = 1;
    s->scene.camera.pose = glint_pose_translate(0, 0, 0);
    CHECK_EQUAL(glint_camera_project(&s->config, &s->scene.camera, (glint_vector){0, 0, -1}, NULL), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_camera_project(&s->config, &s->scene.camera, (glint_vector){INT32_MIN, INT32_MIN, -1}, &place),
                1);
    CHECK_EQUAL(place.x, INT32_MIN);
    CHECK_EQUAL(place.y, INT32_MAX);
    CHECK_EQUAL(glint_camera_project(&s->config, &s->scene.camera, (glint_vector){INT32_MAX, INT32_MAX, -1}, &place),
                1);
    CHECK_EQUAL(place.x, INT32_MAX);
    CHECK_EQUAL(place.y, INT32_MIN);
}

/* ---- Sizes ---- */

/* 0 is the answer of what no configuration is, and of each that is not valid. */
static void sizes_of_no_configuration_are_0(void) {
    CHECK_EQUAL(glint_pixels_need(NULL), 0);
    CHECK_EQUAL(glint_workspace_size(NULL), 0);
    CHECK_EQUAL(glint_tile_signature_count(NULL), 0);
    stage *s = begin();
    CHECK_AT_MOST(1, glint_pixels_need(&s->config));
    CHECK_AT_MOST(1, glint_workspace_size(&s->config));
    CHECK_EQUAL(glint_tile_signature_count(&s->config), 1);
    s->config.format = NULL;
    CHECK_EQUAL(glint_pixels_need(&s->config), 0);
    CHECK_EQUAL(glint_workspace_size(&s->config), 0);
    CHECK_EQUAL(glint_tile_signature_count(&s->config), 0);
}

/* ---- Generators ---- */

static void generators_stop_at_their_limits(void) {
    static int16_t positions[257 * 257][3], directions[257 * 257][3];
    static uint16_t numbers[2 * 256 * 256][3];
    const glint_mesh_room room = {positions, directions, numbers, 257 * 257, 2 * 256 * 256};
    glint_mesh mesh;
    memset(&mesh, 0, sizeof mesh);
    CHECK_EQUAL(glint_generate_plane(&mesh, &room, 255, 255, GLINT_ONE, GLINT_ONE), GLINT_OK);
    CHECK_EQUAL(mesh.vertex_count, 65536);
    mesh.positions = NULL;
    CHECK_EQUAL(glint_generate_plane(&mesh, &room, 256, 256, GLINT_ONE, GLINT_ONE), GLINT_ERROR_GENERATOR);
    CHECK_EQUAL(mesh.vertex_count, 257 * 257);
    CHECK(mesh.positions == NULL);
    CHECK_EQUAL(glint_generate_torus(&mesh, &room, 4, 4, 4096 * GLINT_ONE, 4096 * GLINT_ONE), GLINT_OK);
    CHECK_EQUAL(glint_generate_torus(&mesh, &room, 4, 4, 4096 * GLINT_ONE, 4096 * GLINT_ONE + 1),
                GLINT_ERROR_GENERATOR);
}

int test_main(void (*write)(const char *text)) {
    static const test_case cases[] = {
        TEST_CASE(missing_attributes_are_named),
        TEST_CASE(empty_layouts_are_none),
        TEST_CASE(arrays_come_first),
        TEST_CASE(what_is_missing_is_named),
        TEST_CASE(picking_looks_at_the_screen_alone),
        TEST_CASE(hidden_objects_need_nothing),
        TEST_CASE(lines_are_drawn_on_tiles_of_a_frame),
        TEST_CASE(colours_of_lines_are_checked),
        TEST_CASE(edges_saturate),
        TEST_CASE(widest_views_have_lines),
        TEST_CASE(points_far_aside_saturate),
        TEST_CASE(sizes_of_no_configuration_are_0),
        TEST_CASE(generators_stop_at_their_limits),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
