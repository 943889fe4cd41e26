/* SPDX-License-Identifier: MIT */
/*
 * Suite: every panel, rotation and pixel format, through driver and model, against the plain picture, pixel by pixel;
 * and what a frame takes in bytes.
 */
#include "harness.h"
#include "panels.h"
#include "patterns.h"
#include "picture.h"
#include "scenes.h"
#include "wire.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE_MAX = 480 };

static void *allocate(size_t size) {
    void *memory = calloc(size, 1);
    if (memory == NULL) {
        fputs("out of memory\n", stderr);
        exit(1);
    }
    return memory;
}

static int turns(const tested_panel *panel) {
    return panel->can_turn ? 4 : 1;
}

static void report_complaints(const wire *line, const char *module) {
    panel_note notes[PANEL_NOTES_MAX];
    const unsigned count = panel_model_notes(line->model, notes);
    char text[200];

    if (!CHECK_EQUAL(panel_model_all_complaints(line->model), 0) && count > 0) {
        snprintf(text, sizeof text, "  %s, byte %llu, command %02x: %s\n", module, (unsigned long long)notes[0].byte,
                 notes[0].command, panel_complaint_text(notes[0].complaint));
        test_write(text);
    }
}

/* ---- A pattern that tells every pixel from its neighbours, sent as rectangles ----------------------------------- */

/* Pixels of the glass that are not as wanted; `wanted` is called for each pixel of the picture. */
static int count_wrong(const way *to, wire *line, void (*wanted)(const way *to, int x, int y, uint8_t rgb[3])) {
    const panel_picture *glass = panel_model_picture(line->model);
    int wrong = 0;

    for (int y = 0; y < glint_panel_height(&to->driver); y++) {
        for (int x = 0; x < glint_panel_width(&to->driver); x++) {
            uint8_t rgb[3] = {0, 0, 0};
            int at[2];
            panels_find_on_glass(to->panel->type, to->driver.rotation, x, y, at);
            if (panels_is_seen(to->panel, at[0], at[1])) {
                wanted(to, x, y, rgb);
            }
            wrong += memcmp(glass->rgb + (size_t)(at[1] * glass->width + at[0]) * 3, rgb, 3) != 0;
        }
    }
    return wrong;
}

static int smaller(int a, int b) {
    return a < b ? a : b;
}

/* Sends the pattern as a grid of rectangles of one size. */
static void send_pattern(const way *to, int width, int height) {
    const int across = glint_panel_width(&to->driver);
    const int down = glint_panel_height(&to->driver);
    const size_t stride = glint_row_bytes(glint_panel_format(&to->driver), (uint32_t)(width + 7) / 8 * 8);
    uint8_t *tile = allocate(stride * (size_t)(height + 7) / 8 * 8);

    for (int y = 0; y < down; y += height) {
        for (int x = 0; x < across; x += width) {
            const int rectangle[4] = {x, y, smaller(width, across - x), smaller(height, down - y)};
            memset(tile, 0, stride * (size_t)height);
            pattern_fill(to, tile, stride, rectangle);
            CHECK_EQUAL(glint_panel_begin(&to->driver, x, y, rectangle[2], rectangle[3], tile, stride), GLINT_OK);
            CHECK_EQUAL(glint_panel_wait(&to->driver), GLINT_OK);
        }
    }
    free(tile);
}

static void check_pattern(const tested_panel *panel, unsigned rotation, unsigned bits, int has_words) {
    /* sizes that divide no side; whole bytes all the same, but for the last column */
    static const int sizes[][2] = {{SIDE_MAX, SIDE_MAX}, {24, 40}, {8, 8}, {64, 16}, {16, 64}};
    wire line;
    way to;

    wire_open(&line, panel->module, panel->type->clock_max, 1);
    to = way_choose(panel, &line, rotation, bits, has_words);
    CHECK_EQUAL(glint_panel_start(&to.driver), GLINT_OK);
    CHECK(line.is_lit);
    for (unsigned i = 0; i < TEST_COUNT(sizes); i++) {
        send_pattern(&to, sizes[i][0], sizes[i][1]);
        CHECK_EQUAL(count_wrong(&to, &line, pattern_expect), 0);
    }
    report_complaints(&line, panel->module);
    wire_close(&line);
}

/* The number of ways tried is printed, and must be what the table of panels comes to. */
static void patterns_arrive(void) {
    unsigned ways = 0;
    char text[120];

    for (unsigned i = 0; i < tested_panel_count; i++) {
        const tested_panel *panel = &tested_panels[i];
        for (int rotation = 0; rotation < turns(panel); rotation++) {
            for (int kind = 0; kind < 3 && panel->bits[kind]; kind++, ways++) {
                check_pattern(panel, (unsigned)rotation, panel->bits[kind], 0);
            }
            if (panel->bits[0] == 16) {
                check_pattern(panel, (unsigned)rotation, 16, 1);
                ways++;
            }
        }
    }
    snprintf(text, sizeof text, "panels %u, with each rotation and format %u\n", tested_panel_count, ways);
    test_write(text);
    /* 7 take 12, 16 and 24 bits, and words; ILI9341 16 and 24, and words; SSD1351 16, and words; five have one way */
    CHECK_EQUAL(ways, 4 * (7 * 4 + 3 + 2 + 5) + 1);
}

/* ---- What the library draws ------------------------------------------------------------------------------------- */

static picture plain; /* the picture that `wanted_plain` looks into */

/* Of 8 bits a panel takes the upper 6. */
static void wanted_plain(const way *to, int x, int y, uint8_t rgb[3]) {
    (void)to;
    for (int channel = 0; channel < 3; channel++) {
        const int of = picture_channels(plain.format) == 1 ? 0 : channel;
        const int top = picture_level_max(plain.format, of);
        const int level = picture_level(&plain, x, y, of);
        rgb[channel] = top == 255 ? pattern_expand((unsigned)level >> 2, 6) : (uint8_t)((level * 255 + top / 2) / top);
    }
}

static const glint_scene *example(void) {
    static test_scene scene;

    scene_build_named(&scene, "interlocked");
    scene.scene.background = (glint_colour){GLINT_Q16(0.2), GLINT_Q16(0.45), GLINT_Q16(0.7)};
    return &scene.scene;
}

static glint_status draw(const glint_panel *driver, const uint16_t tile[2], void *arena, size_t size) {
    glint_renderer renderer;
    glint_config config = {.width = glint_panel_width(driver), .height = glint_panel_height(driver)};
    glint_status status;

    config.tile_width = tile[0];
    config.tile_height = tile[1];
    config.format = glint_panel_format(driver);
    config.flush = glint_panel_flush(driver);
    config.arena = arena;
    config.arena_size = size;
    status = glint_init(&renderer, &config);
    return status ? status : glint_render(&renderer, example());
}

/* One-bit pages are judged by the one-bit rows that the image tests judge. */
static const glint_format *judged_format(const glint_format *format) {
    return format == &glint_format_mono_pages            ? &glint_format_mono
           : format == &glint_format_mono_pages_dithered ? &glint_format_mono_dithered
                                                         : format;
}

static void check_drawing(const tested_panel *panel, unsigned rotation, const glint_format *format,
                          const uint16_t tile[2]) {
    const size_t size = 1 << 20;
    void *arena = allocate(size);
    wire line;
    way to = {panel, {panel->type, &line.bus, (glint_panel_rotation)rotation, format, 0}, 0};

    wire_open(&line, panel->module, panel->type->clock_max, 1);
    line.is_random = 1;
    to.driver.has_words = format == &glint_format_rgb565 || format == &glint_format_rgb565_dithered;
    plain = picture_open(glint_panel_width(&to.driver), glint_panel_height(&to.driver),
                         judged_format(glint_panel_format(&to.driver)));
    CHECK_EQUAL(picture_render(&plain, example(), NULL, NULL), GLINT_OK);
    CHECK_EQUAL(glint_panel_start(&to.driver), GLINT_OK);
    CHECK_EQUAL(draw(&to.driver, tile, arena, size), GLINT_OK);
    CHECK_EQUAL(count_wrong(&to, &line, wanted_plain), 0);
    report_complaints(&line, panel->module);
    picture_close(&plain);
    wire_close(&line);
    free(arena);
}

static const uint16_t tiles[][2] = {{8, 8}, {16, 16}, {32, 32}, {64, 64}, {64, 8}, {8, 64}, {32, 16}};

enum { SQUARE = 2 };

/* Bytes leave at random times, while the next tile is drawn and after. */
static void drawings_arrive(void) {
    static const glint_format *const coloured[] = {&glint_format_rgb565,          &glint_format_rgb565_be,
                                                   &glint_format_rgb444,          &glint_format_rgb888,
                                                   &glint_format_rgb565_dithered, &glint_format_rgb565_be_dithered,
                                                   &glint_format_rgb444_dithered, &glint_format_rgb888_dithered};

    for (unsigned i = 0; i < tested_panel_count; i++) {
        const tested_panel *panel = &tested_panels[i];
        for (unsigned rotation = 0; rotation < (unsigned)turns(panel); rotation++) {
            check_drawing(panel, rotation, NULL, tiles[(i + rotation) % TEST_COUNT(tiles)]);
            for (unsigned kind = 0; kind < TEST_COUNT(coloured); kind++) {
                if (panels_take(panel, (unsigned)glint_row_bytes(coloured[kind], 8)) && panel->bits[0] >= 16) {
                    check_drawing(panel, rotation, coloured[kind], tiles[(i + kind + rotation) % TEST_COUNT(tiles)]);
                }
            }
        }
    }
}

static void one_bit_undithered_arrives(void) {
    for (unsigned i = 0; i < tested_panel_count; i++) {
        for (unsigned rotation = 0; rotation < 4 && tested_panels[i].bits[0] == 1; rotation++) {
            for (unsigned tile = 0; tile < TEST_COUNT(tiles); tile++) {
                check_drawing(&tested_panels[i], rotation, rotation % 2 ? &glint_format_mono : &glint_format_mono_pages,
                              tiles[tile]);
            }
        }
    }
}

/* ---- Bytes ------------------------------------------------------------------------------------------------------ */

/*
 * Bytes of the pixels of a frame, in tiles of 32x32: rows of whole bytes, and round glasses without their corners; and
 * windows, one a tile or a page.
 */
static unsigned pixel_bytes(const way *to, unsigned *windows) {
    const int width = glint_panel_width(&to->driver);
    const int height = glint_panel_height(&to->driver);
    unsigned bytes = 0;

    *windows = 0;
    for (int y = 0; y < height; y += 32) {
        for (int x = 0; x < width; x += 32) {
            const int across = smaller(32, width - x);
            const int down = smaller(32, height - y);
            int seen = 0;
            for (int i = 0; i < across * down; i++) {
                seen |= panels_is_seen(to->panel, x + i % across, y + i / across);
            }
            if (seen) {
                *windows += !to->panel->has_single_pages ? 1
                            : to->driver.rotation % 2    ? (unsigned)across / 8
                                                         : (unsigned)down / 8;
                bytes += to->bits == 12 ? (unsigned)(down * ((across + 1) / 2 * 3))
                                        : (unsigned)(down * across) * to->bits / 8;
            }
        }
    }
    return bytes;
}

static void check_bytes(const tested_panel *panel, unsigned rotation, unsigned bits) {
    static uint32_t arena[1 << 16];
    wire line;
    way to;
    uint64_t before;
    unsigned windows, pixels;
    char text[120];

    wire_open(&line, panel->module, panel->type->clock_max, 1);
    to = way_choose(panel, &line, rotation, bits, 0);
    CHECK_EQUAL(glint_panel_start(&to.driver), GLINT_OK);
    before = panel_model_bytes(line.model);
    CHECK_EQUAL(draw(&to.driver, tiles[SQUARE], arena, sizeof arena), GLINT_OK);
    pixels = pixel_bytes(&to, &windows);
    CHECK_EQUAL(line.streamed, pixels);
    CHECK_EQUAL(panel_model_bytes(line.model) - before, windows * panel->window_bytes + pixels);
    if (rotation == 0) {
        snprintf(text, sizeof text,
                 "%-15s %2u bits: %3u windows in tiles of 32x32, %6u bytes a frame, of these %4u not pixels\n",
                 panel->module, bits, windows, windows * panel->window_bytes + pixels, windows * panel->window_bytes);
        test_write(text);
    }
    wire_close(&line);
}

static void no_byte_too_many(void) {
    for (unsigned i = 0; i < tested_panel_count; i++) {
        for (int rotation = 0; rotation < turns(&tested_panels[i]); rotation++) {
            for (int kind = 0; kind < 3 && tested_panels[i].bits[kind]; kind++) {
                check_bytes(&tested_panels[i], (unsigned)rotation, tested_panels[i].bits[kind]);
            }
        }
    }
}

/* ---- What a driver refuses -------------------------------------------------------------------------------------- */

static int start_status(const tested_panel *panel, unsigned rotation, const glint_format *format, int has_words,
                        int can_send_words) {
    wire line;
    glint_panel driver = {panel->type, &line.bus, (glint_panel_rotation)rotation, format, has_words};
    int status;

    wire_open(&line, panel->module, 0, 1);
    if (!can_send_words) {
        line.bus.begin_words = NULL;
    }
    status = glint_panel_start(&driver);
    CHECK(status == GLINT_OK || panel_model_bytes(line.model) == 0);
    wire_close(&line);
    return status;
}

static void what_a_panel_cannot_is_refused(void) {
    for (unsigned i = 0; i < tested_panel_count; i++) {
        const tested_panel *panel = &tested_panels[i];
        const int has_16 = panels_take(panel, 16);
        const int has_12 = panels_take(panel, 12);
        const int has_24 = panels_take(panel, 24);
        for (unsigned rotation = 1; rotation < 4; rotation++) {
            CHECK_EQUAL(start_status(panel, rotation, NULL, 0, 1), panel->can_turn ? 0 : GLINT_ERROR_ROTATION);
        }
        CHECK_EQUAL(start_status(panel, 0, &glint_format_rgb565_be, 0, 1), has_16 ? 0 : GLINT_ERROR_FORMAT);
        CHECK_EQUAL(start_status(panel, 0, &glint_format_rgb444, 0, 1), has_12 ? 0 : GLINT_ERROR_FORMAT);
        CHECK_EQUAL(start_status(panel, 0, &glint_format_rgb888, 0, 1), has_24 ? 0 : GLINT_ERROR_FORMAT);
        CHECK_EQUAL(start_status(panel, 0, &glint_format_grey8, 0, 1), GLINT_ERROR_FORMAT);
        CHECK_EQUAL(start_status(panel, 0, &glint_format_rgb565, 1, 1), has_16 ? 0 : GLINT_ERROR_FORMAT);
        CHECK_EQUAL(start_status(panel, 0, &glint_format_rgb565, 1, 0), GLINT_ERROR_FORMAT);
        CHECK_EQUAL(start_status(panel, 0, &glint_format_rgb888, 1, 1), GLINT_ERROR_FORMAT);
    }
}

/* A type that claims pixels its controller has no name for, as a panel of one's own may. */
static void pixels_without_a_name_are_refused(void) {
    glint_panel_type type = *panels_find("ili9341")->type;
    wire line;
    const glint_panel driver = {&type, &line.bus, GLINT_PANEL_0, &glint_format_grey8, 0};

    type.bits[1] = 8;
    wire_open(&line, "ili9341", 0, 1);
    CHECK_EQUAL(glint_panel_start(&driver), GLINT_ERROR_FORMAT);
    CHECK(!line.is_lit);
    CHECK_EQUAL(panel_model_all_complaints(line.model), 0);
    wire_close(&line);
}

/* Left and right edges on whole bytes; pages begin on theirs. */
static void split_bytes_are_refused(void) {
    static const uint8_t pixels[64];
    wire line;
    const glint_panel packed = {panels_find("st7789-240x240")->type, &line.bus, GLINT_PANEL_0, &glint_format_rgb444, 0};
    const glint_panel pages = {panels_find("ssd1306")->type, &line.bus, GLINT_PANEL_0, NULL, 0};
    const glint_panel rows = {panels_find("ssd1306")->type, &line.bus, GLINT_PANEL_90, NULL, 0};

    wire_open(&line, "st7789-240x240", 0, 1);
    CHECK_EQUAL(glint_panel_begin(&packed, 1, 0, 2, 1, pixels, 3), GLINT_ERROR_REGION);
    CHECK_EQUAL(glint_panel_begin(&packed, 0, 0, 3, 1, pixels, 6), GLINT_ERROR_REGION);
    CHECK_EQUAL(glint_panel_begin(&pages, 0, 4, 8, 8, pixels, 1), GLINT_ERROR_REGION);
    CHECK_EQUAL(glint_panel_begin(&pages, 0, 0, 8, 4, pixels, 1), GLINT_ERROR_REGION);
    CHECK_EQUAL(glint_panel_begin(&rows, 4, 0, 8, 8, pixels, 1), GLINT_ERROR_REGION);
    CHECK_EQUAL(glint_panel_begin(&rows, 0, 0, 4, 8, pixels, 1), GLINT_ERROR_REGION);
    CHECK_EQUAL(panel_model_bytes(line.model), 0);
    wire_close(&line);
}

static void what_is_not_on_the_screen_is_refused(void) {
    static const int rectangles[][4] = {{-2, 0, 4, 4},  {0, -1, 4, 4}, {126, 0, 4, 4},        {0, 61, 4, 4},
                                        {1, 0, 4, 4},   {0, 0, 3, 4},  {0, 0, 0, 4},          {0, 0, 4, 0},
                                        {0, 0, 130, 4}, {0, 0, 4, 65}, {2147483646, 0, 4, 4}, {0, 2147483647, 4, 4}};
    static const uint8_t pixels[4];
    wire line;
    const glint_panel driver = {panels_find("ssd0323")->type, &line.bus};

    wire_open(&line, "ssd0323", 0, 1);
    for (unsigned i = 0; i < TEST_COUNT(rectangles); i++) {
        const int *r = rectangles[i];
        CHECK_EQUAL(glint_panel_begin(&driver, r[0], r[1], r[2], r[3], pixels, 1), GLINT_ERROR_REGION);
    }
    CHECK_EQUAL(panel_model_bytes(line.model), 0);
    wire_close(&line);
}

/* A glass of odd width, and a memory that ends with it or not. */
static void odd_glasses_take_what_memory_has(void) {
    static const uint8_t pixels[4];
    glint_panel_type type = *panels_find("ssd0323")->type;
    wire line;
    const glint_panel odd = {&type, &line.bus};

    type.width = 127;
    wire_open(&line, "ssd0323", 0, 1);
    CHECK_EQUAL(glint_panel_start(&odd), GLINT_OK);
    CHECK_EQUAL(glint_panel_begin(&odd, 120, 0, 7, 1, pixels, sizeof pixels), GLINT_OK);
    CHECK_EQUAL(glint_panel_wait(&odd), GLINT_OK);
    type.memory_width = 127;
    CHECK_EQUAL(glint_panel_begin(&odd, 120, 0, 7, 1, pixels, sizeof pixels), GLINT_ERROR_REGION);
    CHECK_EQUAL(glint_panel_begin(&odd, 120, 0, 6, 1, pixels, sizeof pixels), GLINT_OK);
    CHECK_EQUAL(glint_panel_wait(&odd), GLINT_OK);
    CHECK_EQUAL(panel_model_all_complaints(line.model), 0);
    wire_close(&line);
}

/* On a glass whose colours lie the other way, red arrives where blue does. */
static void colours_lie_as_the_glass_has_them(void) {
    static const uint8_t red[2] = {0xf8, 0x00};
    glint_panel_type type = *panels_find("ssd1351")->type;
    wire line;
    const glint_panel driver = {&type, &line.bus};
    uint8_t rgb[3];

    type.glass ^= GLINT_PANEL_BGR;
    wire_open(&line, "ssd1351", 0, 1);
    CHECK_EQUAL(glint_panel_start(&driver), GLINT_OK);
    CHECK_EQUAL(glint_panel_begin(&driver, 0, 0, 1, 1, red, sizeof red), GLINT_OK);
    CHECK_EQUAL(glint_panel_wait(&driver), GLINT_OK);
    panel_model_pixel(line.model, 0, 0, rgb);
    CHECK(rgb[0] == 0 && rgb[1] == 0 && rgb[2] == 255);
    wire_close(&line);
}

/* Of pixels of 12 bits, two are whole bytes, wherever they begin. */
static void pairs_of_pixels_are_taken(void) {
    static const uint8_t pixels[3];
    wire line;
    const glint_panel packed = {panels_find("st7789-240x240")->type, &line.bus, GLINT_PANEL_0, &glint_format_rgb444, 0};

    wire_open(&line, "st7789-240x240", 0, 1);
    CHECK_EQUAL(glint_panel_start(&packed), GLINT_OK);
    for (int x = 0; x < 8; x += 2) {
        CHECK_EQUAL(glint_panel_begin(&packed, x, 0, 2, 1, pixels, 3), GLINT_OK);
        CHECK_EQUAL(glint_panel_wait(&packed), GLINT_OK);
    }
    CHECK_EQUAL(panel_model_all_complaints(line.model), 0);
    wire_close(&line);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(patterns_arrive),
        TEST_CASE(drawings_arrive),
        TEST_CASE(one_bit_undithered_arrives),
        TEST_CASE(no_byte_too_many),
        TEST_CASE(what_a_panel_cannot_is_refused),
        TEST_CASE(pixels_without_a_name_are_refused),
        TEST_CASE(split_bytes_are_refused),
        TEST_CASE(what_is_not_on_the_screen_is_refused),
        TEST_CASE(odd_glasses_take_what_memory_has),
        TEST_CASE(colours_lie_as_the_glass_has_them),
        TEST_CASE(pairs_of_pixels_are_taken),
    };

    return test_run(write, cases, TEST_COUNT(cases));
}
