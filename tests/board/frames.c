/* SPDX-License-Identifier: MIT */
#include "frames.h"

#include "byte_order.h"

/* The teapot at once in the largest format and tiles. */
static uint32_t arena[96 * 1024 / sizeof(uint32_t)];

/* Rectangles are whole bytes: tiles are 8 pixels wide or more. */
static int flush_begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
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

glint_status frame_draw_scene(frame_image *image, const glint_scene *scene, const frame_options *options) {
    glint_renderer renderer;
    glint_config config = {.width = TURNTABLE_WIDTH, .height = TURNTABLE_HEIGHT};

    config.tile_width = options->tile_width;
    config.tile_height = options->tile_height;
    config.format = options->format;
    config.flush.begin = flush_begin;
    config.flush.context = image;
    glint_status status = prepare(&config, scene, options->smallest);
    if (status == GLINT_OK) {
        status = glint_init(&renderer, &config);
    }
    if (status != GLINT_OK) {
        return status;
    }
    image->row_bytes = glint_row_bytes(options->format, TURNTABLE_WIDTH);
    image->arena_size = config.arena_size;
    status = glint_render(&renderer, scene);
    image->stats = renderer.stats;
    return status;
}

glint_status frame_draw(frame_image *image, turntable_model model, uint32_t frame, const frame_options *options) {
    turntable table;

    turntable_frame(&table, model, frame);
    return frame_draw_scene(image, &table.scene, options);
}

uint32_t frame_checksum(const frame_image *image, const glint_format *format) {
    const uint32_t offset_basis = 2166136261u, prime = 16777619u;
    const size_t flip = byte_order_flip_of(format);
    uint32_t sum = offset_basis;

    for (size_t i = 0; i < image->row_bytes * TURNTABLE_HEIGHT; i++) {
        sum = (sum ^ image->pixels[i ^ flip]) * prime;
    }
    return sum;
}
