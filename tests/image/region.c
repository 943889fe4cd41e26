/* SPDX-License-Identifier: MIT */
/*
 * Suite: regions side by side make the whole frame, also where the screen lies elsewhere on a display; painters of
 * background and overlay see each pixel once, and where objects show. A panel that is sent only the tiles that changed
 * shows, after every frame, what a panel shows that is sent all of them.
 */
#include "every_format.h"
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "random.h"
#include "scenes.h"

#include <string.h>

/* Neither is a multiple of a tile. */
#define WIDTH 150
#define HEIGHT 101
#define NOTHING 0xffffffffu

/* ---- A display of pixels by number, larger than the screen ---- */

#define MARGIN 8

typedef struct display {
    const glint_format *format;
    uint32_t pixel[HEIGHT + 2 * MARGIN][WIDTH + 2 * MARGIN]; /* NOTHING where none was sent */
    uint32_t again;                                          /* pixels sent twice, or beyond the display */
    uint32_t calls;
} display;

/* The bits of a pixel, x and y from a byte's first on. */
static uint32_t bits_at(const glint_format *format, const void *pixels, size_t stride, int x, int y) {
    const uint8_t *const bytes = pixels;
    const uint8_t *const row = bytes + (size_t)y * stride;
    if (format_is_paged(format))
        return bytes[(size_t)x + (size_t)(y / 8 * 8) * stride] >> (y & 7) & 1;
    switch (glint_row_bytes(format, 8)) {
    case 1:
        return row[x >> 3] >> (x & 7) & 1;
    case 4:
        return x & 1 ? row[x >> 1] & 15 : row[x >> 1] >> 4;
    case 8:
        return row[x];
    case 12:
        return x & 1 ? (row[3 * (x >> 1) + 1] & 15u) << 8 | row[3 * (x >> 1) + 2]
                     : (uint32_t)row[3 * (x >> 1)] << 4 | row[3 * (x >> 1) + 1] >> 4;
    case 16:
        return (uint32_t)row[2 * x] << 8 | row[2 * x + 1];
    default:
        return (uint32_t)row[3 * x] << 16 | (uint32_t)row[3 * x + 1] << 8 | row[3 * x + 2];
    }
}

static int begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    display *to = context;
    to->calls++;
    for (int row = 0; row < height; row++)
        for (int column = 0; column < width; column++) {
            const int at_x = x + column + MARGIN, at_y = y + row + MARGIN;
            if (at_x < 0 || at_y < 0 || at_x >= WIDTH + 2 * MARGIN || at_y >= HEIGHT + 2 * MARGIN ||
                to->pixel[at_y][at_x] != NOTHING)
                to->again++;
            else
                to->pixel[at_y][at_x] = bits_at(to->format, pixels, stride, column, row);
        }
    return 0;
}

static int wait(void *context) {
    (void)context;
    return 0;
}

static void clear(display *to, const glint_format *format) {
    memset(to->pixel, 0xff, sizeof to->pixel);
    to->format = format;
    to->again = to->calls = 0;
}

/* ---- Frames ---- */

static uint8_t arena[1 << 20];
static display whole, part;

static glint_config configure(display *to, const glint_format *format, uint16_t tile) {
    clear(to, format);
    return (glint_config){.width = WIDTH,
                          .height = HEIGHT,
                          .tile_width = tile,
                          .tile_height = tile,
                          .format = format,
                          .flush = {begin, wait, to},
                          .arena = arena,
                          .arena_size = sizeof arena};
}

static glint_status draw(const glint_config *config, const glint_scene *scene) {
    glint_renderer renderer;
    const glint_status status = glint_init(&renderer, config);
    return status == GLINT_OK ? glint_render(&renderer, scene) : status;
}

static uint32_t at(const display *of, int x, int y) {
    return of->pixel[y + MARGIN][x + MARGIN];
}

/* Is the part the whole's, at an offset, and nothing else? */
static int is_part(const glint_rectangle *region, int left, int top) {
    uint32_t wrong = part.again;
    for (int y = -MARGIN; y < HEIGHT + MARGIN; y++)
        for (int x = -MARGIN; x < WIDTH + MARGIN; x++) {
            const int of_x = x - left, of_y = y - top;
            const int inside = of_x >= region->x && of_x < region->x + region->width && of_y >= region->y &&
                               of_y < region->y + region->height;
            wrong += at(&part, x, y) != (inside ? at(&whole, of_x, of_y) : NOTHING);
        }
    return wrong == 0;
}

static void regions_side_by_side_make_the_whole(void) {
    test_scene scene;
    glint_renderer renderer;
    scene_build_random(&scene, 7);
    glint_config config = configure(&whole, &glint_format_rgb565, 0);
    CHECK_EQUAL(draw(&config, &scene.scene), GLINT_OK);
    config = configure(&part, &glint_format_rgb565, 0);
    config.left = MARGIN - 1;
    config.top = -MARGIN;
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    for (int16_t x = 0; x < WIDTH; x = (int16_t)(x + 47))
        for (int16_t y = 0; y < HEIGHT; y = (int16_t)(y + 13)) {
            const glint_rectangle region = {x, y, (int16_t)(x + 47 < WIDTH ? 47 : WIDTH - x),
                                            (int16_t)(y + 13 < HEIGHT ? 13 : HEIGHT - y)};
            CHECK_EQUAL(glint_render_region(&renderer, &scene.scene, &region), GLINT_OK);
        }
    const glint_rectangle all = {0, 0, WIDTH, HEIGHT};
    CHECK(is_part(&all, config.left, config.top));
    clear(&part, config.format); /* the renderer's own region is as it was */
    CHECK_EQUAL(glint_render(&renderer, &scene.scene), GLINT_OK);
    CHECK(is_part(&all, config.left, config.top));
}

/* Colours at vertices are interpolated over eight columns of the screen, or divided by w where few of these are drawn:
 * where a region ends must not decide on it, or it shows as a seam. */
static void regions_end_anywhere(void) {
    static const uint8_t colours[4][3] = {{255, 0, 90}, {40, 180, 10}, {20, 90, 250}, {250, 250, 60}};
    const glint_material paint = {.model = &glint_model_unlit, .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    glint_mesh square = scene_square_mesh(2 * GLINT_ONE, GLINT_ONE);
    square.colours = colours;
    for (int i = 0; i < 24; i++) {
        const glint_pose x = glint_pose_rotate_x((20 + i) * GLINT_ONE), y = glint_pose_rotate_y((30 - i) * GLINT_ONE);
        const glint_object object = {&square, &paint, glint_pose_then(&x, &y), &glint_per_vertex};
        const glint_scene scene = {.camera = glint_camera_default(), .objects = &object, .object_count = 1};
        glint_config config = configure(&whole, &glint_format_rgb888, 0);
        CHECK_EQUAL(draw(&config, &scene), GLINT_OK);
        config = configure(&part, &glint_format_rgb888, 0);
        config.region = (glint_rectangle){(int16_t)i, 0, (int16_t)(64 + 2 * i), HEIGHT};
        CHECK_EQUAL(draw(&config, &scene), GLINT_OK);
        CHECK(is_part(&config.region, 0, 0));
    }
}

static void bad_regions_are_refused(void) {
    static const struct {
        const glint_format *format;
        glint_rectangle region;
        glint_status status;
    } cases[] = {
        {&glint_format_rgb565, {0, 0, 0, 1}, GLINT_ERROR_REGION},
        {&glint_format_rgb565, {1, 0, 0, 0}, GLINT_ERROR_REGION},
        {&glint_format_rgb565, {-1, 0, 8, 8}, GLINT_ERROR_REGION},
        {&glint_format_rgb565, {0, -8, 8, 8}, GLINT_ERROR_REGION},
        {&glint_format_rgb565, {143, 0, 8, 8}, GLINT_ERROR_REGION},
        {&glint_format_rgb565, {0, 94, 8, 8}, GLINT_ERROR_REGION},
        {&glint_format_rgb565, {0, 0, -8, 8}, GLINT_ERROR_REGION},
        {&glint_format_rgb565, {INT16_MAX, INT16_MAX, INT16_MAX, INT16_MAX}, GLINT_ERROR_REGION},
        {&glint_format_rgb565, {INT16_MIN, INT16_MIN, INT16_MIN, INT16_MIN}, GLINT_ERROR_REGION},
        {&glint_format_rgb565, {149, 100, 1, 1}, GLINT_OK},
        {&glint_format_grey4, {1, 0, 7, 8}, GLINT_ERROR_REGION},
        {&glint_format_rgb444, {0, 0, 7, 8}, GLINT_ERROR_REGION},
        {&glint_format_mono, {4, 0, 8, 8}, GLINT_ERROR_REGION},
        {&glint_format_mono, {144, 1, 6, 1}, GLINT_OK},
        {&glint_format_mono_pages, {0, 4, 8, 8}, GLINT_ERROR_REGION},
        {&glint_format_mono_pages, {0, 0, 8, 4}, GLINT_ERROR_REGION},
        {&glint_format_mono_pages, {3, 96, 1, 5}, GLINT_OK},
    };
    test_scene scene;
    scene_build_random(&scene, 1);
    for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++) {
        glint_renderer renderer;
        glint_need need;
        glint_config config = configure(&part, cases[i].format, 0);
        CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
        CHECK_EQUAL(glint_render_region(&renderer, &scene.scene, &cases[i].region), cases[i].status);
        CHECK_EQUAL(part.calls, cases[i].status == GLINT_OK);
        config.region = cases[i].region;
        CHECK_EQUAL(glint_init(&renderer, &config), cases[i].status);
        CHECK_EQUAL(glint_arena_need(&config, &scene.scene, &need), cases[i].status);
    }
    CHECK_EQUAL(glint_render_region(NULL, &scene.scene, &cases[0].region), GLINT_ERROR_NULL);
    glint_renderer renderer = {0};
    CHECK_EQUAL(glint_render_region(&renderer, &scene.scene, NULL), GLINT_ERROR_NULL);
}

/* ---- Only what changed ---- */

/* Regions go through the filter, and what they showed of a tile is not taken for the tile. */
static void changes_know_regions(void) {
    static glint_tile_signature signatures[5 * 4];
    test_scene scene;
    glint_change_filter changes;
    glint_renderer renderer;
    scene_build_random(&scene, 3);
    glint_config config = configure(&part, &glint_format_rgb565, 0);
    config.left = 3;
    config.top = -2;
    CHECK_EQUAL(glint_tile_signature_count(&config), 20);
    CHECK_EQUAL(glint_change_filter_init(&changes, signatures, &config), GLINT_OK);
    config.flush = glint_change_filter_flush(&changes);
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    CHECK_EQUAL(glint_render(&renderer, &scene.scene), GLINT_OK);
    CHECK_EQUAL(changes.sent, 20);
    const glint_rectangle region = {33, 5, 31, 50}; /* parts of two tiles */
    CHECK_EQUAL(glint_render_region(&renderer, &scene.scene, &region), GLINT_OK);
    CHECK_EQUAL(changes.sent, 22);
    CHECK_EQUAL(glint_render(&renderer, &scene.scene), GLINT_OK);
    CHECK_EQUAL(changes.unchanged, 18);
    const glint_rectangle tile = {32, 32, 32, 32};
    CHECK_EQUAL(glint_render_region(&renderer, &scene.scene, &tile), GLINT_OK);
    CHECK_EQUAL(changes.unchanged, 19);
}

/* ---- Painters ---- */

typedef struct painting {
    uint8_t value; /* of each byte */
    uint32_t calls;
    uint32_t pixels; /* how many were painted */
    int is_overlay;
    uint8_t drawn[HEIGHT][WIDTH]; /* where depth says that an object shows */
} painting;

static int paint(void *context, const glint_tile *tile) {
    painting *p = context;
    p->calls++;
    for (int y = 0; y < tile->height; y++)
        for (int x = 0; x < tile->width; x++) {
            p->pixels++;
            if (p->is_overlay)
                p->drawn[tile->y + y][tile->x + x] = tile->depth[(size_t)y * tile->depth_stride + (size_t)x] != 0;
            else
                ((uint8_t *)tile->pixels)[(size_t)y * tile->stride + (size_t)x] = p->value;
        }
    return 0;
}

static void painters_see_every_pixel_once(void) {
    for (unsigned i = 0; i < scene_count; i++)
        for (int small = 0; small < 2; small++) {
            static painting under, over;
            test_scene scene;
            glint_need need;
            uint32_t wrong = 0;
            scene_build(&scene, &scene_definitions[i]);
            glint_config config = configure(&whole, &glint_format_grey8, 0);
            under = (painting){.value = 10};
            over = (painting){.is_overlay = 1};
            config.background = (glint_painter){paint, &under};
            CHECK_EQUAL(glint_arena_need(&config, &scene.scene, &need), GLINT_OK);
            config.arena_size = small ? need.least : need.one_pass;
            CHECK_EQUAL(draw(&config, &scene.scene), GLINT_OK);
            config.flush.context = &part;
            clear(&part, config.format);
            under.value = 200;
            config.overlay = (glint_painter){paint, &over};
            CHECK_EQUAL(draw(&config, &scene.scene), GLINT_OK);
            CHECK_EQUAL(under.pixels, 2 * WIDTH * HEIGHT);
            CHECK_EQUAL(over.pixels, WIDTH * HEIGHT);
            for (int y = 0; y < HEIGHT; y++) /* what differs with the background is where none is drawn */
                for (int x = 0; x < WIDTH; x++) {
                    const int shows = at(&whole, x, y) == 10 && at(&part, x, y) == 200;
                    wrong += over.drawn[y][x] ? at(&whole, x, y) != at(&part, x, y) : !shows;
                }
            CHECK_EQUAL(wrong, 0);
        }
}

/* An overlay's paint is sent, also of a scene without objects. */
static int paint_corner(void *context, const glint_tile *tile) {
    (void)context;
    ((uint8_t *)tile->pixels)[0] = 77;
    return 0;
}

static void overlays_are_sent(void) {
    test_scene scene;
    scene_build_random(&scene, 2);
    scene.scene.object_count = 0;
    glint_config config = configure(&part, &glint_format_grey8, 0);
    config.overlay.paint = paint_corner;
    config.region = (glint_rectangle){5, 6, 90, 80};
    CHECK_EQUAL(draw(&config, &scene.scene), GLINT_OK);
    CHECK_EQUAL(at(&part, 5, 6), 77);
    CHECK_EQUAL(at(&part, 32, 6), 77);
    CHECK_EQUAL(at(&part, 5, 64), 77);
    CHECK_EQUAL(at(&part, 64, 64), 77);
    CHECK(at(&part, 6, 6) != 77 && at(&part, 33, 32) != 77);
}

/* ---- Only what changed is sent, also after transfers that failed: the panel shows what one shows that is sent all
 * ---- */

#define TILES_MAX (19 * 13)
#define FRAMES 12

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

static int begin_transfer(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    panel *p = context;
    const int rectangle[4] = {x, y, width, height};
    memcpy(p->rectangle, rectangle, sizeof rectangle);
    p->pixels = pixels;
    p->stride = stride;
    return fails(p) || (!p->has_wait && finish(p));
}

static int end_transfer(void *context) {
    return finish(context);
}

static glint_config configure_panel(panel *p, const glint_format *format, uint16_t tile, int has_wait) {
    *p = (panel){.shown = picture_open(WIDTH, HEIGHT, format), .has_wait = has_wait};
    p->flush = (glint_flush){begin_transfer, has_wait ? end_transfer : 0, p};
    return (glint_config){.width = WIDTH,
                          .height = HEIGHT,
                          .tile_width = tile,
                          .tile_height = tile,
                          .format = format,
                          .flush = p->flush,
                          .arena = arena,
                          .arena_size = sizeof arena};
}

/* A torus that moves through the picture and stands still in every third frame. */
static void build(test_scene *scene, int frame) {
    scene_build(scene, &scene_definitions[0]);
    scene->objects[0].pose.m[0][3] += (frame - frame / 3 - FRAMES / 3) * GLINT_ONE / 8;
}

static void check_shown(const panel *p, const glint_scene *scene) {
    picture wanted = picture_open(WIDTH, HEIGHT, p->shown.format);
    CHECK_EQUAL(picture_render(&wanted, scene, NULL, NULL), GLINT_OK);
    CHECK(memcmp(wanted.bytes, p->shown.bytes, wanted.size) == 0);
    picture_close(&wanted);
}

static void follow(const glint_format *format, uint16_t tile, int has_wait) {
    static glint_tile_signature signatures[TILES_MAX];
    glint_change_filter changes;
    panel p;
    glint_config config = configure_panel(&p, format, tile, has_wait);
    CHECK_AT_MOST(glint_tile_signature_count(&config), TILES_MAX);
    CHECK_EQUAL(glint_change_filter_init(&changes, signatures, &config), GLINT_OK);
    config.flush = glint_change_filter_flush(&changes);
    for (int frame = 0; frame < FRAMES; frame++) {
        test_scene scene;
        const uint32_t before = changes.sent, all = glint_tile_signature_count(&config);
        build(&scene, frame);
        CHECK_EQUAL(draw(&config, &scene.scene), GLINT_OK);
        check_shown(&p, &scene.scene);
        CHECK_EQUAL(changes.sent + changes.unchanged, (uint32_t)(frame + 1) * all);
        if (frame == 0)
            CHECK_EQUAL(changes.sent, all);
        else if (frame % 3 == 0)
            CHECK_EQUAL(changes.sent, before);
        else
            CHECK(changes.sent > before && changes.sent < before + all);
    }
    glint_change_filter_forget(&changes);
    const uint32_t before = changes.sent;
    test_scene scene;
    build(&scene, FRAMES - 1);
    CHECK_EQUAL(draw(&config, &scene.scene), GLINT_OK);
    CHECK_EQUAL(changes.sent, before + glint_tile_signature_count(&config));
    picture_close(&p.shown);
}

static void only_what_changed_is_sent(void) {
    follow(&glint_format_rgb565, 32, 0);
    follow(&glint_format_rgb565, 16, 1);
    follow(&glint_format_rgb888, 16, 1);
    follow(&glint_format_grey4_dithered, 8, 0);
}

/* What failed is sent again, however it failed, until the picture is whole. */
static void failed_transfers_are_sent_again(void) {
    static glint_tile_signature signatures[TILES_MAX];
    for (uint32_t every = 1; every < 40; every += 3) {
        glint_change_filter changes;
        panel p;
        glint_config config = configure_panel(&p, &glint_format_rgb565, 32, every % 2 == 0);
        glint_change_filter_init(&changes, signatures, &config);
        config.flush = glint_change_filter_flush(&changes);
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
}

/* Parts of tiles that a region cuts are waited for, too: else a user would see pixels of the tile after, as the buffer
 * is drawn into while it is sent. */
static void parts_of_tiles_are_waited_for(void) {
    static glint_tile_signature signatures[TILES_MAX];
    static const glint_rectangle region = {1, 1, WIDTH - 2, HEIGHT - 2};
    glint_change_filter changes;
    glint_renderer renderer;
    panel p;
    test_scene scene;
    build(&scene, 0);
    glint_config config = configure_panel(&p, &glint_format_rgb565, 32, 1);
    CHECK_EQUAL(glint_change_filter_init(&changes, signatures, &config), GLINT_OK);
    config.flush = glint_change_filter_flush(&changes);
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    CHECK_EQUAL(glint_render_region(&renderer, &scene.scene, &region), GLINT_OK);
    picture wanted = picture_open(WIDTH, HEIGHT, p.shown.format);
    const picture_options options = {.region = region};
    CHECK_EQUAL(picture_render(&wanted, &scene.scene, &options, NULL), GLINT_OK);
    CHECK(memcmp(wanted.bytes, p.shown.bytes, wanted.size) == 0);
    picture_close(&wanted);
    picture_close(&p.shown);
}

/* A filter that was refused has no flush to draw with. */
static void expect_refused(glint_tile_signature *signatures, const glint_config *config, glint_status expected) {
    glint_change_filter changes;
    memset(&changes, 0xff, sizeof changes);
    CHECK_EQUAL(glint_change_filter_init(&changes, signatures, config), expected);
    CHECK(!changes.sent && !changes.unchanged && !changes.signatures && !changes.count);
    const glint_flush flush = glint_change_filter_flush(&changes);
    CHECK(!flush.begin && !flush.wait && !flush.context);
}

static void bad_arguments_are_refused(void) {
    glint_tile_signature signature;
    panel p;
    glint_config config = configure_panel(&p, &glint_format_rgb565, 32, 0);
    CHECK_EQUAL(glint_change_filter_init(NULL, &signature, &config), GLINT_ERROR_NULL);
    expect_refused(NULL, &config, GLINT_ERROR_NULL);
    expect_refused(&signature, NULL, GLINT_ERROR_NULL);
    config.tile_width = 5;
    expect_refused(&signature, &config, GLINT_ERROR_TILE);
    CHECK_EQUAL(glint_tile_signature_count(&config), 0);
    config.tile_width = 32;
    config.flush.begin = 0;
    expect_refused(&signature, &config, GLINT_ERROR_NULL);
    picture_close(&p.shown);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(regions_side_by_side_make_the_whole),
        TEST_CASE(regions_end_anywhere),
        TEST_CASE(bad_regions_are_refused),
        TEST_CASE(changes_know_regions),
        TEST_CASE(painters_see_every_pixel_once),
        TEST_CASE(overlays_are_sent),
        TEST_CASE(only_what_changed_is_sent),
        TEST_CASE(failed_transfers_are_sent_again),
        TEST_CASE(parts_of_tiles_are_waited_for),
        TEST_CASE(bad_arguments_are_refused),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
