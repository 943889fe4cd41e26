/* SPDX-License-Identifier: MIT */
#include "frames.h"

#include "byte_order.h"

/* What a board can spare, and its own size of tiles (port/boards.mk); the library's where it says none. */
#ifndef BOARD_ARENA
#define BOARD_ARENA 0x7fffffff
#define BOARD_TILE_WIDTH 0
#define BOARD_TILE_HEIGHT 0
#endif

/* The teapot at once in the largest format and tiles. */
#define ARENA_MOST (96 * 1024)

/* What boards spare for programs that have a scene in memory is less: these have it on the stack. */
#define ARENA_SPARED (BOARD_ARENA - 512)

static uint32_t arena[(ARENA_SPARED < ARENA_MOST ? ARENA_SPARED : ARENA_MOST) / sizeof(uint32_t)];

static glint_status prepare(glint_config *config, const glint_scene *scene, int smallest) {
    glint_need need;
    const glint_status status = glint_arena_need(config, scene, &need);

    if (status != GLINT_OK) {
        return status;
    }
    config->arena = arena;
    config->arena_size = smallest ? need.least : need.one_pass;
    if (config->arena_size > sizeof arena) {
        config->arena_size = sizeof arena;
    }
    return GLINT_OK;
}

static glint_status draw(glint_flush flush, const glint_scene *scene, const frame_options *options) {
    glint_renderer renderer;
    glint_config config = {.width = TURNTABLE_WIDTH, .height = TURNTABLE_HEIGHT};

    config.tile_width = options->tile_width ? options->tile_width : BOARD_TILE_WIDTH;
    config.tile_height = options->tile_height ? options->tile_height : BOARD_TILE_HEIGHT;
    config.format = options->format;
    config.layers = options->layers;
    config.samples = options->samples;
    config.flush = flush;
    glint_status status = prepare(&config, scene, options->smallest);
    if (status == GLINT_OK) {
        status = glint_init(&renderer, &config);
    }
    return status == GLINT_OK ? glint_render(&renderer, scene) : status;
}

/* ---- Pictures: rectangles are whole bytes, as tiles are 8 pixels wide or more -------------------------------------
 */

static int copy_pixels(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    frame_image *image = context;
    const uint8_t *from = pixels;
    const size_t row_bytes = image->row_bytes * (size_t)width / TURNTABLE_WIDTH;
    const size_t left = image->row_bytes * (size_t)x / TURNTABLE_WIDTH;

    for (int row = 0; row < height; row++) {
        uint8_t *to = image->pixels + (size_t)(y + row) * image->row_bytes + left;
        for (size_t i = 0; i < row_bytes; i++) {
            to[i] = from[(size_t)row * stride + i];
        }
    }
    return 0;
}

glint_status frame_draw_scene(frame_image *image, const glint_scene *scene, const frame_options *options) {
    const glint_flush flush = {.begin = copy_pixels, .context = image};

    image->row_bytes = glint_row_bytes(options->format, TURNTABLE_WIDTH);
    return draw(flush, scene, options);
}

glint_status frame_draw(frame_image *image, turntable_model model, uint32_t frame, const frame_options *options) {
    turntable table;

    turntable_frame(&table, model, frame);
    return frame_draw_scene(image, &table.scene, options);
}

/* ---- Sums ---------------------------------------------------------------------------------------------------------
 */

typedef struct pixel_sum {
    uint32_t sum;
    size_t row_bytes;
    size_t flip; /* of a byte's place, where the core stores high bytes first */
} pixel_sum;

/* The finaliser of MurmurHash3 (Appleby, 2011): every bit of the result depends on every bit of the number. */
static uint32_t hash(uint32_t number) {
    number = (number ^ number >> 16) * 0x85ebca6bu;
    number = (number ^ number >> 13) * 0xc2b2ae35u;
    return number ^ number >> 16;
}

static int sum_pixels(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    pixel_sum *all = context;
    const uint8_t *from = pixels;
    const size_t row_bytes = all->row_bytes * (size_t)width / TURNTABLE_WIDTH;
    const size_t left = all->row_bytes * (size_t)x / TURNTABLE_WIDTH;

    for (int row = 0; row < height; row++) {
        const size_t begin = (size_t)(y + row) * all->row_bytes + left;
        for (size_t i = 0; i < row_bytes; i++) {
            const size_t place = (begin + i) ^ all->flip;
            all->sum += hash((uint32_t)place << 8 | from[(size_t)row * stride + i]);
        }
    }
    return 0;
}

glint_status frame_sum_scene(uint32_t *sum, const glint_scene *scene, const frame_options *options) {
    pixel_sum all = {0, glint_row_bytes(options->format, TURNTABLE_WIDTH), byte_order_flip_of(options->format)};
    const glint_flush flush = {.begin = sum_pixels, .context = &all};
    const glint_status status = draw(flush, scene, options);

    *sum = all.sum;
    return status;
}

glint_status frame_sum(uint32_t *sum, turntable_model model, uint32_t frame, const frame_options *options) {
    turntable table;

    turntable_frame(&table, model, frame);
    return frame_sum_scene(sum, &table.scene, options);
}
