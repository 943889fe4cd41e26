/* SPDX-License-Identifier: MIT */
/*
 * Suite: surfaces show the texels that they wear: where double precision finds them, in any tiles, arena and region, of
 * every type and size, and up to the extremes of coordinates; and what is no texture is refused by name. A user would
 * see textures bend, swim or shift, seams between tiles, or a picture of memory that is none of his.
 */
#include "glint_extras.h"
#include "harness.h"
#include "judge.h"
#include "library_geometry.h"
#include "picture.h"
#include "reference.h"
#include "stability/contract.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH 320
#define HEIGHT 240
#define VIEWS 10
#define PI 3.14159265358979323846

/* ---- Textures ------------------------------------------------------------------------------------------------ */

#define SIZE 64
#define LARGEST 1024

static uint16_t stone[SIZE * SIZE], colours[LARGEST * LARGEST];

/* Multiplicative hashing (Knuth). */
static uint32_t hash(uint32_t number) {
    return (number * 2654435761u ^ number << 7) >> 13;
}

/* Value noise: heights of a grid of so many texels, mixed, from -1 to 1; it repeats. */
static double rough(uint32_t x, uint32_t y, uint32_t grid, uint32_t seed) {
    const double across = (double)(x % grid) / grid, down = (double)(y % grid) / grid;
    double sum = 0;
    for (uint32_t i = 0; i < 4; i++) {
        const uint32_t column = (x / grid + i % 2) % (SIZE / grid), row = (y / grid + i / 2) % (SIZE / grid);
        const double height = (hash(seed + column + SIZE * row) & 1023) / 511.5 - 1;
        sum += height * (i % 2 ? across : 1 - across) * (i / 2 ? down : 1 - down);
    }
    return sum;
}

static uint16_t stone_at(uint32_t x, uint32_t y) {
    double level[3];
    for (uint32_t c = 0; c < 3; c++) {
        level[c] = 0.55 - 0.05 * c;
        for (uint32_t grid = 16, seed = c; grid; grid /= 2, seed += 8192)
            level[c] += 0.016 * (grid + 3) * rough(x, y, grid, seed);
        level[c] = fmax(0, fmin(1, level[c]));
    }
    return (uint16_t)(lrint(31 * level[0]) << 11 | lrint(63 * level[1]) << 5 | lrint(31 * level[2]));
}

static void fill_colours(void) {
    for (uint32_t i = 0; i < SIZE * SIZE; i++)
        stone[i] = stone_at(i % SIZE, i / SIZE);
    for (uint32_t i = 0; i < LARGEST * LARGEST; i++)
        colours[i] = (uint16_t)hash(i);
}

/* ---- Scenes -------------------------------------------------------------------------------------------------- */

#define VERTICES_MAX 400
#define TRIANGLES_MAX 576

/* A scene of one object that wears a texture, and all it points to; not to be moved once made. */
#define LEVELS 10

typedef struct worn {
    int16_t positions[VERTICES_MAX][3], normals[VERTICES_MAX][3], coordinates[VERTICES_MAX][2];
    uint16_t triangles[TRIANGLES_MAX][3];
    glint_mesh mesh;
    glint_texture texture, levels[LEVELS];
    glint_material material;
    glint_light light;
    glint_object object;
    glint_scene scene;
} worn;

static void begin(worn *w) {
    const glint_vector down = GLINT_VECTOR(-0.5, -1, -1);
    const glint_colour white = GLINT_COLOUR(1, 1, 1), sky = GLINT_COLOUR(0.2, 0.4, 0.2);
    memset(w, 0, sizeof *w);
    w->mesh = (glint_mesh){.positions = (const int16_t(*)[3])w->positions,
                           .normals = (const int16_t(*)[3])w->normals,
                           .triangles = (const uint16_t(*)[3])w->triangles,
                           .extent = {GLINT_ONE, GLINT_ONE, GLINT_ONE},
                           .texture_coordinates = (const int16_t(*)[2])w->coordinates,
                           .texture_extent = {GLINT_ONE, GLINT_ONE}};
    w->texture = (glint_texture){&glint_texture_rgb565, stone, NULL, SIZE, SIZE, 0, 0};
    w->material = glint_material_paint(&glint_model_unlit, white, GLINT_ONE / 8, 30 * GLINT_ONE);
    w->material.texture = &w->texture;
    w->light = glint_sun(down, white);
    w->object = (glint_object){&w->mesh, &w->material, glint_pose_identity(), &glint_per_fragment};
    w->scene = (glint_scene){.camera = glint_camera_default(),
                             .background = sky,
                             .ambient = white,
                             .lights = &w->light,
                             .light_count = 1,
                             .objects = &w->object,
                             .object_count = 1};
}

static void set_triple(int16_t to[3], double x, double y, double z) {
    to[0] = (int16_t)lrint(32767 * x);
    to[1] = (int16_t)lrint(32767 * y);
    to[2] = (int16_t)lrint(32767 * z);
}

static void add_triangle(worn *w, uint32_t a, uint32_t b, uint32_t c) {
    uint16_t *const corners = w->triangles[w->mesh.triangle_count++];
    corners[0] = (uint16_t)a;
    corners[1] = (uint16_t)b;
    corners[2] = (uint16_t)c;
}

/* 576 triangles, around which the texture goes four times, and twice around the tube: vertices at its seams lie
 * double. */
static void make_torus(worn *w, int view) {
    enum { AROUND = 24, ALONG = 12 };
    begin(w);
    for (int i = 0; i <= AROUND; i++)
        for (int j = 0; j <= ALONG; j++) {
            const uint32_t vertex = w->mesh.vertex_count++;
            const double a = 2 * PI * i / AROUND, b = 2 * PI * j / ALONG, radius = (1 + 0.4 * cos(b)) / 1.4;
            set_triple(w->positions[vertex], radius * cos(a), radius * sin(a), 0.4 * sin(b) / 1.4);
            set_triple(w->normals[vertex], cos(a) * cos(b), sin(a) * cos(b), sin(b));
            w->coordinates[vertex][0] = (int16_t)(32640 * i / AROUND);
            w->coordinates[vertex][1] = (int16_t)(32640 * j / ALONG);
            if (i < AROUND && j < ALONG) {
                add_triangle(w, vertex, vertex + ALONG + 1, vertex + ALONG + 2);
                add_triangle(w, vertex, vertex + ALONG + 2, vertex + 1);
            }
        }
    w->mesh.texture_extent[0] = 4 * GLINT_ONE;
    w->mesh.texture_extent[1] = 2 * GLINT_ONE;
    const glint_pose x = glint_pose_rotate_x((36 * view - 50) * GLINT_ONE), y = glint_pose_rotate_y(17 * GLINT_ONE),
                     scaling = glint_pose_scale(GLINT_Q16(1.4), GLINT_Q16(1.4), GLINT_Q16(1.4));
    w->object.pose = glint_pose_then(&scaling, &x);
    w->object.pose = glint_pose_then(&w->object.pose, &y);
}

/* A box whose six sides show the texture once each. */
static void make_crate(worn *w, int view) {
    begin(w);
    const glint_mesh_room room = {w->positions, w->normals, w->triangles, VERTICES_MAX, TRIANGLES_MAX};
    glint_mesh box;
    CHECK_EQUAL(glint_generate_box(&box, &room, GLINT_ONE, GLINT_ONE, GLINT_ONE), GLINT_OK);
    w->mesh.vertex_count = box.vertex_count;
    w->mesh.triangle_count = box.triangle_count;
    for (uint32_t i = 0; i < box.vertex_count; i++) {
        const int across = w->normals[i][0] ? 1 : 0, down = w->normals[i][2] ? 1 : 2;
        w->coordinates[i][0] = w->positions[i][across] < 0 ? -16384 : 16384;
        w->coordinates[i][1] = w->positions[i][down] < 0 ? 16384 : -16384;
    }
    w->mesh.texture_offset[0] = w->mesh.texture_offset[1] = GLINT_ONE / 2;
    glint_camera_orbit(&w->scene.camera, (glint_vector){0, 0, 0}, (36 * view + 20) * GLINT_ONE,
                       (7 * view - 35) * GLINT_ONE, GLINT_Q16(3.5));
}

/* Two triangles, 128 repeats wide, that reach behind the eye, which moves over them and looks down and up again. */
static void make_floor(worn *w, int view) {
    static const int16_t sides[4][2] = {{-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
    begin(w);
    w->mesh.vertex_count = 4;
    for (int i = 0; i < 4; i++) {
        set_triple(w->positions[i], sides[i][0], 0, sides[i][1]);
        set_triple(w->normals[i], 0, 1, 0);
        w->coordinates[i][0] = (int16_t)(32767 * sides[i][0]);
        w->coordinates[i][1] = (int16_t)(32767 * sides[i][1]);
    }
    add_triangle(w, 0, 1, 2);
    add_triangle(w, 0, 2, 3);
    w->mesh.extent = (glint_vector){128 * GLINT_ONE, GLINT_ONE, 128 * GLINT_ONE};
    w->mesh.texture_extent[0] = w->mesh.texture_extent[1] = 64 * GLINT_ONE;
    glint_camera_orbit(&w->scene.camera, (glint_vector){view * 7000, GLINT_ONE, -view * 9000}, 33 * view * GLINT_ONE,
                       (4 * view + 5) * GLINT_ONE, GLINT_ONE / 4);
}

/* A floor of 576 triangles, each pair of which shows the texture once: some are small on the screen, and yet deep. */
static void make_paving(worn *w, int view) {
    enum { ACROSS = 24, ALONG = 12 };
    begin(w);
    for (int i = 0; i <= ACROSS; i++)
        for (int j = 0; j <= ALONG; j++) {
            const uint32_t vertex = w->mesh.vertex_count++;
            set_triple(w->positions[vertex], 2.0 * i / ACROSS - 1, 0, 1 - 2.0 * j / ALONG);
            set_triple(w->normals[vertex], 0, 1, 0);
            w->coordinates[vertex][0] = (int16_t)(1024 * i);
            w->coordinates[vertex][1] = (int16_t)(1024 * (ALONG - j));
            if (i < ACROSS && j < ALONG) {
                add_triangle(w, vertex, vertex + ALONG + 1, vertex + ALONG + 2);
                add_triangle(w, vertex, vertex + ALONG + 2, vertex + 1);
            }
        }
    w->mesh.extent = (glint_vector){6 * GLINT_ONE, GLINT_ONE, 3 * GLINT_ONE};
    w->mesh.texture_extent[0] = w->mesh.texture_extent[1] = 32 * GLINT_ONE;
    glint_camera_orbit(&w->scene.camera, (glint_vector){view * 7000, GLINT_ONE / 4, -view * 9000},
                       33 * view * GLINT_ONE, (2 * view + 5) * GLINT_ONE, GLINT_ONE / 4);
}

typedef void (*scene_maker)(worn *w, int view);

static const struct {
    const char *name;
    scene_maker make;
} scenes[] = {{"torus", make_torus}, {"crate", make_crate}, {"floor", make_floor}, {"paving", make_paving}};

/* ---- Against double precision -------------------------------------------------------------------------------- */

/* What a picture shows beside the exact texels, in pixels whose texels are settled (sampling.h). */
typedef struct likeness {
    long pixels, equal, open; /* judged, equal, and those whose level may be another */
    double squares;
} likeness;

static void compare(const worn *w, likeness *sum) {
    static reference_pixel pixels[WIDTH * HEIGHT];
    const reference_image exact = {WIDTH, HEIGHT, pixels};
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    const glint_config config = picture_config(&image, NULL);
    library_geometry geometry;
    CHECK_EQUAL(library_geometry_open(&geometry, &config, &w->scene), GLINT_OK);
    reference_render(&exact, &w->scene, (const reference_position *const *)geometry.positions);
    CHECK_EQUAL(picture_render(&image, &w->scene, NULL, NULL), GLINT_OK);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        int is_equal = 1;
        sum->open += pixels[i].covered && pixels[i].is_level_open;
        if (!pixels[i].covered || pixels[i].uncertain || pixels[i].unsettled)
            continue;
        for (int c = 0; c < 3; c++) {
            const int most = picture_level_max(image.format, c);
            const double level = picture_level(&image, i % WIDTH, i / WIDTH, c);
            is_equal &= level == round(pixels[i].colour[c] * most);
            sum->squares += pow(level / most - pixels[i].colour[c], 2) / 3;
        }
        sum->pixels++;
        sum->equal += is_equal;
    }
    library_geometry_close(&geometry);
    picture_close(&image);
}

/* At least 36 dB, or 99 % of all pixels the same; and all pixels keep the contract. */
static void nearest_texels_are_shown(void) {
    static worn w;
    for (unsigned i = 0; i < TEST_COUNT(scenes); i++) {
        likeness sum = {0};
        long other = 0, unsettled = 0;
        char line[160];
        for (int view = 0; view < VIEWS; view++) {
            contract_result result;
            scenes[i].make(&w, view);
            compare(&w, &sum);
            contract_judge(&w.scene, WIDTH, HEIGHT, &glint_format_rgb565, &result);
            CHECK(contract_holds(&result));
            other += result.found.beside;
            unsettled += result.found.unsettled;
        }
        const double decibels = -10 * log10(sum.squares / (double)sum.pixels);
        snprintf(line, sizeof line,
                 "  %s: %ld pixels, %.2f dB, %.3f %% equal; %ld of the texel beside, %ld unsettled\n", scenes[i].name,
                 sum.pixels, decibels, 100 * (double)sum.equal / (double)sum.pixels, other, unsettled);
        test_write(line);
        CHECK(sum.pixels > VIEWS * WIDTH * HEIGHT / 8);
        CHECK(decibels >= 36 || sum.equal * 100 >= sum.pixels * 99);
    }
}

/* ---- Coordinates --------------------------------------------------------------------------------------------- */

/* Numbers of columns and rows as colours: 1024 columns, and of 64 rows each again. */
static void number_texels(void) {
    for (uint32_t i = 0; i < LARGEST * LARGEST; i++)
        colours[i] = (uint16_t)(i % LARGEST | i / LARGEST % 64 << 10);
}

static int column_at(const picture *image, int pixel) {
    uint16_t word;
    memcpy(&word, image->bytes + 2 * (size_t)pixel, sizeof word);
    return word % LARGEST;
}

/* A floor whose coordinates move by whole texels shows those beside, pixel by pixel, and nothing else: it does not
 * swim. Once around it is where it was. */
static void floors_move_by_texels(void) {
    static worn w;
    for (int view = 0; view < VIEWS; view += 3) {
        picture still = picture_open(WIDTH, HEIGHT, &glint_format_rgb565), moved = still;
        long shown = 0;
        make_floor(&w, view);
        number_texels();
        w.texture.texels = colours;
        w.texture.width = w.texture.height = LARGEST;
        w.mesh.texture_extent[0] = w.mesh.texture_extent[1] = GLINT_ONE;
        w.scene.background = (glint_colour){0, 0, 0};
        CHECK_EQUAL(picture_render(&still, &w.scene, NULL, NULL), GLINT_OK);
        moved = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
        for (int by = -1; by <= LARGEST; by = by > 0 ? 8 * by : by + 1) {
            w.mesh.texture_offset[0] = by * (GLINT_ONE / LARGEST);
            CHECK_EQUAL(picture_render(&moved, &w.scene, NULL, NULL), GLINT_OK);
            long wrong = 0;
            for (int i = 0; i < WIDTH * HEIGHT; i++) {
                shown += column_at(&still, i) > 0;
                wrong += column_at(&still, i) + column_at(&moved, i) > 0 &&
                         (column_at(&moved, i) - column_at(&still, i) - by) % LARGEST != 0;
            }
            CHECK_EQUAL(wrong, 0);
        }
        CHECK(shown > WIDTH * HEIGHT);
        picture_close(&still);
        picture_close(&moved);
    }
    fill_colours();
}

/* ---- The same bits ------------------------------------------------------------------------------------------- */

static void check_same_bits(const worn *w, const glint_format *format) {
    static const uint16_t sides[4] = {8, 16, 32, 64};
    static const glint_rectangle regions[3] = {{0, 0, 8, 16}, {88, 40, 144, 104}, {296, 200, 24, 40}};
    picture wanted = picture_open(WIDTH, HEIGHT, format);
    CHECK_EQUAL(picture_render(&wanted, &w->scene, NULL, NULL), GLINT_OK);
    for (int i = 0; i < 16; i++) {
        picture_options options = {.tile_width = sides[i % 4], .tile_height = sides[i / 4]};
        CHECK(picture_draws_same(&wanted, &w->scene, &options, NULL));
        const glint_need need = picture_need(&wanted, &w->scene, &options);
        options.region = regions[i % 3];
        options.arena_size = picture_arena(&need, 64 * (uint32_t)(i % 5));
        CHECK(picture_draws_same(&wanted, &w->scene, &options, NULL));
    }
    picture_close(&wanted);
}

static void tiles_arenas_and_regions_change_nothing(void) {
    static worn w;
    static const glint_format *const formats[] = {&glint_format_rgb565, &glint_format_rgb565_be_dithered,
                                                  &glint_format_rgb888, &glint_format_mono};
    for (unsigned i = 0; i < TEST_COUNT(scenes); i++)
        for (unsigned j = 0; j < TEST_COUNT(formats); j++) {
            scenes[i].make(&w, (int)(2 * j + i));
            check_same_bits(&w, formats[j]);
        }
}

/* ---- Sizes and types ----------------------------------------------------------------------------------------- */

static void check_contract(const worn *w, const glint_format *format) {
    static const glint_evaluation *const evaluations[3] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    const glint_material *const material = &w->material;
    contract_result result;
    char line[240];
    int where = 0;
    contract_judge(&w->scene, WIDTH / 2, HEIGHT / 2, format, &result);
    if (CHECK(contract_holds(&result)))
        return;
    while (where < 2 && w->object.evaluation != evaluations[where])
        where++;
    snprintf(line, sizeof line, "  lit %s, %s, %u triangles, flags %u and %u, colours %d: ",
             where == 0   ? "per fragment"
             : where == 1 ? "per vertex"
                          : "per facet",
             material->model == &glint_model_lambert ? "Lambert"
             : material->model == &glint_model_phong ? "Phong"
             : material->model == &glint_model_unlit ? "unlit"
                                                     : "Blinn-Phong",
             w->mesh.triangle_count, w->mesh.flags, material->flags, w->mesh.colours != NULL);
    test_write(line);
    snprintf(line, sizeof line, "%s, status %d, missed %ld, spilled %ld, over one %ld, worst %.3f of %.3f at %d, %d\n",
             format == &glint_format_rgb888 ? "RGB888" : "other", result.found.status, result.found.missed,
             result.found.spilled, result.found.over_one, result.found.worst, result.bound, result.worst_x,
             result.worst_y);
    test_write(line);
}

static void every_size_is_drawn(void) {
    static worn w;
    for (int i = 0; i < 11 * 11; i += 2) {
        scenes[(unsigned)i / 2 % TEST_COUNT(scenes)].make(&w, i % VIEWS);
        w.texture.texels = colours;
        w.texture.width = (uint16_t)(1 << i % 11);
        w.texture.height = (uint16_t)(1 << i / 11);
        if (w.texture.width > 128 || w.texture.height > 128)
            w.mesh.texture_extent[0] = w.mesh.texture_extent[1] = GLINT_ONE / 2;
        w.material.flags = i / 2 % 2 ? GLINT_MATERIAL_BILINEAR : 0;
        check_contract(&w, &glint_format_rgb565);
    }
}

/* One white texel is none. */
static void one_texel_is_a_colour(void) {
    static const uint16_t white = 0xffff;
    static worn w;
    for (unsigned i = 0; i < TEST_COUNT(scenes); i++) {
        picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb888);
        scenes[i].make(&w, 1);
        w.material.diffuse = (glint_colour)GLINT_COLOUR(0.72, 1, 0.01);
        w.texture = (glint_texture){&glint_texture_rgb565, &white, NULL, 1, 1, 0, 0};
        CHECK_EQUAL(picture_render(&image, &w.scene, NULL, NULL), GLINT_OK);
        w.material.texture = NULL;
        CHECK(picture_draws_same(&image, &w.scene, NULL, NULL));
        picture_close(&image);
    }
}

/* A picture of up to 16 colours is the same in every type that has colours, with texels mixed or not. */
static void types_show_the_same(void) {
    enum { COUNT = 32 * 16 };
    static uint16_t words[COUNT];
    static uint8_t bytes[COUNT], nibbles[COUNT / 2];
    static worn w;
    for (int i = 0; i < COUNT; i++) {
        bytes[i] = (uint8_t)(colours[i] % 16);
        words[i] = stone[97 * bytes[i]];
        nibbles[i / 2] = (uint8_t)(nibbles[i / 2] | bytes[i] << (i % 2 ? 0 : 4));
    }
    uint16_t palette[256];
    for (int i = 0; i < 256; i++)
        palette[i] = stone[97 * (i % 16)];
    const glint_texture types[3] = {{&glint_texture_rgb565, words, NULL, 32, 16, 0, 0},
                                    {&glint_texture_palette256, bytes, palette, 32, 16, 0, 0},
                                    {&glint_texture_palette16, nibbles, palette, 32, 16, 0, 0}};
    static const glint_format *const formats[] = {&glint_format_rgb565, &glint_format_rgb565_be, &glint_format_grey4};
    for (unsigned i = 0; i < 2 * TEST_COUNT(formats); i++) {
        const glint_format *const format = formats[i / 2];
        picture image = picture_open(WIDTH, HEIGHT, format);
        make_crate(&w, (int)i % VIEWS);
        w.material.flags = i % 2 ? GLINT_MATERIAL_BILINEAR : 0;
        w.texture = types[0];
        CHECK_EQUAL(picture_render(&image, &w.scene, NULL, NULL), GLINT_OK);
        for (int j = 1; j < 3; j++) {
            w.texture = types[j];
            CHECK(picture_draws_same(&image, &w.scene, NULL, NULL));
            check_contract(&w, format);
        }
        w.texture = (glint_texture){&glint_texture_grey8, colours, NULL, 32, 16, 0, 0};
        check_contract(&w, format);
        picture_close(&image);
    }
}

/* ---- Extremes ------------------------------------------------------------------------------------------------ */

/* Any number of an offset is a place on a texture that repeats, and an offset of whole repeats is none. */
static void offsets_repeat(void) {
    static worn w;
    static const glint_q16 whole[] = {INT32_MIN, -GLINT_ONE, GLINT_ONE, INT32_MAX - 65535};
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    for (unsigned i = 0; i < TEST_COUNT(scenes); i++) {
        scenes[i].make(&w, 3);
        w.mesh.texture_offset[0] = w.mesh.texture_offset[1] = 0;
        CHECK_EQUAL(picture_render(&image, &w.scene, NULL, NULL), GLINT_OK);
        for (unsigned j = 0; j < TEST_COUNT(whole); j++) {
            w.mesh.texture_offset[0] = whole[j];
            w.mesh.texture_offset[1] = whole[(j + 1) % TEST_COUNT(whole)];
            CHECK(picture_draws_same(&image, &w.scene, NULL, NULL));
        }
        w.mesh.texture_offset[0] = INT32_MAX;
        w.mesh.texture_offset[1] = INT32_MIN + 1;
        check_contract(&w, &glint_format_rgb565);
    }
    picture_close(&image);
}

/* Up to 65536 repeats over a triangle are drawn, with the same bits in any tiles. */
static void extremes_are_drawn(void) {
    static worn w;
    static const glint_q16 extents[] = {0, 1, INT32_MAX};
    for (unsigned i = 0; i < TEST_COUNT(scenes); i++)
        for (unsigned j = 0; j < TEST_COUNT(extents); j++) {
            scenes[i].make(&w, 5);
            for (uint32_t vertex = 0; vertex < w.mesh.vertex_count; vertex++)
                for (int axis = 0; axis < 2; axis++)
                    w.coordinates[vertex][axis] = (int16_t)(hash(vertex) >> axis & 1 ? -32768 : 32767);
            w.mesh.texture_offset[0] = j % 2 ? INT32_MIN : INT32_MAX;
            w.mesh.texture_extent[0] = extents[j];
            w.mesh.texture_extent[1] = extents[(j + i) % TEST_COUNT(extents)];
            check_same_bits(&w, &glint_format_rgb565);
            check_contract(&w, &glint_format_rgb565);
        }
}

/* A triangle of some 20 pixels whose corners are up to 8 times as far as each other, over a few large texels. */
static void make_steep(worn *w, uint32_t number) {
    const double focal = HEIGHT / 2.0 / tan(PI / 8);
    begin(w);
    w->mesh.vertex_count = 3;
    w->mesh.extent = (glint_vector){GLINT_ONE / 2, GLINT_ONE / 2, 8 * GLINT_ONE};
    w->object.pose.m[2][3] = -9 * GLINT_ONE;
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t random = hash(3 * number + i), other = hash(random);
        const double depth = 1 + number % 8 * 0.14 + (i == number % 3 ? 0 : (random & 127) / 20.0);
        const double x = 10 * cos(2 * PI * i / 3) + (random >> 7 & 3), y = 10 * sin(2 * PI * i / 3);
        set_triple(w->positions[i], 2 * x * depth / focal, 2 * y * depth / focal, (9 - depth) / 8);
        set_triple(w->normals[i], 0, 0, 1);
        w->coordinates[i][0] = (int16_t)(other & 0x7fff);
        w->coordinates[i][1] = (int16_t)(hash(other) & 0x7fff);
    }
    add_triangle(w, 0, 1, 2);
    w->mesh.flags = GLINT_MESH_DOUBLE_SIDED;
    w->texture.texels = colours;
    w->texture.width = (uint16_t)(1u << number % 3);
    w->texture.height = (uint16_t)(1u << number / 3 % 3);
    w->scene.camera = (glint_camera){glint_pose_identity(), 45 * GLINT_ONE, GLINT_ONE / 2};
}

/* Texels of small triangles are where their depth has them, however steep that is. */
static void small_triangles_may_be_steep(void) {
    static worn w;
    for (uint32_t number = 0; number < 400; number++) {
        make_steep(&w, number);
        check_contract(&w, &glint_format_rgb565);
    }
}

/* ---- Light ------------------------------------------------------------------------------------------------------- */

static uint8_t tints[VERTICES_MAX][3];

/* Every evaluation and model, with and without colours of the mesh, seen from both sides: texels multiply what is
 * ambient and diffuse, and highlights stay. */
static void light_is_multiplied(void) {
    static const glint_evaluation *const evaluations[3] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    static const glint_shading_model *const models[4] = {&glint_model_lambert, &glint_model_phong,
                                                         &glint_model_blinn_phong, &glint_model_unlit};
    static worn w;
    for (unsigned i = 0; i < 3 * VERTICES_MAX; i++)
        tints[i / 3][i % 3] = (uint8_t)(hash(i) & 255);
    for (unsigned i = 0; i < 2 * 3 * 4 * TEST_COUNT(scenes); i++) {
        scenes[i % TEST_COUNT(scenes)].make(&w, (int)i % VIEWS);
        w.material.model = models[i / TEST_COUNT(scenes) % 4];
        w.object.evaluation = evaluations[i / TEST_COUNT(scenes) / 4 % 3];
        if (i / TEST_COUNT(scenes) / 12)
            w.mesh.colours = (const uint8_t(*)[3])tints;
        w.mesh.flags = w.object.evaluation == &glint_per_vertex ? 0 : i / 4 % 2;
        w.material.diffuse = (glint_colour)GLINT_COLOUR(0.6, 0.7, 0.5);
        w.material.specular = (glint_colour)GLINT_COLOUR(0.2, 0.1, 0.3);
        check_contract(&w, &glint_format_rgb565);
        check_contract(&w, &glint_format_rgb888);
    }
}

/* Paint without light that takes from one channel alone: a user would see texels as they are. */
static void each_channel_of_paint_is_multiplied(void) {
    static worn w;
    for (int i = 0; i < 6; i++) {
        const glint_colour paints[3] = {GLINT_COLOUR(0.4, 1, 1), GLINT_COLOUR(1, 0.4, 1), GLINT_COLOUR(1, 1, 0.4)};
        make_torus(&w, i);
        w.material.diffuse = paints[i % 3];
        check_contract(&w, i < 3 ? &glint_format_rgb565 : &glint_format_rgb888);
    }
}

/* ---- Edges and mixtures ---------------------------------------------------------------------------------------- */

/* Of a texture so small that texels are large: clamped, mixed, and both, in its middle and beyond. */
static void edges_are_clamped_and_texels_mixed(void) {
    static worn w;
    for (unsigned i = 0; i < 4 * TEST_COUNT(scenes); i++) {
        scenes[i % TEST_COUNT(scenes)].make(&w, (int)i % VIEWS);
        w.material.flags = i / TEST_COUNT(scenes) * GLINT_MATERIAL_CLAMP;
        w.texture.width = (uint16_t)(4u << i % 3);
        w.texture.height = (uint16_t)(16u >> i % 3);
        w.texture.texels = colours;
        check_contract(&w, &glint_format_rgb565);
        w.mesh.texture_offset[0] -= GLINT_ONE / 3;
        w.mesh.texture_offset[1] += GLINT_ONE / 5;
        check_contract(&w, &glint_format_rgb888);
        check_same_bits(&w, i % 2 ? &glint_format_rgb565 : &glint_format_rgb888);
    }
}

/* Beyond all edges one texel is left, up to the last number. */
static void clamping_holds_to_the_extremes(void) {
    static const glint_q16 offsets[4] = {INT32_MIN, INT32_MAX, -300 * GLINT_ONE, 300 * GLINT_ONE};
    static worn w;
    for (int i = 0; i < 16; i++) {
        picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
        make_floor(&w, i % VIEWS);
        w.mesh.texture_offset[0] = offsets[i % 4];
        w.mesh.texture_offset[1] = offsets[i / 4];
        w.material.flags = i % 3 ? GLINT_MATERIAL_CLAMP : GLINT_MATERIAL_CLAMP | GLINT_MATERIAL_BILINEAR;
        CHECK_EQUAL(picture_render(&image, &w.scene, NULL, NULL), GLINT_OK);
        const int column = offsets[i % 4] < 0 ? 0 : SIZE - 1, row = offsets[i / 4] < 0 ? 0 : SIZE - 1;
        w.texture = (glint_texture){&glint_texture_rgb565, &stone[SIZE * row + column], NULL, 1, 1, 0, 0};
        w.material.flags = 0;
        CHECK(picture_draws_same(&image, &w.scene, NULL, NULL));
        picture_close(&image);
    }
}

/* Gives a texture all levels, which show the beginning of its own texels. */
static void share_levels(worn *w) {
    glint_texture *larger = &w->texture;
    for (int i = 0; larger->width * larger->height > 1; i++) {
        w->levels[i] = *larger;
        w->levels[i].width = (uint16_t)((larger->width + 1) / 2);
        w->levels[i].height = (uint16_t)((larger->height + 1) / 2);
        larger->smaller = &w->levels[i];
        larger = &w->levels[i];
    }
}

/* ---- Holes ------------------------------------------------------------------------------------------------------- */

/* What glint_pick finds is what is seen, through holes too. */
static void check_picks(const glint_scene *scene, long seen[2]) {
    static reference_pixel pixels[WIDTH / 2 * HEIGHT / 2];
    const reference_image exact = {WIDTH / 2, HEIGHT / 2, pixels};
    picture image = picture_open(WIDTH / 2, HEIGHT / 2, &glint_format_rgb565);
    glint_config config = picture_config(&image, NULL);
    glint_renderer renderer;
    library_geometry geometry;
    CHECK_EQUAL(library_geometry_open(&geometry, &config, scene), GLINT_OK);
    reference_render(&exact, scene, (const reference_position *const *)geometry.positions);
    config.arena_size = picture_need(&image, scene, NULL).one_pass;
    config.arena = malloc(config.arena_size);
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    for (int i = 0; i < WIDTH / 2 * HEIGHT / 2; i += 37) {
        glint_hit hit = {0};
        if (pixels[i].uncertain)
            continue;
        CHECK_EQUAL(glint_pick(&renderer, scene, i % (WIDTH / 2), i / (WIDTH / 2), &hit), pixels[i].covered);
        CHECK_EQUAL(hit.object, pixels[i].object);
        seen[hit.object] += pixels[i].covered;
    }
    free(config.arena);
    library_geometry_close(&geometry);
    picture_close(&image);
}

/* A fence, of every type, lit in every way, before a torus and behind it: neither colour nor depth is drawn in holes.
 */
static void holes_show_what_is_behind(void) {
    enum { COUNT = 16 * 16 };
    static const glint_evaluation *const evaluations[3] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    static uint16_t words[COUNT];
    static uint8_t bytes[COUNT], nibbles[COUNT / 2];
    static worn fence, behind;
    long seen[2] = {0, 0};
    const glint_texture types[4] = {{&glint_texture_rgb565, words, NULL, 16, 16, GLINT_TEXTURE_HAS_KEY, 5},
                                    {&glint_texture_grey8, bytes, NULL, 16, 16, GLINT_TEXTURE_HAS_KEY, 5},
                                    {&glint_texture_palette256, bytes, stone, 16, 16, GLINT_TEXTURE_HAS_KEY, 5},
                                    {&glint_texture_palette16, nibbles, stone, 16, 16, GLINT_TEXTURE_HAS_KEY, 5}};
    for (int i = 0; i < COUNT; i++) {
        bytes[i] = i % 16 / 4 % 2 && i / 16 % 8 > 2 ? 5 : (uint8_t)(i % 5);
        words[i] = bytes[i] == 5 ? 5 : stone[i];
        nibbles[i / 2] = (uint8_t)((i % 2 ? nibbles[i / 2] : 0) | bytes[i] << (i % 2 ? 0 : 4));
    }
    for (unsigned i = 0; i < 4 * 4; i++) {
        make_crate(&fence, (int)i % VIEWS);
        make_torus(&behind, (int)i % VIEWS);
        fence.texture = types[i % 4];
        fence.material.flags = i % 3 ? 0 : GLINT_MATERIAL_BILINEAR;
        fence.material.model = i / 4 ? &glint_model_blinn_phong : &glint_model_unlit;
        fence.object.evaluation = evaluations[i / 4 % 3];
        fence.mesh.flags = fence.object.evaluation == &glint_per_vertex ? 0 : GLINT_MESH_DOUBLE_SIDED;
        if (i % 2) {
            share_levels(&fence);
            fence.mesh.texture_extent[0] = fence.mesh.texture_extent[1] = (int32_t)i * GLINT_ONE;
        }
        const glint_pose smaller = glint_pose_scale(GLINT_ONE / 2, GLINT_ONE / 2, GLINT_ONE / 2);
        behind.object.pose = glint_pose_then(&behind.object.pose, &smaller);
        const glint_object order[2][2] = {{fence.object, behind.object}, {behind.object, fence.object}};
        fence.scene.objects = order[i % 2];
        fence.scene.object_count = 2;
        check_contract(&fence, &glint_format_rgb565);
        check_contract(&fence, &glint_format_rgb888);
        check_same_bits(&fence, &glint_format_rgb565);
        check_picks(&fence.scene, seen);
    }
    CHECK(seen[0] > 100 && seen[1] > 100);
}

/* A texture that is all hole is not there. */
static void nothing_but_holes_is_nothing(void) {
    static const uint16_t key = 0x1234;
    static worn w;
    for (unsigned i = 0; i < TEST_COUNT(scenes); i++) {
        uint32_t empty = 0;
        const picture_options options = {.overlay = {picture_count_empty, &empty}};
        picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
        scenes[i].make(&w, 2);
        w.texture = (glint_texture){&glint_texture_rgb565, &key, NULL, 1, 1, GLINT_TEXTURE_HAS_KEY, 0x1234};
        CHECK_EQUAL(picture_render(&image, &w.scene, &options, NULL), GLINT_OK);
        CHECK_EQUAL(empty, WIDTH * HEIGHT);
        w.scene.object_count = 0;
        CHECK(picture_draws_same(&image, &w.scene, NULL, NULL));
        picture_close(&image);
    }
}

/* ---- Levels -------------------------------------------------------------------------------------------------- */

/* Texels of levels, from the second on: less than a third more than those of the first. */
static uint16_t level_texels[LARGEST * LARGEST / 2];

/* Gives a texture of RGB565 levels of texels of their own: means of those of the larger one, or any colours. */
static void make_levels(worn *w, int are_means) {
    uint16_t *to = level_texels;
    share_levels(w);
    for (glint_texture *larger = &w->texture, *level = w->levels; larger->smaller; larger = level++) {
        const uint16_t *const from = larger->texels;
        level->texels = to;
        for (int at = 0; at < level->width * level->height; at++) {
            const int x = at % level->width * (larger->width / level->width),
                      y = at / level->width * (larger->height / level->height);
            unsigned sums[3] = {2, 2, 2};
            for (int j = 0; j < 4; j++) {
                const int column = x + j % 2 * (larger->width > 1), row = y + j / 2 * (larger->height > 1);
                const uint16_t texel = from[row * larger->width + column];
                sums[0] += texel >> 11;
                sums[1] += texel >> 5 & 63;
                sums[2] += texel & 31;
            }
            to[at] = are_means ? (uint16_t)(sums[0] / 4 << 11 | sums[1] / 4 << 5 | sums[2] / 4)
                               : (uint16_t)hash((uint32_t)(at + level->width * 4096));
        }
        to += level->width * level->height;
    }
}

/* Each triangle shows one level, which the reference chooses by itself; tiles, arenas and regions change nothing. */
static void levels_are_chosen_by_area(void) {
    static const glint_evaluation *const evaluations[3] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    static worn w;
    likeness sum = {0};
    for (unsigned i = 0; i < 6 * TEST_COUNT(scenes); i++) {
        contract_result result;
        scenes[i % TEST_COUNT(scenes)].make(&w, (int)i % VIEWS);
        w.texture.texels = colours;
        w.texture.width = (uint16_t)(4u << i % 5);
        w.texture.height = (uint16_t)(64u >> i % 7);
        w.material.flags = i / TEST_COUNT(scenes) % 4 * GLINT_MATERIAL_CLAMP;
        w.material.model = i % 3 ? &glint_model_unlit : &glint_model_phong;
        w.object.evaluation = evaluations[i / 2 % 3];
        make_levels(&w, 0);
        check_same_bits(&w, i % 2 ? &glint_format_rgb565 : &glint_format_rgb888);
        contract_judge(&w.scene, WIDTH, HEIGHT, &glint_format_rgb565, &result);
        CHECK(contract_holds(&result));
        compare(&w, &sum);
    }
    char line[120];
    snprintf(line, sizeof line, "  levels: %ld pixels, %ld of triangles whose level may be another\n", sum.pixels,
             sum.open);
    test_write(line);
    CHECK(sum.pixels > 6 * WIDTH * HEIGHT);
    CHECK(sum.open * 500 < sum.pixels);
}

/* Bricks with mortar between. */
static void lay_bricks(uint16_t *to) {
    for (uint32_t i = 0; i < SIZE * SIZE; i++) {
        const uint32_t row = i / SIZE, column = (i + row / 16 % 2 * 16) % SIZE;
        const int is_mortar = row % 16 < 3 || column % 32 < 3;
        const uint32_t level = hash(i) & 7;
        to[i] =
            (uint16_t)(is_mortar ? 25 << 11 | 50 << 5 | 24 : (18 + level) << 11 | (16 + level) << 5 | (6 + level / 2));
    }
}

/* Returns the ratio of peak signal to noise against 64 samples a pixel in double precision, in decibels. */
static double measure_noise(const worn *w, const reference_pixel *samples) {
    enum { SIDE = 8, ACROSS = WIDTH / 2, DOWN = HEIGHT / 2 };
    picture image = picture_open(ACROSS, DOWN, &glint_format_rgb888);
    double squares = 0;
    CHECK_EQUAL(picture_render(&image, &w->scene, NULL, NULL), GLINT_OK);
    for (int i = 0; i < ACROSS * DOWN * 3; i++) {
        const int x = i / 3 % ACROSS, y = i / 3 / ACROSS;
        double sum = 0;
        for (int j = 0; j < SIDE * SIDE; j++)
            sum += samples[(SIDE * y + j / SIDE) * SIDE * ACROSS + SIDE * x + j % SIDE].colour[i % 3];
        squares += pow(picture_level(&image, x, y, i % 3) / 255.0 - sum / (SIDE * SIDE), 2);
    }
    picture_close(&image);
    return -10 * log10(squares / (ACROSS * DOWN * 3));
}

/* On a paved floor levels gain 3 dB, and 5 dB where texels are mixed; on a floor of two triangles they change nothing.
 */
static void levels_lessen_noise(void) {
    static reference_pixel samples[4 * WIDTH * 4 * HEIGHT];
    static worn w;
    const reference_image exact = {4 * WIDTH, 4 * HEIGHT, samples};
    double noise[2][2];
    char line[160];
    make_paving(&w, 1);
    lay_bricks(colours);
    w.texture.texels = colours;
    reference_render(&exact, &w.scene, NULL);
    for (int i = 0; i < 4; i++) {
        w.material.flags = i / 2 ? GLINT_MATERIAL_BILINEAR : 0;
        w.texture.smaller = NULL;
        if (i % 2)
            make_levels(&w, 1);
        noise[i / 2][i % 2] = measure_noise(&w, samples);
    }
    snprintf(line, sizeof line, "  paving: nearest %.2f dB, with levels %.2f dB; mixed %.2f dB, with levels %.2f dB\n",
             noise[0][0], noise[0][1], noise[1][0], noise[1][1]);
    test_write(line);
    CHECK(noise[0][1] > noise[0][0] + 3);
    CHECK(noise[1][1] > noise[1][0] + 5);
    make_floor(&w, 1);
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    CHECK_EQUAL(picture_render(&image, &w.scene, NULL, NULL), GLINT_OK);
    make_levels(&w, 1);
    CHECK(picture_draws_same(&image, &w.scene, NULL, NULL));
    picture_close(&image);
    fill_colours();
}

/* A square of two triangles that faces the viewer, of exactly as many texels as pixels, shows its texture; of a
 * sixteenth of a pixel less it shows the next level, and far away the last one, be it of one texel or of more. */
static void squares_show_the_level_of_their_size(void) {
    static worn w;
    static const int16_t sides[4][2] = {{-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
    for (int last = 0; last <= 6; last++)
        for (int size = 1; size <= SIZE; size++) {
            picture image = picture_open(2 * SIZE, 2 * SIZE, &glint_format_rgb565);
            int level = 0;
            begin(&w);
            w.mesh.vertex_count = 4;
            for (int i = 0; i < 4; i++) {
                set_triple(w.positions[i], sides[i][0], -sides[i][1], 0);
                set_triple(w.normals[i], 0, 0, 1);
                w.coordinates[i][0] = (int16_t)(sides[i][0] < 0 ? 0 : 32767);
                w.coordinates[i][1] = (int16_t)(sides[i][1] < 0 ? 0 : 32767);
            }
            add_triangle(&w, 0, 1, 2);
            add_triangle(&w, 0, 2, 3);
            make_levels(&w, 0);
            for (int i = 0; i <= 6; i++) { /* each level is of one colour */
                glint_texture *const of = i ? &w.levels[i - 1] : &w.texture;
                for (int at = 0; at < of->width * of->height; at++)
                    (i ? (uint16_t *)(uintptr_t)of->texels : colours)[at] = (uint16_t)(i + 1);
                if (!i)
                    of->texels = colours;
                if (i == last)
                    of->smaller = NULL;
            }
            w.scene.camera.projection = &glint_orthographic;
            w.scene.camera.view_height = 2 * SIZE * GLINT_ONE / 16;
            glint_camera_orbit(&w.scene.camera, (glint_vector){0, 0, 0}, 0, 0, 8 * GLINT_ONE);
            const glint_q16 half = size * GLINT_ONE / 32;
            w.object.pose = glint_pose_scale(half, half, half);
            CHECK_EQUAL(picture_render(&image, &w.scene, NULL, NULL), GLINT_OK);
            while (level < last && SIZE >> level > size)
                level++;
            uint16_t shown;
            memcpy(&shown, image.bytes + 2 * (2 * SIZE + 1) * (SIZE - 1), sizeof shown);
            CHECK_EQUAL(shown, level + 1);
            picture_close(&image);
        }
    fill_colours();
}

/* ---- Errors -------------------------------------------------------------------------------------------------- */

/* Draws what is to be refused: nothing is sent, and glint_check names the same. */
static void check_refused(const worn *w, glint_status status) {
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    glint_config config = picture_config(&image, NULL);
    glint_renderer renderer;
    glint_report report;
    glint_need need;
    config.arena_size = 100000;
    config.arena = malloc(config.arena_size);
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    CHECK_EQUAL(glint_render(&renderer, &w->scene), status);
    CHECK_EQUAL(glint_check(&config, &w->scene, &report), status);
    CHECK_EQUAL(glint_arena_need(&config, &w->scene, &need), status);
    CHECK(image.calls == 0 || status == GLINT_OK);
    free(config.arena);
    picture_close(&image);
}

#define CHANGED(status, change)    \
    do {                           \
        make_crate(&w, 0);         \
        change;                    \
        check_refused(&w, status); \
    } while (0)

static void what_is_no_texture_is_refused(void) {
    static worn w;
    static const uint16_t no_sizes[] = {0, 3, 63, 65, 1023, 1025, 2048, 32768, 65535};
    CHANGED(GLINT_ERROR_NULL, w.texture.type = NULL);
    CHANGED(GLINT_ERROR_NULL, w.texture.texels = NULL);
    CHANGED(GLINT_ERROR_NULL, w.texture.type = &glint_texture_palette16);
    CHANGED(GLINT_ERROR_NULL, w.texture.type = &glint_texture_palette256);
    CHANGED(GLINT_OK, w.texture.type = &glint_texture_grey8);
    for (unsigned i = 0; i < TEST_COUNT(no_sizes); i++) {
        CHANGED(GLINT_ERROR_TEXTURE, w.texture.width = no_sizes[i]);
        CHANGED(GLINT_ERROR_TEXTURE, w.texture.height = no_sizes[i]);
    }
    CHANGED(GLINT_ERROR_TEXTURE, w.mesh.texture_coordinates = NULL);
    CHANGED(GLINT_ERROR_TEXTURE, w.mesh.texture_extent[0] = -1);
    CHANGED(GLINT_ERROR_TEXTURE, w.mesh.texture_extent[1] = INT32_MIN);
    CHANGED(GLINT_ERROR_FLAGS, w.texture.flags = 2);
    CHANGED(GLINT_ERROR_FLAGS, w.texture.flags = 0x8000);
    CHANGED(GLINT_ERROR_FLAGS, w.material.flags = 2 * GLINT_MATERIAL_BILINEAR);
    CHANGED(GLINT_ERROR_TEXTURE, (w.texture.type = &glint_texture_grey8, w.texture.flags = 1, w.texture.key = 256));
    CHANGED(GLINT_ERROR_TEXTURE, (w.texture.type = &glint_texture_palette16, w.texture.palette = stone,
                                  w.texture.flags = GLINT_TEXTURE_HAS_KEY, w.texture.key = 16));
    CHANGED(GLINT_OK, (w.texture.type = &glint_texture_palette16, w.texture.palette = stone,
                       w.texture.flags = GLINT_TEXTURE_HAS_KEY, w.texture.key = 15));
    CHANGED(GLINT_OK, (w.texture.flags = GLINT_TEXTURE_HAS_KEY, w.texture.key = 0xffff));
    CHANGED(GLINT_OK, make_levels(&w, 1));
    CHANGED(GLINT_OK, (make_levels(&w, 1), w.levels[2].smaller = NULL));
    CHANGED(GLINT_ERROR_TEXTURE, (make_levels(&w, 1), w.levels[2].smaller = &w.levels[2]));
    CHANGED(GLINT_ERROR_TEXTURE, (make_levels(&w, 1), w.levels[5].smaller = &w.levels[5]));
    CHANGED(GLINT_ERROR_TEXTURE, (make_levels(&w, 1), w.levels[5].smaller = &w.texture));
    CHANGED(GLINT_ERROR_TEXTURE, (make_levels(&w, 1), w.texture.smaller = &w.levels[1]));
    CHANGED(GLINT_ERROR_TEXTURE, (make_levels(&w, 1), w.levels[3].width = 8));
    CHANGED(GLINT_ERROR_TEXTURE, (make_levels(&w, 1), w.levels[3].height = 2));
    CHANGED(GLINT_ERROR_TEXTURE, (make_levels(&w, 1), w.levels[5].width = 0));
    CHANGED(GLINT_ERROR_TEXTURE, (make_levels(&w, 1), w.levels[0].type = &glint_texture_grey8));
    CHANGED(GLINT_ERROR_TEXTURE, (make_levels(&w, 1), w.levels[0].type = NULL));
    CHANGED(GLINT_ERROR_TEXTURE, (make_levels(&w, 1), w.levels[4].flags = GLINT_TEXTURE_HAS_KEY));
    CHANGED(GLINT_ERROR_FLAGS, (make_levels(&w, 1), w.levels[4].flags = 2));
    CHANGED(GLINT_ERROR_NULL, (make_levels(&w, 1), w.levels[4].texels = NULL));
    CHANGED(GLINT_OK, (w.material.texture = NULL, w.mesh.texture_coordinates = NULL, w.mesh.texture_extent[0] = -1));
    CHECK(strlen(glint_strerror(GLINT_ERROR_TEXTURE)) > 20);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(nearest_texels_are_shown),
        TEST_CASE(floors_move_by_texels),
        TEST_CASE(tiles_arenas_and_regions_change_nothing),
        TEST_CASE(every_size_is_drawn),
        TEST_CASE(one_texel_is_a_colour),
        TEST_CASE(types_show_the_same),
        TEST_CASE(offsets_repeat),
        TEST_CASE(extremes_are_drawn),
        TEST_CASE(small_triangles_may_be_steep),
        TEST_CASE(what_is_no_texture_is_refused),
        TEST_CASE(light_is_multiplied),
        TEST_CASE(each_channel_of_paint_is_multiplied),
        TEST_CASE(edges_are_clamped_and_texels_mixed),
        TEST_CASE(clamping_holds_to_the_extremes),
        TEST_CASE(holes_show_what_is_behind),
        TEST_CASE(nothing_but_holes_is_nothing),
        TEST_CASE(levels_are_chosen_by_area),
        TEST_CASE(levels_lessen_noise),
        TEST_CASE(squares_show_the_level_of_their_size),
    };
    fill_colours();
    return test_run(write, cases, TEST_COUNT(cases));
}
