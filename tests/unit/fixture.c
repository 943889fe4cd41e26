/* SPDX-License-Identifier: MIT */
#include "fixture.h"

#include "byte_order.h"
#include "harness.h"
#include "torus.h"

#define GUARD_BYTES 16
#define GUARD 0xa7

static struct {
    uint8_t before_screen[GUARD_BYTES];
    uint8_t screen[FIXTURE_SCREEN_BYTES];
    uint8_t after_screen[GUARD_BYTES];
    uint8_t arena[FIXTURE_ARENA_BYTES + GUARD_BYTES]; /* what lies beyond config.arena_size is guarded too */
    uint8_t after_arena[GUARD_BYTES];
} memory;

static fixture the_fixture;

static const int16_t floor_positions[4][3] = {
    {-32768, 0, 32767}, {32767, 0, 32767}, {32767, 0, -32768}, {-32768, 0, -32768}};
static const int16_t floor_normals[4][3] = {{0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}};
static const uint16_t floor_triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};

static void fill(uint8_t *bytes, size_t count, uint8_t value) {
    for (size_t i = 0; i < count; i++)
        bytes[i] = value;
}

static int holds(const uint8_t *bytes, size_t count, uint8_t value) {
    for (size_t i = 0; i < count; i++) {
        if (bytes[i] != value)
            return 0;
    }
    return 1;
}

uint32_t fixture_checksum_add(uint32_t checksum, const uint8_t *bytes, size_t count) {
    for (size_t i = 0; i < count; i++)
        checksum = (checksum ^ bytes[i]) * 16777619u;
    return checksum;
}

/* ---- Flush --------------------------------------------------------------------------------------------------- */

static uint32_t sending_checksum(const fixture *f) {
    uint32_t checksum = FIXTURE_CHECKSUM_START;
    for (uint32_t row = 0; row < f->sending_rows; row++)
        checksum = fixture_checksum_add(checksum, f->sending + row * f->sending_stride, f->sending_bytes);
    return checksum;
}

static void copy_tile(fixture *f, int x, int y) {
    size_t stride = glint_row_bytes(f->config.format, f->config.width);
    size_t left = glint_row_bytes(f->config.format, (uint32_t)x);
    for (uint32_t row = 0; row < f->sending_rows; row++) {
        for (size_t i = 0; i < f->sending_bytes; i++)
            memory.screen[((size_t)y + row) * stride + left + i] = f->sending[row * f->sending_stride + i];
    }
}

/* Tiles come left to right and top to bottom, each cut at the screen's edges. */
static int in_place(fixture *f, int x, int y, int width, int height) {
    int tile_width = f->config.tile_width ? f->config.tile_width : 32;
    int tile_height = f->config.tile_height ? f->config.tile_height : 32;
    int across = f->config.width - x < tile_width ? f->config.width - x : tile_width;
    int down = f->config.height - y < tile_height ? f->config.height - y : tile_height;
    if (x != f->next_x || y != f->next_y || width != across || height != down || down <= 0)
        return 0;
    f->next_x = x + width < f->config.width ? x + width : 0;
    f->next_y = f->next_x == 0 ? y + height : y;
    return 1;
}

static int begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    fixture *f = context;
    f->begins++;
    if (f->sending != 0 || !in_place(f, x, y, width, height)) {
        f->flaws++;
        return 1;
    }
    f->sending = pixels;
    f->sending_stride = stride;
    f->sending_rows = (uint32_t)height;
    f->sending_bytes = glint_row_bytes(f->config.format, (uint32_t)width);
    f->sending_checksum = sending_checksum(f);
    f->pixels_sent += (uint32_t)(width * height);
    copy_tile(f, x, y);
    return 0;
}

static int wait(void *context) {
    fixture *f = context;
    f->waits++;
    f->flaws += f->sending == 0 || f->sending_checksum != sending_checksum(f);
    f->sending = 0;
    return 0;
}

/* ---- Scene --------------------------------------------------------------------------------------------------- */

static glint_colour colour(glint_q16 r, glint_q16 g, glint_q16 b) {
    const glint_colour result = {r, g, b};
    return result;
}

static void set_up_meshes(fixture *f) {
    const glint_mesh torus = {torus_positions,
                              torus_normals,
                              torus_triangles,
                              TEST_COUNT(torus_positions),
                              TEST_COUNT(torus_triangles),
                              {0, 0, 0},
                              {torus_extent[0], torus_extent[1], torus_extent[2]},
                              0};
    const glint_mesh square = {floor_positions,
                               floor_normals,
                               floor_triangles,
                               4,
                               2,
                               {0, 0, 0},
                               {40 * GLINT_ONE, GLINT_ONE, 40 * GLINT_ONE},
                               GLINT_MESH_DOUBLE_SIDED};
    f->torus = torus;
    f->floor = square;
}

static void set_up_objects(fixture *f) {
    glint_pose turn_y = glint_pose_rotate_y(20 * GLINT_ONE);
    glint_pose turn_x = glint_pose_rotate_x(-50 * GLINT_ONE);
    glint_pose turn = glint_pose_then(&turn_y, &turn_x);
    for (int i = 0; i < FIXTURE_OBJECTS_MAX; i++) {
        f->materials[i].model = &glint_model_blinn_phong;
        f->materials[i].ambient = colour(GLINT_Q16(0.135), GLINT_Q16(0.075), GLINT_Q16(0.045));
        f->materials[i].diffuse = colour(GLINT_Q16(0.765), GLINT_Q16(0.425), GLINT_Q16(0.255));
        f->materials[i].specular = colour(GLINT_Q16(0.5), GLINT_Q16(0.5), GLINT_Q16(0.5));
        f->materials[i].shininess = 32 * GLINT_ONE;
        f->objects[i].mesh = &f->torus;
        f->objects[i].material = &f->materials[i];
        f->objects[i].evaluation = &glint_per_fragment;
        f->objects[i].pose = turn;
        f->objects[i].pose.m[2][3] = GLINT_Q16(-3.7);
    }
}

static void set_up_scene(fixture *f) {
    for (int i = 0; i <= GLINT_LIGHTS_MAX; i++) {
        const glint_vector direction = {GLINT_Q16(-0.4), GLINT_Q16(-0.6), GLINT_Q16(-0.7)};
        f->lights[i].type = &glint_light_directional;
        f->lights[i].direction = direction;
        f->lights[i].diffuse = f->lights[i].specular = colour(GLINT_ONE, GLINT_ONE, GLINT_ONE);
    }
    f->scene.camera.pose = glint_pose_identity();
    f->scene.camera.field_of_view = 60 * GLINT_ONE;
    f->scene.camera.near_plane = GLINT_Q16(0.1);
    f->scene.viewer = GLINT_VIEWER_LOCAL;
    f->scene.background = colour(0, 0, GLINT_ONE / 4);
    f->scene.ambient = colour(GLINT_ONE, GLINT_ONE, GLINT_ONE);
    f->scene.lights = f->lights;
    f->scene.light_count = 1;
    f->scene.objects = f->objects;
    f->scene.object_count = 1;
}

static void set_up_config(fixture *f) {
    f->config.width = FIXTURE_WIDTH;
    f->config.height = FIXTURE_HEIGHT;
    f->config.tile_width = 16;
    f->config.tile_height = 16;
    f->config.format = &glint_format_rgb565;
    f->config.flush.begin = begin;
    f->config.flush.wait = wait;
    f->config.flush.context = f;
    f->config.arena = memory.arena;
    f->config.arena_size = FIXTURE_ARENA_BYTES;
}

fixture *fixture_begin(void) {
    fill((uint8_t *)&the_fixture, sizeof the_fixture, 0);
    set_up_meshes(&the_fixture);
    set_up_objects(&the_fixture);
    set_up_scene(&the_fixture);
    set_up_config(&the_fixture);
    return &the_fixture;
}

/* ---- Drawing ------------------------------------------------------------------------------------------------- */

static void start_frame(fixture *f) {
    fill((uint8_t *)&memory, sizeof memory, GUARD);
    f->begins = f->waits = f->pixels_sent = f->flaws = 0;
    f->sending = 0;
    f->next_x = f->next_y = 0;
}

static size_t screen_bytes(const fixture *f) {
    return glint_row_bytes(f->config.format, f->config.width) * f->config.height;
}

static void check_guards(const fixture *f, size_t screen_used) {
    size_t arena_used = f->config.arena_size <= FIXTURE_ARENA_BYTES ? f->config.arena_size : 0;
    CHECK(holds(memory.before_screen, GUARD_BYTES, GUARD));
    CHECK(holds(memory.screen + screen_used, sizeof memory.screen - screen_used, GUARD));
    CHECK(holds(memory.after_screen, GUARD_BYTES, GUARD));
    if (f->config.arena == memory.arena)
        CHECK(holds(memory.arena + arena_used, sizeof memory.arena - arena_used, GUARD));
    CHECK(holds(memory.after_arena, GUARD_BYTES, GUARD));
}

glint_status fixture_render(fixture *f) {
    start_frame(f);
    glint_status status = glint_init(&f->renderer, &f->config);
    if (status == GLINT_OK)
        status = glint_render(&f->renderer, &f->scene);
    if (status == GLINT_OK) {
        CHECK_EQUAL(f->pixels_sent, (uint32_t)f->config.width * f->config.height);
        CHECK_EQUAL(f->begins, f->waits);
        check_guards(f, screen_bytes(f));
    }
    CHECK_EQUAL(f->flaws, 0);
    return status;
}

void fixture_expect_error(fixture *f, glint_status expected) {
    CHECK_EQUAL(fixture_render(f), expected);
    CHECK_EQUAL(f->begins, 0);
    check_guards(f, 0);
    glint_need need;
    if (expected != GLINT_ERROR_ARENA && f->config.arena != 0)
        CHECK_EQUAL(glint_arena_need(&f->config, &f->scene, &need), expected);
    f = fixture_begin();
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    static uint32_t sound; /* a sound frame is the same after every error */
    sound = sound ? sound : fixture_checksum(f);
    CHECK_EQUAL(fixture_checksum(f), sound);
}

glint_need fixture_need(const fixture *f) {
    glint_need need = {0};
    CHECK_EQUAL(glint_arena_need(&f->config, &f->scene, &need), GLINT_OK);
    return need;
}

/* A flip of 1 takes the bytes of each pair in reverse. */
static uint32_t checksum_of_screen(const fixture *f, size_t flip) {
    uint32_t checksum = FIXTURE_CHECKSUM_START;
    for (size_t i = 0; i < screen_bytes(f); i++)
        checksum = fixture_checksum_add(checksum, &memory.screen[i ^ flip], 1);
    return checksum;
}

uint32_t fixture_checksum(const fixture *f) {
    return checksum_of_screen(f, byte_order_flip_of(f->config.format));
}

uint32_t fixture_checksum_of_pairs(const fixture *f) {
    return checksum_of_screen(f, 1);
}

const uint8_t *fixture_row(const fixture *f, int y) {
    return memory.screen + glint_row_bytes(f->config.format, f->config.width) * (size_t)y;
}

uint8_t *fixture_arena(void) {
    return memory.arena;
}
