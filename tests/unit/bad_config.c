/* SPDX-License-Identifier: MIT */
/* Bad configurations and arenas, and a flush callback without a wait. */
#include "fixture.h"
#include "glint_extras.h"
#include "harness.h"
#include "unit.h"

void init_refuses_bad_configurations(void) {
    static const uint16_t tiles[] = {1, 4, 7, 9, 12, 24, 48, 63, 65, 128, 65535};
    REFUSED(GLINT_ERROR_SIZE, f->config.width = 0, f->config.height = 32);
    REFUSED(GLINT_ERROR_SIZE, f->config.width = 32, f->config.height = 0);
    REFUSED(GLINT_ERROR_SIZE, f->config.width = GLINT_SIZE_MAX + 1, f->config.height = 32);
    REFUSED(GLINT_ERROR_SIZE, f->config.width = 32, f->config.height = GLINT_SIZE_MAX + 1);
    REFUSED(GLINT_ERROR_SIZE, f->config.width = 65535, f->config.height = 65535);
    for (unsigned i = 0; i < TEST_COUNT(tiles); i++) {
        REFUSED(GLINT_ERROR_TILE, f->config.tile_width = tiles[i], f->config.tile_height = 8);
        REFUSED(GLINT_ERROR_TILE, f->config.tile_width = 8, f->config.tile_height = tiles[i]);
    }
    REFUSED(GLINT_ERROR_ARENA, f->config.arena_size = 0);
    REFUSED(GLINT_ERROR_ARENA, f->config.arena_size = 8);
    fixture *f = fixture_begin();
    f->config.arena_size = glint_workspace_size(&f->config) - 1;
    CHECK_EQUAL(glint_init(&f->renderer, &f->config), GLINT_ERROR_ARENA);
    f = fixture_begin();
    f->config.pixels = fixture_arena() + (-(uintptr_t)fixture_arena() & (sizeof(void *) - 1));
    f->config.pixels_size = glint_pixels_need(&f->config) - 1;
    CHECK_EQUAL(glint_init(&f->renderer, &f->config), GLINT_ERROR_PIXELS);
    f->config.pixels_size++;
    CHECK_EQUAL(glint_init(&f->renderer, &f->config), GLINT_OK);
    f->config.format = 0;
    CHECK_EQUAL(glint_pixels_need(&f->config), 0);
}

void null_pointers_are_refused(void) {
    fixture *f = fixture_begin();
    glint_frame frame;
    glint_need need;
    const glint_vector zero = {0, 0, 0};
    const glint_vector at = {0, 0, -GLINT_ONE};
    const glint_vector up = {0, GLINT_ONE, 0};
    CHECK_EQUAL(glint_init(0, &f->config), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_init(&f->renderer, 0), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_render(0, &f->scene), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_arena_need(0, &f->scene, &need), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_arena_need(&f->config, 0, &need), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_arena_need(&f->config, &f->scene, 0), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_frame_begin(0, &f->config, &f->scene), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_frame_begin(&frame, 0, &f->scene), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_frame_begin(&frame, &f->config, 0), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_frame_next_pass(0), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_camera_look_at(0, zero, at, up), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_init(&f->renderer, &f->config), GLINT_OK);
    CHECK_EQUAL(glint_render(&f->renderer, 0), GLINT_ERROR_NULL);
    f->config.flush.begin = 0;
    CHECK_EQUAL(glint_init(&f->renderer, &f->config), GLINT_ERROR_NULL);
}

/* ---- What a failure leaves ----------------------------------------------------------------------------------- */

/* Breaks a configuration, or for 0 nothing but what glint_init is given. @return the error; GLINT_OK when there is no
 * such way */
static glint_status break_config(glint_config *config, int how) {
    switch (how) {
    case 0:
        return GLINT_ERROR_NULL;
    case 1:
        config->arena = 0;
        return GLINT_ERROR_NULL;
    case 2:
        config->format = 0;
        return GLINT_ERROR_NULL;
    case 3:
        config->width = 0;
        return GLINT_ERROR_SIZE;
    case 4:
        config->tile_height = 7;
        return GLINT_ERROR_TILE;
    case 5:
        config->arena_size = 9;
        return GLINT_ERROR_ARENA;
    default:
        return GLINT_OK;
    }
}

static int is_zero(const glint_config *config) {
    return !(config->width | config->height | config->tile_width | config->tile_height) && !config->format &&
           !config->flush.begin && !config->flush.wait && !config->flush.context && !config->arena &&
           !config->arena_size && !config->gamma && !config->keeps_arena;
}

/* A renderer that held something is all 0, and cannot draw. */
void failed_init_leaves_zeros(void) {
    for (int how = 0;; how++) {
        fixture *f = fixture_begin();
        CHECK_EQUAL(fixture_render(f), GLINT_OK);
        glint_config config = f->config;
        const glint_status expected = break_config(&config, how);
        if (expected == GLINT_OK)
            break;
        CHECK(!is_zero(&f->renderer.config) && f->renderer.stats.tiles && f->renderer.kept.count);
        CHECK_EQUAL(glint_init(&f->renderer, how ? &config : 0), expected);
        CHECK(is_zero(&f->renderer.config));
        CHECK(!f->renderer.stats.tiles && !f->renderer.kept.shadings && !f->renderer.kept.count);
        CHECK_EQUAL(glint_render(&f->renderer, &f->scene), GLINT_ERROR_NULL);
    }
}

/* A frame that was begun is all 0, and has no pass; for an error of its configuration or of its scene. */
void failed_begin_leaves_zeros(void) {
    for (int how = 0; how < 8; how++) {
        fixture *f = fixture_begin();
        glint_frame frame;
        glint_config config = f->config;
        CHECK_EQUAL(glint_frame_begin(&frame, &config, &f->scene), GLINT_OK);
        glint_status expected = break_config(&config, how);
        if (how == 6)
            expected = GLINT_ERROR_NULL;
        if (how == 7) {
            f->materials[0].specular.r = f->lights[0].specular.r = GLINT_COLOUR_MAX;
            expected = GLINT_ERROR_COLOUR;
        }
        CHECK_EQUAL(glint_frame_begin(&frame, how ? &config : 0, how == 6 ? 0 : &f->scene), expected);
        CHECK(is_zero(&frame.config));
        CHECK(!frame.scene && !frame.view && !frame.shading && !frame.shading_count && !frame.tile_count);
        CHECK_EQUAL(glint_frame_next_pass(&frame), GLINT_ERROR_NULL);
    }
}

/* What is only filled in stays as it was. */
void failed_questions_leave_answers(void) {
    fixture *f = fixture_begin();
    const glint_vector zero = {0, 0, 0}, up = {0, GLINT_ONE, 0};
    glint_need need = {1, 2, 3};
    glint_camera camera = {glint_pose_scale(1, 2, 3), 4, 5};
    CHECK_EQUAL(glint_camera_look_at(&camera, zero, up, up), GLINT_ERROR_CAMERA);
    for (int i = 0; i < 12; i++)
        CHECK_EQUAL(camera.pose.m[i / 4][i % 4], i % 5 ? 0 : i / 5 + 1);
    CHECK(camera.field_of_view == 4 && camera.near_plane == 5);
    f->objects[0].pose = glint_pose_scale(0, 0, 0);
    CHECK_EQUAL(glint_arena_need(&f->config, &f->scene, &need), GLINT_ERROR_POSE);
    f = fixture_begin();
    f->torus.triangle_count = 0;
    CHECK_EQUAL(glint_arena_need(&f->config, &f->scene, &need), GLINT_ERROR_MESH);
    f = fixture_begin();
    f->config.format = 0;
    CHECK_EQUAL(glint_arena_need(&f->config, &f->scene, &need), GLINT_ERROR_NULL);
    CHECK_EQUAL(glint_workspace_size(&f->config), 0);
    CHECK(need.least == 1 && need.resident == 2 && need.one_pass == 3);
}

/* ---- Arena --------------------------------------------------------------------------------------------------- */

/* The smallest arena at every alignment draws the frame, one byte less is refused. */
void arena_one_byte_short_is_refused(void) {
    fixture *f = fixture_begin();
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    uint32_t wanted = fixture_checksum(f);
    glint_need need = fixture_need(f);
    CHECK(need.least <= need.one_pass);
    for (unsigned skew = 0; skew < 8 && need.least + skew <= FIXTURE_ARENA_BYTES; skew++) {
        f = fixture_begin();
        f->config.arena = fixture_arena() + skew;
        f->config.arena_size = need.least;
        CHECK_EQUAL(fixture_render(f), GLINT_OK);
        CHECK_EQUAL(fixture_checksum(f), wanted);
        f = fixture_begin();
        f->config.arena = fixture_arena() + skew;
        f->config.arena_size = need.least - 1;
        fixture_expect_error(f, GLINT_ERROR_ARENA);
    }
}

/* What glint_frame_begin says to the fixture's arena, workspace aside. */
static glint_status begin_frame(const fixture *f) {
    glint_frame frame;
    frame.shading_count = 0xffffffffu; /* anything, where the arena is not kept */
    return glint_frame_begin(&frame, &f->config, &f->scene);
}

#define BESIDE 64

/* Changes or checks the bytes on both sides of an arena. @return how many are not what they were */
static unsigned beside(uint8_t *arena, size_t size, int checks) {
    unsigned changed = 0;
    for (unsigned i = 0; i < BESIDE; i++) {
        uint8_t *const bytes[2] = {arena - BESIDE + i, arena + size + i};
        for (unsigned side = 0; side < 2; side++) {
            changed += checks && *bytes[side] != 0x5a + i;
            *bytes[side] = (uint8_t)(0x5a + i);
        }
    }
    return changed;
}

/* Arenas of every size: none writes beside itself, and from one on they are accepted. */
static void expect_arenas(fixture *f) {
    const size_t most = FIXTURE_ARENA_BYTES - 2 * BESIDE;
    int accepted = 0;
    f->config.arena = fixture_arena() + BESIDE;
    for (size_t size = 0; size <= most; size += accepted > 64 ? 61 : 1) { /* a board takes its time */
        beside(f->config.arena, size, 0);
        f->config.arena_size = size;
        const glint_status status = begin_frame(f);
        CHECK(status == GLINT_OK || (status == GLINT_ERROR_ARENA && !accepted));
        CHECK_EQUAL(beside(f->config.arena, size, 1), 0);
        accepted += status == GLINT_OK;
    }
    CHECK(accepted > 0 && accepted < (int)most);
}

void frames_refuse_small_arenas(void) {
    expect_arenas(fixture_begin());
    fixture *f = fixture_begin();
    f->scene.light_count = 0; /* a view takes less than an object's transform */
    expect_arenas(f);
}

/* ---- Flush --------------------------------------------------------------------------------------------------- */

static uint32_t tiles_taken;

static int take_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    tiles_taken += context == 0 && x >= 0 && y >= 0 && width > 0 && height > 0 && pixels != 0 && stride > 0;
    return 0;
}

void flush_without_wait(void) {
    fixture *f = fixture_begin();
    f->config.flush.begin = take_tile;
    f->config.flush.wait = 0;
    f->config.flush.context = 0;
    tiles_taken = 0;
    CHECK_EQUAL(glint_init(&f->renderer, &f->config), GLINT_OK);
    CHECK_EQUAL(glint_render(&f->renderer, &f->scene), GLINT_OK);
    CHECK_EQUAL(tiles_taken, (FIXTURE_WIDTH / 16) * (FIXTURE_HEIGHT / 16));
}
