/* SPDX-License-Identifier: MIT */
/*
 * Suite: flush callbacks and painters that fail at any tile end the frame by a named error, and the next one is whole;
 * callbacks that draw, pick and ask with a renderer of their own leave the frame that called them as it is.
 */
#include "glint_extras.h"
#include "harness.h"
#include "scenes.h"

#include <stdlib.h>
#include <string.h>

/* Neither is a multiple of a tile. */
#define WIDTH 70
#define HEIGHT 41
#define TILE 16
#define TILES (5u * 3u)
#define ARENA_MOST (256u << 10)
#define NEVER 0xffffffffu

/* ---- A screen whose callbacks fail, or call the library ---- */

typedef enum callback { BEGIN, WAIT, BACKGROUND, OVERLAY, CALLBACKS } callback;

typedef struct screen {
    uint16_t pixel[HEIGHT][WIDTH];
    uint32_t calls[CALLBACKS];
    uint32_t fails_at[CALLBACKS];
    int failure[CALLBACKS];                /* what is returned then */
    void (*within)(struct screen *screen); /* called by each callback */
    int has_wait, is_sending;
    uint32_t unpaired; /* begins while something is sent, and waits while nothing is */
} screen;

static int called(screen *s, callback which) {
    if (s->within)
        s->within(s);
    return s->calls[which]++ == s->fails_at[which] ? s->failure[which] : 0;
}

static int begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    screen *const s = context;
    s->unpaired += (uint32_t)s->is_sending;
    for (int row = 0; row < height; row++)
        memcpy(&s->pixel[y + row][x], (const uint8_t *)pixels + (size_t)row * stride, (size_t)width * sizeof(uint16_t));
    const int failed = called(s, BEGIN);
    s->is_sending = failed == 0 && s->has_wait;
    return failed;
}

static int wait(void *context) {
    screen *const s = context;
    s->unpaired += !s->is_sending;
    s->is_sending = 0;
    return called(s, WAIT);
}

/* Stripes that tell tiles apart. */
static int paint_background(void *context, const glint_tile *tile) {
    for (int y = 0; y < tile->height; y++)
        for (int x = 0; x < tile->width; x++)
            ((uint16_t *)tile->pixels)[(size_t)y * tile->stride / 2 + (size_t)x] = (uint16_t)(tile->x * 77 + y);
    return called(context, BACKGROUND);
}

/* A line across each tile. */
static int paint_overlay(void *context, const glint_tile *tile) {
    for (int x = 0; x < tile->width; x++)
        ((uint16_t *)tile->pixels)[x] ^= 0x1234;
    return called(context, OVERLAY);
}

static void open_screen(screen *s) {
    const int has_wait = s->has_wait;
    memset(s, 0, sizeof *s);
    s->has_wait = has_wait;
    for (int i = 0; i < CALLBACKS; i++)
        s->fails_at[i] = NEVER;
}

/* ---- Renderers ---- */

typedef struct setting {
    int has_wait, has_painters, is_least, keeps_arena;
} setting;

static setting setting_of(int number) {
    return (setting){number & 1, number >> 1 & 1, number >> 2 & 1, number >> 3 & 1};
}

static glint_config configure(screen *s, setting as, const glint_scene *scene, void *arena) {
    glint_config config = {.width = WIDTH,
                           .height = HEIGHT,
                           .tile_width = TILE,
                           .tile_height = TILE,
                           .format = &glint_format_rgb565,
                           .flush = {begin, as.has_wait ? wait : NULL, s},
                           .arena = arena,
                           .keeps_arena = (uint8_t)as.keeps_arena};
    glint_need need = {0};
    s->has_wait = as.has_wait;
    if (as.has_painters) {
        config.background = (glint_painter){paint_background, s};
        config.overlay = (glint_painter){paint_overlay, s};
    }
    CHECK_EQUAL(glint_arena_need(&config, scene, &need), GLINT_OK);
    config.arena_size = as.is_least ? need.least : need.one_pass;
    CHECK_AT_MOST(config.arena_size, ARENA_MOST);
    return config;
}

static const glint_scene *example(uint32_t seed) {
    static test_scene scenes[3];
    scene_build_random(&scenes[seed % 3], seed);
    return &scenes[seed % 3].scene;
}

/* ---- Failures ---- */

static uint8_t arena[ARENA_MOST];

/* What was called before the frame ended: nothing after the failure but the wait for what was on its way. */
static void check_calls(const screen *s, setting as, callback which, uint32_t tile) {
    CHECK_EQUAL(s->calls[which], tile + 1);
    CHECK_EQUAL(s->unpaired, 0);
    CHECK(!s->is_sending);
    CHECK_EQUAL(s->calls[BEGIN], which == BEGIN || which == WAIT ? tile + 1 : tile);
    CHECK_EQUAL(s->calls[WAIT], !as.has_wait ? 0 : which == WAIT ? tile + 1 : tile);
    if (as.has_painters) { /* while a tile is sent, the next one is painted */
        const uint32_t painted = tile + 1 + (which == WAIT && tile + 1 < TILES);
        CHECK_EQUAL(s->calls[BACKGROUND], painted);
        CHECK_EQUAL(s->calls[OVERLAY], which == BACKGROUND ? tile : painted);
    }
}

static void fail_at(glint_renderer *renderer, const glint_scene *scene, setting as, callback which, uint32_t tile) {
    static const int failures[] = {1, -1, -13, 0x7fffffff, -0x7fffffff - 1, GLINT_ERROR_TIMEOUT};
    screen *const s = renderer->config.flush.context;
    const int is_flush = which == BEGIN || which == WAIT;
    open_screen(s);
    s->fails_at[which] = tile;
    s->failure[which] = failures[tile % TEST_COUNT(failures)];
    CHECK_EQUAL(glint_render(renderer, scene), is_flush ? GLINT_ERROR_FLUSH : GLINT_ERROR_PAINT);
    CHECK_EQUAL(renderer->stats.flush_error, is_flush ? s->failure[which] : 0);
    check_calls(s, as, which, tile);
}

static void check_next(glint_renderer *renderer, const glint_scene *scene, const screen *wanted) {
    screen *const s = renderer->config.flush.context;
    open_screen(s);
    CHECK_EQUAL(glint_render(renderer, scene), GLINT_OK);
    CHECK_EQUAL(renderer->stats.flush_error, 0);
    CHECK_EQUAL(s->calls[BEGIN], TILES);
    CHECK_EQUAL(s->unpaired, 0);
    CHECK(memcmp(s->pixel, wanted->pixel, sizeof wanted->pixel) == 0);
}

static void failures_end_the_frame(void) {
    static screen s, wanted;
    for (int number = 0; number < 16; number++) {
        const setting as = setting_of(number);
        const glint_scene *const scene = example(5);
        glint_renderer renderer;
        const glint_config config = configure(&s, as, scene, arena);
        CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
        open_screen(&s);
        CHECK_EQUAL(glint_render(&renderer, scene), GLINT_OK);
        CHECK(as.is_least == (renderer.stats.passes > 1));
        wanted = s;
        for (int which = 0; which < CALLBACKS; which++)
            for (uint32_t tile = 0; tile < TILES; tile++) {
                if ((which == WAIT && !as.has_wait) || (which >= BACKGROUND && !as.has_painters))
                    continue;
                fail_at(&renderer, scene, as, (callback)which, tile);
                check_next(&renderer, scene, &wanted);
            }
    }
}

/* A painter fails, and then the wait for the tile before: the frame's error is the first, and neither is lost. */
static void both_failures_are_told(void) {
    static screen s;
    const glint_scene *const scene = example(5);
    glint_renderer renderer;
    const glint_config config = configure(&s, (setting){.has_wait = 1, .has_painters = 1}, scene, arena);
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    for (uint32_t tile = 1; tile < TILES; tile++) {
        open_screen(&s);
        s.fails_at[OVERLAY] = tile;
        s.fails_at[WAIT] = tile - 1;
        s.failure[OVERLAY] = 5;
        s.failure[WAIT] = GLINT_ERROR_TIMEOUT;
        CHECK_EQUAL(glint_render(&renderer, scene), GLINT_ERROR_PAINT);
        CHECK_EQUAL(renderer.stats.flush_error, GLINT_ERROR_TIMEOUT);
        CHECK_EQUAL(s.calls[BEGIN], tile);
        CHECK_EQUAL(s.calls[WAIT], tile);
    }
}

/* ---- Callbacks that call the library ---- */

/* What callbacks draw with; each level of them has its own. */
typedef struct nested {
    glint_renderer renderer;
    screen screen, wanted;
    const glint_scene *scene;
    uint8_t *arena;
    uint32_t calls;
} nested;

static nested levels[2];

static void draw_level(nested *of, void (*within)(screen *s), uint32_t fails_at) {
    open_screen(&of->screen);
    of->screen.within = within;
    of->screen.fails_at[BEGIN] = fails_at;
    of->screen.failure[BEGIN] = 1;
    of->calls++;
    CHECK_EQUAL(glint_render(&of->renderer, of->scene), fails_at == NEVER ? GLINT_OK : GLINT_ERROR_FLUSH);
    if (fails_at == NEVER)
        CHECK(memcmp(of->screen.pixel, of->wanted.pixel, sizeof of->wanted.pixel) == 0);
}

static void draw_innermost(screen *s) {
    (void)s;
    draw_level(&levels[1], NULL, NEVER);
}

/* A frame now and then, of which some draw another in their callbacks; frames that fail; questions. */
static void call_library(screen *s) {
    nested *const of = &levels[0];
    const glint_scene *const scene = of->scene;
    const glint_config *const config = &of->renderer.config;
    const uint32_t all = s->calls[BEGIN] + s->calls[WAIT] + s->calls[BACKGROUND] + s->calls[OVERLAY];
    const glint_line line = {{0, 0, 0}, {GLINT_ONE, GLINT_ONE, 0}, {GLINT_ONE, 0, 0}};
    const glint_rectangle part = {16, 8, 24, 16};
    glint_need need;
    glint_report report;
    glint_screen_point place;
    glint_hit hit;
    glint_segment segment;
    glint_frame frame;
    switch (all % 8) {
    case 0:
        draw_level(of, draw_innermost, NEVER);
        break;
    case 1:
        draw_level(of, NULL, all % 7);
        break;
    case 2:
        CHECK_EQUAL(glint_check(config, scene, &report), GLINT_OK);
        break;
    case 3:
        CHECK(glint_pick(&of->renderer, scene, WIDTH / 2, HEIGHT / 2, &hit) >= 0);
        break;
    case 4:
        CHECK(glint_camera_project(config, &scene->camera, (glint_vector){0, 0, 0}, &place) >= 0);
        CHECK_EQUAL(glint_lines_project(&segment, config, &scene->camera, &scene->objects[0].pose, &line, 1), GLINT_OK);
        break;
    case 5:
        CHECK_EQUAL(glint_frame_begin(&frame, config, scene), GLINT_OK);
        CHECK(glint_frame_next_pass(&frame) > 0);
        break;
    case 6:
        open_screen(&of->screen);
        CHECK_EQUAL(glint_render_region(&of->renderer, scene, &part), GLINT_OK);
        break;
    default:
        CHECK_EQUAL(glint_arena_need(config, scene, &need), GLINT_OK);
        draw_level(of, NULL, NEVER);
        break;
    }
}

static void open_level(nested *of, uint32_t seed, setting as) {
    of->scene = example(seed);
    of->arena = malloc(ARENA_MOST);
    of->calls = 0;
    CHECK(of->arena != NULL);
    const glint_config config = configure(&of->screen, as, of->scene, of->arena);
    CHECK_EQUAL(glint_init(&of->renderer, &config), GLINT_OK);
    open_screen(&of->screen);
    CHECK_EQUAL(glint_render(&of->renderer, of->scene), GLINT_OK);
    of->wanted = of->screen;
}

static void callbacks_may_call_the_library(void) {
    static screen s, wanted;
    for (int number = 0; number < 16; number++) {
        const setting as = setting_of(number);
        const glint_scene *const scene = example(5);
        glint_renderer renderer;
        open_level(&levels[0], 6, setting_of(15 - number));
        open_level(&levels[1], 7, (setting){.has_wait = 1});
        const glint_config config = configure(&s, as, scene, arena);
        CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
        open_screen(&s);
        CHECK_EQUAL(glint_render(&renderer, scene), GLINT_OK);
        wanted = s;
        for (int frame = 0; frame < 2; frame++) {
            open_screen(&s);
            s.within = call_library;
            CHECK_EQUAL(glint_render(&renderer, scene), GLINT_OK);
            CHECK_EQUAL(s.calls[BEGIN], TILES);
            CHECK(memcmp(s.pixel, wanted.pixel, sizeof wanted.pixel) == 0);
        }
        CHECK(levels[0].calls > 0 && levels[1].calls > 0);
        free(levels[0].arena);
        free(levels[1].arena);
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(failures_end_the_frame),
        TEST_CASE(both_failures_are_told),
        TEST_CASE(callbacks_may_call_the_library),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
