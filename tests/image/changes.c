/* SPDX-License-Identifier: MIT */
/*
 * Suite: a panel that keeps its picture and is sent only the tiles that changed shows, after every frame, what a panel
 * shows that is sent all of them; also after transfers that failed.
 */
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "scenes.h"

#include <stdlib.h>
#include <string.h>

/* Neither is a multiple of a tile. */
#define WIDTH 150
#define HEIGHT 101
#define TILES_MAX (19 * 13)
#define FRAMES 12
#define ARENA (1 << 18)

/* A panel whose transfers fail now and then, as they begin or as they end; what was on its way is then lost. */
typedef struct panel {
    picture shown;
    glint_flush flush;
    uint32_t calls, fail_every; /* 0: never */
    int has_wait;
    int rectangle[4]; /* on its way */
    const void *pixels;
    size_t stride;
} panel;

static int fails(panel *p) {
    return p->fail_every != 0 && ++p->calls % p->fail_every == 0;
}

static int finish(panel *p) {
    if (fails(p))
        return 1;
    return picture_put(&p->shown, p->rectangle, p->pixels, p->stride);
}

static int begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    panel *p = context;
    const int rectangle[4] = {x, y, width, height};
    memcpy(p->rectangle, rectangle, sizeof rectangle);
    p->pixels = pixels;
    p->stride = stride;
    return fails(p) || (!p->has_wait && finish(p));
}

static int wait(void *context) {
    return finish(context);
}

static glint_config configure(panel *p, const glint_format *format, uint16_t tile, int has_wait, void *arena) {
    *p = (panel){.shown = picture_open(WIDTH, HEIGHT, format), .has_wait = has_wait};
    p->flush = (glint_flush){begin, has_wait ? wait : 0, p};
    return (glint_config){.width = WIDTH,
                          .height = HEIGHT,
                          .tile_width = tile,
                          .tile_height = tile,
                          .format = format,
                          .flush = p->flush,
                          .arena = arena,
                          .arena_size = ARENA};
}

/* A torus that moves through the picture and stands still in every third frame. */
static void build(test_scene *scene, int frame) {
    scene_build(scene, &scene_definitions[0]);
    scene->objects[0].pose.m[0][3] += (frame - frame / 3 - FRAMES / 3) * GLINT_ONE / 8;
}

static glint_status draw(const glint_config *config, const glint_scene *scene) {
    glint_renderer renderer;
    const glint_status status = glint_init(&renderer, config);
    return status == GLINT_OK ? glint_render(&renderer, scene) : status;
}

static void check_shown(const panel *p, const glint_scene *scene) {
    picture wanted = picture_open(WIDTH, HEIGHT, p->shown.format);
    CHECK_EQUAL(picture_render(&wanted, scene, NULL, NULL), GLINT_OK);
    CHECK(memcmp(wanted.bytes, p->shown.bytes, wanted.size) == 0);
    picture_close(&wanted);
}

static void follow(const glint_format *format, uint16_t tile, int has_wait) {
    static glint_signature signatures[TILES_MAX];
    void *arena = malloc(ARENA);
    glint_changes changes;
    panel p;
    glint_config config = configure(&p, format, tile, has_wait, arena);
    CHECK_AT_MOST(glint_changes_count(&config), TILES_MAX);
    CHECK_EQUAL(glint_changes_init(&changes, signatures, &config), GLINT_OK);
    config.flush = glint_changes_flush(&changes);
    for (int frame = 0; frame < FRAMES; frame++) {
        test_scene scene;
        const uint32_t before = changes.sent, tiles = glint_changes_count(&config);
        build(&scene, frame);
        CHECK_EQUAL(draw(&config, &scene.scene), GLINT_OK);
        check_shown(&p, &scene.scene);
        CHECK_EQUAL(changes.sent + changes.unchanged, (uint32_t)(frame + 1) * tiles);
        if (frame == 0)
            CHECK_EQUAL(changes.sent, tiles);
        else if (frame % 3 == 0)
            CHECK_EQUAL(changes.sent, before);
        else
            CHECK(changes.sent > before && changes.sent < before + tiles);
    }
    glint_changes_forget(&changes);
    const uint32_t before = changes.sent;
    test_scene scene;
    build(&scene, FRAMES - 1);
    CHECK_EQUAL(draw(&config, &scene.scene), GLINT_OK);
    CHECK_EQUAL(changes.sent, before + glint_changes_count(&config));
    picture_close(&p.shown);
    free(arena);
}

static void only_what_changed_is_sent(void) {
    follow(&glint_format_rgb565, 32, 0);
    follow(&glint_format_rgb565, 16, 1);
    follow(&glint_format_rgb888, 16, 1);
    follow(&glint_format_grey4_dithered, 8, 0);
}

/* What failed is sent again, however it failed, until the picture is whole. */
static void failed_transfers_are_sent_again(void) {
    static glint_signature signatures[TILES_MAX];
    void *arena = malloc(ARENA);
    for (uint32_t every = 1; every < 40; every += 3) {
        glint_changes changes;
        panel p;
        glint_config config = configure(&p, &glint_format_rgb565, 32, every % 2 == 0, arena);
        glint_changes_init(&changes, signatures, &config);
        config.flush = glint_changes_flush(&changes);
        test_scene scene;
        for (int frame = 0; frame < FRAMES; frame++) {
            build(&scene, frame);
            p.fail_every = every;
            const glint_status status = draw(&config, &scene.scene);
            CHECK(status == GLINT_OK || status == GLINT_ERROR_FLUSH);
            if (status == GLINT_OK)
                check_shown(&p, &scene.scene);
        }
        p.fail_every = 0;
        CHECK_EQUAL(draw(&config, &scene.scene), GLINT_OK);
        check_shown(&p, &scene.scene);
        picture_close(&p.shown);
    }
    free(arena);
}

/* A filter that was refused has no flush to draw with. */
static void expect_refused(glint_signature *signatures, const glint_config *config, glint_status expected) {
    glint_changes changes;
    memset(&changes, 0xff, sizeof changes);
    CHECK_EQUAL(glint_changes_init(&changes, signatures, config), expected);
    CHECK(!changes.sent && !changes.unchanged && !changes.signatures && !changes.count);
    const glint_flush flush = glint_changes_flush(&changes);
    CHECK(!flush.begin && !flush.wait && !flush.context);
}

static void bad_arguments_are_refused(void) {
    glint_signature signature;
    panel p;
    uint32_t arena[1];
    glint_config config = configure(&p, &glint_format_rgb565, 32, 0, arena);
    CHECK_EQUAL(glint_changes_init(NULL, &signature, &config), GLINT_ERROR_NULL);
    expect_refused(NULL, &config, GLINT_ERROR_NULL);
    expect_refused(&signature, NULL, GLINT_ERROR_NULL);
    config.tile_width = 5;
    expect_refused(&signature, &config, GLINT_ERROR_TILE);
    CHECK_EQUAL(glint_changes_count(&config), 0);
    config.tile_width = 32;
    config.flush.begin = 0;
    expect_refused(&signature, &config, GLINT_ERROR_NULL);
    picture_close(&p.shown);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(only_what_changed_is_sent),
        TEST_CASE(failed_transfers_are_sent_again),
        TEST_CASE(bad_arguments_are_refused),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
