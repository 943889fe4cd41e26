/* SPDX-License-Identifier: MIT */
/*
 * Suite: every size of arena, from none to one byte more than the best. Below the smallest it is refused, from there
 * on the picture is the same.
 */
#include "bench.h"
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "sample.h"
#include "scenes.h"

#include <stdlib.h>
#include <string.h>

#define WIDTH 24
#define HEIGHT 12
#define MATERIALS_MAX 8
#define OBJECTS_MAX 60

static const int16_t points[4][3] = {{0, 32767, 0}, {-32767, -16384, 0}, {32767, -16384, 0}, {0, 0, 32767}};
static const uint16_t sides[4][3] = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}};
static const glint_mesh pyramid = {
    .positions = points,
    .normals = points,
    .triangles = sides,
    .vertex_count = 4,
    .triangle_count = 4,
    .extent = {GLINT_ONE, GLINT_ONE, GLINT_ONE},
};

/* Pyramids side by side, each of a material of its own. */
typedef struct row {
    glint_scene scene;
    glint_light lights[2]; /* the second shows nowhere */
    glint_material materials[MATERIALS_MAX];
    glint_object objects[OBJECTS_MAX];
} row;

/* What is the matter with pyramid i. */
typedef void (*variant)(row *r, uint32_t i);

static void lambert(row *r, uint32_t i) {
    r->materials[i].model = &glint_model_lambert;
}

static void blinn_phong(row *r, uint32_t i) {
    r->materials[i].specular = (glint_colour){GLINT_ONE / 2, GLINT_ONE / 4, (glint_q16)i * GLINT_ONE / 8};
}

/* Directional light alone takes one in two. */
static void mixed(row *r, uint32_t i) {
    if (i % 2)
        lambert(r, i);
    else if (i % 4)
        r->materials[i].model = &glint_model_phong;
    else
        r->materials[i].model = &glint_model_unlit;
}

static void per_vertex(row *r, uint32_t i) {
    r->objects[i].evaluation = i % 3 == 0 ? &glint_per_vertex : i % 3 == 1 ? &glint_per_facet : &glint_per_fragment;
}

/* More objects than the smallest arenas have room for, which are all behind the eye. */
static void many_behind_the_eye(row *r, uint32_t i) {
    blinn_phong(r, i);
    for (uint32_t behind = r->scene.object_count; i == 0 && behind < OBJECTS_MAX; behind++) {
        r->objects[behind] = r->objects[0];
        r->objects[behind].pose.m[2][3] = 5 * GLINT_ONE;
        r->scene.object_count = behind + 1;
    }
}

static void build(row *r, uint32_t count, variant change) {
    const glint_colour white = {GLINT_ONE, GLINT_ONE, GLINT_ONE};
    *r = (row){.scene = {.camera = {glint_pose_identity(), 40 * GLINT_ONE, GLINT_ONE / 8}}};
    r->lights[0] =
        (glint_light){&glint_light_directional, {0, 0, 0}, {-GLINT_ONE, -GLINT_ONE, -GLINT_ONE}, white, white};
    r->lights[1] = (glint_light){.type = &glint_light_point};
    r->scene.ambient = white;
    r->scene.lights = r->lights;
    r->scene.light_count = 1 + count % 2;
    r->scene.objects = r->objects;
    r->scene.object_count = count;
    for (uint32_t i = 0; i < count; i++) {
        const glint_q16 level = (glint_q16)(i + 1) * (GLINT_ONE / 10);
        r->materials[i] = (glint_material){.model = &glint_model_blinn_phong, .shininess = 20 * GLINT_ONE};
        r->materials[i].diffuse = (glint_colour){level, GLINT_ONE - level, level / 2};
        r->materials[i].ambient.g = GLINT_ONE / 16;
        r->objects[i] =
            (glint_object){.mesh = &pyramid, .material = &r->materials[i], .evaluation = &glint_per_fragment};
        r->objects[i].pose = glint_pose_translate(((glint_q16)i - 4) * GLINT_ONE, 0, -5 * GLINT_ONE);
        change(r, i);
    }
}

/* Tiles of a few pixels. */
static const picture_options small = {.tile_width = 16, .tile_height = 8};

static picture open_picture(void) {
    return picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
}

static int is_blank(const picture *image) {
    for (size_t i = 0; i < image->size; i++)
        if (image->bytes[i])
            return 0;
    return 1;
}

/* Where what is drawn from changes; all of these are tried. */
static int is_edge(const glint_need *need, size_t size) {
    return size == 1 || size + 1 - need->least <= 2 || size + 1 - need->resident <= 2 || size + 1 >= need->one_pass;
}

/* @return does each size draw the picture, or is refused, as it should? */
static int every_size_is_right(const row *r, uint8_t keeps_arena) {
    picture wanted = open_picture(), got = open_picture();
    const glint_need need = picture_need(&wanted, &r->scene, &small);
    picture_options options = small;
    glint_stats once, stats;
    int right = CHECK(need.least <= need.resident && need.resident <= need.one_pass);
    options.keeps_arena = keeps_arena;
    CHECK_EQUAL(picture_render(&wanted, &r->scene, &options, &once), GLINT_OK);
    CHECK(!is_blank(&wanted));
    for (size_t size = 1; size <= need.one_pass + 1 && right; size++) {
        if (size % sample_share() && !is_edge(&need, size))
            continue;
        const glint_status expected = size < need.least ? GLINT_ERROR_ARENA : GLINT_OK;
        options.arena_size = size;
        memset(got.bytes, 0, got.size);
        right = CHECK_EQUAL(picture_render(&got, &r->scene, &options, &stats), expected);
        if (expected == GLINT_OK)
            right &= CHECK(picture_is_complete(&got) && picture_equal(&wanted, &got));
        if (size >= need.resident)
            right &= CHECK_EQUAL(stats.vertices, once.vertices);
    }
    picture_close(&wanted);
    picture_close(&got);
    return right;
}

/* One material to so many, the last ones also in an arena that is kept from frame to frame. */
static void check_variant(uint32_t most, variant change) {
    row r;
    int right = 1;
    for (uint32_t count = 1; count <= most && right; count++) {
        build(&r, count, change);
        right = every_size_is_right(&r, 0);
    }
    if (right)
        every_size_is_right(&r, 1);
}

static void matt_materials(void) {
    check_variant(MATERIALS_MAX, lambert);
}

static void shining_materials(void) {
    check_variant(3, blinn_phong);
}

static void materials_of_all_models(void) {
    check_variant(MATERIALS_MAX, mixed);
}

static void objects_of_all_evaluations(void) {
    check_variant(4, per_vertex);
}

static void objects_behind_the_eye(void) {
    check_variant(2, many_behind_the_eye);
}

enum { ROUNDS = 12 };
static uint16_t many_sides[4 * ROUNDS][3];
static glint_mesh many_sided;

/* More triangles to a vertex than parts of an object have room for. */
static void many_triangles_of_few_vertices(row *r, uint32_t i) {
    lambert(r, i);
    for (unsigned t = 0; t < TEST_COUNT(many_sides); t++)
        memcpy(many_sides[t], sides[t % 4], sizeof sides[0]);
    many_sided = pyramid;
    many_sided.triangles = (const uint16_t(*)[3])many_sides;
    many_sided.triangle_count = TEST_COUNT(many_sides);
    r->objects[i].mesh = &many_sided;
}

static void triangles_of_few_vertices(void) {
    check_variant(2, many_triangles_of_few_vertices);
}

/* A part has twice as many triangles as vertices: with as many a user would wait for nearly twice as many passes. */
static void few_vertices_cost_few_passes(void) {
    picture image = open_picture();
    picture_options options = small;
    glint_stats stats;
    row r;
    build(&r, MATERIALS_MAX, many_triangles_of_few_vertices);
    options.arena_size = picture_need(&image, &r.scene, &small).least;
    CHECK_EQUAL(picture_render(&image, &r.scene, &options, &stats), GLINT_OK);
    CHECK_AT_MOST(stats.passes, 50); /* 43; and 78 with as many */
    picture_close(&image);
}

/* Pyramids in one place; each side is there twice. */
enum { CROWD = 5000 };
static int16_t crowd_points[4 * CROWD][3];
static uint16_t crowd_sides[8 * CROWD][3];

/* A pass numbers 57344 triangles, and two meshes have more in view. The third is drawn as without them: a user would
 * see it missing, or corners of others. */
static void more_triangles_than_a_pass_numbers(void) {
    picture wanted = open_picture(), got = open_picture();
    const picture_options options = {.tile_width = 32, .tile_height = 16, .arena_size = (size_t)1 << 22};
    glint_mesh crowd = pyramid, half;
    row r;
    for (unsigned i = 0; i < 4 * CROWD; i++)
        memcpy(crowd_points[i], points[i % 4], sizeof points[0]);
    for (unsigned i = 0; i < 8 * CROWD; i++)
        for (int c = 0; c < 3; c++)
            crowd_sides[i][c] = (uint16_t)(i / 4 % CROWD * 4 + sides[i % 4][c]);
    crowd.positions = crowd.normals = (const int16_t(*)[3])crowd_points;
    crowd.triangles = (const uint16_t(*)[3])crowd_sides;
    crowd.vertex_count = 4 * CROWD;
    crowd.triangle_count = 8 * CROWD;
    crowd.flags = GLINT_MESH_DOUBLE_SIDED;
    half = crowd;
    half.triangle_count = 4 * CROWD;
    build(&r, 3, lambert);
    for (int i = 0; i < 3; i++)
        r.objects[i].pose.m[0][3] = (i - 1) * GLINT_ONE;
    CHECK_EQUAL(picture_render(&wanted, &r.scene, &options, 0), GLINT_OK);
    CHECK(!is_blank(&wanted));
    r.objects[0].mesh = &crowd;
    r.objects[1].mesh = &half;
    CHECK_EQUAL(picture_render(&got, &r.scene, &options, 0), GLINT_OK);
    CHECK(picture_equal(&wanted, &got));
    picture_close(&wanted);
    picture_close(&got);
}

/* Highlights so wide that no table serves them. */
static void wide_lobes(row *r, uint32_t i) {
    r->materials[i].model = i % 2 ? &glint_model_phong : &glint_model_blinn_phong;
    r->materials[i].shininess = GLINT_ONE / 2 + (glint_q16)i * GLINT_ONE / 4;
    r->materials[i].specular = (glint_colour){GLINT_ONE / 2, GLINT_ONE / 2, GLINT_ONE / 2};
}

/* What an arena held before does not matter. */
static void arenas_of_any_content(void) {
    static const uint32_t contents[] = {0, 0x7fffffff, 0x80000000, 0xffffffff, 0x7fff8000};
    static const variant variants[] = {wide_lobes, mixed, per_vertex};
    static uint32_t arena[16384];
    for (unsigned v = 0; v < TEST_COUNT(variants); v++) {
        picture wanted = open_picture();
        row r;
        build(&r, 4, variants[v]);
        CHECK_EQUAL(picture_render(&wanted, &r.scene, &small, NULL), GLINT_OK);
        for (unsigned i = 0; i < TEST_COUNT(contents); i++) {
            picture got = open_picture();
            glint_config config = picture_config(&got, &small);
            glint_renderer renderer;
            for (unsigned word = 0; word < TEST_COUNT(arena); word++)
                arena[word] = contents[i];
            config.arena = arena;
            config.arena_size = sizeof arena;
            CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
            CHECK_EQUAL(glint_render(&renderer, &r.scene), GLINT_OK);
            CHECK(picture_equal(&wanted, &got));
            picture_close(&got);
        }
        picture_close(&wanted);
    }
}

/* ---- Pixels apart from the arena ---- */

enum { CACHE_LINE = 64, CANARIES = 32 };

/* A panel that looks where pixels are that it is sent, while it is said to send them. */
typedef struct watched {
    uint8_t *pixels;
    size_t size;
    int tiles, waits, is_apart;
} watched;

static int begin_watched(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    watched *w = context;
    const uint8_t *const at = pixels;
    (void)x, (void)y, (void)width;
    w->tiles++;
    w->is_apart &= at >= w->pixels && at + (size_t)height * stride <= w->pixels + w->size &&
                   (size_t)(at - w->pixels) % CACHE_LINE == 0;
    return 0;
}

static int wait_watched(void *context) {
    ((watched *)context)->waits++;
    return 0;
}

static void fill_canaries(uint8_t *memory, size_t size) {
    memset(memory + size, 0xa5, CANARIES);
}

static int has_canaries(const uint8_t *memory, size_t size) {
    int whole = 1;
    for (size_t i = 0; i < CANARIES; i++)
        whole &= memory[size + i] == 0xa5;
    return whole;
}

/* In each format, with the least arena and memory of pixels: nothing is written beyond either. */
static void check_apart(const glint_format *format, uint16_t tile, int waits) {
    watched w = {.is_apart = 1};
    row r;
    glint_renderer renderer;
    glint_need need, within;
    build(&r, 3, mixed);
    glint_config config = {.width = WIDTH, .height = HEIGHT, .tile_width = tile, .tile_height = tile, .format = format};
    config.flush = (glint_flush){begin_watched, waits ? wait_watched : NULL, &w};
    CHECK_EQUAL(glint_arena_need(&config, &r.scene, &within), GLINT_OK);
    w.size = config.pixels_size = glint_pixels_need(&config);
    config.pixels = w.pixels = malloc(w.size + CANARIES);
    CHECK_EQUAL(glint_arena_need(&config, &r.scene, &need), GLINT_OK);
    CHECK(need.least < within.least);
    config.arena_size = need.least;
    config.arena = malloc(need.least + CANARIES);
    CHECK(config.arena && config.pixels);
    fill_canaries(config.arena, need.least);
    fill_canaries(config.pixels, w.size);
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    CHECK_EQUAL(glint_render(&renderer, &r.scene), GLINT_OK);
    CHECK(w.is_apart && w.tiles > 0 && (w.waits > 0) == waits);
    CHECK(has_canaries(config.arena, need.least) && has_canaries(config.pixels, w.size));
    CHECK_AT_MOST(renderer.stats.arena_used, need.least);
    config.pixels_size--;
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_ERROR_PIXELS);
    config.pixels_size += 2;
    config.pixels = w.pixels + 1;
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_ERROR_PIXELS);
    free(w.pixels);
    free(config.arena);
}

static void pixels_apart(void) {
    static const glint_format *const formats[] = {&glint_format_rgb565,        &glint_format_rgb888,
                                                  &glint_format_rgb444,        &glint_format_grey4_dithered,
                                                  &glint_format_mono_dithered, &glint_format_mono_pages_dithered};
    for (unsigned i = 0; i < TEST_COUNT(formats); i++) {
        check_apart(formats[i], 8, 0);
        check_apart(formats[i], 8, 1);
        check_apart(formats[i], 32, 0);
        check_apart(formats[i], 32, 1);
    }
}

/* ---- Clusters ---- */

/* Clusters are numbered in 16 bits: one more is refused, though they add up to the mesh. */
static void more_clusters_than_numbers(void) {
    enum { MOST = 65536 };
    static glint_cluster list[MOST + 1];
    glint_clusters clusters = {&glint_cull_cones, list, NULL, MOST};
    glint_mesh mesh = pyramid;
    picture none = open_picture();
    row r;
    glint_need need;
    const glint_config config = picture_config(&none, &small);
    build(&r, 1, lambert);
    list[0] = (glint_cluster){.spread = 255, .height = -1, .triangles = 4, .vertices = 4};
    mesh.clusters = &clusters;
    r.objects[0].mesh = &mesh;
    CHECK_EQUAL(glint_arena_need(&config, &r.scene, &need), GLINT_OK);
    CHECK_EQUAL(picture_render(&none, &r.scene, &small, NULL), GLINT_OK);
    clusters.count = MOST + 1;
    CHECK_EQUAL(glint_arena_need(&config, &r.scene, &need), GLINT_ERROR_MESH);
    picture_options options = small;
    options.arena_size = need.one_pass;
    CHECK_EQUAL(picture_render(&none, &r.scene, &options, NULL), GLINT_ERROR_MESH);
    picture_close(&none);
}

/* ---- Indices beyond the mesh ---- */

/* Triangles that each cover the screen. */
enum { COVERS = 200, COVERS_VERTICES = 100 };
static int16_t places[COVERS_VERTICES][3], normals[COVERS_VERTICES][3];
static uint16_t covers_list[COVERS][3];
static const glint_mesh covers = {.positions = (const int16_t (*)[3])places,
                                  .normals = (const int16_t (*)[3])normals,
                                  .triangles = (const uint16_t (*)[3])covers_list,
                                  .vertex_count = COVERS_VERTICES,
                                  .triangle_count = COVERS,
                                  .extent = {20 * GLINT_ONE, 20 * GLINT_ONE, 1}};

static const picture_options smallest = {.tile_width = 8, .tile_height = 8};

/* @return what they need */
static glint_need build_covers(row *r, const picture *image) {
    static const int16_t corners[3][3] = {{-32767, -32767, 0}, {32767, -32767, 0}, {0, 32767, 0}};
    for (int i = 0; i < COVERS_VERTICES; i++) {
        memcpy(places[i], corners[i % 3], sizeof places[i]);
        memcpy(normals[i], points[3], sizeof normals[i]);
    }
    for (int i = 0; i < COVERS; i++)
        for (int c = 0; c < 3; c++)
            covers_list[i][c] = (uint16_t)((3 * i + c) % (COVERS_VERTICES / 3 * 3));
    build(r, 1, lambert);
    r->objects[0].mesh = &covers;
    r->objects[0].pose.m[0][3] = 0;
    return picture_need(image, &r->scene, &smallest);
}

static glint_status render_in(const row *r, size_t size, picture *image, glint_stats *stats) {
    picture_options options = smallest;
    options.arena_size = size;
    return picture_render(image, &r->scene, &options, stats);
}

/* One of them names a vertex that is not there, and another object follows: found with any arena. */
static void bad_indices_are_found_in_any_arena(void) {
    for (int bad = -1; bad < COVERS; bad += bad < 0 ? 1 : COVERS - 1) {
        picture got = open_picture();
        row r;
        build_covers(&r, &got);
        r.objects[1] = r.objects[0];
        r.scene.object_count = 2;
        const glint_need need = picture_need(&got, &r.scene, &smallest);
        if (bad >= 0)
            covers_list[bad][2] = COVERS_VERTICES;
        for (size_t size = need.least; size <= need.one_pass; size += 8) {
            glint_stats stats;
            const glint_status status = render_in(&r, size, &got, &stats);
            if (!CHECK_EQUAL(status, bad < 0 ? GLINT_OK : GLINT_ERROR_INDEX))
                break;
        }
        picture_close(&got);
    }
}

/* Some are without area, or face away: each is counted as dropped, with any arena. */
static void dropped_triangles_are_counted_in_any_arena(void) {
    enum { DROPPED = 20 };
    for (int kind = 0; kind < 2; kind++) {
        picture got = open_picture();
        row r;
        const glint_need need = build_covers(&r, &got);
        for (int i = 0; i < DROPPED; i++) {
            uint16_t *const corners = covers_list[7 * i];
            const uint16_t first = corners[0];
            corners[0] = corners[1];
            corners[1] = kind ? first : corners[0];
        }
        for (size_t size = need.least; size <= need.one_pass; size += 64) {
            glint_stats stats;
            CHECK_EQUAL(render_in(&r, size, &got, &stats), GLINT_OK);
            CHECK(stats.triangles >= COVERS);
            CHECK(stats.facing_away >= DROPPED);
        }
        picture_close(&got);
    }
}

/* ---- Lists at their ends ---- */

enum { WIDE = 256, TILES = (WIDE / 8) * (WIDE / 8) };

static picture draw_wide(const row *r, uint16_t tile, size_t size) {
    picture image = picture_open(WIDE, WIDE, &glint_format_rgb565);
    const picture_options options = {.tile_width = tile, .tile_height = tile, .arena_size = size};
    CHECK_EQUAL(picture_render(&image, &r->scene, &options, NULL), GLINT_OK);
    return image;
}

/* A mesh of triangles before a camera of 90 degrees, each of a colour of its own: so many that cover the screen, so
 * many that show in one tile, last those that the near plane clips. None is farther than the one before it in its
 * group. */
typedef struct crowd {
    int16_t positions[3 * 6000][3];
    uint8_t colours[3 * 6000][3];
    uint16_t triangles[6000][3];
    glint_mesh mesh;
} crowd;

static void add_triangle(crowd *c, const int16_t (*corners)[3], int depth) {
    const uint32_t number = c->mesh.triangle_count;
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t vertex = c->mesh.vertex_count + i;
        memcpy(c->positions[vertex], corners[i], sizeof corners[i]);
        c->positions[vertex][2] = (int16_t)(corners[i][2] + depth);
        c->triangles[number][i] = (uint16_t)vertex;
        for (uint32_t k = 0; k < 3; k++)
            c->colours[vertex][k] = (uint8_t)((number + 1) * (7 + 6 * k));
    }
    c->mesh.vertex_count += 3;
    c->mesh.triangle_count++;
}

static void build_crowd(row *r, crowd *c, int whole, int in_tile, int clipped) {
    static const int16_t covering[3][3] = {{-8000, -4000, 0}, {8000, -4000, 0}, {0, 12000, 0}},
                         in_a_tile[3][3] = {{40, 40, 500}, {120, 40, 500}, {40, 120, 500}},
                         passing[3][3] = {{0, -500, 20000}, {3000, -500, 500}, {-3000, -500, 500}};
    build(r, 1, lambert);
    memset(c, 0, sizeof *c);
    for (int i = 0; i < whole; i++)
        add_triangle(c, covering, i);
    for (int i = 0; i < in_tile; i++)
        add_triangle(c, in_a_tile, i / 4);
    for (int i = 0; i < clipped; i++)
        add_triangle(c, passing, i / 16);
    c->mesh.positions = (const int16_t(*)[3])c->positions;
    c->mesh.normals = (const int16_t(*)[3])c->positions;
    c->mesh.colours = (const uint8_t(*)[3])c->colours;
    c->mesh.triangles = (const uint16_t(*)[3])c->triangles;
    c->mesh.extent = (glint_vector){32 * GLINT_ONE, 32 * GLINT_ONE, 32 * GLINT_ONE};
    r->scene.camera.field_of_view = 90 * GLINT_ONE;
    r->objects[0].mesh = &c->mesh;
    r->objects[0].pose = glint_pose_translate(0, 0, -3 * GLINT_ONE);
    r->objects[0].evaluation = &glint_per_facet;
}

static void check_crowd(int whole, int in_tile, int clipped, uint16_t tile, size_t large) {
    static crowd c;
    row r;
    build_crowd(&r, &c, whole, in_tile, clipped);
    picture one = draw_wide(&r, tile, large), other = draw_wide(&r, 64, 300000);
    CHECK(!is_blank(&one));
    CHECK(picture_equal(&one, &other));
    picture_close(&one);
    picture_close(&other);
}

/* References are numbered up to 65534: the last few do not do for a clipped triangle, and the pass ends before it. */
static void lists_of_most_references(void) {
    const int whole = 65534 / TILES - 2;
    for (int left = 4; left < 7; left++)
        check_crowd(whole, 65535 - TILES * (1 + whole) - left, 2, 8, 1 << 21);
}

/* So are clipped triangles, up to 8190. */
static void lists_of_most_clipped(void) {
    check_crowd(0, 0, 4500, 64, 4 << 20);
}

/* Where a clipped triangle's first part is in many tiles, its second may find no room: in steps below a part's size. */
static void parts_in_many_tiles(void) {
    static crowd c;
    row r;
    build_crowd(&r, &c, 0, 0, 3);
    picture wanted = draw_wide(&r, 8, 0);
    const glint_need need = picture_need(&wanted, &r.scene, &smallest);
    int same = 1;
    for (size_t size = need.resident; size < need.one_pass && same; size += 32) {
        picture got = draw_wide(&r, 8, size);
        same = CHECK(picture_equal(&wanted, &got));
        picture_close(&got);
    }
    picture_close(&wanted);
}

/* Squares that all lie in one quarter of the tiles need as much in each, and are transformed once a frame there. */
static void quarters_need_the_same(void) {
    enum { SQUARES = 40 };
    const glint_mesh square = scene_square_mesh(28 * GLINT_ONE, GLINT_ONE);
    const glint_material paint = {.model = &glint_model_unlit};
    picture image = picture_open(64, 256, &glint_format_rgb565);
    picture_options options = {.tile_width = 8, .tile_height = 8};
    glint_config config = picture_config(&image, &options);
    glint_object objects[SQUARES];
    const glint_scene scene = {.camera = {.pose = glint_pose_identity(),
                                          .near_plane = GLINT_ONE,
                                          .projection = &glint_orthographic,
                                          .view_height = 256 * GLINT_ONE},
                               .objects = objects,
                               .object_count = SQUARES};
    glint_need first = {0};
    for (int quarter = 0; quarter < 4; quarter++) {
        for (int i = 0; i < SQUARES; i++)
            objects[i] =
                (glint_object){.mesh = &square,
                               .material = &paint,
                               .pose = glint_pose_translate(0, (96 - 64 * quarter) * GLINT_ONE, -(2 + i) * GLINT_ONE)};
        glint_need need = {0};
        glint_stats stats = {0};
        CHECK_EQUAL(glint_arena_need(&config, &scene, &need), GLINT_OK);
        first = quarter ? first : need;
        CHECK(need.least < need.resident);
        CHECK_EQUAL(need.resident, first.resident);
        options.arena_size = need.resident;
        CHECK_EQUAL(picture_render(&image, &scene, &options, &stats), GLINT_OK);
        CHECK_EQUAL(stats.vertices, 4 * SQUARES);
    }
    picture_close(&image);
}

/* Where passes draw parts of objects, triangles share transformed vertices: without that a user would wait longer. */
static void parts_share_vertices(void) {
    picture image = picture_open(320, 240, &glint_format_rgb565);
    picture_options options = {.tile_width = 32, .tile_height = 32};
    bench_scene scene;
    glint_stats once, parts;
    bench_build_scene(&scene, &bench_definitions[0], scene_bench_mesh(0), 3);
    const glint_need need = picture_need(&image, &scene.scene, &options);
    CHECK_EQUAL(picture_render(&image, &scene.scene, &options, &once), GLINT_OK);
    options.arena_size = need.least + (need.resident - need.least) / 2;
    CHECK_EQUAL(picture_render(&image, &scene.scene, &options, &parts), GLINT_OK);
    CHECK_AT_MOST(parts.vertices, 6 * once.vertices); /* 3.8; and 17 without a cache */
    picture_close(&image);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(matt_materials),
        TEST_CASE(shining_materials),
        TEST_CASE(materials_of_all_models),
        TEST_CASE(objects_of_all_evaluations),
        TEST_CASE(objects_behind_the_eye),
        TEST_CASE(triangles_of_few_vertices),
        TEST_CASE(few_vertices_cost_few_passes),
        TEST_CASE(more_triangles_than_a_pass_numbers),
        TEST_CASE(arenas_of_any_content),
        TEST_CASE(pixels_apart),
        TEST_CASE(more_clusters_than_numbers),
        TEST_CASE(bad_indices_are_found_in_any_arena),
        TEST_CASE(dropped_triangles_are_counted_in_any_arena),
        TEST_CASE(lists_of_most_references),
        TEST_CASE(lists_of_most_clipped),
        TEST_CASE(parts_in_many_tiles),
        TEST_CASE(quarters_need_the_same),
        TEST_CASE(parts_share_vertices),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
